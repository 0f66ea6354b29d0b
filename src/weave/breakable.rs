//! What a renderer of Markdown that does not know formulas takes out of them.
//!
//! Reference: CommonMark 0.31, sections 2.4 (backslash escapes), 6.1 (code spans), 6.2 (emphasis), 6.3 (links), 6.6 (HTML).

use crate::formula::source::Pieces;

/// Why a formula, with its signs, does not come through such a renderer whole; nothing if it does. `in_table` says that it stands in a
/// row of a table.
///
/// Cost: linear in its length, but for signs of emphasis, of which there are few.
pub(super) fn broken(formula: &str, in_table: bool) -> Option<String> {
    let signs: Vec<char> = formula.chars().collect();
    let after = |i: usize| signs.get(i + 1).copied();
    if in_table && formula.contains('|') {
        return Some("'|' ends the cell of the table".to_owned());
    }
    let mut escaped = false;
    for (i, sign) in signs.iter().enumerate() {
        let next = after(i);
        if escaped {
            escaped = false;
            continue;
        }
        match (sign, next) {
            ('\\', Some(next)) if next.is_ascii_punctuation() => {
                return Some(format!("'\\{next}' loses its stroke"));
            }
            ('\\', _) => escaped = true,
            ('`', _) if signs.iter().skip(i + 1).any(|sign| *sign == '`') => {
                return Some("'`' begins code".to_owned());
            }
            (']', Some('(')) if signs.iter().take(i).any(|sign| *sign == '[') => {
                return Some("'](' makes a link".to_owned());
            }
            ('<', Some(next)) if next.is_ascii_alphabetic() || next == '/' => {
                let rest: String = signs.iter().skip(i).collect();
                if rest.contains('>') {
                    return Some(format!("'<{next}' begins a tag of HTML"));
                }
            }
            _ => {}
        }
    }
    emphasized(&signs).map(|sign| format!("two '{sign}' make the text between them slanted"))
}

/// A run of signs that may begin or end emphasis.
struct Run {
    sign: char,
    length: usize,
    opens: bool,
    closes: bool,
}

/// The sign of two runs that make emphasis.
fn emphasized(signs: &[char]) -> Option<char> {
    let mut runs: Vec<Run> = Vec::new();
    let mut at = 0;
    while let Some(&sign) = signs.get(at) {
        let length = signs.iter().skip(at).take_while(|other| **other == sign).count();
        if matches!(sign, '*' | '_') {
            let before = at.checked_sub(1).and_then(|before| signs.get(before)).copied();
            runs.push(run(sign, length, before, signs.get(at + length).copied()));
        }
        at += length;
    }
    let meet = |open: &Run, close: &Run| {
        let both = (open.opens && open.closes) || (close.opens && close.closes);
        let third = |length: usize| length.is_multiple_of(3);
        let thirds = third(open.length + close.length) && !(third(open.length) && third(close.length));
        open.sign == close.sign && open.opens && close.closes && !(both && thirds)
    };
    let mut earlier = runs.iter().enumerate();
    earlier.find(|(i, open)| runs.iter().skip(i + 1).any(|close| meet(open, close))).map(|(_, run)| run.sign)
}

fn run(sign: char, length: usize, before: Option<char>, after: Option<char>) -> Run {
    let blank = |c: Option<char>| c.is_none_or(char::is_whitespace);
    // Symbols are as punctuation: neither letters nor digits.
    let punctuation = |c: Option<char>| c.is_some_and(|c| !c.is_whitespace() && !c.is_alphanumeric());
    let left = !blank(after) && (!punctuation(after) || blank(before) || punctuation(before));
    let right = !blank(before) && (!punctuation(before) || blank(after) || punctuation(after));
    let word = sign == '_';
    Run {
        sign,
        length,
        opens: left && (!word || !right || punctuation(before)),
        closes: right && (!word || !left || punctuation(after)),
    }
}

/// Whether a place of a page stands in a row of a table that begins with its bar.
pub(super) fn in_table(page: &str, at: usize) -> bool {
    let before = page.piece(..at);
    before.rsplit('\n').next().is_some_and(|line| line.trim_start().starts_with('|'))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The words that a page of HTML shows.
    fn shown(html: &str) -> String {
        let mut out = String::new();
        let mut tag = false;
        for c in html.chars() {
            match c {
                '<' => tag = true,
                '>' => tag = false,
                _ if !tag => out.push(c),
                _ => {}
            }
        }
        out.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
    }

    /// Whether another renderer of CommonMark shows a formula as it stands.
    fn comes_through(formula: &str) -> bool {
        let compile =
            markdown::CompileOptions { allow_dangerous_html: true, ..markdown::CompileOptions::default() };
        let options = markdown::Options { compile, ..markdown::Options::default() };
        let page = format!("a {formula} b");
        shown(&markdown::to_html_with_options(&page, &options).unwrap()) == page
    }

    #[test]
    fn formulas_of_lecture_notes() {
        for (formula, why) in [
            ("$a_1 b_1$", None),
            ("$b_i^r = (1-t) b_i^{r-1} + t b_{i+1}^{r-1}$", None),
            (r"$\hat{b}_i + x_{j}$", Some("two '_'")),
            (r"$\{1, 2\}$", Some(r"'\{'")),
            (r"$a \\ b$", Some(r"'\\'")),
            ("$a*b*c$", Some("two '*'")),
            ("$a * b * c$", None),
            ("$f[x_0](t)$", Some("link")),
            ("$a <b> c$", Some("HTML")),
            ("$0 < t < 1$", None),
            (r"$\alpha \beta$", None),
        ] {
            let found = broken(formula, false);
            match why {
                None => assert_eq!(found, None, "{formula}"),
                Some(why) => {
                    assert!(found.as_ref().is_some_and(|found| found.contains(why)), "{formula}: {found:?}")
                }
            }
            assert_eq!(found.is_none(), comes_through(formula), "{formula}: {}", markdown::to_html(formula));
        }
        assert!(broken("$|x|$", true).is_some() && broken("$|x|$", false).is_none());
        assert!(in_table("a\n| $x$ |\n", 4) && !in_table("a\nb $x$\n", 4));
    }

    proptest! {
        /// A renderer of CommonMark that others wrote is the other way.
        #[test]
        fn as_another_renderer_has_it(pieces in prop::collection::vec(prop::sample::select(vec![
            "a", "1", " ", "_", "*", "{", "}", "^", "\\alpha", "\\{", "(", ")", "=", "+", "__",
        ]), 0..12)) {
            let formula = format!("${}$", pieces.concat());
            // There it differs from CommonMark.
            prop_assume!(!formula.contains("*_") && !formula.contains("_*"));
            prop_assert_eq!(broken(&formula, false).is_none(), comes_through(&formula), "{}: {}", formula, markdown::to_html(&formula));
        }
    }
}
