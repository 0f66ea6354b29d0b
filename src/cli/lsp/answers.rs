//! What editors show of the findings on a page.

use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, DiagnosticSeverity, DocumentChanges, Hover,
    HoverContents, InlayHint, InlayHintLabel, InlayHintTooltip, MarkupContent, MarkupKind, NumberOrString,
    OneOf, OptionalVersionedTextDocumentIdentifier, Position, TextDocumentEdit, TextEdit, Uri, WorkspaceEdit,
};

use super::checker::Checked;
use crate::formula::source::Span;
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic::Severity;
use crate::notes::report::{Fix, Rule, fixes, message};

/// As much of a suggestion stands in a menu.
const TITLE: usize = 60;

impl Checked {
    fn text(&self) -> &str {
        self.report.file.text()
    }

    /// The byte at a place.
    pub fn byte(&self, position: Position) -> usize {
        self.places.byte(self.text(), position)
    }

    fn mark(
        &self,
        span: Span,
        severity: DiagnosticSeverity,
        code: &str,
        message: String,
    ) -> lsp_types::Diagnostic {
        lsp_types::Diagnostic {
            range: self.places.range(self.text(), span),
            severity: Some(severity),
            code: Some(NumberOrString::String(code.to_owned())),
            source: Some("polarform".to_owned()),
            message,
            ..Default::default()
        }
    }

    /// What is refuted, what is suspicious, and what is wrong with the page itself.
    pub fn diagnostics(&self) -> Vec<lsp_types::Diagnostic> {
        let mut all: Vec<_> = self.report.findings.iter().flat_map(|finding| self.marks(finding)).collect();
        for problem in &self.report.problems {
            let severity = match problem.severity {
                Severity::Error => DiagnosticSeverity::ERROR,
                Severity::Warning => DiagnosticSeverity::WARNING,
                Severity::Note => DiagnosticSeverity::INFORMATION,
            };
            let lines =
                [problem.message.as_str()].into_iter().chain(problem.hints.iter().map(String::as_str));
            let text = lines.collect::<Vec<_>>().join("\n");
            all.push(self.mark(problem.span.unwrap_or_default(), severity, problem.code.id(), text));
        }
        all
    }

    fn marks(&self, finding: &Finding) -> Vec<lsp_types::Diagnostic> {
        let mut marks = Vec::new();
        if let Some((rule @ Rule::Refuted, text)) = message(finding) {
            marks.push(self.mark(finding.span, DiagnosticSeverity::ERROR, rule.id(), text));
        }
        if let Some(warning) = &finding.warning {
            let rule = Rule::Suspicious.id();
            marks.push(self.mark(finding.span, DiagnosticSeverity::WARNING, rule, warning.clone()));
        }
        marks
    }

    /// The verdict on the relation at a byte, how it was read, and what that rests on.
    pub fn hover(&self, byte: usize, markdown: bool) -> Option<Hover> {
        let there = |finding: &&Finding| finding.span.start <= byte && byte <= finding.span.end;
        // Relations of a chain share their sides: the one whose sign is nearest is meant.
        let distance = |finding: &&Finding| {
            let sign = finding.mark;
            (sign.start.saturating_sub(byte)).max(byte.saturating_sub(sign.end))
        };
        let finding = self.report.findings.iter().filter(there).min_by_key(distance)?;
        let (kind, value) = match markdown {
            true => (MarkupKind::Markdown, told(finding, true)),
            false => (MarkupKind::PlainText, told(finding, false)),
        };
        let contents = HoverContents::Markup(MarkupContent { kind, value });
        Some(Hover { contents, range: Some(self.places.range(self.text(), finding.span)) })
    }

    /// A mark behind each claim between two bytes: ✓ proved, ≈ true in all instances tried, ✗ refuted, ? undecided.
    pub fn hints(&self, between: Span, markdown: bool) -> Vec<InlayHint> {
        let mark = |finding: &Finding| match finding.verdict {
            _ if finding.relation == 0 => None,
            Verdict::Proved => Some("✓"),
            Verdict::Sampled => Some("≈"),
            Verdict::Refuted => Some("✗"),
            Verdict::Undecided => Some("?"),
            Verdict::Definition | Verdict::Unread => None,
        };
        let near = |finding: &&Finding| between.start <= finding.span.end && finding.span.end <= between.end;
        let all = self.report.findings.iter().filter(near).filter_map(|finding| {
            let kind = if markdown { MarkupKind::Markdown } else { MarkupKind::PlainText };
            let told = MarkupContent { kind, value: told(finding, markdown) };
            Some(InlayHint {
                position: self.places.position(self.text(), finding.span.end),
                label: InlayHintLabel::String(mark(finding)?.to_owned()),
                kind: None,
                text_edits: None,
                tooltip: Some(InlayHintTooltip::MarkupContent(told)),
                padding_left: Some(true),
                padding_right: None,
                data: None,
            })
        });
        all.collect()
    }

