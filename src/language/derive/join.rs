//! The conditions for two Bézier curves to meet C^k, and what they ask of the control points.

use super::lines::{chain, line};
use super::schemes::{given_curve, label, local, point_expr, weighted_labels};
use super::words::{Reason, Title};
use crate::formula::{Expr, Sign, Term};
use crate::language::value::{Derivation, Form, Geometry, Line, Value};
use crate::math::curve::{BezierCurve, CurveError, JoiningCondition, bernstein_scaling, joining_conditions};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// f(b^{n−j}, c^j) = g(b^{n−j}, c^j) for j = 0, …, k, for curves F over [a, b] and G over [b, c]:
/// values of f from its control points by extrapolation, control points of g.
///
/// Cost: k de Casteljau schemes.
///
/// # Errors
/// As [`joining_conditions`].
pub fn joining(
    left: &BezierCurve<Fraction>,
    right: &BezierCurve<Fraction>,
    form: Form,
    k: usize,
) -> Result<Derivation, CurveError> {
    let conditions = joining_conditions(left, right, k)?;
    let curve =
        |name: &str, curve: &BezierCurve<Fraction>| given_curve(name, &Geometry::Bezier(curve.clone(), form));
    let mut lines = vec![curve("F", left), curve("G", right)];
    let mut meets = true;
    for condition in &conditions {
        lines.extend(condition_lines(left, right, form, condition));
        let (order, holds) = (condition.order, condition.holds());
        let difference: Vec<Fraction> =
            condition.found.iter().zip(&condition.required).map(|(x, y)| x.minus(y)).collect();
        let numbers = difference.iter().all(|x| x.as_rational().is_some());
        let sides = [label("g", &condition.label), label("f", &condition.label)];
        let (formula, reason) = match (holds, numbers) {
            (true, _) => (chain(sides), Reason::ConditionHolds(order)),
            (false, true) => {
                meets = false;
                (minus(sides, form, difference), Reason::ConditionFails(order))
            }
            // c_j stands alone: the condition says what it has to be.
            (false, false) => match lone_symbol(condition) {
                Some(found) => {
                    (chain([found, point_expr(form, &condition.required)]), Reason::Condition(order))
                }
                None => (minus(sides, form, difference), Reason::ConditionOnDifference(order)),
            },
        };
        lines.push(line(formula, reason));
        if !meets {
            break;
        }
    }
    Ok(Derivation { title: Title::Joining(k).words(), lines, language: None })
}

/// g(…) − f(…) = difference
fn minus([g, f]: [Expr; 2], form: Form, difference: Vec<Fraction>) -> Expr {
    let terms = vec![Term { sign: Sign::Plus, expr: g }, Term { sign: Sign::Minus, expr: f }];
    chain([Expr::sum(terms), point_expr(form, &difference)])
}

/// The control point of the second curve, if it is a symbol that does not occur in the condition.
fn lone_symbol(condition: &JoiningCondition<Fraction>) -> Option<Expr> {
    let [found] = &condition.found[..] else { return None };
    let [symbol] = <[Symbol; 1]>::try_from(found.variables()).ok()?;
    let bare = *found == Fraction::from(MultiPoly::symbol(symbol.clone()));
    let free = !condition.required.iter().any(|x| x.variables().contains(&symbol));
    (bare && free).then(|| Value::Scalar(found.clone()).to_expr())
}

/// The value of f by extrapolation, and that of g.
fn condition_lines(
    left: &BezierCurve<Fraction>,
    right: &BezierCurve<Fraction>,
    form: Form,
    condition: &JoiningCondition<Fraction>,
) -> [Line; 2] {
    let (n, j) = (left.degree(), condition.order);
    let (a, b) = left.interval().ends();
    // f(b^{n−j}, c^j) = Σ_i B_i^j(λ) f(a^{j−i}, b^{n−j+i}) with c = (1 − λ) a + λ b.
    let weights = bernstein_scaling(j, &local(left, right.interval().end()));
    let labels = (0..=j).map(|i| {
        let arguments = [vec![a.clone(); j - i], vec![b.clone(); n - j + i]].concat();
        (weights[i][j].clone(), label("f", &arguments))
    });
    let value = point_expr(form, &condition.required);
    let f = chain([label("f", &condition.label), weighted_labels(labels), value]);
    let g = chain([label("g", &condition.label), point_expr(form, &condition.found)]);
    let reason = if j == 0 { Reason::LastControlPoint } else { Reason::Extrapolated(j) };
    [line(f, reason), line(g, Reason::ControlPointOfSecond(j))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::Zero;

    #[test]
    fn weights_add_up_to_one() {
        let weights = bernstein_scaling(3, &Fraction::from(crate::math::number::integer(2)));
        let sum = (0..=3).fold(Fraction::zero(), |sum, i| sum.plus(&weights[i][3]));
        assert_eq!(sum, Fraction::from(crate::math::number::integer(1)));
    }
}
