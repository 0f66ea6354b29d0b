//! Values by de Casteljau's and de Boor's schemes, and inserted knots, with polar labels.

use num_traits::{One, Zero};

use super::lines::{call, chain, combination, factor, line, sequence, subscript, term};
use super::words::{Reason, Title};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term};
use crate::language::value::{Derivation, Form, Geometry, Line, polynomial_expr, symbol_expr};
use crate::math::curve::{BezierCurve, CurveError, Tableau};
use crate::math::poly::Fraction;
use crate::math::ring::compare;
use crate::math::ring::{Field, Ring};
use crate::math::spline::{BSpline, DeBoor, SplineError};

/// The label f(u, v, w).
pub fn polar_label(arguments: &[Fraction]) -> Expr {
    label("f", arguments)
}

pub(super) fn label(name: &str, arguments: &[Fraction]) -> Expr {
    call(Expr::name(name), arguments.iter().map(polynomial_expr).collect())
}

/// (1 − s) p + s q, as one writes it.
pub fn mean_of_two(s: &Fraction, p: Expr, q: Expr) -> Expr {
    combination([(Fraction::one().minus(s), p), (s.clone(), q)])
}

pub(super) fn point_expr(form: Form, point: &[Fraction]) -> Expr {
    form.plain(point).to_expr()
}

/// F(t) = Σ b_i B_i^n(t)
pub(super) fn given_curve(name: &str, geometry: &Geometry) -> Line {
    let left = Expr::apply(Expr::name(name), vec![symbol_expr(&geometry.parameter())]);
    line(chain([left, geometry.display_expr()]), Reason::Given)
}

fn symbolic(x: &Fraction) -> bool {
    x.as_rational().is_none()
}

/// Whether values of a scheme would be long: symbolic points mixed by symbolic ratios, or ratios
/// that are quotients. Then each point is shown only as the mean that it is.
pub fn shown_as_means(tableau: &Tableau<Fraction>, ratios: &[Vec<Fraction>]) -> bool {
    let points = tableau.levels[0].iter().flatten().any(symbolic);
    ratios.iter().flatten().any(|ratio| symbolic(ratio) && (points || ratio.as_polynomial().is_none()))
}

/// The first level, and a line for each further point.
fn levels(tableau: &Tableau<Fraction>, ratios: &[Vec<Fraction>], form: Form) -> Vec<Line> {
    let means_only = shown_as_means(tableau, ratios);
    let name = |r: usize, i: usize| polar_label(&tableau.labels[r][i]);
    let value = |r: usize, i: usize| point_expr(form, &tableau.levels[r][i]);
    let first = (0..tableau.levels[0].len()).map(|i| chain([name(0, i), value(0, i)]));
    let mut lines = vec![line(sequence(first.collect()), Reason::ControlPoints)];
    for (r, ratios) in ratios.iter().enumerate() {
        for (i, ratio) in ratios.iter().enumerate() {
            let mean = mean_of_two(ratio, name(r, i), name(r, i + 1));
            let mut sides = vec![name(r + 1, i), mean];
            if !means_only {
                sides.push(value(r + 1, i));
            }
            lines.push(line(chain(sides), Reason::Level(r + 1)));
        }
    }
    lines
}

/// F(t) = f(t, …, t) = the point, if all arguments are t; the weight is divided out.
fn result(
    tableau: &Tableau<Fraction>,
    arguments: &[Fraction],
    form: Form,
    means_only: bool,
) -> Result<Option<Line>, CurveError> {
    let Some(t) = arguments.first().filter(|t| arguments.iter().all(|u| u == *t)) else { return Ok(None) };
    let left = Expr::apply(Expr::name("F"), vec![polynomial_expr(t)]);
    let value = form.value(tableau.result().clone())?.to_expr();
    if form.rational {
        return Ok(Some(line(chain([left, value]), Reason::DivideByWeight)));
    }
    let mut sides = vec![left, polar_label(arguments)];
    if !means_only {
        sides.push(value);
    }
    Ok(Some(line(chain(sides), Reason::PointOfCurve)))
}

/// De Casteljau's scheme for f(u_1, …, u_n), level by level.
///
/// Cost: that of [`BezierCurve::tableau`] and of writing out its points.
///
/// # Errors
/// [`CurveError::Arguments`] unless there are n arguments; [`CurveError::ZeroDenominator`] for a
/// point of a rational curve at infinity.
pub fn casteljau(
    curve: &BezierCurve<Fraction>,
    form: Form,
    arguments: &[Fraction],
) -> Result<Derivation, CurveError> {
    let tableau = curve.tableau(arguments)?;
    let n = curve.degree();
    let ratios: Vec<Vec<Fraction>> =
        arguments.iter().enumerate().map(|(r, u)| vec![local(curve, u); n - r]).collect();
    let mut lines = vec![given_curve("F", &Geometry::Bezier(curve.clone(), form))];
    lines.extend(levels(&tableau, &ratios, form));
    lines.extend(result(&tableau, arguments, form, shown_as_means(&tableau, &ratios))?);
    Ok(Derivation { title: Title::DeCasteljau.words(), lines, language: None })
}

/// (u − a)/(b − a)
pub(super) fn local(curve: &BezierCurve<Fraction>, u: &Fraction) -> Fraction {
    let (a, b) = curve.interval().ends();
    u.minus(a).times(&b.minus(a).inverse().expect("the ends of an interval differ"))
}

