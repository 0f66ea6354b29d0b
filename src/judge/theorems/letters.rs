//! The letters of a formula by what they are used as, and the ways to exchange those of a theorem for them.

use std::collections::BTreeSet;

use super::entry::Equation;
use super::free::{Functions, is_raised};
use crate::formula::{Accent, Expr, Kind};
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases, integer_names, is_index_letter, own_names, walk};
use crate::math::number::Rational;

/// So many ways to exchange the letters are tried for one equation.
const MOST_WAYS: usize = 120;

/// Letters of a theorem and what stands in their place.
pub(super) type Letters = Vec<(String, Expr)>;

/// Letters that are integers wherever they stand.
const COUNTS: &[&str] = &["i", "j", "k", "l", "m", "n"];

/// A letter for a family or a function.
#[derive(Clone, Debug)]
pub(super) struct Letter {
    pub(super) base: String,
    pub(super) name: Expr,
    /// The number of its indices.
    indices: usize,
    /// Whether it is a function, and then whether it has several arguments.
    applied: Option<bool>,
}

/// The letters of a formula.
#[derive(Clone, Debug, Default)]
pub(super) struct Profile {
    /// Families and functions.
    pub(super) letters: Vec<Letter>,
    /// Other names that are no integers.
    pub(super) variables: Vec<Expr>,
    /// Integers that no sum binds.
    pub(super) integers: Vec<String>,
    /// Letters with an index above.
    pub(super) raised: BTreeSet<String>,
}

impl Profile {
    /// The letters of the sides of an equation; `towers` have indices above, and `applied` tells of which letters it is
    /// known that they are functions.
    pub(super) fn of(sides: &[&Expr], towers: &BTreeSet<String>, applied: &dyn Fn(&str) -> bool) -> Profile {
        let mut profile = Profile { raised: towers.clone(), ..Profile::default() };
        let mut bound = Vec::new();
        let mut integers: BTreeSet<String> = BTreeSet::new();
        for side in sides {
            integers.extend(integer_names(side));
            walk(side, &mut |part| {
                match &part.kind {
                    Kind::Big { lower, .. } => bound.extend(own_names(lower)),
                    Kind::Integral { variable, .. } => bound.extend(Head::of(variable).map(|head| head.base)),
                    _ => {}
                }
                // Nobody writes b_i^1 for a power.
                let first = matches!(&part.kind, Kind::Pow(base, one) if one.as_int() == Some(1) && matches!(base.kind, Kind::Subscript(..)));
                if first || is_raised(part, &BTreeSet::new()) {
                    profile.raised.extend(Head::of(part).map(|head| head.base));
                }
            });
        }
        let mut look = Look { profile, bound, integers, applied, functions: BTreeSet::new() };
        // N(2x - 1) is a value if N(x) is one.
        for side in sides {
            walk(side, &mut |part| {
                if let Kind::Apply(callee, groups) = &part.kind
                    && let Some(head) = undone(callee).and_then(Head::of)
                    && look.is_function(&head, &groups.iter().flatten().collect::<Vec<_>>())
                {
                    look.functions.insert(head.base);
                }
            });
        }
        sides.iter().for_each(|side| look.at(side));
        look.profile
    }

    /// The functions, polar forms with the number of their arguments.
    pub(super) fn functions(&self, polar: &[(String, usize)]) -> Functions {
        let functions = self.letters.iter().filter(|letter| letter.applied.is_some());
        functions
            .map(|letter| {
                let arity = polar.iter().find(|(base, _)| *base == letter.base).map(|(_, arity)| *arity);
                (letter.base.clone(), arity)
            })
            .collect()
    }

    /// Whether a letter stands with indices, and not for a function.
    pub(super) fn is_family(&self, base: &str) -> bool {
        self.letters.iter().any(|letter| letter.base == base && letter.applied.is_none())
    }

