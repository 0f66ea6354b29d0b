//! Functions with a standard meaning: Bernstein polynomials, elementary symmetric functions,
//! forward differences.

use num_traits::One;

use super::linear::Linear;
use super::names;
use super::read::{Reader, opaque_term, rational_value};
use super::term::{Term, collected};
use crate::formula::{Expr, Kind};
use crate::language::lexicon::families::FORWARD_DIFFERENCE;
use crate::math::number::Int;
use crate::math::poly::{Fraction, MultiPoly};

/// Differences of a higher numeric order are refused.
const MAX_DIFFERENCE: i64 = 8;
/// Derivatives of a higher order are refused.
pub const MAX_ORDER: u32 = 6;

impl Reader<'_> {
    /// B_i^n at an argument; without one, at the argument of the other Bernstein polynomials.
    pub(super) fn bernstein(&mut self, callee: &Expr, argument: Option<&Expr>) -> Option<Vec<Term>> {
        let head = names::bernstein(callee)?;
        let [index] = head.indices else { return None };
        let default = self.names.argument();
        let at = rational_value(&self.read(argument.or(default.as_ref())?)?)?;
        let (i, n) = (self.linear(index)?, self.linear(head.degree)?);
        let binomial = self.binomial(&n, &i);
        match head.order {
            0 => self.bernstein_terms(&binomial, &i, &n, &at),
            order if order <= MAX_ORDER => {
                let variable = self.fresh();
                let x = Fraction::from(MultiPoly::symbol(variable.clone()));
                let mut terms = self.bernstein_terms(&binomial, &i, &n, &x)?;
                for _ in 0..order {
                    terms = self.derivative(&terms, &variable)?;
                }
                self.at(&terms, &variable, &at)
            }
            _ => None,
        }
    }

    /// C(n, i) x^i (1−x)^(n−i)
    fn bernstein_terms(
        &mut self,
        binomial: &Term,
        i: &Linear,
        n: &Linear,
        x: &Fraction,
    ) -> Option<Vec<Term>> {
        self.reals.extend(x.variables());
        let mut term = binomial.clone();
        term.multiply_power(x, i)?;
        term.multiply_power(&(Fraction::one() - x.clone()), &n.minus(i))?;
        Some(vec![term])
    }

    /// B_{i,j,k}^n(u, v, w) = n!/(i! j! k!) u^i v^j w^k for i + j + k = n, and 0 otherwise.
    pub(super) fn triangular(&mut self, callee: &Expr, arguments: &[Expr]) -> Option<Vec<Term>> {
        let head = names::bernstein(callee)?;
        if head.order > 0 || arguments.len() != 3 {
            return None;
        }
        let n = self.linear(head.degree)?;
        self.take_for_granted(&n);
        let mut term = Term::factorial(n.clone(), 1);
        let mut rest = n;
        for (index, argument) in head.indices.iter().zip(arguments) {
            let x = rational_value(&self.read(argument)?)?;
            let form = self.linear(index)?;
            self.reals.extend(x.variables());
            term.multiply_factorial(form.clone(), -1);
            term.multiply_power(&x, &form)?;
            rest = rest.minus(&form);
        }
        term.guards.insert(rest.clone());
        term.guards.insert(rest.negated());
        Some(vec![term])
    }

    /// e_i(t_1, …, t_n) or σ_{i,n}(t_1, …, t_n) = e_i/C(n, i); both are 0 for i < 0 and i > n.
    pub(super) fn elementary(
        &mut self,
        base: &Expr,
        indices: &[Expr],
        arguments: &[Expr],
    ) -> Option<Vec<Term>> {
        let Kind::Name(name) = &base.kind else { return None };
        if !matches!(name.as_str(), "e" | "sigma") {
            return None;
        }
        let forms = self.indices(indices)?;
        let index = forms.first()?.clone();
        if let (Some(argument), "sigma", [n]) = (repeated(arguments), name.as_str(), &forms[1..]) {
            return self.diagonal(&index, n, arguments, argument);
        }
        let (family, count) = self.argument_list(arguments)?;
        let mut term = opaque_term(&format!("e({family})"), vec![index.clone(), count.clone()]);
        match (name.as_str(), &forms[1..]) {
            ("e", []) => self.take_for_granted(&count),
            ("sigma", [n]) if *n == count => {
                let binomial = self.binomial(&count, &index);
                term = term.times(&binomial.inverse()?);
                // Out of range the mean is 0; then the binomial may not be divided by.
                term.defined.clear();
                term.guards.extend([index.clone(), count.minus(&index)]);
            }
            _ => return None,
        }
        self.symmetric = true;
        Some(vec![term])
    }

    /// σ_{i,n}(t, …, t) = t^i for 0 ≤ i ≤ n, and 0 otherwise.
    fn diagonal(&mut self, i: &Linear, n: &Linear, arguments: &[Expr], t: &Expr) -> Option<Vec<Term>> {
        if let [Expr { kind: Kind::Brace(_, Some(count)), .. }] = arguments
            && self.linear(count)? != *n
        {
            return None;
        }
        self.take_for_granted(n);
        self.natural_range(i, n);
        let base = rational_value(&self.read(t)?)?;
        self.reals.extend(base.variables());
        let mut term = Term::power(&base, i)?;
        term.guards.extend([i.clone(), n.minus(i)]);
        Some(vec![term])
    }

    /// The letter and the length of a list t_1, …, t_n.
    fn argument_list(&mut self, arguments: &[Expr]) -> Option<(String, Linear)> {
        let mut letter: Option<String> = None;
        let mut expected = 1;
        let mut dots = false;
        let mut last = Linear::default();
        for argument in arguments {
            let (base, index) = match &argument.kind {
                Kind::Ellipsis if !dots && letter.is_some() => {
                    dots = true;
                    continue;
                }
                Kind::Subscript(base, index) => (base, index),
                _ => return None,
            };
            let head = Self::head(base)?.to_string();
            if letter.get_or_insert_with(|| head.clone()) != &head {
                return None;
            }
            let [form] = <[Linear; 1]>::try_from(self.indices(index)?).ok()?;
            if !dots {
                if form.as_constant() != Some(&Int::from(expected)) {
                    return None;
                }
                expected += 1;
            } else if last.as_constant().is_none() && last != Linear::default() {
                return None;
            }
            last = form;
        }
        // After the dots exactly one argument, t_n with a letter in its index.
        let ends_well = dots
            && last.as_constant().is_none()
            && matches!(arguments.iter().rev().nth(1).map(|a| &a.kind), Some(Kind::Ellipsis));
        ends_well.then_some((letter?, last))
    }

    /// Δ^k of an indexed symbol: Σ_j (−1)^(k−j) C(k, j) b_{i+j}, by its first index.
    pub(super) fn difference(&mut self, operator: &Expr, order: Expr, symbol: &Expr) -> Option<Vec<Term>> {
        let delta = Expr::name(FORWARD_DIFFERENCE);
        if self.defines(&delta) || self.defines(operator) {
            return None;
        }
        let Kind::Subscript(base, indices) = &symbol.kind else { return None };
        let whole = Kind::Mul(vec![operator.clone(), symbol.clone()]).into();
        if let Some(body) = self.looked_up(&whole) {
            return self.read(&body);
        }
        if self.defines(symbol) || indices.len() != 1 {
            return None;
        }
        let head = Self::head(base)?;
        let [index] = <[Linear; 1]>::try_from(self.indices(indices)?).ok()?;
        let order = self.linear(&order)?;
        let minus = Fraction::from(MultiPoly::constant(-crate::math::number::Rational::one()));
        let member = |form: Linear| super::read::indexed_term(&head, vec![form]);
        if let Some(k) = order.as_constant() {
            let k = k.as_small().filter(|k| (0..=MAX_DIFFERENCE).contains(k))?;
            let terms = (0..=k).map(|j| {
                let (k, j) = (usize::try_from(k).unwrap_or(0), usize::try_from(j).unwrap_or(0));
                let c = Fraction::from(crate::math::number::Rational::from_integer(
                    crate::math::number::binomial(k, j),
                ));
                let sign = if (k - j) % 2 == 1 { minus.clone() } else { Fraction::one() };
                let shift = i64::try_from(j).unwrap_or(0);
                member(index.shifted(shift)).scaled(&(c * sign))
            });
            return Some(collected(terms));
        }
        let variable = self.fresh();
        self.integers.insert(variable.clone());
        let j = Linear::symbol(&variable);
        let mut term = self.binomial(&order, &j).times(&opaque_term(&head.to_string(), vec![index.plus(&j)]));
        term.multiply_power(&minus, &order.minus(&j))?;
        term.guards.extend([j.clone(), order.minus(&j)]);
        term.bound.insert(variable);
        Some(vec![term])
    }
}

/// The argument of a list t, …, t, also under a brace.
fn repeated(arguments: &[Expr]) -> Option<&Expr> {
    match arguments {
        [Expr { kind: Kind::Brace(inside, _), .. }] => repeated(inside),
        [first, Expr { kind: Kind::Ellipsis, .. }, last] => {
            let letter = matches!(first.kind, Kind::Name(_));
            (letter && first.same_as(last)).then_some(first)
        }
        _ => None,
    }
}
