//! Curvature and torsion from the derivatives of a curve at one parameter.
//!
//! Definition: κ = |c' × c''|/|c'|³ and τ = det(c', c'', c''')/|c' × c''|²; in the plane κ has the sign of
//! det(c', c''). By Lagrange's identity |c' × c''|² = |c'|² |c''|² − (c' · c'')² in every dimension, so that
//! κ² is rational where the derivatives are; κ itself has a root in it.
//!
//! Reference: M. P. do Carmo, *Differential Geometry of Curves and Surfaces* (1976), section 1-5.

use super::CurveError;
use crate::math::ring::{Field, Ring};

fn dot<C: Ring>(u: &[C], v: &[C]) -> C {
    u.iter().zip(v).fold(C::zero(), |sum, (x, y)| sum.plus(&x.times(y)))
}

/// |u × v|² = |u|² |v|² − (u · v)², in any dimension.
fn squared_area<C: Ring>(u: &[C], v: &[C]) -> C {
    let mixed = dot(u, v);
    dot(u, u).times(&dot(v, v)).minus(&mixed.times(&mixed))
}

/// κ² from c' and c''.
///
/// # Errors
/// [`CurveError::Degenerate`] where c' is 0, [`CurveError::DimensionsOf`], also for curves with one coordinate.
///
/// ```
/// use polarform::curve::squared_curvature;
/// use polarform::number::{integer as z, rational as q};
/// // (t, t²) at 1/2
/// assert_eq!(squared_curvature(&[z(1), z(1)], &[z(0), z(2)])?, q(1, 2));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn squared_curvature<C: Field>(first: &[C], second: &[C]) -> Result<C, CurveError> {
    same_dimension(first, second)?;
    if first.len() < 2 {
        return Err(CurveError::DimensionsOf { left: first.len(), right: 2 });
    }
    let speed = dot(first, first);
    let cube = speed.times(&speed).times(&speed);
    let inverse = cube.inverse().ok_or(CurveError::Degenerate)?;
    Ok(squared_area(first, second).times(&inverse))
}

/// det(c', c'') in the plane, whose sign is that of the curvature: positive in a left turn.
///
/// # Errors
/// [`CurveError::DimensionsOf`] unless both have two coordinates.
///
/// ```
/// use polarform::curve::turn;
/// use polarform::number::integer as z;
/// assert_eq!(turn(&[z(1), z(1)], &[z(0), z(2)])?, z(2));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn turn<C: Ring>(first: &[C], second: &[C]) -> Result<C, CurveError> {
    match (first, second) {
        ([x, y], [u, v]) => Ok(x.times(v).minus(&y.times(u))),
        _ => Err(CurveError::DimensionsOf { left: first.len().max(second.len()), right: 2 }),
    }
}

/// τ from c', c'' and c''' of a curve in space.
///
/// # Errors
/// [`CurveError::Degenerate`] where c' × c'' is 0, [`CurveError::DimensionsOf`] unless all have three
/// coordinates.
///
/// ```
/// use polarform::curve::torsion;
/// use polarform::number::integer as z;
/// // (t, t², t³) at 0
/// assert_eq!(torsion(&[1, 0, 0].map(z), &[0, 2, 0].map(z), &[0, 0, 6].map(z))?, z(3));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn torsion<C: Field>(first: &[C], second: &[C], third: &[C]) -> Result<C, CurveError> {
    let ([x, y, z], [u, v, w], [p, q, r]) = (first, second, third) else {
        let odd = [first, second, third].iter().map(|vector| vector.len()).find(|&size| size != 3);
        return Err(CurveError::DimensionsOf { left: odd.unwrap_or(3), right: 3 });
    };
    let cross = [y.times(w).minus(&z.times(v)), z.times(u).minus(&x.times(w)), x.times(v).minus(&y.times(u))];
    let area = dot(&cross, &cross).inverse().ok_or(CurveError::Degenerate)?;
    Ok(dot(&cross, &[p.clone(), q.clone(), r.clone()]).times(&area))
}