    fn count(&self, of: &Letter) -> usize {
        self.letters.iter().filter(|letter| letter.is_like(of)).count()
    }

    /// Whether there are as many letters of each kind in both, and no more integers than in a theorem. The ends of
    /// intervals may be numbers.
    pub(super) fn may_be(&self, theorem: &Profile) -> bool {
        let ends = || theorem.variables.iter().filter(|name| is_end_name(name)).count();
        self.letters.len() == theorem.letters.len()
            && (self.variables.len() == theorem.variables.len()
                || ends() > 1 && self.variables.len() + ends() == theorem.variables.len())
            && self.integers.len() <= theorem.integers.len()
            && self.letters.iter().all(|letter| self.count(letter) == theorem.count(letter))
    }
}

impl Letter {
    fn is_like(&self, other: &Letter) -> bool {
        self.indices == other.indices && self.applied == other.applied
    }
}

/// Whether a letter of the table is an end of an interval.
pub(super) fn is_end(letter: &str) -> bool {
    matches!(letter, "u" | "v" | "w")
}

fn is_end_name(name: &Expr) -> bool {
    matches!(&name.kind, Kind::Name(letter) if is_end(letter))
}

struct Look<'a> {
    profile: Profile,
    bound: Vec<String>,
    integers: BTreeSet<String>,
    applied: &'a dyn Fn(&str) -> bool,
    functions: BTreeSet<String>,
}

impl Look<'_> {
    fn at(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Apply(callee, groups) => {
                let word =
                    matches!(&callee.kind, Kind::Name(name) if matches!(name.as_str(), "det" | "sqrt"));
                let marked = undone(callee);
                let head = marked.and_then(Head::of).filter(|head| head.arguments.is_none());
                let items: Vec<&Expr> = groups.iter().flatten().collect();
                if let (Some(head), Some(name), false) = (&head, marked, word)
                    && self.is_function(head, &items)
                {
                    let many =
                        items.len() > 1 || items.iter().any(|item| matches!(item.kind, Kind::Brace(..)));
                    self.letter(head, name, Some(many));
                } else if !word {
                    self.at(callee);
                }
                items.into_iter().for_each(|item| self.at(item));
            }
            Kind::Mul(factors) => {
                let mut differences = BTreeSet::new();
                for (at, pair) in factors.windows(2).enumerate() {
                    match (&pair[0].kind, &pair[1].kind) {
                        (Kind::Name(name), Kind::Subscript(..)) if name == "Delta" => {
                            differences.insert(at);
                        }
                        (Kind::Pow(base, order), Kind::Subscript(..)) if matches!(&base.kind, Kind::Name(name) if name == "Delta") =>
                        {
                            differences.insert(at);
                            self.at(order);
                        }
                        (Kind::Name(name), Kind::List(_)) | (Kind::List(_), Kind::Name(name)) => {
                            let place = if matches!(pair[0].kind, Kind::Name(_)) { at } else { at + 1 };
                            differences.insert(place);
                            let base = format!("[]{name}");
                            self.add(Letter {
                                base,
                                name: factors[place].clone(),
                                indices: 0,
                                applied: Some(true),
                            });
                        }
                        _ => {}
                    }
                }
                for (at, factor) in factors.iter().enumerate() {
                    if !differences.contains(&at) {
                        self.at(factor);
                    }
                }
            }
            Kind::Subscript(..) | Kind::Upper(..) => self.member(expr),
            Kind::Pow(..) if is_raised(expr, &self.profile.raised) => self.member(expr),
            Kind::Name(name) => {
                if self.bound.contains(name) || name == "infty" {
                } else if self.integers.contains(name) && is_index_letter(name)
                    || COUNTS.contains(&name.as_str())
                {
                    if !self.profile.integers.contains(name) {
                        self.profile.integers.push(name.clone());
                    }
                } else {
                    self.variable(expr);
                }
            }
            Kind::Accent(Accent::Hat, body) if matches!(body.kind, Kind::Number(_)) => {}
            Kind::Accent(..) => self.variable(expr),
            Kind::Derivative { body, variables, .. } => {
                variables.iter().filter_map(|(_, order)| order.as_ref()).for_each(|order| self.at(order));
                body.iter().for_each(|body| self.at(body));
            }
            _ => expr.for_each_child(&mut |child| self.at(child)),
        }
    }

    fn is_function(&self, head: &Head, items: &[&Expr]) -> bool {
        let plain = |item: &&Expr| {
            let item = inner(item);
            matches!(
                item.kind,
                Kind::Name(_) | Kind::Number(_) | Kind::Div(..) | Kind::Subscript(..) | Kind::Accent(..)
            )
        };
        let count = COUNTS.contains(&head.base.as_str()) && head.lower.is_empty();
        !count
            && (self.functions.contains(&head.base)
                || (self.applied)(&head.base)
                || items.len() > 1
                || items.iter().any(plain)
                || head.lower.len() > 1)
    }

    fn member(&mut self, expr: &Expr) {
        match Head::of(expr) {
            Some(head) if head.arguments.is_none() => self.letter(&head, expr, None),
            _ => expr.for_each_child(&mut |child| self.at(child)),
        }
    }

    fn letter(&mut self, head: &Head, expr: &Expr, applied: Option<bool>) {
        let indices = head.lower.len() + head.upper.len();
        self.add(Letter { base: head.base.clone(), name: base_of(expr).clone(), indices, applied });
        head.lower.iter().chain(&head.upper).for_each(|index| self.at(index));
    }

    fn add(&mut self, letter: Letter) {
        match self
            .profile
            .letters
            .iter_mut()
            .find(|known| known.base == letter.base && known.is_like(&letter))
        {
            Some(_) => {}
            None => {
                // f(t, …, t) and f(t): the one with more arguments tells.
                let other = self.profile.letters.iter_mut().find(|known| {
                    known.base == letter.base && known.indices == letter.indices && known.applied.is_some()
                });
                match (other, letter.applied) {
                    (Some(known), Some(many)) => known.applied = Some(many || known.applied == Some(true)),
                    _ => self.profile.letters.push(letter),
                }
            }
        }
    }

    fn variable(&mut self, expr: &Expr) {
        if !self.profile.variables.iter().any(|known| known.same_as(expr)) {
            self.profile.variables.push(expr.clone().without_spans());
        }
    }
}

