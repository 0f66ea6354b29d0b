//! HTML within Markdown: tags, and what holds no text of the page.
//!
//! Programs, styles, text as it is typed, comments and instructions are passed over up to their end, also over
//! blank lines. Reference: CommonMark 0.31, blocks of HTML of the kinds 1, 2, 3 and 5; `highlight` and `comment`
//! of Liquid.

use crate::formula::source::Pieces;

/// What opens a stretch without text, and what closes it. The names of tags stand without `>`.
const KINDS: [(&str, &str); 9] = [
    ("<!--", "-->"),
    ("<?", "?>"),
    ("<![CDATA[", "]]>"),
    ("<script", "</script"),
    ("<style", "</style"),
    ("<pre", "</pre"),
    ("<textarea", "</textarea"),
    ("{% highlight ", "{% endhighlight %}"),
    ("{% comment %}", "{% endcomment %}"),
];

/// What stands at a place.
pub(super) enum Found {
    Nothing,
    /// A stretch without text, up to this byte.
    Closed(usize),
    /// It opens here and is never closed; so many bytes are its sign.
    Open(usize),
}

/// Looks for stretches without text; remembers those that are never closed, so that all searches together
/// take time linear in the length of the text.
#[derive(Default)]
pub(super) struct Hidden {
    /// For each kind, whether none is closed from some place on.
    missing: [bool; KINDS.len()],
}

impl Hidden {
    /// What opens at `at`. The places of successive calls increase.
    pub(super) fn at(&mut self, text: &str, at: usize) -> Found {
        let rest = text.piece(at..);
        let Some(kind) = KINDS.iter().position(|(open, _)| opens(rest, open)) else { return Found::Nothing };
        let (open, close) = KINDS[kind];
        if self.missing[kind] {
            return Found::Nothing;
        }
        match find(rest, open.len(), close) {
            Some(end) => Found::Closed(at + end),
            None => {
                self.missing[kind] = true;
                Found::Open(open.len())
            }
        }
    }
}

fn opens(rest: &str, open: &str) -> bool {
    let head =
        rest.as_bytes().get(..open.len()).is_some_and(|head| head.eq_ignore_ascii_case(open.as_bytes()));
    let next = rest.as_bytes().get(open.len());
    head && match open {
        "<?" => next.is_some_and(u8::is_ascii_alphabetic),
        _ if is_tag(open) => next.is_none_or(|byte| byte.is_ascii_whitespace() || *byte == b'>'),
        _ => true,
    }
}

fn is_tag(open: &str) -> bool {
    open.ends_with(|c: char| c.is_ascii_alphabetic())
}

/// The byte after the closing sign; a closing tag goes on to its bracket.
fn find(rest: &str, from: usize, close: &str) -> Option<usize> {
    let is_close = |end: &&str| {
        end.as_bytes().get(..close.len()).is_some_and(|head| head.eq_ignore_ascii_case(close.as_bytes()))
    };
    let mark = close.piece(..1);
    let end = rest.piece(from..).match_indices(mark).map(|(at, _)| rest.piece(from + at..)).find(is_close)?;
    let after = rest.len() - end.len() + close.len();
    let bracket = if is_tag(close) { rest.piece(after..).find('>')? + 1 } else { 0 };
    Some(after + bracket)
}

/// The byte after the closing tag of this name.
pub(super) fn closing_tag(rest: &str, name: &str) -> Option<usize> {
    find(rest, 0, &format!("</{name}"))
}

/// Names of tags that may be taken for one: `<b` also begins a relation.
const TAGS: &[&str] = &[
    "a",
    "abbr",
    "article",
    "aside",
    "audio",
    "b",
    "blockquote",
    "body",
    "br",
    "button",
    "caption",
    "center",
    "cite",
    "code",
    "col",
    "colgroup",
    "dd",
    "del",
    "details",
    "dfn",
    "div",
    "dl",
    "dt",
    "em",
    "embed",
    "figcaption",
    "figure",
    "font",
    "footer",
    "form",
    "h1",
    "h2",
    "h3",
    "h4",
    "h5",
    "h6",
    "head",
    "header",
    "hr",
    "html",
    "i",
    "iframe",
    "img",
    "input",
    "ins",
    "kbd",
    "label",
    "legend",
    "li",
    "link",
    "main",
    "mark",
    "math",
    "meta",
    "nav",
    "noscript",
    "ol",
    "option",
    "p",
    "picture",
    "pre",
    "q",
    "s",
    "samp",
    "script",
    "section",
    "select",
    "small",
    "source",
    "span",
    "strike",
    "strong",
    "style",
    "sub",
    "summary",
    "sup",
    "svg",
    "table",
    "tbody",
    "td",
    "textarea",
    "tfoot",
    "th",
    "thead",
    "title",
    "tr",
    "tt",
    "u",
    "ul",
    "var",
    "video",
];

/// The length of the tag or address in angle brackets at the beginning, and its name if what it
/// encloses is no text.
pub(super) fn tag(rest: &str) -> Option<(usize, Option<&str>)> {
    let inner = rest.get(1..)?;
    let close = inner.bytes().take(2000).position(|byte| matches!(byte, b'>' | b'<'))?;
    if inner.as_bytes()[close] == b'<' {
        return None;
    }
    let content = inner.piece(..close);
    let len = close + 2;
    let address = content.contains("://") || content.starts_with("mailto:");
    if address && !content.contains(char::is_whitespace) {
        return Some((len, None));
    }
    let name = content.trim_start_matches('/');
    let name = name.piece(..name.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(name.len()));
    if !TAGS.iter().any(|tag| tag.eq_ignore_ascii_case(name)) {
        return None;
    }
    let attributes = content.trim_start_matches('/').piece(name.len()..).trim_end_matches('/').trim();
    let plausible = attributes.is_empty()
        || (attributes.contains('=') && attributes.starts_with(|c: char| c.is_ascii_alphabetic()))
        || name.len() > 2;
    let raw = ["code", "pre", "script", "style", "svg", "math", "kbd", "samp", "tt", "textarea"];
    let is_raw = raw.iter().any(|raw| raw.eq_ignore_ascii_case(name));
    let hidden = is_raw && !content.starts_with('/') && !content.ends_with('/');
    plausible.then_some((len, hidden.then_some(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closed(text: &str) -> Option<&str> {
        match Hidden::default().at(text, 0) {
            Found::Closed(end) => Some(&text[end..]),
            _ => None,
        }
    }

    #[test]
    fn stretches_without_text() {
        for text in [
            "<script>\n\na\n</script>|",
            "<SCRIPT type='a'>b</Script >|",
            "<pre\n>c</pre>|",
            "<!-- <script> -->|",
            "<?php $a ?>|",
            "<![CDATA[ $b ]]>|",
            "{% highlight js %}$c{% endhighlight %}|",
        ] {
            assert_eq!(closed(text), Some("|"), "{text}");
        }
        for text in ["<prefix></prefix>", "<? a ?>", "<script>", "<code>a</code>", "a <b", "<ä", "<!-- é"] {
            assert_eq!(closed(text), None, "{text}");
        }
    }

    #[test]
    fn a_sign_without_end_is_told_once() {
        let text = "<pre> é <pre> <style>a</style>";
        let mut hidden = Hidden::default();
        assert!(matches!(hidden.at(text, 0), Found::Open(4)));
        assert!(matches!(hidden.at(text, 9), Found::Nothing));
        assert!(matches!(hidden.at(text, 15), Found::Closed(end) if end == text.len()));
    }
}
