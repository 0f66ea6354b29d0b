//! Conditions in words inside of a formula: the cases "n even", "falls n gerade ist", sums over odd or even indices.

use super::speech::{self, Around};
use crate::formula::{BigOp, Expr, Kind, Rel, Sign, Term};
use crate::judge::page::statement::{Role, Said, Statement};
use crate::judge::written::names::Head;
use crate::language::latex;

/// (−1)^n = −1 for an odd n, (−1)^n = 1 for an even one.
pub fn parity(n: &Expr, odd: bool) -> Expr {
    let power = Kind::Pow(Box::new(Expr::int(-1).grouped()), Box::new(n.clone()));
    Expr::relation(power.into(), Rel::Eq, Expr::int(if odd { -1 } else { 1 }))
}

/// Puts formulas for the conditions of cases that are said in words.
///
/// Cost: linear in the formula.
pub fn read_conditions(expr: &mut Expr) {
    if let Kind::Cases(cases) = &mut expr.kind {
        for condition in cases.iter_mut().filter_map(|(_, condition)| condition.as_mut()) {
            if let Some(read) = in_words(condition) {
                *condition = read;
            }
        }
    }
    if let Kind::Big { op: BigOp::Sum, lower, body, .. } = &mut expr.kind
        && let Some((index, odd)) = parity_below(lower)
    {
        // Every other term: those with (1 ± (−1)^i)/2 = 1.
        let sign = if odd { Sign::Minus } else { Sign::Plus };
        let power = Expr::int(-1).grouped().power(index);
        let terms = [(Sign::Plus, Expr::int(1)), (sign, power)].map(|(sign, expr)| Term { sign, expr });
        let half = Expr::from(Kind::Add(terms.into())).over(Expr::int(2));
        **body = Expr::new(Kind::Mul(vec![half, std::mem::replace(body, Expr::int(1))]), body.span);
    }
    expr.for_each_child_mut(&mut read_conditions);
}

/// The index of a sum that is said to be odd or even below its sign: `\sum_{i \text{ odd}}`,
/// `\sum_{i=0,\ i \text{ even}}^n`. The words are taken away.
fn parity_below(lower: &mut Vec<Expr>) -> Option<(Expr, bool)> {
    *lower = std::mem::take(lower)
        .into_iter()
        .flat_map(|piece| match piece.kind {
            Kind::Sequence(items) => items,
            _ => vec![piece],
        })
        .collect();
    let at = lower.iter().position(|piece| matches!(piece.kind, Kind::Text(_))).filter(|&at| at > 0)?;
    let (index, Kind::Text(words)) = (&lower[at - 1], &lower[at].kind) else { return None };
    let name = match &index.kind {
        Kind::Name(_) => index.clone(),
        Kind::Chain(left, _) if matches!(left.kind, Kind::Name(_)) => left.as_ref().clone(),
        _ => return None,
    };
    let around = Around { right: words.clone(), ..Around::default() };
    let odd = match speech::role(&around, false)? {
        Role::Odd => true,
        Role::Even => false,
        _ => return None,
    };
    let bounded = |piece: &Expr| matches!(&piece.kind, Kind::Chain(left, _) if left.same_as(&name));
    lower.remove(at);
    if matches!(lower[at - 1].kind, Kind::Name(_)) && lower.iter().any(bounded) {
        lower.remove(at - 1);
    }
    Some((name, odd))
}

fn in_words(condition: &Expr) -> Option<Expr> {
    let parts = match &condition.kind {
        Kind::Sequence(items) | Kind::Tuple(items) => items.as_slice(),
        Kind::Text(_) => std::slice::from_ref(condition),
        _ => return None,
    };
    let mut around = Around::default();
    let mut formula: Option<Expr> = None;
    for part in parts {
        match &part.kind {
            Kind::Text(words) => {
                let mut pieces = words.split('$');
                let first = pieces.next().unwrap_or_default();
                if formula.is_some() { &mut around.right } else { &mut around.left }.push_str(first);
                if let (Some(inner), None) = (pieces.next(), &formula) {
                    formula = Some(latex::read(inner).ok()?.without_spans());
                    around.right.push_str(pieces.next().unwrap_or_default());
                }
            }
            _ if formula.is_none() => formula = Some(part.clone()),
            _ => return None,
        }
    }
    let formula = formula?;
    match speech::role(&around, false)? {
        role @ (Role::Odd | Role::Even) => Some(parity(&formula, role == Role::Odd)),
        Role::Case | Role::All if matches!(formula.kind, Kind::Chain(..)) => Some(formula),
        _ => None,
    }
}

/// "N(t) = 1 for 0 ≤ t < 1, and N(t) = 0 elsewhere": two cases of one formula.
///
/// `elsewhere` says which formula after a statement of the sentence holds in all other cases.
pub(super) fn complete(
    statements: &mut [Statement],
    elsewhere: &dyn Fn(&[Statement], usize) -> Option<Expr>,
) {
    for at in 0..statements.len() {
        let Said::Chain(chain) = &statements[at].said else { continue };
        let function = Head::of(&chain.sides[0].expr).is_some_and(|head| head.arguments.is_some());
        let ([(Rel::Eq | Rel::Define, _)], [condition], true) =
            (chain.relations.as_slice(), chain.conditions.as_slice(), function && !chain.partial)
        else {
            continue;
        };
        let order = matches!(&condition.kind, Kind::Chain(_, links)
            if links.iter().all(|link| matches!(link.rel, Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge | Rel::In)));
        let Some(other) = elsewhere(statements, at).filter(|_| order) else { continue };
        let condition = condition.clone();
        if let Said::Chain(chain) = &mut statements[at].said {
            let value = chain.sides[1].expr.clone();
            let span = value.span;
            chain.sides[1].expr = Expr::new(Kind::Cases(vec![(value, Some(condition)), (other, None)]), span);
            chain.conditions.clear();
        }
    }
}
