//! The lists of a paragraph, and what they are lists of.

use super::Page;
use super::read::closed;
use super::signs::{Sign, sentence_end, sentence_start};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::object::Sort;
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::notes::speech::Hint;

/// What a list is of.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Role {
    Points,
    Knots,
    Nodes,
    /// Values at nodes.
    Values(Vec<Expr>),
    /// Values of an index.
    Index,
    /// Nothing says it.
    Open,
}

/// The letter of lists of points with letters of their own: A, B, C.
const POINTS: &str = "";

/// Members of one family, or numbers or points.
#[derive(Clone, Debug)]
pub(super) struct List {
    /// The letter of the family.
    pub letter: Option<String>,
    pub items: Vec<Expr>,
    pub role: Role,
    /// The first sign and the one after it.
    pub at: usize,
    pub to: usize,
    /// Whether only equations give its members.
    equations: bool,
}

impl List {
    /// All points of a letter of which the page lists none.
    pub fn unlisted(letter: &str) -> List {
        let items = vec![member(letter, Expr::name("i"))];
        List { letter: Some(letter.to_owned()), items, role: Role::Points, at: 0, to: 0, equations: false }
    }

    /// The degree of a polynomial with these control points, if the list tells it.
    pub fn degree(&self) -> Option<i64> {
        let index = |item: &Expr| Head::of(item)?.index()?.as_int();
        match (&self.letter, self.items.as_slice()) {
            (None, items) => Some(items.len() as i64 - 1),
            (Some(_), [_]) => None,
            (Some(_), [first, .., last]) => (index(first)? == 0).then(|| index(last)).flatten(),
            _ => None,
        }
    }

    /// Whether its members are numbered from 0 on, without a gap, or by any index.
    fn is_whole(&self) -> bool {
        let index = |item: &Expr| Head::of(item)?.index().cloned();
        let numbers: Vec<Option<i64>> = self.items.iter().map(|item| index(item)?.as_int()).collect();
        let dots = self.items.iter().any(|item| item.kind == Kind::Ellipsis);
        match self.items.as_slice() {
            [one] => index(one)
                .is_some_and(|index| matches!(&index.kind, Kind::Name(name) if is_index_letter(name))),
            _ if dots => numbers.first() == Some(&Some(0)),
            _ => numbers.iter().enumerate().all(|(at, number)| *number == Some(at as i64)),
        }
    }
}

/// b_i
pub(super) fn member(letter: &str, index: Expr) -> Expr {
    Kind::Subscript(Box::new(Expr::name(letter)), vec![index]).into()
}

/// An item of a list: its letter, or none for a number or a point; whether an equation gives it.
fn item(expr: &Expr) -> Option<(Option<String>, Expr, bool)> {
    let member = |expr: &Expr| {
        let head = Head::of(expr).filter(|head| head.arguments.is_none() && head.upper.is_empty())?;
        (head.lower.len() == 1).then_some(head.base)
    };
    let point = |expr: &Expr| {
        let capital = |name: &str| name.len() == 1 && name.starts_with(char::is_uppercase);
        matches!(&expr.kind, Kind::Name(name) if capital(name))
    };
    match &expr.kind {
        // A = (0, 0), B = (1, 3)
        Kind::Chain(left, links) if links.len() == 1 && links[0].rel == Rel::Eq && point(left) => {
            Some((Some(POINTS.to_owned()), left.as_ref().clone(), true))
        }
        Kind::Name(_) if point(expr) => Some((Some(POINTS.to_owned()), expr.clone(), false)),
        Kind::Chain(left, links) if links.len() == 1 && links[0].rel == Rel::Eq => {
            Some((Some(member(left)?), left.as_ref().clone(), true))
        }
        Kind::Chain(..) => None,
        _ if bases(expr).is_empty() && expr.kind != Kind::Ellipsis && closed(expr).is_none() => {
            Some((None, expr.clone(), false))
        }
        _ => Some((Some(member(expr)?), expr.clone(), false)),
    }
}

/// The lists of a paragraph in their order.
pub(super) fn lists(all: &[Sign], page: &Page) -> Vec<List> {
    let mut found: Vec<List> = Vec::new();
    let mut open = false;
    for (at, sign) in all.iter().enumerate() {
        let items: Vec<Expr> = match sign {
            Sign::Join => continue,
            Sign::Number(number) => vec![Expr::int(*number)],
            Sign::Formula(number) => match page.said(*number) {
                // (l_0, l_1, l_2) = …
                [Expr { kind: Kind::Chain(left, _), .. }]
                    if left.items().is_some_and(|items| items.len() > 2) =>
                {
                    left.items().unwrap_or_default().to_vec()
                }
                said => said.to_vec(),
            },
            _ => {
                open = false;
                continue;
            }
        };
        for expr in items {
            if expr.kind == Kind::Ellipsis {
                if let Some(last) = found.last_mut().filter(|_| open) {
                    last.items.push(expr);
                    last.to = at + 1;
                }
                continue;
            }
            let Some((letter, own, equation)) = item(&expr) else {
                open = false;
                continue;
            };
            match found.last_mut().filter(|last| open && last.letter == letter) {
                // b_0, …, b_3, where b_1 = b_0
                Some(last)
                    if equation
                        && last
                            .items
                            .iter()
                            .any(|item| item.kind == Kind::Ellipsis || item.same_as(&own)) => {}
                Some(last) => {
                    last.items.push(own);
                    last.to = at + 1;
                    last.equations &= equation;
                }
                None => found.push(List {
                    letter,
                    items: vec![own],
                    role: Role::Open,
                    at,
                    to: at + 1,
                    equations: equation,
                }),
            }
            open = true;
        }
    }
    found
        .retain(|list| !list.equations && (list.items.len() > 1 || list.letter.is_some() && list.is_whole()));
    // b_0, …, b_3 again
    let mut unique: Vec<List> = Vec::new();
    for list in found {
        let known = |other: &List| other.letter.is_some() && other.letter == list.letter;
        if !unique.iter().any(known) {
            unique.push(list);
        }
    }
    let mut found = unique;
    let ends: Vec<(usize, usize)> = found.iter().map(|list| (list.at, list.to)).collect();
    for (number, list) in found.iter_mut().enumerate() {
        let before = number.checked_sub(1).map_or(0, |last| ends[last].1);
        let after = ends.get(number + 1).map_or(all.len(), |next| next.0);
        list.role = role(all, list, before, after);
    }
    values_at_nodes(all, found)
}

