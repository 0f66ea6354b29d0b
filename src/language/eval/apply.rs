//! A name followed by a bracket: value of a function, or product.

use std::sync::Arc;

use super::arguments::{self, Arguments};
use super::curves::is_curve;
use super::names::{name_of, stands_for_itself};
use super::{Evaluated, Machine, arithmetic, geometry, wrong_kind};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::functions;
use crate::language::value::{Clause, Function, Parameter, Polar, PolarKind, Value};
use crate::math::blossom::Argument;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Symbol};

/// Letters that are read as functions when they have no value: `f(t + 1)` is then a question.
const FUNCTION_LETTERS: &[&str] = &["f", "g", "h", "phi", "psi", "varphi"];

/// Letters that are read as families of functions when they have indices but no value.
const FAMILY_LETTERS: &[&str] = &["B", "N", "L", "H", "T"];

/// What stands before the bracket.
enum Callee {
    Value(Value),
    /// A function with its index arguments already evaluated.
    Indexed(Arc<Function>, Vec<(Value, Span)>),
    /// A standard family such as B_i^n, with its index arguments.
    Family(&'static str, Vec<(Value, Span)>),
}

impl Machine {
    pub(crate) fn eval_apply(&mut self, callee: &Expr, groups: &[Vec<Expr>], whole: &Expr) -> Evaluated {
        match self.callee(callee)? {
            Callee::Value(value) => match value {
                Value::Builtin(name) => {
                    let builtin = functions::builtin(name)
                        .ok_or_else(|| Diagnostic::error(Code::Internal, format!("no function {name}")))?;
                    self.call_builtin(builtin, groups, whole.span)
                }
                Value::Polar(polar) => self.call_polar(&polar, groups, callee, whole.span),
                Value::Function(function) => {
                    let values = self.arguments(groups)?;
                    self.call(&function, values, whole.span)
                }
                Value::Geometry(geometry) => {
                    let values = self.arguments(groups)?;
                    geometry::call_geometry(&geometry, &values, whole.span)
                }
                Value::Piecewise(function) => {
                    let values = self.arguments(groups)?;
                    geometry::call_piecewise(&function, &values, whole.span)
                }
                // A curve is a list of functions or polar forms, one for each coordinate.
                Value::List(items)
                    if matches!(items.first(), Some(Value::Polar(polar)) if !matches!(polar.kind, PolarKind::Univariate(_)))
                        && is_curve(&items) =>
                {
                    let value = |item: &Value| match item {
                        Value::Polar(polar) => self.call_polar(polar, groups, callee, whole.span),
                        other => Err(wrong_kind("a polar form", other).at(callee.span)),
                    };
                    items.iter().map(value).collect::<Result<_, _>>().map(Value::List)
                }
                Value::List(items) if is_curve(&items) => {
                    let values = self.arguments(groups)?;
                    items
                        .iter()
                        .map(|item| self.coordinate(item, &values, whole.span))
                        .collect::<Result<_, _>>()
                        .map(Value::List)
                }
                scalar => self.bracket_product(scalar, callee, groups, whole.span),
            },
            Callee::Indexed(function, mut values) => {
                values.extend(self.arguments(groups)?);
                self.call(&function, values, whole.span)
            }
            Callee::Family(name, indices) => {
                let mut all = Arguments::default();
                for (value, span) in indices.into_iter().chain(self.arguments(groups)?) {
                    all.push(value, span);
                }
                let builtin = functions::builtin(name)
                    .ok_or_else(|| Diagnostic::error(Code::Internal, format!("no function {name}")))?;
                self.note(
                    Diagnostic::note(
                        Code::StandardMeaning,
                        format!("read with its standard meaning, {}", builtin.signature()),
                    )
                    .at(callee.span),
                );
                builtin.run(self, all).at(whole.span)
            }
        }
    }

