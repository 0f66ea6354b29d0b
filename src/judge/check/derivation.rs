//! The operator of differentiation: D F, D^k F(x), (-D)^k F(x), D_x F(x, y).

use crate::formula::{Expr, Kind, Sign, Term};
use crate::judge::known::checker::Checker;
use crate::judge::page::statement::{Chain, Place};
use crate::judge::written::names::{Head, walk};

/// The letter of the operator.
const OPERATOR: &str = "D";

impl Checker {
    /// The chain with derivatives in the place of the operator, if the page does not call something else D.
    pub(in crate::judge) fn without_operator(&self, chain: &Chain, place: &Place) -> Option<Chain> {
        let own = || {
            self.context.visible(OPERATOR, place).next().is_some()
                || self.context.object_called(OPERATOR, place).is_some()
        };
        let occurs = chain.sides.iter().any(|side| side.expr.has(&is_operator));
        if !occurs || own() {
            return None;
        }
        let function = |letter: &str| {
            self.context.letters.functions.contains(letter)
                || self.context.object_called(letter, place).is_some()
        };
        let mut changed = chain.clone();
        for side in &mut changed.sides {
            differentiate(&mut side.expr, &function);
        }
        Some(changed)
    }
}

fn differentiate(expr: &mut Expr, function: &dyn Fn(&str) -> bool) {
    expr.for_each_child_mut(&mut |child| differentiate(child, function));
    let Kind::Mul(factors) = &mut expr.kind else { return };
    let mut at = 0;
    while at + 1 < factors.len() {
        if let Some(operator) = Operator::of(&factors[at])
            && let Some(derivative) = operator.applied_to(&factors[at + 1], function)
        {
            factors.splice(at..at + 2, derivative);
        }
        at += 1;
    }
    if let [only] = factors.as_slice() {
        *expr = only.clone();
    }
}

fn is_operator(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Name(name) if name == OPERATOR)
}

/// D, D^k, (-D)^k, D_x
struct Operator {
    negative: bool,
    times: Option<Expr>,
    variable: Option<Expr>,
}

impl Operator {
    fn of(expr: &Expr) -> Option<Operator> {
        match &expr.kind {
            _ if is_operator(expr) => Some(Operator { negative: false, times: None, variable: None }),
            Kind::Subscript(base, lower) if is_operator(base) => match lower.as_slice() {
                [variable @ Expr { kind: Kind::Name(_), .. }] => {
                    Some(Operator { negative: false, times: None, variable: Some(variable.clone()) })
                }
                _ => None,
            },
            Kind::Group(inner) => Operator::of(inner).filter(|inner| inner.times.is_none()),
            Kind::Add(terms) => match terms.as_slice() {
                [Term { sign: Sign::Minus, expr }] => Operator::of(expr)
                    .filter(|inner| !inner.negative)
                    .map(|inner| Operator { negative: true, ..inner }),
                _ => None,
            },
            Kind::Pow(base, times) => {
                let operator = Operator::of(base).filter(|operator| operator.times.is_none())?;
                Some(Operator { times: Some((**times).clone()), ..operator })
            }
            _ => None,
        }
    }

    /// The factors that stand for the derivative.
    fn applied_to(self, of: &Expr, function: &dyn Fn(&str) -> bool) -> Option<Vec<Expr>> {
        let head = Head::of(of).filter(|head| head.arguments.is_some() || function(&head.base))?;
        let span = of.span;
        let order = self.times.clone().unwrap_or_else(|| Expr::int(1));
        let derivative = match (&self.variable, &of.kind) {
            (Some(variable), _) => {
                let mut stands = false;
                head.flat()
                    .iter()
                    .for_each(|argument| walk(argument, &mut |part| stands |= part.same_as(variable)));
                stands.then(|| Kind::Derivative {
                    partial: head.flat().len() > 1,
                    variables: vec![(variable.clone(), self.times.clone())],
                    body: Some(Box::new(of.clone())),
                })?
            }
            (None, Kind::Apply(callee, groups)) if head.flat().len() == 1 => {
                Kind::Apply(Box::new(raised(callee, order.clone())), groups.clone())
            }
            (None, _) if head.arguments.is_none() => raised(of, order.clone()).kind,
            _ => return None,
        };
        let mut factors = vec![Expr::new(derivative, span)];
        if self.negative {
            let sign = Expr::from(Kind::Group(Box::new(Expr::int(-1)))).power(order);
            factors.insert(0, sign);
        }
        Some(factors)
    }
}

/// The derivative of a function, without its arguments.
fn raised(function: &Expr, order: Expr) -> Expr {
    match order.as_int() {
        Some(order @ 1..=3) => {
            Expr::new(Kind::Prime(Box::new(function.clone()), order as u32), function.span)
        }
        _ => Expr::new(Kind::Upper(Box::new(function.clone()), vec![order]), function.span),
    }
}
