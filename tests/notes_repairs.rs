//! Repairing pages, folders, standard input, settings.

use std::fs;

use crate::common::folder::Folder;
use crate::common::{run, run_with};

/// Ten slips, each in a paragraph of its own, with bytes that must stay.
const SLIPS: &str = "# Slips  \r\n\n\
    So $(a+b)^2  =  a^2 + 3ab + b^2$ holds.\t\n\n\
    Then $2^{10} = 1025$.\n\n\
    Then $(t+1)(t-1) = t^2 + 1$.\n\n\
    Then $\\binom{5}{2} = 11$.\n\n\
    Hence $\\sum_{i=0}^n B_i^n(t) = 2$.\n\n\
    Then $3 \\cdot 4 = 13$.\n\n\
    Then $5^2 - 4^2 = 8$ in all cases.\n\n\
    Then $\\tfrac12 + \\tfrac13 = \\tfrac15$.\n\n\
    Then $(x-y)^2 = x^2 - 2xy - y^2$.\n\n\
    Hence $(1-t)^2 + 2t(1-t) + t^2 = 0$.\n\n\
    The rest: caf\u{e9} $x$ .   ";

fn findings(path: &str) -> Vec<serde_json::Value> {
    let ran = run(&["notes", "check", path, "--report", "json"]);
    let json: serde_json::Value = serde_json::from_str(&ran.out).expect("it is JSON");
    json["files"][0]["formulas"].as_array().expect("a list").clone()
}

#[test]
fn suggestions_are_put_in_and_nothing_else_changes() {
    let folder = Folder::new("fix");
    let page = folder.write("slips.md", SLIPS);
    let wrong = |all: &[serde_json::Value]| {
        let refuted = all.iter().filter(|finding| finding["verdict"] == "refuted");
        let (with, without): (Vec<_>, Vec<_>) = refuted.partition(|finding| !finding["suggestion"].is_null());
        (with.len(), without.len())
    };
    let before = wrong(&findings(&page));
    assert_eq!(before, (10, 0), "all of them have a suggestion");
    let patch = run(&["notes", "check", &page, "--diff"]);
    assert_eq!(patch.status, Some(1), "{}", patch.err);
    assert!(
        patch.out.starts_with("--- a/") && patch.out.contains("\n+So $(a+b)^2  =  a^2 + 2ab + b^2$"),
        "{}",
        patch.out
    );
    assert_eq!(fs::read_to_string(&page).expect("it is there"), SLIPS, "--diff writes nothing");

    run(&["notes", "check", &page, "--fix"]);
    let after = fs::read_to_string(&page).expect("it is there");
    assert_eq!(wrong(&findings(&page)), (0, 0), "{after}");
    // Line by line, only what stands between the dollars differs.
    assert_eq!(after.matches('\n').count(), SLIPS.matches('\n').count());
    for (old, new) in SLIPS.split('\n').zip(after.split('\n')) {
        let outside = |line: &str| -> Vec<String> { line.split('$').step_by(2).map(str::to_owned).collect() };
        assert_eq!(outside(old), outside(new));
    }
    let again = run(&["notes", "check", &page, "--fix"]);
    assert!(again.err.contains("0 changes"), "{}", again.err);
    assert_eq!(fs::read_to_string(&page).expect("it is there"), after);
}

#[test]
fn folders_and_standard_input() {
    let folder = Folder::new("folders");
    folder.write("a.md", "$1 + 1 = 2$\n");
    fs::create_dir_all(folder.path("deep/.hidden")).expect("it can be made");
    folder.write("deep/b.rst", ":math:`2 + 2 = 4`\n");
    folder.write("deep/.hidden/c.md", "$1 = 2$\n");
    folder.write("deep/d.typ", "$ 1 = 2 $");
    let ran = run(&["notes", "check", &folder.path("")]);
    assert_eq!(ran.status, Some(0), "{}{}", ran.out, ran.err);
    assert!(
        ran.out.contains("a.md") && ran.out.contains("b.rst") && !ran.out.contains("c.md"),
        "{}",
        ran.out
    );

    let ask = |arguments: &[&str], page: &str| {
        let ran = run_with(arguments, page.as_bytes());
        (ran.status, ran.out)
    };
    assert_eq!(ask(&["notes", "check", "-"], "$1 + 1 = 3$").0, Some(1));
    let latex = "\\documentclass{article}\\begin{document}$1 + 1 = 2$\\end{document}";
    let (status, out) = ask(&["notes", "check", "-"], latex);
    assert!(status == Some(0) && out.contains("1 claim: 1 proved"), "{out}");
    let (status, out) = ask(&["notes", "check", "-", "--as", "rst"], ":math:`1 + 1 = 2`");
    assert!(status == Some(0) && out.contains("1 claim: 1 proved"), "{out}");
    assert_eq!(ask(&["notes", "check", "-", "--fix"], "$1 = 2$").0, Some(2));
}

#[test]
fn settings_and_what_is_known() {
    let folder = Folder::new("settings");
    let page = folder.write("a.md", "Then $1 + 1 = 3$.\n");
    let known = folder.path("known.json");
    let ran = run(&["notes", "check", &page, "--write-baseline", &known]);
    assert_eq!(ran.status, Some(1), "{}", ran.err);
    let config = folder.write("polarform.toml", "[notes]\nbaseline = \"known.json\"\n");
    let ran = run(&["notes", "check", &page, "--config", &config]);
    assert_eq!(ran.status, Some(0), "{}", ran.out);
    assert!(ran.err.contains("1 finding not reported"), "{}", ran.err);
    // What is new is reported, also when lines move.
    folder.write("a.md", "New: $2 + 2 = 5$.\n\nThen $1 + 1 = 3$.\n");
    let ran = run(&["notes", "check", &page, "--config", &config]);
    assert!(ran.status == Some(1) && ran.out.contains("1 refuted"), "{}", ran.out);

    folder.write("polarform.toml", "[notes]\nignore = [\"refuted\"]\n");
    assert_eq!(run(&["notes", "check", &page, "--config", &config]).status, Some(0));
    folder.write("polarform.toml", "[notes]\nignore = [\"nothing\"]\n");
    let ran = run(&["notes", "check", &page, "--config", &config]);
    assert!(ran.status == Some(2) && ran.err.contains("'nothing' is no rule"), "{}", ran.err);
}

#[test]
fn a_page_of_which_no_formula_is_read_is_an_error() {
    let folder = Folder::new("unread-page");
    for text in ["Then \\frac12 is half.\n", "Then $a \\foo{b} = c$.\n"] {
        let page = folder.write("a.md", text);
        let ran = run(&["notes", "check", &page]);
        assert_eq!(ran.status, Some(2), "{}{}", ran.out, ran.err);
        assert!(ran.err.contains("none of its formulas"), "{}", ran.err);
    }
    let page = folder.write("a.md", "Words only.\n");
    assert_eq!(run(&["notes", "check", &page]).status, Some(0));
}
