//! Numbers.

use super::Builtin;
use super::parameter::{Takes, many, required, size};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::arithmetic;
use crate::language::ops::errors::{division_by_zero, wrong_kind};
use crate::language::value::Value;
use crate::math::number::exact_root;
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
        example: "binomial(5, 2)",
        call: |_, args| arithmetic::binomial(args.value(0)?, args.value(1)?),
        ..NEW
    },
    Builtin {
        name: "factorial",
        parameters: &[size("n", "the number")],
        summary: "1 2 ... n; also written n!",
        example: "factorial(5)",
        call: |_, args| arithmetic::factorial(args.value(0)?).at(args.span(0)),
        ..NEW
    },
    Builtin {
        name: "sqrt",
        parameters: &[required("q", Takes::Number, "the square of a rational number")],
        summary: "the square root of a number that is the square of a rational one",
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
            required("a", Takes::Number, "the dividend"),
            required("b", Takes::Number, "the divisor"),
        ],
        summary: "what division of a by b to an integer leaves, a - b floor(a/b); also written a mod b",
        example: "mod(17, 5)",
        call: |_, args| {
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
        parameters: &[many("a, b, ...", Takes::Number, 1, "the numbers")],
        summary: "the largest of some numbers",
        example: "max(1/2, 1/3)",
        call: |_, args| extreme(args, true),
        ..NEW
    },
    Builtin {
        name: "min",
        parameters: &[many("a, b, ...", Takes::Number, 1, "the numbers")],
        summary: "the smallest of some numbers",
        example: "min(1/2, 1/3)",
        call: |_, args| extreme(args, false),
        ..NEW
    },
    Builtin {
        name: "map",
        parameters: &[
            required("F", Takes::Any, "the function, such as i -> i^2"),
            required("list", Takes::List, "what it is applied to, also a range such as 0..3"),
        ],
        summary: "the list of the values of a function; [i^2 for i = 0..3] is the same",
        example: "map(i -> i^2, 0..3)",
        call: |machine, args| {
            let Value::Function(function) = args.value(0)? else {
                return Err(wrong_kind("a function such as i -> i^2", args.value(0)?).at(args.span(0)));
            };
            let Value::List(items) = args.value(1)? else {
                return Err(wrong_kind("a list", args.value(1)?).at(args.span(1)));
            };
            let span = args.span(0);
            let value = |item: &Value| machine.call(function, vec![(item.clone(), args.span(1))], span);
            items.iter().map(value).collect::<Result<_, _>>().map(Value::List)
        },
        ..NEW
    },
    Builtin {
        name: "dot",
        parameters: &[
            required("a", Takes::Point, "a point or vector"),
            required("b", Takes::Point, "another one, of as many coordinates"),
        ],
        summary: "the scalar product of two points",
        example: "dot([1, 2], [3, 4])",
        call: |_, args| match (args.value(0)?, args.value(1)?) {
            (Value::List(a), Value::List(b)) => arithmetic::row_times_column(a, b),
            (Value::List(_), b) => Err(wrong_kind("a point such as [1, 2]", b).at(args.span(1))),
            (a, _) => Err(wrong_kind("a point such as [1, 2]", a).at(args.span(0))),
        },
        ..NEW
    },
    Builtin {
        name: "cross",
        parameters: &[
            required("a", Takes::Any, "a point of space"),
            required("b", Takes::Any, "another one"),
        ],
        summary: "the cross product of two points in space",
        example: "cross([1, 0, 0], [0, 1, 0])",
        call: |_, args| arithmetic::cross(args.value(0)?.clone(), args.value(1)?.clone()),
        ..NEW
    },
    Builtin {
        name: "length",
        parameters: &[required("list", Takes::List, "the list")],
        summary: "the number of items of a list",
        example: "length([1, 2, 3])",
        call: |_, args| match args.value(0)? {
            Value::List(items) => Ok(Value::int(items.len() as i64)),
            other => Err(wrong_kind("a list", other).at(args.span(0))),
        },
        ..NEW
    },
];

fn extreme(args: &Arguments, largest: bool) -> Result<Value, Diagnostic> {
    let mut best = args.rational(0)?;
    for i in 1..args.len() {
        let next = args.rational(i)?;
        if (next > best) == largest {
            best = next;
        }
    }
    Ok(Value::number(best))
}
