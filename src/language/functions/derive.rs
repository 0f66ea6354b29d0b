//! Derivations in the language.

use super::gives::Gives;
use crate::language::eval::{Arguments, Machine};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use std::sync::Arc;

use super::Builtin;
use super::blends::{BOUNDARY, coons};
use super::differential::{self, derivatives, still};
use super::interpolation::{self, ENDS, MOMENTS, ONE_END, SLOPES, Samples};
use super::parameter::{
    CURVE, DEGREE, FIRST_CURVE, LINE, METHOD, NODES, Parameter, SECOND_CURVE, SPAN, SPLINE, VALUES, VARIABLE,
    many, named, optional, required,
};
use super::polar::{POLAR, combine, method};
use super::rational::homogeneous_coordinates;
use super::rational_blossoms::{MULTIRATIONAL, function, multirational_error};
use super::told::{LANG, told};
use crate::language::derive::{self, Combination};
use crate::language::diagnostic::{At, Code, Diagnostic, nearest};
use crate::language::ops::formula::{coefficients_in, variable_of};
use crate::language::ops::takes::Takes;
use crate::language::value::{Derivation, Geometry, Polar, PolarKind, Value};
use crate::math::blossom::PolarForm;
use crate::math::interpolate::{CubicSpline, DividedDifferences};
use crate::math::interval::Interval;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Poly, Symbol};
use crate::math::ring::Ring;

type Result<T> = std::result::Result<T, Diagnostic>;

const ABOUT: Builtin = Builtin { gives: Gives::Derivation, ..Builtin::about("Derivations") };

const WITH_NUMBERS: Parameter =
    required("F", Takes::Polynomial, "the polynomial, with numbers as coefficients");

pub(super) const TABLE: &[Builtin] = &[Builtin {
    name: "derive",
    parameters: &[
        required("what", Takes::Any, "the name of the derivation"),
        many("...", Takes::Any, 0, "what it is about"),
        LANG,
    ],
    summary: "how something is found, line by line with reasons; docs/derivations.md lists what",
    example: "derive(product, t^2 + 2t, t + 1)",
    subjects: SUBJECTS,
    call: |_, args| Err(no_subject(args)),
    ..ABOUT
}];

const NEW: Builtin = Builtin { subject_of: Some("derive"), common: &[LANG], ..ABOUT };

/// A polynomial, or the coordinates of a curve.
const CURVE_OR_POLYNOMIAL: Parameter =
    required("F", Takes::OneOf(&[Takes::Polynomial, Takes::Curve]), "the polynomial or Bézier curve");

const POLYNOMIALS: Parameter =
    required("F", Takes::OneOf(&[Takes::Coordinates, Takes::Geometry]), "the polynomial; a list for a curve");

const POLYNOMIAL: Parameter = required("F", Takes::Polynomial, "a polynomial or polar form");

const OTHER: Parameter = required("G", Takes::Polynomial, "another one");

const ARGUMENTS: Parameter =
    many("u_1, ..., u_n", Takes::Scalar, 1, "one parameter, or as many as the degree");

