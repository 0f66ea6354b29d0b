//! The blocks of Markdown: quotations, lists, headings, tables, code, paragraphs.
//!
//! Follows CommonMark 0.31 and GitHub's tables, with one difference: a formula is stronger than a
//! block. From its opening to its closing sign a display is one piece, whatever its lines look
//! like, and it may begin or end anywhere in a line. (The crate `markdown` wants `$$` alone on its
//! line: after `$$a =` on one line and `b$$` on the next, it takes all that follows for a formula
//! until the next line of `$$`.) Time and space are linear in the length of the text.

use std::borrow::Cow;

use super::code_spans::{InCode, code_span, in_code};
use super::collect::Collector;
use super::cursor::Cursor;
use super::directives::{Content, content, without_options};
use super::front::front_matter;
use super::html::{Found, Hidden};
use super::inline;
use super::parts::{Part, PartKind, options_in};
use super::rst;
use super::signs::{braced_name, display_end, inline_end, is_math_environment, line_at};
use crate::document::{Enclosure, Item, Places, Style};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// Takes the Markdown text apart.
pub(super) fn scan(text: &str, out: &mut Collector) {
    let in_code = in_code(text);
    out.in_code =
        InCode { double_backquotes: in_code.double_backquotes || out.in_code.double_backquotes, ..in_code };
    let mut blocks = Blocks {
        text,
        out,
        open: Vec::new(),
        code: None,
        options: None,
        lines: Vec::new(),
        joined: Vec::new(),
        hidden: Hidden::default(),
    };
    let mut at = front_matter(text);
    while at < text.len() {
        at = blocks.line(at);
    }
    blocks.end_code(text.len(), false);
    blocks.end_paragraph();
    blocks.close(0);
}

/// Deeper quotations and lists are taken for text.
const MAX_NESTING: usize = 100;

enum Open {
    Quotation,
    /// Its lines are indented by this many columns.
    Item(usize),
    /// A fenced division of Pandoc.
    Division,
    /// `!!! note` of Documenter and MkDocs: its lines are indented by this many columns.
    Admonition(usize),
    /// A fence of MyST within which Markdown goes on.
    Directive {
        mark: u8,
        len: usize,
        start: Span,
    },
}

impl Open {
    fn enclosure(&self) -> Enclosure {
        match self {
            Open::Quotation => Enclosure::Quotation,
            Open::Item(_) => Enclosure::Item,
            Open::Division | Open::Admonition(_) | Open::Directive { .. } => Enclosure::Environment,
        }
    }
}

/// A fenced code block.
struct Fence {
    mark: u8,
    len: usize,
    start: Span,
    /// What is said of it.
    info: Span,
    /// What its lines are.
    content: Content,
    /// Its lines, if they are of interest.
    lines: Option<Vec<Span>>,
    /// The columns by which the opening fence is indented, and so may its lines.
    indent: usize,
}

struct Blocks<'a> {
    text: &'a str,
    out: &'a mut Collector,
    open: Vec<Open>,
    code: Option<Fence>,
    /// Whether the options of a directive may stand here, and if so, whether as a block of YAML.
    options: Option<bool>,
    /// The lines of the paragraph, without the marks of what encloses it.
    lines: Vec<Span>,
    /// Those of them that a formula or comment of the line above goes on to.
    joined: Vec<usize>,
    /// What holds no text of the page.
    hidden: Hidden,
}

