//! Notations of notes that the language does not have: block matrices, sums without bounds, cases on
//! knot intervals, indices in the place of exponents.

use super::calls::unclear;
use super::{Evaluated, FREE_TERMS, Model, shape};
use crate::formula::{BigOp, Delimiter, Expr, Kind, Link, Rel, Sign, Term};
use crate::judge::page::context::Body;
use crate::judge::written::names::{Head, implied_index, is_star, walk};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::lexicon::families::Family;
use crate::language::lexicon::roles;
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use nalgebra::DMatrix;

impl Model {
    /// Powers that are none: A^T is left to the language, b_i^r may be a name with two indices.
    pub(super) fn power(
        &self,
        machine: &mut Machine,
        base: &Expr,
        exponent: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        if let Kind::Name(mark) = &exponent.kind
            && matches!(mark.as_str(), "T" | "top")
        {
            return Some(machine.eval(base).and_then(|value| match value {
                // L = L^T, where nothing says what L is
                Value::Scalar(formula)
                    if matches!(base.kind, Kind::Name(_)) && formula.as_rational().is_none() =>
                {
                    Err(unclear("what is transposed here", expr))
                }
                Value::Scalar(_) => Ok(value),
                other => arithmetic::transpose(other).map_err(|error| error.at(expr.span)),
            }));
        }
        if let Kind::Apply(callee, groups) = &base.kind
            && let Some(product) = self.as_product(machine, callee, groups, Some(exponent), expr)
        {
            return Some(product);
        }
        // x(t)^2 is the square of a value, if x is a function; x^i (1-x)^{n-i} is a product.
        if let Kind::Apply(callee, _) = &base.kind
            && Head::of(callee).is_none_or(|head| head.upper.is_empty())
            && self.is_function(machine, callee)
        {
            return Some(machine.eval(base).and_then(|value| {
                let exponent = machine.eval(exponent)?;
                arithmetic::power(value, &exponent).map_err(|error| error.at(expr.span))
            }));
        }
        let head = self.context.with_pairs_apart(Head::of(expr)?);
        if let Some(result) = self.defined(machine, &head, None) {
            return Some(result);
        }
        if let Some(result) = self.standard_name(machine, &head, expr) {
            return Some(result);
        }
        if !head.lower.is_empty() && self.context.letters.towers.contains(&head.base) && !head.parenthesized {
            return Some(self.symbol(machine, &head, expr).map(Value::symbol));
        }
        let prime = matches!(&exponent.kind, Kind::Name(name) if name == "prime");
        if prime || is_star(exponent) {
            return Some(self.symbol(machine, &head, expr).map(Value::symbol));
        }
        None
    }

