//! Slips in which two things changed places, or one was written for another of its kind: weights, arguments,
//! how often a value stands, the ends of an interval in a denominator.

use super::edits::at_every_node;
use crate::formula::{Expr, Kind, Sign, Term};
use crate::judge::written::names::{is_index_letter, own_names, walk};

/// So many arguments of other calls are tried in the place of one.
const MAX_ARGUMENTS: usize = 6;

/// The edits with a cost each.
pub(super) fn exchanges(expr: &Expr, other: &Expr) -> Vec<(u32, Expr)> {
    let calls = calls([expr, other]);
    let bound = bound_names(expr);
    let mut found = Vec::new();
    at_every_node(expr, false, &mut |node, in_index, rebuild| {
        let new = |kind: Kind| Expr::new(kind, node.span);
        let mut edits: Vec<(u32, Expr)> = Vec::new();
        match &node.kind {
            Kind::Add(terms) if !in_index => {
                edits.extend(weights(terms).map(|terms| (1, new(Kind::Add(terms)))))
            }
            Kind::Div(above, below, style) if !in_index => {
                // t_{i+k} − t_{i+1} for t_{i+k−1} − t_i
                for by in [1, -1] {
                    let mut moved = below.as_ref().clone();
                    if move_indices(&mut moved, by) > 1 {
                        edits.push((2, new(Kind::Div(above.clone(), Box::new(moved), *style))));
                    }
                }
            }
            Kind::Mul(factors) if !in_index => {
                if let [number, name, ..] = factors.as_slice()
                    && matches!((&number.kind, &name.kind), (Kind::Number(_), Kind::Name(name)) if is_index_letter(name))
                {
                    // (2n + 1) c for 2n c
                    for by in [1, -1] {
                        let double = Expr::product(vec![number.clone(), name.clone()]).plus(by).grouped();
                        let rest = factors[2..].iter().cloned();
                        edits.push((4, Expr::product(std::iter::once(double).chain(rest).collect())));
                    }
                }
            }
            Kind::Apply(callee, groups) if groups.len() == 1 => {
                let mut put = |cost: u32, at: usize, by: Expr| {
                    let mut items = groups[0].clone();
                    items[at] = by;
                    edits.push((cost, new(Kind::Apply(callee.clone(), vec![items]))));
                };
                for (at, item) in groups[0].iter().enumerate().filter(|(_, item)| is_simple(item)) {
                    let used = calls.iter().filter(|(name, _)| name.same_as(callee)).map(|(_, used)| used);
                    for argument in used.filter(|argument| !argument.same_as(item)).take(MAX_ARGUMENTS) {
                        put(3, at, argument.clone());
                    }
                }
                let counts = counts(&groups[0]);
                edits.extend(counts.map(|items| (2, new(Kind::Apply(callee.clone(), vec![items])))));
            }
            // b_{i+j} for b_j
            Kind::Name(name) if in_index && bound.contains(name) => {
                for other in bound.iter().filter(|other| *other != name) {
                    let terms = [Expr::name(other), node.clone()];
                    let terms = terms.map(|expr| Term { sign: Sign::Plus, expr });
                    edits.push((4, new(Kind::Add(terms.into()))));
                }
            }
            _ => {}
        }
        found.extend(edits.into_iter().map(|(cost, edit)| (cost, rebuild(edit))));
    });
    found
}

/// The callees of a formula, each with an argument that stands alone.
fn calls(sides: [&Expr; 2]) -> Vec<(Expr, Expr)> {
    let mut calls: Vec<(Expr, Expr)> = Vec::new();
    for side in sides {
        walk(side, &mut |part| {
            let Kind::Apply(callee, groups) = &part.kind else { return };
            for argument in groups.iter().flatten() {
                let known = |(name, used): &(Expr, Expr)| name.same_as(callee) && used.same_as(argument);
                if is_simple(argument) && !calls.iter().any(known) {
                    calls.push((callee.as_ref().clone(), argument.clone()));
                }
            }
        });
    }
    calls
}

fn is_simple(argument: &Expr) -> bool {
    matches!(argument.kind, Kind::Name(_) | Kind::Number(_) | Kind::Subscript(..))
}

/// The indices of sums and products.
fn bound_names(expr: &Expr) -> Vec<String> {
    let mut names = Vec::new();
    walk(expr, &mut |part| {
        if let Kind::Big { lower, .. } = &part.kind {
            names.extend(own_names(lower));
        }
    });
    names
}

/// The sum with the last factors of two products exchanged: the weights of two points.
fn weights(terms: &[Term]) -> impl Iterator<Item = Vec<Term>> {
    let pairs = (0..terms.len()).flat_map(move |i| (i + 1..terms.len()).map(move |j| (i, j)));
    pairs.filter_map(|(i, j)| {
        let (Kind::Mul(first), Kind::Mul(second)) = (&terms[i].expr.kind, &terms[j].expr.kind) else {
            return None;
        };
        let (mut first, mut second) = (first.clone(), second.clone());
        std::mem::swap(first.last_mut()?, second.last_mut()?);
        let mut changed = terms.to_vec();
        changed[i].expr = Expr::product(first);
        changed[j].expr = Expr::product(second);
        Some(changed)
    })
}

/// The arguments with other numbers at two neighbouring braces: exchanged, or one more here and one less there.
fn counts(items: &[Expr]) -> impl Iterator<Item = Vec<Expr>> {
    let label = |item: &Expr| match &item.kind {
        Kind::Brace(_, Some(label)) => Some(label.as_ref().clone()),
        _ => None,
    };
    let pairs = (1..items.len()).filter_map(move |at| Some((at, label(&items[at - 1])?, label(&items[at])?)));
    pairs.flat_map(|(at, first, second)| {
        let one = |label: &Expr, by: i64| by_one(label, by);
        let labels = [
            (second.clone(), first.clone()),
            (one(&first, 1), one(&second, -1)),
            (one(&first, -1), one(&second, 1)),
        ];
        labels.map(|(first, second)| {
            let mut items = items.to_vec();
            for (at, new) in [(at - 1, first), (at, second)] {
                if let Kind::Brace(_, label) = &mut items[at].kind {
                    *label = Some(Box::new(new));
                }
            }
            items
        })
    })
}

/// n + 1 for n, and n for n − 1.
fn by_one(number: &Expr, by: i64) -> Expr {
    if let Kind::Add(terms) = &number.kind
        && let Some((last, rest)) = terms.split_last()
        && last.expr.as_int() == Some(1)
        && (last.sign == Sign::Plus) == (by < 0)
    {
        return Expr::sum(rest.to_vec());
    }
    match &number.kind {
        Kind::Add(terms) => {
            let sign = if by < 0 { Sign::Minus } else { Sign::Plus };
            Expr::sum(terms.iter().cloned().chain([Term { sign, expr: Expr::int(1) }]).collect())
        }
        _ => number.clone().plus(by),
    }
}

/// Moves every index of a formula; says how many there are.
fn move_indices(expr: &mut Expr, by: i64) -> usize {
    if let Kind::Subscript(_, indices) = &mut expr.kind {
        return match indices.as_mut_slice() {
            [index] => {
                *index = by_one(index, by);
                1
            }
            _ => 0,
        };
    }
    let mut count = 0;
    expr.for_each_child_mut(&mut |child| count += move_indices(child, by));
    count
}
