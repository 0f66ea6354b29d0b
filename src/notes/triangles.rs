//! Tables of numbers in the shape of a triangle: the schemes of de Casteljau, Neville and Newton.
//!
//! **Definition.** A *triangle* has columns (or rows) of m, m − 1, m − 2, … cells with numbers or points, wherever in
//! their column they stand: from the top, from the bottom, or half a row lower in each column. What is empty, and the
//! names at the head and at the side, are none of its cells. A column of m numbers before the first one holds the nodes.

use crate::document::Document;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::judge::page::statement::{Side, Triangle};
use crate::judge::written::names::bases;
use crate::language::{latex, syntax};

type Cell = Option<Side>;

/// The rows of a table that is being read.
#[derive(Default)]
pub(super) struct Table {
    rows: Vec<Vec<Cell>>,
    inside: bool,
    /// The number of the first statement in it.
    pub first: usize,
}

impl Table {
    /// A row begins, after so many statements.
    pub(super) fn begin_row(&mut self, statements: usize) {
        if self.rows.is_empty() {
            self.first = statements;
        }
        self.rows.push(vec![None]);
        self.inside = true;
    }

    pub(super) fn end_row(&mut self) {
        self.inside = false;
    }

    /// Whether what comes now stands in a row.
    pub(super) fn is_inside(&self) -> bool {
        self.inside
    }

    /// What stands between the formulas of a row: the ends of cells, and numbers that are set as words.
    pub(super) fn words(&mut self, document: &Document, span: Span) {
        let Some(row) = self.rows.last_mut() else { return };
        let text = document.file.slice(span);
        let mut at = span.start;
        for (number, cell) in text.split(['|', '&']).enumerate() {
            if number > 0 {
                row.push(None);
            }
            let inner = cell.trim_matches(|c: char| c.is_whitespace() || matches!(c, '*' | '_' | '\\'));
            if !inner.is_empty() {
                let start = at + (inner.as_ptr() as usize - cell.as_ptr() as usize);
                let read = syntax::parse(inner).ok().or_else(|| latex::read(inner).ok());
                let side = read.map(|expr| moved(expr, start, inner));
                if let Some(last) = row.last_mut() {
                    *last = side.filter(|_| last.is_none());
                }
            }
            at += cell.len() + 1;
        }
    }

    /// A formula in a row.
    pub(super) fn formula(&mut self, side: Option<&Side>) {
        if let Some(last) = self.rows.last_mut().and_then(|row| row.last_mut()) {
            *last = side.filter(|_| last.is_none()).cloned();
        }
    }

    /// The triangles that the table can be read as. The next row begins a new table.
    pub(super) fn finish(&mut self) -> Vec<Triangle> {
        triangles(&std::mem::take(&mut self.rows))
    }
}

/// A formula that stands at a place of the file.
fn moved(mut expr: Expr, start: usize, text: &str) -> Side {
    expr.map_spans(&|span| Span::new(span.start + start, span.end + start));
    Side { expr, latex: text.to_owned() }
}

/// The triangles that a matrix in a formula can be read as.
pub(super) fn in_matrix(expr: &Expr, latex: &dyn Fn(Span) -> String) -> Vec<Triangle> {
    let Kind::Matrix(rows, _) = &expr.kind else { return Vec::new() };
    let side = |cell: &Expr| Side { expr: cell.clone(), latex: latex(cell.span) };
    let row = |row: &Vec<Option<Expr>>| row.iter().map(|cell| cell.as_ref().map(side)).collect();
    triangles(&rows.iter().map(row).collect::<Vec<_>>())
}

fn triangles(rows: &[Vec<Cell>]) -> Vec<Triangle> {
    // x | f | 1. | 2.: the numbers at the head of columns are none of the scheme.
    let rows = match rows.split_first() {
        Some((head, rest)) if head.iter().flatten().filter(|side| !is_data(side)).count() > 1 => rest,
        _ => rows,
    };
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let data = |side: Side| is_data(&side).then_some(side);
    let column = |at: usize| rows.iter().filter_map(|row| data(row.get(at)?.clone()?)).collect();
    // The number of a level may stand before it.
    let line = |from: usize| {
        move |row: &Vec<Cell>| {
            row.iter().flatten().cloned().filter_map(data).skip(from).collect::<Vec<Side>>()
        }
    };
    let lines: Vec<Vec<Side>> = rows.iter().map(line(0)).collect();
    let numbered = are_numbers_of_levels(&lines);
    let readings = [
        Some((0..width).map(column).collect()),
        Some(lines),
        numbered.then(|| rows.iter().map(line(1)).collect()),
    ];
    readings.into_iter().flatten().filter_map(decreasing).collect()
}

/// Whether the lines begin with numbers that count them: 0, 1, 2.
fn are_numbers_of_levels(lines: &[Vec<Side>]) -> bool {
    let firsts = lines.iter().filter_map(|line| line.first());
    let numbers: Option<Vec<i64>> = firsts.map(|side| side.expr.as_int()).collect();
    numbers.is_some_and(|numbers| numbers.windows(2).all(|pair| pair[1] == pair[0] + 1))
}

/// A number or a point.
fn is_data(side: &Side) -> bool {
    let named = !bases(&side.expr).is_empty() || matches!(side.expr.kind, Kind::Text(_) | Kind::Chain(..));
    !named && !side.is_unread()
}

/// The last lines whose lengths are m, m − 1, …, with those of length m before them.
fn decreasing(mut lines: Vec<Vec<Side>>) -> Option<Triangle> {
    lines.retain(|line| !line.is_empty());
    let mut first = lines.len().checked_sub(1)?;
    while first > 0 && lines[first - 1].len() == lines[first].len() + 1 {
        first -= 1;
    }
    let columns = lines.split_off(first);
    let nodes = lines.pop().filter(|nodes| nodes.len() == columns[0].len());
    (columns.len() > 2).then_some(Triangle { nodes, columns })
}
