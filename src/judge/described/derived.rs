//! Numbers for several new points, against what can be made of the numbers that the section gives.
//!
//! **Definition.** A *row* is a list of numbers or points, or members of one family with numbers in a row: b_0 = …, b_1 = ….
//! What is *made* of a row is what the topics of its section let be made of it: its points at a higher degree, those of a part,
//! of the derivative, of a segment of a uniform spline, of a refined polygon, those after a knot was inserted, the Greville
//! abscissae of knots.
//!
//! **Rule.** A row that nothing else decides holds if it is made of an earlier one, where at least two of its coordinates do
//! not stand beside their place there already. One of its items is wrong if all others are made so, nothing else fits, and all that comes so
//! near gives the same point in its place.

use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::known::checker::Checker;
use crate::judge::known::found::{Point, Row};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases};
use crate::math::curve::{self, BezierCurve, Interval};
use crate::math::number::{Rational, rational};
use crate::math::spline::{BSpline, KnotVector};
use crate::math::subdivision::Scheme;
use num_traits::{One, Zero};

/// Degrees of uniform splines whose segments are written as Bézier curves, with their words.
const UNIFORM: [(usize, &str); 2] = [
    (2, "the Bézier points of a uniform quadratic segment"),
    (3, "the Bézier points of a uniform cubic segment"),
];

/// So many rows before a row are looked at.
const MOST_ROWS: usize = 6;

/// What is made of a row, with its words.
struct Made {
    points: Vec<Point>,
    words: &'static str,
}

/// How a row compares with what is made of another.
struct Comparison {
    /// The coordinates that agree and that the other row does not have.
    hits: usize,
    /// The items that differ, each with what it should be.
    wrong: Vec<(usize, Point)>,
    /// Whether it has more items than the other row, four at least.
    grown: bool,
    words: &'static str,
}

impl Comparison {
    /// Whether so much agrees that it is no chance; the points that an algorithm only moves on count as one.
    fn is_telling(&self) -> bool {
        self.hits + usize::from(self.grown) > 1 && self.hits > 0
    }
}

impl Checker {
    /// Remembers the numbers that a chain gives; its findings are those from a number on.
    pub(in crate::judge) fn remember_row(&mut self, chain: &Chain, statement: &Statement, from: usize) {
        let equal = |relation: &Rel| matches!(relation, Rel::Eq | Rel::Define | Rel::Approx);
        let (Some(left), Some(right)) = (chain.sides.first(), chain.sides.last()) else { return };
        if chain.relations.is_empty() || !chain.relations.iter().all(|(relation, _)| equal(relation)) {
            return;
        }
        let finding = Some(from + chain.relations.len() - 1);
        let index = |expr: &Expr| {
            let head = Head::of(expr).filter(|head| head.arguments.is_none() && head.upper.is_empty())?;
            Some((head.base.clone(), head.index()?.as_int()?))
        };
        // U = (0, 0, 0, 1, 1, 1)
        if let (Kind::Name(_), Some(_)) = (&left.expr.kind, right.expr.items()) {
            return self.remember_list(&right.expr, statement);
        }
        let row = match left.expr.items() {
            None => match (index(&left.expr), point(&right.expr)) {
                (Some((letter, first)), Some(point)) => Some((letter, first, vec![(point, finding)])),
                _ => None,
            },
            Some(names) => {
                let points = points(&right.expr).unwrap_or_default();
                let dots = names.iter().any(|name| name.kind == Kind::Ellipsis);
                match (names.first().and_then(index), names.last().and_then(index)) {
                    (Some((letter, first)), Some((other, last)))
                        if letter == other
                            && (dots || names.len() == points.len())
                            && last - first + 1 == points.len() as i64 =>
                    {
                        Some((letter, first, points.into_iter().map(|point| (point, finding)).collect()))
                    }
                    _ => None,
                }
            }
        };
        if let Some((letter, first, items)) = row {
            let given = matches!(statement.role, Some(Role::Introduced | Role::Assumed | Role::Case));
            self.add_row(Row {
                letter,
                first,
                items,
                place: statement.place.clone(),
                topics: statement.topics,
                given,
            });
        }
    }

