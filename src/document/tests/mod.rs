mod dialects;
#[cfg(feature = "files")]
mod files;
mod latex;
mod notebook;
mod oracle;
mod properties;
mod rst;

use super::*;
use crate::document::{Enclosure, Formula, Item};
use crate::language::diagnostic::Code;

/// The items in short: `line:column text` of formulas, the text of the rest.
fn shown(notes: &Document) -> Vec<String> {
    let place = |span: crate::formula::source::Span| {
        let (line, column) = notes.file.line_column(span.start);
        format!("{line}:{column}")
    };
    let mark = |what: &Enclosure| match what {
        Enclosure::Quotation => "quotation",
        Enclosure::Item => "item",
        Enclosure::Row => "row",
        Enclosure::Environment => "environment",
    };
    notes
        .items
        .iter()
        .map(|item| match item {
            Item::Heading { level, span } => format!("h{level} {} {}", place(*span), notes.file.slice(*span)),
            Item::Words(span) => format!("w {} {}", place(*span), notes.file.slice(*span)),
            Item::Break => "break".to_owned(),
            Item::Formula(formula) => format!("{:?} {} {}", formula.style, place(formula.span), formula.text),
            Item::Declaration { text, span, block } => {
                let what = if *block { "queries" } else { "declaration" };
                format!("{what} {} {text}", place(*span))
            }
            Item::Enter(what) => format!("enter {}", mark(what)),
            Item::Leave(what) => format!("leave {}", mark(what)),
            Item::Title { kind, label } => format!("title {kind} {}", label.as_deref().unwrap_or("-")),
        })
        .collect()
}

fn markdown(text: &str) -> Document {
    document(SourceFile::new("notes.md", text), Container::Markdown)
}

fn formulas(notes: &Document) -> Vec<&Formula> {
    notes
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Formula(formula) => Some(formula),
            _ => None,
        })
        .collect()
}

/// The formulas of a Markdown text, without problems.
fn texts(text: &str) -> Vec<String> {
    let notes = markdown(text);
    assert!(notes.problems.is_empty(), "{text:?}: {:?}", notes.problems);
    formulas(&notes).into_iter().map(|formula| formula.text.clone()).collect()
}

#[track_caller]
fn assert_shown(text: &str, wanted: &[&str]) {
    let notes = markdown(text);
    assert!(notes.problems.is_empty(), "{:?}", notes.problems);
    assert_eq!(shown(&notes), wanted, "{text:?}");
}

#[test]
fn words_and_formulas() {
    assert_shown(
        "# On $F$ ##\n\nLet $F(t) = t^2$,\nand *so*\n$$ a $$ on.\n",
        &[
            "h1 1:3 On $F$",
            "Inline 1:7 F",
            "break",
            "w 3:1 Let",
            "Inline 3:6 F(t) = t^2",
            "w 3:17 ,",
            "w 4:1 and *so*",
            "Display 5:4 a",
            "w 5:9 on.",
            "break",
        ],
    );
    assert_shown("A\n=\n\nB\n---\n", &["h1 1:1 A", "break", "h2 4:1 B", "break"]);
}

#[test]
fn displays() {
    // Blank lines, lines that look like blocks, signs in the middle of lines.
    for (text, wanted) in [
        ("$$\na\n\n= b\n$$\n", vec!["a\n\n= b"]),
        ("$$a\n= b$$\n\n$c$\n", vec!["a\n= b", "c"]),
        ("则\n$$\n- a\n+ b\n=\n1. c\n$$\n", vec!["- a\n+ b\n=\n1. c"]),
        ("$$a$$ by $b$ and $$c$$\n", vec!["a", "b", "c"]),
        ("$$\na\n$$ (1)\n", vec!["a"]),
        ("    $$\n    a\n    $$\n", vec!["a"]),
        ("$$ \\text{for $n$ and $m$} = 1 $$", vec!["\\text{for $n$ and $m$} = 1"]),
        ("$$ a \\\\$$ $b$", vec!["a \\\\", "b"]),
        ("```math\na\nb\n```\n", vec!["a\nb"]),
        ("\\[ a = b \\]\n\\(c\\) and \\[1\\] \\(see there\\)", vec!["a = b", "c"]),
        ("\\\\[\na = b\n\\\\] and \\\\(c\\\\)\n", vec!["a = b", "c"]),
        ("\\begin{align*}\na &= b\n\\end{align*}\n", vec!["\\begin{align*}\na &= b\n\\end{align*}"]),
        ("$$$$ $x$", vec!["x"]),
        ("$`a_1`$ and $b$", vec!["a_1", "b"]),
        ("$a$$b$", vec!["a", "b"]),
        ("$x_1 +\nx_2$", vec!["x_1 +\nx_2"]),
    ] {
        assert_eq!(texts(text), wanted, "{text:?}");
    }
}

