//! What the words, lists and intervals of a paragraph are together.

use std::collections::BTreeMap;

use super::lists::{self, List, Role, lists};
use super::signs::{Sign, sentence_end, sentence_start};
use super::{Account, Page, Points, formulas};
use crate::formula::{Accent, Expr, Kind, Rel, Sign as Plus, Term, interval};
use crate::judge::page::object::{Sort, UNNAMED};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::written::names::{Head, bases, is_index_letter, walk};
use crate::language::lexicon::roles::{is_control_point, is_variable};
use crate::notes::speech::Hint;

/// A paragraph that is read.
pub(super) struct Told<'a> {
    pub all: &'a [Sign],
    pub page: &'a Page<'a>,
    pub topics: Topics,
    /// Polar forms that were told before, and of what.
    pub forms: &'a [(String, String)],
}

impl Told<'_> {
    pub fn account(&self, numbers: Vec<usize>) -> Option<Account> {
        let spline = self.one_curve()?;
        let all = lists(self.all, self.page);
        let degrees: Vec<i64> = self.degrees();
        let mut families: Vec<List> = Vec::new();
        let mut knots = Vec::new();
        let mut data = None;
        for list in all {
            match list.role {
                Role::Points => families.push(list),
                Role::Knots if knots.is_empty() && spline => knots = list.items,
                Role::Values(ref nodes) if data.is_none() => data = Some((list.items.clone(), nodes.clone())),
                Role::Index => {}
                _ => return None,
            }
        }
        // "The h with h(0) = 1, h'(0) = 2. The points are 0, 0, 1": no control points.
        if families.iter().any(|list| list.letter.is_none() && self.has_values_before(list.at)) {
            return None;
        }
        let mut letters = Vec::new();
        let mut calls = Vec::new();
        let mut names: BTreeMap<String, i64> = BTreeMap::new();
        for expr in numbers.iter().flat_map(|number| self.page.said(*number)) {
            if let Kind::Name(name) = &without_bold(expr).kind {
                *names.entry(name.clone()).or_default() -= 1;
            }
            if matches!(expr.kind, Kind::Chain(..)) {
                letters.extend(bases(expr));
            }
            walk(expr, &mut |part| {
                if let Kind::Name(name) = &part.kind {
                    *names.entry(name.clone()).or_default() += 1;
                }
                if let Kind::Apply(inner, _) | Kind::Subscript(inner, _) = &part.kind
                    && let Kind::Name(name) = &without_bold(inner).kind
                {
                    *names.entry(name.clone()).or_default() -= 1;
                }
                calls.extend(call(part));
            });
        }
        // c (1 - d) + d (1 - c) is no value of c.
        calls.retain(|call: &Call| {
            call.derived
                || !matches!(&without_bold(&call.name).kind, Kind::Name(name) if names.get(name).is_some_and(|count| *count > 0))
        });
        if families.is_empty() && !spline {
            families.extend(self.unlisted(&numbers, data.as_ref().map(|(values, _)| values.as_slice())));
        }
        let formula = match (families.is_empty(), &data, spline) {
            (false, None, false) => self.formula(&numbers)?,
            _ => None,
        };
        let (formula, coefficients) = match formula.as_ref().and_then(|(_, sum)| coefficients(sum)) {
            Some(coefficients) => (None, coefficients),
            None => (formula.map(|(of, _)| of), Vec::new()),
        };
        let polar = self.polar_form(&calls)?;
        let name = self.name(&calls, polar.as_ref(), formula.as_ref())?;
        let degree = degrees.first().copied();
        let mut account = Account {
            numbers,
            letters,
            name,
            degree,
            points: Vec::new(),
            data,
            formula,
            coefficients,
            knots,
            polar,
        };
        if spline {
            account.spline(families, self)?;
        } else {
            account.points = self.points(families, &account, &degrees)?;
            if account.points.is_empty() && account.data.is_none() {
                return None;
            }
        }
        Some(account)
    }

    /// Whether a formula before a sign gives a number as the value of a function.
    fn has_values_before(&self, at: usize) -> bool {
        let number = |expr: &Expr| bases(expr).is_empty();
        formulas(&self.all[..at]).flat_map(|formula| self.page.said(formula)).any(|said| match &said.kind {
            Kind::Chain(left, links) => {
                matches!(links.as_slice(), [link] if link.rel == Rel::Eq && number(&link.expr))
                    && matches!(&left.kind, Kind::Apply(_, groups) if groups.iter().flatten().all(number))
            }
            _ => false,
        })
    }

    /// Points that equations speak of and no list: "two control points coincide: b_1 = b_0".
    fn unlisted(&self, numbers: &[usize], values: Option<&[Expr]>) -> Option<List> {
        let noun = self.all.iter().rposition(|sign| *sign == Sign::Hint(Hint::Points))?;
        let after = formulas(&self.all[noun..]).next()?;
        let mut letters: Vec<String> = Vec::new();
        for said in
            numbers.iter().filter(|number| **number >= after).flat_map(|number| self.page.said(*number))
        {
            walk(said, &mut |part| {
                if let Some(head) =
                    Head::of(part).filter(|head| head.index().is_some() && head.arguments.is_none())
                    && head.upper.is_empty()
                    && is_control_point(&head.base)
                    && !letters.contains(&head.base)
                {
                    letters.push(head.base);
                }
            });
        }
        let data: Vec<String> =
            values.into_iter().flatten().filter_map(Head::of).map(|head| head.base).collect();
        letters.retain(|letter| !data.contains(letter));
        match letters.as_slice() {
            [one] => Some(List::unlisted(one)),
            _ => None,
        }
    }

    /// Whether one curve is spoken of, and whether it is a spline; nothing if there may be more than one.
    fn one_curve(&self) -> Option<bool> {
        let (mut spline, mut bezier, mut any) = (false, false, false);
        let mut new = 0;
        let mut again = false;
        for (at, sign) in self.all.iter().enumerate() {
            match sign {
                Sign::Hint(Hint::Again) => again = true,
                Sign::OfDegree(_) => any = true,
                Sign::Curve(sort) => {
                    any = true;
                    spline |= matches!(sort, Sort::SplineCurve | Sort::BSpline);
                    bezier |= *sort == Sort::BezierCurve;
                }
                _ => {}
            }
            if !matches!(sign, Sign::Curve(_) | Sign::OfDegree(_)) {
                continue;
            }
            let before = at.checked_sub(1).map(|before| &self.all[before]);
            match before {
                // Two cubics, but not "into two cubic pieces"
                Some(Sign::Number(count)) if *count > 1 && !self.is_part(at) => return None,
                // An adjective that is not known may change everything.
                Some(Sign::Unknown)
                    if matches!(at.checked_sub(2).map(|b| &self.all[b]), Some(Sign::Article)) =>
                {
                    return None;
                }
                Some(Sign::Article) if !again => new += 1,
                _ => {}
            }
        }
        (any && new < 2 && !(spline && bezier)).then_some(spline)
    }

    /// Whether words for a curve lead to "piece", "half".
    fn is_part(&self, at: usize) -> bool {
        let last = self.all[at..]
            .iter()
            .find(|sign| !matches!(sign, Sign::Curve(_) | Sign::OfDegree(_) | Sign::Filler));
        matches!(last, Some(Sign::Hint(Hint::Part | Hint::Half)))
    }

    /// The degrees that words say, in their order.
    fn degrees(&self) -> Vec<i64> {
        let mut found = Vec::new();
        for (at, sign) in self.all.iter().enumerate() {
            let degree = match sign {
                Sign::OfDegree(degree) => Some(*degree),
                Sign::Degree => self.all[at + 1..].iter().take(3).find_map(|next| match next {
                    Sign::Number(degree) => Some(*degree),
                    Sign::Formula(number) => self.page.said(*number).first().and_then(Expr::as_int),
                    _ => None,
                }),
                _ => None,
            };
            found.extend(degree.filter(|degree| !found.contains(degree)));
        }
        found
    }

    /// The name of the curve: the only function with values that is no polar form.
    fn name(&self, calls: &[Call], polar: Option<&Expr>, formula: Option<&Expr>) -> Option<Expr> {
        let mut found: Option<&Call> = None;
        for call in calls.iter().filter(|call| call.arguments < 2) {
            if polar.is_some_and(|polar| polar.same_as(&call.name)) {
                continue;
            }
            match found {
                Some(known) if !known.name.same_as(&call.name) => return None,
                Some(known) if known.derived || !call.derived => {}
                _ => found = Some(call),
            }
        }
        let unnamed = Expr::name(format!("{UNNAMED}{}", formulas(self.all).next().unwrap_or_default()));
        let Some(call) = found.filter(|_| formula.is_none()) else {
            return Some(polar.and_then(|polar| self.form_told_before(polar)).unwrap_or(unnamed));
        };
        // "Its derivative is y(t) = …": another function, unless the curve is called so.
        let other = [Topic::Derivative, Topic::PolarForm].into_iter().any(|topic| self.topics.has(topic));
        if other && !call.derived && !self.is_called(&call.name) {
            return None;
        }
        Some(call.name.clone())
    }

    /// Whether words call the curve by a name: the curve x, x a cubic.
    fn is_called(&self, name: &Expr) -> bool {
        let named = |sign: &Sign| match sign {
            Sign::Formula(number) => {
                let first = self.page.said(*number).first();
                first.is_some_and(|said| {
                    said.same_as(name) || matches!(&said.kind, Kind::Apply(own, _) if own.same_as(name))
                })
            }
            _ => false,
        };
        let curve = |sign: &Sign| matches!(sign, Sign::Curve(_) | Sign::OfDegree(_));
        let near = |at: usize| {
            let before = self.all[..at].iter().rev().find(|sign| **sign != Sign::Filler);
            let after = self.all[at + 1..]
                .iter()
                .find(|sign| !matches!(sign, Sign::Filler | Sign::Article | Sign::Join));
            before.is_some_and(curve) || after.is_some_and(curve)
        };
        (0..self.all.len()).any(|at| named(&self.all[at]) && near(at))
    }

    /// The polar form of the curve, if one is spoken of; nothing if that may be that of something else.
    fn polar_form(&self, calls: &[Call]) -> Option<Option<Expr>> {
        let count = self.all.iter().filter(|sign| **sign == Sign::PolarForm).count();
        let mut several = calls.iter().filter(|call| call.arguments > 1 && !call.derived);
        match (count, several.next()) {
            (0, None) => Some(None),
            (0, Some(first)) => self.form_told_before(&first.name).map(|_| Some(first.name.clone())),
            (_, None) => Some(None),
            (_, Some(first)) => {
                let one = several.all(|call| call.name.same_as(&first.name));
                let cut = self.topics.has(Topic::Derivative);
                (one && !cut).then(|| Some(first.name.clone()))
            }
        }
    }

    /// The function whose polar form a name was said to be before, if the curve is called so: "Let p be the cubic …".
    fn form_told_before(&self, name: &Expr) -> Option<Expr> {
        let own = Head::of(name)?.base;
        let (_, of) = self.forms.iter().find(|(form, _)| *form == own)?;
        Some(Expr::name(of)).filter(|of| self.is_called(of))
    }

    /// The formula of the curve: a sum in a variable, or what a function is defined as. Nothing if there are several.
    fn formula(&self, numbers: &[usize]) -> Option<Option<(Expr, Expr)>> {
        let mut found: Option<(Expr, Expr)> = None;
        let last = numbers.last();
        for number in numbers.iter().filter(|number| Some(*number) != last) {
            for said in self.page.said(*number) {
                let own = match &said.kind {
                    Kind::Add(_) => {
                        let variables = bases(said).into_iter().filter(|name| is_variable(name)).count();
                        (variables == 1).then_some((said, said))
                    }
                    Kind::Chain(left, links) => match (&left.kind, links.as_slice()) {
                        (Kind::Apply(function, arguments), [link])
                            if link.rel == Rel::Eq
                                && matches!(function.kind, Kind::Name(_))
                                && matches!(arguments.concat().as_slice(), [Expr { kind: Kind::Name(name), .. }] if is_variable(name)) =>
                        {
                            Some((function.as_ref(), &link.expr))
                        }
                        _ => None,
                    },
                    _ => None,
                };
                if let Some(own) = own {
                    if found.is_some() {
                        return None;
                    }
                    found = Some((own.0.clone(), own.1.clone()));
                }
            }
        }
        Some(found)
    }

    /// Between which knots the function lives that belongs to d_i, if the knots are the integers.
    pub fn support(&self, list: &List, degree: i64) -> Option<Vec<Expr>> {
        let [point] = list.items.as_slice() else { return None };
        let index = Head::of(point)?.index()?.clone();
        let own = |expr: &Expr| bases(expr).iter().all(|name| Expr::name(name).same_as(&index));
        // The difference of i + 1 and i
        let shift = |expr: &Expr| match &expr.kind {
            _ if expr.same_as(&index) => Some(0),
            Kind::Add(terms) => match terms.as_slice() {
                [a, b] if a.expr.same_as(&index) && a.sign == Plus::Plus => {
                    b.expr.as_int().map(|by| if b.sign == Plus::Plus { by } else { -by })
                }
                _ => None,
            },
            _ => None,
        };
        let from = |first: i64, last: i64| {
            vec![index.clone().plus(first), Kind::Ellipsis.into(), index.clone().plus(last)]
        };
        let mut found: Vec<Vec<Expr>> = Vec::new();
        let whole = self.all.contains(&Sign::Hint(Hint::Integers));
        for (at, sign) in self.all.iter().enumerate() {
            let rest = self.all[at..].iter().take_while(|sign| **sign != Sign::End);
            let before = self.all[..at].iter().rev().take_while(|sign| **sign != Sign::End);
            let centred = rest.chain(before).any(|sign| *sign == Sign::Hint(Hint::Centred));
            if let Sign::Formula(number) = sign {
                let said = self.page.said(*number);
                let items = match said {
                    [one] => one.items().unwrap_or(said),
                    _ => said,
                };
                if !items.iter().all(own) {
                    continue;
                }
                let shifts: Option<Vec<i64>> = items.iter().map(shift).collect();
                let Some(shifts) = shifts else { continue };
                let steps = shifts.windows(2).all(|pair| pair[1] == pair[0] + 1);
                if steps && shifts.len() as i64 == degree && degree > 1 {
                    found.push(from(shifts[0] - 1, shifts[0] + degree));
                } else if let (true, [middle], true) = (centred && whole, shifts.as_slice(), degree % 2 == 1)
                {
                    found.push(from(middle - (degree + 1) / 2, middle + (degree + 1) / 2));
                }
            }
        }
        match found.as_slice() {
            [one] => Some(one.clone()),
            _ => None,
        }
    }

    /// The intervals of the paragraph in their order, each once in a row.
    pub fn intervals(&self) -> Vec<(usize, (Expr, Expr))> {
        let mut found: Vec<(usize, (Expr, Expr))> = Vec::new();
        for (at, sign) in self.all.iter().enumerate() {
            let own = match sign {
                Sign::Formula(number) => match self.page.said(*number) {
                    [one] => closed(one),
                    _ => None,
                },
                Sign::Hint(Hint::Unit) => Some((Expr::int(0), Expr::int(1))),
                Sign::Hint(Hint::SameInterval) => found.last().map(|(_, last)| last.clone()),
                _ => None,
            };
            found.extend(own.map(|own| (at, own)));
        }
        found
    }

    /// The families with their intervals, that of the least degree first.
    fn points(&self, families: Vec<List>, account: &Account, degrees: &[i64]) -> Option<Vec<Points>> {
        let count = families.len();
        let given = account.data.is_some() || account.formula.is_some();
        let parts = self.parts();
        let intervals = self.intervals();
        let unit = (Expr::int(0), Expr::int(1));
        let again = |list: &List| {
            // Its sentence and the one before
            let from = sentence_start(self.all, sentence_start(self.all, list.at).saturating_sub(1));
            let to = sentence_end(self.all, list.at);
            self.all[from..to].iter().any(|sign| {
                matches!(
                    sign,
                    Sign::Its | Sign::Hint(Hint::Again | Hint::Powers | Hint::Split | Hint::Middle)
                )
            })
        };
        // More than one family: words have to say that they are of the same curve.
        if count > 1 && !families.iter().skip(1).all(again) {
            return None;
        }
        // "The control points of its derivative"
        let derived = self.topics.has(Topic::Derivative);
        if derived && (count > 1 || given) {
            return None;
        }
        let ends: Vec<(Expr, Expr)> = match parts.as_slice() {
            [] => match (intervals.as_slice(), count) {
                (_, 0) => intervals.first().map(|(_, own)| own.clone()).into_iter().collect(),
                ([], _) => vec![unit; count],
                ([(_, one)], 1) => vec![one.clone()],
                // Of other degrees over one interval
                ([(at, one)], _) => {
                    let numbers: Vec<Option<i64>> = families.iter().map(List::degree).collect();
                    let different = numbers
                        .windows(2)
                        .all(|pair| pair[0].is_some() && pair[1].is_some() && pair[0] != pair[1]);
                    let first = |list: &List| self.all[list.at..*at].contains(&Sign::End);
                    if different {
                        vec![one.clone(); count]
                    } else if count == 2 && families[0].at < *at && first(&families[0]) {
                        vec![unit, one.clone()]
                    } else {
                        return None;
                    }
                }
                (several, count) if several.len() == count => {
                    several.iter().map(|(_, own)| own.clone()).collect()
                }
                (several, _) => {
                    let (_, first) = &several[0];
                    let same =
                        several.iter().all(|(_, own)| own.0.same_as(&first.0) && own.1.same_as(&first.1));
                    let one =
                        count == 1 || families.windows(2).all(|pair| pair[0].degree() != pair[1].degree());
                    if !(same && one) {
                        return None;
                    }
                    vec![first.clone(); count]
                }
            },
            // "The curve with the control points …, split at t = 1/3. Its left part …"
            [(part, _), ..] if count == 1 && families[0].at < *part => {
                let [] = intervals.as_slice() else { return None };
                vec![unit]
            }
            parts if parts.len() == count || parts.len() + 1 == count => {
                let whole = match intervals.as_slice() {
                    [] => unit,
                    [(_, one)] => one.clone(),
                    _ => return None,
                };
                let middle = self.middle(&whole, account)?;
                let part = |second: &bool| match second {
                    false => (whole.0.clone(), middle.clone()),
                    true => (middle.clone(), whole.1.clone()),
                };
                let first = (parts.len() < count).then(|| whole.clone());
                first.into_iter().chain(parts.iter().map(|(_, second)| part(second))).collect()
            }
            _ => return None,
        };
        let mut found: Vec<Points> = families
            .into_iter()
            .zip(ends)
            .map(|(list, interval)| Points { degree: list.degree(), list, interval })
            .collect();
        // Its own degree is the least one, and words say it, if they say any.
        let least = found.iter().filter_map(|points| points.degree).min().or(account.degree);
        let raised = found.iter().any(|points| points.degree.is_some() && points.degree != least);
        let said =
            |degree: Option<i64>| degree.is_none_or(|degree| degrees.is_empty() || degrees.contains(&degree));
        let data = account.data.as_ref().map(|(values, _)| values.len() as i64 - 1);
        if !given && !said(least) || data.is_some_and(|own| account.degree.is_some_and(|said| said != own)) {
            return None;
        }
        if degrees.len() > 1 && !raised && !given {
            return None;
        }
        if parts.is_empty() {
            found.sort_by_key(|points| points.degree);
        }
        for points in &mut found {
            points.degree = points.degree.or(least).or(data);
            // b_i: one by one
            if let (Some(degree), Some(letter), [_]) =
                (points.degree, &points.list.letter, points.list.items.as_slice())
            {
                points.list.items = (0..=degree).map(|i| lists::member(letter, Expr::int(i))).collect();
            }
        }
        // Two families over one interval would be the same points.
        let twice = |(at, one): (usize, &Points)| {
            found[..at].iter().any(|other| {
                let same =
                    other.interval.0.same_as(&one.interval.0) && other.interval.1.same_as(&one.interval.1);
                same && other.degree == one.degree
            })
        };
        if found.iter().enumerate().any(twice) {
            return None;
        }
        found.iter().all(|points| points.degree.is_some()).then_some(found)
    }
}

