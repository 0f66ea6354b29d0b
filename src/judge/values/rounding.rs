//! Decimal numbers: as far as the digits that are shown.

use crate::judge::values::roots;
use crate::language::value::{Judgement, Value, Verdict};
use crate::math::number::{Rational, integer, rational};
use num_traits::{Signed, Zero};

/// Between which numbers a number is.
type Bounds = (Rational, Rational);

/// `a ≈ b` for numbers: b is a rounded or cut off, to the last digit that b shows, or the other way round.
///
/// That is proved. Refuted is what is more than twice as large or of another sign, and what differs from the right
/// digits in one or two that are not the last; how near `≈` means else is not said.
pub(in crate::judge) fn approximation(judgement: &mut Judgement) {
    let sides = (bounds(&judgement.left), bounds(&judgement.right));
    let (Some(left), Some(right)) = sides else {
        judgement.reasons.push("what ≈ means is known for numbers only".to_owned());
        return;
    };
    if judgement.left == judgement.right || shows(&right, &left) || shows(&left, &right) {
        judgement.verdict = Verdict::Proved;
    } else if are_far(&left, &right) {
        judgement.verdict = Verdict::Refuted;
        judgement.reasons.push("one is more than twice the other".to_owned());
    } else if let Some(digits) = misprint(&right, &left).or_else(|| misprint(&left, &right)) {
        judgement.verdict = Verdict::Refuted;
        judgement.reasons.push(format!("to as many digits it is {digits}"));
    } else {
        judgement.reasons.push("they differ in the digits that are shown".to_owned());
    }
}

/// Bounds for a number, equal ones for a rational number, else very near each other.
fn bounds(value: &Value) -> Option<Bounds> {
    if let Some(q) = value.as_rational() {
        return Some((q.clone(), q));
    }
    match value {
        Value::Algebraic(root) => Some(root.number.refined(&num_traits::pow(rational(1, 10), 40)).ends()),
        Value::Scalar(formula) => roots::bounds(formula),
        _ => None,
    }
}

/// Whether one is a decimal that shows the other: within half of the unit of its last digit, or cut off after it.
fn shows((shown, end): &Bounds, (low, high): &Bounds) -> bool {
    let Some(unit) = last_digit(shown).filter(|_| shown == end) else { return false };
    let between = |from: Rational, to: Rational| from <= *low && *high <= to;
    let half = &unit / integer(2);
    let (from, to) =
        if shown.is_negative() { (shown - &unit, shown.clone()) } else { (shown.clone(), shown + &unit) };
    between(shown - &half, shown + &half) || between(from, to)
}

/// Whether the signs differ, or one number is more than twice the other.
fn are_far(left: &Bounds, right: &Bounds) -> bool {
    let above = |(low, _): &Bounds, (_, high): &Bounds| low.is_positive() && *low > high * integer(2);
    let below = |(_, high): &Bounds, (low, _): &Bounds| high.is_negative() && *high < low * integer(2);
    let zero = |(low, high): &Bounds| !low.is_positive() && !high.is_negative();
    let apart = |a: &Bounds, b: &Bounds| above(a, b) || below(a, b);
    !zero(left) && !zero(right) && (apart(left, right) || apart(right, left))
}

/// The digits that a decimal should show, if one or two of at least three are wrong, and not only the last.
fn misprint((shown, end): &Bounds, (low, _): &Bounds) -> Option<String> {
    let unit = last_digit(shown).filter(|_| shown == end)?;
    let right = (low / &unit).round();
    let wrong = shown / &unit;
    let long = wrong.abs() >= integer(100);
    let apart = (&right - &wrong).abs() > integer(10);
    (long && apart && misprinted(&wrong, &right)).then(|| decimal(&(right * unit)))
}

/// Whether a number of several digits is another one with a digit or two wrong, or with its sign lost.
pub(in crate::judge) fn misprinted(wrong: &Rational, value: &Rational) -> bool {
    let digits = |q: &Rational| q.numer().to_string().trim_start_matches('-').to_owned();
    let (a, b) = (digits(wrong), digits(value));
    let differing = a.chars().zip(b.chars()).filter(|(x, y)| x != y).count();
    wrong.denom() == value.denom() && a.len() == b.len() && a.len() > 1 && differing <= 2.min(a.len() - 1)
}

/// A number with finitely many decimal digits, as one writes it.
fn decimal(q: &Rational) -> String {
    let (mut scaled, mut places) = (q.abs(), 0);
    while !scaled.is_integer() {
        scaled *= integer(10);
        places += 1;
    }
    let digits = format!("{:0>width$}", scaled.to_integer().to_string(), width = places + 1);
    let (whole, rest) = digits.split_at(digits.len() - places);
    let sign = if q.is_negative() { "-" } else { "" };
    if rest.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{rest}") }
}

/// The value of the last decimal digit of a number: 1/1000 for 1.053, 100 for 1700; nothing for 1/3.
pub(in crate::judge) fn last_digit(q: &Rational) -> Option<Rational> {
    let ten = integer(10);
    let (mut digit, mut scaled) = (integer(1), q.clone());
    for _ in 0..400 {
        if scaled.is_integer() {
            break;
        }
        scaled *= &ten;
        digit /= &ten;
    }
    if !scaled.is_integer() || scaled.is_zero() {
        return (scaled.is_integer()).then_some(digit);
    }
    let mut shorter = &scaled / &ten;
    while digit >= integer(1) && shorter.is_integer() {
        digit *= &ten;
        shorter /= &ten;
    }
    Some(digit)
}
