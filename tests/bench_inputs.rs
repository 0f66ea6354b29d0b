//! The benchmark inputs are the agreed ones: their workloads, done modulo 2^61 − 1 by
//! the plainest formula, give the agreed checksums.

#[path = "../benches/inputs/mod.rs"]
mod inputs;

use inputs::*;
use polarform::number::{Rational, binomial};
use polarform::poly::Poly;

fn residues(values: &[Rational]) -> Vec<u64> {
    values.iter().map(modp).collect()
}

fn choose(n: usize, k: usize) -> u64 {
    binomial(n, k).mod_word(P)
}

fn minus(a: u64, b: u64) -> u64 {
    plus(a, P - b)
}

/// Σ a_k e_k(u_1, …, u_n) / C(n, k)
fn polar_value(a: &[u64], arguments: &[u64]) -> u64 {
    let n = arguments.len();
    let mut e = vec![0; n + 1];
    e[0] = 1;
    for &u in arguments {
        for k in (1..=n).rev() {
            e[k] = plus(e[k], times(u, e[k - 1]));
        }
    }
    (0..a.len()).fold(0, |sum, k| plus(sum, times(a[k], times(e[k], inverse(choose(n, k))))))
}

fn points(n: usize) -> Vec<u64> {
    (1..=n as u64).map(point).collect()
}

#[test]
fn polar_forms_w2() {
    for n in [6, 7, 8, 12, 16] {
        assert_eq!(polar_value(&residues(&in_w2(n)), &points(n)), expected(&format!("W2/{n}")));
    }
}

#[test]
fn polar_values_w3() {
    for n in [10, 100, 1000] {
        let (f, u) = in_w3(n);
        assert_eq!(polar_value(&residues(&f), &residues(&u)), expected(&format!("W3/{n}")));
    }
}

#[test]
fn products_w4() {
    for d in [100, 1000, 10000] {
        let (f, g) = in_w4(d);
        assert_eq!(times(ck_poly(&f), ck_poly(&g)), expected(&format!("W4/{d}")));
    }
    let (f, g) = in_w4_long();
    assert_eq!(times(ck_poly(&f), ck_poly(&g)), expected("W4/1000x1000bit"));
    let product = Poly::from_coefficients(f) * Poly::from_coefficients(g);
    assert_eq!(ck_integers(product.numerators(), product.denominator()), expected("W4/1000x1000bit"));
}

#[test]
fn compositions_w5() {
    for d in [20, 50, 100] {
        let (f, g) = in_w5(d);
        let inner = ck_poly(&g);
        let value = f.iter().rev().fold(0, |h, c| plus(times(h, inner), modp(c)));
        assert_eq!(value, expected(&format!("W5/{d}")));
        if d < 100 {
            let composed = Poly::from_coefficients(f).compose(&Poly::from_coefficients(g));
            assert_eq!(ck_poly(&composed.coefficients()), value);
        }
    }
}

#[test]
fn basis_matrices_w6() {
    // Pascal's triangle
    let mut rows = vec![vec![1]];
    for n in 0..200 {
        let below = (0..n).map(|k| plus(rows[n][k], rows[n][k + 1]));
        rows.push(std::iter::once(1).chain(below).chain([1]).collect::<Vec<u64>>());
    }
    for n in [10, 50, 100, 200] {
        let (rows, choose_n) = (&rows, &rows[n]);
        let bernstein = (0..=n).flat_map(|k| {
            (0..=n).map(move |i| {
                let size = if i <= k { times(choose_n[k], rows[k][i]) } else { 0 };
                if i < k && (k - i) % 2 == 1 { minus(0, size) } else { size }
            })
        });
        let inverses: Vec<u64> = choose_n.iter().map(|&value| inverse(value)).collect();
        let inverse_entries = (0..=n).flat_map(|i| {
            let inverses = &inverses;
            (0..=n).map(move |k| if k <= i { times(rows[i][k], inverses[k]) } else { 0 })
        });
        assert_eq!(ck_residues(bernstein.chain(inverse_entries)), expected(&format!("W6/{n}")));
    }
}

