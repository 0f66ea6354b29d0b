//! What stands within a paragraph of Markdown: words, formulas, comments, code, tags, links.

use std::collections::BTreeMap;

use super::code_spans::{Dollars, closing_run, dollars_in_code, run_of};
use super::collect::Collector;
use super::directives::shortcode;
use super::html::{self, Found, Hidden};
use super::parts::{Opening, PartKind, hidden_queries, query_at};
use super::signs::{braced_name, display_end, inline_end, is_currency, is_math_environment, reads_as_prose};
use crate::document::{Item, Style};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// Takes the text of a paragraph apart; it stands at byte `start` of the file.
pub(super) fn paragraph(text: &str, start: usize, out: &mut Collector) {
    Inline::new(text, start, true, out).scan();
}

/// The formulas of a heading.
pub(super) fn heading(text: &str, start: usize, out: &mut Collector) {
    Inline::new(text, start, false, out).scan();
}

/// Code spans and addresses are this long at most; it keeps looking for their ends linear.
pub(super) const NEARBY: usize = 1000;

/// Roles of MyST and reStructuredText before backquotes that hold a formula.
const ROLES: [&str; 2] = ["{math}", ":math:"];

/// The bytes of the attributes or the label after a display: `{#eq-a}`, `(eq:a)`.
fn attributes(rest: &str) -> usize {
    let line = nearby(rest);
    let text = line.trim_start_matches([' ', '\t']);
    let braces = ["{#", "{.", "{:"].iter().any(|open| text.starts_with(open));
    let closing = if braces { '}' } else { ')' };
    let Some(close) = text.find(closing) else { return 0 };
    let label = |text: &str| {
        text.chars().all(|c| c.is_alphanumeric() || matches!(c, ':' | '-' | '_' | '.'))
            && text.contains([':', '-', '_'])
    };
    let fits = braces
        || (text.starts_with('(')
            && label(text.piece(1..close))
            && text.piece(close + 1..).trim().is_empty());
    if fits { line.len() - text.len() + close + 1 } else { 0 }
}

/// Not more of the text than is worth looking at.
fn near(text: &str) -> &str {
    let mut end = text.len().min(NEARBY);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text.piece(..end)
}

/// The rest of the line, but not more of it than is worth looking at.
pub(super) fn nearby(text: &str) -> &str {
    let text = near(text);
    text.split('\n').next().unwrap_or(text)
}

/// Whether `\[ … \]` or `\( … \)` holds a formula: Markdown also writes brackets like that.
pub(super) fn is_bracketed_formula(content: &str) -> bool {
    let content = content.trim();
    let letter = content.chars().count() == 1 && content.chars().all(char::is_alphabetic);
    letter || (content.contains(['\\', '=', '^', '_', '+', '<', '>', '(', '/']) && !reads_as_prose(content))
}

/// Whether the content of `\( … \)` is a formula such as `n-1`, and no words in brackets.
fn is_difference(content: &str) -> bool {
    let letters = |part: &str| part.chars().filter(|c| c.is_alphabetic()).count();
    let parts = content.split('-');
    content.contains('-')
        && content.contains(|c: char| c.is_ascii_digit())
        && parts.map(str::trim).all(|part| !part.is_empty() && letters(part) <= 1)
}

struct Inline<'a> {
    text: &'a str,
    start: usize,
    out: &'a mut Collector,
    /// Whether the words count: those of a heading do not.
    words: bool,
    /// Whether what comes next directly follows a formula.
    after_formula: bool,
    /// Up to where everything was said.
    said: usize,
    /// Whether a bracket was opened.
    bracket: bool,
    /// What holds no text of the page.
    hidden: Hidden,
    /// Tags without a closing tag from here on.
    no_close: Vec<String>,
    /// For each number of backquotes, from where on no such run stands.
    no_code: BTreeMap<usize, usize>,
}

impl<'a> Inline<'a> {
    fn new(text: &'a str, start: usize, words: bool, out: &'a mut Collector) -> Self {
        Inline {
            text,
            start,
            out,
            words,
            after_formula: false,
            said: 0,
            bracket: false,
            hidden: Hidden::default(),
            no_close: Vec::new(),
            no_code: BTreeMap::new(),
        }
    }

