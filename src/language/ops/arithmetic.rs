//! Sums, products, powers and matrix operations of values. Errors know no place yet.

use nalgebra::DMatrix;
use num_traits::{One, Zero};

use super::errors::{division_by_zero, linalg_error, mismatch, wrong_kind};
use super::function::pointwise;
use super::{geometry, polar};
use crate::budget;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::Value;
use crate::math::number::{Int, Rational};
use crate::math::poly::Fraction;
use crate::math::ring::{Field, Ring};

type Result<T> = std::result::Result<T, Diagnostic>;

/// The sum of two values.
pub(crate) fn add(left: Value, right: Value) -> Result<Value> {
    match (left, right) {
        (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(a + b)),
        (Value::Vector(a), Value::Vector(b)) => Ok(Value::Vector(a + b)),
        (Value::List(a), Value::List(b)) if a.len() == b.len() => {
            let sum = a.iter().cloned().zip(b.iter().cloned()).map(|(x, y)| add(x, y));
            let kind = if b.is_point() { &b } else { &a };
            sum.collect::<Result<_>>().map(|sum| Value::List(kind.with(sum)))
        }
        (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => Ok(Value::Matrix(a + b)),
        (Value::Polar(a), Value::Polar(b)) => polar::add(&a, &b),
        (Value::Piecewise(a), Value::Piecewise(b)) => geometry::add_piecewise(&a, &b),
        // A sum that begins with nothing.
        (Value::Piecewise(a), Value::Scalar(b)) | (Value::Scalar(b), Value::Piecewise(a)) if b.is_zero() => {
            Ok(Value::Piecewise(a))
        }
        (Value::Geometry(a), Value::Geometry(b)) => geometry::add(&a, &b),
        (Value::Geometry(a), b @ (Value::List(_) | Value::Scalar(_)))
        | (b @ (Value::List(_) | Value::Scalar(_)), Value::Geometry(a)) => geometry::translate(&a, &b),
        // A column of coordinates is a point.
        (Value::List(a), Value::Matrix(b)) | (Value::Matrix(b), Value::List(a))
            if b.shape() == (a.len(), 1) =>
        {
            let column = b.iter().cloned().map(Value::Scalar).collect();
            add(Value::List(a), Value::List(column))
        }
        (Value::Function(a), b) => pointwise(&Value::Function(a), &b, "added", |x, y| Ok(x + y)),
        (a, Value::Function(b)) => pointwise(&a, &Value::Function(b), "added", |x, y| Ok(x + y)),
        (Value::List(a), Value::List(b)) => Err(Diagnostic::error(
            Code::Shape,
            format!("lists of {} and {} items cannot be added", a.len(), b.len()),
        )),
        (Value::Matrix(a), Value::Matrix(b)) => Err(Diagnostic::error(
            Code::Shape,
            format!("a {}x{} and a {}x{} matrix cannot be added", a.nrows(), a.ncols(), b.nrows(), b.ncols()),
        )),
        (a, b) => Err(mismatch("added", &a, &b)),
    }
}

/// The negative of a value.
pub(crate) fn negate(value: Value) -> Result<Value> {
    match value {
        Value::Scalar(a) => Ok(Value::Scalar(-a)),
        Value::Vector(a) => Ok(Value::Vector(-a)),
        other => multiply(Value::int(-1), other),
    }
}

/// The product of two values.
pub(crate) fn multiply(left: Value, right: Value) -> Result<Value> {
    match (left, right) {
        (Value::Scalar(a), Value::Scalar(b)) => {
            // Repeated products of numbers must stay within the limit on digits, too.
            if let (Some(x), Some(y)) = (a.as_rational(), b.as_rational()) {
                let bits = |q: &Rational| q.numer().bits().max(q.denom().bits());
                budget::charge_bits(bits(&x).saturating_add(bits(&y)));
            }
            Ok(Value::Scalar(a * b))
        }
        (Value::Scalar(a), Value::Vector(b)) | (Value::Vector(b), Value::Scalar(a)) => {
            Ok(Value::Vector(a * b))
        }
        (Value::Scalar(a), Value::List(items)) | (Value::List(items), Value::Scalar(a)) => {
            let multiple = |item: &Value| multiply(Value::Scalar(a.clone()), item.clone());
            items
                .iter()
                .map(multiple)
                .collect::<Result<_>>()
                .map(|multiples| Value::List(items.with(multiples)))
        }
        (Value::Scalar(a), Value::Matrix(m)) | (Value::Matrix(m), Value::Scalar(a)) => {
            Ok(Value::Matrix(m.map(|x| x.times(&a))))
        }
        (Value::Scalar(a), Value::Polar(f)) | (Value::Polar(f), Value::Scalar(a)) => polar::scale(&a, &f),
        (Value::Scalar(a), Value::Piecewise(f)) | (Value::Piecewise(f), Value::Scalar(a)) => {
            Ok(geometry::scale_piecewise(&a, &f))
        }
        (Value::Scalar(a), Value::Geometry(c)) | (Value::Geometry(c), Value::Scalar(a)) => {
            geometry::scale(&a, &c)
        }
        (Value::Matrix(a), Value::Matrix(b)) => {
            if a.ncols() != b.nrows() {
                return Err(Diagnostic::error(
                    Code::Shape,
                    format!(
                        "a {}x{} matrix times a {}x{} matrix: the inner sizes differ",
                        a.nrows(),
                        a.ncols(),
                        b.nrows(),
                        b.ncols()
                    ),
                ));
            }
            budget::charge_terms((a.nrows() * b.ncols()) as u64);
            Ok(Value::Matrix(crate::math::linalg::multiply(&a, &b).map_err(linalg_error)?))
        }
        // A matrix times points: each row combines them.
        (Value::Matrix(a), Value::List(items))
            if a.ncols() == items.len() && items.iter().all(|item| matches!(item, Value::List(_))) =>
        {
            let row = |i: usize| combination(a.row(i).iter(), &items);
            (0..a.nrows()).map(row).collect::<Result<_>>().map(Value::List)
        }
        // A row times a matrix; with a column it is one number.
        (Value::List(items), Value::Matrix(a)) if a.nrows() == items.len() => {
            let column = |j: usize| combination(a.column(j).iter(), &items);
            let row: Vec<Value> = (0..a.ncols()).map(column).collect::<Result<_>>()?;
            match <[Value; 1]>::try_from(row) {
                Ok([only]) => Ok(only),
                Err(row) => Ok(Value::list(row)),
            }
        }
        (Value::Matrix(a), Value::List(items)) => {
            let product = multiply(Value::Matrix(a), column(&items)?)?;
            Ok(match product {
                Value::Matrix(m) if m.ncols() == 1 => {
                    Value::List(items.with(m.iter().cloned().map(Value::Scalar).collect()))
                }
                other => other,
            })
        }
        (Value::Function(a), b) => pointwise(&Value::Function(a), &b, "multiplied", |x, y| Ok(x * y)),
        (a, Value::Function(b)) => pointwise(&a, &Value::Function(b), "multiplied", |x, y| Ok(x * y)),
        (Value::Geometry(c), Value::Geometry(d)) => {
            Err(mismatch("multiplied", &Value::Geometry(c), &Value::Geometry(d))
                .hint("curve_product(c, d) is the product of a function and a curve, or the scalar product"))
        }
        (Value::Builtin(name), b) => Err(mismatch("multiplied", &Value::Builtin(name), &b)
            .hint(format!("a function is called with parentheses: {name}(...)"))),
        (Value::List(a), b) if is_grid(&a) => {
            Err(mismatch("multiplied", &Value::List(a), &b).hint(AS_MATRIX))
        }
        (Value::List(a), Value::List(b)) => Err(mismatch("multiplied", &Value::List(a), &Value::List(b))
            .hint("dot(a, b) is the scalar product of two points, cross(a, b) their cross product")),
        (Value::Polar(_), Value::Polar(_)) => {
            Err(Diagnostic::error(Code::Type, "the product of two polar forms is not symmetric")
                .hint("polar_product(f, g) is the polar form of the product of the polynomials"))
        }
        (a, b) => Err(mismatch("multiplied", &a, &b)),
    }
}

/// What can be done with names that stand for integers.
const ALL_INTEGERS: &str =
    "an equation with it is checked for all integers: polarform check \"binomial(n, k) = binomial(n, n-k)\"";

/// What to write for a matrix that is given as a list of its rows.
const AS_MATRIX: &str = "a matrix has semicolons between its rows: [1, 2; 3, 4]";

/// Whether a list has lists of one length as items, as a matrix has rows.
fn is_grid(items: &[Value]) -> bool {
    let length = |item: &Value| match item {
        Value::List(row) => Some(row.len()),
        _ => None,
    };
    let first = items.first().and_then(length);
    first.is_some() && items.iter().all(|item| length(item) == first)
}

/// The sum of multiples of the items.
fn combination<'a>(weights: impl Iterator<Item = &'a Fraction>, items: &[Value]) -> Result<Value> {
    let mut terms =
        weights.zip(items).map(|(weight, item)| multiply(Value::Scalar(weight.clone()), item.clone()));
    let first = terms.next().unwrap_or_else(|| Ok(Value::int(0)))?;
    terms.try_fold(first, |sum, term| add(sum, term?))
}

