//! Printing results and problems.

use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use smallvec::SmallVec;

use super::arguments::Global;
use crate::figure::{TikzOptions, figure_json, terminal, tikz, value_json};
use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic, Severity, harmless, render, render_json};
use crate::language::value::{Language, Notation, Polar, PolarKind, Value, symbol_expr};
use crate::language::write::{
    ARTICLE, Breaks, Format, Manner, expanded_terms, write_answer, write_expanded, write_expr, write_grouped,
};
use crate::math::blossom::PolarForm;
use crate::math::number::Rational;
use crate::scene::Scene;
use crate::session::Failure;

/// Polar forms of a larger degree are written out without building the formula.
const STREAM_ABOVE: usize = 6;

/// LaTeX with more terms is not broken into lines: no page holds it.
const LONGEST_BROKEN: u64 = 5000;

/// What an argument is called, as it is printed.
type Name = SmallVec<[u8; 16]>;

/// The columns and rows of a preview.
pub(super) const PREVIEW: (usize, usize) = (72, 20);

/// Where results and messages go, and how.
pub(super) struct Output {
    pub format: Format,
    pub notation: Notation,
    pub language: Language,
    /// How wide LaTeX may be, in points.
    width: f64,
    breaks: Breaks,
    /// Whether usual readings are told, too.
    pub verbose: bool,
    /// Whether only what is wrong is told.
    pub quiet: bool,
    color: bool,
    limits: crate::budget::Limits,
    /// When the statement began that is printed, by the clock of the limits.
    began: Mutex<Duration>,
}

impl Output {
    pub fn new(global: &Global) -> Self {
        let color = global.color.wanted(io::stderr().is_terminal());
        let (notation, language) = (global.notation(), global.lang);
        let width = match global.width {
            None => ARTICLE,
            Some(0) => f64::INFINITY,
            Some(points) => f64::from(points),
        };
        let limits = global.limits();
        Output {
            format: global.format(),
            notation,
            language,
            width,
            breaks: global.breaks,
            verbose: global.verbose,
            quiet: global.quiet,
            color,
            began: Mutex::new(limits.now()),
            limits,
        }
    }

    /// A statement begins: what is printed of it has the time that its evaluation leaves.
    pub fn begin(&self) {
        *self.began.lock().unwrap_or_else(PoisonError::into_inner) = self.limits.now();
    }

    /// One line of results.
    pub fn line(&self, line: &str) -> io::Result<()> {
        let mut out = io::stdout().lock();
        out.write_all(line.as_bytes())?;
        out.write_all(b"\n")
    }

    /// Results that end with a line end of their own.
    pub fn text(&self, text: &str) -> io::Result<()> {
        self.bytes(text.as_bytes())
    }

    /// The content of a file.
    pub fn bytes(&self, bytes: &[u8]) -> io::Result<()> {
        let mut out = io::stdout().lock();
        out.write_all(bytes)?;
        out.flush()
    }

    /// A problem, on standard error.
    pub fn problem(&self, problem: &Diagnostic, file: &SourceFile) {
        if self.quiet && problem.severity == Severity::Note {
            return;
        }
        let text = match self.format {
            Format::Json => render_json(problem, file).to_string(),
            _ => render(problem, file, self.color),
        };
        // When standard error is gone there is nobody left to tell.
        let _ = writeln!(io::stderr().lock(), "{text}");
    }

    /// A remark on standard error, on what is done beside the results.
    pub fn remark(&self, text: &str) {
        if !self.quiet {
            // When standard error is gone there is nobody left to tell.
            let _ = writeln!(io::stderr().lock(), "{text}");
        }
    }

    /// A statement that failed.
    pub fn failure(&self, failure: &Failure) {
        self.problem(&failure.problem, &failure.file);
    }

    /// A value. Writing can fail, and a value can be too large to write out.
    pub fn value(&self, value: &Value, name: Option<Expr>) -> Result<(), Trouble> {
        match value {
            Value::Figure(scene) => return self.figure(scene, name),
            // What is short enough is printed as any formula; the result is the same.
            Value::Polar(polar) if matches!(self.notation, Notation::Expanded | Notation::Grouped) => {
                if self.format != Format::Json
                    && let PolarKind::Univariate(form) = &polar.kind
                    && form.degree() > STREAM_ABOVE
                    && let Some(form) = rational(form)
                    && !(self.format == Format::Latex
                        && self.width.is_finite()
                        && expanded_terms(&form) < LONGEST_BROKEN)
                {
                    return self.stream(polar, &form, name);
                }
            }
            _ => {}
        }
        let manner = Manner {
            format: self.format,
            notation: self.notation,
            language: self.language,
            width: self.width,
            breaks: self.breaks,
        };
        let line = self.limited(|| match (self.format, value) {
            // Also of lists of figures.
            (Format::Json, Value::List(_)) => Ok(value_json(value, self.notation).to_string()),
            _ => write_answer(value, name, &manner),
        })?;
        Ok(self.line(&line.map_err(|error| Trouble::problem(error.to_string()))?)?)
    }

