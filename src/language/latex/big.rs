//! Sums, products, limits, maxima and integrals, with their bounds.

use super::commands::Role;
use super::reader::{Reader, Result, Window};
use super::token::{Fence, Tok};
use crate::formula::source::{Pieces, Span};
use crate::formula::{BigOp, Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::math::number::integer;

/// The factors of a product sign end with the last one in which its index occurs: in
/// `\prod_j (y - t_j) c` the c stands beside it. The others come back by themselves.
fn up_to_index(body: Expr, lower: &[Expr]) -> (Expr, Vec<Expr>) {
    let index = lower.iter().find_map(|piece| match &piece.kind {
        Kind::Chain(left, _) => Some(left.as_ref()),
        Kind::Name(_) => Some(piece),
        _ => None,
    });
    let (Kind::Mul(factors), Some(index)) = (&body.kind, index) else { return (body, Vec::new()) };
    fn occurs(expr: &Expr, index: &Expr) -> bool {
        // Π_{j ∈ S} t_j Π_{j ∉ S} (1 - t_j): the second j is another one.
        if let Kind::Big { lower, .. } = &expr.kind
            && lower.iter().any(|piece| matches!(&piece.kind, Kind::Chain(left, _) if left.same_as(index)))
        {
            return false;
        }
        let mut found = expr.same_as(index);
        expr.for_each_child(&mut |child| found = found || occurs(child, index));
        found
    }
    let last = factors.iter().rposition(|factor| occurs(factor, index));
    match last {
        Some(last) if last + 1 < factors.len() => {
            let mut own = factors.clone();
            let rest = own.split_off(last + 1);
            let span = own[0].span.to(own[last].span);
            let body = if last == 0 { own.remove(0) } else { Expr::new(Kind::Mul(own), span) };
            (body, rest)
        }
        _ => (body, Vec::new()),
    }
}

impl Reader<'_> {
    /// `_{…}` and `^{…}` in any order: what stands below, item by item, and what stands above.
    pub fn bounds(&mut self) -> Result<(Vec<Expr>, Option<Expr>)> {
        let mut lower = None;
        let mut upper = None;
        while let Some(kind) = self.peek() {
            match kind {
                Tok::Sub if lower.is_none() => {
                    self.bump();
                    lower = Some(self.below()?);
                }
                Tok::Raised(false) if lower.is_none() => {
                    self.bump();
                    lower = Some(self.raised()?);
                }
                Tok::Sup if upper.is_none() => {
                    self.bump();
                    upper = Some(self.argument()?);
                }
                Tok::Raised(true) if upper.is_none() => {
                    self.bump();
                    upper = self.raised()?.pop();
                }
                _ => break,
            }
        }
        Ok((lower.unwrap_or_default(), upper))
    }

    /// What stands below, perhaps on several lines.
    fn below(&mut self) -> Result<Vec<Expr>> {
        if self.peek() == Some(Tok::Command(Role::Lines)) {
            self.bump();
        }
        if self.peek() != Some(Tok::OpenBrace) {
            return Ok(vec![self.argument()?]);
        }
        let outer = self.inside(self.pos)?;
        let mut window = self.trim(outer.clone());
        if let Some(at) = window.clone().next()
            && self.tokens[at].kind == Tok::Command(Role::Lines)
            && let Some((brace, Tok::OpenBrace)) = self.look(at + 1)
        {
            window = self.inside(brace)?;
        } else if let Some(at) = window.clone().next()
            && let Tok::Begin(_) = self.tokens[at].kind
            && self.after(at) == window.end
        {
            window = at + 1..window.end - 1;
        }
        let mut items = Vec::new();
        for line in self.split(window, |kind| kind == Tok::RowBreak) {
            if !self.is_blank(line.clone()) {
                let row = self.row_in(line)?;
                match row.kind {
                    Kind::Sequence(list) => items.extend(list),
                    _ => items.push(row),
                }
            }
        }
        self.pos = outer.end + 1;
        Ok(items)
    }

    /// An operator over a range; it takes the product that follows.
    pub fn big(&mut self, op: BigOp) -> Result<Expr> {
        let start = self.start();
        let sign = self.bump();
        let (lower, upper) = self.bounds()?;
        if lower.is_empty()
            && upper.is_none()
            && let Some(function) = self.big_as_function(op, sign)?
        {
            return Ok(function);
        }
        self.is_no_sum_in_braces()?;
        let body = self.big_body(sign)?;
        let (body, rest) = match op {
            BigOp::Product => up_to_index(body, &lower),
            _ => (body, Vec::new()),
        };
        let end = body.span;
        let kind = Kind::Big { op, lower, upper: upper.map(Box::new), body: Box::new(body) };
        let big = self.node(kind, start);
        if rest.is_empty() {
            return Ok(big);
        }
        let big = Expr { span: sign.to(end), ..big };
        Ok(self.node(Kind::Mul(std::iter::once(big).chain(rest).collect()), start))
    }

    /// `\max(a, b)`, `\min\{a, b\}`, and `\max` alone are names of functions.
    fn big_as_function(&mut self, op: BigOp, sign: Span) -> Result<Option<Expr>> {
        let name = match op {
            BigOp::Max => "max",
            BigOp::Min => "min",
            BigOp::Limit => "lim",
            _ => return Ok(None),
        };
        let callee = Expr::new(Kind::Name(name.to_owned()), sign);
        let groups = match self.peek() {
            Some(Tok::Open(Fence::Paren) | Tok::Left(Fence::Paren)) => self.arguments()?,
            Some(Tok::Open(Fence::Curly) | Tok::Left(Fence::Curly)) => vec![vec![self.deeper(Self::atom)?]],
            Some(Tok::Minus) => return Ok(None),
            Some(kind) if self.begins_operand(kind) => return Ok(None),
            _ => return Ok(Some(callee)),
        };
        Ok(Some(self.node(Kind::Apply(Box::new(callee), groups), sign.start)))
    }

    fn big_body(&mut self, sign: Span) -> Result<Expr> {
        while self.eat(Tok::Gap).is_some() {}
        match self.peek() {
            Some(Tok::Plus | Tok::Minus) => self.deeper(Self::product),
            Some(kind) if self.begins_operand(kind) => self.deeper(Self::product),
            _ => {
                let problem = Diagnostic::error(Code::UnexpectedEnd, "nothing stands after this operator")
                    .at(sign)
                    .hint("write what it applies to, such as \\sum_{i=0}^n a_i");
                Err(Box::new(problem))
            }
        }
    }

    /// Refuses `\sum_i {a + b}` in a query: print does not show the braces, so that b stands outside.
    fn is_no_sum_in_braces(&self) -> Result<()> {
        let brace = |at: usize, sign: &str| self.tokens[at].kind == Tok::Skip && self.text_at(at) == sign;
        let open = (0..self.pos)
            .rev()
            .take_while(|&at| matches!(self.tokens[at].kind, Tok::Skip | Tok::Gap))
            .find(|&at| brace(at, "{"));
        let Some(open) = open.filter(|_| self.query) else { return Ok(()) };
        let (mut depth, mut at, mut begun) = (1_u32, open + 1, false);
        while at < self.end && depth > 0 {
            match self.tokens[at].kind {
                Tok::Plus | Tok::Minus if begun => {
                    return Err(Box::new(
                        Diagnostic::error(Code::AmbiguousProduct, "how far does this operator reach?")
                            .at(self.span_at(open).to(self.span_at(at)))
                            .reason("these braces do not show in print")
                            .hint("write \\left( … \\right) around all that it applies to, or no braces"),
                    ));
                }
                _ if brace(at, "{") => depth += 1,
                _ if brace(at, "}") => depth -= 1,
                Tok::Skip => {}
                _ => begun = true,
            }
            at = self.after(at);
        }
        Ok(())
    }

    /// `\int_a^b f(t)\,dt`: reads up to the differential.
    pub fn integral(&mut self) -> Result<Expr> {
        let start = self.start();
        let sign = self.bump();
        let (mut lower, upper) = self.bounds()?;
        if lower.len() > 1 {
            let problem = Diagnostic::error(Code::UnsupportedLatex, "several conditions below an integral");
            return Err(Box::new(problem.at(sign)));
        }
        let over_region = lower.len() == 1 && upper.is_none();
        let (body, variable) = self.integrand(sign, over_region)?;
        let kind = Kind::Integral {
            lower: lower.pop().map(Box::new),
            upper: upper.map(Box::new),
            body: Box::new(body),
            variable: Box::new(variable),
        };
        Ok(self.node(kind, start))
    }

    /// `\iint_D f\,dx\,dy`: an integral over what stands below.
    pub fn integral_over(&mut self, count: u8) -> Result<Expr> {
        let start = self.start();
        let sign = self.bump();
        let (mut lower, upper) = self.bounds()?;
        let (Some(region), true, None) = (lower.pop(), lower.is_empty(), upper) else {
            let name = self.text.piece(sign.range());
            let problem =
                Diagnostic::error(Code::UnsupportedLatex, format!("{name} without what it is taken over"));
            return Err(Box::new(problem.at(sign).hint(format!("write {name}_D, or \\int with its bounds"))));
        };
        let (body, variable) = self.integrand(sign, true)?;
        let mut variables = vec![variable];
        while variables.len() < usize::from(count)
            && let Some((false, next)) = self.peek().and_then(|_| self.differential_at(self.pos))
            && let Some(variable) = self.variable_at(next)
        {
            let end = variable.end;
            variables.push(self.expr_in(variable)?);
            self.pos = end;
        }
        let span = variables[0].span.to(variables[variables.len() - 1].span);
        let variable = match variables.len() {
            1 => variables.swap_remove(0),
            _ => Expr::new(Kind::Tuple(variables), span),
        };
        let (lower, upper) = (Some(Box::new(region)), None);
        let kind = Kind::Integral { lower, upper, body: Box::new(body), variable: Box::new(variable) };
        Ok(self.node(kind, start))
    }

    /// What stands under an integral, and its variable; an integral over a region may leave it out: `\oint_\gamma f`.
    fn integrand(&mut self, sign: Span, over_region: bool) -> Result<(Expr, Expr)> {
        self.peek();
        let from = self.pos;
        if let Some((at, variable)) = self.find_differential(from) {
            let body = if self.is_blank(from..at) {
                let here = self.span_at(at).start;
                Expr::new(Kind::Number(integer(1)), Span::new(here, here))
            } else {
                self.within(from..at, Self::sum)?
            };
            let end = variable.end;
            let variable = self.expr_in(variable)?;
            self.pos = end;
            return Ok((body, variable));
        }
        // ∫ dt f(t)
        if let Some((false, next)) = self.differential_at(from)
            && let Some(variable) = self.variable_at(next)
        {
            let end = variable.end;
            let variable = self.expr_in(variable)?;
            self.pos = end;
            return Ok((self.deeper(Self::product)?, variable));
        }
        if over_region && !self.query {
            let body = self.big_body(sign)?;
            let inside = from..self.pos;
            if !inside.into_iter().any(|at| self.differential_at(at).is_some()) {
                return Ok((body, Expr::new(Kind::Sequence(Vec::new()), self.here())));
            }
        }
        let problem = Diagnostic::error(Code::UnsupportedLatex, "an integral without a differential")
            .at(sign)
            .reason("the variable of integration is not said")
            .hint("end it with \\,dt");
        Err(Box::new(problem))
    }

    /// The differential that ends the integral whose body starts at `from`: where it begins, and its variable.
    fn find_differential(&self, from: usize) -> Option<(usize, Window)> {
        let mut inner = 0_u32;
        let mut at = from;
        while at < self.end {
            match self.tokens[at].kind {
                Tok::Rel(_) | Tok::Comma | Tok::Semicolon | Tok::Period => return None,
                Tok::Command(Role::Integral | Role::IntegralOver(_)) => inner += 1,
                Tok::Sub | Tok::Sup => {
                    let (argument, _) = self.look(at + 1)?;
                    at = self.after(argument);
                    continue;
                }
                _ => {
                    if let Some((false, next)) = self.differential_at(at)
                        && let Some(variable) = self.variable_at(next)
                        && self.ends_integral(variable.end)
                    {
                        if inner == 0 {
                            return Some((at, variable));
                        }
                        inner -= 1;
                        at = variable.end;
                        continue;
                    }
                }
            }
            at = self.after(at);
        }
        None
    }

    /// Whether an integral may end before the token at `at`.
    fn ends_integral(&self, at: usize) -> bool {
        match self.look(at) {
            None => true,
            Some((at, kind)) => {
                matches!(
                    kind,
                    Tok::Rel(_)
                        | Tok::Plus
                        | Tok::Minus
                        | Tok::Comma
                        | Tok::Semicolon
                        | Tok::Period
                        | Tok::Text(..)
                        | Tok::Slash
                        | Tok::Dot
                        | Tok::Command(Role::Integral | Role::Stacked)
                ) || self.differential_at(at).is_some()
            }
        }
    }

    /// A `d` or `∂` at `at`, upright, bold or not: whether it is ∂, and the index after it.
    pub fn differential_at(&self, at: usize) -> Option<(bool, usize)> {
        let (at, kind) = self.look(at)?;
        match kind {
            Tok::Letter('d') => Some((false, at + 1)),
            Tok::Symbol("partial") => Some((true, at + 1)),
            Tok::Word(start, end) | Tok::Text(start, end)
                if self.text.piece(start as usize..end as usize).trim() == "d" =>
            {
                Some((false, at + 1))
            }
            Tok::Command(Role::Accent(_)) => {
                let (argument, kind) = self.look(at + 1)?;
                let end = self.after(argument);
                let inside = if kind == Tok::OpenBrace { argument + 1..end - 1 } else { argument..end };
                let inside = self.trim(inside);
                let is_d = inside.len() == 1 && self.tokens[inside.start].kind == Tok::Letter('d');
                is_d.then_some((false, end))
            }
            // {\rm d} or {\rm d t}
            Tok::Command(Role::Switch(_)) => match self.look(at + 1)? {
                (letter, Tok::Letter('d')) => Some((false, letter + 1)),
                _ => None,
            },
            Tok::OpenBrace => {
                let inside = self.trim(at + 1..self.partner(at)?);
                let is_d = inside.len() == 2
                    && matches!(self.tokens[inside.start].kind, Tok::Command(Role::Switch(_)))
                    && self.tokens[inside.start + 1].kind == Tok::Letter('d');
                is_d.then(|| (false, self.after(at)))
            }
            _ => None,
        }
    }

    /// A variable at `at`, with its index: its tokens.
    pub fn variable_at(&self, at: usize) -> Option<Window> {
        let (at, kind) = self.look(at)?;
        let mut end = match kind {
            Tok::Letter(_) | Tok::Symbol(_) | Tok::Word(..) => at + 1,
            Tok::Command(Role::Accent(_)) => self.after(self.look(at + 1)?.0),
            _ => return None,
        };
        if let Some((sub, Tok::Sub)) = self.look(end) {
            end = self.after(self.look(sub + 1)?.0);
        }
        Some(at..end)
    }
}
