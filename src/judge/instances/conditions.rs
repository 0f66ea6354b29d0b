//! What the conditions of a chain do to the comparison of its sides: they are equations that are solved
//! and put in, and ranges.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::hypotheses::{self, Solution, is_coefficient};
use crate::judge::instances::tally::Tally;
use crate::judge::instances::trial::Trial;
use crate::judge::model::FREE_TERMS;
use crate::judge::page::context::is_variable;
use crate::judge::values::compare::{self, Domain, Outcome};
use crate::judge::written::names::{Head, base_of, implied_index, own_names};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// Why nothing can be said where conditions contradict each other.
pub(in crate::judge) const CANNOT_HOLD: &str = "the condition cannot hold";

/// The conditions at hand, those said with the chain first.
pub(in crate::judge) struct Conditions<'a> {
    pub(in crate::judge) own: &'a [Expr],
    pub(in crate::judge) earlier: &'a [Expr],
}

impl Conditions<'_> {
    #[allow(clippy::too_many_arguments)]
    pub(in crate::judge) fn compare(
        &self,
        trial: &Trial,
        rel: Rel,
        left: &Value,
        right: &Value,
        bound: &[(String, i64)],
        degree: Option<usize>,
        tally: &mut Tally,
    ) -> Outcome {
        let ranges: Vec<Expr> = match rel {
            Rel::Le | Rel::Lt | Rel::Ge | Rel::Gt => self.own.iter().chain(self.earlier).cloned().collect(),
            _ => Vec::new(),
        };
        // t in B_i^n(t) ≥ 0 runs from 0 to 1.
        let domain = if tally.record.unit { Domain::Unit } else { Domain::Reals };
        let plain = compare::relation(rel, left, right, &ranges, domain);
        if !matches!(plain, Outcome::Fails(_)) {
            // "For every t", without a range
            let everywhere = domain == Domain::Unit
                && trial.is_for_every_number(&ranges)
                && !matches!(compare::relation(rel, left, right, &ranges, Domain::Reals), Outcome::Holds);
            return match everywhere {
                true => Outcome::Unclear("it holds from 0 to 1, but for every number it is said".to_owned()),
                false => plain,
            };
        }
        if rel == Rel::Eq
            && let Some(outcome) = self.by_contact(trial, left, right, bound, degree, tally)
        {
            return outcome;
        }
        let mut solved: Vec<(Symbol, crate::math::poly::Fraction)> = Vec::new();
        let mut plain = plain;
        // Numbers stay what they are, whatever was said before.
        let constant = compare::symbols(left).is_empty() && compare::symbols(right).is_empty();
        let earlier = if constant { &[] } else { self.earlier };
        for (at, condition) in self.own.iter().chain(earlier).enumerate() {
            let values = match weights(condition) {
                None => trial.condition_values(condition, bound, degree),
                // A sum of weights runs as far as the weights do that occur.
                Some(bounded) => {
                    let exactly =
                        if bounded { trial.condition_values(condition, bound, degree) } else { None };
                    let usable = exactly.filter(|(a, b)| {
                        compare::solved(a, b, &solved, left, right).is_some() || compare::contradicts(a, b)
                    });
                    let extended = || with_upper_bound(condition, left, right);
                    usable.or_else(|| trial.evaluated_condition(&extended(), bound, degree))
                }
            };
            let Some((a, b)) = values else { continue };
            if compare::contradicts(&a, &b) && at < self.own.len() + 3 {
                return Outcome::Unclear(CANNOT_HOLD.to_owned());
            }
            // f(0) = 2 and f(1) = 3, where f is tried as a constant
            if degree.is_some()
                && let (Some(a), Some(b)) =
                    (compare::substituted(&a, &solved), compare::substituted(&b, &solved))
                && !solved.is_empty()
                && compare::contradicts(&a, &b)
            {
                return Outcome::Unclear("nothing of this degree fits the data".to_owned());
            }
            let Some((symbol, value)) = compare::solved(&a, &b, &solved, left, right) else { continue };
            // w_0 = w_2 = 1: what is solved later stands in what was solved before.
            let later = [(symbol, value)];
            for (_, earlier) in &mut solved {
                if let Ok(put_in) = earlier.substitute(&later) {
                    *earlier = put_in;
                }
            }
            solved.extend(later);
            let (l, r) = (compare::substituted(left, &solved), compare::substituted(right, &solved));
            if let (Some(l), Some(r)) = (l, r) {
                let outcome = compare::relation(rel, &l, &r, &ranges, domain);
                if matches!(outcome, Outcome::Holds) {
                    if at >= self.own.len() {
                        tally.condition = Some(at - self.own.len());
                    }
                    return outcome;
                }
                // What fails fails where the conditions of the chain hold.
                if at < self.own.len() {
                    plain = outcome;
                }
            }
        }
        if constant {
            return plain;
        }
        // Data determine a function only within a class that the page names: for all that is known, S may be a spline.
        let supposed = tally.record.unknown.iter().any(|base| {
            trial.context.object_of_a_class(base, trial.place).is_none()
                && !tally.record.paired.contains(base)
        });
        if supposed {
            return plain;
        }
        let equations: Vec<(Value, Value)> = self
            .own
            .iter()
            .chain(trial.hypotheses().iter().take(NEAREST))
            .flat_map(|condition| {
                let instances = trial.condition_instances(condition, bound, degree);
                instances.into_iter().filter_map(|own| trial.condition_values(condition, &own, degree))
            })
            .collect();
        let family = |value: &Value| -> BTreeSet<String> {
            let members = compare::symbols(value).into_iter().filter(|symbol| !symbol.is_plain());
            members.map(|symbol| base_of(&symbol).into_owned()).collect()
        };
        let wanted = family(left);
        let Some(Solution { values: solution, sampled }) =
            hypotheses::solve(&equations, &[left, right], &|symbol| wanted.contains(&*base_of(symbol)))
        else {
            return plain;
        };
        let (Some(l), Some(r)) =
            (compare::substituted(left, &solution), compare::substituted(right, &solution))
        else {
            return plain;
        };
        let open = |value: &Value| {
            compare::symbols(value)
                .into_iter()
                .filter(|s| !s.is_plain() && wanted.contains(&*base_of(s)))
                .count()
        };
        let is_solved = |symbol: &Symbol| solution.iter().any(|(solved, _)| solved == symbol);
        let touched = |value: &Value| compare::symbols(value).iter().any(is_solved);
        if !touched(left) && !touched(right) {
            // c_5, where the hypotheses say what c_0, …, c_3 are.
            let members = |symbol: &Symbol| {
                !symbol.is_plain()
                    && wanted.contains(&*base_of(symbol))
                    && solution.iter().any(|(solved, _)| {
                        base_of(solved) == base_of(symbol) && solved.upper().len() == symbol.upper().len()
                    })
            };
            let beyond = compare::symbols(left).iter().any(members);
            tally.beyond += usize::from(beyond && matches!(plain, Outcome::Fails(_)));
            return plain;
        }
        // c_0 in terms of b_2 and c_1, of which the claim speaks, too
        let members = |value: &Value| -> BTreeSet<Symbol> {
            compare::symbols(value).into_iter().filter(|symbol| !symbol.is_plain()).collect()
        };
        let spoken_of: BTreeSet<Symbol> =
            equations.iter().flat_map(|(a, b)| [a, b]).flat_map(compare::symbols).collect();
        let settled = members(left).iter().all(is_solved)
            && members(&l).is_subset(&members(right))
            && members(&r).is_subset(&spoken_of);
        // p(t) = 1 + α t^2 + β t^3 says what α and β are, if nothing else speaks of them.
        let own = compare::symbols(left);
        let unheard = |symbol: &Symbol| {
            !is_variable(symbol.base()) && !spoken_of.contains(symbol) && !own.contains(symbol)
        };
        let ansatz = compare::symbols(right).iter().any(unheard);
        // q(0) = p(1) says of q what p says: numbers for it are data of a p that may be any polynomial.
        let of_any = |value: &Value| compare::symbols(value).iter().any(is_coefficient);
        let data = of_any(&l) != of_any(&r);
        let outcome = compare::relation(rel, &l, &r, &ranges, domain);
        tally.condition.get_or_insert(0);
        tally.sampled |= sampled;
        match outcome {
            Outcome::Holds => outcome,
            // Everything that is claimed about is determined, and it is something else.
            Outcome::Fails(_) if open(left) > 0 && (open(&l) == 0 || settled) && !ansatz && !data => {
                tally.determined += 1;
                outcome
            }
            _ => plain,
        }
    }
}

