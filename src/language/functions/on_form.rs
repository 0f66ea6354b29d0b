//! What functions such as `derivative` do with the polar form of a surface.

use super::gives::Gives;
use std::sync::Arc;

use num_traits::{One, Zero};

use super::on_surface;
use super::parameter::{Need, Parameter, optional, required};
use super::record::Variant;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::polar_error;
use crate::language::ops::takes::Takes;
use crate::language::value::{Polar, PolarKind, Value};
use crate::math::poly::Fraction;

pub(super) const DERIVATIVE: Option<Variant> = Variant::new(
    &[
        required("f", Takes::Polar, "the polar form of a surface"),
        required(
            "r",
            Takes::OneOf(&[Takes::Size, Takes::Point]),
            "how often in the first variable; or a direction, for one of total degree",
        ),
        Parameter {
            need: Need::Many(0, usize::MAX),
            ..optional(
                "s",
                Takes::OneOf(&[Takes::Size, Takes::Point]),
                "0",
                "how often in the next one; or further directions",
            )
        },
    ],
    Gives::Polar,
    derivative,
);

/// The polar form of a partial derivative, or of one in given directions.
fn derivative(args: &Arguments) -> Evaluated {
    let f = args.polar(0)?;
    let orders = |count: usize| match args.len() - 1 {
        given if given > count => {
            let message = format!("the polynomial has {count} variables, {given} orders are given");
            Err(Diagnostic::error(Code::Arity, message)
                .at(args.span(count + 1))
                .hint("one order for each variable, as in derivative(f, 1, 0)"))
        }
        _ => Ok(()),
    };
    let kind = match &f.kind {
        PolarKind::Total(form) => {
            let directions = match on_surface::directions(args)? {
                Some(directions) => {
                    let size = form.dimension();
                    if let Some(i) = directions.iter().position(|direction| direction.len() != size) {
                        let message =
                            format!("a direction has {size} coordinates here, not {}", directions[i].len());
                        return Err(Diagnostic::error(Code::Shape, message).at(args.span(i + 1)));
                    }
                    directions.into_iter().map(Into::into).collect()
                }
                None => {
                    orders(form.dimension())?;
                    let mut list = Vec::new();
                    for (k, i) in (1..args.len()).enumerate() {
                        let entry = |j| if j == k { Fraction::one() } else { Fraction::zero() };
                        let unit = (0..form.dimension()).map(entry);
                        list.resize(list.len() + args.size(i)?, unit.collect::<Vec<_>>());
                    }
                    list
                }
            };
            form.derivative(&directions).map(PolarKind::Total)
        }
        PolarKind::Tensor(form) => {
            orders(2)?;
            form.derivative(args.size(1)?, args.optional_size(2)?.unwrap_or(0)).map(PolarKind::Tensor)
        }
        PolarKind::Univariate(form) => Ok(PolarKind::Univariate(form.nth_derivative(args.size(1)?))),
    };
    let kind = kind.map_err(polar_error).at(args.span(1))?;
    Ok(Value::Polar(Arc::new(Polar { kind, variables: f.variables.clone() })))
}
