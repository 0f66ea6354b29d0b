//! Sums, products, derivatives, integrals, composition.

use std::sync::Arc;

use super::arguments::{coefficients_in, variable_of};
use super::arithmetic::{self, formula_function};
use super::names::name_of;
use super::{Evaluated, Machine, unsupported, wrong_kind};
use crate::formula::source::Span;
use crate::formula::{BigOp, Expr, Kind, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::value::{Clause, Function, Parameter, Polar, PolarKind, Shape, Value};
use crate::math::number::Combinations;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// F^(k) of a function given by one formula, or the polar form of the derivative.
pub(crate) fn derivative_of_function(value: &Value, order: usize) -> Result<Value, Diagnostic> {
    match value {
        Value::Function(function) => {
            let Some((variable, formula)) = function.as_formula() else {
                return Err(Diagnostic::error(
                    Code::Type,
                    "only functions of one variable given by one formula have a derivative here",
                )
                .hint("use diff(formula, variable)"));
            };
            Ok(formula_function(variable.clone(), nth_derivative(formula, variable, order)))
        }
        Value::Polar(polar) => match &polar.kind {
            PolarKind::Univariate(form) => Ok(Value::Polar(Arc::new(Polar {
                kind: PolarKind::Univariate(form.derivative(order)),
                variables: polar.variables.clone(),
            }))),
            _ => Err(Diagnostic::error(Code::Type, "say in which direction to differentiate")
                .hint("use diff(f, ...) on the polynomial")),
        },
        Value::Scalar(formula) => {
            let variable = variable_of(formula, None)?;
            Ok(Value::Scalar(nth_derivative(formula, &variable, order)))
        }
        Value::Geometry(_) | Value::Piecewise(_) => {
            let mut args = super::Arguments::default();
            args.push(value.clone(), Span::default());
            args.push(Value::int(order as i64), Span::default());
            match crate::language::functions::method("derivative", value) {
                Some(method) => method(&args),
                None => Err(wrong_kind("a function", value)),
            }
        }
        other => Err(wrong_kind("a function", other)),
    }
}

/// d^k/dt^k.
pub(crate) fn nth_derivative(formula: &Fraction, variable: &Symbol, order: usize) -> Fraction {
    let mut result = formula.clone();
    for _ in 0..order {
        if num_traits::Zero::is_zero(&result) {
            break;
        }
        result = result.derivative(variable);
    }
    result
}

/// ∫_a^b of a polynomial in the variable; without bounds the antiderivative that is 0 at 0.
pub(crate) fn integrate(
    formula: &Fraction,
    variable: &Symbol,
    bounds: Option<(&Fraction, &Fraction)>,
) -> Result<Fraction, Diagnostic> {
    let primitive = Coefficients::new(coefficients_in(formula, variable)?).antiderivative();
    Ok(match bounds {
        Some((a, b)) => primitive.value(b).minus(&primitive.value(a)),
        None => primitive.value(&Fraction::from(MultiPoly::symbol(variable.clone()))),
    })
}

/// How many of the ends a and b of dots are too many: none if both are written as numbers.
fn too_many(from: &Expr, to: &Expr, a: i64, b: i64) -> usize {
    let literal = |index: &Expr| matches!(index.kind, Kind::Number(_));
    if literal(from) && literal(to) {
        return 0;
    }
    usize::try_from(a.saturating_sub(b).saturating_add(1)).unwrap_or(0).min(2)
}

impl Machine {
    /// The bare symbol an expression names, for binding it.
    pub(crate) fn binder(&mut self, expr: &Expr) -> Result<Symbol, Diagnostic> {
        name_of(expr, self).ok_or_else(|| {
            Diagnostic::error(Code::BadDefinition, "expected a variable").at(expr.span).reason("not a name")
        })
    }

    pub(crate) fn eval_lambda(&mut self, parameters: &[Expr], body: &Expr) -> Evaluated {
        let mut names = Vec::with_capacity(parameters.len());
        for parameter in parameters {
            names.push(self.binder(parameter)?);
        }
        let clause = self.clause(names.iter().cloned().map(Parameter::Name).collect(), body)?;
        Ok(Value::Function(Arc::new(Function {
            name: None,
            shape: Shape::plain(names.len()),
            clauses: vec![clause],
        })))
    }

    /// A clause with the value of its body, if that exists for symbolic parameters. Unknown words in
    /// the body are reported where they are written, not when the function is called.
    pub(crate) fn clause(&mut self, parameters: Vec<Parameter>, body: &Expr) -> Result<Clause, Diagnostic> {
        let symbols: Vec<(Symbol, Value)> = parameters
            .iter()
            .filter_map(|parameter| match parameter {
                Parameter::Name(symbol) => Some((symbol.clone(), Value::symbol(symbol.clone()))),
                Parameter::Exactly(_) => None,
            })
            .collect();
        let notes = self.notes.len();
        // In b_i the parameter i chooses a name; there is no formula to put its value into.
        let chooses = symbols.iter().any(|(name, _)| is_index_in(name, body));
        let formula = match self.with_locals(symbols, |machine| machine.eval(body)) {
            Ok(Value::Scalar(formula)) if !chooses => Some(formula),
            Err(error) if matches!(error.code, Code::UnknownName | Code::UnknownFunction) => {
                return Err(error);
            }
            _ => None,
        };
        self.notes.truncate(notes);
        let mut scope = self.scope.clone();
        for (name, value) in &self.locals {
            Arc::make_mut(&mut scope).insert(name.clone(), value.clone());
        }
        Ok(Clause { parameters, body: body.clone(), written: false, formula, scope })
    }

    pub(crate) fn eval_big(
        &mut self,
        op: BigOp,
        lower: &[Expr],
        upper: Option<&Expr>,
        body: &Expr,
        span: Span,
    ) -> Evaluated {
        let combine: fn(Value, Value) -> Evaluated = match op {
            BigOp::Sum => arithmetic::add,
            BigOp::Product => arithmetic::multiply,
            BigOp::Max => |a, b| pick(a, b, true),
            BigOp::Min => |a, b| pick(a, b, false),
            BigOp::Union | BigOp::Intersection | BigOp::Limit => {
                return Err(unsupported("limits, unions and intersections have no value here").at(span));
            }
        };
        let assignments = self.index_values(lower, upper, span)?;
        let mut total: Option<Value> = None;
        for names in assignments {
            crate::budget::steps(8);
            let value = self.with_locals(names, |machine| machine.eval(body))?;
            total = Some(match total {
                None => value,
                Some(total) => combine(total, value).at(body.span)?,
            });
        }
        match (total, op) {
            (Some(total), _) => Ok(total),
            (None, BigOp::Sum) => Ok(Value::int(0)),
            (None, BigOp::Product) => Ok(Value::int(1)),
            (None, _) => Err(Diagnostic::error(Code::Domain, "nothing to choose from").at(span)),
        }
    }

    /// All values the index names of Σ or Π run through.
    fn index_values(
        &mut self,
        lower: &[Expr],
        upper: Option<&Expr>,
        span: Span,
    ) -> Result<Vec<Vec<(Symbol, Value)>>, Diagnostic> {
        let no_bounds = || {
            Diagnostic::error(Code::Undecided, "the bounds of this sum or product are not given")
                .at(span)
                .hint("write sum(i=0..3, ...) or \\sum_{i=0}^{3}")
        };
        let mut assignments: Vec<Vec<(Symbol, Value)>> = vec![Vec::new()];
        let mut filters: Vec<&Expr> = Vec::new();
        let mut bound_any = false;
        for (at, piece) in lower.iter().enumerate() {
            let Kind::Chain(left, links) = &piece.kind else { return Err(no_bounds().at(piece.span)) };
            let link = &links[0];
            match (link.rel, links.len()) {
                // i = a, with the upper bound above the sign, or i = a..b
                (Rel::Eq, 1) if name_of(left, self).is_some() && !mentions_enclosed(left) => {
                    let name = self.binder(left)?;
                    let (from, to) = match (&link.expr.kind, upper) {
                        (Kind::Range(from, to), _) => (self.eval_int(from)?, self.eval_int(to)?),
                        (_, Some(upper)) => (self.eval_int(&link.expr)?, self.eval_int(upper)?),
                        (_, None) => return Err(no_bounds().at(piece.span)),
                    };
                    let count = to.saturating_sub(from).saturating_add(1).max(0);
                    crate::budget::charge_terms(count as u64 * assignments.len() as u64);
                    let values: Vec<Value> = (from..=to).map(Value::int).collect();
                    assignments = extended(assignments, &name, &values);
                    bound_any = true;
                }
                // i + j + k = n: all ways to write n as an ordered sum of integers ≥ 0
                (Rel::Eq, 1) if matches!(left.kind, Kind::Add(_)) => {
                    let names = self.addends(left)?;
                    let total = self.eval_int(&link.expr)?;
                    let sums = compositions(total, names.len());
                    crate::budget::charge_terms(sums.len() as u64);
                    assignments = assignments
                        .iter()
                        .flat_map(|base| {
                            sums.iter().map(|sum| {
                                let values = sum.iter().map(|&i| Value::int(i));
                                base.iter().cloned().chain(names.iter().cloned().zip(values)).collect()
                            })
                        })
                        .collect();
                    bound_any = true;
                }
                // S ⊆ {1, …, n}, |S| = i
                (Rel::Subset, 1) => {
                    let name = self.binder(left)?;
                    let items = self.set_items(&link.expr)?;
                    let size = lower[at + 1..].iter().find_map(|other| size_condition(other, left));
                    let sizes = match size {
                        Some(size) => {
                            let size = self.eval_int(size)?;
                            // No subset has a negative size: one beyond the last has none either.
                            let size = usize::try_from(size).unwrap_or(items.len() + 1);
                            size..=size
                        }
                        None => 0..=items.len(),
                    };
                    let mut subsets = Vec::new();
                    for k in sizes {
                        for chosen in Combinations::new(items.len(), k) {
                            crate::budget::charge_terms(subsets.len() as u64 + 1);
                            subsets.push(Value::List(chosen.iter().map(|&i| items[i].clone()).collect()));
                        }
                    }
                    assignments = extended(assignments, &name, &subsets);
                    bound_any = true;
                }
                (Rel::In, 1) => {
                    let name = self.binder(left)?;
                    let items = self.set_items(&link.expr)?;
                    assignments = extended(assignments, &name, &items);
                    bound_any = true;
                }
                // a ≤ i ≤ b
                (Rel::Le | Rel::Lt, 2) if matches!(links[1].rel, Rel::Le | Rel::Lt) => {
                    let name = self.binder(&link.expr)?;
                    let from = self.eval_int(left)? + i64::from(link.rel == Rel::Lt);
                    let to = self.eval_int(&links[1].expr)? - i64::from(links[1].rel == Rel::Lt);
                    crate::budget::charge_terms(to.saturating_sub(from).saturating_add(1).max(0) as u64);
                    let values: Vec<Value> = (from..=to).map(Value::int).collect();
                    assignments = extended(assignments, &name, &values);
                    bound_any = true;
                }
                (Rel::Eq, 1) if matches!(left.kind, Kind::Enclosed(..)) => {} // |S| = i, used above
                _ => filters.push(piece),
            }
        }
        if !bound_any {
            return Err(no_bounds());
        }
        for filter in filters {
            let mut kept = Vec::with_capacity(assignments.len());
            for names in assignments {
                let value = self.with_locals(names.clone(), |machine| machine.eval(filter))?;
                let Value::Claim(claim) = &value else {
                    return Err(wrong_kind("a condition", &value).at(filter.span));
                };
                match super::claim::decided(claim) {
                    Some(true) => kept.push(names),
                    Some(false) => {}
                    None => {
                        return Err(Diagnostic::error(
                            Code::Undecided,
                            "whether this condition holds depends on symbols",
                        )
                        .at(filter.span)
                        .hint("give the names in it a value first"));
                    }
                }
            }
            assignments = kept;
        }
        Ok(assignments)
    }

    /// The names of `i + j + k`.
    fn addends(&mut self, sum: &Expr) -> Result<Vec<Symbol>, Diagnostic> {
        let Kind::Add(terms) = &sum.kind else { return Ok(Vec::new()) };
        let mut names = Vec::with_capacity(terms.len());
        for term in terms {
            if term.sign == crate::formula::Sign::Minus {
                return Err(unsupported("an index condition with a minus sign").at(term.expr.span));
            }
            names.push(self.binder(&term.expr)?);
        }
        Ok(names)
    }

    fn set_items(&mut self, set: &Expr) -> Result<Vec<Value>, Diagnostic> {
        match &set.kind {
            Kind::Set(items, None) => self.expand_items(items),
            _ => match self.eval(set)? {
                Value::List(items) => Ok(items),
                other => Err(wrong_kind("a set such as {1, ..., n}", &other).at(set.span)),
            },
        }
    }

    /// Fills `a_1, ..., a_5` or `1, ..., n`: what stands before is already in `values`.
    ///
    /// Says how many of the two ends are too many: in t_1, ..., t_{i-1} one for i = 2, when both
    /// ends are t_1, and two for i = 1, when there is nothing at all.
    pub(crate) fn fill_ellipsis(
        &mut self,
        before: &Expr,
        after: &Expr,
        values: &mut Vec<Value>,
        span: Span,
    ) -> Result<usize, Diagnostic> {
        let unclear = || {
            unsupported("what the ellipsis stands for is not clear")
                .at(span)
                .hint("it is filled between numbers (1, ..., 5) and between indices (t1, ..., t5)")
        };
        // In 0, 2, ..., 10 the two numbers before the dots tell the step.
        let previous = values.len().checked_sub(2).and_then(|i| values[i].as_int());
        let (first, last) = (self.eval(before)?, self.eval(after)?);
        if let (Some(a), Some(b)) = (first.as_int(), last.as_int()) {
            let step = previous.map_or(1, |p| a - p).max(1);
            crate::budget::charge_terms(b.saturating_sub(a).max(0) as u64);
            values.extend((a + step..b).step_by(usize::try_from(step).unwrap_or(1)).map(Value::int));
            return Ok(too_many(before, after, a, b));
        }
        let (Kind::Subscript(base, from), Kind::Subscript(_, to)) = (&before.kind, &after.kind) else {
            return Err(unclear());
        };
        let place = from.iter().zip(to).position(|(a, b)| !a.same_as(b)).ok_or_else(unclear)?;
        let (a, b) = (self.eval_int(&from[place])?, self.eval_int(&to[place])?);
        crate::budget::charge_terms(b.saturating_sub(a).max(0) as u64);
        for i in a + 1..b {
            let mut indices = from.clone();
            indices[place] = Expr::int(i);
            values.push(self.eval(&Kind::Subscript(base.clone(), indices).into())?);
        }
        Ok(too_many(&from[place], &to[place], a, b))
    }

    pub(crate) fn eval_integral(
        &mut self,
        lower: Option<&Expr>,
        upper: Option<&Expr>,
        body: &Expr,
        variable: &Expr,
    ) -> Evaluated {
        let name = self.binder(variable)?;
        let bounds = match (lower, upper) {
            (Some(a), Some(b)) => Some((self.eval_scalar(a)?, self.eval_scalar(b)?)),
            (None, None) => None,
            (Some(one), None) | (None, Some(one)) => {
                return Err(unsupported("an integral with one bound only").at(one.span));
            }
        };
        let own = Value::symbol(name.clone());
        let integrand = self.with_locals([(name.clone(), own)], |machine| machine.eval_scalar(body))?;
        let bounds = bounds.as_ref().map(|(a, b)| (a, b));
        integrate(&integrand, &name, bounds).map(Value::Scalar).at(body.span)
    }

    pub(crate) fn eval_derivative(
        &mut self,
        variables: &[(Expr, Option<Expr>)],
        body: Option<&Expr>,
        span: Span,
    ) -> Evaluated {
        let Some(body) = body else {
            return Err(unsupported("a differential operator without a function").at(span));
        };
        let mut orders = Vec::with_capacity(variables.len());
        for (variable, order) in variables {
            let order = match order {
                Some(order) => self.eval_int(order)?,
                None => 1,
            };
            let order = usize::try_from(order).map_err(|_| {
                Diagnostic::error(Code::BadExponent, "a negative order of differentiation").at(span)
            })?;
            orders.push((self.binder(variable)?, order));
        }
        let own: Vec<(Symbol, Value)> =
            orders.iter().map(|(name, _)| (name.clone(), Value::symbol(name.clone()))).collect();
        let value = self.with_locals(own, |machine| machine.eval(body))?;
        if let (Value::Function(_) | Value::Polar(_), [(_, order)]) = (&value, orders.as_slice()) {
            return derivative_of_function(&value, *order).at(body.span);
        }
        let Value::Scalar(mut result) = value else {
            return Err(wrong_kind("a formula or function to differentiate", &value).at(body.span));
        };
        for (name, order) in &orders {
            result = nth_derivative(&result, name, *order);
        }
        // Outside the operator the variables have their own values again.
        let bound: Vec<(Symbol, Fraction)> = orders
            .iter()
            .filter_map(|(name, _)| Some((name.clone(), self.lookup(name)?.as_scalar()?.clone())))
            .collect();
        result.substitute(&bound).map(Value::Scalar).map_err(|_| arithmetic::division_by_zero()).at(span)
    }

    pub(crate) fn eval_at(
        &mut self,
        body: &Expr,
        lower: &[Expr],
        upper: Option<&Expr>,
        span: Span,
    ) -> Evaluated {
        if let Some(upper) = upper {
            return self.eval_between(body, lower, upper, span);
        }
        let mut names = Vec::new();
        for piece in lower {
            let Kind::Chain(left, links) = &piece.kind else {
                return Err(unsupported("expected t = value at the bar").at(piece.span));
            };
            let Some(last) = links.last() else { continue };
            let value = self.eval_scalar(&last.expr)?;
            names.push((self.binder(left)?, value.clone()));
            for link in &links[..links.len() - 1] {
                if link.expr.kind != Kind::Ellipsis {
                    names.push((self.binder(&link.expr)?, value.clone()));
                }
            }
        }
        let own: Vec<(Symbol, Value)> =
            names.iter().map(|(name, _)| (name.clone(), Value::symbol(name.clone()))).collect();
        let formula = self.with_locals(own, |machine| match machine.eval(body)? {
            // dF/dt is a function; its variable is the one at the bar
            Value::Function(function) => match (function.as_formula(), names.as_slice()) {
                (Some((own, formula)), [(name, _)]) => formula
                    .substitute(&[(own.clone(), Fraction::from(MultiPoly::symbol(name.clone())))])
                    .map_err(|_| arithmetic::division_by_zero()),
                _ => Err(wrong_kind("a formula", &Value::Function(function))),
            },
            Value::Scalar(formula) => Ok(formula),
            other => Err(wrong_kind("a number or formula", &other)),
        });
        let formula = formula.at(body.span)?;
        formula.substitute(&names).map(Value::Scalar).map_err(|_| arithmetic::division_by_zero()).at(span)
    }

    /// [F(t)]_a^b = F(b) - F(a).
    fn eval_between(&mut self, body: &Expr, lower: &[Expr], upper: &Expr, span: Span) -> Evaluated {
        let [from] = lower else {
            return Err(unsupported("several lower bounds at a bar").at(span));
        };
        let (given, from) = match &from.kind {
            Kind::Chain(left, links) => (Some(self.binder(left)?), &links[links.len() - 1].expr),
            _ => (None, from),
        };
        let (a, b) = (self.eval_scalar(from)?, self.eval_scalar(upper)?);
        let own = given.iter().map(|name| (name.clone(), Value::symbol(name.clone())));
        let formula = self.with_locals(own.collect::<Vec<_>>(), |machine| machine.eval_scalar(body))?;
        let variable = variable_of(&formula, given).at(body.span)?;
        let at = |x| formula.substitute(&[(variable.clone(), x)]).map_err(|_| arithmetic::division_by_zero());
        Ok(Value::Scalar(at(b).at(span)?.minus(&at(a).at(span)?)))
    }

    /// F ∘ G.
    pub(crate) fn compose(&mut self, outer: Value, inner: Value) -> Evaluated {
        if let Some(method) = crate::language::functions::method("compose", &outer) {
            let mut args = super::Arguments::default();
            args.push(outer, Span::default());
            args.push(inner, Span::default());
            return method(&args);
        }
        let parts = |value: &Value| -> Result<(Symbol, Fraction), Diagnostic> {
            match value {
                Value::Function(f) => f
                    .as_formula()
                    .map(|(t, formula)| (t.clone(), formula.clone()))
                    .ok_or_else(|| wrong_kind("a function of one variable given by one formula", value)),
                Value::Scalar(formula) => Ok((variable_of(formula, None)?, formula.clone())),
                other => Err(wrong_kind("a function", other)),
            }
        };
        let scalars = matches!((&outer, &inner), (Value::Scalar(_), Value::Scalar(_)));
        let (variable, formula) = parts(&outer)?;
        let (inner_variable, inner_formula) = parts(&inner)?;
        let result =
            formula.substitute(&[(variable, inner_formula)]).map_err(|_| arithmetic::division_by_zero())?;
        Ok(if scalars { Value::Scalar(result) } else { formula_function(inner_variable, result) })
    }

    pub(crate) fn eval_scalar(&mut self, expr: &Expr) -> Result<Fraction, Diagnostic> {
        match self.eval(expr)? {
            Value::Scalar(x) => Ok(x),
            other => Err(wrong_kind("a number or formula", &other).at(expr.span)),
        }
    }
}

/// Whether a name occurs within the index of another: i in b_i, n - i in p_{n-i}.
fn is_index_in(name: &Symbol, expr: &Expr) -> bool {
    fn search(name: &Symbol, expr: &Expr, within: bool) -> bool {
        match &expr.kind {
            Kind::Name(other) => within && *name == Symbol::new(other),
            Kind::Subscript(base, indices) | Kind::Upper(base, indices) => {
                search(name, base, within) || indices.iter().any(|index| search(name, index, true))
            }
            _ => {
                let mut found = false;
                expr.for_each_child(&mut |child| found = found || search(name, child, within));
                found
            }
        }
    }
    search(name, expr, false)
}

fn pick(a: Value, b: Value, larger: bool) -> Evaluated {
    match (a.as_rational(), b.as_rational()) {
        (Some(x), Some(y)) => Ok(if (x >= y) == larger { a } else { b }),
        _ => Err(Diagnostic::error(Code::Undecided, "only numbers can be compared")),
    }
}

fn extended(
    assignments: Vec<Vec<(Symbol, Value)>>,
    name: &Symbol,
    values: &[Value],
) -> Vec<Vec<(Symbol, Value)>> {
    let mut result = Vec::with_capacity(assignments.len() * values.len());
    for base in assignments {
        for value in values {
            let mut names = base.clone();
            names.push((name.clone(), value.clone()));
            result.push(names);
        }
    }
    result
}

fn mentions_enclosed(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::Enclosed(..))
}

