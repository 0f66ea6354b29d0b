//! Rational Bézier surfaces: tensor-product and triangular.
//!
//! As for curves, a rational patch is a polynomial one of dimension d + 1, the weight last, and
//! its surface point is x / w. Everything linear is done on the homogeneous patch.
//!
//! **Invariant.** The homogeneous patch has at least one coordinate.
//!
//! References: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), chapters 16 and 17;
//! L. Piegl, W. Tiller, *The NURBS Book* (1997), section 4.5.

use super::domain::Triangle;
use super::patch::{Direction, TensorPatch, minus};
use super::projective::{check_weight, lifted, lifted_net, parted, projected, quotient_derivatives};
use super::triangle::TrianglePatch;
use super::{CurveError, Point, Vector, polygon};
use crate::budget;
use crate::math::interval::Interval;
use crate::math::ring::{Field, Ring};

/// A rational tensor-product patch.
///
/// ```
/// use polarform::curve::{CurveError, Interval, RationalPatch};
/// use polarform::number::{integer as z, rational as q};
/// // a quarter of the cylinder x² + y² = 1 of height 1
/// let row = |x, y| vec![vec![z(x), z(y), z(0)], vec![z(x), z(y), z(1)]];
/// let net = vec![row(1, 0), row(1, 1), row(0, 1)];
/// let weights = [1, 1, 2].map(|w| vec![z(w), z(w)]).to_vec();
/// let patch = RationalPatch::new(net, weights, Interval::unit(), Interval::unit())?;
/// assert_eq!(patch.value(&q(1, 2), &q(1, 3))?, [q(3, 5), q(4, 5), q(1, 3)]);
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct RationalPatch<C> {
    homogeneous: TensorPatch<C>,
}

impl<C: Field> RationalPatch<C> {
    /// The patch with this net of control points and of weights.
    ///
    /// # Errors
    /// [`CurveError::WeightCount`] (of all points, or of the first row that differs),
    /// [`CurveError::ZeroWeight`] with the place counted along the rows, and those of
    /// [`TensorPatch::new`].
    pub fn new(
        points: Vec<Vec<impl Into<Point<C>>>>,
        weights: Vec<Vec<C>>,
        u: Interval<C>,
        v: Interval<C>,
    ) -> Result<Self, CurveError> {
        let plain = TensorPatch::new(points, u.clone(), v.clone())?;
        Ok(RationalPatch { homogeneous: TensorPatch::new(lifted_net(plain.net(), &weights)?, u, v)? })
    }

    /// The image of a polynomial patch, its last coordinate being the weight. Control vectors may
    /// have weight 0.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] if there are no coordinates.
    pub fn from_homogeneous(homogeneous: TensorPatch<C>) -> Result<Self, CurveError> {
        check_weight(homogeneous.dimension())?;
        Ok(RationalPatch { homogeneous })
    }

    /// The polynomial patch with the weight as its last coordinate.
    pub fn homogeneous(&self) -> &TensorPatch<C> {
        &self.homogeneous
    }

    /// The number of coordinates, without the weight.
    pub fn dimension(&self) -> usize {
        self.homogeneous.dimension() - 1
    }

    /// The weights by rows.
    pub fn weights(&self) -> Vec<Vec<C>> {
        self.homogeneous.coordinate(self.dimension())
    }

    /// The control points by rows; `None` for one at infinity.
    pub fn points(&self) -> Vec<Vec<Option<Point<C>>>> {
        self.homogeneous.net().iter().map(|row| row.iter().map(|v| projected(v).ok()).collect()).collect()
    }

    /// The surface point at (u, v), inside of the rectangle or outside.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`].
    pub fn value(&self, u: &C, v: &C) -> Result<Point<C>, CurveError> {
        projected(&self.homogeneous.value(u, v))
    }

