//! Piecewise polynomials near a parameter: where it lies decides which piece is meant.
//!
//! **Definition.** A value near a parameter t₀ is a formula that is right in a neighbourhood of t₀. Two piecewise
//! polynomials agree near t₀ if these formulas do; whether they agree everywhere is sampled by enough t₀.

use super::calls::unclear;
use super::{Bound, Evaluated, Model};
use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::page::object::Object;
use crate::judge::values::equality;
use crate::judge::written::names::{Head, bases};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::number::{Rational, integer};
use crate::math::poly::{Coefficients, Fraction, Index, Symbol};
use crate::math::ring::Ring;
use crate::math::spline::KnotVector;
use num_traits::Zero;

/// Generic knots have these numbers.
const KNOTS: std::ops::Range<i64> = -4..12;

impl Model {
    /// Whether piecewise polynomials are considered near a parameter.
    pub fn is_local(&self) -> bool {
        self.around.borrow().is_some()
    }

    /// The knot number j: the one that the page gives, the outer ones beyond them; else uneven ones, unless the notes
    /// define B-splines over the integers.
    pub fn knot(&self, j: i64) -> Rational {
        let given = &self.given_knots;
        if let (Some((_, first)), Some((_, last))) = (given.first_key_value(), given.last_key_value()) {
            let inner = given.range(..=j).next_back().map(|(_, knot)| knot);
            return inner.unwrap_or(if j < 0 { first } else { last }).clone();
        }
        self.record.borrow_mut().any_knots |= !self.uniform;
        const UNEVEN: [i64; 16] = [-9, -5, -4, -1, 0, 2, 3, 7, 8, 12, 15, 16, 20, 22, 27, 29];
        let uneven = usize::try_from(j - KNOTS.start).ok().and_then(|at| UNEVEN.get(at).copied());
        integer(match uneven {
            Some(knot) if !self.uniform => knot,
            _ if self.uniform => j,
            _ => 3 * j,
        })
    }

    /// The knots from one number to another; nothing if a sum over all B-splines goes beyond the given ones.
    pub(super) fn knots_between(&self, first: i64, last: i64) -> Option<Vec<Rational>> {
        let given = &self.given_knots;
        let known = given.contains_key(&first) && given.contains_key(&last);
        (known || !self.all_splines.get()).then(|| (first..=last).map(|j| self.knot(j)).collect())
    }

    /// The value of a sum over all B-splines on the given knots.
    pub(super) fn over_given_knots(&self, sum: &mut dyn FnMut(i64, i64) -> Evaluated) -> Option<Evaluated> {
        let (first, last) = (self.given_knots.first_key_value()?.0, self.given_knots.last_key_value()?.0);
        let outer = self.all_splines.replace(true);
        let result = sum(*first, *last);
        self.all_splines.set(outer);
        Some(result)
    }

    /// Whether the page gives the knots by number.
    pub fn has_given_knots(&self) -> bool {
        !self.given_knots.is_empty()
    }

    /// The generic knots, called by letters.
    pub fn knots(&self, letters: &[String]) -> Vec<(Symbol, Value)> {
        let named = |letter: &String| {
            let letter = Symbol::new(letter);
            KNOTS.map(move |j| (letter.numbered(j), Value::number(self.knot(j)))).collect::<Vec<_>>()
        };
        letters.iter().flat_map(named).collect()
    }

    /// A value at the parameter considered: its plain symbols are that parameter.
    pub(super) fn number_here(&self, x: &Fraction) -> Option<Rational> {
        if let Some(number) = x.as_rational() {
            return Some(number);
        }
        let around = self.around.borrow().clone()?;
        let at = |symbol: &Symbol| symbol.is_plain().then(|| around.clone());
        x.value(&at)
    }

    /// The knots of a B-spline: those that words give it, a part of all that they give, or those of its number.
    pub(super) fn knots_of(
        &self,
        machine: &mut Machine,
        object: &Object,
        head: &Head,
        bound: &Bound,
        degree: usize,
        expr: &Expr,
    ) -> Option<Result<Vec<Rational>, Diagnostic>> {
        if let Some(knots) = self.explicit_knots(machine, object, bound, degree) {
            return Some(Ok(knots));
        }
        let first = head.lower.first().and_then(|index| machine.eval(index).ok())?.as_int()?;
        // 0 (n + 1 times), too
        let number = |knot: &Expr| match &knot.kind {
            Kind::Brace(items, _) => {
                items.iter().any(|item| bases(item).is_empty() && item.kind != Kind::Ellipsis)
            }
            Kind::Ellipsis => false,
            _ => bases(knot).is_empty(),
        };
        if !object.knots.iter().any(number) {
            return self.knots_between(first, first + degree as i64 + 1).map(Ok);
        }
        // N_2 on all the knots 0, 0, 0, 1, 2, 2, 2
        let Some(all) = self.all_knots(machine, object, bound) else {
            return Some(Err(unclear("what the knots are", expr)));
        };
        let first = usize::try_from(first).ok()?;
        Some(Ok(all.get(first..first + degree + 2)?.to_vec()))
    }

