//! The blocks of MyST and reStructuredText that have a name: what their content is.
//!
//! Reference: the directives of Docutils, Sphinx, MyST and sphinx-proof. One that is not listed here may hold
//! anything, such as a program; its formulas are not read, and that is told.

use super::collect::Collector;
use super::vocabulary::THEOREMS;
use crate::formula::source::Span;

/// What the content of a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    Formula,
    /// Text with formulas, in the language of the page.
    Prose,
    Rst,
    /// A program, data, a picture.
    Code,
    /// A directive that is not known.
    Unknown,
}

/// Directives whose content is text.
const PROSE: &[&str] = &[
    "admonition",
    "aside",
    "attention",
    "blockquote",
    "card",
    "caution",
    "centered",
    "class",
    "compound",
    "container",
    "csv-table",
    "danger",
    "definition",
    "deprecated",
    "details",
    "div",
    "dropdown",
    "epigraph",
    "error",
    "figure",
    "footer",
    "full-width",
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
    "margin",
    "note",
    "only",
    "panels",
    "pull-quote",
    "question",
    "quote",
    "rst-class",
    "rubric",
    "seealso",
    "sidebar",
    "solution-start",
    "exercise-start",
    "tab",
    "tab-item",
    "tab-set",
    "table",
    "tabbed",
    "tabs",
    "tip",
    "todo",
    "topic",
    "versionadded",
    "versionchanged",
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
    "include",
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
    let line = |at: usize| text[lines[at].range()].trim();
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
            ("{prf:theorem} Of Bernstein", Content::Prose),
            ("{eval-rst}", Content::Rst),
            ("{code-cell} python", Content::Code),
            ("{.python .numbered}", Content::Code),
            ("{r, echo=FALSE}", Content::Code),
            ("{=latex}", Content::Code),
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
