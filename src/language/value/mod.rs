//! What a formula can evaluate to.
//!
//! One type over all mathematical types of the crate, so that the language, the notes
//! checker and the writers speak of the same things. Every value turns back into a
//! formula ([`Value::to_expr`]), which the writers print.

mod algebraic;
mod derivation;
mod factors;
mod function;
mod geometry;
mod grouped;
mod list;
mod newton;
mod outcome;
mod piecewise;
mod polar;
mod table;
mod to_expr;
mod written;

pub use algebraic::{Algebraic, in_letter};
pub use derivation::{Derivation, Language, Line, Words};
pub use function::{Clause, Function, Parameter, Scope, Shape};
pub use geometry::{Form, Geometry, homogeneous};
pub use grouped::in_powers_of;
pub use list::List;
pub use newton::{newton_expr, newton_function, nodes_expr};
pub use outcome::{Claim, Judgement, Verdict, Witness};
pub use piecewise::PiecewiseFunction;
pub(crate) use piecewise::free_parameter;
pub use polar::{Notation, Polar, PolarKind};
pub use table::{Cell, Table};
pub use to_expr::{collected, curve_expr, exact_term, grouped_expr, polynomial_expr, symbol_expr};
pub use written::Written;

use std::sync::Arc;

use nalgebra::DMatrix;

use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::scene::Scene;

/// A value of the language.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number, polynomial or rational function, in any symbols.
    Scalar(Fraction),
    /// A real algebraic number that is not rational.
    Algebraic(Arc<Algebraic>),
    /// A vector argument v̂ (a difference of parameter values).
    Vector(Fraction),
    /// A polar form.
    Polar(Arc<Polar>),
    /// A function given by a formula, perhaps in several clauses.
    Function(Arc<Function>),
    /// A function of the program.
    Builtin(&'static str),
    /// A list, or a point.
    List(List<Value>),
    /// A matrix of scalars.
    Matrix(DMatrix<Fraction>),
    /// The outcome of a claim.
    Claim(Arc<Claim>),
    /// A curve or surface.
    Geometry(Arc<Geometry>),
    /// A piecewise polynomial.
    Piecewise(Arc<PiecewiseFunction>),
    /// A scheme or report of several columns.
    Table(Arc<Table>),
    /// A derivation, line by line.
    Derivation(Arc<Derivation>),
    /// A drawing.
    Figure(Arc<Scene>),
    /// A formula that is shown as it was arranged.
    Written(Arc<Written>),
    /// Words, such as the answer of `degree(0)`.
    Text(String),
}

impl Value {
    /// The coordinates of a point, which may be written as a column.
    pub(crate) fn coordinates(self) -> Option<Vec<Value>> {
        match self {
            Value::List(items) => Some(items.into_iter().collect()),
            Value::Matrix(column) if column.ncols() == 1 => {
                Some(column.iter().cloned().map(Value::Scalar).collect())
            }
            _ => None,
        }
    }

    /// A list.
    pub fn list(items: Vec<Value>) -> Self {
        Value::List(items.into())
    }

    /// A point, by its coordinates.
    ///
    /// ```
    /// use polarform::value::Value;
    /// use polarform::write::text;
    /// let point = Value::point(vec![Value::int(1), Value::int(2)]);
    /// assert_eq!(text(&point.to_expr()), "(1, 2)");
    /// assert_eq!(point, Value::list(vec![Value::int(1), Value::int(2)]));
    /// ```
    pub fn point(items: Vec<Value>) -> Self {
        Value::List(List::point(items))
    }

    /// A rational number.
    pub fn number(value: Rational) -> Self {
        Value::Scalar(Fraction::from(MultiPoly::constant(value)))
    }

    /// A small integer.
    pub fn int(value: i64) -> Self {
        Value::number(Rational::from_integer(value.into()))
    }

    /// A symbol standing for itself.
    pub fn symbol(symbol: Symbol) -> Self {
        Value::Scalar(Fraction::from(MultiPoly::symbol(symbol)))
    }

    /// The kind of value, with its article, for messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Value::Scalar(f) if f.as_rational().is_some() => "a number",
            Value::Scalar(f) if f.as_polynomial().is_some() => "a polynomial",
            Value::Scalar(_) => "a rational function",
            Value::Algebraic(_) => "an algebraic number",
            Value::Vector(_) => "a vector argument",
            Value::Polar(_) => "a polar form",
            Value::Function(_) | Value::Builtin(_) => "a function",
            Value::List(_) => "a list",
            Value::Matrix(_) => "a matrix",
            Value::Geometry(geometry) => geometry.kind(),
            Value::Piecewise(_) => "a piecewise polynomial",
            Value::Table(_) => "a table",
            Value::Derivation(_) => "a derivation",
            Value::Figure(_) => "a figure",
            Value::Written(written) => written.value.kind(),
            Value::Claim(_) => "a claim",
            Value::Text(_) => "a text",
        }
    }

    /// The scalar, if it is one.
    pub fn as_scalar(&self) -> Option<&Fraction> {
        match self {
            Value::Scalar(f) => Some(f),
            _ => None,
        }
    }

    /// The rational number, if it is one.
    pub fn as_rational(&self) -> Option<Rational> {
        self.as_scalar().and_then(Fraction::as_rational)
    }

    /// The machine integer, if it is one.
    pub fn as_int(&self) -> Option<i64> {
        let q = self.as_rational()?;
        if num_traits::One::is_one(q.denom()) { q.numer().as_small() } else { None }
    }
}
