//! Rival meanings: names that a page gives more than one meaning, in examples, items of a list, or for a comparison.
//!
//! **Rule.** A relation that fails is not wrong if it holds with another meaning that the page itself gives to a name in
//! it, before or after: which of them is meant was misunderstood. The other meaning must be one that the page gives
//! elsewhere, not in the relation, and not one that is its own slip said again.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::budget::Limits;
use crate::formula::{Expr, Kind, Link, Rel, interval};
use crate::judge::described::meanings::New;
use crate::judge::instances::setting;
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::definable;
use crate::judge::known::senses::{Appeal, Means, Sense};
use crate::judge::page::context::{Body, Context, Definition, Mark, Source, is_only_about, is_variable};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::Object;
use crate::judge::page::statement::{Chain, Place, Role, Said, Side, Statement};
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases, capital_of, is_index_letter, underived, walk};

/// Whether an equation says all of a name: a number, or a formula in its variables.
fn is_meaning(head: &Head, body: &Expr) -> bool {
    let variables = head.flat();
    let used = bases(body);
    let variable = |name: &String| is_variable(name) || used.contains(name);
    let named = variables.iter().all(|argument| matches!(&argument.kind, Kind::Name(name) if variable(name)));
    let own: BTreeSet<String> = variables.into_iter().flat_map(bases).collect();
    named && (head.arguments.is_none() || used.is_empty() || !used.is_disjoint(&own))
}

/// Whether formulas call a name with as many arguments as a head has, or do not call it at all.
fn is_called_like(head: &Head, sides: &[&Expr]) -> bool {
    let count = head.flat().len();
    let mut counts = BTreeSet::new();
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Apply(callee, groups) = &part.kind
                && Head::of(underived(callee)).is_some_and(|own| own.base == head.base)
            {
                counts.insert(groups.iter().flatten().count());
            }
        });
    }
    head.arguments.is_none() || counts.is_empty() || counts.contains(&count)
}

/// So many other meanings are tried for one formula.
const TRIES: usize = 24;

/// So many formulas of a page are looked at again: nobody writes pages on which more is wrong.
const MOST_APPEALS: usize = 100;

/// Other meanings of some names.
struct Rival {
    /// What they are, in words.
    what: String,
    means: Vec<Means>,
    /// The formula over another interval.
    chain: Option<Chain>,
}

/// x = a, f(t) = t^2: a name, and what it is said to be.
fn equation(left: &Expr, rel: Rel, right: &Expr) -> Option<Means> {
    let head = definable(left).filter(|_| matches!(rel, Rel::Eq | Rel::Define))?;
    let of_itself = bases(right).contains(&head.base) || right.kind == Kind::Ellipsis;
    (!of_itself).then(|| Means::Formula(head, right.clone()))
}

