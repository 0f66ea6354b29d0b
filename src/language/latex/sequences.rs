//! Sequences of formulas, relations and ∀; passing over what cannot be read.

use super::commands::{Infix, Role};
use super::reader::{Reader, Result, Window, is_separator};
use super::token::{Fence, Tok};
use crate::formula::source::{Pieces, Span};
use crate::formula::{BinomialStyle, Expr, Kind, Link, Quotient, Rel};
use crate::language::diagnostic::Diagnostic;
use crate::language::syntax::congruence;

impl Reader<'_> {
    /// The two parts around `\over` or `\choose`, if such a command stands in the window.
    pub fn infix(&mut self) -> Result<Option<Expr>> {
        let start = self.start();
        let window = self.pos..self.end;
        let parts = self.split(window, |kind| matches!(kind, Tok::Command(Role::Infix(_))));
        let [left, right] = match <[Window; 2]>::try_from(parts) {
            Ok(parts) => parts,
            Err(parts) if parts.len() < 2 => return Ok(None),
            Err(parts) => return Err(self.unexpected(parts[1].end)),
        };
        let command = self.tokens[left.end].kind;
        let above = self.expr_in(left)?;
        let below = self.expr_in(right)?;
        self.pos = self.end;
        let (above, below) = (Box::new(above), Box::new(below));
        let kind = match command {
            Tok::Command(Role::Infix(Infix::Choose)) => Kind::Binomial(above, below, BinomialStyle::Stacked),
            _ => Kind::Div(above, below, Quotient::Fraction),
        };
        Ok(Some(self.node(kind, start)))
    }

    /// The whole window: formulas and words side by side, or the two parts around `\over`.
    pub fn content(&mut self) -> Result<Expr> {
        let start = self.start();
        let mut items = self.list()?;
        match items.len() {
            0 => Err(self.ended()),
            1 => Ok(items.swap_remove(0)),
            _ => Ok(self.sequence(items, start)),
        }
    }

    fn sequence(&self, items: Vec<Expr>, start: usize) -> Expr {
        let end = items.last().map_or(start, |item| item.span.end);
        Expr::new(Kind::Sequence(items), Span::new(start, end))
    }

    /// Items up to the end of the window, or up to what ends an item here.
    pub fn items(&mut self) -> Result<Vec<Expr>> {
        let mut items = Vec::new();
        loop {
            self.skip_separators(items.is_empty())?;
            let Some(kind) = self.peek() else { return Ok(items) };
            if self.ends_items(kind) {
                return Ok(items);
            }
            let item = match kind {
                Tok::Text(..) | Tok::Command(Role::ForAll) => self.worded_item(kind)?,
                _ => self.item()?,
            };
            let words = matches!(item.kind, Kind::Text(_));
            items.push(item);
            let Some(next) = self.peek() else { return Ok(items) };
            if !(words && self.row || is_separator(next) || self.ends_items(next) || self.begins_item(next)) {
                return self.stuck();
            }
        }
    }

    /// An item that begins with words or ∀.
    fn worded_item(&mut self, kind: Tok) -> Result<Expr> {
        if kind == Tok::Command(Role::ForAll) {
            let (from, start) = (self.pos, self.start());
            return match self.for_all() {
                Err(problem) if self.tolerant => Ok(self.recover(from, start, *problem)),
                result => result,
            };
        }
        if self.row && !self.is_word_atom() { Ok(self.words()) } else { self.item() }
    }

    /// In a row, separators may be doubled, lead and trail; in an argument list they may not.
    fn skip_separators(&mut self, first: bool) -> Result<()> {
        let mut seen = first;
        while let Some(kind) = self.peek() {
            let stray_colon = self.row && first && kind == Tok::Rel(Rel::Colon);
            if !is_separator(kind) && !stray_colon {
                break;
            }
            if kind == Tok::Semicolon && !self.row {
                break; // ends a group of arguments
            }
            if !self.row && (kind == Tok::Period || std::mem::replace(&mut seen, true)) {
                return self.stuck();
            }
            self.bump();
        }
        // a list in brackets may not end with a comma
        if !self.row && !first && seen && self.peek().is_none() {
            return Err(self.ended());
        }
        Ok(())
    }

    /// What ends the items of this window without being their separator.
    fn ends_items(&self, kind: Tok) -> bool {
        match kind {
            Tok::Semicolon => !self.row,
            Tok::Bar => self.in_set,
            Tok::Mid => self.in_set || !self.row,
            Tok::Rel(Rel::Colon) => self.in_set || self.colon_ends,
            _ => false,
        }
    }

    /// What may follow an item of a row without a separator.
    fn begins_item(&self, kind: Tok) -> bool {
        self.row
            && match kind {
                Tok::Text(..) | Tok::Command(Role::ForAll) => true,
                _ => self.is_condition(),
            }
    }

    /// Whether a bracket with a relation in it comes next: a condition such as `(i = 1, …, n)`. One that a relation
    /// follows, or that touches a letter without an index, is an argument: P(Z ≥ 1) = 1/2.
    pub fn is_condition(&self) -> bool {
        let Some(token) = self.tokens.get(self.pos) else { return false };
        token.relation
            && matches!(token.kind, Tok::Open(Fence::Paren) | Tok::Left(Fence::Paren))
            && !matches!(self.look(self.after(self.pos)), Some((_, Tok::Rel(_))))
            && !self.touches_letter(token.span().start)
    }

    /// Whether a letter that is no index ends where the next token begins.
    fn touches_letter(&self, at: usize) -> bool {
        let before = |back: usize| self.pos.checked_sub(back).map(|at| &self.tokens[at]);
        let letter =
            before(1).is_some_and(|token| matches!(token.kind, Tok::Letter(_)) && token.span().end == at);
        letter && !before(2).is_some_and(|token| matches!(token.kind, Tok::Sub | Tok::Sup))
    }

    fn words(&mut self) -> Expr {
        let span = self.bump();
        let Tok::Text(start, end) = self.tokens[self.pos - 1].kind else {
            return Expr::new(Kind::Text(String::new()), span);
        };
        let content = self.text.piece(start as usize..end as usize);
        Expr::new(Kind::Text(content.split_whitespace().collect::<Vec<_>>().join(" ")), span)
    }

    /// One item: relations, joined by implications. Most items have none, and are read with
    /// little on the stack.
    fn item(&mut self) -> Result<Expr> {
        let start = self.start();
        let first = self.side();
        match self.peek() {
            Some(Tok::Rel(Rel::Implies | Rel::Iff)) => self.implications(first?, start),
            _ => first,
        }
    }

    fn implications(&mut self, first: Expr, start: usize) -> Result<Expr> {
        let mut links = Vec::new();
        while let Some(Tok::Rel(rel @ (Rel::Implies | Rel::Iff))) = self.peek() {
            let span = self.bump();
            let expr = self.side()?;
            links.push(Link { rel, span, expr });
        }
        Ok(self.chained(first, links, start))
    }

    /// One side of an implication: sums with relations between.
    fn side(&mut self) -> Result<Expr> {
        let start = self.start();
        let first = self.piece();
        let side = match self.peek() {
            Some(Tok::Rel(_) | Tok::Command(Role::Stacked | Role::LongArrow)) => self.chain(first?, start),
            Some(Tok::Mid) if self.row && !self.in_set => self.chain(first?, start),
            _ => first,
        };
        if self.is_modulus() { self.congruence(side?, start) } else { side }
    }

    /// Whether `\pmod m` or `(\bmod m)` comes next.
    pub fn is_modulus(&self) -> bool {
        match self.look(self.pos) {
            Some((_, Tok::Command(Role::Modulus))) => true,
            Some((at, Tok::Open(Fence::Paren) | Tok::Left(Fence::Paren))) => {
                matches!(self.look(at + 1), Some((_, Tok::Binary("mod"))))
            }
            _ => false,
        }
    }

    /// Relations that are meant by a modulus: of them nothing more is known, and the last side keeps it.
    fn congruence(&mut self, side: Expr, start: usize) -> Result<Expr> {
        self.peek();
        let at = self.pos;
        if self.query {
            return Err(Box::new(congruence(self.span_at(at))));
        }
        let (name, modulus) = if self.tokens[at].kind == Tok::Command(Role::Modulus) {
            (self.bump(), self.argument()?)
        } else {
            let inside = self.inside(at)?;
            let name = self.span_at(self.trim(inside.clone()).start);
            let modulus = self.expr_in(self.trim(inside.clone()).start + 1..inside.end)?;
            self.pos = inside.end + 1;
            (name, modulus)
        };
        let end = self.here().end;
        let by = |expr: Expr| {
            let span = Span::new(expr.span.start, end);
            Expr::new(residue(name, expr, modulus), span)
        };
        match side.kind {
            Kind::Chain(first, mut links) => {
                let last = links.pop().map(|link| Link { expr: by(link.expr), ..link });
                links.extend(last);
                self.unjudged(&mut links);
                Ok(self.node(Kind::Chain(first, links), start))
            }
            _ => Ok(by(side)),
        }
    }

    /// 7 ≡ 1 mod 3 is a congruence, and 1 mod 3 no remainder.
    fn congruent(&mut self, links: &mut [Link]) -> Result<()> {
        if !links.iter().any(|link| link.rel == Rel::Equiv) {
            return Ok(());
        }
        let Some(Link { expr, .. }) = links.last_mut().filter(|link| link.expr.is_remainder()) else {
            return Ok(());
        };
        if let Kind::Apply(name, groups) = &mut expr.kind
            && let Some([number, modulus]) = groups.first_mut().map(Vec::as_mut_slice)
        {
            if self.query {
                return Err(Box::new(congruence(name.span)));
            }
            let take = |expr: &mut Expr| std::mem::replace(expr, Expr::int(0));
            expr.kind = residue(name.span, take(number), take(modulus));
            self.unjudged(links);
        }
        Ok(())
    }

    /// Of relations that a modulus gives their meaning nothing more is known.
    fn unjudged(&self, links: &mut [Link]) {
        for link in links {
            if matches!(link.rel, Rel::Eq | Rel::Equiv | Rel::Define) {
                link.rel = Rel::Other('≡');
            }
        }
    }

    fn chain(&mut self, first: Expr, start: usize) -> Result<Expr> {
        let mut links = Vec::new();
        while let Some((rel, span)) = self.relation() {
            let expr = self.piece()?;
            links.push(Link { rel, span, expr });
        }
        self.congruent(&mut links)?;
        Ok(self.chained(first, links, start))
    }

    fn chained(&self, first: Expr, links: Vec<Link>, start: usize) -> Expr {
        match links.last() {
            None => first,
            Some(last) => {
                let span = Span::new(start, last.expr.span.end.max(last.span.end));
                Expr::new(Kind::Chain(Box::new(first), links), span)
            }
        }
    }

    /// Takes a relation sign, also one with a remark above, if one comes next.
    pub fn relation(&mut self) -> Option<(Rel, Span)> {
        match self.peek()? {
            Tok::Rel(Rel::Implies | Rel::Iff) => None,
            Tok::Rel(Rel::Colon) if self.in_set || self.colon_ends => None,
            // a colon at the end of a row announces what follows it
            Tok::Rel(Rel::Colon) if self.row && self.look(self.pos + 1).is_none() => {
                self.bump();
                None
            }
            Tok::Rel(Rel::Lt) if self.angle_end(self.pos).is_some() => None,
            Tok::Rel(rel) => Some((rel, self.bump())),
            Tok::Mid if self.row && !self.in_set => Some((Rel::Other('∣'), self.bump())),
            Tok::Command(Role::Stacked) => {
                let (rel, end) = self.stacked_relation(self.pos)?;
                let span = self.span_at(self.pos).to(self.span_at(end - 1));
                self.pos = end;
                Some((rel, span))
            }
            Tok::Command(Role::LongArrow) => {
                let start = self.bump();
                let end = self.look(self.pos).map_or(self.pos, |(at, _)| self.after(at));
                self.pos = end;
                Some((Rel::To, start.to(self.here())))
            }
            _ => None,
        }
    }

    /// The relation of `\stackrel{remark}{=}` at `at`, and the index after it.
    fn stacked_relation(&self, at: usize) -> Option<(Rel, usize)> {
        let (remark, _) = self.look(at + 1)?;
        let (below, kind) = self.look(self.after(remark))?;
        let inner = if kind == Tok::OpenBrace { self.look(below + 1)?.0 } else { below };
        let Tok::Rel(rel) = self.tokens[inner].kind else { return None };
        let end = self.after(below);
        if kind == Tok::OpenBrace && self.look(inner + 1)?.0 + 1 != end {
            return None;
        }
        let remark = self.text.piece(self.span_of(remark..self.after(remark)).range());
        let defines = ["def", "triangle", "Delta", ":", "设", "记"].iter().any(|word| remark.contains(word));
        Some((if rel == Rel::Eq && defines { Rel::Define } else { rel }, end))
    }

    /// One side of a relation. In a tolerant row, an unreadable one is passed over.
    fn piece(&mut self) -> Result<Expr> {
        if self.tolerant { Ok(self.tolerant_piece()) } else { self.range() }
    }

    fn tolerant_piece(&mut self) -> Expr {
        let start = self.start();
        let from = self.pos;
        let open_bars = self.bars.len();
        match self.range() {
            Ok(expr) => match self.peek() {
                Some(next) if !self.ends_piece(next) => {
                    let problem = self.unexpected(self.pos);
                    self.recover(from, start, *problem)
                }
                _ => expr,
            },
            Err(problem) => {
                self.bars.truncate(open_bars);
                self.recover(from, start, *problem)
            }
        }
    }

    fn ends_piece(&self, kind: Tok) -> bool {
        matches!(kind, Tok::Rel(_) | Tok::Command(Role::Stacked | Role::LongArrow))
            || is_separator(kind)
            || kind == Tok::Mid && self.row && !self.in_set
            || self.is_modulus()
            || self.ends_items(kind)
            || self.begins_item(kind)
    }

    /// Passes over the tokens from `from`, which begins at byte `start`, to the end of the piece.
    fn recover(&mut self, from: usize, start: usize, problem: Diagnostic) -> Expr {
        self.problems.push(problem);
        let mut at = from;
        while at < self.end {
            let kind = self.tokens[at].kind;
            if matches!(kind, Tok::Rel(_) | Tok::Command(Role::Stacked | Role::LongArrow))
                || is_separator(kind)
            {
                break;
            }
            at = self.after(at).min(self.end);
        }
        self.pos = at;
        let end = if self.is_blank(from..at) { start } else { self.span_of(from..at).end };
        let span = Span::new(start, end);
        Expr::new(Kind::Unread(self.text.piece(span.range()).to_owned()), span)
    }

    /// A sum, or `a..b`.
    fn range(&mut self) -> Result<Expr> {
        let first = self.sum();
        if self.peek() != Some(Tok::Range) {
            return first;
        }
        let first = first?;
        self.bump();
        let last = self.sum()?;
        let span = first.span.to(last.span);
        Ok(Expr::new(Kind::Range(Box::new(first), Box::new(last)), span))
    }

    /// `∀ x ∈ P, y ∈ Q: body`; what follows the bound names is the body.
    fn for_all(&mut self) -> Result<Expr> {
        let start = self.bump().start;
        let colon_ends = std::mem::replace(&mut self.colon_ends, true);
        let bound = self.deeper(|reader| reader.items());
        self.colon_ends = colon_ends;
        let mut bound = bound?;
        if self.row && self.eat(Tok::Rel(Rel::Colon)).is_some() {
            let body = self.deeper(|reader| {
                let start = reader.start();
                let mut items = reader.items()?;
                match items.len() {
                    0 => Err(reader.ended()),
                    1 => Ok(items.remove(0)),
                    _ => Ok(reader.sequence(items, start)),
                }
            })?;
            return Ok(self.node(Kind::ForAll(bound, Some(Box::new(body))), start));
        }
        if bound.is_empty() {
            return self.stuck();
        }
        let count = bound.iter().take_while(|item| is_bound(item)).count().max(1);
        let mut rest = bound.split_off(count);
        let body = match rest.len() {
            0 => None,
            1 => rest.pop(),
            _ => {
                let from = rest.first().map_or(start, |first| first.span.start);
                Some(self.sequence(rest, from))
            }
        };
        Ok(self.node(Kind::ForAll(bound, body.map(Box::new)), start))
    }
}

/// A number by a modulus, as it is kept.
fn residue(name: Span, number: Expr, modulus: Expr) -> Kind {
    let callee = Expr::new(Kind::Name("pmod".to_owned()), name);
    Kind::Apply(Box::new(callee), vec![vec![number, modulus]])
}

/// What ∀ may bind: names, membership, and dots.
fn is_bound(item: &Expr) -> bool {
    match &item.kind {
        Kind::Name(_) | Kind::Ellipsis => true,
        Kind::Subscript(base, _) | Kind::Accent(_, base) | Kind::Upper(base, _) => is_bound(base),
        Kind::Chain(first, links) => {
            is_bound(first) && links.iter().all(|link| matches!(link.rel, Rel::In | Rel::Subset))
        }
        _ => false,
    }
}
