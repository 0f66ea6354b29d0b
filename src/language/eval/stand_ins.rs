//! What a call means where nothing of its own says it: f beside F, b beside b_0, b_1, …, a decimal comma, `B_{i,n}`.

use super::machine::Machine;
use super::names::name_of;
use super::statement::is_decimal_comma;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::{letters, roles};
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::Symbol;

impl Machine {
    /// F(0,5) of a function of one variable has a decimal comma; a note says so.
    pub(super) fn with_decimal(&mut self, callee: &Expr, groups: &[Vec<Expr>]) -> Option<Expr> {
        let ([group], None) = (groups, &self.reading) else { return None };
        let [whole, part] = group.as_slice() else { return None };
        let (Kind::Number(units), Kind::Number(digits)) = (&whole.kind, &part.kind) else { return None };
        if !is_decimal_comma(whole, part) {
            return None;
        }
        let value = name_of(callee, self).and_then(|name| self.lookup(&name))?;
        let Value::Function(function) = value else { return None };
        let shape = function.shape;
        if (shape.inner, shape.lower + shape.upper) != (1, 0) {
            return None;
        }
        let place = (0..part.span.len())
            .fold(Rational::from_integer(1.into()), |place, _| place / Rational::from_integer(10.into()));
        let number = units.clone() + digits.clone() * place;
        let shown = Expr { span: whole.span.to(part.span), ..Expr::number(&number) };
        let note = format!("the comma is read as a decimal point: {}", crate::language::write::text(&shown));
        self.note(Diagnostic::note(Code::BadNumber, note).at(shown.span));
        Some(shown)
    }

    /// What stands in for a name without a value before a parenthesis: for f the polar form of a polynomial F that is
    /// defined, for b the Bézier curve with control points b_0, …, b_n that are.
    pub(super) fn stand_in(
        &mut self,
        callee: &Expr,
        groups: &[Vec<Expr>],
    ) -> Result<Option<Value>, Diagnostic> {
        let (Kind::Name(letter), [group]) = (&callee.kind, groups) else { return Ok(None) };
        if self.reading.is_some() || self.lookup(&Symbol::new(letter)).is_some() {
            return Ok(None);
        }
        let capital = letters::capital(letter).filter(|_| group.len() > 1 && roles::is_function(letter));
        let (function, subject) = if let Some(capital) = capital {
            match self.lookup(&Symbol::new(&capital)) {
                Some(Value::Function(_)) => {}
                Some(Value::Scalar(formula)) if formula.as_polynomial().is_some() => {}
                _ => return Ok(None),
            }
            ("polar", Expr { span: callee.span, ..Expr::name(capital) })
        } else if group.len() == 1 && roles::is_control_point(letter) {
            let point = |i: i64| Expr { span: callee.span, ..Expr::indexed(letter.as_str(), i) };
            let known = |point: &Expr| name_of(point, self).is_some_and(|name| self.lookup(&name).is_some());
            let points: Vec<Expr> = (0..).map(point).take_while(known).collect();
            if points.len() < 2 {
                return Ok(None);
            }
            ("bezier", Expr { span: callee.span, ..Kind::List(points).into() })
        } else {
            return Ok(None);
        };
        let mut arguments = vec![subject];
        if function == "polar" {
            arguments.push(crate::formula::named("degree", Expr::int(self.count(group))));
        }
        let call = crate::formula::call(function, arguments, callee.span);
        let note = format!("{letter} is read as {}", crate::language::write::text(&call));
        self.note(Diagnostic::note(Code::StandardMeaning, note).at(callee.span));
        self.eval(&call).map(Some)
    }
}

impl Machine {
    /// How many arguments these are, with those below braces.
    fn count(&mut self, group: &[Expr]) -> i64 {
        let one = |machine: &mut Machine, item: &Expr| match &item.kind {
            Kind::Brace(_, Some(label)) => machine.eval_int(label).unwrap_or(1),
            _ => 1,
        };
        group.iter().map(|item| one(self, item)).sum()
    }
}

/// Refuses B_{3,2}: with the number first it would be 0, so that the degree may stand first.
pub(super) fn first_is_the_number(values: &[(Value, Span)], callee: &Expr) -> Result<(), Diagnostic> {
    let [(degree, _), (number, _)] = values else { return Ok(()) };
    match (degree.as_int(), number.as_int()) {
        (Some(degree), Some(number)) if number > degree => {
            let message = format!("is {degree} the number or the degree?");
            Err(Diagnostic::error(Code::AmbiguousProduct, message)
                .at(callee.span)
                .reason("B_{i,n} is read with the number i first, and i is at most n")
                .hint(format!(
                    "write B_{degree}^{number}(t) for the Bernstein polynomial of degree {number}"
                )))
        }
        _ => Ok(()),
    }
}
