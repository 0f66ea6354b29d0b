//! What sentences say in words that names stand for: "let f be the polar form of F".
//!
//! **Definition.** A *noun phrase* is a noun of the field with what belongs to it: adjectives before it, and after
//! it its names, its degree, what it belongs to, its knots, its control points. Its *subject*, the names that it
//! speaks of, follows it at once ("the polar form f of F"), or stands before it ("let f be the polar form of F",
//! "f its polar form"), or after "by". What a phrase is, in four languages, is data of `speech`.

use super::sentence::Piece;
use super::speech::{self, Word};
use std::collections::BTreeMap;

use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::judge::names::Head;
use crate::judge::object::{Object, Sort};
use crate::judge::statement::{Said, Statement};

/// A part of a sentence, as far as it matters here.
#[derive(Clone, Debug)]
enum Token {
    Word(Word),
    /// Words without a known meaning.
    Unknown(String),
    /// A number in words.
    Number(i64),
    /// A formula in the sentence.
    Formula(usize),
    Comma,
    /// A colon, a bracket, a dash.
    Stop,
}

/// Puts a statement about each object before the first formula that speaks of it.
///
/// Cost: linear in the words, times the number of phrases.
pub fn insert(sentences: &[Vec<Piece>], statements: &mut Vec<Statement>) {
    let formulas = formulas(statements);
    let mut found: BTreeMap<usize, Vec<Object>> = BTreeMap::new();
    let mut topic: Vec<Expr> = Vec::new();
    for sentence in sentences {
        let tokens = tokens(sentence);
        let mut reader = Reader { tokens, formulas: &formulas, topic, taken: 0, found: &mut found };
        reader.read();
        topic = reader.topic;
    }
    let mut all = Vec::with_capacity(statements.len() + found.len());
    for statement in statements.drain(..) {
        for object in found.remove(&statement.place.formula).unwrap_or_default() {
            let said = Said::Object(Box::new(object));
            all.push(Statement { said, role: None, ..statement.clone() });
        }
        all.push(statement);
    }
    *statements = all;
}

/// What the formula with a number says, in its parts.
fn formulas(statements: &[Statement]) -> BTreeMap<usize, Vec<Expr>> {
    let mut found: BTreeMap<usize, Vec<Expr>> = BTreeMap::new();
    for statement in statements {
        let expr = match &statement.said {
            Said::Chain(chain) => chain.whole(),
            Said::Condition(side) | Said::Bare(side, _) => side.expr.clone(),
            _ => continue,
        };
        let own = found.entry(statement.place.formula).or_default();
        match expr.kind {
            Kind::Sequence(items) => own.extend(items),
            _ => own.push(expr),
        }
    }
    found
}

fn tokens(sentence: &[Piece]) -> Vec<Token> {
    let mut found = Vec::new();
    for piece in sentence {
        match piece {
            Piece::Formula(number) => found.push(Token::Formula(*number)),
            Piece::Words(words) => words_of(words, &mut found),
        }
    }
    found
}

fn words_of(words: &str, found: &mut Vec<Token>) {
    let lower: String = words
        .to_lowercase()
        .chars()
        .map(|c| match c {
            '*' | '_' | '#' | '>' | '~' | '`' | '\\' | '\n' | '-' if c != '-' => ' ',
            '’' => '\'',
            '–' | '‑' => '-',
            c => c,
        })
        .collect();
    let single = lower.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut rest = single.as_str();
    while let Some(c) = rest.chars().next() {
        if c == ' ' {
            rest = &rest[1..];
        } else if let Some((length, word)) = speech::word(rest) {
            found.push(Token::Word(word.clone()));
            rest = &rest[length..];
        } else if matches!(c, ',' | '，' | '、') {
            found.push(Token::Comma);
            rest = &rest[c.len_utf8()..];
        } else if c.is_ascii_digit() {
            let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            let number = rest[..digits].parse();
            found.push(number.map_or_else(|_| Token::Unknown(rest[..digits].to_owned()), Token::Number));
            rest = &rest[digits..];
        } else if c.is_alphabetic() {
            let spaced = !('\u{2e80}'..='\u{ffef}').contains(&c);
            let length = match spaced {
                true => rest
                    .find(|c: char| !c.is_alphanumeric() && !matches!(c, '-' | '\''))
                    .unwrap_or(rest.len()),
                false => c.len_utf8(),
            };
            let word = &rest[..length.max(c.len_utf8())];
            match found.last_mut() {
                Some(Token::Unknown(known)) => {
                    if spaced {
                        known.push(' ');
                    }
                    known.push_str(word);
                }
                _ => found.push(Token::Unknown(word.to_owned())),
            }
            rest = &rest[word.len()..];
        } else {
            if !matches!(c, '\'' | '"' | '.' | '。') {
                found.push(Token::Stop);
            }
            rest = &rest[c.len_utf8()..];
        }
    }
}

