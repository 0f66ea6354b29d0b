//! How far a sum reaches: in Σ_i a_i − b_i the last term belongs to it, for its i has no other meaning.

use std::borrow::Cow;

use crate::formula::{Expr, Kind, Link, Rel, Sign, Term};
use crate::judge::page::statement::Chain;
use crate::judge::written::names::{has_free, own_names};

/// The chain with sums that reach as far as their indices are used. An index that is free on another side, or in a
/// condition, has a meaning outside of the sum.
pub(in crate::judge) fn whole_sums(chain: &Chain) -> Cow<'_, Chain> {
    let sum = |part: &Expr| matches!(part.kind, Kind::Big { .. });
    if !chain.sides.iter().any(|side| side.expr.has(&sum)) {
        return Cow::Borrowed(chain);
    }
    let mut whole = chain.clone();
    for at in 0..whole.sides.len() {
        let others = chain.sides.iter().enumerate().filter(|(other, _)| *other != at);
        let others: Vec<&Expr> = others.map(|(_, side)| &side.expr).chain(&chain.conditions).collect();
        let means_else = |name: &str| others.iter().any(|other| has_free(other, name));
        extend(&mut whole.sides[at].expr, &means_else);
        as_outer(&mut whole.sides[at].expr, &mut Vec::new());
    }
    Cow::Owned(whole)
}

fn extend(expr: &mut Expr, means_else: &dyn Fn(&str) -> bool) {
    expr.for_each_child_mut(&mut |child| extend(child, means_else));
    let Kind::Add(terms) = &mut expr.kind else { return };
    let reached = |at: usize, terms: &[Term]| -> Option<usize> {
        let Kind::Big { lower, .. } = &terms[at].expr.kind else { return None };
        let own = own_names(lower);
        let used = |term: &Term| own.iter().any(|name| !means_else(name) && has_free(&term.expr, name));
        (at + 1..terms.len()).rev().find(|later| used(&terms[*later]))
    };
    let Some((at, last)) = (0..terms.len()).find_map(|at| Some((at, reached(at, terms)?))) else { return };
    let more: Vec<Term> = terms.drain(at + 1..=last).collect();
    let span = terms[at].expr.span.to(more[more.len() - 1].expr.span);
    if let Kind::Big { body, .. } = &mut terms[at].expr.kind {
        let first = Term { sign: Sign::Plus, expr: (**body).clone() };
        let inside = body.span.to(span);
        **body = Expr::new(Kind::Add(std::iter::once(first).chain(more).collect()), inside);
    }
    terms[at].expr.span = span;
    if let ([only], Sign::Plus) = (terms.as_slice(), terms[0].sign) {
        *expr = only.expr.clone();
    }
}

/// Σ_{i=0}^n Π_{j ≠ i} …: j runs as far as i.
fn as_outer(expr: &mut Expr, around: &mut Vec<(String, Expr, Expr)>) {
    let mut own = None;
    if let Kind::Big { lower, upper, .. } = &mut expr.kind {
        match (lower.as_slice(), &upper) {
            ([Expr { kind: Kind::Chain(index, links), .. }], Some(to)) => {
                if let (Kind::Name(name), [Link { rel: Rel::Eq, expr: from, .. }]) =
                    (&index.kind, links.as_slice())
                {
                    own = Some((name.clone(), from.clone(), to.as_ref().clone()));
                }
            }
            ([Expr { kind: Kind::Chain(index, links), .. }], None) => {
                if let (
                    Kind::Name(_),
                    [Link { rel: Rel::Ne, expr: Expr { kind: Kind::Name(other), .. }, .. }],
                ) = (&index.kind, links.as_slice())
                    && let Some((_, from, to)) = around.iter().rev().find(|(name, ..)| name == other)
                {
                    let start = Expr::relation(index.as_ref().clone(), Rel::Eq, from.clone());
                    *upper = Some(Box::new(to.clone()));
                    lower.insert(0, start);
                }
            }
            _ => {}
        }
    }
    let depth = around.len();
    around.extend(own);
    expr.for_each_child_mut(&mut |child| as_outer(child, around));
    around.truncate(depth);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::Rel;
    use crate::formula::source::Span;
    use crate::judge::page::statement::Side;
    use crate::language::{latex, write};

    fn left(left: &str, right: &str) -> String {
        let side = |text: &str| Side { expr: latex::read(text).unwrap(), latex: text.to_owned() };
        let chain = Chain::new(vec![side(left), side(right)], vec![(Rel::Eq, Span::default())]);
        write::latex(&whole_sums(&chain).sides[0].expr)
    }

    #[test]
    fn a_sum_reaches_as_far_as_its_index() {
        let extended = left(r"\sum_{i=0}^n a_i - b_i + c", "d");
        assert_eq!(extended, left(r"\sum_{i=0}^n (a_i - b_i) + c", "d"));
        for (sum, right) in [
            (r"\sum_{i=0}^n a_i - b_i", "c_i"),
            (r"\sum_{i=0}^n a_i - \sum_{i=0}^n b_i", "c"),
            (r"\sum_{i=0}^n a_i - b", "c"),
        ] {
            assert_eq!(left(sum, right), write::latex(&latex::read(sum).unwrap()), "{sum}");
        }
    }
}
