//! A line of prose as names, numbers, signs and words.

use std::ops::Range;

use crate::formula::source::Pieces;
use crate::language::lexicon::letters::{self, is_ideograph};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Name,
    /// A bare `a`, `A` or `I`, which may be a word.
    Article,
    Number,
    /// ∑, ∏, ∫, ∂ …: an operand follows.
    Prefix,
    /// `!`: an operand stands before.
    Postfix,
    Operator,
    Relation,
    Open(char),
    Close(char),
    Comma,
    Dots,
    Cut,
    /// A sign of mathematics that is not known: what it touches is not read.
    Strange,
}

#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) range: Range<usize>,
    /// Whether white space stands before it.
    pub(super) spaced: bool,
    /// Marks of emphasis at both ends.
    pub(super) marks: usize,
    /// Whether it is a word of letters that are no ideographs.
    pub(super) word: bool,
    /// Whether its letters stand for their product.
    pub(super) product: bool,
}

pub(super) fn tokens(line: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut at = 0;
    let mut spaced = false;
    while let Some(c) = line.piece(at..).chars().next() {
        if c.is_whitespace() {
            at += c.len_utf8();
            spaced = true;
            continue;
        }
        let (kind, len, marks) = token(line, at, c);
        let word = kind == Kind::Cut && (is_letter(c) && !is_ideograph(c) || c.is_ascii_digit());
        tokens.push(Token { kind, range: at..at + len, spaced, marks, word, product: false });
        at += len;
        spaced = false;
    }
    tokens
}

fn token(line: &str, at: usize, c: char) -> (Kind, usize, usize) {
    let rest = line.piece(at..);
    let one = c.len_utf8();
    if c.is_ascii_digit() {
        let mut len = rest.bytes().take_while(u8::is_ascii_digit).count();
        if let Some(tail) = rest.piece(len..).strip_prefix('.') {
            let decimals = tail.bytes().take_while(u8::is_ascii_digit).count();
            len += if decimals > 0 { decimals + 1 } else { 0 };
        }
        let word = letters(rest.piece(len..));
        if word > 1 {
            return (Kind::Cut, len + word, 0);
        }
        return (Kind::Number, len + exponents(rest.piece(len..)), 0);
    }
    if is_letter(c) {
        let word = letters(rest);
        if word > 1 || !c.is_ascii() {
            return (Kind::Cut, word + index_of_word(rest.piece(word..)), 0);
        }
        return name(rest, one);
    }
    if letters::name(c).is_some() || letters::of_blackboard(c).is_some() {
        return name(rest, one);
    }
    if c == '*' {
        let marks = rest.bytes().take_while(|&byte| byte == b'*').count();
        let free = !line.piece(..at).ends_with(|c: char| c.is_alphanumeric() || c == ')');
        if free && marks <= 2 && rest.piece(marks..).starts_with(is_symbol) {
            let inner = rest.piece(marks..);
            let first = inner.chars().next().map_or(0, char::len_utf8);
            let (kind, len, _) = name(inner, first);
            if kind != Kind::Cut
                && letters(inner) <= 1
                && inner.piece(len..).starts_with(rest.piece(..marks))
                && !inner.piece(len + marks..).starts_with(|c: char| c.is_alphanumeric() || c == '*')
            {
                return (Kind::Name, len + 2 * marks, marks);
            }
        }
        return (if marks == 1 { Kind::Operator } else { Kind::Cut }, marks, 0);
    }
    for dots in ["...", "…", "⋯"] {
        if rest.starts_with(dots) {
            return (Kind::Dots, dots.len(), 0);
        }
    }
    for relation in [":=", "<=", ">=", "!=", "=", "≤", "≥", "≠", "≔", "≜", "⩽", "⩾", "<", ">"] {
        if let Some(after) = rest.strip_prefix(relation) {
            // ==, =>, <=> and arrows are no relations.
            let arrow = after.starts_with(['=', '>', '<']) || (relation == "<" && after.starts_with('-'));
            return (if arrow { Kind::Cut } else { Kind::Relation }, relation.len() + usize::from(arrow), 0);
        }
    }
    let kind = match c {
        '∑' | '∏' | '∫' | '∂' | '∇' => {
            let (kind, len, _) = name(rest, one);
            return (if kind == Kind::Cut { Kind::Strange } else { Kind::Prefix }, len, 0);
        }
        '√' => Kind::Prefix,
        '!' => Kind::Postfix,
        '+' | '-' | '−' | '–' | '±' | '/' | '^' | '·' | '⋅' | '×' | '∘' | '⊗' => Kind::Operator,
        '(' | '[' | '{' => Kind::Open(c),
        '（' => Kind::Open('('),
        ')' | '）' => Kind::Close('('),
        ']' => Kind::Close('['),
        '}' => Kind::Close('{'),
        ',' | ';' => Kind::Comma,
        '∞' => Kind::Number,
        // The bars of |x|; those between the cells of a table stand apart.
        '|' if glued(line.piece(..at).chars().next_back()) || glued(rest.chars().nth(1)) => Kind::Strange,
        c if is_strange(c) => Kind::Strange,
        _ => Kind::Cut,
    };
    (kind, one, 0)
}

