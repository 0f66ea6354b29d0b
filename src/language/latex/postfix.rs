//! Factorials and arguments behind an atom; for scripts and primes see `scripts`.
//!
//! Whether `f(t + 1)` is a value or a product only the evaluator can know, from the
//! declared names. The reader decides by form: a name, with its scripts, takes the
//! bracket as arguments, anything else is a factor. `t^2(t+1)` is a product, since a
//! number above a name without index is a power; `B_i^3(t)` takes an argument.

mod scripts;

use super::forms::is_callee;
use super::numbers::repeating;
use super::reader::{Reader, Result, Window};
use super::token::{Env, Fence, Tok};
use crate::budget;
use crate::formula::source::{Pieces, Span};
use crate::formula::{Expr, Kind, Quotient, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::letters::is_one_letter;
use crate::language::syntax::special_call;
use crate::math::number::parse_scientific;

impl Reader<'_> {
    /// An atom with everything that follows it.
    pub fn postfix(&mut self) -> Result<Expr> {
        budget::step();
        let start = self.start();
        let first = self.pos;
        let atom = self.atom();
        match self.peek() {
            Some(
                Tok::Sub
                | Tok::Sup
                | Tok::Prime(_)
                | Tok::Raised(_)
                | Tok::Bang
                | Tok::Percent
                | Tok::Open(_)
                | Tok::Left(_),
            ) => self.suffixes(atom?, start, first),
            _ => atom,
        }
    }

    /// Scripts, factorials and arguments behind an atom.
    fn suffixes(&mut self, atom: Expr, start: usize, first: usize) -> Result<Expr> {
        let mut expr = atom;
        let mut layers = 0;
        loop {
            let next = match self.peek() {
                Some(Tok::Sub | Tok::Sup | Tok::Prime(_) | Tok::Raised(_)) => {
                    self.scripts(expr, start, first)
                }
                Some(Tok::Bang) => {
                    self.bump();
                    if self.eat(Tok::Bang).is_some() {
                        let base = self.text.piece(expr.span.range());
                        let problem = Diagnostic::error(Code::UnexpectedToken, "'!!' has no meaning here")
                            .at(self.since(start))
                            .reason("the double factorial is not known")
                            .hint(format!("write ({base}!)! for the factorial of the factorial"));
                        return Err(Box::new(problem));
                    }
                    Ok(self.node(Kind::Factorial(Box::new(expr)), start))
                }
                // 25\%
                Some(Tok::Percent) if matches!(expr.kind, Kind::Number(_)) => {
                    let sign = self.bump();
                    let hundred = Expr { span: sign, ..Expr::int(100) };
                    let quotient = Kind::Div(Box::new(expr), Box::new(hundred), Quotient::Slash);
                    let quotient = self.node(quotient, start);
                    Ok(self.node(Kind::Group(Box::new(quotient)), start))
                }
                Some(Tok::Open(Fence::Paren) | Tok::Left(Fence::Paren)) if self.takes_arguments(&expr) => {
                    self.applied(expr, start)
                }
                Some(Tok::Open(Fence::Square) | Tok::Left(Fence::Square)) if self.indexes(&expr) => {
                    self.bracket_index(expr, start)
                }
                Some(Tok::Open(Fence::Curly) | Tok::Left(Fence::Curly)) if self.is_word(&expr, first) => {
                    self.applied_to_set(expr, start)
                }
                _ => return Ok(expr),
            };
            expr = next?;
            layers += 1;
            self.wrap(layers)?;
        }
    }

    fn applied(&mut self, callee: Expr, start: usize) -> Result<Expr> {
        let mut groups = self.arguments()?;
        // hat(1) and sum(i=0..n, t^i) in a query are what they are in plain notation.
        if let (true, Kind::Name(name), [group]) = (self.query, &callee.kind, groups.as_mut_slice()) {
            match special_call(name, std::mem::take(group)) {
                Ok(kind) => return Ok(self.node(kind, start)),
                Err(items) => *group = items,
            }
        }
        Ok(self.node(Kind::Apply(Box::new(callee), groups), start))
    }

    /// Whether the square brackets that come next, without a blank, hold indices: `b[0]`. Pages use them
    /// for parentheses, queries for entries.
    fn indexes(&self, base: &Expr) -> bool {
        let Some(close) = self.partner(self.pos) else { return false };
        let touches = self.pos > 0 && self.span_at(self.pos - 1).end == self.span_at(self.pos).start;
        let index = |at: usize| {
            matches!(
                self.tokens[at].kind,
                Tok::Number | Tok::Letter(_) | Tok::Symbol(_) | Tok::Comma | Tok::Plus | Tok::Minus
            )
        };
        // f[x_0, x_1] is no product.
        let several = self.split(self.pos + 1..close, |kind| kind == Tok::Comma).len() > 1;
        let power = self.look(close + 1).is_some_and(|(_, kind)| kind == Tok::Sup);
        self.query
            && touches
            && !power
            && matches!(self.tokens[close].kind, Tok::Close(Fence::Square) | Tok::Right(Fence::Square))
            && (is_callee(base) || matches!(base.kind, Kind::Apply(..)))
            && close > self.pos + 1
            && (several || (self.pos + 1..close).all(index))
    }

    /// `b[0]`: an index that is a list.
    fn bracket_index(&mut self, base: Expr, start: usize) -> Result<Expr> {
        let window = self.inside(self.pos)?;
        let brackets = self.span_at(self.pos).to(self.span_at(window.end));
        let after = window.end + 1;
        let items = self.list_in(window)?;
        self.pos = after;
        let list = Expr::new(Kind::List(items), brackets);
        Ok(self.node(Kind::Subscript(Box::new(base), vec![list]), start))
    }

    fn applied_to_set(&mut self, callee: Expr, start: usize) -> Result<Expr> {
        let set = self.deeper(Self::atom)?;
        Ok(self.node(Kind::Apply(Box::new(callee), vec![vec![set]]), start))
    }

    /// The arguments in the bracket that comes next.
    pub fn arguments(&mut self) -> Result<Vec<Vec<Expr>>> {
        let window = self.inside(self.pos)?;
        let after = window.end + 1;
        let groups = self.groups_in(window);
        self.pos = after;
        groups
    }

    fn is_word(&self, expr: &Expr, first: usize) -> bool {
        matches!(expr.kind, Kind::Name(_)) && matches!(self.tokens[first].kind, Tok::Word(..) | Tok::Text(..))
    }

    /// Whether the bracket that comes next holds the arguments of `callee`.
    fn takes_arguments(&self, callee: &Expr) -> bool {
        let Some(close) = self.partner(self.pos) else { return false };
        // `[0, 1)` and `(0, 1]` are intervals
        if !matches!(self.tokens[close].kind, Tok::Close(Fence::Paren) | Tok::Right(Fence::Paren)) {
            return false;
        }
        let window = self.pos + 1..close;
        // polar(t^2, degree=3) of a query is no formula with a condition beside it.
        let word = self.query && matches!(&callee.kind, Kind::Name(name) if !is_one_letter(name));
        if self.row && self.is_condition() && !word || self.is_table(window.clone()) || self.is_modulus() {
            return false;
        }
        // polar(F)(0, 1)
        if let Kind::Apply(function, _) = &callee.kind {
            return self.query && matches!(&function.kind, Kind::Name(name) if !is_one_letter(name));
        }
        let Kind::Group(inner) = &callee.kind else { return is_callee(callee) };
        match &inner.kind {
            Kind::Derivative { .. } | Kind::Compose(_) => true,
            Kind::Mul(factors)
                if matches!(factors.last(), Some(Expr { kind: Kind::Derivative { .. }, .. })) =>
            {
                true
            }
            // (FG)(t); whether it is a product after all the evaluator decides
            Kind::Mul(factors) => self.is_single_name(window) && factors.iter().all(is_callee),
            Kind::Add(terms) => {
                let parts = self.split(window, |kind| kind == Tok::Comma);
                let single = matches!(parts.as_slice(), [part] if self.is_single_name(part.clone()));
                parts.len() > 1 || single && terms.iter().all(|term| is_callee(&term.expr))
            }
            _ => false,
        }
    }

    fn is_single_name(&self, window: Window) -> bool {
        let window = self.trim(window);
        window.len() == 1 && matches!(self.tokens[window.start].kind, Tok::Letter(_) | Tok::Symbol(_))
    }

    /// Whether a window holds one matrix and nothing else.
    pub fn is_table(&self, window: Window) -> bool {
        let window = self.trim(window);
        window.clone().next().is_some_and(|at| {
            matches!(self.tokens[at].kind, Tok::Begin(Env::Matrix(_) | Env::Array))
                && self.after(at) == window.end
        })
    }

    /// Arguments: lists with semicolons or bars between, f(u_1, u_2 | v_1).
    pub fn groups_in(&mut self, window: Window) -> Result<Vec<Vec<Expr>>> {
        if self.is_blank(window.clone()) {
            return Ok(vec![Vec::new()]);
        }
        self.relate_lone_bar(window.clone());
        self.within(window, Self::groups)
    }

    /// A bar that has no partner stands between what is said and its condition: p(x | z), D(p || q).
    fn relate_lone_bar(&mut self, window: Window) {
        let mut bars = Vec::new();
        let mut at = window.start;
        while at < window.end {
            if matches!(self.tokens[at].kind, Tok::Bar | Tok::DoubleBar) {
                bars.push(at);
            }
            at = self.after(at);
        }
        let [bar] = bars.as_slice() else { return };
        let evaluates = matches!(self.look(bar + 1), Some((_, Tok::Sub | Tok::Sup | Tok::Raised(_))));
        let between = !self.is_blank(window.start..*bar) && !self.is_blank(bar + 1..window.end);
        if between && !evaluates {
            let sign = if self.tokens[*bar].kind == Tok::Bar { '∣' } else { '∥' };
            self.tokens[*bar].kind = Tok::Rel(Rel::Other(sign));
        }
    }

    fn groups(&mut self) -> Result<Vec<Vec<Expr>>> {
        let mut groups = vec![self.list()?];
        while self.eat(Tok::Semicolon).or_else(|| self.eat(Tok::Mid)).is_some() {
            groups.push(self.items()?);
        }
        Ok(groups)
    }

    /// An argument of a command: a group in braces or one token.
    pub fn argument(&mut self) -> Result<Expr> {
        match self.peek() {
            Some(Tok::OpenBrace) => self.braced(),
            Some(Tok::Number) => self.digit(),
            _ => self.deeper(Self::atom),
        }
    }

    /// The content of the braces that come next.
    fn braced(&mut self) -> Result<Expr> {
        let at = self.pos;
        let window = self.inside(at)?;
        let after = window.end + 1;
        if self.is_blank(window.clone()) {
            return Err(self.blank(self.span_at(at).to(self.span_at(window.end))));
        }
        let expr = self.expr_in(window);
        self.pos = after;
        expr
    }

    fn blank(&self, span: Span) -> Box<Diagnostic> {
        Box::new(Diagnostic::error(Code::UnexpectedEnd, "an empty argument").at(span))
    }

    /// Without braces, TeX takes one digit of a number.
    fn digit(&mut self) -> Result<Expr> {
        let span = self.tokens[self.pos].span();
        if span.len() < 2 || !self.text_at(self.pos).starts_with(|c: char| c.is_ascii_digit()) {
            return self.deeper(Self::atom);
        }
        self.tokens[self.pos].cut_front();
        self.numeral(Span::new(span.start, span.start + 1))
    }

    /// The number written at `span`.
    pub fn numeral(&self, span: Span) -> Result<Expr> {
        // Groups of digits are set apart by small spaces, decimals by a comma in some countries.
        let text = self.text.piece(span.range()).replace("\\,", "").replace('~', "");
        // Between thousands stand several, or a decimal point follows.
        let thousands = text.matches("{,}").count() > 1 || text.contains('.');
        let text = text.replace("{,}", if thousands { "" } else { "." });
        match repeating(&text).unwrap_or_else(|| parse_scientific(&text)) {
            Ok(value) => Ok(Expr::new(Kind::Number(value), span)),
            Err(error) => Err(Box::new(Diagnostic::error(Code::BadNumber, error.to_string()).at(span))),
        }
    }
}
