//! Formulas as the dialects of Markdown write them.

use super::*;

#[test]
fn myst() {
    let text = "See {math}`a = b` and {eq}`my_eq`, {ref}`x <y>`.\n\n```{math}\n:label: eq:a\n\nc = d\n```\n\n\
                :::{math}\ne = f\n:::\n\n```{math} g = h\n```\n\n$$i = j$$ (eq:last)\n";
    assert_eq!(texts(text), ["a = b", "c = d", "e = f", "g = h", "i = j"]);
    let words = shown(&markdown(text));
    assert!(!words.iter().any(|item| item.contains("label") || item.contains("eq:last")), "{words:?}");
}

#[test]
fn directives_of_myst_hold_markdown() {
    let text = "````{prf:theorem} On $n$\n:label: thm\n\nLet $a$ be.\n\n```{note}\n- $b$\n\n  ```python\n  $x$\n  ```\n```\n$c$\n````\n\
                $d$\n\n:::{admonition} Title\n:class: tip\n$e$\n:::\n\n```{note}\n---\nname: x\n---\n$f$\n```\n";
    let notes = markdown(text);
    assert!(notes.problems.is_empty(), "{:?}", notes.problems);
    let all: Vec<&str> = formulas(&notes).iter().map(|formula| formula.text.as_str()).collect();
    assert_eq!(all, ["n", "a", "b", "c", "d", "e", "f"]);
    let marks: Vec<String> = shown(&notes).into_iter().filter(|item| item.contains("environment")).collect();
    assert_eq!(
        marks.join(", "),
        [
            "enter environment, enter environment, leave environment, leave environment",
            "enter environment, leave environment",
            "enter environment, leave environment"
        ]
        .join(", ")
    );
}

#[test]
fn a_directive_without_end() {
    let notes = markdown("```{note}\n$a$\n\n$b$\n");
    assert_eq!(formulas(&notes).len(), 2);
    assert_eq!(notes.problems.len(), 1);
    assert_eq!(notes.problems[0].code, Code::UnclosedBlock);
}

#[test]
fn restructured_text_in_myst() {
    let text = "```{eval-rst}\n.. math::\n   :label: x\n\n   a = b\n\nSee :math:`c`.\n```\n$d$\n";
    assert_eq!(texts(text), ["a = b", "c", "d"]);
}

#[test]
fn manuals_of_julia() {
    let text = "Knots ``t_i \\le t_{i+1}`` and `code`, ``n``, see [x](@ref).\n\n```math\na = b\n```\n\n\
                !!! note \"On ``m``\"\n    Here $c = d$ and\n\n    ```math\n    e = f\n    ```\n\nnot ```` ``x`` ````\n";
    assert_eq!(texts(text), [r"t_i \le t_{i+1}", "n", "a = b", "m", "c = d", "e = f"]);
    // Elsewhere two backquotes are as good as one.
    assert_eq!(texts("``a``, `b`, ``x `y` z``\n"), [""; 0]);
}

#[test]
fn gitlab_and_github() {
    assert_eq!(texts("so $`a = b`$ and $`c\n= d`$\n\n```math\ne\n```\n"), ["a = b", "c\n= d", "e"]);
}

#[test]
fn kramdown_and_quarto() {
    let text = "so $$a = b$$ holds\n\n$$\nc\n$$ {#eq-c}\n\n::: {.callout-note}\n$d$\n:::\n\n```{r}\nx$y <- 1\n```\n\n\
                Term\n:   means $e$\n\n    and $f$\n\n[^1]: A note $g$\n\n    with $h$\n";
    assert_eq!(texts(text), ["a = b", "c", "d", "e", "f", "g", "h"]);
    assert!(!shown(&markdown(text)).iter().any(|item| item.contains("eq-c")));
}

#[test]
fn between_dollars_stands_a_formula() {
    let formula = "f(r,s,t) = rst + rs + st + rt";
    assert_eq!(texts(&format!("Let ${formula}$ be given.\n")), [formula]);
    let notes = markdown("costs 5$ and so on, or else we pay more, $a$\n");
    assert_eq!(formulas(&notes).len(), 1);
}

#[test]
fn what_looks_like_a_formula_is_counted() {
    for text in [
        "so \\frac12 is\n",
        "[ x = \\sum_i a_i ]\n",
        "```{mystery}\nsee {math}`a`\n```\n",
        "![x](https://latex.codecogs.com/svg.latex?%5Cfrac12)\n",
        "a <math><mi>x</mi></math> b\n",
    ] {
        let notes = markdown(text);
        assert_eq!(formulas(&notes).len(), 0, "{text}");
        let codes: Vec<Code> = notes.problems.iter().map(|problem| problem.code).collect();
        assert_eq!(codes, [Code::UnseenFormula], "{text}");
    }
    for text in ["C:\\frac_dir is\n".replace("frac_", "temp"), "\\newpage, \\\\alpha\n".to_owned()] {
        assert!(markdown(&text).problems.is_empty(), "{text}");
    }
}

