//! Labelled paragraphs and environments: examples, proofs, theorems; and words that go back to an example.

use super::LANGUAGES;
use crate::formula::source::Pieces;

/// What a labelled paragraph does to names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Block {
    /// An example, an exercise: what is said of names there ends with it.
    Closed,
    /// A proof or a solution: it goes on from the example or exercise before.
    Proof,
    /// A case: it is within a proof.
    Case,
    /// A theorem, a remark.
    Open,
    /// A definition: what is said of names there goes on.
    Definition,
}

impl Block {
    /// Whether a block of another kind that begins in it is a part of it.
    pub fn holds(self, other: Block) -> bool {
        matches!((self, other), (Block::Closed, Block::Proof | Block::Case) | (Block::Proof, Block::Case))
    }
}

/// What stands before an example that a sentence goes back to.
pub(super) struct Recalls {
    /// Before its number: "in" of "in Example 2".
    pub(super) named: &'static [&'static str],
    /// Before the last one: "in the" of "in the example".
    pub(super) last: &'static [&'static str],
    /// Before that, if the sentence only compares: "as" of "as in Example 2".
    pub(super) compared: &'static [&'static str],
    /// Words that make what follows an example, without a label.
    pub(super) running: &'static [&'static str],
    /// How a word begins that leads back from it to the general case, near the start of a sentence.
    pub(super) general: &'static [&'static str],
    /// How words begin that put other data in the place of those before.
    pub(super) changed: &'static [&'static str],
}

/// So many letters of a sentence may stand before the word that leads back to the general case.
const NEAR_START: usize = 30;

/// Whether what follows these words is an example within a text: "for example", in their last sentence.
pub fn gives_example(words: &str) -> bool {
    let text = words.to_lowercase();
    let last = text.rsplit(['.', '。', '!', '?', '！', '？']).next().unwrap_or_default();
    LANGUAGES.iter().flat_map(|language| language.recalls.running).any(|cue| last.contains(cue))
}

/// Whether words put other data in the place of those before: "if now b_1 is replaced by …", "with t = 1 instead";
/// on a page in a language that is not understood, also those of others: "substituirmos" is there what "replace" is here, while
/// "substituting" changes nothing.
pub fn changes_data(words: &str, foreign: bool) -> bool {
    let text = words.to_lowercase();
    let begins =
        |cue: &str| text.match_indices(cue).any(|(at, _)| !text.piece(..at).ends_with(char::is_alphanumeric));
    // "We replace each monomial by its polar form": no data.
    if NO_DATA.iter().any(|noun| text.contains(noun)) {
        return false;
    }
    LANGUAGES.iter().any(|language| {
        let mut cues = language.recalls.changed.iter();
        cues.any(|cue| if language.spaced { begins(cue) } else { text.contains(cue) })
    }) || foreign && super::tongue::CHANGED.iter().any(|cue| begins(cue))
}

/// What formulas are made of, and no data: who replaces these changes none.
const NO_DATA: &[&str] =
    &["monomial", "monôme", "monom ", "monome", "单项式", "each power", "powers of", "jede potenz"];

/// How words begin after which something certainly stands in the place of something else.
const REPLACED: &[&str] = &[
    "replac",
    "instead",
    "exchang",
    "swap",
    "moved",
    "move ",
    "we move",
    "altered",
    "modif",
    "ersetz",
    "stattdessen",
    "verschieb",
    "verschob",
    "vertausch",
    "tauscht",
    "remplac",
    "au lieu",
    "déplac",
    "échang",
    "换成",
    "改为",
    "改成",
    "替换",
];

/// Words between what is replaced and the word that says so: "b_1 is replaced".
const PASSIVE: &[&str] =
    &["is", "are", "was", "were", "be", "now", "wird", "werden", "nun", "est", "sont", "被"];

/// So many words may stand between the word that replaces and what it replaces.
const NEAR: usize = 2;

