//! The signs around formulas: `$`, `$$`, `\(`, `\[` and environments, and where they end.
//!
//! One slip of the author, a display that is never closed, must not turn the rest of the file
//! inside out. So the search for the closing sign stops at what cannot stand in a formula: a
//! heading, a fence, a formula set with single `$`, a paragraph of prose.

use crate::formula::source::Pieces;
use crate::language::lexicon::letters::is_ideograph;

/// The environments that are displays of their own.
const ENVIRONMENTS: &[&str] = &[
    "equation",
    "align",
    "alignat",
    "flalign",
    "gather",
    "multline",
    "eqnarray",
    "dmath",
    "displaymath",
    "math",
    "xalignat",
    "xxalignat",
    "IEEEeqnarray",
];

/// Whether `\begin{name}` opens a display outside of any other sign.
pub(super) fn is_math_environment(name: &str) -> bool {
    ENVIRONMENTS.contains(&name.strip_suffix('*').unwrap_or(name))
}

/// The name in braces at `at`: `{equation*}`, and the byte after the brace.
pub(super) fn braced_name(text: &str, at: usize) -> Option<(&str, usize)> {
    let rest = text.get(at..)?;
    let inner = rest.strip_prefix('{')?;
    let len = inner.bytes().take(40).position(|byte| byte == b'}')?;
    let name = inner.get(..len)?;
    (!name.is_empty() && !name.contains(['{', '\\', '\n', '$'])).then_some((name, at + len + 2))
}

/// Where the formula that was opened before `from` ends: the byte of the closing sign `$$`, `$`,
/// `\]`, `\)`, `\end{…}`. In a LaTeX file comments are passed over and a blank line ends the search.
pub(super) fn display_end(text: &str, from: usize, closing: &str, latex: bool) -> Option<usize> {
    let opening = match closing {
        r"\]" => Some(r"\[".to_owned()),
        r"\)" => Some(r"\(".to_owned()),
        r"\\]" => Some(r"\\[".to_owned()),
        r"\\)" => Some(r"\\(".to_owned()),
        _ => closing.strip_prefix(r"\end").map(|name| format!(r"\begin{name}")),
    };
    formula_end(text, from, opening.as_deref(), closing, latex)
}

/// The same for any pair of signs, which may be commands. A second opening sign ends the search:
/// the first was not closed. This also keeps repeated searches linear.
pub(super) fn formula_end(
    text: &str,
    from: usize,
    opening: Option<&str>,
    closing: &str,
    latex: bool,
) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut at = from;
    let mut braces = Braces::default();
    let mut after_blank = false;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\\' if stands(text, at, closing) => return Some(at),
            b'\\' if opening.is_some_and(|opening| stands(text, at, opening)) => return None,
            b'\\' => {
                at += 1 + text.piece(at + 1..).chars().next().map_or(0, char::len_utf8);
                continue;
            }
            b'$' if closing != "$" && stands(text, at, closing) => return Some(at),
            b'$' if !braces.pass(at) => return (closing == "$").then_some(at),
            b'{' => braces.open(text, at),
            b'}' => braces.close(),
            b'%' if latex => at += line_at(text, at).len() - 1,
            b'\n' => {
                let line = line_at(text, at + 1);
                let bare = line.trim_start_matches([' ', '\t', '>']).trim_end();
                if latex {
                    if line.trim().is_empty() {
                        return None;
                    }
                } else if is_heading(bare) || is_fence(bare) || (after_blank && reads_as_prose(bare)) {
                    return None;
                }
                after_blank = bare.is_empty();
            }
            _ => {}
        }
        at += 1;
    }
    None
}

/// Whether the sign stands at `at`; a command ends where its letters end.
fn stands(text: &str, at: usize, sign: &str) -> bool {
    let letter = |c: char| c.is_ascii_alphabetic();
    text.piece(at..)
        .strip_prefix(sign)
        .is_some_and(|rest| !sign.ends_with(letter) || !rest.starts_with(letter))
}

/// A group of text in a formula, within which `$…$` may stand, is not longer.
const MAX_TEXT: usize = 1000;

/// So many `$` stand in the groups of text of a formula.
const MAX_PASSED: usize = 100;

/// The braces that are open in a formula.
#[derive(Default)]
struct Braces {
    /// Whether each belongs to \text or the like.
    open: Vec<bool>,
    /// How many of them do.
    texts: usize,
    /// Where the outermost \text begins.
    start: usize,
    /// How many `$` were passed.
    passed: usize,
}

impl Braces {
    fn open(&mut self, text: &str, at: usize) {
        let opens = opens_text(text.piece(..at));
        if opens && self.texts == 0 {
            self.start = at;
        }
        self.texts += usize::from(opens);
        self.open.push(opens);
    }

    fn close(&mut self) {
        self.texts -= usize::from(self.open.pop() == Some(true));
    }

    /// Whether the `$` at `at` stands in \text{…} and so ends nothing.
    fn pass(&mut self, at: usize) -> bool {
        self.passed += 1;
        self.texts > 0 && at < self.start + MAX_TEXT && self.passed <= MAX_PASSED
    }
}

/// The line that starts at `at`, without its end.
pub(super) fn line_at(text: &str, at: usize) -> &str {
    let rest = text.piece(at..);
    rest.piece(..rest.bytes().position(|byte| byte == b'\n').unwrap_or(rest.len()))
}

fn is_heading(line: &str) -> bool {
    let marks = line.bytes().take_while(|&byte| byte == b'#').count();
    (1..=6).contains(&marks) && line.piece(marks..).starts_with([' ', '\t'])
}

