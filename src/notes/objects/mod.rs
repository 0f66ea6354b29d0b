//! What sentences say in words that names stand for: "let f be the polar form of F".
//!
//! **Definition.** A *noun phrase* is a noun of the field with what belongs to it: adjectives before it, and after
//! it its names, its degree, what it belongs to, its knots, its control points. Its *subject*, the names that it
//! speaks of, follows it at once ("the polar form f of F"), or stands before it ("let f be the polar form of F",
//! "f its polar form"), or after "by". What a phrase is, in four languages, is data of `speech`.

mod account;
mod attributes;
mod contact;
mod coreference;
mod facts;
mod owners;
mod page;
mod patches;
mod phrase;
mod pieces;
mod quantities;
mod subject;
mod tables;
#[cfg(test)]
mod tests;
mod tokens;
mod unnamed;

use std::collections::{BTreeMap, BTreeSet};

use self::attributes::is_call;
use self::coreference::Talk;
use self::facts::{are_coordinates, in_order, shared_out, told_before};
use self::page::{Page, by_members, formulas, sections};
use self::phrase::Phrase;
use self::subject::{is_made_of_functions, left_side, name_in, named};
use self::tables::Row;
use self::tokens::{Token, tokens, without_smoothness};
use super::sentence::Piece;
use super::speech::Word;
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, RATIONAL, Sort};
use crate::judge::page::statement::{Place, Said, Statement};
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::lexicon::roles::is_variable;

/// Puts a statement about each object before the first formula that speaks of it.
///
/// Cost: linear in the words, times the number of phrases.
pub fn insert(sentences: &[Vec<Piece>], statements: &mut Vec<Statement>) {
    let formulas = formulas(statements);
    let apart = by_members(&formulas);
    let places =
        statements.iter().map(|statement| (statement.place.formula, statement.place.clone())).collect();
    let mut found: BTreeMap<usize, Vec<Object>> = BTreeMap::new();
    let mut talk = Talk::default();
    let mut rows: Vec<Row> = Vec::new();
    let mut table = Vec::new();
    for (count, sentence) in sentences.iter().enumerate() {
        let cells = tables::cells(sentence, &formulas);
        match cells.as_ref().and_then(|cells| tables::row(cells)) {
            Some(row) => rows.push(row),
            None => rows.clear(),
        }
        match cells {
            Some(cells) => table.push(cells),
            None => {
                tables::put(tables::data(&std::mem::take(&mut table), &formulas), &talk.topic, &mut found)
            }
        }
        let above = count.checked_sub(1).map(|before| sentences[before].as_slice());
        for (name, value) in above.map(|above| tables::values(above, sentence, &formulas)).unwrap_or_default()
        {
            let number = contact::numbers(sentence).first().copied();
            let own = Object { names: vec![name], values: vec![value], ..Object::new(Sort::Symbols) };
            found.entry(number.unwrap_or_default()).or_default().push(own);
        }
        if let [xs, ys] = rows.as_slice() {
            tables::tell(xs, ys, &talk.topic, &mut found);
        }
        let tokens = without_smoothness(tokens(sentence), &formulas);
        let mut reader = Reader {
            tokens,
            formulas: &apart,
            places: &places,
            talk,
            count,
            listed: Vec::new(),
            taken: 0,
            found: &mut found,
        };
        reader.read();
        talk = reader.talk;
    }
    tables::put(tables::data(&table, &formulas), &talk.topic, &mut found);
    for sentence in sentences {
        told_before(sentence, statements, &mut found);
    }
    let page = Page { formulas: &formulas, places: &places };
    owners::tell(&page, &mut found);
    account::tell(sentences, &page, &mut found);
    let sections = sections(sentences, &page);
    patches::tell(&sections, &page, &mut found);
    quantities::tell(&sections, &page, &mut found);
    unnamed::tell(&sections, &page, &mut found);
    // "A rational curve" of which no weights are given, rational basis functions
    let other = |object: &&mut Object| {
        object.rational
            && (object.weights.is_empty() || matches!(object.sort, Sort::Bernstein | Sort::BSpline))
    };
    for object in found.values_mut().flatten().filter(other) {
        object.sort = Sort::Other(RATIONAL.into());
    }
    for object in found.values_mut().flatten().filter(|object| are_coordinates(&object.points)) {
        object.points.clear();
    }
    let mut all = Vec::with_capacity(statements.len() + found.len());
    let mut contacts = contact::contacts(sentences, &formulas);
    for statement in statements.drain(..) {
        for contact in contacts.remove(&statement.place.formula).unwrap_or_default() {
            all.push(Statement::new(Said::Contact(contact), statement.place.clone()));
        }
        for object in found.remove(&statement.place.formula).unwrap_or_default() {
            let said = Said::Object(Box::new(object));
            all.push(Statement::new(said, statement.place.clone()));
        }
        all.push(statement);
    }
    *statements = all;
}

