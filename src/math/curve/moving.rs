//! Moving lines that follow a plane curve, and what they give: the equation and the parameter of a point.
//!
//! A moving line a(t) x + b(t) y + c(t) = 0 follows the curve (X/W, Y/W) if a X + b Y + c W = 0. Those that follow a curve of
//! degree n form a free module with a basis p, q of degrees μ and n − μ, where μ is the least degree (a μ-basis), and
//! Res_t(p, q) is the equation, to the power in which the curve is run through. Where the first subresultant A t + B of p and q
//! is not 0, t = −B/A is the parameter of the point (x, y).
//!
//! T. W. Sederberg, F. Chen, "Implicitization using moving curves and surfaces", SIGGRAPH 1995; D. Cox, T. W. Sederberg,
//! F. Chen, "The moving line ideal basis of planar rational curves", CAGD 15 (1998).

use nalgebra::DMatrix;
use num_traits::Zero;

use crate::budget;
use crate::math::linalg::{determinant, null_space, rank};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Poly, Symbol};

/// The coefficients a, b, c of a moving line.
pub type MovingLine = [Poly; 3];

/// A μ-basis of a curve with homogeneous coordinates X, Y, W, the line of lower degree first; `None` if the curve is a point.
///
/// Cost: null spaces of n matrices with 3 n columns at most.
///
/// ```
/// use polarform::curve::moving_lines;
/// use polarform::poly::Poly;
/// let t = Poly::variable();
/// let [p, q] = moving_lines(&[t.pow(2), t.pow(3), Poly::one()]).unwrap();
/// // y − t x and t² − x
/// assert_eq!(p.each_ref().map(|f| f.to_string()), ["-t", "1", "0"]);
/// assert_eq!(q.iter().filter_map(Poly::degree).max(), Some(2));
/// ```
pub fn moving_lines(curve: &[Poly; 3]) -> Option<[MovingLine; 2]> {
    let common = curve.iter().fold(Poly::zero(), |common, f| common.gcd(f));
    let curve = curve.each_ref().map(|f| f.div_exact(&common).unwrap_or_else(Poly::zero));
    let n = curve.iter().filter_map(Poly::degree).max().unwrap_or(0);
    if n == 0 {
        return None;
    }
    for degree in 0..=n / 2 {
        let found = of_degree(&curve, n, degree);
        if let [p, rest @ ..] = found.as_slice() {
            if let [q, ..] = rest {
                return Some([p.clone(), q.clone()]);
            }
            // Among those of degree n − μ, one that is no multiple of p.
            let coefficients = |line: &MovingLine, shift: usize| -> Vec<Rational> {
                let one = |f: &Poly| {
                    (0..=n - degree)
                        .map(|k| k.checked_sub(shift).map_or_else(Rational::zero, |k| f.coefficient(k)))
                        .collect::<Vec<_>>()
                };
                line.iter().flat_map(one).collect()
            };
            let multiples: Vec<Vec<Rational>> =
                (0..=n - 2 * degree).map(|shift| coefficients(p, shift)).collect();
            let independent = |q: &MovingLine| {
                let mut rows = multiples.clone();
                rows.push(coefficients(q, 0));
                rank(&DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j].clone())) == rows.len()
            };
            let q = of_degree(&curve, n, n - degree).into_iter().find(independent)?;
            return Some([p.clone(), q]);
        }
    }
    None
}

/// A basis of the moving lines of degree k at most.
fn of_degree(curve: &[Poly; 3], n: usize, k: usize) -> Vec<MovingLine> {
    budget::steps(1 + ((n + k) * k) as u32);
    let matrix = DMatrix::from_fn(n + k + 1, 3 * (k + 1), |i, j| {
        let (which, power) = (j / (k + 1), j % (k + 1));
        i.checked_sub(power).map_or_else(Rational::zero, |i| curve[which].coefficient(i))
    });
    let basis = null_space(&matrix);
    let line = |column: usize| -> MovingLine {
        let list: Vec<Rational> = basis.column(column).iter().cloned().collect();
        let scale = list
            .iter()
            .fold(crate::math::number::Int::ONE, |scale, q| num_integer::Integer::lcm(&scale, q.denom()));
        let content = list.iter().fold(crate::math::number::Int::ZERO, |content, q| {
            num_integer::Integer::gcd(&content, &(q.numer() * &scale.div_exact(q.denom())))
        });
        let scale = Rational::new(scale, content);
        std::array::from_fn(|which| {
            list[which * (k + 1)..(which + 1) * (k + 1)].iter().map(|q| q * &scale).collect()
        })
    };
    (0..basis.ncols()).map(line).collect()
}

