//! The plain notation, as typed: `t1 t2 + 5/3 (t1 + t2)`.

use std::fmt;

use super::plain::{self, Plain};
use super::walk::{Joint, Notation, Pieces, Tail, to_string, walk};
use crate::formula::{Expr, Kind, Precedence, Rel};
use crate::language::lexicon::relations;
use crate::language::value::Value;

/// The formula in the plain notation, which the plain reader reads back to the same tree, up to
/// parentheses that had to be added. What the notation has no sign for becomes a call.
///
/// Cost: linear in the size of the tree.
///
/// ```
/// use polarform::expr::Expr;
/// let sum = Expr::sum(["a", "b"].map(|name| polarform::expr::Term {
///     sign: polarform::expr::Sign::Plus,
///     expr: Expr::name(name),
/// }).into());
/// let tree = Expr::product(vec![Expr::int(5).over(Expr::int(3)), Expr::indexed("t", 1), sum]);
/// assert_eq!(polarform::write::text(&tree), "5/3 t1 (a + b)");
/// ```
pub fn text(expr: &Expr) -> String {
    to_string(&Text, expr)
}

/// Writes what [`text()`] returns into `out`.
///
/// # Errors
/// Those of `out`.
pub fn write_text(out: &mut dyn fmt::Write, expr: &Expr) -> fmt::Result {
    walk(&Text, expr, Precedence::Sequence, out)
}

/// The value in the plain notation.
///
/// ```
/// use polarform::value::Value;
/// let list = Value::list(vec![Value::number(polarform::number::rational(5, 3)), Value::int(-1)]);
/// assert_eq!(list.to_string(), "[5/3, -1]");
/// ```
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_text(f, &self.to_expr())
    }
}

pub(super) struct Text;

impl Plain for Text {
    const ARROW: &'static str = " -> ";
    const DOTS: &'static str = "...";
    const CENTRED_DOTS: &'static str = "...";
    const FLOOR: (&'static str, &'static str) = ("floor(", ")");
    const CEIL: (&'static str, &'static str) = ("ceil(", ")");

    fn relation(rel: Rel) -> &'static str {
        match rel {
            Rel::Eq => " = ",
            Rel::Define => " := ",
            Rel::Ne => " != ",
            Rel::Lt => " < ",
            Rel::Le => " <= ",
            Rel::Gt => " > ",
            Rel::Ge => " >= ",
            Rel::Equiv => " ≡ ",
            Rel::Approx => " ≈ ",
            Rel::In => " in ",
            Rel::NotIn => " ∉ ",
            Rel::Subset => " ⊆ ",
            Rel::To | Rel::MapsTo => " -> ",
            Rel::Implies => " => ",
            Rel::Iff => " <=> ",
            Rel::Colon => ": ",
            Rel::Other(sign) => relations::of(sign).map_or(" ", |sign| sign.unicode),
        }
    }

    /// 2n in an index; elsewhere there is a blank in any case.
    fn is_tight(factor: &Expr) -> bool {
        matches!(&factor.kind, Kind::Number(value) if value.is_integer())
    }
}

impl Notation for Text {
    type Error = fmt::Error;

    fn level(&self, expr: &Expr) -> Precedence {
        plain::level(expr)
    }

    fn between(&self, joint: Joint, before: &Tail, next: &str) -> &'static str {
        let first = next.chars().next();
        match joint {
            Joint::Adjacent => match (before.last, first) {
                (Some('.'), Some('.')) => " ",
                _ => "",
            },
            Joint::Times { .. } if first.is_some_and(|c| c.is_ascii_digit() || c == '{') => "*",
            // f[x0, x1] is a divided difference
            Joint::Times { compact: false, .. }
                if first == Some('[') && before.last.is_some_and(char::is_alphabetic) =>
            {
                ""
            }
            Joint::Times { compact: false, .. } => " ",
            Joint::Times { compact: true, hint: number, .. } => match (before.last, first) {
                (_, Some('.')) | (Some('.'), _) => " ",
                // 2e is the beginning of a power of ten
                (_, Some(c)) if number && (c == '(' || c.is_alphabetic() && !matches!(c, 'e' | 'E')) => "",
                _ => "*",
            },
        }
    }

    fn expand<'a>(&self, expr: &'a Expr, out: &mut Pieces<'a>) -> fmt::Result {
        plain::expand::<Self>(expr, out);
        Ok(())
    }
}