/// Whether words certainly put something else in the place of the formula before them, "b_1 is replaced by", or of the
/// one after them, "replacing".
pub fn replaces_data(words: &str) -> [bool; 2] {
    let text = words.to_lowercase();
    let count = |part: &str| part.split_whitespace().count();
    let mut found = [false; 2];
    for cue in REPLACED {
        for (at, _) in text.match_indices(cue) {
            let before = text.piece(..at);
            if cue.is_ascii() && before.ends_with(char::is_alphanumeric) {
                continue;
            }
            let word = text.piece(at..).find(char::is_whitespace).map_or(text.len(), |end| at + end);
            let after = text.piece(word..);
            let apart = |part: &str| part.contains(['.', ',', ';', ':', '。', '，', '；']);
            // "1 instead of 2" puts the 1 there.
            let of = after.trim_start().starts_with("of") || cue.starts_with("au lieu");
            found[0] |= before.split_whitespace().all(|word| PASSIVE.contains(&word)) && !of;
            let alone = matches!(*cue, "instead" | "stattdessen") || cue.starts_with("au lieu");
            found[1] |= count(after) <= NEAR && !apart(text.piece(at..)) && !alone;
        }
    }
    found
}

/// Whether what is changed by these words is the formula after them: "we replace".
pub fn replaces_next(words: &str) -> bool {
    let text = words.to_lowercase();
    let last = text.rsplit(['.', '。', '!', '?', '！', '？', ',', '，', ';', ':']).next().unwrap_or_default();
    changes_data(last, false) && last.split_whitespace().count() <= 4
}

/// Words before a name that make it an odd or an even number, and nouns that may stand between.
const ODD: &[&str] = &["odd", "ungerade", "ungerades", "ungeraden", "奇数"];
const EVEN: &[&str] = &["even", "gerade", "gerades", "geraden", "偶数"];
const NUMBERS: &[&str] = &["integer", "integers", "number", "numbers", "degree", "zahl", "zahlen"];

/// Whether the words before a name say that it is odd, "for odd", or even.
pub fn parity_before(words: &str) -> Option<bool> {
    let text = words.to_lowercase();
    let last = text.split_whitespace().rev().find(|word| !NUMBERS.contains(word))?;
    let is =
        |list: &[&str]| list.iter().any(|word| last == *word || !word.is_ascii() && last.ends_with(word));
    if is(ODD) { Some(true) } else { is(EVEN).then_some(false) }
}

/// Whether words begin "exactly then", which a later "when" ends: "genau dann …, wenn".
pub fn says_exactly(words: &str) -> bool {
    let text = words.to_lowercase();
    text.contains("genau dann") || text.contains("dann und nur dann")
}

/// Whether words end with the "when" of that.
pub fn ends_with_when(words: &str) -> bool {
    words.to_lowercase().trim_end().ends_with("wenn")
}

/// Whether the last word is one that puts something else in the place of what follows: "and replace".
pub fn ends_with_a_change(words: &str) -> bool {
    words.split_whitespace().next_back().is_some_and(|word| changes_data(word, false))
}

/// Whether a sentence ends within these words or right before them.
pub fn ends_a_sentence(words: &str) -> bool {
    words.trim_start().starts_with(char::is_uppercase)
        || words.contains(['。', '！', '？', '!', '?'])
        || words.contains(". ")
        || words.contains(".\n")
}

/// Whether the words before a formula begin their sentence with a case of some data: "For integer knots".
pub fn is_for_some_data(words: &str) -> bool {
    let text = words.to_lowercase();
    let last = text.rsplit(['.', '。', '!', '?', '！', '？']).next().unwrap_or_default().trim();
    // One word and at most three more: the case itself, "for t = 1/2", is a condition of its sentence anyway.
    let more = last.split_whitespace().count();
    LANGUAGES.iter().any(|language| {
        let begins = |cue: &str| match language.spaced {
            true => last.split_whitespace().next() == Some(cue) && (2..=4).contains(&more),
            false => last.starts_with(cue) && last.chars().count() <= 8 && last != cue,
        };
        let example = last.ends_with("example") || last.ends_with("instance");
        language.conditions.cases.iter().any(|cue| begins(cue)) && !last.contains([',', '，']) && !example
    })
}

/// Words with which a clause begins that gives data of its own.
const WITH: &[&str] = &[
    "with", "for", "take", "using", "mit", "für", "bei", "avec", "pour", "prenons", "取", "对", "对于", "若",
    "当",
];

/// How the last clause of some words begins, and how many words it has.
fn last_clause(words: &str) -> Option<(String, usize)> {
    let text = words.to_lowercase();
    let clause = text.rsplit(['.', ';', ':', '。', '；', '：', '!', '?']).next()?.trim();
    let clause = clause.trim_start_matches(['*', '_', ' ']);
    Some((clause.split_whitespace().next()?.to_owned(), clause.split_whitespace().count()))
}

