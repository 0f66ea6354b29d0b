//! Trying a chain of relations on all small instances.
//!
//! An instance gives values to the integers of the chain (and to the degree of functions that are
//! not defined). In an instance each side is evaluated exactly; a side that makes no sense there,
//! such as a binomial of a negative number, makes the instance invalid for its relations only.

use std::collections::BTreeSet;
use std::rc::Rc;
use std::time::{Duration, Instant};

use super::compare::Outcome;
use super::conditions::{Conditions, LAST_INTERVAL, knots_around};
use super::context::{Context, is_variable};
use super::evaluator::{self, evaluate_reading};
use super::features::{has_divided_differences, has_groups, has_splines, highest_derivative, pairs};
use super::model::{Choices, Curve, Model, Record, holds};
use super::names::{Head, integer_names, walk};
use super::statement::Place;
use crate::budget::{self, Limits, Stop};
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// Degrees tried for functions without a definition, unless a derivative asks for more.
const LARGEST_DEGREE: usize = 4;

/// The largest value tried for an integer, by the number of integers.
const LARGEST: [i64; 6] = [0, 6, 4, 3, 2, 2];

/// More instances than this are not tried.
const MOST: usize = 260;

/// A part of the time that one formula may take; ample time if that is not limited.
pub fn share(limits: &Limits, part: u32) -> Duration {
    limits.time.unwrap_or(Duration::from_secs(60)) / part
}

/// What is tried.
pub struct Trial<'a> {
    /// The sides of the chain.
    pub sides: Vec<&'a Expr>,
    /// The relations between them.
    pub relations: Vec<Rel>,
    /// Conditions said with the chain.
    pub conditions: Vec<Expr>,
    /// Conditions said before, that may be needed.
    pub earlier: Vec<Expr>,
    /// Those of them that stand in the same section, the nearest first.
    pub hypotheses: Vec<Expr>,
    /// What is known.
    pub context: Rc<Context>,
    /// Where the chain stands.
    pub place: &'a Place,
    /// The curve that the sentence speaks of.
    pub curve: Option<Curve>,
    /// How ambiguous notations are read.
    pub choices: Choices,
    /// The limits of the chain.
    pub limits: Limits,
}

/// A failed instance.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Values of the integers.
    pub integers: Vec<(String, i64)>,
    /// The degree of functions without definition, if it was chosen.
    pub degree: Option<usize>,
    /// The knot interval of B-splines, if there are any.
    pub interval: Option<i64>,
    /// Whether nothing in it is extreme: indices neither at the ends nor outside.
    pub inner: bool,
    /// Whether an index is greater than a size.
    pub outside: bool,
    /// How the sides differ.
    pub outcome: Outcome,
    /// The values of the sides.
    pub left: Value,
    /// The values of the sides.
    pub right: Value,
}

/// How the instances of one relation went.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Instances in which it holds.
    pub holds: usize,
    /// Those among them in which the sides are not zero.
    pub nonzero: usize,
    /// Those among them in which nothing is extreme.
    pub holds_inner: usize,
    /// Instances in which it fails.
    pub fails: Vec<Failure>,
    /// Why instances could not be compared.
    pub unclear: Vec<String>,
    /// Instances, none of them extreme, in which a curve is given a wrong number of points.
    pub mismatches: Vec<(Vec<(String, i64)>, String)>,
    /// Errors in evaluating.
    pub errors: Vec<Diagnostic>,
    /// Failures in which the hypotheses say what the left side is.
    pub determined: usize,
    /// Whether an earlier condition was needed.
    pub condition: Option<usize>,
    /// What happened in the evaluations of its sides.
    pub record: Record,
}

/// How all instances went.
pub struct Outcomes {
    /// For each relation.
    pub tallies: Vec<Tally>,
    /// The integers that were given values.
    pub integers: Vec<String>,
    /// Whether the conditions give each of them its value.
    pub fixed: bool,
    /// Their largest values tried.
    pub largest: i64,
    /// Whether degrees were tried.
    pub degrees: bool,
    /// How many instances made sense.
    pub instances: usize,
}

