//! Indices: `t_1`, `p_{i,j}`, `b[0]`.

use super::super::chars;
use super::super::token::{Bracket, TokenKind};
use super::super::truncated::{may_be_truncated, truncated};
use super::operand::{Items, is_named, is_number};
use super::{MAX_DEPTH, Node, Parsed, Parser};
use crate::formula::source::{Pieces, Span};
use crate::formula::{Expr, Kind};

impl Parser<'_> {
    /// Whether square brackets that open here, without a blank, hold indices: `b[0]`, `M[1,2]`. Before a
    /// matrix or a list of points they begin a factor.
    pub(super) fn index_follows(&self, base: &Expr) -> bool {
        let holds = is_named(base) || matches!(base.kind, Kind::Apply(..) | Kind::List(_));
        if !holds || self.peek().spaced {
            return false;
        }
        let mut depth = 0_usize;
        for (at, token) in self.tokens[self.at..].iter().enumerate() {
            match token.kind {
                TokenKind::Open(Bracket::Square) if at == 1 => return false,
                TokenKind::Open(_) if depth > MAX_DEPTH => return false,
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) if depth <= 1 => return true,
                TokenKind::Close(_) => depth -= 1,
                TokenKind::Semicolon if depth == 1 => return false,
                _ => {}
            }
        }
        false
    }

    /// `b[0]`, of which [`Self::index_follows`] holds: an index that is a list.
    pub(super) fn bracket_index(&mut self, base: Node) -> Parsed<Node> {
        let inside = self.inside(false)?;
        let span = base.extent.to(inside.span());
        let brackets = inside.span();
        let Items { list, height } = self.items(inside, "an index")?;
        // f[x_, y_] := x^2 + y
        let parameter = |item: &Expr| {
            matches!(item.kind, Kind::Name(_)) && self.text.piece(item.span.end..).starts_with('_')
        };
        if list.iter().all(parameter) {
            let height = height.max(base.height);
            return self.node(Kind::Apply(Box::new(base.expr), vec![list]), span, height);
        }
        let list = Expr::new(Kind::List(list), brackets);
        self.node(Kind::Subscript(Box::new(base.expr), vec![list]), span, height.max(base.height) + 1)
    }

    /// The index after a name or an underscore.
    pub(super) fn subscript(&mut self, base: Node) -> Parsed<Node> {
        if self.positive_part_follows(&base.expr) {
            return self.positive_part(base);
        }
        match &base.expr.kind {
            Kind::Subscript(_, indices)
                if !matches!(indices.as_slice(), [Expr { kind: Kind::List(_), .. }]) =>
            {
                return Err(self.double_index(&base, self.peek()));
            }
            Kind::Number(_) | Kind::Ellipsis | Kind::Text(_) => return Err(self.no_index(&base)),
            _ => {}
        }
        if self.peek().kind == TokenKind::Underscore {
            self.bump();
            // f[t_] := t^2
            let pattern = matches!(self.peek().kind, TokenKind::Close(Bracket::Square) | TokenKind::Comma);
            if pattern && self.open.last().is_some_and(|open| open.kind == TokenKind::Open(Bracket::Square)) {
                return Ok(base);
            }
        }
        let (indices, end) = match self.peek().kind {
            TokenKind::Open(Bracket::Brace | Bracket::Paren | Bracket::Sub) => self.indices()?,
            _ => self.plain_index()?,
        };
        self.indexed(base, indices, end)
    }

    /// Whether `_+` follows, with nothing after it that is added.
    fn positive_part_follows(&self, base: &Expr) -> bool {
        let kind = |ahead: usize| self.tokens.get(self.at + ahead).map(|token| token.kind);
        kind(0) == Some(TokenKind::Underscore)
            && kind(1) == Some(TokenKind::Plus)
            && !matches!(kind(2), Some(TokenKind::Name | TokenKind::Number | TokenKind::Index))
            && may_be_truncated(base)
    }

    /// The truncated power `(t - 1)_+^2`.
    fn positive_part(&mut self, base: Node) -> Parsed<Node> {
        self.bump();
        let plus = self.bump();
        let mut span = base.extent.to(plus.span());
        let mut height = base.height;
        let exponent = match self.peek().kind {
            TokenKind::Caret => {
                self.bump();
                Some(self.exponent()?)
            }
            TokenKind::Open(Bracket::Sup) => return Err(self.missing_index()),
            _ => None,
        };
        if let Some(exponent) = &exponent {
            span = span.to(exponent.extent);
            height = height.max(exponent.height);
        }
        self.node(truncated(base.expr, exponent.map(|node| node.expr)), span, height + 2)
    }

    /// Indices in brackets.
    fn indices(&mut self) -> Parsed<(Items, Span)> {
        let inside = self.inside(false)?;
        let span = inside.span();
        Ok((self.items(inside, "an index")?, span))
    }

    /// An index of digits or letters, the letters perhaps with digits of their own.
    fn plain_index(&mut self) -> Parsed<(Items, Span)> {
        let token = self.peek();
        let mut index = match token.kind {
            TokenKind::Index | TokenKind::Number => self.numeral()?,
            TokenKind::Name => {
                self.bump();
                self.name(token)?
            }
            TokenKind::BadNumber => return Err(self.bad_number(token)),
            _ => return Err(self.missing_index()),
        };
        if token.kind == TokenKind::Name && self.peek().kind == TokenKind::Index {
            let (digits, end) = self.plain_index()?;
            index = self.indexed(index, digits, end)?;
        }
        let span = index.extent;
        let mut items = Items::default();
        items.push(index);
        Ok((items, span))
    }

    fn indexed(&self, base: Node, mut indices: Items, end: Span) -> Parsed<Node> {
        for index in &mut indices.list {
            self.keep_leading_zero(index);
        }
        let height = base.height.max(indices.height);
        let kind = Kind::Subscript(Box::new(base.expr), indices.list);
        self.node(kind, base.extent.to(end), height)
    }

    /// The index 01 is a name: it differs from 1.
    fn keep_leading_zero(&self, index: &mut Expr) {
        let text = self.text.piece(index.span.range());
        let first = text.chars().next().map(chars::ordinary);
        if is_number(index) && first == Some('0') && text.chars().nth(1).is_some() && !text.contains('.') {
            index.kind = Kind::Name(text.chars().map(chars::ordinary).collect());
        }
    }
}
