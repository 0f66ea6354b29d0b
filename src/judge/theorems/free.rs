//! Formulas in free letters: what a member of a family or a value of a function is does not matter, only which.
//!
//! **Rule.** Equal letters with equal indices, orders of derivatives and arguments are equal; nothing else is known of
//! them, but that a polar form is symmetric, and that ‖−v‖ is ‖v‖ and det alternates. Sums, products, dots,
//! binomials, matrices and fractions are calculated as everywhere.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use crate::formula::{Accent, Enclosure, Expr, Kind};
use crate::judge::instances::integers::as_values;
use crate::judge::model::Model;
use crate::judge::values::evaluator::evaluate_reading;
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Machine, Reading};
use crate::language::value::Value;
use crate::math::number::{Rational, binomial, exact_root, integer};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use num_traits::{One, Signed, Zero};

type Evaluated = Result<Value, Diagnostic>;

/// What a letter with indices, a derivative and arguments is.
#[derive(Clone, Debug)]
pub(super) struct Atom {
    /// The letter.
    pub(super) base: String,
    /// Its indices, those above last.
    pub(super) indices: Vec<String>,
    /// How often it is differentiated.
    pub(super) order: i64,
    /// Its arguments; vectors are marked.
    pub(super) arguments: Option<Vec<(Fraction, bool)>>,
}

/// What atoms are worth.
pub(super) type World = dyn Fn(&Atom) -> Option<Rational>;

/// Functions by their letters; polar forms with the number of their arguments.
pub(super) type Functions = BTreeMap<String, Option<usize>>;

/// A reading in free letters.
pub(super) struct Free {
    pub(super) model: Model,
    pub(super) functions: Rc<Functions>,
    /// Letters with an index above: b_i^2 is no power.
    pub(super) raised: Rc<BTreeSet<String>>,
    pub(super) world: Option<Rc<World>>,
}

impl Free {
    /// The value of a formula.
    pub(super) fn value(self: &Rc<Self>, expr: &Expr, integers: &[(String, i64)]) -> Option<Fraction> {
        let value = evaluate_reading(expr, self.clone(), as_values(integers)).ok()?;
        match crate::judge::values::compare::plain(&value) {
            Value::Scalar(value) => Some(value),
            _ => None,
        }
    }

    fn atom(&self, atom: Atom) -> Evaluated {
        if let Some(world) = &self.world {
            let value = world(&atom);
            return value.map(|value| Value::Scalar(value.into())).ok_or_else(|| open("what this is", None));
        }
        if atom.arguments.is_none() && atom.order == 0 && atom.indices.is_empty() {
            return Ok(Value::symbol(Symbol::new(atom.base)));
        }
        let polar = self.functions.get(&atom.base).copied().flatten().is_some();
        let mut name = atom.base;
        name.extend(std::iter::repeat_n('\'', usize::try_from(atom.order).unwrap_or(0)));
        if !atom.indices.is_empty() {
            name += &format!("[{}]", atom.indices.join(","));
        }
        if let Some(arguments) = atom.arguments {
            let mut texts: Vec<String> = arguments
                .iter()
                .map(|(value, vector)| format!("{}{value}", if *vector { "^" } else { "" }))
                .collect();
            if polar {
                texts.sort();
            }
            name += &format!("({})", texts.join(";"));
        }
        Ok(Value::symbol(Symbol::new(name)))
    }

    fn indices(&self, machine: &mut Machine, head: &Head) -> Result<Vec<String>, Diagnostic> {
        let text = |index: &Expr, machine: &mut Machine| match &index.kind {
            Kind::Text(text) => Ok(text.trim().to_owned()),
            // w_1^*
            Kind::Name(name) if machine.lookup(&Symbol::new(name)).is_none() => Ok(name.clone()),
            _ => match machine.eval(index)? {
                Value::Scalar(value) => Ok(value.to_string()),
                _ => Err(open("what this index is", Some(index))),
            },
        };
        head.lower.iter().chain(&head.upper).map(|index| text(index, machine)).collect()
    }

