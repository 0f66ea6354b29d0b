//! The words of a sentence, as far as they matter for what names stand for.

use std::collections::BTreeMap;

use super::super::sentence::Piece;
use super::super::speech::{self, Word};
use crate::formula::source::Pieces;
use crate::formula::{Expr, Kind};
use crate::judge::page::object::Sort;

/// A part of a sentence, as far as it matters here.
#[derive(Clone, Debug)]
pub(super) enum Token {
    Word(Word),
    /// Words without a known meaning.
    Unknown(String),
    /// A number in words.
    Number(i64),
    /// A formula in the sentence.
    Formula(usize),
    Comma,
    /// A colon, a bracket, a dash.
    Stop,
}

pub(super) fn tokens(sentence: &[Piece]) -> Vec<Token> {
    let mut found = Vec::new();
    for piece in sentence {
        match piece {
            Piece::Formula(number) => found.push(Token::Formula(*number)),
            Piece::Words(words) => words_of(after_ordinal(words, &mut found), &mut found),
        }
    }
    without_asides(with_coefficients(found))
}

/// Coefficients in the Bernstein basis of a degree, wherever the sentence names the basis, are Bézier coefficients of that
/// degree; others are numbers.
fn with_coefficients(mut tokens: Vec<Token>) -> Vec<Token> {
    let basis = |token: &Token| matches!(token, Token::Word(Word::Noun(Sort::Bernstein)));
    let word = |token: &Token| matches!(token, Token::Word(Word::Coefficients));
    let (bases, all) =
        (tokens.iter().filter(|t| basis(t)).count(), tokens.iter().filter(|t| word(t)).count());
    let places = (tokens.iter().position(basis), tokens.iter().position(word));
    if let ((Some(basis), Some(at)), (1, 1)) = (places, (bases, all)) {
        let between = &tokens[basis.min(at) + 1..basis.max(at)];
        if !between.iter().any(|token| matches!(token, Token::Word(Word::Noun(_)))) {
            return in_basis(tokens, basis, at);
        }
    }
    for token in tokens.iter_mut().filter(|token| word(token)) {
        *token = Token::Word(Word::Noun(Sort::Symbols));
    }
    tokens
}

/// "The coefficients b_0, b_1, b_2 in the quadratic Bernstein basis": the quadratic Bézier coefficients b_0, b_1, b_2.
fn in_basis(mut tokens: Vec<Token>, basis: usize, at: usize) -> Vec<Token> {
    let degree = |token: &Token| match token {
        Token::Word(Word::OfDegree(degree)) => Some(*degree),
        _ => None,
    };
    let leads = |token: &Token| {
        is_filler(token)
            || matches!(token, Token::Unknown(_))
            || matches!(
                token,
                Token::Word(
                    Word::Article | Word::Der | Word::On | Word::Preposition | Word::OfDegree(_) | Word::By
                )
            )
    };
    let mut from = basis;
    while from > 0 && leads(&tokens[from - 1]) {
        from -= 1;
    }
    // … basis B_0^2, B_1^2, B_2^2
    let mut to = basis + 1;
    while matches!(tokens.get(to), Some(Token::Formula(_)))
        || to > basis + 1 && matches!(tokens[to - 1..].get(..2), Some([Token::Comma, Token::Formula(_)]))
    {
        to += 1;
    }
    let (own, number) = match tokens.get(to..) {
        Some([Token::Word(Word::Of), Token::Word(Word::Degree), Token::Number(degree), ..]) => {
            (3, Some(*degree))
        }
        Some([Token::Word(Word::Of), Token::Word(Word::Degree), Token::Formula(_), ..]) => (3, None),
        _ => (0, None),
    };
    let number = number.or_else(|| tokens[from..basis].iter().find_map(degree));
    // "of degree n" stays behind its noun.
    let size: Vec<Token> = if number.is_none() { tokens[to..to + own].to_vec() } else { Vec::new() };
    let adjective = number.map(|degree| Token::Word(Word::OfDegree(degree)));
    let noun = adjective.into_iter().chain([Token::Word(Word::Noun(Sort::ControlPoints))]).chain(size);
    let noun: Vec<Token> = noun.collect();
    let rest = from..to + own;
    match basis < at {
        true => {
            tokens.splice(at..=at, noun);
            tokens.drain(rest);
        }
        false => {
            tokens.drain(rest);
            tokens.splice(at..=at, noun);
        }
    }
    tokens
}

/// Whether a token changes nothing.
fn is_filler(token: &Token) -> bool {
    matches!(token, Token::Word(word) if word.is_filler())
}

/// F (over [0, 1]) and G (over [1, 2]): where they live is no part of the list.
fn without_asides(tokens: Vec<Token>) -> Vec<Token> {
    let mut found: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let aside = match tokens.get(at..at + 4) {
            Some(
                [Token::Stop, Token::Word(Word::On | Word::Preposition), Token::Formula(_), Token::Stop],
            ) => 4,
            _ => 0,
        };
        let after_formula = matches!(found.last(), Some(Token::Formula(_)));
        // 是 p 次（p ≥ 1）B 样条, of degree p (p ≥ 1)
        let after_degree = matches!(
            found.as_slice(),
            [.., Token::Word(Word::DegreeAfter)] | [.., Token::Word(Word::Degree), Token::Formula(_)]
        );
        if after_degree && let Some([Token::Stop, Token::Formula(_), Token::Stop]) = tokens.get(at..at + 3) {
            at += 3;
            continue;
        }
        // its (trivariate) blossom
        let inner = tokens[at + 1..].iter().take_while(|token| is_filler(token)).count();
        let closed = matches!(tokens.get(at + 1 + inner), Some(Token::Stop));
        // a pour points de contrôle, dans l'ordre, (0, 0), …
        let between = matches!(tokens[at], Token::Comma)
            && inner > 0
            && matches!(tokens.get(at + 1 + inner), Some(Token::Comma))
            && matches!(tokens.get(at + 2 + inner), Some(Token::Formula(_)));
        if between && matches!(found.last(), Some(Token::Word(Word::Noun(_) | Word::Be))) {
            at += inner + 2;
        } else if aside > 0 && after_formula {
            at += aside;
        } else if inner > 0 && closed && matches!(tokens[at], Token::Stop) {
            found.extend_from_slice(&tokens[at + 1..=at + inner]);
            at += inner + 2;
        } else {
            found.push(tokens[at].clone());
            at += 1;
        }
    }
    found
}

