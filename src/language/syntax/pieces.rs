//! A text taken apart into phrases and the formulas between them.

use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::letters::{self, is_ideograph};
use crate::language::lexicon::phrases::{Label, Phrase, phrase};
use crate::language::lexicon::{asking, words};
use std::borrow::Cow;

/// A part of a text with words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Part {
    /// Words that are known.
    Phrase(Phrase, Span),
    /// What stands between them.
    Piece(Span),
}

/// The phrases outside of brackets and the formulas between them.
pub(super) fn parts(
    text: &str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut depth = 0_usize;
    let mut dollar = false;
    let mut start = 0;
    let mut at = 0;
    let mut before = ' ';
    let push = |parts: &mut Vec<Part>, from: usize, to: usize| {
        let piece = text.piece(from..to);
        let separates = |c: char| {
            c.is_whitespace()
                || matches!(c, ',' | ';' | ':' | '.' | '?' | '？' | '，' | '：' | '。' | '!' | '¿' | '¡')
        };
        // 5! is a factorial
        let trimmed = piece.trim_start_matches(separates).trim_end_matches(|c| c != '!' && separates(c));
        if !trimmed.is_empty() && !matches!(trimmed, "'" | "’") {
            let from = from + (piece.len() - piece.trim_start_matches(separates).len());
            parts.push(Part::Piece(Span::new(from, from + trimmed.len())));
        }
    };
    let mut listed = false;
    let mut solid = ' ';
    while let Some(c) = text.piece(at..).chars().next() {
        let apart = !(before.is_alphanumeric() && !is_ideograph(before)
            || matches!(before, '_' | '^' | '\\' | '{'))
            || is_ideograph(c);
        if depth == 0
            && !dollar
            && apart
            && c.is_alphabetic()
            && let Some((phrase, length)) = phrase(text.piece(at..), function)
            && is_word(text, at, length, known, phrase)
            // for which a is a^2 = 4
            && !(length == 1 && matches!(parts.last(), Some(Part::Phrase(Phrase::Which, _))) && text.piece(start..at).trim().is_empty())
        {
            push(&mut parts, start, at);
            parts.push(Part::Phrase(phrase, Span::new(at, at + length)));
            at += length;
            // knots = 0, 1, 2
            let sign = text.piece(at..).trim_start();
            let points = matches!(phrase, Phrase::Function("control_points" | "bezier_points"));
            match sign.chars().next() {
                Some('=' | ':') if matches!(phrase, Phrase::Label(_)) => at = text.len() - sign.len() + 1,
                // 节点为 0, 1, 2
                Some(is @ ('为' | '是')) if points || matches!(phrase, Phrase::Label(_)) => {
                    at = text.len() - sign.len() + is.len_utf8();
                }
                _ => {}
            }
            start = at;
            listed = false;
            before = ' ';
            continue;
        }
        // de 0 a 3
        if c == 'a'
            && depth == 0
            && before == ' '
            && solid.is_ascii_digit()
            && matches!(parts.last(), Some(Part::Phrase(Phrase::Of | Phrase::Label(Label::From), _)))
            && text
                .piece(at..)
                .strip_prefix("a ")
                .is_some_and(|rest| rest.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit()))
        {
            push(&mut parts, start, at);
            parts.push(Part::Phrase(Phrase::Label(Label::To), Span::new(at, at + 1)));
            at += 1;
            start = at;
            before = ' ';
            continue;
        }
        // at t = 1/2: (0, 0), (2, 4)
        let piece = text.piece(start..at).trim_start();
        if c == ':'
            && depth == 0
            && !dollar
            && piece.contains('=')
            && begins_equation(piece)
            && text
                .piece(at + 1..)
                .trim_start()
                .starts_with(|next: char| next == '(' || next.is_ascii_digit())
            && text.piece(at + 1..).starts_with(' ')
        {
            push(&mut parts, start, at);
            at += 1;
            start = at;
            listed = false;
            before = ' ';
            continue;
        }
        // 0, 4, 2, t = 1/2
        let ends = solid.is_alphanumeric() || matches!(solid, ',' | ')' | ']' | '}');
        let after_list = before == ',' || listed && before.is_whitespace() && ends;
        if depth == 0 && after_list && start < at && begins_equation(text.piece(at..)) {
            push(&mut parts, start, at);
            start = at;
            listed = false;
        }
        listed |= depth == 0 && matches!(c, ',' | '=' | ':') || depth == 1 && c == ']';
        // -> Bernstein
        if let Some(arrow) = ["->", "→"].into_iter().find(|arrow| text.piece(at..).starts_with(arrow)) {
            let after = text.piece(at + arrow.len()..).trim_start();
            if matches!(phrase(after, function), Some((Phrase::Function(_) | Phrase::Degree(_), _))) {
                push(&mut parts, start, at);
                parts.push(Part::Phrase(Phrase::Label(Label::To), Span::new(at, at + arrow.len())));
                at += arrow.len();
                start = at;
                before = ' ';
                continue;
            }
        }
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            '$' => dollar = !dollar,
            _ => {}
        }
        before = c;
        if !c.is_whitespace() {
            solid = c;
        }
        at += c.len_utf8();
    }
    push(&mut parts, start, text.len());
    parts
}