/// The product of a row and a column of values.
pub(crate) fn row_times_column(row: &[Value], column: &[Value]) -> Result<Value> {
    if row.len() != column.len() {
        return Err(Diagnostic::error(
            Code::Shape,
            format!("a row of {} and a column of {} items cannot be multiplied", row.len(), column.len()),
        ));
    }
    let mut terms = row.iter().zip(column).map(|(x, y)| multiply(x.clone(), y.clone()));
    let first = terms.next().unwrap_or_else(|| Ok(Value::int(0)))?;
    terms.try_fold(first, |sum, term| add(sum, term?))
}

/// The scalar product of two points, which may be columns, or the product of matrices, which may be lists of their rows.
pub(crate) fn inner(left: &Value, right: &Value) -> Result<Value> {
    match (left, right) {
        (Value::List(rows), _) if is_grid(rows) => {
            rows.iter().map(|row| inner(row, right)).collect::<Result<Vec<_>>>().map(Value::list)
        }
        (Value::List(a), Value::List(b)) => row_times_column(a, b),
        (Value::Matrix(a), Value::Matrix(b)) if a.ncols() == 1 && a.shape() == b.shape() && a.nrows() > 1 => {
            let entries = |column: &DMatrix<Fraction>| -> Vec<Value> {
                column.iter().cloned().map(Value::Scalar).collect()
            };
            row_times_column(&entries(a), &entries(b))
        }
        _ => multiply(left.clone(), right.clone()),
    }
}

