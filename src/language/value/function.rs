//! Functions given by formulas.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Value;
use crate::formula::Expr;
use crate::math::poly::{Fraction, Symbol};

/// The names visible to a function when it was defined.
pub type Scope = Arc<BTreeMap<Symbol, Value>>;

/// How a function is written: `B_i^n(t)` has one lower, one upper and one ordinary argument.
/// All of them together, in this order, are the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Shape {
    /// Arguments written as subscripts.
    pub lower: usize,
    /// Arguments written as superscripts.
    pub upper: usize,
    /// Arguments in parentheses.
    pub inner: usize,
    /// How many coordinates each of them has, if they are points: 2 in `f((u1, v1), (u2, v2))`; otherwise 0.
    pub dimension: usize,
}

impl Shape {
    /// A function written `f(x, y)`.
    pub fn plain(inner: usize) -> Self {
        Shape { inner, ..Shape::default() }
    }

    /// Number of parameters.
    pub fn arity(self) -> usize {
        self.lower + self.upper + self.inner * self.dimension.max(1)
    }
}

/// A parameter of one clause.
#[derive(Clone, Debug, PartialEq)]
pub enum Parameter {
    /// Takes any value under this name.
    Name(Symbol),
    /// Matches this number only: a base case such as `N(i, 0, t) := …`.
    Exactly(crate::math::number::Rational),
}

/// One case of a definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Clause {
    /// The parameters.
    pub parameters: Vec<Parameter>,
    /// The right-hand side as written.
    pub body: Expr,
    /// Whether it is shown as written also where its formula is known: Newton's form of a
    /// polynomial is one because of how it is written.
    pub written: bool,
    /// Its value with the parameters as symbols, if it can be computed once and for all.
    pub formula: Option<Fraction>,
    /// The names visible when the clause was written.
    pub scope: Scope,
}

/// A function given by one or more clauses; the first that matches counts, exact
/// parameters before names.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// The name it was defined under, if any.
    pub name: Option<Symbol>,
    /// How it is written.
    pub shape: Shape,
    /// The clauses.
    pub clauses: Vec<Clause>,
}

impl Function {
    /// The parameter and the formula of a function of one variable given by a single formula.
    pub fn as_formula(&self) -> Option<(&Symbol, &Fraction)> {
        match self.clauses.as_slice() {
            [Clause { parameters, formula: Some(formula), .. }] => match parameters.as_slice() {
                [Parameter::Name(symbol)] => Some((symbol, formula)),
                _ => None,
            },
            _ => None,
        }
    }

    /// All parameters and the formula, when every parameter is a name and there is one clause.
    pub fn as_formula_of_many(&self) -> Option<(Vec<&Symbol>, &Fraction)> {
        let [Clause { parameters, formula: Some(formula), .. }] = self.clauses.as_slice() else {
            return None;
        };
        let names: Option<Vec<&Symbol>> = parameters
            .iter()
            .map(|parameter| match parameter {
                Parameter::Name(symbol) => Some(symbol),
                Parameter::Exactly(_) => None,
            })
            .collect();
        Some((names?, formula))
    }
}
