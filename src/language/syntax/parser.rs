//! Tokens to a formula tree.
//!
//! ```text
//! statement  = item [ "/." item ] { "," item }        several: Sequence; F /. t -> 2
//!            | "def" call ":" "return" item           a definition
//! item       = definition                             also what stands in brackets
//! definition = relation [ ":=" relation ]
//! relation   = function { rel function }              = == != < <= > >= ≈ ≡ in ⊆ => <=>
//! function   = range | parameters "->" function       t -> t^2, (i, n) -> i/n
//! range      = sum [ ".." sum ]                       0..n
//! sum        = [ "+" ] term { ( "+" | "-" ) term }
//! term       = "-" term | product
//! product    = factor { [ "*" | "/" | "mod" | "." | ".*" | "./" ] factor } from the left: 5/3 t = (5/3) t
//! factor     = "-" factor | power { "∘" power }       "-" only after a sign
//! power      = postfix [ ( "^" | "**" | ".^" ) exponent ] 2^3^2 = 2^(3^2)
//! exponent   = "-" exponent | "{" items "}" | power
//! postfix    = atom { "_" index | "'" | "!" | accent | "^{(" items ")}" | call | "." name call }
//! call       = "(" items { ";" items } ")"            see below
//! index      = digits | word | "{" items "}" | "(" items ")"
//! atom       = number | name | "..." | '"' words '"'
//!            | "(" items ")"                          one: parentheses, several: a tuple, also with ";"
//!            | "[" items { ";" items } "]"            a list, also of numbers with blanks; with ";" a matrix by rows
//!            | "{" items [ "|" item ] "}"             a set
//!            | "⌊" item "⌋" | "⌈" item "⌉" | "|" item "|" | special
//! special    = ("sum" | "prod" | "max" | "min" | "union" | "intersection")
//!                 "(" bound { "," ( bound | relation ) } "," item ")"   bound: i=0..n, i in S
//!            | "integral" "(" item "," name [ "=" sum ".." sum ] ")"
//!            | "cases" "(" item ( "if" item | "otherwise" ) { "," … } ")"
//!            | ("binomial" | "binom") "(" item "," item ")"
//!            | "compose" "(" item "," items ")"
//!            | ("abs" | "norm" | "floor" | "ceil" | "transpose") "(" item ")"
//!            | ("hat" | "bar" | "vec" | "tilde" | "dot" | "ddot"
//!               | "bold" | "script" | "blackboard") "(" item ")"
//! items      = [ item { "," item } ]
//! ```
//!
//! **Names.** A run of letters is one name (`alpha`, `polar`), a Greek letter is one
//! by itself (`α` = `alpha` = `\alpha`). Digits directly after a name are its index:
//! `t12` = `t_12` = `t_{12}`, and `t1t2` is a product. An index with a leading zero is
//! kept as a name: `b_{01}`. `p_ij` has the one index `ij`, `p_{i,j}` has two.
//! Unicode indices and exponents (`t₁₂`, `t⁻¹`) read as `t_{12}`, `t^{-1}`.
//!
//! **Call or product?** An opening parenthesis
//! - directly after a name (with its index, primes, accent, upper index), after a
//!   call, or after `(F∘G)` or `(t -> …)` makes a call: `f(t)`, `F'(t)`, `f(0)(1)`
//! - directly after other parentheses makes a call if it holds a comma or semicolon,
//!   as in `(f+g)(0,1)`; otherwise `(t+1)(t-1)` is a product
//! - directly after name and exponent makes a call of the power if the name has an
//!   index or the exponent is a bare name, as in `B_i^n(t)` and `B_1^2(t)`; otherwise a
//!   product, as in `t^2(t+1)`. A name in an exponent takes no call itself, unless it
//!   is a special one: `2^f(x)` is not `2^(f(x))`
//! - after a blank or a number makes a product: `c_2 (t1+t2)`, `2(t+1)`

mod call;
mod elsewhere;
mod index;
mod operand;
mod problem;

pub(crate) use call::{is_special, special_call};
pub(crate) use problem::{congruence, reach_of_mod};

use super::token::{Token, TokenKind};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Quotient, Rel, Sign, Term};
use crate::language::diagnostic::Diagnostic;

/// Brackets may be nested this deeply.
pub const MAX_DEPTH: usize = 256;

