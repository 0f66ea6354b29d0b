//! A name that is asked for by what words say of an object: `find b_1 such that the quadratic 1, b_1, 3 has the value 2 at 1/2`,
//! `which c_1, c_2 make 0, 1, 2 and 2, c_1, c_2 join C^2?`

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel, applied, call, named};
use crate::judge::written::names::bases;
use crate::language::eval::Equals;
use crate::language::lexicon::{roles, wanted};
use crate::session::{Answer, Failure, Session};

impl Session {
    /// Solves what words say for the names that are asked for; `None` if the text is no such question.
    pub(in crate::session) fn run_condition(
        &mut self,
        file: &SourceFile,
        whole: Span,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let Some(formula) = self.condition(file, whole) else { return Ok(None) };
        self.evaluated_as(file, formula, whole, Equals::Claims).map(|answer| Some(vec![answer]))
    }

    fn condition(&self, file: &SourceFile, whole: Span) -> Option<Expr> {
        let text = file.slice(whole);
        let (names, claim) = wanted::asked_by_condition(text)?;
        let names = self.names_in(file, names.shifted(whole.start))?;
        let place = claim.shifted(whole.start);
        let (claim, order) = match wanted::order_of_join(file.slice(place)) {
            Some((start, end, geometric, order)) => {
                // The order may stand anywhere in what is said; the words for a join are read with it.
                let mut masked = file.text().as_bytes().to_vec();
                masked[place.start + start..place.start + end].fill(b' ');
                let masked = SourceFile::new(file.name(), String::from_utf8(masked).ok()?);
                let join = self.spoken(&masked, place).ok().flatten().or_else(|| {
                    let text = format!("{} join", masked.slice(place).trim_end_matches(['?', ' ', '.']));
                    let alone = SourceFile::new(file.name(), text);
                    self.spoken(&alone, Span::new(0, alone.text().len())).ok().flatten()
                })?;
                (join, Some((geometric, order)))
            }
            None => (self.spoken(file, place).ok().flatten()?, None),
        };
        let list = |items: &[Expr]| Expr::new(Kind::List(items.to_vec()), whole);
        let claim = called_at(claim, &names);
        match (&claim.kind, order) {
            (Kind::Chain(_, links), None) if matches!(links.as_slice(), [Link { rel: Rel::Eq, .. }]) => {
                let inside = bases(&claim);
                let known = names.iter().all(|name| bases(name).iter().all(|base| inside.contains(base)));
                let unknowns = match names.as_slice() {
                    [one] => one.clone(),
                    several => list(several),
                };
                known.then(|| call("solve", vec![claim.clone(), unknowns], whole))
            }
            (Kind::Apply(callee, groups), Some((geometric, order))) => {
                let Kind::Name(function) = &callee.kind else { return None };
                if !matches!(function.as_str(), "continuity" | "geometric_continuity") {
                    return None;
                }
                let curves = groups.first()?.iter().take(2).cloned();
                let order = Expr { span: whole, ..Expr::int(order) };
                let function = if geometric { "geometric_continuity" } else { "joining_conditions" };
                let mut arguments: Vec<Expr> = curves.chain([order]).collect();
                arguments.push(named("unknowns", list(&names)));
                Some(applied(Expr { span: whole, ..Expr::name(function) }, arguments, whole))
            }
            _ => None,
        }
    }

    /// The names that stand in a text: c_1, c_2; c_1 and c_2.
    pub(in crate::session) fn names_in(&self, file: &SourceFile, span: Span) -> Option<Vec<Expr>> {
        let text = file.slice(span);
        let mut found = Vec::new();
        let mut start = 0;
        let ends: Vec<(usize, usize)> = wanted::conjunctions(text)
            .into_iter()
            .chain(text.match_indices([',', ';']).map(|(at, sign)| (at, at + sign.len())))
            .collect();
        let mut ends = ends;
        ends.sort_unstable();
        for (end, next) in ends.into_iter().chain([(text.len(), text.len())]) {
            let part = Span::new(span.start + start, span.start + end);
            let name = self.read(file, part).ok()?;
            if !matches!(name.kind, Kind::Name(_) | Kind::Subscript(..)) {
                return None;
            }
            found.push(name);
            start = next;
        }
        Some(found)
    }
}

/// A curve that is claimed to have a value, at the parameter that is asked for: for which t is the curve equal to 1?
fn called_at(claim: Expr, names: &[Expr]) -> Expr {
    let ([Expr { kind: Kind::Name(name), .. }], Kind::Chain(left, links)) = (names, &claim.kind) else {
        return claim;
    };
    let curve = matches!(&left.kind, Kind::Apply(callee, _)
        if matches!(&callee.kind, Kind::Name(own) if matches!(own.as_str(), "bezier" | "derivative")));
    if !curve || !roles::is_variable(name) || bases(&claim).contains(name) {
        return claim;
    }
    let span = claim.span;
    let left = applied((**left).clone(), vec![names[0].clone()], left.span);
    Expr::new(Kind::Chain(Box::new(left), links.clone()), span)
}
