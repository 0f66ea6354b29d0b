//! Statements in words: `derivative of t^3`, `t^2 + 1 at t = 2`, `is f symmetric`.
//!
//! Words are not read. A word of prose that stands between blanks among factors is no product of its
//! letters either; the error names what the other words of the statement are called here.

use super::machine::Machine;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::{phrases, words};
use crate::math::poly::Symbol;

/// The phrase that two words side by side may be meant for.
fn misspelled_in(expr: &Expr) -> Option<&'static str> {
    if let Kind::Mul(factors) = &expr.kind {
        let word = |factor: &Expr| match &factor.kind {
            Kind::Name(word) => word.to_lowercase(),
            _ => String::new(),
        };
        let pairs = factors.windows(2).map(|pair| (word(&pair[0]), word(&pair[1])));
        if let Some(found) =
            pairs.into_iter().find_map(|(first, second)| phrases::misspelled(&first, &second))
        {
            return Some(found.trim_end_matches('~'));
        }
    }
    let mut children = Vec::new();
    expr.for_each_child(&mut |child| children.push(child));
    children.into_iter().find_map(misspelled_in)
}

impl Machine {
    /// Refuses a statement with a word of prose in it.
    pub(super) fn is_no_prose(&mut self, statement: &Expr) -> Result<(), Diagnostic> {
        if self.reading.is_some() {
            return Ok(());
        }
        let Some(word) = self.prose_in(statement) else { return Ok(()) };
        let Kind::Name(text) = &word.kind else { return Ok(()) };
        let mut error = Diagnostic::error(Code::UnknownName, format!("'{text}' is a word, not a formula"))
            .at(word.span)
            .reason("words are not read");
        if let Some(phrase) = misspelled_in(statement) {
            return Err(error.hint(format!("did you mean '{phrase}'?")));
        }
        let mut forms = Vec::new();
        self.forms_named_in(statement, &mut forms);
        // What the word itself asks for goes first: f(t) where t = 2.
        let advice =
            words::elsewhere(text).or_else(|| words::prose(text).filter(|advice| !advice.is_empty()));
        for form in forms.into_iter().take(2) {
            error = error.hint(format!("write {form}"));
        }
        if let Some(advice) = advice {
            error = error.hint(advice);
        }
        Err(match error.hints.is_empty() {
            true => error.hint("write a formula; polarform functions lists the functions"),
            false => error,
        })
    }

    /// The first word of prose that is a factor of its own, set off by blanks.
    fn prose_in<'a>(&self, expr: &'a Expr) -> Option<&'a Expr> {
        if let Kind::Mul(factors) = &expr.kind {
            for (at, factor) in factors.iter().enumerate() {
                let Kind::Name(word) = &factor.kind else { continue };
                let spaced = (at == 0 || factors[at - 1].span.end < factor.span.start)
                    && factors.get(at + 1).is_none_or(|next| factor.span.end < next.span.start);
                let known = self.lookup(&Symbol::new(word)).is_some();
                if spaced && !known && words::prose(word).is_some() {
                    return Some(factor);
                }
            }
        }
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        children.into_iter().find_map(|child| self.prose_in(child))
    }

    /// The forms of the functions that the words of a statement name.
    fn forms_named_in(&self, expr: &Expr, forms: &mut Vec<String>) {
        if let Kind::Name(word) = &expr.kind
            && word.len() > 2
            && self.lookup(&Symbol::new(word)).is_none()
        {
            let word = &word.to_lowercase();
            let singular = word.strip_suffix('s').unwrap_or(word);
            let form = |name: &str| {
                let function = (self.tools.function)(name)
                    .or_else(|| (self.tools.synonym)(name).and_then(|known| (self.tools.function)(known)));
                words::form(name).map(str::to_owned).or_else(|| function.map(|function| function.form()))
            };
            let found = match words::topic(word) {
                Some(function) => form(function),
                None => form(word).or_else(|| form(singular)),
            };
            forms.extend(found.filter(|found| !forms.contains(found)));
        }
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        children.into_iter().for_each(|child| self.forms_named_in(child, forms));
    }
}
