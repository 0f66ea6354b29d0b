//! Long LaTeX over several lines: broken before relations, before + and -, and after commas.
//!
//! A line of TeX has a width, and display math is not broken by TeX itself. The width of a formula is
//! estimated from its LaTeX; a break goes to the place that fits, outside of brackets where that
//! does not leave a line half empty. Fractions, scripts, growing brackets and environments stay whole.
//!
//! **Reference.** Knuth, *The TeXbook* (1984), chapters 17 and 18, for what is spaced how.

use super::ruler::measured;
use std::collections::BTreeSet;

/// The width of the text of an `article` at ten points, in points.
pub const ARTICLE: f64 = 345.0;

/// A line this full may end outside of brackets, although more would fit on it.
const FULL_ENOUGH: f64 = 0.3;

/// So is a line that has this much, if all the rest fits on the next one.
const SOMETHING: f64 = 0.2;

/// Numerals of more digits may be broken, after as many digits as a multiple of this.
const LONG_NUMERAL: usize = 30;
const DIGITS: usize = 5;
const DEEPEST: usize = usize::MAX / 2;

/// A left side that takes more of the width than this is no margin for the lines of the right side.
const LONG_LEFT: f64 = 0.35;

/// The indentation of a line that goes on with a formula.
pub(super) const QUAD: f64 = 10.0;

/// A formula in LaTeX as an `aligned` environment of lines of about this width in points; as it is, if
/// it is not wider, or has an environment of its own at its outside.
///
/// Cost: linear in the length, times the number of places for a break in a line.
///
/// ```
/// use polarform::write::broken;
/// let sum = "F(t) = a + b + c";
/// assert_eq!(broken(sum, 345.0), sum);
/// assert_eq!(broken(sum, 60.0), "\\begin{aligned}\nF(t) &= a + b \\\\\n&\\quad {}+ c\n\\end{aligned}");
/// ```
pub fn broken(latex: &str, width: f64) -> String {
    if measured(latex) <= width {
        return latex.to_owned();
    }
    if let Some(cases) = broken_cases(latex, width) {
        return cases;
    }
    if latex.starts_with("\\begin") {
        return latex.to_owned();
    }
    let latex = &opened(latex, width);
    let first = places(latex).into_iter().find(|place| place.kind == Sign::Relation && place.depth == 0);
    let (left, right) = latex.split_at(first.map_or(0, |place| place.at));
    // All lines begin below the relation; a long left side has a line of its own.
    let margin = measured(left);
    if margin > width {
        return format!("\\begin{{aligned}}\n&{}\n\\end{{aligned}}", lines_of(latex, width).join(" \\\\\n&"));
    }
    if margin > LONG_LEFT * width {
        let lines = lines_of(right, width - QUAD).join(" \\\\\n&\\quad ");
        return format!("\\begin{{aligned}}\n&{} \\\\\n&\\quad {lines}\n\\end{{aligned}}", left.trim_end());
    }
    let lines = lines_of(right, width - margin);
    if lines.len() < 2 {
        return latex.to_owned();
    }
    format!("\\begin{{aligned}}\n{} &{}\n\\end{{aligned}}", left.trim_end(), lines.join(" \\\\\n&"))
        .replace("\n &", "\n&")
}

/// A definition by cases whose values are broken, each in its own row.
fn broken_cases(latex: &str, width: f64) -> Option<String> {
    const OPEN: &str = "\\begin{cases}";
    const CLOSE: &str = "\\end{cases}";
    const BRACE: f64 = 12.0;
    let (before, rest) = latex.split_once(OPEN)?;
    let (body, after) = rest.rsplit_once(CLOSE)?;
    if body.contains("\\begin") || measured(before) > LONG_LEFT * width {
        return None;
    }
    let room = width - measured(before) - BRACE;
    // In a broken row fractions are large, so they are in all.
    let row = |row: &str| {
        let (value, condition) = row.split_once(" & ").unwrap_or((row, ""));
        let room = (room - measured(condition) - 2.0 * QUAD).max(FULL_ENOUGH * room);
        let lines = lines_of(value.trim(), room).join(" \\\\\n&");
        format!("\\begin{{aligned}}[t]\n&{lines}\n\\end{{aligned}} & {condition}")
    };
    let rows: Vec<String> = body.trim().split(" \\\\ ").map(row).collect();
    Some(format!("{before}{OPEN}\n{}\n{CLOSE}{after}", rows.join(" \\\\\n")))
}

/// How a formula is broken that is wider than a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Breaks {
    /// Below its first relation: an `aligned` of amsmath.
    #[default]
    Aligned,
    /// From the left margin to the right one: a `multlined` of mathtools.
    Multlined,
    /// By TeX itself: a display `dmath*` of breqn.
    Dmath,
}

