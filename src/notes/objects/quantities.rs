//! A point that a paragraph describes before its formula: "the point S with u = v = w = 1/3", "its point s at t = 1/2".
//!
//! **Rule.** A letter that nothing else says is the value of the one curve or patch whose control points its section
//! gives, at the one parameter that the section gives, if its words speak of a point of it and of nothing that is made
//! of it: a derivative, a part, other control points.

use std::collections::BTreeMap;

use super::page::{Page, Section};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::object::{Object, Sort, UNNAMED};
use crate::judge::page::topic::Topic;
use crate::judge::written::names::{bases, integer_names};
use crate::language::lexicon::roles::is_variable;
use crate::math::number::rational;
use crate::notes::sentence::Piece;
use crate::notes::speech;

/// Says of such letters which value they are.
///
/// Cost: linear in the words and formulas.
pub(super) fn tell(sections: &[Section], page: &Page, found: &mut BTreeMap<usize, Vec<Object>>) {
    for section in sections {
        let others = [
            Topic::Derivative,
            Topic::Curvature,
            Topic::Integral,
            Topic::Subdivision,
            Topic::Half,
            Topic::Elevation,
            Topic::Insertion,
            Topic::Join,
            Topic::PolarForm,
            Topic::Modular,
            Topic::Tensor,
        ];
        let patch = section.topics.has(Topic::Triangle);
        // "The centroid of the triangle", "a triangular patch"
        let other = |topic: &Topic| {
            section.topics.has(*topic)
                && !(patch
                    && (*topic == Topic::Tensor
                        || *topic == Topic::Integral && section.speaks_of_the_centroid()))
        };
        if others.iter().any(other) {
            continue;
        }
        let Some((number, name)) = section.described(page) else { continue };
        if !section.calls_a_point(&name, page) {
            continue;
        }
        let mut made = None;
        let Some(value) = section.value(page, found, number, &mut made) else { continue };
        let own = Object { names: vec![name], values: vec![value], ..Object::new(Sort::Symbols) };
        found.entry(number).or_default().extend(made.into_iter().chain([own]));
    }
}

