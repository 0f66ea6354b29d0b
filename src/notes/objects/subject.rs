//! The names that a phrase speaks of.

use super::super::speech::Word;
use super::Reader;
use super::tokens::Token;
use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, bases};

impl Reader<'_> {
    /// The formulas right before a token that a phrase can be said of, without values if it is said of `plain`
    /// symbols, and the number of the first one.
    pub(super) fn subjects_before(&self, from: usize, plain: bool) -> Option<(Vec<Expr>, usize)> {
        let mut at = from;
        while let Some(before) = at.checked_sub(1) {
            match &self.tokens[before] {
                Token::Word(Word::Be | Word::Filler | Word::The | Word::Same | Word::Article | Word::Der)
                | Token::Comma => at = before,
                // N sei der B-Spline
                Token::Word(Word::Let)
                    if before.checked_sub(1).is_some_and(|name| self.formula_at(name).is_some()) =>
                {
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
                // "f(a, a, b) is a point" does not say what f is.
                let named = |item: &&Expr| !plain || !matches!(left_side(item).kind, Kind::Apply(..));
                let names: Vec<Expr> = own.iter().filter(named).filter_map(name_in).collect();
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
                Token::Word(
                    Word::Of
                        | Word::On
                        | Word::With
                        | Word::As
                        | Word::Through
                        | Word::Preposition
                        | Word::Degree
                )
            )
        });
        // Mit f bezeichnen wir …
        let called = self.is(at + 1, &Word::Be)
            && at.checked_sub(1).is_some_and(|with| {
                let opens = with.checked_sub(1).map(|before| &self.tokens[before]);
                self.is(with, &Word::With) && matches!(opens, None | Some(Token::Comma | Token::Stop))
            });
        Some((items, first?)).filter(|_| !governed || called)
    }

    /// "Let B_i^n be the derivatives of the Bernstein polynomials": the names that something else is called by, which is made
    /// of what a phrase speaks of, with the words for it.
    pub(super) fn made_of(&self, object: &Object, from: usize) -> Option<(Vec<Expr>, usize, String)> {
        if !matches!(object.sort, Sort::Bernstein | Sort::BSpline) || !object.names.is_empty() {
            return None;
        }
        let of = from.checked_sub(1).filter(|&of| self.is(of, &Word::Of) || self.is(of, &Word::Der))?;
        let Token::Unknown(words) = self.tokens.get(of.checked_sub(1)?)? else { return None };
        let (names, number) = self.subjects_before(of - 1, false)?;
        Some((names, number, words.clone()))
    }

    /// "Write f for its blossom"
    pub(super) fn subject_of_notation(&self, from: usize) -> Option<(Vec<Expr>, usize)> {
        let name = from.checked_sub(2).filter(|_| self.is(from - 1, &Word::On))?;
        let mut number = self.formula_at(name)?;
        let mut said = self.said(number).to_vec();
        // "Write f and g for the blossoms"
        let mut first = name;
        while let Some(gap) = first.checked_sub(2)
            && (self.is(first - 1, &Word::And) || matches!(self.tokens[first - 1], Token::Comma))
            && let Some(more) = self.formula_at(gap)
            && !self.said(more).iter().any(|item| matches!(item.kind, Kind::Chain(..)))
        {
            (first, number) = (gap, more);
            said.splice(0..0, self.said(more).iter().cloned());
        }
        let before = first.checked_sub(1).map(|before| &self.tokens[before]);
        let opens = matches!(
            before,
            None | Some(
                Token::Comma
                    | Token::Stop
                    | Token::Word(Word::Filler | Word::The | Word::Same | Word::Let | Word::And)
            )
        );
        let items: Vec<Expr> = said.iter().filter_map(name_in).collect();
        (opens && items.len() == said.len()).then_some((items, number))
    }

    /// 设 s 是节点 x_i 上的三次样条: what begins the clause is what its last noun says.
    pub(super) fn subject_of_clause(&self, from: usize) -> Option<(Vec<Expr>, usize)> {
        let owned = from.checked_sub(1).is_some_and(|before| self.is(before, &Word::Owns));
        let start = (0..from).rev().take_while(|&at| !matches!(self.tokens[at], Token::Comma)).last()?;
        let be = (start..from).find(|&at| self.is(at, &Word::Be)).filter(|_| owned)?;
        let number = be.checked_sub(1).and_then(|before| self.formula_at(before))?;
        let items: Vec<Expr> = self.said(number).iter().filter_map(name_in).collect();
        (items.len() == 1).then_some((items, number))
    }

    /// "denoted by f"
    pub(super) fn subject_after(&self, to: usize) -> Option<(Vec<Expr>, usize)> {
        let at = self.skip_fillers(to);
        // "The blossom of F, taken as a cubic, is f(u, v, w) = …"
        let comma = matches!(self.tokens.get(at), Some(Token::Comma))
            && (self.is(at + 1, &Word::Be) || self.is(at + 1, &Word::By));
        let at = at + usize::from(comma);
        // "Seine Polarform sei f"
        let by = self.is(at, &Word::By) || self.is(at, &Word::Be) || at == to && self.is(at, &Word::Let);
        let number = self.formula_at(self.skip_fillers(at + 1)).filter(|_| by)?;
        // "The curve is x(t) = …, w(t) = …" says what x is.
        let said = self.said(number);
        let equation = matches!(said.first(), Some(Expr { kind: Kind::Chain(..), .. }));
        // "A curve is x(t) = Σ b_i B_i^n(t), B_i^n(t) = …", in whatever order these are read
        let usual = |item: &&Expr| Head::of(left_side(item)).is_some_and(|head| head.notation().is_some());
        let first = said.iter().position(|item| !usual(&item)).unwrap_or(0);
        let said = if equation { &said[first..=first] } else { said };
        let mut items: Vec<Expr> = said.iter().filter_map(name_in).collect();
        // "The blossoms are f and g"
        if !equation {
            let (listed, _) = self.list(self.skip_fillers(at + 1));
            let names: Vec<Expr> = listed.iter().filter_map(name_in).collect();
            if names.len() == listed.len() && listed.iter().all(|item| !matches!(item.kind, Kind::Chain(..)))
            {
                items = names;
            }
        }
        (!items.is_empty()).then_some((items, number))
    }

    /// "Let G be a group": what a noun that is not known here says of names.
    pub(super) fn unknown_sort(&mut self, at: usize) {
        let start = self.skip_fillers(at + 1);
        let (items, mut end) = self.list(start);
        let names: Vec<Expr> =
            items.iter().filter(|item| matches!(item.kind, Kind::Name(_))).cloned().collect();
        let Some(number) = self.formula_at(start).filter(|_| !names.is_empty() && names.len() == items.len())
        else {
            return;
        };
        let mut article = false;
        while let Some(Token::Word(
            word @ (Word::Be | Word::Filler | Word::The | Word::Same | Word::Article),
        )) = self.tokens.get(end)
        {
            article |= *word == Word::Article;
            end += 1;
        }
        if let (true, Some(Token::Unknown(words))) = (article, self.tokens.get(end))
            && !matches!(self.tokens.get(end + 1), Some(Token::Word(Word::Noun(_))))
        {
            let sort = Sort::Other(words.clone().into());
            self.found.entry(number).or_default().push(Object { names, ..Object::new(sort) });
        }
    }
}