fn glued(beside: Option<char>) -> bool {
    beside.is_some_and(|c| !c.is_whitespace() && c != '|')
}

/// Signs of mathematics, numbers in one sign, signs as wide as ideographs, and units.
fn is_strange(c: char) -> bool {
    let block = matches!(c, '\u{2200}'..='\u{22ff}' | '\u{2a00}'..='\u{2aff}' | '\u{2308}'..='\u{230b}' | '\u{20a0}'..='\u{20bf}');
    let wide = matches!(c, '\u{ff01}'..='\u{ff5e}') && !matches!(c, '，' | '；' | '：' | '！' | '？' | '．');
    block || wide || is_raised(c) || c.is_numeric() || matches!(c, '%' | '~' | '&' | '@' | '‖' | '÷' | '°')
}

/// The bytes of what is glued to a word by the sign for an index: Bézier_3.
fn index_of_word(text: &str) -> usize {
    match text.strip_prefix('_') {
        Some(index) => 1 + script(index, false).unwrap_or(letters(index)),
        None => 0,
    }
}

/// Letters that form words: Greek letters and raised ones stand for themselves.
fn is_letter(c: char) -> bool {
    c.is_alphabetic() && letters::name(c).is_none() && letters::of_blackboard(c).is_none() && !is_raised(c)
}

fn is_symbol(c: char) -> bool {
    c.is_ascii_alphabetic() || letters::name(c).is_some()
}

/// Raised and lowered digits, letters and signs, and accents.
fn is_raised(c: char) -> bool {
    matches!(c, '²' | '³' | '¹' | 'ʰ'..='˿' | 'ᴬ'..='ᶿ' | '⁰'..='₟' | 'ⱼ' | 'ⱽ')
        || matches!(c, '\u{302}'..='\u{308}' | '\u{20d7}')
}

/// The bytes of the word at the beginning; a letter may stand next to an ideograph.
fn letters(text: &str) -> usize {
    let ideographs = text.starts_with(is_ideograph);
    text.chars().take_while(|&c| is_letter(c) && is_ideograph(c) == ideographs).map(char::len_utf8).sum()
}

/// The bytes of raised characters and primes at the beginning.
fn exponents(text: &str) -> usize {
    text.chars().take_while(|&c| is_raised(c)).map(char::len_utf8).sum()
}

/// A name of one letter of `len` bytes, with its indices, exponents and primes.
fn name(text: &str, len: usize) -> (Kind, usize, usize) {
    let letter = len;
    let mut len = len;
    len += text.piece(len..).bytes().take_while(u8::is_ascii_digit).count();
    loop {
        let rest = text.piece(len..);
        len += match rest.chars().next() {
            Some(c) if is_raised(c) || matches!(c, '\'' | '’' | '′' | '″') => c.len_utf8(),
            Some(sign @ ('_' | '^')) => match script(rest.piece(1..), text.starts_with(['∑', '∏', 'Σ', 'Π']))
            {
                Some(script) => 1 + script,
                None if sign == '^' => break,
                // A word with underscores.
                None => return (Kind::Cut, len + 1 + letters(rest.piece(1..)), 0),
            },
            _ => break,
        };
    }
    let article = len == letter && text.starts_with(['a', 'A', 'I']);
    (if article { Kind::Article } else { Kind::Name }, len, 0)
}

/// The bytes of an index or exponent: in braces, digits, or a letter; `a_ju_j` are two names. Below a sum (`bounds`) it
/// may say from where.
fn script(text: &str, bounds: bool) -> Option<usize> {
    let first = text.chars().next()?;
    if first == '(' {
        // b_(i-1), B_i^(n-1)
        let close = text.bytes().take(40).position(|byte| byte == b')')?;
        let inner = text.piece(1..close);
        let plain = !inner.is_empty() && !inner.contains(['(', ' ']);
        return (plain && (bounds || !inner.contains('='))).then_some(close + 1);
    }
    if first == '{' {
        let close = text.bytes().take(40).position(|byte| byte == b'}')?;
        let inner = text.piece(1..close);
        return (!inner.contains('{') && (bounds || !inner.contains('='))).then_some(close + 1);
    }
    if first.is_ascii_digit() {
        return Some(text.bytes().take_while(u8::is_ascii_digit).count());
    }
    if letters::name(first).is_some() {
        return Some(first.len_utf8());
    }
    if !first.is_ascii_alphabetic() {
        return None;
    }
    let word = letters(text);
    let splits = text.piece(word..).starts_with(|c: char| matches!(c, '_' | '^' | '(') || is_raised(c));
    match word {
        1 => Some(1),
        2 if splits => Some(1),
        2 => Some(2),
        _ => None,
    }
}
