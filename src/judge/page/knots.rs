//! The knots that a page speaks of: listed, named, given by numbers, or told by supports.

use std::collections::{BTreeMap, BTreeSet};

use crate::formula::{Expr, Kind, Rel, Sign, interval};
use crate::judge::page::context::{Body, Context};
use crate::judge::page::letters::Letters;
use crate::judge::page::object::{Declared, Sort};
use crate::judge::page::statement::Place;
use crate::judge::written::names::{Head, bases, walk};
use crate::language::lexicon::families;
use crate::language::lexicon::roles::{self, Listed};
use crate::math::number::{Rational, integer};
use num_traits::ToPrimitive;

/// So many knots are taken of a formula for all of them.
const FORMULA_KNOTS: std::ops::Range<i64> = -4..13;

impl Context {
    /// The letters whose members are knots: those that words call so, or between which a B-spline is defined to
    /// be 1 or lives, or of whose members a claim has differences in denominators; else t.
    pub fn knot_letters(&self, place: &Place, sides: &[&Expr]) -> Vec<String> {
        let mut found = self.stated_knots(place);
        if found.is_empty() {
            found = divided_by(sides);
        }
        if found.is_empty() { vec![self.usual_knots(place, sides)] } else { found }
    }

    /// The letter that many give to knots and this section to numbers in a row: u, after u_0 = u_1 = u_2 = 0, u_3 = 1; else t.
    /// Coefficients are none: the abscissae ξ_i in Σ ξ_i N_i(u).
    fn usual_knots(&self, place: &Place, sides: &[&Expr]) -> String {
        let coefficients = coefficients(sides);
        let mut others = roles::letters_of(Listed::Knots)
            .filter(|letter| *letter != "t" && !coefficients.contains(*letter));
        let given = |letter: &&str| !in_order(self.members_given(&[(*letter).to_owned()], place)).is_empty();
        others.find(given).unwrap_or("t").to_owned()
    }

    /// The knots that the section gives by number, from the first on without a gap.
    pub fn given_knots(&self, letters: &[String], place: &Place) -> BTreeMap<i64, Rational> {
        let found = self.members_given(letters, place);
        if !found.is_empty() {
            return in_order(found);
        }
        let first = self
            .first_listed(letters, place)
            .or_else(|| self.letters.first_knot())
            .or_else(|| self.first_point(place));
        first.map_or_else(BTreeMap::new, |first| in_order((first..).zip(self.unnamed_knots(place)).collect()))
    }

    /// The values that the section gives to members of some letters, by their numbers.
    fn members_given(&self, letters: &[String], place: &Place) -> BTreeMap<i64, Rational> {
        let mut found = BTreeMap::new();
        for letter in letters {
            for (_, definition, near) in self.visible(letter, place) {
                let value = match &definition.body {
                    Body::Formula(Expr { kind: Kind::Number(q), .. }) => Some(q.clone()),
                    Body::Value(value) => value.as_rational(),
                    Body::Formula(_) => None,
                };
                // u_i = i
                if let (true, Some(Expr { kind: Kind::Name(index), .. }), Body::Formula(body)) =
                    (near && definition.head.lower.len() == 1, definition.head.index(), &definition.body)
                    && bases(body).iter().all(|name| name == index)
                    // i ∈ ℤ; n = 2 beside it says nothing of the knots.
                    && definition.conditions.iter().all(|condition| {
                        of_integers(condition) || !bases(condition).contains(index)
                    })
                {
                    for j in FORMULA_KNOTS {
                        if let Some(value) = value_at(body, index, j) {
                            found.entry(j).or_insert(value);
                        }
                    }
                }
                let index = definition.head.index().and_then(Expr::as_int);
                if let (true, Some(index), Some(value)) = (near, index, value) {
                    found.entry(index).or_insert(value);
                }
            }
        }
        // i^2 increases from 0 on.
        if let Some((first, _)) = found.first_key_value()
            && *first == FORMULA_KNOTS.start
        {
            while let Some((second, next)) = found.iter().nth(1)
                && *second < 1
                && found.first_key_value().is_some_and(|(_, first)| first > next)
            {
                found.pop_first();
            }
        }
        found
    }

