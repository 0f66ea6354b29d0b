//! Notations in a formula that decide how its instances are built.

use std::collections::{BTreeMap, BTreeSet};

use crate::formula::{Expr, Kind};
use crate::judge::written::names::{Head, bases, bracket_beside_name, capital_of, is_capital, walk};
use crate::language::lexicon::families::{self, Family};
use crate::language::lexicon::roles;
use crate::language::write;

/// The capital letters F whose small ones occur as polar forms in the chain: F and f both occur,
/// or f has several arguments and F may be known.
pub fn pairs(sides: &[&Expr], may_be_known: &dyn Fn(&str) -> bool) -> BTreeSet<String> {
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
        if !is_capital(base) {
            let capital = capital_of(base);
            if *count > 1 && may_be_known(&capital) || called.contains_key(&capital) {
                found.insert(capital);
            }
        }
    }
    found
}

/// The highest order of a derivative that is written as a number, with primes or as F^{(5)}.
pub fn highest_derivative(side: &Expr) -> usize {
    let number = |expr: &Expr| usize::try_from(expr.as_int()?).ok();
    let mut highest = 0;
    walk(side, &mut |part| {
        let order = match &part.kind {
            Kind::Prime(_, order) => *order as usize,
            Kind::Derivative { variables, .. } => {
                variables.iter().map(|(_, order)| order.as_ref().and_then(number).unwrap_or(1)).sum()
            }
            Kind::Apply(callee, _) => Head::of(callee)
                .filter(|head| head.parenthesized)
                .and_then(|head| head.upper.first().and_then(number))
                .unwrap_or(0),
            _ => 0,
        };
        highest = highest.max(order);
    });
    // Higher ones would take too long.
    highest.min(HIGHEST_ORDER)
}

/// Derivatives up to this order are given functions of sufficient degree.
const HIGHEST_ORDER: usize = 12;

