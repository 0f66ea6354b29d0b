//! Entries of lists, matrices and curves: `b_0`, `b[0]`, `M_{1,2}`, `M_{12}`, `c(t)_0`.
//!
//! Lists count from 0, as control points do; matrices from 1, as in books. The entries of a curve
//! are its control points.

use super::arguments::Arguments;
use super::machine::{Evaluated, Machine};
use super::names::{indices_in_brackets, letters_side_by_side};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::lexicon::roles;
use crate::language::value::Value;

/// An index with a value.
struct Index {
    value: i64,
    /// Its digits, where each might be an index: 12 in `M_{12}`.
    digits: Option<Vec<i64>>,
    span: Span,
}

/// What brackets behind lists and matrices tell of the number of the first entry.
#[derive(Debug, Default)]
pub(super) struct Counted {
    /// A 0 was among the indices, so that it is known how they count.
    told: bool,
    /// Where an index has another meaning if it counts otherwise.
    place: Option<(Span, &'static str)>,
}

impl Machine {
    /// Remembers `v[2]`, which is another entry where indices count from 1.
    fn counts(&mut self, value: &Value, indices: &[Expr], whole: &Expr) {
        let numbers: Option<Vec<i64>> = indices_in_brackets(indices).iter().map(Expr::as_int).collect();
        let Some(numbers) = numbers.filter(|_| is_bracketed(indices)) else { return };
        self.counted.told |= numbers.contains(&0);
        let how = match value {
            Value::List(_) => "items of a list count from 0",
            Value::Matrix(_) => "rows and columns count from 1",
            _ => return,
        };
        self.counted.place.get_or_insert((whole.span, how));
    }

    /// The remark how indices count, where nothing in the statement tells it.
    pub(super) fn told_how_indices_count(&mut self) {
        let Counted { told, place } = std::mem::take(&mut self.counted);
        if let (Some((span, how)), false) = (place, told) {
            self.note(Diagnostic::note(Code::StandardMeaning, how).at(span));
        }
    }

    /// The entry of a formula that is no name: `c(t)_0`, `[1, 4, 9][1]`.
    pub(super) fn entry_of(&mut self, base: &Expr, indices: &[Expr], whole: &Expr) -> Evaluated {
        let value = self.eval(base)?;
        match self.entry(&value, indices, whole)? {
            Some(entry) => Ok(entry),
            None if is_bracketed(indices) => Err(factor_or_index(whole)),
            None => Err(Diagnostic::error(Code::Type, format!("{} has no entries", value.kind()))
                .at(base.span)
                .reason(format!("this is {}", value.kind()))
                .hint("lists, matrices and curves have entries: b_0, M_{1,2}")),
        }
    }

    /// Refuses `t[1 - t]`, which may be an index or a product, for a name t without entries.
    pub(super) fn is_plain_index(&mut self, expr: &Expr) -> Result<(), Diagnostic> {
        let Kind::Subscript(base, indices) = &expr.kind else { return Ok(()) };
        let plain = |machine: &mut Machine, index: &Expr| {
            matches!(index.kind, Kind::Name(_)) || machine.eval_int(index).is_ok()
        };
        if is_bracketed(indices) {
            // t[1, 2] may be t times a point.
            if indices_in_brackets(indices).len() > 1 {
                return Err(factor_or_index(expr));
            }
            for index in indices_in_brackets(indices) {
                if !plain(self, index) {
                    return Err(factor_or_index(expr));
                }
            }
        }
        self.is_plain_index(base)
    }

    /// The entry of a value; `None` if such values have no entries.
    pub(super) fn entry(
        &mut self,
        value: &Value,
        indices: &[Expr],
        whole: &Expr,
    ) -> Result<Option<Value>, Diagnostic> {
        if !matches!(value, Value::List(_) | Value::Matrix(_) | Value::Geometry(_)) {
            return Ok(None);
        }
        if !self.has_reading() {
            self.counts(value, indices, whole);
        }
        let list = indices_in_brackets(indices).iter();
        let list: Vec<Index> = list.map(|index| self.index(index, whole)).collect::<Result<_, _>>()?;
        self.entry_at(value.clone(), &list, whole).map(Some)
    }

