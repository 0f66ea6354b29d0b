//! The equation of a plane curve as a determinant.

use super::lines::{chain, factor, line, power, term};
use super::words::{Reason, Title};
use crate::formula::Expr;
use crate::language::value::{Derivation, Value, grouped_expr, polynomial_expr};
use crate::math::curve::{bezout_matrix, implicit_equation};
use crate::math::linalg::determinant;
use crate::math::poly::{Fraction, Symbol};

/// P = W x − X and Q = W y − Y, Bézout's matrix, its determinant by factors, and the factor that is the equation. `None` for a single point.
///
/// Cost: that of [`implicit_equation`], and a determinant of size n with polynomials in x and y.
///
/// # Panics
/// If t, x or y occur in the coordinates, by powers of the parameter, the weight last.
pub fn implicit(coordinates: &[Vec<Fraction>; 3]) -> Option<Derivation> {
    let [t, x, y] = ["t", "x", "y"].map(Symbol::new);
    let equation = implicit_equation(coordinates, [&x, &y])?;
    let (p, q, matrix) = bezout_matrix(coordinates, &t, [&x, &y])?;
    let at = |name: &str, letters: &[&str]| {
        Expr::apply(Expr::name(name), letters.iter().map(|letter| Expr::name(*letter)).collect())
    };
    let mut lines = vec![
        line(chain([at("P", &["t"]), polynomial_expr(&p)]), Reason::CommonRoot),
        line(chain([at("Q", &["t"]), polynomial_expr(&q)]), Reason::CommonRoot),
        line(chain([Expr::name("M"), Value::Matrix(matrix.clone()).to_expr()]), Reason::Bezout),
    ];
    let value = determinant(&matrix).ok()?;
    let by_factors = value.numerator().factors();
    let factors = by_factors
        .factors
        .iter()
        .filter_map(|(f, m)| power(factor(grouped_expr(&Fraction::from(f.clone()))), *m));
    let below = Fraction::new(
        crate::math::poly::MultiPoly::constant(by_factors.constant),
        value.denominator().clone(),
    )
    .ok()?;
    let product = Expr::sum(vec![term(&below, factors.collect())]);
    lines.push(line(chain([at("det", &["M"]), product]), Reason::Determinant));
    lines.push(line(
        chain([at("F", &["x", "y"]), polynomial_expr(&Fraction::from(equation))]),
        Reason::EquationOfCurve,
    ));
    Some(Derivation { title: Title::Implicit.words(), lines, language: None })
}