    /// The position vector and all partial derivatives of order at most k at (u, v): entry (r, s), r + s ≤ k, belongs to
    /// ∂^{r+s}/∂u^r ∂v^s.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`].
    pub fn derivatives(&self, u: &C, v: &C, k: usize) -> Result<Vec<Vec<Vector<C>>>, CurveError> {
        quotient_derivatives(&triangular(k, |r, s| self.homogeneous.derivative_at(r, s, u, v)))
    }

    /// The normal ∂f/∂u × ∂f/∂v at (u, v).
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless the dimension is 3, [`CurveError::ZeroDenominator`].
    pub fn normal_at(&self, u: &C, v: &C) -> Result<Vector<C>, CurveError> {
        three(self.dimension())?;
        let jet = self.derivatives(u, v, 1)?;
        Ok(polygon::cross(&jet[1][0], &jet[0][1], C::times, |x, y| x.minus(&y)).into())
    }

    /// The tangent planes as a polynomial: a patch of degree (3m − 1, 3n − 1) in dimension 4 whose
    /// value (n, e) is the plane n·x + e = 0 that touches the surface, with n = w³ ∂f/∂u × ∂f/∂v.
    ///
    /// By the homogeneous point F it is the linear form X ↦ ± det(F, ∂F/∂u, ∂F/∂v, X), which
    /// needs no division. Cost: O(m² n²) products.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless the dimension is 3.
    pub fn tangent_planes(&self) -> Result<TensorPatch<C>, CurveError> {
        three(self.dimension())?;
        let parts = |patch: &TensorPatch<C>| (0..4).map(|k| patch.coordinate(k)).collect::<Vec<_>>();
        let position = parts(&self.homogeneous);
        let (along_u, along_v) =
            (parts(&self.homogeneous.derivative(1, 0)), parts(&self.homogeneous.derivative(0, 1)));
        let minor = |i: usize, j: usize| {
            minus(&polygon::product(&along_u[i], &along_v[j]), &polygon::product(&along_u[j], &along_v[i]))
        };
        let minors = [[minor(1, 2), minor(0, 1)], [minor(2, 3), minor(0, 3)], [minor(1, 3), minor(0, 2)]];
        let [[m12, m01], [m23, m03], [m13, m02]] = &minors;
        // F^a M_bc − F^b M_ac + F^c M_ab for the columns a < b < c, the first and third with +
        let form = |[(a, bc), (b, ac), (c, ab)]: [(usize, &Vec<Vec<C>>); 3], positive: bool| {
            let [first, second, third] =
                [(a, bc), (b, ac), (c, ab)].map(|(k, minor)| polygon::product(&position[k], minor));
            let outer = added(&first, &third);
            if positive { minus(&outer, &second) } else { minus(&second, &outer) }
        };
        let forms = [
            form([(1, m23), (2, m13), (3, m12)], true),
            form([(0, m23), (2, m03), (3, m02)], false),
            form([(0, m13), (1, m03), (3, m01)], true),
            form([(0, m12), (1, m02), (2, m01)], false),
        ];
        Ok(self.homogeneous.with_coordinates(&forms))
    }

    /// The two patches on both sides of u = t, or of v = t.
    ///
    /// # Errors
    /// [`CurveError::EmptyInterval`] if t is an end of the interval.
    pub fn subdivide(&self, direction: Direction, t: &C) -> Result<(Self, Self), CurveError> {
        let (left, right) = self.homogeneous.subdivide(direction, t)?;
        Ok((RationalPatch { homogeneous: left }, RationalPatch { homogeneous: right }))
    }
}

/// A rational triangular patch.
///
/// ```
/// use polarform::curve::{CurveError, RationalTriangle, Triangle};
/// use polarform::number::{integer as z, rational as q};
/// let points = vec![vec![z(0)], vec![z(1)], vec![z(2)]];
/// let patch = RationalTriangle::new(points, [1, 1, 2].map(z).to_vec(), Triangle::unit())?;
/// assert_eq!(patch.value(&[q(1, 3), q(1, 3)])?, [q(5, 4)]);
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct RationalTriangle<C> {
    homogeneous: TrianglePatch<C>,
}