    /// A matrix with blocks in it or with empty cells beside them.
    pub(super) fn blocks(
        &self,
        machine: &mut Machine,
        rows: &[Vec<Option<Expr>>],
        delimiter: Delimiter,
        expr: &Expr,
    ) -> Option<Evaluated> {
        if delimiter == Delimiter::Bar || rows.iter().flatten().all(Option::is_some) {
            return None;
        }
        let height = rows.len();
        let width = rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut matrix: DMatrix<Option<Fraction>> = DMatrix::from_element(height, width, None);
        let mut blocks = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            for (j, cell) in row.iter().enumerate() {
                let Some(cell) = cell else { continue };
                match machine.eval(cell) {
                    Ok(Value::Scalar(x)) => matrix[(i, j)] = Some(x),
                    Ok(Value::Matrix(block)) => blocks.push((i, j, block)),
                    Ok(_) => return Some(Err(shape("a cell that is neither a number nor a matrix", expr))),
                    Err(error) => return Some(Err(error)),
                }
            }
        }
        for (i, j, block) in blocks {
            // A block stands for the empty cells around it: its corner is the first empty cell there.
            let (h, w) = block.shape();
            let fits = (0..=height.saturating_sub(h))
                .flat_map(|top| (0..=width.saturating_sub(w)).map(move |left| (top, left)));
            let place = fits.into_iter().find(|&(top, left)| {
                (top..top + h).contains(&i)
                    && (left..left + w).contains(&j)
                    && (top..top + h).all(|r| (left..left + w).all(|c| matrix[(r, c)].is_none()))
            });
            let Some((top, left)) = place else {
                return Some(Err(shape("where the block in this matrix ends is not clear", expr)));
            };
            for r in 0..h {
                for c in 0..w {
                    matrix[(top + r, left + c)] = Some(block[(r, c)].clone());
                }
            }
        }
        let zero = || Fraction::from(MultiPoly::zero());
        Some(Ok(Value::Matrix(matrix.map(|cell| cell.unwrap_or_else(zero)))))
    }

    /// Sums without bounds, with bounds but no index, or up to ∞.
    pub(super) fn unbounded(
        &self,
        machine: &mut Machine,
        op: BigOp,
        lower: &[Expr],
        upper: Option<&Expr>,
        body: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        if !matches!(op, BigOp::Sum | BigOp::Product) {
            return None;
        }
        let range = |name: &str, from: Expr, to: Expr| {
            let piece = Expr::new(
                Kind::Chain(
                    Box::new(Expr::name(name)),
                    vec![Link { rel: Rel::Eq, span: expr.span, expr: from }],
                ),
                expr.span,
            );
            let big =
                Kind::Big { op, lower: vec![piece], upper: Some(Box::new(to)), body: Box::new(body.clone()) };
            Expr::new(big, expr.span)
        };
        // All B-splines that are not 0 on one of the intervals that are tried.
        let local = |machine: &mut Machine, name: &str| {
            let part = |machine: &mut Machine, first: i64, last: i64| {
                machine.eval(&range(name, Expr::int(first), Expr::int(last)))
            };
            if let Some(sum) = self.over_given_knots(&mut |first, last| part(machine, first, last)) {
                return sum;
            }
            let mut sum = part(machine, -LOCAL_TERMS, LOCAL_TERMS)?;
            let mut end = LOCAL_TERMS;
            // Beyond the knots there are no more, perhaps on one side only.
            let mut open = [true, true];
            while op == BigOp::Sum && open != [false, false] {
                let next = end + LOCAL_TERMS;
                let mut wider = sum.clone();
                for (open, [from, to]) in open.iter_mut().zip([[end + 1, next], [-next, -end - 1]]) {
                    let more = open.then(|| part(machine, from, to).ok()).flatten();
                    *open = more.is_some();
                    if let Some(more) = more {
                        wider = arithmetic::add(wider, more).map_err(|error| error.at(expr.span))?;
                    }
                }
                if wider == sum {
                    break;
                }
                if next > MOST_LOCAL_TERMS {
                    let message = "limits of infinite sums are not computed";
                    return Err(Diagnostic::error(Code::Undecided, message).at(expr.span));
                }
                (sum, end) = (wider, next);
            }
            Ok(sum)
        };
        if let ([Expr { kind: Kind::Chain(index, links), .. }], Some(upper)) = (lower, upper)
            && let (Kind::Name(name), [Link { rel: Rel::Eq, expr: from, .. }]) =
                (&index.kind, links.as_slice())
            && is_infinity(upper)
            && matches!(&from.kind, Kind::Add(terms) if matches!(terms.as_slice(),
                [Term { sign: Sign::Minus, expr }] if is_infinity(expr)))
            && self.is_local()
        {
            return Some(local(machine, name));
        }
        if let Some(upper) = upper
            && is_infinity(upper)
        {
            let Some(degree) = self.degree else {
                self.record.borrow_mut().wants_degree = true;
                return Some(Err(Diagnostic::error(Code::Undecided, "an infinite sum").at(expr.span)));
            };
            self.record.borrow_mut().infinite = true;
            let up_to = |end: i64| {
                let (lower, upper) = (lower.to_vec(), Some(Box::new(Expr::int(end))));
                Expr::new(Kind::Big { op, lower, upper, body: Box::new(body.clone()) }, expr.span)
            };
            let last = degree.max(4) as i64;
            let sums: Result<Vec<Value>, Diagnostic> =
                (last..=last + 4).map(|end| machine.eval(&up_to(end))).collect();
            return Some(sums.and_then(|mut sums| {
                // Only a sum whose terms vanish from some place on has a value here.
                let first = sums.swap_remove(0);
                if sums.iter().all(|sum| *sum == first) {
                    return Ok(first);
                }
                Err(Diagnostic::error(Code::Undecided, "limits of infinite sums are not computed")
                    .at(expr.span))
            }));
        }
        let bound_names: Vec<Expr> = lower
            .iter()
            .flat_map(|piece| match &piece.kind {
                Kind::Sequence(items) | Kind::Tuple(items) => items.clone(),
                _ => vec![piece.clone()],
            })
            .collect();
        let all = |machine: &mut Machine, name: &str| {
            let (first, last) = match self.last_nonzero(body, name) {
                Some(last) => (0, last),
                None if self.is_local() => return Some(local(machine, name)),
                None => {
                    self.record.borrow_mut().unbounded = true;
                    (1, Expr::int(FREE_TERMS))
                }
            };
            Some(machine.eval(&range(name, Expr::int(first), last)))
        };
        match (bound_names.as_slice(), upper) {
            ([], None) => all(machine, &implied_index(body)?),
            ([one], None) => match &one.kind {
                // Σ_π over all permutations, where the body applies π
                Kind::Name(name) if applies(body, name) => self.permuted(machine, op, name, None, body, expr),
                Kind::Name(name) => all(machine, name),
                Kind::Chain(left, links) if matches!((&left.kind, links.as_slice()), (Kind::Name(name), [Link { rel: Rel::In, .. }]) if applies(body, name)) =>
                {
                    let Kind::Name(name) = &left.kind else { return None };
                    let group = Head::of(&links[0].expr)?;
                    let size = group.lower.first().or(group.flat().first().copied()).cloned();
                    self.permuted(machine, op, name, size, body, expr)
                }
                // Σ_{|S| = i}, where the page says of which set S is a part
                Kind::Chain(left, _) if matches!(left.kind, Kind::Enclosed(..)) => {
                    let Kind::Enclosed(_, set) = &left.kind else { return None };
                    let whole = self.whole_set(machine, set)?;
                    let lower = vec![whole, one.clone()];
                    let big = Kind::Big { op, lower, upper: None, body: Box::new(body.clone()) };
                    Some(machine.eval(&Expr::new(big, expr.span)))
                }
                // i ∈ ℤ
                Kind::Chain(left, links) => match (&left.kind, links.as_slice()) {
                    (Kind::Name(name), [Link { rel: Rel::In, expr: set, .. }])
                        if Head::of(set).is_some_and(|set| set.base == "Z" && set.lower.is_empty()) =>
                    {
                        all(machine, name)
                    }
                    // Π_{j ≠ i} (x_i - x_j), where the page lists x_0, …, x_n
                    (Kind::Name(name), [Link { rel: Rel::Ne, .. }]) => {
                        let (from, to) = self.listed_with(body, name)?;
                        let from = Expr::relation(Expr::name(name), Rel::Eq, from);
                        let lower = vec![from, one.clone()];
                        let big =
                            Kind::Big { op, lower, upper: Some(Box::new(to)), body: Box::new(body.clone()) };
                        Some(machine.eval(&Expr::new(big, expr.span)))
                    }
                    _ => self.increasing(machine, op, one, body, expr),
                },
                _ => None,
            },
            ([from], Some(to)) if !matches!(from.kind, Kind::Chain(..)) => {
                let name = implied_index(body)?;
                Some(machine.eval(&range(&name, from.clone(), to.clone())))
            }
            // i + j + k = d, i, j, k ≥ 0: the sums run over nonnegative integers anyway
            (many, None) if many.len() > 1 => {
                let first = &many[0];
                let Kind::Chain(left, _) = &first.kind else { return None };
                let rest = many[1..].iter().all(|piece| match &piece.kind {
                    Kind::Name(_) => true,
                    Kind::Chain(_, links) => matches!(links.as_slice(), [Link { rel: Rel::Ge, expr, .. }]
                        if matches!(&expr.kind, Kind::Number(q) if num_traits::Zero::is_zero(q))),
                    _ => false,
                });
                if !matches!(left.kind, Kind::Add(_)) || !rest {
                    return None;
                }
                let big =
                    Kind::Big { op, lower: vec![first.clone()], upper: None, body: Box::new(body.clone()) };
                Some(machine.eval(&Expr::new(big, expr.span)))
            }
            _ => None,
        }
    }

    /// "S ⊆ {1, …, n}", as the page says it, or else of the numbers up to the degree.
    fn whole_set(&self, machine: &mut Machine, set: &Expr) -> Option<Expr> {
        let told = self.context.conditions.iter().rev().find(|condition| {
            self.place.knows(&condition.place, condition.assumed)
                && matches!(&condition.expr.kind, Kind::Chain(left, links)
                    if left.same_as(set) && matches!(links.as_slice(), [Link { rel: Rel::Subset, .. }]))
        });
        if let Some(told) = told {
            return Some(told.expr.clone());
        }
        let size = self.size_here(machine)?;
        let items = (1..=size).map(Expr::int).collect();
        Some(Expr::relation(set.clone(), Rel::Subset, Kind::Set(items, None).into()))
    }

    /// The value of the letter for a degree.
    fn size_here(&self, machine: &Machine) -> Option<i64> {
        let value = |name: &&str| machine.lookup(&Symbol::new(*name)).and_then(Value::as_int);
        roles::DEGREES.iter().find_map(value).or(self.degree.map(|degree| degree as i64))
    }

    /// A sum or product over all permutations of 1, …, n.
    ///
    /// Cost: n! evaluations.
    fn permuted(
        &self,
        machine: &mut Machine,
        op: BigOp,
        name: &str,
        size: Option<Expr>,
        body: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let size = match size {
            Some(size) => machine.eval_int(&size).ok()?,
            None => self.size_here(machine)?,
        };
        if !(0..=MOST_PERMUTED).contains(&size) {
            let message = "there are too many permutations to try";
            return Some(Err(Diagnostic::error(Code::Undecided, message).at(expr.span)));
        }
        let letter = Symbol::new(name);
        let mut indexed = body.clone();
        with_indices(&mut indexed, name);
        let combine = if op == BigOp::Product { arithmetic::multiply } else { arithmetic::add };
        let mut result = Value::int(i64::from(op == BigOp::Product));
        for order in orders(size) {
            crate::budget::steps(16);
            let names: Vec<(Symbol, Value)> =
                (1..).zip(&order).map(|(at, &to)| (letter.numbered(at), Value::int(to))).collect();
            let term = machine.with_locals(names, |machine| machine.eval(&indexed));
            match term.and_then(|term| combine(result, term)) {
                Ok(value) => result = value,
                Err(error) => return Some(Err(error.at(expr.span))),
            }
        }
        Some(Ok(result))
    }

    /// The range of an index of a family that the page lists.
    fn listed_with(&self, body: &Expr, name: &str) -> Option<(Expr, Expr)> {
        let mut found = None;
        walk(body, &mut |part| {
            if let (None, Kind::Subscript(base, lower)) = (&found, &part.kind)
                && matches!(lower.as_slice(), [Expr { kind: Kind::Name(own), .. }] if own == name)
                && let Some(head) = Head::of(base)
            {
                found = self.context.listed(&head.base, &self.place);
            }
        });
        found
    }

    /// Σ over 1 ≤ i_1 < … < i_k ≤ n: over the sets of k of these numbers.
    ///
    /// Cost: C(n, k) evaluations.
    fn increasing(
        &self,
        machine: &mut Machine,
        op: BigOp,
        range: &Expr,
        body: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let Kind::Chain(least, links) = &range.kind else { return None };
        let [low, rise, fall, high] = links.as_slice() else { return None };
        let strict = |rel: Rel| rel == Rel::Lt;
        if fall.expr.kind == Kind::Ellipsis
            || rise.expr.kind != Kind::Ellipsis
            || !strict(rise.rel)
            || !strict(fall.rel)
        {
            return None;
        }
        let (first, last) = (Head::of(&low.expr)?, Head::of(&fall.expr)?);
        let ([from], [to]) = (first.lower.as_slice(), last.lower.as_slice()) else { return None };
        if first.base != last.base {
            return None;
        }
        let int = |machine: &mut Machine, expr: &Expr| machine.eval_int(expr).ok();
        let (from, to) = (int(machine, from)?, int(machine, to)?);
        let least = int(machine, least)? + i64::from(strict(low.rel));
        let most = int(machine, &high.expr)? - i64::from(strict(high.rel));
        let count = usize::try_from(to - from + 1).ok()?;
        let members = usize::try_from((most - least + 1).max(0)).ok()?;
        let letter = Symbol::new(&first.base);
        let mut result = Value::int(i64::from(op == BigOp::Product));
        let mut chosen: Vec<usize> = (0..count).collect();
        if count > members {
            return Some(Ok(result));
        }
        loop {
            crate::budget::steps(16);
            let names: Vec<(Symbol, Value)> = (from..=to)
                .zip(&chosen)
                .map(|(at, &member)| (letter.numbered(at), Value::int(least + member as i64)))
                .collect();
            let term = match machine.with_locals(names, |machine| machine.eval(body)) {
                Ok(term) => term,
                Err(error) => return Some(Err(error)),
            };
            let joined = match op {
                BigOp::Product => arithmetic::multiply(result, term),
                _ => arithmetic::add(result, term),
            };
            result = match joined {
                Ok(value) => value,
                Err(error) => return Some(Err(error.at(expr.span))),
            };
            // The next set, in the order of the alphabet.
            let Some(at) = (0..count).rev().find(|&at| chosen[at] < members - count + at) else {
                return Some(Ok(result));
            };
            chosen[at] += 1;
            for next in at + 1..count {
                chosen[next] = chosen[next - 1] + 1;
            }
        }
    }

    /// Values at t_1 = … = t_n = t, also where an equals sign was lost.
    pub(super) fn at(
        &self,
        machine: &mut Machine,
        body: &Expr,
        lower: &[Expr],
        expr: &Expr,
    ) -> Option<Evaluated> {
        let [piece] = lower else { return None };
        let Kind::Chain(left, links) = &piece.kind else { return None };
        let dots = links.iter().any(|link| {
            let mut found = false;
            walk(&link.expr, &mut |part| found = found || part.kind == Kind::Ellipsis);
            found
        });
        if !dots {
            return None;
        }
        let head = Head::of(left)?;
        let value = match machine.eval(&links.last()?.expr) {
            Ok(value) => value,
            Err(error) => return Some(Err(error)),
        };
        // All members of the family t_1, t_2, … get the value.
        let base = Symbol::new(&head.base);
        let names: Vec<(Symbol, Value)> = (0..=40).map(|i| (base.numbered(i), value.clone())).collect();
        Some(machine.with_locals(names, |machine| machine.eval(body)).map_err(|error| error.at(expr.span)))
    }
}

