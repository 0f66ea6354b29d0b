//! What can be typed in a query: functions, names defined before it, commands of LaTeX.

use std::collections::BTreeSet;

use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionTextEdit, Documentation, MarkupContent, MarkupKind, Range,
    TextEdit,
};

use super::places::Places;
use crate::document::options_in;
use crate::formula::source::floor_boundary;
use crate::language::functions::{BUILTINS, Builtin};
use crate::language::latex;

/// A query is not longer; what stands further back belongs to something else.
const LONGEST: usize = 4096;

/// What can stand for the word before a byte, if that is in a query: `{{ … }}`, `\polarform{…}`, a block of queries.
pub(super) fn completions(text: &str, places: &Places, byte: usize) -> Vec<CompletionItem> {
    let byte = floor_boundary(text, byte);
    let Some(start) = query(&text[..byte]) else { return Vec::new() };
    let letter = |c: char| c.is_alphanumeric() || c == '_';
    let before = &text[start..byte];
    let word = &before[before.trim_end_matches(letter).len()..];
    let range = Range::new(places.position(text, byte - word.len()), places.position(text, byte));
    if before[..before.len() - word.len()].ends_with('\\') {
        let known = latex::commands().iter().filter(|command| command.is_supported());
        let names = known.map(|command| command.name().trim_start_matches('\\'));
        return names
            .filter(|name| !word.is_empty() && name.starts_with(word))
            .map(|name| item(name, CompletionItemKind::KEYWORD, range))
            .collect();
    }
    let own = defined(&text[..start]).into_iter().chain(defined(before)).collect::<BTreeSet<_>>();
    let own = own.iter().filter(|name| name.starts_with(word) && *name != word);
    let own = own.map(|name| item(name, CompletionItemKind::VARIABLE, range));
    let functions = BUILTINS.iter().filter(|function| function.name.starts_with(word));
    own.chain(functions.map(|function| described(function, range))).collect()
}

/// The range of what is typed stands in each item, so that a client need not guess where the word begins.
fn item(name: &str, kind: CompletionItemKind, range: Range) -> CompletionItem {
    CompletionItem {
        label: name.to_owned(),
        kind: Some(kind),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(range, name.to_owned()))),
        ..CompletionItem::default()
    }
}

fn described(function: &Builtin, range: Range) -> CompletionItem {
    let value = format!("{}\n\n```\n{}\n```", function.summary, function.example);
    CompletionItem {
        detail: Some(function.signature()),
        documentation: Some(Documentation::MarkupContent(MarkupContent {
            kind: MarkupKind::Markdown,
            value,
        })),
        ..item(function.name, CompletionItemKind::FUNCTION, range)
    }
}

/// Where the query begins that is open at the end of a text.
fn query(before: &str) -> Option<usize> {
    match block(before) {
        Block::Queries(start) => Some(start),
        Block::Other => None,
        Block::Outside => in_line(before),
    }
}

/// A query in a line: the last braces that are not closed.
fn in_line(before: &str) -> Option<usize> {
    let window = floor_boundary(before, before.len().saturating_sub(LONGEST));
    let near = &before[window..];
    let braces = near.rfind("{{").map(|at| at + 2).filter(|at| {
        let inside = &near[*at..];
        let other = inside.starts_with(['#', '<', '%']) || near[..at - 2].ends_with('\\');
        !other && !inside.contains("}}") && !inside.contains("\n\n")
    });
    let command = near.rfind("\\polarform{").map(|at| at + "\\polarform{".len()).filter(|at| {
        let depth = near[*at..].chars().try_fold(0_usize, |depth, c| match c {
            '{' => Some(depth + 1),
            '}' => depth.checked_sub(1),
            _ => Some(depth),
        });
        depth.is_some()
    });
    braces.max(command).map(|at| window + at)
}

/// The block that is open at the end of a text.
enum Block {
    Queries(usize),
    Other,
    Outside,
}

fn block(before: &str) -> Block {
    let begin = "\\begin{polarform}";
    if let Some(at) = before.rfind(begin)
        && !before[at..].contains("\\end{polarform}")
    {
        return Block::Queries(at + begin.len());
    }
    let mut open: Option<(&str, Option<usize>)> = None;
    let mut at = 0;
    for line in before.split_inclusive('\n') {
        at += line.len();
        let bare = line.trim_start_matches([' ', '>']).trim_end();
        let sign = if bare.starts_with("~~~") { '~' } else { '`' };
        let info = bare.trim_start_matches(sign);
        let fence = &bare[..bare.len() - info.len()];
        if fence.len() < 3 {
            continue;
        }
        open = match open {
            None if !info.contains('`') => Some((fence, options_in(info).map(|_| at))),
            Some((opened, _)) if fence.starts_with(opened) && info.is_empty() => None,
            other => other,
        };
    }
    match open {
        Some((_, Some(start))) => Block::Queries(start),
        Some((_, None)) => Block::Other,
        None => Block::Outside,
    }
}

/// The names before a `:=`, with or without arguments.
fn defined(text: &str) -> BTreeSet<String> {
    let name = |(at, _): (usize, &str)| {
        let mut head = text[..at].trim_end();
        if head.ends_with(')') {
            head = head[..head.rfind('(')?].trim_end();
        }
        let letter = |c: char| c.is_alphanumeric() || c == '_';
        let name = &head[head.trim_end_matches(letter).len()..];
        (!name.is_empty() && !name.starts_with(|c: char| c.is_ascii_digit())).then(|| name.to_owned())
    };
    text.match_indices(":=").filter_map(name).collect()
}

/// Whether a place may be in a query at all, before the text is looked at.
pub(super) const TRIGGERS: [&str; 2] = ["{", "\\"];

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(text: &str) -> Vec<String> {
        let (before, after) = text.split_once('|').expect("a place");
        let text = format!("{before}{after}");
        let places = Places::new(&text);
        completions(&text, &places, before.len()).into_iter().map(|item| item.label).collect()
    }

    #[test]
    fn in_queries_only() {
        for page in [
            "Then $f(0) = {{ pola|",
            "Then {{ pola| }} and more",
            "```polarform\nf := pola|\n```\n",
            "~~~ {.polarform hide}\npola|",
            "> ```polarform\n> pola|",
            "\\begin{polarform}[steps=true]\nf := pola|\n\\end{polarform}",
            "\\(\\polarform{\\frac{1}{2} + pola|}\\)",
        ] {
            let found = labels(page);
            assert!(
                found.contains(&"polar".to_owned()) && found.contains(&"polar_sum".to_owned()),
                "{page}: {found:?}"
            );
        }
        for page in [
            "pola|",
            "{{ f }} pola|",
            "{{#include pola|",
            "{{< pola|",
            "\\{{ pola|",
            "{{ a\n\npola|",
            "```python\n{{ pola|",
            "```polarform\nf\n```\npola|",
            "\\polarform{f} pola|",
            "\\begin{polarform}\\end{polarform} pola|",
        ] {
            assert_eq!(labels(page), Vec::<String>::new(), "{page}");
        }
    }

    #[test]
    fn names_of_the_page_come_first() {
        let found = labels("```polarform\ncurve(t) := t^2\ncurve_2 := 3; x = 1\n```\nand {{ 2 cur| }}");
        assert_eq!(found[..2], ["curve", "curve_2"]);
        assert!(found.contains(&"curvature".to_owned()), "{found:?}");
        assert_eq!(labels("设 {{ 𝒇 := 1; \\fra|"), ["frac"]);
        assert!(labels("{{ | }}").len() > 150);
    }
}
