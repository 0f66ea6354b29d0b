//! What a written name refers to.

use super::machine::{Evaluated, Machine};
use crate::formula::{Accent, Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::lexicon::topics::{self, Advice};
use crate::language::lexicon::{letters, words};
use crate::language::ops::function;
use crate::language::value::{Function, Value};
use crate::math::poly::{Index, Symbol};

/// Longer words are not likely to be meant as products of their letters.
const LONGEST_PRODUCT: usize = 5;

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
            Some(base.with_indices(indices_of(indices_in_brackets(indices), machine)?))
        }
        Kind::Upper(base, indices) => {
            let base = name_of(base, machine)?;
            Some(base.with_upper(indices_of(indices, machine)?))
        }
        Kind::Accent(Accent::Bold, body) | Kind::Group(body) if !matches!(body.kind, Kind::Group(_)) => {
            name_of(body, machine)
        }
        // Two accents are no name.
        Kind::Accent(accent, body) => name_of(body, machine)
            .filter(|name| name.accent().is_empty() || machine.has_reading())
            .map(|name| name.with_accent(accent.name())),
        _ => None,
    }
}

/// The indices of `b[0]`, which are those of `b_0`.
pub(super) fn indices_in_brackets(indices: &[Expr]) -> &[Expr] {
    match indices {
        [Expr { kind: Kind::List(items), .. }] => items,
        _ => indices,
    }
}

/// The indices of a member of a family that has `count` of them: `ij` and 12 are two indices each.
pub(super) fn spread(indices: &[Expr], count: usize, machine: &Machine) -> Vec<Expr> {
    let [index] = indices else { return indices.to_vec() };
    if let Some(letters) = letters_side_by_side(index, machine).filter(|letters| letters.len() == count) {
        return letters;
    }
    let digits = match &index.kind {
        Kind::Number(number) if number.is_integer() => number.numer().to_string(),
        Kind::Name(name) => name.clone(),
        _ => return indices.to_vec(),
    };
    if digits.len() != count || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return indices.to_vec();
    }
    digits.bytes().map(|digit| Expr { span: index.span, ..Expr::int(i64::from(digit - b'0')) }).collect()
}

/// Indices as parts of a name. Letters side by side are several indices: for i = 0 and j = 1,
/// `b_{ij}` is `b_{01}`.
fn indices_of(indices: &[Expr], machine: &mut Machine) -> Option<Vec<Index>> {
    let mut list = Vec::with_capacity(indices.len());
    for index in indices {
        match letters_side_by_side(index, machine) {
            Some(letters) => {
                let parts: Option<Vec<Index>> =
                    letters.iter().map(|letter| index_of(letter, machine)).collect();
                list.extend(joined(parts?));
            }
            None => list.push(index_of(index, machine)?),
        }
    }
    Some(list)
}

/// The letters and digits of an index such as `ij`, written without blanks; a number is no factor
/// of what follows only if it is 0.
pub(super) fn letters_side_by_side(index: &Expr, machine: &Machine) -> Option<Vec<Expr>> {
    match &index.kind {
        Kind::Name(word) if word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_alphabetic()) => {
            let known = letters::sign(word).is_some() || machine.lookup(&Symbol::new(word)).is_some();
            let letter = |letter: char| Expr::new(Kind::Name(letter.to_string()), index.span);
            (!known).then(|| word.chars().map(letter).collect())
        }
        Kind::Mul(factors) => {
            let touch = factors.windows(2).all(|pair| pair[0].span.end == pair[1].span.start);
            let single = factors.iter().enumerate().all(|(at, factor)| match &factor.kind {
                Kind::Name(_) => true,
                Kind::Number(digit) => digit.is_integer() && (at > 0 || num_traits::Zero::is_zero(digit)),
                _ => false,
            });
            (touch && single).then(|| factors.clone())
        }
        _ => None,
    }
}

