//! Comparing the values of two sides.

use crate::formula::{Expr, Rel};
use crate::judge::values::equality::judge;
pub use crate::judge::values::equality::symbols;
use crate::judge::values::inequality::inequality;
use crate::judge::values::roots;
use crate::language::value::{Judgement, Value, Verdict};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// What comes of a comparison.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// Exactly so.
    Holds,
    /// Not so, and how.
    Fails(Box<Judgement>),
    /// It cannot be said, and why.
    Unclear(String),
}

/// Where parameters are that nothing restricts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Anywhere.
    Reals,
    /// Those of Bernstein polynomials: between 0 and 1, barycentric coordinates not negative.
    Unit,
}

/// Compares two values.
pub fn relation(rel: Rel, left: &Value, right: &Value, conditions: &[Expr], domain: Domain) -> Outcome {
    let (left, right) = (plain(left), plain(right));
    if let Some(why) = other_shapes(&left, &right) {
        return Outcome::Unclear(why);
    }
    match rel {
        Rel::Eq | Rel::Equiv | Rel::Define => {
            // 1̂ = 1 − 0: the vector between two points
            let (left, right) = match (left, right) {
                (Value::Vector(a), Value::Scalar(b)) | (Value::Scalar(b), Value::Vector(a)) => {
                    if a == b {
                        return Outcome::Holds;
                    }
                    (Value::Scalar(a), Value::Scalar(b))
                }
                other => other,
            };
            match judged(Rel::Eq, &left, &right) {
                Outcome::Fails(judgement) => match roots::equal(&left, &right) {
                    Some(true) => Outcome::Holds,
                    // Roots have no other value than their own.
                    Some(false) => Outcome::Fails(Box::new(Judgement { witness: None, ..*judgement })),
                    None => Outcome::Fails(judgement),
                },
                other => other,
            }
        }
        Rel::Le | Rel::Lt | Rel::Ge | Rel::Gt => inequality(rel, &left, &right, conditions, domain),
        Rel::Ne => match judge(Rel::Ne, &left, &right) {
            Ok(judgement) if judgement.verdict == Verdict::Proved => Outcome::Holds,
            _ => Outcome::Unclear("whether the sides differ depends on their symbols".to_owned()),
        },
        Rel::Approx => judged(rel, &left, &right),
        _ => Outcome::Unclear("this relation says nothing that can be computed".to_owned()),
    }
}

fn judged(rel: Rel, left: &Value, right: &Value) -> Outcome {
    match judge(rel, left, right) {
        Ok(judgement) => match judgement.verdict {
            Verdict::Proved | Verdict::Sampled => Outcome::Holds,
            Verdict::Refuted => Outcome::Fails(Box::new(judgement)),
            Verdict::Undecided => Outcome::Unclear(judgement.reasons.join("; ")),
        },
        Err(error) => Outcome::Unclear(error.message),
    }
}

/// Lists and matrices of different sizes are rather misread than wrong.
fn other_shapes(left: &Value, right: &Value) -> Option<String> {
    match (left, right) {
        (Value::List(a), Value::List(b)) if a.len() != b.len() => {
            Some(format!("the sides are lists of {} and of {} items", a.len(), b.len()))
        }
        (Value::Matrix(a), Value::Matrix(b)) if a.shape() != b.shape() => Some(format!(
            "the sides are matrices of {} by {} and of {} by {}",
            a.nrows(),
            a.ncols(),
            b.nrows(),
            b.ncols()
        )),
        _ => None,
    }
}

/// A one-by-one matrix is its entry, a list of one its item; a column is a list.
pub fn plain(value: &Value) -> Value {
    match value {
        Value::Matrix(matrix) if matrix.shape() == (1, 1) => Value::Scalar(matrix[(0, 0)].clone()),
        Value::List(items) if items.len() == 1 => plain(&items[0]),
        other => other.clone(),
    }
}

