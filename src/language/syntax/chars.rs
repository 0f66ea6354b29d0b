//! Unicode characters and what they stand for.

use crate::formula::Accent;
use crate::language::lexicon::letters;

const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
const SUBSCRIPTS_PLAIN: &str = "0123456789+-=()aehijklmnoprstuvx";
const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻᵀ";
const SUPERSCRIPTS_PLAIN: &str = "0123456789+-=()abcdefghijklmnoprstuvwxyzT";

fn translate(c: char, from: &str, to: &str) -> Option<char> {
    // The blocks that hold all of them: most other characters are found out at once.
    if !matches!(c, '²'..='¹' | 'ʰ'..='˿' | 'ᴬ'..='ᶿ' | '⁰'..='₟' | 'ⱼ' | 'ⱽ') {
        return None;
    }
    from.chars().zip(to.chars()).find(|&(f, _)| f == c).map(|(_, t)| t)
}

/// The ordinary form of a lowered character: ₁ to 1.
pub(super) fn subscript(c: char) -> Option<char> {
    translate(c, SUBSCRIPTS, SUBSCRIPTS_PLAIN)
}

/// The ordinary form of a raised character: ² to 2.
pub(super) fn superscript(c: char) -> Option<char> {
    translate(c, SUPERSCRIPTS, SUPERSCRIPTS_PLAIN)
}

/// The ordinary form of a raised, lowered or full-width character, or the character itself.
pub(super) fn ordinary(c: char) -> char {
    if c.is_ascii() {
        return c;
    }
    match c {
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(c as u32 - 0xfee0).unwrap_or(c),
        _ => subscript(c).or_else(|| superscript(c)).unwrap_or(c),
    }
}

/// The accent a combining character puts on the character before it.
pub(super) fn accent(c: char) -> Option<Accent> {
    Some(match c {
        '\u{302}' => Accent::Hat,
        '\u{303}' => Accent::Tilde,
        '\u{304}' | '\u{305}' => Accent::Bar,
        '\u{307}' => Accent::Dot,
        '\u{308}' => Accent::Ddot,
        '\u{20d7}' => Accent::Vec,
        _ => return None,
    })
}

/// Signs between groups of three digits, as in Switzerland: 1'000'000.
pub(super) const APOSTROPHES: [char; 2] = ['\'', '’'];

/// Numerator and denominator of a fraction in one character: ½.
pub(super) fn fraction(c: char) -> Option<[i64; 2]> {
    Some(match c {
        '½' => [1, 2],
        '⅓' => [1, 3],
        '⅔' => [2, 3],
        '¼' => [1, 4],
        '¾' => [3, 4],
        '⅕' => [1, 5],
        '⅖' => [2, 5],
        '⅗' => [3, 5],
        '⅘' => [4, 5],
        '⅙' => [1, 6],
        '⅚' => [5, 6],
        '⅐' => [1, 7],
        '⅛' => [1, 8],
        '⅜' => [3, 8],
        '⅝' => [5, 8],
        '⅞' => [7, 8],
        '⅑' => [1, 9],
        '⅒' => [1, 10],
        _ => return None,
    })
}

/// The sign of a square root before a number or formula without brackets.
pub(super) const ROOT: char = '√';

/// How many primes a character stands for.
pub(super) fn primes(c: char) -> Option<u32> {
    match c {
        '\'' | '’' | '‘' | '′' => Some(1),
        '″' | '”' => Some(2),
        '‴' => Some(3),
        _ => None,
    }
}

/// Whether the character takes part in words; Greek and blackboard letters stand for themselves.
pub(super) fn is_letter(c: char) -> bool {
    if c.is_ascii() {
        return c.is_ascii_alphabetic();
    }
    ordinary(c).is_alphabetic()
        && letters::name(c).is_none()
        && letters::of_blackboard(c).is_none()
        && subscript(c).is_none()
        && superscript(c).is_none()
}

/// Blanks, also invisible ones that come with pasted text.
pub(super) fn is_blank(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2060}'..='\u{2063}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_agree() {
        assert_eq!(SUBSCRIPTS.chars().count(), SUBSCRIPTS_PLAIN.len());
        assert_eq!(SUPERSCRIPTS.chars().count(), SUPERSCRIPTS_PLAIN.len());
        for (lowered, plain) in SUBSCRIPTS.chars().zip(SUBSCRIPTS_PLAIN.chars()) {
            assert_eq!(subscript(lowered), Some(plain));
        }
        for (raised, plain) in SUPERSCRIPTS.chars().zip(SUPERSCRIPTS_PLAIN.chars()) {
            assert_eq!(superscript(raised), Some(plain));
        }
        assert_eq!(ordinary('（'), '(');
        assert_eq!(ordinary('²'), '2');
    }
}
