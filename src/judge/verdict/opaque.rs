//! Values that are not computed here: √(x² + 1), e^x, |x|, sin x, ‖v‖.
//!
//! **Rule.** An equation that holds whatever numbers stand in their places holds. Equal arguments give equal values,
//! e^{a + b} is e^a e^b, and (√a)² is a; no other law is used, and nothing is refuted by them.

use crate::formula::{Expr, Kind, Quotient, Rel, Sign, Term};
use crate::judge::instances::setting::Setting;
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::statement::{Chain, Statement};
use crate::judge::values::consequences::private;
use crate::judge::verdict::relation::Judged;
use crate::judge::written::names::{bases, is_index_letter, walk};
use crate::language::lexicon::words;
use crate::math::number::{Rational, integer};
use num_traits::{Signed, ToPrimitive};

impl Checker {
    /// The verdict on an equation with such values, if it holds whatever they are.
    pub(in crate::judge) fn with_any_values(
        &self,
        setting: &Setting,
        at: usize,
        statement: &Statement,
    ) -> Option<Finding> {
        let rel = setting.chain.relations[at];
        let sides = &setting.chain.sides[at..at + 2];
        if rel.0 != Rel::Eq || !sides.iter().all(|side| is_algebraic(&side.expr)) {
            return None;
        }
        let mut values = Vec::new();
        let mut put = sides.to_vec();
        put.iter_mut().for_each(|side| replace(&mut side.expr, &mut values));
        let unchanged = put.iter().zip(sides).all(|(new, old)| new.expr == old.expr);
        // An index of a sum within would have another value in each term.
        let inner: Vec<String> = values.iter().flat_map(bases).collect();
        if unchanged || sides.iter().any(|side| binds(&side.expr, &inner)) {
            return None;
        }
        let chain = Chain { sides: put, relations: vec![rel], ..setting.chain.clone() };
        let setting = self.setting(&chain, &statement.place, setting.curve.clone());
        let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
        let attempt = self.attempts(&setting, &sides, &[rel.0]);
        let tally = &attempt.outcomes.tallies[0];
        match self.verdict(tally, &attempt, &setting, 0, statement, None) {
            Judged::Verdict(mut finding) if matches!(finding.verdict, Verdict::Proved | Verdict::Sampled) => {
                finding.notes.push("it holds whatever the values are that are not computed here".to_owned());
                Some(*finding)
            }
            _ => None,
        }
    }
}

/// Whether it is free of limits, derivatives, integrals and whatever else looks into its parts.
fn is_algebraic(expr: &Expr) -> bool {
    !expr.has(&|part| {
        matches!(
            part.kind,
            Kind::Derivative { .. }
                | Kind::Prime(..)
                | Kind::Integral { .. }
                | Kind::At { .. }
                | Kind::Lambda(..)
                | Kind::Compose(..)
                | Kind::Cases(..)
                | Kind::Matrix(..)
                | Kind::Ellipsis
                | Kind::Unread(_)
        )
    })
}

/// Whether a sum or product runs over one of these names.
fn binds(expr: &Expr, names: &[String]) -> bool {
    expr.has(&|part| match &part.kind {
        Kind::Big { lower, .. } => lower.iter().flat_map(bases).any(|name| names.contains(&name)),
        _ => false,
    })
}

/// Puts a name in the place of each value that is not computed; equal values get one name.
fn replace(expr: &mut Expr, values: &mut Vec<Expr>) {
    match &mut expr.kind {
        Kind::Subscript(..) | Kind::Upper(..) => return,
        Kind::Pow(base, exponent) => {
            if let (Some(inside), Some(half)) = (square_root(base), half_of(exponent)) {
                let (inside, half) = (inside.clone(), Expr::new(Kind::Number(integer(half)), exponent.span));
                expr.kind = Kind::Pow(Box::new(inside), Box::new(half));
                return replace(expr, values);
            }
            if is_positive(base) && is_real(exponent) {
                let product = terms(exponent).into_iter().map(|term| power(base, term, values)).collect();
                expr.kind = Kind::Mul(product);
                if let Kind::Mul(factors) = &mut expr.kind
                    && factors.len() == 1
                {
                    *expr = factors.remove(0);
                }
                return;
            }
        }
        Kind::Enclosed(..) => return *expr = named(expr, values),
        Kind::Apply(callee, _) if matches!(&callee.kind, Kind::Name(name) if words::is_function_word(name)) =>
        {
            return *expr = named(expr, values);
        }
        _ => {}
    }
    expr.for_each_child_mut(&mut |child| replace(child, values));
}

