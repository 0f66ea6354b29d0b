//! Text to tokens. Total: a character without meaning is a token of its own kind,
//! which only the parser complains about, and only if it gets there.

use super::chars;
use super::token::{Bracket, MAX_TOKENS, Token, TokenKind, too_long};
use crate::formula::Rel;
use crate::formula::source::Pieces;
use crate::language::diagnostic::Diagnostic;
use crate::language::lexicon::letters;

/// The tokens of `text`, line ends included, blanks and comments left out.
///
/// # Errors
/// When there are more than [`MAX_TOKENS`].
pub(super) fn lex(text: &str) -> Result<Vec<Token>, Diagnostic> {
    let mut lexer = Lexer { text, at: 0, spaced: false, tokens: Vec::new() };
    lexer.run().map_err(|problem| *problem)?;
    Ok(lexer.tokens)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    spaced: bool,
    tokens: Vec<Token>,
}

type Lexed = Result<(), Box<Diagnostic>>;

impl Lexer<'_> {
    fn run(&mut self) -> Lexed {
        while let Some(c) = self.peek() {
            let start = self.at;
            let after_name = !self.spaced
                && self.last().is_some_and(takes_index)
                && !self.text.piece(..start).ends_with(chars::ROOT);
            let plain = chars::ordinary(c);
            if c == '\n' {
                self.at += 1;
                self.push(TokenKind::Newline, start)?;
                self.spaced = true;
            } else if chars::is_blank(c) {
                self.skip(|c| c != '\n' && chars::is_blank(c));
                self.spaced = true;
            } else if c == '#' {
                self.skip(|c| c != '\n');
                self.spaced = true;
            } else if let Some(bracket) = run_bracket(c) {
                self.run_of(bracket)?;
            } else if plain.is_ascii_digit() && after_name {
                self.skip(is_digit);
                let decimal = self.fraction_follows();
                if decimal {
                    self.number_tail();
                }
                self.push(if decimal { TokenKind::BadNumber } else { TokenKind::Index }, start)?;
            } else if plain.is_ascii_digit() || (plain == '.' && self.nth(1).is_some_and(is_digit)) {
                self.number(start)?;
            } else if chars::fraction(c).is_some() {
                self.at += c.len_utf8();
                self.push(TokenKind::Number, start)?;
            } else if c == chars::ROOT {
                self.at += c.len_utf8();
                self.push(TokenKind::Name, start)?;
            } else if chars::is_letter(c) {
                self.word(start)?;
            } else if letters::name(c).is_some() || letters::of_blackboard(c).is_some() || c == '∞' {
                self.at += c.len_utf8();
                self.push(TokenKind::Name, start)?;
            } else if c == '\\' {
                self.command(start)?;
            } else if c == '"' {
                self.quotation(start)?;
            } else if chars::primes(c).is_some() {
                self.skip(|c| chars::primes(c).is_some());
                self.push(TokenKind::Prime, start)?;
            } else {
                let (kind, length) = self.sign(c, plain);
                self.at += length;
                self.push(kind, start)?;
            }
        }
        Ok(())
    }

    fn peek(&self) -> Option<char> {
        self.text.piece(self.at..).chars().next()
    }

    fn nth(&self, n: usize) -> Option<char> {
        self.text.piece(self.at..).chars().nth(n)
    }

    fn last(&self) -> Option<TokenKind> {
        self.tokens.last().map(|token| token.kind)
    }

    fn skip(&mut self, wanted: impl Fn(char) -> bool) {
        let rest = self.text.piece(self.at..);
        self.at += rest.find(|c| !wanted(c)).unwrap_or(rest.len());
    }

    fn push(&mut self, kind: TokenKind, start: usize) -> Lexed {
        self.push_span(kind, start, self.at)
    }

    fn push_span(&mut self, kind: TokenKind, start: usize, end: usize) -> Lexed {
        let token = Token::new(kind, start, end, self.spaced)?;
        if self.tokens.len() >= MAX_TOKENS {
            return Err(too_long(token.span()));
        }
        self.tokens.push(token);
        self.spaced = false;
        Ok(())
    }

    /// A run of raised or lowered characters, between an opening and a closing token.
    fn run_of(&mut self, bracket: Bracket) -> Lexed {
        let member = |c: char| run_bracket(c) == Some(bracket);
        let start = self.at;
        self.skip(member);
        let end = self.at;
        self.push_span(TokenKind::Open(bracket), start, end)?;
        self.at = start;
        while self.at < end {
            let start = self.at;
            let plain = self.peek().map_or(' ', chars::ordinary);
            if plain.is_ascii_digit() {
                self.skip(|c| member(c) && chars::ordinary(c).is_ascii_digit());
                self.push(TokenKind::Number, start)?;
            } else if plain.is_ascii_alphabetic() {
                self.skip(|c| member(c) && chars::ordinary(c).is_ascii_alphabetic());
                self.push(TokenKind::Name, start)?;
            } else {
                self.at += self.peek().map_or(1, char::len_utf8);
                let kind = match plain {
                    '+' => TokenKind::Plus,
                    '-' => TokenKind::Minus,
                    '=' => TokenKind::Relation(Rel::Eq),
                    '(' => TokenKind::Open(Bracket::Paren),
                    _ => TokenKind::Close(Bracket::Paren),
                };
                self.push(kind, start)?;
            }
        }
        self.push_span(TokenKind::Close(bracket), end, end)
    }

    /// Whether a point with a digit follows, and not the `..` of a range.
    fn fraction_follows(&self) -> bool {
        self.peek().is_some_and(|c| chars::ordinary(c) == '.') && self.nth(1).is_some_and(is_digit)
    }

    fn number(&mut self, start: usize) -> Lexed {
        self.skip(is_digit);
        // 1'000'000
        while self.text.piece(start..self.at).len() <= 3
            || self.text.piece(start..self.at).contains(chars::APOSTROPHES)
        {
            let group = self.text.piece(self.at..);
            let digits = group.trim_start_matches(chars::APOSTROPHES);
            let three = digits.chars().take_while(char::is_ascii_digit).count() == 3;
            if group.len() - digits.len() == 0 || !three || digits.piece(3..).starts_with(chars::is_letter) {
                break;
            }
            self.at += group.len() - digits.len() + 3;
        }
        // 3½
        if self.peek().and_then(chars::fraction).is_some() {
            self.at += self.peek().map_or(0, char::len_utf8);
            return self.push(TokenKind::Number, start);
        }
        let point = self.peek().is_some_and(|c| chars::ordinary(c) == '.')
            && self.nth(1).is_none_or(|c| chars::ordinary(c) != '.');
        if point {
            self.at += self.peek().map_or(0, char::len_utf8);
            self.skip(is_digit);
        }
        // 0.(3)
        let repeats = point && self.text.piece(start..self.at).ends_with('.') && self.peek() == Some('(');
        let number = self.at;
        let bad = self.number_tail() || repeats;
        // 2.5E2 is a number to all programs; e may be a name.
        let tail = self.text.piece(number..self.at);
        let bad = bad && (!tail.starts_with('E') || self.peek().is_some_and(chars::is_letter));
        self.push(if bad { TokenKind::BadNumber } else { TokenKind::Number }, start)
    }

    /// Takes in what makes a numeral malformed: further points, or a power of ten as in `1e-5`.
    fn number_tail(&mut self) -> bool {
        let start = self.at;
        while self.fraction_follows() {
            self.at += self.peek().map_or(0, char::len_utf8);
            self.skip(is_digit);
        }
        if matches!(self.peek(), Some('e' | 'E')) {
            let sign = usize::from(matches!(self.nth(1), Some('+' | '-')));
            if self.nth(1 + sign).is_some_and(is_digit) {
                self.at += 1 + sign;
                self.skip(is_digit);
            }
        }
        self.at > start
    }

    fn word(&mut self, start: usize) -> Lexed {
        // 当t=2时: no blanks stand between Chinese words and names.
        let chinese = self.peek().is_some_and(letters::is_ideograph);
        self.skip(|c| chars::is_letter(c) && letters::is_ideograph(c) == chinese);
        let index = self.last() == Some(TokenKind::Underscore);
        // polar_sum is one word; a_xy and sigma_xy are names with an index.
        while !index && joins_words(self.text.piece(start..self.at), self.text.piece(self.at..)) {
            self.at += 1;
            self.skip(chars::is_letter);
        }
        let kind = match self.text.piece(start..self.at) {
            "in" if !index => TokenKind::Relation(Rel::In),
            "if" if !index => TokenKind::If,
            "for" if !index => TokenKind::For,
            "otherwise" if !index => TokenKind::Otherwise,
            "and" if !index => TokenKind::And,
            _ => TokenKind::Name,
        };
        self.push(kind, start)
    }

    fn command(&mut self, start: usize) -> Lexed {
        self.at += 1;
        self.skip(|c| c.is_ascii_alphabetic());
        if self.at == start + 1 {
            // `\;`, `\{`: one character belongs to the backslash, but never the line end.
            self.at += self.peek().filter(|&c| c != '\n').map_or(0, char::len_utf8);
        }
        let kind = match self.text.piece(start + 1..self.at) {
            "cdot" | "times" | "ast" => TokenKind::Star,
            "div" => TokenKind::Slash,
            "circ" => TokenKind::Compose,
            "ldots" | "dots" | "cdots" => TokenKind::Dots,
            "to" | "mapsto" => TokenKind::Arrow,
            "ne" | "neq" => TokenKind::Relation(Rel::Ne),
            "lt" => TokenKind::Relation(Rel::Lt),
            "le" | "leq" => TokenKind::Relation(Rel::Le),
            "gt" => TokenKind::Relation(Rel::Gt),
            "ge" | "geq" => TokenKind::Relation(Rel::Ge),
            "equiv" => TokenKind::Relation(Rel::Equiv),
            "approx" => TokenKind::Relation(Rel::Approx),
            "in" => TokenKind::Relation(Rel::In),
            "notin" => TokenKind::Relation(Rel::NotIn),
            "subset" | "subseteq" => TokenKind::Relation(Rel::Subset),
            "coloneqq" | "triangleq" => TokenKind::Relation(Rel::Define),
            "infty" => TokenKind::Name,
            name if letters::sign(name).is_some() => TokenKind::Name,
            _ => TokenKind::Command,
        };
        self.push(kind, start)
    }

    fn quotation(&mut self, start: usize) -> Lexed {
        let rest = self.text.piece(start + 1..);
        match rest.find(['"', '\n']) {
            Some(length) if rest.as_bytes()[length] == b'"' => {
                self.at = start + length + 2;
                self.push(TokenKind::Text, start)
            }
            _ => {
                self.at = start + 1;
                self.push(TokenKind::OpenText, start)
            }
        }
    }

    /// Operators and punctuation: the kind and the number of bytes.
    fn sign(&self, c: char, plain: char) -> (TokenKind, usize) {
        use TokenKind::*;
        let second = self.nth(1).map(chars::ordinary);
        let third = self.nth(2).map(chars::ordinary);
        let bytes = |count: usize| self.text.piece(self.at..).chars().take(count).map(char::len_utf8).sum();
        let (kind, count) = match (plain, second, third) {
            ('<', Some('='), Some('>')) => (Relation(Rel::Iff), 3),
            ('.', Some('.'), Some('.')) => (Dots, 3),
            ('.', Some('.'), _) => (DotDot, 2),
            (':', Some('='), _) => (Relation(Rel::Define), 2),
            ('!', Some('='), _) => (Relation(Rel::Ne), 2),
            ('<', Some('='), _) => (Relation(Rel::Le), 2),
            ('>', Some('='), _) => (Relation(Rel::Ge), 2),
            ('=', Some('>'), _) => (Relation(Rel::Implies), 2),
            ('=', Some('='), _) => (Relation(Rel::Eq), 2),
            ('-', Some('>'), _) => (Arrow, 2),
            ('*', Some('*'), _) => (Caret, 2),
            ('$', Some('$'), _) => (Dollar, 2),
            ('$', ..) => (Dollar, 1),
            ('+', ..) => (Plus, 1),
            ('-' | '−' | '–' | '‐' | '‑', ..) => (Minus, 1),
            ('*' | '·' | '⋅' | '×' | '∙' | '•' | '∗', ..) => (Star, 1),
            ('/' | '÷' | '∕' | '⁄', ..) => (Slash, 1),
            ('^', ..) => (Caret, 1),
            ('!', ..) => (Bang, 1),
            ('_', ..) => (Underscore, 1),
            ('(', ..) => (Open(Bracket::Paren), 1),
            (')', ..) => (Close(Bracket::Paren), 1),
            ('[', ..) => (Open(Bracket::Square), 1),
            (']', ..) => (Close(Bracket::Square), 1),
            ('{', ..) => (Open(Bracket::Brace), 1),
            ('}', ..) => (Close(Bracket::Brace), 1),
            ('⌊', ..) => (Open(Bracket::Floor), 1),
            ('⌋', ..) => (Close(Bracket::Floor), 1),
            ('⌈', ..) => (Open(Bracket::Ceil), 1),
            ('⌉', ..) => (Close(Bracket::Ceil), 1),
            (',', ..) => (Comma, 1),
            (';', ..) => (Semicolon, 1),
            (':', ..) => (Colon, 1),
            ('|', ..) => (Bar, 1),
            ('…' | '⋯', ..) => (Dots, 1),
            ('→' | '↦', ..) => (Arrow, 1),
            ('∘', ..) => (Compose, 1),
            ('=', ..) => (Relation(Rel::Eq), 1),
            ('<', ..) => (Relation(Rel::Lt), 1),
            ('>', ..) => (Relation(Rel::Gt), 1),
            ('≠', ..) => (Relation(Rel::Ne), 1),
            ('≤' | '⩽', ..) => (Relation(Rel::Le), 1),
            ('≥' | '⩾', ..) => (Relation(Rel::Ge), 1),
            ('≔' | '≜', ..) => (Relation(Rel::Define), 1),
            ('≡', ..) => (Relation(Rel::Equiv), 1),
            ('≈', ..) => (Relation(Rel::Approx), 1),
            ('∈', ..) => (Relation(Rel::In), 1),
            ('∉', ..) => (Relation(Rel::NotIn), 1),
            ('⊆' | '⊂', ..) => (Relation(Rel::Subset), 1),
            ('⇒', ..) => (Relation(Rel::Implies), 1),
            ('⇔', ..) => (Relation(Rel::Iff), 1),
            _ if chars::accent(c).is_some() => (Accent, 1),
            _ => (Unknown, 1),
        };
        (kind, bytes(count))
    }
}

fn is_digit(c: char) -> bool {
    chars::ordinary(c).is_ascii_digit() && run_bracket(c).is_none()
}

/// Digits directly after these are an index.
fn takes_index(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Name | TokenKind::Underscore | TokenKind::Accent)
}

fn run_bracket(c: char) -> Option<Bracket> {
    if c.is_ascii() {
        None
    } else if chars::subscript(c).is_some() {
        Some(Bracket::Sub)
    } else if chars::superscript(c).is_some() {
        Some(Bracket::Sup)
    } else {
        None
    }
}

/// Whether an underscore joins two words: two letters or more on both sides, no Greek letter. A
/// single letter may stand between two such words, as in `not_a_knot`.
fn joins_words(word: &str, rest: &str) -> bool {
    let letters = |text: &str| text.chars().take_while(char::is_ascii_lowercase).count();
    let follows = |rest: &str| rest.strip_prefix('_').is_some_and(|next| letters(next) > 1);
    let over_a_letter = |rest: &str| {
        rest.strip_prefix('_').is_some_and(|next| letters(next) == 1 && follows(next.piece(1..)))
    };
    letters(word) > 1 && letters::sign(word).is_none() && (follows(rest) || over_a_letter(rest))
}
