//! The documentation is run: every console example gives the output it shows, every example
//! of the function table works, every picture is as its command draws it, the function reference
//! is up to date, and links lead somewhere.
//!
//! `UPDATE_DOCS=1 cargo test --test main docs::` writes the outputs and the reference anew.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use polarform::functions::{BUILTINS, Gives, Parameter, Takes};
use polarform::session::Session;
use polarform::value::{Value, Verdict};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// README.md, CONTRIBUTING.md, CHANGELOG.md and docs/*.md.
fn pages() -> Vec<PathBuf> {
    let mut pages = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root().join(name)).to_vec();
    for entry in fs::read_dir(root().join("docs")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "md") {
            pages.push(path);
        }
    }
    pages.sort();
    pages
}

/// The words of a command line: blanks separate, '…' is literal, "…" and \ work as in a shell.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote: Option<char> = None;
    let mut rest = line.chars().peekable();
    while let Some(c) = rest.next() {
        match (quote, c) {
            (Some(q), _) if c == q => quote = None,
            (Some('"'), '\\') if rest.peek().is_some_and(|next| "\"\\$`".contains(*next)) => {
                word.get_or_insert_default().extend(rest.next());
            }
            (Some(_), _) => word.get_or_insert_default().push(c),
            (None, '\'' | '"') => {
                word.get_or_insert_default();
                quote = Some(c);
            }
            (None, '\\') => word.get_or_insert_default().extend(rest.next()),
            (None, _) if c.is_whitespace() => words.extend(word.take()),
            (None, _) => word.get_or_insert_default().push(c),
        }
    }
    assert!(quote.is_none(), "unbalanced quotes: {line}");
    words.extend(word);
    words
}

