//! What the field knows of quantities that the page does not determine: degree elevation, knot insertion, …
//!
//! **Definition.** A claim is an *instance* of a theorem if the theorem belongs to the topics of the section, and the
//! letters of the theorem can be exchanged for those of the claim, families for families with as many indices, functions
//! for functions, integers for integers, numbers or neighbours of integers. The claim *fits* if the difference of its
//! sides is that of the theorem then but for a factor, in letters of which nothing else is known, for small integers.
//!
//! What fits is proved or sampled. What fits no theorem is wrong only if it is one slip away from one: a page may call
//! anything c_i.

mod entry;
mod free;
mod letters;
mod roles;
mod slips;
#[cfg(test)]
mod tests;

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use self::entry::{Equation, Theorem, known};
use self::free::Free;
use self::letters::{Profile, Way, ways};
use super::check::Checker;
use super::context::{Body, Context, Mark};
use super::evaluator;
use super::finding::{Finding, Verdict};
use super::integers::as_values;
use super::model::{Choices, Model, holds};
use super::names::{bases, walk};
use super::object::Sort;
use super::repair;
use super::statement::{Chain, Place, Statement};
use super::topic::Topic;
use super::trial::{Setting, Trial};
use super::unfold;
use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::language::write;
use crate::math::poly::{MonomialOrder, MultiPoly};
use num_traits::{Signed, Zero};

/// In so many instances a claim is compared with a theorem.
const INSTANCES: usize = 8;

/// A claim as an instance of a theorem.
#[derive(Clone)]
struct Instance<'a> {
    theorem: &'a Theorem,
    equation: &'a Equation,
    way: Way,
    /// The sides of the theorem in the letters of the claim.
    sides: [Expr; 2],
    /// Right sides that are known to be wrong.
    misremembered: Vec<Expr>,
    /// For which integers it holds.
    conditions: Vec<Expr>,
    standing: Standing,
}

/// What it means that a claim fits an instance.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Standing {
    /// It is right.
    Certain,
    /// Nothing: the sizes or the letters may be others.
    Doubtful,
    /// It is wrong: the sizes are others than the page says.
    Shifted,
}

/// A claim, and what its sides are in instances.
struct Claim<'a> {
    left: &'a Expr,
    right: &'a Expr,
    profile: Profile,
    conditions: &'a [Expr],
    place: &'a Place,
    context: Rc<Context>,
}

/// The values of integers.
type Values = Vec<(String, i64)>;

impl Checker {
    /// What the page leaves open the field may know.
    pub(super) fn by_the_field(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        if chain.blocked || !statement.topics.any() {
            return;
        }
        let limits = self.limits.clone();
        for (at, finding) in findings.iter_mut().enumerate() {
            if !matches!(finding.verdict, Verdict::Definition | Verdict::Undecided) {
                continue;
            }
            let found = budget::run(&limits, || self.by_theorems(chain, at, statement, finding));
            let Ok(Some(found)) = found else { continue };
            if found.verdict == Verdict::Refuted {
                Rc::make_mut(&mut self.context).forget(before);
            }
            *finding = found;
        }
    }

    /// Judges a relation of a chain by what the field knows of it, if that decides it.
    fn by_theorems(
        &self,
        chain: &Chain,
        at: usize,
        statement: &Statement,
        finding: &Finding,
    ) -> Option<Finding> {
        let (left, right) = (&chain.sides[at].expr, main_case(&chain.sides[at + 1].expr));
        if !matches!(chain.relations[at].0, Rel::Eq | Rel::Define)
            || chain.sides[at].is_unread()
            || chain.sides[at + 1].is_unread()
        {
            return None;
        }
        let start = budget::spent();
        let long = || budget::spent() - start > super::trial::share(&self.limits, 2);
        let marked = [left, right].map(without_marks);
        let plain = [left.clone(), right.clone()];
        let forms = if marked == plain { vec![plain] } else { vec![plain, marked] };
        for form in &forms {
            let [left, right] = form;
            let claim = self.claim(left, right, chain, &statement.place);
            if claim.profile.letters.is_empty() {
                return None;
            }
            let known = known();
            let instances = self.instances(&known, &claim, statement);
            if let Some(found) = self.among(&claim, &instances, finding, &long) {
                return found;
            }
        }
        None
    }

