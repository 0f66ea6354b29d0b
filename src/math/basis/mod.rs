//! Bases of the polynomials of degree at most n, and the matrices between them.
//!
//! A [`Basis`] is a list φ_0, …, φ_n of polynomials; the coefficients c of a polynomial
//! f in it are defined by f(t) = Σ c_j φ_j(t). [`change_of_basis`] gives the matrix M
//! with c' = M c for two bases; [`evaluate_basis`] the values φ_j(t).
//!
//! Between the two most important ones, the powers of t and the Bernstein polynomials
//! B_i^n(t) = C(n,i) t^i (1−t)^{n−i} on [0, 1], stand closed forms: with Bézier ordinates
//! b_0, …, b_n of f,
//!
//! f(t) = (1 t … t^n) A_n (b_0 … b_n)^T,
//! (A_n)_{ij} = (−1)^{i−j} C(n,i) C(i,j) and (A_n^{-1})_{ij} = C(i,j) / C(n,j) for j ≤ i,
//!
//! both 0 above the diagonal: [`bernstein_to_power`], [`power_to_bernstein`]. Every other
//! basis is reached through powers of t − o for a point o that suits it.
//!
//! **Invariant.** Everything here follows from closed forms and triangular schemes, never
//! from inverting a matrix; the generic exact inverse is the oracle of the tests.
//!
//! References: R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective",
//! CAGD 29 (2012); G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), chapters 5–7;
//! L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989).

mod bernstein;
mod change;
mod evaluate;
mod legendre;
mod matrices;

use std::fmt;

use crate::math::interval::Interval;
use crate::math::ring::Field;

pub use bernstein::{bernstein, bernstein_all, bernstein_simplex};
pub use change::change_of_basis;
pub use evaluate::evaluate_basis;
pub use legendre::legendre_all;
pub use matrices::{bernstein_to_power, lowering, power_to_bernstein, raising};

/// A basis φ_0, …, φ_n of the polynomials of degree at most n.
///
/// What the basis is for a given n, and whether there is one, says [`Basis::validate`].
#[derive(Clone, PartialEq)]
pub enum Basis<F> {
    /// φ_j = t^j.
    Power,
    /// φ_j = (t − at)^j; the coefficients are f^{(j)}(at) / j!.
    Taylor {
        /// The point of expansion.
        at: F,
    },
    /// φ_j = B_j^n((t − a)/(b − a)); the coefficients are the Bézier ordinates over [a, b].
    Bernstein(Interval<F>),
    /// φ_j = P_j((2t − a − b)/(b − a)), the Legendre polynomials of the interval [a, b]: orthogonal there, 1 at b.
    /// The Bézier ordinates of φ_j over [a, b] are (−1)^{i+j} C(j, i).
    Legendre(Interval<F>),
    /// φ_j = ∏_{k≠j} (t − x_k)/(x_j − x_k) for n+1 distinct nodes; the coefficients are the
    /// values f(x_j).
    Lagrange(Vec<F>),
    /// φ_j = ∏_{k<j} (t − x_k); the coefficients are the divided differences f[x_0, …, x_j].
    ///
    /// Nodes may repeat. There are n+1 of them; the last occurs in no φ_j and may be
    /// left out.
    Newton(Vec<F>),
    /// The basis dual to f(a), f'(a), …, f^{(m−1)}(a), f(b), f'(b), …, f^{(m−1)}(b), in this
    /// order, where n + 1 = 2m. For n = 3 these are the cubic Hermite polynomials.
    HermiteEndpoints(Interval<F>),
}

/// Why there is no such basis, or no such matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BasisError {
    /// Two nodes of a Lagrange basis are equal.
    EqualNodes {
        /// Index of the first of them.
        first: usize,
        /// Index of the second.
        second: usize,
    },
    /// There are too many or too few nodes for the degree.
    NodeCount {
        /// The degree n.
        degree: usize,
        /// The number of nodes given; n + 1 are needed.
        given: usize,
    },
    /// Hermite data at two ends need an odd degree.
    EvenDegree {
        /// The degree n.
        degree: usize,
    },
    /// A degree can be raised only to a larger one and lowered only to a smaller one.
    Degrees {
        /// The degree before.
        from: usize,
        /// The degree after.
        to: usize,
    },
}

