//! The command that weaves: files, streams, exit status; and what a real TeX makes of it.

use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::common::folder::Folder;
use crate::common::{run, run_with};

const NOTES: &str = "\
```polarform
f := polar(t^2 + 2t)
```

so $f(0, 1) = {{ f(0, 1) }}$ and {{ f(0, 1/2) }}.
";

#[test]
fn in_place_and_again() {
    let folder = Folder::new("in_place");
    let notes = folder.write("notes.md", NOTES);
    let ran = run(&["weave", "--check", &notes]);
    assert_eq!(ran.status, Some(1), "{}", ran.err);
    assert!(ran.err.contains("error[E703]") && ran.err.contains("notes.md:5:15"), "{}", ran.err);
    assert_eq!(folder.read("notes.md"), NOTES);

    let ran = run(&["weave", &notes]);
    assert_eq!((ran.status, ran.err.as_str()), (Some(0), ""));
    assert_eq!(ran.out, format!("{notes}: 3 results, 3 changed\n"));
    let woven = folder.read("notes.md");
    assert!(woven.contains("so $f(0, 1) = 1$<!-- $f(0, 1) = {{ f(0, 1) }}$ --> and $\\frac{1}{2}$<!--"));

    let begin = Instant::now();
    let ran = run(&["weave", &notes]);
    assert_eq!((ran.status, ran.out), (Some(0), format!("{notes}: nothing changed\n")));
    assert!(begin.elapsed() < Duration::from_secs(2));
    assert_eq!(folder.read("notes.md"), woven);
    assert_eq!(run(&["weave", "--check", &notes]).status, Some(0));
    assert_eq!(run(&["weave", "--fresh", &notes]).out, format!("{notes}: 3 results, 0 changed\n"));
    assert_eq!(folder.read("notes.md"), woven);

    folder.write("notes.md", woven.replace("t^2 + 2t)", "t^2 + 4t)"));
    let ran = run(&["weave", "--check", &notes]);
    assert_eq!(ran.status, Some(1));
    assert!(ran.out.ends_with("3 out of date\n"), "{}", ran.out);
    assert_eq!(folder.files(), ["notes.md"]);
}

#[test]
fn what_fails_keeps_its_old_result() {
    let folder = Folder::new("fails");
    let notes = folder.write("notes.md", NOTES);
    run(&["weave", &notes]);
    let broken =
        folder.read("notes.md").replace("{{ f(0, 1/2) }}", "{{ f(0, 1/0) }}").replace("+ 2t", "+ 4t");
    folder.write("notes.md", &broken);
    let ran = run(&["weave", &notes]);
    assert_eq!(ran.status, Some(2));
    assert!(ran.err.starts_with("error[E303]") && ran.err.contains("notes.md:"), "{}", ran.err);
    assert!(
        ran.err.contains("and $\\frac{1}{2}$<!-- {{ f(0, 1/0) }} -->") && ran.err.contains('^'),
        "{}",
        ran.err
    );
    let woven = folder.read("notes.md");
    assert!(woven.contains("$f(0, 1) = 2$<!--") && woven.contains("$\\frac{1}{2}$<!-- {{ f(0, 1/0) }} -->"));
    assert!(!woven.contains("woven by"), "what fails is told each time");
    assert_eq!(run(&["weave", &notes]).status, Some(2));
    assert_eq!(folder.read("notes.md"), woven);
}

#[test]
fn refuted_claims() {
    let folder = Folder::new("refuted");
    let notes = folder.write("notes.md", "x\n\nso {{ 1 + 1 = 3 }} and {{ 2 }}\n");
    for _ in 0..2 {
        let ran = run(&["weave", &notes]);
        assert_eq!(ran.status, Some(1));
        assert!(ran.err.starts_with("error[E704]: this claim is false"), "{}", ran.err);
        assert!(ran.err.contains("left 2, right 3"), "{}", ran.err);
    }
    assert!(folder.read("notes.md").contains("refuted: left "));
    let json = run(&["weave", &notes, "--format", "json"]);
    let summary: serde_json::Value = serde_json::from_str(&json.out).expect("it is JSON");
    assert_eq!((&summary["refuted"], &summary["failed"]), (&1.into(), &false.into()));
    assert!(json.err.starts_with('{'), "{}", json.err);
}

#[test]
fn copies() {
    let folder = Folder::new("copies");
    let notes = folder.write("notes.src.md", NOTES);
    let target = folder.path("notes.md");
    let ran = run(&["weave", &notes, "-o", "-"]);
    assert_eq!((ran.status, ran.err.as_str()), (Some(0), ""));
    assert!(ran.out.ends_with("so $f(0, 1) = 1$ and $\\frac{1}{2}$.\n"), "{}", ran.out);
    assert_eq!(run(&["weave", &notes, "-o", &target, "--check"]).status, Some(1));
    assert_eq!(run(&["weave", &notes, "-o", &target]).status, Some(0));
    let copy = folder.read("notes.md");
    assert!(copy.starts_with(&ran.out) && copy.lines().count() == ran.out.lines().count() + 1);
    assert!(run(&["weave", &notes, "-o", &target]).out.ends_with("nothing changed\n"));
    assert_eq!(run(&["weave", &notes, "-o", &target, "--check"]).status, Some(0));
    folder.write("notes.md", copy.replace("= 1$", "= 7$"));
    let ran = run(&["weave", &notes, "-o", &target, "--check"]);
    assert_eq!(ran.status, Some(1));
    assert!(ran.err.contains("notes.md:9:1"), "{}", ran.err);

    // With a query that fails, the copy stays.
    let old = folder.read("notes.md");
    folder.write("notes.src.md", NOTES.replace("1/2", "1/0"));
    let ran = run(&["weave", &notes, "-o", &target]);
    assert_eq!((ran.status, folder.read("notes.md") == old), (Some(2), true));
    assert!(ran.out.contains("was not written"), "{}", ran.out);

    assert_eq!(run(&["weave", &notes, "-o", &notes]).status, Some(2));
    assert_eq!(run(&["weave", &notes, &notes, "-o", &target]).status, Some(2));
}

#[test]
fn files_that_cannot_be_woven() {
    let folder = Folder::new("bad_files");
    let latin = folder.write("latin.md", b"caf\xe9 {{ 1 }}\n");
    let good = folder.write("good.md", "{{ 1 + 1 }}\n");
    fs::create_dir(folder.path("empty")).expect("it can be made");
    for (arguments, code, what) in [
        (vec![folder.path("missing.md")], "E501", "there is no such file"),
        (vec![folder.path("empty")], "E501", "this is a directory"),
        (vec![latin.clone()], "E606", "line 1 is not UTF-8"),
        (vec![good.clone(), "-o".into(), folder.path("none/out.md")], "E501", "the folder must exist"),
        (vec![good.clone(), "-o".into(), folder.path("")], "E501", "this is a directory"),
        (vec![good.clone(), "--format".into(), "latex".into()], "E502", "no such format"),
    ] {
        let arguments: Vec<&str> =
            ["weave"].into_iter().chain(arguments.iter().map(String::as_str)).collect();
        let ran = run(&arguments);
        assert_eq!(ran.status, Some(2), "{arguments:?}: {}", ran.out);
        assert!(ran.err.starts_with(&format!("error[{code}]")) && ran.err.contains(what), "{}", ran.err);
        assert!(ran.err.contains("= help:"), "{}", ran.err);
    }
    assert_eq!(fs::read(&latin).unwrap(), b"caf\xe9 {{ 1 }}\n");
    // One bad file does not spoil the others.
    let ran = run(&["weave", &latin, &good]);
    assert_eq!(ran.status, Some(2));
    assert!(folder.read("good.md").starts_with("$2$<!-- {{ 1 + 1 }} -->\n"));
}

/// Pictures are written beside their document, whatever links stand there.
#[cfg(unix)]
#[test]
fn links_out_of_the_folder_are_not_followed() {
    use std::os::unix::fs::symlink;
    let (folder, outside) = (Folder::new("links"), Folder::new("outside"));
    let notes = folder.write("notes.md", "```polarform picture=figures/a\nfigure_basis(2)\n```\n");
    symlink(&outside.0, folder.path("figures")).unwrap();
    let refused = |what: &str| {
        let ran = run(&["weave", &notes]);
        assert_eq!(ran.status, Some(2));
        assert!(ran.err.contains(what), "{}", ran.err);
    };
    refused("leads out of the folder");
    assert!(outside.files().is_empty());
    fs::remove_file(folder.path("figures")).unwrap();
    fs::create_dir(folder.path("figures")).unwrap();
    let other = outside.write("b.svg", "<svg class=\"polarform\"/>");
    symlink(&other, folder.path("figures/a.svg")).unwrap();
    refused("leads out of the folder");
    fs::remove_file(&other).unwrap();
    refused("leads nowhere");
    assert!(outside.files().is_empty());
    // Within the folder, links are followed.
    fs::remove_dir_all(folder.path("figures")).unwrap();
    fs::create_dir(folder.path("pictures")).unwrap();
    symlink(folder.path("pictures"), folder.path("figures")).unwrap();
    assert_eq!(run(&["weave", &notes]).status, Some(0));
    assert!(folder.read("pictures/a.svg").contains("class=\"polarform"));
}

#[test]
fn blocks_that_are_never_closed_and_bad_options() {
    let folder = Folder::new("unclosed");
    for (text, code, place) in [
        ("a\n\n```polarform\n1 + 1\n", "E701", "a.md:3:4"),
        ("a {{ 1 + 1\n", "E701", "a.md:1:3"),
        ("```polarform\n1\n```\n<!-- woven -->\nx\n", "E701", "a.md:4:1"),
        ("```polarform stile=list\n1\n```\n", "E702", "a.md:1:14"),
        ("```polarform style=lists\n1\n```\n", "E702", "a.md:1:14"),
    ] {
        let file = folder.write("a.md", text);
        let ran = run(&["weave", &file]);
        assert_eq!(ran.status, Some(2), "{text}");
        assert!(ran.err.starts_with(&format!("error[{code}]")) && ran.err.contains(place), "{}", ran.err);
        assert!(ran.err.contains('^') && ran.err.contains("= help:"), "{}", ran.err);
        assert_eq!(folder.read("a.md"), text);
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_may_only_be_read() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("readonly");
    let file = folder.write("a.md", "{{ 1 + 1 }}\n");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
    let ran = run(&["weave", &file]);
    assert_eq!(ran.status, Some(2));
    assert!(ran.err.contains("may only be read"), "{}", ran.err);
    assert_eq!((folder.read("a.md").as_str(), folder.files()), ("{{ 1 + 1 }}\n", vec!["a.md".to_owned()]));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    assert_eq!(run(&["weave", &file]).status, Some(0));
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
}

