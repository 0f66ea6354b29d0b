//! Tables of data: a row of arguments above a row of values.

use std::collections::BTreeMap;

use super::super::sentence::Piece;
use super::subject::named;
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, bases};
use crate::language::syntax;

/// A row of a table: its name and the numbers after it.
pub(super) struct Row {
    name: Expr,
    values: Vec<Expr>,
}

/// The row that a piece of a table is: x_i | 0 | 1 | 3.
pub(super) fn row(pieces: &[Piece], formulas: &BTreeMap<usize, Vec<Expr>>) -> Option<Row> {
    let mut cells: Vec<Vec<Expr>> = vec![Vec::new()];
    let mut bars = 0;
    for piece in pieces {
        match piece {
            Piece::Formula(number) => cells.last_mut()?.extend(formulas.get(number)?.iter().cloned()),
            Piece::Words(words) => {
                for (at, cell) in words.split('|').enumerate() {
                    if at > 0 {
                        bars += 1;
                        cells.push(Vec::new());
                    }
                    let cell = cell.trim();
                    if !cell.is_empty() {
                        cells.last_mut()?.push(syntax::parse(cell).ok()?);
                    }
                }
            }
        }
    }
    let cells: Vec<Vec<Expr>> = cells.into_iter().filter(|cell| !cell.is_empty()).collect();
    let cells: Vec<Expr> = cells
        .into_iter()
        .map(|cell| <[Expr; 1]>::try_from(cell).ok().map(|[one]| one))
        .collect::<Option<_>>()?;
    let (name, values) = cells.split_first()?;
    let numbers = values.len() > 1 && values.iter().all(|value| bases(value).is_empty());
    let row = Row { name: name.clone(), values: values.to_vec() };
    (bars > 1 && numbers && Head::of(name).is_some()).then_some(row)
}

/// The values of names in a table of two rows: f(0, 1), f(1, 1) above (0, 2), (3, 6).
pub(super) fn values(
    above: &[Piece],
    below: &[Piece],
    formulas: &BTreeMap<usize, Vec<Expr>>,
) -> Vec<(Expr, Expr)> {
    let cells = |row: &[Piece]| -> Option<Vec<Expr>> {
        let mut found = Vec::new();
        for piece in row {
            match piece {
                Piece::Formula(number) => match formulas.get(number)?.as_slice() {
                    [one] => found.push(one.clone()),
                    _ => return None,
                },
                Piece::Words(words) if words.chars().all(|c| c.is_whitespace() || c == '|') => {}
                Piece::Words(_) => return None,
            }
        }
        (row.len() > found.len()).then_some(found)
    };
    let (Some(names), Some(values)) = (cells(above), cells(below)) else { return Vec::new() };
    let call = |name: &Expr| matches!(name.kind, Kind::Apply(..));
    let given = |value: &Expr| bases(value).is_empty();
    let fits = names.len() > 1 && names.len() == values.len();
    if fits && names.iter().all(call) && values.iter().all(given) {
        names.into_iter().zip(values).collect()
    } else {
        Vec::new()
    }
}

/// Gives a function the data of two rows: the one that names the second row, p(x_i), or the one that was spoken of last.
pub(super) fn tell(xs: &Row, ys: &Row, topic: &[Expr], found: &mut BTreeMap<usize, Vec<Object>>) {
    let own = match (&ys.name.kind, topic) {
        (Kind::Apply(..), _) => named(&ys.name),
        (_, [one]) => one.clone(),
        _ => return,
    };
    if xs.values.len() != ys.values.len() {
        return;
    }
    let function = |object: &&mut Object| {
        matches!(object.sort, Sort::Polynomial | Sort::SplineCurve)
            && object.points.is_empty()
            && object.names.iter().any(|known| known.same_as(&own))
    };
    if let Some(object) = found.values_mut().rev().flat_map(|list| list.iter_mut().rev()).find(function) {
        object.data = xs.values.iter().cloned().zip(ys.values.iter().cloned()).collect();
    }
}
