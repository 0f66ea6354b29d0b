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

use std::rc::Rc;

use self::entry::{Equation, Theorem, known};
use self::fit::{Claim, Instance, Standing};
use self::letters::{Profile, Way, ways};
use super::check::Checker;
use super::context::{Body, Context, Mark};
use super::finding::{Finding, Verdict};
use super::model::Choices;
use super::names::{Head, bases, walk};
use super::object::Sort;
use super::repair;
use super::statement::{Chain, Place, Role, Statement};
use super::topic::Topic;
use super::trial::{Setting, Trial};
use super::unfold;
use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::language::write;

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
        let plain = with_indices_apart([left, right]);
        let marked = plain.each_ref().map(without_marks);
        let forms = if marked == plain { vec![plain] } else { vec![plain, marked] };
        for form in &forms {
            let [left, right] = form;
            let claim = self.claim(left, right, chain, &statement.place);
            if claim.profile.letters.is_empty() {
                return None;
            }
            let instances = self.instances(&known, &claim, statement);
            let names = statement.role != Some(Role::Claimed)
                && finding.verdict == Verdict::Definition
                && self.names_a_value(left, right);
            if let Some(found) = self.among(&claim, &instances, finding, names, &long) {
                return found;
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
        let unlike = |theirs: &str, ours: &Expr| {
            roles::clash(theirs, ours, &self.context, claim.place)
                || roles::is_no_basis(theirs, ours, &self.context, claim.place)
        };
        if way.letters.iter().any(|(theirs, ours)| unlike(theirs, ours)) {
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

/// b_{ijk} beside b_{i-1,j,k}: indices that are written together.
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

/// A formula in which b_i^{(1)} is a member of a family with another name.
fn without_marks(expr: &Expr) -> Expr {
    fn unmark(expr: &mut Expr) {
        expr.for_each_child_mut(&mut unmark);
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
