//! Formulas that a sentence gives without standing for them: "It would be wrong to write …", "…, which is false".

use super::{normal, plain};
use crate::formula::source::Pieces;

/// Verbs of what is not so.
const UNREAL: &[&str] = &[
    "would", "würde", "würden", "hätte", "hätten", "wäre", "wären", "gäbe", "ergäbe", "ergäben", "bekäme",
    "erhielte", "käme", "müsste",
];

/// What is believed and not so.
const BELIEVED: &[&str] = &[
    "tempting",
    "tempted",
    "might think",
    "might believe",
    "might expect",
    "might guess",
    "might hope",
    "verlockend",
    "könnte meinen",
    "könnte glauben",
    "könnte denken",
    "könnte vermuten",
    "pourrait croire",
    "pourrait penser",
    "on serait tenté",
    "i wrote",
    "i got",
    "my guess",
    "ich habe geschrieben",
    "j'ai écrit",
    "j'ai trouvé",
    "had we",
    "had one",
    "if we had",
    "if one had",
    "were we to",
    "if it were",
    "hätte man",
    "hätten wir",
    "si l'on avait",
    "si nous avions",
    "可能会认为",
    "可能以为",
    "容易以为",
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

/// How words begin with which something is said to be so, besides those for what is true.
const SAYS: &[&str] = &[
    "mean", "impl", "follow", "hold", "equal", "entail", "heißt", "heissen", "bedeutet", "folgt", "gilt",
    "impliqu", "signifi", "entraîn", "résult", "意味", "表示", "说明", "推出", "等于",
];

/// So many words may stand between such a word and the one that denies it.
const BETWEEN: usize = 2;

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

/// Words with which a sentence begins that asks which formulas are true.
const CHOOSING: &[&str] = &[
    "which",
    "decide",
    "choose",
    "mark",
    "tick",
    "select",
    "welche",
    "welcher",
    "welches",
    "entscheiden",
    "entscheide",
    "kreuzen",
    "kreuze",
    "wählen",
    "lequel",
    "laquelle",
    "lesquelles",
    "lesquels",
    "quelle",
    "quelles",
    "quels",
    "cochez",
    "choisissez",
    "判断",
    "选",
];

/// Titles of such questions.
const TRUE_OR_FALSE: &[&str] = &[
    "true or false",
    "right or wrong",
    "correct or not",
    "richtig oder falsch",
    "wahr oder falsch",
    "vrai ou faux",
    "juste ou faux",
    "正误",
    "对错",
    "真假",
    "是否正确",
];

/// How words begin for what is true.
const TRUE: &[&str] = &[
    "true", "right", "correct", "valid", "richtig", "wahr", "korrekt", "gültig", "vrai", "juste", "exact",
    "valable", "正确", "成立",
];

/// Titles of sheets with such questions.
const QUIZ: &[&str] = &["quiz", "multiple choice", "multiple-choice", "qcm", "单选题", "选择题", "判断题"];

/// What a sentence begins with that speaks of the one before it.
const THAT: &[&str] = &[
    "this", "that", "it", "both", "das", "dies", "es", "beides", "c'est", "c’est", "cela", "ceci", "ce",
    "这", "此", "该",
];

/// Words after which comes what is spoken of.
const ONWARD: &[&str] = &["that", "dass", "que", "to", "zu", "if", "for", "unless", "für"];

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
    let believed = BELIEVED.iter().any(|cue| clause.contains(cue));
    if clause.split(' ').any(verb) || calls_wrong(clause) || believed || says_it_is_not(clause) {
        return true;
    }
    let right = normal(right);
    let clause = right.split(['.', ';', '。', '；']).next().unwrap_or_default();
    let near: String = clause.split(' ').take(7).collect::<Vec<_>>().join(" ");
    let first = near.split([',', '，']).next().unwrap_or_default();
    !joins(&near) && (calls_wrong(&near) || says_it_is_not(first))
}

/// "Not right is", "does not mean that", "gilt nicht", "n'implique pas", but not "it is not hard to see that".
fn says_it_is_not(clause: &str) -> bool {
    let says = |word: &&str| TRUE.iter().chain(SAYS).any(|cue| word.starts_with(cue));
    let words: Vec<&str> = clause.split_whitespace().collect();
    let denied = words.iter().enumerate().any(|(at, word)| {
        let near = &words[at.saturating_sub(BETWEEN)..words.len().min(at + BETWEEN + 1)];
        NOT.contains(word) && near.iter().any(says)
    });
    denied
        || clause.match_indices('不').any(|(at, not)| {
            let rest = clause.piece(at + not.len()..);
            TRUE.iter().chain(SAYS).any(|cue| !cue.is_ascii() && rest.starts_with(cue))
        })
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

/// Whether a sentence begins by calling wrong what the one before it said: "This is false", but not "It is false that".
pub fn calls_that_wrong(words: &str) -> bool {
    let text = plain(words);
    let text = text.trim_start();
    let points = THAT.iter().any(|that| {
        let rest = text.strip_prefix(that);
        rest.is_some_and(|rest| !that.is_ascii() || !rest.starts_with(char::is_alphabetic))
    });
    let words: Vec<&str> =
        text.split([',', ';', ':', '.', '，', '；', '。']).next().unwrap_or_default().split(' ').collect();
    let start = words[..words.len().min(5)].join(" ");
    points && calls_wrong(&start) && !words.iter().any(|word| ONWARD.contains(word))
}

/// Whether a sentence asks which of the formulas after it are true: "True or false?", "Which of these are correct?"
pub fn asks_what_is_true(words: &str) -> bool {
    let text = plain(words);
    let begins = |cue: &&str| {
        text.match_indices(*cue)
            .any(|(at, _)| !cue.is_ascii() || !text.piece(..at).ends_with(char::is_alphanumeric))
    };
    let first = |cue: &&str| {
        text.strip_prefix(*cue).is_some_and(|rest| !cue.is_ascii() || !rest.starts_with(char::is_alphabetic))
    };
    let asks = text.contains(['?', '？']) || CHOOSING.iter().any(first);
    asks && TRUE.iter().any(begins) || TRUE_OR_FALSE.iter().chain(QUIZ).any(begins)
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
