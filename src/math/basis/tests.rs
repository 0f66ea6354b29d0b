use nalgebra::DMatrix;
use num_traits::{One, Zero};
use proptest::prelude::*;

use super::*;
use crate::math::linalg::surd::Surd;
use crate::math::linalg::{determinant, inverse, is_lower_triangular, multiply};
use crate::math::number::{Int, Rational, binomial, integer, rational};

fn whole(x: Int) -> Rational {
    Rational::from_integer(x)
}

fn reduced(x: &Rational) -> bool {
    Rational::new(x.numer().clone(), x.denom().clone()).denom() == x.denom()
}

#[test]
fn closed_forms_entry_by_entry() {
    for n in (0..=40).chain([61, 100]) {
        let (forth, back) = (bernstein_to_power(n), power_to_bernstein(n));
        assert!(is_lower_triangular(&forth) && is_lower_triangular(&back));
        for j in 0..=n {
            for i in j..=n {
                let magnitude = whole(binomial(n, i) * binomial(i, j));
                let expected = if (i - j) % 2 == 0 { magnitude } else { -magnitude };
                assert_eq!(forth[(i, j)], expected);
                assert_eq!(back[(i, j)], Rational::new(binomial(i, j), binomial(n, j)));
                assert!(reduced(&back[(i, j)]));
            }
        }
    }
}

#[test]
fn closed_forms_are_inverse() {
    for n in 0..=16 {
        let (forth, back) = (bernstein_to_power(n), power_to_bernstein(n));
        assert_eq!(inverse(&forth), Ok(back.clone()));
        assert_eq!(inverse(&back), Ok(forth.clone()));
        let product: Int = (0..=n).map(|k| binomial(n, k)).product();
        assert_eq!(determinant(&forth), Ok(whole(product)));
    }
    let (forth, back) = (bernstein_to_power(40), power_to_bernstein(40));
    assert_eq!(multiply(&forth, &back), Ok(DMatrix::identity(41, 41)));
}

#[test]
fn raising_and_lowering() {
    for m in 0..=6 {
        for n in m..=9 {
            let up = raising(m, n).unwrap();
            let a = bernstein_to_power(m);
            let padded =
                DMatrix::from_fn(n + 1, m + 1, |i, j| if i <= m { a[(i, j)].clone() } else { integer(0) });
            assert_eq!(multiply(&power_to_bernstein(n), &padded), Ok(up.clone()));
            for row in up.row_iter() {
                assert_eq!(row.iter().fold(Rational::zero(), |sum, x| sum + x), integer(1));
            }
            let down = lowering(n, m).unwrap();
            assert_eq!(multiply(&down, &up), Ok(DMatrix::identity(m + 1, m + 1)));
            let a = bernstein_to_power(n);
            let cut = DMatrix::from_fn(m + 1, n + 1, |i, j| a[(i, j)].clone());
            assert_eq!(multiply(&power_to_bernstein(m), &cut), Ok(down));
            // one degree at a time
            if n > m {
                assert_eq!(multiply(&raising(n - 1, n).unwrap(), &raising(m, n - 1).unwrap()), Ok(up));
            }
        }
    }
    assert_eq!(raising(3, 2).unwrap_err().to_string(), "cannot raise degree 3 to 2, which is smaller");
    assert_eq!(lowering(2, 3).unwrap_err().to_string(), "cannot lower degree 2 to 3, which is larger");
}

/// b_i = f(a^{n−i} b^i) by the multiaffine de Casteljau scheme on control points over [c, d].
fn blossom(points: &[Rational], c: &Rational, d: &Rational, arguments: &[Rational]) -> Rational {
    let mut points = points.to_vec();
    for u in arguments {
        let s = (u - c) / (d - c);
        points = points.windows(2).map(|w| &w[0] + (&w[1] - &w[0]) * &s).collect();
    }
    points[0].clone()
}