    /// Remembers a list of numbers that stands alone.
    pub(in crate::judge) fn remember_list(&mut self, expr: &Expr, statement: &Statement) {
        if let Some(points) = points(expr).filter(|points| points.len() > 2) {
            let items = points.into_iter().map(|point| (point, None)).collect();
            let (place, topics) = (statement.place.clone(), statement.topics);
            self.add_row(Row { letter: String::new(), first: 0, items, place, topics, given: true });
        }
    }

    fn add_row(&mut self, row: Row) {
        if let Some(last) = self.rows.last_mut()
            && !row.letter.is_empty()
            && last.letter == row.letter
            && last.first + last.items.len() as i64 == row.first
            && last.place.scope == row.place.scope
            && last.place.blocks == row.place.blocks
            && last.place.changes == row.place.changes
            && row.place.group <= last.place.group + 1
        {
            last.items.extend(row.items);
            last.given &= row.given;
            last.place = row.place;
            return;
        }
        self.rows.push(row);
    }

    /// Judges the rows of the page that nothing else decided. To be called after the last statement.
    pub(in crate::judge) fn by_rows(&mut self) {
        let open = |findings: &[Finding], number: usize| {
            findings.get(number).is_some_and(|finding| finding.verdict == Verdict::Definition)
        };
        for at in 0..self.rows.len() {
            let row = &self.rows[at];
            let mut numbers = row.items.iter().filter_map(|(_, finding)| *finding);
            if row.given || !numbers.any(|number| open(&self.findings, number)) {
                continue;
            }
            for (number, finding) in self.compared(at).unwrap_or_default() {
                if open(&self.findings, number) {
                    self.findings[number] = finding;
                }
            }
        }
    }

    /// The findings that a row gets.
    fn compared(&self, at: usize) -> Option<Vec<(usize, Finding)>> {
        let row = &self.rows[at];
        let known = |other: &&Row| {
            let place = &other.place;
            other.letter != row.letter && row.place.knows(place, false) && !row.place.may_change(place)
        };
        let told = self.rows_told(row);
        let before: Vec<&Row> =
            self.rows[..at].iter().rev().filter(known).take(MOST_ROWS).chain(&told).collect();
        let numbers = self.numbers_heard(&row.place);
        let mut found: Vec<Comparison> = Vec::new();
        for source in &before {
            let others = before.iter().filter(|other| !std::ptr::eq(**other, *source));
            let knots: Vec<Vec<Rational>> = others.filter_map(|other| other.numbers()).collect();
            for made in source.made(row.topics, &numbers, &knots, row.items.len()) {
                found.extend(row.against(&made, source));
            }
        }
        let finding = |number: usize| self.findings.get(number).cloned();
        if let Some(held) = found.iter().find(|own| own.wrong.is_empty() && own.hits > 1) {
            let numbers = row.items.iter().filter_map(|(_, finding)| *finding);
            let proved = |number| {
                let reason = Some(format!("{}, as the words say", held.words));
                Some((number, Finding { verdict: Verdict::Proved, reason, ..finding(number)? }))
            };
            return Some(numbers.filter_map(proved).collect());
        }
        let mut near = found.iter().filter(|own| own.wrong.len() == 1 && own.is_telling());
        let first = near.next()?;
        if near.any(|other| other.wrong != first.wrong) {
            return None;
        }
        let (item, meant) = &first.wrong[0];
        let (own, number) = &row.items[*item];
        let number = (*number)?;
        let wrong = Finding {
            verdict: Verdict::Refuted,
            reason: Some(format!("it differs from {}", first.words)),
            witness: Some(format!("left {}, right {}", written(meant), written(own))),
            suggestion: None,
            evidence: vec![Evidence::Terms],
            ..finding(number)?
        };
        Some(vec![(number, wrong)])
    }

