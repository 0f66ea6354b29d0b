//! Whether a claim fits an instance of a theorem, or is one slip away from it.

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use super::entry::{Equation, Theorem};
use super::free::Free;
use super::letters::{Profile, Way, is_end};
use super::slips;
use crate::budget;
use crate::formula::{Expr, Kind};
use crate::judge::instances::integers::as_values;
use crate::judge::known::unfold;
use crate::judge::model::{Choices, Model, holds};
use crate::judge::page::context::Context;
use crate::judge::page::statement::Place;
use crate::judge::repair;
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases, is_index_letter, walk};
use crate::math::poly::{MonomialOrder, MultiPoly};
use crate::math::ring::Ring;
use num_traits::{Signed, Zero};

/// In so many instances a claim is compared with a theorem.
const INSTANCES: usize = 8;

/// A claim as an instance of a theorem.
#[derive(Clone)]
pub(super) struct Instance<'a> {
    pub(super) theorem: &'a Theorem,
    pub(super) equation: &'a Equation,
    pub(super) way: Way,
    /// The sides of the theorem in the letters of the claim.
    pub(super) sides: [Expr; 2],
    /// Right sides that are known to be wrong.
    pub(super) misremembered: Vec<Expr>,
    /// Right sides that are as usual, so that nothing can be said.
    pub(super) conventions: Vec<Expr>,
    /// For which integers it holds.
    pub(super) conditions: Vec<Expr>,
    pub(super) standing: Standing,
    /// Whether the section speaks of something of which the theorem is not: a spline, a surface.
    pub(super) apart: bool,
}

/// What it means that a claim fits an instance.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Standing {
    /// It is right.
    Certain,
    /// Nothing: the sizes or the letters may be others.
    Doubtful,
    /// It is wrong: the sizes are others than the page says.
    Shifted,
}

/// A claim, and what its sides are in instances.
pub(super) struct Claim<'a> {
    pub(super) left: &'a Expr,
    pub(super) right: &'a Expr,
    pub(super) profile: Profile,
    pub(super) conditions: &'a [Expr],
    pub(super) place: &'a Place,
    pub(super) context: Rc<Context>,
}

/// The values of integers.
pub(super) type Values = Vec<(String, i64)>;

