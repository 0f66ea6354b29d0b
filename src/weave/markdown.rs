//! Weaving Markdown: from the sites of a text to the bytes that change.

use std::borrow::Cow;

use super::markup::{Markup, within_cell};
use super::options::BlockOptions;
use super::plan::{Block, Plan, Site, SiteKind, Template};
use super::runner::Runner;
use super::{Mode, Options};
use crate::formula::source::{Pieces, SourceFile, Span, replaced};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::functions::Arrangement;
use crate::language::write::Breaks;

/// A change of a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edit {
    /// The bytes that go.
    pub(super) span: Span,
    /// What comes in their place.
    pub(super) new: String,
    /// The query that this is the result of.
    pub(super) query: Span,
    /// The number of its site.
    pub(super) site: usize,
    /// Whether a result stands there afterwards.
    pub(super) settles: bool,
}

/// Runs the queries of a text and says what changes in it. `place` leads from the text to the file.
pub(super) fn edits(
    text: &str,
    plan: &Plan,
    runner: &mut Runner,
    file: &SourceFile,
    place: &dyn Fn(Span) -> Span,
    options: &Options,
) -> Vec<Edit> {
    for problem in &plan.problems {
        let mut problem = problem.clone();
        problem.span = problem.span.map(place);
        runner.problem(problem, file);
    }
    let line_end = line_end(text);
    let mut weaver = Weaver { text, runner, file, place, options, line_end, site: 0, edits: Vec::new() };
    for (number, site) in plan.sites.iter().enumerate() {
        weaver.site = number;
        match &site.kind {
            SiteKind::Template(template) => weaver.template(site, template),
            SiteKind::Block(block) => weaver.block(site, block),
        }
    }
    let mut edits = weaver.edits;
    edits.retain(|edit| text.piece(edit.span.range()) != edit.new);
    if options.mode == Mode::InPlace {
        for query in keep_what_is_found_again(text, plan, &mut edits, options) {
            let problem = Diagnostic::error(Code::UnclosedFormula, "a result would not be found again here")
                .at(place(query))
                .reason("nothing was written")
                .hint(r"look for a lone $ near it; a currency is written \$")
                .hint("or weave into another file with -o");
            runner.problem(problem, file);
        }
    }
    edits
}

/// So many results that would not be found again are left out one by one.
const MOST_DOUBTS: usize = 20;

/// Leaves out results that the next run would not take for results: what is a formula depends on what
/// stands around it, where dollars are not balanced. Gives the queries of those left out.
fn keep_what_is_found_again(text: &str, plan: &Plan, edits: &mut Vec<Edit>, options: &Options) -> Vec<Span> {
    let mut doubtful = Vec::new();
    while !edits.is_empty() {
        let after = edited(text, edits);
        let again = super::plan::plan(&after, &options.blocks);
        let settled = |number: usize| {
            let at = edits.partition_point(|edit| edit.site < number);
            edits[at..].iter().take_while(|edit| edit.site == number).any(|edit| edit.settles)
        };
        let Some(first) = plan.first_difference(text, &again, &after, settled) else { break };
        let before = edits.iter().rev().map(|edit| edit.site).find(|site| *site <= first);
        let site = before.unwrap_or(edits[0].site);
        doubtful.extend(edits.iter().find(|edit| edit.site == site).map(|edit| edit.query));
        edits.retain(|edit| edit.site != site);
        if doubtful.len() >= MOST_DOUBTS {
            edits.clear();
        }
    }
    doubtful
}

/// How the lines of a text end.
pub(super) fn line_end(text: &str) -> &'static str {
    match text.find('\n') {
        Some(at) if text.piece(..at).ends_with('\r') => "\r\n",
        _ => "\n",
    }
}

/// The text with its changes; they are in its order.
pub(super) fn edited(text: &str, edits: &[Edit]) -> String {
    replaced(text, edits.iter().map(|edit| (edit.span, edit.new.as_str())))
}

struct Weaver<'a> {
    text: &'a str,
    runner: &'a mut Runner,
    file: &'a SourceFile,
    place: &'a dyn Fn(Span) -> Span,
    options: &'a Options,
    line_end: &'static str,
    /// The number of the site that is woven.
    site: usize,
    edits: Vec<Edit>,
}

