//! Atoms, brackets and what is attached to them: indices, primes, exponents in Unicode.

use super::super::chars;
use super::super::token::{Bracket, Token, TokenKind};
use super::call::{accent_of, is_special};
use super::elsewhere::in_one_row;
use super::{MAX_DEPTH, Node, Parsed, Parser};
use crate::formula::source::Span;
use crate::formula::{Accent, BinomialStyle, Delimiter, Enclosure, Expr, Kind};
use crate::language::lexicon::families::is_binomial_coefficient;
use crate::language::lexicon::letters;
use crate::language::lexicon::roles::is_power_of_sum;
use crate::math::number::{Rational, parse_decimal, parse_scientific};

/// Digits of a numeral that are free of charge.
const SHORT_NUMERAL: usize = 100;

/// What stands between two separators inside brackets.
pub(super) struct Cell {
    /// The item, if there is one.
    pub(super) item: Option<Node>,
    /// The separator or bracket after it.
    pub(super) end: Token,
    /// The condition after `if`; `otherwise` is a condition without formula.
    pub(super) condition: Option<Option<Box<Node>>>,
}

/// The inside of a pair of brackets.
pub(super) struct Inside {
    /// The cells between commas, by rows between semicolons. At least one row with one cell.
    pub(super) rows: Vec<Vec<Cell>>,
    /// What follows a bar.
    pub(super) bar: Option<Box<Node>>,
    pub(super) open: Token,
    pub(super) close: Token,
}

impl Inside {
    pub(super) fn span(&self) -> Span {
        self.open.span().to(self.close.span())
    }

    fn is_empty(&self) -> bool {
        is_empty(&self.rows)
    }
}

/// Whether there is a single cell and nothing in it.
fn is_empty(rows: &[Vec<Cell>]) -> bool {
    matches!(rows, [row] if matches!(row.as_slice(), [cell] if cell.item.is_none()))
}

/// Items with the height of the tallest.
#[derive(Default)]
pub(super) struct Items {
    pub(super) list: Vec<Expr>,
    pub(super) height: u32,
}

impl Items {
    pub(super) fn push(&mut self, node: Node) {
        self.height = self.height.max(node.height);
        self.list.push(node.expr);
    }
}

fn is_bar_or_brace(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Bar | TokenKind::Open(Bracket::Brace))
}