impl Section<'_> {
    fn speaks_of_the_centroid(&self) -> bool {
        self.words().any(speech::speaks_of_the_centroid)
    }

    /// The only new letter for which an equation is given, and the number of its formula.
    fn described(&self, page: &Page) -> Option<(usize, Expr)> {
        let mut found: Option<(usize, Expr)> = None;
        for number in &self.numbers {
            for said in page.said(*number) {
                let Kind::Chain(left, links) = &said.kind else { continue };
                // t = 1/2, u = v = w = 1/3
                if links[0].rel != Rel::Eq || links.iter().any(|link| bases(&link.expr).is_empty()) {
                    continue;
                }
                let letter = match &left.kind {
                    Kind::Accent(_, inner) => inner.as_ref(),
                    _ => left.as_ref(),
                };
                let Kind::Name(name) = &letter.kind else { continue };
                let index =
                    |number: &usize| page.said(*number).iter().any(|said| integer_names(said).contains(name));
                if found.is_some() || self.numbers.iter().any(index) {
                    return None;
                }
                found = Some((*number, left.as_ref().clone()));
            }
        }
        let (number, name) = found?;
        // Its own value, or one of its control points, says more.
        let used = self.numbers.iter().flat_map(|own| page.said(*own)).any(|said| {
            let inside = |part: &Expr| match &part.kind {
                Kind::Apply(inner, groups) => {
                    inner.same_as(&name) || groups.iter().flatten().any(|argument| argument.same_as(&name))
                }
                Kind::Subscript(inner, _) | Kind::Pow(inner, _) => inner.same_as(&name),
                Kind::Chain(left, _) => {
                    left.items().is_some_and(|items| items.iter().any(|item| item.same_as(&name)))
                }
                _ => false,
            };
            said.has(&inside)
        });
        (!used).then_some((number, name))
    }

    /// Whether words right beside a name call it a point: "the point S", "S denotes the point".
    fn calls_a_point(&self, name: &Expr, page: &Page) -> bool {
        let own = |number: usize| match page.said(number) {
            [Expr { kind: Kind::Chain(left, _), .. }] => left.same_as(name),
            [one] => one.same_as(name),
            _ => false,
        };
        let beside = |sentence: &&[Piece]| {
            (0..sentence.len()).any(|at| {
                let Piece::Formula(number) = &sentence[at] else { return false };
                let before = at.checked_sub(1).map(|before| &sentence[before]);
                own(*number)
                    && (matches!(before, Some(Piece::Words(words)) if speech::ends_with_a_point(words))
                        || matches!(sentence.get(at + 1), Some(Piece::Words(words)) if speech::leads_to_a_point(words)))
            })
        };
        self.sentences.iter().any(beside)
    }

    /// The value of the only curve or patch at the only parameter.
    fn value(
        &self,
        page: &Page,
        found: &BTreeMap<usize, Vec<Object>>,
        claim: usize,
        made: &mut Option<Object>,
    ) -> Option<Expr> {
        let here = found.iter().filter(|(number, _)| self.numbers.contains(number)).flat_map(|(_, all)| all);
        let curve = |object: &&Object| {
            object.sort == Sort::BezierCurve && !object.points.is_empty() && object.interval.is_none()
                || object.sort == Sort::Function && !object.values.is_empty()
        };
        let mut curves = here.clone().filter(curve);
        let mut points = here.filter(|object| object.sort == Sort::ControlPoints && object.of.is_none());
        let name = match (curves.next(), curves.next(), points.next(), points.next()) {
            (Some(one), None, ..) => one.names.first()?.clone(),
            // "A conic with the control points A, B, C and the weights 1, ω, 1"
            (None, _, Some(own), None)
                if own.interval.is_none()
                    && (!self.topics.has(Topic::Rational) || !own.weights.is_empty()) =>
            {
                let names = vec![Expr::name(format!("{UNNAMED}points"))];
                let (points, weights) = (own.names.clone(), own.weights.clone());
                *made =
                    Some(Object { names: names.clone(), points, weights, ..Object::new(Sort::BezierCurve) });
                names.into_iter().next()?
            }
            _ => return None,
        };
        let name = &name;
        let given =
            || self.numbers.iter().filter(|number| **number != claim).flat_map(|number| page.said(*number));
        let Kind::Apply(patch, _) = &name.kind else {
            let mut places: Vec<Expr> = Vec::new();
            for said in given() {
                let place = match &said.kind {
                    Kind::Chain(left, links) => match (&left.kind, links.as_slice()) {
                        (Kind::Name(name), [link]) if link.rel == Rel::Eq && is_variable(name) => &link.expr,
                        _ => continue,
                    },
                    Kind::Div(..) => said,
                    _ => continue,
                };
                if bases(place).is_empty() && !places.iter().any(|known| known.same_as(place)) {
                    places.push(place.clone());
                }
            }
            let [place] = <[Expr; 1]>::try_from(places).ok()?;
            return Some(Expr::apply(name.clone(), vec![place]));
        };
        let mut arguments: Vec<Expr> = Vec::new();
        for said in given() {
            match &said.kind {
                // u = v = w = 1/3; λ = 1/2, μ = ν = 1/4
                Kind::Chain(left, links) if links.iter().all(|link| link.rel == Rel::Eq) => {
                    let last = &links.last()?.expr;
                    let names = std::iter::once(left.as_ref())
                        .chain(links.iter().rev().skip(1).map(|link| &link.expr));
                    let names: Vec<&Expr> = names.collect();
                    let plain = names.iter().all(|name| matches!(name.kind, Kind::Name(_)));
                    if plain && bases(last).is_empty() && last.items().is_none() {
                        arguments.extend(names.iter().map(|_| last.clone()));
                    }
                }
                _ if said.items().is_some_and(|items| items.len() == 3) && bases(said).is_empty() => {
                    arguments.extend(said.items()?.iter().cloned());
                }
                _ => {}
            }
        }
        if arguments.is_empty() && self.speaks_of_the_centroid() {
            arguments = vec![Expr::number(&rational(1, 3)); 3];
        }
        (arguments.len() == 3).then(|| Expr::apply(patch.as_ref().clone(), arguments))
    }
}
