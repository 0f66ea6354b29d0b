//! A multirational blossom, by its coefficients or by divided differences.

use super::lines::{chain, combination, derivative, integer, line, power, sequence, subscript, symbol, term};
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::language::value::{Derivation, Line, polynomial_expr};
use crate::math::blossom::{MultirationalError, multirational, rational_antiderivative};
use crate::math::number::{Rational, binomial, factorial};
use crate::math::poly::{Fraction, MultiPoly, Symbol, horner};
use crate::math::ring::{Field, Ring};
use num_traits::One;

/// Differences of more nodes are not written one by one.
const MOST_NODES: usize = 5;

/// f(u_1, …, u_m / v_1, …, v_n) of F: for m ≥ n the powers t^k become coefficients of ∏ (1 + u_i x)/∏ (1 + v_j x); for m < n it is a divided
/// difference.
///
/// Cost: that of [`multirational`], and n²/2 differences of fractions.
///
/// # Errors
/// [`MultirationalError`].
pub fn multirational_steps(
    f: &Fraction,
    t: &Symbol,
    u: &[Fraction],
    v: &[Fraction],
) -> Result<Derivation, MultirationalError> {
    let list =
        |p: &MultiPoly| -> Vec<Fraction> { p.coefficients_in(t).into_iter().map(Fraction::from).collect() };
    let (above, below) = (list(f.numerator()), list(f.denominator()));
    let value = multirational(&above, &below, u, v)?;
    let at_t = |name: &str| Expr::apply(Expr::name(name), vec![polynomial_expr(&symbol(t))]);
    let mut lines = vec![line(chain([at_t("F"), polynomial_expr(f)]), Reason::Given)];
    let last = match u.len().checked_sub(v.len()) {
        Some(order) => by_powers(&mut lines, &above, &below, order, u, v),
        None => by_differences(&mut lines, (&above, &below), t, u, v)?,
    };
    let numbers =
        |list: &[Fraction]| -> Expr { Kind::List(list.iter().map(polynomial_expr).collect()).into() };
    let whole = Expr::apply(Expr::name("multirational"), vec![at_t("F"), numbers(u), numbers(v)]);
    lines.push(line(chain([whole, last, polynomial_expr(&value)]), Reason::PutTogether));
    Ok(Derivation { title: Title::Multirational.words(), lines, language: None })
}

/// ∏ (1 + s x) over some numbers.
fn product(list: &[Fraction], x: &Fraction) -> Fraction {
    list.iter().fold(Fraction::one(), |product, s| product.times(&Fraction::one().plus(&s.times(x))))
}

/// The coefficients e_k of the series, and Σ a_k e_k/C(d, k).
fn by_powers(
    lines: &mut Vec<Line>,
    above: &[Fraction],
    below: &[Fraction],
    order: usize,
    u: &[Fraction],
    v: &[Fraction],
) -> Expr {
    let used: Vec<Symbol> = u.iter().chain(v).flat_map(Fraction::variables).collect();
    let x = symbol(&super::lines::fresh(&["x", "z", "s"], &used));
    let quotient = |a: Expr, list: &[Fraction]| {
        if list.is_empty() { a } else { a.over(polynomial_expr(&product(list, &x))) }
    };
    let series = Expr::apply(Expr::name("E"), vec![polynomial_expr(&x)]);
    lines.push(line(
        chain([series, quotient(polynomial_expr(&product(u, &x)), v)]),
        Reason::SeriesOfArguments(order),
    ));
    // The value for t^k alone is e_k/C(d, k).
    let share = |k: usize| Rational::from_integer(binomial(order, k));
    let coefficient = |k: usize| {
        let power: Vec<Fraction> = (0..=k).map(|i| integer((i == k) as usize)).collect();
        let alone = multirational(&power, &[Fraction::one()], u, v).expect("its degree is at most the order");
        alone.scaled(&share(k))
    };
    let named = (0..=order).map(|k| chain([subscript("e", &[k]), polynomial_expr(&coefficient(k))]));
    lines.push(line(sequence(named.collect()), Reason::CoefficientsOfSeries(order)));
    let scale = below.first().and_then(Field::inverse).unwrap_or_else(Fraction::one);
    let terms = above
        .iter()
        .enumerate()
        .map(|(k, a)| (a.times(&scale).scaled(&share(k).recip()), subscript("e", &[k])));
    combination(terms)
}