/// No tree is higher than this: it limits chains such as `1/2/3/…` that need no brackets.
pub const MAX_HEIGHT: u32 = 512;

/// The long numerals of a text (those over a hundred digits) may have this many digits in all.
///
/// Turning digits into a number is the one step whose cost is not linear.
pub const MAX_DIGITS: usize = 1_000_000;

/// Results inside the parser; boxed to keep the stack small.
type Parsed<T> = Result<T, Box<Diagnostic>>;

/// The formula of one statement, whose tokens are given.
pub(super) fn parse_statement(text: &str, tokens: &[Token]) -> Result<Expr, Diagnostic> {
    let mut parser = Parser::new(text, tokens);
    match parser.statement() {
        Ok(node) => Ok(node.expr),
        Err(problem) => Err(*problem),
    }
}

/// A subtree under construction.
struct Node {
    expr: Expr,
    /// What the parent must cover: more than the span of `expr` if that stood in braces.
    extent: Span,
    height: u32,
}

/// A binary operator or sign.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Op {
    Sign(Sign),
    Add(Sign),
    Mul,
    Div,
    /// `7 mod 3`
    Mod,
    /// `A.v`, a scalar product or one of matrices
    Dot,
    /// `a .* b`, entry by entry: the operator behind the point
    Termwise(TokenKind),
    Compose,
    Power,
    Range,
    Lambda,
    Relation(Rel),
}

/// How tightly an operator holds its operands; the numbers mean nothing but their order.
///
/// A sign holds looser than a product at the start of a term, tighter after an operator.
mod strength {
    pub(super) const DEFINE: u8 = 10;
    pub(super) const RELATION: u8 = 20;
    pub(super) const LAMBDA: u8 = 30;
    pub(super) const RANGE: u8 = 40;
    pub(super) const SUM: u8 = 50;
    pub(super) const SIGN_OF_TERM: u8 = 55;
    pub(super) const PRODUCT: u8 = 60;
    pub(super) const SIGN_OF_FACTOR: u8 = 65;
    pub(super) const COMPOSE: u8 = 70;
    pub(super) const SIGN_OF_POWER: u8 = 75;
    pub(super) const POWER: u8 = 80;
}

impl Op {
    fn strength(self) -> u8 {
        match self {
            Op::Relation(Rel::Define) => strength::DEFINE,
            Op::Relation(_) => strength::RELATION,
            Op::Lambda => strength::LAMBDA,
            Op::Range => strength::RANGE,
            Op::Add(_) => strength::SUM,
            Op::Sign(_) => strength::SIGN_OF_TERM,
            Op::Termwise(TokenKind::Caret) => strength::POWER,
            Op::Mul | Op::Div | Op::Mod | Op::Dot | Op::Termwise(_) => strength::PRODUCT,
            Op::Compose => strength::COMPOSE,
            Op::Power => strength::POWER,
        }
    }

    fn groups_from_the_right(self) -> bool {
        matches!(self, Op::Power | Op::Lambda | Op::Sign(_) | Op::Termwise(TokenKind::Caret))
    }
}

/// An operator that waits for its right operand.
struct Pending {
    op: Op,
    strength: u8,
    /// `None` for a sign.
    left: Option<Node>,
    /// The operator; for a product by juxtaposition the token that follows it.
    token: Token,
}

struct Parser<'a> {
    text: &'a str,
    tokens: &'a [Token],
    at: usize,
    /// The last token taken.
    last: Option<Token>,
    /// The brackets that are open, outermost first.
    open: Vec<Token>,
    digits_left: usize,
}

impl<'a> Parser<'a> {
    fn new(text: &'a str, tokens: &'a [Token]) -> Self {
        let mut parser =
            Parser { text, tokens, at: 0, last: None, open: Vec::new(), digits_left: MAX_DIGITS };
        parser.skip_line_ends();
        parser
    }

    fn skip_line_ends(&mut self) {
        while self.tokens.get(self.at).is_some_and(|token| token.kind == TokenKind::Newline) {
            self.at += 1;
        }
    }

    fn peek(&self) -> Token {
        self.tokens.get(self.at).copied().unwrap_or_else(|| Token::end_after(self.tokens.last()))
    }

    fn bump(&mut self) -> Token {
        let token = self.peek();
        if token.kind != TokenKind::End {
            self.at += 1;
            self.skip_line_ends();
            self.last = Some(token);
        }
        token
    }

