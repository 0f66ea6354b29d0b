//! What stands at the head of a page and tells of it: blocks of YAML and TOML, lines of names and values.

use super::signs::line_at;

/// The length of the YAML or TOML block at the beginning.
pub(super) fn front_matter(text: &str) -> usize {
    let fence = line_at(text, 0).trim_end();
    if fence != "---" && fence != "+++" {
        return metadata(text);
    }
    let mut at = line_at(text, 0).len() + 1;
    while at < text.len() {
        let line = line_at(text, at);
        at += line.len() + 1;
        if line.trim_end() == fence || (fence == "---" && line.trim_end() == "...") {
            return at.min(text.len());
        }
    }
    0
}

/// Names of what lines at the head of a page tell of it.
const METADATA: [&str; 14] = [
    "author",
    "authors",
    "categories",
    "category",
    "date",
    "lang",
    "layout",
    "marp",
    "permalink",
    "slug",
    "status",
    "subtitle",
    "tags",
    "title",
];

/// The length of the lines `title: …` at the beginning, without a fence, as MultiMarkdown, Pelican and Hexo
/// know them. They end with a blank line or a fence.
fn metadata(text: &str) -> usize {
    let name = |line: &str| {
        let name = line.split_once(':')?.0;
        let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | ' ');
        (!name.is_empty() && name.len() < 40 && name.chars().all(plain)).then(|| name.to_ascii_lowercase())
    };
    if !name(line_at(text, 0)).is_some_and(|name| METADATA.contains(&name.as_str())) {
        return 0;
    }
    let mut at = 0;
    while at < text.len() {
        let line = line_at(text, at);
        let ends = line.trim().is_empty() || line.trim_end() == "---";
        if !ends && name(line).is_none() && !line.starts_with([' ', '\t', '-']) {
            return 0;
        }
        at = (at + line.len() + 1).min(text.len());
        if ends {
            break;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_at_the_head() {
        for text in [
            "---\ntitle: $x$\n---\n|",
            "+++\ntitle = \"$x$\"\n+++\n|",
            "Title: On $x$\nDate: 2020-01-01\nTags: a, b\n\n|",
            "title: On $x$\ntags:\n- a\n- b\n---\n|",
            "author: A\n    and B\n\n|",
        ] {
            assert_eq!(&text[front_matter(text)..], "|", "{text}");
        }
        for text in [
            "Given: $x$\n\n",
            "title: a\nSo $x$.\n",
            "Theorem: $x$\n",
            "--- $x$\n",
            "title\n",
            "",
            "---\n$x$\n",
        ] {
            assert_eq!(front_matter(text), 0, "{text}");
        }
    }
}
