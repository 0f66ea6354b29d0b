//! What holds of any text.

use proptest::prelude::*;

use super::*;
use crate::document::Style;
use crate::formula::source::Span;

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_taken_apart(text in "\\PC{0,60}") {
        check(&text)?;
    }

    #[test]
    fn any_sequence_of_signs_is_taken_apart(pieces in prop::collection::vec(piece(), 0..40)) {
        check(&pieces.concat())?;
        // The same in a cell of a notebook.
        let cell = serde_json::Value::from(pieces.concat());
        check(&format!("{{\"cells\": [{{\"cell_type\": \"markdown\", \"source\": {cell}}}]}}"))?;
    }

    /// Two formulas in sentences are found, whatever surrounds the paragraph.
    #[test]
    fn formulas_are_found_in_their_places(
        marks in prop::collection::vec(prop::sample::select(vec!["> ", "- ", "1. "]), 0..4),
        first in formula(),
        second in formula(),
    ) {
        let marks = marks.concat();
        let text = format!("{marks}so ${first}$ and $${second}$$ hold\n");
        let notes = markdown(&text);
        prop_assert_eq!(&notes.problems, &[]);
        let all = formulas(&notes);
        prop_assert_eq!(all.len(), 2, "{:?}", shown(&notes));
        for (formula, wanted) in all.iter().zip([&first, &second]) {
            prop_assert_eq!(&formula.text, wanted.trim());
            prop_assert_eq!(notes.file.slice(formula.span), wanted.trim());
        }
    }
}

fn formula() -> impl Strategy<Value = String> {
    let part = prop::sample::select(vec![
        "a",
        "_1",
        "^{2}",
        "=",
        "\\frac{1}{2}",
        "<b>",
        "*",
        "`",
        "|",
        "\\$",
        "[x](y)",
        " ",
    ]);
    prop::collection::vec(part, 0..6).prop_map(|parts| format!("t{}", parts.concat()))
}

fn piece() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "$",
        "$",
        "$$",
        "$$",
        "\n",
        "\n",
        "\n\n",
        "> ",
        "- ",
        "1. ",
        "  ",
        "    ",
        "\t",
        "```",
        "```math\n",
        "```{math}\n",
        "```{note}\n",
        ":::{math}\n",
        ":label: x\n",
        "---\n",
        "!!! note\n",
        "{math}`",
        ":math:`",
        "``",
        ".. math::\n",
        ".. note:: ",
        ".. [1] ",
        "::\n",
        "====\n",
        "| ",
        "[^1]: ",
        "\\frac",
        "`",
        "# ",
        "---\n",
        "===\n",
        "|",
        "|---|\n",
        "<!--",
        "-->",
        "<!-- polarform: x := 1 -->",
        "<b>",
        "<code>",
        "</code>",
        "[",
        "](",
        ")",
        "(",
        "\\(",
        "\\)",
        "\\[",
        "\\]",
        "\\",
        "\\\\",
        "{",
        "}",
        "%",
        "% polarform: y",
        "\\begin{align}",
        "\\end{align}",
        "\\begin{theorem}",
        "\\end{theorem}",
        "\\begin{itemize}",
        "\\end{itemize}",
        "\\item ",
        "\\begin{document}",
        "\\end{document}",
        "\\begin{tabular}{l}",
        "\\end{tabular}",
        "\\newcommand{\\x}[1]{a#1}",
        "\\def\\y{\\y\\x}",
        "\\x",
        "\\y",
        "\\be",
        "\\def\\be{\\begin{align}}",
        "\\section{",
        "\\verb|",
        "\\input{x}",
        "\\text{",
        "\\label{",
        ":::",
        "::: a\n",
        "F(t) = t",
        "a",
        "words and more",
        "极",
        "形式",
        "é",
        "²",
        "=",
        "+",
        "_",
        "^",
        "1",
        "*",
        "f(u, v) = ",
        "...",
        "http://a",
        "\r",
        "\r\n",
        "\u{feff}",
        "😀",
        "𝔼",
        "µ",
    ])
}

/// Every kind of file: spans lie in the text, in order, on the boundaries of characters.
fn check(text: &str) -> Result<(), TestCaseError> {
    for kind in [Container::Markdown, Container::Rst, Container::Latex, Container::Notebook] {
        let notes = document(SourceFile::new("x", text), kind);
        let inside = |span: Span| {
            let span_ok = span.start <= span.end && span.end <= text.len();
            span_ok && text.is_char_boundary(span.start) && text.is_char_boundary(span.end)
        };
        let mut last = 0;
        let mut open = Vec::new();
        for item in &notes.items {
            let span = match item {
                Item::Heading { span, .. } => *span,
                Item::Words(span) => {
                    prop_assert!(!notes.file.slice(*span).trim().is_empty());
                    *span
                }
                Item::Declaration { span, .. } => *span,
                Item::Formula(formula) => {
                    let len = formula.text.len();
                    prop_assert!(formula.text.chars().any(|c| !c.is_whitespace()));
                    for at in (0..len).filter(|&at| formula.text.is_char_boundary(at)) {
                        let end = formula.text[at..].chars().next().map_or(at, |c| at + c.len_utf8());
                        let place = formula.in_file(Span::new(at, end));
                        prop_assert!(inside(place), "{kind:?} {text:?} {formula:?} {place:?}");
                        prop_assert!(
                            place.start >= formula.span.start && place.end <= formula.span.end,
                            "{kind:?} {text:?} {formula:?} {place:?}"
                        );
                    }
                    if formula.style == Style::Plain && kind == Container::Markdown {
                        prop_assert_eq!(notes.file.slice(formula.span).len(), len);
                    }
                    formula.span
                }
                Item::Enter(what) => {
                    open.push(*what);
                    continue;
                }
                Item::Leave(what) => {
                    prop_assert_eq!(open.pop(), Some(*what));
                    continue;
                }
                Item::Title { .. } | Item::Break => continue,
            };
            prop_assert!(inside(span), "{kind:?} {text:?} {item:?}");
            prop_assert!(span.start >= last, "{kind:?} {text:?}: {:?}", notes.items);
            // The formulas of a heading stand within it.
            last = if matches!(item, Item::Heading { .. }) { span.start } else { span.end };
        }
        prop_assert!(open.is_empty());
        for problem in &notes.problems {
            let span = problem.span.unwrap_or_default();
            prop_assert!(inside(span) && !problem.hints.is_empty(), "{kind:?} {text:?} {problem:?}");
        }
    }
    Ok(())
}
