//! Lines and columns of spans, found in one pass over the file.

use crate::formula::source::{Pieces, SourceFile, Span, floor_boundary};

/// A place in a file, everything counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// The line.
    pub line: usize,
    /// The column in characters.
    pub column: usize,
    /// The column in UTF-16 code units.
    pub unit: usize,
}

/// Both ends of a span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Region {
    /// Its first character.
    pub start: Place,
    /// Just behind its last character.
    pub end: Place,
}

impl Region {
    /// The line of its last character.
    pub fn last_line(self) -> usize {
        self.end.line - usize::from(self.end.column == 1 && self.end.line > self.start.line)
    }
}

/// Finds the places of spans. Spans in the order of the file cost one pass over it, however long
/// its lines are.
pub(super) struct Locator<'a> {
    starts: Cursor<'a>,
    ends: Cursor<'a>,
}

impl<'a> Locator<'a> {
    pub fn new(file: &'a SourceFile) -> Self {
        Locator { starts: Cursor::new(file.text()), ends: Cursor::new(file.text()) }
    }

    /// The place of one byte, asked for in the order of the file.
    pub fn place(&mut self, byte: usize) -> Place {
        self.starts.place(byte)
    }

    pub fn region(&mut self, span: Span) -> Region {
        Region { start: self.starts.place(span.start), end: self.ends.place(span.end) }
    }
}

/// A place that moves through a text.
struct Cursor<'a> {
    text: &'a str,
    byte: usize,
    place: Place,
}

impl<'a> Cursor<'a> {
    fn new(text: &'a str) -> Self {
        Cursor { text, byte: 0, place: Place { line: 1, column: 1, unit: 1 } }
    }

    fn place(&mut self, byte: usize) -> Place {
        let byte = floor_boundary(self.text, byte);
        if byte < self.byte {
            // Back to the start of the line that holds the byte.
            let back = self.text.piece(..byte).rfind('\n').map_or(0, |at| at + 1);
            self.place.line -= self.text.piece(back..self.byte).bytes().filter(|&b| b == b'\n').count();
            (self.place.column, self.place.unit) = (1, 1);
            self.byte = back;
        }
        for character in self.text.piece(self.byte..byte).chars() {
            if character == '\n' {
                self.place = Place { line: self.place.line + 1, column: 1, unit: 1 };
            } else {
                self.place.column += 1;
                self.place.unit += character.len_utf16();
            }
        }
        self.byte = byte;
        self.place
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn columns_count_characters_or_units() {
        let file = SourceFile::new("x", "设 𝒇(t)\r\nab");
        let region = Locator::new(&file).region(Span::new("设 ".len(), "设 𝒇".len()));
        assert_eq!(region.start, Place { line: 1, column: 3, unit: 3 });
        assert_eq!(region.end, Place { line: 1, column: 4, unit: 5 });
        let end = Locator::new(&file).region(Span::new(99, 99)).end;
        assert_eq!(end, Place { line: 2, column: 3, unit: 3 });
    }

    proptest! {
        #[test]
        fn the_order_of_questions_does_not_matter(
            text in "[a中𝒇\r\n]{0,30}",
            places in prop::collection::vec(0usize..80, 1..10),
        ) {
            let file = SourceFile::new("x", text.clone());
            let mut locator = Locator::new(&file);
            for byte in places {
                let place = locator.region(Span::new(byte, byte)).start;
                let floor = floor_boundary(&text, byte);
                prop_assert_eq!((place.line, place.column), file.line_column(floor));
            }
        }
    }
}