#[test]
fn subdivision_is_the_blossom() {
    let (a, b, c, d) = (rational(-1, 2), rational(5, 3), rational(7, 1), rational(2, 9));
    for n in 0..=5 {
        let from = Basis::Bernstein(Interval::new(a.clone(), b.clone()).unwrap());
        let to = Basis::Bernstein(Interval::new(c.clone(), d.clone()).unwrap());
        let matrix = change_of_basis(n, &from, &to).unwrap();
        for j in 0..=n {
            let points: Vec<_> = (0..=n).map(|k| integer(i64::from(k == j))).collect();
            for i in 0..=n {
                let arguments: Vec<_> = (0..n).map(|k| if k < i { d.clone() } else { c.clone() }).collect();
                assert_eq!(matrix[(i, j)], blossom(&points, &a, &b, &arguments));
            }
        }
    }
}

#[test]
fn bernstein_values() {
    for n in 0..8 {
        for t in [rational(0, 1), rational(1, 1), rational(2, 7), rational(-3, 2)] {
            let all = bernstein_all(n, &t);
            assert_eq!(all.len(), n + 1);
            assert_eq!(all.iter().fold(Rational::zero(), |sum, x| sum + x), integer(1));
            for (i, value) in all.iter().enumerate() {
                assert_eq!(*value, bernstein(n, i, &t));
                if n > 0 {
                    let left = if i > 0 { &t * bernstein(n - 1, i - 1, &t) } else { Rational::zero() };
                    assert_eq!(*value, left + (integer(1) - &t) * bernstein(n - 1, i, &t));
                }
            }
            assert!(bernstein(n, n + 1, &t).is_zero());
        }
    }
}

/// The Bézier ordinates of the j-th Legendre polynomial are (−1)^{i+j} C(j, i).
#[test]
fn legendre_polynomials_in_bezier_form() {
    let ends = || (rational(-1, 2), rational(5, 3));
    for n in 0..7 {
        let ((a, b), (c, d)) = (ends(), ends());
        let matrix = change_of_basis(
            n,
            &Basis::Legendre(Interval::new(a, b).unwrap()),
            &Basis::Bernstein(Interval::new(c, d).unwrap()),
        )
        .unwrap();
        for i in 0..=n {
            let value = whole(binomial(n, i));
            assert_eq!(matrix[(i, n)], if (i + n) % 2 == 0 { value } else { -value });
        }
    }
}

/// For the cubic on [0, 1], as in every textbook.
#[test]
fn cubic_hermite_polynomials() {
    let basis = Basis::HermiteEndpoints(Interval::unit());
    let columns = [[1, 0, -3, 2], [0, 1, -2, 1], [0, 0, 3, -2], [0, 0, -1, 1]];
    let expected = DMatrix::from_iterator(4, 4, columns.into_iter().flatten().map(integer));
    assert_eq!(change_of_basis(3, &basis, &Basis::Power), Ok(expected));
}

#[test]
fn divided_differences() {
    // t³ on 0, 1, 2, 4: f[0] = 0, f[0, 1] = 1, f[0,1,2] = 3, f[0,1,2,4] = 1
    let nodes: Vec<Rational> = [0, 1, 2, 4].into_iter().map(integer).collect();
    let matrix = change_of_basis(3, &Basis::Lagrange(nodes.clone()), &Basis::Newton(nodes)).unwrap();
    let values = DMatrix::from_iterator(4, 1, [0, 1, 8, 64].into_iter().map(integer));
    let expected = DMatrix::from_iterator(4, 1, [0, 1, 3, 1].into_iter().map(integer));
    assert_eq!(multiply(&matrix, &values), Ok(expected));
}

