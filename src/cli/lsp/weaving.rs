//! Results filled into a page, as an action of the editor.

use std::path::{Path, PathBuf};

use lsp_types::{CodeAction, CodeActionKind, Command, TextEdit};
use serde_json::json;

use super::places::Places;
use crate::budget::Limits;
use crate::cli::beside::put_beside;
use crate::cli::pictures::{picture_prefix, put_picture};
use crate::document::{Container, PartKind, latex_parts, markdown_cells, markdown_parts, options_in};
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::Severity;
use crate::weave::{Options, Woven, weave_markdown, weave_notebook};

/// The command that the action stands for.
pub(super) const COMMAND: &str = "polarform.weave";

/// The kind of the action.
pub(super) fn kind() -> CodeActionKind {
    CodeActionKind::new("source.polarform.weave")
}

/// Whether there are queries in a page whose results are put somewhere; reStructuredText has none.
pub(super) fn has_queries(text: &str, kind: Container) -> bool {
    match kind {
        Container::Markdown => in_markdown(text),
        Container::Notebook => {
            markdown_cells(text).is_ok_and(|cells| cells.iter().any(|cell| in_markdown(&cell.text)))
        }
        Container::Latex => {
            let is_query = |kind: &PartKind| matches!(kind, PartKind::Query | PartKind::Code { .. });
            latex_parts(text).0.iter().any(|part| is_query(&part.kind))
        }
        Container::Rst => false,
    }
}

fn in_markdown(text: &str) -> bool {
    let query = |kind: &PartKind, part: &str| match kind {
        PartKind::Query => true,
        PartKind::Formula { .. } | PartKind::Comment => part.contains("{{"),
        PartKind::Code { info, .. } => text.get(info.range()).is_some_and(|info| options_in(info).is_some()),
        _ => false,
    };
    markdown_parts(text).0.iter().any(|part| query(&part.kind, &part.text))
}

/// The action for a page.
pub(super) fn action(uri: &str) -> CodeAction {
    let title = "Put the results of polarform into the page";
    CodeAction {
        title: title.to_owned(),
        kind: Some(kind()),
        command: Some(Command::new(title.to_owned(), COMMAND.to_owned(), Some(vec![json!(uri)]))),
        ..CodeAction::default()
    }
}

/// What weaving changes in a page, as one edit, and what is wrong with its queries. Pictures are written beside it, and what LaTeX
/// reads.
pub(super) fn woven(
    text: &str,
    kind: Container,
    path: Option<&PathBuf>,
    places: &Places,
    limits: &Limits,
) -> (Option<TextEdit>, Vec<String>) {
    let name = path.map_or_else(|| "page".to_owned(), |path| path.display().to_string());
    let options = Options { limits: limits.clone(), fresh: true, ..Options::default() };
    let file = SourceFile::new(name, text);
    let woven = match (kind, path) {
        (Container::Markdown, _) => {
            let pictures = path.map(|path| picture_prefix(path));
            weave_markdown(&file, &Options { pictures, ..options })
        }
        (Container::Notebook, _) => weave_notebook(&file, &options),
        (Container::Latex, Some(path)) => match put_beside(path, &file, &options) {
            // The document stays as it is.
            Ok((woven, _)) => Woven { text: text.to_owned(), ..woven },
            Err(problem) => return (None, vec![problem.message]),
        },
        (Container::Latex, None) => {
            return (None, vec!["save the document first: its results go to a file beside it".to_owned()]);
        }
        (Container::Rst, _) => {
            return (None, vec!["results are not written into reStructuredText".to_owned()]);
        }
    };
    let wrong = woven.problems.iter().filter(|failure| failure.problem.severity == Severity::Error);
    let mut problems: Vec<String> = wrong
        .map(|failure| {
            let line = failure.problem.span.map_or(1, |span| failure.file.line(span.start));
            format!("line {line}: {}", failure.problem.message)
        })
        .collect();
    if let Some(folder) = path.and_then(|path| path.parent()) {
        problems.extend(woven.pictures.iter().filter_map(|(name, svg)| picture(folder, name, svg).err()));
    }
    (changed(text, &woven.text, places), problems)
}

fn picture(folder: &Path, name: &str, svg: &str) -> Result<(), String> {
    put_picture(folder, name, svg).map_err(|problem| problem.message)
}

/// The smallest edit that makes one text of another.
fn changed(old: &str, new: &str, places: &Places) -> Option<TextEdit> {
    let alike = |pairs: &mut dyn Iterator<Item = (char, char)>| {
        pairs.take_while(|(a, b)| a == b).map(|(a, _)| a.len_utf8()).sum::<usize>()
    };
    let start = alike(&mut old.chars().zip(new.chars()));
    let (rest, other) = (&old[start..], &new[start..]);
    let end = alike(&mut rest.chars().rev().zip(other.chars().rev()));
    (old != new).then(|| {
        let range = places.range(old, Span::new(start, old.len() - end));
        TextEdit::new(range, other[..other.len() - end].to_owned())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queries_are_seen() {
        for page in ["{{ 1 + 1 }}", "$a = {{ 1 }}$", "```polarform\n1\n```", "$2$<!-- {{ 1 + 1 }} -->"] {
            assert!(has_queries(page, Container::Markdown), "{page}");
        }
        let notebook =
            |cell: &str| format!(r#"{{"cells": [{{"cell_type": "markdown", "source": ["{cell}"]}}]}}"#);
        assert!(has_queries(&notebook("$a = {{ 1 }}$"), Container::Notebook));
        assert!(!has_queries(&notebook("$a = 1$"), Container::Notebook));
        assert!(has_queries("$a = \\polarform{1}$", Container::Latex));
        assert!(has_queries("\\begin{polarform}\n1\n\\end{polarform}", Container::Latex));
        assert!(!has_queries("$a = 1$ % \\polarform{1}", Container::Latex));
        for page in ["", "$a = 1$", "`{{ 1 }}`", "```python\n{{ 1 }}\n```", "<!-- {a} -->"] {
            assert!(!has_queries(page, Container::Markdown), "{page}");
        }
    }

    #[test]
    fn the_smallest_edit() {
        let (old, new) = ("设 a 𝒇b\n", "设 a 𝒈𝒇b\n");
        let edit = changed(old, new, &Places::new(old)).expect("it changes");
        assert_eq!((edit.new_text.as_str(), edit.range.start), ("𝒈", edit.range.end));
        assert_eq!(changed(old, old, &Places::new(old)), None);
        let edit = changed("aaa", "aa", &Places::new("aaa")).expect("it changes");
        assert_eq!((edit.new_text.as_str(), edit.range.end.character - edit.range.start.character), ("", 1));
    }
}
