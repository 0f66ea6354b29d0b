//! Sizes that data tell: where the page gives x_0, x_1, x_2 and no more, the n of Σ_{i=0}^n x_i is 2.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind};
use crate::judge::page::context::{Body, Context, Definition};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::Place;
use crate::judge::written::names::{Head, bases, walk};

impl Context {
    /// The value of a size in a formula whose sums run up to it over members that the place gives by number, all of them.
    pub fn size_in_data(&self, size: &str, formula: &Expr, place: &Place) -> Option<i64> {
        let mut found = BTreeSet::new();
        walk(formula, &mut |part| {
            let Kind::Big { lower, upper: Some(upper), body, .. } = &part.kind else { return };
            let own = matches!(&upper.kind, Kind::Name(name) if name == size);
            let index = lower.first().and_then(|first| match &first.kind {
                Kind::Chain(left, _) => match &left.kind {
                    Kind::Name(index) => Some(index),
                    _ => None,
                },
                _ => None,
            });
            let Some(index) = index.filter(|_| own) else { return };
            walk(body, &mut |inner| {
                let Some(head) = Head::of(inner) else { return };
                let plain = head.upper.is_empty() && head.arguments.is_none();
                let runs = |lower: &Expr| matches!(&lower.kind, Kind::Name(name) if name == index);
                if let (true, Some(at)) = (plain, head.lower.iter().position(runs)) {
                    let given = self.given_from_to(&head.base, head.lower.len(), at, place);
                    found.extend(given.map(|[_, last]| last));
                }
            });
        });
        if found.len() == 1 { found.first().copied() } else { None }
    }

    /// The degree of a curve with the points b_0, b_1, …, of which the place gives all: 3, where it gives b_0, …, b_3.
    pub fn degree_in_data(&self, object: &Object, place: &Place) -> Option<usize> {
        let names = object.points.iter().filter(|point| point.kind != Kind::Ellipsis);
        let heads: Vec<Head> = names.map(Head::of).collect::<Option<_>>()?;
        let letter = &heads.first().filter(|_| object.sort != Sort::SplineCurve)?.base;
        let plain = |head: &Head| head.base == *letter && head.index().is_some() && head.upper.is_empty();
        let ends = heads.iter().all(plain).then(|| self.given_from_to(letter, 1, 0, place))?;
        usize::try_from(ends?[1]).ok()
    }

    /// The least and the largest index, in one place of several, of the members of a letter that the place gives, if it
    /// gives all between them and the least is 0 or 1.
    pub fn given_from_to(&self, letter: &str, count: usize, at: usize, place: &Place) -> Option<[i64; 2]> {
        let given = |definition: &Definition| -> Option<Vec<i64>> {
            let head = &definition.head;
            let constant = match &definition.body {
                Body::Formula(body) => bases(body).is_empty(),
                Body::Value(_) => true,
            };
            let member = head.upper.is_empty() && head.arguments.is_none() && head.lower.len() == count;
            let indices = head.lower.iter().map(Expr::as_int).collect::<Option<Vec<i64>>>();
            indices.filter(|_| member && constant)
        };
        let near = self.visible(letter, place).filter(|(_, _, near)| *near);
        let mut members = near.filter_map(|(_, definition, _)| Some((definition, given(definition)?)));
        let (latest, first) = members.next()?;
        let beside = |other: &Place| other.scope == latest.place.scope && other.blocks == latest.place.blocks;
        let rest = members.filter(|(definition, _)| beside(&definition.place)).map(|(_, indices)| indices);
        let all: BTreeSet<Vec<i64>> = rest.chain([first]).collect();
        let span = |at: usize| {
            let least = all.iter().map(|indices| indices[at]).min().filter(|least| (0..2).contains(least))?;
            Some((least, all.iter().map(|indices| indices[at]).max()?))
        };
        let spans: Vec<(i64, i64)> = (0..count).map(span).collect::<Option<_>>()?;
        let size: i64 = spans.iter().map(|(least, most)| most - least + 1).product();
        (all.len() > 1 && size == all.len() as i64).then(|| spans[at].into())
    }
}
