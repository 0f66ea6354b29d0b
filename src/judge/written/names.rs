//! Names as written: heads of definitions and calls, names that stand for integers.

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::formula::{Accent, BigOp, Expr, Kind, Rel, before_brackets, bracketed};
use crate::language::lexicon::families::{self, Family, Notation};
use crate::language::lexicon::roles;
pub(crate) use crate::language::lexicon::roles::is_index_letter;
use crate::language::write;
use crate::math::poly::Symbol;

/// A name with its indices and arguments, as it stands on the left of a definition or in a call.
#[derive(Clone, Debug)]
pub struct Head {
    /// The letter, with its mark: "P", "hat v".
    pub base: String,
    /// The indices below.
    pub lower: Vec<Expr>,
    /// The indices above.
    pub upper: Vec<Expr>,
    /// Whether the upper index stands in parentheses: f^{(2)}.
    pub parenthesized: bool,
    /// The arguments by groups; `None` if it is not applied to anything.
    pub arguments: Option<Vec<Vec<Expr>>>,
}

impl Head {
    /// Its index below, if that is the only one there.
    pub fn index(&self) -> Option<&Expr> {
        match self.lower.as_slice() {
            [index] => Some(index),
            _ => None,
        }
    }

    /// Whether it is a letter alone, without indices and arguments.
    pub(in crate::judge) fn is_bare(&self) -> bool {
        self.lower.is_empty() && self.upper.is_empty() && self.arguments.is_none()
    }

    /// The standard notation that it is written in, if it has one.
    pub(crate) fn notation(&self) -> Option<&'static Notation> {
        if self.has_its_degree_below() {
            return None;
        }
        families::notation(&self.base, self.lower.len(), self.upper.len())
    }

    /// B_n^i, where others write B_i^n.
    pub(in crate::judge) fn has_its_degree_below(&self) -> bool {
        match (self.lower.as_slice(), self.upper.as_slice()) {
            ([Expr { kind: Kind::Name(below), .. }], [Expr { kind: Kind::Name(above), .. }]) => {
                roles::is_size(below) && is_index_letter(above) && !roles::is_size(above)
            }
            _ => false,
        }
    }

    /// Whether it is a member of a family with a standard meaning.
    pub(in crate::judge) fn is_a(&self, family: Family) -> bool {
        self.notation().is_some_and(|notation| notation.family == family)
    }

    /// Whether it is a Bernstein polynomial, of an interval or a triangle.
    pub(in crate::judge) fn is_bernstein(&self) -> bool {
        self.is_a(Family::Bernstein) || self.is_a(Family::Triangular)
    }

    /// Takes a name apart; `None` for anything else.
    pub fn of(expr: &Expr) -> Option<Head> {
        match &expr.kind {
            Kind::Name(name) => Some(Head {
                base: name.clone(),
                lower: Vec::new(),
                upper: Vec::new(),
                parenthesized: false,
                arguments: None,
            }),
            Kind::Accent(Accent::Bold | Accent::Script | Accent::Blackboard, body) => Head::of(body),
            Kind::Accent(accent @ (Accent::Hat | Accent::Bar | Accent::Vec | Accent::Tilde), body) => {
                let mut head = Head::of(body).filter(|head| head.arguments.is_none())?;
                head.base = format!("{} {}", accent.name(), head.base);
                Some(head)
            }
            Kind::Subscript(base, lower) => {
                let mut head = Head::of(base).filter(|head| head.lower.is_empty())?;
                head.lower = lower.iter().flat_map(split).collect();
                head.arguments.is_none().then_some(head)
            }
            Kind::Pow(base, upper) => {
                let mut head = Head::of(base)?;
                if !head.upper.is_empty() || head.arguments.is_some() {
                    return None;
                }
                // b_i^* is no member of the family b.
                match is_star(upper) && !head.base.contains(' ') {
                    true => head.base = format!("{STAR} {}", head.base),
                    false => head.upper = vec![upper.as_ref().clone()],
                }
                Some(head)
            }
            Kind::Upper(base, upper) => {
                let mut head = Head::of(base)?;
                if !head.upper.is_empty() || head.arguments.is_some() {
                    return None;
                }
                head.upper = upper.clone();
                head.parenthesized = true;
                Some(head)
            }
            Kind::Apply(callee, groups) => {
                let mut head = Head::of(callee)?;
                if head.arguments.is_some() {
                    return None;
                }
                head.arguments = Some(groups.clone());
                Some(head)
            }
            Kind::Group(inner) => operator(inner),
            _ => None,
        }
    }

    /// Whether both are written alike.
    pub(in crate::judge) fn same_as(&self, other: &Head) -> bool {
        let alike = |own: &[Expr], other: &[Expr]| {
            own.len() == other.len() && own.iter().zip(other).all(|(a, b)| a.same_as(b))
        };
        let (own, theirs) = (self.flat(), other.flat());
        self.base == other.base
            && alike(&self.lower, &other.lower)
            && alike(&self.upper, &other.upper)
            && own.len() == theirs.len()
            && own.iter().zip(theirs).all(|(a, b)| a.same_as(b))
    }

    /// The arguments, groups run together.
    pub fn flat(&self) -> Vec<&Expr> {
        self.arguments.iter().flatten().flatten().collect()
    }
}