/// T = the knots.
fn knots_line(name: &str, spline: &BSpline<Fraction>, reason: Reason) -> Line {
    let list = Kind::List(spline.knots().knots().iter().map(polynomial_expr).collect());
    line(chain([Expr::name(name), list.into()]), reason)
}

/// t_j ≤ t < t_{j+1}, where numbers tell.
fn interval_line(spline: &BSpline<Fraction>, span: usize, t: &Fraction) -> Option<Line> {
    use std::cmp::Ordering::{Equal, Less};
    let (start, end) = (&spline.knots().knots()[span], &spline.knots().knots()[span + 1]);
    let last = match (compare(start, t)?, compare(t, end)?) {
        (Less | Equal, Less) => Rel::Lt,
        (Less, Equal) => Rel::Le,
        _ => return None,
    };
    let link = |rel, expr| Link { rel, span: Span::default(), expr };
    let links = vec![link(Rel::Le, polynomial_expr(t)), link(last, polynomial_expr(end))];
    let chain = Kind::Chain(Box::new(polynomial_expr(start)), links).into();
    Some(line(chain, Reason::KnotInterval(span)))
}

/// De Boor's scheme, level by level, as [`BSpline::de_boor`] gives it for these arguments.
///
/// Cost: that of writing out its points.
///
/// # Errors
/// [`CurveError::ZeroDenominator`] for a point of a rational curve at infinity.
pub fn de_boor(
    spline: &BSpline<Fraction>,
    form: Form,
    scheme: &DeBoor<Fraction>,
    arguments: &[Fraction],
) -> Result<Derivation, CurveError> {
    let mut lines = vec![knots_line("T", spline, Reason::Knots)];
    let equal = arguments.first().filter(|t| arguments.iter().all(|u| u == *t));
    lines.extend(equal.and_then(|t| interval_line(spline, scheme.span, t)));
    lines.extend(levels(&scheme.tableau, &scheme.ratios, form));
    let means_only = shown_as_means(&scheme.tableau, &scheme.ratios);
    lines.extend(result(&scheme.tableau, arguments, form, means_only)?);
    Ok(Derivation { title: Title::DeBoor.words(), lines, language: None })
}

/// The ratios by which a new knot t mixes neighbouring control points, and the new points.
///
/// Cost: as [`BSpline::insert`], and writing out all control points.
///
/// # Errors
/// As [`BSpline::insert`].
pub fn insertion(spline: &BSpline<Fraction>, form: Form, t: &Fraction) -> Result<Derivation, SplineError> {
    let (n, span) = (spline.degree(), spline.knots().span_of(t)?);
    let fine = spline.insert(t)?;
    let (old, new) = (spline.knots(), fine.knots());
    let mut lines = vec![knots_line("T", spline, Reason::Knots)];
    lines.extend(interval_line(spline, span, t));
    let given =
        (span - n..=span).map(|i| chain([polar_label(old.label(i)), point_expr(form, &spline.points()[i])]));
    lines.push(line(sequence(given.collect()), Reason::ControlPoints));
    for (i, ratio) in spline.insertion_ratios(t)? {
        let (start, end) = (&old.knots()[i], &old.knots()[i + n]);
        let quotient = difference(t, start).over(difference(end, start));
        let name = subscript("alpha", &[i]);
        lines.push(line(chain([name, quotient, polynomial_expr(&ratio)]), Reason::InsertionRatio { i, n }));
        let mean = mean_of_two(&ratio, polar_label(old.label(i - 1)), polar_label(old.label(i)));
        let value = point_expr(form, &fine.points()[i]);
        lines.push(line(chain([polar_label(new.label(i)), mean, value]), Reason::MixedPoint(i)));
    }
    lines.push(knots_line("U", &fine, Reason::NewKnots));
    let all = fine.points().iter().enumerate();
    let all = all.map(|(i, point)| chain([subscript("e", &[i]), point_expr(form, point)]));
    lines.push(line(sequence(all.collect()), Reason::NewControlPoints));
    Ok(Derivation { title: Title::Insertion.words(), lines, language: None })
}

/// a − b with the numbers put in: 3/2 − 1, not 1/2.
pub(super) fn difference(a: &Fraction, b: &Fraction) -> Expr {
    let second = if is_negative(b) || !single(b) { polynomial_expr(b).grouped() } else { polynomial_expr(b) };
    Expr::sum(vec![
        Term { sign: Sign::Plus, expr: bare_or_grouped(a) },
        Term { sign: Sign::Minus, expr: second },
    ])
}

fn bare_or_grouped(x: &Fraction) -> Expr {
    if single(x) { polynomial_expr(x) } else { factor(polynomial_expr(x)) }
}

/// Whether it is written as one term.
fn single(x: &Fraction) -> bool {
    !matches!(polynomial_expr(x).kind, Kind::Add(terms) if terms.len() > 1)
}

fn is_negative(x: &Fraction) -> bool {
    matches!(polynomial_expr(x).kind, Kind::Add(_))
}

/// Σ weight · label, for weights that may be 0.
pub(super) fn weighted_labels(items: impl IntoIterator<Item = (Fraction, Expr)>) -> Expr {
    let items = items.into_iter().filter(|(weight, _)| !weight.is_zero());
    Expr::sum(items.map(|(weight, label)| term(&weight, vec![label])).collect())
}