/// A function without the marks of derivatives.
fn undone(callee: &Expr) -> Option<&Expr> {
    match &callee.kind {
        Kind::Prime(body, _)
        | Kind::Accent(Accent::Dot | Accent::Ddot, body)
        | Kind::Derivative { body: Some(body), .. } => Some(body),
        Kind::Upper(body, _) if Head::of(body).is_some_and(|head| head.lower.is_empty()) => Some(body),
        _ => Some(callee),
    }
}

/// The letter of a name, with its marks.
pub(super) fn base_of(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Subscript(base, _) | Kind::Pow(base, _) | Kind::Upper(base, _) | Kind::Apply(base, _) => {
            base_of(base)
        }
        Kind::Prime(base, _) | Kind::Accent(Accent::Dot | Accent::Ddot, base) => base_of(base),
        _ => expr,
    }
}

/// A way to read a claim as an instance of a theorem.
#[derive(Clone, Debug, Default)]
pub(super) struct Way {
    /// What stands for the letters.
    pub(super) letters: Letters,
    /// What stands for the integers.
    pub(super) integers: Letters,
    /// So many of the integers, the first ones, are indices on the left.
    pub(super) anchored: usize,
    /// Whether the page says which of the ends of intervals is before which.
    pub(super) ordered: bool,
    /// What stands for both ends of an interval, if the theorem has one.
    pub(super) ends: Vec<Expr>,
}

