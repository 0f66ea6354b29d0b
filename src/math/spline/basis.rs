//! B-spline basis functions as piecewise polynomials, in two ways.
//!
//! N_i^0 is 1 on [t_i, t_{i+1}) and
//! N_i^k(t) = (t − t_i)/(t_{i+k} − t_i) N_i^{k−1}(t) + (t_{i+k+1} − t)/(t_{i+k+1} − t_{i+1}) N_{i+1}^{k−1}(t),
//! a quotient with denominator 0 counting as 0 (Cox, de Boor). By the blossom, the piece on
//! [t_j, t_{j+1}] is the polynomial whose polar form is 1 at the label of N_i and 0 at the other
//! labels of that interval.

use super::{KnotVector, SplineError};
use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::Rational;
use crate::math::piecewise::{Outside, Piecewise};
use crate::math::poly::Coefficients;
use crate::math::ring::Field;

/// The polynomials on each knot interval of the support, beginning with [t_i, t_{i+1}].
type Local<C> = Vec<Coefficients<C>>;

impl<C: Field> KnotVector<C> {
    /// N_i^n as a piecewise polynomial, by the recurrence of Cox and de Boor.
    ///
    /// Where it jumps, at a knot of multiplicity n + 1, it is what it is to the right, but at the end of the domain what it is to the
    /// left, also if further knots follow: so Σ d_i N_i is the spline on the whole domain. Without a domain the last knot is taken as its end.
    ///
    /// Cost: n³/6 products of a polynomial by a linear one.
    ///
    /// # Errors
    /// [`SplineError::NoSuchFunction`].
    ///
    /// ```
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::KnotVector;
    /// let knots = KnotVector::new(2, [0, 1, 2, 3].map(z).to_vec())?;
    /// let n = knots.basis_function(0)?;
    /// assert_eq!(*n.pieces()[1], [q(-3, 2), z(3), z(-1)]); // −t² + 3t − 3/2 on [1, 2]
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn basis_function(&self, i: usize) -> Result<Piecewise<C>, SplineError> {
        self.check_index(i)?;
        let n = self.degree();
        let window = &self.knots()[i..=i + n + 1];
        let table = recurrence(window, n);
        Ok(assembled(window, &table[0], self.last_end()))
    }

    /// All basis functions N_0^n, …, N_{m−1}^n, sharing the lower degrees.
    ///
    /// Cost: m n²/2 products of a polynomial by a linear one.
    pub fn basis_functions(&self) -> Vec<Piecewise<C>> {
        let n = self.degree();
        let size = (self.count() as u64).saturating_mul((n as u64 + 1).saturating_pow(2));
        budget::charge_terms(size);
        let table = recurrence(self.knots(), n);
        table
            .iter()
            .enumerate()
            .map(|(i, local)| assembled(self.support(i), local, self.last_end()))
            .collect()
    }

    /// j and the values N_{j−n}(t), …, N_j(t) of the functions that are not 0 on the knot interval
    /// [t_j, t_{j+1}] of t; the end of the domain belongs to the last one.
    ///
    /// Cost: n² products and quotients (the recurrence of Cox and de Boor, each value once).
    ///
    /// # Errors
    /// As [`KnotVector::span_of`].
    ///
    /// ```
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::KnotVector;
    /// let knots = KnotVector::uniform(2, 3, &z(0), &z(1))?;
    /// assert_eq!(knots.values_at(&q(5, 2))?, (2, vec![q(1, 8), q(3, 4), q(1, 8)]));
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn values_at(&self, t: &C) -> Result<(usize, Vec<C>), SplineError> {
        let span = self.span_of(t)?;
        let knots = self.knots();
        let mut values = vec![C::one()];
        for k in 1..=self.degree() {
            let mut saved = C::zero();
            for (r, value) in values.iter_mut().enumerate() {
                budget::step();
                let (start, end) = (&knots[span + 1 + r - k], &knots[span + 1 + r]);
                let unit = end.minus(start).inverse().expect("the interval contains the span");
                let share = value.times(&unit);
                *value = saved.plus(&end.minus(t).times(&share));
                saved = t.minus(start).times(&share);
            }
            values.push(saved);
        }
        Ok((span, values))
    }

    /// Where functions are what they are to the left.
    fn last_end(&self) -> &C {
        self.interval().map_or_else(|_| &self.knots()[self.knots().len() - 1], Interval::end)
    }

    fn check_index(&self, index: usize) -> Result<(), SplineError> {
        let count = self.count();
        if index < count { Ok(()) } else { Err(SplineError::NoSuchFunction { index, count }) }
    }
}

