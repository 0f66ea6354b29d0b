//! Formulas as on a board: grouped by the points they combine, or by the powers of their parameter.
//!
//! `(1 - t) b_0 + t b_1` is how a mean of points is written, and `t^2 - (a + b) t + a b` a polynomial
//! in t with letters as coefficients. Which symbol is a point and which the parameter, the formula
//! itself tells: points have indices and occur linearly, the parameter is the only letter t, u, x, ….

use num_traits::{One, Signed, Zero};

use super::factors::factors;
use super::to_expr::{
    exact_term, poly_terms, polynomial_expr, power_expr, symbol_expr, weighted as weighted_by,
};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::language::lexicon::roles;
use crate::math::poly::{Fraction, Index, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// Longer formulas are not grouped.
const MOST_TERMS: usize = 200;

/// The formula grouped, if something is gained; a polynomial of n terms takes some n divisions.
pub(super) fn grouped(f: &Fraction) -> Option<Expr> {
    let p = f.as_polynomial().filter(|p| (2..=MOST_TERMS).contains(&p.len()))?;
    let parameters: Vec<Symbol> =
        p.variables().iter().filter(|symbol| is_parameter(symbol)).cloned().collect();
    if parameters.is_empty() || parameters.len() == p.variables().len() {
        return None;
    }
    let main = match parameters.as_slice() {
        [one] => Some(one),
        _ => None,
    };
    if let Some(main) = main
        && p.degree_in(main) as usize > MOST_TERMS
    {
        return None;
    }
    if let Some(main) = main
        && p.coefficients_in(main).iter().all(|coefficient| coefficient.len() <= 1)
    {
        return Some(by_powers(p, main));
    }
    by_points(p, &parameters).or_else(|| main.map(|main| by_powers(p, main)))
}

/// By descending powers of a symbol, with their coefficients before them.
pub(super) fn by_powers(p: &MultiPoly, variable: &Symbol) -> Expr {
    let mut terms = Vec::new();
    for (k, coefficient) in p.coefficients_in(variable).iter().enumerate().rev() {
        let power = (k > 0).then(|| power_expr(variable, u32::try_from(k).unwrap_or(u32::MAX)));
        match power {
            Some(power) if !coefficient.is_zero() => terms.push(times(coefficient, power)),
            Some(_) => {}
            None => terms.extend(poly_terms(coefficient)),
        }
    }
    positive_first(&mut terms);
    Expr::sum(terms)
}

/// The polynomial with these coefficients by descending powers of variable - at; n^2 steps for
/// degree n.
pub fn in_powers_of(coefficients: &[Fraction], variable: &Symbol, at: &Fraction) -> Expr {
    let mut list = coefficients.to_vec();
    if !at.is_zero() {
        // Synthetic division by variable - at, again and again.
        for start in 0..list.len() {
            crate::budget::steps(u32::try_from(list.len()).unwrap_or(u32::MAX));
            for k in (start..list.len() - 1).rev() {
                let shift = list[k + 1].times(at);
                list[k] = list[k].plus(&shift);
            }
        }
    }
    let base = match at.is_zero() {
        true => symbol_expr(variable),
        false => polynomial_expr(&Fraction::from(MultiPoly::symbol(variable.clone())).minus(at)),
    };
    let mut terms = Vec::new();
    for (k, coefficient) in list.iter().enumerate().rev().filter(|(_, coefficient)| !coefficient.is_zero()) {
        let power = match k {
            0 => None,
            1 => Some(base.clone()),
            _ => Some(base.clone().power(Expr::int(k as i64))),
        };
        match (coefficient.as_polynomial(), power) {
            (Some(coefficient), Some(power)) => terms.push(times(coefficient, power)),
            (Some(coefficient), None) => terms.extend(poly_terms(coefficient)),
            (None, power) => terms.push(weighted_by(coefficient, power)),
        }
    }
    positive_first(&mut terms);
    Expr::sum(terms)
}

/// coefficient · body, with a factor that all terms of the coefficient have before the bracket.
pub(super) fn times(coefficient: &MultiPoly, body: Expr) -> Term {
    if let [only] = poly_terms(coefficient).as_slice() {
        let one = coefficient.as_constant().is_some_and(|c| c.abs().is_one());
        let mut product = if one { Vec::new() } else { factors_in(&only.expr) };
        product.push(body);
        return Term { sign: only.sign, expr: Expr::product(product) };
    }
    let negative = coefficient.terms(MonomialOrder::GrLex).iter().all(|(_, c)| c.is_negative());
    let content = if negative { -coefficient.content() } else { coefficient.content() };
    let inside = match content.is_zero() {
        true => coefficient.clone(),
        false => coefficient.scaled(&content.recip()),
    };
    exact_term(&content, vec![Expr::sum(poly_terms(&inside)), body])
}

/// As a combination of the points of one family, if each has a coefficient in factors t, 1 - t and
/// differences of letters.
fn by_points(p: &MultiPoly, parameters: &[Symbol]) -> Option<Expr> {
    let points = points_of(p)?;
    let mut terms = Vec::with_capacity(points.len());
    let mut gained = false;
    for point in &points {
        let weight = p.derivative(point);
        gained |= weight.len() > 1;
        terms.push(weighted(&weight, parameters, symbol_expr(point))?);
    }
    gained.then(|| Expr::sum(terms))
}

/// The indexed symbols of one letter in which a polynomial is linear and homogeneous, in the order of
/// their indices; `None` if there are no such letters, or several.
fn points_of(p: &MultiPoly) -> Option<Vec<Symbol>> {
    let terms = p.terms(MonomialOrder::Lex);
    let mut found: Vec<Vec<Symbol>> = Vec::new();
    for symbol in p.variables().iter().filter(|symbol| !symbol.indices().is_empty()) {
        match found.iter_mut().find(|family| family[0].base() == symbol.base()) {
            Some(family) => family.push(symbol.clone()),
            None => found.push(vec![symbol.clone()]),
        }
    }
    found.retain(|family| {
        let degree = |powers: &[(Symbol, u32)]| -> u32 {
            powers.iter().filter(|(symbol, _)| family.contains(symbol)).map(|(_, e)| e).sum()
        };
        family.len() > 1 && terms.iter().all(|(powers, _)| degree(powers) == 1)
    });
    let [family] = found.as_mut_slice() else { return None };
    family.sort_by_key(|symbol| {
        symbol.indices().iter().map(Index::to_string).map(|index| (index.len(), index)).collect::<Vec<_>>()
    });
    Some(std::mem::take(family))
}

/// weight · point with the weight in factors, which are symbols and differences.
fn weighted(weight: &MultiPoly, parameters: &[Symbol], point: Expr) -> Option<Term> {
    let mut rest = weight.clone();
    let mut brackets = Vec::new();
    for parameter in parameters {
        let opposite = MultiPoly::one().minus(&MultiPoly::symbol(parameter.clone()));
        let mut power = 0;
        while let Some(quotient) = rest.div_exact(&opposite).filter(|_| rest.as_constant().is_none()) {
            rest = quotient;
            power += 1;
        }
        if power > 0 {
            brackets.push((opposite, power));
        }
    }
    let parts = factors(&rest);
    let mut product = Vec::new();
    let difference = |factor: &MultiPoly| {
        let terms = factor.terms(MonomialOrder::GrLex);
        terms.len() == 2 && terms.iter().all(|(_, c)| c.abs().is_one()) && terms[0].1 != terms[1].1
    };
    for (factor, power) in parts.powers.iter().chain(&brackets) {
        match factor.variables() {
            [symbol] if factor.len() == 1 => product.push(power_expr(symbol, *power)),
            _ if difference(factor) => {
                let base = Expr::sum(poly_terms(factor));
                product.push(if *power == 1 { base } else { base.power(Expr::int(i64::from(*power))) });
            }
            _ => return None,
        }
    }
    product.push(point);
    Some(exact_term(&parts.constant, product))
}

/// Whether a symbol is the letter of a parameter.
fn is_parameter(symbol: &Symbol) -> bool {
    symbol.is_plain() && roles::is_parameter(symbol.base())
}

/// The factors of a product, or the one factor that a formula is.
fn factors_in(expr: &Expr) -> Vec<Expr> {
    match &expr.kind {
        Kind::Mul(factors) => factors.clone(),
        _ => vec![expr.clone()],
    }
}

/// 1 - t rather than -t + 1.
fn positive_first(terms: &mut [Term]) {
    if let [Term { sign: Sign::Minus, .. }, Term { sign: Sign::Plus, .. }] = terms {
        terms.swap(0, 1);
    }
}
