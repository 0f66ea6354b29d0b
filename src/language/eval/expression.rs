//! The value of each kind of formula.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::lambda::{is_mapping, parameters_of};
use super::machine::{Evaluated, Machine};
use super::names::{name_of, stands_for_itself};
use super::products::without_power;
use crate::formula::source::Span;
use crate::formula::{Accent, BinomialStyle, Delimiter, Enclosure, Expr, Kind, Sign};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::lexicon::families::BINOMIAL_COEFFICIENT;
use crate::language::lexicon::roles;
use crate::language::ops::errors::{linalg_error, unsupported, wrong_kind};
use crate::language::ops::formula::symbol_of;
use crate::language::ops::{arithmetic, lists};
use crate::language::value::{Claim, Value};
use crate::math::linalg::determinant;
use crate::math::number::exact_root;
use crate::math::poly::{Fraction, Symbol};

impl Machine {
    pub(super) fn eval_kind(&mut self, expr: &Expr) -> Evaluated {
        let span = expr.span;
        if let Some(product) = self.spelled_out(expr)? {
            return self.eval(&product);
        }
        match &expr.kind {
            Kind::Number(q) => {
                crate::budget::charge_bits(q.numer().bits().max(q.denom().bits()));
                Ok(Value::number(q.clone()))
            }
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) => match self.difference_of_lambda(expr)? {
                Some(difference) => Ok(difference),
                None => self.eval_name(expr),
            },
            Kind::Accent(accent, body) => self.eval_accent(*accent, body, expr),
            Kind::Group(body) => self.eval(body),
            Kind::Add(terms) if terms.iter().any(|term| term.expr.kind == Kind::Ellipsis) => {
                self.sum_with_dots(terms, span)
            }
            Kind::Add(terms) => {
                let mut sum: Option<Value> = None;
                for term in terms {
                    let value = self.eval(&term.expr)?;
                    let place = term.expr.span;
                    sum = Some(match (sum, term.sign) {
                        (None, Sign::Plus) => value,
                        (None, Sign::Minus) => arithmetic::negate(value).at(place)?,
                        (Some(sum), Sign::Plus) => self.added(sum, value, place)?,
                        (Some(sum), Sign::Minus) => {
                            let negative = arithmetic::negate(value).at(place)?;
                            self.added(sum, negative, place)?
                        }
                    });
                }
                sum.ok_or_else(|| Diagnostic::error(Code::Empty, "an empty sum").at(span))
            }
            Kind::Mul(factors) if factors.iter().any(|factor| factor.kind == Kind::Ellipsis) => {
                self.product_with_dots(factors, span)
            }
            Kind::Mul(factors) => self.eval_product(factors, span),
            Kind::Div(left, right, style) => self.eval_quotient(left, right, *style),
            Kind::Pow(base, exponent) => self.eval_power(base, exponent, span),
            Kind::Apply(callee, groups) => self.eval_apply(callee, groups, expr),
            Kind::Tuple(items) if items.is_empty() => {
                Err(Diagnostic::error(Code::Empty, "nothing stands between the brackets")
                    .at(span)
                    .hint("an empty list is written [ ]"))
            }
            // [1..5] is the list of these numbers, as 1..5 is.
            Kind::List(items) if matches!(items.as_slice(), [Expr { kind: Kind::Range(..), .. }]) => {
                self.eval(&items[0])
            }
            Kind::Tuple(items) => {
                let values = self.expand_items(items)?;
                Ok(match lists::together(values).at(span)? {
                    Value::List(coordinates) => Value::point(coordinates.into_iter().collect()),
                    other => other,
                })
            }
            Kind::List(items) | Kind::Sequence(items) => {
                self.expand_items(items).and_then(|values| lists::together(values).at(span))
            }
            Kind::Matrix(rows, delimiter) => self.eval_matrix(rows, *delimiter, span),
            Kind::Binomial(n, k, BinomialStyle::Subscripted) if self.is_power_of_c(n, span)? => {
                let letter = Expr::new(Kind::Name(BINOMIAL_COEFFICIENT.to_owned()), span);
                let base = Expr::new(Kind::Subscript(Box::new(letter), vec![n.as_ref().clone()]), span);
                self.eval_power(&base, k, span)
            }
            Kind::Binomial(n, k, _) => {
                let (n, k) = (self.eval(n)?, self.eval(k)?);
                arithmetic::binomial(&n, &k).at(span)
            }
            Kind::Factorial(body) => self.eval_factorial(body),
            Kind::Enclosed(enclosure, body) => match self.size_of_part(body) {
                Some(size) => Ok(Value::int(size as i64)),
                None => self.eval_enclosed(*enclosure, body),
            },
            Kind::Big { op, lower, upper, body } => self.eval_big(*op, lower, upper.as_deref(), body, span),
            Kind::Integral { lower, upper, body, variable } => {
                self.eval_integral(lower.as_deref(), upper.as_deref(), body, variable)
            }
            Kind::Derivative { variables, body, .. } => {
                self.eval_derivative(variables, body.as_deref(), span)
            }
            Kind::At { body, lower, upper } => self.eval_at(body, lower, upper.as_deref(), span),
            Kind::Cases(cases) => self.eval_cases(cases, span),
            Kind::Compose(items) => {
                self.is_no_unknown_composed(items)?;
                let mut result = self.eval(&items[0])?;
                for item in &items[1..] {
                    let inner = self.eval(item)?;
                    result = self.compose(result, inner, item.span)?;
                }
                Ok(result)
            }
            Kind::Prime(body, order) => {
                if let Some(member) = self.member(without_group(body))? {
                    return self.derivative_of(&member, *order as usize, body.span);
                }
                let value = self.eval(body)?;
                // A' as MATLAB has it; entries with letters may be meant as functions.
                if let (Value::Matrix(matrix), 1) = (&value, *order)
                    && matrix.iter().all(|entry| entry.as_rational().is_some())
                {
                    let note = "a prime at a matrix of numbers is read as its transpose";
                    self.note(Diagnostic::note(Code::StandardMeaning, note).at(span));
                    return arithmetic::transpose(value).at(span);
                }
                if value.as_rational().is_some() {
                    return Err(Diagnostic::error(Code::Type, "a number has no derivative")
                        .at(span)
                        .reason("the prime belongs to this number")
                        .hint("write (t^2)' or diff(t^2, t) for the derivative of a power"));
                }
                // The derivative of an undefined F is not that of a variable F.
                let power = without_power(without_group(body));
                let member = matches!(power.kind, Kind::Subscript(..)) && power.span != body.span;
                if let Some(symbol) = name_of(if member { power } else { body }, self).filter(|symbol| {
                    self.reading.is_none() && !(member && roles::is_parameter(symbol.base()))
                }) && (member && self.lookup(&symbol).is_none()
                    || symbol_of(&value).is_some_and(|found| found == symbol))
                {
                    return Err(Diagnostic::error(Code::UnknownName, format!("'{symbol}' is not defined"))
                        .at(body.span)
                        .reason("what is differentiated?")
                        .hint(format!("define it first: {symbol}(t) := ..."))
                        .hint("a name may have the prime in its index: a_{b'}"));
                }
                self.derivative_of(&value, *order as usize, body.span)
            }
            Kind::Transpose(body) => {
                let value = self.eval(body)?;
                arithmetic::transpose(value).at(body.span)
            }
            Kind::Range(from, to) => {
                let (from, to) = (self.eval_int(from)?, self.eval_int(to)?);
                crate::budget::charge_terms(to.saturating_sub(from).max(0) as u64);
                Ok(Value::List((from..=to).map(Value::int).collect()))
            }
            Kind::Lambda(parameters, body) => self.eval_lambda(parameters, body),
            Kind::Chain(parameters, links) if self.reading.is_none() && is_mapping(links) => {
                self.eval_lambda(parameters_of(parameters), &links[0].expr)
            }
            Kind::Chain(first, links) => {
                let before = std::mem::take(&mut self.answers);
                let judgements = match self.of_one_kind(first, links) {
                    Some((first, links)) => (self.tools.judge)(self, &first, &links),
                    None => (self.tools.judge)(self, first, links),
                };
                self.answers = before;
                let judgements = judgements?;
                Ok(Value::Claim(Arc::new(Claim { judgements })))
            }
            Kind::Text(text) => Ok(Value::Text(text.clone())),
            Kind::Cross(items) => {
                let mut product = self.eval(&items[0])?;
                for item in &items[1..] {
                    let value = self.eval(item)?;
                    product = arithmetic::cross(product, value).at(item.span)?;
                }
                Ok(product)
            }
            Kind::Set(..) => Err(unsupported("sets have no value of their own here").at(span)),
            Kind::Ellipsis => Err(unsupported("an ellipsis can stand only between the items of a list")
                .at(span)
                .hint("write the items out, or an argument list such as f(t1, ..., t4)")),
            Kind::Brace(items, label) => {
                let items = self.repeated(items, label.as_deref(), span)?;
                Ok(Value::list(items))
            }
            Kind::ForAll(..) => Err(unsupported("quantifiers are not evaluated").at(span)),
            Kind::Unread(text) => Err(Diagnostic::error(
                Code::UnsupportedLatex,
                format!("this piece could not be read: {text}"),
            )
            .at(span)),
        }
    }

    /// Refuses f ∘ g for an f without a value: as a symbol it would be a constant.
    fn is_no_unknown_composed(&mut self, items: &[Expr]) -> Result<(), Diagnostic> {
        if self.has_reading() {
            return Ok(());
        }
        for item in items {
            let name = name_of(item, self).filter(|name| !roles::is_parameter(name.base()));
            if let Some(name) = name.filter(|name| self.lookup(name).is_none())
                && stands_for_itself(name.base())
            {
                return Err(Diagnostic::error(Code::UnknownName, format!("'{name}' has no value here"))
                    .at(item.span)
                    .reason("what is composed?")
                    .hint(format!("define it first: {name}(t) := t^2")));
            }
        }
        Ok(())
    }

    /// Whether `C_n^k` is a power: C, or C_n, has a value. Otherwise it is a binomial coefficient.
    fn is_power_of_c(&mut self, index: &Expr, span: Span) -> Result<bool, Diagnostic> {
        let letter = Expr::new(Kind::Name(BINOMIAL_COEFFICIENT.to_owned()), span);
        let base = Expr::new(Kind::Subscript(Box::new(letter), vec![index.clone()]), span);
        let known = self.lookup(&Symbol::new(BINOMIAL_COEFFICIENT)).is_some()
            || name_of(&base, self).is_some_and(|name| self.lookup(&name).is_some());
        if !known {
            self.note(
                Diagnostic::note(Code::StandardMeaning, "read with its standard meaning, binomial(n, k)")
                    .at(span),
            );
        }
        Ok(known)
    }

    fn eval_accent(&mut self, accent: Accent, body: &Expr, whole: &Expr) -> Evaluated {
        match accent {
            Accent::Bold => self.eval(body),
            Accent::Hat => {
                // v̂ := p - q defines a name of its own, whose value is a vector.
                if let Some(name) = name_of(whole, self)
                    && let Some(value) = self.lookup(&name)
                {
                    return Ok(lists::vector(value.clone()).unwrap_or_else(|other| other));
                }
                let value = self.eval(body)?;
                lists::vector(value).map_err(|other| {
                    wrong_kind("a number, symbol or point under the hat", &other).at(body.span)
                })
            }
            // What is differentiated has to be known, as under F'.
            Accent::Dot | Accent::Ddot => {
                let order = if accent == Accent::Dot { 1 } else { 2 };
                self.eval(&Expr::new(Kind::Prime(Box::new(body.clone()), order), whole.span))
            }
            // The vectors 1 - 0 and b - a.
            Accent::Vec if matches!(body.kind, Kind::Number(_)) => self.eval_accent(Accent::Hat, body, whole),
            Accent::Vec if matches!(&body.kind, Kind::Mul(ends) if ends.len() == 2) => {
                let Kind::Mul(ends) = &body.kind else { return self.eval(body) };
                let (from, to) = (self.eval(&ends[0])?, self.eval(&ends[1])?);
                let back = arithmetic::negate(from).at(ends[0].span)?;
                let difference = arithmetic::add(to, back).at(body.span)?;
                lists::vector(difference).map_err(|other| wrong_kind("two points", &other).at(body.span))
            }
            Accent::Bar | Accent::Vec | Accent::Tilde | Accent::Script | Accent::Blackboard => {
                match name_of(whole, self) {
                    Some(name) => Ok(self.lookup(&name).cloned().unwrap_or_else(|| Value::symbol(name))),
                    None => Err(unsupported("an accent over more than a name")
                        .at(whole.span)
                        .hint("an accent belongs over one name, as in \\bar z; the vector from a to b is \\overrightarrow{ab}")),
                }
            }
        }
    }

    fn eval_matrix(&mut self, rows: &[Vec<Option<Expr>>], delimiter: Delimiter, span: Span) -> Evaluated {
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut entries = Vec::new();
        for row in rows {
            for cell in row {
                let Some(cell) = cell else {
                    return Err(Diagnostic::error(Code::Shape, "a matrix with an empty cell").at(span));
                };
                match self.eval(cell)? {
                    Value::Scalar(x) => entries.push(x),
                    other => {
                        return Err(wrong_kind("a number or formula in the matrix", &other).at(cell.span));
                    }
                }
            }
            if row.len() != columns {
                return Err(Diagnostic::error(
                    Code::Shape,
                    format!("a row has {} entries where others have {columns}", row.len()),
                )
                .at(row.first().and_then(Option::as_ref).map_or(span, |cell| cell.span)));
            }
        }
        let matrix = DMatrix::from_row_iterator(rows.len(), columns, entries);
        match delimiter {
            Delimiter::Bar => determinant(&matrix).map(Value::Scalar).map_err(linalg_error).at(span),
            _ => Ok(Value::Matrix(matrix)),
        }
    }

    fn eval_enclosed(&mut self, enclosure: Enclosure, body: &Expr) -> Evaluated {
        let value = self.eval(body)?;
        if enclosure == Enclosure::Abs
            && let Value::Matrix(matrix) = &value
        {
            return determinant(matrix).map(Value::Scalar).map_err(linalg_error).at(body.span);
        }
        // ‖(3, 4)‖; of a vector |…| means the same.
        let column = |matrix: &DMatrix<Fraction>| matrix.ncols() == 1 || matrix.nrows() == 1;
        let value = match value {
            Value::Matrix(matrix) if enclosure == Enclosure::Norm && column(&matrix) => {
                Value::List(matrix.iter().cloned().map(Value::Scalar).collect())
            }
            value => value,
        };
        if let (Enclosure::Norm | Enclosure::Abs, Value::List(items)) = (enclosure, &value) {
            let square = arithmetic::row_times_column(items, items).at(body.span)?;
            return match square.as_rational().map(|square| exact_root(&square, 2)) {
                Some(Some(norm)) => Ok(Value::number(norm)),
                _ => Err(Diagnostic::error(Code::Irrational, "this norm is not rational")
                    .at(body.span)
                    .hint("dot(v, v) is its square")),
            };
        }
        let Some(q) = value.as_rational() else {
            return Err(wrong_kind("a number", &value).at(body.span));
        };
        match enclosure {
            Enclosure::Abs | Enclosure::Norm => Ok(Value::number(num_traits::Signed::abs(&q))),
            Enclosure::Floor => Ok(Value::number(q.floor())),
            Enclosure::Ceil => Ok(Value::number(q.ceil())),
        }
    }

    fn eval_cases(&mut self, cases: &[(Expr, Option<Expr>)], span: Span) -> Evaluated {
        for (value, condition) in cases {
            let holds = match condition {
                None => true,
                Some(condition) => match self.eval(condition)? {
                    Value::Claim(claim) => claim.decided().ok_or_else(|| {
                        Diagnostic::error(Code::Undecided, "whether this case holds depends on symbols")
                            .hint("define a function and take its values: F(x) := ..., then F(3)")
                            .at(condition.span)
                    })?,
                    Value::Text(_) => true,
                    other => return Err(wrong_kind("a condition", &other).at(condition.span)),
                },
            };
            if holds {
                return self.eval(value);
            }
        }
        Err(Diagnostic::error(Code::Domain, "no case applies").at(span))
    }
}

/// What stands in parentheses.
fn without_group(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Group(inner) => without_group(inner),
        _ => expr,
    }
}
