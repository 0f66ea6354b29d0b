//! Points that are made of points: the weights add up to 1.
//!
//! **Rule.** A formula for points of a kind in points of the same kind, such as control points in control points, does not
//! depend on the origin: with the point 1 for each of them both sides are 1. Differences, with the sum 0, are vectors. Any
//! other sum is no affine combination, so the formula is warned of.
//!
//! It says nothing where weights of other families stand beside the points (homogeneous coordinates), nor where the page
//! does not speak of control points, nor of integrals.

use std::collections::BTreeSet;

use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::tally::Failure;
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::judge::page::context::{Body, is_variable};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Chain, Place, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::written::names::{Head, is_index_letter, letter_of, walk};
use crate::language::lexicon::families::{self, Family};
use crate::language::lexicon::roles::{self, Listed};
use crate::language::write;

impl Checker {
    /// Warns of a formula for control points whose weights do not add up to 1.
    ///
    /// Cost: that of trying the sum of its weights, where such points stand on both sides.
    pub(in crate::judge) fn warn_of_weights(
        &self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
    ) {
        let ([left, right], [(Rel::Eq | Rel::Define, _)], [finding]) =
            (chain.sides.as_slice(), chain.relations.as_slice(), findings)
        else {
            return;
        };
        let open = matches!(finding.verdict, Verdict::Definition | Verdict::Undecided);
        if !open || finding.warning.is_some() || left.is_unread() || right.is_unread() {
            return;
        }
        if statement.topics.has(Topic::Integral) {
            return;
        }
        let Some(weights) = self.sum_of_weights(&left.expr, &right.expr, statement) else { return };
        let side = |expr: Expr, like: &Side| Side { expr, latex: like.latex.clone() };
        let sum = Chain { sides: vec![side(Expr::int(1), left), side(weights, right)], ..chain.clone() };
        let setting = self.setting(&sum, &statement.place, None);
        let sides = [&sum.sides[0].expr, &sum.sides[1].expr];
        let trial = || self.trial(&setting, &sides, &[Rel::Eq], Choices::default()).run();
        let Ok(outcomes) = budget::run(&self.limits, trial) else { return };
        let fails = &outcomes.tallies[0].fails;
        let zero = |failure: &Failure| {
            failure.right.as_rational().is_some_and(|sum| num_traits::Zero::is_zero(&sum))
        };
        let Some(failure) = fails.iter().find(|failure| failure.inner && !failure.outside) else { return };
        if fails.iter().any(zero) || outcomes.tallies[0].gap.is_some() {
            return;
        }
        let total = write::text(&failure.right.to_expr());
        let integers: Vec<String> =
            failure.integers.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        finding.warning = Some(match integers.is_empty() {
            true => format!("the weights of these points add up to {total}, not to 1"),
            false => format!(
                "the weights of these points add up to {total}, not to 1, for {}",
                integers.join(", ")
            ),
        });
    }