    fn index(&mut self, index: &Expr, whole: &Expr) -> Result<Index, Diagnostic> {
        let span = index.span;
        if let Some(letters) = letters_side_by_side(index, self) {
            let digits: Vec<i64> =
                letters.iter().map(|letter| self.eval_int(letter)).collect::<Result<_, _>>().map_err(
                    |_| {
                        Diagnostic::error(Code::BadExponent, "an index without a value")
                            .at(span)
                            .hint("give the letters values, or sum over them")
                    },
                )?;
            let value =
                digits.iter().fold(0_i64, |number, digit| number.saturating_mul(10).saturating_add(*digit));
            return Ok(Index { value, digits: Some(digits), span });
        }
        if let Kind::Name(text) = &index.kind
            && text.bytes().all(|byte| byte.is_ascii_digit())
        {
            let digits: Vec<i64> = text.bytes().map(|byte| i64::from(byte - b'0')).collect();
            return Ok(Index { value: text.parse().unwrap_or(i64::MAX), digits: Some(digits), span });
        }
        let value = self.eval(index)?;
        let Some(value) = value.as_int() else {
            return Err(match is_bracketed(index_list(whole)) && value.as_rational().is_none() {
                true => factor_or_index(whole),
                false => Diagnostic::error(Code::BadExponent, "an index must be an integer")
                    .at(span)
                    .reason(format!("this is {}", value.kind()))
                    .hint("give the index a value, or sum over it: sum(i=0..2, b_i)"),
            });
        };
        let literal = matches!(index.kind, Kind::Number(_)) && value > 9 && !is_bracketed(index_list(whole));
        let digits = literal.then(|| value.to_string().bytes().map(|byte| i64::from(byte - b'0')).collect());
        Ok(Index { value, digits, span })
    }

