//! The likely slip in a wrong formula.
//!
//! Small edits of one side are tried: an index or exponent changed by one, a letter or index
//! exchanged for one that occurs beside it, a sign, a number changed a little, a factor added or
//! left out, the entries of a binomial. An edit is a repair if with it the relation holds in every
//! instance; it is better if the rest of the chain is then true as well. It is proposed if the judge confirms it in
//! the place of the wrong one (`confirm`). The search is exhaustive
//! for single edits and stops after a share of the steps. Where none is found, each number is solved for.

mod confirm;
mod edits;
mod exchanges;
mod number;
mod tidy;

pub(super) use self::edits::edits;

use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::setting::Setting;
use crate::judge::instances::tally::{Outcomes, Tally};
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::judge::page::statement::Statement;
use crate::judge::values::rounding::misprinted;
use crate::judge::written::bare::{bare, vanishes};
use crate::judge::written::features::{has_call, has_structure, missing_argument};
use crate::judge::written::names::{Head, bases, walk};
use crate::language::write;
use std::cell::Cell;

/// A relation with which a wrong one is replaced.
pub struct Repair {
    left: Expr,
    rel: Rel,
    right: Expr,
    /// Whether it is a small edit of the wrong one, and says something: it is no a = a, and not 0 = 0 only.
    pub near: bool,
    /// Whether the judge confirms it as well as the wrong one was refuted.
    sure: bool,
}

impl Repair {
    /// As LaTeX that can be pasted over the relation, if it was confirmed as well as the relation was refuted.
    pub fn latex(&self) -> Option<String> {
        self.sure.then(|| write::latex(&Expr::relation(self.left.clone(), self.rel, self.right.clone())))
    }
}

/// So many changes that are true in every instance are put before the judge.
const HEARINGS: usize = 8;

/// A repair of the relation number `at`; `held` are those before it that hold. Cost: an instance or two for each of some
/// hundred edits, all instances for those that pass.
pub fn find(
    checker: &Checker,
    setting: &Setting,
    at: usize,
    choices: Choices,
    tally: &Tally,
    statement: &Statement,
    held: &[usize],
) -> Option<Repair> {
    let tried = tally.holds + tally.fails.len();
    let start = budget::spent();
    let hearings = Cell::new(0);
    let confirmed = |left: &Expr, right: &Expr| {
        if checker.confirming {
            return false;
        }
        hearings.set(hearings.get() + 1);
        let short = budget::spent() - start <= crate::judge::instances::setting::share(&checker.limits, 1);
        short
            && hearings.get() <= HEARINGS
            && checker.confirms(setting.chain, at, [left, right], held, statement)
    };
    let Setting { chain, curve, .. } = setting;
    let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
    let rel = chain.relations[at].0;
    let try_out = |left: &Expr, right: &Expr, quick: bool| -> Option<Tally> {
        let trial = checker.trial(setting, &[left, right], &[rel], choices);
        let mut outcomes = if quick { trial.first(3) } else { trial.run() };
        is_true(&outcomes, quick).then(|| outcomes.tallies.remove(0))
    };
    // The slip is on the right more often than on the left, and there the edits are listed first.
    let mut candidates: Vec<(Expr, Expr)> = Vec::new();
    if at == 0 {
        candidates.extend(with_arguments(left, right).map(|left| (left, right.clone())));
    }
    candidates.extend(edits(right, left, curve).into_iter().map(|edit| (left.clone(), edit)));
    if at > 0 || Head::of(left).is_none() {
        candidates.extend(edits(left, right, &None).into_iter().map(|edit| (edit, right.clone())));
    }
    let next = chain
        .sides
        .get(at + 2)
        .filter(|_| matches!(chain.relations[at + 1].0, Rel::Eq))
        .map(|side| &side.expr);
    // n = 10, 2 = 1, 2x + y = 1 become true with another number, whatever was meant.
    let computed = has_structure(left)
        || bases(left).is_empty() && !matches!(left.kind, Kind::Number(_))
        || has_call(left);
    let value = matches!(right.kind, Kind::Number(_)) && !computed;
    let mut best: Option<Repair> = None;
    for (left, right) in candidates {
        if budget::spent() - start > crate::judge::instances::setting::share(&checker.limits, 16) {
            break;
        }
        budget::steps(64);
        let says_nothing = vanishes(&left) || vanishes(&right) || bare(&left) == bare(&right);
        if says_nothing || try_out(&left, &right, true).is_none() {
            continue;
        }
        let Some(holds) = try_out(&left, &right, false) else { continue };
        let repair = Repair {
            near: rel == Rel::Eq && !value && holds.nonzero > 0 && 2 * holds.holds >= tried,
            sure: 2 * holds.holds >= tried && is_mostly_true(&holds) && confirmed(&left, &right),
            left,
            rel,
            right,
        };
        // One that mends the rest of the chain, too, is surely meant.
        let last = next.is_none_or(|next| next.same_as(&repair.right));
        let mends = last || next.is_some_and(|next| try_out(&repair.right, next, false).is_some());
        if mends && repair.sure {
            return Some(repair);
        }
        if best.as_ref().is_none_or(|best| repair.sure && !best.sure) {
            best = Some(Repair { near: repair.near || best.is_some_and(|best| best.near), ..repair });
        }
    }
    if best.as_ref().is_some_and(|best| best.sure) {
        return best;
    }
    let solved = || {
        let (left, right) = number::candidates(checker, setting, at, choices)
            .into_iter()
            .find(|(left, right)| try_out(left, right, false).is_some())?;
        Some(Repair { near: rel == Rel::Eq && !value, sure: false, left, rel, right })
    };
    let others: [&dyn Fn() -> Option<Repair>; 2] = [&solved, &|| written_out(checker, setting, at, choices)];
    for mut repair in others.into_iter().filter_map(|other| other()) {
        repair.sure = confirmed(&repair.left, &repair.right);
        // A small edit that is true shows what was meant, also where it is not what to write.
        repair.near = best.as_ref().map_or(repair.near, |best| best.near);
        if repair.sure {
            return Some(repair);
        }
        best = Some(best.unwrap_or(repair));
    }
    best
}