impl<C: Field> RationalTriangle<C> {
    /// The patch with these control points and weights, in the order of [`super::indices`].
    ///
    /// # Errors
    /// [`CurveError::WeightCount`], [`CurveError::ZeroWeight`], and those of [`TrianglePatch::new`].
    pub fn new(
        points: Vec<impl Into<Point<C>>>,
        weights: Vec<C>,
        triangle: Triangle<C>,
    ) -> Result<Self, CurveError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        super::dimension(&points)?;
        Ok(RationalTriangle { homogeneous: TrianglePatch::new(lifted(&points, &weights)?, triangle)? })
    }

    /// The image of a polynomial patch, its last coordinate being the weight. Control vectors may
    /// have weight 0.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] if there are no coordinates.
    pub fn from_homogeneous(homogeneous: TrianglePatch<C>) -> Result<Self, CurveError> {
        check_weight(homogeneous.dimension())?;
        Ok(RationalTriangle { homogeneous })
    }

    /// The polynomial patch with the weight as its last coordinate.
    pub fn homogeneous(&self) -> &TrianglePatch<C> {
        &self.homogeneous
    }

    /// The number of coordinates, without the weight.
    pub fn dimension(&self) -> usize {
        self.homogeneous.dimension() - 1
    }

    /// The weights.
    pub fn weights(&self) -> Vec<C> {
        self.homogeneous.points().iter().map(|vector| parted(vector).1.clone()).collect()
    }

    /// The control points; `None` for one at infinity.
    pub fn points(&self) -> Vec<Option<Point<C>>> {
        self.homogeneous.points().iter().map(|vector| projected(vector).ok()).collect()
    }

    /// The surface point at p, inside of the triangle or outside.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`], [`CurveError::DimensionsOf`] unless p is in the plane.
    pub fn value(&self, p: &[C]) -> Result<Point<C>, CurveError> {
        projected(&self.homogeneous.value(p)?)
    }

    /// The position vector and all partial derivatives of order at most k at p, with x, y the coordinates of the parameter
    /// plane: entry (r, s), r + s ≤ k, belongs to ∂^{r+s}/∂x^r ∂y^s.
    ///
    /// # Errors
    /// As for [`RationalTriangle::value`].
    pub fn derivatives(&self, p: &[C], k: usize) -> Result<Vec<Vec<Vector<C>>>, CurveError> {
        self.homogeneous.value(p)?;
        let derivative = |r, s| Ok(self.homogeneous.partial_derivative(r, s).value(p)?.position());
        let grid = triangular(k, derivative).into_iter().map(|row| row.into_iter().collect());
        quotient_derivatives(&grid.collect::<Result<Vec<Vec<_>>, CurveError>>()?)
    }

    /// The normal ∂f/∂x × ∂f/∂y at p.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless the dimension is 3 and p is in the plane,
    /// [`CurveError::ZeroDenominator`].
    pub fn normal_at(&self, p: &[C]) -> Result<Vector<C>, CurveError> {
        three(self.dimension())?;
        let jet = self.derivatives(p, 1)?;
        Ok(polygon::cross(&jet[1][0], &jet[0][1], C::times, |x, y| x.minus(&y)).into())
    }
}

fn three(dimension: usize) -> Result<(), CurveError> {
    if dimension == 3 { Ok(()) } else { Err(CurveError::DimensionsOf { left: dimension, right: 3 }) }
}

/// Entries (r, s) with r + s ≤ k.
fn triangular<T>(k: usize, entry: impl Fn(usize, usize) -> T) -> Vec<Vec<T>> {
    let size = k as u64 + 1;
    budget::charge_terms(size.saturating_mul(size) / 2);
    (0..=k).map(|r| (0..=k - r).map(|s| entry(r, s)).collect()).collect()
}

