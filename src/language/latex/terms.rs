//! Sums, products, quotients, compositions.

use super::commands::Role;
use super::reader::{Reader, Result, is_separator};
use super::token::{Fence, Tok};
use crate::formula::source::Pieces;
use crate::formula::{Enclosure, Expr, Kind, Quotient, Rel, Sign, Term};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::syntax::reach_of_mod;

const PLUS_MINUS: Tok = Tok::Binary("pm");
const MINUS_PLUS: Tok = Tok::Binary("mp");

/// Whether a sign binds less than those between factors.
fn is_loose(kind: Tok) -> bool {
    matches!(kind, Tok::Binary("mod" | "pm" | "mp"))
}

impl Reader<'_> {
    fn sign(&mut self) -> Option<Sign> {
        let sign = match self.peek()? {
            Tok::Plus => Sign::Plus,
            Tok::Minus => Sign::Minus,
            _ => return None,
        };
        self.bump();
        Some(sign)
    }

    /// Terms with signs between.
    pub fn sum(&mut self) -> Result<Expr> {
        let start = self.start();
        let sign = self.sign();
        self.skip_gaps();
        let first = self.product();
        match self.peek() {
            Some(Tok::Plus | Tok::Minus | PLUS_MINUS | MINUS_PLUS) => {}
            _ if sign.is_some() => {}
            _ => return first,
        }
        self.terms(sign, first?, start)
    }

    /// The terms after the first.
    fn terms(&mut self, sign: Option<Sign>, first: Expr, start: usize) -> Result<Expr> {
        let mut written = sign.is_some();
        let mut terms = vec![Term { sign: sign.unwrap_or(Sign::Plus), expr: first }];
        while let Some(next) = self.peek() {
            // a + b ± c: two numbers, made of the sum before
            if let PLUS_MINUS | MINUS_PLUS = next {
                let before = match terms.len() {
                    1 if !written => terms.remove(0).expr,
                    _ => self.node(Kind::Add(std::mem::take(&mut terms)), start),
                };
                let both = self.either_sign(Some(before), start)?;
                (terms, written) = (vec![Term { sign: Sign::Plus, expr: both }], false);
                continue;
            }
            let Some(sign) = self.sign() else { break };
            self.skip_gaps();
            let expr = self.product()?;
            terms.push(Term { sign, expr });
        }
        if let Some(term) = terms.iter().find(|term| term.expr.is_remainder()) {
            return Err(Box::new(reach_of_mod(term.expr.span)));
        }
        match terms.as_mut_slice() {
            [only] if !written => Ok(std::mem::replace(&mut only.expr, Expr::int(0))),
            _ => Ok(self.node(Kind::Add(terms), start)),
        }
    }

    /// `± b` and `a ± b` are kept as a call of the sign: they are two numbers, and never judged.
    fn either_sign(&mut self, before: Option<Expr>, start: usize) -> Result<Expr> {
        let name = if self.peek() == Some(PLUS_MINUS) { "pm" } else { "mp" };
        self.only_on_pages("two formulas in one cannot be computed; write both")?;
        let callee = Expr::new(Kind::Name(name.to_owned()), self.bump());
        self.skip_gaps();
        let after = self.deeper(Self::product)?;
        let arguments = before.into_iter().chain([after]).collect();
        Ok(self.node(Kind::Apply(Box::new(callee), vec![arguments]), start))
    }

    /// Refuses the next token in a query: it is read on pages, and means nothing that can be computed.
    pub fn only_on_pages(&mut self, reason: &str) -> Result<()> {
        self.peek();
        if !self.query {
            return Ok(());
        }
        let problem =
            Diagnostic::error(Code::UnsupportedLatex, format!("{} is not supported", self.text_at(self.pos)));
        Err(Box::new(problem.at(self.span_at(self.pos)).reason(reason)))
    }

    /// Where an operand is expected, wide spaces mean nothing.
    fn skip_gaps(&mut self) {
        while self.eat(Tok::Gap).is_some() {}
    }

    /// Factors side by side or with `·`, `*`, `/` between, from the left.
    pub fn product(&mut self) -> Result<Expr> {
        // `a + -b`, `\sum -b`
        if let Some(Tok::Plus | Tok::Minus) = self.peek() {
            return self.signed(Self::product);
        }
        let start = self.start();
        if let Some(PLUS_MINUS | MINUS_PLUS) = self.peek() {
            return self.either_sign(None, start);
        }
        let first = self.factor();
        match self.peek() {
            Some(kind) if self.goes_on(kind) => self.factors(first?, start),
            _ => first,
        }
    }

    /// A sign and what it belongs to.
    fn signed(&mut self, read: fn(&mut Self) -> Result<Expr>) -> Result<Expr> {
        let start = self.start();
        match self.sign() {
            None => read(self),
            Some(sign) => {
                let expr = self.deeper(read)?;
                Ok(self.node(Kind::Add(vec![Term { sign, expr }]), start))
            }
        }
    }

    /// Whether this token may go on with a product.
    fn goes_on(&self, kind: Tok) -> bool {
        match kind {
            Tok::Dot | Tok::Star | Tok::Slash | Tok::Binary("mod") => true,
            Tok::Period => self.is_lowered_dot(),
            Tok::Bar | Tok::DoubleBar if self.closes_bar(kind) => false,
            Tok::Bar | Tok::Mid if self.is_evaluation() => true,
            Tok::Bar if self.in_set => false,
            _ if self.row && self.is_condition() || self.is_modulus() => false,
            _ => self.begins_operand(kind),
        }
    }

    /// The factors after the first.
    fn factors(&mut self, first: Expr, start: usize) -> Result<Expr> {
        let mut factors = vec![first];
        let mut layers = 0;
        while let Some(kind) = self.peek().filter(|&kind| self.goes_on(kind)) {
            if let Some(last) = factors.last().filter(|last| last.is_remainder()) {
                return Err(Box::new(reach_of_mod(last.span)));
            }
            let next = match kind {
                Tok::Binary("mod") => {
                    let left = self.joined(std::mem::take(&mut factors), start);
                    let name = Expr::new(Kind::Name("mod".to_owned()), self.span_at(self.pos));
                    self.bump();
                    self.skip_gaps();
                    let right = self.signed_operand()?;
                    Ok(self.node(Kind::Apply(Box::new(name), vec![vec![left, right]]), start))
                }
                Tok::Dot | Tok::Star | Tok::Period => {
                    self.bump();
                    self.skip_gaps();
                    self.signed_operand()
                }
                Tok::Slash => {
                    layers += 1;
                    let left = self.joined(std::mem::take(&mut factors), start);
                    self.quotient(left, start, layers)
                }
                Tok::Bar | Tok::Mid if self.is_evaluation() => {
                    layers += 1;
                    let body = self.joined(std::mem::take(&mut factors), start);
                    self.bump();
                    self.wrap(layers).and_then(|()| self.evaluated(body, start))
                }
                _ => {
                    let next = self.factor();
                    if let (Some(last), Ok(next)) = (factors.last(), &next) {
                        self.refuse_mixed_number(last, next)?;
                        self.refuse_two_numbers(&factors, next)?;
                    }
                    next
                }
            };
            factors.push(next?);
        }
        Ok(self.joined(factors, start))
    }

    /// A derivative `dx/dt`, or an operand.
    fn factor(&mut self) -> Result<Expr> {
        match self.inline_derivative()? {
            Some(derivative) => Ok(derivative),
            None => self.operand(),
        }
    }

    fn refuse_mixed_number(&self, before: &Expr, after: &Expr) -> Result<()> {
        if !before.is_mixed_with(after) {
            return Ok(());
        }
        let (number, fraction) = (self.text.piece(before.span.range()), self.text.piece(after.span.range()));
        Err(Box::new(
            Diagnostic::error(Code::AmbiguousProduct, "a mixed number or a product?")
                .hint(format!("write {number} \\cdot {fraction} for the product"))
                .hint(format!("write {number} + {fraction} for the mixed number"))
                .at(before.span.to(after.span)),
        ))
    }

    /// Refuses `2 3`, which is 23 in print, and `2 x 3` in a query, where the x may be a sign.
    fn refuse_two_numbers(&self, before: &[Expr], after: &Expr) -> Result<()> {
        let Some(last) = before.last() else { return Ok(()) };
        let number = |expr: &Expr| matches!(expr.kind, Kind::Number(_));
        let leads = match &after.kind {
            Kind::Pow(base, _) | Kind::Factorial(base) => number(base),
            _ => number(after),
        };
        let cross = self.query
            && before.len() > 1
            && matches!(&last.kind, Kind::Name(x) if x == "x" || x == "X")
            && number(&before[before.len() - 2]);
        if !leads || !number(last) && !cross {
            return Ok(());
        }
        let text = |expr: &Expr| self.text.piece(expr.span.range());
        let problem = match cross {
            false => Diagnostic::error(Code::UnexpectedToken, "two numbers side by side")
                .reason("a product, or one number?")
                .hint(format!(
                    "write {0} \\cdot {1} for the product, {0}{1} for one number",
                    text(last),
                    text(after)
                )),
            true => Diagnostic::error(Code::AmbiguousProduct, "a sign of multiplication or the letter x?")
                .hint(format!(
                    "write {0} \\cdot {1} for the product, {0} \\cdot {2} \\cdot {1} for one with the letter",
                    text(&before[before.len() - 2]),
                    text(after),
                    text(last)
                )),
        };
        let first = if cross { &before[before.len() - 2] } else { last };
        Err(Box::new(problem.at(first.span.to(after.span))))
    }

    /// Whether the period here stands between two thin spaces, as some write a product: `2\,.\,t`.
    fn is_lowered_dot(&self) -> bool {
        let span = self.span_at(self.pos);
        self.query
            && self.text.piece(..span.start).trim_end().ends_with("\\,")
            && self.text.piece(span.end..).trim_start().starts_with("\\,")
            && self.look(self.pos + 1).is_some_and(|(_, kind)| self.begins_operand(kind))
    }

    fn quotient(&mut self, left: Expr, start: usize, layers: u32) -> Result<Expr> {
        self.wrap(layers)?;
        self.bump();
        self.skip_gaps();
        let right = self.signed_operand()?;
        Ok(self.node(Kind::Div(Box::new(left), Box::new(right), Quotient::Slash), start))
    }

    /// An operand that may carry a sign, as in `a · -b`.
    fn signed_operand(&mut self) -> Result<Expr> {
        match self.peek() {
            Some(Tok::Plus | Tok::Minus) => self.signed(Self::signed_operand),
            _ => self.operand(),
        }
    }

    /// One factor itself, or the product of several.
    fn joined(&self, mut factors: Vec<Expr>, start: usize) -> Expr {
        if factors.len() == 1 {
            return factors.remove(0);
        }
        self.node(Kind::Mul(factors), start)
    }

    /// Whether a bar here ends the innermost open bars. `||` may also be two single bars.
    pub fn closes_bar(&self, kind: Tok) -> bool {
        match self.bars.last() {
            Some(Enclosure::Abs) => {
                kind == Tok::Bar || kind == Tok::DoubleBar && self.text_at(self.pos) == "||"
            }
            Some(Enclosure::Norm) => kind == Tok::DoubleBar,
            _ => false,
        }
    }

    /// Whether the bar here is one of `|_{t=0}`.
    pub fn is_evaluation(&self) -> bool {
        matches!(self.look(self.pos + 1), Some((_, Tok::Sub | Tok::Sup | Tok::Raised(_))))
    }

    /// Factors with `∘`, `×` or a named operator between.
    pub fn operand(&mut self) -> Result<Expr> {
        let start = self.start();
        let first = self.postfix();
        let first = match first {
            Ok(delta) if is_difference(&delta) => self.difference(delta, true),
            _ => first,
        };
        match self.peek() {
            Some(kind) if is_loose(kind) => first,
            Some(Tok::Circ | Tok::Cross | Tok::Binary(_)) => self.composed(first?, start),
            _ => first,
        }
    }

    fn composed(&mut self, first: Expr, start: usize) -> Result<Expr> {
        let mut left = first;
        let mut layers = 0;
        while let Some(operator @ (Tok::Circ | Tok::Cross | Tok::Binary(_))) =
            self.peek().filter(|kind| !is_loose(*kind))
        {
            layers += 1;
            self.wrap(layers)?;
            if operator == Tok::Binary("wedge") {
                self.only_on_pages("separate formulas by a comma")?;
            }
            let span = self.tokens[self.pos].span();
            let mut list = vec![left];
            while self.eat(operator).is_some() {
                self.skip_gaps();
                // 2 \times -3
                let signed = operator == Tok::Cross && matches!(self.peek(), Some(Tok::Plus | Tok::Minus));
                let item = if signed { self.signed(Self::postfix)? } else { self.postfix()? };
                list.push(if is_difference(&item) { self.difference(item, false)? } else { item });
            }
            let kind = match operator {
                Tok::Circ => Kind::Compose(list),
                Tok::Binary(name) => {
                    Kind::Apply(Box::new(Expr::new(Kind::Name(name.to_owned()), span)), vec![list])
                }
                _ => Kind::Cross(list),
            };
            left = self.node(kind, start);
        }
        Ok(left)
    }

    /// Δb_i as a factor of a product of vectors, Δb_0 × Δb_1; if it is the first one, a × has to follow.
    fn difference(&mut self, delta: Expr, first: bool) -> Result<Expr> {
        let member = matches!(self.peek(), Some(Tok::Letter(_) | Tok::Symbol(_) | Tok::Command(_)));
        if !member || !self.peek().is_some_and(|kind| self.goes_on(kind)) {
            return Ok(delta);
        }
        let before = self.pos;
        let next = self.postfix()?;
        if !matches!(next.kind, Kind::Subscript(..)) || first && self.peek() != Some(Tok::Cross) {
            self.pos = before;
            return Ok(delta);
        }
        let span = delta.span.to(next.span);
        Ok(Expr::new(Kind::Mul(vec![delta, next]), span))
    }

    /// Whether an operand may begin with this token.
    pub fn begins_operand(&self, kind: Tok) -> bool {
        match kind {
            Tok::Number
            | Tok::Letter(_)
            | Tok::Symbol(_)
            | Tok::Word(..)
            | Tok::Ellipsis
            | Tok::OpenBrace
            | Tok::Open(_)
            | Tok::Left(_)
            | Tok::Begin(_)
            | Tok::Bad(_) => true,
            Tok::Bar | Tok::DoubleBar => true,
            Tok::Text(..) => !self.row || self.is_word_atom(),
            Tok::Command(role) => !matches!(
                role,
                Role::Infix(_) | Role::ForAll | Role::Stacked | Role::LongArrow | Role::Modulus
            ),
            _ => false,
        }
    }

    /// Whether the words here are a name: one word, and a bracket follows, or it stands where an operand must stand:
    /// `\text{size} = 6`, `k - \text{size}`.
    pub fn is_word_atom(&self) -> bool {
        let Some(Tok::Text(start, end)) = self.tokens.get(self.pos).map(|token| token.kind) else {
            return false;
        };
        let word = self.text.piece(start as usize..end as usize).trim();
        let is_name = word.bytes().all(|byte| byte.is_ascii_alphanumeric())
            && word.starts_with(|c: char| c.is_ascii_alphabetic())
            && !super::commands::CONNECTIVES.contains(&word.to_ascii_lowercase().as_str());
        if !is_name || !self.row {
            return is_name;
        }
        let Some((_, next)) = self.look(self.pos + 1) else { return self.is_after(Tok::is_operator) };
        match next {
            Tok::Open(Fence::Paren | Fence::Curly) | Tok::Left(Fence::Paren | Fence::Curly) => true,
            Tok::Rel(Rel::Colon) => false,
            Tok::Rel(_) => !self.is_after(|kind| !kind.is_operator() && !is_separator(kind)),
            _ if next.is_operator() => {
                self.is_after(|kind| kind.is_operator() || matches!(kind, Tok::Rel(_)))
            }
            _ => self.is_after(Tok::is_operator),
        }
    }

    /// Whether a token of that kind stands before the next one.
    fn is_after(&self, test: impl Fn(Tok) -> bool) -> bool {
        self.pos.checked_sub(1).is_some_and(|at| test(self.tokens[at].kind))
    }
}

/// Whether it is the sign of a difference, Δ or Δ^k.
fn is_difference(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Name(name) => name == "Delta",
        Kind::Pow(base, _) | Kind::Upper(base, _) => is_difference(base),
        _ => false,
    }
}
