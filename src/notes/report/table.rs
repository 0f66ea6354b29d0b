//! The numbers at the end of a report.

use comfy_table::{CellAlignment, Table, presets};

use super::terminal::{BOLD, painted, plain};
use super::{Tally, counted};
use crate::judge::finding::{FileReport, Verdict};

/// Verdicts in the order in which a person asks for them.
const ORDER: [Verdict; 6] = [
    Verdict::Refuted,
    Verdict::Proved,
    Verdict::Sampled,
    Verdict::Definition,
    Verdict::Undecided,
    Verdict::Unread,
];

/// How many statements got which verdict, for one file in words, for several as a table.
pub fn render_summary(reports: &[FileReport], color: bool) -> String {
    let tally = Tally::of(reports);
    let mut out = match reports {
        [] => return String::new(),
        [one] => {
            format!("{}\n", painted(&format!("{}: {}", plain(one.file.name()), share(&tally)), BOLD, color))
        }
        _ => table(reports, &tally),
    };
    if reports.len() == 1 && tally.statements() > 0 {
        let parts: Vec<String> = ORDER
            .into_iter()
            .filter(|&verdict| tally.count(verdict) > 0)
            .map(|verdict| format!("{} {}", tally.count(verdict), plural(verdict, tally.count(verdict))))
            .collect();
        out.push_str(&format!("  {}\n", parts.join(", ")));
    }
    let mut rest = Vec::new();
    if tally.warnings() > 0 {
        rest.push(counted(tally.warnings(), "warning", "warnings"));
    }
    if tally.silent() > 0 {
        rest.push(counted(tally.silent(), "formula without a statement", "formulas without a statement"));
    }
    if tally.problems() > 0 {
        rest.push(counted(
            tally.problems(),
            "problem with the file itself",
            "problems with the files themselves",
        ));
    }
    if !rest.is_empty() {
        let indent = if reports.len() == 1 { "  " } else { "" };
        out.push_str(&format!("{indent}{}\n", rest.join(", ")));
    }
    out
}

fn share(tally: &Tally) -> String {
    match tally.percent_judged() {
        None if tally.problems() > 0 => "nothing could be read".to_owned(),
        None => "nothing to judge".to_owned(),
        Some(percent) => {
            let statements = counted(tally.statements(), "statement", "statements");
            format!("{statements}, {} judged ({percent}%)", tally.judged())
        }
    }
}

fn plural(verdict: Verdict, count: usize) -> &'static str {
    match verdict {
        Verdict::Definition if count != 1 => "definitions",
        _ => verdict.word(),
    }
}

fn table(reports: &[FileReport], total: &Tally) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    let heads = ["file", "statements"]
        .into_iter()
        .chain(ORDER.into_iter().map(|verdict| plural(verdict, 2)))
        .chain(["judged"]);
    table.set_header(heads);
    for report in reports {
        let tally = Tally::of(std::slice::from_ref(report));
        table.add_row(row(plain(report.file.name()), &tally));
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
    let mut cells = vec![name, tally.statements().to_string()];
    cells.extend(ORDER.into_iter().map(|verdict| tally.count(verdict).to_string()));
    cells.push(tally.percent_judged().map_or("-".to_owned(), |percent| format!("{percent}%")));
    cells
}