    /// Knots as numbers: what has no value is the knot of its number.
    pub(super) fn numbered_knots(&self, knots: &[Value]) -> Option<Vec<Rational>> {
        let number = |knot: &Value| match knot.as_rational() {
            Some(knot) => Some(knot),
            None => match equality::symbols(knot).iter().collect::<Vec<_>>().as_slice() {
                [only] => match only.indices() {
                    [Index::Number(j)] => Some(self.knot(*j)),
                    _ => None,
                },
                _ => None,
            },
        };
        knots.iter().map(number).collect()
    }

    /// Evaluates with another parameter to be near to.
    pub(super) fn moved<T>(&self, around: Option<Rational>, work: impl FnOnce() -> T) -> T {
        let before = self.around.replace(around);
        let result = work();
        self.around.replace(before);
        result
    }

    /// Whether a condition holds near the parameter; `None` if that cannot be said.
    pub fn holds_here(&self, machine: &mut Machine, condition: &Expr) -> Option<bool> {
        if let Some(items) = condition.alternatives() {
            let held: Vec<Option<bool>> = items.iter().map(|item| self.holds_here(machine, item)).collect();
            return match held.contains(&Some(true)) {
                true => Some(true),
                false => (!held.contains(&None)).then_some(false),
            };
        }
        let Kind::Chain(left, links) = &condition.kind else { return None };
        let number = |machine: &mut Machine, expr: &Expr| match machine.eval(expr) {
            Ok(Value::Scalar(x)) => self.number_here(&x),
            _ => None,
        };
        let mut value = number(machine, left);
        let mut unknown = false;
        for link in links {
            if matches!(link.rel, Rel::In | Rel::NotIn) {
                let ([from, to], _) = interval(&link.expr)?;
                let (from, to) = (number(machine, from), number(machine, to));
                let value = value.as_ref()?;
                let outside = from.as_ref().is_some_and(|from| value < from)
                    || to.as_ref().is_some_and(|to| value > to);
                let known = outside || from.is_some() && to.is_some();
                return known.then_some(outside == (link.rel == Rel::NotIn));
            }
            let next = number(machine, &link.expr);
            match (&value, &next) {
                (Some(a), Some(b)) => {
                    let ok = match link.rel {
                        Rel::Lt => a < b,
                        Rel::Le => a <= b,
                        Rel::Gt => a > b,
                        Rel::Ge => a >= b,
                        Rel::Eq => a == b,
                        Rel::Ne => a != b,
                        _ => return None,
                    };
                    if !ok {
                        return Some(false);
                    }
                }
                _ => unknown = true,
            }
            value = next;
        }
        (!unknown).then_some(true)
    }

    /// Cases on where a parameter lies.
    pub(super) fn cases_here(
        &self,
        machine: &mut Machine,
        cases: &[(Expr, Option<Expr>)],
        expr: &Expr,
    ) -> Option<Evaluated> {
        for (value, condition) in cases {
            let relation = |condition: &&Expr| {
                matches!(condition.kind, Kind::Chain(..)) || condition.alternatives().is_some()
            };
            // "otherwise" in words
            let Some(condition) = condition.as_ref().filter(relation) else {
                return Some(machine.eval(value));
            };
            match self.holds_here(machine, condition) {
                Some(true) => return Some(machine.eval(value)),
                Some(false) => {}
                None => return Some(Err(unclear("when this case holds", expr))),
            }
        }
        Some(Err(unclear("which case holds", expr)))
    }

