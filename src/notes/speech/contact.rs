//! Words that say how functions agree: "share their value at 1", "stimmen bis zur zweiten Ableitung überein".

use std::sync::LazyLock;

use super::starts::Starts;
use super::{Word, is_letter, plain, word};
use crate::formula::source::Pieces;

/// What a word says of functions that agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// "agree", "share", "the same".
    Agree,
    /// "touch": value and first derivative.
    Touch,
    /// "join": at least their values agree, and more where more is said.
    Join,
    /// "value".
    Value,
    /// "derivative".
    Derivative,
    /// "slope": the first derivative.
    Slope,
    /// "second".
    Ordinal(u32),
    /// "two".
    Count(u32),
    /// "times", right after a number of them.
    Twice,
    /// "continuously differentiable".
    Smooth,
    /// "order", with its number after it.
    Order,
    /// "up to".
    UpTo,
    /// "together with": what agrees besides the values.
    Including,
    /// "start": at the first end of the interval.
    Start,
    /// "end": at the last one.
    End,
    /// "end points".
    Ends,
    /// "nothing", "not".
    Not,
    /// "at", "the knot": what follows is where they agree.
    Place,
    /// "there": where it was said before.
    There,
    /// "thus": what comes after it follows from what was said.
    So,
    /// Changes nothing.
    Neutral,
    /// A word that is not known here.
    Unknown,
}

/// Words by what they say; those that end with a hyphen may end in any way.
const WORDS: &[(Agreement, &[&str])] = &[
    (
        Agreement::Agree,
        &[
            "agree-",
            "coincid-",
            "share-",
            "the same",
            "same",
            "equal-",
            "common",
            "identical",
            "match-",
            "stimm-",
            "übereinstimm-",
            "denselben",
            "dieselbe-",
            "dasselbe",
            "demselben",
            "gleich-",
            "gemeinsam-",
            "fallen",
            "coïncid-",
            "même-",
            "égal-",
            "égaux",
            "commun-",
            "identique-",
            "相等",
            "相同",
            "一致",
            "重合",
            "difference vanishes",
            "differenz verschwindet",
            "différence s'annule",
        ],
    ),
    (Agreement::Touch, &["touch-", "berühr-", "相切"]),
    (
        Agreement::Join,
        &[
            "join-",
            "meet-",
            "treffen",
            "schließen",
            "raccord-",
            "连接",
            "拼接",
            "衔接",
            "setzen",
            "continuity",
            "连续",
        ],
    ),
    (
        Agreement::Value,
        &["value-", "position-", "wert", "werte", "werten", "funktionswert-", "valeur-", "函数值", "值"],
    ),
    (Agreement::Derivative, &["derivative-", "ableitung-", "dérivée-", "导数"]),
    (Agreement::Slope, &["slope-", "steigung-", "pente-", "斜率"]),
    (Agreement::Ordinal(1), &["first", "erste-", "premi-", "一阶"]),
    (Agreement::Ordinal(2), &["second", "zweite-", "deuxième-", "seconde-", "二阶"]),
    (Agreement::Ordinal(3), &["third", "dritte-", "troisième-", "三阶"]),
    (Agreement::Ordinal(4), &["fourth", "vierte-", "quatrième-", "四阶"]),
    (Agreement::Count(2), &["two", "twice", "beiden", "zweimal", "deux", "两"]),
    (Agreement::Count(3), &["three", "drei", "dreimal", "trois"]),
    (Agreement::Twice, &["times", "mal", "fois", "次"]),
    (
        Agreement::Smooth,
        &[
            "continuously differentiab-",
            "stetig differenzierbar-",
            "continûment dérivab-",
            "continûment différentiab-",
            "连续可微",
            "连续可导",
        ],
    ),
    (Agreement::Order, &["order", "ordnung", "ordre"]),
    (
        Agreement::UpTo,
        &["up to", "bis zur", "bis zum", "bis zu", "bis", "jusqu'à", "jusqu'au", "直到", "直至"],
    ),
    (
        Agreement::Including,
        &[
            "together with",
            "along with",
            "as well as",
            "including",
            "samt",
            "mitsamt",
            "einschließlich",
            "sowie",
            "ainsi que",
            "de même que",
            "连同",
            "以及",
        ],
    ),
    (Agreement::Start, &["start-", "begin-", "anfang-", "commenc-", "起点"]),
    (Agreement::End, &["end in", "end at", "enden", "finiss-", "终点"]),
    (Agreement::Ends, &["end points", "endpoints", "end-points", "endpunkt-", "extrémités", "端点"]),
    (
        Agreement::Not,
        &[
            "nothing", "not", "no", "unknown", "nichts", "nicht", "kein-", "rien", "pas", "aucun-", "不",
            "未", "没有",
        ],
    ),
    (
        Agreement::Place,
        &[
            "at",
            "at the",
            "knot",
            "breakpoint",
            "stelle",
            "punkt",
            "bei",
            "knoten",
            "nœud",
            "noeud",
            "en",
            "在",
            "节点",
            "点",
            "parameter",
            "paramètre",
            "place",
            "places",
            "in",
            "dans",
            "à",
            "au",
            "处的",
            "处",
        ],
    ),
    (Agreement::There, &["there", "these", "dort", "diesen", "y", "là", "该处", "此处", "ces"]),
    (
        Agreement::So,
        &[
            "so",
            "thus",
            "hence",
            "therefore",
            "consequently",
            "daher",
            "somit",
            "folglich",
            "deshalb",
            "donc",
            "ainsi",
            "因此",
            "所以",
            "于是",
            "从而",
        ],
    ),
    (
        Agreement::Neutral,
        &[
            "and",
            "or",
            "of",
            "the",
            "a",
            "an",
            "their",
            "whose",
            "which",
            "that",
            "both",
            "also",
            "have",
            "has",
            "be",
            "is",
            "are",
            "let",
            "given",
            "with",
            "such",
            "by",
            "take",
            "takes",
            "this",
            "point",
            "points",
            "they",
            "satisfy",
            "satisfies",
            "call",
            "write",
            "denote",
            "for",
            "on",
            "over",
            "all",
            "any",
            "number",
            "numbers",
            "real",
            "arbitrary",
            "then",
            "as",
            "we",
            "say",
            "namely",
            "arcs",
            "arc",
            "itself",
            "to",
            "it",
            "each",
            "other",
            "where",
            "und",
            "die",
            "der",
            "das",
            "den",
            "dem",
            "des",
            "ein",
            "eine",
            "zwei",
            "haben",
            "hat",
            "an",
            "am",
            "sich",
            "im",
            "sei",
            "seien",
            "ist",
            "sind",
            "deren",
            "ihre",
            "ihren",
            "ihrer",
            "mit",
            "nennen",
            "nenne",
            "wir",
            "heißen",
            "bezeichnen",
            "bezeichne",
            "dass",
            "überein",
            "zusammen",
            "auch",
            "beide",
            "also",
            "miteinander",
            "aneinander",
            "beliebig",
            "ebenfalls",
            "für",
            "alle",
            "et",
            "la",
            "le",
            "les",
            "l",
            "d",
            "de",
            "leur",
            "leurs",
            "ont",
            "soit",
            "soient",
            "que",
            "tels",
            "telles",
            "se",
            "un",
            "une",
            "note",
            "on",
            "pour",
            "tout",
            "avec",
            "sont",
            "chacun",
            "和",
            "与",
            "的",
            "及",
            "都",
            "且",
            "其",
            "它们",
            "设",
            "有",
            "在",
            "为",
            "是",
            "均",
            "分别",
            "记",
            "则",
            "对",
            "任意",
            "两",
            "个",
            "条",
            "段",
            "即",
            "满足",
            "具有",
            "并",
            "各",
            "阶",
            "所有",
        ],
    ),
];

