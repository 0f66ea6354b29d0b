//! Sums and products over indices, maxima and minima.

use super::machine::{Evaluated, Machine};
use super::names::name_of;
use crate::formula::source::Span;
use crate::formula::{BigOp, Expr, Kind, Link, Rel, Sign};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::arithmetic;
use crate::language::ops::errors::{unsupported, wrong_kind};
use crate::language::value::Value;
use crate::math::number::Combinations;
use crate::math::poly::Symbol;

impl Machine {
    pub(crate) fn eval_big(
        &mut self,
        op: BigOp,
        lower: &[Expr],
        upper: Option<&Expr>,
        body: &Expr,
        span: Span,
    ) -> Evaluated {
        if let (BigOp::Sum, Some(sum)) = (op, self.closed_sum(lower, upper, body, span)?) {
            return Ok(sum);
        }
        if let (BigOp::Max | BigOp::Min, None) = (op, upper)
            && let Some(extreme) = self.extreme_over_reals(op == BigOp::Max, lower, body, span)
        {
            return extreme;
        }
        let combine: fn(Value, Value) -> Evaluated = match op {
            BigOp::Sum => arithmetic::add,
            BigOp::Product => arithmetic::multiply,
            BigOp::Max => |a, b| pick(a, b, true),
            BigOp::Min => |a, b| pick(a, b, false),
            BigOp::Limit => return self.eval_limit(lower, body, span),
            BigOp::Union | BigOp::Intersection => {
                return Err(unsupported("unions and intersections have no value here").at(span));
            }
        };
        // One index with two ends, the usual case, needs no list of all its values.
        let assignments: Box<dyn Iterator<Item = Vec<(Symbol, Value)>>> = match self
            .one_range(lower, upper)?
        {
            Some((name, from, to)) => Box::new((from..=to).map(move |i| vec![(name.clone(), Value::int(i))])),
            None => Box::new(self.index_values(lower, upper, span)?.into_iter()),
        };
        // The values so far, joined to parts of 2^k neighbours if they are scalars: a long sum of polynomials is not
        // copied once for each of its terms.
        let mut parts: Vec<(u32, Value)> = Vec::new();
        for names in assignments {
            crate::budget::steps(8);
            let (mut level, mut value) = (0, self.with_locals(names, |machine| machine.eval(body))?);
            let scalar = |value: &Value| op == BigOp::Sum && matches!(value, Value::Scalar(_));
            while let Some((_, last)) =
                parts.pop_if(|(k, last)| *k == level || !scalar(last) || !scalar(&value))
            {
                value = combine(last, value).at(body.span)?;
                level += 1;
            }
            parts.push((level, value));
        }
        let mut total: Option<Value> = None;
        while let Some((_, part)) = parts.pop() {
            total = Some(match total {
                None => part,
                Some(total) => combine(part, total).at(body.span)?,
            });
        }
        match (total, op) {
            (Some(total), _) => Ok(total),
            (None, BigOp::Sum) => Ok(Value::int(0)),
            (None, BigOp::Product) => Ok(Value::int(1)),
            (None, _) => Err(Diagnostic::error(Code::Domain, "nothing to choose from").at(span)),
        }
    }

    /// The index of Σ or Π with its first and its last value, if `i = a` with an upper bound or `i = a..b` is all there is.
    fn one_range(
        &mut self,
        lower: &[Expr],
        upper: Option<&Expr>,
    ) -> Result<Option<(Symbol, i64, i64)>, Diagnostic> {
        let [piece] = lower else { return Ok(None) };
        let Kind::Chain(left, links) = &piece.kind else { return Ok(None) };
        match links.as_slice() {
            [link] if link.rel == Rel::Eq => self.range_of(left, link, upper),
            _ => Ok(None),
        }
    }

