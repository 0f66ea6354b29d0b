//! Texts woven whole.

use proptest::prelude::*;

use super::*;
use crate::language::diagnostic::Code;
use crate::language::diagnostic::Severity;

fn file(text: &str) -> SourceFile {
    SourceFile::new("a.md", text)
}

fn woven(text: &str) -> Woven {
    weave_markdown(&file(text), &Options::default())
}

/// In place, without the stamp.
fn in_place(text: &str) -> String {
    without_stamp(&woven(text).text).0.to_owned()
}

fn copied(text: &str) -> String {
    weave_markdown(&file(text), &Options { mode: Mode::Template, ..Options::default() }).text
}

fn codes(woven: &Woven) -> Vec<Code> {
    woven.problems.iter().map(|failure| failure.problem.code).collect()
}

#[test]
fn queries_among_words_and_in_formulas() {
    assert_eq!(in_place("so {{ 1/2 + 1/3 }}."), r"so $\frac{5}{6}$<!-- {{ 1/2 + 1/3 }} -->.");
    assert_eq!(copied("so {{ 1/2 + 1/3 }}."), r"so $\frac{5}{6}$.");
    assert_eq!(in_place("$a = {{ 1 }} - {{ 2 }}$"), "$a = 1 - 2$<!-- $a = {{ 1 }} - {{ 2 }}$ -->");
    assert_eq!(copied("$$\na = {{ 1 }}\n$$\n"), "$$\na = 1\n$$\n");
    assert_eq!(
        in_place("> $$\n> a = {{ 1 }}\n> $$\n"),
        "> $$\n> a = 1\n> $$\n> <!--\n> $$\n> a = {{ 1 }}\n> $$\n> -->\n"
    );
    assert_eq!(copied(r"$\frac{{a}}{{ 2 }}$ and \(x = {{ 2 }}\)"), r"$\frac{{a}}2$ and \(x = 2\)");
    assert_eq!(copied("a := {{ a := 3 }}, {{ a^2; a^3 }}"), "a := $a = 3$, $27$");
    assert_eq!(copied("{{ degree(0) }}"), "the zero polynomial has no degree");
}

#[test]
fn what_is_left_alone() {
    for text in [
        "",
        "no queries\n",
        "---\na: {{ 1 }}\n---\n",
        "`{{ 1 }}` and \\{{ 1 }} and {{#include a.md}} and {{< video a >}}\n",
        "```text\n{{ 1 }}\n```\n\n    {{ 1 }}\n",
        "${{n}\\choose{k}}$ and $x^{{2}}$\n",
        "<!-- {{ not closed -->\n<!-- just words -->\n",
        "<!-- polarform: F(t) := t^2 -->\n",
        "<!-- woven -->\nan old result\n<!-- /woven -->\n",
    ] {
        assert_eq!(woven(text).text, text);
        assert_eq!(copied(text), text);
    }
}

#[test]
fn a_block_and_its_result() {
    let text = "```polarform\na := 2\na^2\n```\nnext\n";
    let right = "```polarform\na := 2\na^2\n```\n<!-- woven -->\n\n$$\na = 2\n$$\n\n$$\n4\n$$\n\n<!-- /woven -->\nnext\n";
    assert_eq!(in_place(text), right);
    assert_eq!(in_place(&right.replace('4', "an edited result")), right);
    assert_eq!(copied(text), "```polarform\na := 2\na^2\n```\n\n$$\na = 2\n$$\n\n$$\n4\n$$\nnext\n");
    assert_eq!(copied(right), copied(text));
    let hidden = "```polarform hide show=last style=inline\na := 2\na^2\n```\n";
    assert_eq!(copied(hidden), "$4$\n");
    let settled = in_place(hidden);
    assert!(settled.starts_with("<!--\n```polarform hide show=last style=inline\n"), "{settled}");
    assert!(settled.ends_with("```\n-->\n<!-- woven -->\n\n$4$\n\n<!-- /woven -->\n"), "{settled}");
    assert_eq!(copied(&settled), "$4$\n");
    assert_eq!(copied("a\n\n```polarform hide show=none\na := 2\n```\n\n{{ a }}\n"), "a\n\n$2$\n");
    // Without results there is no region.
    assert_eq!(
        in_place(&right.replacen("polarform", "polarform show=none", 1)),
        text.replacen("polarform", "polarform show=none", 1)
    );
}