/// What can be derived.
const SUBJECTS: &[Builtin] = &[
    Builtin {
        name: "polar",
        parameters: &[
            POLYNOMIALS,
            METHOD,
            named("degree=n", Takes::Size, "the degree of F", "the number of arguments"),
            VARIABLE,
        ],
        summary: "the polar form of a polynomial",
        example: "derive(polar, t^2 + 2t, method=taylor)",
        call: |machine, args| told(args, polar(machine, args)?),
        ..NEW
    },
    Builtin {
        name: "sum",
        parameters: &[POLYNOMIAL, OTHER],
        summary: "the polar form of F + G",
        example: "derive(sum, t^2 + 2t, t + 1)",
        call: |machine, args| told(args, combination(machine, args, Combination::Sum)?),
        ..NEW
    },
    Builtin {
        name: "product",
        parameters: &[POLYNOMIAL, OTHER],
        summary: "the polar form of F G",
        example: "derive(product, t^2 + 2t, t + 1)",
        call: |machine, args| told(args, combination(machine, args, Combination::Product)?),
        ..NEW
    },
    Builtin {
        name: "compose",
        parameters: &[POLYNOMIAL, OTHER],
        summary: "the polar form of F(G(t))",
        example: "derive(compose, t^2 + 2t, t + 1)",
        call: |machine, args| told(args, combination(machine, args, Combination::Composition)?),
        ..NEW
    },
    Builtin {
        name: "derivative",
        parameters: &[CURVE_OR_POLYNOMIAL, optional("k", Takes::Size, "1", "how often")],
        summary: "the k-th derivative by vector arguments",
        example: "derive(derivative, t^3, 1)",
        call: |machine, args| {
            let (polar, variable) = univariate(machine, &args.only(1))?;
            told(args, derive::derivative(&polar, &variable, args.size(1)?))
        },
        ..NEW
    },
    Builtin {
        name: "elevate",
        parameters: &[
            required(
                "F",
                Takes::OneOf(&[Takes::Polynomial, Takes::Curve]),
                "a polynomial, polar form or Bézier curve",
            ),
            optional("k", Takes::Size, "1", "by how many degrees"),
        ],
        summary: "the same polynomial with k more arguments, or a curve with more points",
        example: "derive(elevate, t^2, 1)",
        call: |machine, args| told(args, elevate(machine, args)?),
        ..NEW
    },
    Builtin {
        name: "matrix",
        parameters: &[DEGREE],
        summary: "A_n, from Bézier points to power coefficients",
        example: "derive(matrix, 2)",
        call: |_, args| told(args, derive::power_matrix(args.size(0)?)),
        ..NEW
    },
    Builtin {
        name: "inverse_matrix",
        parameters: &[DEGREE],
        summary: "its inverse",
        example: "derive(inverse_matrix, 2)",
        call: |_, args| told(args, derive::bernstein_matrix(args.size(0)?)),
        ..NEW
    },
    Builtin {
        name: "casteljau",
        parameters: &[CURVE, ARGUMENTS],
        summary: "a value by de Casteljau's scheme",
        example: "derive(casteljau, bezier([0, 1, 4]), 1/2)",
        call: |_, args| told(args, casteljau(args)?),
        ..NEW
    },
    Builtin {
        name: "deboor",
        parameters: &[SPLINE, ARGUMENTS, SPAN],
        summary: "a value by de Boor's scheme",
        example: "derive(deboor, bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 1/2)",
        call: |_, args| told(args, deboor(args)?),
        ..NEW
    },
    Builtin {
        name: "insert",
        parameters: &[SPLINE, required("t", Takes::Scalar, "the new knot")],
        summary: "the control points after a knot is inserted",
        example: "derive(insert, bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 1/2)",
        call: |_, args| told(args, insert(args)?),
        ..NEW
    },
    Builtin {
        name: "join",
        parameters: &[FIRST_CURVE, SECOND_CURVE, optional("k", Takes::Size, "1", "the order")],
        summary: "the conditions for two curves to meet C^k",
        example: "derive(join, bezier([b_0, b_1, b_2]), bezier([c_0, c_1, c_2], 1, 2), 1)",
        call: |_, args| told(args, join(args)?),
        ..NEW
    },
    Builtin {
        name: "newton",
        parameters: &[NODES, VALUES],
        summary: "the divided differences and Newton's form",
        example: "derive(newton, [0, 1, 3], [1, 3, 2])",
        call: |_, args| told(args, newton(args)?),
        ..NEW
    },
    Builtin {
        name: "roots",
        parameters: &[
            WITH_NUMBERS,
            optional("a", Takes::Number, "below all roots", "the lower end"),
            optional("b", Takes::Number, "above all roots", "the upper end"),
            VARIABLE,
        ],
        summary: "the real roots in [a, b], by Bernstein coefficients over intervals that are halved",
        example: "derive(roots, t^2 - 2, 0, 2)",
        call: |_, args| told(args, real_roots(args)?),
        ..NEW
    },
    Builtin {
        name: "clipping",
        parameters: &[
            WITH_NUMBERS,
            optional("a", Takes::Number, "below all roots", "the lower end"),
            optional("b", Takes::Number, "above all roots", "the upper end"),
            named("width=1/1000", Takes::Number, "1/1000", "how long the interval around a root may be"),
            VARIABLE,
        ],
        summary: "the real roots in [a, b], by Bezier clipping",
        example: "derive(clipping, t^2 - 2, 0, 2, width=1/10)",
        call: |_, args| told(args, clipped(args)?),
        ..NEW
    },
    Builtin {
        name: "sturm",
        parameters: &[
            WITH_NUMBERS,
            optional("a", Takes::Number, "below all roots", "the lower end, not counted"),
            optional("b", Takes::Number, "above all roots", "the upper end, counted"),
            VARIABLE,
        ],
        summary: "the number of real roots in (a, b] by the signs of Sturm's chain",
        example: "derive(sturm, t^3 - 3t + 1, 0, 2)",
        call: |_, args| {
            let (f, variable, interval) = with_interval(args)?;
            told(args, derive::sturm(&f, &variable, &interval))
        },
        ..NEW
    },
    Builtin {
        name: "resultant",
        parameters: &[
            required("F", Takes::Scalar, "a polynomial"),
            required("G", Takes::Scalar, "another one"),
            optional("variable", Takes::Variable, "the only variable, or t", "the variable").shown("t"),
        ],
        summary: "the resultant as Sylvester's determinant",
        example: "derive(resultant, x - t^2, y - t^3, t)",
        call: |_, args| told(args, resultant(args)?),
        ..NEW
    },
    Builtin {
        name: "geometric_continuity",
        parameters: &[FIRST_CURVE, SECOND_CURVE, optional("k", Takes::Size, "2", "the order")],
        summary: "how two curves meet G^k, by the chain rule",
        example: "derive(geometric_continuity, bezier([[0, 0], [1, 0], [2, 1]]), bezier([[2, 1], [4, 3], [5, 5]]), 2)",
        call: |_, args| told(args, geometric_continuity(args)?),
        ..NEW
    },
    Builtin {
        name: "hull",
        parameters: &[CURVE, required("t", Takes::Number, "a parameter in the interval of the curve")],
        summary: "why a point of a curve lies in the convex hull of the control points",
        example: "derive(hull, bezier([[0, 0], [1, 2], [2, 0]]), 1/3)",
        call: |_, args| told(args, hull(args)?),
        ..NEW
    },
    Builtin {
        name: "curvature",
        parameters: &[LINE, required("t", Takes::Scalar, "the parameter")],
        summary: "the curvature by the first two derivatives",
        example: "derive(curvature, [t, t^2], 1)",
        call: |_, args| told(args, curvature(args)?),
        ..NEW
    },
    Builtin {
        name: "connection_matrix",
        parameters: &[required("k", Takes::Size, "the order")],
        summary: "the beta-matrix of G^k, by the chain rule",
        example: "derive(connection_matrix, 2)",
        call: |_, args| {
            let k = args.size(0)?;
            crate::budget::charge_terms((k as u64).saturating_pow(3));
            told(args, derive::connection_matrix(k))
        },
        ..NEW
    },
    Builtin {
        name: "implicit",
        parameters: &[required(
            "curve",
            Takes::OneOf(&[Takes::Curve, Takes::Coordinates]),
            "a Bézier curve of the plane, or its coordinates as formulas",
        )
        .shown("c")],
        summary: "the equation of a plane curve as a determinant",
        example: "derive(implicit, [t^2, t^3])",
        call: |_, args| told(args, implicit(args)?),
        ..NEW
    },
    Builtin {
        name: "coons",
        parameters: BOUNDARY,
        summary: "Coons' surface of four curves as a Boolean sum",
        example: "derive(coons, bezier([0, 1]), bezier([1, 3]), bezier([0, 1, 1]), bezier([1, 3]))",
        call: |_, args| told(args, boolean_sum(args)?),
        ..NEW
    },
    Builtin {
        name: "multirational",
        parameters: MULTIRATIONAL,
        summary: "a multirational blossom by coefficients or divided differences",
        example: "derive(multirational, 1/t, [u], [v, w])",
        call: |_, args| {
            let (f, t) = function(args, 0)?;
            let steps = derive::multirational_steps(&f, &t, &args.scalars(1)?, &args.scalars(2)?);
            told(args, steps.map_err(|error| multirational_error(args, error))?)
        },
        ..NEW
    },
    Builtin {
        name: "moments",
        parameters: &[NODES, VALUES, ENDS, SLOPES, MOMENTS],
        common: &ONE_END,
        summary: "the moments of a cubic spline by its system of equations",
        example: "derive(moments, [0, 1, 2], [0, 1, 0])",
        call: |_, args| told(args, moments(args)?),
        ..NEW
    },
];