    /// The index of `left = …` with its first and its last value; `None` if `left` is no name, or an end is missing.
    fn range_of(
        &mut self,
        left: &Expr,
        link: &Link,
        upper: Option<&Expr>,
    ) -> Result<Option<(Symbol, i64, i64)>, Diagnostic> {
        if name_of(left, self).is_none() || mentions_enclosed(left) {
            return Ok(None);
        }
        let name = self.binder(left)?;
        let (from, to) = match (&link.expr.kind, upper) {
            (Kind::Range(from, to), _) => (self.eval_int(from)?, self.eval_int(to)?),
            (_, Some(upper)) => (self.eval_int(&link.expr)?, self.eval_int(upper)?),
            (_, None) => return Ok(None),
        };
        crate::budget::charge_terms(to.saturating_sub(from).saturating_add(1).max(0) as u64);
        Ok(Some((name, from, to)))
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
        // In i, j = 0 both names have the bounds.
        let mut together: Vec<Symbol> = Vec::new();
        for (at, piece) in lower.iter().enumerate() {
            if let Kind::Name(_) = &piece.kind
                && lower[at..].iter().any(|later| matches!(later.kind, Kind::Chain(..)))
            {
                together.push(self.binder(piece)?);
                continue;
            }
            let Kind::Chain(left, links) = &piece.kind else { return Err(no_bounds().at(piece.span)) };
            let link = &links[0];
            // i ≥ a and, elsewhere, i ≤ b
            if let Some((name, from, to)) = self.ends_of(piece, lower, upper) {
                if assignments.iter().all(|names| names.iter().all(|(known, _)| *known != name)) {
                    let count = to.saturating_sub(from).saturating_add(1).max(0) as u64;
                    crate::budget::charge_terms(count.saturating_mul(assignments.len() as u64));
                    let values: Vec<Value> = (from..=to).map(Value::int).collect();
                    assignments = extended(assignments, &name, &values);
                    bound_any = true;
                }
                continue;
            }
            match (link.rel, links.len()) {
                // i = a, with the upper bound above the sign, or i = a..b
                (Rel::Eq, 1) if name_of(left, self).is_some() && !mentions_enclosed(left) => {
                    let (name, from, to) =
                        self.range_of(left, link, upper)?.ok_or_else(|| no_bounds().at(piece.span))?;
                    let values: Vec<Value> = (from..=to).map(Value::int).collect();
                    for name in together.drain(..).chain([name]) {
                        crate::budget::charge_terms(
                            (values.len() as u64).saturating_mul(assignments.len() as u64),
                        );
                        assignments = extended(assignments, &name, &values);
                    }
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
                    let mut pairs = Vec::new();
                    for k in sizes {
                        for chosen in Combinations::new(items.len(), k) {
                            crate::budget::charge_terms(pairs.len() as u64 + 1);
                            let others = (0..items.len()).filter(|i| !chosen.contains(i));
                            let pick = |at: &usize| items[*at].clone();
                            let others = others.map(|i| items[i].clone()).collect();
                            pairs.push([Value::List(chosen.iter().map(pick).collect()), Value::List(others)]);
                        }
                    }
                    let rest = outside(&name);
                    assignments = assignments
                        .iter()
                        .flat_map(|base| {
                            pairs.iter().map(|[own, others]| {
                                let own = [(name.clone(), own.clone()), (rest.clone(), others.clone())];
                                base.iter().cloned().chain(own).collect()
                            })
                        })
                        .collect();
                    bound_any = true;
                }
                // j ∉ S, within the set of which S is a part
                (Rel::NotIn, 1) => {
                    let name = self.binder(left)?;
                    let rest = name_of(&link.expr, self).and_then(|set| self.lookup(&outside(&set)).cloned());
                    let Some(Value::List(items)) = rest else {
                        return Err(no_bounds()
                            .at(piece.span)
                            .hint("what this set is a part of is not said"));
                    };
                    assignments = extended(assignments, &name, &items);
                    bound_any = true;
                }
                (Rel::In, 1) => {
                    let name = self.binder(left)?;
                    // n ∈ [1, 5] is an interval in print, a list of two numbers here.
                    if let (Kind::List(ends), false) = (&link.expr.kind, self.has_reading())
                        && ends.len() == 2
                    {
                        let problem =
                            Diagnostic::error(Code::AmbiguousProduct, "an interval, or two numbers?");
                        return Err(problem
                            .at(link.expr.span)
                            .hint(format!(
                                "of all integers between write {} = 1..5",
                                crate::language::write::text(left)
                            ))
                            .hint("of these two write braces: {1, 5}"));
                    }
                    let items = self.set_items(&link.expr)?;
                    assignments = extended(assignments, &name, &items);
                    bound_any = true;
                }
                // a ≤ i ≤ b, a ≤ i < j ≤ b: each index has its place between the ends
                (Rel::Le | Rel::Lt, 2..) if links.iter().all(|l| matches!(l.rel, Rel::Le | Rel::Lt)) => {
                    let strict = |links: &[Link]| links.iter().filter(|l| l.rel == Rel::Lt).count() as i64;
                    let last = links.len() - 1;
                    let (from, to) = (self.eval_int(left)?, self.eval_int(&links[last].expr)?);
                    for (k, link) in links[..last].iter().enumerate() {
                        let name = self.binder(&link.expr)?;
                        let (from, to) = (from + strict(&links[..=k]), to - strict(&links[k + 1..]));
                        let count = to.saturating_sub(from).saturating_add(1).max(0) as u64;
                        crate::budget::charge_terms(count.saturating_mul(assignments.len() as u64));
                        let values: Vec<Value> = (from..=to).map(Value::int).collect();
                        assignments = extended(assignments, &name, &values);
                    }
                    if last > 1 {
                        filters.push(piece);
                    }
                    bound_any = true;
                }
                (Rel::Eq, 1) if matches!(left.kind, Kind::Enclosed(..)) => {} // |S| = i, used above
                _ => filters.push(piece),
            }
        }
        if !bound_any || !together.is_empty() {
            return Err(no_bounds());
        }
        for filter in filters {
            let mut kept = Vec::with_capacity(assignments.len());
            for names in assignments {
                let value = self.with_locals(names.clone(), |machine| machine.eval(filter))?;
                let Value::Claim(claim) = &value else {
                    return Err(wrong_kind("a condition", &value).at(filter.span));
                };
                match claim.decided() {
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

    /// The name that an inequality bounds, and its least and largest values by all of the conditions; `None` if
    /// they leave an end open or bind the name otherwise.
    fn ends_of(&mut self, piece: &Expr, lower: &[Expr], upper: Option<&Expr>) -> Option<(Symbol, i64, i64)> {
        let (name, ..) = self.end(piece)?;
        let (mut from, mut to) = (None, None);
        for other in lower {
            match (self.end(other), &other.kind) {
                (Some((known, true, value)), _) if known == name => {
                    from = Some(from.map_or(value, |old: i64| old.max(value)));
                }
                (Some((known, false, value)), _) if known == name => {
                    to = Some(to.map_or(value, |old: i64| old.min(value)));
                }
                (None, Kind::Chain(left, links)) if links[0].rel == Rel::Eq || links.len() > 1 => {
                    let mut sides = std::iter::once(left.as_ref()).chain(links.iter().map(|link| &link.expr));
                    if sides.any(|side| name_of(side, self).as_ref() == Some(&name)) {
                        return None;
                    }
                }
                _ => {}
            }
        }
        let to = to.or_else(|| upper.and_then(|upper| self.eval_int(upper).ok()));
        Some((name, from?, to?))
    }

    /// The end that `i > a` or `a > i` gives a free name i: whether it is the lower one, and the first integer
    /// that is allowed.
    fn end(&mut self, piece: &Expr) -> Option<(Symbol, bool, i64)> {
        let Kind::Chain(left, links) = &piece.kind else { return None };
        let [link] = links.as_slice() else { return None };
        let (larger, strict) = match link.rel {
            Rel::Gt => (true, 1),
            Rel::Ge => (true, 0),
            Rel::Lt => (false, 1),
            Rel::Le => (false, 0),
            _ => return None,
        };
        let sides = [(left.as_ref(), &link.expr, larger), (&link.expr, left.as_ref(), !larger)];
        sides.into_iter().find_map(|(name, value, lower)| {
            let name = name_of(name, self).filter(|name| self.lookup(name).is_none())?;
            let value = self.eval_int(value).ok()?;
            Some((
                name,
                lower,
                if lower { value.saturating_add(strict) } else { value.saturating_sub(strict) },
            ))
        })
    }

    /// The names of `i + j + k`.
    fn addends(&mut self, sum: &Expr) -> Result<Vec<Symbol>, Diagnostic> {
        let Kind::Add(terms) = &sum.kind else { return Ok(Vec::new()) };
        let mut names = Vec::with_capacity(terms.len());
        for term in terms {
            if term.sign == Sign::Minus {
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
                Value::List(items) => Ok(items.into_iter().collect()),
                other => Err(wrong_kind("a set such as {1, ..., n}", &other).at(set.span)),
            },
        }
    }
}

impl Machine {
    /// How many elements a set has that runs through the parts of another one.
    pub(super) fn size_of_part(&mut self, expr: &Expr) -> Option<usize> {
        let name = name_of(expr, self)?;
        self.lookup(&outside(&name))?;
        match self.lookup(&name)? {
            Value::List(items) => Some(items.len()),
            _ => None,
        }
    }
}

/// The name of what is not in a set that runs through the parts of another one.
fn outside(set: &Symbol) -> Symbol {
    set.clone().with_accent("outside")
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
