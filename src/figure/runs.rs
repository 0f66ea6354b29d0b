//! Formulas as runs of characters: what a text element of a drawing can show.

use crate::formula::{Accent, Enclosure, Expr, Kind, Precedence, Quotient, Sign};
use crate::language::write::{unicode, unicode_relation};
use crate::scene::Text;

use super::measure::advance;

/// How the characters of a run look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Face {
    /// Names.
    Italic,
    /// Numbers, signs, words.
    Upright,
    /// Names of vectors and matrices.
    Bold,
}

/// Characters set alike.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub(super) text: String,
    pub(super) face: Face,
    /// The size, in sizes of the label.
    pub(super) scale: f64,
    /// How far above the line it stands, in em of the label.
    pub(super) rise: f64,
    /// How far it is moved to the right of where the run before it ends, in em of the label.
    pub(super) shift: f64,
}

/// Beyond this depth a formula is set as plain text, whatever it holds.
const DEEPEST: usize = 40;

/// Thin space of mathematics.
const THIN: &str = "\u{2009}";

/// The label as runs, from left to right.
pub(super) fn runs(text: &Text) -> Vec<Run> {
    let mut setter = Setter::default();
    match text {
        Text::Words(words) => setter.push(words, Face::Upright, Line::BASE),
        Text::Formula(formula) => setter.set(formula, Line::BASE, 0),
    }
    setter.runs
}

/// Where characters stand.
#[derive(Clone, Copy)]
struct Line {
    scale: f64,
    rise: f64,
}

impl Line {
    const BASE: Line = Line { scale: 1.0, rise: 0.0 };

    fn script(self, up: bool) -> Line {
        let rise = if up { 0.36 } else { -0.2 };
        Line { scale: (self.scale * 0.72).max(0.5), rise: self.rise + rise * self.scale }
    }
}

#[derive(Default)]
struct Setter {
    runs: Vec<Run>,
    /// How far the next run is moved.
    shift: f64,
}

impl Setter {
    fn push(&mut self, text: &str, face: Face, line: Line) {
        // characters that XML has no place for, and line ends
        let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        if text.is_empty() {
            return;
        }
        let shift = std::mem::take(&mut self.shift);
        match self.runs.last_mut() {
            Some(last)
                if shift == 0.0
                    && last.face == face
                    && last.scale == line.scale
                    && last.rise == line.rise =>
            {
                last.text.push_str(&text);
            }
            _ => self.runs.push(Run { text, face, scale: line.scale, rise: line.rise, shift }),
        }
    }

    fn sign(&mut self, text: &str, line: Line) {
        self.push(text, Face::Upright, line);
    }

    /// Where the next character would be, in em.
    fn pen(&self) -> f64 {
        self.shift + self.runs.iter().map(|run| run.shift + advance(run)).sum::<f64>()
    }

    /// An operand, in parentheses if it holds together less than `level`.
    fn operand(&mut self, expr: &Expr, level: Precedence, line: Line, depth: usize) {
        let open = expr.precedence() < level;
        if open {
            self.sign("(", line);
        }
        self.set(expr, line, depth + 1);
        if open {
            self.sign(")", line);
        }
    }

    fn list(&mut self, items: &[Expr], line: Line, depth: usize) {
        // scripts have no room for spaces
        let comma = if line.scale < 1.0 { ",".to_owned() } else { format!(",{THIN}") };
        for (i, item) in items.iter().enumerate() {
            if i > 0 {
                self.sign(&comma, line);
            }
            self.operand(item, Precedence::Relation, line, depth);
        }
    }

    fn fenced(&mut self, fence: (&str, &str), items: &[Expr], line: Line, depth: usize) {
        self.sign(fence.0, line);
        self.list(items, line, depth);
        self.sign(fence.1, line);
    }

    /// An operator with spaces around it, or without in an index.
    fn spaced(&mut self, sign: &str, line: Line) {
        if line.scale < 1.0 {
            self.sign(sign, line);
        } else {
            self.sign(&format!("{THIN}{sign}{THIN}"), line);
        }
    }

    /// The base with an upper script; above a lower script, if the base has one.
    fn raised(&mut self, base: &Expr, line: Line, depth: usize, script: impl FnOnce(&mut Self, Line)) {
        let Kind::Subscript(name, indices) = &base.kind else {
            self.operand(base, Precedence::Postfix, line, depth);
            script(self, line.script(true));
            return;
        };
        self.operand(name, Precedence::Atom, line, depth);
        let start = self.pen();
        self.list(indices, line.script(false), depth + 1);
        let below = self.pen();
        self.shift += start - below;
        script(self, line.script(true));
        self.shift += (below - self.pen()).max(0.0);
    }