    fn scan(mut self) {
        let mut at = 0;
        while let Some(&byte) = self.text.as_bytes().get(at) {
            at = match byte {
                b'\\' => self.command(at),
                b'`' => self.code(at),
                b'<' => self.angle(at),
                b'$' => self.dollar(at),
                b'!' | b']' => self.link(at),
                b'[' => {
                    self.bracket = true;
                    at + 1
                }
                b'h' | b'w' => self.address(at),
                b'{' => self.query(at),
                _ => at + 1,
            };
        }
        self.say(self.text.len());
    }

    /// The words up to `at`.
    fn say(&mut self, at: usize) {
        if self.words && self.said < at {
            let words = self.text.piece(self.said..at);
            self.out.prose(words, self.start + self.said, self.after_formula);
        }
        self.said = self.said.max(at);
        self.after_formula = false;
    }

    /// Passes what is neither words nor formula.
    fn skip(&mut self, from: usize, to: usize) -> usize {
        self.say(from);
        self.said = to;
        to
    }

    /// The formula `text`, with the signs around it `from..to`.
    fn formula(&mut self, style: Style, text: Span, from: usize, to: usize) -> usize {
        self.say(from);
        if let Some(layout) = &mut self.out.layout {
            let inner = text.start - from..text.end - from;
            let span = Span::new(from, to).shifted(self.start);
            layout.push(PartKind::Formula { style, inner }, span, self.text.piece(from..to), span.start);
        }
        self.out.formula(style, self.text.piece(text.range()), self.start + text.start);
        self.said = to;
        self.after_formula = true;
        to
    }

    fn command(&mut self, at: usize) -> usize {
        let rest = self.text.piece(at..);
        // The signs of LaTeX, and as some generators of pages want them, with the backslash escaped; of Doxygen.
        for (open, close, style) in [
            (r"\f$", r"\f$", Style::Inline),
            (r"\f[", r"\f]", Style::Display),
            (r"\[", r"\]", Style::Display),
            (r"\(", r"\)", Style::Inline),
            (r"\\[", r"\\]", Style::Display),
            (r"\\(", r"\\)", Style::Inline),
        ] {
            let from = at + open.len();
            if rest.starts_with(open)
                && let Some(end) = display_end(self.text, from, close, false)
                && (open.starts_with(r"\f")
                    || is_bracketed_formula(self.text.piece(from..end))
                    || style == Style::Inline && is_difference(self.text.piece(from..end)))
            {
                return self.formula(style, Span::new(from, end), at, end + close.len());
            }
        }
        if rest.starts_with(r"\begin")
            && let Some((name, after)) = braced_name(self.text, at + 6)
            && is_math_environment(name)
        {
            let closing = format!(r"\end{{{name}}}");
            return match display_end(self.text, after, &closing, false) {
                Some(end) => {
                    let end = end + closing.len();
                    self.formula(Style::Display, Span::new(at, end), at, end)
                }
                None => {
                    self.out.unclosed(rest.piece(..after - at), self.start + at, &closing);
                    after
                }
            };
        }
        at + 1 + rest.piece(1..).chars().next().map_or(0, char::len_utf8)
    }

    fn code(&mut self, at: usize) -> usize {
        let run = run_of(self.text, at, b'`');
        if self.no_code.get(&run).is_some_and(|&from| at >= from) {
            return at + run;
        }
        match closing_run(self.text, at + run, run) {
            Some(end) => {
                let inner = Span::new(at + run, end - run);
                let before = self.text.piece(self.said..at);
                match ROLES.iter().find(|role| before.ends_with(**role)) {
                    Some(role) => self.formula(Style::Inline, inner, at - role.len(), end),
                    None if run == 2 && self.out.in_code.double_backquotes => {
                        self.formula(Style::Inline, inner, at, end)
                    }
                    None => match dollars_in_code(self.text.piece(inner.range())) {
                        Some((style, part)) if self.out.in_code.dollars == Dollars::Formulas => {
                            self.formula(style, part.shifted(inner.start), at, end)
                        }
                        Some((_, part)) => {
                            self.unseen_in_code(part, at, end);
                            self.skip(at, end)
                        }
                        None => self.skip(at, end),
                    },
                }
            }
            None => {
                self.no_code.insert(run, at);
                at + run
            }
        }
    }

