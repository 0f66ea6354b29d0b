//! Comparing the values of two sides.

use super::roots;
use super::values::judge;
pub use super::values::symbols;
use crate::formula::{Expr, Kind, Rel};
use crate::language::lexicon::roles;
use crate::language::value::{Judgement, Value, Verdict, Witness};
use crate::math::number::{Rational, integer};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Poly, Symbol};
use crate::math::ring::Ring;
use num_traits::{Signed, Zero};

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
            match judge(Rel::Eq, &left, &right) {
                Ok(judgement) => match judgement.verdict {
                    Verdict::Proved | Verdict::Sampled => Outcome::Holds,
                    Verdict::Refuted => match roots::equal(&left, &right) {
                        Some(true) => Outcome::Holds,
                        // Roots have no other value than their own.
                        Some(false) => Outcome::Fails(Box::new(Judgement { witness: None, ..judgement })),
                        None => Outcome::Fails(Box::new(judgement)),
                    },
                    Verdict::Undecided => Outcome::Unclear(judgement.reasons.join("; ")),
                },
                Err(error) => Outcome::Unclear(error.message),
            }
        }
        Rel::Le | Rel::Lt | Rel::Ge | Rel::Gt => inequality(rel, &left, &right, conditions, domain),
        Rel::Ne => match judge(Rel::Ne, &left, &right) {
            Ok(judgement) if judgement.verdict == Verdict::Proved => Outcome::Holds,
            _ => Outcome::Unclear("whether the sides differ depends on their symbols".to_owned()),
        },
        Rel::Approx => Outcome::Unclear("approximations are not checked".to_owned()),
        _ => Outcome::Unclear("this relation says nothing that can be computed".to_owned()),
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
fn plain(value: &Value) -> Value {
    match value {
        Value::Matrix(matrix) if matrix.shape() == (1, 1) => Value::Scalar(matrix[(0, 0)].clone()),
        Value::List(items) if items.len() == 1 => plain(&items[0]),
        other => other.clone(),
    }
}

/// The interval of a variable that the conditions give: 0 ≤ t ≤ 1, t ∈ [0, 1].
fn interval(symbol: &Symbol, conditions: &[Expr]) -> Option<(Rational, Rational)> {
    let number = |expr: &Expr| match &expr.kind {
        Kind::Number(q) => Some(q.clone()),
        _ => None,
    };
    let named = |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if *symbol == Symbol::new(name));
    conditions.iter().find_map(|condition| {
        let Kind::Chain(left, links) = &condition.kind else { return None };
        match links.as_slice() {
            [link] if link.rel == Rel::In && named(left) => {
                let items = match &link.expr.kind {
                    Kind::List(items) | Kind::Tuple(items) => items.clone(),
                    Kind::Apply(_, groups) => groups.first()?.clone(),
                    _ => return None,
                };
                Some((number(items.first()?)?, number(items.get(1)?)?))
            }
            [one, two] if named(&one.expr) => {
                let (a, b) = (number(left)?, number(&two.expr)?);
                Some(if a <= b { (a, b) } else { (b, a) })
            }
            _ => None,
        }
    })
}

fn inequality(rel: Rel, left: &Value, right: &Value, conditions: &[Expr], domain: Domain) -> Outcome {
    let (Value::Scalar(a), Value::Scalar(b)) = (left, right) else {
        return Outcome::Unclear("only numbers can be ordered".to_owned());
    };
    let (larger, smaller) = if matches!(rel, Rel::Ge | Rel::Gt) { (a, b) } else { (b, a) };
    let difference = larger.minus(smaller);
    let strict = matches!(rel, Rel::Lt | Rel::Gt);
    if let Some(d) = difference.as_rational() {
        return if d.is_positive() || (d.is_zero() && !strict) {
            Outcome::Holds
        } else {
            fails(
                rel,
                left,
                right,
                Witness {
                    assignment: Vec::new(),
                    left: a.as_rational().unwrap_or_else(Rational::zero),
                    right: b.as_rational().unwrap_or_else(Rational::zero),
                },
            )
        };
    }
    let Some(polynomial) = difference.as_polynomial() else {
        return Outcome::Unclear("an inequality between quotients is not decided".to_owned());
    };
    let variables = polynomial.variables().to_vec();
    if let [variable] = variables.as_slice() {
        let given = interval(variable, conditions);
        let coefficients: Option<Vec<Rational>> =
            polynomial.coefficients_in(variable).iter().map(|c| c.as_constant()).collect();
        let Some(coefficients) = coefficients else {
            return Outcome::Unclear("the coefficients are not numbers".to_owned());
        };
        let everywhere = beyond_all_roots(&coefficients);
        let f = Poly::from_coefficients(coefficients);
        let (from, to) = match (&given, domain, everywhere) {
            (Some(found), ..) => found.clone(),
            (None, Domain::Unit, _) if variable.is_plain() => (integer(0), integer(1)),
            (None, Domain::Reals, Some(bound)) => (-bound.clone(), bound),
            _ => return Outcome::Unclear("the range of the variable is not given".to_owned()),
        };
        if f.is_nonnegative_on(&from, &to) {
            let middle = (&from + &to) / integer(2);
            if !strict {
                return Outcome::Holds;
            }
            // > on the open interval
            let open =
                f.count_roots(&from, &to).is_some_and(|roots| roots == usize::from(f.value(&to).is_zero()));
            return if open && f.value(&middle).is_positive() {
                Outcome::Holds
            } else {
                Outcome::Unclear("equality occurs within the range".to_owned())
            };
        }
        if given.is_none() {
            return Outcome::Unclear("the range of the variable is not given".to_owned());
        }
        let steps = 64;
        for k in 0..=steps {
            let at = &from + (&to - &from) * Rational::new(k.into(), steps.into());
            let value = f.value(&at);
            if value.is_negative() {
                let put = |formula: &Fraction| formula.value(&|s| (s == variable).then(|| at.clone()));
                if let (Some(left_value), Some(right_value)) = (put(a), put(b)) {
                    let witness = Witness {
                        assignment: vec![(variable.clone(), at.clone())],
                        left: left_value,
                        right: right_value,
                    };
                    return fails(rel, left, right, witness);
                }
            }
        }
        return Outcome::Unclear("it fails somewhere in the range".to_owned());
    }
    // Barycentric coordinates are not negative.
    let nonnegative = polynomial.terms(MonomialOrder::Lex).iter().all(|(_, c)| !c.is_negative());
    let coordinates = variables.iter().all(|v| v.is_plain() && roles::is_barycentric(v.base()));
    if nonnegative && coordinates && domain == Domain::Unit && !strict {
        return Outcome::Holds;
    }
    Outcome::Unclear("an inequality in several variables is not decided".to_owned())
}

/// A number beyond all real roots, by Cauchy's bound, if the polynomial is positive there on both sides.
fn beyond_all_roots(coefficients: &[Rational]) -> Option<Rational> {
    let degree = coefficients.iter().rposition(|c| !c.is_zero())?;
    let leading = &coefficients[degree];
    let largest =
        coefficients[..degree].iter().map(|c| (c / leading).abs()).max().unwrap_or_else(Rational::zero);
    (degree % 2 == 0 && leading.is_positive()).then(|| largest + integer(1))
}

fn fails(rel: Rel, left: &Value, right: &Value, witness: Witness) -> Outcome {
    Outcome::Fails(Box::new(Judgement {
        rel,
        left: left.clone(),
        right: right.clone(),
        verdict: Verdict::Refuted,
        difference: None,
        witness: Some(witness),
        reasons: Vec::new(),
    }))
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
