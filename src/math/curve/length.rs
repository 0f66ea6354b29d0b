//! Lengths, and areas of polygons: Pythagorean hodographs, bounds of arc lengths.
//!
//! |c'|² is a polynomial. If it is σ² the curve has a Pythagorean hodograph and the length is ∫ |σ|; in the plane that is so for
//! c' = w (u² − v², 2 u v). Otherwise the length lies between that of the chord and that of the control polygon, of each part of the
//! curve; their difference falls to a quarter with each halving.
//!
//! R. T. Farouki, T. Sakkalis, "Pythagorean hodographs", IBM J. Res. Dev. 34 (1990); J. Gravesen, "Adaptive subdivision and the
//! length and energy of Bézier curves", Comput. Geom. 8 (1997).

use num_traits::{Signed, Zero};

use super::{BezierCurve, Point};
use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational, integer, rational};
use crate::math::poly::{Coefficients, Poly, RealRoot};
use crate::math::ring::{Field, Ring};

/// The polynomials of the coordinates.
fn coordinates(curve: &BezierCurve<Rational>) -> Vec<Poly> {
    curve.power().into_iter().map(Poly::from_coefficients).collect()
}

/// σ with σ² = |c'|² and a positive leading coefficient; `None` if there is no such polynomial. Cost: square-free factors.
///
/// ```
/// use polarform::curve::{BezierCurve, Interval, speed};
/// use polarform::number::integer as z;
/// // c' = (1 − t², 2 t)
/// let coordinates = [vec![z(0), z(1), z(0), polarform::number::rational(-1, 3)], vec![z(0), z(0), z(1)]];
/// let c = BezierCurve::from_power(&coordinates, Interval::unit())?;
/// assert_eq!(speed(&c).unwrap().to_string(), "t^2 + 1");
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn speed(curve: &BezierCurve<Rational>) -> Option<Poly> {
    let square = coordinates(curve).iter().fold(Poly::zero(), |sum, x| sum + x.derivative().pow(2));
    if square.is_zero() {
        return Some(Poly::zero());
    }
    let mut root = Poly::constant(crate::math::number::exact_root(&square.leading_coefficient(), 2)?);
    for (factor, multiplicity) in square.square_free_factors() {
        if multiplicity % 2 == 1 {
            return None;
        }
        root *= factor.leading_monic().pow((multiplicity / 2) as u32);
    }
    Some(root)
}

/// The length of a curve with a Pythagorean hodograph, if σ changes its sign at rational numbers only; else two numbers
/// between which the length lies, at most `width` apart.
///
/// Cost: subdivisions until the bounds are near, √(length/width) of them at least, and two roots of numbers for each point.
///
/// # Panics
/// If the width is not positive.
///
/// ```
/// use polarform::curve::{BezierCurve, Interval, arc_length};
/// use polarform::number::{integer as z, rational as q};
/// let c = BezierCurve::new(vec![vec![z(0), z(0)], vec![z(1), z(1)], vec![z(2), z(0)]], Interval::unit())?;
/// let (lower, upper) = arc_length(&c, &q(1, 100));
/// // √2 + ln(1 + √2) = 2.29558…
/// assert!(lower < q(22956, 10000) && upper > q(22955, 10000));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn arc_length(curve: &BezierCurve<Rational>, width: &Rational) -> (Rational, Rational) {
    assert!(width.is_positive(), "bounds need a positive width");
    if let Some(length) = exact_length(curve) {
        return (length.clone(), length);
    }
    let mut parts = vec![curve.clone()];
    loop {
        budget::charge_terms(parts.len() as u64);
        // Half of the width for the roots, so that they cannot stop the rest.
        let share = width / integer((4 * parts.len() * (curve.degree() + 1)) as i64);
        let mut sums = (Rational::zero(), Rational::zero());
        for part in &parts {
            let points = part.points();
            sums.0 += distance(&points[0], &points[points.len() - 1], &share).0;
            for pair in points.windows(2) {
                sums.1 += distance(&pair[0], &pair[1], &share).1;
            }
        }
        if &sums.1 - &sums.0 <= *width {
            return sums;
        }
        let halves = |part: &BezierCurve<Rational>| {
            budget::steps(1 + (curve.degree() * curve.degree()) as u32);
            let (a, b) = part.interval().ends();
            let (left, right) = part.subdivide(&((a + b) * rational(1, 2))).expect("the middle is no end");
            [left, right]
        };
        parts = parts.iter().flat_map(halves).collect();
    }
}

