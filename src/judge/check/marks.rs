//! What is written in other ways than it is meant: a new thing with the letter of an old one and a prime, S' in the place
//! of S; κ_+ beside κ_-, no positive part; χ of an interval.
//!
//! **Rule.** S' = … names a new thing if nothing on the page is a function S, or says what S is.

use crate::formula::{Expr, Kind, Link, Rel, interval};
use crate::judge::known::checker::Checker;
use crate::judge::page::statement::{Chain, Place};

/// B_{j,1} = χ_{[t_j, t_{j+1})} as a formula with cases: 1 for t_j ≤ x < t_{j+1}, otherwise 0.
pub(in crate::judge) fn with_characteristic_function(chain: &Chain) -> Option<Chain> {
    let ([left, right], [(Rel::Eq | Rel::Define, _)]) = (chain.sides.as_slice(), chain.relations.as_slice())
    else {
        return None;
    };
    let (function, at) = match &right.expr.kind {
        Kind::Apply(function, groups) => (function.as_ref(), groups.concat()),
        _ => (&right.expr, Vec::new()),
    };
    let Kind::Subscript(letter, index) = &function.kind else { return None };
    let ([index], Kind::Name(name)) = (index.as_slice(), &letter.kind) else { return None };
    let ([from, to], [above, below]) = interval(index).filter(|_| name == "chi")?;
    let called = matches!(left.expr.kind, Kind::Apply(..));
    let variable = match at.as_slice() {
        [] if !called => Expr::name("x"),
        [one] if called => one.clone(),
        _ => return None,
    };
    let sign = |open: bool| if open { Rel::Lt } else { Rel::Le };
    let link = |rel: Rel, expr: &Expr| Link { rel, span: index.span, expr: expr.clone() };
    let within =
        Kind::Chain(Box::new(from.clone()), vec![link(sign(above), &variable), link(sign(below), to)]);
    let cases = vec![(Expr::int(1), Some(Expr::new(within, index.span))), (Expr::int(0), None)];
    let mut changed = chain.clone();
    changed.sides[1].expr = Expr::new(Kind::Cases(cases), right.expr.span);
    if !called {
        let call = Kind::Apply(Box::new(left.expr.clone()), vec![vec![variable]]);
        changed.sides[0].expr = Expr::new(call, left.expr.span);
    }
    Some(changed)
}

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
