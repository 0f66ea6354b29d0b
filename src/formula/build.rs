//! Short constructors for computed expressions (no span).

use super::{Expr, Kind, Link, Quotient, Rel, Sign, Term};
use crate::formula::source::Span;
use crate::math::number::Rational;
use num_traits::{One, Signed, ToPrimitive};

impl Expr {
    /// An expression read at `span`.
    pub fn new(kind: Kind, span: Span) -> Self {
        Expr { kind, span }
    }

    /// A number; fractions become quotients and negative numbers a sum of one negative term,
    /// as they would be written.
    pub fn number(value: &Rational) -> Self {
        let magnitude = value.abs();
        let unsigned = if magnitude.denom().is_one() {
            Expr::from(Kind::Number(magnitude))
        } else {
            let part = |x: &crate::math::number::Int| Kind::Number(Rational::from_integer(x.clone())).into();
            Kind::Div(
                Box::new(part(magnitude.numer())),
                Box::new(part(magnitude.denom())),
                Quotient::Fraction,
            )
            .into()
        };
        if value.is_negative() { unsigned.negated() } else { unsigned }
    }

    /// Of some conditions one at least holds: a call of "or".
    pub fn any(conditions: Vec<Expr>) -> Self {
        Kind::Apply(Box::new(Expr::name("or")), vec![conditions]).into()
    }

    /// The alternatives of [`Expr::any`].
    pub fn alternatives(&self) -> Option<&[Expr]> {
        match &self.kind {
            Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if name == "or") => {
                groups.first().map(Vec::as_slice)
            }
            _ => None,
        }
    }

    /// The number written here.
    pub fn as_number(&self) -> Option<&Rational> {
        match &self.kind {
            Kind::Number(q) => Some(q),
            _ => None,
        }
    }

    /// The integer written here, without a sign.
    pub fn as_int(&self) -> Option<i64> {
        self.as_number().filter(|q| q.is_integer())?.to_i64()
    }

    /// The integer written here, with or without a sign and brackets.
    pub fn as_signed_int(&self) -> Option<i64> {
        match &self.kind {
            Kind::Group(inner) => inner.as_signed_int(),
            Kind::Add(terms) => match terms.as_slice() {
                [Term { sign: Sign::Minus, expr }] => expr.as_signed_int().map(|n| -n),
                [only] => only.expr.as_signed_int(),
                _ => None,
            },
            _ => self.as_int(),
        }
    }

    /// The items of [a, b] or (a, b).
    pub fn items(&self) -> Option<&[Expr]> {
        match &self.kind {
            Kind::List(items) | Kind::Tuple(items) => Some(items),
            _ => None,
        }
    }

    /// The elements of a list, a tuple or a set that is written out.
    pub(crate) fn elements(&self) -> Option<&[Expr]> {
        match &self.kind {
            Kind::Set(elements, None) => Some(elements),
            _ => self.items(),
        }
    }

    /// A small integer.
    pub fn int(value: i64) -> Self {
        Expr::number(&Rational::from_integer(value.into()))
    }

    /// A plain name.
    pub fn name(name: impl Into<String>) -> Self {
        Kind::Name(name.into()).into()
    }

    /// base_index
    pub fn indexed(base: impl Into<String>, index: i64) -> Self {
        Kind::Subscript(Box::new(Expr::name(base)), vec![Expr::int(index)]).into()
    }

    /// −self, as a sum of one negative term.
    pub fn negated(self) -> Self {
        Kind::Add(vec![Term { sign: Sign::Minus, expr: self }]).into()
    }

    /// A sum of signed terms; one positive term is that term itself, none is 0.
    pub fn sum(mut terms: Vec<Term>) -> Self {
        match terms.as_slice() {
            [] => Expr::int(0),
            [Term { sign: Sign::Plus, .. }] => terms.remove(0).expr,
            _ => Kind::Add(terms).into(),
        }
    }

    /// The sum with a number that is not 0: n + 1, n − 1.
    pub fn plus(self, by: i64) -> Self {
        let sign = if by < 0 { Sign::Minus } else { Sign::Plus };
        let number = Expr::int(by.abs());
        Expr::sum(vec![Term { sign: Sign::Plus, expr: self }, Term { sign, expr: number }])
    }

    /// A product; one factor is that factor itself, none is 1.
    pub fn product(mut factors: Vec<Expr>) -> Self {
        match factors.len() {
            0 => Expr::int(1),
            1 => factors.remove(0),
            _ => Kind::Mul(factors).into(),
        }
    }

    /// self^exponent
    pub fn power(self, exponent: Expr) -> Self {
        Kind::Pow(Box::new(self), Box::new(exponent)).into()
    }

    /// self / denominator as a fraction.
    pub fn over(self, denominator: Expr) -> Self {
        Kind::Div(Box::new(self), Box::new(denominator), Quotient::Fraction).into()
    }

    /// callee(arguments)
    pub fn apply(callee: Expr, arguments: Vec<Expr>) -> Self {
        Kind::Apply(Box::new(callee), vec![arguments]).into()
    }

    /// left rel right
    pub fn relation(left: Expr, rel: Rel, right: Expr) -> Self {
        Kind::Chain(Box::new(left), vec![Link { rel, span: Span::default(), expr: right }]).into()
    }

    /// (self)
    pub fn grouped(self) -> Self {
        Kind::Group(Box::new(self)).into()
    }
}

