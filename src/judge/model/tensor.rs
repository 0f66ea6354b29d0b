//! Polar forms of surfaces with two groups of arguments.

use super::calls::{each, unclear, variable};
use super::objects::coefficients_in;
use super::{Evaluated, Model};
use crate::formula::Expr;
use crate::judge::names::{Head, capital_of};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::value::Value;
use crate::math::number::Rational;
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
        let (x, y) = (Symbol::new("\u{25e6}"), Symbol::new("\u{25e6}").numbered(2));
        let symbols = vec![Value::symbol(x.clone()), Value::symbol(y.clone())];
        let value = self.at_place(machine, of, symbols, expr)?;
        let (su, sv) = (means(&u), means(&v));
        each(value, &|formula| {
            let mut sum = Fraction::zero();
            for (i, row) in coefficients_in(&formula, &x, expr)?.iter().enumerate() {
                for (j, coefficient) in coefficients_in(row, &y, expr)?.iter().enumerate() {
                    if coefficient.is_zero() {
                        continue;
                    }
                    let (Some(a), Some(b)) = (su.get(i), sv.get(j)) else {
                        let message = format!("a surface of degree ({i}, {j}) has more arguments than these");
                        return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
                    };
                    sum = sum.plus(&coefficient.times(a).times(b));
                }
            }
            Ok(sum)
        })
    }
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
