//! What stands in a formula and does not belong to it: labels, numbers, text between rows, comments.

use super::arguments::command_name;
use super::text::Text;
use crate::formula::Kind;
use crate::formula::source::{Pieces, Span};
use crate::language::syntax;
use crate::language::write::latex;

/// A longer label or text between rows is not looked for.
const MAX_LABEL: usize = 1500;

/// The formula that stands at byte `start` with `\label{…}`, `\tag{…}`, `\nonumber`, `\notag`,
/// `\intertext{…}` blanked, and comments too if there can be any. In place of `\polarform{…}`, the query
/// stands there.
pub(super) fn cleaned(text: &str, start: usize, comments: bool) -> Text {
    let mut clean = Text::plain("", start);
    let mut said = 0;
    let mut at = 0;
    while let Some(found) = text.piece(at..).find(|c| c == '\\' || (comments && c == '%')) {
        at += found;
        if let Some((end, query)) = query(text, at) {
            plain(&mut clean, text, start, said..at);
            clean.push_whole(&query, Span::new(start + at, start + end));
            (said, at) = (end, end);
            continue;
        }
        let end = if text.piece(at..).starts_with('%') {
            at + text.piece(at..).find('\n').unwrap_or(text.len() - at)
        } else {
            match dropped(text, at) {
                Ok(end) => end,
                Err(after) => {
                    at = after;
                    continue;
                }
            }
        };
        plain(&mut clean, text, start, said..at);
        // As many blanks as characters, so that lines of ASCII stay as long as they are.
        for (i, c) in text.piece(at..end).char_indices() {
            let place = Span::new(start + at + i, start + at + i + c.len_utf8());
            clean.push_whole(if c == '\n' { "\n" } else { " " }, place);
        }
        (said, at) = (end, end);
    }
    plain(&mut clean, text, start, said..text.len());
    clean
}

/// The query `\polarform{…}` at `at` as LaTeX, and its end.
fn query(text: &str, at: usize) -> Option<(usize, String)> {
    if command_name(text, at) != "polarform" {
        return None;
    }
    let open = at + "\\polarform".len();
    let end = braces_end(text, open)?;
    let inner = text.piece(open..end).trim().strip_prefix('{')?.strip_suffix('}')?;
    if syntax::looks_like_latex(inner) {
        return Some((end, format!("\\left({inner}\\right)")));
    }
    let expr = syntax::parse(inner).ok()?;
    let one = matches!(expr.kind, Kind::Name(_) | Kind::Number(_) | Kind::Subscript(..) | Kind::Apply(..));
    let formula = latex(&expr);
    Some((end, if one { formula } else { format!("\\left( {formula} \\right)") }))
}

fn plain(clean: &mut Text, text: &str, start: usize, part: std::ops::Range<usize>) {
    if !part.is_empty() {
        clean.places.push(clean.text.len(), start + part.start, true);
        clean.text.push_str(text.piece(part));
    }
}

/// The byte after the command at `at` and its argument if both are dropped, else that after its name.
fn dropped(text: &str, at: usize) -> Result<usize, usize> {
    let name = command_name(text, at);
    let after = at + 1 + name.len();
    match name {
        "nonumber" | "notag" => Ok(after),
        "label" | "tag" | "intertext" | "shortintertext" => {
            let star = after + usize::from(text.piece(after..).starts_with('*'));
            Ok(braces_end(text, star).unwrap_or(after))
        }
        _ => Err(after),
    }
}

/// The byte after the group in braces at `at`.
pub(super) fn braces_end(text: &str, at: usize) -> Option<usize> {
    let open = at + (text.piece(at..).len() - text.piece(at..).trim_start().len());
    let mut depth = 0_usize;
    let mut escaped = false;
    for (i, byte) in text.piece(open..).bytes().enumerate().take(MAX_LABEL) {
        match byte {
            _ if escaped => {
                escaped = false;
                continue;
            }
            b'\\' => escaped = true,
            b'{' => depth += 1,
            b'}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (i > 0).then_some(open + i + 1);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_and_comments_are_blanked() {
        for (text, comments, wanted) in [
            (r"a\label{x} = b\nonumber", false, "a          = b         "),
            (r"a \tag*{(é)} b", false, "a            b"),
            ("a \\intertext{so\n$x$} b", false, "a              \n     b"),
            (r"a \labels{x} \label{", false, r"a \labels{x}       {"),
            ("a % é $\n+ b \\% c", true, "a      \n+ b \\% c"),
            ("a % b", false, "a % b"),
        ] {
            assert_eq!(cleaned(text, 7, comments).text, wanted, "{text}");
        }
        let clean = cleaned("a % é\n+ b", 7, true);
        let sign = clean.text.find('+').unwrap();
        assert_eq!(clean.places.byte(sign), 7 + "a % é\n".len());
        assert_eq!(braces_end("x {a{b}} c", 1), Some(8));
        assert_eq!(braces_end("{a", 0), None);
        assert_eq!(braces_end(r"{\}\\}", 0), Some(6));
    }
}
