//! Families with a standard meaning: Bernstein polynomials, elementary symmetric means, B-splines.

use super::calls::variable;
use super::{Ambiguity, Evaluated, Model};
use crate::formula::{Expr, Kind, Sign};
use crate::judge::page::object::Sort;
use crate::judge::values::compare;
use crate::judge::written::names::Head;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::lexicon::families::{self, Family};
use crate::language::ops::arithmetic;
use crate::language::ops::errors::polar_error;
use crate::language::value::Value;
use crate::math::number::integer;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

impl Model {
    /// A name whose meaning is standard without arguments: B_i^n as a function of t, A_n.
    pub(super) fn standard_name(&self, machine: &mut Machine, head: &Head, expr: &Expr) -> Option<Evaluated> {
        let variables: &[&str] = match head.notation()?.family {
            Family::Bernstein => &["t"],
            Family::Triangular => &["u", "v", "w"],
            _ => return None,
        };
        let at = variables.iter().map(|name| Value::symbol(Symbol::new(*name))).collect();
        self.family(machine, head, &[at], expr)
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
        let notation = head.notation()?;
        if notation.family == Family::Bernstein && self.context.is_own(&head.base, &self.place) {
            return None;
        }
        let (lower, upper) = (head.lower.as_slice(), head.upper.as_slice());
        let indices: Vec<&Expr> = lower.iter().chain(upper).collect();
        match (notation.family, indices.as_slice(), arguments.len()) {
            (Family::Bernstein, [i, n], 1) => {
                self.note(notation.meaning);
                let (mut i, mut n) = (*i, *n);
                if upper.is_empty() {
                    let said = self.context.letters.degree_first();
                    if said.is_none() {
                        self.ambiguous(Ambiguity::Bernstein);
                    }
                    if said.unwrap_or(self.choices.degree_first) {
                        (i, n) = (n, i);
                    }
                }
                let x = scalars?.swap_remove(0);
                // "The Bernstein polynomials over [a, b]"
                let x = match self.declared(head) {
                    Some((object, _)) if object.sort == Sort::Bernstein => {
                        self.reparametrised(machine, &object, &x)?
                    }
                    _ => x,
                };
                Some(self.bernstein(machine, n, i, &x))
            }
            (Family::Triangular, [i, j, k, n], 3) => {
                self.note(notation.meaning);
                Some(self.triangular(machine, n, [i, j, k], &scalars?))
            }
            // B_{ijk}^n(τ), where τ_1, τ_2, τ_3 are the coordinates of τ
            (Family::Triangular, [i, j, k, n], 1) => {
                self.note(notation.meaning);
                Some(self.triangular(machine, n, [i, j, k], &barycentric(&arguments[0])?))
            }
            (Family::SymmetricMean, [i, n, power @ ..], _) => {
                let at = scalars?;
                if power.iter().any(|power| !power.same_as(i)) {
                    return None;
                }
                Some(self.symmetric_mean(machine, i, n, &at, notation.meaning, expr))
            }
            // Of order k, if N_i^1 is where the recursion begins; of degree k, if N_i^0 is.
            (Family::Spline, [i, k], 1) => {
                let t = scalars?;
                Some(self.spline(machine, i, k, &t[0], notation.meaning, expr))
            }
            _ => None,
        }
    }

    /// B_i^n(x), whose parameter runs from 0 to 1.
    pub(super) fn bernstein_value(&self, degree: i64, i: i64, x: &Fraction) -> Fraction {
        self.record.borrow_mut().unit = true;
        families::bernstein(degree, i, x)
    }

    fn bernstein(&self, machine: &mut Machine, n: &Expr, i: &Expr, t: &Fraction) -> Evaluated {
        let (n, i) = (machine.eval_int(n)?, machine.eval_int(i)?);
        Ok(Value::Scalar(self.bernstein_value(n, i, t)))
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
        self.record.borrow_mut().unit = true;
        Ok(Value::Scalar(families::triangular(&parts, at)))
    }

    fn symmetric_mean(
        &self,
        machine: &mut Machine,
        i: &Expr,
        n: &Expr,
        at: &[Fraction],
        meaning: &str,
        expr: &Expr,
    ) -> Evaluated {
        // σ_{i,n-i}: the mean of products of i arguments and n − i complements
        let complement = matches!(&n.kind, Kind::Add(terms)
            if terms.len() == 2 && terms[1].sign == Sign::Minus && terms[1].expr.same_as(i));
        let (i, second) = (machine.eval_int(i)?, machine.eval_int(n)?);
        let n = if complement { i + second } else { second };
        if n != at.len() as i64 {
            let message = format!("a symmetric mean of {n} arguments is given {}", at.len());
            return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
        }
        let Some(i) = usize::try_from(i).ok().filter(|&i| i <= at.len()) else {
            return Ok(Value::int(0));
        };
        let mean = if complement {
            self.note("sigma_{i,n-i} is the mean of the products of i arguments and n-i complements 1-t_j");
            families::complementary_mean(i, at)
        } else {
            self.note(meaning);
            families::symmetric_mean(i, at)
        };
        mean.map(Value::Scalar).map_err(polar_error)
    }

    /// N_i^k between the knots t_m and t_{m+1}, by the recursion of de Boor, Cox and Mansfield.
    fn spline(
        &self,
        machine: &mut Machine,
        i: &Expr,
        k: &Expr,
        t: &Fraction,
        meaning: &str,
        expr: &Expr,
    ) -> Evaluated {
        let said = self.context.spline_has_this_degree(k, &self.place);
        if said.is_none() {
            self.ambiguous(Ambiguity::Spline);
        }
        let (i, k) = (machine.eval_int(i)?, machine.eval_int(k)?);
        let order = if said.unwrap_or(self.choices.spline_degree) { k + 1 } else { k };
        self.note(meaning);
        if order < 1 {
            return Err(Diagnostic::error(Code::Domain, "a B-spline of order 0").at(expr.span));
        }
        let Some(knots) = self.knots_between(i, i + order) else { return Ok(Value::int(0)) };
        self.local_spline(&knots, t, expr).map(Value::Scalar)
    }
}

/// The barycentric coordinates of a point: those that it has, or τ_1, τ_2, τ_3 of an unknown τ.
fn barycentric(point: &Value) -> Option<Vec<Fraction>> {
    if let Value::Scalar(_) = point {
        let symbols = compare::symbols(point);
        let [symbol] = symbols.as_slice() else { return None };
        let unknown = symbol.is_plain() && *point == Value::symbol(symbol.clone());
        return unknown.then(|| (1..=3).map(|i| variable(symbol.numbered(i))).collect());
    }
    let own = point.clone().coordinates().filter(|own| own.len() == 3)?;
    own.iter().map(|value| value.as_scalar().cloned()).collect()
}

/// The value of the Lagrange polynomial with number `i` of nodes.
pub(super) fn lagrange(nodes: &[Fraction], i: usize, x: &Fraction) -> Result<Fraction, Diagnostic> {
    let mut product = Fraction::from_rational(&integer(1));
    for (_, node) in nodes.iter().enumerate().filter(|(j, _)| *j != i) {
        let above = Value::Scalar(x.minus(node));
        match arithmetic::divide(above, Value::Scalar(nodes[i].minus(node)))? {
            Value::Scalar(factor) => product = product.times(&factor),
            _ => return Ok(Fraction::zero()),
        }
    }
    Ok(product)
}
