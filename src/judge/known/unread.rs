//! What stands beside something that could not be read or taken in.
//!
//! **Rule.** A name with a usual meaning, such as B for Bernstein polynomials, may have been given another one by a
//! formula that was not read, or by a list of members that stayed open. No relation is judged by the usual meaning after
//! such a formula in its section.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, interval};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::Context;
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::statement::{Chain, Place};
use crate::judge::written::names::{Head, bases};
use crate::language::lexicon::families;

/// Names in a chain that was not understood, or that it gives a meaning of its own.
#[derive(Clone)]
pub(in crate::judge) struct Unread {
    names: Vec<String>,
    place: Place,
    line: usize,
    /// Whether it says what they mean, and not what everybody means.
    own: bool,
}

impl Unread {
    /// The families in a chain that gives one that was not seen before a meaning of its own, or of which a side could not be read, or lists members of which nothing was found.
    pub(in crate::judge) fn of(
        chain: &Chain,
        place: &Place,
        findings: &[Finding],
        line: usize,
        seen: &BTreeSet<String>,
    ) -> Option<Self> {
        let own = family_of_its_own(chain, findings).or_else(|| operator_of_its_own(chain, findings));
        // A slip in what was spoken of before gives it no other meaning.
        if let Some(own) = own.filter(|own| !seen.contains(own)) {
            return Some(Unread { names: vec![own], place: place.clone(), line, own: true });
        }
        let open = findings.iter().all(|finding| finding.verdict == Verdict::Undecided);
        let doubtful = chain.sides.iter().any(|side| side.is_unread() || open && lists_members(&side.expr));
        let read = chain.sides.iter().filter(|side| !side.is_unread()).flat_map(|side| bases(&side.expr));
        let names: Vec<String> = read.filter(|name| doubtful && families::is_family(name)).collect();
        (!names.is_empty()).then(|| Unread { names, place: place.clone(), line, own: false })
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
        Some(match self.own {
            true => format!("line {} says of {name} what is not usual", self.line),
            false => format!("line {} may say what {name} is, and was not understood", self.line),
        })
    }
}

impl Checker {
    /// Why the usual meanings of names in two sides are in doubt here.
    pub(in crate::judge) fn doubt(&self, sides: [usize; 2], chain: &Chain, place: &Place) -> Option<String> {
        if self.unread.is_empty() {
            return None;
        }
        let own = sides.into_iter().flat_map(|at| bases(&chain.sides[at].expr)).collect();
        self.unread.iter().rev().find_map(|unread| unread.doubt(&own, &self.context, place))
    }
}

/// The letter of a family of which an equation says all that it is, in another way than everybody does: B_i^n(t) = t^i.
fn family_of_its_own(chain: &Chain, findings: &[Finding]) -> Option<String> {
    // B_i^{n,[a,b]}(x) = …, of which the interval is left out later on
    let over_an_interval = Head::of(&chain.sides[0].expr).filter(|head| {
        let mut indices = head.lower.iter().chain(&head.upper);
        let with_interval = |index: &Expr| index.has(&|part| interval(part).is_some());
        head.arguments.is_some() && families::is_family(&head.base) && indices.any(with_interval)
    });
    if let Some(head) = over_an_interval {
        return Some(head.base);
    }
    let head = family_told(chain).filter(|_| chain.relations.len() == 1)?;
    let first = findings.first()?;
    let other = first.verdict == Verdict::Refuted || first.warning.is_some();
    (other && families::has_values(&head.base)).then_some(head.base)
}

/// The head of which the first equation of a chain says what all its members are, not by themselves.
pub(in crate::judge) fn family_told(chain: &Chain) -> Option<Head> {
    let head = Head::of(&chain.sides[0].expr).filter(is_whole_family)?;
    (!bases(&chain.sides[1].expr).contains(&head.base)).then_some(head)
}

/// The letter of an operator of which an equation says what it does, in another way than everybody does: Δb_i = b_i - b_{i-1}.
fn operator_of_its_own(chain: &Chain, findings: &[Finding]) -> Option<String> {
    let Kind::Mul(factors) = &chain.sides[0].expr.kind else { return None };
    let [Expr { kind: Kind::Name(operator), .. }, operand] = factors.as_slice() else { return None };
    let usual =
        [families::FORWARD_DIFFERENCE, families::BACKWARD_DIFFERENCE, "D"].contains(&operator.as_str());
    let letter = |expr: &Expr| matches!(&expr.kind, Kind::Name(_));
    let any = Head::of(operand).is_some_and(|head| {
        let mut places = head.lower.iter().chain(&head.upper).chain(head.flat()).peekable();
        places.peek().is_some() && places.all(letter)
    });
    let holds = matches!(findings.first()?.verdict, Verdict::Proved | Verdict::Sampled);
    let says = chain.relations.len() == 1 && !bases(&chain.sides[1].expr).contains(operator);
    (usual && any && says && !holds).then(|| operator.clone())
}

/// Whether a head stands for all members of a family, as functions: B_i^n(t).
pub(in crate::judge) fn is_whole_family(head: &Head) -> bool {
    let letter = |expr: &Expr| matches!(&expr.kind, Kind::Name(_));
    let mut indices = head.lower.iter().chain(&head.upper).peekable();
    indices.peek().is_some() && indices.all(letter) && head.flat().into_iter().all(letter)
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
