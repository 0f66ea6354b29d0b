//! Functionals that give the control points of splines.

use crate::budget;
use crate::math::blossom::PolarForm;
use crate::math::curve::Point;
use crate::math::number::{Int, Rational};
use crate::math::poly::Coefficients;
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

/// The quasi-interpolant of local interpolants: d_i = p(t_{i+1}, …, t_{i+n}), the blossom of the polynomial p of degree n that agrees with F at
/// n + 1 equally spaced points of a knot interval in the middle of the support of N_i. It is F if F is a spline over these knots, so for all
/// polynomials of degree n.
///
/// T. Lyche, L. L. Schumaker, "Local spline approximation methods", J. Approx. Theory 15 (1975).
///
/// Cost: n + 1 values of F and n³ steps for each control point.
///
/// # Errors
/// Those of F; inside, those of [`BSpline::new`].
///
/// ```
/// use polarform::approximation::quasi_interpolant;
/// use polarform::interval::Interval;
/// use polarform::number::{Rational, integer as z};
/// use polarform::spline::{KnotVector, SplineError};
/// let knots = KnotVector::clamped(2, &[z(2)], &Interval::new(z(0), z(4))?)?;
/// let s = quasi_interpolant(knots, |x: &Rational| Ok::<_, SplineError>([x * x].into()))??;
/// assert_eq!(s.points(), [[z(0)], [z(0)], [z(8)], [z(16)]]);
/// # Ok::<(), SplineError>(())
/// ```
pub fn quasi_interpolant<C: Field, E>(
    knots: KnotVector<C>,
    function: impl Fn(&C) -> Result<Point<C>, E>,
) -> Result<Result<BSpline<C>, SplineError>, E> {
    let n = knots.degree();
    let spans = knots.spans();
    budget::charge_terms((knots.count() as u64).saturating_mul((n as u64 + 1).saturating_pow(2)));
    let mut points = Vec::with_capacity(knots.count());
    for i in 0..knots.count() {
        // The interval nearest to the middle of t_i, …, t_{i+n+1}; a support that does not meet the domain has any.
        let apart = |j: &&usize| (!(i..=i + n).contains(*j), (2 * **j).abs_diff(2 * i + n));
        let Some(&j) = spans.iter().min_by_key(apart) else {
            return Ok(Err(SplineError::OutsideDomain));
        };
        let (a, b) = (&knots.knots()[j], &knots.knots()[j + 1]);
        let share = |k: usize| match n {
            0 => Rational::new(Int::ONE, 2.into()),
            _ => Rational::new(Int::from(k), Int::from(n)),
        };
        let nodes: Vec<C> = (0..=n).map(|k| a.plus(&b.minus(a).scaled(&share(k)))).collect();
        let mut sum: Option<Point<C>> = None;
        for (k, x) in nodes.iter().enumerate() {
            budget::steps(1 + (n * n) as u32);
            let others: Vec<C> =
                nodes.iter().enumerate().filter(|(m, _)| *m != k).map(|(_, y)| y.clone()).collect();
            let basis = Coefficients::from_roots(&others);
            let form = PolarForm::with_degree(basis.to_vec(), n).expect("the degree is n");
            let above = form.value(knots.label(i)).expect("a label has n knots");
            let below = others.iter().fold(C::one(), |product, y| product.times(&x.minus(y)));
            let Some(weight) = below.inverse().map(|inverse| above.times(&inverse)) else {
                return Ok(Err(SplineError::OutsideDomain));
            };
            let value: Point<C> = function(x)?.iter().map(|c| c.times(&weight)).collect();
            sum = Some(match sum {
                None => value,
                Some(sum) => &sum + &value.position(),
            });
        }
        points.extend(sum);
    }
    Ok(BSpline::new(knots, points))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, rational as q};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Splines over the knots, clamped or not, are found again, whatever their knots.
        #[test]
        fn it_is_a_projection(n in 1_usize..4, steps in prop::collection::vec(0i64..3, 12), list in prop::collection::vec(-9i64..10, 12)) {
            let mut knots = vec![z(0)];
            for step in &steps {
                let last = knots[knots.len() - 1].clone();
                knots.push(last + z(*step));
            }
            let Ok(knots) = KnotVector::new(n, knots) else { return Ok(()) };
            // At an inner knot of multiplicity n + 1 a spline has two values.
            prop_assume!(knots.multiplicities().iter().all(|(_, m)| *m <= n));
            let points: Vec<Vec<Rational>> = list[..knots.count()].iter().map(|&x| vec![z(x)]).collect();
            let Ok(s) = BSpline::new(knots.clone(), points) else { return Ok(()) };
            let found = quasi_interpolant(knots, |x: &Rational| s.value(x)).unwrap().unwrap();
            for (k, (p, q)) in found.points().iter().zip(s.points()).enumerate() {
                let (knots, (a, b)) = (s.knots().support(k), s.interval().ends());
                let meets = knots.windows(2).any(|pair| pair[0] < pair[1] && pair[0] < *b && pair[1] > *a);
                prop_assert!(!meets || p == q, "{k}");
            }
        }
    }

    #[test]
    fn of_degree_0_it_takes_values_in_the_middle() {
        let knots = KnotVector::new(0, [0, 1, 3].map(z).to_vec()).unwrap();
        let s = quasi_interpolant(knots, |x: &Rational| Ok::<_, SplineError>([x.clone()].into()))
            .unwrap()
            .unwrap();
        assert_eq!(s.points(), [[q(1, 2)], [z(2)]]);
    }
}
