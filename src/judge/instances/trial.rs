//! Trying a chain of relations on all small instances.
//!
//! An instance gives values to the integers of the chain (and to the degree of functions that are
//! not defined). In an instance each side is evaluated exactly; a side that makes no sense there,
//! such as a binomial of a negative number, makes the instance invalid for its relations only.

use crate::language::lexicon::roles;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use crate::budget::{self, Limits, Stop};
use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::instances::conditions::{CANNOT_HOLD, Conditions};
use crate::judge::instances::integers::{
    as_values, equated_index, is_inner, is_outside, is_positive, last_values,
};
use crate::judge::instances::setting::{Facts, Setting, share};
use crate::judge::instances::tally::{Failure, Outcomes, Tally};
use crate::judge::model::{Choices, Model, Record, holds};
use crate::judge::page::context::{Context, is_variable};
use crate::judge::page::statement::Place;
use crate::judge::values::compare::{self, Outcome};
use crate::judge::values::evaluator::{self, evaluate_reading};
use crate::judge::values::family::advance;
use crate::judge::written::features::{ends_of_sums, has_divided_differences, has_groups, pairs};
use crate::judge::written::names::{bases, integer_names, is_index_letter};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::Value;
use crate::math::number::{Rational, integer};
use crate::math::poly::Symbol;
use num_traits::Zero;

/// The largest value tried for an integer, by the number of integers.
const LARGEST: [i64; 6] = [0, 6, 4, 3, 2, 2];

/// The same for inequalities between numbers, and for equations between numbers with many integers.
const LARGEST_OF_NUMBERS: [i64; 6] = [0, 30, 14, 4, 3, 2];

/// Larger values of the only integer of an inequality between numbers.
const LATE: [i64; 3] = [60, 100, 200];

/// More instances than this are not tried.
const MOST: usize = 260;

/// What is tried.
pub struct Trial<'a> {
    /// The sides of the chain.
    pub sides: Vec<&'a Expr>,
    /// The relations between them.
    pub relations: Vec<Rel>,
    /// Conditions said with the chain.
    pub conditions: &'a [Expr],
    /// Names of which it speaks for all values.
    quantified: &'a [String],
    /// What it may rest on.
    pub facts: Rc<Facts>,
    /// What is known.
    pub context: Rc<Context>,
    /// Where the chain stands.
    pub place: &'a Place,
    /// The limits of the chain.
    limits: Limits,
    /// What its names mean, before an instance fixes degree and parameter.
    reading: Model,
    /// The last values that its sides allow for indices.
    last: Vec<(String, Expr)>,
    /// What its conditions are in an instance.
    memo: Memo,
}

/// The sides of conditions, by condition, integers and degree.
type Memo = RefCell<HashMap<(*const Expr, Vec<(String, i64)>, Option<usize>), Option<(Value, Value)>>>;

impl<'a> Trial<'a> {
    /// Some sides and relations, in the setting of a chain, under one way to read ambiguous notations.
    pub(in crate::judge) fn new(
        context: Rc<Context>,
        setting: &Setting<'a>,
        sides: Vec<&'a Expr>,
        relations: Vec<Rel>,
        choices: Choices,
        limits: &Limits,
    ) -> Self {
        let reading = Model::new(context.clone(), setting.place.clone(), choices, setting.curve.clone())
            .with_pairs(pairs(&sides, &|letter| context.letters.may_have_polar_form(letter)))
            .opaque(has_divided_differences(&sides))
            .with_tensor(has_groups(&sides))
            .with_ends(ends_of_sums(&sides));
        let mut trial = Trial {
            last: last_values(&sides),
            sides,
            relations,
            conditions: &setting.chain.conditions,
            quantified: &setting.chain.quantified,
            facts: setting.facts.clone(),
            context,
            place: setting.place,
            limits: limits.clone(),
            reading,
            memo: Memo::default(),
        };
        let given = trial.facts.given_knots.clone();
        trial.reading =
            trial.reading.clone().with_uniform_knots(trial.has_integer_knots()).with_given_knots(given);
        trial
    }

    /// Conditions that stand in the same section, the nearest first.
    pub(in crate::judge) fn hypotheses(&self) -> &[Expr] {
        &self.facts.earlier[..self.facts.near]
    }