fn equations(expr: &Expr) -> Vec<Means> {
    match &expr.kind {
        Kind::Chain(left, links) => match links.as_slice() {
            [Link { rel, expr, .. }] => equation(left, *rel, expr).into_iter().collect(),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

fn interval_between(from: &Expr, to: &Expr) -> Option<Means> {
    (evaluator::number(from)? < evaluator::number(to)?).then(|| Means::Interval(from.clone(), to.clone()))
}

/// [0, 2], 0 ≤ t ≤ 2, t ∈ [0, 2]
fn ends(expr: &Expr) -> Option<Means> {
    if let Some(([from, to], _)) = interval(expr) {
        return interval_between(from, to);
    }
    let Kind::Chain(left, links) = &expr.kind else { return None };
    match links.as_slice() {
        [Link { rel: Rel::In, expr, .. }] => ends(expr),
        [Link { rel: Rel::Le | Rel::Lt, .. }, Link { rel: Rel::Le | Rel::Lt, expr, .. }] => {
            interval_between(left, expr)
        }
        _ => None,
    }
}

/// 1, 2, 1
fn list(expr: &Expr) -> Option<Means> {
    let items =
        expr.items().filter(|items| items.len() > 1 && items.iter().all(|item| bases(item).is_empty()))?;
    Some(Means::List(items.to_vec()))
}

impl Checker {
    /// Keeps what a statement says that names mean; `first` is the number of its first finding.
    pub(in crate::judge) fn note_senses(&mut self, statement: &Statement, first: usize) {
        let (mut means, finding) = match &statement.said {
            Said::Chain(chain) => {
                let [left, right, ..] = chain.sides.as_slice() else { return };
                let read = !left.is_unread() && !right.is_unread();
                let own = equation(&left.expr, chain.relations[0].0, &right.expr).filter(|_| read);
                // M_1 = M_2 = -6/5
                let value = chain.sides.last().filter(|side| bases(&side.expr).is_empty());
                let valued = value.filter(|_| chain.sides.len() > 2).map(|value| {
                    let named = chain.sides[..chain.sides.len() - 1].iter();
                    named.filter_map(|side| equation(&side.expr, Rel::Eq, &value.expr))
                });
                let means = own
                    .into_iter()
                    .chain(valued.into_iter().flatten())
                    .chain(chain.conditions.iter().flat_map(equations))
                    .collect();
                (means, Some(first))
            }
            Said::Condition(side) => {
                (equations(&side.expr).into_iter().chain(ends(&side.expr)).collect(), None)
            }
            Said::Object(object) if object.has_values() => {
                (vec![Means::Object(Rc::new(object.as_ref().clone()))], None)
            }
            Said::Bare(side, _) => {
                (ends(&side.expr).or_else(|| list(&side.expr)).into_iter().collect(), None)
            }
            _ => return,
        };
        let formula = statement.place.formula;
        // "from 0 to 2", "t_0 = 1, t_1 = 3"; 0, 2, 5 in one formula are a list.
        let (number, member) = match &statement.said {
            Said::Bare(side, _) => (Some(&side.expr), true),
            Said::Chain(chain) => (chain.sides.get(1).map(|side| &side.expr), false),
            _ => (None, false),
        };
        let number = number.filter(|expr| evaluator::number(expr).is_some()).cloned();
        let last = self.last_number.take();
        let listed = member && last.as_ref().is_some_and(|(other, _)| *other == formula);
        if let (Some(to), Some((_, Some(from))), false) = (&number, &last, listed) {
            means.extend(interval_between(from, to));
        }
        self.last_number = number.map(|number| (formula, (!listed).then_some(number)));
        // 1, 2, 1 are three statements of one formula.
        if let Said::Bare(Side { expr, .. }, _) = &statement.said
            && let (true, []) = (bases(expr).is_empty(), means.as_slice())
        {
            match self.senses.last_mut() {
                Some(Sense { means: Means::List(items), formula: own, .. }) if *own == formula => {
                    items.push(expr.clone());
                }
                _ => means.push(Means::List(vec![expr.clone()])),
            }
        }
        let supposed = matches!(statement.role, Some(Role::Assumed | Role::Introduced));
        let new =
            means.into_iter().map(|means| Sense { supposed, finding, ..Sense::at(&statement.place, means) });
        self.senses.extend(new);
    }

    /// Keeps a formula of which a relation is or may become refuted.
    pub(in crate::judge) fn note_appeal(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        before: Mark,
        findings: &[Finding],
    ) {
        let first = self.findings.len();
        let pending = self.uses.iter().rev().take_while(|one| one.finding >= first);
        let refuted = findings.iter().any(|finding| finding.verdict == Verdict::Refuted);
        let may_be = refuted || pending.into_iter().any(|one| one.wrong.is_some());
        if may_be && self.appeals.len() < MOST_APPEALS {
            let (chain, statement) = (chain.clone(), statement.clone());
            let mut known = self.context.clone();
            Rc::make_mut(&mut known).forget(before);
            self.appeals.push(Appeal { first, chain, statement, known });
        }
    }

    /// Takes back what was refuted and holds with another meaning that the page gives to a name in it. To be called
    /// after the last statement.
    ///
    /// Cost: at most twice [`TRIES`] times that of each of the first [`MOST_APPEALS`] formulas that are refuted.
    pub(in crate::judge) fn hear_appeals(&mut self) {
        let appeals = std::mem::take(&mut self.appeals);
        let senses = std::mem::take(&mut self.senses);
        for appeal in appeals {
            let count = appeal.chain.relations.len();
            let refuted = |own: &Self| {
                let own = &own.findings[appeal.first..appeal.first + count];
                own.iter().any(|finding| finding.verdict == Verdict::Refuted)
            };
            if !refuted(self) {
                continue;
            }
            let mut rivals = self.rivals(&appeal, &senses);
            rivals.extend(self.other_curves(&appeal, &senses));
            rivals.extend(over_other_intervals(&appeal, &senses));
            for rival in rivals {
                let Some(findings) = self.judged_with(&appeal, &rival) else { continue };
                let reason = match rival.means.as_slice() {
                    [Means::Usual(base)] => format!(
                        "it holds with the usual meaning of {base}, not that of the page: which one is meant?"
                    ),
                    _ => format!("it holds with {} of the page: which one is meant?", rival.what),
                };
                for (at, found) in findings.iter().enumerate() {
                    let own = &mut self.findings[appeal.first + at];
                    let holds = matches!(found.verdict, Verdict::Proved | Verdict::Sampled);
                    if own.verdict == Verdict::Refuted && holds {
                        *own = Finding {
                            verdict: Verdict::Undecided,
                            reason: Some(reason.clone()),
                            witness: None,
                            suggestion: None,
                            evidence: Vec::new(),
                            ..own.clone()
                        };
                    }
                }
                if !refuted(self) {
                    break;
                }
            }
            if let Some((line, doubtful)) = self.line_of_another(&appeal, &senses) {
                let own = &mut self.findings[appeal.first];
                let other =
                    format!("it may be another function: line {line} gives this name another formula");
                *own = Finding {
                    verdict: Verdict::Undecided,
                    reason: Some(other),
                    warning: own.reason.take().filter(|_| doubtful),
                    evidence: Vec::new(),
                    ..own.clone()
                };
            }
        }
    }

    /// Takes back what holds with the values of an example only, and is said of any: "let p(t) = t^2. … For every
    /// polynomial p of degree two, p(0) = 0".
    ///
    /// Cost: that of the formula once more, where a sentence releases a name.
    pub(in crate::judge) fn as_said_of_any(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let holds = |finding: &Finding| matches!(finding.verdict, Verdict::Proved | Verdict::Sampled);
        let place = &statement.place;
        let released = &statement.released;
        let given = || {
            released.iter().any(|name| self.context.visible(name, place).next().is_some())
                || self.context.conditions.iter().any(|own| is_only_about(&own.expr, released))
                || self.context.heard.iter().any(|(_, own)| is_only_about(own, released))
        };
        let refuted = |finding: &Finding| finding.verdict == Verdict::Refuted;
        let decided = |finding: &Finding| holds(finding) || refuted(finding);
        if released.is_empty() || !findings.iter().any(decided) || !given() {
            return;
        }
        let mut known = self.context.clone();
        Rc::make_mut(&mut known).forget(before);
        let other = known.without_examples(released);
        if other.mark() == known.mark() && other.heard.len() == known.heard.len() {
            return;
        }
        let before = other.mark();
        let mut other = Checker { before, ..self.aside(Rc::new(other)) };
        let found = other.judged(chain, statement, before).unwrap_or_default();
        for (at, finding) in findings.iter_mut().enumerate().filter(|(_, finding)| holds(finding)) {
            if !found.get(at).is_some_and(holds) {
                finding.verdict = Verdict::Undecided;
                finding.reason = Some("it holds in an example before: is it said of any other?".to_owned());
                finding.instances = None;
            }
        }
        // What is wrong in an example only is not wrong of others.
        for (at, finding) in findings.iter_mut().enumerate().filter(|(_, finding)| refuted(finding)) {
            if let Some(found) = found.get(at).filter(|found| !refuted(found)) {
                *finding = found.clone();
            }
        }
    }

    /// The line with the formula of a function that another sentence gives a second formula, without a word that would
    /// make it a claim: "The surface x(u, v) = … . The surface x(u, v) = …". Or after a third one of its own paragraph:
    /// "For cubics d_i = … , and f = x^2 gives d_i = …", where another paragraph says what d_i is for quadratics. Tells
    /// whether it may be a slip, which only the first may.
    fn line_of_another(
        &self,
        Appeal { first, chain, statement, known }: &Appeal,
        senses: &[Sense],
    ) -> Option<(usize, bool)> {
        let place = &statement.place;
        let refuted = self.findings[*first].verdict == Verdict::Refuted;
        let named = |argument: &&Expr| matches!(&argument.kind, Kind::Name(name) if is_variable(name) || is_index_letter(name));
        let places = |head: &Head| -> usize { head.lower.len() + head.flat().len() };
        let any =
            |head: &Head| places(head) > 0 && head.lower.iter().chain(head.flat()).all(|one| named(&one));
        let renewed = |head: &Head| {
            let anew = senses.iter().any(|sense| {
                let same = |own: &Head| own.base == head.base && any(own) && places(own) == places(head);
                sense.paragraph == place.group
                    && sense.formula < place.formula
                    && matches!(&sense.means, Means::Formula(own, _) if same(own))
            });
            let mut given = known.visible(&head.base, place);
            anew && given.all(|(_, own, _)| own.place.group != place.group)
        };
        let silent = matches!(statement.role, None | Some(Role::Introduced)) && !chain.universal;
        let head = Head::of(&chain.sides[0].expr).filter(|head| refuted && any(head))?;
        let doubtful = !renewed(&head);
        if doubtful && !(silent && head.arguments.is_some()) {
            return None;
        }
        let mut given = known.visible(&head.base, &statement.place);
        given.find_map(|(_, own, near)| {
            let same = near && own.head.flat().len() == head.flat().len() && any(&own.head);
            (same && own.head.lower.len() == head.lower.len()).then_some((own.line, doubtful))
        })
    }

    /// Other meanings of the names of a formula, alone and with those of their paragraph.
    fn rivals(&self, appeal: &Appeal, senses: &[Sense]) -> Vec<Rival> {
        let Appeal { chain, statement, known, first } = appeal;
        let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
        let place = &statement.place;
        let mut reached = known.reached(&sides, place);
        // f is the polar form of F.
        let capitals: Vec<String> = reached.iter().map(|base| capital_of(base)).collect();
        reached.extend(capitals);
        let own = *first..*first + chain.relations.len();
        let is_meant = |object: &Object| {
            let named = object.names.iter().filter_map(Head::of);
            let mut told = named.filter_map(|head| known.object_called(&head.base, place));
            told.any(|told| *told.object == *object)
        };
        let is_rival = |sense: &Sense| {
            let refuted = |finding: usize| {
                self.findings.get(finding).is_some_and(|finding| finding.verdict == Verdict::Refuted)
            };
            let other = match &sense.means {
                Means::Formula(head, body) => {
                    // The slip itself, said again
                    let same_name = Head::of(sides[0]).is_some_and(|own| {
                        let arguments = own.flat().into_iter().zip(head.flat());
                        own.base == head.base && arguments.into_iter().all(|(a, b)| a.same_as(b))
                    });
                    let same = same_name && sides.iter().any(|side| side.same_as(body));
                    let refuted = sense.finding.is_some_and(refuted);
                    let member = sense.supposed && !head.lower.is_empty() && head.arguments.is_none();
                    (member || is_meaning(head, body))
                        && is_called_like(head, &sides)
                        && (head.arguments.is_some() || !refuted)
                        && !same
                        && self.is_of_example(&head.base, known, place)
                }
                Means::Object(object) => object.is_function() && !is_meant(object),
                Means::Usual(_) => true,
                Means::List(_) | Means::Interval(..) => false,
            };
            let elsewhere = !sense.finding.is_some_and(|finding| own.contains(&finding));
            let near =
                sense.scope == place.scope && place.blocks.iter().all(|block| sense.blocks.contains(block));
            elsewhere && near && other && sense.bases().iter().any(|base| reached.contains(base))
        };
        let all: Vec<&Sense> = senses.iter().filter(|sense| is_rival(sense)).collect();
        let distance = |senses: &[&Sense]| senses[0].formula.abs_diff(place.formula);
        let mut alone: Vec<&[&Sense]> = all.chunks(1).collect();
        alone.sort_by_key(|one| distance(one));
        let paragraphs = all.chunk_by(|a, b| a.paragraph == b.paragraph);
        let mut together: Vec<&[&Sense]> = paragraphs.filter(|all| all.len() > 1).collect();
        together.sort_by_key(|all| distance(all));
        together.truncate(TRIES / 3);
        alone.truncate(TRIES - together.len());
        let rival = |senses: &[&Sense]| Rival {
            what: format!("another {}", senses[0].bases().first().map_or("", String::as_str)),
            means: senses.iter().map(|sense| sense.means.clone()).collect(),
            chain: None,
        };
        alone.into_iter().chain(together).map(rival).collect()
    }

    /// Whether the values or the formula of an example are known of a name, so that what fails does so with these.
    fn is_of_example(&self, base: &str, known: &Context, place: &Place) -> bool {
        let closed = |own: &Definition| match &own.body {
            Body::Formula(body) => is_meaning(&own.head, body),
            Body::Value(_) => true,
        };
        // The polar form of t^2 + 4t, but not that of any F
        let formula = |of: &Expr| bases(of).iter().all(|name| is_variable(name));
        let given =
            |own: &Object| own.has_data() || !own.values.is_empty() || own.of.as_ref().is_some_and(formula);
        known.visible(base, place).any(|(_, own, near)| near && closed(own))
            || known.object_called(base, place).is_some_and(|told| given(&told.object))
            || known.values_heard(|other| other.group == place.group).any(|(name, _)| name == base)
    }

    /// The curve of which a value is given, with other points or weights or over another interval that the page names.
    fn other_curves(&mut self, appeal: &Appeal, senses: &[Sense]) -> Vec<Rival> {
        let Appeal { chain, statement, known, .. } = appeal;
        let here = self.aside(known.clone());
        let mut found = Vec::new();
        for sides in chain.sides.windows(2) {
            let (left, right) = (&sides[0].expr, &sides[1].expr);
            let Kind::Apply(callee, _) = &left.kind else { continue };
            let Some(name) = Head::of(underived(callee)) else { continue };
            let told = known.object_called(&name.base, &statement.place).map(|told| &*told.object);
            let told = told.filter(|object| !object.points.is_empty()).cloned();
            let others =
                || New::of(left, right).map(|new| here.curves(&new, right, statement)).unwrap_or_default();
            let others = || others().into_iter().filter_map(|curve| curve.object);
            for object in told.map_or_else(|| others().collect(), |own| vec![own]) {
                let names = vec![underived(callee).clone()];
                let object = Object { names, of: None, ..object };
                found.extend(senses.iter().filter_map(|sense| otherwise(&object, sense)));
            }
        }
        found.truncate(TRIES);
        found
    }

    /// A checker for a second look, to which nothing but what is known matters.
    fn aside(&mut self, context: Rc<Context>) -> Checker {
        let findings = std::mem::take(&mut self.findings);
        let uses = std::mem::take(&mut self.uses);
        let other = Checker { context, confirming: true, ..self.clone() };
        (self.findings, self.uses) = (findings, uses);
        other
    }

    /// What would be found with other meanings.
    fn judged_with(&mut self, appeal: &Appeal, rival: &Rival) -> Option<Vec<Finding>> {
        let Appeal { statement, known, .. } = appeal;
        let chain = rival.chain.as_ref().unwrap_or(&appeal.chain);
        let limits = Limits { steps: Some(setting::share(&self.limits, 2)), ..self.limits.clone() };
        let mut other = Checker { limits, ..self.aside(known.clone()) };
        for means in &rival.means {
            match means {
                Means::Formula(head, body) => {
                    // y = x^2/2, where x was a function of t before
                    let free: Vec<String> = match head.arguments {
                        None if head.lower.is_empty() => {
                            bases(body).into_iter().filter(|name| is_variable(name)).collect()
                        }
                        _ => Vec::new(),
                    };
                    if head.arguments.is_some() {
                        let apart = other.context.without_objects(std::slice::from_ref(&head.base));
                        other.context = Rc::new(apart);
                    }
                    if !free.is_empty() {
                        other.context = Rc::new(other.context.without(&free));
                    }
                    let (head, body) = (head.clone(), Body::Formula(body.clone()));
                    other.define_by(Source::Given, head, body, &[], &statement.place, chain.whole().span);
                }
                Means::Object(object) => other.object(object, &statement.place),
                Means::Usual(base) => {
                    other.context = Rc::new(other.context.without(std::slice::from_ref(base)));
                }
                Means::List(_) | Means::Interval(..) => {}
            }
        }
        let before = other.context.mark();
        other.before = before;
        other.judged(chain, statement, before).ok()
    }
}

/// A formula for a range, with the one on its other side: "on [0, 1] it is N(t) = …, on [1, 2] it is …".
fn over_other_intervals(appeal: &Appeal, senses: &[Sense]) -> Vec<Rival> {
    let Appeal { chain, statement, .. } = appeal;
    let mut found = Vec::new();
    for (at, condition) in chain.conditions.iter().enumerate() {
        let Some(Means::Interval(from, to)) = ends(condition) else { continue };
        // Right before or after it
        let others = senses.iter().filter(|sense| sense.formula.abs_diff(statement.place.formula) == 1);
        for sense in others {
            let Means::Interval(start, end) = &sense.means else { continue };
            if start.same_as(&from) && end.same_as(&to) {
                continue;
            }
            let mut other = chain.clone();
            exchange(&mut other.conditions[at], &[(&from, start), (&to, end)]);
            found.push(Rival { what: "another interval".to_owned(), means: Vec::new(), chain: Some(other) });
        }
    }
    found.truncate(TRIES);
    found
}

/// Puts something in the place of parts of a formula.
fn exchange(expr: &mut Expr, pairs: &[(&Expr, &Expr)]) {
    match pairs.iter().find(|(old, _)| expr.same_as(old)) {
        Some((_, new)) => *expr = (*new).clone(),
        None => expr.for_each_child_mut(&mut |child| exchange(child, pairs)),
    }
}

/// A curve with points or weights that a page lists, or over an interval that it names.
fn otherwise(object: &Object, sense: &Sense) -> Option<Rival> {
    let own = |what: &str, object: Object| {
        let means = vec![Means::Object(Rc::new(object))];
        Some(Rival { what: what.to_owned(), means, chain: None })
    };
    match &sense.means {
        Means::Interval(from, to) => {
            own("another interval", Object { interval: Some((from.clone(), to.clone())), ..object.clone() })
        }
        Means::List(items) if items.len() == object.points.len() && items[0].items().is_none() => {
            own("the weights", Object { weights: items.clone(), ..object.clone() })
        }
        _ => None,
    }
}