    fn claim<'a>(&self, left: &'a Expr, right: &'a Expr, chain: &'a Chain, place: &'a Place) -> Claim<'a> {
        let letters = &self.context.letters;
        let applied = |base: &str| letters.is_function(base);
        let profile = Profile::of(&[left, right], &letters.towers, &applied);
        let context = Rc::new(Context::new(letters.clone()));
        Claim { left, right, profile, conditions: &chain.conditions, place, context }
    }

    /// The verdict on a claim by its instances; nothing inside if it has to stay as it is.
    fn among(
        &self,
        claim: &Claim,
        instances: &[Instance],
        finding: &Finding,
        long: &dyn Fn() -> bool,
    ) -> Option<Option<Finding>> {
        let mut doubt = false;
        let mut slip: Option<&Instance> = None;
        for instance in instances {
            if long() {
                return Some(None);
            }
            if !claim.fits(instance) {
                continue;
            }
            match instance.standing {
                Standing::Doubtful => doubt = true,
                Standing::Shifted => {
                    slip = instances.iter().find(|other| {
                        other.theorem.name == instance.theorem.name && other.standing == Standing::Certain
                    });
                }
                Standing::Certain => {
                    let ranged = !claim.profile.integers.is_empty();
                    return Some(Some(Finding {
                        verdict: if ranged { Verdict::Sampled } else { Verdict::Proved },
                        reason: Some(format!("{}, as the field has it", instance.theorem.name)),
                        witness: None,
                        suggestion: None,
                        ..finding.clone()
                    }));
                }
            }
        }
        if doubt {
            return Some(None);
        }
        let (instance, [left, right]) = slip
            .map(|meant| (meant, meant.sides.clone()))
            .or_else(|| claim.one_slip_away(instances, long))?;
        let repaired = Expr::relation(left, Rel::Eq, right);
        Some(Some(Finding {
            verdict: Verdict::Refuted,
            reason: Some(format!("it differs from {}", instance.theorem.name)),
            witness: claim.witness(instance),
            suggestion: Some(write::latex(&repaired)),
            ..finding.clone()
        }))
    }