    /// The integers that no condition gives by others: "where k = n + 1".
    fn free(&self, bound: &[(String, i64)]) -> Vec<(String, i64)> {
        let sum = |condition: &&Expr| matches!(&condition.kind, Kind::Chain(_, links) if matches!(links[0].expr.kind, Kind::Add(_)));
        let given =
            |name: &String| self.conditions.iter().filter(sum).any(|one| equated_index(one) == Some(name));
        bound.iter().filter(|(name, _)| !given(name)).cloned().collect()
    }

    /// Tries all small instances, and larger ones if very few of the small ones make sense: of 1 < i < n - 1 the first is n = 4.
    pub fn run(&self) -> Outcomes {
        let outcomes = self.run_some(None, 0);
        let tried = |tally: &Tally| tally.holds + tally.fails.len();
        let few = outcomes.tallies.iter().any(|tally| (1..3).contains(&tried(tally)));
        match few && outcomes.integers.len() > 1 && !outcomes.fixed {
            true => self.run_some(None, 2),
            false => outcomes,
        }
    }

    /// Whether it is said of every value of a variable for which no condition gives a range.
    pub(in crate::judge) fn is_for_every_number(&self, conditions: &[Expr]) -> bool {
        let ranged = |name: &String| conditions.iter().any(|condition| bases(condition).contains(name));
        self.quantified.iter().any(|name| is_variable(name) && !is_index_letter(name) && !ranged(name))
    }

    fn run_some(&self, count: Option<usize>, more: i64) -> Outcomes {
        let integers = self.integers();
        let splines = self.has_pieces();
        // n = i + j + k
        let sums: Vec<Option<Expr>> = integers.iter().map(|name| self.made_of(name, &integers)).collect();
        let free = sums.iter().filter(|sum| sum.is_none()).count();
        // n! ≤ 3^n fails late.
        let numbers = self.is_of_integers(&integers);
        let equality = self.relations.iter().all(|rel| matches!(rel, Rel::Eq | Rel::Equiv | Rel::Define));
        let tried = if numbers && (!equality || free > 3) { LARGEST_OF_NUMBERS } else { LARGEST };
        let largest = tried.get(free).copied().unwrap_or(1);
        let largest = if splines { largest.min(3) } else { largest } + more;
        let mut outcomes = Outcomes {
            tallies: self.relations.iter().map(|_| Tally::default()).collect(),
            integers: integers.clone(),
            fixed: false,
            largest,
            degrees: false,
            cut: false,
            instances: 0,
        };
        if integers.len() > 8 {
            return outcomes;
        }
        let fixed: Vec<Option<i64>> = integers.iter().map(|name| self.fixed(name)).collect();
        outcomes.fixed = fixed.iter().all(Option::is_some);
        let opaque = has_divided_differences(&self.sides);
        let largest = if opaque { largest.min(3 + more) } else { largest };
        // Σ_{k=0}^6 of n over k is 2^n up to n = 6.
        let largest = match free {
            1 => largest.max(self.largest_number() + 2),
            _ => largest,
        };
        outcomes.largest = largest;
        let mut all: Vec<Vec<i64>> = Vec::new();
        if let (true, false, [_], [None]) = (numbers, equality, integers.as_slice(), fixed.as_slice()) {
            // (1 + 1/n)^n ≤ 2.7 fails late.
            all.extend(LATE.iter().map(|value| vec![*value]));
        }
        let mut values = vec![0i64; integers.len()];
        loop {
            let chosen = |at: usize| fixed[at].is_none() && sums[at].is_none();
            if values.iter().enumerate().all(|(at, value)| chosen(at) || *value == 0) {
                let mut own: Vec<i64> =
                    values.iter().zip(&fixed).map(|(value, fixed)| fixed.unwrap_or(*value)).collect();
                let named: Vec<(String, i64)> = integers.iter().cloned().zip(own.iter().copied()).collect();
                let mut whole = true;
                for (at, sum) in sums.iter().enumerate() {
                    let Some(sum) = sum else { continue };
                    let sum =
                        evaluator::machine().with_locals(as_values(&named), |machine| machine.eval_int(sum));
                    match sum {
                        Ok(sum) if sum >= 0 => own[at] = sum,
                        _ => whole = false,
                    }
                }
                if whole {
                    all.push(own);
                }
            }
            if !advance(&mut values, largest) {
                break;
            }
        }
        // Small ones first: large ones are left out if they take long.
        all.sort_by_key(|values| values.iter().sum::<i64>());
        // Those with zeros or beyond a size and the others take turns.
        let named = |values: &Vec<i64>| -> Vec<(String, i64)> {
            integers.iter().cloned().zip(values.iter().copied()).collect()
        };
        let (inner, outer): (Vec<_>, Vec<_>) = all.into_iter().partition(|values| {
            let bound = named(values);
            is_positive(&bound) && !is_outside(&self.free(&bound), &self.last)
        });
        let (mut inner, mut outer) = (inner.into_iter(), outer.into_iter());
        let turns = std::iter::from_fn(|| match (inner.next(), outer.next()) {
            (None, None) => None,
            pair => Some([pair.1, pair.0]),
        });
        let all: Vec<Vec<i64>> = turns.flatten().flatten().collect();
        let start = budget::spent();
        let mut tried = 0;
        for values in all {
            let bound: Vec<(String, i64)> = integers.iter().cloned().zip(values).collect();
            if count.is_some() && !is_inner(&self.free(&bound)) || !self.allows(&bound) {
                continue;
            }
            if count.is_some_and(|count| tried >= count) {
                break;
            }
            tried += 1;
            let limits = Limits { steps: Some(share(&self.limits, 8)), ..self.limits.clone() };
            let done = budget::run(&limits, || self.instance(&bound, splines, &mut outcomes));
            match done {
                Ok(()) => {}
                Err(Stop::Interrupted) => break,
                Err(stop) => {
                    for tally in &mut outcomes.tallies {
                        tally.unclear.push(format!("an instance was too large ({stop})"));
                    }
                    break;
                }
            }
            // One failure is enough for whoever asks for a few.
            if count.is_some() && outcomes.tallies.iter().any(|tally| !tally.fails.is_empty()) {
                break;
            }
            // Where it holds for some and fails for others, it has to be seen for which.
            let mixed = outcomes.tallies.iter().any(|tally| tally.holds > 0 && !tally.fails.is_empty());
            let most = share(&self.limits, if mixed { 8 } else { 64 });
            if tried >= MOST || budget::spent() - start > most {
                outcomes.cut = true;
                break;
            }
            budget::steps(1000);
        }
        outcomes
    }

