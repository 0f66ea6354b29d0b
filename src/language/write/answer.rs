//! Answers as a person reads them: values with their names, verdicts in words.

use super::{
    Breaks, Format, WriteError, claim_json, latex_table_within, text, value_json, write_derivation_within,
    write_expr, write_table,
};
use crate::formula::{Expr, Kind};
use crate::language::value::{Claim, Judgement, Language, Notation, Value, Verdict, curve_expr, symbol_expr};

/// How answers are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manner {
    /// Text, LaTeX, JSON, …
    pub format: Format,
    /// How polar forms are written.
    pub notation: Notation,
    /// The language of derivations that have none of their own.
    pub language: Language,
    /// How wide LaTeX may be, in points.
    pub width: f64,
    /// How wider LaTeX is broken.
    pub breaks: Breaks,
}

impl Default for Manner {
    fn default() -> Self {
        Manner {
            format: Format::default(),
            notation: Notation::default(),
            language: Language::default(),
            width: f64::INFINITY,
            breaks: Breaks::default(),
        }
    }
}

/// An answer in one of the formats, without a line end: `name = value`, or the value alone if it has no
/// name; of a claim, a verdict for each relation with its reasons. Figures are told by their titles.
///
/// # Errors
/// [`WriteError`] for values without meaning in SymPy.
///
/// ```
/// use polarform::session::Session;
/// use polarform::write::{Manner, write_answer};
/// let mut session = Session::default();
/// let mut answer = |query: &str| {
///     let answer = session.run(query).unwrap();
///     write_answer(&answer.outcome.value, answer.name(), &Manner::default()).unwrap()
/// };
/// assert_eq!(answer("a := 1/2"), "a = 1/2");
/// assert_eq!(answer("polar(t^2)"), "f(t1, t2) = t1 t2");
/// assert_eq!(answer("a = 1"), "refuted\n  left side: 1/2\n  right side: 1\n  left - right: -1/2");
/// ```
pub fn write_answer(value: &Value, name: Option<Expr>, manner: &Manner) -> Result<String, WriteError> {
    let written = |expr: &Expr| write_expr(expr, manner.format);
    let fitted = |latex: String| match manner.format {
        Format::Latex => manner.breaks.broken(&latex, manner.width),
        _ => latex,
    };
    match (value, manner.format) {
        (Value::Claim(claim), _) => write_claim(claim, manner),
        (Value::Derivation(derivation), format) => {
            write_derivation_within(derivation, format, manner.language, manner.width)
        }
        (_, Format::Json) => Ok(value_json(value, manner.notation).to_string()),
        (Value::Text(words), _) => Ok(words.clone()),
        (Value::List(items), _) if is_words(items) => {
            let lines: Result<Vec<String>, WriteError> =
                items.iter().map(|item| write_answer(item, None, manner)).collect();
            Ok(lines?.join("\n"))
        }
        (Value::Polar(polar), Format::Sympy) => written(&polar.body(manner.notation)),
        (Value::Polar(polar), _) => {
            let name = name.unwrap_or_else(|| Expr::name("f"));
            written(&polar.equation(name, manner.notation)).map(fitted)
        }
        (Value::Table(table), format) => {
            let body = match format {
                Format::Latex => latex_table_within(table, manner.width),
                _ => write_table(table, format)?,
            };
            match &name {
                Some(name) if format != Format::Sympy => Ok(written(name)? + " =\n" + &body),
                _ => Ok(body),
            }
        }
        (Value::List(items), format) if format != Format::Sympy => {
            let own = name.clone().unwrap_or_else(|| Expr::name("f"));
            match curve_expr(items, own, manner.notation) {
                Some(curve) => written(&curve).map(fitted),
                None => write_value(value, name, manner).map(fitted),
            }
        }
        _ => write_value(value, name, manner).map(fitted),
    }
}

fn is_words(items: &[Value]) -> bool {
    !items.is_empty() && items.iter().all(|item| matches!(item, Value::Text(_)))
}

