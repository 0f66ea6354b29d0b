//! What the words around a formula make of it: a claim, a case, a hypothesis, something asked.
//!
//! **Definition.** A *cue* is a phrase right before or right after a formula; its *role* is what the
//! formula is said as. The cues are data, a file for each language. A formula without a cue has no
//! role: its form and what is known decide.

mod blocks;
mod chinese;
mod contact;
mod english;
mod french;
mod german;
mod hints;
mod quantities;
mod release;
mod rewriting;
mod starts;
#[cfg(test)]
mod tests;
mod tongue;
mod unreal;

pub use blocks::{
    Block, block, changes_data, ends_a_sentence, ends_with_a_change, ends_with_when, generalises,
    gives_example, goes_on_from_before, is_for_some_data, is_with_some_data, kind_of_block, number_of_block,
    opens_data, parity_before, recalled, replaces_data, replaces_next, says_exactly, sets_apart,
};
pub use contact::{Agreement, concludes, cues};
pub use hints::{Hint, hint};
pub use quantities::{ends_with_a_point, is_the_derivative, leads_to_a_point, speaks_of_the_centroid};
pub use release::{holds_for_any, is_arbitrary, releases, speaks_of_a_kind};
pub use rewriting::says_as;
pub use tongue::is_understood;
pub use unreal::{asks_what_is_true, calls_that_wrong, denies, joins, names_a_mistake};

use std::borrow::Cow;
use std::sync::LazyLock;

use self::starts::{Starts, without_accent};

use self::blocks::Recalls;
use crate::formula::source::Pieces;
use crate::judge::page::object::Sort;
use crate::judge::page::statement::Role;
use crate::judge::page::topic::{Topic, Topics};
use crate::language::lexicon::words;

/// What a phrase is in a sentence that says what names stand for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Word {
    /// What something can be.
    Noun(Sort),
    /// "cubic": of degree 3.
    OfDegree(i64),
    /// "degree".
    Degree,
    /// "of the second degree".
    HasDegree(i64),
    /// "which": what follows is no noun.
    Relative,
    /// "order", which is the degree and one.
    Order,
    /// 次: the number before it is a degree.
    DegreeAfter,
    /// 阶: the number before it is an order.
    OrderAfter,
    /// "of".
    Of,
    /// "der": an article, or "of the".
    Der,
    /// 的: what stands before it owns what comes after.
    Owns,
    /// "with".
    With,
    /// "on", "over", "for".
    On,
    /// "as".
    As,
    /// "is", "be", "denotes".
    Be,
    /// "its".
    Its,
    /// "with points": if a curve has them, they are its control points.
    WithPoints,
    /// "those": things of the kind that was named last.
    Those,
    /// "it": what was spoken of.
    It,
    /// "the": what is spoken of may be known.
    The,
    /// "the same", "this": what is spoken of is known.
    Same,
    /// "arguments": the number before it is how many a polar form takes.
    Arguments,
    /// "let".
    Let,
    /// "by": what follows is the name.
    By,
    /// "and".
    And,
    /// "uniform".
    Uniform,
    /// "two": after "degree" it is the degree.
    Count(i64),
    /// "natural": of a spline without curvature at its ends.
    Natural,
    /// "interpolates": the points after it are values of the function before it.
    Through,
    /// "rational": with weights.
    Rational,
    /// "weights", after "with".
    Weights,
    /// "from", "to": the formula after it is not what the sentence speaks of.
    Preposition,
    /// "multiplicity": how often the knots before it occur.
    Multiplicity,
    /// "end points": the first and the last control point.
    Ends,
    /// "segment", "piece".
    Piece,
    /// "support": the interval after it is where a B-spline is not 0.
    Support,
    /// "a": what follows says what a name is.
    Article,
    /// "coefficients": with respect to a basis.
    Coefficients,
    /// "symmetric".
    Symmetric,
    /// "biaffine": affine in each argument, of which there are so many.
    Affine(Option<i64>),
    /// Changes nothing.
    Filler,
}

