//! A name in the definition of a function that conditions determine: `p(t) = t^2 + a t + 1, p(2) = 7, a = ?`, `…, find a`.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::written::names::bases;
use crate::language::eval::Equals;
use crate::language::syntax;
use crate::session::lines::several::defining;
use crate::session::{Answer, Failure, Session};

impl Session {
    /// Solves conditions on a function for a name in its definition, which is asked for; `None` if nothing of the kind is said.
    pub(in crate::session) fn run_sought(
        &mut self,
        file: &SourceFile,
        whole: Span,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let Some((head, asked)) = self.sought(file, whole) else { return Ok(None) };
        let Ok(read) = self.read(file, head) else { return Ok(None) };
        let items = match read.kind {
            Kind::Sequence(items) => items,
            _ => return Ok(None),
        };
        let said = items.into_iter().filter(|item| !matches!(item.kind, Kind::Text(_)));
        let (definitions, conditions): (Vec<Expr>, Vec<Expr>) =
            said.partition(|item| of_letter(item).is_some());
        let [definition] = definitions.as_slice() else { return Ok(None) };
        let own = of_letter(definition);
        let about = |condition: &Expr| own.as_ref().is_some_and(|own| bases(condition).contains(own));
        if conditions.is_empty() || !conditions.iter().all(about) || !conditions.iter().all(is_equation) {
            return Ok(None);
        }
        let mut there = self.clone();
        let definition =
            there.evaluated(file, defining(definition.clone()), Equals::DefinesUnbound, false)?;
        let Some(formula) = there.solved_for(file, asked, conditions) else { return Ok(None) };
        let answer = there.evaluated_as(file, formula, whole, Equals::Claims)?;
        self.env = there.env;
        Ok(Some(vec![definition, answer]))
    }

    /// Where the definition and conditions stand, and the name that is asked for behind them.
    fn sought(&self, file: &SourceFile, whole: Span) -> Option<(Span, Span)> {
        let text = file.slice(whole);
        let name = |span: Span| {
            let inside = file.slice(span);
            let first = inside.chars().next().is_some_and(char::is_alphabetic);
            let index = inside.chars().skip(1).all(|c| c.is_ascii_digit() || matches!(c, '_' | '{' | '}'));
            first && index
        };
        let place = |start: usize, end: usize| {
            let inside = text.get(start..end)?;
            let trimmed = inside.trim().trim_end_matches(['?', '？', '.', '=']).trim();
            let begin = start + inside.find(trimmed)?;
            Some(Span::new(begin, begin + trimmed.len()).shifted(whole.start)).filter(|span| name(*span))
        };
        let is_question = |end: usize| {
            let rest: String =
                text.get(end..).unwrap_or_default().chars().filter(|c| !c.is_whitespace()).collect();
            rest.trim_end_matches(['?', '？']).ends_with('=') && rest.ends_with(['?', '？', '='])
        };
        syntax::continuations(text).into_iter().find_map(|found| {
            if !(found.asked || is_question(found.end)) {
                return None;
            }
            let rest = found.rest(text)?;
            let asked = place(rest.start, rest.end)?;
            Some((Span::new(whole.start, whole.start + found.end), asked))
        })
    }
}

/// The function that an equation defines for all values of a letter: p in p(t) = t^2.
fn of_letter(item: &Expr) -> Option<String> {
    let Kind::Chain(left, links) = &item.kind else { return None };
    let ([Link { rel: Rel::Eq | Rel::Define, .. }], Kind::Apply(callee, groups)) =
        (links.as_slice(), &left.kind)
    else {
        return None;
    };
    match (&callee.kind, groups.as_slice()) {
        (Kind::Name(name), [arguments]) => {
            let letters = arguments.iter().all(|argument| matches!(argument.kind, Kind::Name(_)));
            // p(t) = p(1) is a condition.
            let by_itself = links.iter().any(|link| bases(&link.expr).contains(name));
            (letters && !by_itself).then(|| name.clone())
        }
        _ => None,
    }
}

fn is_equation(item: &Expr) -> bool {
    matches!(&item.kind, Kind::Chain(_, links) if matches!(links.as_slice(), [Link { rel: Rel::Eq, .. }]))
}
