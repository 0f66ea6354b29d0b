//! The blocks of reStructuredText: sections, paragraphs, lists, tables, directives, comments.
//!
//! Indentation says what belongs to what. A line is compared with the columns of the blocks that are open;
//! those that it does not reach end. Time and space are linear in the length of the text.
//!
//! Reference: the reStructuredText markup specification of Docutils; `math` as in Sphinx, where blank lines
//! separate equations.

use std::ops::Range;

use super::collect::Collector;
use super::directives::{self, Content, is_option, without_options};
use super::rst_inline;
use super::signs::line_at;
use crate::document::{Enclosure, Item, Style};
use crate::formula::source::{Pieces, Span};

/// Takes a part of a text apart.
pub(super) fn scan(text: &str, range: Range<usize>, out: &mut Collector) {
    let mut lines = Vec::new();
    let mut at = range.start;
    while at < range.end {
        let len = line_at(text, at).len().min(range.end - at);
        lines.push(Line::new(text, at, at + len));
        at += len + 1;
    }
    let mut rst = Rst { text, lines, out, open: Vec::new(), paragraph: Vec::new(), levels: Vec::new() };
    let mut line = 0;
    while line < rst.lines.len() {
        line = rst.line(line);
    }
    rst.end_paragraph();
    rst.close(0);
}

/// Deeper blocks are taken for text.
const MAX_NESTING: usize = 100;

/// Marks that underline titles.
const UNDERLINES: &str = "=-`:.'\"~^_*+#<>!$%&(),/;?@[\\]{|}";

#[derive(Clone, Copy)]
struct Line {
    /// Its first byte that is no white space.
    start: usize,
    /// The byte after its last one that is none.
    end: usize,
    /// The column where it starts; tabs stop at every eighth.
    column: usize,
}

impl Line {
    fn new(text: &str, start: usize, end: usize) -> Self {
        let mut column = 0;
        let mut at = start;
        for byte in text.piece(start..end).bytes() {
            match byte {
                b' ' => column += 1,
                b'\t' => column += 8 - column % 8,
                _ => break,
            }
            at += 1;
        }
        let end = at + text.piece(at..end).trim_end().len();
        Line { start: at, end, column }
    }

    fn is_blank(self) -> bool {
        self.start == self.end
    }

    fn span(self) -> Span {
        Span::new(self.start, self.end)
    }
}

/// A block whose lines stand in this column or further to the right.
struct Open {
    column: usize,
    what: Enclosure,
}

struct Rst<'a> {
    text: &'a str,
    lines: Vec<Line>,
    out: &'a mut Collector,
    open: Vec<Open>,
    /// The lines of the paragraph.
    paragraph: Vec<Line>,
    /// Marks of titles, with whether they also stand above, by level.
    levels: Vec<(u8, bool)>,
}