impl Trial<'_> {
    /// The integers of the chain.
    pub fn integers(&self) -> Vec<String> {
        let mut names: BTreeSet<String> = BTreeSet::new();
        for side in &self.sides {
            names.extend(integer_names(side));
        }
        for condition in &self.conditions {
            // i = 0, …, n: its bound is an integer, too
            let own = integer_names(condition);
            let ranges = matches!(&condition.kind, Kind::Chain(_, links)
                if links.iter().any(|link| matches!(link.expr.kind, Kind::Range(..))));
            if ranges {
                names.extend(own);
            }
        }
        // n in a formula about P, where P(t) = Σ_{i=0}^n …
        let used: BTreeSet<String> = self.sides.iter().flat_map(|side| super::names::bases(side)).collect();
        for base in &used {
            for (_, definition, near) in self.context.visible(base, self.place) {
                if let (super::context::Body::Formula(body), true) = (&definition.body, near) {
                    let own: Vec<String> = definition
                        .head
                        .lower
                        .iter()
                        .chain(&definition.head.upper)
                        .flat_map(super::names::bases)
                        .collect();
                    names.extend(integer_names(body).into_iter().filter(|name| {
                        matches!(name.as_str(), "n" | "d" | "m" | "N")
                            && used.contains(name)
                            && !own.contains(name)
                    }));
                }
            }
        }
        // A name that is a variable of a function on a side is no integer.
        let mut arguments: BTreeSet<String> = BTreeSet::new();
        for side in &self.sides {
            walk(side, &mut |part| {
                if let Kind::Derivative { variables, .. } = &part.kind {
                    arguments.extend(variables.iter().filter_map(|(v, _)| Head::of(v)).map(|head| head.base));
                }
                if let Kind::Apply(callee, groups) = &part.kind
                    && Head::of(callee).is_some_and(|head| self.context.letters.is_function(&head.base))
                {
                    for argument in groups.iter().flatten() {
                        if let Kind::Name(name) = &argument.kind {
                            arguments.insert(name.clone());
                        }
                    }
                }
            });
        }
        names.retain(|name| !arguments.contains(name) && name != "e");
        names.into_iter().collect()
    }

    /// The value that a condition of the chain gives an integer: n = 2.
    fn fixed(&self, name: &str) -> Option<i64> {
        self.conditions.iter().find_map(|condition| match &condition.kind {
            Kind::Chain(left, links) if matches!(&left.kind, Kind::Name(own) if own == name) => {
                match links.as_slice() {
                    [link] if link.rel == Rel::Eq => evaluator::machine().eval_int(&link.expr).ok(),
                    _ => None,
                }
            }
            _ => None,
        })
    }

    /// A degree for which every derivative that is written is still alive.
    fn largest_degree(&self) -> usize {
        self.sides.iter().map(|side| highest_derivative(side) + 1).fold(LARGEST_DEGREE, usize::max)
    }

    /// Tries all small instances.
    pub fn run(&self) -> Outcomes {
        self.run_some(None)
    }

    fn run_some(&self, count: Option<usize>) -> Outcomes {
        let integers = self.integers();
        let splines = has_splines(&self.sides) || self.defined_by_splines();
        let largest = LARGEST.get(integers.len()).copied().unwrap_or(1);
        let largest = if splines { largest.min(3) } else { largest };
        let mut outcomes = Outcomes {
            tallies: self.relations.iter().map(|_| Tally::default()).collect(),
            integers: integers.clone(),
            fixed: false,
            largest,
            degrees: false,
            instances: 0,
        };
        if integers.len() > 8 {
            return outcomes;
        }
        let fixed: Vec<Option<i64>> = integers.iter().map(|name| self.fixed(name)).collect();
        outcomes.fixed = fixed.iter().all(Option::is_some);
        let opaque = has_divided_differences(&self.sides);
        let largest = if opaque { largest.min(3) } else { largest };
        outcomes.largest = largest;
        let mut all: Vec<Vec<i64>> = Vec::new();
        let mut values = vec![0i64; integers.len()];
        loop {
            let free = values.iter().zip(&fixed).all(|(value, fixed)| fixed.is_none() || *value == 0);
            if free {
                let own = values.iter().zip(&fixed).map(|(value, fixed)| fixed.unwrap_or(*value));
                all.push(own.collect());
            }
            if !advance(&mut values, largest) {
                break;
            }
        }
        // Small ones first: large ones are left out if they take long.
        all.sort_by_key(|values| values.iter().sum::<i64>());
        let start = Instant::now();
        let mut tried = 0;
        for values in all {
            let bound: Vec<(String, i64)> = integers.iter().cloned().zip(values).collect();
            if count.is_some() && !is_inner(&bound) || !self.allows(&bound) {
                continue;
            }
            if count.is_some_and(|count| tried >= count) {
                break;
            }
            tried += 1;
            let limits = Limits { time: Some(share(&self.limits, 16)), ..self.limits.clone() };
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
            if tried >= MOST || start.elapsed() > share(&self.limits, 32) {
                break;
            }
            budget::steps(1000);
        }
        outcomes
    }

    /// Tries a few instances only: the first in which nothing is extreme.
    pub fn first(&self, count: usize) -> Outcomes {
        let mut outcomes = self.run_some(Some(count));
        outcomes.largest = 0;
        outcomes
    }

    /// Whether the conditions on integers hold.
    fn allows(&self, bound: &[(String, i64)]) -> bool {
        let names: Vec<(Symbol, Value)> =
            bound.iter().map(|(name, value)| (Symbol::new(name), Value::int(*value))).collect();
        let restricts = |condition: &&Expr| {
            matches!(&condition.kind, Kind::Chain(left, links)
            if matches!(left.kind, Kind::Name(_))
                && links.iter().all(|link| link.rel != Rel::Eq && matches!(link.expr.kind, Kind::Number(_))))
        };
        self.conditions.iter().chain(self.hypotheses.iter().filter(restricts)).all(|condition| {
            // Conditions on other names than integers are used when sides are compared.
            let holds =
                evaluator::machine().with_locals(names.clone(), |machine| Ok(holds(machine, condition)));
            holds.ok().flatten() != Some(false)
        })
    }

    fn model(&self, degree: Option<usize>, interval: Option<i64>) -> Model {
        Model::new(self.context.clone(), self.place.clone(), self.choices, self.curve.clone())
            .with_degree(degree)
            .with_pairs(pairs(&self.sides))
            .opaque(has_divided_differences(&self.sides))
            .on_interval(interval, self.has_integer_knots())
            .with_tensor(has_groups(&self.sides))
    }

    /// Whether a function in it is defined by B-splines.
    fn defined_by_splines(&self) -> bool {
        self.sides.iter().flat_map(|side| super::names::bases(side)).any(|base| {
            self.context.visible(&base, self.place).next().is_some_and(|(_, definition, _)| {
                matches!(&definition.body, super::context::Body::Formula(body) if has_splines(&[body]))
            })
        })
    }

    /// Whether the notes define B-splines over the integers: i ≤ t < i + 1.
    fn has_integer_knots(&self) -> bool {
        let mut knots = false;
        let mut look = |expr: &Expr| {
            walk(expr, &mut |part| {
                knots = knots
                    || matches!(&part.kind, Kind::Subscript(base, _)
                        if matches!(&base.kind, Kind::Name(name) if matches!(name.as_str(), "t" | "u" | "x")));
            });
        };
        self.sides.iter().for_each(|side| look(side));
        let defined = self.context.visible("N", self.place).next();
        match defined.map(|(_, definition, _)| &definition.body) {
            Some(super::context::Body::Formula(body)) => {
                look(body);
                !knots
            }
            _ => false,
        }
    }

    /// The variables of the function on the left: in F(u) = … the name u stands for itself, whatever
    /// it meant before.
    fn variables(&self) -> Vec<String> {
        let mut found = Vec::new();
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
        let reading = Rc::new(model);
        let variables = self.variables();
        let mut records = Vec::with_capacity(self.sides.len());
        let mut values = Vec::with_capacity(self.sides.len());
        for side in &self.sides {
            let free = variables.iter().map(|name| (Symbol::new(name), Value::symbol(Symbol::new(name))));
            let knots = (-4..12)
                .filter(|_| reading.middle().is_some())
                .map(|j| (Symbol::new("t").numbered(j), Value::number(reading.knot(j))));
            let names = free
                .chain(knots)
                .chain(bound.iter().map(|(name, value)| (Symbol::new(name), Value::int(*value))));
            values.push(evaluate_reading(side, reading.clone(), names));
            records.push(reading.take_record());
        }
        (values, records)
    }

    fn instance(&self, bound: &[(String, i64)], splines: bool, outcomes: &mut Outcomes) {
        crate::budget::steps(64);
        // First the degrees: a polar form with m arguments is one of degree m.
        let mut degrees: Vec<Option<usize>> = vec![None];
        let first = splines.then_some(0);
        let (values, probe) = self.evaluate(self.model(None, first).discovering(), bound);
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
            let size = ["n", "d", "m", "N"]
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
            let inside = |interval: &i64| self.conditions.iter().all(|c| knots_around(c, bound, *interval));
            let intervals: Vec<Option<i64>> =
                if splines { (0..=LAST_INTERVAL).filter(inside).map(Some).collect() } else { vec![None] };
            let mut valid = false;
            for interval in intervals {
                let (values, records) = self.evaluate(self.model(degree, interval), bound);
                valid |= self.compare(bound, degree, interval, &values, &records, outcomes);
            }
            outcomes.instances += usize::from(valid);
        }
    }

    /// Compares neighbouring sides; says whether any two could be compared.
    fn compare(
        &self,
        bound: &[(String, i64)],
        degree: Option<usize>,
        interval: Option<i64>,
        values: &[Result<Value, Diagnostic>],
        records: &[Record],
        outcomes: &mut Outcomes,
    ) -> bool {
        let inner = is_inner(bound) && degree != Some(0);
        let mut valid = false;
        for (at, rel) in self.relations.iter().enumerate() {
            let tally = &mut outcomes.tallies[at];
            // A side that makes no sense is skipped: the next is compared with the one before.
            let left_at = (0..=at).rev().find(|&i| values[i].is_ok());
            let (left, right) = match (left_at.map(|i| &values[i]), &values[at + 1]) {
                (Some(Ok(left)), Ok(right))
                    if left_at == Some(at)
                        || (!may_skip(&values[at]) && matches!(rel, Rel::Eq | Rel::Equiv | Rel::Define)) =>
                {
                    (left, right)
                }
                (_, Err(error)) | (Some(Err(error)), _) => {
                    if inner && error.code == Code::Arity && records[at + 1].mixed {
                        tally.mismatches.push((bound.to_vec(), error.message.clone()));
                    }
                    note_error(tally, error);
                    continue;
                }
                _ => {
                    if let Err(error) = &values[at] {
                        note_error(tally, error);
                    }
                    continue;
                }
            };
            tally.record.merge(&records[left_at.unwrap_or(at)]);
            tally.record.merge(&records[at + 1]);
            let conditions = Conditions { own: &self.conditions, earlier: &self.earlier };
            let outcome = conditions.compare(self, *rel, left, right, bound, degree, tally);
            // With B-splines an inequality may be meant for a part of the intervals.
            if interval.is_some()
                && !matches!(rel, Rel::Eq | Rel::Equiv | Rel::Define)
                && matches!(outcome, Outcome::Fails(_))
            {
                tally.unclear.push("on which intervals it holds is not clear".to_owned());
                continue;
            }
            match outcome {
                Outcome::Holds => {
                    valid = true;
                    tally.holds += 1;
                    tally.nonzero +=
                        usize::from(!left.as_rational().is_some_and(|q| num_traits::Zero::is_zero(&q)));
                    tally.holds_inner += usize::from(inner);
                }
                Outcome::Fails(_) => {
                    valid = true;
                    tally.fails.push(Failure {
                        integers: bound.to_vec(),
                        degree,
                        interval,
                        inner,
                        outside: is_outside(bound),
                        outcome,
                        left: left.clone(),
                        right: right.clone(),
                    });
                }
                Outcome::Unclear(why) => {
                    if !tally.unclear.contains(&why) {
                        tally.unclear.push(why);
                    }
                }
            }
        }
        valid
    }

    /// The value of a condition's sides in an instance.
    pub(super) fn condition_values(
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
        let reading = Rc::new(self.model(degree, None));
        let names = || bound.iter().map(|(name, value)| (Symbol::new(name), Value::int(*value)));
        let left = evaluate_reading(left, reading.clone(), names()).ok()?;
        let right = evaluate_reading(&link.expr, reading, names()).ok()?;
        Some((left, right))
    }
}

