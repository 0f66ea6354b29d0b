//! The file of results beside a LaTeX document, `lecture.polarform.tex`.
//!
//! Each entry is what `polarform.sty` reads: the query, by which TeX finds it, and the result. A line of
//! `%%%` opens an entry, so that the entries of the file before can be told apart without a reader of TeX.

use std::collections::BTreeMap;

const STAMP: &str = "% woven by polarform ";
const ENTRY: &str = "\n%%% ";
const END: &str = "\\endinput\n";

/// A query with its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// What TeX finds it by, written as the beginning of the entry.
    pub(super) key: String,
    /// The rest of the entry.
    pub(super) result: String,
}

impl Entry {
    /// A query within a line: its text between the braces, and the formula.
    pub(super) fn inline(query: &str, formula: &str) -> Self {
        Entry { key: inline_key(query), result: format!("{{{formula}}}") }
    }

    /// A block: the text between `\begin{polarform}` and its end, with the options, and the lines of
    /// the result.
    pub(super) fn block(query: &str, show_code: bool, lines: &[String]) -> Self {
        let code = if show_code { "code" } else { "" };
        let mut result = format!("\\polarformblock{{{code}}}{{%\n");
        for line in lines {
            result.push_str(line);
            result.push('\n');
        }
        // A line end would be a blank in the text.
        if result.ends_with('\n') && !lines.is_empty() {
            result.pop();
            result.push_str("%\n");
        }
        result.push('}');
        Entry { key: block_key(query), result }
    }
}

pub(super) fn inline_key(query: &str) -> String {
    format!("\\polarformresult{{{query}}}")
}

pub(super) fn block_key(query: &str) -> String {
    format!("\\begin{{polarformquery}}{query}\\end{{polarformquery}}\n")
}

/// The results of the run before, by their queries, in their order.
#[derive(Debug, Default)]
pub(super) struct Before<'a> {
    pub(super) stamp: Option<&'a str>,
    /// All after the line of the stamp.
    pub(super) body: &'a str,
    entries: BTreeMap<&'a str, Vec<&'a str>>,
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
            let split = if entry.starts_with(r"\polarformresult{") {
                // The result is the last group; braces in it are balanced.
                last_group(entry)
            } else {
                entry.rfind("\\end{polarformquery}\n").map(|at| at + "\\end{polarformquery}\n".len())
            };
            if let Some(split) = split {
                before.entries.entry(&entry[..split]).or_default().push(&entry[split..]);
            }
        }
        before
    }

    /// The results of a query, one for each time that it stands with another result.
    pub(super) fn results(&self, key: &str) -> &[&'a str] {
        self.entries.get(key).map_or(&[], Vec::as_slice)
    }
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

/// The body of the file: all entries, each query once unless it has several results.
pub(super) fn body(document: &str, entries: &[Entry]) -> String {
    let document = document.replace(['\n', '\r'], " ");
    let mut out = format!("% Results for {document}, read by polarform.sty; do not edit.");
    let mut results: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for entry in entries {
        results.entry(&entry.key).or_default().push(&entry.result);
    }
    let mut written: BTreeMap<&str, usize> = BTreeMap::new();
    for (number, entry) in entries.iter().enumerate() {
        let all = &results[entry.key.as_str()];
        let times = written.entry(&entry.key).or_default();
        *times += 1;
        if *times == 1 || all.iter().any(|result| *result != all[0]) {
            out.push_str(&format!("{ENTRY}{}\n{}{}", number + 1, entry.key, entry.result));
        }
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

    #[test]
    fn entries_are_found_again() {
        let lines = [r"\[".to_owned(), r"\frac{1}{2}".to_owned(), r"\]".to_owned()];
        let entries = [
            Entry::inline(r"\frac{a}{b}", r"\frac{1}{2}"),
            Entry::block("[steps]\nf := 1\n", true, &lines),
            Entry::inline("a", "1"),
            Entry::inline("a", "1"),
            Entry::inline("b", "1"),
            Entry::inline("b", "2"),
        ];
        let text = file(&body("a.tex", &entries), Some("0123456789abcdef"));
        let before = Before::new(&text);
        assert_eq!(before.stamp, Some("0123456789abcdef"));
        assert_eq!(before.results(&inline_key(r"\frac{a}{b}")), [r"{\frac{1}{2}}"]);
        assert_eq!(before.results(&inline_key("a")), ["{1}"]);
        assert_eq!(before.results(&inline_key("b")), ["{1}", "{2}"]);
        let block = before.results(&block_key("[steps]\nf := 1\n"));
        assert_eq!(block, ["\\polarformblock{code}{%\n\\[\n\\frac{1}{2}\n\\]%\n}"]);
        assert!(before.results("c").is_empty());
        assert_eq!(file(before.body, before.stamp), text);
    }

    #[test]
    fn the_last_entry_ends_where_the_file_ends() {
        let text = file(&body("a.tex", &[Entry::inline("a", "1")]), None);
        let before = Before::new(&text);
        assert_eq!(before.stamp, None);
        assert_eq!(before.results(&inline_key("a")), ["{1}"]);
    }
}
