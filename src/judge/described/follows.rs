//! What follows from other equations of the page: c_1, where C^1 was written out with numbers for all but c_1.
//!
//! **Rule.** The equations that a page gives, or that hold on it, are taken as they stand, without a meaning for their names.
//! One with an index or an argument that may be any is put for each term of that shape; values of a polar form that differ
//! in one argument only lie on a line. What is a combination of them holds. A formula is wrong if they say of its left side
//! what it is, in the same terms, and it says something else.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::budget;
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term};
use crate::judge::known::checker::Checker;
use crate::judge::known::found::Equation;
use crate::judge::page::context::Mark;
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::refute::MEANINGLESS;
use crate::judge::values::consequences::{Consequence, Sides, consequence, plain, terms};
use crate::judge::values::evaluator::number;
use crate::judge::written::names::{Head, bases, is_index_letter, walk};
use crate::language::lexicon::roles::is_variable;
use crate::language::write;
use crate::math::number::Rational;

/// So many of the equations before a formula are looked at.
const MOST: usize = 60;

/// So many instances are made of those with free indices.
const INSTANCES: usize = 40;

/// An equation that may be used.
struct Used<'a> {
    sides: Sides,
    /// Where it comes from; nothing for what is known of polar forms.
    from: Option<&'a Equation>,
    /// Whether it stands so on the page.
    written: bool,
}

impl Checker {
    /// Keeps the equations of a chain that are given or hold.
    pub(in crate::judge) fn keep_equations(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &[Finding],
    ) {
        let said = match statement.role {
            None | Some(Role::Claimed | Role::Always | Role::Introduced | Role::Assumed | Role::All) => true,
            Some(_) => false,
        };
        let sound = said && !chain.blocked && !chain.partial;
        for (at, finding) in findings.iter().enumerate() {
            let meant = match finding.verdict {
                Verdict::Proved | Verdict::Sampled => true,
                _ if statement.denied => false,
                Verdict::Definition => true,
                // Points whose names have no meaning cannot be added.
                Verdict::Undecided => finding
                    .reason
                    .as_deref()
                    .is_some_and(|reason| reason == MEANINGLESS || reason.ends_with("cannot be added")),
                _ => false,
            };
            if matches!(chain.relations[at].0, Rel::Eq | Rel::Define) {
                let line = self.line(finding.span);
                let pairs = members(&plain(&chain.sides[at].expr), &plain(&chain.sides[at + 1].expr));
                let new = pairs.into_iter().map(|sides| {
                    let letters = [&sides.0, &sides.1].into_iter().flat_map(telling).collect();
                    let own: BTreeSet<String> = [&sides.0, &sides.1].into_iter().flat_map(bases).collect();
                    let about = |range: &&Expr| !bases(range).is_disjoint(&own);
                    Rc::new(Equation {
                        sides,
                        ranges: chain.conditions.iter().filter(about).cloned().collect(),
                        letters,
                        place: statement.place.clone(),
                        line,
                        assumed: statement.role == Some(Role::Assumed),
                        sure: sound && meant && finding.warning.is_none(),
                    })
                });
                self.equations.extend(new);
            }
        }
    }

    /// Judges what looks like a definition, or stayed open, by the other equations of the page.
    ///
    /// Cost: one elimination with at most [`MOST`] equations, and one for each of them if it decides.
    pub(in crate::judge) fn by_equations(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let claimed = matches!(statement.role, None | Some(Role::Claimed | Role::Always));
        // Said of any, it rests on no data.
        let general = !statement.released.is_empty() || chain.universal;
        if !claimed
            || general
            || chain.blocked
            || chain.partial
            || chain.given
            || !chain.conditions.is_empty()
        {
            return;
        }
        for (at, finding) in findings.iter_mut().enumerate() {
            let open = matches!(finding.verdict, Verdict::Definition | Verdict::Undecided);
            if !open || !matches!(chain.relations[at].0, Rel::Eq) {
                continue;
            }
            let claim = (plain(&chain.sides[at].expr), plain(&chain.sides[at + 1].expr));
            // F(t) = … is a formula, no value.
            let formula = |head: &Head| head.flat().iter().any(|own| matches!(own.kind, Kind::Name(_)));
            if Head::of(&claim.0).is_some_and(|head| formula(&head)) {
                continue;
            }
            let limits = self.limits.clone();
            let found = budget::run(&limits, || self.decided_by_members(&claim, statement));
            let Ok(Some((consequence, lines))) = found else { continue };
            let from = listed(&lines);
            match consequence {
                Consequence::Follows => {
                    finding.verdict = Verdict::Proved;
                    finding.reason = Some(match lines.len() {
                        1 => format!("it follows from line {from}"),
                        _ => format!("it follows from lines {from}"),
                    });
                }
                Consequence::Differs(value) => {
                    let value = write::text(&value);
                    let left = &chain.sides[at].latex;
                    finding.verdict = Verdict::Refuted;
                    finding.evidence = vec![Evidence::Field];
                    finding.reason = Some(match lines.len() {
                        1 => format!("by line {from}, {left} is {value}"),
                        _ => format!("by lines {from}, {left} is {value}"),
                    });
                    Rc::make_mut(&mut self.context).forget(before);
                }
            }
        }
    }

