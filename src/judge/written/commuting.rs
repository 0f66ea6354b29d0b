//! Formulas with letters that need not commute: matrices, operators, elements of groups.
//!
//! **Definition.** Multiplied out with the factors in their order, a formula is a combination of *words* of its letters. Two
//! formulas with the same words are equal in every ring; what needs more holds for numbers only.

use std::collections::{BTreeMap, BTreeSet};

use crate::formula::{Expr, Kind, Sign};
use crate::language::write;
use crate::math::number::Rational;
use num_traits::{One, Zero};

/// Words with the numbers before them, none of them 0.
type Words = BTreeMap<Vec<String>, Rational>;

/// More words, or longer ones, are not made.
const MOST_WORDS: usize = 400;
const HIGHEST_POWER: i64 = 6;

/// The letters whose order matters for two sides that are equal for numbers: those in words that only one of them has.
/// Nothing if the sides have the same words, or are more than sums, products and powers.
///
/// Cost: the number of words, at most [`MOST_WORDS`] for each product.
pub(in crate::judge) fn letters_in_order(left: &Expr, right: &Expr) -> BTreeSet<String> {
    let (Some(left), Some(right)) = (words(left), words(right)) else { return BTreeSet::new() };
    // What holds by what the page says does not show in its letters.
    if sorted(&left) != sorted(&right) {
        return BTreeSet::new();
    }
    let differs = |(word, value): (&Vec<String>, &Rational), other: &Words| other.get(word) != Some(value);
    let one = left.iter().filter(|pair| differs(*pair, &right)).map(|(word, _)| word);
    let other = right.iter().filter(|pair| differs(*pair, &left)).map(|(word, _)| word);
    one.chain(other).filter(|word| word.len() > 1).flatten().cloned().collect()
}

/// The same for letters that commute.
fn sorted(words: &Words) -> Words {
    let mut sum = Words::new();
    for (word, value) in words {
        let mut word = word.clone();
        word.sort();
        *sum.entry(word).or_insert_with(Rational::zero) += value;
    }
    sum.retain(|_, value| !value.is_zero());
    sum
}

fn words(expr: &Expr) -> Option<Words> {
    let mut sum = Words::new();
    match &expr.kind {
        Kind::Group(inner) => return words(inner),
        Kind::Number(q) => add(&mut sum, Vec::new(), q.clone()),
        Kind::Add(terms) => {
            for term in terms {
                for (word, value) in words(&term.expr)? {
                    add(&mut sum, word, if term.sign == Sign::Plus { value } else { -value });
                }
            }
        }
        Kind::Mul(factors) => {
            sum.insert(Vec::new(), Rational::one());
            for factor in factors {
                sum = product(&sum, &words(factor)?)?;
            }
        }
        Kind::Pow(base, exponent) => match exponent.as_signed_int() {
            Some(power) if (0..=HIGHEST_POWER).contains(&power) => {
                let base = words(base)?;
                sum.insert(Vec::new(), Rational::one());
                for _ in 0..power {
                    sum = product(&sum, &base)?;
                }
            }
            // (ab)^{-1} is b^{-1} a^{-1}
            Some(-1) => {
                let base = words(base)?;
                let mut base = base.into_iter();
                let (Some((word, value)), None) = (base.next(), base.next()) else { return None };
                let inverse = |letter: &String| match letter.strip_suffix("⁻¹") {
                    Some(letter) => letter.to_owned(),
                    None => format!("{letter}⁻¹"),
                };
                add(&mut sum, word.iter().rev().map(inverse).collect(), value.recip());
            }
            _ => return None,
        },
        Kind::Name(_) | Kind::Subscript(..) | Kind::Accent(..) => {
            add(&mut sum, vec![write::text(expr)], Rational::one());
        }
        _ => return None,
    }
    Some(sum)
}

fn add(sum: &mut Words, mut word: Vec<String>, value: Rational) {
    // a a^{-1} is 1.
    while let Some(at) = word.windows(2).position(|pair| {
        pair[0].strip_suffix("⁻¹") == Some(&pair[1]) || pair[1].strip_suffix("⁻¹") == Some(&pair[0])
    }) {
        word.drain(at..at + 2);
    }
    let entry = sum.entry(word.clone()).or_insert_with(Rational::zero);
    *entry += value;
    if entry.is_zero() {
        sum.remove(&word);
    }
}

fn product(left: &Words, right: &Words) -> Option<Words> {
    if left.len() * right.len() > MOST_WORDS {
        return None;
    }
    let mut sum = Words::new();
    for (one, a) in left {
        for (other, b) in right {
            add(&mut sum, one.iter().chain(other).cloned().collect(), a * b);
        }
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::latex;

    fn ordered(left: &str, right: &str) -> Vec<String> {
        let [left, right] = [left, right].map(|text| latex::read(text).unwrap());
        letters_in_order(&left, &right).into_iter().collect()
    }

    #[test]
    fn what_holds_in_every_ring_needs_no_order() {
        for (left, right) in [
            ("(A+B)^2", "A^2+AB+BA+B^2"),
            ("A(B+C)", "AB+AC"),
            ("(AB)^{-1}", "B^{-1}A^{-1}"),
            ("ABB^{-1}", "A"),
            ("(A-B)(A+B)", "A^2+AB-BA-B^2"),
            ("2A", "A+A"),
        ] {
            assert!(ordered(left, right).is_empty(), "{left} = {right}");
        }
    }

    #[test]
    fn what_holds_for_numbers_only_names_its_letters() {
        assert_eq!(ordered("(A+B)^2", "A^2+2AB+B^2"), ["A", "B"]);
        assert_eq!(ordered("(ab)^{-1}", "a^{-1}b^{-1}"), ["a⁻¹", "b⁻¹"]);
        assert_eq!(ordered("E_{ij}E_{kl}", "E_{kl}E_{ij}").len(), 2);
    }
}
