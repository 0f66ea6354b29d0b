//! Displays: delimiters around a formula, rows, and reading that passes over what it cannot read.

use super::reader::{Reader, Window};
use super::token::{Env, Fence, Tok};
use crate::formula::source::{Pieces, Span};
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::Diagnostic;

/// One row of a display, read by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The bytes of the row, without `\\` and spaces around it.
    pub span: Span,
    /// The relation the row begins with, if it goes on with a chain begun above, and its place.
    pub leading: Option<(Rel, Span)>,
    /// The relation the row ends with, if the chain goes on in the next formula, and its place.
    pub trailing: Option<(Rel, Span)>,
    /// What was read, after the leading relation. Pieces that could not be read are [`Kind::Unread`].
    pub expr: Expr,
    /// Why they could not be read.
    pub problems: Vec<Diagnostic>,
}

/// The part of `text` between the signs that delimit a formula, without spaces around it.
pub(super) fn formula_span(text: &str) -> Span {
    let mut span = trimmed(text, Span::new(0, text.len()));
    loop {
        let inner = text.piece(span.range());
        let pair =
            [("$$", "$$"), ("\\[", "\\]"), ("\\(", "\\)"), ("$", "$")].into_iter().find(|(open, close)| {
                inner.len() >= open.len() + close.len() && inner.starts_with(open) && inner.ends_with(close)
            });
        // `\\(` ends in a row break, and `\\[` begins with one
        let Some((open, close)) = pair else { return span };
        if close.starts_with('\\') && inner.piece(..inner.len() - 1).ends_with("\\\\") {
            return span;
        }
        span = trimmed(text, Span::new(span.start + open.len(), span.end - close.len()));
    }
}

fn trimmed(text: &str, span: Span) -> Span {
    let inner = text.piece(span.range());
    let start = span.start + inner.len() - inner.trim_start().len();
    Span::new(start, start + inner.trim().len())
}

/// Reads each row of the formula at `span` by itself, passing over what cannot be read. Rows
/// that begin with a relation are joined to the row above if `join`.
pub(super) fn read_rows(text: &str, span: Span, join: bool) -> Vec<Row> {
    let mut reader = Reader::new(text, span, true);
    let (window, columns) = unwrapped(&reader);
    let rows = reader.formulas(window, join);
    rows.iter().for_each(|row| joined(&mut reader, row.clone()));
    rows.into_iter().map(|row| read_row(&mut reader, row, columns, !join)).collect()
}

/// The content of the environment that fills the formula, if its rows are formulas.
fn unwrapped(reader: &Reader) -> (Window, bool) {
    let mut window = 0..reader.tokens.len();
    let mut columns = false;
    loop {
        let mut inner = reader.trim(window.clone());
        while inner.len() > 1
            && matches!(reader.tokens[inner.end - 1].kind, Tok::Comma | Tok::Period | Tok::Semicolon)
        {
            inner = reader.trim(inner.start..inner.end - 1);
        }
        let Some(at) = inner.clone().next() else { return (window, columns) };
        if reader.after(at) != inner.end || inner.len() < 2 {
            return (window, columns);
        }
        let content = at + 1..inner.end - 1;
        match (reader.tokens[at].kind, reader.tokens[inner.end - 1].kind) {
            (Tok::Begin(Env::Rows), _) => columns = false,
            (Tok::Begin(Env::Array), _) if reader.has_relation(content.clone()) => columns = true,
            (Tok::Begin(Env::Cases), _) if reader.is_system(content.clone()) => columns = false,
            (Tok::Left(Fence::Curly), Tok::Right(Fence::Dot)) => {
                let table = reader.trim(content.clone());
                let is_system = table.clone().next().is_some_and(|at| {
                    matches!(reader.tokens[at].kind, Tok::Begin(_))
                        && reader.after(at) == table.end
                        && reader.is_system(at + 1..table.end - 1)
                });
                if !is_system {
                    return (window, columns);
                }
            }
            _ => return (window, columns),
        }
        window = content;
    }
}

/// Takes away the break and the space between rows of which the second goes on with the first. A sign at the end of
/// the one that the other begins with again is the same sign, as many typesetters repeat it.
fn joined(reader: &mut Reader, row: Window) {
    let mut depth = 0usize;
    let mut between = false;
    let mut last = None;
    for at in row {
        match reader.tokens[at].kind {
            Tok::Begin(_) | Tok::OpenBrace => depth += 1,
            Tok::End(_) | Tok::CloseBrace => depth = depth.saturating_sub(1),
            _ => {}
        }
        between = match reader.tokens[at].kind {
            Tok::RowBreak => depth == 0,
            Tok::Align | Tok::Gap | Tok::Skip => between,
            kind @ (Tok::Rel(_) | Tok::Plus) if between && last == Some(kind) => true,
            kind => {
                last = Some(kind);
                false
            }
        };
        if between {
            reader.tokens[at].kind = Tok::Skip;
        }
    }
}

fn read_row(reader: &mut Reader, window: Window, columns: bool, leading: bool) -> Row {
    let span = reader.span_of(window.clone());
    let trailing = if leading { trailing(reader, window.clone()) } else { None };
    let window = window.start..trailing.map_or(window.end, |(.., end)| end);
    (reader.pos, reader.end) = (window.start, window.end);
    // a colon announces the row
    let leading = if leading { reader.relation().filter(|&(rel, _)| rel != Rel::Colon) } else { None };
    let rest = reader.pos..window.end;
    let expr = match reader.whole_row(rest.clone(), true, columns) {
        Ok(expr) => expr,
        Err(problem) => {
            reader.problems.push(*problem);
            let place = if reader.is_blank(rest.clone()) { reader.here() } else { reader.span_of(rest) };
            Expr::new(Kind::Unread(reader.text.piece(place.range()).to_owned()), place)
        }
    };
    let trailing = trailing.map(|(rel, place, _)| (rel, place));
    Row { span, leading, trailing, expr, problems: std::mem::take(&mut reader.problems) }
}

/// The relation after which the row ends, its place, and the end of the row before it.
fn trailing(reader: &Reader, window: Window) -> Option<(Rel, Span, usize)> {
    let inner = reader.trim(window);
    let last = inner.clone().next_back()?;
    let Tok::Rel(rel @ (Rel::Eq | Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge | Rel::Equiv)) =
        reader.tokens[last].kind
    else {
        return None;
    };
    let before = reader.trim(inner.start..last);
    (!before.is_empty()).then(|| (rel, reader.span_of(last..last + 1), before.end))
}
