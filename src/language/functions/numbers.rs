//! Numbers.

use super::Builtin;
use super::gives::Gives;
use super::parameter::{many, required, size};
use super::polynomials::divided;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::arithmetic;
use crate::language::ops::errors::{division_by_zero, wrong_kind};
use crate::language::ops::takes::Takes;
use crate::language::value::Value;
use crate::math::number::{Rational, exact_root};
use crate::math::poly::Fraction;
use nalgebra::DMatrix;
use num_traits::Zero;

const NEW: Builtin = Builtin::about("Numbers");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "binomial",
        parameters: &[
            required("n", Takes::Scalar, "the number of things, or a formula"),
            required("k", Takes::Size, "the size of the subsets"),
        ],
        summary: "the number of k-subsets of n things; n may be symbolic",
        gives: Gives::Scalar,
        example: "binomial(5, 2)",
        call: |_, args| arithmetic::binomial(args.value(0)?, args.value(1)?),
        ..NEW
    },
    Builtin {
        name: "factorial",
        parameters: &[size("n", "the number")],
        summary: "1 2 ... n; also written n!",
        gives: Gives::Count,
        example: "factorial(5)",
        call: |_, args| arithmetic::factorial(args.value(0)?).at(args.span(0)),
        ..NEW
    },
    Builtin {
        name: "sqrt",
        parameters: &[required("q", Takes::Number, "the square of a rational number")],
        summary: "the square root of a number that is the square of a rational one",
        gives: Gives::Scalar,
        example: "sqrt(9/16)",
        call: |_, args| {
            let square = args.rational(0)?;
            exact_root(&square, 2).map(Value::number).ok_or_else(|| {
                Diagnostic::error(Code::Domain, format!("{square} is not the square of a rational number"))
                    .at(args.span(0))
                    .reason("its root is not rational")
                    .hint(format!("roots(t^2 - {square}) isolates the roots exactly"))
            })
        },
        ..NEW
    },
    Builtin {
        name: "mod",
        parameters: &[
            required("a", Takes::Scalar, "the dividend"),
            required("b", Takes::Scalar, "the divisor"),
        ],
        summary: "what division leaves: a - b floor(a/b) of numbers, the remainder of polynomials; a mod b",
        gives: Gives::Scalar,
        example: "mod(17, 5)",
        call: |_, args| {
            // t^5 mod (t - 2)^2; of t mod 2 it is not known whether t is an integer
            if !args.scalar(1)?.variables().is_empty() {
                return divided(args).map(|(_, rest)| Value::Scalar(rest));
            }
            let (a, b) = (args.rational(0)?, args.rational(1)?);
            if b.is_zero() {
                return Err(division_by_zero()).at(args.span(1));
            }
            let times = (&a / &b).floor();
            Ok(Value::number(a - b * times))
        },
        ..NEW
    },
    Builtin {
        name: "max",
        parameters: &[many(
            "a, b, ...",
            Takes::OneOf(&[Takes::Number, Takes::Scalars]),
            1,
            "the numbers, also in one list",
        )],
        summary: "the largest of some numbers",
        gives: Gives::Scalar,
        example: "max(1/2, 1/3)",
        call: |_, args| extreme(args, true),
        ..NEW
    },
    Builtin {
        name: "min",
        parameters: &[many(
            "a, b, ...",
            Takes::OneOf(&[Takes::Number, Takes::Scalars]),
            1,
            "the numbers, also in one list",
        )],
        summary: "the smallest of some numbers",
        gives: Gives::Scalar,
        example: "min(1/2, 1/3)",
        call: |_, args| extreme(args, false),
        ..NEW
    },
    Builtin {
        name: "map",
        parameters: &[
            required("F", Takes::Mapping, "the function, such as i -> i^2"),
            required("list", Takes::List, "what it is applied to, also a range such as 0..3"),
        ],
        summary: "the list of the values of a function; [i^2 for i = 0..3] is the same",
        gives: Gives::Any,
        example: "map(i -> i^2, 0..3)",
        call: |machine, args| {
            let (function, items) = (args.mapping(0)?, args.list(1)?);
            let span = args.span(0);
            let value = |item: &Value| machine.call(function, vec![(item.clone(), args.span(1))], span);
            items.iter().map(value).collect::<Result<_, _>>().map(Value::List)
        },
        ..NEW
    },
    Builtin {
        name: "dot",
        parameters: &[
            required(
                "a",
                Takes::OneOf(&[Takes::List, Takes::Matrix]),
                "a point, a matrix or the list of its rows",
            ),
            required(
                "b",
                Takes::OneOf(&[Takes::List, Takes::Matrix]),
                "another one, of as many coordinates or rows",
            ),
        ],
        summary: "the scalar product of two points, or the product of matrices; also written a . b",
        gives: Gives::Any,
        example: "dot([1, 2], [3, 4])",
        call: |_, args| {
            for place in 0..2 {
                let value = args.value(place)?;
                if !matches!(value, Value::List(_) | Value::Matrix(_)) {
                    return Err(wrong_kind("a point such as [1, 2]", value).at(args.span(place)));
                }
            }
            arithmetic::inner(args.value(0)?, args.value(1)?)
        },
        ..NEW
    },
    Builtin {
        name: "termwise",
        parameters: &[
            required("F", Takes::Mapping, "the function of two arguments, such as (x, y) -> x y"),
            required("a", Takes::Any, "a list, a matrix or a number"),
            required("b", Takes::Any, "another one, of the same size, or a number"),
        ],
        summary: "a function of the entries of lists or matrices, one by one; also a .* b and a.^2",
        gives: Gives::Any,
        example: "termwise((x, y) -> x y, [1, 2], [3, 4])",
        call: |machine, args| {
            let function = args.mapping(0)?;
            let span = args.span(0);
            let (left, right) = (args.span(1), args.span(2));
            let mut each = |a: &Value, b: &Value| {
                machine.call(function, vec![(a.clone(), left), (b.clone(), right)], span)
            };
            termwise(&mut each, args.value(1)?, args.value(2)?).at(right)
        },
        ..NEW
    },
    Builtin {
        name: "cross",
        parameters: &[
            required("a", Takes::Point, "a point of space"),
            required("b", Takes::Point, "another one"),
        ],
        summary: "the cross product of two points in space",
        gives: Gives::Point,
        example: "cross([1, 0, 0], [0, 1, 0])",
        call: |_, args| arithmetic::cross(args.value(0)?.clone(), args.value(1)?.clone()),
        ..NEW
    },
    Builtin {
        name: "length",
        parameters: &[required("list", Takes::List, "the list")],
        summary: "the number of items of a list",
        gives: Gives::Count,
        example: "length([1, 2, 3])",
        call: |_, args| Ok(Value::int(args.list(0)?.len() as i64)),
        ..NEW
    },
];

