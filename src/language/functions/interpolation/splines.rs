//! Interpolating cubic splines and their systems of equations.

use crate::language::eval::Arguments;
use crate::language::functions::gives::Gives;
use crate::language::functions::notions::{chosen, words_of};
use std::sync::Arc;

use super::NEW;
use super::data::{Datum, Result, Samples, datum, indexed, pair, word};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::functions::Builtin;
use crate::language::functions::parameter::{
    CURVE, NODES, Parameter, RESULT_VARIABLE, VALUES, named, optional,
};
use crate::language::functions::record::Variant;
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, PiecewiseFunction, Table, Value};
use crate::math::interpolate::{CubicSpline, End, Ends, Unknowns};
use crate::math::poly::Fraction;

pub(crate) const ENDS: Parameter = optional(
    "ends",
    Takes::Word(&["natural", "clamped", "periodic", "not_a_knot"]),
    "natural, or clamped with slopes",
    "what holds at the ends",
)
.shown("ends=natural");

pub(crate) const SLOPES: Parameter =
    named("slopes=[a, b]", Takes::Points, "none", "the slopes of clamped ends");

pub(crate) const MOMENTS: Parameter =
    named("moments=[a, b]", Takes::Points, "none", "the second derivatives at the ends");

/// What holds at one end only, whatever holds at the other.
pub(crate) const ONE_END: [Parameter; 4] = [
    named("first_slope=a", Takes::Point, "what ends says", "the slope at the first node"),
    named("last_slope=b", Takes::Point, "what ends says", "the slope at the last node"),
    named("first_moment=a", Takes::Point, "what ends says", "the second derivative at the first node"),
    named("last_moment=b", Takes::Point, "what ends says", "the second derivative at the last node"),
];

const UNKNOWNS: [(&str, Unknowns); 2] = [("moments", Unknowns::Moments), ("slopes", Unknowns::Slopes)];

const METHOD: Parameter = named(
    "method=moments",
    Takes::Word(&words_of(&UNKNOWNS)),
    "moments",
    "the unknowns of the system that is solved",
);

pub(crate) const TABLE: &[Builtin] = &[
    Builtin {
        name: "cubic_spline",
        parameters: &[NODES, VALUES, ENDS, SLOPES, MOMENTS, METHOD, RESULT_VARIABLE],
        common: &ONE_END,
        summary: "the cubic spline; ends are natural, clamped (with slopes), periodic or not_a_knot",
        gives: Gives::Piecewise,
        example: "cubic_spline([0, 1, 2], [0, 1, 0])",
        call: |_, args| {
            let given = Given::read(args)?;
            let variable = given.samples.variable(args)?;
            let spline = given.spline(args)?;
            let piecewise =
                |function| Value::Piecewise(Arc::new(PiecewiseFunction::new(function, variable.clone())));
            let mut list: Vec<Value> = spline.to_piecewise().into_iter().map(piecewise).collect();
            Ok(if given.samples.form.scalar { list.swap_remove(0) } else { Value::point(list) })
        },
        ..NEW
    },
    Builtin {
        name: "spline_system",
        parameters: &[NODES, VALUES, ENDS, SLOPES, MOMENTS, METHOD],
        common: &ONE_END,
        summary: "the tridiagonal system of a cubic spline for its moments M_i or slopes m_i, solved",
        gives: Gives::Table,
        example: "spline_system([0, 1, 3, 4], [0, 1, -1, 2])",
        call: |_, args| {
            let given = Given::read(args)?;
            Ok(Value::Table(Arc::new(system(&given.spline(args)?, given.samples.form))))
        },
        ..NEW
    },
    Builtin {
        name: "spline_moments",
        parameters: &[NODES, VALUES, ENDS, SLOPES, MOMENTS, METHOD],
        common: &ONE_END,
        summary: "the second derivatives M_0, ..., M_n of a cubic spline at its nodes",
        gives: Gives::Points,
        example: "spline_moments([0, 1, 2], [0, 1, 0])",
        call: |_, args| {
            let given = Given::read(args)?;
            Ok(given.list(given.spline(args)?.moments()))
        },
        ..NEW
    },
    Builtin {
        name: "spline_slopes",
        parameters: &[NODES, VALUES, ENDS, SLOPES, MOMENTS, METHOD],
        common: &ONE_END,
        summary: "the first derivatives m_0, ..., m_n of a cubic spline at its nodes",
        gives: Gives::Points,
        example: "spline_slopes([0, 1, 2], [0, 1, 0])",
        call: |_, args| {
            let given = Given::read(args)?;
            Ok(given.list(given.spline(args)?.slopes()))
        },
        ..NEW
    },
    Builtin {
        name: "bending_energy",
        parameters: &[NODES, VALUES, ENDS, SLOPES, MOMENTS],
        common: &ONE_END,
        on_curve: Variant::new(&[CURVE], Gives::Scalar, super::energy::bending),
        summary: "the integral of |S''|^2, which no interpolant makes smaller than the natural spline",
        gives: Gives::Scalar,
        example: "bending_energy([0, 1, 2], [0, 1, 0])",
        call: |_, args| Ok(Value::Scalar(Given::read(args)?.spline(args)?.bending_energy())),
        ..NEW
    },
];

