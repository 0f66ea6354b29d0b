//! Polar forms of surfaces: with two groups of arguments, and by the total degree at points of the plane.

use super::calls::{each, unclear, variable};
use super::objects::{PLACE, coefficients_in};
use super::{Evaluated, Model};
use crate::formula::Expr;
use crate::judge::written::names::{Head, capital_of};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::value::Value;
use crate::math::number::{Rational, integer, multinomial};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

impl Model {
    /// An unknown tensor-product form: symmetric and affine in each group.
    pub(super) fn tensor(&self, head: &Head, u: &[Value], v: &[Value], expr: &Expr) -> Evaluated {
        self.record.borrow_mut().unknown.insert(capital_of(&head.base));
        let scalars = |values: &[Value]| -> Option<Vec<Fraction>> {
            values.iter().map(|value| value.as_scalar().cloned()).collect()
        };
        let (Some(u), Some(v)) = (scalars(u), scalars(v)) else {
            return Err(unclear("what these arguments are", expr));
        };
        let name = Symbol::new(format!("[{}]", capital_of(&head.base)));
        let (su, sv) = (means(&u), means(&v));
        let mut sum = Fraction::zero();
        for (i, a) in su.iter().enumerate() {
            for (j, b) in sv.iter().enumerate() {
                sum = sum.plus(&variable(name.numbered(i as i64).numbered(j as i64)).times(a).times(b));
            }
        }
        Ok(Value::Scalar(sum))
    }

    /// The polar form of a surface F(u, v) in each of its variables: u^i v^j becomes the product of two means.
    pub(super) fn tensor_of(
        &self,
        machine: &mut Machine,
        of: &Expr,
        u: &[Value],
        v: &[Value],
        expr: &Expr,
    ) -> Evaluated {
        let scalars = |values: &[Value]| -> Option<Vec<Fraction>> {
            values.iter().map(|value| value.as_scalar().cloned()).collect()
        };
        let (Some(u), Some(v)) = (scalars(u), scalars(v)) else {
            return Err(unclear("what these arguments are", expr));
        };
        let (x, y) = (Symbol::new(PLACE), Symbol::new(PLACE).numbered(2));
        let symbols = vec![Value::symbol(x.clone()), Value::symbol(y.clone())];
        let value = self.at_place(machine, of, symbols, expr)?;
        let (su, sv) = (means(&u), means(&v));
        each(value, &|formula| {
            sum_of_powers(&formula, [&x, &y], expr, &|i, j| match (su.get(i), sv.get(j)) {
                (Some(a), Some(b)) => Ok(a.times(b)),
                _ => Err(format!("a surface of degree ({i}, {j}) has more arguments than these")),
            })
        })
    }

    /// The value of the polar form of a polynomial in two variables, by its total degree, at points of the plane:
    /// the product of the sums 1 + x u_k + y v_k has the symmetric functions as coefficients.
    pub(super) fn total_polar_value(
        &self,
        machine: &mut Machine,
        of: &Expr,
        points: &[(Fraction, Fraction)],
        expr: &Expr,
    ) -> Evaluated {
        let (x, y) = (Symbol::new(PLACE), Symbol::new(PLACE).numbered(2));
        let symbols = vec![Value::symbol(x.clone()), Value::symbol(y.clone())];
        let value = self.at_place(machine, of, symbols, expr)?;
        let n = points.len();
        let mut table = vec![vec![Fraction::zero(); n + 1]; n + 1];
        table[0][0] = Fraction::from_rational(&integer(1));
        for (u, v) in points {
            for i in (0..=n).rev() {
                for j in (0..=n).rev() {
                    let left = if i > 0 { table[i - 1][j].times(u) } else { Fraction::zero() };
                    let below = if j > 0 { table[i][j - 1].times(v) } else { Fraction::zero() };
                    table[i][j] = table[i][j].plus(&left).plus(&below);
                }
            }
        }
        each(value, &|formula| {
            sum_of_powers(&formula, [&x, &y], expr, &|i, j| {
                if i + j > n {
                    return Err(format!(
                        "a polynomial of degree {} has no polar form with {n} arguments",
                        i + j
                    ));
                }
                let count = Rational::new(1.into(), multinomial(&[i, j, n - i - j]));
                Ok(table[i][j].scaled(&count))
            })
        })
    }
}

/// A polynomial in x and y with a value in place of each x^i y^j; an error says why there is none.
fn sum_of_powers(
    formula: &Fraction,
    [x, y]: [&Symbol; 2],
    expr: &Expr,
    value: &dyn Fn(usize, usize) -> Result<Fraction, String>,
) -> Result<Fraction, Diagnostic> {
    let mut sum = Fraction::zero();
    for (i, row) in coefficients_in(formula, x, expr)?.iter().enumerate() {
        for (j, coefficient) in coefficients_in(row, y, expr)?.iter().enumerate() {
            if !coefficient.is_zero() {
                let value =
                    value(i, j).map_err(|message| Diagnostic::error(Code::Arity, message).at(expr.span))?;
                sum = sum.plus(&coefficient.times(&value));
            }
        }
    }
    Ok(sum)
}

/// The means σ_{i,n} of the elementary symmetric functions, for all i.
fn means(values: &[Fraction]) -> Vec<Fraction> {
    let one = Fraction::from_rational(&Rational::from_integer(1.into()));
    let mut sums = vec![one];
    for value in values {
        let mut next = sums.clone();
        next.push(Fraction::zero());
        for (i, sum) in sums.iter().enumerate() {
            next[i + 1] = next[i + 1].plus(&sum.times(value));
        }
        sums = next;
    }
    let row = crate::math::number::binomial_row(values.len());
    sums.into_iter().zip(row).map(|(sum, count)| sum.scaled(&Rational::new(1.into(), count))).collect()
}
