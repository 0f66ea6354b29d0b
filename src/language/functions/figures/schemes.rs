//! Triangular schemes: de Casteljau, de Boor, divided differences; steps of subdivision.

use super::numeric::{form_name, numbers};
use super::options::{Labels, drawn, finished, labels};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::functions::notions::scheme;
use crate::language::functions::splines;
use crate::language::ops::errors::{curve_error, subdivision_error};
use crate::language::ops::takes::word_of;
use crate::language::value::{Form, Geometry, Value, polynomial_expr};
use crate::math::curve::{Point, Tableau};
use crate::math::interpolate::{DividedDifferences, InterpolationError};
use crate::math::number::Rational;
use crate::math::poly::Fraction;
use crate::math::ring::{Field, Ring};
use crate::scene::pictures::{Apex, PyramidPicture, SubdivisionPicture};
use num_traits::One;

type Result<T> = std::result::Result<T, Diagnostic>;

/// A scheme of more entries is not read any more.
const LARGEST: usize = 24;

pub(super) fn pyramid(args: &Arguments) -> Evaluated {
    let apex = match args.named("apex") {
        None => Apex::Right,
        Some((value, span)) => match word_of(value) {
            Some("right") => Apex::Right,
            Some("top") => Apex::Top,
            Some("bottom") => Apex::Bottom,
            _ => {
                return Err(Diagnostic::error(Code::Domain, "the apex of a scheme is right, top or bottom")
                    .at(span)
                    .hint("for example apex=top"));
            }
        },
    };
    let (levels, weights, title) = match args.value(0)? {
        Value::List(_) if matches!(args.value(1)?, Value::List(_)) => divided_differences(args)?,
        _ => blossom(args)?,
    };
    if levels.len() > LARGEST {
        return Err(Diagnostic::error(
            Code::Undrawable,
            format!("a scheme of {} levels does not fit a page", levels.len()),
        )
        .at(args.span(0))
        .hint("casteljau(c, t) and deboor(s, t) print schemes of any size"));
    }
    let last = levels.len() - 1;
    let shown = args.flag("weights")?;
    let picture = PyramidPicture {
        weights: if shown { weights } else { Vec::new() },
        apex,
        marked: vec![(last, 0)],
        ..PyramidPicture::of(levels)
    };
    let [english, chinese] = title;
    finished(args, drawn(picture.scene(), args.span(0))?.with_title(english).also("zh", chinese))
}

/// The polygons of a subdivision scheme.
pub(super) fn subdivision(args: &Arguments) -> Evaluated {
    /// After more steps nothing new is seen.
    const MOST: usize = 8;
    let (points, _) = args.control_points(0)?;
    let steps = args.size(2)?;
    if steps > MOST {
        let error = Diagnostic::error(Code::Undrawable, format!("{steps} steps are too many for a picture"));
        return Err(error
            .at(args.span(2))
            .hint("after a few steps the polygon cannot be told from the limit"));
    }
    let plane = |point: &Point<Fraction>| -> Result<[Rational; 2]> {
        numbers(point, args.span(0))?.try_into().map_err(|list: Vec<Rational>| {
            let message = format!("points of the plane are needed, these have {} coordinates", list.len());
            Diagnostic::error(Code::Shape, message).at(args.span(0)).hint("such as [[0, 0], [1, 3], [4, 3]]")
        })
    };
    let (scheme, closed) = (scheme(args, 1)?, args.flag("closed")?);
    let mut levels = vec![points];
    for k in 0..steps {
        let finer = scheme.refine(&levels[k], closed).map_err(subdivision_error).at(args.span(0))?;
        levels.push(finer);
    }
    let levels = levels.iter().map(|level| level.iter().map(plane).collect());
    let levels: Vec<Vec<[Rational; 2]>> = levels.collect::<Result<_>>()?;
    let labels = match labels(args)? {
        Some(Labels::None) => Vec::new(),
        _ => (0..levels[0].len()).map(|i| Expr::indexed("p", i as i64)).collect(),
    };
    finished(args, drawn(SubdivisionPicture { levels, closed, labels }.scene(), args.span(0))?)
}