impl fmt::Display for BasisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BasisError::EqualNodes { first, second } => {
                write!(f, "the nodes x_{first} and x_{second} are equal")
            }
            BasisError::NodeCount { degree, given } => {
                let needed = degree.saturating_add(1);
                let plural = if needed == 1 { "" } else { "s" };
                write!(f, "degree {degree} needs {needed} node{plural}, {given} given")
            }
            BasisError::EvenDegree { degree } => {
                write!(f, "values and derivatives at two ends need an odd degree, not {degree}")
            }
            BasisError::Degrees { from, to } if from < to => {
                write!(f, "cannot lower degree {from} to {to}, which is larger")
            }
            BasisError::Degrees { from, to } => {
                write!(f, "cannot raise degree {from} to {to}, which is smaller")
            }
        }
    }
}

impl std::error::Error for BasisError {}

/// As queries name it: `power`, `[bernstein, a, b]`, `[lagrange, t_0, …]`; over [0, 1] `bernstein` and `hermite`.
impl<F: Field + fmt::Display> fmt::Display for Basis<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let over =
            |f: &mut fmt::Formatter<'_>, word: &str, interval: &Interval<F>, alone: bool| match interval
                .ends()
            {
                (a, b) if alone && a.is_zero() && b.is_one() => f.write_str(word),
                (a, b) => write!(f, "[{word}, {a}, {b}]"),
            };
        let at = |f: &mut fmt::Formatter<'_>, word: &str, nodes: &[F]| {
            write!(f, "[{word}")?;
            nodes.iter().try_for_each(|node| write!(f, ", {node}"))?;
            f.write_str("]")
        };
        match self {
            Basis::Power => f.write_str("power"),
            Basis::Taylor { at } => write!(f, "[taylor, {at}]"),
            Basis::Bernstein(interval) => over(f, "bernstein", interval, true),
            Basis::Legendre(interval) => over(f, "legendre", interval, false),
            Basis::HermiteEndpoints(interval) => over(f, "hermite", interval, true),
            Basis::Lagrange(nodes) => at(f, "lagrange", nodes),
            Basis::Newton(nodes) => at(f, "newton", nodes),
        }
    }
}

debug_by_text!(Basis);

impl<F: Field> Basis<F> {
    /// Whether this is a basis of the polynomials of degree at most n. Cost: O(n²)
    /// comparisons for nodes, otherwise none to speak of.
    ///
    /// # Errors
    /// The [`BasisError`] that says which nodes are wrong.
    ///
    /// ```
    /// use polarform::basis::{Basis, BasisError};
    /// use polarform::number::integer;
    /// let nodes = Basis::Lagrange(vec![integer(0), integer(1), integer(0)]);
    /// assert_eq!(nodes.validate(2), Err(BasisError::EqualNodes { first: 0, second: 2 }));
    /// assert_eq!(nodes.validate(3), Err(BasisError::NodeCount { degree: 3, given: 3 }));
    /// ```
    pub fn validate(&self, n: usize) -> Result<(), BasisError> {
        match self {
            Basis::Power | Basis::Taylor { .. } => Ok(()),
            Basis::Bernstein(_) | Basis::Legendre(_) => Ok(()),
            Basis::HermiteEndpoints(_) if n.is_multiple_of(2) => Err(BasisError::EvenDegree { degree: n }),
            Basis::HermiteEndpoints(_) => Ok(()),
            Basis::Newton(nodes) if nodes.len() == n => Ok(()),
            Basis::Newton(nodes) | Basis::Lagrange(nodes) if nodes.len().checked_sub(1) != Some(n) => {
                Err(BasisError::NodeCount { degree: n, given: nodes.len() })
            }
            Basis::Newton(_) => Ok(()),
            Basis::Lagrange(nodes) => {
                let equal = |second: usize| nodes[..second].iter().position(|x| *x == nodes[second]);
                match (0..=n).find_map(|second| equal(second).map(|first| (first, second))) {
                    Some((first, second)) => Err(BasisError::EqualNodes { first, second }),
                    None => Ok(()),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
