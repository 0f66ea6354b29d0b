//! What a value looks like in a document, whatever the document is written in.

use super::options::BlockOptions;
use crate::figure::{SvgOptions, TikzOptions, svg, tikz};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::syntax::parse;
use crate::language::value::{Claim, Language, Line, Table, Value, Verdict, curve_expr, symbol_expr};
use crate::language::write::{
    latex, latex_table_within, repeats_left_side, split_at_relation, text, verdict_in_words, write_words,
};
use crate::session::Answer;

/// A result as the formats of documents need it.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A formula.
    Formula(Shown),
    /// Words.
    Words(String),
    /// A derivation, line by line.
    Steps(Vec<StepLine>),
    /// A figure.
    Picture(Picture),
}

/// A figure in the forms that documents take.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// What it shows, for those who do not see it.
    pub title: String,
    /// As SVG.
    pub svg: String,
    /// As a `tikzpicture`.
    pub tikz: String,
    /// The file that holds the SVG, relative to the document; `None` to put it into the text.
    pub file: Option<String>,
}

/// A formula as LaTeX and in plain notation.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// All of it, for math mode.
    pub latex: String,
    /// All of it, in plain notation.
    pub text: String,
    /// What is asked and what comes out, for two columns of a table: LaTeX. A claim that is true has
    /// no right column.
    pub columns: (String, Option<String>),
    /// What is to be said of a claim that is not true.
    pub remark: Option<String>,
    /// What came of a claim.
    pub verdict: Option<Verdict>,
}

/// A line of a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct StepLine {
    /// LaTeX up to the sign at which lines are aligned, and from there on.
    pub latex: (String, String),
    /// Whether that first part is the one of the line before and need not be written again.
    pub repeats: bool,
    /// The formula in plain notation.
    pub text: String,
    /// Why it holds: words, with formulas in plain notation between backticks.
    pub reason: String,
}

/// Makes the piece of a document that shows an answer: the one place to add a kind of value.
///
/// `lines` is the derivation of the value, where the options want one and there is one. A definition
/// shows as `name = value`, a claim as it was written, everything else as its value.
///
/// # Errors
/// A value that has no form in a document.
///
/// ```
/// use polarform::session::Session;
/// use polarform::weave::{BlockOptions, Piece, render};
/// let answer = Session::default().run("polar(t^2)(0, 1/2) + 1/3").unwrap();
/// let Piece::Formula(shown) = render(&answer, &[], &BlockOptions::default()).unwrap() else { panic!() };
/// assert_eq!(shown.latex, "\\frac{1}{3}");
/// ```
pub fn render(answer: &Answer, lines: &[Line], options: &BlockOptions) -> Result<Piece, Diagnostic> {
    if !lines.is_empty() {
        return Ok(steps(lines, options.lang));
    }
    let value = &answer.outcome.value;
    let name = answer.outcome.defined.as_ref().map(symbol_expr);
    let piece = match value {
        Value::Text(words) => Piece::Words(words.clone()),
        Value::List(items)
            if !items.is_empty() && items.iter().all(|item| matches!(item, Value::Text(_))) =>
        {
            let words = items.iter().filter_map(|item| match item {
                Value::Text(words) => Some(words.as_str()),
                _ => None,
            });
            Piece::Words(words.collect::<Vec<_>>().join(", "))
        }
        Value::Builtin(name) => {
            let problem = Diagnostic::error(Code::Type, format!("{name} is a function of the program"));
            return Err(problem.hint("write a call of it, with arguments"));
        }
        Value::Figure(scene) => {
            let scene = scene.as_ref().clone().in_language(options.lang.code());
            Piece::Picture(Picture {
                title: scene.title().to_owned(),
                svg: svg(&scene, &SvgOptions::default()),
                tikz: tikz(&scene, &TikzOptions::default()),
                file: None,
            })
        }
        Value::Claim(claim) => Piece::Formula(claimed(claim, &answer.statement)),
        Value::Polar(polar) => {
            Piece::Formula(equation(&polar.equation(answer.function_name(), options.notation)))
        }
        Value::Function(_) => Piece::Formula(equation(&value.to_expr_in(options.notation))),
        Value::List(items) => match curve_expr(items, answer.function_name(), options.notation) {
            Some(curve) => Piece::Formula(equation(&curve)),
            None => Piece::Formula(named(value, name, &answer.statement, options)),
        },
        Value::Table(table) => Piece::Formula(tabulated(table, name, options.room())),
        Value::Derivation(derivation) => {
            steps(&derivation.lines, derivation.language.unwrap_or(options.lang))
        }
        Value::Scalar(_)
        | Value::Algebraic(_)
        | Value::Vector(_)
        | Value::Matrix(_)
        | Value::Geometry(_)
        | Value::Piecewise(_)
        | Value::Written(_) => Piece::Formula(named(value, name, &answer.statement, options)),
    };
    Ok(piece)
}

/// `name = value`, `query = value` or the value alone.
fn named(value: &Value, name: Option<Expr>, statement: &Expr, options: &BlockOptions) -> Shown {
    let body_latex = latex(&value.display_expr(options.notation));
    let body_text = text(&value.to_expr_in(options.notation));
    let left = name.as_ref().unwrap_or(statement);
    let (left_latex, left_text) = (latex(left), text(left));
    // A value that is written as it is asked for is no equation.
    let equation = name.is_some() || (options.equation && left_text != body_text);
    let (latex, text) = if equation {
        (format!("{left_latex} = {body_latex}"), format!("{left_text} = {body_text}"))
    } else {
        (body_latex.clone(), body_text)
    };
    Shown { latex, text, columns: (left_latex, Some(body_latex)), remark: None, verdict: None }
}

