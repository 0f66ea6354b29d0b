//! A line of Bézier points: what curves share with the rows and columns of nets.
//!
//! The points are b_i = f(a^{n−i}, b^i) for the two ends a, b of some interval; an argument u
//! of f comes as its coordinates (α, β) with f(…, u, …) = α f(…, a, …) + β f(…, b, …), with
//! α + β = 1 for a point and 0 for a vector. There is always at least one point.
//!
//! Reference: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989), sections 5 and 6.

use super::{CurveError, Point};
use crate::budget;
use crate::math::number::{Int, Rational, binomial_row, over_one_denominator};
use crate::math::ring::Ring;

/// Puts in one argument: one level of de Casteljau's algorithm.
pub(super) fn put<C: Ring>(points: &[Point<C>], [alpha, beta]: &[C; 2]) -> Vec<Point<C>> {
    budget::steps(points.len() as u32);
    let mix = |p: &Point<C>, q: &Point<C>| -> Point<C> {
        p.iter().zip(q).map(|(x, y)| x.times(alpha).plus(&y.times(beta))).collect()
    };
    points.windows(2).map(|pair| mix(&pair[0], &pair[1])).collect()
}

/// f(u_1, …, u_n) for as many arguments as the degree says.
pub(super) fn blossom<'a, C: Ring>(
    points: &[Point<C>],
    arguments: impl IntoIterator<Item = &'a [C; 2]>,
) -> Point<C> {
    let mut level = points.to_vec();
    for argument in arguments {
        level = put(&level, argument);
    }
    level.swap_remove(0)
}

/// f(u, …, u)
pub(super) fn value<C: Ring>(points: &[Point<C>], u: &[C; 2]) -> Point<C> {
    blossom(points, std::iter::repeat_n(u, points.len() - 1))
}

/// The value at the ratio s on integers over one denominator: n²/2 products and a single gcd. `None`
/// unless everything is a number.
pub(super) fn value_of_numbers<C: Ring>(points: &[Point<C>], s: &C) -> Option<Point<C>> {
    let s = s.as_rational()?;
    let (p, q) = (s.numer().clone(), s.denom().clone());
    let rest = &q - &p;
    let degree = points.len() - 1;
    let coordinate = |k: usize| -> Option<C> {
        let numbers: Vec<Rational> =
            points.iter().map(|point| point[k].as_rational()).collect::<Option<_>>()?;
        let (mut level, scale) = over_one_denominator(&numbers);
        while level.len() > 1 {
            budget::steps(level.len() as u32);
            level = level.windows(2).map(|pair| &pair[0] * &rest + &pair[1] * &p).collect();
        }
        let denominator = num_traits::pow(q.clone(), degree) * scale;
        Some(C::from_rational(&Rational::new(level.swap_remove(0), denominator)))
    };
    (0..points[0].len()).map(coordinate).collect()
}

/// f(p^{n−i}, q^i) for i = 0, …, n: the points over [p, q], or with p = 0 and q = 1̂ the power
/// coefficients without their binomials. Cost: O(n³).
pub(super) fn values<C: Ring>(points: &[Point<C>], p: &[C; 2], q: &[C; 2]) -> Vec<Point<C>> {
    let mut level = points.to_vec();
    let mut list = vec![value(&level, q)];
    for _ in 1..points.len() {
        level = put(&level, p);
        list.push(value(&level, q));
    }
    list.reverse();
    list
}

/// The points over [a, u] and over [u, b].
pub(super) fn split<C: Ring>(points: &[Point<C>], u: &[C; 2]) -> (Vec<Point<C>>, Vec<Point<C>>) {
    let mut level = points.to_vec();
    let (mut left, mut right) = (Vec::new(), Vec::new());
    loop {
        left.extend(level.first().cloned());
        right.extend(level.last().cloned());
        if level.len() == 1 {
            right.reverse();
            return (left, right);
        }
        level = put(&level, u);
    }
}

/// The points of the k-th derivative; one zero if k exceeds the degree.
pub(super) fn derivative<C: Ring>(points: &[Point<C>], k: usize, inverse_width: &C) -> Vec<Point<C>> {
    let n = points.len() - 1;
    if k > n {
        return vec![vec![C::zero(); points[0].len()].into()];
    }
    let unit = [-inverse_width.clone(), inverse_width.clone()];
    let mut level = points.to_vec();
    for _ in 0..k {
        level = put(&level, &unit);
    }
    let factor = falling(n, k);
    level.iter().map(|p| p.iter().map(|x| x.scaled(&factor)).collect()).collect()
}

