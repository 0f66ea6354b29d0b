//! Calls: definitions, derivatives, standard families, polar forms, unknown functions.

use super::{Ambiguity, Evaluated, Model};
use crate::formula::{Accent, Expr, Kind, Sign};
use crate::judge::page::context::{Body, Definition, Source, is_variable};
use crate::judge::page::object::Sort;
use crate::judge::written::names::{Head, bases, is_extreme, is_index_letter};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::lexicon::{families, roles};
use crate::language::ops::arithmetic;
use crate::language::ops::calculus::nth_derivative;
use crate::language::ops::errors::division_by_zero;
use crate::language::value::Value;
use crate::math::poly::{Fraction, MultiPoly, Symbol};

impl Model {
    /// `callee(groups)`; `None` if it is no call of a function.
    pub(super) fn call(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        groups: &[Vec<Expr>],
        expr: &Expr,
    ) -> Option<Evaluated> {
        // The greater of two numbers is what it is in queries.
        if is_extreme(callee) {
            return None;
        }
        if !self.is_function(machine, callee) {
            return self
                .as_value_of_formula(machine, callee, groups)
                .or_else(|| self.as_product(machine, callee, groups, None, expr));
        }
        if let Some(result) = self.functional(machine, callee, groups) {
            return Some(result);
        }
        if let (Kind::Name(name), true) = (&callee.kind, self.is_queried(callee, groups))
            && let Some(Ok(function)) = self.defined(machine, &Head::of(callee)?, None)
        {
            let own = [(Symbol::new(name), function)];
            return Some(machine.with_locals(own, |machine| machine.eval(expr)));
        }
        // A permutation of all arguments: F(π(u_1, …, u_n)).
        if let [group] = groups
            && let [only] = group.as_slice()
            && let Kind::Apply(inner, permuted) = &only.kind
            && matches!(&inner.kind, Kind::Name(name) if name == "pi")
        {
            let [list] = permuted.as_slice() else { return None };
            let values = self.arguments(machine, list, None, expr).map(|mut values| {
                let shift = 1.min(values.len());
                values.rotate_left(shift);
                vec![values]
            });
            return Some(values.and_then(|values| self.apply(machine, callee, &values, expr)));
        }
        // S(x_i - 0) and S(x_i + 0) are limits from one side.
        let one_sided = groups.iter().flatten().any(|argument| {
            matches!(&argument.kind, Kind::Add(terms) if terms.len() == 2
                && matches!(&terms[1].expr.kind, Kind::Number(q) if num_traits::Zero::is_zero(q)))
        });
        if one_sided {
            return Some(Err(unclear("what a limit from one side is", expr)));
        }
        let mut values = Vec::with_capacity(groups.len());
        self.flexible.set(false);
        let head = Head::of(callee);
        let polar = head.as_ref().and_then(|head| self.stated_arity(machine, head));
        let arity = head.and_then(|head| self.arity(&head, polar, groups.len()));
        for group in groups {
            // f(t^n)
            let repeated = match polar {
                Some(_) => self.repeated_by_powers(machine, group, polar),
                None => Ok(None),
            };
            let group = repeated.and_then(|repeated| match repeated {
                Some(values) => Ok(values),
                None => self.arguments(machine, group, arity, expr),
            });
            match group {
                Ok(group) => values.push(group),
                Err(error) => return Some(Err(error)),
            }
        }
        Some(self.apply(machine, callee, &values, expr))
    }

    /// q(2t - 1), where the page says q = x^2 - 1: a product, or the value at 2t - 1.
    fn as_value_of_formula(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        groups: &[Vec<Expr>],
    ) -> Option<Evaluated> {
        let [group] = groups else { return None };
        let [argument @ Expr { kind: Kind::Add(_) | Kind::Mul(_) | Kind::Number(_) | Kind::Div(..), .. }] =
            group.as_slice()
        else {
            return None;
        };
        let head = Head::of(callee).filter(|head| head.arguments.is_none())?;
        let formula = |definition: &Definition| match &definition.body {
            Body::Formula(body) => {
                Head::of(body).is_none() && bases(body).iter().any(|name| is_variable(name))
            }
            Body::Value(_) => false,
        };
        let near = self.context.visible(&head.base, &self.place).find(|(_, _, near)| *near);
        if !near.is_some_and(|(_, definition, _)| formula(definition)) {
            return None;
        }
        let Ok(Value::Scalar(value)) = machine.eval(callee) else { return None };
        let [variable] = <[Symbol; 1]>::try_from(value.variables()).ok()?;
        if !variable.is_plain() || !is_variable(variable.base()) {
            return None;
        }
        self.ambiguous(Ambiguity::Applied);
        if !self.choices.applied {
            return None;
        }
        Some(machine.eval(argument).and_then(|argument| match argument {
            Value::Scalar(at) => match value.substitute(&[(variable, at)]) {
                Ok(value) => Ok(Value::Scalar(value)),
                Err(_) => Err(unclear("what this value is", callee)),
            },
            _ => Err(unclear("what this argument is", callee)),
        }))
    }

