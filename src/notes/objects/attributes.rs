//! What belongs to a noun: its degree, what it is of, its knots, its control points, its interval.

use super::phrase::Phrase;
use super::subject::{ends, left_side, name_in};
use super::tokens::Token;
use super::{Reader, in_order};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, bases};
use crate::notes::speech::{self, Word};

/// What words make of a function.
enum Made {
    Formula(Vec<Expr>),
    Unknown(String),
}

impl Reader<'_> {
    /// The members of the family of a name that a formula, or with `row` several after each other, give one by one.
    pub(super) fn siblings(&self, name: &Expr, number: usize, row: bool) -> Vec<Expr> {
        let member = |expr: &Expr| {
            Head::of(expr)
                .filter(|head| head.arguments.is_none() && head.lower.len() == 1 && head.upper.is_empty())
        };
        let Some(own) = member(left_side(name)) else { return vec![name.clone()] };
        let given = |item: &&Expr| matches!(item.kind, Kind::Chain(..));
        let start = self.tokens.iter().position(|token| matches!(token, Token::Formula(at) if *at == number));
        let others = self.tokens.iter().skip(start.map_or(0, |at| at + 1)).map_while(|token| match token {
            Token::Formula(at) => Some(Some(*at)),
            Token::Comma | Token::Word(Word::And) => Some(None),
            _ => None,
        });
        let numbers: Vec<usize> =
            std::iter::once(number).chain(row.then_some(others).into_iter().flatten().flatten()).collect();
        let alike = numbers.iter().flat_map(|at| self.said(*at)).filter(given).map(left_side);
        let alike = alike.filter(|left| member(left).is_some_and(|head| head.base == own.base));
        let found: Vec<Expr> = alike.cloned().collect();
        if found.len() > 1 { found } else { vec![name.clone()] }
    }

    /// Reads the values of what was named: the knots t_0, …, t_3 are 0, 0, 1, 1; the control points 0, 4, 8.
    pub(super) fn values(&self, object: &mut Object, at: usize, named: bool) -> Option<usize> {
        if !matches!(object.sort, Sort::Knots | Sort::Nodes | Sort::ControlPoints) {
            return None;
        }
        let comma = usize::from(matches!(self.tokens.get(at), Some(Token::Comma)));
        let linked = self.is(at + comma, &Word::Be);
        let start = self.skip_fillers(if linked { at + comma + 1 } else { at });
        let (items, end) = self.list(start);
        let items: Vec<Expr> = match items.as_slice() {
            [Expr { kind: Kind::Tuple(inside) | Kind::List(inside) | Kind::Set(inside, None), .. }] => {
                inside.clone()
            }
            _ => items,
        };
        let constant = items.iter().all(|item| bases(item).is_empty() && item.kind != Kind::Ellipsis);
        let owned = object.sort == Sort::ControlPoints || named && linked;
        let given = items.len() > 1 && constant && owned;
        given.then(|| {
            object.values = items;
            end
        })
    }

    /// The intervals from a token on, with commas and "and" between them, and the token after them.
    fn intervals(&self, mut at: usize) -> (Vec<(Expr, Expr)>, usize) {
        let mut found = Vec::new();
        let mut end = at;
        while let Some(interval) = self.formula_at(at).and_then(|number| ends(self.said(number))) {
            found.push(interval);
            end = at + 1;
            at = end;
            while matches!(self.tokens.get(at), Some(Token::Comma | Token::Word(Word::And))) {
                at += 1;
            }
        }
        (found, end)
    }

    /// A number or formula that says a degree: n, p ≥ 1.
    pub(super) fn number_at(&self, at: usize) -> Option<Expr> {
        match self.tokens.get(at)? {
            Token::Number(number) => Some(Expr::int(*number)),
            // of degree five
            Token::Word(Word::Count(number)) if at > 0 && self.is(at - 1, &Word::Degree) => {
                Some(Expr::int(*number))
            }
            Token::Formula(number) => self.said(*number).first().map(|said| match &said.kind {
                Kind::Chain(left, _) => left.as_ref().clone(),
                _ => said.clone(),
            }),
            _ => None,
        }
    }

    /// "Supported on [t_i, t_{i+n+1}]": the knots t_i, …, t_{i+n+1}, and the token after it.
    fn support(&self, at: usize) -> Option<(Vec<Expr>, usize)> {
        let joins = |at: usize| {
            matches!(
                self.tokens.get(at),
                Some(
                    Token::Comma
                        | Token::Word(
                            Word::And
                                | Word::Of
                                | Word::With
                                | Word::Der
                                | Word::Filler
                                | Word::The
                                | Word::Same
                                | Word::Article
                        )
                )
            )
        };
        let noun = (at..at + 4).find(|&at| !joins(at)).filter(|&at| self.is(at, &Word::Support))?;
        let start = (noun + 1..noun + 4)
            .find(|&at| !joins(at) && !self.is(at, &Word::On) && !self.is(at, &Word::Be))?;
        let (from, to) = ends(self.said(self.formula_at(start)?))?;
        Some((vec![from, Kind::Ellipsis.into(), to], start + 1))
    }

    /// "Of its derivative F'", "of the square of F": what words make of a function, and the token after them.
    fn made_from(&self, at: usize) -> Option<(Made, usize)> {
        let skipped = |token: &Token| {
            matches!(token, Token::Word(Word::Its | Word::The | Word::Article | Word::Filler | Word::Der))
        };
        let noun = (at..self.tokens.len()).find(|&at| !skipped(&self.tokens[at]))?;
        let its = (at..noun).any(|at| self.is(at, &Word::Its));
        let Token::Unknown(words) = &self.tokens[noun] else { return None };
        if let Some(number) = self.formula_at(noun + 1) {
            return Some((Made::Formula(self.said(number).to_vec()), noun + 2));
        }
        let of = self.is(noun + 1, &Word::Of) || self.is(noun + 1, &Word::Der);
        let start = self.skip_fillers(noun + 2);
        let (function, end) = match (self.formula_at(start).filter(|_| of), self.talk.topic.as_slice()) {
            (Some(number), _) => match self.said(number) {
                [only] => (name_in(only)?, start + 1),
                _ => return None,
            },
            (None, [one]) if its => (one.clone(), noun + 1),
            _ => return None,
        };
        let derived = speech::is_the_derivative(words) && matches!(function.kind, Kind::Name(_));
        Some(match derived {
            true => (Made::Formula(vec![Kind::Prime(Box::new(function), 1).into()]), end),
            false => (Made::Unknown(words.clone()), end),
        })
    }

    /// Reads "of degree n", "of F", "on the knots …", "with the control points …"; the token after it.
    pub(super) fn attribute(&self, at: usize, phrase: &mut Phrase) -> Option<usize> {
        let Phrase { object, of, intervals, piece, anonymous, same, of_known, owner, inner: within, .. } =
            phrase;
        if object.sort == Sort::BSpline
            && let Some((knots, end)) = self.support(at)
        {
            if object.knots.is_empty() {
                object.knots = knots;
            }
            return Some(end);
        }
        let own = matches!(
            self.tokens.get(at),
            Some(Token::Word(Word::Noun(Sort::ControlPoints | Sort::Knots) | Word::Weights))
        );
        let next = if own { at } else { self.skip_fillers(at + 1) };
        let word = match self.tokens.get(at)? {
            // with … and weights …
            Token::Word(Word::And)
                if matches!(
                    self.tokens.get(next),
                    Some(Token::Word(
                        Word::Weights | Word::Noun(Sort::Knots | Sort::Nodes | Sort::ControlPoints)
                    ))
                ) =>
            {
                &Word::With
            }
            Token::Word(Word::Der) => &Word::Of,
            // …, the control points being b_0, …, b_3 and the weights 1, 2, 1
            Token::Word(Word::Noun(Sort::ControlPoints | Sort::Knots) | Word::Weights)
                if matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve)
                    && object.is_without(&self.tokens[at])
                    && self.formula_at(at + 1 + usize::from(self.is(at + 1, &Word::Be))).is_some() =>
            {
                &Word::With
            }
            // with control points b_0, …, b_n over [0, 1] and c_0, …, c_n over [1, 2]
            Token::Word(Word::And)
                if object.sort == Sort::BezierCurve && !object.points.is_empty() && intervals.len() == 1 =>
            {
                let (items, end) = self.list(at + 1);
                let member = |item: &Expr| {
                    item.kind == Kind::Ellipsis || Head::of(item).is_some_and(|h| h.index().is_some())
                };
                let interval = self.formula_at(self.skip_fillers(end + 1)).map(|number| self.said(number));
                let over = self.is(end, &Word::On).then(|| ends(interval?)).flatten();
                if !items.iter().all(member) {
                    return None;
                }
                object.points.extend(items);
                intervals.push(over?);
                return Some(self.skip_fillers(end + 1) + 1);
            }
            // 曲线的控制点为 b_0, b_1, b_2
            Token::Word(Word::Owns)
                if matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve)
                    && matches!(self.tokens.get(at + 1), Some(token @ Token::Word(Word::Noun(Sort::ControlPoints | Sort::Knots) | Word::Weights)) if object.is_without(token)) =>
            {
                &Word::With
            }
            // through the points (0, 1), (1, 3); which interpolates p_i, …, p_{i+r} at t_i, …, t_{i+r}
            Token::Word(Word::Through | Word::On)
                if matches!(object.sort, Sort::Polynomial | Sort::Function) && !object.has_data() =>
            {
                // On (0, 1) and (1, 2), but zu den Daten (0, 1) und (1, 2)
                let start = self.after_nouns(at + 1);
                let called = (at..start).any(|at| self.is(at, &Word::Noun(Sort::Symbols)));
                if (called || self.is(at, &Word::Through))
                    && let Some((data, end)) = self.data(start)
                {
                    object.data = data;
                    return Some(end);
                }
                if self.is(at, &Word::Through)
                    && let Some((points, nodes, end)) = self.points_at_nodes(at + 1)
                {
                    object.points = points;
                    object.knots = nodes;
                    object.sort = Sort::Interpolant;
                    return Some(end);
                }
                &Word::On
            }
            // a polar form in n + 1 arguments
            Token::Word(Word::Preposition | Word::With | Word::Of | Word::On)
                if object.sort == Sort::PolarForm
                    // "With d arguments" may be said beside one with d + 1.
                    && self.number_at(next).is_some_and(|count| {
                        !self.is(at, &Word::With) || !matches!(count.kind, Kind::Name(_))
                    })
                    && matches!(
                        self.tokens.get(next + 1),
                        Some(Token::Word(Word::Arguments | Word::Noun(Sort::Symbols)))
                    ) =>
            {
                object.degree = self.number_at(next);
                return Some(next + 2);
            }
            // in degree 4
            Token::Word(Word::Preposition) if self.is(next, &Word::Degree) => &Word::Of,
            // with the Bernstein polynomials of degree 4
            Token::Word(Word::With | Word::Preposition)
                if matches!(self.tokens.get(next), Some(Token::Word(Word::Noun(Sort::Bernstein)))) =>
            {
                let inner = self.phrase(next, Sort::Bernstein);
                object.degree = Some(inner.object.degree?);
                return Some(inner.to);
            }
            // 该曲线的控制点为 b_0, b_1, b_2
            Token::Word(Word::Owns)
                if *same
                    && matches!(
                        self.tokens.get(at + 1),
                        Some(Token::Word(Word::Noun(Sort::ControlPoints)))
                    )
                    && object.points.is_empty() =>
            {
                &Word::With
            }
            // e_k in x_1, …, x_n
            Token::Word(Word::Preposition) if matches!(object.sort, Sort::Symmetric(_)) => &Word::Of,
            Token::Word(word) => word,
            _ => return None,
        };
        if *word == Word::Of
            && object.sort == Sort::PolarForm
            && of.is_empty()
            && let Some((made, end)) = self.made_from(next)
        {
            match made {
                Made::Formula(items) => of.extend(items),
                Made::Unknown(words) => object.sort = Sort::Other(words.into()),
            }
            return Some(end);
        }
        match word {
            Word::Of | Word::On | Word::With | Word::As => {
                let mut next = next;
                while self.is(next, &Word::Uniform) || self.is(next, &Word::Piece) {
                    object.uniform |= self.is(next, &Word::Uniform);
                    *piece |= self.is(next, &Word::Piece);
                    next = self.skip_fillers(next + 1);
                    if *piece && self.is(next, &Word::Of) {
                        next = self.skip_fillers(next + 1);
                    }
                }
                // for n + 1 distinct nodes x_0, …, x_n
                let counted = self.skip_fillers(next + 1);
                let number = matches!(
                    self.tokens.get(next),
                    Some(Token::Formula(_) | Token::Number(_) | Token::Word(Word::Count(_)))
                );
                if number
                    && matches!(self.tokens.get(counted), Some(token @ Token::Word(Word::Noun(Sort::Knots | Sort::Nodes | Sort::ControlPoints))) if object.is_without(token))
                {
                    next = counted;
                }
                // "The Bézier points of the left piece, over [a, c]"
                if *piece && object.sort == Sort::ControlPoints && object.interval.is_none() {
                    let comma = usize::from(matches!(self.tokens.get(next), Some(Token::Comma)));
                    let over = self.is(next + comma, &Word::On).then_some(next + comma + 1);
                    let here = over.and_then(|over| Some((self.interval_at(over)?, over + 1)));
                    let said = || self.interval_in(at).or(self.talk.interval.clone());
                    if let Some((interval, end)) = here.or_else(|| Some((said()?.1, next))) {
                        object.interval = Some(interval);
                        *of_known = true;
                        return Some(end);
                    }
                }
                // "Un polynôme de forme polaire f" has it.
                let owned = self.is(next, &Word::Noun(Sort::PolarForm));
                if *word == Word::Of && owned && object.is_function() && object.sort != Sort::PolarForm {
                    return None;
                }
                match self.tokens.get(next)? {
                    Token::Word(mark @ (Word::Degree | Word::Order)) => {
                        let value = self.skip_fillers(next + 1);
                        let degree = self.number_at(value)?;
                        object.degree = Some(if *mark == Word::Order { degree.plus(-1) } else { degree });
                        Some(value + 1)
                    }
                    Token::Word(Word::OfDegree(degree)) if *word == Word::As => {
                        object.degree = Some(Expr::int(*degree));
                        Some(next + 1)
                    }
                    // with the end points b_0 and b_2
                    Token::Word(Word::Ends)
                        if object.sort == Sort::BezierCurve && object.points.is_empty() =>
                    {
                        let (items, end) = self.list(self.skip_fillers(next + 1));
                        let names: Vec<Expr> = items.iter().filter_map(name_in).collect();
                        let [first, last] = names.as_slice() else { return None };
                        let (a, b) = (Head::of(first)?, Head::of(last)?);
                        let numbered = a.base == b.base && a.index()?.as_int() == Some(0);
                        let whole = match (&object.degree, b.index()) {
                            (Some(degree), Some(index)) => degree.same_as(index),
                            _ => false,
                        };
                        object.points = match numbered && whole {
                            true => vec![first.clone(), Kind::Ellipsis.into(), last.clone()],
                            false => return None,
                        };
                        Some(end)
                    }
                    Token::Word(
                        noun @ (Word::Noun(Sort::Knots | Sort::Nodes | Sort::ControlPoints) | Word::Weights),
                    ) => {
                        let list = match noun {
                            Word::Weights => &mut object.weights,
                            Word::Noun(Sort::ControlPoints) => &mut object.points,
                            _ => &mut object.knots,
                        };
                        let mut at = next + 1;
                        while matches!(
                            self.tokens.get(at),
                            Some(Token::Word(
                                Word::Filler
                                    | Word::The
                                    | Word::Same
                                    | Word::Article
                                    | Word::Be
                                    | Word::OfDegree(_)
                            ))
                        ) {
                            at += 1;
                        }
                        let (items, end) = self.list(at);
                        if items.iter().any(is_call) {
                            return None;
                        }
                        *list = in_order(listed(items));
                        // "With uniform knots" gives none.
                        let given = !list.is_empty() || object.uniform && at == end;
                        given.then_some(end)
                    }
                    Token::Word(Word::Noun(_) | Word::OfDegree(_)) if *word != Word::With => {
                        let noun = (next..self.tokens.len())
                            .find(|&at| matches!(self.tokens[at], Token::Word(Word::Noun(_))))
                            .filter(|&at| at == next || self.leads_to_noun(next))
                            .unwrap_or(next);
                        let sort = match &self.tokens[noun] {
                            Token::Word(Word::Noun(sort)) => sort.clone(),
                            _ => Sort::Polynomial,
                        };
                        let inner = self.phrase(noun, sort);
                        if *word == Word::As || object.degree.is_none() {
                            object.degree = inner.object.degree.clone().or(object.degree.take());
                        }
                        if *piece {
                            // A segment of a curve is what the curve is.
                            object.sort = inner.object.sort.clone();
                        }
                        if of.is_empty() {
                            of.extend(
                                inner
                                    .object
                                    .names
                                    .iter()
                                    .map(|name| name_in(name).unwrap_or_else(|| name.clone())),
                            );
                            of.extend(inner.of.iter().cloned());
                            let known = inner.same || inner.definite && object.names.is_empty();
                            if of.is_empty() && *word == Word::Of && known && !inner.new {
                                *of_known = true;
                            } else {
                                *anonymous |= of.is_empty() && *word == Word::Of;
                                if *anonymous && inner.object.degree.is_some() && inner.object.is_function() {
                                    *owner = Some(inner.object.clone());
                                }
                            }
                        }
                        object.uniform |= inner.object.uniform;
                        object.rational |= inner.object.rational;
                        object.knots.extend(inner.object.knots.iter().cloned());
                        object.points.extend(inner.object.points.iter().cloned());
                        object.interval = object.interval.take().or(inner.object.interval.clone());
                        let to = inner.to;
                        if *word == Word::Of && inner.named.is_some() {
                            within.push(inner);
                        }
                        Some(to)
                    }
                    Token::Formula(_) if *word == Word::Of => {
                        let (items, end) = self.list(next);
                        // P(u) = … is P.
                        of.extend(items.iter().map(|item| match &item.kind {
                            Kind::Chain(..) => name_in(item).unwrap_or_else(|| item.clone()),
                            _ => item.clone(),
                        }));
                        Some(end)
                    }
                    Token::Formula(_) if *word == Word::On => {
                        let (items, end) = self.list(next);
                        // zum Knotenvektor (0, 0, 0, 1, 1, 1)
                        if let [only] = items.as_slice()
                            && let Some(knots) = right_side(only).elements().filter(|all| all.len() > 3)
                        {
                            object.knots = knots.to_vec();
                            return Some(end);
                        }
                        *intervals = self.intervals(next).0;
                        object.interval = intervals.first().cloned();
                        Some(self.intervals(next).1).filter(|_| !intervals.is_empty())
                    }
                    Token::Unknown(_) if *word == Word::On => {
                        let number = self.formula_at(next + 1)?;
                        object.interval = Some(ends(self.said(number))?);
                        Some(next + 2)
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

impl Object {
    /// Whether nothing is said yet of what a word speaks of: its control points, its weights.
    fn is_without(&self, token: &Token) -> bool {
        match token {
            Token::Word(Word::Weights) => self.weights.is_empty(),
            Token::Word(Word::Noun(Sort::Knots)) => self.knots.is_empty(),
            _ => self.points.is_empty(),
        }
    }
}

/// The items of a list of names, values or equations, which have their own formulas.
pub(super) fn listed(items: Vec<Expr>) -> Vec<Expr> {
    // with the control points P_0 = (1, 0), P_1 = (2, 3), with the weights w_0 = w_2 = 1, w_1 = 3, with the knots u_i = i
    let equation = |item: &&Expr| {
        matches!(&item.kind, Kind::Chain(_, links) if links[0].rel == Rel::Eq
            && links[0].expr.elements().is_none_or(|_| items.len() > 1))
    };
    let family = |item: &Expr| Head::of(item).map(|head| head.base);
    let items: Vec<Expr> = match items.first().filter(equation).and_then(name_in) {
        // q_0 = p_3, q_1, q_2
        Some(first) if items.iter().skip(1).all(|item| family(item) == family(&first)) => {
            std::iter::once(first).chain(items.into_iter().skip(1)).collect()
        }
        Some(_) => items.iter().filter(equation).flat_map(names_in).collect(),
        None => items,
    };
    // with the ordinates (1, 4, -2), on the knots t_0, …, t_3 = 0, 0, 1, 1
    match items.as_slice() {
        [only] => {
            let list = match &only.kind {
                Kind::Chain(_, links) => &links[0].expr,
                _ => only,
            };
            list.elements().map_or_else(|| items.clone(), <[Expr]>::to_vec)
        }
        _ => items,
    }
}

/// The names in an equation that gives them one value: w_0 = w_2 = 1.
fn names_in(equation: &Expr) -> Vec<Expr> {
    let Kind::Chain(left, links) = &equation.kind else { return Vec::new() };
    let between = links.iter().rev().skip(1).rev().map(|link| &link.expr);
    std::iter::once(left.as_ref()).chain(between).filter_map(name_in).collect()
}

/// The right side of an equation, or a formula alone.
fn right_side(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Chain(_, links) if links[0].rel == Rel::Eq => &links[0].expr,
        _ => expr,
    }
}

/// Whether it is, or gives, the value of a function: no knot.
pub(super) fn is_call(expr: &Expr) -> bool {
    matches!(left_side(expr).kind, Kind::Apply(..))
}