    fn set(&mut self, expr: &Expr, line: Line, depth: usize) {
        if depth > DEEPEST {
            return self.sign(&unicode(expr), line);
        }
        match &expr.kind {
            Kind::Name(name) => self.name(name, Face::Italic, line),
            Kind::Number(_) => self.sign(&unicode(expr).replace('-', "−"), line),
            Kind::Text(words) => self.sign(words, line),
            Kind::Ellipsis => self.sign("…", line),
            Kind::Subscript(base, indices) => {
                self.operand(base, Precedence::Atom, line, depth);
                self.list(indices, line.script(false), depth + 1);
            }
            Kind::Upper(base, indices) => self.raised(base, line, depth, |setter, script| {
                setter.fenced(("(", ")"), indices, script, depth + 1);
            }),
            Kind::Pow(base, exponent) => self.raised(base, line, depth, |setter, script| {
                let inner = match &exponent.kind {
                    Kind::Group(inner) => inner,
                    _ => exponent,
                };
                setter.set(inner, script, depth + 1);
            }),
            Kind::Transpose(base) => {
                self.raised(base, line, depth, |setter, script| setter.sign("T", script))
            }
            Kind::Prime(base, count) => {
                self.operand(base, Precedence::Postfix, line, depth);
                self.sign(&"′".repeat(*count as usize), line);
            }
            Kind::Accent(accent, body) => self.accent(*accent, body, expr, line),
            Kind::Add(terms) => {
                for (i, term) in terms.iter().enumerate() {
                    match (term.sign, i) {
                        (Sign::Plus, 0) => {}
                        (Sign::Minus, 0) => self.sign("−", line),
                        (Sign::Plus, _) => self.spaced("+", line),
                        (Sign::Minus, _) => self.spaced("−", line),
                    }
                    self.operand(&term.expr, Precedence::Product, line, depth);
                }
            }
            Kind::Mul(factors) => {
                for (i, factor) in factors.iter().enumerate() {
                    if i > 0 {
                        self.sign(between(&factors[i - 1], factor), line);
                    }
                    self.operand(factor, Precedence::Product, line, depth);
                }
            }
            Kind::Div(above, below, quotient) => {
                // a fraction becomes a quotient, whose parts hold together less
                let level =
                    if *quotient == Quotient::Fraction { Precedence::Compose } else { Precedence::Product };
                self.operand(above, level.min(Precedence::Product), line, depth);
                self.sign("/", line);
                self.operand(below, Precedence::Compose, line, depth);
            }
            Kind::Apply(callee, groups) => {
                self.operand(callee, Precedence::Postfix, line, depth);
                if italic_f(callee) {
                    self.shift += 0.06 * line.scale;
                }
                self.sign("(", line);
                for (i, group) in groups.iter().enumerate() {
                    if i > 0 {
                        self.sign(&format!(";{THIN}"), line);
                    }
                    self.list(group, line, depth);
                }
                self.sign(")", line);
            }
            Kind::Group(body) => self.fenced(("(", ")"), std::slice::from_ref(&**body), line, depth),
            Kind::Tuple(items) => self.fenced(("(", ")"), items, line, depth),
            Kind::List(items) => self.fenced(("[", "]"), items, line, depth),
            Kind::Set(items, None) => self.fenced(("{", "}"), items, line, depth),
            Kind::Factorial(body) => {
                self.operand(body, Precedence::Postfix, line, depth);
                self.sign("!", line);
            }
            Kind::Enclosed(enclosure, body) => {
                let fence = match enclosure {
                    Enclosure::Abs => ("|", "|"),
                    Enclosure::Norm => ("‖", "‖"),
                    Enclosure::Floor => ("⌊", "⌋"),
                    Enclosure::Ceil => ("⌈", "⌉"),
                };
                self.fenced(fence, std::slice::from_ref(&**body), line, depth);
            }
            Kind::Compose(items) => {
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        self.spaced("∘", line);
                    }
                    self.operand(item, Precedence::Power, line, depth);
                }
            }
            Kind::Chain(first, links) => {
                self.operand(first, Precedence::Lambda, line, depth);
                for link in links {
                    self.spaced(unicode_relation(link.rel).trim(), line);
                    self.operand(&link.expr, Precedence::Lambda, line, depth);
                }
            }
            Kind::Sequence(items) => self.list(items, line, depth),
            _ => self.sign(&unicode(expr), line),
        }
    }

    fn name(&mut self, name: &str, face: Face, line: Line) {
        let letters = unicode(&Expr::name(name));
        let single = letters.chars().count() == 1;
        let capital_greek = letters.chars().all(|c| ('Α'..='Ω').contains(&c));
        let face = match face {
            Face::Italic if !single || capital_greek || !letters.chars().all(char::is_alphabetic) => {
                Face::Upright
            }
            face => face,
        };
        self.push(&letters, face, line);
    }

    fn accent(&mut self, accent: Accent, body: &Expr, whole: &Expr, line: Line) {
        match (accent, &body.kind) {
            (Accent::Bold, Kind::Name(name)) => self.name(name, Face::Bold, line),
            (Accent::Bold, Kind::Number(_)) => self.push(&unicode(body), Face::Bold, line),
            (_, Kind::Name(name)) if accent != Accent::Blackboard && accent != Accent::Script => {
                // the mark of the accent follows its letter
                let text = unicode(whole);
                let letters = unicode(&Expr::name(name.as_str())).chars().count();
                let face =
                    if letters == 1 && text.chars().count() == 2 { Face::Italic } else { Face::Upright };
                self.push(&text, face, line);
            }
            _ => self.sign(&unicode(whole), line),
        }
    }
}

