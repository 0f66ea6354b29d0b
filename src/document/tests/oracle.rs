//! The formulas of well-made Markdown are those that another reader finds.

use markdown::mdast::Node;
use markdown::{Constructs, ParseOptions, to_mdast};
use proptest::prelude::*;

use super::*;

/// The formulas with their first lines.
fn others(text: &str) -> Vec<(String, usize)> {
    let constructs = Constructs { math_flow: true, math_text: true, frontmatter: true, ..Constructs::gfm() };
    let options = ParseOptions { constructs, ..ParseOptions::gfm() };
    let tree = to_mdast(text, &options).expect("Markdown without MDX is always read");
    let mut found = Vec::new();
    walk(&tree, &mut found);
    found
}

fn walk(node: &Node, found: &mut Vec<(String, usize)>) {
    let line = node.position().map_or(0, |position| position.start.line);
    match node {
        // The line of a display is that of its opening sign.
        Node::Math(math) => found.push((squeezed(&math.value), line + 1)),
        Node::InlineMath(math) => found.push((squeezed(&math.value), line)),
        _ => {}
    }
    for child in node.children().into_iter().flatten() {
        walk(child, found);
    }
}

/// Without the blanks, in which the two differ.
fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn formula() -> impl Strategy<Value = String> {
    let part =
        prop::sample::select(vec!["a", "_1", "^{2}", "= t", "\\frac{1}{2}", " + ", "\\\\ ", "*b*", "<c>"]);
    prop::collection::vec(part, 1..5).prop_map(|parts| format!("t{}", parts.concat().trim_end()))
}

/// A block, which may hold blocks.
fn block() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        formula().prop_map(|formula| format!("so ${formula}$ it is\n")),
        (formula(), formula()).prop_map(|(a, b)| format!("so ${a}$ or\n`$x$` and $${b}$$, it is\n")),
        formula().prop_map(|formula| format!("$$\n{formula}\n= 1\n$$\n")),
        (formula(), formula()).prop_map(|(a, b)| format!("then\n$$\n{a}\n\n{b}\n$$\nand\n")),
        formula().prop_map(|formula| format!("## On ${formula}$\n")),
        formula().prop_map(|formula| format!("```\n${formula}$\n```\n")),
        formula().prop_map(|formula| format!("| a | b |\n|---|---|\n| x | ${formula}$ |\n")),
        Just("***\n".to_owned()),
        Just("[text](b.md) and *more*\n".to_owned()),
    ];
    leaf.prop_recursive(3, 12, 3, |inner| {
        (prop::sample::select(vec!["> ", "- ", "3. "]), prop::collection::vec(inner, 1..3)).prop_map(
            |(mark, blocks)| {
                let rest = if mark == "> " { "> ".to_owned() } else { " ".repeat(mark.len()) };
                let text = blocks.join("\n");
                let lines = text.lines().enumerate();
                lines.map(|(i, line)| format!("{}{line}\n", if i == 0 { mark } else { &rest })).collect()
            },
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn formulas_are_those_of_another_reader(blocks in prop::collection::vec(block(), 1..5)) {
        let text = blocks.join("\n");
        let notes = markdown(&text);
        prop_assert_eq!(&notes.problems, &[]);
        let found: Vec<_> = formulas(&notes)
            .into_iter()
            .filter(|formula| formula.style != crate::document::Style::Plain)
            .map(|formula| (squeezed(&formula.text), notes.file.line_column(formula.span.start).0))
            .collect();
        prop_assert_eq!(found, others(&text), "{}", text);
    }
}
