//! Letters side by side: a word, a name, or a product.

use super::Word;
use super::commands::{self, BARE_WORDS, CONNECTIVES};
use super::lexer::Lexer;
use super::token::Tok;
use crate::formula::source::Pieces;
use crate::language::lexicon::letters::is_ideograph;
use crate::language::lexicon::words;

impl Lexer<'_> {
    pub(super) fn letters(&mut self) {
        let length = self.run(|byte| byte.is_ascii_alphabetic());
        let word = self.rest().piece(..length);
        let (start, end) = (self.at, self.at + length);
        let content = (start as u32, end as u32);
        if words::is_sign_with_bounds(word, self.rest().piece(length..))
            && let Some(command) = commands::lookup(word)
        {
            let word = word.to_owned();
            return self.known(start, end, command.role(), &word);
        }
        if BARE_WORDS.contains(&word) {
            return self.push(Tok::Word(content.0, content.1), length);
        }
        if CONNECTIVES.contains(&word) && (length > 2 || self.stands_alone(length)) {
            return self.push(Tok::Text(content.0, content.1), length);
        }
        if length == 1 && self.joins_relations() {
            return self.push(Tok::Text(content.0, content.1), length);
        }
        // A name of several words such as polar_sum.
        let longest = self.run(|byte| byte.is_ascii_alphabetic() || byte == b'_');
        if longest > length
            && let Word::Name = self.meaning(longest)
        {
            return self.push(Tok::Word(content.0, (start + longest) as u32), longest);
        }
        if length > 1 {
            match self.meaning(length) {
                Word::Name => return self.push(Tok::Word(content.0, content.1), length),
                Word::Letters => {}
                // x_{max}
                Word::Refused(_) if self.is_whole_index(length) => {
                    return self.push(Tok::Text(content.0, content.1), length);
                }
                Word::Refused(problem) => return self.bad(start, end, *problem),
            }
        }
        for (offset, letter) in word.to_owned().char_indices() {
            self.push_from(start + offset, Tok::Letter(letter), start + offset + 1);
        }
    }

    /// Whether the letter here is a word between two relations, as its spaces say: a = 0\ e\ b = 1.
    fn joins_relations(&self) -> bool {
        let (before, after) = (self.text.piece(..self.at), self.rest().piece(1..));
        let spaced = before.ends_with("\\ ") && after.starts_with("\\ ");
        spaced && after.contains('=') && self.tokens.iter().any(|token| matches!(token.kind, Tok::Rel(_)))
    }

    /// Whether the word of `length` bytes here is all of an index.
    fn is_whole_index(&self, length: usize) -> bool {
        let mut before = self.tokens.iter().rev().map(|token| token.kind);
        before.next() == Some(Tok::OpenBrace)
            && before.next() == Some(Tok::Sub)
            && self.rest().piece(length..).trim_start().starts_with('}')
    }

    /// What the letters here are.
    fn meaning(&self, length: usize) -> Word {
        let (word, tail) = self.rest().split_at(length);
        let tail = tail.strip_prefix("\\left").unwrap_or(tail);
        (self.words)(word, tail.starts_with('('))
    }

    /// Whether a short word here (`if`, `or`, `by`) is set off from the formula, so that it is
    /// not a product of letters.
    fn stands_alone(&self, length: usize) -> bool {
        let tail = self.rest().piece(length..);
        let spaced = self.text.piece(..self.at).ends_with([' ', '\t']) && tail.starts_with([' ', '\t']);
        let begins = matches!(
            self.last(),
            None | Some(Tok::Comma | Tok::Gap | Tok::Align | Tok::RowBreak | Tok::Skip | Tok::Begin(_))
        );
        let after = tail.trim_start_matches([' ', '\t', '\\', '~']);
        (spaced || begins) && !after.starts_with(['(', '^', '_', '=', '+', '-', '<', '>', ',', '}', '\''])
    }

    /// Whether the word of `run` bytes here belongs to a name: `Bézier(n, t)`, `é(t)`. Ideographs stand beside names.
    pub(super) fn is_in_name(&self, run: usize) -> bool {
        let word = self.rest().piece(..run);
        let letter = |c: char| c.is_ascii_alphabetic();
        let before = self.text.piece(..self.at).ends_with(letter);
        let after =
            self.rest().piece(run..).starts_with(|c: char| letter(c) || matches!(c, '(' | '_' | '^' | '\''));
        word.chars().all(|c| c.is_alphabetic() && !is_ideograph(c))
            && (before || after || word.chars().count() == 1)
    }
}
