//! Decimal numbers: as far as the digits that are shown.

use crate::language::value::{Judgement, Verdict};
use crate::math::number::{Rational, integer};
use crate::math::poly::RealRoot;
use num_traits::{Signed, Zero};

/// `a ≈ b` for numbers: b is a rounded or cut off, to the last digit that b shows, or the other way round.
///
/// That is proved or, where one is more than twice the other, refuted; how near `≈` means else is not said.
pub(super) fn approximation(judgement: &mut Judgement) {
    let sides = (judgement.left.as_real(), judgement.right.as_real());
    let (Some(left), Some(right)) = sides else {
        judgement.reasons.push("what ≈ means is known for numbers only".to_owned());
        return;
    };
    let shows = |number: &RealRoot, shown: &RealRoot| match shown {
        RealRoot::Rational(shown) => is_shown(number, shown),
        RealRoot::Irrational(_) => false,
    };
    if left == right || shows(&left, &right) || shows(&right, &left) {
        judgement.verdict = Verdict::Proved;
    } else if are_far(&left, &right) {
        judgement.verdict = Verdict::Refuted;
        judgement.reasons.push("one is more than twice the other".to_owned());
    } else {
        judgement.reasons.push("they differ in the digits that are shown".to_owned());
    }
}

/// Whether a decimal shows a number: within half of the unit of its last digit, or cut off after it.
fn is_shown(number: &RealRoot, shown: &Rational) -> bool {
    let Some(unit) = last_digit(shown) else { return false };
    let between = |from: Rational, to: Rational| {
        RealRoot::Rational(from) <= *number && *number <= RealRoot::Rational(to)
    };
    let half = &unit / integer(2);
    let (from, to) =
        if shown.is_negative() { (shown - &unit, shown.clone()) } else { (shown.clone(), shown + &unit) };
    between(shown - &half, shown + &half) || between(from, to)
}

/// Whether the signs differ, or one number is more than twice the other.
fn are_far(left: &RealRoot, right: &RealRoot) -> bool {
    let (RealRoot::Rational(left), RealRoot::Rational(right)) = (left, right) else { return false };
    if left.is_zero() || right.is_zero() {
        return false;
    }
    let two = integer(2);
    left.is_positive() != right.is_positive()
        || left.abs() > right.abs() * &two
        || right.abs() > left.abs() * &two
}

/// The value of the last decimal digit of a number: 1/1000 for 1.053, 100 for 1700; nothing for 1/3.
pub(super) fn last_digit(q: &Rational) -> Option<Rational> {
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
