//! Dots: in sums, in products and among arguments.
//!
//! What dots stand for is found from the terms beside them and then checked on them: the last
//! term with its integer replaced (a_0 + a_1 t + … + a_n t^n), terms that differ by one in some
//! places (t_1 + … + t_n), all products in lexicographic order (t_1 t_2 + t_1 t_3 + … + t_4 t_5), or
//! cyclic shifts. If none fits, the dots have no meaning.

use super::calls::unclear;
use super::steps::{Steps, not_yet_named};
use super::{Ambiguity, Evaluated, Model};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::judge::features::is_repeated;
use crate::judge::names::{Head, bracket_beside_name, walk};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::number::Combinations;
use crate::math::poly::Symbol;

/// Values of an index tried for a term before the dots.
const TRIED: i64 = 12;

type Combine = fn(Value, Value) -> Evaluated;

impl Model {
    /// A sum; dots in it are written out.
    pub(super) fn sum(&self, machine: &mut Machine, terms: &[Term], expr: &Expr) -> Option<Evaluated> {
        // a_0 + … a_n, without a sign after the dots
        let apart: Vec<Term> = terms
            .iter()
            .flat_map(|term| match &term.expr.kind {
                Kind::Mul(factors) if factors.len() > 1 && factors[0].kind == Kind::Ellipsis => {
                    let rest = Expr::product(factors[1..].to_vec());
                    vec![
                        Term { expr: factors[0].clone(), ..term.clone() },
                        Term { expr: rest, ..term.clone() },
                    ]
                }
                _ => vec![term.clone()],
            })
            .collect();
        let terms = apart.as_slice();
        let dots = terms.iter().position(|term| term.expr.kind == Kind::Ellipsis)?;
        let signed = |term: &Term| match term.sign {
            Sign::Plus => term.expr.clone(),
            Sign::Minus => term.expr.clone().negated(),
        };
        let before: Vec<Expr> = terms[..dots].iter().map(signed).collect();
        let after: Vec<Expr> = terms[dots + 1..].iter().map(signed).collect();
        Some(self.dotted(machine, &before, &after, arithmetic::add, &Value::int(0), expr))
    }

    /// A product: dots in it are written out, f[x_0, x_1] is a divided difference.
    pub(super) fn product(&self, machine: &mut Machine, factors: &[Expr], expr: &Expr) -> Option<Evaluated> {
        if let Some(dots) = factors.iter().position(|factor| factor.kind == Kind::Ellipsis) {
            // n(n-1) is read as a call; here it is two factors. J_{n,k}(x) is one.
            let number = |callee: &Expr| matches!(&callee.kind, Kind::Name(name) if !self.context.letters.is_function(name));
            let split = |list: &[Expr]| -> Vec<Expr> {
                list.iter()
                    .flat_map(|factor| match &factor.kind {
                        Kind::Apply(callee, groups)
                            if groups.len() == 1 && groups[0].len() == 1 && number(callee) =>
                        {
                            vec![callee.as_ref().clone(), groups[0][0].clone()]
                        }
                        Kind::Group(inner) => vec![inner.as_ref().clone()],
                        _ => vec![factor.clone()],
                    })
                    .collect()
            };
            let before = split(&factors[..dots]);
            let after = split(&factors[dots + 1..]);
            return Some(self.dotted(machine, &before, &after, arithmetic::multiply, &Value::int(1), expr));
        }
        let (at, before) = factors
            .windows(2)
            .enumerate()
            .find_map(|(at, pair)| bracket_beside_name(&pair[0], &pair[1]).map(|before| (at, before)))?;
        let (function, bracket) = if before { (at + 1, at) } else { (at, at + 1) };
        let name = Head::of(&factors[function])?;
        if machine.lookup(&Symbol::new(&name.base)).is_some() {
            return None;
        }
        if !self.is_function(machine, &factors[function]) {
            return Some(Err(unclear(&format!("what the bracket beside {} is", name.base), expr)));
        }
        let nodes = match &factors[bracket].kind {
            Kind::List(nodes) => nodes.clone(),
            Kind::Group(node) => vec![node.as_ref().clone()],
            _ => return None,
        };
        // b[0^{n-i}, 1^i]: arguments that repeat, no nodes
        if nodes.iter().any(is_repeated) {
            return Some(Err(unclear(&format!("what the bracket beside {} is", name.base), expr)));
        }
        let difference = self.divided_difference(machine, &factors[function], &nodes, expr);
        let rest: Vec<Expr> = factors[..at].iter().chain(&factors[at + 2..]).cloned().collect();
        Some(difference.and_then(|value| {
            if rest.is_empty() {
                return Ok(value);
            }
            let rest = machine.eval(&Expr::product(rest))?;
            arithmetic::multiply(value, rest).map_err(|error| error.at(expr.span))
        }))
    }

