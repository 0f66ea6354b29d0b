//! Brackets: groups, tuples, lists, sets, intervals, values at a point.

use super::reader::{Reader, Result, Window};
use super::token::{Env, Fence, Tok};
use crate::formula::source::Span;
use crate::formula::{Delimiter, Enclosure, Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};

impl Reader<'_> {
    /// A bracket that opens here, with its content and its partner.
    pub fn bracket(&mut self) -> Result<Expr> {
        let at = self.pos;
        let window = self.inside(at)?;
        let close = window.end;
        let result = match (fence(self.tokens[at].kind), fence(self.tokens[close].kind)) {
            (Fence::Paren, Fence::Paren) => self.round(window),
            (Fence::Square, Fence::Square) => self.square(window),
            (Fence::Curly, Fence::Curly) => self.set(window),
            (Fence::Bar, Fence::Bar) => self.upright_bars(window),
            (Fence::Norm, Fence::Norm) => self.enclosed(window, Enclosure::Norm),
            (Fence::Floor, Fence::Floor) => self.enclosed(window, Enclosure::Floor),
            (Fence::Ceil, Fence::Ceil) => self.enclosed(window, Enclosure::Ceil),
            (Fence::Dot, Fence::Dot) => self.group(window),
            (Fence::Angle, Fence::Angle) => self.called("inner", window, at),
            (Fence::Square, Fence::Paren) => self.interval("rightopen", window, at),
            (Fence::Paren, Fence::Square) => self.interval("leftopen", window, at),
            (Fence::Curly, Fence::Dot) | (Fence::Dot, Fence::Curly) => self.open_ended(window),
            (Fence::Dot, Fence::Bar | Fence::Square) => return self.open_beginning(window),
            _ => Err(self.mismatched(at, close)),
        };
        self.pos = close + 1;
        let start = self.span_at(at).start;
        result.map(|kind| self.node(kind, start))
    }

    fn mismatched(&self, at: usize, close: usize) -> Box<Diagnostic> {
        let problem = Diagnostic::error(Code::Unbalanced, "two brackets of different kinds")
            .at(self.span_at(at))
            .label(self.span_at(close), "it ends here");
        Box::new(problem)
    }

    fn round(&mut self, window: Window) -> Result<Kind> {
        if self.is_table(window.clone()) {
            return self.bracketed_matrix(window, Delimiter::Paren);
        }
        let place = self.span_of(window.clone());
        let mut groups = self.groups_in(window)?;
        if groups.len() > 1 {
            return Ok(Kind::Tuple(groups.into_iter().map(|items| sequence(items, place)).collect()));
        }
        let mut items = groups.swap_remove(0);
        Ok(if items.len() == 1 { Kind::Group(Box::new(items.swap_remove(0))) } else { Kind::Tuple(items) })
    }

    fn square(&mut self, window: Window) -> Result<Kind> {
        if self.is_table(window.clone()) {
            return self.bracketed_matrix(window, Delimiter::Bracket);
        }
        if self.is_blank(window.clone()) {
            return Ok(Kind::List(Vec::new()));
        }
        // [1, 2; 3, 4], as in the plain notation
        let rows = self.split(window.clone(), |kind| kind == Tok::Semicolon);
        if self.query && rows.len() > 1 {
            let rows = rows.into_iter().filter(|row| !self.is_blank(row.clone())).collect::<Vec<_>>();
            let row = |row: Window| Ok(self.list_in(row)?.into_iter().map(Some).collect());
            let rows = rows.into_iter().map(row).collect::<Result<_>>()?;
            return Ok(Kind::Matrix(rows, Delimiter::Bracket));
        }
        // [a_0; a_1, a_2]: a continued fraction, an interval, a matrix, which only the page knows
        if rows.len() > 1 {
            let callee = Expr::new(Kind::Name("semicolons".to_owned()), self.span_of(window.clone()));
            return Ok(Kind::Apply(Box::new(callee), self.groups_in(window)?));
        }
        let mut items = self.list_in(window)?;
        Ok(if items.len() == 1 { Kind::Group(Box::new(items.swap_remove(0))) } else { Kind::List(items) })
    }

    fn upright_bars(&mut self, window: Window) -> Result<Kind> {
        if self.is_table(window.clone()) {
            return self.bracketed_matrix(window, Delimiter::Bar);
        }
        self.enclosed(window, Enclosure::Abs)
    }

    fn enclosed(&mut self, window: Window, enclosure: Enclosure) -> Result<Kind> {
        let body = self.expr_in(window)?;
        Ok(Kind::Enclosed(enclosure, Box::new(body)))
    }

    fn group(&mut self, window: Window) -> Result<Kind> {
        let body = self.expr_in(window)?;
        Ok(Kind::Group(Box::new(body)))
    }

    /// Brackets that stand for a function.
    fn called(&mut self, name: &str, window: Window, at: usize) -> Result<Kind> {
        let items = self.list_in(window)?;
        let callee = Expr::new(Kind::Name(name.to_owned()), self.span_at(at));
        Ok(Kind::Apply(Box::new(callee), vec![items]))
    }

    /// `[a, b)`
    fn interval(&mut self, name: &str, window: Window, at: usize) -> Result<Kind> {
        if self.split(window.clone(), |kind| kind == Tok::Comma).len() != 2 {
            let problem = *self.mismatched(at, window.end);
            return Err(Box::new(problem.reason("only an interval with two ends is written so")));
        }
        self.called(name, window, at)
    }

    /// `\left\{ … \right.`: cases, or equations.
    fn open_ended(&mut self, window: Window) -> Result<Kind> {
        let inner = self.trim(window.clone());
        let is_table = inner
            .clone()
            .next()
            .is_some_and(|at| matches!(self.tokens[at].kind, Tok::Begin(_)) && self.after(at) == inner.end);
        let expr = if is_table { self.cases(inner.start + 1..inner.end - 1)? } else { self.row_in(window)? };
        Ok(expr.kind)
    }

    /// `\left. F \right|_{t=0}`, `\left. F \right]_a^b`
    fn open_beginning(&mut self, window: Window) -> Result<Expr> {
        let start = self.span_at(self.pos).start;
        let close = window.end;
        let body = self.expr_in(window)?;
        self.pos = close + 1;
        let is_bar = self.tokens[close].kind == Tok::Right(Fence::Bar);
        if is_bar || matches!(self.peek(), Some(Tok::Sub | Tok::Sup)) {
            return self.evaluated(body, start);
        }
        Ok(self.node(Kind::Group(Box::new(body)), start))
    }

    /// The matrix that fills the window, with the brackets around it.
    fn bracketed_matrix(&mut self, window: Window, around: Delimiter) -> Result<Kind> {
        let inner = self.trim(window.clone());
        if let Tok::Begin(Env::Matrix(Delimiter::None) | Env::Array) = self.tokens[inner.start].kind {
            let rows = self.matrix_rows(inner.start + 1..inner.end - 1)?;
            return Ok(Kind::Matrix(rows, around));
        }
        if around == Delimiter::Bar {
            return self.enclosed(window, Enclosure::Abs);
        }
        self.group(window)
    }

    /// `{a, b}` or `{x | condition}`; one sum in braces is a group.
    fn set(&mut self, window: Window) -> Result<Kind> {
        self.separate_rows(window.clone());
        if self.is_blank(window.clone()) {
            return Ok(Kind::Set(Vec::new(), None));
        }
        let (mut items, condition) = self.within(window, Self::set_content)?;
        let is_group = condition.is_none()
            && matches!(items.as_slice(), [Expr { kind: Kind::Add(terms), .. }] if terms.len() > 1);
        if is_group {
            return Ok(Kind::Group(Box::new(items.swap_remove(0))));
        }
        Ok(Kind::Set(items, condition))
    }

    fn set_content(&mut self) -> Result<(Vec<Expr>, Option<Box<Expr>>)> {
        self.in_set = true;
        let items = self.items()?;
        if !matches!(self.peek(), Some(Tok::Bar | Tok::Mid | Tok::Rel(Rel::Colon))) {
            return Ok((items, None));
        }
        self.bump();
        self.in_set = false;
        let condition = self.content()?;
        Ok((items, Some(Box::new(condition))))
    }

    /// The `>` of `<f, g>`, as some write ⟨f, g⟩, if the `<` at `at` is meant so.
    pub fn angle_end(&self, at: usize) -> Option<usize> {
        let close = (at + 1..self.end).find(|&i| matches!(self.tokens[i].kind, Tok::Rel(_)))?;
        let is_end = self.tokens[close].kind == Tok::Rel(Rel::Gt)
            && self.split(at + 1..close, |kind| kind == Tok::Comma).len() == 2;
        is_end.then_some(close)
    }

    /// `<f, g>`
    pub fn angle(&mut self) -> Result<Expr> {
        let at = self.pos;
        let Some(close) = self.angle_end(at) else { return self.stuck() };
        let kind = self.called("inner", at + 1..close, at)?;
        self.pos = close + 1;
        Ok(self.node(kind, self.span_at(at).start))
    }

    /// The bounds behind a bar of evaluation that was just taken.
    pub fn evaluated(&mut self, body: Expr, start: usize) -> Result<Expr> {
        let bar = self.here();
        let (lower, upper) = self.bounds()?;
        if lower.is_empty() && upper.is_none() {
            let problem = Diagnostic::error(Code::UnexpectedEnd, "a bar without the point of evaluation")
                .at(bar)
                .hint("write \\right|_{t=0}");
            return Err(Box::new(problem));
        }
        let kind = Kind::At { body: Box::new(body), lower, upper: upper.map(Box::new) };
        Ok(self.node(kind, start))
    }
}

/// The shape of a bracket.
fn fence(kind: Tok) -> Fence {
    match kind {
        Tok::Open(fence) | Tok::Close(fence) | Tok::Left(fence) | Tok::Right(fence) => fence,
        _ => Fence::Dot,
    }
}

/// A group of arguments as one expression; without any it stands at `place`.
fn sequence(mut items: Vec<Expr>, place: Span) -> Expr {
    match items.as_slice() {
        [_] => items.swap_remove(0),
        [first, .., last] => {
            let span = first.span.to(last.span);
            Expr::new(Kind::Sequence(items), span)
        }
        [] => Expr::new(Kind::Sequence(items), place),
    }
}