impl Breaks {
    /// All ways.
    pub const ALL: [Self; 3] = [Self::Aligned, Self::Multlined, Self::Dmath];

    /// The environment, without its star.
    pub fn name(self) -> &'static str {
        match self {
            Self::Aligned => "aligned",
            Self::Multlined => "multlined",
            Self::Dmath => "dmath",
        }
    }

    /// A formula in LaTeX over lines of about this width in points; as it is, if it is not wider or has an environment of
    /// its own at its outside. A `dmath*` is a display of its own, the others stand in one.
    ///
    /// ```
    /// use polarform::write::Breaks;
    /// assert_eq!(Breaks::Multlined.broken("a + b + c", 30.0), "\\begin{multlined}\na + b \\\\\n{}+ c\n\\end{multlined}");
    /// assert_eq!(Breaks::Dmath.broken("a + b + c", 30.0), "\\begin{dmath*}\na + b + c\n\\end{dmath*}");
    /// assert_eq!(Breaks::Dmath.broken("a + b + c", 300.0), "a + b + c");
    /// ```
    pub fn broken(self, latex: &str, width: f64) -> String {
        if measured(latex) <= width {
            return latex.to_owned();
        }
        if let Some(cases) = broken_cases(latex, width) {
            return cases;
        }
        if latex.starts_with("\\begin") {
            return latex.to_owned();
        }
        match self {
            Breaks::Aligned => broken(latex, width),
            Breaks::Multlined => {
                let lines = lines_of(latex, width);
                let lines: Vec<&str> = lines.iter().map(|line| line.trim_start_matches("\\quad ")).collect();
                match lines.len() {
                    1 => latex.to_owned(),
                    _ => format!("\\begin{{multlined}}\n{}\n\\end{{multlined}}", lines.join(" \\\\\n")),
                }
            }
            Breaks::Dmath => format!("\\begin{{dmath*}}\n{latex}\n\\end{{dmath*}}"),
        }
    }
}

/// A right side in lines of about this width; each but the first begins with a relation, or indented.
pub fn lines_of(latex: &str, width: f64) -> Vec<String> {
    let latex = &opened(latex, width);
    let places = places(latex);
    let mut lines = Vec::new();
    let mut start = 0;
    loop {
        let rest = latex[start..].trim_start();
        let indent = if start > 0 { QUAD } else { 0.0 };
        let room = width - indent;
        let line = |text: &str| match start {
            0 => text.trim().to_owned(),
            _ if begins_with_relation(text.trim_start()) => text.trim().to_owned(),
            _ if text.trim_start().starts_with(['+', '-']) => format!("\\quad {{}}{}", text.trim()),
            _ if text.trim_start().starts_with('(') && latex[..start].ends_with(['}', ')']) => {
                format!("\\quad {{}}\\cdot {}", text.trim())
            }
            _ => format!("\\quad {}", text.trim()),
        };
        let end = match measured(rest) <= room {
            true => None,
            false => place_to_break(latex, start, &places, room),
        };
        let Some(end) = end else {
            lines.push(line(&latex[start..]));
            return lines;
        };
        lines.push(line(&latex[start..end]));
        start = end;
    }
}

/// The formula with what is wider than a line made breakable: brackets of a fixed size for growing ones, and
/// the numerator of a fraction beside it.
fn opened(latex: &str, width: f64) -> String {
    let mut out = String::with_capacity(latex.len());
    let mut at = 0;
    while at < latex.len() {
        let rest = &latex[at..];
        if rest.starts_with("\\left")
            && let Some(group) = growing(rest)
        {
            match measured(group) > width {
                true => {
                    let inner = &group["\\left".len()..group.rfind("\\right").unwrap_or(group.len())];
                    let open = if inner.starts_with('\\') { command(inner).len() } else { 1 };
                    let close =
                        &group[group.rfind("\\right").map_or(group.len(), |end| end + "\\right".len())..];
                    out += &format!("\\Bigl{}{}\\Bigr{close}", &inner[..open], opened(&inner[open..], width));
                }
                false => out += group,
            }
            at += group.len();
        } else if rest.starts_with("\\frac{")
            && let Some((above, below)) = parts_of_fraction(rest)
        {
            let whole = &rest[.."\\frac{}{}".len() + above.len() + below.len()];
            match (measured(above) > width, measured(below) > width / 2.0) {
                (true, false) => {
                    out += &format!("\\frac{{1}}{{{below}}} \\bigl({}\\bigr)", opened(above, width));
                }
                (above_wide, true) if above_wide || measured(below) > width => {
                    let (above, below) = (opened(above, width), opened(below, width));
                    out += &format!("\\bigl({above}\\bigr) \\big/ \\bigl({below}\\bigr)");
                }
                _ => out += whole,
            }
            at += whole.len();
        } else {
            let next = rest.chars().next().map_or(1, char::len_utf8);
            out += &rest[..next];
            at += next;
        }
    }
    out
}

