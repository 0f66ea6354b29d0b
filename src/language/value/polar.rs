//! Polar forms as values: with the names of their arguments, and the ways to write them out.

use crate::math::blossom::{PolarForm, TensorPolarForm, TotalDegreePolarForm};
use crate::math::poly::{Fraction, MultiPoly, Symbol, horner};

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

    /// The polynomial F(t) = f(t, …, t) in the variables of the form.
    pub fn diagonal(&self) -> Fraction {
        let variable = |k: usize| Fraction::from(MultiPoly::symbol(self.variables[k].clone()));
        match &self.kind {
            PolarKind::Univariate(form) => horner(form.coefficients(), &variable(0)),
            PolarKind::Tensor(form) => {
                let rows: Vec<Fraction> =
                    form.coefficients().iter().map(|row| horner(row, &variable(1))).collect();
                horner(&rows, &variable(0))
            }
            PolarKind::Total(form) => {
                let point: Vec<Fraction> = (0..form.dimension()).map(variable).collect();
                form.diagonal_at(&point)
            }
        }
    }
}
