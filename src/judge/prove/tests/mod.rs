//! Identities that must be proved, near misses that must not be, and random changes of the
//! former against evaluation at numbers.

mod brute;
mod closed_forms;
mod definitions;
mod identities;
mod mutations;
mod near_misses;

use super::{Proof, prove};
use crate::formula::{Expr, Kind};
use crate::language::latex;

/// The sides of an equation.
fn sides(text: &str) -> (Expr, Expr) {
    match latex::read(text).unwrap_or_else(|problem| panic!("{text}: {problem:?}")).kind {
        Kind::Chain(left, mut links) => {
            let right = links.pop().expect("a chain has a link").expr;
            (*left, right)
        }
        other => panic!("{text}: {other:?}"),
    }
}

fn proof(text: &str) -> Option<Proof> {
    let (left, right) = sides(text);
    prove(&left, &right, &|_| None)
}
