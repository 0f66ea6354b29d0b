//! Unicode characters that stand for commands: `α`, `≤`, `∑`, `₁`, `²`.

use super::commands::Role;
use super::token::{Fence, Tok};
use crate::formula::{Accent, BigOp, Rel};
use crate::language::lexicon::{letters, relations};

/// What a character outside ASCII is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Character {
    Token(Tok),
    Prime(u32),
    /// A raised (true) or lowered (false) character.
    Raised(bool),
}

/// The meaning of a character, if it has one.
pub(super) fn character(c: char) -> Option<Character> {
    if let Some(symbol) = letters::name(c) {
        return Some(Character::Token(Tok::Symbol(symbol)));
    }
    if let Some((upper, _)) = raised(c) {
        return Some(Character::Raised(upper));
    }
    let kind = match c {
        '’' | '′' | '´' => return Some(Character::Prime(1)),
        '″' => return Some(Character::Prime(2)),
        '‴' => return Some(Character::Prime(3)),
        '−' | '–' | '－' => Tok::Minus,
        '＋' => Tok::Plus,
        '·' | '⋅' | '∙' => Tok::Dot,
        '∗' => Tok::Star,
        '×' => Tok::Cross,
        '∘' => Tok::Circ,
        '∪' => Tok::Binary("cup"),
        '∩' => Tok::Binary("cap"),
        '∖' => Tok::Binary("setminus"),
        '⊗' => Tok::Binary("otimes"),
        '⊕' => Tok::Binary("oplus"),
        '±' => Tok::Binary("pm"),
        '∓' => Tok::Binary("mp"),
        '∧' => Tok::Binary("wedge"),
        '，' | '、' => Tok::Comma,
        '；' => Tok::Semicolon,
        '。' | '．' => Tok::Period,
        '：' => Tok::Rel(Rel::Colon),
        '（' => Tok::Open(Fence::Paren),
        '）' => Tok::Close(Fence::Paren),
        '⌊' => Tok::Open(Fence::Floor),
        '⌋' => Tok::Close(Fence::Floor),
        '⌈' => Tok::Open(Fence::Ceil),
        '⌉' => Tok::Close(Fence::Ceil),
        '⟨' => Tok::Open(Fence::Angle),
        '⟩' => Tok::Close(Fence::Angle),
        '‖' | '∥' => Tok::DoubleBar,
        '∣' | '｜' => Tok::Bar,
        '…' | '⋯' | '⋮' | '⋱' => Tok::Ellipsis,
        '＝' => Tok::Rel(Rel::Eq),
        '≠' => Tok::Rel(Rel::Ne),
        '≤' | '⩽' | '≦' => Tok::Rel(Rel::Le),
        '≥' | '⩾' | '≧' => Tok::Rel(Rel::Ge),
        '≡' => Tok::Rel(Rel::Equiv),
        '≈' => Tok::Rel(Rel::Approx),
        '∈' => Tok::Rel(Rel::In),
        '∉' => Tok::Rel(Rel::NotIn),
        '⊂' | '⊆' => Tok::Rel(Rel::Subset),
        '≔' | '≜' => Tok::Rel(Rel::Define),
        '→' | '⟶' => Tok::Rel(Rel::To),
        '↦' | '⟼' => Tok::Rel(Rel::MapsTo),
        '⇒' | '⟹' => Tok::Rel(Rel::Implies),
        '⇔' | '⟺' => Tok::Rel(Rel::Iff),
        '∞' => Tok::Symbol("infty"),
        '∂' => Tok::Symbol("partial"),
        '∇' => Tok::Symbol("nabla"),
        '∅' => Tok::Symbol("emptyset"),
        '△' => Tok::Symbol("Delta"),
        '⊤' => Tok::Symbol("top"),
        '∑' => Tok::Command(Role::Big(BigOp::Sum)),
        '∏' => Tok::Command(Role::Big(BigOp::Product)),
        '⋃' => Tok::Command(Role::Big(BigOp::Union)),
        '⋂' => Tok::Command(Role::Big(BigOp::Intersection)),
        '∫' => Tok::Command(Role::Integral),
        '∀' => Tok::Command(Role::ForAll),
        '√' => Tok::Command(Role::Root),
        '\u{200b}' | '\u{2061}' | '\u{2062}' | '\u{feff}' => Tok::Skip,
        _ => match (letters::of_blackboard(c), letters::of_mathematical(c)) {
            (Some(symbol), _) => Tok::Symbol(symbol),
            (None, Some((plain, _))) if plain.is_ascii() => Tok::Letter(plain),
            (None, Some((plain, _))) => Tok::Symbol(letters::name(plain)?),
            (None, None) => Tok::Rel(Rel::Other(relations::of(c)?.sign)),
        },
    };
    Some(Character::Token(kind))
}

/// The accent of letters that have one in Unicode.
pub(super) fn accent(c: char) -> Option<Accent> {
    match letters::of_blackboard(c) {
        Some(_) => Some(Accent::Blackboard),
        None => letters::of_mathematical(c).filter(|(_, bold)| *bold).map(|_| Accent::Bold),
    }
}

/// Whether a character belongs to words of a language, not to formulas.
pub(super) fn is_word(c: char) -> bool {
    !c.is_ascii() && c.is_alphabetic() && character(c).is_none()
        || matches!(c, '“' | '”' | '《' | '》' | '「' | '」')
}

/// Whether the text begins with one letter in braces.
pub(super) fn is_letter_in_braces(text: &str) -> bool {
    matches!(text.as_bytes(), [b'{', letter, b'}', ..] if letter.is_ascii_alphabetic())
}

/// The plain character that a raised (true) or lowered (false) one stands for.
pub(super) fn raised(c: char) -> Option<(bool, char)> {
    const UPPER: &str = "⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9⁺+⁻-⁽(⁾)ⁿnⁱiʲjᵏkᵐmʳrˢsᵗtᵈd";
    const LOWER: &str = "₀0₁1₂2₃3₄4₅5₆6₇7₈8₉9₊+₋-₍(₎)ₐaₑeₒoₓxₕhₖkₗlₘmₙnₚpₛsₜtᵢiⱼjᵣrᵤuᵥv";
    let find = |table: &str| {
        let mut characters = table.chars();
        while let (Some(from), Some(to)) = (characters.next(), characters.next()) {
            if from == c {
                return Some(to);
            }
        }
        None
    };
    if c.is_ascii() {
        return None;
    }
    find(UPPER).map(|to| (true, to)).or_else(|| find(LOWER).map(|to| (false, to)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::latex::commands;

    #[test]
    fn characters_mean_what_commands_mean() {
        for command in commands() {
            let mut meaning = command.meaning().chars();
            if let (Some(c), None, Role::Symbol(symbol)) = (meaning.next(), meaning.next(), command.role())
                && let Some(Character::Token(kind)) = character(c)
            {
                assert_eq!(kind, Tok::Symbol(symbol), "{c}");
            }
        }
    }

    #[test]
    fn raised_and_lowered() {
        assert_eq!(raised('²'), Some((true, '2')));
        assert_eq!(raised('₁'), Some((false, '1')));
        assert_eq!(raised('ᵢ'), Some((false, 'i')));
        assert_eq!(raised('2'), None);
        assert!(is_word('次') && is_word('é') && !is_word('α') && !is_word('x'));
    }
}
