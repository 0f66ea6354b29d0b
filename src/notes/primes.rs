//! Primes that mark names: the new points P'_{2i} beside the P_i.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind};
use crate::judge::page::statement::{Said, Statement};
use crate::judge::written::names::walk;

/// Reads a prime on a name with an index as a mark, if the page applies its letter to nothing: it is no derivative.
///
/// Cost: linear in the formulas.
pub(super) fn as_marks(statements: &mut [Statement]) {
    let mut applied = BTreeSet::new();
    for statement in statements.iter_mut() {
        each(statement, &mut |expr| {
            walk(expr, &mut |part| {
                // y_0'(t - 2t^2) may be a product.
                if let Kind::Apply(callee, groups) = &part.kind
                    && groups.iter().flatten().any(is_argument)
                {
                    applied.extend(letter(callee));
                }
            });
        });
    }
    for statement in statements {
        each(statement, &mut |expr| mark(expr, &applied));
    }
}

/// Whether it can be nothing but an argument, if it stands in brackets after a name.
fn is_argument(expr: &Expr) -> bool {
    !matches!(expr.kind, Kind::Add(_))
}

/// Works on every formula of a statement.
pub(super) fn each(statement: &mut Statement, work: &mut dyn FnMut(&mut Expr)) {
    match &mut statement.said {
        Said::Chain(chain) => {
            chain.sides.iter_mut().map(|side| &mut side.expr).chain(&mut chain.conditions).for_each(work);
        }
        Said::Condition(side) | Said::Bare(side, _) => work(&mut side.expr),
        Said::Object(_)
        | Said::Contact(_)
        | Said::Triangles(..)
        | Said::Declaration(..)
        | Said::Queries(..) => {}
    }
}

/// The letter of a name with indices, primes and accents.
fn letter(expr: &Expr) -> Option<String> {
    match &expr.kind {
        Kind::Name(name) => Some(name.clone()),
        Kind::Prime(inner, _)
        | Kind::Subscript(inner, _)
        | Kind::Upper(inner, _)
        | Kind::Accent(_, inner) => letter(inner),
        _ => None,
    }
}

fn mark(expr: &mut Expr, applied: &BTreeSet<String>) {
    expr.for_each_child_mut(&mut |child| mark(child, applied));
    let (name, lower, primes) = match &expr.kind {
        // P'_{2i}
        Kind::Subscript(base, lower) => match &base.kind {
            Kind::Prime(name, primes) => (name.as_ref(), lower, *primes),
            _ => return,
        },
        // P_{2i}'
        Kind::Prime(base, primes) => match &base.kind {
            Kind::Subscript(name, lower) => (name.as_ref(), lower, *primes),
            _ => return,
        },
        _ => return,
    };
    if letter(name).is_none_or(|letter| applied.contains(&letter)) {
        return;
    }
    let member = Expr::new(Kind::Subscript(Box::new(name.clone()), lower.clone()), expr.span);
    let sign = Expr::new(Kind::Text("'".repeat(primes as usize)), expr.span);
    expr.kind = Kind::Upper(Box::new(member), vec![sign]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{self, Container};
    use crate::formula::source::SourceFile;
    use crate::notes::statement::statements;

    fn marked(page: &str) -> bool {
        let document = document::document(SourceFile::new("page.md", page), Container::Markdown);
        statements(&document).iter().any(|statement| match &statement.said {
            Said::Chain(chain) => {
                chain.sides.iter().any(|side| side.expr.has(&|part| matches!(part.kind, Kind::Upper(..))))
            }
            _ => false,
        })
    }

    #[test]
    fn a_mark_is_no_derivative() {
        assert!(marked("The new points are $P'_{2i} = P_i$."));
        assert!(marked("The new points are $q_0' = p_0$."));
        assert!(!marked("With $s_i'(x_i) = m_i$ the slope is $s_i' = 0$."));
        assert!(!marked("For $p(t) = t^2$ we have $p' = 2t$."));
    }
}
