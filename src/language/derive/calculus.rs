//! Derivatives by vector arguments, and elevation of the degree.

use num_traits::Zero;

use super::combine::left_out;
use super::lines::{
    call, chain, combination, derivative as primed, integer, line, ratio, sequence, subscript, symbol,
};
use super::polar::{given, univariate};
use super::words::{Reason, Title};
use crate::formula::{Accent, Expr, Kind};
use crate::language::value::{Derivation, Form, Line, Notation, grouped_expr, symbol_expr};
use crate::math::blossom::PolarForm;
use crate::math::curve::{BezierCurve, Point};
use crate::math::interval::Interval;
use crate::math::number::{Rational, binomial, factorial};
use crate::math::poly::{Fraction, Symbol};

/// F^{(k)}(t) = n!/(n−k)! f(t^{n−k}, 1̂^k), step by step, for F of degree at most n given by its
/// polar form f.
///
/// Cost: k + 1 values of f at arguments with one symbol.
pub fn derivative(form: &PolarForm<Fraction>, variable: &Symbol, k: usize) -> Derivation {
    let n = form.degree();
    let polar = univariate(form.clone(), variable);
    let t = symbol_expr(variable);
    let left = || Expr::apply(primed(Expr::name("F"), k), vec![t.clone()]);
    let mut lines = vec![
        given(Expr::name("F"), &polar, Reason::DegreeAtMost(n)),
        line(polar.equation(Expr::name("f"), Notation::Grouped), Reason::PolarFormOf("F")),
    ];
    let result = grouped_expr(&univariate(form.nth_derivative(k.min(n + 1)), variable).diagonal());
    let title = Title::Derivative(k).words();
    if k > n {
        lines.push(line(chain([left(), Expr::int(0)]), Reason::MoreHatsThanArguments { n, k }));
        return Derivation { title, lines, language: None };
    }
    let share = Fraction::from(Rational::new(factorial(n), factorial(n - k)));
    let with =
        |last: Vec<Expr>| call(Expr::name("f"), vec![t.clone(); n - k].into_iter().chain(last).collect());
    if k == 0 {
        lines.push(line(chain([left(), with(Vec::new()), result]), Reason::Diagonal));
        return Derivation { title, lines, language: None };
    }
    let hat: Expr = Kind::Accent(Accent::Hat, Box::new(Expr::int(1))).into();
    let hats = combination([(share.clone(), with(vec![hat; k]))]);
    lines.push(line(chain([left(), hats]), Reason::DerivativeByHats { n, k }));
    // (1 − 0)^k, multiplied out: j ones and k − j zeros with sign (−1)^{k−j} and weight C(k, j).
    let ends = |j: usize| [vec![Expr::int(1); j], vec![Expr::int(0); k - j]].concat();
    let weight = |j: usize| {
        let count = Fraction::from(Rational::from_integer(binomial(k, j)));
        if (k - j) % 2 == 1 { -count } else { count }
    };
    let inside = combination((0..=k).rev().map(|j| (weight(j), with(ends(j)))));
    lines.push(line(chain([left(), combination([(share.clone(), inside)])]), Reason::HatIsDifference));
    let value = |j: usize| {
        let mut arguments = vec![symbol(variable); n - k];
        arguments.extend(vec![integer(1); j]);
        arguments.extend(vec![integer(0); k - j]);
        // There are n arguments.
        form.value(&arguments).unwrap_or_else(|_| Fraction::zero())
    };
    for j in (0..=k).rev() {
        let sides = [with(ends(j)), grouped_expr(&value(j))];
        lines.push(line(chain(sides), Reason::ValueOfForm));
    }
    let inside = combination((0..=k).rev().map(|j| (weight(j), grouped_expr(&value(j)))));
    let numbers = combination([(share, inside)]);
    lines.push(line(chain([left(), numbers, result]), Reason::PutTogether));
    Derivation { title, lines, language: None }
}

