//! Lecture notes and their verdicts.

use std::cell::RefCell;

use polarform::budget::Limits;
use polarform::document::{Container, Document, Item, document};
use polarform::judge::finding::{FileReport, Verdict};
use polarform::notes::report::{Tally, fixes, render_json};
use polarform::notes::{Memory, Options, check_again, check_document};
use polarform::source::SourceFile;
use serde_json::{Map, Value, json};

use super::told::Places;
use super::{Refusal, Request, bounded, depth, field, optional, typst::typst};

/// Longer pages are not checked.
const LONGEST: usize = 512 << 10;

/// Pages with more formulas are not checked: a browser could not show them.
const MOST_FORMULAS: usize = 6000;

/// What was found so far is told for the first time after so many statements.
const FIRST: usize = 8;

thread_local! {
    /// The last page of requests that are about the same one, and how it was written.
    static MEMORY: RefCell<Option<(Container, Memory)>> = const { RefCell::new(None) };
}

fn kind(word: &str) -> Result<Container, Refusal> {
    NAMES
        .iter()
        .find(|(name, _)| *name == word)
        .map(|(_, kind)| *kind)
        .ok_or_else(|| format!("pages written as {word} are not read"))
}

/// Names of how a page is written.
const NAMES: [(&str, Container); 4] = [
    ("markdown", Container::Markdown),
    ("latex", Container::Latex),
    ("rst", Container::Rst),
    ("notebook", Container::Notebook),
];

/// The report of `notes check`, each formula with its place in UTF-16 code units and the edits that put its suggestion in. With `again`
/// the page is the one of the last such request, edited: only what the edit may change is judged, and what is found meanwhile goes to `tell`.
pub(crate) fn report(request: &Request, tell: &mut dyn FnMut(Value)) -> Result<Value, Refusal> {
    let text = bounded(field(request, "text")?, LONGEST, "the page")?;
    let kind = optional(request, "as").map_or_else(|| Ok(Container::guess(text.as_bytes())), kind)?;
    let name = optional(request, "name").unwrap_or("page");
    let document = document(SourceFile::new(name, text), kind);
    let formulas = document.items.iter().filter(|item| matches!(item, Item::Formula(_))).count();
    if formulas > MOST_FORMULAS {
        return Err(format!(
            "the page has {formulas} formulas, and more than {MOST_FORMULAS} are not checked here"
        ));
    }
    let steps = request.get("steps").and_then(Value::as_u64);
    let limits = Limits { steps, depth: depth(request), ..Limits::default() };
    let context = optional(request, "context").map(str::to_owned);
    let options = Options { limits, context };
    if request.get("again").and_then(Value::as_bool) != Some(true) {
        return told(&document, kind, &check_document(&document, &options));
    }
    // A check that breaks down leaves no memory behind.
    let remembered = MEMORY.take().filter(|(before, _)| *before == kind);
    let mut memory = remembered.map(|(_, memory)| memory).unwrap_or_default();
    let (mut judged, mut next, mut edited) = (0, FIRST, memory.is_empty());
    let report = check_again(&document, &options, &mut memory, &mut |progress| {
        judged += 1;
        // The more there is to tell, the more seldom: all of it is no more work than the last report twice.
        if judged >= next || (progress.edited && !edited) {
            next = next.max(judged * 2);
            edited |= progress.edited;
            if let Ok(mut so_far) = told(&document, kind, &progress.report()) {
                so_far["partial"] = true.into();
                tell(so_far);
            }
        }
    });
    MEMORY.set(Some((kind, memory)));
    told(&document, kind, &report)
}

fn told(document: &Document, kind: Container, report: &FileReport) -> Result<Value, Refusal> {
    let told: Value = serde_json::from_str(&render_json(std::slice::from_ref(report)))
        .map_err(|error| error.to_string())?;
    let mut formulas = told["files"][0]["formulas"].as_array().cloned().unwrap_or_default();
    let mut places = Places::new(report.file.text());
    for (formula, finding) in formulas.iter_mut().zip(&report.findings) {
        let (from, to) = places.of(finding.span);
        formula["from"] = from.into();
        formula["to"] = to.into();
        let alone = FileReport::new(report.file.clone(), vec![finding.clone()], Vec::new());
        let mut place = |fix: polarform::notes::report::Fix| {
            let (from, to) = places.of(fix.span);
            json!({"from": from, "to": to, "text": fix.text})
        };
        formula["typst"] = json!(typst(&finding.reading));
        formula["suggestion_typst"] = json!(finding.suggestion.as_deref().and_then(typst));
        formula["fixes"] = fixes(document, &alone).into_iter().map(&mut place).collect();
    }
    let tally = Tally::of(std::slice::from_ref(report));
    let verdicts =
        Verdict::ALL.into_iter().map(|verdict| (verdict.word().to_owned(), tally.count(verdict).into()));
    let counts: Map<String, Value> = verdicts.chain([("silent".to_owned(), tally.silent().into())]).collect();
    let problems: Vec<Value> =
        report.problems.iter().map(|problem| super::told::problem(problem, &report.file)).collect();
    let kind = NAMES.iter().find(|(_, known)| *known == kind).map(|(name, _)| *name);
    Ok(
        json!({"as": kind, "formulas": formulas, "problems": problems, "counts": counts, "words": tally.words(), "summary": told["summary"]}),
    )
}

#[cfg(test)]
mod tests {
    use crate::answer;
    use serde_json::{Value, json};

    /// The answer to each page in turn, as edits of one, with what was told before it.
    fn edited(texts: &[&str]) -> Vec<Vec<Value>> {
        let answered = |text: &&str| {
            let mut told = Vec::new();
            let request = json!({"do": "check", "text": text, "again": true}).to_string();
            let last = crate::answer_telling(&request, &mut |partial| {
                told.push(serde_json::from_str(partial).unwrap())
            });
            told.push(serde_json::from_str(&last).unwrap());
            told
        };
        texts.iter().map(answered).collect()
    }

    #[test]
    fn an_edited_page_has_the_report_of_a_new_one_and_tells_what_it_found_before() {
        let first: String = (0..20).map(|i| format!("Now ${i} + 1 = {}$.\n\n", i + 1)).collect();
        let second = first.replace("$9 + 1 = 10$", "$9 + 1 = 11$");
        let latex = format!(
            "\\documentclass{{article}}\n\\begin{{document}}\n{second}\\end{{document}}\n% $1 = 2$\n"
        );
        let answers = edited(&[&first, &second, &latex]);
        for (text, (told, kind)) in
            [&first, &second, &latex].into_iter().zip(answers.iter().zip(["markdown", "markdown", "latex"]))
        {
            assert_eq!(told.last(), Some(&checked(text, kind)), "{text}");
        }
        let counts = |told: &Value| told["formulas"].as_array().unwrap().len();
        let partial = |told: &Vec<Value>| {
            told.iter().filter(|one| one["partial"] == true).map(counts).collect::<Vec<_>>()
        };
        assert_eq!(partial(&answers[0]), [8, 16]);
        // The edit is judged at once; the rest is as it was.
        assert_eq!(partial(&answers[1])[0], 20);
        assert_eq!(answers[1][0]["counts"]["refuted"], 1);
        assert_eq!(answers[2][0]["as"], "latex");
    }

    #[test]
    fn too_many_formulas_are_refused_in_words() {
        let refused = checked(&"$1=1$ ".repeat(7000), "markdown")["refused"].to_string();
        assert!(refused.contains("7000 formulas"), "{refused}");
    }

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
