//! Formulas as they are written, nothing multiplied out: equations between sides that are equal so say nothing.

use std::collections::BTreeMap;

use super::names::walk;
use crate::formula::{Expr, Kind, Sign};
use crate::language::write;
use crate::math::number::Rational;
use num_traits::{One, Zero};

/// Factors with their powers.
type Product = Vec<(String, i64)>;

/// Whether something is taken from itself or multiplied by 0: a - a, 0 a.
pub(super) fn vanishes(expr: &Expr) -> bool {
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

/// A formula as a linear combination of products of what stands in it, nothing multiplied out: equations between
/// sides that are equal so say nothing.
pub(super) fn bare(expr: &Expr) -> BTreeMap<Product, Rational> {
    let mut sum = BTreeMap::new();
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
            // A sum that is a multiple of one thing: z + z
            if let [(key, value)] = bare(expr).into_iter().collect::<Vec<_>>().as_slice() {
                for (name, own) in key {
                    *factors.entry(name.clone()).or_default() += own * power;
                }
                return if power > 0 { value.clone() } else { value.recip() };
            }
        }
        _ => {}
    }
    *factors.entry(bare_text(expr)).or_default() += power;
    Rational::one()
}

/// The text of a formula with all that stands inside of it in its bare form.
fn bare_text(expr: &Expr) -> String {
    let mut plain = expr.clone();
    plain.for_each_child_mut(&mut |child| {
        let product = |key: &Product| -> String {
            key.iter().map(|(name, power)| format!("*{name}^{power}")).collect()
        };
        let terms = bare(child).into_iter().map(|(key, value)| format!("+{value}{}", product(&key)));
        let name = format!("({})", terms.collect::<String>());
        *child = Expr::new(Kind::Name(name), child.span);
    });
    write::text(&plain)
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