/// "The i-th polynomial": the formula is a part of an adjective; "an n-variate form": it counts its arguments. Gives
/// the words after it.
fn after_ordinal<'a>(words: &'a str, found: &mut Vec<Token>) -> &'a str {
    let suffix = words.strip_prefix('-').filter(|rest| rest.starts_with(char::is_alphabetic));
    let (Some(rest), Some(Token::Formula(_))) = (suffix, found.last()) else { return words };
    let after = rest.trim_start_matches(|c: char| c.is_alphanumeric() || c == '-').trim_start();
    if matches!(speech::word(&speech::plain(rest)), Some((_, Word::Arguments))) {
        found.push(Token::Word(Word::Arguments));
    } else if matches!(speech::word(&speech::plain(after)), Some((_, Word::Degree))) {
        // "Ein Polynom n-ten Grades"
        let degree = found.len() - 1;
        found.splice(degree..degree, [Token::Word(Word::Of), Token::Word(Word::Degree)]);
        return after.trim_start_matches(char::is_alphanumeric);
    } else {
        found.pop();
        found.push(Token::Word(Word::Filler));
    }
    rest.trim_start_matches(|c: char| c.is_alphanumeric() || c == '-')
}

fn words_of(words: &str, found: &mut Vec<Token>) {
    let words = speech::plain(words);
    // Where the last number in words stands.
    let mut counted: Option<(usize, i64)> = None;
    let mut rest = words.as_str();
    while let Some(c) = rest.chars().next() {
        if c == ' ' {
            rest = rest.piece(1..);
        } else if matches!(found.last(), Some(Token::Word(Word::Noun(_))))
            && c == '('
            && let Some(end) = rest.find(')')
        {
            // control points (de Boor points) d_0, …, d_n
            rest = rest.piece(end + 1..);
        } else if let Some((length, word)) = speech::word(rest) {
            let size = matches!(found.last(), Some(Token::Word(Word::Degree | Word::Order)));
            if let (Word::Arguments, Some((at, count))) = (word, counted)
                && at + 1 == found.len()
            {
                found[at] = Token::Number(count);
            }
            // with points b_0, …, b_3
            if *word == Word::WithPoints {
                found.push(Token::Word(Word::With));
            }
            // du second degré
            if let Word::HasDegree(degree) = word {
                found.extend([Token::Word(Word::Of), Token::Word(Word::Degree), Token::Number(*degree)]);
                rest = rest.piece(length..);
                continue;
            }
            found.push(match word {
                Word::WithPoints => Token::Word(Word::Noun(Sort::ControlPoints)),
                Word::Count(count) if size => Token::Number(*count),
                Word::Count(count) => {
                    counted = Some((found.len(), *count));
                    Token::Word(Word::Filler)
                }
                word => Token::Word(word.clone()),
            });
            rest = rest.piece(length..);
        } else if matches!(c, ',' | '，' | '、') {
            found.push(Token::Comma);
            rest = rest.piece(c.len_utf8()..);
        } else if c.is_ascii_digit() {
            let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            let number = rest.piece(..digits).parse();
            found
                .push(number.map_or_else(|_| Token::Unknown(rest.piece(..digits).to_owned()), Token::Number));
            rest = rest.piece(digits..);
        } else if c.is_alphabetic() {
            let spaced = !('\u{2e80}'..='\u{ffef}').contains(&c);
            let length = match spaced {
                true => rest
                    .find(|c: char| !c.is_alphanumeric() && !matches!(c, '-' | '\''))
                    .unwrap_or(rest.len()),
                false => c.len_utf8(),
            };
            let word = rest.piece(..length.max(c.len_utf8()));
            match found.last_mut() {
                Some(Token::Unknown(known)) => {
                    if spaced {
                        known.push(' ');
                    }
                    known.push_str(word);
                }
                _ => found.push(Token::Unknown(word.to_owned())),
            }
            rest = rest.piece(word.len()..);
        } else {
            if !matches!(c, '\'' | '"' | '.' | '。') {
                found.push(Token::Stop);
            }
            rest = rest.piece(c.len_utf8()..);
        }
    }
}

/// "A C^2 cubic spline" is a cubic spline.
pub(super) fn without_smoothness(tokens: Vec<Token>, formulas: &BTreeMap<usize, Vec<Expr>>) -> Vec<Token> {
    let smooth = |number: &usize| {
        matches!(formulas.get(number).map(Vec::as_slice), Some([Expr { kind: Kind::Pow(letter, _), .. }])
            if matches!(&letter.kind, Kind::Name(name) if name == "C"))
    };
    let adjective = |at: usize| {
        let noun = matches!(tokens.get(at + 1), Some(Token::Word(Word::OfDegree(_) | Word::Noun(_))));
        matches!(&tokens[at], Token::Formula(number) if noun && smooth(number))
    };
    let kept = (0..tokens.len()).filter(|&at| !adjective(at)).collect::<Vec<_>>();
    kept.into_iter().map(|at| tokens[at].clone()).collect()
}