impl Claim<'_> {
    /// What stands for the letters of the claim in an instance of a theorem.
    pub(super) fn free(&self, instance: &Instance, values: &Values) -> Rc<Free> {
        let arity = |(letter, arity): &(String, Expr)| {
            let (_, own) = instance.way.letters.iter().find(|(known, _)| known == letter)?;
            let base = Head::of(own)?.base;
            let mut arity = arity.clone();
            unfold::put(&mut arity, &instance.way.integers);
            let value = evaluator::machine()
                .with_locals(as_values(values), |machine| machine.eval_int(&arity))
                .ok()?;
            Some((base, usize::try_from(value).ok()?))
        };
        let polar: Vec<(String, usize)> = instance.theorem.polar.iter().filter_map(arity).collect();
        let mut raised = self.profile.raised.clone();
        for letter in &instance.equation.profile.raised {
            let own = instance.way.letters.iter().find(|(known, _)| known == letter);
            raised.extend(own.and_then(|(_, own)| Head::of(own)).map(|head| head.base));
        }
        Rc::new(Free {
            model: Model::new(self.context.clone(), self.place.clone(), Choices::default(), None),
            functions: Rc::new(self.profile.functions(&polar)),
            raised: Rc::new(raised),
            world: None,
        })
    }

    /// The values of integers for which an instance of a theorem is looked at, those in the middle of ranges first.
    pub(super) fn values(&self, instance: &Instance) -> Vec<Values> {
        let names = &self.profile.integers;
        let largest = [0i64, 6, 5, 4, 3].get(names.len()).copied().unwrap_or(0);
        let mut all: Vec<Values> = vec![Vec::new()];
        for name in names {
            let longer = |values: &Values| {
                (0..=largest)
                    .map(|value| [values.clone(), vec![(name.clone(), value)]].concat())
                    .collect::<Vec<_>>()
            };
            all = all.iter().flat_map(longer).collect();
        }
        all.retain(|values| {
            let locals: Vec<_> = as_values(values).collect();
            evaluator::machine()
                .with_locals(locals, |machine| {
                    let mut met = instance.conditions.iter().chain(self.conditions);
                    let allowed = met.all(|condition| holds(machine, condition) != Some(false));
                    let natural = instance
                        .way
                        .integers
                        .iter()
                        .all(|(_, value)| machine.eval_int(value).is_ok_and(|value| value >= 0));
                    Ok(allowed && natural)
                })
                .unwrap_or(false)
        });
        all.sort_by_key(|values| {
            let numbers: BTreeSet<i64> = values.iter().map(|(_, value)| *value).collect();
            let extreme = values.iter().filter(|(_, value)| *value < 1).count();
            (extreme + values.len() - numbers.len(), values.iter().map(|(_, value)| *value).sum::<i64>())
        });
        // Some in the middle, and some at the ends.
        if all.len() > INSTANCES {
            let last = all.split_off(all.len() - INSTANCES / 4);
            all.truncate(INSTANCES - last.len());
            all.extend(last);
        }
        all
    }

    /// Whether the claim fits an instance of a theorem.
    pub(super) fn fits(&self, instance: &Instance) -> bool {
        self.is_instance(instance, self.left, self.right)
    }

    /// Whether the claim fits an instance of a theorem with other sides.
    pub(super) fn fits_sides(&self, instance: &Instance, left: &Expr, right: &Expr) -> bool {
        let sides = [left, right].map(Clone::clone);
        self.fits(&Instance { sides, ..instance.clone() })
    }

    pub(super) fn is_instance(&self, instance: &Instance, left: &Expr, right: &Expr) -> bool {
        let mut compared = 0;
        for values in self.values(instance) {
            let free = self.free(instance, &values);
            let [one, other] = &instance.sides;
            let Some(theirs) = key(&free, one, other, &values) else { continue };
            // b_0 = a_0 is an instance of many a theorem, and says nothing of any.
            let trivial = theirs.len() < 3
                && !is_plain(other)
                && self.profile.integers.is_empty()
                && !instance.equation.profile.integers.is_empty();
            match key(&free, left, right, &values) {
                Some(ours) if ours == theirs && !trivial => compared += 1,
                _ => return false,
            }
        }
        compared > usize::from(!self.profile.integers.is_empty())
    }

    /// Values of integers for which it is not what a theorem says.
    fn where_it_differs(&self, instance: &Instance) -> Option<(Values, Rc<Free>)> {
        let [one, other] = &instance.sides;
        self.values(instance).into_iter().find_map(|values| {
            let free = self.free(instance, &values);
            let theirs = key(&free, one, other, &values)?;
            (key(&free, self.left, self.right, &values) != Some(theirs)).then_some((values, free))
        })
    }

    /// A theorem that one small edit of the claim leads to, and the sides with that.
    pub(super) fn one_slip_away<'a, 'b>(
        &self,
        instances: &'a [Instance<'b>],
        long: &dyn Fn() -> bool,
    ) -> Option<(&'a Instance<'b>, [Expr; 2])> {
        let certain: Vec<&Instance> =
            instances.iter().filter(|own| own.standing == Standing::Certain && !own.apart).collect();
        if certain.is_empty() {
            return None;
        }
        let rights = edits(self.right, self.left);
        let lefts = edits(self.left, self.right);
        // The value of an edit depends on the integers and on the numbers of arguments only.
        let mut seen: HashMap<String, Vec<Option<MultiPoly>>> = HashMap::new();
        let mut near: Vec<&Instance> = Vec::new();
        for instance in certain {
            let alike = alike(self.right, &instance.sides[1]) && alike(self.left, &instance.sides[0]);
            if !alike || is_plain(self.right) != is_plain(&instance.equation.right) {
                continue;
            }
            let Some((values, free)) = self.where_it_differs(instance) else { continue };
            let values = &values;
            let [one, other] = &instance.sides;
            if long() {
                return None;
            }
            let same = |theirs: &Expr, ours: &Expr| {
                let theirs = free.value(theirs, values);
                theirs.is_some() && theirs == free.value(ours, values)
            };
            let (left, right) = (same(one, self.left), same(other, self.right));
            // The slip is on one side.
            let edits = match (left, right) {
                (true, false) => &rights,
                (false, true) if !instance.is_about_a_letter() => &lefts,
                _ => continue,
            };
            let Some(theirs) = key(&free, one, other, values) else { continue };
            let put = |edit: &Expr| {
                if left { [self.left.clone(), edit.clone()] } else { [edit.clone(), self.right.clone()] }
            };
            let place = format!("{left}{values:?}{:?}{:?}", free.functions, free.raised);
            let keys = seen.entry(place).or_insert_with(|| {
                let key = |edit: &Expr| {
                    let [left, right] = put(edit);
                    if long() { None } else { key(&free, &left, &right, values) }
                };
                edits.iter().map(key).collect()
            });
            let found = keys.iter().zip(edits.iter()).filter(|(key, _)| key.as_ref() == Some(&theirs));
            let mut held = found
                .map(|(_, edit)| put(edit))
                .filter(|[left, right]| self.is_instance(instance, left, right));
            if let Some(sides) = held.next() {
                return Some((instance, sides));
            }
            if left {
                near.push(instance);
            }
        }
        // A slip that leaves nothing to be edited: a root, an exponent, a letter that is gone.
        for instance in near {
            let Some((values, free)) = self.where_it_differs(instance) else { continue };
            let values = &values;
            let [one, other] = &instance.sides;
            let Some(ours) = key(&free, self.left, self.right, values) else { continue };
            let spoilt = |right: &Expr| {
                key(&free, one, right, values).as_ref() == Some(&ours)
                    && self.fits_sides(instance, one, right)
            };
            if instance.slips().iter().any(|right| !long() && spoilt(right)) {
                return Some((instance, [self.left.clone(), other.clone()]));
            }
        }
        None
    }

    /// What the right side should be, in an instance.
    pub(super) fn witness(&self, instance: &Instance) -> Option<String> {
        let all = self.values(instance);
        let different = |values: &&Values| {
            let free = self.free(instance, values);
            free.value(self.right, values) != free.value(&instance.sides[1], values)
        };
        let values = all.iter().find(different)?;
        let free = self.free(instance, values);
        let (ours, theirs) = (free.value(self.right, values)?, free.value(&instance.sides[1], values)?);
        let place: Vec<String> = values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let place = if place.is_empty() { String::new() } else { format!("{}: ", place.join(", ")) };
        Some(format!("{place}left {theirs}, right {ours}")).filter(|text| text.chars().count() < 200)
    }
}

