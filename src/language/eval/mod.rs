//! From a formula to its value.
//!
//! The formula tree says what was written; this module decides what it means, by the
//! names that are defined: `f(t + 1)` is a value when f is a function here and a product
//! when f is a scalar. Mathematical errors know no place; they get it here, with
//! [`At`].
//!
//! Names without a value stand for themselves: single letters, Greek letters and anything
//! with a subscript are symbols. Other unknown words are errors, with the nearest known
//! name as a hint.

mod apply;
pub(crate) mod arguments;
pub(crate) mod arithmetic;
pub(crate) mod calculus;
pub(crate) mod claim;
pub(crate) mod curves;
mod define;
mod family;
pub(crate) mod geometry;
pub(crate) mod names;
mod products;
mod same_geometry;

use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

pub use arguments::Arguments;
pub(crate) use calculus::nth_derivative;
pub(crate) use claim::{find_witness, judge};
pub use names::name_of;

use crate::formula::source::Span;
use crate::formula::{Accent, Delimiter, Enclosure, Expr, Kind, Rel, Sign};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::value::{Claim, Scope, Value};
use crate::math::number::Rational;
use crate::math::poly::Symbol;
use nalgebra::DMatrix;

/// Room on the stack below which a new segment is taken, and its size.
const RED_ZONE: usize = 256 * 1024;
const SEGMENT: usize = 4 * 1024 * 1024;

/// The names defined so far. Cloning is cheap.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Env {
    names: Scope,
}

impl Env {
    /// The value of a name, if it is defined.
    pub fn get(&self, name: &Symbol) -> Option<&Value> {
        self.names.get(name)
    }

    /// Defines or redefines a name.
    pub fn set(&mut self, name: Symbol, value: Value) {
        Arc::make_mut(&mut self.names).insert(name, value);
    }

    /// Forgets a name; says whether it was defined.
    pub fn remove(&mut self, name: &Symbol) -> bool {
        Arc::make_mut(&mut self.names).remove(name).is_some()
    }

    /// All defined names in natural order.
    pub fn iter(&self) -> impl Iterator<Item = (&Symbol, &Value)> {
        self.names.iter()
    }
}

/// What a statement did.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its value.
    pub value: Value,
    /// The name it defined, if it was a definition.
    pub defined: Option<Symbol>,
    /// Remarks: readings that somebody might not expect.
    pub notes: Vec<Diagnostic>,
}

/// How `=` is understood at the top of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equals {
    /// An unbound name on its left is defined.
    DefinesUnbound,
    /// Always a claim.
    Claims,
}

/// Evaluates one statement and, if it is a definition, adds it to `env`.
///
/// `env` is changed only on success. Limits are those of [`crate::budget::run`] around it.
///
/// # Errors
/// A [`Diagnostic`] with its place.
pub fn evaluate(expr: &Expr, env: &mut Env, equals: Equals) -> Result<Outcome, Diagnostic> {
    let mut machine = Machine::new(env.names.clone());
    let (value, defined) = machine.statement(expr, equals)?;
    if let Some(name) = &defined {
        env.set(name.clone(), value.clone());
    }
    Ok(Outcome { value, defined, notes: machine.notes })
}

/// A way of understanding formulas that goes before the usual one: it may give names, calls and
/// notations a meaning that they do not have in the language. Lecture notes are read like this.
pub trait Reading {
    /// The value of a formula, or `None` to leave it to the language. Parts of it are evaluated
    /// with [`Machine::eval`], which asks this reading again.
    fn eval(&self, machine: &mut Machine, expr: &Expr) -> Option<Result<Value, Diagnostic>>;
}

/// The value of a formula under a reading, with some names bound.
///
/// # Errors
/// A [`Diagnostic`] with its place.
pub fn evaluate_reading(
    expr: &Expr,
    reading: Rc<dyn Reading>,
    names: impl IntoIterator<Item = (Symbol, Value)>,
) -> Result<Value, Diagnostic> {
    let mut machine = Machine::new(Scope::default());
    machine.reading = Some(reading);
    machine.with_locals(names, |machine| machine.eval(expr))
}

