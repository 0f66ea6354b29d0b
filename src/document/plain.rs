//! Formulas in plain notation among words: `F(u) = f(u, u, u)`, `F(t) = t³ + 3t² + 5t + 1`.
//!
//! **Definition.** A formula in a line of prose is a longest run of names (one letter, perhaps with
//! indices, exponents, primes), numbers, operators and brackets that holds a relation sign at its
//! top level with mathematics on both sides, and that one of the two readers can read. Words of two
//! letters and more end a run, as do full stops, and commas outside of brackets.
//!
//! When in doubt it is prose: a formula that is missed says nothing, one that is made up is judged.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::document::Style;
use crate::formula::source::Pieces;
use crate::language::lexicon::letters::{self, is_ideograph};
use crate::language::lexicon::words::is_function_word;
use crate::language::{latex, syntax};

/// A formula of a line: its bytes, and its text, in which marks of emphasis are blanked.
pub(super) struct Found {
    pub(super) range: Range<usize>,
    pub(super) text: String,
    /// `Inline` if it reads as LaTeX only: letters stand side by side for their product, ∑ has bounds.
    pub(super) style: Style,
}

/// A longer run of tokens is not read: it is data, not prose.
const MAX_TOKENS: usize = 400;

/// A longer word is none of a product.
const MAX_PRODUCT: usize = 5;

/// How many tokens may be left out at the ends of a run to make it readable.
const MAX_CUT: usize = 3;

/// The formulas of a line, in order. After a formula (`continues`) one may begin with a relation
/// sign: what stands on its left is the formula before.
pub(super) fn find(line: &str, continues: bool) -> Vec<Found> {
    if !line.contains(['=', '≤', '≥', '≠', '≔', '≜', '⩽', '⩾']) {
        return Vec::new();
    }
    let mut tokens = tokens(line);
    read_words(line, &mut tokens);
    let mut found = Vec::new();
    for (at, segment) in segments(&tokens) {
        if is_half(&tokens, at, segment.len()) {
            continue;
        }
        for run in balanced(whole_parts(&tokens, at, segment)) {
            let first = continues
                && run.first().is_some_and(|token| line.piece(..token.range.start).trim().is_empty());
            found.extend(formulas(line, run, first));
        }
    }
    found
}

/// The runs between the tokens that belong to no formula, with the numbers of their first tokens.
fn segments(tokens: &[Token]) -> Vec<(usize, &[Token])> {
    let mut found = Vec::new();
    let mut from = 0;
    for at in 0..=tokens.len() {
        if tokens.get(at).is_none_or(|token| matches!(token.kind, Kind::Cut | Kind::Strange)) {
            if from < at {
                found.push((from, &tokens[from..at]));
            }
            from = at + 1;
        }
    }
    found
}

/// Whether a run is a part of something larger that is not read: beside an unknown sign, or glued to a word
/// whose argument or index it is.
fn is_half(tokens: &[Token], at: usize, len: usize) -> bool {
    let before = at.checked_sub(1).map(|at| &tokens[at]);
    let after = tokens.get(at + len);
    let strange = |token: Option<&Token>| token.is_some_and(|token| token.kind == Kind::Strange);
    let call = before.is_some_and(|token| token.word)
        && !tokens[at].spaced
        && matches!(tokens[at].kind, Kind::Open(_) | Kind::Operator | Kind::Number);
    strange(before) || strange(after) || call
}

/// The parts of a run that no sign joins to a word beside it: of `x = 1, y = a - what` the first one.
fn whole_parts<'a>(tokens: &[Token], at: usize, segment: &'a [Token]) -> &'a [Token] {
    let word = |token: Option<&Token>| token.is_some_and(|token| token.word);
    let joins = |token: Option<&Token>| token.is_some_and(|token| token.kind == Kind::Operator);
    let comma = |token: &Token| token.kind == Kind::Comma;
    let mut whole = segment;
    if word(tokens.get(at + segment.len())) && joins(whole.last()) {
        whole = &whole[..whole.iter().rposition(comma).unwrap_or(0)];
    }
    if word(at.checked_sub(1).map(|before| &tokens[before])) && joins(whole.first()) {
        whole = &whole[whole.iter().position(comma).unwrap_or(whole.len())..];
    }
    whole
}

