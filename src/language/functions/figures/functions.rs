//! Graphs of functions.

use super::numeric::{HEIGHT, number, numbers};
use super::options::{Labels, drawn, finished, labels};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::lexicon::families;
use crate::language::ops::errors::{piecewise_error, spline_error, wrong_kind};
use crate::language::value::{Geometry, Value, polynomial_expr, symbol_expr};
use crate::math::basis::bernstein_to_power;
use crate::math::number::{Rational, integer};
use crate::math::piecewise::{Outside, Piecewise};
use crate::math::poly::Coefficients;
use crate::math::poly::{Fraction, Symbol};
use crate::math::spline::KnotVector;
use crate::scene::pictures::{BasisPicture, Function, Knot, Piece};
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

/// More names would cover the graphs.
const MOST_NAMED: usize = 14;

/// Formulas of more characters do not stand beside their graphs.
const LONGEST_NAME: usize = 24;

fn named(args: &Arguments, count: usize) -> Result<bool> {
    Ok(match labels(args)? {
        Some(labels) => labels == Labels::Points,
        None => count <= MOST_NAMED,
    })
}

/// N_i^n
fn member(family: &str, i: usize, n: usize) -> Expr {
    let index = Kind::Subscript(Box::new(Expr::name(family)), vec![Expr::int(i as i64)]);
    Expr::from(index).power(Expr::int(n as i64))
}

pub(super) fn basis(args: &Arguments) -> Evaluated {
    let n = args.size(0)?;
    if args.given(1).is_none() {
        crate::budget::charge_terms((n as u64 + 1).saturating_pow(2));
        let named = named(args, n + 1)?;
        let interval = [integer(0), integer(1)];
        let powers = bernstein_to_power(n);
        let function = |i: usize| Function {
            pieces: vec![Piece {
                interval: interval.clone(),
                coefficients: powers.column(i).iter().cloned().collect(),
            }],
            label: named.then(|| member(families::BERNSTEIN, i, n)),
        };
        let picture = BasisPicture {
            height: HEIGHT,
            ..BasisPicture::of((0..=n).map(function).collect(), interval.clone())
        };
        let title = format!("Bernstein polynomials of degree {n}");
        let scene = drawn(picture.scene(), args.span(0))?.with_title(title);
        return finished(args, scene.also("zh", format!("{n} 次 Bernstein 多项式")));
    }
    let span = args.span(1);
    let knots = KnotVector::new(n, numbers(&args.scalars(1)?, span)?).map_err(spline_error).at(span)?;
    let named = named(args, knots.count())?;
    let functions = knots.basis_functions().into_iter().enumerate();
    let functions = functions.map(|(i, function)| Function {
        pieces: pieces(&function),
        label: named.then(|| member(families::SPLINE, i, n)),
    });
    let interval = match knots.knots() {
        [first, .., last] => [first.clone(), last.clone()],
        _ => [integer(0), integer(0)],
    };
    let picture = BasisPicture {
        knots: knots
            .multiplicities()
            .into_iter()
            .map(|(at, multiplicity)| Knot { at, multiplicity, label: None })
            .collect(),
        height: HEIGHT,
        ..BasisPicture::of(functions.collect(), interval)
    };
    let title = format!("B-splines of degree {n}");
    let scene = drawn(picture.scene(), span)?.with_title(title);
    finished(args, scene.also("zh", format!("{n} 次 B 样条")))
}

fn pieces(function: &Piecewise<Rational>) -> Vec<Piece> {
    let intervals = function.breaks().windows(2);
    let piece = |(interval, coefficients): (&[Rational], &Coefficients<Rational>)| Piece {
        interval: [interval[0].clone(), interval[1].clone()],
        coefficients: coefficients.to_vec(),
    };
    intervals.zip(function.pieces()).map(piece).collect()
}

/// A function before the interval of the picture is known.
enum Given {
    Polynomial(Vec<Rational>, Symbol),
    Piecewise(Piecewise<Rational>, Symbol),
}