    /// The lists of numbers of which the words of a section tell, such as knots.
    fn rows_told(&self, row: &Row) -> Vec<Row> {
        let told =
            self.context.objects.iter().rev().filter(|told| row.place.knows(&told.place, told.object.local));
        let lists = told.flat_map(|told| {
            let single = |list: &[Expr]| list.iter().map(point).collect::<Option<Vec<Point>>>();
            let own = [&told.object.knots, &told.object.points, &told.object.values];
            let list = |own: &Vec<Expr>| match own.as_slice() {
                [one] => points(one),
                all => single(all),
            };
            own.into_iter().filter_map(list).filter(|points| points.len() > 2).collect::<Vec<_>>()
        });
        let rows = lists.take(MOST_ROWS).map(|points| Row {
            letter: String::new(),
            first: 0,
            items: points.into_iter().map(|point| (point, None)).collect(),
            place: row.place.clone(),
            topics: row.topics,
            given: true,
        });
        rows.collect()
    }

    /// The numbers of which the section speaks: 1/2, t = 1/2, both ends of [0, 2].
    fn numbers_heard(&self, place: &Place) -> Vec<Rational> {
        let mut found: Vec<Rational> = Vec::new();
        let mut intervals: Vec<(Rational, Rational)> = Vec::new();
        for expr in self.heard(place) {
            let value = match &expr.kind {
                Kind::Chain(left, links) if Head::of(left).is_some() => links.last().map(|link| &link.expr),
                _ => Some(expr),
            };
            let ends = interval(expr).map(|([from, to], _)| [from.clone(), to.clone()]);
            let single = value.filter(|value| value.items().is_none()).cloned();
            if let Some([from, to]) = &ends
                && let (Some(from), Some(to)) = (constant(from), constant(to))
                && from < to
            {
                intervals.push((from, to));
            }
            for number in ends.into_iter().flatten().chain(single).filter_map(|value| constant(&value)) {
                if !found.contains(&number) {
                    found.push(number);
                }
            }
        }
        // t = 1 in [0, 2] is the middle.
        let inside = intervals.iter().flat_map(|(from, to)| {
            found.iter().filter(move |x| from < *x && *x < to).map(move |x| (x - from) / (to - from))
        });
        let more: Vec<Rational> = inside.filter(|share| !found.contains(share)).collect();
        found.extend(more);
        found
    }
}

impl Row {
    /// The numbers of a row that has no points with coordinates.
    fn numbers(&self) -> Option<Vec<Rational>> {
        self.items
            .iter()
            .map(|(point, _)| <[Rational; 1]>::try_from(point.clone()).ok())
            .map(|one| Some(one?[0].clone()))
            .collect()
    }

    /// How it compares with what is made of another row; nothing if it has other places or dimensions.
    fn against(&self, made: &Made, source: &Row) -> Option<Comparison> {
        let (mut hits, mut wrong) = (0, Vec::new());
        for (at, (own, _)) in self.items.iter().enumerate() {
            let place = usize::try_from(self.first + at as i64).ok()?;
            let meant = made.points.get(place).filter(|meant| meant.len() == own.len())?;
            // An end that stays where it was says nothing.
            let beside = source.items.iter().skip(place.saturating_sub(1)).take(2 + usize::from(place > 0));
            let new = !beside.into_iter().any(|(known, _)| known == meant);
            if own == meant {
                hits += if new { own.len() } else { 0 };
            } else {
                wrong.push((at, meant.clone()));
            }
        }
        let grown = self.items.len() > source.items.len().max(3);
        Some(Comparison { hits, wrong, grown, words: made.words })
    }

