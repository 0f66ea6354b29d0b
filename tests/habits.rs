//! What programs of the shell are expected to do: completions, manual pages, standard input, folders, settings, quiet
//! runs, reports for other programs.

use std::collections::BTreeSet;
use std::fs;

use roxmltree::Document;

use crate::common::folder::Folder;
use crate::common::{command, run, run_with};

/// The commands, as the help lists them.
fn commands() -> Vec<String> {
    let help = run(&["--help"]).out;
    let lines =
        help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names =
        lines.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").map(str::to_owned).collect()
}

#[test]
fn completions_know_commands_options_and_values() {
    let commands = commands();
    assert!(commands.len() > 15, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let ran = run(&["completions", shell]);
        assert_eq!((ran.status, ran.err.as_str()), (Some(0), ""));
        let options = ["quiet", "max-terms", "report"];
        // Two of the shells are told no values.
        let values = ["laguerre", "sarif", "in_bernstein", "zh"];
        let values = if matches!(shell, "elvish" | "powershell") { &[][..] } else { &values };
        for word in commands.iter().map(String::as_str).chain(options).chain(values.iter().copied()) {
            assert!(ran.out.contains(word), "{shell}: {word}");
        }
    }
    assert_eq!(run(&["completions", "cmd"]).status, Some(2));
}

#[test]
fn manual_pages() {
    let folder = Folder::new("man");
    let target = folder.path("man1");
    let ran = run(&["man", "-o", &target]);
    assert_eq!((ran.status, ran.out.as_str()), (Some(0), ""), "{}", ran.err);
    let pages: BTreeSet<String> = fs::read_dir(&target)
        .expect("it is made")
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    for name in commands() {
        assert!(pages.contains(&format!("polarform-{name}.1")), "{name}: {pages:?}");
    }
    assert!(pages.contains("polarform.1") && pages.contains("polarform-notes-check.1"), "{pages:?}");
    for name in &pages {
        let page = folder.read(&format!("man1/{name}"));
        for part in [".TH ", ".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS"] {
            assert!(page.contains(part), "{name}: {part}");
        }
        // Each page is also printed by itself.
        let words = name.trim_end_matches(".1").split('-').skip(1);
        let printed = run(&[&["man"], words.collect::<Vec<_>>().as_slice()].concat());
        assert_eq!(printed.out, page, "{name}");
    }
    let wrong = run(&["man", "notes", "chek"]);
    assert!(wrong.status == Some(2) && wrong.err.contains("did you mean 'check'?"), "{}", wrong.err);
    let blocked = folder.write("file", "");
    assert!(run(&["man", "-o", &blocked]).err.contains("E501"));
}

#[test]
fn a_formula_from_standard_input() {
    for (arguments, input, out) in [
        (&["polar", "-"][..], "t^2\n", "f(t1, t2) = t1 t2\n"),
        (&["eval", "-"], "a := 2\na + 1\n", "a = 2\n3\n"),
        (&["eval", "a := 2", "-"], "a + 1", "a = 2\n3\n"),
        (&["check", "-"], "1 + 1 = 2", "proved\n"),
        (&["product", "t", "-"], "t", "h(t1, t2) = t1 t2\n"),
        (&["interpolate", "--nodes", "0,1", "--values", "-"], "1, 3", "p(t) = 2 t + 1\n"),
        (&["bezier", "[0, 0], [2, 4]", "--at", "-"], "1/2", "(1, 2)\n"),
        (&["bezier", "-", "--at", "1/2"], "[0, 0], [2, 4]", "(1, 2)\n"),
    ] {
        let ran = run_with(arguments, input.as_bytes());
        assert_eq!((ran.out.as_str(), ran.status), (out, Some(0)), "{arguments:?}: {}", ran.err);
    }
    let drawn = run_with(&["figure", "bezier", "-"], b"[0, 0], [1, 2], [2, 0]");
    assert!(drawn.out.starts_with("<svg"), "{}", drawn.err);
    // It is shown where the formula is wrong, as always.
    let wrong = run_with(&["polar", "-"], b"t^2\n + / 2");
    assert!(wrong.status == Some(2) && wrong.err.contains("<polynomial>:"), "{}", wrong.err);
    for (arguments, input) in
        [(&["sum", "-", "-"][..], &b"t"[..]), (&["polar", "-"], b""), (&["polar", "-"], b"\xff")]
    {
        let ran = run_with(arguments, input);
        assert!(ran.status == Some(2) && ran.out.is_empty() && ran.err.contains("'-'"), "{}", ran.err);
    }
}

