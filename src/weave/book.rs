//! Books of mdBook: a preprocessor that weaves every chapter as a template.
//!
//! mdBook writes `[context, book]` as JSON and reads the book back. Each chapter is a file of its own,
//! with a session of its own. The book has its chapters under `items` (mdBook 0.5) or `sections` (0.4),
//! and those below a chapter under `sub_items`.

use std::fmt;

use serde_json::Value;

use super::breakable::{broken, in_table};
use super::{Mode, Options, Woven, weave_markdown};
use crate::document::{Part, PartKind, Style, markdown_parts};
use crate::formula::source::{Pieces, SourceFile, Span, replaced};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::session::Failure;

/// Why there is no book.
#[derive(Debug)]
pub enum BookError {
    /// The text is no JSON.
    Json(serde_json::Error),
    /// It is JSON, but not `[context, book]`.
    Shape,
}

impl fmt::Display for BookError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BookError::Json(error) => write!(f, "what mdBook should have sent is no JSON: {error}"),
            BookError::Shape => f.write_str("mdBook should have sent [context, book]"),
        }
    }
}

impl std::error::Error for BookError {}

/// Weaves the book that mdBook sends; the text of the outcome is the book to send back.
///
/// Cost: the queries, and time linear in the length of the text.
///
/// # Errors
/// When the text is not what mdBook sends.
///
/// ```
/// use polarform::weave::{Options, weave_book};
/// let sent = r#"[{}, {"items": [{"Chapter": {"name": "One", "content": "{{ 1 + 1 }}"}}]}]"#;
/// let woven = weave_book(sent, &Options::default()).unwrap();
/// assert!(woven.text.contains(r#""content":"$2$""#));
/// ```
pub fn weave_book(text: &str, options: &Options) -> Result<Woven, BookError> {
    let mut sent: Value = serde_json::from_str(text).map_err(BookError::Json)?;
    // Another preprocessor that takes formulas out before they are read as Markdown.
    let sets_formulas = sent.pointer("/0/config/preprocessor/katex").is_some();
    let book = sent.get_mut(1).filter(|book| book.is_object()).ok_or(BookError::Shape)?;
    let options = Options { mode: Mode::Template, ..options.clone() };
    let mut woven = Woven::default();
    let items = if book.get("items").is_some() { "items" } else { "sections" };
    let items = book.get_mut(items).and_then(Value::as_array_mut).ok_or(BookError::Shape)?;
    let mut waiting: Vec<&mut Value> = items.iter_mut().rev().collect();
    while let Some(item) = waiting.pop() {
        let Some(Value::Object(chapter)) = item.get_mut("Chapter") else { continue };
        let name = ["source_path", "path", "name"].iter().find_map(|key| chapter.get(*key)?.as_str());
        let name = name.unwrap_or("<chapter>").to_owned();
        if let Some(Value::String(content)) = chapter.get_mut("content") {
            let result_name = name.clone();
            let result = weave_markdown(&SourceFile::new(name, content.as_str()), &options);
            content.clone_from(&result.text);
            let file = SourceFile::new(result_name, content.as_str());
            let lost = match options.set {
                Some(set) => {
                    let (text, unset) = with_formulas(content, set);
                    *content = text;
                    unset
                }
                None if sets_formulas => Vec::new(),
                None => broken_formulas(content),
            };
            woven.problems.extend(lost.into_iter().map(|problem| Failure { problem, file: file.clone() }));
            woven.failed |= result.failed;
            woven.refuted += result.refuted;
            woven.results += result.results;
            woven.problems.extend(result.problems);
        }
        if let Some(Value::Array(below)) = chapter.get_mut("sub_items") {
            waiting.extend(below.iter_mut().rev());
        }
    }
    woven.text = book.to_string();
    Ok(woven)
}

/// A page with its formulas as HTML, which no renderer of Markdown takes apart, and those that stay as they are.
fn with_formulas(text: &str, set: fn(&str, bool) -> Option<String>) -> (String, Vec<Diagnostic>) {
    let mut made: Vec<(Span, String)> = Vec::new();
    let mut unset = Vec::new();
    for part in markdown_parts(text).0 {
        let PartKind::Formula { style, inner } = &part.kind else { continue };
        if *style == Style::Plain {
            continue;
        }
        match set(part.text.piece(inner.clone()), *style != Style::Inline) {
            Some(html) => made.push((part.span, unmarked(&html))),
            None => {
                let message = "this formula cannot be set as MathML and stays as it is";
                unset.push(Diagnostic::warning(Code::UnsupportedLatex, message).at(part.span));
            }
        }
    }
    (replaced(text, made.iter().map(|(span, html)| (*span, html.as_str()))), unset)
}

/// Formulas that mdBook would not show as they stand.
fn broken_formulas(text: &str) -> Vec<Diagnostic> {
    let told = |part: Part| {
        if !matches!(&part.kind, PartKind::Formula { style, .. } if *style != Style::Plain) {
            return None;
        }
        let why = broken(&part.text, in_table(text, part.span.start))?;
        let message = format!("mdBook takes this formula apart: {why}");
        let problem = Diagnostic::warning(Code::BrokenFormula, message).at(part.span);
        Some(problem.hint("polarform weave --mdbook --mathml sets formulas so that none can be broken"))
    };
    markdown_parts(text).0.into_iter().filter_map(told).collect()
}

/// HTML within a line of Markdown, of which no sign is one of Markdown.
fn unmarked(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut tag = false;
    for c in html.chars() {
        match c {
            '<' => tag = true,
            '>' => tag = false,
            _ => {}
        }
        match c {
            '\n' | '\r' => out.push(' '),
            '*' | '_' | '`' | '[' | ']' | '\\' | '~' | '$' | '!' if !tag => {
                out.push_str(&format!("&#{};", u32::from(c)));
            }
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_safe_from_markdown() {
        let set: fn(&str, bool) -> Option<String> = |latex, display| {
            (latex != "?").then(|| format!("<math a=\"_\">\n<mi>{}*_</mi>{display}</math>", latex.trim()))
        };
        let page = "In $a_1 * b$ and $?$:\n\n> $$\n> c\n> $$\n\n`$d$` costs 3$ or 4$.\n";
        let (text, unset) = with_formulas(page, set);
        assert_eq!(
            text,
            "In <math a=\"_\"> <mi>a&#95;1 &#42; b&#42;&#95;</mi>false</math> and $?$:\n\n\
             > <math a=\"_\"> <mi>c&#42;&#95;</mi>true</math>\n\n`$d$` costs 3$ or 4$.\n"
        );
        assert_eq!(unset.len(), 1);
        assert_eq!(unset[0].span, Some(Span::new(page.find("$?$").unwrap(), page.find("$?$").unwrap() + 3)));
    }
}
