//! Derivations: a line of text each, aligned LaTeX, or data.

use serde_json::{Value as Json, json};

use super::{Format, WriteError, latex, lines_of, measured, text, write_expr, write_words};
use crate::formula::{Expr, Kind};
use crate::language::value::{Derivation, Language, Line};

/// A derivation in one of the formats, its reasons in its own language if it has one, else in the
/// given one: a line `formula    [reason]` each; in LaTeX an `aligned` environment, for display
/// math; data for JSON.
///
/// In LaTeX the lines are aligned at their first relation, and a left side that repeats the one
/// before is not written again.
///
/// # Errors
/// [`WriteError`] for constructs without meaning in SymPy.
pub fn write_derivation(
    derivation: &Derivation,
    format: Format,
    language: Language,
) -> Result<String, WriteError> {
    write_derivation_within(derivation, format, language, f64::INFINITY)
}

/// The same in LaTeX of about this width in points: if the lines are wider, their right sides are broken, and
/// the reasons stand below them.
///
/// # Errors
/// [`WriteError`] for constructs without meaning in SymPy.
pub fn write_derivation_within(
    derivation: &Derivation,
    format: Format,
    language: Language,
    width: f64,
) -> Result<String, WriteError> {
    let language = derivation.language.unwrap_or(language);
    match format {
        Format::Latex => Ok(aligned(&derivation.lines, language, width)),
        Format::Json => Ok(derivation_json(derivation, language).to_string()),
        Format::Text | Format::Unicode | Format::Sympy => {
            let lines = derivation.lines.iter().map(|line| {
                let formula = write_expr(&line.formula, format)?;
                let reason = write_words(line.reason.text(language), format);
                Ok(match format {
                    Format::Sympy => format!("{formula}  # {reason}"),
                    _ => format!("{formula}    [{reason}]"),
                })
            });
            Ok(lines.collect::<Result<Vec<String>, WriteError>>()?.join("\n"))
        }
    }
}

/// The narrowest lines into which reasons are broken, in points.
const LEAST_FOR_WORDS: f64 = 100.0;

/// The left side of the first relation.
fn left_side(formula: &Expr) -> Option<&Expr> {
    match &formula.kind {
        Kind::Chain(left, _) => Some(left),
        Kind::Sequence(items) => items.first().and_then(left_side),
        _ => None,
    }
}

/// The LaTeX of a formula up to its first relation, and from there on: at this place the lines of
/// a derivation are aligned. Without a relation all of it stands on the right.
///
/// ```
/// use polarform::write::split_at_relation;
/// let formula = polarform::syntax::parse("p_1 = t = s").unwrap();
/// assert_eq!(split_at_relation(&formula), ("p_1".to_owned(), "= t = s".to_owned()));
/// ```
pub fn split_at_relation(formula: &Expr) -> (String, String) {
    let whole = latex(formula);
    let left = left_side(formula).map(latex).unwrap_or_default();
    match whole.strip_prefix(&left) {
        Some(rest) => (left, rest.trim_start().to_owned()),
        None => (String::new(), whole),
    }
}

/// Whether a line of a derivation has the left side of the one before, which then need not be written again. The
/// first of several formulas keeps its own: they are read together, and the last of those before would be its left side.
pub fn repeats_left_side(before: &Expr, formula: &Expr) -> bool {
    let several = |expr: &Expr| matches!(expr.kind, Kind::Sequence(_));
    let left = |expr| left_side(expr).map(latex);
    !several(before) && !several(formula) && left(formula).is_some() && left(before) == left(formula)
}

