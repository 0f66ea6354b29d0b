//! Area and centroid by Green's formula.
//!
//! The area that a closed curve encloses is ½ ∮ (x dy − y dx), its moments are ½ ∮ x² dy and −½ ∮ y² dx. Of a curve (X/W, Y/W)
//! the first integrand is (X Y' − Y X')/(2 W²). A quotient P/Q of polynomials has a rational antiderivative B/M with
//! M = gcd(Q, Q') and P = B' S − B (M' S/M) for S = Q/M, or none (Horowitz and Ostrogradsky): a linear system for B.
//!
//! E. Horowitz, "Algorithms for partial fraction decomposition and rational function integration", SYMSAC 1971.

use nalgebra::DMatrix;
use num_traits::Zero;

use super::PlaneCurve;
use crate::math::linalg::solutions;
use crate::math::number::{Rational, rational};
use crate::math::poly::{Poly, RealRoot};

/// Why there is no rational area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaError {
    /// The curve with this number has no ends.
    Endless(usize),
    /// It does not start where the one before ends.
    Apart(usize),
    /// A weight of it is 0: it goes through infinity.
    Infinite(usize),
    /// The antiderivative has logarithms or arcus tangents.
    NotRational(usize),
}

/// ½ ∮ (x dy − y dx), ½ ∮ x² dy and −½ ∮ y² dx along closed curves, one after the other.
///
/// Cost for a rational curve of degree n: linear systems of size 2 n and 4 n.
///
/// # Errors
/// [`AreaError`] with the number of a curve; a curve whose integral is not rational is told even if another one takes that away again.
///
/// ```
/// use polarform::curve::{PlaneCurve, green};
/// use polarform::number::{integer as z, rational as q};
/// use polarform::poly::Poly;
/// let t = Poly::variable();
/// let over = |x: Poly, y: Poly| PlaneCurve::new([x, y, Poly::one()], (Some(z(0)), Some(z(1)))).unwrap();
/// // Under the arch of a parabola: 2/3 of the triangle of its tangents.
/// let arch = over(Poly::from(2) - t.scale(&z(2)), (&t - t.pow(2)).scale(&z(4)));
/// let [area, x, _] = green(&[over(t.scale(&z(2)), Poly::from(0)), arch]).unwrap();
/// assert_eq!((area.clone(), x / area), (q(4, 3), z(1)));
/// ```
pub fn green(curves: &[PlaneCurve]) -> Result<[Rational; 3], AreaError> {
    let mut sums = [Rational::zero(), Rational::zero(), Rational::zero()];
    let mut ends = Vec::with_capacity(curves.len());
    for (i, curve) in curves.iter().enumerate() {
        let (Some(a), Some(b)) = curve.range() else { return Err(AreaError::Endless(i)) };
        let [x, y, w] = curve.coordinates();
        if w.real_roots(Some(a), Some(b)).is_none_or(|roots| !roots.is_empty()) {
            return Err(AreaError::Infinite(i));
        }
        ends.push([a, b].map(|t| curve.point(&RealRoot::Rational(t.clone()))));
        let (dx, dy) = (x.derivative() * w - x * w.derivative(), y.derivative() * w - y * w.derivative());
        let forms = [(x * y.derivative() - y * x.derivative(), 2), (x.pow(2) * dy, 4), (-y.pow(2) * dx, 4)];
        for (sum, (above, power)) in sums.iter_mut().zip(forms) {
            let value = integral(&above, &w.pow(power), a, b).ok_or(AreaError::NotRational(i))?;
            *sum += value * rational(1, 2);
        }
    }
    for i in 0..ends.len() {
        let next = (i + 1) % ends.len();
        if ends[i][1] != ends[next][0] {
            return Err(AreaError::Apart(next));
        }
    }
    Ok(sums)
}