#[test]
fn mdbook() {
    let book = r#"[{"root": "/"}, {"items": [{"Chapter": {"name": "A", "content": "{{ 1 + 1 }}", "path": "a.md"}}]}]"#;
    let ran = run_with(&["weave", "--mdbook"], book.as_bytes());
    assert_eq!(ran.status, Some(0), "{}", ran.err);
    let woven: serde_json::Value = serde_json::from_str(&ran.out).expect("it is JSON");
    assert_eq!(woven["items"][0]["Chapter"]["content"], "$2$");
    assert_eq!(run(&["weave", "--mdbook", "supports", "html"]).status, Some(0));
    let ran = run_with(&["weave", "--mdbook"], book.replace("1 + 1", "1/0").as_bytes());
    assert_eq!((ran.status, ran.out.as_str()), (Some(2), ""));
    assert!(ran.err.contains("a.md:1:6"), "{}", ran.err);
    assert_eq!(run_with(&["weave", "--mdbook"], b"[]").status, Some(2));
    assert_eq!(run(&["weave"]).status, Some(2));
    // What mdBook would take apart is told, but not if another preprocessor takes formulas out first.
    let broken = |config: &str| {
        let content = r"So $\\{1, 2\\}$ and $\\hat{b}_i = c_{j}$, but $b_i = c_j$.";
        format!(
            r#"[{{"config": {{"preprocessor": {config}}}}}, {{"items": [{{"Chapter": {{"name": "One", "content": "{content}"}}}}]}}]"#
        )
    };
    let ran = run_with(&["weave", "--mdbook"], broken(r#"{"polarform": {}}"#).as_bytes());
    assert_eq!((ran.status, ran.err.matches("warning[E610]").count()), (Some(0), 2), "{}", ran.err);
    assert!(ran.err.contains("loses its stroke") && ran.err.contains("slanted"), "{}", ran.err);
    let ran = run_with(&["weave", "--mdbook"], broken(r#"{"polarform": {}, "katex": {}}"#).as_bytes());
    assert!(ran.status == Some(0) && ran.err.is_empty(), "{}", ran.err);
    let ran = run_with(&["weave", "--mdbook", "--mathml"], broken("{}").as_bytes());
    assert!(ran.status == Some(0) && ran.err.is_empty(), "{}", ran.err);
}

const LECTURE: &str = r"\documentclass{article}
\usepackage{polarform}
\usepackage{hyperref}
\begin{document}
\begin{polarform}[steps=true]
F(t) := t^2 + 2t   # 100% {exact}
f := polar(F)
f(0, 1/2)
\end{polarform}
\section{The value \polarform{f(0,1)}}
Then $f(0,1) = \polarform{f(0,1)}$, in text \polarform{f(\tfrac12, r)}. % \polarform{nothing}
\begin{align}
 a &= \polarform{f(0,1/3)} \\ b &= \polarform{f(0, 1) = 1}
\end{align}
\begin{polarform}[style=list, hide]
polar_product(F, t + 1)
\end{polarform}
\begin{polarform}[style=table]
f(0,0)
abs(-3)
\end{polarform}
\begin{polarform}[style=code]
[1, 2; 3, 4]
[5, 6]
\end{polarform}
\begin{polarform}[show=none]
f := polar(t^3)
\end{polarform}
Now \polarform{f(1, 1, 2)}.
\end{document}
";

#[test]
fn latex() {
    let folder = Folder::new("latex");
    let lecture = folder.write("lecture.tex", LECTURE);
    assert_eq!(run(&["weave", "--check", &lecture]).status, Some(1));
    assert_eq!(folder.files(), ["lecture.tex"]);
    let ran = run(&["weave", &lecture]);
    assert_eq!((ran.status, ran.err.as_str()), (Some(0), ""));
    assert_eq!(folder.files(), ["lecture.polarform.tex", "lecture.tex", "polarform.sty"]);
    assert_eq!(folder.read("lecture.tex"), LECTURE);
    assert_eq!(folder.read("polarform.sty"), polarform::weave::PACKAGE);
    assert!(folder.read("lecture.polarform.tex").contains(r"\polarformresult{1}{1}{f(\tfrac12, r)}"));
    assert!(run(&["weave", &lecture]).out.ends_with("nothing changed\n"));
    assert_eq!(run(&["weave", "--check", &lecture]).status, Some(0));
    folder.write("lecture.tex", LECTURE.replace("+ 2t", "+ 4t"));
    let ran = run(&["weave", "--check", &lecture]);
    assert_eq!(ran.status, Some(1));
    assert!(ran.err.contains("lecture.tex:5:1"), "{}", ran.err);
    assert_eq!(run(&["weave", &lecture, "-o", &folder.path("a.tex")]).status, Some(2));

    let part = folder.write("part.tex", "\\documentclass{article}\n\\polarform{1}\n");
    let ran = run(&["weave", &part]);
    assert_eq!(ran.status, Some(0));
    assert!(ran.err.contains("the package polarform is not loaded"), "{}", ran.err);
    let elsewhere = folder.path("");
    fs::remove_file(folder.path("polarform.sty")).unwrap();
    assert_eq!(run(&["weave", "--write-style", &elsewhere]).status, Some(0));
    assert_eq!(folder.read("polarform.sty"), polarform::weave::PACKAGE);
}

/// Runs pdflatex in the folder, if there is one: what it says, without the breaks of its lines.
fn pdflatex(folder: &Folder, file: &str) -> Option<String> {
    let mut command = Command::new("pdflatex");
    command.args(["-interaction=nonstopmode", "-halt-on-error", file]).current_dir(&folder.0);
    command.env("max_print_line", "1000").stdin(Stdio::null());
    let output = command.output().ok()?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{said}");
    Some(said)
}

#[test]
fn a_real_tex_compiles_it_before_and_after() {
    let folder = Folder::new("tex");
    let lecture = folder.write("lecture.tex", LECTURE);
    folder.write("polarform.sty", polarform::weave::PACKAGE);
    let Some(before) = pdflatex(&folder, "lecture.tex") else {
        // There is no TeX on this machine.
        return;
    };
    assert!(before.contains("run polarform weave lecture.tex"), "{before}");
    assert!(before.contains("No result for 'f(0,1)'"), "{before}");

    assert_eq!(run(&["weave", &lecture]).status, Some(0));
    for _ in 0..2 {
        let after = pdflatex(&folder, "lecture.tex").expect("it is there");
        assert!(!after.contains("Package polarform Warning"), "{after}");
    }
    // A query that was changed is noticed, and only that one.
    folder.write("lecture.tex", LECTURE.replace(r"\polarform{f(0,1/3)}", r"\polarform{f(0,1/4)}"));
    let changed = pdflatex(&folder, "lecture.tex").expect("it is there");
    assert!(changed.contains("No result for 'f(0,1/4)'"), "{changed}");
    assert!(!changed.contains("No result for 'f(0,1)'"), "{changed}");
    let block = LECTURE.replace("polar_product(F, t + 1)", "polar_product(F, t + 2)");
    folder.write("lecture.tex", block);
    let changed = pdflatex(&folder, "lecture.tex").expect("it is there");
    assert_eq!(changed.matches("No result for").count(), 1, "{changed}");
    assert!(changed.contains("No result for the block"), "{changed}");
}

/// A name that is defined anew, and the places where LaTeX moves text to or sets it twice.
const REDEFINED: &str = r"\documentclass[twoside]{book}
\usepackage{polarform,hyperref}
\pagestyle{headings}
\begin{document}
\tableofcontents\listoffigures
\chapter{One}
\begin{polarform}[show=none, hide]
f := polar(t^2 + 2t)
\end{polarform}
\section{First \polarform{f(0,1)}, $\polarform{f(0,\tfrac12)}$}
\newpage Here \polarform{f(0,1)}.
\begin{figure}\caption{Before \polarform{f(0,1)}}\end{figure}
\begin{gather} \polarform{f := polar(t^2 + 4t)} \\ \polarform{f(0,1)} \end{gather}
Now \polarform{f(0,1)}.
\begin{figure}\caption{After \polarform{f(0,1)}}\end{figure}
\section{Second \polarform{f(0,1)}}
\newpage Text.
\end{document}
";

#[test]
fn the_same_query_has_the_result_of_its_place() {
    let folder = Folder::new("states");
    let file = folder.write("book.tex", REDEFINED);
    assert_eq!(run(&["weave", &file]).status, Some(0));
    for _ in 0..3 {
        let Some(said) = pdflatex(&folder, "book.tex") else { return };
        assert!(!said.contains("Package polarform Warning"), "{said}");
    }
    let mut command = Command::new("pdftotext");
    let Ok(output) = command.args(["book.pdf", "-"]).current_dir(&folder.0).output() else { return };
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    for (wanted, times) in [
        ("First 1", 2),
        ("Here 1.", 1),
        ("Before 1", 2),
        ("Now 2.", 1),
        ("After 2", 2),
        ("Second 2", 2),
        ("SECOND 2", 1),
    ] {
        assert_eq!(text.matches(wanted).count(), times, "{wanted} in {text}");
    }
}

/// The bars: 200 results, and a second run with nothing to do. A debug build on a busy machine has
/// more time.
#[test]
fn two_hundred_results() {
    let folder = Folder::new("many");
    let mut text = String::from("```polarform\nf := polar(t^3 + t)\n```\n\n");
    for i in 0..199 {
        text.push_str(&format!("The value $f(0, 1, {i}) = {{{{ f(0, 1, {i}) }}}}$.\n\n"));
    }
    let notes = folder.write("notes.md", text);
    let ran = run(&["weave", &notes]);
    assert!(ran.out.ends_with("200 results, 200 changed\n"), "{}", ran.out);
    assert!(ran.time < Duration::from_secs(10), "{:?}", ran.time);
    let ran = run(&["weave", &notes]);
    assert!(ran.out.ends_with("nothing changed\n") && ran.time < Duration::from_secs(2), "{:?}", ran.time);
}

/// Everything that is woven into a lecture with all styles and derivations.
const EVERYTHING: &str = "\
```polarform show=none hide
F(t) := t^3 + 3t^2 + 5t + 1
f := polar(F)
```

so $f(0, 1, 1) = {{ f(0, 1, 1) }}$, {{ f }}, {{ 1 + 1 = 3 }}, {{ (t + 1)^2 = t^2 + 1 }} and {{ degree(0) }}.

$$
{{ bernstein_to_power(3) }}
$$

> - in a list
>
>   ```polarform style=list steps=taylor
>   g := polar(t^2 + 2t)
>   ```
>
>   $$
>   {{ g }}
>   $$

```polarform steps=probability notation=sigma
g := polar(t^2 + 2t)
```

```polarform steps=parts
polar(F)
```

```polarform steps=laguerre style=table
polar(F)
```

```polarform steps=bezier equation
polar(t^2)
f(r, s, 1/2)
abs(-3)
```

```polarform style=inline
polar_compose(t^2, t^2 + 1)
[1, 2; 3, 4]
```

```polarform steps
h := polar_compose(t^2, t^2 + 1)
polar_sum(t^3, t^2)
```
";

fn formulas(text: &str) -> Vec<String> {
    use polarform::document::Item;
    use polarform::document::{Container, document};
    let file = polarform::source::SourceFile::new("a.md", text);
    let items = document(file.clone(), Container::Markdown).items.into_iter();
    let formula = |item: Item| match item {
        Item::Formula(formula) => Some(file.slice(formula.span).to_owned()),
        _ => None,
    };
    items.filter_map(formula).collect()
}

#[test]
fn a_real_renderer_accepts_what_is_woven() {
    use polarform::weave::{Mode, Options, weave_markdown};
    let file = polarform::source::SourceFile::new("a.md", EVERYTHING);
    let copy = weave_markdown(&file, &Options { mode: Mode::Template, ..Options::default() });
    let in_place = weave_markdown(&file, &Options::default());
    let told: Vec<&str> = copy.problems.iter().map(|failure| failure.problem.code.id()).collect();
    assert_eq!(told, ["E704", "E211", "E704"], "{:?}", copy.problems);
    // The comments hide nothing but themselves.
    let mut shown = formulas(&copy.text);
    // Words are a formula in place only.
    let without_words = |formulas: Vec<String>| -> Vec<String> {
        formulas.into_iter().filter(|formula| !formula.starts_with(r"\text{the zero")).collect()
    };
    shown = without_words(shown);
    let blank = |formula: &String| formula.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(
        without_words(formulas(&in_place.text)).iter().map(blank).collect::<Vec<_>>(),
        shown.iter().map(blank).collect::<Vec<_>>()
    );
    let options = katex::Opts::builder().output_type(katex::OutputType::Mathml).build().expect("all is set");
    for formula in formulas(&in_place.text) {
        if let Err(error) = katex::render_with_opts(&formula, &options) {
            panic!("{formula}: {error}");
        }
    }
    // Another reader of Markdown sees the same formulas.
    let html = |text: &str| {
        let mut constructs = markdown::Constructs::gfm();
        (constructs.math_flow, constructs.math_text) = (true, true);
        let parse = markdown::ParseOptions { constructs, ..markdown::ParseOptions::default() };
        let options = markdown::Options { parse, ..markdown::Options::default() };
        markdown::to_html_with_options(text, &options).expect("Markdown has no errors")
    };
    let count = |text: &str| html(text).matches("language-math").count();
    assert_eq!(count(&in_place.text), formulas(&in_place.text).len(), "{}", html(&in_place.text));
    assert_eq!(count(&copy.text), formulas(&copy.text).len(), "{}", html(&copy.text));
}

#[test]
fn figures_go_beside_the_document() {
    use polarform::weave::{Mode, Options, weave_markdown};
    let text = "```polarform picture=pictures/curve hide\nfigure_bezier(bezier([[0, 0], [1, 2], [2, 0]]))\n```\n\n\
                ```polarform\nfigure_basis(2)\nfigure_basis(3)\n```\n";
    let file = polarform::source::SourceFile::new("a.md", text);
    let options = Options { pictures: Some("a-figure".to_owned()), ..Options::default() };
    let woven = weave_markdown(&file, &options);
    let names: Vec<&str> = woven.pictures.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["pictures/curve.svg", "a-figure-1.svg", "a-figure-2.svg"]);
    assert!(woven.text.contains("![Bézier curve](pictures/curve.svg)"), "{}", woven.text);
    assert!(woven.pictures.iter().all(|(_, svg)| svg.starts_with("<svg") || svg.starts_with("<?xml")));
    let again = weave_markdown(&polarform::source::SourceFile::new("a.md", woven.text.as_str()), &options);
    assert!(again.unchanged);
    // Without a place for files the picture stands in the text.
    let inline = weave_markdown(&file, &Options { mode: Mode::Template, ..Options::default() });
    assert!(inline.text.contains("<svg") && inline.pictures.is_empty());
    for wrong in ["{{ figure_basis(2) }}\n", "```polarform picture=../up\nfigure_basis(2)\n```\n"] {
        let woven = weave_markdown(&polarform::source::SourceFile::new("a.md", wrong), &options);
        assert!(woven.failed && woven.text == wrong, "{wrong}");
    }
}
