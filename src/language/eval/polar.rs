//! Calls of polar forms.

use std::sync::Arc;

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::errors::{polar_error, wrong_kind};
use crate::language::ops::polar::{argument, point_argument};
use crate::language::value::{Polar, PolarKind, Value};
use crate::math::blossom::Argument;
use crate::math::poly::Fraction;

impl Machine {
    pub(crate) fn call_polar(
        &mut self,
        polar: &Arc<Polar>,
        groups: &[Vec<Expr>],
        callee: &Expr,
        span: Span,
    ) -> Evaluated {
        match &polar.kind {
            PolarKind::Univariate(form) => {
                let values = self.polar_arguments(groups, form.degree())?;
                let list: Result<Vec<_>, _> = values.into_iter().map(placed).collect();
                let list = list?;
                form.value(&list)
                    .map(Value::Scalar)
                    .map_err(polar_error)
                    .map_err(|error| explain_count(error, callee, form.degree(), list.len()))
                    .at(span)
            }
            PolarKind::Tensor(form) => {
                let (m, n) = form.degrees();
                let groups: Vec<Vec<Expr>> = match groups {
                    // Without a semicolon the first m arguments are the u's.
                    [all] if all.len() == m + n => vec![all[..m].to_vec(), all[m..].to_vec()],
                    other => other.to_vec(),
                };
                let [u, v] = groups.as_slice() else {
                    return Err(Diagnostic::error(
                        Code::Arity,
                        format!("this polar form takes {m} and {n} arguments, separated by ';'"),
                    )
                    .at(span)
                    .hint("write f(u1, u2; v1, v2)"));
                };
                let u = self.polar_arguments(std::slice::from_ref(u), m)?;
                let v = self.polar_arguments(std::slice::from_ref(v), n)?;
                let u: Result<Vec<_>, _> = u.into_iter().map(placed).collect();
                let v: Result<Vec<_>, _> = v.into_iter().map(placed).collect();
                form.value(&u?, &v?).map(Value::Scalar).map_err(polar_error).at(span)
            }
            PolarKind::Total(form) => {
                let values = self.polar_arguments(groups, form.degree())?;
                let mut list = Vec::with_capacity(values.len());
                for (value, place) in values {
                    list.push(point_argument(&value).ok_or_else(|| {
                        wrong_kind("a point such as (u1, v1)", &value)
                            .at(place)
                            .hint("the arguments of this polar form are points: f((u1, v1), (u2, v2))")
                    })?);
                }
                form.value(&list).map(Value::Scalar).map_err(polar_error).at(span)
            }
        }
    }

    /// Arguments of a polar form of known degree; `f(t, ..., t)` is filled up to it.
    pub(super) fn polar_arguments(
        &mut self,
        groups: &[Vec<Expr>],
        degree: usize,
    ) -> Result<Vec<(Value, Span)>, Diagnostic> {
        let [group] = groups else { return self.arguments(groups) };
        let written_out = group.iter().any(|item| matches!(item.kind, Kind::Ellipsis | Kind::Brace(..)));
        if !written_out
            && group.len() != degree
            && let Some(values) = self.powers_as_arguments(group, degree)?
        {
            return Ok(values);
        }
        let Some(at) = group.iter().position(|e| e.kind == Kind::Ellipsis) else {
            return self.arguments(groups);
        };
        let same = at > 0 && group.get(at + 1).is_some_and(|after| after.same_as(&group[at - 1]));
        let others = group.len() - 1;
        if !same || others > degree || group.iter().any(|e| matches!(e.kind, Kind::Brace(..))) {
            return self.arguments(groups);
        }
        // f(t, ..., t, u): the ellipsis stands for as many more t as are missing.
        let mut values = Vec::with_capacity(degree);
        for item in &group[..at] {
            values.push((self.eval(item)?, item.span));
        }
        let filler = values[at - 1].clone();
        values.extend(std::iter::repeat_n(filler, degree - others));
        for item in &group[at + 1..] {
            values.push((self.eval(item)?, item.span));
        }
        Ok(values)
    }

    /// The arguments in f(0^{n-i} 1^i) or f(0^2, t), where powers are repetitions: only if there
    /// would be a wrong number of arguments otherwise, and this way there is the right one.
    fn powers_as_arguments(
        &mut self,
        group: &[Expr],
        degree: usize,
    ) -> Result<Option<Vec<(Value, Span)>>, Diagnostic> {
        let factors = group.iter().flat_map(|item| match &item.kind {
            Kind::Mul(factors) => factors.as_slice(),
            _ => std::slice::from_ref(item),
        });
        let mut repeated = Vec::new();
        let mut total = 0_usize;
        for factor in factors {
            let (base, count) = match &factor.kind {
                Kind::Pow(base, exponent) => (base.as_ref(), self.eval(exponent)?.as_int()),
                _ => (factor, Some(1)),
            };
            let Some(count) = count.and_then(|count| usize::try_from(count).ok()) else { return Ok(None) };
            total = total.saturating_add(count);
            repeated.push((base, count));
        }
        if total != degree {
            return Ok(None);
        }
        let mut values = Vec::with_capacity(degree);
        for (base, count) in repeated {
            let value = self.eval(base)?;
            values.extend(std::iter::repeat_n((value, base.span), count));
        }
        Ok(Some(values))
    }
}

fn placed((value, place): (Value, Span)) -> Result<Argument<Fraction>, Diagnostic> {
    argument(value).at(place)
}

fn explain_count(error: Diagnostic, callee: &Expr, degree: usize, given: usize) -> Diagnostic {
    if error.code != Code::Arity {
        return error;
    }
    let name = match &callee.kind {
        Kind::Name(name) => name.clone(),
        _ => "f".to_owned(),
    };
    if given == 1 {
        error.hint(format!("arguments are separated by commas: {name}(0, 0, 1)")).hint(format!(
            "the polynomial itself is diagonal({name}), and partial({name}, ...) leaves arguments free"
        ))
    } else if given < degree {
        error.hint(format!("partial({name}, ...) puts in some arguments and leaves the others free"))
    } else {
        error.hint(format!("elevate({name}, {}) has as many arguments", given - degree))
    }
}
