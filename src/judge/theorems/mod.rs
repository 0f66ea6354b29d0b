//! What the field knows of quantities that the page does not determine: degree elevation, knot insertion, …
//!
//! **Definition.** A claim is an *instance* of a theorem if the theorem belongs to the topics of the section, and the
//! letters of the theorem can be exchanged for those of the claim, families for families with as many indices, functions
//! for functions, integers for integers, numbers or neighbours of integers. The claim *fits* if the difference of its
//! sides is that of the theorem then but for a factor, in letters of which nothing else is known, for small integers.
//!
//! What fits is proved or sampled. What fits no theorem is wrong only if it is one slip away from one: a page may call
//! anything c_i.

mod agreement;
mod entry;
mod fit;
mod forms;
mod free;
mod letters;
mod own_values;
mod roles;
mod slips;
mod standing;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::rc::Rc;

use self::entry::{Theorem, known};
use self::fit::{Claim, Instance, Standing};
use self::forms::{
    in_order_of_page, main_case, with_indices_apart, with_repetitions, with_windows, without_marks,
    without_parameters,
};
use self::letters::{Profile, Said, ways};
use crate::budget;
use crate::formula::{Accent, Expr, Kind, Rel, interval};
use crate::judge::instances::setting::Setting;
use crate::judge::instances::trial::Trial;
use crate::judge::known::checker::Checker;
use crate::judge::known::found::Agreement;
use crate::judge::known::unfold;
use crate::judge::known::unread::family_told;
use crate::judge::model::Choices;
use crate::judge::page::context::{Body, Context, Mark};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::repair;
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases, has_members, is_index_letter, walk};
use crate::math::number::{integer, rational};

