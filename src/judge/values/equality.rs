//! Comparing two values: is `a = b` so for all values of their symbols, and if not, why?

use crate::formula::Rel;
use crate::judge::values::inequality::{self, Decision, Range};
use crate::judge::values::rounding;
use crate::judge::values::same_geometry::{self, Comparison};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::ops::errors::division_by_zero;
use crate::language::ops::polar::{expand_polar, laws_report};
use crate::language::value::{Function, Judgement, Polar, PolarKind, Value, Verdict, Witness};
use crate::math::blossom::laws::ArgumentNames;
use crate::math::number::{Rational, integer};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::{Signed, Zero};

/// Judges one relation between two values.
pub fn judge(rel: Rel, left: &Value, right: &Value) -> Result<Judgement, Diagnostic> {
    let mut judgement = Judgement {
        rel,
        left: left.clone(),
        right: right.clone(),
        verdict: Verdict::Undecided,
        difference: None,
        witness: None,
        reasons: Vec::new(),
    };
    match rel {
        Rel::Eq | Rel::Equiv | Rel::Define => equality(&mut judgement)?,
        Rel::Ne => {
            equality(&mut judgement)?;
            judgement.verdict = match judgement.verdict {
                Verdict::Proved => Verdict::Refuted,
                Verdict::Refuted if numbers(left, right) => Verdict::Proved,
                _ => Verdict::Undecided,
            };
        }
        Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge => order(&mut judgement),
        Rel::Approx => rounding::approximation(&mut judgement),
        Rel::In => {
            if let Value::List(items) = right {
                let member = items.iter().any(|item| item == left);
                let constant = left.as_rational().is_some();
                judgement.verdict = match (member, constant) {
                    (true, _) => Verdict::Proved,
                    (false, true) => Verdict::Refuted,
                    _ => Verdict::Undecided,
                };
            }
        }
        _ => {
            return Err(Diagnostic::error(Code::Unsupported, "this relation cannot be checked")
                .hint("equations and inequalities between numbers can be"));
        }
    }
    if judgement.verdict == Verdict::Undecided && judgement.reasons.is_empty() {
        judgement.reasons.push("it was not decided for all values of the symbols".to_owned());
    }
    Ok(judgement)
}

/// Whether both sides are numbers.
fn numbers(left: &Value, right: &Value) -> bool {
    left.as_real().is_some() && right.as_real().is_some()
}

fn order(judgement: &mut Judgement) {
    let rel = judgement.rel;
    let holds = |a: &Rational, b: &Rational| match rel {
        Rel::Lt => a < b,
        Rel::Le => a <= b,
        Rel::Gt => a > b,
        _ => a >= b,
    };
    if let (Some(a), Some(b)) = (judgement.left.as_real(), judgement.right.as_real()) {
        let holds = match rel {
            Rel::Lt => a < b,
            Rel::Le => a <= b,
            Rel::Gt => a > b,
            _ => a >= b,
        };
        judgement.verdict = if holds { Verdict::Proved } else { Verdict::Refuted };
        return;
    }
    let (Some(a), Some(b)) = (judgement.left.as_scalar(), judgement.right.as_scalar()) else { return };
    let Some((positive, strict)) = inequality::positive(judgement) else { return };
    if let Some(d) = positive.as_rational() {
        let true_everywhere = d.is_positive() || d.is_zero() && !strict;
        judgement.verdict = if true_everywhere { Verdict::Proved } else { Verdict::Refuted };
        return;
    }
    if positive.variables().len() > 1 && inequality::holds_by_squares(&positive, strict) {
        judgement.verdict = Verdict::Proved;
        return;
    }
    let witness = match inequality::decide(&positive, strict, &Range::default()) {
        Some(Decision::Holds) => {
            judgement.verdict = Verdict::Proved;
            return;
        }
        Some(Decision::Zero(root)) => {
            judgement.reasons.push(format!("the sides are equal at the root of {root}"));
            return;
        }
        Some(Decision::Fails(point)) => {
            let put = |f: &Fraction| f.value(&|_| Some(point.clone()));
            let assignment = positive.variables().into_iter().map(|s| (s, point.clone())).collect();
            put(a).zip(put(b)).map(|(left, right)| Witness { assignment, left, right })
        }
        // One counterexample is enough to refute; none proves nothing.
        _ => find_witness(a, b, |x, y| !holds(x, y)),
    };
    if let Some(witness) = witness {
        judgement.witness = Some(witness);
        judgement
            .reasons
            .push("it fails for some values; give the range if it is meant for a part".to_owned());
    }
}