/// Whether a relation held wherever it made sense, often enough.
pub(super) fn is_true(outcomes: &Outcomes, quick: bool) -> bool {
    let tally = &outcomes.tallies[0];
    let ranged = !outcomes.integers.is_empty();
    let enough = if !ranged || quick { tally.holds > 0 } else { tally.holds_inner >= 1 || tally.holds >= 4 };
    let fails = tally.fails.iter().filter(|failure| !failure.outside && (failure.inner || !ranged)).count();
    fails == 0 && enough && tally.mismatches.is_empty()
}

/// Whether what fails, in extreme instances only, is so little that it may be a case that the page leaves out.
fn is_mostly_true(tally: &Tally) -> bool {
    let fails = tally.fails.iter().filter(|failure| !failure.outside).count();
    5 * fails <= 2 * tally.holds
}

/// f(t) = … in t_1, …, t_n: the arguments written out.
fn with_arguments(left: &Expr, right: &Expr) -> Option<Expr> {
    let head = Head::of(left)?;
    missing_argument(&head, right)?;
    let Kind::Apply(callee, _) = &left.kind else { return None };
    let arguments = head.flat();
    let base = arguments.first()?;
    let mut last = None;
    walk(right, &mut |part| {
        if let Kind::Big { upper: Some(upper), .. } = &part.kind
            && last.is_none()
        {
            last = Some(upper.as_ref().clone());
        }
    });
    let index = |index: Expr| Expr::from(Kind::Subscript(Box::new((*base).clone()), vec![index]));
    let list = vec![index(Expr::int(1)), Kind::Ellipsis.into(), index(last?)];
    Some(Expr::apply(callee.as_ref().clone(), list))
}

/// The formula on the left written out, if the relation is no family.
fn written_out(checker: &Checker, setting: &Setting, at: usize, choices: Choices) -> Option<Repair> {
    let chain = setting.chain;
    let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
    let outcomes = checker.trial(setting, &[left, right], &[Rel::Eq], choices).run();
    if !outcomes.integers.is_empty() {
        return None;
    }
    // The value of the left side, if it is a formula of bearable length.
    let failure = outcomes.tallies[0].fails.last()?;
    let invented = crate::judge::values::compare::symbols(&failure.left)
        .iter()
        .any(crate::judge::instances::hypotheses::is_coefficient);
    let crate::language::value::Value::Scalar(value) = &failure.left else { return None };
    let size = value.numerator().len() + value.denominator().len();
    if invented || size > 24 {
        return None;
    }
    let right = crate::language::value::polynomial_expr(value);
    let rel = chain.relations[at].0;
    let near = rel == Rel::Eq
        && matches!((&chain.sides[at + 1].expr.kind, &right.kind), (Kind::Number(wrong), Kind::Number(value)) if misprinted(wrong, value));
    (!left.same_as(&right)).then(|| Repair { left: left.clone(), rel, right, near, sure: false })
}