struct Reader<'a> {
    tokens: Vec<Token>,
    formulas: &'a BTreeMap<usize, Vec<Expr>>,
    /// What "its" refers to.
    topic: Vec<Expr>,
    /// The tokens before this one belong to noun phrases already.
    taken: usize,
    found: &'a mut BTreeMap<usize, Vec<Object>>,
}

/// A noun phrase.
struct Phrase {
    object: Object,
    /// Several things that it belongs to: the polar forms of F and G.
    of: Vec<Expr>,
    /// Whether it is a piece of what it says.
    piece: bool,
    /// Whether it belongs to something without a name: the polar form of any quadratic.
    anonymous: bool,
    /// Its first token and the one after it.
    from: usize,
    to: usize,
    /// The number of the first formula that names it, right after its noun.
    named: Option<usize>,
}

impl<'a> Reader<'a> {
    fn said(&self, number: usize) -> &'a [Expr] {
        self.formulas.get(&number).map_or(&[], Vec::as_slice)
    }

    fn read(&mut self) {
        let mut at = 0;
        while at < self.tokens.len() {
            match &self.tokens[at] {
                Token::Word(Word::Noun(sort)) => {
                    let phrase = self.phrase(at, sort.clone());
                    at = phrase.to.max(at + 1);
                    self.take(phrase);
                }
                // A cubic: an adjective without a noun.
                Token::Word(Word::OfDegree(degree))
                    if *degree > 1 && self.follows_article(at) && !self.leads_to_noun(at) =>
                {
                    let phrase = self.phrase(at, Sort::Polynomial);
                    at = phrase.to.max(at + 1);
                    self.take(phrase);
                }
                Token::Formula(number) => {
                    if let Some(first) = self.said(*number).first() {
                        self.speak_of(left_side(first));
                    }
                    at += 1;
                }
                Token::Word(Word::Let) => {
                    self.unknown_sort(at);
                    at += 1;
                }
                _ => at += 1,
            }
        }
    }

    /// "its" refers to the function that was spoken of last, not to a member of a family nor to a value.
    fn speak_of(&mut self, call: &Expr) {
        let Some(head) = Head::of(call) else { return };
        let plain = |argument: &&Expr| matches!(argument.kind, Kind::Name(_));
        if head.arguments.is_some() && head.lower.is_empty() && head.upper.is_empty() {
            self.topic = if head.flat().iter().all(plain) { vec![named(call)] } else { Vec::new() };
        }
    }

    fn follows_article(&self, at: usize) -> bool {
        let article = |word: &Word| matches!(word, Word::Article | Word::Filler | Word::Der | Word::Its);
        at.checked_sub(1)
            .is_some_and(|before| matches!(&self.tokens[before], Token::Word(word) if article(word)))
    }

    /// Whether only adjectives stand between a word and a noun after it.
    fn leads_to_noun(&self, at: usize) -> bool {
        let rest = self.tokens[at + 1..].iter().find(|token| {
            !matches!(
                token,
                Token::Word(
                    Word::Filler
                        | Word::Article
                        | Word::Uniform
                        | Word::Rational
                        | Word::OfDegree(_)
                        | Word::Piece
                )
            )
        });
        matches!(rest, Some(Token::Word(Word::Noun(_)) | Token::Unknown(_)))
    }

    fn formula_at(&self, at: usize) -> Option<usize> {
        match self.tokens.get(at) {
            Some(Token::Formula(number)) => Some(*number),
            _ => None,
        }
    }

    fn is(&self, at: usize, word: &Word) -> bool {
        matches!(self.tokens.get(at), Some(Token::Word(own)) if own == word)
    }

    fn skip_fillers(&self, mut at: usize) -> usize {
        while self.is(at, &Word::Filler) || self.is(at, &Word::Article) || self.is(at, &Word::Der) {
            at += 1;
        }
        at
    }

    /// The formulas and numbers from a token on, with commas and "and" between them, and the token after them.
    fn list(&self, mut at: usize) -> (Vec<Expr>, usize) {
        let mut items = Vec::new();
        let mut end = at;
        loop {
            match self.tokens.get(at) {
                Some(Token::Formula(number)) => items.extend(self.said(*number).iter().cloned()),
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
    fn phrase(&self, noun: usize, sort: Sort) -> Phrase {
        let mut object = Object::new(sort);
        let mut phrase_of = Vec::new();
        let (mut piece, mut rational, mut anonymous) = (false, false, false);
        let mut from = noun;
        if let Token::Word(Word::OfDegree(degree)) = self.tokens[noun] {
            object.degree = Some(Expr::int(degree));
        }
        if object.sort == Sort::Other(String::new()) {
            object.sort = Sort::Other("prime".to_owned());
        }
        // Adjectives, what owns it, its degree before it.
        while let Some(before) = from.checked_sub(1) {
            match &self.tokens[before] {
                Token::Word(Word::Filler | Word::Article | Word::Der) => {}
                Token::Word(Word::OfDegree(degree)) => object.degree = Some(Expr::int(*degree)),
                Token::Word(Word::Uniform) => object.uniform = true,
                Token::Word(Word::Piece) => piece = true,
                Token::Word(Word::Of) if before > 0 && self.is(before - 1, &Word::Piece) => {
                    piece = true;
                    from = before;
                }
                Token::Word(Word::Its) => phrase_of.extend(self.topic.iter().cloned()),
                // 3 次, F 的
                Token::Word(mark @ (Word::DegreeAfter | Word::OrderAfter)) if before > 0 => {
                    let Some(degree) = self.number_at(before - 1) else { break };
                    object.degree = Some(if *mark == Word::OrderAfter { minus_one(degree) } else { degree });
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
                Token::Word(Word::Rational) => rational = true,
                // An adjective that is not known here may change everything.
                Token::Unknown(word)
                    if object.sort != Sort::Symbols
                        && !word.contains(' ')
                        && (self.is(before.wrapping_sub(1), &Word::Filler)
                            || self.is(before.wrapping_sub(1), &Word::Article)) =>
                {
                    object.sort = Sort::Other(word.clone());
                }
                _ => break,
            }
            from -= 1;
        }
        // Adjectives after it: B-spline quadratique.
        let mut at = noun + 1;
        while let Some(Token::Word(
            word @ (Word::Filler | Word::OfDegree(_) | Word::Uniform | Word::Rational),
        )) = self.tokens.get(at)
        {
            match word {
                Word::OfDegree(degree) => object.degree = Some(Expr::int(*degree)),
                Word::Uniform => object.uniform = true,
                Word::Rational => rational = true,
                _ => {}
            }
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
            if items.iter().all(of_name) || matches!(object.sort, Sort::Knots | Sort::Nodes) {
                object.names = items;
                number_of_name = Some(number);
                at = end;
            }
        } else if matches!(object.sort, Sort::Knots | Sort::Nodes)
            && matches!(self.tokens.get(first), Some(Token::Number(_)))
        {
            (object.names, at) = self.list(first);
        }
        // Knots and control points in a phrase are names of their own only if they are names.
        loop {
            let mut next = at;
            while matches!(self.tokens.get(next), Some(Token::Comma | Token::Word(Word::Filler))) {
                next += 1;
            }
            let Some(end) = self.attribute(next, &mut object, &mut phrase_of, &mut piece, &mut anonymous)
            else {
                break;
            };
            at = end;
        }
        // The cubic with the Bézier points …
        if matches!(object.sort, Sort::Polynomial | Sort::Function) && !object.points.is_empty() {
            object.sort = Sort::BezierCurve;
        }
        if rational && object.weights.is_empty() {
            object.sort = Sort::Other("rational".to_owned());
        }
        Phrase { object, of: phrase_of, piece, anonymous, from, to: at, named: number_of_name }
    }

    /// A number or formula that says a degree.
    fn number_at(&self, at: usize) -> Option<Expr> {
        match self.tokens.get(at)? {
            Token::Number(number) => Some(Expr::int(*number)),
            Token::Formula(number) => self.said(*number).first().cloned(),
            _ => None,
        }
    }

    /// Reads "of degree n", "of F", "on the knots …", "with the control points …"; the token after it.
    fn attribute(
        &self,
        at: usize,
        object: &mut Object,
        of: &mut Vec<Expr>,
        piece: &mut bool,
        anonymous: &mut bool,
    ) -> Option<usize> {
        let next = self.skip_fillers(at + 1);
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
                match self.tokens.get(next)? {
                    Token::Word(mark @ (Word::Degree | Word::Order)) => {
                        let value = self.skip_fillers(next + 1);
                        let degree = self.number_at(value)?;
                        object.degree = Some(if *mark == Word::Order { minus_one(degree) } else { degree });
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
                        *list = items;
                        (!list.is_empty()).then_some(end)
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
                            of.extend(inner.of);
                            *anonymous |= of.is_empty() && *word == Word::Of;
                        }
                        object.uniform |= inner.object.uniform;
                        object.knots.extend(inner.object.knots);
                        object.points.extend(inner.object.points);
                        object.interval = object.interval.take().or(inner.object.interval);
                        Some(inner.to)
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
                    Token::Formula(number) if *word == Word::On => {
                        object.interval = Some(interval(self.said(*number))?);
                        Some(next + 1)
                    }
                    Token::Unknown(_) if *word == Word::On => {
                        let number = self.formula_at(next + 1)?;
                        object.interval = Some(interval(self.said(number))?);
                        Some(next + 2)
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The formulas right before a token that a phrase can be said of, and the number of the first one.
    fn subjects_before(&self, from: usize) -> Option<(Vec<Expr>, usize)> {
        let mut at = from;
        while let Some(before) = at.checked_sub(1) {
            match &self.tokens[before] {
                Token::Word(Word::Be | Word::Filler | Word::Article | Word::Der) | Token::Comma => {
                    at = before
                }
                _ => break,
            }
        }
        let mut items: Vec<Expr> = Vec::new();
        let mut first = None;
        let formula_before =
            |at: usize| at.checked_sub(1).filter(|&b| b >= self.taken).and_then(|b| self.formula_at(b));
        while let Some(number) = formula_before(at) {
            let own = self.said(number);
            // p(t), 0 ≤ t ≤ 1, is …
            let range = matches!(own, [Expr { kind: Kind::Chain(_, links), .. }]
                if links.iter().all(|link| !matches!(link.rel, Rel::Eq | Rel::Define)));
            if !range {
                let names: Vec<Expr> = own.iter().filter_map(name_in).collect();
                if names.len() != own.len() {
                    break;
                }
                items.splice(0..0, names);
                first = Some(number);
            }
            at -= 1;
            let mut gap = at;
            while matches!(
                gap.checked_sub(1).map(|before| &self.tokens[before]),
                Some(Token::Comma | Token::Word(Word::And))
            ) {
                gap -= 1;
            }
            // f and g: but not "F a polynomial and f its polar form"
            if formula_before(gap).is_none() || range && first.is_some() {
                break;
            }
            at = gap;
        }
        // "from p_1 to p_2 is a curve" does not speak of p_2.
        let governed = at.checked_sub(1).is_some_and(|before| {
            matches!(
                &self.tokens[before],
                Token::Word(Word::Of | Word::On | Word::With | Word::As | Word::Preposition | Word::Degree)
            )
        });
        Some((items, first?)).filter(|_| !governed)
    }

    /// "denoted by f"
    fn subject_after(&self, to: usize) -> Option<(Vec<Expr>, usize)> {
        let at = self.skip_fillers(to);
        let by = self.is(at, &Word::By) || self.is(at, &Word::Be);
        let number = self.formula_at(self.skip_fillers(at + 1)).filter(|_| by)?;
        let items: Vec<Expr> = self.said(number).iter().filter_map(name_in).collect();
        (!items.is_empty()).then_some((items, number))
    }

    fn take(&mut self, phrase: Phrase) {
        let Phrase { mut object, mut of, piece, anonymous, from, to, named } = phrase;
        if piece && matches!(object.sort, Sort::BSpline | Sort::SplineCurve) {
            object.sort = Sort::SplineCurve;
            object.interval.get_or_insert_with(|| (Expr::int(0), Expr::int(1)));
        }
        let subject = match named {
            Some(number) if !object.names.is_empty() => Some((object.names.clone(), number)),
            _ => self.subjects_before(from).or_else(|| self.subject_after(to)),
        };
        let Some((names, number)) = subject else { return };
        let whole = |expr: &Expr| expr.kind != Kind::Ellipsis && name_in(expr).is_none();
        if names.iter().any(whole) && !matches!(object.sort, Sort::Knots | Sort::Nodes) {
            return;
        }
        let owned = from.checked_sub(1).is_some_and(|before| self.is(before, &Word::With));
        let takes = object.sort == Sort::PolarForm || object.sort == Sort::ControlPoints && owned;
        if takes && of.is_empty() && !anonymous {
            of.extend(self.topic.iter().cloned());
        }
        self.taken = to;
        let function = object.is_function() && object.sort != Sort::PolarForm;
        let names: Vec<Expr> =
            names.iter().map(|name| name_in(name).unwrap_or_else(|| name.clone())).collect();
        if function {
            self.topic = names.clone();
        }
        // The polar forms f and g of F and G
        if of.len() > 1 && of.len() == names.len() {
            for (name, of) in names.into_iter().zip(of) {
                let own = Object { names: vec![name], of: Some(of), ..object.clone() };
                self.found.entry(number).or_default().push(own);
            }
            return;
        }
        object.names = names;
        object.of = of.into_iter().next();
        self.found.entry(number).or_default().push(object);
    }

    /// "Let G be a group": what a noun that is not known here says of names.
    fn unknown_sort(&mut self, at: usize) {
        let start = self.skip_fillers(at + 1);
        let (items, mut end) = self.list(start);
        let names: Vec<Expr> =
            items.iter().filter(|item| matches!(item.kind, Kind::Name(_))).cloned().collect();
        let Some(number) = self.formula_at(start).filter(|_| !names.is_empty() && names.len() == items.len())
        else {
            return;
        };
        let mut article = false;
        while let Some(Token::Word(word @ (Word::Be | Word::Filler | Word::Article))) = self.tokens.get(end) {
            article |= *word == Word::Article;
            end += 1;
        }
        if let (true, Some(Token::Unknown(words))) = (article, self.tokens.get(end))
            && !matches!(self.tokens.get(end + 1), Some(Token::Word(Word::Noun(_))))
        {
            let sort = Sort::Other(words.clone());
            self.found.entry(number).or_default().push(Object { names, ..Object::new(sort) });
        }
    }
}

/// The left side of an equation, or a formula alone.
fn left_side(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Chain(left, links) if matches!(links[0].rel, Rel::Eq | Rel::Define | Rel::In | Rel::Colon) => {
            left.as_ref()
        }
        _ => expr,
    }
}

/// A name, or a function at variables, on the left of an equation or alone.
fn subject(expr: &Expr) -> Option<Expr> {
    let name = left_side(expr);
    let plain = |argument: &&Expr| {
        Head::of(argument).is_some_and(|head| head.arguments.is_none()) || argument.kind == Kind::Ellipsis
    };
    let whole = |argument: &&Expr| !matches!(argument.kind, Kind::Number(_)) && plain(argument);
    Head::of(name).filter(|head| head.flat().iter().all(whole)).map(|_| name.clone())
}

fn name_in(expr: &Expr) -> Option<Expr> {
    if expr.kind == Kind::Ellipsis {
        return Some(expr.clone());
    }
    subject(expr).map(|name| named(&name))
}

/// A name without its arguments.
fn named(expr: &Expr) -> Expr {
    match &expr.kind {
        Kind::Apply(callee, _) => callee.as_ref().clone(),
        _ => expr.clone(),
    }
}

fn minus_one(order: Expr) -> Expr {
    let one = Term { sign: Sign::Minus, expr: Expr::int(1) };
    Expr::sum(vec![Term { sign: Sign::Plus, expr: order }, one])
}

/// [a, b]
fn interval(items: &[Expr]) -> Option<(Expr, Expr)> {
    let [one] = items else { return None };
    let ends: &[Expr] = match &one.kind {
        Kind::List(ends) | Kind::Tuple(ends) => ends,
        Kind::Apply(_, groups) => groups.first()?,
        _ => return None,
    };
    match ends {
        [from, to] => Some((from.clone(), to.clone())),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{self, Container};
    use crate::formula::source::SourceFile;
    use crate::language::write;
    use crate::notes::statement::statements;

    /// What a page says of its names, an object a line.
    fn said(page: &str) -> Vec<String> {
        let file = SourceFile::new("page.md", page);
        let document = document::document(file, Container::Markdown);
        let objects = statements(&document).into_iter().filter_map(|statement| match statement.said {
            Said::Object(object) => Some(*object),
            _ => None,
        });
        let list = |items: &[Expr]| items.iter().map(write::text).collect::<Vec<_>>().join(" ");
        let line = |object: Object| {
            let mut line = format!("{}: {:?}", list(&object.names), object.sort);
            for (what, items) in [
                (" degree ", object.degree.as_slice()),
                (" of ", object.of.as_slice()),
                (" knots ", &object.knots),
                (" points ", &object.points),
            ] {
                if !items.is_empty() {
                    line += what;
                    line += &list(items);
                }
            }
            if let Some((from, to)) = &object.interval {
                line += &format!(" on {}..{}", write::text(from), write::text(to));
            }
            line + if object.uniform { " uniform" } else { "" }
        };
        objects.map(line).collect()
    }

    #[test]
    fn objects_in_four_languages() {
        let mut wrong = Vec::new();
        for (page, wanted) in [
            ("Let $f$ be the polar form of $F$.", vec!["f: PolarForm of F"]),
            (
                "Let $F$ be a polynomial of degree $n$ and $f$ its polar form.",
                vec!["F: Polynomial degree n", "f: PolarForm of F"],
            ),
            ("Let $F(t)=t^3$ and let $g$ be its blossom.", vec!["g: PolarForm of F"]),
            (
                "Let $f$ be the polar form of $t^2+2t$, taken as degree 3, and $g$ the polar form of $t^3+1$.",
                vec!["f: PolarForm degree 3 of t^2 + 2 t", "g: PolarForm of t^3 + 1"],
            ),
            (
                "Let $H=fg$ be the product and $h$ the polar form of $H$, of degree 2.",
                vec!["h: PolarForm degree 2 of H"],
            ),
            (
                "Let $f_j$ be the polar form of the piece of $\\mathbf C$ on $[u_j,u_{j+1})$.",
                vec!["f_j: PolarForm of bold(C) on u_j..u_{j+1}"],
            ),
            (
                "Let $N_{0,2}$ be the B-spline of degree 2 on the knots $0,1,2,3$.",
                vec!["N_{0,2}: BSpline degree 2 knots 0 1 2 3"],
            ),
            (
                "let $N_i^k(t)$ be the B-spline of order $k$, that is of degree $k-1$, on the simple knots $t_i,\\dots,t_{i+k}$.",
                vec!["N_i^k: BSpline degree k - 1 knots t_i ... t_{i+k}"],
            ),
            (
                "Let $\\mathbf p(t)$, $0\\le t\\le 1$, be one segment of the uniform cubic B-spline with the de Boor points $d_0,d_1,d_2,d_3$.",
                vec!["bold(p): SplineCurve degree 3 points d_0 d_1 d_2 d_3 on 0..1 uniform"],
            ),
            (
                "Let $\\ell_i$ be the polynomial of degree at most $n$ with $\\ell_i(x_j)=\\delta_{ij}$.",
                vec!["ell_i: Polynomial degree n"],
            ),
            ("Let $p$ be a prime.", vec!["p: Other(\"prime\")"]),
            ("Let $G$ be a finite group.", vec!["G: Other(\"finite group\")"]),
            ("Let $A$ and $B$ be invertible matrices.", vec!["A B: Matrix"]),
            (
                "Polynomials $F$ and $G$ with polar forms $f$ and $g$.",
                vec!["F G: Polynomial", "f: PolarForm of F", "g: PolarForm of G"],
            ),
            (
                "The cubic Bézier curve $p$ with control points $b_0,b_1,b_2,b_3$ is drawn.",
                vec!["p: BezierCurve degree 3 points b_0 b_1 b_2 b_3"],
            ),
            ("Sei $f$ die Polarform von $F$.", vec!["f: PolarForm of F"]),
            (
                "Es sei $F$ ein Polynom vom Grad $n$ und $f$ seine Polarform.",
                vec!["F: Polynomial degree n", "f: PolarForm of F"],
            ),
            ("Soit $f$ la forme polaire de $F$.", vec!["f: PolarForm of F"]),
            (
                "Soit $P$ un polynôme de degré 3 et $p$ sa forme polaire.",
                vec!["P: Polynomial degree 3", "p: PolarForm of P"],
            ),
            ("设 $f$ 是 $F$ 的极形式。", vec!["f: PolarForm of F"]),
            ("设 $F$ 是 $n$ 次多项式，$f$ 是其极形式。", vec!["F: Polynomial degree n", "f: PolarForm of F"]),
            ("The curve is drawn in $t$.", vec![]),
        ] {
            let found = said(page);
            if found != wanted {
                wrong.push(format!("{page}\n    {found:?}\n    {wanted:?}"));
            }
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}
