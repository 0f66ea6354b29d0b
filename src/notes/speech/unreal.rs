//! Formulas that a sentence gives without standing for them: "It would be wrong to write …", "…, which is false".

use super::{normal, plain};
use crate::formula::source::Pieces;

/// Verbs of what is not so.
const UNREAL: &[&str] = &[
    "would", "würde", "würden", "hätte", "hätten", "wäre", "wären", "gäbe", "ergäbe", "ergäben", "bekäme",
    "erhielte", "käme", "müsste",
];

/// How the French conditional ends.
const CONDITIONAL: &[&str] =
    &["erait", "eraient", "irait", "iraient", "drait", "draient", "aurait", "vrait", "rrait"];

/// How words begin that call something wrong.
const WRONG: &[&str] = &[
    "wrong",
    "incorrect",
    "false",
    "erroneous",
    "nonsens",
    "untrue",
    "falsch",
    "fälschlich",
    "irrtümlich",
    "unsinn",
    "faux",
    "fausse",
    "erroné",
    "à tort",
    "错误",
    "错写",
    "误写",
    "误以为",
    "不成立",
    "impossible",
    "unmöglich",
    "absurd",
    "不正确",
];

const NOT: &[&str] = &["not", "never", "nicht", "nie", "pas", "kein", "keine"];

/// Mistakes that a sentence may tell of at length.
const MISTAKES: &[&str] = &[
    "mistake",
    "common error",
    "typical error",
    "häufiger fehler",
    "häufigen fehler",
    "typischer fehler",
    "beliebter fehler",
    "erreur fréquente",
    "erreur courante",
    "erreur classique",
    "常见错误",
    "常见的错误",
];

/// Words with which something else begins.
const JOINTS: &[&str] = &["and", "but", "while", "whereas", "und", "aber", "während", "et", "mais", "tandis"];

/// Whether the words around a formula say that it is not so, or would be so only if something else were.
///
/// Cost: linear in the words.
pub(super) fn is_unreal(left: &str, right: &str) -> bool {
    let left = normal(left);
    // "Es wäre falsch, hier … zu schreiben"
    let infinitive = right.trim_start().starts_with("zu ");
    let ends: &[char] = if infinitive { &[';', ':'] } else { &[',', ';', ':', '，', '；', '：', '('] };
    let clause = left.rsplit(ends).next().unwrap_or_default();
    let verb = |word: &str| UNREAL.contains(&word) || CONDITIONAL.iter().any(|end| word.ends_with(end));
    if clause.split(' ').any(verb) || calls_wrong(clause) {
        return true;
    }
    let right = normal(right);
    let clause = right.split(['.', ';', '。', '；']).next().unwrap_or_default();
    let near: String = clause.split(' ').take(7).collect::<Vec<_>>().join(" ");
    !joins(&near) && calls_wrong(&near)
}

/// Whether words deny what follows them: "but not".
pub fn denies(words: &str) -> bool {
    let text = plain(words);
    text.contains('不') || text.split(' ').any(|word| NOT.contains(&word))
}

/// Whether words begin with "and", "but" or the like.
pub fn joins(words: &str) -> bool {
    plain(words).split(' ').next().is_some_and(|first| JOINTS.contains(&first))
}

/// Whether words begin to tell of a mistake that many make.
pub fn names_a_mistake(words: &str) -> bool {
    let text = plain(words);
    MISTAKES.iter().any(|mistake| text.contains(mistake))
}

fn calls_wrong(clause: &str) -> bool {
    WRONG.iter().any(|wrong| {
        clause.match_indices(wrong).any(|(at, _)| {
            let before = clause.piece(..at);
            let begins = !before.ends_with(char::is_alphabetic) || !wrong.is_ascii();
            let last = before.split_whitespace().next_back().unwrap_or_default();
            begins && last != "no" && !NOT.contains(&last) && !before.ends_with('不')
        })
    })
}