/// The largest or smallest of numbers, which may stand in one list.
fn extreme(args: &Arguments, largest: bool) -> Result<Value, Diagnostic> {
    let numbers: Vec<Rational> = match args.value(0)? {
        Value::List(items) if args.len() == 1 && !items.is_empty() => {
            let number = |item: &Value| {
                item.as_rational().ok_or_else(|| wrong_kind("a number", item).at(args.span(0)))
            };
            items.iter().map(number).collect::<Result<_, _>>()?
        }
        _ => (0..args.len()).map(|i| args.rational(i)).collect::<Result<_, _>>()?,
    };
    let best = if largest { numbers.into_iter().max() } else { numbers.into_iter().min() };
    Ok(best.map_or(Value::int(0), Value::number))
}

/// A function of each pair of entries; a number goes with all entries.
fn termwise(
    each: &mut dyn FnMut(&Value, &Value) -> Result<Value, Diagnostic>,
    left: &Value,
    right: &Value,
) -> Result<Value, Diagnostic> {
    let sizes = || {
        Diagnostic::error(Code::Shape, "lists or matrices of different sizes have no pairs of entries")
            .hint("make the numbers of rows, columns or items agree")
    };
    match (left, right) {
        (Value::List(a), Value::List(b)) if a.len() != b.len() => Err(sizes()),
        (Value::List(a), Value::List(b)) => a
            .iter()
            .zip(b.iter())
            .map(|(a, b)| termwise(each, a, b))
            .collect::<Result<_, _>>()
            .map(Value::List),
        (Value::List(a), b) if !matches!(b, Value::Matrix(_)) => {
            a.iter().map(|a| termwise(each, a, b)).collect::<Result<_, _>>().map(Value::List)
        }
        (a, Value::List(b)) if !matches!(a, Value::Matrix(_)) => {
            b.iter().map(|b| termwise(each, a, b)).collect::<Result<_, _>>().map(Value::List)
        }
        (Value::Matrix(a), Value::Matrix(b)) if a.shape() != b.shape() => Err(sizes()),
        (Value::Matrix(a), Value::Matrix(b)) => entrywise(a, |i, x| {
            let y = b.iter().nth(i).cloned().ok_or_else(sizes)?;
            each(&Value::Scalar(x), &Value::Scalar(y))
        }),
        (Value::Matrix(a), b @ Value::Scalar(_)) => entrywise(a, |_, x| each(&Value::Scalar(x), b)),
        (a @ Value::Scalar(_), Value::Matrix(b)) => entrywise(b, |_, y| each(a, &Value::Scalar(y))),
        (Value::Matrix(_), _) | (_, Value::Matrix(_)) => Err(sizes()),
        (a, b) => each(a, b),
    }
}

/// The matrix of the values at the entries, which come column by column with their number.
fn entrywise(
    matrix: &DMatrix<Fraction>,
    mut value: impl FnMut(usize, Fraction) -> Result<Value, Diagnostic>,
) -> Result<Value, Diagnostic> {
    let scalar = |value: Value| match value {
        Value::Scalar(formula) => Ok(formula),
        other => Err(wrong_kind("a number or formula", &other)),
    };
    let entries: Vec<Fraction> = matrix
        .iter()
        .enumerate()
        .map(|(i, entry)| value(i, entry.clone()).and_then(scalar))
        .collect::<Result<_, _>>()?;
    Ok(Value::Matrix(DMatrix::from_vec(matrix.nrows(), matrix.ncols(), entries)))
}
