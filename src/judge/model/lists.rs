//! Lists that belong to curves: knots, control points, weights; and the sums that they make.

use super::calls::each;
use super::{Bound, Evaluated, Model};
use crate::formula::{Expr, Kind};
use crate::judge::page::object::Object;
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

impl Model {
    /// The value of s = Σ d_i N_i, where N_i lives between the knots that belong to d_i.
    pub(super) fn by_supports(
        &self,
        machine: &mut Machine,
        object: &Object,
        bound: &Bound,
        degree: usize,
        x: &Fraction,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let index = index_of_support(object)?;
        let mut sum: Option<Value> = None;
        for i in SUPPORTS {
            let mut own = bound.clone();
            own.push((Symbol::new(&index), Value::int(i)));
            let knots = self.items(machine, &object.knots, &own, Some(degree + 2))?;
            let weight = match self.local_spline(&self.numbered_knots(&knots)?, x, expr) {
                Ok(weight) => weight,
                Err(error) => return Some(Err(error)),
            };
            if weight.is_zero() {
                continue;
            }
            let point = machine.with_locals(own, |machine| machine.eval(&object.points[0])).ok()?;
            let term = each(point, &|point| Ok(point.times(&weight))).ok()?;
            sum = Some(match sum {
                None => term,
                Some(sum) => arithmetic::add(sum, term).ok()?,
            });
        }
        sum.map(Ok)
    }

    /// The functions that the control points of a curve are multiplied by: those of the basis, or, with weights, the
    /// quotients w_i B_i / Σ w_j B_j.
    pub(super) fn weighted(
        &self,
        machine: &mut Machine,
        object: &Object,
        bound: &Bound,
        mut basis: Vec<Fraction>,
    ) -> Option<Vec<Fraction>> {
        if object.weights.is_empty() {
            return Some(basis);
        }
        let own = self.points(machine, &object.weights, bound, basis.len().checked_sub(1)?)?;
        for (function, own) in basis.iter_mut().zip(&own) {
            *function = function.times(own.as_scalar()?);
        }
        let sum = basis.iter().fold(Fraction::zero(), |sum, function| sum.plus(function));
        for function in &mut basis {
            let share = arithmetic::divide(Value::Scalar(function.clone()), Value::Scalar(sum.clone()));
            *function = share.ok()?.as_scalar()?.clone();
        }
        Some(basis)
    }

    /// How many items a list has, dots written out.
    pub(super) fn count(&self, machine: &mut Machine, items: &[Expr], bound: &Bound) -> Option<usize> {
        self.items(machine, items, bound, None).map(|items| items.len())
    }

    /// The values of a list, dots written out; as many as are wanted.
    pub(super) fn items(
        &self,
        machine: &mut Machine,
        items: &[Expr],
        bound: &Bound,
        wanted: Option<usize>,
    ) -> Option<Vec<Value>> {
        let first = items.first()?;
        let work = |machine: &mut Machine| self.arguments(machine, items, wanted, first);
        let values = machine.with_locals(bound.clone(), work).ok()?;
        wanted.is_none_or(|wanted| values.len() == wanted).then_some(values)
    }

    /// The control points, or weights, of a curve of a degree.
    pub(super) fn points(
        &self,
        machine: &mut Machine,
        points: &[Expr],
        bound: &Bound,
        degree: usize,
    ) -> Option<Vec<Value>> {
        let first = points.first()?;
        // b_i stands for all of them.
        if let ([one], Some(head)) = (points, Head::of(first))
            && matches!(head.lower.as_slice(), [Expr { kind: Kind::Name(_), .. }])
        {
            let name = |i: usize| {
                let head = Head { lower: vec![Expr::int(i as i64)], ..head.clone() };
                self.symbol(machine, &head, one).map(Value::symbol).ok()
            };
            return (0..=degree).map(name).collect();
        }
        self.items(machine, points, bound, Some(degree + 1))
    }

    pub(super) fn nodes(
        &self,
        machine: &mut Machine,
        object: &Object,
        bound: &Bound,
    ) -> Option<Vec<Fraction>> {
        let nodes = self.items(machine, &object.knots, bound, None)?;
        nodes.iter().map(|node| node.as_scalar().cloned()).collect()
    }

    /// The knots that words give, if they are numbers.
    pub(in crate::judge) fn all_knots(
        &self,
        machine: &mut Machine,
        object: &Object,
        bound: &Bound,
    ) -> Option<Vec<Rational>> {
        let knots: Option<Vec<Rational>> =
            self.nodes(machine, object, bound)?.iter().map(Fraction::as_rational).collect();
        knots.filter(|knots| knots.windows(2).all(|ends| ends[0] <= ends[1]))
    }

    /// The knots of a B-spline, if they are said and are numbers.
    pub(in crate::judge) fn explicit_knots(
        &self,
        machine: &mut Machine,
        object: &Object,
        bound: &Bound,
        degree: usize,
    ) -> Option<Vec<Rational>> {
        let values = self.items(machine, &object.knots, bound, Some(degree + 2))?;
        values.iter().map(Value::as_rational).collect()
    }
}

/// The B-splines that are looked through for those that live at a parameter.
const SUPPORTS: std::ops::Range<i64> = -8..16;

/// The index in d_i and in its support from u_i to u_{i+4}.
pub(super) fn index_of_support(object: &Object) -> Option<String> {
    let ([point], [first, _, last]) = (object.points.as_slice(), object.knots.as_slice()) else {
        return None;
    };
    let head = Head::of(point)?;
    let Kind::Name(index) = &head.index()?.kind else { return None };
    let runs = |knot: &Expr| bases(knot).contains(index);
    (is_index_letter(index) && runs(first) && runs(last)).then(|| index.clone())
}

pub(super) fn combination(points: &[Value], weights: &[Fraction]) -> Evaluated {
    let mut sum: Option<Value> = None;
    for (point, weight) in points.iter().zip(weights) {
        let term = each(point.clone(), &|x| Ok(x.times(weight)))?;
        sum = Some(match sum {
            None => term,
            Some(sum) => arithmetic::add(sum, term)?,
        });
    }
    sum.ok_or_else(|| Diagnostic::error(Code::Empty, "no points"))
}