#[test]
fn weaving_from_standard_input_and_in_folders() {
    let page = "$f = {{ 1/2 + 1/2 }}$\n";
    let ran = run_with(&["weave", "-"], page.as_bytes());
    assert_eq!(ran.status, Some(0), "{}", ran.err);
    assert!(ran.out.starts_with("$f = 1"), "{}", ran.out);
    // What it gave is up to date, what it was given is not.
    assert_eq!(run_with(&["weave", "-", "--check"], ran.out.as_bytes()).status, Some(0));
    assert_eq!(run_with(&["weave", "-", "--check", "-q"], page.as_bytes()).status, Some(1));
    assert_eq!(run_with(&["weave", "-", "-o", "-"], page.as_bytes()).out, "$f = 1$\n");
    assert_eq!(run_with(&["weave", "-"], b"$ {{ 1/0 }} $\n").status, Some(2));
    for (arguments, input) in [
        (&["weave", "-", "--as", "rst"][..], page),
        (&["weave", "-", "-o", "a.md"], page),
        (&["weave", "-", "--check"], r"\documentclass{a}"),
    ] {
        let ran = run_with(arguments, input.as_bytes());
        assert!(
            ran.status == Some(2) && ran.out.is_empty() && ran.err.contains("help"),
            "{arguments:?}: {}",
            ran.err
        );
    }

    // Markdown that shows a document of LaTeX is no LaTeX, what begins with comments may be.
    let shows = format!("{page}\n```latex\n\\begin{{document}}\n\\end{{document}}\n```\n");
    assert!(run_with(&["weave", "-", "-o", "-"], shows.as_bytes()).out.starts_with("$f = 1$\n"));
    let paper = "% a paper\n\n\\documentclass{a}\n\\begin{document}\n\\(2 + 2 = 5\\)\n\\end{document}\n";
    assert!(run_with(&["notes", "check", "-"], paper.as_bytes()).out.contains("1 refuted"));
    // What LaTeX reads goes to standard output.
    let paper = paper.replace("= 5", r"= \polarform{2 + 2}");
    let ran = run_with(&["weave", "-"], paper.as_bytes());
    assert!(ran.status == Some(0) && ran.out.contains("{2 + 2}{4}"), "{}{}", ran.out, ran.err);

    let folder = Folder::new("folder");
    fs::create_dir_all(folder.path("book/drafts")).expect("it can be made");
    for (name, text) in
        [("a.md", page), ("drafts/b.md", page), ("c.rst", page), ("part.tex", r"\polarform{1}")]
    {
        folder.write(&format!("book/{name}"), text);
    }
    folder.write("polarform.toml", "[notes]\nexclude = [\"book/drafts\"]\n");
    let weave = |arguments: &[&str]| {
        let output =
            command(&[&["weave"], arguments].concat()).current_dir(&folder.0).output().expect("it runs");
        (String::from_utf8_lossy(&output.stdout).into_owned(), output.status.code())
    };
    assert_eq!(weave(&["book", "--check"]), ("book/a.md: 1 result, 1 out of date\n".to_owned(), Some(1)));
    assert_eq!(weave(&["book", "-q"]), (String::new(), Some(0)));
    assert!(folder.read("book/a.md").starts_with("$f = 1"));
    assert_eq!(folder.read("book/drafts/b.md"), page);
    assert_eq!(folder.files().len(), 2);
}