impl From<Kind> for Expr {
    fn from(kind: Kind) -> Self {
        Expr { kind, span: Span::default() }
    }
}

/// function(arguments), found wrong as a whole at `span`.
pub(crate) fn call(function: &str, arguments: Vec<Expr>, span: Span) -> Expr {
    applied(Expr::new(Kind::Name(function.to_owned()), span), arguments, span)
}

/// callee(arguments), found wrong as a whole at `span`.
pub(crate) fn applied(callee: Expr, arguments: Vec<Expr>, span: Span) -> Expr {
    Expr::new(Kind::Apply(Box::new(callee), vec![arguments]), span)
}

/// The argument `name = value` of a function.
pub(crate) fn named(name: &str, value: Expr) -> Expr {
    let span = value.span;
    let left = Expr::new(Kind::Name(name.to_owned()), span);
    Expr::new(Kind::Chain(Box::new(left), vec![Link { rel: Rel::Eq, span, expr: value }]), span)
}

/// What is added to the letter of a function that is called with brackets.
const BRACKETS: &str = "[]";

/// The name of a function that is called with brackets: b[0, 1], where b(t) is another one.
pub(crate) fn bracketed(letter: &str) -> String {
    format!("{letter}{BRACKETS}")
}

/// The letter of a function that is called with brackets, if a name is one.
pub(crate) fn before_brackets(name: &str) -> Option<&str> {
    name.strip_suffix(BRACKETS)
}

impl Expr {
    /// Whether it is the name of a function that is called with brackets.
    pub(crate) fn is_called_with_brackets(&self) -> bool {
        match &self.kind {
            Kind::Name(name) => before_brackets(name).is_some(),
            Kind::Accent(_, inner) => inner.is_called_with_brackets(),
            _ => false,
        }
    }
}

/// The ends of [a, b], (a, b), [a, b), (a, b], and which of them are left out.
pub(crate) fn interval(expr: &Expr) -> Option<([&Expr; 2], [bool; 2])> {
    let (items, open) = match &expr.kind {
        Kind::List(items) => (items, [false, false]),
        Kind::Tuple(items) => (items, [true, true]),
        Kind::Apply(kind, groups) => match &kind.kind {
            Kind::Name(name) if name == "rightopen" => (groups.first()?, [false, true]),
            Kind::Name(name) if name == "leftopen" => (groups.first()?, [true, false]),
            _ => return None,
        },
        _ => return None,
    };
    let [a, b] = items.as_slice() else { return None };
    Some(([a, b], open))
}

/// What is said of several names, said of each: u, v ∈ I as u ∈ I and v ∈ I, 0 ≤ u, v ≤ 1 as two ranges.
pub(crate) fn spread(items: Vec<Expr>) -> Vec<Expr> {
    let bare = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..));
    let ordered = |link: &Link| matches!(link.rel, Rel::Le | Rel::Lt);
    let mut found: Vec<Expr> = Vec::with_capacity(items.len());
    // Where the names begin that wait for a relation, and what stands before the first one.
    let (mut start, mut before) = (None, None);
    for item in items {
        let begins = match &item.kind {
            Kind::Chain(bound, links) => match links.as_slice() {
                [link] if ordered(link) && bare(&link.expr) && !bare(bound) => {
                    Some((bound.clone(), link.clone()))
                }
                _ => None,
            },
            _ => None,
        };
        if begins.is_some() || bare(&item) {
            if start.is_none() || begins.is_some() {
                start = Some(found.len());
                before = begins;
            }
            found.push(item);
            continue;
        }
        let Kind::Chain(left, links) = &item.kind else {
            start = None;
            found.push(item);
            continue;
        };
        let said =
            !matches!(links.first(), Some(Link { rel: Rel::Eq | Rel::Define | Rel::Implies | Rel::Iff, .. }));
        let fits = bare(left) && said && (before.is_none() || links.len() == 1 && links.iter().all(ordered));
        match start.take().filter(|_| fits) {
            Some(start) => {
                let names: Vec<Expr> = found.drain(start..).collect();
                let name = |item: Expr| match item.kind {
                    Kind::Chain(_, links) => links.into_iter().next().map(|link| link.expr),
                    _ => Some(item),
                };
                for name in names.into_iter().filter_map(name).chain([(**left).clone()]) {
                    let span = name.span;
                    let chain = match &before {
                        None => Kind::Chain(Box::new(name), links.clone()),
                        Some((bound, first)) => {
                            let first = Link { expr: name, ..first.clone() };
                            Kind::Chain(bound.clone(), std::iter::once(first).chain(links.clone()).collect())
                        }
                    };
                    found.push(Expr::new(chain, span));
                }
            }
            None => found.push(item),
        }
        before = None;
    }
    found
}
