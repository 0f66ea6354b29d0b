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
mod fit;
mod free;
mod letters;
mod roles;
mod slips;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::rc::Rc;

use self::entry::{Equation, Theorem, known};
use self::fit::{Claim, Instance, Standing};
use self::letters::{Profile, Said, Way, ways};
use super::check::Checker;
use super::context::{Body, Context, Mark};
use super::evaluator;
use super::finding::{Finding, Verdict};
use super::inequality::interval;
use super::integers::as_values;
use super::model::Choices;
use super::names::{Head, bases, is_index_letter, walk};
use super::object::Sort;
use super::repair;
use super::statement::{Chain, Place, Role, Statement};
use super::topic::{Topic, Topics};
use super::trial::{Setting, Trial};
use super::unfold;
use crate::budget;
use crate::formula::{Accent, Expr, Kind, Rel};
use crate::language::lexicon::families;
use crate::language::write;

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
        let known = known();
        let polar = statement.topics.has(Topic::PolarForm);
        let plain = with_indices_apart([left, right]).map(|side| with_repetitions(&side, polar));
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
            let instances = self.instances(&known, &claim, statement);
            let names = statement.role != Some(Role::Claimed)
                && finding.verdict == Verdict::Definition
                && self.names_a_value(left, right);
            match self.among(&claim, &instances, finding, names, &long) {
                Some(Some(found)) => {
                    return Some(found).filter(|found| !doubt || found.verdict != Verdict::Refuted);
                }
                Some(None) => doubt = true,
                None => {}
            }
        }
        None
    }

    /// d_1 = f(-1, 0, 1), where nothing on the page uses d yet: a value of f gets a name, whatever the field calls so.
    fn names_a_value(&self, left: &Expr, right: &Expr) -> bool {
        let used = |base: &String| {
            self.context.definitions.iter().any(|definition| match &definition.body {
                Body::Formula(body) => bases(body).contains(base),
                Body::Value(_) => false,
            })
        };
        matches!(right.kind, Kind::Apply(..)) && !bases(left).iter().any(used)
    }

    /// A side with what the page says that members of its families are, other than the one it is about.
    fn with_members_unfolded(&self, side: &Expr, chain: &Chain, place: &Place) -> Expr {
        let own = Head::of(&chain.sides[0].expr).map(|head| head.base);
        let mut result = side.clone();
        let head = Head::of(side).filter(|head| head.arguments.is_none());
        let head = head.filter(|head| !head.lower.is_empty() || !is_index_letter(&head.base));
        let given = |head: &Head| own.as_ref() != Some(&head.base) && self.is_given(head, place);
        if head.as_ref().is_some_and(given)
            && let Some(value) = self.unfolded(side, place, Choices::default())
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
    ) -> Option<Option<Finding>> {
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
        if doubt || names {
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
        let mut topics = spoken(statement.topics, [claim.left, claim.right]);
        if self.order_of_contact(claim.place).is_some() {
            topics.add(Topic::Join);
        }
        let one_length = self.context.letters.has_one_length();
        let uneven = self.context.has_uneven_knots(claim.place);
        let even = |theorem: &Theorem| if theorem.is_about(Topic::Spline) { !uneven } else { one_length };
        let said = Said { degrees: topics.degrees().collect(), intervals: self.intervals_heard(claim.place) };
        let mut found = Vec::new();
        for theorem in known {
            if !theorem.is_spoken_of(topics) || theorem.even && !even(theorem) {
                continue;
            }
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

    /// What it means that a claim fits a theorem in a way.
    fn standing(
        &self,
        theorem: &Theorem,
        equation: &Equation,
        way: &Way,
        claim: &Claim,
        said: &Said,
    ) -> Standing {
        let unlike = |theirs: &str, ours: &Expr| {
            roles::clash(theirs, ours, &self.context, claim.place)
                || roles::is_no_basis(theirs, ours, &self.context, claim.place)
        };
        // What a ratio is the page says.
        let given = |(theirs, ours): &(String, Expr)| {
            theirs == "a" && Head::of(ours).is_some_and(|head| self.is_given(&head, claim.place))
        };
        if way.letters.iter().any(given) {
            return Standing::Doubtful;
        }
        let named = |letter: &String| equation.profile.is_family(letter) || letter.starts_with(['B', 'N']);
        if way.letters.iter().any(|(theirs, ours)| named(theirs) && unlike(theirs, ours)) {
            return Standing::Doubtful;
        }
        if let Some(standing) = self.contact(theorem, way, claim.place) {
            return standing;
        }
        // Of another degree than words say.
        let size = way.integers.iter().find(|(letter, _)| letter == "n").and_then(|(_, size)| size.as_int());
        let degree = size.map(|size| size - i64::from(equation.order));
        if degree.is_some_and(|degree| !said.degrees.is_empty() && !said.degrees.contains(&degree)) {
            return Standing::Doubtful;
        }
        let within =
            |name: &Expr| said.intervals.iter().any(|(from, to)| from.same_as(name) || to.same_as(name));
        // The points are those of the interval spoken of last.
        if let ([from, to], [latest, .., _]) = (way.ends.as_slice(), said.intervals.as_slice())
            && within(from)
            && within(to)
            && !(latest.0.same_as(from) && latest.1.same_as(to))
        {
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
                || theorem.has_orders() && self.context.spline_has_degree(claim.place) == Some(true)
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

    /// What the order of contact that the page supposes makes of a theorem on contact.
    fn contact(&self, theorem: &Theorem, way: &Way, place: &Place) -> Option<Standing> {
        let (_, free) = way.integers.iter().find(|(letter, _)| theorem.contact.as_ref() == Some(letter))?;
        let order = self.order_of_contact(place)?;
        // Both are a name or a neighbour of one.
        let parts = |expr: &Expr| match &expr.kind {
            Kind::Add(_) => {
                let at = |value: i64| {
                    let names: Vec<_> = bases(expr).into_iter().map(|name| (name, value)).collect();
                    evaluator::machine().with_locals(as_values(&names), |machine| machine.eval_int(expr)).ok()
                };
                Some((bases(expr), at(0)?))
            }
            Kind::Name(_) => Some((bases(expr), 0)),
            _ => expr.as_int().map(|value| (BTreeSet::new(), value)),
        };
        let ((letter, own), (other, supposed)) = (parts(free)?, parts(&order)?);
        Some(match own - supposed {
            _ if letter != other => Standing::Doubtful,
            0 => Standing::Certain,
            1 => Standing::Shifted,
            _ => Standing::Doubtful,
        })
    }

    /// The r of F^{(k)}(a) = G^{(k)}(a) for k = 0, …, r.
    fn order_of_contact(&self, place: &Place) -> Option<Expr> {
        let index = |side: &Expr| {
            let Kind::Apply(callee, _) = &side.kind else { return None };
            let head = Head::of(callee).filter(|head| head.parenthesized)?;
            match head.upper.as_slice() {
                [Expr { kind: Kind::Name(index), .. }] => Some(index.clone()),
                _ => None,
            }
        };
        let supposed = |expr: &Expr| {
            let Kind::Chain(left, links) = &expr.kind else { return None };
            let [link] = links.as_slice() else { return None };
            index(left).filter(|own| index(&link.expr).as_ref() == Some(own))
        };
        let open = self.context.conditions.iter().flat_map(|condition| {
            std::iter::once(&condition.expr).chain(&condition.ranges).map(|expr| (expr, &condition.place))
        });
        let said = self.context.heard.iter().map(|(place, expr)| (&**expr, place));
        let all: Vec<&Expr> =
            open.chain(said).filter(|(_, other)| place.knows(other, false)).map(|(expr, _)| expr).collect();
        let index = all.iter().rev().find_map(|expr| supposed(expr))?;
        all.iter().rev().find_map(|expr| {
            let Kind::Chain(left, links) = &expr.kind else { return None };
            let last = &links.last()?.expr;
            let about = |side: &Expr| matches!(&side.kind, Kind::Name(name) if *name == index);
            match (&last.kind, links.as_slice()) {
                (Kind::Range(_, last), [link]) if about(left) && link.rel == Rel::Eq => {
                    Some(last.as_ref().clone())
                }
                (_, [first, second]) if about(&first.expr) && left.as_int() == Some(0) => match second.rel {
                    Rel::Le => Some(last.clone()),
                    Rel::Lt => Some(last.clone().plus(-1)),
                    _ => None,
                },
                _ => None,
            }
        })
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
                    let base = Head::of(points).map(|head| head.base);
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

/// b_{ijk} beside b_{i-1,j,k}: indices that are written together; p_{i,…,k}, the first and the last index.
fn with_indices_apart(sides: [&Expr; 2]) -> [Expr; 2] {
    let mut several: Vec<(String, usize)> = Vec::new();
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Subscript(base, indices) = &part.kind
                && let Some(head) = Head::of(base)
                && indices.len() > 1
            {
                several.push((head.base, indices.len()));
            }
        });
    }
    fn split(expr: &mut Expr, several: &[(String, usize)]) {
        expr.for_each_child_mut(&mut |child| split(child, several));
        let Kind::Subscript(base, indices) = &mut expr.kind else { return };
        // p_{i,…,k}: from i to k
        if let [_, dots, _] = indices.as_slice()
            && dots.kind == Kind::Ellipsis
        {
            indices.remove(1);
            return;
        }
        let [Expr { kind: Kind::Mul(factors), .. }] = indices.as_slice() else { return };
        if Head::of(base).is_some_and(|head| several.contains(&(head.base, factors.len()))) {
            *indices = factors.clone();
        }
    }
    sides.map(|side| {
        let mut side = side.clone();
        split(&mut side, &several);
        side
    })
}

/// A formula in which f(a^{⟨k⟩}, b) has a brace with a count, and so has f(a^k, b) where polar forms are spoken of.
fn with_repetitions(expr: &Expr, polar: bool) -> Expr {
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = with_repetitions(child, polar));
    let Kind::Apply(_, groups) = &mut result.kind else { return result };
    if groups.iter().map(Vec::len).sum::<usize>() < 2 {
        return result;
    }
    for item in groups.iter_mut().flatten() {
        let repeated = match &item.kind {
            Kind::Upper(base, counts) if counts.len() == 1 => Some((base, &counts[0])),
            Kind::Pow(base, count) if polar && !bases(count).is_empty() => Some((base, count.as_ref())),
            _ => None,
        };
        if let Some((base, count)) = repeated
            && matches!(base.kind, Kind::Name(_) | Kind::Number(_) | Kind::Accent(..))
        {
            item.kind = Kind::Brace(vec![base.as_ref().clone()], Some(Box::new(count.clone())));
        }
    }
    result
}

/// A formula in which the points b_i^r(t) of an algorithm are written b_i^r.
fn without_parameters(expr: &Expr) -> Expr {
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = without_parameters(child));
    let Kind::Apply(callee, groups) = &result.kind else { return result };
    let name = |item: &&Expr| matches!(item.kind, Kind::Name(_));
    let one = matches!(groups.as_slice(), [group] if matches!(group.as_slice(), [item] if name(&item)));
    let point = Head::of(callee).is_some_and(|head| {
        let (lower, upper) = (head.lower.len(), head.upper.len());
        head.arguments.is_none()
            && lower + upper > 1
            && families::notation(&head.base, lower, upper).is_none()
    });
    if one && point { callee.as_ref().clone() } else { result }
}

/// A formula in which b_i^{(1)} is a member of a family with another name.
fn without_marks(expr: &Expr) -> Expr {
    fn unmark(expr: &mut Expr) {
        // N_i'(t) is a derivative, y_0' the slope beside y_0.
        if let Kind::Apply(callee, groups) = &mut expr.kind
            && matches!(callee.kind, Kind::Prime(..))
        {
            return groups.iter_mut().flatten().for_each(unmark);
        }
        expr.for_each_child_mut(&mut unmark);
        if let Kind::Prime(base, order) = &expr.kind
            && let Kind::Subscript(letter, indices) = &base.kind
            && let Some(head) = Head::of(letter)
        {
            let marks = "'".repeat(*order as usize);
            let name = Expr::new(Kind::Name(format!("{}{marks}", head.base)), letter.span);
            expr.kind = Kind::Subscript(Box::new(name), indices.clone());
            return;
        }
        // b_i^*
        if let Kind::Pow(base, _) | Kind::Upper(base, _) | Kind::Accent(_, base) = &expr.kind
            && let Kind::Subscript(letter, indices) = &base.kind
            && let Some(head) = Head::of(expr)
            && head.upper.is_empty()
            && head.lower.len() == indices.len()
        {
            let name = Expr::new(Kind::Name(head.base), letter.span);
            expr.kind = Kind::Subscript(Box::new(name), indices.clone());
            return;
        }
        let Kind::Upper(base, upper) = &expr.kind else { return };
        let ([mark], Kind::Subscript(letter, indices)) = (upper.as_slice(), &base.kind) else { return };
        let mark = match &mark.kind {
            Kind::Number(number) => number.to_string(),
            Kind::Text(text) => text.clone(),
            _ => return,
        };
        let Some(head) = Head::of(letter) else { return };
        let name = Expr::new(Kind::Name(format!("{}({mark})", head.base)), letter.span);
        expr.kind = Kind::Subscript(Box::new(name), indices.clone());
    }
    let mut result = expr.clone();
    unmark(&mut result);
    result
}
