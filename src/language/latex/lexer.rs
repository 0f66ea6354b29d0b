//! Text to tokens.
//!
//! The lexer never fails: what it cannot read becomes a [`Tok::Bad`] that carries
//! its problem, so that one strange character spoils only the formula it stands in.
//! Spaces, comments, sizes and labels are gone after this stage.

mod control;

use super::Words;
use super::characters::{Character, character, is_word};
use super::token::{Fence, Tok, Token};
use crate::formula::Rel;
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// A numeral with more digits is refused.
pub(super) const MAX_DIGITS: usize = 20_000;

/// The tokens of `text[range]` and the problems of the bad ones among them.
pub(super) fn lex(text: &str, range: Span, words: Words) -> (Vec<Token>, Vec<Diagnostic>) {
    let mut lexer = Lexer {
        text,
        words,
        at: range.start,
        end: range.end,
        tokens: Vec::new(),
        problems: Vec::new(),
        sized: None,
        max_raw: control::MAX_RAW,
    };
    while lexer.at < lexer.end {
        lexer.token();
    }
    (lexer.tokens, lexer.problems)
}

pub(super) struct Lexer<'t> {
    pub(super) text: &'t str,
    pub(super) words: Words<'t>,
    pub(super) at: usize,
    end: usize,
    pub(super) tokens: Vec<Token>,
    problems: Vec<Diagnostic>,
    /// Where `\Bigl` stands that the next bracket belongs to.
    sized: Option<usize>,
    max_raw: usize,
}