/// n (n − 1) … (n − k + 1); 0 if k > n.
pub(super) fn falling(n: usize, k: usize) -> Rational {
    if k > n {
        return Rational::from_integer(Int::ZERO);
    }
    Rational::from_integer((n - k + 1..=n).map(Int::from).product())
}

/// The points of the same polynomial with the degree raised.
pub(super) fn elevated<C: Ring>(points: &[Point<C>], by: usize) -> Vec<Point<C>> {
    budget::charge_terms((points.len() as u64).saturating_add(by as u64));
    let mut list = points.to_vec();
    for _ in 0..by {
        let n = list.len();
        budget::steps(n as u32);
        let between = (1..n).map(|i| {
            // b_i turns into i/(n+1) b_{i−1} + (1 − i/(n+1)) b_i, with n + 1 = the number of points
            let s = Rational::new(Int::from(i), Int::from(n));
            let rest = Rational::new(Int::from(n - i), Int::from(n));
            list[i - 1].iter().zip(&list[i]).map(|(x, y)| x.scaled(&s).plus(&y.scaled(&rest))).collect()
        });
        let mut next = vec![list[0].clone()];
        next.extend(between);
        next.push(list[n - 1].clone());
        list = next;
    }
    list
}

/// The degree of the polynomial: the largest k with Δ^k b_0 ≠ 0.
pub(super) fn exact_degree<C: Ring>(points: &[Point<C>]) -> usize {
    let mut level = points.to_vec();
    let mut exact = 0;
    for k in 1..points.len() {
        budget::steps(level.len() as u32);
        level = level.windows(2).map(|pair| (&pair[1] - &pair[0]).from_origin()).collect();
        if level[0].iter().any(|x| !x.is_zero()) {
            exact = k;
        }
    }
    exact
}

/// Whether a polynomial of degree `exact`, written with `degree`, can be written with `by` less.
pub(super) fn check_reducible(degree: usize, exact: usize, by: usize) -> Result<(), CurveError> {
    if exact.saturating_add(by) <= degree {
        Ok(())
    } else {
        Err(CurveError::NotReducible { degree, exact, by })
    }
}

/// The points of the same polynomial with the degree lowered, where [`check_reducible`] allows it.
pub(super) fn reduced<C: Ring>(points: &[Point<C>], by: usize) -> Vec<Point<C>> {
    let mut list = points.to_vec();
    for _ in 0..by {
        let n = list.len() - 1;
        budget::steps(n as u32);
        let mut lower: Vec<Point<C>> = Vec::with_capacity(n);
        for (i, b) in list.iter().take(n).enumerate() {
            // the inverse of the elevation: (n − i) c_i = n b_i − i c_{i−1}
            let front = Rational::new(Int::from(n), Int::from(n - i));
            let back = Rational::new(Int::from(i), Int::from(n - i));
            let point = match lower.last() {
                None => b.clone(),
                Some(c) => b.iter().zip(c).map(|(x, y)| x.scaled(&front).minus(&y.scaled(&back))).collect(),
            };
            lower.push(point);
        }
        list = lower;
    }
    list
}

/// The Bernstein coefficients of a product of two polynomials in two variables, from theirs:
/// (F G)_{kl} = Σ C(m,i) C(m',k−i) / C(m+m',k) · C(n,j) C(n',l−j) / C(n+n',l) · F_{ij} G_{k−i,l−j}.
pub(super) fn product<C: Ring>(f: &[Vec<C>], g: &[Vec<C>]) -> Vec<Vec<C>> {
    let rows = f.len() + g.len() - 1;
    let columns = f[0].len() + g[0].len() - 1;
    budget::charge_terms((rows as u64).saturating_mul(columns as u64));
    let (f, g) = (weighed(f, Weigh::With), weighed(g, Weigh::With));
    let mut h = vec![vec![C::zero(); columns]; rows];
    for (i, f_row) in f.iter().enumerate() {
        for (k, g_row) in g.iter().enumerate() {
            budget::steps((f_row.len() * g_row.len()) as u32);
            for (j, x) in f_row.iter().enumerate() {
                for (l, y) in g_row.iter().enumerate() {
                    h[i + k][j + l] += x.times(y);
                }
            }
        }
    }
    weighed(&h, Weigh::Without)
}