/// Whether the words before a list begin their clause with data of its own: "With the ordinates".
pub fn is_with_some_data(words: &str) -> bool {
    last_clause(words).is_some_and(|(first, count)| {
        let written = |cue: &str| cue.chars().all(|c| c > '\u{2e7f}');
        let chinese = |cue: &&str| written(cue) && first.starts_with(*cue) && first.chars().count() <= 8;
        WITH.contains(&first.as_str()) && count <= 4 || WITH.iter().any(chinese)
    })
}

/// Whether the words before a formula are only "for": "For f(x) = e^x we have".
pub fn opens_data(words: &str) -> bool {
    last_clause(words).is_some_and(|(first, count)| count == 1 && WITH.contains(&first.as_str()))
}

/// Whether a sentence that begins in these words leads back from an example to the general case: "in general".
pub fn generalises(words: &str, begins: bool) -> bool {
    let text = words.to_lowercase();
    let mut sentences = text.split(['.', '。', '!', '?', '！', '？']);
    let first = sentences.next().filter(|_| begins);
    first.into_iter().chain(sentences).any(|sentence| {
        let start: String = sentence.trim_start().chars().take(NEAR_START).collect();
        let spaced = |cue: &str| {
            start.match_indices(cue).any(|(at, _)| !start.piece(..at).ends_with(char::is_alphanumeric))
        };
        LANGUAGES.iter().any(|language| {
            language
                .recalls
                .general
                .iter()
                .any(|cue| if language.spaced { spaced(cue) } else { start.contains(cue) })
        })
    })
}

/// What the paragraph that begins with these words is, if it bears a label: bold, italic, or a word with
/// a number, a point or a colon.
pub fn block(words: &str) -> Option<Block> {
    let text = words.trim_start_matches([' ', '\n', '\t', '•', '·', '●', '◦']);
    let marked = text.starts_with(['*', '_', '【', '[']);
    let text = text.trim_start_matches(['*', '_', '【', '[', ' ']);
    let label: String = text.chars().take_while(|c| c.is_alphabetic()).collect();
    let capital = label.chars().next().is_some_and(|c| !c.is_lowercase());
    let rest = text.piece(label.len()..).trim_start();
    let closed = rest.starts_with(['.', ':', '*', '_', '(', '：', '】', ']', '。', '（'])
        || rest.starts_with(|c: char| c.is_ascii_digit())
        || rest.is_empty();
    let (low, spaced) = (label.to_lowercase(), label.is_ascii());
    for language in LANGUAGES {
        for (name, block) in language.blocks {
            let same = if language.spaced { low == *name } else { low == *name && (marked || !spaced) };
            if same && (marked || capital && closed) {
                return Some(*block);
            }
        }
    }
    let foreign = FOREIGN.iter().find(|(name, _)| *name == low);
    if let Some((_, block)) = foreign.filter(|_| marked || capital && closed) {
        return Some(*block);
    }
    // "**Worked example.**", "*Numerisches Beispiel:*"
    let titled = ["**", "__", "*", "_"].into_iter().find_map(|mark| run_in_title(words, mark));
    let example = |word: &str| {
        let mut names = LANGUAGES.iter().flat_map(|language| language.blocks);
        names.any(|(name, block)| *block == Block::Closed && *name == word)
    };
    if let Some((title, Some(_))) = titled
        && title.split_whitespace().count() <= LONGEST_LABEL
        && title.to_lowercase().split(|c: char| !c.is_alphabetic()).any(example)
    {
        return Some(Block::Closed);
    }
    is_run_in_heading(words).then_some(Block::Open)
}

/// Labels of paragraphs in Spanish, Italian and Portuguese.
const FOREIGN: &[(&str, Block)] = &[
    ("ejemplo", Block::Closed),
    ("ejercicio", Block::Closed),
    ("solución", Block::Proof),
    ("demostración", Block::Proof),
    ("teorema", Block::Open),
    ("definición", Block::Definition),
    ("esempio", Block::Closed),
    ("esercizio", Block::Closed),
    ("soluzione", Block::Proof),
    ("dimostrazione", Block::Proof),
    ("definizione", Block::Definition),
    ("exemplo", Block::Closed),
    ("exercício", Block::Closed),
    ("solução", Block::Proof),
    ("demonstração", Block::Proof),
    ("definição", Block::Definition),
];

