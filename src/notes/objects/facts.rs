//! Sentences that say something of what was spoken of before: "its weights are …", "N_2 has the knots …".

use std::collections::BTreeMap;

use super::super::sentence::Piece;
use super::Reader;
use super::attributes::listed;
use super::phrase::Phrase;
use super::subject::{ends, left_side, name_in};
use super::tokens::Token;
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::{Said, Statement};
use crate::judge::written::names::{Head, bases};
use crate::language::lexicon::families::{self, Family};
use crate::notes::speech::{self, Word};

impl Reader<'_> {
    /// "p interpolates (0, 1), (1, 3)": data of the function that was spoken of last. Gives the token after them.
    pub(super) fn interpolated(&mut self, at: usize) -> usize {
        let Some((data, end)) = self.data(at + 1) else { return at + 1 };
        let [name] = self.talk.topic.as_slice() else { return at + 1 };
        let function = |object: &&mut Object| {
            matches!(object.sort, Sort::Polynomial | Sort::SplineCurve)
                && object.points.is_empty()
                && object.names.iter().any(|known| known.same_as(name))
        };
        let known = self.found.values_mut().rev().flat_map(|list| list.iter_mut().rev()).find(function);
        if let Some(object) = known {
            object.data = data;
        }
        end
    }

    /// The token after the words for what numbers are: "the three points".
    pub(super) fn after_nouns(&self, at: usize) -> usize {
        let noun = |token: &Token| {
            matches!(
                token,
                Token::Word(
                    Word::Article | Word::Der | Word::Noun(Sort::Symbols | Sort::Nodes | Sort::ControlPoints)
                )
            ) || matches!(token, Token::Word(word) if word.is_filler())
        };
        (at..self.tokens.len()).find(|&next| !noun(&self.tokens[next])).unwrap_or(at)
    }

    /// The points (0, 1), (1, 3) from a token on, or the values 1, 3 at 0, 1, and the token after them.
    pub(super) fn data(&self, at: usize) -> Option<(Vec<(Expr, Expr)>, usize)> {
        let (items, end) = self.list(self.after_nouns(at));
        let pair = |item: &Expr| match item.items() {
            Some([x, y]) => Some((x.clone(), y.clone())),
            _ => None,
        };
        let pairs: Option<Vec<(Expr, Expr)>> = items.iter().map(pair).collect();
        if let Some(pairs) = pairs.filter(|pairs| pairs.len() > 1) {
            return Some((pairs, end));
        }
        let (values, nodes, end) = self.points_at_nodes(at)?;
        let dots = |items: &[Expr]| items.iter().any(|item| item.kind == Kind::Ellipsis);
        let one_by_one = values.len() == nodes.len() && values.len() > 1 && !dots(&values) && !dots(&nodes);
        one_by_one.then(|| (nodes.into_iter().zip(values).collect(), end))
    }

    /// "The points p_i, …, p_{i+r} at t_i, …, t_{i+r}", from a token on, and the token after them.
    pub(super) fn points_at_nodes(&self, at: usize) -> Option<(Vec<Expr>, Vec<Expr>, usize)> {
        let (values, end) = self.list(self.after_nouns(at));
        if !self.is(end, &Word::On) && !self.is(end, &Word::Preposition) {
            return None;
        }
        let (nodes, end) = self.list(self.after_nouns(end + 1));
        (values.len() > 1 && values.len() == nodes.len()).then_some((values, nodes, end))
    }

    /// The points that end before a token, after a word for "through", and where that stands.
    pub(super) fn data_before(&self, end: usize) -> Option<(usize, Vec<(Expr, Expr)>)> {
        let through = (0..end).rev().find(|&at| self.is(at, &Word::Through))?;
        let (data, after) = self.data(through + 1)?;
        (after == end).then_some((through, data))
    }

    /// "The weights are w_0 = 1, w_1 = 2": those of the curve that was spoken of last. Gives the token after them.
    pub(super) fn weights(&mut self, at: usize) -> usize {
        let mut start = at + 1;
        while self.is(start, &Word::Be) || self.skip_fillers(start) > start {
            start = self.skip_fillers(start) + usize::from(self.is(start, &Word::Be));
        }
        let (items, end) = self.list(start);
        let weights = listed(items);
        let weights = in_order(weights);
        let here = self.tokens.iter().find_map(|token| match token {
            Token::Formula(number) => self.places.get(number).map(|place| (place.group, &place.scope)),
            _ => None,
        });
        let Some((group, scope)) = here else { return at + 1 };
        // "The curve b(t) with b_0 = 0, b_1 = 2, b_2 = 0"
        let mut members: Vec<Expr> = Vec::new();
        for said in
            self.places.iter().filter(|(_, place)| place.group == group).flat_map(|(at, _)| self.said(*at))
        {
            let name = left_side(said);
            let next = Head::of(name).and_then(|head| head.index()?.as_int()) == Some(members.len() as i64);
            if next && members.first().is_none_or(|first| bases(first) == bases(name)) {
                members.push(name.clone());
            }
        }
        let fits = |object: &Object| {
            let points = match object.sort {
                Sort::ControlPoints => &object.names,
                _ => &object.points,
            };
            let dots = points.iter().any(|point| point.kind == Kind::Ellipsis);
            let unsaid = points.is_empty() && members.len() == weights.len();
            object.rational && points.is_empty() || unsaid || dots || points.len() == weights.len()
        };
        let curve = |object: &&mut Object| {
            object.weights.is_empty()
                && (object.rational
                    || matches!(object.sort, Sort::BezierCurve | Sort::ControlPoints)
                        && object.knots.is_empty())
        };
        // Those of all that its paragraph says of the curve; what is not understood of them is that it has some.
        let mut taken = false;
        for (number, objects) in self.found.iter_mut().rev() {
            let Some(place) = self.places.get(number) else { continue };
            let near = place.group == group;
            for object in objects.iter_mut().filter(curve) {
                if !weights.is_empty() && near && fits(object) {
                    object.weights.clone_from(&weights);
                    if object.sort == Sort::BezierCurve && object.points.is_empty() && !object.rational {
                        object.points.clone_from(&members);
                    }
                    taken = true;
                } else if place.scope == *scope && !taken && object.sort == Sort::BezierCurve {
                    object.rational = true;
                }
            }
        }
        if taken { end } else { at + 1 }
    }

    /// "N_{1,2} has the knots 0, 0, 1, 2", "M_p has degree p and the knots 0, …, p + 1": what a name has of which the
    /// sentences before spoke, or a member of its family. Gives the token after it.
    pub(super) fn has(&mut self, at: usize) -> usize {
        // "The second one, N_{1,2}, has …"
        let comma = at.checked_sub(1).is_some_and(|before| matches!(self.tokens[before], Token::Comma));
        let before = at.checked_sub(1 + usize::from(comma)).filter(|&before| before >= self.taken);
        let Some(number) = before.and_then(|before| self.formula_at(before)) else { return at + 1 };
        let [name] = self.said(number) else { return at + 1 };
        let Some(name) = name_in(name).filter(|name| name.kind != Kind::Ellipsis) else { return at + 1 };
        let Some(head) = Head::of(&name) else { return at + 1 };
        let alike = |other: &Expr| {
            Head::of(other).is_some_and(|other| {
                let indices = |head: &Head| head.lower.len() + head.upper.len();
                other.base == head.base && indices(&other) == indices(&head)
            })
        };
        let of_family = |object: &&Object| object.sort == Sort::BSpline && object.names.iter().any(alike);
        let family = || self.found.values().rev().flat_map(|list| list.iter().rev()).find(of_family).cloned();
        let standard = || {
            let notation = families::notation(&head.base, head.lower.len(), head.upper.len())?;
            (notation.family == Family::Spline).then(|| Object::new(Sort::BSpline))
        };
        let Some(known) = self.known(&name).or_else(family).or_else(standard) else { return at + 1 };
        let own = |object: &Object| (object.degree.clone(), object.knots.clone(), object.points.clone());
        let before = own(&known);
        // What the family has is not what its member has.
        let known = match known.names.iter().any(|other| other.same_as(&name)) {
            true => known,
            false => Object { names: vec![name], degree: None, knots: Vec::new(), ..known },
        };
        let mut phrase = Phrase::new(known, at);
        let mut end = at;
        while let Some(next) = self.attribute(end, &mut phrase) {
            end = next;
        }
        let mut object = phrase.object;
        if end == at || own(&object) == before || object.knots.is_empty() {
            return at + 1;
        }
        if object.sort == Sort::BSpline && object.degree.is_none() {
            object.degree = degree_of_knots(&object.knots);
        }
        self.taken = end;
        self.found.entry(number).or_default().push(object);
        end
    }

    /// "0 and 1 occur with multiplicity n + 1": the knots that are said so, those that were named since the last noun.
    pub(super) fn multiple(&mut self, at: usize) -> usize {
        let before =
            (0..at).rev().find(|&noun| matches!(self.tokens[noun], Token::Word(Word::Noun(Sort::Knots))));
        let (Some(noun), Some(times)) = (before, self.number_at(self.skip_fillers(at + 1))) else {
            return at + 1;
        };
        let named = (noun + 1..at).find(|&next| self.formula_at(next).is_some());
        let Some(first) = named else { return at + 1 };
        let (items, _) = self.list(first);
        let knot = |item: &Expr| {
            let all = vec![item.clone(), Kind::Ellipsis.into(), item.clone()];
            Expr::from(Kind::Brace(all, Some(Box::new(times.clone()))))
        };
        let numbers = items.len() > 1 && items.iter().all(|item| bases(item).is_empty());
        if let (true, Some(number)) = (numbers, self.formula_at(first)) {
            let names = items.iter().map(knot).collect();
            self.found.entry(number).or_default().push(Object { names, ..Object::new(Sort::Knots) });
        }
        at + 1
    }

    /// The knots that the paragraph of a formula listed last as numbers.
    pub(super) fn knots_before(&self, formula: usize) -> Vec<Expr> {
        let near = self.said_near(formula, |here, there| here.group == there.group);
        let last = near.into_iter().find(|object| object.sort == Sort::Knots);
        let given = |item: &Expr| match &item.kind {
            Kind::Brace(items, _) => items.first().is_some_and(|first| bases(first).is_empty()),
            Kind::Ellipsis => false,
            _ => bases(item).is_empty(),
        };
        let names = last.map(|object| object.names.as_slice()).unwrap_or_default();
        // T = (0, 0, 1, 2, 2), by its name
        let defined = |name: &Expr| {
            self.formulas.range(..=formula).rev().flat_map(|(_, said)| said).find_map(|said| {
                match &said.kind {
                    Kind::Chain(left, links) if left.same_as(name) => links[0].expr.elements(),
                    _ => None,
                }
            })
        };
        let items = match names {
            [only] => only.elements().or_else(|| defined(only)).unwrap_or(names),
            _ => names,
        };
        if items.len() > 1 && items.iter().all(given) { items.to_vec() } else { Vec::new() }
    }

    /// "N_{i,3} has the support [u_i, u_{i+4}]": a B-spline over these knots. Gives the token after it.
    pub(super) fn support_of(&mut self, at: usize) -> usize {
        let joins = |token: &Token| {
            matches!(
                token,
                Token::Stop
                    | Token::Word(
                        Word::Filler
                            | Word::The
                            | Word::Same
                            | Word::Article
                            | Word::Der
                            | Word::Be
                            | Word::With
                            | Word::On
                            | Word::Of
                            | Word::Its
                            | Word::Owns
                    )
            )
        };
        let before = (self.taken..at).rev().find(|&other| !joins(&self.tokens[other]));
        let after = (at + 1..self.tokens.len()).find(|&other| !joins(&self.tokens[other]));
        let next = |from: usize| (from + 1..self.tokens.len()).find(|&other| !joins(&self.tokens[other]));
        let numbers = |at: Option<usize>| at.and_then(|at| self.formula_at(at));
        let interval = |number: usize| ends(self.said(number));
        // "The support of N_i is …" or "N_i has the support …"
        let (name, set, end) = match (numbers(before), numbers(after)) {
            (_, Some(name)) if interval(name).is_none() => {
                let set = after.and_then(next);
                (Some(name), numbers(set), set)
            }
            (name, set) => (name, set, after),
        };
        let (Some(name), Some(set), Some(end)) = (name, set, end) else { return at + 1 };
        let member = |expr: &Expr| Head::of(expr).is_some_and(|head| !head.lower.is_empty());
        let names: Vec<Expr> = self.said(name).iter().filter_map(name_in).filter(member).collect();
        let Some((from, to)) = interval(set).filter(|_| names.len() == 1) else { return at + 1 };
        let knots = vec![from, Kind::Ellipsis.into(), to];
        // "The basis function that belongs to d_i has the support …": so are the control points numbered.
        let letter = names.first().and_then(Head::of).map(|head| head.base);
        let of_points = |object: &&Object| {
            let own = object.points.first().and_then(Head::of).map(|head| head.base);
            object.sort == Sort::SplineCurve && own.is_some() && own == letter
        };
        let curve = self.found.values().rev().flat_map(|list| list.iter().rev()).find(of_points).cloned();
        let object = match curve {
            Some(curve) => Object { knots, ..curve },
            None => {
                let degree = degree_of_knots(&knots);
                Object { names, degree, knots, ..Object::new(Sort::BSpline) }
            }
        };
        self.taken = end + 1;
        self.found.entry(name).or_default().push(object);
        end + 1
    }
}

