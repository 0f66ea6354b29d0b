//! A noun with what belongs to it.

use super::super::speech::Word;
use super::subject::{ends, left_side, name_in, named, subject};
use super::tokens::Token;
use super::{Reader, in_order};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::names::bases;
use crate::judge::object::{Object, Sort};

/// A noun phrase.
pub(super) struct Phrase {
    pub(super) object: Object,
    /// Several things that it belongs to: the polar forms of F and G.
    pub(super) of: Vec<Expr>,
    /// The intervals of several curves.
    pub(super) intervals: Vec<(Expr, Expr)>,
    /// Whether it is a piece of what it says.
    pub(super) piece: bool,
    /// Whether it belongs to something without a name: the polar form of any quadratic.
    pub(super) anonymous: bool,
    /// Its first token and the one after it.
    pub(super) from: usize,
    pub(super) to: usize,
    /// The number of the first formula that names it, right after its noun.
    pub(super) named: Option<usize>,
    /// What it belongs to, where that has names: the polar form of a cubic F.
    pub(super) inner: Vec<Phrase>,
}

impl Reader<'_> {
    /// Whether only adjectives stand between a word and a noun after it.
    pub(super) fn leads_to_noun(&self, at: usize) -> bool {
        let rest = self.tokens[at + 1..].iter().find(|token| {
            !matches!(
                token,
                Token::Word(
                    Word::Filler
                        | Word::Symmetric
                        | Word::Affine(_)
                        | Word::Article
                        | Word::Uniform
                        | Word::Natural
                        | Word::Rational
                        | Word::OfDegree(_)
                        | Word::Piece
                )
            )
        });
        matches!(rest, Some(Token::Word(Word::Noun(_)) | Token::Unknown(_)))
    }

    pub(super) fn formula_at(&self, at: usize) -> Option<usize> {
        match self.tokens.get(at) {
            Some(Token::Formula(number)) => Some(*number),
            _ => None,
        }
    }

    pub(super) fn is(&self, at: usize, word: &Word) -> bool {
        let same = |own: &Word| own == word || *word == Word::Filler && own.is_filler();
        matches!(self.tokens.get(at), Some(Token::Word(own)) if same(own))
    }

    pub(super) fn skip_fillers(&self, mut at: usize) -> usize {
        while self.is(at, &Word::Filler) || self.is(at, &Word::Article) || self.is(at, &Word::Der) {
            at += 1;
        }
        at
    }

    /// The formulas and numbers from a token on, with commas and "and" between them, and the token after them.
    pub(super) fn list(&self, mut at: usize) -> (Vec<Expr>, usize) {
        let mut items: Vec<Expr> = Vec::new();
        let mut end = at;
        let equation = |item: &Expr| matches!(item.kind, Kind::Chain(..));
        loop {
            // "with polar form f, G a quadratic": G begins another phrase.
            if !items.is_empty() && (self.is(at + 1, &Word::Article) || self.is(at + 1, &Word::Its)) {
                break;
            }
            match self.tokens.get(at) {
                Some(Token::Formula(number)) => {
                    let more = self.said(*number);
                    // "of a cubic F and u = 1": equations are no items of a list of names.
                    if items.first().is_some_and(|first| !equation(first)) && more.iter().any(equation) {
                        break;
                    }
                    items.extend(more.iter().cloned());
                }
                Some(Token::Number(number)) => items.push(Expr::int(*number)),
                _ => break,
            }
            at += 1;
            end = at;
            while matches!(self.tokens.get(at), Some(Token::Comma | Token::Word(Word::And))) {
                at += 1;
            }
        }
        (items, end)
    }

    /// The knots that end before a token, and their noun.
    fn list_before(&self, end: usize) -> Option<(usize, Vec<Expr>)> {
        let mut at = end;
        while matches!(
            self.tokens.get(at.wrapping_sub(1)),
            Some(Token::Formula(_) | Token::Number(_) | Token::Comma)
        ) {
            at -= 1;
        }
        let noun = at.checked_sub(1)?;
        let knots = matches!(self.tokens[noun], Token::Word(Word::Noun(Sort::Knots | Sort::Nodes)));
        (knots && at < end).then(|| (noun, self.list(at).0))
    }

    /// The noun phrase around a noun.
    pub(super) fn phrase(&self, noun: usize, sort: Sort) -> Phrase {
        let mut object = Object::new(sort);
        let mut phrase_of = Vec::new();
        let (mut piece, mut closed) = (false, false);
        // "symmetric"; "affine in each of its arguments", of which there may be so many
        let (mut symmetric, mut affine) = (false, None);
        let mut from = noun;
        if let Token::Word(Word::OfDegree(degree)) = self.tokens[noun] {
            object.degree = Some(Expr::int(degree));
        }
        // Adjectives, what owns it, its degree before it.
        while let Some(before) = from.checked_sub(1) {
            match &self.tokens[before] {
                Token::Word(
                    Word::Filler | Word::Article | Word::Der | Word::Noun(Sort::Symbols | Sort::Vectors),
                ) => closed = true,
                Token::Word(Word::Symmetric) => symmetric = true,
                Token::Word(Word::Affine(count)) => affine = Some(*count),
                Token::Word(Word::OfDegree(degree)) => object.degree = Some(Expr::int(*degree)),
                Token::Word(Word::Uniform) => object.uniform = true,
                Token::Word(Word::Natural) => object.natural = true,
                Token::Word(Word::Piece) => piece = true,
                Token::Word(Word::Of) if before > 0 && self.is(before - 1, &Word::Piece) => {
                    piece = true;
                    from = before;
                }
                Token::Word(Word::Its) => {
                    closed = true;
                    phrase_of.extend(self.topic.iter().cloned());
                }
                // 3 次, F 的
                Token::Word(mark @ (Word::DegreeAfter | Word::OrderAfter)) if before > 0 => {
                    let Some(degree) = self.number_at(before - 1) else { break };
                    object.degree = Some(if *mark == Word::OrderAfter { degree.plus(-1) } else { degree });
                    from = before;
                }
                // 节点 0, 1, 2 上的
                Token::Word(Word::Owns) if before > 1 && self.is(before - 1, &Word::On) => {
                    let Some((noun, items)) = self.list_before(before - 1) else { break };
                    object.knots = items;
                    from = noun + 1;
                }
                Token::Word(Word::Owns) if before > 0 => {
                    let Some(number) = self.formula_at(before - 1) else { break };
                    phrase_of.extend(self.said(number).iter().cloned());
                    from = before;
                }
                // degree-n polynomial, degree n polynomial
                Token::Formula(_) | Token::Number(_) if before > 0 && self.is(before - 1, &Word::Degree) => {
                    object.degree = self.number_at(before);
                    from = before;
                }
                Token::Word(Word::Rational) => object.rational = true,
                // A C^2 cubic spline
                Token::Formula(number) if is_smoothness(self.said(*number)) => {}
                // An adjective that is not known here may change everything.
                Token::Unknown(word)
                    if !matches!(object.sort, Sort::Symbols | Sort::Vectors)
                        && !closed
                        && !word.contains(' ')
                        && (self.is(before.wrapping_sub(1), &Word::Filler)
                            || self.is(before.wrapping_sub(1), &Word::Article)) =>
                {
                    object.sort = Sort::Other(word.clone().into());
                }
                _ => break,
            }
            from -= 1;
        }
        // Adjectives after it: B-spline quadratique.
        let mut at = noun + 1;
        while let Some(Token::Word(
            word @ (Word::Filler
            | Word::Symmetric
            | Word::Affine(_)
            | Word::OfDegree(_)
            | Word::Uniform
            | Word::Natural
            | Word::Rational
            | Word::Piece),
        )) = self.tokens.get(at)
        {
            match word {
                Word::OfDegree(degree) => object.degree = Some(Expr::int(*degree)),
                Word::Symmetric => symmetric = true,
                Word::Affine(count) => affine = Some(*count),
                Word::Uniform => object.uniform = true,
                Word::Natural => object.natural = true,
                Word::Rational => object.rational = true,
                Word::Piece => piece = true,
                _ => {}
            }
            at += 1;
        }
        // "a knot vector, T = (0, 0, 1, 2, 2)"
        let list = |number: usize| {
            matches!(self.said(number), [Expr { kind: Kind::Chain(left, links), .. }]
                if matches!(left.kind, Kind::Name(_)) && links.len() == 1 && links[0].expr.elements().is_some())
        };
        if object.sort == Sort::Knots
            && matches!(self.tokens.get(at), Some(Token::Comma))
            && self.formula_at(at + 1).is_some_and(list)
        {
            at += 1;
        }
        let mut number_of_name = None;
        // What has no values is named without an equation.
        let plain = matches!(object.sort, Sort::Symbols | Sort::Other(_));
        let of_name = |expr: &Expr| {
            expr.kind == Kind::Ellipsis
                || subject(expr).is_some_and(|name| !plain || named(&name).same_as(expr))
        };
        let first = self.skip_fillers(at);
        if let Some(number) = self.formula_at(first) {
            let (items, end) = self.list(first);
            let knots = matches!(object.sort, Sort::Knots | Sort::Nodes) && !items.iter().any(is_call);
            if items.iter().all(of_name) || knots {
                object.names = items;
                number_of_name = Some(number);
                at = end;
            }
        } else if matches!(object.sort, Sort::Knots | Sort::Nodes)
            && matches!(self.tokens.get(first), Some(Token::Number(_)))
        {
            (object.names, at) = self.list(first);
        }
        // Its knots are 0, 1, 2
        if matches!(object.sort, Sort::Knots | Sort::Nodes)
            && number_of_name.is_none()
            && self.is(at, &Word::Be)
        {
            let start = self.skip_fillers(at + 1);
            let (items, end) = self.list(start);
            if !items.is_empty() && !items.iter().any(is_call) {
                object.names = items;
                number_of_name = self.formula_at(start);
                at = end;
            }
        }
        let named = number_of_name.is_some();
        if let Some(end) = self.values(&mut object, at, named) {
            at = end;
        }
        let mut phrase = Phrase {
            object,
            of: phrase_of,
            intervals: Vec::new(),
            piece,
            anonymous: false,
            from,
            to: at,
            named: number_of_name,
            inner: Vec::new(),
        };
        // Knots and control points in a phrase are names of their own only if they are names.
        loop {
            let mut next = phrase.to;
            // 定义在 [0, 1] 与 [1, 3] 上,
            let after = self.is(next, &Word::On) && matches!(self.tokens.get(next + 1), Some(Token::Comma));
            next += usize::from(after);
            while matches!(self.tokens.get(next), Some(Token::Comma | Token::Word(Word::Filler))) {
                next += 1;
            }
            let Some(end) = self.attribute(next, &mut phrase) else { break };
            phrase.to = end;
        }
        // A spline on the knots t_0, …, t_3, namely 0, 0, 1, 1
        if !phrase.object.knots.is_empty() {
            let mut knots = Object { names: phrase.object.knots.clone(), ..Object::new(Sort::Knots) };
            if let Some(end) = self.values(&mut knots, phrase.to, true) {
                let named = (noun..end).find_map(|at| self.formula_at(at));
                let (from, to) = (phrase.to, end);
                phrase.inner.push(Phrase {
                    object: knots,
                    of: Vec::new(),
                    intervals: Vec::new(),
                    piece: false,
                    anonymous: false,
                    from,
                    to,
                    named,
                    inner: Vec::new(),
                });
                phrase.to = end;
            }
        }
        // The knots t_0, …, t_3 of a quadratic spline are 0, 0, 1, 1
        if phrase.object.values.is_empty()
            && let Some(end) = self.values(&mut phrase.object, phrase.to, named)
        {
            phrase.to = end;
        }
        let object = &mut phrase.object;
        // The Lagrange polynomials of x_0, …, x_n
        if matches!(object.sort, Sort::Lagrange | Sort::Symmetric(_)) && object.knots.is_empty() {
            object.knots = std::mem::take(&mut phrase.of);
        }
        // The cubic with the Bézier points …
        if matches!(object.sort, Sort::Polynomial | Sort::Function) && !object.points.is_empty() {
            object.sort = Sort::BezierCurve;
        }
        if let (Sort::Function, Some(count)) = (&object.sort, affine) {
            object.sort = if symmetric { Sort::PolarForm } else { Sort::Affine };
            object.degree = object.degree.take().or(count.map(Expr::int));
        }
        phrase
    }

    /// Reads the values of what was named: the knots t_0, …, t_3 are 0, 0, 1, 1; the control points 0, 4, 8.
    fn values(&self, object: &mut Object, at: usize, named: bool) -> Option<usize> {
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

    /// A number or formula that says a degree: n, p ≥ 1.
    fn number_at(&self, at: usize) -> Option<Expr> {
        match self.tokens.get(at)? {
            Token::Number(number) => Some(Expr::int(*number)),
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
                            Word::And | Word::Of | Word::With | Word::Der | Word::Filler | Word::Article
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

    /// Reads "of degree n", "of F", "on the knots …", "with the control points …"; the token after it.
    fn attribute(&self, at: usize, phrase: &mut Phrase) -> Option<usize> {
        let Phrase { object, of, intervals, piece, anonymous, inner: within, .. } = phrase;
        if object.sort == Sort::BSpline
            && let Some((knots, end)) = self.support(at)
        {
            if object.knots.is_empty() {
                object.knots = knots;
            }
            return Some(end);
        }
        let own =
            matches!(self.tokens.get(at), Some(Token::Word(Word::Noun(Sort::ControlPoints) | Word::Weights)));
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
            Token::Word(Word::Noun(Sort::ControlPoints) | Word::Weights)
                if matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve)
                    && object.is_without(&self.tokens[at])
                    && self.is(at + 1, &Word::Be)
                    && self.formula_at(at + 2).is_some() =>
            {
                &Word::With
            }
            // 曲线的控制点为 b_0, b_1, b_2
            Token::Word(Word::Owns)
                if matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve)
                    && matches!(self.tokens.get(at + 1), Some(token @ Token::Word(Word::Noun(Sort::ControlPoints) | Word::Weights)) if object.is_without(token)) =>
            {
                &Word::With
            }
            // e_k in x_1, …, x_n
            Token::Word(Word::Preposition) if matches!(object.sort, Sort::Symmetric(_)) => &Word::Of,
            Token::Word(word) => word,
            _ => return None,
        };
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
                            Some(Token::Word(Word::Filler | Word::Article | Word::Be | Word::OfDegree(_)))
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
                            *anonymous |= of.is_empty() && *word == Word::Of;
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
                            && let Some(knots) = only.elements().filter(|elements| elements.len() > 3)
                        {
                            object.knots = knots.to_vec();
                            return Some(end);
                        }
                        let all: Option<Vec<(Expr, Expr)>> =
                            items.iter().map(|item| ends(std::slice::from_ref(item))).collect();
                        let all = all.filter(|all| !all.is_empty())?;
                        object.interval = all.first().cloned();
                        *intervals = all;
                        Some(end)
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
            _ => self.points.is_empty(),
        }
    }
}

/// The items of a list of names, values or equations, which have their own formulas.
pub(super) fn listed(items: Vec<Expr>) -> Vec<Expr> {
    // with the control points P_0 = (1, 0), P_1 = (2, 3), with the weights w_0 = w_2 = 1, w_1 = 3, with the knots u_i = i
    let equation = |item: &&Expr| {
        matches!(&item.kind, Kind::Chain(_, links) if links[0].rel == Rel::Eq
            && links[0].expr.items().is_none_or(|_| items.len() > 1))
    };
    let items: Vec<Expr> = match items.first().filter(equation).and_then(name_in) {
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

/// C^2, among adjectives.
fn is_smoothness(said: &[Expr]) -> bool {
    let [Expr { kind: Kind::Pow(letter, order), .. }] = said else { return false };
    matches!(&letter.kind, Kind::Name(name) if name == "C") && matches!(order.kind, Kind::Number(_))
}

/// Whether it is, or gives, the value of a function: no knot.
pub(super) fn is_call(expr: &Expr) -> bool {
    matches!(left_side(expr).kind, Kind::Apply(..))
}
