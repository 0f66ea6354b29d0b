//! The points of de Casteljau's scheme, one by one: b_0^1 = (1/2, 1), where the section gives the control points and the
//! parameter.
//!
//! **Definition.** b_i^r is the sum of B_j^r(t) b_(i+j) over j = 0, …, r; the page may number the levels above, also in
//! parentheses.
//!
//! **Rule.** A point that agrees with the scheme is right. One that differs is wrong if another one of the same
//! scheme agrees, and if it does not follow from the points of the level before, as the page has them.

use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::judge::instances::tally::Failure;
use crate::judge::known::checker::Checker;
use crate::judge::known::found::Scheme;
use crate::judge::page::context::{Body, is_variable};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::statement::{Chain, Place, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::counterexample;
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases};
use crate::math::basis::bernstein_all;
use crate::math::number::Rational;

/// So many numbers of a section are tried for the parameter.
const MAX_PARAMETERS: usize = 8;

impl Checker {
    /// Judges a point of a scheme.
    pub(in crate::judge) fn by_scheme(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
    ) {
        let place = &statement.place;
        let (left, right) = (&chain.sides[0], &chain.sides[1]);
        if !matches!(findings[0].verdict, Verdict::Definition | Verdict::Undecided)
            || !statement.topics.has(Topic::Casteljau)
            || statement.topics.has(Topic::Rational)
            || self.context.visible("w", place).next().is_some()
            || chain.relations[0].0 != Rel::Eq
            || left.is_unread()
            || right.is_unread()
        {
            return;
        }
        let Some((letter, i, level)) = member(&left.expr).filter(|(.., level)| *level > 0) else { return };
        let count = (0..).take_while(|&j| self.has_point(&letter, j, place)).count() as i64;
        if i + level >= count {
            return;
        }
        let scheme = |t: &Rational, level: i64, from: i64| {
            let weights = bernstein_all(level as usize, t);
            let points = (0..=level).map(|j| point(&letter, i + j, from, &left.expr));
            let terms = points.zip(weights).map(|(point, weight)| Term {
                sign: Sign::Plus,
                expr: Expr::product(vec![Expr::number(&weight), point]),
            });
            Expr::sum(terms.collect())
        };
        let differ = |value: &Expr| self.differ(value, &right.expr, chain, statement);
        let known = |scheme: &&Scheme| scheme.letter == letter && scheme.place.scope == place.scope;
        let mut run = self.schemes.iter().rev().find(known);
        let mut parameters = self.parameters_of_scheme(place);
        // "At t = 1/2 it gives …. At t = 1/4 it gives …": the first run is over.
        if let (Some((at, now)), Some(last)) = (parameters.first().cloned(), run)
            && at > last.place.formula
            && now != last.parameter
        {
            parameters.retain(|(_, t)| *t != last.parameter);
            run = None;
        }
        if let Some((_, t)) = parameters.into_iter().find(|(_, t)| differ(&scheme(t, level, 0)).is_none()) {
            findings[0] = Finding {
                verdict: Verdict::Proved,
                reason: Some(format!("de Casteljau's scheme at {t}")),
                warning: None,
                ..findings[0].clone()
            };
            self.schemes.push(Scheme { letter, parameter: t, place: place.clone() });
            return;
        }
        let Some(t) = run.map(|scheme| &scheme.parameter) else { return };
        let Some(Some(failure)) = differ(&scheme(t, level, 0)) else { return };
        // It goes on from a point that is wrong itself.
        if level > 1 && differ(&scheme(t, 1, level - 1)).is_none() {
            return;
        }
        findings[0] = Finding {
            verdict: Verdict::Refuted,
            reason: Some(format!("it differs from de Casteljau's scheme at {t}")),
            witness: counterexample::counterexample(&failure),
            suggestion: None,
            evidence: vec![Evidence::Names],
            ..findings[0].clone()
        };
    }