/// Whether divided differences f[x_0, x_1] occur, none of them with a node that is repeated.
pub fn has_divided_differences(sides: &[&Expr]) -> bool {
    let (mut found, mut repeated) = (false, false);
    for side in sides {
        walk(side, &mut |part| {
            let Kind::Mul(factors) = &part.kind else { return };
            for pair in factors.windows(2) {
                let Some(before) = bracket_beside_name(&pair[0], &pair[1]) else { continue };
                found = true;
                if let Kind::List(nodes) = &pair[usize::from(!before)].kind {
                    let same =
                        |(at, node): (usize, &Expr)| nodes[..at].iter().any(|other| other.same_as(node));
                    repeated |= nodes.iter().enumerate().any(same);
                }
            }
        });
    }
    found && !repeated
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

/// The letters that are upper ends of sums and products.
pub fn ends_of_sums(sides: &[&Expr]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Big { upper: Some(upper), .. } = &part.kind
                && let Kind::Name(name) = &upper.kind
            {
                found.insert(name.clone());
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

/// Sums, products, factorials, binomials: signs of an identity rather than of a condition.
pub fn has_structure(side: &Expr) -> bool {
    let mut found = false;
    walk(side, &mut |part| {
        found = found
            || matches!(
                part.kind,
                Kind::Big { .. } | Kind::Factorial(_) | Kind::Binomial(..) | Kind::Integral { .. }
            );
    });
    found
}

/// Whether a function is applied in a formula: s = x(1/2) is a point, t = i/n a parameter.
pub fn has_call(side: &Expr) -> bool {
    let mut found = false;
    walk(side, &mut |part| found |= matches!(part.kind, Kind::Apply(..)));
    found
}

/// Whether an argument of a polar form says how often it stands there: t^n, 0^{n-i}.
pub fn is_repeated(argument: &Expr) -> bool {
    matches!(&argument.kind, Kind::Pow(_, times) if !matches!(times.kind, Kind::Number(_)))
        || matches!(argument.kind, Kind::Upper(..))
}

/// Whether a binomial coefficient of numbers stands in a formula that nobody would write: 0 over 1 is a point.
pub fn has_column(side: &Expr) -> bool {
    let mut found = false;
    let negative = |entry: &Expr| matches!(&entry.kind, Kind::Add(terms) if terms.len() == 1);
    walk(side, &mut |part| {
        if let Kind::Binomial(n, k, _) = &part.kind {
            found |= match (&n.kind, &k.kind) {
                (Kind::Number(n), Kind::Number(k)) => k > n,
                _ => bases(part).is_empty() && (negative(n) || negative(k)),
            };
        }
    });
    found
}

/// B_i^j without an argument beside B_j^n(t).
pub fn without_argument(side: &Expr) -> Option<String> {
    fn search(expr: &Expr, called: &mut bool, bare: &mut Option<String>) {
        let family = |expr: &Expr| {
            Head::of(expr).is_some_and(|head| head.arguments.is_none() && head.is_a(Family::Bernstein))
        };
        if let Kind::Apply(callee, groups) = &expr.kind
            && family(callee)
        {
            *called = true;
            groups.iter().flatten().for_each(|argument| search(argument, called, bare));
        } else if family(expr) {
            bare.get_or_insert_with(|| write::text(expr));
        } else {
            expr.for_each_child(&mut |child| search(child, called, bare));
        }
    }
    let (mut called, mut bare) = (false, None);
    search(side, &mut called, &mut bare);
    bare.filter(|_| called)
}

/// A running index that is free on one side only.
pub fn loose_index(left: &Expr, right: &Expr, conditions: &[Expr]) -> Option<String> {
    let running = |side: &Expr| -> BTreeSet<String> {
        crate::judge::written::names::integer_names(side)
            .into_iter()
            .filter(|name| roles::is_running(name))
            .collect()
    };
    let (a, b) = (running(left), running(right));
    let said: BTreeSet<String> = conditions.iter().flat_map(bases).collect();
    // In the sums of one side the same letter runs: the free one is a slip.
    let mut bound = BTreeSet::new();
    for side in [left, right] {
        walk(side, &mut |part| {
            if let Kind::Big { lower, .. } = &part.kind {
                bound.extend(crate::judge::written::names::own_names(lower));
            }
        });
    }
    a.symmetric_difference(&b).find(|name| bound.contains(*name) && !said.contains(*name)).cloned()
}

/// Whether a side is nothing but a value of a function at numbers or indexed names.
pub fn bare_values(side: &Expr) -> bool {
    match &side.kind {
        Kind::Apply(callee, groups) => {
            Head::of(callee).is_some_and(|head| !families::has_values(&head.base))
                && groups.iter().flatten().all(|argument| {
                    let mut plain = true;
                    walk(argument, &mut |part| {
                        plain = plain
                            && !matches!(&part.kind, Kind::Brace(..) | Kind::Ellipsis | Kind::Big { .. });
                    });
                    plain
                })
        }
        Kind::Group(inner) => bare_values(inner),
        _ => false,
    }
}

/// f(t) = … in t_1, …, t_n
pub fn missing_argument(head: &Head, body: &Expr) -> Option<String> {
    let arguments = head.flat();
    let [argument] = arguments.as_slice() else { return None };
    let Kind::Name(name) = &argument.kind else { return None };
    let (mut plain, mut indexed) = (false, None);
    fn search(expr: &Expr, name: &str, plain: &mut bool, indexed: &mut Option<String>) {
        match &expr.kind {
            Kind::Subscript(base, _) if matches!(&base.kind, Kind::Name(own) if own == name) => {
                indexed.get_or_insert_with(|| write::text(expr));
            }
            Kind::Name(own) if own == name => *plain = true,
            _ => expr.for_each_child(&mut |child| search(child, name, plain, indexed)),
        }
    }
    search(body, name, &mut plain, &mut indexed);
    match (plain, indexed) {
        (false, Some(text)) => Some(format!(
            "the left side is a function of {name}, but the right side has {text} and the like instead"
        )),
        _ => None,
    }
}