    /// The number of the first knot where the page lists their names: 0 of t_0, …, t_7.
    fn first_listed(&self, letters: &[String], place: &Place) -> Option<i64> {
        self.heard.windows(3).rev().find_map(|window| {
            let [(here, first), (_, dots), (_, last)] = window else { return None };
            let head = Head::of(first).filter(|head| letters.contains(&head.base))?;
            let listed = dots.kind == Kind::Ellipsis && Head::of(last)?.base == head.base;
            (listed && place.knows(here, false)).then(|| head.index()?.as_int())?
        })
    }

    /// The number of the first point in sums over B-splines, where all are given.
    fn first_point(&self, place: &Place) -> Option<i64> {
        let mut given = self
            .letters
            .spline_points
            .iter()
            .filter_map(|(letter, _)| self.given_from_to(letter, 1, 0, place));
        given.next().map(|[first, _]| first)
    }

    /// Whether the section gives knots that are not at equal distances.
    pub fn has_uneven_knots(&self, place: &Place) -> bool {
        let listed = self.unnamed_knots(place);
        let given = self.given_knots(&self.stated_knots(place), place);
        let uneven =
            |knots: &[Rational]| knots.windows(3).any(|three| &three[1] - &three[0] != &three[2] - &three[1]);
        // Numbers in a row that do not decrease may be knots, whatever they are called.
        let rows = self
            .heard
            .chunk_by(|(a, _), (b, _)| a.formula == b.formula)
            .filter(|row| row.first().is_some_and(|(other, _)| other.group == place.group) && row.len() > 3);
        let mut rows = rows.filter_map(|row| row.iter().map(|(_, expr)| expr.as_number().cloned()).collect());
        let unlike = |row: Vec<Rational>| row.is_sorted() && uneven(&row);
        uneven(&listed) || uneven(&given.into_values().collect::<Vec<_>>()) || rows.any(unlike)
    }

    /// Whether the second index of a B-spline N is its degree. The page tells it by where its recursion begins, at
    /// N_{i,0}, or at N_i^1 with orders; by as many knots as a sum of B-splines needs; by the degree of its splines.
    pub fn spline_has_degree(&self, place: &Place) -> Option<bool> {
        let begins = self.visible(families::SPLINE, place).find_map(|(_, definition, _)| {
            let last = definition.head.upper.last().or(definition.head.lower.get(1))?;
            match last.as_int() {
                Some(0) => Some(true),
                Some(1) => Some(false),
                _ => None,
            }
        });
        let counted = || {
            let Letters { spline_sums, spline_points, .. } = &self.letters;
            if spline_sums.is_empty() && spline_points.is_empty() {
                return None;
            }
            let knots = match self.unnamed_knots(place).len() {
                0 => self.given_knots(&self.stated_knots(place), place).len(),
                listed => listed,
            } as i64;
            let bounded = spline_sums.iter().map(|[from, to, size]| (to - from + 1, *size));
            // Σ_i d_i N_{i,2}, where the d_i are given
            let given = spline_points.iter().filter_map(|(letter, size)| {
                let [first, last] = self.given_from_to(letter, 1, 0, place)?;
                Some((last - first + 1, *size))
            });
            bounded.chain(given).find_map(|(count, size)| match knots - count - size {
                1 => Some(true),
                0 => Some(false),
                _ => None,
            })
        };
        let said = || {
            let here = self
                .objects
                .iter()
                .rev()
                .filter(|declared| place.knows(&declared.place, declared.object.local));
            let splines = here.filter(|d| matches!(d.object.sort, Sort::SplineCurve | Sort::BSpline));
            splines.filter_map(|declared| declared.object.degree.as_ref()?.as_int()).find_map(|degree| {
                let sizes = &self.letters.spline_sizes;
                match (sizes.contains(&degree), sizes.contains(&(degree + 1))) {
                    (true, false) => Some(true),
                    (false, true) => Some(false),
                    _ => None,
                }
            })
        };
        begins.or_else(counted).or_else(said)
    }