/// `\left( … \right)` at the start of a text, unless one of its sides is empty.
fn growing(text: &str) -> Option<&str> {
    let (mut depth, mut at) = (0_usize, 0);
    while let Some(found) = text[at..].find('\\') {
        at += found;
        let name = command(&text[at..]);
        at += name.len();
        match name {
            "\\left" => depth += 1,
            "\\right" => depth -= 1,
            _ => continue,
        }
        let side = if text[at..].starts_with('\\') { command(&text[at..]).len() } else { 1 };
        if text[at..].starts_with('.') {
            return None;
        }
        at += side;
        if depth == 0 {
            return text.get(..at);
        }
    }
    None
}

/// The two arguments of the `\frac` that a text begins with.
fn parts_of_fraction(text: &str) -> Option<(&str, &str)> {
    let above = braced(text.strip_prefix("\\frac")?)?;
    let below = braced(&text["\\frac{}".len() + above.len()..])?;
    Some((above, below))
}

/// What stands in the braces that a text begins with.
fn braced(text: &str) -> Option<&str> {
    let mut depth = 0_usize;
    for (at, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 1 => return text.get(1..at),
            '}' => depth = depth.checked_sub(1)?,
            _ if depth == 0 => return None,
            _ => {}
        }
    }
    None
}

/// Where the line that begins at `start` ends: as far as fits, at the least depth of brackets that fills
/// it well; after the next term, if nothing fits.
fn place_to_break(latex: &str, start: usize, places: &[Place], room: f64) -> Option<usize> {
    let after = places.iter().filter(|place| place.at > start + leading_sign(&latex[start..]));
    let mut fitting: Vec<(&Place, f64)> = Vec::new();
    let mut next = None;
    for place in after {
        let width = measured(&latex[start..place.at]);
        if width > room {
            next = Some(place.at);
            break;
        }
        fitting.push((place, width));
    }
    if fitting.is_empty() {
        return next;
    }
    let depths = fitting.iter().map(|(place, _)| place.depth).collect::<BTreeSet<_>>();
    for depth in depths {
        let enough = |place: &Place, width: f64| {
            place.kind == Sign::Relation
                || width >= FULL_ENOUGH * room
                || width >= SOMETHING * room && measured(&latex[place.at..]) <= room - QUAD
        };
        let best = fitting.iter().rev().find(|(place, width)| place.depth <= depth && enough(place, *width));
        if let Some((place, _)) = best {
            return Some(place.at);
        }
    }
    fitting.last().map(|(place, _)| place.at).or(next)
}

/// The bytes before which a break would only cut off the sign that a line begins with.
fn leading_sign(text: &str) -> usize {
    text.len() - text.trim_start().len()
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    Relation,
    Plus,
    Comma,
    Digits,
    Factor,
}

/// A place where a line may begin.
#[derive(Clone, Copy, Debug)]
struct Place {
    at: usize,
    kind: Sign,
    /// How many small brackets are open there.
    depth: usize,
}

pub(super) const RELATIONS: &[&str] =
    &["=", ":=", "<", ">", "\\le", "\\ge", "\\ne", "\\equiv", "\\approx", "\\in"];

fn begins_with_relation(text: &str) -> bool {
    let word = text.split_whitespace().next().unwrap_or("");
    RELATIONS.contains(&word)
}