#[test]
fn the_session_runs_through_the_file() {
    let text = "{{ f(0, 1) }}\n\n```polarform show=none\nf := polar(t^2 + 2t)\n```\n\n{{ f(0, 1) }}\n";
    let woven = woven(text);
    assert_eq!(codes(&woven), [Code::AmbiguousProduct]);
    assert!(woven.failed && woven.text.contains("\n$1$<!-- {{ f(0, 1) }} -->\n"), "{}", woven.text);
    assert!(woven.text.starts_with("{{ f(0, 1) }}\n"));
}

#[test]
fn problems_are_told_where_they_stand() {
    let text = "# One\n\n> - so\n>\n>   ```polarform\n>   a := 1\n>   b := 1/0\n>   c := 2\n>   ```\n\n$x = {{ a }} {{ nope1 + a }}$, {{ c }}\n";
    let woven = woven(text);
    let places: Vec<(usize, usize)> = woven
        .problems
        .iter()
        .map(|failure| failure.file.line_column(failure.problem.span.unwrap().start))
        .collect();
    assert_eq!(places, [(7, 12), (11, 17)], "{:?}", woven.problems);
    // The formula and the block stay, the rest is filled in.
    assert_eq!(without_stamp(&woven.text), (text.replace("{{ c }}", "$2$<!-- {{ c }} -->").as_str(), None));
}

#[test]
fn refuted_claims_show_their_verdict() {
    let woven = woven("$a$: {{ (t+1)^2 = t^2 + 2t + 1 }} and {{ 1 + 1 = 3 }}\n");
    assert_eq!((woven.refuted, woven.failed), (1, false));
    assert!(
        woven.text.contains(r"${\left( t + 1 \right)}^2")
            || woven.text.contains("(t + 1)^2 = t^2 + 2 t + 1$")
    );
    assert!(
        woven
            .text
            .contains(r"$1 + 1 = 3 \quad \textbf{[}\text{refuted: left }2\text{, right }3\textbf{]}$<!--")
    );
    assert_eq!(without_stamp(&woven.text).1, None, "a refuted claim is told each time");
    let undecided = super::weave_markdown(&file("{{ x > 0 }}"), &Options::default());
    assert!(
        undecided.failed && undecided.problems.iter().any(|failure| failure.problem.code == Code::Undecided)
    );
}

#[test]
fn the_stamp_knows_what_matters() {
    let text = "Words. {{ 1 + 1 }}\n\n```polarform\nf := polar(t^3 + t)\n```\n";
    let first = woven(text).text;
    assert!(woven(&first).unchanged);
    // Words may change, results and queries may not.
    assert!(woven(&first.replace("Words", "Other words")).unchanged);
    for (old, new) in
        [("$2$", "$3$"), ("{{ 1 + 1", "{{ 1 + 2"), ("t^3 + t)", "t^3)"), ("polarform\n", "polarform steps\n")]
    {
        let changed = woven(&first.replacen(old, new, 1));
        assert!(!changed.unchanged && !changed.stale.is_empty(), "{old}");
    }
    let fresh = Options { fresh: true, ..Options::default() };
    let again = weave_markdown(&file(&first), &fresh);
    assert!(!again.unchanged && again.stale.is_empty() && again.text == first);
    let other = Options {
        blocks: BlockOptions {
            notation: crate::language::value::Notation::Expanded,
            ..BlockOptions::default()
        },
        ..Options::default()
    };
    assert!(!weave_markdown(&file(&first), &other).unchanged);
}