#[test]
fn programs_and_comments_hold_no_formulas() {
    for (open, close) in [
        ("<script>", "</script>"),
        ("<style media='a'>", "</style>"),
        ("<pre>", "</pre>"),
        ("<TEXTAREA>", "</textarea>"),
        ("<!--", "-->"),
        ("<?php", "?>"),
        ("{% highlight js %}", "{% endhighlight %}"),
    ] {
        let text = format!("{open}\n\n# $a$\n| $b$ |\n|---|\n| $c$ |\n\n- $d$\n{close} then $e$\n\n$f$\n");
        assert_eq!(texts(&text), ["e", "f"], "{text}");
        let notes = markdown(&format!("> {open}\n> $a$\n\nb $c$\n"));
        assert_eq!(formulas(&notes).len(), 2, "{open}");
        assert_eq!(notes.problems.len(), 1, "{open}");
    }
    assert_eq!(texts("<div>\n\n$a$\n\n</div>\n\n<prefix> $b$\n"), ["a", "b"]);
    // Rows of a table go on after a comment.
    assert_eq!(texts("| a |\n|---|\n| $b$ |\n<!-- $x$\n\n$y$ -->\n| $c$ |\n"), ["b", "c"]);
}

#[test]
fn formulas_in_code_spans() {
    // Where some stand outside, a page shows how to write them.
    let notes = markdown("Write `$x^2$` or `$$a_i$$`, so $b$; `$HOME`, `$5`, `a$b`.\n");
    assert_eq!((formulas(&notes).len(), notes.problems.len()), (1, 0));
    let notes = markdown("So `$x^2 = 1$` and `$$a_i$$` and `$b$`; `$HOME`, `$5`, `a$b`.\n");
    assert_eq!((formulas(&notes).len(), notes.problems.len()), (0, 2));
    // Else all of them are formulas.
    let text =
        "For `$x > 0$` [see][book$12] the `$$\\Gamma(x+1) = x$$` and [more][book$14]: `$n,$` `code`.\n";
    assert_eq!(texts(text), ["x > 0", "\\Gamma(x+1) = x", "n,"]);
}

#[test]
fn derivations_in_words_go_on_with_a_relation() {
    let text =
        "Here p(t) = t^2 + 1\n     = (t+1)^2 - 2t\n     = (t+1)^2 - 3t\nand\n\n> (1-t)^2\n> = 1 - 2t + t^2\n";
    let notes = markdown(text);
    let found: Vec<String> = formulas(&notes)
        .iter()
        .map(|formula| formula.text.split_whitespace().collect::<Vec<_>>().join(" "))
        .collect();
    assert_eq!(found, ["p(t) = t^2 + 1 = (t+1)^2 - 2t = (t+1)^2 - 3t", "(1-t)^2 = 1 - 2t + t^2"]);
    assert_eq!(notes.file.line_column(formulas(&notes)[0].places.byte(20)), (2, 6));
    // Words on the line above, and a line under a title.
    assert_eq!(texts("a word\n= b = c\n"), ["b = c"]);
    assert_eq!(texts("x = y\n=====\n"), [""; 0]);
    let long = format!("a\n{}", "= b c\n".repeat(50_000));
    assert!(formulas(&markdown(&long)).len() < 50_001);
}

#[test]
fn escaped_parentheses() {
    assert_eq!(texts("both \\\\(n-1\\\\) and \\(2 - k\\)\n"), ["n-1", "2 - k"]);
    assert_eq!(texts("\\(see 3-4\\) \\[a-z0-9\\] \\(well-known\\)\n"), [""; 0]);
}

/// Each formula in the table of formats is seen in a file of its format.
#[test]
fn the_formats_of_the_documentation() {
    let page = include_str!("../../../docs/notes.md");
    let table = page.split("## Formats").nth(1).and_then(|rest| rest.split("\n## ").next()).unwrap();
    let mut tried = 0;
    for row in table.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| ---")).skip(1) {
        let cells: Vec<&str> = row.split(" | ").collect();
        let ending = cells[1].split('`').nth(1).unwrap();
        let kind = Container::of(std::path::Path::new(&format!("a{ending}"))).unwrap();
        let code = if cells[2].contains("`` ") { "`` " } else { "`" };
        for (i, example) in cells[2].split(code.trim()).enumerate() {
            let example = example.trim();
            if i % 2 == 0 || !example.contains("a = b") || kind == Container::Notebook {
                continue;
            }
            let text = format!("So {example}\n");
            let notes = document(SourceFile::new("a", text.clone()), kind);
            assert_eq!(
                formulas(&notes).first().map(|formula| formula.text.as_str()),
                Some("a = b"),
                "{text}"
            );
            tried += 1;
        }
    }
    assert!(tried >= 7, "{tried}");
}