struct Reader<'a> {
    tokens: Vec<Token>,
    formulas: &'a BTreeMap<usize, Vec<Expr>>,
    /// Where the formulas stand.
    places: &'a BTreeMap<usize, Place>,
    /// What was spoken of.
    talk: Talk,
    /// The number of the sentence.
    count: usize,
    /// The families whose names were listed: x_0, …, x_n.
    listed: Vec<Vec<Expr>>,
    /// The tokens before this one belong to noun phrases already.
    taken: usize,
    found: &'a mut BTreeMap<usize, Vec<Object>>,
}

impl<'a> Reader<'a> {
    fn said(&self, number: usize) -> &'a [Expr] {
        self.formulas.get(&number).map_or(&[], Vec::as_slice)
    }

    fn read(&mut self) {
        for at in 0..self.tokens.len() {
            self.size(at);
        }
        self.read_phrases();
        self.talk.interval = self.interval_in(self.tokens.len()).or(self.talk.interval.take());
    }

    fn read_phrases(&mut self) {
        let mut at = 0;
        while at < self.tokens.len() {
            match &self.tokens[at] {
                // "a real polynomial"
                Token::Word(Word::Noun(Sort::Symbols | Sort::Vectors))
                    if matches!(self.tokens.get(at + 1), Some(Token::Word(Word::Noun(_)))) =>
                {
                    at += 1;
                }
                Token::Word(Word::Noun(sort)) => {
                    let phrase = self.phrase(at, sort.clone());
                    at = phrase.to.max(at + 1);
                    self.take(phrase);
                }
                // A cubic, g is affine: an adjective without a noun.
                Token::Word(Word::OfDegree(degree))
                    if !self.leads_to_noun(at)
                        && (*degree > 1 && self.follows_article(at)
                            || at > 1 && self.is(at - 1, &Word::Be) && self.formula_at(at - 2).is_some()) =>
                {
                    let phrase = self.phrase(at, Sort::Polynomial);
                    at = phrase.to.max(at + 1);
                    self.take(phrase);
                }
                Token::Formula(number) => {
                    let items = self.said(*number);
                    let member = |item: &Expr| matches!(item.kind, Kind::Subscript(..) | Kind::Ellipsis);
                    if items.len() > 1 && items.iter().all(member) {
                        self.listed.push(items.to_vec());
                    }
                    // "F and f(s, t) its polar form": its is that of F.
                    let next = (at + 1..self.tokens.len())
                        .find(|&next| !self.is(next, &Word::Be) && !self.is(next, &Word::Filler));
                    let own = next.is_some_and(|next| self.is(next, &Word::Its));
                    // H = F + G and its polar form
                    if let (Some(Expr { kind: Kind::Chain(left, links), .. }), false) = (items.first(), own)
                        && matches!(left.kind, Kind::Name(_))
                        && matches!(links.as_slice(), [link] if is_made_of_functions(&link.expr))
                    {
                        self.talk.of(vec![left.as_ref().clone()]);
                    }
                    if let (Some(first), false) = (self.said(*number).first(), own) {
                        let beside = at > 1
                            && matches!(self.tokens[at - 1], Token::Comma | Token::Word(Word::And))
                            && matches!(self.tokens[at - 2], Token::Formula(_));
                        self.speak_of(left_side(first), beside);
                    }
                    at += 1;
                }
                Token::Word(Word::Let) => {
                    self.unknown_sort(at);
                    at += 1;
                }
                Token::Word(Word::Support) => at = self.support_of(at),
                Token::Word(Word::Weights) => at = self.weights(at),
                Token::Word(Word::With) => at = self.has(at),
                Token::Word(Word::Multiplicity) => at = self.multiple(at),
                Token::Word(Word::Through) => at = self.interpolated(at),
                // "p_0, …, p_3 the Bézier points over [0, c], and q_0, …, q_3 those over [c, 1]"
                Token::Word(Word::Those) if self.talk.points.is_some() => {
                    let mut phrase = self.phrase(at, Sort::ControlPoints);
                    if phrase.object.interval.is_none()
                        && let Some(interval) = self.interval_at(at + 1)
                    {
                        phrase.object.interval = Some(interval);
                        phrase.to = at + 2;
                    }
                    phrase.of.extend(self.talk.points.clone());
                    at = phrase.to.max(at + 1);
                    if phrase.object.interval.is_some() {
                        self.take(phrase);
                    }
                }
                Token::Word(Word::It | Word::Piece) => at = self.named_anew(at),
                _ => at += 1,
            }
        }
    }

    /// "its" refers to the function that was spoken of last, not to a member of a family nor to a value.
    fn speak_of(&mut self, call: &Expr, beside: bool) {
        // "The derivative F' is … Its blossom"
        let value = matches!(&call.kind, Kind::Apply(_, groups) if !groups.iter().flatten().all(|own| matches!(own.kind, Kind::Name(_))));
        if let Kind::Prime(function, _) = &named(call).kind
            && !value
            && matches!(function.kind, Kind::Name(_))
        {
            self.talk.of(vec![named(call)]);
            return;
        }
        let Some(head) = Head::of(call) else { return };
        let plain = |argument: &&Expr| matches!(argument.kind, Kind::Name(_));
        // F(c) = G(c) is still about both.
        let variable = |argument: &&Expr| matches!(&argument.kind, Kind::Name(name) if is_variable(name));
        let topic = &self.talk.topic;
        if topic.len() > 1
            && topic.iter().any(|one| one.same_as(&named(call)))
            && !head.flat().iter().all(variable)
        {
            return;
        }
        if head.arguments.is_some() && head.lower.is_empty() && head.upper.is_empty() {
            let own = matches!(self.talk.topic.as_slice(), [one] if one.same_as(&named(call)));
            // P(t) = … and Q(t) = … with the polar forms p and q
            if !beside {
                self.talk.of(Vec::new());
            }
            match head.flat().iter().all(plain) {
                true => self.talk.topic.push(named(call)),
                // p(0) = 1 is still about p.
                false if own => self.talk.topic.push(named(call)),
                false => self.talk.of(Vec::new()),
            }
        }
    }

    /// What was said before of objects whose places fit that of a formula, the latest first.
    fn said_near(&self, number: usize, fits: impl Fn(&Place, &Place) -> bool) -> Vec<&Object> {
        let Some(here) = self.places.get(&number) else { return Vec::new() };
        let near = |other: &usize| self.places.get(other).is_some_and(|there| fits(here, there));
        let lists = self.found.iter().rev().filter(|(other, _)| near(other));
        lists.flat_map(|(_, list)| list.iter().rev()).collect()
    }

    fn follows_article(&self, at: usize) -> bool {
        let article = |word: &Word| {
            matches!(word, Word::Article | Word::Filler | Word::The | Word::Same | Word::Der | Word::Its)
        };
        // "a closed cubic": an adjective that is not known may stand between.
        let adjective = |token: &Token| matches!(token, Token::Unknown(word) if !word.contains(' '));
        let steps = 1 + usize::from(self.tokens[..at].last().is_some_and(adjective));
        let before = at.checked_sub(steps).map(|before| &self.tokens[before]);
        before.is_some_and(|before| matches!(before, Token::Word(word) if article(word)))
    }

    fn take(&mut self, phrase: Phrase) {
        let Phrase { mut object, mut of, intervals, piece, anonymous, from, to, named, inner, .. } = phrase;
        let Phrase { same, definite, of_known, owner, new, .. } = phrase;
        // The middle piece of the B-spline N whose knots are 0, 1, 3, 4: N is all of it.
        let whole = object.sort == Sort::BSpline && !object.knots.is_empty();
        if piece && !whole && matches!(object.sort, Sort::BSpline | Sort::SplineCurve) {
            object.sort = Sort::SplineCurve;
            object.interval.get_or_insert_with(|| (Expr::int(0), Expr::int(1)));
        }
        // "Regarded as a polynomial of degree 3"
        if object.names.is_empty() && object.is_function() && from > 0 && self.is(from - 1, &Word::As) {
            self.view(from, object.degree);
            return;
        }
        if let Some((names, number, other)) = self.made_of(&object, from) {
            self.found
                .entry(number)
                .or_default()
                .push(Object { names, ..Object::new(Sort::Other(other.into())) });
            self.taken = to;
            return;
        }
        let subject = match named {
            Some(number) if !object.names.is_empty() => Some((object.names.clone(), number)),
            // "Its polar form is h = f + g" speaks of h.
            _ if self.is(from, &Word::Its) && self.subject_after(to).is_some() => self.subject_after(to),
            _ => self
                .subjects_before(from, matches!(object.sort, Sort::Symbols | Sort::Vectors))
                .or_else(|| self.subject_after(to))
                .or_else(|| self.subject_after(self.after_intervals(to)?))
                .or_else(|| self.subject_of_notation(from))
                .or_else(|| self.subject_of_clause(from)),
        };
        // "By f(u, v) we denote its polar form": its is not that of f.
        if let (Sort::PolarForm, Some((names, _)), [own], [before]) =
            (&object.sort, &subject, of.as_slice(), self.talk.before.as_slice())
            && matches!(names.as_slice(), [name] if subject::named(name).same_as(own))
            && !own.same_as(before)
        {
            of = vec![before.clone()];
        }
        inner.into_iter().for_each(|phrase| self.take(phrase));
        // "The curve with the control points (1, 0), (1, 1), (0, 1) is x(t) = …, y(t) = …": its coordinates
        let plane = object.points.iter().any(|point| point.items().is_some());
        let function = |said: &Expr| matches!(left_side(said).kind, Kind::Apply(..));
        let subject = subject.filter(|(_, number)| {
            let said = self.said(*number);
            !(plane && said.len() > 1 && said.iter().take(2).all(function))
        });
        // The control points of p are 1, 2, 4; p has the control points 1, 2, 4
        if object.sort == Sort::ControlPoints && object.names.is_empty() && !object.values.is_empty() {
            // "Its derivative has the control points 3, 3, 6", "the points 0, 1, 2 give a line": those of another curve
            let subject = from.checked_sub(2).map(|before| &self.tokens[before]);
            let of_other = self.is(from - usize::from(from > 0), &Word::With)
                && matches!(subject, Some(Token::Unknown(_) | Token::Word(Word::Piece)));
            let given = |name: &Expr| self.known(name).is_some_and(|known| !known.points.is_empty());
            if of_other || of.is_empty() && self.talk.topic.iter().any(given) {
                self.taken = to;
                let number = (from..to).find_map(|at| self.formula_at(at));
                let other = Object { points: object.values, ..Object::new(Sort::ControlPoints) };
                self.found.entry(number.unwrap_or_default()).or_default().push(other);
                return;
            }
            let names = match (of.as_slice(), self.talk.topic.as_slice()) {
                ([one], _) => vec![one.clone()],
                ([], [one]) if !anonymous => vec![one.clone()],
                _ => Vec::new(),
            };
            let number = (from..to).find_map(|at| self.formula_at(at));
            let degree = Some(Expr::int(object.values.len() as i64 - 1));
            let points = std::mem::take(&mut object.values);
            let spline = names.first().and_then(|name| self.known(name));
            let object = match spline.filter(|known| known.sort == Sort::SplineCurve) {
                Some(known) => Object { points, ..known },
                None => Object { names, degree, points, sort: Sort::BezierCurve, ..object },
            };
            if let Some(number) = number {
                self.taken = to;
                self.found.entry(number).or_default().push(object);
            }
            return;
        }
        // "The Bézier points of p over [a, b]: b_0 = …"
        let stop = matches!(self.tokens.get(to), Some(Token::Stop));
        let subject = subject.or_else(|| {
            let number = self.formula_at(to + 1).filter(|_| stop && object.sort == Sort::ControlPoints)?;
            let [first @ Expr { kind: Kind::Chain(..), .. }, ..] = self.said(number) else { return None };
            let names = self.siblings(&name_in(first)?, number, false);
            (names.len() > 1 && !of.is_empty()).then_some((names, number))
        });
        let Some((names, number)) = subject else {
            self.take_unnamed(object, intervals, same, new, from, to);
            return;
        };
        // "The curve is x(t) = …": the curve without a name that was spoken of
        if (same || definite)
            && matches!(object.sort, Sort::Function | Sort::BezierCurve | Sort::SplineCurve)
            && object.points.is_empty()
            && let [name] = names.as_slice()
            && self.name_unnamed(name, number)
        {
            self.taken = to;
            return;
        }
        // "Its control points are a_0 = 1, a_1 = 0, …": all that the formula gives
        let names = match (&object.sort, names.as_slice()) {
            (Sort::ControlPoints, [only]) => {
                let spline = |of: &Expr| {
                    let known = self.known(of);
                    known.is_some_and(|known| known.sort == Sort::SplineCurve && known.points.is_empty())
                };
                let row = !of.is_empty() && (!self.is(from, &Word::Its) || of.iter().all(spline));
                self.siblings(only, number, row)
            }
            _ => names,
        };
        let points = object.sort == Sort::ControlPoints;
        // "The control points are f(0, 1), f(1, 1)": values, no names.
        if !object.is_function() && self.said(number).iter().any(is_call) || points && self.has_a_part(from) {
            return;
        }
        // "Let N be the B-spline of degree 3: its knots are …"; "p is a Bézier curve. Its control points are …", or "the
        // control points are …"
        let owned_by = match (of.as_slice(), self.talk.topic.as_slice()) {
            ([owner], _) => Some(owner),
            ([], [owner]) if definite && !anonymous && !self.talk.is_unnamed() => {
                let lacks = |known: &Object| match object.sort {
                    Sort::Knots => known.sort == Sort::SplineCurve && known.knots.is_empty(),
                    _ => points,
                };
                Some(owner).filter(|owner| self.known(owner).as_ref().is_some_and(lacks))
            }
            _ => None,
        };
        if matches!(object.sort, Sort::Knots | Sort::ControlPoints)
            && let Some(mut known) = owned_by.and_then(|owner| self.known(owner))
        {
            let curve = match known.sort {
                Sort::BezierCurve => true,
                Sort::SplineCurve => known.interval.is_none(),
                _ => false,
            };
            let (list, free) = match object.sort {
                Sort::Knots => (&mut known.knots, true),
                _ => (&mut known.points, curve),
            };
            if free && (list.is_empty() || object.sort == Sort::Knots) {
                *list = match names.as_slice() {
                    [only] => only.elements().map_or_else(|| names.clone(), <[Expr]>::to_vec),
                    _ => names.clone(),
                };
                self.taken = to;
                self.found.entry(number).or_default().push(known);
                return;
            }
        }
        let whole = |expr: &Expr| expr.kind != Kind::Ellipsis && name_in(expr).is_none();
        if names.iter().any(whole) && !matches!(object.sort, Sort::Knots | Sort::Nodes) {
            return;
        }
        // "The left half has the control points …": a half of what is said before has others.
        let owned = from.checked_sub(1).is_some_and(|before| {
            let other = before.checked_sub(1).map(|owner| &self.tokens[owner]);
            self.is(before, &Word::With) && !matches!(other, Some(Token::Unknown(_)))
        });
        // "δ is the vector b - a"
        if object.sort == Sort::Vectors
            && names.len() == 1
            && let Some([value]) = self.formula_at(to).map(|number| self.said(number))
            && matches!(value.kind, Kind::Add(_) | Kind::Number(_))
        {
            object.values = vec![value.clone()];
        }
        let takes = object.sort == Sort::PolarForm || points && (owned || of_known);
        if self.of_pieces(&object, &names, &of, number) {
            self.taken = to;
            return;
        }
        // "A function that is affine …. Let f be a polar form": of another one
        let other =
            new && !of_known && self.talk.is_unnamed() && !(from > 0 && self.is(from - 1, &Word::With));
        if takes && of.is_empty() && !anonymous && !other {
            if object.sort == Sort::PolarForm
                && names.len() != self.talk.topic.len()
                && !self.talk.topic.is_empty()
            {
                return;
            }
            of.extend(self.talk.topic.iter().cloned());
        }
        // "Let d_0, …, d_3 be the de Boor points": those of the curve without a name that was spoken of
        if points && definite && of.is_empty() && !anonymous && self.gives_points(&names, number) {
            self.taken = to;
            return;
        }
        if object.sort == Sort::PolarForm || points {
            if let Some((sentence, degree)) = &self.talk.viewed
                && object.degree.is_none()
                && (*sentence == self.count || self.is(from, &Word::Its))
            {
                object.degree = Some(degree.clone());
            }
            // On intervals of which nothing more is understood
            let rest = (to..self.tokens.len()).find(|&at| self.interval_at(at).is_some());
            if points && object.interval.is_none() && rest.is_some() {
                return;
            }
            if let [owner] = of.as_slice()
                && object.interval.is_none()
            {
                let owner = owner.clone();
                if !self.of_piece(&mut object, &names, &owner, from, number) {
                    return;
                }
            }
            self.introduce(&of, number);
        }
        // "the Lagrange polynomials", right after their nodes
        let other = |items: &[Expr]| match (items.first(), names.first()) {
            (Some(a), Some(b)) => Head::of(a).map(|a| a.base) != Head::of(b).map(|b| b.base),
            _ => false,
        };
        if object.sort == Sort::Lagrange
            && object.knots.is_empty()
            && let Some(nodes) = self.listed.iter().rfind(|items| other(items))
        {
            object.knots = nodes.clone();
        }
        if object.sort == Sort::Lagrange && object.knots.is_empty() {
            let nodes = self.said_near(number, |here, there| here.knows(there, false));
            let listed = |known: &&Object| {
                matches!(known.sort, Sort::Nodes | Sort::Knots)
                    && known.names.first().is_some_and(|_| other(&known.names))
            };
            object.knots =
                nodes.into_iter().find(listed).map(|known| known.names.clone()).unwrap_or_default();
        }
        if matches!(object.sort, Sort::BSpline | Sort::SplineCurve)
            && object.knots.is_empty()
            && !object.uniform
        {
            object.knots = self.knots_before(number);
        }
        // "The function N is the B-spline …" goes on to say which one.
        let goes_on = matches!(self.tokens.get(to), Some(Token::Word(Word::Be | Word::Let)));
        if object.sort != Sort::Function || !goes_on {
            self.taken = to;
        }
        let function = object.is_function() && object.sort != Sort::PolarForm;
        let names: Vec<Expr> =
            names.iter().map(|name| name_in(name).unwrap_or_else(|| name.clone())).collect();
        if function {
            self.talk.of(names.clone());
        }
        // "On this interval s is a polynomial"
        let known =
            || names.iter().all(|name| self.known(name).is_some_and(|known| known.sort == Sort::SplineCurve));
        if object.sort == Sort::Polynomial && object.degree.is_none() && known() {
            return;
        }
        // The monomial t^k is a polynomial: no name, as N_i^k is.
        let power =
            |name: &Expr| matches!(&name.kind, Kind::Pow(base, _) if matches!(base.kind, Kind::Name(_)));
        let family = matches!(object.sort, Sort::BSpline | Sort::Bernstein | Sort::Lagrange);
        if function && !family && names.iter().all(power) {
            return;
        }
        // p and q, curves with the control points p_0, …, p_3 and q_0, …, q_3
        let lists = shared_out(&object.points, names.len());
        if names.len() > 1 && lists.is_empty() && !object.points.is_empty() {
            return;
        }
        if names.len() > 1 && lists.len() == names.len() {
            for (at, (name, points)) in names.into_iter().zip(lists).enumerate() {
                let interval = intervals.get(at).cloned().or(object.interval.clone());
                let own = Object { names: vec![name], points, interval, ..object.clone() };
                self.found.entry(number).or_default().push(own);
            }
            return;
        }
        // The polar forms f and g of F and G
        if of.len() > 1 && of.len() == names.len() {
            for (name, of) in names.into_iter().zip(of) {
                let own = Object { names: vec![name], of: Some(of), ..object.clone() };
                self.found.entry(number).or_default().push(own);
            }
            return;
        }
        // "f and g, their blossoms": no two are of one; the letters tell which is whose.
        let several = object.sort == Sort::PolarForm
            && matches!(names.as_slice(), [first, .., last] if bases(first) != bases(last));
        object.names = names;
        object.of = of.into_iter().next().filter(|_| !several);
        // "The same function F" says nothing new of F.
        if (same || definite) && object.is_bare() && self.is_known(&object) {
            return;
        }
        if object.sort == Sort::ControlPoints {
            self.talk.points = object.of.clone();
        }
        let plain = object.of.is_none() && !object.determines() && !object.has_data();
        object.any = !same && !definite && plain && object.is_function() && self.follows_let(number);
        // "The blossom f of a cubic": what may be spoken of again
        if let (Some(owner), None) = (owner, &object.of) {
            self.owned_by(owner, &object, from);
        }
        self.found.entry(number).or_default().push(object);
    }

    /// Whether "let" stands before a formula.
    fn follows_let(&self, number: usize) -> bool {
        let at = self.tokens.iter().position(|token| matches!(token, Token::Formula(own) if *own == number));
        at.is_some_and(|at| (at.saturating_sub(2)..at).any(|before| self.is(before, &Word::Let)))
    }

    /// "Of degree n", "k is the order": which letter a size is.
    fn size(&mut self, at: usize) {
        let (sort, after) = match self.tokens[at] {
            Token::Word(Word::Degree) => (Sort::Degree, false),
            Token::Word(Word::DegreeAfter) => (Sort::Degree, true),
            Token::Word(Word::Order) => (Sort::Order, false),
            Token::Word(Word::OrderAfter) => (Sort::Order, true),
            _ => return,
        };
        let link = |token: &Token| {
            matches!(
                token,
                Token::Word(Word::Be | Word::Article | Word::Der | Word::Filler | Word::The | Word::Same)
            )
        };
        let next = (at + 1..self.tokens.len()).find(|&next| !link(&self.tokens[next]));
        let last = (0..at).rev().find(|&last| !link(&self.tokens[last]));
        let formula = |at: Option<usize>| at.and_then(|at| self.formula_at(at));
        let number = if after { formula(last) } else { formula(next).or_else(|| formula(last)) };
        let Some(number) = number else { return };
        let [size] = self.said(number) else { return };
        let letters: BTreeSet<String> =
            bases(size).into_iter().filter(|name| is_index_letter(name)).collect();
        if let (Some(letter), 1) = (letters.first(), letters.len()) {
            let degree = Some(size.clone());
            let object = Object { names: vec![Expr::name(letter)], degree, ..Object::new(sort) };
            self.found.entry(number).or_default().push(object);
        }
    }
}
