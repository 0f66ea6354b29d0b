//! Lecture notes and their verdicts.

use polarform::budget::Limits;
use polarform::document::{Container, document};
use polarform::judge::finding::{FileReport, Verdict};
use polarform::notes::report::{Tally, fixes, render_json};
use polarform::notes::{Options, check_document};
use polarform::source::SourceFile;
use serde_json::{Map, Value, json};

use super::told::{self, Places};
use super::{Refusal, Request, bounded, depth, field, optional, typst::typst};

/// Longer pages are not checked.
const LONGEST: usize = 512 << 10;

/// The report of `notes check`, each formula with its place in UTF-16 code units and the edits that put its suggestion in.
pub(crate) fn report(request: &Request) -> Result<Value, Refusal> {
    let text = bounded(field(request, "text")?, LONGEST, "the page")?;
    let kind = match optional(request, "as") {
        None | Some("markdown") => Container::Markdown,
        Some("latex") => Container::Latex,
        Some("rst") => Container::Rst,
        Some("notebook") => Container::Notebook,
        Some(other) => return Err(format!("pages written as {other} are not read")),
    };
    let name = optional(request, "name").unwrap_or("page");
    let document = document(SourceFile::new(name, text), kind);
    let steps = request.get("steps").and_then(Value::as_u64);
    let limits = Limits { steps, depth: depth(request), ..Limits::default() };
    let context = optional(request, "context").map(str::to_owned);
    let report = check_document(&document, &Options { limits, context });
    let told: Value = serde_json::from_str(&render_json(std::slice::from_ref(&report)))
        .map_err(|error| error.to_string())?;
    let mut formulas = told["files"][0]["formulas"].as_array().cloned().unwrap_or_default();
    let mut places = Places::new(report.file.text());
    for (formula, finding) in formulas.iter_mut().zip(&report.findings) {
        let (from, to) = places.of(finding.span);
        formula["from"] = from.into();
        formula["to"] = to.into();
        let alone =
            FileReport { file: report.file.clone(), findings: vec![finding.clone()], problems: Vec::new() };
        let mut place = |fix: polarform::notes::report::Fix| {
            let (from, to) = places.of(fix.span);
            json!({"from": from, "to": to, "text": fix.text})
        };
        formula["typst"] = json!(typst(&finding.reading));
        formula["suggestion_typst"] = json!(finding.suggestion.as_deref().and_then(typst));
        formula["fixes"] = fixes(&document, &alone).into_iter().map(&mut place).collect();
    }
    let tally = Tally::of(std::slice::from_ref(&report));
    let verdicts =
        Verdict::ALL.into_iter().map(|verdict| (verdict.word().to_owned(), tally.count(verdict).into()));
    let counts: Map<String, Value> = verdicts.chain([("silent".to_owned(), tally.silent().into())]).collect();
    let problems: Vec<Value> =
        report.problems.iter().map(|problem| told::problem(problem, &report.file)).collect();
    Ok(
        json!({"formulas": formulas, "problems": problems, "counts": counts, "words": tally.words(), "summary": told["summary"]}),
    )
}

#[cfg(test)]
mod tests {
    use crate::answer;
    use serde_json::{Value, json};

    fn checked(text: &str, kind: &str) -> Value {
        serde_json::from_str(&answer(&json!({"do": "check", "text": text, "as": kind}).to_string())).unwrap()
    }

    #[test]
    fn places_and_edits_are_those_of_the_page() {
        let page = "多 𝕋: $1 + 1 = 3$ and $2 + 2 = 4$.\n";
        let report = checked(page, "markdown");
        let units: Vec<u16> = page.encode_utf16().collect();
        let formulas = report["formulas"].as_array().unwrap();
        let verdicts: Vec<&str> =
            formulas.iter().map(|formula| formula["verdict"].as_str().unwrap()).collect();
        assert_eq!(verdicts, ["refuted", "proved"]);
        let cut = |value: &Value| {
            let place = |name: &str| value[name].as_u64().unwrap() as usize;
            String::from_utf16(&units[place("from")..place("to")]).unwrap()
        };
        assert_eq!(cut(&formulas[0]), "1 + 1 = 3");
        assert_eq!(
            (cut(&formulas[0]["fixes"][0]), &formulas[0]["fixes"][0]["text"]),
            ("3".to_owned(), &json!("2"))
        );
        assert_eq!(formulas[0]["suggestion_typst"], "1 + 1 = 2");
        assert_eq!(report["words"], "2 claims: 1 refuted, 1 proved");
        assert_eq!(report["counts"]["refuted"], 1);
    }

    #[test]
    fn what_is_too_long_or_unknown_is_refused() {
        assert!(checked(&"a".repeat(600 << 10), "markdown")["refused"].as_str().unwrap().contains("600 kB"));
        assert!(checked("a", "word")["refused"].is_string());
    }
}