impl Model {
    /// The last index for which the terms of a sum over all integers do not vanish, by the binomial or Bernstein
    /// polynomial in them: n for C(n, k) and B_k^n, also if a name for them stands there.
    fn last_nonzero(&self, body: &Expr, index: &str) -> Option<Expr> {
        let bernstein = |head: &Head| {
            let own = || self.context.is_own(&head.base, &self.place);
            head.is_a(Family::Bernstein) && (head.lower.len() == 1 || !own())
        };
        let mut last = last_nonzero(body, index, &bernstein);
        let mut heads: Vec<Head> = Vec::new();
        walk(body, &mut |part| heads.extend(Head::of(part).filter(|head| !head.lower.is_empty())));
        for head in heads {
            let given: Vec<&Expr> = head.lower.iter().chain(&head.upper).collect();
            let at = given.iter().position(|own| matches!(&own.kind, Kind::Name(name) if name == index));
            let (Some(at), None) = (at, &last) else { continue };
            last = self.context.visible(&head.base, &self.place).find_map(|(_, definition, _)| {
                let own: Vec<&Expr> = definition.head.lower.iter().chain(&definition.head.upper).collect();
                let (Body::Formula(body), Kind::Name(letter)) = (&definition.body, &own.get(at)?.kind) else {
                    return None;
                };
                let last = last_nonzero(body, letter, &bernstein).filter(|_| own.len() == given.len())?;
                let place = own.iter().position(|own| own.same_as(&last));
                Some(place.map_or(last, |place| given[place].clone()))
            });
        }
        last
    }
}