    /// f_0(1 - t)^2, where the page applies f to nothing and says f_0 by itself: a product.
    pub(super) fn as_product(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        groups: &[Vec<Expr>],
        exponent: Option<&Expr>,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let [group] = groups else { return None };
        let [factor @ Expr { kind: Kind::Add(_), .. }] = group.as_slice() else { return None };
        let head = Head::of(callee).filter(|head| !head.lower.is_empty())?;
        let member = roles::NAMED_FUNCTIONS.contains(&head.base.as_str())
            && !self.context.letters.is_function(&head.base);
        let factor = factor.clone().grouped();
        let factor = match exponent {
            Some(exponent) => factor.power(exponent.clone()),
            None => factor,
        };
        member.then(|| machine.eval(&Expr::new(Kind::Mul(vec![callee.clone(), factor]), expr.span)))
    }

    /// Whether a query says what is called, so that the language knows how to call it: f := polar(…).
    fn is_queried(&self, callee: &Expr, groups: &[Vec<Expr>]) -> bool {
        let Kind::Name(name) = &callee.kind else { return false };
        let written_out = |item: &Expr| !matches!(item.kind, Kind::Ellipsis | Kind::Brace(..));
        groups.iter().flatten().all(written_out)
            && self.context.visible(name, &self.place).next().is_some_and(|(_, definition, _)| {
                definition.source == Source::Query
                    && definition.head.arguments.is_none()
                    && definition.head.lower.is_empty()
            })
    }

    /// Whether what stands before a bracket is a function and not a factor.
    pub(super) fn is_function(&self, machine: &mut Machine, callee: &Expr) -> bool {
        match &callee.kind {
            Kind::Prime(..) | Kind::Derivative { .. } => true,
            Kind::Accent(Accent::Dot | Accent::Ddot, _) => true,
            Kind::Subscript(base, _) if matches!(base.kind, Kind::Accent(Accent::Dot | Accent::Ddot, _)) => {
                true
            }
            Kind::Group(inner) => match &inner.kind {
                Kind::Add(terms) => terms.iter().all(|term| self.is_function(machine, &term.expr)),
                Kind::Mul(factors) => {
                    let mut function = |factor: &Expr| self.is_function(machine, factor);
                    factors.iter().any(&mut function)
                        && factors.iter().all(|factor| function(factor) || self.is_identity(factor))
                }
                Kind::Compose(_) | Kind::Derivative { .. } => true,
                _ => self.is_function(machine, inner),
            },
            _ => {
                let Some(head) = Head::of(callee) else { return false };
                if head.arguments.is_some() {
                    return false;
                }
                let plain = head.lower.is_empty() && head.upper.is_empty();
                if plain && machine.lookup(&Symbol::new(&head.base)).is_some() {
                    return false;
                }
                if let Some(declared) = self.object(&head)
                    && !matches!(declared.object.sort, Sort::Other(_))
                {
                    return declared.object.is_function();
                }
                let context = self.context.clone();
                let defined = context
                    .visible(&head.base, &self.place)
                    .find(|(_, definition, _)| definition.head.lower.len() == head.lower.len());
                // k (t) is a product, unless k(t) was defined.
                let applied = || {
                    defined.is_some_and(|(_, definition, near)| near && definition.head.arguments.is_some())
                };
                if plain
                    && is_index_letter(&head.base)
                    && !self.context.letters.is_function(&head.base)
                    && !applied()
                {
                    return false;
                }
                match defined {
                    Some((_, definition, near)) if near || !self.context.letters.is_function(&head.base) => {
                        definition.head.arguments.is_some() || self.context.letters.is_function(&head.base)
                    }
                    _ => {
                        self.context.letters.is_function(&head.base)
                            || (families::is_family(&head.base) || head.base == "P")
                                && !(head.lower.is_empty() && head.upper.is_empty())
                    }
                }
            }
        }
    }