/// Runs `work` with a fresh evaluator in which some names are bound.
pub fn with_machine<T>(
    names: impl IntoIterator<Item = (Symbol, Value)>,
    work: impl FnOnce(&mut Machine) -> T,
) -> T {
    let mut machine = Machine::new(Scope::default());
    machine.locals.extend(names);
    work(&mut machine)
}

/// The state of one evaluation.
pub struct Machine {
    reading: Option<Rc<dyn Reading>>,
    scope: Scope,
    /// Local names, innermost last.
    locals: Vec<(Symbol, Value)>,
    depth: usize,
    notes: Vec<Diagnostic>,
    /// Values of functions of numbers already computed in this statement.
    memo: BTreeMap<(Symbol, Vec<Rational>), Value>,
}

pub(crate) type Evaluated = Result<Value, Diagnostic>;

impl Machine {
    fn new(scope: Scope) -> Self {
        Machine {
            reading: None,
            scope,
            locals: Vec::new(),
            depth: 0,
            notes: Vec::new(),
            memo: BTreeMap::new(),
        }
    }

    /// The value of a name where we are.
    pub fn lookup(&self, name: &Symbol) -> Option<&Value> {
        let local = self.locals.iter().rev().find(|(n, _)| n == name).map(|(_, value)| value);
        local.or_else(|| self.scope.get(name))
    }

    /// Runs `work` with some names bound.
    ///
    /// # Errors
    /// Those of the work.
    pub fn with_locals<T>(
        &mut self,
        names: impl IntoIterator<Item = (Symbol, Value)>,
        work: impl FnOnce(&mut Self) -> Result<T, Diagnostic>,
    ) -> Result<T, Diagnostic> {
        let before = self.locals.len();
        self.locals.extend(names);
        let result = work(self);
        self.locals.truncate(before);
        result
    }

    pub(crate) fn note(&mut self, note: Diagnostic) {
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    fn statement(&mut self, expr: &Expr, equals: Equals) -> Result<(Value, Option<Symbol>), Diagnostic> {
        if let Kind::Chain(left, links) = &expr.kind {
            let defines = links[0].rel == Rel::Define
                || (equals == Equals::DefinesUnbound
                    && links[0].rel == Rel::Eq
                    && self.is_new_definition(left, &links[0].expr));
            if defines {
                return self.define(left, links).map(|(name, value)| (value, Some(name)));
            }
        }
        self.eval(expr).map(|value| (value, None))
    }

    /// The value of an expression.
    ///
    /// # Errors
    /// A [`Diagnostic`] with its place.
    pub fn eval(&mut self, expr: &Expr) -> Evaluated {
        crate::budget::step();
        stacker::maybe_grow(RED_ZONE, SEGMENT, || {
            if let Some(reading) = self.reading.clone()
                && let Some(result) = reading.eval(self, expr)
            {
                return result;
            }
            self.eval_kind(expr)
        })
    }

    fn eval_kind(&mut self, expr: &Expr) -> Evaluated {
        let span = expr.span;
        match &expr.kind {
            Kind::Number(q) => {
                crate::budget::charge_bits(q.numer().bits().max(q.denom().bits()));
                Ok(Value::number(q.clone()))
            }
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) => self.eval_name(expr),
            Kind::Accent(accent, body) => self.eval_accent(*accent, body, expr),
            Kind::Group(body) => self.eval(body),
            Kind::Add(terms) => {
                let mut sum: Option<Value> = None;
                for term in terms {
                    let value = self.eval(&term.expr)?;
                    let place = term.expr.span;
                    sum = Some(match (sum, term.sign) {
                        (None, Sign::Plus) => value,
                        (None, Sign::Minus) => arithmetic::negate(value).at(place)?,
                        (Some(sum), Sign::Plus) => arithmetic::add(sum, value).at(place)?,
                        (Some(sum), Sign::Minus) => {
                            let negative = arithmetic::negate(value).at(place)?;
                            arithmetic::add(sum, negative).at(place)?
                        }
                    });
                }
                sum.ok_or_else(|| Diagnostic::error(Code::Empty, "an empty sum").at(span))
            }
            Kind::Mul(factors) => self.eval_product(factors, span),
            Kind::Div(left, right, style) => self.eval_quotient(left, right, *style),
            Kind::Pow(base, exponent) => self.eval_power(base, exponent, span),
            Kind::Apply(callee, groups) => self.eval_apply(callee, groups, expr),
            Kind::Tuple(items) | Kind::List(items) | Kind::Sequence(items) => {
                self.expand_items(items).and_then(|values| together(values).at(span))
            }
            Kind::Matrix(rows, delimiter) => self.eval_matrix(rows, *delimiter, span),
            Kind::Binomial(n, k, _) => {
                let (n, k) = (self.eval(n)?, self.eval(k)?);
                arithmetic::binomial(&n, &k).at(span)
            }
            Kind::Factorial(body) => self.eval_factorial(body),
            Kind::Enclosed(enclosure, body) => self.eval_enclosed(*enclosure, body),
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
                let mut result = self.eval(&items[0])?;
                for item in &items[1..] {
                    let inner = self.eval(item)?;
                    result = self.compose(result, inner).at(item.span)?;
                }
                Ok(result)
            }
            Kind::Prime(body, order) => {
                let value = self.eval(body)?;
                if value.as_rational().is_some() {
                    return Err(Diagnostic::error(Code::Type, "a number has no derivative")
                        .at(span)
                        .reason("the prime belongs to this number")
                        .hint("write (t^2)' or diff(t^2, t) for the derivative of a power"));
                }
                // The derivative of an undefined F is not that of a variable F.
                if let Kind::Name(name) = &body.kind
                    && arguments::symbol_of(&value).is_some_and(|symbol| symbol == Symbol::new(name))
                {
                    return Err(self.unknown_name(name, body));
                }
                calculus::derivative_of_function(&value, *order as usize).at(body.span)
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
            Kind::Chain(first, links) => {
                let judgements = self.judge_chain(first, links)?;
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
                Ok(Value::List(items))
            }
            Kind::ForAll(..) => Err(unsupported("quantifiers are not evaluated").at(span)),
            Kind::Unread(text) => Err(Diagnostic::error(
                Code::UnsupportedLatex,
                format!("this piece could not be read: {text}"),
            )
            .at(span)),
        }
    }

