//! Extreme values of polynomials and quotients in one variable over an interval.

use super::calls::unclear;
use super::{Evaluated, Model};
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::inequality::{Decision, Range, decide, interval};
use crate::language::eval::Machine;
use crate::language::ops::calculus::nth_derivative;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;

impl Model {
    /// max or min of f(t) for t in an interval, if it is taken at a rational place: f is nowhere larger.
    ///
    /// Cost: as for isolating the roots of f' and of f minus its extreme value.
    pub(super) fn extreme(
        &self,
        machine: &mut Machine,
        largest: bool,
        lower: &[Expr],
        body: &Expr,
        expr: &Expr,
    ) -> Evaluated {
        let not = || unclear("what this extreme value is", expr);
        let [condition] = lower else { return Err(not()) };
        let (variable, ends, open) = variable_in(condition).ok_or_else(not)?;
        let symbol = Symbol::new(variable);
        let own = [(symbol.clone(), Value::symbol(symbol.clone()))];
        let Value::Scalar(f) = machine.with_locals(own, |machine| machine.eval(body))? else {
            return Err(not());
        };
        if f.variables().iter().any(|other| *other != symbol) {
            return Err(not());
        }
        let mut number = |end: &Expr| machine.eval(end)?.as_rational().ok_or_else(not);
        let (a, b) = (number(ends[0])?, number(ends[1])?);
        let mut places: Vec<Rational> = [(&a, open[0]), (&b, open[1])]
            .into_iter()
            .filter(|(_, open)| !open)
            .map(|(end, _)| end.clone())
            .collect();
        let slope = nth_derivative(&f, &symbol, 1);
        let slope: Option<Poly> =
            slope.numerator().coefficients_in(&symbol).iter().map(MultiPoly::as_constant).collect();
        let roots = slope.and_then(|slope| slope.real_roots(Some(&a), Some(&b))).unwrap_or_default();
        places.extend(roots.into_iter().filter_map(|(root, _)| match root {
            RealRoot::Rational(q) if (q != a || !open[0]) && (q != b || !open[1]) => Some(q),
            _ => None,
        }));
        let value = |place: &Rational| f.value(&|name: &Symbol| (*name == symbol).then(|| place.clone()));
        let values = places.iter().filter_map(value);
        let best = if largest { values.max() } else { values.min() }.ok_or_else(not)?;
        let bound = Fraction::from_rational(&best);
        let over = if largest { bound.minus(&f) } else { f.minus(&bound) };
        let nowhere_beyond = match over.as_rational() {
            Some(_) => true,
            None => matches!(decide(&over, false, &Range::between(a, b)), Some(Decision::Holds)),
        };
        if nowhere_beyond { Ok(Value::number(best)) } else { Err(not()) }
    }
}

/// The variable of a ≤ t ≤ b or t ∈ [a, b], the ends, and whether they are left out.
fn variable_in(condition: &Expr) -> Option<(&str, [&Expr; 2], [bool; 2])> {
    let Kind::Chain(first, links) = &condition.kind else { return None };
    match (&first.kind, links.as_slice()) {
        (Kind::Name(name), [Link { rel: Rel::In, expr: set, .. }]) => {
            let (ends, open) = interval(set)?;
            Some((name, ends, open))
        }
        (
            _,
            [Link { rel: one @ (Rel::Le | Rel::Lt), expr: Expr { kind: Kind::Name(name), .. }, .. }, other],
        ) => {
            let open = [*one == Rel::Lt, other.rel == Rel::Lt];
            matches!(other.rel, Rel::Le | Rel::Lt).then_some((name, [first.as_ref(), &other.expr], open))
        }
        _ => None,
    }
}
