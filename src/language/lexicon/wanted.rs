//! Words for what is asked with something else: and its value, find b so that, which c make the join C^2.

use super::asking::starts_with_one_of;
use super::letters::is_ideograph;
use crate::formula::source::Span;

/// Words between two things that are asked.
const AND: &[&str] = &["and", "und", "et", "y", "e", "以及", "及", "和"];

/// Words for what is done with that what was asked first.
const AGAIN: &[&str] = &[
    "evaluate",
    "evaluate it",
    "the value",
    "value",
    "den wert",
    "werte sie",
    "la valeur",
    "l'évaluer",
    "el valor",
    "il valore",
    "在",
];

/// Words that stand for an object before them, whatever else is said.
const POSSESSIVES: &[&str] = &[
    "its", "seinen", "seine", "sein", "ihren", "ihre", "ihr", "sa", "son", "ses", "su", "sus", "il suo",
    "la sua", "其", "它的",
];

/// Whether a text asks about an object that is named before it: find its derivative at 0.
pub(crate) fn is_of_another(text: &str) -> bool {
    let mut rest = text.trim_start();
    while let Some(length) = starts_with_one_of(rest, WANTED) {
        rest = rest.get(length..).unwrap_or_default().trim_start();
    }
    starts_with_one_of(rest, POSSESSIVES).is_some()
}

/// Where the words for "and" stand in a text outside of brackets: the end of what is before them, the start of what follows.
pub(crate) fn conjunctions(text: &str) -> Vec<(usize, usize)> {
    let mut depth = 0_i32;
    let mut found = Vec::new();
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        if depth == 0
            && (before.is_whitespace() || is_ideograph(c))
            && let Some(length) = text.get(at..).and_then(|rest| starts_with_one_of(rest, AND))
        {
            found.push((at, at + length));
        }
        before = c;
    }
    found
}

/// The end of what is asked first and the start of what is asked about its answer: and its value at 1.
pub(crate) fn and_its(text: &str) -> Option<(usize, usize)> {
    conjunctions(text).into_iter().find(|(end, start)| {
        let rest = text.get(*start..).unwrap_or_default().trim_start();
        *end > 0 && [AGAIN, POSSESSIVES].into_iter().any(|words| starts_with_one_of(rest, words).is_some())
    })
}

/// Words before names that are asked for.
const WANTED: &[&str] = &[
    "find",
    "determine",
    "compute",
    "calculate",
    "choose",
    "what is",
    "which",
    "for which",
    "for what",
    "which value of",
    "for which value of",
    "for what value of",
    "what value of",
    "for which values of",
    "the value of",
    "the values of",
    "what must",
    "what should",
    "what does",
    "the coefficient",
    "the control point",
    "all",
    "value of",
    "the point",
    "the points",
    "the number",
    "the parameter",
    "the unknown",
    "the middle control point",
    "le point",
    "le point de contrôle",
    "den punkt",
    "den kontrollpunkt",
    "die zahl",
    "el punto",
    "el punto de control",
    "fix",
    "pick",
    "bestimme",
    "finde",
    "berechne",
    "wähle",
    "für welches",
    "für welche",
    "für welchen wert von",
    "welches",
    "welche",
    "trouve",
    "trouver",
    "trouvez",
    "déterminer",
    "détermine",
    "pour quel",
    "pour quelle valeur de",
    "pour quelle",
    "quel",
    "quelle",
    "encuentra",
    "halla",
    "determina",
    "para qué",
    "para qué valor de",
    "qué",
    "求",
    "trova",
];

/// Words between such names and what is to hold.
const MAKING: &[&str] = &[
    "be so that",
    "be such that",
    "need to be so that",
    "have to be so that",
    "make",
    "makes",
    "is",
    "are",
    "do",
    "does",
    "has",
    "will",
    "have we",
    "gives",
    "give",
    "machen",
    "macht",
    "ist",
    "sind",
    "hat",
    "gilt",
    "est",
    "rend",
    "rendent",
    "faut-il pour que",
    "es",
    "hace que",
    "hacen que",
    "so that",
    "such that",
    "so dass",
    "sodass",
    "tel que",
    "telle que",
    "tels que",
    "tal que",
    "tales que",
    "damit",
    "para que",
    "pour que",
    "使",
    "使得",
];

/// The names that are asked for and what is said that makes them known: find b_1 such that the quadratic 1, b_1, 3 has …
pub(crate) fn asked_by_condition(text: &str) -> Option<(Span, Span)> {
    let skip = |at: usize| at + text.get(at..).map_or(0, |rest| rest.len() - rest.trim_start().len());
    let mut start = skip(0);
    let first = start;
    while let Some(length) = text.get(start..).and_then(|rest| starts_with_one_of(rest, WANTED)) {
        start = skip(start + length);
    }
    if start == first {
        return None;
    }
    let mut before = ' ';
    for (at, c) in text.get(start..)?.char_indices() {
        let place = start + at;
        if at > 0
            && (before.is_whitespace() || is_ideograph(c))
            && let Some(length) = text.get(place..).and_then(|rest| starts_with_one_of(rest, MAKING))
        {
            let names = text.get(start..place)?.trim_end().trim_end_matches(',');
            let claim = skip(place + length);
            let end = text
                .trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '?' | '.' | '？' | '。'))
                .len();
            return (!names.is_empty() && claim < end)
                .then(|| (Span::new(start, start + names.len()), Span::new(claim, end)));
        }
        // Names, and what stands between them.
        let inside = c.is_alphanumeric() || matches!(c, '_' | '{' | '}' | ',' | ' ' | '\'');
        if !inside {
            return None;
        }
        before = c;
    }
    None
}

/// Where an order of smoothness stands, C^2, whether it is a geometric one, and which it is.
pub(crate) fn order_of_join(text: &str) -> Option<(usize, usize, bool, i64)> {
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        if matches!(c, 'C' | 'G') && !before.is_alphanumeric() {
            let rest = text.get(at + 1..)?;
            let sign = usize::from(rest.starts_with('^'));
            let digits = rest.get(sign..)?.chars().take_while(char::is_ascii_digit).count();
            let end = at + 1 + sign + digits;
            if digits > 0 && !text.get(end..)?.starts_with(|c: char| c.is_alphanumeric() || c == '(') {
                return Some((at, end, c == 'G', text.get(end - digits..end)?.parse().ok()?));
            }
        }
        before = c;
    }
    None
}

/// Words between a question and the object that it is about.
const FOR: &[&str] =
    &["for", "where", "if", "of", "für", "wenn", "falls", "von", "pour", "si", "de", "para", "del", "per"];

/// Where an object may begin behind what is asked about it: the end of the question, the start of the object.
pub(crate) fn of_objects(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut before = ' ';
    let mut depth = 0_i32;
    for (at, c) in text.char_indices() {
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        if depth == 0
            && before.is_whitespace()
            && at > 0
            && let Some(length) = text.get(at..).and_then(|rest| starts_with_one_of(rest, FOR))
        {
            found.push((at, at + length));
        }
        before = c;
    }
    found
}