fn equality(judgement: &mut Judgement) -> Result<(), Diagnostic> {
    let (left, right) = (judgement.left.clone(), judgement.right.clone());
    match (&left, &right) {
        (Value::Algebraic(_), _) | (_, Value::Algebraic(_))
            if let (Some(a), Some(b)) = (left.as_real(), right.as_real()) =>
        {
            judgement.verdict = if a == b { Verdict::Proved } else { Verdict::Refuted };
        }
        (Value::Scalar(a), Value::Scalar(b)) | (Value::Vector(a), Value::Vector(b)) => {
            equal_scalars(judgement, a, b);
        }
        // A row times a column is a number.
        (Value::Matrix(a), Value::Scalar(b)) if a.shape() == (1, 1) => {
            equal_scalars(judgement, &a[(0, 0)], b)
        }
        (Value::Scalar(a), Value::Matrix(b)) if b.shape() == (1, 1) => {
            equal_scalars(judgement, a, &b[(0, 0)])
        }
        (Value::List(a), Value::List(b)) => {
            if a.len() != b.len() {
                judgement.verdict = Verdict::Refuted;
                judgement.reasons.push(format!("one list has {} items, the other {}", a.len(), b.len()));
                return Ok(());
            }
            each(
                judgement,
                a.iter()
                    .zip(b)
                    .enumerate()
                    .map(|(i, (x, y))| (format!("item {i} (counted from 0)"), x.clone(), y.clone())),
            )?;
        }
        // A column of coordinates is a point.
        (Value::List(_), Value::Matrix(column)) | (Value::Matrix(column), Value::List(_))
            if column.ncols() == 1 =>
        {
            let list = |side: Value| side.clone().coordinates().map_or(side, Value::list);
            (judgement.left, judgement.right) = (list(left), list(right));
            equality(judgement)?;
        }
        (Value::Matrix(a), Value::Matrix(b)) => {
            if a.shape() != b.shape() {
                judgement.verdict = Verdict::Refuted;
                judgement.reasons.push(format!(
                    "one matrix is {}x{}, the other {}x{}",
                    a.nrows(),
                    a.ncols(),
                    b.nrows(),
                    b.ncols()
                ));
                return Ok(());
            }
            let entries = (0..a.nrows()).flat_map(|i| (0..a.ncols()).map(move |j| (i, j)));
            each(
                judgement,
                entries.map(|(i, j)| {
                    let place = format!("entry ({}, {})", i + 1, j + 1);
                    (place, Value::Scalar(a[(i, j)].clone()), Value::Scalar(b[(i, j)].clone()))
                }),
            )?;
        }
        (Value::Polar(a), Value::Polar(b)) => {
            if a == b {
                judgement.verdict = Verdict::Proved;
            } else {
                judgement.verdict = Verdict::Refuted;
                judgement.reasons.push(polar_difference(a, b));
            }
        }
        (Value::Function(f), Value::Function(g)) => equal_functions(judgement, f, g)?,
        (Value::Polar(f), Value::Function(g)) | (Value::Function(g), Value::Polar(f)) => {
            polar_against_function(judgement, f, g)?;
        }
        (Value::Geometry(a), Value::Geometry(b)) => match same_geometry::compare(a, b) {
            Comparison::Same => judgement.verdict = Verdict::Proved,
            Comparison::Different(reason) => {
                judgement.verdict = Verdict::Refuted;
                judgement.reasons.push(reason);
            }
            Comparison::Unknown(reason) => judgement.reasons.push(reason.to_owned()),
        },
        (Value::Piecewise(a), Value::Piecewise(b)) => {
            let same = a.function.merged() == b.function.merged();
            judgement.verdict = if same { Verdict::Proved } else { Verdict::Refuted };
        }
        (Value::Text(a), Value::Text(b)) => {
            judgement.verdict = if a == b { Verdict::Proved } else { Verdict::Refuted };
        }
        (a, b) => {
            judgement.reasons.push(format!("{} and {} cannot be compared", a.kind(), b.kind()));
        }
    }
    Ok(())
}

