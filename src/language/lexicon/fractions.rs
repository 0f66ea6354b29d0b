//! Numbers in words: one third, drei Viertel, 三分之一, four; and words for a formula: the unit interval, the x axis.

use super::letters::is_ideograph;
use super::phrases;

/// Words, and the digits or the formula in their place.
const FRACTIONS: &[(&str, &str)] = &[
    ("one half", "1/2"),
    ("a half", "1/2"),
    ("one third", "1/3"),
    ("a third", "1/3"),
    ("two thirds", "2/3"),
    ("one quarter", "1/4"),
    ("a quarter", "1/4"),
    ("three quarters", "3/4"),
    ("one fourth", "1/4"),
    ("three fourths", "3/4"),
    ("one fifth", "1/5"),
    ("ein halb", "1/2"),
    ("einhalb", "1/2"),
    ("ein drittel", "1/3"),
    ("einem drittel", "1/3"),
    ("zwei drittel", "2/3"),
    ("ein viertel", "1/4"),
    ("einem viertel", "1/4"),
    ("drei viertel", "3/4"),
    ("dreiviertel", "3/4"),
    ("un demi", "1/2"),
    ("un tiers", "1/3"),
    ("deux tiers", "2/3"),
    ("un quart", "1/4"),
    ("trois quarts", "3/4"),
    ("un medio", "1/2"),
    ("un tercio", "1/3"),
    ("dos tercios", "2/3"),
    ("un cuarto", "1/4"),
    ("tres cuartos", "3/4"),
    ("un mezzo", "1/2"),
    ("un terzo", "1/3"),
    ("due terzi", "2/3"),
    ("un quarto", "1/4"),
    ("tre quarti", "3/4"),
    ("unit interval", "[0, 1]"),
    ("einheitsintervall", "[0, 1]"),
    ("intervalle unité", "[0, 1]"),
    ("intervalo unidad", "[0, 1]"),
    ("intervalo unitario", "[0, 1]"),
    ("intervallo unitario", "[0, 1]"),
    ("单位区间", "[0, 1]"),
    ("x axis", "y = 0"),
    ("x-axis", "y = 0"),
    ("y axis", "x = 0"),
    ("y-axis", "x = 0"),
    ("x-achse", "y = 0"),
    ("y-achse", "x = 0"),
    ("l'axe des x", "y = 0"),
    ("l'axe des y", "x = 0"),
    ("eje x", "y = 0"),
    ("eje y", "x = 0"),
    ("二分之一", "1/2"),
    ("三分之一", "1/3"),
    ("三分之二", "2/3"),
    ("四分之一", "1/4"),
    ("四分之三", "3/4"),
];

/// The words behind a fraction that make it a part of something else: one half of the curve, a third root.
const OF: &[&str] =
    &["of", "von", "der", "des", "de", "du", "root", "derivative", "degree", "order", "knot", "point"];

/// A text with digits and blanks for its fractions in words, so that all places stay the same; `None` if it has none.
pub(crate) fn with_digits(text: &str) -> Option<String> {
    let lower = text.to_lowercase();
    // Some letters are longer in small.
    if lower.len() != text.len() {
        return None;
    }
    let mut found: Option<Vec<u8>> = None;
    for (words, digits) in FRACTIONS {
        for (at, _) in lower.match_indices(words) {
            let ideographs = words.starts_with(is_ideograph);
            let before = lower.get(..at).and_then(|text| text.chars().next_back());
            let rest = lower.get(at + words.len()..).unwrap_or_default();
            let apart =
                !before.is_some_and(char::is_alphanumeric) && !rest.starts_with(char::is_alphanumeric);
            let next: String = rest.trim_start().chars().take_while(|c| c.is_alphabetic()).collect();
            if !(apart || ideographs) || OF.contains(&next.as_str()) {
                continue;
            }
            let bytes = found.get_or_insert_with(|| text.as_bytes().to_vec());
            if let Some(place) = bytes.get_mut(at..at + words.len()) {
                place.fill(b' ');
                place.iter_mut().zip(digits.bytes()).for_each(|(place, digit)| *place = digit);
            }
        }
    }
    found.and_then(|bytes| String::from_utf8(bytes).ok())
}

/// Numbers from 2 on in the languages that set blanks. One is also an article and a pronoun.
const COUNTS: &[[&str; 5]] = &[
    ["two", "zwei", "deux", "dos", "due"],
    ["three", "drei", "trois", "tres", "tre"],
    ["four", "vier", "quatre", "cuatro", "quattro"],
    ["five", "fünf", "cinq", "cinco", "cinque"],
    ["six", "sechs", "six", "seis", "sei"],
    ["seven", "sieben", "sept", "siete", "sette"],
    ["eight", "acht", "huit", "ocho", "otto"],
    ["nine", "neun", "neuf", "nueve", "nove"],
];

/// The same for whole numbers in words; a word of a phrase, such as "first two", stays.
pub(crate) fn with_counts(text: &str, function: &dyn Fn(&str) -> Option<&'static str>) -> Option<String> {
    let mut found: Option<Vec<u8>> = None;
    let mut at = 0;
    let mut before = ' ';
    while let Some(c) = text.get(at..).and_then(|rest| rest.chars().next()) {
        let length: usize = match c.is_alphabetic() && !is_ideograph(c) && !before.is_alphanumeric() {
            true => match phrases::phrase(text.get(at..)?, function) {
                Some((_, length)) => length,
                None => {
                    let word = text.get(at..)?.chars().take_while(|c| c.is_alphabetic());
                    word.map(char::len_utf8).sum()
                }
            },
            false => c.len_utf8(),
        };
        let word = text.get(at..at + length)?.to_lowercase();
        if let Some(count) = COUNTS.iter().position(|words| words.contains(&word.as_str())) {
            let place = found.get_or_insert_with(|| text.as_bytes().to_vec()).get_mut(at..at + length)?;
            place.fill(b' ');
            *place.first_mut()? = b'2' + u8::try_from(count).ok()?;
        }
        before = text.get(..at + length)?.chars().next_back()?;
        at += length;
    }
    found.and_then(|bytes| String::from_utf8(bytes).ok())
}

#[cfg(test)]
mod tests {
    use super::{with_counts, with_digits};

    #[test]
    fn counts_are_digits() {
        assert_eq!(with_counts("elevate by two", &|_| None).as_deref(), Some("elevate by 2  "));
        assert_eq!(with_counts("um drei Grade", &|_| None).as_deref(), Some("um 3    Grade"));
        assert_eq!(with_counts("the first two points", &|_| None), None);
        assert_eq!(with_counts("the four point scheme", &|_| None), None);
    }

    #[test]
    fn fractions_are_digits() {
        assert_eq!(with_digits("at one third").as_deref(), Some("at 1/3      "));
        assert_eq!(with_digits("一半在三分之一处").map(|text| text.contains("1/3")), Some(true));
        assert_eq!(with_digits("a third root"), None);
        assert_eq!(with_digits("at 1/3"), None);
    }
}
