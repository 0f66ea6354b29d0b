//! Statements and their answers.

use polarform::budget::{self, Limits};
use polarform::diagnostic::{Code, Diagnostic};
use polarform::session::{Answer, Session};
use polarform::source::SourceFile;
use polarform::value::{Language, Notation, Value as Result_, Verdict};
use polarform::weave::{BlockOptions, Piece, render};
use polarform::write::{Format, Manner, write_answer};
use serde_json::{Value, json};

use super::{Refusal, Request, bounded, depth, field, optional, told, typst::typst};

/// A statement takes at most so many steps, some tens of seconds.
const STEPS: u64 = 40_000_000;

/// A value may have so many terms: a page with more of them is of use to nobody.
const TERMS: u64 = 200_000;

/// Inputs are not longer.
const LONGEST: usize = 64 << 10;

/// Longer formulas are not set.
const LONGEST_FORMULA: usize = 24 << 10;

/// Longer answers are not shown.
const LONGEST_TEXT: usize = 512 << 10;

pub(crate) fn session(depth: usize) -> Session {
    Session::new(Limits { steps: Some(STEPS), terms: TERMS, depth, ..Limits::default() })
}

/// The session after the inputs that a request brings, if it brings any.
pub(crate) fn earlier(request: &Request) -> Result<Option<Session>, Refusal> {
    let Some(inputs) = request.get("session").and_then(Value::as_array) else { return Ok(None) };
    let mut session = session(depth(request));
    for input in inputs {
        let input = bounded(input.as_str().ok_or("an input is a text")?, LONGEST, "the input")?;
        // One that failed then fails now, and changed nothing.
        session.run_file(&SourceFile::new("input", input), |_, _| true);
    }
    Ok(Some(session))
}

/// Runs an input, which may be several statements, up to the first that fails.
pub(crate) fn answer(session: &mut Session, request: &Request) -> Result<Value, Refusal> {
    let input = bounded(field(request, "input")?, LONGEST, "the input")?;
    let lang = optional(request, "lang").map_or(Ok(Language::default()), str::parse)?;
    let notation = match optional(request, "notation") {
        None | Some("grouped") => Notation::Grouped,
        Some("expanded") => Notation::Expanded,
        Some("sigma") => Notation::Sigma,
        Some("ellipsis") => Notation::Ellipsis,
        Some(other) => return Err(format!("there is no notation {other}")),
    };
    let options = BlockOptions { lang, notation, ..BlockOptions::default() };
    let file = SourceFile::new("input", input);
    let mut answers = Vec::new();
    let mut problem = Value::Null;
    session.run_file(&file, |session, result| {
        let shown = match &result {
            Ok(answer) => budget::run(&session.limits, || shown(answer, &options))
                .unwrap_or_else(|stop| Err(Diagnostic::error(Code::TooManyTerms, stop.to_string()))),
            Err(failure) => Err(failure.problem.clone()),
        };
        match shown {
            Ok(answer) => answers.push(answer),
            Err(found) => problem = told::problem(&found, &file),
        }
        problem.is_null()
    });
    Ok(json!({"answers": answers, "problem": problem, "names": session.names()}))
}

