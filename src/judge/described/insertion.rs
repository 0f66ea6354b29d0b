//! New control points after a knot was inserted, by numbers.
//!
//! **Formula** (Boehm). Inserting x between the knots t_k ≤ x < t_{k+1} of a spline of degree n gives the control points
//! (1 - α_i) d_{i-1} + α_i d_i with α_i = (x - t_i)/(t_{i+n} - t_i), cut off at 0 and 1.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::budget;
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::judge::instances::setting;
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::judge::page::context::{Body, Mark, value_given};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::{Chain, Place, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::counterexample;
use crate::judge::repair;
use crate::judge::written::names::{Head, walk};
use crate::language::lexicon::families;
use crate::math::number::{Rational, integer};

/// A spline with its knots by number.
struct Spline {
    degree: i64,
    points: String,
    knots: BTreeMap<i64, Rational>,
}

impl Checker {
    /// Judges a formula for a new control point, where the section speaks of a spline and of a knot to be inserted.
    pub(in crate::judge) fn by_insertion(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let Some((Rel::Eq, _)) = chain.relations.first() else { return };
        let open = findings[0].verdict == Verdict::Definition && !chain.blocked;
        if !open || !statement.topics.has(Topic::Insertion) {
            return;
        }
        let limits = self.limits.clone();
        let Ok(Some(found)) = budget::run(&limits, || self.inserted(chain, statement, &findings[0])) else {
            return;
        };
        if found.verdict == Verdict::Refuted {
            Rc::make_mut(&mut self.context).forget(before);
        } else if let Some(head) = Head::of(&chain.sides[0].expr)
            && matches!(chain.sides[1].expr.kind, Kind::Add(_))
        {
            self.agreed.push((head.base, statement.place.clone()));
        }
        findings[0] = found;
    }

    fn inserted(&self, chain: &Chain, statement: &Statement, finding: &Finding) -> Option<Finding> {
        let place = &statement.place;
        let (left, right) = (&chain.sides[0].expr, &chain.sides[1].expr);
        let head = Head::of(left).filter(|head| head.arguments.is_none())?;
        let [index] = head.lower.as_slice() else { return None };
        let i = index.as_int()?;
        let told = self.spline_of(place, &head.base);
        let whole = told.is_some();
        let spline = told
            .or_else(|| self.spline_in_parts(statement, &head.base))
            .or_else(|| self.spline_in_a_sum(statement, &head.base))?;
        // The new knot \bar u = 7/2, or a number in passing.
        let named = self.context.definitions.iter().rev().find_map(|definition| match &definition.body {
            Body::Formula(body) if place.knows(&definition.place, definition.assumed) => {
                let head = &definition.head;
                let plain = head.lower.is_empty() && head.arguments.is_none();
                Some(body.clone()).filter(|_| plain && (head.base.contains(' ') || !head.upper.is_empty()))
            }
            _ => None,
        });
        let number = |x: &Expr| x.as_number().cloned().or_else(|| fraction(x));
        // Numbers of the paragraph that are no knots
        let new = || {
            let is_new = |x: &Rational| {
                let inside =
                    spline.knots.values().any(|knot| knot < x) && spline.knots.values().any(|knot| knot > x);
                inside && !spline.knots.values().any(|knot| knot == x)
            };
            let passing =
                self.context.conditions.iter().filter(|told| place.knows(&told.place, told.assumed));
            let told = passing.filter_map(|told| Some(value_given(&told.expr)?.1));
            let mut all: Vec<Rational> =
                self.heard(place).chain(told).filter_map(number).filter(is_new).collect();
            all.sort();
            all.dedup();
            all
        };
        let x = named.as_ref().and_then(number).or_else(|| {
            let (all, heard) = (new(), self.parameter_heard(place).as_ref().and_then(number));
            match all.as_slice() {
                [x] => Some(x.clone()),
                [] => heard.filter(|_| whole),
                _ => heard.filter(|x| whole && all.contains(x)),
            }
        })?;
        let (from, to) = (spline.knots.get(&i)?, spline.knots.get(&(i + spline.degree))?);
        let ratio = match from < to {
            true => (&x - from) / (to - from),
            false => integer(i64::from(*to <= x)),
        };
        let ratio = ratio.clamp(integer(0), integer(1));
        let terms = [(integer(1) - &ratio, i - 1), (ratio, i)]
            .into_iter()
            .filter(|(weight, _)| *weight != integer(0));
        let term = |(weight, at): (Rational, i64)| Term {
            sign: Sign::Plus,
            expr: Expr::product(vec![Expr::number(&weight), Expr::indexed(&spline.points, at)]),
        };
        let wanted = Expr::sum(terms.map(term).collect());
        let setting = self.setting(chain, place, None).without_equations();
        let tried = |formula: &Expr| {
            let mut outcomes =
                self.trial(&setting, &[formula, &wanted], &[Rel::Eq], Choices::default()).run();
            outcomes.tallies.remove(0)
        };
        let tally = tried(right);
        if !tally.errors.is_empty() || !tally.unclear.is_empty() {
            return None;
        }
        let Some(failure) = tally.fails.first() else {
            return (tally.holds > 0).then(|| Finding {
                verdict: Verdict::Proved,
                reason: Some("the control point after knot insertion".to_owned()),
                witness: None,
                suggestion: None,
                ..finding.clone()
            });
        };
        // After another new point that agreed nothing else can be meant.
        let mut agreed = self.agreed.iter();
        let meant = agreed.any(|(letter, other)| *letter == head.base && place.knows(other, false));
        let start = budget::spent();
        let repaired = repair::edits(right, left, &None)
            .into_iter()
            .take_while(|_| budget::spent() - start < setting::share(&self.limits, 4))
            .find(|edit| {
                let tally = tried(edit);
                tally.fails.is_empty() && tally.holds > 0
            })
            .or_else(|| meant.then(|| wanted.clone()))?;
        Some(Finding {
            verdict: Verdict::Refuted,
            reason: Some("it differs from the control point after knot insertion".to_owned()),
            witness: counterexample::counterexample(failure),
            suggestion: self.suggestion(chain, 0, [left, &repaired], &[], statement),
            ..finding.clone()
        })
    }

    /// The latest spline of the section with knots by number, whose control points have another letter.
    fn spline_of(&self, place: &Place, new: &str) -> Option<Spline> {
        let curves = self
            .context
            .objects
            .iter()
            .rev()
            .filter(|told| told.object.sort == Sort::SplineCurve && place.knows(&told.place, false));
        let of = |object: &Object| {
            let degree = object.degree.as_ref()?.as_int()?;
            let points = object.points.first().and_then(Head::of).map(|head| head.base);
            let points =
                points.or_else(|| self.points_of_sum(&Head::of(object.names.first()?)?.base, place))?;
            let numbers: Option<Vec<Rational>> =
                object.knots.iter().map(|knot| knot.as_number().cloned()).collect();
            let knots: BTreeMap<i64, Rational> = match numbers.filter(|knots| !knots.is_empty()) {
                Some(knots) => (0..).zip(knots).collect(),
                None => {
                    let letter = object.knots.first().and_then(Head::of).map(|head| head.base);
                    let letters =
                        letter.map_or_else(|| self.context.knot_letters(place, &[]), |own| vec![own]);
                    self.context.given_knots(&letters, place)
                }
            };
            (points != new && !knots.is_empty()).then_some(Spline { degree, points, knots })
        };
        curves.filter_map(|told| of(&told.object)).next()
    }

    /// A spline of which the section says degree, knots and control points one by one, as many as fit together.
    fn spline_in_parts(&self, statement: &Statement, new: &str) -> Option<Spline> {
        let place = &statement.place;
        let mut degrees = statement.topics.degrees();
        let degree = degrees.next().filter(|_| degrees.next().is_none())?;
        let knots = self.context.given_knots(&self.context.knot_letters(place, &[]), place);
        let count = knots.len() as i64 - degree - 1;
        // p_0, …, p_4: as many as there have to be
        let numbered = |expr: &Expr, number: i64| {
            let head = Head::of(expr).filter(|head| head.index().and_then(Expr::as_int) == Some(number))?;
            (head.arguments.is_none() && head.base != new).then_some(head.base)
        };
        let last: Vec<String> = self.heard(place).filter_map(|expr| numbered(expr, count - 1)).collect();
        let mut first = self.heard(place).filter_map(|expr| numbered(expr, 0));
        let points = first.find(|letter| last.contains(letter))?;
        let from_first = knots.keys().next() == Some(&0);
        (from_first && count > degree).then_some(Spline { degree, points, knots })
    }

    /// A spline that a formula gives as a sum of B-splines, s = Σ d_i N_{i,2}, with its knots by number.
    fn spline_in_a_sum(&self, statement: &Statement, new: &str) -> Option<Spline> {
        let place = &statement.place;
        let knots = self.context.given_knots(&self.context.knot_letters(place, &[]), place);
        let mut near =
            self.context.definitions.iter().rev().filter(|own| place.knows(&own.place, own.assumed));
        let (points, size) = near.find_map(|own| {
            let Body::Formula(body) = &own.body else { return None };
            let mut size = None;
            walk(body, &mut |part| {
                let spline = Head::of(part).filter(|head| head.base == families::SPLINE);
                size = size.take().or_else(|| {
                    spline.and_then(|head| head.lower.iter().skip(1).chain(&head.upper).next_back().cloned())
                });
            });
            Some((self.points_of_sum(&own.head.base, place)?, size?))
        })?;
        let order = self.context.spline_has_this_degree(&size, place) == Some(false);
        let degree = size.as_int()? - i64::from(order);
        (points != new && !knots.is_empty()).then_some(Spline { degree, points, knots })
    }

    /// The letter of the control points in s(x) = Σ d_i N_{i,n}(x).
    fn points_of_sum(&self, curve: &str, place: &Place) -> Option<String> {
        self.context.visible(curve, place).find_map(|(_, definition, _)| {
            let Body::Formula(body) = &definition.body else { return None };
            let mut found = None;
            walk(body, &mut |part| {
                if let Kind::Subscript(base, _) = &part.kind
                    && let Kind::Name(letter) = &base.kind
                    && !families::is_family(letter)
                    && found.is_none()
                {
                    found = Some(letter.clone());
                }
            });
            found
        })
    }
}

/// The value of a fraction of two numbers.
fn fraction(expr: &Expr) -> Option<Rational> {
    let Kind::Div(above, below, _) = &expr.kind else { return None };
    let (above, below) = (above.as_number()?, below.as_number()?);
    (*below != integer(0)).then(|| above / below)
}
