//! Families with a standard meaning: Bernstein polynomials, elementary symmetric means, B-splines.

use super::calls::unclear;
use super::polynomials::means;
use super::{Ambiguity, Evaluated, Model};
use crate::formula::{Expr, Kind, Sign};
use crate::judge::names::Head;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::value::Value;
use crate::math::number::{Rational, binomial, multinomial};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

impl Model {
    /// A name whose meaning is standard without arguments: B_i^n as a function of t, A_n.
    pub(super) fn standard_name(&self, machine: &mut Machine, head: &Head, expr: &Expr) -> Option<Evaluated> {
        match head.base.as_str() {
            "B" if head.lower.len() + head.upper.len() == 2 => {
                let t = vec![vec![Value::symbol(Symbol::new("t"))]];
                self.family(machine, head, &t, expr)
            }
            _ => None,
        }
    }

    /// The value of a member of a standard family.
    pub(super) fn family(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Option<Evaluated> {
        let [arguments] = values else { return None };
        let scalars: Option<Vec<Fraction>> =
            arguments.iter().map(|value| value.as_scalar().cloned()).collect();
        let (lower, upper) = (head.lower.as_slice(), head.upper.as_slice());
        match (head.base.as_str(), lower, upper, arguments.len()) {
            ("B", [i], [n], 1) => {
                self.note("B_i^n is the Bernstein polynomial");
                Some(self.bernstein(machine, n, i, &scalars?[0]))
            }
            ("B", [a, b], [], 1) => {
                self.note("B_{i,n} is the Bernstein polynomial");
                self.ambiguous(Ambiguity::Bernstein);
                let (i, n) = if self.choices.degree_first { (b, a) } else { (a, b) };
                Some(self.bernstein(machine, n, i, &scalars?[0]))
            }
            ("B", [i, j, k], [n], 3) => {
                self.note("B_{i,j,k}^n is the Bernstein polynomial of a triangle");
                Some(self.triangular(machine, n, [i, j, k], &scalars?))
            }
            ("sigma", [i, n], _, _) => {
                let powers = scalars?;
                // σ_{i,n-i}: the mean of products of i arguments and n − i complements
                let complement = matches!(&n.kind, Kind::Add(terms)
                    if terms.len() == 2 && terms[1].sign == Sign::Minus && terms[1].expr.same_as(i));
                if let [power] = upper
                    && !power.same_as(i)
                {
                    return None;
                }
                Some(self.symmetric_mean(machine, i, n, complement, &powers, expr))
            }
            // Of order k, if N_i^1 is where the recursion begins; of degree k, if N_i^0 is.
            ("N", [i], [k], 1) => {
                let t = scalars?;
                Some(self.spline(machine, i, k, &t[0], expr))
            }
            ("N", [i, k], [], 1) => {
                let t = scalars?;
                Some(self.spline(machine, i, k, &t[0], expr))
            }
            _ => None,
        }
    }

    fn bernstein(&self, machine: &mut Machine, n: &Expr, i: &Expr, t: &Fraction) -> Evaluated {
        let (n, i) = (machine.eval_int(n)?, machine.eval_int(i)?);
        if i < 0 || i > n {
            return Ok(Value::int(0));
        }
        crate::budget::charge_terms(n as u64);
        let one = one();
        let power =
            |base: &Fraction, exponent: i64| base.pow(exponent as i32).unwrap_or_else(|_| one.clone());
        let weight = Rational::from_integer(binomial(n as usize, i as usize));
        Ok(Value::Scalar(power(t, i).times(&power(&one.minus(t), n - i)).scaled(&weight)))
    }

    fn triangular(&self, machine: &mut Machine, n: &Expr, indices: [&Expr; 3], at: &[Fraction]) -> Evaluated {
        let n = machine.eval_int(n)?;
        let mut list = Vec::with_capacity(3);
        for index in indices {
            list.push(machine.eval_int(index)?);
        }
        if list.iter().any(|&i| i < 0) {
            return Ok(Value::int(0));
        }
        if list.iter().sum::<i64>() != n {
            return Err(Diagnostic::error(Code::Domain, "the indices do not add up to the degree"));
        }
        let parts: Vec<usize> = list.iter().map(|&i| i as usize).collect();
        let mut product = one().scaled(&Rational::from_integer(multinomial(&parts)));
        for (x, &i) in at.iter().zip(&list) {
            product = product.times(&x.pow(i as i32).unwrap_or_else(|_| one()));
        }
        Ok(Value::Scalar(product))
    }

    fn symmetric_mean(
        &self,
        machine: &mut Machine,
        i: &Expr,
        n: &Expr,
        complement: bool,
        at: &[Fraction],
        expr: &Expr,
    ) -> Evaluated {
        let (i, second) = (machine.eval_int(i)?, machine.eval_int(n)?);
        let n = if complement { i + second } else { second };
        if n != at.len() as i64 {
            let message = format!("a symmetric mean of {n} arguments is given {}", at.len());
            return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
        }
        if i < 0 || i > n {
            return Ok(Value::int(0));
        }
        let sigma = means(at);
        if !complement {
            self.note("sigma_{i,n} is the mean of the products of i of the n arguments");
            return Ok(Value::Scalar(sigma[i as usize].clone()));
        }
        self.note("sigma_{i,n-i} is the mean of the products of i arguments and n-i complements 1-t_j");
        // the polar form of t^i (1−t)^{n−i}
        let mut sum = Fraction::from(MultiPoly::zero());
        for j in 0..=(n - i) {
            let weight = Rational::from_integer(binomial((n - i) as usize, j as usize));
            let weight = if j % 2 == 0 { weight } else { -weight };
            sum = sum.plus(&sigma[(i + j) as usize].scaled(&weight));
        }
        Ok(Value::Scalar(sum))
    }

    /// N_i^k between the knots t_m and t_{m+1}, by the recursion of de Boor, Cox and Mansfield.
    fn spline(&self, machine: &mut Machine, i: &Expr, k: &Expr, t: &Fraction, expr: &Expr) -> Evaluated {
        // At a number the interval is the one it lies in.
        let number = t.as_rational();
        let own =
            number.as_ref().and_then(|t| (-4..20).find(|&m| self.knot(m) <= *t && *t < self.knot(m + 1)));
        let said = self.context.spline_has_degree(&self.place);
        if said.is_none() {
            self.ambiguous(Ambiguity::Spline);
        }
        let Some(interval) = own.or(self.interval) else {
            return Err(unclear("on which knot interval this B-spline is taken", expr));
        };
        let (i, k) = (machine.eval_int(i)?, machine.eval_int(k)?);
        let order = if said.unwrap_or(self.choices.spline_degree) { k + 1 } else { k };
        let knot = |j: i64| Fraction::from_rational(&self.knot(j));
        self.note("N_i^k is the B-spline with the knots t_i");
        spline_value(i, order, interval, t, &knot)
            .map(Value::Scalar)
            .ok_or_else(|| Diagnostic::error(Code::Domain, "a B-spline of order 0").at(expr.span))
    }
}

/// N_{i,order}(t) for t between knot m and m + 1; `None` for an order below 1.
fn spline_value(
    i: i64,
    order: i64,
    m: i64,
    t: &Fraction,
    knot: &dyn Fn(i64) -> Fraction,
) -> Option<Fraction> {
    if order < 1 {
        return None;
    }
    // Outside its support it is zero.
    if m < i || m >= i + order {
        return Some(Fraction::from(MultiPoly::zero()));
    }
    if order == 1 {
        return Some(one());
    }
    let left = spline_value(i, order - 1, m, t, knot)?;
    let right = spline_value(i + 1, order - 1, m, t, knot)?;
    let quotient =
        |a: Fraction, b: Fraction| a.times(&crate::math::ring::Field::inverse(&b).unwrap_or_else(one));
    let first = quotient(t.minus(&knot(i)), knot(i + order - 1).minus(&knot(i)));
    let second = quotient(knot(i + order).minus(t), knot(i + order).minus(&knot(i + 1)));
    Some(first.times(&left).plus(&second.times(&right)))
}

fn one() -> Fraction {
    Fraction::from_rational(&Rational::from_integer(1.into()))
}