    /// Whether `callee(…)` is a product: its callee has a scalar value.
    pub(crate) fn is_product(&mut self, expr: &Expr) -> Result<bool, Diagnostic> {
        let Kind::Apply(callee, groups) = &expr.kind else { return Ok(false) };
        if groups.len() != 1 || groups[0].len() != 1 {
            return Ok(false);
        }
        Ok(match self.callee(callee)? {
            Callee::Value(value) => {
                !matches!(
                    &value,
                    Value::Function(_)
                        | Value::Polar(_)
                        | Value::Builtin(_)
                        | Value::Geometry(_)
                        | Value::Piecewise(_)
                ) && !matches!(&value, Value::List(items) if is_curve(items))
            }
            _ => false,
        })
    }

    /// Whether this is a member of a standard family with numbers as indices, such as B_1^3.
    pub(crate) fn is_standard(&mut self, callee: &Expr) -> bool {
        matches!(self.indexed_callee(callee), Ok(Some(Callee::Family(_, indices)))
            if indices.iter().all(|(index, _)| index.as_rational().is_some()))
    }

    fn bracket_product(
        &mut self,
        scalar: Value,
        callee: &Expr,
        groups: &[Vec<Expr>],
        span: Span,
    ) -> Evaluated {
        let [group] = groups else {
            return Err(not_a_function(&scalar).at(callee.span));
        };
        let [factor] = group.as_slice() else {
            return Err(not_a_function(&scalar).at(callee.span));
        };
        if let Kind::Name(name) = &callee.kind
            && scalar.as_rational().is_none()
            && (name.chars().next().is_some_and(char::is_uppercase)
                || FUNCTION_LETTERS.contains(&name.as_str()))
            && self.lookup(&Symbol::new(name)).is_some()
        {
            return Err(Diagnostic::error(
                Code::AmbiguousProduct,
                format!("{name} is a formula, not a function: is this its value or a product?"),
            )
            .at(callee.span)
            .reason(format!("{name} was defined without an argument"))
            .hint(format!("define it as a function: {name}(t) := ..."))
            .hint(format!("or write {name} * (...) for the product")));
        }
        let factor_value = self.eval(factor)?;
        arithmetic::multiply(scalar, factor_value).at(span)
    }

    /// Finds out what stands before a bracket.
    fn callee(&mut self, callee: &Expr) -> Result<Callee, Diagnostic> {
        // N_0 may have a definition of its own beside those of the family N_i.
        let symbol = name_of(callee, self);
        if let Some(symbol) = &symbol
            && let Some(value) = self.lookup(symbol)
        {
            return Ok(Callee::Value(value.clone()));
        }
        if let Some(found) = self.indexed_callee(callee)? {
            return Ok(found);
        }
        let Some(symbol) = symbol else {
            return self.eval(callee).map(Callee::Value);
        };
        if symbol.is_plain() {
            let name = symbol.base();
            if let Some(builtin) = functions::builtin(name) {
                return Ok(Callee::Value(Value::Builtin(builtin.name)));
            }
            if !stands_for_itself(name) {
                let mut error = self.unknown_name(name, callee);
                error.code = Code::UnknownFunction;
                error.hints.retain(|hint| !hint.starts_with("for a product"));
                if error.hints.is_empty() {
                    error = error.hint(format!("define it first: {name}(t) := ..."));
                }
                return Err(error);
            }
            let capital = name.chars().next().is_some_and(char::is_uppercase);
            if capital || FUNCTION_LETTERS.contains(&name) {
                return Err(Diagnostic::error(
                    Code::AmbiguousProduct,
                    format!("'{name}' has no value here: is this a value of {name} or a product?"),
                )
                .at(callee.span)
                .reason("not defined")
                .hint(format!("define it, for example {name}(t) := t^2 or {name} := polar(t^2)"))
                .hint(format!("or write {name} * (...) for the product")));
            }
        }
        if !symbol.indices().is_empty()
            && (FAMILY_LETTERS.contains(&symbol.base()) || FUNCTION_LETTERS.contains(&symbol.base()))
        {
            let mut error = Diagnostic::error(
                Code::AmbiguousProduct,
                format!("'{symbol}' has no value here: is this a value of a family or a product?"),
            )
            .at(callee.span)
            .reason("not defined");
            if symbol.base() == "B" {
                error = error.hint("the Bernstein polynomial is written B_i^n(t), or bernstein(n, i, t)");
            }
            return Err(error.hint(format!("define it first, or write {symbol} * (...) for the product")));
        }
        self.eval(callee).map(Callee::Value)
    }

