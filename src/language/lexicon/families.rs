//! Families of functions that are known by their notation: B_i^n, N_i^k, σ_{i,n}.

use crate::formula::{Expr, Kind};
use crate::math::basis;
use crate::math::blossom::{PolarError, PolarForm};
use crate::math::number::{Rational, binomial};
use crate::math::poly::{Coefficients, Fraction};
use crate::math::ring::Ring;
use crate::math::spline::KnotVector;
use num_traits::{One, Zero};

/// The forward difference, an operator: Δ b_i = b_{i+1} − b_i.
pub(crate) const FORWARD_DIFFERENCE: &str = "Delta";

/// The backward difference.
pub(crate) const BACKWARD_DIFFERENCE: &str = "nabla";

/// The letter of binomial coefficients: C_n^i is n over i.
pub(crate) const BINOMIAL_COEFFICIENT: &str = "C";

/// Whether a letter with these indices is a binomial coefficient: `C_n^i`, each index a number, a
/// name, or a sum or product of such. Whether C has a value after all the evaluator decides.
pub(crate) fn is_binomial_coefficient(letter: &Expr, lower: &[Expr], upper: &Expr) -> bool {
    let is_index = |expr: &Expr| {
        matches!(
            expr.kind,
            Kind::Number(_) | Kind::Name(_) | Kind::Add(_) | Kind::Mul(_) | Kind::Subscript(..)
        )
    };
    matches!(&letter.kind, Kind::Name(name) if name == BINOMIAL_COEFFICIENT)
        && matches!(lower, [below] if is_index(below))
        && is_index(upper)
}

/// The letter of Bernstein polynomials: B_i^n.
pub(crate) const BERNSTEIN: &str = "B";

/// The letter of B-splines: N_i^k.
pub(crate) const SPLINE: &str = "N";

/// The letters of Lagrange polynomials, which have no values without their nodes: L_i, \ell_i.
pub(crate) const LAGRANGE: &[&str] = &["L", "l", "ell"];

/// What a family consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    /// Bernstein polynomials.
    Bernstein,
    /// Bernstein polynomials of a triangle, in barycentric coordinates.
    Triangular,
    /// Means of the products of i of n arguments.
    SymmetricMean,
    /// B-splines over knots that the notation does not tell.
    Spline,
}

/// A way to write the members of a family.
#[derive(Debug)]
pub(crate) struct Notation {
    /// The letter.
    pub(crate) letter: &'static str,
    /// The number of lower indices: which member of the family, and after that perhaps its degree.
    pub(crate) lower: usize,
    /// The number of upper indices: its degree.
    pub(crate) upper: usize,
    /// What is written so.
    pub(crate) family: Family,
    /// The same in words.
    pub(crate) meaning: &'static str,
    /// The function of the language that has the values, and which of the indices, lower ones
    /// first, are its first arguments; without one the notation is explained where it is used.
    pub(crate) function: Option<(&'static str, &'static [usize])>,
}

/// All notations.
const NOTATIONS: &[Notation] = &[
    Notation {
        letter: BERNSTEIN,
        lower: 1,
        upper: 1,
        family: Family::Bernstein,
        meaning: "B_i^n is the Bernstein polynomial",
        function: Some(("bernstein", &[1, 0])),
    },
    // Other books have the degree first.
    Notation {
        letter: BERNSTEIN,
        lower: 2,
        upper: 0,
        family: Family::Bernstein,
        meaning: "B_{i,n} is the Bernstein polynomial",
        function: Some(("bernstein", &[1, 0])),
    },
    Notation {
        letter: BERNSTEIN,
        lower: 3,
        upper: 1,
        family: Family::Triangular,
        meaning: "B_{i,j,k}^n is the Bernstein polynomial of a triangle",
        function: None,
    },
    Notation {
        letter: "sigma",
        lower: 2,
        upper: 0,
        family: Family::SymmetricMean,
        meaning: "sigma_{i,n} is the mean of the products of i of the n arguments",
        function: Some(("sigma", &[0, 1])),
    },
    // The number of factors again: σ_{i,n}^i.
    Notation {
        letter: "sigma",
        lower: 2,
        upper: 1,
        family: Family::SymmetricMean,
        meaning: "sigma_{i,n} is the mean of the products of i of the n arguments",
        function: None,
    },
    // Of order k in some books, of degree k in others.
    Notation {
        letter: SPLINE,
        lower: 1,
        upper: 1,
        family: Family::Spline,
        meaning: "N_i^k is the B-spline with the knots t_i",
        function: None,
    },
    Notation {
        letter: SPLINE,
        lower: 2,
        upper: 0,
        family: Family::Spline,
        meaning: "N_i^k is the B-spline with the knots t_i",
        function: None,
    },
];