    /// What the topics let be made of it, for a row with so many items.
    fn made(&self, topics: Topics, numbers: &[Rational], knots: &[Vec<Rational>], count: usize) -> Vec<Made> {
        let points: Vec<Point> = self.items.iter().map(|(point, _)| point.clone()).collect();
        let mut found = Vec::new();
        let mut add = |points: &[curve::Point<Rational>], words| {
            found.push(Made { points: points.iter().map(|point| point.to_vec()).collect(), words });
        };
        let Some(bezier) = BezierCurve::new(points.clone(), Interval::unit())
            .ok()
            .filter(|_| self.first == 0 && points.len() > 1)
        else {
            return found;
        };
        if !topics.has(Topic::Rational) {
            if topics.has(Topic::Elevation) {
                let by = count.saturating_sub(points.len()).clamp(1, 3);
                add(bezier.elevate(by).points(), "the control points at a higher degree");
            }
            let part =
                [Topic::Subdivision, Topic::Half, Topic::Casteljau].into_iter().any(|own| topics.has(own));
            let half = topics.has(Topic::Half).then(|| rational(1, 2));
            for t in numbers.iter().cloned().chain(half).filter(|t| part && !t.is_one()) {
                let ends = [(Rational::zero(), t.clone()), (t, Rational::one())];
                for interval in ends.into_iter().filter_map(|(from, to)| Interval::new(from, to).ok()) {
                    add(bezier.part(interval).points(), "the Bézier points of this part of the curve");
                }
            }
            if topics.has(Topic::Derivative) && !topics.has(Topic::Spline) {
                add(bezier.derivative().points(), "the control points of the derivative");
            }
        }
        if topics.has(Topic::Spline) && knots.is_empty() {
            for (degree, words) in
                UNIFORM.into_iter().filter(|(own, _)| topics.degrees().any(|n| n == *own as i64))
            {
                let knots = KnotVector::uniform(degree, points.len(), &Rational::zero(), &Rational::one());
                let spline = knots.and_then(|knots| BSpline::new(knots, points.clone()));
                let pieces = spline.map(|spline| spline.bezier_pieces()).unwrap_or_default();
                let all =
                    pieces.iter().enumerate().flat_map(|(k, piece)| &piece.points()[usize::from(k > 0)..]);
                add(&all.cloned().collect::<Vec<_>>(), words);
            }
        }
        if (topics.has(Topic::Scheme) || topics.has(Topic::Subdivision))
            && let Ok(cut) = Scheme::lane_riesenfeld(2).refine(bezier.points(), false)
        {
            add(&cut, "Chaikin's scheme");
        }
        for row in knots {
            let degree = row.len().checked_sub(points.len() + 1).filter(|degree| (1..6).contains(degree));
            let knots = degree.and_then(|degree| KnotVector::new(degree, row.clone()).ok());
            let Some(spline) = knots.and_then(|knots| BSpline::new(knots, points.clone()).ok()) else {
                continue;
            };
            if topics.has(Topic::Insertion) {
                for refined in
                    numbers.iter().filter(|x| !row.contains(x)).filter_map(|x| spline.insert(x).ok())
                {
                    add(refined.points(), "the control points after the insertion of a knot");
                }
            }
            if topics.has(Topic::Derivative)
                && let Ok(derivative) = spline.derivative()
            {
                add(derivative.points(), "the control points of the derivative");
            }
        }
        if topics.has(Topic::Greville)
            && let Some(own) = self.numbers()
        {
            for degree in topics.degrees().filter_map(|degree| usize::try_from(degree).ok()) {
                if let Ok(knots) = KnotVector::new(degree, own.clone()) {
                    let abscissae = (0..knots.count()).map(|i| vec![knots.greville(i)].into());
                    add(&abscissae.collect::<Vec<_>>(), "the Greville abscissa");
                }
            }
        }
        found
    }
}

fn constant(expr: &Expr) -> Option<Rational> {
    if bases(expr).is_empty() { evaluator::number(expr) } else { None }
}

/// A number, or a point by numbers.
fn point(expr: &Expr) -> Option<Point> {
    match expr.items() {
        Some(items) => items.iter().map(constant).collect(),
        None => constant(expr).map(|number| vec![number]),
    }
}

/// The numbers or points of a list.
fn points(expr: &Expr) -> Option<Vec<Point>> {
    expr.items()?.iter().map(point).collect()
}

fn written(point: &Point) -> String {
    match point.as_slice() {
        [number] => number.to_string(),
        all => format!("({})", all.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    }
}
