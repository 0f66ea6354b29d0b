//! Where the queries of a Markdown text stand, and where their results.
//!
//! **Definition.** A *site* is a place of the text that depends on queries: a query among words, a
//! formula with queries in it, a block. It is *open* as it is typed, and *settled* once results stand in
//! the text:
//!
//! | open | settled |
//! | --- | --- |
//! | `{{ q }}` | `$r$<!-- {{ q }} -->` |
//! | `$… {{ q }} …$` | `$… r …$<!-- $… {{ q }} …$ -->` |
//! | a fenced block | the block, `<!-- woven -->`, results, `<!-- /woven -->` |
//! | a block that is hidden | the same, the block within a comment |
//!
//! The comment stands after the formula, not before it, because a line of Markdown that begins with a
//! comment is no paragraph, and its formulas are not set.

use std::ops::Range;

use super::options::BlockOptions;
use super::stamp::Digest;
use crate::document::Places;
use crate::document::options_in;
use crate::document::{Opening, Part, PartKind, markdown_parts, query_at};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

const BEGIN: &str = "woven";
const END: &str = "/woven";

/// A place of the text that depends on queries.
pub(super) struct Site {
    pub(super) kind: SiteKind,
    /// What a further line begins with here.
    pub(super) margin: String,
}

pub(super) enum SiteKind {
    /// A query, or a formula with queries.
    Template(Template),
    /// Statements on lines of their own.
    Block(Block),
}

pub(super) struct Template {
    /// The query or the formula as it was typed.
    pub(super) text: String,
    /// From bytes of that to bytes of the file.
    pub(super) places: Places,
    /// Where queries stand in it: with the braces.
    pub(super) holes: Vec<Range<usize>>,
    /// Whether it is a formula.
    pub(super) formula: bool,
    /// All that belongs to it.
    pub(super) span: Span,
    /// The part of it that is the result; `None` while it is open.
    pub(super) result: Option<Span>,
}

pub(super) struct Block {
    pub(super) code: String,
    pub(super) places: Places,
    pub(super) options: BlockOptions,
    /// The words after the opening fence.
    pub(super) info: Span,
    /// The fenced block, or the comment around it.
    pub(super) span: Span,
    pub(super) in_comment: bool,
    /// The result with the comments around it.
    pub(super) region: Option<Span>,
}

/// What stands in a text.
pub(super) struct Plan {
    pub(super) sites: Vec<Site>,
    pub(super) problems: Vec<Diagnostic>,
}

/// Finds all sites. Linear in the length of the text.
pub(super) fn plan(text: &str, defaults: &BlockOptions) -> Plan {
    let (parts, problems) = markdown_parts(text);
    let mut planner = Planner { text, parts: &parts, defaults, plan: Plan { sites: Vec::new(), problems } };
    let mut next = 0;
    while next < parts.len() {
        next = planner.part(next);
    }
    planner.plan
}

impl Plan {
    /// The files of the pictures in the results of blocks.
    pub(super) fn pictures(&self, text: &str) -> Vec<String> {
        let results = self.sites.iter().filter_map(|site| match &site.kind {
            SiteKind::Block(block) => block.region.map(|span| text.piece(span.range())),
            SiteKind::Template(_) => None,
        });
        let link = |line: &str| {
            let (_, file) = line.trim_start_matches(['>', ' ']).strip_prefix("![")?.rsplit_once("](")?;
            file.trim_end().strip_suffix(')').map(str::to_owned)
        };
        results.flat_map(str::lines).filter_map(link).collect()
    }
}

impl Plan {
    /// What the results depend on, and the results that stand in the text.
    pub(super) fn digest(&self, text: &str, options: &str) -> String {
        let mut digest = Digest::new(options);
        for site in &self.sites {
            match &site.kind {
                SiteKind::Template(template) => {
                    digest.add(&template.text);
                    digest.add(template.result.map_or("", |span| text.piece(span.range())));
                }
                SiteKind::Block(block) => {
                    digest.add(&block.code);
                    digest.add(text.piece(block.info.range()));
                    digest.add(if block.in_comment { "hidden" } else { "" });
                    digest.add(block.region.map_or("", |span| text.piece(span.range())));
                }
            }
        }
        digest.text()
    }
}