/// A list of scalars as a column.
fn column(items: &[Value]) -> Result<Value> {
    let entries: Option<Vec<Fraction>> = items.iter().map(|item| item.as_scalar().cloned()).collect();
    let entries =
        entries.ok_or_else(|| Diagnostic::error(Code::Type, "expected a list of numbers or formulas"))?;
    Ok(Value::Matrix(DMatrix::from_vec(entries.len(), 1, entries)))
}

/// The quotient of two values.
pub(crate) fn divide(left: Value, right: Value) -> Result<Value> {
    match (left, right) {
        (Value::Function(a), b) => pointwise(&Value::Function(a), &b, "divided", quotient),
        (a, Value::Function(b)) => pointwise(&a, &Value::Function(b), "divided", quotient),
        (a, Value::Scalar(b)) => {
            let inverse = b.inverse().ok_or_else(division_by_zero)?;
            multiply(a, Value::Scalar(inverse))
        }
        (a, b) => Err(mismatch("divided", &a, &b)),
    }
}

fn quotient(a: Fraction, b: Fraction) -> Result<Fraction> {
    Ok(a * b.inverse().ok_or_else(division_by_zero)?)
}

/// Largest exponent accepted; products of that size are stopped by other limits long before.
const MAX_EXPONENT: i64 = i32::MAX as i64;

