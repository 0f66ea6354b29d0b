//! Formulas as they are written, nothing multiplied out: equations between sides that are equal so say nothing.

use std::collections::BTreeMap;

use crate::formula::{Expr, Kind, Sign};
use crate::judge::written::names::walk;
use crate::language::write;
use crate::math::number::Rational;
use num_traits::{One, Zero};

/// Factors with their powers.
type Product = Vec<(String, i64)>;

/// Products with the numbers before them, none of them 0.
type Bare = BTreeMap<Product, Rational>;

/// Whether something is taken from itself or multiplied by 0: a - a, 0 a.
pub(in crate::judge) fn vanishes(expr: &Expr) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        found |= match &part.kind {
            Kind::Add(_) => bare(part).is_empty(),
            Kind::Mul(factors) => factors.iter().any(|factor| bare(factor).is_empty()),
            _ => false,
        };
    });
    found
}

/// Whether the sides are products of the same letters in another order: gH = Hg. Of numbers nobody says that.
pub(in crate::judge) fn only_commutes(left: &Expr, right: &Expr) -> bool {
    let (mut one, mut other) = (Vec::new(), Vec::new());
    letters(left, 1, &mut one)
        && letters(right, 1, &mut other)
        && one != other
        && powers(&one) == powers(&other)
        && one.iter().chain(&other).any(|(name, _)| *name != one[0].0)
}

/// Whether a product of powers of letters has a letter again after another one: r s r s. Of numbers nobody writes that.
pub(in crate::judge) fn is_word(expr: &Expr) -> bool {
    let Kind::Mul(factors) = &expr.kind else { return false };
    let letter = |factor: &Expr| match &factor.kind {
        Kind::Name(name) => Some(name.clone()),
        Kind::Pow(base, _) => match &base.kind {
            Kind::Name(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    };
    let Some(mut word) = factors.iter().map(letter).collect::<Option<Vec<String>>>() else { return false };
    word.dedup();
    let own: std::collections::BTreeSet<&String> = word.iter().collect();
    own.len() < word.len()
}

/// The letters of a product with their powers.
fn powers<'a>(letters: &[(&'a str, i64)]) -> BTreeMap<&'a str, i64> {
    let mut sum = BTreeMap::new();
    letters.iter().for_each(|(name, power)| *sum.entry(*name).or_default() += power);
    sum.retain(|_, power| *power != 0);
    sum
}

/// The letters of a product with their signs in the exponent, in order; whether it is one of letters only.
fn letters<'a>(expr: &'a Expr, sign: i64, found: &mut Vec<(&'a str, i64)>) -> bool {
    match &expr.kind {
        Kind::Name(name) => {
            found.push((name, sign));
            true
        }
        Kind::Group(inner) => letters(inner, sign, found),
        Kind::Mul(factors) => factors.iter().all(|factor| letters(factor, sign, found)),
        Kind::Pow(base, exponent) => match exponent.as_signed_int() {
            Some(power) if (1..9).contains(&power.abs()) => {
                (0..power.abs()).all(|_| letters(base, sign * power.signum(), found))
            }
            _ => false,
        },
        _ => false,
    }
}

/// A formula as a linear combination of products of what stands in it. Cost: linear, each part is taken once.
pub(in crate::judge) fn bare(expr: &Expr) -> Bare {
    let mut sum = Bare::new();
    let mut add = |key: Product, value: Rational| {
        let entry = sum.entry(key).or_insert_with(Rational::zero);
        *entry += value;
    };
    match &expr.kind {
        Kind::Group(inner) => return bare(inner),
        Kind::Pow(base, exponent) if is_one(exponent) => return bare(base),
        Kind::Cross(factors) => return bare(&Expr::product(factors.clone())),
        Kind::Add(terms) => {
            for term in terms {
                for (key, value) in bare(&term.expr) {
                    add(key, if term.sign == Sign::Plus { value } else { -value });
                }
            }
        }
        Kind::Mul(_) | Kind::Div(..) | Kind::Number(_) => {
            let mut factors = BTreeMap::new();
            let value = monomial(expr, 1, &mut factors);
            let key: Vec<_> = factors.into_iter().filter(|(_, power)| *power != 0).collect();
            // 3 · 4 = 12 says something.
            if key.is_empty() && !value.is_zero() {
                add(vec![(write::text(expr), 1)], Rational::one());
            } else {
                add(key, value);
            }
        }
        _ => add(vec![(bare_text(expr), 1)], Rational::one()),
    }
    sum.retain(|_, value| !value.is_zero());
    sum
}