    /// Passes a stretch that holds no text of the page, if one begins at `at`.
    fn hidden(&mut self, at: usize) -> Option<usize> {
        match self.hidden.at(self.text, at) {
            Found::Nothing => None,
            Found::Closed(end) => {
                if self.text.piece(at..).starts_with("<!--") {
                    self.say(at);
                    self.comment(at + 4, end - 3);
                }
                Some(self.skip(at, end))
            }
            Found::Open(len) => {
                self.out.problem(
                    Diagnostic::warning(Code::UnclosedBlock, "this is never closed")
                        .at(Span::new(at, at + len).shifted(self.start))
                        .reason("it begins here")
                        .hint("close it; what follows it is read as a part of the page"),
                );
                None
            }
        }
    }

    /// Tells of a formula in a code span that may be meant, if it is more than a letter.
    fn unseen_in_code(&mut self, formula: Span, at: usize, end: usize) {
        if formula.len() > 1 && self.out.in_code.dollars == Dollars::Unclear {
            self.out.problem(
                Diagnostic::warning(Code::UnseenFormula, "a formula in a code span was not read")
                    .at(Span::new(at, end).shifted(self.start))
                    .hint("leave out the backquotes; or write $`…`$, as GitLab and GitHub have it"),
            );
        }
    }

    fn angle(&mut self, at: usize) -> usize {
        if let Some(end) = self.hidden(at) {
            return end;
        }
        let rest = self.text.piece(at..);
        match html::tag(rest) {
            Some((len, raw)) => {
                if raw == Some("math") {
                    let span = Span::new(at, at + len).shifted(self.start);
                    self.out.unseen(span, "a formula in MathML was not read");
                }
                let hidden = raw.map_or(0, |name| self.raw(at + len, name));
                self.skip(at, at + len + hidden)
            }
            None => at + 1,
        }
    }

    /// How many bytes from `at` on are no text, up to the end of the tag.
    fn raw(&mut self, at: usize, name: &str) -> usize {
        let name = name.to_ascii_lowercase();
        if self.no_close.contains(&name) {
            return 0;
        }
        html::closing_tag(self.text.piece(at..), &name).unwrap_or_else(|| {
            self.no_close.push(name);
            0
        })
    }

    /// A query `{{ … }}`, where parts are wanted; code of Liquid; a file that is included.
    fn query(&mut self, at: usize) -> usize {
        if let Some(end) = self.hidden(at) {
            return end;
        }
        if !self.text.piece(at + 1..).starts_with('{') {
            return at + 1;
        }
        let Some(layout) = &mut self.out.layout else {
            return match shortcode(nearby(self.text.piece(at..)), self.start + at, self.out) {
                Some(len) => self.skip(at, at + len),
                None => at + 1,
            };
        };
        match query_at(self.text, at, false) {
            Opening::Query(inner) => {
                let end = inner.end + 2;
                let span = Span::new(at, end).shifted(self.start);
                // A query is one piece, however its lines are broken.
                let text = self.text.piece(inner.clone()).replace(['\n', '\r'], " ");
                layout.push(PartKind::Query, span, &text, self.start + inner.start);
                self.skip(at, end)
            }
            Opening::Unclosed => {
                self.out.problem(
                    Diagnostic::error(Code::UnclosedQuery, "{{ is never closed")
                        .at(Span::new(at, at + 2).shifted(self.start))
                        .reason("a query begins here")
                        .hint(r"write }} after the query, or \{{ for the braces"),
                );
                self.skip(at, at + 2)
            }
            Opening::Other => {
                let braces = self.text.piece(at..).bytes().take_while(|&byte| byte == b'{').count();
                self.skip(at, at + braces.max(1))
            }
        }
    }

    /// `<!-- polarform: … -->`, or a hidden block of queries.
    fn comment(&mut self, from: usize, to: usize) {
        if let Some(layout) = &mut self.out.layout {
            let span = Span::new(from - 4, to + 3).shifted(self.start);
            layout.push(PartKind::Comment, span, self.text.piece(from..to), self.start + from);
        }
        if let Some(part) = hidden_queries(self.text.piece(from..to)) {
            let start = part.places.byte(0);
            return self.out.queries(&part.text, self.start + from + start);
        }
        let Some(colon) = self.text.piece(from..to).trim_start().strip_prefix("polarform:") else { return };
        let text = colon.trim();
        let start = to - colon.len() + (colon.len() - colon.trim_start().len());
        let span = Span::new(start, start + text.len()).shifted(self.start);
        self.out.push(Item::Declaration { text: text.to_owned(), span, block: false });
    }

