//! Sums and products over ranges, values by cases.

use std::collections::BTreeSet;

use super::linear::Linear;
use super::read::{Reader, rational_value};
use super::term::{Term, collected};
use crate::formula::{BigOp, Expr, Kind, Link, Rel};
use crate::math::poly::Symbol;

/// Disjoint sets of integers, each given by forms that are ≥ 0 in it.
type Region = Vec<BTreeSet<Linear>>;

/// Values by more cases are refused.
const MAX_CASES: usize = 60;

/// A variable of a sum with the forms that are ≥ 0 in its range.
type Range = (String, Symbol);

impl Reader<'_> {
    /// Σ over one of: i = a above which stands b; a ≤ i ≤ b; i + j + k = n with i, j, k ≥ 0.
    pub(super) fn sum(&mut self, lower: &[Expr], upper: Option<&Expr>, body: &Expr) -> Option<Vec<Term>> {
        let depth = self.scope.len();
        let (bound, guards) = self.range(lower, upper)?;
        self.natural_length(&bound, &guards);
        self.scope.truncate(depth);
        self.scope.extend(bound.iter().cloned());
        let known = self.ranges.len();
        self.ranges.extend(guards.iter().cloned());
        let terms = self.read(body);
        self.ranges.truncate(known);
        self.scope.truncate(depth);
        let mut terms = terms?;
        for term in &mut terms {
            term.guards.extend(guards.iter().cloned());
            term.bound.extend(bound.iter().map(|(_, symbol)| symbol.clone()));
        }
        Some(collected(terms))
    }

    /// A sum from a letter k to n is meant for k ≤ n, or for k = n + 1 where it is empty.
    fn natural_length(&mut self, bound: &[Range], guards: &[Linear]) {
        let [(_, variable)] = bound else { return };
        let [from, to] = guards else { return };
        let (from, to) =
            (from.substitute(variable, &Linear::default()), to.substitute(variable, &Linear::default()));
        let length = to.plus(&from).shifted(1);
        if !from.terms().is_empty() && !self.mentions_bound(&length) && !length.contains(variable) {
            self.lengths.push(length);
        }
    }

    fn bind(&mut self, name: &str) -> Range {
        let symbol = self.fresh();
        self.integers.insert(symbol.clone());
        (name.to_owned(), symbol)
    }

    /// The variables and what is ≥ 0 in the range.
    fn range(&mut self, lower: &[Expr], upper: Option<&Expr>) -> Option<(Vec<Range>, Vec<Linear>)> {
        let (mut bound, mut guards) = (Vec::new(), Vec::new());
        match upper {
            Some(upper) => {
                // i = 0, or i = 0, j = 0, or i, j = 0
                let above = self.limits(upper, BigOp::Min)?;
                let mut waiting: Vec<&str> = Vec::new();
                for item in lower {
                    match &item.kind {
                        Kind::Name(name) => waiting.push(name),
                        Kind::Chain(first, links) => {
                            let (Kind::Name(name), [Link { rel: Rel::Eq, expr: from, .. }]) =
                                (&first.kind, links.as_slice())
                            else {
                                return None;
                            };
                            let below = self.limits(from, BigOp::Max)?;
                            waiting.push(name);
                            for name in waiting.drain(..) {
                                let (name, symbol) = self.bind(name);
                                let i = Linear::symbol(&symbol);
                                guards.extend(below.iter().map(|a| i.minus(a)));
                                guards.extend(above.iter().map(|b| b.minus(&i)));
                                bound.push((name, symbol));
                            }
                        }
                        _ => return None,
                    }
                }
                if !waiting.is_empty() || bound.is_empty() {
                    return None;
                }
            }
            None => {
                let [Expr { kind: Kind::Chain(first, links), .. }] = lower else { return None };
                let members: Vec<&Expr> =
                    std::iter::once(&**first).chain(links.iter().map(|l| &l.expr)).collect();
                if let ([_], Rel::Eq) = (links.as_slice(), links.first()?.rel) {
                    self.simplex(first, &links[0].expr, &mut bound, &mut guards)?;
                } else {
                    self.inequalities(&members, links, &mut bound, &mut guards)?;
                }
            }
        }
        let mut names: Vec<&String> = bound.iter().map(|(name, _)| name).collect();
        names.sort_unstable();
        names.dedup();
        (names.len() == bound.len()).then_some((bound, guards))
    }

    /// i + j + k = n
    fn simplex(
        &mut self,
        left: &Expr,
        right: &Expr,
        bound: &mut Vec<Range>,
        guards: &mut Vec<Linear>,
    ) -> Option<()> {
        let total = self.linear(right)?;
        let Kind::Add(terms) = &left.kind else { return None };
        let mut rest = total;
        for term in terms {
            let Kind::Name(name) = &term.expr.kind else { return None };
            if term.sign == crate::formula::Sign::Minus {
                return None;
            }
            let (name, symbol) = self.bind(name);
            let i = Linear::symbol(&symbol);
            rest = rest.minus(&i);
            guards.push(i);
            bound.push((name, symbol));
        }
        guards.extend([rest.clone(), rest.negated()]);
        Some(())
    }

    /// a ≤ i ≤ b, a ≤ i < j ≤ b
    fn inequalities(
        &mut self,
        members: &[&Expr],
        links: &[Link],
        bound: &mut Vec<Range>,
        guards: &mut Vec<Linear>,
    ) -> Option<()> {
        if members.len() < 3 {
            return None;
        }
        let last = members.len() - 1;
        let ends = [self.linear(members[0])?, self.linear(members[last])?];
        let mut forms = vec![ends[0].clone()];
        for member in &members[1..last] {
            let Kind::Name(name) = &member.kind else { return None };
            let (name, symbol) = self.bind(name);
            forms.push(Linear::symbol(&symbol));
            bound.push((name, symbol));
        }
        forms.push(ends[1].clone());
        for (pair, link) in forms.windows(2).zip(links) {
            let step = match link.rel {
                Rel::Le => 0,
                Rel::Lt => -1,
                _ => return None,
            };
            guards.push(pair[1].minus(&pair[0]).shifted(step));
        }
        Some(())
    }

    /// A bound of a range; `max(0, k − n)` below and `min(m, k)` above are two.
    fn limits(&mut self, expr: &Expr, op: BigOp) -> Option<Vec<Linear>> {
        let word = if op == BigOp::Max { "max" } else { "min" };
        match &expr.kind {
            Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if name == word) => {
                let items: Vec<&Expr> = match groups.as_slice() {
                    [group] => match group.as_slice() {
                        [Expr { kind: Kind::Set(items, None), .. }] => items.iter().collect(),
                        items => items.iter().collect(),
                    },
                    _ => return None,
                };
                items.into_iter().map(|item| self.linear(item)).collect()
            }
            _ => Some(vec![self.linear(expr)?]),
        }
    }

    /// Π_{j=a}^{b} of factors that do not depend on j, or depend on it like j + c or c − j.
    pub(super) fn product_over(
        &mut self,
        lower: &[Expr],
        upper: Option<&Expr>,
        body: &Expr,
    ) -> Option<Vec<Term>> {
        let [Expr { kind: Kind::Chain(first, links), .. }] = lower else { return None };
        let (Kind::Name(name), [Link { rel: Rel::Eq, expr: from, .. }]) = (&first.kind, links.as_slice())
        else {
            return None;
        };
        let (a, b) = (self.linear(from)?, self.linear(upper?)?);
        let range = self.bind(name);
        self.scope.push(range.clone());
        let factor = self.read(body);
        self.scope.pop();
        let value = rational_value(&factor?)?;
        let known = self.known();
        // An empty range with more than one number missing would not fit the formula.
        if !known.entails(&b.minus(&a).shifted(1)) {
            return None;
        }
        let length = b.minus(&a).shifted(1);
        if !value.variables().contains(&range.1) {
            self.reals.extend(value.variables());
            return Some(vec![Term::power(&value, &length)?]);
        }
        let form = Linear::from_poly(value.as_polynomial()?)?;
        self.integers.extend(form.terms().keys().cloned());
        let known = self.known();
        let (first, last) = (form.substitute(&range.1, &a), form.substitute(&range.1, &b));
        let (high, low) = match form.coefficient(&range.1).as_small()? {
            1 => (last, first),
            -1 => (first, last),
            _ => return None,
        };
        // low (low+1) … high = high!/(low−1)!, where high ≥ 0 or the product is empty.
        if !known.entails(&high) {
            return None;
        }
        let mut term = Term::factorial(high, 1);
        term.multiply_factorial(low.shifted(-1), -1);
        Some(vec![term])
    }

    /// n (n−1) ⋯ (n−k+1), 1 · 2 ⋯ n: the product of consecutive integers from the factors around
    /// the dots, with the numbers of the first and the last factor used.
    pub(super) fn dotted(&mut self, factors: &[Expr], dots: usize) -> Option<(usize, usize, Term)> {
        let last = self.linear(factors.get(dots + 1)?)?;
        let mut forms = Vec::new();
        for factor in factors[..dots].iter().rev() {
            let Some(form) = self.linear(factor) else { break };
            forms.push(form);
        }
        let step = forms.first()?.minus(forms.get(1)?);
        let is_step = |pair: &[Linear]| pair[0].minus(&pair[1]) == step;
        let count = 1 + forms.windows(2).take_while(|pair| is_step(pair)).count();
        let first = &forms[count - 1];
        let (low, high) = match step.as_constant()?.as_small()? {
            1 => (first, &last),
            -1 => (&last, first),
            _ => return None,
        };
        let known = self.known();
        if !known.entails(high) || !known.entails(&high.minus(low).shifted(1)) {
            return None;
        }
        let mut term = Term::factorial(high.clone(), 1);
        term.multiply_factorial(low.shifted(-1), -1);
        Some((dots - count, dots + 1, term))
    }

    /// Values by cases: the first condition that holds counts. Each value stands in its own case
    /// only; elsewhere it need not have a meaning.
    pub(super) fn cases(&mut self, cases: &[(Expr, Option<Expr>)]) -> Option<Vec<Term>> {
        let mut remaining: Region = vec![BTreeSet::new()];
        let mut sum = Vec::new();
        for (value, condition) in cases {
            let (holds, fails) = match condition {
                Some(condition) => self.condition(condition)?,
                None => (vec![BTreeSet::new()], Vec::new()),
            };
            let outer = std::mem::replace(&mut self.in_case, true);
            let value = self.read(value);
            self.in_case = outer;
            let value = value?;
            for case in both(&remaining, &holds) {
                sum.extend(value.iter().map(|term| {
                    let mut term = term.clone();
                    term.guards.extend(case.iter().cloned());
                    term
                }));
            }
            remaining = both(&remaining, &fails);
            if sum.len() + remaining.len() > MAX_CASES {
                return None;
            }
        }
        Some(collected(sum))
    }

    /// Where a condition holds, and where it does not.
    fn condition(&mut self, condition: &Expr) -> Option<(Region, Region)> {
        let Kind::Chain(first, links) = &condition.kind else { return None };
        let (mut holds, mut fails): (Region, Region) = (vec![BTreeSet::new()], Vec::new());
        let mut left = self.linear(first)?;
        for link in links {
            let right = self.linear(&link.expr)?;
            let (less, more) = (right.minus(&left), left.minus(&right));
            let part = |forms: &[Linear]| forms.iter().cloned().collect::<BTreeSet<Linear>>();
            let equal = part(&[less.clone(), more.clone()]);
            let (below, above) = (part(&[less.shifted(-1)]), part(&[more.shifted(-1)]));
            let (here, elsewhere) = match link.rel {
                Rel::Eq => (vec![equal], vec![below, above]),
                Rel::Ne => (vec![below, above], vec![equal]),
                Rel::Le => (vec![part(&[less])], vec![above]),
                Rel::Lt => (vec![below], vec![part(&[more])]),
                Rel::Ge => (vec![part(&[more])], vec![below]),
                Rel::Gt => (vec![above], vec![part(&[less])]),
                _ => return None,
            };
            fails.extend(both(&holds, &elsewhere));
            holds = both(&holds, &here);
            left = right;
        }
        Some((holds, fails))
    }
}

/// The intersection of two regions.
fn both(a: &Region, b: &Region) -> Region {
    a.iter().flat_map(|x| b.iter().map(|y| x.union(y).cloned().collect())).collect()
}
