//! Slips that leave nothing to be edited: what is gone has to be put back, what was exchanged everywhere exchanged again.

use crate::formula::{Expr, Kind};
use crate::judge::written::names::{is_index_letter, walk};

/// A formula without one of its roots or exponents.
pub(super) fn of(expr: &Expr, slips: &mut Vec<Expr>) {
    let mut gone: Vec<(Expr, Expr)> = Vec::new();
    walk(expr, &mut |part| match &part.kind {
        Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if name == "sqrt") => {
            let body = groups.iter().flatten().next();
            gone.extend(body.map(|body| (part.clone(), body.clone())));
        }
        Kind::Pow(base, _) if !matches!(base.kind, Kind::Subscript(..)) => {
            gone.push((part.clone(), base.as_ref().clone()));
        }
        // (n - 1)(b_1 - b_0) for n(b_1 - b_0)
        Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if is_index_letter(name)) => {
            if let [group] = groups.as_slice()
                && let [factor] = group.as_slice()
            {
                let other = |by: i64| {
                    Expr::product(vec![callee.as_ref().clone().plus(by).grouped(), factor.clone().grouped()])
                };
                gone.extend([-1, 1].map(|by| (part.clone(), other(by))));
            }
        }
        _ => {}
    });
    for (old, new) in gone {
        let mut edit = expr.clone();
        replace(&mut edit, &old, &new);
        slips.push(edit);
    }
}

/// A formula in which two of its members or names are exchanged, where that may have happened.
pub(super) fn exchanges(expr: &Expr, may_be: &dyn Fn(&Expr, &Expr) -> bool, slips: &mut Vec<Expr>) {
    let mut parts: Vec<Expr> = Vec::new();
    walk(expr, &mut |part| {
        if matches!(part.kind, Kind::Subscript(..) | Kind::Name(_))
            && !parts.iter().any(|known| known.same_as(part))
        {
            parts.push(part.clone());
        }
    });
    // No formula has such a name.
    let between = Expr::name("\u{2022}");
    for (at, one) in parts.iter().enumerate() {
        for other in parts[..at].iter().filter(|other| may_be(one, other)) {
            let mut edit = expr.clone();
            replace(&mut edit, one, &between);
            replace(&mut edit, other, one);
            replace(&mut edit, &between.clone().grouped(), other);
            slips.push(edit);
        }
    }
}

fn replace(expr: &mut Expr, old: &Expr, new: &Expr) {
    *expr = expr.with_parts(&[(old.clone(), new.clone().grouped())]);
}

/// A formula in which a row of a matrix has the other sign, or two of its rows or columns are exchanged, or rows and
/// columns.
pub(super) fn of_matrices(expr: &Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    walk(expr, &mut |part| {
        let Kind::Matrix(rows, delimiter) = &part.kind else { return };
        let width = rows.first().map_or(0, Vec::len);
        if rows.len() < 2 || width < 2 || rows.iter().any(|row| row.len() != width) {
            return;
        }
        let mut add = |rows: Vec<Vec<Option<Expr>>>| {
            let mut edit = expr.clone();
            replace(&mut edit, part, &Expr::new(Kind::Matrix(rows, *delimiter), part.span));
            found.push(edit);
        };
        for at in 0..rows.len() {
            let mut negated = rows.clone();
            for cell in negated[at].iter_mut() {
                *cell = cell.take().map(Expr::negated);
            }
            add(negated);
            for other in 0..at {
                let mut exchanged = rows.clone();
                exchanged.swap(at, other);
                add(exchanged);
            }
        }
        add((0..width).map(|column| rows.iter().map(|row| row[column].clone()).collect()).collect());
        add(rows.iter().map(|row| row.iter().rev().cloned().collect()).collect());
    });
    found
}
