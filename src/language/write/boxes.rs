//! Matrices over several lines, for a terminal.

use super::unicode::relation;
use crate::formula::{Delimiter, Expr, Kind, Precedence};

/// A larger picture is not drawn.
const MAX_CHARACTERS: usize = 1 << 20;

/// Lines of equal width.
struct Picture {
    lines: Vec<String>,
    width: usize,
}

/// A matrix, or a chain of relations with one as a side, drawn over several lines; `None` for
/// everything else. `one_line` prints what stands beside matrices and in their cells.
///
/// ```text
///     ⎛ 1  0 ⎞
/// A = ⎝ 0  1 ⎠
/// ```
pub(super) fn layout(expr: &Expr, one_line: fn(&Expr) -> String) -> Option<String> {
    let pictures = match &expr.kind {
        Kind::Matrix(..) => vec![picture(expr, one_line)?],
        Kind::Chain(first, links) => {
            let is_matrix = |expr: &Expr| matches!(expr.kind, Kind::Matrix(..));
            if !is_matrix(first) && !links.iter().any(|link| is_matrix(&link.expr)) {
                return None;
            }
            let mut pictures = vec![picture(first, one_line)?];
            for link in links {
                pictures.push(line(relation(link.rel).to_owned()));
                pictures.push(picture(&link.expr, one_line)?);
            }
            pictures
        }
        _ => return None,
    };
    let height = pictures.iter().map(|picture| picture.lines.len()).max()?;
    let width: usize = pictures.iter().map(|picture| picture.width).sum();
    if height < 2 || width.saturating_mul(height) > MAX_CHARACTERS {
        return None;
    }
    let mut text = String::new();
    for row in 0..height {
        let start = text.len();
        for picture in &pictures {
            let above = (height - picture.lines.len()) / 2;
            match row.checked_sub(above).and_then(|row| picture.lines.get(row)) {
                Some(line) => text.push_str(line),
                None => text.extend(std::iter::repeat_n(' ', picture.width)),
            }
        }
        text.truncate(start + text[start..].trim_end().len());
        if row + 1 < height {
            text.push('\n');
        }
    }
    Some(text)
}

fn line(text: String) -> Picture {
    let width = width(&text);
    Picture { lines: vec![text], width }
}

/// A side of a relation.
fn picture(expr: &Expr, one_line: fn(&Expr) -> String) -> Option<Picture> {
    match &expr.kind {
        Kind::Matrix(rows, delimiter) => matrix(rows, *delimiter, one_line),
        _ if expr.precedence() < Precedence::Lambda => Some(line(format!("({})", one_line(expr)))),
        _ => Some(line(one_line(expr))),
    }
}

/// `None` for a matrix without rows or one that is too large.
fn matrix(
    rows: &[Vec<Option<Expr>>],
    delimiter: Delimiter,
    one_line: fn(&Expr) -> String,
) -> Option<Picture> {
    let columns = rows.iter().map(Vec::len).max()?;
    if rows.len().saturating_mul(columns) > MAX_CHARACTERS {
        return None;
    }
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().map(|cell| cell.as_ref().map_or(String::new(), one_line)).collect())
        .collect();
    let mut widths = vec![0; columns];
    for row in &cells {
        for (cell, widest) in row.iter().zip(&mut widths) {
            *widest = width(cell).max(*widest);
        }
    }
    let total = widths.iter().sum::<usize>() + 2 * columns + 2;
    if total.saturating_mul(rows.len()) > MAX_CHARACTERS {
        return None;
    }
    let mut lines = Vec::with_capacity(rows.len());
    for (i, row) in cells.iter().enumerate() {
        let (open, close) = brackets(delimiter, i, rows.len());
        let mut line = format!("{open} ");
        for (j, &widest) in widths.iter().enumerate() {
            let cell = row.get(j).map_or("", String::as_str);
            let missing = widest - width(cell);
            let before = if j > 0 { 2 } else { 0 } + missing / 2;
            line.extend(std::iter::repeat_n(' ', before));
            line.push_str(cell);
            line.extend(std::iter::repeat_n(' ', missing - missing / 2));
        }
        line.push(' ');
        line.push_str(close);
        lines.push(line);
    }
    let width = lines.first().map_or(0, |line| width(line));
    Some(Picture { lines, width })
}

/// The pieces of the brackets beside row `row` of `rows`.
fn brackets(delimiter: Delimiter, row: usize, rows: usize) -> (&'static str, &'static str) {
    let place = match (row, rows) {
        (_, 1) => 0,
        (0, _) => 1,
        (row, rows) if row + 1 == rows => 3,
        _ => 2,
    };
    match delimiter {
        Delimiter::Paren => [("(", ")"), ("⎛", "⎞"), ("⎜", "⎟"), ("⎝", "⎠")][place],
        Delimiter::Bracket => [("[", "]"), ("⎡", "⎤"), ("⎢", "⎥"), ("⎣", "⎦")][place],
        Delimiter::Bar => ("│", "│"),
        Delimiter::None => ("", ""),
    }
}

/// Columns that a text takes on a terminal; combining accents take none.
fn width(text: &str) -> usize {
    text.chars().filter(|c| !matches!(c, '\u{300}'..='\u{36f}' | '\u{20d0}'..='\u{20ff}')).count()
}