    fn text_of(&self, token: Token) -> &'a str {
        token.text(self.text)
    }

    /// A new node over children of at most the given height.
    fn node(&self, kind: Kind, span: Span, children: u32) -> Parsed<Node> {
        let height = children + 1;
        if height > MAX_HEIGHT {
            return Err(self.too_deep(self.last.map_or(span, Token::span)));
        }
        Ok(Node { expr: Expr::new(kind, span), extent: span, height })
    }

    fn statement(&mut self) -> Parsed<Node> {
        let mut first = if self.at_definition() { self.definition_elsewhere()? } else { self.expr()? };
        while self.at_rules() {
            first = self.with_rules(first)?;
        }
        let mut rest = Vec::new();
        let mut height = first.height;
        let mut span = first.extent;
        while matches!(self.peek().kind, TokenKind::Comma | TokenKind::And) {
            let comma = self.bump();
            if self.peek().kind == TokenKind::End {
                return Err(self.missing_operand(Some(comma)));
            }
            let item = self.expr()?;
            height = height.max(item.height);
            span = span.to(item.extent);
            rest.push(item.expr);
        }
        if self.peek().kind != TokenKind::End {
            return Err(self.unexpected());
        }
        if rest.is_empty() {
            return Ok(first);
        }
        rest.insert(0, first.expr);
        self.node(Kind::Sequence(rest), span, height)
    }

    /// One item: everything down to a comma, a closing bracket or the end.
    ///
    /// This and the functions through which it calls itself are cut small, because
    /// their frames are what deep nesting puts on the stack.
    fn expr(&mut self) -> Parsed<Node> {
        let mut stack: Vec<Pending> = Vec::new();
        loop {
            self.signs(&mut stack)?;
            let operand = self.operand_after(stack.last());
            let operand = self.power_calls(&mut stack, operand?);
            let done = self.operator_after(&mut stack, operand?);
            if let Some(node) = done? {
                return Ok(node);
            }
        }
    }

    /// Takes the signs before an operand; after an operator only minus may stand.
    fn signs(&mut self, stack: &mut Vec<Pending>) -> Parsed<()> {
        loop {
            let token = self.peek();
            let sign = match token.kind {
                TokenKind::Minus => Sign::Minus,
                TokenKind::Plus if stack.is_empty() => Sign::Plus,
                _ => return Ok(()),
            };
            self.bump();
            let strength = match stack.last() {
                Some(top) if top.strength >= strength::COMPOSE => strength::SIGN_OF_POWER,
                Some(top) if top.strength >= strength::PRODUCT => strength::SIGN_OF_FACTOR,
                _ => strength::SIGN_OF_TERM,
            };
            self.wait(stack, Pending { op: Op::Sign(sign), strength, left: None, token })?;
        }
    }

    fn operand_after(&mut self, top: Option<&Pending>) -> Parsed<Node> {
        match top {
            Some(top) if top.op == Op::Power => self.exponent(),
            _ => self.operand(top.map(|top| top.token)),
        }
    }

    /// `B_i^n(t)`: a parenthesis after an exponent may call the power.
    fn power_calls(&mut self, stack: &mut Vec<Pending>, mut operand: Node) -> Parsed<Node> {
        // B^3_1 is B_1^3
        if self.peek().kind == TokenKind::Underscore
            && let Some(top) = stack.last_mut().filter(|top| top.op == Op::Power)
            && let Some(base) = top.left.take_if(|base| matches!(base.expr.kind, Kind::Name(_)))
        {
            top.left = Some(self.subscript(base)?);
        }
        while self.at_call()
            && let Some(power) = stack.pop_if(|top| top.op == Op::Power)
        {
            if !power.left.as_ref().is_some_and(|base| operand::calls_power(&base.expr, &operand.expr)) {
                stack.push(power);
                break;
            }
            let callee = self.combine(power, operand)?;
            operand = self.called(callee)?;
        }
        Ok(operand)
    }

    fn called(&mut self, callee: Node) -> Parsed<Node> {
        let call = self.call(callee)?;
        self.postfix(call, false)
    }

    /// Takes the operator after an operand; without one the item is complete.
    fn operator_after(&mut self, stack: &mut Vec<Pending>, operand: Node) -> Parsed<Option<Node>> {
        let Some(op) = self.infix()? else {
            return self.reduce(stack, operand, 0).map(Some);
        };
        let token = self.peek();
        let strength = op.strength();
        let floor = if op.groups_from_the_right() { strength + 1 } else { strength };
        let left = self.reduce(stack, operand, floor)?;
        self.check_left(op, &left, token)?;
        let two = self.at_assignment() || matches!(op, Op::Termwise(_));
        if op == Op::Mod || self.at_word_of() || !self.at_operand() {
            self.bump();
        }
        if two {
            self.bump();
        }
        self.wait(stack, Pending { op, strength, left: Some(left), token })?;
        Ok(None)
    }

    fn wait(&self, stack: &mut Vec<Pending>, pending: Pending) -> Parsed<()> {
        // Each waiting operator adds to the height, so the stack never needs to be higher.
        if stack.len() >= MAX_HEIGHT as usize {
            return Err(self.too_deep(pending.token.span()));
        }
        stack.push(pending);
        Ok(())
    }

    /// Gives the operators of at least the given strength their right operand.
    fn reduce(&self, stack: &mut Vec<Pending>, mut right: Node, floor: u8) -> Parsed<Node> {
        while stack.last().is_some_and(|top| top.strength >= floor)
            && let Some(top) = stack.pop()
        {
            right = self.combine(top, right)?;
        }
        Ok(right)
    }

    /// The operator at this place, a product if an operand follows directly.
    fn infix(&self) -> Parsed<Option<Op>> {
        let token = self.peek();
        if let Some(problem) = self.x_for_times() {
            return Err(problem);
        }
        Ok(Some(match token.kind {
            TokenKind::Plus => Op::Add(Sign::Plus),
            TokenKind::Minus => Op::Add(Sign::Minus),
            TokenKind::Star => Op::Mul,
            TokenKind::Slash if self.at_rules() => return Ok(None),
            TokenKind::Slash => Op::Div,
            TokenKind::Caret => Op::Power,
            TokenKind::Compose => Op::Compose,
            TokenKind::Name if token.spaced && self.text_of(token) == "mod" => Op::Mod,
            TokenKind::Unknown if let Some(op) = self.point_operator() => op,
            TokenKind::DotDot => Op::Range,
            TokenKind::Arrow => Op::Lambda,
            TokenKind::Relation(_) if self.at_assignment() => match self.assigns_function() {
                true => Op::Relation(Rel::Define),
                false => return Err(self.assignment(token)),
            },
            TokenKind::Relation(rel) => Op::Relation(rel),
            TokenKind::Colon if self.at_mapping() => Op::Relation(Rel::Define),
            TokenKind::Name if self.at_word_of() => Op::Mul,
            TokenKind::Number
                if self.last.is_some_and(|last| last.kind == TokenKind::Number) && !self.after_power() =>
            {
                return Err(self.two_numbers());
            }
            _ if self.at_operand() => Op::Mul,
            _ => return Ok(None),
        }))
    }

    /// Whether a number here begins a further factor: 0^3 1^2, and f(0^2 1) among the arguments of a call.
    fn after_power(&self) -> bool {
        let kind = |at: Option<usize>| at.and_then(|at| self.tokens.get(at)).map(|token| token.kind);
        let exponent = kind(self.at.checked_sub(2)) == Some(TokenKind::Caret);
        let called =
            |open: usize| !self.tokens[open].spaced && kind(open.checked_sub(1)) == Some(TokenKind::Name);
        exponent
            && (kind(Some(self.at + 1)) == Some(TokenKind::Caret) || self.enclosing().is_some_and(called))
    }

    /// Refuses left operands that an operator cannot have.
    fn check_left(&self, op: Op, left: &Node, token: Token) -> Parsed<()> {
        match (op, &left.expr.kind) {
            (Op::Relation(Rel::Define), Kind::Chain(..)) => Err(self.bad_definition(left, token)),
            (Op::Range, Kind::Range(..)) => Err(self.double_range(left, token)),
            (Op::Lambda, kind) if !is_parameters(kind) => Err(self.bad_parameters(left)),
            _ => Ok(()),
        }
    }

    fn combine(&self, pending: Pending, right: Node) -> Parsed<Node> {
        let Pending { op, left, token, .. } = pending;
        let Some(mut left) = left else {
            is_no_remainder(&right.expr)?;
            let sign = if let Op::Sign(sign) = op { sign } else { Sign::Plus };
            let span = token.span().to(right.extent);
            return self.node(Kind::Add(vec![Term { sign, expr: right.expr }]), span, right.height);
        };
        if matches!(op, Op::Add(_) | Op::Mul | Op::Div | Op::Mod) {
            is_no_remainder(&left.expr).and_then(|()| is_no_remainder(&right.expr))?;
        }
        if op == Op::Relation(Rel::Equiv) {
            is_no_congruence(&right.expr)?;
        }
        let span = left.extent.to(right.extent);
        let height = left.height.max(right.height);
        // Sums, products, compositions and chains grow in place, so that long ones stay flat.
        match (op, &mut left.expr.kind) {
            (Op::Add(sign), Kind::Add(terms)) => {
                terms.push(Term { sign, expr: right.expr });
                return self.grown(left, span, right.height);
            }
            (Op::Mul, Kind::Mul(list)) | (Op::Compose, Kind::Compose(list)) => {
                list.push(right.expr);
                return self.grown(left, span, right.height);
            }
            (Op::Relation(rel), Kind::Chain(_, links)) => {
                links.push(Link { rel, span: token.span(), expr: right.expr });
                return self.grown(left, span, right.height);
            }
            _ => {}
        }
        let right = right.expr;
        let left = left.expr;
        let kind = match op {
            Op::Add(sign) | Op::Sign(sign) => {
                Kind::Add(vec![Term { sign: Sign::Plus, expr: left }, Term { sign, expr: right }])
            }
            Op::Mul => Kind::Mul(vec![left, right]),
            Op::Div => Kind::Div(Box::new(left), Box::new(right), Quotient::Slash),
            Op::Compose => Kind::Compose(vec![left, right]),
            Op::Mod | Op::Dot => {
                let name = if op == Op::Mod { "mod" } else { "dot" };
                let name = Expr { span: token.span(), ..Expr::name(name) };
                Kind::Apply(Box::new(name), vec![vec![left, right]])
            }
            Op::Termwise(sign) => elsewhere::termwise(sign, left, right, token.span()),
            Op::Power => operand::power(left, right),
            Op::Range => Kind::Range(Box::new(left), Box::new(right)),
            Op::Lambda => Kind::Lambda(parameters(left), Box::new(right)),
            Op::Relation(rel) => {
                Kind::Chain(Box::new(left), vec![Link { rel, span: token.span(), expr: right }])
            }
        };
        let within = if matches!(op, Op::Termwise(_)) { elsewhere::HEIGHT_OF_TERMWISE } else { 0 };
        self.node(kind, span, height.max(within))
    }

    /// A flat node that has taken in one more child.
    fn grown(&self, mut node: Node, span: Span, child: u32) -> Parsed<Node> {
        node.expr.span = span;
        node.extent = span;
        node.height = node.height.max(child + 1);
        if node.height > MAX_HEIGHT {
            return Err(self.too_deep(self.last.map_or(span, Token::span)));
        }
        Ok(node)
    }
}

