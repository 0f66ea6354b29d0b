use proptest::prelude::*;
use serde_json::Value;

use super::*;
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// The first occurrence of `part` in the text.
fn at(text: &str, part: &str) -> Span {
    let start = text.find(part).unwrap_or_else(|| panic!("{part:?} is not in the text"));
    Span::new(start, start + part.len())
}

/// A finding on `part` with the mark at the first `mark` within it.
fn finding(text: &str, part: &str, mark: &str, verdict: Verdict) -> Finding {
    let span = at(text, part);
    let mark = at(part, mark).shifted(span.start);
    Finding { verdict, ..Finding::new(span, mark, part.to_owned(), part.to_owned(), 1) }
}

fn some(text: &str) -> Option<String> {
    Some(text.to_owned())
}

/// Chinese words, a formula over several lines, a wide line.
fn lecture() -> FileReport {
    let long = "设多项式曲线的控制点为已知，".repeat(12);
    let text = format!(
        "# 极形式\n\n\
         设 $F(t)=t^2+2t$，则 $f(t_1,t_2)=t_1t_2+t_1+t_2$。\n\n\
         $$\n\\begin{{aligned}}\nF'(t) &= 3c_3t^2+2c_1t+c_1 \\\\\n&= 3 (f(t,t,1)-f(t,t,0))\n\\end{{aligned}}\n$$\n\n\
         {long}$\\sigma_{{1,2}} = t_1+t_2$ 而且 $\\sum_{{i=0}}^n B_i^n(t) = 1$。\n\n\
         其中 $t$ 与 $x > y$，$\\foo{{t}} = 1$\n"
    );
    let alone = Span::new(at(&text, "t$ 与").start, at(&text, "$ 与").start);
    let findings = vec![
        Finding {
            reason: some("F is used as t^2 + 2t from here on"),
            ..finding(&text, "F(t)=t^2+2t", "=", Verdict::Definition)
        },
        Finding {
            evidence: Vec::new(),
            determined: false,
            notes: vec!["f is the polar form of F".to_owned()],
            ..finding(&text, "f(t_1,t_2)=t_1t_2+t_1+t_2", "=", Verdict::Proved)
        },
        Finding {
            reason: some("the coefficient of t is 2 c_2, not 2 c_1"),
            witness: some("c_1 = 1, c_2 = 0, t = 1: left 0, right 2"),
            suggestion: some("F'(t) &= 3c_3t^2+2c_2t+c_1"),
            instances: some("4 instances: n from 0 to 3"),
            evidence: Vec::new(),
            determined: false,
            notes: vec!["F is c_0 + c_1 t + c_2 t^2 + c_3 t^3".to_owned()],
            ..finding(&text, "F'(t) &= 3c_3t^2+2c_1t+c_1", "3c_3t^2+2c_1t+c_1", Verdict::Refuted)
        },
        Finding {
            relation: 2,
            reason: some("the left side is wrong already"),
            witness: some("t = 1: left 3, right 4"),
            ..finding(&text, "3c_3t^2+2c_1t+c_1 \\\\\n&= 3 (f(t,t,1)-f(t,t,0))", "\\\\\n&=", Verdict::Refuted)
        },
        Finding {
            warning: some("σ_{1,2} is usually the mean (t_1 + t_2)/2"),
            suggestion: some("\\sigma_{1,2} = \\frac{t_1+t_2}{2}"),
            ..finding(&text, "\\sigma_{1,2} = t_1+t_2", "\\sigma_{1,2}", Verdict::Definition)
        },
        Finding {
            instances: some("7 instances: n from 0 to 6"),
            ..finding(&text, "\\sum_{i=0}^n B_i^n(t) = 1", "=", Verdict::Sampled)
        },
        Finding { span: alone, mark: alone, relation: 0, ..finding(&text, "t", "t", Verdict::Undecided) },
        Finding {
            reason: some("nothing is known of x and y"),
            ..finding(&text, "x > y", ">", Verdict::Undecided)
        },
        Finding {
            reason: some("\\foo is not known"),
            ..finding(&text, "\\foo{t} = 1", "\\foo", Verdict::Unread)
        },
    ];
    let problem = Diagnostic::warning(Code::Unbalanced, "the formula is not closed")
        .at(at(&text, "# 极形式"))
        .hint("close it with $");
    FileReport::new(SourceFile::new("lectures/极形式.md", text), findings, vec![problem])
}

