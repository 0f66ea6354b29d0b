//! Polar forms: making, elevating, combining, writing out.

use super::gives::Gives;
use super::notions::{chosen, words_of};
use crate::language::eval::Arguments;
use crate::language::ops::errors::{curve_error, division_by_zero, polar_error, wrong_kind};
use crate::language::ops::formula::Univariate;
use crate::language::ops::polar::point_argument;
use crate::language::ops::{formula, function};
use std::sync::Arc;

use super::parameter::{METHOD, Parameter, START, VARIABLE, many, named, optional, required};
use super::{Builtin, on_geometry, on_surface};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::Takes;
use crate::language::value::{Polar, PolarKind, Value};
use crate::math::blossom::{Method, PolarForm, TensorPolarForm, TotalDegreePolarForm};
use crate::math::curve::Interval;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Polar forms");

/// Also the derivations of polar forms begin with it.
pub(super) const POLAR: Builtin = Builtin {
    name: "polar",
    parameters: &[
        required("F", Takes::Polynomial, "the polynomial; a list of them for a curve"),
        optional("degree", Takes::Size, "the degree of F", "the number of arguments").shown("degree=n"),
        VARIABLE,
    ],
    common: &[METHOD],
    summary: "the polar form of a polynomial, of its own degree or a larger one",
    gives: Gives::Polar,
    example: "polar(t^2 + 2t, degree=3)",
    each: true,
    on_curve: on_geometry::POLAR,
    on_surface: on_surface::POLAR,
    call: |_, args| {
        names_a_polynomial(args)?;
        let given = args.univariate(0).map_err(|error| match error.code {
            Code::AmbiguousVariable => {
                error.hint("the forms of a surface are polar_tensor(F, u, v) and polar_total(F, [u, v])")
            }
            _ => error,
        })?;
        let own = given.coefficients.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
        let degree = args.optional_size(1)?.unwrap_or(own);
        let form = PolarForm::with_degree(given.coefficients, degree)
            .map_err(|error| polar_error(error).hint(format!("use degree={own} or more")))?;
        Ok(univariate(form, given.variable))
    },
    ..NEW
};

/// The method that was asked for.
pub(super) fn method(args: &Arguments) -> Result<Method> {
    match args.named("method") {
        Some((Value::Text(name), span)) => {
            name.parse().map_err(|message: String| Diagnostic::error(Code::Domain, message).at(span))
        }
        _ => Ok(Method::Elementary),
    }
}

/// Refuses polar(F) for an undefined F, which would be a polynomial in the variable F.
fn names_a_polynomial(args: &Arguments) -> Result<()> {
    let Some(symbol) = formula::symbol_of(args.value(0)?) else { return Ok(()) };
    if args.variable()?.is_some() || symbol.base() == "t" || formula::is_parameter(&symbol) {
        return Ok(());
    }
    Err(Diagnostic::error(Code::AmbiguousVariable, format!("'{symbol}' has no value here"))
        .at(args.span(0))
        .reason("a polynomial, a constant or the parameter?")
        .hint(format!("define it first: {symbol} := t^2"))
        .hint(format!("or name the parameter: polar({symbol}, variable=t)")))
}

/// The ways to combine forms, and whether they symmetrise. Both lead to the same form.
const COMBINATIONS: [(&str, bool); 2] = [("diagonal", false), ("symmetrize", true)];

const COMBINED: Parameter = named(
    "method=diagonal",
    Takes::Word(&words_of(&COMBINATIONS)),
    "diagonal",
    "from the polynomials, or from the polar forms with distinct arguments and their mean",
);

type Operation = fn(&PolarForm<Fraction>, &PolarForm<Fraction>) -> PolarForm<Fraction>;

/// The way that was asked for.
fn ways(args: &Arguments, diagonal: Operation, symmetrize: Operation) -> Result<Operation> {
    Ok(if chosen(args.named("method"), &COMBINATIONS)? { symmetrize } else { diagonal })
}

/// A formula, or a function of as many variables, in these.
fn formula_in(args: &Arguments, variables: &[Symbol]) -> Result<Fraction> {
    let function = match args.value(0)? {
        Value::Function(function) => function::formula_in(function, variables),
        _ => None,
    };
    function.map_or_else(|| args.scalar(0), Ok)
}

