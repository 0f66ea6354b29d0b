//! A text derived from a file, and where its bytes come from.

use std::ops::Range;

use crate::document::Places;
use crate::formula::source::{Pieces, Span};

/// Names of commands are not longer.
const MAX_NAME: usize = 60;

/// A text with the places of its bytes in the file.
#[derive(Clone, Debug, Default)]
pub(super) struct Text {
    pub(super) text: String,
    pub(super) places: Places,
}

impl Text {
    /// The bytes of the file from `start` on.
    pub(super) fn plain(text: impl Into<String>, start: usize) -> Self {
        Text { text: text.into(), places: Places::plain(start) }
    }

    /// Adds text that stands for the bytes `file`.
    pub(super) fn push_whole(&mut self, text: &str, file: Span) {
        if !text.is_empty() {
            self.places.push_whole(self.text.len(), file);
            self.text.push_str(text);
        }
    }

    /// Adds a part of another text.
    pub(super) fn push_part(&mut self, from: &Text, part: Range<usize>) {
        if !part.is_empty() {
            self.places.append(self.text.len(), &from.places, Span::new(part.start, part.end));
            self.text.push_str(from.text.piece(part));
        }
    }

    /// A space if the next letter would become part of the command at the end.
    pub(super) fn separate(&mut self, next: &str, file: Span) {
        let letters = self.text.bytes().rev().take(MAX_NAME).take_while(u8::is_ascii_alphabetic).count();
        let before = self.text.piece(..self.text.len() - letters);
        let ends = letters > 0 && before.ends_with('\\') && !before.ends_with(r"\\");
        if ends && next.starts_with(|c: char| c.is_ascii_alphabetic()) {
            self.push_whole(" ", file);
        }
    }
}