    /// A name with its indices.
    fn name(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        let head = Head::of(expr)?;
        if head.arguments.is_some() {
            return None;
        }
        if head.lower.is_empty()
            && head.upper.is_empty()
            && machine.lookup(&Symbol::new(&head.base)).is_some()
        {
            return None;
        }
        Some(
            self.indices(machine, &head)
                .and_then(|indices| self.atom(Atom { base: head.base, indices, order: 0, arguments: None })),
        )
    }

    /// A function without its derivatives, and their order.
    fn derived(&self, machine: &mut Machine, callee: &Expr) -> Option<(Expr, i64)> {
        match &callee.kind {
            Kind::Prime(body, order) => Some((body.as_ref().clone(), i64::from(*order))),
            Kind::Accent(Accent::Dot, body) => Some((body.as_ref().clone(), 1)),
            Kind::Accent(Accent::Ddot, body) => Some((body.as_ref().clone(), 2)),
            Kind::Derivative { variables, body: Some(body), .. } => {
                let [(_, order)] = variables.as_slice() else { return None };
                let order = order.as_ref().map_or(Ok(1), |order| machine.eval_int(order)).ok()?;
                Some((body.as_ref().clone(), order))
            }
            Kind::Subscript(base, lower) => {
                let (base, order) = self.derived(machine, base)?;
                (order > 0)
                    .then(|| (Expr::new(Kind::Subscript(Box::new(base), lower.clone()), callee.span), order))
            }
            Kind::Upper(base, upper) if Head::of(base).is_some_and(|head| head.lower.is_empty()) => {
                let [order] = upper.as_slice() else { return None };
                Some((base.as_ref().clone(), machine.eval_int(order).ok()?))
            }
            _ => None,
        }
    }

    fn call(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        groups: &[Vec<Expr>],
        order: i64,
        expr: &Expr,
    ) -> Option<Evaluated> {
        if let Kind::Name(word) = &callee.kind {
            match (word.as_str(), groups) {
                ("det", [vectors]) => return Some(self.alternating(machine, "det", vectors)),
                ("area", [corners]) => return Some(Self::area(machine, corners)),
                ("sqrt", [group]) if group.len() == 1 => {
                    return Some(machine.eval(&group[0]).and_then(|value| self.root(&value, 2)));
                }
                ("root", [group]) if group.len() == 2 => {
                    let order = machine.eval_int(&group[1]);
                    return Some(order.and_then(|order| self.root(&machine.eval(&group[0])?, order)));
                }
                _ => {}
            }
        }
        let (function, own) = self.derived(machine, callee).unwrap_or_else(|| (callee.clone(), 0));
        let head = Head::of(&function).filter(|head| head.arguments.is_none())?;
        if own == 0 && order == 0 && !self.functions.contains_key(&head.base) {
            // n(a - b)
            let [group] = groups else { return None };
            let [factor] = group.as_slice() else { return None };
            let product = Kind::Mul(vec![callee.clone(), factor.clone().grouped()]);
            return Some(machine.eval(&Expr::new(product, expr.span)));
        }
        let arity = self.functions.get(&head.base).copied().flatten();
        let mut arguments = Vec::new();
        for group in groups {
            match self.model.arguments(machine, group, arity, expr) {
                Ok(values) => arguments.extend(values),
                Err(error) => return Some(Err(error)),
            }
        }
        let plain = |value: Value| match value {
            Value::Scalar(value) => Ok((value, false)),
            Value::Vector(value) => Ok((value, true)),
            _ => Err(open("what this argument is", Some(expr))),
        };
        let arguments: Result<Vec<_>, _> = arguments.into_iter().map(plain).collect();
        Some(arguments.and_then(|arguments| {
            let indices = self.indices(machine, &head)?;
            self.atom(Atom { base: head.base, indices, order: order + own, arguments: Some(arguments) })
        }))
    }

    /// The area of a triangle, whichever way round it is told.
    fn area(machine: &mut Machine, corners: &[Expr]) -> Evaluated {
        let mut names = Vec::new();
        for corner in corners {
            let Value::Scalar(value) = machine.eval(corner)? else {
                return Err(open("what this point is", Some(corner)));
            };
            names.push(value.to_string());
        }
        names.sort();
        Ok(Value::symbol(Symbol::new(format!("area({})", names.join(";")))))
    }

