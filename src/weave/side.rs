//! The file of results beside a LaTeX document, `lecture.polarform.tex`.
//!
//! Each entry is what `polarform.sty` reads: the query, by which TeX finds it, and the result. A line of
//! `%%%` opens an entry, so that the entries of the file before can be told apart without a reader of TeX.

use crate::formula::source::Pieces;
use std::collections::{BTreeMap, BTreeSet};

const STAMP: &str = "% woven by polarform ";
const ENTRY: &str = "\n%%% ";
const INLINE: &str = r"\polarformresult{";
const BLOCK: &str = r"\begin{polarformquery}";
const BLOCK_END: &str = "\\end{polarformquery}\n\\polarformblock{";
const END: &str = "\\endinput\n";

/// A query with its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// What TeX finds it by, together with the state.
    pub(super) key: Key,
    /// What to set, in braces; for a block also whether its code is shown.
    pub(super) result: String,
    /// The number of the state that it is found in.
    pub(super) state: usize,
    /// The state that it leads to: a new one if it defines a name, so that the same query may have
    /// another result afterwards.
    pub(super) next: usize,
}

/// The text of a query.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Key {
    /// Between the braces of `\polarform{…}`.
    Inline(String),
    /// From `\begin{polarform}` to its end, with the options.
    Block(String),
}

/// The result of a query within a line.
pub(super) fn inline_result(formula: &str) -> String {
    format!("{{{formula}}}")
}

/// The result of a block: its lines, and whether the code is shown.
pub(super) fn block_result(show_code: bool, lines: &[String]) -> String {
    let code = if show_code { "code" } else { "" };
    // A line end at the end would be a blank in the text.
    let end = if lines.is_empty() { "" } else { "%\n" };
    format!("{{{code}}}{{%\n{}{end}}}", lines.join("\n"))
}

/// The results of the run before, by their queries, in their order.
#[derive(Debug, Default)]
pub(super) struct Before<'a> {
    pub(super) stamp: Option<&'a str>,
    /// All after the line of the stamp.
    pub(super) body: &'a str,
    entries: BTreeMap<Key, Vec<(usize, &'a str)>>,
}

impl<'a> Before<'a> {
    /// Takes the text of the file apart; what is not ours is passed over.
    pub(super) fn new(text: &'a str) -> Self {
        let (first, body) = text.split_once('\n').unwrap_or((text, ""));
        let stamp = first.strip_prefix(STAMP).and_then(|rest| rest.split_once(": ")).map(|(_, stamp)| stamp);
        let mut before = Before { stamp, body, entries: BTreeMap::new() };
        let content = body.strip_suffix(END).unwrap_or(body);
        for piece in content.split(ENTRY).skip(1) {
            let Some((_, entry)) = piece.split_once('\n') else { continue };
            let entry = entry.strip_suffix('\n').unwrap_or(entry);
            if let Some((key, state, result)) = read_entry(entry) {
                before.entries.entry(key).or_default().push((state, result));
            }
        }
        before
    }

    /// Whether a query had this result.
    pub(super) fn has(&self, key: &Key, result: &str) -> bool {
        self.entries.get(key).is_some_and(|all| all.iter().any(|(_, old)| *old == result))
    }

    /// The result of a query in a state; in any state, if it always had the same one.
    pub(super) fn result(&self, key: &Key, state: usize) -> Option<&'a str> {
        let all = self.entries.get(key)?;
        let here = all.iter().find(|(old, _)| *old == state).map(|(_, result)| *result);
        let first = all.first().map(|(_, result)| *result);
        here.or(first.filter(|first| all.iter().all(|(_, result)| result == first)))
    }
}