/// What a spline is asked for with.
struct Given {
    samples: Samples,
    ends: Ends<Datum>,
    unknowns: Unknowns,
}

impl Given {
    fn read(args: &Arguments) -> Result<Self> {
        let samples = Samples::read(args)?;
        let unknowns =
            args.named("method").map_or(Ok(Unknowns::Moments), |given| chosen(Some(given), &UNKNOWNS))?;
        let ends = ends(args, samples.form)?;
        Ok(Given { samples, ends, unknowns })
    }

    fn spline(&self, args: &Arguments) -> Result<CubicSpline<Fraction, Datum>> {
        let solve = match self.unknowns {
            Unknowns::Moments => CubicSpline::by_moments,
            Unknowns::Slopes => CubicSpline::by_slopes,
        };
        solve(&self.samples.nodes, &self.samples.values, self.ends.clone()).map_err(Samples::failed(args))
    }

    fn list(&self, data: &[Datum]) -> Value {
        Value::List(data.iter().map(|datum| self.samples.form.plain(datum.clone())).collect())
    }
}

/// The ends by their word, or by the slopes or moments that are given, each end for itself if something is said of it.
pub(crate) fn ends(args: &Arguments, form: Form) -> Result<Ends<Datum>> {
    let mut ends = both_ends(args, form)?;
    for (at_last, name, slope) in [
        (false, "first_slope", true),
        (true, "last_slope", true),
        (false, "first_moment", false),
        (true, "last_moment", false),
    ] {
        let Some((value, span)) = args.named(name) else { continue };
        let datum = datum(value, form, span)?;
        let Ends::Each { first, last } = &mut ends else {
            let error = Diagnostic::error(Code::Arity, "periodic ends take no slope or moment of their own");
            return Err(error.at(span).hint("leave out ends=periodic"));
        };
        let end = if slope { End::Slope(datum) } else { End::SecondDerivative(datum) };
        let place = if at_last { last } else { first };
        if matches!(place, End::Slope(_) | End::SecondDerivative(_)) {
            let error = Diagnostic::error(Code::Arity, "two things are said of one end").at(span);
            return Err(error.hint("give a slope or a second derivative for each end"));
        }
        *place = end;
    }
    Ok(ends)
}