    /// The same of the letter of a size of which words say that it is a degree, "of degree p", "of degree k - 1".
    pub fn spline_has_this_degree(&self, size: &Expr, place: &Place) -> Option<bool> {
        let Some(letter) = bases(size).into_iter().next() else { return self.spline_has_degree(place) };
        let own = Expr::name(&letter);
        let (mut told, mut less) = (None, None);
        for size in self.sizes_of(&letter).filter(|told| place.in_reach(&told.place, false)) {
            let Some(said) = &size.object.degree else { continue };
            let said = match &said.kind {
                Kind::Chain(left, _) => left,
                _ => said,
            };
            let degree = size.object.sort == Sort::Degree;
            let by = if degree { -1 } else { 1 };
            // "Of degree p - 1" beside "of degree p": p is the degree.
            if said.same_as(&own) {
                told = told.or(Some(degree));
            } else if said.same_as(&own.clone().plus(by)) {
                less = less.or(Some(!degree));
            }
        }
        told.or(less).or_else(|| self.spline_has_degree(place))
    }

    /// The latest list of numbers that the section calls knots: the knot vector (0, 0, 0, 1, 1, 1), perhaps by a name
    /// for it, or the knots of its latest spline.
    fn unnamed_knots(&self, place: &Place) -> Vec<Rational> {
        // The formula that gives them is not judged by itself.
        let here = self.objects.iter().rev().filter(|declared| {
            place.knows(&declared.place, declared.object.local) && declared.place.formula != place.formula
        });
        let lists = here.map(|declared| match declared.object.sort {
            Sort::Knots => declared.object.names.as_slice(),
            Sort::SplineCurve => declared.object.knots.as_slice(),
            _ => &[],
        });
        let numbers = |items: &[Expr]| -> Option<Vec<Rational>> {
            let items = match items {
                [one @ Expr { kind: Kind::Name(name), .. }] => self
                    .visible(name, place)
                    .find_map(|(_, definition, near)| match &definition.body {
                        Body::Formula(body) if near => body.elements(),
                        _ => None,
                    })
                    .or_else(|| one.elements())?,
                // The knots u = (0, 0, 0, 1, 2, 2, 2)
                [Expr { kind: Kind::Chain(_, links), .. }] => links.last()?.expr.elements()?,
                [one] => one.elements()?,
                items => items,
            };
            items.iter().map(|item| item.as_number().cloned()).collect()
        };
        lists.filter(|items| !items.is_empty()).find_map(numbers).unwrap_or_default()
    }

    /// The letters that the page itself gives to knots.
    pub fn stated_knots(&self, place: &Place) -> Vec<String> {
        let mut found: Vec<String> = Vec::new();
        let mut put = |letter: &Expr| {
            if let Kind::Name(letter) = &letter.kind
                && !found.contains(letter)
            {
                found.push(letter.clone());
            }
        };
        let alive = |declared: &&Declared| place.in_reach(&declared.place, declared.object.local);
        for declared in self.objects.iter().filter(alive) {
            if declared.object.sort == Sort::Knots {
                for name in &declared.object.names {
                    match &name.kind {
                        // The knots u = (0, 0, 0, 1, …)
                        Kind::Chain(left, _) if matches!(left.kind, Kind::Name(_)) => put(left),
                        // The knot vector (u_0, …, u_8) = (0, 0, 0, 1, …)
                        Kind::Chain(left, _) => {
                            left.items().into_iter().flatten().filter_map(family).for_each(&mut put);
                        }
                        _ => family(name).into_iter().for_each(&mut put),
                    }
                }
            }
            if matches!(declared.object.sort, Sort::BSpline | Sort::SplineCurve) {
                declared.object.knots.iter().filter_map(family).for_each(&mut put);
            }
        }
        for definition in self.definitions.iter().filter(|d| place.in_reach(&d.place, d.assumed)) {
            let Body::Formula(Expr { kind: Kind::Cases(cases), .. }) = &definition.body else { continue };
            for condition in cases.iter().filter_map(|(_, condition)| condition.as_ref()) {
                if let Kind::Chain(left, links) = &condition.kind
                    && let [one, two] = links.as_slice()
                    && matches!((one.rel, two.rel), (Rel::Le | Rel::Lt, Rel::Le | Rel::Lt))
                {
                    [left, &two.expr].into_iter().filter_map(family).for_each(&mut put);
                }
            }
        }
        if found.is_empty() { self.ends_of_supports(place) } else { found }
    }