/// b_{n,i}, control point i of the representation of degree n.
fn point_name(degree: usize, i: usize) -> Expr {
    subscript("b", &[degree, i])
}

/// b_{n+1,i} = i/(n+1) b_{n,i−1} + (1 − i/(n+1)) b_{n,i}, for all i.
fn raised_points(n: usize, values: &[Expr]) -> Vec<Line> {
    (0..=n + 1)
        .map(|i| {
            let weights = [ratio(i, n + 1), ratio(n + 1 - i, n + 1)];
            let names = [point_name(n, i.saturating_sub(1)), point_name(n, i.min(n))];
            let mean = combination(weights.into_iter().zip(names));
            line(chain([point_name(n + 1, i), mean, values[i].clone()]), Reason::RaisedPoint { i, n })
        })
        .collect()
}

/// The same polynomial with `by` more arguments: the means over all ways to leave out one, and
/// the Bézier points over [0, 1] of each degree.
///
/// Cost: that of writing out the forms.
pub fn elevation(form: &PolarForm<Fraction>, variable: &Symbol, by: usize) -> Derivation {
    let (n, polar) = (form.degree(), univariate(form.clone(), variable));
    let mut lines = vec![
        given(Expr::name("F"), &polar, Reason::DegreeAtMost(n)),
        line(polar.equation(Expr::name("f"), Notation::Grouped), Reason::PolarFormOf("F")),
    ];
    let size = n as u64 + by as u64 + 1;
    crate::budget::charge_terms(size.saturating_mul(by as u64));
    let points = |form: &PolarForm<Fraction>| form.bezier_points(&Interval::unit());
    let mut name = Expr::name("f");
    for degree in n..n + by {
        crate::budget::step();
        let (old, new) = (form.elevate(degree - n), univariate(form.elevate(degree + 1 - n), variable));
        let next = subscript("f", &[degree + 1]);
        let sides = [new.call(next.clone())]
            .into_iter()
            .chain(left_out(&name, &old, degree + 1, variable))
            .chain([new.body(Notation::Grouped)]);
        lines.push(line(chain(sides), Reason::LeaveOut { from: degree, to: degree + 1 }));
        name = next;
    }
    let start = points(form).into_iter().enumerate().map(|(i, point)| {
        let arguments = [vec![Expr::int(0); n - i], vec![Expr::int(1); i]].concat();
        let label = if n == 0 { grouped_expr(&point) } else { call(Expr::name("f"), arguments) };
        chain([point_name(n, i), label, grouped_expr(&point)])
    });
    lines.push(line(sequence(start.collect()), Reason::BezierPoints));
    for degree in n..n + by {
        let values: Vec<Expr> = points(&form.elevate(degree + 1 - n)).iter().map(grouped_expr).collect();
        lines.extend(raised_points(degree, &values));
    }
    Derivation { title: Title::Elevation(by).words(), lines, language: None }
}

/// The control points of the same curve with its degree raised by one, `by` times.
///
/// Cost: as [`BezierCurve::elevate`], for each degree.
pub fn elevation_of_curve(curve: &BezierCurve<Fraction>, form: Form, by: usize) -> Derivation {
    let n = curve.degree();
    crate::budget::charge_terms((n as u64 + by as u64 + 1).saturating_mul(by as u64));
    let expr = |point: &Point<Fraction>| form.plain(point.clone()).to_expr();
    let given = curve.points().iter().enumerate().map(|(i, point)| chain([point_name(n, i), expr(point)]));
    let mut lines = vec![line(sequence(given.collect()), Reason::ControlPoints)];
    for degree in n..n + by {
        crate::budget::step();
        let raised = curve.elevate(degree + 1 - n);
        lines.extend(raised_points(degree, &raised.points().iter().map(expr).collect::<Vec<_>>()));
    }
    Derivation { title: Title::Elevation(by).words(), lines, language: None }
}
