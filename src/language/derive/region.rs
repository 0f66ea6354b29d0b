//! Why a polynomial is not negative on a rectangle or triangle, a box or tetrahedron, or where it is negative.

use nalgebra::DMatrix;

use super::lines::{chain, factor, line, power, sequence, subscript, term};
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind};
use crate::language::value::{Derivation, Line, Value, grouped_expr, polynomial_expr, symbol_expr};
use crate::math::curve::{Region, RegionFailure, RegionPart, RegionShown, positivity_on};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::system::{RealZero, SystemError};
use num_traits::One;

/// F ≥ 0 on a region by Bernstein coefficients over parts of it, or by its critical points; or a value of F that is negative.
///
/// Cost: that of [`positivity_on`].
///
/// # Errors
/// Why it stays open.
pub fn positivity_over(
    f: &MultiPoly,
    unknowns: &[Symbol],
    region: &Region,
) -> Result<Derivation, SystemError> {
    let title = Title::Positivity.words();
    let mut lines =
        vec![line(chain([at("F", letters(unknowns)), polynomial_expr(&formula(f))]), Reason::Given)];
    let shown = match positivity_on(f, unknowns, region) {
        Ok(shown) => shown,
        Err(RegionFailure::Open(error)) => return Err(error),
        Err(RegionFailure::Negative(point)) => {
            lines.push(negative_value(f, unknowns, &point));
            return Ok(Derivation { title, lines, language: None });
        }
    };
    let name = without_squares(&mut lines, &shown.root_of_square, &shown.rest, unknowns);
    match shown.shown {
        RegionShown::Coefficients(parts) => {
            lines.extend(
                parts
                    .iter()
                    .map(|part| line(coefficients(part), Reason::NoneNegativeOver(place(&part.region)))),
            );
        }
        RegionShown::CriticalPoints(zeros) => {
            let boundary =
                if unknowns.len() == 2 { Reason::EdgesNotNegative } else { Reason::FacesNotNegative };
            critical(&mut lines, name, &shown.rest, unknowns, &zeros, boundary);
        }
    }
    Ok(Derivation { title, lines, language: None })
}

/// The coefficients of a part: a matrix over a rectangle, else one after the other.
fn coefficients(part: &RegionPart) -> Expr {
    let list = &part.coefficients;
    match &part.region {
        Region::Box(ends) if ends.len() == 2 => {
            let columns = list.iter().take_while(|(index, _)| index[0] == 0).count();
            let numbers = list.iter().map(|(_, c)| Fraction::from(c.clone()));
            let matrix = DMatrix::from_row_iterator(list.len() / columns, columns, numbers);
            chain([Expr::name("b"), Value::Matrix(matrix).to_expr()])
        }
        _ => {
            let one = |(index, q): &(Vec<usize>, Rational)| chain([subscript("b", index), Expr::number(q)]);
            sequence(list.iter().map(one).collect())
        }
    }
}

fn formula(p: &MultiPoly) -> Fraction {
    Fraction::from(p.clone())
}

fn at(name: &str, arguments: Vec<Expr>) -> Expr {
    Expr::apply(Expr::name(name), arguments)
}

fn letters(unknowns: &[Symbol]) -> Vec<Expr> {
    unknowns.iter().map(symbol_expr).collect()
}

fn negative_value(f: &MultiPoly, unknowns: &[Symbol], point: &[Rational]) -> Line {
    let place = |s: &Symbol| unknowns.iter().position(|x| x == s).map(|k| point[k].clone());
    let value = polynomial_expr(&Fraction::from(f.value(&place)));
    line(chain([at("F", point.iter().map(Expr::number).collect()), value]), Reason::Negative)
}

/// G and F = S² G, if S is no number; the name of what is left.
fn without_squares(
    lines: &mut Vec<Line>,
    root: &MultiPoly,
    rest: &MultiPoly,
    unknowns: &[Symbol],
) -> &'static str {
    if root.as_constant().is_some() {
        return "F";
    }
    let g = chain([at("G", letters(unknowns)), polynomial_expr(&formula(rest))]);
    lines.push(line(g, Reason::WithoutSquares));
    let factors = [power(factor(grouped_expr(&formula(root))), 2), power(at("G", letters(unknowns)), 1)];
    let product = Expr::sum(vec![term(&Fraction::one(), factors.into_iter().flatten().collect())]);
    lines.push(line(chain([at("F", letters(unknowns)), product]), Reason::SquareTimes));
    "G"
}

/// The boundary, the derivatives and their common zeros.
fn critical(
    lines: &mut Vec<Line>,
    name: &str,
    rest: &MultiPoly,
    unknowns: &[Symbol],
    zeros: &[RealZero],
    boundary: Reason,
) {
    let g = formula(rest);
    lines.push(line(chain([at(name, letters(unknowns)), polynomial_expr(&g)]), boundary));
    let slope = |x: &Symbol| {
        let slope = Expr::apply(Expr::name("diff"), vec![Expr::name(name), symbol_expr(x)]);
        chain([slope, polynomial_expr(&g.derivative(x))])
    };
    lines.push(line(sequence(unknowns.iter().map(slope).collect()), Reason::CriticalPoints));
    let point = |zero: &RealZero| -> Expr {
        let coordinates = zero.coordinates.iter().zip(unknowns);
        Kind::List(coordinates.map(|(x, s)| Value::root(x.clone(), s).to_expr()).collect()).into()
    };
    let all: Expr = Kind::List(zeros.iter().map(point).collect()).into();
    let reason = if zeros.is_empty() { Reason::NoCriticalPoints } else { Reason::CriticalNotNegative };
    lines.push(line(all, reason));
}

/// Numbers in plain notation.
fn list(numbers: &[Rational]) -> String {
    let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
    format!("[{}]", numbers.join(", "))
}

/// A region in plain notation.
fn place(region: &Region) -> String {
    match region {
        Region::Box(ends) => {
            ends.iter().map(|ends| format!("`{}`", list(ends))).collect::<Vec<_>>().join(" x ")
        }
        Region::Simplex(corners) => {
            let all: Vec<String> = corners.iter().map(|p| list(p)).collect();
            format!("`[{}]`", all.join(", "))
        }
    }
}
