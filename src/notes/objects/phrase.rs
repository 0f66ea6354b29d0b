//! A noun with what belongs to it.

use super::super::speech::Word;
use super::Reader;
use super::attributes::is_call;
use super::facts::degree_of_knots;
use super::subject::{left_side, named, subject};
use super::tokens::Token;
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, is_range};

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
    /// Whether it is what was spoken of before: the same curve.
    pub(super) same: bool,
    /// Whether it may be: the curve.
    pub(super) definite: bool,
    /// Whether it belongs to what was spoken of before.
    pub(super) of_known: bool,
    /// Something new without a name that it belongs to: the polar form of a cubic.
    pub(super) owner: Option<Object>,
    /// Whether it is something new: a curve.
    pub(super) new: bool,
    /// Its first token and the one after it.
    pub(super) from: usize,
    pub(super) to: usize,
    /// The number of the first formula that names it, right after its noun.
    pub(super) named: Option<usize>,
    /// What it belongs to, where that has names: the polar form of a cubic F.
    pub(super) inner: Vec<Phrase>,
}

impl Phrase {
    /// What is to be said of an object from a token on.
    pub(super) fn new(object: Object, from: usize) -> Self {
        Phrase {
            object,
            of: Vec::new(),
            intervals: Vec::new(),
            piece: false,
            anonymous: false,
            same: false,
            definite: false,
            of_known: false,
            owner: None,
            new: false,
            from,
            to: from,
            named: None,
            inner: Vec::new(),
        }
    }
}