    /// How two sides differ: `None` if they are equal, `Some(None)` if that is open.
    fn differ(
        &self,
        left: &Expr,
        right: &Expr,
        chain: &Chain,
        statement: &Statement,
    ) -> Option<Option<Box<Failure>>> {
        let side = |expr: &Expr| Side { expr: expr.clone(), latex: String::new() };
        let own = Chain {
            sides: vec![side(left), side(right)],
            relations: vec![chain.relations[0]],
            ..chain.clone()
        };
        let setting = self.setting(&own, &statement.place, None).without_equations();
        let sides: Vec<&Expr> = own.sides.iter().map(|side| &side.expr).collect();
        let attempt = self.attempts(&setting, &sides, &[Rel::Eq]);
        let tally = &attempt.outcomes.tallies[0];
        if !tally.errors.is_empty() || !tally.unclear.is_empty() {
            return Some(None);
        }
        match tally.fails.first() {
            Some(failure) => Some(Some(Box::new(failure.clone()))),
            None if tally.holds > 0 => None,
            None => Some(None),
        }
    }

    /// The numbers that the section says the parameter is, the last one first, each with the number of its formula: t = 1/4.
    pub(in crate::judge) fn parameters_of_scheme(&self, place: &Place) -> Vec<(usize, Rational)> {
        let number = |expr: &Expr| match &expr.kind {
            Kind::Chain(left, links) => {
                let named = matches!(&left.kind, Kind::Name(name) if is_variable(name) || name == "lambda");
                let value =
                    links.last().filter(|link| link.rel == Rel::Eq && bases(&link.expr).is_empty())?;
                named.then(|| evaluator::machine().eval(&value.expr).ok()?.as_rational()).flatten()
            }
            _ => None,
        };
        let said = self.context.conditions.iter().rev();
        let said = said.filter(|condition| place.sees(&condition.place)).map(|c| (c.place.formula, &c.expr));
        let heard = self.context.heard.iter().rev();
        let heard =
            heard.filter(|(other, _)| place.sees(other)).map(|(other, expr)| (other.formula, &**expr));
        let defined = self.context.definitions.iter().rev().filter(|definition| {
            let head = &definition.head;
            let name = is_variable(&head.base) || head.base == "lambda";
            name && head.lower.is_empty() && head.upper.is_empty() && place.sees(&definition.place)
        });
        let defined = defined.filter_map(|definition| match &definition.body {
            Body::Formula(body) if bases(body).is_empty() => {
                let value = evaluator::number(body)?;
                Some((definition.place.formula, value))
            }
            _ => None,
        });
        let numbers = said.chain(heard).filter_map(|(at, expr)| Some((at, number(expr)?)));
        let mut all: Vec<(usize, Rational)> = numbers.chain(defined).collect();
        all.sort_by_key(|(at, _)| std::cmp::Reverse(*at));
        let mut found: Vec<(usize, Rational)> = Vec::new();
        for (at, value) in all {
            if found.len() < MAX_PARAMETERS && !found.iter().any(|(_, known)| *known == value) {
                found.push((at, value));
            }
        }
        found
    }

    /// Whether the section says what the control point of a number is.
    fn has_point(&self, letter: &str, number: i64, place: &Place) -> bool {
        self.context.visible(letter, place).any(|(_, definition, near)| {
            let head = &definition.head;
            let index = head.index().and_then(Expr::as_int);
            near && head.arguments.is_none()
                && index == Some(number)
                && (head.upper.is_empty() || level(head) == Some(0))
        })
    }
}

/// The letter, number and level of b_i^r or b_i^{(r)}.
fn member(expr: &Expr) -> Option<(String, i64, i64)> {
    let head = Head::of(expr).filter(|head| head.arguments.is_none())?;
    Some((head.base.clone(), head.index()?.as_int()?, level(&head)?))
}

fn level(head: &Head) -> Option<i64> {
    match head.upper.as_slice() {
        [level] => level.as_int(),
        _ => None,
    }
}

/// A point written as another one is, with its own number and level.
fn point(letter: &str, number: i64, level: i64, like: &Expr) -> Expr {
    let name: Expr = Kind::Subscript(Box::new(Expr::name(letter)), vec![Expr::int(number)]).into();
    if level == 0 {
        return name;
    }
    match Head::of(like).is_some_and(|head| head.parenthesized) {
        true => Kind::Upper(Box::new(name), vec![Expr::int(level)]).into(),
        false => name.power(Expr::int(level)),
    }
}