/// The letter of the function whose polar form has a name: F of f, b of b[…].
pub fn capital_of(base: &str) -> String {
    if let Some(function) = before_brackets(base) {
        return function.to_owned();
    }
    let mut letters = base.chars();
    let first = letters.next();
    first.into_iter().flat_map(char::to_uppercase).chain(letters).collect()
}

/// Whether a name is a capital letter, and not that of a polar form.
pub(in crate::judge) fn is_capital(base: &str) -> bool {
    base.starts_with(char::is_uppercase) && before_brackets(base).is_none()
}

/// The names that the polar form of a function may have, if they are not its own: f of F, b[…] of b.
pub(in crate::judge) fn polar_names(base: &str) -> impl Iterator<Item = String> {
    [base.to_lowercase(), bracketed(base)].into_iter().filter(move |name| name != base)
}

/// The mark of names such as b^*.
const STAR: &str = "star";

/// Whether an upper index only makes another name of a letter.
pub(in crate::judge) fn is_star(upper: &Expr) -> bool {
    matches!(&upper.kind, Kind::Name(name) if matches!(name.as_str(), "ast" | "star"))
}

/// (B_n f)(x): an operator with an index, and what it is applied to, make one name.
fn operator(product: &Expr) -> Option<Head> {
    let (mut head, function) = operated(product)?;
    head.base = format!("{}[{}]", head.base, write::text(function));
    Some(head)
}

/// The operator of B_n f, and the function.
pub(in crate::judge) fn operated(product: &Expr) -> Option<(Head, &Expr)> {
    let Kind::Mul(factors) = &product.kind else { return None };
    let [operator, function] = factors.as_slice() else { return None };
    let plain = |head: &Head| head.arguments.is_none() && head.upper.is_empty();
    let head = Head::of(operator).filter(|head| plain(head) && head.lower.len() == 1)?;
    Head::of(function).filter(plain)?;
    Some((head, function))
}

/// The index 01 stands for 0, 1: a number of a row and one of a column; so does ij for i, j.
fn split(index: &Expr) -> Vec<Expr> {
    let letter = |factor: &Expr| matches!(&factor.kind, Kind::Name(name) if is_index_letter(name));
    match &index.kind {
        Kind::Mul(factors) if factors.iter().all(letter) => factors.clone(),
        // b_{n00}
        Kind::Mul(factors) if factors.iter().all(|factor| letter(factor) || zeros(factor).is_some()) => {
            let apart = |factor: &Expr| match zeros(factor) {
                Some(count) => vec![Expr::new(Expr::int(0).kind, factor.span); count],
                None => vec![factor.clone()],
            };
            factors.iter().flat_map(apart).collect()
        }
        Kind::Name(word) if word.len() > 1 && word.bytes().all(|b| b.is_ascii_digit()) => {
            word.bytes().map(|b| Expr::new(Expr::int(i64::from(b - b'0')).kind, index.span)).collect()
        }
        _ => vec![index.clone()],
    }
}

