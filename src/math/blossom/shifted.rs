//! The q-blossom and the h-blossom.
//!
//! **Definition.** The q-blossom of F of degree at most n is the symmetric multiaffine f with f(t, q t, …, q^{n−1} t) = F(t); the
//! h-blossom has f(t, t − h, …, t − (n − 1) h) = F(t). For q = 1 and h = 0 both are the polar form.
//!
//! **Formula.** A symmetric multiaffine function is Σ a_k e_k(u_1, …, u_n) with elementary symmetric functions e_k. For the q-blossom
//! e_k(t, q t, …) = q^{k(k−1)/2} [n k]_q t^k with Gauss' binomials, so a_k = c_k/(q^{k(k−1)/2} [n k]_q). For the h-blossom
//! e_k(t, t − h, …) is a polynomial of degree k in t with the leading coefficient C(n, k): a triangular system.
//!
//! P. Simeonov, V. Zafiris, R. Goldman, "q-Blossoming: a new approach to algorithms and identities for q-Bernstein bases and q-Bézier
//! curves", J. Approx. Theory 164 (2012); the same, "h-Blossoming", CAGD 28 (2011).

use super::PolarForm;
use crate::budget;
use crate::math::number::{Rational, binomial, integer};
use crate::math::ring::Field;

/// The q-blossom of Σ c_k t^k as a form of n arguments; `None` if it does not exist since some q^{k(k−1)/2} [n k]_q with k ≤ n is 0
/// where c_k ≠ 0. There are n + 1 coefficients.
///
/// Cost: n² products.
///
/// ```
/// use polarform::blossom::q_blossom;
/// use polarform::number::{integer as z, rational as q};
/// // f(u, v) = u v/2 for q = 2, since f(t, 2 t) = t².
/// let f = q_blossom(&[0, 0, 1].map(z), &z(2)).unwrap();
/// assert_eq!(f.value(&[z(3), z(6)]).unwrap(), z(9));
/// assert!(q_blossom(&[0, 1, 0].map(z), &z(-1)).is_none());
/// ```
pub fn q_blossom<C: Field>(coefficients: &[C], q: &C) -> Option<PolarForm<C>> {
    let arguments = nodes(coefficients.len(), |k| q.powered(k as u32));
    // e_k(1, q, …, q^{n−1})
    let values = elementary(&arguments);
    let share = |(k, c): (usize, &C)| match values[k].inverse() {
        Some(inverse) => Some(c.times(&inverse)),
        None if c.is_zero() => Some(C::zero()),
        None => None,
    };
    let list: Option<Vec<C>> = coefficients.iter().enumerate().map(share).collect();
    list.map(form)
}

/// The h-blossom of Σ c_k t^k as a form of n arguments. There are n + 1 coefficients.
///
/// Cost: n³ products.
///
/// ```
/// use polarform::blossom::h_blossom;
/// use polarform::number::{integer as z, rational as q};
/// // f(u, v) = u v + (u + v)/2 for h = 1, since f(t, t − 1) = t² − 1/2.
/// let f = h_blossom(&[q(-1, 2), z(0), z(1)], &z(1));
/// assert_eq!(f.value(&[z(3), z(2)]).unwrap(), q(17, 2));
/// ```
pub fn h_blossom<C: Field>(coefficients: &[C], h: &C) -> PolarForm<C> {
    let n = coefficients.len().saturating_sub(1);
    // e_k(t, t − h, …, t − (n − 1) h) by powers of t, for all k.
    let mut symmetric: Vec<Vec<C>> = vec![vec![C::one()]];
    for j in 0..n {
        budget::steps(1 + (n * n) as u32 / 8);
        let shift = -h.scaled(&integer(j as i64));
        let mut next = symmetric.clone();
        next.push(Vec::new());
        for (k, e) in symmetric.iter().enumerate() {
            // e_{k+1} gains e_k (t − j h).
            let target = &mut next[k + 1];
            target.resize(target.len().max(e.len() + 1), C::zero());
            for (i, c) in e.iter().enumerate() {
                target[i + 1] += c.clone();
                target[i] += c.times(&shift);
            }
        }
        symmetric = next;
    }
    let mut rest = coefficients.to_vec();
    let mut list = vec![C::zero(); n + 1];
    for k in (0..=n).rev() {
        let share = rest[k].scaled(&Rational::from_integer(binomial(n, k)).recip());
        for (x, c) in rest.iter_mut().zip(&symmetric[k]) {
            *x -= c.times(&share);
        }
        list[k] = share;
    }
    form(list)
}

/// Σ a_k e_k, kept as the polar form of Σ C(n, k) a_k t^k.
fn form<C: Field>(list: Vec<C>) -> PolarForm<C> {
    let n = list.len() - 1;
    let weighed = |(k, a): (usize, &C)| a.scaled(&Rational::from_integer(binomial(n, k)));
    PolarForm::new(list.iter().enumerate().map(weighed).collect::<Vec<C>>())
}

