//! The queries of a LaTeX file: `\polarform{…}` and the environment `polarform`.
//!
//! What TeX does not read is passed over: comments, verbatim text, what stands between `\iffalse` and
//! `\fi` and after `\end{document}`. A query with a `#` stands in the definition of a macro and has no
//! text of its own.

use super::arguments::command_name;
use super::inline::nearby;
use super::parts::{Layout, Part, PartKind};
use super::signs::{braced_name, line_at};
use super::vocabulary::VERBATIM;
use crate::document::Places;
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// The environment and the command of a query.
const NAME: &str = "polarform";

/// A query in braces is not longer.
const MAX_QUERY: usize = 1 << 14;

/// Takes a LaTeX text apart.
pub(super) fn scan(text: &str) -> (Vec<Part>, Vec<Diagnostic>) {
    let mut scanner = Scanner { text, layout: Layout::default(), problems: Vec::new(), missing: Vec::new() };
    let mut at = 0;
    while at < text.len() {
        at = match text.as_bytes()[at] {
            b'%' => at + line_at(text, at).len(),
            b'\\' => scanner.command(at),
            _ => at + 1,
        };
    }
    (scanner.layout.parts, scanner.problems)
}

struct Scanner<'a> {
    text: &'a str,
    layout: Layout,
    problems: Vec<Diagnostic>,
    /// Ends that were looked for and do not come any more.
    missing: Vec<String>,
}

impl Scanner<'_> {
    /// The byte after the command at `at`, or after all that belongs to it.
    fn command(&mut self, at: usize) -> usize {
        let name = command_name(self.text, at);
        let after = at + 1 + name.len();
        match name {
            NAME => self.query(at, after),
            "begin" => self.begin(at, after),
            "end" if self.text.piece(after..).starts_with("{document}") => self.text.len(),
            "verb" | "lstinline" => self.verbatim(after),
            "iffalse" => self.find(after, r"\fi").map_or(after, |found| found + 3),
            "input" | "include" | "subfile" => self.named(PartKind::Include, at, after),
            "usepackage" | "RequirePackage" => {
                let after = self.brackets(after).1;
                self.named(PartKind::Package, at, after)
            }
            _ => after,
        }
    }

    fn query(&mut self, at: usize, after: usize) -> usize {
        let rest = self.text.piece(after..);
        let open = after + (rest.len() - rest.trim_start_matches([' ', '\t']).len());
        if !self.text.piece(open..).starts_with('{') {
            return after;
        }
        let Some(end) = group_end(self.text, open) else {
            self.problems.push(
                Diagnostic::error(Code::UnclosedQuery, r"\polarform{ is never closed")
                    .at(Span::new(at, open + 1))
                    .reason("a query begins here")
                    .hint("write } after the query"),
            );
            return open + 1;
        };
        let inner = self.text.piece(open + 1..end - 1);
        if !inner.contains('#') {
            self.layout.push(PartKind::Query, Span::new(at, end), &without_comments(inner), open + 1);
        }
        end
    }

    fn begin(&mut self, at: usize, after: usize) -> usize {
        let Some((name, end)) = braced_name(self.text, after) else { return after };
        let closing = format!(r"\end{{{name}}}");
        if name == NAME {
            let (info, from) = self.brackets(end);
            let found = self.find(from, &closing);
            // Code begins on the line of \begin, or on the next one if nothing else stands there.
            let rest = self.text.piece(from..).trim_start_matches([' ', '\t', '\r']);
            let body = if rest.starts_with('\n') { self.text.len() - rest.len() + 1 } else { from };
            let to = found.unwrap_or(body).max(body);
            let kind = PartKind::Code { info, closed: found.is_some() };
            let code = self.text.piece(body..to);
            self.layout.parts.push(Part {
                kind,
                span: Span::new(at, found.map_or(from, |found| found + closing.len()).max(from)),
                text: code.to_owned(),
                places: Places::plain(body),
                margin: String::new(),
            });
            return found.map_or(from, |found| found + closing.len());
        }
        if VERBATIM.contains(&name.trim_end_matches('*')) && name != "algorithmic" && name != "algpseudocode"
        {
            return self.find(end, &closing).map_or(end, |found| found + closing.len());
        }
        end
    }

    /// The next place of the sign.
    fn find(&mut self, from: usize, sign: &str) -> Option<usize> {
        if self.missing.iter().any(|missing| missing == sign) {
            return None;
        }
        let found = self.text.piece(from..).find(sign).map(|found| from + found);
        if found.is_none() {
            self.missing.push(sign.to_owned());
        }
        found
    }

    fn verbatim(&self, after: usize) -> usize {
        let line = nearby(self.text.piece(after..));
        let starred = line.strip_prefix('*').unwrap_or(line);
        let from = after + (line.len() - starred.len());
        let Some(sign) = starred.chars().next().filter(|c| !c.is_whitespace()) else { return after };
        let closing = if sign == '{' { '}' } else { sign };
        let len = sign.len_utf8();
        starred.piece(len..).find(closing).map_or(after, |found| from + len + found + closing.len_utf8())
    }

    /// What stands in brackets at `at`, and the byte after them.
    fn brackets(&self, at: usize) -> (Span, usize) {
        let rest = nearby(self.text.piece(at..));
        match rest.find(']').filter(|_| rest.starts_with('[')) {
            Some(close) => (Span::new(at + 1, at + close), at + close + 1),
            None => (Span::new(at, at), at),
        }
    }

    /// A part for each of the names in braces.
    fn named(&mut self, kind: PartKind, at: usize, after: usize) -> usize {
        let rest = nearby(self.text.piece(after..));
        let Some(inner) = rest.strip_prefix('{').and_then(|rest| rest.split('}').next()) else {
            return after;
        };
        let end = after + inner.len() + 2;
        if end > after + rest.len() || inner.contains(['#', '\\', '{']) {
            return after;
        }
        let mut from = at;
        for name in inner.split(',') {
            // Parts do not overlap: the first one takes the command.
            let to = (after + 1 + (name.as_ptr() as usize - inner.as_ptr() as usize) + name.len()).min(end);
            self.layout.push(kind.clone(), Span::new(from, to), name.trim(), to - name.len());
            from = to;
        }
        end
    }
}