/// The letters of a_0 + a_1 t + a_2 t^2, each before the power of its number.
fn coefficients(sum: &Expr) -> Option<Vec<Expr>> {
    let Kind::Add(terms) = &sum.kind else { return None };
    let letter = |expr: &Expr| {
        let head = Head::of(expr).filter(|head| head.arguments.is_none() && head.upper.is_empty());
        head.is_some_and(|head| !(is_variable(&head.base) && head.lower.is_empty()))
    };
    let power = |expr: &Expr| match &expr.kind {
        Kind::Name(name) if is_variable(name) => Some(1),
        Kind::Pow(base, exponent) if matches!(&base.kind, Kind::Name(name) if is_variable(name)) => {
            exponent.as_int()
        }
        _ => None,
    };
    let own = |term: &Term| match &term.expr.kind {
        Kind::Mul(factors) => match factors.as_slice() {
            [a, b] if letter(a) => Some((power(b)?, a.clone())),
            [b, a] if letter(a) => Some((power(b)?, a.clone())),
            _ => None,
        },
        _ => letter(&term.expr).then(|| (0, term.expr.clone())),
    };
    let plus = terms.iter().all(|term| term.sign == Plus::Plus);
    let mut found: Vec<(i64, Expr)> = terms.iter().map(own).collect::<Option<_>>()?;
    found.sort_by_key(|(power, _)| *power);
    let all = plus && found.iter().enumerate().all(|(at, (power, _))| *power == at as i64);
    all.then(|| found.into_iter().map(|(_, letter)| letter).collect())
}

