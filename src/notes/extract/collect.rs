//! Where the readers of containers put what they find.

use std::borrow::Cow;

use super::macros::{Macros, Text, command_name};
use super::plain;
use crate::diagnostic::{Code, Diagnostic};
use crate::notes::document::{Enclosure, Formula, Item, Style};
use crate::source::Span;

/// The pieces found so far.
#[derive(Default)]
pub(super) struct Collector {
    pub(super) items: Vec<Item>,
    pub(super) problems: Vec<Diagnostic>,
    pub(super) macros: Macros,
}

impl Collector {
    /// A formula: `text` as it stands at byte `start`, without the signs around it.
    pub(super) fn formula(&mut self, style: Style, text: &str, start: usize) {
        let start = start + (text.len() - text.trim_start().len());
        let span = Span::new(start, start + text.trim().len());
        let text = Text::plain(without_labels(text.trim()), start);
        let text = self.macros.expand(text, &mut self.problems);
        if !text.text.trim().is_empty() {
            self.items.push(Item::Formula(Formula { style, span, text: text.text, places: text.places }));
        }
    }

    /// Words among which formulas in plain notation may stand; `continues` a formula before them.
    pub(super) fn prose(&mut self, text: &str, start: usize, continues: bool) {
        for (i, (line, at)) in lines(text, start).enumerate() {
            let mut said = 0;
            for found in plain::find(line, continues && i == 0) {
                self.line(&line[said..found.range.start], at + said);
                said = found.range.end;
                self.formula(Style::Plain, &found.text, at + found.range.start);
            }
            self.line(&line[said..], at + said);
        }
    }

    fn line(&mut self, line: &str, at: usize) {
        let begin = at + (line.len() - line.trim_start().len());
        let len = line.trim().len();
        if len > 0 {
            self.items.push(Item::Words(Span::new(begin, begin + len)));
        }
    }

    /// The end of a paragraph, unless nothing was said since the last one.
    pub(super) fn end_paragraph(&mut self) {
        let last = self.items.iter().rev().find(|item| !matches!(item, Item::Declaration { .. }));
        if !matches!(last, None | Some(Item::Break | Item::Enter(_) | Item::Leave(_))) {
            self.items.push(Item::Break);
        }
    }

    pub(super) fn enter(&mut self, what: Enclosure) {
        self.items.push(Item::Enter(what));
    }

    pub(super) fn leave(&mut self, what: Enclosure) {
        self.items.push(Item::Leave(what));
    }

    /// A sign that opens a formula which is never closed.
    pub(super) fn unclosed(&mut self, sign: &str, at: usize, closing: &str) {
        let problem = Diagnostic::warning(Code::UnclosedFormula, format!("{sign} is never closed"))
            .at(Span::new(at, at + sign.len()))
            .reason("a formula begins here");
        self.problems.push(if sign == "$" {
            problem.hint(r"write $ after the formula, or \$ for the currency")
        } else {
            problem.hint(format!("write {closing} after the formula"))
        });
    }
}

/// The lines of a text with the bytes where they start.
fn lines(text: &str, start: usize) -> impl Iterator<Item = (&str, usize)> {
    let mut at = start;
    text.split('\n').map(move |line| {
        let begin = at;
        at += line.len() + 1;
        (line, begin)
    })
}

/// The formula with `\label{…}`, `\tag{…}`, `\nonumber`, `\notag` and `\intertext{…}` blanked.
fn without_labels(text: &str) -> Cow<'_, str> {
    let mut blanked: Option<String> = None;
    let mut at = 0;
    while let Some(found) = text[at..].find('\\') {
        at += found;
        let name = command_name(text, at);
        let after = at + 1 + name.len();
        let end = match name {
            "nonumber" | "notag" => after,
            "label" | "tag" | "intertext" | "shortintertext" => {
                let star = after + usize::from(text[after..].starts_with('*'));
                braces_end(text, star).unwrap_or(after)
            }
            _ => {
                at = after;
                continue;
            }
        };
        let blanked = blanked.get_or_insert_with(|| text.to_owned());
        // Line ends stay, so that a comment before them ends where it did.
        let blank: String =
            text[at..end].bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect();
        blanked.replace_range(at..end, &blank);
        at = end;
    }
    blanked.map_or(Cow::Borrowed(text), Cow::Owned)
}

/// The byte after the group in braces at `at`.
fn braces_end(text: &str, at: usize) -> Option<usize> {
    let open = at + (text[at..].len() - text[at..].trim_start().len());
    let mut depth = 0_usize;
    for (i, byte) in text[open..].bytes().enumerate().take(MAX_LABEL) {
        match byte {
            b'{' => depth += 1,
            b'}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (i > 0).then_some(open + i + 1);
        }
    }
    None
}

/// A longer label or text between rows is not looked for.
const MAX_LABEL: usize = 4000;
