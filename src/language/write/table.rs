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

fn column_widths(table: &Table) -> Vec<f64> {
    let cell = |cell: &Cell| cell.to_expr().map_or(0.0, |expr| measured(&latex(&expr)));
    let header = table.header.iter().map(|expr| measured(&latex(expr))).collect();
    let rows = table.rows.iter().map(|row| row.iter().map(cell).collect::<Vec<f64>>());
    rows.fold(header, |mut widths: Vec<f64>, row| {
        widths.resize(widths.len().max(row.len()), 0.0);
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = width.max(cell);
        }
        widths
    })
}

/// The array with the cells of its widest column broken, if a table with a header fits so.
fn with_broken_column(table: &Table, width: f64) -> Option<String> {
    const LEAST: f64 = 100.0;
    if table.header.is_empty() {
        return None;
    }
    let cell = |cell: &Cell| cell.to_expr().map_or(String::new(), |expr| latex(&expr));
    let mut rows: Vec<Vec<String>> = table.rows.iter().map(|row| row.iter().map(cell).collect()).collect();
    let header: Vec<String> = table.header.iter().map(latex).collect();
    let widths = column_widths(table);
    let widest = (0..widths.len()).max_by(|&a, &b| widths[a].total_cmp(&widths[b]))?;
    let others: f64 = widths.iter().sum::<f64>() - widths[widest] + 10.0 * widths.len() as f64;
    let room = width - others;
    if room < LEAST {
        return None;
    }
    for row in &mut rows {
        if let Some(cell) = row.get_mut(widest).filter(|cell| measured(cell) > room) {
            let lines = lines_of(cell, room).join(" \\\\\n&");
            *cell = format!("\\begin{{aligned}}[t]\n&{lines}\n\\end{{aligned}}");
        }
    }
    let body: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
    let columns = "l".repeat(header.len());
    let (header, body) = (header.join(" & "), body.join(" \\\\\n"));
    Some(format!("\\begin{{array}}{{{columns}}}\n{header} \\\\ \\hline\n{body}\n\\end{{array}}"))
}

/// A table as LaTeX of about this width in points: an array, or if that is much wider, the cells below
/// each other, column by column.
pub fn latex_table_within(table: &Table, width: f64) -> String {
    /// The space between two columns, as it is and at least.
    const SPACE: f64 = 10.0;
    const TIGHT: f64 = 5.0;
    /// What has a header is not taken apart for less.
    const TOLERANCE: f64 = 1.3;
    let array = latex_table(table);
    let widths = column_widths(table);
    let columns = widths.len() as f64;
    let wide = widths.iter().sum::<f64>();
    if wide + SPACE * columns <= width {
        return array;
    }
    if wide + TIGHT * columns <= width {
        let letters = "l".repeat(widths.len());
        let tight = vec!["l"; widths.len()].join("@{\\;}");
        return array.replacen(&format!("{{{letters}}}"), &format!("{{@{{}}{tight}@{{}}}}"), 1);
    }
    if let Some(array) = with_broken_column(table, width) {
        return array;
    }
    if !table.header.is_empty() && wide + SPACE * columns <= TOLERANCE * width {
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
