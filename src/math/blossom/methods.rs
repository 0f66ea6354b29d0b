//! Six ways to derive a polar form, each with its steps as data.
//!
//! All of them end at the weights w_k of f = Σ_k w_k e_k(t_1, …, t_n), which are
//! w_k = c_k / C(n, k); the methods differ in how they get there, and the tests demand
//! that they agree.
//!
//! References: Ramshaw (1989); de Boor, *B(asic)-spline basics* (1993), for the Taylor
//! form (the dual functional) and its independence of τ by integration by parts;
//! Laguerre's polars: Seidel, *An introduction to polar forms*, IEEE CG&A 13 (1993).

use std::fmt;
use std::str::FromStr;

use super::polar_form::PolarForm;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational, binomial, binomial_row, factorial};
use crate::math::poly::Coefficients;
use crate::math::ring::Ring;

/// The six derivations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// t^i → σ_{i,n}
    Elementary,
    /// t^i → expected product over a random i-subset of the arguments
    Probability,
    /// Σ ((−1)^{n−i}/n!) Φ^{(n−i)}(τ) F^{(i)}(τ)
    Taylor,
    /// the same sum, its independence of τ shown by differentiating, then τ = 0
    Parts,
    /// iterated polars p(τ) + (u − τ)/d p'(τ)
    Laguerre,
    /// Σ b_i C(n, i) · mean of t…t (1−t)…(1−t)
    Bezier,
}

impl Method {
    /// All of them.
    pub const ALL: [Method; 6] = [
        Method::Elementary,
        Method::Probability,
        Method::Taylor,
        Method::Parts,
        Method::Laguerre,
        Method::Bezier,
    ];

    /// The name used on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Method::Elementary => "elementary",
            Method::Probability => "probability",
            Method::Taylor => "taylor",
            Method::Parts => "parts",
            Method::Laguerre => "laguerre",
            Method::Bezier => "bezier",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Method {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        Method::ALL.into_iter().find(|method| method.name() == text).ok_or_else(|| {
            format!("no method '{text}'; the methods are {}", Method::ALL.map(Method::name).join(", "))
        })
    }
}

/// A symmetric multi-affine function of m arguments, Σ_k w_k e_k(t_1, …, t_m), as w_0, …, w_m.
pub type Weights<C> = Vec<C>;

/// One step of a derivation. "Symmetric" entries are weights of elementary symmetric functions.
#[derive(Clone, Debug, PartialEq)]
pub enum Step<C> {
    /// Power i with coefficient c is replaced by σ_{i,n}: c e_i / C(n, i).
    Replace {
        /// The power.
        power: usize,
        /// Its coefficient c_i.
        coefficient: C,
        /// C(n, i).
        subsets: Int,
        /// c_i / C(n, i).
        weight: C,
    },
    /// A random i-subset of the n arguments is each of C(n, i) subsets with equal probability;
    /// its expected product is e_i / C(n, i).
    Expect {
        /// Size of the subset.
        size: usize,
        /// The coefficient of the power.
        coefficient: C,
        /// 1 / C(n, i).
        probability: Rational,
        /// c_i / C(n, i).
        weight: C,
    },
    /// One term of the Taylor form.
    TaylorTerm {
        /// i
        order: usize,
        /// τ
        at: C,
        /// F^{(i)}(τ)
        derivative: C,
        /// Φ^{(n−i)}(τ), symmetric in the arguments.
        auxiliary: Weights<C>,
        /// (−1)^{n−i} / n!
        factor: Rational,
        /// The term itself.
        term: Weights<C>,
    },
    /// d/dτ of term i of the Taylor form is (left + right), where left = s_i Φ^{(n−i+1)} F^{(i)}
    /// and right = s_i Φ^{(n−i)} F^{(i+1)}, s_i = (−1)^{n−i}/n!; right of i cancels left of i + 1.
    Telescope {
        /// i
        order: usize,
        /// s_i
        factor: Rational,
        /// Coefficients in τ of the left part, each symmetric in the arguments.
        left: Vec<Weights<C>>,
        /// Coefficients in τ of the right part.
        right: Vec<Weights<C>>,
    },
    /// The polar with respect to the next argument: p(τ) + (t_k − τ)/d · p'(τ).
    Polar {
        /// k, counted from 1.
        argument: usize,
        /// d, the degree before.
        degree: usize,
        /// Coefficients in τ of the result, each symmetric in t_1, …, t_k.
        result: Vec<Weights<C>>,
    },
    /// A Bézier point over [0, 1] times its symmetrised Bernstein polynomial.
    BezierTerm {
        /// i
        index: usize,
        /// b_i
        point: C,
        /// C(n, i) · mean of t_{j1}…t_{ji}(1−t_{j(i+1)})…(1−t_{jn}).
        blossom: Weights<Rational>,
    },
}

