//! The matrix A_n from Bézier points to power coefficients, and its inverse.

use nalgebra::DMatrix;

use super::lines::{chain, combination, line, multiple, power, product, subscript};
use super::words::{Reason, Title};
use crate::budget;
use crate::formula::{Delimiter, Expr, Kind, Sign, Term};
use crate::language::lexicon::families;
use crate::language::value::{Derivation, Line};
use crate::math::basis::{bernstein_to_power, power_to_bernstein};
use crate::math::number::{Rational, binomial};
use crate::math::poly::Fraction;

fn t() -> Expr {
    Expr::name("t")
}

/// 1 − t
fn rest() -> Expr {
    let term = |sign, expr| Term { sign, expr };
    Expr::sum(vec![term(Sign::Plus, Expr::int(1)), term(Sign::Minus, t())])
}

/// B_i^n(t)
fn bernstein(i: usize, n: usize) -> Expr {
    Expr::apply(subscript(families::BERNSTEIN, &[i]).power(Expr::int(n as i64)), vec![t()])
}

/// c t^i (1 − t)^k
fn split(c: &Rational, i: usize, k: usize) -> Expr {
    let powers = [power(t(), i), power(rest().grouped(), k)];
    multiple(c, powers.into_iter().flatten().collect())
}

/// Without the brackets around all of it.
fn bare(expr: Expr) -> Expr {
    match expr.kind {
        Kind::Group(inner) => *inner,
        kind => kind.into(),
    }
}

fn matrix(entries: &DMatrix<Rational>) -> Expr {
    let rows = entries.row_iter().map(|row| row.iter().map(|q| Some(Expr::number(q))).collect());
    Kind::Matrix(rows.collect(), Delimiter::Paren).into()
}

fn column(items: impl IntoIterator<Item = Expr>) -> Expr {
    Kind::Matrix(items.into_iter().map(|item| vec![Some(item)]).collect(), Delimiter::Paren).into()
}

fn name(n: usize) -> Expr {
    subscript("A", &[n])
}

/// A column of coefficients as a polynomial by ascending powers.
fn ascending(coefficients: impl IntoIterator<Item = Rational>) -> Expr {
    combination(coefficients.into_iter().enumerate().map(|(i, c)| {
        let power = power(t(), i).unwrap_or_else(|| Expr::int(1));
        (Fraction::from(c), power)
    }))
}

/// A_n column by column: the binomial expansions of B_0^n, …, B_n^n.
///
/// Cost: (n + 1)² entries.
pub fn power_matrix(n: usize) -> Derivation {
    budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
    let entries = bernstein_to_power(n);
    let mut lines: Vec<Line> = (0..=n)
        .map(|j| {
            let product = bare(split(&Rational::from_integer(binomial(n, j)), j, n - j));
            let expansion = ascending(entries.column(j).iter().cloned());
            line(chain([bernstein(j, n), product, expansion]), Reason::BinomialExpansion { n, j })
        })
        .collect();
    lines.push(line(chain([name(n), matrix(&entries)]), Reason::ColumnsOfPowers(n)));
    let powers = (0..=n).map(|i| power(t(), i).unwrap_or_else(|| Expr::int(1)));
    let transposed: Expr = Kind::Transpose(Box::new(name(n))).into();
    let sides = [product(vec![transposed, column(powers)]), column((0..=n).map(|j| bernstein(j, n)))];
    lines.push(line(chain(sides), Reason::BasesByMatrix));
    Derivation { title: Title::PowerMatrix(n).words(), lines, language: None }
}

/// The inverse of A_n column by column: t^j (t + (1 − t))^{n−j} in the Bernstein basis.
///
/// Cost: (n + 1)² entries, and their product with those of A_n.
pub fn bernstein_matrix(n: usize) -> Derivation {
    budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1).saturating_mul(n as u64 + 1));
    let (forward, entries) = (bernstein_to_power(n), power_to_bernstein(n));
    let mut lines: Vec<Line> = (0..=n)
        .map(|j| {
            let plus = |expr| Term { sign: Sign::Plus, expr };
            let one = Expr::sum(vec![plus(t()), plus(rest().grouped())]).grouped();
            let whole = product([power(t(), j), power(one, n - j)].into_iter().flatten().collect());
            let left = power(t(), j).unwrap_or_else(|| Expr::int(1));
            let basis = (j..=n).map(|i| (Fraction::from(entries[(i, j)].clone()), bernstein(i, n)));
            let mut sides = vec![left];
            if j < n {
                let weight = |i: usize| Rational::from_integer(binomial(n - j, i - j));
                let expanded = (j..=n).map(|i| plus(split(&weight(i), i, n - i)));
                sides.extend([bare(whole), Expr::sum(expanded.collect())]);
            }
            sides.push(combination(basis));
            line(chain(sides), Reason::BinomialOfOne { n, j })
        })
        .collect();
    lines.push(line(chain([name(n), matrix(&forward)]), Reason::ColumnsOfPowers(n)));
    let inverse = name(n).power(Expr::int(-1));
    lines.push(line(chain([inverse.clone(), matrix(&entries)]), Reason::ColumnsOfBernstein(n)));
    let identity = DMatrix::from_fn(n + 1, n + 1, |i, j| Rational::from_integer(i64::from(i == j).into()));
    let product = product(vec![name(n), inverse]);
    lines.push(line(chain([product, matrix(&identity)]), Reason::Inverse));
    Derivation { title: Title::BernsteinMatrix(n).words(), lines, language: None }
}
