//! Declarations: what a comment or a side file says about the names of the notes.
//!
//! A declaration is a sequence of statements of the query language: definitions
//! (`F(t) := t^2 + 1`), conditions (`0 <= i <= n`, `a + b + c = 1`), or `ignore`, after which the next
//! formula is not judged. What a block of queries defines is declared, too: weaving runs the block, and
//! the text around it speaks of its names.

use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Source};
use crate::judge::page::statement::Place;
use crate::judge::written::names::Head;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::{latex, syntax};

fn read(statement: &str) -> Result<Expr, Diagnostic> {
    if syntax::looks_like_latex(statement) { latex::read(statement) } else { syntax::parse(statement) }
}

impl Checker {
    /// Takes in declarations; `span` is their place in the file, if they stand there.
    pub fn declare(&mut self, text: &str, place: &Place, span: Option<Span>) {
        let text = text.trim();
        if text == "ignore" || text == "ignore next" {
            self.ignored += 1;
            return;
        }
        let pieces = match syntax::statements(text) {
            Ok(spans) => spans,
            Err(problem) => {
                self.complain(&problem.message, span);
                return;
            }
        };
        for piece in pieces {
            let part = &text[piece.range()];
            match read(part) {
                Ok(expr) => self.declaration(&expr, place, span),
                Err(problem) => self.complain(&problem.message, span),
            }
        }
    }

    /// Takes in the definitions of a block of queries. Other statements are its own business, and so is
    /// what is wrong with it: weaving tells.
    pub(in crate::judge) fn queries(&mut self, text: &str, place: &Place, span: Span) {
        for piece in syntax::statements(text).unwrap_or_default() {
            let Ok(expr) = read(&text[piece.range()]) else { continue };
            let Kind::Chain(left, links) = &expr.kind else { continue };
            let Some(head) = Head::of(left) else { continue };
            let known = || self.context.definitions.iter().any(|known| known.head.base == head.base);
            let defines = match links.as_slice() {
                [link] => link.rel == Rel::Define || (link.rel == Rel::Eq && !known()),
                _ => false,
            };
            if defines {
                self.define_by(Source::Query, head, Body::Formula(links[0].expr.clone()), &[], place, span);
            }
        }
    }

    fn declaration(&mut self, expr: &Expr, place: &Place, span: Option<Span>) {
        let at = span.unwrap_or_default();
        if let Kind::Chain(left, links) = &expr.kind {
            let defines = links[0].rel == Rel::Define
                || (links[0].rel == Rel::Eq && links.len() == 1 && matches!(left.kind, Kind::Apply(..)));
            if defines && let Some(head) = Head::of(left) {
                let body = Body::Formula(links[0].expr.clone());
                self.define_by(Source::Declaration, head, body, &[], place, at);
                return;
            }
            self.condition(expr.clone(), at, false, place);
            return;
        }
        self.complain(
            "a declaration is a definition such as F(t) := t^2, a condition, or the word ignore",
            span,
        );
    }

    fn complain(&mut self, message: &str, span: Option<Span>) {
        let problem =
            Diagnostic::warning(Code::BadDefinition, format!("this declaration is passed over: {message}"))
                .hint("write, for example, <!-- polarform: F(t) := t^2 + 1 -->");
        self.problems.push(match span {
            Some(span) => problem.at(span),
            None => problem,
        });
    }
}