impl Word {
    /// Whether it changes nothing of most things.
    pub fn is_filler(&self) -> bool {
        matches!(self, Word::Filler | Word::The | Word::Same | Word::Symmetric | Word::Affine(_))
    }
}

/// A phrase and what it makes of a formula.
#[derive(Clone, Copy)]
enum Cue {
    /// It stands before the formula.
    Before(&'static str, Role),
    /// It stands before the formula and orders: "find", but not "we square it and find".
    Command(&'static str, Role),
    /// It stands alone before the formula, at the start of a sentence that goes on to a claim.
    Opening(&'static str, Role),
    /// It stands after the formula.
    After(&'static str, Role),
}

/// "A prime": an integer of which nothing can be tried.
const PRIME: Sort = Sort::Other(Cow::Borrowed("prime"));

struct Language {
    cues: &'static [Cue],
    /// The words of conditions, which queries share.
    conditions: words::Conditions,
    /// Words that say 0.
    zero: &'static [&'static str],
    /// Who does something in a sentence: "we".
    subjects: &'static [&'static str],
    /// Words that ask for a proof.
    proofs: &'static [&'static str],
    /// Words with which a paragraph goes on from what the one before supposes.
    conclusions: &'static [&'static str],
    /// Words that may stand between a cue and its formula.
    fillers: &'static [&'static str],
    /// Labels of paragraphs.
    blocks: &'static [(&'static str, Block)],
    /// What stands before an example that a sentence goes back to.
    recalls: Recalls,
    /// What phrases are in a sentence that says what names stand for.
    words: &'static [(&'static str, Word)],
    /// How words begin that tell what a section is on.
    topics: &'static [(&'static str, Topic)],
    /// What a noun or an adjective may end with beside its form in the list.
    endings: &'static [&'static str],
    /// Whether blanks separate words.
    spaced: bool,
}

impl Language {
    /// All cues, with those that queries share.
    fn cues(&self) -> impl Iterator<Item = Cue> {
        let before = |words: &'static [&'static str], role: Role| {
            words.iter().map(move |word| Cue::Before(word, role))
        };
        self.cues
            .iter()
            .copied()
            .chain(before(self.conditions.cases, Role::Case))
            .chain(before(self.conditions.values, Role::Introduced))
            .chain(before(self.conditions.definitions, Role::Introduced))
    }
}

const LANGUAGES: &[Language] = &[
    Language {
        cues: english::CUES,
        conditions: words::ENGLISH,
        zero: english::ZERO,
        subjects: english::SUBJECTS,
        proofs: english::PROOFS,
        conclusions: english::CONCLUSIONS,
        fillers: english::FILLERS,
        blocks: english::BLOCKS,
        recalls: english::RECALLS,
        words: english::WORDS,
        topics: english::TOPICS,
        endings: &["s"],
        spaced: true,
    },
    Language {
        cues: german::CUES,
        conditions: words::GERMAN,
        zero: german::ZERO,
        subjects: german::SUBJECTS,
        proofs: german::PROOFS,
        conclusions: german::CONCLUSIONS,
        fillers: german::FILLERS,
        blocks: german::BLOCKS,
        recalls: german::RECALLS,
        words: german::WORDS,
        topics: german::TOPICS,
        endings: &["s", "es", "n", "en", "e", "er", "em", "ns"],
        spaced: true,
    },
    Language {
        cues: french::CUES,
        conditions: words::FRENCH,
        zero: french::ZERO,
        subjects: french::SUBJECTS,
        proofs: french::PROOFS,
        conclusions: french::CONCLUSIONS,
        fillers: french::FILLERS,
        blocks: french::BLOCKS,
        recalls: french::RECALLS,
        words: french::WORDS,
        topics: french::TOPICS,
        endings: &["s", "e", "es"],
        spaced: true,
    },
    Language {
        cues: chinese::CUES,
        conditions: words::CHINESE,
        zero: chinese::ZERO,
        subjects: chinese::SUBJECTS,
        proofs: chinese::PROOFS,
        conclusions: chinese::CONCLUSIONS,
        fillers: chinese::FILLERS,
        blocks: chinese::BLOCKS,
        recalls: chinese::RECALLS,
        words: chinese::WORDS,
        topics: chinese::TOPICS,
        endings: &[],
        spaced: false,
    },
];