fn equal_scalars(judgement: &mut Judgement, a: &Fraction, b: &Fraction) {
    let difference = a.minus(b);
    if difference.is_zero() {
        judgement.verdict = Verdict::Proved;
        return;
    }
    judgement.verdict = Verdict::Refuted;
    judgement.witness = find_witness(a, b, |x, y| x != y);
    judgement.difference = Some(Value::Scalar(difference));
}

/// Judges a family of equations; the first that fails speaks for all.
fn each(
    judgement: &mut Judgement,
    parts: impl Iterator<Item = (String, Value, Value)>,
) -> Result<(), Diagnostic> {
    judgement.verdict = Verdict::Proved;
    for (place, x, y) in parts {
        let part = judge(Rel::Eq, &x, &y)?;
        match part.verdict {
            Verdict::Proved => {}
            Verdict::Refuted => {
                judgement.verdict = Verdict::Refuted;
                judgement.reasons = std::iter::once(format!("{place} differs")).chain(part.reasons).collect();
                judgement.difference = part.difference;
                judgement.witness = part.witness;
                return Ok(());
            }
            Verdict::Sampled | Verdict::Undecided => {
                judgement.verdict = part.verdict;
                judgement.reasons = part.reasons;
            }
        }
    }
    Ok(())
}

fn equal_functions(judgement: &mut Judgement, f: &Function, g: &Function) -> Result<(), Diagnostic> {
    if f == g {
        judgement.verdict = Verdict::Proved;
        return Ok(());
    }
    let (Some((names, a)), Some((others, b))) = (f.as_formula_of_many(), g.as_formula_of_many()) else {
        judgement.reasons.push("functions given by cases are not compared".to_owned());
        return Ok(());
    };
    if names.len() != others.len() {
        judgement.verdict = Verdict::Refuted;
        judgement.reasons.push(format!(
            "one function takes {} arguments, the other {}",
            names.len(),
            others.len()
        ));
        return Ok(());
    }
    let renaming: Vec<(Symbol, Fraction)> = others
        .iter()
        .zip(&names)
        .map(|(other, name)| ((*other).clone(), Fraction::from(MultiPoly::symbol((*name).clone()))))
        .collect();
    let b = b.substitute(&renaming).map_err(|_| division_by_zero())?;
    equal_scalars(judgement, a, &b);
    Ok(())
}

fn polar_against_function(
    judgement: &mut Judgement,
    polar: &Polar,
    function: &Function,
) -> Result<(), Diagnostic> {
    let Some((names, formula)) = function.as_formula_of_many() else {
        judgement.reasons.push("functions given by cases are not compared".to_owned());
        return Ok(());
    };
    let groups = polar.arity();
    let dimension = match &polar.kind {
        PolarKind::Total(form) => form.dimension(),
        _ => 1,
    };
    let arguments = function.shape.inner;
    if function.shape.dimension.max(1) != dimension || arguments != groups.iter().sum::<usize>() {
        judgement.verdict = Verdict::Refuted;
        judgement.reasons.push(format!(
            "the polar form takes {} arguments, the function {}",
            groups.iter().sum::<usize>(),
            arguments
        ));
        return Ok(());
    }
    let mut names = names.chunks(dimension).map(|point| point.iter().map(|name| (*name).clone()).collect());
    let lists = groups.iter().map(|&count| names.by_ref().take(count).collect()).collect();
    let arrangement = ArgumentNames::new(lists);
    if let Some(expanded) = expand_polar(polar, &arrangement) {
        equal_scalars(judgement, &Fraction::from(expanded), formula);
        if judgement.verdict == Verdict::Refuted {
            judgement.reasons = laws_report(polar, formula, &arrangement);
        }
    }
    Ok(())
}