    /// The same of a list of names, (c_0, c_1) = (2, 3): all have to follow, and one that differs is enough.
    fn decided_by_members(
        &self,
        claim: &Sides,
        statement: &Statement,
    ) -> Option<(Consequence, BTreeSet<usize>)> {
        let claims = members(&claim.0, &claim.1);
        if claims.len() == 1 {
            return self.decided(claim, statement);
        }
        let mut lines = BTreeSet::new();
        let mut values = Vec::new();
        let mut differs = false;
        for one in &claims {
            let (found, from) = self.decided(one, statement)?;
            lines.extend(from);
            values.push(match found {
                Consequence::Follows => one.1.clone(),
                Consequence::Differs(value) => {
                    differs = true;
                    value
                }
            });
        }
        let found =
            if differs { Consequence::Differs(Kind::Tuple(values).into()) } else { Consequence::Follows };
        Some((found, lines))
    }

    /// What other equations say of a claim, and the lines of those that are needed.
    fn decided(&self, claim: &Sides, statement: &Statement) -> Option<(Consequence, BTreeSet<usize>)> {
        let place = &statement.place;
        let mut known: BTreeSet<String> = [&claim.0, &claim.1].into_iter().flat_map(telling).collect();
        if known.is_empty() {
            return None;
        }
        let alive: Vec<&Rc<Equation>> =
            self.equations.iter().rev().filter(|own| own.sure && is_alive(own, place)).take(MOST).collect();
        let mut taken = vec![false; alive.len()];
        while let Some(at) = (0..alive.len()).find(|&at| !taken[at] && !alive[at].letters.is_disjoint(&known))
        {
            taken[at] = true;
            known.extend(alive[at].letters.iter().cloned());
        }
        let related = || alive.iter().zip(&taken).filter(|(_, taken)| **taken).map(|(own, _)| own);
        let numbers: Vec<(String, Expr)> = related()
            .filter_map(|own| match &own.sides.0.kind {
                Kind::Name(name) if !is_variable(name) => {
                    Some((name.clone(), Expr::number(&number(&own.sides.1)?)))
                }
                _ => None,
            })
            .collect();
        let with_numbers = |(left, right): &Sides| {
            let put = |side: &Expr| {
                plain(&numbers.iter().fold(side.clone(), |side, (name, value)| side.with_name(name, value)))
            };
            (put(left), put(right))
        };
        // n = 3 itself says nothing more.
        let claim = &with_numbers(claim);
        let mut rules: Vec<(&Equation, Sides)> = Vec::new();
        let mut used: Vec<Used> = Vec::new();
        for own in related() {
            let sides = with_numbers(&own.sides);
            if free(&sides.0).is_empty() {
                if !own.ranges.is_empty() || number(&sides.0).is_some() {
                    continue;
                }
                used.push(Used { sides, from: Some(own.as_ref()), written: true });
            } else if !hides_arguments(&sides) {
                rules.push((own.as_ref(), sides));
            }
        }
        let mut all = terms_of(claim, &used);
        let mut at = 0;
        while at < all.len() && used.len() < MOST + INSTANCES {
            for (rule, sides) in &rules {
                let Some(sides) = instance(sides, &rule.ranges, &all[at]) else { continue };
                let new = terms([&sides.0, &sides.1].into_iter());
                let new: Vec<Expr> = new.into_iter().filter(|term| !all.contains(term)).collect();
                all.extend(new);
                if !used.iter().any(|own| own.sides == sides) {
                    used.push(Used { sides, from: Some(*rule), written: false });
                }
            }
            at += 1;
        }
        let polar = self.polar_names(&all, &rules, statement);
        for own in &mut used {
            own.sides = (sorted(&own.sides.0, &polar), sorted(&own.sides.1, &polar));
        }
        let claim = &(sorted(&claim.0, &polar), sorted(&claim.1, &polar));
        // The pieces of a spline have polar forms of their own.
        if !statement.topics.has(Topic::Spline) {
            used.extend(on_lines(&terms_of(claim, &used), &polar));
        }
        let of = |used: &[&Used]| {
            let sides: Vec<Sides> = used.iter().map(|own| own.sides.clone()).collect();
            consequence(&sides, claim)
        };
        let mut needed: Vec<&Used> = used.iter().collect();
        let found = of(&needed)?;
        let mut at = 0;
        while at < needed.len() {
            let mut fewer = needed.clone();
            fewer.remove(at);
            match of(&fewer).as_ref() == Some(&found) {
                true => needed = fewer,
                false => at += 1,
            }
        }
        let again = |own: &&Used| {
            own.written && (own.sides == *claim || own.sides.0 == claim.1 && own.sides.1 == claim.0)
        };
        let lines: BTreeSet<usize> = needed.iter().filter_map(|own| own.from).map(|from| from.line).collect();
        let said_before =
            needed.iter().any(|own| again(own) || own.written && own.sides.0 == claim.0 && needed.len() == 1);
        // Another equation for it, of which nothing is known, may be what it comes from.
        let last = needed.iter().filter_map(|own| own.from).map(|from| from.place.formula).max()?;
        let own = telling(&claim.0);
        let unsure =
            self.equations.iter().rev().take_while(|other| other.place.formula >= last).any(|other| {
                !other.sure && !other.letters.is_disjoint(&own) && place.knows(&other.place, other.assumed)
            });
        let differs = matches!(found, Consequence::Differs(_));
        // "Over [-1, 1] they are b_0 = 2, …": those of another interval than before; polar values hold everywhere.
        let elsewhere = self
            .context
            .intervals_beside(place)
            .any(|(formula, ..)| formula > last && formula <= place.formula);
        if differs && elsewhere && !matches!(claim.0.kind, Kind::Apply(..)) {
            return None;
        }
        // b_1 = b_2 may be what is asked of them.
        if differs && (number(&claim.1).is_none() && is_one(&claim.1) || !is_one(&claim.0)) {
            return None;
        }
        (!(said_before || unsure && differs)).then_some((found, lines))
    }

