//! Numbers that a sentence gives and nothing takes: "scaled by 2", "if the interval has the length 2".
//!
//! **Rule.** What a sentence claims after a number or a list of numbers that no phrase took, and that the claim does not
//! speak of, may be said of other data than those before.

use super::sentence::Piece;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, interval};
use crate::judge::page::object::Object;
use crate::judge::page::statement::{Said, Statement};
use crate::judge::written::names::bases;

/// Counts such numbers as changes of data.
///
/// Cost: linear in the statements, times the numbers of a sentence.
pub(super) fn count(sentences: &[Vec<Piece>], statements: &mut [Statement]) {
    let taken: Vec<Span> = statements
        .iter()
        .filter_map(|statement| match &statement.said {
            Said::Object(object) => Some(parts(object)),
            _ => None,
        })
        .flatten()
        .collect();
    let mut sentence_of = Vec::new();
    for (number, sentence) in sentences.iter().enumerate() {
        let formulas = sentence.iter().filter(|piece| matches!(piece, Piece::Formula(_)));
        sentence_of.extend(formulas.map(|_| number));
    }
    let mut spare: Vec<Expr> = Vec::new();
    let mut used: Vec<Expr> = Vec::new();
    let mut current = None;
    for statement in statements {
        let sentence = sentence_of.get(statement.place.formula.wrapping_sub(1)).copied();
        if sentence != current {
            (current, spare) = (sentence, Vec::new());
        }
        match &statement.said {
            Said::Bare(side, _) if is_datum(&side.expr) => {
                let own = side.expr.span;
                let known = |end: &Expr| used.iter().any(|list| list.has(&|part| part.same_as(end)));
                if taken.iter().any(|span| own.start <= span.start && span.end <= own.end) {
                    used.push(side.expr.clone());
                // "the whole interval [0, 3]", where the nodes are 0, 1, 3
                } else if !interval(&side.expr).is_some_and(|(ends, _)| ends.into_iter().all(known)) {
                    spare.push(side.expr.clone());
                }
            }
            Said::Chain(chain) => {
                let whole = chain.whole();
                // 2 in b(2), but not in 2b_1
                let called = |part: &Expr, datum: &Expr| match &part.kind {
                    Kind::Apply(_, groups) => groups.iter().flatten().any(|argument| argument.same_as(datum)),
                    _ => datum.as_int().is_none() && part.same_as(datum),
                };
                let spoken = |datum: &Expr| whole.has(&|part| called(part, datum));
                statement.place.changes += u32::from(!spare.iter().all(spoken));
            }
            _ => {}
        }
    }
}

/// Whether it is a number, a list of numbers or an interval.
fn is_datum(expr: &Expr) -> bool {
    let list = matches!(expr.kind, Kind::Tuple(_) | Kind::List(_) | Kind::Sequence(_) | Kind::Set(..));
    bases(expr).is_empty() && (expr.as_number().is_some() || list || interval(expr).is_some())
}

/// Where all that words say of an object stands.
fn parts(object: &Object) -> Vec<Span> {
    let Object { degree, knots, points, weights, values, interval, data, .. } = object;
    let ends = interval.iter().flat_map(|(from, to)| [from, to]);
    let pairs = data.iter().flat_map(|(x, y)| [x, y]);
    let all = degree.iter().chain(knots).chain(points).chain(weights).chain(values).chain(ends).chain(pairs);
    all.map(|expr| expr.span).filter(|span| span.end > span.start).collect()
}
