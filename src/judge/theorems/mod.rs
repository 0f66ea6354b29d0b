//! What the field knows of quantities that the page does not determine: degree elevation, knot insertion, …
//!
//! **Definition.** A claim is an *instance* of a theorem if the theorem belongs to a topic of the section, the left
//! sides agree up to the letters, and the letters of the right side can be exchanged for those of the claim, points
//! for points, knots for knots, sizes for sizes. The claim *fits* if both right sides are equal then, by the same
//! trial as for any claim.
//!
//! What fits is proved or sampled. What fits no theorem is wrong only if it is one slip away from one: a page may call
//! anything c_i.

mod table;

use std::cell::LazyCell;
use std::rc::Rc;

use self::table::{THEOREMS, Theorem};
use super::check::Checker;
use super::compare;
use super::context::{Context, Mark};
use super::evaluator::evaluate_reading;
use super::finding::{Finding, Verdict};
use super::model::{Choices, Model};
use super::names::{Head, bases, is_index_letter, own_names, walk};
use super::object::Sort;
use super::repair;
use super::statement::{Chain, Place, Statement};
use super::tally::Outcomes;
use super::topic::Topic;
use super::trial::{Setting, Trial};
use super::unfold;
use super::witness;
use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::language::{latex, write};

/// So many ways to exchange the letters are tried for one theorem.
const MOST_WAYS: usize = 48;

/// A theorem as a tree: its left side, its right sides, each with whether it counts orders.
struct Read {
    theorem: &'static Theorem,
    left: Expr,
    rights: Vec<(Expr, bool)>,
}

thread_local! {
    static READ: Vec<Read> = THEOREMS.iter().filter_map(read).collect();
}

fn read(theorem: &'static Theorem) -> Option<Read> {
    let left = latex::read(theorem.left).ok()?;
    let rights = [(Some(theorem.right), false), (theorem.by_order, true)];
    let rights = rights.into_iter().filter_map(|(text, order)| Some((latex::read(text?).ok()?, order)));
    Some(Read { theorem, left, rights: rights.collect() })
}

/// A right side that a theorem may mean here.
struct Instance {
    theorem: &'static Theorem,
    right: Expr,
    /// Whether its sizes are those that the words of the page give, as far as they matter.
    certain: bool,
    /// Whether a size is taken for one less than it is said to be: what fits this only is a slip.
    shifted: bool,
}

