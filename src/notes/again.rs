//! Checking a page again after an edit: statements before it are not judged anew, and verdicts behind it are kept until
//! they are.
//!
//! **Rule.** What is known before a statement depends on the statements before it and on how letters are used on the whole
//! page. If both are the same as the last time, so is the state of the checker, and it goes on from there.

use std::collections::HashSet;
use std::sync::atomic::Ordering;

use super::fixes::in_own_words;
use super::page::Options;
use super::statement::statements;
use crate::document::Document;
use crate::formula::source::Span;
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::{FileReport, Finding};
use crate::judge::page::statement::{Place, Said, Statement};
use crate::language::diagnostic::Diagnostic;

/// States are kept of so many places of a page.
const STATES: usize = 24;

/// What is remembered of the last check of a page, for [`check_again`].
#[derive(Default)]
pub struct Memory {
    text: String,
    context: Option<String>,
    statements: Vec<Statement>,
    /// The state before the statement of that number, in ascending order.
    states: Vec<(usize, Checker)>,
    findings: Vec<Finding>,
}

impl Memory {
    /// Whether nothing was checked yet.
    pub fn is_empty(&self) -> bool {
        self.statements.is_empty()
    }
}

/// Where two texts differ: as far as they begin alike, and where the ends that are alike begin in each.
#[derive(Clone, Copy)]
struct Edit {
    start: usize,
    old_end: usize,
    new_end: usize,
}

impl Edit {
    fn between(old: &str, new: &str) -> Self {
        let (old, new) = (old.as_bytes(), new.as_bytes());
        let start = old.iter().zip(new).take_while(|(a, b)| a == b).count();
        let (rest, other) = (&old[start..], &new[start..]);
        let alike = rest.iter().rev().zip(other.iter().rev()).take_while(|(a, b)| a == b).count();
        Edit { start, old_end: old.len() - alike, new_end: new.len() - alike }
    }

    /// Where a span of the old text is in the new one, if the edit did not touch it.
    fn moved(self, span: Span) -> Option<Span> {
        if span.end <= self.start {
            return Some(span);
        }
        let offset = |at: usize| at - self.old_end + self.new_end;
        (span.start >= self.old_end).then(|| Span::new(offset(span.start), offset(span.end)))
    }
}

/// The first byte of what is said.
fn start(said: &Said) -> usize {
    match said {
        Said::Chain(chain) => chain.sides.first().map_or(0, |side| side.expr.span.start),
        Said::Condition(side) | Said::Bare(side, _) => side.expr.span.start,
        Said::Object(object) => object.names.first().map_or(0, |name| name.span.start),
        // It has no place of its own.
        Said::Contact(_) => usize::MAX,
        Said::Triangles(readings, _) => {
            let first = readings.first().and_then(|triangle| triangle.columns[0].first());
            first.map_or(0, |side| side.expr.span.start)
        }
        Said::Declaration(_, span) | Said::Queries(_, span) => span.start,
    }
}

/// The last findings that the edit did not touch, at their new places.
fn kept(findings: &[Finding], edit: Edit) -> impl Iterator<Item = Finding> {
    findings.iter().filter_map(move |finding| {
        let (span, mark) = (edit.moved(finding.span)?, edit.moved(finding.mark)?);
        Some(Finding { span, mark, ..finding.clone() })
    })
}

/// How far a check is.
pub struct Progress<'a> {
    /// Whether all that was edited has been judged.
    pub edited: bool,
    report: &'a dyn Fn() -> FileReport,
}

impl Progress<'_> {
    /// What was found so far, and for what comes after it the verdicts of the last check.
    pub fn report(&self) -> FileReport {
        (self.report)()
    }
}

/// Checks every formula of a page as [`check_document`](super::check_document) does, with the same findings. Statements
/// before an edit are not judged again; `progress` is called after each one that is. The memory is that of the same page.
///
/// Cost: that of the statements from the edit on.
pub fn check_again(
    document: &Document,
    options: &Options,
    memory: &mut Memory,
    progress: &mut dyn FnMut(&Progress),
) -> FileReport {
    run(document, options, Some(memory), progress)
}