/// Lines that end with CR LF, and text that would like to be markup.
fn windows() -> FileReport {
    let text =
        "Let\r\n$$\r\na <b\r\n&= c\r\n$$\r\n\r\n\t$\\text{<script>alert(1)</script>} = \u{1b}[31m0$\r\n";
    let findings = vec![
        Finding {
            witness: some("a = 1, b = 0: left 1, right 0"),
            ..finding(text, "a <b\r\n&= c", "<", Verdict::Refuted)
        },
        Finding {
            reason: some("the text \"<script>\u{1b}[31m\" is no formula"),
            suggestion: some("</code><script>alert(2)</script>"),
            ..finding(text, "\\text{<script>alert(1)</script>} = \u{1b}[31m0", "=", Verdict::Refuted)
        },
    ];
    FileReport::new(SourceFile::new("notes <b>.tex", text), findings, Vec::new())
}

fn both() -> Vec<FileReport> {
    vec![lecture(), windows()]
}

#[test]
fn tallies() {
    let tally = Tally::of(&both());
    assert_eq!((tally.statements(), tally.silent(), tally.warnings(), tally.problems()), (10, 1, 1, 1));
    assert_eq!((tally.claims(), tally.definitions(), tally.unseen()), (8, 2, 0));
    let mut sum = Tally::default();
    both().into_iter().for_each(|report| sum += Tally::of(&[report]));
    assert_eq!(sum, tally);
}

#[test]
fn text() {
    let plain = TextOptions::default();
    insta::assert_snapshot!("text_of_one_file", render_text(&[lecture()], plain));
    insta::assert_snapshot!(
        "text_of_two_files",
        render_text(&both(), TextOptions { verbose: true, ..plain })
    );
    let empty = FileReport::new(SourceFile::new("a.md", ""), vec![], vec![]);
    insta::assert_snapshot!(render_text(&[empty], plain), @"a.md: nothing to judge");
    assert_eq!(render_text(&[], plain), "");
}

#[test]
fn text_in_color_says_the_same() {
    for verbose in [false, true] {
        let plain = render_text(&both(), TextOptions { color: false, verbose, quiet: false });
        let colored = render_text(&both(), TextOptions { color: true, verbose, quiet: false });
        let mut stripped = String::new();
        let mut rest = colored.as_str();
        while let Some((before, after)) = rest.split_once('\x1b') {
            stripped.push_str(before);
            rest = after.split_once('m').expect("only styles are used").1;
        }
        stripped.push_str(rest);
        assert_eq!(stripped, plain);
        assert!(!plain.contains('\x1b'));
    }
}

#[test]
fn listing() {
    insta::assert_snapshot!("listing", render_listing(&both(), false));
    let json: Value = serde_json::from_str(&render_listing_json(&both())).expect("it is JSON");
    assert_eq!(json["files"][0]["formulas"][8]["reading"], Value::Null);
    assert_eq!(json["files"][0]["formulas"][1]["reading"], "f(t_1,t_2)=t_1t_2+t_1+t_2");
}

#[test]
fn json() {
    insta::assert_snapshot!("json", render_json(&both()));
}

#[test]
fn json_has_every_field() {
    let json: Value = serde_json::from_str(&render_json(&both())).expect("it is JSON");
    let fields = [
        "line",
        "column",
        "end_line",
        "end_column",
        "start",
        "end",
        "latex",
        "relation",
        "kind",
        "verdict",
        "reason",
        "witness",
        "evidence",
        "suggestion",
        "instances",
        "warning",
        "reading",
        "notes",
        "fingerprint",
    ];
    for formula in json["files"][0]["formulas"].as_array().expect("a list") {
        let keys: Vec<&str> = formula.as_object().expect("an object").keys().map(String::as_str).collect();
        assert_eq!(keys, fields);
    }
    let counts: Vec<u64> =
        Verdict::ALL.iter().map(|v| json["summary"][v.word()].as_u64().expect("a count")).collect();
    assert_eq!(counts, [2, 1, 1, 4, 2, 1]);
    let summary = &json["summary"];
    assert_eq!(
        (&summary["claims"], &summary["definitions"], &summary["unseen"]),
        (&8.into(), &2.into(), &0.into())
    );
    let first = &json["files"][0]["formulas"][0];
    assert_eq!(
        (&first["kind"], &first["end"]),
        (&"definition".into(), &(first["start"].as_u64().unwrap() + 11).into())
    );
}

