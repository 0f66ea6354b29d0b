//! LaTeX files.

use super::*;

fn latex(text: &str) -> Document {
    document(SourceFile::new("notes.tex", text), Container::Latex)
}

#[track_caller]
fn assert_latex(text: &str, wanted: &[&str]) {
    let notes = latex(text);
    assert!(notes.problems.is_empty(), "{:?}", notes.problems);
    assert_eq!(shown(&notes), wanted, "{text:?}");
}

fn texts(text: &str) -> Vec<String> {
    let notes = latex(text);
    assert!(notes.problems.is_empty(), "{text:?}: {:?}", notes.problems);
    formulas(&notes).into_iter().map(|formula| formula.text.clone()).collect()
}

#[test]
fn options_of_queries_without_their_bracket() {
    let text = "\\begin{document}\n\\begin{polarform}[\n\\end{polarform}\n$a]$ $b$\n\\end{document}\n";
    let notes = document(SourceFile::new("a.tex", text), Container::Latex);
    let all: Vec<&str> = formulas(&notes).iter().map(|formula| formula.text.as_str()).collect();
    assert_eq!(all, ["a]", "b"]);
}

#[test]
fn a_whole_file() {
    assert_latex(
        "\\documentclass{article}\n% polarform: n := 3\n\\newcommand{\\R}{\\mathbb{R}}\n$no$\n\\begin{document}\n\\section*{On $F$}\nLet $t\\in\\R$, % a remark $no$\nthen\n\\[ a = b \\]\n\nNext.\n\\end{document}\n$no$\n",
        &[
            "declaration 2:14 n := 3",
            "h3 6:11 On $F$",
            "Inline 6:15 F",
            "break",
            "w 7:1 Let",
            "Inline 7:6 t\\in\\mathbb{R}",
            "w 7:13 ,",
            "w 8:1 then",
            "Display 9:4 a = b",
            "break",
            "w 11:1 Next.",
            "break",
        ],
    );
}

#[test]
fn signs_and_environments() {
    for (text, wanted) in [
        ("$a$ \\(b\\) \\[c\\] $$d$$ $e$$f$ \\$5 \\%", vec!["a", "b", "c", "d", "e", "f"]),
        (
            "\\begin{equation}\\label{x}a\\tag{1}\\end{equation}",
            vec!["\\begin{equation}         a       \\end{equation}"],
        ),
        (
            "\\begin{align*}a &= b\\nonumber\\\\ &= c\\end{align*}",
            vec!["\\begin{align*}a &= b         \\\\ &= c\\end{align*}"],
        ),
        ("\\begin{dmath}a\\end{dmath}", vec!["a"]),
        ("\\begin{IEEEeqnarray*}{rCl}a &=& b\\end{IEEEeqnarray*}", vec!["a &=& b"]),
        (
            "\\begin{subequations}\\begin{gather}a\\end{gather}\\end{subequations}",
            vec!["\\begin{gather}a\\end{gather}"],
        ),
        ("$a % $ no\n+ b$", vec!["a       \n+ b"]),
        ("$\\text{if $x$} a$", vec!["\\text{if $x$} a"]),
        ("\\verb|$a$| \\verb+$+ $b$ \\lstinline{$c$} \\mintinline{tex}|$d$|", vec!["b"]),
        ("\\begin{verbatim}\n$a$ \\end{x}\n\\end{verbatim} $b$", vec!["b"]),
        ("\\begin{lstlisting}[x]\n$a$\n\\end{lstlisting}\\begin{comment}$b$\\end{comment}", vec![]),
        ("\\iffalse $a$ \\fi $b$", vec!["b"]),
        ("\\ensuremath{a_1} \\label{$x$} \\url{a$b$}", vec!["a_1"]),
        ("\\begin{align}\na\n%\n\\end{align}", vec!["\\begin{align}\na\n \n\\end{align}"]),
        (
            "\\begin{align}a\\intertext{and $x$ so}b\\end{align}",
            vec!["\\begin{align}a                      b\\end{align}"],
        ),
        ("F(u) = f(u, u)", vec![]),
    ] {
        assert_eq!(texts(text), wanted, "{text:?}");
    }
}

#[test]
fn theorems_lists_tables() {
    assert_latex(
        "\\newtheorem{satzx}{Satz}\n\\begin{theorem}[Name]\nSo $a$.\n\\end{theorem}\n\\begin{satzx}x\\end{satzx}\n\\begin{quote}q\\end{quote}\n",
        &[
            "enter environment",
            "title theorem -",
            "w 2:16 [Name]",
            "w 3:1 So",
            "Inline 3:5 a",
            "w 3:7 .",
            "break",
            "leave environment",
            "enter environment",
            "title Satz -",
            "w 5:14 x",
            "break",
            "leave environment",
            "enter quotation",
            "w 6:14 q",
            "break",
            "leave quotation",
        ],
    );
    assert_latex(
        "\\begin{itemize}\n\\item one\n\\item $b$\n\\begin{enumerate}\\item c\\end{enumerate}\n\\end{itemize}",
        &[
            "enter item",
            "w 2:7 one",
            "break",
            "leave item",
            "enter item",
            "Inline 3:8 b",
            "break",
            "enter item",
            "w 4:24 c",
            "break",
            "leave item",
            "leave item",
        ],
    );
    assert_latex(
        "\\begin{tabular}{ll}\\hline\na & $b$ \\\\\nc \\\\ \\hline\n\\end{tabular}",
        &[
            "enter row",
            "w 2:1 a &",
            "Inline 2:6 b",
            "break",
            "leave row",
            "enter row",
            "w 3:1 c",
            "break",
            "leave row",
        ],
    );
}

