//! What a request is about, where that is more than formulas side by side: curves, sums, products, divided differences.

use super::draft::Draft;
use super::utterance::Utterance;
use super::{Reader, draft, one_term};
use crate::formula::source::Span;
use crate::formula::{BigOp, Expr, Kind, Rel, Sign, Term, applied, call};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Equals;
use crate::language::lexicon::phrases::Label;
use crate::language::syntax::{Count, Total, What, family_index};
use crate::language::value::{Value, symbol_expr};
use crate::session::Failure;

impl Reader<'_> {
    /// F[x_0, x_1, …] of a formula in one variable, or of a function: the divided difference of x^3 at 1, 2, 4.
    pub(super) fn divided_difference(&self, asked: &Utterance) -> Option<Expr> {
        let ([Draft { builtin, .. }], [function], [read]) =
            (asked.drafts.as_slice(), asked.items.as_slice(), asked.said.as_slice())
        else {
            return None;
        };
        let at = matches!(read.label, Label::At | Label::Nodes | Label::Knots | Label::With | Label::Over);
        if builtin.name != "divided_differences" || !at {
            return None;
        }
        let nodes = match read.items.as_slice() {
            [Expr { kind: Kind::List(nodes) | Kind::Tuple(nodes), .. }] => nodes.clone(),
            nodes => nodes.to_vec(),
        };
        let outcome = self.session.clone().evaluate(&mut function.clone(), Equals::Claims).ok()?;
        let span = function.span;
        let function = match &outcome.value {
            Value::Function(_) => function.clone(),
            Value::Scalar(formula) => match formula.variables().as_slice() {
                [variable] => {
                    let letter = Expr { span, ..symbol_expr(variable) };
                    Expr::new(Kind::Lambda(vec![letter], Box::new(function.clone())), span).grouped()
                }
                _ => return None,
            },
            _ => return None,
        };
        // the divided differences of x^2 at 0, 2, 5: all of them
        let phrase = self.file.slice(asked.drafts[0].phrase).to_lowercase();
        let several = ["differences", "differenzen", "différences", "diferencias"];
        if several.iter().any(|plural| phrase.contains(plural)) {
            let nodes = draft::list(nodes);
            let values = call("map", vec![function, nodes.clone()], span);
            return Some(call("divided_differences", vec![nodes, values], span));
        }
        let nodes = vec![draft::list(nodes)];
        (nodes.len() == 1).then(|| Expr::new(Kind::Subscript(Box::new(function), nodes), span))
    }

    /// Curves by their control points; where no intervals are said, one begins where the other ends.
    pub(super) fn curves(
        &self,
        curves: Vec<(Span, Option<Span>)>,
    ) -> Result<Option<Vec<Expr>>, Box<Failure>> {
        let mut found = Vec::new();
        for (number, (points, interval)) in (0_i64..).zip(curves) {
            let place = points.shifted(self.start);
            let points = match self.items(points)?.as_slice() {
                [list @ Expr { kind: Kind::List(_), .. }] => list.clone(),
                points => draft::list(points.to_vec()),
            };
            let ends = match interval {
                Some(interval) => match self.items(interval)?.as_slice() {
                    [Expr { kind: Kind::List(ends) | Kind::Tuple(ends), .. }] if ends.len() == 2 => {
                        ends.clone()
                    }
                    _ => return Ok(None),
                },
                None => vec![Expr::int(number), Expr::int(number + 1)],
            };
            found.push(call("bezier", std::iter::once(points).chain(ends).collect(), place));
        }
        Ok(Some(found))
    }

    /// The sum or product of formulas; of lists it is not clear what that is.
    pub(super) fn joined(
        &self,
        op: BigOp,
        spans: Vec<Span>,
        curves: bool,
    ) -> Result<Option<Expr>, Box<Failure>> {
        if curves {
            return self.joined_curves(op, spans);
        }
        let formulas = spans.into_iter().map(|span| self.one(span)).collect::<Result<Vec<_>, _>>()?;
        let several = |item: &Expr| matches!(item.kind, Kind::List(_) | Kind::Tuple(_) | Kind::Sequence(_));
        if formulas.iter().any(several) {
            return Ok(None);
        }
        let span = formulas.iter().map(|formula| formula.span).reduce(Span::to).unwrap_or_default();
        let whole = match op {
            BigOp::Product => Expr::product(formulas.into_iter().map(one_term).collect()),
            BigOp::Sum => Expr::sum(
                formulas.into_iter().map(|expr| Term { sign: Sign::Plus, expr: one_term(expr) }).collect(),
            ),
            _ => return Ok(None),
        };
        Ok(Some(Expr { span, ..whole }))
    }

    /// The sum or product of polynomials by their Bernstein coefficients.
    fn joined_curves(&self, op: BigOp, spans: Vec<Span>) -> Result<Option<Expr>, Box<Failure>> {
        let mut found: Vec<Expr> = Vec::new();
        for place in spans {
            let span = place.shifted(self.start);
            let points = match self.items(place)?.as_slice() {
                [list @ Expr { kind: Kind::List(_), .. }] => list.clone(),
                [Expr { kind: Kind::Tuple(points), .. }] => draft::list(points.clone()),
                [_] => return Ok(None),
                points => draft::list(points.to_vec()),
            };
            found.push(call("bezier", vec![points], span));
        }
        let joined = |left: Expr, right: Expr| {
            let span = left.span.to(right.span);
            match op {
                BigOp::Product => call("curve_product", vec![left, right], span),
                _ => {
                    let term = |expr: Expr| Term { sign: Sign::Plus, expr };
                    Expr { span, ..Expr::sum(vec![term(left), term(right)]) }
                }
            }
        };
        Ok(found.into_iter().reduce(joined).filter(|_| matches!(op, BigOp::Product | BigOp::Sum)))
    }

    /// A number that follows from others: 11 - 3 - 1.
    pub(super) fn count(&self, count: &Count) -> Result<Expr, Box<Failure>> {
        let mut terms = Vec::new();
        for (minus, what) in count {
            let expr = match what {
                What::Formula(span) => self.one(*span)?,
                What::Degree(number) => Expr::int(*number),
                _ => continue,
            };
            terms.push(Term { sign: if *minus { Sign::Minus } else { Sign::Plus }, expr });
        }
        let signed = |term: &Term| match term.sign {
            Sign::Minus => term.expr.as_int().map(|n| -n),
            Sign::Plus => term.expr.as_int(),
        };
        let total: Option<i64> = terms.iter().map(signed).sum();
        let span = terms.iter().map(|term| term.expr.span).filter(|span| !span.is_empty()).reduce(Span::to);
        // C^-1 is no error: the curve may jump there.
        if total.is_some_and(|total| total < 0) && terms.len() > 2 {
            let problem = Diagnostic::error(Code::Domain, "there is no such spline")
                .at(span.unwrap_or_default())
                .reason("m control points of degree n have m + n + 1 knots")
                .hint("give another degree, or another number of knots or points");
            return Err(self.fail(problem));
        }
        Ok(Expr::sum(terms))
    }

    /// The sum or product that is asked for in words.
    pub(super) fn total(&self, total: &Total) -> Result<Expr, Box<Failure>> {
        if total.range == total.body
            && let Some((index, degree)) = family_index(self.file.slice(total.body.shifted(self.start)))
        {
            let body = self.one(total.body)?;
            let span = total.phrase.shifted(self.start).to(body.span);
            let name = |text: &str| match text.parse::<i64>() {
                Ok(number) => Expr { span, ..Expr::int(number) },
                Err(_) => Expr { span, ..Expr::name(text) },
            };
            let body = match &body.kind {
                Kind::Apply(..) => body,
                _ => applied(body, vec![Expr { span, ..Expr::name("t") }], span),
            };
            let lower = vec![Expr { span, ..Expr::relation(name(index), Rel::Eq, Expr::int(0)) }];
            let upper = Some(Box::new(name(degree)));
            return Ok(Expr::new(Kind::Big { op: total.op, lower, upper, body: Box::new(body) }, span));
        }
        let (range, body) = (self.one(total.range)?, self.one(total.body)?);
        let span = total.phrase.shifted(self.start).to(body.span).to(range.span);
        if let (Some(index), Some(end)) = (total.index, total.end) {
            let (name, end) = (self.one(index)?, self.one(end)?);
            let lower = vec![Expr { span: name.span.to(range.span), ..Expr::relation(name, Rel::Eq, range) }];
            let body = Box::new(one_term(body));
            return Ok(Expr::new(Kind::Big { op: total.op, lower, upper: Some(Box::new(end)), body }, span));
        }
        let wrong = || {
            let problem =
                Diagnostic::error(Code::Usage, "a sum needs the first and the last value of its index")
                    .at(range.span)
                    .hint("write sum(k=1..4, k^2)");
            Box::new(Failure { problem, file: self.file.clone() })
        };
        let Kind::Chain(name, links) = &range.kind else { return Err(wrong()) };
        let [link] = links.as_slice() else { return Err(wrong()) };
        let (from, to) = match (&link.expr.kind, total.end) {
            (Kind::Range(from, to), None) => ((**from).clone(), (**to).clone()),
            (_, Some(end)) => (link.expr.clone(), self.one(end)?),
            _ => return Err(wrong()),
        };
        let lower = vec![Expr { span: range.span, ..Expr::relation((**name).clone(), Rel::Eq, from) }];
        let body = Box::new(body.grouped());
        Ok(Expr::new(Kind::Big { op: total.op, lower, upper: Some(Box::new(to)), body }, span))
    }
}
