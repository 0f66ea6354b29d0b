//! What the formulas of a page say, for whoever looks at paragraphs or sections as a whole.

use std::collections::BTreeMap;

use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::names::Head;
use crate::judge::statement::{Place, Said, Statement};

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

/// Whether it lists members of one family in their order: u_0 < u_1 < … < u_m.
fn is_ordered(first: &Expr, links: &[Link]) -> bool {
    let base = |expr: &Expr| Head::of(expr).filter(|head| head.index().is_some()).map(|head| head.base);
    let own = base(first);
    own.is_some()
        && links.len() > 1
        && links.iter().all(|link| matches!(link.rel, Rel::Lt | Rel::Le))
        && links.iter().all(|link| link.expr.kind == Kind::Ellipsis || base(&link.expr) == own)
}
