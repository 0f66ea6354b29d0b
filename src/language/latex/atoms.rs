//! What an operand begins with.

use super::characters;
use super::commands::Role;
use super::reader::{Reader, Result};
use super::token::{Env, Fence, Tok};
use crate::formula::source::{Pieces, Span};
use crate::formula::{Accent, BinomialStyle, Enclosure, Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};

impl Reader<'_> {
    /// One atom, without scripts and arguments.
    pub fn atom(&mut self) -> Result<Expr> {
        while self.row && self.eat(Tok::Gap).is_some() {}
        let Some(kind) = self.peek() else { return self.stuck() };
        match kind {
            Tok::OpenBrace => self.brace_group(),
            Tok::Open(_) | Tok::Left(_) => self.bracket(),
            Tok::Rel(Rel::Lt) => self.angle(),
            Tok::Bar => self.bars(Enclosure::Abs),
            Tok::DoubleBar => self.bars(Enclosure::Norm),
            Tok::Begin(env) => self.table(env),
            Tok::Command(role) => self.command(role),
            _ => self.leaf(kind),
        }
    }

    /// An atom of one token.
    fn leaf(&mut self, kind: Tok) -> Result<Expr> {
        let at = self.pos;
        let word = |start: u32, end: u32| self.text.piece(start as usize..end as usize);
        let kind = match kind {
            Tok::Number => {
                let span = self.bump();
                return self.numeral(span);
            }
            Tok::Letter(_) | Tok::Symbol(_) => {
                let kind = Kind::Name(match self.tokens[at].kind {
                    Tok::Symbol(name) => name.to_owned(),
                    Tok::Letter(letter) => letter.to_string(),
                    _ => return self.stuck(),
                });
                match self.text_at(at).chars().next().and_then(characters::accent) {
                    Some(accent) => Kind::Accent(accent, Box::new(Expr::new(kind, self.span_at(at)))),
                    None => kind,
                }
            }
            Tok::Word(start, end) => Kind::Name(word(start, end).split_whitespace().collect()),
            Tok::Text(start, end) => {
                let content = word(start, end).trim().to_owned();
                if self.is_word_atom() { Kind::Name(content) } else { Kind::Text(content) }
            }
            Tok::Ellipsis | Tok::Range => Kind::Ellipsis,
            Tok::Dot if self.is_placeholder() => Kind::Name("cdot".to_owned()),
            Tok::Star if self.is_placeholder() => Kind::Name("ast".to_owned()),
            _ => return self.stuck(),
        };
        Ok(Expr::new(kind, self.bump()))
    }

    /// Braces that hold `\over` or a font switch.
    fn brace_group(&mut self) -> Result<Expr> {
        let window = self.inside(self.pos)?;
        let span = self.span_at(self.pos).to(self.span_at(window.end));
        let after = window.end + 1;
        let expr = self.expr_in(window)?;
        self.pos = after;
        Ok(Expr::new(expr.kind, span))
    }

    fn table(&mut self, env: Env) -> Result<Expr> {
        let window = self.inside(self.pos)?;
        let after = window.end + 1;
        let expr = self.environment(env, window, self.pos);
        self.pos = after;
        expr
    }

    /// An operator alone, as in `f(\cdot, \cdot)`.
    fn is_placeholder(&self) -> bool {
        match self.look(self.pos + 1) {
            None => true,
            Some((_, kind)) => matches!(
                kind,
                Tok::Comma
                    | Tok::Semicolon
                    | Tok::Close(_)
                    | Tok::Right(_)
                    | Tok::Bar
                    | Tok::DoubleBar
                    | Tok::Rel(_)
            ),
        }
    }

    fn command(&mut self, role: Role) -> Result<Expr> {
        match role {
            Role::Function => self.function(),
            Role::Big(op) => self.big(op),
            Role::Integral => self.integral(),
            Role::IntegralOver(count) => self.integral_over(count),
            Role::Fraction => self.fraction(),
            Role::Accent(accent) => self.accented(accent),
            Role::Binomial => self.binomial(),
            Role::Root => self.root(),
            Role::Brace => self.brace(),
            Role::Switch(accent) => self.switch(accent),
            Role::Lines => self.plain(Env::Rows),
            Role::Plain(env) => self.plain(env),
            Role::Stacked if self.text_at(self.pos) == "\\underset" => self.with_bounds(),
            Role::Stacked => {
                let name = self.text_at(self.pos);
                let problem = Diagnostic::error(
                    Code::UnsupportedLatex,
                    format!(
                        "{name} is read only where it makes a relation, as \\stackrel{{\\text{{def}}}}{{=}}"
                    ),
                );
                Err(Box::new(problem.at(self.span_at(self.pos))))
            }
            _ => self.stuck(),
        }
    }

    fn accented(&mut self, accent: Accent) -> Result<Expr> {
        let start = self.bump().start;
        let body = self.argument()?;
        // \mathbf{B'} is the derivative of \mathbf B.
        if let Kind::Prime(function, order) = body.kind {
            let function = self.node(Kind::Accent(accent, function), start);
            return Ok(self.node(Kind::Prime(Box::new(function), order), start));
        }
        Ok(self.node(Kind::Accent(accent, Box::new(body)), start))
    }

    fn binomial(&mut self) -> Result<Expr> {
        let start = self.bump().start;
        let above = Box::new(self.part()?);
        let below = Box::new(self.part()?);
        Ok(self.node(Kind::Binomial(above, below, BinomialStyle::Stacked), start))
    }

    /// `\substack{…}`, `\cases{…}`, `\pmatrix{…}`
    fn plain(&mut self, env: Env) -> Result<Expr> {
        let at = self.pos;
        let start = self.bump().start;
        if self.peek() != Some(Tok::OpenBrace) {
            return self.stuck();
        }
        let window = self.inside(self.pos)?;
        let after = window.end + 1;
        let expr = self.environment(env, window, at)?;
        self.pos = after;
        Ok(self.node(expr.kind, start))
    }

    /// `\sin x`: the argument is a bracket, or the plain factors that follow.
    fn function(&mut self) -> Result<Expr> {
        let start = self.start();
        let span = self.bump();
        let name = self.text.piece(span.range()).trim_start_matches('\\').to_owned();
        let mut callee = Expr::new(Kind::Name(name), span);
        while let Some(Tok::Sub | Tok::Sup | Tok::Prime(_)) = self.peek() {
            let before = self.pos;
            callee = self.function_scripts(callee, start)?;
            if self.pos == before {
                break;
            }
        }
        self.applied_to_rest(callee, start)
    }

    /// `\underset{x}{\max} f(x)`: an operator with its bounds.
    fn with_bounds(&mut self) -> Result<Expr> {
        let start = self.bump().start;
        let below = self.argument()?;
        let braces = self.peek() == Some(Tok::OpenBrace);
        let window =
            if braces { self.inside(self.pos)? } else { self.pos..self.after(self.pos).min(self.end) };
        let inner = self.trim(window.clone());
        let end = if braces { window.end + 1 } else { window.end };
        if let [only] = &self.tokens[inner.clone()]
            && let Tok::Command(Role::Big(op)) = only.kind
        {
            self.pos = end;
            let body = self.deeper(Self::product)?;
            let kind = Kind::Big { op, lower: vec![below], upper: None, body: Box::new(body) };
            return Ok(self.node(kind, start));
        }
        let operator = match self.expr_in(inner)? {
            Expr { kind: Kind::Text(word), span } if word.bytes().all(|byte| byte.is_ascii_alphabetic()) => {
                Expr::new(Kind::Name(word), span)
            }
            other => other,
        };
        self.pos = end;
        let callee = self.node(Kind::Subscript(Box::new(operator), vec![below]), start);
        self.applied_to_rest(callee, start)
    }

    /// A function before its argument: a bracket, or the plain factors that follow.
    fn applied_to_rest(&mut self, callee: Expr, start: usize) -> Result<Expr> {
        if matches!(self.peek(), Some(Tok::Open(Fence::Paren) | Tok::Left(Fence::Paren)))
            && let Some(close) = self.partner(self.pos)
            && matches!(self.tokens[close].kind, Tok::Close(Fence::Paren) | Tok::Right(Fence::Paren))
        {
            let groups = self.arguments()?;
            return Ok(self.node(Kind::Apply(Box::new(callee), groups), start));
        }
        let mut factors = Vec::new();
        let from = self.start();
        while let Some(
            Tok::Number
            | Tok::Letter(_)
            | Tok::Symbol(_)
            | Tok::Begin(Env::Matrix(_))
            | Tok::Command(Role::Accent(_) | Role::Fraction | Role::Root | Role::Function),
        ) = self.peek()
        {
            let is_function = matches!(self.peek(), Some(Tok::Command(Role::Function)));
            if is_function && !factors.is_empty() {
                break;
            }
            factors.push(self.deeper(Self::postfix)?);
        }
        let argument = match factors.len() {
            0 => return Ok(callee),
            1 => factors.remove(0),
            _ => self.node(Kind::Mul(factors), from),
        };
        Ok(self.node(Kind::Apply(Box::new(callee), vec![vec![argument]]), start))
    }

    /// `\log_2`, `\sin^2`, before the argument.
    fn function_scripts(&mut self, callee: Expr, start: usize) -> Result<Expr> {
        self.scripts(callee, start, self.pos)
    }

    fn root(&mut self) -> Result<Expr> {
        let start = self.start();
        let span = self.bump();
        let name = |name: &str| Box::new(Expr::new(Kind::Name(name.to_owned()), span));
        let is_character = self.text.piece(span.range()).starts_with('√');
        if self.peek() == Some(Tok::Open(Fence::Square)) {
            let window = self.inside(self.pos)?;
            let index = self.expr_in(window.clone())?;
            self.pos = window.end + 1;
            let body = self.argument()?;
            return Ok(self.node(Kind::Apply(name("root"), vec![vec![body, index]]), start));
        }
        let body = match self.peek() {
            // √2, √(x + 1): brackets only show how far the root reaches
            Some(Tok::Number) if is_character => self.deeper(Self::atom)?,
            _ => self.argument()?,
        };
        Ok(self.node(Kind::Apply(name("sqrt"), vec![vec![body]]), start))
    }

    /// `\underbrace{items}_{label}`
    fn brace(&mut self) -> Result<Expr> {
        let start = self.start();
        self.bump();
        let items = if self.peek() == Some(Tok::OpenBrace) {
            let window = self.inside(self.pos)?;
            let items = self.list_in(window.clone())?;
            self.pos = window.end + 1;
            items
        } else {
            vec![self.argument()?]
        };
        let label = match self.peek() {
            Some(Tok::Sub | Tok::Sup) => {
                self.bump();
                if self.peek() == Some(Tok::OpenBrace) {
                    let window = self.inside(self.pos)?;
                    let blank = self.is_blank(window.clone());
                    let label = if blank { None } else { Some(self.row_in(window.clone())?) };
                    self.pos = window.end + 1;
                    label
                } else {
                    Some(self.argument()?)
                }
            }
            _ => None,
        };
        Ok(self.node(Kind::Brace(items, label.map(Box::new)), start))
    }

    /// `\bf x` holds to the end of the group; `\rm area` is a name.
    fn switch(&mut self, accent: Option<Accent>) -> Result<Expr> {
        let start = self.start();
        self.bump();
        let rest = self.trim(self.pos..self.end);
        let letters = rest.clone().all(|at| matches!(self.tokens[at].kind, Tok::Letter(_)));
        let body = if letters && rest.len() > 1 && accent.is_none() {
            let span = self.span_of(rest.clone());
            self.pos = rest.end;
            let name: String = rest.map(|at| self.text_at(at)).collect();
            Expr::new(Kind::Name(name), span)
        } else {
            let end = self.end;
            let body = self.row_in(rest)?;
            self.pos = end;
            body
        };
        Ok(match accent {
            Some(accent) => self.node(Kind::Accent(accent, Box::new(body)), start),
            None => Expr::new(body.kind, self.since(start)),
        })
    }

    /// `|x|` and `||x||` written with plain bars.
    fn bars(&mut self, enclosure: Enclosure) -> Result<Expr> {
        let open = self.bump();
        self.bars.push(enclosure);
        let body = self.deeper(Self::sum)?;
        let close = self.peek();
        let closed = close.is_some_and(|kind| self.closes_bar(kind));
        self.bars.pop();
        if !closed {
            let problem = Diagnostic::error(Code::Unbalanced, "'|' without a closing '|'").at(open);
            return Err(Box::new(match close {
                Some(_) => problem.label(self.span_at(self.pos), "expected the closing bar here"),
                None => problem.hint("add the closing bar"),
            }));
        }
        if close == Some(Tok::DoubleBar) && enclosure == Enclosure::Abs {
            // the second half of `||` opens or closes something else
            let span = self.tokens[self.pos].span();
            self.tokens[self.pos].cut_front();
            self.tokens[self.pos].kind = Tok::Bar;
            let kind = Kind::Enclosed(enclosure, Box::new(body));
            return Ok(Expr::new(kind, Span::new(open.start, span.start + 1)));
        }
        self.bump();
        Ok(self.node(Kind::Enclosed(enclosure, Box::new(body)), open.start))
    }
}
