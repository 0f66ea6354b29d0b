//! The plain notation with Unicode signs, for reading on a terminal: `t₁t₂ + 5/3 (t₁ + t₂)`.

use std::fmt;

use num_traits::Signed;

use super::boxes;
use super::names;
use super::plain::{self, Plain};
use super::shape;
use super::walk::{Joint, Notation, Pieces, Tail, to_string};
use crate::formula::{Accent, Expr, Kind, Precedence, Rel, Sign, Term};
use crate::language::lexicon::{letters, relations};

/// The formula with Unicode signs, indices and exponents. A matrix, or an equation with one as a
/// side, takes several lines; anything else one line, which the plain reader reads back.
///
/// Cost: linear in the size of the tree; for matrices, in that of the printed lines.
///
/// ```
/// use polarform::expr::Expr;
/// let tree = Expr::product(vec![Expr::name("sigma"), Expr::indexed("t", 12).power(Expr::int(2))]);
/// assert_eq!(polarform::write::unicode(&tree), "σ t₁₂²");
/// ```
pub fn unicode(expr: &Expr) -> String {
    boxes::layout(expr, one_line).unwrap_or_else(|| one_line(expr))
}

fn one_line(expr: &Expr) -> String {
    to_string(&Unicode, expr)
}

struct Unicode;

impl Plain for Unicode {
    const ARROW: &'static str = " ↦ ";
    const DOTS: &'static str = "…";
    const CENTRED_DOTS: &'static str = "⋯";
    const FLOOR: (&'static str, &'static str) = ("⌊", "⌋");
    const CEIL: (&'static str, &'static str) = ("⌈", "⌉");

    fn relation(rel: Rel) -> &'static str {
        relation(rel)
    }

    /// 2t, t₁t₂, t²s
    fn is_tight(factor: &Expr) -> bool {
        match &factor.kind {
            Kind::Number(value) => value.is_integer(),
            Kind::Subscript(..) | Kind::Pow(..) => true,
            _ => false,
        }
    }
}

/// A relation with the blanks around it.
pub(crate) fn relation(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => " = ",
        Rel::Define => " := ",
        Rel::Ne => " ≠ ",
        Rel::Lt => " < ",
        Rel::Le => " ≤ ",
        Rel::Gt => " > ",
        Rel::Ge => " ≥ ",
        Rel::Equiv => " ≡ ",
        Rel::Approx => " ≈ ",
        Rel::In => " ∈ ",
        Rel::NotIn => " ∉ ",
        Rel::Subset => " ⊆ ",
        Rel::To => " → ",
        Rel::MapsTo => " ↦ ",
        Rel::Implies => " ⇒ ",
        Rel::Iff => " ⇔ ",
        Rel::Colon => ": ",
        Rel::Other(sign) => relations::of(sign).map_or(" ", |sign| sign.unicode),
    }
}

impl Notation for Unicode {
    type Error = fmt::Error;

    fn level(&self, expr: &Expr) -> Precedence {
        match &expr.kind {
            // A run of raised characters takes no further ones.
            Kind::Upper(..) | Kind::Transpose(_) => Precedence::Power,
            _ => plain::level(expr),
        }
    }

    fn between(&self, joint: Joint, before: &Tail, next: &str) -> &'static str {
        let mut letters = next.chars();
        let (first, second) = (letters.next(), letters.next());
        let Joint::Times { hint: tight, .. } = joint else {
            return if before.last == Some('.') && first == Some('.') { " " } else { "" };
        };
        match (before.last, first) {
            (_, Some('0'..='9' | '{')) => "·",
            // f[x₀, x₁] is a divided difference
            (Some(last), Some('[')) if last.is_alphabetic() => "",
            // 2e is the beginning of a power of ten
            (Some(last), Some(c))
                if tight
                    && (last.is_ascii_digit() || is_raised_or_lowered(last))
                    && c.is_alphabetic()
                    && !second.is_some_and(char::is_alphabetic)
                    && !matches!(c, 'e' | 'E') =>
            {
                ""
            }
            _ => " ",
        }
    }

    fn expand<'a>(&self, expr: &'a Expr, out: &mut Pieces<'a>) -> fmt::Result {
        match &expr.kind {
            Kind::Name(name) => out.str(names::sign(name).unwrap_or(name)),
            Kind::Subscript(base, indices) => match plain::without_brackets(indices) {
                [index] if can_take_index(base) => match run(index, lowered) {
                    Some(run) => {
                        out.node(base, Precedence::Postfix);
                        out.string(run);
                    }
                    None => plain::expand::<Self>(expr, out),
                },
                _ => plain::expand::<Self>(expr, out),
            },
            Kind::Upper(base, indices) => match indices.as_slice() {
                [index] if !matches!(base.kind, Kind::Number(_)) => match run(index, raised) {
                    Some(run) => {
                        out.node(base, Precedence::Postfix);
                        out.string(format!("⁽{run}⁾"));
                    }
                    None => plain::expand::<Self>(expr, out),
                },
                _ => plain::expand::<Self>(expr, out),
            },
            Kind::Pow(base, exponent) => {
                // Parentheses in an exponent would make it an upper index; raised, it needs none.
                let inner = match &exponent.kind {
                    Kind::Group(inner) => inner,
                    _ => exponent,
                };
                match run(inner, raised) {
                    Some(run) => {
                        out.node(base, Precedence::Postfix);
                        out.string(run);
                    }
                    None => plain::power(base, exponent, out),
                }
            }
            Kind::Transpose(body) => {
                out.node(body, Precedence::Postfix);
                out.str("ᵀ");
            }
            Kind::Prime(body, count) => {
                shape::primed(body, out);
                out.string("′".repeat(*count as usize));
            }
            Kind::Accent(accent, body) => match accented(*accent, body) {
                Some(letter) => out.string(letter),
                None => plain::expand::<Self>(expr, out),
            },
            _ => plain::expand::<Self>(expr, out),
        }
        Ok(())
    }
}

