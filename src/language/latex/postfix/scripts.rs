//! Subscripts, superscripts and primes behind a base.

use super::super::characters::raised;
use super::super::commands::Role;
use super::super::forms::is_transposed;
use super::super::reader::{Reader, Result, Window};
use super::super::token::{Fence, Tok};
use crate::formula::source::{Pieces, Span};
use crate::formula::{BinomialStyle, Expr, Kind, Link, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::families::is_binomial_coefficient;
use crate::language::lexicon::roles::is_power_of_sum;
use crate::language::syntax::truncated::{may_be_truncated, truncated};
use crate::math::number::parse_decimal;

/// What a superscript means.
enum Raise {
    Nothing,
    Power(Expr),
    Upper(Vec<Expr>),
    /// In round brackets: the number of a name, the order of a derivative, or else an exponent.
    Round(Expr, Span),
    Prime(u32),
    Transpose,
}

/// What was collected behind a base.
#[derive(Default)]
struct Scripts {
    lower: Option<Vec<Expr>>,
    upper: Option<Raise>,
    primes: u32,
    /// Whether + stands below: a truncated power.
    positive: bool,
}

impl Scripts {
    fn add(&mut self, raise: Raise) {
        match raise {
            Raise::Nothing => {}
            Raise::Prime(count) => self.primes = self.primes.saturating_add(count),
            raise => self.upper = Some(raise),
        }
    }
}

impl Reader<'_> {
    /// A run of scripts and primes in any order; applied as subscript, primes, superscript.
    pub fn scripts(&mut self, base: Expr, start: usize, first: usize) -> Result<Expr> {
        let scripts = self.script_run(may_be_truncated(&base))?;
        Ok(self.attached(base, scripts, start, first))
    }

    fn script_run(&mut self, truncatable: bool) -> Result<Scripts> {
        let mut scripts = Scripts::default();
        while let Some(kind) = self.peek() {
            match kind {
                Tok::Sub | Tok::Raised(false) if scripts.lower.is_some() => {
                    return Err(self.doubled("subscript"));
                }
                Tok::Sup | Tok::Raised(true) if scripts.upper.is_some() => {
                    return Err(self.doubled("superscript"));
                }
                Tok::Sub => {
                    self.bump();
                    if truncatable && self.positive_part() {
                        scripts.positive = true;
                        continue;
                    }
                    scripts.lower = Some(self.subscript()?);
                }
                Tok::Raised(false) => {
                    self.bump();
                    scripts.lower = Some(self.raised()?);
                }
                Tok::Sup => {
                    self.bump();
                    let raise = self.superscript()?;
                    scripts.add(raise);
                }
                Tok::Raised(true) => {
                    self.bump();
                    let raise = self.raised_power()?;
                    scripts.add(raise);
                }
                Tok::Prime(count) if scripts.upper.is_none() => {
                    self.bump();
                    scripts.add(Raise::Prime(count));
                }
                _ => break,
            }
        }
        Ok(scripts)
    }

    fn attached(&self, base: Expr, scripts: Scripts, start: usize, first: usize) -> Expr {
        let Scripts { lower, upper, primes, positive } = scripts;
        if let (true, None | Some(Raise::Nothing | Raise::Power(_))) = (positive, &upper) {
            let exponent = match upper {
                Some(Raise::Power(exponent)) => Some(exponent),
                _ => None,
            };
            return self.node(truncated(base, exponent), start);
        }
        let square = matches!(self.tokens[first].kind, Tok::Open(Fence::Square) | Tok::Left(Fence::Square));
        // [ t^2 (1 - t) ]_{t = 1/3}
        if upper.is_none()
            && primes == 0
            && matches!(base.kind, Kind::Group(_))
            && let Some([Expr { kind: Kind::Chain(place, links), .. }]) = lower.as_deref()
            && matches!(place.kind, Kind::Name(_))
            && matches!(links.as_slice(), [Link { rel: Rel::Eq, .. }])
        {
            let kind = Kind::At { body: Box::new(base), lower: lower.unwrap_or_default(), upper: None };
            return self.node(kind, start);
        }
        let (lower, upper) = match (lower, upper) {
            (Some(mut lower), Some(Raise::Power(above))) if primes == 0 => {
                if is_binomial_coefficient(&base, &lower, &above) {
                    let below = Box::new(lower.swap_remove(0));
                    let kind = Kind::Binomial(below, Box::new(above), BinomialStyle::Subscripted);
                    return self.node(kind, start);
                }
                if square && matches!(base.kind, Kind::Group(_)) {
                    let kind = Kind::At { body: Box::new(base), lower, upper: Some(Box::new(above)) };
                    return self.node(kind, start);
                }
                (Some(lower), Some(Raise::Power(above)))
            }
            other => other,
        };
        let mut expr = base;
        if let Some(indices) = lower
            && !indices.is_empty()
        {
            expr = self.node(Kind::Subscript(Box::new(expr), indices), start);
        }
        if primes > 0 {
            expr = self.node(Kind::Prime(Box::new(expr), primes), start);
        }
        match upper {
            None | Some(Raise::Nothing | Raise::Prime(_)) => expr,
            Some(Raise::Power(exponent)) if is_transposed(&expr, &exponent) => {
                self.node(Kind::Transpose(Box::new(expr)), start)
            }
            Some(Raise::Power(exponent)) => self.node(Kind::Pow(Box::new(expr), Box::new(exponent)), start),
            Some(Raise::Upper(indices)) => self.node(Kind::Upper(Box::new(expr), indices), start),
            Some(Raise::Round(inner, span)) if is_power_of_sum(&expr, &inner) => {
                let exponent = Expr::new(Kind::Group(Box::new(inner)), span);
                self.node(Kind::Pow(Box::new(expr), Box::new(exponent)), start)
            }
            Some(Raise::Round(index, _)) => self.node(Kind::Upper(Box::new(expr), vec![index]), start),
            Some(Raise::Transpose) => self.node(Kind::Transpose(Box::new(expr)), start),
        }
    }

    fn doubled(&mut self, what: &str) -> Box<Diagnostic> {
        let problem = Diagnostic::error(Code::UnexpectedToken, format!("a second {what}"))
            .at(self.span_at(self.pos))
            .hint(format!(
                "put both into one pair of braces, or braces around the first {what} and its base"
            ));
        Box::new(problem)
    }

    /// What stands after `_`: indices with commas between.
    pub fn subscript(&mut self) -> Result<Vec<Expr>> {
        self.peek();
        if let Some(sign) = self.sign_in(self.pos..self.pos + 1) {
            self.bump();
            return Ok(vec![sign]);
        }
        if self.peek() != Some(Tok::OpenBrace) {
            self.is_one_digit("an index", '_')?;
            return Ok(vec![self.argument()?]);
        }
        let window = self.inside(self.pos)?;
        // \mathbb{R}_{+}
        if let Some(sign) = self.sign_in(self.trim(window.clone())) {
            self.pos = window.end + 1;
            return Ok(vec![sign]);
        }
        let indices = self.indices_in(window.clone())?;
        self.pos = window.end + 1;
        Ok(indices)
    }

    /// A lone sign as an index: the + of the positive numbers, the − of the value on the left.
    fn sign_in(&self, window: Window) -> Option<Expr> {
        let name = match self.tokens.get(window.start).filter(|_| window.len() == 1)?.kind {
            Tok::Plus => "plus",
            Tok::Minus => "minus",
            _ => return None,
        };
        Some(Expr::new(Kind::Name(name.to_owned()), self.span_of(window)))
    }

    fn indices_in(&mut self, window: Window) -> Result<Vec<Expr>> {
        let window = self.trim(window);
        if window.is_empty() {
            return Ok(Vec::new());
        }
        let kinds = || window.clone().map(|at| self.tokens[at].kind);
        let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        if kinds().all(|kind| kind == Tok::Number || kind == Tok::Skip) {
            // also spaced, as in `b _ { 0 1 }`
            let numerals = window.clone().filter(|&at| self.tokens[at].kind == Tok::Number);
            let joined: String = numerals.map(|at| self.text_at(at)).collect();
            if window.len() > 1 && digits(&joined) && joined.len() < 20 {
                let span = self.span_of(window);
                return Ok(vec![index_of_digits(&joined, span)]);
            }
        }
        let mut indices = self.list_in(window)?;
        for index in &mut indices {
            let text = self.text.piece(index.span.range());
            if matches!(index.kind, Kind::Number(_))
                && text.len() > 1
                && text.starts_with('0')
                && digits(text)
            {
                index.kind = Kind::Name(text.to_owned());
            }
        }
        Ok(indices)
    }

    /// What stands after `^`.
    fn superscript(&mut self) -> Result<Raise> {
        match self.peek() {
            Some(Tok::OpenBrace) => {
                let window = self.inside(self.pos)?;
                let raise = self.raise_in(window.clone())?;
                self.pos = window.end + 1;
                Ok(raise)
            }
            Some(
                Tok::Star
                | Tok::Plus
                | Tok::Minus
                | Tok::Circ
                | Tok::Prime(_)
                | Tok::Symbol("top")
                | Tok::Word(..),
            ) => {
                let at = self.pos;
                self.pos += 1;
                self.raise_in(at..at + 1)
            }
            _ => {
                self.is_one_digit("an exponent", '^')?;
                Ok(Raise::Power(self.argument()?))
            }
        }
    }

    /// Refuses t^10, which TeX prints as t^1 0 and everybody means as t^{10}.
    fn is_one_digit(&mut self, script: &str, sign: char) -> Result<()> {
        if self.peek() != Some(Tok::Number) {
            return Ok(());
        }
        let (span, text) = (self.tokens[self.pos].span(), self.text_at(self.pos));
        if text.len() < 2 || !text.bytes().all(|byte| byte.is_ascii_digit()) {
            return Ok(());
        }
        let (first, rest) = text.split_at(1);
        Err(Box::new(
            Diagnostic::error(Code::AmbiguousProduct, format!("{script} of several digits needs braces"))
                .at(span)
                .reason(format!("TeX takes the {first} only"))
                .hint(format!(
                    "write {sign}{{{text}}} for the whole number, {sign}{first} {rest} for the product"
                )),
        ))
    }

    fn raise_in(&mut self, window: Window) -> Result<Raise> {
        let window = self.trim(window);
        if let Some(raise) = self.raise_of_signs(window.clone()) {
            return Ok(raise);
        }
        // f^{(k)}, the step of a scheme: c^{[0]}, a value k times: f(t^{⟨k⟩}, 1)
        if self.is_bracket(window.clone()) {
            let inner = self.trim(window.start + 1..window.end - 1);
            // x^{(+)}
            if let Some(sign) = self.sign_in(inner) {
                return Ok(Raise::Upper(vec![sign]));
            }
            let round = self.tokens[window.start].kind == Tok::Open(Fence::Paren);
            let span = self.span_of(window.clone());
            let mut list = self.list_in(window.start + 1..window.end - 1)?;
            let one = round && list.len() == 1;
            return Ok(if one { Raise::Round(list.swap_remove(0), span) } else { Raise::Upper(list) });
        }
        let mut list = self.list_in(window)?;
        Ok(if list.len() == 1 { Raise::Power(list.swap_remove(0)) } else { Raise::Upper(list) })
    }

    /// Whether a window is one round, square or angle bracket from end to end.
    fn is_bracket(&self, window: Window) -> bool {
        let (Tok::Open(fence) | Tok::Left(fence)) = self.tokens[window.start].kind else { return false };
        matches!(fence, Fence::Paren | Fence::Square | Fence::Angle) && self.after(window.start) == window.end
    }

    /// Superscripts that are signs rather than expressions: primes, stars, the T of a transpose.
    fn raise_of_signs(&self, window: Window) -> Option<Raise> {
        let kinds: Vec<Tok> = window.clone().take(3).map(|at| self.tokens[at].kind).collect();
        let name = |name: &str| {
            Some(Raise::Power(Expr::new(Kind::Name(name.to_owned()), self.span_of(window.clone()))))
        };
        match kinds.as_slice() {
            [] => return Some(Raise::Nothing),
            [Tok::Star] => return name("ast"),
            [Tok::Plus] => return name("plus"),
            [Tok::Minus] => return name("minus"),
            [Tok::Circ] => return name("circ"),
            [Tok::Symbol("top")] | [Tok::Command(Role::Switch(_)), Tok::Letter('T')] => {
                return Some(Raise::Transpose);
            }
            [Tok::Word(start, end)] | [Tok::Text(start, end)]
                if self.text.piece(*start as usize..*end as usize).trim() == "T" =>
            {
                return Some(Raise::Transpose);
            }
            _ => {}
        }
        let mut primes = 0_u32;
        for at in window {
            match self.tokens[at].kind {
                Tok::Prime(count) => primes = primes.saturating_add(count),
                Tok::Skip => {}
                _ => return None,
            }
        }
        Some(Raise::Prime(primes))
    }

    /// Unicode scripts just taken: `₁₂`, `ⁿ⁺¹`.
    pub fn raised(&mut self) -> Result<Vec<Expr>> {
        let span = self.here_before();
        let plain: String =
            self.text.piece(span.range()).chars().filter_map(raised).map(|(_, plain)| plain).collect();
        if plain.len() > 1 && plain.starts_with('0') && plain.bytes().all(|byte| byte.is_ascii_digit()) {
            return Ok(vec![index_of_digits(&plain, span)]);
        }
        let mut inner = Reader::new(&plain, Span::new(0, plain.len()), false);
        inner.depth = self.depth;
        let mut items = inner.list_in(0..inner.end).map_err(|problem| {
            let mut problem = *problem;
            problem.span = Some(span);
            problem.labels.clear();
            Box::new(problem)
        })?;
        fn place(expr: &mut Expr, span: Span) {
            expr.span = span;
            if let Kind::Chain(_, links) = &mut expr.kind {
                links.iter_mut().for_each(|link| link.span = span);
            }
            expr.for_each_child_mut(&mut |child| place(child, span));
        }
        items.iter_mut().for_each(|item| place(item, span));
        Ok(items)
    }

    fn raised_power(&mut self) -> Result<Raise> {
        let text = self.text.piece(self.here_before().range());
        let in_brackets = text.starts_with('⁽') && text.ends_with('⁾');
        let mut list = self.raised()?;
        if in_brackets
            && let [Expr { kind: Kind::Group(_), span }] = list.as_slice()
            && let (span, Kind::Group(inner)) = (*span, list.remove(0).kind)
        {
            return Ok(Raise::Round(*inner, span));
        }
        Ok(if list.len() == 1 { Raise::Power(list.remove(0)) } else { Raise::Upper(list) })
    }

    /// The token last taken.
    fn here_before(&self) -> Span {
        self.span_at(self.pos.saturating_sub(1))
    }
}

/// `01` is a name, `12` a number.
fn index_of_digits(digits: &str, span: Span) -> Expr {
    match parse_decimal(digits) {
        Ok(value) if !digits.starts_with('0') || digits.len() == 1 => Expr::new(Kind::Number(value), span),
        _ => Expr::new(Kind::Name(digits.to_owned()), span),
    }
}
