//! The curvature of a curve from its first two derivatives.

use super::lines::{chain, derivative, line};
use super::words::{Reason, Title};
use crate::formula::Expr;
use crate::language::value::{Derivation, Form, Value, polynomial_expr};
use crate::math::curve::{CurveError, Vector, squared_curvature};
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use num_traits::Zero;

/// c', c'' at a parameter, |c'|², |c''|² and c' · c'', and κ² = (|c'|² |c''|² − (c' · c'')²)/|c'|⁶; the value of κ with its sign comes last, if
/// it is known.
///
/// # Errors
/// As [`squared_curvature`].
pub fn curvature(
    t: &Fraction,
    [first, second]: [&Vector<Fraction>; 2],
    value: Option<&Value>,
) -> Result<Derivation, CurveError> {
    let squared = squared_curvature(first, second)?;
    let dot = |v: &Vector<Fraction>, w: &Vector<Fraction>| {
        v.iter().zip(w.iter()).fold(Fraction::zero(), |sum, (x, y)| sum.plus(&x.times(y)))
    };
    let at = |order: usize| Expr::apply(derivative(Expr::name("c"), order), vec![polynomial_expr(t)]);
    let vector = |v: &Vector<Fraction>| Form::default().plain(v.clone()).to_expr();
    let named = |name: &str, x: &Fraction| chain([Expr::name(name), polynomial_expr(x)]);
    let mut lines = vec![
        line(chain([at(1), vector(first)]), Reason::TangentVector),
        line(chain([at(2), vector(second)]), Reason::SecondDerivative),
        line(named("E", &dot(first, first)), Reason::LengthSquared("c'")),
        line(named("S", &dot(second, second)), Reason::LengthSquared("c''")),
        line(named("D", &dot(first, second)), Reason::InnerProduct),
    ];
    let kappa = || Expr::name("kappa");
    let minus = |left: Expr, right: Expr| {
        use crate::formula::{Sign, Term};
        Expr::sum(vec![Term { sign: Sign::Plus, expr: left }, Term { sign: Sign::Minus, expr: right }])
    };
    let [e, s, d] = ["E", "S", "D"].map(Expr::name);
    let formula = minus(Expr::product(vec![e.clone(), s]), d.power(Expr::int(2)));
    let formula = formula.grouped().over(e.power(Expr::int(3)));
    let square = kappa().power(Expr::int(2));
    lines.push(line(chain([square, formula, polynomial_expr(&squared)]), Reason::SquaredCurvature));
    lines.extend(value.map(|value| line(chain([kappa(), value.to_expr()]), Reason::CurvatureWithSign)));
    Ok(Derivation { title: Title::Curvature.words(), lines, language: None })
}