#[test]
fn standard_input_and_output_of_a_check() {
    let folder = Folder::new("standard");
    let page = folder.write("a.md", "So $s + 1 = 3$ and $\\two = 2$.\n");
    let context = run_with(&["notes", "check", &page, "--context", "-"], b"s := 2");
    assert!(context.out.contains("1 proved"), "{}{}", context.out, context.err);
    let macros = run_with(&["notes", "check", &page, "--macros", "-"], b"\\newcommand{\\two}{2}");
    assert!(macros.out.contains("1 proved"), "{}{}", macros.out, macros.err);
    let html = run_with(&["notes", "check", &page, "--report", "html", "-o", "-"], b"");
    assert!(html.out.starts_with("<!DOCTYPE html>") && !folder.files().iter().any(|name| name == "-"));
    // It can be read once.
    for arguments in [
        &["notes", "check", "-", "--context", "-"][..],
        &["notes", "check", &page, "--context", "-", "--macros", "-"],
    ] {
        let ran = run_with(arguments, b"s := 2");
        assert!(ran.status == Some(2) && ran.err.contains("read once"), "{}{}", ran.out, ran.err);
    }
    let drawn = run(&["figure", "basis", "2", "--format", "svg", "-o", "-"]);
    assert!(drawn.out.starts_with("<svg"), "{}", drawn.err);
}

#[test]
fn a_folder_of_scripts() {
    let folder = Folder::new("scripts");
    folder.write("b.polar", "a + 1\n");
    folder.write("a.polar", "a := 1\na\n");
    folder.write("c.txt", "nothing\n");
    let ran = run(&["run", &folder.path("")]);
    // Each has a session of its own: what the first defines the second does not know.
    let lines: Vec<&str> = ran.out.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(lines, ["a = 1", "1", "a + 1"], "{}", ran.err);
    let empty = Folder::new("no-scripts");
    let ran = run(&["run", &empty.path("")]);
    assert!(
        ran.status == Some(2) && ran.err.contains("has no scripts") && ran.err.contains(".polar"),
        "{}",
        ran.err
    );
}

/// A page with a wrong, a true, an unread and a strange formula.
const PAGE: &str = "# A\n\nThus $2 + 2 = 5$, $2 + 2 = 4$\nand $x \\bowtie y = 1$.\n\nAlso $$\n\\begin{aligned} 1 + 1\n&= 3\\end{aligned}\n$$\n";

#[test]
fn quiet_runs_tell_only_what_is_wrong() {
    let folder = Folder::new("quiet");
    let (good, bad) =
        (folder.write("good.md", "$1 + 1 = 2$ and $x \\bowtie y$\n"), folder.write("bad.md", PAGE));
    let ran = run(&["notes", "check", "-q", &good]);
    assert_eq!((ran.out.as_str(), ran.err.as_str(), ran.status), ("", "", Some(0)));
    let ran = run(&["notes", "check", "--quiet", &good, &bad]);
    assert_eq!((ran.out.matches("refuted:").count(), ran.status), (2, Some(1)), "{}", ran.out);
    assert!(!ran.out.contains("claims") && !ran.out.contains("good.md"), "{}", ran.out);
    let target = folder.path("a.json");
    assert_eq!(run(&["notes", "check", "-q", &good, "-o", &target]).out, "");
    for (arguments, out, status) in [
        (&["check", "1 = 1", "-q"][..], "", 0),
        (&["eval", "1 = 1", "1 + 1", "-q"], "2\n", 0),
        (&["check", "x > 0", "-q"], "undecided", 2),
        (&["check", "1 = 2", "-q"], "refuted", 1),
    ] {
        let ran = run(arguments);
        assert!(
            ran.out.starts_with(out) && (!out.is_empty() || ran.out.is_empty()),
            "{arguments:?}: {}",
            ran.out
        );
        assert_eq!((ran.status, ran.err.as_str()), (Some(status), ""), "{arguments:?}");
    }
    assert_eq!(run(&["notes", "check", "-q", "-v", &good]).status, Some(2));
}

#[test]
fn annotations_of_github() {
    let folder = Folder::new("github");
    folder.write("a, 50%.md", PAGE);
    let check = |arguments: &[&str]| {
        let all = [&["notes", "check", "./a, 50%.md", "--report", "github"], arguments].concat();
        let output = command(&all).current_dir(&folder.0).output().expect("it runs");
        String::from_utf8(output.stdout).expect("it is text")
    };
    let out = check(&[]);
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines.len(), 3, "{out}");
    assert!(
        lines[0].starts_with(
            "::error file=a%2C 50%25.md,line=3,endLine=3,col=7,endColumn=16,title=polarform%3A refuted::refuted: left"
        ),
        "{out}"
    );
    assert!(lines[0].contains("%0Asuggestion: 2 + 2 = 4"), "{out}");
    // Columns are told of places within one line only.
    assert!(lines[1].starts_with("::error file=a%2C 50%25.md,line=7,endLine=8,title="), "{out}");
    assert_eq!(lines[2], "polarform: 4 claims: 2 refuted, 1 proved, 1 unread");
    assert_eq!(check(&["-v"]).matches("::notice ").count(), 1);
}

