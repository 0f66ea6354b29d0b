//! Whether the words of a page are in a language that is understood here.

/// Small words that most sentences of English, German and French have, and those of Spanish, Italian or Portuguese lack.
const SMALL: &[&str] = &[
    "the", "of", "and", "is", "are", "we", "that", "this", "with", "for", "by", "be", "which", "it", "on",
    "at", "from", "then", "have", "has", "let", "its", "where", "if", "der", "die", "das", "und", "ist",
    "sind", "wir", "ein", "eine", "mit", "für", "von", "den", "dem", "des", "auf", "im", "zu", "als",
    "nicht", "wird", "sei", "gilt", "les", "et", "est", "du", "dans", "pour", "une", "par", "sur", "nous",
    "qui", "où", "soit", "sont", "aux", "cette", "alors", "donc", "avec",
];

/// How words begin that put other data in the place of those before, in Spanish, Italian and Portuguese, of which nothing
/// else is understood.
pub(super) const CHANGED: &[&str] = &[
    "sustitu",
    "sustitú",
    "reemplaz",
    "cambi",
    "ahora",
    "en lugar",
    "en vez",
    "intercambi",
    "otro ejemplo",
    "segundo ejemplo",
    "esta vez",
    "sostitu",
    "rimpiazz",
    "invece",
    "adesso",
    "al posto",
    "scambi",
    "altro esempio",
    "secondo esempio",
    "questa volta",
    "substitu",
    "trocar",
    "troque",
    "trocam",
    "agora",
    "em vez",
    "outro exemplo",
    "segundo exemplo",
    "desta vez",
];

/// Fewer words show nothing.
const LEAST: usize = 12;

/// Whether words are in a language whose words are known here: one in eight of its small words, or Chinese.
///
/// Cost: linear in the words.
pub fn is_understood(text: &str) -> bool {
    let text = text.to_lowercase();
    let words: Vec<&str> =
        text.split(|c: char| !c.is_alphabetic()).filter(|word| word.chars().nth(1).is_some()).collect();
    let other = |c: char| ('\u{3040}'..='\u{30ff}').contains(&c) || ('\u{ac00}'..='\u{d7a3}').contains(&c);
    let chinese = |word: &&&str| word.contains(|c: char| ('\u{4e00}'..='\u{9fff}').contains(&c));
    let written = words.iter().filter(chinese).count();
    if 2 * written > words.len() && !text.contains(other) {
        return true;
    }
    let small = words.iter().filter(|word| SMALL.contains(word)).count();
    words.len() < LEAST || 8 * small >= words.len()
}
