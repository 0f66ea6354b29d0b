//! Words that make of a name any thing of its kind: "for every polynomial p", "let h be arbitrary".

use super::{normal, plain};

/// How words begin that stand before something of which anything may be meant.
const ANY: &[&str] = &[
    "any",
    "every",
    "each",
    "arbitrary",
    "general",
    "another",
    "beliebig",
    "jede",
    "allgemein",
    "ander",
    "tout",
    "chaque",
    "quelconque",
    "arbitraire",
    "général",
    "autre",
    "任意",
    "任何",
    "任一",
    "每",
    "一般",
    "另",
    "其他",
    "其它",
];

/// The same, after the name: "be arbitrary", "un polynôme quelconque".
const BE: &[&str] =
    &["be", "is", "are", "denote", "sei", "seien", "ist", "sind", "un", "une", "est", "sont", "为", "是"];

/// Words that introduce a name, and articles after it: "let f be a continuous function".
const LET: &[&str] = &["let", "sei", "seien", "soit", "soient", "设", "令"];
const ARTICLES: &[&str] = &["a", "an", "ein", "eine", "einer", "un", "une", "一"];

/// So many words may stand between such a word and the name.
const FEW: usize = 6;

fn begins(word: &str) -> bool {
    ANY.iter()
        .any(|cue| if cue.is_ascii() || word.is_ascii() { word.starts_with(cue) } else { word.contains(cue) })
}

/// Whether the words after a name say that it is arbitrary: "be arbitrary", "seien beliebig", "任意".
pub fn is_arbitrary(right: &str) -> bool {
    let after = clause(plain(right).trim_start(), false);
    let last =
        |word: &String| FREE.iter().any(|cue| word.starts_with(cue) || !cue.is_ascii() && word.contains(cue));
    after.len() <= 4 && after.iter().any(last)
}

/// How the words begin that make a name arbitrary.
const FREE: &[&str] = &["arbitrary", "beliebig", "quelconque", "arbitraire", "任意"];

/// Words with which what is spoken of has data.
const WITH: &[&str] = &[
    "with",
    "having",
    "satisfying",
    "through",
    "interpolating",
    "from",
    "mit",
    "durch",
    "aus",
    "avec",
    "par",
    "de",
    "vérifiant",
    "满足",
    "由",
    "从",
    "取",
];

/// Whether the words from the start of a sentence to its first formula only say of what kind of thing it speaks: "the
/// polynomials with", "a clamped spline has".
pub fn speaks_of_a_kind(left: &str) -> bool {
    let words = normal(left);
    let words: Vec<&str> = words.split_whitespace().collect();
    let (Some(first), Some(last)) = (words.first(), words.last()) else { return false };
    let with = WITH.iter().any(|own| last == own || !own.is_ascii() && last.ends_with(own));
    let indefinite = words.len() <= FEW
        && ARTICLES.iter().any(|own| first == own || !own.is_ascii() && first.starts_with(own));
    with || indefinite || words.len() <= FEW && words.iter().any(|word| begins(word))
}

/// The words of the last or the first clause.
fn clause(text: &str, last: bool) -> Vec<String> {
    let mut parts = text.split([',', ';', ':', '.', '，', '；', '：', '。']);
    let part = if last { parts.next_back() } else { parts.next() };
    part.unwrap_or_default().split_whitespace().map(str::to_owned).collect()
}

/// Words that open what something is said for.
const FOR: &[&str] = &["for", "für", "pour", "对", "对于"];

/// Whether the words before a relation say that it holds for anything of a kind: "for arbitrary control points".
pub fn holds_for_any(left: &str) -> bool {
    let words = clause(&normal(left), true);
    let opens = words
        .first()
        .is_some_and(|first| FOR.iter().any(|own| first == own || !own.is_ascii() && first.starts_with(own)));
    opens && words.len() <= FEW && words.iter().any(|word| begins(word))
}

/// Whether the words around a name make it any thing of its kind.
///
/// Cost: linear in the words.
pub fn releases(left: &str, right: &str) -> bool {
    // "for every cubic F"
    let before = clause(&normal(left), true);
    let near = &before[before.len().saturating_sub(FEW)..];
    let article =
        |word: &String| ARTICLES.iter().any(|own| word == own || !own.is_ascii() && word.starts_with(own));
    // "a natural spline s"
    let indefinite = before.len() > 1 && before.len() <= FEW && before.first().is_some_and(article);
    if near.iter().any(|word| begins(word)) || indefinite {
        return true;
    }
    // "let p be an arbitrary polynomial"
    let after = clause(plain(right).trim_start(), false);
    let said = after
        .first()
        .is_some_and(|first| BE.iter().any(|be| first == be || !be.is_ascii() && first.starts_with(be)));
    let lets = before
        .last()
        .is_some_and(|last| LET.iter().any(|own| last == own || !own.is_ascii() && last.ends_with(own)));
    let introduced = lets && after.iter().take(2).any(article);
    introduced || said && after.iter().take(FEW).any(|word| begins(word))
}