impl Blocks<'_> {
    /// Takes the line that starts at `start`, with those that a formula in it goes on to; the
    /// start of the next one.
    fn line(&mut self, start: usize) -> usize {
        let end = start + line_at(self.text, start).len();
        let next = end + 1;
        let mut cursor = Cursor::new(self.text, start, end);
        let mut matched = 0;
        for open in &self.open {
            let goes_on = match open {
                Open::Quotation => cursor.quotation_mark(),
                Open::Item(columns) | Open::Admonition(columns) => {
                    cursor.is_blank() || cursor.skip_columns(*columns)
                }
                Open::Division | Open::Directive { .. } => true,
            };
            if !goes_on {
                break;
            }
            matched += 1;
        }
        let all = matched == self.open.len();
        if self.code.is_some() {
            if all {
                self.code_line(&cursor);
                return next;
            }
            self.end_code(start, false);
        }
        if self.is_option(cursor.rest()) {
            return next;
        }
        if cursor.is_blank() {
            self.end_paragraph();
            self.close(matched);
            return next;
        }
        if all && self.underline(&mut cursor.clone()) {
            return next;
        }
        let mut fresh = false;
        loop {
            let in_paragraph = !self.lines.is_empty();
            if cursor.indent() >= 4 && !self.opens_display(&cursor) {
                if in_paragraph {
                    break;
                }
                self.close_unless(fresh, matched);
                return next;
            }
            let indent = cursor.indent();
            cursor.skip_spaces();
            let nests = self.open.len() < MAX_NESTING;
            if nests && cursor.quotation_mark() {
                self.begin(Open::Quotation, fresh, matched);
            } else if let Some((mark, len)) = cursor.fence() {
                self.end_paragraph();
                self.close_unless(fresh, matched);
                if !self.closes_directive(mark, len, &cursor) {
                    self.fence(mark, len, indent, &cursor);
                }
                return next;
            } else if let Some((level, span)) = cursor.heading() {
                self.end_paragraph();
                self.close_unless(fresh, matched);
                self.heading(level, span);
                return next;
            } else if cursor.is_rule() {
                self.end_paragraph();
                self.close_unless(fresh, matched);
                return next;
            } else if nests && let Some(columns) = cursor.list_mark(indent, in_paragraph && all && !fresh) {
                self.begin(Open::Item(columns), fresh, matched);
            } else if nests && let Some(title) = cursor.admonition() {
                self.begin(Open::Admonition(indent + 4), fresh, matched);
                self.set_margin();
                inline::heading(self.text.piece(title.range()), title.start, self.out);
                self.out.end_paragraph();
                return next;
            } else if nests && let Some(closing) = cursor.division() {
                self.end_paragraph();
                let colons = cursor.rest().bytes().take_while(|&byte| byte == b':').count();
                let name = cursor.rest().piece(colons..).trim_start();
                if name.starts_with("{math}") || name.starts_with("{include}") {
                    self.close_unless(fresh, matched);
                    self.fence(b':', colons, indent, &cursor);
                } else {
                    let named = name
                        .strip_prefix('{')
                        .is_some_and(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()));
                    self.division(closing, fresh, matched);
                    self.options = named.then_some(false);
                }
                return next;
            } else {
                break;
            }
            fresh = true;
            if cursor.is_blank() {
                return next;
            }
        }
        // A comment on a line of its own does not go on with the paragraph of a quotation.
        let comment = !all && cursor.rest().trim_start().starts_with("<!--");
        if fresh || comment || self.lines.is_empty() {
            self.end_paragraph();
            self.close_unless(fresh, matched);
        }
        cursor.skip_spaces();
        self.paragraph_line(cursor.at(), cursor.end())
    }

    fn opens_display(&self, cursor: &Cursor) -> bool {
        cursor.rest().trim_start().starts_with("$$")
    }

    fn begin(&mut self, open: Open, fresh: bool, matched: usize) {
        self.end_paragraph();
        self.close_unless(fresh, matched);
        self.out.enter(open.enclosure());
        self.open.push(open);
    }

    /// Closes what did not go on, before the first new block of a line.
    fn close_unless(&mut self, fresh: bool, matched: usize) {
        if !fresh {
            self.close(matched);
        }
    }

    fn close(&mut self, keep: usize) {
        while self.open.len() > keep {
            if let Some(open) = self.open.pop() {
                self.out.leave(open.enclosure());
                if let Open::Directive { start, .. } = open {
                    self.out.problem(never_closed(start, "it ends with what it stands in"));
                }
            }
        }
    }

    /// Begins a fenced block, or a directive of MyST in which Markdown goes on.
    fn fence(&mut self, mark: u8, len: usize, indent: usize, cursor: &Cursor) {
        let rest = cursor.rest().piece(len..);
        let begin = cursor.end() - rest.trim_start().len();
        let info = Span::new(begin, begin + rest.trim().len());
        let start = Span::new(cursor.at(), cursor.at() + len);
        let content = content(rest.trim());
        if content == Content::Prose && self.open.len() < MAX_NESTING {
            self.begin(Open::Directive { mark, len, start }, true, 0);
            self.options = Some(false);
            let title = begin + rest.trim().find('}').map_or(0, |at| at + 1);
            inline::heading(self.text.piece(title..info.end), title, self.out);
            return self.out.end_paragraph();
        }
        let wanted = content != Content::Code || options_in(rest).is_some() || self.out.layout.is_some();
        let lines = wanted.then(Vec::new);
        self.code = Some(Fence { mark, len, start, info, content, lines, indent });
    }

    /// Whether the fence closes the innermost directive that it can.
    fn closes_directive(&mut self, mark: u8, len: usize, cursor: &Cursor) -> bool {
        if !cursor.rest().piece(len..).trim().is_empty() {
            return false;
        }
        let closes =
            |open: &Open| matches!(open, Open::Directive { mark: m, len: l, .. } if *m == mark && *l <= len);
        let Some(at) = self.open.iter().rposition(closes) else { return false };
        self.close(at + 1);
        if let Some(open) = self.open.pop() {
            self.out.leave(open.enclosure());
        }
        true
    }

    /// Whether the line is an option of the directive above it.
    fn is_option(&mut self, line: &str) -> bool {
        let Some(yaml) = self.options else { return false };
        let line = line.trim();
        if yaml && line.is_empty() {
            self.options = None;
            return false;
        }
        let fence = line == "---";
        if yaml || fence {
            self.options = if yaml && fence { None } else { Some(true) };
            return true;
        }
        let option = super::directives::is_option(line);
        if !option {
            self.options = None;
        }
        option
    }

    fn division(&mut self, closing: bool, fresh: bool, matched: usize) {
        if !closing {
            self.begin(Open::Division, fresh, matched);
        } else if let Some(last) = self.open.iter().rposition(|open| matches!(open, Open::Division)) {
            self.close(last);
        }
    }

    /// A heading that is underlined: the lines of the paragraph are its text.
    fn underline(&mut self, cursor: &mut Cursor) -> bool {
        let (Some(first), Some(last)) = (self.lines.first(), self.lines.last()) else { return false };
        if cursor.indent() >= 4 || self.text.piece(last.range()).trim_end().ends_with("$$") {
            return false;
        }
        cursor.skip_spaces();
        let rest = cursor.rest().trim_end();
        let level = match rest.as_bytes().first() {
            Some(b'=') => 1,
            Some(b'-') => 2,
            _ => return false,
        };
        if !rest.bytes().all(|byte| byte == rest.as_bytes()[0]) {
            return false;
        }
        let span = first.to(*last);
        self.lines.clear();
        self.joined.clear();
        self.heading(level, span);
        true
    }

    fn heading(&mut self, level: u8, span: Span) {
        self.out.push(Item::Heading { level, span });
        self.set_margin();
        inline::heading(self.text.piece(span.range()), span.start, self.out);
        self.out.end_paragraph();
    }

    fn code_line(&mut self, cursor: &Cursor) {
        let Some(fence) = &mut self.code else { return };
        let rest = cursor.rest().trim();
        let closes = rest.len() >= fence.len && rest.bytes().all(|byte| byte == fence.mark);
        if closes && cursor.indent() < 4 {
            self.end_code(cursor.at() + cursor.rest().trim_end().len(), true);
        } else if let Some(lines) = &mut fence.lines {
            let mut cursor = cursor.clone();
            cursor.skip_columns(fence.indent.min(cursor.indent()));
            lines.push(Span::new(cursor.at(), cursor.end()));
        }
    }

    fn end_code(&mut self, at: usize, closed: bool) {
        let Some(fence) = self.code.take() else { return };
        if let Some(lines) = &fence.lines {
            let span = Span::new(fence.start.start, at);
            self.note_code(&fence, lines, span, closed);
            if fence.content == Content::Formula {
                // What stands behind the name on the first line belongs to the formula.
                let name =
                    self.text.piece(fence.info.range()).find('}').map_or(fence.info.len(), |at| at + 1);
                let first = Span::new(fence.info.start + name, fence.info.end);
                let mut all = vec![first];
                all.extend_from_slice(without_options(self.text, lines));
                let all = if first.is_empty() { &all[1..] } else { &all[..] };
                let masked = masked(self.text, all);
                self.out.formula(Style::Display, &masked, all.first().map_or(at, |line| line.start));
                self.out.end_paragraph();
            } else if fence.content == Content::Rst {
                let range =
                    lines.first().map_or(at, |line| line.start)..lines.last().map_or(at, |line| line.end);
                rst::scan(self.text, range, self.out);
            } else if fence.content == Content::Include {
                let name = self.text.piece(fence.info.range()).split_once('}').map_or("", |(_, name)| name);
                let options = lines.iter().map(|line| self.text.piece(line.range()));
                super::directives::included(name, options, fence.start.to(fence.info), self.out);
            } else if fence.content == Content::Unknown {
                let lines: Vec<&str> = lines.iter().map(|line| self.text.piece(line.range())).collect();
                super::directives::count_unseen(&lines, fence.info, self.out);
            } else if closed && options_in(self.text.piece(fence.info.range())).is_some() {
                let code = masked(self.text, lines);
                self.out.queries(&code, lines.first().map_or(at, |line| line.start));
            }
        }
        if !closed {
            self.out.problem(never_closed(fence.start, "nothing in it was checked"));
        }
    }

    /// Notes a fenced block, if parts are wanted; one that holds a formula is a formula.
    fn note_code(&mut self, fence: &Fence, lines: &[Span], span: Span, closed: bool) {
        self.set_margin();
        let Some(layout) = &mut self.out.layout else { return };
        if fence.content == Content::Formula && closed {
            let ends = [fence.start.to(fence.info), Span::new(span.end - fence.len, span.end)];
            let all = [&ends[..1], lines, &ends[1..]].concat();
            let masked = masked(self.text, &all);
            let first = lines.first().map_or(ends[1].start, |line| line.start);
            let inner = first - span.start..ends[1].start - span.start;
            layout.push(PartKind::Formula { style: Style::Display, inner }, span, &masked, span.start);
            return;
        }
        let mut part = Part {
            kind: PartKind::Code { info: fence.info, closed },
            span,
            text: String::new(),
            places: Places::default(),
            margin: layout.margin.clone(),
        };
        for line in lines {
            part.places.push(part.text.len(), line.start, true);
            part.text.push_str(self.text.piece(line.range()).trim_end_matches('\r'));
            part.text.push('\n');
        }
        layout.parts.push(part);
    }

    /// What a further line of the open blocks begins with.
    fn set_margin(&mut self) {
        let Some(layout) = &mut self.out.layout else { return };
        layout.margin.clear();
        for open in &self.open {
            match open {
                Open::Quotation => layout.margin.push_str("> "),
                Open::Item(columns) | Open::Admonition(columns) => {
                    layout.margin.extend(std::iter::repeat_n(' ', *columns));
                }
                Open::Division | Open::Directive { .. } => {}
            }
        }
    }

    /// Adds a line to the paragraph, with all lines that a formula or comment in it spans.
    fn paragraph_line(&mut self, start: usize, end: usize) -> usize {
        let mut start = start;
        let mut end = end;
        let mut at = start;
        loop {
            match self.opening(at, end) {
                Some(close) if close > end => {
                    self.lines.push(Span::new(start, end));
                    while end < close {
                        let line = line_at(self.text, end + 1);
                        let mut cursor = Cursor::new(self.text, end + 1, end + 1 + line.len());
                        for open in &self.open {
                            match open {
                                Open::Quotation => {
                                    cursor.quotation_mark();
                                }
                                Open::Item(columns) | Open::Admonition(columns) => {
                                    cursor.skip_columns(*columns);
                                }
                                Open::Division | Open::Directive { .. } => {}
                            }
                        }
                        (start, end) = (cursor.at(), end + 1 + line.len());
                        self.joined.push(self.lines.len());
                        if end < close {
                            self.lines.push(Span::new(start, end));
                        }
                    }
                    at = close;
                }
                Some(close) => at = close,
                None => break,
            }
        }
        self.lines.push(Span::new(start, end));
        end + 1
    }

    /// The first display or comment that opens between `at` and `end`: where it ends.
    fn opening(&mut self, mut at: usize, end: usize) -> Option<usize> {
        let bytes = self.text.as_bytes();
        while at < end {
            match bytes[at] {
                b'`' => at = code_span(self.text.piece(..end), at),
                b'\\' => {
                    if let Some(close) = self.opening_command(at) {
                        return Some(close);
                    }
                    at += 2;
                }
                b'<' | b'{' => match self.hidden.at(self.text, at) {
                    Found::Closed(close) => return Some(close),
                    Found::Nothing | Found::Open(_) => at += 1,
                },
                b'$' if bytes.get(at + 1) == Some(&b'$') => match display_end(self.text, at + 2, "$$", false)
                {
                    Some(close) => return Some(close + 2),
                    None => at += 2,
                },
                b'$' => at = inline_end(self.text.piece(..end), at).unwrap_or(at) + 1,
                _ => at += 1,
            }
        }
        None
    }

    fn opening_command(&mut self, at: usize) -> Option<usize> {
        let rest = self.text.piece(at..);
        for (open, close) in [(r"\[", r"\]"), (r"\\[", r"\\]")] {
            if rest.starts_with(open) {
                let from = at + open.len();
                let found = display_end(self.text, from, close, false)?;
                let formula = inline::is_bracketed_formula(self.text.piece(from..found));
                return formula.then_some(found + close.len());
            }
        }
        let (name, after) = braced_name(self.text, at + rest.strip_prefix(r"\begin").map(|_| 6)?)?;
        if !is_math_environment(name) {
            return None;
        }
        let closing = format!(r"\end{{{name}}}");
        display_end(self.text, after, &closing, false).map(|found| found + closing.len())
    }

    fn end_paragraph(&mut self) {
        if self.lines.is_empty() {
            return;
        }
        self.set_margin();
        let lines = std::mem::take(&mut self.lines);
        let joined = std::mem::take(&mut self.joined);
        let is_joined = |row: usize| joined.binary_search(&row).is_ok();
        let table = (1..lines.len()).find(|&row| {
            !is_joined(row)
                && self.text.piece(lines[row - 1].range()).contains('|')
                && is_delimiter_row(self.text.piece(lines[row].range()))
        });
        let first_row = table.map_or(lines.len(), |row| row - 1);
        let words = &lines[..first_row];
        if let Some(first) = words.first() {
            inline::paragraph(&masked(self.text, words), first.start, self.out);
            self.out.end_paragraph();
        }
        let mut row = first_row;
        while row < lines.len() {
            let next = (row + 1..lines.len()).find(|&next| !is_joined(next)).unwrap_or(lines.len());
            if row != first_row + 1 {
                self.out.enter(Enclosure::Row);
                inline::paragraph(&masked(self.text, &lines[row..next]), lines[row].start, self.out);
                self.out.end_row();
            }
            row = next;
        }
    }
}

