//! What sentences say beside their formulas: a join, an operator, an equivalence, a diagonal.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::written::names::{Head, bases, operated, walk};

impl Checker {
    /// (B_n q)(x), where the page says what (B_n f)(x) is: the same with q in the place of f.
    pub(in crate::judge) fn operators(&mut self, chain: &Chain, place: &Place) {
        let mut wanted: Vec<(String, String, Expr)> = Vec::new();
        for side in &chain.sides {
            walk(&side.expr, &mut |part| {
                if let Kind::Group(product) = &part.kind
                    && let (Some(whole), Some((operator, function))) = (Head::of(part), operated(product))
                    && self.context.visible(&whole.base, place).next().is_none()
                {
                    wanted.push((whole.base, operator.base, function.clone()));
                }
            });
        }
        for (base, operator, function) in wanted {
            let like = |known: &str| {
                known.strip_prefix(operator.as_str()).is_some_and(|rest| {
                    // Not one that was made of it.
                    rest.starts_with('[') && rest.chars().all(|c| c.is_alphabetic() || matches!(c, '[' | ']'))
                })
            };
            let definitions = &self.context.definitions;
            let known = definitions.iter().rev().find(|definition| {
                like(&definition.head.base) && place.in_reach(&definition.place, definition.assumed)
            });
            let Some(Definition { head, body: Body::Formula(body), conditions, .. }) = known.cloned() else {
                continue;
            };
            let argument = head.base[operator.len()..].trim_matches(['[', ']']).to_owned();
            let body = body.with_name(&argument, &function);
            self.define(Head { base, ..head }, Body::Formula(body.clone()), &conditions, place, body.span);
        }
    }

    /// "They join if and only if c_0 = b_n": what is known of the join leads to it, or to something else.
    pub(in crate::judge) fn as_a_consequence(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
    ) {
        let named: BTreeSet<String> = chain.sides.iter().flat_map(|side| bases(&side.expr)).collect();
        let told = self.context.objects.iter().filter(|told| {
            told.object.sort == Sort::BezierCurve && statement.place.knows(&told.place, false)
        });
        let letters = |object: &Object| object.points.first().and_then(Head::of).map(|head| head.base);
        let curves: Vec<(String, String)> = told
            .filter_map(|told| Some((Head::of(told.object.names.first()?)?.base, letters(&told.object)?)))
            .collect();
        let joined = curves
            .iter()
            .any(|(curve, points)| named.contains(points) && self.is_constrained(curve, &statement.place));
        if !joined {
            return;
        }
        let claim = Statement { role: Some(Role::Claimed), ..statement.clone() };
        let kept = self.context.clone();
        let tried = self.chain(chain, &claim);
        self.context = kept;
        for (finding, tried) in findings.iter_mut().zip(tried) {
            let refuted = tried.verdict == Verdict::Refuted && tried.determined;
            if refuted || matches!(tried.verdict, Verdict::Proved | Verdict::Sampled) {
                *finding = tried;
            }
        }
    }

    /// "They join with C^1 continuity": what the last two curves of the section, over adjacent intervals, fulfil.
    pub(in crate::judge) fn join(&mut self, expr: &Expr, statement: &Statement) {
        let Kind::Pow(letter, order) = &expr.kind else { return };
        let (Kind::Name(letter), Some(order)) = (&letter.kind, order.as_int()) else { return };
        let place = &statement.place;
        if letter != "C" || !(0..4).contains(&order) || statement.denied {
            return;
        }
        let curves = self.context.objects.iter().rev().filter(|told| {
            told.object.sort == Sort::BezierCurve
                && told.object.names.len() == 1
                && place.knows(&told.place, false)
        });
        let curves: Vec<Rc<Object>> = curves.take(2).map(|told| told.object.clone()).collect();
        let adjacent = match curves.as_slice() {
            [second, first] => match (&first.interval, &second.interval) {
                (Some((_, end)), Some((start, _))) if end.same_as(start) => {
                    Some((first.names[0].clone(), second.names[0].clone(), end.clone()))
                }
                _ => None,
            },
            _ => None,
        };
        let Some((first, second, end)) = adjacent.or_else(|| self.contact(place)) else { return };
        for k in 0..=order {
            let value = |name: &Expr| {
                let name = name.clone();
                let name = if k == 0 { name } else { Kind::Prime(Box::new(name), k as u32).into() };
                Expr::apply(name, vec![end.clone()])
            };
            let equation = Expr::relation(value(&first), Rel::Eq, value(&second));
            self.condition(equation, expr.span, false, place);
        }
    }

    /// "Two cubics F and G meet at a": the two polynomials of which the paragraph speaks, and the parameter that it
    /// names last.
    fn contact(&self, place: &Place) -> Option<(Expr, Expr, Expr)> {
        let here = |other: &Place| other.group == place.group;
        let told = self.context.objects.iter().filter(|told| here(&told.place));
        let polynomials = told.filter(|told| told.object.sort == Sort::Polynomial);
        let mut names: Vec<Expr> = Vec::new();
        for name in polynomials.flat_map(|told| &told.object.names) {
            if !names.iter().any(|known| known.same_as(name)) {
                names.push(name.clone());
            }
        }
        let [first, second] = names.as_slice() else { return None };
        let (_, last) = self.context.heard.iter().rev().filter(|(other, _)| here(other)).nth(1)?;
        let Kind::Name(parameter) = &last.kind else { return None };
        let free = self.context.object_called(parameter, place).is_none();
        free.then(|| (first.clone(), second.clone(), last.as_ref().clone()))
    }

    /// "There is one symmetric multiaffine f with f(t, …, t) = F(t)": f is the polar form of F.
    pub(in crate::judge) fn diagonal(&mut self, chain: &Chain, statement: &Statement) {
        let [(Rel::Eq | Rel::Define, _)] = chain.relations.as_slice() else { return };
        let place = &statement.place;
        let (one, other) = (&chain.sides[0].expr, &chain.sides[1].expr);
        for (form, function) in [(one, other), (other, one)] {
            let (Kind::Apply(f, all), Kind::Apply(of, own)) = (&form.kind, &function.kind) else { continue };
            let ([all], [own]) = (all.as_slice(), own.as_slice()) else { continue };
            let (Kind::Name(name), [argument @ Expr { kind: Kind::Name(_), .. }]) = (&f.kind, own.as_slice())
            else {
                continue;
            };
            let same = |item: &Expr| match &item.kind {
                Kind::Brace(items, _) => {
                    items.iter().all(|item| item.same_as(argument) || item.kind == Kind::Ellipsis)
                }
                _ => item.same_as(argument) || item.kind == Kind::Ellipsis,
            };
            let open = matches!(all.as_slice(), [Expr { kind: Kind::Name(_), .. }]);
            let known = self.context.object_called(name, place).is_some_and(|d| d.object.is_function())
                || self.context.visible(name, place).next().is_some();
            if open
                || known
                || f.same_as(of)
                || !all.iter().all(same)
                || !statement.topics.has(Topic::PolarForm)
            {
                continue;
            }
            let (names, of) = (vec![f.as_ref().clone()], Some(of.as_ref().clone()));
            self.object(&Object { names, of, ..Object::new(Sort::PolarForm) }, place);
            return;
        }
    }
}
