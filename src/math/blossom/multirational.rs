//! The multirational blossom, of polynomials and of rational functions.
//!
//! **Definition.** The multirational blossom of order d = m − n of F is the function f(u_1, …, u_m / v_1, …, v_n) that is symmetric in
//! the u and in the v, affine in each u, does not change where an argument stands on both sides and is left out (cancellation), and has
//! F(t) = f(t, …, t / ) with d arguments t, or f( / t, …, t) with −d of them. Without v it is the polar form. For d < 0 the model is
//! F(t) = (a − t)^d with f = ∏ (a − u_i)/∏ (a − v_j).
//!
//! **Polynomials.** For d ≥ 0 only polynomials of degree at most d have one. It is determined if it has to be a polynomial of total degree d at
//! most in all arguments: that of t^k is c_k/C(d, k) with Σ c_k x^k = ∏ (1 + u_i x)/∏ (1 + v_j x).
//!
//! **Negative order.** Let d = −k < 0 and G^{(k−1)} = (k − 1)! F. Then f is the divided difference of G(t) ∏ (t − u_i) at v_1, …, v_n: for
//! F = (a − t)^{−k} and G = 1/(a − t) it is the model, since a divided difference of n nodes is 0 for polynomials of degree n − 2. G has to be
//! rational here: that is found by Hermite's reduction, as a linear system for its numerator over gcd(B, B') where F = A/B.
//!
//! **Divided differences.** Of A/B at the roots of ω, repeated or not: A = R B + S ω with deg R < n and deg S < deg B determines R, which interpolates
//! A/B, and its coefficient of t^{n−1}.
//!
//! R. Goldman, "Blossoming with cancellation" and "The rational Bernstein bases and the multirational blossoms", CAGD 16 (1999).

use std::fmt;

use nalgebra::DMatrix;

use crate::budget;
use crate::math::linalg::solutions;
use crate::math::number::{Rational, binomial, factorial};
use crate::math::poly::Coefficients;
use crate::math::ring::Field;

/// Why there is no multirational blossom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MultirationalError {
    /// Of order d ≥ 0 only polynomials of degree at most d have one.
    Degree {
        /// The order.
        order: usize,
    },
    /// It has logarithms: no rational function has F as derivative of this order.
    Logarithm {
        /// The order of the derivative, k − 1.
        order: usize,
    },
    /// An argument v is a pole, or the denominator is 0.
    Pole,
}

impl fmt::Display for MultirationalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MultirationalError::Degree { order } => {
                write!(
                    f,
                    "of order {order} only polynomials of degree {order} at most have a multirational blossom"
                )
            }
            MultirationalError::Logarithm { order: 1 } => {
                f.write_str("the blossom has logarithms: F is the derivative of no rational function")
            }
            MultirationalError::Logarithm { order } => {
                write!(
                    f,
                    "the blossom has logarithms: F is the derivative of order {order} of no rational function"
                )
            }
            MultirationalError::Pole => f.write_str("F has a pole at an argument on the right"),
        }
    }
}

impl std::error::Error for MultirationalError {}

/// f(u_1, …, u_m / v_1, …, v_n) for F = A/B by power coefficients.
///
/// Cost: m n products for polynomials of order 0 or more; else m products by linear polynomials and linear systems of sizes
/// 2 deg B (one for each order below −1) and n + deg B.
///
/// # Errors
/// [`MultirationalError`].
///
/// ```
/// use polarform::blossom::multirational;
/// use polarform::number::{integer as z, rational as q};
/// // F = 1/t of order −1: f( / v) = 1/v, f(u / v, w) = u/(v w)
/// let (one, t) = ([z(1)], [z(0), z(1)]);
/// assert_eq!(multirational(&one, &t, &[z(5)], &[z(2), z(3)]), Ok(q(5, 6)));
/// // F = t^2 of order 2: f(u, v, w / w) = u v
/// assert_eq!(multirational(&[z(0), z(0), z(1)], &one, &[2, 3, 7].map(z), &[z(7)]), Ok(z(6)));
/// ```
pub fn multirational<C: Field>(
    numerator: &[C],
    denominator: &[C],
    u: &[C],
    v: &[C],
) -> Result<C, MultirationalError> {
    let (a, b) = (Coefficients::new(numerator.to_vec()), Coefficients::new(denominator.to_vec()));
    let (a, b) = lowest(a, b).ok_or(MultirationalError::Pole)?;
    match u.len().checked_sub(v.len()) {
        Some(order) => {
            let fits = a.degree().is_none_or(|k| k <= order) && b.degree() == Some(0);
            let inverse = b.first().and_then(Field::inverse).filter(|_| fits);
            let inverse = inverse.ok_or(MultirationalError::Degree { order })?;
            Ok(of_polynomial(&a, order, u, v).times(&inverse))
        }
        None => of_negative_order(a, b, u, v),
    }
}