#[test]
fn macros() {
    for (text, wanted) in [
        ("\\newcommand{\\B}[2]{B_{#1}^{#2}} $\\B in(t)$", vec!["B_{i}^{n}(t)"]),
        (
            "\\def\\be{\\begin{equation}}\\def\\ee{\\end{equation}} \\be a \\ee $b$",
            vec!["\\begin{equation} a \\end{equation}", "b"],
        ),
        ("\\newcommand{\\x}{1} $\\x$ \\renewcommand{\\x}{2} $\\x$", vec!["1", "2"]),
        ("\\newcommand{\\x}{$y$} \\x $z$", vec!["z"]),
    ] {
        assert_eq!(texts(text), wanted, "{text:?}");
    }
    let notes = latex("\\newcommand{\\p}[1]{\\mathbf{p}_{#1}}\n$a = \\p{12}$");
    let formula = formulas(&notes)[0];
    let at = |part: &str| {
        let start = formula.text.find(part).unwrap();
        let span = formula.in_file(crate::formula::source::Span::new(start, start + part.len()));
        (notes.file.line_column(span.start), notes.file.slice(span))
    };
    assert_eq!(at("\\mathbf"), ((2, 6), "\\p{12}"));
    assert_eq!(at("12"), ((2, 9), "12"));
    assert_eq!(formula.text, "a = \\mathbf{p}_{12}");
}

#[test]
fn slips_in_latex() {
    for (text, code, place, wanted) in [
        ("$a\n\nb $c$", Code::UnclosedFormula, (1, 1), vec!["c"]),
        ("x \\[ a\n\n$c$", Code::UnclosedFormula, (1, 3), vec!["c"]),
        ("\\begin{align} a\n\n$c$", Code::UnclosedFormula, (1, 1), vec!["c"]),
        ("\\begin{theorem} $c$", Code::UnclosedBlock, (1, 1), vec!["c"]),
        ("\\begin{theorem}\\begin{quote}$c$\\end{theorem}", Code::UnclosedBlock, (1, 16), vec!["c"]),
        ("\\end{theorem}$c$", Code::UnclosedBlock, (1, 1), vec!["c"]),
        ("\\begin{verbatim}$c$", Code::UnclosedBlock, (1, 1), vec!["c"]),
        ("\\newcommand{\\x}{ $c$", Code::HalfDefinition, (1, 1), vec!["c"]),
        ("\\def\\x{\\x\\x}\n$c + \\x$", Code::MacroTooLarge, (2, 6), vec!["c + \\x"]),
    ] {
        let notes = latex(text);
        let found: Vec<_> = formulas(&notes).into_iter().map(|formula| formula.text.as_str()).collect();
        assert_eq!(found, wanted, "{text:?}");
        assert_eq!(notes.problems.len(), 1, "{text:?}: {:?}", notes.problems);
        let problem = &notes.problems[0];
        assert_eq!(problem.code, code, "{text:?}");
        assert_eq!(notes.file.line_column(problem.span.unwrap().start), place, "{text:?}");
        assert!(!problem.hints.is_empty());
    }
}

#[test]
fn macros_in_markdown() {
    let notes = markdown("$\\newcommand{\\B}{\\mathbf{b}}$\n\nso $\\B_0$ and\n\n> $$\n> \\B\n> + 1\n> $$\n");
    let found: Vec<_> = formulas(&notes).into_iter().map(|formula| formula.text.as_str()).collect();
    assert_eq!(found, ["\\mathbf{b}_0", "\\mathbf{b}\n  + 1"]);
    let place = formulas(&notes)[1].in_file(crate::formula::source::Span::new(15, 16));
    assert_eq!(notes.file.slice(place), "1");
}

#[test]
fn algorithms_in_words_and_programs() {
    let text = |inner: &str| {
        let notes = latex(&format!(
            "\\begin{{document}}\n\\begin{{algorithm}}\n{inner}\n\\end{{algorithm}}\n\\end{{document}}\n"
        ));
        let texts: Vec<String> = formulas(&notes).into_iter().map(|formula| formula.text.clone()).collect();
        (texts.join("; "), notes.problems.len())
    };
    assert_eq!(text("Start with $r = 0$."), ("r = 0".to_owned(), 0));
    let steps = r"\caption{For $n$} \begin{algorithmic} \State $r = r + 1$ \end{algorithmic}";
    assert_eq!(text(steps), ("n".to_owned(), 1));
    assert_eq!(text(r"\KwIn{$n$} \For{$r$}{$r = r + 1$\;}"), (String::new(), 1));
}