/// Whether the letter leans into what follows.
fn italic_f(callee: &Expr) -> bool {
    matches!(&callee.kind, Kind::Name(name) if name.len() == 1)
}

/// What stands between two factors.
fn between(before: &Expr, after: &Expr) -> &'static str {
    match (&before.kind, &after.kind) {
        (_, Kind::Number(_)) => "·",
        (_, Kind::Pow(base, _)) if matches!(base.kind, Kind::Number(_)) => "·",
        (Kind::Number(value), _) if value.is_integer() => "",
        // words are kept apart, letters are not
        (Kind::Name(name), _) | (_, Kind::Name(name))
            if unicode(&Expr::name(name.as_str())).chars().count() > 1 =>
        {
            THIN
        }
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::syntax::parse;

    /// Runs in one line: `_` and `^` before what is below and above the line.
    fn flat(formula: &str) -> String {
        let text = Text::Formula(parse(formula).unwrap());
        let piece = |run: Run| {
            let mark = if run.rise > 0.0 {
                "^"
            } else if run.rise < 0.0 {
                "_"
            } else {
                ""
            };
            let slant = if run.face == Face::Italic { "*" } else { "" };
            format!("{mark}{slant}{}{slant}", run.text.replace('\u{2009}', "~"))
        };
        runs(&text).into_iter().map(piece).collect()
    }

    #[test]
    fn formulas() {
        for (formula, expected) in [
            ("b_0", "*b*_0"),
            ("f(0, t, 1)", "*f*(0,~*t*,~1)"),
            ("N_0^3", "*N*_0^3"),
            ("p_{i,j}", "*p*_*i*_,_*j*"),
            ("1 - t", "1~−~*t*"),
            ("(1-t)/2", "(1~−~*t*)/2"),
            ("-2 alpha", "−2*α*"),
            ("t_{i+1}", "*t*_*i*_+1"),
            ("Delta", "Δ"),
            ("F'(t)", "*F*′(*t*)"),
            ("2 t (1 - t)", "2*t*(1~−~*t*)"),
            ("a/(b c)", "*a*/(*bc*)"),
            ("a max", "*a*~max"),
            ("2*10^30", "2·10^30"),
            ("hat(v)", "*v\u{302}*"),
            ("1/3", "1/3"),
            ("a = b", "*a*~=~*b*"),
        ] {
            assert_eq!(flat(formula), expected, "{formula}");
        }
    }

    #[test]
    fn upper_index_stands_above_the_lower() {
        let runs = runs(&Text::Formula(parse("N_{12}^3 t").unwrap()));
        // back over the two digits, then forward to where they end
        assert!(runs[2].shift < -0.5 && runs[3].shift > 0.2, "{runs:?}");
    }

    #[test]
    fn deep_formulas() {
        let deep = (0..2000).fold(Expr::name("t"), |inner, _| inner.grouped());
        let runs = runs(&Text::Formula(deep));
        assert_eq!(
            runs.iter().map(|run| run.text.chars().filter(|&c| c == '(').count()).sum::<usize>(),
            2000
        );
    }
}