impl Weaver<'_> {
    fn edit(&mut self, span: Span, new: String, query: Span) {
        self.edits.push(Edit { span, new, query, site: self.site, settles: false });
    }

    /// A change after which a result stands in the text.
    fn settle(&mut self, span: Span, new: String, query: Span) {
        self.edits.push(Edit { span, new, query, site: self.site, settles: true });
    }

    fn template(&mut self, site: &Site, template: &Template) {
        let mut result = String::new();
        let mut at = 0;
        let mut complete = true;
        let in_table = self.in_table(template.span);
        for hole in &template.holes {
            let code = template.text.piece(hole.start + 2..hole.end - 2).replace(['\n', '\r'], " ");
            let place = |span: Span| (self.place)(template.places.span(span.shifted(hole.start + 2)));
            match self.runner.query(&code, self.file, &place, &self.options.blocks) {
                Some(piece) => {
                    result.push_str(&self.typed(template.text.piece(at..hole.start)));
                    let bare = template.formula || self.options.mode == Mode::InPlace;
                    let shown = Markup::Markdown.inline(&piece, bare);
                    let shown = if in_table { within_cell(&shown) } else { shown };
                    if bare && !template.formula {
                        // In place even words are a formula, so that their end can be found again.
                        result.push_str(&format!("${shown}$"));
                    } else {
                        result.push_str(&shown);
                    }
                    at = hole.end;
                }
                None => complete = false,
            }
        }
        if !complete {
            return;
        }
        result.push_str(&self.typed(template.text.piece(at..)));
        // Two dollars side by side would be the sign of a display.
        let span = template.result.unwrap_or(template.span);
        let comes = !template.formula || template.result.is_some_and(Span::is_empty);
        if comes && result.starts_with('$') && self.text.piece(..span.start).ends_with('$') {
            result.insert(0, ' ');
        }
        if comes && result.ends_with('$') && self.text.piece(template.span.end..).starts_with('$') {
            result.push_str(if self.options.mode == Mode::Template { " " } else { "" });
        }
        let query = template.places.span(Span::new(template.holes[0].start, template.holes[0].end));
        let result = self.lines(result.split('\n').map(|line| line.trim_end_matches('\r')), &site.margin);
        match (self.options.mode, template.result) {
            (Mode::Template, _) => self.edit(template.span, result, query),
            (Mode::InPlace, Some(old)) => self.settle(old, result, query),
            (Mode::InPlace, None) => {
                let comment = self.comment(template, &site.margin);
                self.settle(template.span, result + &comment, query);
            }
        }
    }

    /// Whether a bar stands beside the span in its line: there, one in a result would end a cell.
    fn in_table(&self, span: Span) -> bool {
        let before = self.text.piece(..span.start).rsplit('\n').next();
        let after = self.text.piece(span.end..).split('\n').next();
        before.into_iter().chain(after).any(|side| side.contains('|'))
    }

    /// A part of a template as it can be kept in a comment. Two hyphens end one in some renderers; in a
    /// formula a blank between them changes nothing.
    fn typed<'t>(&self, text: &'t str) -> Cow<'t, str> {
        match self.options.mode {
            Mode::InPlace if text.contains("--") => text.replace("--", "- -").into(),
            _ => text.into(),
        }
    }

    /// The comment that keeps the template beside its result.
    fn comment(&self, template: &Template, margin: &str) -> String {
        let source = self.typed(&template.text);
        let alone =
            self.text.piece(template.span.end..).split('\n').next().is_none_or(|rest| rest.trim().is_empty());
        if source.contains('\n') && alone {
            let lines = source.split('\n').map(|line| line.trim_end_matches('\r'));
            let lines = ["", "<!--"].into_iter().chain(lines).chain(["-->"]);
            self.lines(lines, margin)
        } else {
            let source = self.lines(source.split('\n').map(|line| line.trim_end_matches('\r')), margin);
            format!("<!-- {source} -->")
        }
    }

    /// Lines, each but the first one after the margin.
    fn lines<'a>(&self, lines: impl Iterator<Item = &'a str>, margin: &str) -> String {
        let mut out = String::new();
        for (i, line) in lines.enumerate() {
            if i > 0 {
                out.push_str(self.line_end);
                out.push_str(if line.is_empty() { margin.trim_end() } else { margin });
            }
            out.push_str(line);
        }
        out
    }

    fn block(&mut self, site: &Site, block: &Block) {
        let place = |span: Span| (self.place)(block.places.span(span));
        let pieces = self.runner.block(&block.code, self.file, &place, &block.options);
        let Some(pieces) = pieces else { return };
        let lines = Markup::Markdown.block(&pieces, &block.options);
        let query = block.info;
        let margin = site.margin.as_str();
        let after = Span::new(block.span.end, block.region.map_or(block.span.end, |region| region.end));
        if self.options.mode == Mode::Template {
            self.template_block(block, &lines, margin, after);
            return;
        }
        let hides = block.options.hide && !block.in_comment;
        if hides && block.code.contains("-->") {
            let problem = Diagnostic::error(Code::BlockOption, "this block cannot be hidden in its place")
                .at((self.place)(block.info))
                .reason("its code holds -->, which would end the comment")
                .hint("write a blank into the arrow, or weave into another file with -o");
            self.runner.problem(problem, self.file);
        } else if hides {
            let fence = self.text.piece(block.span.range());
            let lines = ["<!--", fence, "-->"].into_iter();
            let hidden = self.lines(lines, margin);
            self.edit(block.span, hidden, query);
        }
        if lines.is_empty() {
            self.edit(after, String::new(), query);
            return;
        }
        let lines = lines.iter().map(String::as_str);
        let region = ["<!-- woven -->", ""].into_iter().chain(lines).chain(["", "<!-- /woven -->"]);
        match block.region {
            Some(old) => {
                let region = self.lines(region, margin);
                self.settle(old, region, query);
            }
            None => {
                let region = self.lines([""].into_iter().chain(region), margin);
                self.settle(after, region, query);
            }
        }
    }

    /// The span with the end of its line, and a blank line after it if there is one before it, too.
    fn whole_lines(&self, span: Span) -> Span {
        let blank = |line: &str| line.trim().is_empty() && line.ends_with('\n');
        let mut following = self.text.piece(span.end..).split_inclusive('\n');
        let mut end = span.end;
        let Some(rest) = following.next().filter(|rest| blank(rest)) else { return span };
        end += rest.len();
        let before = self.text.piece(..span.start);
        let first = before.is_empty() || before.ends_with("\n\n") || before.ends_with("\n\r\n");
        if let Some(line) = following.next().filter(|line| first && blank(line)) {
            end += line.len();
        }
        Span::new(span.start, end)
    }

    /// The block with its results, or these alone.
    fn template_block(&mut self, block: &Block, lines: &[String], margin: &str, after: Span) {
        let lines = lines.iter().map(String::as_str);
        if block.options.hide || block.in_comment {
            let shown = self.lines(lines, margin);
            let all = block.span.to(after);
            let all = if shown.is_empty() && margin.is_empty() { self.whole_lines(all) } else { all };
            self.edit(all, shown, block.info);
            return;
        }
        // The options are of no use to readers.
        let info = self.text.piece(block.info.range());
        let plain = if info.starts_with('{') { "{.polarform}" } else { "polarform" };
        self.edit(block.info, plain.to_owned(), block.info);
        let results: Vec<&str> = lines.collect();
        if results.is_empty() {
            self.edit(after, String::new(), block.info);
        } else {
            let results = self.lines(["", ""].into_iter().chain(results), margin);
            self.edit(after, results, block.info);
        }
    }
}

/// A text that stands for the options: what is woven with others is out of date.
pub(super) fn signature(options: &Options) -> String {
    let BlockOptions { steps, notation, arrange, style, hide, show, equation, lang, width, breaks, picture } =
        &options.blocks;
    let breaks = match breaks {
        Breaks::Aligned => String::new(),
        other => format!(" {}", other.name()),
    };
    let width = width.map(|points| format!(" {points}")).unwrap_or_default();
    let arranged = match arrange {
        Arrangement::Usual => String::new(),
        other => format!(" {}", other.name()),
    };
    format!(
        "{:?} {steps:?} {notation:?} {style:?} {hide} {show:?} {equation} {lang:?} {picture:?} {:?}{width}{arranged}{breaks}",
        options.mode, options.pictures
    )
}
