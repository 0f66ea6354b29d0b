//! How the instances of a chain went.

use crate::judge::model::Record;
use crate::judge::values::compare::Outcome;
use crate::language::diagnostic::Diagnostic;
use crate::language::value::Value;
use crate::math::number::Rational;

/// A failed instance.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Values of the integers.
    pub integers: Vec<(String, i64)>,
    /// The degree of functions without definition, if it was chosen.
    pub degree: Option<usize>,
    /// The parameter near which piecewise polynomials were considered.
    pub around: Option<Rational>,
    /// Whether that parameter says where it fails: of numbers it says nothing.
    pub varies: bool,
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

impl Failure {
    /// Left minus right, after all that is known, if that is one value.
    pub fn difference(&self) -> Option<&Value> {
        match &self.outcome {
            Outcome::Fails(judgement) => judgement.difference.as_ref(),
            _ => None,
        }
    }

    /// Whether the sides differ by a number, after all that is known.
    pub fn differs_by_a_number(&self) -> bool {
        self.difference().is_some_and(|value| value.as_rational().is_some())
    }
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
    /// Those among them with positive integers, none of them beyond a size, and sides that are not zero unless it says so.
    pub holds_proper: usize,
    /// Instances in which it fails.
    pub fails: Vec<Failure>,
    /// Why instances could not be compared.
    pub unclear: Vec<String>,
    /// Instances, none of them extreme, in which a curve is given a wrong number of points.
    pub mismatches: Vec<(Vec<(String, i64)>, String)>,
    /// Errors in evaluating.
    pub errors: Vec<Diagnostic>,
    /// Why instances, none of them extreme, could not be computed though nothing is wrong with their numbers.
    pub gap: Option<String>,
    /// Failures in which the hypotheses say what the left side is.
    pub determined: usize,
    /// Failures for the general solution of all that is said of functions that agree.
    pub related: usize,
    /// Failures in which they say what other members of its family are, but leave it open.
    pub beyond: usize,
    /// Whether numbers were put for names.
    pub sampled: bool,
    /// Whether an earlier condition was needed.
    pub condition: Option<usize>,
    /// What happened in the evaluations of its sides.
    pub record: Record,
}

impl Tally {
    /// Whether it is about two functions that words introduced and of which no more is known.
    pub fn is_of_two_functions(&self) -> bool {
        self.record.unknown.len() > 1
    }
}

/// How all instances went.
#[derive(Clone)]
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
    /// Whether not all of them were tried.
    pub cut: bool,
    /// How many instances made sense.
    pub instances: usize,
}