fn can_take_index(base: &Expr) -> bool {
    !matches!(base.kind, Kind::Subscript(..) | Kind::Number(_) | Kind::Ellipsis | Kind::Text(_))
}

const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
const LOWERED_PLAIN: &str = "0123456789+-aehijklmnoprstuvx";
const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻᵀ";
const RAISED_PLAIN: &str = "0123456789+-abcdefghijklmnoprstuvwxyzT";

fn lowered(c: char) -> Option<char> {
    LOWERED_PLAIN.chars().zip(LOWERED.chars()).find(|&(plain, _)| plain == c).map(|(_, low)| low)
}

fn raised(c: char) -> Option<char> {
    RAISED_PLAIN.chars().zip(RAISED.chars()).find(|&(plain, _)| plain == c).map(|(_, high)| high)
}

fn is_raised_or_lowered(c: char) -> bool {
    RAISED.contains(c) || LOWERED.contains(c) || c == '⁾'
}

/// At most this many terms of a sum are set as an index or exponent.
const MAX_TERMS: usize = 4;

/// A number, name, multiple of a name, or short sum of these as a run of raised or lowered
/// characters, if there are characters for it.
fn run(index: &Expr, translate: fn(char) -> Option<char>) -> Option<String> {
    let mut plain = String::new();
    match &index.kind {
        Kind::Add(terms) if terms.len() <= MAX_TERMS => {
            for (i, Term { sign, expr }) in terms.iter().enumerate() {
                match sign {
                    Sign::Minus => plain.push('-'),
                    Sign::Plus if i > 0 || terms.len() == 1 => plain.push('+'),
                    Sign::Plus => {}
                }
                term(expr, &mut plain)?;
            }
        }
        _ => term(index, &mut plain)?,
    }
    plain.chars().map(translate).collect()
}

fn term(expr: &Expr, plain: &mut String) -> Option<()> {
    match &expr.kind {
        Kind::Mul(factors) => match factors.as_slice() {
            [number @ Expr { kind: Kind::Number(_), .. }, name @ Expr { kind: Kind::Name(_), .. }] => {
                term(number, plain)?;
                let letters = plain.len();
                term(name, plain)?;
                // the name 01 would go on with the numeral
                (!plain[letters..].starts_with(|c: char| c.is_ascii_digit())).then_some(())
            }
            _ => None,
        },
        Kind::Number(value) if value.is_integer() && !value.is_negative() => {
            plain.push_str(&value.numer().to_string());
            Some(())
        }
        // Greek letters have no such characters, and spelt out they would be words
        Kind::Name(name) if !name.is_empty() && names::sign(name).is_none() => {
            plain.push_str(name);
            Some(())
        }
        _ => None,
    }
}

/// A single letter or digit with a combining accent, or a blackboard letter.
fn accented(accent: Accent, body: &Expr) -> Option<String> {
    let text = match &body.kind {
        Kind::Name(name) if accent == Accent::Blackboard => {
            return letters::blackboard(name).map(String::from);
        }
        Kind::Name(name) => names::sign(name).unwrap_or(name).to_owned(),
        Kind::Number(value) if value.is_integer() && !value.is_negative() => value.numer().to_string(),
        _ => return None,
    };
    let mark = match accent {
        Accent::Hat => '\u{302}',
        Accent::Tilde => '\u{303}',
        Accent::Bar => '\u{304}',
        Accent::Dot => '\u{307}',
        Accent::Ddot => '\u{308}',
        Accent::Vec => '\u{20d7}',
        Accent::Bold | Accent::Script | Accent::Blackboard => return None,
    };
    let mut letters = text.chars();
    let single = letters.next().is_some() && letters.next().is_none();
    single.then(|| format!("{text}{mark}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_agree() {
        assert_eq!(LOWERED.chars().count(), LOWERED_PLAIN.chars().count());
        assert_eq!(RAISED.chars().count(), RAISED_PLAIN.chars().count());
        assert_eq!((lowered('x'), raised('T'), raised('q')), (Some('ₓ'), Some('ᵀ'), None));
    }
}
