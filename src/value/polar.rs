//! Polar forms as values: with the names of their arguments, and the ways to write them out.

use crate::blossom::{PolarForm, TensorPolarForm, TotalDegreePolarForm};
use crate::poly::{Fraction, Symbol};

/// How to write a polar form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Notation {
    /// Monomials with a common coefficient together: `5/3 (t1 + t2 + t3)`.
    #[default]
    Grouped,
    /// Every monomial with its own coefficient.
    Expanded,
    /// With the means σ_{i,n}.
    Sigma,
    /// Grouped, long sums shortened to `t1 t2 t3 + ... + t4 t5 t6`.
    Ellipsis,
}

/// The kinds of polar forms.
#[derive(Clone, Debug, PartialEq)]
pub enum PolarKind {
    /// Of a polynomial in one variable.
    Univariate(PolarForm<Fraction>),
    /// Symmetric in each of two groups of arguments.
    Tensor(TensorPolarForm<Fraction>),
    /// Arguments are points.
    Total(TotalDegreePolarForm<Fraction>),
}

/// A polar form together with the variables of its diagonal.
#[derive(Clone, Debug)]
pub struct Polar {
    /// The form.
    pub kind: PolarKind,
    /// The variables of the diagonal; the arguments are named after them (t gives t1, t2, …).
    pub variables: Vec<Symbol>,
}

impl PartialEq for Polar {
    /// Equality of maps; the names of the variables do not matter.
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

impl Polar {
    /// Number of arguments in each group.
    pub fn arity(&self) -> Vec<usize> {
        match &self.kind {
            PolarKind::Univariate(form) => vec![form.degree()],
            PolarKind::Tensor(form) => vec![form.degrees().0, form.degrees().1],
            PolarKind::Total(form) => vec![form.degree()],
        }
    }
}
