//! Functionals that give the control points of splines.

use crate::budget;
use crate::math::curve::Point;
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;
use crate::math::spline::{BSpline, KnotVector, SplineError};

/// The weights of F(τ), F'(τ), …, F^(n)(τ) in the functional of de Boor and Fix for the control point with
/// the label u_1, …, u_n: (n−r)!/n! e_r(u_1 − τ, …, u_n − τ), by elementary symmetric functions.
///
/// λ F = Σ_r (−1)^(n−r) ψ^(n−r)(τ) F^(r)(τ) with ψ(y) = (u_1 − y)…(u_n − y)/n! is the same. For a polynomial
/// of degree at most n it is f(u_1, …, u_n) whatever τ is; for a spline it is the control point d_i for
/// every τ within the support of N_i. Cost: n² products.
///
/// Reference: C. de Boor, G. J. Fix, "Spline approximation by quasiinterpolants", J. Approx. Theory 8 (1973).
///
/// ```
/// use polarform::approximation::de_boor_fix;
/// use polarform::number::{integer as z, rational as q};
/// // f(1, 3) = F(0) + (1 + 3)/2 F'(0) + 3/2 F''(0)
/// assert_eq!(de_boor_fix(&[z(1), z(3)], &z(0)), [q(1, 1), q(2, 1), q(3, 2)]);
/// ```
pub fn de_boor_fix<C: Field>(label: &[C], tau: &C) -> Vec<C> {
    let n = label.len();
    budget::charge_terms(n as u64);
    let mut symmetric = vec![C::zero(); n + 1];
    symmetric[0] = C::one();
    for (count, knot) in label.iter().enumerate() {
        let distance = knot.minus(tau);
        for r in (0..=count).rev() {
            budget::step();
            let more = symmetric[r].times(&distance);
            symmetric[r + 1] += more;
        }
    }
    let mut share = Rational::from_integer(Int::ONE);
    let mut weights = Vec::with_capacity(n + 1);
    for (r, e) in symmetric.into_iter().enumerate() {
        weights.push(e.scaled(&share));
        if r < n {
            share /= Int::from(n - r);
        }
    }
    weights
}

/// Schoenberg's variation diminishing spline: control points F(ξ_i) over the Greville abscissae. It is F if F
/// has degree 1 at most.
///
/// # Errors
/// Those of F; inside, those of [`BSpline::new`].
///
/// ```
/// use polarform::approximation::schoenberg;
/// use polarform::interval::Interval;
/// use polarform::number::{Rational, integer as z};
/// use polarform::spline::{KnotVector, SplineError};
/// let knots = KnotVector::clamped(2, &[z(2)], &Interval::new(z(0), z(4))?)?;
/// let s = schoenberg(knots, |x: &Rational| Ok::<_, SplineError>([x * x].into()))??;
/// assert_eq!(s.points(), [[z(0)], [z(1)], [z(9)], [z(16)]]);
/// # Ok::<(), SplineError>(())
/// ```
pub fn schoenberg<C: Field, E>(
    knots: KnotVector<C>,
    function: impl Fn(&C) -> Result<Point<C>, E>,
) -> Result<Result<BSpline<C>, SplineError>, E> {
    let points = (0..knots.count()).map(|i| function(&knots.greville(i)));
    let points = points.collect::<Result<Vec<_>, E>>()?;
    Ok(BSpline::new(knots, points))
}
