//! LaTeX files: formulas, headings, theorems, lists, macros, included files.
//!
//! Reads what authors write, not what TeX would do with it: definitions are taken note of in the
//! order of the text, conditionals and changes of category codes are not followed. The preamble
//! holds definitions only; what follows `\end{document}` is not read.
//!
//! Reference: Lamport, *LaTeX: A Document Preparation System*; the user's guide of amsmath.

use super::arguments::command_name;
use super::clean::braces_end;
use super::collect::Collector;
use super::inline::nearby;
use super::macros::{half_definition, is_definer};
use super::signs::{braced_name, display_end, formula_end, is_math_environment, line_at};
use super::vocabulary::{HEADINGS, LISTS, PROGRAM, QUOTATIONS, SILENT, TABLES, THEOREMS, VERBATIM};
use super::words::{label_after, without_accents};
use crate::document::{Enclosure, Item, Style};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::latex;

/// What is done with `\input{name}`: the name, where it stands, whether it stands in the body.
pub(super) type Include<'a> = dyn FnMut(&str, Span, bool, &mut Collector) + 'a;

/// Takes a LaTeX file apart. `body`: whether it belongs to the body of the file that includes it.
pub(super) fn scan(text: &str, body: bool, out: &mut Collector, include: &mut Include) {
    let preamble = text.lines().any(|line| line.trim_start().starts_with(r"\begin{document}"));
    let mut latex = Latex {
        text,
        out,
        include,
        body: body && !preamble,
        said: 0,
        open: Vec::new(),
        title: None,
        missing: Vec::new(),
    };
    let mut at = 0;
    while at < text.len() {
        if let Some(end) = latex.title.filter(|&end| at >= end) {
            latex.end_title(end);
        }
        at = match text.as_bytes()[at] {
            b'%' => latex.comment(at),
            b'\\' => latex.command(at),
            b'$' if latex.body => latex.dollar(at),
            b'\n' => latex.line_end(at),
            _ => at + 1,
        };
    }
    latex.finish();
}

/// Deeper environments are not followed.
const MAX_NESTING: usize = 200;

enum Kind {
    Enclosure(Enclosure),
    /// A list, and whether it is within an item.
    List(bool),
    Table,
    Other,
}

struct Open<'a> {
    name: &'a str,
    place: Span,
    kind: Kind,
}

struct Latex<'a, 'b> {
    text: &'a str,
    out: &'b mut Collector,
    include: &'b mut Include<'b>,
    /// Whether `\begin{document}` is passed.
    body: bool,
    /// Up to where everything was said.
    said: usize,
    open: Vec<Open<'a>>,
    /// Where the title of the heading ends.
    title: Option<usize>,
    /// Ends of verbatim texts that were looked for and do not come any more.
    missing: Vec<String>,
}

