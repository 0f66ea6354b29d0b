//! What other systems write: `F.subs(t, 2)`, `F /. t -> 2`, `[1 2 3]`, `(0; 1)`, `a .* b`, `A.v`, `np.dot(a, b)`.

use super::super::token::{Bracket, Token, TokenKind};
use super::operand::{Cell, Inside};
use super::{Node, Op, Parsed, Parser};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Quotient, Rel};

/// Names before which a point says whose function follows: `np.dot(a, b)`.
const LIBRARIES: &[&str] =
    &["np", "numpy", "linalg", "la", "sp", "sympy", "sym", "math", "scipy", "LinearAlgebra"];

/// How high what [`termwise`] adds is.
pub(super) const HEIGHT_OF_TERMWISE: u32 = 4;

/// An operator entry by entry: `a .* b` is termwise((x, y) -> x y, a, b).
pub(super) fn termwise(sign: TokenKind, left: Expr, right: Expr, span: Span) -> Kind {
    let name = |name: &str| Expr { span, ..Expr::name(name) };
    let (x, y) = (name("x"), name("y"));
    let parameters = vec![x.clone(), y.clone()];
    let body = match sign {
        TokenKind::Caret => Kind::Pow(Box::new(x), Box::new(y)),
        TokenKind::Slash => Kind::Div(Box::new(x), Box::new(y), Quotient::Slash),
        _ => Kind::Mul(vec![x, y]),
    };
    let each = Kind::Lambda(parameters, Box::new(Expr::new(body, span)));
    Kind::Apply(Box::new(name("termwise")), vec![vec![Expr::new(each, span), left, right]])
}