/// The words around a formula, as far as its sentence goes.
#[derive(Clone, Debug, Default)]
pub struct Around {
    /// From the formula before in the sentence, or from the start of the sentence.
    pub left: String,
    /// To the next formula of the sentence, or to its end.
    pub right: String,
    /// Whether the formula is the first of its sentence.
    pub first: bool,
    /// Whether the sentence says what "we" do, up to the formula.
    pub ours: bool,
    /// Whether the sentence asks for a proof.
    pub proves: bool,
    /// Whether the sentence speaks of a mistake, up to the formula.
    pub mistaken: bool,
    /// Whether the sentence is a question.
    pub asks: bool,
}

/// Small letters, single blanks, no marks of emphasis.
pub fn plain(words: &str) -> String {
    let clean: String = words
        .chars()
        .map(|c| match c {
            '*' | '_' | '#' | '>' | '~' | '`' | '\\' => ' ',
            '’' => '\'',
            '–' | '‑' => '-',
            c => c,
        })
        .collect();
    clean.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Plain words without punctuation at the ends.
fn normal(words: &str) -> String {
    let ends = |c: char| {
        c.is_whitespace() || matches!(c, ',' | ':' | ';' | '(' | ')' | '，' | '：' | '；' | '（' | '）')
    };
    plain(words).trim_matches(ends).to_owned()
}

/// Whether words have a noun for things of a sort.
pub fn speaks_of(words: &str, sort: &Sort) -> bool {
    let text = words.to_lowercase();
    let starts = text.char_indices().filter(|(at, _)| !text.piece(..*at).ends_with(char::is_alphabetic));
    let mut said = starts.filter_map(|(at, _)| word(text.piece(at..)));
    said.any(|(_, word)| matches!(word, Word::Noun(own) if own == sort))
}

/// The longest phrase at the start of a text in small letters, with its length in bytes.
pub fn word(text: &str) -> Option<(usize, &'static Word)> {
    static ALL: LazyLock<Starts<(&Language, &str, &Word)>> = LazyLock::new(|| {
        let of = |language: &'static Language| language.words.iter().map(move |entry| (language, entry));
        Starts::of(LANGUAGES.iter().flat_map(of).map(|(own, (phrase, word))| (*phrase, (own, *phrase, word))))
    });
    let mut best: Option<(usize, &'static Word)> = None;
    for (language, phrase, word) in ALL.at(text) {
        let longer = |length: &usize| best.is_none_or(|(most, _)| *length > most);
        if let Some(length) = written(text, phrase, word, language).filter(longer) {
            best = Some((length, word));
        }
    }
    best
}

/// How many bytes at the start of a text a phrase takes, with or without hyphens and accents, a noun or an adjective in
/// any of its forms: "B-Spline-Kurven", "des Bernsteinpolynoms".
fn written(text: &str, phrase: &str, word: &Word, language: &Language) -> Option<usize> {
    if !language.spaced {
        return text.starts_with(phrase).then_some(phrase.len());
    }
    let joint = |c: char| matches!(c, '-' | ' ');
    let mut rest = text;
    let mut letters = phrase.chars().peekable();
    while let Some(letter) = letters.peek() {
        match rest.chars().next() {
            Some(c) if without_accent(c) == without_accent(*letter) || joint(c) && joint(*letter) => {
                rest = rest.piece(c.len_utf8()..);
                letters.next();
            }
            Some('-') if rest.len() < text.len() => rest = rest.piece(1..),
            _ if *letter == '-' => {
                letters.next();
            }
            _ => return None,
        }
    }
    let inflected =
        matches!(word, Word::Noun(_) | Word::OfDegree(_) | Word::Uniform | Word::Rational | Word::Weights);
    let endings = if inflected { language.endings } else { &[] };
    let ends = |ending: &&&str| {
        rest.strip_prefix(**ending).is_some_and(|after| !after.starts_with(char::is_alphanumeric))
    };
    let ending = [""].iter().chain(endings).find(ends)?;
    Some(text.len() - rest.len() + ending.len())
}

/// Whether a word goes on with a character: Chinese has no blanks around the words of other languages.
fn is_letter(c: char) -> bool {
    c.is_alphanumeric() && !('\u{2e80}'..='\u{ffef}').contains(&c)
}

/// Adds what words speak of.
///
/// Cost: linear in the words, times the number of topics.
pub fn topics(words: &str, found: &mut Topics) {
    let text = plain(words);
    for language in LANGUAGES {
        for (phrase, topic) in language.topics {
            if !found.has(*topic) && mentions(&text, phrase, false, language) {
                found.add(*topic);
            }
        }
        for (phrase, word) in language.words {
            if let Word::OfDegree(degree) = word
                && mentions(&text, phrase, true, language)
            {
                found.add_degree(*degree);
            }
            if let Word::Noun(sort) = word
                && let Some(topic) = topic_of(sort)
                // De Boor points are those of a spline.
                && let topic = if phrase.contains("boor") { Topic::Spline } else { topic }
                && !found.has(topic)
                && mentions(&text, phrase, true, language)
            {
                found.add(topic);
            }
        }
    }
}

/// The topic of a section that speaks of such an object.
fn topic_of(sort: &Sort) -> Option<Topic> {
    Some(match sort {
        Sort::ControlPoints => Topic::ControlPoints,
        Sort::PolarForm => Topic::PolarForm,
        Sort::Bernstein => Topic::Bernstein,
        Sort::BezierCurve => Topic::BezierCurve,
        Sort::BSpline | Sort::SplineCurve => Topic::Spline,
        _ => return None,
    })
}

/// Whether words begin to say what stands in the formula before them.
pub fn explains(words: &str) -> bool {
    let text = plain(words);
    let text = text.trim_start_matches([',', ' ', '，']);
    let words = LANGUAGES.iter().map(|language| &language.conditions);
    let mut words = words.flat_map(|conditions| conditions.values.iter().chain(conditions.cases.first()));
    words.any(|word| text.starts_with(word))
}

/// Which of two parts, the left or the right one, words speak of last.
pub fn last_side(words: &str) -> Option<Topic> {
    let text = plain(words);
    let sides = LANGUAGES.iter().flat_map(|language| language.topics);
    let found = sides.filter(|(_, topic)| matches!(topic, Topic::First | Topic::Second));
    found
        .filter_map(|(phrase, topic)| Some((text.rfind(phrase)?, *topic)))
        .max_by_key(|(at, _)| *at)
        .map(|(_, topic)| topic)
}

/// The words after the last occurrence of a phrase, if only fillers follow it.
fn ends_with(words: &str, phrase: &str, language: &Language) -> bool {
    let mut rest = words;
    loop {
        if let Some(before) = rest.strip_suffix(phrase)
            && (!language.spaced || before.is_empty() || !before.ends_with(char::is_alphanumeric))
        {
            return true;
        }
        let Some(filler) = language.fillers.iter().find(|filler| {
            rest.strip_suffix(**filler)
                .is_some_and(|before| !language.spaced || before.is_empty() || before.ends_with(' '))
        }) else {
            return false;
        };
        rest = rest.piece(..rest.len() - filler.len()).trim_end_matches([' ', ',']);
    }
}

fn starts_with(words: &str, phrase: &str, language: &Language) -> bool {
    words
        .strip_prefix(phrase)
        .is_some_and(|after| !language.spaced || !after.starts_with(char::is_alphanumeric))
}

/// The role that the words around a formula give it. `claims` says whether the sentence goes on to a
/// formula that is claimed.
///
/// Cost: linear in the words, times the number of cues.
pub fn role(around: &Around, claims: bool) -> Option<Role> {
    let (left, right) = (normal(&around.left), normal(&around.right));
    // "Solving, we find": the formula is not what is solved.
    let apart = around.left.trim_end().ends_with([',', '，']);
    let mut best: Option<(usize, Role)> = None;
    for language in LANGUAGES {
        for cue in language.cues() {
            let found = match &cue {
                Cue::Before(_, Role::Asked | Role::Sought) | Cue::Command(..) if apart => None,
                // "Show the equation …": it is claimed.
                Cue::Before(phrase, Role::Sought) if around.proves => {
                    ends_with(&left, phrase, language).then_some((phrase, &Role::Claimed))
                }
                Cue::Command(phrase, _) if around.ours && !left.ends_with(&format!("to {phrase}")) => {
                    ends_with(&left, phrase, language).then_some((phrase, &Role::Claimed))
                }
                Cue::Command(phrase, role) => ends_with(&left, phrase, language).then_some((phrase, role)),
                Cue::Before(phrase, role) => ends_with(&left, phrase, language).then_some((phrase, role)),
                Cue::Opening(phrase, role) => {
                    (claims && around.first && left == *phrase).then_some((phrase, role))
                }
                Cue::After(phrase, role) => starts_with(&right, phrase, language).then_some((phrase, role)),
            };
            if let Some((phrase, role)) = found {
                // The longer phrase says more, and what opens a sentence more than its last word.
                let opening = matches!(cue, Cue::Opening(..) | Cue::After(..));
                let weight = phrase.chars().count() + if opening { 100 } else { 0 };
                if best.is_none_or(|(most, _)| weight > most) {
                    best = Some((weight, *role));
                }
            }
        }
    }
    let role = best.map(|(_, role)| role);
    let asserted = matches!(role, None | Some(Role::Claimed | Role::Always | Role::Introduced));
    if asserted && (around.mistaken || unreal::is_unreal(&around.left, &around.right)) {
        Some(Role::Asked)
    } else {
        role
    }
}

/// Whether the first words of a sentence are those of a case, with nothing set apart: "For uniform knots of distance".
pub fn opens_case(words: &str) -> bool {
    let text = normal(words);
    let case = |cue: &Cue, language: &Language| matches!(cue, Cue::Before(phrase, Role::Case) if starts_with(&text, phrase, language));
    let open = !words.contains([',', '，', ':', '：']);
    open && LANGUAGES.iter().any(|language| language.cues().any(|cue| case(&cue, language)))
}

/// Whether words say nothing but "on": the interval after them belongs to what stands before them.
///
/// True for "and on": then it belongs to what comes after.
pub fn says_on(words: &str) -> Option<bool> {
    let text = normal(words);
    let on = |text: &str| {
        let begins = word(text).filter(|(_, word)| **word == Word::On);
        begins.is_some_and(|(length, _)| length == text.len() || is_interval_noun(text.piece(length..)))
            || WITHIN.iter().any(|within| text.strip_prefix(within).is_some_and(is_interval_noun))
    };
    // "and on", "hence on the interval"
    let joined = || {
        text.match_indices(' ').map(|(at, _)| (text.piece(..at), text.piece(at + 1..))).find_map(
            |(before, last)| {
                let claims = || {
                    let left = before.rsplit([',', '，']).next().unwrap_or_default().to_owned();
                    role(&Around { left, ..Around::default() }, false) == Some(Role::Claimed)
                };
                (on(last) && (goes_on(before) == Some(false) || claims())).then_some(true)
            },
        )
    };
    if on(&text) { Some(false) } else { joined() }
}

/// Whether words between a variable and an interval say that the one lies in the other: "lies in the knot interval".
pub fn says_in(words: &str) -> bool {
    let text = normal(words);
    LIES.iter()
        .any(|lies| text.strip_prefix(lies).is_some_and(|rest| rest.is_empty() || is_interval_noun(rest)))
}

/// Nouns for intervals.
const INTERVALS: &[&str] = &[
    "interval",
    "subinterval",
    "segment",
    "span",
    "intervall",
    "teilintervall",
    "knotenintervall",
    "parameterintervall",
    "intervalle",
    "sous-intervalle",
    "segment",
    "区间",
    "段",
    "子区间",
];

/// Words before such a noun.
const WITHIN: &[&str] =
    &["in", "on", "over", "inside", "within", "auf", "im", "in", "über", "sur", "dans", "在"];

/// Words that say where a variable lies.
const LIES: &[&str] = &[
    "in",
    "is in",
    "lies in",
    "lie in",
    "belongs to",
    "lying in",
    "liegt in",
    "liegt im",
    "im",
    "in dem",
    "aus",
    "dans",
    "est dans",
    "appartient à",
    "属于",
    "在",
    "位于",
    "落在",
];

/// At most two words and a noun for an interval: "the middle knot interval".
fn is_interval_noun(words: &str) -> bool {
    let words = words.trim_end_matches(['上', '内', '中', '里']);
    let text = words.trim_start();
    let begins = text.len() < words.len()
        || text.starts_with(|c: char| ('\u{2e80}'..='\u{ffef}').contains(&c))
        || words.starts_with('\'');
    let last = INTERVALS.iter().any(|noun| text.ends_with(noun));
    begins && last && text.split(' ').count() <= 4 && text.chars().count() < 40
}

/// Whether words say that something is 0 in all other cases: ", and zero elsewhere".
pub fn zero_elsewhere(words: &str) -> bool {
    let text = plain(words);
    LANGUAGES.iter().any(|language| {
        let elsewhere = |cue: &Cue| match cue {
            Cue::Before(phrase, Role::Elsewhere) | Cue::After(phrase, Role::Elsewhere) => {
                mentions(&text, phrase, true, language)
            }
            _ => false,
        };
        has_one_of(&text, language.zero, language) && language.cues.iter().any(elsewhere)
    })
}

/// Whether words say what "we" do.
pub fn ours(words: &str) -> bool {
    let text = plain(words);
    text.split(' ').any(|word| LANGUAGES.iter().any(|language| language.subjects.contains(&word)))
}

/// Whether a question asks for a reason.
pub fn asks_why(words: &str) -> bool {
    let text = plain(words);
    ["why", "warum", "weshalb", "pourquoi", "为什么", "为何"].iter().any(|why| text.contains(why))
}

/// Whether words ask for a proof.
pub fn proves(words: &str) -> bool {
    let text = plain(words);
    LANGUAGES.iter().any(|language| has_one_of(&text, language.proofs, language))
}

fn has_one_of(text: &str, phrases: &[&str], language: &Language) -> bool {
    phrases.iter().any(|phrase| mentions(text, phrase, true, language))
}

/// Whether a phrase stands in a text in small letters, as `whole` words or as how words begin.
fn mentions(text: &str, phrase: &str, whole: bool, language: &Language) -> bool {
    text.match_indices(phrase).any(|(at, _)| {
        let (before, after) = (text.piece(..at), text.piece(at + phrase.len()..));
        let begins = !before.ends_with(is_letter);
        let ends = !whole || !after.starts_with(is_letter);
        !language.spaced || begins && ends
    })
}

/// Whether the words only go on from the formula before: "and", "or", a comma. True for an alternative.
pub fn goes_on(words: &str) -> Option<bool> {
    match normal(words).as_str() {
        "" | "and" | "and also" | "as well as" | "und" | "und auch" | "sowie" | "et" | "et aussi"
        | "ainsi que" | "和" | "且" | "、" | "及" | "以及" | "并且" => Some(false),
        "or" | "oder" | "ou" | "或" => Some(true),
        _ => None,
    }
}