/// Members of one family in the order of their numbers: w_0, w_2, w_1 are three weights.
pub(super) fn in_order(mut names: Vec<Expr>) -> Vec<Expr> {
    let member = |name: &Expr| {
        let head = Head::of(name)?;
        Some((head.base.clone(), head.index()?.as_int()?))
    };
    let members: Option<Vec<(String, i64)>> = names.iter().map(member).collect();
    if members.is_some_and(|all| all.windows(2).all(|pair| pair[0].0 == pair[1].0)) {
        names.sort_by_key(|name| member(name).map(|(_, number)| number));
    }
    names
}

/// The degree of a B-spline over some knots: two less than there are.
pub(super) fn degree_of_knots(knots: &[Expr]) -> Option<Expr> {
    let index = |end: &Expr| match Head::of(end).filter(|head| head.index().is_some()) {
        Some(head) => head.index().cloned(),
        None => Some(end.clone()),
    };
    match knots {
        [first, .., last] if knots.iter().any(|knot| knot.kind == Kind::Ellipsis) => {
            let length = Kind::Add(vec![
                Term { sign: Sign::Plus, expr: index(last)? },
                Term { sign: Sign::Minus, expr: index(first)?.grouped() },
            ]);
            Some(Expr::from(length).grouped().plus(-1))
        }
        [_, _, ..] if knots.iter().all(|knot| !matches!(knot.kind, Kind::Brace(..))) => {
            Some(Expr::int(knots.len() as i64 - 2))
        }
        _ => None,
    }
}

