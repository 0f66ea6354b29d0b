//! Small edits of a formula: an index moved, a letter exchanged, a sign, a factor.

use super::exchanges::exchanges;
use super::tidy::tidy;
use crate::formula::{BinomialStyle, Expr, Kind, Rel, Sign, Term};
use crate::judge::page::statement::Curve;
use crate::judge::written::names::{bases, integer_names, is_index_letter, own_names, walk};
use crate::math::number::{Rational, integer};
use num_traits::{One, Signed, Zero};

/// Small edits of a formula, the likeliest first.
pub(in crate::judge) fn edits(expr: &Expr, other: &Expr, curve: &Option<Curve>) -> Vec<Expr> {
    let mut pool = Pool::default();
    pool.collect(expr);
    pool.collect(other);
    let mut found: Vec<(u32, Expr)> = Vec::new();
    let mut binomials = Vec::new();
    walk(expr, &mut |part| {
        if let Kind::Binomial(..) = &part.kind {
            binomials.push(part.span);
        }
    });
    at_every_node(expr, false, &mut |node, in_index, rebuild| {
        for (cost, replacement) in node_edits(node, in_index, &pool) {
            // A lost factor is likelier than another binomial.
            let within =
                binomials.iter().any(|span| span.start <= node.span.start && node.span.end <= span.end);
            let cost = cost + if within { 3 } else { 0 };
            // The same slip may have been made wherever the name stands.
            let exchanged = matches!(
                replacement.kind,
                Kind::Subscript(..) | Kind::Name(_) | Kind::Add(_) | Kind::Group(_)
            );
            if exchanged && matches!(node.kind, Kind::Subscript(..) | Kind::Name(_)) {
                let mut all = expr.clone();
                let places = replace_all(&mut all, node, &replacement);
                if places > 1 {
                    // Many of the same slip are another formula.
                    let more = if places > MANY { LESS } else { 0 };
                    found.push((cost + more, all));
                }
            }
            found.push((cost, rebuild(replacement)));
        }
    });
    // Two members of a family exchanged in a sum: the weights of b_{i-1} and b_i.
    at_every_node(expr, false, &mut |node, _, rebuild| {
        if !matches!(node.kind, Kind::Add(_) | Kind::Div(..)) {
            return;
        }
        for (at, first) in pool.siblings.iter().enumerate() {
            for second in &pool.siblings[at + 1..] {
                let mut exchanged = node.clone();
                if exchange(&mut exchanged, first, second) > 1 {
                    found.push((1, rebuild(exchanged)));
                }
            }
        }
    });
    // Factors for the whole side, or for the terms of its sum.
    for (cost, factor) in factors(&pool, expr) {
        found.push((cost, Expr::product(vec![factor.clone(), grouped(expr)])));
        within_sums(expr, &factor, cost, &mut found);
    }
    if let Some(curve) = curve {
        let point = Expr::from(Kind::Subscript(Box::new(Expr::name(&curve.points)), vec![Expr::name("i")]));
        within_sums(expr, &point, 0, &mut found);
    }
    found.extend(exchanges(expr, other));
    // What speaks of less than before is seldom meant.
    let names = bases(expr);
    let elsewhere = bases(other);
    let says_less = |edit: &Expr| {
        let kept = bases(edit);
        names.iter().any(|name| !kept.contains(name) && !elsewhere.contains(name))
    };
    found.retain(|(_, edit)| !has_power_zero(edit) || has_power_zero(expr));
    found.iter_mut().filter(|(_, edit)| says_less(edit)).for_each(|(cost, _)| *cost += LESS);
    found.sort_by_key(|(cost, _)| *cost);
    let mut edits: Vec<Expr> = found.into_iter().map(|(_, edit)| edit).collect();
    edits.iter_mut().for_each(tidy);
    edits
}

/// What an edit costs more if a name is gone with it.
const LESS: u32 = 4;

/// The same slip is made in no more places.
const MANY: usize = 4;

fn has_power_zero(expr: &Expr) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        if let Kind::Pow(_, exponent) = &part.kind {
            found |= is_zero(exponent);
        }
    });
    found
}

pub(super) fn is_zero(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Number(q) if *q == Rational::zero())
}