/// Letters of a theorem and what stands in their place.
type Letters = Vec<(String, Expr)>;

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
            let setting = self.setting(chain, &statement.place, statement.curve());
            let found = budget::run(&limits, || self.by_theorems(&setting, at, statement, finding));
            let Ok(Some(found)) = found else { continue };
            if found.verdict == Verdict::Refuted {
                Rc::make_mut(&mut self.context).forget(before);
            }
            *finding = found;
        }
    }

    /// Judges a relation of a chain by what the field knows of its left side, if that decides it.
    fn by_theorems(
        &self,
        setting: &Setting,
        at: usize,
        statement: &Statement,
        finding: &Finding,
    ) -> Option<Finding> {
        let chain = setting.chain;
        let (left, right) = (&chain.sides[at].expr, main_case(&chain.sides[at + 1].expr));
        // Numbers may be equal by chance.
        if chain.relations[at].0 != Rel::Eq
            || Kinds::of(right).families.is_empty()
            || chain.sides[at].is_unread()
            || chain.sides[at + 1].is_unread()
        {
            return None;
        }
        let start = budget::spent();
        let long = || budget::spent() - start > super::trial::share(&self.limits, 2);
        let instances = READ.with(|known| {
            let one_length = self.context.letters.has_one_length();
            let uneven = self.context.has_uneven_knots(setting.place);
            // Knots that have names may be at equal distances.
            let even = |topic: Topic| if topic == Topic::Spline { !uneven } else { one_length };
            let spoken = known.iter().filter(|Read { theorem, .. }| {
                statement.topics.has(theorem.topic) && (!theorem.equal_lengths || even(theorem.topic))
            });
            spoken.flat_map(|read| self.instances(read, left, right, statement)).collect::<Vec<_>>()
        });
        // Numbers may be equal by chance.
        let number = LazyCell::new(|| {
            let model = Model::new(self.context.clone(), setting.place.clone(), Choices::default(), None);
            let value = evaluate_reading(right, Rc::new(model), []);
            value.is_ok_and(|value| compare::symbols(&value).is_empty())
        });
        let mut slip: Option<(&Instance, Expr)> = None;
        let mut doubt = false;
        for instance in &instances {
            if long() {
                return None;
            }
            let outcomes = held(&self.bare(setting, right, &instance.right)).or_else(|| match *number {
                true => None,
                false => held(&self.with_what_is_given(setting, right, &instance.right)),
            });
            let Some(outcomes) = outcomes else { continue };
            if !instance.certain {
                doubt = true;
                continue;
            }
            if instance.shifted {
                slip = instances
                    .iter()
                    .find(|other| {
                        other.theorem.name == instance.theorem.name && other.certain && !other.shifted
                    })
                    .map(|meant| (meant, meant.right.clone()));
                continue;
            }
            let ranged = !outcomes.integers.is_empty() || outcomes.degrees;
            return Some(Finding {
                verdict: if ranged { Verdict::Sampled } else { Verdict::Proved },
                reason: Some(format!("{}, as the field has it", instance.theorem.name)),
                witness: None,
                suggestion: None,
                ..finding.clone()
            });
        }
        if doubt {
            return None;
        }
        let meant = instances
            .iter()
            .filter(|instance| instance.certain && !instance.shifted && alike(right, &instance.right));
        let one_slip_away = |instance: &Instance| {
            let edits = repair::edits(right, left, &None).into_iter();
            let mut edits = edits.take_while(|_| !long());
            edits.find(|edit| held(&self.bare(setting, edit, &instance.right)).is_some())
        };
        let (instance, repaired) = slip
            .or_else(|| meant.into_iter().find_map(|instance| Some((instance, one_slip_away(instance)?))))?;
        let outcomes = self.bare(setting, right, &instance.right).first(6);
        let fails = &outcomes.tallies[0].fails;
        let failure = fails.iter().find(|failure| failure.inner).or(fails.first())?;
        Some(Finding {
            verdict: Verdict::Refuted,
            reason: Some(format!("it differs from {}", instance.theorem.name)),
            witness: witness::counterexample(failure),
            suggestion: Some(write::latex(&Expr::relation(left.clone(), Rel::Eq, repaired))),
            ..finding.clone()
        })
    }

    /// Two formulas with the points and knots that the page gives.
    fn with_what_is_given<'a>(&self, setting: &Setting<'a>, right: &'a Expr, wanted: &'a Expr) -> Trial<'a> {
        self.trial(&setting.without_equations(), &[right, wanted], &[Rel::Eq], Choices::default())
    }

    /// Whether two formulas are equal, whatever their letters mean.
    pub(super) fn agree(&self, setting: &Setting, one: &Expr, other: &Expr) -> bool {
        held(&self.bare(setting, one, other)).is_some()
    }

    /// Two formulas without anything that the page says of their letters.
    fn bare<'a>(&self, setting: &Setting<'a>, right: &'a Expr, wanted: &'a Expr) -> Trial<'a> {
        let setting = Setting { facts: Rc::default(), curve: None, ..*setting };
        let nothing = Rc::new(Context::new(self.context.letters.clone()));
        let sides = vec![right, wanted];
        Trial::new(nothing, &setting, sides, vec![Rel::Eq], Choices::default(), &self.limits)
    }

    /// The right sides that a theorem may mean here.
    fn instances(&self, read: &Read, left: &Expr, right: &Expr, statement: &Statement) -> Vec<Instance> {
        let Some(letters) = left_letters(&read.left, left) else { return Vec::new() };
        let theorem = read.theorem;
        let mut found = Vec::new();
        // c_i = c_{i+n}, of a closed curve, is no formula for c_i.
        let own =
            |expr: &Expr, side: &Expr| Head::of(expr).is_some_and(|head| bases(side).contains(&head.base));
        let marked = Head::of(left).is_some_and(|head| !head.upper.is_empty());
        if !marked && own(left, right) && !read.rights.iter().any(|(theirs, _)| own(&read.left, theirs)) {
            return found;
        }
        for (wanted, order) in &read.rights {
            for letters in ways(theorem, wanted, right, &letters, statement) {
                let size = letters.iter().find(|(letter, _)| letter == "n").map(|(_, size)| size.clone());
                let said = size.as_ref().and_then(|size| self.said_as_order(size, &statement.place));
                let mut add = |letters: &Letters, certain: bool, shifted: bool| {
                    let right = put(wanted, letters, left);
                    found.push(Instance { theorem, right, certain, shifted });
                };
                if theorem.by_order.is_some() {
                    // Where words say that it is the degree, the other is the likely slip. Many say order for the degree.
                    match said {
                        Some(true) if !order => add(&letters, false, false),
                        Some(said) => add(&letters, true, said != *order),
                        None => add(&letters, !order, false),
                    }
                    continue;
                }
                add(&letters, true, false);
                // From degree n - 1 to n, or from n to n + 1
                if let Some(size @ Expr { kind: Kind::Name(_), .. }) = &size {
                    let less = size.clone().plus(-1);
                    let by = |(letter, own): &(String, Expr)| match letter.as_str() {
                        "n" => (letter.clone(), less.clone()),
                        _ => (letter.clone(), own.clone()),
                    };
                    add(&letters.iter().map(by).collect(), said == Some(false), true);
                }
            }
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
}

/// Whether a formula has about the form of a theorem: as many members of families, or one more or fewer of many,
/// and no sum that has no terms to speak of.
fn alike(right: &Expr, wanted: &Expr) -> bool {
    let members = |expr: &Expr| {
        let (mut count, mut trivial) = (0usize, false);
        walk(expr, &mut |part| match &part.kind {
            Kind::Subscript(..) => count += 1,
            Kind::Big { upper: Some(upper), .. } => {
                trivial |= matches!(&upper.kind, Kind::Number(q) if *q <= crate::math::number::integer(1));
            }
            _ => {}
        });
        (count, trivial)
    };
    let ((own, _), (theirs, trivial)) = (members(right), members(wanted));
    let sum = |expr: &Expr| {
        let mut found = false;
        walk(expr, &mut |part| found |= matches!(part.kind, Kind::Big { .. }));
        found
    };
    let written_out = sum(wanted) && !sum(right) && own > 1;
    !trivial && (own == theirs || theirs > 2 && own.abs_diff(theirs) == 1 || written_out)
}

/// What came of two formulas that are equal wherever they make sense.
fn held(trial: &Trial) -> Option<Outcomes> {
    let quick = repair::is_true(&trial.first(4), true);
    quick.then(|| trial.run()).filter(|outcomes| repair::is_true(outcomes, false))
}

/// The ways to put letters of the claim for those of a theorem that its left side leaves open.
fn ways(
    theorem: &Theorem,
    wanted: &Expr,
    right: &Expr,
    letters: &Letters,
    statement: &Statement,
) -> Vec<Letters> {
    let theirs = Kinds::of(wanted);
    let ours = Kinds::of(right);
    let given = |letter: &String| letters.iter().any(|(known, _)| known == letter);
    let taken = |expr: &Expr| is_variable_of(expr) && letters.iter().any(|(_, known)| known.same_as(expr));
    // "A cubic"; "a parabola, as a cubic".
    let degrees: Vec<i64> = statement.topics.degrees().collect();
    let degree = match (theorem.topic, degrees.as_slice()) {
        (Topic::Elevation, &[from, to]) if to == from + 1 => Some(from),
        (Topic::Spline | Topic::Join, &[only]) => Some(only),
        _ => None,
    };
    let sizes: Vec<Expr> = ours.sizes.iter().cloned().chain(degree.map(Expr::int)).collect();
    let mut all = vec![letters.clone()];
    for (wanted, candidates) in
        [(&theirs.families, &ours.families), (&theirs.sizes, &sizes), (&theirs.variables, &ours.variables)]
    {
        // The parameter t and the knots t_i are different things.
        let others = all.first().map_or(0, Vec::len);
        for letter in wanted {
            let Kind::Name(letter) = &letter.kind else { return Vec::new() };
            if given(letter) {
                continue;
            }
            let mut next = Vec::new();
            for way in &all {
                let free = candidates.iter().filter(|candidate| {
                    !taken(candidate) && !way[others..].iter().any(|(_, known)| known.same_as(candidate))
                });
                next.extend(free.map(|candidate| {
                    let mut way = way.clone();
                    way.push((letter.clone(), candidate.clone()));
                    way
                }));
            }
            next.truncate(MOST_WAYS);
            all = next;
        }
    }
    all
}

/// Whether it is a name of an integer, or of a variable: one stands for one thing only. The points b and b^{(1)} are
/// two families with one letter.
fn is_variable_of(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Name(name) if is_index_letter(name))
}