/// The byte after the group in braces at `open`.
fn group_end(text: &str, open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    let mut comment = false;
    let mut escaped = false;
    for (i, byte) in text.as_bytes()[open..].iter().enumerate().take(MAX_QUERY) {
        match byte {
            b'\n' => comment = false,
            _ if comment => {}
            _ if escaped => escaped = false,
            // Queries do not nest; this also keeps repeated searches linear.
            b'\\' if text.piece(open + i + 1..).starts_with(NAME) => return None,
            b'\\' => escaped = true,
            b'%' => comment = true,
            b'{' => depth += 1,
            b'}' => {
                depth -= 1;
                if depth == 0 {
                    return Some(open + i + 1);
                }
            }
            _ => {}
        }
    }
    None
}

/// The text in one line, its comments blanked; every byte stays where it is.
fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut escaped = false;
    let mut comment = false;
    for c in text.chars() {
        comment = (comment || (c == '%' && !escaped)) && c != '\n';
        escaped = c == '\\' && !escaped;
        if comment || matches!(c, '\n' | '\r') {
            out.extend(std::iter::repeat_n(' ', c.len_utf8()));
        } else {
            out.push(c);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<(String, String)> {
        let (parts, _) = scan(text);
        parts.into_iter().map(|part| (text[part.span.range()].to_owned(), part.text)).collect()
    }

    #[test]
    fn queries() {
        let text =
            "a \\polarform{f(0, \\frac{1}{2})} % \\polarform{x}\n\\verb|\\polarform{y}| \\polarform {g\n(1)}";
        let parts = shown(text);
        assert_eq!(parts.len(), 2, "{parts:?}");
        assert_eq!(parts[0].1, "f(0, \\frac{1}{2})");
        assert_eq!(parts[1].1, "g (1)");
        let text = "\\begin{polarform}[steps=true]\nf := 1\n\\end{polarform}\\begin{verbatim}\\polarform{x}";
        let (parts, _) = scan(text);
        assert_eq!(parts.len(), 2);
        let PartKind::Code { info, closed: true } = parts[0].kind else { panic!("{parts:?}") };
        assert_eq!((&text[info.range()], parts[0].text.as_str()), ("steps=true", "f := 1\n"));
        assert_eq!(shown("\\newcommand{\\q}[1]{\\polarform{f(#1)}}"), []);
        assert_eq!(shown("\\polarform{a %}\n}")[0].1, "a    ");
    }

    #[test]
    fn files_packages_and_problems() {
        let parts = shown("\\usepackage[a]{amsmath, polarform}\\input{one}\\include{two}");
        let names: Vec<&str> = parts.iter().map(|part| part.1.as_str()).collect();
        assert_eq!(names, ["amsmath", "polarform", "one", "two"]);
        let (_, problems) = scan("\\polarform{f(0");
        assert_eq!(problems[0].code, Code::UnclosedQuery);
        let (parts, _) = scan("\\begin{polarform}\nf");
        assert!(matches!(parts[0].kind, PartKind::Code { closed: false, .. }));
    }
}
