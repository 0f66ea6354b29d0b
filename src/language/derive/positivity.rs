//! Why a polynomial is not negative on an interval: coefficients that anybody can check, or a value that is negative.

use super::lines::{call, chain, factor, fresh, line, power, sequence, subscript, symbol, term};
use super::polar::{given, univariate};
use super::schemes::label;
use super::words::{Reason, Title};
use crate::formula::{Expr, Rel};
use crate::language::value::{
    Derivation, Notation, Value, grouped_expr, in_letter, polynomial_expr, symbol_expr,
};
use crate::math::blossom::PolarForm;
use crate::math::interval::Interval;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;
use num_traits::{One, Signed, Zero};

/// Whether a derivation ends with a value of F that is negative.
pub fn shows_negative_value(shown: &Derivation) -> bool {
    let refutes = |reason: Reason| shown.lines.last().is_some_and(|line| line.reason == reason.words());
    refutes(Reason::Negative) || refutes(Reason::NotPositive)
}

/// What is to be shown of a polynomial, or of a quotient.
#[derive(Clone, Debug, Default)]
pub struct Claimed {
    /// F = P/Q with a denominator that has no root there; the polynomial is then P Q, which has the sign of F.
    pub quotient: Option<Fraction>,
    /// F > 0, not only F ≥ 0.
    pub strict: bool,
}

/// F ≥ 0 on [a, b], or F > 0, by Bernstein coefficients that are not negative, which are values of the polar form, or a value
/// of F that contradicts it. An end that is `None` is none.
///
/// Cost: that of [`Poly::positivity`], and n + 1 polar values for each part.
pub fn positivity(
    f: &Poly,
    variable: &Symbol,
    a: Option<&Rational>,
    b: Option<&Rational>,
    claimed: &Claimed,
) -> Derivation {
    let formula = |p: &Poly| Fraction::from(in_letter(p, variable));
    let polar =
        |p: &Poly| PolarForm::new(p.coefficients().into_iter().map(Fraction::from).collect::<Vec<_>>());
    let value = |name: &str, at: Expr| Expr::apply(Expr::name(name), vec![at]);
    let title = Title::Positivity.words();
    let (own, own_small) = if claimed.quotient.is_some() { ("H", "h") } else { ("F", "f") };
    let mut lines = Vec::new();
    if let Some(quotient) = &claimed.quotient {
        let sides = [value("F", symbol_expr(variable)), polynomial_expr(quotient)];
        lines.push(line(chain(sides), Reason::Given));
    }
    let reason = if claimed.quotient.is_some() { Reason::SignOfQuotient } else { Reason::Given };
    lines.push(given(Expr::name(own), &univariate(polar(f), variable), reason));
    let shown = match claimed.strict {
        true => f.strict_positivity(a, b),
        false => f.positivity(a, b).map_err(RealRoot::Rational),
    };
    let shown = match shown {
        Ok(shown) => shown,
        Err(point) => {
            let number = match &point {
                RealRoot::Rational(q) => f.value(q),
                RealRoot::Irrational(_) => Rational::zero(),
            };
            let reason = if number.is_zero() { Reason::NotPositive } else { Reason::Negative };
            let at = value(own, Value::root(point, variable).to_expr());
            lines.push(line(chain([at, polynomial_expr(&Fraction::from(number))]), reason));
            return Derivation { title, lines, language: None };
        }
    };
    let strict = claimed.strict;
    let square = shown.root_of_square.degree() > Some(0);
    let (name, small) = if square { ("G", "g") } else { (own, own_small) };
    if square {
        let factors = [
            power(factor(grouped_expr(&formula(&shown.root_of_square))), 2),
            power(value("G", symbol_expr(variable)), 1),
        ];
        lines.push(given(Expr::name("G"), &univariate(polar(&shown.rest), variable), Reason::WithoutSquares));
        let product = Expr::sum(vec![term(&Fraction::one(), factors.into_iter().flatten().collect())]);
        lines.push(line(chain([value(own, symbol_expr(variable)), product]), Reason::SquareTimes));
    }
    let form = polar(&shown.rest);
    let n = form.degree();
    let x = fresh(&["x", "s", "u"], std::slice::from_ref(variable));
    let beyond = |tail: &Option<(Rational, Poly)>, up: bool| {
        let (c, p) = tail.as_ref().filter(|_| n > 0)?;
        let (from, step) = (Fraction::from(c.clone()), symbol(&x));
        let at = if up { from.plus(&step) } else { from.minus(&step) };
        let sides = [value(name, polynomial_expr(&at)), polynomial_expr(&Fraction::from(in_letter(p, &x)))];
        Some(line(chain(sides), Reason::NoneNegativeBeyond { end: c.clone(), up, strict }))
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
            let reason = Reason::NoneNegative { lower: lower.clone(), upper: upper.clone(), strict };
            lines.push(line(sequence(list.iter().enumerate().map(point).collect()), reason));
        }
    }
    lines.extend(beyond(&shown.above, true));
    if n == 0 {
        let constant = polynomial_expr(&formula(&shown.rest));
        let rel = if strict { Rel::Gt } else { Rel::Ge };
        lines.push(line(Expr::relation(constant, rel, Expr::int(0)), Reason::PositiveConstant { strict }));
    }
    Derivation { title, lines, language: None }
}

/// The same by the Bernstein coefficients of a higher degree over the whole interval: f_n(a^{n−i}, b^i) for the polar form f_n with n
/// arguments. `None` if one of them is negative, which says nothing.
///
/// Cost: n² additions.
pub fn positivity_by_elevation(
    f: &Poly,
    variable: &Symbol,
    interval: &Interval<Rational>,
    n: usize,
    strict: bool,
) -> Option<Derivation> {
    let form = PolarForm::new(f.coefficients().into_iter().map(Fraction::from).collect::<Vec<_>>());
    let (a, b) = interval.ends();
    let raised = form.elevate(n.checked_sub(form.degree())?);
    let ends = [a, b].map(|q| Fraction::from(q.clone()));
    let raised_over = Interval::new(ends[0].clone(), ends[1].clone()).ok()?;
    let list = raised.bezier_points(&raised_over);
    let numbers: Vec<Rational> = list.iter().map(Fraction::as_rational).collect::<Option<_>>()?;
    let positive_ends = [numbers.first(), numbers.last()].into_iter().flatten().all(Signed::is_positive);
    if numbers.iter().any(Signed::is_negative) || strict && !positive_ends {
        return None;
    }
    let name = || subscript("f", &[n]);
    let point = |(i, value): (usize, &Fraction)| {
        let arguments = [vec![ends[0].clone(); n - i], vec![ends[1].clone(); i]].concat();
        chain([call(name(), arguments.iter().map(polynomial_expr).collect()), polynomial_expr(value)])
    };
    let lines = vec![
        given(Expr::name("F"), &univariate(form, variable), Reason::Given),
        line(univariate(raised, variable).equation(name(), Notation::Grouped), Reason::WithArguments(n)),
        line(
            sequence(list.iter().enumerate().map(point).collect()),
            Reason::NoneNegative { lower: a.clone(), upper: b.clone(), strict },
        ),
    ];
    Some(Derivation { title: Title::Positivity.words(), lines, language: None })
}
