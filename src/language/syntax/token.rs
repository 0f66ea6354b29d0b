//! Tokens: what kind of sign, and where.

use crate::formula::Rel;
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// A text may have this many tokens; more is refused with [`Code::TooLong`].
///
/// It bounds the memory a tree can take (about a hundred bytes for each token).
pub const MAX_TOKENS: usize = 4_000_000;

/// Kinds of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bracket {
    /// ( )
    Paren,
    /// [ ]
    Square,
    /// { }
    Brace,
    /// ⌊ ⌋
    Floor,
    /// ⌈ ⌉
    Ceil,
    /// around a run of Unicode subscripts: the opening token spans the run, the closing one is empty
    Sub,
    /// around a run of Unicode superscripts, likewise
    Sup,
}

impl Bracket {
    /// The closing sign.
    pub(super) fn closing(self) -> &'static str {
        match self {
            Bracket::Paren => ")",
            Bracket::Square => "]",
            Bracket::Brace => "}",
            Bracket::Floor => "⌋",
            Bracket::Ceil => "⌉",
            Bracket::Sub | Bracket::Sup => "",
        }
    }

    /// The opening sign.
    pub(super) fn opening(self) -> &'static str {
        match self {
            Bracket::Paren => "(",
            Bracket::Square => "[",
            Bracket::Brace => "{",
            Bracket::Floor => "⌊",
            Bracket::Ceil => "⌈",
            Bracket::Sub | Bracket::Sup => "",
        }
    }
}

/// What a token is; its text is found through its span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TokenKind {
    /// `3`, `0.25`
    Number,
    /// a numeral with a second point, or in scientific notation
    BadNumber,
    /// digits directly after a name or an underscore
    Index,
    /// a word, a Greek letter, or `\alpha`
    Name,
    /// a LaTeX command that is not a name or operator here
    Command,
    /// `"words"`
    Text,
    /// a quotation mark without partner on its line
    OpenText,
    Newline,
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Bang,
    Underscore,
    /// one or more primes
    Prime,
    /// a combining accent
    Accent,
    Open(Bracket),
    Close(Bracket),
    Comma,
    Semicolon,
    Colon,
    Bar,
    Dollar,
    /// `...`
    Dots,
    /// `..`
    DotDot,
    /// `->`
    Arrow,
    Compose,
    Relation(Rel),
    /// the word `if`
    If,
    /// `for` in a list by a formula.
    For,
    /// the word `and`
    And,
    /// the word `otherwise`
    Otherwise,
    /// a character without meaning
    Unknown,
    /// after the last token
    End,
}

/// A token with its place. Twelve bytes, for there are millions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    start: u32,
    end: u32,
    /// What it is.
    pub(super) kind: TokenKind,
    /// Whether a blank, a line end or a comment stands before it.
    pub(super) spaced: bool,
}

impl Token {
    /// A token at `start..end`.
    ///
    /// # Errors
    /// When the text is too long for 32-bit positions.
    pub(super) fn new(
        kind: TokenKind,
        start: usize,
        end: usize,
        spaced: bool,
    ) -> Result<Self, Box<Diagnostic>> {
        match (u32::try_from(start), u32::try_from(end)) {
            (Ok(start), Ok(end)) => Ok(Token { start, end, kind, spaced }),
            _ => Err(too_long(Span::new(start, end))),
        }
    }

    /// The end of a text whose last token is `last`.
    pub(super) fn end_after(last: Option<&Token>) -> Self {
        let end = last.map_or(0, |token| token.end);
        Token { start: end, end, kind: TokenKind::End, spaced: false }
    }

    /// Its place.
    pub(super) fn span(self) -> Span {
        Span::new(self.start as usize, self.end as usize)
    }

    /// The text it was read from.
    pub(super) fn text(self, source: &str) -> &str {
        source.piece(self.span().range())
    }
}

/// The error for a text with too many tokens.
pub(super) fn too_long(span: Span) -> Box<Diagnostic> {
    let message = format!("the text has more than {MAX_TOKENS} numbers, names and signs");
    Box::new(
        Diagnostic::error(Code::TooLong, message)
            .at(span)
            .reason("the limit is reached here")
            .hint("split the text into several files or inputs"),
    )
}