impl Parser<'_> {
    /// Whether an operand begins here, so that it makes a product with the one before.
    pub(super) fn at_operand(&self) -> bool {
        use TokenKind::*;
        matches!(
            self.peek().kind,
            Number
                | Name
                | Text
                | Dots
                | Open(Bracket::Paren | Bracket::Square | Bracket::Floor | Bracket::Ceil)
        ) || self.peek().kind == Bar && !self.open.iter().any(|open| is_bar_or_brace(open.kind))
    }

    /// An atom with everything attached to it. `after` is the operator before it.
    pub(super) fn operand(&mut self, after: Option<Token>) -> Parsed<Node> {
        let atom = self.atom(after)?;
        self.postfix(atom, false)
    }

    /// What stands after `^`: like an operand, but names take no call and braces only group.
    pub(super) fn exponent(&mut self) -> Parsed<Node> {
        if self.peek().kind == TokenKind::Open(Bracket::Brace) {
            return self.braced("an exponent");
        }
        let atom = self.atom(self.last)?;
        self.postfix(atom, true)
    }

    fn atom(&mut self, after: Option<Token>) -> Parsed<Node> {
        let token = self.peek();
        match token.kind {
            TokenKind::Number => self.numeral(),
            _ if self.at_function() => self.anonymous_function(),
            TokenKind::Name => self.word(),
            TokenKind::Text => self.words(),
            TokenKind::Dots => {
                self.bump();
                self.node(Kind::Ellipsis, token.span(), 0)
            }
            TokenKind::Open(Bracket::Paren) => self.parentheses(),
            TokenKind::Open(Bracket::Square) => self.square(),
            TokenKind::Open(Bracket::Brace) => self.set(),
            TokenKind::Open(Bracket::Floor) => self.enclosed(Enclosure::Floor),
            TokenKind::Open(Bracket::Ceil) => self.enclosed(Enclosure::Ceil),
            TokenKind::Bar => self.bars(),
            _ => Err(self.missing_operand(after)),
        }
    }

    pub(super) fn numeral(&mut self) -> Parsed<Node> {
        let token = self.bump();
        self.is_decimal(token)?;
        let value = self.number(token)?;
        self.node(Kind::Number(value), token.span(), 0)
    }

    /// A name, or the call of a special one.
    fn word(&mut self) -> Parsed<Node> {
        let token = self.bump();
        let token = self.past_libraries(token);
        if self.at_call() && is_special(self.text_of(token)) {
            return self.special(token);
        }
        if self.text_of(token).starts_with(chars::ROOT) {
            let root = self.node(Kind::Name("sqrt".to_owned()), token.span(), 0)?;
            let body = self.atom(Some(token))?;
            let span = token.span().to(body.extent);
            let kind = Kind::Apply(Box::new(root.expr), vec![vec![body.expr]]);
            return self.node(kind, span, body.height);
        }
        // hat 1, vec d
        let accented = matches!(self.peek().kind, TokenKind::Number | TokenKind::Name) && self.peek().spaced;
        if let Some(accent) = accent_of(self.text_of(token)).filter(|_| accented) {
            let body = self.atom(Some(token))?;
            let span = token.span().to(body.extent);
            return self.node(Kind::Accent(accent, Box::new(body.expr)), span, body.height);
        }
        self.name(token)
    }

    fn words(&mut self) -> Parsed<Node> {
        let token = self.bump();
        let words = self.text_of(token).trim_matches('"').to_owned();
        self.node(Kind::Text(words), token.span(), 0)
    }

    fn enclosed(&mut self, enclosure: Enclosure) -> Parsed<Node> {
        let item = self.braced("a number")?;
        self.node(Kind::Enclosed(enclosure, Box::new(item.expr)), item.extent, item.height)
    }

    /// `|x|`, the absolute value of a number, the determinant of a matrix. Within bars and braces a bar after an
    /// operand closes or separates.
    fn bars(&mut self) -> Parsed<Node> {
        let open = self.bump();
        if self.open.len() >= MAX_DEPTH {
            return Err(self.too_deep(open.span()));
        }
        self.open.push(open);
        let item = self.expr()?;
        if self.peek().kind != TokenKind::Bar {
            return Err(self.unexpected());
        }
        let close = self.bump();
        self.open.pop();
        let span = open.span().to(close.span());
        self.node(Kind::Enclosed(Enclosure::Abs, Box::new(item.expr)), span, item.height)
    }

    /// The one item in the brackets that open here; its extent is that of the brackets.
    fn braced(&mut self, what: &str) -> Parsed<Node> {
        let inside = self.inside(false)?;
        self.single(inside, what)
    }

    /// The value of a numeral, in any kind of digits.
    fn number(&mut self, token: Token) -> Parsed<Rational> {
        let text = self.text_of(token);
        if text.len() > SHORT_NUMERAL {
            let digits = text.len();
            self.digits_left =
                self.digits_left.checked_sub(digits).ok_or_else(|| self.too_many_digits(token))?;
        }
        let value = if text.contains('E') {
            parse_scientific(text)
        } else if text.contains(chars::APOSTROPHES) {
            parse_decimal(&text.replace(chars::APOSTROPHES, ""))
        } else if text.is_ascii() {
            parse_decimal(text)
        } else if let Some([numerator, denominator]) = text.chars().last().and_then(chars::fraction) {
            let part = Rational::new(numerator.into(), denominator.into());
            let digits: String = text.chars().map(chars::ordinary).filter(char::is_ascii_digit).collect();
            let whole =
                if digits.is_empty() { Ok(Rational::from_integer(0.into())) } else { parse_decimal(&digits) };
            whole.map(|whole| whole + part)
        } else {
            parse_decimal(&text.chars().map(chars::ordinary).collect::<String>())
        };
        value.map_err(|_| self.bad_number(token))
    }

    /// The name a token stands for: Greek letters by their LaTeX name, ℝ as a blackboard R.
    pub(super) fn name(&self, token: Token) -> Parsed<Node> {
        let text = self.text_of(token);
        let mut letters = text.chars();
        let only = letters.next().filter(|c| !c.is_ascii() && letters.next().is_none());
        if let Some(letter) = only.and_then(letters::of_blackboard) {
            let letter = self.node(Kind::Name(letter.to_owned()), token.span(), 0)?;
            let kind = Kind::Accent(Accent::Blackboard, Box::new(letter.expr));
            return self.node(kind, token.span(), letter.height);
        }
        let name = if let Some(greek) = only.and_then(letters::name) {
            greek.to_owned()
        } else if only == Some('∞') {
            "infty".to_owned()
        } else {
            text.trim_start_matches('\\').chars().map(chars::ordinary).collect()
        };
        self.node(Kind::Name(name), token.span(), 0)
    }

    /// What is attached to an operand. A name in an exponent takes no call.
    pub(super) fn postfix(&mut self, mut node: Node, exponent: bool) -> Parsed<Node> {
        loop {
            let attached = match self.peek().kind {
                // B^3_1: the index belongs to B
                TokenKind::Underscore if exponent && is_number(&node.expr) => return Ok(node),
                TokenKind::Index | TokenKind::Underscore | TokenKind::Open(Bracket::Sub) => {
                    self.subscript(node)
                }
                TokenKind::Open(Bracket::Sup) => self.superscript(node),
                TokenKind::Caret if self.upper_follows() && !is_number(&node.expr) => self.upper(node),
                TokenKind::Prime => self.prime(node),
                TokenKind::Accent => self.accent(node),
                TokenKind::Bang => self.factorial(node),
                TokenKind::Open(Bracket::Square) if self.index_follows(&node.expr) => {
                    self.bracket_index(node)
                }
                _ if !exponent && self.at_call() && self.calls(&node.expr) => self.call(node),
                TokenKind::Unknown if !is_number(&node.expr) && self.at_method() => self.method(node),
                TokenKind::Unknown if !exponent && self.text_of(self.peek()) == "%" => self.percent(node),
                _ => return Ok(node),
            };
            node = attached?;
        }
    }

    fn prime(&mut self, node: Node) -> Parsed<Node> {
        let mut count = 0;
        let mut span = node.extent;
        while self.peek().kind == TokenKind::Prime {
            let prime = self.bump();
            let here = self.text_of(prime).chars().filter_map(chars::primes).sum();
            count = u32::saturating_add(count, here);
            span = span.to(prime.span());
        }
        self.node(Kind::Prime(Box::new(node.expr), count), span, node.height)
    }

    /// A combining accent.
    fn accent(&mut self, node: Node) -> Parsed<Node> {
        let token = self.bump();
        let accent = self.text_of(token).chars().next().and_then(chars::accent);
        let kind = Kind::Accent(accent.unwrap_or(Accent::Hat), Box::new(node.expr));
        self.node(kind, node.extent.to(token.span()), node.height)
    }

    fn factorial(&mut self, node: Node) -> Parsed<Node> {
        if matches!(node.expr.kind, Kind::Factorial(_)) {
            return Err(self.double_factorial(&node, self.peek()));
        }
        let span = node.extent.to(self.bump().span());
        self.node(Kind::Factorial(Box::new(node.expr)), span, node.height)
    }

    /// Whether an opening parenthesis follows without a blank.
    pub(super) fn at_call(&self) -> bool {
        let token = self.peek();
        token.kind == TokenKind::Open(Bracket::Paren) && !token.spaced
    }

    /// Whether a parenthesis directly after `callee` makes a call.
    fn calls(&self, callee: &Expr) -> bool {
        match &callee.kind {
            Kind::Accent(_, inner) => !is_number(inner),
            Kind::Group(inner) => {
                matches!(inner.kind, Kind::Compose(_) | Kind::Lambda(..)) || self.arguments_follow()
            }
            kind => {
                is_named(callee) || matches!(kind, Kind::Apply(..) | Kind::Compose(_) | Kind::Transpose(_))
            }
        }
    }

    /// Whether the parentheses that open here hold a comma or semicolon of their own.
    fn arguments_follow(&self) -> bool {
        let mut depth = 0_usize;
        for token in &self.tokens[self.at..] {
            match token.kind {
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) if depth <= 1 => return false,
                TokenKind::Close(_) => depth -= 1,
                TokenKind::Comma | TokenKind::Semicolon if depth == 1 => return true,
                _ => {}
            }
            if depth > MAX_DEPTH {
                return false;
            }
        }
        false
    }

    /// Whether `^{(…)}` follows.
    fn upper_follows(&self) -> bool {
        let mut rest = self.tokens[self.at..].iter().filter(|token| token.kind != TokenKind::Newline);
        let mut opens = |wanted| rest.next().is_some_and(|token| token.kind == wanted);
        if !(opens(TokenKind::Caret)
            && opens(TokenKind::Open(Bracket::Brace))
            && opens(TokenKind::Open(Bracket::Paren)))
        {
            return false;
        }
        let mut depth = 1_usize;
        while depth > 0 {
            match rest.next().map(|token| token.kind) {
                Some(TokenKind::Open(_)) if depth > MAX_DEPTH => return false,
                Some(TokenKind::Open(_)) => depth += 1,
                Some(TokenKind::Close(_)) => depth -= 1,
                Some(_) => {}
                None => return false,
            }
        }
        rest.next().is_some_and(|token| token.kind == TokenKind::Close(Bracket::Brace))
    }

    /// `^{(…)}`, of which [`Self::upper_follows`] holds.
    fn upper(&mut self, base: Node) -> Parsed<Node> {
        self.bump();
        let index = self.braced("an upper index")?;
        self.raised(base, index)
    }

    /// A run of Unicode superscripts.
    fn superscript(&mut self, base: Node) -> Parsed<Node> {
        let exponent = self.braced("an exponent")?;
        let power = self.raised(base, exponent)?;
        match &power.expr.kind {
            Kind::Pow(base, exponent) if self.at_call() && calls_power(base, exponent) => self.call(power),
            _ => Ok(power),
        }
    }

    /// An upper index if the exponent is in parentheses, otherwise a power.
    fn raised(&self, base: Node, exponent: Node) -> Parsed<Node> {
        let height = base.height.max(exponent.height);
        let number = is_number(&base.expr);
        let left = Box::new(base.expr);
        let kind = match exponent.expr.kind {
            Kind::Group(inner) if !number && !is_power_of_sum(&left, &inner) => {
                Kind::Upper(left, vec![*inner])
            }
            Kind::Tuple(items) if !number => Kind::Upper(left, items),
            kind => power(*left, Expr::new(kind, exponent.expr.span)),
        };
        self.node(kind, base.extent.to(exponent.extent), height)
    }

    /// Reads a pair of brackets; `conditions` allows `if` and `otherwise` after items.
    pub(super) fn inside(&mut self, conditions: bool) -> Parsed<Inside> {
        let open = self.bump();
        let TokenKind::Open(bracket) = open.kind else {
            return Err(self.unexpected());
        };
        if self.open.len() >= MAX_DEPTH {
            return Err(self.too_deep(open.span()));
        }
        self.open.push(open);
        let mut rows = vec![Vec::new()];
        let mut bar = None;
        loop {
            self.cell(&mut rows, conditions)?;
            if bracket == Bracket::Brace && self.peek().kind == TokenKind::Bar && !is_empty(&rows) {
                self.bump();
                bar = Some(self.boxed()?);
            }
            if self.peek().kind == TokenKind::For
                && rows.len() == 1
                && (bracket == Bracket::Square || bracket == Bracket::Paren && self.lists_in_call(open))
            {
                self.listed(&mut rows[0])?;
            }
            let end = self.peek();
            match end.kind {
                TokenKind::Comma | TokenKind::Semicolon if bar.is_none() => {}
                TokenKind::Dollar if bracket == Bracket::Paren && self.counts_derivatives() => {}
                TokenKind::Close(closing) if closing == bracket => {}
                _ => return Err(self.unexpected()),
            }
            self.bump();
            if let Some(cell) = rows.last_mut().and_then(|row| row.last_mut()) {
                cell.end = end;
            }
            match end.kind {
                TokenKind::Comma | TokenKind::Dollar => {}
                TokenKind::Semicolon => rows.push(Vec::new()),
                _ => {
                    self.open.pop();
                    return Ok(Inside { rows, bar, open, close: end });
                }
            }
        }
    }

    /// `[i^2 for i = 0..3]` is map(i -> i^2, 0..3), joined with nothing else.
    fn listed(&mut self, row: &mut [Cell]) -> Parsed<()> {
        let [Cell { item: Some(item), .. }] = row else { return Err(self.unexpected()) };
        self.bump();
        let bound = self.expr()?;
        let extent = item.extent.to(bound.extent);
        let height = item.height.max(bound.height) + 2;
        let Kind::Chain(name, mut links) = bound.expr.kind else { return Err(self.unexpected()) };
        if links.len() != 1 || !super::is_parameter(&name.kind) {
            return Err(self.unexpected());
        }
        let values = self.range_by_colon(links.remove(0).expr)?;
        let extent = extent.to(values.span);
        let body = Box::new(std::mem::replace(&mut item.expr, Expr::new(Kind::Ellipsis, extent)));
        let each = Expr::new(Kind::Lambda(vec![*name], body), extent);
        let map = Box::new(Expr::new(Kind::Name("map".to_owned()), extent));
        item.expr = Expr::new(Kind::Apply(map, vec![vec![each, values]]), extent);
        item.extent = extent;
        item.height = height;
        Ok(())
    }

    /// Adds what stands before the next separator to the last row.
    fn cell(&mut self, rows: &mut [Vec<Cell>], conditions: bool) -> Parsed<()> {
        use TokenKind::{Bar, Close, Comma, Semicolon};
        let end = self.peek();
        let item = match end.kind {
            Comma | Semicolon | Close(_) | Bar => None,
            _ => Some(self.expr()?),
        };
        let condition = if conditions { self.condition()? } else { None };
        if let Some(row) = rows.last_mut() {
            row.push(Cell { item, end, condition });
        }
        Ok(())
    }

    fn boxed(&mut self) -> Parsed<Box<Node>> {
        self.expr().map(Box::new)
    }

    /// What follows the value of a case.
    fn condition(&mut self) -> Parsed<Option<Option<Box<Node>>>> {
        match self.peek().kind {
            TokenKind::If => {
                self.bump();
                self.boxed().map(|condition| Some(Some(condition)))
            }
            TokenKind::Otherwise => {
                self.bump();
                Ok(Some(None))
            }
            _ => Ok(None),
        }
    }

    /// The items of a bracket without semicolons, at least one.
    pub(super) fn items(&self, inside: Inside, what: &str) -> Parsed<Items> {
        if inside.is_empty() {
            return Err(self.empty_brackets(&inside, what));
        }
        let mut items = Items::default();
        for row in inside.rows {
            for cell in row {
                if cell.end.kind == TokenKind::Semicolon {
                    return Err(self.stray_semicolon(cell.end));
                }
                items.push(cell.item.ok_or_else(|| self.missing_item(cell.end))?);
            }
        }
        Ok(items)
    }

    /// The only item of a bracket.
    fn single(&self, inside: Inside, what: &str) -> Parsed<Node> {
        let extent = inside.span();
        let comma = inside.rows.iter().flatten().map(|cell| cell.end).next();
        let items = self.items(inside, what)?;
        match <[Expr; 1]>::try_from(items.list) {
            Ok([expr]) => Ok(Node { expr, extent, height: items.height }),
            Err(_) => Err(self.only_one(comma.map_or(extent, Token::span), what)),
        }
    }

    fn parentheses(&mut self) -> Parsed<Node> {
        let inside = self.inside(false)?;
        self.group_or_tuple(inside)
    }

    fn group_or_tuple(&self, inside: Inside) -> Parsed<Node> {
        let span = inside.span();
        let Items { mut list, height } = self.items(in_one_row(inside), "a formula")?;
        let kind = match list.pop() {
            Some(only) if list.is_empty() => Kind::Group(Box::new(only)),
            last => {
                list.extend(last);
                Kind::Tuple(list)
            }
        };
        self.node(kind, span, height)
    }

    fn square(&mut self) -> Parsed<Node> {
        let inside = match self.spaced_numbers()? {
            Some(numbers) => numbers,
            None => self.inside(false)?,
        };
        self.list_or_matrix(inside)
    }

    /// A list, or a matrix if there are semicolons.
    fn list_or_matrix(&self, inside: Inside) -> Parsed<Node> {
        let span = inside.span();
        if inside.is_empty() {
            return self.node(Kind::List(Vec::new()), span, 0);
        }
        if inside.rows.len() == 1 {
            let Items { mut list, height } = self.items(inside, "an item")?;
            if let [Expr { kind: Kind::Apply(callee, groups), .. }] = list.as_slice()
                && matches!(&callee.kind, Kind::Name(name) if name == "map")
                && callee.span == groups[0][0].span
            {
                return Ok(Node { expr: list.remove(0), extent: span, height });
            }
            return self.node(Kind::List(list), span, height);
        }
        let mut height = 0;
        let mut rows: Vec<Vec<Option<Expr>>> = Vec::with_capacity(inside.rows.len());
        for row in inside.rows {
            let mut cells = Vec::with_capacity(row.len());
            for cell in row {
                height = height.max(cell.item.as_ref().map_or(0, |item| item.height));
                cells.push(cell.item.map(|item| item.expr));
            }
            rows.push(cells);
        }
        // `[1, 2;]` is a matrix of one row.
        rows.pop_if(|row| matches!(row.as_slice(), [None]));
        self.node(Kind::Matrix(rows, Delimiter::Paren), span, height)
    }

    fn set(&mut self) -> Parsed<Node> {
        let inside = self.inside(false)?;
        self.members(inside)
    }

    fn members(&self, mut inside: Inside) -> Parsed<Node> {
        let span = inside.span();
        let bar = inside.bar.take();
        let items = if inside.is_empty() { Items::default() } else { self.items(inside, "a member")? };
        let height = items.height.max(bar.as_ref().map_or(0, |bar| bar.height));
        self.node(Kind::Set(items.list, bar.map(|bar| Box::new(bar.expr))), span, height)
    }
}

