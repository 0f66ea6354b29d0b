//! Formulas in plain notation among words: `F(u) = f(u, u, u)`, `F(t) = t³ + 3t² + 5t + 1`.
//!
//! **Definition.** A formula in a line of prose is a longest run of names (one letter, perhaps with
//! indices, exponents, primes), numbers, operators and brackets that holds a relation sign at its
//! top level with mathematics on both sides, and that one of the two readers can read. Words of two
//! letters and more end a run, as do full stops, and commas outside of brackets.
//!
//! When in doubt it is prose: a formula that is missed says nothing, one that is made up is judged.

mod tokens;

use std::collections::BTreeSet;
use std::ops::Range;

use self::tokens::{Kind, Token, tokens};
use crate::document::{Style, vocabulary};
use crate::formula::source::Pieces;
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
        let Some(whole) = without_labels(line, &tokens, at, whole_parts(&tokens, at, segment)) else {
            continue;
        };
        for run in balanced(whole) {
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

/// A run without the numbers of formulas at its ends, `(2) a = b`, `a = b (3)`, and without that of what a word before it
/// speaks of, `Theorem 5 (x + 2)^2 = …`; `None` where it may be a factor as well: `Thus 2 (x + 1) = …`.
fn without_labels<'a>(line: &str, tokens: &[Token], at: usize, run: &'a [Token]) -> Option<&'a [Token]> {
    let mut run = run;
    if let Some(end) = label(run)
        && run.get(end).is_some_and(|next| next.spaced && may_begin(next))
    {
        run = &run[end..];
    }
    let last =
        (0..run.len()).rev().take(4).find(|&from| from > 0 && label(&run[from..]) == Some(run.len() - from));
    if let Some(from) = last.filter(|&from| run[from].spaced) {
        match run[from - 1].kind {
            Kind::Number | Kind::Close(_) => run = &run[..from],
            // f (3) is a value, a (3) a formula with its number.
            Kind::Name | Kind::Article if line.piece(run[run.len() - 1].range.end..).trim().is_empty() => {
                return None;
            }
            _ => {}
        }
    }
    let word = at.checked_sub(1).map(|before| &tokens[before]).filter(|before| before.word);
    if let (Some(word), [Token { kind: Kind::Number, .. }, next, ..]) = (word, run)
        && next.spaced
        && may_begin(next)
    {
        let word = line.piece(word.range.clone());
        if vocabulary::is_numbered(word) {
            run = &run[1..];
        } else if word.starts_with(char::is_uppercase) {
            return None;
        }
    }
    Some(run)
}

/// The length of a number in brackets at the beginning: (2), [6], (2a), (1.3).
fn label(run: &[Token]) -> Option<usize> {
    let open = match run {
        [Token { kind: Kind::Open(open @ ('(' | '[')), .. }, Token { kind: Kind::Number, .. }, ..] => *open,
        _ => return None,
    };
    let letter = usize::from(matches!(run.get(2)?.kind, Kind::Name | Kind::Article) && !run.get(2)?.spaced);
    let close = run.get(2 + letter)?;
    (close.kind == Kind::Close(open)).then_some(3 + letter)
}

fn may_begin(token: &Token) -> bool {
    starts_operand(token) || matches!(token.kind, Kind::Open(_)) || token.kind == Kind::Operator
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
            let Some(tokens) = part.get(front..end).filter(|_| is_apart(part, front, end)) else { continue };
            if let Some(found) = readable(line, tokens, continues && front == 0) {
                return Some(found);
            }
        }
    }
    None
}

/// Whether what is left out at the ends may be words and stops, with space to the rest: of `∑ᵢ i = 3` nothing is left out.
fn is_apart(part: &[Token], front: usize, end: usize) -> bool {
    let word = |token: &Token| {
        let sign = matches!(token.kind, Kind::Prefix | Kind::Operator | Kind::Postfix);
        !sign && !matches!(token.kind, Kind::Open(_) | Kind::Close(_))
    };
    let spaced = |at: usize| part.get(at).is_none_or(|token| token.spaced || token.kind == Kind::Comma);
    part[..front].iter().chain(&part[end..]).all(word)
        && (front == 0 || spaced(front) || part[front - 1].kind == Kind::Comma)
        && spaced(end)
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
            ("(2) (a+b)^2 = a^2 + 2ab + b^2", vec!["(a+b)^2 = a^2 + 2ab + b^2"]),
            ("see Eq. (7) x + 1 = y", vec!["x + 1 = y"]),
            ("Theorem 5 (x+2)^2 = y", vec!["(x+2)^2 = y"]),
            ("so 2 (x+1) = 2x + 2", vec!["2 (x+1) = 2x + 2"]),
            ("y = x + 1 (3)", vec!["y = x + 1"]),
            ("| a = 1 | b = 2 |", vec!["a = 1", "b = 2"]),
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
            "Bézier_3 + 1 = 5",
            "ñ_1 + 1 = 6",
            "³√8 + 1 = 3",
            "∑ᵢ₌₁ⁿ i = n(n+1)/2",
            "（a＋b）^2 = a^2",
            "|x| + 1 = 2",
            "⌊3/2⌋ + 1 = 2",
            "1½ + 1 = 2",
            "6÷2 = 3",
            "3€ + 2 = 5",
            "Thus 2 (x+1) = 2x + 2",
            "y = x + a (3)",
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