    /// The letters of the ends of intervals [u_i, u_{i+p+1}], [u_j, u_{j+1}).
    fn ends_of_supports(&self, place: &Place) -> Vec<String> {
        let letter = |end: &Expr| {
            let head = Head::of(end).filter(|head| head.arguments.is_none() && head.upper.is_empty())?;
            head.lower.iter().any(|index| !bases(index).is_empty()).then_some(head.base)
        };
        let heard = self.heard.iter().filter(|(other, _)| place.knows(other, false));
        let mut found: Vec<String> = Vec::new();
        for ([from, to], _) in heard.filter_map(|(_, expr)| interval(expr)) {
            if let (Some(one), Some(other)) = (letter(from), letter(to))
                && one == other
                && !found.contains(&one)
            {
                found.push(one);
            }
        }
        found
    }
}

/// The letters of members that are multiplied by values of functions: ξ of ξ_i N_i(u).
fn coefficients(sides: &[&Expr]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Mul(factors) = &part.kind
                && factors.iter().any(|factor| matches!(factor.kind, Kind::Apply(..)))
            {
                found.extend(factors.iter().filter_map(family).flat_map(bases));
            }
        });
    }
    found
}

/// The letter of a member: t of t_i.
fn family(member: &Expr) -> Option<&Expr> {
    match &member.kind {
        Kind::Subscript(base, _) => Some(base),
        // u_i = 2i
        Kind::Chain(left, _) => family(left),
        _ => None,
    }
}

/// Knots whose numbers follow each other and that do not decrease; nothing if others are among them, or too few.
fn in_order(found: BTreeMap<i64, Rational>) -> BTreeMap<i64, Rational> {
    let knots: Vec<(&i64, &Rational)> = found.iter().collect();
    let whole = knots.windows(2).all(|pair| *pair[0].0 + 1 == *pair[1].0 && pair[0].1 <= pair[1].1);
    if whole && knots.len() > 2 { found } else { BTreeMap::new() }
}

/// i ∈ ℤ
fn of_integers(condition: &Expr) -> bool {
    matches!(&condition.kind, Kind::Chain(_, links)
        if matches!(links.as_slice(), [link] if link.rel == Rel::In && matches!(link.expr.kind, Kind::Accent(..))))
}

/// The value of a formula in an index that adds, multiplies and divides.
fn value_at(body: &Expr, index: &str, value: i64) -> Option<Rational> {
    let of = |expr: &Expr| value_at(expr, index, value);
    Some(match &body.kind {
        Kind::Name(name) if name == index => integer(value),
        Kind::Number(q) => q.clone(),
        Kind::Group(inner) => of(inner)?,
        Kind::Add(terms) => terms.iter().try_fold(integer(0), |sum, term| {
            let own = of(&term.expr)?;
            Some(if term.sign == Sign::Minus { sum - own } else { sum + own })
        })?,
        Kind::Mul(factors) => factors.iter().try_fold(integer(1), |all, own| Some(all * of(own)?))?,
        Kind::Div(above, below, _) => {
            let below = of(below)?;
            (below != integer(0)).then_some(())?;
            of(above)? / below
        }
        // i^2, 2^i
        Kind::Pow(base, exponent) => {
            let (base, exponent) = (of(base)?, of(exponent)?);
            let power = exponent.is_integer().then(|| exponent.to_usize()).flatten()?;
            (power <= 16).then(|| num_traits::pow(base, power))?
        }
        _ => return None,
    })
}

/// The letters in denominators that are differences of members of one family: t in (x - t_i)/(t_{i+n} - t_i).
pub fn divided_by(sides: &[&Expr]) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let member = |expr: &Expr| match &expr.kind {
        Kind::Subscript(base, _) => match &base.kind {
            Kind::Name(letter) => Some(letter.clone()),
            _ => None,
        },
        _ => None,
    };
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Div(_, below, _) = &part.kind
                && let Kind::Add(terms) = &below.kind
                && let [first, second] = terms.as_slice()
                && let (Some(a), Some(b)) = (member(&first.expr), member(&second.expr))
                && a == b
                && !found.contains(&a)
            {
                found.push(a);
            }
        });
    }
    found
}
