//! `polarform interpolate`: queries for polynomials and splines through points.

use super::Status;
use super::argument_reader::{ArgumentReader, Failed, bound};
use super::arguments::{Interpolate, Interpolation};
use super::commands::Ran;
use super::output::Output;
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel, applied, call, named};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Value, symbol_expr};
use crate::language::write::Format;
use crate::math::poly::Symbol;
use crate::session::{Failure, Session};

pub(super) fn run(wanted: &Interpolate, session: &mut Session, output: &Output) -> Ran {
    fitting(wanted)?;
    let mut reader = ArgumentReader::new(output);
    let (variable, symbol) = variable(&mut reader, session, &wanted.variable)?;
    let data = Data::read(&mut reader, wanted)?;
    let at = match &wanted.at {
        None => None,
        Some(at) => Some(reader.formula("at", at)?),
    };
    let (function, letter) = match wanted.method {
        Interpolation::Lagrange | Interpolation::Neville | Interpolation::Aitken => ("lagrange", "p"),
        Interpolation::Newton => ("newton", "p"),
        Interpolation::Hermite => ("hermite", "p"),
        Interpolation::Spline => ("cubic_spline", "S"),
        Interpolation::LeastSquares => ("least_squares", "p"),
    };
    let value = reader.evaluate(session, data.with_variable(function, &variable))?;
    let t = || symbol_expr(&symbol);
    if wanted.steps {
        let parameter = || at.clone().unwrap_or_else(|| variable.clone());
        let steps = match wanted.method {
            Interpolation::Lagrange => data.of_nodes("lagrange_basis", &variable),
            Interpolation::Newton => data.call("divided_differences", vec![]),
            Interpolation::Hermite => data.call("hermite_table", vec![]),
            Interpolation::Neville => data.call("neville", vec![parameter()]),
            Interpolation::Aitken => data.call("aitken", vec![parameter()]),
            Interpolation::Spline => data.call("spline_system", vec![]),
            Interpolation::LeastSquares => data.with_variable("least_squares_report", &variable),
        };
        match reader.evaluate(session, steps)? {
            Value::List(items) => {
                for (j, item) in items.iter().enumerate() {
                    output.value(item, Some(Expr::apply(Expr::indexed("L", j as i64), vec![t()])))?;
                }
            }
            table => output.value(&table, None)?,
        }
    }
    match at {
        None => named_value(output, &value, Expr::apply(Expr::name(letter), vec![t()]))?,
        Some(at) => {
            let found = value_at(&reader, session, &value, &variable, &at)?;
            output.value(&found, Some(Expr::apply(Expr::name(letter), vec![at])))?;
        }
    }
    Ok(Status::Fine)
}

/// Options that say nothing for a method are a mistake.
fn fitting(wanted: &Interpolate) -> Failed<()> {
    let spline = wanted.method == Interpolation::Spline;
    let squares = wanted.method == Interpolation::LeastSquares;
    let degree = wanted.degree.map(|degree| degree.to_string());
    for (option, given, fits, method) in [
        ("--ends", &wanted.ends, spline, "spline"),
        ("--slopes", &wanted.slopes, spline, "spline"),
        ("--by", &wanted.by, spline, "spline"),
        ("--degree", &degree, squares, "least-squares"),
        ("--weights", &wanted.weights, squares, "least-squares"),
    ] {
        if let Some(text) = given.as_ref().filter(|_| !fits) {
            let problem = Diagnostic::error(Code::Usage, format!("{option} says nothing for this method"));
            return Err(failure(problem.hint(format!("it belongs to --method {method}")), option, text));
        }
    }
    if squares && wanted.degree.is_none() {
        let problem = Diagnostic::error(Code::Usage, "least squares need the degree of the polynomial");
        return Err(failure(problem.hint("--degree 1 is a straight line"), "--nodes", &wanted.nodes));
    }
    Ok(())
}

/// A problem with the whole text of an option.
fn failure(problem: Diagnostic, option: &str, text: &str) -> Box<Failure> {
    let file = SourceFile::new(format!("<{}>", option.trim_start_matches('-')), text);
    Box::new(Failure { problem: problem.at(Span::new(0, text.len())), file })
}

/// The variable as it was given, and what it is.
fn variable(reader: &mut ArgumentReader, session: &mut Session, name: &str) -> Failed<(Expr, Symbol)> {
    let variable = reader.formula("variable", name)?;
    let value = reader.evaluate(session, variable.clone())?;
    let symbol = value.as_scalar().and_then(|f| match f.as_polynomial()?.variables() {
        [symbol] if value == Value::symbol(symbol.clone()) => Some(symbol.clone()),
        _ => None,
    });
    match symbol {
        Some(symbol) => Ok((variable, symbol)),
        None => {
            let message = format!("expected a variable, found {}", value.kind());
            let problem = Diagnostic::error(Code::Type, message).at(variable.span);
            Err(reader.failure(problem.hint("a single letter such as s")))
        }
    }
}