/// ∫ |σ|
fn exact_length(curve: &BezierCurve<Rational>) -> Option<Rational> {
    let sigma = speed(curve)?;
    let (a, b) = curve.interval().ends();
    let (a, b) = (a.min(b), a.max(b));
    let mut cuts = vec![a.clone()];
    for (root, multiplicity) in sigma.real_roots(Some(a), Some(b)).unwrap_or_default() {
        match root {
            RealRoot::Rational(t) => cuts.push(t),
            RealRoot::Irrational(_) if multiplicity % 2 == 1 => return None,
            RealRoot::Irrational(_) => {}
        }
    }
    cuts.push(b.clone());
    // A root at an end gives an empty interval, of length 0.
    let between = cuts.windows(2).filter_map(|pair| Interval::new(pair[0].clone(), pair[1].clone()).ok());
    Some(between.map(|interval| sigma.integral(&interval).abs()).sum())
}

/// Bounds of |p − q|, at most `width` apart.
fn distance(p: &Point<Rational>, q: &Point<Rational>, width: &Rational) -> (Rational, Rational) {
    let square: Rational = p.iter().zip(q.iter()).map(|(x, y)| (x - y) * (x - y)).sum();
    // ⌊√(N²·square)⌋/N with 1/N ≤ width.
    let n: Int = width.recip().ceil().to_integer();
    let scaled = square * Rational::from_integer(&n * &n);
    let floor = Int::from(num_integer::Roots::sqrt(&scaled.floor().to_integer().into_big()));
    let exact = Rational::from_integer(&floor * &floor) == scaled;
    let next = if exact { floor.clone() } else { &floor + Int::ONE };
    (Rational::new(floor, n.clone()), Rational::new(next, n))
}

/// The planar curve with c' = (u² − v², 2 u v) and c(0) = the start, by powers.
///
/// Cost: three products.
pub fn pythagorean_curve<C: Ring>(
    u: &Coefficients<C>,
    v: &Coefficients<C>,
    start: [C; 2],
) -> [Coefficients<C>; 2] {
    let both = u.times(v);
    let [x, y] = [u.times(u).minus(&v.times(v)), both.plus(&both)].map(|slope| slope.antiderivative());
    let [a, b] = start.map(Coefficients::constant);
    [x.plus(&a), y.plus(&b)]
}

/// The offset c + d n of a planar curve with a Pythagorean hodograph, with n = (−y', x')/σ to the left of the direction in which the
/// curve runs where σ > 0, by homogeneous coordinates σ x − d y', σ y + d x', σ. `None` if |c'|² is no square.
///
/// R. T. Farouki, T. Sakkalis, "Pythagorean hodographs", IBM J. Res. Dev. 34 (1990). Cost: that of [`speed`].
///
/// ```
/// use polarform::curve::{BezierCurve, Interval, pythagorean_offset};
/// use polarform::number::integer as z;
/// let line = BezierCurve::new(vec![vec![z(0), z(0)], vec![z(3), z(4)]], Interval::unit())?;
/// let moved = pythagorean_offset(&line, &z(5)).unwrap();
/// assert_eq!(moved.points(), [[z(-20), z(15), z(5)], [z(-5), z(35), z(5)]]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn pythagorean_offset(curve: &BezierCurve<Rational>, d: &Rational) -> Option<BezierCurve<Rational>> {
    let sigma = speed(curve).filter(|sigma| !sigma.is_zero())?;
    let list = coordinates(curve);
    let [x, y] = list.as_slice() else { return None };
    let moved = [&sigma * x - y.derivative().scale(d), &sigma * y + x.derivative().scale(d), sigma];
    let power: Vec<Vec<Rational>> = moved.iter().map(Poly::coefficients).collect();
    BezierCurve::from_power(&power, curve.interval().clone()).ok()
}

