//! Checking lecture notes from Python.

use std::path::PathBuf;
use std::time::Duration;

use polarform::budget::Limits;
use polarform::diagnostic::{Diagnostic, Severity};
use polarform::document::{Container, Document, Macros, Reading, read_files, read_text};
use polarform::judge::finding::{FileReport, Finding as Native, Verdict};
use polarform::notes::report::{
    TextOptions, fixed, fixes, render_github, render_html, render_json, render_junit, render_sarif,
    render_text,
};
use polarform::notes::{Options, check_document};
use polarform::source::SourceFile;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::compute::{compute, limits};
use crate::error::{exception, span_in_characters};

/// A formula has so long if no limit is set, as on the command line.
const TIME: Duration = Duration::from_secs(60);

/// One relation of a page with its verdict.
#[pyclass(frozen, get_all, module = "polarform")]
pub struct Finding {
    /// proved, sampled, refuted, undecided, unread or definition
    verdict: &'static str,
    /// Why.
    reason: Option<String>,
    /// Values for which the sides differ, in words.
    counterexample: Option<String>,
    /// What was probably meant, as LaTeX to be put in the place of the relation.
    suggestion: Option<String>,
    /// Something suspicious that is no refutation.
    warning: Option<String>,
    /// The relation as it stands on the page.
    latex: String,
    /// How it was read.
    reading: String,
    /// What the verdict rests on.
    assumed: Vec<String>,
    /// Which instances were tried.
    tried: Option<String>,
    /// The characters it covers: `text[start:end]`.
    span: (usize, usize),
    /// Counted from 1.
    line: usize,
    /// Counted from 1, in characters.
    column: usize,
    /// The line where it ends.
    end_line: usize,
    /// The column behind its last character.
    end_column: usize,
}

#[pymethods]
impl Finding {
    fn __repr__(&self) -> String {
        format!("<{} {}:{} {}>", self.verdict, self.line, self.column, self.latex)
    }
}

/// Something wrong with a page itself.
#[pyclass(frozen, get_all, module = "polarform")]
pub struct Problem {
    /// error, warning or note
    severity: &'static str,
    /// The stable code; `pf.explain(code)` tells more.
    code: &'static str,
    /// What is wrong.
    message: String,
    /// What to do about it.
    hints: Vec<String>,
    /// Counted from 1, if the place is known.
    line: Option<usize>,
    /// Counted from 1, in characters.
    column: Option<usize>,
}

#[pymethods]
impl Problem {
    fn __repr__(&self) -> String {
        let place =
            self.line.map_or_else(String::new, |line| format!(" {line}:{}", self.column.unwrap_or(1)));
        format!("<{}{place} {}>", self.severity, self.message)
    }
}

/// The verdicts on a page.
#[pyclass(frozen, module = "polarform")]
pub struct Report {
    document: Document,
    report: FileReport,
}

fn found(finding: &Native, file: &SourceFile) -> Finding {
    let (line, column) = file.line_column(finding.span.start);
    let (end_line, end_column) = file.line_column(finding.span.end);
    Finding {
        verdict: finding.verdict.word(),
        reason: finding.reason.clone(),
        counterexample: finding.witness.clone(),
        suggestion: finding.suggestion.clone(),
        warning: finding.warning.clone(),
        latex: finding.latex.clone(),
        reading: finding.reading.clone(),
        assumed: finding.notes.clone(),
        tried: finding.instances.clone(),
        span: span_in_characters(file.text(), finding.span),
        line,
        column,
        end_line,
        end_column,
    }
}

fn problem_of(problem: &Diagnostic, file: &SourceFile) -> Problem {
    let place = problem.span.map(|span| file.line_column(span.start));
    Problem {
        severity: match problem.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        },
        code: problem.code.id(),
        message: problem.message.clone(),
        hints: problem.hints.clone(),
        line: place.map(|(line, _)| line),
        column: place.map(|(_, column)| column),
    }
}

impl Report {
    fn with(&self, wanted: impl Fn(&Native) -> bool) -> Vec<Finding> {
        let all = self.report.findings.iter().filter(|finding| wanted(finding));
        all.map(|finding| found(finding, &self.report.file)).collect()
    }
}

#[pymethods]
impl Report {
    /// Every relation of the page, in its order.
    #[getter]
    fn findings(&self) -> Vec<Finding> {
        self.with(|_| true)
    }

    /// The relations that are wrong.
    #[getter]
    fn refuted(&self) -> Vec<Finding> {
        self.with(|finding| finding.verdict == Verdict::Refuted)
    }

    /// What is wrong with the page itself.
    #[getter]
    fn problems(&self) -> Vec<Problem> {
        self.report.problems.iter().map(|problem| problem_of(problem, &self.report.file)).collect()
    }

