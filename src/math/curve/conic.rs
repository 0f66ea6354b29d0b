//! Conics as rational quadratic curves, and their equations.
//!
//! **Shape.** A conic arc from p_0 to p_2 with tangents meeting in p_1 has weights 1, w, 1 up to a
//! change of parameter. Its denominator has discriminant w_1² − w_0 w_2, the number of points at
//! infinity: none for an ellipse (w² < 1), a double one for a parabola, two for a hyperbola.
//!
//! **Equation.** Write X = B_0 h_0 + B_1 h_1 + B_2 h_2 with control vectors h_i = (w_i p_i, w_i)
//! and L_0 = det(X, h_1, h_2), L_1 = det(h_0, X, h_2), L_2 = det(h_0, h_1, X). Then
//! L_i = B_i det(h_0, h_1, h_2), and B_1² = 4 B_0 B_2 gives L_1² − 4 L_0 L_2 = 0, a quadratic form
//! in X = (x, y, 1).
//!
//! Reference: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), chapter 12.

use std::cmp::Ordering;

use nalgebra::DMatrix;

use super::domain::{Triangle, determinant};
use super::rational::RationalCurve;
use super::{CurveError, Interval, Point, polygon};
use crate::math::linalg;
use crate::math::number::integer;
use crate::math::ring::Field;
use crate::math::ring::compare;

/// What a rational quadratic curve is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConicKind {
    /// An ellipse, perhaps a circle: no point at infinity.
    Ellipse,
    /// A parabola: one point at infinity.
    Parabola,
    /// A hyperbola: two points at infinity.
    Hyperbola,
    /// Part of a line, or a single point: the control vectors are linearly dependent.
    Line,
}

/// The conic arc over [0, 1] from p_0 to p_2 with tangents towards p_1 and weights 1, w, 1.
///
/// # Errors
/// [`CurveError::Dimensions`], [`CurveError::ZeroWeight`].
///
/// ```
/// use polarform::curve::{ConicKind, conic_arc, conic_kind};
/// use polarform::number::{integer as z, rational as q};
/// let points = [[0, 0], [1, 2], [2, 0]].map(|p| p.map(z).to_vec());
/// let arc = conic_arc(points, q(1, 2))?;
/// assert_eq!(arc.value(&q(1, 2))?, [z(1), q(2, 3)]);
/// assert_eq!(conic_kind(&arc)?, Some(ConicKind::Ellipse));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn conic_arc<C: Field>(
    points: [impl Into<Point<C>>; 3],
    weight: C,
) -> Result<RationalCurve<C>, CurveError> {
    RationalCurve::new(points.into(), vec![C::one(), weight, C::one()], Interval::unit())
}

/// The conic over [0, 1] from p_0 to p_2 with tangents towards p_1 that passes through q at 1/2.
///
/// With the barycentric coordinates τ of q the weights 2τ_0, τ_1, 2τ_2 do it, whatever τ: no
/// square root is needed unless the first and last weight have to be equal.
///
/// # Errors
/// [`CurveError::Degenerate`] for three points on a line, [`CurveError::ZeroWeight`] for q on a side
/// of their triangle, [`CurveError::DimensionsOf`] unless in the plane.
pub fn conic_through<C: Field>(
    points: [impl Into<Point<C>>; 3],
    q: &[C],
) -> Result<RationalCurve<C>, CurveError> {
    let triangle = Triangle::new(points)?;
    let [first, middle, last] = triangle.barycentric(q)?;
    let weights = vec![first.plus(&first), middle, last.plus(&last)];
    RationalCurve::new(triangle.corners().to_vec(), weights, Interval::unit())
}

fn quadratic<C: Field>(curve: &RationalCurve<C>) -> Result<[&Point<C>; 3], CurveError> {
    let [first, middle, last] = curve.homogeneous().points() else {
        return Err(CurveError::Degrees { left: curve.degree(), right: 2 });
    };
    Ok([first, middle, last])
}

/// What a rational curve of degree 2 is, in any dimension; `None` if it depends on symbols.
///
/// # Errors
/// [`CurveError::Degrees`] unless the degree is 2.
pub fn conic_kind<C: Field>(curve: &RationalCurve<C>) -> Result<Option<ConicKind>, CurveError> {
    let vectors = quadratic(curve)?;
    let size = curve.dimension();
    if linalg::rank(&DMatrix::from_fn(3, size + 1, |i, j| vectors[i][j].clone())) < 3 {
        return Ok(Some(ConicKind::Line));
    }
    let [first, middle, last] = vectors.map(|vector| &vector[size]);
    Ok(compare(&middle.times(middle), &first.times(last)).map(|order| match order {
        Ordering::Less => ConicKind::Ellipse,
        Ordering::Equal => ConicKind::Parabola,
        Ordering::Greater => ConicKind::Hyperbola,
    }))
}