impl<'a> Rst<'a> {
    fn at(&self, line: usize) -> &'a str {
        let text = self.text;
        self.lines.get(line).map_or("", |line| text.piece(line.start..line.end))
    }

    /// Takes the line apart, with those that belong to it; the next one.
    fn line(&mut self, at: usize) -> usize {
        let line = self.lines[at];
        if line.is_blank() {
            self.end_paragraph();
            return at + 1;
        }
        if !self.paragraph.is_empty() {
            if let Some(level) = self.underline(at) {
                return level;
            }
            if self.paragraph.last().is_some_and(|last| last.column == line.column) && !self.is_row(at) {
                self.paragraph.push(line);
                return at + 1;
            }
            self.end_paragraph();
        }
        let keep = self.open.iter().take_while(|open| open.column <= line.column).count();
        self.close(keep);
        if let Some(next) = self.overlined(at) {
            return next;
        }
        let text = self.at(at);
        if is_line_of_marks(text) && text.len() >= 4 {
            // A line between paragraphs.
            return at + 1;
        }
        if text == ".." && self.lines.get(at + 1).is_none_or(|next| next.is_blank()) {
            // It ends the block before.
            return at + 1;
        }
        if text == ".." || text.starts_with(".. ") {
            return self.explicit(at);
        }
        if text.starts_with("__ ") || text.starts_with(">>> ") {
            return (at..self.lines.len()).find(|&at| self.lines[at].is_blank()).unwrap_or(self.lines.len());
        }
        if is_border(text) {
            return at + 1;
        }
        if self.is_row(at) {
            self.row(at);
            return at + 1;
        }
        if let Some(len) = list_mark(text).filter(|_| self.open.len() < MAX_NESTING) {
            let rest = text.piece(len..).trim_start();
            let shift = text.len() - rest.len();
            self.out.enter(Enclosure::Item);
            self.open.push(Open { column: line.column + 1, what: Enclosure::Item });
            self.lines[at] = Line { start: line.start + shift, column: line.column + shift, ..line };
            return if rest.is_empty() { at + 1 } else { self.line(at) };
        }
        self.paragraph.push(line);
        at + 1
    }

    /// The heading whose text is the paragraph, if the line underlines it.
    fn underline(&mut self, at: usize) -> Option<usize> {
        let text = self.at(at);
        let [title] = self.paragraph[..] else { return None };
        let long = text.len() >= 4
            || text.chars().count() >= self.text.piece(title.start..title.end).chars().count();
        if !is_line_of_marks(text) || !long || self.lines[at].column != title.column {
            return None;
        }
        self.paragraph.clear();
        self.heading(text.as_bytes()[0], false, title);
        Some(at + 1)
    }

    /// A title with a line above and below.
    fn overlined(&mut self, at: usize) -> Option<usize> {
        let (over, under) = (self.at(at), self.at(at + 2));
        let title = *self.lines.get(at + 1)?;
        let fits = over.len() >= 2 && is_line_of_marks(over) && over == under && !title.is_blank();
        if !fits || is_line_of_marks(self.at(at + 1)) {
            return None;
        }
        self.heading(over.as_bytes()[0], true, title);
        Some(at + 3)
    }

    fn heading(&mut self, mark: u8, over: bool, title: Line) {
        self.close(0);
        let known = self.levels.iter().position(|&level| level == (mark, over));
        let level = known.unwrap_or_else(|| {
            self.levels.push((mark, over));
            self.levels.len() - 1
        });
        self.out.push(Item::Heading { level: (level + 1).min(6) as u8, span: title.span() });
        rst_inline::scan(self.text.piece(title.start..title.end), title.start, false, self.out);
        self.out.end_paragraph();
    }

    /// A row of a table, or a line of a line block.
    fn is_row(&self, at: usize) -> bool {
        self.at(at).starts_with("| ")
    }

    fn row(&mut self, at: usize) {
        let line = self.lines[at];
        let cells = self.at(at);
        let table = cells.ends_with('|') && cells.len() > 1;
        if table {
            self.out.enter(Enclosure::Row);
        }
        rst_inline::scan(
            self.text.piece(line.start + 1..line.end - usize::from(table)),
            line.start + 1,
            true,
            self.out,
        );
        if table {
            self.out.end_row();
        } else {
            self.out.end_paragraph();
        }
    }

    /// The line after the block whose first line is `at`: those that are further to the right belong to it.
    fn block_end(&self, at: usize) -> usize {
        let column = self.lines[at].column;
        let inside = |line: &Line| line.is_blank() || line.column > column;
        let lines = self.lines[at + 1..].iter().take_while(|line| inside(line)).count();
        at + 1 + lines
    }

    /// What begins with two dots: a directive, footnote, target, substitution or comment.
    fn explicit(&mut self, at: usize) -> usize {
        let line = self.lines[at];
        let rest = self.at(at).piece(2..).trim_start();
        let start = line.end - rest.len();
        let end = self.block_end(at);
        if let Some(text) = rest.strip_prefix("polarform:").filter(|text| !text.starts_with(':')) {
            let last = (at..end).rev().find(|&at| !self.lines[at].is_blank()).unwrap_or(at);
            let start = line.end - text.trim_start().len();
            let span = Span::new(start, self.lines[last].end.max(start));
            let text = self.text.piece(span.range()).to_owned();
            self.out.push(Item::Declaration { text, span, block: false });
            return end;
        }
        if rest.starts_with('[') {
            // A footnote: its text follows.
            let text = rest.find("] ").map_or(line.end, |close| start + close + 2);
            if self.open.len() >= MAX_NESTING {
                return end;
            }
            self.open_block(line.column, Enclosure::Item);
            self.lines[at] = Line { start: text, column: line.column + (text - line.start), ..line };
            return if text == line.end { at + 1 } else { self.line(at) };
        }
        let Some((name, argument)) = rest.split_once("::").filter(|(name, _)| is_name(name)) else {
            let lines: Vec<&str> = (at..end).map(|at| self.at(at)).collect();
            if rest.starts_with('|') {
                directives::count_unseen(&lines, line.span(), self.out);
            }
            return end;
        };
        let argument = line.end - argument.trim_start().len();
        if name == "default-role" {
            self.out.default_role = self.text.piece(argument..line.end).trim() == "math";
            return end;
        }
        // What plots show may be a session with words between its commands.
        let session = |at: usize| self.at(at).starts_with(">>> ");
        let content = match directives::named(name) {
            Content::Code if name == "plot" && (at + 1..end).any(session) => Content::Prose,
            content => content,
        };
        match content {
            Content::Formula => {
                self.formulas(at, argument, end);
                end
            }
            Content::Prose => {
                self.open_block(line.column, Enclosure::Environment);
                let next = (at + 1..end).find(|&at| !is_option(self.at(at))).unwrap_or(end);
                for option in at + 1..next {
                    let line = self.lines[option];
                    let text = self.text.piece(line.start..line.end);
                    // Such as the heads of a table.
                    if text.contains('`') {
                        self.out.enter(Enclosure::Row);
                        rst_inline::scan(text, line.start, false, self.out);
                        self.out.end_row();
                    }
                }
                if directives::begins_at_once(name) && argument < line.end {
                    let below = self.lines[next..end].first().filter(|line| !line.is_blank());
                    let column = below.map_or(line.column + 3, |line| line.column);
                    self.paragraph.push(Line { start: argument, end: line.end, column });
                } else if self.text.piece(argument..line.end).contains('`') {
                    rst_inline::scan(self.text.piece(argument..line.end), argument, false, self.out);
                    self.out.end_paragraph();
                }
                next
            }
            Content::Rst | Content::Code => end,
            Content::Include => {
                let text = self.text;
                let options = self.lines[at + 1..end].iter().map(|line| text.piece(line.start..line.end));
                directives::included(text.piece(argument..line.end), options, line.span(), self.out);
                end
            }
            Content::Unknown => {
                let lines: Vec<&str> = (at..end).map(|at| self.at(at)).collect();
                directives::count_unseen(&lines, line.span(), self.out);
                end
            }
        }
    }

    fn open_block(&mut self, column: usize, what: Enclosure) {
        if self.open.len() < MAX_NESTING {
            self.out.enter(what);
            self.open.push(Open { column: column + 1, what });
        }
    }

    /// The equations of a directive, which blank lines separate.
    fn formulas(&mut self, at: usize, argument: usize, end: usize) {
        let first = Span::new(argument, self.lines[at].end);
        let lines: Vec<Span> = (at + 1..end).map(|at| self.lines[at].span()).collect();
        let mut all = without_options(self.text, &lines).to_vec();
        if !first.is_empty() {
            // The content may begin on the line of the name.
            all.insert(0, first);
        }
        let mut from = None;
        let mut depth = 0_isize;
        for (i, line) in all.iter().enumerate() {
            let text = self.text.piece(line.range());
            depth += text.matches(r"\begin{").count() as isize - text.matches(r"\end{").count() as isize;
            if !line.is_empty() {
                from.get_or_insert(line.start);
            }
            let ends = all.get(i + 1).is_none_or(|next| next.is_empty() && depth <= 0);
            if let (true, Some(start)) = (ends && !line.is_empty(), from) {
                self.equation(start, line.end);
                from = None;
            }
        }
    }

    fn equation(&mut self, start: usize, end: usize) {
        let text = self.text.piece(start..end);
        // With `:nowrap:` the signs of LaTeX stand there.
        let bare = [(r"\[", r"\]"), ("$$", "$$")].iter().find_map(|(open, close)| {
            let rest = text.strip_prefix(open)?;
            Some(rest.trim_end().strip_suffix(close).unwrap_or(rest))
        });
        let shift = if bare.is_some() { 2 } else { 0 };
        self.out.formula(Style::Display, bare.unwrap_or(text), start + shift);
    }

    fn end_paragraph(&mut self) {
        let lines = std::mem::take(&mut self.paragraph);
        let (Some(first), Some(last)) = (lines.first(), lines.last()) else { return };
        let text = self.text.piece(first.start..last.end);
        if !text.trim_end_matches(':').is_empty() {
            rst_inline::scan(text, first.start, true, self.out);
            self.out.end_paragraph();
        }
        if text.ends_with("::") {
            // What is indented after it is shown as it is typed.
            let after = self.lines.partition_point(|line| line.start <= last.start);
            let next =
                self.lines[after..].iter().position(|line| !line.is_blank()).map(|found| after + found);
            if let Some(next) = next.filter(|&next| self.lines[next].column > first.column) {
                let column = first.column;
                for line in &mut self.lines[next..] {
                    if !line.is_blank() && line.column <= column {
                        break;
                    }
                    // As good as blank.
                    line.end = line.start;
                }
            }
        }
    }

    fn close(&mut self, keep: usize) {
        while self.open.len() > keep {
            if let Some(open) = self.open.pop() {
                self.out.leave(open.what);
            }
        }
    }
}

