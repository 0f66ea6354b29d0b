//! Closed forms of sums over one variable.
//!
//! - Σ_l p(l) X^l/(l! (N−l)!) by the binomial theorem: with p = Σ c_k l(l−1)…(l−k+1) it is
//!   Σ_k c_k X^k (1+X)^(N−k)/(N−k)!, for all integers N.
//! - Σ_j 1/((j+a)! (j+d)! (b−j)! (c−j)!) = (a+b+c+d)!/((a+b)! (c+d)! (a+c)! (b+d)!), which is
//!   Vandermonde's identity, for a+b ≥ 0 and c+d ≥ 0 (otherwise the sum is 0).
//! - Σ_j (j+a)! (b−j)!/((j+c)! (d−j)!) = p! q! (a+b+1)!/((p+q+1)! (c+d)!) with p = a − c ≥ 0 and
//!   q = b − d ≥ 0: the same identity for C(j+a, p) C(b−j, q).
//! - Σ_{j=a}^{b} p(j) X^j = X^(b+1) Q(b+1) − X^a Q(a) with X Q(j+1) − Q(j) = p(j).
//!
//! All but the last sum over all integers; the factorials in the denominator end the sum. If the
//! range of the sum ends a constant number of terms earlier, these are subtracted.

use std::collections::BTreeSet;

use num_traits::{One, Zero};

use super::context::{Context, negation};
use super::decide::Step;
use super::linear::Linear;
use super::term::{Term, add};
use crate::budget;
use crate::math::number::{Int, Rational, binomial};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};

/// Polynomials of higher degree in the variable are not summed.
const MAX_DEGREE: usize = 12;
/// At most so many terms are subtracted at an end of the range.
const MAX_REMOVED: i64 = 8;

/// What is known of a sum over one variable.
pub enum Closed {
    /// It is the sum of these terms.
    Sum(Vec<Term>),
    /// It must be known whether this form is negative.
    Split(Linear),
    /// No closed form was found.
    Open,
}

/// A sum over one variable j, taken apart. Outside of the range the body is the formula that it
/// is inside; there it need not be what was written.
struct Sum<'a> {
    variable: &'a Symbol,
    /// The body without the guards and facts on j.
    body: Term,
    /// The facts on other variables.
    facts: BTreeSet<Linear>,
    lower: Vec<Linear>,
    upper: Vec<Linear>,
    /// What holds here, with the guards on other variables.
    known: Context,
}

/// The sum of a term over the integer values of one of its bound variables.
pub fn close(term: &Term, variable: &Symbol, context: &Context, steps: &mut BTreeSet<Step>) -> Closed {
    if let Some(closed) = try_close(term, variable, context, steps) {
        return closed;
    }
    let is_empty = |sum: &Sum<'_>| sum.ends().iter().any(|(a, b)| sum.known.refutes(&b.minus(a)));
    match Sum::new(term, variable, context) {
        Some(sum) if is_empty(&sum) => Closed::Sum(Vec::new()),
        _ => Closed::Open,
    }
}