/// The integral of P/Q from a to b, where Q has no root; `None` if the antiderivative is not rational.
fn integral(p: &Poly, q: &Poly, a: &Rational, b: &Rational) -> Option<Rational> {
    let (whole, rest) = p.div_rem(q)?;
    let primitive = whole.antiderivative();
    let mut value = primitive.value(b) - primitive.value(a);
    if !rest.is_zero() {
        let m = q.gcd(&q.derivative());
        let s = q.div_exact(&m)?;
        let inner = (m.derivative() * &s).div_exact(&m)?;
        let columns = m.degree()?;
        let images: Vec<Poly> = (0..columns)
            .map(|k| {
                let power = Poly::monomial(rational(1, 1), k);
                power.derivative() * &s - power * &inner
            })
            .collect();
        let rows = images.iter().chain([&rest]).filter_map(Poly::degree).max()? + 1;
        let matrix = DMatrix::from_fn(rows, columns, |i, k| images[k].coefficient(i));
        let right: Vec<Rational> = (0..rows).map(|i| rest.coefficient(i)).collect();
        let found = solutions(&matrix, &right).ok()?;
        let mut coefficients = vec![Rational::zero(); columns];
        for (k, c) in found.determined.into_iter().zip(found.constants?) {
            coefficients[k] = c;
        }
        let above = Poly::from_coefficients(coefficients);
        let quotient = |t: &Rational| above.value(t) / m.value(t);
        value += quotient(b) - quotient(a);
    }
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::polygon_moments;
    use crate::math::number::integer as z;
    use proptest::prelude::*;

    fn poly(list: &[i64]) -> Poly {
        list.iter().map(|&k| z(k)).collect()
    }

    fn segment(p: [Rational; 2], q: [Rational; 2], weights: [i64; 2]) -> PlaneCurve {
        // w_0 p (1 − t) + w_1 q t over w_0 (1 − t) + w_1 t
        let line = |a: Rational, b: Rational| Poly::from_coefficients(vec![a.clone(), b - a]);
        let [v, w] = weights.map(z);
        let [x, y] = [0, 1].map(|k| line(&p[k] * &v, &q[k] * &w));
        PlaneCurve::new([x, y, line(v, w)], (Some(z(0)), Some(z(1)))).unwrap()
    }

    proptest! {
        /// Edges of a polygon with weights at their ends enclose what the polygon does.
        #[test]
        fn the_parameter_does_not_matter(
            points in prop::collection::vec([-6i64..7, -6i64..7], 3..6), weights in prop::collection::vec(1i64..5, 6),
        ) {
            let at = |i: usize| points[i % points.len()].map(z);
            let edge = |i: usize| segment(at(i), at(i + 1), [weights[i], weights[(i * i + 1) % 6]]);
            let edges: Vec<PlaneCurve> = (0..points.len()).map(edge).collect();
            let corners: Vec<_> = (0..points.len()).map(|i| at(i).into()).collect();
            prop_assert_eq!(green(&edges), Ok(polygon_moments(&corners)));
        }

        /// A rational antiderivative is found again, and none where a pole is simple.
        #[test]
        fn derivatives_are_integrated(
            a in prop::collection::vec(-5i64..6, 1..5), m in prop::collection::vec(-3i64..4, 1..3), c in -3i64..4,
        ) {
            let below = Poly::from(3) + poly(&m).pow(2);
            let above = poly(&a).derivative() * &below - poly(&a) * below.derivative();
            let more = poly(&[c]) * &below;
            let found = integral(&(&above + &more), &below.pow(2), &z(-1), &z(2));
            let quotient = |t: i64| poly(&a).value(&z(t)) / below.value(&z(t));
            let expected = quotient(2) - quotient(-1);
            if below.degree() == Some(0) {
                prop_assert_eq!(found, Some(expected + z(3 * c) / below.value(&z(0))));
            } else {
                prop_assert_eq!(found, (c == 0).then_some(expected));
            }
        }
    }

    #[test]
    fn what_has_no_rational_area() {
        // x² + y² = 1 in the first quadrant
        let arc =
            PlaneCurve::new([poly(&[1, 0, -1]), poly(&[0, 2]), poly(&[1, 0, 1])], (Some(z(0)), Some(z(1))))
                .unwrap();
        let [o, p, q] = [[0, 0], [1, 0], [0, 1]].map(|p: [i64; 2]| p.map(z));
        assert_eq!(
            green(&[segment(o.clone(), p.clone(), [1, 1]), arc.clone(), segment(q, o, [1, 1])]),
            Err(AreaError::NotRational(1))
        );
        assert_eq!(
            green(&[segment(p.clone(), p.clone(), [1, 1]), segment([z(2), z(0)], p, [1, 1])]),
            Err(AreaError::Apart(1))
        );
        let endless = PlaneCurve::new([poly(&[0, 1]), poly(&[1]), poly(&[1])], (None, Some(z(1)))).unwrap();
        assert_eq!(green(&[endless]), Err(AreaError::Endless(0)));
        let pole =
            PlaneCurve::new([poly(&[1]), poly(&[0, 1]), poly(&[-1, 2])], (Some(z(0)), Some(z(1)))).unwrap();
        assert_eq!(green(&[pole]), Err(AreaError::Infinite(0)));
    }
}