fn added<C: Ring>(f: &[Vec<C>], g: &[Vec<C>]) -> Vec<Vec<C>> {
    polygon::zipped(f, g, C::plus)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Surface;
    use crate::math::curve::{indices, patch, triangle};
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{MultiPoly, Symbol};
    use proptest::prelude::*;

    /// A quotient of polynomials in x and y, not reduced.
    #[derive(Clone)]
    struct Quotient(MultiPoly, MultiPoly);

    impl Quotient {
        /// The quotient rule.
        fn derivative(&self, symbol: &Symbol) -> Self {
            let Quotient(n, d) = self;
            let top = n.derivative(symbol).times(d).minus(&n.times(&d.derivative(symbol)));
            Quotient(top, d.times(d))
        }

        fn at(&self, x: &Rational, y: &Rational) -> Rational {
            let value = |s: &Symbol| Some(if s.base() == "x" { x.clone() } else { y.clone() });
            let [n, d] = [&self.0, &self.1].map(|p| p.value(&value).as_constant().unwrap());
            n / d
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn derivatives_agree_with_the_quotient_rule(homogeneous in patch::tests::any_patch(3),
                                                     u in (-5i64..6, 1i64..3), v in -3i64..4) {
            let (u, v) = (q(u.0, u.1), z(v));
            let patch = RationalPatch::from_homogeneous(homogeneous).unwrap();
            let Ok(grid) = patch.derivatives(&u, &v, 2) else {
                prop_assert_eq!(patch.value(&u, &v), Err(CurveError::ZeroDenominator));
                return Ok(());
            };
            prop_assert_eq!(&grid[0][0], &patch.value(&u, &v).unwrap().position());
            // the first coordinate as a quotient of polynomials in x and y
            let symbols = ["x", "y"].map(Symbol::new);
            let polynomial = |k: usize| {
                let mut total = MultiPoly::zero();
                for (i, row) in patch.homogeneous.polar_forms()[k].coefficients().iter().enumerate() {
                    for (j, c) in row.iter().enumerate() {
                        let [x, y] = symbols.clone().map(MultiPoly::symbol);
                        total += (x.powered(i as u32) * y.powered(j as u32)).scaled(c);
                    }
                }
                total
            };
            let mut along_u = Quotient(polynomial(0), polynomial(2));
            for row in &grid {
                let mut both = along_u.clone();
                for point in row {
                    prop_assert_eq!(&both.at(&u, &v), &point[0]);
                    both = both.derivative(&symbols[1]);
                }
                along_u = along_u.derivative(&symbols[0]);
            }
        }

        #[test]
        fn tangent_planes_touch(homogeneous in patch::tests::any_patch(4), u in (-5i64..6, 1i64..3), v in -3i64..4) {
            let (u, v) = (q(u.0, u.1), z(v));
            let patch = RationalPatch::from_homogeneous(homogeneous).unwrap();
            let planes = patch.tangent_planes().unwrap();
            let plane = planes.value(&u, &v);
            let vector = patch.homogeneous.value(&u, &v);
            let dot = |a: &[Rational], b: &[Rational]| -> Rational { a.iter().zip(b).map(|(x, y)| x * y).sum() };
            prop_assert_eq!(dot(&plane, &vector), z(0));
            if let Ok(normal) = patch.normal_at(&u, &v) {
                let weight = num_traits::pow(vector[3].clone(), 3);
                prop_assert_eq!(&*(normal * &weight), &plane[..3]);
            }
            let (m, n) = patch.homogeneous().degrees();
            if m > 0 && n > 0 {
                prop_assert_eq!(planes.degrees(), (3 * m - 1, 3 * n - 1));
            }
        }

        #[test]
        fn changes_keep_the_surface(homogeneous in patch::tests::any_patch(3), u in -5i64..6, v in -5i64..6) {
            let (u, v) = (z(u), q(v, 2));
            let patch = RationalPatch::from_homogeneous(homogeneous).unwrap();
            let value = patch.value(&u, &v);
            prop_assert_eq!(&Surface::elevate(&patch, 2).unwrap().value(&u, &v), &value);
            let unit = patch.part((Interval::unit(), Interval::unit())).unwrap();
            prop_assert_eq!(&unit.value(&u, &v), &value);
            if let Ok((left, right)) = patch.subdivide(Direction::U, &q(2, 5)) {
                prop_assert_eq!(&left.value(&u, &v), &value);
                prop_assert_eq!(&right.value(&u, &v), &value);
            }
        }

        #[test]
        fn triangles_agree_with_rectangles(homogeneous in triangle::tests::any_patch(4), x in (-5i64..6, 1i64..3), y in -3i64..4) {
            let p = vec![q(x.0, x.1), z(y)];
            let patch = RationalTriangle::from_homogeneous(homogeneous).unwrap();
            let tensor = patch.homogeneous.to_tensor(Interval::unit(), Interval::unit());
            let tensor = RationalPatch::from_homogeneous(tensor).unwrap();
            prop_assert_eq!(patch.value(&p), tensor.value(&p[0], &p[1]));
            prop_assert_eq!(patch.derivatives(&p, 2), tensor.derivatives(&p[0], &p[1], 2));
            prop_assert_eq!(patch.normal_at(&p), tensor.normal_at(&p[0], &p[1]));
            prop_assert_eq!(patch.elevate(2).unwrap().value(&p), patch.value(&p));
            prop_assert_eq!(patch.part(Triangle::unit()).unwrap().value(&p), patch.value(&p));
            let corners = patch.homogeneous.triangle().corners();
            let middle = crate::math::curve::lerp(&corners[0], &corners[1], &q(1, 2));
            let inner = crate::math::curve::lerp(&corners[2], &middle, &q(1, 2));
            for piece in patch.subdivide(&[inner[0].clone(), inner[1].clone()]).unwrap() {
                prop_assert_eq!(piece.value(&p), patch.value(&p));
            }
        }
    }

    #[test]
    fn weights_and_points_return() {
        let points: Vec<Point<Rational>> =
            indices(2).iter().map(|i| [z(i[0] as i64), z(i[1] as i64)].into()).collect();
        let weights: Vec<Rational> = (1..7).map(z).collect();
        let patch = RationalTriangle::new(points.clone(), weights.clone(), Triangle::unit()).unwrap();
        assert_eq!(patch.weights(), weights);
        assert_eq!(patch.points().into_iter().map(Option::unwrap).collect::<Vec<_>>(), points);
        assert_eq!(patch.dimension(), 2);
        let zero = RationalTriangle::new(points.clone(), vec![z(0); 6], Triangle::unit());
        assert_eq!(zero, Err(CurveError::ZeroWeight { index: 0 }));

        let net: Vec<Vec<Point<Rational>>> = points.chunks(3).map(<[_]>::to_vec).collect();
        let rows: Vec<Vec<Rational>> = weights.chunks(3).map(<[_]>::to_vec).collect();
        let unit = Interval::unit;
        let patch = RationalPatch::new(net.clone(), rows.clone(), unit(), unit()).unwrap();
        assert_eq!(patch.weights(), rows);
        assert_eq!(patch.points()[1][2], Some(points[5].clone()));
        let few = RationalPatch::new(net.clone(), rows[..1].to_vec(), unit(), unit());
        assert_eq!(few, Err(CurveError::WeightCount { weights: 3, points: 6 }));
        let mut zero = rows.clone();
        zero[1][2] = z(0);
        let zero = RationalPatch::new(net.clone(), zero, unit(), unit());
        assert_eq!(zero, Err(CurveError::ZeroWeight { index: 5 }));
        let short = RationalPatch::new(net, vec![rows[0].clone(), vec![]], unit(), unit());
        assert_eq!(short, Err(CurveError::WeightCount { weights: 0, points: 3 }));
        assert!(patch.normal_at(&z(0), &z(0)).is_err() && patch.tangent_planes().is_err());
        assert!((patch.value(&z(0), &z(0)).unwrap() - &points[0]).is_zero());
    }
}