fn try_close(
    term: &Term,
    variable: &Symbol,
    context: &Context,
    steps: &mut BTreeSet<Step>,
) -> Option<Closed> {
    let term = term.cancelled()?;
    if term.coefficient.is_zero() {
        return Some(Closed::Sum(Vec::new()));
    }
    let mut sum = Sum::new(&term, variable, context)?;
    for (a, b) in sum.ends() {
        match b.minus(&a).as_constant() {
            Some(length) if *length < Int::ZERO => return Some(Closed::Sum(Vec::new())),
            Some(length) if length.is_zero() => {
                return Some(Closed::Sum(vec![term.substitute(variable, &a)?]));
            }
            _ => {}
        }
    }
    sum.absorb_denominator();
    if sum.body.coefficient.denominator().variables().contains(variable) {
        return None;
    }
    let (mut up, mut down) = (Vec::new(), Vec::new());
    let (mut up_above, mut down_above) = (Vec::new(), Vec::new());
    for (form, m) in sum.body.factorials.iter().filter(|(form, _)| form.contains(variable)) {
        let rest = form.substitute(variable, &Linear::default());
        let list = match (form.coefficient(variable).as_small(), *m < 0) {
            (Some(1), true) => &mut up,
            (Some(-1), true) => &mut down,
            (Some(1), false) => &mut up_above,
            (Some(-1), false) => &mut down_above,
            _ => return None,
        };
        list.extend(std::iter::repeat_n(rest, m.unsigned_abs() as usize));
    }
    let ratio = sum.ratio()?;
    if let ([a], [b], [c], [d], true) =
        (up_above.as_slice(), down_above.as_slice(), up.as_slice(), down.as_slice(), ratio.is_one())
    {
        let (p, q) = (a.minus(c), b.minus(d));
        for form in [&p, &q] {
            if sum.known.refutes(form) {
                return None;
            }
            if !sum.known.entails(form) {
                return Some(sum.split(form.clone()));
            }
        }
        if !sum.covers(&[c.negated()], std::slice::from_ref(d)) {
            return None;
        }
        steps.insert(Step::Vandermonde);
        return sum.upper_vandermonde([&p, &q], c, d).map(Closed::Sum);
    }
    if !up_above.is_empty() || !down_above.is_empty() {
        return None;
    }
    match (up.as_slice(), down.as_slice()) {
        ([], []) => {
            if let Some(split) = sum.single_ends() {
                return Some(sum.split(split));
            }
            steps.insert(Step::PowerSum);
            sum.telescoped(&ratio).map(Closed::Sum)
        }
        ([a], [b]) => {
            if let Some(split) = sum.restrict(&a.negated(), b)? {
                return Some(sum.split(split));
            }
            steps.insert(Step::BinomialTheorem);
            sum.binomial_theorem(a, b, &ratio).map(Closed::Sum)
        }
        ([a, d], [b, c]) if ratio.is_one() => {
            if !sum.covers(&[a.negated(), d.negated()], &[b.clone(), c.clone()]) {
                return None;
            }
            steps.insert(Step::Vandermonde);
            sum.vandermonde([a, b, c, d]).map(Closed::Sum)
        }
        _ => None,
    }
}

impl<'a> Sum<'a> {
    fn new(term: &Term, variable: &'a Symbol, context: &Context) -> Option<Self> {
        let mut body = term.clone();
        body.bound.remove(variable);
        let (on_variable, others): (BTreeSet<Linear>, BTreeSet<Linear>) =
            std::mem::take(&mut body.guards).into_iter().partition(|guard| guard.contains(variable));
        let mut known = context.clone();
        others.iter().for_each(|guard| known.assume(guard));
        body.guards = others;
        let facts: BTreeSet<Linear> =
            std::mem::take(&mut body.defined).into_iter().filter(|fact| !fact.contains(variable)).collect();
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for guard in on_variable {
            let rest = guard.substitute(variable, &Linear::default());
            match guard.coefficient(variable).as_small()? {
                1 => lower.push(rest.negated()),
                -1 => upper.push(rest),
                _ => return None,
            }
        }
        Some(Sum { variable, body, facts, lower, upper, known })
    }

    /// All pairs of a lower and an upper end.
    fn ends(&self) -> Vec<(Linear, Linear)> {
        self.lower.iter().flat_map(|a| self.upper.iter().map(|b| (a.clone(), b.clone()))).collect()
    }

    /// 1/((L+1) L!) = 1/(L+1)! wherever the left side has a value.
    fn absorb_denominator(&mut self) {
        loop {
            budget::step();
            let denominator = self.body.coefficient.denominator().clone();
            let found = self.body.factorials.iter().find_map(|(form, m)| {
                let next = form.shifted(1).to_poly();
                (*m < 0 && form.contains(self.variable) && denominator.div_exact(&next).is_some())
                    .then(|| (form.clone(), next))
            });
            let Some((form, next)) = found else { return };
            self.body.coefficient *= Fraction::from(next);
            self.body.multiply_factorial(form.clone(), 1);
            self.body.multiply_factorial(form.shifted(1), -1);
            self.body.defined.clear();
        }
    }

    /// X, where the powers are (something without j) · X^j.
    fn ratio(&self) -> Option<Fraction> {
        let mut ratio = Fraction::one();
        for (base, exponent) in &self.body.powers {
            let a = exponent.coefficient(self.variable).as_small().filter(|a| a.abs() <= 20)?;
            ratio *= Fraction::from(base.poly()).pow(i32::try_from(a).ok()?).ok()?;
        }
        Some(ratio)
    }

