//! Derivatives written as quotients: `d/dt (t^2)`, `dF/dt`, `d^2/dt^2 F(t)`.

use super::machine::Machine;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::lexicon::letters::is_one_letter;
use crate::math::poly::Symbol;

/// `d/dt`, with what is differentiated if it stands in the quotient.
struct Quotient {
    variable: Expr,
    order: Option<Expr>,
    body: Option<Expr>,
}

impl Machine {
    /// The derivative that a product stands for whose first factor is `d/dt`.
    pub(super) fn differential(&self, factors: &[Expr], span: Span) -> Option<Expr> {
        let (Expr { kind: Kind::Div(above, below, _), .. }, rest) = factors.split_first()? else {
            return None;
        };
        let (quotient, rest) = match (self.quotient_of(above, below), rest) {
            (Some(quotient), _) if quotient.body.is_none() => (quotient, rest),
            // In LaTeX, d/dt is d/d before t.
            (None, [variable, rest @ ..]) if self.is_d(above) && self.is_d(below) => {
                let (variable, body) = match &variable.kind {
                    Kind::Apply(name, groups) => match groups.as_slice() {
                        [group] if group.len() == 1 => (name.as_ref(), Some(group[0].clone().grouped())),
                        _ => return None,
                    },
                    _ => (variable, None),
                };
                let touches = below.span.end == variable.span.start;
                if !touches || !matches!(&variable.kind, Kind::Name(name) if is_one_letter(name)) {
                    return None;
                }
                let quotient = Quotient { variable: variable.clone(), order: None, body: None };
                if let Some(first) = body {
                    let mut factors = vec![first];
                    factors.extend_from_slice(rest);
                    return Some(derivative(quotient, Expr::product(factors), span));
                }
                (quotient, rest)
            }
            _ => return None,
        };
        let body = match rest {
            [] => return None,
            [only] => only.clone(),
            [first, .., last] => Expr::new(Kind::Mul(rest.to_vec()), first.span.to(last.span)),
        };
        Some(derivative(quotient, body, span))
    }

    /// The derivative that a product stands for whose first factor is ∂_u.
    pub(super) fn partial(&self, factors: &[Expr], span: Span) -> Option<Expr> {
        let (operator, rest) = factors.split_first()?;
        let variables = self.variables_of_partial(operator).filter(|_| !rest.is_empty())?;
        let body = Some(Box::new(Expr::product(rest.to_vec())));
        Some(Expr::new(Kind::Derivative { partial: true, variables, body }, span))
    }

    /// u of ∂_u, u and v of ∂_{uv}.
    fn variables_of_partial(&self, operator: &Expr) -> Option<Vec<(Expr, Option<Expr>)>> {
        let Kind::Subscript(sign, indices) = &operator.kind else { return None };
        let is_sign = matches!(&sign.kind, Kind::Name(name) if name == "partial");
        if !is_sign || self.lookup(&Symbol::new("partial")).is_some() {
            return None;
        }
        let letters = indices.iter().flat_map(|index| match &index.kind {
            Kind::Mul(letters) => letters.as_slice(),
            _ => std::slice::from_ref(index),
        });
        let variable = |letter: &Expr| {
            matches!(&letter.kind, Kind::Name(name) if is_one_letter(name)).then(|| (letter.clone(), None))
        };
        letters.map(variable).collect()
    }

    /// The derivative that a quotient stands for: `dF/dt`, `d/dt(t^2)`.
    pub(super) fn differential_quotient(&self, above: &Expr, below: &Expr) -> Option<Expr> {
        let mut quotient = self.quotient_of(above, below)?;
        let body = quotient.body.take()?;
        Some(derivative(quotient, body, above.span.to(below.span)))
    }

    fn quotient_of(&self, above: &Expr, below: &Expr) -> Option<Quotient> {
        // d, d^2, or dF
        let (order, mut body) = match &above.kind {
            Kind::Pow(base, order) => (Some(order.as_ref().clone()), self.after_d(base)?),
            // d^2F, d^2 F(t)
            Kind::Mul(factors) if factors.len() == 2 => match &factors[0].kind {
                Kind::Pow(base, order) if self.is_d(base) => {
                    (Some(order.as_ref().clone()), Some(factors[1].clone()))
                }
                _ => return None,
            },
            Kind::Apply(callee, groups) => {
                let body = self.after_d(callee)??;
                (None, Some(Expr::new(Kind::Apply(Box::new(body), groups.clone()), above.span)))
            }
            _ => (None, self.after_d(above)?),
        };
        // dt, dt^2, or dt(…)
        let (power, argument) = match &below.kind {
            Kind::Apply(callee, groups) => match groups.as_slice() {
                [group] if group.len() == 1 && body.is_none() => (callee.as_ref(), Some(group[0].clone())),
                _ => return None,
            },
            _ => (below, None),
        };
        let name = match (&power.kind, &order) {
            (Kind::Pow(base, below), Some(above)) if below.same_as(above) => base.as_ref(),
            (_, None) => power,
            _ => return None,
        };
        let variable = self.after_d(name)??;
        // The differential of what has no value is no derivative.
        if matches!(&body, Some(Expr { kind: Kind::Name(name), .. }) if self.lookup(&Symbol::new(name)).is_none())
        {
            return None;
        }
        body = body.or(argument);
        Some(Quotient { variable, order, body })
    }

    fn is_d(&self, expr: &Expr) -> bool {
        matches!(self.after_d(expr), Some(None))
    }

    /// What follows the d of a differential: nothing for `d` alone.
    fn after_d(&self, expr: &Expr) -> Option<Option<Expr>> {
        let Kind::Name(word) = &expr.kind else { return None };
        if self.lookup(&Symbol::new(word)).is_some() || self.lookup(&Symbol::new("d")).is_some() {
            return None;
        }
        match word.strip_prefix('d')? {
            "" => Some(None),
            name if is_one_letter(name) => {
                let span = Span::new((expr.span.start + 1).min(expr.span.end), expr.span.end);
                Some(Some(Expr::new(Kind::Name(name.to_owned()), span)))
            }
            _ => None,
        }
    }
}

fn derivative(quotient: Quotient, body: Expr, span: Span) -> Expr {
    let variables = vec![(quotient.variable, quotient.order)];
    let whole = Kind::Derivative { partial: false, variables, body: Some(Box::new(body)) };
    Expr::new(whole, span)
}
