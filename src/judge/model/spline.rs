//! Splines of which the page says no more than their degree: polynomials on the knot intervals that meet smoothly.
//!
//! **Formula.** A spline of degree d with simple knots k_j is s(x) = Σ a_i x^i + Σ e_j (x - k_j)_+^d. The a_i and e_j are
//! any numbers, so that what holds for these symbols holds for each such spline. At a knot its value and its derivatives
//! below the d-th are those of the terms with the knots before it.

use super::calls::{unclear, variable};
use super::{Evaluated, Model};
use crate::formula::{Expr, Kind};
use crate::judge::page::context::{Body, Definition};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, walk};
use crate::language::eval::Machine;
use crate::language::value::Value;
use crate::math::number::integer;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

/// The knots that are tried.
const KNOTS: std::ops::Range<i64> = 0..10;

impl Model {
    /// The value of a spline at a knot, or at a number between knots that are numbers.
    pub(super) fn any_spline(
        &self,
        machine: &mut Machine,
        object: &Object,
        head: &Head,
        degree: usize,
        x: &Fraction,
        expr: &Expr,
    ) -> Evaluated {
        let letter = self.letter_of_knots(object, &head.base);
        let given: Option<Vec<Fraction>> = object
            .knots
            .iter()
            .filter(|knot| knot.kind != Kind::Ellipsis)
            .map(|knot| Some(Fraction::from_rational(knot.as_number()?)))
            .collect();
        let given = given.filter(|given| !given.is_empty());
        let knots: Vec<(i64, Fraction)> = match given {
            Some(given) => (0..).zip(given).collect(),
            None => KNOTS
                .filter_map(|j| {
                    let knot = Kind::Subscript(Box::new(Expr::name(&letter)), vec![Expr::int(j)]);
                    match machine.eval(&knot.into()).ok()? {
                        Value::Scalar(knot) => Some((j, knot)),
                        _ => None,
                    }
                })
                .collect(),
        };
        // Within a derivative x is a symbol for it.
        let place = self.place_of_derivative.borrow().clone().unwrap_or_else(|| x.clone());
        let at_knot = knots.iter().position(|(_, knot)| *knot == place);
        let before: Vec<&(i64, Fraction)> = match (at_knot, place.as_rational()) {
            (Some(at), _) => knots[..at].iter().collect(),
            (None, Some(number)) => {
                let mut numbers = knots.iter().filter(|(_, knot)| knot.as_rational().is_some()).peekable();
                if numbers.peek().is_none() {
                    return Err(unclear("between which knots this value of a spline is", expr));
                }
                numbers.filter(|(_, knot)| knot.as_rational().is_some_and(|knot| knot < number)).collect()
            }
            (None, None) => return Err(unclear("between which knots this value of a spline is", expr)),
        };
        self.note_generic(format!("{} is any spline of degree {degree}", head.base));
        let name = Symbol::new(format!("[{}]", head.base));
        let power = |base: &Fraction, exponent: usize| {
            (0..exponent).fold(Fraction::from_rational(&integer(1)), |all, _| all.times(base))
        };
        let smooth = (0..=degree).map(|i| variable(name.numbered(i as i64)).times(&power(x, i)));
        let first = degree as i64 + 1 - KNOTS.start;
        // At a knot that is there twice one derivative less agrees.
        let kinks = before.iter().enumerate().filter_map(|(at, (j, knot))| {
            let times = before[..at].iter().filter(|(_, other)| other == knot).count();
            let exponent = degree.checked_sub(times)?;
            Some(variable(name.numbered(first + j)).times(&power(&x.minus(knot), exponent)))
        });
        Ok(Value::Scalar(smooth.chain(kinks).fold(Fraction::zero(), |sum, term| sum.plus(&term))))
    }

    /// The letter of the knots of a spline: as words say it, or as its values are given, s(x_i) = y_i.
    fn letter_of_knots(&self, object: &Object, spline: &str) -> String {
        let letter = |items: &[Expr]| items.first().and_then(Head::of).map(|head| head.base);
        let told = letter(&object.knots).or_else(|| {
            let knots = |sort: &Sort| matches!(sort, Sort::Knots | Sort::Nodes);
            let here = self.context.objects.iter().rev().filter(|told| self.place.knows(&told.place, false));
            here.filter(|told| knots(&told.object.sort)).find_map(|told| letter(&told.object.names))
        });
        told.or_else(|| {
            let bodies =
                self.context.definitions.iter().rev().filter_map(|Definition { body, .. }| match body {
                    Body::Formula(body) => Some(body),
                    Body::Value(_) => None,
                });
            let said = self.context.conditions.iter().rev().map(|condition| &condition.expr);
            bodies.chain(said).find_map(|formula| {
                let mut found = None;
                walk(formula, &mut |part| {
                    if let Kind::Apply(callee, groups) = &part.kind
                        && callee.has(&|name| matches!(&name.kind, Kind::Name(own) if own == spline))
                        && let [Expr { kind: Kind::Subscript(base, _), .. }] = groups.concat().as_slice()
                        && let Kind::Name(letter) = &base.kind
                    {
                        found = Some(letter.clone());
                    }
                });
                found
            })
        })
        .unwrap_or_else(|| "x".to_owned())
    }
}
