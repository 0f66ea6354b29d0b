//! What the two sides of a relation look like where it fails.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind};
use crate::judge::instances::hypotheses::is_coefficient;
use crate::judge::instances::tally::Failure;
use crate::judge::page::context::is_variable;
use crate::judge::values::compare::{self, Outcome};
use crate::judge::values::roots;
use crate::judge::written::names::walk;
use crate::language::value::Value;
use crate::language::write;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use num_traits::Zero;

/// Whether both sides are made of parameters only.
pub fn are_of_parameters(failure: &Failure) -> bool {
    let parameter = |symbol: &Symbol| symbol.is_plain() && is_variable(symbol.base());
    [&failure.left, &failure.right].into_iter().all(|value| visible(value).iter().all(parameter))
}

/// Whether the sides are equal if letters that only one of them has are renamed to members of a family.
pub fn renames_its_letters(failure: &Failure) -> bool {
    let Outcome::Fails(judgement) = &failure.outcome else { return false };
    let Some(difference) = &judgement.difference else { return false };
    let symbols = visible(difference);
    let open = |symbol: &&Symbol| symbol.is_plain() && !is_variable(symbol.base());
    let letters: Vec<&Symbol> = symbols.iter().filter(open).collect();
    let members: Vec<&Symbol> = symbols.iter().filter(|symbol| !symbol.is_plain()).collect();
    if letters.is_empty() || letters.len() > 3 || members.is_empty() || members.len() > 6 {
        return false;
    }
    let ways = members.len().pow(letters.len() as u32);
    (0..ways).any(|way| {
        let mut rest = way;
        let by: Vec<(Symbol, Fraction)> = letters
            .iter()
            .map(|letter| {
                let member = members[rest % members.len()].clone();
                rest /= members.len();
                ((*letter).clone(), Fraction::from(MultiPoly::symbol(member)))
            })
            .collect();
        let zero = |value: Value| compare::plain(&value).as_rational().is_some_and(|q| q.is_zero());
        compare::substituted(difference, &by).is_some_and(zero)
    })
}

pub fn is_argument(symbol: &Symbol, side: &Expr) -> bool {
    let text = symbol.to_string();
    let mut found = false;
    walk(side, &mut |part| {
        if let Kind::Subscript(..) = &part.kind {
            found = found || write::text(part) == text;
        }
    });
    found
}

/// The symbols of a value that are no roots of numbers and no coefficients of an unknown function.
pub fn visible(value: &Value) -> BTreeSet<Symbol> {
    let known = |symbol: &Symbol| is_coefficient(symbol) || roots::is_root(symbol);
    compare::symbols(value).into_iter().filter(|symbol| !known(symbol)).collect()
}

/// Whether both sides have the same degree in every symbol, as the two sides of a wrong expansion
/// have and those of an equation to be solved have not.
pub fn degrees_agree(failure: &Failure) -> bool {
    let (Value::Scalar(a), Value::Scalar(b)) = (&failure.left, &failure.right) else { return true };
    let (Some(a), Some(b)) = (a.as_polynomial(), b.as_polynomial()) else { return true };
    a.variables().iter().chain(b.variables()).all(|symbol| a.degree_in(symbol) == b.degree_in(symbol))
        && a.total_degree().unwrap_or(0) > 1
}