/// A power, or a power of a matrix.
pub(crate) fn power(base: Value, exponent: &Value) -> Result<Value> {
    let Some(k) = exponent.as_rational() else {
        return Err(Diagnostic::error(
            Code::BadExponent,
            format!("an exponent must be an integer, not {}", exponent.kind()),
        )
        .hint("give the exponent a value first, or sum over it with bounds")
        .hint(ALL_INTEGERS));
    };
    if !k.denom().is_one() {
        return Err(Diagnostic::error(Code::BadExponent, format!("the exponent {k} is not an integer"))
            .hint("roots are not rational; only integer powers are exact here"));
    }
    let Some(k) = k.numer().as_small().filter(|k| k.abs() <= MAX_EXPONENT) else {
        let digits = k.numer().to_string().len();
        let shown =
            if digits > 40 { format!("an exponent of {digits} digits") } else { format!("the exponent {k}") };
        return Err(Diagnostic::error(Code::TooManyTerms, format!("{shown} is too large")));
    };
    match base {
        Value::Scalar(a) => scalar_power(&a, k).map(Value::Scalar),
        Value::Matrix(m) => matrix_power(m, k),
        Value::Function(f) => {
            let zero = Value::int(0);
            pointwise(&Value::Function(f), &zero, "raised to a power", |x, _| scalar_power(&x, k))
        }
        other => {
            let error = Diagnostic::error(Code::Type, format!("{} has no powers", other.kind()));
            Err(match other {
                Value::List(items) if is_grid(&items) => error.hint(AS_MATRIX),
                Value::List(_) => error.hint("dot(a, a) is the square of a length"),
                Value::Geometry(_) => error.hint("curve_product(c, c) is the square of a function"),
                _ => error,
            })
        }
    }
}

fn scalar_power(a: &Fraction, k: i64) -> Result<Fraction> {
    if a.is_zero() && k < 0 {
        return Err(division_by_zero());
    }
    if let Some(q) = a.as_rational() {
        let bits = q.numer().bits().max(q.denom().bits()).saturating_sub(1);
        budget::charge_bits(bits.saturating_mul(k.unsigned_abs()));
    }
    let exponent =
        i32::try_from(k).map_err(|_| Diagnostic::error(Code::TooManyTerms, "the exponent is too large"))?;
    a.pow(exponent).map_err(|_| division_by_zero())
}

fn matrix_power(m: DMatrix<Fraction>, k: i64) -> Result<Value> {
    if m.nrows() != m.ncols() {
        return Err(Diagnostic::error(
            Code::Shape,
            format!("a {}x{} matrix has no powers", m.nrows(), m.ncols()),
        ));
    }
    let mut base = if k < 0 { crate::math::linalg::inverse(&m).map_err(linalg_error)? } else { m };
    let mut result = DMatrix::identity(base.nrows(), base.nrows());
    let mut left = k.unsigned_abs();
    while left > 0 {
        budget::steps(256);
        if left & 1 == 1 {
            result = crate::math::linalg::multiply(&result, &base).map_err(linalg_error)?;
        }
        left >>= 1;
        if left > 0 {
            base = crate::math::linalg::multiply(&base, &base).map_err(linalg_error)?;
        }
    }
    Ok(Value::Matrix(result))
}