/// All functions of degree n over these knots; over integers if they are numbers.
fn recurrence<C: Field>(knots: &[C], n: usize) -> Vec<Local<C>> {
    let numbers: Option<Vec<Rational>> = knots.iter().map(C::as_rational).collect();
    if let Some(numbers) = numbers {
        let lifted = |piece: &Vec<Rational>| piece.iter().map(C::from_rational).collect();
        let table = super::integers::recurrence(&numbers, n);
        return table.iter().map(|local| local.iter().map(lifted).collect()).collect();
    }
    recurrence_in(knots, n)
}

/// The same over any field.
fn recurrence_in<C: Field>(knots: &[C], n: usize) -> Vec<Local<C>> {
    let mut level: Vec<Local<C>> = knots
        .windows(2)
        .map(|pair| vec![Coefficients::constant(if pair[0] == pair[1] { C::zero() } else { C::one() })])
        .collect();
    for k in 1..=n {
        let share = |i: usize| knots[i + k].minus(&knots[i]).inverse();
        let shares: Vec<Option<C>> = (0..knots.len() - k).map(share).collect();
        level = (0..level.len() - 1)
            .map(|i| {
                budget::step();
                let mut local: Local<C> = vec![Coefficients::zero(); k + 1];
                if let Some(s) = &shares[i] {
                    let rise = Coefficients::new(vec![-knots[i].times(s), s.clone()]);
                    for (piece, lower) in local.iter_mut().zip(&level[i]) {
                        *piece = lower.times(&rise);
                    }
                }
                if let Some(s) = &shares[i + 1] {
                    let fall = Coefficients::new(vec![knots[i + k + 1].times(s), -s.clone()]);
                    for (piece, lower) in local[1..].iter_mut().zip(&level[i + 1]) {
                        *piece = piece.plus(&lower.times(&fall));
                    }
                }
                local
            })
            .collect();
    }
    level
}