    /// The theorems that a claim may be an instance of.
    fn instances<'a>(&self, known: &'a [Theorem], claim: &Claim, statement: &Statement) -> Vec<Instance<'a>> {
        let topics = statement.topics;
        let one_length = self.context.letters.has_one_length();
        let uneven = self.context.has_uneven_knots(claim.place);
        let even = |theorem: &Theorem| if theorem.is_about(Topic::Spline) { !uneven } else { one_length };
        let degrees: Vec<i64> = topics.degrees().collect();
        let mut found = Vec::new();
        for theorem in known {
            if !theorem.is_spoken_of(topics) || theorem.even && !even(theorem) {
                continue;
            }
            for equation in &theorem.equations {
                if !claim.profile.may_be(&equation.profile) {
                    continue;
                }
                for way in ways(equation, claim.left, &claim.profile, &degrees) {
                    let standing = self.standing(theorem, equation, &way, claim);
                    let by = [way.letters.clone(), way.integers.clone()].concat();
                    let put = |expr: &Expr| {
                        let mut expr = expr.clone();
                        unfold::put(&mut expr, &by);
                        expr.without_spans()
                    };
                    found.push(Instance {
                        sides: [put(&equation.left), put(&equation.right)],
                        misremembered: equation.misremembered.iter().map(put).collect(),
                        conditions: theorem.conditions.iter().map(put).collect(),
                        theorem,
                        equation,
                        way,
                        standing,
                    });
                }
            }
        }
        found
    }

    /// What it means that a claim fits a theorem in a way.
    fn standing(&self, theorem: &Theorem, equation: &Equation, way: &Way, claim: &Claim) -> Standing {
        if way.letters.iter().any(|(theirs, ours)| roles::clash(theirs, ours, &self.context, claim.place)) {
            return Standing::Doubtful;
        }
        let sizes =
            way.integers.iter().skip(way.anchored).filter(|(letter, _)| letter != "i" && letter != "j");
        for (_, value) in sizes.clone() {
            let Kind::Add(_) = &value.kind else { continue };
            let name = bases(value).into_iter().next().unwrap_or_default();
            // Of degree n - 1, or of degree n raised from n - 1: words or sums tell.
            let points = way.letters.iter().find(|(letter, _)| letter == "b").map(|(_, value)| value);
            let said = self.said_as_order(&Expr::name(&name), claim.place) == Some(false)
                || points.is_some_and(|points| self.sums_to(&name, points, claim.place));
            return if said && !equation.order { Standing::Shifted } else { Standing::Doubtful };
        }
        if theorem.has_orders() {
            let size = way.integers.iter().find(|(letter, _)| letter == "n").map(|(_, size)| size);
            let said = size.and_then(|size| self.said_as_order(size, claim.place));
            // Where words say that it is the degree, the other is the likely slip. Many say order for the degree.
            return match said {
                Some(true) if !equation.order => Standing::Doubtful,
                Some(said) if said != equation.order => Standing::Shifted,
                Some(_) => Standing::Certain,
                None if equation.order => Standing::Doubtful,
                None => Standing::Certain,
            };
        }
        Standing::Certain
    }

    /// Whether a sum of the page over some points ends with a letter.
    fn sums_to(&self, end: &str, points: &Expr, place: &Place) -> bool {
        let bodies = self.context.definitions.iter().filter(|known| place.sees(&known.place));
        let mut found = false;
        for definition in bodies {
            let Body::Formula(body) = &definition.body else { continue };
            walk(body, &mut |part| {
                if let Kind::Big { upper: Some(upper), body, .. } = &part.kind {
                    let own = matches!(&upper.kind, Kind::Name(name) if name == end);
                    let base = super::names::Head::of(points).map(|head| head.base);
                    found |= own && base.is_some_and(|base| bases(body).contains(&base));
                }
            });
        }
        found
    }

    /// Whether words say that a size is an order (true), or a degree (false).
    fn said_as_order(&self, size: &Expr, place: &Place) -> Option<bool> {
        let Kind::Name(letter) = &size.kind else { return None };
        let spoken = self.context.sizes_of(letter).filter(|declared| place.in_reach(&declared.place, false));
        let (mut said, mut less) = (None, false);
        for declared in spoken {
            // "of degree n - 1": n is no degree.
            let other =
                declared.object.degree.as_ref().is_some_and(|degree| degree.same_as(&size.clone().plus(-1)));
            match declared.object.sort {
                _ if other => less = true,
                Sort::Order => said = said.or(Some(true)),
                Sort::Degree => said = said.or(Some(false)),
                _ => {}
            }
        }
        said.filter(|order| *order || !less)
    }

    /// Whether two formulas are equal, whatever their letters mean.
    pub(super) fn agree(&self, setting: &Setting, one: &Expr, other: &Expr) -> bool {
        let setting = Setting { facts: Rc::default(), curve: None, ..*setting };
        let nothing = Rc::new(Context::new(self.context.letters.clone()));
        let trial =
            Trial::new(nothing, &setting, vec![one, other], vec![Rel::Eq], Choices::default(), &self.limits);
        repair::is_true(&trial.first(4), true) && repair::is_true(&trial.run(), false)
    }
}

