//! Derivatives of functions, at arguments.

use super::calls::{each, unclear};
use super::definitions::OPEN_PIECE;
use super::{Evaluated, Model};
use crate::formula::{Expr, Kind};
use crate::judge::page::context::Body;
use crate::judge::page::object::Sort;
use crate::judge::values::equality::symbols;
use crate::judge::written::names::{Head, bases, calls, primed};
use crate::language::eval::Machine;
use crate::language::ops::arithmetic;
use crate::language::ops::calculus::nth_derivative;
use crate::language::ops::errors::division_by_zero;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Symbol};

/// The variable in which functions are differentiated.
const FRESH: &str = "\u{2022}";

impl Model {
    /// d^3/dt^3 F(0): the derivative of F, of which 0 is the argument.
    pub(super) fn derivative_at_number(
        &self,
        machine: &mut Machine,
        variables: &[(Expr, Option<Expr>)],
        body: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let ([(_, order)], Kind::Apply(callee, groups)) = (variables, &body.kind) else { return None };
        let [argument] = groups.as_slice() else { return None };
        let [number] = argument.as_slice() else { return None };
        if !bases(number).is_empty() || !self.is_function(machine, callee) {
            return None;
        }
        let order = match order {
            Some(order) => usize::try_from(machine.eval_int(order).ok()?).ok()?,
            None => 1,
        };
        let at = match machine.eval(number) {
            Ok(value) => vec![vec![value]],
            Err(error) => return Some(Err(error)),
        };
        Some(self.derivative(machine, callee, order, &at, expr))
    }

