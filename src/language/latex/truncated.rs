//! The sign of truncated powers: the + below (x - j)_+^p.

use super::reader::Reader;
use super::token::Tok;

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