/// The difference of two sides but for a factor; nothing if it is 0 or has no value.
fn key(free: &Rc<Free>, left: &Expr, right: &Expr, values: &Values) -> Option<MultiPoly> {
    budget::steps(64);
    let difference = free.value(left, values)?.minus(&free.value(right, values)?);
    if difference.is_zero() {
        return None;
    }
    let numerator = difference.numerator().primitive_part();
    let negative =
        numerator.terms(MonomialOrder::Lex).first().is_some_and(|(_, factor)| factor.is_negative());
    Some(if negative { -numerator } else { numerator })
}

impl Instance<'_> {
    /// The letters of the page that stand for its letters.
    pub(super) fn families(&self) -> BTreeSet<String> {
        self.way.letters.iter().flat_map(|(_, own)| bases(own)).collect()
    }

    /// Whether it says what something is that has a name.
    pub(super) fn is_about_a_letter(&self) -> bool {
        Head::of(&self.equation.left).is_some()
    }

    /// Whether two letters stand for things of one kind, and which of them is which is certain.
    fn may_be_exchanged(&self, one: &Expr, other: &Expr) -> bool {
        let theirs = |own: &Expr| {
            self.way.letters.iter().find(|(_, ours)| ours.same_as(own)).map(|(letter, _)| letter)
        };
        match (&one.kind, &other.kind) {
            (Kind::Subscript(a, indices), Kind::Subscript(b, others)) => {
                a.same_as(b) && indices.len() == others.len()
            }
            _ => match (theirs(one), theirs(other)) {
                (Some(a), Some(b)) => self.way.ordered && is_end(a) && is_end(b),
                _ => false,
            },
        }
    }

    /// The right side with small slips, and in forms that are known to be wrong.
    pub(super) fn slips(&self) -> Vec<Expr> {
        let [left, right] = &self.sides;
        let mut slips = Vec::new();
        slips::of(right, &mut slips);
        slips::exchanges(right, &|one, other| self.may_be_exchanged(one, other), &mut slips);
        slips.extend(self.misremembered.iter().cloned());
        slips.extend(repair::edits(right, left, &None));
        slips
    }
}

/// Whether a formula has about the form of a side of a theorem: as many members of families, or one more or fewer of many,
/// and no sum that has no terms to speak of.
fn alike(own: &Expr, theirs: &Expr) -> bool {
    let members = |expr: &Expr| {
        let (mut count, mut sums, mut trivial) = (0usize, false, false);
        let mut different: Vec<&Expr> = Vec::new();
        walk(expr, &mut |part| match &part.kind {
            Kind::Subscript(..) => {
                count += 1;
                if !different.iter().any(|known| known.same_as(part)) {
                    different.push(part);
                }
            }
            // Δ b_0 is b_1 - b_0.
            Kind::Mul(factors) => {
                let delta = |part: &&Expr| {
                    matches!(&part.kind, Kind::Name(name) if name == "Delta") || is_power(part)
                };
                count += factors.iter().filter(delta).count();
            }
            Kind::Big { upper, .. } => {
                sums = true;
                let few = |upper: &Expr| upper.as_int().is_some_and(|last| last < 2);
                trivial |= upper.as_ref().is_some_and(|upper| few(upper));
            }
            _ => {}
        });
        (count, different.len(), sums, trivial)
    };
    let (ours, our_kinds, sums, _) = members(own);
    let (count, kinds, theirs_sum, trivial) = members(theirs);
    let written_out = theirs_sum && !sums && ours > 1;
    let many = count > 2 && ours.abs_diff(count) == 1 || kinds > 2 && our_kinds == kinds;
    !trivial && (ours == count || many || written_out)
}

/// Whether it is Δ^k.
fn is_power(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Pow(base, _) if matches!(&base.kind, Kind::Name(name) if name == "Delta"))
}

/// Whether a side is one thing.
fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        // n(a - b) is a product.
        Kind::Apply(callee, groups) => {
            groups.iter().flatten().count() > 1
                || !matches!(&callee.kind, Kind::Name(name) if is_index_letter(name))
        }
        Kind::Name(_) | Kind::Subscript(..) | Kind::Pow(..) | Kind::Number(_) => true,
        _ => false,
    }
}

/// Small edits of a side.
fn edits(side: &Expr, other: &Expr) -> Vec<Expr> {
    let mut found = slips::of_matrices(side);
    found.extend(repair::edits(side, other, &None));
    found
}