/// The letters of a formula by what they are used as.
#[derive(Default)]
struct Kinds {
    /// With an index below.
    families: Vec<Expr>,
    /// Names of integers that no sum binds.
    sizes: Vec<Expr>,
    /// Other names.
    variables: Vec<Expr>,
}

impl Kinds {
    fn of(expr: &Expr) -> Kinds {
        let mut kinds = Kinds::default();
        let mut bound: Vec<String> = Vec::new();
        walk(expr, &mut |part| {
            if let Kind::Big { lower, .. } = &part.kind {
                bound.extend(own_names(lower));
            }
        });
        kinds.look(expr, &bound);
        kinds
    }

    fn look(&mut self, expr: &Expr, bound: &[String]) {
        let add = |list: &mut Vec<Expr>, expr: &Expr| {
            if !list.iter().any(|known| known.same_as(expr)) {
                list.push(expr.clone());
            }
        };
        match &expr.kind {
            Kind::Subscript(base, indices) => {
                add(&mut self.families, base);
                for index in indices {
                    self.look(index, bound);
                }
            }
            Kind::Name(name) if is_index_letter(name) => {
                if !bound.contains(name) {
                    add(&mut self.sizes, expr);
                }
            }
            Kind::Name(name) if bound.contains(name) => {}
            Kind::Name(_) | Kind::Accent(..) => add(&mut self.variables, expr),
            _ => expr.for_each_child(&mut |child| self.look(child, bound)),
        }
    }
}

