//! Systems of polynomial equations: Gröbner bases, and the real solutions where there are finitely many.
//!
//! Every real solution is given by one real number u, a root of a polynomial m, and x_i = N_i(u)/D(u): coordinates are
//! real numbers in isolating intervals, and the sign of any polynomial there is that of one polynomial at u.
//!
//! In two unknowns u is one of them, or x + k y, and m a resultant (`pair`); in any number of unknowns u is a linear
//! form that tells all solutions apart, and m its minimal polynomial in the algebra Q\[x\]/I (`quotient`).
//!
//! F. Rouillier, "Solving zero-dimensional systems through the rational univariate representation", AAECC 9 (1999).

mod groebner;
mod pair;
mod quotient;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::fmt;

use num_traits::Signed;

use crate::budget;
use crate::math::number::{Int, Rational, integer};
use crate::math::poly::{AlgebraicNumber, MultiPoly, Poly, RealRoot, Symbol};

pub use groebner::groebner_basis;
pub use pair::{Bounds, common_zeros, within};
pub use quotient::{MOST_SOLUTIONS, real_zeros};

/// Why a system is not solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SystemError {
    /// It has infinitely many complex solutions.
    Infinite,
    /// It has more complex solutions, with multiplicities, than [`MOST_SOLUTIONS`].
    Many,
    /// Its degrees allow more than [`MOST_SOLUTIONS`] complex solutions, and these were not counted.
    Degrees,
    /// Finding its Gröbner basis takes more pairs of polynomials than are looked at.
    Pairs,
    /// The equation of a surface has too many terms.
    Equation,
    /// Two solutions stay on one line, or one stays double, in every direction that was tried.
    Entangled,
}

impl fmt::Display for SystemError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SystemError::Infinite => f.write_str("there are infinitely many complex solutions"),
            SystemError::Many => {
                write!(f, "there are more than {MOST_SOLUTIONS} complex solutions, with multiplicities")
            }
            SystemError::Degrees => {
                write!(f, "the degrees allow more than {MOST_SOLUTIONS} complex solutions")
            }
            SystemError::Pairs => {
                write!(f, "a Gröbner basis needs more than {} pairs of polynomials", groebner::MOST_PAIRS)
            }
            SystemError::Equation => {
                f.write_str("the equation of the surface has a degree above 13, and so more than 560 terms")
            }
            SystemError::Entangled => f.write_str("a solution is multiple in every direction that was tried"),
        }
    }
}

impl std::error::Error for SystemError {}

/// A real solution of a system with finitely many.
#[derive(Clone, Debug, PartialEq)]
pub struct RealZero {
    /// Its coordinates.
    pub coordinates: Vec<RealRoot>,
    /// u
    parameter: RealRoot,
    /// N_1, …, N_k
    numerators: Vec<Poly>,
    /// D
    denominator: Poly,
}

impl RealZero {
    /// The sign of F there: equal if F = 0. Symbols of F are the unknowns.
    ///
    /// Cost: a product of polynomials modulo m for each factor of each term, then that of [`AlgebraicNumber::sign_of`].
    ///
    /// # Panics
    /// If F has another symbol.
    pub fn sign_of(&self, f: &MultiPoly, unknowns: &[Symbol]) -> Ordering {
        for digits in [24, 96] {
            if let Some(sign) = self.sign_by_intervals(f, unknowns, digits) {
                return sign;
            }
        }
        let modulus = match &self.parameter {
            RealRoot::Irrational(number) => Some(number.polynomial().clone()),
            RealRoot::Rational(_) => None,
        };
        let reduced = |p: Poly| match modulus.as_ref().and_then(|m| p.div_rem(m)) {
            Some((_, rest)) => rest,
            None => p,
        };
        let degree = f.total_degree().unwrap_or(0);
        let powers = |p: &Poly| {
            let mut list = vec![Poly::one()];
            for k in 0..degree as usize {
                list.push(reduced(&list[k] * p));
            }
            list
        };
        let below = powers(&self.denominator);
        let above: Vec<Vec<Poly>> = self.numerators.iter().map(powers).collect();
        let mut sum = Poly::zero();
        for (monomial, c) in f.terms(crate::math::poly::MonomialOrder::Lex) {
            let total: u32 = monomial.iter().map(|(_, e)| e).sum();
            let mut term = below[(degree - total) as usize].scale(&c);
            for (symbol, e) in monomial {
                let place = unknowns.iter().position(|s| *s == symbol).expect("only unknowns occur");
                term = reduced(&term * &above[place][e as usize]);
            }
            sum += term;
        }
        let sign = self.parameter.sign_of(&sum);
        match degree % 2 == 1 && self.parameter.sign_of(&self.denominator).is_lt() {
            true => sign.reverse(),
            false => sign,
        }
    }
}