impl Plan {
    /// The number of the first site that another plan, of the text after weaving, does not have in its
    /// place with a result; `settled` tells for which sites there must be one.
    pub(super) fn first_difference(
        &self,
        text: &str,
        after: &Plan,
        text_after: &str,
        settled: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        let same = |(number, (one, two)): (usize, (&Site, &Site))| match (&one.kind, &two.kind) {
            (SiteKind::Template(one), SiteKind::Template(two)) => {
                let has_result = |template: &Template| template.result.is_some_and(|span| !span.is_empty());
                let wanted = settled(number) || has_result(one);
                plain(&one.text) == plain(&two.text) && (has_result(two) || !wanted)
            }
            (SiteKind::Block(one), SiteKind::Block(two)) => {
                one.code == two.code
                    && text.piece(one.info.range()) == text_after.piece(two.info.range())
                    && (two.region.is_some() || !settled(number))
            }
            _ => false,
        };
        let (here, there) = (self.sites.len(), after.sites.len());
        let first = self.sites.iter().zip(&after.sites).enumerate().map(same).position(|same| !same);
        first.or((here != there).then(|| here.min(there)))
    }
}

/// A template as it stands in a comment.
fn plain(template: &str) -> String {
    template.lines().map(str::trim).collect::<Vec<_>>().join("\n").replace("--", "- -")
}

struct Planner<'a> {
    text: &'a str,
    parts: &'a [Part],
    defaults: &'a BlockOptions,
    plan: Plan,
}

