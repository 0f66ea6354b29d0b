//! `polarform interpolate`: queries for polynomials and splines through points.

use super::Status;
use super::arguments::{Interpolate, Interpolation};
use super::commands::{Ran, evaluated, formula, list, operand, query};
use super::output::Output;
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Value, symbol_expr};
use crate::language::write::{Format, text};
use crate::math::poly::Symbol;
use crate::session::{Failure, Session};

type Failed<T> = Result<T, Box<Failure>>;

pub(super) fn run(wanted: &Interpolate, session: &mut Session, output: &Output) -> Ran {
    fitting(wanted)?;
    let file = SourceFile::new("<variable>", wanted.variable.as_str());
    let variable = variable(session, &file)?;
    // Queries are written out, so that what is wrong is shown in them.
    let ask = |session: &mut Session, text: String| operand(session, &SourceFile::new("<interpolate>", text));
    let Data { positional, options } = data(wanted)?;
    let call = |function: &str, more: &str| format!("{function}({positional}{options}{more})");
    let named = |function: &str| call(function, &format!(", variable={}", wanted.variable));
    let at = match &wanted.at {
        None => None,
        Some(at) => {
            let file = SourceFile::new("<at>", at.as_str());
            Some((operand(session, &file)?, formula(&file)?, file))
        }
    };
    let (function, letter) = match wanted.method {
        Interpolation::Lagrange | Interpolation::Neville | Interpolation::Aitken => ("lagrange", "p"),
        Interpolation::Newton => ("newton", "p"),
        Interpolation::Hermite => ("hermite", "p"),
        Interpolation::Spline => ("cubic_spline", "S"),
        Interpolation::LeastSquares => ("least_squares", "p"),
    };
    let value = ask(session, named(function))?;
    let t = || symbol_expr(&variable);
    if wanted.steps {
        let parameter = wanted.at.as_deref().unwrap_or(&wanted.variable);
        let steps = match wanted.method {
            Interpolation::Lagrange => {
                format!("lagrange_basis({}, variable={})", nodes(wanted)?, wanted.variable)
            }
            Interpolation::Newton => call("divided_differences", ""),
            Interpolation::Hermite => call("hermite_table", ""),
            Interpolation::Neville => call("neville", &format!(", {parameter}")),
            Interpolation::Aitken => call("aitken", &format!(", {parameter}")),
            Interpolation::Spline => call("spline_system", ""),
            Interpolation::LeastSquares => named("least_squares_report"),
        };
        match ask(session, steps)? {
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
        Some((parameter, shown, file)) => {
            session.env.set(Symbol::new("u"), parameter);
            let found = value_at(session, &file, &value, &variable)?;
            output.value(&found, Some(Expr::apply(Expr::name(letter), vec![shown])))?;
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

fn variable(session: &mut Session, file: &SourceFile) -> Failed<Symbol> {
    let value = operand(session, file)?;
    let symbol = value.as_scalar().and_then(|f| match f.as_polynomial()?.variables() {
        [symbol] if value == Value::symbol(symbol.clone()) => Some(symbol.clone()),
        _ => None,
    });
    symbol.ok_or_else(|| {
        let problem = Diagnostic::error(Code::Type, format!("expected a variable, found {}", value.kind()));
        failure(problem.hint("a single letter such as s"), "variable", file.text())
    })
}

/// The first arguments of a query, and those with names.
struct Data {
    positional: String,
    options: String,
}

fn data(wanted: &Interpolate) -> Failed<Data> {
    let nodes = nodes(wanted)?;
    let positional = match wanted.method {
        Interpolation::Hermite => hermite_rows(wanted)?,
        _ => format!("{nodes}, {}", bracketed("values", &wanted.values)?),
    };
    let mut options = String::new();
    if let Some(degree) = wanted.degree {
        options.push_str(&format!(", {degree}"));
    }
    for (name, given) in [("slopes", &wanted.slopes), ("weights", &wanted.weights)] {
        if let Some(given) = given {
            options.push_str(&format!(", {name}={}", bracketed(name, given)?));
        }
    }
    for (name, option, given) in [("ends", "ends", &wanted.ends), ("method", "by", &wanted.by)] {
        if let Some(given) = given {
            let word = formula(&SourceFile::new(format!("<{option}>"), given.as_str()))?;
            options.push_str(&format!(", {name}={}", text(&word)));
        }
    }
    Ok(Data { positional, options })
}

fn nodes(wanted: &Interpolate) -> Failed<String> {
    bracketed("nodes", &wanted.nodes)
}

/// `0, 1, 2` as a list; a list or a range stays one.
fn bracketed(name: &str, given: &str) -> Failed<String> {
    let items = list(&SourceFile::new(format!("<{name}>"), given))?;
    Ok(match items.as_slice() {
        [Expr { kind: Kind::Range(..), .. }] => text(&items[0]),
        [Expr { kind: Kind::List(inner), .. }] if !inner.iter().any(is_list) || inner.iter().all(is_list) => {
            text(&items[0])
        }
        _ => text(&Kind::List(items).into()),
    })
}

fn is_list(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::List(_))
}

/// `[[x_0, f, f', …], …]`
fn hermite_rows(wanted: &Interpolate) -> Failed<String> {
    let nodes = list(&SourceFile::new("<nodes>", wanted.nodes.as_str()))?;
    let values = list(&SourceFile::new("<values>", wanted.values.as_str()))?;
    if nodes.len() != values.len() {
        let message = format!("{} lists of values needed, {} given", nodes.len(), values.len());
        let problem = Diagnostic::error(Code::Shape, message).hint("give [f, f', ...] for each node");
        return Err(failure(problem, "values", &wanted.values));
    }
    let rows = nodes.into_iter().zip(values).map(|(node, own)| {
        let mut row = vec![node];
        match own.kind {
            Kind::List(items) => row.extend(items),
            _ => row.push(own),
        }
        Kind::List(row).into()
    });
    Ok(text(&Kind::List(rows.collect()).into()))
}

/// The value of what was found at the parameter called u.
fn value_at(session: &mut Session, file: &SourceFile, value: &Value, variable: &Symbol) -> Failed<Value> {
    let span = Span::new(0, file.text().len());
    match value {
        Value::List(items) => items
            .iter()
            .map(|item| value_at(session, file, item, variable))
            .collect::<Failed<_>>()
            .map(Value::List),
        Value::Scalar(_) => {
            session.env.set(Symbol::new("p"), value.clone());
            let arguments = vec![Expr::name("p"), symbol_expr(variable), Expr::name("u")];
            query(session, file, span, "subs", arguments, vec![])
        }
        _ => {
            session.env.set(Symbol::new("S"), value.clone());
            let argument = Expr::new(Kind::Name("u".to_owned()), span);
            let call = Kind::Apply(Box::new(Expr::name("S")), vec![vec![argument]]);
            evaluated(session, file, Expr::new(call, span))
        }
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
