//! The commands about curves: each is a query of the language.

use super::argument_reader::{ArgumentReader, Failed};
use super::arguments::{BezierArguments, BsplineArguments, Change};
use crate::formula::{Expr, Kind, applied, call, named};
use crate::language::diagnostic::{Code, Diagnostic};

/// function(curve, items); what is wrong with the call is wrong with the items.
fn with_items(
    reader: &mut ArgumentReader,
    function: &str,
    curve: Expr,
    option: &str,
    text: &str,
) -> Failed<Expr> {
    let mut arguments = vec![curve];
    arguments.extend(reader.arguments(option, text)?);
    Ok(call(function, arguments, reader.last_span()))
}

/// The curve with the changes made.
fn changed(reader: &mut ArgumentReader, mut curve: Expr, change: &Change) -> Expr {
    for (name, order) in
        [("elevate", change.elevate), ("reduce", change.reduce), ("derivative", change.derivative)]
    {
        if let Some(order) = order {
            let order = reader.number(name, order);
            let span = order.span;
            curve = call(name, vec![curve, order], span);
        }
    }
    curve
}

/// The value at a parameter.
fn at(reader: &mut ArgumentReader, curve: Expr, text: &str) -> Failed<Expr> {
    let parameter = reader.arguments("at", text)?;
    Ok(applied(curve, parameter, reader.last_span()))
}

/// The weights, if there are any, among the arguments of a curve.
fn weigh(reader: &mut ArgumentReader, curve: &mut Vec<Expr>, weights: Option<&String>) -> Failed<()> {
    if let Some(weights) = weights {
        curve.push(named("weights", reader.list("weights", weights)?));
    }
    Ok(())
}

/// The query of `polarform bezier`.
pub(super) fn bezier(reader: &mut ArgumentReader, arguments: &BezierArguments) -> Failed<Expr> {
    let mut curve = vec![reader.points("points", &arguments.points)?];
    let mut span = reader.last_span();
    if let Some(ends) = &arguments.interval {
        curve.extend(reader.arguments("interval", ends)?);
        span = reader.last_span();
    }
    weigh(reader, &mut curve, arguments.weights.as_ref())?;
    let curve = call("bezier", curve, span);
    let curve = changed(reader, curve, &arguments.change);
    if let Some(t) = &arguments.at {
        at(reader, curve, t)
    } else if let Some(list) = &arguments.scheme {
        with_items(reader, "casteljau", curve, "scheme", list)
    } else if let Some(list) = &arguments.subdivide {
        with_items(reader, "subdivide", curve, "subdivide", list)
    } else {
        Ok(curve)
    }
}

/// The query of `polarform bspline`.
pub(super) fn bspline(reader: &mut ArgumentReader, arguments: &BsplineArguments) -> Failed<Expr> {
    if arguments.span.is_some()
        && arguments.at.is_none()
        && arguments.scheme.is_none()
        && arguments.insert.is_none()
    {
        let problem = Diagnostic::error(Code::Usage, "--span names the knot interval of a parameter")
            .hint("give --at, --scheme or --insert with it");
        return Err(reader.failure(problem));
    }
    let degree = reader.number("degree", arguments.degree);
    let knots = reader.list("knots", &arguments.knots)?;
    let span = knots.span;
    let Some(points) = arguments.points.as_ref().or(arguments.listed.as_ref()) else {
        return basis_function(reader, arguments, vec![degree, knots]);
    };
    let mut curve = vec![degree, knots, reader.points("points", points)?];
    weigh(reader, &mut curve, arguments.weights.as_ref())?;
    let mut curve = call("bspline", curve, span);
    if let Some(list) = &arguments.insert {
        curve = with_items(reader, "insert_knots", curve, "insert", list)?;
        name_interval(reader, &mut curve, arguments.span);
    }
    if let Some(t) = &arguments.remove {
        curve = with_items(reader, "remove_knot", curve, "remove", t)?;
    }
    let curve = changed(reader, curve, &arguments.change);
    let span = curve.span;
    if let Some(t) = &arguments.at {
        let mut value = at(reader, curve, t)?;
        name_interval(reader, &mut value, arguments.span);
        Ok(value)
    } else if let Some(list) = &arguments.scheme {
        scheme(reader, curve, list, arguments.span)
    } else if arguments.pieces {
        Ok(call("pieces", vec![curve], span))
    } else if arguments.labels {
        Ok(call("labels", vec![curve], span))
    } else {
        Ok(curve)
    }
}

/// Adds the knot interval to a call, if it was named.
fn name_interval(reader: &mut ArgumentReader, call: &mut Expr, interval: Option<usize>) {
    if let (Kind::Apply(_, groups), Some(interval)) = (&mut call.kind, interval)
        && let Some(group) = groups.first_mut()
    {
        group.push(named("span", reader.number("span", interval)));
    }
}

fn basis_function(
    reader: &mut ArgumentReader,
    arguments: &BsplineArguments,
    mut start: Vec<Expr>,
) -> Failed<Expr> {
    let span = reader.last_span();
    start.push(reader.number("basis", arguments.basis.unwrap_or(0)));
    let function = call("bspline_basis", start, span);
    let function = match arguments.change.derivative {
        Some(order) => {
            let order = reader.number("derivative", order);
            call("derivative", vec![function, order], reader.last_span())
        }
        None => function,
    };
    match &arguments.at {
        Some(t) => at(reader, function, t),
        None => Ok(function),
    }
}

/// De Boor's scheme.
fn scheme(reader: &mut ArgumentReader, curve: Expr, list: &str, interval: Option<usize>) -> Failed<Expr> {
    let mut arguments = vec![curve];
    arguments.extend(reader.arguments("scheme", list)?);
    let span = reader.last_span();
    if let Some(interval) = interval {
        arguments.push(named("span", reader.number("span", interval)));
    }
    Ok(call("deboor", arguments, span))
}