/// A function from its pieces, empty intervals left out, that is at `end` what it is to the left.
fn assembled<C: Field>(window: &[C], local: &Local<C>, end: &C) -> Piecewise<C> {
    let (mut breaks, mut pieces) = (vec![window[0].clone()], Vec::new());
    for (pair, piece) in window.windows(2).zip(local) {
        if pair[0] != pair[1] {
            breaks.push(pair[1].clone());
            pieces.push(piece.clone());
        }
    }
    let function = Piecewise::new(breaks, pieces, Outside::Zero)
        .expect("a knot has at most multiplicity n + 1, so n + 2 of them are not all equal");
    function.left_at(end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational as q;

    #[test]
    fn values_are_those_of_the_pieces() {
        let knots = [q(-1, 3), q(0, 1), q(0, 1), q(1, 2), q(5, 7), q(5, 7), q(5, 7), q(3, 1), q(10, 3)];
        for n in 0..5 {
            let Ok(knots) = KnotVector::new(n, knots.to_vec()) else { continue };
            let Ok((a, b)) = knots.interval().map(Interval::ends) else { continue };
            for k in 0..=12 {
                let t = a + (b - a) * q(k, 12);
                let (span, values) = knots.values_at(&t).unwrap();
                for i in 0..knots.count() {
                    let expected = knots.basis_function(i).unwrap().value(&t).unwrap();
                    let place = (i + n).checked_sub(span).filter(|place| *place <= n);
                    let found = place.map_or_else(|| q(0, 1), |place| values[place].clone());
                    assert_eq!(found, expected, "degree {n}, N_{i} at {t}");
                }
            }
        }
    }

    proptest::proptest! {
        /// Functions, their values and splines against the recurrence at one parameter, for knots of any multiplicities, with N_i^0 = 1 on
        /// [t_i, t_{i+1}), but on (t_i, t_{i+1}] where the parameter is the end of the domain.
        #[test]
        fn everything_agrees_with_the_recurrence_at_a_number(
            n in 0usize..4, runs in proptest::collection::vec(1usize..5, 2..7), place in 0i64..30, points in proptest::collection::vec(-5i64..6, 24),
        ) {
            let knots: Vec<Rational> =
                runs.iter().zip(0..).flat_map(|(&m, k)| std::iter::repeat_n(q(k * (k + 3), 2), m.min(n + 1))).collect();
            let Ok(knots) = KnotVector::new(n, knots) else { return Ok(()) };
            let Ok((a, b)) = knots.interval().map(Interval::ends) else { return Ok(()) };
            let t = q(place, 2).max(a.clone()).min(b.clone());
            let list = knots.knots();
            fn value(list: &[Rational], i: usize, k: usize, t: &Rational, at_end: bool) -> Rational {
                let inside = if at_end { list[i] < *t && *t <= list[i + 1] } else { list[i] <= *t && *t < list[i + 1] };
                if k == 0 {
                    return q(i64::from(inside), 1);
                }
                let quotient = |p: Rational, r: Rational| if r == q(0, 1) { r } else { p / r };
                quotient(t - &list[i], &list[i + k] - &list[i]) * value(list, i, k - 1, t, at_end)
                    + quotient(&list[i + k + 1] - t, &list[i + k + 1] - &list[i + 1]) * value(list, i + 1, k - 1, t, at_end)
            }
            let expected: Vec<Rational> = (0..knots.count()).map(|i| value(list, i, n, &t, t == *b)).collect();
            let (span, values) = knots.values_at(&t).unwrap();
            let functions = knots.basis_functions();
            for (i, expected) in expected.iter().enumerate() {
                proptest::prop_assert_eq!(&functions[i].value(&t).unwrap(), expected);
                proptest::prop_assert_eq!(&knots.basis_function(i).unwrap().value(&t).unwrap(), expected);
                let place = (i + n).checked_sub(span).filter(|place| *place <= n);
                proptest::prop_assert_eq!(&place.map_or_else(|| q(0, 1), |place| values[place].clone()), expected);
            }
            let points: Vec<Rational> = points[..knots.count()].iter().map(|&x| q(x, 1)).collect();
            let sum = points.iter().zip(&expected).fold(q(0, 1), |sum, (d, x)| sum + d * x);
            let as_functions = points.iter().zip(&functions).map(|(d, f)| f.map(|piece| piece.scaled(d)));
            let added = as_functions.reduce(|f, g| f.sum(&g).unwrap()).unwrap();
            proptest::prop_assert_eq!(&added.value(&t).unwrap(), &sum);
            let spline = super::super::bspline::BSpline::new(knots.clone(), points.iter().map(|d| vec![d.clone()]).collect()).unwrap();
            proptest::prop_assert_eq!(&spline.value(&t).unwrap()[0], &sum);
        }
    }

    /// The recurrence over integers against the one over the field.
    #[test]
    fn integers_and_fractions_agree() {
        let knots = [q(-1, 3), q(0, 1), q(0, 1), q(1, 2), q(5, 7), q(5, 7), q(5, 7), q(3, 1), q(10, 3)];
        for n in 0..6 {
            let (fast, plain) = (recurrence(&knots, n), recurrence_in(&knots, n));
            for (fast, plain) in fast.iter().flatten().zip(plain.iter().flatten()) {
                assert_eq!(fast, plain);
            }
        }
    }
}

#[cfg(test)]
mod by_blossom {
    use super::super::bspline::BSpline;
    use super::*;
    use crate::math::blossom::PolarForm;

    impl<C: Field> KnotVector<C> {
        /// N_i^n by blossoming: on each interval the polynomial whose control points over the knots
        /// are 0 but for the i-th, which is 1. Equal to [`KnotVector::basis_function`].
        ///
        /// # Errors
        /// [`SplineError::NoSuchFunction`].
        pub(in crate::math::spline) fn basis_function_by_blossom(
            &self,
            i: usize,
        ) -> Result<Piecewise<C>, SplineError> {
            self.check_index(i)?;
            let n = self.degree();
            // Outside knots further to both sides do not matter for this function.
            let inner = &self.knots()[i..=i + n + 1];
            let step = |a: &C, b: &C| if a == b { C::one() } else { b.minus(a) };
            let spread = step(&inner[0], &inner[n + 1]);
            let mut knots: Vec<C> = Vec::with_capacity(3 * n + 2);
            let shifted = |k: usize, sign: &C| inner[0].plus(&sign.times(&times(&spread, k)));
            knots.extend((1..=n).rev().map(|k| shifted(k, &-C::one())));
            knots.extend_from_slice(inner);
            let after = |k: usize| inner[n + 1].plus(&times(&spread, k));
            knots.extend((1..=n).map(after));
            let extended = KnotVector::new(n, knots)?;
            let points = (0..extended.count()).map(|k| vec![if k == n { C::one() } else { C::zero() }]);
            let spline = BSpline::new(extended, points.collect())?;
            let (mut breaks, mut pieces) = (vec![inner[0].clone()], Vec::new());
            for j in n..=2 * n {
                let (a, b) = (&spline.knots().knots()[j], &spline.knots().knots()[j + 1]);
                if a == b {
                    continue;
                }
                let ordinates: Vec<C> =
                    spline.bezier_piece(j)?.points().iter().map(|point| point[0].clone()).collect();
                let interval = Interval::new(a.clone(), b.clone()).map_err(|_| SplineError::NoDomain)?;
                let form = PolarForm::from_bezier_points_over(&ordinates, &interval)
                    .map_err(|_| SplineError::NoDomain)?;
                pieces.push(form.diagonal());
                breaks.push(b.clone());
            }
            let function = Piecewise::new(breaks, pieces, Outside::Zero)?;
            Ok(function.left_at(self.last_end()))
        }
    }

    fn times<C: Field>(x: &C, k: usize) -> C {
        x.scaled(&Rational::from_integer(crate::math::number::Int::from(k)))
    }
}