impl RealZero {
    /// The sign of F, if the coordinates with so many binary digits tell that it is not 0.
    fn sign_by_intervals(&self, f: &MultiPoly, unknowns: &[Symbol], digits: u32) -> Option<Ordering> {
        let width = Rational::new(Int::ONE, Int::from(2).pow(digits));
        // Ends are rounded outwards, so that powers stay short.
        let unit = Rational::from_integer(Int::from(2).pow(digits + 8));
        let outwards = |(low, high): (Rational, Rational)| {
            ((low * &unit).floor() / &unit, (high * &unit).ceil() / &unit)
        };
        let ends: Vec<(Rational, Rational)> = self
            .coordinates
            .iter()
            .map(|x| match x {
                RealRoot::Rational(q) => (q.clone(), q.clone()),
                RealRoot::Irrational(number) => outwards(number.refined(&width).ends()),
            })
            .collect();
        let product = |a: &(Rational, Rational), b: &(Rational, Rational)| {
            let all = [&a.0 * &b.0, &a.0 * &b.1, &a.1 * &b.0, &a.1 * &b.1];
            let least = all.iter().min().expect("four of them").clone();
            (least, all.into_iter().max().expect("four of them"))
        };
        let (mut low, mut high) = (Rational::from_integer(Int::ZERO), Rational::from_integer(Int::ZERO));
        for (monomial, c) in f.terms(crate::math::poly::MonomialOrder::Lex) {
            budget::step();
            let mut term = (c.clone(), c);
            for (symbol, e) in monomial {
                let place = unknowns.iter().position(|s| *s == symbol).expect("only unknowns occur");
                for _ in 0..e {
                    term = product(&term, &ends[place]);
                    if term.0 != term.1 {
                        term = outwards(term);
                    }
                }
            }
            low += term.0;
            high += term.1;
        }
        match (low.is_positive(), high.is_negative()) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        }
    }
}

/// The real number N(u)/D(u), where D(u) ≠ 0.
///
/// Cost: a resultant with deg m + 1 values, its real roots, then values of N and D until one of these is singled out.
///
/// ```
/// use polarform::poly::Poly;
/// use polarform::system::image;
/// let t = Poly::variable();
/// let (root, _) = (t.pow(2) - Poly::from(2)).real_roots(None, None).unwrap().remove(1);
/// assert_eq!(image(&root, &t.pow(2), &Poly::one()).to_string(), "2");
/// assert_eq!(image(&root, &(&t + Poly::one()), &t).to_string(), "2 t^2 - 4 t + 1 in (1, 2)");
/// ```
pub fn image(u: &RealRoot, numerator: &Poly, denominator: &Poly) -> RealRoot {
    let number = match u {
        RealRoot::Rational(q) => return RealRoot::Rational(numerator.value(q) / denominator.value(q)),
        RealRoot::Irrational(number) => number,
    };
    let m = number.polynomial();
    let rest = |p: &Poly| p.div_rem(m).map_or_else(|| p.clone(), |(_, rest)| rest);
    let (n, d) = (rest(numerator), rest(denominator));
    if n.degree().unwrap_or(0) == 0 && d.degree().unwrap_or(0) == 0 {
        return RealRoot::Rational(n.coefficient(0) / d.coefficient(0));
    }
    // Res_t(m, x D − N) is 0 at the values at all roots of m.
    let degree = m.degree().unwrap_or(0);
    let nodes: Vec<Rational> = (0..=degree as i64).map(integer).collect();
    let formal = n.degree().max(d.degree()).unwrap_or(0);
    let value = |x: &Rational| {
        let inner = d.scale(x) - n.clone();
        // The degree may drop at a node; the determinant for the full degree has the missing power of the leading coefficient.
        let missing = formal - inner.degree().unwrap_or(0).min(formal);
        m.resultant(&inner) * num_traits::pow(m.leading_coefficient(), missing)
    };
    let values: Vec<Rational> = nodes.iter().map(value).collect();
    let equation = interpolated(&nodes, values);
    let candidates = equation.real_roots(None, None).unwrap_or_default();
    let candidates: Vec<RealRoot> = candidates.into_iter().map(|(root, _)| root).collect();
    selected(number, &n, &d, candidates)
}