/// So often what members of families are is put for them.
const UNFOLDINGS: usize = 2;

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
            // Of curves that meet a model knows nothing but what equations say.
            let joined = finding.verdict == Verdict::Refuted
                && self.smoothness(&statement.place).is_some_and(|order| order > 0);
            if !joined && !matches!(finding.verdict, Verdict::Definition | Verdict::Undecided) {
                continue;
            }
            if self.doubt([at, at + 1], chain, &statement.place).is_some() {
                continue;
            }
            // a(z) = Σ a_k z^k = (1 + z)^n: what is said of the sum is said of a(z).
            let whole = at > 0 && Head::of(&chain.sides[0].expr).is_some();
            let mut lefts = std::iter::once(at).chain(whole.then_some(0));
            let found = budget::run(&limits, || {
                lefts.find_map(|left| self.by_theorems(chain, left, at, statement, finding))
            });
            let Ok(Some((found, agreement))) = found else { continue };
            // "Let B_i^n(t) = t^i": what is not usual is warned of.
            if finding.verdict == Verdict::Definition
                && found.verdict == Verdict::Refuted
                && statement.role == Some(Role::Introduced)
                && family_told(chain).is_some()
            {
                continue;
            }
            self.agreements.extend(agreement);
            if joined && found.verdict == Verdict::Refuted {
                continue;
            }
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
        first: usize,
        at: usize,
        statement: &Statement,
        finding: &Finding,
    ) -> Option<(Finding, Option<Agreement>)> {
        let (left, right) = (&chain.sides[first].expr, main_case(&chain.sides[at + 1].expr));
        if !chain.relations[first..=at].iter().all(|(relation, _)| matches!(relation, Rel::Eq | Rel::Define))
            || [left, right].into_iter().any(|side| side.has(&is_point))
            || chain.sides[first].is_unread()
            || chain.sides[at + 1].is_unread()
        {
            return None;
        }
        let start = budget::spent();
        let long = || budget::spent() - start > crate::judge::instances::setting::share(&self.limits, 2);
        let suggestion = |sides: [&Expr; 2]| self.suggestion(chain, at, sides, &[], statement);
        let known = known();
        let polar = statement.topics.has(Topic::PolarForm);
        let plain =
            with_indices_apart([left, right]).map(|side| with_windows(&with_repetitions(&side, polar)));
        let marked = plain.each_ref().map(without_marks);
        let bare = marked.each_ref().map(without_parameters);
        let mut forms = vec![plain, marked, bare];
        for _ in 0..UNFOLDINGS {
            let last = forms.last()?.clone();
            forms.push(last.map(|side| self.with_members_unfolded(&side, chain, &statement.place)));
        }
        forms.dedup();
        let mut doubt = false;
        for form in &forms {
            let [left, right] = form;
            let claim = self.claim(left, right, chain, &statement.place);
            if claim.profile.letters.is_empty() {
                break;
            }
            let instances = self.instances(&known, &claim, statement, finding);
            let names = statement.role != Some(Role::Claimed)
                && finding.verdict == Verdict::Definition
                && self.names_a_value(left, right);
            match self.among(&claim, &instances, finding, names, &long, &suggestion) {
                Some(Some(found)) => {
                    let open =
                        !doubt && !self.is_function_of_its_own(&chain.sides[first].expr, &statement.place);
                    return Some(found).filter(|(found, _)| open || found.verdict != Verdict::Refuted);
                }
                Some(None) => doubt = true,
                None => {}
            }
        }
        None
    }

    /// d_1 = f(-1, 0, 1), where nothing on the page uses d yet: a value of f gets a name, whatever the field calls so.
    fn names_a_value(&self, left: &Expr, right: &Expr) -> bool {
        let Some(head) = Head::of(left) else { return false };
        let letter = [head.base];
        // The member c_1 is not the function c.
        let uses = |body: &Expr| match head.lower.is_empty() {
            true => bases(body).contains(&letter[0]),
            false => has_members(body, &letter),
        };
        let used = self.context.definitions.iter().any(|definition| match &definition.body {
            Body::Formula(body) => uses(body),
            Body::Value(_) => false,
        });
        let root = |callee: &Expr| matches!(&callee.kind, Kind::Name(word) if matches!(word.as_str(), "sqrt" | "root"));
        matches!(&right.kind, Kind::Apply(callee, _) if !root(callee)) && !used
    }

    /// Whether a member without arguments is a function for which the page has a formula: \beta_k^m, after \beta_k^m(x) = ….
    fn is_function_of_its_own(&self, member: &Expr, place: &Place) -> bool {
        let Some(head) = Head::of(member).filter(|head| head.arguments.is_none() && !head.lower.is_empty())
        else {
            return false;
        };
        let mut known = self.context.visible(&head.base, place);
        known.any(|(_, own, near)| {
            near && own.head.arguments.is_some() && own.head.lower.len() == head.lower.len()
        })
    }

    /// A side with what the page says that members of its families are, other than the one it is about.
    fn with_members_unfolded(&self, side: &Expr, chain: &Chain, place: &Place) -> Expr {
        let own = Head::of(&chain.sides[0].expr).map(|head| head.base);
        let mut result = side.clone();
        let head = Head::of(side).filter(|head| head.arguments.is_none());
        let tells = |part: &Expr| matches!(part.kind, Kind::Subscript(..) | Kind::Matrix(..));
        let given = |head: &Head| own.as_ref() != Some(&head.base) && self.is_given(head, place);
        if let Some(head) = head.filter(given)
            && let Some(value) = self.unfolded(side, place, Choices::default())
            // A count stays as it is, the midpoint m and the matrix M do not.
            && (!head.lower.is_empty() || !is_index_letter(&head.base) || value.has(&tells))
        {
            return value.without_spans();
        }
        result.for_each_child_mut(&mut |child| *child = self.with_members_unfolded(child, chain, place));
        result
    }

    /// Whether another formula says what a member of a family is.
    fn is_given(&self, head: &Head, place: &Place) -> bool {
        let definition = self.context.visible(&head.base, place).next();
        definition.is_some_and(|(_, definition, near)| near && definition.place.formula != place.formula)
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
        names: bool,
        long: &dyn Fn() -> bool,
        suggestion: &dyn Fn([&Expr; 2]) -> Option<String>,
    ) -> Option<Option<(Finding, Option<Agreement>)>> {
        let agreed = claim.agreed(instances, &self.agreements);
        if let Some(instance) = agreed.filter(|instance| !claim.fits(instance)) {
            return Some(Some((self.differs(claim, instance, &instance.sides, finding, suggestion), None)));
        }
        let mut doubt = false;
        let mut slip: Option<&Instance> = None;
        for instance in instances {
            if long() {
                return Some(None);
            }
            doubt |= instance.conventions.iter().any(|right| {
                claim.fits_sides(instance, &instance.sides[0], right)
                    && instance.standing == Standing::Certain
            });
            if !claim.fits(instance) {
                continue;
            }
            match instance.standing {
                // c_2 = (b_2 + b_3)/2, where words say nothing of another degree
                _ if instance.apart
                    && instance.theorem.is_about(Topic::Elevation)
                    && claim.profile.integers.is_empty() =>
                {
                    doubt = true;
                }
                Standing::Doubtful => doubt = true,
                // The old points by the new ones
                Standing::Certain if self.is_inverse(&instance.families(), claim) => doubt = true,
                Standing::Shifted => {
                    slip = instances.iter().find(|other| {
                        other.theorem.name == instance.theorem.name && other.standing == Standing::Certain
                    });
                }
                Standing::Certain => {
                    let ranged = !claim.profile.integers.is_empty();
                    let found = Finding {
                        verdict: if ranged { Verdict::Sampled } else { Verdict::Proved },
                        reason: Some(format!("{}, as the field has it", instance.theorem.name)),
                        witness: None,
                        suggestion: None,
                        ..finding.clone()
                    };
                    return Some(Some((found, Agreement::of(claim, instance))));
                }
            }
        }
        if doubt || names {
            return Some(None);
        }
        let (instance, [left, right]) = slip
            .map(|meant| (meant, meant.sides.clone()))
            .or_else(|| claim.one_slip_away(instances, long))?;
        let families = instance.families();
        if self.has_equal_members(&families, claim.place) || self.is_inverse(&families, claim) {
            return Some(None);
        }
        Some(Some((self.differs(claim, instance, &[left, right], finding, suggestion), None)))
    }

    fn differs(
        &self,
        claim: &Claim,
        instance: &Instance,
        [left, right]: &[Expr; 2],
        finding: &Finding,
        suggestion: &dyn Fn([&Expr; 2]) -> Option<String>,
    ) -> Finding {
        Finding {
            verdict: Verdict::Refuted,
            reason: Some(format!("it differs from {}", instance.theorem.name)),
            witness: claim.witness(instance),
            suggestion: suggestion([left, right]),
            ..finding.clone()
        }
    }

    /// Whether the section says what others of these families are by the one that a claim is about: b_i = i/n c_{i-1} +
    /// (1 - i/n) c_i, from which c_i is found again.
    fn is_inverse(&self, families: &BTreeSet<String>, claim: &Claim) -> bool {
        let Some(head) = Head::of(claim.left) else { return false };
        let told = self.agreements.iter().filter(|own| claim.place.sees(&own.place)).any(|own| {
            let member = Head::of(&own.member)
                .is_some_and(|member| member.base != head.base && families.contains(&member.base));
            member && own.letters.iter().any(|(_, letter)| bases(letter).contains(&head.base))
        });
        if told {
            return true;
        }
        let mut near = self.context.definitions.iter().filter(|own| claim.place.knows(&own.place, false));
        near.any(|own| match &own.body {
            Body::Formula(body) => {
                families.contains(&own.head.base)
                    && own.head.base != head.base
                    && own.head.arguments.is_none()
                    && Head::of(body).is_none()
                    && bases(body).contains(&head.base)
            }
            Body::Value(_) => false,
        })
    }

    /// Whether the paragraph speaks last of an interval that is none of [0, 1] and its halves.
    fn is_cut_elsewhere(&self, place: &Place) -> bool {
        let halves = [integer(0), rational(1, 2), integer(1)];
        let cut = |end: &Expr| evaluator::number(end).is_some_and(|end| !halves.contains(&end));
        self.context.intervals_beside(place).next_back().is_some_and(|(_, ends, _)| ends.into_iter().any(cut))
    }

    /// The theorems that a claim may be an instance of.
    fn instances<'a>(
        &self,
        known: &'a [Theorem],
        claim: &Claim,
        statement: &Statement,
        finding: &Finding,
    ) -> Vec<Instance<'a>> {
        let mut topics = spoken(statement.topics, [claim.left, claim.right]);
        let smooth = self.smoothness(claim.place).is_some_and(|order| order > 0);
        if smooth || self.order_of_contact(claim.place).is_some() {
            topics.add(Topic::Join);
        }
        let refuted = finding.verdict == Verdict::Refuted;
        let one_length = self.context.letters.has_one_length();
        let uneven = self.context.has_uneven_knots(claim.place);
        // The points of "the left part" are none of a scheme that is repeated.
        let part = [Topic::First, Topic::Second, Topic::Half].into_iter().any(|topic| topics.has(topic));
        let of_part = part && !topics.has(Topic::Scheme);
        let told_uneven = statement.sentence.has(Topic::Uneven)
            || statement.topics.has(Topic::Uneven) && !statement.topics.has(Topic::Uniform);
        let cut_elsewhere = told_uneven || self.is_cut_elsewhere(claim.place);
        let even = |theorem: &Theorem| {
            !told_uneven && if theorem.is_about(Topic::Spline) { !uneven } else { one_length }
        };
        let objects = self.context.objects.iter().filter(|told| claim.place.knows(&told.place, false));
        // A curve with the points b_0, …, b_3 is a cubic, and so are Catmull-Rom splines.
        let last = |points: &[Expr]| match [points.first()?, points.last()?].map(Head::of) {
            [Some(first), Some(last)] if first.base == last.base && first.index()?.as_int()? == 0 => {
                last.index()?.as_int().filter(|last| *last > 0)
            }
            _ => None,
        };
        let unsaid = topics.degrees().next().is_none();
        let spoken = objects.filter_map(|told| match &told.object.degree {
            Some(degree) => degree.as_int(),
            None if told.object.sort == Sort::ControlPoints && unsaid => last(&told.object.names),
            None => None,
        });
        let cubic = topics.has(Topic::CatmullRom).then_some(3);
        let degrees = topics.degrees().chain(spoken).chain(cubic).collect();
        let said = Said { degrees, intervals: self.intervals_heard(claim.place) };
        let subjects = [Topic::Spline, Topic::Tensor, Topic::Triangle];
        let mut found = Vec::new();
        for theorem in known {
            let halves = [Topic::Half, Topic::Subdivision].into_iter().any(|topic| theorem.is_about(topic));
            // "Its right part has the control points c_j."
            let other_side = |mean: &str, own: Topic, other: Topic| {
                theorem.means(mean) && statement.near.has(other) && !statement.near.has(own)
            };
            if !theorem.is_spoken_of(topics)
                || other_side("left", Topic::First, Topic::Second)
                || other_side("right", Topic::Second, Topic::First)
                || cut_elsewhere && halves
                || of_part && theorem.means("scheme")
                || theorem.even && !even(theorem)
                || refuted && theorem.contact.is_none()
            {
                continue;
            }
            // Where no words say that it is a cubic, what differs from a theorem on cubics may be of another degree.
            let apart = subjects.iter().any(|own| topics.has(*own) && !theorem.is_about(*own))
                // Points of a curve of the same degree, c_2 = (b_2 + b_3)/2, may be those of a half.
                || theorem.is_about(Topic::Elevation) && !topics.has(Topic::Elevation)
                || theorem.degree().is_some_and(|own| !said.degrees.contains(&own));
            for equation in &theorem.equations {
                if !claim.profile.may_be(&equation.profile) {
                    continue;
                }
                for way in ways(equation, claim.left, &claim.profile, &said) {
                    let standing = self.standing(theorem, equation, &way, claim, &said);
                    let by = [way.letters.clone(), way.integers.clone()].concat();
                    let put = |expr: &Expr| {
                        let mut expr = expr.clone();
                        unfold::put(&mut expr, &by);
                        in_order_of_page(&mut expr, &self.context, claim.place);
                        expr.without_spans()
                    };
                    found.push(Instance {
                        sides: [put(&equation.left), put(&equation.right)],
                        misremembered: equation.misremembered.iter().map(put).collect(),
                        conventions: equation.conventions.iter().map(put).collect(),
                        conditions: theorem.conditions.iter().map(put).collect(),
                        theorem,
                        equation,
                        way,
                        standing,
                        apart,
                    });
                }
            }
        }
        found
    }

    /// The intervals that the section speaks of, the latest first, and pairs of names of which one is said to be less.
    fn intervals_heard(&self, place: &Place) -> Vec<(Expr, Expr)> {
        let mut found = Vec::new();
        for expr in self.heard(place) {
            match &expr.kind {
                Kind::Chain(left, links)
                    if links.iter().all(|link| matches!(link.rel, Rel::Lt | Rel::Le)) =>
                {
                    let sides: Vec<&Expr> =
                        std::iter::once(left.as_ref()).chain(links.iter().map(|link| &link.expr)).collect();
                    let names =
                        sides.windows(2).filter(|pair| pair.iter().all(|side| Head::of(side).is_some()));
                    found.extend(names.map(|pair| (pair[0].clone(), pair[1].clone())));
                }
                Kind::List(_) | Kind::Apply(..) => {
                    found.extend(interval(expr).map(|([from, to], _)| (from.clone(), to.clone())));
                }
                _ => {}
            }
        }
        found
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

/// What a section and the form of a claim in it speak of.
fn spoken(mut topics: Topics, sides: [&Expr; 2]) -> Topics {
    for side in sides {
        walk(side, &mut |part| match &part.kind {
            Kind::Derivative { .. } | Kind::Accent(Accent::Dot | Accent::Ddot, _) => {
                topics.add(Topic::Derivative);
            }
            Kind::Apply(callee, _) if matches!(callee.kind, Kind::Prime(..)) => topics.add(Topic::Derivative),
            Kind::Integral { .. } => topics.add(Topic::Integral),
            _ => {}
        });
    }
    topics
}

/// (0, -1): with numbers a claim is no instance of a theorem on letters.
fn is_point(part: &Expr) -> bool {
    matches!(&part.kind, Kind::Tuple(items) | Kind::List(items) if items.len() > 1 && bases(part).is_empty())
}
