//! Piecewise polynomials as values.

use std::collections::BTreeSet;

use super::{Value, grouped_expr, polynomial_expr, symbol_expr};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::math::piecewise::{Outside, Piecewise, PiecewiseError};
use crate::math::poly::{Fraction, MultiPoly, Symbol};

/// A piecewise polynomial with the name of its variable.
#[derive(Clone, Debug)]
pub struct PiecewiseFunction {
    /// The function.
    pub function: Piecewise<Fraction>,
    /// How its variable is called.
    pub variable: Symbol,
    /// How its pieces are shown, if not as polynomials: as the sums of products they were made of.
    pub written: Option<Vec<Expr>>,
}

/// A parameter that is none of the symbols in some formulas: t where it is free.
pub(crate) fn free_parameter<'a>(formulas: impl IntoIterator<Item = &'a Fraction>) -> Symbol {
    let taken: BTreeSet<Symbol> = formulas.into_iter().flat_map(Fraction::variables).collect();
    let letters = ["t", "x", "u", "tau", "xi", "s"].map(Symbol::new);
    letters.into_iter().find(|letter| !taken.contains(letter)).unwrap_or_else(|| {
        let mut indexed = (0..).map(|i| Symbol::indexed("x", i));
        indexed.find(|symbol| !taken.contains(symbol)).unwrap_or_else(|| Symbol::new("t"))
    })
}

impl PartialEq for PiecewiseFunction {
    /// Equality of functions; the name of the variable does not matter.
    fn eq(&self, other: &Self) -> bool {
        self.function == other.function
    }
}

impl PiecewiseFunction {
    /// A function of this variable, its pieces shown as polynomials.
    pub fn new(function: Piecewise<Fraction>, variable: Symbol) -> Self {
        PiecewiseFunction { function, variable, written: None }
    }

    /// The pieces as they are shown.
    fn shown(&self) -> Vec<Expr> {
        match &self.written {
            Some(pieces) => pieces.clone(),
            None => self.formulas().iter().map(grouped_expr).collect(),
        }
    }

    /// The pieces as polynomials in the variable.
    pub fn formulas(&self) -> Vec<Fraction> {
        let t = Fraction::from(MultiPoly::symbol(self.variable.clone()));
        self.function.pieces().iter().map(|piece| piece.value(&t)).collect()
    }

    /// The value at a parameter.
    ///
    /// # Errors
    /// As [`Piecewise::value`].
    pub fn value(&self, t: &Fraction) -> Result<Value, PiecewiseError> {
        self.function.value(t).map(Value::Scalar)
    }

    /// The call that makes it.
    pub fn to_expr(&self) -> Expr {
        let list = |items: Vec<Expr>| Expr::from(Kind::List(items));
        let breaks = self.function.breaks().iter().map(polynomial_expr).collect();
        let pieces = self.shown();
        let mut arguments = vec![list(breaks), list(pieces)];
        if self.variable != Symbol::new("t") {
            arguments.push(Expr::relation(Expr::name("variable"), Rel::Eq, symbol_expr(&self.variable)));
        }
        if self.function.outside() == Outside::Zero {
            arguments.push(Expr::relation(Expr::name("outside"), Rel::Eq, Expr::int(0)));
        }
        if !self.function.is_closed() {
            let closed = match self.function.inner_left() {
                Some(k) => list(vec![polynomial_expr(&self.function.breaks()[k])]),
                None => Expr::int(0),
            };
            arguments.push(Expr::relation(Expr::name("closed"), Rel::Eq, closed));
        }
        Expr::apply(Expr::name("piecewise"), arguments)
    }

    /// The function by cases, for reading.
    pub fn display_expr(&self) -> Expr {
        let t = symbol_expr(&self.variable);
        let link = |rel, expr| Link { rel, span: Span::default(), expr };
        let breaks = self.function.breaks();
        let pieces = self.shown();
        let last = pieces.len() - 1;
        let mut cases: Vec<(Expr, Option<Expr>)> = Vec::with_capacity(last + 2);
        for (i, piece) in pieces.into_iter().enumerate() {
            let (from, to) = (polynomial_expr(&breaks[i]), polynomial_expr(&breaks[i + 1]));
            let left = self.function.inner_left();
            let start = if left == Some(i) { Rel::Lt } else { Rel::Le };
            let closed = left == Some(i + 1) || i == last && self.function.is_closed();
            let end = if closed { Rel::Le } else { Rel::Lt };
            let range = Kind::Chain(Box::new(from), vec![link(start, t.clone()), link(end, to)]);
            cases.push((piece, Some(range.into())));
        }
        if self.function.outside() == Outside::Zero {
            cases.push((Expr::int(0), None));
        }
        Kind::Cases(cases).into()
    }
}
