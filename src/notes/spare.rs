//! Numbers that a sentence gives and nothing takes: "scaled by 2", "if the interval has the length 2".
//!
//! **Rule.** What a sentence claims after a number or a list of numbers that no phrase took, and that the claim does not
//! speak of, may be said of other data than those before.

use std::collections::HashMap;

use super::sentence::Piece;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, interval};
use crate::judge::page::object::Object;
use crate::judge::page::statement::{Said, Statement};
use crate::judge::written::names::bases;

/// Marks what stands after such numbers.
///
/// Cost: linear in the statements, times the numbers of a sentence.
pub(super) fn mark(sentences: &[Vec<Piece>], statements: &mut [Statement]) {
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
    // 0, 1, 3 are three statements in one formula.
    let mut in_formula: HashMap<usize, usize> = HashMap::new();
    for statement in statements.iter().filter(|own| matches!(own.said, Said::Bare(..))) {
        *in_formula.entry(statement.place.formula).or_default() += 1;
    }
    let mut spare: Vec<(usize, Expr)> = Vec::new();
    // The numbers that stood alone or in lists so far.
    let mut told: Vec<Expr> = Vec::new();
    let mut current = None;
    for statement in statements {
        let sentence = sentence_of.get(statement.place.formula.wrapping_sub(1)).copied();
        if sentence != current {
            (current, spare) = (sentence, Vec::new());
        }
        match &statement.said {
            Said::Bare(side, _) if is_datum(&side.expr) => {
                let own = side.expr.span;
                let taken = taken.iter().any(|span| own.start <= span.start && span.end <= own.end);
                // "the whole interval [0, 3]", where the nodes are 0, 1, 3
                let known = |number: &Expr| told.iter().any(|other| other.same_as(number));
                let numbers = items(&side.expr);
                let several = numbers.len() > 1 || in_formula[&statement.place.formula] > 1;
                if !(taken || several && numbers.iter().all(|number| known(number))) {
                    spare.push((statement.place.formula, side.expr.clone()));
                }
                if several {
                    told.extend(numbers.into_iter().cloned());
                }
            }
            Said::Chain(chain) => {
                let whole = chain.whole();
                let unspoken = spare.iter().rev().find(|(_, datum)| !speaks_of(&whole, datum));
                statement.place.spare = unspoken.map_or(0, |(formula, _)| *formula);
                told.extend(chain.sides.iter().flat_map(|side| items(&side.expr)).cloned());
            }
            _ => {}
        }
    }
}

/// The numbers of a list or an interval; anything else itself.
fn items(expr: &Expr) -> Vec<&Expr> {
    match (interval(expr), expr.items()) {
        (Some((ends, _)), _) => ends.to_vec(),
        (None, Some(items)) => items.iter().collect(),
        (None, None) => vec![expr],
    }
}

/// Whether a formula has a datum as a part; a whole number as an argument or an item, b(2), not as a factor, 2b_1.
fn speaks_of(whole: &Expr, datum: &Expr) -> bool {
    // f(0, 0, 1) over [0, 1]
    if let Some((ends, _)) = interval(datum) {
        return whole.has(&|part| {
            let Kind::Apply(_, groups) = &part.kind else { return false };
            let mut arguments = groups.iter().flatten();
            groups.iter().flatten().count() > 1
                && arguments.all(|own| ends.iter().any(|end| own.same_as(end)))
        });
    }
    let counts = datum.as_int().is_some();
    whole.has(&|part| {
        let calculates = matches!(
            part.kind,
            Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..) | Kind::Div(..) | Kind::Chain(..)
        );
        let mut found = false;
        part.for_each_child(&mut |child| found |= child.same_as(datum) && !(counts && calculates));
        found
    })
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
