//! Printing results and problems.

use std::io::{self, IsTerminal, Write};
use std::sync::Arc;

use super::arguments::Global;
use crate::figure::{TikzOptions, figure_json, terminal, tikz, value_json};
use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic, render, render_json};
use crate::language::value::{
    Claim, Derivation, Language, Notation, Polar, PolarKind, Value, Verdict, curve_expr, symbol_expr,
};
use crate::language::write::{
    Format, claim_json, expanded_terms, text, write_derivation, write_expanded, write_expr, write_grouped,
    write_table,
};
use crate::math::blossom::PolarForm;
use crate::math::number::Rational;
use crate::scene::Scene;
use crate::session::Failure;

/// Polar forms of a larger degree are written out without building the formula.
const STREAM_ABOVE: usize = 6;

/// The columns and rows of a preview.
pub(super) const PREVIEW: (usize, usize) = (72, 20);

/// Where results and messages go, and how.
pub(super) struct Output {
    pub format: Format,
    pub notation: Notation,
    pub language: Language,
    color: bool,
    limits: crate::budget::Limits,
}

impl Output {
    pub fn new(global: &Global) -> Self {
        let color = global.color.wanted(io::stderr().is_terminal());
        let (notation, language) = (global.notation(), global.lang);
        Output { format: global.format(), notation, language, color, limits: global.limits() }
    }

    /// One line of results.
    pub fn line(&self, line: &str) -> io::Result<()> {
        let mut out = io::stdout().lock();
        out.write_all(line.as_bytes())?;
        out.write_all(b"\n")
    }

    /// Results that end with a line end of their own.
    pub fn text(&self, text: &str) -> io::Result<()> {
        let mut out = io::stdout().lock();
        out.write_all(text.as_bytes())?;
        out.flush()
    }

    /// A problem, on standard error.
    pub fn problem(&self, problem: &Diagnostic, file: &SourceFile) {
        let text = match self.format {
            Format::Json => render_json(problem, file).to_string(),
            _ => render(problem, file, self.color),
        };
        // When standard error is gone there is nobody left to tell.
        let _ = writeln!(io::stderr().lock(), "{text}");
    }

    /// A statement that failed.
    pub fn failure(&self, failure: &Failure) {
        self.problem(&failure.problem, &failure.file);
    }

    /// A value. Writing can fail, and a value can be too large to write out.
    pub fn value(&self, value: &Value, name: Option<Expr>) -> Result<(), Trouble> {
        match value {
            Value::Polar(polar) => self.polar(polar, name),
            Value::Claim(claim) => self.claim(claim),
            Value::Derivation(derivation) => self.derivation(derivation),
            Value::Text(words) if self.format != Format::Json => Ok(self.line(words)?),
            Value::List(items)
                if !items.is_empty()
                    && self.format != Format::Json
                    && items.iter().all(|item| matches!(item, Value::Text(_))) =>
            {
                for item in items {
                    self.value(item, None)?;
                }
                Ok(())
            }
            Value::Figure(scene) => self.figure(scene, name),
            _ => self.plain(value, name),
        }
    }

