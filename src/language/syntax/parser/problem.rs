//! What the parser says when it cannot go on: the place, the reason, and a hint that works.

use super::super::token::{Bracket, Token, TokenKind};
use super::operand::Inside;
use super::{MAX_DEPTH, MAX_DIGITS, Node, Parser};
use crate::formula::source::{Pieces, Span};
use crate::formula::{BigOp, Kind};
use crate::language::diagnostic::{Code, Diagnostic};

/// Quoted texts are cut to this many characters.
const QUOTE: usize = 24;

type Problem = Box<Diagnostic>;

fn error(code: Code, message: impl Into<String>, span: Span) -> Diagnostic {
    Diagnostic::error(code, message).at(span)
}

impl Parser<'_> {
    /// The error for `7 % 3`.
    pub(super) fn percent_or_remainder(&self, sign: Token) -> Problem {
        let problem = error(Code::AmbiguousProduct, "a percentage, or a remainder?", sign.span());
        Box::new(problem.hint("write 7 mod 3 for the remainder, 7/100 for the percentage"))
    }

    /// The error for `x <- 3`.
    pub(super) fn assignment(&self, sign: Token) -> Problem {
        let problem =
            error(Code::UnexpectedToken, "'<-': a value, or less than a negative number?", sign.span());
        Box::new(problem.hint("write x := 3 to give x a value").hint("write x < -3 for the inequality"))
    }
}

/// The error for `1 + 7 mod 3` and `7 mod 3 * 2`.
pub(crate) fn reach_of_mod(span: Span) -> Diagnostic {
    error(Code::AmbiguousProduct, "how far does mod reach?", span)
        .reason("it stands beside other operators")
        .hint("write parentheses: (1 + 7) mod 3, or 1 + (7 mod 3)")
}

/// The error for `7 ≡ 1 mod 3`.
pub(crate) fn congruence(span: Span) -> Diagnostic {
    error(Code::AmbiguousProduct, "a congruence, or equal to the remainder?", span)
        .reason("congruences are not computed")
        .hint("write (7 - 1) mod 3 = 0 for the congruence, 7 = (1 mod 3) for the remainder")
}

