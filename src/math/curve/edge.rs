//! How smoothly two patches join along a common edge, as equations.
//!
//! Definition: two patches with polar forms f and g that share an edge of their domains join C^k
//! along it iff all derivatives up to order k agree there. In polar values:
//!
//! tensor product, the edge u = b:  f(b^{m−r}, e^r; c^{n−s}, d^s) = g(b^{m−r}, e^r; c^{n−s}, d^s),
//! triangles, the edge from p to q:  f(p^i, q^j, d^r) = g(p^i, q^j, d^r),
//!
//! for all r ≤ k, where e is the far end, or d the far corner, of the second domain. The right
//! sides are control points of the second patch; the left sides are what the first one asks for.
//!
//! References: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989), section 12; G. Farin,
//! *Curves and Surfaces for CAGD*, 5th ed. (2002), sections 14.5 and 17.5.

use super::domain::Triangle;
use super::patch::{Direction, TensorPatch};
use super::polygon;
use super::triangle::{TrianglePatch, indices};
use super::{CurveError, Point};
use crate::math::blossom::Argument;
use crate::math::ring::Field;

/// One condition: a control point of the second patch must be a polar value of the first.
#[derive(Clone, PartialEq)]
pub struct EdgeEquation<C> {
    /// r, how many arguments lie off the edge: the condition belongs to C^r.
    pub order: usize,
    /// s or j, how often the second end of the edge is an argument.
    pub place: usize,
    /// What the first patch asks for.
    pub required: Point<C>,
    /// The control point of the second patch.
    pub found: Point<C>,
}

debug_by_fields!(EdgeEquation: order, place, required, found);

impl<C: PartialEq> EdgeEquation<C> {
    /// Whether the two sides are equal.
    pub fn holds(&self) -> bool {
        self.required == self.found
    }
}

fn same_dimension(left: usize, right: usize) -> Result<(), CurveError> {
    if left == right { Ok(()) } else { Err(CurveError::DimensionsOf { left, right }) }
}

fn same_degree(left: usize, right: usize) -> Result<(), CurveError> {
    if left == right { Ok(()) } else { Err(CurveError::Degrees { left, right }) }
}

impl<C: Field> TensorPatch<C> {
    /// The conditions for `next` to join this patch C^k where its interval of u (or v) starts
    /// and this one's ends. By ascending order; orders above the degree add none.
    ///
    /// # Errors
    /// [`CurveError::NoCommonEdge`] unless the interval of u ends where the other starts and those
    /// of v are equal (or the other way round); [`CurveError::Degrees`],
    /// [`CurveError::DimensionsOf`].
    ///
    /// ```
    /// use polarform::curve::{CurveError, Direction, Interval, TensorPatch};
    /// use polarform::number::integer as z;
    /// let line = |heights: [i64; 2]| heights.map(|h| vec![vec![z(h)]]).to_vec();
    /// let first = TensorPatch::new(line([0, 1]), Interval::unit(), Interval::unit())?;
    /// let second = TensorPatch::new(line([1, 3]), Interval::new(z(1), z(2))?, Interval::unit())?;
    /// let equations = first.join_conditions(&second, Direction::U, 1)?;
    /// assert_eq!((equations[1].required[0].clone(), equations[1].found[0].clone()), (z(2), z(3)));
    /// assert!(equations[0].holds() && !equations[1].holds());
    /// # Ok::<(), CurveError>(())
    /// ```
    pub fn join_conditions(
        &self,
        next: &Self,
        direction: Direction,
        k: usize,
    ) -> Result<Vec<EdgeEquation<C>>, CurveError> {
        if direction == Direction::V {
            return self.transposed().join_conditions(&next.transposed(), Direction::U, k);
        }
        same_dimension(self.dimension(), next.dimension())?;
        let ((m, n), (other_m, other_n)) = (self.degrees(), next.degrees());
        same_degree(m, other_m)?;
        same_degree(n, other_n)?;
        if self.u().end() != next.u().start() || self.v() != next.v() {
            return Err(CurveError::NoCommonEdge);
        }
        let end = self.u().point_coordinates(self.u().end());
        let far = self.u().point_coordinates(next.u().end());
        let mut equations = Vec::new();
        for order in 0..=k.min(m) {
            let mut arguments = vec![end.clone(); m - order];
            arguments.resize(m, far.clone());
            for place in 0..=n {
                let column: Vec<Point<C>> = self.net().iter().map(|row| row[place].clone()).collect();
                let required = polygon::blossom(&column, &arguments);
                equations.push(EdgeEquation {
                    order,
                    place,
                    required,
                    found: next.net()[order][place].clone(),
                });
            }
        }
        Ok(equations)
    }
}

