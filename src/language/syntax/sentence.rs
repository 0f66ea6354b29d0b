//! A formula with the words of a sentence around it: `t^2 + 1 for t = 3`, `is t^2 = t?`, `let F(t) = t^2`.

use super::token::{Bracket, Token, TokenKind};
use super::{lexer, statement};
use crate::formula::source::Span;
use crate::language::lexicon::letters::is_ideograph;
use crate::language::lexicon::words::{self, Aside};

/// A statement taken apart.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sentence {
    /// Where its formula stands.
    pub formula: Span,
    /// Where conditions stand, each with whether it may only name what is meant for all values: for all t.
    pub conditions: Vec<(Span, bool)>,
    /// Whether it is a question.
    pub asked: bool,
}

impl Sentence {
    /// The same, in a text that stands at a place of another one.
    pub fn shifted(self, by: usize) -> Self {
        Sentence {
            formula: self.formula.shifted(by),
            conditions: self.conditions.into_iter().map(|(span, all)| (span.shifted(by), all)).collect(),
            asked: self.asked,
        }
    }
}

/// What the words around a formula say; `None` if there are none. A name that is `known` is no word.
///
/// Words inside of brackets belong to lists and cases. Cost: linear in the length of the text.
pub(crate) fn sentence(text: &str, known: &dyn Fn(&str) -> bool) -> Option<Sentence> {
    let tokens = lexer::lex(text).ok()?;
    let tokens = &tokens[..tokens.iter().rposition(|token| token.kind != TokenKind::Newline)? + 1];
    let mut parts = parts(text, tokens, known)?;
    let asks = |part: &Part| *part == Part::Word(Aside::Question);
    let mut asked = false;
    while parts.last().is_some_and(asks) {
        parts.pop();
        asked = true;
    }
    if parts.first().is_some_and(asks) {
        parts.remove(0);
        asked = true;
    }
    let introduced = parts.first() == Some(&Part::Word(Aside::Let));
    if introduced {
        parts.remove(0);
    }
    let mut pieces = Vec::new();
    let mut words = 0;
    // For n = 3, sum(…)
    if parts.first() == Some(&Part::Word(Aside::Condition)) {
        let end = parts.iter().rposition(Part::is_stop)?;
        let before: Vec<Part> = parts.drain(..=end).collect();
        pieces.extend(conditions(before));
        words += 1;
    } else if let Some(end) = parts.iter().position(|part| *part == Part::Colon)
        && parts[..end]
            .iter()
            .all(|part| matches!(part, Part::Piece(_) | Part::Stop | Part::Word(Aside::Joint)))
        && end > 0
    {
        // a = 2, b = 3: a + b
        let before: Vec<Part> = parts.drain(..=end).collect();
        pieces.extend(conditions(before));
        words += 1;
    }
    let mut rest = parts.into_iter().skip_while(Part::is_stop).peekable();
    let mut formula = rest.next()?.piece()?;
    while let Some(part) = rest.next_if(|part| !matches!(part, Part::Word(Aside::Condition | Aside::ForAll)))
    {
        match part {
            Part::Piece(more) => formula = formula.to(more),
            Part::Stop | Part::Colon => {}
            // let a = 1 and b = 2; is a = b and b = c?
            Part::Word(Aside::Joint) if introduced || asked => {}
            Part::Word(_) => return None,
        }
    }
    words += usize::from(rest.peek().is_some());
    pieces.extend(conditions(rest));
    (asked || introduced || words > 0).then_some(Sentence { formula, conditions: pieces, asked })
}

/// What a text says that begins with a word of conditions, each with whether it may only name what is meant for all values.
pub(crate) fn conditions_in(text: &str, known: &dyn Fn(&str) -> bool) -> Option<Vec<(Span, bool)>> {
    let tokens = lexer::lex(text).ok()?;
    let tokens = &tokens[..tokens.iter().rposition(|token| token.kind != TokenKind::Newline)? + 1];
    let parts = parts(text, tokens, known)?;
    matches!(parts.first(), Some(Part::Word(Aside::Condition | Aside::ForAll))).then(|| conditions(parts))
}

/// The pieces among parts, each with whether a word such as "all" stands before it, after the last "for".
fn conditions(parts: impl IntoIterator<Item = Part>) -> Vec<(Span, bool)> {
    let mut all = false;
    let mut found = Vec::new();
    for part in parts {
        match part {
            Part::Piece(span) => found.push((span, all)),
            Part::Word(Aside::Every | Aside::ForAll) => all = true,
            Part::Word(Aside::Condition) => all = false,
            Part::Word(_) | Part::Stop | Part::Colon => {}
        }
    }
    found
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Piece(Span),
    Word(Aside),
    /// A comma between pieces.
    Stop,
    /// A colon between them.
    Colon,
}

impl Part {
    fn is_stop(&self) -> bool {
        matches!(self, Part::Stop | Part::Colon)
    }

    fn piece(self) -> Option<Span> {
        match self {
            Part::Piece(span) => Some(span),
            _ => None,
        }
    }
}