/// The longest word at the start of a text in small letters, with its length in bytes.
fn longest(text: &str) -> Option<(usize, Agreement)> {
    let fits = |word: &str| {
        let (stem, open) = match word.strip_suffix('-') {
            Some(stem) => (stem, true),
            None => (word, false),
        };
        let rest = text.strip_prefix(stem)?;
        let spaced = stem.starts_with(is_letter);
        let more: usize = rest.chars().take_while(|c| is_letter(*c)).map(char::len_utf8).sum();
        match spaced && more > 0 {
            true => open.then_some(stem.len() + more),
            false => Some(stem.len()),
        }
    };
    static ALL: LazyLock<Starts<(Agreement, &str)>> = LazyLock::new(|| {
        let of = |(cue, words): &'static (Agreement, &[&str])| {
            words.iter().map(move |word| (*word, (*cue, *word)))
        };
        Starts::of(WORDS.iter().flat_map(of))
    });
    ALL.at(text).iter().filter_map(|(cue, word)| Some((fits(word)?, *cue))).max_by_key(|(length, _)| *length)
}

/// Whether words draw a conclusion: "and so".
pub fn concludes(words: &str) -> bool {
    cues(words).contains(&Some(Agreement::So))
}

/// What the words of a text say of functions that agree, one after the other; `None` is a comma.
pub fn cues(words: &str) -> Vec<Option<Agreement>> {
    let text = plain(words);
    let mut rest = text.as_str();
    let mut found = Vec::new();
    while let Some(c) = rest.chars().next() {
        let own = longest(rest);
        let known = word(rest).filter(|(length, _)| own.is_none_or(|(most, _)| *length > most));
        let length = if let Some((length, word)) = known {
            found.push(Some(match word {
                Word::Count(count) => Agreement::Count(u32::try_from(*count).unwrap_or_default()),
                _ => Agreement::Neutral,
            }));
            length
        } else if let Some((length, cue)) = own {
            found.push(Some(cue));
            length
        } else if c.is_alphanumeric() {
            found.push(Some(Agreement::Unknown));
            match is_letter(c) {
                true => rest.find(|c: char| !is_letter(c)).unwrap_or(rest.len()),
                false => c.len_utf8(),
            }
        } else {
            if matches!(c, ',' | '，' | ';' | '；' | '、') {
                found.push(None);
            }
            c.len_utf8()
        };
        rest = rest.piece(length..);
    }
    found
}