impl Planner<'_> {
    /// Takes one part and what belongs to it; the number of the next one.
    fn part(&mut self, at: usize) -> usize {
        let part = &self.parts[at];
        match &part.kind {
            PartKind::Query => {
                let text = format!("{{{{{}}}}}", part.text);
                let template = Template {
                    holes: std::iter::once(0..text.len()).collect(),
                    text,
                    places: Places::plain(part.span.start),
                    formula: false,
                    span: part.span,
                    result: None,
                };
                self.site(SiteKind::Template(template), part);
                at + 1
            }
            PartKind::Formula { inner, .. } => {
                let holes = holes(&part.text, inner.clone());
                if holes.is_empty() {
                    return at + 1;
                }
                let (text, places, moved) = without_margin(part);
                let holes = holes.iter().map(|hole| moved(hole.start)..moved(hole.end)).collect();
                let template = Template { text, places, holes, formula: true, span: part.span, result: None };
                self.site(SiteKind::Template(template), part);
                at + 1
            }
            PartKind::Comment => self.comment(at),
            PartKind::Code { info, closed } => {
                let words = self.text.piece(info.range());
                let Some(range) = options_in(words) else { return at + 1 };
                if !closed {
                    self.plan.problems.push(
                        Diagnostic::error(Code::UnclosedQuery, "this block is never closed")
                            .at(*info)
                            .reason("it begins here")
                            .hint("close it with a line of as many backquotes as it begins with"),
                    );
                    return at + 1;
                }
                let options = self.defaults.with(words.piece(range.clone()), info.start + range.start);
                self.block(at, options, part.text.clone(), part.places.clone(), *info, false)
            }
            PartKind::Include | PartKind::Package => at + 1,
        }
    }

    fn site(&mut self, kind: SiteKind, part: &Part) {
        self.plan.sites.push(Site { kind, margin: part.margin.clone() });
    }

    /// A comment: one that holds a template or a block belongs to the text, others do not.
    fn comment(&mut self, at: usize) -> usize {
        let part = &self.parts[at];
        let content = part.text.trim();
        if content == BEGIN {
            // The result of a block that is gone stays as it is.
            return self.region_end(at).map_or(at + 1, |end| end + 1);
        }
        if !content.contains("{{") && !content.contains("polarform") {
            return at + 1;
        }
        let (inner, places, _) = without_margin(part);
        let (parts, _) = markdown_parts(&inner);
        let [only] = parts.as_slice() else { return at + 1 };
        if inner.piece(..only.span.start).trim() != "" || inner.piece(only.span.end..).trim() != "" {
            return at + 1;
        }
        let whole = inner.piece(only.span.range());
        let in_file = |span: Span| Span::new(places.byte(span.start), places.byte(span.end));
        match &only.kind {
            PartKind::Query | PartKind::Formula { .. } => {
                let formula = only.kind != PartKind::Query;
                let holes = match &only.kind {
                    PartKind::Formula { inner, .. } => holes(whole, inner.clone()),
                    _ => std::iter::once(0..whole.len()).collect(),
                };
                if holes.is_empty() {
                    return at + 1;
                }
                let first_line = |text: &str| text.split('\n').next().map(|line| line.trim_end().to_owned());
                let old = at.checked_sub(1).map(|before| &self.parts[before]).filter(|before| {
                    let gap = self.text.piece(before.span.end..part.span.start);
                    // Only a display of several lines has its comment on the next line.
                    let display = formula
                        && whole.contains('\n')
                        && first_line(whole) == first_line(&before.text)
                        && gap.matches('\n').count() == 1
                        && gap.chars().all(|c| c.is_whitespace() || c == '>');
                    matches!(before.kind, PartKind::Formula { .. }) && (gap.is_empty() || display)
                });
                // A formula that is open itself is not the result of another.
                let old = old.filter(|before| match &before.kind {
                    PartKind::Formula { inner, .. } => self::holes(&before.text, inner.clone()).is_empty(),
                    _ => false,
                });
                let result = old.map_or(Span::new(part.span.start, part.span.start), |old| old.span);
                let mut moved = Places::default();
                let lines = whole.split_inclusive('\n').scan(only.span.start, |from, line| {
                    let start = *from;
                    *from += line.len();
                    Some(start)
                });
                for start in lines {
                    moved.push(start - only.span.start, places.byte(start), true);
                }
                let template = Template {
                    text: whole.to_owned(),
                    places: moved,
                    holes,
                    formula,
                    span: result.to(part.span),
                    result: Some(result),
                };
                self.site(SiteKind::Template(template), part);
                at + 1
            }
            PartKind::Code { info, closed: true } => {
                let words = inner.piece(info.range());
                let Some(range) = options_in(words) else { return at + 1 };
                let info = in_file(*info);
                let options = self.defaults.with(words.piece(range.clone()), info.start + range.start);
                let mut code_places = Places::default();
                let mut from = 0;
                for line in only.text.split_inclusive('\n') {
                    code_places.push(from, places.byte(only.places.byte(from)), true);
                    from += line.len();
                }
                self.block(at, options, only.text.clone(), code_places, info, true)
            }
            _ => at + 1,
        }
    }

    fn block(
        &mut self,
        at: usize,
        options: Result<BlockOptions, Vec<Diagnostic>>,
        code: String,
        places: Places,
        info: Span,
        in_comment: bool,
    ) -> usize {
        let part = &self.parts[at];
        let mut next = at + 1;
        let mut region = None;
        if let Some(begin) = self.parts.get(next).filter(|begin| self.begins_region(part, begin)) {
            match self.region_end(next) {
                Some(end) => {
                    region = Some(begin.span.to(self.parts[end].span));
                    next = end + 1;
                }
                None => {
                    self.plan.problems.push(
                        Diagnostic::error(Code::UnclosedQuery, "the woven result is never closed")
                            .at(begin.span)
                            .reason("it begins here")
                            .hint("write <!-- /woven --> after it, or remove this comment"),
                    );
                    return next + 1;
                }
            }
        }
        match options {
            Ok(options) => {
                let block = Block { code, places, options, info, span: part.span, in_comment, region };
                self.site(SiteKind::Block(block), part);
            }
            Err(problems) => self.plan.problems.extend(problems),
        }
        next
    }

    fn begins_region(&self, block: &Part, begin: &Part) -> bool {
        let gap = self.text.piece(block.span.end..begin.span.start);
        begin.kind == PartKind::Comment
            && begin.text.trim() == BEGIN
            && gap.chars().all(|c| c.is_whitespace() || c == '>')
    }

    /// The comment that ends the region which begins at `at`.
    fn region_end(&self, at: usize) -> Option<usize> {
        let after = self.parts.iter().enumerate().skip(at + 1);
        for (i, part) in after {
            let content = part.text.trim();
            match &part.kind {
                PartKind::Comment if content == END => return Some(i),
                PartKind::Comment if content == BEGIN => return None,
                PartKind::Code { info, .. } if options_in(self.text.piece(info.range())).is_some() => {
                    return None;
                }
                _ => {}
            }
        }
        None
    }
}

/// The queries in a formula whose signs enclose the bytes `inner`.
fn holes(text: &str, inner: Range<usize>) -> Vec<Range<usize>> {
    let text = text.piece(..inner.end);
    let bytes = text.as_bytes();
    let mut holes = Vec::new();
    let mut at = inner.start;
    while at + 1 < text.len() {
        match (bytes[at], bytes[at + 1]) {
            (b'\\', _) => at += 2,
            (b'{', b'{') => match query_at(text, at, true) {
                Opening::Query(range) => {
                    holes.push(at..range.end + 2);
                    at = range.end + 2;
                }
                Opening::Unclosed | Opening::Other => at += 1,
            },
            _ => at += 1,
        }
    }
    holes
}