/// Replaces a node wherever it occurs; says how often.
fn replace_all(expr: &mut Expr, node: &Expr, by: &Expr) -> usize {
    if expr.same_as(node) {
        *expr = with_span(by.clone(), node);
        return 1;
    }
    let mut count = 0;
    expr.for_each_child_mut(&mut |child| count += replace_all(child, node, by));
    count
}

/// Exchanges two members of one family; says how many places change.
fn exchange(expr: &mut Expr, first: &Expr, second: &Expr) -> usize {
    if let (Kind::Subscript(a, _), Kind::Subscript(b, _)) = (&first.kind, &second.kind)
        && !a.same_as(b)
    {
        return 0;
    }
    for (own, other) in [(first, second), (second, first)] {
        if expr.same_as(own) {
            *expr = with_span(other.clone(), expr);
            return 1;
        }
    }
    let mut count = 0;
    expr.for_each_child_mut(&mut |child| count += exchange(child, first, second));
    count
}

/// Whether a term begins with a number.
fn has_coefficient(term: &Expr) -> bool {
    let number = |expr: &Expr| matches!(expr.kind, Kind::Number(_) | Kind::Div(..));
    match &term.kind {
        Kind::Mul(factors) => factors.first().is_some_and(number),
        _ => number(term),
    }
}

pub(super) fn grouped(expr: &Expr) -> Expr {
    match expr.kind {
        Kind::Add(_) => expr.clone().grouped(),
        _ => expr.clone(),
    }
}

/// The body of a sum multiplied by a factor.
fn within_sums(expr: &Expr, factor: &Expr, cost: u32, found: &mut Vec<(u32, Expr)>) {
    at_every_node(expr, false, &mut |node, _, rebuild| {
        if let Kind::Big { op, lower, upper, body } = &node.kind {
            // A factor goes before what depends on the variable, after binomials.
            let mut factors = match &body.kind {
                Kind::Mul(factors) => factors.clone(),
                _ => vec![body.as_ref().clone()],
            };
            let at = factors
                .iter()
                .take_while(|f| matches!(f.kind, Kind::Binomial(..) | Kind::Number(_) | Kind::Div(..)))
                .count();
            factors.insert(at, factor.clone());
            let body = Box::new(Expr::product(factors));
            let big = Kind::Big { op: *op, lower: lower.clone(), upper: upper.clone(), body };
            found.push((cost + 1, rebuild(Expr::new(big, node.span))));
        }
    });
}

/// Factors that are easily lost: n, 1/n, 1/n!, signs, small numbers.
fn factors(pool: &Pool, expr: &Expr) -> Vec<(u32, Expr)> {
    let one_over = |e: Expr| Expr::int(1).over(e);
    let mut list =
        vec![(3, Expr::int(2)), (3, one_over(Expr::int(2))), (4, Expr::int(3)), (4, one_over(Expr::int(3)))];
    for name in &pool.integers {
        let n = || Expr::name(name);
        let factorial = || Expr::from(Kind::Factorial(Box::new(n())));
        list.push((2, n()));
        list.push((3, one_over(n())));
        list.push((3, one_over(factorial())));
        list.push((4, factorial()));
        let plus = |by: i64| n().plus(by);
        list.push((4, plus(1).grouped()));
        list.push((4, plus(-1).grouped()));
        list.push((4, one_over(plus(1))));
        list.push((4, one_over(plus(-1))));
    }
    // The alternating sign of a sum over i up to n, perhaps with 1/n!.
    walk(expr, &mut |part| {
        if let Kind::Big { lower, upper: Some(upper), .. } = &part.kind
            && let Some(i) = own_names(lower).first()
        {
            let minus_one = || Expr::int(-1).grouped();
            let term = |sign, expr| Term { sign, expr };
            let difference: Expr =
                Kind::Add(vec![term(Sign::Plus, upper.as_ref().clone()), term(Sign::Minus, Expr::name(i))])
                    .into();
            let factorial = Expr::from(Kind::Factorial(upper.clone()));
            for exponent in [difference, Expr::name(i)] {
                let sign = minus_one().power(exponent);
                list.push((4, sign.clone()));
                list.push((5, sign.over(factorial.clone())));
            }
            // Means of products have binomials.
            let binomial = Kind::Binomial(upper.clone(), Box::new(Expr::name(i)), BinomialStyle::Stacked);
            list.push((5, one_over(binomial.into())));
        }
    });
    list
}

