//! Sums whose bounds are symbols: of a polynomial in the index the sum is a polynomial in the bounds.

use super::machine::Machine;
use super::names::name_of;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::ops::arithmetic;
use crate::language::value::{Value, polynomial_expr};
use crate::language::write::text;
use crate::math::number::integer;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::One;

impl Machine {
    /// Σ p(k) for k from a to b, where an answer is asked for and p is a polynomial in k: with the differences
    /// Δ^j p(0) it is Σ_j Δ^j p(0) (C(b + 1, j + 1) − C(a, j + 1)). A note says for which bounds it holds. `None` if
    /// both bounds are numbers, or if this is no such sum.
    ///
    /// Cost: d + 1 values of p for the degree d, and d²/2 differences.
    ///
    /// # Errors
    /// Those of the bounds.
    ///
    /// **Reference.** Graham, Knuth, Patashnik, *Concrete Mathematics* (1994), sections 2.6 and 5.3.
    pub(super) fn closed_sum(
        &mut self,
        lower: &[Expr],
        upper: Option<&Expr>,
        body: &Expr,
        span: Span,
    ) -> Result<Option<Value>, Diagnostic> {
        if !self.answers || self.has_reading() {
            return Ok(None);
        }
        let [Expr { kind: Kind::Chain(index, links), .. }] = lower else { return Ok(None) };
        let [Link { rel: Rel::Eq, expr: from, .. }] = links.as_slice() else { return Ok(None) };
        let (from, to) = match (&from.kind, upper) {
            (Kind::Range(from, to), _) => (from.as_ref(), to.as_ref()),
            (_, Some(to)) => (from, to),
            (_, None) => return Ok(None),
        };
        let Some(index) = name_of(index, self) else { return Ok(None) };
        let (Value::Scalar(from), Value::Scalar(to)) = (self.eval(from)?, self.eval(to)?) else {
            return Ok(None);
        };
        let number = |bound: &Fraction| bound.as_rational().is_some();
        let free = |bound: &Fraction| bound.as_polynomial().is_some() && !bound.variables().contains(&index);
        if number(&from) && number(&to) || !free(&from) || !free(&to) {
            return Ok(None);
        }
        let Some(term) = self.formula_in(&index, body) else { return Ok(None) };
        if term.denominator().variables().contains(&index) {
            return Ok(None);
        }
        let degree = term.numerator().degree_in(&index) as usize;
        crate::budget::charge_terms((degree as u64 + 1).saturating_mul(degree as u64 + 1));
        let at = |k: usize| term.substitute(&[(index.clone(), Fraction::from(integer(k as i64)))]).ok();
        let Some(mut differences) = (0..=degree).map(at).collect::<Option<Vec<Fraction>>>() else {
            return Ok(None);
        };
        for order in 1..=degree {
            for k in (order..=degree).rev() {
                differences[k] = differences[k].minus(&differences[k - 1]);
            }
        }
        let after = Value::Scalar(to.plus(&Fraction::one()));
        let before = Value::Scalar(from.clone());
        let mut sum = Value::int(0);
        for (j, difference) in differences.into_iter().enumerate() {
            let order = Value::int(j as i64 + 1);
            let start = arithmetic::negate(arithmetic::binomial(&before, &order)?)?;
            let count = arithmetic::add(arithmetic::binomial(&after, &order)?, start)?;
            sum = arithmetic::add(sum, arithmetic::multiply(Value::Scalar(difference), count)?)?;
        }
        let shown = |bound: &Fraction| text(&polynomial_expr(bound));
        let note = format!("for integers {} >= {}", shown(&to), shown(&from.minus(&Fraction::one())));
        self.note(Diagnostic::note(Code::SymbolicBounds, note).at(span));
        Ok(Some(sum))
    }

    /// A body as a formula in a name, if arithmetic is all that happens to the name there: floor(k/2) and b_k are not
    /// what they are for the symbol k.
    pub(super) fn formula_in(&mut self, name: &Symbol, body: &Expr) -> Option<Fraction> {
        if !self.is_arithmetic_in(name, body) {
            return None;
        }
        let own = (name.clone(), Value::symbol(name.clone()));
        match self.with_locals([own], |machine| machine.eval(body)) {
            Ok(Value::Scalar(formula)) => Some(formula),
            _ => None,
        }
    }

    fn is_arithmetic_in(&mut self, name: &Symbol, expr: &Expr) -> bool {
        if !self.occurs(name, expr) {
            return true;
        }
        match &expr.kind {
            Kind::Name(_) | Kind::Group(_) | Kind::Add(_) | Kind::Mul(_) | Kind::Div(..) => {}
            Kind::Pow(_, fixed) | Kind::Binomial(_, fixed, _) if !self.occurs(name, fixed) => {}
            Kind::Apply(callee, _) if self.is_formula(name, callee) => {}
            _ => return false,
        }
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        children.into_iter().all(|child| self.is_arithmetic_in(name, child))
    }

    /// Whether a name stands somewhere in an expression, also as a letter of a product.
    fn occurs(&mut self, name: &Symbol, expr: &Expr) -> bool {
        let letter = matches!(&expr.kind, Kind::Name(word)
            if word.contains(name.base()) && self.is_product_of_letters(word));
        if letter || name_of(expr, self).as_ref() == Some(name) {
            return true;
        }
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        children.into_iter().any(|child| self.occurs(name, child))
    }

    /// Whether what stands before a parenthesis is a factor, or a function by one formula.
    fn is_formula(&mut self, name: &Symbol, callee: &Expr) -> bool {
        let Some(symbol) = name_of(callee, self) else { return false };
        if symbol == *name {
            return true;
        }
        match self.lookup(&symbol) {
            Some(Value::Function(function)) => function.as_formula_of_many().is_some(),
            Some(Value::Scalar(_)) => true,
            Some(_) => false,
            None => symbol.is_plain() && (self.tools.function)(symbol.base()).is_none(),
        }
    }
}
