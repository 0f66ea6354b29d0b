//! Conditions in words inside of a formula: the cases "n even", "falls n gerade ist".

use super::speech::{self, Around};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::statement::Role;
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
    expr.for_each_child_mut(&mut read_conditions);
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