    /// Combines the parts before, within and after the dots.
    fn dotted(
        &self,
        machine: &mut Machine,
        before: &[Expr],
        after: &[Expr],
        combine: Combine,
        neutral: &Value,
        expr: &Expr,
    ) -> Evaluated {
        let (Some(last), Some(nearest)) = (after.first(), before.last()) else {
            return Err(unclear("what the dots stand for", expr));
        };
        let rest = &after[1..];
        let template = self.by_template(machine, before, last, combine, neutral)?;
        // 1/(n+1) + … + 1/(2n): by steps of one, or of two?
        if let Some(total) = &template
            && let Some(parts) = self.by_steps(machine, before, nearest, last)?
        {
            let mut other = neutral.clone();
            for part in parts {
                let value = machine.eval(&part)?;
                other = combine(other, value)?;
            }
            if other != *total {
                return Err(unclear("what the dots stand for", expr));
            }
        }
        let mut total = match template {
            Some(total) => total,
            None => {
                let parts = match self.by_steps(machine, before, nearest, last)? {
                    // t_1 t_2 + … + t_4 t_5 may also be all products.
                    Some(parts) if before.len() == 1 => match self.by_order(machine, before, last)? {
                        Some(all) if all.len() != parts.len() => {
                            self.ambiguous(Ambiguity::Dots);
                            if self.choices.all_products { all } else { parts }
                        }
                        _ => parts,
                    },
                    Some(parts) => parts,
                    None => match self.by_order(machine, before, last)? {
                        Some(parts) => parts,
                        None => return Err(unclear("what the dots stand for", expr)),
                    },
                };
                let mut total = neutral.clone();
                for part in parts {
                    let value = machine.eval(&part)?;
                    total = combine(total, value)?;
                }
                total
            }
        };
        for part in rest {
            let value = machine.eval(part)?;
            total = combine(total, value)?;
        }
        Ok(total)
    }

    /// The last term with another value for one of its integers gives all terms.
    fn by_template(
        &self,
        machine: &mut Machine,
        before: &[Expr],
        last: &Expr,
        combine: Combine,
        neutral: &Value,
    ) -> Result<Option<Value>, Diagnostic> {
        let mut names: Vec<(String, i64)> = Vec::new();
        walk(last, &mut |part| {
            if let Kind::Name(name) = &part.kind
                && let Some(value) = machine.lookup(&Symbol::new(name)).and_then(Value::as_int)
                && !names.iter().any(|(known, _)| known == name)
            {
                names.push((name.clone(), value));
            }
        });
        let mut values = Vec::with_capacity(before.len());
        for part in before {
            let value = machine.eval(part)?;
            values.push(value);
        }
        for (name, end) in names {
            let symbol = Symbol::new(&name);
            let term = |machine: &mut Machine, j: i64| {
                machine.with_locals([(symbol.clone(), Value::int(j))], |machine| machine.eval(last)).ok()
            };
            // The terms before the dots must be those of consecutive indices.
            let fits = (-2..=TRIED).find(|&first| {
                values
                    .iter()
                    .enumerate()
                    .all(|(k, value)| term(machine, first + k as i64).is_some_and(|t| t == *value))
            });
            // n(n−1)⋯ may stand there as one factor.
            let Some(first) = fits else { continue };
            if values.len() < 2 && end > first && end - first > TRIED {
                continue;
            }
            let mut total = neutral.clone();
            crate::budget::charge_terms(end.saturating_sub(first).max(0) as u64);
            for j in first..=end {
                let Some(value) = term(machine, j) else { return Ok(None) };
                total = combine(total, value)?;
            }
            return Ok(Some(total));
        }
        Ok(None)
    }