/// Whether a text can have words: a formula of letters and calls, polar(t^3) + 1, has none, and needs none looked up.
pub(super) fn may_have_words(text: &str) -> bool {
    if !text.is_ascii() || text.contains(['=', '?', '\'']) {
        return true;
    }
    let part = |c: char| c.is_alphanumeric() || c == '_';
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_alphabetic()) {
        let apart = rest.piece(..start).ends_with(' ');
        rest = rest.piece(start..);
        let end = rest.find(|c| !part(c)).unwrap_or(rest.len());
        let letters = rest.piece(..end).chars().filter(|c| c.is_alphabetic()).count();
        rest = rest.piece(end..);
        // A letter between blanks may be one, as in Spanish.
        if if letters > 1 { !rest.starts_with('(') } else { apart && rest.starts_with(' ') } {
            return true;
        }
    }
    false
}

/// The text with blanks for the parentheses around words: `at t = 1/2 (degree 2)`.
pub(super) fn without_asides<'a>(
    text: &'a str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
) -> Cow<'a, str> {
    let mut masked: Option<Vec<u8>> = None;
    let mut at = 0;
    while let Some(found) = text.piece(at..).find(['(', '[', '{']) {
        let open = at + found;
        let length = text.piece(open..).len() - after_brackets(text.piece(open..)).len();
        let Some(inside) = text.piece(open..open + length).strip_suffix(')').and_then(|all| all.get(1..))
        else {
            at = open + length.max(1);
            continue;
        };
        let says = match phrase(inside, function) {
            Some((own @ (Phrase::Label(_) | Phrase::Degree(_) | Phrase::Ordinal(_)), length))
                if length < inside.len() =>
            {
                is_word(inside, 0, length, known, own) && inside.piece(length..).starts_with(' ')
            }
            // 1, 3, 2 (Bézier); 0, 0, 1, 1 (linear)
            Some((Phrase::Function("bezier" | "bspline") | Phrase::Degree(_), length)) => {
                length == inside.len()
            }
            _ => false,
        };
        if says && text.piece(..open).ends_with(' ') && text.piece(open..).starts_with('(') {
            let bytes = masked.get_or_insert_with(|| text.as_bytes().to_vec());
            bytes[open] = b' ';
            bytes[open + length - 1] = b' ';
        }
        at = open + length.max(1);
    }
    masked.and_then(|bytes| String::from_utf8(bytes).ok()).map_or(Cow::Borrowed(text), Cow::Owned)
}

