//! What the page supposes of the names of a relation and the judge does not use: a relation that fails may rest on it.
//!
//! **Rule.** Red is certain only if all is used that the section says of what a relation speaks of: in words that are
//! not understood, in laws such as f(t) = f(1 - t) that stay open, and in equations between members of one family.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition, is_variable};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::{Declared, Object, Sort, UNNAMED};
use crate::judge::page::statement::{Chain, Place, Statement, equates_values};
use crate::judge::page::topic::Topic;
use crate::judge::values::compare;
use crate::judge::written::names::{Head, bases, integer_names, is_index_letter};
use crate::language::lexicon::roles::is_control_point;

/// Whether two heads are those of one thing: b_1, or p(t) and p(x).
fn is_same(one: &Head, other: &Head) -> bool {
    one.lower.len() == other.lower.len()
        && one.upper.len() == other.upper.len()
        && one.flat().len() == other.flat().len()
        && one.lower.iter().zip(&other.lower).all(|(a, b)| a.same_as(b))
}

impl Checker {
    /// Keeps open what was called wrong if something that the page supposes may have been needed for it.
    pub(in crate::judge) fn as_supposed(
        &self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
    ) {
        let place = &statement.place;
        // The field knows what rational curves are, and what d_1, d_2 or N_0, N_1 are, consecutive or normalised.
        let rational = statement.topics.has(Topic::Rational);
        let one = |expr: &Expr| match &expr.kind {
            Kind::Apply(callee, _) => match &callee.kind {
                Kind::Prime(inner, _) => matches!(inner.kind, Kind::Name(_)),
                own => matches!(own, Kind::Name(_)),
            },
            _ => false,
        };
        for (at, finding) in findings.iter_mut().enumerate() {
            let sides = [&chain.sides[at].expr, &chain.sides[at + 1].expr];
            if matches!(finding.verdict, Verdict::Proved | Verdict::Sampled)
                && let Some(reason) = self.replaced_data(sides, place)
            {
                finding.verdict = Verdict::Undecided;
                finding.reason = Some(reason);
            }
            if finding.verdict != Verdict::Refuted {
                continue;
            }
            let unknown = (!rational && sides.iter().any(|side| side.has(&one)))
                .then(|| self.said_in_unknown_words(sides, place))
                .flatten();
            let doubt = unknown.or_else(|| self.unused(sides, place));
            if let Some(reason) = doubt {
                finding.verdict = Verdict::Undecided;
                finding.reason = Some(reason);
                (finding.witness, finding.suggestion) = (None, None);
                finding.evidence.clear();
            }
        }
    }

    /// What the page says of what a relation speaks of, and what is not used.
    pub(in crate::judge) fn unused(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        self.open_law(sides, place)
            .or_else(|| self.form_of_a_part(sides, place))
            .or_else(|| self.changed_data(sides, place))
            .or_else(|| self.given_as_a_list(sides, place))
            .or_else(|| self.listed_beside(sides, place))
    }

    /// f(t, …, t) = s(t), where f is "the polar form of the polynomial that agrees with s there": what f has to do with s is said
    /// in words.
    fn form_of_a_part(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let names: BTreeSet<String> = sides.into_iter().flat_map(bases).collect();
        names.iter().find_map(|form| {
            let told = self.context.object_called(form, place)?;
            let of_any = match &told.object.of {
                Some(Expr { kind: Kind::Name(of), .. }) => of.starts_with(UNNAMED),
                of => of.is_none(),
            };
            if told.object.sort != Sort::PolarForm || !of_any {
                return None;
            }
            let beside = self.context.heard.iter().filter(|(other, _)| other.group == told.place.group);
            let mut named =
                beside.filter_map(|(_, expr)| Head::of(expr)).filter(|own| own.arguments.is_none());
            let has_formula = |name: &str| {
                let mut known = self.context.visible(name, place);
                known.any(|(_, own, _)| own.head.lower.is_empty() && own.head.arguments.is_some())
            };
            let other = named.find(|own| {
                own.base != *form
                    && own.lower.is_empty()
                    && names.contains(&own.base)
                    && has_formula(&own.base)
            })?;
            Some(format!("what {form} has to do with {} is not understood", other.base))
        })
    }