    /// D_d F(u, v, w) = d_1 F_u + d_2 F_v + d_3 F_w, unless the page says what D is.
    pub(super) fn directional_derivative(
        &self,
        machine: &mut Machine,
        operator: &Expr,
        function: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let (Kind::Subscript(letter, direction), Kind::Apply(callee, groups)) =
            (&operator.kind, &function.kind)
        else {
            return None;
        };
        let ([direction], [arguments], Kind::Name(letter)) =
            (direction.as_slice(), groups.as_slice(), &letter.kind)
        else {
            return None;
        };
        let own = Head::of(direction).filter(|own| own.lower.is_empty() && own.arguments.is_none())?;
        let known = self.context.visible(letter, &self.place).next().is_some();
        if letter != "D" || known || !self.is_function(machine, callee) {
            return None;
        }
        let listed = |base: &str| {
            self.context.visible(base, &self.place).find_map(|(_, definition, _)| match &definition.body {
                Body::Formula(body) => body.items().map(<[Expr]>::to_vec),
                Body::Value(_) => None,
            })
        };
        let mut free = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let Kind::Name(name) = &argument.kind else { return None };
            free.push(Symbol::new(name));
        }
        let member =
            |i: usize| Kind::Subscript(Box::new(direction.clone()), vec![Expr::int(i as i64)]).into();
        let given = listed(&own.base);
        // F(τ), with the coordinates τ_1, τ_2, τ_3
        if let [point] = free.as_slice() {
            let count =
                given.as_ref().or(listed(point.base()).as_ref()).map(Vec::len).filter(|count| *count > 1)?;
            free = (1..=count as i64).map(|i| point.numbered(i)).collect();
        }
        let components = given.unwrap_or_else(|| (1..=free.len()).map(member).collect());
        if components.len() != free.len() {
            return Some(Err(unclear("what this direction is", expr)));
        }
        self.note("D_d is the derivative in the direction d");
        let names: Vec<(Symbol, Value)> = free
            .iter()
            .filter(|name| name.is_plain())
            .map(|name| (name.clone(), Value::symbol(name.clone())))
            .collect();
        let value = match machine.with_locals(names, |machine| machine.eval(function)) {
            Ok(Value::Scalar(value)) => value,
            Ok(_) => return Some(Err(unclear("what is differentiated here", expr))),
            Err(error) => return Some(Err(error)),
        };
        let mut sum = Value::int(0);
        for (name, component) in free.iter().zip(&components) {
            let slope = Value::Scalar(nth_derivative(&value, name, 1));
            let term = machine.eval(component).and_then(|component| arithmetic::multiply(component, slope));
            sum = match term.and_then(|term| arithmetic::add(sum, term)) {
                Ok(sum) => sum,
                Err(error) => return Some(Err(error.at(expr.span))),
            };
        }
        Some(Ok(sum))
    }

    /// ∂F/∂u (a, b): the derivative at the function's own variables, then the arguments put in.
    pub(super) fn derivative_at(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        function: &Expr,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Evaluated {
        let arguments: Option<Vec<Fraction>> =
            values.iter().flatten().map(|value| value.as_scalar().cloned()).collect();
        let head = Head::of(function);
        let own: Option<Vec<Symbol>> = head.and_then(|head| {
            let count = values.iter().flatten().count();
            // z = 1 + 4u + 2v beside z(u, v) is a plane.
            let mut visible = self.context.visible(&head.base, &self.place);
            let (_, definition, _) = visible.find(|(_, own, _)| own.head.flat().len() == count)?;
            let name = |argument: &&Expr| match &argument.kind {
                Kind::Name(name) => Some(Symbol::new(name)),
                _ => None,
            };
            definition.head.flat().iter().map(name).collect()
        });
        let (Some(arguments), Some(own)) = (arguments, own) else {
            return Err(unclear("what the value of this derivative is", expr));
        };
        let free: Vec<(Symbol, Value)> =
            own.iter().map(|name| (name.clone(), Value::symbol(name.clone()))).collect();
        let derivative = machine.with_locals(free, |machine| machine.eval(callee))?;
        let Value::Scalar(formula) = derivative else {
            return Err(unclear("what the value of this derivative is", expr));
        };
        let put: Vec<(Symbol, Fraction)> = own.into_iter().zip(arguments).collect();
        formula.substitute(&put).map(Value::Scalar).map_err(|_| division_by_zero())
    }

    /// The derivative of a function of one variable, at a value.
    pub(super) fn derivative(
        &self,
        machine: &mut Machine,
        function: &Expr,
        order: usize,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Evaluated {
        let [group] = values else {
            return Err(unclear("the derivative of a function of two groups of arguments", expr));
        };
        let [argument] = group.as_slice() else {
            return Err(unclear("in which variable this is differentiated", expr));
        };
        let Value::Scalar(argument) = argument else {
            return Err(unclear("the derivative at something that is not a number", expr));
        };
        if order == 0 {
            return self.apply(machine, function, values, expr);
        }
        // x''(t), where the page says what x'(t) is, and not what x is
        if let Some((given, derivative)) = self.derivative_given(function, order) {
            return self.derivative(machine, &derivative, order - given, values, expr);
        }
        let fresh = Symbol::new(FRESH);
        let own = vec![vec![Value::symbol(fresh.clone())]];
        // Near the argument it is a polynomial.
        let spline = Head::of(function).and_then(|head| self.object(&head)).map(|told| told.object.clone());
        let spline = spline.filter(|told| told.sort == Sort::SplineCurve && !told.points.is_empty());
        let around = if self.is_local() || spline.is_some() { self.number_here(argument) } else { None };
        let derived = |value: Value| {
            each(value, &|formula| {
                // A point of an algorithm, of which it is not known how it depends on the variable
                let own = formula.variables();
                if !own.contains(&fresh) && own.iter().any(|symbol| !symbol.upper().is_empty()) {
                    return Err(unclear("how this function depends on its variable", expr));
                }
                let derived = nth_derivative(&formula, &fresh, order);
                derived.substitute(&[(fresh.clone(), argument.clone())]).map_err(|_| division_by_zero())
            })
        };
        // At a knot of a spline both sides have to agree, where there are two.
        if let (Some(spline), Some(at)) = (spline, argument.as_rational()) {
            let near = Rational::new(1.into(), (1i64 << 40).into());
            let end = |knot: Option<&Expr>| knot.and_then(Expr::as_number) == Some(&at);
            let mut side = |at: Rational| {
                let value = self.moved(Some(at), || self.apply(machine, function, &own, expr));
                value.and_then(derived)
            };
            let (left, right) = (side(&at - &near)?, side(&at + &near)?);
            return match (end(spline.knots.first()), end(spline.knots.last())) {
                (true, false) => Ok(right),
                (false, true) => Ok(left),
                _ if left == right => Ok(left),
                _ => Err(unclear("what the derivative at this knot is", expr)),
            };
        }
        let outer = self.place_of_derivative.replace(Some(argument.clone()));
        let value = self.moved(around, || self.apply(machine, function, &own, expr));
        self.place_of_derivative.replace(outer);
        match (value, argument.as_rational()) {
            // Given by several formulas: the derivatives from both sides have to agree.
            (Err(error), Some(at)) if error.message == OPEN_PIECE => {
                let near = Rational::new(1.into(), (1i64 << 40).into());
                let mut side = |at: Rational| {
                    let value = self.moved(Some(at), || self.apply(machine, function, &own, expr))?;
                    derived(value)
                };
                let (left, right) = (side(&at - &near)?, side(&at + &near)?);
                if left == right {
                    Ok(left)
                } else {
                    Err(unclear("what the derivative at this knot is", expr))
                }
            }
            (value, _) => derived(value?),
        }
    }

    /// The highest derivative, up to an order, that the page gives of a function of which it says no more.
    fn derivative_given(&self, function: &Expr, order: usize) -> Option<(usize, Expr)> {
        let head = Head::of(function).filter(|head| head.lower.is_empty() && head.upper.is_empty())?;
        let visible = |name: &str| self.context.visible(name, &self.place).next().is_some();
        if visible(&head.base) {
            return None;
        }
        let given = (1..=order).rev().find(|order| visible(&primed(&head.base, *order)))?;
        let name = Kind::Name(primed(&head.base, given));
        Some((given, Expr::new(name, function.span)))
    }

    /// F' alone, as in F' = 3 t^2.
    pub(super) fn derived_name(
        &self,
        machine: &mut Machine,
        body: &Expr,
        order: usize,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let Some(head) = Head::of(body) else {
            // (f^2)' is no derivative in f.
            let function = |name: &String| {
                let told = self.context.object_called(name, &self.place);
                self.context.letters.is_function(name) || told.is_some_and(|told| told.object.is_function())
            };
            return bases(body)
                .iter()
                .any(|name| function(name) && !calls(body, name))
                .then(|| Err(unclear("what is differentiated here", expr)));
        };
        if machine.lookup(&Symbol::new(&head.base)).is_some() {
            return None;
        }
        let context = self.context.clone();
        let given = self.derivative_given(body, order).and_then(|(_, derivative)| Head::of(&derivative));
        let known = given.as_ref().unwrap_or(&head);
        let definition = context.visible(&known.base, &self.place).find_map(|(_, definition, _)| {
            let arguments = definition.head.flat();
            match arguments.as_slice() {
                [one] => Head::of(one).map(|own| own.base),
                _ => None,
            }
        });
        let Some(variable) = definition else {
            // x''' of a cubic is a constant.
            let here = Symbol::new(FRESH.repeat(2));
            let value = self.derivative(machine, body, order, &[vec![Value::symbol(here.clone())]], expr);
            let constant = value.ok().filter(|value| !symbols(value).contains(&here));
            return Some(constant.ok_or_else(|| unclear("what is differentiated here", expr)));
        };
        let variable = Symbol::new(&variable);
        let own = vec![vec![Value::symbol(variable)]];
        Some(self.derivative(machine, body, order, &own, expr))
    }
}