/// Indices side by side as they are written: digits make one index, other numbers need commas.
fn joined(parts: Vec<Index>) -> Vec<Index> {
    let short = |part: &Index| match part {
        Index::Number(i) => (0..10).contains(i),
        Index::Word(_) => true,
    };
    if !parts.iter().all(short) {
        return parts;
    }
    let text: String = parts.iter().map(Index::to_string).collect();
    vec![match text.parse::<i64>() {
        Ok(number) if !text.starts_with('0') => Index::Number(number),
        _ => Index::Word(text),
    }]
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
    if let Kind::Prime(body, order) = &expr.kind {
        let body = index_of(body, machine)?;
        return Some(Index::Word(format!("{body}{}", "'".repeat(*order as usize))));
    }
    match machine.eval(expr).ok()? {
        Value::Scalar(value) => match Value::Scalar(value.clone()).as_int() {
            Some(i) => Some(Index::Number(i)),
            None => Some(Index::Word(value.to_string())),
        },
        Value::Text(text) => Some(Index::Word(text)),
        // A list or function named like an index has nothing to do with it.
        _ => match &expr.kind {
            Kind::Name(name) => Some(Index::Word(name.clone())),
            _ => None,
        },
    }
}

impl Machine {
    /// The value of a name, or the symbol that stands for it.
    pub(crate) fn eval_name(&mut self, expr: &Expr) -> Evaluated {
        let Some(symbol) = name_of(expr, self) else {
            return match &expr.kind {
                Kind::Subscript(base, indices) => self.entry_of(base, indices, expr),
                _ => Err(Diagnostic::error(Code::Type, "only names can have indices")
                    .at(expr.span)
                    .reason("not a name")),
            };
        };
        if let Some(value) = self.lookup(&symbol) {
            return Ok(value.clone());
        }
        if let Some(value) = self.indexed_value(expr)? {
            return Ok(value);
        }
        if stands_for_itself(symbol.base()) || !symbol.accent().is_empty() {
            self.is_plain_index(expr)?;
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
    pub(super) fn indexed_value(&mut self, expr: &Expr) -> Result<Option<Value>, Diagnostic> {
        let (base, indices, upper) = match &expr.kind {
            Kind::Subscript(base, indices) => (base, indices, false),
            Kind::Upper(base, indices) => (base, indices, true),
            _ => return Ok(None),
        };
        let name = name_of(base, self);
        let Some(value) = name.as_ref().and_then(|name| self.lookup(name).cloned()) else {
            // p_{1,0} for a point p_1
            if let (Some((first, rest)), false, Some(name)) = (indices.split_first(), upper, &name)
                && !rest.is_empty()
                && let Some(index) = index_of(first, self)
                && let Some(value @ (Value::List(_) | Value::Matrix(_) | Value::Geometry(_))) =
                    self.lookup(&name.with_indices(vec![index])).cloned()
            {
                return self.entry(&value, rest, expr);
            }
            // b_0[1]: the entry of an entry
            return match &base.kind {
                Kind::Subscript(..) if !upper => match self.indexed_value(base)? {
                    Some(value) => self.entry(&value, indices, expr),
                    None => Ok(None),
                },
                _ => Ok(None),
            };
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
        if let Value::Function(function) = &value
            && let Some(member) = self.member_at(function, indices, expr.span)
        {
            return member.map(Some);
        }
        if let Value::Function(function) = &value
            && let Some(partial) = self.partial_by_index(function, indices)
        {
            return Ok(Some(partial));
        }
        if let (Value::Function(function), [Expr { kind: Kind::List(nodes), .. }]) =
            (&value, indices.as_slice())
        {
            return self.divided_difference(function, nodes, expr.span).map(Some);
        }
        // The parameter of a function may have members of its own: in b(b_0) it is no list.
        self.entry(&value, indices, expr)
    }

    /// `F_u` and `F_{uv}` of a function of u and v.
    fn partial_by_index(&mut self, function: &Function, indices: &[Expr]) -> Option<Value> {
        let mut names = Vec::new();
        for index in indices {
            match letters_side_by_side(index, self) {
                Some(letters) => names.extend(letters),
                None => names.push(index.clone()),
            }
        }
        let names: Option<Vec<(Symbol, usize)>> =
            names.iter().map(|name| name_of(name, self).map(|name| (name, 1))).collect();
        self.partial_of(function, &names?)
    }

    /// The partial derivative of a function of several variables, also of one whose values are points.
    pub(super) fn partial_of(&mut self, function: &Function, orders: &[(Symbol, usize)]) -> Option<Value> {
        if let Some(partial) = function::partial(function, orders) {
            return Some(partial);
        }
        let coordinates = self.coordinates_of(function)?;
        let partials = coordinates.iter().map(|coordinate| match coordinate {
            Value::Function(coordinate) => function::partial(coordinate, orders),
            _ => None,
        });
        partials.collect::<Option<Vec<_>>>().map(Value::point)
    }

    /// The error for a word without meaning, with the nearest known one.
    pub(crate) fn unknown_name(&self, name: &str, expr: &Expr) -> Diagnostic {
        self.unknown_word(name).at(expr.span)
    }

    /// The error for the call of a word without meaning.
    pub(crate) fn unknown_function(&self, name: &str, callee: &Expr) -> Diagnostic {
        let mut error = self.unknown_name(name, callee);
        error.code = Code::UnknownFunction;
        error.hints.retain(|hint| !hint.starts_with("for a product"));
        for hint in &mut error.hints {
            *hint = hint.replace(&format!("{name} :="), &format!("{name}(t) :="));
        }
        match error.hints.iter().any(|hint| hint.starts_with("define it first")) && name.len() > 3 {
            true => error.hint("or use one of the functions that polarform functions lists"),
            false => error,
        }
    }

    pub(super) fn unknown_word(&self, name: &str) -> Diagnostic {
        let error =
            Diagnostic::error(Code::UnknownName, format!("'{name}' is not defined")).reason("unknown name");
        if let Some(advice) = words::elsewhere(name) {
            return error.hint(advice);
        }
        if let Some(form) = words::form(name) {
            return error.hint(format!("write {form}"));
        }
        let special = words::FORMS.iter().map(|(name, _)| *name);
        let known = self.scope.keys().map(Symbol::base).chain((self.tools.names)()).chain(special);
        // A short word is close to many others.
        let alike = |best: &&str| name.len() > 3 || best.starts_with(name) || name.starts_with(*best);
        let best = (self.tools.synonym)(name).or_else(|| nearest(name, known).filter(alike));
        if let Some(best) = best {
            return error.hint(format!("did you mean '{best}'?"));
        }
        let called = |name: &str| (self.tools.function)(name).map(|function| function.form());
        // rational_bezier, spline_domain: a part of the word is a function.
        let part = || name.split('_').filter(|part| part.len() > 3).find_map(called);
        if let Some(form) = words::topic(name).and_then(called).or_else(part) {
            return error.hint(format!("write {form}"));
        }
        let about = topics::advice(&name.to_lowercase());
        if let Some(advice) = about.first() {
            let hint = match advice {
                Advice::Write(query) | Advice::Equations(query) => Some(format!("for example {query}")),
                Advice::Function(function) => called(function).map(|form| format!("write {form}")),
                Advice::Say(advice) => Some((*advice).to_owned()),
            };
            if let Some(hint) = hint {
                return error.hint(hint);
            }
        }
        if !name.is_ascii() && letters::sign(name).is_none() {
            return error.hint("write a formula; polarform functions lists the functions");
        }
        let error = error.hint(format!("define it first: {name} := ..."));
        match name.len() <= LONGEST_PRODUCT && name.bytes().all(|byte| byte.is_ascii_alphabetic()) {
            true => {
                let spaced: Vec<String> = name.chars().map(String::from).collect();
                error.hint(format!("for a product of the letters write {}", spaced.join(" ")))
            }
            false => error,
        }
    }
}
