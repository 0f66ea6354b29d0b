//! How derivations look, in each language: their titles and reasons.

use crate::common::derivations::derived;
use crate::common::transcripts;
use insta::assert_snapshot;
use polarform::blossom::Method;
use polarform::value::Language;
use polarform::write::{Format, write_derivation, write_words};

/// One derivation of each kind.
const KINDS: [&str; 14] = [
    "derive(polar, t^2 + 2t, method=bezier)",
    "derive(sum, t^2 + 2t, t^3 + 1)",
    "derive(product, t^2 + 2t, t + 1)",
    "derive(compose, t^2 + 2t, t^2 + 1)",
    "derive(derivative, t^3 + 3t^2 + 5t + 1, 2)",
    "derive(elevate, t^2 + 2t)",
    "derive(matrix, 2)",
    "derive(inverse_matrix, 2)",
    "derive(casteljau, bezier([[0, 0], [1, 2], [2, 0]]), 1/2)",
    "derive(deboor, bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 3/2)",
    "derive(insert, bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 3/2)",
    "derive(join, bezier([b_0, b_1, b_2]), bezier([c_0, c_1, c_2], 1, 2), 2)",
    "derive(newton, [0, 1, 3], [1, 2, 10])",
    "derive(moments, [0, 1, 2], [0, 1, 0])",
];

#[test]
fn each_kind_in_each_language() {
    for kind in KINDS {
        let name: String = kind.chars().skip(7).take_while(|c| *c != ',').collect();
        let derivation = derived(&[], kind);
        let mut page = String::new();
        for language in Language::ALL {
            page += &format!("{}\n", write_words(derivation.title.text(language), Format::Text));
            for format in [Format::Text, Format::Latex] {
                page += &write_derivation(&derivation, format, language).unwrap();
                page += "\n\n";
            }
        }
        assert_snapshot!(name, page);
    }
}

/// Queries that together give almost every reason.
fn many() -> Vec<String> {
    let mut queries = KINDS.map(str::to_owned).to_vec();
    queries.extend(Method::ALL.map(|method| format!("derive(polar, t^3 - t^2 + 2 t - 1, method={method})")));
    queries.extend(
        [
            "derive(polar, polar_tensor(u v, u, v, 1, 1))",
            "derive(polar, polar_total(u v, [u, v], degree=2))",
            "derive(sum, t, t^3)",
            "derive(product, t^4, t^4)",
            "derive(product, 2, t)",
            "derive(compose, t, t^2)",
            "derive(compose, t^4, t^3)",
            "derive(compose, 2, t)",
            "derive(derivative, t^2, 0)",
            "derive(derivative, t^2, 3)",
            "derive(elevate, bezier([1, 2]))",
            "derive(casteljau, bezier([1, 2], weights=[1, 2]), 1/2)",
            "derive(join, bezier([0, 1]), bezier([2, 3], 1, 2))",
            "derive(join, bezier([0, 1]), bezier([1, 2], 1, 2))",
            "derive(join, bezier([[a, 0], [b, 1]]), bezier([[c, 1], [d, 2]], 1, 2))",
            "derive(newton, [0, 0], [1, 2])",
            "derive(moments, [0, 1, 2], [0, 1, 0], ends=periodic)",
            "derive(moments, [0, 1, 2], [0, 1, 0], ends=not_a_knot)",
            "derive(moments, [0, 1, 2], [0, 1, 0], slopes=[1, 1])",
            "derive(moments, [0, 1, 2], [0, 1, 0], moments=[1, 1])",
        ]
        .map(str::to_owned),
    );
    queries
}

#[test]
fn words_are_complete() {
    for query in many() {
        let derivation = derived(&[], &query);
        for words in derivation.lines.iter().map(|line| &line.reason).chain([&derivation.title]) {
            for language in Language::ALL {
                let said = words.text(language);
                let pieces: Vec<&str> = said.split('`').collect();
                assert!(pieces.len() % 2 == 1 && !said.is_empty(), "{said}");
                for formula in pieces.iter().skip(1).step_by(2) {
                    polarform::syntax::parse(formula).unwrap_or_else(|problem| panic!("{said}: {problem:?}"));
                }
                let plain: String = pieces.into_iter().step_by(2).collect();
                let chinese = plain.chars().any(|c| ('\u{4e00}'..='\u{9fff}').contains(&c));
                assert!(language == Language::Chinese || !chinese, "{said}");
                assert!(!plain.contains(['#', '%', '&', '_', '$', '\\', '{']), "{said}");
                // Nothing is left untranslated.
                let names = plain.replace("de Casteljau", "").replace("de Boor", "");
                let english = names.chars().any(|c| c.is_ascii_alphabetic());
                assert!(language == Language::English || !english, "{said}");
            }
        }
    }
}

#[test]
fn on_the_command_line() {
    assert_snapshot!(transcripts([
        vec!["matrix", "--degree", "1", "--steps", "--inverse", "--lang", "zh"],
        vec![
            "eval",
            "derive(matrix, 1, lang=zh)",
            "derive(matrix, 1)",
            "--lang",
            "en",
            "--format",
            "unicode"
        ],
        vec!["polar", "t^2", "--steps", "--at", "0, 1", "--format", "sympy"],
        vec!["polar", "t^2", "--steps", "--format", "json"],
        vec!["matrix", "--degree", "1", "--steps", "--to", "[newton, 0, 1]"],
        vec!["eval", "derive(polar, t, lang=fr)"],
        vec!["eval", "derive(compse, t, t)"],
        vec!["eval", "derive()"],
        vec!["eval", "derive(3)"],
        vec!["eval", "derive(matrix, -1)"],
        vec!["eval", "derive(polar, t, method=euler)"],
        vec!["eval", "derive(polar, 1/t)"],
        vec!["eval", "derive(product, t)"],
        vec!["eval", "derive(derivative, [t, t^2])"],
        vec!["eval", "derive(casteljau, bezier([0, 1, 2]), 1, 2, 3)"],
        vec!["eval", "derive(insert, bspline(1, [0, 0, 1, 1], [2, 3]), 7)"],
        vec!["eval", "derive(newton, [0, 1, 0], [1, 2, 3])"],
        vec!["eval", "derive(moments, [0, 2, 1], [1, 2, 3])"],
        vec!["eval", "derive(moments, [0, 1], [1, 2], ends=clamped)"],
        vec!["eval", "derive(matrix, 100000)"],
        vec!["eval", "derive(roots, (t - 1)^2 (t^2 - 3), 0, 2)"],
        vec!["eval", "derive(roots, (t - 1)^2 (t^2 - 3), 0, 2)", "--lang", "zh", "--format", "latex"],
        vec!["eval", "derive(roots, 5)"],
        vec!["eval", "derive(roots, t, 2, 1)"],
        vec!["eval", "derive(roots, a t, 0, 1)"],
    ]));
}
