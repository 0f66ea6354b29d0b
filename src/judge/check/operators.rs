//! Operators of the page, in the ways in which they are written: B_n f(x), (B_n f)(x), B_n[f](x), B_n(f)(x), B_n(f; x).
//!
//! **Rule.** A formula with one of these on its left says what an operator is if its right side applies that function. From
//! then on all of them are read as (B_n f)(x), for whatever function.

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::model::applies;
use crate::judge::page::statement::Chain;
use crate::judge::written::names::{Head, bases, operated};
use crate::language::lexicon::roles::is_variable;

impl Checker {
    /// The chain with every operator of the page written in one way.
    pub(in crate::judge) fn with_operators(&mut self, chain: &Chain) -> Option<Chain> {
        if let ([left, right], [(Rel::Eq | Rel::Define, _)]) =
            (chain.sides.as_slice(), chain.relations.as_slice())
            && let Some((operator, function, _)) = applied(&left.expr, &|_| true)
            && let (Some(operator), Some(function)) = (Head::of(&operator), Head::of(&function))
            && applies(&right.expr, &function.base)
            && !applies(&right.expr, &operator.base)
        {
            self.operators.insert(operator.base);
        }
        if self.operators.is_empty() {
            return None;
        }
        let known = |letter: &str| self.operators.contains(letter);
        let mut changed = chain.clone();
        changed.sides.iter_mut().for_each(|side| rewrite(&mut side.expr, &known));
        // B_n e_1 = x: equal as functions of x
        let other = |name: &String| known(name) || self.context.letters.is_function(name);
        let mut names = changed.sides.iter().flat_map(|side| bases(&side.expr));
        let variable = names.find(|name| is_variable(name) && !other(name));
        let variable = Expr::name(variable.unwrap_or_else(|| "x".to_owned()));
        let is_function = |part: &Expr| {
            Head::of(part).is_some_and(|head| {
                head.arguments.is_none() && !known(&head.base) && self.context.letters.is_function(&head.base)
            })
        };
        for side in &mut changed.sides {
            let Kind::Mul(factors) = &side.expr.kind else { continue };
            if let [operator, function] = factors.as_slice()
                && is_operator(operator, &known)
                && is_function(function)
            {
                side.expr = canonical((operator.clone(), function.clone(), variable.clone()), &side.expr);
            }
        }
        Some(changed)
    }
}

/// B_n
fn is_operator(expr: &Expr, known: &dyn Fn(&str) -> bool) -> bool {
    Head::of(expr).is_some_and(|head| {
        head.lower.len() == 1 && head.upper.is_empty() && head.arguments.is_none() && known(&head.base)
    })
}

fn rewrite(expr: &mut Expr, known: &dyn Fn(&str) -> bool) {
    if let Some(whole) = applied(expr, known) {
        *expr = canonical(whole, expr);
    }
    if let Kind::Mul(factors) = &mut expr.kind {
        let mut at = 0;
        while at + 1 < factors.len() {
            let found = [3, 2].into_iter().filter(|length| at + length <= factors.len()).find_map(|length| {
                let span = factors[at].span.to(factors[at + length - 1].span);
                let part = Expr::new(Kind::Mul(factors[at..at + length].to_vec()), span);
                Some((length, canonical(applied(&part, known)?, &part)))
            });
            if let Some((length, whole)) = found {
                factors.splice(at..at + length, [whole]);
            }
            at += 1;
        }
    }
    expr.for_each_child_mut(&mut |child| rewrite(child, known));
}

/// (B_n f)(x)
fn canonical((operator, function, argument): (Expr, Expr, Expr), whole: &Expr) -> Expr {
    let span = operator.span.to(function.span);
    let product = Expr::new(Kind::Mul(vec![operator, function]), span);
    let group = Expr::new(Kind::Group(Box::new(product)), span);
    Expr::new(Kind::Apply(Box::new(group), vec![vec![argument]]), whole.span)
}

/// The operator, the function and the argument of a formula in one of the ways.
fn applied(expr: &Expr, known: &dyn Fn(&str) -> bool) -> Option<(Expr, Expr, Expr)> {
    let operator = |expr: &Expr| is_operator(expr, known);
    // B_n(t, x) is the operator at the function t.
    let function = |expr: &Expr| match &expr.kind {
        Kind::Name(name) if name.chars().count() == 1 && !is_variable(name) => Some(expr.clone()),
        _ => None,
    };
    let product = |expr: &Expr| {
        let Kind::Group(inner) = &expr.kind else { return None };
        let (_, of) = operated(inner).filter(|(head, _)| known(&head.base))?;
        let Kind::Mul(factors) = &inner.kind else { return None };
        Some((factors[0].clone(), function(of)?))
    };
    let call = |expr: &Expr| {
        let Kind::Apply(callee, groups) = &expr.kind else { return None };
        match groups.iter().flatten().collect::<Vec<_>>().as_slice() {
            [of] if operator(callee) => Some((callee.as_ref().clone(), function(of)?)),
            _ => None,
        }
    };
    match &expr.kind {
        Kind::Apply(callee, groups) => {
            match groups.iter().map(Vec::as_slice).collect::<Vec<_>>().as_slice() {
                // B_n(f; x), B_n(f, x), B_n[f](x)
                [[of, at]] | [[of], [at]] if operator(callee) => {
                    Some((callee.as_ref().clone(), function(of)?, at.clone()))
                }
                [[at]] => {
                    let (first, of) = product(callee)?;
                    Some((first, of, at.clone()))
                }
                _ => None,
            }
        }
        Kind::Mul(factors) => match factors.as_slice() {
            // B_n f(x)
            [first, Expr { kind: Kind::Apply(callee, groups), .. }] if operator(first) => {
                match groups.as_slice() {
                    [group] if group.len() == 1 => Some((first.clone(), function(callee)?, group[0].clone())),
                    _ => None,
                }
            }
            // (B_n f)(1/2), B_n(f)(x)
            [first, Expr { kind: Kind::Group(at), .. }] => {
                let (operator, of) = product(first).or_else(|| call(first))?;
                Some((operator, of, at.as_ref().clone()))
            }
            // B_n[f](x)
            [first, Expr { kind: Kind::Group(of), .. }, Expr { kind: Kind::Group(at), .. }]
                if operator(first) =>
            {
                Some((first.clone(), function(of)?, at.as_ref().clone()))
            }
            _ => None,
        },
        _ => None,
    }
}
