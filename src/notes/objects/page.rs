//! What the formulas of a page say, for whoever looks at paragraphs or sections as a whole.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::contact::numbers;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::page::statement::{Place, Said, Statement};
use crate::judge::page::topic::Topics;
use crate::judge::written::names::Head;
use crate::notes::sentence::Piece;
use crate::notes::speech;

/// What the formulas of the page say, by their numbers, and where they stand.
pub(super) struct Page<'a> {
    pub formulas: &'a BTreeMap<usize, Vec<Expr>>,
    pub places: &'a BTreeMap<usize, Place>,
}

impl Page<'_> {
    pub fn said(&self, number: usize) -> &[Expr] {
        self.formulas.get(&number).map_or(&[], Vec::as_slice)
    }
}

/// The sentences of one section that have formulas, with the numbers of these.
#[derive(Default)]
pub(super) struct Section<'a> {
    pub topics: Topics,
    pub numbers: Vec<usize>,
    pub sentences: Vec<&'a [Piece]>,
}

impl Section<'_> {
    /// Its words, piece by piece.
    pub fn words(&self) -> impl Iterator<Item = &str> {
        self.sentences.iter().flat_map(|sentence| words(sentence))
    }
}

fn words(sentence: &[Piece]) -> impl Iterator<Item = &str> {
    sentence.iter().filter_map(|piece| match piece {
        Piece::Words(words) => Some(words.as_str()),
        Piece::Formula(_) => None,
    })
}

/// The sections of a page.
///
/// Cost: linear in the words, times the number of topics.
pub(super) fn sections<'a>(sentences: &'a [Vec<Piece>], page: &Page) -> Vec<Section<'a>> {
    let mut found: BTreeMap<&[u32], Section> = BTreeMap::new();
    for sentence in sentences {
        let own = numbers(sentence);
        let Some(place) = own.first().and_then(|number| page.places.get(number)) else { continue };
        let section = found.entry(&place.scope).or_default();
        section.numbers.extend(own);
        section.sentences.push(sentence);
        words(sentence).for_each(|words| speech::topics(words, &mut section.topics));
    }
    found.into_values().collect()
}

/// What the formula with a number says, in its parts.
pub(super) fn formulas(statements: &[Statement]) -> BTreeMap<usize, Vec<Expr>> {
    let mut found: BTreeMap<usize, Vec<Expr>> = BTreeMap::new();
    for statement in statements {
        let expr = match &statement.said {
            Said::Chain(chain) => chain.whole(),
            Said::Condition(side) | Said::Bare(side, _) => side.expr.clone(),
            _ => continue,
        };
        let own = found.entry(statement.place.formula).or_default();
        if let Some(members) = members_of_sequence(&expr) {
            own.extend(members);
            continue;
        }
        match expr.kind {
            Kind::Sequence(items) => own.extend(items),
            Kind::Chain(first, links) if is_ordered(&first, &links) => {
                own.push(*first);
                own.extend(links.into_iter().map(|link| link.expr));
            }
            _ => own.push(expr),
        }
    }
    found
}

/// The members of a sequence: t_i of (t_i)_{i ∈ ℤ}, and t_0, …, t_m of {t_i}_{i=0}^m.
fn members_of_sequence(expr: &Expr) -> Option<Vec<Expr>> {
    let whole = match &expr.kind {
        // t = (t_i)
        Kind::Chain(first, links) => match (&first.kind, links.as_slice()) {
            (Kind::Name(_), [link]) if matches!(link.rel, Rel::Eq | Rel::Define) => &link.expr,
            _ => return None,
        },
        _ => expr,
    };
    let (below, upper) = match &whole.kind {
        Kind::Upper(below, upper) => (below.as_ref(), upper.as_slice()),
        _ => (whole, [].as_slice()),
    };
    let (inside, lower) = match &below.kind {
        Kind::Subscript(inside, lower) => (inside.as_ref(), lower.as_slice()),
        _ => (below, [].as_slice()),
    };
    let member = match &inside.kind {
        Kind::Group(one) => one.as_ref(),
        Kind::Set(items, None) | Kind::Tuple(items) | Kind::List(items) => match items.as_slice() {
            [one] => one,
            _ => return None,
        },
        _ => return None,
    };
    let Kind::Subscript(letter, indices) = &member.kind else { return None };
    let [Expr { kind: Kind::Name(index), .. }] = indices.as_slice() else { return None };
    let at = |end: &Expr| Expr::new(Kind::Subscript(letter.clone(), vec![end.clone()]), member.span);
    let from = lower.iter().find_map(|range| match &range.kind {
        Kind::Chain(own, links) if matches!(&own.kind, Kind::Name(name) if name == index) => {
            match links.as_slice() {
                [link] if link.rel == Rel::Eq => Some(&link.expr),
                _ => None,
            }
        }
        _ => None,
    });
    Some(match (from, upper) {
        (Some(from), [to]) => vec![at(from), Kind::Ellipsis.into(), at(to)],
        _ => vec![member.clone()],
    })
}

/// What formulas say of each member: (b_0, b_1, b_2) = (1, 4, 2) is b_0 = 1, b_1 = 4, b_2 = 2.
pub(super) fn by_members(formulas: &BTreeMap<usize, Vec<Expr>>) -> Cow<'_, BTreeMap<usize, Vec<Expr>>> {
    let apart = |said: &Expr| match &said.kind {
        Kind::Chain(first, links) => members(first, links),
        _ => None,
    };
    let mut all = Cow::Borrowed(formulas);
    for (number, said) in formulas {
        if said.iter().any(|one| apart(one).is_some()) {
            let each = said.iter().flat_map(|one| apart(one).unwrap_or_else(|| vec![one.clone()]));
            all.to_mut().insert(*number, each.collect());
        }
    }
    all
}

fn members(first: &Expr, links: &[Link]) -> Option<Vec<Expr>> {
    let [link] = links else { return None };
    let (names, values) = (first.items()?, link.expr.items()?);
    let base = |expr: &Expr| Head::of(expr).filter(|head| head.index().is_some()).map(|head| head.base);
    let own = base(names.first()?)?;
    let family = names.len() > 2 && names.iter().all(|name| base(name).as_ref() == Some(&own));
    (family && link.rel == Rel::Eq && names.len() == values.len()).then(|| {
        let one = |(name, value): (&Expr, &Expr)| {
            let link = Link { expr: value.clone(), ..link.clone() };
            Expr::new(Kind::Chain(Box::new(name.clone()), vec![link]), first.span)
        };
        names.iter().zip(values).map(one).collect()
    })
}

/// Whether it lists members of one family in their order: u_0 < u_1 < … < u_m.
fn is_ordered(first: &Expr, links: &[Link]) -> bool {
    let base = |expr: &Expr| Head::of(expr).filter(|head| head.index().is_some()).map(|head| head.base);
    let own = base(first);
    own.is_some()
        && links.len() > 1
        && links.iter().all(|link| matches!(link.rel, Rel::Lt | Rel::Le))
        && links.iter().all(|link| link.expr.kind == Kind::Ellipsis || base(&link.expr) == own)
}
