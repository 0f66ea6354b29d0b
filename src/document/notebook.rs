//! Jupyter notebooks: the Markdown cells of the JSON.
//!
//! The text of a cell stands in strings of JSON, where `\` is written `\\` and a line ends with
//! `\n`. So a cell is a derived text: it is decoded with the place of each byte, taken apart as
//! Markdown, and what was found is led back to the file.
//!
//! Reference: the notebook format 4 (nbformat), and 3, where the cells stand in worksheets.

use std::collections::BTreeMap;

use serde_json::value::RawValue;

use super::blocks;
use super::collect::Collector;
use super::text::Text;
use crate::document::{Item, Places};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// Takes a notebook apart.
pub(super) fn scan(text: &str, out: &mut Collector) {
    out.escaped = true;
    match sources(text) {
        Ok(sources) => {
            for source in sources {
                match cell(text, source) {
                    Ok(cell) => markdown(&cell, out),
                    Err(problem) => out.problem(problem),
                }
            }
        }
        Err(problem) => out.problem(problem),
    }
}

/// A Markdown cell of a notebook.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Its text.
    pub text: String,
    /// From bytes of the text to bytes of the file.
    pub places: Places,
}

/// The Markdown cells of a notebook, in its order.
///
/// # Errors
/// When the text is no notebook.
pub fn markdown_cells(text: &str) -> Result<Vec<Cell>, Diagnostic> {
    let decoded = |source: &RawValue| {
        let Text { text: decoded, places } = cell(text, source)?;
        Ok(Cell { text: decoded, places })
    };
    sources(text)?.into_iter().map(decoded).collect()
}

type Object<'a> = BTreeMap<String, &'a RawValue>;

/// The sources of the Markdown cells.
fn sources(text: &str) -> Result<Vec<&RawValue>, Diagnostic> {
    let notebook: Object = serde_json::from_str(text).map_err(|error| {
        let at = place(text, error.line(), error.column());
        broken(&error.to_string(), Span::new(at, at))
    })?;
    let mut lists = Vec::new();
    match (notebook.get("cells"), notebook.get("worksheets")) {
        (Some(cells), _) => lists.push(*cells),
        (None, Some(sheets)) => {
            for sheet in list(text, sheets)? {
                lists.extend(object(text, sheet)?.get("cells").copied());
            }
        }
        (None, None) => return Err(broken("it has no cells", Span::new(0, 0))),
    }
    let mut sources = Vec::new();
    for cells in lists {
        for cell in list(text, cells)? {
            let cell = object(text, cell)?;
            if cell.get("cell_type").is_some_and(|kind| kind.get() == "\"markdown\"") {
                sources.extend(cell.get("source").copied());
            }
        }
    }
    Ok(sources)
}

fn list<'a>(text: &str, raw: &'a RawValue) -> Result<Vec<&'a RawValue>, Diagnostic> {
    serde_json::from_str(raw.get()).map_err(|_| broken("a list should stand here", span_of(text, raw)))
}

fn object<'a>(text: &str, raw: &'a RawValue) -> Result<Object<'a>, Diagnostic> {
    serde_json::from_str(raw.get()).map_err(|_| broken("an object should stand here", span_of(text, raw)))
}

fn broken(what: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::BrokenNotebook, format!("this is not a notebook: {what}"))
        .at(span)
        .hint("open it with Jupyter and save it anew")
}