    /// Tries a few instances only: the first in which nothing is extreme.
    pub fn first(&self, count: usize) -> Outcomes {
        let mut outcomes = self.run_some(Some(count), 0);
        outcomes.largest = 0;
        outcomes
    }

    /// Whether the conditions on integers hold.
    fn allows(&self, bound: &[(String, i64)]) -> bool {
        let names: Vec<(Symbol, Value)> = as_values(bound).collect();
        // What is said of an integer with the chain counts instead of what was said before.
        let own: BTreeSet<String> =
            self.conditions.iter().flat_map(crate::judge::written::names::bases).collect();
        let restricts = |condition: &&Expr| match &condition.kind {
            Kind::Chain(left, links) => {
                let equation = links.iter().any(|link| link.rel == Rel::Eq);
                (!equation || matches!(left.kind, Kind::Add(_) | Kind::Pow(..)))
                    && bases(condition).is_disjoint(&own)
            }
            _ => false,
        };
        self.conditions.iter().chain(self.hypotheses().iter().filter(restricts)).all(|condition| {
            // Conditions on other names than integers are used when sides are compared.
            let holds =
                evaluator::machine().with_locals(names.clone(), |machine| Ok(holds(machine, condition)));
            holds.ok().flatten() != Some(false)
        })
    }

    pub(in crate::judge) fn model(
        &self,
        degree: Option<usize>,
        around: Option<Rational>,
        breaks: &[Rational],
    ) -> Model {
        self.reading.clone().with_degree(degree).near(around).with_breaks(breaks.to_vec())
    }

    /// The variables of the function on the left: in F(u) = … the name u stands for itself, whatever
    /// it meant before. So does what is said of all u.
    fn variables(&self) -> Vec<String> {
        let real = |name: &&String| !is_index_letter(name) && !self.context.letters.is_function(name);
        let mut found: Vec<String> = self.quantified.iter().filter(real).cloned().collect();
        if let Some(Kind::Apply(_, groups)) = self.sides.first().map(|side| &side.kind) {
            for argument in groups.iter().flatten() {
                if let Kind::Name(name) = &argument.kind
                    && is_variable(name)
                {
                    found.push(name.clone());
                }
            }
        }
        found
    }