/// Names and numbers that occur in a formula and may have been exchanged.
#[derive(Default)]
struct Pool {
    /// Indexed names by base, each with its indices.
    siblings: Vec<Expr>,
    /// Plain names that are no functions.
    names: Vec<String>,
    /// Names of integers.
    integers: Vec<String>,
}

impl Pool {
    fn collect(&mut self, expr: &Expr) {
        walk(expr, &mut |part| match &part.kind {
            Kind::Subscript(..) if !self.siblings.iter().any(|known| known.same_as(part)) => {
                self.siblings.push(part.clone());
            }
            _ => {}
        });
        self.plain_names(expr);
        for name in integer_names(expr) {
            if !self.integers.contains(&name) {
                self.integers.push(name);
            }
        }
    }

    /// Names that stand alone: not those that are called or indexed.
    fn plain_names(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Name(name) if !self.names.contains(name) => self.names.push(name.clone()),
            Kind::Apply(callee, groups) if matches!(callee.kind, Kind::Name(_)) => {
                groups.iter().flatten().for_each(|argument| self.plain_names(argument));
            }
            Kind::Subscript(base, indices) if matches!(base.kind, Kind::Name(_)) => {
                indices.iter().for_each(|index| self.plain_names(index));
            }
            _ => expr.for_each_child(&mut |child| self.plain_names(child)),
        }
    }
}

