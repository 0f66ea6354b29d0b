//! What a whole paragraph tells of one curve, in whatever order it tells it.
//!
//! **Definition.** An *account* of a paragraph is one curve, with its degree and what determines it: control points, data,
//! a formula, or nothing more; and *families* of points, each of which is this curve's over an interval, with a degree.
//! It is made of the nouns, lists and intervals of the paragraph, wherever they stand.
//!
//! **Rule.** Lists belong to the nouns next to them, intervals and parts to families in their order. Where that leaves two
//! readings, where a second curve may be meant, or where a word says more than this, there is no account.

mod lists;
mod parts;
mod read;
mod signs;

use std::collections::BTreeMap;

use self::lists::List;
use self::read::Told;
use self::signs::{Sign, signs};
use super::super::sentence::Piece;
use super::super::speech::{self, Hint};
use super::facts::in_order;
use super::page::Page;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::written::names::Head;

/// So many sentences a paragraph may have.
const MOST_SENTENCES: usize = 8;

/// Adds what paragraphs tell as a whole to what their sentences told, where that leaves claims open.
///
/// Cost: linear in the words, times the number of hints.
pub(super) fn tell(sentences: &[Vec<Piece>], page: &Page, found: &mut BTreeMap<usize, Vec<Object>>) {
    let forms: Vec<(String, String)> = found
        .values()
        .flatten()
        .filter(|object| object.sort == Sort::PolarForm)
        .filter_map(|object| {
            let form = Head::of(object.names.first()?)?.base;
            Some((form, Head::of(object.of.as_ref()?)?.base))
        })
        .collect();
    for paragraph in paragraphs(sentences, page) {
        let Some(account) = Account::of(paragraph, page, &forms) else { continue };
        let numbers = account.numbers.clone();
        let objects = account.objects();
        let claimed = objects.iter().any(|object| account.is_claimed(object));
        let Some(first) = numbers.first().filter(|_| claimed) else { continue };
        let letters: Vec<String> = objects
            .iter()
            .flat_map(|object| object.names.iter().chain(&object.points))
            .filter_map(Head::of)
            .map(|head| head.base)
            .collect();
        let replaced = |object: &Object| {
            let own = object.names.iter().chain(&object.points).filter_map(Head::of);
            !object.is_size()
                && (object.is_unnamed() || own.map(|head| head.base).any(|base| letters.contains(&base)))
        };
        for number in &numbers {
            if let Some(list) = found.get_mut(number) {
                list.retain(|object| !replaced(object));
            }
        }
        found.entry(*first).or_default().extend(objects);
    }
}

/// The sentences with formulas of one paragraph, with those between them.
fn paragraphs<'a>(sentences: &'a [Vec<Piece>], page: &Page) -> Vec<&'a [Vec<Piece>]> {
    let groups = |sentence: &[Piece]| -> Vec<u32> {
        let numbers = sentence.iter().filter_map(|piece| match piece {
            Piece::Formula(number) => page.places.get(number),
            Piece::Words(_) => None,
        });
        numbers.map(|place| place.group).collect()
    };
    let mut found = Vec::new();
    let (mut start, mut last) = (0, None);
    for (at, sentence) in sentences.iter().enumerate() {
        let own = groups(sentence);
        let (Some(first), Some(end)) = (own.first(), own.last()) else { continue };
        if last.is_some_and(|last| last != *first) {
            found.push(&sentences[start..at]);
            start = at;
        }
        last = Some(*end);
    }
    found.push(&sentences[start..]);
    found.retain(|paragraph: &&[Vec<Piece>]| paragraph.len() <= MOST_SENTENCES);
    found
}

/// A family of points of the curve.
struct Points {
    list: List,
    degree: Option<i64>,
    interval: (Expr, Expr),
}

struct Account {
    /// The formulas of the paragraph.
    numbers: Vec<usize>,
    /// The letters in the equations of the paragraph, and the functions whose values occur there.
    letters: Vec<String>,
    /// The name of the curve, if it has one.
    name: Expr,
    degree: Option<i64>,
    /// The points that determine it come first.
    points: Vec<Points>,
    /// Values at nodes.
    data: Option<(Vec<Expr>, Vec<Expr>)>,
    /// A formula in a variable.
    formula: Option<Expr>,
    /// Its coefficients in powers, by their letters.
    coefficients: Vec<Expr>,
    knots: Vec<Expr>,
    polar: Option<Expr>,
}

