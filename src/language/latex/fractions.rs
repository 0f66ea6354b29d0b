//! Fractions, and fractions of differentials, which are derivatives.

use super::reader::{Reader, Result, Window};
use super::token::{Fence, Tok};
use crate::formula::source::Pieces;
use crate::formula::{Expr, Kind, Quotient};
use crate::language::diagnostic::{Code, Diagnostic};

/// What the two parts of d^k F / dt^k say.
struct Differentials {
    partial: bool,
    /// What is differentiated, if it stands in the fraction.
    body: Window,
    /// Variables and orders.
    variables: Vec<(Window, Option<Window>)>,
}

impl Reader<'_> {
    /// `\frac{a}{b}`, or a derivative.
    pub fn fraction(&mut self) -> Result<Expr> {
        let start = self.start();
        if let Some((differentials, end)) = self.differentials() {
            return self.derivative(differentials, end, start);
        }
        self.bump();
        let above = Box::new(self.part()?);
        let below = Box::new(self.part()?);
        Ok(self.node(Kind::Div(above, below, Quotient::Fraction), start))
    }

    /// An argument of a fraction: without braces TeX takes one sign, of `(n+1)` only the parenthesis.
    pub fn part(&mut self) -> Result<Expr> {
        if let Some(Tok::Open(_) | Tok::Left(_) | Tok::Bar | Tok::DoubleBar) = self.peek() {
            let command = self.text_at(self.pos).to_owned();
            let problem = Diagnostic::error(Code::UnexpectedToken, "an argument without braces")
                .at(self.span_at(self.pos))
                .reason(format!("TeX takes only the '{command}' here"))
                .hint("write braces around each part: \\frac{1}{n + 1}");
            return Err(Box::new(problem));
        }
        self.argument()
    }

    fn derivative(&mut self, differentials: Differentials, end: usize, start: usize) -> Result<Expr> {
        let mut variables = Vec::with_capacity(differentials.variables.len());
        for (variable, order) in differentials.variables {
            let variable = self.expr_in(variable)?;
            let order = order.map(|order| self.within(order, Self::argument)).transpose()?;
            variables.push((variable, order));
        }
        let inside = !self.is_blank(differentials.body.clone());
        let body = if inside { Some(self.expr_in(differentials.body)?) } else { None };
        self.pos = end;
        let follows = match self.peek() {
            Some(kind) => {
                self.begins_operand(kind) && !(self.row && self.is_condition()) && !self.ends_here(kind)
            }
            None => false,
        };
        let (body, point) = match body {
            None if follows => {
                let (body, point) = before_bar(self.deeper(Self::product)?);
                (Some(body), point)
            }
            body => (body, None),
        };
        let kind = Kind::Derivative { partial: differentials.partial, variables, body: body.map(Box::new) };
        let derivative = self.node(kind, start);
        Ok(match point {
            Some(lower) => self.node(Kind::At { body: Box::new(derivative), lower, upper: None }, start),
            None => derivative,
        })
    }

    /// Whether a bar here closes or evaluates something rather than opening.
    fn ends_here(&self, kind: Tok) -> bool {
        matches!(kind, Tok::Bar | Tok::DoubleBar)
            && (self.closes_bar(kind) || self.in_set || self.is_evaluation())
    }

    /// The parts of the fraction at the current token, if it is one of differentials, and its end.
    fn differentials(&self) -> Option<(Differentials, usize)> {
        let (above, kind) = self.look(self.pos + 1)?;
        let after = self.after(above);
        // \frac d{dt}: without braces it is one sign.
        let (inside, above_end) =
            if kind == Tok::OpenBrace { (above + 1, after - 1) } else { (above, after) };
        let (below, Tok::OpenBrace) = self.look(after)? else { return None };
        let below_end = self.partner(below)?;
        let (partial, next) = self.differential_at(inside).filter(|(_, next)| *next <= above_end)?;
        let (_, body) = self.order_at(next, above_end)?;
        if matches!(self.look(body).filter(|&(at, _)| at < above_end), Some((_, kind)) if !self.begins_operand(kind))
        {
            return None;
        }
        let mut variables = Vec::new();
        let mut at = below + 1;
        while !self.is_blank(at..below_end) {
            let (also_partial, next) = self.differential_at(at)?;
            let variable = self.variable_at(next)?;
            let (order, end) = self.order_at(variable.end, below_end)?;
            if also_partial != partial || end > below_end {
                return None;
            }
            variables.push((variable, order));
            at = end;
        }
        if variables.is_empty() {
            return None;
        }
        Some((Differentials { partial, body: body..above_end, variables }, below_end + 1))
    }

    /// `dx/dt`, `\partial^2 x/\partial u\,\partial v` at the current token, with its end.
    pub fn inline_derivative(&mut self) -> Result<Option<Expr>> {
        let start = self.start();
        match self.inline_differentials() {
            Some((differentials, end)) => self.derivative(differentials, end, start).map(Some),
            None => Ok(None),
        }
    }

    fn inline_differentials(&self) -> Option<(Differentials, usize)> {
        let (partial, next) = self.differential_at(self.pos)?;
        let (order, next) = self.order_at(next, self.end)?;
        let (at, kind) = self.look(next)?;
        // d/dt, or what is differentiated: a name, perhaps at its arguments.
        let body = if kind == Tok::Slash {
            at..at
        } else {
            let name = self.variable_at(at)?;
            match self.look(name.end)? {
                (_, Tok::Slash) => name,
                (open, Tok::Open(Fence::Paren) | Tok::Left(Fence::Paren)) => name.start..self.after(open),
                _ => return None,
            }
        };
        let (slash, Tok::Slash) = self.look(body.end)? else { return None };
        let (first, kind) = self.look(slash + 1)?;
        let enclosed = matches!(kind, Tok::Open(Fence::Paren)).then(|| self.after(first));
        let (mut at, last) = match enclosed {
            Some(after) => (first + 1, after - 1),
            None => (first, self.end),
        };
        let number = |window: &Option<Window>| match window {
            Some(order) => self.number_in(order.clone()),
            None => Some(1),
        };
        let mut variables = Vec::new();
        let (whole, mut sum) = (number(&order), 0);
        while (variables.is_empty() || enclosed.is_some() || whole.is_some_and(|whole| sum < whole))
            && !self.is_blank(at..last)
        {
            let (_, next) = self.differential_at(at).filter(|(own, _)| *own == partial)?;
            let variable = self.variable_at(next)?;
            let (own, end) = self.order_at(variable.end, last).filter(|(_, end)| *end <= last)?;
            sum += number(&own).unwrap_or(0);
            variables.push((variable, own));
            at = end;
        }
        let fits = !variables.is_empty() && whole.is_none_or(|whole| whole == sum);
        fits.then_some((Differentials { partial, body, variables }, enclosed.unwrap_or(at)))
    }

    /// The number that is all of a window, in braces or not.
    fn number_in(&self, window: Window) -> Option<u32> {
        let braces = |c: char| matches!(c, '{' | '}') || c.is_whitespace();
        let (first, last) = (self.span_at(window.start), self.span_at(window.end - 1));
        self.text.piece(first.to(last).range()).trim_matches(braces).parse().ok()
    }

    /// The superscript at `at`, if there is one before `end`, and the index after it.
    fn order_at(&self, at: usize, end: usize) -> Option<(Option<Window>, usize)> {
        match self.look(at) {
            Some((sup, Tok::Sup)) if sup < end => {
                let (argument, kind) = self.look(sup + 1)?;
                if argument >= end || !(kind == Tok::OpenBrace || self.begins_operand(kind)) {
                    return None;
                }
                let after = self.after(argument);
                Some((Some(argument..after), after))
            }
            _ => Some((None, at)),
        }
    }
}

/// A bar at the end of what is differentiated belongs to the derivative: first d/dt, then t = 0.
fn before_bar(body: Expr) -> (Expr, Option<Vec<Expr>>) {
    let Expr { kind, span } = body;
    match kind {
        Kind::At { body, lower, upper: None } => (*body, Some(lower)),
        Kind::Mul(mut factors) => {
            let Some(last) = factors.pop() else { return (Expr::new(Kind::Mul(factors), span), None) };
            let (last, point) = before_bar(last);
            factors.push(last);
            (Expr::new(Kind::Mul(factors), span), point)
        }
        Kind::Big { op, lower, upper, body } => {
            let (body, point) = before_bar(*body);
            (Expr::new(Kind::Big { op, lower, upper, body: Box::new(body) }, span), point)
        }
        kind => (Expr::new(kind, span), None),
    }
}