/// The notation with this letter and as many lower and upper indices.
pub(crate) fn notation(letter: &str, lower: usize, upper: usize) -> Option<&'static Notation> {
    NOTATIONS.iter().find(|known| known.letter == letter && known.lower == lower && known.upper == upper)
}

/// Whether the letter stands for a family with indices.
pub(crate) fn is_family(letter: &str) -> bool {
    NOTATIONS.iter().any(|known| known.letter == letter)
}

/// Whether the letter stands for a family whose values the notation alone tells.
pub(crate) fn has_values(letter: &str) -> bool {
    NOTATIONS.iter().any(|known| known.letter == letter && known.family != Family::Spline)
}

/// B_i^n(t); 0 outside 0 ≤ i ≤ n.
pub(crate) fn bernstein(n: i64, i: i64, t: &Fraction) -> Fraction {
    match (usize::try_from(n), usize::try_from(i)) {
        (Ok(n), Ok(i)) => {
            crate::budget::charge_terms(n as u64);
            basis::bernstein(n, i, t)
        }
        _ => Fraction::zero(),
    }
}

/// n!/(i! j! k!) u^i v^j w^k for indices that add up to n.
pub(crate) fn triangular(indices: &[usize], at: &[Fraction]) -> Fraction {
    basis::bernstein_simplex(indices, at)
}

/// σ_{i,n}: the mean of the products of i of the arguments, which is the polar form of t^i.
///
/// # Errors
/// [`PolarError`] for more factors than arguments.
pub(crate) fn symmetric_mean(i: usize, at: &[Fraction]) -> Result<Fraction, PolarError> {
    let mut power = vec![Fraction::zero(); i];
    power.push(Fraction::one());
    PolarForm::with_degree(power, at.len())?.value(at)
}

/// The mean of the products of i arguments and of the complements 1 − t_j of the others: the polar
/// form of t^i (1−t)^{n−i}.
///
/// # Errors
/// [`PolarError`] for more factors than arguments.
pub(crate) fn complementary_mean(i: usize, at: &[Fraction]) -> Result<Fraction, PolarError> {
    let others = at.len().saturating_sub(i);
    let mut polynomial = vec![Fraction::zero(); i];
    polynomial.extend((0..=others).map(|j| {
        let weight = Rational::from_integer(binomial(others, j));
        Fraction::from_rational(&if j % 2 == 0 { weight } else { -weight })
    }));
    PolarForm::with_degree(polynomial, at.len())?.value(at)
}

/// The B-spline over the given distinct knots on the interval with a number, counted from 0 at its
/// first knot; 0 outside its support, `None` without a knot interval.
pub(crate) fn spline(knots: &[Rational], interval: i64, t: &Fraction) -> Option<Fraction> {
    let degree = knots.len().checked_sub(2)?;
    let Some(interval) = usize::try_from(interval).ok().filter(|&at| at <= degree) else {
        return Some(Fraction::zero());
    };
    let function = KnotVector::new(degree, knots.to_vec()).ok()?.basis_function(0).ok()?;
    let piece: Coefficients<Fraction> =
        function.pieces()[interval].iter().map(Fraction::from_rational).collect();
    Some(piece.value(t))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use crate::math::poly::{MultiPoly, Symbol};

    fn number(q: Rational) -> Fraction {
        Fraction::from_rational(&q)
    }

    #[test]
    fn notations_are_told_apart_by_their_indices() {
        assert_eq!(notation("B", 1, 1).map(|n| n.family), Some(Family::Bernstein));
        assert_eq!(notation("B", 3, 1).map(|n| n.family), Some(Family::Triangular));
        assert!(notation("B", 0, 0).is_none() && notation("P", 1, 1).is_none());
        assert!(is_family("N") && !has_values("N") && has_values("sigma"));
    }

    #[test]
    fn members_have_their_values() {
        let t = number(rational(1, 3));
        assert_eq!(bernstein(2, 1, &t), number(rational(4, 9)));
        assert_eq!(bernstein(2, -1, &t), number(integer(0)));
        let at = [1, 2, 3].map(|k| number(integer(k)));
        assert_eq!(symmetric_mean(2, &at).unwrap(), number(rational(11, 3)));
        assert_eq!(complementary_mean(3, &at).unwrap(), number(integer(6)));
        assert_eq!(triangular(&[1, 1, 1], &at), number(integer(36)));
    }

    #[test]
    fn a_spline_is_its_polynomial_on_each_interval() {
        let knots = [0, 1, 2].map(integer);
        let t = Fraction::from(MultiPoly::symbol(Symbol::new("t")));
        assert_eq!(spline(&knots, 0, &t), Some(t.clone()));
        assert_eq!(spline(&knots, 1, &t), Some(number(integer(2)).minus(&t)));
        assert_eq!(spline(&knots, 2, &t), Some(number(integer(0))));
        assert_eq!(spline(&knots[..1], 0, &t), None);
    }
}