    /// The root of a product of squares is a product, any other one is a letter.
    fn root(&self, value: &Value, order: i64) -> Evaluated {
        let Value::Scalar(value) = value else { return Err(open("what this root is", None)) };
        if order == 1 {
            return Ok(Value::Scalar(value.clone()));
        }
        if let (Some(_), Some(number)) = (&self.world, value.as_rational()) {
            let root = u32::try_from(order).ok().and_then(|order| exact_root(&number, order));
            return root
                .map(|root| Value::Scalar(root.into()))
                .ok_or_else(|| open("what this root is", None));
        }
        let sign = if order == 2 { "sqrt".to_owned() } else { format!("root{order}") };
        Ok(Value::symbol(Symbol::new(format!("{sign}({value})"))))
    }

    /// A function that is linear in each of its arguments and alternates.
    fn alternating(&self, machine: &mut Machine, word: &str, items: &[Expr]) -> Evaluated {
        let mut all: Vec<(Rational, Vec<String>)> = vec![(Rational::one(), Vec::new())];
        for item in items {
            let value = machine.eval(item)?;
            let Value::Scalar(value) = value else { return Err(open("what this vector is", Some(item))) };
            let Some(sum) = value.as_polynomial() else {
                return Err(open("what this vector is", Some(item)));
            };
            let mut next = Vec::new();
            for (powers, factor) in sum.terms(MonomialOrder::Lex) {
                let name = MultiPoly::from_terms([(powers, Rational::one())]).to_string();
                for (known, names) in &all {
                    if !names.contains(&name) {
                        let mut names = names.clone();
                        names.push(name.clone());
                        next.push((known * &factor, names));
                    }
                }
            }
            crate::budget::charge_terms(next.len() as u64);
            all = next;
        }
        let mut sum = Fraction::zero();
        for (mut factor, mut names) in all {
            for end in (1..names.len()).rev() {
                for at in 0..end {
                    if names[at] > names[at + 1] {
                        names.swap(at, at + 1);
                        factor = -factor;
                    }
                }
            }
            let symbol = Symbol::new(format!("{word}({})", names.join(";")));
            sum += Fraction::from(MultiPoly::symbol(symbol)) * Fraction::from(factor);
        }
        Ok(Value::Scalar(sum))
    }

    /// Δ^k b_i, and divided differences.
    fn product(&self, machine: &mut Machine, factors: &[Expr], expr: &Expr) -> Option<Evaluated> {
        let is_delta = |factor: &Expr| matches!(&factor.kind, Kind::Name(name) if name == "Delta");
        for (at, pair) in factors.windows(2).enumerate() {
            let order = match &pair[0].kind {
                Kind::Pow(base, order) if is_delta(base) => Some(order.as_ref().clone()),
                _ if is_delta(&pair[0]) => Some(Expr::int(1)),
                _ => None,
            };
            if let (Some(order), Some(base), Some(head)) =
                (order, base_of_member(&pair[1]), Head::of(&pair[1]))
                && head.lower.len() == 1
            {
                let difference = self.difference(machine, &order, base, &head);
                return Some(difference.and_then(|value| self.rest(machine, factors, at, value, expr)));
            }
            let nodes = match (&pair[0].kind, &pair[1].kind) {
                (Kind::Name(name), Kind::List(items)) | (Kind::List(items), Kind::Name(name)) => {
                    Some((name, items))
                }
                _ => None,
            };
            if let Some((name, items)) = nodes {
                let values = self.model.arguments(machine, items, None, expr);
                let value = values.and_then(|values| {
                    let scalars = values.into_iter().filter_map(|value| match value {
                        Value::Scalar(value) => Some((value, false)),
                        _ => None,
                    });
                    let mut arguments: Vec<(Fraction, bool)> = scalars.collect();
                    arguments.sort_by_key(|(value, _)| value.to_string());
                    self.atom(Atom {
                        base: format!("[]{name}"),
                        indices: Vec::new(),
                        order: 0,
                        arguments: Some(arguments),
                    })
                });
                return Some(value.and_then(|value| self.rest(machine, factors, at, value, expr)));
            }
        }
        None
    }