    /// How to go on where it is not known whether a form is negative.
    fn split(&self, form: Linear) -> Closed {
        if !form.terms().keys().any(|symbol| self.body.bound.contains(symbol)) {
            return Closed::Split(form);
        }
        let mut whole = self.body.clone();
        whole.bound.insert(self.variable.clone());
        whole.defined.extend(self.facts.iter().cloned());
        let j = Linear::symbol(self.variable);
        whole.guards.extend(self.lower.iter().map(|a| j.minus(a)));
        whole.guards.extend(self.upper.iter().map(|b| b.minus(&j)));
        let parts = [form.clone(), negation(&form)].map(|guard| {
            let mut part = whole.clone();
            part.guards.insert(guard);
            part
        });
        Closed::Sum(parts.to_vec())
    }

    /// Brings each end down to one form; returns a form whose sign would have to be known.
    fn single_ends(&mut self) -> Option<Linear> {
        for (list, sign) in [(&mut self.lower, 1), (&mut self.upper, -1)] {
            while let [first, second, ..] = list.as_slice() {
                budget::step();
                let difference = first.minus(second).scaled(&Int::from(sign));
                if self.known.entails(&difference) {
                    list.remove(1);
                } else if self.known.refutes(&difference) {
                    list.remove(0);
                } else {
                    return Some(difference);
                }
            }
        }
        None
    }

    /// Keeps only ends that lie within the support from `start` to `end`. `None` if that is
    /// impossible, a form if its sign would have to be known.
    fn restrict(&mut self, start: &Linear, end: &Linear) -> Option<Option<Linear>> {
        let known = &self.known;
        let mut open = None;
        let mut keep = |inside: Linear| {
            // The end cuts off `inside` terms of the support, if that is positive.
            if known.entails(&inside.negated()) {
                return Some(false);
            }
            if inside.as_constant().is_some() {
                return Some(true);
            }
            if known.entails(&inside.shifted(-1)) {
                return None;
            }
            open = Some(inside.negated());
            Some(true)
        };
        let mut lower = Vec::new();
        for a in &self.lower {
            if keep(a.minus(start))? {
                lower.push(a.clone());
            }
        }
        let mut upper = Vec::new();
        for b in &self.upper {
            if keep(end.minus(b))? {
                upper.push(b.clone());
            }
        }
        if open.is_some() {
            return Some(open);
        }
        // Constant distances from the support: the innermost end counts.
        let distance = |x: &Linear, y: &Linear| x.minus(y).as_constant().cloned().unwrap_or(Int::ZERO);
        lower.sort_by_key(|a| distance(a, start));
        upper.sort_by_key(|b| distance(end, b));
        self.restricted(lower.pop(), upper.pop());
        Some(None)
    }

    fn restricted(&mut self, lower: Option<Linear>, upper: Option<Linear>) {
        // Whether the range is empty is still decided by all ends.
        let pairs = self.ends();
        let both = lower.is_some() && upper.is_some();
        let pure = self.is_pure();
        let needed: Vec<Linear> = if !pure {
            pairs.iter().map(|(a, b)| b.minus(a)).collect()
        } else if let (true, Some(a), Some(b)) = (both, &lower, &upper) {
            vec![b.minus(a).shifted(1)]
        } else {
            Vec::new()
        };
        self.require(needed, !pure);
        self.lower = lower.into_iter().collect();
        self.upper = upper.into_iter().collect();
    }

    /// Makes the closed form 0 where one of the forms is negative.
    fn require(&mut self, forms: Vec<Linear>, keep_facts: bool) {
        for form in forms {
            if !self.known.entails(&form) {
                self.body.guards.insert(form);
            }
        }
        if keep_facts {
            self.body.defined.extend(self.facts.iter().cloned());
        }
    }

    /// Whether the closed form makes sense for an empty range, too: no denominators, and no
    /// factorials in numerators.
    fn is_pure(&self) -> bool {
        self.body.coefficient.denominator().as_constant().is_some()
            && self.body.factorials.values().all(|m| *m < 0)
    }