/// So many words are a label.
const LONGEST_LABEL: usize = 4;

/// Whether a paragraph begins with a heading of its own: "**Degree elevation.**", but not "**Step 1.**", "**Given:**".
fn is_run_in_heading(words: &str) -> bool {
    let Some((title, closed)) = run_in_title(words, "**") else { return false };
    closed == Some('.')
        && title.chars().filter(|c| c.is_alphabetic()).count() > 3
        && !title.contains(|c: char| c.is_ascii_digit())
}

/// Whether a paragraph begins with a title of its own that sets it apart from those beside it: "*Uniform knots.*",
/// "**Second choice:**", or with a mark of a part, "(b)".
pub fn sets_apart(words: &str) -> bool {
    if is_part(words) {
        return true;
    }
    let titled = ["**", "__", "*", "_"].into_iter().find_map(|mark| run_in_title(words, mark));
    titled.is_some_and(|(title, closed)| closed.is_some() && title.chars().any(char::is_alphabetic))
}

/// Whether words begin with "(b)", "ii)", "(3)".
fn is_part(words: &str) -> bool {
    let text = words.trim_start().trim_start_matches(['*', '_']);
    let text = text.strip_prefix('(').unwrap_or(text);
    let Some((mark, after)) = text.split_once(')') else { return false };
    let after = after.trim_start_matches(['*', '_']);
    let roman = mark.chars().all(|c| matches!(c, 'i' | 'v' | 'x'));
    let letter = mark.chars().count() == 1 && mark.starts_with(char::is_alphanumeric);
    let number = mark.len() < 3 && mark.chars().all(|c| c.is_ascii_digit());
    !mark.is_empty() && (roman || letter || number) && after.starts_with(char::is_whitespace)
}

/// The emphasised words at the start of a paragraph, and the point or colon that closes them.
fn run_in_title<'a>(words: &'a str, mark: &str) -> Option<(&'a str, Option<char>)> {
    let text = words.trim_start().strip_prefix(mark)?;
    let end = text.find(mark)?;
    let (title, after) = (text.piece(..end), text.piece(end + mark.len()..));
    let sign = |c: char| match c {
        '.' | '。' => Some('.'),
        ':' | '：' => Some(':'),
        _ => None,
    };
    let closed = title.chars().next_back().and_then(sign).or_else(|| after.chars().next().and_then(sign));
    Some((title, closed))
}

/// What an environment is that bears a name of a labelled paragraph.
pub fn kind_of_block(name: &str) -> Option<Block> {
    let name = name.trim().trim_end_matches(['*', '.', ':']).to_lowercase();
    let mut blocks = LANGUAGES.iter().flat_map(|language| language.blocks);
    blocks.find(|(known, _)| *known == name).map(|(_, block)| *block).or(match name.as_str() {
        "ex" | "exm" | "eg" | "expl" | "exo" | "bsp" | "exampleblock" => Some(Block::Closed),
        "pf" | "sol" | "bew" => Some(Block::Proof),
        _ => None,
    })
}

/// The number of a labelled paragraph: 2 of "**Example 2.**".
pub fn number_of_block(words: &str) -> Option<String> {
    let label = words.trim_start().trim_start_matches(['*', '_', '【', '[', ' ']);
    let rest = label.trim_start_matches(char::is_alphabetic).trim_start_matches([' ', '~', '\u{a0}']);
    name_at(rest)
}

/// A number such as 2 or 3.1, or the label of a reference.
fn name_at(text: &str) -> Option<String> {
    if let Some(label) = [r"\ref{", r"\cref{", r"\autoref{"].iter().find_map(|sign| text.strip_prefix(sign)) {
        return Some(label.piece(..label.find('}')?).trim().to_owned());
    }
    let number: String = text.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    let number = number.trim_end_matches('.');
    (!number.is_empty()).then(|| number.to_owned())
}