/// Edits of one node, with a cost each.
fn node_edits(node: &Expr, in_index: bool, pool: &Pool) -> Vec<(u32, Expr)> {
    let mut list: Vec<(u32, Expr)> = Vec::new();
    let new = |kind: Kind| Expr::new(kind, node.span);
    match &node.kind {
        Kind::Number(q) => {
            let mut near = vec![q + integer(1), q - integer(1)];
            if !in_index {
                near.extend([
                    q * integer(2),
                    q / integer(2),
                    q + integer(2),
                    q * integer(3),
                    q / integer(3),
                    q - integer(2),
                ]);
            }
            for value in near {
                if !value.is_negative() {
                    list.push((if in_index { 0 } else { 1 }, with_span(Expr::number(&value), node)));
                }
            }
        }
        Kind::Name(name) => {
            for other in pool.names.iter().filter(|other| *other != name) {
                let alike = is_index_letter(name) == is_index_letter(other);
                let case = name.chars().next().map(char::is_uppercase)
                    == other.chars().next().map(char::is_uppercase);
                if alike && case {
                    list.push((if in_index { 1 } else { 2 }, new(Kind::Name(other.clone()))));
                }
            }
            let integer = pool.integers.contains(name);
            let index = integer || is_index_letter(name);
            // n − i, i + n for i
            for other in pool.integers.iter().filter(|other| in_index && index && *other != name) {
                let difference = [(Sign::Plus, Expr::name(other)), (Sign::Minus, node.clone())];
                let sum = [(Sign::Plus, node.clone()), (Sign::Plus, Expr::name(other))];
                for (cost, terms) in [(3, difference), (4, sum)] {
                    list.push((cost, new(Kind::Add(terms.map(|(sign, expr)| Term { sign, expr }).into()))));
                }
            }
            if integer && !in_index {
                for by in [1, -1] {
                    list.push((3, node.clone().plus(by).grouped()));
                }
            }
            // i for i + 1 and i − 1
            if in_index && is_index_letter(name) {
                for sign in [Sign::Plus, Sign::Minus] {
                    let terms = vec![
                        Term { sign: Sign::Plus, expr: node.clone() },
                        Term { sign, expr: Expr::int(1) },
                    ];
                    list.push((0, new(Kind::Add(terms))));
                }
            }
        }
        Kind::Subscript(base, indices) => {
            for sibling in &pool.siblings {
                if let Kind::Subscript(own, others) = &sibling.kind
                    && own.same_as(base)
                    && others.len() == indices.len()
                    && !sibling.same_as(node)
                {
                    list.push((1, with_span(sibling.clone(), node)));
                }
            }
            // P_{n,0,0} for P_{0,0,n}, v_k for v_{k-1}
            for i in 0..indices.len() {
                for j in i + 1..indices.len() {
                    let mut swapped = indices.clone();
                    swapped.swap(i, j);
                    list.push((2, new(Kind::Subscript(base.clone(), swapped))));
                }
                if let Kind::Add(terms) = &indices[i].kind
                    && terms.len() == 2
                    && matches!(&terms[1].expr.kind, Kind::Number(q) if q.is_one())
                {
                    let mut plain = indices.clone();
                    plain[i] = terms[0].expr.clone();
                    list.push((1, new(Kind::Subscript(base.clone(), plain))));
                }
            }
        }
        Kind::Add(terms) => {
            for (i, term) in terms.iter().enumerate() {
                let mut changed = terms.clone();
                changed[i].sign = if term.sign == Sign::Plus { Sign::Minus } else { Sign::Plus };
                list.push((1, new(Kind::Add(changed))));
                // b − a for a − b
                if let (0, [first, second]) = (i, terms.as_slice())
                    && (first.sign, second.sign) == (Sign::Plus, Sign::Minus)
                {
                    let plus = Term { sign: Sign::Plus, ..second.clone() };
                    let minus = Term { sign: Sign::Minus, ..first.clone() };
                    list.push((1, new(Kind::Add(vec![plus, minus]))));
                }
                // a − 2b + c for a − b + c
                if !in_index && !has_coefficient(&term.expr) {
                    for lost in [2, 3] {
                        let mut changed = terms.clone();
                        changed[i].expr = Expr::product(vec![Expr::int(lost), grouped(&term.expr)]);
                        list.push((4, new(Kind::Add(changed))));
                    }
                }
                if terms.len() == 2 {
                    // n − 1 for n, n + 1 for n − 1
                    let number = matches!(&terms[1].expr.kind, Kind::Number(q) if q.is_one());
                    if number && i == 1 {
                        list.push((0, terms[0].expr.clone()));
                    }
                }
                if terms.len() > 2 {
                    let mut shorter = terms.clone();
                    shorter.remove(i);
                    list.push((4, new(Kind::Add(shorter))));
                }
            }
            if in_index && terms.len() == 2 && terms[0].sign == Sign::Plus {
                list.extend(terms.iter().map(|term| (2, term.expr.clone())));
            }
            if in_index {
                // n + 1 − k for n + 1
                for name in &pool.integers {
                    let names: Vec<&Expr> = terms.iter().map(|term| &term.expr).collect();
                    if !names.iter().any(|known| matches!(&known.kind, Kind::Name(own) if own == name)) {
                        let mut changed = terms.clone();
                        changed.push(Term { sign: Sign::Minus, expr: Expr::name(name) });
                        list.push((3, new(Kind::Add(changed))));
                    }
                }
                // n − k for n − 2, by a letter that occurs
                for (i, term) in terms.iter().enumerate().skip(1) {
                    if matches!(term.expr.kind, Kind::Number(_)) {
                        for name in &pool.integers {
                            let mut changed = terms.clone();
                            changed[i].expr = Expr::name(name);
                            list.push((2, new(Kind::Add(changed))));
                        }
                    }
                }
            }
        }
        Kind::Mul(factors) => {
            for i in 0..factors.len() {
                if factors.len() > 1 && !matches!(factors[i].kind, Kind::Ellipsis) {
                    let mut fewer = factors.clone();
                    fewer.remove(i);
                    list.push((3, Expr::product(fewer)));
                }
            }
            // The order of matrices
            let capital =
                |factor: &Expr| bases(factor).iter().any(|name| name.starts_with(char::is_uppercase));
            for i in 1..factors.len() {
                if capital(&factors[i - 1]) && capital(&factors[i]) {
                    let mut swapped = factors.clone();
                    swapped.swap(i - 1, i);
                    list.push((3, Expr::product(swapped)));
                }
            }
            // 2n + 1 for 2n
            if !in_index && bases(node).iter().any(|name| pool.integers.contains(name)) {
                list.push((5, node.clone().plus(1).grouped()));
            }
        }
        Kind::Div(a, b, style) => {
            list.push((4, a.as_ref().clone()));
            list.push((4, new(Kind::Div(b.clone(), a.clone(), *style))));
        }
        Kind::Binomial(n, k, style) => {
            list.push((3, new(Kind::Binomial(k.clone(), n.clone(), *style))));
        }
        Kind::Pow(base, exponent) => {
            if !in_index {
                list.push((2, base.as_ref().clone()));
            }
            // n(n − 1) for n²
            if let (Kind::Name(name), Kind::Number(q)) = (&base.kind, &exponent.kind)
                && pool.integers.contains(name)
                && *q == integer(2)
            {
                let factors = vec![base.as_ref().clone(), base.as_ref().clone().plus(-1).grouped()];
                list.push((3, Expr::product(factors)));
            }
            if let Kind::Number(q) = &exponent.kind
                && q == &Rational::zero()
            {
                list.push((1, base.as_ref().clone()));
            }
        }
        Kind::Apply(callee, groups) if groups.len() == 1 => {
            for i in 1..groups[0].len() {
                let mut swapped = groups[0].clone();
                swapped.swap(i - 1, i);
                list.push((3, new(Kind::Apply(callee.clone(), vec![swapped]))));
            }
        }
        Kind::Tuple(items) | Kind::List(items) => {
            for i in 1..items.len() {
                let mut swapped = items.clone();
                swapped.swap(i - 1, i);
                let tuple = matches!(node.kind, Kind::Tuple(_));
                list.push((2, new(if tuple { Kind::Tuple(swapped) } else { Kind::List(swapped) })));
            }
        }
        Kind::Matrix(rows, delimiter) => {
            list.push((2, new(Kind::Matrix(transposed(rows), *delimiter))));
        }
        Kind::Group(_) => {
            for name in &pool.integers {
                list.push((5, node.clone().power(Expr::name(name))));
            }
        }
        _ => {}
    }
    // A power that was lost.
    if !in_index && matches!(node.kind, Kind::Name(_) | Kind::Subscript(..) | Kind::Group(_)) {
        list.push((4, node.clone().power(Expr::int(2))));
    }
    list
}