    /// `N_i(t)`, `B_i^n(t)` and the like, for defined functions and standard families.
    fn indexed_callee(&mut self, callee: &Expr) -> Result<Option<Callee>, Diagnostic> {
        let (base, lower, upper) = match &callee.kind {
            Kind::Subscript(base, lower) => (base.as_ref(), lower.as_slice(), None),
            Kind::Pow(inner, upper) => split_lower(inner, upper),
            Kind::Upper(inner, list) if list.len() == 1 => split_lower(inner, &list[0]),
            _ => return Ok(None),
        };
        let Some(name) = name_of(base, self) else { return Ok(None) };
        match self.lookup(&name).cloned() {
            Some(Value::Function(function))
                if function.shape.lower == lower.len()
                    && function.shape.upper == usize::from(upper.is_some())
                    && function.shape.lower + function.shape.upper > 0 =>
            {
                let mut values = Vec::with_capacity(lower.len() + 1);
                for index in lower.iter().chain(upper) {
                    values.push((self.eval(index)?, index.span));
                }
                Ok(Some(Callee::Indexed(function, values)))
            }
            Some(_) => Ok(None),
            None => {
                let family = match (name.is_plain().then(|| name.base()), lower, upper) {
                    (Some("B"), [i], Some(n)) => Some(("bernstein", vec![n, i])),
                    (Some("sigma"), [i, n], None) => Some(("sigma", vec![i, n])),
                    _ => None,
                };
                let Some((family, indices)) = family else {
                    // N_1^2(t) is no product of a power.
                    if name.is_plain()
                        && upper.is_some()
                        && !lower.is_empty()
                        && FAMILY_LETTERS.contains(&name.base())
                    {
                        let message = format!(
                            "'{}' has no value here: is this a value of a family or a product?",
                            name.base()
                        );
                        let error = Diagnostic::error(Code::AmbiguousProduct, message)
                            .at(callee.span)
                            .reason("not defined");
                        return Err(match name.base() {
                            "N" => error.hint("a B-spline is bspline_basis(n, knots, i)(t)"),
                            other => {
                                error.hint(format!("define it first, for example {other}(i, n, t) := ..."))
                            }
                        });
                    }
                    return Ok(None);
                };
                let mut values = Vec::with_capacity(2);
                for index in indices {
                    values.push((self.eval(index)?, index.span));
                }
                Ok(Some(Callee::Family(family, values)))
            }
        }
    }

    /// The arguments of a call, groups run together.
    pub(crate) fn arguments(&mut self, groups: &[Vec<Expr>]) -> Result<Vec<(Value, Span)>, Diagnostic> {
        let mut values = Vec::new();
        for group in groups {
            let span = group.iter().map(|e| e.span).reduce(Span::to).unwrap_or_default();
            if group.iter().any(|e| matches!(e.kind, Kind::Ellipsis | Kind::Brace(..))) {
                values.extend(self.expand_items(group)?.into_iter().map(|value| (value, span)));
            } else {
                for item in group {
                    values.push((self.eval(item)?, item.span));
                }
            }
        }
        Ok(values)
    }

