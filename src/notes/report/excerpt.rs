//! The lines of a file around a mark, cut so that they can be shown.

use std::ops::Range;

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::formula::source::{Pieces, SourceFile, Span, floor_boundary};

/// Lines wider than this many columns are cut.
const WIDTH: usize = 100;

/// A mark over more lines than this is shown by its first ones.
const LINES: usize = 6;

/// Lines of the same formula shown before and behind the mark.
const AROUND: usize = 2;

/// Bytes that are looked at before and behind a mark to find the ends of its line.
const REACH: usize = 4096;

/// Some lines of a file with a mark in them.
#[derive(Debug, PartialEq)]
pub(super) struct Excerpt {
    /// The lines; what was cut off shows as `…`.
    pub text: String,
    /// How many of them come before the mark.
    pub before: usize,
    /// Where the mark starts in the file.
    pub start: usize,
    /// The mark in `text`.
    pub mark: Range<usize>,
    /// The column of the mark in `text`, in characters from 1.
    pub column: usize,
}

impl Excerpt {
    /// The lines of `mark`, with their neighbours as far as they belong to `whole`. The cost does
    /// not depend on the length of the file or of its lines.
    pub fn new(file: &SourceFile, whole: Span, mark: Span) -> Self {
        let text = file.text();
        let (whole, mark) = (trimmed(text, whole), trimmed(text, mark));
        let mut excerpt =
            Excerpt { text: String::new(), before: 0, start: mark.start, mark: 0..0, column: 1 };
        let found = line_start(text, mark.start);
        let mut start = found.unwrap_or_else(|| floor_boundary(text, mark.start.saturating_sub(REACH)));
        while excerpt.before < AROUND && found.is_some() && start > whole.start.max(1) {
            let Some(previous) = line_start(text, start - 1) else { break };
            start = previous;
            excerpt.before += 1;
        }
        let mut behind = 0;
        for number in 0.. {
            let horizon = floor_boundary(text, start + 2 * REACH);
            let line_end = text.piece(start..horizon).find('\n').map(|at| start + at);
            let end = line_end.unwrap_or(horizon);
            let cut = (number == 0 && found.is_none(), line_end.is_none() && horizon < text.len());
            let marked = mark.start.max(start)..mark.end.min(end);
            excerpt.push_line(
                text.piece(start..end),
                start,
                cut,
                (marked.start <= marked.end).then_some(marked),
            );
            behind += usize::from(mark.end <= end);
            let enough = behind > AROUND || number >= excerpt.before + LINES;
            if enough || line_end.is_none() || (behind > 0 && end >= whole.end) {
                break;
            }
            start = end + 1;
            excerpt.text.push('\n');
        }
        excerpt
    }

    /// Adds a line that starts at byte `start` of the file, with its part of the mark; `cut` says
    /// whether there is more of it on the left and on the right.
    fn push_line(&mut self, line: &str, start: usize, cut: (bool, bool), marked: Option<Range<usize>>) {
        let line = line.strip_suffix('\r').unwrap_or(line);
        let local = |byte: usize| byte.saturating_sub(start).min(line.len());
        let focus = marked.clone().map_or(0..0, |part| local(part.start)..local(part.end));
        let window = window(line, &focus);
        if window.start > 0 || cut.0 {
            self.text.push('…');
        }
        let at = self.text.len();
        self.text.push_str(line.piece(window.clone()));
        if window.end < line.len() || cut.1 {
            self.text.push('…');
        }
        if marked.is_some() {
            let shown = |byte: usize| at + byte.clamp(window.start, window.end) - window.start;
            if self.mark == (0..0) {
                self.mark.start = shown(focus.start);
                let line = self.text.piece(..self.mark.start).rfind('\n').map_or(0, |at| at + 1);
                self.column = self.text.piece(line..self.mark.start).chars().count() + 1;
            }
            self.mark.end = shown(focus.end);
        }
    }
}

/// The span on boundaries of characters, without white space at its ends.
fn trimmed(text: &str, span: Span) -> Span {
    let start = floor_boundary(text, span.start);
    let part = text.piece(start..floor_boundary(text, span.end).max(start));
    let inner = part.trim();
    if inner.is_empty() {
        return Span::new(start, start);
    }
    let start = start + (part.len() - part.trim_start().len());
    Span::new(start, start + inner.len())
}

