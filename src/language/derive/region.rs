//! Why a polynomial in two variables is not negative on a rectangle or triangle, or where it is negative.

use nalgebra::DMatrix;

use super::lines::{chain, factor, line, power, sequence, subscript, term};
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind};
use crate::language::value::{Derivation, Value, grouped_expr, polynomial_expr, symbol_expr};
use crate::math::curve::{Region, RegionFailure, RegionShown, indices, positivity_on};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::system::SystemError;
use num_traits::One;

/// F ≥ 0 on a region by Bernstein coefficients over parts of it, or by its critical points; or a value of F that is negative.
///
/// Cost: that of [`positivity_on`].
///
/// # Errors
/// Why it stays open.
pub fn positivity_over(
    f: &MultiPoly,
    unknowns: &[Symbol; 2],
    region: &Region,
) -> Result<Derivation, SystemError> {
    let formula = |p: &MultiPoly| Fraction::from(p.clone());
    let at = |name: &str, arguments: Vec<Expr>| Expr::apply(Expr::name(name), arguments);
    let letters = || unknowns.iter().map(symbol_expr).collect::<Vec<_>>();
    let title = Title::Positivity.words();
    let mut lines = vec![line(chain([at("F", letters()), polynomial_expr(&formula(f))]), Reason::Given)];
    let shown = match positivity_on(f, unknowns, region) {
        Ok(shown) => shown,
        Err(RegionFailure::Open(error)) => return Err(error),
        Err(RegionFailure::Negative(point)) => {
            let place = |s: &Symbol| unknowns.iter().position(|x| x == s).map(|k| point[k].clone());
            let value = polynomial_expr(&Fraction::from(f.value(&place)));
            let arguments = point.iter().map(Expr::number).collect();
            lines.push(line(chain([at("F", arguments), value]), Reason::Negative));
            return Ok(Derivation { title, lines, language: None });
        }
    };
    let square = shown.root_of_square.as_constant().is_none();
    let name = if square { "G" } else { "F" };
    if square {
        let g = chain([at("G", letters()), polynomial_expr(&formula(&shown.rest))]);
        lines.push(line(g, Reason::WithoutSquares));
        let factors =
            [power(factor(grouped_expr(&formula(&shown.root_of_square))), 2), power(at("G", letters()), 1)];
        let product = Expr::sum(vec![term(&Fraction::one(), factors.into_iter().flatten().collect())]);
        lines.push(line(chain([at("F", letters()), product]), Reason::SquareTimes));
    }
    match shown.shown {
        RegionShown::Coefficients(parts) => {
            for part in parts {
                let coefficients = match &part.region {
                    Region::Rectangle(..) => {
                        let (rows, columns) = (part.coefficients.len(), part.coefficients[0].len());
                        let entry = |i: usize, j: usize| Fraction::from(part.coefficients[i][j].clone());
                        let matrix = Value::Matrix(DMatrix::from_fn(rows, columns, entry)).to_expr();
                        chain([Expr::name("b"), matrix])
                    }
                    Region::Triangle(_) => {
                        let list = &part.coefficients[0];
                        let n = (0..).find(|n| (n + 1) * (n + 2) / 2 >= list.len()).unwrap_or(0);
                        let one = |(index, q): ([usize; 3], &Rational)| {
                            chain([subscript("b", &index), Expr::number(q)])
                        };
                        sequence(indices(n).into_iter().zip(list).map(one).collect())
                    }
                };
                lines.push(line(coefficients, Reason::NoneNegativeOver(corners(&part.region))));
            }
        }
        RegionShown::CriticalPoints(zeros) => {
            let g = formula(&shown.rest);
            lines.push(line(chain([at(name, letters()), polynomial_expr(&g)]), Reason::EdgesNotNegative));
            let slope = |x: &Symbol| {
                let slope = Expr::apply(Expr::name("diff"), vec![Expr::name(name), symbol_expr(x)]);
                chain([slope, polynomial_expr(&g.derivative(x))])
            };
            lines.push(line(sequence(unknowns.iter().map(slope).collect()), Reason::CriticalPoints));
            let point = |zero: &crate::math::system::RealZero| -> Expr {
                let coordinates = zero.coordinates.iter().zip(unknowns);
                Kind::List(coordinates.map(|(x, s)| Value::root(x.clone(), s).to_expr()).collect()).into()
            };
            let all: Expr = Kind::List(zeros.iter().map(point).collect()).into();
            let reason =
                if zeros.is_empty() { Reason::NoCriticalPoints } else { Reason::CriticalNotNegative };
            lines.push(line(all, reason));
        }
    }
    Ok(Derivation { title, lines, language: None })
}

/// A region in plain notation.
fn corners(region: &Region) -> String {
    let list = |numbers: &[Rational]| {
        let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
        format!("[{}]", numbers.join(", "))
    };
    match region {
        Region::Rectangle(u, v) => format!("`{}` x `{}`", list(u), list(v)),
        Region::Triangle(corners) => {
            let all: Vec<String> = corners.iter().map(|p| list(p)).collect();
            format!("`[{}]`", all.join(", "))
        }
    }
}
