//! What a sentence speaks of again: "its", "the same curve", "it".
//!
//! **Definition.** A *referent* is what the last phrase with a noun of a function spoke of, by its name or by one that no
//! page has. "Its", "the same curve", "this polynomial" and "the curve" without anything that tells it from others are
//! that referent.

use super::Reader;
use super::subject::{ends, left_side, name_in};
use super::tokens::Token;
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, Sort, UNNAMED};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::written::names::Head;
use crate::notes::speech::{self, Word};

/// What was spoken of.
#[derive(Default)]
pub(super) struct Talk {
    /// The names of the referent.
    pub(super) topic: Vec<Expr>,
    /// The names of the one before.
    pub(super) before: Vec<Expr>,
    /// The referent, if it has no name and no statement says yet what it is.
    pub(super) unnamed: Option<Object>,
    /// Polar forms of it, if it has no name.
    pub(super) forms: Vec<Object>,
    /// What the control points that were spoken of last belong to.
    pub(super) points: Option<Expr>,
    /// As what degree it is regarded, and in which sentence that was said.
    pub(super) viewed: Option<(usize, Expr)>,
    /// The last interval and the number of its formula.
    pub(super) interval: Option<(usize, (Expr, Expr))>,
}

impl Talk {
    /// Whether the referent has no name.
    pub(super) fn is_unnamed(&self) -> bool {
        matches!(self.topic.as_slice(), [Expr { kind: Kind::Name(name), .. }] if name.starts_with(UNNAMED))
    }

    /// Goes on to speak of something else.
    pub(super) fn of(&mut self, names: Vec<Expr>) {
        let last = std::mem::replace(&mut self.topic, names);
        if !last.is_empty() {
            self.before = last;
        }
        self.unnamed = None;
        self.forms.clear();
        self.viewed = None;
    }
}