#[test]
fn results_of_tests_for_junit() {
    let folder = Folder::new("junit");
    let strange = "$2 + 2 = 5$ & <b> $1 \u{1b}= \\text{\"x\u{0}\"}$\n";
    let files = [folder.write("a.md", PAGE), folder.write("b.md", strange), folder.path("missing.md")];
    // A claim is named as it is written, with the sizes of its brackets.
    let sized = run_with(&["notes", "check", "-", "--report", "junit"], br"$x = \Bigl(1 + x\Bigr)$");
    assert!(sized.out.contains(r#"name="1:2 x = \Bigl(1 + x\Bigr)""#), "{}", sized.out);
    let target = folder.path("report.xml");
    let ran = run(&["notes", "check", &files[0], &files[1], &files[2], "-o", &target]);
    assert_eq!(ran.status, Some(1), "{}", ran.err);
    let text = folder.read("report.xml");
    let xml = Document::parse(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    let number = |node: roxmltree::Node, name: &str| {
        node.attribute(name)
            .and_then(|text| text.parse::<usize>().ok())
            .unwrap_or_else(|| panic!("{name}: {text}"))
    };
    let root = xml.root_element();
    let suites: Vec<_> = root.children().filter(|node| node.has_tag_name("testsuite")).collect();
    assert_eq!(suites.len(), 3, "{text}");
    // The numbers are those of the elements, which a reader of the file adds up.
    for (name, element) in
        [("tests", "testcase"), ("failures", "failure"), ("errors", "error"), ("skipped", "skipped")]
    {
        for suite in &suites {
            let found = suite.descendants().filter(|node| node.has_tag_name(element)).count();
            assert_eq!(number(*suite, name), found, "{name}: {text}");
        }
        assert_eq!(number(root, name), suites.iter().map(|suite| number(*suite, name)).sum::<usize>());
    }
    assert_eq!((number(suites[0], "tests"), number(suites[0], "failures")), (4, 2), "{text}");
    assert_eq!(number(suites[2], "errors"), 1, "{text}");
    let first = suites[0].children().find(|node| node.has_tag_name("testcase")).expect("there are claims");
    assert_eq!((first.attribute("line"), first.attribute("name")), (Some("3"), Some("3:7 2 + 2 = 5")));
}

#[test]
fn settings_name_files_and_macros() {
    let folder = Folder::new("settings");
    fs::create_dir(folder.path("pages")).expect("it can be made");
    folder.write("pages/a.md", "$\\twice{1} = 3$, $\\twice{1} = 2$\n");
    folder.write("macros.tex", "\\newcommand{\\twice}[1]{2 \\cdot #1}\n");
    let check = |arguments: &[&str]| {
        let output = command(&[&["notes", "check"], arguments].concat())
            .current_dir(&folder.0)
            .output()
            .expect("it runs");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (text(&output.stdout), text(&output.stderr), output.status.code())
    };
    let (_, err, status) = check(&[]);
    assert!(status == Some(2) && err.contains("[notes] files"), "{err}");
    let (out, _, status) = check(&["pages"]);
    assert!(status == Some(2) && out.contains("2 unread"), "{out}");
    let given = check(&["pages", "--macros", "macros.tex"]);
    assert!(given.2 == Some(1) && given.0.contains("1 refuted, 1 proved"), "{given:?}");
    folder.write("polarform.toml", "[notes]\nfiles = [\"pages\"]\nmacros = \"macros.tex\"\n");
    assert_eq!(check(&[]), given);
    assert!(given.0.contains(" --> pages/a.md:1:"), "{given:?}");
    folder.write("polarform.toml", "[notes]\nfile = [\"pages\"]\n");
    let (_, err, status) = check(&["pages"]);
    assert!(status == Some(2) && err.contains("polarform.toml:2:1") && err.contains("'files'?"), "{err}");
    let (_, err, status) = check(&["pages", "--config", "none.toml"]);
    assert!(status == Some(2) && err.contains("none.toml"), "{err}");
}