fn same_dimension<C>(u: &[C], v: &[C]) -> Result<(), CurveError> {
    match (u.len(), v.len()) {
        (left, right) if left == right => Ok(()),
        (left, right) => Err(CurveError::DimensionsOf { left, right }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::{BezierCurve, Interval};
    use crate::math::number::{Rational, integer as z, rational as q};
    use num_traits::Zero;
    use proptest::prelude::*;

    fn points(dimension: usize) -> impl Strategy<Value = Vec<Vec<Rational>>> {
        let coordinate = (-9i64..9, 1i64..4).prop_map(|(p, r)| q(p, r));
        prop::collection::vec(prop::collection::vec(coordinate, dimension), 4..7)
    }

    fn derivatives(points: Vec<Vec<Rational>>, t: &Rational) -> Vec<Vec<Rational>> {
        let curve = BezierCurve::new(points, Interval::unit()).unwrap();
        (1..=3).map(|k| curve.nth_derivative(k).value(t).into()).collect()
    }

    proptest! {
        /// At its start κ = (n−1)/n · h/a², for the first edge a and the distance h of b_2 from its line.
        #[test]
        fn at_the_start_of_a_bezier_curve(b in points(3)) {
            let n = b.len() as i64 - 1;
            let d = derivatives(b.clone(), &z(0));
            let (a, c): (Vec<Rational>, Vec<Rational>) =
                (0..3).map(|k| (&b[1][k] - &b[0][k], &b[2][k] - &b[0][k])).unzip();
            let length = dot(&a, &a);
            if length.is_zero() {
                prop_assert_eq!(squared_curvature(&d[0], &d[1]), Err(CurveError::Degenerate));
            } else {
                let height = squared_area(&a, &c) / &length;
                let expected = q((n - 1) * (n - 1), n * n) * height / (&length * &length);
                prop_assert_eq!(squared_curvature(&d[0], &d[1]).unwrap(), expected);
            }
        }

        /// Neither depends on the parameter: at s with t = s², c' becomes 2s c' and so on.
        #[test]
        fn no_change_of_parameter_alters_them(b in points(3), k in 1i64..9) {
            let s = q(k, 9);
            let d = derivatives(b, &(&s * &s));
            let mix = |x: &Rational, y: &Rational| x * z(4) * &s * &s + y * z(2);
            let first: Vec<_> = d[0].iter().map(|x| x * z(2) * &s).collect();
            let second: Vec<_> = d[1].iter().zip(&d[0]).map(|(x, y)| mix(x, y)).collect();
            let third: Vec<_> =
                d[2].iter().zip(&d[1]).map(|(x, y)| x * z(8) * &s * &s * &s + y * z(12) * &s).collect();
            prop_assert_eq!(squared_curvature(&first, &second), squared_curvature(&d[0], &d[1]));
            prop_assert_eq!(torsion(&first, &second, &third), torsion(&d[0], &d[1], &d[2]));
        }

        #[test]
        fn in_the_plane_the_turn_is_its_root(b in points(2), k in 0i64..9) {
            let d = derivatives(b, &q(k, 9));
            let turned = turn(&d[0], &d[1]).unwrap();
            prop_assert_eq!(&turned * &turned, squared_area(&d[0], &d[1]));
        }
    }

    #[test]
    fn what_has_none() {
        let zero = [z(0), z(0)];
        assert_eq!(squared_curvature(&zero, &[z(1), z(2)]), Err(CurveError::Degenerate));
        assert_eq!(squared_curvature(&[z(1), z(1)], &zero), Ok(z(0)));
        assert_eq!(squared_curvature(&zero, &[z(1)]), Err(CurveError::DimensionsOf { left: 2, right: 1 }));
        assert_eq!(squared_curvature(&[z(1)], &[z(1)]), Err(CurveError::DimensionsOf { left: 1, right: 2 }));
        assert_eq!(turn(&[z(1)], &[z(1)]), Err(CurveError::DimensionsOf { left: 1, right: 2 }));
        let line = [z(1), z(2), z(3)];
        assert_eq!(torsion(&line, &line, &line), Err(CurveError::Degenerate));
        assert_eq!(torsion(&line, &zero, &line), Err(CurveError::DimensionsOf { left: 2, right: 3 }));
    }
}