/// Whether a side could not be read or evaluated at all, so that the one before may take its place.
fn may_skip(value: &Result<Value, Diagnostic>) -> bool {
    // A side that makes no sense for these integers makes the instance invalid.
    matches!(value, Err(error) if matches!(error.code, Code::Domain | Code::Arity | Code::DivisionByZero))
}

fn note_error(tally: &mut Tally, error: &Diagnostic) {
    if !tally.errors.iter().any(|known| known.message == error.message) {
        tally.errors.push(error.clone());
    }
}

/// Whether no index is at an end of its range, as far as names tell: sizes at least 2, indices
/// between 1 and the least size minus 1.
fn is_inner(bound: &[(String, i64)]) -> bool {
    let size = |name: &str| matches!(name, "n" | "m" | "d" | "N" | "M");
    let least = bound.iter().filter(|(name, _)| size(name)).map(|(_, value)| *value).min();
    bound.iter().all(|(name, value)| {
        if size(name) { *value >= 2 } else { *value >= 1 && least.is_none_or(|least| *value < least.max(2)) }
    })
}

/// Whether an index is greater than the least size.
fn is_outside(bound: &[(String, i64)]) -> bool {
    let size = |name: &str| matches!(name, "n" | "m" | "d" | "N" | "M");
    let least = bound.iter().filter(|(name, _)| size(name)).map(|(_, value)| *value).min();
    least.is_some_and(|least| bound.iter().any(|(name, value)| !size(name) && *value > least))
}

/// The next combination of values, the last one fastest; false after the last combination.
pub(super) fn advance(values: &mut [i64], largest: i64) -> bool {
    for value in values.iter_mut().rev() {
        if *value < largest {
            *value += 1;
            return true;
        }
        *value = 0;
    }
    false
}