impl Claim<'_> {
    /// What stands for the letters of the claim in an instance of a theorem.
    fn free(&self, instance: &Instance, values: &Values) -> Rc<Free> {
        let arity = |(letter, arity): &(String, Expr)| {
            let (_, own) = instance.way.letters.iter().find(|(known, _)| known == letter)?;
            let base = super::names::Head::of(own)?.base;
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
            raised.extend(own.and_then(|(_, own)| super::names::Head::of(own)).map(|head| head.base));
        }
        Rc::new(Free {
            model: Model::new(self.context.clone(), self.place.clone(), Choices::default(), None),
            functions: Rc::new(self.profile.functions(&polar)),
            raised: Rc::new(raised),
            world: None,
        })
    }

    /// The values of integers for which an instance of a theorem is looked at, those in the middle of ranges first.
    fn values(&self, instance: &Instance) -> Vec<Values> {
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
    fn fits(&self, instance: &Instance) -> bool {
        self.is_instance(instance, self.left, self.right)
    }

    /// Whether the claim fits an instance of a theorem with other sides.
    fn fits_sides(&self, instance: &Instance, left: &Expr, right: &Expr) -> bool {
        let sides = [left, right].map(Clone::clone);
        self.fits(&Instance { sides, ..instance.clone() })
    }

    fn is_instance(&self, instance: &Instance, left: &Expr, right: &Expr) -> bool {
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

    /// A theorem that one small edit of the claim leads to, and the sides with that.
    fn one_slip_away<'a, 'b>(
        &self,
        instances: &'a [Instance<'b>],
        long: &dyn Fn() -> bool,
    ) -> Option<(&'a Instance<'b>, [Expr; 2])> {
        let certain: Vec<&Instance> =
            instances.iter().filter(|instance| instance.standing == Standing::Certain).collect();
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
            let all = self.values(instance);
            let Some(values) = all.first() else { continue };
            let free = self.free(instance, values);
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
            let all = self.values(instance);
            let Some(values) = all.first() else { continue };
            let free = self.free(instance, values);
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
    fn witness(&self, instance: &Instance) -> Option<String> {
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
    use crate::math::ring::Ring;
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
    /// Whether it says what something is that has a name.
    fn is_about_a_letter(&self) -> bool {
        super::names::Head::of(&self.equation.left).is_some()
    }

    /// The right side with small slips, and in forms that are known to be wrong.
    fn slips(&self) -> Vec<Expr> {
        let [left, right] = &self.sides;
        let mut slips = Vec::new();
        slips::of(right, &mut slips);
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
        walk(expr, &mut |part| match &part.kind {
            Kind::Subscript(..) => count += 1,
            // Δ b_0 is b_1 - b_0.
            Kind::Name(name) if name == "Delta" => count += 1,
            Kind::Big { upper, .. } => {
                sums = true;
                let few = |upper: &Expr| upper.as_int().is_some_and(|last| last < 2);
                trivial |= upper.as_ref().is_some_and(|upper| few(upper));
            }
            _ => {}
        });
        (count, sums, trivial)
    };
    let ((ours, sums, _), (count, theirs_sum, trivial)) = (members(own), members(theirs));
    let written_out = theirs_sum && !sums && ours > 1;
    !trivial && (ours == count || count > 2 && ours.abs_diff(count) == 1 || written_out)
}

/// Whether a side is one thing.
fn is_plain(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        Kind::Name(_) | Kind::Subscript(..) | Kind::Pow(..) | Kind::Apply(..) | Kind::Number(_)
    )
}

/// Small edits of a side.
fn edits(side: &Expr, other: &Expr) -> Vec<Expr> {
    let mut found = slips::of_matrices(side);
    found.extend(repair::edits(side, other, &None));
    found
}

/// The one case of a formula that is not a number, or the formula.
fn main_case(expr: &Expr) -> &Expr {
    let Kind::Cases(cases) = &expr.kind else { return expr };
    let mut formulas =
        cases.iter().map(|(body, _)| body).filter(|body| !matches!(body.kind, Kind::Number(_)));
    match (formulas.next(), formulas.next()) {
        (Some(only), None) => only,
        _ => expr,
    }
}

/// A formula in which b_i^{(1)} is a member of a family with another name.
fn without_marks(expr: &Expr) -> Expr {
    fn unmark(expr: &mut Expr) {
        expr.for_each_child_mut(&mut unmark);
        let Kind::Upper(base, upper) = &expr.kind else { return };
        let ([mark], Kind::Subscript(letter, indices)) = (upper.as_slice(), &base.kind) else { return };
        let mark = match &mark.kind {
            Kind::Number(number) => number.to_string(),
            Kind::Text(text) => text.clone(),
            _ => return,
        };
        let Some(head) = super::names::Head::of(letter) else { return };
        let name = Expr::new(Kind::Name(format!("{}({mark})", head.base)), letter.span);
        expr.kind = Kind::Subscript(Box::new(name), indices.clone());
    }
    let mut result = expr.clone();
    unmark(&mut result);
    result
}
