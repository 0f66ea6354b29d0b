//! The words of a paragraph, as far as they are attributes of a curve.

use super::super::super::sentence::Piece;
use super::super::super::speech::{self, Hint, Word};
use crate::formula::source::Pieces;
use crate::judge::page::object::Sort;

/// A word or a formula of a paragraph.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Sign {
    /// A curve, a polynomial, a spline.
    Curve(Sort),
    /// "cubic".
    OfDegree(i64),
    /// "degree".
    Degree,
    /// A number in words or digits.
    Number(i64),
    /// What lists may be of.
    Knots,
    Nodes,
    PolarForm,
    Hint(Hint),
    /// "at", "over".
    On,
    /// "its", "the same": what was spoken of.
    Its,
    /// A comma or "and".
    Join,
    /// "a".
    Article,
    Uniform,
    Support,
    /// A word that says nothing here.
    Filler,
    /// A word that is not known.
    Unknown,
    /// A noun that makes other things than curves and points of names.
    Strange,
    Formula(usize),
    /// The end of a sentence.
    End,
}

/// Where the sentence begins in which a sign stands.
pub(super) fn sentence_start(all: &[Sign], at: usize) -> usize {
    all[..at].iter().rposition(|sign| *sign == Sign::End).map_or(0, |end| end + 1)
}

/// Where it ends.
pub(super) fn sentence_end(all: &[Sign], at: usize) -> usize {
    all[at..].iter().position(|sign| *sign == Sign::End).map_or(all.len(), |end| at + end)
}

/// The signs of a sentence.
pub(super) fn signs(sentence: &[Piece], found: &mut Vec<Sign>) {
    for piece in sentence {
        match piece {
            Piece::Formula(number) => found.push(Sign::Formula(*number)),
            Piece::Words(words) => words_of(words, found),
        }
    }
    found.push(Sign::End);
}

fn words_of(words: &str, found: &mut Vec<Sign>) {
    let words = speech::plain(words);
    let mut rest = words.as_str();
    while let Some(c) = rest.chars().next() {
        let hint = speech::hint(rest);
        let word = speech::word(rest);
        let (length, sign) = match (hint, word) {
            (Some((length, hint)), word) if word.is_none_or(|(other, _)| other <= length) => {
                // "The second half": the noun is part of the hint
                if matches!(hint, Hint::First | Hint::Second) && rest.piece(..length).contains(' ') {
                    found.push(Sign::Hint(hint));
                    (length, Sign::Hint(Hint::Part))
                } else {
                    (length, Sign::Hint(hint))
                }
            }
            (_, Some((length, word))) => {
                let whole = ["integer", "entier", "ganzzahl", "整数"];
                let sign = sign_of(word);
                if sign == Sign::Knots && whole.iter().any(|whole| rest.piece(..length).contains(whole)) {
                    found.push(Sign::Hint(Hint::Integers));
                }
                // "In the Bernstein basis" names no functions.
                let basis = ["basis", "base", "基"].iter().any(|basis| rest.piece(..length).ends_with(basis));
                (length, if basis && sign == Sign::Strange { Sign::Filler } else { sign })
            }
            _ if matches!(c, ';' | '；') => (c.len_utf8(), Sign::End),
            _ if matches!(c, ',' | '，' | '、') => (c.len_utf8(), Sign::Join),
            _ if c.is_ascii_digit() => {
                let length = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
                (length, rest.piece(..length).parse().map_or(Sign::Unknown, Sign::Number))
            }
            _ if c.is_alphabetic() => {
                let spaced = !('\u{2e80}'..='\u{ffef}').contains(&c);
                let ends = |c: char| !c.is_alphanumeric() && !matches!(c, '-' | '\'');
                let length = if spaced { rest.find(ends).unwrap_or(rest.len()) } else { c.len_utf8() };
                (length.max(c.len_utf8()), Sign::Unknown)
            }
            _ => {
                rest = rest.piece(c.len_utf8()..);
                continue;
            }
        };
        found.push(sign);
        rest = rest.piece(length.max(1)..);
    }
}

fn sign_of(word: &Word) -> Sign {
    match word {
        Word::Noun(sort) => match sort {
            Sort::Polynomial | Sort::Function | Sort::BSpline | Sort::SplineCurve | Sort::BezierCurve => {
                Sign::Curve(sort.clone())
            }
            Sort::ControlPoints => Sign::Hint(Hint::Points),
            Sort::Knots => Sign::Knots,
            Sort::Nodes => Sign::Nodes,
            Sort::PolarForm => Sign::PolarForm,
            Sort::Symbols | Sort::Vectors => Sign::Filler,
            _ => Sign::Strange,
        },
        Word::WithPoints => Sign::Hint(Hint::Points),
        Word::OfDegree(degree) => Sign::OfDegree(*degree),
        Word::Degree | Word::DegreeAfter => Sign::Degree,
        Word::Count(count) => Sign::Number(*count),
        Word::On => Sign::On,
        Word::Its | Word::It | Word::Same | Word::Those => Sign::Its,
        Word::And => Sign::Join,
        Word::Article => Sign::Article,
        Word::Uniform => Sign::Uniform,
        Word::Support => Sign::Support,
        Word::Piece => Sign::Hint(Hint::Part),
        Word::Rational
        | Word::Weights
        | Word::Natural
        | Word::Multiplicity
        | Word::Order
        | Word::OrderAfter => Sign::Strange,
        Word::Through => Sign::Hint(Hint::Through),
        _ => Sign::Filler,
    }
}