    fn evaluate(
        &self,
        model: Model,
        bound: &[(String, i64)],
    ) -> (Vec<Result<Value, Diagnostic>>, Vec<Record>) {
        let (local, given) = (model.is_local(), model.has_given_knots());
        let reading = Rc::new(model);
        let (values, records) = self.evaluate_with(&reading, bound, local);
        // c_i = t_{i+1} t_{i+2}, c_2 = 2: a number is compared with the knots that are given.
        let number = |side: &&Expr| bases(side).is_empty();
        let knots = || {
            let mut symbols = values.iter().flatten().flat_map(compare::symbols);
            symbols.any(|symbol| self.facts.knot_letters.iter().any(|letter| letter == symbol.base()))
        };
        match !local && given && self.sides.iter().any(number) && knots() {
            true => self.evaluate_with(&reading, bound, true),
            false => (values, records),
        }
    }

    fn evaluate_with(
        &self,
        reading: &Rc<Model>,
        bound: &[(String, i64)],
        knots: bool,
    ) -> (Vec<Result<Value, Diagnostic>>, Vec<Record>) {
        let variables = self.variables();
        let mut records = Vec::with_capacity(self.sides.len());
        let mut values = Vec::with_capacity(self.sides.len());
        for side in &self.sides {
            let free = variables.iter().map(|name| (Symbol::new(name), Value::symbol(Symbol::new(name))));
            let knots = if knots { reading.knots(&self.facts.knot_letters) } else { Vec::new() };
            let names = free.chain(knots).chain(as_values(bound));
            values.push(evaluate_reading(side, reading.clone(), names));
            records.push(reading.take_record());
        }
        (values, records)
    }

    fn instance(&self, bound: &[(String, i64)], splines: bool, outcomes: &mut Outcomes) {
        crate::budget::steps(64);
        self.memo.borrow_mut().clear();
        // First the degrees: a polar form with m arguments is one of degree m.
        let mut degrees: Vec<Option<usize>> = vec![None];
        let first = splines.then(|| integer(1) / integer(2));
        let breaks = if splines { self.breaks(bound, &self.facts.reached) } else { Vec::new() };
        let (values, probe) = self.evaluate(self.model(None, first, &breaks).discovering(), bound);
        let arities: BTreeSet<usize> =
            probe.iter().flat_map(|record| record.arities.iter().copied()).collect();
        let wanted = probe.iter().any(|record| record.wants_degree || record.flexible);
        if arities.is_empty() && !wanted && !splines {
            // Nothing depends on a degree: the values are those already.
            let valid = self.compare(bound, None, None, &values, &probe, outcomes);
            outcomes.instances += usize::from(valid);
            return;
        }
        if let Some(&least) = arities.first() {
            degrees = vec![Some(least)];
        } else if wanted {
            let size = roles::DEGREES
                .iter()
                .find_map(|name| bound.iter().find(|(own, _)| own == name).map(|(_, value)| *value));
            degrees = match size {
                Some(size) => usize::try_from(size).ok().map(Some).into_iter().collect(),
                None => (0..=self.largest_degree()).map(Some).collect(),
            };
        }
        if degrees.len() > 1 {
            outcomes.degrees = true;
        }
        for degree in degrees {
            let places: Vec<Option<Rational>> = match splines {
                true => self.places(bound, &breaks).into_iter().map(Some).collect(),
                false => vec![None],
            };
            let mut valid = false;
            for around in places {
                let (values, records) = self.evaluate(self.model(degree, around.clone(), &breaks), bound);
                valid |= self.compare(bound, degree, around, &values, &records, outcomes);
            }
            outcomes.instances += usize::from(valid);
        }
    }

