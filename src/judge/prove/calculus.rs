//! Derivatives, values at a place, and integrals over [0, 1].

use num_traits::{One, Zero};

use super::context::Context;
use super::known::MAX_ORDER;
use super::linear::Linear;
use super::names;
use super::read::{Reader, rational_value};
use super::term::{Base, Term, collected};
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::lexicon::roles;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

impl Reader<'_> {
    /// d/dx of a sum of terms; each factor is differentiated in a term of its own.
    pub(super) fn derivative(&mut self, terms: &[Term], variable: &Symbol) -> Option<Vec<Term>> {
        self.reals.insert(variable.clone());
        let mut sum = Vec::new();
        for term in terms {
            sum.push(Term { coefficient: term.coefficient.derivative(variable), ..term.clone() });
            for (base, exponent) in &term.powers {
                let inner = base.poly().derivative(variable);
                if inner.is_zero() {
                    continue;
                }
                let mut part = Term { powers: term.powers.clone(), ..term.clone() };
                part.powers.remove(base);
                part.multiply_power(&Fraction::from(base.poly()), &exponent.shifted(-1))?;
                sum.push(part.scaled(&exponent.to_fraction().times(&Fraction::from(inner))));
            }
        }
        Some(collected(sum))
    }

    /// Whether all other letters of the terms may be taken for constants.
    fn others_are_constant(&self, terms: &[Term], variable: &Symbol) -> bool {
        terms.iter().all(|term| {
            let bases = term.powers.keys().flat_map(|base| base.poly().variables().to_vec());
            let mut letters = term.coefficient.variables().into_iter().chain(bases);
            letters.all(|s| {
                s == *variable
                    || self.integers.contains(&s)
                    || (roles::is_constant(s.base()) && s.accent().is_empty() && s.indices().is_empty())
                    || (names::is_constant_family(s.base()) && !s.indices().is_empty())
            }) && term.symbols.keys().all(|s| names::is_constant_family(&s.head))
        })
    }

    fn mentions(terms: &[Term], variable: &Symbol) -> bool {
        terms.iter().any(|term| {
            term.coefficient.variables().contains(variable)
                || term.powers.keys().any(|base| base.poly().variables().contains(variable))
        })
    }

    /// A name that may be a variable of differentiation.
    fn variable(&mut self, expr: &Expr) -> Option<Symbol> {
        let Kind::Name(name) = &expr.kind else { return None };
        if !names::is_letter(name) || self.defines(expr) {
            return None;
        }
        let symbol = Symbol::new(name.clone());
        self.reals.insert(symbol.clone());
        Some(symbol)
    }

    /// d^k/dt^k body, ∂^{r+s}/∂u^r∂v^s body
    pub(super) fn differentiated(
        &mut self,
        partial: bool,
        variables: &[(Expr, Option<Expr>)],
        body: &Expr,
    ) -> Option<Vec<Term>> {
        let mut terms = self.read(body)?;
        for (variable, order) in variables {
            let symbol = self.variable(variable)?;
            let order = match order {
                None => 1,
                Some(order) => self.linear(order)?.as_constant()?.as_small()?,
            };
            // Letters could depend on t if t itself does not occur.
            let explicit = Self::mentions(&terms, &symbol) || terms.is_empty();
            if !explicit || !(partial || self.others_are_constant(&terms, &symbol)) {
                return None;
            }
            if !(1..=i64::from(MAX_ORDER)).contains(&order) {
                return None;
            }
            for _ in 0..order {
                terms = self.derivative(&terms, &symbol)?;
            }
        }
        Some(terms)
    }

    /// (B_i^n(t))', where the argument is a name.
    pub(super) fn primed(&mut self, body: &Expr, order: u32) -> Option<Vec<Term>> {
        let mut inner = body;
        while let Kind::Group(body) = &inner.kind {
            inner = body;
        }
        match &inner.kind {
            Kind::Apply(callee, groups) if names::bernstein(callee).is_some() => {
                let [group] = groups.as_slice() else { return None };
                let [argument @ Expr { kind: Kind::Name(_), .. }] = group.as_slice() else { return None };
                self.differentiated(false, &[(argument.clone(), Some(Expr::int(i64::from(order))))], inner)
            }
            _ => {
                let primed = Kind::Prime(Box::new(body.clone()), order).into();
                names::bernstein(&primed)?;
                self.bernstein(&primed, None)
            }
        }
    }

    /// F'(x) for a function that can be looked up.
    pub(super) fn derivative_at(
        &mut self,
        function: &Expr,
        order: u32,
        argument: &Expr,
    ) -> Option<Vec<Term>> {
        if order > MAX_ORDER {
            return None;
        }
        let mut name = function;
        while let Kind::Group(body) = &name.kind {
            name = body;
        }
        let at = rational_value(&self.read(argument)?)?;
        let variable = self.fresh();
        let place = Expr::name(variable.to_string());
        self.scope.push((variable.to_string(), variable.clone()));
        let call = Expr::apply(name.clone(), vec![place]);
        let defined = self.defines(&call);
        let terms = if defined { self.read(&call) } else { None };
        self.scope.pop();
        let mut terms = terms?;
        if !self.others_are_constant(&terms, &variable) {
            return None;
        }
        for _ in 0..order {
            terms = self.derivative(&terms, &variable)?;
        }
        self.at(&terms, &variable, &at)
    }

    /// body |_{t=x}
    pub(super) fn evaluated(&mut self, body: &Expr, lower: &[Expr]) -> Option<Vec<Term>> {
        let [Expr { kind: Kind::Chain(first, links), .. }] = lower else { return None };
        let [Link { rel: Rel::Eq, expr: place, .. }] = links.as_slice() else { return None };
        let symbol = self.variable(first)?;
        let terms = self.read(body)?;
        if !Self::mentions(&terms, &symbol) || !self.others_are_constant(&terms, &symbol) {
            return None;
        }
        let place = rational_value(&self.read(place)?)?;
        self.at(&terms, &symbol, &place)
    }

    /// What is known of integers here.
    pub(super) fn known(&self) -> Context {
        let mut known = self.domain.clone();
        self.ranges.iter().for_each(|form| known.assume(form));
        self.integers
            .iter()
            .filter(|symbol| !symbol.base().starts_with('#'))
            .for_each(|symbol| known.assume(&Linear::symbol(symbol)));
        known
    }

    /// The terms with a rational function put in for a variable. A factor b^L with b = 0 there is
    /// 1 for L = 0 and 0 for L > 0; where L < 0 the term must be 0 for another reason.
    pub(super) fn at(&mut self, terms: &[Term], variable: &Symbol, place: &Fraction) -> Option<Vec<Term>> {
        self.reals.extend(place.variables());
        let put = [(variable.clone(), place.clone())];
        let known = self.known();
        let mut sum = Vec::new();
        for term in terms {
            let mut result = Term { powers: term.powers.clone(), ..term.clone() };
            result.powers.clear();
            let mut vanishing = 0;
            for (base, exponent) in &term.powers {
                let p = Fraction::from(base.poly());
                let value = p.substitute(&put).ok()?;
                let mut exponent = exponent.clone();
                if value.is_zero() {
                    vanishing += 1;
                    let order;
                    (order, result.coefficient) = valuation(&result.coefficient, base);
                    exponent = exponent.shifted(order);
                    if !is_zero_below(&result, &exponent, &known) {
                        return None;
                    }
                }
                result.multiply_power(&value, &exponent)?;
            }
            if vanishing > 1 {
                return None;
            }
            result.coefficient = result.coefficient.substitute(&put).ok()?;
            sum.push(result);
        }
        Some(collected(sum))
    }

    /// ∫_0^1 body dt, by ∫ t^a (1−t)^b dt = a! b!/(a+b+1)!.
    pub(super) fn integrated(
        &mut self,
        lower: &Expr,
        upper: &Expr,
        body: &Expr,
        variable: &Expr,
    ) -> Option<Vec<Term>> {
        let (from, to) = (rational_value(&self.read(lower)?)?, rational_value(&self.read(upper)?)?);
        if !from.is_zero() || !to.is_one() {
            return None;
        }
        let symbol = self.variable(variable)?;
        let terms = self.read(body)?;
        if !self.others_are_constant(&terms, &symbol) {
            return None;
        }
        let known = self.known();
        let mut sum = Vec::new();
        for term in &terms {
            sum.extend(beta(term, &symbol, &known)?);
        }
        Some(collected(sum))
    }

    /// Whether the formula has a meaning given by the notes.
    pub(super) fn defines(&self, expr: &Expr) -> bool {
        self.looked_up(expr).is_some()
    }
}