fn of_polynomial<C: Field>(a: &Coefficients<C>, order: usize, u: &[C], v: &[C]) -> C {
    let length = order + 1;
    // ∏ (1 + u_i x)/∏ (1 + v_j x) up to x^d.
    let mut series = vec![C::zero(); length];
    series[0] = C::one();
    for x in u {
        budget::steps(length as u32);
        for k in (1..length).rev() {
            let lower = series[k - 1].times(x);
            series[k] += lower;
        }
    }
    for x in v {
        budget::steps(length as u32);
        for k in 1..length {
            let lower = series[k - 1].times(x);
            series[k] -= lower;
        }
    }
    let weight = |k: usize| Rational::from_integer(binomial(order, k)).recip();
    a.iter().enumerate().fold(C::zero(), |sum, (k, c)| sum.plus(&c.times(&series[k]).scaled(&weight(k))))
}

fn of_negative_order<C: Field>(
    a: Coefficients<C>,
    b: Coefficients<C>,
    u: &[C],
    v: &[C],
) -> Result<C, MultirationalError> {
    let k = v.len() - u.len();
    let (a, b) = rational_antiderivative(&a, &b, k - 1)?;
    let (a, b) = (Coefficients::new(a), Coefficients::new(b));
    // An argument u may cancel a pole.
    let (a, b) = lowest(a.times(&Coefficients::from_roots(u)), b).ok_or(MultirationalError::Pole)?;
    let difference =
        divided_difference(&a, &b, &Coefficients::from_roots(v)).ok_or(MultirationalError::Pole)?;
    Ok(difference.scaled(&Rational::from_integer(factorial(k - 1))))
}

/// A rational function with A/B as derivative of this order, by power coefficients of numerator and denominator.
///
/// Cost: for each order a linear system of size 2 deg B at most.
///
/// # Errors
/// [`MultirationalError::Logarithm`], and [`MultirationalError::Pole`] for B = 0.
pub fn rational_antiderivative<C: Field>(
    numerator: &[C],
    denominator: &[C],
    order: usize,
) -> Result<(Vec<C>, Vec<C>), MultirationalError> {
    let (a, b) = (Coefficients::new(numerator.to_vec()), Coefficients::new(denominator.to_vec()));
    let (mut a, mut b) = lowest(a, b).ok_or(MultirationalError::Pole)?;
    for _ in 0..order {
        (a, b) = antiderivative(&a, &b).ok_or(MultirationalError::Logarithm { order })?;
    }
    Ok((a.to_vec(), b.to_vec()))
}

/// A/B without common factors; `None` if B = 0.
fn lowest<C: Field>(a: Coefficients<C>, b: Coefficients<C>) -> Option<(Coefficients<C>, Coefficients<C>)> {
    b.degree()?;
    let common = gcd(a.clone(), b.clone());
    Some((a.div_rem(&common)?.0, b.div_rem(&common)?.0))
}

fn gcd<C: Field>(mut a: Coefficients<C>, mut b: Coefficients<C>) -> Coefficients<C> {
    while let Some((_, rest)) = a.div_rem(&b) {
        budget::step();
        a = std::mem::replace(&mut b, rest);
    }
    a
}