#[test]
fn line_ends_are_kept() {
    let text = "a {{ 1 }}\r\n\r\n- ```polarform\r\n  1 + 1\r\n  ```\r\n";
    let woven = woven(text);
    assert!(!woven.failed, "{:?}", woven.problems);
    assert!(woven.text.ends_with("-->\r\n"), "{:?}", woven.text);
    let bare = woven.text.replace("\r\n", "\n");
    assert!(!bare.contains('\r') && bare.matches('\n').count() == woven.text.matches("\r\n").count());
    assert_eq!(without_stamp(&bare).0, in_place(&text.replace("\r\n", "\n")));
}

#[test]
fn bars_in_tables() {
    let text = "| a | b |\n| --- | --- |\n| {{ [1, 2; 3, 4] }} | x |\n";
    let row = copied(text);
    assert!(row.lines().all(|line| line.matches('|').count() == 3), "{row}");
}

#[test]
fn latex_keeps_old_results_of_failing_queries() {
    let document = |query: &str| {
        SourceFile::new(
            "b.tex",
            format!(
                "\\documentclass{{a}}\\usepackage{{polarform}}\n\\polarform{{{query}}} \\polarform{{1 + 1}}\n\\begin{{polarform}}[show=last]\na := 2\na^2\n\\end{{polarform}}\n"
            ),
        )
    };
    let weave =
        |query: &str, before: &str| weave_latex(&document(query), before, &mut |_| None, &Options::default());
    let first = weave("b := 5", "");
    assert_eq!((first.results, first.stale.len(), first.failed), (4, 3, false), "{:?}", first.problems);
    assert!(first.text.contains("\\polarformresult{0}{1}{b := 5}{b = 5}\n"));
    assert!(first.text.contains("\\begin{polarformquery}[show=last]\na := 2\na^2\n\\end{polarformquery}\n"));
    assert!(weave("b := 5", &first.text).unchanged);
    let broken = first.text.replace("b := 5", "nope(1)");
    let second = weave("nope(1)", &broken);
    assert!(second.failed && second.text.contains("{nope(1)}{b = 5}"), "{}", second.text);
    assert!(!weave("nope(1)", &second.text).unchanged);
    let third = weave("nope2(1)", &first.text);
    assert!(!third.text.contains("nope2"));
}

#[test]
fn latex_reads_included_files_in_their_places() {
    let main =
        SourceFile::new("m.tex", "\\polarform{a := 2}\\input{one}\\polarform{a}\\input{one}\\input{gone}");
    let mut load =
        |name: &str| (name == "one").then(|| SourceFile::new("one.tex", "\\polarform{a := 3}\\input{one}"));
    let woven = weave_latex(&main, "", &mut load, &Options::default());
    assert!(woven.text.contains("{a}{3}"), "{}", woven.text);
    let problem = weave_latex(
        &main,
        "",
        &mut |_| Some(SourceFile::new("two.tex", "x\n\\polarform{1/0}")),
        &Options::default(),
    );
    let failure = &problem.problems[0];
    assert_eq!(
        (failure.file.name(), failure.file.line_column(failure.problem.span.unwrap().start)),
        ("two.tex", (2, 14))
    );
}

#[test]
fn the_same_query_with_two_results() {
    let text =
        "\\polarform{a := 2}\\polarform{a}\\polarform{a := 3}\\polarform{a}\\polarform{2}\\polarform{2}";
    let woven = weave_latex(&SourceFile::new("m.tex", text), "", &mut |_| None, &Options::default());
    assert!(
        woven.text.contains("%%% 2\n\\polarformresult{1}{1}{a}{2}\n")
            && woven.text.contains("%%% 4\n\\polarformresult{2}{2}{a}{3}\n")
    );
    assert_eq!(woven.text.matches("{2}{2}\n").count(), 1);
}

#[test]
fn latex_cannot_tell_the_last_values_apart() {
    let woven = weave_latex(
        &SourceFile::new("m.tex", "\\polarform{1}\\polarform{ans + 1}\\polarform{ans + 1}\\polarform{2}"),
        "",
        &mut |_| None,
        &Options::default(),
    );
    assert_eq!(codes(&woven), [Code::Unsupported]);
    assert!(woven.failed && woven.text.contains("{ans + 1}{2}") && !woven.text.contains("{3}"));
}