    /// Compares neighbouring sides; says whether any two could be compared.
    fn compare(
        &self,
        bound: &[(String, i64)],
        degree: Option<usize>,
        around: Option<Rational>,
        values: &[Result<Value, Diagnostic>],
        records: &[Record],
        outcomes: &mut Outcomes,
    ) -> bool {
        let free = self.free(bound);
        let outside = is_outside(&free, &self.last);
        let inner = is_inner(&free) && degree != Some(0) && !outside;
        let proper = !outside && is_positive(bound);
        let mut valid = false;
        for (at, rel) in self.relations.iter().enumerate() {
            let tally = &mut outcomes.tallies[at];
            // A side that makes no sense is skipped: the next is compared with the one before.
            let left_at = (0..=at).rev().find(|&i| values[i].is_ok());
            let (left, right) = match (left_at.map(|i| &values[i]), &values[at + 1]) {
                (Some(Ok(left)), Ok(right))
                    if left_at == Some(at)
                        || !may_skip(&values[at])
                            && self.relations[left_at.unwrap_or(at)..=at]
                                .iter()
                                .all(|rel| matches!(rel, Rel::Eq | Rel::Equiv | Rel::Define)) =>
                {
                    (left, right)
                }
                (_, Err(error)) | (Some(Err(error)), _) => {
                    if inner && error.code == Code::Arity && records[at + 1].mixed {
                        tally.mismatches.push((bound.to_vec(), error.message.clone()));
                    }
                    note_error(tally, error, inner);
                    continue;
                }
                _ => {
                    if let Err(error) = &values[at] {
                        note_error(tally, error, inner);
                    }
                    continue;
                }
            };
            tally.record.merge(&records[left_at.unwrap_or(at)]);
            tally.record.merge(&records[at + 1]);
            let conditions = Conditions { own: self.conditions, earlier: &self.facts.earlier };
            let outcome = conditions.compare(self, *rel, left, right, bound, degree, tally);
            // With B-splines an inequality may be meant for a part of the intervals.
            if around.is_some()
                && !matches!(rel, Rel::Eq | Rel::Equiv | Rel::Define)
                && matches!(outcome, Outcome::Fails(_))
            {
                tally.unclear.push("on which intervals it holds is not clear".to_owned());
                continue;
            }
            match outcome {
                // Where a spline vanishes there is nothing to see.
                Outcome::Holds
                    if around.is_some() && is_zero(left) && is_zero(right) && !self.says_zero(at) =>
                {
                    valid = true;
                }
                Outcome::Holds => {
                    valid = true;
                    tally.holds += 1;
                    tally.nonzero += usize::from(!is_zero(left));
                    tally.holds_inner += usize::from(inner);
                    let seen = !is_zero(left) || self.says_zero(at);
                    tally.holds_proper += usize::from(proper && seen);
                }
                // t = arcsin 0 = 0: what stands between is not understood.
                Outcome::Fails(_) if left_at != Some(at) => {
                    tally.unclear.push("the side before is not understood".to_owned());
                }
                Outcome::Fails(_) => {
                    valid = true;
                    tally.fails.push(Failure {
                        integers: bound.to_vec(),
                        degree,
                        around: around.clone(),
                        varies: self
                            .sides
                            .iter()
                            .any(|side| bases(side).iter().any(|name| is_variable(name))),
                        inner,
                        outside: outside
                            || degree
                                .is_some_and(|degree| free.iter().any(|(_, value)| *value > degree as i64)),
                        outcome,
                        left: left.clone(),
                        right: right.clone(),
                    });
                }
                // No weights have the sum 1 if there are none.
                Outcome::Unclear(why) => {
                    if !tally.unclear.contains(&why) && (inner || why != CANNOT_HOLD) {
                        tally.unclear.push(why);
                    }
                }
            }
        }
        valid
    }

    /// The values of the indices of a condition: those of the instance, and all small ones where the condition has
    /// indices of its own, as i and j in ℓ_i(x_j) = δ_{ij}.
    pub(in crate::judge) fn condition_instances(
        &self,
        condition: &Expr,
        bound: &[(String, i64)],
        degree: Option<usize>,
    ) -> Vec<Vec<(String, i64)>> {
        let own: Vec<String> = integer_names(condition)
            .into_iter()
            .filter(|name| is_index_letter(name) && !bound.iter().any(|(known, _)| known == name))
            .collect();
        if own.is_empty() || own.len() > 2 {
            return vec![bound.to_vec()];
        }
        let size = bound.iter().find(|(name, _)| roles::is_degree(name));
        let last =
            size.map(|(_, value)| *value).or(degree.map(|degree| degree as i64)).unwrap_or(3).clamp(0, 4);
        let at = self.facts.earlier.iter().position(|own| std::ptr::eq(own, condition));
        let ranges = at.and_then(|at| self.facts.ranges.get(at));
        let mut all = Vec::new();
        let mut values = vec![0i64; own.len()];
        loop {
            let more = own.iter().cloned().zip(values.iter().copied());
            let values_here: Vec<(String, i64)> = bound.iter().cloned().chain(more).collect();
            let names: Vec<(Symbol, Value)> = as_values(&values_here).collect();
            let within = |range: &Expr| {
                let held =
                    evaluator::machine().with_locals(names.clone(), |machine| Ok(holds(machine, range)));
                held.ok().flatten() != Some(false)
            };
            if ranges.is_none_or(|ranges| ranges.iter().all(within)) {
                all.push(values_here);
            }
            if !advance(&mut values, last) {
                return all;
            }
        }
    }

