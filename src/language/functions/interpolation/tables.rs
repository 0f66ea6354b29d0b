//! The tables of a lecture: divided differences, Neville's and Aitken's tableau.

use super::data::{Datum, difference, difference_label, indexed, indexed_by, labelled};
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::language::value::{Cell, Form, Table, Value};
use crate::math::interpolate::{DividedDifferences, Scheme, Tableau};
use crate::math::poly::Fraction;

/// Whether the nodes have symbols, so that values are long quotients.
fn symbolic(nodes: &[Fraction]) -> bool {
    nodes.iter().any(|x| x.as_rational().is_none())
}

/// The rows of a scheme, each after its node x_i.
fn beside_nodes(nodes: &[Fraction], places: &[usize], levels: Vec<Vec<Cell>>) -> Table {
    let mut table = Table::triangle(levels);
    for ((row, x), place) in table.rows.iter_mut().zip(nodes).zip(places) {
        row.insert(0, labelled(indexed("x", *place), Value::Scalar(x.clone())));
    }
    table
}

/// Row i: x_i, f\[x_i\], f[x_{i−1}, x_i], …, f[x_0, …, x_i]. `places[i]` is the index that node i
/// bears: a repeated node has one.
///
/// For symbolic nodes the differences of higher order are shown as quotients of those before.
pub(crate) fn differences(
    table: &DividedDifferences<Fraction, Datum>,
    places: &[usize],
    form: Form,
) -> Table {
    let nodes = table.nodes();
    let as_quotients = symbolic(nodes);
    let label = |i: usize, k: usize| difference_label((i..=i + k).map(|j| indexed("x", places[j])));
    let cell = |i: usize, k: usize, value: &Datum| {
        if as_quotients && k > 1 && places[i] != places[i + k] {
            let top = Kind::Add(vec![
                Term { sign: Sign::Plus, expr: label(i + 1, k - 1) },
                Term { sign: Sign::Minus, expr: label(i, k - 1) },
            ]);
            let quotient = Expr::from(top).over(ungrouped(difference(&nodes[i + k], &nodes[i])));
            return Cell::Formula(Expr::relation(label(i, k), Rel::Eq, quotient));
        }
        labelled(label(i, k), form.plain(value.clone()))
    };
    let levels = table.columns().iter().enumerate();
    let levels =
        levels.map(|(k, column)| column.iter().enumerate().map(|(i, value)| cell(i, k, value)).collect());
    beside_nodes(nodes, places, levels.collect())
}

/// Row i: x_i, p_i and the interpolants that end with x_i, up to p_{0,…,i}.
///
/// For symbolic nodes each is shown as the combination it is.
pub(crate) fn tableau(tableau: &Tableau<Fraction, Datum>, form: Form) -> Table {
    let nodes = tableau.nodes();
    let as_combinations = symbolic(nodes);
    let indices = |k: usize, i: usize| -> Vec<usize> {
        match tableau.scheme() {
            Scheme::Neville => (i..=i + k).collect(),
            Scheme::Aitken => (0..k).chain([k + i]).collect(),
        }
    };
    let label = |k: usize, i: usize| indexed_by("p", indices(k, i));
    let cell = |k: usize, i: usize, value: &Datum| match tableau.parents(k, i) {
        Some((left, right)) if as_combinations => {
            let own = indices(k, i);
            // Neville combines over the first and last node, Aitken over the last two.
            let l = match tableau.scheme() {
                Scheme::Neville => own[0],
                Scheme::Aitken => own[k - 1],
            };
            let (a, b, t) = (&nodes[l], &nodes[own[k]], tableau.parameter());
            let part = |factor: Expr, entry: usize| Term {
                sign: Sign::Plus,
                expr: Expr::product(vec![factor, label(k - 1, entry)]),
            };
            let top = Kind::Add(vec![part(difference(b, t), left), part(difference(t, a), right)]);
            let quotient = Expr::from(top).over(ungrouped(difference(b, a)));
            Cell::Formula(Expr::relation(label(k, i), Rel::Eq, quotient))
        }
        _ => labelled(label(k, i), form.plain(value.clone())),
    };
    let levels = tableau.levels().iter().enumerate();
    let levels =
        levels.map(|(k, level)| level.iter().enumerate().map(|(i, value)| cell(k, i, value)).collect());
    let places: Vec<usize> = (0..nodes.len()).collect();
    beside_nodes(nodes, &places, levels.collect())
}

/// A denominator needs no brackets of its own.
fn ungrouped(expr: Expr) -> Expr {
    match expr.kind {
        Kind::Group(body) => *body,
        _ => expr,
    }
}