/// G with G^{(k−1)} = (k − 1)! F, H = G ∏ (t − u_i), and its divided difference at the v_j.
fn by_differences(
    lines: &mut Vec<Line>,
    (above, below): (&[Fraction], &[Fraction]),
    t: &Symbol,
    u: &[Fraction],
    v: &[Fraction],
) -> Result<Expr, MultirationalError> {
    let order = v.len() - u.len();
    let at = |name: Expr, x: &Fraction| Expr::apply(name, vec![polynomial_expr(x)]);
    let letter = symbol(t);
    let polynomial = |list: &[Fraction]| horner(list, &letter);
    let (a, b) = rational_antiderivative(above, below, order - 1)?;
    let scale = Rational::from_integer(factorial(order - 1));
    let g = polynomial(&a).times(&polynomial(&b).inverse().ok_or(MultirationalError::Pole)?).scaled(&scale);
    if order > 1 {
        lines.push(line(
            chain([at(Expr::name("G"), &letter), polynomial_expr(&g)]),
            Reason::RationalAntiderivative,
        ));
        let right = Expr::sum(vec![term(&Fraction::from(scale), vec![at(Expr::name("F"), &letter)])]);
        lines.push(line(
            chain([at(derivative(Expr::name("G"), order - 1), &letter), right]),
            Reason::DerivativeIs(order - 1),
        ));
    }
    let first = if order > 1 { "G" } else { "F" };
    let factors = u.iter().map(|x| letter.minus(x));
    let h = factors.clone().fold(g, |h, factor| h.times(&factor));
    let written = factors.map(|f| power(super::lines::factor(polynomial_expr(&f)), 1));
    let sides = std::iter::once(Some(at(Expr::name(first), &letter))).chain(written).flatten().collect();
    let product = Expr::sum(vec![Term { sign: Sign::Plus, expr: Expr::product(sides) }]);
    lines.push(line(
        chain([at(Expr::name("H"), &letter), product, polynomial_expr(&h)]),
        Reason::FactorsOfArguments,
    ));
    let name = |nodes: &[Fraction]| -> Expr {
        match nodes {
            [x] => at(Expr::name("H"), x),
            _ => {
                let list = Kind::List(nodes.iter().map(polynomial_expr).collect()).into();
                Expr::product(vec![Expr::name("H"), list])
            }
        }
    };
    let distinct = (0..v.len()).all(|i| (0..i).all(|j| v[i] != v[j]));
    if distinct && v.len() <= MOST_NODES {
        let value =
            |x: &Fraction| h.substitute(&[(t.clone(), x.clone())]).map_err(|_| MultirationalError::Pole);
        let mut level: Vec<Fraction> = v.iter().map(value).collect::<Result<_, _>>()?;
        let values =
            v.iter().zip(&level).map(|(x, y)| chain([name(std::slice::from_ref(x)), polynomial_expr(y)]));
        lines.push(line(sequence(values.collect()), Reason::Data));
        for k in 1..v.len() {
            let next = |i: usize| {
                let inverse = v[i + k].minus(&v[i]).inverse().expect("the nodes differ");
                level[i + 1].minus(&level[i]).times(&inverse)
            };
            let next: Vec<Fraction> = (0..v.len() - k).map(next).collect();
            for (i, y) in next.iter().enumerate() {
                crate::budget::step();
                let minus = |a: Expr, b: Expr| {
                    Expr::sum(vec![Term { sign: Sign::Plus, expr: a }, Term { sign: Sign::Minus, expr: b }])
                };
                let quotient = minus(name(&v[i + 1..=i + k]), name(&v[i..i + k]))
                    .over(polynomial_expr(&v[i + k].minus(&v[i])));
                lines.push(line(
                    chain([name(&v[i..=i + k]), quotient, polynomial_expr(y)]),
                    Reason::DividedDifference(k),
                ));
            }
            level = next;
        }
    }
    Ok(name(v))
}