/// Coons' surface; u and v are its parameters.
fn boolean_sum(args: &Arguments) -> Result<Derivation> {
    let ([in_u, in_v], surface, form) = coons(args)?;
    let reserved = ["u", "v"].map(Symbol::new);
    let symbols = |x: &Fraction| x.variables().iter().any(|s| reserved.contains(s));
    for (i, curve) in in_u.iter().chain(&in_v).enumerate() {
        let (a, b) = curve.interval().ends();
        if symbols(a) || symbols(b) || curve.points().iter().any(|p| p.iter().any(symbols)) {
            let error = Diagnostic::error(Code::Domain, "u and v are the parameters of the surface");
            return Err(error.at(args.span(i)).hint("choose other letters for the points"));
        }
    }
    Ok(derive::coons(&in_u, &in_v, &surface, form))
}

/// The equation of a plane curve.
fn implicit(args: &Arguments) -> Result<Derivation> {
    let (coordinates, _) = homogeneous_coordinates(args, 0)?;
    let coordinates: [Vec<Fraction>; 3] = coordinates.try_into().map_err(|list: Vec<_>| {
        let message = format!("a curve of the plane is needed, this one has {} coordinates", list.len() - 1);
        Diagnostic::error(Code::Shape, message).at(args.span(0)).hint("such as derive(implicit, [t^2, t^3])")
    })?;
    let reserved = ["t", "x", "y"].map(Symbol::new);
    if coordinates.iter().flatten().any(|c| c.variables().iter().any(|s| reserved.contains(s))) {
        let error = Diagnostic::error(Code::Domain, "t is the parameter, x and y are the coordinates");
        return Err(error.at(args.span(0)).hint("choose other letters for the control points"));
    }
    derive::implicit(&coordinates).ok_or_else(|| {
        let error = Diagnostic::error(Code::Degenerate, "the curve is a single point").at(args.span(0));
        error.hint("a point has no single equation; give a curve")
    })
}