    /// Whether a factor of a function is a variable, which stands for itself: x in x f.
    fn is_identity(&self, factor: &Expr) -> bool {
        matches!(&factor.kind, Kind::Name(name) if is_variable(name)
            && self.context.visible(name, &self.place).next().is_none())
    }

    /// The value of a function at arguments that are values already.
    pub(super) fn apply(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Evaluated {
        match &callee.kind {
            // (B_n f)(x), where the page says what it is
            Kind::Group(_)
                if Head::of(callee)
                    .is_some_and(|head| self.context.visible(&head.base, &self.place).next().is_some()) =>
            {
                self.apply_head(machine, callee, values, expr)
            }
            Kind::Group(inner) => self.apply(machine, inner, values, expr),
            Kind::Accent(Accent::Bold | Accent::Script | Accent::Blackboard, inner)
                if matches!(inner.kind, Kind::Group(_)) =>
            {
                self.apply(machine, inner, values, expr)
            }
            Kind::Prime(inner, order) => self.derivative(machine, inner, *order as usize, values, expr),
            Kind::Accent(Accent::Dot, inner) => self.derivative(machine, inner, 1, values, expr),
            Kind::Accent(Accent::Ddot, inner) => self.derivative(machine, inner, 2, values, expr),
            Kind::Subscript(base, lower) => {
                let (order, inner) = match &base.kind {
                    Kind::Accent(Accent::Dot, inner) => (1, inner),
                    Kind::Accent(Accent::Ddot, inner) => (2, inner),
                    _ => return self.apply_head(machine, callee, values, expr),
                };
                let inner = Expr::new(Kind::Subscript(inner.clone(), lower.clone()), callee.span);
                self.derivative(machine, &inner, order, values, expr)
            }
            Kind::Derivative { variables, body: Some(body), .. } => {
                if let ([(_, order)], [group]) = (variables.as_slice(), values)
                    && group.len() == 1
                {
                    let order = match order {
                        Some(order) => machine.eval_int(order)?,
                        None => 1,
                    };
                    return self.derivative(machine, body, order.max(0) as usize, values, expr);
                }
                self.derivative_at(machine, callee, body, values, expr)
            }
            // (f + g)(t_1, t_2, t_3): each takes as many arguments as it has.
            Kind::Add(terms) => {
                let mut sum: Option<Value> = None;
                for term in terms {
                    let value = self.apply_some(machine, &term.expr, values, expr)?;
                    let value = if term.sign == Sign::Minus { arithmetic::negate(value)? } else { value };
                    sum = Some(match sum {
                        None => value,
                        Some(sum) => arithmetic::add(sum, value)?,
                    });
                }
                sum.ok_or_else(|| Diagnostic::error(Code::Empty, "an empty sum").at(expr.span))
            }
            Kind::Mul(factors) => {
                let mut product = Value::int(1);
                for factor in factors {
                    let value = match values {
                        // (x f)(t) = t f(t)
                        [group] if group.len() == 1 && self.is_identity(factor) => group[0].clone(),
                        _ => self.apply_some(machine, factor, values, expr)?,
                    };
                    product = arithmetic::multiply(product, value)?;
                }
                Ok(product)
            }
            Kind::Compose(items) => {
                let mut current = values.to_vec();
                let mut result = None;
                for item in items.iter().rev() {
                    let value = self.apply(machine, item, &current, expr)?;
                    current = vec![vec![value.clone()]];
                    result = Some(value);
                }
                result.ok_or_else(|| Diagnostic::error(Code::Empty, "nothing is composed").at(expr.span))
            }
            _ => self.apply_head(machine, callee, values, expr),
        }
    }

    /// As [`Model::apply`], with the first arguments only if the function takes fewer.
    fn apply_some(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Evaluated {
        if let ([group], Some(head)) = (values, Head::of(callee)) {
            for count in (1..group.len()).rev() {
                if self.defined(machine, &head, Some(values)).is_some() {
                    break;
                }
                let first = vec![group[..count].to_vec()];
                if let Some(result) = self.defined(machine, &head, Some(&first)) {
                    return result;
                }
            }
            // The polar form of a certain polynomial has as many arguments as its degree.
            if let Some(degree) = self.degree_of_example(machine, &head, expr)
                && degree < group.len()
            {
                return self.apply(machine, callee, &[group[..degree].to_vec()], expr);
            }
        }
        self.apply(machine, callee, values, expr)
    }

    fn apply_head(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Evaluated {
        let Some(head) = Head::of(callee) else {
            return Err(unclear("what is applied here", expr));
        };
        let head = self.context.with_pairs_apart(head);
        if let [group] = values
            && group.iter().any(|value| matches!(value, Value::Vector(_)))
            && let Some(result) = self.affine_by_definition(machine, &head, group)
        {
            return result;
        }
        if let Some(result) = self.defined(machine, &head, Some(values)) {
            return result;
        }
        if let Some(result) = self.applied_formula(machine, &head, values) {
            return result;
        }
        if let Some(result) = self.spoken(machine, &head, values, expr) {
            return result;
        }
        if let Some(result) = self.varied(machine, &head, values, expr) {
            return result;
        }
        if let Some(result) = self.family(machine, &head, values, expr) {
            return result;
        }
        self.function(machine, &head, values, expr)
    }

    /// P(1, 0, 0) of P = Σ p_{ijk} B_{ijk}^n, a formula in as many variables, in the order of the alphabet.
    fn applied_formula(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: &[Vec<Value>],
    ) -> Option<Evaluated> {
        let plain = Head { arguments: None, ..head.clone() };
        let defined =
            self.context.visible(&head.base, &self.place).next().is_some_and(|(_, definition, _)| {
                definition.head.arguments.is_none()
                    && definition.head.lower.len() == head.lower.len()
                    && definition.head.upper.len() == head.upper.len()
            });
        let at: Option<Vec<Fraction>> =
            values.iter().flatten().map(|value| value.as_scalar().cloned()).collect();
        let at = at.filter(|_| defined)?;
        let value = self.defined(machine, &plain, None)?.ok()?;
        let mut variables: Vec<Symbol> = crate::judge::values::equality::symbols(&value)
            .into_iter()
            .filter(|symbol| symbol.is_plain() && crate::judge::page::context::is_variable(symbol.base()))
            .collect();
        variables.sort();
        if variables.len() != at.len() {
            return None;
        }
        let put: Vec<(Symbol, Fraction)> = variables.into_iter().zip(at).collect();
        Some(each(value, &|formula| formula.substitute(&put).map_err(|_| division_by_zero())))
    }

    /// x_u, a partial derivative of a function of u and v, without its arguments.
    pub(super) fn partial_derivative(
        &self,
        machine: &mut Machine,
        head: &Head,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let arguments = self.context.variables_of_partial(head, &self.place)?;
        let values = vec![arguments.iter().map(|name| Value::symbol(Symbol::new(name))).collect()];
        self.varied(machine, head, &values, expr)
    }

    /// Calls whose indices say what to do with the function: F^{(q)}, f^{(+1)}, f^r, x_u.
    fn varied(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Option<Evaluated> {
        if let [upper] = head.upper.as_slice() {
            let bare = Expr { kind: bare(head, true), span: expr.span };
            if families::is_family(&head.base) {
                return None;
            }
            // f^+ is another function.
            if matches!(&upper.kind, Kind::Name(sign) if matches!(sign.as_str(), "plus" | "minus")) {
                return Some(Err(unclear("what the sign above this name says", expr)));
            }
            if head.parenthesized {
                if matches!(&upper.kind, Kind::Add(terms) if terms.len() == 1 && terms[0].sign == Sign::Plus)
                {
                    self.note("f^{(+1)} is the polar form of the degree raised by one");
                    return Some(self.apply(machine, &bare, values, expr));
                }
                let order = machine.eval(upper).ok()?.as_int()?;
                let order = usize::try_from(order).ok()?;
                return Some(self.derivative(machine, &bare, order, values, expr));
            }
            if head.lower.is_empty() && self.context.letters.is_function(&head.base) {
                let order = machine.eval(upper).ok()?;
                if !matches!(upper.kind, Kind::Number(_)) {
                    self.ambiguous(Ambiguity::Power);
                    if !self.choices.powers {
                        let order = usize::try_from(order.as_int()?).ok()?;
                        return Some(self.derivative(machine, &bare, order, values, expr));
                    }
                }
                let value = match self.apply(machine, &bare, values, expr) {
                    Ok(value) => value,
                    Err(error) => return Some(Err(error)),
                };
                return Some(arithmetic::power(value, &order).map_err(|error| error.at(expr.span)));
            }
        }
        // x_u(u, v), x_{uv}: partial derivatives of a function that has these variables
        let [index] = head.lower.as_slice() else { return None };
        let letters: Vec<&str> = match &index.kind {
            Kind::Name(name) => vec![name.as_str()],
            Kind::Mul(factors) => factors
                .iter()
                .map(|factor| match &factor.kind {
                    Kind::Name(name) => Some(name.as_str()),
                    _ => None,
                })
                .collect::<Option<_>>()?,
            _ => return None,
        };
        let plain = Head { lower: Vec::new(), ..head.clone() };
        let context = self.context.clone();
        let (_, definition, _) = context.visible(&head.base, &self.place).find(|(_, definition, _)| {
            let own: Vec<String> =
                definition.head.flat().iter().filter_map(|e| Head::of(e)).map(|h| h.base).collect();
            definition.head.lower.is_empty() && letters.iter().all(|letter| own.iter().any(|o| o == letter))
        })?;
        let own: Vec<Symbol> = definition
            .head
            .flat()
            .iter()
            .filter_map(|e| Head::of(e))
            .map(|head| Symbol::new(head.base))
            .collect();
        let symbols: Vec<Vec<Value>> = vec![own.iter().cloned().map(Value::symbol).collect()];
        let flat: Vec<&Value> = values.iter().flatten().collect();
        if flat.len() != own.len() {
            return None;
        }
        let replacements: Option<Vec<(Symbol, Fraction)>> = own
            .iter()
            .zip(&flat)
            .map(|(symbol, value)| Some((symbol.clone(), value.as_scalar()?.clone())))
            .collect();
        let replacements = replacements?;
        let value = self.defined(machine, &plain, Some(&symbols))?;
        Some(value.and_then(|value| {
            each(value, &|formula| {
                let derived = letters
                    .iter()
                    .fold(formula, |formula, letter| nth_derivative(&formula, &Symbol::new(*letter), 1));
                derived.substitute(&replacements).map_err(|_| division_by_zero())
            })
        }))
    }

    /// F ∘ G without arguments: a formula in the variable of G.
    pub(super) fn composed(&self, machine: &mut Machine, items: &[Expr], expr: &Expr) -> Option<Evaluated> {
        if !items.iter().all(|item| self.is_function(machine, item)) {
            return None;
        }
        let variable = Head::of(items.last()?).and_then(|head| {
            let context = self.context.clone();
            context
                .visible(&head.base, &self.place)
                .find_map(|(_, d, _)| d.head.flat().first().and_then(|first| Head::of(first)))
                .map(|head| head.base)
        })?;
        let own = vec![vec![Value::symbol(Symbol::new(variable))]];
        let whole = Expr::new(Kind::Compose(items.to_vec()), expr.span);
        Some(self.apply(machine, &whole, &own, expr))
    }
}

/// The name without its upper index (or all indices kept below).
fn bare(head: &Head, keep_lower: bool) -> Kind {
    let base = match head.base.split_once(' ') {
        Some((accent, base)) => {
            let accent = Accent::ALL.into_iter().find(|a| a.name() == accent).unwrap_or(Accent::Bar);
            Expr::from(Kind::Accent(accent, Box::new(Expr::name(base))))
        }
        None => Expr::name(&head.base),
    };
    if keep_lower && !head.lower.is_empty() {
        Kind::Subscript(Box::new(base), head.lower.clone())
    } else {
        base.kind
    }
}

/// Applies an operation to a formula, or to each coordinate of a point.
pub(super) fn each(value: Value, operation: &dyn Fn(Fraction) -> Result<Fraction, Diagnostic>) -> Evaluated {
    match value {
        Value::Scalar(formula) => operation(formula).map(Value::Scalar),
        Value::List(items) => {
            items.into_iter().map(|item| each(item, operation)).collect::<Result<_, _>>().map(Value::List)
        }
        Value::Matrix(matrix) => {
            let (rows, columns) = matrix.shape();
            let entries: Result<Vec<Fraction>, Diagnostic> =
                matrix.transpose().iter().cloned().map(operation).collect();
            Ok(Value::Matrix(nalgebra::DMatrix::from_row_iterator(rows, columns, entries?)))
        }
        other => Err(Diagnostic::error(Code::Type, format!("{} is no formula", other.kind()))),
    }
}

pub(super) fn unclear(what: &str, expr: &Expr) -> Diagnostic {
    Diagnostic::error(Code::Undecided, format!("it is not clear {what}")).at(expr.span)
}

/// A symbol as a formula.
pub(super) fn variable(symbol: Symbol) -> Fraction {
    Fraction::from(MultiPoly::symbol(symbol))
}
