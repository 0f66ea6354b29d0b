//! Symmetric functions of arguments, and the laws of polar forms.

use super::gives::Gives;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::lexicon::families;
use crate::language::ops::errors::{division_by_zero, polar_error};
use crate::language::ops::polar::laws_report;
use crate::language::value::{Polar, PolarKind, Value};
use crate::math::blossom::laws::ArgumentNames;
use crate::math::blossom::{PolarForm, symmetrize};
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use num_traits::{One, Zero};

use super::Builtin;
use super::parameter::{many, required, size};
use super::polar::symbols;
use crate::language::ops::takes::Takes;

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Polar forms");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "symmetrize",
        parameters: &[
            required("expression", Takes::Scalar, "a formula in the arguments"),
            required("arguments", Takes::Variables, "the arguments that are permuted")
                .shown("[t_1, ..., t_n]"),
        ],
        summary: "the mean of an expression over all permutations of the given arguments",
        gives: Gives::Scalar,
        example: "symmetrize(t1 t2 + t1, [t1, t2])",
        call: |_, args| {
            let expression = args.scalar(0)?;
            let names = symbols(args, 1)?;
            if expression.denominator().variables().iter().any(|s| names.contains(s)) {
                return Err(Diagnostic::error(Code::NotPolynomial, "an argument stands in the denominator")
                    .at(args.span(0)));
            }
            let arrangement = ArgumentNames::new(vec![names.into_iter().map(|s| vec![s]).collect()]);
            let mean = symmetrize(expression.numerator(), &arrangement);
            Fraction::new(mean, expression.denominator().clone())
                .map(Value::Scalar)
                .map_err(|_| division_by_zero())
        },
        ..NEW
    },
    Builtin {
        name: "sigma",
        parameters: &[
            size("i", "how many factors each product has"),
            size("n", "the number of arguments"),
            many("t_1, ..., t_n", Takes::ScalarOrList, 0, "the arguments"),
        ],
        summary: "the mean of all products of i of n arguments; also written sigma_{i,n}(...)",
        gives: Gives::Scalar,
        example: "sigma(2, 3, t1, t2, t3)",
        call: |_, args| {
            let (i, n) = (args.size(0)?, args.size(1)?);
            let list = trailing_scalars(args, 2)?;
            if list.len() != n {
                return Err(Diagnostic::error(
                    Code::Arity,
                    format!("sigma_{{{i},{n}}} takes {n} arguments, not {}", list.len()),
                ));
            }
            if i > n {
                return Ok(Value::int(0));
            }
            families::symmetric_mean(i, &list).map(Value::Scalar).map_err(polar_error)
        },
        ..NEW
    },
    Builtin {
        name: "esym",
        parameters: &[
            size("i", "how many factors each product has"),
            many("t_1, ..., t_n", Takes::ScalarOrList, 0, "the arguments"),
        ],
        summary: "the elementary symmetric function e_i: the sum of all products of i arguments",
        gives: Gives::Scalar,
        example: "esym(2, t1, t2, t3)",
        call: |_, args| {
            let i = args.size(0)?;
            Ok(Value::Scalar(elementary(&trailing_scalars(args, 1)?, i)))
        },
        ..NEW
    },
    Builtin {
        name: "laws",
        parameters: &[
            required("expression", Takes::Scalar, "a formula in the arguments"),
            required("arguments", Takes::Variables, "the arguments of the form").shown("[t_1, ..., t_n]"),
            required("F", Takes::Polynomial, "the polynomial"),
        ],
        summary: "whether an expression is the polar form of F, and if not, which law fails and why",
        gives: Gives::Any,
        example: "laws(t1^2, [t1, t2], t^2)",
        call: |_, args| {
            let expression = args.scalar(0)?;
            let names = symbols(args, 1)?;
            let given = args.univariate(2)?;
            let form = PolarForm::with_degree(given.coefficients, names.len()).map_err(polar_error)?;
            let polar = Polar { kind: PolarKind::Univariate(form), variables: vec![given.variable] };
            let arrangement = ArgumentNames::new(vec![names.into_iter().map(|s| vec![s]).collect()]);
            let lines = laws_report(&polar, &expression, &arrangement);
            Ok(match lines.as_slice() {
                [] => Value::Text("symmetric, multi-affine, right diagonal: it is the polar form".into()),
                many => Value::List(many.iter().cloned().map(Value::Text).collect()),
            })
        },
        ..NEW
    },
];

/// Scalars from place `from` on, or those of a single list there.
fn trailing_scalars(args: &Arguments, from: usize) -> Result<Vec<Fraction>> {
    match args.len() == from + 1 {
        true => args.scalars_or_list(from),
        false => args.scalars_from(from),
    }
}

/// e_i of any scalars, by the recurrence over the arguments. Cost: O(i n) products.
fn elementary(list: &[Fraction], i: usize) -> Fraction {
    if i > list.len() {
        return Fraction::zero();
    }
    let mut e = vec![Fraction::zero(); i + 1];
    e[0] = Fraction::one();
    for u in list {
        for k in (1..=i).rev() {
            e[k] = e[k].plus(&e[k - 1].times(u));
        }
        crate::budget::charge_terms(e.iter().map(Ring::size).sum());
    }
    e.swap_remove(i)
}
