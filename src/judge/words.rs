//! Words near a formula that tell what it is, as far as its role does not.

use super::model::Curve;
use super::statement::Statement;

/// Words before a formula that make it a condition or an equation to be solved.
pub const CONDITION_CUES: &[&str] = &[
    "if",
    "when",
    "whenever",
    "suppose",
    "assume",
    "such that",
    "satisfy",
    "satisfies",
    "solve",
    "equation",
    "condition",
    "conditions",
    "require",
    "requires",
    "iff",
    "unless",
    "want",
    "find",
    "impose",
    "unknown",
    "solves",
    "which",
    "whether",
    "vanishes",
    "root",
    "roots",
    "zero of",
    "ask",
    "若",
    "如果",
    "当",
    "条件",
    "满足",
    "方程",
    "假设",
    "求",
    "使得",
    "要求",
    "等价",
    "wenn",
    "falls",
    "löse",
    "gleichung",
    "bedingung",
    "bedingungen",
    "si",
    "résoudre",
    "équation",
    "condition de",
];

/// Words before a formula that introduce a new meaning.
pub const DEFINITION_CUES: &[&str] = &[
    "let", "define", "set", "put", "denote", "given", "consider", "设", "令", "记", "定义", "取", "给定",
    "sei", "setze", "soit", "posons", "on pose",
];

/// The last words before a formula, in small letters.
pub fn last_words(statement: &Statement) -> String {
    let text = if statement.gap.trim().is_empty() { &statement.before } else { &statement.gap };
    let tail: Vec<char> = text.trim().chars().rev().take(60).collect();
    let tail: String = tail.into_iter().rev().collect();
    // Only what stands after the last full stop belongs to the sentence.
    let start = tail
        .rfind(['.', '。', ';', '；', '\n'])
        .map_or(0, |at| at + tail[at..].chars().next().map_or(1, char::len_utf8));
    let words = tail[start..].to_lowercase();
    // "If F is of degree n, then we have": what follows is the conclusion.
    match words.rfind("then").or_else(|| words.rfind("we have")) {
        Some(at) => words[at..].to_owned(),
        None => words,
    }
}

pub fn has_cue(words: &str, cues: &[&str]) -> bool {
    cues.iter().any(|cue| {
        if cue.is_ascii() {
            words.split(|c: char| !c.is_alphanumeric()).any(|word| word == *cue)
                || (cue.contains(' ') && words.contains(cue))
        } else {
            words.contains(cue)
        }
    })
}

/// The Bézier curve that the words before a formula speak of, if they speak of its polar form.
pub fn curve_spoken_of(recent: &str) -> Option<Curve> {
    let text = recent.to_lowercase();
    let tail: String = {
        let letters: Vec<char> = text.chars().rev().take(400).collect();
        letters.into_iter().rev().collect()
    };
    let bezier = [
        "bezier curve",
        "bézier curve",
        "贝塞尔曲线",
        "bezier曲线",
        "bezier 曲线",
        "bézierkurve",
        "courbe de bézier",
    ]
    .iter()
    .any(|word| tail.contains(word));
    let polar = ["polar form", "blossom", "极形式", "开花", "polarform", "forme polaire"]
        .iter()
        .any(|word| tail.contains(word));
    (bezier && polar).then(|| Curve { points: "b".to_owned() })
}
