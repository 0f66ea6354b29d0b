//! Letters that have a name or a sign of their own: Greek ones and those of blackboards.
//!
//! **Definition.** A Greek letter has one name, that of its LaTeX command, and one sign, the Unicode
//! character that LaTeX prints for it: `\epsilon` is ϵ, `\varepsilon` is ε.
//!
//! **Reference.** Unicode mathematics symbols and their LaTeX commands, as in the package unicode-math.

/// Greek letters: name and sign. Capitals that look like Latin ones have no name.
pub const GREEK: [(&str, &str); 43] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ϵ"),
    ("varepsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("vartheta", "ϑ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("varkappa", "ϰ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("omicron", "ο"),
    ("pi", "π"),
    ("varpi", "ϖ"),
    ("rho", "ρ"),
    ("varrho", "ϱ"),
    ("sigma", "σ"),
    ("varsigma", "ς"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "ϕ"),
    ("varphi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("ell", "ℓ"),
];

/// The name of a letter by its sign, also by signs that look the same.
///
/// ```
/// use polarform::language::lexicon::letters::{name, sign};
/// assert_eq!(name('σ'), Some("sigma"));
/// assert_eq!(name('s'), None);
/// assert_eq!(sign("sigma"), Some("σ"));
/// assert_eq!(sign("sum"), None);
/// ```
pub fn name(letter: char) -> Option<&'static str> {
    let letter = match letter {
        'Ͱ'..='Ͽ' | 'ℓ' => letter,
        'µ' => 'μ',        // micro sign
        '∆' => 'Δ',        // increment
        '\u{2126}' => 'Ω', // ohm
        _ => return None,
    };
    GREEK.iter().find(|(_, sign)| sign.chars().eq([letter])).map(|(name, _)| *name)
}

/// The sign of a letter by its name; the inverse of [`name`].
pub fn sign(name: &str) -> Option<&'static str> {
    GREEK.iter().find(|(greek, _)| *greek == name).map(|(_, sign)| *sign)
}

/// Whether a name is one letter: a single character of an alphabet, or the name of a Greek letter.
///
/// ```
/// use polarform::language::lexicon::letters::is_one_letter;
/// assert!(is_one_letter("t") && is_one_letter("varrho") && is_one_letter("é"));
/// assert!(!is_one_letter("sin") && !is_one_letter("1"));
/// ```
pub fn is_one_letter(name: &str) -> bool {
    let mut letters = name.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) => letter.is_alphabetic(),
        _ => sign(name).is_some(),
    }
}

const LATIN: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// Blackboard letters that stand outside of their block, and what is left free for them there.
const OUTSIDE: [(char, char); 7] =
    [('C', 'ℂ'), ('H', 'ℍ'), ('N', 'ℕ'), ('P', 'ℙ'), ('Q', 'ℚ'), ('R', 'ℝ'), ('Z', 'ℤ')];

/// The Latin letter of a blackboard letter: ℝ is R.
///
/// ```
/// use polarform::language::lexicon::letters::{blackboard, of_blackboard};
/// assert_eq!(of_blackboard('ℝ'), Some("R"));
/// assert_eq!(of_blackboard('𝕋'), Some("T"));
/// assert_eq!(blackboard("T"), Some('𝕋'));
/// ```
pub fn of_blackboard(sign: char) -> Option<&'static str> {
    if sign.is_ascii() {
        return None;
    }
    let at = LATIN.chars().position(|letter| double_struck(letter) == Some(sign))?;
    LATIN.get(at..=at)
}

/// The blackboard letter of a capital Latin one; the inverse of [`of_blackboard`].
pub fn blackboard(letter: &str) -> Option<char> {
    let mut letters = letter.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) => double_struck(letter),
        _ => None,
    }
}

fn double_struck(letter: char) -> Option<char> {
    if !letter.is_ascii_uppercase() {
        return None;
    }
    match OUTSIDE.iter().find(|(latin, _)| *latin == letter) {
        Some((_, sign)) => Some(*sign),
        None => char::from_u32('𝔸' as u32 + (letter as u32 - 'A' as u32)),
    }
}

