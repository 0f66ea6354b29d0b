//! Derivations in the language.

use std::sync::Arc;

use super::Builtin;
use super::interpolation::{self, Samples};
use crate::language::derive::{self, Combination};
use crate::language::diagnostic::{At, Code, Diagnostic, nearest};
use crate::language::eval::Callable;
use crate::language::eval::{Arguments, Evaluated, Machine};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use crate::language::value::{Derivation, Geometry, Language, Polar, PolarKind, Value};
use crate::math::blossom::{Method, PolarForm};
use crate::math::interpolate::{CubicSpline, DividedDifferences};
use crate::math::poly::{Fraction, Symbol};

type Result<T> = std::result::Result<T, Diagnostic>;

const TOPIC: &str = "Derivations";

const SIGNATURE: &str = "derive(what, ..., lang=en)";

pub(super) const TABLE: &[Builtin] = &[Builtin {
    name: "derive",
    signature: SIGNATURE,
    summary: "how something is found, line by line with reasons; docs/derivations.md lists what",
    example: "derive(product, t^2 + 2t, t + 1)",
    topic: TOPIC,
    call: derive,
}];

/// What can be derived: its word, its form, and the way.
type Subject = (&'static str, &'static str, fn(&mut Machine, &Arguments, &str) -> Result<Derivation>);

const SUBJECTS: &[Subject] = &[
    ("polar", "derive(polar, F, method=elementary, degree=n, variable=t)", polar),
    ("sum", "derive(sum, F, G)", sum),
    ("product", "derive(product, F, G)", product),
    ("compose", "derive(compose, F, G)", compose),
    ("derivative", "derive(derivative, F, k)", derivative),
    ("elevate", "derive(elevate, F, k)", elevate),
    ("matrix", "derive(matrix, n)", matrix),
    ("inverse_matrix", "derive(inverse_matrix, n)", inverse_matrix),
    ("casteljau", "derive(casteljau, c, u_1, ..., u_n)", casteljau),
    ("deboor", "derive(deboor, s, u_1, ..., u_n, span=j)", deboor),
    ("insert", "derive(insert, s, t)", insert),
    ("join", "derive(join, c, d, k)", join),
    ("newton", "derive(newton, [x_0, ..., x_n], [y_0, ..., y_n])", newton),
    ("moments", "derive(moments, [x_0, ..., x_n], [y_0, ..., y_n], ends=natural)", moments),
];

fn derive(machine: &mut Machine, args: &Arguments) -> Evaluated {
    let Value::Text(what) = args.value(0).map_err(|error| error.hint(known_subjects()))? else {
        return Err(wrong_kind("the name of a derivation", args.value(0)?)
            .at(args.span(0))
            .hint(known_subjects()));
    };
    let Some((_, form, subject)) = SUBJECTS.iter().find(|(name, ..)| name == what) else {
        let error = Diagnostic::error(Code::UnknownFunction, format!("there is no derivation '{what}'"));
        let best = nearest(what, SUBJECTS.iter().map(|(name, ..)| *name));
        return Err(error
            .at(args.span(0))
            .hint(best.map_or_else(known_subjects, |best| format!("did you mean '{best}'?"))));
    };
    let language = match args.named_or("lang", usize::MAX) {
        Some((Value::Text(code), span)) => Some(
            code.parse::<Language>()
                .map_err(|message| Diagnostic::error(Code::Domain, message).at(span).hint("lang=en"))?,
        ),
        Some((other, span)) => return Err(wrong_kind("a language", other).at(span).hint("lang=en")),
        None => None,
    };
    let mut derivation = subject(machine, &args.after_first(&["lang"]), form)?;
    derivation.language = language;
    Ok(Value::Derivation(Arc::new(derivation)))
}

fn known_subjects() -> String {
    let names: Vec<&str> = SUBJECTS.iter().map(|(name, ..)| *name).collect();
    format!("what can be derived: {}", names.join(", "))
}

/// A word under a name.
fn word<'a>(args: &'a Arguments, name: &str) -> Result<Option<(&'a str, crate::formula::source::Span)>> {
    match args.named_or(name, usize::MAX) {
        Some((Value::Text(word), span)) => Ok(Some((word, span))),
        Some((other, span)) => Err(wrong_kind("a word", other).at(span)),
        None => Ok(None),
    }
}

/// The polar forms of a polynomial or of the coordinates of a curve.
fn polars(machine: &mut Machine, args: &Arguments) -> Result<Vec<Arc<Polar>>> {
    let builtin = super::builtin("polar").ok_or_else(internal)?;
    let one = |value: Value| match value {
        Value::Polar(polar) => Ok(polar),
        other => Err(wrong_kind("a polynomial", &other).at(args.span(0))),
    };
    // Polar forms need no making; they keep their numbers of arguments.
    let made = match args.value(0)? {
        Value::Polar(polar) => Some(vec![polar.clone()]),
        Value::List(items) => items.iter().cloned().map(|item| one(item).ok()).collect(),
        _ => None,
    };
    if let Some(polars) = made.filter(|polars| !polars.is_empty() && !args.has("degree")) {
        return Ok(polars);
    }
    match builtin.run(machine, args.clone()).at(args.span(0))? {
        Value::List(items) => items.into_iter().map(one).collect(),
        value => one(value).map(|polar| vec![polar]),
    }
}

fn internal() -> Diagnostic {
    Diagnostic::error(Code::Internal, "a function of the program is missing")
}