/// What the letters on the left of a theorem stand for in the left side of a claim, if that has its form.
fn left_letters(pattern: &Expr, left: &Expr) -> Option<Letters> {
    let (theirs, ours) = (Head::of(pattern)?, Head::of(left)?);
    if theirs.arguments.is_some() != ours.arguments.is_some() || theirs.flat().len() != ours.flat().len() {
        return None;
    }
    let inner = |index: &Expr| match &index.kind {
        Kind::List(items) if items.len() == 1 => items[0].clone(),
        Kind::Group(inner) => inner.as_ref().clone(),
        _ => index.clone(),
    };
    let indices = |head: &Head| -> Vec<Expr> { head.lower.iter().chain(&head.upper).map(inner).collect() };
    let (wanted, mut given) = (indices(&theirs), indices(&ours));
    // b_i^{(1)}, b_i^*: a mark, not an index.
    let mark = |index: &Expr| match &index.kind {
        Kind::Name(name) => !is_index_letter(name),
        Kind::Number(_) => ours.parenthesized,
        Kind::Text(_) => true,
        _ => false,
    };
    if given.len() == wanted.len() + 1 && ours.upper.len() == 1 && mark(&ours.upper[0]) {
        given.pop();
    }
    if wanted.len() != given.len() {
        return None;
    }
    let mut letters: Letters = vec![(theirs.base.clone(), base_of(left).clone())];
    let pairs = wanted.iter().zip(&given).chain(theirs.flat().into_iter().zip(ours.flat()));
    for (pattern, index) in pairs {
        if !unify(pattern, index, &mut letters) {
            return None;
        }
    }
    Some(letters)
}

/// The letter of a name, with its marks.
fn base_of(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Subscript(base, _) | Kind::Pow(base, _) | Kind::Upper(base, _) | Kind::Apply(base, _) => {
            base_of(base)
        }
        _ => expr,
    }
}

/// Whether an index has the form of a pattern; its letters are noted.
fn unify(pattern: &Expr, index: &Expr, letters: &mut Letters) -> bool {
    match (&pattern.kind, &index.kind) {
        (Kind::Name(letter), _) => match letters.iter().find(|(known, _)| known == letter) {
            Some((_, known)) => known.same_as(index),
            None => {
                letters.push((letter.clone(), index.clone()));
                true
            }
        },
        (Kind::Add(wanted), Kind::Add(given)) => {
            wanted.len() == given.len()
                && wanted.iter().zip(given).all(|(a, b)| a.sign == b.sign && unify(&a.expr, &b.expr, letters))
        }
        (Kind::Mul(wanted), Kind::Mul(given)) => {
            wanted.len() == given.len() && wanted.iter().zip(given).all(|(a, b)| unify(a, b, letters))
        }
        _ => pattern.same_as(index),
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

/// A formula of a theorem in the letters of the claim, with the indices of a family above or below as the claim has
/// them.
fn put(expr: &Expr, letters: &Letters, left: &Expr) -> Expr {
    let raised = Head::of(left).is_some_and(|head| head.lower.len() == 1 && head.upper.len() == 1);
    let mut result = expr.clone();
    unfold::put(&mut result, letters);
    if raised {
        raise(&mut result, base_of(left));
    }
    if Head::of(left).is_some_and(|head| head.parenthesized) {
        parenthesize(&mut result);
    }
    result.without_spans()
}

/// w_i^{r-1} as w_i^{(r-1)}.
fn parenthesize(expr: &mut Expr) {
    expr.for_each_child_mut(&mut |child| parenthesize(child));
    if let Kind::Pow(base, upper) = &expr.kind
        && matches!(base.kind, Kind::Subscript(..))
    {
        *expr = Expr::new(Kind::Upper(base.clone(), vec![upper.as_ref().clone()]), expr.span);
    }
}

/// N_{i,k} as N_i^k.
fn raise(expr: &mut Expr, family: &Expr) {
    expr.for_each_child_mut(&mut |child| raise(child, family));
    if let Kind::Subscript(base, indices) = &expr.kind
        && base.same_as(family)
        && let [i, k] = indices.as_slice()
    {
        let lower = Expr::new(Kind::Subscript(base.clone(), vec![i.clone()]), expr.span);
        *expr = Expr::new(Kind::Pow(Box::new(lower), Box::new(k.clone())), expr.span);
    }
}