impl Reader<'_> {
    /// Whether only adjectives stand between a word and a noun after it.
    pub(super) fn leads_to_noun(&self, at: usize) -> bool {
        let rest = self.tokens[at + 1..].iter().find(|token| {
            !matches!(
                token,
                Token::Word(
                    Word::Filler
                        | Word::The
                        | Word::Same
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

    /// Whether nothing but a degree and a kind stands between an article and its noun.
    fn is_bare(&self, from: usize, noun: usize) -> bool {
        self.tokens[from..noun].iter().all(|token| {
            matches!(token, Token::Word(Word::OfDegree(_) | Word::Uniform | Word::Rational | Word::Same))
        })
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

    /// "A Bézier curve: control points b_0, b_1, b_2"
    fn opens_points(&self, at: usize) -> bool {
        let noun = matches!(
            self.tokens.get(at + 1),
            Some(Token::Word(Word::Noun(Sort::ControlPoints) | Word::Weights))
        );
        let list = at + 2 + usize::from(self.is(at + 2, &Word::Be));
        matches!(self.tokens.get(at), Some(Token::Stop)) && noun && self.formula_at(list).is_some()
    }

    /// The token after a range of a parameter and a comma: the curve x(t), t ∈ [0, 1], has …
    pub(super) fn after_range(&self, at: usize) -> Option<usize> {
        let noun = |token: &Token| matches!(token, Token::Word(Word::Noun(Sort::Symbols) | Word::Filler));
        let formula = (at..self.tokens.len()).find(|&at| !noun(&self.tokens[at]))?;
        let range = self.said(self.formula_at(formula)?);
        let comma = matches!(self.tokens.get(formula + 1), Some(Token::Comma));
        let one = matches!(range, [only] if is_range(only));
        (one && comma).then_some(formula + 2)
    }

    /// The formulas and numbers from a token on, with commas and "and" between them, and the token after them.
    pub(super) fn list(&self, mut at: usize) -> (Vec<Expr>, usize) {
        let mut items: Vec<Expr> = Vec::new();
        let mut end = at;
        let equation = |item: &Expr| matches!(item.kind, Kind::Chain(..));
        loop {
            // "with polar form f, G a quadratic": G begins another phrase.
            let article = |at: usize| self.is(at, &Word::Article) || self.is(at, &Word::Its);
            if !items.is_empty() && (article(at + 1) || self.is(at + 1, &Word::Be) && article(at + 2)) {
                break;
            }
            match self.tokens.get(at) {
                Some(Token::Formula(number)) => {
                    let more = self.said(*number);
                    // "of a cubic F and u = 1": equations are no items of a list of names.
                    if items.first().is_some_and(|first| !equation(first)) && more.iter().any(equation) {
                        break;
                    }
                    // "the curve P(t) = Σ P_i B_{i,3}(t), B_{i,3}(t) = …": what the curve is made of follows it.
                    let shape = |item: &Expr| Head::of(left_side(item)).map(|head| head.lower.len());
                    let own = more.first().filter(|first| equation(first)).and_then(shape);
                    let alike =
                        |item: &&Expr| own.is_none_or(|own| shape(item).is_none_or(|count| count == own));
                    items.extend(more.iter().take_while(alike).cloned());
                }
                Some(Token::Number(number)) => items.push(Expr::int(*number)),
                _ => break,
            }
            at += 1;
            end = at;
            // the knots u = (0, 0, 0, 1, 1, 1) and d = (1, 2, 0)
            if matches!(items.as_slice(), [only] if gives_a_list(only)) {
                break;
            }
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
        let (mut same, mut definite, mut new) = (false, false, false);
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
                    word @ (Word::Filler
                    | Word::The
                    | Word::Same
                    | Word::Article
                    | Word::Der
                    | Word::Noun(Sort::Symbols | Sort::Vectors)),
                ) => {
                    closed = true;
                    // "The curve", but not "the left curve"
                    same |= *word == Word::Same;
                    definite |= matches!(word, Word::The | Word::Der) && self.is_bare(from, noun);
                    new |= *word == Word::Article;
                }
                // an n-variate form
                Token::Word(Word::Arguments) if before > 0 && self.number_at(before - 1).is_some() => {
                    if object.sort == Sort::PolarForm {
                        object.degree = self.number_at(before - 1);
                    }
                    from = before;
                }
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
                    phrase_of.extend(self.talk.topic.iter().cloned());
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
                // 过点 (0, 1), (1, 3) 的
                Token::Word(Word::Owns) if self.data_before(before).is_some() => {
                    let Some((through, data)) = self.data_before(before) else { break };
                    object.data = data;
                    from = through + 1;
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
                // A unit vector is a vector whatever else it is.
                Token::Unknown(word) if object.sort == Sort::Vectors && !closed && !word.contains(' ') => {}
                // An adjective that is not known here may change everything.
                Token::Unknown(word)
                    if !matches!(object.sort, Sort::Symbols | Sort::Vectors)
                        && !closed
                        && !word.contains(' ')
                        && (self.is(before.wrapping_sub(1), &Word::Filler)
                            || self.is(before.wrapping_sub(1), &Word::Article)
                            || matches!(object.sort, Sort::Bernstein | Sort::BSpline)
                                && self.is(before.wrapping_sub(1), &Word::The)) =>
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
            | Word::The
            | Word::Same
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
        let list = |number: usize| matches!(self.said(number), [only] if gives_a_list(only));
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
            of: phrase_of,
            piece,
            same,
            definite,
            new,
            to: at,
            named: number_of_name,
            ..Phrase::new(object, from)
        };
        // Knots and control points in a phrase are names of their own only if they are names.
        loop {
            let mut next = phrase.to;
            // 定义在 [0, 1] 与 [1, 3] 上,
            let after = self.is(next, &Word::On) && matches!(self.tokens.get(next + 1), Some(Token::Comma));
            next += usize::from(after);
            while matches!(
                self.tokens.get(next),
                Some(Token::Comma | Token::Word(Word::Filler | Word::The | Word::Same))
            ) || self.opens_points(next)
            {
                next += 1;
            }
            let Some(end) = self
                .attribute(next, &mut phrase)
                .or_else(|| self.attribute(self.after_range(next)?, &mut phrase))
            else {
                break;
            };
            phrase.to = end;
        }
        // A spline on the knots t_0, …, t_3, namely 0, 0, 1, 1
        if !phrase.object.knots.is_empty() {
            let mut knots = Object { names: phrase.object.knots.clone(), ..Object::new(Sort::Knots) };
            if let Some(end) = self.values(&mut knots, phrase.to, true) {
                let named = (noun..end).find_map(|at| self.formula_at(at));
                let (from, to) = (phrase.to, end);
                phrase.inner.push(Phrase { to, named, ..Phrase::new(knots, from) });
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
        if object.sort == Sort::BSpline && object.degree.is_none() {
            object.degree = degree_of_knots(&object.knots);
        }
        // The Lagrange polynomials of x_0, …, x_n
        if matches!(object.sort, Sort::Lagrange | Sort::Symmetric(_)) && object.knots.is_empty() {
            object.knots = std::mem::take(&mut phrase.of);
        }
        // The cubic with the Bézier points …
        if matches!(object.sort, Sort::Polynomial | Sort::Function) && !object.points.is_empty() {
            object.sort = Sort::BezierCurve;
        }
        // A cubic curve
        if object.sort == Sort::Function && object.degree.is_some() && affine.is_none() && !object.rational {
            object.sort = Sort::Polynomial;
        }
        // "A uniform B-spline with the control points …" is a curve.
        if object.sort == Sort::BSpline && !object.points.is_empty() {
            object.sort = Sort::SplineCurve;
        }
        // A symmetric curve or cubic is more than a curve.
        if symmetric && affine.is_none() && matches!(object.sort, Sort::BezierCurve | Sort::SplineCurve) {
            object.sort = Sort::Other("symmetric".into());
        }
        if let (Sort::PolarForm, Some(Some(count)), None) = (&object.sort, affine, &object.degree) {
            object.degree = Some(Expr::int(count));
        }
        if let (Sort::Function, Some(count)) = (&object.sort, affine) {
            object.sort = if symmetric { Sort::PolarForm } else { Sort::Affine };
            object.degree = object.degree.take().or(count.map(Expr::int));
        }
        phrase
    }
}

/// C^2, among adjectives.
fn is_smoothness(said: &[Expr]) -> bool {
    let [Expr { kind: Kind::Pow(letter, order), .. }] = said else { return false };
    matches!(&letter.kind, Kind::Name(name) if name == "C") && matches!(order.kind, Kind::Number(_))
}

/// T = (0, 0, 1, 2, 2): all of a list at once.
fn gives_a_list(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Chain(left, links)
        if matches!(left.kind, Kind::Name(_)) && links.len() == 1 && links[0].expr.elements().is_some_and(|all| all.len() > 2))
}