    /// The product of what two neighbours are with the other factors.
    fn rest(
        &self,
        machine: &mut Machine,
        factors: &[Expr],
        at: usize,
        value: Value,
        expr: &Expr,
    ) -> Evaluated {
        let others: Vec<Expr> = factors[..at].iter().chain(&factors[at + 2..]).cloned().collect();
        if others.is_empty() {
            return Ok(value);
        }
        let others = machine.eval(&Expr::product(others))?;
        crate::language::ops::arithmetic::multiply(others, value).map_err(|error| error.at(expr.span))
    }

    fn difference(&self, machine: &mut Machine, order: &Expr, base: &Expr, head: &Head) -> Evaluated {
        let order = machine.eval_int(order)?;
        if !(0..=8).contains(&order) {
            return Err(open("what this difference is", None));
        }
        let index = machine.eval_int(&head.lower[0])?;
        let mut sum = Fraction::zero();
        for k in 0..=order {
            let name = Kind::Subscript(Box::new(base.clone()), vec![Expr::int(index + k)]);
            let Value::Scalar(value) = machine.eval(&Expr::from(name))? else {
                return Err(open("what this difference is", None));
            };
            let sign = integer(if (order - k) % 2 == 0 { 1 } else { -1 });
            let factor = Rational::from_integer(binomial(order as usize, k as usize));
            sum += value * Fraction::from(sign * factor);
        }
        Ok(Value::Scalar(sum))
    }
}

impl Reading for Free {
    fn eval(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        match &expr.kind {
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) => self.name(machine, expr),
            Kind::Accent(Accent::Hat, body) if matches!(body.kind, Kind::Number(_)) => {
                Some(machine.eval(body).map(|value| match value {
                    Value::Scalar(value) => Value::Vector(value),
                    other => other,
                }))
            }
            Kind::Accent(..) => {
                self.name(machine, expr).or_else(|| Some(Err(open("what this mark is", Some(expr)))))
            }
            Kind::Pow(..) if is_raised(expr, &self.raised) => self.name(machine, expr),
            Kind::Apply(callee, groups) => self.call(machine, callee, groups, 0, expr),
            Kind::Derivative { variables, body: Some(body), .. } => {
                let ([(_, order)], Kind::Apply(callee, groups)) = (variables.as_slice(), &body.kind) else {
                    return Some(Err(open("what this derivative is", Some(expr))));
                };
                let order = match order {
                    Some(order) => match machine.eval_int(order) {
                        Ok(order) => order,
                        Err(error) => return Some(Err(error)),
                    },
                    None => 1,
                };
                self.call(machine, callee, groups, order, expr)
            }
            Kind::Derivative { .. } | Kind::Prime(..) | Kind::At { .. } => {
                Some(Err(open("what this derivative is", Some(expr))))
            }
            Kind::Integral { lower, upper, body, variable } => {
                let Kind::Name(name) = &variable.kind else { return None };
                if let Some(world) = &self.world {
                    let ends = (lower.as_deref(), upper.as_deref());
                    return Some(integral(world, machine, ends, name, body));
                }
                let bound = [(Symbol::new(name), Value::symbol(Symbol::new("\u{2022}")))];
                let value = machine.with_locals(bound, |machine| machine.eval(body));
                let text = |end: &Option<Box<Expr>>, machine: &mut Machine| match end {
                    Some(end)
                        if !end.has(&|part| matches!(&part.kind, Kind::Name(name) if name == "infty")) =>
                    {
                        machine.eval(end).map(|value| plain_text(&value))
                    }
                    Some(end) => Ok(crate::language::write::text(end)),
                    None => Ok(String::new()),
                };
                Some(value.and_then(|value| {
                    let (from, to) = (text(lower, machine)?, text(upper, machine)?);
                    Ok(Value::symbol(Symbol::new(format!("int({from};{to};{})", plain_text(&value)))))
                }))
            }
            Kind::Enclosed(Enclosure::Norm | Enclosure::Abs, body) => {
                Some(machine.eval(body).and_then(|value| {
                    let Value::Scalar(value) = value else {
                        return Err(open("what this length is", Some(expr)));
                    };
                    if let (Some(_), Some(number)) = (&self.world, value.as_rational()) {
                        return Ok(Value::Scalar(number.abs().into()));
                    }
                    let (one, other) = (value.to_string(), (-value).to_string());
                    Ok(Value::symbol(Symbol::new(format!("|{}|", one.min(other)))))
                }))
            }
            Kind::Cross(items) if items.len() == 2 => Some(self.alternating(machine, "cross", items)),
            Kind::Mul(factors) => {
                self.product(machine, factors, expr).or_else(|| self.model.eval(machine, expr))
            }
            Kind::Add(_) | Kind::Binomial(..) | Kind::Matrix(..) | Kind::Big { .. } => {
                self.model.eval(machine, expr)
            }
            Kind::List(items) | Kind::Tuple(items) if items.len() == 1 => Some(machine.eval(&items[0])),
            _ => None,
        }
    }
}

