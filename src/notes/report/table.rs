//! The numbers at the end of a report.

use comfy_table::{CellAlignment, Table, presets};

use super::terminal::{BOLD, painted};
use super::{CLAIMS, Tally, further_words, verdict_words};
use crate::judge::page::finding::FileReport;
use crate::language::diagnostic::harmless;

/// How many claims got which verdict, and what else there is; for several files with a table.
pub fn render_summary(reports: &[FileReport], color: bool) -> String {
    let tally = Tally::of(reports);
    let further = further_words(&tally).join(", ");
    let (mut out, indent) = match reports {
        [] => return String::new(),
        [one] => {
            let line = format!("{}: {}", harmless(one.file.name()), verdict_words(&tally));
            (format!("{}\n", painted(&line, BOLD, color)), "  ")
        }
        _ => (table(reports, &tally), ""),
    };
    if !further.is_empty() {
        out.push_str(&format!("{indent}{further}\n"));
    }
    out
}

fn table(reports: &[FileReport], total: &Tally) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    let heads = ["file", "claims"].into_iter().chain(CLAIMS.map(|verdict| verdict.word()));
    table.set_header(heads.chain(["definitions"]));
    for report in reports {
        let tally = Tally::of(std::slice::from_ref(report));
        table.add_row(row(harmless(report.file.name()), &tally));
    }
    table.add_row(row("total".to_owned(), total));
    for column in table.column_iter_mut() {
        column.set_padding((0, 2));
        if column.index > 0 {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

fn row(name: String, tally: &Tally) -> Vec<String> {
    let mut cells = vec![name, tally.claims().to_string()];
    cells.extend(CLAIMS.map(|verdict| tally.count(verdict).to_string()));
    cells.push(tally.definitions().to_string());
    cells
}