/// The name of the example that words go back to, empty if it is the last one: "In Example 2 …", "for the example above".
/// "As in Example 2" compares.
pub fn recalled(words: &str) -> Option<String> {
    let text = words.to_lowercase();
    let text = text.replace(['~', '\u{a0}', '\n'], " ");
    LANGUAGES.iter().find_map(|language| {
        let examples = language.blocks.iter().filter(|(_, block)| *block == Block::Closed);
        examples
            .flat_map(|(name, _)| text.match_indices(name).map(|(at, name)| (at, at + name.len())))
            .find_map(|(at, end)| {
                let before = text.piece(..at).trim_end_matches([' ', '\'', '’']);
                let after = text.piece(end..).trim_start();
                let name = name_at(after);
                let cue = |cue: &str| {
                    before.strip_suffix(cue).is_some_and(|rest| {
                        let apart = !language.spaced || !rest.ends_with(char::is_alphanumeric);
                        let compared =
                            language.recalls.compared.iter().any(|word| rest.trim_end().ends_with(word));
                        apart && !compared
                    })
                };
                // 例 1 中
                let within = || {
                    let rest =
                        after.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').trim_start();
                    !language.spaced && rest.starts_with(['中', '的'])
                };
                match name {
                    Some(name) => {
                        let cues = || language.recalls.named.iter().chain(language.recalls.last);
                        (cues().any(|word| cue(word)) || within()).then_some(name)
                    }
                    None => {
                        let whole = !language.spaced
                            || !after.starts_with(char::is_alphanumeric)
                            || text.piece(end..).starts_with(' ');
                        (whole && language.recalls.last.iter().any(|word| cue(word))).then(String::new)
                    }
                }
            })
    })
}

/// Whether a paragraph begins with a word that draws a conclusion from the one before: "Then", "Hence".
pub fn goes_on_from_before(words: &str) -> bool {
    let text = super::plain(words);
    let text = text.trim_start();
    LANGUAGES.iter().any(|language| {
        language.conclusions.iter().any(|word| {
            text.strip_prefix(word)
                .is_some_and(|rest| !language.spaced || !rest.starts_with(char::is_alphanumeric))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels() {
        assert_eq!(block("**Example.** Let"), Some(Block::Closed));
        assert_eq!(block("Proof. We"), Some(Block::Proof));
        assert_eq!(block("Theorem 3. Let"), Some(Block::Open));
        assert_eq!(block("例 2 设"), Some(Block::Closed));
        assert_eq!(block("Case 1: "), Some(Block::Case));
        assert_eq!(block("Examples of this kind abound"), None);
        assert_eq!(block("The proof is easy."), None);
    }

    #[test]
    fn words_that_go_back_to_an_example() {
        for (words, wanted) in [
            ("In Example 2 we have", Some("2")),
            (r"Dans l'exemple~\ref{un},", Some("un")),
            (r"Im Beispiel~\ref{a:b} ist", Some("a:b")),
            ("In the example,", Some("")),
            ("im Beispiel", Some("")),
            ("在例 1 中", Some("1")),
            ("例 1 中三个控制点为", Some("1")),
            ("对上例，", Some("")),
            ("上例中", Some("")),
            ("For the above example,", Some("")),
            ("Im obigen Beispiel ist", Some("")),
            ("As in Example 2,", None),
            ("For example,", None),
            ("zum Beispiel", None),
            ("par exemple", None),
            ("例如", None),
        ] {
            assert_eq!(recalled(words).as_deref(), wanted, "{words}");
        }
        assert_eq!(number_of_block("**Example 3.1.** Let").as_deref(), Some("3.1"));
        assert_eq!(number_of_block("**例 2（双曲线）。**").as_deref(), Some("2"));
        assert_eq!(kind_of_block("Beispiel"), Some(Block::Closed));
    }

    #[test]
    fn examples_without_a_label() {
        for words in ["Let us take for example", "Zahlenbeispiel: Zu", "Par exemple, si", "It is so. 例如取"]
        {
            assert!(gives_example(words), "{words}");
        }
        assert!(!gives_example("For example, it is so. Then"));
        for (words, begins) in [
            ("The general statement follows", true),
            (". Allgemein hat man", false),
            ("。现在回到一般的", false),
            (". For arbitrary", false),
        ] {
            assert!(generalises(words, begins), "{words}");
        }
        assert!(!generalises("is not a point of the curve in general", false));
    }

    #[test]
    fn headings_within_a_paragraph() {
        assert_eq!(block("**Degree elevation.** The same"), Some(Block::Open));
        assert_eq!(block("**Step 1.** We"), None);
        assert_eq!(block("**Given:** the"), None);
    }
}