/// The same, with or without a memory.
pub(super) fn run(
    document: &Document,
    options: &Options,
    memory: Option<&mut Memory>,
    progress: &mut dyn FnMut(&Progress),
) -> FileReport {
    let statements = statements(document);
    let mut checker = Checker::new(&document.file, &options.limits, &statements);
    let interrupted = || options.limits.interrupt.load(Ordering::Relaxed);
    let Some(memory) = memory else {
        declare(&mut checker, options);
        for statement in &statements {
            if interrupted() {
                break;
            }
            checker.statement(statement);
        }
        checker.conclude();
        return report(document, checker.findings, &checker.problems);
    };
    let edit = Edit::between(&memory.text, document.file.text());
    let same = statements.iter().zip(&memory.statements).take_while(|(new, old)| new == old).count();
    if memory.context != options.context {
        memory.states.clear();
    }
    memory.states.retain(|(number, _)| *number <= same);
    let resumed = memory.states.last().and_then(|(number, state)| Some((*number, checker.resumed(state)?)));
    let first = match resumed {
        Some((number, state)) => {
            checker = state;
            number
        }
        None => {
            memory.states.clear();
            declare(&mut checker, options);
            0
        }
    };
    let edited = statements.iter().rposition(|statement| start(&statement.said) < edit.new_end).unwrap_or(0);
    let every = (statements.len() / STATES).max(1);
    let mut findings = std::mem::take(&mut memory.findings);
    for (number, statement) in statements.iter().enumerate().skip(first) {
        let remembered = memory.states.last().is_some_and(|(last, _)| *last == number);
        if !remembered && (number % every == 0 || number == same) {
            memory.states.push((number, checker.clone()));
        }
        checker.statement(statement);
        if interrupted() {
            break;
        }
        let so_far = || {
            // What is said after a formula ("where …") may come before it.
            let rest = statements[number + 1..].iter().map(|statement| start(&statement.said)).min();
            let done: HashSet<Span> = checker.findings.iter().map(|finding| finding.span).collect();
            let is_later = |finding: &Finding| {
                rest.is_some_and(|rest| rest <= finding.span.start) && !done.contains(&finding.span)
            };
            let later = kept(&findings, edit).filter(is_later);
            report(document, checker.findings.iter().cloned().chain(later).collect(), &checker.problems)
        };
        progress(&Progress { edited: number >= edited, report: &so_far });
    }
    memory.states.retain(|(number, _)| *number % every == 0 || *number == same);
    memory.text = document.file.text().to_owned();
    memory.context = options.context.clone();
    if interrupted() {
        // The verdicts from before, as far as they are of use to the next check.
        findings = kept(&findings, edit).collect();
    } else {
        checker.conclude();
        findings = checker.findings;
    }
    memory.statements = statements;
    memory.findings = findings.clone();
    report(document, findings, &checker.problems)
}

fn declare(checker: &mut Checker, options: &Options) {
    if let Some(context) = &options.context {
        let nowhere = Place::default();
        checker.declare(context, &nowhere, None);
    }
}

fn report(document: &Document, mut findings: Vec<Finding>, problems: &[Diagnostic]) -> FileReport {
    findings.iter_mut().for_each(|finding| in_own_words(document, finding));
    let problems = [document.problems.as_slice(), problems].concat();
    FileReport::new(document.file.clone(), findings, problems)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;

    use proptest::prelude::*;

    use super::super::check_document;
    use super::*;
    use crate::budget::Limits;
    use crate::document::{Container, document};
    use crate::formula::source::SourceFile;

    const PAGE: &str = "# One\n\nLet $F(t) = t^2 + 2t$ with polar form $f$, so $f(t_1, t_2) = t_1 t_2 + t_1 + t_2$.\n\n\
        For $n \\ge 1$ we have $\\sum_{i=0}^n B_i^n(t) = 1$. Then $a = 3$ and $a + 1 = 4$.\n\n\
        # Two\n\nNow $2 + 2 = 5$, and $F(1) = 3$ where $k = 2$. Suppose $x = y$; then $x - y = 0$.\n\n\
        We claim $b_0 = 1$, $b_1 = 2 b_0$ and $(s + 1)^2 = s^2 + 2s + 1$.\n";

    fn page(text: &str) -> Document {
        document(SourceFile::new("page", text), Container::Markdown)
    }

    /// What is put into a page, or typed.
    const PIECES: [&str; 12] =
        ["", "$", "t", "=", "3", " $1 + 1 = 3$ ", "\n\n", "# Three\n\n", "Suppose ", "f(", "$a = 4$", "\\"];

    proptest! {
        #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

        /// The page from the beginning is the other way to each report.
        #[test]
        fn findings_are_those_of_a_new_check(
            edits in prop::collection::vec((0.0..1.0_f64, 0_usize..4, 0_usize..PIECES.len(), any::<bool>()), 1..7)
        ) {
            let mut text = PAGE.to_owned();
            let mut memory = Memory::default();
            for (place, removed, piece, interrupted) in edits {
                let at = (place * text.len() as f64) as usize;
                text.replace_range(at..(at + removed).min(text.len()), PIECES[piece]);
                let document = page(&text);
                // Some edits come while the check before is going on.
                let limits = Limits { interrupt: Arc::new(AtomicBool::new(interrupted)), ..Limits::default() };
                let options = Options { limits, context: None };
                let again = check_again(&document, &options, &mut memory, &mut |_| {});
                if !interrupted {
                    let anew = check_document(&document, &Options::default());
                    prop_assert_eq!(&again.findings, &anew.findings, "{:?}", text);
                    prop_assert_eq!(&again.problems, &anew.problems, "{:?}", text);
                }
            }
        }
    }

    #[test]
    fn only_what_follows_an_edit_is_judged_and_the_rest_is_told_meanwhile() {
        let mut memory = Memory::default();
        let mut judged = |text: &str| {
            let mut steps = Vec::new();
            let again = check_again(&page(text), &Options::default(), &mut memory, &mut |progress| {
                steps.push((progress.edited, progress.report()));
            });
            (steps, again)
        };
        let all = judged(PAGE).0.len();
        assert!(all > 12, "{all}");
        let text = PAGE.replace("2 + 2 = 5", "2 + 2 = 41");
        let (steps, last) = judged(&text);
        assert!(steps.len() < all, "{} of {all}", steps.len());
        let (edited, told) = steps.iter().find(|(edited, _)| *edited).expect("the edit is reached");
        assert!(edited);
        let sorted = |report: &FileReport| {
            let mut findings = report.findings.clone();
            findings.sort_by_key(|finding| (finding.span, finding.relation));
            findings
        };
        assert_eq!(sorted(told), sorted(&last));
        assert!(told.findings.iter().any(|finding| finding.latex == "2 + 2 = 41"));
        // Nothing changed: only what follows the last state is judged.
        assert!(judged(&text).0.len() <= 1);
    }
}