impl Lexer<'_> {
    pub(super) fn rest(&self) -> &str {
        self.text.piece(self.at..self.end)
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn starts_with(&self, what: &str) -> bool {
        self.rest().starts_with(what)
    }

    /// Length of the longest prefix whose bytes all satisfy `test`.
    pub(super) fn run(&self, test: impl Fn(u8) -> bool) -> usize {
        self.rest().bytes().take_while(|&byte| test(byte)).count()
    }

    fn skip_spaces(&mut self) {
        self.at += self.run(|byte| byte.is_ascii_whitespace());
    }

    /// Adds a token for the next `length` bytes.
    pub(super) fn push(&mut self, kind: Tok, length: usize) {
        self.push_from(self.at, kind, self.at + length);
    }

    pub(super) fn push_from(&mut self, start: usize, kind: Tok, end: usize) {
        // \Bigl( is one bracket: what it opens begins with its size.
        let bracket = matches!(kind, Tok::Open(_) | Tok::Close(_) | Tok::Bar | Tok::DoubleBar | Tok::Mid);
        let start = self.sized.take().filter(|_| bracket).unwrap_or(start);
        self.tokens.push(Token::new(kind, start, end));
        self.at = end;
    }

    pub(super) fn bad(&mut self, start: usize, end: usize, problem: Diagnostic) {
        let number = self.problems.len() as u32;
        self.problems.push(problem.at(Span::new(start, end)));
        self.push_from(start, Tok::Bad(number), end);
    }

    pub(super) fn last(&self) -> Option<Tok> {
        self.tokens.last().map(|token| token.kind)
    }

    fn token(&mut self) {
        let Some(c) = self.peek() else {
            self.at = self.end;
            return;
        };
        match c {
            _ if c.is_whitespace() => self.at += c.len_utf8(),
            '%' => self.at += self.run(|byte| byte != b'\n'),
            '\\' => self.command(),
            '0'..='9' => self.number(),
            '.' => self.dots(),
            'a'..='z' | 'A'..='Z' => self.letters(),
            '\'' => {
                let count = self.run(|byte| byte == b'\'');
                self.push(Tok::Prime(count as u32), count);
            }
            '|' if self.starts_with("||") => self.push(Tok::DoubleBar, 2),
            ':' if self.colon_equals() > 0 => self.push(Tok::Rel(Rel::Define), self.colon_equals()),
            // a =: b defines b
            '=' if self.starts_with("=:") => self.push(Tok::Rel(Rel::Eq), 2),
            // f"(x)
            '"' if matches!(self.last(), Some(Tok::Letter(_) | Tok::Symbol(_))) => {
                self.push(Tok::Prime(2), 1)
            }
            '<' if self.starts_with("<=") => self.push(Tok::Rel(Rel::Le), 2),
            '>' if self.starts_with(">=") => self.push(Tok::Rel(Rel::Ge), 2),
            // n != 3; n!=3 is a factorial, as it is set
            '!' if self.starts_with("!=") && self.text.piece(..self.at).ends_with([' ', '\t', '\n']) => {
                self.push(Tok::Rel(Rel::Ne), 2)
            }
            '-' if self.starts_with("->") => self.push(Tok::Rel(Rel::To), 2),
            _ => match ascii(c) {
                Some(kind) => self.push(kind, 1),
                None => self.other(c),
            },
        }
    }

    /// Length of `:=` here, also with spaces between; 0 if there is none.
    fn colon_equals(&self) -> usize {
        let rest = self.rest().piece(1..);
        let trimmed = rest.trim_start_matches([' ', '\t']);
        if trimmed.starts_with('=') { self.rest().len() - trimmed.len() + 1 } else { 0 }
    }

    fn dots(&mut self) {
        let start = self.at;
        let count = self.run(|byte| byte == b'.');
        if count == 1 && self.rest().piece(1..).starts_with(|c: char| c.is_ascii_digit()) {
            let length = 1 + self.rest().piece(1..).bytes().take_while(u8::is_ascii_digit).count();
            if length > MAX_DIGITS {
                let problem = Diagnostic::error(Code::TooManyDigits, format!("a number of {length} digits"));
                return self.bad(start, start + length, problem);
            }
            return self.push(Tok::Number, length);
        }
        match count {
            // 0.d_1 d_2 is no 0, and not followed by anything else
            1 if self.text.piece(..start).ends_with(|c: char| c.is_ascii_digit())
                && self.rest().piece(1..).starts_with(|c: char| c.is_ascii_alphabetic()) =>
            {
                let problem =
                    Diagnostic::error(Code::UnexpectedCharacter, "a letter after the point of a number")
                        .hint("write a product without the point: 2 x");
                self.bad(start, start + 2, problem);
            }
            // (1, 2).x is no list of two formulas
            1 if self.text.piece(..start).ends_with([')', ']'])
                && self.rest().piece(1..).starts_with(|c: char| c.is_ascii_alphabetic()) =>
            {
                let problem = Diagnostic::error(Code::UnexpectedCharacter, "a letter after a point")
                    .hint("write p[0] for the first coordinate of p, a blank between two formulas");
                self.bad(start, start + 2, problem);
            }
            1 => {
                // recognisers of scanned text write `. . .`
                let mut dots = self.rest().char_indices().filter(|(_, c)| !matches!(c, ' ' | '\t'));
                let third = match (dots.next(), dots.next(), dots.next()) {
                    (Some((_, '.')), Some((_, '.')), Some((at, '.'))) => Some(at),
                    _ => None,
                };
                match third {
                    Some(at) => self.push(Tok::Ellipsis, at + 1),
                    None => self.push(Tok::Period, 1),
                }
            }
            2 => self.push(Tok::Range, 2),
            _ => self.push(Tok::Ellipsis, count),
        }
    }

    fn other(&mut self, c: char) {
        let length = c.len_utf8();
        match character(c) {
            Some(Character::Token(Tok::Rel(Rel::Implies | Rel::Iff))) if self.begins_formula() => {
                self.push(Tok::Text(self.at as u32, (self.at + length) as u32), length);
            }
            Some(Character::Token(kind)) => self.push(kind, length),
            Some(Character::Prime(count)) => self.push(Tok::Prime(count), length),
            Some(Character::Raised(upper)) => {
                let run: usize = self
                    .rest()
                    .chars()
                    .take_while(|&next| character(next) == Some(Character::Raised(upper)))
                    .map(char::len_utf8)
                    .sum();
                self.push(Tok::Raised(upper), run);
            }
            None if is_word(c) => {
                let run: usize = self.rest().chars().take_while(|&c| is_word(c)).map(char::len_utf8).sum();
                if self.is_in_name(run) {
                    let problem = Diagnostic::error(
                        Code::UnexpectedCharacter,
                        format!("'{c}' cannot be a letter of a name in a formula"),
                    )
                    .hint("write names with ASCII or Greek letters, words as \\text{…}");
                    return self.bad(self.at, self.at + run, problem);
                }
                self.push(Tok::Text(self.at as u32, (self.at + run) as u32), run);
            }
            None => {
                let problem = match c {
                    '$' => Diagnostic::error(Code::UnexpectedCharacter, "a '$' inside a formula")
                        .reason("the formula should have ended here")
                        .hint("read each formula by itself"),
                    _ => Diagnostic::error(
                        Code::UnexpectedCharacter,
                        format!("'{}' has no meaning in a formula", c.escape_debug()),
                    ),
                };
                self.bad(self.at, self.at + length, problem);
            }
        }
    }

    /// Whether a formula begins here: an arrow before it is a word, "thus".
    fn begins_formula(&self) -> bool {
        matches!(self.last(), None | Some(Tok::Begin(_)))
    }
}

fn ascii(c: char) -> Option<Tok> {
    Some(match c {
        '_' => Tok::Sub,
        '^' => Tok::Sup,
        '+' => Tok::Plus,
        '-' => Tok::Minus,
        '*' => Tok::Star,
        '/' => Tok::Slash,
        '!' => Tok::Bang,
        ',' => Tok::Comma,
        ';' => Tok::Semicolon,
        ':' => Tok::Rel(Rel::Colon),
        '=' => Tok::Rel(Rel::Eq),
        '<' => Tok::Rel(Rel::Lt),
        '>' => Tok::Rel(Rel::Gt),
        '|' => Tok::Bar,
        '(' => Tok::Open(Fence::Paren),
        ')' => Tok::Close(Fence::Paren),
        '[' => Tok::Open(Fence::Square),
        ']' => Tok::Close(Fence::Square),
        '{' => Tok::OpenBrace,
        '}' => Tok::CloseBrace,
        '&' => Tok::Align,
        '~' => Tok::Skip,
        _ => return None,
    })
}
