//! Why a point of a Bézier curve lies in the convex hull of the control points.

use super::lines::{chain, combination, line, sequence};
use super::schemes::{given_curve, point_expr};
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind};
use crate::language::lexicon::families;
use crate::language::value::{Derivation, Form, Geometry, polynomial_expr};
use crate::math::basis::bernstein_all;
use crate::math::curve::BezierCurve;
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use num_traits::Zero;

/// c(t) = Σ B_i^n(t) b_i for a parameter of the interval: the weights are not negative and have the sum 1.
///
/// Cost: the values of n + 1 Bernstein polynomials.
pub fn hull(curve: &BezierCurve<Fraction>, form: Form, t: &Fraction) -> Derivation {
    let n = curve.degree();
    let local = curve.interval().local(t);
    let weights = bernstein_all(n, &local);
    let name = |i: usize| {
        let head = Kind::Subscript(Box::new(Expr::name(families::BERNSTEIN)), vec![Expr::int(i as i64)]);
        Expr::apply(Expr::from(head).power(Expr::int(n as i64)), vec![polynomial_expr(&local)])
    };
    let mut lines = vec![given_curve("F", &Geometry::Bezier(curve.clone(), form))];
    let values = weights.iter().enumerate().map(|(i, w)| chain([name(i), polynomial_expr(w)]));
    lines.push(line(sequence(values.collect()), Reason::WeightsNotNegative));
    let total = weights.iter().fold(Fraction::zero(), |sum, w| sum.plus(w));
    let sum = combination(weights.iter().map(|w| (w.clone(), Expr::int(1))));
    lines.push(line(chain([sum, polynomial_expr(&total)]), Reason::WeightsSumToOne));
    let value = Expr::apply(Expr::name("F"), vec![polynomial_expr(t)]);
    let points = weights.iter().zip(curve.points()).map(|(w, p)| (w.clone(), point_expr(form, p)));
    let sides = [value, combination(points), point_expr(form, &curve.value(t))];
    lines.push(line(chain(sides), Reason::ConvexCombination));
    Derivation { title: Title::Hull.words(), lines, language: None }
}