/// A function everybody knows before its argument is a name. A short word between signs is a product if each of its
/// letters is a name of the line: `2ab`, `rs + st`.
fn read_words(line: &str, tokens: &mut [Token]) {
    let text = |token: &Token| line.piece(token.range.clone()).to_owned();
    let names: BTreeSet<char> = tokens
        .iter()
        .filter(|token| matches!(token.kind, Kind::Name | Kind::Article))
        .filter_map(|token| line.piece(token.range.clone()).chars().find(|c| c.is_alphabetic()))
        .collect();
    for at in 0..tokens.len() {
        let token = &tokens[at];
        let written = text(token);
        let letters = written.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        let counted = letters.len() < written.len();
        let called = tokens.get(at + 1).is_some_and(|next| next.kind == Kind::Open('(') && !next.spaced);
        if called && (is_function_word(&written) || written == "binom") {
            (tokens[at].kind, tokens[at].word) = (Kind::Name, false);
            continue;
        }
        let few = matches!(letters.len(), 2..=MAX_PRODUCT);
        if token.kind != Kind::Cut || !few || !letters.chars().all(|c| names.contains(&c)) {
            continue;
        }
        let begins = counted
            || at.checked_sub(1).is_some_and(|before| {
                matches!(tokens[before].kind, Kind::Operator | Kind::Relation | Kind::Open(_))
            });
        let ends = tokens.get(at + 1).is_none_or(|next| match next.kind {
            Kind::Operator | Kind::Relation | Kind::Close(_) | Kind::Comma => true,
            Kind::Cut => !next.word,
            _ => false,
        });
        if begins && ends {
            (tokens[at].kind, tokens[at].word, tokens[at].product) = (Kind::Name, false, true);
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Name,
    /// A bare `a`, `A` or `I`, which may be a word.
    Article,
    Number,
    /// ∑, ∏, ∫, ∂ …: an operand follows.
    Prefix,
    /// `!`: an operand stands before.
    Postfix,
    Operator,
    Relation,
    Open(char),
    Close(char),
    Comma,
    Dots,
    Cut,
    /// A sign of mathematics that is not known: what it touches is not read.
    Strange,
}

#[derive(Clone, Debug)]
struct Token {
    kind: Kind,
    range: Range<usize>,
    /// Whether white space stands before it.
    spaced: bool,
    /// Marks of emphasis at both ends.
    marks: usize,
    /// Whether it is a word of letters that are no ideographs.
    word: bool,
    /// Whether its letters stand for their product.
    product: bool,
}

fn tokens(line: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut at = 0;
    let mut spaced = false;
    while let Some(c) = line.piece(at..).chars().next() {
        if c.is_whitespace() {
            at += c.len_utf8();
            spaced = true;
            continue;
        }
        let (kind, len, marks) = token(line, at, c);
        let word = kind == Kind::Cut && (is_letter(c) && !is_ideograph(c) || c.is_ascii_digit());
        tokens.push(Token { kind, range: at..at + len, spaced, marks, word, product: false });
        at += len;
        spaced = false;
    }
    tokens
}

fn token(line: &str, at: usize, c: char) -> (Kind, usize, usize) {
    let rest = line.piece(at..);
    let one = c.len_utf8();
    if c.is_ascii_digit() {
        let mut len = rest.bytes().take_while(u8::is_ascii_digit).count();
        if let Some(tail) = rest.piece(len..).strip_prefix('.') {
            let decimals = tail.bytes().take_while(u8::is_ascii_digit).count();
            len += if decimals > 0 { decimals + 1 } else { 0 };
        }
        let word = letters(rest.piece(len..));
        if word > 1 {
            return (Kind::Cut, len + word, 0);
        }
        return (Kind::Number, len + exponents(rest.piece(len..)), 0);
    }
    if is_letter(c) {
        let word = letters(rest);
        if word > 1 || !c.is_ascii() {
            return (Kind::Cut, word, 0);
        }
        return name(rest, one);
    }
    if letters::name(c).is_some() || letters::of_blackboard(c).is_some() {
        return name(rest, one);
    }
    if c == '*' {
        let marks = rest.bytes().take_while(|&byte| byte == b'*').count();
        let free = !line.piece(..at).ends_with(|c: char| c.is_alphanumeric() || c == ')');
        if free && marks <= 2 && rest.piece(marks..).starts_with(is_symbol) {
            let inner = rest.piece(marks..);
            let first = inner.chars().next().map_or(0, char::len_utf8);
            let (kind, len, _) = name(inner, first);
            if kind != Kind::Cut
                && letters(inner) <= 1
                && inner.piece(len..).starts_with(rest.piece(..marks))
                && !inner.piece(len + marks..).starts_with(|c: char| c.is_alphanumeric() || c == '*')
            {
                return (Kind::Name, len + 2 * marks, marks);
            }
        }
        return (if marks == 1 { Kind::Operator } else { Kind::Cut }, marks, 0);
    }
    for dots in ["...", "…", "⋯"] {
        if rest.starts_with(dots) {
            return (Kind::Dots, dots.len(), 0);
        }
    }
    for relation in [":=", "<=", ">=", "!=", "=", "≤", "≥", "≠", "≔", "≜", "⩽", "⩾", "<", ">"] {
        if let Some(after) = rest.strip_prefix(relation) {
            // ==, =>, <=> and arrows are no relations.
            let arrow = after.starts_with(['=', '>', '<']) || (relation == "<" && after.starts_with('-'));
            return (if arrow { Kind::Cut } else { Kind::Relation }, relation.len() + usize::from(arrow), 0);
        }
    }
    let kind = match c {
        '∑' | '∏' | '∫' | '∂' | '∇' => {
            let (kind, len, _) = name(rest, one);
            return (if kind == Kind::Cut { kind } else { Kind::Prefix }, len, 0);
        }
        '√' => Kind::Prefix,
        '!' => Kind::Postfix,
        '+' | '-' | '−' | '–' | '±' | '/' | '^' | '·' | '⋅' | '×' | '∘' | '⊗' => Kind::Operator,
        '(' | '[' | '{' => Kind::Open(c),
        '（' => Kind::Open('('),
        ')' | '）' => Kind::Close('('),
        ']' => Kind::Close('['),
        '}' => Kind::Close('{'),
        ',' | ';' => Kind::Comma,
        '∞' => Kind::Number,
        // The blocks of mathematical operators, and what ASCII has of them.
        '%' | '~' | '&' | '@' | '\u{2200}'..='\u{22ff}' | '\u{2a00}'..='\u{2aff}' => Kind::Strange,
        _ => Kind::Cut,
    };
    (kind, one, 0)
}

/// Letters that form words: Greek letters and raised ones stand for themselves.
fn is_letter(c: char) -> bool {
    c.is_alphabetic() && letters::name(c).is_none() && letters::of_blackboard(c).is_none() && !is_raised(c)
}

fn is_symbol(c: char) -> bool {
    c.is_ascii_alphabetic() || letters::name(c).is_some()
}

/// Raised and lowered digits, letters and signs, and accents.
fn is_raised(c: char) -> bool {
    matches!(c, '²' | '³' | '¹' | 'ʰ'..='˿' | 'ᴬ'..='ᶿ' | '⁰'..='₟' | 'ⱼ' | 'ⱽ')
        || matches!(c, '\u{302}'..='\u{308}' | '\u{20d7}')
}

/// The bytes of the word at the beginning; a letter may stand next to an ideograph.
fn letters(text: &str) -> usize {
    let ideographs = text.starts_with(is_ideograph);
    text.chars().take_while(|&c| is_letter(c) && is_ideograph(c) == ideographs).map(char::len_utf8).sum()
}

/// The bytes of raised characters and primes at the beginning.
fn exponents(text: &str) -> usize {
    text.chars().take_while(|&c| is_raised(c)).map(char::len_utf8).sum()
}

/// A name of one letter of `len` bytes, with its indices, exponents and primes.
fn name(text: &str, len: usize) -> (Kind, usize, usize) {
    let letter = len;
    let mut len = len;
    len += text.piece(len..).bytes().take_while(u8::is_ascii_digit).count();
    loop {
        let rest = text.piece(len..);
        len += match rest.chars().next() {
            Some(c) if is_raised(c) || matches!(c, '\'' | '’' | '′' | '″') => c.len_utf8(),
            Some(sign @ ('_' | '^')) => match script(rest.piece(1..), text.starts_with(['∑', '∏'])) {
                Some(script) => 1 + script,
                None if sign == '^' => break,
                // A word with underscores.
                None => return (Kind::Cut, len + 1 + letters(rest.piece(1..)), 0),
            },
            _ => break,
        };
    }
    let article = len == letter && text.starts_with(['a', 'A', 'I']);
    (if article { Kind::Article } else { Kind::Name }, len, 0)
}

/// The bytes of an index or exponent: in braces, digits, or a letter; `a_ju_j` are two names. Below a sum (`bounds`) it
/// may say from where.
fn script(text: &str, bounds: bool) -> Option<usize> {
    let first = text.chars().next()?;
    if first == '(' {
        // b_(i-1), B_i^(n-1)
        let close = text.bytes().take(40).position(|byte| byte == b')')?;
        let inner = text.piece(1..close);
        return (!inner.is_empty() && !inner.contains(['(', '=', ' '])).then_some(close + 1);
    }
    if first == '{' {
        let close = text.bytes().take(40).position(|byte| byte == b'}')?;
        let inner = text.piece(1..close);
        return (!inner.contains('{') && (bounds || !inner.contains('='))).then_some(close + 1);
    }
    if first.is_ascii_digit() {
        return Some(text.bytes().take_while(u8::is_ascii_digit).count());
    }
    if letters::name(first).is_some() {
        return Some(first.len_utf8());
    }
    if !first.is_ascii_alphabetic() {
        return None;
    }
    let word = letters(text);
    let splits = text.piece(word..).starts_with(|c: char| matches!(c, '_' | '^' | '(') || is_raised(c));
    match word {
        1 => Some(1),
        2 if splits => Some(1),
        2 => Some(2),
        _ => None,
    }
}

/// The parts of a segment between brackets that have no partner in it.
fn balanced(segment: &[Token]) -> Vec<&[Token]> {
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut lonely = Vec::new();
    for (i, token) in segment.iter().enumerate() {
        match token.kind {
            Kind::Open(c) => open.push((i, c)),
            Kind::Close(c) => {
                // `[0, 1)` is an interval: one kind of bracket may close the other.
                if open.last().is_some_and(|&(_, o)| o == c || (o != '{' && c != '{')) {
                    open.pop();
                } else {
                    lonely.push(i);
                }
            }
            _ => {}
        }
    }
    lonely.extend(open.into_iter().map(|(i, _)| i));
    lonely.sort_unstable();
    let mut runs = Vec::new();
    let mut from = 0;
    for at in lonely.into_iter().chain([segment.len()]) {
        // What follows `f(` is half an argument.
        let call = from >= 2
            && matches!(segment[from - 1].kind, Kind::Open(_))
            && matches!(segment[from - 2].kind, Kind::Name | Kind::Article)
            && !segment[from - 1].spaced;
        if from < at && !call {
            runs.push(&segment[from..at]);
        }
        from = at + 1;
    }
    runs
}

/// The formulas of a run whose brackets are balanced: its parts between commas.
fn formulas(line: &str, run: &[Token], mut continues: bool) -> Vec<Found> {
    let mut found = Vec::new();
    let mut depth = 0_usize;
    let mut from = 0;
    let mut parts: Vec<&[Token]> = Vec::new();
    for (i, token) in run.iter().enumerate() {
        match token.kind {
            Kind::Open(_) => depth += 1,
            Kind::Close(_) => depth = depth.saturating_sub(1),
            Kind::Comma if depth == 0 => {
                parts.push(&run[from..i]);
                from = i + 1;
            }
            _ => {}
        }
    }
    parts.push(&run[from..]);
    for (i, part) in parts.iter().enumerate() {
        // `i = 0, 1, …, n` and `x = 1, 2` say something else than `i = 0` and `x = 1`.
        let list = parts.get(i + 1).is_some_and(|next| {
            matches!(next, [Token { kind: Kind::Number | Kind::Dots, .. }, ..])
                && !next.iter().any(|token| token.kind == Kind::Relation)
        });
        if !list && part.len() <= MAX_TOKENS {
            found.extend(formula(line, part, continues));
        }
        continues = false;
    }
    found
}

/// The longest readable formula of a part, which may lack a few tokens at the ends.
fn formula(line: &str, part: &[Token], continues: bool) -> Option<Found> {
    let mut part = part;
    // `-o=2` is an option of a program.
    while let [Token { kind: Kind::Open('('), .. }, inner @ .., Token { kind: Kind::Close('('), .. }] = part
        && closes_at(part) == Some(part.len() - 1)
    {
        part = inner;
    }
    let glued = part.iter().all(|token| token.kind != Kind::Relation || !token.spaced);
    if glued && part.first().is_some_and(|token| is_minus(line, token)) {
        return None;
    }
    // In `a F(t) = 0` the first letter is a word.
    while let Some(last) = part.windows(2).rposition(|pair| {
        pair[0].kind == Kind::Article && pair[1].spaced && starts_operand(&pair[1]) || joins_nothing(pair)
    }) {
        let (head, tail) = part.split_at(last + 1);
        part = if has_relation(tail) {
            tail
        } else {
            &head[..head.len() - usize::from(head[last].kind == Kind::Article)]
        };
    }
    for cut in 0..=MAX_CUT {
        for front in 0..=cut {
            let end = part.len().checked_sub(cut - front)?;
            let Some(tokens) = part.get(front..end) else { continue };
            if let Some(found) = readable(line, tokens, continues && front == 0) {
                return Some(found);
            }
        }
    }
    None
}

/// Where the bracket is closed with which the tokens begin.
fn closes_at(tokens: &[Token]) -> Option<usize> {
    let mut depth = 0_usize;
    tokens.iter().position(|token| {
        match token.kind {
            Kind::Open(_) => depth += 1,
            Kind::Close(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0
    })
}

fn is_minus(line: &str, token: &Token) -> bool {
    matches!(line.piece(token.range.clone()), "-" | "−")
}

fn starts_operand(token: &Token) -> bool {
    matches!(token.kind, Kind::Name | Kind::Article | Kind::Number | Kind::Prefix)
}

/// Two operands that cannot be a product: `x 2`.
fn joins_nothing(pair: &[Token]) -> bool {
    matches!(pair[0].kind, Kind::Name | Kind::Article | Kind::Number) && pair[1].kind == Kind::Number
}

fn has_relation(tokens: &[Token]) -> bool {
    tokens.iter().any(|token| token.kind == Kind::Relation)
}

fn readable(line: &str, tokens: &[Token], continues: bool) -> Option<Found> {
    let first = tokens.first()?;
    let last = tokens.last()?;
    let begins = match first.kind {
        Kind::Relation => continues,
        Kind::Operator => is_minus(line, first),
        Kind::Postfix | Kind::Close(_) | Kind::Comma | Kind::Cut | Kind::Dots => false,
        _ => true,
    };
    let ends =
        matches!(last.kind, Kind::Name | Kind::Article | Kind::Number | Kind::Close(_) | Kind::Postfix);
    if !begins || !ends {
        return None;
    }
    let mut depth = 0_usize;
    let mut sides = vec![0_usize];
    let mut strong = false;
    for token in tokens {
        match token.kind {
            Kind::Open(_) => depth += 1,
            Kind::Close(_) => depth = depth.checked_sub(1)?,
            Kind::Relation if depth == 0 => {
                sides.push(0);
                strong |= !matches!(line.piece(token.range.clone()), "<" | ">");
            }
            Kind::Name | Kind::Article | Kind::Number => {
                if let Some(side) = sides.last_mut() {
                    *side += 1;
                }
            }
            _ => {}
        }
    }
    let skipped = usize::from(continues && first.kind == Kind::Relation);
    if depth != 0 || sides.len() < 2 || !strong || sides[skipped..].contains(&0) {
        return None;
    }
    let range = first.range.start..last.range.end;
    let mut text = line.piece(range.clone()).to_owned();
    for token in tokens.iter().filter(|token| token.marks > 0) {
        let (from, to) = (token.range.start - range.start, token.range.end - range.start);
        let blank = " ".repeat(token.marks);
        text.replace_range(from..from + token.marks, &blank);
        text.replace_range(to - token.marks..to, &blank);
    }
    let asked = if skipped > 0 { format!("x{text}") } else { text.clone() };
    let style = if !tokens.iter().any(|token| token.product) && syntax::parse(&asked).is_ok() {
        Style::Plain
    } else {
        latex::read(&asked).ok().map(|_| Style::Inline)?
    };
    Some(Found { range, text, style })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(line: &str) -> Vec<String> {
        find(line, false).into_iter().map(|found| found.text).collect()
    }

    #[test]
    fn formulas_in_prose() {
        for (line, wanted) in [
            ("by the identity F(u) = f(u, u, u). (u is real)", vec!["F(u) = f(u, u, u)"]),
            ("and f (∑_j a_ju_j) = ∑_j a_jf(u_j) for all", vec!["f (∑_j a_ju_j) = ∑_j a_jf(u_j)"]),
            ("with ∑ a_j = 1.", vec!["∑ a_j = 1"]),
            ("of F(t) = t³ + 3t² + 5t + 1 can", vec!["F(t) = t³ + 3t² + 5t + 1"]),
            ("that f(u,..., u) = F(u), where", vec!["f(u,..., u) = F(u)"]),
            ("(given that x_1 ≤ t ≤ x_2)", vec!["x_1 ≤ t ≤ x_2"]),
            ("F(0) = 0, F(1) = 1", vec!["F(0) = 0", "F(1) = 1"]),
            ("define G(t) := -t^2;", vec!["G(t) := -t^2"]),
            ("曲线F(t) = t²在", vec!["F(t) = t²"]),
            ("take a F(t) = 2t here", vec!["F(t) = 2t"]),
            ("f(t1, t2) = t1 t2 + 1", vec!["f(t1, t2) = t1 t2 + 1"]),
            ("so a = b + 1 and", vec!["a = b + 1"]),
            ("let n! = n (n-1)!", vec!["n! = n (n-1)!"]),
            ("here b_(i-1) = b_i holds", vec!["b_(i-1) = b_i"]),
            ("and B_i^(n-1)(t) = 0 holds", vec!["B_i^(n-1)(t) = 0"]),
            ("(a-b)^2 = a^2 - 2ab + b^2.", vec!["(a-b)^2 = a^2 - 2ab + b^2"]),
            ("f(r,s,t) = rst + rs - t", vec!["f(r,s,t) = rst + rs - t"]),
            ("that ∑_{i=1}^n i = n (n+1)/2 is", vec!["∑_{i=1}^n i = n (n+1)/2"]),
            ("（1 + 1）= 2", vec!["（1 + 1）= 2"]),
            ("this holds (x = y + 1) there", vec!["x = y + 1"]),
            ("x = 1, y = a - step", vec!["x = 1"]),
            ("so B_i^(2)(t) = binom(2,i) t^i holds", vec!["B_i^(2)(t) = binom(2,i) t^i"]),
        ] {
            assert_eq!(found(line), wanted, "{line}");
        }
    }

    #[test]
    fn emphasis_is_blanked() {
        let all = find("of *F*(t) = 2 *t* as", false);
        assert_eq!(all[0].text, " F (t) = 2  t ");
        assert_eq!(all[0].range, 3..17);
    }

    #[test]
    fn prose_stays_prose() {
        for line in [
            "for i = 0, 1, ..., n we",
            "x = 1, 2 or 3",
            "width=5px height=3em",
            "max_degree = 3",
            "speed = distance / time",
            "a function F",
            "if x == y then",
            "n => n+1",
            "f : ℝ → ℝ",
            "F =",
            "= 3 is it",
            "赋范空间=线性空间+范数",
            "the points f(0,0,0), f(0,0,1)",
            "x < y",
            "a / b",
            "--flag=value -o=2",
            "E = mc²",
            "f(x = y",
            "a = b ⊕ c",
            "x = y % z",
            "a ~ b = c",
            "é(t) = 4",
            "a = b - step + c",
            "speed / c = a",
            "x = y + 2area",
            "Bézier(n) = 3",
        ] {
            assert_eq!(found(line), [""; 0], "{line}");
        }
    }

    #[test]
    fn a_formula_may_go_on() {
        let all = find("\t= f(0, 0, 1)", true);
        assert_eq!((all[0].text.as_str(), all[0].range.clone()), ("= f(0, 0, 1)", 1..13));
        assert!(find("is = 3", true).is_empty());
    }
}