    fn eval_accent(&mut self, accent: Accent, body: &Expr, whole: &Expr) -> Evaluated {
        match accent {
            Accent::Bold => self.eval(body),
            Accent::Hat => {
                // v̂ := p - q defines a name of its own, whose value is a vector.
                if let Some(name) = name_of(whole, self)
                    && let Some(value) = self.lookup(&name)
                {
                    return Ok(vector(value.clone()).unwrap_or_else(|other| other));
                }
                let value = self.eval(body)?;
                vector(value).map_err(|other| {
                    wrong_kind("a number, symbol or point under the hat", &other).at(body.span)
                })
            }
            Accent::Dot => {
                let value = self.eval(body)?;
                calculus::derivative_of_function(&value, 1).at(body.span)
            }
            Accent::Ddot => {
                let value = self.eval(body)?;
                calculus::derivative_of_function(&value, 2).at(body.span)
            }
            Accent::Bar | Accent::Vec | Accent::Tilde | Accent::Script | Accent::Blackboard => {
                match name_of(whole, self) {
                    Some(name) => Ok(self.lookup(&name).cloned().unwrap_or_else(|| Value::symbol(name))),
                    None => Err(unsupported("an accent over more than a name").at(whole.span)),
                }
            }
        }
    }

    /// Items of a list, with `a_1, ..., a_n` and underbraces written out.
    pub(crate) fn expand_items(&mut self, items: &[Expr]) -> Result<Vec<Value>, Diagnostic> {
        let mut values = Vec::with_capacity(items.len());
        let mut skip = false;
        for (at, item) in items.iter().enumerate() {
            if std::mem::take(&mut skip) {
                continue;
            }
            match &item.kind {
                Kind::Ellipsis => {
                    let (Some(before), Some(after)) =
                        (at.checked_sub(1).map(|i| &items[i]), items.get(at + 1))
                    else {
                        return Err(unsupported("an ellipsis needs an item on both sides")
                            .at(item.span)
                            .hint("write the first and the last item: t1, ..., t5"));
                    };
                    let too_many = self.fill_ellipsis(before, after, &mut values, item.span)?;
                    skip = too_many > 0;
                    if too_many > 1 {
                        values.pop();
                    }
                }
                Kind::Brace(list, label) => {
                    let label = label.as_deref();
                    values.extend(self.repeated(list, label, item.span)?);
                }
                _ => values.push(self.eval(item)?),
            }
        }
        Ok(values)
    }