#[test]
fn sarif() {
    insta::assert_snapshot!("sarif", render_sarif(&both()));
}

/// What SARIF 2.1.0 requires of the properties in use (sections 3.13, 3.14, 3.19, 3.20, 3.27,
/// 3.30, 3.55 to 3.58 of the specification).
#[test]
fn sarif_is_as_specified() {
    let strange = FileReport {
        problems: vec![Diagnostic::error(Code::File, "cannot read it")],
        ..FileReport::new(SourceFile::new("/no/such file.ipynb", ""), vec![], vec![])
    };
    let mut reports = both();
    reports.push(strange);
    let log: Value = serde_json::from_str(&render_sarif(&reports)).expect("it is JSON");
    assert_eq!(log["version"], "2.1.0");
    let runs = log["runs"].as_array().expect("runs");
    assert_eq!(runs.len(), 1);
    let run = &runs[0];
    assert!(["utf16CodeUnits", "unicodeCodePoints"].contains(&run["columnKind"].as_str().expect("text")));
    let driver = &run["tool"]["driver"];
    assert_eq!(
        (&driver["name"], &driver["version"]),
        (&"polarform".into(), &env!("CARGO_PKG_VERSION").into())
    );
    let rules = driver["rules"].as_array().expect("rules");
    let artifacts = run["artifacts"].as_array().expect("artifacts");
    let results = run["results"].as_array().expect("results");
    assert_eq!(results.len(), 7);
    let location = |place: &Value| {
        let artifact = &place["artifactLocation"];
        let index = artifact["index"].as_u64().expect("an index") as usize;
        assert_eq!(artifacts[index]["location"]["uri"], artifact["uri"]);
        let uri = artifact["uri"].as_str().expect("a URI");
        assert!(uri.is_ascii() && !uri.contains([' ', '<', '"']), "{uri}");
        index
    };
    let inside = |region: &Value, text: &str| {
        let number = |name: &str| region[name].as_u64().expect("a number") as usize;
        let (line, end_line) = (number("startLine"), number("endLine"));
        assert!((1..=end_line).contains(&line));
        assert!(line < end_line || number("startColumn") <= number("endColumn"));
        let lines: Vec<&str> = text.split('\n').collect();
        for (line, column) in [(line, number("startColumn")), (end_line, number("endColumn"))] {
            assert!((1..=lines[line - 1].encode_utf16().count() + 1).contains(&column), "{region}");
        }
    };
    for result in results {
        let rule = &rules[result["ruleIndex"].as_u64().expect("an index") as usize];
        assert_eq!(rule["id"], result["ruleId"]);
        assert_eq!(rule["defaultConfiguration"]["level"], result["level"]);
        assert!(!result["message"]["text"].as_str().expect("a message").is_empty());
        assert!(rule["helpUri"].as_str().is_some_and(|uri| uri.starts_with("https://")));
        assert!(result["partialFingerprints"]["polarformFormula/v1"].is_string());
        let place = &result["locations"][0]["physicalLocation"];
        let index = location(place);
        inside(&place["region"], reports[index].file.text());
        for fix in result["fixes"].as_array().into_iter().flatten() {
            for change in fix["artifactChanges"].as_array().expect("changes are required") {
                assert_eq!(location(change), index);
                for replacement in change["replacements"].as_array().expect("replacements are required") {
                    inside(&replacement["deletedRegion"], reports[index].file.text());
                    assert!(replacement["insertedContent"]["text"].is_string());
                }
            }
        }
    }
    let invocation = &run["invocations"][0];
    assert_eq!(invocation["executionSuccessful"], false);
    let notifications = invocation["toolExecutionNotifications"].as_array().expect("a list");
    assert_eq!(notifications.len(), 2);
    let codes = driver["notifications"].as_array().expect("a list");
    for notification in notifications {
        assert!(codes.iter().any(|code| code["id"] == notification["descriptor"]["id"]));
        location(&notification["locations"][0]["physicalLocation"]);
    }
}

