//! Formulas as MathML, for browsers.
//!
//! pulldown-latex does the work. Before it come the few things that authors write and it does not
//! know: old names of commands, `\sum_\limits`, spaces in the columns of an array, rows outside
//! of an environment.

use std::convert::Infallible;

use crate::formula::source::Pieces;
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::event::{Content, Event};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Formulas with more commands and braces than this stay as source: each may be a level of
/// recursion.
const LEVELS: usize = 1000;

/// More than a level of recursion takes, also in a build without optimisation.
const STACK_PER_LEVEL: usize = 48 << 10;

/// Names that pulldown-latex does not know, and what says the same.
const RENAMED: [(&str, &str); 10] = [
    ("pmb", "\\boldsymbol"),
    ("bm", "\\boldsymbol"),
    ("part", "\\partial"),
    ("mathbbm", "\\mathbb"),
    ("mathscr", "\\mathcal"),
    ("mbox", "\\text"),
    ("hbox", "\\text"),
    ("nonumber", ""),
    ("notag", ""),
    ("qedhere", ""),
];

/// Commands that name or number an equation; they are left out with their argument.
const NUMBERING: [&str; 2] = ["label", "tag"];

/// The formula as a `<math>` element, all text in it escaped; `None` if it cannot be rendered.
pub(super) fn mathml(latex: &str) -> Option<String> {
    mathml_within(latex, true)
}

/// The formula as a `<math>` element for a page of HTML, in a line or on one of its own; `None` if it cannot be rendered.
///
/// Cost: linear in its length.
///
/// ```
/// use polarform::notes::report::mathml_within;
/// let math = mathml_within("t_1^2", false).unwrap();
/// assert!(math.starts_with("<math") && math.contains("<msubsup>"));
/// assert_eq!(mathml_within(r"\nonsense{", true), None);
/// ```
pub fn mathml_within(latex: &str, display: bool) -> Option<String> {
    let levels = latex.bytes().filter(|b| matches!(b, b'\\' | b'{' | b'^' | b'_')).count();
    if levels > LEVELS {
        return None;
    }
    let stack = (levels + 16) * STACK_PER_LEVEL;
    stacker::maybe_grow(stack, stack, || {
        let latex = without_infixes(&prepared(latex));
        let rendered = |latex: &str| rendered(latex, display);
        rendered(&latex).or_else(|| {
            let rows = latex.trim_end().trim_end_matches("\\\\");
            rendered(rows).or_else(|| rendered(&format!("\\begin{{aligned}}{rows}\\end{{aligned}}")))
        })
    })
}