    fn dollar(&mut self, at: usize) -> usize {
        if self.text.piece(at..).starts_with("$$") {
            return self.dollars(at);
        }
        if let Some(code) = self.text.piece(at..).strip_prefix("$`")
            && let Some(len) = near(code).find("`$")
        {
            let text = Span::new(at + 2, at + 2 + len);
            return self.formula(Style::Inline, text, at, text.end + 2);
        }
        // Who writes into the text must not take a price and the code after it for a formula.
        let strict = self.out.layout.is_some() || self.out.in_code.dollars == Dollars::Formulas;
        let has_code = |end: usize| {
            let content = self.text.piece(at..end);
            content.contains("<!--") || (content.contains('`') && !content.contains(r"\text"))
        };
        match inline_end(self.text, at).filter(|&end| !strict || !has_code(end)) {
            Some(end) => self.formula(Style::Inline, Span::new(at + 1, end), at, end + 1),
            None => {
                if !is_currency(self.text, at) && !self.ends_cell(at) {
                    self.out.unclosed("$", self.start + at, "$");
                }
                self.skip(at, at + 1)
            }
        }
    }

    /// Whether the `$` closes a cell, after a tab, that was opened without one: `$b_0 = c$⇥= d$`.
    fn ends_cell(&self, at: usize) -> bool {
        let rest = self.text.piece(at + 1..).trim_start_matches([' ', '\t', '\r']);
        (rest.is_empty() || rest.starts_with('\n')) && self.text.piece(self.said..at).starts_with('\t')
    }

    fn dollars(&mut self, at: usize) -> usize {
        match display_end(self.text, at + 2, "$$", false) {
            Some(end) if !self.text.piece(at + 2..end).trim().is_empty() => {
                self.formula(Style::Display, Span::new(at + 2, end), at, end + 2);
                self.said = end + 2 + attributes(self.text.piece(end + 2..));
                self.said
            }
            Some(end) => self.skip(at, end + 2),
            None => {
                self.out.unclosed("$$", self.start + at, "$$");
                let rest = self.text.piece(at + 2..);
                if !rest.contains('$') && rest.contains('\\') && !rest.lines().any(reads_as_prose) {
                    return self.formula(
                        Style::Display,
                        Span::new(at + 2, self.text.len()),
                        at,
                        self.text.len(),
                    );
                }
                self.skip(at, at + 2)
            }
        }
    }

    /// The address of a link or an image.
    fn link(&mut self, at: usize) -> usize {
        let rest = nearby(self.text.piece(at..));
        let label = match rest.strip_prefix("![") {
            Some(label) => match label.find("](") {
                Some(len) => len + 2,
                None => return at + 1,
            },
            None if rest.starts_with("](") && self.bracket => 0,
            None => return at + 1,
        };
        let mut depth = 0_usize;
        for (i, byte) in rest.bytes().enumerate().skip(label + 1) {
            match byte {
                b'(' => depth += 1,
                b')' if depth == 1 => {
                    let address = rest.piece(label + 2..i);
                    let escapes = ["%5C", "%5c", "\\"].iter().any(|sign| address.contains(sign));
                    if escapes && address.starts_with("http") {
                        let span = Span::new(at, at + i + 1).shifted(self.start);
                        self.out.unseen(span, "a picture of a formula was not read");
                    }
                    return self.skip(at, at + i + 1);
                }
                b')' => depth -= 1,
                _ => {}
            }
        }
        at + 1
    }

    /// A web address in the text.
    fn address(&mut self, at: usize) -> usize {
        let rest = self.text.piece(at..);
        if !["https://", "http://", "www."].iter().any(|begin| rest.starts_with(begin)) {
            return at + 1;
        }
        let stop = |c: char| c.is_whitespace() || matches!(c, '<' | '>' | ')' | '|') || !c.is_ascii();
        let len = rest.find(stop).unwrap_or(rest.len());
        self.skip(at, at + len)
    }
}