/// How often the base divides the fraction (negative in the denominator), and the rest.
fn valuation(value: &Fraction, base: &Base) -> (i64, Fraction) {
    let p = base.poly();
    let strip = |q: &MultiPoly| {
        let (mut order, mut rest) = (0, q.clone());
        while !rest.is_zero() && p.as_constant().is_none() {
            let Some(quotient) = rest.div_exact(&p) else { break };
            rest = quotient;
            order += 1;
        }
        (order, rest)
    };
    let ((above, top), (below, bottom)) = (strip(value.numerator()), strip(value.denominator()));
    let rest = Fraction::new(top, bottom).unwrap_or_else(|_| value.clone());
    (above - below, rest)
}

/// Whether the term is 0 wherever the exponent is negative: because it never is, because of a
/// factorial in the denominator, or because of factors such as the i of i t^(i−1).
fn is_zero_below(term: &Term, exponent: &Linear, known: &Context) -> bool {
    // Where the term is not 0, the factorials in its denominator have arguments ≥ 0.
    let mut inside = known.clone();
    let below = term.factorials.iter().filter(|(_, m)| **m < 0);
    below.for_each(|(form, _)| inside.assume(form));
    let mut numerator = term.coefficient.numerator().clone();
    for m in 0..=i64::from(MAX_ORDER) {
        let form = exponent.shifted(m);
        if m > 0 {
            let Some(quotient) = numerator.div_exact(&form.to_poly()) else { return false };
            numerator = quotient;
        }
        if inside.entails(&form) {
            return true;
        }
        if form.as_constant().is_some() {
            return false;
        }
    }
    false
}