/// Refuses `1 + 7 mod 3` and `7 mod 3 * 2`, which are read in two ways.
fn is_no_remainder(expr: &Expr) -> Parsed<()> {
    match expr.is_remainder() {
        true => Err(Box::new(problem::reach_of_mod(expr.span))),
        false => Ok(()),
    }
}

/// Refuses `7 ≡ 1 mod 3`.
fn is_no_congruence(right: &Expr) -> Parsed<()> {
    match right.is_remainder() {
        true => Err(Box::new(congruence(right.span))),
        false => Ok(()),
    }
}

fn is_parameter(kind: &Kind) -> bool {
    match kind {
        Kind::Name(_) => true,
        Kind::Subscript(base, _) | Kind::Accent(_, base) => is_parameter(&base.kind),
        _ => false,
    }
}

fn is_parameters(kind: &Kind) -> bool {
    match kind {
        Kind::Tuple(items) => items.iter().all(|item| is_parameter(&item.kind)),
        Kind::Group(inner) => is_parameter(&inner.kind),
        single => is_parameter(single),
    }
}

/// The parameters of a function, of which [`is_parameters`] holds.
fn parameters(left: Expr) -> Vec<Expr> {
    match left.kind {
        Kind::Tuple(items) => items,
        Kind::Group(inner) => vec![*inner],
        _ => vec![left],
    }
}
