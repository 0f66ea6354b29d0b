//! What a written name refers to.

use super::machine::{Evaluated, Machine};
use crate::formula::{Accent, Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::lexicon::letters;
use crate::language::value::Value;
use crate::math::poly::{Index, Symbol};

/// Functions somebody may expect that have no exact rational values.
const TRANSCENDENTAL: &[&str] = &["sqrt", "root", "sin", "cos", "tan", "exp", "log", "ln", "arctan"];

/// Whether an undefined name may stand for itself.
pub(crate) fn stands_for_itself(name: &str) -> bool {
    name.chars().count() == 1 || letters::sign(name).is_some()
}

/// The symbol a name denotes, its indices evaluated as far as they have values:
/// `t_i` is `t_2` when i is 2. `None` if the expression is not a name.
pub fn name_of(expr: &Expr, machine: &mut Machine) -> Option<Symbol> {
    match &expr.kind {
        Kind::Name(name) => Some(Symbol::new(name)),
        Kind::Subscript(base, indices) => {
            let base = name_of(base, machine)?;
            let indices: Option<Vec<Index>> = indices.iter().map(|index| index_of(index, machine)).collect();
            Some(base.with_indices(indices?))
        }
        Kind::Upper(base, indices) => {
            let base = name_of(base, machine)?;
            let indices: Option<Vec<Index>> = indices.iter().map(|index| index_of(index, machine)).collect();
            Some(base.with_upper(indices?))
        }
        Kind::Accent(Accent::Bold, body) | Kind::Group(body) if !matches!(body.kind, Kind::Group(_)) => {
            name_of(body, machine)
        }
        Kind::Accent(accent, body) => Some(name_of(body, machine)?.with_accent(accent.name())),
        _ => None,
    }
}

/// An index as part of a name: an integer if it has such a value, else its own name.
fn index_of(expr: &Expr, machine: &mut Machine) -> Option<Index> {
    if let Kind::Name(name) = &expr.kind
        && name.starts_with(|c: char| c.is_ascii_digit())
    {
        return Some(Index::Word(name.clone()));
    }
    // An index such as π(1) is not a product: without a value for π it says nothing.
    if let Kind::Apply(callee, _) = &expr.kind
        && name_of(callee, machine).is_some_and(|name| machine.lookup(&name).is_none())
    {
        return None;
    }
    match machine.eval(expr).ok()? {
        Value::Scalar(value) => match Value::Scalar(value.clone()).as_int() {
            Some(i) => Some(Index::Number(i)),
            None => Some(Index::Word(value.to_string())),
        },
        Value::Function(_) | Value::Builtin(_) => match &expr.kind {
            Kind::Name(name) => Some(Index::Word(name.clone())),
            _ => None,
        },
        Value::Text(text) => Some(Index::Word(text)),
        _ => None,
    }
}

impl Machine {
    /// The value of a name, or the symbol that stands for it.
    pub(crate) fn eval_name(&mut self, expr: &Expr) -> Evaluated {
        let Some(symbol) = name_of(expr, self) else {
            return Err(Diagnostic::error(Code::Type, "only names can have indices")
                .at(expr.span)
                .reason("not a name"));
        };
        if let Some(value) = self.lookup(&symbol) {
            return Ok(value.clone());
        }
        if let Some(value) = self.indexed_value(expr)? {
            return Ok(value);
        }
        if stands_for_itself(symbol.base()) || !symbol.accent().is_empty() {
            return Ok(Value::symbol(symbol));
        }
        if !symbol.is_plain() {
            return Err(self.unknown_name(symbol.base(), expr));
        }
        if (self.tools.is_word)(symbol.base()) {
            return Ok(Value::Text(symbol.base().to_owned()));
        }
        match (self.tools.function)(symbol.base()) {
            Some(function) => Ok(Value::Builtin(function.name())),
            None => Err(self.unknown_name(symbol.base(), expr)),
        }
    }

    /// `b_2` or `M_{1,2}` for a defined list or matrix, `F^{(2)}` for a function.
    fn indexed_value(&mut self, expr: &Expr) -> Result<Option<Value>, Diagnostic> {
        let (base, indices, upper) = match &expr.kind {
            Kind::Subscript(base, indices) => (base, indices, false),
            Kind::Upper(base, indices) => (base, indices, true),
            _ => return Ok(None),
        };
        let Some(value) = name_of(base, self).and_then(|name| self.lookup(&name).cloned()) else {
            return Ok(None);
        };
        if upper {
            return match (&value, indices.as_slice()) {
                (Value::Function(_), [order]) => {
                    let order = self.eval_int(order)?;
                    let order = usize::try_from(order).map_err(|_| {
                        Diagnostic::error(Code::BadExponent, "a negative order of differentiation")
                            .at(expr.span)
                    })?;
                    self.derivative_of(&value, order, expr.span).map(Some)
                }
                _ => Ok(None),
            };
        }
        let numbers: Option<Vec<usize>> = indices
            .iter()
            .map(|index| self.eval_int(index).ok().and_then(|i| usize::try_from(i).ok()))
            .collect();
        let out_of_range =
            |count: String| Diagnostic::error(Code::Domain, "index out of range").reason(count).at(expr.span);
        match (&value, numbers.as_deref()) {
            // Lists count from 0, as control points do; matrices from 1, as in books.
            (Value::List(items), Some([i])) => {
                items.get(*i).cloned().map(Some).ok_or_else(|| {
                    out_of_range(format!("the list has {} items, counted from 0", items.len()))
                })
            }
            (Value::Matrix(matrix), Some([i, j])) => {
                let entry = i.checked_sub(1).zip(j.checked_sub(1)).and_then(|place| matrix.get(place));
                entry.cloned().map(|x| Some(Value::Scalar(x))).ok_or_else(|| {
                    out_of_range(format!("the matrix is {} x {}", matrix.nrows(), matrix.ncols()))
                })
            }
            _ => Ok(None),
        }
    }

    /// The error for a word without meaning, with the nearest known one.
    pub(crate) fn unknown_name(&self, name: &str, expr: &Expr) -> Diagnostic {
        let error = Diagnostic::error(Code::UnknownName, format!("'{name}' is not defined"))
            .at(expr.span)
            .reason("unknown name");
        let known = self.scope.keys().map(Symbol::base).chain((self.tools.names)());
        match (self.tools.synonym)(name)
            .or_else(|| nearest(name, known).filter(|_| name != "minus" && name != "plus"))
        {
            Some(best) => error.hint(format!("did you mean '{best}'?")),
            None if name == "minus" || name == "plus" => {
                error.hint("an exponent of several characters needs braces: t^{-1}")
            }
            None if TRANSCENDENTAL.contains(&name) => error
                .hint("only polynomials and rational functions with rational coefficients are exact here"),
            None if name.chars().all(|c| c.is_ascii_lowercase()) && name.len() <= 3 => {
                let spaced: Vec<String> = name.chars().map(String::from).collect();
                error.hint(format!("for a product of symbols write '{}'", spaced.join(" ")))
            }
            None => error.hint(format!("define it first: {name} := ...")),
        }
    }
}