fn rendered(latex: &str, display: bool) -> Option<String> {
    let storage = Storage::new();
    // An error is rendered as a message within the formula; here it ends the attempt instead.
    let events: Vec<_> = Parser::new(latex, &storage).collect::<Result<_, _>>().ok()?;
    if events.iter().any(is_markup) {
        return None;
    }
    let mut out = String::new();
    let display_mode = if display { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    push_mathml(&mut out, events.into_iter().map(Ok::<_, Infallible>), config).ok()?;
    // The one is no entity of XML, the other no blank before the next attribute.
    let math = escaped(&out.replace("&nbsp;", "\u{a0}").replace("\"minsize=", "\" minsize="));
    is_well_formed(&math).then_some(math)
}

/// pulldown-latex escapes text, but not the names of functions.
fn is_markup(event: &Event) -> bool {
    matches!(event, Event::Content(Content::Function(name)) if name.contains(['<', '>', '&']))
}

/// It does not escape operators either, which are single characters: what opens no tag is text,
/// and so is what closes none.
fn escaped(math: &str) -> String {
    let mut out = String::with_capacity(math.len());
    let mut before = ' ';
    for (at, character) in math.char_indices() {
        let after = math.piece(at + character.len_utf8()..);
        match character {
            '<' if !after.starts_with(|c: char| c == '/' || c.is_ascii_alphabetic()) => out.push_str("&lt;"),
            '>' if before == '>' => out.push_str("&gt;"),
            '&' if !ENTITIES.iter().any(|entity| after.starts_with(entity)) => out.push_str("&amp;"),
            _ => out.push(character),
        }
        before = character;
    }
    out
}

/// Whether all tags are closed in order: a few strange formulas, such as `\\^x`, come out broken.
fn is_well_formed(math: &str) -> bool {
    let mut open = Vec::new();
    for piece in math.split('<').skip(1) {
        let Some((tag, text)) = piece.split_once('>') else { return false };
        match tag.strip_prefix('/') {
            Some(name) if open.pop() == Some(name) => {}
            Some(_) => return false,
            None if tag.ends_with('/') => {}
            None => open.push(tag.split(' ').next().unwrap_or(tag)),
        }
        if text.contains('>') {
            return false;
        }
    }
    open.is_empty()
}

/// What follows `&` where it is not text.
const ENTITIES: [&str; 5] = ["lt;", "gt;", "amp;", "quot;", "#"];

/// The formula in the words of pulldown-latex.
fn prepared(latex: &str) -> String {
    let mut out = String::with_capacity(latex.len());
    let mut rest = latex;
    while let Some(at) = rest.find('\\') {
        out.push_str(rest.piece(..at));
        rest = rest.piece(at + 1..);
        let length = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let (name, after) = rest.split_at(length);
        rest = after;
        match name {
            // A single character; it must not start a command of its own.
            "" => {
                out.push('\\');
                if let Some(character) = rest.chars().next() {
                    out.push(character);
                    rest = rest.piece(character.len_utf8()..);
                }
            }
            "limits" | "nolimits" if out.trim_end().ends_with(['_', '^']) => {
                let kept = out.trim_end().len() - 1;
                let script = out.split_off(kept);
                out.push_str(&format!("\\{name}{script}"));
            }
            _ if NUMBERING.contains(&name) => {
                if let Some((_, after)) = braced(rest) {
                    rest = after;
                }
            }
            "begin" => {
                out.push_str("\\begin");
                rest = array(rest, &mut out);
            }
            _ => match RENAMED.iter().find(|(old, _)| *old == name) {
                Some((_, new)) => out.push_str(new),
                None => {
                    out.push('\\');
                    out.push_str(name);
                }
            },
        }
    }
    out.push_str(rest);
    out
}

/// Commands of TeX between the two parts of a group, and what stands before, between and after the parts elsewhere.
const INFIXES: [(&str, [&str; 3]); 3] = [
    ("choose", ["\\binom{", "}{", "}"]),
    ("over", ["\\frac{", "}{", "}"]),
    ("atop", ["\\begin{matrix}", "\\\\", "\\end{matrix}"]),
];

/// Where an open group begins, and where its second part does, with what is set around the parts.
type Group = (usize, Option<(usize, [&'static str; 3])>);

/// `{n \choose k}` as `{\binom{n}{k}}`.
fn without_infixes(latex: &str) -> String {
    // Where the open groups begin in `out`, and where the second part of each does.
    let mut groups: Vec<Group> = vec![(0, None)];
    let mut out = String::with_capacity(latex.len());
    let close = |out: &mut String, (start, infix): Group| {
        let Some((at, [before, between, after])) = infix else { return };
        let second = out.split_off(at);
        let first = out.split_off(start);
        *out += &[before, first.trim(), between, second.trim(), after].concat();
    };
    let mut rest = latex;
    while let Some(at) = rest.find(['\\', '{', '}']) {
        out.push_str(rest.piece(..at));
        rest = rest.piece(at..);
        let letters = rest.bytes().skip(1).take_while(u8::is_ascii_alphabetic).count();
        let length = match rest.starts_with('\\') {
            true if letters > 0 => 1 + letters,
            true => rest.chars().take(2).map(char::len_utf8).sum(),
            false => 1,
        };
        let (token, after) = rest.split_at(length);
        rest = after;
        let infix = INFIXES.iter().find(|(name, _)| token.strip_prefix('\\') == Some(*name));
        match (infix, groups.last_mut()) {
            (Some((_, parts)), Some(group)) if group.1.is_none() => {
                group.1 = Some((out.len(), *parts));
                continue;
            }
            _ => {}
        }
        if token == "}"
            && groups.len() > 1
            && let Some(group) = groups.pop()
        {
            close(&mut out, group);
        }
        out.push_str(token);
        if token == "{" {
            groups.push((out.len(), None));
        }
    }
    out.push_str(rest);
    match groups.as_slice() {
        [group] => close(&mut out, *group),
        _ => return latex.to_owned(),
    }
    out
}

/// What stands between the braces that come next, and what follows them.
fn braced(text: &str) -> Option<(&str, &str)> {
    text.trim_start().strip_prefix('{')?.split_once('}')
}

/// Copies `{array} { l }` without its spaces, and returns what follows.
fn array<'a>(rest: &'a str, out: &mut String) -> &'a str {
    let Some((name, after)) = braced(rest) else { return rest };
    out.push_str(&format!("{{{}}}", name.trim()));
    match braced(after) {
        Some((columns, after)) if name.trim() == "array" => {
            out.push_str(&format!("{{{}}}", columns.split_whitespace().collect::<String>()));
            after
        }
        _ => after,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn formulas_of_real_notes_are_rendered() {
        for latex in [
            r"f(t_1, t_2) = \frac{5}{3} (t_1 + t_2) + 1",
            r"\pmb{b}_0 \bm x \hat{1} \widehat{1} \overrightarrow{AB} \dot P",
            r"f(\underbrace{t,\ldots,t}_{n-k},\underbrace{\hat 1,\ldots,\hat 1}_k)",
            r"\sum_\limits{i=0}^n \binom{n}{i} t^i",
            r"\begin{array} { l } { x _ { u } } \\ { y } \end{array}",
            r"A_2 \triangleq \left(\begin{matrix} 1 & 0 \\ -2 & 2 \end{matrix}\right)\\",
            r"a &= b \\ &= c",
            r"{n \choose k} t^k = {n\choose {n-k}} {a + b \over 2} {i \atop j}",
            r"\left. \frac{\part F}{\part u} \right|_{u=0}",
            r"a &= b \label{first} \nonumber \\ &= c \tag{2}",
            r"\begin{cases} \displaystyle 1 & t \ge 0 \\ 0 & \text{否则} \end{cases}",
            "F(u) = f(u, u), t³, u₁, ∑_j a_j u_j",
        ] {
            assert!(mathml(latex).is_some(), "{latex}");
        }
    }

    #[test]
    fn infixes_become_commands() {
        assert_eq!(without_infixes(r"2{n\choose {k \over 2}}"), r"2{\binom{n}{{\frac{k}{2}}}}");
        assert_eq!(without_infixes(r"a \over b"), r"\frac{a}{b}");
        assert_eq!(without_infixes(r"\{a\} \overline{b} {c\over"), r"\{a\} \overline{b} {c\over");
    }

    #[test]
    fn blanks_and_large_brackets_are_well_formed() {
        let math = mathml(r"2 F\Bigl(\frac{1}{2}\Bigr)~\text{for } n").expect("it can be rendered");
        let parsed = roxmltree::Document::parse(&math).unwrap_or_else(|error| panic!("{error}: {math}"));
        let sizes = parsed.descendants().filter(|node| node.has_attribute("minsize")).count();
        assert_eq!(sizes, 2, "{math}");
        assert!(
            parsed.descendants().filter_map(|node| node.text()).any(|text| text == "for\u{a0}"),
            "{math}"
        );
    }

    #[test]
    fn text_is_escaped() {
        assert_eq!(mathml(r"\operatorname{<img src=x>}"), None);
        let math = mathml(r"\text{<script>alert('&')</script>} < 1").expect("it can be rendered");
        assert!(!math.contains("<script"), "{math}");
        for latex in [r#"\color{red" onclick="x}a"#, r"\href{javascript:alert(1)}{x}"] {
            let math = mathml(latex).unwrap_or_default();
            assert!(!math.contains("onclick=\"x") && !math.contains("javascript:"), "{math}");
        }
    }

    #[test]
    fn deep_nesting_is_left_alone() {
        for (open, close) in [("{", "}"), ("\\sqrt ", ""), ("\\frac{", "}{1}"), ("\\left(", "\\right)")] {
            for depth in [100, 450, 2000, 100_000] {
                let latex = format!("{}x{}", open.repeat(depth), close.repeat(depth));
                let _ = mathml(&latex);
            }
        }
    }

    #[test]
    fn only_whole_names_are_replaced() {
        assert_eq!(
            prepared(r"\pmb b \pmbx \\pmb \partial \part"),
            r"\boldsymbol b \pmbx \\pmb \partial \partial"
        );
        assert_eq!(prepared(r"\sum _ \limits{i} \"), r"\sum \limits_ {i} \");
        assert_eq!(prepared(r"\begin { array } { l | c }"), r"\begin{array}{l|c}");
        assert_eq!(prepared(r"\begin{matrix} {a} & b"), r"\begin{matrix} {a} & b");
    }

    proptest! {
        #[test]
        fn any_text_is_rendered_or_not(
            parts in prop::collection::vec(prop::sample::select(vec![
                "\\frac", "{", "}", "^", "_", "\\left(", "\\right)", "&", "\\\\", "\\begin{matrix}",
                "\\end{matrix}", "\\begin", "\\end", "x", "'", "\\hat", "\\text{<b>}", "\\", "中", "[",
                "]", "\\sqrt", "\\limits", "\\sum", "\\displaystyle", "\\pmb", " ", "%", "<", ">", "\\&", "\\mathrm{<a>}", "\\operatorname{<c>}", "\\not<", "\\left<", "#1", "\u{0}",
            ]), 0..16)
        ) {
            if let Some(math) = mathml(&parts.concat()) {
                prop_assert!(math.starts_with("<math") && math.ends_with("</math>"));
                prop_assert!(!["<a", "<b", "<c"].iter().any(|tag| math.contains(tag)), "{}", math);
            }
        }
    }
}