/// Coefficient by coefficient, for nets of equal size.
pub(super) fn zipped<C>(f: &[Vec<C>], g: &[Vec<C>], rule: impl Fn(&C, &C) -> C) -> Vec<Vec<C>> {
    let row = |(x, y): (&Vec<C>, &Vec<C>)| x.iter().zip(y).map(|(x, y)| rule(x, y)).collect();
    f.iter().zip(g).map(row).collect()
}

#[derive(Clone, Copy, PartialEq)]
enum Weigh {
    With,
    Without,
}

/// Entry (i, j) times, or divided by, C(m, i) C(n, j).
fn weighed<C: Ring>(net: &[Vec<C>], how: Weigh) -> Vec<Vec<C>> {
    let (in_u, in_v) = (binomial_row(net.len() - 1), binomial_row(net[0].len() - 1));
    let weigh = |(x, a): (&C, Int)| match how {
        Weigh::With => x.scaled(&Rational::from_integer(a)),
        Weigh::Without => x.scaled(&Rational::new(Int::ONE, a)),
    };
    let row = |(row, b): (&Vec<C>, &Int)| row.iter().zip(in_v.iter().map(|c| b * c)).map(weigh).collect();
    net.iter().zip(&in_u).map(row).collect()
}

/// The coordinates of the cross product of two vectors given by their coordinates, with any
/// product and difference of coordinates.
pub(super) fn cross<T>(v: &[T], w: &[T], times: impl Fn(&T, &T) -> T, minus: impl Fn(T, T) -> T) -> [T; 3] {
    let minor = |i: usize, j: usize| minus(times(&v[i], &w[j]), times(&v[j], &w[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::basis::bernstein_all;
    use crate::math::number::{integer as z, rational as q};
    use proptest::prelude::*;

    fn at(s: Rational) -> [Rational; 2] {
        [z(1) - &s, s]
    }

    fn line() -> impl Strategy<Value = Vec<Point<Rational>>> {
        let point = prop::collection::vec((-9i64..10).prop_map(z), 2).prop_map(Point::from);
        prop::collection::vec(point, 1..6)
    }

    proptest! {
        #[test]
        fn ways_agree(points in line(), s in (-5i64..6, 1i64..4), by in 0usize..3) {
            let s = q(s.0, s.1);
            let direct: Point<Rational> = super::super::combination(
                2, bernstein_all(points.len() - 1, &s).iter().zip(&points)).from_origin();
            prop_assert_eq!(value(&points, &at(s.clone())), direct.clone());
            let higher = elevated(&points, by);
            prop_assert_eq!(value(&higher, &at(s.clone())), direct);
            prop_assert_eq!(exact_degree(&higher), exact_degree(&points));
            prop_assert_eq!(reduced(&higher, by), points.clone());
            let (left, right) = split(&points, &at(s.clone()));
            prop_assert_eq!(values(&points, &at(z(0)), &at(s.clone())), left);
            prop_assert_eq!(values(&points, &at(s), &at(z(1))), right);
            prop_assert_eq!(values(&points, &at(z(0)), &at(z(1))), points);
        }

        #[test]
        fn products(f in prop::collection::vec((-9i64..10).prop_map(z), 1..5),
                    g in prop::collection::vec((-9i64..10).prop_map(z), 1..5)) {
            let s = q(2, 3);
            let at = |f: &[Rational]| -> Rational {
                bernstein_all(f.len() - 1, &s).iter().zip(f).map(|(b, x)| b * x).sum()
            };
            let h = product(std::slice::from_ref(&f), std::slice::from_ref(&g));
            prop_assert_eq!(at(&h[0]), at(&f) * at(&g));
        }
    }

    #[test]
    fn differences() {
        let points = [[z(0)], [z(0)], [z(1)]].map(Point::from); // s²
        assert_eq!(derivative(&points, 1, &z(1)), [[z(0)], [z(2)]]);
        assert_eq!(derivative(&points, 2, &q(1, 2)), [[q(1, 2)]]); // over an interval of width 2
        assert_eq!(derivative(&points, 3, &z(1)), [[z(0)]]);
        assert!(check_reducible(0, 0, 1).is_err());
    }
}
