//! The walk that all writers share: a stack of pieces still to be printed.
//!
//! A [`Notation`] says for one node what it consists of: strings, and children each
//! with the precedence that its place requires. The walk adds parentheses, and
//! settles what stands between two pieces only when it has both in hand, from the
//! characters that would meet. So no notation has to guess how an operand begins,
//! and a deep tree needs memory but no call stack.

use std::fmt;

use crate::budget;
use crate::formula::{Expr, Precedence};

/// A way to print formula trees.
pub(super) trait Notation {
    /// What can go wrong.
    type Error: From<fmt::Error>;

    /// The precedence of what `expr` is printed as.
    fn level(&self, expr: &Expr) -> Precedence;

    /// The parentheses to put around `expr` where it needs them.
    fn parentheses(&self, _expr: &Expr) -> (&'static str, &'static str) {
        ("(", ")")
    }

    /// What stands between the text printed so far and `next`, which is not empty.
    fn between(&self, joint: Joint, before: &Tail, next: &str) -> &'static str;

    /// The pieces of `expr`, without parentheses around it.
    fn expand<'a>(&self, expr: &'a Expr, out: &mut Pieces<'a>) -> Result<(), Self::Error>;
}

/// How two pieces meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Joint {
    /// One follows the other.
    Adjacent,
    /// They are factors of a product.
    Times {
        /// What the notation said about the first factor, see [`Pieces::times`].
        hint: bool,
        /// Side by side they could be a mixed number, see [`Expr::is_mixed_with`].
        mixed: bool,
        /// In an index or exponent.
        compact: bool,
    },
}

/// How the text printed so far ends.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tail {
    /// The last character.
    pub(super) last: Option<char>,
    /// The last piece ended in a LaTeX command such as `\sigma`.
    pub(super) command: bool,
    /// The last piece was a LaTeX row break.
    pub(super) row_break: bool,
}

impl Tail {
    fn after(piece: &str) -> Self {
        let head = piece.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        Tail {
            last: piece.chars().next_back(),
            command: head.len() < piece.len() && head.ends_with('\\') && !head.ends_with("\\\\"),
            row_break: piece.ends_with("\\\\ "),
        }
    }
}

enum Piece<'a> {
    Str(&'a str),
    String(String),
    Node { expr: &'a Expr, level: Precedence, compact: bool },
    Times { hint: bool, mixed: bool, compact: bool },
}

/// The pieces of a node, in order.
pub(super) struct Pieces<'a> {
    list: Vec<Piece<'a>>,
    compact: bool,
}

impl<'a> Pieces<'a> {
    /// Whether this is inside an index or exponent, where sums are set without blanks.
    pub(super) fn compact(&self) -> bool {
        self.compact
    }

    /// A fixed string.
    pub(super) fn str(&mut self, text: &'a str) {
        self.list.push(Piece::Str(text));
    }

    /// A string made for the purpose.
    pub(super) fn string(&mut self, text: String) {
        self.list.push(Piece::String(text));
    }

    /// A child in a place that requires at least `level`.
    pub(super) fn node(&mut self, expr: &'a Expr, level: Precedence) {
        self.list.push(Piece::Node { expr, level, compact: self.compact });
    }

    /// A child in an index or exponent.
    pub(super) fn script(&mut self, expr: &'a Expr, level: Precedence) {
        self.list.push(Piece::Node { expr, level, compact: true });
    }

    /// A child in parentheses, whatever it is.
    pub(super) fn wrapped(&mut self, open: &'a str, expr: &'a Expr, close: &'a str) {
        self.str(open);
        self.node(expr, Precedence::Sequence);
        self.str(close);
    }

    /// The sign of a product, settled when the next factor is known. The hint is what
    /// [`Notation::between`] wants to know about the factor before.
    pub(super) fn times(&mut self, hint: bool, mixed: bool) {
        self.list.push(Piece::Times { hint, mixed, compact: self.compact });
    }

    /// Items with a separator, each in a place that requires at least `level`.
    pub(super) fn list(
        &mut self,
        items: impl IntoIterator<Item = &'a Expr>,
        separator: &'a str,
        level: Precedence,
    ) {
        for (i, item) in items.into_iter().enumerate() {
            if i > 0 {
                self.str(separator);
            }
            self.node(item, level);
        }
    }

    /// The same in an index or exponent.
    pub(super) fn script_list(&mut self, items: &'a [Expr], separator: &'a str) {
        let compact = std::mem::replace(&mut self.compact, true);
        self.list(items, separator, Precedence::Relation);
        self.compact = compact;
    }
}

struct Sink<'w> {
    out: &'w mut dyn fmt::Write,
    tail: Tail,
    joint: Joint,
}

impl Sink<'_> {
    fn push<N: Notation>(&mut self, notation: &N, piece: &str) -> fmt::Result {
        if piece.is_empty() {
            return Ok(());
        }
        let joint = std::mem::replace(&mut self.joint, Joint::Adjacent);
        self.out.write_str(notation.between(joint, &self.tail, piece))?;
        self.tail = Tail::after(piece);
        self.out.write_str(piece)
    }
}

/// Prints `expr` in a place that requires at least `level`.
///
/// Cost: linear in the size of the tree and of the output.
pub(super) fn walk<N: Notation>(
    notation: &N,
    expr: &Expr,
    level: Precedence,
    out: &mut dyn fmt::Write,
) -> Result<(), N::Error> {
    let mut sink = Sink { out, tail: Tail::default(), joint: Joint::Adjacent };
    let mut stack = vec![Piece::Node { expr, level, compact: false }];
    let mut pieces = Pieces { list: Vec::new(), compact: false };
    while let Some(piece) = stack.pop() {
        match piece {
            Piece::Str(text) => sink.push(notation, text)?,
            Piece::String(text) => sink.push(notation, &text)?,
            Piece::Times { hint, mixed, compact } => sink.joint = Joint::Times { hint, mixed, compact },
            Piece::Node { expr, level, compact } => {
                budget::step();
                if notation.level(expr) < level {
                    let (open, close) = notation.parentheses(expr);
                    sink.push(notation, open)?;
                    stack.push(Piece::Str(close));
                }
                pieces.compact = compact;
                notation.expand(expr, &mut pieces)?;
                stack.extend(pieces.list.drain(..).rev());
            }
        }
    }
    Ok(())
}

/// The output of a notation that cannot fail.
pub(super) fn to_string<N: Notation<Error = fmt::Error>>(notation: &N, expr: &Expr) -> String {
    let mut text = String::new();
    walk(notation, expr, Precedence::Sequence, &mut text).expect("writing into a String cannot fail");
    text
}