impl Way {
    /// What stands for the degree, or order, n.
    pub(super) fn size(&self) -> Option<&Expr> {
        self.integers.iter().find(|(letter, _)| letter == "n").map(|(_, size)| size)
    }
}

/// What the page says of sizes.
pub(super) struct Said {
    /// Degrees.
    pub(super) degrees: Vec<i64>,
    /// Intervals, the latest first.
    pub(super) intervals: Vec<(Expr, Expr)>,
}

impl Said {
    /// Numbers that are the ends of neighbouring intervals, if the page speaks of no others.
    fn ends(&self, count: usize) -> Option<Vec<Expr>> {
        let mut places: Vec<(Rational, Rational)> = Vec::new();
        for (from, to) in &self.intervals {
            if let (Some(from), Some(to)) = (number(from), number(to))
                && !places.contains(&(from.clone(), to.clone()))
            {
                places.push((from, to));
            }
        }
        places.sort();
        let adjacent = places.windows(2).all(|pair| pair[0].1 == pair[1].0);
        let all = places.first().map(|(from, _)| from).into_iter().chain(places.iter().map(|(_, to)| to));
        (adjacent && places.len() + 1 == count).then(|| all.map(Expr::number).collect())
    }

    /// Whether a name stands before another one on the line, as intervals or else the alphabet tells.
    fn in_order(&self, one: &Expr, other: &Expr) -> bool {
        let base = |name: &Expr| Head::of(name).map(|head| head.base);
        self.says_before(one, other) || !self.says_before(other, one) && base(one) <= base(other)
    }

    /// Whether intervals tell that a name stands before another one on the line.
    fn says_before(&self, one: &Expr, other: &Expr) -> bool {
        let mut reached = vec![one];
        let mut at = 0;
        while at < reached.len() {
            let here = reached[at];
            for (start, end) in &self.intervals {
                if start.same_as(here) && !reached.iter().any(|known| known.same_as(end)) {
                    reached.push(end);
                }
            }
            at += 1;
        }
        reached.iter().skip(1).any(|place| place.same_as(other))
    }
}

fn number(expr: &Expr) -> Option<Rational> {
    match &expr.kind {
        Kind::Number(number) => Some(number.clone()),
        Kind::Div(..) if bases(expr).is_empty() => evaluator::number(expr),
        _ => None,
    }
}

