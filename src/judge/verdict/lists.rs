//! Lists of formulas that belong together: the polar forms of a list of polynomials.

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::{Finding, Verdict, blank};
use crate::judge::page::statement::{Chain, Place};
use crate::judge::values::compare::Outcome;
use crate::judge::values::evaluator::evaluate_reading;
use crate::judge::written::names::Head;
use crate::language::value::Value;
use crate::language::write;
use crate::math::blossom::TotalDegreePolarForm;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;

impl Checker {
    /// `B = {…}` where B was a list of as many polynomials before: if the new items are in u_1, u_2,
    /// v_1, … and have the old ones as diagonals, they are meant as polar forms.
    pub(in crate::judge) fn listed(&self, chain: &Chain, place: &Place) -> Option<Finding> {
        let [(Rel::Eq | Rel::Define, _)] = chain.relations.as_slice() else { return None };
        let head = Head::of(&chain.sides[0].expr).filter(|head| head.arguments.is_none())?;
        let new = items(&chain.sides[1].expr)?;
        let (_, definition, _) = self
            .context
            .visible(&head.base, place)
            .find(|(_, d, near)| *near && d.head.arguments.is_none() && d.head.lower.is_empty())?;
        let crate::judge::page::context::Body::Formula(body) = &definition.body else { return None };
        let old = items(body)?;
        if old.len() != new.len() {
            return None;
        }
        let old: Vec<Fraction> = old.iter().map(|item| self.formula(item, place)).collect::<Option<_>>()?;
        let new: Vec<Fraction> = new.iter().map(|item| self.formula(item, place)).collect::<Option<_>>()?;
        // The diagonal: every u_i is u.
        let diagonal = |formula: &Fraction| -> Option<Fraction> {
            let by: Vec<(Symbol, Fraction)> = formula
                .variables()
                .into_iter()
                .filter(|symbol| !symbol.indices().is_empty())
                .map(|symbol| {
                    let plain = Fraction::from(MultiPoly::symbol(Symbol::new(symbol.base())));
                    (symbol, plain)
                })
                .collect();
            formula.substitute(&by).ok()
        };
        let diagonals: Vec<Fraction> = new.iter().map(diagonal).collect::<Option<_>>()?;
        let indexed = new.iter().flat_map(Fraction::variables).any(|symbol| !symbol.indices().is_empty());
        if diagonals != old || !indexed {
            return None;
        }
        let degree = old.iter().filter_map(|f| f.as_polynomial()?.total_degree()).max()? as usize;
        let mut variables: Vec<Symbol> = old.iter().flat_map(Fraction::variables).collect();
        variables.sort();
        variables.dedup();
        let mut finding = blank(chain, 0);
        finding.verdict = Verdict::Proved;
        finding.reason = Some("the polar forms of the list before".to_owned());
        let expr = &chain.sides[1].expr;
        for ((polynomial, claimed), item) in old.iter().zip(&new).zip(items(expr)?) {
            let terms =
                polynomial.as_polynomial()?.terms(MonomialOrder::Lex).into_iter().map(|(powers, c)| {
                    let exponents: Vec<u32> = variables
                        .iter()
                        .map(|v| powers.iter().find(|(symbol, _)| symbol == v).map_or(0, |(_, e)| *e))
                        .collect();
                    (exponents, Fraction::from_rational(&c))
                });
            let form = TotalDegreePolarForm::new(variables.len(), degree, terms).ok()?;
            let points: Vec<Vec<Fraction>> = (1..=degree as i64)
                .map(|i| variables.iter().map(|v| Fraction::from(MultiPoly::symbol(v.numbered(i)))).collect())
                .collect();
            let expanded = form.value(&points).ok()?;
            let outcome = crate::judge::values::compare::relation(
                Rel::Eq,
                &Value::Scalar(claimed.clone()),
                &Value::Scalar(expanded.clone()),
                &[],
                crate::judge::values::compare::Domain::Reals,
            );
            if let Outcome::Fails(judgement) = outcome {
                let polynomial = write::text(&crate::language::value::polynomial_expr(polynomial));
                finding.verdict = Verdict::Refuted;
                finding.reason = Some(format!(
                    "{} is not the polar form of {polynomial}: it is not affine in each argument (u_i, v_i)",
                    write::text(item)
                ));
                finding.witness = judgement.witness.map(|witness| {
                    let values: Vec<String> =
                        witness.assignment.iter().map(|(s, v)| format!("{s} = {v}")).collect();
                    format!("{}: left {}, right {}", values.join(", "), witness.left, witness.right)
                });
                finding.mark = item.span;
                finding.suggestion = Some(write::latex(&crate::language::value::polynomial_expr(&expanded)));
                break;
            }
        }
        Some(finding)
    }

    fn formula(&self, item: &Expr, place: &Place) -> Option<Fraction> {
        let model =
            crate::judge::model::Model::new(self.context.clone(), place.clone(), Default::default(), None);
        match evaluate_reading(item, std::rc::Rc::new(model), []).ok()? {
            Value::Scalar(formula) => Some(formula),
            _ => None,
        }
    }
}

/// The items of a list in braces or brackets.
fn items(expr: &Expr) -> Option<Vec<&Expr>> {
    let list = match &expr.kind {
        Kind::Set(items, None) | Kind::List(items) | Kind::Tuple(items) => items,
        _ => return None,
    };
    (list.len() > 1).then(|| {
        list.iter()
            .flat_map(|item| match &item.kind {
                Kind::Sequence(inner) => inner.iter().collect::<Vec<_>>(),
                _ => vec![item],
            })
            .collect()
    })
}