fn nodes<C: Field>(count: usize, at: impl Fn(usize) -> C) -> Vec<C> {
    (0..count.saturating_sub(1)).map(at).collect()
}

/// e_0, …, e_n of n elements. Cost: n² products.
fn elementary<C: Field>(list: &[C]) -> Vec<C> {
    let mut values = vec![C::one()];
    for x in list {
        values.push(C::zero());
        for k in (1..values.len()).rev() {
            let lower = values[k - 1].times(x);
            values[k] += lower;
        }
    }
    values
}

/// The apolar product Σ (−1)^k C(n, k)^{-1} a_k b_{n−k} of Σ a_k t^k and Σ b_k t^k, both as polynomials of degree n: for F with the
/// polar form f and G = c (t − r_1) … (t − r_n) it is c f(r_1, …, r_n). The two are apolar if it is 0.
///
/// Cost: n products.
///
/// # Panics
/// If the lists have different lengths.
///
/// ```
/// use polarform::blossom::apolar_product;
/// use polarform::number::integer as z;
/// // F = t², G = (t − 1)(t − 3): f(1, 3) = 3
/// assert_eq!(apolar_product(&[0, 0, 1].map(z), &[3, -4, 1].map(z)), z(3));
/// ```
pub fn apolar_product<C: Field>(f: &[C], g: &[C]) -> C {
    assert_eq!(f.len(), g.len(), "both polynomials have one degree");
    let n = f.len().saturating_sub(1);
    let mut sum = C::zero();
    for (k, (a, b)) in f.iter().zip(g.iter().rev()).enumerate() {
        let weight = Rational::from_integer(binomial(n, k)).recip();
        let term = a.times(b).scaled(&weight);
        sum += if k % 2 == 1 { -term } else { term };
    }
    sum
}

/// (c t + d)^n F((a t + b)/(c t + d)) for F = Σ c_k t^k of degree n and the entries a, b, c, d, as a polar form: a change of parameter of the
/// homogeneous coordinates of a rational curve.
///
/// Cost: n² products of polynomials by linear ones.
///
/// ```
/// use polarform::blossom::moebius;
/// use polarform::number::integer as z;
/// // t²/(t + 1)², times (t + 1)²
/// let f = moebius(&[0, 0, 1].map(z), &[1, 0, 1, 1].map(z));
/// assert_eq!(f.value(&[z(2), z(3)]).unwrap(), z(6));
/// ```
pub fn moebius<C: Field>(coefficients: &[C], [a, b, c, d]: &[C; 4]) -> PolarForm<C> {
    let n = coefficients.len() - 1;
    let times = |list: &[C], constant: &C, slope: &C| {
        let mut product = vec![C::zero(); list.len() + 1];
        for (k, x) in list.iter().enumerate() {
            product[k] += x.times(constant);
            product[k + 1] += x.times(slope);
        }
        product
    };
    // Horner: the sum over k ≥ j, with a factor (c t + d) for each step.
    let mut sum = vec![coefficients[n].clone()];
    let mut below = vec![C::one()];
    for k in (0..n).rev() {
        budget::steps(1 + n as u32);
        below = times(&below, d, c);
        sum = times(&sum, b, a);
        for (x, y) in sum.iter_mut().zip(&below) {
            *x += coefficients[k].times(y);
        }
    }
    PolarForm::new(sum)
}

