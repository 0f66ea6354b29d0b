//! What a page calls so was shown by another member: after b_0 = (d_0 + 4 d_1 + d_2)/6 the b_1 there is known.

use super::fit::{Claim, Instance, Standing};
use super::letters::Letters;
use crate::formula::{Expr, Kind};
use crate::judge::known::found::Agreement;
use crate::judge::written::names::{Head, bases, walk};

impl Agreement {
    /// That of a claim with an instance that it fits, if it is of several members: b_0 = a_0 is one of many a theorem.
    pub(super) fn of(claim: &Claim, instance: &Instance) -> Option<Self> {
        let telling = instance.is_about_a_letter() && members(claim.right) > 1;
        telling.then(|| Agreement {
            theorem: instance.theorem.name,
            letters: instance.way.letters.clone(),
            sizes: sizes(instance),
            member: claim.left.clone(),
            place: claim.place.clone(),
        })
    }

    /// Whether an instance gives another member in the same letters, in the same paragraph or soon after it.
    fn speaks_of(&self, claim: &Claim, instance: &Instance) -> bool {
        let (own, other) = (&self.place, claim.place);
        self.theorem == instance.theorem.name
            && !self.member.same_as(claim.left)
            && other.scope == own.scope
            && other.blocks == own.blocks
            && other.changes == own.changes
            && other.group <= own.group + 2
            && are_equal(&self.letters, &instance.way.letters)
            && are_equal(&self.sizes, &sizes(instance))
    }
}

impl Claim<'_> {
    /// The instance that gives the member that a claim is about, as another one agreed with its theorem, if the claim makes
    /// it of the same families.
    pub(super) fn agreed<'a, 'b>(
        &self,
        instances: &'a [Instance<'b>],
        known: &[Agreement],
    ) -> Option<&'a Instance<'b>> {
        if known.is_empty() || members(self.right) < 2 {
            return None;
        }
        let own = bases(self.right);
        let mut same = instances.iter().filter(|instance| {
            let [left, right] = &instance.sides;
            instance.standing == Standing::Certain
                && !instance.apart
                && left.same_as(self.left)
                && bases(right) == own
                && known.iter().any(|agreement| agreement.speaks_of(self, instance))
        });
        let first = same.next()?;
        let one = same.all(|other| other.sides[1].same_as(&first.sides[1]));
        let told = |agreement: &Agreement| {
            agreement.theorem == first.theorem.name && agreement.member.same_as(self.left)
        };
        (one && !known.iter().any(told)).then_some(first)
    }
}

fn sizes(instance: &Instance) -> Letters {
    let sizes = instance.way.integers.iter().filter(|(letter, _)| letter != "i" && letter != "j");
    sizes.cloned().collect()
}

fn are_equal(one: &Letters, other: &Letters) -> bool {
    one.len() == other.len()
        && one
            .iter()
            .all(|(letter, own)| other.iter().any(|(known, its)| known == letter && own.same_as(its)))
}

/// How many members of families stand in a formula.
fn members(expr: &Expr) -> usize {
    let mut count = 0;
    walk(expr, &mut |part| {
        let member = matches!(part.kind, Kind::Subscript(..)) && Head::of(part).is_some();
        count += usize::from(member);
    });
    count
}
