//! A place within a line of Markdown, in bytes and in columns (tabs stop at every fourth).

use crate::formula::source::Pieces;

/// Walks over the marks at the beginning of a line.
#[derive(Clone)]
pub(super) struct Cursor<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    column: usize,
    /// Columns of a tab that were not asked for when it was passed.
    spare: usize,
}

impl<'a> Cursor<'a> {
    /// The line `start..end`.
    pub(super) fn new(text: &'a str, start: usize, end: usize) -> Self {
        Cursor { text, at: start, end, column: 0, spare: 0 }
    }

    pub(super) fn at(&self) -> usize {
        self.at
    }

    pub(super) fn end(&self) -> usize {
        self.end
    }

    pub(super) fn rest(&self) -> &'a str {
        self.text.piece(self.at..self.end)
    }

    pub(super) fn is_blank(&self) -> bool {
        self.rest().trim().is_empty()
    }

    fn peek(&self) -> Option<u8> {
        self.rest().bytes().next()
    }

    /// How many columns of white space stand here.
    pub(super) fn indent(&self) -> usize {
        let mut column = self.column;
        for byte in self.rest().bytes() {
            match byte {
                b' ' => column += 1,
                b'\t' => column += 4 - column % 4,
                _ => break,
            }
        }
        column - self.column + self.spare
    }

    /// Passes this many columns of white space; whether there were that many.
    pub(super) fn skip_columns(&mut self, columns: usize) -> bool {
        if self.indent() < columns {
            return false;
        }
        let mut left = columns.saturating_sub(self.spare);
        self.spare = self.spare.saturating_sub(columns);
        while left > 0 {
            let width = if self.peek() == Some(b'\t') { 4 - self.column % 4 } else { 1 };
            self.at += 1;
            self.column += width;
            self.spare = width.saturating_sub(left);
            left = left.saturating_sub(width);
        }
        true
    }

    pub(super) fn skip_spaces(&mut self) {
        let columns = self.indent();
        self.skip_columns(columns);
    }

    /// Passes ASCII that is no white space.
    fn skip_marks(&mut self, len: usize) {
        self.at += len;
        self.column += len;
        self.spare = 0;
    }

    /// Passes `>` and the space after it.
    pub(super) fn quotation_mark(&mut self) -> bool {
        let mut ahead = self.clone();
        if ahead.indent() >= 4 {
            return false;
        }
        ahead.skip_spaces();
        if ahead.peek() != Some(b'>') {
            return false;
        }
        ahead.skip_marks(1);
        ahead.skip_columns(1);
        *self = ahead;
        true
    }

    /// The mark and the length of a code fence.
    pub(super) fn fence(&self) -> Option<(u8, usize)> {
        let mark = self.peek().filter(|byte| matches!(byte, b'`' | b'~'))?;
        let rest = self.rest();
        let len = rest.bytes().take_while(|&byte| byte == mark).count();
        (len >= 3 && (mark == b'~' || !rest.piece(len..).contains('`'))).then_some((mark, len))
    }

    /// The level of a heading that begins with `#`, and the bytes of its text.
    pub(super) fn heading(&self) -> Option<(u8, crate::formula::source::Span)> {
        let rest = self.rest().trim_end();
        let level = rest.bytes().take_while(|&byte| byte == b'#').count();
        let text = rest.piece(level..);
        if !(1..=6).contains(&level) || !(text.is_empty() || text.starts_with([' ', '\t'])) {
            return None;
        }
        let start = self.at + level + (text.len() - text.trim_start().len());
        let bare = text.trim().trim_end_matches('#');
        let bare = if bare.is_empty() || bare.ends_with([' ', '\t']) { bare.trim_end() } else { text.trim() };
        Some((level as u8, crate::formula::source::Span::new(start, start + bare.len())))
    }

    /// A line of three or more `*`, `-` or `_`.
    pub(super) fn is_rule(&self) -> bool {
        let Some(mark) = self.peek().filter(|byte| matches!(byte, b'*' | b'-' | b'_')) else { return false };
        let rest = self.rest().trim_end();
        rest.bytes().filter(|&byte| byte == mark).count() >= 3
            && rest.bytes().all(|byte| byte == mark || matches!(byte, b' ' | b'\t'))
    }

    /// Passes the mark of a list item that was indented by `indent` columns: by how many columns
    /// its lines are indented. One that interrupts a paragraph has text and begins with 1.
    pub(super) fn list_mark(&mut self, indent: usize, interrupts: bool) -> Option<usize> {
        let rest = self.rest();
        let digits = rest.bytes().take(10).take_while(u8::is_ascii_digit).count();
        let len = match rest.as_bytes().get(digits)? {
            b'-' | b'*' | b'+' if digits == 0 => 1,
            // What a term means, in lists of definitions.
            b':' if digits == 0 && !rest.piece(1..).trim().is_empty() => 1,
            b'[' if digits == 0 && rest.starts_with("[^") => return self.footnote(indent),
            b'.' | b')' if (1..=9).contains(&digits) => digits + 1,
            _ => return None,
        };
        let text = rest.piece(len..);
        let blank = text.trim().is_empty();
        let separate = blank || text.starts_with([' ', '\t']);
        if !separate || (interrupts && (blank || (digits > 0 && rest.piece(..digits) != "1"))) {
            return None;
        }
        self.skip_marks(len);
        let spaces = self.indent();
        let spaces = if blank || spaces > 4 { 1 } else { spaces };
        self.skip_columns(spaces);
        Some(indent + len + spaces)
    }

    /// Passes the mark of a footnote, `[^name]:`; its further lines are indented by four columns.
    fn footnote(&mut self, indent: usize) -> Option<usize> {
        let close = self.rest().bytes().take(60).position(|byte| byte == b']')?;
        self.rest().piece(close + 1..).starts_with(':').then(|| {
            self.skip_marks(close + 2);
            self.skip_spaces();
            indent + 4
        })
    }

    /// The title of a note whose lines are indented: `!!! note "Title"` of Documenter and MkDocs,
    /// `??? note`, `=== "Tab"`.
    pub(super) fn admonition(&self) -> Option<crate::formula::source::Span> {
        let rest = self.rest().trim_end();
        let title = ["!!! ", "??? ", "???+ ", "=== \""].iter().find_map(|mark| rest.strip_prefix(mark))?;
        let start = self.at + rest.len() - title.len();
        title
            .starts_with(|c: char| c.is_alphanumeric())
            .then(|| crate::formula::source::Span::new(start, start + title.len()))
    }

    /// A fence of a division, `::: name` or `:::`: whether it closes one.
    pub(super) fn division(&self) -> Option<bool> {
        let rest = self.rest().trim_end();
        rest.starts_with(":::").then(|| rest.trim_matches(':').trim().is_empty())
    }
}