/// Collects the factors of a product with their powers; gives the number before it.
fn monomial(expr: &Expr, power: i64, factors: &mut BTreeMap<String, i64>) -> Rational {
    match &expr.kind {
        Kind::Pow(base, exponent) if is_one(exponent) => return monomial(base, power, factors),
        Kind::Pow(base, _) if is_one(base) => return Rational::one(),
        Kind::Number(q) if power > 0 => return q.clone(),
        Kind::Number(q) if !q.is_zero() => return q.recip(),
        Kind::Group(inner) if !matches!(inner.kind, Kind::Add(_)) => return monomial(inner, power, factors),
        Kind::Mul(list) => {
            return list
                .iter()
                .fold(Rational::one(), |value, factor| value * monomial(factor, power, factors));
        }
        Kind::Div(above, below, _) => {
            return monomial(above, power, factors) * monomial(below, -power, factors);
        }
        Kind::Add(_) | Kind::Group(_) => {
            let sum = bare(expr);
            // A sum that is a multiple of one thing: z + z
            if let [(key, value)] = sum.iter().collect::<Vec<_>>().as_slice() {
                for (name, own) in *key {
                    *factors.entry(name.clone()).or_default() += own * power;
                }
                return if power > 0 { (*value).clone() } else { value.recip() };
            }
            *factors.entry(text(&sum)).or_default() += power;
        }
        _ => *factors.entry(bare_text(expr)).or_default() += power,
    }
    Rational::one()
}

/// The text of a formula with all that stands inside of it in its bare form.
fn bare_text(expr: &Expr) -> String {
    let mut plain = expr.clone();
    plain.for_each_child_mut(&mut |child| *child = Expr::new(Kind::Name(text(&bare(child))), child.span));
    write::text(&plain)
}

fn text(sum: &Bare) -> String {
    let product =
        |key: &Product| -> String { key.iter().map(|(name, power)| format!("*{name}^{power}")).collect() };
    let terms = sum.iter().map(|(key, value)| format!("+{value}{}", product(key)));
    format!("({})", terms.collect::<String>())
}

fn is_one(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(q) => q.is_one(),
        Kind::Group(inner) => is_one(inner),
        Kind::Add(terms) => {
            matches!(terms.as_slice(), [only] if only.sign == Sign::Plus && is_one(&only.expr))
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Expr {
        crate::language::latex::read(text).expect("it can be read")
    }

    #[test]
    fn what_says_nothing() {
        for (left, right) in
            [("a", "a"), (r"\lambda x", r"+\lambda x"), (r"\frac{z+z}{2}", "z"), ("a x y", "a^1 x y")]
        {
            assert_eq!(bare(&read(left)), bare(&read(right)), "{left} = {right}");
        }
        for (left, right) in [("1+1", "2"), (r"3\cdot 4", "12"), ("(a+b)^2", "a^2+2ab+b^2"), ("a-b", "b-a")] {
            assert_ne!(bare(&read(left)), bare(&read(right)), "{left} = {right}");
        }
        assert!(vanishes(&read("2 + (a - a)")) && vanishes(&read(r"0\cdot a")) && !vanishes(&read("a - b")));
    }

    #[test]
    fn what_says_that_letters_commute() {
        for (left, right) in [("gH", "Hg"), ("h", "ghg^{-1}"), ("(uv)(vx)", "(vx)(uv)")] {
            assert!(only_commutes(&read(left), &read(right)), "{left} = {right}");
        }
        for (left, right) in [("abc", "a(bc)"), ("aab", "a^2 b"), ("2a", "a 2"), ("a b", "a c")] {
            assert!(!only_commutes(&read(left), &read(right)), "{left} = {right}");
        }
    }

    #[test]
    fn words_of_a_group() {
        for (text, wanted) in
            [("r^k s r^k s", true), ("a b a^{-1}", true), ("a a b", false), ("2 x y x", false)]
        {
            assert_eq!(is_word(&read(text)), wanted, "{text}");
        }
    }

    /// Sums within products within sums: each is taken once, or this would not end.
    #[test]
    fn deep_formulas() {
        let nested = (0..60).fold("1".to_owned(), |inner, _| format!("(b+{inner})c"));
        assert!(!vanishes(&read(&nested)));
    }
}