/// The words outside of brackets, and what stands between them.
fn parts(text: &str, tokens: &[Token], known: &dyn Fn(&str) -> bool) -> Option<Vec<Part>> {
    let change = statement::nesting(text, tokens).change;
    let mut found: Vec<Part> = Vec::new();
    let (mut at, mut depth) = (0, 0_usize);
    // $ … $ around all of it
    let whole = tokens.len() > 2 && is_display(text, tokens[0]) && is_display(text, tokens[tokens.len() - 1]);
    let inside = whole
        && change[1..tokens.len() - 1]
            .iter()
            .scan(1, |d, c| {
                *d += i32::from(*c);
                Some(*d)
            })
            .all(|d| d > 0);
    let end = tokens.len() - usize::from(inside);
    at += usize::from(inside);
    while at < end {
        let token = tokens[at];
        let outside = depth == 0;
        match change[at] {
            1 => depth += 1,
            -1 => depth = depth.saturating_sub(1),
            _ => {}
        }
        if outside && token.kind == TokenKind::Otherwise {
            return None;
        }
        let word = if outside { word(text, &tokens[..end], at, known) } else { None };
        match (word, token.kind) {
            (Some((word, length)), _) => {
                found.push(Part::Word(word));
                at += length;
                continue;
            }
            (_, TokenKind::Comma) if outside => found.push(Part::Stop),
            (_, TokenKind::Colon) if outside && !after_lambda(text, &tokens[..at]) => found.push(Part::Colon),
            _ if outside && is_space(text, token) => {}
            _ => match found.last_mut() {
                Some(Part::Piece(piece)) => *piece = piece.to(token.span()),
                _ => found.push(Part::Piece(token.span())),
            },
        }
        at += 1;
    }
    Some(found)
}

/// Whether a colon here belongs to a function as Python writes it: lambda t: t^2, def f(t): return t^2.
fn after_lambda(text: &str, before: &[Token]) -> bool {
    if before.first().is_some_and(|first| first.text(text) == "def") {
        return true;
    }
    let names =
        before.iter().rev().take_while(|token| matches!(token.kind, TokenKind::Name | TokenKind::Comma));
    names.skip(1).any(|token| token.text(text) == "lambda")
}

/// The word that begins at a token, and how many tokens it takes.
fn word(text: &str, tokens: &[Token], at: usize, known: &dyn Fn(&str) -> bool) -> Option<(Aside, usize)> {
    let token = tokens[at];
    let written = token.text(text);
    match token.kind {
        TokenKind::Name | TokenKind::If | TokenKind::For | TokenKind::And => {
            let apart = (at == 0 || token.spaced) && tokens.get(at + 1).is_none_or(|next| next.spaced);
            let apart = apart || written.chars().all(is_ideograph);
            // on [0, 1]
            let bracket =
                tokens.get(at + 1).is_some_and(|next| next.kind == TokenKind::Open(Bracket::Square));
            let interval = (bracket && words::is_before_interval(written)).then_some(Aside::Condition);
            let aside = words::aside(written).or(interval).filter(|_| apart && !known(written))?;
            Some((aside, 1))
        }
        TokenKind::Command if words::is_text_command(written) => {
            let close =
                tokens[at..].iter().position(|token| token.kind == TokenKind::Close(Bracket::Brace))?;
            let open = tokens.get(at + 1).filter(|next| next.kind == TokenKind::Open(Bracket::Brace))?;
            let inside = Span::new(open.span().end, tokens[at + close].span().start);
            let words =
                text.get(inside.range())?.split_whitespace().map(|word| words::aside(word.trim_matches(',')));
            let asides: Vec<Aside> = words.collect::<Option<_>>()?;
            let one = match asides.as_slice() {
                [Aside::Condition, .., Aside::Every] => Aside::ForAll,
                _ => *asides.iter().find(|aside| **aside == Aside::Condition).or(asides.first())?,
            };
            Some((one, close + 1))
        }
        TokenKind::Command | TokenKind::Unknown => Some((words::aside(written)?, 1)),
        _ => None,
    }
}

fn is_display(text: &str, token: Token) -> bool {
    token.kind == TokenKind::Dollar || matches!(token.text(text), "\\[" | "\\]" | "\\(" | "\\)")
}

fn is_space(text: &str, token: Token) -> bool {
    token.kind == TokenKind::Newline
        || matches!(token.text(text), "\\quad" | "\\qquad" | "\\," | "\\;" | "\\:" | "\\!" | "\\ " | "~")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken_apart(text: &str) -> Option<(&str, Vec<&str>, bool)> {
        let found = sentence(text, &|name| name == "at")?;
        let piece = |span: Span| &text[span.range()];
        let conditions = found.conditions.into_iter().map(|(span, _)| piece(span)).collect();
        Some((piece(found.formula), conditions, found.asked))
    }

    #[test]
    fn words_are_told_from_formulas() {
        assert_eq!(taken_apart("t^2, for t = 3"), Some(("t^2", vec!["t = 3"], false)));
        assert_eq!(taken_apart("is a = b for all a and b?"), Some(("a = b", vec!["a", "b"], true)));
        assert_eq!(taken_apart("For n = 2, k = 1: B_k^n"), Some(("B_k^n", vec!["n = 2", "k = 1"], false)));
        assert_eq!(taken_apart("a = 2, b = 3: a b"), Some(("a b", vec!["a = 2", "b = 3"], false)));
        assert_eq!(taken_apart("let a = 1 and b = 2"), Some(("a = 1 and b = 2", vec![], false)));
        assert_eq!(taken_apart("let F(t) = t^2"), Some(("F(t) = t^2", vec![], false)));
        assert_eq!(taken_apart(r"$t \text{ for all } t \ge 0$"), Some(("t", vec![r"t \ge 0"], false)));
        assert_eq!(taken_apart(r"$a$ where $a = 1$"), Some(("$a$", vec!["$a = 1$"], false)));
    }

    #[test]
    fn formulas_without_words_stay_whole() {
        for text in [
            "t^2 + 1",
            "[i for i = 0..3]",
            "f(x if x < 1)",
            "a at b",
            "cases(1 if t < 0, 2 otherwise)",
            "",
            ";",
            "for",
            "?",
        ] {
            assert_eq!(taken_apart(text), None, "{text}");
        }
    }
}