/// The entries, their weights, and what it is called, in English and Chinese.
type Scheme = (Vec<Vec<Expr>>, Vec<Vec<[Expr; 2]>>, [&'static str; 2]);

/// De Casteljau's scheme of a Bézier curve, or de Boor's of a spline.
fn blossom(args: &Arguments) -> Result<Scheme> {
    let wanted = labels(args)?.unwrap_or(Labels::Polar);
    if let Value::Geometry(geometry) = args.value(0)?
        && let Geometry::Spline(spline, form) = &**geometry
    {
        let (scheme, _) = splines::de_boor(args, spline)?;
        let levels = entries(&scheme.tableau, wanted, *form);
        return Ok((levels, weights(&scheme.ratios), ["De Boor's algorithm", "de Boor 算法"]));
    }
    let (curve, form) = args.curve(0)?;
    let mut list = args.scalars_from(1)?;
    if let [t] = list.as_slice() {
        list = vec![t.clone(); curve.degree()];
    }
    let tableau = curve.tableau(&list).map_err(curve_error).at(args.span(1))?;
    let (a, b) = curve.interval().ends();
    let unit =
        b.minus(a).inverse().ok_or_else(|| curve_error(crate::math::curve::CurveError::EmptyInterval))?;
    let ratios: Vec<Vec<Fraction>> =
        list.iter().enumerate().map(|(r, u)| vec![u.minus(a).times(&unit); curve.degree() - r]).collect();
    Ok((entries(&tableau, wanted, form), weights(&ratios), ["De Casteljau's algorithm", "de Casteljau 算法"]))
}

fn entries(tableau: &Tableau<Fraction>, wanted: Labels, form: Form) -> Vec<Vec<Expr>> {
    let label = |arguments: &Vec<Fraction>| match arguments.as_slice() {
        [] => form_name(0),
        _ => Expr::apply(form_name(0), arguments.iter().map(polynomial_expr).collect()),
    };
    match wanted {
        Labels::Values => tableau
            .levels
            .iter()
            .map(|level| level.iter().map(|point| form.plain(point.clone()).to_expr()).collect())
            .collect(),
        _ => tableau.labels.iter().map(|level| level.iter().map(label).collect()).collect(),
    }
}

/// 1 − s and s at the two arrows to each entry.
fn weights(ratios: &[Vec<Fraction>]) -> Vec<Vec<[Expr; 2]>> {
    let pair = |s: &Fraction| [polynomial_expr(&Fraction::one().minus(s)), polynomial_expr(s)];
    ratios.iter().map(|level| level.iter().map(pair).collect()).collect()
}

/// The triangle of divided differences; equal neighbours among the nodes are repeated nodes.
fn divided_differences(args: &Arguments) -> Result<Scheme> {
    if args.len() > 2 {
        return Err(Diagnostic::error(Code::Arity, "nodes and values are two lists")
            .at(args.span(2))
            .hint("figure_pyramid([0, 1, 2], [1, 3, 2])"));
    }
    let (nodes, values) = (args.scalars(0)?, args.scalars(1)?);
    // Differences of symbols are long quotients, which nobody reads in a figure.
    let symbolic = nodes.iter().chain(&values).any(|x| x.as_rational().is_none());
    let usual = if symbolic { Labels::Points } else { Labels::Values };
    let wanted = labels(args)?.unwrap_or(usual);
    let table = DividedDifferences::with_repeats(&nodes, &values).map_err(|error| {
        let (code, span) = match error {
            InterpolationError::NodesApart { .. } => (Code::Coincident, args.span(0)),
            _ => (Code::Shape, args.span(1)),
        };
        Diagnostic::error(code, error.to_string()).at(span).hint(
            "give one value for each node; a repeated node stands next to itself, then come derivatives",
        )
    })?;
    let name = |k: usize, i: usize| {
        let nodes = nodes[i..=i + k].iter().map(polynomial_expr).collect();
        Expr::product(vec![form_name(0), Kind::List(nodes).into()])
    };
    let levels = table.columns().iter().enumerate().map(|(k, column)| {
        let entry = |(i, value): (usize, &Fraction)| match wanted {
            Labels::Points => name(k, i),
            _ => polynomial_expr(value),
        };
        column.iter().enumerate().map(entry).collect()
    });
    Ok((levels.collect(), Vec::new(), ["Divided differences", "差商"]))
}