    /// The letters of polar forms among the functions with several arguments.
    fn polar_names(
        &self,
        all: &[Expr],
        rules: &[(&Equation, Sides)],
        statement: &Statement,
    ) -> BTreeSet<String> {
        let called: BTreeSet<String> = all.iter().filter_map(polar_call).map(|(name, _)| name).collect();
        let is_form = |name: &String| {
            let told = self.context.object_called(name, &statement.place);
            let spoken = told.as_ref().is_some_and(|told| told.object.sort == Sort::PolarForm);
            let other = told.is_some_and(|told| !told.object.is_function());
            let defined = rules.iter().any(|(_, sides)| {
                Head::of(&sides.0).is_some_and(|head| head.base == *name && head.arguments.is_some())
            });
            let counts: BTreeSet<usize> = all
                .iter()
                .filter_map(polar_call)
                .filter(|(own, _)| own == name)
                .map(|(_, arguments)| arguments.len())
                .collect();
            counts.len() == 1 && (spoken || statement.topics.has(Topic::PolarForm) && !defined && !other)
        };
        called.into_iter().filter(is_form).collect()
    }
}

/// Whether the names of a formula for a function stand for its arguments, too: f(t_1, t_2) = e_2 + 2e_1.
fn hides_arguments((left, right): &Sides) -> bool {
    let own = bases(right);
    let shown = |argument: &Expr| bases(argument).is_subset(&own);
    Head::of(left).is_some_and(|head| !own.is_empty() && !head.flat().into_iter().all(shown))
}

/// The terms of a claim and of equations.
fn terms_of(claim: &Sides, used: &[Used]) -> Vec<Expr> {
    let sides = std::iter::once(claim).chain(used.iter().map(|own| &own.sides));
    terms(sides.flat_map(|(left, right)| [left, right]))
}

/// "1, 3 and 4"
fn listed(lines: &BTreeSet<usize>) -> String {
    let lines: Vec<String> = lines.iter().map(usize::to_string).collect();
    match lines.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => lines.concat(),
    }
}