/// The query, the state and the result of an entry.
fn read_entry(entry: &str) -> Option<(Key, usize, &str)> {
    let state = |numbers: &str| numbers.split('}').next()?.parse().ok();
    if let Some(rest) = entry.strip_prefix(INLINE) {
        // The result is the last group; braces in it are balanced.
        let split = last_group(rest)?;
        let (numbers, query) = rest.piece(..split).split_at(rest.piece(..split).match_indices('{').nth(1)?.0);
        return Some((
            Key::Inline(query.get(1..query.len() - 1)?.to_owned()),
            state(numbers)?,
            rest.piece(split..),
        ));
    }
    let rest = entry.strip_prefix(BLOCK)?;
    let at = rest.rfind(BLOCK_END)?;
    let numbers = rest.piece(at + BLOCK_END.len()..);
    let result = numbers.match_indices('{').nth(1)?.0;
    Some((Key::Block(rest.piece(..at).to_owned()), state(numbers)?, numbers.piece(result..)))
}

/// Where the last group in braces of a text begins.
fn last_group(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    let mut start = None;
    let mut escaped = false;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'{' => {
                if depth == 0 {
                    start = Some(at);
                }
                depth += 1;
            }
            b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    start
}

/// The body of the file: all entries, each query once in each state.
pub(super) fn body(document: &str, entries: &[Entry]) -> String {
    let document = document.replace(['\n', '\r'], " ");
    let mut out = format!("% Results for {document}, read by polarform.sty; do not edit.");
    let mut written = BTreeSet::new();
    for (number, Entry { key, state, next, result }) in entries.iter().enumerate() {
        if !written.insert((*state, key)) {
            continue;
        }
        out.push_str(&format!("{ENTRY}{}\n", number + 1));
        out.push_str(&match key {
            Key::Inline(query) => format!("{INLINE}{state}}}{{{next}}}{{{query}}}{result}"),
            Key::Block(query) => format!("{BLOCK}{query}{BLOCK_END}{state}}}{{{next}}}{result}"),
        });
    }
    out.push('\n');
    out.push_str(END);
    out
}

/// The file with its stamp, or without one.
pub(super) fn file(body: &str, stamp: Option<&str>) -> String {
    let version = super::stamp::VERSION;
    match stamp {
        Some(stamp) => format!("{STAMP}{version}: {stamp}\n{body}"),
        None => format!("{STAMP}{version}\n{body}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inline(query: &str, formula: &str, state: usize, next: usize) -> Entry {
        Entry { key: Key::Inline(query.to_owned()), result: inline_result(formula), state, next }
    }

    #[test]
    fn entries_are_found_again() {
        let lines = [r"\[".to_owned(), r"\frac{1}{2}".to_owned(), r"\]".to_owned()];
        let block = Key::Block("[steps]\nf := 1\n".to_owned());
        let entries = [
            inline(r"\frac{a}{b}", r"\frac{1}{2}", 0, 0),
            Entry { key: block.clone(), result: block_result(true, &lines), state: 0, next: 1 },
            inline("a", "1", 1, 1),
            inline("a", "1", 1, 1),
            inline("b := 2", "b = 2", 1, 2),
            inline("a", "2", 2, 2),
        ];
        let text = file(&body("a.tex", &entries), Some("0123456789abcdef"));
        let before = Before::new(&text);
        assert_eq!(before.stamp, Some("0123456789abcdef"));
        assert_eq!(before.result(&entries[0].key, 0), Some(r"{\frac{1}{2}}"));
        assert_eq!(before.result(&entries[0].key, 7), Some(r"{\frac{1}{2}}"));
        let a = &entries[2].key;
        assert_eq!([0, 1, 2].map(|state| before.result(a, state)), [None, Some("{1}"), Some("{2}")]);
        assert!(before.has(a, "{2}") && !before.has(a, "{3}"));
        let result = "{code}{%\n\\[\n\\frac{1}{2}\n\\]%\n}";
        assert_eq!(before.result(&block, 0), Some(result));
        assert_eq!(text.matches("%%% ").count(), 5);
        assert_eq!(file(before.body, before.stamp), text);
    }

    #[test]
    fn whatever_stands_in_the_file() {
        for text in [
            "",
            "a",
            "a\n\n%%% 1\n",
            "a\n\n%%% 1\n\\polarformresult{}",
            "a\n\n%%% 1\n\\polarformresult{0}{{1",
        ] {
            assert!(Before::new(text).entries.is_empty(), "{text}");
        }
    }
}