/// The equation A x² + B x y + C y² + D x + E y + F = 0 of a conic.
#[derive(Clone, Debug, PartialEq)]
pub struct ImplicitConic<C> {
    /// A, B, C, D, E, F, up to a common factor.
    pub coefficients: [C; 6],
}

impl<C: Field> ImplicitConic<C> {
    /// The equation of a rational quadratic curve in the plane.
    ///
    /// # Errors
    /// [`CurveError::Degrees`] unless the degree is 2, [`CurveError::DimensionsOf`] unless in the
    /// plane, [`CurveError::Degenerate`] if the control vectors are linearly dependent.
    ///
    /// ```
    /// use polarform::curve::{ImplicitConic, conic_arc};
    /// use polarform::number::integer as z;
    /// // the parabola y = x²
    /// let arc = conic_arc([[-1, 1], [0, -1], [1, 1]].map(|p| p.map(z).to_vec()), z(1))?;
    /// let conic = ImplicitConic::new(&arc)?;
    /// assert_eq!(conic.coefficients, [16, 0, 0, 0, -16, 0].map(z));
    /// # Ok::<(), polarform::curve::CurveError>(())
    /// ```
    pub fn new(curve: &RationalCurve<C>) -> Result<Self, CurveError> {
        let [first, middle, last] = quadratic(curve)?;
        if curve.dimension() != 2 {
            return Err(CurveError::DimensionsOf { left: curve.dimension(), right: 2 });
        }
        let cross = |v: &[C], w: &[C]| polygon::cross(v, w, C::times, |x, y| x.minus(&y));
        let forms = [cross(middle, last), cross(last, first), cross(first, middle)];
        let volume = forms[0].iter().zip(first).fold(C::zero(), |sum, (x, y)| sum + x.times(y));
        if volume.is_zero() {
            return Err(CurveError::Degenerate);
        }
        // the coefficient of X_i X_j in L_1² − 4 L_0 L_2; for i ≠ j two products have this monomial
        let [l, m, r] = &forms;
        let entry = |i: usize, j: usize| {
            let mut square = m[i].times(&m[j]);
            let mut mixed = l[i].times(&r[j]);
            if i != j {
                square = square.plus(&square);
                mixed += l[j].times(&r[i]);
            }
            square.minus(&mixed.scaled(&integer(4)))
        };
        let coefficients = [entry(0, 0), entry(0, 1), entry(1, 1), entry(0, 2), entry(1, 2), entry(2, 2)];
        Ok(ImplicitConic { coefficients })
    }

    /// The left side at a point of the plane.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless p has 2 coordinates.
    pub fn value(&self, p: &[C]) -> Result<C, CurveError> {
        let [x, y] = p else {
            return Err(CurveError::DimensionsOf { left: 2, right: p.len() });
        };
        let monomials = [x.times(x), x.times(y), y.times(y), x.clone(), y.clone(), C::one()];
        let terms = self.coefficients.iter().zip(&monomials);
        Ok(terms.fold(C::zero(), |sum, (c, monomial)| sum + c.times(monomial)))
    }

