//! The tokens of a formula.

use super::commands::Role;
use crate::formula::Rel;
use crate::formula::source::Span;

/// Bracket shapes; the same value stands for the opening and the closing side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fence {
    Paren,
    Square,
    Curly,
    Angle,
    Floor,
    Ceil,
    Bar,
    Norm,
    /// The invisible bracket of `\left.` and `\right.`.
    Dot,
}

/// Environments, by what they mean to the reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Env {
    /// A matrix with the brackets its name says.
    Matrix(crate::formula::Delimiter),
    /// `array`: a matrix, or aligned rows if its cells hold relations.
    Array,
    /// `cases`
    Cases,
    /// Rows of formulas: `aligned`, `gather`, …
    Rows,
}

/// What a token is. Numbers, words and texts are looked up in the source by their span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Tok {
    Number,
    Letter(char),
    /// A named symbol such as `alpha`.
    Symbol(&'static str),
    /// An upright word used as a name: the bytes of its letters.
    Word(u32, u32),
    /// Words: the bytes of the content.
    Text(u32, u32),
    /// Unicode superscripts (true) or subscripts (false).
    Raised(bool),
    Sub,
    Sup,
    Prime(u32),
    Plus,
    Minus,
    Dot,
    Star,
    Cross,
    Circ,
    Slash,
    /// A binary operator read as a function of that name, such as `setminus`.
    Binary(&'static str),
    Bang,
    Percent,
    Comma,
    Semicolon,
    Period,
    Range,
    Ellipsis,
    Rel(Rel),
    OpenBrace,
    CloseBrace,
    Open(Fence),
    Close(Fence),
    Left(Fence),
    Right(Fence),
    /// `|`
    Bar,
    /// `||`
    DoubleBar,
    /// `\mid`, `\middle|`
    Mid,
    Begin(Env),
    End(Env),
    RowBreak,
    Align,
    /// A wide space, or an `&` between two formulas of a row.
    Gap,
    /// Something without meaning.
    Skip,
    /// A command with a structure of its own.
    Command(Role),
    /// Something that cannot be read: the number of its problem.
    Bad(u32),
}

impl Tok {
    /// Whether it joins two operands.
    pub fn is_operator(self) -> bool {
        matches!(self, Tok::Plus | Tok::Minus | Tok::Dot | Tok::Star | Tok::Cross | Tok::Slash)
    }
}

/// "No partner".
pub(super) const ALONE: u32 = u32::MAX;

/// A token, its bytes, and for brackets of all kinds the index of the other bracket.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    pub kind: Tok,
    start: u32,
    end: u32,
    pub partner: u32,
    /// For opening brackets: a relation stands directly inside.
    pub relation: bool,
    /// For opening brackets: `\over`, `\choose` or a font switch stands directly inside.
    pub special: bool,
    /// The front of the token was taken by itself.
    pub cut: bool,
}

impl Token {
    /// A token at the given bytes; the lexer makes sure that they fit in 32 bits.
    pub fn new(kind: Tok, start: usize, end: usize) -> Token {
        Token {
            kind,
            start: start as u32,
            end: end as u32,
            partner: ALONE,
            relation: false,
            special: false,
            cut: false,
        }
    }

    pub fn span(&self) -> Span {
        Span::new(self.start as usize, self.end as usize)
    }

    /// Removes the first byte, which is a token of its own.
    pub fn cut_front(&mut self) {
        self.start += 1;
        self.cut = true;
    }
}