fn polar(machine: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 1..=1, &["method", "degree", "variable"])?;
    let method = match word(args, "method")? {
        Some((name, span)) => name.parse::<Method>().map_err(|message| {
            Diagnostic::error(Code::Domain, message).at(span).hint("method=elementary is the usual one")
        })?,
        None => Method::Elementary,
    };
    let polars = polars(machine, &args.without(&["method"]))?;
    Ok(derive::polar_of_curve(&polars, method))
}

/// One polar form in one variable.
fn univariate(machine: &mut Machine, args: &Arguments) -> Result<(PolarForm<Fraction>, Symbol)> {
    let polars = polars(machine, args)?;
    match polars.as_slice() {
        [one] => match &one.kind {
            PolarKind::Univariate(form) => Ok((form.clone(), one.variables[0].clone())),
            _ => Err(wrong_kind("a polynomial in one variable", &Value::Polar(one.clone())).at(args.span(0))),
        },
        _ => Err(Diagnostic::error(Code::Type, "expected one polynomial, not a curve")
            .at(args.span(0))
            .hint("take one coordinate after the other")),
    }
}

fn sum(machine: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    combination(machine, args, form, Combination::Sum)
}

fn product(machine: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    combination(machine, args, form, Combination::Product)
}

fn compose(machine: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    combination(machine, args, form, Combination::Composition)
}

fn combination(machine: &mut Machine, args: &Arguments, form: &str, kind: Combination) -> Result<Derivation> {
    args.expect(form, 2..=2, &[])?;
    let name = match kind {
        Combination::Sum => "polar_sum",
        Combination::Product => "polar_product",
        Combination::Composition => "polar_compose",
    };
    let builtin = super::builtin(name).ok_or_else(internal)?;
    let Value::Polar(result) = builtin.run(machine, args.clone()).at(args.span(0))? else {
        return Err(internal());
    };
    let (f, _) = univariate(machine, &args.only(1))?;
    let (g, _) = univariate(machine, &args.after_first(&[]))?;
    Ok(derive::combination(kind, &f, &g, &result))
}

fn derivative(machine: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 1..=2, &["k"])?;
    let k = args.named_size("k", 1)?.unwrap_or(1);
    let (polar, variable) = univariate(machine, &args.only(1))?;
    Ok(derive::derivative(&polar, &variable, k))
}

fn elevate(machine: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 1..=2, &["k"])?;
    let k = args.named_size("k", 1)?.unwrap_or(1);
    if let Value::Geometry(geometry) = args.value(0)?
        && let Geometry::Bezier(curve, form) = &**geometry
    {
        return Ok(derive::elevation_of_curve(curve, *form, k));
    }
    let (polar, variable) = univariate(machine, &args.only(1))?;
    Ok(derive::elevation(&polar, &variable, k))
}

fn matrix(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 1..=1, &[])?;
    Ok(derive::power_matrix(args.size(0)?))
}

fn inverse_matrix(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 1..=1, &[])?;
    Ok(derive::bernstein_matrix(args.size(0)?))
}

fn casteljau(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 2..=usize::MAX, &[])?;
    let (curve, form) = args.bezier(0)?;
    let list = super::curves::repeated(args.scalars_from(1)?, curve.degree());
    derive::casteljau(&curve, form, &list).map_err(curve_error).at(args.span(1))
}

fn deboor(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 2..=usize::MAX, &["span"])?;
    let (s, form) = args.spline(0)?;
    let (scheme, list) = super::splines::de_boor(args, &s)?;
    // The scheme of another piece would not end in a point of the curve.
    if let [t, rest @ ..] = list.as_slice()
        && rest.iter().all(|u| u == t)
        && let Ok(own) = s.knots().span_of(t)
        && own != scheme.span
        && t != &s.knots().knots()[scheme.span + 1]
    {
        return Err(Diagnostic::error(
            Code::OutsideDomain,
            format!("the parameter lies on knot interval {own}"),
        )
        .at(args.span(1))
        .reason(format!("not on interval {}", scheme.span))
        .hint("leave out span=, or give as many arguments as the degree for a polar value"));
    }
    derive::de_boor(&s, form, &scheme, &list).map_err(curve_error).at(args.span(1))
}

fn insert(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 2..=2, &[])?;
    let (s, form) = args.spline(0)?;
    derive::insertion(&s, form, &args.scalar(1)?).map_err(spline_error).at(args.span(1))
}

fn join(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 2..=3, &["k"])?;
    let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
    let form = super::joins::polynomial_pair(args, left, right)?;
    let k = args.named_size("k", 2)?.unwrap_or(1);
    derive::joining(&f, &g, form, k).map_err(curve_error).at(args.span(1))
}

fn newton(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 2..=2, &[])?;
    let samples = Samples::read(args)?;
    let table = DividedDifferences::with_repeats(&samples.nodes, &samples.values);
    Ok(derive::newton(&table.map_err(Samples::failed(args))?, samples.form))
}

fn moments(_: &mut Machine, args: &Arguments, form: &str) -> Result<Derivation> {
    args.expect(form, 2..=2, &["ends", "slopes", "moments"])?;
    let samples = Samples::read(args)?;
    let ends = interpolation::ends(args, samples.form)?;
    let spline = CubicSpline::by_moments(&samples.nodes, &samples.values, ends);
    Ok(derive::moments(&spline.map_err(Samples::failed(args))?, samples.form))
}