/// The plain letter of a mathematical one, and whether that is bold: 𝑡 is t, 𝒅 a bold d, 𝛼 is α. Double-struck ones
/// are those of [`of_blackboard`].
///
/// ```
/// use polarform::language::lexicon::letters::of_mathematical;
/// assert_eq!(of_mathematical('𝑡'), Some(('t', false)));
/// assert_eq!(of_mathematical('𝐁'), Some(('B', true)));
/// assert_eq!(of_mathematical('𝛼'), Some(('α', false)));
/// assert_eq!(of_mathematical('t'), None);
/// ```
pub fn of_mathematical(sign: char) -> Option<(char, bool)> {
    const LATIN_BLOCK: (u32, u32) = (0x1d400, 0x1d6a4);
    const GREEK_BLOCK: (u32, u32) = (0x1d6a8, 0x1d7cb);
    /// Letters of the block that stand elsewhere.
    const ELSEWHERE: [(char, char); 9] = [
        ('ℎ', 'h'),
        ('ℬ', 'B'),
        ('ℰ', 'E'),
        ('ℱ', 'F'),
        ('ℋ', 'H'),
        ('ℐ', 'I'),
        ('ℒ', 'L'),
        ('ℳ', 'M'),
        ('ℛ', 'R'),
    ];
    if let Some(&(_, plain)) = ELSEWHERE.iter().find(|(own, _)| *own == sign) {
        return Some((plain, false));
    }
    let code = sign as u32;
    if (LATIN_BLOCK.0..LATIN_BLOCK.1).contains(&code) {
        let (style, at) = ((code - LATIN_BLOCK.0) / 52, (code - LATIN_BLOCK.0) % 52);
        let first = if at < 26 { u32::from(b'A') } else { u32::from(b'a') - 26 };
        return Some((char::from_u32(first + at)?, matches!(style, 0 | 2 | 4 | 7 | 9 | 11)));
    }
    if (GREEK_BLOCK.0..GREEK_BLOCK.1).contains(&code) {
        let (style, at) = ((code - GREEK_BLOCK.0) / 58, (code - GREEK_BLOCK.0) % 58);
        let plain = match at {
            0..=24 if at != 17 => char::from_u32('Α' as u32 + at)?,
            26..=50 => char::from_u32('α' as u32 + at - 26)?,
            52 => 'ϵ',
            53 => 'ϑ',
            55 => 'ϕ',
            56 => 'ϱ',
            57 => 'ϖ',
            _ => return None,
        };
        return Some((plain, matches!(style, 0 | 2 | 3 | 4)));
    }
    None
}

/// The capital of a small letter, also by its name: F of f, Phi of phi.
pub(crate) fn capital(letter: &str) -> Option<String> {
    let first = letter.chars().next().filter(char::is_ascii_lowercase)?;
    Some(first.to_ascii_uppercase().to_string() + letter.get(1..)?)
}

/// A character of Chinese, Japanese or Korean.
pub fn is_ideograph(c: char) -> bool {
    matches!(c, '\u{3040}'..='\u{30ff}' | '\u{3400}'..='\u{9fff}' | '\u{ac00}'..='\u{d7af}' | '\u{f900}'..='\u{faff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_signs_are_inverse() {
        for (i, (greek, sign_)) in GREEK.iter().enumerate() {
            let letter = sign_.chars().next().unwrap();
            assert_eq!((name(letter), sign(greek)), (Some(*greek), Some(*sign_)));
            assert!(GREEK[..i].iter().all(|(other, its)| other != greek && its != sign_));
        }
        for at in 0..LATIN.len() {
            let letter = &LATIN[at..=at];
            assert_eq!(blackboard(letter).and_then(of_blackboard), Some(letter));
        }
        assert_eq!((of_blackboard('R'), blackboard("r"), blackboard("RR")), (None, None, None));
    }
}