impl Parser<'_> {
    /// `25%`; before another operand it is the sign of a remainder elsewhere.
    pub(super) fn percent(&mut self, node: Node) -> Parsed<Node> {
        let sign = self.bump();
        if self.at_operand() && !self.at_word_of() {
            return Err(self.percent_or_remainder(sign));
        }
        let span = node.extent.to(sign.span());
        let hundred = Expr { span: sign.span(), ..Expr::int(100) };
        let quotient = Kind::Div(Box::new(node.expr), Box::new(hundred), Quotient::Slash);
        let quotient = Expr::new(quotient, span);
        self.node(Kind::Group(Box::new(quotient)), span, node.height + 1)
    }

    /// Whether "of" stands here between a percentage and what it is of.
    pub(super) fn at_word_of(&self) -> bool {
        let percent = self.last.is_some_and(|last| self.text_of(last) == "%");
        percent && matches!(self.text_of(self.peek()), "of" | "von" | "de" | "of the")
    }

    /// Whether `t$2` stands here, t twice: diff(t^4, t$2).
    pub(super) fn counts_derivatives(&self) -> bool {
        let next = self.tokens.get(self.at + 1);
        self.last.is_some_and(|last| last.kind == TokenKind::Name)
            && next.is_some_and(|next| next.kind == TokenKind::Number)
    }

    /// Whether a function without a name begins here: `function(t) t^2`, `@(t) t^2`, `lambda t: t^2`.
    pub(super) fn at_function(&self) -> bool {
        let token = self.peek();
        let kind = |at: usize| self.tokens.get(self.at + at).map(|token| token.kind);
        match (token.kind, self.text_of(token)) {
            (TokenKind::Name, "function") | (TokenKind::Unknown, "@") => {
                kind(1) == Some(TokenKind::Open(Bracket::Paren))
            }
            (TokenKind::Name, "lambda") => {
                let mut at = 1;
                while kind(at) == Some(TokenKind::Name) && kind(at + 1) == Some(TokenKind::Comma) {
                    at += 2;
                }
                kind(at) == Some(TokenKind::Name) && kind(at + 1) == Some(TokenKind::Colon)
            }
            _ => false,
        }
    }

    /// A function without a name, of which [`Self::at_function`] holds.
    pub(super) fn anonymous_function(&mut self) -> Parsed<Node> {
        let word = self.bump();
        let mut names = Vec::new();
        if self.peek().kind == TokenKind::Name {
            while self.peek().kind == TokenKind::Name {
                let name = self.bump();
                names.push(self.name(name)?.expr);
                if self.bump().kind == TokenKind::Colon {
                    break;
                }
            }
        } else {
            let inside = self.inside(false)?;
            names = self.items(inside, "a parameter")?.list;
        }
        let body = self.expr()?;
        let span = word.span().to(body.extent);
        self.node(Kind::Lambda(names, Box::new(body.expr)), span, body.height)
    }

    /// Whether a function is given to a name here: `f: t -> t^2`.
    pub(super) fn at_mapping(&self) -> bool {
        let kind = |at: usize| self.tokens.get(self.at + at).map(|token| token.kind);
        self.peek().kind == TokenKind::Colon
            && self.open.is_empty()
            && kind(1) == Some(TokenKind::Name)
            && kind(2) == Some(TokenKind::Arrow)
    }

    /// Whether `<-` stands here, which gives a value in R.
    pub(super) fn at_assignment(&self) -> bool {
        let token = |at: usize| self.tokens.get(self.at + at);
        let minus = token(1).is_some_and(|minus| minus.kind == TokenKind::Minus && !minus.spaced);
        self.peek().kind == TokenKind::Relation(Rel::Lt) && minus && token(2).is_some_and(|next| next.spaced)
    }

    /// Whether a function follows `<-`.
    pub(super) fn assigns_function(&self) -> bool {
        let token = |at: usize| self.tokens.get(self.at + at);
        let opens = token(3).is_some_and(|token| token.kind == TokenKind::Open(Bracket::Paren));
        token(2).is_some_and(|word| self.text_of(*word) == "function") && opens
    }

    fn is_point(&self, token: Option<&Token>) -> bool {
        token.is_some_and(|token| {
            token.kind == TokenKind::Unknown && !token.spaced && self.text_of(*token) == "."
        })
    }

    /// The operator that a point begins: `x.^2`, `a .* b`, or the point alone between operands, `A.v`.
    pub(super) fn point_operator(&self) -> Option<Op> {
        let [point, next] = self.tokens.get(self.at..self.at + 2)? else { return None };
        if point.kind != TokenKind::Unknown || self.text_of(*point) != "." {
            return None;
        }
        match next.kind {
            TokenKind::Star | TokenKind::Slash | TokenKind::Caret if !next.spaced => {
                Some(Op::Termwise(next.kind))
            }
            TokenKind::Name | TokenKind::Open(Bracket::Square | Bracket::Brace)
                if next.spaced == point.spaced =>
            {
                Some(Op::Dot)
            }
            TokenKind::Open(Bracket::Paren) if next.spaced && point.spaced => Some(Op::Dot),
            _ => None,
        }
    }

    /// Takes the names of libraries before a name: `np.linalg.det(A)` is det(A).
    pub(super) fn past_libraries(&mut self, mut name: Token) -> Token {
        while LIBRARIES.contains(&self.text_of(name))
            && self.is_point(self.tokens.get(self.at))
            && self.tokens.get(self.at + 1).is_some_and(|next| next.kind == TokenKind::Name && !next.spaced)
            && self.tokens.get(self.at + 2).is_some_and(|next| {
                !next.spaced && (next.kind == TokenKind::Open(Bracket::Paren) || self.text_of(*next) == ".")
            })
        {
            self.bump();
            name = self.bump();
        }
        name
    }

    /// Whether a function is defined here as in Python: `def f(t): return t**2`.
    pub(super) fn at_definition(&self) -> bool {
        let kind = |at: usize| self.tokens.get(self.at + at).map(|token| token.kind);
        self.text_of(self.peek()) == "def"
            && kind(1) == Some(TokenKind::Name)
            && kind(2) == Some(TokenKind::Open(Bracket::Paren))
    }

    /// A definition of which [`Self::at_definition`] holds.
    pub(super) fn definition_elsewhere(&mut self) -> Parsed<Node> {
        let word = self.bump();
        let head = self.operand(None)?;
        if self.peek().kind != TokenKind::Colon {
            return Err(self.unexpected());
        }
        let colon = self.bump();
        if self.text_of(self.peek()) != "return" {
            return Err(self.unexpected());
        }
        self.bump();
        let body = self.expr()?;
        let span = word.span().to(body.extent);
        let height = head.height.max(body.height);
        let link = Link { rel: Rel::Define, span: colon.span(), expr: body.expr };
        self.node(Kind::Chain(Box::new(head.expr), vec![link]), span, height)
    }

    /// Whether the values of an index follow in parentheses of a call: `sum(i^2 for i in range(5))`.
    pub(super) fn lists_in_call(&self, open: Token) -> bool {
        let at = self.tokens.partition_point(|token| token.span().start < open.span().start);
        let before = at.checked_sub(1).and_then(|at| self.tokens.get(at));
        !open.spaced && before.is_some_and(|before| before.kind == TokenKind::Name)
    }

    /// The end of a range that goes on with a colon, `0:4`, as other systems write 0..4.
    pub(super) fn range_by_colon(&mut self, values: Expr) -> Parsed<Expr> {
        if self.peek().kind != TokenKind::Colon {
            return Ok(values);
        }
        self.bump();
        let end = self.expr()?.expr;
        if self.peek().kind == TokenKind::Colon {
            return Err(self.unexpected());
        }
        let span = values.span.to(end.span);
        Ok(Expr::new(Kind::Range(Box::new(values), Box::new(end)), span))
    }

    /// Whether a method is called here: `.subs(t, 2)`.
    pub(super) fn at_method(&self) -> bool {
        let token = |at: usize| self.tokens.get(self.at + at);
        let tight = |at: usize, kind| token(at).is_some_and(|token| token.kind == kind && !token.spaced);
        self.is_point(token(0)) && tight(1, TokenKind::Name) && tight(2, TokenKind::Open(Bracket::Paren))
    }

    /// A function called as a method of its first argument.
    pub(super) fn method(&mut self, object: Node) -> Parsed<Node> {
        self.bump();
        let name = self.bump();
        let callee = self.name(name)?;
        let extent = object.extent;
        let mut call = self.call(callee)?;
        if let Kind::Apply(_, groups) = &mut call.expr.kind
            && let Some(first) = groups.first_mut()
        {
            first.insert(0, object.expr);
        }
        call.height = call.height.max(object.height + 1);
        call.extent = extent.to(call.extent);
        call.expr.span = call.extent;
        Ok(call)
    }

    /// Whether values are put in here: `/. t -> 2`.
    pub(super) fn at_rules(&self) -> bool {
        self.peek().kind == TokenKind::Slash && self.is_point(self.tokens.get(self.at + 1))
    }

    /// A formula with values for names, as `subs` has them.
    pub(super) fn with_rules(&mut self, formula: Node) -> Parsed<Node> {
        self.bump();
        self.bump();
        let rules = self.expr()?;
        let span = formula.extent.to(rules.extent);
        let height = formula.height.max(rules.height) + 1;
        let items = match rules.expr.kind {
            Kind::Set(items, None) | Kind::List(items) => items,
            _ => vec![rules.expr],
        };
        let mut arguments = vec![formula.expr];
        for rule in items {
            match rule.kind {
                Kind::Lambda(mut names, value) if names.len() == 1 => {
                    let relation = Expr::relation(names.remove(0), Rel::Eq, *value);
                    arguments.push(Expr { span: rule.span, ..relation });
                }
                _ => return Err(self.no_rule(rule.span)),
            }
        }
        let callee = Expr { span: formula.extent, ..Expr::name("subs") };
        self.node(Kind::Apply(Box::new(callee), vec![arguments]), span, height)
    }

    /// The numbers between the square brackets that open here, if only blanks stand between them.
    ///
    /// # Errors
    /// A sign that might be that of an item or a difference: `[1 -1]`.
    pub(super) fn spaced_numbers(&mut self) -> Parsed<Option<Inside>> {
        let open = self.peek();
        if open.kind != TokenKind::Open(Bracket::Square) {
            return Ok(None);
        }
        let rest = &self.tokens[self.at + 1..];
        let Some(end) =
            rest.iter().position(|token| matches!(token.kind, TokenKind::Open(_) | TokenKind::Close(_)))
        else {
            return Ok(None);
        };
        if rest[end].kind != TokenKind::Close(Bracket::Square) {
            return Ok(None);
        }
        let (mut numbers, mut signed, mut before) = (false, None, TokenKind::Semicolon);
        for token in &rest[..end] {
            match (before, token.kind) {
                (TokenKind::Number, TokenKind::Number) if token.spaced => numbers = true,
                (TokenKind::Semicolon | TokenKind::Slash, TokenKind::Number)
                | (TokenKind::Number, TokenKind::Semicolon) => {}
                (TokenKind::Number, TokenKind::Slash) if !token.spaced => {}
                (TokenKind::Number, TokenKind::Minus) if token.spaced => signed = signed.or(Some(*token)),
                (TokenKind::Semicolon, TokenKind::Minus) => {}
                // A sign belongs to what follows it at once.
                (TokenKind::Minus, TokenKind::Number) if !token.spaced => {}
                _ => return Ok(None),
            }
            before = token.kind;
        }
        // [1 -3 2] has no commas; [1 -1] may be a difference.
        if let Some(sign) = signed.filter(|_| !numbers) {
            return Err(self.signed_item(sign));
        }
        if !numbers {
            return Ok(None);
        }
        self.bump();
        let mut rows: Vec<Vec<Cell>> = vec![Vec::new()];
        loop {
            let token = self.peek();
            match token.kind {
                TokenKind::Semicolon => {
                    self.bump();
                    rows.push(Vec::new());
                }
                TokenKind::Close(_) => break,
                _ => {
                    let item = Some(self.number_of_list()?);
                    if let Some(row) = rows.last_mut() {
                        row.push(Cell { item, end: token, condition: None });
                    }
                }
            }
        }
        let close = self.bump();
        Ok(Some(Inside { rows, bar: None, open, close }))
    }

    /// -1/2
    fn number_of_list(&mut self) -> Parsed<Node> {
        let sign = (self.peek().kind == TokenKind::Minus).then(|| self.bump());
        let mut number = self.numeral()?;
        if self.peek().kind == TokenKind::Slash {
            self.bump();
            let below = self.numeral()?;
            let span = number.extent.to(below.extent);
            let kind = Kind::Div(Box::new(number.expr), Box::new(below.expr), Quotient::Slash);
            number = self.node(kind, span, number.height.max(below.height))?;
        }
        let Some(sign) = sign else { return Ok(number) };
        let span = sign.span().to(number.extent);
        let height = number.height;
        self.node(number.expr.negated().kind, span, height)
    }
}

/// A point with semicolons between its coordinates, `(0; 1)`, in one row.
pub(super) fn in_one_row(mut inside: Inside) -> Inside {
    let single = |row: &Vec<Cell>| matches!(row.as_slice(), [Cell { item: Some(_), .. }]);
    if inside.rows.len() > 1 && inside.rows.iter().all(single) {
        let mut row: Vec<Cell> = inside.rows.into_iter().flatten().collect();
        for cell in &mut row {
            if cell.end.kind == TokenKind::Semicolon {
                cell.end.kind = TokenKind::Comma;
            }
        }
        inside.rows = vec![row];
    }
    inside
}
