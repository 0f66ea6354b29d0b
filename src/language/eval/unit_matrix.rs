//! Letters in sums that may mean more than themselves: I beside a matrix, A - λ I, and t beside a curve.

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use nalgebra::DMatrix;
use num_traits::Zero;

/// The letter of the identity matrix.
const UNIT: &str = "I";

impl Machine {
    /// The sum of two values. Beside a square matrix, a multiple of a letter I without a value is one of the identity
    /// matrix, and a note says so.
    pub(super) fn added(&mut self, left: Value, right: Value, span: Span) -> Evaluated {
        let (left, right) = match (left, right) {
            (Value::Matrix(matrix), Value::Scalar(formula)) => {
                let other = self.multiple_of_unit(&matrix, formula, span);
                (Value::Matrix(matrix), other)
            }
            (Value::Scalar(formula), Value::Matrix(matrix)) => {
                let other = self.multiple_of_unit(&matrix, formula, span);
                (other, Value::Matrix(matrix))
            }
            both => both,
        };
        if let (Value::Geometry(curve), Value::Scalar(formula))
        | (Value::Scalar(formula), Value::Geometry(curve)) = (&left, &right)
        {
            self.beside_curve(&curve.parameter(), formula, span);
        }
        arithmetic::add(left, right).at(span)
    }

    /// In bezier([1, 3]) + t^2 the letter t is one of any number, added to each control point: a note says so.
    fn beside_curve(&mut self, parameter: &Symbol, formula: &Fraction, span: Span) {
        if !formula.variables().contains(parameter) || self.has_reading() {
            return;
        }
        let text = format!("{parameter} is a letter beside the curve here, not its parameter");
        let note = Diagnostic::note(Code::StandardMeaning, text).at(span);
        let hint = format!(
            "write a polynomial as a curve, too: bezier([1, 3]) + bezier(bezier_points({parameter}^2))"
        );
        self.note(note.hint(hint));
    }

    /// c I as a matrix of the size of another; any other formula as it is.
    fn multiple_of_unit(&mut self, beside: &DMatrix<Fraction>, formula: Fraction, span: Span) -> Value {
        let unit = Symbol::new(UNIT);
        let factor = formula.derivative(&unit);
        let rest = formula.minus(&factor.times(&Fraction::from(MultiPoly::symbol(unit.clone()))));
        let multiple = !factor.is_zero() && rest.is_zero() && !factor.variables().contains(&unit);
        if !multiple || beside.nrows() != beside.ncols() || self.has_reading() {
            return Value::Scalar(formula);
        }
        let size = beside.nrows();
        let note = format!("{UNIT} is read as the identity matrix, identity({size})");
        self.note(Diagnostic::note(Code::StandardMeaning, note).at(span));
        Value::Matrix(DMatrix::<Fraction>::identity(size, size).map(|entry| entry.times(&factor)))
    }
}