/// The one of some numbers that is N(u)/D(u), of which it is known that one is. D(u) ≠ 0.
fn selected(u: &AlgebraicNumber, numerator: &Poly, denominator: &Poly, mut from: Vec<RealRoot>) -> RealRoot {
    let mut u = u.clone();
    while from.len() > 1 {
        budget::step();
        let (lower, upper) = u.ends();
        let (n, d) = (enclosure(numerator, &lower, &upper), enclosure(denominator, &lower, &upper));
        if d.0.is_positive() || d.1.is_negative() {
            let quotients = [&n.0 / &d.0, &n.0 / &d.1, &n.1 / &d.0, &n.1 / &d.1];
            let least = RealRoot::Rational(quotients.iter().min().expect("four of them").clone());
            let most = RealRoot::Rational(quotients.iter().max().expect("four of them").clone());
            from.retain(|x| (&least..=&most).contains(&x));
        }
        u = u.refined(&((upper - lower) / integer(1 << 12)));
    }
    from.pop().expect("the value is among the numbers")
}

/// Two numbers between which F lies on an interval, by Horner's rule with so many digits that their distance is of the order
/// of its width.
fn enclosure(f: &Poly, lower: &Rational, upper: &Rational) -> (Rational, Rational) {
    let width = upper - lower;
    let digits = 64 + width.denom().bits().saturating_sub(width.numer().bits()) as u32;
    let unit = Int::from(2).pow(digits);
    let scaled = |q: &Rational| {
        let q = q * Rational::from_integer(unit.clone());
        (q.floor().to_integer(), q.ceil().to_integer())
    };
    let (x, y) = (scaled(lower).0, scaled(upper).1);
    let (mut low, mut high) = (Int::ZERO, Int::ZERO);
    let floor = |a: &Int| num_integer::Integer::div_floor(a, &unit);
    for k in (0..=f.degree().unwrap_or(0)).rev() {
        let products = [&low * &x, &low * &y, &high * &x, &high * &y];
        let (c, d) = scaled(&f.coefficient(k));
        low = floor(products.iter().min().expect("four of them")) + c;
        high = floor(products.iter().max().expect("four of them")) + Int::ONE + d;
    }
    (Rational::new(low, unit.clone()), Rational::new(high, unit))
}

/// The polynomial with these values. Cost: n² operations on numbers.
fn interpolated(nodes: &[Rational], mut values: Vec<Rational>) -> Poly {
    for k in 1..nodes.len() {
        budget::steps(1 + (nodes.len() / 32) as u32);
        for i in (k..nodes.len()).rev() {
            values[i] = (&values[i] - &values[i - 1]) / (&nodes[i] - &nodes[i - k]);
        }
    }
    let mut sum = Poly::zero();
    for (node, c) in nodes.iter().zip(values).rev() {
        sum = sum * (Poly::variable() - Poly::constant(node.clone())) + Poly::constant(c);
    }
    sum
}

/// A polynomial in one symbol, with numbers as coefficients.
fn univariate(f: &MultiPoly, symbol: &Symbol) -> Option<Poly> {
    f.coefficients_in(symbol).iter().map(MultiPoly::as_constant).collect()
}