#[test]
fn errors_name_what_is_wrong() {
    let fails = |n, basis: &Basis<Rational>, error: BasisError, text: &str| {
        assert_eq!(basis.validate(n), Err(error.clone()));
        assert_eq!(error.to_string(), text);
        assert_eq!(evaluate_basis(n, basis, &integer(3)), Err(error.clone()));
        assert_eq!(change_of_basis(n, basis, &Basis::Power), Err(error.clone()));
        assert_eq!(change_of_basis(n, &Basis::Power, basis), Err(error));
    };
    let one = || integer(1);
    fails(
        2,
        &Basis::HermiteEndpoints(Interval::new(one(), integer(2)).unwrap()),
        BasisError::EvenDegree { degree: 2 },
        "values and derivatives at two ends need an odd degree, not 2",
    );
    fails(
        3,
        &Basis::Lagrange(vec![integer(0), one(), integer(2), rational(2, 2)]),
        BasisError::EqualNodes { first: 1, second: 3 },
        "the nodes x_1 and x_3 are equal",
    );
    let count = BasisError::NodeCount { degree: 2, given: 1 };
    for basis in [Basis::Lagrange(vec![one()]), Basis::Newton(vec![one()])] {
        fails(2, &basis, count.clone(), "degree 2 needs 3 nodes, 1 given");
    }
    let count = BasisError::NodeCount { degree: 0, given: 0 };
    fails(0, &Basis::Lagrange(vec![]), count, "degree 0 needs 1 node, 0 given");
    let count = BasisError::NodeCount { degree: 0, given: 2 };
    fails(0, &Basis::Newton(vec![one(), one()]), count, "degree 0 needs 1 node, 2 given");
    assert_eq!(Basis::Newton(Vec::<Rational>::new()).validate(0), Ok(()));
}

/// One basis of each kind from arbitrary material.
fn bases<F: Field>(n: usize, distinct: &[F], any: &[F]) -> Vec<Basis<F>> {
    let (a, b) = (distinct[0].clone(), distinct[1].clone());
    let mut list = vec![
        Basis::Power,
        Basis::Taylor { at: any[0].clone() },
        Basis::Bernstein(Interval::unit()),
        Basis::Bernstein(Interval::new(b.clone(), a.clone()).unwrap()),
        Basis::Legendre(Interval::new(a.clone(), b.clone()).unwrap()),
        Basis::Lagrange(distinct[..=n].to_vec()),
        Basis::Newton(any[..=n].to_vec()),
        Basis::Newton(distinct[..n].to_vec()),
    ];
    if n % 2 == 1 {
        list.push(Basis::HermiteEndpoints(Interval::new(a, b).unwrap()));
    }
    list
}

fn dot<F: Field>(x: &[F], y: &[F]) -> F {
    x.iter().zip(y).fold(F::zero(), |sum, (x, y)| sum.plus(&x.times(y)))
}

fn check_laws<F: Field>(n: usize, bases: &[Basis<F>], coefficients: &[F], t: &F) {
    let identity = DMatrix::identity(n + 1, n + 1);
    let column = DMatrix::from_column_slice(n + 1, 1, coefficients);
    let powers = evaluate_basis(n, &Basis::Power, t).unwrap();
    // The matrix to the powers, its generic inverse and the values at t.
    let known = bases.iter().map(|basis| {
        let to_power = change_of_basis(n, basis, &Basis::Power).expect("a basis");
        let from_power = inverse(&to_power).unwrap();
        (basis, to_power, from_power, evaluate_basis(n, basis, t).unwrap())
    });
    let known: Vec<_> = known.collect();
    for (i, (x, to_power, from_power, values)) in known.iter().enumerate() {
        for (j, value) in values.iter().enumerate() {
            assert_eq!(*value, dot(to_power.column(j).as_slice(), &powers));
        }
        assert_eq!(change_of_basis(n, &Basis::Power, x).as_ref(), Ok(from_power));
        for (y, y_to_power, y_from_power, there) in &known[i..] {
            let matrix = change_of_basis(n, x, y).unwrap();
            let back = change_of_basis(n, y, x).unwrap();
            // composition: X → Y is X → power → Y
            assert_eq!(multiply(y_from_power, to_power).as_ref(), Ok(&matrix));
            assert_eq!(multiply(from_power, y_to_power).as_ref(), Ok(&back));
            assert_eq!(multiply(&back, &matrix).as_ref(), Ok(&identity));
            let converted = multiply(&matrix, &column).unwrap();
            assert_eq!(dot(coefficients, values), dot(converted.as_slice(), there));
        }
    }
}

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-3i64..=3).prop_map(integer),
        3 => (-9i64..=9, 1i64..=5).prop_map(|(p, q)| rational(p, q)),
        1 => (any::<i64>(), 1..=i64::MAX).prop_map(|(p, q)| rational(p, q)),
    ]
}