fn aligned(lines: &[Line], language: Language, width: f64) -> String {
    let parts: Vec<(String, String, String)> = lines
        .iter()
        .map(|line| {
            let (left, right) = split_at_relation(&line.formula);
            (left, right, format!("\\text{{{}}}", write_words(line.reason.text(language), Format::Latex)))
        })
        .collect();
    let widest = |part: &dyn Fn(&(String, String, String)) -> f64| parts.iter().map(part).fold(0.0, f64::max);
    let (margin, reasons) = (widest(&|row| measured(&row.0)), widest(&|row| measured(&row.2)));
    let below = margin + widest(&|row| measured(&row.1)) + reasons > width;
    let rows = parts.iter().enumerate().map(|(i, (left, right, reason))| {
        let repeats = i > 0 && repeats_left_side(&lines[i - 1].formula, &lines[i].formula);
        let shown = if repeats { "" } else { left };
        let row = match below {
            false => format!("{shown} &{right} && {reason}"),
            true => {
                let right = lines_of(right, width - margin).join(" \\\\\n&");
                let reason = lines_of_words(reason, (width - margin - 20.0).max(LEAST_FOR_WORDS))
                    .join(" \\\\\n&\\qquad ");
                format!("{shown} &{right} \\\\\n&\\qquad {reason}")
            }
        };
        row.trim_start().to_owned()
    });
    let rows: Vec<String> = rows.collect();
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", rows.join(" \\\\\n"))
}

/// `\text{ words }` as several of them, broken at blanks outside of formulas.
fn lines_of_words(text: &str, width: f64) -> Vec<String> {
    let words = text.strip_prefix("\\text{").and_then(|rest| rest.strip_suffix('}'));
    let Some(words) = words.filter(|_| measured(text) > width) else { return vec![text.to_owned()] };
    let mut lines = vec![String::new()];
    let mut formula = false;
    for word in words.split(' ') {
        let line = lines.last().map_or("", String::as_str);
        let joined = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
        match formula || line.is_empty() || measured(&format!("\\text{{{joined}}}")) <= width {
            true => *lines.last_mut().expect("there is a line") = joined,
            false => lines.push(word.to_owned()),
        }
        formula ^= word.matches('$').count() % 2 == 1;
    }
    lines.into_iter().map(|line| format!("\\text{{{line}}}")).collect()
}

/// A derivation as its title and lines, each with its formula as text and LaTeX and its reason;
/// and all of it as LaTeX.
pub fn derivation_json(derivation: &Derivation, language: Language) -> Json {
    let language = derivation.language.unwrap_or(language);
    let lines = derivation.lines.iter().map(|line| {
        json!({
            "formula": text(&line.formula),
            "latex": latex(&line.formula),
            "reason": write_words(line.reason.text(language), Format::Text),
        })
    });
    json!({
        "kind": "derivation",
        "title": write_words(derivation.title.text(language), Format::Text),
        "language": language.code(),
        "lines": lines.collect::<Vec<_>>(),
        "latex": aligned(&derivation.lines, language, f64::INFINITY),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::Rel;
    use crate::language::value::Words;

    #[test]
    fn repeated_left_sides_are_written_once() {
        let words = |text: &str| Words::new(|_| text.to_owned());
        let line = |right: &str| Line {
            formula: Expr::relation(Expr::name("a"), Rel::Eq, Expr::name(right)),
            reason: words("as `t_1`"),
        };
        let lines = vec![line("b"), line("c"), Line { formula: Expr::name("d"), reason: words("why") }];
        let derivation = Derivation { title: words("title"), lines, language: None };
        let write = |format| write_derivation(&derivation, format, Language::English).unwrap();
        assert_eq!(
            write(Format::Latex),
            "\\begin{aligned}\na &= b && \\text{as $t_1$} \\\\\n&= c && \\text{as $t_1$} \\\\\n&d && \\text{why}\n\\end{aligned}"
        );
        let narrow = write_derivation_within(&derivation, Format::Latex, Language::English, 20.0).unwrap();
        assert_eq!(narrow.lines().nth(1), Some("a &= b \\\\"));
        assert_eq!(narrow.lines().nth(2), Some("&\\qquad \\text{as $t_1$} \\\\"));
        assert_eq!(write(Format::Text), "a = b    [as t1]\na = c    [as t1]\nd    [why]");
        assert_eq!(write(Format::Sympy).lines().next(), Some("Eq(a, b)  # as t1"));
        let data: Json = serde_json::from_str(&write(Format::Json)).unwrap();
        assert_eq!(data["lines"][1]["latex"], "a = c");
    }
}
