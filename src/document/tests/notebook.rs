//! Jupyter notebooks.

use super::*;
use crate::formula::source::Span;

fn notebook(text: &str) -> Document {
    document(SourceFile::new("notes.ipynb", text), Container::Notebook)
}

#[test]
fn cells_and_places() {
    let text = r##"{"cells": [
 {"cell_type": "code", "source": ["x = '$no$'"]},
 {"cell_type": "markdown", "source": [
   "# A \u00e9 \"b\"\n",
   "so $\\alpha = 1$ and\n",
   "$$\n",
   "a \\\\ b\n",
   "$$"]},
 {"cell_type": "raw", "source": "$no$"},
 {"source": "> F(t) = 2t, $\ud835\udd3c x$", "cell_type": "markdown"}
], "nbformat": 4}"##;
    let notes = notebook(text);
    assert_eq!(notes.problems, []);
    assert_eq!(
        shown(&notes),
        [
            "h1 4:7 A \\u00e9 \\\"b\\\"",
            "break",
            "w 5:5 so",
            "Inline 5:9 \\alpha = 1",
            "w 5:22 and",
            "Display 7:5 a \\\\ b",
            "break",
            "enter quotation",
            "Plain 10:16 F(t) = 2t",
            "w 10:25 ,",
            "Inline 10:28 𝔼 x",
            "break",
            "leave quotation",
        ]
    );
    let all = formulas(&notes);
    let slice = |formula: &Formula, from: usize, to: usize| {
        notes.file.slice(formula.in_file(Span::new(from, to))).to_owned()
    };
    assert_eq!(notes.file.slice(all[0].span), r"\\alpha = 1");
    assert_eq!(slice(all[0], 0, 6), r"\\alpha");
    assert_eq!(slice(all[0], 9, 10), "1");
    assert_eq!(slice(all[1], 2, 4), r"\\\\");
    assert_eq!(slice(all[1], 5, 6), "b");
    assert_eq!(slice(all[3], 0, 4), r"\ud835\udd3c");
    assert_eq!(slice(all[3], 5, 6), "x");
}

#[test]
fn macros_of_other_cells() {
    let notes = notebook(
        r#"{"cells": [{"cell_type": "markdown", "source": "$\\newcommand{\\B}[1]{b_{#1}}$"},
{"cell_type": "markdown", "source": "$\\B{k} = c$"}]}"#,
    );
    let formula = formulas(&notes)[0];
    assert_eq!(formula.text, "b_{k} = c");
    assert_eq!(notes.file.slice(formula.in_file(Span::new(0, 1))), r"\\B{k}");
    assert_eq!(notes.file.slice(formula.in_file(Span::new(3, 4))), "k");
    assert_eq!(notes.file.slice(formula.in_file(Span::new(8, 9))), "c");
}

#[test]
fn format_three() {
    let notes = notebook(r#"{"worksheets": [{"cells": [{"cell_type": "markdown", "source": ["$a$"]}]}]}"#);
    assert_eq!(shown(&notes), ["Inline 1:67 a", "break"]);
}

#[test]
fn broken_notebooks() {
    for (text, place) in [
        ("", (1, 1)),
        ("{\"cells\": [\n {\"cell_type\"", (2, 13)),
        ("[]", (1, 1)),
        ("{}", (1, 1)),
        ("{\"cells\": 3}", (1, 11)),
        ("{\"cells\": [3]}", (1, 12)),
        ("{\"cells\": [{\"cell_type\": \"markdown\", \"source\": [3]}]}", (1, 49)),
    ] {
        let notes = notebook(text);
        let problem = &notes.problems[0];
        assert_eq!((problem.code, notes.problems.len()), (Code::BrokenNotebook, 1), "{text}");
        assert_eq!(notes.file.line_column(problem.span.unwrap().start), place, "{text}: {problem:?}");
    }
    // The other cells are still read.
    let notes = notebook(
        r#"{"cells": [{"cell_type": "markdown", "source": 3}, {"cell_type": "markdown", "source": "$a$"}]}"#,
    );
    assert_eq!((formulas(&notes).len(), notes.problems.len()), (1, 1));
    // A problem of a cell has its place in the file.
    let notes = notebook("{\"cells\": [{\"cell_type\": \"markdown\", \"source\": \"é \\n $a\"}]}");
    assert_eq!(notes.problems[0].code, Code::UnclosedFormula);
    assert_eq!(notes.file.line_column(notes.problems[0].span.unwrap().start), (1, 54));
}

#[test]
fn what_the_author_wrote() {
    let text = r#"{"cells": [{"cell_type": "markdown", "source": ["Sei \u00fc \"so\" $a \\\\\n",
 "= b$"]}]}"#;
    let notes = notebook(text);
    assert_eq!(notes.source(formulas(&notes)[0].span), "a \\\\\n= b");
    let Item::Words(words) = notes.items[0] else { unreachable!() };
    assert_eq!(notes.words(words).trim(), "Sei ü \"so\"");
}