    /// Terms that differ by one in some places, as t_1 + t_2 + … + t_5.
    fn by_steps(
        &self,
        machine: &mut Machine,
        before: &[Expr],
        nearest: &Expr,
        last: &Expr,
    ) -> Result<Option<Vec<Expr>>, Diagnostic> {
        let Some(steps) = Steps::between(machine, nearest, last) else { return Ok(None) };
        // The term before, if there is one, must lie on the same line.
        if before.len() > 1 {
            let previous = machine.eval(&before[before.len() - 2])?;
            if machine.eval(&steps.at(-1)).ok() != Some(previous) {
                return Ok(None);
            }
        }
        let mut parts: Vec<Expr> = before.to_vec();
        if steps.count < 0 {
            // a_1 + … + a_0 is empty, a_1 + a_2 + … + a_1 is a_1.
            let keep = (before.len() as i64 + steps.count).max(0) as usize;
            parts.truncate(keep);
            return Ok(Some(parts));
        }
        crate::budget::charge_terms(steps.count.max(0) as u64);
        for k in 1..=steps.count {
            parts.push(steps.at(k));
        }
        Ok(Some(parts))
    }

    /// All products in lexicographic order, or all cyclic shifts.
    fn by_order(
        &self,
        machine: &mut Machine,
        before: &[Expr],
        last: &Expr,
    ) -> Result<Option<Vec<Expr>>, Diagnostic> {
        let lists: Option<Vec<(Shape, Vec<i64>)>> =
            before.iter().chain([last]).map(|term| self.indices_of(machine, term)).collect();
        let Some(lists) = lists else { return Ok(None) };
        let (shape, first) = &lists[0];
        if lists.iter().any(|(other, list)| other != shape || list.len() != first.len()) {
            return Ok(None);
        }
        let given: Vec<&Vec<i64>> = lists[..before.len()].iter().map(|(_, list)| list).collect();
        let end = &lists[lists.len() - 1].1;
        let most = lists.iter().flat_map(|(_, list)| list).copied().max().unwrap_or(0);
        let least = lists.iter().flat_map(|(_, list)| list).copied().min().unwrap_or(0);
        let size = usize::try_from(most - least + 1).unwrap_or(0);
        if size > 60 {
            return Ok(None);
        }
        let all: Vec<Vec<i64>> = if first.windows(2).all(|pair| pair[0] < pair[1])
            && end.windows(2).all(|pair| pair[0] < pair[1])
            && shape.is_product()
        {
            Combinations::new(size, first.len())
                .map(|chosen| chosen.iter().map(|&i| least + i as i64).collect())
                .collect()
        } else {
            let shift = |list: &[i64], by: i64| -> Vec<i64> {
                list.iter().map(|i| least + (i - least + by).rem_euclid(size as i64)).collect()
            };
            (0..size as i64).map(|by| shift(first, by)).collect()
        };
        let fits = all.len() >= given.len()
            && all.iter().zip(&given).all(|(a, b)| a == *b)
            && all.last() == Some(end);
        Ok(fits.then(|| all.iter().map(|list| shape.with(list)).collect()))
    }

    /// The indices of a product of indexed names, or of the arguments of a call.
    fn indices_of(&self, machine: &mut Machine, term: &Expr) -> Option<(Shape, Vec<i64>)> {
        let (callee, items): (Option<Expr>, Vec<Expr>) = match &term.kind {
            Kind::Mul(factors) => (None, factors.clone()),
            Kind::Apply(callee, groups) if groups.len() == 1 => {
                (Some(callee.as_ref().clone()), written_out(machine, &groups[0])?)
            }
            Kind::Subscript(..) => (None, vec![term.clone()]),
            _ => return None,
        };
        let mut base: Option<Expr> = None;
        let mut list = Vec::with_capacity(items.len());
        for item in &items {
            let Kind::Subscript(own, lower) = &item.kind else { return None };
            let [index] = lower.as_slice() else { return None };
            match &base {
                Some(base) if !base.same_as(own) => return None,
                _ => base = Some(own.as_ref().clone()),
            }
            list.push(machine.eval_int(index).ok()?);
        }
        let callee = callee.map(|callee| callee.without_spans());
        Some((Shape { callee, base: base?.without_spans() }, list))
    }