/// Two polynomials that are not 0.
fn resultant(args: &Arguments) -> Result<Derivation> {
    let (f, g) = (args.scalar(0)?, args.scalar(1)?);
    let t = variable_of(&f.plus(&g), args.optional_symbol(2)?).at(args.span(0))?;
    let polynomial = |i: usize, f: &Fraction| {
        coefficients_in(f, &t).at(args.span(i))?;
        match f.as_polynomial() {
            Some(p) if !num_traits::Zero::is_zero(p) => Ok(p.clone()),
            _ => Err(Diagnostic::error(
                Code::Domain,
                "a polynomial that is not 0 is needed, without denominators",
            )
            .at(args.span(i))
            .hint("multiply by the denominator first")),
        }
    };
    let (p, q) = (polynomial(0, &f)?, polynomial(1, &g)?);
    derive::resultant(&p, &q, &t).ok_or_else(|| {
        let error = Diagnostic::error(Code::Domain, "the resultant of 0 is 0").at(args.span(0));
        error.hint("give two polynomials that are not 0")
    })
}

/// Two polynomial curves with numbers.
fn geometric_continuity(args: &Arguments) -> Result<Derivation> {
    let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
    let form = super::joins::polynomial_pair(args, left, right)?;
    let k = args.size(2)?;
    crate::budget::charge_terms((k as u64).saturating_pow(3));
    let numbers = |i: usize, curve| {
        super::geometric::numeric(curve).ok_or_else(|| {
            Diagnostic::error(Code::Type, "numbers are needed as control points")
                .at(args.span(i))
                .hint("geometric_continuity(c, d, k) has the conditions for symbols")
        })
    };
    let (p, q) = (numbers(0, &f)?, numbers(1, &g)?);
    derive::geometric_steps((&f, &g), (&p, &q), form, k).map_err(curve_error).at(args.span(1))
}

