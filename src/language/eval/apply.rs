//! A name followed by a bracket: value of a function, or product.

use std::sync::Arc;

use super::arguments::{Arguments, named};
use super::curves;
use super::machine::{Evaluated, Machine};
use super::names::{name_of, spread, stands_for_itself};
use super::products::without_power;
use super::stand_ins::first_is_the_number;
use super::tools::{Callable, Slot};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::lexicon::{families, roles};
use crate::language::ops::arithmetic;
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::is_parameter;
use crate::language::ops::function::formula_function;
use crate::language::ops::lists::is_curve;
use crate::language::value::{Function, PolarKind, Value};
use crate::math::poly::Symbol;

/// What stands before the bracket.
pub(super) enum Callee {
    Value(Value),
    /// A function with its index arguments already evaluated.
    Indexed(Arc<Function>, Vec<(Value, Span)>),
    /// A standard family such as B_i^n, with its index arguments.
    Family(&'static str, Vec<(Value, Span)>),
}

impl Machine {
    pub(crate) fn eval_apply(&mut self, callee: &Expr, groups: &[Vec<Expr>], whole: &Expr) -> Evaluated {
        if let Some(total) = self.total_of_list(callee, groups, whole)? {
            return Ok(total);
        }
        // ∂_u (u^2 v)
        if let [group] = groups
            && let [body] = group.as_slice()
            && let Some(derivative) = self.partial(&[callee.clone(), body.clone().grouped()], whole.span)
        {
            return self.eval(&derivative);
        }
        let decimal = self.with_decimal(callee, groups).map(|number| vec![vec![number]]);
        let groups = decimal.as_deref().unwrap_or(groups);
        let callee_value = match self.stand_in(callee, groups)? {
            Some(value) => Callee::Value(value),
            None => self.callee(callee)?,
        };
        match callee_value {
            Callee::Value(value) => match value {
                Value::Builtin(name) => {
                    let function = self.function(name)?;
                    self.call_builtin(function, groups, whole.span)
                }
                Value::Polar(polar) => self.call_polar(&polar, groups, callee, whole.span),
                Value::Function(function) => {
                    let values = self.arguments(groups)?;
                    self.call(&function, values, whole.span)
                }
                Value::Geometry(geometry) => {
                    if let Some(value) =
                        self.piece_of_spline(&Value::Geometry(geometry.clone()), groups, whole.span)?
                    {
                        return Ok(value);
                    }
                    let values = self.arguments(groups)?;
                    curves::call_geometry(&geometry, &values, whole.span)
                }
                Value::Piecewise(function) => {
                    let values = self.arguments(groups)?;
                    curves::call_piecewise(&function, &values, whole.span)
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
                    items
                        .iter()
                        .map(value)
                        .collect::<Result<_, _>>()
                        .map(|values| Value::List(items.with(values)))
                }
                Value::List(items) if is_curve(&items) => {
                    // The polar form of a curve has one degree, up to which f(0^2, 1) is filled.
                    let degree = |item: &Value| match item {
                        Value::Polar(polar) => match &polar.kind {
                            PolarKind::Univariate(form) => Some(form.degree()),
                            _ => None,
                        },
                        _ => None,
                    };
                    let first = items.first().and_then(degree);
                    let values = match first.filter(|_| items.iter().all(|item| degree(item) == first)) {
                        Some(degree) => self.polar_arguments(groups, degree)?,
                        None => self.arguments(groups)?,
                    };
                    items
                        .iter()
                        .map(|item| self.coordinate(item, &values, whole.span))
                        .collect::<Result<_, _>>()
                        .map(|values| Value::List(items.with(values)))
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
                let function = self.function(name)?;
                self.note(
                    Diagnostic::note(
                        Code::StandardMeaning,
                        format!("read with its standard meaning, {}", function.form()),
                    )
                    .at(callee.span),
                );
                function.run(self, all).at(whole.span)
            }
        }
    }

    /// The sum or product of the items of a list: sum([1, 2, 3]).
    fn total_of_list(
        &mut self,
        callee: &Expr,
        groups: &[Vec<Expr>],
        whole: &Expr,
    ) -> Result<Option<Value>, Diagnostic> {
        let (Kind::Name(name), [group]) = (&callee.kind, groups) else { return Ok(None) };
        let (combine, nothing): (fn(Value, Value) -> Evaluated, i64) = match name.as_str() {
            "sum" => (arithmetic::add, 0),
            "prod" | "product" => (arithmetic::multiply, 1),
            _ => return Ok(None),
        };
        let ([list], None) = (group.as_slice(), self.lookup(&Symbol::new(name))) else { return Ok(None) };
        let Value::List(items) = self.eval(list)? else { return Ok(None) };
        let total = items.into_iter().map(Ok).reduce(|total, item| combine(total?, item?));
        total.unwrap_or_else(|| Ok(Value::int(nothing))).at(whole.span).map(Some)
    }

    /// Whether `callee(…)` is a product: its callee has a scalar value.
    pub(crate) fn is_product(&mut self, expr: &Expr) -> Result<bool, Diagnostic> {
        let Kind::Apply(callee, groups) = &expr.kind else { return Ok(false) };
        if groups.len() != 1 || groups[0].len() != 1 {
            return Ok(false);
        }
        Ok(match self.callee(callee)? {
            Callee::Value(scalar @ Value::Scalar(_)) => {
                self.is_no_lone_call(callee, &groups[0][0])?;
                let before = self.notes.len();
                let value = self.value_of_result(&scalar, callee, &groups[0][0], expr.span)?;
                self.notes.truncate(before);
                if value.is_some() {
                    return Ok(false);
                }
                self.called_formula(&scalar, callee)?.is_none()
            }
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
            // t^2 (0, 1), (1 - t)(1, 1): a number times a point
            let parameter = name_of(callee, self).is_some_and(|name| roles::is_parameter(name.base()));
            let formula = matches!(scalar, Value::Scalar(_))
                && (parameter || matches!(callee.kind, Kind::Group(_) | Kind::Pow(..) | Kind::Apply(..)));
            if formula && self.reading.is_none() {
                let point = self.expand_items(group)?;
                return arithmetic::multiply(scalar, Value::point(point)).at(span);
            }
            return Err(not_a_function(&scalar).at(callee.span));
        };
        if matches!(scalar, Value::List(_)) && self.reading.is_none() {
            return Err(super::entries::list_called(callee.span));
        }
        self.is_no_lone_call(callee, factor)?;
        if let Some(value) = self.value_of_result(&scalar, callee, factor, span)? {
            return Ok(value);
        }
        if let Some(called) = self.called_formula(&scalar, callee)? {
            return self.call_formula(&called, &scalar, callee, factor, span);
        }
        let factor_value = self.eval(factor)?;
        arithmetic::multiply(scalar, factor_value).at(span)
    }

    /// Refuses p(t), p(2) and p([1, 2]) for a p without a value: these parentheses group nothing, so they mean a call.
    pub(super) fn is_no_lone_call(&mut self, callee: &Expr, inside: &Expr) -> Result<(), Diagnostic> {
        if self.reading.is_some()
            || self.is_item(callee)
            || !(matches!(inside.kind, Kind::Name(_) | Kind::Subscript(..) | Kind::List(_) | Kind::Tuple(_))
                || is_number(inside))
        {
            return Ok(());
        }
        let named = match &callee.kind {
            Kind::Pow(base, _) if matches!(base.kind, Kind::Subscript(..)) => base,
            _ => callee,
        };
        // t(t) can only be a product.
        let lone = name_of(named, self).filter(|_| !callee.same_as(inside));
        if lone.is_none_or(|name| self.lookup(&name).is_some()) {
            return Ok(());
        }
        let shown = super::super::write::text(callee);
        Err(Diagnostic::error(
            Code::AmbiguousProduct,
            format!("'{shown}' has no value here: is this a value of {shown} or a product?"),
        )
        .at(callee.span)
        .reason("not defined")
        .hint(format!("define it, for example {shown}(t) := t^2"))
        .hint(format!("or write {shown} * (...) for the product")))
    }

    /// Finds out what stands before a bracket.
    fn callee(&mut self, callee: &Expr) -> Result<Callee, Diagnostic> {
        // B_1^3'(t): the prime stands behind the index above
        if let Kind::Pow(base, upper) = &callee.kind
            && let (Kind::Subscript(..), Kind::Prime(index, order)) = (&base.kind, &upper.kind)
            && let Some(member) =
                self.member(&Expr::new(Kind::Pow(base.clone(), index.clone()), callee.span))?
        {
            return self.derivative_of(&member, *order as usize, callee.span).map(Callee::Value);
        }
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
            self.is_no_unknown_member(callee)?;
            return self.eval_called(callee).map(Callee::Value);
        };
        if symbol.is_plain() {
            let name = symbol.base();
            if let Some(function) = (self.tools.function)(name) {
                return Ok(Callee::Value(Value::Builtin(function.name())));
            }
            if !stands_for_itself(name) {
                return match (self.tools.alias)(name).filter(|_| self.reading.is_none()) {
                    Some(function) => {
                        let note = format!("'{name}' is read as {}", function.name());
                        self.note(Diagnostic::note(Code::StandardMeaning, note).at(callee.span));
                        Ok(Callee::Value(Value::Builtin(function.name())))
                    }
                    None => Err(self.unknown_function(name, callee)),
                };
            }
            let capital = name.chars().next().is_some_and(char::is_uppercase);
            if capital || roles::FUNCTIONS.contains(&name) {
                return Err(Diagnostic::error(
                    Code::AmbiguousProduct,
                    format!("'{name}' has no value here: is this a value of {name} or a product?"),
                )
                .at(callee.span)
                .reason("not defined")
                .hint(format!("define it, for example {name}(t) := t^2 or {name} := polar(t^2)"))
                .hint(match name {
                    families::BINOMIAL_COEFFICIENT => "the binomial coefficient is binomial(n, k)".to_owned(),
                    families::BERNSTEIN => {
                        "the Bernstein polynomial is B_i^n(t), or bernstein(n, i, t)".to_owned()
                    }
                    families::SPLINE => "a B-spline is bspline_basis(n, knots, i)(t)".to_owned(),
                    _ => format!("or write {name} * (...) for the product"),
                }));
            }
        }
        if let Some(value) = self.indexed_value(callee)? {
            return Ok(Callee::Value(value));
        }
        if !symbol.indices().is_empty()
            && (roles::FAMILIES.contains(&symbol.base()) || roles::FUNCTIONS.contains(&symbol.base()))
        {
            let mut error = Diagnostic::error(
                Code::AmbiguousProduct,
                format!("'{symbol}' has no value here: is this a value of a family or a product?"),
            )
            .at(callee.span)
            .reason("not defined");
            if symbol.base() == families::BERNSTEIN {
                error = error.hint("the Bernstein polynomial is written B_i^n(t), or bernstein(n, i, t)");
            }
            if symbol.base() == families::SPLINE {
                error = error.hint("a B-spline is bspline_basis(n, knots, i)(t)");
            }
            return Err(error.hint(format!("define it first, or write {symbol} * (...) for the product")));
        }
        self.eval(callee).map(Callee::Value)
    }

    /// Refuses b_i^r(t) for a b_i and an r without values: with letters as indices it is no power.
    fn is_no_unknown_member(&mut self, callee: &Expr) -> Result<(), Diagnostic> {
        let Kind::Pow(base, upper) = &callee.kind else { return Ok(()) };
        let Kind::Subscript(letter, _) = &base.kind else { return Ok(()) };
        let mut free = |expr: &Expr| name_of(expr, self).is_some_and(|name| self.lookup(&name).is_none());
        if !free(base) || !free(letter) || !free(upper) || self.reading.is_some() {
            return Ok(());
        }
        let shown = super::super::write::text(callee);
        let letter = super::super::write::text(letter);
        Err(Diagnostic::error(
            Code::AmbiguousProduct,
            format!("'{shown}' has no value here: is this a member of a family or a product?"),
        )
        .at(callee.span)
        .reason("not defined")
        .hint(format!(
            "define it first, a recursion by its first case: {letter}_i^0(t) := ..., then {shown}(t) := ..."
        ))
        .hint(format!("or write {shown} * (...) for the product")))
    }

    /// `N_i(t)`, `B_i^n(t)` and the like, for defined functions and standard families.
    pub(super) fn indexed_callee(&mut self, callee: &Expr) -> Result<Option<Callee>, Diagnostic> {
        let (base, lower, upper) = match &callee.kind {
            Kind::Subscript(base, lower) => (base.as_ref(), lower.as_slice(), None),
            Kind::Pow(inner, upper) => split_lower(inner, upper),
            Kind::Upper(inner, list) if list.len() == 1 => split_lower(inner, &list[0]),
            _ => return Ok(None),
        };
        let Some(name) = name_of(base, self) else { return Ok(None) };
        match self.lookup(&name).cloned() {
            Some(Value::Function(function))
                if function.shape.lower == spread(lower, function.shape.lower, self).len()
                    && function.shape.upper == usize::from(upper.is_some())
                    && function.shape.lower + function.shape.upper > 0 =>
            {
                let lower = spread(lower, function.shape.lower, self);
                let mut values = Vec::with_capacity(lower.len() + 1);
                for index in lower.iter().chain(upper) {
                    values.push((self.eval(index)?, index.span));
                }
                Ok(Some(Callee::Indexed(function, values)))
            }
            Some(_) => Ok(None),
            None => {
                let standard = families::notation(name.base(), lower.len(), usize::from(upper.is_some()))
                    .filter(|_| name.is_plain());
                let Some((function, places)) = standard.and_then(|notation| notation.function) else {
                    // N_1^2(t) is no product of a power.
                    let family = name.is_plain() && roles::FAMILIES.contains(&name.base());
                    return match family && upper.is_some() && !lower.is_empty() {
                        true => Err(unknown_family(name.base()).at(callee.span)),
                        false => Ok(None),
                    };
                };
                let indices: Vec<&Expr> = lower.iter().chain(upper).collect();
                let mut values = Vec::with_capacity(places.len());
                for &place in places {
                    values.push((self.eval(indices[place])?, indices[place].span));
                }
                if upper.is_none() && function == "bernstein" {
                    first_is_the_number(&values, callee)?;
                }
                Ok(Some(Callee::Family(function, values)))
            }
        }
    }

    /// The value of what stands before a parenthesis.
    pub(super) fn eval_called(&mut self, expr: &Expr) -> Evaluated {
        let before = std::mem::replace(&mut self.called, matches!(without_power(expr).kind, Kind::Group(_)));
        let value = self.eval(expr);
        self.called = before;
        value
    }

    /// The function that a member of a family is, such as B_1^3; `None` for anything else.
    pub(super) fn member(&mut self, expr: &Expr) -> Result<Option<Value>, Diagnostic> {
        let Kind::Pow(base, upper) = &expr.kind else { return Ok(None) };
        if self.reading.is_some() || !matches!(base.kind, Kind::Subscript(..)) {
            return Ok(None);
        }
        let variable = Symbol::new("t");
        let argument = (Value::symbol(variable.clone()), expr.span);
        let value = match self.indexed_callee(expr)? {
            Some(Callee::Indexed(function, mut values)) if function.shape.inner == 1 => {
                values.push(argument);
                self.call(&function, values, expr.span)?
            }
            Some(Callee::Family(name, indices)) => {
                let mut all = Arguments::default();
                for (value, span) in indices.into_iter().chain([argument]) {
                    all.push(value, span);
                }
                self.function(name)?.run(self, all).at(upper.span)?
            }
            _ => return Ok(None),
        };
        Ok(value.as_scalar().map(|formula| formula_function(variable, formula.clone())))
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
        function: &'static dyn Callable,
        groups: &[Vec<Expr>],
        span: Span,
    ) -> Evaluated {
        let mut all = Arguments::default();
        for group in groups {
            let mut values: Vec<Value> = Vec::with_capacity(group.len());
            let mut spans: Vec<Span> = Vec::with_capacity(group.len());
            let mut skip = false;
            for (at, item) in group.iter().enumerate() {
                if std::mem::take(&mut skip) {
                    continue;
                }
                let place = all.len() + values.len();
                // x = 1 is an equation among equations, unless x is the name of an argument.
                let is_equation = named(item).is_none_or(|(name, _)| {
                    let mut before = all.values().chain(&values);
                    !function.takes_name(&name) && before.all(|value| matches!(value, Value::Claim(_)))
                });
                if function.takes_equations()
                    && is_equation
                    && let Some(equations) = self.equations(item)?
                {
                    values.push(equations);
                    spans.push(item.span);
                    continue;
                }
                match (named(item), &item.kind) {
                    (Some((name, value)), _) => {
                        let given = self.eval_or_word(value, function, Slot::Name(&name))?;
                        all.push_written(item, name, given, value.span);
                    }
                    (None, Kind::Chain(left, links))
                        if function.takes_values()
                            && let ([Link { rel: Rel::Eq, expr: value, .. }], Kind::Subscript(..)) =
                                (links.as_slice(), &left.kind)
                            && let Some(name) = name_of(left, self) =>
                    {
                        let given = self.eval(value)?;
                        all.push_indexed(name, given, value.span);
                    }
                    (None, Kind::Ellipsis) => skip = self.fill_dots(group, at, &mut values)?,
                    (None, Kind::Brace(list, label)) => {
                        values.extend(self.repeated(list, label.as_deref(), item.span)?);
                    }
                    // max{1, 2}
                    (None, Kind::Set(members, None)) => {
                        for member in members {
                            values.push(self.eval(member)?);
                            spans.push(member.span);
                        }
                    }
                    (None, _) => {
                        self.not_named_without_sign(item)?;
                        // polar(B_1^3)
                        let before = std::mem::replace(&mut self.called, function.takes_polynomial(place));
                        let value = self.eval_or_word(item, function, Slot::Place(place));
                        self.called = before;
                        let value = value?;
                        if value.as_rational().is_some() && function.takes_polynomial(place) {
                            self.parameter_has_value(item);
                        }
                        let split = function.takes_coordinates(place);
                        values.push(if split { self.in_coordinates(value) } else { value });
                    }
                }
                spans.resize(values.len(), item.span);
            }
            for (value, span) in values.into_iter().zip(spans) {
                all.push(value, span);
            }
        }
        function.run(self, all).at(span).map_err(|error| match error.code {
            Code::Type if error.hints.is_empty() => error.hint(format!("the form is {}", function.form())),
            _ => error,
        })
    }

    /// A remark on polar(t^2) where t is a number.
    fn parameter_has_value(&mut self, polynomial: &Expr) {
        if let Kind::Name(name) = &polynomial.kind
            && let Some(value) = self.lookup(&Symbol::new(name)).and_then(Value::as_rational)
            && is_parameter(&Symbol::new(name))
        {
            let note = format!("{name} has the value {value}, so this is a constant");
            let note = Diagnostic::note(Code::AmbiguousVariable, note).at(polynomial.span);
            self.note(
                note.hint("use another letter for the parameter; at the prompt :forget takes a value away"),
            );
        }
        polynomial.for_each_child(&mut |child| self.parameter_has_value(child));
    }

    /// Refuses `degree 3` for `degree=3`.
    fn not_named_without_sign(&self, item: &Expr) -> Result<(), Diagnostic> {
        let Kind::Mul(factors) = &item.kind else { return Ok(()) };
        match &factors[0].kind {
            Kind::Name(word)
                if word.len() > 1
                    && (self.tools.argument_word)(word)
                    && self.lookup(&Symbol::new(word)).is_none() =>
            {
                Err(Diagnostic::error(Code::Arity, "the name of an argument stands beside its value")
                    .at(item.span)
                    .hint(format!("write {word}=...")))
            }
            _ => Ok(()),
        }
    }

    /// The value of an argument, or the word it is.
    fn eval_or_word(&mut self, item: &Expr, function: &dyn Callable, slot: Slot) -> Evaluated {
        match &item.kind {
            Kind::Name(word)
                if function.takes_word(slot, word, self.lookup(&Symbol::new(word)).is_some()) =>
            {
                Ok(Value::Text(word.clone()))
            }
            _ => {
                if function.takes_unknowns(slot) {
                    self.unknowns_of_curves(item);
                }
                self.eval(item)
            }
        }
    }

    /// A remark on the unknown c_0 where c is a curve: that is its control point.
    fn unknowns_of_curves(&mut self, unknowns: &Expr) {
        if let Kind::Subscript(base, _) = &unknowns.kind
            && let Some(curve) = name_of(base, self)
            && matches!(self.lookup(&curve), Some(Value::Geometry(_)))
            && name_of(unknowns, self).is_none_or(|name| self.lookup(&name).is_none())
        {
            let message = format!("this is a control point of {curve}, no unknown of its own");
            let note = Diagnostic::note(Code::AmbiguousVariable, message).at(unknowns.span);
            return self
                .note(note.hint(format!("use another letter than {curve} for the points or the curve")));
        }
        unknowns.for_each_child(&mut |child| self.unknowns_of_curves(child));
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

/// `B_i` with an upper index: base, lower indices, upper index.
fn split_lower<'a>(inner: &'a Expr, upper: &'a Expr) -> (&'a Expr, &'a [Expr], Option<&'a Expr>) {
    match &inner.kind {
        Kind::Subscript(base, lower) => (base, lower, Some(upper)),
        _ => (inner, &[], Some(upper)),
    }
}

/// 2, 1/2, -1
fn is_number(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Div(above, below, _) => is_number(above) && is_number(below),
        Kind::Add(terms) => terms.len() == 1 && is_number(&terms[0].expr),
        _ => false,
    }
}

fn not_a_function(value: &Value) -> Diagnostic {
    let error =
        Diagnostic::error(Code::Type, format!("{} cannot be applied to several arguments", value.kind()))
            .reason(format!("this is {}", value.kind()));
    match value {
        Value::Matrix(_) => error.hint("an entry is written M_{1,2} or M[1, 2]"),
        Value::Scalar(_) => error
            .hint("define a function of several variables first: F(u, v) := u v")
            .hint("for the product with a point write * between them"),
        _ => error,
    }
}

/// The error for a member of a family that nobody defined, such as N_1^2(t).
fn unknown_family(letter: &str) -> Diagnostic {
    let message = format!("'{letter}' has no value here: is this a value of a family or a product?");
    let error = Diagnostic::error(Code::AmbiguousProduct, message).reason("not defined");
    match letter {
        families::SPLINE => error.hint("a B-spline is bspline_basis(n, knots, i)(t)"),
        other => error.hint(format!("define it first, for example {other}(i, n, t) := ...")),
    }
}
