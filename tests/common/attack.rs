//! One input for everything that reads it: nothing may panic, hang or answer with an internal error.
//!
//! Both the random tests (`tests/fuzz.rs`) and the targets guided by coverage (`fuzz/`) come here.

use std::time::{Duration, Instant};

use polarform::budget::{self, Limits};
use polarform::diagnostic::{Code, Diagnostic, render};
use polarform::document::{Container, Macros, read_text};
use polarform::notes::report::{
    TextOptions, fixed, fixes, render_github, render_html, render_json, render_junit, render_listing,
    render_sarif, render_summary, render_text,
};
use polarform::notes::{Options as Checking, check_document, listing};
use polarform::session::Session;
use polarform::source::{SourceFile, Span};
use polarform::weave::{
    Mode, Options as Weaving, Woven, weave_book, weave_latex, weave_markdown, weave_notebook,
};
use polarform::write::{latex, sympy, text, unicode};
use polarform::{latex as latex_reader, syntax};

/// One input may take this long, limits and printing included (debug builds are slow).
const LONGEST: Duration = Duration::from_secs(20);

/// What is wrong, if anything.
pub type Outcome = Result<(), String>;

/// What is read, with the formats that its inputs are in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Statements, in plain notation or LaTeX.
    Language,
    /// A page of notes that is checked.
    Notes(Container),
    /// A file that is woven.
    Weave(Written),
}

/// How a file stands in which results are put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    Markdown,
    Template,
    Notebook,
    Latex,
    /// What mdBook sends.
    Book,
}

impl Family {
    pub const NOTES: [Family; 4] = [
        Family::Notes(Container::Markdown),
        Family::Notes(Container::Latex),
        Family::Notes(Container::Rst),
        Family::Notes(Container::Notebook),
    ];

    pub const WEAVE: [Family; 5] = [
        Family::Weave(Written::Markdown),
        Family::Weave(Written::Template),
        Family::Weave(Written::Notebook),
        Family::Weave(Written::Latex),
        Family::Weave(Written::Book),
    ];

    /// Everything that reads such an input, on one; `given` is a session with some names.
    pub fn attack(self, input: &[u8], given: &Session) -> Outcome {
        let start = Instant::now();
        let limits = &given.limits;
        match self {
            Family::Language => language(&String::from_utf8_lossy(input), given)?,
            Family::Notes(kind) => notes(kind, input, limits)?,
            Family::Weave(kind) => weave(kind, &String::from_utf8_lossy(input), limits)?,
        }
        match start.elapsed() {
            time if time >= LONGEST => Err(format!("took {time:?}")),
            _ => Ok(()),
        }
    }
}

/// A session with small limits and some names.
pub fn given() -> Session {
    let limits = Limits {
        time: Some(Duration::from_millis(200)),
        steps: Some(200_000),
        terms: 20_000,
        bits: 1 << 16,
        ..Limits::default()
    };
    let mut given = Session::new(limits);
    for definition in
        ["f := polar(t^3 + 3t^2 + 5t + 1)", "F(t) := t^2 + 2t", "g := polar(t^2)", "n := 3", "i := 1"]
    {
        given.run(definition).expect("it can be defined");
    }
    given
}

fn internal(problem: &Diagnostic, file: &SourceFile) -> Outcome {
    let shown = render(problem, file, false);
    if problem.code == Code::Internal { Err(shown) } else { Ok(()) }
}

fn language(input: &str, given: &Session) -> Outcome {
    let _ = syntax::parse_program(input);
    let (tree, _) = latex_reader::read_tolerant(input);
    let _ = (text(&tree), unicode(&tree), latex(&tree), sympy(&tree).is_ok());
    let _ = latex_reader::read_rows(input);
    let mut session = given.clone();
    let file = SourceFile::new("<fuzz>", input);
    let start = Instant::now();
    let mut outcome = Ok(());
    session.run_file(&file, |session, result| {
        match result {
            Ok(answer) => {
                let limits = session.limits.clone();
                let value = answer.outcome.value;
                // A value too large to print is stopped, which is fine.
                let _ = budget::run(&limits, || {
                    let expr = value.to_expr();
                    (text(&expr), unicode(&expr), latex(&expr), sympy(&expr).is_ok())
                });
            }
            Err(failure) => outcome = outcome.clone().and(internal(&failure.problem, &failure.file)),
        }
        start.elapsed() < LONGEST
    });
    outcome
}

fn notes(kind: Container, input: &[u8], limits: &Limits) -> Outcome {
    let name = if kind == Container::Notebook { "a.ipynb" } else { "a.md" };
    let Ok(document) = read_text(name, input.to_vec(), kind, &Macros::default()) else { return Ok(()) };
    let file = &document.file;
    let whole = |span: Span| file.text().get(span.start..span.end).is_some();
    // A page has many formulas, and it is the page that matters here.
    let limits = Limits { steps: Some(10_000), ..limits.clone() };
    let report = check_document(&document, &Checking { limits, context: None });
    for problem in &report.problems {
        internal(problem, file)?;
    }
    if let Some(finding) = report.findings.iter().find(|finding| !whole(finding.span)) {
        return Err(format!("a finding at {:?} is no piece of the page", finding.span));
    }
    let changed = fixed(file.text(), &fixes(&document, &report));
    let listed = polarform::judge::finding::FileReport::new(
        file.clone(),
        listing(&document),
        document.problems.clone(),
    );
    let reports = [report];
    let options = TextOptions { color: false, verbose: true, quiet: false };
    let written = [
        render_text(&reports, options),
        render_summary(&reports, false),
        render_json(&reports),
        render_sarif(&reports),
        render_html(&reports),
        render_github(&reports, true),
        render_junit(&reports),
        render_listing(&[listed], false),
    ];
    let _ = (changed, written);
    Ok(())
}

fn weave(kind: Written, input: &str, limits: &Limits) -> Outcome {
    // A stop by the clock would not come again at the same place.
    let limits = Limits { time: None, ..limits.clone() };
    let mode = if kind == Written::Template { Mode::Template } else { Mode::InPlace };
    let options = Weaving { mode, limits, fresh: true, ..Weaving::default() };
    let file = |text: &str| SourceFile::new("a.md", text);
    let woven = |text: &str, before: &str| -> Option<Woven> {
        Some(match kind {
            Written::Markdown | Written::Template => weave_markdown(&file(text), &options),
            Written::Notebook => weave_notebook(&file(text), &options),
            Written::Latex => weave_latex(&file(text), before, &mut |_| None, &options),
            Written::Book => weave_book(text, &options).ok()?,
        })
    };
    let Some(first) = woven(input, "") else { return Ok(()) };
    for failure in &first.problems {
        internal(&failure.problem, &failure.file)?;
    }
    // Weaving twice changes nothing.
    let again = match kind {
        Written::Template | Written::Book => None,
        Written::Latex => woven(input, &first.text),
        _ => woven(&first.text, ""),
    };
    match again {
        Some(again) if again.text != first.text => Err(format!(
            "weaving again changes what was woven\n--- first\n{}\n--- again\n{}",
            first.text, again.text
        )),
        _ => Ok(()),
    }
}