/// Whether an equation from there may be used here.
fn is_alive(equation: &Equation, place: &Place) -> bool {
    place.knows(&equation.place, equation.assumed)
        && !place.is_apart(&equation.place)
        && !equation.letters.iter().any(|letter| place.is_replaced(letter, &equation.place))
}

/// The letters of a formula that say which equations belong to it: t_1 is no variable.
fn telling(expr: &Expr) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    walk(expr, &mut |part| match &part.kind {
        Kind::Name(name) if !is_variable(name) && !is_index_letter(name) => {
            found.insert(name.clone());
        }
        Kind::Subscript(..) | Kind::Apply(..) => found.extend(Head::of(part).map(|head| head.base)),
        _ => {}
    });
    found
}

/// Whether nothing is calculated.
fn is_one(expr: &Expr) -> bool {
    Head::of(expr).is_some()
}

/// (a, b) = (1, 2) as a = 1 and b = 2, anything else as it is.
fn members(left: &Expr, right: &Expr) -> Vec<Sides> {
    match (left.items(), right.items()) {
        (Some(names), Some(values)) if names.len() == values.len() => {
            names.iter().cloned().zip(values.iter().cloned()).collect()
        }
        _ => vec![(left.clone(), right.clone())],
    }
}

/// The indices and arguments of a head that may be any.
fn free(left: &Expr) -> Vec<Expr> {
    let Some(head) = Head::of(left) else { return Vec::new() };
    let mut found: Vec<Expr> = Vec::new();
    for index in head.lower.iter().chain(&head.upper) {
        let letters = bases(index).into_iter().filter(|name| is_index_letter(name));
        found.extend(letters.map(Expr::name));
    }
    let variable = |argument: &&&Expr| match &argument.kind {
        Kind::Name(_) => true,
        Kind::Subscript(base, _) => matches!(&base.kind, Kind::Name(name) if is_variable(name)),
        _ => false,
    };
    // Of a function of one variable the formula may hold for a part only.
    let arguments = head.flat();
    if arguments.len() > 1 && arguments.iter().all(|argument| variable(&argument)) {
        found.extend(arguments.into_iter().cloned());
    }
    found
}

/// An equation with a free index or argument, for the term that stands on its left side then.
fn instance((left, right): &Sides, ranges: &[Expr], term: &Expr) -> Option<Sides> {
    let (pattern, own) = (Head::of(left)?, Head::of(term)?);
    let alike = pattern.base == own.base
        && pattern.lower.len() == own.lower.len()
        && pattern.upper.len() == own.upper.len()
        && pattern.parenthesized == own.parenthesized
        && pattern.flat().len() == own.flat().len();
    if !alike {
        return None;
    }
    let mut by: Vec<(Expr, Expr)> = Vec::new();
    let mut put = |name: Expr, value: Expr| match by.iter().find(|(known, _)| *known == name) {
        Some((_, other)) => *other == value,
        None => {
            by.push((name, value));
            true
        }
    };
    let indices = pattern.lower.iter().chain(&pattern.upper).zip(own.lower.iter().chain(&own.upper));
    for (wanted, given) in indices {
        let letters: Vec<String> = bases(wanted).into_iter().collect();
        let fits = match letters.as_slice() {
            [] => wanted == given,
            [letter] if is_index_letter(letter) => {
                let value = Expr::number(&solved(wanted, letter, &number(given)?)?);
                put(Expr::name(letter.clone()), value)
            }
            _ => false,
        };
        if !fits {
            return None;
        }
    }
    for (wanted, given) in pattern.flat().into_iter().zip(own.flat()) {
        let fits = wanted == given || put(wanted.clone(), given.clone());
        if !fits {
            return None;
        }
    }
    let by: Vec<(Expr, Expr)> = by
        .into_iter()
        .map(|(name, value)| match value.kind {
            Kind::Number(_) => (name, value.grouped()),
            _ => (name, value),
        })
        .collect();
    let instance = |expr: &Expr| plain(&expr.with_parts(&by));
    let sides = (instance(left), instance(right));
    let holds = ranges.iter().all(|range| holds(&instance(range)) == Some(true));
    (holds && !by.is_empty() && sides.0 == *term && !sides.1.has(&|part| part.kind == Kind::Ellipsis))
        .then_some(sides)
}