    /// The right side with 1 for each of its points, if both sides are about points and nothing else.
    fn sum_of_weights(&self, left: &Expr, right: &Expr, statement: &Statement) -> Option<Expr> {
        let own = Head::of(left).filter(|head| !head.lower.is_empty() && !head.is_bernstein())?;
        let mut members: Vec<(String, Expr)> = Vec::new();
        let mut several = false;
        walk(right, &mut |part| several |= matches!(part.kind, Kind::Big { .. }));
        gather(right, &mut members);
        let letters: BTreeSet<&str> = members.iter().map(|(base, _)| letter(base)).collect();
        // b_1 = b_0 + d_0/3 in bold letters: the d_i may be vectors.
        let alone = letters.len() == 1 && letters.contains(letter(&own.base));
        let points = |base: &str| {
            self.are_points(base, letter(base), &statement.place)
                || alone && self.context.letters.is_bold(letter(base))
        };
        several |= members.len() > 1;
        if !several || members.is_empty() || !members.iter().all(|(base, _)| points(base)) {
            return None;
        }
        let new = [Topic::Subdivision, Topic::Elevation, Topic::Insertion, Topic::Casteljau, Topic::Scheme];
        let made = roles::listed(letter(&own.base)) == Some(Listed::Points)
            && new.into_iter().any(|topic| statement.topics.has(topic));
        if !letters.contains(letter(&own.base)) && !points(&own.base) && !made {
            return None;
        }
        let weights = with_ones(right, &letters);
        let spacing =
            |name: &str| matches!(roles::listed(name), Some(Listed::Knots | Listed::Lengths | Listed::Nodes));
        let number = |name: &str| {
            is_index_letter(name)
                || is_variable(name)
                || roles::is_degree(name)
                || matches!(name, "a" | "b" | "c" | "d" | "binomial")
        };
        let mut known = true;
        walk(&weights, &mut |part| {
            known &= match &part.kind {
                // Knots and lengths, but no weights of a rational curve and no matrices
                Kind::Subscript(..) | Kind::Upper(..) => {
                    Head::of(part).is_some_and(|head| spacing(&head.base))
                }
                Kind::Name(name) => number(name) || spacing(name),
                Kind::Accent(..) | Kind::Prime(..) | Kind::Matrix(..) => false,
                Kind::List(_) | Kind::Tuple(_) | Kind::Cases(_) => false,
                _ => true,
            };
        });
        known.then_some(weights)
    }

    /// Whether the page says that a family is one of control points, or the one without its mark: in words, or by a sum of
    /// them with basis functions.
    fn are_points(&self, base: &str, letter: &str, place: &Place) -> bool {
        let own = |expr: &Expr| {
            Head::of(expr)
                .is_some_and(|head| (head.base == base || head.base == letter) && !head.lower.is_empty())
        };
        let told =
            self.context.objects.iter().filter(|told| place.in_reach(&told.place, told.object.local)).any(
                |told| {
                    let object = &told.object;
                    object.sort == Sort::ControlPoints && object.names.iter().any(own)
                        || object.points.iter().any(own)
                },
            );
        let basis = |part: &Expr| {
            Head::of(part).is_some_and(|head| {
                let (lower, upper) = (head.lower.len(), head.upper.len());
                families::notation(&head.base, lower, upper).is_some()
            })
        };
        let combines =
            |part: &Expr| matches!(&part.kind, Kind::Big { body, .. } if body.has(&own) && body.has(&basis));
        told || self.context.definitions.iter().any(|definition| match &definition.body {
            Body::Formula(body) => place.knows(&definition.place, definition.assumed) && body.has(&combines),
            Body::Value(_) => false,
        })
    }
}

/// The letter of a name without its marks and primes: b for hat b and b'.
fn letter(base: &str) -> &str {
    letter_of(base).trim_end_matches('\'')
}

/// The members of families in a formula whose letters stand for points, each once.
fn gather(expr: &Expr, found: &mut Vec<(String, Expr)>) {
    let Some(head) = Head::of(expr).filter(|head| !head.lower.is_empty()) else {
        return expr.for_each_child(&mut |child| gather(child, found));
    };
    if is_point(&head) && !found.iter().any(|(_, known)| known.same_as(expr)) {
        found.push((head.base, expr.clone()));
    }
}

fn is_point(head: &Head) -> bool {
    let basis = head.is_bernstein() || head.is_a(Family::Spline);
    !head.lower.is_empty() && !basis && roles::listed(letter(&head.base)) == Some(Listed::Points)
}

/// A formula with 1 for each member of some families.
fn with_ones(expr: &Expr, letters: &BTreeSet<&str>) -> Expr {
    if Head::of(expr).is_some_and(|head| is_point(&head) && letters.contains(letter(&head.base))) {
        return Expr { span: expr.span, ..Expr::int(1) };
    }
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = with_ones(child, letters));
    result
}