/// Whether the line is one mark again and again.
fn is_line_of_marks(line: &str) -> bool {
    line.chars()
        .next()
        .is_some_and(|first| UNDERLINES.contains(first) && line.len() > 1 && line.chars().all(|c| c == first))
}

/// A border of a table: `+---+---+`, `=== ====`.
fn is_border(line: &str) -> bool {
    let grid = line.starts_with('+') && line.bytes().all(|byte| matches!(byte, b'+' | b'-' | b'=' | b' '));
    let simple = line.contains(' ') && line.bytes().all(|byte| matches!(byte, b'=' | b' '));
    (grid && line.len() > 2) || simple
}

/// The name of a directive.
fn is_name(name: &str) -> bool {
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '+' | ':' | '.');
    !name.is_empty() && name.chars().all(plain)
}

/// The bytes of the mark of a list item or field with the space after it.
fn list_mark(line: &str) -> Option<usize> {
    let first = line.chars().next()?;
    let rest = line.piece(first.len_utf8()..);
    if matches!(first, '*' | '+' | '-' | '•' | '‣' | '⁃') {
        return (rest.is_empty() || rest.starts_with(' ')).then_some(first.len_utf8());
    }
    if first == ':' {
        // A field: `:param x: text`.
        let close = rest.find(": ").or_else(|| rest.strip_suffix(':').map(str::len))?;
        let name = rest.piece(..close);
        return (!name.is_empty() && !name.contains(['`', ':'])).then_some(close + 2);
    }
    let open = usize::from(first == '(');
    let number =
        line.piece(open..).bytes().take_while(|byte| byte.is_ascii_alphanumeric() || *byte == b'#').count();
    let name = line.piece(open..open + number);
    let roman = |name: &str| name.bytes().all(|byte| b"ivxlIVXL".contains(&byte));
    let counts = name == "#" || name.bytes().all(|byte| byte.is_ascii_digit()) || number == 1 || roman(name);
    let mark = *line.as_bytes().get(open + number)?;
    let closes = mark == b')' || (mark == b'.' && open == 0);
    let after = line.get(open + number + 1..)?;
    (number > 0 && number <= 5 && counts && closes && after.starts_with(' ')).then_some(open + number + 1)
}