/// The ways to read a claim as an instance of an equation.
pub(super) fn ways(equation: &Equation, left: &Expr, ours: &Profile, said: &Said) -> Vec<Way> {
    let theirs = &equation.profile;
    let mut start = Way::default();
    if ours.variables.len() < theirs.variables.len() {
        let letters = theirs.variables.iter().filter(|name| is_end_name(name)).filter_map(Head::of);
        let mut letters: Vec<String> = letters.map(|head| head.base).collect();
        letters.sort();
        let Some(ends) = said.ends(letters.len()) else { return Vec::new() };
        start.letters.extend(letters.into_iter().zip(ends));
    }
    if let (Some(pattern), Some(head)) = (Head::of(&equation.left), Head::of(left)) {
        let of = |profile: &Profile, base: &str| profile.letters.iter().find(|one| one.base == base).cloned();
        match (of(theirs, &pattern.base), of(ours, &head.base)) {
            (Some(one), Some(other)) if one.is_like(&other) => start.letters.push((one.base, other.name)),
            (None, None) => {}
            _ => return Vec::new(),
        }
        for (pattern, index) in indices(&pattern).iter().zip(indices(&head)) {
            if let Kind::Name(letter) = &pattern.kind
                && theirs.integers.contains(letter)
                && !start.integers.iter().any(|(known, _)| known == letter)
            {
                start.integers.push((letter.clone(), index));
            }
        }
    }
    let mut all = vec![start];
    for letter in &theirs.letters {
        let candidates: Vec<&Expr> =
            ours.letters.iter().filter(|own| own.is_like(letter)).map(|own| &own.name).collect();
        let rivals =
            theirs.letters.iter().filter(|other| other.is_like(letter)).map(|other| other.base.as_str());
        all = extended(all, &letter.base, &candidates, Some(&rivals.collect()));
    }
    let variables = theirs.variables.iter().filter_map(Head::of).map(|head| head.base).collect::<Vec<_>>();
    for variable in &variables {
        let rivals = variables.iter().map(String::as_str).collect();
        all = extended(all, variable, &ours.variables.iter().collect::<Vec<_>>(), Some(&rivals));
    }
    // From a to b, not from b to a.
    let ends = |way: &Way| -> Vec<Expr> {
        let end =
            |letter: &str| way.letters.iter().find(|(known, _)| known == letter).map(|(_, own)| own.clone());
        ["u", "v", "w"].into_iter().filter_map(end).filter(|end| Head::of(end).is_some()).collect()
    };
    all.retain(|way| ends(way).windows(2).all(|pair| said.in_order(&pair[0], &pair[1])));
    for way in &mut all {
        way.anchored = way.integers.len();
        way.ends = ends(way);
        way.ordered = way.ends.windows(2).all(|pair| said.says_before(&pair[0], &pair[1]));
    }
    for integer in &theirs.integers {
        let names: Vec<Expr> = ours.integers.iter().map(Expr::name).collect();
        let mut candidates = names.clone();
        candidates.extend(names.iter().map(|name| name.clone().plus(-1)));
        candidates.extend(names.iter().map(|name| name.clone().plus(1)));
        if ours.integers.len() < theirs.integers.len() {
            let degrees = said.degrees.iter();
            let said = degrees.clone().copied().chain(degrees.map(|degree| degree - 1));
            let mut numbers: Vec<i64> = said.chain(0..=4).filter(|number| *number >= 0).collect();
            let mut seen = BTreeSet::new();
            numbers.retain(|number| seen.insert(*number));
            candidates.extend(numbers.into_iter().map(Expr::int));
        }
        all = extended(all, integer, &candidates.iter().collect::<Vec<_>>(), None);
    }
    // What is claimed for all n is no instance for one n.
    all.retain(|way| {
        let used: BTreeSet<String> = way.integers.iter().flat_map(|(_, value)| bases(value)).collect();
        ours.integers.iter().all(|name| used.contains(name))
    });
    all.truncate(MOST_WAYS);
    all
}

fn indices(head: &Head) -> Vec<Expr> {
    head.lower.iter().chain(&head.upper).map(|index| inner(index).clone()).collect()
}

fn inner(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::List(items) if items.len() == 1 => inner(&items[0]),
        Kind::Group(body) => inner(body),
        _ => expr,
    }
}

/// Ways in which one more letter has something in its place; `rivals` stand for other things than it, and none are given
/// for an integer.
fn extended(all: Vec<Way>, letter: &str, candidates: &[&Expr], rivals: Option<&BTreeSet<&str>>) -> Vec<Way> {
    let integer = rivals.is_none();
    let mut next: Vec<Way> = Vec::new();
    for way in all {
        let known = if integer { &way.integers } else { &way.letters };
        if known.iter().any(|(own, _)| own == letter) {
            next.push(way);
            continue;
        }
        for candidate in candidates {
            // Two letters are two things; two integers may be one number.
            let clash = |(own, value): &(String, Expr)| match rivals {
                None => {
                    let names = bases(candidate);
                    !names.is_empty() && names == bases(value)
                }
                Some(rivals) => rivals.contains(own.as_str()) && value.same_as(candidate),
            };
            if known.iter().any(clash) {
                continue;
            }
            let mut longer = way.clone();
            let list = if integer { &mut longer.integers } else { &mut longer.letters };
            list.push((letter.to_owned(), (*candidate).clone()));
            next.push(longer);
        }
    }
    next.truncate(8 * MOST_WAYS);
    next
}