/// ∫_0^1 of a term.
fn beta(term: &Term, variable: &Symbol, known: &Context) -> Option<Vec<Term>> {
    let t = MultiPoly::symbol(variable.clone());
    let minus = MultiPoly::constant(-Rational::one());
    let bases = [Base::new(&t), Base::new(&t.plus(&minus))];
    let mut rest = term.clone();
    let mut exponents = Vec::new();
    for base in &bases {
        let (order, coefficient) = valuation(&rest.coefficient, base);
        rest.coefficient = coefficient;
        exponents.push(rest.powers.remove(base).unwrap_or_default().shifted(order));
    }
    let [a, b] = <[Linear; 2]>::try_from(exponents).ok()?;
    // The second base is t − 1 = −(1 − t).
    rest.multiply_power(&Fraction::from(minus), &b)?;
    let elsewhere = rest.powers.keys().any(|base| base.poly().variables().contains(variable));
    if elsewhere || rest.coefficient.denominator().variables().contains(variable) {
        return None;
    }
    let list = rest.coefficient.numerator().coefficients_in(variable);
    // Parts of a polynomial factor may diverge where the whole does not.
    let safe = if list.len() > 1 {
        known.entails(&a) && known.entails(&b)
    } else {
        is_zero_below(&rest, &a, known) && is_zero_below(&rest, &b, known)
    };
    if !safe {
        return None;
    }
    let mut sum = Vec::new();
    for (k, c) in list.iter().enumerate() {
        let a = a.shifted(i64::try_from(k).ok()?);
        let mut part = rest.clone();
        part.coefficient = Fraction::new(c.clone(), rest.coefficient.denominator().clone()).ok()?;
        part.guards.extend([a.clone(), b.clone()]);
        part.multiply_factorial(a.clone(), 1);
        part.multiply_factorial(b.clone(), 1);
        part.multiply_factorial(a.plus(&b).shifted(1), -1);
        sum.push(part);
    }
    Some(sum)
}