impl Reader<'_> {
    /// What was said last of a name.
    pub(super) fn known(&self, name: &Expr) -> Option<Object> {
        let own = |object: &&Object| object.names.iter().any(|known| known.same_as(name));
        let curves =
            |object: &&Object| matches!(object.sort, Sort::BSpline | Sort::SplineCurve | Sort::BezierCurve);
        let said = self.found.values().rev().flat_map(|list| list.iter().rev());
        self.talk.unnamed.iter().chain(said).filter(curves).find(own).cloned()
    }

    /// Whether each name of an object was spoken of as a function.
    pub(super) fn is_known(&self, object: &Object) -> bool {
        let said = |name: &Expr| {
            let mut all = self.found.values().flatten().filter(|known| known.is_function());
            all.any(|known| known.names.iter().any(|known| known.same_as(name)))
        };
        object.is_function() && object.names.iter().all(said)
    }

    /// Takes in a phrase that no name belongs to: "a cubic Bézier curve", "the same curve has the control points …".
    pub(super) fn take_unnamed(
        &mut self,
        mut object: Object,
        intervals: Vec<(Expr, Expr)>,
        same: bool,
        new: bool,
        from: usize,
        to: usize,
    ) {
        // "A spline of degree p is a polynomial": the same thing
        let be = from.checked_sub(1).is_some_and(|before| self.is(before, &Word::Be));
        // "A conic arc is a rational curve with the points …": a curve after all
        if be && object.points.is_empty() {
            if let (Some(known), Sort::Polynomial) = (&mut self.talk.unnamed, &object.sort)
                && known.points.is_empty()
            {
                known.sort = Sort::Polynomial;
                known.degree = object.degree.or(known.degree.take());
            }
            return;
        }
        let curve = matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve);
        let number = (from..to).find_map(|at| self.formula_at(at));
        // "The left half is a cubic curve with the control points …": no curve of its own
        if be && curve && self.is_part(from - 1) {
            if let Some(number) = number {
                let of_part = Object { names: object.points, ..Object::new(Sort::ControlPoints) };
                self.found.entry(number).or_default().push(of_part);
            }
            return;
        }
        // "Converted into Bézier form with the Bézier points …" is the same curve.
        let form = object.sort == Sort::BezierCurve
            && !new
            && from.checked_sub(1).is_some_and(|before| self.is(before, &Word::Preposition));
        if (same || form) && object.is_function() {
            let points = std::mem::take(&mut object.points);
            if let (Some(number), false) = (number, points.is_empty()) {
                self.has_points(points, &object, from, number);
            }
            return;
        }
        // "Quadratic B-splines over the knot vector (0, 0, 0, 1, 3, 3, 3)"
        let listed = object.knots.len() > 3 && object.knots.iter().all(|knot| knot.as_number().is_some());
        if let (Sort::BSpline, true, Some(number)) = (&object.sort, listed, number) {
            let knots = Object { names: object.knots, ..Object::new(Sort::Knots) };
            self.found.entry(number).or_default().push(knots);
            return;
        }
        let name = Expr::name(format!("{UNNAMED}{}.{from}", self.count));
        if curve
            && !object.points.is_empty()
            && let Some(number) = number
        {
            let lists = super::facts::families(&object.points);
            if lists.len() > 1 && lists.len() == intervals.len() {
                // "Two curves over [0, 1] and [1, 3] with the control points b_0, … and c_0, …"
                for ((points, interval), at) in lists.into_iter().zip(intervals).zip(1..) {
                    let names = vec![Expr::name(format!("{UNNAMED}{at}"))];
                    let interval = Some(interval);
                    let own = Object { names, points, interval, ..object.clone() };
                    self.found.entry(number).or_default().push(own);
                }
            } else {
                object.names = vec![name.clone()];
                self.talk.of(vec![name]);
                self.found.entry(number).or_default().push(object);
            }
            return;
        }
        let polynomial = object.sort == Sort::Polynomial && object.degree.is_some() && object.data.is_empty();
        if new && (curve || polynomial) {
            self.talk.of(vec![name.clone()]);
            object.names = vec![name];
            self.talk.unnamed = Some(object);
        }
    }

    /// Whether it is a part of a curve that has what begins at a token.
    pub(super) fn has_a_part(&self, from: usize) -> bool {
        from.checked_sub(1).is_some_and(|verb| self.is(verb, &Word::With) && self.is_part(verb))
    }

    /// Whether the words before a verb speak of a part of a curve.
    fn is_part(&self, verb: usize) -> bool {
        match verb.checked_sub(1).map(|subject| &self.tokens[subject]) {
            Some(Token::Unknown(words)) => {
                let mut topics = Topics::default();
                speech::topics(words, &mut topics);
                [Topic::Half, Topic::Second, Topic::Subdivision].into_iter().any(|topic| topics.has(topic))
            }
            // The pieces of a spline have points of their own, too.
            Some(Token::Word(Word::Piece)) => {
                let spline = |known: &Object| known.sort == Sort::SplineCurve;
                matches!(self.talk.topic.as_slice(), [owner] if !self.known(owner).as_ref().is_some_and(spline))
            }
            _ => false,
        }
    }

    /// "The same curve has the control points …"
    fn has_points(&mut self, points: Vec<Expr>, object: &Object, from: usize, number: usize) {
        let [owner] = self.talk.topic.as_slice() else { return };
        let owner = owner.clone();
        if object.degree.is_none() && self.gives_points(&points, number) {
            return;
        }
        let mut own = Object {
            degree: object.degree.clone(),
            interval: object.interval.clone(),
            of: Some(owner.clone()),
            ..Object::new(Sort::ControlPoints)
        };
        if own.interval.is_some() || self.of_piece(&mut own, &points, &owner, from, number) {
            self.introduce(std::slice::from_ref(&owner), number);
            own.names = points;
            self.found.entry(number).or_default().push(own);
        }
    }

    /// "F is regarded as a polynomial of degree n + 1": it is F that is spoken of, whatever was before.
    pub(super) fn view(&mut self, from: usize, degree: Option<Expr>) {
        let viewed = (0..from).rev().find_map(|at| self.formula_at(at));
        let viewed = viewed.and_then(|number| self.said(number).first());
        if let Some(name @ Expr { kind: Kind::Name(_), .. }) = viewed
            && !matches!(self.talk.topic.as_slice(), [own] if own.same_as(name))
        {
            let name = name.clone();
            self.talk.of(vec![name]);
        }
        self.talk.viewed = degree.map(|degree| (self.count, degree));
    }

    /// Says what the referent is before a formula that speaks of what belongs to it.
    pub(super) fn introduce(&mut self, owners: &[Expr], number: usize) {
        let owned = |object: &mut Object| owners.iter().any(|owner| object.names[0].same_as(owner));
        if let Some(object) = self.talk.unnamed.take_if(owned) {
            let forms = std::mem::take(&mut self.talk.forms);
            self.found.entry(number).or_default().extend(std::iter::once(object).chain(forms));
        }
    }

    /// "The blossom f of a cubic": the cubic can be spoken of again.
    pub(super) fn owned_by(&mut self, mut owner: Object, object: &Object, from: usize) {
        let name = Expr::name(format!("{UNNAMED}{}.{from}", self.count));
        self.talk.of(vec![name.clone()]);
        owner.names = vec![name.clone()];
        self.talk.unnamed = Some(owner);
        self.talk.forms = vec![Object { of: Some(name), ..object.clone() }];
    }

    /// Takes points for those of the referent without a name, if it has none yet; whether it does.
    pub(super) fn gives_points(&mut self, points: &[Expr], number: usize) -> bool {
        let free = |object: &mut Object| {
            object.points.is_empty() && matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve)
        };
        let Some(mut object) = self.talk.unnamed.take_if(free) else { return false };
        object.points = points.to_vec();
        self.found.entry(number).or_default().push(object);
        true
    }

    /// Finds the interval of the piece to which a polar form or control points belong; whether they belong to one
    /// polynomial.
    pub(super) fn of_piece(
        &self,
        object: &mut Object,
        names: &[Expr],
        owner: &Expr,
        from: usize,
        number: usize,
    ) -> bool {
        let known = self.known(owner);
        let spline = known.as_ref().is_some_and(|known| known.sort == Sort::SplineCurve);
        let near = |other: &usize| match (self.places.get(other), self.places.get(&number)) {
            (Some(there), Some(here)) => there.group == here.group,
            _ => false,
        };
        let interval = self
            .interval_in(from)
            .or_else(|| self.talk.interval.clone().filter(|(other, _)| near(other)))
            .map(|(_, interval)| interval);
        let index = |name: &Expr| Head::of(name).and_then(|head| head.index().cloned());
        let numbered = match (&interval, names) {
            (Some((start, _)), [name]) => match (index(start), index(name)) {
                (Some(a), Some(b)) => a.same_as(&b),
                _ => false,
            },
            _ => false,
        };
        // s_j of the piece on [u_j, u_{j+1}]
        if numbered && object.sort == Sort::PolarForm {
            object.interval = interval;
            return true;
        }
        // "A cubic x is given over [a, b] by its Bézier points"
        let whole = known.as_ref().is_none_or(|known| known.interval.is_none());
        if !spline && whole && object.sort == Sort::ControlPoints {
            // The points of a piece between knots are those of the spline.
            let knot = |end: &Expr| Head::of(end).is_some_and(|head| head.index().is_some());
            let interval = self.interval_in(from).map(|(_, interval)| interval);
            object.interval = interval.filter(|(a, b)| !knot(a) && !knot(b));
        }
        let Some(known) = known.filter(|_| spline) else { return true };
        if known.interval.is_some() {
            return true;
        }
        let member = |end: &Expr| Head::of(end).is_some_and(|head| head.index().is_some());
        let knots = interval.filter(|(a, b)| member(a) && member(b));
        if object.sort == Sort::ControlPoints && known.points.is_empty() {
            return true;
        }
        let found = knots.is_some();
        object.interval = knots;
        found || object.sort == Sort::PolarForm
    }

    /// The last interval before a token and the number of its formula.
    pub(super) fn interval_in(&self, end: usize) -> Option<(usize, (Expr, Expr))> {
        (0..end).rev().find_map(|at| Some((self.formula_at(at)?, self.interval_at(at)?)))
    }

    /// The interval that a token is.
    pub(super) fn interval_at(&self, at: usize) -> Option<(Expr, Expr)> {
        ends(self.said(self.formula_at(at)?))
    }

    /// Gives the referent without a name the name of a function; whether there is one.
    pub(super) fn name_unnamed(&mut self, name: &Expr, number: usize) -> bool {
        let [owner] = self.talk.topic.as_slice() else { return false };
        let unnamed = self.talk.is_unnamed();
        let plain = Head::of(name).is_some_and(|head| head.lower.is_empty() && head.upper.is_empty());
        let Some(known) = self.known(owner).filter(|_| unnamed && plain) else { return false };
        let own = Object { names: vec![name.clone()], ..known };
        self.talk.of(own.names.clone());
        self.found.entry(number).or_default().push(own);
        true
    }

    /// "It is x(t) = …", "the segment s(t)": a name for the referent without one. Gives the token after them.
    pub(super) fn named_anew(&mut self, at: usize) -> usize {
        let mut start = self.skip_fillers(at + 1);
        if self.is(at, &Word::It) {
            if !self.is(start, &Word::Be) {
                return at + 1;
            }
            start = self.skip_fillers(start + 1);
        } else if !at.checked_sub(1).is_some_and(|before| self.is(before, &Word::The)) {
            return at + 1;
        }
        let Some(number) = self.formula_at(start) else { return at + 1 };
        let call = self.said(number).first().map(left_side);
        let function = call.filter(|call| matches!(call.kind, Kind::Apply(..))).and_then(name_in);
        match function {
            Some(name) if self.name_unnamed(&name, number) => start + 1,
            _ => at + 1,
        }
    }
}