/// The B-splines with numbers from −4 to 4 are all up to degree 3 that are not 0 where they are mostly tried; as many
/// more on both sides show whether the others vanish.
const LOCAL_TERMS: i64 = 4;

/// Permutations of more numbers are too many.
const MOST_PERMUTED: i64 = 5;

/// Whether a formula applies a name to something: t_{π(i)}.
fn applies(body: &Expr, name: &str) -> bool {
    body.has(&|part| matches!(&part.kind, Kind::Apply(callee, groups)
        if matches!(&callee.kind, Kind::Name(own) if own == name) && groups.iter().map(Vec::len).sum::<usize>() == 1))
}

/// π(i) as π_i.
fn with_indices(expr: &mut Expr, name: &str) {
    expr.for_each_child_mut(&mut |child| with_indices(child, name));
    if let Kind::Apply(callee, groups) = &expr.kind
        && matches!(&callee.kind, Kind::Name(own) if own == name)
    {
        let index = groups.concat();
        *expr = Expr::new(Kind::Subscript(callee.clone(), index), expr.span);
    }
}

/// All orders of 1, …, n.
fn orders(size: i64) -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for next in 1..=size {
        all = all
            .iter()
            .flat_map(|order: &Vec<i64>| {
                (0..=order.len()).map(move |at| {
                    let mut longer = order.clone();
                    longer.insert(at, next);
                    longer
                })
            })
            .collect();
    }
    all
}

/// Further away nothing is looked for.
const MOST_LOCAL_TERMS: i64 = 24;

fn is_infinity(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Name(name) if name == "infty")
}

/// The last index for which the terms of a sum over all integers do not vanish, by the binomial or Bernstein
/// polynomial in them: n for C(n, k) and B_k^n.
fn last_nonzero(body: &Expr, index: &str, bernstein: &dyn Fn(&Head) -> bool) -> Option<Expr> {
    let is_index = |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if name == index);
    let mut last = None;
    walk(body, &mut |part| match &part.kind {
        Kind::Binomial(n, k, _) if is_index(k) => last = Some(n.as_ref().clone()),
        Kind::Apply(callee, _) => {
            if let Some(head) = Head::of(callee)
                && bernstein(&head)
                && let [one, other] = head.lower.iter().chain(&head.upper).collect::<Vec<_>>()[..]
            {
                // B_i^n, B_{i,n}, or B_{n,i}
                match (is_index(one), is_index(other)) {
                    (true, false) => last = Some(other.clone()),
                    (false, true) => last = Some(one.clone()),
                    _ => {}
                }
            }
        }
        _ => {}
    });
    last
}