/// A polar form with the way it was found.
#[derive(Clone, PartialEq)]
pub struct Worked<C> {
    /// The method.
    pub method: Method,
    /// Its steps, in order.
    pub steps: Vec<Step<C>>,
    /// The result.
    pub form: PolarForm<C>,
}

impl<C: Ring> PolarForm<C> {
    /// Derives this polar form anew from its diagonal, by the given method, with all steps.
    ///
    /// Taylor uses the development point `tau` (any will do; parts always ends with τ = 0).
    /// Cost: O(n²) ring operations for elementary, probability and bezier, O(n³) for the others.
    ///
    /// ```
    /// use polarform::blossom::{Method, PolarForm};
    /// use polarform::number::integer;
    /// let f = PolarForm::new([1, 5, 3, 1].map(integer).to_vec());
    /// for method in Method::ALL {
    ///     assert_eq!(f.derive(method, &integer(7)).form, f);
    /// }
    /// ```
    pub fn derive(&self, method: Method, tau: &C) -> Worked<C> {
        let c = self.coefficients();
        let (weights, steps) = match method {
            Method::Elementary => elementary(c),
            Method::Probability => probability(c),
            Method::Taylor => taylor(c, tau),
            Method::Parts => parts(c),
            Method::Laguerre => laguerre(c),
            Method::Bezier => bezier(c),
        };
        let row = binomial_row(self.degree());
        let coefficients =
            weights.iter().zip(row).map(|(w, b)| w.scaled(&Rational::from_integer(b))).collect();
        Worked { method, steps, form: PolarForm::new(coefficients) }
    }
}

type Outcome<C> = (Weights<C>, Vec<Step<C>>);

fn elementary<C: Ring>(c: &[C]) -> Outcome<C> {
    let row = binomial_row(c.len() - 1);
    let weights: Vec<C> =
        c.iter().zip(&row).map(|(c, b)| c.scaled(&Rational::new(Int::ONE, b.clone()))).collect();
    let steps = (0..c.len())
        .rev()
        .map(|power| Step::Replace {
            power,
            coefficient: c[power].clone(),
            subsets: row[power].clone(),
            weight: weights[power].clone(),
        })
        .collect();
    (weights, steps)
}

fn probability<C: Ring>(c: &[C]) -> Outcome<C> {
    let n = c.len() - 1;
    let mut weights = Vec::with_capacity(c.len());
    let mut steps = Vec::with_capacity(c.len());
    for (size, coefficient) in c.iter().enumerate() {
        // Drawing one argument after the other without putting back: the chance that the
        // drawn set is a given i-set is i/n · (i−1)/(n−1) · …
        let probability: Rational =
            (0..size).map(|k| Rational::new(Int::from(size - k), Int::from(n - k))).product();
        let weight = coefficient.scaled(&probability);
        weights.push(weight.clone());
        steps.push(Step::Expect { size, coefficient: coefficient.clone(), probability, weight });
    }
    (weights, steps)
}

/// F^{(i)} for i = 0..=n.
fn derivatives<C: Ring>(c: &[C]) -> Vec<Coefficients<C>> {
    let first = Coefficients::new(c.to_vec());
    std::iter::successors(Some(first), |last| Some(last.derivative())).take(c.len()).collect()
}

