//! How large a text is, without knowing the font.
//!
//! The widths are those of Latin Modern and Times, whichever is wider; what is wanted is a box
//! that surely holds the label, not its exact width.

use unicode_width::UnicodeWidthChar;

use super::runs::{Face, Run, runs};
use crate::scene::{Extent, Size, Text};

/// The space that a label takes.
///
/// The one place where widths of texts are estimated; pass it to [`crate::scene::layout()`].
///
/// ```
/// use polarform::{expr::Expr, figure::measure, scene::{Size, Text}};
/// let short = measure(&Text::Formula(Expr::indexed("b", 0)), Size::Normal);
/// let long = measure(&Text::from("a longer text"), Size::Normal);
/// assert!(short.width < long.width);
/// ```
pub fn measure(text: &Text, size: Size) -> Extent {
    let em = size.em();
    let mut extent = Extent { width: 0.0, ascent: 0.0, descent: 0.0 };
    let (mut pen, mut right) = (0.0_f64, 0.0_f64);
    for run in runs(text) {
        pen += run.shift + advance(&run);
        right = right.max(pen);
        for c in run.text.chars() {
            let (above, below) = reach(c);
            extent.ascent = extent.ascent.max(em * (run.rise + above * run.scale));
            extent.descent = extent.descent.max(em * (below * run.scale - run.rise));
        }
    }
    // a little for letters that lean out of their boxes
    extent.width = right.max(pen) * em + 1.0;
    extent
}

/// How far a run moves the pen, in em of the label.
pub(super) fn advance(run: &Run) -> f64 {
    let bold = if run.face == Face::Bold { 1.1 } else { 1.0 };
    run.text.chars().map(|c| width(c, run.face)).sum::<f64>() * run.scale * bold
}

/// The width of a character in em.
fn width(c: char, face: Face) -> f64 {
    match c {
        '0'..='9' => 0.51,
        '\u{2009}' => 0.18,
        ' ' | '\u{a0}' => 0.3,
        '(' | ')' => 0.39,
        '[' | ']' | ',' | '.' | ';' | ':' | '!' | '\'' | '′' | '|' => 0.29,
        '/' | '·' => 0.48,
        '+' | '−' | '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '≡' => 0.72,
        '→' | '↦' | '⇒' | '⇔' | '…' => 1.0,
        'i' | 'l' => 0.31,
        'j' | 't' | 'r' | 'f' if face == Face::Italic => 0.41,
        'j' | 't' | 'r' | 'f' => 0.39,
        'm' => 0.85,
        'w' => 0.75,
        'I' | 'J' => 0.5,
        'M' | 'W' => 0.98,
        'A'..='Z' => 0.75,
        'a'..='z' => 0.53,
        _ => match c.width() {
            Some(0) | None => 0.0,
            Some(1) if c.is_uppercase() => 0.8,
            Some(1) => 0.6,
            Some(_) => 1.05,
        },
    }
}

/// How far a character reaches above and below its line, in em.
fn reach(c: char) -> (f64, f64) {
    match c {
        '(' | ')' | '[' | ']' | '/' | '|' | '{' | '}' => (0.76, 0.25),
        ',' | ';' => (0.45, 0.2),
        '0'..='9' | 'A'..='Z' => (0.69, 0.02),
        'b' | 'd' | 'f' | 'h' | 'k' | 'l' | 'i' | 't' => (0.71, 0.02),
        'g' | 'p' | 'q' | 'y' => (0.46, 0.23),
        'j' => (0.67, 0.23),
        'a'..='z' | ' ' | '\u{2009}' => (0.46, 0.02),
        '+' | '−' | '=' => (0.6, 0.1),
        // an accent over the letter before it
        '\u{300}'..='\u{36f}' | '\u{20d0}'..='\u{20ff}' => (0.85, 0.0),
        _ => (0.8, 0.22),
    }
}