#[test]
fn a_fix_in_a_notebook_is_a_piece_of_a_string() {
    let text = "{\"source\": [\"$\\\\sigma = 1$\\n\"]}";
    let findings = vec![Finding {
        suggestion: some("\\sigma = \"2\""),
        ..finding(text, "\\\\sigma = 1", "=", Verdict::Refuted)
    }];
    let report = FileReport::new(SourceFile::new("a.ipynb", text), findings, vec![]);
    let log: Value = serde_json::from_str(&render_sarif(&[report])).expect("it is JSON");
    let fix = &log["runs"][0]["results"][0]["fixes"][0]["artifactChanges"][0]["replacements"][0];
    assert_eq!(fix["insertedContent"]["text"], "\\\\sigma = \\\"2\\\"");
}

#[test]
fn html() {
    insta::with_settings!({filters => vec![
        (r"(?s)<style>.*?</style>", "<style>…</style>"),
        ("sha256-[^']*", "sha256-…"),
        (r"(?s)<script>const.*?</script>", "<script>…</script>"),
        (r"(</(p|article|h1|h2|dd|section|details|header|head|button)>)", "$1\n"),
    ]}, {
        insta::assert_snapshot!("html", render_html(&both()));
    });
}

#[test]
fn html_holds_no_foreign_markup() {
    let page = render_html(&both());
    assert_eq!(page.matches("<script").count(), 1);
    assert!(!page.contains("notes <b>"));
    // A script of a reader's notes would not run if it came into the page.
    assert!(!page.contains("script-src 'unsafe-inline'") && page.contains("script-src 'sha256-"));
    assert!(!page.contains('\x1b') && !page.contains('\r'));
    assert!(!page.contains("http://") && !page.contains("https://"), "the page needs no network");
}

/// Reports with spans and texts that fit nothing.
fn report() -> impl Strategy<Value = FileReport> {
    let words = "[a中𝒇\\\\{}^_&<>\"'\u{1b}\t\r\n ]{0,20}";
    let finding = (
        prop::array::uniform4(0usize..80),
        prop::sample::select(Verdict::ALL.to_vec()),
        0usize..3,
        prop::array::uniform6(prop::option::of(words)),
        words,
    );
    (words, prop::collection::vec(finding, 0..5)).prop_map(|(text, findings)| FileReport {
        file: SourceFile::new("x.md", text),
        findings: findings
            .into_iter()
            .map(
                |(
                    [a, b, c, d],
                    verdict,
                    relation,
                    [reason, witness, suggestion, instances, warning, note],
                    latex,
                )| {
                    Finding {
                        span: Span::new(a, b),
                        mark: Span::new(c, d),
                        reading: latex.clone(),
                        latex,
                        relation,
                        verdict,
                        reason,
                        witness,
                        suggestion,
                        instances,
                        warning,
                        evidence: Vec::new(),
                        determined: false,
                        notes: note.into_iter().collect(),
                    }
                },
            )
            .collect(),
        problems: vec![Diagnostic::error(Code::Unbalanced, "open").at(Span::new(70, 90))],
        left_out: 0,
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_report_can_be_written(reports in prop::collection::vec(report(), 0..3)) {
        for verbose in [false, true] {
            let text = render_text(&reports, TextOptions { color: false, verbose, quiet: false });
            prop_assert!(!text.contains('\x1b'), "{}", text);
        }
        for json in [render_json(&reports), render_sarif(&reports), render_listing_json(&reports)] {
            prop_assert!(serde_json::from_str::<Value>(&json).is_ok());
        }
        prop_assert!(!render_listing(&reports, false).contains('\x1b'));
        let xml = render_junit(&reports);
        prop_assert!(roxmltree::Document::parse(&xml).is_ok(), "{}", xml);
        for verbose in [false, true] {
            // Whatever stands in the notes, each line is one command, and the last one has the numbers.
            let text = render_github(&reports, verbose);
            let lines: Vec<&str> = text.split_terminator('\n').collect();
            let (last, commands) = lines.split_last().expect("there are numbers");
            prop_assert!(last.starts_with("polarform: ") && !text.contains('\r'), "{}", text);
            for command in commands {
                let known = ["error", "warning", "notice"].map(|level| format!("::{level} file=x.md"));
                prop_assert!(known.iter().any(|start| command.starts_with(start)), "{}", command);
            }
        }
        prop_assert_eq!(render_html(&reports).matches("<script").count(), 1);
    }
}