/// Φ(τ) = ∏ (t_j − τ) = Σ_k (−τ)^{n−k} e_k: its m-th derivative as coefficients in τ, each the
/// weights of symmetric functions. Only power n−k−m of τ goes with e_k.
fn auxiliary_derivative<C: Ring>(n: usize, m: usize) -> Vec<Weights<C>> {
    let mut by_power = vec![vec![C::zero(); n + 1]; (n + 1).saturating_sub(m).max(1)];
    for (rest, weights) in by_power.iter_mut().enumerate().take((n + 1).saturating_sub(m)) {
        let power = rest + m;
        let falling: Int = (rest + 1..=power).map(Int::from).product();
        let sign = if power.is_multiple_of(2) { falling } else { -falling };
        weights[n - power] = C::from_rational(&Rational::from_integer(sign));
    }
    by_power
}

fn evaluate_at<C: Ring>(by_power: &[Weights<C>], tau: &C) -> Weights<C> {
    let mut result = vec![C::zero(); by_power.first().map_or(0, Vec::len)];
    for weights in by_power.iter().rev() {
        for (r, w) in result.iter_mut().zip(weights) {
            *r = r.times(tau).plus(w);
        }
    }
    result
}

fn taylor_factor(n: usize, i: usize) -> Rational {
    let magnitude = Rational::new(Int::ONE, factorial(n));
    if (n - i).is_multiple_of(2) { magnitude } else { -magnitude }
}

fn taylor<C: Ring>(c: &[C], tau: &C) -> Outcome<C> {
    let n = c.len() - 1;
    let mut weights = vec![C::zero(); n + 1];
    let mut steps = Vec::with_capacity(n + 1);
    for (i, derived) in derivatives(c).iter().enumerate() {
        crate::budget::steps(n as u32 + 1);
        let derivative = derived.value(tau);
        let auxiliary = evaluate_at(&auxiliary_derivative(n, n - i), tau);
        let factor = taylor_factor(n, i);
        let term: Weights<C> = auxiliary.iter().map(|w| w.times(&derivative).scaled(&factor)).collect();
        for (sum, t) in weights.iter_mut().zip(&term) {
            *sum += t.clone();
        }
        steps.push(Step::TaylorTerm { order: i, at: tau.clone(), derivative, auxiliary, factor, term });
    }
    (weights, steps)
}

/// Product of a polynomial in τ with symmetric coefficients and one with plain coefficients.
fn multiply_in_tau<C: Ring>(a: &[Weights<C>], b: &[C], factor: &Rational) -> Vec<Weights<C>> {
    let size = a.first().map_or(0, Vec::len);
    let mut result = vec![vec![C::zero(); size]; (a.len() + b.len()).saturating_sub(1).max(1)];
    for (i, weights) in a.iter().enumerate() {
        for (j, c) in b.iter().enumerate() {
            for (r, w) in result[i + j].iter_mut().zip(weights) {
                *r += w.times(c).scaled(factor);
            }
        }
    }
    while result.len() > 1 && result.last().is_some_and(|top| top.iter().all(C::is_zero)) {
        result.pop();
    }
    result
}

fn parts<C: Ring>(c: &[C]) -> Outcome<C> {
    let n = c.len() - 1;
    let derived = derivatives(c);
    let mut steps = Vec::with_capacity(2 * n + 2);
    for (i, function) in derived.iter().enumerate() {
        crate::budget::steps((n * n) as u32 + 1);
        let factor = taylor_factor(n, i);
        let next = derived.get(i + 1).map_or(&[] as &[C], |p| p);
        steps.push(Step::Telescope {
            order: i,
            left: multiply_in_tau(&auxiliary_derivative(n, n - i + 1), function, &factor),
            right: multiply_in_tau(&auxiliary_derivative(n, n - i), next, &factor),
            factor,
        });
    }
    let (weights, at_zero) = taylor(c, &C::zero());
    steps.extend(at_zero);
    (weights, steps)
}