    /// The centre of symmetry, where both partial derivatives vanish; a parabola has none.
    pub fn centre(&self) -> Option<Point<C>> {
        let [a, b, c, d, e, _] = &self.coefficients;
        let (rows, right) = ([[a.plus(a), b.clone()], [b.clone(), c.plus(c)]], [-d.clone(), -e.clone()]);
        let inverse = determinant(&rows[0], &rows[1]).inverse()?;
        let x = determinant(&[right[0].clone(), rows[0][1].clone()], &[right[1].clone(), rows[1][1].clone()]);
        let y = determinant(&[rows[0][0].clone(), right[0].clone()], &[rows[1][0].clone(), right[1].clone()]);
        Some([x.times(&inverse), y.times(&inverse)].into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::BezierCurve;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use num_traits::Signed;
    use proptest::prelude::*;

    fn any_quadratic() -> impl Strategy<Value = RationalCurve<Rational>> {
        prop::collection::vec(prop::collection::vec((-6i64..7).prop_map(z), 3), 3).prop_map(|vectors| {
            RationalCurve::from_homogeneous(BezierCurve::new(vectors, Interval::unit()).unwrap()).unwrap()
        })
    }

    proptest! {
        #[test]
        fn curves_satisfy_their_equation(curve in any_quadratic(), list in prop::collection::vec((-9i64..10, 1i64..5), 6)) {
            let kind = conic_kind(&curve).unwrap().unwrap();
            match ImplicitConic::new(&curve) {
                Ok(conic) => {
                    for (p, r) in list {
                        if let Ok(point) = curve.value(&q(p, r)) {
                            prop_assert_eq!(conic.value(&point), Ok(z(0)));
                        }
                    }
                    let [a, b, c, ..] = &conic.coefficients;
                    let discriminant = b * b - a * c * z(4);
                    let expected = if discriminant.is_negative() {
                        ConicKind::Ellipse
                    } else if discriminant == z(0) {
                        ConicKind::Parabola
                    } else {
                        ConicKind::Hyperbola
                    };
                    prop_assert_eq!(kind, expected);
                    // the centre is the mean of opposite points, where the line through it meets twice
                    prop_assert_eq!(conic.centre().is_none(), kind == ConicKind::Parabola);
                    if let (Some(m), Ok(p)) = (conic.centre(), curve.value(&q(1, 3))) {
                        let opposite: Point<Rational> = m.iter().zip(&p).map(|(m, x)| m * z(2) - x).collect();
                        prop_assert_eq!(conic.value(&opposite), Ok(z(0)));
                    }
                }
                Err(error) => {
                    prop_assert_eq!(error, CurveError::Degenerate);
                    prop_assert_eq!(kind, ConicKind::Line);
                }
            }
        }

        #[test]
        fn a_point_in_the_middle(c in prop::collection::vec((-6i64..7).prop_map(z), 8)) {
            let points = [c[0..2].to_vec(), c[2..4].to_vec(), c[4..6].to_vec()];
            match conic_through(points.clone(), &c[6..]) {
                Ok(curve) => {
                    prop_assert_eq!(curve.value(&q(1, 2)), Ok(c[6..].into()));
                    prop_assert_eq!(&curve.value(&z(0)).unwrap(), &points[0]);
                    let tangent = curve.derivatives(&z(1), 1).unwrap()[1].clone();
                    let edge: Vec<_> = (0..2).map(|k| &points[2][k] - &points[1][k]).collect();
                    prop_assert_eq!(determinant(&tangent, &edge), z(0));
                }
                Err(error) => {
                    let expected = matches!(error, CurveError::Degenerate | CurveError::ZeroWeight { .. });
                    prop_assert!(expected);
                }
            }
        }
    }

    #[test]
    fn kinds_by_the_shoulder_weight() {
        let points = [[0, 0], [1, 2], [2, 0]].map(|p| p.map(z).to_vec());
        for (weight, kind) in [
            (q(1, 2), ConicKind::Ellipse),
            (q(-1, 2), ConicKind::Ellipse),
            (z(1), ConicKind::Parabola),
            (z(2), ConicKind::Hyperbola),
        ] {
            assert_eq!(conic_kind(&conic_arc(points.clone(), weight).unwrap()), Ok(Some(kind)));
        }
        let flat = conic_arc([[0], [1], [2]].map(|p| p.map(z).to_vec()), z(2)).unwrap();
        assert_eq!(conic_kind(&flat), Ok(Some(ConicKind::Line)));
        assert!(ImplicitConic::new(&flat).is_err());
        let line = RationalCurve::new(vec![vec![z(0)]], vec![z(1)], Interval::unit()).unwrap();
        assert_eq!(conic_kind(&line), Err(CurveError::Degrees { left: 0, right: 2 }));
        assert_eq!(conic_arc(points, z(0)), Err(CurveError::ZeroWeight { index: 1 }));
    }

    #[test]
    fn a_symbolic_weight() {
        let number = |x: i64| Fraction::from(z(x));
        let w = Fraction::from(MultiPoly::symbol(Symbol::new("w")));
        let points = [[0, 0], [0, 1], [1, 1]].map(|p| p.map(number).to_vec());
        let arc = conic_arc(points, w.clone()).unwrap();
        assert_eq!(conic_kind(&arc), Ok(None));
        let conic = ImplicitConic::new(&arc).unwrap();
        let t = Fraction::from(MultiPoly::symbol(Symbol::new("t")));
        assert_eq!(conic.value(&arc.value(&t).unwrap()), Ok(number(0)));
        let [a, b, c, ..] = &conic.coefficients;
        let discriminant = b.clone() * b.clone() - number(4) * a.clone() * c.clone();
        assert_eq!(discriminant, number(16) * w.clone() * w.clone() * (w.clone() * w - number(1)));
    }
}
