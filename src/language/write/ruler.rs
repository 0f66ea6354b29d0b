//! How wide formulas in LaTeX are, about.

use super::lines::{QUAD, RELATIONS, command};

/// The width of a formula in LaTeX, about, in points at a size of ten points.
///
/// ```
/// use polarform::write::measured;
/// assert!(measured("a + b") > measured("a b"));
/// assert!(measured(r"\frac{a + b}{c}") < measured("(a + b) c"));
/// ```
pub fn measured(latex: &str) -> f64 {
    /// What pieces are rounded off, in all.
    const SAFETY: f64 = 1.02;
    SAFETY * Ruler { text: latex, at: 0 }.run(false)
}

/// Widths in Computer Modern at ten points.
const LETTER: f64 = 5.4;
const NARROW: f64 = 3.9;
const OPERATOR: f64 = 12.3;
const RELATION: f64 = 13.4;
const SCRIPT: f64 = 0.72;

struct Ruler<'a> {
    text: &'a str,
    at: usize,
}

impl Ruler<'_> {
    /// The width up to the end, or to the brace that closes.
    fn run(&mut self, in_braces: bool) -> f64 {
        let mut width: f64 = 0.0;
        let mut widest: f64 = 0.0;
        while let Some(c) = self.text[self.at..].chars().next() {
            if c == '}' && in_braces {
                self.at += 1;
                break;
            }
            if self.text[self.at..].starts_with("\\\\") {
                self.at += 2;
                widest = widest.max(width);
                width = 0.0;
                continue;
            }
            width += self.piece(c);
        }
        widest.max(width)
    }

    fn piece(&mut self, c: char) -> f64 {
        if c == '\\' {
            let name = command(&self.text[self.at..]);
            self.at += name.len();
            return self.of_command(name);
        }
        self.at += c.len_utf8();
        match c {
            '{' => self.run(true),
            '}' | ' ' | '\n' => 0.0,
            '_' => SCRIPT * self.argument(),
            '^' => match self.text[..self.at - 1].trim_end().ends_with('}') || self.after_index() {
                // above an index
                true => (SCRIPT * self.argument() - LETTER).max(0.0),
                false => SCRIPT * self.argument(),
            },
            '+' | '-' => OPERATOR,
            '=' | '<' | '>' => RELATION,
            '(' | ')' | '[' | ']' | '|' | '.' | ':' | ';' | '\'' => NARROW,
            ',' => 4.5,
            '&' => 20.0,
            'm' | 'w' | 'M' | 'W' => 8.5,
            'B' | 'D' | 'H' | 'K' | 'N' | 'Q' | 'R' | 'U' | 'X' => 7.9,
            _ => LETTER,
        }
    }

    /// Whether an index of one letter ends here, as before the ^ of b_0^2.
    fn after_index(&self) -> bool {
        let before = &self.text.as_bytes()[..self.at - 1];
        before.len() > 1 && before[before.len() - 2] == b'_'
    }

    /// The width of the next argument: braces, a command or one character.
    fn argument(&mut self) -> f64 {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        match self.text[self.at..].chars().next() {
            Some(c) => self.piece(c),
            None => 0.0,
        }
    }

    fn of_command(&mut self, name: &str) -> f64 {
        match name {
            "\\frac" | "\\tfrac" | "\\dfrac" | "\\binom" => {
                let (above, below) = (self.argument(), self.argument());
                above.max(below) + if name == "\\binom" { 14.0 } else { 2.4 }
            }
            "\\begin" | "\\end" => {
                self.argument();
                10.0
            }
            "\\left" | "\\right" => 4.5,
            "\\," | "\\!" | "\\;" | "\\:" => 2.0,
            "\\quad" => QUAD,
            "\\qquad" => 2.0 * QUAD,
            "\\cdot" | "\\times" | "\\circ" => 7.0,
            "\\sum" | "\\prod" | "\\int" => 14.0,
            "\\hat" | "\\vec" | "\\bar" | "\\tilde" | "\\mathbf" | "\\mathrm" | "\\text"
            | "\\operatorname" => self.argument(),
            _ if RELATIONS.contains(&name) || name == "\\mapsto" || name == "\\to" => RELATION,
            _ => 5.8,
        }
    }
}