/// Where the line of a byte starts, if that is not too far.
fn line_start(text: &str, byte: usize) -> Option<usize> {
    let from = floor_boundary(text, byte.saturating_sub(REACH));
    match text.piece(from..byte).rfind('\n') {
        Some(at) => Some(from + at + 1),
        None => (from == 0).then_some(0),
    }
}

/// The part of a line that is shown: all of it, or the columns around the start of `focus`.
fn window(line: &str, focus: &Range<usize>) -> Range<usize> {
    if line.len() <= WIDTH || line.width() <= WIDTH {
        return 0..line.len();
    }
    let mut start = 0;
    if line.piece(..focus.end).width() >= WIDTH {
        let mut room = WIDTH / 3;
        start = focus.start;
        for (at, character) in line.piece(..focus.start).char_indices().rev() {
            match room.checked_sub(character.width().unwrap_or(1)) {
                Some(left) => (room, start) = (left, at),
                None => break,
            }
        }
    }
    let end = start + fitting(line.piece(start..), WIDTH);
    start..end
}

/// How many bytes of a line fit into some columns.
pub(super) fn fitting(line: &str, columns: usize) -> usize {
    let mut room = columns;
    for (at, character) in line.char_indices() {
        match room.checked_sub(character.width().unwrap_or(1)) {
            Some(left) => room = left,
            None => return at,
        }
    }
    line.len()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(text: &str, whole: &str, mark: &str) -> Excerpt {
        let find = |part: &str| {
            let at = text.find(part).expect("the part is in the text");
            Span::new(at, at + part.len())
        };
        Excerpt::new(&SourceFile::new("x", text), find(whole), find(mark))
    }

    #[test]
    fn neighbours_belong_to_the_formula() {
        let text = "before\n$$\na\nb = 1\nc\n$$\nbehind";
        let excerpt = of(text, "a\nb = 1\nc", "=");
        assert_eq!((excerpt.text.as_str(), excerpt.before), ("a\nb = 1\nc", 1));
        assert_eq!((&excerpt.text[excerpt.mark.clone()], excerpt.column), ("=", 3));
        let alone = of(text, "b = 1", "=");
        assert_eq!((alone.text.as_str(), alone.before), ("b = 1", 0));
    }

    #[test]
    fn line_ends_are_no_part_of_lines() {
        let excerpt = of("a\r\nb = \r\n1\r\n", "b = \r\n1", "b = \r\n1");
        assert_eq!((excerpt.text.as_str(), excerpt.mark), ("b = \n1", 0..6));
    }

    #[test]
    fn long_lines_are_cut_around_the_mark() {
        for times in [100, 10_000] {
            let text = format!("{}控制点 b = c {}", "多项式".repeat(times), "words ".repeat(times));
            let excerpt = of(&text, "b = c", "=");
            assert!(excerpt.text.width() <= WIDTH + 2, "{}", excerpt.text.width());
            assert!(excerpt.text.starts_with('…') && excerpt.text.ends_with('…'));
            assert_eq!(&excerpt.text[excerpt.mark.clone()], "=");
            assert_eq!(excerpt.text.chars().nth(excerpt.column - 1), Some('='));
        }
    }

    #[test]
    fn a_long_mark_is_shown_by_its_first_lines() {
        let text = "x\n".repeat(50);
        let all = Span::new(0, text.len());
        let excerpt = Excerpt::new(&SourceFile::new("x", text), all, all);
        assert_eq!(excerpt.text.lines().count(), LINES + 1);
        assert_eq!(excerpt.mark, 0..excerpt.text.len());
    }

    proptest! {
        #[test]
        fn any_span_can_be_shown(
            text in "[a中𝒇\u{301}\t\r\n ]{0,60}",
            wide in any::<bool>(),
            places in prop::array::uniform4(0usize..300),
        ) {
            let text = if wide { text.replace('a', &"宽w".repeat(40)) } else { text };
            let [a, b, c, d] = places;
            let excerpt = Excerpt::new(&SourceFile::new("x", text), Span::new(a, b), Span::new(c, d));
            prop_assert!(excerpt.text.get(excerpt.mark.clone()).is_some(), "{:?}", excerpt);
            prop_assert!(excerpt.before <= excerpt.text[..excerpt.mark.start].lines().count());
        }
    }
}