pub(super) fn functions(args: &Arguments) -> Evaluated {
    let span = args.span(0);
    let variable = args.variable()?;
    let items: Vec<Value> = match args.value(0)? {
        Value::List(items) if items.is_empty() => {
            return Err(Diagnostic::error(Code::Empty, "there are no functions to draw")
                .at(span)
                .hint("for example figure_functions([t^2, t^3], 0, 1)"));
        }
        Value::List(items) => items.to_vec(),
        one => vec![one.clone()],
    };
    let named = named(args, items.len())?;
    let mut given = Vec::with_capacity(items.len());
    let mut names = Vec::with_capacity(items.len());
    for item in &items {
        names.push(if named { name_of(item) } else { None });
        given.push(read(args, item, variable.clone(), span)?);
    }
    let interval = interval(args, &given)?;
    let mut letter = variable;
    let mut drawings = Vec::with_capacity(given.len());
    for (function, label) in given.into_iter().zip(names) {
        let (pieces, own) = match function {
            Given::Polynomial(coefficients, own) => {
                (vec![Piece { interval: interval.clone(), coefficients }], own)
            }
            Given::Piecewise(function, own) => (with_outside(&function, &interval), own),
        };
        letter.get_or_insert(own);
        drawings.push(Function { pieces, label });
    }
    let count = drawings.len();
    let picture = BasisPicture {
        variable: letter.as_ref().map(symbol_expr),
        height: HEIGHT,
        ..BasisPicture::of(drawings, interval)
    };
    let end = args.given(2).map_or(span, |(_, span)| span);
    let title = if count == 1 { "Graph of a function" } else { "Graphs of functions" };
    finished(args, drawn(picture.scene(), end)?.with_title(title).also("zh", "函数图像"))
}

/// What is written beside a graph: the name of the function, or its formula if that is short.
fn name_of(value: &Value) -> Option<Expr> {
    match value {
        Value::Function(function) if function.name.is_some() => function.name.as_ref().map(symbol_expr),
        Value::Scalar(formula) => {
            let expr = polynomial_expr(formula);
            (crate::language::write::text(&expr).chars().count() <= LONGEST_NAME).then_some(expr)
        }
        _ => None,
    }
}

fn read(args: &Arguments, item: &Value, variable: Option<Symbol>, span: Span) -> Result<Given> {
    let t = || Symbol::new("t");
    let numeric = |function: &Piecewise<Fraction>| -> Result<Piecewise<Rational>> {
        let breaks = numbers(function.breaks(), span)?;
        let pieces = function.pieces().iter().map(|piece| numbers(piece, span));
        Piecewise::new(breaks, pieces.collect::<Result<_>>()?, function.outside())
            .map_err(piecewise_error)
            .at(span)
    };
    match item {
        Value::Piecewise(function) => {
            Ok(Given::Piecewise(numeric(&function.function)?, function.variable.clone()))
        }
        Value::Geometry(geometry) => {
            let (spline, form) = args.with_first(Value::Geometry(geometry.clone())).spline(0)?;
            if spline.dimension() != 1 || form.rational {
                let figure = match **geometry {
                    Geometry::Bezier(..) => "figure_bezier(c)",
                    _ => "figure_bspline(s)",
                };
                return Err(wrong_kind("functions", item).at(span).hint(format!("{figure} draws a curve")));
            }
            match spline.power_pieces().first() {
                Some(function) => Ok(Given::Piecewise(numeric(function)?, t())),
                None => Err(wrong_kind("functions", item).at(span)),
            }
        }
        other => {
            let given = args.with_first(other.clone()).univariate_in(0, variable)?;
            Ok(Given::Polynomial(numbers(&given.coefficients, span)?, given.variable))
        }
    }
}

/// What is drawn: from a to b, or all pieces, or [0, 1].
fn interval(args: &Arguments, given: &[Given]) -> Result<[Rational; 2]> {
    let whole = given.iter().filter_map(|function| match function {
        Given::Piecewise(function, _) => Some([function.breaks().first()?, function.breaks().last()?]),
        Given::Polynomial(..) => None,
    });
    let whole = whole.fold(None, |all: Option<[Rational; 2]>, [a, b]| match all {
        None => Some([a.clone(), b.clone()]),
        Some([least, greatest]) => Some([least.min(a.clone()), greatest.max(b.clone())]),
    });
    let end = |i: usize| args.optional_scalar(i)?.map(|end| number(&end, args.span(i))).transpose();
    let (a, b) = (end(1)?, end(2)?);
    Ok(match (a, b, whole) {
        (None, None, Some(whole)) => whole,
        (a, b, whole) => {
            let start = match (a, whole) {
                (Some(a), _) => a,
                (None, Some([a, _])) => a,
                (None, None) => integer(0),
            };
            let b = b.unwrap_or_else(|| &start + integer(1));
            [start, b]
        }
    })
}

/// The pieces, with zero around them where the function is that.
fn with_outside(function: &Piecewise<Rational>, [a, b]: &[Rational; 2]) -> Vec<Piece> {
    let mut list = pieces(function);
    if function.outside() == Outside::Zero
        && let (Some(first), Some(last)) = (function.breaks().first(), function.breaks().last())
    {
        let zero = |from: &Rational, to: &Rational| Piece {
            interval: [from.clone(), to.clone()],
            coefficients: vec![Rational::zero()],
        };
        if a < first {
            list.insert(0, zero(a, first));
        }
        if last < b {
            list.push(zero(last, b));
        }
    }
    list
}