/// The ends by their word, or by the slopes or moments that are given.
fn both_ends(args: &Arguments, form: Form) -> Result<Ends<Datum>> {
    let slopes = args.named("slopes");
    let moments = args.named("moments");
    let unwanted = |what: &str, span: Span, hint: &str| {
        Err(Diagnostic::error(Code::Arity, format!("these ends take no {what}")).at(span).hint(hint))
    };
    let slopes_hint = "slopes=[a, b] are those of clamped ends";
    let moments_hint = "moments=[a, b] stand alone: they are the second derivatives at the ends";
    match (word(args.given(2)), slopes, moments) {
        (_, Some(_), Some((_, span))) => unwanted("moments", span, moments_hint),
        (None | Some(("clamped", ..)), Some((value, span)), None) => {
            pair(value, form, span).map(|(first, last)| Ends::clamped(first, last))
        }
        (None, None, Some((value, span))) => {
            pair(value, form, span).map(|(first, last)| Ends::second_derivatives(first, last))
        }
        (Some(("clamped", _, span)), None, _) => {
            Err(Diagnostic::error(Code::Arity, "clamped ends need their slopes")
                .at(span)
                .hint("ends=clamped, slopes=[a, b]"))
        }
        (Some(_), Some((_, span)), None) => unwanted("slopes", span, slopes_hint),
        (Some(_), None, Some((_, span))) => unwanted("moments", span, moments_hint),
        (None | Some(("natural", ..)), None, None) => Ok(Ends::natural()),
        (Some(("periodic", ..)), None, None) => Ok(Ends::Periodic),
        (Some(("not_a_knot", ..)), None, None) => Ok(Ends::not_a_knot()),
        (Some((_, value, span)), None, None) => Err(ENDS.kind.refuses(value).at(span)),
    }
}

/// One row for each equation: the coefficients of the unknown before, of its own and of the one
/// after it, the right side, and the solution. Rows of inner nodes bear the names of textbooks,
/// μ_i, λ_i and d_i.
fn system(spline: &CubicSpline<Fraction, Datum>, form: Form) -> Table {
    let system = spline.system();
    let (letter, below, above, solution) = match system.unknowns {
        Unknowns::Moments => ("M", "mu", "lambda", spline.moments()),
        Unknowns::Slopes => ("m", "lambda", "mu", spline.slopes()),
    };
    let unknown = |shift: Option<Sign>| -> Expr {
        let i = Expr::name("i");
        let index = match shift {
            None => i,
            Some(sign) => {
                Expr::sum(vec![Term { sign: Sign::Plus, expr: i }, Term { sign, expr: Expr::int(1) }])
            }
        };
        Kind::Subscript(Box::new(Expr::name(letter)), vec![index]).into()
    };
    let words = |words: &str| Expr::from(Kind::Text(words.to_owned()));
    let mut table = Table {
        header: vec![
            Expr::name("i"),
            unknown(Some(Sign::Minus)),
            unknown(None),
            unknown(Some(Sign::Plus)),
            words("right side"),
            words("solution"),
        ],
        rows: Vec::new(),
    };
    let matrix = &system.matrix;
    let n = spline.pieces();
    for (row, right) in system.right.iter().enumerate() {
        let i = row + system.first;
        let inner = matrix.is_cyclic() || (i > 0 && i < n);
        let scalar = |x: &Fraction| Value::Scalar(x.clone());
        let named = |name: &str, value: Value| match inner {
            true => Cell::Labelled(indexed(name, i), value),
            false => Cell::Value(value),
        };
        // There is nothing before the first and nothing after the last equation.
        let neighbour = |name: &str, x: &Fraction, there: bool| match there {
            true => named(name, scalar(x)),
            false => Cell::Empty,
        };
        let right = form.plain(right.clone());
        table.rows.push(vec![
            Cell::Value(Value::int(i as i64)),
            neighbour(below, &matrix.lower()[row], inner || i > 0),
            Cell::Value(scalar(&matrix.diagonal()[row])),
            neighbour(above, &matrix.upper()[row], inner || i < n),
            // The right sides for slopes have no letter of their own.
            if system.unknowns == Unknowns::Moments { named("d", right) } else { Cell::Value(right) },
            Cell::Labelled(indexed(letter, i), form.plain(solution[i].clone())),
        ]);
    }
    if system.first > 0 {
        let same = Expr::relation(indexed(letter, 0), Rel::Eq, indexed(letter, n));
        let mut row = vec![Cell::Value(Value::int(0))];
        row.resize(5, Cell::Empty);
        row.push(Cell::Formula(same));
        table.rows.insert(0, row);
    }
    table
}