/// What is interpolated, and how.
struct Data {
    nodes: Expr,
    /// The arguments of a query.
    all: Vec<Expr>,
}

impl Data {
    fn read(reader: &mut ArgumentReader, wanted: &Interpolate) -> Failed<Self> {
        let (nodes, mut all) = match wanted.method {
            Interpolation::Hermite => {
                let rows = hermite_rows(reader, wanted)?;
                (rows.clone(), vec![rows])
            }
            _ => {
                let nodes = reader.list("nodes", &wanted.nodes)?;
                (nodes.clone(), vec![nodes, reader.list("values", &wanted.values)?])
            }
        };
        if let Some(degree) = wanted.degree {
            all.push(reader.number("degree", degree));
        }
        for (name, given) in [("slopes", &wanted.slopes), ("weights", &wanted.weights)] {
            if let Some(given) = given {
                all.push(named(name, reader.list(name, given)?));
            }
        }
        for (name, option, given) in [("ends", "ends", &wanted.ends), ("method", "by", &wanted.by)] {
            if let Some(given) = given {
                all.push(named(name, reader.formula(option, given)?));
            }
        }
        Ok(Data { nodes, all })
    }

    fn call(&self, function: &str, more: Vec<Expr>) -> Expr {
        call(function, self.all.iter().cloned().chain(more).collect(), self.nodes.span)
    }

    fn with_variable(&self, function: &str, variable: &Expr) -> Expr {
        self.call(function, vec![named("variable", variable.clone())])
    }

    fn of_nodes(&self, function: &str, variable: &Expr) -> Expr {
        call(function, vec![self.nodes.clone(), named("variable", variable.clone())], self.nodes.span)
    }
}

/// `[[x_0, f, f', …], …]`
fn hermite_rows(reader: &mut ArgumentReader, wanted: &Interpolate) -> Failed<Expr> {
    let nodes = reader.items("nodes", &wanted.nodes)?;
    let whole = reader.last_span();
    let values = reader.items("values", &wanted.values)?;
    if nodes.len() != values.len() {
        let message = format!("{} lists of values needed, {} given", nodes.len(), values.len());
        let problem = Diagnostic::error(Code::Shape, message).at(reader.last_span());
        return Err(reader.failure(problem.hint("give [f, f', ...] for each node")));
    }
    let rows = nodes.into_iter().zip(values).map(|(node, own)| {
        let span = node.span;
        let mut row = vec![node];
        match own.kind {
            Kind::List(items) | Kind::Tuple(items) => row.extend(items),
            _ => row.push(own),
        }
        Expr::new(Kind::List(row), span)
    });
    Ok(Expr::new(Kind::List(rows.collect()), whole))
}

/// The value of what was found, at a parameter.
fn value_at(
    reader: &ArgumentReader,
    session: &mut Session,
    value: &Value,
    variable: &Expr,
    at: &Expr,
) -> Failed<Value> {
    let span = at.span;
    let found = bound(session, "<found>", value.clone(), span);
    match value {
        Value::List(items) => items
            .iter()
            .map(|item| value_at(reader, session, item, variable, at))
            .collect::<Failed<_>>()
            .map(Value::List),
        Value::Scalar(_) => {
            reader.evaluate(session, call("subs", vec![found, variable.clone(), at.clone()], span))
        }
        _ => reader.evaluate(session, applied(found, vec![at.clone()], span)),
    }
}

/// `p(t) = …`; a function in Newton's form as it is written.
fn named_value(output: &Output, value: &Value, name: Expr) -> Result<(), super::output::Trouble> {
    let body = |value: &Value| match value {
        Value::Function(function) => function.clauses.first().map(|clause| clause.body.clone()),
        _ => None,
    };
    let formula = match value {
        Value::List(items) => {
            let bodies: Option<Vec<Expr>> = items.iter().map(body).collect();
            bodies.filter(|bodies| !bodies.is_empty()).map(|bodies| Kind::List(bodies).into())
        }
        one => body(one),
    };
    match (formula, output.format) {
        (Some(formula), Format::Text | Format::Unicode | Format::Latex) => {
            Ok(output.line(&output.written(&Expr::relation(name, Rel::Eq, formula))?)?)
        }
        _ => output.value(value, Some(name)),
    }
}
