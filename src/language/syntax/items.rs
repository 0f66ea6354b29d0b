//! Lists written without commas: `0 0 1/2 1`, `[0, 0] [1, 2]`.

use super::lexer;
use super::token::{Bracket, Token, TokenKind};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// Where the items of a list stand that has blanks for commas; `None` if `text` is anything else.
///
/// The items are numbers, ranges of numbers, points in brackets, or names; several names or a name
/// first, since `2 t` is a product.
///
/// # Errors
/// When a sign might be that of an item or a difference, as in `1 -1`; when the text is too long.
///
/// ```
/// use polarform::syntax::spaced_items;
/// let text = "0 0 1/2 1";
/// let items: Vec<_> = spaced_items(text).unwrap().unwrap().into_iter().map(|s| &text[s.range()]).collect();
/// assert_eq!(items, ["0", "0", "1/2", "1"]);
/// assert_eq!(spaced_items("0, 1"), Ok(None));
/// assert_eq!(spaced_items("b_0 b_1 b_2").unwrap().map(|items| items.len()), Some(3));
/// assert_eq!(spaced_items("2 t"), Ok(None));
/// assert!(spaced_items("1 -1").is_err());
/// ```
pub fn spaced_items(text: &str) -> Result<Option<Vec<Span>>, Diagnostic> {
    let tokens = lexer::lex(text)?;
    let pieces = pieces(&tokens);
    if pieces.len() < 2 || !pieces.iter().all(|piece| is_item(piece) || is_name(piece)) {
        return Ok(None);
    }
    let names = pieces.iter().filter(|piece| is_name(piece)).count();
    if names == 1 && pieces.len() == 2 && !is_name(pieces[0]) {
        return Ok(None);
    }
    let spans: Vec<Span> =
        pieces.iter().map(|piece| piece[0].span().to(piece[piece.len() - 1].span())).collect();
    if let Some(signed) = pieces[1..].iter().find(|piece| is_sign(piece[0])) {
        return Err(ambiguous(text, &spans, signed[0]));
    }
    Ok(Some(spans))
}

/// The tokens, cut at the blanks outside of brackets.
fn pieces(tokens: &[Token]) -> Vec<&[Token]> {
    let mut depth = 0_usize;
    tokens
        .chunk_by(|before, after| {
            match before.kind {
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth > 0 || !after.spaced
        })
        .collect()
}

fn is_sign(token: Token) -> bool {
    matches!(token.kind, TokenKind::Plus | TokenKind::Minus)
}

fn is_item(piece: &[Token]) -> bool {
    let unsigned = if is_sign(piece[0]) { &piece[1..] } else { piece };
    let kinds: Vec<TokenKind> = unsigned.iter().take(4).map(|token| token.kind).collect();
    match kinds.as_slice() {
        [TokenKind::Number]
        | [TokenKind::Number, TokenKind::Slash | TokenKind::DotDot, TokenKind::Number] => true,
        [TokenKind::Open(Bracket::Paren | Bracket::Square), ..] => is_point(piece),
        _ => false,
    }
}

/// A name with its index: b, b0, b_0, b_{10}.
fn is_name(piece: &[Token]) -> bool {
    let kinds: Vec<TokenKind> = piece.iter().map(|token| token.kind).collect();
    match kinds.as_slice() {
        [TokenKind::Name] | [TokenKind::Name, TokenKind::Index] => true,
        [TokenKind::Name, TokenKind::Underscore, index @ ..] => match index {
            [TokenKind::Number | TokenKind::Index | TokenKind::Name] => true,
            [TokenKind::Open(Bracket::Brace), inside @ .., TokenKind::Close(Bracket::Brace)] => {
                let part = |kind: &TokenKind| {
                    matches!(kind, TokenKind::Number | TokenKind::Index | TokenKind::Name | TokenKind::Comma)
                };
                inside.iter().all(part)
            }
            _ => false,
        },
        _ => false,
    }
}

/// Whether one pair of brackets stands around all of it, with a comma directly inside.
fn is_point(piece: &[Token]) -> bool {
    let mut depth = 0_usize;
    let mut comma = false;
    for (i, token) in piece.iter().enumerate() {
        match token.kind {
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) => depth = depth.saturating_sub(1),
            TokenKind::Comma => comma |= depth == 1,
            _ => {}
        }
        if depth == 0 {
            return comma && i + 1 == piece.len() && i > 0;
        }
    }
    false
}

fn ambiguous(text: &str, spans: &[Span], sign: Token) -> Diagnostic {
    /// A longer list is not repeated in a hint.
    const LONGEST: usize = 60;
    let problem = Diagnostic::error(Code::UnexpectedToken, "a list without commas, or a difference?")
        .at(sign.span())
        .reason("the sign of an item, or an operator?");
    if text.len() > LONGEST {
        return problem.hint("write commas between the items");
    }
    let items: Vec<&str> = spans.iter().map(|span| text.piece(span.range())).collect();
    problem.hint(format!("for a list write {}", items.join(", ")))
}