/// So many earlier conditions, the nearest ones, are solved together.
const NEAREST: usize = 12;

/// Whether a condition is about a sum, and whether that has both bounds.
fn weights(condition: &Expr) -> Option<bool> {
    match &condition.kind {
        Kind::Chain(sum, _) => match &sum.kind {
            Kind::Big { upper, .. } => Some(upper.is_some()),
            _ => None,
        },
        _ => None,
    }
}

/// The upper bound of a sum of weights, where the instance does not fix it: the largest index of
/// the weights in the sides.
fn with_upper_bound(condition: &Expr, left: &Value, right: &Value) -> Expr {
    let Kind::Chain(sum, links) = &condition.kind else { return condition.clone() };
    let Kind::Big { op, body, lower, .. } = &sum.kind else { return condition.clone() };
    let index = own_names(lower).into_iter().next().or_else(|| implied_index(body));
    let (Some(index), Some(head)) = (index, Head::of(body)) else { return condition.clone() };
    let most = compare::symbols(left)
        .into_iter()
        .chain(compare::symbols(right))
        .filter(|symbol| base_of(symbol) == head.base)
        .filter_map(|symbol| match symbol.indices() {
            [crate::math::poly::Index::Number(i)] => Some(*i),
            _ => None,
        })
        .max();
    let least = match lower.first().map(|piece| &piece.kind) {
        Some(Kind::Chain(_, from)) => from[0].expr.clone(),
        _ => Expr::int(1),
    };
    let sum = Kind::Big {
        op: *op,
        lower: vec![Expr::relation(Expr::name(index), Rel::Eq, least)],
        upper: Some(Box::new(Expr::int(most.unwrap_or(FREE_TERMS)))),
        body: body.clone(),
    };
    Kind::Chain(Box::new(sum.into()), links.clone()).into()
}
