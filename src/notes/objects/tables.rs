//! Tables of data: a row of arguments above a row of values, members of families with their numbers, points with their
//! coordinates.

use std::collections::BTreeMap;

use super::super::sentence::Piece;
use super::super::speech;
use super::subject::named;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, bases, is_index_letter, walk};
use crate::language::syntax;

/// A cell of a table: its words, and the formulas in it.
#[derive(Clone, Default)]
pub(super) struct Cell {
    words: String,
    formulas: Vec<Expr>,
    /// The number of its first formula on the page.
    number: Option<usize>,
}

impl Cell {
    /// What the cell is, if it is one formula or number and nothing else.
    fn value(&self) -> Option<Expr> {
        match (self.words.trim(), self.formulas.as_slice()) {
            ("", [one]) => Some(one.clone()),
            (words, []) => syntax::parse(words).ok(),
            _ => None,
        }
    }

    fn is_empty(&self) -> bool {
        self.formulas.is_empty() && self.words.trim().is_empty()
    }

    /// The names in the cell, in words or as formulas.
    fn names(&self) -> Vec<Expr> {
        match self.formulas.as_slice() {
            [] => self.words.split_whitespace().filter_map(|word| syntax::parse(word).ok()).collect(),
            formulas => formulas.to_vec(),
        }
    }

    /// Whether its words speak of knots.
    fn is_of_knots(&self) -> bool {
        speech::speaks_of(&self.words, &Sort::Knots)
    }

    /// The number of a coordinate that the cell speaks of: x, x_i, "x of P_i".
    fn axis(&self) -> Option<usize> {
        let names = self.names();
        let axis =
            |name: &Expr| AXES.iter().position(|axis| matches!(&name.kind, Kind::Name(own) if own == axis));
        names.first().and_then(axis).filter(|_| names.len() == 1 || self.family().is_some())
    }

    /// The letter with an index of its own in the cell: u_i.
    fn family(&self) -> Option<Head> {
        let mut heads = self.formulas.iter().filter_map(Head::of);
        heads.find(|head| {
            let index = |index: &Expr| matches!(&index.kind, Kind::Name(letter) if is_index_letter(letter));
            matches!(head.lower.as_slice(), [only] if index(only))
                && head.upper.is_empty()
                && head.arguments.is_none()
        })
    }
}

/// The names of coordinates.
const AXES: [&str; 3] = ["x", "y", "z"];

/// The cells of a piece of a table, without the empty ones before the first bar and after the last.
pub(super) fn cells(pieces: &[Piece], formulas: &BTreeMap<usize, Vec<Expr>>) -> Option<Vec<Cell>> {
    let mut cells = vec![Cell::default()];
    for piece in pieces {
        match piece {
            Piece::Formula(number) => {
                let cell = cells.last_mut()?;
                cell.formulas.extend(formulas.get(number)?.iter().cloned());
                cell.number = cell.number.or(Some(*number));
            }
            Piece::Words(words) => {
                for (at, part) in words.split(['|', '&']).enumerate() {
                    if at > 0 {
                        cells.push(Cell::default());
                    }
                    cells.last_mut()?.words.push_str(part);
                }
            }
        }
    }
    let barred = |cell: Option<&Cell>| cell.is_some_and(Cell::is_empty);
    if barred(cells.first()) && barred(cells.last()) && cells.len() > 2 {
        cells.pop();
        cells.remove(0);
    }
    (cells.len() > 1).then_some(cells)
}

/// What a table says of names, each thing with the formula that it stands at: i | 0 | 1 | 2 above u_i | 0 | 0 | 1, points with
/// their coordinates, by rows or by columns.
pub(super) fn data(rows: &[Vec<Cell>], formulas: &BTreeMap<usize, Vec<Expr>>) -> Vec<(usize, Object)> {
    if let Some(net) = net(rows, formulas) {
        return vec![net];
    }
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let turned: Vec<Vec<Cell>> = (0..width)
        .map(|at| rows.iter().map(|row| row.get(at).cloned().unwrap_or_default()).collect())
        .collect();
    let found = by_rows(rows);
    if found.is_empty() { by_rows(&turned) } else { found }
}

/// Keeps what a table says; points belong to the curve that was spoken of last.
pub(super) fn put(data: Vec<(usize, Object)>, topic: &[Expr], found: &mut BTreeMap<usize, Vec<Object>>) {
    for (number, object) in data {
        let curve = |other: &&mut Object| {
            matches!(other.sort, Sort::SplineCurve | Sort::BezierCurve)
                && other.points.is_empty()
                && matches!((topic, other.names.as_slice()), ([one], [own]) if one.same_as(own))
        };
        if object.sort == Sort::ControlPoints
            && let Some(curve) = found.values_mut().rev().flat_map(|list| list.iter_mut().rev()).find(curve)
        {
            curve.points = object.names.clone();
        }
        found.entry(number).or_default().push(object);
    }
}

/// The number of a row or column: 2 of "i = 2".
fn label(cell: &Cell) -> Option<(String, i64)> {
    let Kind::Chain(left, links) = &cell.value()?.kind else { return None };
    match (&left.kind, links.as_slice()) {
        (Kind::Name(letter), [link]) if link.rel == Rel::Eq && is_index_letter(letter) => {
            Some((letter.clone(), link.expr.as_int()?))
        }
        _ => None,
    }
}