/// How many zeros stand in a row: 2 for 00.
fn zeros(factor: &Expr) -> Option<usize> {
    match &factor.kind {
        Kind::Number(q) if num_traits::Zero::is_zero(q) => Some(1),
        Kind::Name(word) if word.bytes().all(|b| b == b'0') => Some(word.len()),
        _ => None,
    }
}

/// The names of an expression that must be integers for it to make sense: in bounds, binomials,
/// factorials, indices, exponents and counts. Names bound by sums are left out.
pub fn integer_names(expr: &Expr) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    collect(expr, Position::Free, &mut found);
    found
}

#[derive(Clone, Copy, PartialEq)]
enum Position {
    Free,
    /// Here only letters usual for indices count.
    Index,
    /// Here every name is an integer.
    Integer,
}

fn collect(expr: &Expr, position: Position, found: &mut BTreeSet<String>) {
    match &expr.kind {
        Kind::Name(name) => {
            let usual = is_index_letter(name);
            if position == Position::Integer && name.chars().count() == 1 && name != "T"
                || position == Position::Index && usual
            {
                found.insert(name.clone());
            }
        }
        Kind::Subscript(base, lower) => {
            collect(base, Position::Free, found);
            lower.iter().for_each(|index| collect(index, Position::Index, found));
        }
        Kind::Upper(base, upper) => {
            collect(base, Position::Free, found);
            upper.iter().for_each(|index| collect(index, Position::Index, found));
        }
        Kind::Pow(base, exponent) => {
            collect(base, position, found);
            let index = if position == Position::Free { Position::Index } else { position };
            let symbolic = matches!(exponent.kind, Kind::Name(_) | Kind::Add(_) | Kind::Mul(_));
            collect(exponent, if symbolic { index } else { Position::Index }, found);
        }
        Kind::Binomial(n, k, _) => {
            collect(n, Position::Integer, found);
            collect(k, Position::Integer, found);
        }
        Kind::Factorial(body) => collect(body, Position::Integer, found),
        // gcd(a, b) is that of integers, gcd(t^2 - 1, t - 1) one of polynomials.
        Kind::Apply(callee, groups) if is_gcd(callee) => {
            let whole = !groups.iter().flatten().any(names_a_parameter);
            let position = if whole { Position::Integer } else { position };
            groups.iter().flatten().for_each(|item| collect(item, position, found));
        }
        Kind::Apply(callee, groups) if is_extreme(callee) => {
            groups.iter().flatten().for_each(|item| collect(item, position, found));
        }
        // 1² + 2² + … + n²: what the dots lead to
        Kind::Add(terms) if terms.iter().any(|term| term.expr.kind == Kind::Ellipsis) => {
            let mut led_to = false;
            for term in terms {
                let position = if led_to && position == Position::Free { Position::Index } else { position };
                collect(&term.expr, position, found);
                led_to = term.expr.kind == Kind::Ellipsis;
            }
        }
        Kind::Range(from, to) => {
            collect(from, Position::Integer, found);
            collect(to, Position::Integer, found);
        }
        Kind::Brace(items, label) => {
            items.iter().for_each(|item| collect(item, position, found));
            label.iter().for_each(|label| collect(label, Position::Integer, found));
        }
        Kind::Derivative { variables, body, .. } => {
            for (_, order) in variables {
                order.iter().for_each(|order| collect(order, Position::Integer, found));
            }
            body.iter().for_each(|body| collect(body, position, found));
        }
        Kind::Big { lower, upper, body, op } => {
            let mut inner = BTreeSet::new();
            let mut own = own_names(lower);
            collect(body, position, &mut inner);
            for piece in lower {
                match &piece.kind {
                    Kind::Chain(left, links) => {
                        if !matches!(links[0].rel, Rel::Subset | Rel::In | Rel::NotIn) {
                            collect(left, Position::Integer, &mut inner);
                        }
                        let bounds = links.iter().filter(|link| !matches!(link.rel, Rel::In | Rel::NotIn));
                        bounds.for_each(|link| collect(&link.expr, Position::Integer, &mut inner));
                    }
                    _ if upper.is_some() => collect(piece, Position::Integer, &mut inner),
                    _ => {}
                }
            }
            if own.is_empty() && matches!(op, BigOp::Sum | BigOp::Product) {
                own.extend(implied_index(body));
            }
            if let Some(upper) = upper {
                collect(upper, Position::Integer, &mut inner);
            }
            found.extend(inner.into_iter().filter(|name| !own.contains(name)));
        }
        Kind::Integral { lower, upper, body, .. } => {
            for part in lower.iter().chain(upper).chain([body]) {
                collect(part, position, found);
            }
        }
        Kind::Cases(cases) => {
            for (value, condition) in cases {
                collect(value, position, found);
                if let Some(condition) = condition {
                    collect(condition, Position::Index, found);
                }
            }
        }
        _ => expr.for_each_child(&mut |child| collect(child, position, found)),
    }
}