/// The right-hand side of `|S| = size` for the given S.
fn size_condition<'a>(condition: &'a Expr, set: &Expr) -> Option<&'a Expr> {
    let Kind::Chain(left, links) = &condition.kind else { return None };
    let Kind::Enclosed(_, inner) = &left.kind else { return None };
    (links.len() == 1 && links[0].rel == Rel::Eq && inner.same_as(set)).then(|| &links[0].expr)
}

/// All ordered lists of `parts` integers ≥ 0 with the given sum, first part descending.
fn compositions(total: i64, parts: usize) -> Vec<Vec<i64>> {
    if parts == 0 || total < 0 {
        return if parts == 0 && total == 0 { vec![Vec::new()] } else { Vec::new() };
    }
    if parts == 1 {
        return vec![vec![total]];
    }
    let mut all = Vec::new();
    for first in (0..=total).rev() {
        crate::budget::charge_terms(all.len() as u64);
        for rest in compositions(total - first, parts - 1) {
            let mut list = vec![first];
            list.extend(rest);
            all.push(list);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordered_sums() {
        assert_eq!(compositions(2, 2), [[2, 0], [1, 1], [0, 2]]);
        assert_eq!(compositions(0, 3), [[0, 0, 0]]);
        assert_eq!(compositions(4, 3).len(), 15);
        assert!(compositions(-1, 2).is_empty());
    }
}
