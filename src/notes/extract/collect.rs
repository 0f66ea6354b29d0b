//! Where the readers of containers put what they find.

use crate::diagnostic::{Code, Diagnostic};
use crate::notes::document::{Enclosure, Formula, Item, Places, Style};
use crate::source::Span;

/// The pieces found so far.
#[derive(Default)]
pub(super) struct Collector {
    pub(super) items: Vec<Item>,
    pub(super) problems: Vec<Diagnostic>,
}

impl Collector {
    /// A formula: `text` as it stands at byte `start`, without the signs around it.
    pub(super) fn formula(&mut self, style: Style, text: &str, start: usize) {
        let start = start + (text.len() - text.trim_start().len());
        let text = text.trim();
        if text.is_empty() {
            return;
        }
        self.items.push(Item::Formula(Formula {
            style,
            span: Span::new(start, start + text.len()),
            text: text.to_owned(),
            places: Places::plain(start),
        }));
    }

    /// Words on one or several lines.
    pub(super) fn words(&mut self, text: &str, start: usize) {
        let mut at = start;
        for line in text.split('\n') {
            let trimmed = line.trim();
            if !trimmed.is_empty() {
                let begin = at + (line.len() - line.trim_start().len());
                self.items.push(Item::Words(Span::new(begin, begin + trimmed.len())));
            }
            at += line.len() + 1;
        }
    }

    /// The end of a paragraph, unless nothing was said since the last one.
    pub(super) fn end_paragraph(&mut self) {
        if !matches!(self.items.last(), None | Some(Item::Break | Item::Enter(_) | Item::Leave(_))) {
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