    /// How many relations there are of each verdict.
    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let counts = PyDict::new(py);
        for verdict in Verdict::ALL {
            counts.set_item(verdict.word(), self.report.count(verdict))?;
        }
        Ok(counts)
    }

    /// Whether nothing is refuted.
    #[getter]
    fn ok(&self) -> bool {
        self.report.count(Verdict::Refuted) == 0
    }

    /// What the page is called.
    #[getter]
    fn name(&self) -> &str {
        self.report.file.name()
    }

    /// The page.
    #[getter]
    fn text(&self) -> &str {
        self.report.file.text()
    }

    fn __len__(&self) -> usize {
        self.report.findings.len()
    }

    fn __getitem__(&self, index: isize) -> PyResult<Finding> {
        let length = self.report.findings.len() as isize;
        let at = if index < 0 { index + length } else { index };
        match usize::try_from(at).ok().and_then(|at| self.report.findings.get(at)) {
            Some(finding) => Ok(found(finding, &self.report.file)),
            None => Err(pyo3::exceptions::PyIndexError::new_err("there are not so many findings")),
        }
    }

    /// The page with all suggestions in it.
    fn fixed(&self) -> String {
        fixed(self.report.file.text(), &fixes(&self.document, &self.report))
    }

    /// The report as a program prints it: `format` is text, html, json, sarif, github or junit.
    #[pyo3(signature = (format="text", *, verbose=false, color=false))]
    fn render(&self, format: &str, verbose: bool, color: bool) -> PyResult<String> {
        let reports = std::slice::from_ref(&self.report);
        Ok(match format {
            "text" => render_text(reports, TextOptions { color, verbose, quiet: false }),
            "html" => render_html(reports),
            "json" => render_json(reports),
            "sarif" => render_sarif(reports),
            "github" => render_github(reports, verbose),
            "junit" => render_junit(reports),
            _ => {
                return Err(PyValueError::new_err(
                    "the formats are text, html, json, sarif, github and junit",
                ));
            }
        })
    }

    fn __str__(&self) -> PyResult<String> {
        self.render("text", false, false)
    }

    /// For notebooks: what is wrong, with its places, and the counts.
    fn _repr_html_(&self) -> PyResult<String> {
        let text = self.__str__()?.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        // Notebooks set what cells give in the font of text, and the marks below lines would be beside what they mean.
        Ok(format!(r#"<pre style="font-family: monospace">{}</pre>"#, text.trim_end()))
    }

    fn __repr__(&self) -> String {
        let told = Verdict::ALL.iter().filter(|verdict| self.report.count(**verdict) > 0);
        let counts: Vec<String> =
            told.map(|verdict| format!("{} {}", self.report.count(*verdict), verdict.word())).collect();
        format!(
            "<polarform.Report of {}: {}>",
            self.name(),
            if counts.is_empty() { "no formulas".to_owned() } else { counts.join(", ") }
        )
    }
}

fn container(format: &str) -> PyResult<Container> {
    Ok(match format {
        "markdown" | "md" | "text" => Container::Markdown,
        "latex" | "tex" => Container::Latex,
        "rst" => Container::Rst,
        "notebook" | "ipynb" => Container::Notebook,
        _ => return Err(PyValueError::new_err("the formats are markdown, latex, rst and notebook")),
    })
}

fn timed() -> Limits {
    let limits = limits();
    Limits { time: limits.time.or(Some(TIME)), ..limits }
}

/// Judges every formula of a text: `format` is markdown, latex, rst or notebook, `context` are declarations in the
/// language of queries, `name` is what the page is called.
#[pyfunction]
#[pyo3(signature = (text, /, format="markdown", *, context=None, name="<text>"))]
pub fn check(
    py: Python<'_>,
    text: &str,
    format: &str,
    context: Option<String>,
    name: &str,
) -> PyResult<Report> {
    let kind = container(format)?;
    let done = compute(py, &timed(), |limits| {
        let document = read_text(name, text.as_bytes().to_vec(), kind, &Macros::default())?;
        let report = check_document(&document, &Options { limits: limits.clone(), context });
        Ok(Report { document, report })
    })?;
    done.map_err(|problem: Diagnostic| exception(py, &problem, &SourceFile::new(name, text)))
}

/// Judges every formula of a file and of those it includes, a report for each.
#[pyfunction]
#[pyo3(signature = (path, /, format=None, *, context=None))]
pub fn check_file(
    py: Python<'_>,
    path: PathBuf,
    format: Option<&str>,
    context: Option<String>,
) -> PyResult<Vec<Report>> {
    let kind = format.map(container).transpose()?;
    let done = compute(py, &timed(), |limits| {
        let documents = read_files(&path, &Reading { kind, ..Reading::default() })?;
        let options = Options { limits: limits.clone(), context };
        let reports = documents.into_iter().map(|document| {
            let report = check_document(&document, &options);
            Report { document, report }
        });
        Ok(reports.collect::<Vec<_>>())
    })?;
    done.map_err(|problem: Diagnostic| {
        exception(py, &problem, &SourceFile::new(path.display().to_string(), ""))
    })
}
