//! The blocks of MyST and reStructuredText that have a name: what their content is.
//!
//! Reference: the directives of Docutils, Sphinx, MyST and sphinx-proof. One that is not listed here may hold
//! anything, such as a program; its formulas are not read, and that is told.

use super::collect::{Collector, Include};
use super::vocabulary::THEOREMS;
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// What the content of a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    Formula,
    /// Text with formulas, in the language of the page.
    Prose,
    Rst,
    /// A program, data, a picture.
    Code,
    /// Another file, whose name stands after that of the directive.
    Include,
    /// A directive that is not known.
    Unknown,
}

/// Directives whose content is text, also those with which Sphinx describes the parts of a program.
const PROSE: &[&str] = &[
    "admonition",
    "alias",
    "aside",
    "attention",
    "attribute",
    "blockquote",
    "card",
    "caution",
    "centered",
    "class",
    "classmethod",
    "cmdoption",
    "compound",
    "concept",
    "confval",
    "container",
    "csv-table",
    "danger",
    "data",
    "decorator",
    "definition",
    "deprecated",
    "describe",
    "details",
    "div",
    "dropdown",
    "enum",
    "enum-struct",
    "enumerator",
    "envvar",
    "epigraph",
    "error",
    "event",
    "exception",
    "exercise-start",
    "figure",
    "footer",
    "full-width",
    "function",
    "glossary",
    "grid",
    "grid-item",
    "grid-item-card",
    "header",
    "highlights",
    "hint",
    "hlist",
    "important",
    "legend",
    "line-block",
    "list-table",
    "macro",
    "margin",
    "member",
    "method",
    "module",
    "namespace",
    "note",
    "object",
    "only",
    "option",
    "panels",
    "program",
    "property",
    "pull-quote",
    "question",
    "quote",
    "rst-class",
    "rubric",
    "seealso",
    "sidebar",
    "solution-start",
    "staticmethod",
    "struct",
    "tab",
    "tab-item",
    "tab-set",
    "tabbed",
    "table",
    "tabs",
    "tip",
    "todo",
    "topic",
    "type",
    "union",
    "var",
    "versionadded",
    "versionchanged",
    "versionremoved",
    "warning",
];

/// Families of directives whose content is text: theorems, and what Sphinx describes.
const DOMAINS: &[&str] = &["prf", "proof", "py", "c", "cpp", "js", "rst", "std", "mat", "f"];

/// Directives whose content holds no formulas.
const CODE: &[&str] = &[
    "bibliography",
    "code",
    "code-block",
    "code-cell",
    "contents",
    "doctest",
    "graphviz",
    "highlight",
    "image",
    "index",
    "literalinclude",
    "mermaid",
    "meta",
    "parsed-literal",
    "plot",
    "raw",
    "sourcecode",
    "tableofcontents",
    "testcode",
    "toctree",
];

/// What a fence holds, by what is said of it: `math`, `{math}`, `{note} Title`, `python`.
pub(super) fn content(info: &str) -> Content {
    if info == "math" {
        return Content::Formula;
    }
    // Blocks of pandoc that go into LaTeX as they are
    if matches!(info, "{=latex}" | "{=tex}") {
        return Content::Prose;
    }
    match info.strip_prefix('{').and_then(|rest| rest.split_once('}')) {
        Some((name, _)) => named(name),
        None => Content::Code,
    }
}

/// What the directive of this name holds.
pub(super) fn named(name: &str) -> Content {
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | ':');
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) || !name.chars().all(plain) {
        return Content::Code;
    }
    let name = name.to_ascii_lowercase();
    let (domain, own) = name.rsplit_once(':').map_or(("", name.as_str()), |(domain, own)| (domain, own));
    match own {
        "math" if domain.is_empty() => Content::Formula,
        "eval-rst" => Content::Rst,
        "include" => Content::Include,
        _ if DOMAINS.contains(&domain) || PROSE.contains(&own) || THEOREMS.contains(&own) => Content::Prose,
        _ if CODE.contains(&own) => Content::Code,
        _ => Content::Unknown,
    }
}

/// Whether the text of a directive begins right after its name; else a title, a path or a signature stands there.
pub(super) fn begins_at_once(name: &str) -> bool {
    const NOTES: &[&str] = &[
        "attention",
        "caution",
        "danger",
        "error",
        "hint",
        "important",
        "note",
        "seealso",
        "tip",
        "todo",
        "warning",
    ];
    NOTES.contains(&name)
}