/// The integer for which a linear index has a value.
fn solved(index: &Expr, letter: &str, value: &Rational) -> Option<Rational> {
    let at = |x: i64| number(&index.with_name(letter, &Expr::int(x)));
    let (zero, one, two) = (at(0)?, at(1)?, at(2)?);
    let slope = &one - &zero;
    if slope == Rational::from_integer(0.into()) || &two - &one != slope {
        return None;
    }
    Some((value - zero) / slope).filter(Rational::is_integer)
}

/// Whether a range without names holds; nothing if it cannot be told.
fn holds(range: &Expr) -> Option<bool> {
    let Kind::Chain(left, links) = &range.kind else { return None };
    let mut before = left.as_ref();
    for Link { rel, expr, .. } in links {
        let sound = match (expr.items(), rel) {
            (Some(items), Rel::Eq | Rel::In) => {
                let value = number(before)?;
                let numbers: Vec<Rational> = items.iter().filter_map(number).collect();
                let dotted = items.iter().any(|item| item.kind == Kind::Ellipsis);
                match dotted {
                    true => *numbers.first()? <= value && value <= *numbers.last()?,
                    false => numbers.contains(&value),
                }
            }
            _ => {
                let (a, b) = (number(before)?, number(expr)?);
                match rel {
                    Rel::Eq => a == b,
                    Rel::Ne => a != b,
                    Rel::Lt => a < b,
                    Rel::Le => a <= b,
                    Rel::Gt => a > b,
                    Rel::Ge => a >= b,
                    _ => return None,
                }
            }
        };
        if !sound {
            return Some(false);
        }
        before = expr;
    }
    Some(true)
}

/// A call with at least two arguments, all of them numbers.
fn polar_call(term: &Expr) -> Option<(String, Vec<Rational>)> {
    let head = Head::of(term).filter(|head| head.lower.is_empty() && head.upper.is_empty())?;
    let arguments: Vec<Rational> = head.flat().into_iter().map(number).collect::<Option<_>>()?;
    (arguments.len() > 1).then_some((head.base, arguments))
}

/// A formula with the arguments of polar forms in ascending order.
fn sorted(expr: &Expr, polar: &BTreeSet<String>) -> Expr {
    let mut found = expr.clone();
    if let Some((name, mut arguments)) = polar_call(expr)
        && polar.contains(&name)
    {
        arguments.sort();
        if let Kind::Apply(_, groups) = &mut found.kind {
            *groups = vec![arguments.iter().map(Expr::number).collect()];
        }
        return found;
    }
    found.for_each_child_mut(&mut |child| *child = sorted(child, polar));
    found
}

/// That values of polar forms on one line, f(a, x), f(a, y), f(a, z), are there like x, y, z.
fn on_lines(all: &[Expr], polar: &BTreeSet<String>) -> Vec<Used<'static>> {
    let calls: Vec<(&Expr, String, Vec<Rational>)> = all
        .iter()
        .filter_map(|term| polar_call(term).map(|(name, arguments)| (term, name, arguments)))
        .filter(|(_, name, _)| polar.contains(name))
        .collect();
    let mut found = Vec::new();
    let mut lines: BTreeSet<(String, Vec<Rational>)> = BTreeSet::new();
    for (_, name, arguments) in &calls {
        for at in 0..arguments.len() {
            let mut common = arguments.clone();
            common.remove(at);
            lines.insert((name.clone(), common));
        }
    }
    for (name, common) in lines {
        let on: Vec<(&Expr, Rational)> = calls
            .iter()
            .filter(|(_, own, arguments)| *own == name && arguments.len() == common.len() + 1)
            .filter_map(|(term, _, arguments)| Some((*term, other(arguments, &common)?)))
            .collect();
        let [(f, x), (g, y), rest @ ..] = on.as_slice() else { continue };
        for (h, z) in rest {
            let term = |factor: Rational, value: &Expr| {
                let expr = Expr::product(vec![Expr::number(&factor).grouped(), value.clone()]);
                Term { sign: Sign::Plus, expr }
            };
            let sum = Expr::sum(vec![term(z - y, f), term(x - z, g), term(y - x, h)]);
            found.push(Used { sides: (sum, Expr::int(0)), from: None, written: false });
        }
    }
    found.truncate(MOST);
    found
}

/// The argument beside some others.
fn other(arguments: &[Rational], common: &[Rational]) -> Option<Rational> {
    let mut rest = arguments.to_vec();
    for value in common {
        let at = rest.iter().position(|own| own == value)?;
        rest.remove(at);
    }
    rest.pop()
}