/// The area of a polygon of the plane and its moments: Σ a_i, Σ a_i (x_i + x_{i+1})/3 and Σ a_i (y_i + y_{i+1})/3 with
/// a_i = ½ det(p_i, p_{i+1}). Cost: linear.
///
/// # Panics
/// If a point has fewer than two coordinates.
pub fn polygon_moments<C: Field>(points: &[Point<C>]) -> [C; 3] {
    let mut sums = [C::zero(), C::zero(), C::zero()];
    for (p, q) in points.iter().zip(points.iter().cycle().skip(1)) {
        let area = p[0].times(&q[1]).minus(&p[1].times(&q[0])).scaled(&rational(1, 2));
        for k in 0..2 {
            sums[k + 1] += area.times(&p[k].plus(&q[k])).scaled(&rational(1, 3));
        }
        sums[0] += area;
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Interval;
    use proptest::prelude::*;

    fn poly(len: usize) -> impl Strategy<Value = Poly> {
        prop::collection::vec(-4i64..5, 1..len).prop_map(|list| list.into_iter().map(integer).collect())
    }

    fn curve(list: &[Poly], n: usize) -> BezierCurve<Rational> {
        let power: Vec<Vec<Rational>> =
            list.iter().map(|p| (0..=n).map(|k| p.coefficient(k)).collect()).collect();
        BezierCurve::from_power(&power, Interval::unit()).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// The speed is u² + v², and bounds without it contain the exact length.
        #[test]
        fn pythagorean_hodographs(u in poly(4), v in poly(4)) {
            let [a, b] = [&u, &v].map(|p| Coefficients::new(p.coefficients()));
            let list = pythagorean_curve(&a, &b, [integer(2), integer(3)]).map(|p| Poly::from_coefficients(p.to_vec()));
            let c = curve(&list, 7);
            prop_assert_eq!(c.value(&integer(0)), [integer(2), integer(3)]);
            let sigma = u.pow(2) + v.pow(2);
            prop_assert_eq!(speed(&c).unwrap(), sigma.clone());
            // The offset has the distance d from the curve, at right angles to it.
            if !sigma.is_zero() {
                let moved = pythagorean_offset(&c, &integer(3)).unwrap();
                for k in 0..=4 {
                    let t = rational(k, 4);
                    let (p, m) = (c.value(&t), moved.value(&t));
                    if m[2].is_zero() {
                        continue;
                    }
                    let [dx, dy] = [0, 1].map(|i| &m[i] / &m[2] - &p[i]);
                    let slope = c.nth_derivative(1).value(&t);
                    prop_assert_eq!(&dx * &dx + &dy * &dy, integer(9));
                    prop_assert!((dx * &slope[0] + dy * &slope[1]).is_zero());
                }
            }
            let length = sigma.integral(&Interval::unit());
            prop_assert_eq!(arc_length(&c, &rational(1, 10)), (length.clone(), length.clone()));
            // The same curve moved into space obliquely has no polynomial speed in general, but the same kind of bounds.
            let points = c.points();
            let (chord, polygon) = (
                distance(&points[0], &points[points.len() - 1], &rational(1, 1000)).0,
                points.windows(2).map(|p| distance(&p[0], &p[1], &rational(1, 1000)).1).sum::<Rational>(),
            );
            prop_assert!(chord <= length && length <= polygon);
        }

        /// Bounds get nearer and stay around the inner ones.
        #[test]
        fn bounds_are_nested(x in poly(4), y in poly(4)) {
            let c = curve(&[x, y], 3);
            let (wide, narrow) = (arc_length(&c, &integer(1)), arc_length(&c, &rational(1, 16)));
            prop_assert!(wide.0 <= narrow.1 && narrow.0 <= wide.1);
            prop_assert!(&narrow.1 - &narrow.0 <= rational(1, 16));
            // Riemann sums of |c'| by bounds of its square.
            let square = coordinates(&c).iter().fold(Poly::zero(), |sum, x| sum + x.derivative().pow(2));
            let parts = 64;
            let mut riemann = (Rational::zero(), Rational::zero());
            for k in 0..parts {
                let part = Interval::new(rational(k, parts), rational(k + 1, parts)).unwrap();
                let list = square.bernstein_coefficients(&part);
                let least = list.iter().min().cloned().unwrap_or_else(Rational::zero).max(Rational::zero());
                let most = list.iter().max().cloned().unwrap_or_else(Rational::zero).max(Rational::zero());
                let root = |q: Rational| {
                    let n = num_integer::Roots::sqrt(&(q * integer(1_000_000)).floor().to_integer().into_big());
                    let low = Rational::new(Int::from(n), Int::from(1000));
                    (low.clone(), low + rational(1, 1000))
                };
                riemann.0 += root(least).0 / integer(parts);
                riemann.1 += root(most).1 / integer(parts);
            }
            prop_assert!(riemann.0 <= narrow.1 && narrow.0 <= riemann.1);
        }

        /// The shoelace formula agrees with triangles from the origin.
        #[test]
        fn polygons(points in prop::collection::vec((-5i64..6, -5i64..6), 3..7)) {
            let at = |i: usize| { let (x, y) = points[i % points.len()]; [integer(x), integer(y)] };
            let mut expected = [Rational::zero(), Rational::zero(), Rational::zero()];
            for i in 0..points.len() {
                let ([a, b], [c, d]) = (at(i), at(i + 1));
                let area = (&a * &d - &b * &c) * rational(1, 2);
                expected[0] += area.clone();
                expected[1] += &area * (a + c) / integer(3);
                expected[2] += &area * (b + d) / integer(3);
            }
            let corners: Vec<Point<Rational>> = (0..points.len()).map(|i| at(i).into()).collect();
            prop_assert_eq!(polygon_moments(&corners), expected);
        }
    }
}