    /// `t, ..., t` with a count below the brace.
    fn repeated(
        &mut self,
        items: &[Expr],
        label: Option<&Expr>,
        span: Span,
    ) -> Result<Vec<Value>, Diagnostic> {
        let plain: Vec<&Expr> = items.iter().filter(|item| item.kind != Kind::Ellipsis).collect();
        let same = plain.windows(2).all(|pair| pair[0].same_as(pair[1]));
        match (label, plain.first()) {
            (Some(label), Some(item)) if same => {
                let count = self.eval_int(label)?;
                let count = usize::try_from(count).map_err(|_| {
                    Diagnostic::error(Code::Domain, format!("{count} copies make no sense")).at(label.span)
                })?;
                crate::budget::charge_terms(count as u64);
                Ok(vec![self.eval(item)?; count])
            }
            (Some(_), Some(_)) => self.expand_items(items),
            (None, Some(_)) if plain.len() == items.len() => self.expand_items(items),
            _ => Err(unsupported("how many copies the brace stands for is not said")
                .at(span)
                .hint("write the number below the brace: \\underbrace{t,\\ldots,t}_{3}")),
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
            Delimiter::Bar => crate::math::linalg::determinant(&matrix)
                .map(Value::Scalar)
                .map_err(arithmetic::linalg)
                .at(span),
            _ => Ok(Value::Matrix(matrix)),
        }
    }

    fn eval_enclosed(&mut self, enclosure: Enclosure, body: &Expr) -> Evaluated {
        let value = self.eval(body)?;
        if enclosure == Enclosure::Abs
            && let Value::Matrix(matrix) = &value
        {
            return crate::math::linalg::determinant(matrix)
                .map(Value::Scalar)
                .map_err(arithmetic::linalg)
                .at(body.span);
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
                    Value::Claim(claim) => claim::decided(&claim).ok_or_else(|| {
                        Diagnostic::error(Code::Undecided, "whether this case holds depends on symbols")
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

    /// The integer an expression denotes.
    ///
    /// # Errors
    /// What is wrong with the expression, or that its value is no integer.
    pub fn eval_int(&mut self, expr: &Expr) -> Result<i64, Diagnostic> {
        let value = self.eval(expr)?;
        value.as_int().ok_or_else(|| wrong_kind("an integer", &value).at(expr.span))
    }
}

/// A list of values; several claims side by side are one claim with all their relations.
pub(crate) fn together(values: Vec<Value>) -> Evaluated {
    let claims = values.iter().filter(|value| matches!(value, Value::Claim(_))).count();
    if claims == 0 {
        return Ok(Value::List(values));
    }
    let words = values.iter().filter(|value| matches!(value, Value::Text(_))).count();
    if claims + words < values.len() {
        return Err(unsupported("a claim among other things").hint(
            "give claims one at a time; a condition such as i = 0 goes before them: --given \"i := 0\"",
        ));
    }
    let judgements = values.into_iter().flat_map(|value| match value {
        Value::Claim(claim) => claim.judgements.clone(),
        _ => Vec::new(),
    });
    Ok(Value::Claim(Arc::new(Claim { judgements: judgements.collect() })))
}

/// The vector with the given coordinates; anything else comes back.
pub(crate) fn vector(value: Value) -> Result<Value, Value> {
    match value {
        Value::Scalar(v) => Ok(Value::Vector(v)),
        Value::List(items) => items.into_iter().map(vector).collect::<Result<_, _>>().map(Value::List),
        other => Err(other),
    }
}

/// "expected X, found Y".
pub(crate) fn wrong_kind(expected: &str, found: &Value) -> Diagnostic {
    Diagnostic::error(Code::Type, format!("expected {expected}, found {}", found.kind()))
        .reason(format!("this is {}", found.kind()))
}

pub(crate) fn unsupported(what: &str) -> Diagnostic {
    Diagnostic::error(Code::Unsupported, what)
}