/// The places between blanks, outside of braces, growing brackets and environments.
fn places(latex: &str) -> Vec<Place> {
    let mut places = Vec::new();
    let (mut braces, mut depth) = (0_usize, 0_usize);
    let bytes = latex.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let rest = &latex[at..];
        match bytes[at] {
            b'\\' => {
                let name = command(rest);
                match name {
                    "\\left" | "\\begin" => braces += 1,
                    "\\right" | "\\end" => braces = braces.saturating_sub(1),
                    _ if braces == 0 && depth == 0 && RELATIONS.contains(&name) => {
                        places.push(Place { at, kind: Sign::Relation, depth });
                    }
                    _ => {}
                }
                at += name.len();
                // The bracket of \left( is no small one.
                if matches!(name, "\\left" | "\\right") && bytes.get(at).is_some_and(u8::is_ascii_punctuation)
                {
                    at += if bytes[at] == b'\\' { command(&latex[at..]).len() } else { 1 };
                }
                continue;
            }
            b'{' => braces += 1,
            b'}' => braces = braces.saturating_sub(1),
            b'(' | b'[' if braces == 0 => depth += 1,
            b')' | b']' if braces == 0 => depth = depth.saturating_sub(1),
            b',' if braces == 0 && depth <= 1 && rest.starts_with(", ") => {
                places.push(Place { at: at + 1, kind: Sign::Comma, depth });
            }
            // A long numeral, where nothing else fits.
            b'0'..=b'9' if braces == 0 => {
                let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
                let cuts = if digits > LONG_NUMERAL { 1..digits / DIGITS } else { 0..0 };
                places.extend(cuts.map(|cut| Place {
                    at: at + DIGITS * cut,
                    kind: Sign::Digits,
                    depth: DEEPEST,
                }));
                at += digits;
                continue;
            }
            b' ' if braces == 0 => {
                let next = &rest[1..];
                // A product, where no sum or relation is near.
                if next.starts_with('(') && latex[..at].ends_with(['}', ')']) {
                    places.push(Place { at, kind: Sign::Factor, depth: DEEPEST - 1 });
                }
                if next.starts_with("+ ") || next.starts_with("- ") {
                    places.push(Place { at, kind: Sign::Plus, depth });
                } else if depth == 0 && !next.starts_with('\\') && begins_with_relation(next) {
                    places.push(Place { at, kind: Sign::Relation, depth });
                }
            }
            _ => {}
        }
        at += rest.chars().next().map_or(1, char::len_utf8);
    }
    // Formulas side by side are broken between them first.
    if places.iter().any(|place| place.kind == Sign::Comma && place.depth == 0) {
        for place in places.iter_mut().filter(|place| place.kind != Sign::Comma || place.depth > 0) {
            place.depth += 1;
        }
    }
    places
}

/// The command that a text begins with, with its backslash.
pub(super) fn command(text: &str) -> &str {
    let letters = text[1..].bytes().take_while(u8::is_ascii_alphabetic).count();
    let length =
        if letters > 0 { 1 + letters } else { 1 + text[1..].chars().next().map_or(0, char::len_utf8) };
    &text[..length]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without its breaks a broken formula is the formula.
    fn joined(broken: &str) -> String {
        let body = broken.replace("\\begin{aligned}\n", "").replace("\n\\end{aligned}", "");
        body.replace(" \\\\\n", " ").replace("\\quad {}", "").replace("\\quad ", "").replace('&', "")
    }

    #[test]
    fn nothing_is_lost_and_lines_fit() {
        let sum = |n: usize| (1..=n).map(|i| format!("b_{{{i}}} t^{i}")).collect::<Vec<_>>().join(" + ");
        let cases = [
            format!("F(t) = {}", sum(40)),
            sum(30),
            format!("f(t_1, t_2) = \\frac{{1}}{{3}} ({}) - \\frac{{2}}{{3}} ({})", sum(12), sum(20)),
            format!("[{}]", (0..50).map(|i| format!("p_{{{i}}}")).collect::<Vec<_>>().join(", ")),
            format!("a = {} = {}", sum(3), sum(25)),
        ];
        for case in &cases {
            for width in [120.0, 345.0, 500.0] {
                let text = broken(case, width);
                let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
                assert_eq!(plain(&joined(&text)), plain(case), "{width}");
                let rows =
                    text.lines().filter(|line| !line.starts_with("\\begin") && !line.starts_with("\\end"));
                for row in rows {
                    let row = row.trim_end_matches("\\\\").replace('&', "");
                    assert!(measured(&row) <= width + 30.0, "{width}: {row}");
                }
            }
        }
    }

    #[test]
    fn what_is_wider_than_a_line_is_opened() {
        let sum: Vec<String> = (0..30).map(|i| format!("a_{{{i}}}")).collect();
        let list = format!(r"x = \left[ {} \right]", sum.join(", "));
        let fraction = format!(r"x = -\frac{{{}}}{{b}}", sum.join(" + "));
        let quotient = format!(r"x = \frac{{{0}}}{{{0}}}", sum.join(" + "));
        for (wide, start) in [
            (list, r"x &= \Bigl[ a_{0}, a_{1}"),
            (fraction, r"x &= -\frac{1}{b} \bigl(a_{0} + a_{1}"),
            (quotient, r"x &= \bigl(a_{0} + a_{1}"),
        ] {
            let text = broken(&wide, 200.0);
            assert!(text.contains(start), "{text}");
            assert!(text.lines().all(|line| measured(&line.replace('&', "")) < 230.0), "{text}");
            assert_eq!(broken(&wide, 2000.0), wide);
        }
    }

    #[test]
    fn what_holds_together_stays_whole() {
        for whole in [
            r"\frac{a + b}{e + f}".to_owned(),
            r"\begin{pmatrix} a + b & c + d \\ e & f \end{pmatrix}".to_owned(),
        ] {
            assert_eq!(broken(&whole, 25.0), whole);
        }
    }
}
