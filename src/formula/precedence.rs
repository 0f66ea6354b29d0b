//! The one precedence table, used by both readers and all writers.

use super::{Expr, Kind, Quotient};

/// How tightly an expression holds together, from loosest to tightest.
///
/// `*`, `/` and juxtaposition have the same precedence and group from the left, so
/// `5/3 (t1 + t2)` is five thirds of the sum and `a/b c` is `(a/b) c`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Precedence {
    /// a, b
    Sequence,
    /// a = b
    Relation,
    /// t -> body
    Lambda,
    /// a..b
    Range,
    /// a + b, and a leading minus
    Sum,
    /// a b, a * b, a / b, and what has an open end: Σ, ∫, d/dt
    Product,
    /// F ∘ G, a × b
    Compose,
    /// a^b
    Power,
    /// f(x), n!, F', x_i
    Postfix,
    /// names, numbers, brackets
    Atom,
}

impl Expr {
    /// The precedence of the outermost operation.
    pub fn precedence(&self) -> Precedence {
        match &self.kind {
            Kind::Sequence(_) => Precedence::Sequence,
            Kind::Chain(..) | Kind::ForAll(..) => Precedence::Relation,
            Kind::Lambda(..) => Precedence::Lambda,
            Kind::Range(..) => Precedence::Range,
            Kind::Add(_) => Precedence::Sum,
            Kind::Mul(_)
            | Kind::Div(_, _, Quotient::Slash)
            | Kind::Big { .. }
            | Kind::Integral { .. }
            | Kind::Derivative { .. } => Precedence::Product,
            Kind::Div(_, _, Quotient::Fraction) => Precedence::Product,
            Kind::Compose(_) | Kind::Cross(_) => Precedence::Compose,
            Kind::Pow(..) | Kind::Upper(..) | Kind::Transpose(_) => Precedence::Power,
            Kind::Apply(..)
            | Kind::Factorial(_)
            | Kind::Prime(..)
            | Kind::Subscript(..)
            | Kind::At { .. } => Precedence::Postfix,
            Kind::Number(x) if !num_traits::One::is_one(x.denom()) => Precedence::Product,
            Kind::Number(x) if num_traits::Signed::is_negative(x) => Precedence::Sum,
            Kind::Number(_)
            | Kind::Name(_)
            | Kind::Accent(..)
            | Kind::Group(_)
            | Kind::Tuple(_)
            | Kind::List(_)
            | Kind::Set(..)
            | Kind::Matrix(..)
            | Kind::Binomial(..)
            | Kind::Enclosed(..)
            | Kind::Cases(_)
            | Kind::Ellipsis
            | Kind::Brace(..)
            | Kind::Text(_)
            | Kind::Unread(_) => Precedence::Atom,
        }
    }

    /// Whether this is `a mod b`, written between its two numbers.
    pub fn is_remainder(&self) -> bool {
        let Kind::Apply(callee, groups) = &self.kind else { return false };
        let [arguments] = groups.as_slice() else { return false };
        let between = arguments.first().is_some_and(|first| first.span.start < callee.span.start);
        between && matches!(&callee.kind, Kind::Name(name) if name == "mod")
    }

    /// Whether this and what is set beside it could be a mixed number: in print `3\tfrac12`, a whole number before a
    /// proper fraction of two numbers, is 3 + 1/2 for some and 3 · 1/2 for others. Cost: O(1).
    pub fn is_mixed_with(&self, next: &Expr) -> bool {
        let last = if let Kind::Cross(factors) = &self.kind { factors.last() } else { Some(self) };
        let first = if let Kind::Cross(factors) = &next.kind { factors.first() } else { Some(next) };
        let (Some(last), Some(first)) = (last, first) else { return false };
        let (Kind::Number(whole), Kind::Div(above, below, Quotient::Fraction)) = (&last.kind, &first.kind)
        else {
            return false;
        };
        match (&above.kind, &below.kind) {
            (Kind::Number(above), Kind::Number(below)) => {
                [whole, above, below].iter().all(|number| number.is_integer()) && above < below
            }
            _ => false,
        }
    }
}