pub(super) const TABLE: &[Builtin] = &[
    POLAR,
    Builtin {
        name: "polar_tensor",
        parameters: &[
            required("F", Takes::Function, "the polynomial"),
            required("u", Takes::Variable, "the first variable"),
            required("v", Takes::Variable, "the second variable"),
            optional("m", Takes::Size, "the degree in u", "the number of arguments for u"),
            optional("n", Takes::Size, "the degree in v", "the number of arguments for v"),
        ],
        summary: "the tensor-product polar form of a polynomial of degrees m in u and n in v",
        gives: Gives::Polar,
        example: "polar_tensor(u v, u, v, 2, 2)",
        each: true,
        call: |_, args| {
            let (u, v) = (args.symbol(1)?, args.symbol(2)?);
            let formula = formula_in(args, &[u.clone(), v.clone()])?;
            let rows = formula::coefficients_in(&formula, &u).at(args.span(0))?;
            let mut grid = Vec::with_capacity(rows.len());
            for row in &rows {
                grid.push(formula::coefficients_in(row, &v).at(args.span(0))?);
            }
            let own = (rows.len() - 1, grid.iter().map(Vec::len).max().unwrap_or(1) - 1);
            let m = args.optional_size(3)?.unwrap_or(own.0);
            let n = args.optional_size(4)?.unwrap_or(own.1);
            for (polynomial, asked, i) in [(own.0, m, 3), (own.1, n, 4)] {
                if asked < polynomial {
                    let error = crate::math::blossom::PolarError::DegreeTooSmall { polynomial, asked };
                    return Err(polar_error(error).at(args.span(i)));
                }
            }
            crate::budget::charge_terms((m as u64 + 1).saturating_mul(n as u64 + 1));
            grid.resize(m + 1, Vec::new());
            grid.iter_mut().for_each(|row| row.resize(n + 1, Fraction::zero()));
            let form = TensorPolarForm::new(grid).map_err(polar_error)?;
            Ok(wrap(PolarKind::Tensor(form), vec![u, v]))
        },
        ..NEW
    },
    Builtin {
        name: "polar_total",
        parameters: &[
            required("F", Takes::Function, "the polynomial"),
            required("variables", Takes::Variables, "its variables").shown("[u, v]"),
            optional("degree", Takes::Size, "the degree of F", "the number of arguments").shown("degree=d"),
        ],
        summary: "the polar form of total degree d, whose arguments are points",
        gives: Gives::Polar,
        example: "polar_total(u v, [u, v], degree=2)",
        each: true,
        call: |_, args| {
            let variables = symbols(args, 1)?;
            let formula = formula_in(args, &variables)?;
            let terms = terms_in(&formula, &variables).at(args.span(0))?;
            let own = terms.iter().map(|(e, _)| e.iter().sum::<u32>()).max().unwrap_or(0) as usize;
            let degree = args.optional_size(2)?.unwrap_or(own);
            let form = TotalDegreePolarForm::new(variables.len(), degree, terms).map_err(polar_error)?;
            Ok(wrap(PolarKind::Total(form), variables))
        },
        ..NEW
    },
    Builtin {
        name: "diagonal",
        parameters: &[required("f", Takes::Polar, "the polar form; a list of them for a curve")],
        summary: "the polynomial F(t) = f(t, ..., t)",
        gives: Gives::Function,
        example: "diagonal(polar(t^2 + 1))",
        each: true,
        call: |_, args| {
            let f = args.polar(0)?;
            Ok(Value::Scalar(f.diagonal()))
        },
        ..NEW
    },
    Builtin {
        name: "partial",
        parameters: &[
            required("f", Takes::Polar, "the polar form; a list of them for a curve"),
            many(
                "u1, u2, ...",
                Takes::OneOf(&[Takes::Argument, Takes::Point]),
                0,
                "the arguments, vectors such as hat(1) too",
            ),
        ],
        summary: "puts in some arguments and leaves the others free",
        gives: Gives::Polar,
        example: "partial(polar(t^3), 0, hat(1))",
        each: true,
        call: |_, args| partial(args),
        ..NEW
    },
    Builtin {
        name: "elevate",
        parameters: &[
            required("f", Takes::Polar, "the polar form; a list of them for a curve"),
            optional("k", Takes::Size, "1", "how many arguments more"),
        ],
        summary: "the same polynomial with k more arguments (1 if not given)",
        gives: Gives::Polar,
        example: "elevate(polar(t^2), 1)",
        each: true,
        on_curve: on_geometry::ELEVATE,
        on_surface: on_surface::ELEVATE,
        call: |_, args| {
            let f = args.polar(0)?;
            let by = args.size(1)?;
            let kind = match &f.kind {
                PolarKind::Univariate(form) => PolarKind::Univariate(form.elevate(by)),
                PolarKind::Tensor(form) => PolarKind::Tensor(form.elevate(by, by).map_err(polar_error)?),
                PolarKind::Total(form) => PolarKind::Total(form.elevate(by)),
            };
            Ok(wrap(kind, f.variables.clone()))
        },
        ..NEW
    },
    Builtin {
        name: "reduce",
        parameters: &[
            required("f", Takes::Polar, "the polar form; a list of them for a curve"),
            optional("k", Takes::Size, "1", "how many arguments fewer"),
        ],
        summary: "the same polynomial with k fewer arguments, where that is exact",
        gives: Gives::Polar,
        example: "reduce(polar(t^2, degree=3), 1)",
        each: true,
        on_curve: on_geometry::REDUCE,
        on_surface: on_surface::REDUCE,
        call: |_, args| {
            let f = args.polar(0)?;
            let by = args.size(1)?;
            let kind = match &f.kind {
                PolarKind::Univariate(form) => form.reduce(by).map(PolarKind::Univariate),
                PolarKind::Tensor(form) => form.reduce(by, by).map(PolarKind::Tensor),
                PolarKind::Total(form) => form.reduce(by).map(PolarKind::Total),
            };
            Ok(wrap(kind.map_err(polar_error).at(args.span(0))?, f.variables.clone()))
        },
        ..NEW
    },
    Builtin {
        name: "bezier_points",
        parameters: &[
            required("f", Takes::Coordinates, "the polar form or polynomial; a list of them for a curve"),
            START,
            optional("b", Takes::Scalar, "1", "its end"),
            named("degree=n", Takes::Size, "that of f", "the degree, also a higher one"),
        ],
        summary: "the Bézier points f(a, ..., a, b, ..., b) over [a, b] (0 and 1 if not given)",
        gives: Gives::Points,
        example: "bezier_points(polar(t^2), 0, 1)",
        on_curve: on_geometry::BEZIER_POINTS,
        on_surface: on_surface::CONTROL_POINTS,
        call: |_, args| {
            let interval = ends(args)?;
            if let Value::List(coordinates) = args.value(0)? {
                let read = |item: &Value| univariate_form(&args.with_first(item.clone()), 0);
                let forms = coordinates.iter().map(|item| Ok(read(item)?.0));
                let forms = forms.collect::<Result<Vec<_>>>()?;
                // Points have all their coordinates at one degree.
                let own = forms.iter().map(PolarForm::degree).max().unwrap_or(0);
                let degree = degree_given(args, own)?;
                let points =
                    |form: &PolarForm<_>| form.elevate(degree - form.degree()).bezier_points(&interval);
                let columns: Vec<_> = forms.iter().map(points).collect();
                return Ok(Value::list(points_of(&columns)));
            }
            let (form, _) = univariate_form(args, 0)?;
            let degree = degree_given(args, form.degree())?;
            let form = form.elevate(degree - form.degree());
            Ok(Value::List(form.bezier_points(&interval).into_iter().map(Value::Scalar).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "from_bezier",
        parameters: &[
            required("points", Takes::Points, "the Bézier points").shown("[b_0, ..., b_n]"),
            START,
            optional("b", Takes::Scalar, "1", "its end"),
        ],
        summary: "the polar form with given Bézier points over [a, b] (0 and 1 if not given)",
        gives: Gives::Polar,
        example: "from_bezier([0, 0, 1])",
        call: |_, args| {
            let interval = ends(args)?;
            if let Some(columns) = coordinates_of(args.value(0)?) {
                let forms = columns.iter().map(|column| {
                    PolarForm::from_bezier_points_over(column, &interval)
                        .map(|form| univariate(form, Symbol::new("t")))
                        .map_err(polar_error)
                });
                return forms.collect::<Result<_>>().map(Value::List);
            }
            let points = args.scalars(0)?;
            let form = PolarForm::from_bezier_points_over(&points, &interval).map_err(polar_error)?;
            Ok(univariate(form, Symbol::new("t")))
        },
        ..NEW
    },
    Builtin {
        name: "polar_sum",
        parameters: &[
            required("F", Takes::Polynomial, "a polynomial or polar form"),
            required("G", Takes::Polynomial, "another one"),
        ],
        summary: "the polar form of F + G, of the larger degree",
        gives: Gives::Polar,
        example: "polar_sum(t^2 + 2t, t^3 + 1)",
        call: |_, args| combine(args, PolarForm::sum).map(polar_value),
        ..NEW
    },
    Builtin {
        name: "polar_product",
        parameters: &[
            required("F", Takes::Polynomial, "a polynomial or polar form"),
            required("G", Takes::Polynomial, "another one"),
        ],
        common: &[COMBINED],
        summary: "the polar form of F G: multiply with distinct arguments and symmetrise",
        gives: Gives::Polar,
        example: "polar_product(t^2 + 2t, t^3 + 1)",
        call: |_, args| {
            let operation = ways(args, PolarForm::product, PolarForm::product_by_symmetrizing)?;
            combine(args, operation).map(polar_value)
        },
        ..NEW
    },
    Builtin {
        name: "polar_compose",
        parameters: &[
            required("F", Takes::Polynomial, "the outer polynomial or polar form"),
            required("G", Takes::Polynomial, "the inner one"),
        ],
        common: &[COMBINED],
        summary: "the polar form of F(G(t))",
        gives: Gives::Polar,
        example: "polar_compose(t^2 + 2t, t^3 + 1)",
        call: |_, args| {
            let operation = ways(args, PolarForm::compose, PolarForm::compose_by_symmetrizing)?;
            combine(args, operation).map(polar_value)
        },
        ..NEW
    },
];

fn polar_value(polar: Polar) -> Value {
    Value::Polar(Arc::new(polar))
}

/// The form with some of its arguments put in.
fn partial(args: &Arguments) -> Result<Value> {
    let f = args.polar(0)?;
    match &f.kind {
        PolarKind::Univariate(form) => {
            let mut list = Vec::new();
            for i in 1..args.len() {
                list.push(match args.value(i)? {
                    Value::Scalar(u) => crate::math::blossom::Argument::Point(u.clone()),
                    Value::Vector(v) => crate::math::blossom::Argument::Vector(v.clone()),
                    other => {
                        return Err(wrong_kind("a number, symbol or vector argument", other).at(args.span(i)));
                    }
                });
            }
            let form = form.partial(&list).map_err(polar_error)?;
            Ok(univariate(form, f.variables[0].clone()))
        }
        PolarKind::Total(form) => {
            let mut list = Vec::new();
            for i in 1..args.len() {
                let value = args.value(i)?;
                list.push(
                    point_argument(value)
                        .ok_or_else(|| wrong_kind("a point such as (u1, v1)", value).at(args.span(i)))?,
                );
            }
            let form = form.partial(&list).map_err(polar_error)?;
            Ok(wrap(PolarKind::Total(form), f.variables.clone()))
        }
        PolarKind::Tensor(_) => Err(Diagnostic::error(
            Code::Unsupported,
            "partial values of tensor-product forms are not offered here",
        )
        .at(args.span(0))
        .hint("give all arguments: f(u1, u2; v1, v2)")),
    }
}

fn wrap(kind: PolarKind, variables: Vec<Symbol>) -> Value {
    polar_value(Polar { kind, variables })
}

/// The interval with its ends at the second and third place, 0 and 1 if not given.
fn ends(args: &Arguments) -> Result<Interval<Fraction>> {
    let a = args.optional_scalar(1)?.unwrap_or_else(Fraction::zero);
    let b = args.optional_scalar(2)?.unwrap_or_else(Fraction::one);
    let place = if args.given(1).is_some() { 1 } else { 2 };
    Interval::new(a, b).map_err(curve_error).at(args.span(place))
}

fn univariate(form: PolarForm<Fraction>, variable: Symbol) -> Value {
    let variable = unused(&form, variable);
    wrap(PolarKind::Univariate(form), vec![variable])
}

/// The variable, or another letter if a coefficient contains one of the arguments t1, t2, … that
/// would be named after it.
fn unused(form: &PolarForm<Fraction>, variable: Symbol) -> Symbol {
    let symbols: Vec<Symbol> = form.coefficients().iter().flat_map(Fraction::variables).collect();
    if symbols.is_empty() {
        return variable;
    }
    let taken = |letter: &Symbol| {
        (1..=form.degree()).any(|i| symbols.contains(&letter.numbered(i as i64)))
            || (*letter != variable && symbols.contains(letter))
    };
    let letters = ["u", "s", "x", "v", "w", "y", "z"].map(Symbol::new);
    std::iter::once(variable.clone()).chain(letters).find(|letter| !taken(letter)).unwrap_or(variable)
}

/// A polar form, or a polynomial standing for its polar form.
fn univariate_form(args: &Arguments, i: usize) -> Result<(PolarForm<Fraction>, Symbol)> {
    let Univariate { variable, coefficients } = args.univariate(i)?;
    Ok((PolarForm::new(coefficients), variable))
}

pub(super) fn combine(
    args: &Arguments,
    operation: impl Fn(&PolarForm<Fraction>, &PolarForm<Fraction>) -> PolarForm<Fraction>,
) -> Result<Polar> {
    let (f, variable) = univariate_form(args, 0)?;
    let (g, other) = univariate_form(args, 1)?;
    let formula = |i: usize| args.value(i).is_ok_and(|value| matches!(value, Value::Scalar(_)));
    if variable != other && f.degree() > 0 && g.degree() > 0 && formula(0) && formula(1) {
        return Err(Diagnostic::error(
            Code::AmbiguousVariable,
            format!("one polynomial is in {variable}, the other in {other}"),
        )
        .at(args.span(1))
        .hint("write both in the same variable"));
    }
    let form = operation(&f, &g);
    let variable = unused(&form, variable);
    Ok(Polar { kind: PolarKind::Univariate(form), variables: vec![variable] })
}

/// Points with coordinates, as one list for each coordinate; `None` if the value is not a list of
/// points of one dimension.
fn coordinates_of(value: &Value) -> Option<Vec<Vec<Fraction>>> {
    let Value::List(points) = value else { return None };
    let mut columns: Vec<Vec<Fraction>> = Vec::new();
    for point in points {
        let Value::List(coordinates) = point else { return None };
        if columns.is_empty() {
            columns.resize(coordinates.len(), Vec::new());
        }
        if columns.len() != coordinates.len() {
            return None;
        }
        for (column, x) in columns.iter_mut().zip(coordinates) {
            column.push(x.as_scalar()?.clone());
        }
    }
    (!columns.is_empty()).then_some(columns)
}

/// The points whose coordinates stand in the given lists.
fn points_of(columns: &[Vec<Fraction>]) -> Vec<Value> {
    let count = columns.first().map_or(0, Vec::len);
    let point = |i: usize| columns.iter().map(|column| Value::Scalar(column[i].clone())).collect();
    (0..count).map(|i| Value::point(point(i))).collect()
}

pub(super) fn symbols(args: &Arguments, i: usize) -> Result<Vec<Symbol>> {
    let value = args.value(i)?;
    let list = match value {
        Value::List(items) => items.iter().map(formula::symbol_of).collect::<Option<Vec<Symbol>>>(),
        _ => None,
    };
    let list =
        list.ok_or_else(|| wrong_kind("a list of variables such as [u, v]", value).at(args.span(i)))?;
    match list.iter().enumerate().find(|(k, symbol)| list[..*k].contains(symbol)) {
        Some((_, symbol)) => {
            Err(Diagnostic::error(Code::Coincident, format!("{symbol} is listed twice")).at(args.span(i)))
        }
        None => Ok(list),
    }
}

/// The terms of a formula that is a polynomial in the given variables.
fn terms_in(formula: &Fraction, variables: &[Symbol]) -> Result<Vec<(Vec<u32>, Fraction)>> {
    if formula.denominator().variables().iter().any(|symbol| variables.contains(symbol)) {
        return Err(Diagnostic::error(Code::NotPolynomial, "a variable stands in the denominator")
            .hint("only polynomials have a polar form"));
    }
    let inverse = Fraction::from(formula.denominator().clone()).inverse().ok_or_else(division_by_zero)?;
    Ok(formula
        .numerator()
        .terms(MonomialOrder::Lex)
        .into_iter()
        .map(|(powers, c)| {
            let exponent = |s: &Symbol| powers.iter().find(|(p, _)| p == s).map_or(0, |(_, e)| *e);
            let exponents = variables.iter().map(exponent).collect();
            let others = powers.iter().filter(|(s, _)| !variables.contains(s)).cloned().collect();
            (exponents, Fraction::from(MultiPoly::from_terms([(others, c)])).times(&inverse))
        })
        .collect())
}

/// The degree that is given, or the own one; it cannot be lower.
fn degree_given(args: &Arguments, own: usize) -> Result<usize> {
    let Some(degree) = args.named_size("degree")? else { return Ok(own) };
    match degree < own {
        true => Err(Diagnostic::error(Code::Domain, format!("the degree is {own}, more than {degree}"))
            .at(args.named("degree").map_or(args.span(0), |(_, span)| span))
            .hint(format!("degree={own} or more"))),
        false => Ok(degree),
    }
}