/// Whether a text is made of words alone that ask for nothing: use Bernstein coefficients; please explain why.
pub(crate) fn is_aside(text: &str, known: &dyn Fn(&str) -> bool) -> bool {
    // A sign of a formula, as in "a = ?", is none.
    let separates = |c: char| c.is_whitespace() || ".,;:!?()'\"-？。，".contains(c);
    let mut rest = text.trim_start_matches(separates);
    let mut way = false;
    let none = rest.is_empty();
    while !rest.is_empty() {
        let length = match (asking::aside(rest), phrase(rest, &|_| None)) {
            (Some(length), _) => length,
            (None, Some((Phrase::Using, length))) => {
                way = true;
                length
            }
            (None, Some((Phrase::Filler | Phrase::And | Phrase::Of, length))) => length,
            // How it is done changes nothing.
            (
                None,
                Some((
                    Phrase::Function("polar" | "casteljau" | "deboor" | "in_bernstein" | "bernstein"),
                    length,
                )),
            ) if way => length,
            _ => return false,
        };
        if known(rest.piece(..length)) {
            return false;
        }
        rest = rest.piece(length..).trim_start_matches(separates);
    }
    !none
}

/// Whether a text is made of a few words alone that name nothing that can be done: variation diminishing.
pub(crate) fn is_title(
    text: &str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
) -> bool {
    const MOST: usize = 4;
    let mut count = 0;
    for word in text.split_whitespace() {
        let plain =
            word.chars().count() > 2 && word.chars().all(|c| c.is_alphabetic() || matches!(c, '-' | '\''));
        let says = match phrase(word, function) {
            Some((Phrase::Filler | Phrase::Aside, _)) | None => false,
            Some(_) => true,
        };
        count += 1;
        if !plain
            || says
            || known(word)
            || words::aside(word).is_some()
            || words::prose(word).is_some()
            || asking::denies(word)
        {
            return false;
        }
    }
    (1..=MOST).contains(&count)
}

/// Whether a name with its value stands at the start of a text: t = 1/2.
pub(super) fn begins_equation(text: &str) -> bool {
    let rest = text.trim_start_matches(|c: char| c.is_alphanumeric() || matches!(c, '_' | '\''));
    let sign = rest.trim_start();
    // x: 0 1 3
    let lists = text.len() - rest.len() == 1 && sign.starts_with(": ");
    text.starts_with(char::is_alphabetic) && (sign.starts_with('=') && !sign.starts_with("==") || lists)
}

/// Whether what reads like a phrase is none of a formula: `degree(t)`, `a_1`, `roots := 3`, a name with a value.
fn is_word(text: &str, at: usize, length: usize, known: &dyn Fn(&str) -> bool, phrase: Phrase) -> bool {
    let written = text.piece(at..at + length);
    if known(written) {
        return false;
    }
    // both halves' control points
    if matches!(phrase, Phrase::Filler)
        && written.ends_with('s')
        && text.piece(at + length..).starts_with(['\'', '’'])
        && text.piece(at + length..).chars().nth(1).is_some_and(char::is_whitespace)
    {
        return true;
    }
    if written.ends_with(['\'', '’']) || written.contains(is_ideograph) {
        return true;
    }
    let rest = text.piece(at + length..);
    let label = matches!(phrase, Phrase::Label(_));
    let next = rest.trim_start();
    // sqrt (4) + 1 is a call.
    if matches!(phrase, Phrase::Function(_)) && next.starts_with('(') {
        let after = after_brackets(next).trim_start();
        if after.starts_with(['+', '-', '*', '/', '=', '<', '>', '!']) {
            return false;
        }
    }
    // from -1 to 2
    // of -1, 2, -2
    let negative = (label || written.chars().count() > 1)
        && rest.starts_with(' ')
        && next.strip_prefix('-').is_some_and(|rest| rest.starts_with(char::is_alphanumeric));
    if rest.starts_with(['(', '[', '_', '^', '\'', '{', '-', '.']) && !rest.starts_with(". ") && rest != "."
        || next.starts_with(['+', '*', '/', '^', '=', '<', '>', '-'])
            && !(label && next.starts_with('='))
            && !negative
        || next.starts_with(":=")
        || rest.starts_with(|c: char| c.is_alphanumeric())
    {
        return false;
    }
    // One letter is a name, unless words follow: a cubic.
    if written.chars().count() == 1 && written.is_ascii() {
        // a B-spline
        let letter = |c: &char| c.is_alphabetic() || *c == '-';
        let word: String = next.chars().take_while(letter).collect();
        return rest.starts_with(' ')
            && word.starts_with(char::is_alphabetic)
            && !word.ends_with('-')
            && word.chars().count() > 1;
    }
    true
}