#[test]
fn words_are_split_as_a_shell_does() {
    assert_eq!(words(r#"a "b c"  'd"e' "" f\ g"#), ["a", "b c", "d\"e", "", "f g"]);
    assert_eq!(words(r#""\frac{1}{2}" "\"x\"" '\alpha'"#), [r"\frac{1}{2}", "\"x\"", r"\alpha"]);
}

/// Runs one command of a console example; gives what it prints, errors last, and its status.
///
/// `polarform …`, also as `cargo run --release -- …`, may read a file with `< FILE`;
/// `echo $?` shows the status of the command before.
fn output(line: &str, status: i32) -> (String, i32) {
    if line == "echo $?" {
        return (format!("{status}\n"), 0);
    }
    let words = words(line);
    let mut arguments: Vec<&str> = words.iter().map(String::as_str).collect();
    if let Some(rest) = arguments.strip_prefix(&["cargo", "run", "--release", "--"]) {
        arguments = rest.to_vec();
    } else if arguments.first() == Some(&"polarform") {
        arguments.remove(0);
    } else {
        panic!("not a command of ours: {line}");
    }
    // A picture of the page: made elsewhere, then compared with the one that is there.
    let drawing = arguments.iter().position(|word| *word == "-o").map(|i| i + 1);
    let drawing = drawing.filter(|&i| arguments.get(i).is_some_and(|path| path.starts_with("docs/figures/")));
    let shown_at = drawing.map(|i| root().join(arguments[i]));
    let made_at = tempfile::Builder::new().suffix(".svg").tempfile().expect("there is room for a picture");
    let made_name = made_at.path().to_str().expect("temporary files have plain names");
    if let Some(i) = drawing {
        arguments[i] = made_name;
    }
    let mut input = Stdio::null();
    if let [.., "<", file] = arguments[..] {
        input = fs::File::open(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}")).into();
        arguments.truncate(arguments.len() - 2);
    }
    let ran = Command::new(env!("CARGO_BIN_EXE_polarform"))
        .args(&arguments)
        .current_dir(root())
        .stdin(input)
        .output()
        .expect("the binary was built for this test");
    if let Some(path) = shown_at {
        settle(&path, &read(made_at.path()));
    }
    let mut shown = String::from_utf8(ran.stdout).unwrap();
    shown.push_str(&String::from_utf8(ran.stderr).unwrap());
    (shown, ran.status.code().unwrap_or(-1))
}

/// The page with the outputs in its `console` blocks replaced by the true ones.
fn filled(page: &str) -> String {
    let mut result = String::with_capacity(page.len());
    let mut lines = page.lines().peekable();
    let mut inside = false;
    let mut status = 0;
    while let Some(line) = lines.next() {
        result.push_str(line);
        result.push('\n');
        if line == "```console" {
            inside = true;
        } else if line.starts_with("```") {
            inside = false;
        } else if inside {
            let Some(command) = line.strip_prefix("$ ") else { panic!("output before a command: {line}") };
            let mut command = command.to_owned();
            while let Some(start) = command.strip_suffix('\\') {
                let next = lines.next().expect("a continued line goes on");
                result.push_str(next);
                result.push('\n');
                command = start.to_owned() + next.strip_prefix("> ").expect("continuations start with '> '");
            }
            while lines.next_if(|next| !next.starts_with("$ ") && *next != "```").is_some() {}
            let (shown, code) = output(&command, status);
            status = code;
            result.push_str(&shown);
        }
    }
    result
}

/// Compares, or writes when UPDATE_DOCS is set.
fn settle(path: &Path, right: &str) {
    if std::env::var_os("UPDATE_DOCS").is_some() {
        if fs::read_to_string(path).ok().as_deref() != Some(right) {
            fs::write(path, right).unwrap();
        }
        return;
    }
    let shown = read(path);
    for (i, (is, should)) in shown.lines().zip(right.lines()).enumerate() {
        assert_eq!(is, should, "{}:{} (UPDATE_DOCS=1 renews it)", path.display(), i + 1);
    }
    assert_eq!(shown, right, "{} (UPDATE_DOCS=1 renews it)", path.display());
}

#[test]
fn console_examples_show_what_happens() {
    for page in pages() {
        if !page.ends_with("functions.md") {
            settle(&page, &filled(&read(&page)));
        }
    }
}

#[test]
fn the_function_reference_is_up_to_date() {
    let mut page = String::from(
        "# Functions\n\n\
         Written from the table in `src/language/functions/`, which is also behind `polarform functions`; \
         to renew it: `UPDATE_DOCS=1 cargo test --test main docs::`. \
         An argument may be given by its name wherever one is shown: `elevate(f, k=2)` is `elevate(f, 2)`. \
         What has a notation of its own (`sum`, `prod`, `hat`, `abs`, …) is in [language.md](language.md).\n",
    );
    let mut topic = "";
    for builtin in BUILTINS {
        if builtin.topic != topic {
            topic = builtin.topic;
            write!(page, "\n## {topic}\n").unwrap();
        }
        let (name, signature, summary) = (builtin.name, builtin.signature(), builtin.summary);
        assert!(!builtin.example.contains(['"', '\\', '$', '`']), "{name}: the example needs no quoting");
        let gives = given(builtin.gives, " Gives ", ".");
        write!(page, "\n### {name}\n`{signature}`: {summary}.{gives}\n\n").unwrap();
        list(&mut page, "", builtin.parameters.iter().chain(builtin.common));
        for (form, variant) in builtin.other_forms() {
            let gives = given(variant.gives, ", ", "");
            writeln!(page, "- for {}: `{form}`{gives}", of_what(variant.parameters)).unwrap();
            list(&mut page, "  ", variant.parameters.iter().skip(1));
        }
        for subject in builtin.subjects {
            writeln!(page, "- `{}`: {}", subject.signature(), subject.summary).unwrap();
            list(&mut page, "  ", subject.parameters);
        }
        write!(page, "\n```console\n$ polarform eval \"{}\"\n```\n", builtin.example).unwrap();
    }
    settle(&root().join("docs/functions.md"), &filled(&page));
}

/// What a function gives, where that can be said.
fn given(gives: Gives, before: &str, after: &str) -> String {
    let known = (gives != Gives::Any).then(|| gives.description());
    known.map_or_else(String::new, |what| format!("{before}{what}{after}"))
}

/// A small list of parameters.
fn list<'a>(page: &mut String, indent: &str, parameters: impl IntoIterator<Item = &'a Parameter>) {
    for parameter in parameters {
        writeln!(page, "{indent}- `{}`: {}", parameter.called(), parameter.explanation()).unwrap();
    }
}

/// A curve or surface, in words.
fn of_what(parameters: &[Parameter]) -> String {
    parameters.first().map_or_else(String::new, |first| match first.kind {
        Takes::Curve => "a curve".to_owned(),
        kind => kind.description().into_owned(),
    })
}

#[test]
fn the_list_of_latex_commands_is_up_to_date() {
    let mut page = String::from(
        "# LaTeX that can be read\n\n\
         Written from the table in `src/language/latex/commands.rs`; to renew it: `UPDATE_DOCS=1 cargo test --test main docs::`. \
         Formulas are read as they stand between dollars; text with a command such as `\\frac` or with a `$` \
         counts as LaTeX everywhere a formula is expected:\n\
         ```console\n$ polarform eval '\\frac{5}{3}(t_1 + t_2)' 'f := polar(t^3)' 'f(t, t, \\hat{1})'\n```\n",
    );
    let mut groups: Vec<&str> = Vec::new();
    for command in polarform::latex::commands() {
        if !groups.contains(&command.group()) {
            groups.push(command.group());
        }
    }
    for group in groups {
        write!(page, "\n## {}\n| command | meaning |\n| --- | --- |\n", capitalized(group)).unwrap();
        for command in polarform::latex::commands().iter().filter(|command| command.group() == group) {
            let meaning = command.meaning().replace('|', "\\|");
            writeln!(page, "| `\\{}` | {meaning} |", command.name().replace('|', "\\|")).unwrap();
        }
    }
    page.push_str("\n## Environments\n| environment | meaning |\n| --- | --- |\n");
    for (name, meaning) in polarform::latex::environments() {
        writeln!(page, "| `{name}` | {meaning} |").unwrap();
    }
    settle(&root().join("docs/latex.md"), &filled(&page));
}

fn capitalized(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

#[test]
fn every_example_of_the_table_runs() {
    for builtin in BUILTINS {
        let answer = Session::default().run(builtin.example);
        let answer = answer.unwrap_or_else(|failure| {
            panic!("{}: {}: {}", builtin.name, builtin.example, failure.problem.message)
        });
        if let Value::Claim(claim) = &answer.outcome.value {
            assert_eq!(claim.verdict(), Verdict::Proved, "{}", builtin.example);
        }
    }
}

#[test]
fn links_lead_somewhere() {
    for page in pages() {
        let text = read(&page);
        for piece in text.split("](").skip(1) {
            let target = piece.split([')', '#', '\n']).next().unwrap_or("");
            if !target.is_empty() && !target.contains("://") {
                let path = page.parent().unwrap().join(target);
                assert!(path.exists(), "{} links to {target}", page.display());
            }
        }
    }
}