/// A function whose value stands in a formula.
struct Call {
    name: Expr,
    arguments: usize,
    derived: bool,
}

fn call(part: &Expr) -> Option<Call> {
    let (callee, arguments) = match &part.kind {
        Kind::Apply(callee, groups) => (callee.as_ref(), groups.concat().len()),
        Kind::Prime(..) => (part, 0),
        _ => return None,
    };
    let (mut name, mut derived) = (callee, false);
    while let Kind::Prime(inner, _)
    | Kind::Accent(Accent::Dot | Accent::Ddot, inner)
    | Kind::Group(inner)
    | Kind::Upper(inner, _) = &name.kind
    {
        (name, derived) = (inner, true);
    }
    let plain = matches!(&without_bold(name).kind, Kind::Name(own) if !matches!(own.as_str(), "rightopen" | "leftopen"));
    plain.then(|| Call { name: name.clone(), arguments, derived })
}

/// A name without its weight.
fn without_bold(name: &Expr) -> &Expr {
    match &name.kind {
        Kind::Accent(Accent::Bold, inner) => inner,
        _ => name,
    }
}

/// The ends of a closed interval.
pub(super) fn closed(expr: &Expr) -> Option<(Expr, Expr)> {
    match &expr.kind {
        Kind::Chain(left, links) => match links.as_slice() {
            // t ∈ [0, 2]
            [link] if link.rel == Rel::In => closed(&link.expr),
            // 0 ≤ t ≤ 2
            [a, b] if a.rel == Rel::Le && b.rel == Rel::Le => {
                let variable =
                    matches!(&a.expr.kind, Kind::Name(name) if is_variable(name) && !is_index_letter(name));
                variable.then(|| (left.as_ref().clone(), b.expr.clone()))
            }
            _ => None,
        },
        _ => {
            let ([from, to], open) = interval(expr)?;
            (open == [false, false]).then(|| (from.clone(), to.clone()))
        }
    }
}