    /// Arguments with dots and braces written out.
    pub(super) fn dotted_arguments(
        &self,
        machine: &mut Machine,
        items: &[Expr],
        arity: Option<usize>,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        // First the braces, which say how many.
        let mut pieces: Vec<Piece> = Vec::with_capacity(items.len());
        for item in items {
            match &item.kind {
                Kind::Brace(list, Some(label)) => {
                    let values = self.braced(machine, list, label, expr)?;
                    pieces.push(Piece::Values(values));
                }
                Kind::Brace(list, None) => pieces.extend(list.iter().cloned().map(Piece::Item)),
                _ => pieces.push(Piece::Item(item.clone())),
            }
        }
        // Then dots between the same item twice: as many as are missing.
        let mut flexible: Option<usize> = None;
        let mut values: Vec<Value> = Vec::new();
        let mut at = 0;
        while at < pieces.len() {
            let item = match &pieces[at] {
                Piece::Values(list) => {
                    values.extend(list.iter().cloned());
                    at += 1;
                    continue;
                }
                Piece::Item(item) => item.clone(),
            };
            let next = |k: usize| match pieces.get(at + k) {
                Some(Piece::Item(item)) => Some(item),
                _ => None,
            };
            let dots = next(1).is_some_and(|item| item.kind == Kind::Ellipsis);
            match (dots, next(2)) {
                // t_1, …, X, …, t_d: X stands at one place of the list
                (true, Some(middle))
                    if next(3).is_some_and(|item| item.kind == Kind::Ellipsis)
                        && next(4).is_some_and(|last| same_base(&item, last)) =>
                {
                    let last = next(4).cloned().unwrap_or_else(|| item.clone());
                    values.extend(self.with_one_replaced(machine, &item, middle, &last, expr)?);
                    at += 5;
                }
                (true, Some(after)) if after.same_as(&item) => {
                    if flexible.is_some() {
                        return Err(unclear("how many arguments the dots stand for", expr));
                    }
                    let value = self.argument(machine, &item)?;
                    values.push(value.clone());
                    flexible = Some(values.len());
                    values.push(value);
                    at += 3;
                }
                (true, Some(after)) => {
                    let list = run(machine, &item, after)
                        .and_then(|list| not_yet_named(list, items, after))
                        .ok_or_else(|| unclear("what the dots stand for", expr))?;
                    for entry in list {
                        values.push(machine.eval(&entry)?);
                    }
                    at += 3;
                }
                // f(u, …, u, 1̂, …) with nothing after the dots
                (true, None) => {
                    return Err(unclear("where the dots end", expr));
                }
                (false, _) => {
                    if item.kind == Kind::Ellipsis {
                        return Err(unclear("what the dots stand for", expr));
                    }
                    values.push(self.argument(machine, &item)?);
                    at += 1;
                }
            }
        }
        if let Some(place) = flexible {
            let arity = arity.unwrap_or_else(|| {
                self.record.borrow_mut().flexible = true;
                self.flexible.set(true);
                values.len()
            });
            // Both ends of t, …, t are one item if there is room for one only.
            let filler = values[place].clone();
            let others = values.len() - 2;
            let Some(count) = arity.checked_sub(others) else {
                return Err(Diagnostic::error(Code::Arity, "more arguments than the degree").at(expr.span));
            };
            values.splice(place - 1..=place, std::iter::repeat_n(filler, count));
        }
        Ok(values)
    }

    /// What stands over a brace with a count.
    fn braced(
        &self,
        machine: &mut Machine,
        list: &[Expr],
        label: &Expr,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        let count = machine.eval_int(label)?;
        let Ok(count) = usize::try_from(count) else {
            return Err(
                Diagnostic::error(Code::Domain, format!("{count} copies make no sense")).at(label.span)
            );
        };
        crate::budget::charge_terms(count as u64);
        let plain: Vec<&Expr> = list.iter().filter(|item| item.kind != Kind::Ellipsis).collect();
        let dots = list.iter().position(|item| item.kind == Kind::Ellipsis);
        match (plain.as_slice(), dots) {
            ([], _) => Err(unclear("what the brace holds", expr)),
            ([one], _) => Ok(vec![machine.eval(one)?; count]),
            (many, Some(_)) if many.windows(2).all(|pair| pair[0].same_as(pair[1])) => {
                Ok(vec![machine.eval(many[0])?; count])
            }
            (many, Some(dots)) if dots > 0 => {
                if let Some(after) = list.get(dots + 1)
                    && let Some(entries) = run(machine, &list[dots - 1], after)
                {
                    let mut values = Vec::new();
                    for item in &list[..dots - 1] {
                        values.push(machine.eval(item)?);
                    }
                    for entry in entries {
                        values.push(machine.eval(&entry)?);
                    }
                    for item in &list[dots + 2..] {
                        values.push(machine.eval(item)?);
                    }
                    if values.len() != count {
                        self.record.borrow_mut().mixed = true;
                    }
                    return Ok(values);
                }
                // u, …, u, 1̂ over n − q: the dots repeat what stands before them.
                let mut values = Vec::new();
                for item in many {
                    values.push(machine.eval(item)?);
                }
                let Some(missing) = count.checked_sub(values.len()) else {
                    // Fewer than are written: the repeated ones go first.
                    let surplus = values.len() - count;
                    if surplus <= dots + 1 {
                        values.drain(..surplus);
                        return Ok(values);
                    }
                    return Err(
                        Diagnostic::error(Code::Arity, "more items than the brace says").at(expr.span)
                    );
                };
                let filler = values[dots - 1].clone();
                values.splice(dots..dots, std::iter::repeat_n(filler, missing));
                Ok(values)
            }
            (many, _) => {
                let mut values = Vec::new();
                for item in many {
                    values.push(machine.eval(item)?);
                }
                if values.len() != count {
                    self.record.borrow_mut().mixed = true;
                }
                Ok(values)
            }
        }
    }

