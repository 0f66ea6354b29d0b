//! Numbers for the curvature of the one curve that the section gives.
//!
//! **Formula.** κ² = ((x' · x')(x'' · x'') − (x' · x'')²)/(x' · x')³, in any dimension, for any parameter. Which sign the
//! curvature of a plane curve has depends on who is asked, so that it is its square that is compared.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::meanings::New;
use crate::budget;
use crate::formula::{Expr, Kind, Quotient, Rel, Sign, Term};
use crate::judge::known::checker::Checker;
use crate::judge::known::found::Curve;
use crate::judge::page::context::{Body, Mark, is_variable};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::statement::{Chain, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::counterexample;
use crate::judge::written::names::bases;

/// The letter that everybody uses.
const CURVATURE: &str = "kappa";

impl Checker {
    /// Judges numbers for κ(t).
    pub(in crate::judge) fn by_curvature(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let left = &chain.sides[0].expr;
        let Kind::Apply(callee, groups) = &left.kind else { return };
        let ([group], true) =
            (groups.as_slice(), matches!(&callee.kind, Kind::Name(name) if name == CURVATURE))
        else {
            return;
        };
        let [at] = group.as_slice() else { return };
        if !statement.topics.has(Topic::Curvature)
            || chain.blocked
            || !chain.relations.iter().all(|(relation, _)| *relation == Rel::Eq)
        {
            return;
        }
        let number = |side: &Side| bases(&side.expr).is_empty() && !side.is_unread();
        let Some(last) = chain.sides.last().filter(|side| number(side)) else { return };
        let Some(finding) = findings
            .last()
            .filter(|finding| matches!(finding.verdict, Verdict::Definition | Verdict::Undecided))
        else {
            return;
        };
        let limits = self.limits.clone();
        let found = budget::run(&limits, || self.curvature(at, left, &last.expr, chain, statement, finding));
        let Ok(Some(found)) = found else { return };
        if found.verdict == Verdict::Refuted {
            Rc::make_mut(&mut self.context).forget(before);
        }
        if let Some(own) = findings.last_mut() {
            *own = found;
        }
    }

    fn curvature(
        &mut self,
        at: &Expr,
        left: &Expr,
        right: &Expr,
        chain: &Chain,
        statement: &Statement,
        finding: &Finding,
    ) -> Option<Finding> {
        let new = New::of(left, right)?;
        let mut curves = self.curves(&new, right, statement);
        curves.extend(self.curve_by_coordinates(statement));
        let mut found: Vec<Finding> = Vec::new();
        for (number, curve) in curves.iter().enumerate() {
            // One curve may have a name and be known by its points, too.
            if !curves[..number].iter().any(|other| other.name.same_as(&curve.name)) {
                found.extend(self.curvature_of(curve, at, right, chain, statement, finding));
            }
        }
        let first = found.pop()?;
        // Points of two letters may be those of two curves, of which one was not understood.
        let here =
            self.rows.iter().filter(|row| !row.letter.is_empty() && statement.place.knows(&row.place, false));
        let letters: BTreeSet<&String> = here.map(|row| &row.letter).collect();
        let one = letters.len() < 2 || first.verdict == Verdict::Proved;
        (one && found.iter().all(|other| other.verdict == first.verdict)).then_some(first)
    }

    fn curvature_of(
        &mut self,
        curve: &Curve,
        at: &Expr,
        right: &Expr,
        chain: &Chain,
        statement: &Statement,
        finding: &Finding,
    ) -> Option<Finding> {
        let derivative = |order| {
            let callee = Kind::Prime(Box::new(curve.name.clone()), order).into();
            Expr::from(Kind::Apply(Box::new(callee), vec![vec![at.clone()]]))
        };
        let (one, two) = (derivative(1), derivative(2));
        let dot = |a: &Expr, b: &Expr| Expr::product(vec![a.clone(), b.clone()]);
        let power = |base: Expr, exponent| {
            Expr::from(Kind::Pow(Box::new(Kind::Group(Box::new(base)).into()), Box::new(Expr::int(exponent))))
        };
        let whole = Expr::product(vec![dot(&one, &one), dot(&two, &two)]);
        let area = Expr::sum(vec![
            Term { sign: Sign::Plus, expr: whole },
            Term { sign: Sign::Minus, expr: power(dot(&one, &two), 2) },
        ]);
        let square =
            Expr::from(Kind::Div(Box::new(area), Box::new(power(dot(&one, &one), 3)), Quotient::Fraction));
        let side = |expr: Expr| Side { expr, latex: String::new() };
        let squares = Chain {
            sides: vec![side(square), side(power(right.clone(), 2))],
            relations: vec![chain.relations[0]],
            ..chain.clone()
        };
        let object = curve.object.clone();
        let tally = self.with_objects(object.into_iter(), &squares, statement);
        if !tally.errors.is_empty() || !tally.unclear.is_empty() {
            return None;
        }
        let words = "the curvature of this curve";
        if let Some(failure) = tally.fails.first() {
            return Some(Finding {
                verdict: Verdict::Refuted,
                reason: Some(format!("it differs from {words}")),
                witness: counterexample::counterexample(failure).map(|text| format!("squares: {text}")),
                suggestion: None,
                evidence: vec![Evidence::Field],
                ..finding.clone()
            });
        }
        (tally.holds > 0).then(|| Finding {
            verdict: Verdict::Proved,
            reason: Some(format!("{words}, as the words say")),
            witness: None,
            suggestion: None,
            ..finding.clone()
        })
    }

    /// x(t) = (t, t^2)
    fn curve_by_coordinates(&self, statement: &Statement) -> Option<Curve> {
        let place = &statement.place;
        let known = self.context.definitions.iter().rev().find(|definition| {
            let plain = definition.head.lower.is_empty() && definition.head.upper.is_empty();
            let variable = matches!(definition.head.flat().as_slice(), [Expr { kind: Kind::Name(name), .. }] if is_variable(name));
            let point = matches!(&definition.body, Body::Formula(body) if body.items().is_some_and(|items| items.len() > 1));
            plain && variable && point && place.knows(&definition.place, definition.assumed)
        })?;
        Some(Curve::new(Expr::name(&known.head.base), Expr::int(1)))
    }
}