/// Whether a line is an option of a directive: `:label: eq`.
pub(super) fn is_option(line: &str) -> bool {
    let Some((name, rest)) = line.trim().strip_prefix(':').and_then(|line| line.split_once(':')) else {
        return false;
    };
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_');
    !name.is_empty() && name.chars().all(plain) && (rest.is_empty() || rest.starts_with(' '))
}

/// The lines of a directive without the options before them.
pub(super) fn without_options<'a>(text: &str, lines: &'a [Span]) -> &'a [Span] {
    let line = |at: usize| text.piece(lines[at].range()).trim();
    let mut first = 0;
    if !lines.is_empty() && line(0) == "---" {
        first = (1..lines.len()).find(|&at| line(at) == "---").map_or(0, |at| at + 1);
    }
    while first < lines.len() && (line(first).is_empty() || is_option(line(first))) {
        first += 1;
    }
    let last = (first..lines.len()).rev().find(|&at| !line(at).is_empty()).map_or(first, |at| at + 1);
    &lines[first..last]
}

/// Notes the file that a directive includes, with the options of the directive. One that is shown as it is typed
/// is no part of the page; one of which only a part is included is not read, and that is told.
pub(super) fn included<'a>(
    name: &str,
    options: impl Iterator<Item = &'a str>,
    place: Span,
    out: &mut Collector,
) {
    let name = name.trim().trim_matches(['"', '\'']);
    let options: Vec<&str> =
        options.filter_map(|line| line.trim().strip_prefix(':')?.split(':').next()).collect();
    let has = |names: &[&str]| names.iter().any(|name| options.contains(name));
    if name.is_empty() || has(&["literal", "code", "lang", "number-lines"]) {
        return;
    }
    let part =
        ["start-line", "end-line", "start-after", "end-before", "start-at", "end-at", "lines", "filter"];
    if has(&part) {
        return out.problem(partly(name, place));
    }
    out.includes.push(Include { name: name.to_owned(), place });
}

/// A part of a file that is included.
fn partly(name: &str, place: Span) -> Diagnostic {
    Diagnostic::warning(Code::Include, format!("only a part of {name} is included; it was not read"))
        .at(place)
        .hint("check that file by itself")
}

/// The file that Quarto or mdBook include in a line: `{{< include a.qmd >}}`, `{{#include a.md}}`; how many bytes
/// that takes.
pub(super) fn shortcode(rest: &str, at: usize, out: &mut Collector) -> Option<usize> {
    let (open, close) = if rest.starts_with("{{<") { ("{{<", ">}}") } else { ("{{", "}}") };
    let line = rest.strip_prefix(open)?.lines().next()?;
    let inner = line.piece(..line.find(close)?);
    let sign = if open == "{{<" { "include" } else { "#include" };
    let name = inner.trim().strip_prefix(sign).filter(|name| name.starts_with(' '))?;
    let len = open.len() + inner.len() + close.len();
    let place = Span::new(at, at + len);
    match name.trim().split_once(':') {
        Some((file, _)) if open == "{{" => out.problem(partly(file, place)),
        _ => included(name, std::iter::empty(), place, out),
    }
    Some(len)
}

/// Tells of formulas in the content of a directive that is not read.
pub(super) fn count_unseen(lines: &[&str], place: Span, out: &mut Collector) {
    let mark = |line: &&&str| {
        ["{math}", ":math:", ".. math::", r"\begin{equation", r"\begin{align"]
            .iter()
            .any(|mark| line.contains(mark))
    };
    if lines.iter().any(|line| mark(&line)) {
        out.unseen(place, "the content of this directive was not read, and formulas stand in it");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_directives_hold() {
        for (info, wanted) in [
            ("math", Content::Formula),
            ("{math}", Content::Formula),
            ("{math} a = b", Content::Formula),
            ("{note}", Content::Prose),
            ("{function} double value(double x)", Content::Prose),
            ("{prf:theorem} Of Bernstein", Content::Prose),
            ("{eval-rst}", Content::Rst),
            ("{code-cell} python", Content::Code),
            ("{.python .numbered}", Content::Code),
            ("{r, echo=FALSE}", Content::Code),
            ("{=latex}", Content::Prose),
            ("{=html}", Content::Code),
            ("{include} a.md", Content::Include),
            ("{r}", Content::Unknown),
            ("python", Content::Code),
            ("mathematica", Content::Code),
            ("", Content::Code),
        ] {
            assert_eq!(content(info), wanted, "{info}");
        }
    }

    #[test]
    fn options_are_lines_between_colons() {
        assert!(is_option("  :label: eq") && is_option(":nowrap:") && is_option(":no-index: x"));
        for line in ["label: eq", "::", ":math:`x`", ": x: y", "a :b: c"] {
            assert!(!is_option(line), "{line}");
        }
    }
}
