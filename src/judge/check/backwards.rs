//! What a new name makes of an earlier formula: M, where the page wrote x(t) = (1, t, t^2, t^3) M d before.
//!
//! **Rule.** An earlier formula of the section in which a matrix stands that only now is given says more with it: if the
//! field knows what the formula is about, the matrix is right or wrong.

use std::rc::Rc;

use crate::formula::{Delimiter, Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition, Mark};
use crate::judge::page::finding::{Finding, Verdict, blank};
use crate::judge::page::statement::{Chain, Role, Side, Statement};
use crate::judge::written::names::{Head, bases, is_index_letter, walk};

impl Checker {
    /// Judges a matrix by the formula that it makes complete.
    ///
    /// Cost: that of the formula, where a matrix gets a name.
    pub(in crate::judge) fn by_what_it_completes(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let ([left, right], [(Rel::Eq | Rel::Define, _)], [finding]) =
            (chain.sides.as_slice(), chain.relations.as_slice(), &mut *findings)
        else {
            return;
        };
        let Kind::Name(name) = &left.expr.kind else { return };
        let matrix = right.expr.has(&|part| matches!(part.kind, Kind::Matrix(..)));
        let new = finding.verdict == Verdict::Definition && !right.is_unread();
        if !new || !matrix || statement.role == Some(Role::Introduced) || bases(&right.expr).contains(name) {
            return;
        }
        let found =
            self.by_its_entries(chain, statement).or_else(|| self.completed(chain, name, statement, before));
        let Some(Finding { verdict, reason, witness, evidence, .. }) = found else { return };
        if verdict == Verdict::Refuted {
            Rc::make_mut(&mut self.context).forget(before);
        }
        *finding = Finding { verdict, reason, witness, evidence, ..finding.clone() };
    }

    /// What the field says of the last formula before with a matrix put for its name, if that decides it.
    fn completed(
        &mut self,
        chain: &Chain,
        name: &str,
        statement: &Statement,
        before: Mark,
    ) -> Option<Finding> {
        let (left, right, place) = (&chain.sides[0], &chain.sides[1], &statement.place);
        let uses = |own: &&Definition| match &own.body {
            Body::Formula(body) => bases(body).contains(name) && place.knows(&own.place, own.assumed),
            Body::Value(_) => false,
        };
        let earlier = self.context.definitions[..before.definitions()].iter().rev().find(uses);
        let Some(Definition { head, body: Body::Formula(body), .. }) = earlier.cloned() else { return None };
        if head.lower.len() + head.upper.len() > 0 {
            return None;
        }
        let arguments = head.arguments.clone()?;
        let callee = Expr::name(head.base.clone());
        let call = Expr::new(Kind::Apply(Box::new(callee), arguments), left.expr.span);
        let whole = body.with_name(name, &right.expr.clone().grouped());
        let side = |expr: Expr, like: &Side| Side { expr, latex: like.latex.clone() };
        let completed = Chain::new(vec![side(call, left), side(whole, right)], chain.relations.clone());
        let kept = self.context.clone();
        let mut found = vec![Finding { verdict: Verdict::Definition, ..blank(&completed, 0) }];
        self.by_the_field(&completed, statement, &mut found, before);
        self.context = kept;
        let decides =
            |own: &Finding| matches!(own.verdict, Verdict::Proved | Verdict::Sampled | Verdict::Refuted);
        found.pop().filter(decides)
    }

    /// G = a matrix, where the page says what all G_{ij} are.
    fn by_its_entries(&mut self, chain: &Chain, statement: &Statement) -> Option<Finding> {
        let (left, right) = (&chain.sides[0], &chain.sides[1]);
        let name = Head::of(&left.expr)?.base;
        let letter = |index: &Expr| matches!(&index.kind, Kind::Name(name) if is_index_letter(name));
        let entries = |own: &Definition| {
            own.head.lower.len() == 2 && own.head.arguments.is_none() && own.head.lower.iter().all(letter)
        };
        let bernstein = |part: &Expr| Head::of(part).is_some_and(|head| head.is_bernstein());
        let from_zero = {
            let mut known = self.context.visible(&name, &statement.place);
            let (_, own, _) = known.find(|(_, own, near)| *near && entries(own))?;
            matches!(&own.body, Body::Formula(body) if body.has(&bernstein))
        };
        let (rows, columns) = shape(&right.expr)?;
        let members = |first: i64| {
            let entry = |i: i64, j: i64| {
                let lower = vec![Expr::int(first + i), Expr::int(first + j)];
                Some(Expr::from(Kind::Subscript(Box::new(Expr::name(name.clone())), lower)))
            };
            let row = |i: i64| (0..columns).map(|j| entry(i, j)).collect();
            Expr::new(Kind::Matrix((0..rows).map(row).collect(), Delimiter::Paren), left.expr.span)
        };
        let claim = Statement { role: Some(Role::Claimed), ..statement.clone() };
        // Rows may count from 0 or from 1.
        let usual = if from_zero { 0 } else { self.context.letters.first_row() };
        let mut first = None;
        for from in [usual, 1 - usual] {
            let whole = Side { expr: members(from), latex: left.latex.clone() };
            let kept = self.context.clone();
            let found = self.chain(&Chain { sides: vec![whole, right.clone()], ..chain.clone() }, &claim);
            self.context = kept;
            let found = found.into_iter().next()?;
            match found.verdict {
                Verdict::Proved | Verdict::Sampled => return Some(found),
                Verdict::Refuted => first = first.or(Some(found)),
                _ => return None,
            }
        }
        first
    }
}

/// The numbers of rows and columns of a matrix, or of a multiple of one.
fn shape(expr: &Expr) -> Option<(i64, i64)> {
    let mut found = None;
    walk(expr, &mut |part| {
        if let Kind::Matrix(rows, _) = &part.kind {
            let columns = rows.first().map_or(0, Vec::len);
            found = found.or(Some((rows.len() as i64, columns as i64)));
        }
    });
    found
}
