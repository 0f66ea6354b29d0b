//! Factors over Q: of polynomials in one variable by Zassenhaus, in several by lifting from one.
//!
//! **Result.** p = c ∏ p_k^{m_k} with a rational number c and distinct irreducible p_k, primitive over the
//! integers with a positive leading coefficient, in the order of the multiplicity, the degree and the coefficients.
//!
//! H. Zassenhaus, "On Hensel factorization I", J. Number Theory 1 (1969); J. von zur Gathen, J. Gerhard,
//! *Modern Computer Algebra* (2013), chapters 14 to 16.

mod integers;
mod modular;
mod several;
#[cfg(test)]
mod tests;

use num_traits::{Signed, Zero};

use super::{MonomialOrder, MultiPoly, Poly};
use crate::math::number::Rational;
use crate::math::ring::Ring;

/// A polynomial as a number times powers of irreducible polynomials.
#[derive(Clone, Debug, PartialEq)]
pub struct Factorization<P> {
    /// The number.
    pub constant: Rational,
    /// The distinct irreducible factors with their multiplicities.
    pub factors: Vec<(P, usize)>,
}

impl Poly {
    /// The irreducible factors over Q. The constant of 0 is 0.
    ///
    /// Cost for degree n with r factors modulo a prime of 62 bits: about 30 n³ steps on words, then n² for
    /// each word of the coefficients, and in the worst case 2^r trial divisions, which count for the budget.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = t.pow(4) + Poly::from(4);
    /// let factors: Vec<String> = f.factors().factors.iter().map(|(p, _)| p.to_string()).collect();
    /// assert_eq!(factors, ["t^2 - 2 t + 2", "t^2 + 2 t + 2"]);
    /// ```
    pub fn factors(&self) -> Factorization<Poly> {
        let mut factors = Vec::new();
        for (part, multiplicity) in self.square_free_factors() {
            let part = part.primitive_part();
            let found = integers::irreducible_factors(part.numerators().to_vec());
            factors.extend(found.into_iter().map(|p| (Poly::from_integers(p, 1.into()), multiplicity)));
        }
        factors.sort_by_cached_key(|(p, m)| (*m, p.degree(), p.numerators().to_vec()));
        let lead = factors.iter().fold(Rational::from_integer(1.into()), |lead, (p, m)| {
            lead * p.leading_coefficient().powered(*m as u32)
        });
        Factorization { constant: self.leading_coefficient() / lead, factors }
    }
}

/// Factors of a primitive polynomial without repeated factors, positive multiples of theirs: all linear ones, and others
/// that are irreducible unless there are very many factors modulo a prime.
pub(super) fn coarse_factors(p: Poly) -> Vec<Poly> {
    let found = integers::factors_of_parts(p.into_parts().0, integers::FEW_PARTS);
    found.into_iter().map(|p| Poly::from_integers(p, 1.into())).collect()
}

impl MultiPoly {
    /// The irreducible factors over Q. The constant of 0 is 0.
    ///
    /// Cost: that of the factors in one variable, then for each degree in the other variables one product of
    /// the factors so far; a leading coefficient that is no number raises these degrees.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
    /// let f = x.pow(3) - y.pow(3);
    /// let factors: Vec<String> = f.factors().factors.iter().map(|(p, _)| p.to_string()).collect();
    /// assert_eq!(factors, ["x - y", "x^2 + x y + y^2"]);
    /// ```
    pub fn factors(&self) -> Factorization<MultiPoly> {
        let mut factors = several::factors(self);
        for (factor, _) in &mut factors {
            if factor.leading_coefficient().is_negative() {
                *factor = -factor.clone();
            }
        }
        factors.sort_by_cached_key(|(p, m)| (*m, p.total_degree(), p.len(), p.terms(MonomialOrder::GrLex)));
        let lead = factors.iter().fold(Rational::from_integer(1.into()), |lead, (p, m)| {
            lead * p.leading_coefficient().powered(*m as u32)
        });
        let constant = if self.is_zero() { Rational::zero() } else { self.leading_coefficient() / lead };
        Factorization { constant, factors }
    }
}