fn distinct(list: Vec<Rational>) -> Vec<Rational> {
    let mut kept: Vec<Rational> = Vec::new();
    for mut x in list {
        while kept.contains(&x) {
            x += Rational::one();
        }
        kept.push(x);
    }
    kept
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn laws_over_the_rationals(
        n in 0usize..=5,
        nodes in proptest::collection::vec(number(), 7),
        any in proptest::collection::vec(number(), 7),
        coefficients in proptest::collection::vec(number(), 7),
        t in number(),
    ) {
        let nodes = distinct(nodes);
        check_laws(n, &bases(n, &nodes, &any), &coefficients[..=n], &t);
    }

    #[test]
    fn laws_over_surds(
        n in 0usize..=4,
        nodes in proptest::collection::vec((-5i64..=5, 1i64..=3), 5),
        any in proptest::collection::vec((-5i64..=5, -1i64..=1), 5),
        t in (-5i64..=5, -2i64..=2),
    ) {
        let surd = |(p, q): &(i64, i64)| Surd(integer(*p), integer(*q));
        let shifts = distinct(nodes.iter().map(|(p, _)| integer(*p)).collect());
        let roots = nodes.iter().map(|(_, q)| rational(1, *q));
        let nodes: Vec<Surd> = shifts.into_iter().zip(roots).map(|(p, q)| Surd(p, q)).collect();
        let any: Vec<Surd> = any.iter().map(surd).collect();
        check_laws(n, &bases(n, &nodes, &any), &any[..=n], &surd(&t));
    }
}

#[test]
fn every_degree_once() {
    let nodes: Vec<Rational> = (0..7).map(|k| rational(k * k - 5, k + 2)).collect();
    let any: Vec<Rational> = [2, 2, -1, 2, 0, 0, 7].into_iter().map(integer).collect();
    for n in 0..=6 {
        check_laws(n, &bases(n, &distinct(nodes.clone()), &any), &any[..=n], &rational(3, 7));
    }
}

/// Numbers that are large but close together do not make the matrix large.
#[test]
fn far_from_the_origin() {
    let far = whole(Int::from(10).pow(400));
    let shifted = |x: i64| &far + integer(x);
    let here = Basis::Bernstein(Interval::unit());
    let matrix = change_of_basis(3, &here, &Basis::Bernstein(Interval::new(integer(1), integer(3)).unwrap()));
    let there = Basis::Bernstein(Interval::new(shifted(0), shifted(1)).unwrap());
    assert_eq!(
        change_of_basis(3, &there, &Basis::Bernstein(Interval::new(shifted(1), shifted(3)).unwrap())),
        matrix
    );
}

#[test]
fn limits_come_before_the_work() {
    use crate::budget::{Limits, Stop, run};
    let limits = Limits { terms: 1000, ..Limits::default() };
    let stopped = run(&limits, || bernstein_to_power(1_000_000));
    assert!(matches!(stopped, Err(Stop::Terms { .. })));
    let stopped = run(&limits, || change_of_basis::<Rational>(usize::MAX - 1, &Basis::Power, &Basis::Power));
    assert!(matches!(stopped, Err(Stop::Terms { .. })));
}

#[test]
fn text_is_what_queries_read() {
    let over = || Interval::new(integer(0), integer(2)).unwrap();
    let list = [
        (Basis::Power, "power"),
        (Basis::Taylor { at: rational(1, 2) }, "[taylor, 1/2]"),
        (Basis::Bernstein(Interval::unit()), "bernstein"),
        (Basis::Bernstein(over()), "[bernstein, 0, 2]"),
        (Basis::Legendre(Interval::unit()), "[legendre, 0, 1]"),
        (Basis::HermiteEndpoints(over()), "[hermite, 0, 2]"),
        (Basis::Newton(vec![integer(0), integer(3)]), "[newton, 0, 3]"),
    ];
    for (basis, text) in list {
        assert_eq!((basis.to_string(), format!("{basis:?}")), (text.to_owned(), format!("Basis({text})")));
    }
}
