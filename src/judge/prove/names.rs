//! Which names of an equation stand for numbers, which for functions.

use std::collections::BTreeSet;

use crate::formula::{Accent, Expr, Kind};
use crate::language::lexicon::families::{self, Family};
use crate::language::lexicon::{letters, roles};

/// How the names of an equation are used.
#[derive(Clone, Debug, Default)]
pub struct Names {
    bare: BTreeSet<String>,
    /// Applied or primed, and not merely before a sum in parentheses.
    called: BTreeSet<String>,
    bracketed: BTreeSet<String>,
    families: BTreeSet<String>,
    arguments: Vec<Expr>,
}

impl Names {
    /// Looks through a formula.
    pub fn scan(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Name(name) => {
                self.bare.insert(name.clone());
                return;
            }
            Kind::Prime(body, _) => self.call(body),
            Kind::Apply(callee, groups) => {
                if bernstein(callee).is_some()
                    && let [group] = groups.as_slice()
                    && let [argument] = group.as_slice()
                {
                    let argument = argument.clone().without_spans();
                    if !self.arguments.contains(&argument) {
                        self.arguments.push(argument);
                    }
                }
                groups.iter().flatten().for_each(|argument| self.scan(argument));
                let sum = matches!(groups.iter().flatten().next().map(|x| &x.kind), Some(Kind::Add(_)));
                match &callee.kind {
                    Kind::Name(name) if sum => {
                        self.bracketed.insert(name.clone());
                    }
                    Kind::Name(_) => self.call(callee),
                    Kind::Subscript(_, indices) => indices.iter().for_each(|index| self.scan(index)),
                    _ => self.scan(callee),
                }
                return;
            }
            Kind::Subscript(base, indices) => {
                if let Some(family) = family(base) {
                    self.families.insert(family.to_owned());
                }
                indices.iter().for_each(|index| self.scan(index));
                return;
            }
            _ => {}
        }
        expr.for_each_child(&mut |child| self.scan(child));
    }

    fn call(&mut self, callee: &Expr) {
        if let Kind::Name(name) = &callee.kind {
            self.called.insert(name.clone());
        }
    }

    /// What Bernstein polynomials without argument are taken at: the argument of the others.
    pub fn argument(&self) -> Option<Expr> {
        match self.arguments.as_slice() {
            [] => Some(Expr::name("t")),
            [one] => Some(one.clone()),
            _ => None,
        }
    }

    /// Whether `name(x)` can only be a product: the name is used as a number elsewhere, is not
    /// a usual name of functions, and x is no single name.
    pub fn is_factor(&self, name: &str, argument: &Expr) -> bool {
        self.bare.contains(name)
            && !roles::is_function(name)
            && !self.called.contains(name)
            && name.chars().all(char::is_lowercase)
            && matches!(argument.kind, Kind::Add(_))
    }

    /// Whether `b_0(x)` can only be a product, for the same reasons.
    pub fn is_indexed_factor(&self, base: &Expr, argument: &Expr) -> bool {
        family(base).is_some_and(|name| self.families.contains(name) && is_constant_family(name))
            && matches!(argument.kind, Kind::Add(_))
    }

    /// Whether the name is somewhere applied or primed.
    pub fn is_called(&self, name: &str) -> bool {
        self.called.contains(name) || self.bracketed.contains(name)
    }
}

/// The letter of an indexed name.
fn family(base: &Expr) -> Option<&str> {
    match &base.kind {
        Kind::Name(name) => Some(name),
        Kind::Accent(_, body) => family(body),
        _ => None,
    }
}

/// Whether a name can stand for a number: a letter, not an operator such as sin or Δ.
pub fn is_letter(name: &str) -> bool {
    let capital_greek = name.len() > 1 && name.starts_with(|c: char| c.is_ascii_uppercase());
    letters::is_one_letter(name) && !capital_greek
}

/// Whether a name may stand for a matrix or a vector, whose products depend on the order or are
/// scalar products: capitals and letters with an accent.
pub fn may_be_matrix(head: &str) -> bool {
    let name = head.split('[').next().unwrap_or(head);
    name.contains('(') && !name.starts_with("e(") || name.starts_with(char::is_uppercase)
}

/// Whether an indexed name in d/dt … may be taken for a constant; f_i and B_i are functions,
/// b_i^k and b_i(t) may depend on t.
pub fn is_constant_family(head: &str) -> bool {
    let letter = head.rsplit('(').next().unwrap_or(head).trim_end_matches(')');
    !head.contains(['^', '[']) && roles::is_indexed_constant(letter)
}

/// The function under one or two dots, as in Ṗ(t) and Ṗ_n(t), with their number.
pub fn under_dots(callee: &Expr) -> Option<(Expr, u32)> {
    match &callee.kind {
        Kind::Accent(Accent::Dot, body) => Some(((**body).clone(), 1)),
        Kind::Accent(Accent::Ddot, body) => Some(((**body).clone(), 2)),
        Kind::Subscript(base, indices) => {
            let (name, order) = under_dots(base)?;
            Some((Kind::Subscript(Box::new(name), indices.clone()).into(), order))
        }
        _ => None,
    }
}

/// The parts of B_i^n, B_i^{(n)} or B_{i,j,k}^n, also with a dot or a prime.
pub struct Bernstein<'a> {
    /// The lower indices.
    pub indices: &'a [Expr],
    /// The degree.
    pub degree: &'a Expr,
    /// How many times it is differentiated.
    pub order: u32,
}

/// Reads the name of a Bernstein polynomial.
pub fn bernstein(expr: &Expr) -> Option<Bernstein<'_>> {
    match &expr.kind {
        Kind::Group(body) => bernstein(body),
        Kind::Prime(body, order) => {
            let head = bernstein(body)?;
            Some(Bernstein { order: head.order.checked_add(*order)?, ..head })
        }
        Kind::Pow(base, degree) => {
            let (indices, dots) = lower(base)?;
            let (degree, primes) = match &degree.kind {
                Kind::Prime(degree, primes) => (&**degree, *primes),
                _ => (&**degree, 0),
            };
            Some(Bernstein { indices, degree, order: dots.checked_add(primes)? })
        }
        Kind::Upper(base, upper) => {
            let (indices, order) = lower(base)?;
            match upper.as_slice() {
                // A number in parentheses could be the order of a derivative.
                [degree] if !matches!(degree.kind, Kind::Number(_)) => {
                    Some(Bernstein { indices, degree, order })
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// The indices of B_… and its number of dots and primes.
fn lower(expr: &Expr) -> Option<(&[Expr], u32)> {
    match &expr.kind {
        Kind::Prime(body, primes) => {
            let (indices, order) = lower(body)?;
            Some((indices, order.checked_add(*primes)?))
        }
        Kind::Subscript(base, indices) => {
            let (base, order) = match &base.kind {
                Kind::Accent(Accent::Dot, base) => (base, 1),
                Kind::Accent(Accent::Ddot, base) => (base, 2),
                _ => (base, 0),
            };
            let Kind::Name(name) = &base.kind else { return None };
            let family = families::notation(name, indices.len(), 1)?.family;
            matches!(family, Family::Bernstein | Family::Triangular).then_some((indices.as_slice(), order))
        }
        _ => None,
    }
}