/// The parameter of the point (x, y) of a curve, as a fraction of polynomials in x and y; `None` if the curve is a point or is run
/// through several times.
///
/// Cost: a μ-basis, and two determinants of size n − 2 of polynomials that are linear in x and y.
///
/// ```
/// use polarform::curve::inversion_formula;
/// use polarform::poly::{Poly, Symbol};
/// let t = Poly::variable();
/// let [x, y] = ["x", "y"].map(Symbol::new);
/// let found = inversion_formula(&[t.pow(2), t.pow(3), Poly::one()], [&x, &y]).unwrap();
/// assert_eq!(found.to_string(), "y/x");
/// ```
pub fn inversion_formula(curve: &[Poly; 3], symbols: [&Symbol; 2]) -> Option<Fraction> {
    let [p, q] = moving_lines(curve)?;
    let coordinates = symbols.map(|s| MultiPoly::symbol(s.clone()));
    let columns = |line: &MovingLine| -> Vec<Fraction> {
        let degree = line.iter().filter_map(Poly::degree).max().unwrap_or(0);
        (0..=degree)
            .map(|k| {
                let [a, b, c] = line.each_ref().map(|f| MultiPoly::constant(f.coefficient(k)));
                Fraction::from(a * coordinates[0].clone() + b * coordinates[1].clone() + c)
            })
            .collect()
    };
    let (f, g) = (columns(&p), columns(&q));
    let (m, n) = (f.len() - 1, g.len() - 1);
    let (a, b) = match (m, n) {
        // A line: q alone depends on t.
        (0, 1) | (_, 1) => (g[1].clone(), g[0].clone()),
        (1, _) => (f[1].clone(), f[0].clone()),
        (0, _) => return None,
        _ => {
            let size = m + n - 2;
            let entry = |row: usize, power: usize| {
                let (list, shift) = if row + 1 < n { (&f, n - 2 - row) } else { (&g, m + n - 3 - row) };
                power.checked_sub(shift).and_then(|j| list.get(j)).cloned().unwrap_or_else(Fraction::zero)
            };
            let value = |last: usize| {
                let matrix = DMatrix::from_fn(size, size, |i, j| {
                    entry(i, if j + 1 == size { last } else { size - j })
                });
                determinant(&matrix).ok()
            };
            (value(1)?, value(0)?)
        }
    };
    if a.is_zero() {
        return None;
    }
    let found = -b / a;
    // Of a curve that is run through several times there is no such formula.
    let t = Symbol::new("t");
    let parameter = MultiPoly::symbol(t);
    let [x, y, w] = curve.each_ref().map(|f| Fraction::from(f.value_in(&parameter)));
    let at = [(symbols[0].clone(), x / w.clone()), (symbols[1].clone(), y / w)];
    (found.substitute(&at).ok()? == Fraction::from(parameter)).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::implicit_equation;
    use crate::math::number::integer;
    use proptest::prelude::*;

    fn poly(len: usize) -> impl Strategy<Value = Poly> {
        prop::collection::vec(-4i64..5, 0..len).prop_map(|list| list.into_iter().map(integer).collect())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// Both lines follow the curve, their degrees add up, and their resultant is the equation to a power.
        #[test]
        fn a_basis_gives_the_equation(x in poly(6), y in poly(6), w in poly(5)) {
            prop_assume!(!w.is_zero());
            let curve = [x, y, w];
            let Some(basis) = moving_lines(&curve) else {
                prop_assert!(implicit_equation(&lists(&curve), [&Symbol::new("x"), &Symbol::new("y")]).is_none());
                return Ok(());
            };
            let common = curve.iter().fold(Poly::zero(), |common, f| common.gcd(f));
            let n = curve.iter().filter_map(|f| f.div_exact(&common)).filter_map(|f| f.degree()).max().unwrap_or(0);
            let degree = |line: &MovingLine| line.iter().filter_map(Poly::degree).max().unwrap_or(0);
            prop_assert_eq!(degree(&basis[0]) + degree(&basis[1]), n);
            let [px, py, t] = ["x", "y", "t"].map(Symbol::new);
            let parameter = MultiPoly::symbol(t.clone());
            let written = basis.each_ref().map(|line| {
                let sum = line.iter().zip(&curve).fold(Poly::zero(), |sum, (a, b)| sum + a * b);
                assert!(sum.is_zero());
                let [a, b, c] = line.each_ref().map(|f| f.value_in(&parameter));
                a * MultiPoly::symbol(px.clone()) + b * MultiPoly::symbol(py.clone()) + c
            });
            let equation = implicit_equation(&lists(&curve), [&px, &py]).unwrap();
            let power = written[0].resultant(&written[1], &t);
            let mut rest = power.clone();
            let mut count = 0;
            while let Some(quotient) = rest.div_exact(&equation) {
                rest = quotient;
                count += 1;
            }
            prop_assert!(count > 0 && rest.as_constant().is_some_and(|c| !c.is_zero()));
            // The parameter is a function of the point if and only if the curve is run through once.
            let formula = inversion_formula(&curve, [&px, &py]);
            prop_assert_eq!(formula.is_some(), count == 1);
        }
    }

    fn lists(curve: &[Poly; 3]) -> [Vec<Fraction>; 3] {
        curve.each_ref().map(|f| f.coefficients().into_iter().map(Fraction::from).collect())
    }
}