fn named(value: &Expr, values: &mut Vec<Expr>) -> Expr {
    let at = values.iter().position(|known| known.same_as(value)).unwrap_or_else(|| {
        values.push(value.clone());
        values.len() - 1
    });
    Expr::new(Kind::Name(private(at)), value.span)
}

fn square_root(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        Kind::Group(inner) => square_root(inner),
        Kind::Apply(callee, groups) => match (&callee.kind, groups.as_slice()) {
            (Kind::Name(name), [group]) if name == "sqrt" && group.len() == 1 => group.first(),
            _ => None,
        },
        _ => None,
    }
}

fn half_of(exponent: &Expr) -> Option<i64> {
    exponent.as_signed_int().filter(|power| *power > 0 && power % 2 == 0).map(|power| power / 2)
}

/// Whether a power of it is one of a number, not of a matrix or a function.
fn is_positive(base: &Expr) -> bool {
    match &base.kind {
        Kind::Number(q) => q.is_positive(),
        Kind::Name(name) => !name.starts_with(char::is_uppercase),
        _ => false,
    }
}

/// Whether an exponent is made of numbers and of letters for real ones, so that no integer is put for it.
fn is_real(exponent: &Expr) -> bool {
    let names = bases(exponent);
    let mut sound = true;
    let mut fraction = false;
    walk(exponent, &mut |part| match &part.kind {
        Kind::Number(q) => fraction |= !q.is_integer(),
        Kind::Div(..) => fraction = true,
        Kind::Name(_) | Kind::Add(_) | Kind::Mul(_) | Kind::Group(_) => {}
        _ => sound = false,
    });
    let real = |name: &String| !is_index_letter(name) && !name.starts_with(char::is_uppercase);
    sound && names.iter().all(real) && (fraction || !names.is_empty())
}

fn terms(exponent: &Expr) -> Vec<Term> {
    match &exponent.kind {
        Kind::Group(inner) => terms(inner),
        Kind::Add(terms) => terms.clone(),
        _ => vec![Term { sign: Sign::Plus, expr: exponent.clone() }],
    }
}

/// A power with one term as its exponent: e^{-2x} is 1/(e^x)^2.
fn power(base: &Expr, term: Term, values: &mut Vec<Expr>) -> Expr {
    let span = term.expr.span;
    let number = |q: Rational| Expr::new(Kind::Number(q), span);
    let (count, rest) = match &term.expr.kind {
        Kind::Number(q) if q.is_integer() => (q.to_i64(), None),
        Kind::Mul(factors) => match &factors[0].kind {
            Kind::Number(q) if q.is_integer() => {
                let rest = factors[1..].to_vec();
                let rest = if rest.len() == 1 { rest[0].clone() } else { Expr::new(Kind::Mul(rest), span) };
                (q.to_i64(), Some(rest))
            }
            _ => (Some(1), Some(term.expr.clone())),
        },
        _ => (Some(1), Some(term.expr.clone())),
    };
    let value = |rest: Expr, values: &mut Vec<Expr>| {
        named(&Expr::new(Kind::Pow(Box::new(base.clone()), Box::new(rest)), span), values)
    };
    let (value, count) = match (count, rest) {
        (Some(count), Some(rest)) => (value(rest, values), count),
        (Some(count), None) => (base.clone(), count),
        (None, _) => (value(term.expr.clone(), values), 1),
    };
    let power = Expr::new(Kind::Pow(Box::new(value), Box::new(number(integer(count)))), span);
    match term.sign {
        Sign::Minus => {
            Expr::new(Kind::Div(Box::new(number(integer(1))), Box::new(power), Quotient::Slash), span)
        }
        _ => power,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{latex, write};

    fn after(formula: &str) -> String {
        let mut expr = latex::read(formula).unwrap();
        replace(&mut expr, &mut Vec::new());
        write::text(&expr)
    }

    #[test]
    fn values_that_are_not_computed_get_names() {
        assert_eq!(after(r"|x| + 2 |x| + |y|"), "\u{e000} + 2 \u{e000} + \u{e001}");
        assert_eq!(after(r"e^{x + 1}"), after(r"e^x \cdot e^1"));
        assert_eq!(after(r"\sqrt{x^2 + 1}^2"), "(x^2 + 1)^1");
        // These are powers as others, or no numbers.
        for formula in [r"x^{n+1}", r"A^H", r"x^2", r"2^{-3}"] {
            assert_eq!(after(formula), write::text(&latex::read(formula).unwrap()));
        }
    }
}