    /// A drawing: a preview, TikZ, or data.
    fn figure(&self, scene: &Scene, name: Option<Expr>) -> Result<(), Trouble> {
        let scene = &scene.clone().in_language(self.language.code());
        let drawn = self.limited(|| match self.format {
            Format::Text | Format::Unicode => Ok(terminal(scene, PREVIEW.0, PREVIEW.1)),
            Format::Latex => Ok(tikz(scene, &TikzOptions::default())),
            Format::Json => Ok(figure_json(scene).to_string() + "\n"),
            Format::Sympy => Err(Trouble::problem("a figure has no form in SymPy".to_owned())),
        })??;
        if let (Some(name), Format::Text | Format::Unicode) = (name, self.format) {
            self.line(&(self.written(&name)? + " ="))?;
        }
        Ok(self.text(&drawn)?)
    }

    /// A form written out without being built.
    fn stream(&self, polar: &Polar, form: &PolarForm<Rational>, name: Option<Expr>) -> Result<(), Trouble> {
        self.limited(|| {
            // What is too long is refused before its first line is out.
            crate::budget::charge_terms(expanded_terms(form));
            let argument = |i: usize| symbol_expr(&polar.variables[0].numbered(i as i64));
            // There may be a million of them, and each is short.
            let names: Result<Vec<Name>, Trouble> = (1..=form.degree())
                .map(|i| {
                    crate::budget::step();
                    Ok(Name::from_slice(self.written(&argument(i))?.as_bytes()))
                })
                .collect();
            let names = names?;
            let mut out = BufWriter::new(io::stdout().lock());
            if self.format != Format::Sympy {
                // What stands around one argument stands around all: a formula of each takes room.
                let function = Box::new(name.unwrap_or_else(|| Expr::name("f")));
                let call = self.written(&Kind::Apply(function, vec![vec![argument(1)]]).into())?;
                let first = self.written(&argument(1))?;
                let (before, after) = call.rsplit_once(&first).expect("the argument is written");
                out.write_all(before.as_bytes())?;
                for (i, name) in names.iter().enumerate() {
                    crate::budget::step();
                    out.write_all(if i > 0 { b", " } else { b"" })?;
                    out.write_all(name)?;
                }
                write!(out, "{after} = ")?;
            }
            match self.notation {
                Notation::Grouped => write_grouped(&mut out, form, &names, self.format)?,
                _ => write_expanded(&mut out, form, &names, self.format)?,
            }
            out.write_all(b"\n")?;
            Ok(out.flush()?)
        })?
    }

    /// Does something large under the limits on a statement.
    pub fn limited<T>(&self, work: impl FnOnce() -> T) -> Result<T, Trouble> {
        let began = *self.began.lock().unwrap_or_else(PoisonError::into_inner);
        crate::budget::run_since(began, &self.limits, work)
            .map_err(|stop| Trouble::Problem(Box::new(crate::session::stopped(&stop))))
    }

    /// A formula in the chosen format.
    pub fn written(&self, expr: &Expr) -> Result<String, Trouble> {
        write_expr(expr, self.format).map_err(|error| Trouble::problem(error.to_string()))
    }
}

/// The name of a file in a line of results.
pub(super) fn shown(path: &Path) -> String {
    harmless(&path.display().to_string())
}

/// Why something could not be printed.
pub(super) enum Trouble {
    /// Standard output is closed or full.
    Output(io::Error),
    /// The value has no such form.
    Problem(Box<Diagnostic>),
}

impl Trouble {
    fn problem(message: String) -> Self {
        let problem = Diagnostic::error(Code::Unsupported, message);
        Trouble::Problem(Box::new(problem.hint("choose another --format or --notation")))
    }
}

impl From<io::Error> for Trouble {
    fn from(error: io::Error) -> Self {
        Trouble::Output(error)
    }
}

/// The form over Q, if all coefficients are numbers.
fn rational(form: &PolarForm<crate::math::poly::Fraction>) -> Option<PolarForm<Rational>> {
    let list: Option<Vec<Rational>> = form.coefficients().iter().map(|c| c.as_rational()).collect();
    list.map(PolarForm::new)
}