/// An answer in every form that a host may want.
fn shown(answer: &Answer, options: &BlockOptions) -> Result<Value, Diagnostic> {
    let value = &answer.outcome.value;
    let written = |format| {
        let manner =
            Manner { format, notation: options.notation, language: options.lang, ..Manner::default() };
        write_answer(value, answer.name(), &manner)
            .map_err(|error| Diagnostic::error(Code::Unsupported, error.to_string()))
    };
    let text = written(Format::Text)?;
    if text.len() > LONGEST_TEXT {
        let words = format!("the answer has {} kB, which a page does not show", text.len() >> 10);
        return Err(Diagnostic::error(Code::TooManyTerms, words).hint("ask for a value or a part of it"));
    }
    let notes: Vec<Value> =
        answer.outcome.notes.iter().map(|note| told::problem(note, &answer.file)).collect();
    let mut out = json!({"kind": "formula", "text": text, "latex": null, "notes": notes});
    let set = |latex: String| if latex.len() > LONGEST_FORMULA { Value::Null } else { latex.into() };
    // A function of the program has no place in a document, but it has its form.
    // What stands in a formula is not the same in every host.
    let formula = |out: &mut Value, latex: String| {
        out["typst"] = typst(&latex).map_or(Value::Null, set);
        out["latex"] = set(latex);
    };
    let piece = match value {
        Result_::Builtin(_) => Piece::Words(text),
        _ => render(answer, &[], options)?,
    };
    match piece {
        Piece::Formula(shown) => match shown.verdict {
            None => formula(&mut out, written(Format::Latex)?),
            Some(verdict) => {
                out["kind"] = "claim".into();
                formula(&mut out, shown.latex);
                out["verdict"] = verdict.word().into();
                out["holds"] = matches!(verdict, Verdict::Proved | Verdict::Sampled).into();
            }
        },
        Piece::Words(_) => out["kind"] = "words".into(),
        Piece::Steps(lines) => {
            out["kind"] = "steps".into();
            let line = |line: polarform::weave::StepLine| {
                let (left, right) = line.latex;
                json!({"left": left, "right": right, "typst": [typst(&left), typst(&right)], "text": line.text, "reason": told::words(&line.reason)})
            };
            out["lines"] = lines.into_iter().map(line).collect();
        }
        Piece::Picture(picture) => {
            out["kind"] = "picture".into();
            out["title"] = picture.title.into();
            out["svg"] = picture.svg.into();
            out["tikz"] = picture.tikz.into();
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use crate::answer;
    use serde_json::{Value, json};

    fn asked(session: &[&str], input: &str) -> Value {
        let request = json!({"do": "ask", "session": session, "input": input});
        serde_json::from_str(&answer(&request.to_string())).unwrap()
    }

    #[test]
    fn every_kind_of_answer() {
        let earlier = ["f := polar(t^2 + 2t)"];
        let first = |input| asked(&earlier, input)["answers"][0].clone();
        assert_eq!(first("f(0, 1/2)")["latex"], "\\frac{1}{2}");
        assert_eq!(first("f(0, 1) = 1")["verdict"], "proved");
        let refuted = first("f(0, 1) = 2");
        assert_eq!((&refuted["verdict"], &refuted["holds"]), (&json!("refuted"), &json!(false)));
        assert!(refuted["text"].as_str().unwrap().contains("left side: 1"));
        let picture = first("figure_casteljau(bezier([[0,0],[1,2],[2,0]]), 1/2)");
        assert!(picture["svg"].as_str().unwrap().starts_with("<svg"));
        assert!(picture["tikz"].as_str().unwrap().contains("tikzpicture"));
        assert_eq!(first("polar")["kind"], "words");
        assert!(asked(&[], "derive(polar(t^2))").to_string().len() > 50);
    }

    #[test]
    fn several_statements_and_the_first_that_fails() {
        let all = asked(&[], "a := 1/2; a + 1; a + * 2");
        assert_eq!(all["answers"].as_array().unwrap().len(), 2, "{all}");
        assert!(all["problem"]["message"].is_string());
        let some = asked(&[], "a := 1/2; 1/0; 3");
        assert_eq!(some["answers"].as_array().unwrap().len(), 1);
        assert_eq!((&some["problem"]["from"], &some["problem"]["to"]), (&json!(12), &json!(13)), "{some}");
        assert_eq!(some["names"], json!(["a"]), "{some}");
    }

    #[test]
    fn a_passed_limit_is_told_and_the_session_goes_on() {
        let stopped = asked(&[], "2^(10^9)");
        assert_eq!(stopped["problem"]["code"], "E403", "{stopped}");
        assert_eq!(asked(&["2^(10^9)", "a := 2"], "a + 1")["answers"][0]["text"], "3");
        assert!(asked(&[], &"1+".repeat(40_000))["refused"].as_str().unwrap().contains("78 kB"));
    }
}