/// What a list is of: by the nearest noun before it, else after it, in its sentence.
fn role(all: &[Sign], list: &List, before: usize, after: usize) -> Role {
    let of = |sign: &Sign| match sign {
        Sign::Hint(Hint::Points) => Some(Role::Points),
        Sign::Knots => Some(Role::Knots),
        Sign::Nodes => Some(Role::Nodes),
        _ => None,
    };
    let (start, end) = (sentence_start(all, list.at), sentence_end(all, list.to));
    let found = |signs: &mut dyn Iterator<Item = &Sign>| {
        let mut distance = 0;
        for sign in signs {
            if let Some(role) = of(sign) {
                return Some((distance, role));
            }
            // A comma parts more than a word.
            distance += if *sign == Sign::Join { 3 } else { 1 };
        }
        None
    };
    let before = before.max(start).min(list.at);
    let (after, next) = (after.max(list.to), end.min(after).max(list.to));
    let left = found(&mut all[before..list.at].iter().rev());
    let right = found(&mut all[list.to..next].iter());
    // "Whose knots are the integers, and let c_j be its coefficient"
    let nearest = match (left, right) {
        (Some((before, _)), Some((after, role))) if after + 1 < before => Some(role),
        (Some((_, role)), _) | (None, Some((_, role))) => Some(role),
        (None, None) => None,
    };
    // l_0, …, l_3 and r_0, …, r_3 are the points
    let shared = || {
        let joined = all[list.to..after].iter().all(|sign| matches!(sign, Sign::Join | Sign::Filler));
        (joined && after < end).then(|| all[after..end].iter().find_map(of)).flatten()
    };
    // b_0, …, b_2 the points of a curve over [0, 1] and c_0, …, c_2 those over [0, 2]
    let those = || {
        let near = all[list.to..next].iter().take(3).any(|sign| *sign == Sign::Its);
        let part = |sign: &Sign| matches!(sign, Sign::Hint(Hint::First | Hint::Second));
        let other = all[before..list.at].iter().any(part);
        (near || other).then(|| all[start..list.at].iter().rev().find_map(of)).flatten()
    };
    // a B-spline over 0, 0, 0, 1, 2, 2, 2
    let spline = all.iter().any(|sign| matches!(sign, Sign::Curve(Sort::BSpline | Sort::SplineCurve)));
    let over = || {
        let on = spline && list.at.checked_sub(1).is_some_and(|before| all[before] == Sign::On);
        (on && list.letter.is_none() && list.items.len() > 3).then_some(Role::Knots)
    };
    let indexed = || {
        let index = matches!(list.items.as_slice(), [one] if Head::of(one).is_some());
        index.then_some(Role::Index)
    };
    let own = match over() {
        Some(knots) => Some(knots),
        None => nearest.or_else(those).or_else(shared).or_else(indexed),
    };
    let whole = list.letter.is_none() || list.is_whole();
    match own {
        // "Through the points (0, 1), (1, 2)": no control points
        Some(Role::Points) if !whole || all[start..list.at].contains(&Sign::Hint(Hint::Through)) => {
            Role::Open
        }
        own => own.unwrap_or(Role::Open),
    }
}

/// "Through y_0, y_1, y_2 at 0, 1/2, 1": the second list has the nodes of the first.
fn values_at_nodes(all: &[Sign], mut found: Vec<List>) -> Vec<List> {
    let through =
        |list: &List| all[sentence_start(all, list.at)..list.at].contains(&Sign::Hint(Hint::Through));
    for at in 1..found.len() {
        let (values, nodes) = (&found[at - 1], &found[at]);
        let between = all.get(values.to..nodes.at).unwrap_or_default();
        let at_nodes = between.contains(&Sign::On) && !between.contains(&Sign::End);
        let dots = |list: &List| list.items.iter().any(|item| item.kind == Kind::Ellipsis);
        let alike = values.items.len() == nodes.items.len() && !dots(values) && !dots(nodes);
        if at_nodes && alike && through(values) && nodes.role != Role::Knots {
            let items = found.remove(at).items;
            found[at - 1].role = Role::Values(items);
            break;
        }
    }
    found
}