/// The block of code or directive that begins at the place has no end.
fn never_closed(start: Span, what: &str) -> Diagnostic {
    Diagnostic::warning(Code::UnclosedBlock, "the fenced block is never closed")
        .at(start)
        .reason("it begins here")
        .hint(format!("close it with a line of the same marks; {what}"))
}

fn is_delimiter_row(line: &str) -> bool {
    line.contains('-')
        && line.contains(['|', ':'])
        && line.bytes().all(|byte| matches!(byte, b'|' | b'-' | b':' | b' ' | b'\t' | b'\r'))
}

/// The text from the first of the lines to the last, in which the marks of the enclosing blocks
/// are blanked.
fn masked<'a>(text: &'a str, lines: &[Span]) -> Cow<'a, str> {
    let (Some(first), Some(last)) = (lines.first(), lines.last()) else { return "".into() };
    if lines.windows(2).all(|pair| pair[0].end + 1 == pair[1].start) {
        return text.piece(first.start..last.end).into();
    }
    let mut masked = String::with_capacity(last.end - first.start);
    for line in lines {
        let gap = line.start - (first.start + masked.len());
        if gap > 0 {
            masked.push('\n');
            masked.extend(std::iter::repeat_n(' ', gap - 1));
        }
        masked.push_str(text.piece(line.range()));
    }
    masked.into()
}