/// A power, or the binomial coefficient `C_n^k`.
pub(super) fn power(base: Expr, exponent: Expr) -> Kind {
    match base.kind {
        Kind::Subscript(letter, mut indices) if is_binomial_coefficient(&letter, &indices, &exponent) => {
            let below = Box::new(indices.remove(0));
            Kind::Binomial(below, Box::new(exponent), BinomialStyle::Subscripted)
        }
        kind => Kind::Pow(Box::new(Expr::new(kind, base.span)), Box::new(exponent)),
    }
}

/// Whether a parenthesis directly after `base^exponent` makes a call of the power.
pub(super) fn calls_power(base: &Expr, exponent: &Expr) -> bool {
    let bare = match &exponent.kind {
        Kind::Name(_) => true,
        Kind::Subscript(name, _) => matches!(name.kind, Kind::Name(_)),
        _ => false,
    };
    is_named(base) && (bare || has_index(base))
}

pub(super) fn is_named(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        Kind::Name(_) | Kind::Subscript(..) | Kind::Prime(..) | Kind::Accent(..) | Kind::Upper(..)
    )
}

fn has_index(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Subscript(..) => true,
        Kind::Prime(base, _) | Kind::Accent(_, base) | Kind::Upper(base, _) => has_index(base),
        _ => false,
    }
}

pub(super) fn is_number(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::Number(_))
}