/// A point within the interval of a polynomial curve.
fn hull(args: &Arguments) -> Result<Derivation> {
    let (curve, form) = args.bezier(0)?;
    let t = args.scalar(1)?;
    if form.rational {
        let error = Diagnostic::error(Code::NotPolynomial, "this curve is rational").at(args.span(0));
        return Err(
            error.hint("with positive weights it has the hull property, too: casteljau(c, t) shows means")
        );
    }
    if curve.contains(&t) == Some(false) {
        let (a, b) = curve.interval().ends();
        let error =
            Diagnostic::error(Code::OutsideDomain, format!("the interval of the curve is [{a}, {b}]"));
        return Err(error.at(args.span(1)).hint("outside of it weights are negative"));
    }
    Ok(derive::hull(&curve, form, &t))
}

/// The curvature at a parameter, with its value where that is known.
fn curvature(args: &Arguments) -> Result<Derivation> {
    let (list, _) = derivatives(args, 2)?;
    let value = differential::curvature(args).ok();
    derive::curvature(&args.scalar(1)?, [&list[1], &list[2]], value.as_ref())
        .map_err(|error| still(error, args))
}

/// The error for a word that names no derivation.
fn no_subject(args: &Arguments) -> Diagnostic {
    let names = || SUBJECTS.iter().map(|subject| subject.name);
    let known = || format!("what can be derived: {}", names().collect::<Vec<_>>().join(", "));
    match args.value(0) {
        Ok(Value::Text(what)) => {
            let error = Diagnostic::error(Code::UnknownFunction, format!("there is no derivation '{what}'"));
            let best = nearest(what, names());
            error.at(args.span(0)).hint(best.map_or_else(known, |best| format!("did you mean '{best}'?")))
        }
        Ok(other) => wrong_kind("the name of a derivation", other).at(args.span(0)).hint(known()),
        Err(error) => error.hint(known()),
    }
}

/// The polar forms of a polynomial or of the coordinates of a curve.
fn polars(machine: &mut Machine, args: &Arguments) -> Result<Vec<Arc<Polar>>> {
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
    if let Some(polars) = made.filter(|polars| !polars.is_empty() && args.named("degree").is_none()) {
        return Ok(polars);
    }
    match POLAR.run(machine, args.clone()).at(args.span(0))? {
        Value::List(items) => items.into_iter().map(one).collect(),
        value => one(value).map(|polar| vec![polar]),
    }
}