/// A scheme or report, as an array.
fn tabulated(table: &Table, name: Option<Expr>, room: f64) -> Shown {
    let array = latex_table_within(table, room);
    let left = name.map(|name| (latex(&name), text(&name)));
    let rows = text(&table.to_expr());
    let (whole, text) = match &left {
        Some((latex, text)) => (format!("{latex} = {array}"), format!("{text} = {rows}")),
        None => (array.clone(), rows),
    };
    let columns = left.map_or((array.clone(), None), |(left, _)| (left, Some(array)));
    Shown { latex: whole, text, columns, remark: None, verdict: None }
}

/// A formula that is an equation already.
fn equation(whole: &Expr) -> Shown {
    let columns = match &whole.kind {
        Kind::Chain(left, links) if links.len() == 1 => (latex(left), Some(latex(&links[0].expr))),
        _ => (latex(whole), None),
    };
    Shown { latex: latex(whole), text: text(whole), columns, remark: None, verdict: None }
}

fn claimed(claim: &Claim, statement: &Expr) -> Shown {
    let verdict = claim.verdict();
    let remark = match verdict {
        Verdict::Proved | Verdict::Sampled => None,
        Verdict::Refuted | Verdict::Undecided => {
            let judgement = claim.judgements.iter().find(|judgement| judgement.verdict == verdict);
            Some(judgement.map_or_else(|| verdict.word().to_owned(), verdict_in_words))
        }
    };
    let written = latex(statement);
    Shown {
        latex: written.clone(),
        text: text(statement),
        columns: (written, None),
        remark,
        verdict: Some(verdict),
    }
}

fn steps(lines: &[Line], language: Language) -> Piece {
    let line = |(i, line): (usize, &Line)| StepLine {
        latex: split_at_relation(&line.formula),
        repeats: i > 0 && repeats_left_side(&lines[i - 1].formula, &line.formula),
        text: text(&line.formula),
        reason: line.reason.text(language).to_owned(),
    };
    Piece::Steps(lines.iter().enumerate().map(line).collect())
}

/// Words with formulas between backticks, for math mode: `\text{the mean of } t_1^2`.
///
/// No dollar stands in it: some renderers of Markdown take it for the end of the formula.
pub(super) fn words_in_formula(words: &str) -> String {
    let mut out = String::new();
    for (i, piece) in words.split('`').enumerate().filter(|(_, piece)| !piece.is_empty()) {
        match parse(piece) {
            Ok(formula) if i % 2 == 1 => out.push_str(&latex(&formula)),
            _ => {
                out.push_str(r"\text{");
                out.push_str(&escaped(piece));
                out.push('}');
            }
        }
    }
    out
}

/// The same in plain notation.
pub(super) fn words_as_text(words: &str) -> String {
    write_words(words, crate::language::write::Format::Text)
}

/// Words as text of LaTeX.
pub(super) fn escaped(words: &str) -> String {
    let mut out = String::with_capacity(words.len());
    for c in words.chars() {
        match c {
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => out.extend(['\\', c]),
            '\\' => out.push_str(r"\textbackslash{}"),
            '^' => out.push_str(r"\textasciicircum{}"),
            '~' => out.push_str(r"\textasciitilde{}"),
            '<' => out.push_str(r"\textless{}"),
            '>' => out.push_str(r"\textgreater{}"),
            '"' => out.push_str("''"),
            '\n' | '\r' => out.push(' '),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Session;

    fn shown(statement: &str, options: &str) -> Piece {
        let mut session = Session::default();
        session.run("f := polar(t^2 + 2t)").unwrap();
        let answer = session.run(statement).unwrap();
        render(&answer, &[], &BlockOptions::default().with(options, 0).unwrap()).unwrap()
    }

    fn formula(statement: &str, options: &str) -> String {
        match shown(statement, options) {
            Piece::Formula(shown) => shown.latex,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn kinds_of_values() {
        assert_eq!(formula("f(0, 1/2)", ""), r"\frac{1}{2}");
        assert_eq!(formula("f(0, 1/2)", "equation"), r"f(0, 1/2) = \frac{1}{2}");
        assert_eq!(formula("1/2", "equation"), r"\frac{1}{2}");
        assert_eq!(formula("a := 3", ""), "a = 3");
        assert_eq!(formula("G(t) := t^2", ""), "G(t) := t^2");
        assert_eq!(formula("f", ""), "f(t_1, t_2) = t_1 t_2 + (t_1 + t_2)");
        assert_eq!(formula("g := f", "notation=expanded"), "g(t_1, t_2) = t_1 t_2 + t_1 + t_2");
        assert_eq!(formula("[1, 2; 3, 4]", ""), r"\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}");
        assert_eq!(formula("f(0, 1) = 1", ""), "f(0, 1) = 1");
        assert!(matches!(shown("degree(0)", ""), Piece::Words(_)));
    }

    #[test]
    fn claims_that_are_not_true_get_a_remark() {
        let remark = |statement| match shown(statement, "") {
            Piece::Formula(shown) => shown.remark,
            other => panic!("{other:?}"),
        };
        assert_eq!(remark("f(0, 1) = 1"), None);
        assert_eq!(remark("f(0, 1) = 2").as_deref(), Some("refuted: left `1`, right `2`"));
        let found = remark("(t + 1)^2 = t^2 + 1").unwrap();
        assert!(found.starts_with("refuted: for `t = "), "{found}");
        assert_eq!(remark("x > 0").as_deref(), Some("undecided"));
    }

    #[test]
    fn words_among_formulas() {
        assert_eq!(words_in_formula("the mean of `t_1^2`"), r"\text{the mean of }t_1^2");
        assert_eq!(escaped("50% of a_b"), r"50\% of a\_b");
    }
}