#[test]
fn notebooks_change_only_where_results_stand() {
    let text = "{\"cells\": [\n {\"cell_type\": \"markdown\",\n  \"source\": [\n   \"caf\\u00e9 {{ a := 2 }}\\n\",\n   \"```polarform\\n\",\n   \"a^2\\n\",\n   \"```\"\n  ]},\n {\"cell_type\": \"code\", \"source\": \"{{ a }}\"}, {\"cell_type\": \"markdown\", \"source\": \"$\\\\frac{a}{2} = {{ a/2 }}$\"}],\n \"nbformat\": 4}\n";
    let first = weave_notebook(&SourceFile::new("a.ipynb", text), &Options::default());
    assert!(!first.failed, "{:?}", first.problems);
    assert!(first.text.contains("\"caf\\u00e9 $a = 2$<!-- {{ a := 2 }} -->\\n\",\n"), "{}", first.text);
    assert!(
        first.text.contains("   \"```\\n<!-- woven -->\\n\\n$$\\n4\\n$$\\n\\n<!-- /woven -->\"\n  ]}"),
        "{}",
        first.text
    );
    assert!(
        first.text.contains(r#""$\\frac{a}{2} = 1$<!-- $\\frac{a}{2} = {{ a/2 }}$ -->""#),
        "{}",
        first.text
    );
    assert!(first.text.contains("\"source\": \"{{ a }}\""));
    serde_json::from_str::<serde_json::Value>(&first.text).unwrap();
    let second = weave_notebook(&SourceFile::new("a.ipynb", first.text.as_str()), &Options::default());
    assert_eq!(second.text, first.text);
    let broken =
        weave_notebook(&SourceFile::new("a.ipynb", text.replace("a/2 }}", "a/0 }}")), &Options::default());
    let failure = &broken.problems[0];
    assert_eq!(failure.file.slice(failure.problem.span.unwrap()), "0");
    assert_eq!(
        weave_notebook(&file("{"), &Options::default()).problems[0].problem.code,
        Code::BrokenNotebook
    );
}

#[test]
fn books() {
    let text = r#"[{"root": "/"}, {"sections": [{"Chapter": {"name": "A", "content": "{{ a := 1 }}", "path": "a.md", "sub_items": [{"Chapter": {"name": "B", "content": "{{ nope(2) }}", "path": "b.md"}}]}}, "Separator", {"PartTitle": "P"}], "__non_exhaustive": null}]"#;
    let woven = weave_book(text, &Options::default()).unwrap();
    assert!(woven.text.contains(r#""content":"$a = 1$""#) && woven.text.contains("\"Separator\""));
    assert_eq!(woven.problems[0].file.name(), "b.md");
    assert!(matches!(weave_book("{}", &Options::default()), Err(BookError::Shape)));
    assert!(matches!(weave_book("", &Options::default()), Err(BookError::Json(_))));
}

/// A piece of a document, and whether it is a query.
fn piece() -> impl Strategy<Value = (&'static str, bool)> {
    prop_oneof![
        3 => prop::sample::select(vec![
            "words ", "\n", "\n\n", "- item\n", "> quoted ", "$x^2$ ", "`{{ 1 }}` ", "\\{{ x }} ", "é ", "  ",
            "# Heading\n", "\n```text\n{{ 1 }}\n```\n", "\n$$\ny\n$$\n", "<!-- words --> ", "| a | b |\n",
            "\r\n", "*b* ", "$5 and ", "\n---\n", "\n    {{ code }}\n",
        ]).prop_map(|text| (text, false)),
        1 => prop::sample::select(vec![
            "{{ 1 + 1 }} ", "$a = {{ 2/4 }}$ ", "\n$$\nb = {{ f(0) }}\n$$\n", "\n```polarform\nf(t) := t^2\nf(3)\n```\n",
            "\n```polarform hide style=list\n1; 2\n```\n", "\n> ```polarform style=table\n> 1 + 1\n> ```\n",
            "\n- ~~~polarform style=code\n  1\n  ~~~\n", "{{ 1/0 }} ", "{{ 1 = 2 }} ", "\n```math\n{{ 3 }}\n```\n",
            "<!-- {{ 5 }} --> ", "$z$<!-- {{ 6 }} --> ",
        ]).prop_map(|text| (text, true)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Weaving twice is weaving once, and a stamp is right.
    #[test]
    fn weaving_is_idempotent(pieces in prop::collection::vec(piece(), 0..12)) {
        let text: String = pieces.iter().map(|piece| piece.0).collect();
        let first = woven(&text);
        let second = woven(&first.text);
        prop_assert_eq!(&second.text, &first.text);
        prop_assert_eq!(second.unchanged, without_stamp(&first.text).1.is_some());
        let fresh = weave_markdown(&file(&first.text), &Options { fresh: true, ..Options::default() });
        prop_assert_eq!(&fresh.text, &first.text);
        prop_assert!(fresh.stale.is_empty());
    }

    /// What is no query keeps every byte: taking the changes back gives the text.
    #[test]
    fn the_rest_keeps_every_byte(pieces in prop::collection::vec(piece(), 0..12)) {
        let text: String = pieces.iter().map(|piece| piece.0).collect();
        let plan = plan::plan(&text, &BlockOptions::default());
        let mut runner = Runner::new(Session::default());
        for mode in [Mode::InPlace, Mode::Template] {
            let options = Options { mode, ..Options::default() };
            let found = edits(&text, &plan, &mut runner, &file(&text), &|span| span, &options);
            let mut at = 0;
            let mut kept = String::new();
            for edit in &found {
                prop_assert!(edit.span.start >= at);
                kept.push_str(&text[at..edit.span.start]);
                let old = &text[edit.span.range()];
                prop_assert!(
                    old.is_empty() || old.contains("{{") || old.contains("polarform") || old == "$z$",
                    "{old:?} is not ours"
                );
                kept.push_str(old);
                at = edit.span.end;
            }
            kept.push_str(&text[at..]);
            prop_assert_eq!(&kept, &text);
        }
        if pieces.iter().all(|piece| !piece.1) {
            prop_assert_eq!(&woven(&text).text, &text);
        }
    }

    /// Whatever the bytes are, there is an answer, and problems lie in the file.
    #[test]
    fn any_text_is_answered(text in "([ >`$\\\\{}\n\r!<a1%-]|\\{\\{ | \\}\\}|```polarform\n|<!--|-->|woven|/woven|é|\\\\polarform|\\\\begin\\{polarform\\}|\\\\end\\{polarform\\}){0,40}") {
        let mut all = vec![woven(&text), weave_notebook(&file(&text), &Options::default())];
        all.push(weave_markdown(&file(&text), &Options { mode: Mode::Template, ..Options::default() }));
        all.push(weave_latex(&file(&text), &text, &mut |_| None, &Options::default()));
        for woven in all {
            for Failure { problem, file } in &woven.problems {
                prop_assert!(problem.code != Code::Internal, "{problem:?}");
                let inside = problem.span.is_none_or(|span| file.text().get(span.range()).is_some());
                prop_assert!(inside, "{problem:?}");
                prop_assert!(problem.severity != Severity::Error || problem.span.is_some(), "{problem:?}");
            }
        }
    }
}

#[test]
fn time_is_linear() {
    let begin = std::time::Instant::now();
    for piece in [
        "{{ ",
        "{{",
        "${{ ",
        "<!-- {{ ",
        "```polarform\n",
        "\\polarform{",
        "\\begin{polarform}",
        "{{ a\n",
        "<!-- woven -->\n",
    ] {
        let text = piece.repeat(20_000);
        plan::plan(&text, &BlockOptions::default());
        crate::document::latex_parts(&text);
    }
    let text = "$x$<!-- woven -->\n```polarform\n```\n".repeat(5_000);
    plan::plan(&text, &BlockOptions::default());
    assert!(begin.elapsed() < std::time::Duration::from_secs(20), "{:?}", begin.elapsed());
}