/// Whether a part of a formula is a member of a family with a standard meaning.
pub(in crate::judge) fn is_standard(part: &Expr) -> bool {
    Head::of(part).is_some_and(|head| head.notation().is_some())
}

/// Whether what is applied picks the greatest or least of some numbers.
pub(in crate::judge) fn is_extreme(callee: &Expr) -> bool {
    matches!(&callee.kind, Kind::Name(name) if name == "max" || name == "min")
}

/// Whether an expression is the name of the greatest common divisor.
pub(in crate::judge) fn is_gcd(callee: &Expr) -> bool {
    matches!(&callee.kind, Kind::Name(name) if name == "gcd")
}

/// Whether a parameter such as t stands in an expression.
pub(in crate::judge) fn names_a_parameter(expr: &Expr) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        found |= matches!(&part.kind, Kind::Name(name) if roles::is_parameter(name));
    });
    found
}

/// Whether a name occurs where no sum or product runs over it.
pub fn has_free(expr: &Expr, name: &str) -> bool {
    match &expr.kind {
        Kind::Name(own) => own == name,
        Kind::Big { lower, .. } if own_names(lower).iter().any(|own| own == name) => false,
        _ => {
            let mut found = false;
            expr.for_each_child(&mut |child| found = found || has_free(child, name));
            found
        }
    }
}

/// The names that a sum or product runs over.
pub fn own_names(lower: &[Expr]) -> Vec<String> {
    let mut own = Vec::new();
    for piece in lower {
        match &piece.kind {
            Kind::Name(name) => own.push(name.clone()),
            Kind::Chain(left, links) => match (&left.kind, links.len()) {
                (Kind::Name(name), 1) => own.push(name.clone()),
                // |S| = k
                (Kind::Enclosed(_, set), 1) => {
                    if let Kind::Name(name) = &set.kind {
                        own.push(name.clone());
                    }
                }
                (Kind::Add(terms), _) => own.extend(terms.iter().filter_map(|term| match &term.expr.kind {
                    Kind::Name(name) => Some(name.clone()),
                    _ => None,
                })),
                (_, 2) => {
                    if let Kind::Name(name) = &links[0].expr.kind {
                        own.push(name.clone());
                    }
                }
                _ => {}
            },
            Kind::Sequence(items) | Kind::Tuple(items) => {
                own.extend(own_names(items));
            }
            _ => {}
        }
    }
    own
}

/// The index of a sum that names none: the first letter that is an index in its body.
pub fn implied_index(body: &Expr) -> Option<String> {
    let mut found = None;
    walk(body, &mut |expr| {
        if found.is_some() {
            return;
        }
        if let Kind::Subscript(_, lower) | Kind::Upper(_, lower) = &expr.kind {
            found = lower.iter().find_map(|index| match &index.kind {
                Kind::Name(name) if is_index_letter(name) => Some(name.clone()),
                _ => None,
            });
        }
    });
    // u_{ij} under a sum over j and the like keep their last letter.
    found
}

/// Calls `visit` on the expression and everything in it.
pub fn walk<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    visit(expr);
    expr.for_each_child(&mut |child| walk(child, visit));
}

/// The letter of a name without its marks: b for "hat b" and for b(1).
pub(in crate::judge) fn letter_of(base: &str) -> &str {
    let bare = base.rsplit(' ').next().unwrap_or(base);
    bare.split('(').next().unwrap_or(bare)
}

/// Whether a formula is a part of another one.
pub fn contains(whole: &Expr, sought: &Expr) -> bool {
    let mut found = false;
    walk(whole, &mut |part| found |= part.same_as(sought));
    found
}