/// The left side of an equation, or a formula alone.
pub(super) fn left_side(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Chain(left, links) if matches!(links[0].rel, Rel::Eq | Rel::Define | Rel::In | Rel::Colon) => {
            left.as_ref()
        }
        _ => expr,
    }
}

/// A name, or a function at variables, on the left of an equation or alone.
pub(super) fn subject(expr: &Expr) -> Option<Expr> {
    let name = left_side(expr);
    let plain = |argument: &&Expr| {
        Head::of(argument).is_some_and(|head| head.arguments.is_none()) || argument.kind == Kind::Ellipsis
    };
    let whole = |argument: &&Expr| !matches!(argument.kind, Kind::Number(_)) && plain(argument);
    // P_{i, …, k} is no member of a family with a fixed number of indices.
    let dots = |head: &Head| head.lower.iter().any(|index| index.kind == Kind::Ellipsis);
    Head::of(name).filter(|head| head.flat().iter().all(whole) && !dots(head)).map(|_| name.clone())
}

pub(super) fn name_in(expr: &Expr) -> Option<Expr> {
    if expr.kind == Kind::Ellipsis {
        return Some(expr.clone());
    }
    subject(expr).map(|name| named(&name))
}

/// A name without its arguments.
pub(super) fn named(expr: &Expr) -> Expr {
    match &expr.kind {
        Kind::Apply(callee, _) => callee.as_ref().clone(),
        _ => expr.clone(),
    }
}

/// The ends of an interval.
pub(super) fn ends(items: &[Expr]) -> Option<(Expr, Expr)> {
    let [one] = items else { return None };
    let ([from, to], _) = interval(one)?;
    Some((from.clone(), to.clone()))
}

/// Whether a formula is a sum, a product, a composition or a derivative of functions with capital letters: F + G, F'.
pub(super) fn is_made_of_functions(expr: &Expr) -> bool {
    let capitals = bases(expr).iter().all(|name| name.starts_with(char::is_uppercase));
    let made = match &expr.kind {
        Kind::Prime(..) | Kind::Compose(_) => true,
        Kind::Add(terms) => terms.len() > 1,
        Kind::Mul(factors) => factors.len() > 1,
        _ => false,
    };
    made && capitals && !expr.has(&|part| matches!(part.kind, Kind::Number(_) | Kind::Subscript(..)))
}