    /// Whether a side of a relation is the number 0.
    fn says_zero(&self, at: usize) -> bool {
        [self.sides[at], self.sides[at + 1]]
            .iter()
            .any(|side| matches!(&side.kind, Kind::Number(q) if q.is_zero()))
    }

    /// The values of the sides of one of the conditions of this trial in an instance, worked out once.
    pub(in crate::judge) fn condition_values(
        &self,
        condition: &Expr,
        bound: &[(String, i64)],
        degree: Option<usize>,
    ) -> Option<(Value, Value)> {
        let key = (std::ptr::from_ref(condition), bound.to_vec(), degree);
        if let Some(known) = self.memo.borrow().get(&key) {
            return known.clone();
        }
        let values = self.evaluated_condition(condition, bound, degree);
        self.memo.borrow_mut().insert(key, values.clone());
        values
    }

    /// A number in the range for which an earlier condition is said: t^3 = Σ d_i N_i(t) for 3 ≤ t ≤ 5.
    fn middle_of_range(&self, condition: &Expr) -> Option<Rational> {
        let at = self.facts.earlier.iter().position(|own| std::ptr::eq(own, condition))?;
        self.facts.ranges.get(at)?.iter().find_map(|range| {
            let Kind::Chain(from, links) = &range.kind else { return None };
            let [from, to] = match links.as_slice() {
                [link] if link.rel == Rel::In => interval(&link.expr)?.0,
                [name, to] if matches!(&name.expr.kind, Kind::Name(name) if is_variable(name)) => {
                    [from, &to.expr]
                }
                _ => return None,
            };
            Some((evaluator::number(from)? + evaluator::number(to)?) / integer(2))
        })
    }

    /// The values of the sides of a condition in an instance.
    pub(in crate::judge) fn evaluated_condition(
        &self,
        condition: &Expr,
        bound: &[(String, i64)],
        degree: Option<usize>,
    ) -> Option<(Value, Value)> {
        let Kind::Chain(left, links) = &condition.kind else { return None };
        let [link] = links.as_slice() else { return None };
        if link.rel != Rel::Eq || matches!(link.expr.kind, Kind::Range(..)) {
            return None;
        }
        let around = self.middle_of_range(condition);
        let breaks = match around {
            Some(_) => self.breaks(bound, &self.context.reached(&[condition], self.place)),
            None => Vec::new(),
        };
        let local = around.is_some();
        let reading = Rc::new(self.model(degree, around, &breaks));
        // The n of c_{i+1} = c_i + b_i/(n + 1) is the degree, as in what the page defines.
        let size = |name: &String| {
            roles::is_degree(name)
                && !bound.iter().any(|(own, _)| own == name)
                && self.context.number_in(name, self.place).is_none()
        };
        let sizes: Vec<(String, i64)> = match degree {
            Some(degree) => {
                bases(condition).into_iter().filter(size).map(|name| (name, degree as i64)).collect()
            }
            None => Vec::new(),
        };
        let names = || as_values(bound).chain(as_values(&sizes));
        let left = evaluate_reading(left, reading.clone(), names()).ok()?;
        let right = evaluate_reading(&link.expr, reading.clone(), names()).ok()?;
        let record = reading.take_record();
        // A piece of a spline is that of its own knots; of a function without a degree nothing is known.
        let open = local && record.any_knots || degree.is_none() && record.wants_degree;
        (!open).then_some((left, right))
    }
}

fn is_zero(value: &Value) -> bool {
    value.as_rational().is_some_and(|q| q.is_zero())
}

/// Whether a side could not be read or evaluated at all, so that the one before may take its place.
fn may_skip(value: &Result<Value, Diagnostic>) -> bool {
    // A side that makes no sense for these integers makes the instance invalid.
    matches!(value, Err(error) if matches!(error.code, Code::Domain | Code::Arity | Code::DivisionByZero))
}

fn note_error(tally: &mut Tally, error: &Diagnostic, inner: bool) {
    let misunderstood = matches!(
        error.code,
        Code::UnknownName
            | Code::UnknownFunction
            | Code::AmbiguousProduct
            | Code::AmbiguousVariable
            | Code::Unsupported
            | Code::NotPolynomial
    );
    if inner && misunderstood {
        tally.gap.get_or_insert_with(|| error.message.clone());
    }
    if !tally.errors.iter().any(|known| known.message == error.message) {
        tally.errors.push(error.clone());
    }
}
