//! Tables: aligned columns for a terminal, an array for LaTeX, rows for JSON.

use serde_json::{Value as Json, json};

use super::{Format, WriteError, latex, lines_of, measured, split_at_relation, text, value_json, write_expr};
use crate::formula::{Expr, Kind};
use crate::language::value::{Cell, Notation, Table, Value};

/// A table in one of the formats.
///
/// # Errors
/// [`WriteError`] for constructs without meaning in SymPy.
///
/// ```
/// use polarform::value::{Cell, Table, Value};
/// use polarform::write::{Format, write_table};
/// let level = |list: &[i64]| list.iter().map(|&k| Cell::Value(Value::int(k))).collect();
/// let table = Table::triangle(vec![level(&[1, 2]), level(&[3])]);
/// assert_eq!(write_table(&table, Format::Text).unwrap(), "1\n2  3");
/// ```
pub fn write_table(table: &Table, format: Format) -> Result<String, WriteError> {
    match format {
        Format::Latex => Ok(latex_table(table)),
        Format::Json => Ok(table_json(table).to_string()),
        Format::Sympy => write_expr(&table.to_expr(), format),
        Format::Text | Format::Unicode => grid(table, format),
    }
}

fn grid(table: &Table, format: Format) -> Result<String, WriteError> {
    let shown = |expr: &Expr| -> Result<String, WriteError> {
        match &expr.kind {
            Kind::Text(words) => Ok(words.clone()),
            _ => write_expr(expr, format),
        }
    };
    let mut rows: Vec<Vec<String>> = Vec::with_capacity(table.rows.len() + 1);
    if !table.header.is_empty() {
        rows.push(table.header.iter().map(shown).collect::<Result<_, _>>()?);
    }
    for row in &table.rows {
        let cell = |cell: &Cell| cell.to_expr().map_or(Ok(String::new()), |expr| shown(&expr));
        rows.push(row.iter().map(cell).collect::<Result<_, _>>()?);
    }
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |k: usize| rows.iter().filter_map(|row| row.get(k)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|k| width(k).unwrap_or(0)).collect();
    let line = |row: &Vec<String>| {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            line.push_str(cell);
            line.extend(std::iter::repeat_n(' ', width + 2 - cell.chars().count()));
        }
        line.trim_end().to_owned()
    };
    Ok(rows.iter().map(line).collect::<Vec<_>>().join("\n"))
}

/// A table as a LaTeX array, without dollars.
pub fn latex_table(table: &Table) -> String {
    let columns = table.rows.iter().map(Vec::len).chain([table.header.len()]).max().unwrap_or(0);
    let mut out = format!("\\begin{{array}}{{{}}}\n", "l".repeat(columns.max(1)));
    let joined = |cells: Vec<String>| cells.join(" & ");
    if !table.header.is_empty() {
        out.push_str(&joined(table.header.iter().map(latex).collect()));
        out.push_str(" \\\\ \\hline\n");
    }
    let cell = |cell: &Cell| cell.to_expr().map_or(String::new(), |expr| latex(&expr));
    let rows: Vec<String> = table.rows.iter().map(|row| joined(row.iter().map(cell).collect())).collect();
    out.push_str(&rows.join(" \\\\\n"));
    out.push_str("\n\\end{array}");
    out
}

/// A table as LaTeX of about this width in points: an array, or if that is much wider, the cells below
/// each other, column by column.
pub fn latex_table_within(table: &Table, width: f64) -> String {
    /// What is a little too wide can be made smaller.
    const TOLERANCE: f64 = 1.4;
    let array = latex_table(table);
    if measured(&array) <= TOLERANCE * width {
        return array;
    }
    let columns = table.rows.iter().map(Vec::len).max().unwrap_or(0);
    let mut rows = Vec::new();
    for column in 0..columns {
        for cell in table.rows.iter().filter_map(|row| row.get(column)).filter_map(Cell::to_expr) {
            let (left, right) = split_at_relation(&cell);
            let room = width - measured(&left);
            rows.push(format!("{left} &{}", lines_of(&right, room).join(" \\\\\n&")));
        }
    }
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", rows.join(" \\\\\n"))
}

/// A table as rows of cells, each with its label, text and value.
pub fn table_json(table: &Table) -> Json {
    let words = |expr: &Expr| match &expr.kind {
        Kind::Text(words) => words.clone(),
        _ => text(expr),
    };
    let cell = |cell: &Cell| match cell {
        Cell::Empty => Json::Null,
        Cell::Value(Value::Text(words)) => json!(words),
        Cell::Value(value) => value_json(value, Notation::default()),
        Cell::Labelled(label, value) => {
            let mut data = value_json(value, Notation::default());
            data["label"] = json!(text(label));
            data
        }
        Cell::Formula(formula) => json!({"kind": "formula", "text": text(formula), "latex": latex(formula)}),
    };
    json!({
        "kind": "table",
        "header": table.header.iter().map(words).collect::<Vec<_>>(),
        "rows": table.rows.iter().map(|row| row.iter().map(cell).collect::<Vec<_>>()).collect::<Vec<_>>(),
        "latex": latex_table(table),
    })
}