/// The corners of two triangles ordered so that the first two are common: their places in the
/// first and in the second triangle.
fn common_edge<C: Field>(left: &Triangle<C>, right: &Triangle<C>) -> Option<([usize; 3], [usize; 3])> {
    let place = |corner: &Point<C>| right.corners().iter().position(|other| other == corner);
    let places: Vec<Option<usize>> = left.corners().iter().map(place).collect();
    let common: Vec<(usize, usize)> =
        places.iter().enumerate().filter_map(|(i, place)| Some((i, (*place)?))).collect();
    let [(i, p), (j, q)] = common[..] else { return None };
    Some(([i, j, 3 - i - j], [p, q, 3 - p - q]))
}

impl<C: Field> TrianglePatch<C> {
    /// The conditions for `next` to join this patch C^k along the edge that their triangles
    /// share: f(p^i, q^j, d^r) = g(p^i, q^j, d^r) for r ≤ k, with p before q among the corners of
    /// this triangle and d the far corner of the other. By ascending order r, then by j; orders
    /// above the degree add none.
    ///
    /// # Errors
    /// [`CurveError::NoCommonEdge`] unless exactly two corners are common; [`CurveError::Degrees`],
    /// [`CurveError::DimensionsOf`].
    pub fn join_conditions(&self, next: &Self, k: usize) -> Result<Vec<EdgeEquation<C>>, CurveError> {
        same_dimension(self.dimension(), next.dimension())?;
        same_degree(self.degree(), next.degree())?;
        let (_, order) = common_edge(self.triangle(), next.triangle()).ok_or(CurveError::NoCommonEdge)?;
        let second = next.permuted(order).ok_or(CurveError::NoCommonEdge)?;
        let frame = second.triangle().corners().clone().map(|corner| Argument::Point(corner.into()));
        let required = self.polar_values(&frame)?;
        let sides = required.into_iter().zip(second.points());
        let mut equations: Vec<EdgeEquation<C>> = indices(self.degree())
            .into_iter()
            .zip(sides)
            .filter(|([.., r], _)| *r <= k)
            .map(|([_, j, r], (required, found))| EdgeEquation {
                order: r,
                place: j,
                required,
                found: found.clone(),
            })
            .collect();
        equations.sort_by_key(|equation| (equation.order, equation.place));
        Ok(equations)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::{Interval, Vector, patch, triangle};
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use proptest::prelude::*;

    /// Up to which order the derivatives in u agree on the edge, an independent way.
    fn by_derivatives(
        first: &TensorPatch<Rational>,
        second: &TensorPatch<Rational>,
        k: usize,
    ) -> Option<usize> {
        let u = first.u().end();
        let agree = |r: usize| {
            (0..=first.degrees().1 as i64)
                .all(|v| first.derivative_at(r, 0, u, &z(v)) == second.derivative_at(r, 0, u, &z(v)))
        };
        (0..=k).take_while(|&r| agree(r)).last()
    }

    /// Up to which order, at most k, all conditions hold.
    fn order(equations: &[EdgeEquation<Rational>], k: usize) -> Option<usize> {
        match equations.iter().find(|equation| !equation.holds()) {
            Some(equation) => equation.order.checked_sub(1),
            None => Some(k),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn tensor_patches(patch in patch::tests::any_patch(2), moved in 0usize..5, k in 0usize..5) {
            let next = Interval::new(patch.u().end().clone(), z(9)).unwrap();
            let second = patch.part(next.clone(), patch.v().clone());
            let equations = patch.join_conditions(&second, Direction::U, k).unwrap();
            prop_assert!(equations.iter().all(EdgeEquation::holds));
            // moving the points of row `moved` spoils that order and leaves the lower ones
            let mut net = second.net().to_vec();
            if let Some(row) = net.get_mut(moved) {
                row.iter_mut().for_each(|point| point[1] += z(1));
            }
            let spoiled = TensorPatch::new(net, next, patch.v().clone()).unwrap();
            let found = order(&patch.join_conditions(&spoiled, Direction::U, k).unwrap(), k);
            prop_assert_eq!(found, by_derivatives(&patch, &spoiled, k));
            if moved <= k.min(patch.degrees().0) {
                prop_assert_eq!(found, moved.checked_sub(1));
            }
            let turned = patch.transposed().join_conditions(&spoiled.transposed(), Direction::V, k).unwrap();
            prop_assert_eq!(order(&turned, k), found);
        }

        #[test]
        fn triangles(patch in triangle::tests::any_patch(2), far in (1i64..5, 1i64..5), moved in 0usize..4) {
            let corners = patch.triangle().corners().clone();
            // a corner beyond the edge from b to c, named in another order
            let [s, t] = [far.0, far.1].map(z);
            let weights = [-&s, t.clone(), z(1) + &s - &t];
            let d = patch.triangle().point(&weights);
            let other = Triangle::new([corners[2].clone(), d, corners[1].clone()]).unwrap();
            let second = patch.part(other.clone());
            prop_assert_eq!(order(&patch.join_conditions(&second, 3).unwrap(), 3), Some(3));
            let mut points = second.points().to_vec();
            for ([_, j, _], point) in indices(patch.degree()).into_iter().zip(&mut points) {
                if j == moved {
                    point[0] += z(1);
                }
            }
            let spoiled = TrianglePatch::new(points, other).unwrap();
            let found = order(&patch.join_conditions(&spoiled, 3).unwrap(), 3);
            let expected = if moved <= patch.degree() { moved.checked_sub(1) } else { Some(3) };
            prop_assert_eq!(found, expected);
            // by derivatives across the edge, at points of it
            let across = Vector::from([z(1), z(2)]);
            for r in 0..expected.map_or(0, |order| order + 1) {
                let directions = vec![across.clone(); r];
                let at = crate::math::curve::lerp(&corners[1], &corners[2], &q(1, 3));
                prop_assert_eq!(patch.derivative(&directions).unwrap().value(&at),
                                spoiled.derivative(&directions).unwrap().value(&at));
            }
        }
    }

    #[test]
    fn the_first_order_in_symbols() {
        let name = |s: &str| Fraction::from(MultiPoly::symbol(Symbol::new(s)));
        let net = |letter: &str| {
            (0..3).map(|i| (0..3).map(|j| vec![name(&format!("{letter}{i}{j}"))]).collect()).collect()
        };
        let (a, b, e) = (name("a"), name("b"), name("e"));
        let unit = Interval::unit;
        let first = TensorPatch::new(net("p"), Interval::new(a.clone(), b.clone()).unwrap(), unit()).unwrap();
        let second =
            TensorPatch::new(net("q"), Interval::new(b.clone(), e.clone()).unwrap(), unit()).unwrap();
        let equations = first.join_conditions(&second, Direction::U, 1).unwrap();
        assert_eq!(equations.len(), 6);
        assert_eq!(equations[1].required, [name("p21")]);
        assert_eq!(equations[1].found, [name("q01")]);
        // q_11 = p_21 + (e − b)/(b − a) (p_21 − p_11)
        let ratio = (e - b.clone()) / (b - a);
        let expected = name("p21") + ratio * (name("p21") - name("p11"));
        assert_eq!(equations[4].required, [expected]);
        assert_eq!(equations[4].found, [name("q11")]);
    }

    #[test]
    fn what_cannot_join() {
        let flat = |m: usize, u: Interval<Rational>| {
            TensorPatch::new(vec![vec![vec![z(0)]]; m + 1], u, Interval::unit()).unwrap()
        };
        let next = || Interval::new(z(1), z(2)).unwrap();
        let first = flat(1, Interval::unit());
        let join = |second| first.join_conditions(&second, Direction::U, 0).unwrap_err();
        assert_eq!(join(flat(1, Interval::unit())), CurveError::NoCommonEdge);
        assert_eq!(join(flat(2, next())), CurveError::Degrees { left: 1, right: 2 });
        let patch = |n: usize, triangle| {
            TrianglePatch::new(vec![vec![z(0)]; (n + 1) * (n + 2) / 2], triangle).unwrap()
        };
        let first = patch(1, Triangle::unit());
        assert_eq!(first.join_conditions(&first, 0), Err(CurveError::NoCommonEdge));
        let degrees = CurveError::Degrees { left: 1, right: 0 };
        assert_eq!(first.join_conditions(&patch(0, Triangle::unit()), 0), Err(degrees));
    }
}
