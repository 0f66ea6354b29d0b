//! Functions that are written by some of their own values: x(u, v) = (1 - v) x(u, 0) + v x(u, 1).
//!
//! **Rule.** Where its variables have the numbers of such a value, the right side has to be that value, whatever function
//! it is. What takes other values there is no formula for it.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::free::Free;
use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::known::unfold;
use crate::judge::model::{Choices, Model};
use crate::judge::page::context::{Body, Context, Mark};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::written::names::{Head, walk};
use crate::language::write;

/// So deep formulas are put for functions.
const UNFOLDINGS: usize = 4;

impl Checker {
    /// Refutes a formula for a function that has not the values of it that stand in the formula.
    pub(in crate::judge) fn by_own_values(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let ([left, right], [(Rel::Eq, _)], [finding]) =
            (chain.sides.as_slice(), chain.relations.as_slice(), &mut *findings)
        else {
            return;
        };
        let said = matches!(statement.role, None | Some(Role::Claimed)) && !chain.blocked;
        if finding.verdict != Verdict::Definition
            || !said
            || !chain.conditions.is_empty()
            || right.is_unread()
        {
            return;
        }
        let limits = self.limits.clone();
        let found =
            budget::run(&limits, || self.other_value(&left.expr, &right.expr, &statement.place, before));
        let Ok(Some((value, witness))) = found else { return };
        Rc::make_mut(&mut self.context).forget(before);
        *finding = Finding {
            verdict: Verdict::Refuted,
            reason: Some(format!("it does not have the value {value}")),
            witness: Some(witness),
            suggestion: None,
            evidence: vec![Evidence::Expansion],
            ..finding.clone()
        };
    }

    /// A value in a formula that the formula does not have, with what it has there.
    fn other_value(
        &self,
        left: &Expr,
        right: &Expr,
        place: &Place,
        before: Mark,
    ) -> Option<(String, String)> {
        let head = Head::of(left).filter(|head| head.lower.is_empty() && head.upper.is_empty())?;
        let variables: Vec<String> =
            head.flat().iter().map(|argument| name(argument)).collect::<Option<_>>()?;
        let different: BTreeSet<&String> = variables.iter().collect();
        // Values that the page gives may say more.
        let known =
            self.context.visible(&head.base, place).any(|(number, _, _)| number < before.definitions());
        let own = |side: &Expr| Head::of(side).is_some_and(|own| own.base == head.base);
        let facts = self.context.conditions.iter().any(|fact| match &fact.expr.kind {
            Kind::Chain(left, links) => own(left) || links.iter().any(|link| own(&link.expr)),
            _ => false,
        });
        if variables.is_empty() || different.len() < variables.len() || known || facts {
            return None;
        }
        let whole = self.with_functions(right, &head.base, place, UNFOLDINGS);
        let mut values: Vec<Expr> = Vec::new();
        let mut other = false;
        walk(&whole, &mut |part| match &part.kind {
            Kind::Apply(..) => {
                let Some(own) = Head::of(part).filter(|own| own.base == head.base) else { return };
                let arguments = own.flat();
                let fits = arguments.len() == variables.len()
                    && arguments.iter().zip(&variables).all(|(argument, variable)| {
                        name(argument).as_ref() == Some(variable) || argument.as_number().is_some()
                    })
                    && arguments.iter().any(|argument| argument.as_number().is_some());
                other |= !fits;
                if fits && !values.iter().any(|known| known.same_as(part)) {
                    values.push(part.clone());
                }
            }
            // x', Σ_x, ∫ … dx
            Kind::Prime(..) | Kind::Derivative { .. } | Kind::Integral { .. } | Kind::Ellipsis => {
                other = true
            }
            _ => {}
        });
        if other || values.len() < 2 {
            return None;
        }
        let free = Rc::new(Free {
            model: Model::new(
                Rc::new(Context::new(self.context.letters.clone())),
                place.clone(),
                Choices::default(),
                None,
            ),
            functions: Rc::new(BTreeMap::from([(head.base.clone(), None)])),
            raised: Rc::default(),
            world: None,
        });
        values.iter().find_map(|value| {
            let arguments = Head::of(value)?.flat().into_iter().cloned().collect::<Vec<_>>();
            let by: Vec<(String, Expr)> = variables.iter().cloned().zip(arguments).collect();
            let mut there = whole.clone();
            unfold::put(&mut there, &by);
            let (own, has) = (free.value(value, &[])?, free.value(&there, &[])?);
            (own != has).then(|| {
                let numbers = by.iter().filter(|(_, at)| at.as_number().is_some());
                let at: Vec<String> =
                    numbers.map(|(name, at)| format!("{name} = {}", write::text(at))).collect();
                let there = format!(
                    "{}: left {}, right {}",
                    at.join(", "),
                    write::text(value),
                    plain(&has.to_string())
                );
                (write::text(value), there)
            })
        })
    }

    /// A formula with what the page says of its functions, other than one.
    fn with_functions(&self, expr: &Expr, except: &str, place: &Place, depth: usize) -> Expr {
        let mut result = expr.clone();
        result.for_each_child_mut(&mut |child| *child = self.with_functions(child, except, place, depth));
        let call = matches!(result.kind, Kind::Apply(..));
        let Some(head) = Head::of(&result).filter(|head| head.base != except && call && depth > 0) else {
            return result;
        };
        let body = self.unfolded(&result, place, Choices::default()).or_else(|| {
            // r(u, v), where the page says what r is
            let variables = head.flat().iter().all(|argument| name(argument).is_some());
            let same = |own: &Head| {
                let indices = own.lower.len() == head.lower.len()
                    && own.lower.iter().zip(&head.lower).all(|(one, other)| one.same_as(other));
                let alike = own.arguments.is_none()
                    || own.flat().len() == head.flat().len()
                        && own.flat().iter().zip(head.flat()).all(|(one, other)| one.same_as(other));
                alike && own.upper.is_empty() && indices
            };
            let mut near = self.context.visible(&head.base, place);
            let found = near.find(|(_, own, near)| *near && same(&own.head))?.1;
            match &found.body {
                Body::Formula(body) if variables => Some(body.clone().grouped()),
                _ => None,
            }
        });
        // r_{cd}(u, v) = …, with an index that is none
        let body = body.or_else(|| {
            let Kind::Apply(callee, _) = &result.kind else { return None };
            let variables = head.flat().iter().all(|argument| name(argument).is_some());
            let said =
                self.context.conditions.iter().filter(|fact| variables && place.knows(&fact.place, false));
            let mut values = said.filter_map(|fact| match &fact.expr.kind {
                Kind::Chain(left, links) if left.same_as(&result) || left.same_as(callee) => {
                    match links.as_slice() {
                        [link] if link.rel == Rel::Eq => Some(link.expr.clone().grouped()),
                        _ => None,
                    }
                }
                _ => None,
            });
            values.next()
        });
        match body {
            Some(body) => self.with_functions(&body, except, place, depth - 1),
            None => result,
        }
    }
}

fn name(expr: &Expr) -> Option<String> {
    match &expr.kind {
        Kind::Name(name) => Some(name.clone()),
        _ => None,
    }
}

/// x(u;0) as it is written: x(u, 0).
fn plain(value: &str) -> String {
    value.replace(';', ", ")
}