fn polar(machine: &mut Machine, args: &Arguments) -> Result<Derivation> {
    let method = method(args)?;
    let polars = polars(machine, &args.without(&["method", "lang"]))?;
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

fn combination(machine: &mut Machine, args: &Arguments, kind: Combination) -> Result<Derivation> {
    let result = combine(
        args,
        match kind {
            Combination::Sum => PolarForm::sum,
            Combination::Product => PolarForm::product,
            Combination::Composition => PolarForm::compose,
        },
    )
    .at(args.span(0))?;
    let (f, _) = univariate(machine, &args.only(1))?;
    let (g, _) = univariate(machine, &args.after_first().only(1))?;
    Ok(derive::combination(kind, &f, &g, &result))
}

fn elevate(machine: &mut Machine, args: &Arguments) -> Result<Derivation> {
    let k = args.size(1)?;
    if let Value::Geometry(geometry) = args.value(0)?
        && let Geometry::Bezier(curve, form) = &**geometry
    {
        return Ok(derive::elevation_of_curve(curve, *form, k));
    }
    let (polar, variable) = univariate(machine, &args.only(1))?;
    Ok(derive::elevation(&polar, &variable, k))
}

fn casteljau(args: &Arguments) -> Result<Derivation> {
    let (curve, form) = args.bezier(0)?;
    let list = super::curves::repeated(args.scalars_from(1)?, curve.degree());
    derive::casteljau(&curve, form, &list).map_err(curve_error).at(args.span(1))
}

fn deboor(args: &Arguments) -> Result<Derivation> {
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

fn insert(args: &Arguments) -> Result<Derivation> {
    let (s, form) = args.spline(0)?;
    derive::insertion(&s, form, &args.scalar(1)?).map_err(spline_error).at(args.span(1))
}

fn join(args: &Arguments) -> Result<Derivation> {
    let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
    let form = super::joins::polynomial_pair(args, left, right)?;
    let k = args.size(2)?;
    derive::joining(&f, &g, form, k).map_err(curve_error).at(args.span(1))
}

fn newton(args: &Arguments) -> Result<Derivation> {
    let samples = Samples::read(args)?;
    let table = DividedDifferences::with_repeats(&samples.nodes, &samples.values);
    Ok(derive::newton(&table.map_err(Samples::failed(args))?, samples.form))
}

/// A polynomial that is not constant, and the interval in which its roots are looked for.
fn with_interval(args: &Arguments) -> Result<(Poly, Symbol, Interval<Rational>)> {
    let (polynomial, variable) = super::roots::numeric(args, 0)?;
    if polynomial.degree().is_none_or(|n| n == 0) {
        return Err(Diagnostic::error(Code::Domain, "a constant has no roots to be found")
            .at(args.span(0))
            .hint("give a polynomial of degree 1 or more: derive(roots, t^2 - 2)"));
    }
    let interval = searched(args, &polynomial)?;
    Ok((polynomial, variable, interval))
}

fn real_roots(args: &Arguments) -> Result<Derivation> {
    let (polynomial, variable, interval) = with_interval(args)?;
    Ok(derive::roots(&polynomial, &variable, &interval))
}

/// The interval in which roots are looked for.
fn searched(args: &Arguments, polynomial: &Poly) -> Result<Interval<Rational>> {
    let (a, b) = super::roots::interval(args, 1)?;
    let bound = polynomial.root_bound();
    let (a, b) = (a.unwrap_or_else(|| -&bound), b.unwrap_or(bound));
    let ordered = if a < b { Interval::new(a.clone(), b.clone()).ok() } else { None };
    ordered.ok_or_else(|| {
        Diagnostic::error(Code::Domain, format!("there is nothing between {a} and {b}"))
            .at(args.span(1))
            .hint("give two ends, the lower one first")
    })
}

fn clipped(args: &Arguments) -> Result<Derivation> {
    let (polynomial, variable, interval) = with_interval(args)?;
    let width = super::roots::width(args)?.unwrap_or_else(|| crate::math::number::rational(1, 1000));
    Ok(derive::clipping(&polynomial, &variable, &interval, &width))
}

fn moments(args: &Arguments) -> Result<Derivation> {
    let samples = Samples::read(args)?;
    let ends = interpolation::ends(args, samples.form)?;
    let spline = CubicSpline::by_moments(&samples.nodes, &samples.values, ends);
    Ok(derive::moments(&spline.map_err(Samples::failed(args))?, samples.form))
}