    /// Whether no end of the range lies within the support.
    fn covers(&mut self, starts: &[Linear], ends: &[Linear]) -> bool {
        let lower = self.lower.iter().all(|a| starts.iter().any(|s| self.known.entails(&s.minus(a))));
        let upper = self.upper.iter().all(|b| ends.iter().any(|e| self.known.entails(&b.minus(e))));
        if lower && upper {
            self.restricted(None, None);
        }
        lower && upper
    }

    /// The coefficients of the numerator of the body in falling factorials of l, where j = l + start.
    fn falling(&self, start: &Linear) -> Option<Vec<Fraction>> {
        let numerator = self.body.coefficient.numerator();
        let shifted = Linear::symbol(self.variable).plus(start).to_poly();
        let p = numerator.substitute(&[(self.variable.clone(), shifted)]);
        let mut rest = p.coefficients_in(self.variable);
        if rest.len() > MAX_DEGREE + 1 {
            return None;
        }
        // Repeated division by l, l − 1, l − 2, …
        let mut found = Vec::new();
        let mut k = 0;
        while !rest.is_empty() {
            budget::step();
            let node = Rational::from_integer(Int::from(k));
            for at in (0..rest.len() - 1).rev() {
                let carried = rest[at + 1].scaled(&node);
                rest[at] = rest[at].plus(&carried);
            }
            let remainder = rest.remove(0);
            found.push(Fraction::new(remainder, self.body.coefficient.denominator().clone()).ok()?);
            k += 1;
        }
        Some(found)
    }

    /// The body without what depends on j: factorials gone, powers taken at j = start.
    fn frame(&self, start: &Linear) -> Option<Term> {
        let mut frame = self.body.clone();
        frame.coefficient = Fraction::one();
        frame.factorials.retain(|form, _| !form.contains(self.variable));
        frame.powers.clear();
        for (base, exponent) in &self.body.powers {
            let exponent = exponent.substitute(self.variable, start);
            frame.multiply_power(&Fraction::from(base.poly()), &exponent)?;
        }
        Some(frame)
    }

    /// Σ over l of p(l) X^l/(l! (N−l)!) with l = j + a, N = a + b, less what is outside of the range.
    fn binomial_theorem(&self, a: &Linear, b: &Linear, ratio: &Fraction) -> Option<Vec<Term>> {
        let (start, total) = (a.negated(), a.plus(b));
        let frame = self.frame(&start)?;
        let mut result = Vec::new();
        for (k, c) in self.falling(&start)?.into_iter().enumerate() {
            budget::step();
            let k = i32::try_from(k).ok()?;
            let rest = total.shifted(-i64::from(k));
            let mut term = frame.scaled(&c.times(&ratio.pow(k).ok()?));
            term.multiply_power(&Fraction::one().plus(ratio), &rest)?;
            term.multiply_factorial(rest, -1);
            add(&mut result, term);
        }
        let minus = -Fraction::one();
        let mut remove = |place: Linear| {
            let term = self.body.substitute(self.variable, &place)?;
            add(&mut result, term.scaled(&minus));
            Some(())
        };
        let count = |form: Linear| form.as_constant()?.as_small().filter(|d| *d <= MAX_REMOVED);
        if let Some(lower) = self.lower.first() {
            for l in 0..count(lower.minus(&start))? {
                remove(start.shifted(l))?;
            }
        }
        if let Some(upper) = self.upper.first() {
            for l in 0..count(b.minus(upper))? {
                remove(b.shifted(-l))?;
            }
        }
        Some(result)
    }

    fn vandermonde(&self, [a, b, c, d]: [&Linear; 4]) -> Option<Vec<Term>> {
        let frame = self.frame(&Linear::default())?;
        let mut result = Vec::new();
        for (k, coefficient) in self.falling(&a.negated())?.into_iter().enumerate() {
            budget::step();
            let a = a.shifted(-i64::try_from(k).ok()?);
            let (m, r) = (a.plus(b), c.plus(d));
            let mut term = frame.scaled(&coefficient);
            term.guards.extend([m.clone(), r.clone()]);
            term.multiply_factorial(m.plus(&r), 1);
            for form in [m, r, a.plus(c), b.plus(d)] {
                term.multiply_factorial(form, -1);
            }
            add(&mut result, term);
        }
        Some(result)
    }