    fn call_builtin(
        &mut self,
        builtin: &'static functions::Builtin,
        groups: &[Vec<Expr>],
        span: Span,
    ) -> Evaluated {
        let mut all = Arguments::default();
        for group in groups {
            for item in group {
                match arguments::named(item) {
                    Some((name, value)) => {
                        let takes = |word: &str, known| builtin.takes_word_under(&name, word, known);
                        let given = self.eval_or_word(value, takes)?;
                        all.push_named(name, given, value.span);
                    }
                    None if matches!(item.kind, Kind::Ellipsis | Kind::Brace(..)) => {
                        for value in self.expand_items(group)? {
                            all.push(value, item.span);
                        }
                        break;
                    }
                    None => {
                        let takes = |word: &str, known| builtin.takes_word_at(all.len(), word, known);
                        let value = self.eval_or_word(item, takes)?;
                        all.push(value, item.span);
                    }
                }
            }
        }
        builtin.run(self, all).at(span)
    }

    /// The value of an argument, or the word it is.
    fn eval_or_word(&mut self, item: &Expr, takes: impl Fn(&str, bool) -> bool) -> Evaluated {
        match &item.kind {
            Kind::Name(word) if takes(word, self.lookup(&Symbol::new(word)).is_some()) => {
                Ok(Value::Text(word.clone()))
            }
            _ => self.eval(item),
        }
    }

    /// Calls a function with its index and bracket arguments.
    pub(crate) fn call(
        &mut self,
        function: &Arc<Function>,
        values: Vec<(Value, Span)>,
        span: Span,
    ) -> Evaluated {
        let shape = function.shape;
        if values.len() != shape.arity() {
            let name = function.name.as_ref().map_or("the function".to_owned(), Symbol::to_string);
            let given = values.len().saturating_sub(shape.lower + shape.upper);
            return Err(Diagnostic::error(
                Code::Arity,
                format!(
                    "{name} takes {} argument{}, not {given}",
                    shape.inner,
                    if shape.inner == 1 { "" } else { "s" }
                ),
            )
            .at(span));
        }
        let numbers: Option<Vec<Rational>> = values.iter().map(|(value, _)| value.as_rational()).collect();
        let key = function.name.clone().zip(numbers);
        if let Some(key) = &key
            && let Some(known) = self.memo.get(key)
        {
            return Ok(known.clone());
        }
        let Some(clause) = choose(function, &values) else {
            return Err(
                Diagnostic::error(Code::Domain, "no case of the definition fits these arguments").at(span)
            );
        };
        let result = self.run_clause(function, clause, &values, span)?;
        if let Some(key) = key
            && self.memo.len() < 100_000
        {
            self.memo.insert(key, result.clone());
        }
        Ok(result)
    }

    fn run_clause(
        &mut self,
        function: &Arc<Function>,
        clause: &Clause,
        values: &[(Value, Span)],
        span: Span,
    ) -> Evaluated {
        let bindings: Vec<(Symbol, Value)> = clause
            .parameters
            .iter()
            .zip(values)
            .filter_map(|(parameter, (value, _))| match parameter {
                Parameter::Name(symbol) => Some((symbol.clone(), value.clone())),
                Parameter::Exactly(_) => None,
            })
            .collect();
        if let Some(formula) = &clause.formula {
            let scalars: Option<Vec<(Symbol, Fraction)>> = bindings
                .iter()
                .map(|(symbol, value)| Some((symbol.clone(), value.as_scalar()?.clone())))
                .collect();
            if let Some(scalars) = scalars {
                return formula
                    .substitute(&scalars)
                    .map(Value::Scalar)
                    .map_err(|_| arithmetic::division_by_zero())
                    .at(span);
            }
        }
        let deepest = crate::budget::depth();
        if self.depth >= deepest {
            return Err(Diagnostic::error(Code::Recursion, format!("calls nested more than {deepest} deep"))
                .at(span)
                .reason("this refers to itself without end")
                .hint("give a base case, for example F(0) := 1 before F(n) := n F(n-1)"));
        }
        // The body sees the names of its definition and its parameters, nothing of the caller.
        let caller =
            (std::mem::replace(&mut self.scope, clause.scope.clone()), std::mem::take(&mut self.locals));
        self.depth += 1;
        if let Some(name) = &function.name {
            self.locals.push((name.clone(), Value::Function(function.clone())));
        }
        self.locals.extend(bindings);
        let result = self.eval(&clause.body);
        self.depth -= 1;
        (self.scope, self.locals) = caller;
        // A place inside another definition means nothing to the caller.
        result.map_err(|mut error| {
            error.span = Some(span);
            error
        })
    }