    fn entry_at(&mut self, value: Value, indices: &[Index], whole: &Expr) -> Evaluated {
        let Some((first, others)) = indices.split_first() else { return Ok(value) };
        match value {
            Value::List(items) => {
                let digits = first
                    .digits
                    .as_deref()
                    .filter(|digits| others.is_empty() && depth(&items) >= digits.len());
                let whole_index = usize::try_from(first.value).ok().and_then(|at| items.get(at));
                if let Some(digits) = digits.filter(|digits| digits.len() > 1) {
                    if whole_index.is_some() && digits[0] != 0 {
                        return Err(Diagnostic::error(Code::AmbiguousProduct, "one index or several?")
                            .at(first.span)
                            .hint("write commas between several indices: p_{1,0}")
                            .hint("write brackets around one: p[10]"));
                    }
                    let single = |&value: &i64| Index { value, digits: None, span: first.span };
                    let list: Vec<Index> = digits.iter().map(single).collect();
                    return self.entry_at(Value::List(items), &list, whole);
                }
                match whole_index {
                    Some(item) => self.entry_at(item.clone(), others, whole),
                    None => Err(out_of_list(items.len(), first.value, whole)),
                }
            }
            Value::Matrix(matrix) => {
                let (rows, columns) = matrix.shape();
                let single = rows == 1 || columns == 1;
                let (i, j) = match (indices, first.digits.as_deref()) {
                    ([only], _) if single && only.value <= (rows * columns) as i64 => match rows {
                        1 => (1, only.value),
                        _ => (only.value, 1),
                    },
                    ([_], Some(&[i, j])) => (i, j),
                    ([i, j], _) => (i.value, j.value),
                    _ => {
                        return Err(Diagnostic::error(Code::Domain, "a matrix has two indices")
                            .at(whole.span)
                            .reason(format!("the matrix is {rows} x {columns}"))
                            .hint("write M_{1,2} for row 1, column 2"));
                    }
                };
                let place = |k: i64| usize::try_from(k).ok().and_then(|k| k.checked_sub(1));
                match place(i).zip(place(j)).and_then(|place| matrix.get(place)) {
                    Some(entry) => Ok(Value::Scalar(entry.clone())),
                    None => {
                        let problem = Diagnostic::error(Code::Domain, "index out of range")
                            .at(whole.span)
                            .reason(format!("the matrix is {rows} x {columns}"))
                            .hint("rows and columns of a matrix count from 1");
                        Err(match rows * columns <= FEW_ENTRIES {
                            true => {
                                let row = |i: usize| {
                                    let entries: Vec<String> =
                                        (0..columns).map(|j| matrix[(i, j)].to_string()).collect();
                                    format!("[{}]", entries.join(", "))
                                };
                                let rows: Vec<String> = (0..rows).map(row).collect();
                                problem.hint(format!(
                                    "lists count from 0: a list of rows is [{}]",
                                    rows.join(", ")
                                ))
                            }
                            false => problem,
                        })
                    }
                }
            }
            Value::Geometry(_) => {
                let mut arguments = Arguments::default();
                arguments.push(value, whole.span);
                let points = self.call_function("control_points", arguments).at(whole.span)?;
                self.entry_at(points, indices, whole)
            }
            other => Err(Diagnostic::error(Code::Type, format!("{} has no entries", other.kind()))
                .at(first.span)
                .reason("an index too many")
                .hint("give one index for each level of lists")),
        }
    }
}

/// A larger matrix makes no hint.
const FEW_ENTRIES: usize = 16;

fn index_list(whole: &Expr) -> &[Expr] {
    match &whole.kind {
        Kind::Subscript(_, indices) => indices,
        _ => &[],
    }
}

pub(super) fn is_bracketed(indices: &[Expr]) -> bool {
    matches!(indices, [Expr { kind: Kind::List(_), .. }])
}

/// How many levels of lists there are at least.
fn depth(items: &[Value]) -> usize {
    let inner = items.iter().map(|item| match item {
        Value::List(items) => depth(items),
        _ => 0,
    });
    1 + inner.min().unwrap_or(0)
}

fn out_of_list(length: usize, index: i64, whole: &Expr) -> Diagnostic {
    let problem = Diagnostic::error(Code::Domain, "index out of range")
        .reason(format!("the list has {length} items, counted from 0"))
        .at(whole.span);
    match length.checked_sub(1) {
        Some(last) if index < 0 => problem.hint(format!("the last item has the index {last}")),
        Some(last) => problem.hint(format!("the indices go from 0 to {last}")),
        None => problem.hint("the list is empty"),
    }
}

/// The error for `b(0)` with a list b.
pub(super) fn list_called(callee: Span) -> Diagnostic {
    Diagnostic::error(Code::AmbiguousProduct, "is this an item of the list or a product?")
        .at(callee)
        .reason("this is a list")
        .hint("write b[0] or b_0 for an item, counted from 0")
        .hint("or write b * (...) for the product")
}

pub(super) fn factor_or_index(whole: &Expr) -> Diagnostic {
    let error = Diagnostic::error(Code::AmbiguousProduct, "is this an index or a factor?")
        .at(whole.span)
        .reason("square brackets directly after a name");
    let function = match &whole.kind {
        Kind::Subscript(base, _) => match &base.kind {
            Kind::Name(name) if roles::FUNCTIONS.contains(&name.as_str()) => Some(name),
            _ => None,
        },
        _ => None,
    };
    if let Some(name) = function {
        return error.hint(format!("for a divided difference define the function first: {name}(t) := t^2"));
    }
    error
        .hint("for the product write * before the bracket: t * [1, 2]")
        .hint("for an index write b_0, or p_{1,2}")
}
