//! Why a polynomial is not negative on an interval: coefficients that anybody can check, or a value that is negative.

use super::lines::{chain, factor, fresh, line, power, sequence, symbol, term};
use super::polar::{given, univariate};
use super::schemes::label;
use super::words::{Reason, Title};
use crate::formula::{Expr, Rel};
use crate::language::value::{Derivation, Notation, grouped_expr, in_letter, polynomial_expr, symbol_expr};
use crate::math::blossom::PolarForm;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Poly, Symbol};
use crate::math::ring::Ring;
use num_traits::One;

/// Whether a derivation ends with a value of F that is negative.
pub fn shows_negative_value(shown: &Derivation) -> bool {
    shown.lines.last().is_some_and(|line| line.reason == Reason::Negative.words())
}

/// F ≥ 0 on [a, b] by Bernstein coefficients that are not negative, which are values of the polar form, or a value of F that is
/// negative. An end that is `None` is none.
///
/// Cost: that of [`Poly::positivity`], and n + 1 polar values for each part.
pub fn positivity(f: &Poly, variable: &Symbol, a: Option<&Rational>, b: Option<&Rational>) -> Derivation {
    let formula = |p: &Poly| Fraction::from(in_letter(p, variable));
    let polar =
        |p: &Poly| PolarForm::new(p.coefficients().into_iter().map(Fraction::from).collect::<Vec<_>>());
    let value = |name: &str, at: Expr| Expr::apply(Expr::name(name), vec![at]);
    let title = Title::Positivity.words();
    let mut lines = vec![given(Expr::name("F"), &univariate(polar(f), variable), Reason::Given)];
    let shown = match f.positivity(a, b) {
        Ok(shown) => shown,
        Err(point) => {
            let number = polynomial_expr(&Fraction::from(f.value(&point)));
            let at = value("F", polynomial_expr(&Fraction::from(point)));
            lines.push(line(chain([at, number]), Reason::Negative));
            return Derivation { title, lines, language: None };
        }
    };
    let square = shown.root_of_square.degree() > Some(0);
    let (name, small) = if square { ("G", "g") } else { ("F", "f") };
    if square {
        let factors = [
            power(factor(grouped_expr(&formula(&shown.root_of_square))), 2),
            power(value("G", symbol_expr(variable)), 1),
        ];
        lines.push(given(Expr::name("G"), &univariate(polar(&shown.rest), variable), Reason::WithoutSquares));
        let product = Expr::sum(vec![term(&Fraction::one(), factors.into_iter().flatten().collect())]);
        lines.push(line(chain([value("F", symbol_expr(variable)), product]), Reason::SquareTimes));
    }
    let form = polar(&shown.rest);
    let n = form.degree();
    let x = fresh(&["x", "s", "u"], std::slice::from_ref(variable));
    let beyond = |tail: &Option<(Rational, Poly)>, up: bool| {
        let (c, p) = tail.as_ref().filter(|_| n > 0)?;
        let (from, step) = (Fraction::from(c.clone()), symbol(&x));
        let at = if up { from.plus(&step) } else { from.minus(&step) };
        let sides = [value(name, polynomial_expr(&at)), polynomial_expr(&Fraction::from(in_letter(p, &x)))];
        Some(line(chain(sides), Reason::NoneNegativeBeyond { end: c.clone(), up }))
    };
    lines.extend(beyond(&shown.below, false));
    if n > 0 && !shown.parts.is_empty() {
        let equation = univariate(form.clone(), variable).equation(Expr::name(small), Notation::Grouped);
        lines.push(line(equation, Reason::PolarFormOf(name)));
        crate::budget::charge_terms((shown.parts.len() as u64).saturating_mul(n as u64 + 1));
        for (lower, upper, list) in &shown.parts {
            let ends = [lower, upper].map(|q| Fraction::from(q.clone()));
            let point = |(i, b): (usize, &Rational)| {
                let arguments = [vec![ends[0].clone(); n - i], vec![ends[1].clone(); i]].concat();
                chain([label(small, &arguments), polynomial_expr(&Fraction::from(b.clone()))])
            };
            let reason = Reason::NoneNegative { lower: lower.clone(), upper: upper.clone() };
            lines.push(line(sequence(list.iter().enumerate().map(point).collect()), reason));
        }
    }
    lines.extend(beyond(&shown.above, true));
    if n == 0 {
        let constant = polynomial_expr(&formula(&shown.rest));
        let positive = Expr::relation(constant, Rel::Ge, Expr::int(0));
        lines.push(line(positive, Reason::PositiveConstant));
    }
    Derivation { title, lines, language: None }
}