impl<'a> Latex<'a, '_> {
    /// The words up to `at`.
    fn say(&mut self, at: usize) {
        if self.body && self.title.is_none() && self.said < at {
            self.out.words(self.text.piece(self.said..at), self.said);
        }
        self.said = self.said.max(at);
    }

    /// Passes what is neither words nor formula.
    fn skip(&mut self, from: usize, to: usize) -> usize {
        self.say(from);
        self.said = to;
        to
    }

    fn formula(&mut self, style: Style, content: Span, from: usize, to: usize) -> usize {
        self.say(from);
        self.out.commented_formula(style, self.text.piece(content.range()), content.start);
        self.said = to;
        to
    }

    fn comment(&mut self, at: usize) -> usize {
        let line = line_at(self.text, at);
        let comment = line.trim_start_matches(['%', ' ', '\t']);
        if let Some(text) = comment.strip_prefix("polarform:") {
            self.say(at);
            let start = at + line.len() - text.trim_start().len();
            let span = Span::new(start, start + text.trim().len());
            self.out.push(Item::Declaration { text: text.trim().to_owned(), span, block: false });
        }
        self.skip(at, at + line.len())
    }

    fn line_end(&mut self, at: usize) -> usize {
        let rest = self.text.piece(at + 1..).trim_start_matches([' ', '\t', '\r']);
        if rest.starts_with('\n') {
            self.end_paragraph(at);
        }
        at + 1
    }

    fn end_paragraph(&mut self, at: usize) {
        self.say(at);
        if self.body {
            self.out.end_paragraph();
        }
    }

    fn dollar(&mut self, at: usize) -> usize {
        let sign = if self.text.piece(at..).starts_with("$$") { "$$" } else { "$" };
        let style = if sign == "$$" { Style::Display } else { Style::Inline };
        let from = at + sign.len();
        match display_end(self.text, from, sign, true) {
            Some(end) => self.formula(style, Span::new(from, end), at, end + sign.len()),
            None => {
                self.out.unclosed(sign, at, sign);
                self.skip(at, from)
            }
        }
    }

    fn command(&mut self, at: usize) -> usize {
        let name = command_name(self.text, at);
        let after = at + 1 + name.len();
        match name {
            "begin" => return self.begin(at, after),
            "end" => return self.end(at, after),
            "verb" | "lstinline" | "mintinline" => return self.verbatim(at, after, name),
            "iffalse" => {
                let end = self.find_end(after, r"\fi").unwrap_or(after);
                return self.skip(at, end);
            }
            "newtheorem" => {
                let name = after + usize::from(self.text.piece(after..).starts_with('*'));
                if let Some((name, end)) = braced_name(self.text, name) {
                    let title = self.brackets(end);
                    let title = braces_end(self.text, title).map_or("", |end| self.inside(title, end));
                    self.out.macros.theorems.insert(name.to_owned(), title.to_owned());
                }
                return self.silent(at, name);
            }
            "input" | "include" | "subfile" | "import" | "subimport" => {
                return self.included(at, after, name);
            }
            _ if is_definer(name) => {
                let end = self.out.macros.define(self.text, at).unwrap_or_else(|| {
                    self.out.problem(half_definition(Span::new(at, after)));
                    after
                });
                return self.skip(at, end);
            }
            _ => {}
        }
        if !self.body {
            return after;
        }
        match name {
            "(" => self.bracketed(at, r"\)", Style::Inline),
            "[" => self.bracketed(at, r"\]", Style::Display),
            "\\" => {
                if matches!(self.open.last(), Some(Open { kind: Kind::Table, .. })) {
                    self.say(at);
                    self.out.end_row();
                    self.out.enter(Enclosure::Row);
                }
                self.skip(at, after)
            }
            "item" => self.item(at, after),
            "par" => {
                self.end_paragraph(at);
                self.skip(at, after)
            }
            "ensuremath" => match braces_end(self.text, after) {
                Some(end) => {
                    let open = end - self.text.piece(after..end).trim_start().len();
                    self.formula(Style::Inline, Span::new(open + 1, end - 1), at, end)
                }
                None => after,
            },
            _ if SILENT.contains(&name) => self.silent(at, after),
            _ => match HEADINGS.iter().find(|heading| heading.0 == name) {
                Some(&(_, level)) => self.heading(at, after, level),
                None => self.opening_macro(at, after, name),
            },
        }
    }

    fn bracketed(&mut self, at: usize, closing: &str, style: Style) -> usize {
        match display_end(self.text, at + 2, closing, true) {
            Some(end) => self.formula(style, Span::new(at + 2, end), at, end + 2),
            None => {
                self.out.unclosed(self.text.piece(at..at + 2), at, closing);
                self.skip(at, at + 2)
            }
        }
    }

    /// A macro that stands for the beginning of a display, such as `\be`.
    fn opening_macro(&mut self, at: usize, after: usize, name: &str) -> usize {
        let Some(body) = self.out.macros.body(name).map(str::trim) else { return after };
        let closing = match body.strip_prefix(r"\begin{").and_then(|body| body.strip_suffix('}')) {
            Some(environment) if is_math_environment(environment) => format!(r"\end{{{environment}}}"),
            _ if body == r"\[" => r"\]".to_owned(),
            _ => return after,
        };
        let macros = self.out.macros.names_of(&closing);
        let mut signs: Vec<_> = macros.into_iter().map(|name| format!("\\{name}")).collect();
        signs.push(closing);
        let opening = format!("\\{name}");
        let ends = signs
            .iter()
            .filter_map(|sign| Some((formula_end(self.text, after, Some(&opening), sign, true)?, sign)));
        match ends.min() {
            Some((end, sign)) => {
                let end = end + sign.len();
                self.formula(Style::Display, Span::new(at, end), at, end)
            }
            None => {
                let sign = signs.swap_remove(0);
                self.out.unclosed(self.text.piece(at..after), at, &sign);
                self.skip(at, after)
            }
        }
    }

    fn begin(&mut self, at: usize, after: usize) -> usize {
        let Some((name, end)) = braced_name(self.text, self.spaces(after)) else { return after };
        let place = Span::new(at, end);
        if name == "document" {
            self.body = true;
            self.said = end;
            return end;
        }
        let closing = format!(r"\end{{{name}}}");
        let program = |text: &Self| text.is_program(name, end, &closing);
        if VERBATIM.contains(&name.trim_end_matches('*')) || program(self) {
            return match self.find_end(end, &closing) {
                Some(past) => {
                    if name.starts_with("algorithm") && self.text.piece(end..past).contains('$') {
                        self.out.unseen(place, "the formulas of this algorithm were not read");
                    }
                    if name == "polarform" {
                        self.say(at);
                        let last = past - closing.len();
                        // Options without a closing bracket end nowhere: all of it is code.
                        let code = Some(self.brackets(end)).filter(|&code| code <= last).unwrap_or(end);
                        self.out.queries(self.text.piece(code..last), code);
                    }
                    self.skip(at, past)
                }
                None => {
                    self.out.problem(never_closed(name, place));
                    self.skip(at, end)
                }
            };
        }
        if !self.body {
            return end;
        }
        if is_math_environment(name) {
            return match display_end(self.text, end, &closing, true) {
                Some(close) => {
                    let to = close + closing.len();
                    let plain = name.trim_end_matches('*');
                    let known = latex::environments().any(|(known, _)| known == plain);
                    let content = if known {
                        place.to(Span::new(close, to))
                    } else {
                        Span::new(self.columns(name, end), close)
                    };
                    self.formula(Style::Display, content, at, to)
                }
                None => {
                    self.out.unclosed(self.text.piece(place.range()), at, &closing);
                    self.skip(at, end)
                }
            };
        }
        self.end_paragraph(at);
        if self.open.len() >= MAX_NESTING {
            self.said = end;
            return end;
        }
        let plain = name.trim_end_matches('*');
        let theorem = THEOREMS.contains(&plain.to_ascii_lowercase().as_str());
        let kind = if QUOTATIONS.contains(&plain) {
            Kind::Enclosure(Enclosure::Quotation)
        } else if theorem || self.out.macros.theorems.contains_key(plain) {
            Kind::Enclosure(Enclosure::Environment)
        } else if LISTS.contains(&plain) {
            Kind::List(false)
        } else if TABLES.contains(&plain) {
            Kind::Table
        } else {
            Kind::Other
        };
        let to = match &kind {
            Kind::Enclosure(what) => {
                self.out.enter(*what);
                if *what == Enclosure::Environment {
                    let kind = self.out.macros.theorems.get(plain).filter(|title| !title.is_empty());
                    let kind = without_accents(kind.map_or(plain, String::as_str)).into_owned();
                    self.out.push(Item::Title { kind, label: label_after(self.text, end) });
                }
                end
            }
            Kind::Table => {
                self.out.enter(Enclosure::Row);
                self.arguments(end)
            }
            Kind::List(_) | Kind::Other => self.brackets(end),
        };
        self.open.push(Open { name, place, kind });
        self.said = to;
        to
    }

    /// Whether the environment holds a program in the signs of algorithm2e; else an algorithm is told in words.
    fn is_program(&self, name: &str, from: usize, closing: &str) -> bool {
        let content = || {
            let rest = self.text.piece(from..);
            rest.piece(..rest.find(closing).unwrap_or(0))
        };
        name.starts_with("algorithm") && PROGRAM.iter().any(|sign| content().contains(sign))
    }

    /// The byte after the options of an environment, such as the kinds of its columns.
    fn columns(&self, name: &str, at: usize) -> usize {
        let at = self.brackets(at);
        let columns = name.starts_with("IEEE") || name.contains("alignat");
        let braces = columns && self.text.piece(at..).starts_with('{');
        if braces { braces_end(self.text, at).unwrap_or(at) } else { at }
    }

    /// The byte after the end of a text that is not read.
    fn find_end(&mut self, from: usize, closing: &str) -> Option<usize> {
        if self.missing.iter().any(|missing| missing == closing) {
            return None;
        }
        let found = self.text.piece(from..).find(closing).map(|found| from + found + closing.len());
        if found.is_none() {
            self.missing.push(closing.to_owned());
        }
        found
    }

    fn end(&mut self, at: usize, after: usize) -> usize {
        let Some((name, end)) = braced_name(self.text, self.spaces(after)) else { return after };
        if !self.body {
            return end;
        }
        self.end_paragraph(at);
        self.said = end;
        if name == "document" {
            self.said = self.text.len();
            return self.text.len();
        }
        match self.open.iter().rposition(|open| open.name == name) {
            Some(last) => self.close(last, true),
            None => self.out.problem(
                Diagnostic::warning(Code::UnclosedBlock, format!(r"\end{{{name}}} without \begin{{{name}}}"))
                    .at(Span::new(at, end))
                    .hint(format!(r"remove it, or write \begin{{{name}}} before it")),
            ),
        }
        end
    }

    /// Closes environments; all but the last should have been closed before.
    fn close(&mut self, keep: usize, last: bool) {
        while self.open.len() > keep {
            let Some(open) = self.open.pop() else { return };
            match open.kind {
                Kind::Enclosure(what) => self.out.leave(what),
                Kind::List(true) => self.out.leave(Enclosure::Item),
                Kind::Table => self.out.end_row(),
                Kind::List(false) | Kind::Other => {}
            }
            if self.open.len() > keep || !last {
                self.out.problem(never_closed(open.name, open.place));
            }
        }
    }

    fn item(&mut self, at: usize, after: usize) -> usize {
        self.end_paragraph(at);
        if let Some(Open { kind: Kind::List(item), .. }) = self.open.last_mut() {
            if *item {
                self.out.leave(Enclosure::Item);
            }
            *item = true;
            self.out.enter(Enclosure::Item);
        }
        self.said = after;
        after
    }

    fn heading(&mut self, at: usize, after: usize, level: u8) -> usize {
        let star = after + usize::from(self.text.piece(after..).starts_with('*'));
        let open = self.spaces(self.brackets(star));
        let Some(end) = braces_end(self.text, open).filter(|_| self.text.piece(open..).starts_with('{'))
        else {
            return after;
        };
        self.end_paragraph(at);
        self.out.push(Item::Heading { level, span: Span::new(open + 1, end - 1) });
        self.title = Some(end - 1);
        self.said = open + 1;
        open + 1
    }

    fn end_title(&mut self, end: usize) {
        self.title = None;
        self.out.end_paragraph();
        // The brace is passed.
        self.said = self.said.max(end + 1).min(self.text.len());
    }

    fn verbatim(&mut self, at: usize, after: usize, name: &str) -> usize {
        let mut from = after + usize::from(self.text.piece(after..).starts_with('*'));
        if name != "verb" {
            from = self.brackets(from);
        }
        if name == "mintinline" {
            from = braces_end(self.text, from).unwrap_or(from);
        }
        let Some(sign) = self.text.piece(from..).chars().next().filter(|c| !c.is_whitespace()) else {
            return after;
        };
        let closing = if sign == '{' { '}' } else { sign };
        let line = nearby(self.text.piece(from..));
        match line.piece(sign.len_utf8()..).find(closing) {
            Some(found) => self.skip(at, from + sign.len_utf8() + found + closing.len_utf8()),
            None => after,
        }
    }

    fn included(&mut self, at: usize, after: usize, name: &str) -> usize {
        let from = self.spaces(after);
        let rest = nearby(self.text.piece(from..));
        let (file, end) = match braces_end(self.text, from).filter(|_| rest.starts_with('{')) {
            Some(first) if name.ends_with("import") => match braces_end(self.text, first) {
                Some(second) => {
                    (format!("{}/{}", self.inside(from, first), self.inside(first, second)), second)
                }
                None => return after,
            },
            Some(end) => (self.inside(from, end).to_owned(), end),
            None => {
                let file = rest.split([' ', '\t', '\r', '%', '\\', '{', '}']).next().unwrap_or("");
                (file.to_owned(), from + file.len())
            }
        };
        if file.trim().is_empty() || file.contains(['#', '\\']) {
            return after;
        }
        self.end_paragraph(at);
        (self.include)(file.trim(), Span::new(at, end), self.body, self.out);
        self.said = end;
        end
    }

    /// What stands in the braces of `from..to`.
    fn inside(&self, from: usize, to: usize) -> &'a str {
        self.text.piece(from..to).trim().trim_start_matches('{').trim_end_matches('}')
    }

    /// Passes a command with its arguments.
    fn silent(&mut self, at: usize, after: usize) -> usize {
        let end = self.arguments(after);
        self.skip(at, end)
    }

    /// The byte after white space within the line.
    fn spaces(&self, at: usize) -> usize {
        let rest = self.text.piece(at..);
        at + (rest.len() - rest.trim_start_matches([' ', '\t']).len())
    }

    /// The byte after a short argument in brackets.
    fn brackets(&self, at: usize) -> usize {
        let rest = self.text.piece(at..);
        if !rest.starts_with('[') {
            return at;
        }
        rest.bytes().take(400).position(|byte| byte == b']').map_or(at, |close| at + close + 1)
    }

    /// The byte after all arguments, in brackets and braces.
    fn arguments(&self, at: usize) -> usize {
        let mut at = at + usize::from(self.text.piece(at..).starts_with('*'));
        loop {
            let next = self.brackets(at);
            let next = match braces_end(self.text, next) {
                Some(end) if self.text.piece(next..).starts_with('{') => end,
                _ => next,
            };
            if next == at {
                return at;
            }
            at = next;
        }
    }

    fn finish(&mut self) {
        let end = self.text.len();
        if let Some(end) = self.title {
            self.end_title(end);
        }
        self.end_paragraph(end);
        self.close(0, false);
    }
}

fn never_closed(name: &str, place: Span) -> Diagnostic {
    Diagnostic::warning(Code::UnclosedBlock, format!(r"\begin{{{name}}} is never closed"))
        .at(place)
        .reason("it begins here")
        .hint(format!(r"write \end{{{name}}} where it ends"))
}
