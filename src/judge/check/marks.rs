//! New things with the letter of an old one and a prime: the vertex S' in the place of S; and κ_+ beside κ_-, no positive part.
//!
//! **Rule.** S' = … names a new thing if nothing on the page is a function S, or says what S is.

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::statement::{Chain, Place};

impl Checker {
    /// The chain with names S' in the place of derivatives of what is no function.
    pub(in crate::judge) fn with_marked_names(&mut self, chain: &Chain, place: &Place) -> Option<Chain> {
        if let (Some(left), Some((Rel::Eq | Rel::Define, _))) = (chain.sides.first(), chain.relations.first())
            && let Some(letter) = marked(&left.expr)
            && !self.context.letters.is_function(letter)
            && self.context.visible(letter, place).next().is_none()
            && self.context.object_called(letter, place).is_none()
            && !chain.sides[1]
                .expr
                .has(&|part| matches!(part.kind, Kind::Derivative { .. } | Kind::Prime(..)))
        {
            self.marked.insert(letter.to_owned());
        }
        if self.marked.is_empty() && !self.context.letters.has_signed() {
            return None;
        }
        let mut changed = chain.clone();
        changed.sides.iter_mut().for_each(|side| self.rename(&mut side.expr));
        Some(changed)
    }

    fn rename(&self, expr: &mut Expr) {
        if let Some(letter) = marked(expr).filter(|letter| self.marked.contains(*letter)) {
            expr.kind = Kind::Name(format!("{letter}'"));
        }
        // κ_+ beside κ_-
        if let Some(name) = positive_part(expr)
            && let Kind::Name(letter) = &name.kind
            && self.context.letters.is_signed(letter)
        {
            expr.kind = Kind::Subscript(Box::new(name.clone()), vec![Expr::name("plus")]);
            return;
        }
        expr.for_each_child_mut(&mut |child| self.rename(child));
    }
}

/// S of S'.
fn marked(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        Kind::Prime(inner, 1) => match &inner.kind {
            Kind::Name(letter) => Some(letter),
            _ => None,
        },
        _ => None,
    }
}

/// x of x_+, as it is read: x where x is not negative, else 0.
fn positive_part(expr: &Expr) -> Option<&Expr> {
    let Kind::Cases(cases) = &expr.kind else { return None };
    match cases.as_slice() {
        [(value, Some(condition)), (other, _)] if other.as_int() == Some(0) => match &condition.kind {
            Kind::Chain(left, _) if left.same_as(value) => Some(value),
            _ => None,
        },
        _ => None,
    }
}