/// What follows the brackets at the start of a text.
fn after_brackets(text: &str) -> &str {
    let mut depth = 0_i32;
    for (at, c) in text.char_indices() {
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        if depth == 0 {
            return text.piece(at + c.len_utf8()..);
        }
    }
    ""
}

/// Whether a sum stands in a formula outside of brackets: what belongs to it is not clear beside words.
pub(super) fn is_sum(text: &str) -> bool {
    let mut depth = 0_i32;
    text.trim_start_matches(['-', ' ']).chars().any(|c| {
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        depth == 0 && matches!(c, '+' | '-')
    })
}

/// Whether a formula has a word in it that nobody knows: "t^2 nonsense".
pub(super) fn has_words(piece: &str, known: &dyn Fn(&str) -> bool) -> bool {
    let mut before = ' ';
    let mut rest = piece;
    while let Some(c) = rest.chars().next() {
        let length = rest.chars().take_while(|c| c.is_alphabetic()).map(char::len_utf8).sum::<usize>();
        if length == 0 {
            before = c;
            rest = rest.piece(c.len_utf8()..);
            continue;
        }
        let word = rest.piece(..length);
        let after = rest.piece(length..);
        let spaced = matches!(before, ' ' | ',' | ':' | ';') && !after.starts_with(['(', '[', '_']);
        let long = word.chars().count() > 2 || word.chars().any(is_ideograph);
        // uvw, xyz
        let arguments = word.chars().all(|c| matches!(c, 'r'..='w')) && word != "rust"
            || word.chars().all(|c| matches!(c, 'x'..='z'));
        let name = known(word) || letters::sign(word).is_some() || arguments;
        if spaced && long && !name && before != '\\' {
            return true;
        }
        before = 'a';
        rest = after;
    }
    false
}

/// Whether several items stand side by side in a text, or a list of them.
pub(super) fn is_several(text: &str) -> bool {
    let first = text.trim_start_matches(|c: char| c.is_alphanumeric() || matches!(c, ' ' | '=' | '_'));
    text.contains([',', ';', '='])
        || first.starts_with(['[', '{'])
        || text.contains(' ') && !text.contains(char::is_alphabetic)
}

/// The text with blanks for \text{ }, so that all places stay the same.
pub(crate) fn without_text_commands(text: &str) -> Cow<'_, str> {
    let mut masked: Option<Vec<u8>> = None;
    let mut at = 0;
    while let Some(found) = text.piece(at..).find("\\") {
        at += found;
        let name = text.piece(at + 1..).chars().take_while(char::is_ascii_alphabetic).count();
        let open = at + 1 + name;
        let inside = text.piece(open..);
        if words::is_text_command(text.piece(at..open)) && inside.starts_with('{') {
            let length = inside.len() - after_brackets(inside).len();
            let bytes = masked.get_or_insert_with(|| text.as_bytes().to_vec());
            bytes[at..=open].fill(b' ');
            if inside.piece(..length).ends_with('}') {
                bytes[open + length - 1] = b' ';
            }
        }
        // A control space in front of it: x = 1,\ \text{knots } 0, 1
        if name == 0 && inside.starts_with(' ') && inside.trim_start().starts_with('\\') {
            masked.get_or_insert_with(|| text.as_bytes().to_vec())[at] = b' ';
        }
        at = open;
    }
    masked.and_then(|bytes| String::from_utf8(bytes).ok()).map_or(Cow::Borrowed(text), Cow::Owned)
}

#[cfg(test)]
mod tests {
    use super::may_have_words;

    #[test]
    fn formulas_and_calls_have_no_words() {
        for formula in ["polar(t^3)", "t^2 + 2t - 1", "[1, 2, 3]", "root_of(t^2 - 2, 1, 2)^2", "B_2^3(t)", ""]
        {
            assert!(!may_have_words(formula), "{formula}");
        }
        for words in [
            "roots t^2",
            "roots(F) on [0, 1]",
            "t^2 a 3",
            "f(0) = 1",
            "t^2 à 3",
            "C^1?",
            "导数 t^2",
            "q blossom of t",
        ] {
            assert!(may_have_words(words), "{words}");
        }
    }
}
