//! What stands around the program for other programs: the filter for Pandoc, the action for GitHub, the bundle for TeX,
//! hooks. Where another program is not there, its test says so.

use std::path::Path;
use std::process::Command;

use crate::common::folder::Folder;

fn root(path: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path).display().to_string()
}

fn program() -> &'static str {
    env!("CARGO_BIN_EXE_polarform")
}

/// Whether a program can be run; if not, that is said.
#[expect(clippy::print_stderr, reason = "a test that was left out is told")]
fn finds(name: &str) -> bool {
    let found = Command::new(name).arg("--version").output().is_ok_and(|ran| ran.status.success());
    if !found {
        eprintln!("{name} is not there: a test of it was left out");
    }
    found
}

struct Ran {
    fine: bool,
    out: String,
    err: String,
}

fn ran(command: &mut Command) -> Ran {
    let output = command.output().expect("it starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it is text");
    Ran { fine: output.status.success(), out: text(output.stdout), err: text(output.stderr) }
}

fn pandoc(folder: &Folder, page: &str, format: &str) -> Ran {
    let file = folder.write("page.md", page);
    let filter = root("pandoc/polarform.lua");
    let mut command = Command::new("pandoc");
    command.args([&file, "--lua-filter", &filter, "-t", format]).env("POLARFORM", program());
    ran(command.current_dir(folder.path(".")))
}

#[test]
fn the_filter_for_pandoc_puts_results_in() {
    if !finds("pandoc") {
        return;
    }
    let folder = Folder::new("pandoc");
    let page = "# 设\n\nLet `f := polar(t^2 + 2t)`{.polarform} be one, so\n$f(0,1) = {{ f(0, 1) }}$, and\n\n\
        $$ f(1/2, 1/2) = {{ f(1/2, 1/2) }}. $$\n\n```{.polarform style=table}\nf(2, 2)\nf(3, 3)\n```\n\n\
        > - `f(0, 2)`{.polarform}; `f(0, 0)` and $a = 1$ stay, `{{ f }}` too.\n\n```python\n{{ f }}\n```\n";
    let made = pandoc(&folder, page, "latex");
    assert!(made.fine, "{}", made.err);
    for part in [
        r"\(f(t_1, t_2) = t_1 t_2 + (t_1 + t_2)\)",
        r"\(f(0,1) = 1\)",
        r"f(1/2, 1/2) = \frac{5}{4}.",
        r"\(8\)",
        r"\(15\)",
        r"\texttt{f(0,\ 0)}",
        r"\(a = 1\)",
        r"\texttt{\{\{\ f\ \}\}}",
    ] {
        assert!(made.out.contains(part), "{part}: {}", made.out);
    }
    // Pictures: in the text of HTML, files elsewhere.
    let picture = "```polarform\nfigure_basis(1)\n```\n";
    assert!(pandoc(&folder, picture, "html").out.contains("<svg"));
    let made = pandoc(&folder, picture, "latex");
    assert!(made.out.contains("\\includegraphics") && made.out.contains(".svg"), "{}", made.out);
    // A page without queries is left alone; a query that fails ends it with its place.
    let plain = "Words $a = 1$ and *more*.\n";
    assert_eq!(pandoc(&folder, plain, "markdown").out, plain);
    let failed = pandoc(&folder, "`1/0`{.polarform}\n", "html");
    assert!(!failed.fine && failed.err.contains("division by zero"), "{}", failed.err);
}

/// The lines of the script of a step of the action.
fn script(action: &str, name: &str) -> String {
    let step = action.split("- name: ").find(|step| step.starts_with(name)).expect("there is such a step");
    let (_, script) = step.split_once("run: |\n").expect("it runs something");
    script
        .lines()
        .take_while(|line| line.starts_with("        "))
        .map(|line| line.trim_start().to_owned() + "\n")
        .collect()
}

#[test]
fn the_action_checks_files() {
    if !finds("bash") {
        return;
    }
    let folder = Folder::new("action");
    let action = std::fs::read_to_string(root("action.yml")).expect("it is there");
    std::fs::create_dir_all(folder.path("temp/polarform/bin")).expect("the folder is writable");
    folder.write("a.md", "Now $2 + 2 = 5$.\n");
    folder.write("b.md", "Now $2 + 2 = 4$.\n");
    let installed = folder.path("temp/polarform/bin/polarform");
    std::fs::copy(program(), &installed).expect("it can be copied");
    let run = |step: &str, files: &str, arguments: &str| {
        let mut bash = Command::new("bash");
        bash.args(["-e", "-c", &script(&action, step)]).current_dir(folder.path("."));
        bash.env("RUNNER_TEMP", folder.path("temp")).env("FILES", files).env("ARGUMENTS", arguments);
        ran(&mut bash)
    };
    // What is built already is not built again: there is no folder to build from here.
    assert!(run("Build", "", "").fine);
    let wrong = run("Check", "a.md b.md", "");
    assert!(!wrong.fine && wrong.out.starts_with("::error file=a.md,line=1,"), "{}", wrong.out);
    let fine = run("Check", "b.md", "--verbose");
    assert!(fine.fine, "{}{}", fine.out, fine.err);
}

#[test]
fn the_bundle_for_tex_has_the_same_package() {
    if !finds("pdflatex") || !finds("python3") {
        return;
    }
    let folder = Folder::new("tex-bundle");
    let made = ran(Command::new("bash").args([&root("tex/build"), &folder.path("out")]));
    assert!(made.fine, "{}{}", made.out, made.err);
    let package = folder.read("out/polarform.sty");
    assert!(
        package.contains("\\ProvidesPackage{polarform}") && package.contains("generated with the docstrip"),
        "{package}"
    );
    // A document compiles with it, and shows the results that the program wrote.
    folder.write(
        "out/paper.tex",
        "\\documentclass{article}\\usepackage{polarform}\\begin{document}$\\polarform{1 + 1}$\\end{document}",
    );
    let woven = ran(Command::new(program()).args(["weave", "--quiet", &folder.path("out/paper.tex")]));
    assert!(woven.fine, "{}", woven.err);
    let set = ran(Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "paper.tex"])
        .current_dir(folder.path("out")));
    assert!(set.fine && !set.out.contains("polarform Warning"), "{}", set.out);
}

#[test]
fn hooks_name_commands_that_there_are() {
    let hooks = std::fs::read_to_string(root(".pre-commit-hooks.yaml")).expect("it is there");
    let entries: Vec<&str> =
        hooks.lines().filter_map(|line| line.trim().strip_prefix("entry: polarform ")).collect();
    assert_eq!(entries.len(), 2);
    for entry in entries {
        let folder = Folder::new("hooks");
        let page = folder.write("a.md", "Now $2 + 2 = 4$.\n");
        let fine = ran(Command::new(program()).args(entry.split(' ')).arg(&page));
        assert!(fine.fine && fine.out.is_empty(), "{entry}: {}{}", fine.out, fine.err);
    }
}
