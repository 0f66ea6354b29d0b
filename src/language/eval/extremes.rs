//! Largest and smallest values over an interval: max of F(t) for 0 <= t <= 1.

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::formula::{Enclosure, Expr, Kind, Link, Rel, interval};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::lexicon::roles;
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::coefficients_in;
use crate::language::value::{Value, in_letter};
use crate::language::write;
use crate::math::number::Rational;
use crate::math::poly::{Extreme, Fraction, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;

impl Machine {
    /// The largest or smallest value of a formula for t in an interval; `None` if the name that runs is an index, or if
    /// no interval is given.
    pub(super) fn extreme_over_reals(
        &mut self,
        largest: bool,
        lower: &[Expr],
        body: &Expr,
        span: Span,
    ) -> Option<Evaluated> {
        let [condition] = lower else { return None };
        let (name, ends, open) = variable_in(condition)?;
        // r and s are indices in some books, and parameters in others.
        if roles::is_index_letter(name) && !roles::is_variable(name) {
            return None;
        }
        let name = Symbol::new(name);
        Some(self.extreme_between(largest, &name, ends, open, body, span))
    }

    fn extreme_between(
        &mut self,
        largest: bool,
        name: &Symbol,
        ends: [&Expr; 2],
        open: [bool; 2],
        body: &Expr,
        span: Span,
    ) -> Evaluated {
        let (inner, absolute) = match &body.kind {
            Kind::Enclosed(Enclosure::Abs, inner) => (inner.as_ref(), true),
            _ => (body, false),
        };
        let own = [(name.clone(), Value::symbol(name.clone()))];
        let value = self.with_locals(own, |machine| machine.eval(inner))?;
        let formula =
            value.as_scalar().cloned().ok_or_else(|| wrong_kind("a formula", &value).at(inner.span))?;
        let mut number = |end: &Expr| -> Result<Rational, Diagnostic> {
            let value = self.eval(end)?;
            value.as_rational().ok_or_else(|| wrong_kind("a number", &value).at(end.span))
        };
        let (a, b) = (number(ends[0])?, number(ends[1])?);
        let within = Within { name, ends: [&a, &b], open };
        let found = match absolute {
            true => within.absolute(&formula, largest),
            false => within.extreme(&formula, largest),
        };
        let found = found.at(span)?;
        self.note(taken(&found, name).at(span));
        Ok(Value::root(found.value, name))
    }
}

/// Says where an extreme value is taken.
pub(crate) fn taken(extreme: &Extreme, variable: &Symbol) -> Diagnostic {
    let places: Vec<String> = extreme
        .places
        .iter()
        .map(|place| write::text(&Value::root(place.clone(), variable).to_expr()))
        .collect();
    Diagnostic::note(Code::TakenAt, format!("taken at {variable} = {}", places.join(", ")))
}

/// Where a variable runs.
pub(crate) struct Within<'a> {
    /// The variable.
    pub name: &'a Symbol,
    /// The ends of its interval.
    pub ends: [&'a Rational; 2],
    /// Whether they are left out.
    pub open: [bool; 2],
}

impl Within<'_> {
    /// The largest or smallest value of a quotient of polynomials, and where it is taken.
    pub fn extreme(&self, formula: &Fraction, largest: bool) -> Result<Extreme, Diagnostic> {
        let part = |of: Fraction| -> Result<Poly, Diagnostic> {
            let list = coefficients_in(&of, self.name)?;
            let numbers: Option<Vec<Rational>> = list.iter().map(Fraction::as_rational).collect();
            numbers.map(Poly::from_coefficients).ok_or_else(|| {
                Diagnostic::error(Code::Type, "which value is largest depends on symbols")
                    .hint("give the other names values first, for example a := 3")
            })
        };
        let p = part(Fraction::from(formula.numerator().clone()))?;
        let q = part(Fraction::from(formula.denominator().clone()))?;
        p.extreme(&q, self.ends, self.open, largest).ok_or_else(|| self.none(&q, largest))
    }

    /// The same of the absolute value.
    fn absolute(&self, formula: &Fraction, largest: bool) -> Result<Extreme, Diagnostic> {
        let up = self.extreme(formula, largest)?;
        let down = self.extreme(&-formula.clone(), largest)?;
        let zero = RealRoot::Rational(Rational::default());
        if largest {
            return Ok(match up.value.cmp(&down.value) {
                std::cmp::Ordering::Less => down,
                std::cmp::Ordering::Greater => up,
                std::cmp::Ordering::Equal => {
                    let mut places = [up.places, down.places].concat();
                    places.sort();
                    places.dedup();
                    Extreme { value: up.value, places }
                }
            });
        }
        // The smaller of both is negative; without a root between the ends the other one is the least distance.
        if up.value >= zero {
            return Ok(up);
        }
        if down.value >= zero {
            return Ok(down);
        }
        let squared = self.extreme(&formula.times(formula), false)?;
        Ok(Extreme { value: zero, places: squared.places })
    }

    fn none(&self, below: &Poly, largest: bool) -> Diagnostic {
        let [a, b] = self.ends;
        let which = if largest { "largest" } else { "smallest" };
        if a > b {
            return Diagnostic::error(Code::Domain, format!("the interval [{a}, {b}] is empty"))
                .hint("give the lower end first");
        }
        let pole = below.real_roots(Some(a), Some(b)).and_then(|roots| roots.into_iter().next());
        match pole {
            Some((root, _)) => {
                let place = write::text(&Value::root(root, self.name).to_expr());
                Diagnostic::error(Code::Domain, format!("the denominator is 0 at {} = {place}", self.name))
                    .reason(format!("{} has a root there", write_poly(below, self.name)))
            }
            None => Diagnostic::error(Code::Domain, format!("there is no {which} value"))
                .reason("it is only approached at an end that is left out")
                .hint("of a closed interval there is one: [0, 1]"),
        }
    }
}

fn write_poly(polynomial: &Poly, variable: &Symbol) -> String {
    write::text(&Value::Scalar(Fraction::from(in_letter(polynomial, variable))).to_expr())
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
