//! Notations in a formula that decide how its instances are built.

use std::collections::{BTreeMap, BTreeSet};

use super::names::{Head, walk};
use crate::formula::{Expr, Kind};
use crate::language::lexicon::families::Family;

/// The capital letters F whose small ones occur as polar forms in the chain: F and f both occur,
/// or f has several arguments.
pub fn pairs(sides: &[&Expr]) -> BTreeSet<String> {
    let mut called: BTreeMap<String, usize> = BTreeMap::new();
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Apply(callee, groups) = &part.kind
                && let Some(head) = Head::of(callee)
            {
                let count = groups.iter().flatten().count();
                let most = called.entry(head.base).or_insert(0);
                *most = (*most).max(count);
            }
        });
    }
    let mut found = BTreeSet::new();
    for (base, count) in &called {
        if base.chars().next().is_some_and(char::is_lowercase) {
            let capital = super::model::capital_of(base);
            if *count > 1 || called.contains_key(&capital) {
                found.insert(capital);
            }
        }
    }
    found
}

/// Whether divided differences f[x_0, x_1] occur.
pub fn has_divided_differences(sides: &[&Expr]) -> bool {
    let mut found = false;
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Mul(factors) = &part.kind {
                found = found
                    || factors.windows(2).any(|pair| {
                        matches!(&pair[0].kind, Kind::Name(name) if matches!(name.as_str(), "f" | "g" | "F" | "p"))
                            && matches!(&pair[1].kind, Kind::List(_))
                    });
            }
        });
    }
    found
}

/// Whether functions of two groups of arguments occur: f(u_1, u_2; v_1, v_2).
pub fn has_groups(sides: &[&Expr]) -> bool {
    let mut found = false;
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Apply(callee, groups) = &part.kind {
                found =
                    found || groups.len() == 2 && Head::of(callee).is_some_and(|head| head.lower.is_empty());
            }
        });
    }
    found
}

/// Whether B-splines occur.
pub fn has_splines(sides: &[&Expr]) -> bool {
    let mut found = false;
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Apply(callee, _) = &part.kind
                && let Some(head) = Head::of(callee)
            {
                found = found || head.is_a(Family::Spline);
            }
        });
    }
    found
}