/// The x with Σ x_j (column j) = right, if there is one.
fn combination<C: Field>(columns: &[Coefficients<C>], right: &Coefficients<C>) -> Option<Vec<C>> {
    if columns.is_empty() {
        return right.degree().is_none().then(Vec::new);
    }
    let rows = columns.iter().chain([right]).map(|list| list.len()).max().unwrap_or(0);
    let entry = |list: &Coefficients<C>, i: usize| list.get(i).cloned().unwrap_or_else(C::zero);
    let matrix = DMatrix::from_fn(rows, columns.len(), |i, j| entry(&columns[j], i));
    let right: Vec<C> = (0..rows).map(|i| entry(right, i)).collect();
    let found = solutions(&matrix, &right).expect("the sizes fit");
    let mut all = vec![C::zero(); columns.len()];
    for (&i, x) in found.determined.iter().zip(found.constants?) {
        all[i] = x;
    }
    Some(all)
}

/// x^k times a polynomial.
fn shifted<C: Field>(list: &Coefficients<C>, k: usize) -> Coefficients<C> {
    Coefficients::new(std::iter::repeat_n(C::zero(), k).chain(list.iter().cloned()).collect::<Vec<C>>())
}

/// G with G' = A/B in lowest terms, also in lowest terms, if it is rational: a polynomial and P/D with D = gcd(B, B') and
/// P' D − P D' = (A mod B) D²/B.
fn antiderivative<C: Field>(
    a: &Coefficients<C>,
    b: &Coefficients<C>,
) -> Option<(Coefficients<C>, Coefficients<C>)> {
    let (whole, rest) = a.div_rem(b)?;
    let whole = whole.antiderivative();
    let d = gcd(b.clone(), b.derivative());
    // Both sides are multiplied by B/D.
    let simple = b.div_rem(&d)?.0;
    let slope = d.derivative();
    let size = d.degree().unwrap_or(0);
    let columns: Vec<Coefficients<C>> = (0..size)
        .map(|k| {
            let power = shifted(&Coefficients::constant(C::one()), k);
            power.derivative().times(&d).minus(&power.times(&slope)).times(&simple)
        })
        .collect();
    let p = Coefficients::new(combination(&columns, &rest.times(&d))?);
    lowest(whole.times(&d).plus(&p), d)
}