/// The multilinear form of a polar form: w_1 ⋯ w_n f(u_1/w_1, …, u_n/w_n) at pairs (u_i, w_i), also with w_i = 0. It is linear in each pair; a number t
/// is the pair (t, 1), the vector 1 the pair (1, 0). At n equal pairs it is the homogeneous polynomial w^n F(u/w).
///
/// Cost: n² products.
///
/// # Panics
/// Unless there are n pairs.
///
/// ```
/// use polarform::blossom::{PolarForm, homogeneous_value};
/// use polarform::number::integer as z;
/// let f = PolarForm::new([0, 2, 1].map(z).to_vec()); // t1 t2 + t1 + t2
/// assert_eq!(homogeneous_value(&f, &[[z(3), z(1)], [z(1), z(0)]]), z(4));
/// ```
pub fn homogeneous_value<C: Field>(form: &PolarForm<C>, pairs: &[[C; 2]]) -> C {
    let n = form.degree();
    assert_eq!(pairs.len(), n, "a pair for each argument");
    // ∏ (w_i + u_i x)
    let mut product = vec![C::one()];
    for [u, w] in pairs {
        budget::steps(1 + n as u32);
        product.push(C::zero());
        for k in (0..product.len()).rev() {
            let below = if k > 0 { product[k - 1].times(u) } else { C::zero() };
            product[k] = product[k].times(w).plus(&below);
        }
    }
    let share =
        |(k, c): (usize, &C)| c.times(&product[k]).scaled(&Rational::from_integer(binomial(n, k)).recip());
    form.coefficients().iter().enumerate().map(share).fold(C::zero(), |sum, x| sum.plus(&x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, rational as q};
    use crate::math::poly::Poly;
    use crate::math::ring::Ring;
    use proptest::prelude::*;

    fn list() -> impl Strategy<Value = Vec<Rational>> {
        prop::collection::vec((-5i64..6, 1i64..4).prop_map(|(a, b)| q(a, b)), 1..7)
    }

    proptest! {
        /// Both forms give F on their diagonals, and with q = 1 and h = 0 they are the polar form.
        #[test]
        fn diagonals(c in list(), factor in (-4i64..5, 1i64..4), t in -4i64..5) {
            let factor = q(factor.0, factor.1);
            let n = c.len() - 1;
            let polynomial = Poly::from_coefficients(c.clone());
            let t = q(t, 3);
            let value = polynomial.value(&t);
            let plain = PolarForm::new(c.clone());
            prop_assert_eq!(q_blossom(&c, &z(1)).unwrap(), plain.clone());
            prop_assert_eq!(h_blossom(&c, &z(0)), plain);
            let arguments: Vec<Rational> = (0..n).map(|k| &t - &factor * z(k as i64)).collect();
            prop_assert_eq!(h_blossom(&c, &factor).value(&arguments).unwrap(), value.clone());
            if let Some(form) = q_blossom(&c, &factor) {
                let mut arguments = vec![t.clone()];
                for k in 1..n {
                    arguments.push(&arguments[k - 1] * &factor);
                }
                arguments.truncate(n);
                prop_assert_eq!(form.value(&arguments).unwrap(), value);
            } else {
                prop_assert!(factor == z(0) || factor == z(-1));
            }
        }

        /// Numbers and vectors as pairs, and a homogeneous polynomial on the diagonal.
        #[test]
        fn homogeneous_arguments(c in list(), u in prop::collection::vec((-5i64..6, -3i64..4), 6)) {
            let n = c.len() - 1;
            let form = PolarForm::new(c.clone());
            let pairs: Vec<[Rational; 2]> = u[..n].iter().map(|&(u, w)| [z(u), z(w)]).collect();
            let product = pairs.iter().fold(z(1), |p, [_, w]| p * w);
            if product != z(0) {
                let arguments: Vec<Rational> = pairs.iter().map(|[u, w]| u / w).collect();
                prop_assert_eq!(homogeneous_value(&form, &pairs), form.value(&arguments).unwrap() * product);
            } else if n > 0 {
                // (u, 0) is the difference of (u + 1, 1) and (1, 1).
                let at = pairs.iter().position(|[_, w]| *w == z(0)).unwrap();
                let with = |pair: [Rational; 2]| {
                    let mut pairs = pairs.clone();
                    pairs[at] = pair;
                    homogeneous_value(&form, &pairs)
                };
                let difference = with([&pairs[at][0] + z(1), z(1)]) - with([z(1), z(1)]);
                prop_assert_eq!(homogeneous_value(&form, &pairs), difference);
            }
        }

        /// The change of parameter, at numbers.
        #[test]
        fn changes_of_parameter(c in list(), m in prop::collection::vec(-3i64..4, 4), t in -4i64..5) {
            let entries: [Rational; 4] = [z(m[0]), z(m[1]), z(m[2]), z(m[3])];
            let t = q(t, 2);
            let (above, below) = (&entries[0] * &t + &entries[1], &entries[2] * &t + &entries[3]);
            prop_assume!(below != z(0));
            let n = c.len() - 1;
            let value = Poly::from_coefficients(c.clone()).value(&(above / &below)) * below.powered(n as u32);
            prop_assert_eq!(moebius(&c, &entries).value(&vec![t; n]).unwrap(), value);
        }

        /// The apolar product with a product of linear factors is a polar value.
        #[test]
        fn apolar_products_are_polar_values(c in list(), roots in prop::collection::vec(-4i64..5, 6), lead in 1i64..4) {
            let n = c.len() - 1;
            let roots: Vec<Rational> = roots[..n].iter().map(|&r| z(r)).collect();
            let g = roots.iter().fold(Poly::from(lead), |g, r| g * (Poly::variable() - Poly::constant(r.clone())));
            let g: Vec<Rational> = (0..=n).map(|k| g.coefficient(k)).collect();
            let value = PolarForm::new(c.clone()).value(&roots).unwrap() * z(lead);
            prop_assert_eq!(apolar_product(&c, &g), value);
        }
    }
}
