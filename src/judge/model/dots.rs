//! Dots in sums and in products; among arguments see `dotted_arguments`.
//!
//! What dots stand for is found from the terms beside them and then checked on them: the last
//! term with its integer replaced (a_0 + a_1 t + … + a_n t^n), terms that differ by one in some
//! places (t_1 + … + t_n), all products in lexicographic order (t_1 t_2 + t_1 t_3 + … + t_4 t_5), or
//! cyclic shifts. If none fits, the dots have no meaning.

use super::calls::unclear;
use super::steps::Steps;
use super::{Ambiguity, Evaluated, Model};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::judge::written::features::is_repeated;
use crate::judge::written::names::{Head, bracket_beside_name, walk};
use crate::language::diagnostic::Diagnostic;
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
        if let [operator, function @ Expr { kind: Kind::Apply(..), .. }] = factors
            && let Some(found) = self.directional_derivative(machine, operator, function, expr)
        {
            return Some(found);
        }
        let (at, before) = factors
            .windows(2)
            .enumerate()
            .find_map(|(at, pair)| bracket_beside_name(&pair[0], &pair[1]).map(|before| (at, before)))?;
        let (function, bracket) = if before { (at + 1, at) } else { (at, at + 1) };
        let name = Head::of(&factors[function]).map_or_else(|| "the factors".to_owned(), |head| head.base);
        if machine.lookup(&Symbol::new(&name)).is_some() {
            return None;
        }
        if !self.is_function(machine, &factors[function]) {
            return Some(Err(unclear(&format!("what the bracket beside {name} is"), expr)));
        }
        let nodes = match &factors[bracket].kind {
            Kind::List(nodes) => nodes.clone(),
            Kind::Group(node) => vec![node.as_ref().clone()],
            _ => return None,
        };
        // b[0^{n-i}, 1^i]: arguments that repeat, no nodes
        if nodes.iter().any(is_repeated) {
            return Some(Err(unclear(&format!("what the bracket beside {name} is"), expr)));
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

/// The entries from one item to another: t_1, …, t_n. None at all if the second comes just before
/// the first.
pub(super) fn run(machine: &mut Machine, first: &Expr, last: &Expr) -> Option<Vec<Expr>> {
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