fn write_value(value: &Value, name: Option<Expr>, manner: &Manner) -> Result<String, WriteError> {
    let written = |expr: &Expr| write_expr(expr, manner.format);
    let expr = match manner.format {
        Format::Latex => value.display_expr(manner.notation),
        _ => value.to_expr_in(manner.notation),
    };
    // The cases of a function stand on lines of their own, as they are typed.
    if let (Value::Function(_), Kind::Sequence(cases), Format::Text | Format::Unicode) =
        (value, &expr.kind, manner.format)
    {
        let lines: Result<Vec<String>, WriteError> = cases.iter().map(written).collect();
        return Ok(lines?.join("\n"));
    }
    let body = written(&expr)?;
    // Functions print as their own definition, and SymPy wants the bare expression.
    match name {
        Some(name) if !matches!(value, Value::Function(_)) && manner.format != Format::Sympy => {
            let separator = if body.contains('\n') { " =\n" } else { " = " };
            Ok(written(&name)? + separator + &body)
        }
        _ => Ok(body),
    }
}

/// The verdicts of a chain of relations, each with its reasons.
fn write_claim(claim: &Claim, manner: &Manner) -> Result<String, WriteError> {
    match manner.format {
        Format::Json => return Ok(claim_json(claim).to_string()),
        Format::Sympy => {
            let word = match claim.verdict() {
                Verdict::Proved | Verdict::Sampled => "True",
                Verdict::Refuted => "False",
                Verdict::Undecided => "None",
            };
            return Ok(word.to_owned());
        }
        _ => {}
    }
    let several = claim.judgements.len() > 1;
    let mut lines = Vec::new();
    for (i, judgement) in claim.judgements.iter().enumerate() {
        let start = if several { format!("relation {}: ", i + 1) } else { String::new() };
        lines.push(format!("{start}{}", judgement.verdict.word()));
        if judgement.verdict == Verdict::Proved {
            continue;
        }
        lines.extend(judgement.reasons.iter().map(|reason| format!("  {reason}")));
        if judgement.verdict == Verdict::Refuted {
            lines.push(side("left side", &judgement.left, manner.format)?);
            lines.push(side("right side", &judgement.right, manner.format)?);
            if let Some(difference) = &judgement.difference {
                lines.push(side("left - right", difference, manner.format)?);
            }
        }
        if let Some(witness) = judgement.witness.as_ref().filter(|witness| !witness.assignment.is_empty()) {
            let values = witness.assignment.iter();
            let values = values.map(|(symbol, value)| format!("{} = {value}", text(&symbol_expr(symbol))));
            let values: Vec<String> = values.collect();
            let (left, right) = (&witness.left, &witness.right);
            lines.push(format!("  for {}: left {left}, right {right}", values.join(", ")));
        }
    }
    Ok(lines.join("\n"))
}

fn side(label: &str, value: &Value, format: Format) -> Result<String, WriteError> {
    /// Longer formulas are not repeated in a report.
    const LONGEST: usize = 2000;
    let body = match value {
        Value::Text(words) => words.clone(),
        _ => write_expr(&value.to_expr(), format)?,
    };
    let shown = if body.len() > LONGEST { format!("({} characters)", body.len()) } else { body };
    let separator = if shown.contains('\n') { "\n" } else { " " };
    Ok(format!("  {label}:{separator}{shown}"))
}

/// Longer sides of a refuted claim are not repeated beside it.
const LONGEST_SIDE: usize = 60;

/// A verdict that is not "proved" in one line, formulas between backticks:
/// ``refuted: for `t = 1` left `3`, right `5` ``.
pub fn verdict_in_words(judgement: &Judgement) -> String {
    let word = judgement.verdict.word();
    if judgement.verdict != Verdict::Refuted {
        return word.to_owned();
    }
    if let Some(witness) = judgement.witness.as_ref().filter(|witness| !witness.assignment.is_empty()) {
        let values = witness.assignment.iter();
        let values = values.map(|(name, value)| format!("`{} = {value}`", text(&symbol_expr(name))));
        let values: Vec<String> = values.collect();
        return format!(
            "{word}: for {} left `{}`, right `{}`",
            values.join(", "),
            witness.left,
            witness.right
        );
    }
    let (left, right) = (text(&judgement.left.to_expr()), text(&judgement.right.to_expr()));
    if left.len().max(right.len()) > LONGEST_SIDE {
        return word.to_owned();
    }
    format!("{word}: left `{left}`, right `{right}`")
}
