//! Truncated powers: (x - j)_+^p is (x - j)^p where x - j >= 0, and 0 elsewhere.

use super::reader::Reader;
use super::token::Tok;
use crate::formula::{Accent, Expr, Kind, Link, Rel};
use crate::language::lexicon::letters::is_one_letter;

impl Reader<'_> {
    /// Takes the sign + of a truncated power, if it stands where an index would.
    pub(super) fn positive_part(&mut self) -> bool {
        match self.peek() {
            Some(Tok::Plus) => {
                self.bump();
                true
            }
            Some(Tok::OpenBrace) => {
                let Some(close) = self.partner(self.pos) else { return false };
                let inside: Vec<Tok> = (self.pos + 1..close)
                    .map(|at| self.tokens[at].kind)
                    .filter(|kind| *kind != Tok::Skip)
                    .collect();
                let alone = inside == [Tok::Plus];
                if alone {
                    self.pos = close + 1;
                }
                alone
            }
            _ => false,
        }
    }
}

/// Whether a formula can have a positive part: a variable, a number, a formula in brackets.
pub(super) fn may_be_truncated(base: &Expr) -> bool {
    match &base.kind {
        Kind::Group(_) | Kind::Number(_) => true,
        Kind::Name(name) => is_one_letter(name) && name.starts_with(char::is_lowercase),
        Kind::Accent(Accent::Bold, inner) => may_be_truncated(inner),
        _ => false,
    }
}

/// The truncated power of a formula.
pub(super) fn truncated(base: Expr, exponent: Option<Expr>) -> Kind {
    let span = base.span;
    let zero = || Expr::new(Expr::int(0).kind, span);
    let link = Link { rel: Rel::Ge, span, expr: zero() };
    let within = Expr::new(Kind::Chain(Box::new(base.clone()), vec![link]), span);
    let power = match exponent {
        Some(exponent) => Expr::new(Kind::Pow(Box::new(base), Box::new(exponent)), span),
        None => base,
    };
    Kind::Cases(vec![(power, Some(within)), (zero(), None)])
}