/// The divided difference of A/B at the roots of ω; `None` if B has one of them.
fn divided_difference<C: Field>(
    a: &Coefficients<C>,
    b: &Coefficients<C>,
    node: &Coefficients<C>,
) -> Option<C> {
    let (count, size) = (node.degree()?, b.degree()?);
    if gcd(b.clone(), node.clone()).degree() != Some(0) {
        return None;
    }
    // A = R B + S ω + (a multiple of B ω): A is reduced first, which changes no value.
    let (_, reduced) = a.div_rem(&b.times(node))?;
    let columns: Vec<Coefficients<C>> =
        (0..count).map(|k| shifted(b, k)).chain((0..size).map(|k| shifted(node, k))).collect();
    let found = combination(&columns, &reduced)?;
    // (A − reduced)/B is a multiple of ω.
    Some(found[count - 1].clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::blossom::PolarForm;
    use crate::math::number::{integer as z, rational as q};
    use num_traits::{One, Zero};
    use proptest::prelude::*;

    fn numbers(count: impl Into<prop::collection::SizeRange>) -> impl Strategy<Value = Vec<Rational>> {
        prop::collection::vec((-6i64..7, 1i64..4).prop_map(|(a, b)| q(a, b)), count)
    }

    /// Poles far from the arguments, with multiplicities.
    fn poles() -> impl Strategy<Value = Vec<(i64, u32, i64)>> {
        prop::collection::vec((10i64..20, 2u32..4, -3i64..4), 1..3)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Without v it is the polar form; an argument on both sides may be left out.
        #[test]
        fn polynomials(c in numbers(1..5), u in numbers(4), w in numbers(0..3)) {
            let n = c.len() - 1;
            let u = &u[..n];
            let both: Vec<Rational> = u.iter().chain(&w).cloned().collect();
            let polar = PolarForm::new(c.clone()).value(u).unwrap();
            prop_assert_eq!(multirational(&c, &[z(1)], u, &[]).unwrap(), polar.clone());
            prop_assert_eq!(multirational(&c, &[z(1)], &both, &w).unwrap(), polar);
        }

        /// Sums of c (a − t)^{−k} have the blossom Σ c ∏ (a − u)/∏ (a − v).
        #[test]
        fn sums_of_the_model(parts in poles(), u in numbers(0..3), v in numbers(5), k in 1usize..3) {
            let v = &v[..u.len() + k];
            let (mut above, mut below) = (Coefficients::zero(), Coefficients::constant(z(1)));
            let mut expected = z(0);
            for (a, _, c) in &parts {
                let factor = Coefficients::new(vec![z(*a), z(-1)]);
                let power = (0..k).fold(Coefficients::constant(z(1)), |p, _| p.times(&factor));
                above = above.times(&power).plus(&below.times(&Coefficients::constant(z(*c))));
                below = below.times(&power);
                let product = |list: &[Rational]| list.iter().fold(Rational::one(), |p, x| p * (z(*a) - x));
                expected += z(*c) * product(&u) / product(v);
            }
            prop_assert_eq!(multirational(&above, &below, &u, v).unwrap(), expected);
        }

        /// The laws, for any rational function of order −1, and for derivatives of them of order −2.
        #[test]
        fn laws(parts in poles(), c in numbers(1..4), u in numbers(2), v in numbers(3), x in -5i64..6) {
            let below = parts.iter().fold(Coefficients::constant(z(1)), |p, (a, m, _)| {
                (0..*m).fold(p, |p, _| p.times(&Coefficients::new(vec![z(*a), z(-1)])))
            });
            let x = z(x);
            let value = |list: &[Rational], t: &Rational| Coefficients::new(list.to_vec()).value(t);
            let f = |u: &[Rational], v: &[Rational]| multirational(&c, &below, u, v).unwrap();
            // On the diagonal.
            prop_assert_eq!(f(&[], std::slice::from_ref(&x)), value(&c, &x) / below.value(&x));
            // Cancellation, symmetry, and affine in u.
            let more = [u[0].clone(), u[1].clone(), x.clone()];
            let with: Vec<Rational> = v.iter().cloned().chain([x.clone()]).collect();
            prop_assert_eq!(f(&more, &with), f(&u, &v));
            prop_assert_eq!(f(&[u[1].clone(), u[0].clone()], &[v[2].clone(), v[0].clone(), v[1].clone()]), f(&u, &v));
            let at = |s: Rational| f(&[s, u[1].clone()], &v);
            prop_assert_eq!(at(z(3)) - at(z(2)), at(z(8)) - at(z(7)));
            // G' of order −2 has the divided differences of G.
            let (a, b) = (Coefficients::new(c.clone()), below.clone());
            let slope = a.derivative().times(&b).minus(&a.times(&b.derivative()));
            let square = b.times(&b);
            prop_assume!(slope.degree().is_some());
            if v[0] != v[1] {
                let expected = (value(&c, &v[0]) / below.value(&v[0]) - value(&c, &v[1]) / below.value(&v[1])) / (&v[0] - &v[1]);
                prop_assert_eq!(multirational(&slope, &square, &[], &v[..2]).unwrap(), expected);
            }
            let double = multirational(&slope, &square, &[], &[x.clone(), x.clone()]).unwrap();
            prop_assert_eq!(double, slope.value(&x) / square.value(&x));
        }
    }

    #[test]
    fn what_has_none() {
        let (one, t) = ([z(1)], [z(0), z(1)]);
        assert_eq!(multirational(&one, &t, &[z(1)], &[]), Err(MultirationalError::Degree { order: 1 }));
        assert_eq!(
            multirational(&[z(0), z(0), z(1)], &one, &[z(1)], &[]),
            Err(MultirationalError::Degree { order: 1 })
        );
        assert_eq!(
            multirational(&one, &t, &[], &[z(1), z(2)]),
            Err(MultirationalError::Logarithm { order: 1 })
        );
        assert_eq!(multirational(&one, &t, &[], &[z(0)]), Err(MultirationalError::Pole));
        assert_eq!(multirational(&one, &[], &[], &[z(0)]), Err(MultirationalError::Pole));
        assert!(multirational(&[], &one, &[], &[z(4)]).unwrap().is_zero());
    }
}