#[test]
fn quotations_and_items() {
    assert_shown(
        "> so\n> $$\n> a > b\n> \n> > 0\n> $$\nlazy $c$\n\nout\n",
        &[
            "enter quotation",
            "w 1:3 so",
            "Display 3:3 a > b\n  \n  > 0",
            "w 7:1 lazy",
            "Inline 7:7 c",
            "break",
            "leave quotation",
            "w 9:1 out",
            "break",
        ],
    );
    assert_shown(
        "1. one\n\n   $$\n   x\n   y\n   $$\n   - $z$\n2. two\n",
        &[
            "enter item",
            "w 1:4 one",
            "break",
            "Display 4:4 x\n   y",
            "break",
            "enter item",
            "Inline 7:7 z",
            "break",
            "leave item",
            "leave item",
            "enter item",
            "w 8:4 two",
            "break",
            "leave item",
        ],
    );
    // A display whose lines are not indented stays with its item.
    assert_eq!(texts("- item\n  $$\nx = 1\n  $$\n\nafter $y$\n"), ["x = 1", "y"]);
    let notes = markdown("> > $$\n> > a\n> > = b\n> > $$\n");
    let formula = formulas(&notes)[0];
    let sign = formula.text.find('=').unwrap();
    assert_eq!(notes.file.slice(formula.in_file(crate::formula::source::Span::new(sign, sign + 3))), "= b");
}

#[test]
fn tables() {
    assert_shown(
        "| n | $B$ |\n|---|:-:|\n| 1 | $t$ |\n\nx\n",
        &[
            "enter row",
            "w 1:1 | n |",
            "Inline 1:8 B",
            "w 1:11 |",
            "break",
            "leave row",
            "enter row",
            "w 3:1 | 1 |",
            "Inline 3:8 t",
            "w 3:11 |",
            "break",
            "leave row",
            "w 5:1 x",
            "break",
        ],
    );
    // A table that lost its marks: the second cell has no opening sign.
    assert_shown(
        "$b_0 = f(0^2)$\t= f(0, 0)$\n$b_1 = f(1^2)$\t= f(1, 1)$\n",
        &[
            "Inline 1:2 b_0 = f(0^2)",
            "Plain 1:16 = f(0, 0)",
            "Inline 2:2 b_1 = f(1^2)",
            "Plain 2:16 = f(1, 1)",
            "break",
        ],
    );
}

#[test]
fn declarations() {
    assert_shown(
        "a <!-- polarform: F(t) := t^2 --> b <!-- other $x$ -->\n\n<!--\npolarform:\n\nG := 1\n\n# H := 2\n-->\n",
        &[
            "w 1:1 a",
            "declaration 1:19 F(t) := t^2",
            "w 1:35 b",
            "break",
            "declaration 6:1 G := 1\n\n# H := 2",
        ],
    );
}

#[test]
fn what_is_no_formula() {
    for text in [
        "`$a$` and ``b ` $c$``",
        "```\n$a$\n$$\n```\n",
        "> ```tex\n> $a$\n> ```\n",
        "para\n\n    $a$\n",
        "It costs $5 and $6, or 5$ and 6$.",
        "between $1,000 and $2,000",
        "\\$a\\$",
        "---\ntitle: $a$\n---\n",
        "<!-- $a$ -->",
        "<pre>$a$</pre> <img alt=\"$x$\" src=\"a\">",
        "[text](http://a.b/$x$/c) <http://a.b/$y$> http://a.b/?p=$q$",
        "![$a$](b)",
        "    F(t) = t^2\n",
        "<script>\nvar x = 1; f(x) = 2;\n</script>",
    ] {
        assert_eq!(texts(text), [""; 0], "{text:?}");
    }
    assert_eq!(texts("pay $5 for $x$ and <b>$y$</b>, $x<y$ or $y>x$"), ["x", "y", "x<y", "y>x"]);
}

#[test]
fn one_slip_does_not_hide_the_rest() {
    for (text, place, wanted) in [
        ("$a and so it goes on.\n\n$b$\n", (1, 1), vec!["b"]),
        ("the $C^n宽，曲线 and $b$\n", (1, 5), vec!["b"]),
        ("$$\n\\frac{1}{2}\n\n# Next\n\n$$\nb\n$$\n", (1, 1), vec!["\\frac{1}{2}", "b"]),
        ("$$\n\\alpha\n\nwe see that $c$ is\n\n$$b$$\n", (1, 1), vec!["\\alpha", "c", "b"]),
        ("$$ \\alpha\n\nThis is the prose after it.\n\n$$b$$\n", (1, 1), vec!["\\alpha", "b"]),
        ("> $$\n> \\alpha\n\n$b$\n", (1, 3), vec!["\\alpha", "b"]),
        ("\\begin{align}\na\n\n$b$\n", (1, 1), vec!["b"]),
    ] {
        let notes = markdown(text);
        let found: Vec<_> = formulas(&notes).into_iter().map(|formula| formula.text.as_str()).collect();
        assert_eq!(found, wanted, "{text:?}");
        let problem = &notes.problems[0];
        assert_eq!(problem.code, Code::UnclosedFormula, "{text:?}");
        assert_eq!(notes.file.line_column(problem.span.unwrap().start), place, "{text:?}");
        assert!(!problem.hints.is_empty());
        assert_eq!(notes.problems.len(), 1, "{text:?}: {:?}", notes.problems);
    }
    let notes = markdown("$a$\n\n```\n$b$\n");
    assert_eq!(notes.problems[0].code, Code::UnclosedBlock);
    assert_eq!(notes.file.line_column(notes.problems[0].span.unwrap().start), (3, 1));
}

#[test]
fn windows_line_ends() {
    assert_shown(
        "# A\r\n\r\n> x\r\n> $$\r\n> a\r\n> $$\r\n\r\n| a |\r\n|---|\r\n",
        &[
            "h1 1:3 A",
            "break",
            "enter quotation",
            "w 3:3 x",
            "Display 5:3 a",
            "break",
            "leave quotation",
            "enter row",
            "w 8:1 | a |",
            "break",
            "leave row",
        ],
    );
}
