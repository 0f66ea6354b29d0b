//! Whether two representations are the same curve or surface.

use crate::language::ops::geometry::{as_rational_form, as_rational_spline, as_spline};
use crate::language::value::{Geometry, polynomial_expr};
use crate::language::write::text;
use crate::math::curve::{BezierCurve, TensorPatch};
use crate::math::poly::Fraction;
use crate::math::spline::BSpline;

/// What comes of a comparison.
pub(crate) enum Comparison {
    Same,
    /// With what differs.
    Different(String),
    /// With the reason.
    Unknown(&'static str),
}

use Comparison::{Different, Same, Unknown};

/// Compares as functions of the parameters: degrees, knots and common factors of weights do not
/// matter.
pub(crate) fn compare(left: &Geometry, right: &Geometry) -> Comparison {
    match (left, right) {
        (Geometry::Patch(a, f), Geometry::Patch(b, g)) if f.rational == g.rational => {
            patches(a, b, f.rational)
        }
        (Geometry::Triangle(a, f), Geometry::Triangle(b, g)) if f.rational == g.rational => {
            if a.dimension() != b.dimension() {
                return dimensions(a.dimension(), b.dimension());
            }
            if a.triangle() != b.triangle() {
                return Different("they have different domains".to_owned());
            }
            let n = a.degree().max(b.degree());
            let (a, b) = (a.elevate(n - a.degree()), b.elevate(n - b.degree()));
            nets(a.points() == b.points(), f.rational)
        }
        (Geometry::Surface(a, f), Geometry::Surface(b, g)) if f.rational == g.rational => {
            match a.knots() == b.knots() {
                true => nets(a.net() == b.net(), f.rational),
                false => Unknown("spline surfaces over different knots are not compared"),
            }
        }
        (a, b) if a.is_surface() || b.is_surface() => Unknown("surfaces of different kinds are not compared"),
        (a, b) => curves(a, b),
    }
}

fn dimensions(left: usize, right: usize) -> Comparison {
    Different(format!("one has {left} coordinates, the other {right}"))
}

fn nets(equal: bool, rational: bool) -> Comparison {
    match (equal, rational) {
        (true, _) => Same,
        (false, false) => Different("their control points differ".to_owned()),
        (false, true) => Unknown("the weights may differ by a common factor"),
    }
}

fn patches(a: &TensorPatch<Fraction>, b: &TensorPatch<Fraction>, rational: bool) -> Comparison {
    if a.dimension() != b.dimension() {
        return dimensions(a.dimension(), b.dimension());
    }
    if (a.u(), a.v()) != (b.u(), b.v()) {
        return Different("they have different domains".to_owned());
    }
    let ((m, n), (k, l)) = (a.degrees(), b.degrees());
    let (r, s) = (m.max(k), n.max(l));
    nets(a.elevate(r - m, s - n).net() == b.elevate(r - k, s - l).net(), rational)
}

/// As a spline of homogeneous points.
fn spline(geometry: &Geometry) -> Option<BSpline<Fraction>> {
    match geometry {
        Geometry::Spline(spline, form) => Some(as_rational_spline(spline, *form)),
        Geometry::Bezier(curve, form) => Some(as_rational_spline(&as_spline(curve).ok()?, *form)),
        _ => None,
    }
}

fn curves(left: &Geometry, right: &Geometry) -> Comparison {
    if let (Geometry::Bezier(a, f), Geometry::Bezier(b, g)) = (left, right)
        && a.interval().ends() == b.interval().ends()
        && a.dimension() - usize::from(f.rational) == b.dimension() - usize::from(g.rational)
    {
        let (p, q) = (as_rational_form(a, *f), as_rational_form(b, *g));
        return if same_piece(&p, &q) { Same } else { Different("their control points differ".to_owned()) };
    }
    let (Some(a), Some(b)) = (spline(left), spline(right)) else {
        return Unknown("they are not compared");
    };
    if a.dimension() != b.dimension() {
        return dimensions(a.dimension() - 1, b.dimension() - 1);
    }
    if a.interval() != b.interval() {
        return Different("they have different domains".to_owned());
    }
    // Both over the knots of both.
    let finer = |s: &BSpline<Fraction>, by: &BSpline<Fraction>| {
        let missing: Vec<Fraction> = by
            .inner_knots()
            .into_iter()
            .map(|(knot, _)| knot)
            .filter(|knot| s.knots().multiplicity(knot) == 0)
            .collect();
        s.insert_all(&missing)
    };
    let (Ok(a), Ok(b)) = (finer(&a, &b), finer(&b, &a)) else {
        return Unknown("the order of their knots depends on symbols");
    };
    for (p, q) in a.bezier_pieces().iter().zip(b.bezier_pieces()) {
        if !same_piece(p, &q) {
            let (from, to) = p.interval().ends();
            let shown = |x: &Fraction| text(&polynomial_expr(x));
            return Different(format!("they differ on [{}, {}]", shown(from), shown(to)));
        }
    }
    Same
}

/// p w_q = q w_p for homogeneous points with the weight last.
fn same_piece(p: &BezierCurve<Fraction>, q: &BezierCurve<Fraction>) -> bool {
    let weight = |curve: &BezierCurve<Fraction>| {
        let points = curve.points().iter().map(|point| point[point.len() - 1..].to_vec()).collect();
        BezierCurve::new(points, curve.interval().clone())
    };
    let crossed = |p: &BezierCurve<Fraction>, q: &BezierCurve<Fraction>| weight(p).and_then(|w| w.product(q));
    crossed(q, p) == crossed(p, q)
}
