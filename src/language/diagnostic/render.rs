//! Diagnostics as text with carets, and as JSON.

use std::borrow::Cow;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet, normalize_untrusted_str};
use serde_json::{Value, json};

use super::{Diagnostic, Severity};
use crate::formula::source::{SourceFile, Span, floor_boundary};

/// A source line longer than this is shown as an excerpt around the place.
const LONG_LINE: usize = 160;

/// A longer message is shortened in the middle: it quotes something very long.
const LONG_MESSAGE: usize = 400;

/// The message, without its middle if it is very long.
pub(crate) fn shortened(message: &str) -> Cow<'_, str> {
    if message.len() <= LONG_MESSAGE {
        return Cow::Borrowed(message);
    }
    let head = floor_boundary(message, LONG_MESSAGE / 2);
    let tail = floor_boundary(message, message.len() - LONG_MESSAGE / 4);
    Cow::Owned(format!("{} … {}", &message[..head], &message[tail..]))
}

/// The problem as a person reads it: message, source line with caret, hints.
pub fn render(problem: &Diagnostic, file: &SourceFile, color: bool) -> String {
    let level = match problem.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let title = level.primary_title(shortened(&problem.message)).id(problem.code.id());
    let mut group = Group::with_title(title);
    let window = problem.span.map(|span| excerpt(file, span));
    let path = problem.span.map(|span| {
        let (line, column) = file.line_column(span.start);
        (line, column)
    });
    let mut extra = Vec::new();
    if let (Some(span), Some((start, text)), Some((line, _))) = (problem.span, &window, path) {
        let local = |s: Span| {
            let from = s.start.saturating_sub(*start).min(text.len());
            from..s.end.saturating_sub(*start).min(text.len()).max(from)
        };
        let mut primary = AnnotationKind::Primary.span(local(span));
        if let Some(reason) = &problem.reason {
            primary = primary.label(reason);
        }
        let mut snippet = Snippet::source(*text).line_start(line).path(file.name()).annotation(primary);
        for label in &problem.labels {
            if label.span.start >= *start && label.span.end <= start + text.len() {
                snippet =
                    snippet.annotation(AnnotationKind::Context.span(local(label.span)).label(&label.message));
            } else {
                extra.push(label.message.clone());
            }
        }
        group = group.element(snippet);
    } else if let Some(reason) = &problem.reason {
        extra.push(reason.clone());
    }
    for note in &extra {
        group = group.element(Level::NOTE.message(note));
    }
    for hint in &problem.hints {
        group = group.element(Level::HELP.message(shortened(hint)));
    }
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    let text = renderer.render(&[group]);
    match (problem.span, &window, path) {
        (Some(span), Some((start, excerpt)), Some(place)) => {
            let before = span.start.saturating_sub(*start).min(excerpt.len());
            let shown = excerpt[..floor_boundary(excerpt, before)].chars().count() + 1;
            with_column(text, file, place, shown)
        }
        _ => text,
    }
}

/// The renderer takes the column from what it shows of the line; this puts in that of the file.
pub(crate) fn with_column(text: String, file: &SourceFile, place: (usize, usize), shown: usize) -> String {
    let (line, column) = place;
    if shown == column {
        return text;
    }
    let name = normalize_untrusted_str(file.name());
    text.replacen(&format!("{name}:{line}:{shown}"), &format!("{name}:{line}:{column}"), 1)
}

/// The line that holds the start of `span`, cut to a window when it is very long:
/// the byte where the excerpt starts, and its text.
fn excerpt(file: &SourceFile, span: Span) -> (usize, &str) {
    let text = file.text();
    let at = floor_boundary(text, span.start);
    let line_start = text[..at].rfind('\n').map_or(0, |i| i + 1);
    let line_end = text[at..].find('\n').map_or(text.len(), |i| at + i);
    if line_end - line_start <= LONG_LINE {
        return (line_start, &text[line_start..line_end]);
    }
    let start = floor_boundary(text, at.saturating_sub(LONG_LINE / 2).max(line_start));
    let end = floor_boundary(text, (start + LONG_LINE).min(line_end));
    (start, &text[start..end])
}

/// The problem as one JSON object.
pub fn render_json(problem: &Diagnostic, file: &SourceFile) -> Value {
    let place = problem.span.map(|span| {
        let (line, column) = file.line_column(span.start);
        let (end_line, end_column) = file.line_column(span.end);
        json!({"file": file.name(), "line": line, "column": column,
               "end_line": end_line, "end_column": end_column})
    });
    json!({
        "code": problem.code.id(),
        "severity": match problem.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        },
        "message": shortened(&problem.message),
        "reason": problem.reason,
        "place": place,
        "hints": problem.hints.iter().map(|hint| shortened(hint)).collect::<Vec<_>>(),
    })
}

/// A text on one line, such as the name of a file, without characters that would move the cursor of a terminal.
pub fn harmless(text: &str) -> String {
    normalize_untrusted_str(text).replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::diagnostic::Code;

    #[test]
    fn the_column_is_that_of_the_file() {
        let file = SourceFile::new("a.md", format!("one\n{}x?", "多".repeat(200)));
        let problem = Diagnostic::error(Code::UnexpectedCharacter, "what is '?'").at(Span::new(605, 606));
        let text = render(&problem, &file, false);
        assert!(text.contains("a.md:2:202"), "{text}");
    }
}