fn laguerre<C: Ring>(c: &[C]) -> Outcome<C> {
    let n = c.len() - 1;
    // p as coefficients in τ, each Σ_i w_i e_i(t_1, …, t_k); k = 0 at the start.
    let mut p: Vec<Weights<C>> = c.iter().map(|c| vec![c.clone()]).collect();
    let mut steps = Vec::with_capacity(n);
    for k in 1..=n {
        crate::budget::steps((n * k) as u32);
        let d = n - k + 1;
        let inverse = Rational::new(Int::ONE, Int::from(d));
        // q = p'/d, so that the polar is (p − τ q) + t_k q.
        let q: Vec<Weights<C>> = p
            .iter()
            .enumerate()
            .skip(1)
            .map(|(j, w)| {
                let factor = &inverse * Rational::from_integer(Int::from(j));
                w.iter().map(|w| w.scaled(&factor)).collect()
            })
            .collect();
        let result: Vec<Weights<C>> = (0..d)
            .map(|j| {
                // Without t_k: e_i; with it: t_k e_i = part of e_{i+1} of k arguments. The result is
                // symmetric, so the first gives weights 0..k−1 and the last one of q is left.
                let mut weights: Weights<C> = match j.checked_sub(1) {
                    Some(below) => p[j].iter().zip(&q[below]).map(|(a, b)| a.minus(b)).collect(),
                    None => p[j].clone(),
                };
                debug_assert!(weights.iter().skip(1).eq(q[j].iter().take(k - 1)), "polar not symmetric");
                weights.push(q[j][k - 1].clone());
                weights
            })
            .collect();
        steps.push(Step::Polar { argument: k, degree: d, result: result.clone() });
        p = result;
    }
    (p.swap_remove(0), steps)
}

fn bezier<C: Ring>(c: &[C]) -> Outcome<C> {
    let n = c.len() - 1;
    let points = PolarForm::new(c.to_vec()).bezier_points(&Interval::unit());
    let mut weights = vec![C::zero(); n + 1];
    let mut steps = Vec::with_capacity(n + 1);
    for (i, point) in points.into_iter().enumerate() {
        crate::budget::steps(n as u32 + 1);
        // The monomial of a k-set occurs once for every i-set inside it, with sign (−1)^{k−i}.
        let blossom: Weights<Rational> = (0..=n)
            .map(|k| {
                let count = Rational::from_integer(binomial(k, i));
                if k >= i && (k - i) % 2 == 1 { -count } else { count }
            })
            .collect();
        for (sum, share) in weights.iter_mut().zip(&blossom) {
            *sum += point.scaled(share);
        }
        steps.push(Step::BezierTerm { index: i, point, blossom });
    }
    (weights, steps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;
    use num_traits::Zero;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn all_methods_agree(
            list in prop::collection::vec((-9i64..10, 1i64..6), 1..8),
            tau in (-9i64..10, 1i64..6),
        ) {
            let f = PolarForm::new(list.into_iter().map(|(p, q)| rational(p, q)).collect());
            for method in Method::ALL {
                assert_eq!(f.derive(method, &rational(tau.0, tau.1)).form, f, "{method}");
            }
        }
    }

    #[test]
    fn the_derivative_in_tau_telescopes() {
        let f = PolarForm::new([2, -3, 5, 7].map(|c| rational(c, 1)).to_vec());
        let steps = f.derive(Method::Parts, &Rational::zero()).steps;
        let mut carried: Option<Vec<Weights<Rational>>> = None;
        let zero = |part: &[Weights<Rational>]| part.iter().flatten().all(Zero::is_zero);
        for step in &steps {
            if let Step::Telescope { left, right, .. } = step {
                match &carried {
                    None => assert!(zero(left), "the first left part vanishes"),
                    Some(previous) => {
                        assert_eq!(previous.len(), left.len());
                        let sum = previous.iter().flatten().zip(left.iter().flatten());
                        assert!(sum.map(|(a, b)| a + b).all(|s| s.is_zero()));
                    }
                }
                carried = Some(right.clone());
            }
        }
        assert!(zero(&carried.unwrap()), "the last right part vanishes");
    }

    #[test]
    fn names_read_back() {
        for method in Method::ALL {
            assert_eq!(method.name().parse(), Ok(method));
        }
        assert!("fourier".parse::<Method>().unwrap_err().contains("elementary"));
    }
}