fn polar_difference(a: &Polar, b: &Polar) -> String {
    match (&a.kind, &b.kind) {
        (PolarKind::Univariate(f), PolarKind::Univariate(g)) if f.degree() != g.degree() => {
            format!("the degrees are {} and {}", f.degree(), g.degree())
        }
        (PolarKind::Univariate(f), PolarKind::Univariate(g)) => {
            let place = f.coefficients().iter().zip(g.coefficients()).position(|(x, y)| x != y);
            match place {
                Some(i) => format!(
                    "the coefficients of power {i} are {} and {}",
                    f.coefficients()[i],
                    g.coefficients()[i]
                ),
                None => "they differ".to_owned(),
            }
        }
        _ => "they are polar forms of different polynomials or kinds".to_owned(),
    }
}

/// All symbols of a value.
pub fn symbols(value: &Value) -> Vec<Symbol> {
    let mut found: Vec<Symbol> = match value {
        Value::Scalar(formula) | Value::Vector(formula) => formula.variables(),
        Value::List(items) => items.iter().flat_map(symbols).collect(),
        Value::Matrix(matrix) => matrix.iter().flat_map(Fraction::variables).collect(),
        _ => Vec::new(),
    };
    found.sort();
    found.dedup();
    found
}

/// The differences of the entries of two values.
pub fn differences(a: &Value, b: &Value) -> Option<Vec<Fraction>> {
    Some(match (a, b) {
        (Value::Scalar(a), Value::Scalar(b)) | (Value::Vector(a), Value::Vector(b)) => vec![a.minus(b)],
        (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => {
            a.iter().zip(b.iter()).map(|(x, y)| x.minus(y)).collect()
        }
        (Value::List(a), Value::List(b)) if a.len() == b.len() => {
            let parts: Option<Vec<Vec<Fraction>>> = a.iter().zip(b).map(|(x, y)| differences(x, y)).collect();
            parts?.concat()
        }
        _ => return None,
    })
}

/// Small values to try, simple ones first.
const TRIALS: [i64; 12] = [0, 1, 2, -1, 3, 5, -2, 7, 11, -5, 13, 17];

/// Beyond this degree only the simplest values are tried.
const HIGHEST_DEGREE: u32 = 2000;

/// Values of the symbols at which `wanted(left, right)` holds, checked by substitution.
fn find_witness(
    a: &Fraction,
    b: &Fraction,
    wanted: impl Fn(&Rational, &Rational) -> bool,
) -> Option<Witness> {
    let mut symbols = a.variables();
    symbols.extend(b.variables());
    symbols.sort();
    symbols.dedup();
    // Powers of large degree are tried at 0, 1 and −1 only, where they stay small.
    let degree = |f: &Fraction| f.numerator().total_degree().max(f.denominator().total_degree());
    let high = degree(a).max(degree(b)).is_some_and(|d| d > HIGHEST_DEGREE);
    let trials: &[i64] = if high { &[0, 1, -1] } else { &TRIALS };
    for round in 0..trials.len() * 8 {
        crate::budget::steps(16);
        // Round 0 is all zeros; later rounds walk through the trial values at different speeds.
        let assignment: Vec<(Symbol, Rational)> = symbols
            .iter()
            .enumerate()
            .map(|(i, symbol)| {
                let value = match trials.get(round) {
                    Some(&value) => value,
                    None if high => trials[(round * (i + 1) + i * i) % trials.len()],
                    None => trials[(round * (i + 1) + i * i) % trials.len()] + (round / trials.len()) as i64,
                };
                (symbol.clone(), integer(value))
            })
            .collect();
        let at = |f: &Fraction| {
            f.value(&|symbol: &Symbol| {
                assignment.iter().find(|(name, _)| name == symbol).map(|(_, value)| value.clone())
            })
        };
        if let (Some(left), Some(right)) = (at(a), at(b))
            && wanted(&left, &right)
        {
            return Some(Witness { assignment, left, right });
        }
    }
    None
}
