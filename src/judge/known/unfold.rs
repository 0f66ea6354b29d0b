//! Definitions put into formulas, for proofs: P(t) becomes its right-hand side.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind};
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::judge::page::context::Body;
use crate::judge::page::statement::Place;
use crate::judge::written::names::{Head, bases, is_index_letter, own_names, walk};
use crate::language::lexicon::families::{self, FORWARD_DIFFERENCE, Family};

impl Checker {
    /// What a name or call stands for by the definitions seen from a place, with its indices and
    /// arguments put in; `None` if that is not certain.
    pub(in crate::judge) fn unfolded(&self, expr: &Expr, place: &Place, choices: Choices) -> Option<Expr> {
        let head = Head::of(expr)?;
        if head.is_a(Family::Bernstein) && head.upper.is_empty() && head.arguments.is_some() {
            // B_{i,n}, or B_{n,i}
            let first = self.context.letters.degree_first().unwrap_or(choices.degree_first);
            let (i, n) = if first { (1, 0) } else { (0, 1) };
            let Kind::Apply(callee, groups) = &expr.kind else { return None };
            let base = Box::new(Expr::name(head.base.clone()));
            let lower = Expr::new(Kind::Subscript(base, vec![head.lower[i].clone()]), callee.span);
            let family = Expr::new(Kind::Pow(Box::new(lower), Box::new(head.lower[n].clone())), callee.span);
            return Some(Expr::new(Kind::Apply(Box::new(family), groups.clone()), expr.span));
        }
        if families::has_values(&head.base) || head.base == FORWARD_DIFFERENCE {
            return None;
        }
        let (_, definition, near) = self.context.visible(&head.base, place).next()?;
        let own = &definition.head;
        let shapes = own.lower.len() == head.lower.len()
            && own.upper.len() == head.upper.len()
            && own.arguments.is_some() == head.arguments.is_some()
            && own.flat().len() == head.flat().len();
        let Body::Formula(body) = &definition.body else { return None };
        if !near || !shapes || !definition.conditions.is_empty() {
            return None;
        }
        let patterns = own.lower.iter().chain(&own.upper).chain(own.flat());
        let values = head.lower.iter().chain(&head.upper).chain(head.flat());
        let mut by: Vec<(String, Expr)> = Vec::new();
        for (at, (pattern, value)) in patterns.zip(values).enumerate() {
            let index = at < own.lower.len() + own.upper.len();
            match &pattern.kind {
                Kind::Name(name) if !index || is_index_letter(name) => by.push((name.clone(), value.clone())),
                _ if pattern.same_as(value) => {}
                _ => return None,
            }
        }
        // Names of the arguments must not be caught by sums of the body, nor dots be stretched.
        let free: BTreeSet<String> = by.iter().flat_map(|(_, value)| bases(value)).collect();
        let mut safe = true;
        walk(body, &mut |part| match &part.kind {
            Kind::Big { lower, .. } => {
                let own = own_names(lower);
                safe = safe
                    && !own
                        .iter()
                        .any(|name| free.contains(name) || by.iter().any(|(known, _)| known == name));
            }
            Kind::Ellipsis | Kind::Derivative { .. } | Kind::Integral { .. } | Kind::Unread(_) => {
                safe = false
            }
            _ => {}
        });
        safe.then(|| {
            let mut result = body.clone();
            put(&mut result, &by);
            result.grouped()
        })
    }
}

/// Puts expressions for names.
pub(in crate::judge) fn put(expr: &mut Expr, by: &[(String, Expr)]) {
    if let Kind::Name(name) = &expr.kind {
        if let Some((_, value)) = by.iter().find(|(known, _)| known == name) {
            *expr = match value.kind {
                Kind::Name(_) | Kind::Number(_) | Kind::Accent(..) => value.clone(),
                _ => value.clone().grouped(),
            };
        }
        return;
    }
    expr.for_each_child_mut(&mut |child| put(child, by));
}