/// The transpose of a matrix; a list is a row.
pub(crate) fn transpose(value: Value) -> Result<Value> {
    match value {
        Value::Matrix(m) => Ok(Value::Matrix(m.transpose())),
        // Rows become columns.
        Value::List(rows) if is_grid(&rows) => {
            let columns = match rows.first() {
                Some(Value::List(row)) => row.len(),
                _ => 0,
            };
            let entry = |row: &Value, at: usize| match row {
                Value::List(items) => items.get(at).cloned(),
                _ => None,
            };
            let column = |at: usize| Value::list(rows.iter().filter_map(|row| entry(row, at)).collect());
            Ok(Value::list((0..columns).map(column).collect()))
        }
        Value::List(items) => match column(&items)? {
            // A list is read as a row; its transpose is a column.
            Value::Matrix(m) => Ok(Value::Matrix(m)),
            other => Ok(other),
        },
        Value::Scalar(a) => Ok(Value::Scalar(a)),
        other => Err(Diagnostic::error(Code::Type, format!("{} has no transpose", other.kind()))),
    }
}

/// The cross product of two points in space, or an ordinary product of scalars.
pub(crate) fn cross(left: Value, right: Value) -> Result<Value> {
    let coordinates = |value: &Value| -> Option<Vec<Fraction>> {
        match value {
            Value::List(items) if items.len() == 3 => {
                items.iter().map(|item| item.as_scalar().cloned()).collect()
            }
            _ => None,
        }
    };
    match (coordinates(&left), coordinates(&right)) {
        (Some(a), Some(b)) => {
            let entry = |i: usize, j: usize| Value::Scalar(a[i].times(&b[j]).minus(&a[j].times(&b[i])));
            Ok(Value::point(vec![entry(1, 2), entry(2, 0), entry(0, 1)]))
        }
        _ => multiply(left, right),
    }
}

/// C(n, k): for integers the number of subsets (0 outside 0 ≤ k ≤ n), for symbolic n and
/// a number k ≥ 0 the polynomial n(n−1)…(n−k+1)/k!.
pub(crate) fn binomial(n: &Value, k: &Value) -> Result<Value> {
    let (Some(top), Some(lower)) = (n.as_scalar(), k.as_int()) else {
        return Err(wrong_kind("an integer below in a binomial coefficient", k).hint(ALL_INTEGERS));
    };
    if lower < 0 {
        return Ok(Value::int(0));
    }
    if let Some(n) = n.as_int()
        && n >= 0
    {
        if lower > n {
            return Ok(Value::int(0));
        }
        // C(n, k) has at most k log2(n) bits.
        let small = lower.min(n - lower) as u64;
        budget::charge_bits(small.saturating_mul(64 - u64::from(n.leading_zeros())).min(n as u64));
        let value = crate::math::number::binomial(n as usize, lower as usize);
        return Ok(Value::number(Rational::from_integer(value)));
    }
    budget::charge_terms(lower as u64);
    let mut product = Fraction::one();
    for i in 0..lower {
        let factor = top.minus(&Fraction::from_rational(&Rational::from_integer(Int::from(i))));
        product = product.times(&factor).scaled(&Rational::new(Int::ONE, Int::from(i + 1)));
    }
    Ok(Value::Scalar(product))
}

/// n! for an integer n ≥ 0.
pub(crate) fn factorial(n: &Value) -> Result<Value> {
    match n.as_int() {
        Some(n) if n >= 0 => {
            let bits = (n as u64).saturating_mul(64 - u64::from(n.leading_zeros()));
            budget::charge_bits(bits);
            Ok(Value::number(Rational::from_integer(crate::math::number::factorial(n as usize))))
        }
        Some(_) => Err(Diagnostic::error(Code::Domain, "a factorial needs an integer that is 0 or more")),
        None => Err(wrong_kind("an integer that is 0 or more under the factorial", n).hint(ALL_INTEGERS)),
    }
}