    /// A drawing: a preview, TikZ, or data.
    fn figure(&self, scene: &Scene, name: Option<Expr>) -> Result<(), Trouble> {
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

    fn plain(&self, value: &Value, name: Option<Expr>) -> Result<(), Trouble> {
        let line = self.limited(|| -> Result<String, Trouble> {
            if self.format == Format::Json {
                return Ok(value_json(value, self.notation).to_string());
            }
            if let Value::List(items) = value
                && self.format != Format::Sympy
            {
                let own = name.clone().unwrap_or_else(|| Expr::name("f"));
                if let Some(curve) = curve_expr(items, own, self.notation) {
                    return self.written(&curve);
                }
            }
            if let Value::Table(table) = value {
                let body =
                    write_table(table, self.format).map_err(|error| Trouble::problem(error.to_string()))?;
                return match &name {
                    Some(name) if self.format != Format::Sympy => Ok(self.written(name)? + " =\n" + &body),
                    _ => Ok(body),
                };
            }
            let expr = match self.format {
                Format::Latex => value.display_expr(self.notation),
                _ => value.to_expr_in(self.notation),
            };
            // The cases of a function stand on lines of their own, as they are typed.
            if let (Value::Function(_), Kind::Sequence(cases), Format::Text | Format::Unicode) =
                (value, &expr.kind, self.format)
            {
                let lines: Result<Vec<String>, Trouble> =
                    cases.iter().map(|case| self.written(case)).collect();
                return Ok(lines?.join("\n"));
            }
            let body = self.written(&expr)?;
            // Functions print as their own definition, and SymPy wants the bare expression.
            match name {
                Some(name) if !matches!(value, Value::Function(_)) && self.format != Format::Sympy => {
                    let separator = if body.contains('\n') { " =\n" } else { " = " };
                    Ok(self.written(&name)? + separator + &body)
                }
                _ => Ok(body),
            }
        })??;
        Ok(self.line(&line)?)
    }

    fn polar(&self, polar: &Arc<Polar>, name: Option<Expr>) -> Result<(), Trouble> {
        // What is short enough is printed as any formula; the result is the same.
        if matches!(self.notation, Notation::Expanded | Notation::Grouped)
            && self.format != Format::Json
            && let PolarKind::Univariate(form) = &polar.kind
            && form.degree() > STREAM_ABOVE
            && let Some(form) = rational(form)
        {
            return self.stream(polar, &form, name);
        }
        let line = self.limited(|| match self.format {
            Format::Json => Ok(value_json(&Value::Polar(polar.clone()), self.notation).to_string()),
            Format::Sympy => self.written(&polar.body(self.notation)),
            _ => {
                let name = name.unwrap_or_else(|| Expr::name("f"));
                self.written(&polar.equation(name, self.notation))
            }
        })??;
        Ok(self.line(&line)?)
    }

    /// A form written out without being built.
    fn stream(&self, polar: &Polar, form: &PolarForm<Rational>, name: Option<Expr>) -> Result<(), Trouble> {
        let names: Result<Vec<String>, Trouble> =
            polar.arguments()[0].iter().map(|argument| self.written(&symbol_expr(&argument[0]))).collect();
        let names = names?;
        let left = polar.call(name.unwrap_or_else(|| Expr::name("f")));
        let head = if self.format == Format::Sympy { String::new() } else { self.written(&left)? + " = " };
        let mut out = io::stdout().lock();
        self.limited(|| {
            // What is too long is refused before its first line is out.
            crate::budget::charge_terms(expanded_terms(form));
            out.write_all(head.as_bytes())?;
            match self.notation {
                Notation::Grouped => write_grouped(&mut out, form, &names, self.format)?,
                _ => write_expanded(&mut out, form, &names, self.format)?,
            }
            out.write_all(b"\n")
        })?
        .map_err(Trouble::Output)
    }

    /// Does something large under the limits.
    pub fn limited<T>(&self, work: impl FnOnce() -> T) -> Result<T, Trouble> {
        crate::budget::run(&self.limits, work)
            .map_err(|stop| Trouble::Problem(Box::new(crate::session::stopped(&stop))))
    }

    /// A derivation, line by line.
    fn derivation(&self, derivation: &Derivation) -> Result<(), Trouble> {
        let text = self.limited(|| write_derivation(derivation, self.format, self.language))?;
        Ok(self.line(&text.map_err(|error| Trouble::problem(error.to_string()))?)?)
    }

    /// A formula in the chosen format.
    pub fn written(&self, expr: &Expr) -> Result<String, Trouble> {
        write_expr(expr, self.format).map_err(|error| Trouble::problem(error.to_string()))
    }

    /// The verdicts of a chain of relations.
    pub fn claim(&self, claim: &Claim) -> Result<(), Trouble> {
        if self.format == Format::Json {
            return Ok(self.line(&claim_json(claim).to_string())?);
        }
        if self.format == Format::Sympy {
            let word = match claim.verdict() {
                Verdict::Proved | Verdict::Sampled => "True",
                Verdict::Refuted => "False",
                Verdict::Undecided => "None",
            };
            return Ok(self.line(word)?);
        }
        let several = claim.judgements.len() > 1;
        for (i, judgement) in claim.judgements.iter().enumerate() {
            let start = if several { format!("relation {}: ", i + 1) } else { String::new() };
            let word = match judgement.verdict {
                Verdict::Proved => "true",
                Verdict::Sampled => "true as far as tried",
                Verdict::Refuted => "false",
                Verdict::Undecided => "undecided",
            };
            self.line(&format!("{start}{word}"))?;
            if judgement.verdict == Verdict::Proved {
                continue;
            }
            for reason in &judgement.reasons {
                self.line(&format!("  {reason}"))?;
            }
            if judgement.verdict == Verdict::Refuted {
                self.side("left side", &judgement.left)?;
                self.side("right side", &judgement.right)?;
                if let Some(difference) = &judgement.difference {
                    self.side("left - right", difference)?;
                }
            }
            if let Some(witness) = &judgement.witness
                && !witness.assignment.is_empty()
            {
                let at: Vec<String> = witness
                    .assignment
                    .iter()
                    .map(|(symbol, value)| format!("{} = {value}", text(&symbol_expr(symbol))))
                    .collect();
                self.line(&format!(
                    "  for {}: left {}, right {}",
                    at.join(", "),
                    witness.left,
                    witness.right
                ))?;
            }
        }
        Ok(())
    }

    fn side(&self, label: &str, value: &Value) -> Result<(), Trouble> {
        /// Longer formulas are not repeated in a report.
        const LONGEST: usize = 2000;
        let body = self.limited(|| self.written(&value.to_expr()))??;
        let shown = if body.len() > LONGEST { format!("({} characters)", body.len()) } else { body };
        let separator = if shown.contains('\n') { "\n" } else { " " };
        Ok(self.line(&format!("  {label}:{separator}{shown}"))?)
    }
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
