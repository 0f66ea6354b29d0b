//! Places as editors count them: lines, and UTF-16 code units in a line, both from 0.
//!
//! **Definition.** Lines end with `\n`, `\r\n` or `\r` (Language Server Protocol 3.17, *Text Documents*). A place behind
//! the end of its line is the end of the line.

use lsp_types::{Position, Range};

use crate::formula::source::{Span, floor_boundary};

/// So many bytes at most stand between two marks; a line may be as long as the file.
const STRIDE: usize = 1024;

/// A byte of the text and its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mark {
    byte: usize,
    line: u32,
    unit: u32,
}

/// Where the bytes of a text are. Cost: linear to make; then logarithmic for each place, plus a constant.
#[derive(Debug)]
pub(super) struct Places {
    /// The first byte of each line, and more in long lines.
    marks: Vec<Mark>,
}

/// Whether a line ends behind the character at a byte.
fn ends_line(text: &str, byte: usize, c: char) -> bool {
    c == '\n' || c == '\r' && text.as_bytes().get(byte + 1) != Some(&b'\n')
}

impl Places {
    pub fn new(text: &str) -> Self {
        let mut marks = vec![Mark { byte: 0, line: 0, unit: 0 }];
        let (mut line, mut unit, mut last) = (0, 0, 0);
        for (byte, c) in text.char_indices() {
            if byte - last >= STRIDE {
                marks.push(Mark { byte, line, unit });
                last = byte;
            }
            unit += c.len_utf16() as u32;
            if ends_line(text, byte, c) {
                (line, unit, last) = (line + 1, 0, byte + 1);
                marks.push(Mark { byte: last, line, unit });
            }
        }
        Places { marks }
    }

    /// The place of a byte of the text.
    pub fn position(&self, text: &str, byte: usize) -> Position {
        let byte = floor_boundary(text, byte);
        let mark = self.marks[self.marks.partition_point(|mark| mark.byte <= byte) - 1];
        let units: usize = text[mark.byte..byte].chars().map(char::len_utf16).sum();
        Position::new(mark.line, mark.unit + units as u32)
    }

    pub fn range(&self, text: &str, span: Span) -> Range {
        Range::new(self.position(text, span.start), self.position(text, span.end))
    }

    /// The byte at a place; within a character it is the first one of it.
    pub fn byte(&self, text: &str, position: Position) -> usize {
        let wanted = (position.line, position.character);
        let at = self.marks.partition_point(|mark| (mark.line, mark.unit) <= wanted) - 1;
        let mark = self.marks[at];
        if mark.line < position.line {
            return text.len();
        }
        let mut unit = mark.unit;
        for (offset, c) in text[mark.byte..].char_indices() {
            let byte = mark.byte + offset;
            unit += c.len_utf16() as u32;
            if unit > position.character || matches!(c, '\n' | '\r') {
                return byte;
            }
        }
        text.len()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The same by cutting the text into lines.
    fn slowly(text: &str, byte: usize) -> Position {
        let before = &text[..byte];
        let ended = before.replace("\r\n", "\n").replace('\r', "\n");
        // Between the two signs of one line end, the line goes on.
        let inside = before.ends_with('\r') && text[byte..].starts_with('\n');
        let lines = ended.matches('\n').count() - usize::from(inside);
        let own = before.strip_suffix('\r').filter(|_| inside).unwrap_or(before);
        let start = own.rfind(['\n', '\r']).map_or(0, |at| at + 1);
        Position::new(lines as u32, before[start..].encode_utf16().count() as u32)
    }

    #[test]
    fn units_of_utf16() {
        let text = "设 𝒇(t)\r\nab\rc\n";
        let places = Places::new(text);
        let at = |part: &str| places.position(text, text.find(part).expect("it is there"));
        assert_eq!(at("(t"), Position::new(0, 4));
        assert_eq!(at("b\r"), Position::new(1, 1));
        assert_eq!(at("c\n"), Position::new(2, 0));
        assert_eq!(places.position(text, text.len()), Position::new(3, 0));
        // In the middle of a character, behind a line, behind the text.
        assert_eq!(places.byte(text, Position::new(0, 3)), "设 ".len());
        assert_eq!(places.byte(text, Position::new(1, 99)), text.find("\rc").unwrap());
        assert_eq!(places.byte(text, Position::new(9, 0)), text.len());
        assert_eq!(places.byte(text, Position::new(u32::MAX, u32::MAX)), text.len());
    }

    #[test]
    fn long_lines() {
        let text = "𝒇a".repeat(5000) + "\nend";
        let places = Places::new(&text);
        for byte in [0, 4, 5 * 3000, 5 * 5000, text.len()] {
            let position = places.position(&text, byte);
            assert_eq!(position, slowly(&text, byte));
            assert_eq!(places.byte(&text, position), byte);
        }
    }

    proptest! {
        #[test]
        fn places_and_bytes_belong_together(text in "[a中𝒇\r\n]{0,40}") {
            let places = Places::new(&text);
            for (byte, c) in text.char_indices().chain([(text.len(), ' ')]) {
                let position = places.position(&text, byte);
                prop_assert_eq!(position, slowly(&text, byte), "{:?} at {}", text, byte);
                // Within a line end there is no place of its own.
                if !(c == '\n' && text[..byte].ends_with('\r')) {
                    prop_assert_eq!(places.byte(&text, position), byte);
                }
            }
        }
    }
}