/// Rows for columns.
fn transposed(rows: &[Vec<Option<Expr>>]) -> Vec<Vec<Option<Expr>>> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    (0..columns).map(|j| rows.iter().map(|row| row.get(j).cloned().flatten()).collect()).collect()
}

fn with_span(mut expr: Expr, like: &Expr) -> Expr {
    expr.span = like.span;
    expr
}

/// What is called for a node: the node, whether it stands in an index, and a function that gives the
/// whole formula with the node replaced.
pub(super) type Visit<'a> = &'a mut dyn FnMut(&Expr, bool, &dyn Fn(Expr) -> Expr);

/// Calls `visit` for every node with a function that gives the whole formula with the node replaced.
pub(super) fn at_every_node(expr: &Expr, in_index: bool, visit: Visit<'_>) {
    let mut path = Vec::new();
    descend(expr, expr, in_index, &mut path, visit);
}

fn descend(whole: &Expr, node: &Expr, in_index: bool, path: &mut Vec<usize>, visit: Visit<'_>) {
    if node.kind == Kind::Ellipsis {
        return;
    }
    let here = path.clone();
    visit(node, in_index, &|replacement| {
        let mut copy = whole.clone();
        put(&mut copy, &here, replacement);
        copy
    });
    let mut children = Vec::new();
    node.for_each_child(&mut |child| children.push(child));
    // What is repeated is one thing: only how often may be wrong.
    let repeated = match &node.kind {
        Kind::Brace(list, Some(_)) if list.len() > 1 => list.len(),
        _ => 0,
    };
    for (i, child) in children.into_iter().enumerate().skip(repeated) {
        let index = match &node.kind {
            // i − 1 is edited as a whole
            Kind::Subscript(..) | Kind::Upper(..) | Kind::Pow(..) => i > 0 || in_index,
            Kind::Binomial(..) | Kind::Factorial(_) => true,
            Kind::Big { lower, upper, .. } => i < lower.len() + usize::from(upper.is_some()),
            _ => in_index,
        };
        // k ≠ i: what is left out is no slip of an index.
        if matches!((&node.kind, &child.kind), (Kind::Big { .. }, Kind::Chain(_, links)) if links[0].rel == Rel::Ne)
        {
            continue;
        }
        path.push(i);
        descend(whole, child, index, path, visit);
        path.pop();
    }
}

fn put(expr: &mut Expr, path: &[usize], replacement: Expr) {
    let Some((first, rest)) = path.split_first() else {
        *expr = replacement;
        return;
    };
    let mut at = 0;
    let mut replacement = Some(replacement);
    expr.for_each_child_mut(&mut |child| {
        if at == *first
            && let Some(replacement) = replacement.take()
        {
            put(child, rest, replacement);
        }
        at += 1;
    });
}