    /// "With the weights (1, 1, 2) we find W(t) = …", where nothing else says what the w_i are.
    fn listed_beside(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let told: Vec<&Expr> = self
            .context
            .heard
            .iter()
            .filter(|(other, _)| place.spare > 0 && other.formula == place.spare)
            .map(|(_, expr)| &**expr)
            .collect();
        if told.len() < 2 && !told.iter().any(|list| list.items().is_some_and(|items| items.len() > 1)) {
            return None;
        }
        let reached = self.context.reached(&sides, place);
        let family = |name: &&String| {
            let valued = |own: &Definition| match &own.body {
                Body::Formula(body) => bases(body).is_empty(),
                Body::Value(value) => compare::symbols(value).is_empty(),
            };
            self.context.letters.has_members(name)
                && !self.context.letters.is_function(name)
                && !is_variable(name)
                && !is_index_letter(name)
                && !self.context.visible(name, place).any(|(_, own, _)| valued(own))
        };
        let name = reached.iter().find(family)?;
        Some(format!("the numbers beside it may say what the {name} with indices are"))
    }

    /// A letter that a relation rests on, for which words put something else: "replacing b_1 by 4 we get". What holds with
    /// the data from before is no proof.
    fn replaced_data(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        if place.replaced.is_empty() {
            return None;
        }
        let mut reached = self.context.reached(&sides, place);
        let points = |told: &&Declared| place.knows(&told.place, false) && !told.object.points.is_empty();
        for told in self.context.objects.iter().filter(points) {
            let own = told.object.names.iter().filter_map(Head::of);
            if own.into_iter().any(|head| reached.contains(&head.base)) {
                reached.extend(told.object.points.iter().flat_map(bases));
            }
        }
        // The points of b(t) are the b_i, if nothing else is said.
        let own = self.context.definitions.iter().filter(|own| {
            let base = &own.head.base;
            reached.contains(base) && place.knows(&own.place, false) && place.is_replaced(base, &own.place)
        });
        let own = own.map(|own| (own.head.base.clone(), own.line)).next();
        own.map(|(name, line)| format!("{name} may have been changed since line {line}"))
    }

    /// Numbers that a relation rests on, or another formula for what it says, since which words may have changed them.
    fn changed_data(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let earlier = |other: &Place| place.knows(other, false) && place.may_change(other);
        let mut reached = self.context.reached(&sides, place);
        // The control points of c, which words may tell of without an equation
        let base = |expr: &Expr| Head::of(expr).map(|head| head.base);
        let untold = |name: &String| {
            let told = self.context.object_called(name, place);
            told.is_some_and(|told| told.object.is_function() && told.object.points.is_empty())
        };
        if reached.iter().any(untold) {
            let members = self.context.definitions.iter().filter(|own| own.head.lower.len() == 1);
            reached
                .extend(members.map(|own| own.head.base.clone()).filter(|letter| is_control_point(letter)));
        }
        // n γ_i = i δ_{i-1} + (n - i) δ_i: what is said of the γ_i bears on the δ_i.
        let related = self
            .context
            .conditions
            .iter()
            .filter(|condition| place.knows(&condition.place, condition.assumed));
        for condition in related {
            let own = bases(&condition.expr);
            if own.iter().any(|name| reached.contains(name) && !is_variable(name) && !is_index_letter(name)) {
                reached.extend(own);
            }
        }
        for told in &self.context.objects {
            if told.object.of.as_ref().and_then(base).is_some_and(|of| reached.contains(&of)) {
                reached.extend(told.object.names.iter().filter_map(base));
            }
        }
        let again = |own: &Definition| {
            let same = |head: &Head| head.base == own.head.base && head.lower.len() == own.head.lower.len();
            Head::of(sides[0]).is_some_and(|head| {
                same(&head)
                    && head.lower.iter().zip(&own.head.lower).all(|(a, b)| a.same_as(b))
                    && !head.lower.iter().all(|index| matches!(index.kind, Kind::Name(_)))
            })
        };
        let data = |definition: &Definition| match &definition.body {
            Body::Formula(_) => definition.is_datum(),
            Body::Value(value) => compare::symbols(value).is_empty(),
        };
        // What is said of all i rests on no numbers.
        let general = sides.iter().any(|side| !integer_names(side).is_empty());
        let definitions = self.context.definitions.iter().filter(|own| {
            let base = &own.head.base;
            // T_2(x) is that of another function; N_{i,0}(x) is one for all i.
            let one = own.head.arguments.is_some()
                && !own.head.lower.is_empty()
                && own.head.lower.iter().all(|index| index.as_int().is_some());
            let given_anew = || {
                let mut known = self.context.visible(base, place);
                known
                    .any(|(_, other, near)| near && !earlier(&other.place) && is_same(&other.head, &own.head))
            };
            reached.contains(base)
                && ((!general || one) && data(own) || again(own))
                && earlier(&own.place)
                && !given_anew()
        });
        let definitions = definitions.map(|own| (own.head.base.clone(), own.line));
        let number = |expr: &Expr| bases(expr).is_empty();
        let objects = self.context.objects.iter().filter(|told| {
            let Object { names, points, knots, values, data, .. } = &*told.object;
            let given = points.iter().chain(knots).chain(values).any(number) || !data.is_empty();
            let spoken = names.iter().chain(points).filter_map(Head::of);
            given
                && !general
                && earlier(&told.place)
                && spoken.map(|head| head.base).any(|base| reached.contains(&base))
        });
        let objects = objects.map(|told| ("what it rests on".to_owned(), told.line));
        let conditions = self.context.conditions.iter().filter(|condition| {
            let Kind::Chain(left, links) = &condition.expr.kind else { return false };
            let value = links.iter().any(|link| link.rel == Rel::Eq && number(&link.expr)) || number(left);
            value && !general && earlier(&condition.place) && bases(&condition.expr).is_subset(&reached)
        });
        let conditions = conditions.map(|condition| ("what it rests on".to_owned(), condition.line));
        let (name, line) = definitions.chain(objects).chain(conditions).next()?;
        Some(format!("{name} may have been changed since line {line}"))
    }