/// A value with symbols replaced, one after the other.
pub fn substituted(value: &Value, by: &[(Symbol, Fraction)]) -> Option<Value> {
    let put = |formula: &Fraction| {
        by.iter().try_fold(formula.clone(), |f, one| f.substitute(std::slice::from_ref(one)).ok())
    };
    Some(match value {
        Value::Scalar(formula) => Value::Scalar(put(formula)?),
        Value::Vector(formula) => Value::Vector(put(formula)?),
        Value::List(items) => {
            Value::List(items.iter().map(|item| substituted(item, by)).collect::<Option<_>>()?)
        }
        Value::Matrix(matrix) => {
            let (rows, columns) = matrix.shape();
            let entries: Option<Vec<Fraction>> = matrix.transpose().iter().map(put).collect();
            Value::Matrix(nalgebra::DMatrix::from_row_iterator(rows, columns, entries?))
        }
        _ => return None,
    })
}

/// Whether an equation between numbers is false.
pub fn contradicts(a: &Value, b: &Value) -> bool {
    match (plain(a).as_rational(), plain(b).as_rational()) {
        (Some(a), Some(b)) => a != b,
        _ => false,
    }
}

/// Solves a condition a = b for one of the symbols that occur in the two sides: the last one in
/// which it is linear with a number as coefficient.
pub fn solved(
    a: &Value,
    b: &Value,
    known: &[(Symbol, Fraction)],
    left: &Value,
    right: &Value,
) -> Option<(Symbol, Fraction)> {
    let (a, b) = (substituted(a, known)?, substituted(b, known)?);
    let (Value::Scalar(a), Value::Scalar(b)) = (plain(&a), plain(&b)) else { return None };
    let mut used = symbols(left);
    used.extend(symbols(right));
    // t = c s/(1 - s + c s)
    if let [symbol] = a.numerator().variables()
        && used.contains(symbol)
        && a == Fraction::from(MultiPoly::symbol(symbol.clone()))
        && !symbols(&Value::Scalar(b.clone())).contains(symbol)
    {
        return Some((symbol.clone(), b));
    }
    let difference = a.minus(&b);
    let polynomial = difference.as_polynomial()?;
    let symbol = polynomial
        .variables()
        .iter()
        .rev()
        .find(|symbol| {
            used.contains(symbol)
                && polynomial.degree_in(symbol) == 1
                && polynomial.coefficients_in(symbol)[1].as_constant().is_some()
        })?
        .clone();
    let parts = polynomial.coefficients_in(&symbol);
    let slope = parts[1].as_constant()?;
    let rest = Fraction::from(parts[0].clone());
    Some((symbol, rest.scaled(&(-slope.recip()))))
}

/// Whether lists agree in half of their items and in two at least, polynomials in half of their terms.
pub(in crate::judge) fn agree_in_most(left: &Value, right: &Value) -> bool {
    let enough = |common: usize, all: usize| common > 1 && 2 * common >= all;
    // Rows and columns as points; a product of matrices with one entry as that.
    let plain = |value: &Value| match value.clone().coordinates() {
        Some(items) => items.first().filter(|_| items.len() == 1).cloned().unwrap_or(Value::list(items)),
        None => value.clone(),
    };
    match (&plain(left), &plain(right)) {
        (Value::List(own), Value::List(others)) => {
            own.len() == others.len()
                && own.len() > 2
                && enough(own.iter().zip(others).filter(|(a, b)| a == b).count(), own.len())
        }
        (Value::Scalar(own), Value::Scalar(others)) => {
            let (Some(own), Some(others)) = (own.as_polynomial(), others.as_polynomial()) else {
                return false;
            };
            let (common, all) = common_terms(own, others);
            own.variables() == others.variables() && enough(common, all)
        }
        _ => false,
    }
}

/// Whether both sides have symbols, and the same ones.
pub(in crate::judge) fn in_the_same_symbols(left: &Value, right: &Value) -> bool {
    let own = symbols(left);
    !own.is_empty() && own == symbols(right)
}

/// How many terms polynomials have in common, and how many the longer one has.
pub(in crate::judge) fn common_terms(left: &MultiPoly, right: &MultiPoly) -> (usize, usize) {
    let (own, others) = (left.terms(MonomialOrder::Lex), right.terms(MonomialOrder::Lex));
    (own.iter().filter(|term| others.contains(term)).count(), own.len().max(others.len()))
}