/// Whether a member of a family with one of these letters stands in an expression: t_i.
pub fn has_members(expr: &Expr, letters: &[String]) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        found |= matches!(part.kind, Kind::Subscript(..) | Kind::Upper(..))
            && Head::of(part).is_some_and(|head| !head.lower.is_empty() && letters.contains(&head.base));
    });
    found
}

/// Whether a condition is no equation but a range, an inequality, a membership.
pub fn is_range(condition: &Expr) -> bool {
    !matches!(&condition.kind, Kind::Chain(_, links) if links.iter().any(|link| link.rel == Rel::Eq))
}

/// The base of the names that stand for a symbol: "hat v".
pub(in crate::judge) fn base_of(symbol: &Symbol) -> Cow<'_, str> {
    match symbol.accent() {
        "" => Cow::Borrowed(symbol.base()),
        accent => Cow::Owned(format!("{accent} {}", symbol.base())),
    }
}

/// The symbol of a base, without indices.
pub(in crate::judge) fn symbol_of(base: &str) -> Symbol {
    match base.split_once(' ') {
        Some((accent, base)) => Symbol::new(base).with_accent(accent),
        None => Symbol::new(base),
    }
}

/// The bases of all names in an expression.
pub fn bases(expr: &Expr) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    walk(expr, &mut |part| match &part.kind {
        Kind::Name(name) => {
            found.insert(name.clone());
        }
        Kind::Pow(_, upper) if !is_star(upper) => {}
        Kind::Accent(..) | Kind::Pow(..) => {
            if let Some(head) = Head::of(part) {
                found.insert(head.base);
            }
        }
        _ => {}
    });
    found
}

/// Whether one of two factors is a name and the other a bracket of nodes: f[x_0, x_1], and [x_0, x_1]f, for which it
/// is true.
pub fn bracket_beside_name(first: &Expr, second: &Expr) -> Option<bool> {
    // (fg)[x_0, …, x_n], too
    let combined = |expr: &Expr| match &expr.kind {
        Kind::Group(inner) => matches!(inner.kind, Kind::Mul(_) | Kind::Add(_)),
        _ => false,
    };
    let name = |expr: &Expr| {
        combined(expr) || Head::of(expr).is_some_and(|head| head.arguments.is_none() && head.upper.is_empty())
    };
    let is_node = |item: &Expr| matches!(item.kind, Kind::Subscript(..));
    let nodes = |expr: &Expr| match &expr.kind {
        Kind::List(items) => items.len() > 1 || items.first().is_some_and(is_node),
        _ => false,
    };
    // The reader makes f[x_0], with one node, a product with a bracket.
    let one = matches!(&second.kind, Kind::Group(inner) if is_node(inner));
    // [x_0, …, x_n](fg), but in [0, 1](a + b) it may be an interval.
    let members = |expr: &Expr| match &expr.kind {
        Kind::List(items) => items.iter().all(|item| is_node(item) || item.kind == Kind::Ellipsis),
        _ => false,
    };
    let before = nodes(first) && name(second) && (!combined(second) || members(first));
    match (name(first) && (nodes(second) || one && !combined(first)), before) {
        (true, _) => Some(false),
        (false, true) => Some(true),
        _ => None,
    }
}

/// The name under which a derivative of a function is known of which the page says nothing else: x'' for x.
pub(in crate::judge) fn primed(function: &str, order: usize) -> String {
    format!("{function}{}", "'".repeat(order))
}

/// A function without the marks of derivatives: F of F'(t), also with dots.
pub fn underived(callee: &Expr) -> &Expr {
    match &callee.kind {
        Kind::Prime(function, _) | Kind::Accent(Accent::Dot | Accent::Ddot, function) => underived(function),
        _ => callee,
    }
}

/// Whether a name is called as a function in a formula.
pub fn calls(expr: &Expr, base: &str) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        if let Kind::Apply(callee, _) = &part.kind {
            let inner = match &callee.kind {
                Kind::Prime(inner, _) => inner,
                _ => callee,
            };
            found = found || Head::of(inner).is_some_and(|head| head.base == base);
        }
    });
    found
}