    /// t_1, …, X, …, t_d with X in the place of the t_i that it is made of.
    fn with_one_replaced(
        &self,
        machine: &mut Machine,
        first: &Expr,
        middle: &Expr,
        last: &Expr,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        let (Some(head), Some(end)) = (Head::of(first), Head::of(last)) else {
            return Err(unclear("what the dots stand for", expr));
        };
        let ([from], [to]) = (head.lower.as_slice(), end.lower.as_slice()) else {
            return Err(unclear("what the dots stand for", expr));
        };
        let (from_value, to_value) = (machine.eval_int(from)?, machine.eval_int(to)?);
        let mut own: Option<Expr> = None;
        walk(middle, &mut |part| {
            if own.is_none()
                && let Some(inner) = Head::of(part)
                && inner.base == head.base
                && let Some(index) = inner.lower.first()
            {
                own = Some(match &index.kind {
                    Kind::Mul(factors) => factors[0].clone(),
                    _ => index.clone(),
                });
            }
        });
        let place = match own {
            Some(index) => machine.eval_int(&index)?,
            None => from_value + 1,
        };
        if !(from_value..=to_value).contains(&place) {
            return Err(Diagnostic::error(Code::Domain, "there is no such argument").at(expr.span));
        }
        let mut values = Vec::new();
        for i in from_value..=to_value {
            if i == place {
                values.push(machine.eval(middle)?);
            } else {
                let Kind::Subscript(base, _) = &strip(first).kind else {
                    return Err(unclear("what the dots stand for", expr));
                };
                let entry = Expr::new(Kind::Subscript(base.clone(), vec![Expr::int(i)]), expr.span);
                values.push(machine.eval(&entry)?);
            }
        }
        Ok(values)
    }
}

/// Part of a list of arguments.
enum Piece {
    Item(Expr),
    Values(Vec<Value>),
}

/// A product of indexed names, or a call with such arguments.
#[derive(PartialEq)]
struct Shape {
    callee: Option<Expr>,
    base: Expr,
}

impl Shape {
    fn is_product(&self) -> bool {
        self.callee.is_none()
    }

    fn with(&self, list: &[i64]) -> Expr {
        let items = list
            .iter()
            .map(|&i| Expr::from(Kind::Subscript(Box::new(self.base.clone()), vec![Expr::int(i)])))
            .collect();
        match &self.callee {
            None => Expr::product(items),
            Some(callee) => Expr::apply(callee.clone(), items),
        }
    }
}

fn strip(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Accent(crate::formula::Accent::Bold, inner) => strip(inner),
        _ => expr,
    }
}

fn same_base(a: &Expr, b: &Expr) -> bool {
    match (Head::of(a), Head::of(b)) {
        (Some(a), Some(b)) => {
            a.base == b.base
                && a.lower.len() == 1
                && b.lower.len() == 1
                && a.upper.is_empty()
                && b.upper.is_empty()
        }
        _ => false,
    }
}

/// The entries from one item to another: t_1, …, t_n. None at all if the second comes just before
/// the first.
fn run(machine: &mut Machine, first: &Expr, last: &Expr) -> Option<Vec<Expr>> {
    if first.same_as(last) {
        return None;
    }
    let steps = Steps::between(machine, first, last)?;
    crate::budget::charge_terms(steps.count.max(0) as u64);
    Some((0..=steps.count).map(|k| steps.at(k)).collect())
}

/// A list of arguments of indexed names with its dots written out.
fn written_out(machine: &mut Machine, items: &[Expr]) -> Option<Vec<Expr>> {
    let Some(dots) = items.iter().position(|item| item.kind == Kind::Ellipsis) else {
        return Some(items.to_vec());
    };
    let (before, after) = (items.get(dots.checked_sub(1)?)?, items.get(dots + 1)?);
    let mut all = items[..dots - 1].to_vec();
    all.extend(run(machine, before, after)?);
    all.extend(items[dots + 2..].iter().cloned());
    Some(all)
}