    pub(crate) fn call_polar(
        &mut self,
        polar: &Arc<Polar>,
        groups: &[Vec<Expr>],
        callee: &Expr,
        span: Span,
    ) -> Evaluated {
        match &polar.kind {
            PolarKind::Univariate(form) => {
                let values = self.polar_arguments(groups, form.degree())?;
                let list: Result<Vec<_>, _> = values.into_iter().map(to_argument).collect();
                let list = list?;
                form.value(&list)
                    .map(Value::Scalar)
                    .map_err(arguments::polar)
                    .map_err(|error| explain_count(error, callee, form.degree(), list.len()))
                    .at(span)
            }
            PolarKind::Tensor(form) => {
                let (m, n) = form.degrees();
                let groups: Vec<Vec<Expr>> = match groups {
                    // Without a semicolon the first m arguments are the u's.
                    [all] if all.len() == m + n => vec![all[..m].to_vec(), all[m..].to_vec()],
                    other => other.to_vec(),
                };
                let [u, v] = groups.as_slice() else {
                    return Err(Diagnostic::error(
                        Code::Arity,
                        format!("this polar form takes {m} and {n} arguments, separated by ';'"),
                    )
                    .at(span)
                    .hint("write f(u1, u2; v1, v2)"));
                };
                let u = self.polar_arguments(std::slice::from_ref(u), m)?;
                let v = self.polar_arguments(std::slice::from_ref(v), n)?;
                let u: Result<Vec<_>, _> = u.into_iter().map(to_argument).collect();
                let v: Result<Vec<_>, _> = v.into_iter().map(to_argument).collect();
                form.value(&u?, &v?).map(Value::Scalar).map_err(arguments::polar).at(span)
            }
            PolarKind::Total(form) => {
                let values = self.polar_arguments(groups, form.degree())?;
                let mut list = Vec::with_capacity(values.len());
                for (value, place) in values {
                    list.push(arguments::point_argument(&value).ok_or_else(|| {
                        wrong_kind("a point such as (u1, v1)", &value)
                            .at(place)
                            .hint("the arguments of this polar form are points: f((u1, v1), (u2, v2))")
                    })?);
                }
                form.value(&list).map(Value::Scalar).map_err(arguments::polar).at(span)
            }
        }
    }

    /// Arguments of a polar form of known degree; `f(t, ..., t)` is filled up to it.
    fn polar_arguments(
        &mut self,
        groups: &[Vec<Expr>],
        degree: usize,
    ) -> Result<Vec<(Value, Span)>, Diagnostic> {
        let [group] = groups else { return self.arguments(groups) };
        let written_out = group.iter().any(|item| matches!(item.kind, Kind::Ellipsis | Kind::Brace(..)));
        if !written_out
            && group.len() != degree
            && let Some(values) = self.powers_as_arguments(group, degree)?
        {
            return Ok(values);
        }
        let Some(at) = group.iter().position(|e| e.kind == Kind::Ellipsis) else {
            return self.arguments(groups);
        };
        let same = at > 0 && group.get(at + 1).is_some_and(|after| after.same_as(&group[at - 1]));
        let others = group.len() - 1;
        if !same || others > degree || group.iter().any(|e| matches!(e.kind, Kind::Brace(..))) {
            return self.arguments(groups);
        }
        // f(t, ..., t, u): the ellipsis stands for as many more t as are missing.
        let mut values = Vec::with_capacity(degree);
        for item in &group[..at] {
            values.push((self.eval(item)?, item.span));
        }
        let filler = values[at - 1].clone();
        values.extend(std::iter::repeat_n(filler, degree - others));
        for item in &group[at + 1..] {
            values.push((self.eval(item)?, item.span));
        }
        Ok(values)
    }