/// A net of points: rows "i = 0", "i = 1" and columns "j = 0", "j = 1" of the b_{i,j} that were spoken of before.
fn net(rows: &[Vec<Cell>], formulas: &BTreeMap<usize, Vec<Expr>>) -> Option<(usize, Object)> {
    let ([head, rest @ ..], place) = (rows, rows.iter().flatten().find_map(|cell| cell.number)?) else {
        return None;
    };
    let columns: Vec<(String, i64)> = head.get(1..)?.iter().map(label).collect::<Option<_>>()?;
    let lines: Vec<(String, i64)> = rest.iter().map(|row| label(row.first()?)).collect::<Option<_>>()?;
    let (column, line) = (&columns.first()?.0, &lines.first()?.0);
    let mut letter = None;
    for said in formulas.range(..place).flat_map(|(_, said)| said) {
        walk(said, &mut |part| {
            let named = |index: &Expr, name: &String| matches!(&index.kind, Kind::Name(own) if own == name);
            if let Some(own) = Head::of(part)
                && let [one, other] = own.lower.as_slice()
                && named(one, line)
                && named(other, column)
                && own.arguments.is_none()
            {
                letter = Some(own.base);
            }
        });
    }
    let letter = letter?;
    let (mut names, mut values) = (Vec::new(), Vec::new());
    for (row, (_, i)) in rest.iter().zip(&lines) {
        for (cell, (_, j)) in row[1..].iter().zip(&columns) {
            names.push(
                Kind::Subscript(Box::new(Expr::name(&letter)), vec![Expr::int(*i), Expr::int(*j)]).into(),
            );
            values.push(given(cell.value()?)?);
        }
    }
    (!names.is_empty()).then(|| (place, Object { names, values, ..Object::new(Sort::Symbols) }))
}

fn by_rows(rows: &[Vec<Cell>]) -> Vec<(usize, Object)> {
    let [head, rest @ ..] = rows else { return Vec::new() };
    let Some((corner, heads)) = head.split_first() else { return Vec::new() };
    let index = |expr: &Expr| matches!(&expr.kind, Kind::Name(letter) if is_index_letter(letter));
    let counts = corner.is_empty() || corner.value().is_some_and(|own| index(&own));
    let heads: Vec<Expr> = heads.iter().map_while(Cell::value).collect();
    let members: Vec<Head> = heads.iter().map_while(Head::of).collect();
    let whole = |numbers: &[i64]| numbers.len() > 1 && numbers.windows(2).all(|pair| pair[1] == pair[0] + 1);
    let numbers: Vec<i64> = heads.iter().map_while(Expr::as_int).collect();
    let indices: Vec<i64> = members.iter().filter_map(|head| head.index()?.as_int()).collect();
    let same = members.iter().all(|head| head.base == members[0].base && head.upper.is_empty());
    let named = indices.len() == heads.len() && same && whole(&indices);
    let numbered = counts && numbers.len() == heads.len() && whole(&numbers);
    let place = rows.iter().flatten().find_map(|cell| cell.number);
    let (Some(place), true) = (place, named || numbered) else { return Vec::new() };
    let first = if named { indices[0] } else { numbers[0] };
    // The values of a row, as far as they go
    let mut families: Vec<(String, Vec<Vec<Expr>>, Sort)> = Vec::new();
    for row in rest {
        let Some((label, values)) = row.split_first() else { continue };
        let values: Vec<Expr> =
            values.iter().take(heads.len()).map_while(|cell| given(cell.value()?)).collect();
        let own = label.family().map(|head| head.base).or_else(|| {
            let alone = rest.len() == 1 || label.axis().is_some();
            (named && alone).then(|| members[0].base.clone())
        });
        let Some(own) = own.filter(|_| !values.is_empty()) else { continue };
        let sort = if label.is_of_knots() { Sort::Knots } else { Sort::Symbols };
        match (label.axis(), families.iter_mut().find(|(letter, ..)| *letter == own)) {
            (Some(axis), Some((_, rows, _))) if axis == rows.len() => rows.push(values),
            (None | Some(0), None) => families.push((own, vec![values], sort)),
            _ => return Vec::new(),
        }
    }
    let object = |(letter, rows, mut sort): (String, Vec<Vec<Expr>>, Sort)| {
        let count = rows.iter().map(Vec::len).min().unwrap_or(0);
        if rows.len() > 1 {
            sort = Sort::ControlPoints;
        }
        let value = |at: usize| match rows.as_slice() {
            [only] => only[at].clone(),
            rows => Kind::Tuple(rows.iter().map(|row| row[at].clone()).collect()).into(),
        };
        let names = (first..).take(count).map(|number| Expr::indexed(&letter, number)).collect();
        Object { names, values: (0..count).map(value).collect(), ..Object::new(sort) }
    };
    families.into_iter().map(|family| (place, object(family))).collect()
}

/// A value without names.
fn given(value: Expr) -> Option<Expr> {
    bases(&value).is_empty().then_some(value)
}

/// A row of a table: its name and the numbers after it.
pub(super) struct Row {
    name: Expr,
    values: Vec<Expr>,
}

/// The row that a piece of a table is: x_i | 0 | 1 | 3.
pub(super) fn row(cells: &[Cell]) -> Option<Row> {
    let cells = cells.iter().filter(|cell| !cell.is_empty());
    let cells: Vec<Expr> = cells.map(Cell::value).collect::<Option<_>>()?;
    let (name, values) = cells.split_first()?;
    let numbers = values.len() > 1 && values.iter().all(|value| bases(value).is_empty());
    let row = Row { name: name.clone(), values: values.to_vec() };
    (numbers && Head::of(name).is_some()).then_some(row)
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