    /// Σ_j (j+a)! (b−j)!/((j+c)! (d−j)!) with p = a − c, q = b − d, both ≥ 0.
    fn upper_vandermonde(&self, [p, q]: [&Linear; 2], c: &Linear, d: &Linear) -> Option<Vec<Term>> {
        let frame = self.frame(&Linear::default())?;
        let mut result = Vec::new();
        for (k, coefficient) in self.falling(&c.negated())?.into_iter().enumerate() {
            budget::step();
            let k = i64::try_from(k).ok()?;
            let (p, length) = (p.shifted(k), c.plus(d).shifted(-k));
            let both = p.plus(q).shifted(1);
            let mut term = frame.scaled(&coefficient);
            term.guards.insert(length.clone());
            for form in [p, q.clone(), both.plus(&length)] {
                term.multiply_factorial(form, 1);
            }
            term.multiply_factorial(both, -1);
            term.multiply_factorial(length, -1);
            add(&mut result, term);
        }
        Some(result)
    }

    /// Σ_{j=a}^{b} p(j) X^j
    fn telescoped(&mut self, ratio: &Fraction) -> Option<Vec<Term>> {
        let ([a], [b]) = (self.lower.as_slice(), self.upper.as_slice()) else { return None };
        let (a, b) = (a.clone(), b.clone());
        let pure = self.is_pure();
        let length = b.minus(&a).shifted(i64::from(pure));
        self.require(vec![length], !pure);
        let j = self.variable;
        let value_at = |q: &Fraction, place: &Linear| q.substitute(&[(j.clone(), place.to_fraction())]).ok();
        let (frame, above) = (self.frame(&Linear::default())?, b.shifted(1));
        let q = if ratio.is_one() { self.antidifference()? } else { self.geometric(ratio)? };
        let mut result = Vec::new();
        for (place, sign) in [(&above, Fraction::one()), (&a, -Fraction::one())] {
            let mut term = frame.scaled(&value_at(&q, place)?.times(&sign));
            for (base, exponent) in &self.body.powers {
                let slope = Linear::default().plus_multiple(place, &exponent.coefficient(j));
                term.multiply_power(&Fraction::from(base.poly()), &slope)?;
            }
            add(&mut result, term);
        }
        Some(result)
    }

    /// Q with Q(j+1) − Q(j) = p(j): j(j−1)…(j−k+1) comes from j(j−1)…(j−k)/(k+1).
    fn antidifference(&self) -> Option<Fraction> {
        let j = Linear::symbol(self.variable);
        let mut sum = Fraction::zero();
        let mut product = MultiPoly::one();
        for (k, c) in self.falling(&Linear::default())?.into_iter().enumerate() {
            product = product.times(&j.shifted(-i64::try_from(k).ok()?).to_poly());
            let share = Rational::new(Int::ONE, Int::from(k + 1));
            sum += c.times(&Fraction::from(product.scaled(&share)));
        }
        Some(sum)
    }

    /// Q with X Q(j+1) − Q(j) = p(j) for X ≠ 1, from the highest coefficient down.
    fn geometric(&self, ratio: &Fraction) -> Option<Fraction> {
        let p = self.body.coefficient.numerator().coefficients_in(self.variable);
        if p.len() > MAX_DEGREE + 1 {
            return None;
        }
        let divisor = ratio.minus(&Fraction::one()).inverse()?;
        let mut q: Vec<Fraction> = vec![Fraction::zero(); p.len()];
        for k in (0..p.len()).rev() {
            budget::step();
            let mut rest = Fraction::new(p[k].clone(), self.body.coefficient.denominator().clone()).ok()?;
            for (m, higher) in q.iter().enumerate().skip(k + 1) {
                let c = Rational::from_integer(binomial(m, k));
                rest = rest.minus(&higher.times(ratio).scaled(&c));
            }
            q[k] = rest.times(&divisor);
        }
        let j = Fraction::from(MultiPoly::symbol(self.variable.clone()));
        Some(Coefficients::new(q).value(&j))
    }
}