    /// The arguments in f(0^{n-i} 1^i) or f(0^2, t), where powers are repetitions: only if there
    /// would be a wrong number of arguments otherwise, and this way there is the right one.
    fn powers_as_arguments(
        &mut self,
        group: &[Expr],
        degree: usize,
    ) -> Result<Option<Vec<(Value, Span)>>, Diagnostic> {
        let factors = group.iter().flat_map(|item| match &item.kind {
            Kind::Mul(factors) => factors.as_slice(),
            _ => std::slice::from_ref(item),
        });
        let mut repeated = Vec::new();
        let mut total = 0_usize;
        for factor in factors {
            let (base, count) = match &factor.kind {
                Kind::Pow(base, exponent) => (base.as_ref(), self.eval(exponent)?.as_int()),
                _ => (factor, Some(1)),
            };
            let Some(count) = count.and_then(|count| usize::try_from(count).ok()) else { return Ok(None) };
            total = total.saturating_add(count);
            repeated.push((base, count));
        }
        if total != degree {
            return Ok(None);
        }
        let mut values = Vec::with_capacity(degree);
        for (base, count) in repeated {
            let value = self.eval(base)?;
            values.extend(std::iter::repeat_n((value, base.span), count));
        }
        Ok(Some(values))
    }

    pub(crate) fn eval_factorial(&mut self, body: &Expr) -> Evaluated {
        if let Kind::Apply(callee, groups) = &body.kind
            && self.is_product(body)?
        {
            let factor = self.eval(callee)?;
            let inner = self.eval(&groups[0][0])?;
            let value = arithmetic::factorial(&inner).at(body.span)?;
            return arithmetic::multiply(factor, value).at(body.span);
        }
        let value = self.eval(body)?;
        arithmetic::factorial(&value).at(body.span)
    }
}

/// A value as an argument of a polar form.
pub(crate) fn to_argument((value, place): (Value, Span)) -> Result<Argument<Fraction>, Diagnostic> {
    match value {
        Value::Scalar(u) => Ok(Argument::Point(u)),
        Value::Vector(v) => Ok(Argument::Vector(v)),
        other => Err(wrong_kind("a number, symbol or vector argument", &other).at(place)),
    }
}

/// The clause that fits: exact parameters count before names, earlier before later.
fn choose<'a>(function: &'a Function, values: &[(Value, Span)]) -> Option<&'a Clause> {
    let fits = |clause: &&Clause| {
        clause.parameters.iter().zip(values).all(|(parameter, (value, _))| match parameter {
            Parameter::Name(_) => true,
            Parameter::Exactly(q) => value.as_rational().as_ref() == Some(q),
        })
    };
    let exact =
        |clause: &Clause| clause.parameters.iter().filter(|p| matches!(p, Parameter::Exactly(_))).count();
    function.clauses.iter().filter(fits).reduce(
        |best, clause| {
            if exact(clause) > exact(best) { clause } else { best }
        },
    )
}

/// `B_i` with an upper index: base, lower indices, upper index.
fn split_lower<'a>(inner: &'a Expr, upper: &'a Expr) -> (&'a Expr, &'a [Expr], Option<&'a Expr>) {
    match &inner.kind {
        Kind::Subscript(base, lower) => (base, lower, Some(upper)),
        _ => (inner, &[], Some(upper)),
    }
}

fn not_a_function(value: &Value) -> Diagnostic {
    Diagnostic::error(Code::Type, format!("{} cannot be applied to several arguments", value.kind()))
        .reason(format!("this is {}", value.kind()))
}

fn explain_count(error: Diagnostic, callee: &Expr, degree: usize, given: usize) -> Diagnostic {
    if error.code != Code::Arity {
        return error;
    }
    let name = match &callee.kind {
        Kind::Name(name) => name.clone(),
        _ => "f".to_owned(),
    };
    if given < degree {
        error.hint(format!("partial({name}, ...) puts in some arguments and leaves the others free"))
    } else {
        error.hint(format!("elevate({name}, {}) has as many arguments", given - degree))
    }
}
