//! Tables: schemes such as de Casteljau's, and reports with several columns.

use super::Value;
use crate::formula::{Expr, Kind, Rel};

/// One cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// A value.
    Value(Value),
    /// A value under a label such as f(0, t, 1).
    Labelled(Expr, Value),
    /// A formula that shows how a value comes about, such as 1/2 f(0, 0) + 1/2 f(0, 1).
    Formula(Expr),
}

/// Rows of cells under headings.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Table {
    /// One heading for each column; none for a scheme.
    pub header: Vec<Expr>,
    /// The rows; they may have different lengths.
    pub rows: Vec<Vec<Cell>>,
}

impl Cell {
    /// Words.
    pub fn words(words: impl Into<String>) -> Self {
        Cell::Value(Value::Text(words.into()))
    }

    /// What the cell shows, if anything.
    pub fn to_expr(&self) -> Option<Expr> {
        match self {
            Cell::Empty => None,
            Cell::Value(value) => Some(value.to_expr()),
            Cell::Labelled(label, value) => Some(Expr::relation(label.clone(), Rel::Eq, value.to_expr())),
            Cell::Formula(formula) => Some(formula.clone()),
        }
    }
}

impl Table {
    /// A table with headings in words.
    pub fn with_header<'a>(header: impl IntoIterator<Item = &'a str>) -> Self {
        let header = header.into_iter().map(|words| Kind::Text(words.to_owned()).into()).collect();
        Table { header, rows: Vec::new() }
    }

    /// Levels of a scheme side by side, each starting one row lower: row i holds the entries
    /// (0, i), (1, i−1), …, (i, 0).
    pub fn triangle(levels: Vec<Vec<Cell>>) -> Self {
        let height = levels.first().map_or(0, Vec::len);
        let mut rows = vec![Vec::new(); height];
        for (r, level) in levels.into_iter().enumerate() {
            for (i, cell) in level.into_iter().enumerate() {
                rows[i + r].push(cell);
            }
        }
        Table { header: Vec::new(), rows }
    }

    /// The cells as a list of rows, for the language.
    pub fn to_expr(&self) -> Expr {
        let row = |row: &Vec<Cell>| {
            let cells = row.iter().map(|cell| match cell {
                Cell::Labelled(_, value) | Cell::Value(value) => value.to_expr(),
                Cell::Formula(formula) => formula.clone(),
                Cell::Empty => Kind::Text(String::new()).into(),
            });
            Expr::from(Kind::List(cells.collect()))
        };
        Kind::List(self.rows.iter().map(row).collect()).into()
    }
}
