//! Jupyter notebooks: their Markdown cells are woven as Markdown files are.
//!
//! Only the bytes of results change in the file. The session runs through all cells. There is no stamp:
//! a notebook has no place for it that Jupyter would leave alone.

use super::markdown::{Edit, edited, edits};
use super::runner::Runner;
use super::{Options, Woven, plan};
use crate::document::Places;
use crate::document::markdown_cells;
use crate::formula::source::{Pieces, SourceFile, Span};
use crate::session::Session;

/// Weaves the Markdown cells of a notebook.
///
/// Cost: the queries, and time linear in the length of the text.
///
/// ```
/// use polarform::source::SourceFile;
/// use polarform::weave::{Options, weave_notebook};
/// let text = r#"{"cells": [{"cell_type": "markdown", "source": ["so $1 + 1 = {{ 1 + 1 }}$\n"]}]}"#;
/// let woven = weave_notebook(&SourceFile::new("a.ipynb", text), &Options::default());
/// assert!(woven.text.contains(r#"["so $1 + 1 = 2$<!-- $1 + 1 = {{ 1 + 1 }}$ -->\n"]"#));
/// ```
pub fn weave_notebook(file: &SourceFile, options: &Options) -> Woven {
    let mut runner = Runner::new(Session::new(options.limits.clone()));
    let mut changes = Vec::new();
    match markdown_cells(file.text()) {
        Ok(cells) => {
            for cell in cells {
                let plan = plan::plan(&cell.text, &options.blocks);
                let place = |span: Span| in_file(&cell.places, span);
                let found = edits(&cell.text, &plan, &mut runner, file, &place, options);
                changes.extend(found.into_iter().map(|edit| Edit {
                    span: place(edit.span),
                    new: escaped(&edit.new),
                    query: place(edit.query),
                    ..edit
                }));
            }
        }
        Err(problem) => runner.problem(problem, file),
    }
    let mut woven = Woven { text: edited(file.text(), &changes), ..Woven::default() };
    woven.stale = changes.iter().map(|edit| (file.clone(), edit.query)).collect();
    woven.take(runner);
    woven
}

/// The bytes of the file; an empty span stands right after the byte before it.
fn in_file(places: &Places, span: Span) -> Span {
    if !span.is_empty() {
        return places.span(span);
    }
    let at = match span.start.checked_sub(1) {
        Some(before) => places.span(Span::new(before, span.start)).end,
        None => places.byte(0),
    };
    Span::new(at, at)
}

/// The text as it stands in a string of JSON.
fn escaped(text: &str) -> String {
    let string = serde_json::Value::from(text).to_string();
    string.piece(1..string.len() - 1).to_owned()
}