impl Parser<'_> {
    fn quote(&self, span: Span) -> String {
        let text = self.text.piece(span.range());
        let mut short: String = text.chars().take(QUOTE).collect();
        if short.len() < text.len() {
            short.push('…');
        }
        let shown: String =
            short.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect();
        if shown.contains('\'') { format!("\"{shown}\"") } else { format!("'{shown}'") }
    }

    fn text_at(&self, span: Span) -> &str {
        self.text.piece(span.range())
    }

    fn innermost(&self) -> Option<(Token, Bracket)> {
        self.open.last().and_then(|&token| match token.kind {
            TokenKind::Open(bracket) => Some((token, bracket)),
            _ => None,
        })
    }

    /// A token that neither continues nor ends the formula.
    pub(super) fn unexpected(&self) -> Problem {
        let token = self.peek();
        let span = token.span();
        let text = self.quote(span);
        let unexpected = |message: String| error(Code::UnexpectedToken, message, span);
        Box::new(match token.kind {
            TokenKind::Unknown => return self.unknown_character(token),
            TokenKind::Command => return self.unknown_command(token),
            TokenKind::BadNumber => return self.bad_number(token),
            TokenKind::Close(closing) if self.innermost().is_some_and(|(_, open)| open == closing) => {
                return self.missing_operand(self.last);
            }
            TokenKind::End | TokenKind::Close(_) => return self.unbalanced(token),
            TokenKind::OpenText => unexpected("a quotation mark has no partner".into())
                .reason("the quoted words do not end on this line")
                .hint("add the second \", or write '' for a second derivative"),
            TokenKind::Text => {
                unexpected(format!("the words {text} cannot stand here")).hint("remove the quoted words")
            }
            TokenKind::Bar => unexpected("'|' has no meaning here".into())
                .reason("a bar may open or close")
                .hint("write abs(x) for |x| within bars or braces, and {x | x > 0} for a set"),
            TokenKind::Colon => unexpected("':' has no meaning here".into())
                .hint("write := to define a name, / to divide, 0..3 for a range, [0..3] for its numbers"),
            TokenKind::For => unexpected(format!("{text} stands outside a list"))
                .reason("only a list is made for several values")
                .hint("write [i^2 for i = 0..3]")
                .hint("a function by cases is cases(t^2 if t < 1, 2t - 1 otherwise)"),
            TokenKind::If | TokenKind::Otherwise => unexpected(format!("{text} stands outside cases(…)"))
                .hint("write cases(t^2 if t < 1, 2t - 1 otherwise)"),
            TokenKind::Open(Bracket::Brace) => unexpected("'{' cannot follow here".into())
                .reason("braces make a set, or hold an index after '_' or an exponent after '^'")
                .hint("write ( ) to group, or put an operator before the set"),
            TokenKind::Dollar => unexpected("'$' stands inside a formula".into())
                .hint("put the whole formula between two $, or remove the sign"),
            TokenKind::And => unexpected(format!("{text} stands between two statements only"))
                .hint("write a comma between items, and ';' between statements"),
            TokenKind::Semicolon => return self.stray_semicolon(token),
            TokenKind::Comma => return self.missing_item(token),
            _ => unexpected(format!("{text} cannot stand here"))
                .hint(format!("remove {text}, or write an operator before it")),
        })
    }

    fn unknown_character(&self, token: Token) -> Problem {
        let text = self.text_of(token);
        let hint = match text {
            "∑" | "∏" => "write sum(i=0..n, t^i) or prod(i=0..n, t_i)",
            "∫" => "write integral(t^2, t=0..1)",
            "√" => "roots are not exact numbers; write a name for the root",
            "‖" => "write norm(x)",
            "½" | "¼" | "¾" | "⅓" | "⅔" | "⅙" | "⅛" => "write the fraction as 1/2",
            "%" => "write p/100 for a percentage, # to begin a comment",
            "&" => "write rows of a matrix as [1, 2; 3, 4]",
            "~" => "write ≈ or = for a relation",
            "@" => "write F∘G or compose(F, G) for a composition",
            "'" | "`" => "write F' for a derivative",
            "?" => "remove it; a formula with = is a claim and gets an answer anyway",
            "." if self.tokens.get(self.at + 1).is_some_and(|next| self.text_of(*next) == "(") => {
                "write [f(t) for t = 0..2] for the values of a function"
            }
            "." => "write 0.5 for a decimal, 0..3 for a range, * for a product",
            _ => "remove it, or write the operation you mean, for example t^2",
        };
        Box::new(
            error(
                Code::UnexpectedCharacter,
                format!("unexpected character {}", self.shown(token)),
                token.span(),
            )
            .reason("not part of the notation")
            .hint(hint),
        )
    }

    /// The character, or its code if it cannot be seen.
    fn shown(&self, token: Token) -> String {
        match self.text_of(token).chars().next() {
            Some(c) if c.is_control() || c == '\u{fffd}' || u32::from(c) > 0x2_ffff => {
                format!("U+{:04X}", u32::from(c))
            }
            _ => self.quote(token.span()),
        }
    }

    fn unknown_command(&self, token: Token) -> Problem {
        let command = self.text_of(token);
        let hint = match command {
            "\\frac" | "\\dfrac" | "\\tfrac" => "write (a)/(b)",
            "\\binom" | "\\dbinom" | "\\tbinom" => "write binomial(n, k)",
            "\\sum" => "write sum(i=0..n, t^i)",
            "\\prod" => "write prod(i=0..n, t_i)",
            "\\int" => "write integral(t^2, t=0..1)",
            "\\hat" | "\\widehat" => "write hat(v)",
            "\\bar" | "\\overline" => "write bar(v)",
            "\\vec" | "\\overrightarrow" => "write vec(v)",
            "\\left" | "\\right" | "\\big" | "\\Big" => "leave it out",
            "\\begin" => "write a matrix as [1, 2; 3, 4]",
            "\\ " => "write solve(A, b) for the x with A x = b",
            _ => "write the formula wholly in LaTeX, between $ and $, or without LaTeX commands",
        };
        Box::new(
            error(Code::UnknownCommand, format!("LaTeX command {}", self.quote(token.span())), token.span())
                .reason("not part of the plain notation")
                .hint(hint),
        )
    }

    /// A closing bracket without partner, or the end while a bracket is open.
    fn unbalanced(&self, token: Token) -> Problem {
        if let Some(bar) = self.open.last().filter(|open| open.kind == TokenKind::Bar) {
            let problem = error(Code::Unbalanced, "'|' is never closed".to_owned(), bar.span())
                .reason("opened here")
                .hint("add the closing '|', or write abs(x)");
            let around = self.open.iter().rev().nth(1).map(|open| open.kind);
            return Box::new(match around {
                Some(TokenKind::Open(Bracket::Paren)) => {
                    problem.hint("the coordinates of a point stand between commas: (1, 2)")
                }
                _ => problem,
            });
        }
        let Some((open, bracket)) = self.innermost() else {
            let text = self.quote(token.span());
            return Box::new(
                error(Code::Unbalanced, format!("{text} closes nothing"), token.span())
                    .reason("no bracket is open here")
                    .hint(format!("remove {text}, or add the opening bracket before")),
            );
        };
        let opening = self.quote(open.span());
        let problem = error(Code::Unbalanced, format!("{opening} is never closed"), open.span());
        let closing = bracket.closing();
        Box::new(match token.kind {
            TokenKind::Close(other) => {
                let found = other.closing();
                error(
                    Code::Unbalanced,
                    format!("'{}' is closed by '{found}'", bracket.opening()),
                    open.span(),
                )
                .reason("opened here")
                .label(token.span(), format!("'{closing}' expected here"))
                .hint(format!("write '{closing}' in place of '{found}', or add it before '{found}'"))
            }
            _ => problem.reason("opened here").hint(format!("add the missing '{closing}'")),
        })
    }

    /// Something else stands where an operand is needed; `after` is the operator before.
    pub(super) fn missing_operand(&self, after: Option<Token>) -> Problem {
        let token = self.peek();
        let Some(after) = after else { return self.missing_first(token) };
        let operator = self.quote(after.span());
        let found = self.quote(token.span());
        Box::new(match token.kind {
            TokenKind::End => {
                let message = format!("the formula ends after {operator}");
                let problem = error(Code::UnexpectedEnd, message, after.span())
                    .reason("nothing follows")
                    .hint(format!("write what comes after {operator}, or remove {operator}"));
                match self.innermost() {
                    Some((open, _)) => problem.label(open.span(), "this bracket is still open"),
                    None => problem,
                }
            }
            TokenKind::Close(_) | TokenKind::Comma | TokenKind::Semicolon => {
                let found = if token.span().is_empty() { "the end of the run".to_owned() } else { found };
                error(
                    Code::UnexpectedToken,
                    format!("nothing stands between {operator} and {found}"),
                    after.span(),
                )
                .reason("an operand is missing after this")
                .hint(format!("write what comes after {operator}, or remove {operator}"))
            }
            kind if is_operator(kind) => {
                let message = format!("two operators in a row: {operator} and {found}");
                let hint = match kind {
                    TokenKind::Slash if self.text_of(after) == "/" => {
                        "a // b is a fraction in some languages, here a/b, and its whole part in others, here floor(a/b)".to_owned()
                    }
                    TokenKind::Plus => format!("remove the {found} here: it changes nothing"),
                    _ => format!("remove {operator} or {found}, or write an operand between them"),
                };
                error(Code::UnexpectedToken, message, token.span())
                    .reason("an operand is missing before this")
                    .hint(hint)
            }
            _ => return self.unexpected(),
        })
    }

    /// The same at the beginning of a formula or bracket.
    fn missing_first(&self, token: Token) -> Problem {
        if !is_operator(token.kind) {
            return self.unexpected();
        }
        let found = self.quote(token.span());
        let hint = match token.kind {
            TokenKind::Open(Bracket::Sup | Bracket::Sub) | TokenKind::Underscore | TokenKind::Prime => {
                "write a name before it"
            }
            TokenKind::Accent => "write the letter before the accent, or use hat(v)",
            TokenKind::Arrow => "write the parameters before it, as in t -> t^2",
            _ => "write what comes before it, or remove it",
        };
        Box::new(
            error(Code::UnexpectedToken, format!("nothing stands before {found}"), token.span())
                .reason("an operand is missing before this")
                .hint(hint),
        )
    }

    /// `t^2 /. 3`
    pub(super) fn no_rule(&self, span: Span) -> Problem {
        let problem = error(Code::UnexpectedToken, "after '/.' values of names stand", span);
        Box::new(problem.reason("no value of a name").hint("write /. t -> 2, or /. {a -> 1, t -> 2}"))
    }

    /// `[1 -1]`
    pub(super) fn signed_item(&self, sign: Token) -> Problem {
        let problem = error(Code::UnexpectedToken, "a list without commas, or a difference?", sign.span());
        Box::new(
            problem.reason("the sign of an item, or an operator?").hint(
                "write commas between the items, or blanks on both sides of an operator: 1, -1 or 1 - 1",
            ),
        )
    }

    pub(super) fn two_numbers(&self) -> Problem {
        let token = self.peek();
        let span = self.last.map_or(token.span(), |last| last.span().to(token.span()));
        let problem = error(Code::UnexpectedToken, "two numbers side by side", span);
        let Some(last) = self.last.filter(|_| span.len() <= QUOTE) else {
            return Box::new(problem.reason("a product, or one number?").hint("write * for the product"));
        };
        let (a, b) = (self.text_of(last), self.text_of(token));
        // 0 0 0 1 3 3 3
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let more = rest.iter().take_while(|token| token.kind == TokenKind::Number && token.spaced);
        let numbers: Vec<&str> = more.map(|token| self.text_of(*token)).collect();
        if numbers.len() > 1 {
            let list = format!("write [{a}, {}] for a list", numbers.join(", "));
            return Box::new(problem.reason("a list has brackets, and commas").hint(list));
        }
        let after = |at: usize| self.tokens.get(self.at + at).filter(|token| !token.spaced);
        if let (Some(slash), Some(below)) = (after(1), after(2))
            && slash.kind == TokenKind::Slash
            && below.kind == TokenKind::Number
        {
            let fraction = format!("{b}/{}", self.text_of(*below));
            return Box::new(problem.reason("a mixed number, or a product?").hint(format!(
                "write {a} + {fraction} for the mixed number, {a}*{fraction} for the product"
            )));
        }
        let problem = problem
            .reason("a product, or one number?")
            .hint(format!("write {a}*{b} for the product, {a}{b} for one number"));
        Box::new(match self.enclosing() {
            Some(_) => problem.hint(format!("write a comma between two items: {a}, {b}")),
            None => problem,
        })
    }

    /// The bracket that is open here, looked for among the last tokens.
    pub(super) fn enclosing(&self) -> Option<usize> {
        const FAR: usize = 100;
        let mut closed = 0_usize;
        for at in (self.at.saturating_sub(FAR)..self.at).rev() {
            match self.tokens[at].kind {
                TokenKind::Close(_) => closed += 1,
                TokenKind::Open(_) if closed == 0 => return Some(at),
                TokenKind::Open(_) => closed -= 1,
                _ => {}
            }
        }
        None
    }

    /// Whether a letter x between numbers may be meant as a sign: `2 x 3`.
    pub(super) fn x_for_times(&self) -> Option<Problem> {
        let [number, x] = [2, 1].map(|back| self.at.checked_sub(back).and_then(|at| self.tokens.get(at)));
        let (number, x, next) = (*number?, *x?, self.peek());
        let sign =
            x.kind == TokenKind::Name && x.spaced && next.spaced && matches!(self.text_of(x), "x" | "X");
        if !sign || number.kind != TokenKind::Number || next.kind != TokenKind::Number {
            return None;
        }
        let (a, x, b) = (self.text_of(number), self.text_of(x), self.text_of(next));
        Some(Box::new(
            error(
                Code::AmbiguousProduct,
                "a sign of multiplication or the letter x?",
                number.span().to(next.span()),
            )
            .hint(format!("write {a}*{b} for the product, {a}*{x}*{b} for one with the letter")),
        ))
    }

    pub(super) fn bad_definition(&self, left: &Node, token: Token) -> Problem {
        Box::new(
            error(Code::BadDefinition, "the left side of ':=' is a relation", left.extent)
                .reason("a name, or a name with arguments, is needed here")
                .label(token.span(), "the definition")
                .hint("define one name at a time, as in F(t) := t^2; put claims in a statement of their own"),
        )
    }

    pub(super) fn double_range(&self, left: &Node, token: Token) -> Problem {
        Box::new(
            error(Code::UnexpectedToken, "a range has only two ends", token.span())
                .label(left.extent, "this is a range already")
                .hint("write 0..n"),
        )
    }

    pub(super) fn bad_parameters(&self, left: &Node) -> Problem {
        Box::new(
            error(Code::UnexpectedToken, "the left side of '->' is no list of parameters", left.extent)
                .reason("names are needed here")
                .hint("write t -> t^2 or (i, n) -> i/n"),
        )
    }

    pub(super) fn too_deep(&self, span: Span) -> Problem {
        Box::new(
            error(Code::TooDeep, "the formula is nested too deeply", span)
                .reason(format!("the limit of {MAX_DEPTH} open brackets, or of operations inside each other, is passed here"))
                .hint("define parts of it under names of their own, as in a := …"),
        )
    }

    pub(super) fn too_many_digits(&self, token: Token) -> Problem {
        let message = format!("the long numbers of this text have more than {MAX_DIGITS} digits");
        Box::new(
            error(Code::TooLong, message, token.span())
                .reason(format!("{} digits", token.span().len()))
                .hint("write large numbers as powers or products, or use several inputs"),
        )
    }

    /// Refuses 0x10, which would be 0 times x10.
    pub(super) fn is_decimal(&self, token: Token) -> Result<(), Problem> {
        let rest = self.text.piece(token.span().end..);
        let digits = rest.strip_prefix(['x', 'X', 'b', 'B', 'o', 'O']).filter(|_| self.text_of(token) == "0");
        match digits.filter(|digits| digits.starts_with(|c: char| c.is_ascii_digit())) {
            None => Ok(()),
            Some(_) => Err(Box::new(
                error(Code::BadNumber, "numbers are decimal here".to_owned(), token.span())
                    .reason("another base, or a product with 0?")
                    .hint("write 16 for the number 0x10")
                    .hint("write 0*x10 for the product"),
            )),
        }
    }

    pub(super) fn bad_number(&self, token: Token) -> Problem {
        let text = self.text_of(token);
        let quoted = self.quote(token.span());
        let problem = error(Code::BadNumber, format!("malformed number {quoted}"), token.span());
        let Some(at) = text.find(['e', 'E']) else {
            let index = !text.starts_with(|c: char| c.is_ascii_digit() || c == '.')
                || self
                    .last
                    .is_some_and(|last| last.span().end == token.span().start && takes_index(last.kind));
            if text.ends_with('.') {
                return Box::new(problem.reason("repeating decimals are not read").hint(
                    "write a fraction: 1/3 for 0.333..., or a blank before the parenthesis of a product",
                ));
            }
            return Box::new(if index {
                problem
                    .reason("an index has no decimal point")
                    .hint("write a blank or * before a decimal number")
            } else {
                problem
                    .reason("a number has one decimal point at most")
                    .hint("remove a point, or write a comma or .. between numbers")
            });
        };
        let (number, power) = (text.piece(..at), text.piece(at + 1..));
        let problem = problem.reason("a power of ten, or the name e?");
        Box::new(if text.len() > QUOTE {
            problem.hint("write * 10^ for the power of ten")
        } else {
            let product = if power.starts_with(['+', '-']) {
                format!("{number} e {} {}", power.piece(..1), power.piece(1..))
            } else {
                format!("{number} e_{power}")
            };
            problem.hint(format!("write {number} * 10^{} or {product}", power.trim_start_matches('+')))
        })
    }

    pub(super) fn double_factorial(&self, node: &Node, token: Token) -> Problem {
        let base = match &node.expr.kind {
            Kind::Factorial(base) => self.quote(base.span),
            _ => self.quote(node.extent),
        };
        let base = base.trim_matches('\'');
        Box::new(
            error(Code::UnexpectedToken, "'!!' has no meaning here", node.extent.to(token.span()))
                .reason("the double factorial is not known")
                .hint(format!("write ({base}!)! for the factorial of the factorial")),
        )
    }

    pub(super) fn double_index(&self, base: &Node, token: Token) -> Problem {
        let problem = error(Code::UnexpectedToken, "a second index", token.span())
            .reason("this index follows another")
            .label(base.extent, "has an index already");
        let second = match self.tokens.get(self.at + 1) {
            Some(next) if matches!(next.kind, TokenKind::Index | TokenKind::Number | TokenKind::Name) => {
                *next
            }
            _ => return Box::new(problem.hint("write p_{i,j} for two indices")),
        };
        let second = self.text_of(second);
        Box::new(match &base.expr.kind {
            Kind::Subscript(name, indices) if second.len() + base.extent.len() <= QUOTE => {
                let name = self.text_at(name.span);
                let first =
                    indices.iter().map(|index| self.text_at(index.span)).collect::<Vec<_>>().join(",");
                problem.hint(format!(
                    "write {name}_{{{first},{second}}} for two indices, or a blank between two factors"
                ))
            }
            _ => problem.hint("write p_{i,j} for two indices, or a blank between two factors"),
        })
    }

    pub(super) fn no_index(&self, base: &Node) -> Problem {
        let text = self.quote(base.extent);
        Box::new(
            error(Code::UnexpectedToken, format!("{text} cannot have an index"), base.extent)
                .reason("not a name")
                .hint(match self.text_at(base.extent).bytes().all(|byte| byte.is_ascii_digit()) {
                    true => "put the index on a name, as in c_0; digits are written without signs between"
                        .to_owned(),
                    false => "put the index on a name, as in c_0".to_owned(),
                }),
        )
    }

    pub(super) fn missing_index(&self) -> Problem {
        let token = self.peek();
        let code = if token.kind == TokenKind::End { Code::UnexpectedEnd } else { Code::UnexpectedToken };
        let span = self.last.map_or(token.span(), Token::span);
        Box::new(
            error(code, "no index follows '_'", span).reason("a number, a word or braces must follow").hint(
                match token.kind {
                    TokenKind::Plus => "a truncated power is written cases((t - 1)^2 if t > 1, 0 otherwise)",
                    _ => "write t_1, p_{i,j} or t_{-1}",
                },
            ),
        )
    }

    pub(super) fn empty_brackets(&self, inside: &Inside, what: &str) -> Problem {
        let (open, close) = (inside.open.span(), inside.close.span());
        let (open, close) = (self.text_at(open), self.text_at(close));
        Box::new(
            error(Code::UnexpectedToken, "nothing stands between the brackets", inside.span())
                .reason(format!("{what} is missing"))
                .hint(format!("write {what} between '{open}' and '{close}'")),
        )
    }

    pub(super) fn stray_semicolon(&self, token: Token) -> Problem {
        Box::new(
            error(Code::UnexpectedToken, "';' has no meaning inside these brackets", token.span())
                .reason("it separates statements, rows of [1, 2; 3, 4], and arguments of f(u; v)")
                .hint("write ',' here, or close the bracket before ';'"),
        )
    }

    /// A separator or closing bracket with nothing before it.
    pub(super) fn missing_item(&self, token: Token) -> Problem {
        let text = self.quote(token.span());
        let hint = match token.kind {
            TokenKind::Close(_) => "remove the comma before it, or write another item",
            _ => "remove it, or write an item before it",
        };
        Box::new(
            error(Code::UnexpectedToken, format!("nothing stands before {text}"), token.span())
                .reason("an item is missing")
                .hint(hint),
        )
    }

    pub(super) fn only_one(&self, span: Span, what: &str) -> Problem {
        Box::new(
            error(Code::UnexpectedToken, "only one item can stand here", span)
                .reason(format!("{what} is one item"))
                .hint("keep one of the items, or put them in parentheses as (a, b)"),
        )
    }

    pub(super) fn missing_body(&self, op: BigOp, span: Span) -> Problem {
        let name = big_name(op);
        Box::new(
            error(Code::UnexpectedToken, format!("{name} has bounds but nothing to apply to"), span)
                .reason("the last argument must be a formula")
                .hint(format!("write {name}(i=0..n, t^i)")),
        )
    }

    pub(super) fn not_a_bound(&self, op: BigOp, span: Span) -> Problem {
        let name = big_name(op);
        Box::new(
            error(Code::UnexpectedToken, format!("an argument of {name} that is no bound"), span)
                .reason("before the last argument only bounds and conditions stand")
                .hint(format!("write {name}(i=0..n, j=0..i, j != 1, t^i)")),
        )
    }

    pub(super) fn missing_condition(&self, value: &Node) -> Problem {
        let text = self.quote(value.extent);
        let text = text.trim_matches('\'');
        Box::new(
            error(Code::UnexpectedToken, "a case without condition", value.extent)
                .reason("'if' or 'otherwise' must follow")
                .hint(format!("write {text} if i = 0, or {text} otherwise")),
        )
    }
}

fn is_operator(kind: TokenKind) -> bool {
    use TokenKind::*;
    matches!(
        kind,
        Plus | Minus
            | Star
            | Slash
            | Caret
            | Bang
            | Underscore
            | Prime
            | Accent
            | DotDot
            | Arrow
            | Compose
            | Relation(_)
            | Open(Bracket::Sup | Bracket::Sub)
    )
}

fn takes_index(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Name | TokenKind::Underscore | TokenKind::Accent)
}

fn big_name(op: BigOp) -> &'static str {
    match op {
        BigOp::Sum => "sum",
        BigOp::Product => "prod",
        BigOp::Max => "max",
        BigOp::Min => "min",
        BigOp::Union => "union",
        BigOp::Intersection => "intersection",
        BigOp::Limit => "lim",
    }
}
