//! What stands within a paragraph of reStructuredText: words, formulas, literals, other roles.

use super::collect::Collector;
use super::signs::{display_end, inline_end, is_currency};
use crate::document::Style;
use crate::formula::source::{Pieces, Span};

/// Takes the text of a paragraph apart; it stands at byte `start` of the file. `words`: whether they count.
pub(super) fn scan(text: &str, start: usize, words: bool, out: &mut Collector) {
    let mut inline =
        Inline { text, start, words, out, said: 0, after_formula: false, no_close: [usize::MAX; 2] };
    let mut at = 0;
    while let Some(found) = text.piece(at..).find(['\\', '`', '$', '|']) {
        at += found;
        at = match text.as_bytes()[at] {
            b'\\' => at + 1 + text.piece(at + 1..).chars().next().map_or(0, char::len_utf8),
            b'`' => inline.backquote(at),
            b'$' => inline.dollar(at),
            _ => inline.substitution(at),
        };
    }
    inline.say(text.len());
}

struct Inline<'a> {
    text: &'a str,
    start: usize,
    words: bool,
    out: &'a mut Collector,
    /// Up to where everything was said.
    said: usize,
    after_formula: bool,
    /// From where on no single and no double backquote closes.
    no_close: [usize; 2],
}

impl Inline<'_> {
    fn say(&mut self, at: usize) {
        if self.words && self.said < at {
            self.out.prose(self.text.piece(self.said..at), self.start + self.said, self.after_formula);
        }
        self.said = self.said.max(at);
        self.after_formula = false;
    }

    fn skip(&mut self, from: usize, to: usize) -> usize {
        self.say(from);
        self.said = to;
        to
    }

    fn formula(&mut self, style: Style, text: Span, from: usize, to: usize) -> usize {
        self.say(from);
        self.out.formula(style, self.text.piece(text.range()), self.start + text.start);
        self.said = to;
        self.after_formula = true;
        to
    }

    fn close(&mut self, from: usize, mark: &str) -> Option<usize> {
        let which = mark.len() - 1;
        if from >= self.no_close[which] {
            return None;
        }
        let mut at = from;
        while let Some(found) = self.text.piece(at..).find(mark) {
            let escaped =
                self.text.piece(..at + found).bytes().rev().take_while(|&byte| byte == b'\\').count() % 2
                    == 1;
            // In a formula a backslash before the last sign is one of LaTeX: `\,`.
            if found > 0 && !(escaped && mark == "`" && self.text.piece(at + found + 1..).contains('`')) {
                return Some(at + found);
            }
            at += found + mark.len();
        }
        self.no_close[which] = from;
        None
    }

    fn backquote(&mut self, at: usize) -> usize {
        if self.text.piece(at..).starts_with("``") {
            return match self.close(at + 2, "``") {
                Some(end) => {
                    let more = self.text.piece(end + 2..).bytes().take_while(|&byte| byte == b'`').count();
                    self.skip(at, end + 2 + more)
                }
                None => at + 2,
            };
        }
        let Some(end) = self.close(at + 1, "`") else {
            if self.text.piece(..at).ends_with(":math:") {
                self.out.unclosed(":math:`", self.start + at - ":math:".len(), "`");
            }
            return at + 1;
        };
        let content = Span::new(at + 1, end);
        let before = self.text.piece(self.said..at);
        let role = before.ends_with(':').then(|| role_before(before)).flatten();
        let after = self.text.piece(end + 1..);
        match role {
            Some("math") => self.formula(Style::Inline, content, at - ":math:".len(), end + 1),
            Some(role) => self.skip(at - role.len() - 2, end + 1),
            None if after.starts_with(":math:") => {
                self.formula(Style::Inline, content, at, end + 1 + ":math:".len())
            }
            None if self.out.default_role && !after.starts_with('_') => {
                self.formula(Style::Inline, content, at, end + 1)
            }
            None => self.skip(at, end + 1),
        }
    }

    /// `$…$`, which some projects read as formulas.
    fn dollar(&mut self, at: usize) -> usize {
        if self.text.piece(at..).starts_with("$$") {
            return match display_end(self.text, at + 2, "$$", false) {
                Some(end) => self.formula(Style::Display, Span::new(at + 2, end), at, end + 2),
                None => at + 2,
            };
        }
        match inline_end(self.text, at).filter(|_| !is_currency(self.text, at)) {
            Some(end) => self.formula(Style::Inline, Span::new(at + 1, end), at, end + 1),
            None => at + 1,
        }
    }

    /// `|name|` stands for something else.
    fn substitution(&mut self, at: usize) -> usize {
        let name = self.text.piece(at + 1..);
        let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | ' ' | '.');
        let len = name.chars().take(60).take_while(|&c| plain(c)).map(char::len_utf8).sum::<usize>();
        let tight = len > 0 && !name.starts_with(' ') && !name.piece(..len).ends_with(' ');
        if tight && name.piece(len..).starts_with('|') { self.skip(at, at + len + 2) } else { at + 1 }
    }
}

/// The name of the role at the end: `see :py:func:`, `3-by-:math:`.
fn role_before(before: &str) -> Option<&str> {
    let inner = before.strip_suffix(':')?;
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.' | ':' | '+');
    let start = inner
        .rfind(|c: char| !plain(c))
        .map_or(0, |at| at + inner.piece(at..).chars().next().map_or(1, char::len_utf8));
    let (_, name) = inner.piece(start..).split_once(':')?;
    name.starts_with(|c: char| c.is_ascii_alphanumeric()).then_some(name)
}