    /// The B-spline over knots near the parameter considered: a polynomial in it.
    pub(super) fn local_spline(
        &self,
        knots: &[Rational],
        x: &Fraction,
        expr: &Expr,
    ) -> Result<Fraction, Diagnostic> {
        let Some(at) = self.number_here(x) else {
            return Err(unclear("on which knot interval this B-spline is taken", expr));
        };
        let degree = knots.len().saturating_sub(2);
        let spline = KnotVector::new(degree, knots.to_vec()).and_then(|knots| knots.basis_function(0));
        let spline =
            spline.map_err(|error| Diagnostic::error(Code::Domain, error.to_string()).at(expr.span))?;
        // Where it jumps at the end of the domain it is what it is to the left.
        let jumps = |last: &Rational| degree > 0 && knots.iter().skip(1).all(|knot| knot == last);
        let ends = |last: &Rational| self.given_knots.values().all(|knot| knot <= last);
        let inside =
            spline.breaks().last().is_some_and(|last| at < *last || at == *last && jumps(last) && ends(last));
        Ok(match spline.locate(&at) {
            Ok(piece) if inside => {
                let piece = spline.pieces()[piece].iter().map(Fraction::from_rational);
                piece.collect::<Coefficients<Fraction>>().value(x)
            }
            _ => Fraction::zero(),
        })
    }

    /// An integral over numbers, piece by piece.
    pub(super) fn piecewise_integral(
        &self,
        machine: &mut Machine,
        lower: Option<&Expr>,
        upper: Option<&Expr>,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let Kind::Integral { body, variable, .. } = &expr.kind else { return None };
        let not = |what: &str| Some(Err(unclear(what, expr)));
        let knots: Vec<Rational> = self.breaks.iter().cloned().chain(KNOTS.map(|j| self.knot(j))).collect();
        // ∫ over ℝ: the integrand has to vanish beyond all knots.
        let infinite =
            |end: &Expr| end.has(&|part| matches!(&part.kind, Kind::Name(name) if name == "infty"));
        let whole = match (lower, upper) {
            (Some(set), None) => Head::of(set).is_some_and(|set| set.base == "R" && set.lower.is_empty()),
            (Some(lower), Some(upper)) => infinite(lower) && infinite(upper),
            _ => false,
        };
        let ends = match (lower, upper) {
            _ if whole => {
                let one = integer(1);
                [knots.iter().min().map(|end| end - &one), knots.iter().max().map(|end| end + &one)]
            }
            (Some(lower), Some(upper)) => [lower, upper].map(|end| match machine.eval(end) {
                Ok(Value::Scalar(x)) => x.as_rational(),
                _ => None,
            }),
            _ => return not("between which bounds this is integrated"),
        };
        let [Some(from), Some(to)] = ends else { return not("where the pieces of this integrand end") };
        let (least, most) = if from <= to { (from.clone(), to.clone()) } else { (to.clone(), from.clone()) };
        let mut breaks = knots;
        breaks.retain(|at| least < *at && *at < most);
        breaks.extend([least.clone(), most]);
        breaks.sort();
        breaks.dedup();
        let Kind::Name(name) = &variable.kind else {
            return not("in which variable this is integrated");
        };
        let own = [(Symbol::new(name), Value::symbol(Symbol::new(name)))];
        let mut piece = |ends: &[Rational]| {
            // The integrand first, near the middle of the piece; then a polynomial is integrated.
            let middle = (&ends[0] + &ends[1]) / integer(2);
            let integrand = self.moved(Some(middle.clone()), || {
                machine.with_locals(own.clone(), |machine| machine.eval(body))
            })?;
            if whole && (middle < &from + integer(1) || middle > &to - integer(1)) && !vanishes(&integrand) {
                return Err(unclear("what this integral over all numbers is", expr));
            }
            let integral = Kind::Integral {
                lower: Some(Box::new(Expr::number(&ends[0]))),
                upper: Some(Box::new(Expr::number(&ends[1]))),
                body: Box::new(integrand.to_expr()),
                variable: variable.clone(),
            };
            self.moved(None, || machine.eval(&Expr::new(integral, expr.span)))
        };
        let sum = breaks.windows(2).try_fold(None, |sum: Option<Value>, ends| {
            let value = piece(ends)?;
            Ok(Some(match sum {
                None => value,
                Some(sum) => arithmetic::add(sum, value).map_err(|error| error.at(expr.span))?,
            }))
        });
        let sum = match sum {
            Ok(sum) => sum.unwrap_or_else(|| Value::int(0)),
            Err(error) => return Some(Err(error)),
        };
        Some(if from <= to { Ok(sum) } else { arithmetic::negate(sum) })
    }
}

fn vanishes(value: &Value) -> bool {
    value.as_rational().is_some_and(|q| q.is_zero())
}