/// The integral of a polynomial of degree 11 at most between the places that a world calls breaks, by Romberg's method.
fn integral(
    world: &Rc<World>,
    machine: &mut Machine,
    ends: (Option<&Expr>, Option<&Expr>),
    name: &str,
    body: &Expr,
) -> Evaluated {
    let place = |k: i64| {
        world(&Atom { base: "break".to_owned(), indices: vec![k.to_string()], order: 0, arguments: None })
    };
    let breaks: Vec<Rational> = (0..).map_while(place).collect();
    let mut end = |end: Option<&Expr>, last: bool| {
        let far = |part: &Expr| matches!(&part.kind, Kind::Name(name) if name == "infty");
        match end {
            Some(end) if !end.has(&far) && !matches!(end.kind, Kind::Accent(..)) => {
                machine.eval(end)?.as_rational().ok_or_else(|| open("where this ends", Some(end)))
            }
            _ => (if last { breaks.last() } else { breaks.first() })
                .cloned()
                .ok_or_else(|| open("where this ends", None)),
        }
    };
    let (from, to) = (end(ends.0, false)?, end(ends.1, true)?);
    let inner = breaks.iter().filter(|place| from < **place && **place < to);
    let places: Vec<Rational> = std::iter::once(&from).chain(inner).chain([&to]).cloned().collect();
    let mut sum = Rational::zero();
    for pair in places.windows(2) {
        let length = &pair[1] - &pair[0];
        let mut value = |part: Rational| {
            let at = &pair[0] + &length * part;
            let bound = [(Symbol::new(name), Value::Scalar(at.into()))];
            let value = machine.with_locals(bound, |machine| machine.eval(body))?;
            value.as_rational().ok_or_else(|| open("what this integral is", Some(body)))
        };
        let mut column = Vec::new();
        for level in 0..6u32 {
            let count = 1i64 << level;
            let mut trapezoids = (value(integer(0))? + value(integer(1))?) / integer(2);
            for k in 1..count {
                trapezoids += value(Rational::new(k.into(), count.into()))?;
            }
            column.push(trapezoids * &length / integer(count));
        }
        for step in 1..6u32 {
            let four = integer(4i64.pow(step));
            column =
                column.windows(2).map(|pair| (&pair[1] * &four - &pair[0]) / (&four - integer(1))).collect();
        }
        sum += &column[0];
    }
    Ok(Value::Scalar(sum.into()))
}

fn plain_text(value: &Value) -> String {
    match value {
        Value::Scalar(value) => value.to_string(),
        other => format!("{other:?}"),
    }
}

/// Whether an index, and no exponent, stands above a member of a family.
pub(super) fn is_raised(expr: &Expr, raised: &BTreeSet<String>) -> bool {
    let Kind::Pow(base, upper) = &expr.kind else { return false };
    base_of_member(base).is_some()
        && (bases(upper).iter().any(|name| is_index_letter(name))
            || Head::of(expr).is_some_and(|head| raised.contains(&head.base) || head.upper.is_empty()))
}

/// The letter of a member of a family.
fn base_of_member(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        Kind::Subscript(base, _) => Some(base),
        _ => None,
    }
}

fn open(what: &str, expr: Option<&Expr>) -> Diagnostic {
    let error = Diagnostic::error(Code::Undecided, format!("nothing says {what}"));
    match expr {
        Some(expr) => error.at(expr.span),
        None => error,
    }
}