/// The text of a part without the blanked margin of its further lines; the places of its bytes; and
/// where a byte goes.
fn without_margin(part: &Part) -> (String, Places, impl Fn(usize) -> usize) {
    let mut text = String::with_capacity(part.text.len());
    let mut places = Places::default();
    // For each line: its first byte before, after, and how much was taken away.
    let mut lines = Vec::new();
    let mut from = 0;
    for (i, line) in part.text.split_inclusive('\n').enumerate() {
        let blanks = line.bytes().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let cut = if i == 0 { 0 } else { blanks.min(part.margin.len()) };
        lines.push((from, text.len(), cut));
        places.push(text.len(), part.places.byte(from + cut), true);
        text.push_str(line.piece(cut..));
        from += line.len();
    }
    let moved = move |at: usize| {
        let line = lines.partition_point(|line| line.0 <= at).saturating_sub(1);
        lines.get(line).map_or(at, |&(before, after, cut)| after + (at - before).saturating_sub(cut))
    };
    (text, places, moved)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<String> {
        let plan = plan(text, &BlockOptions::default());
        let site = |site: &Site| match &site.kind {
            SiteKind::Template(template) => {
                let result = template.result.map(|span| &text[span.range()]);
                format!("{} {:?} {result:?}", template.text, template.holes)
            }
            SiteKind::Block(block) => {
                let region = block.region.map(|span| &text[span.range()]);
                format!("{:?} {} {region:?}", block.code, block.in_comment)
            }
        };
        plan.sites.iter().map(site).collect()
    }

    #[test]
    fn open_and_settled() {
        assert_eq!(shown("a {{ b }}"), ["{{ b }} [0..7] None"]);
        assert_eq!(shown("a $x$<!-- {{ b }} -->"), ["{{ b }} [0..7] Some(\"$x$\")"]);
        assert_eq!(shown("a $x$ <!-- {{ b }} -->"), ["{{ b }} [0..7] Some(\"\")"]);
        assert_eq!(shown("$a = {{ b }}$"), ["$a = {{ b }}$ [5..12] None"]);
        assert_eq!(shown("$a = x$<!-- $a = {{ b }}$ -->"), ["$a = {{ b }}$ [5..12] Some(\"$a = x$\")"]);
        assert_eq!(
            shown("<!-- {{ b -->, <!-- $a$ -->, <!-- a {{ b }} -->, $\\{{ b }}$"),
            Vec::<String>::new()
        );
        let display = "> $$\n> x\n> $$\n> <!--\n> $$\n> {{ b }}\n> $$\n> -->\n";
        assert_eq!(shown(display), ["$$\n{{ b }}\n$$ [3..10] Some(\"$$\\n> x\\n> $$\")"]);
    }

    #[test]
    fn blocks_and_regions() {
        let block = "```polarform\na\n```\n";
        assert_eq!(shown(block), ["\"a\\n\" false None"]);
        let settled = format!("{block}\n<!-- woven -->\nx\n<!-- /woven -->\n{{{{ b }}}}");
        assert_eq!(shown(&settled)[0], "\"a\\n\" false Some(\"<!-- woven -->\\nx\\n<!-- /woven -->\")");
        assert_eq!(shown(&settled).len(), 2);
        assert_eq!(shown("- <!--\n  ```polarform\n  a\n  ```\n  -->\n"), ["\"a\\n\" true None"]);
        assert_eq!(shown("<!-- woven -->\n{{ a }}\n<!-- /woven -->"), Vec::<String>::new());
        assert_eq!(shown("```text\n{{ a }}\n```\n"), Vec::<String>::new());
    }

    #[test]
    fn what_has_no_end() {
        let problems = |text| plan(text, &BlockOptions::default()).problems;
        assert_eq!(problems("```polarform\na\n")[0].code, Code::UnclosedQuery);
        let half = "```polarform\na\n```\n<!-- woven -->\nx\n\n```polarform\nb\n```\n";
        let found = problems(half);
        assert_eq!(found[0].span, Some(Span::new(19, 33)));
        assert_eq!(shown(half), ["\"b\\n\" false None"]);
        assert_eq!(problems("a {{ b").len(), 1);
        assert_eq!(problems("```polarform x=1\n```\n")[0].code, Code::BlockOption);
    }
}