#[test]
fn control_points_w7() {
    let split = |points: &[[Rational; 2]], axis: usize| -> Vec<u64> {
        points.iter().map(|p| modp(&p[axis])).collect()
    };
    let fold = |[x, y]: [Vec<u64>; 2]| ck_residues(x.into_iter().zip(y).flat_map(|(x, y)| [x, y]));

    let net = in_w7(700, 100);
    let elevated = [0, 1].map(|axis| {
        let mut b = split(&net, axis);
        for m in 101..=200 {
            let weight = |i: usize| times(i as u64, inverse(m));
            let at = |i: usize| b.get(i).copied().unwrap_or(0);
            b = (0..=m as usize)
                .map(|i| {
                    let previous = if i > 0 { times(weight(i), at(i - 1)) } else { 0 };
                    plus(previous, times(minus(1, weight(i)), at(i)))
                })
                .collect();
        }
        b
    });
    assert_eq!(fold(elevated), expected("W7/elevate"));

    let net = in_w7(701, 200);
    let third = inverse(3);
    let halves = [0, 1].map(|axis| {
        let mut b = split(&net, axis);
        let (mut left, mut right) = (Vec::new(), Vec::new());
        while let (Some(&first), Some(&last)) = (b.first(), b.last()) {
            left.push(first);
            right.push(last);
            b = b.windows(2).map(|w| times(third, plus(times(2, w[0]), w[1]))).collect();
        }
        left.extend(right.into_iter().rev());
        left
    });
    assert_eq!(fold(halves), expected("W7/subdivide"));
}

#[test]
fn polar_products_w8() {
    for m in [5, 6, 7] {
        let (f, g) = in_w8(m);
        let product = Poly::from_coefficients(f) * Poly::from_coefficients(g);
        let value = polar_value(&residues(&product.coefficients()), &points(2 * m));
        assert_eq!(value, expected(&format!("W8/{m}")));
    }
    for k in [8, 12, 16] {
        let f = power(points(4).into_iter().fold(1, plus), k);
        assert_eq!(times(f, plus(f, 1)), expected(&format!("W8/fateman/{k}")));
    }
}

#[test]
fn splines_w9() {
    for n in [3, 10] {
        let t = residues(&in_w9_knots());
        let x = point(0);
        let quotient = |a: u64, b: u64| times(a, inverse(b));
        let mut values = Vec::new();
        for i in 0..t.len() - n - 1 {
            for span in i..=i + n {
                // N_j^k for j = i, …, with only the interval `span` counted
                let mut row: Vec<u64> = (i..=i + n).map(|j| u64::from(j == span)).collect();
                for k in 1..=n {
                    row = (0..row.len() - 1)
                        .map(|a| {
                            let j = i + a;
                            let rise = quotient(minus(x, t[j]), minus(t[j + k], t[j]));
                            let fall = quotient(minus(t[j + k + 1], x), minus(t[j + k + 1], t[j + 1]));
                            plus(times(rise, row[a]), times(fall, row[a + 1]))
                        })
                        .collect();
                }
                values.push(row[0]);
            }
        }
        assert_eq!(ck_residues(values), expected(&format!("W9/basis{n}")));
    }

    let (mut t, points, fresh) = in_w9_insertion();
    let mut d: Vec<[u64; 2]> = points.iter().map(|p| [modp(&p[0]), modp(&p[1])]).collect();
    for u in &fresh {
        let span = t.partition_point(|knot| knot <= u) - 1;
        let mixed: Vec<[u64; 2]> = (span - 2..=span)
            .map(|i| {
                let ratio = modp(&((u - &t[i]) / (&t[i + 3] - &t[i])));
                [0, 1].map(|axis| plus(times(minus(1, ratio), d[i - 1][axis]), times(ratio, d[i][axis])))
            })
            .collect();
        d.splice(span - 2..span, mixed);
        t.insert(span + 1, u.clone());
    }
    assert_eq!(ck_residues(d.into_iter().flatten()), expected("W9/insert1000"));
}