/// The byte of a line and column, both counted from 1; columns are bytes.
fn place(text: &str, line: usize, column: usize) -> usize {
    let ends = text.match_indices('\n').map(|(at, _)| at + 1);
    let start = [0].into_iter().chain(ends).nth(line.saturating_sub(1)).unwrap_or(text.len());
    let mut at = (start + column.saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Where a value stands in the text that it was read from.
fn span_of(text: &str, raw: &RawValue) -> Span {
    // The reader of JSON hands out parts of the text itself.
    let start = (raw.get().as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
    Span::new(start, start + raw.get().len())
}

/// The text of a cell: one string, or a list of strings.
fn cell(text: &str, source: &RawValue) -> Result<Text, Diagnostic> {
    let strings = if source.get().starts_with('"') { vec![source] } else { list(text, source)? };
    let mut cell = Text::default();
    for string in strings {
        let span = span_of(text, string);
        if !string.get().starts_with('"') {
            return Err(broken("a string should stand here", span));
        }
        unescape(string.get(), span.start, &mut cell);
    }
    Ok(cell)
}

/// A part of a cell, which may reach over several of its strings.
pub(super) fn decoded(part: &str) -> String {
    let mut out = String::with_capacity(part.len());
    let mut rest = part;
    while let Some(at) = rest.find(['\\', '"']) {
        out.push_str(rest.piece(..at));
        rest = rest.piece(at..);
        if rest.starts_with('\\') {
            let (c, len) = escape(rest);
            out.push(c);
            rest = rest.piece(len..);
        } else {
            // The end of a string; the next one goes on.
            let next = rest.piece(1..).find('"').map_or(rest.len(), |next| next + 2);
            rest = rest.piece(next..);
        }
    }
    out + rest
}

/// The content of a string in quotes that stands at byte `start`.
fn unescape(string: &str, start: usize, out: &mut Text) {
    let inner = string.piece(1..string.len() - 1);
    let mut at = 0;
    while at < inner.len() {
        let plain = inner.piece(at..).find('\\').unwrap_or(inner.len() - at);
        if plain > 0 {
            out.places.push(out.text.len(), start + 1 + at, true);
            out.text.push_str(inner.piece(at..at + plain));
            at += plain;
        }
        if at < inner.len() {
            let (c, len) = escape(inner.piece(at..));
            out.push_whole(c.encode_utf8(&mut [0; 4]), Span::new(start + 1 + at, start + 1 + at + len));
            at += len;
        }
    }
}

/// The character of an escape and its length.
fn escape(text: &str) -> (char, usize) {
    let unit = |at: usize| text.get(at + 2..at + 6).and_then(|digits| u16::from_str_radix(digits, 16).ok());
    let c = match text.as_bytes().get(1) {
        Some(b'n') => '\n',
        Some(b't') => '\t',
        Some(b'r') => '\r',
        Some(b'b') => '\u{8}',
        Some(b'f') => '\u{c}',
        Some(b'u') => {
            let units = [unit(0), unit(6).filter(|_| text.piece(6..).starts_with(r"\u"))];
            let first = char::decode_utf16(units.into_iter().flatten()).next();
            let c = first.and_then(Result::ok).unwrap_or(char::REPLACEMENT_CHARACTER);
            return (c, if c.len_utf16() == 2 { 12 } else { 6 });
        }
        Some(&byte) => char::from(byte),
        None => '\\',
    };
    (c, 2.min(text.len()))
}

/// Takes a cell apart and leads what was found back to the file.
fn markdown(cell: &Text, out: &mut Collector) {
    let mut inner = Collector::with(std::mem::take(&mut out.macros), Vec::new());
    blocks::scan(&cell.text, &mut inner);
    let (items, problems, macros) = inner.into_parts();
    out.macros = macros;
    let places = &cell.places;
    for item in items {
        out.push(lead_back(item, places));
    }
    for mut problem in problems {
        problem.span = problem.span.map(|span| places.span(span));
        for label in &mut problem.labels {
            label.span = places.span(label.span);
        }
        out.problem(problem);
    }
}

fn lead_back(item: Item, places: &Places) -> Item {
    match item {
        Item::Heading { level, span } => Item::Heading { level, span: places.span(span) },
        Item::Words(span) => Item::Words(places.span(span)),
        Item::Declaration { text, span, block } => Item::Declaration { text, span: places.span(span), block },
        Item::Formula(mut formula) => {
            formula.span = places.span(formula.span);
            formula.places = formula.places.through(formula.text.len(), places);
            Item::Formula(formula)
        }
        other @ (Item::Break | Item::Enter(_) | Item::Leave(_) | Item::Title { .. }) => other,
    }
}