fn is_fence(line: &str) -> bool {
    line.starts_with("```") || line.starts_with("~~~")
}

/// Whether the text before an opening brace is a command whose argument is text.
fn opens_text(before: &str) -> bool {
    let before = before.trim_end_matches([' ', '*']);
    let name = before.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    name.ends_with('\\')
        && (before.piece(name.len()..).starts_with("text")
            || matches!(before.piece(name.len()..), "mbox" | "hbox" | "intertext" | "shortintertext" | "tag"))
}

/// Whether a line outside of signs is a sentence rather than a formula: four words in a row, or
/// six ideographs.
pub(super) fn reads_as_prose(line: &str) -> bool {
    let mut depth = 0_usize;
    let mut words = 0;
    let mut ideographs = 0;
    for word in line.split_whitespace() {
        let plain = word.trim_matches(|c: char| matches!(c, ',' | '.' | ';' | ':' | '(' | ')'));
        let is_word = depth == 0 && plain.len() > 1 && plain.chars().all(|c| c.is_ascii_alphabetic());
        words = if is_word || (words > 0 && plain == "a") { words + 1 } else { 0 };
        for c in word.chars() {
            match c {
                '{' => depth += 1,
                '}' => depth = depth.saturating_sub(1),
                c if depth == 0 && is_ideograph(c) => ideographs += 1,
                _ => {}
            }
        }
        if words >= 4 || ideographs >= 6 {
            return true;
        }
    }
    false
}

/// Where the formula opened by the single `$` at `open` ends: the byte of the closing `$`.
pub(super) fn inline_end(text: &str, open: usize) -> Option<usize> {
    let close = next_dollar(text, open + 1, true).or_else(|| next_dollar(text, open + 1, false))?;
    let content = text.piece(open + 1..close);
    let after = text.as_bytes().get(close + 1);
    (!is_money(content, after) && !is_between_formulas(content)).then_some(close)
}

/// The next `$` that can close a formula; with `nested`, those inside \text{…} are passed over.
fn next_dollar(text: &str, from: usize, nested: bool) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut braces = Braces::default();
    let mut at = from;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\\' => at += 1,
            b'{' if nested => braces.open(text, at),
            b'}' if nested => braces.close(),
            b'$' if !braces.pass(at) => return closes(text, from, at).then_some(at),
            _ => {}
        }
        at += 1;
    }
    None
}

/// Whether the `$` at `at` closes the formula that begins at `from`. In `$a$$b$` it does, there
/// are two formulas; in `$5 and $$x$$` the first sign is a currency.
fn closes(text: &str, from: usize, at: usize) -> bool {
    let rest = &text.as_bytes()[at..];
    match rest.iter().take(3).take_while(|&&byte| byte == b'$').count() {
        1 => true,
        2 => {
            let next = rest[2..]
                .iter()
                .take(MAX_TEXT)
                .take_while(|&&byte| byte != b'\n')
                .position(|&byte| byte == b'$');
            next.is_some_and(|next| rest.get(next + 3) != Some(&b'$'))
                && !is_between_formulas(text.piece(from..at))
        }
        _ => false,
    }
}

/// `$5 and $6`: both signs are currencies.
fn is_money(content: &str, after: Option<&u8>) -> bool {
    content.starts_with(|c: char| c.is_ascii_digit())
        && after.is_some_and(u8::is_ascii_digit)
        && !content.contains(['\\', '^', '_', '='])
}

/// Whether what stands between two `$` is the text between two formulas, so that the first `$`
/// closes one or stands alone.
fn is_between_formulas(content: &str) -> bool {
    if content.trim().is_empty() {
        return true;
    }
    let outside = content.chars();
    let ideographs = outside.clone().filter(|&c| is_ideograph(c)).count();
    let marks = outside.filter(|c| matches!(c, '，' | '。' | '；' | '：' | '、' | '？' | '！')).count();
    let in_text = content.contains("\\text") || content.contains("\\mbox");
    if ideographs >= 2 && marks >= 1 && !in_text {
        return true;
    }
    let open = content.starts_with(char::is_whitespace);
    let close = content.ends_with(char::is_whitespace);
    // `u,` in a list of arguments is no word.
    let words = content
        .split_whitespace()
        .map(|word| word.trim_matches([',', '.', ';', ':']))
        .filter(|word| word.len() > 1 && word.chars().all(|c| c.is_ascii_alphabetic()));
    let words = words.count();
    let signs = content.contains(['\\', '^', '_', '=', '{', '+', '<', '>']);
    // Between two signs that touch it, a formula may hold many words: `$f(r,s,t) = rst + rs + st + rt$`.
    words >= 4 && !in_text && (open || close || reads_as_prose(content))
        || (words >= 1 && !signs && (open || content.starts_with(|c: char| c.is_ascii_digit())))
        || (open != close && words >= 2)
}

/// A sign that amounts to a currency: `$5`, `US$`.
pub(super) fn is_currency(text: &str, at: usize) -> bool {
    let rest = text.piece(at + 1..);
    let digits = rest.bytes().take_while(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b',')).count();
    let after = rest.piece(digits..).chars().next();
    (digits > 0
        && after
            .is_none_or(|c| c.is_whitespace() || c.is_ascii_punctuation() && !matches!(c, '^' | '_' | '\\')))
        || (rest.starts_with(|c: char| c.is_whitespace() || c == ')')
            && text.piece(..at).ends_with(|c: char| c.is_ascii_digit()))
}