/// (ρ_j, z_j): the coordinates of one point of many, no two points.
pub(super) fn are_coordinates(items: &[Expr]) -> bool {
    let index = |item: &Expr| {
        let head = Head::of(item).filter(|head| head.arguments.is_none())?;
        match head.lower.as_slice() {
            [Expr { kind: Kind::Name(index), .. }] => Some((head.base, index.clone())),
            _ => None,
        }
    };
    let all: Option<Vec<(String, String)>> = items.iter().map(index).collect();
    all.is_some_and(|all| {
        all.len() > 1 && all.windows(2).all(|two| two[0].1 == two[1].1 && two[0].0 != two[1].0)
    })
}

/// The points of several curves, each with its own: b_0, …, b_3 and c_0, …, c_3; 0, 1, 3 and 1, 2, 0.
pub(super) fn shared_out(points: &[Expr], count: usize) -> Vec<Vec<Expr>> {
    let each = points.len() / count.max(1);
    let numbers = points.iter().all(|point| bases(point).is_empty());
    match numbers && count > 1 && each > 1 && each * count == points.len() {
        true => points.chunks(each).map(<[Expr]>::to_vec).collect(),
        false => families(points),
    }
}

/// A list taken apart where another family begins: b_0, …, b_3 and c_0, …, c_3.
pub(super) fn families(items: &[Expr]) -> Vec<Vec<Expr>> {
    let mut found: Vec<(String, Vec<Expr>)> = Vec::new();
    for item in items {
        let base = Head::of(item).map(|head| head.base);
        match (found.last_mut(), base) {
            (Some((_, list)), None) => list.push(item.clone()),
            (Some((known, list)), Some(base)) if *known == base => list.push(item.clone()),
            (_, Some(base)) => found.push((base, vec![item.clone()])),
            (None, None) => {}
        }
    }
    found.into_iter().map(|(_, list)| list).collect()
}

/// "x''(0) = 6 (b_2 - 2b_1 + b_0), where x has the points b_0, …, b_3": what is said after a claim of what it speaks of
/// is said for it.
pub(super) fn told_before(
    sentence: &[Piece],
    statements: &[Statement],
    found: &mut BTreeMap<usize, Vec<Object>>,
) {
    let claims = |number: &usize| {
        statements.iter().any(|statement| {
            statement.place.formula == *number
                && matches!(&statement.said, Said::Chain(chain) if chain.relations[0].0 == Rel::Eq)
        })
    };
    let mut claim = None;
    let mut after = false;
    for piece in sentence {
        match piece {
            Piece::Words(words) => after |= claim.is_some() && speech::explains(words),
            Piece::Formula(number) if after => {
                let (Some(claim), Some(objects)) = (claim, found.remove(number)) else { continue };
                found.entry(claim).or_default().extend(objects);
            }
            Piece::Formula(number) => claim = claim.or(Some(*number).filter(claims)),
        }
    }
}