impl Account {
    fn of(paragraph: &[Vec<Piece>], page: &Page, forms: &[(String, String)]) -> Option<Account> {
        let mut all = Vec::new();
        let mut topics = Topics::default();
        for sentence in paragraph {
            signs(sentence, &mut all);
            for piece in sentence {
                if let Piece::Words(words) = piece {
                    speech::topics(words, &mut topics);
                }
            }
        }
        let numbers: Vec<usize> = formulas(&all).collect();
        let other = [
            Topic::Rational,
            Topic::Join,
            Topic::Tensor,
            Topic::Triangle,
            Topic::Integral,
            Topic::Product,
            Topic::Curvature,
            Topic::DividedDifference,
        ];
        let equation = |number: &&usize| {
            let said = page.said(**number);
            said.iter().any(|said| matches!(&said.kind, Kind::Chain(_, links) if links[0].rel == Rel::Eq))
        };
        let equations = numbers.iter().filter(equation).count();
        let stops = |sign: &Sign| {
            *sign == Sign::Strange
                || *sign == Sign::Hint(Hint::Other)
                || *sign == Sign::Hint(Hint::Special) && equations < 2
        };
        if all.iter().any(stops) || other.into_iter().any(|topic| topics.has(topic)) {
            return None;
        }
        let told = Told { all: &all, page, topics, forms };
        told.account(numbers)
    }
}

/// The formulas among signs.
fn formulas(all: &[Sign]) -> impl Iterator<Item = usize> {
    all.iter().filter_map(|sign| match sign {
        Sign::Formula(number) => Some(*number),
        _ => None,
    })
}

impl Account {
    /// Takes the points of a spline.
    fn spline(&mut self, families: Vec<List>, told: &Told) -> Option<()> {
        // Of t_0 < t_1 < … it is not known how many there are.
        if self.knots.iter().any(|knot| knot.kind == Kind::Ellipsis) {
            return None;
        }
        let mut families = families.into_iter();
        let Some(list) = families.next() else {
            // One function of the basis; a spline on these knots may have any points.
            told.all.contains(&Sign::Curve(Sort::BSpline)).then_some(())?;
            self.degree =
                Some(self.knots.len() as i64 - 2).filter(|own| self.degree.is_none_or(|said| said == *own));
            return self.degree.filter(|degree| *degree > 0).map(drop);
        };
        let count = list.degree().map(|last| last + 1);
        let degree = self.degree.or_else(|| Some(self.knots.len() as i64 - count? - 1))?;
        if self.knots.is_empty() {
            self.knots = told.support(&list, degree)?;
        } else if count.is_none_or(|count| count + degree + 1 != self.knots.len() as i64) || degree < 1 {
            return None;
        }
        self.degree = Some(degree);
        let unit = (Expr::int(0), Expr::int(1));
        self.points = vec![Points { list, degree: None, interval: unit }];
        // Bézier points of pieces between knots that follow each other
        let intervals = told.intervals();
        let pieces: Vec<List> = families.collect();
        if pieces.len() != intervals.len() {
            return pieces.is_empty().then_some(());
        }
        for (list, (_, interval)) in pieces.into_iter().zip(intervals) {
            let mut inner = self.knots.windows(2);
            let piece = inner.any(|pair| pair[0].same_as(&interval.0) && pair[1].same_as(&interval.1));
            if !piece || list.degree() != Some(degree) {
                return None;
            }
            self.points.push(Points { list, degree: Some(degree), interval });
        }
        Some(())
    }

    /// Whether an equation or a value in the paragraph is about what an object says.
    fn is_claimed(&self, object: &Object) -> bool {
        object.names.iter().filter_map(Head::of).any(|head| self.letters.contains(&head.base))
    }

    fn objects(&self) -> Vec<Object> {
        let named = |sort: Sort, names: Vec<Expr>| Object { names, local: true, ..Object::new(sort) };
        let curve = vec![self.name.clone()];
        let degree = |degree: Option<i64>| degree.map(Expr::int);
        let mut points = self.points.iter();
        let mut found = Vec::new();
        let mut of = self.name.clone();
        match (&self.formula, &self.data) {
            (Some(formula), _) => of = formula.clone(),
            (None, Some((values, nodes))) => found.push(Object {
                points: values.clone(),
                knots: nodes.clone(),
                ..named(Sort::Interpolant, curve)
            }),
            (None, None) if self.points.is_empty() => found.push(Object {
                degree: degree(self.degree),
                knots: self.knots.clone(),
                ..named(Sort::BSpline, curve)
            }),
            (None, None) => {
                if let Some(own) = points.next() {
                    let points = in_order(own.list.items.clone());
                    found.push(match self.knots.is_empty() {
                        true => Object {
                            points,
                            degree: degree(own.degree),
                            interval: Some(own.interval.clone()),
                            ..named(Sort::BezierCurve, curve)
                        },
                        false => Object {
                            points,
                            degree: degree(self.degree),
                            knots: self.knots.clone(),
                            ..named(Sort::SplineCurve, curve)
                        },
                    });
                }
            }
        }
        found.extend(points.filter(|points| points.list.letter.is_some()).map(|points| Object {
            degree: degree(points.degree),
            interval: Some(points.interval.clone()),
            of: Some(of.clone()),
            ..named(Sort::ControlPoints, points.list.items.clone())
        }));
        if !self.coefficients.is_empty() {
            found.push(Object {
                of: Some(of.clone()),
                ..named(Sort::Coefficients, self.coefficients.clone())
            });
        }
        if let (Some(polar), true) = (&self.polar, self.knots.is_empty()) {
            found.push(Object { of: Some(of), ..named(Sort::PolarForm, vec![polar.clone()]) });
        }
        found
    }
}