    /// b = (0, 6, 3, 3), which may say what the b_i are that a relation rests on.
    fn given_as_a_list(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let reached = self.context.reached(&sides, place);
        let member = |base: &String| {
            let own =
                |part: &Expr| Head::of(part).is_some_and(|head| head.base == *base && !head.lower.is_empty());
            let formulas = reached.iter().flat_map(|name| self.context.visible(name, place));
            let bodies = formulas.filter_map(|(_, definition, _)| match &definition.body {
                Body::Formula(body) => Some(body),
                Body::Value(_) => None,
            });
            sides.into_iter().chain(bodies).any(|side| side.has(&own))
        };
        let mut lists = self.context.definitions.iter().filter(|own| {
            let Body::Formula(body) = &own.body else { return false };
            let whole =
                own.head.lower.is_empty() && own.head.upper.is_empty() && own.head.arguments.is_none();
            let numbers = body.items().is_some_and(|items| items.len() > 2) && bases(body).is_empty();
            whole && numbers && reached.contains(&own.head.base) && place.knows(&own.place, false)
        });
        // Its items are known as members already.
        let read = |list: &Definition| {
            let mut items =
                self.context.definitions.iter().filter(|own| own.place.formula == list.place.formula);
            items.any(|own| own.head.base == list.head.base && !own.head.lower.is_empty())
        };
        let list = lists.find(|own| member(&own.head.base) && !read(own))?;
        Some(format!("line {} may say what the {} with indices are", list.line, list.head.base))
    }

    /// A law of a function in a relation that stayed open, with its line.
    fn open_law(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let own: BTreeSet<String> = sides.into_iter().flat_map(bases).collect();
        let mut laws =
            self.laws.iter().filter(|(name, other, _)| own.contains(name) && place.knows(other, false));
        laws.next().map(|(name, _, line)| format!("what line {line} says of {name} is not used"))
    }

    /// Remembers a law that stayed open: f(t) = f(1 - t).
    pub(in crate::judge) fn remember_law(&mut self, chain: &Chain, place: &Place, findings: &[Finding]) {
        let open = findings.iter().all(|finding| finding.verdict == Verdict::Undecided);
        if !open || !equates_values(chain) {
            return;
        }
        let called = |expr: &Expr| match &expr.kind {
            Kind::Apply(callee, groups) => {
                let varies = |argument: &Expr| bases(argument).iter().any(|name| is_variable(name));
                Head::of(callee).filter(|_| groups.iter().flatten().any(varies))
            }
            _ => None,
        };
        let (Some(one), Some(other)) = (called(&chain.sides[0].expr), called(&chain.sides[1].expr)) else {
            return;
        };
        if one.base == other.base {
            let line = self.line(chain.sides[0].expr.span);
            self.laws.push((one.base, place.clone(), line));
        }
    }
}
