//! What stands beside something that could not be read or taken in.
//!
//! **Rule.** A name with a usual meaning, such as B for Bernstein polynomials, may have been given another one by a
//! formula that was not read, or by a list of members that stayed open. No relation is judged by the usual meaning after
//! such a formula in its section.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind};
use crate::judge::page::context::Context;
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::statement::{Chain, Place};
use crate::judge::written::names::{Head, bases};
use crate::language::lexicon::families;

/// Names in a chain that was not understood.
#[derive(Clone)]
pub(in crate::judge) struct Unread {
    names: Vec<String>,
    place: Place,
    line: usize,
}

impl Unread {
    /// The families in a chain of which a side could not be read, or lists members of which nothing was found.
    pub(in crate::judge) fn of(
        chain: &Chain,
        place: &Place,
        findings: &[Finding],
        line: usize,
    ) -> Option<Self> {
        let open = findings.iter().all(|finding| finding.verdict == Verdict::Undecided);
        let doubtful = chain.sides.iter().any(|side| side.is_unread() || open && lists_members(&side.expr));
        let read = chain.sides.iter().filter(|side| !side.is_unread()).flat_map(|side| bases(&side.expr));
        let names: Vec<String> = read.filter(|name| doubtful && families::is_family(name)).collect();
        (!names.is_empty()).then(|| Unread { names, place: place.clone(), line })
    }

    /// Why the usual meaning of one of the names of a relation is in doubt, if it may say what the name is.
    pub(in crate::judge) fn doubt(
        &self,
        own: &BTreeSet<String>,
        context: &Context,
        place: &Place,
    ) -> Option<String> {
        let name = self.names.iter().find(|name| {
            place.knows(&self.place, false)
                && own.contains(*name)
                && context.visible(name, place).next().is_none()
        })?;
        Some(format!("line {} may say what {name} is, and was not understood", self.line))
    }
}

/// A column or row of names, [B_1; B_2].
fn lists_members(side: &Expr) -> bool {
    let entries: Vec<&Expr> = match &side.kind {
        Kind::Matrix(rows, _) => rows.iter().flatten().flatten().collect(),
        Kind::List(items) => items.iter().collect(),
        _ => return false,
    };
    let member = |entry: &&Expr| Head::of(entry).is_some_and(|head| head.arguments.is_none());
    entries.len() > 1 && entries.iter().all(member)
}