    /// The suggestions for what is refuted between two bytes, and all of them at once.
    pub fn actions(&self, uri: &Uri, between: Span, versioned: bool) -> Vec<CodeActionOrCommand> {
        let edit = |fixes: Vec<Fix>| self.edit(uri, fixes, versioned);
        let mut actions = Vec::new();
        let near =
            |finding: &&Finding| finding.span.start <= between.end && between.start <= finding.span.end;
        for finding in self.report.findings.iter().filter(near) {
            let Some(suggestion) = &finding.suggestion else { continue };
            let found = self.fixes(vec![finding.clone()]);
            if !found.is_empty() {
                actions.push(CodeActionOrCommand::CodeAction(CodeAction {
                    title: format!("Replace by {}", head(suggestion)),
                    kind: Some(CodeActionKind::QUICKFIX),
                    diagnostics: Some(self.marks(finding)),
                    edit: Some(edit(found)),
                    is_preferred: Some(true),
                    ..CodeAction::default()
                }));
            }
        }
        if !actions.is_empty() {
            actions.push(CodeActionOrCommand::CodeAction(CodeAction {
                title: "Put all suggestions of polarform into the page".to_owned(),
                kind: Some(CodeActionKind::SOURCE_FIX_ALL),
                edit: Some(edit(self.fixes(self.report.findings.clone()))),
                ..CodeAction::default()
            }));
        }
        actions
    }

    fn fixes(&self, findings: Vec<Finding>) -> Vec<Fix> {
        let report = FileReport::new(self.report.file.clone(), findings, Vec::new());
        fixes(&self.document, &report)
    }

    fn edit(&self, uri: &Uri, fixes: Vec<Fix>, versioned: bool) -> WorkspaceEdit {
        let put = |fix: Fix| TextEdit::new(self.places.range(self.text(), fix.span), fix.text);
        workspace_edit(uri, fixes.into_iter().map(put).collect(), versioned.then_some(self.version))
    }
}

/// Edits of a page; with its version, so that they are never put into a text that has changed.
pub(super) fn workspace_edit(uri: &Uri, edits: Vec<TextEdit>, version: Option<i32>) -> WorkspaceEdit {
    if version.is_none() {
        return WorkspaceEdit::new([(uri.clone(), edits)].into_iter().collect());
    }
    let text_document = OptionalVersionedTextDocumentIdentifier { uri: uri.clone(), version };
    let edits = edits.into_iter().map(OneOf::Left).collect();
    let changes = DocumentChanges::Edits(vec![TextDocumentEdit { text_document, edits }]);
    WorkspaceEdit { document_changes: Some(changes), ..WorkspaceEdit::default() }
}

/// The beginning of a formula, for a menu.
fn head(formula: &str) -> String {
    let mut head: String = formula.chars().take(TITLE).collect();
    if head.len() < formula.len() {
        head.push('…');
    }
    head
}

/// A finding in words, line by line.
fn told(finding: &Finding, markdown: bool) -> String {
    let word = finding.verdict.word();
    let plain = |text: &str| if markdown { escaped(text) } else { text.to_owned() };
    let mut lines = vec![match (markdown, &finding.reason) {
        (true, None) => format!("**{word}**"),
        (true, Some(reason)) => format!("**{word}**: {}", plain(reason)),
        (false, None) => word.to_owned(),
        (false, Some(reason)) => format!("{word}: {reason}"),
    }];
    let formulas = [("counterexample", &finding.witness), ("suggestion", &finding.suggestion)];
    for (label, text) in formulas {
        let code = |text: &String| if markdown { code(text) } else { text.clone() };
        lines.extend(text.as_ref().map(|text| format!("{label}: {}", code(text))));
    }
    for (label, text) in [("tried", &finding.instances), ("suspicious", &finding.warning)] {
        lines.extend(text.as_ref().map(|text| format!("{label}: {}", plain(text))));
    }
    lines.extend(finding.notes.iter().map(|note| format!("assumed: {}", plain(note))));
    if !finding.reading.is_empty() {
        lines.push(match markdown {
            true => format!("read as\n{}", fenced(&finding.reading)),
            false => format!("read as: {}", finding.reading),
        });
    }
    lines.join(if markdown { "\n\n" } else { "\n" })
}

/// Backquotes that do not stand in the text, at least so many.
fn fence(text: &str, least: usize) -> String {
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    "`".repeat(least.max(longest + 1))
}

/// A formula in a block of code, whatever is in it.
fn fenced(text: &str) -> String {
    let fence = fence(text, 3);
    format!("{fence}latex\n{text}\n{fence}")
}

/// A formula among words, as code.
fn code(text: &str) -> String {
    let fence = fence(text, 1);
    let blank = if text.starts_with('`') || text.ends_with('`') { " " } else { "" };
    format!("{fence}{blank}{}{blank}{fence}", text.replace(['\r', '\n'], " "))
}

/// Words that Markdown leaves as they are.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '&' | '~' | '$' | '|' => out.extend(['\\', c]),
            '\r' | '\n' => out.push(' '),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_stay_texts() {
        assert_eq!(escaped("c_1 * <b>\n# a - 1."), r"c\_1 \* \<b\> # a - 1.");
        assert_eq!(
            (code("a_1"), code("`"), code("a``b`")),
            ("`a_1`".to_owned(), "`` ` ``".to_owned(), "``` a``b` ```".to_owned())
        );
        assert_eq!(fenced("a"), "```latex\na\n```");
        assert_eq!(fenced("```\na"), "````latex\n```\na\n````");
    }
}
