//! Numbers.

use super::Builtin;
use crate::language::diagnostic::{At, Diagnostic};
use crate::language::ops::arithmetic;
use crate::language::ops::errors::wrong_kind;
use crate::language::value::Value;

const TOPIC: &str = "Numbers";

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "binomial",
        signature: "binomial(n, k)",
        summary: "the number of k-subsets of n things; n may be symbolic",
        example: "binomial(5, 2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("binomial(n, k)", 2..=2, &[])?;
            arithmetic::binomial(args.value(0)?, args.value(1)?)
        },
    },
    Builtin {
        name: "factorial",
        signature: "factorial(n)",
        summary: "1 2 ... n; also written n!",
        example: "factorial(5)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("factorial(n)", 1..=1, &[])?;
            arithmetic::factorial(args.value(0)?).at(args.span(0))
        },
    },
    Builtin {
        name: "max",
        signature: "max(a, b, ...)",
        summary: "the largest of some numbers",
        example: "max(1/2, 1/3)",
        topic: TOPIC,
        call: |_, args| extreme(args, "max(a, b, ...)", true),
    },
    Builtin {
        name: "min",
        signature: "min(a, b, ...)",
        summary: "the smallest of some numbers",
        example: "min(1/2, 1/3)",
        topic: TOPIC,
        call: |_, args| extreme(args, "min(a, b, ...)", false),
    },
    Builtin {
        name: "cross",
        signature: "cross(a, b)",
        summary: "the cross product of two points in space",
        example: "cross([1, 0, 0], [0, 1, 0])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("cross(a, b)", 2..=2, &[])?;
            arithmetic::cross(args.value(0)?.clone(), args.value(1)?.clone())
        },
    },
    Builtin {
        name: "length",
        signature: "length(list)",
        summary: "the number of items of a list",
        example: "length([1, 2, 3])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("length(list)", 1..=1, &[])?;
            match args.value(0)? {
                Value::List(items) => Ok(Value::int(items.len() as i64)),
                other => Err(wrong_kind("a list", other).at(args.span(0))),
            }
        },
    },
];

fn extreme(
    args: &crate::language::eval::Arguments,
    signature: &str,
    largest: bool,
) -> Result<Value, Diagnostic> {
    args.expect(signature, 1..=usize::MAX, &[])?;
    let mut best = args.rational(0)?;
    for i in 1..args.len() {
        let next = args.rational(i)?;
        if (next > best) == largest {
            best = next;
        }
    }
    Ok(Value::number(best))
}
