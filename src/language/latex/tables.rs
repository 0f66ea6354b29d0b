//! Environments: matrices, cases, rows of formulas.

use super::reader::{Reader, Result, Window, continues, waits};
use super::token::{Env, Tok};
use crate::formula::{Delimiter, Expr, Kind, Rel};

impl Reader<'_> {
    /// The environment that begins at `at` and has its content in `window`.
    pub fn environment(&mut self, env: Env, window: Window, at: usize) -> Result<Expr> {
        let span = self.span_at(at).to(self.span_at(window.end));
        let kind = match env {
            Env::Matrix(delimiter) => Kind::Matrix(self.matrix_rows(window)?, delimiter),
            Env::Array if !self.has_relation(window.clone()) => {
                Kind::Matrix(self.matrix_rows(window)?, Delimiter::None)
            }
            Env::Array => self.display(window, true)?.kind,
            Env::Cases => self.cases(window)?.kind,
            Env::Rows => self.display(window, false)?.kind,
        };
        Ok(Expr::new(kind, span))
    }

    /// Rows of cells; rows without any content are layout.
    fn cells(&self, window: Window) -> Vec<Vec<Window>> {
        self.split(window, |kind| kind == Tok::RowBreak)
            .into_iter()
            .map(|row| self.split(row, |kind| kind == Tok::Align))
            .filter(|cells| cells.len() > 1 || cells.iter().any(|cell| !self.is_blank(cell.clone())))
            .collect()
    }

    /// The entries of a matrix.
    pub fn matrix_rows(&mut self, window: Window) -> Result<Vec<Vec<Option<Expr>>>> {
        let mut rows = Vec::new();
        for cells in self.cells(window) {
            let mut row = Vec::with_capacity(cells.len());
            for cell in cells {
                row.push(if self.is_blank(cell.clone()) { None } else { Some(self.row_in(cell)?) });
            }
            rows.push(row);
        }
        Ok(rows)
    }

    /// Whether a relation stands in the window, not inside further brackets.
    pub fn has_relation(&self, window: Window) -> bool {
        let mut at = window.start;
        while at < window.end {
            if matches!(self.tokens[at].kind, Tok::Rel(_)) {
                return true;
            }
            at = self.after(at);
        }
        false
    }

    /// Whether the rows of `cases` are equations rather than values with conditions.
    pub fn is_system(&self, window: Window) -> bool {
        let rows = self.cells(window);
        !rows.is_empty()
            && rows.iter().all(|cells| {
                let mut filled = cells.iter().filter(|cell| !self.is_blank((*cell).clone()));
                match (filled.next(), filled.next()) {
                    (Some(cell), None) => self
                        .split(cell.clone(), |kind| matches!(kind, Tok::Comma | Tok::Gap))
                        .first()
                        .is_some_and(|part| self.has_relation(part.clone())),
                    // aligned equations: the second cell goes on with the relation
                    (Some(_), Some(cell)) => {
                        let cell = self.trim(cell.clone());
                        matches!(self.tokens.get(cell.start).map(|token| token.kind), Some(Tok::Rel(_)))
                    }
                    _ => false,
                }
            })
    }

    /// Values with conditions; a system of equations becomes a sequence.
    pub fn cases(&mut self, window: Window) -> Result<Expr> {
        let span = self.span_of(window.clone());
        if self.is_system(window.clone()) {
            return self.display(window, false);
        }
        let mut cases = Vec::new();
        let mut rows = self.cells(window);
        // In `& 1 && \text{if } …` nothing stands before the first sign.
        let blank_first = |row: &Vec<Window>| row.len() > 1 && self.is_blank(row[0].clone());
        if rows.iter().all(blank_first) {
            for row in &mut rows {
                row.remove(0);
            }
        }
        for cells in rows {
            let (Some(first), Some(last)) = (cells.first().cloned(), cells.last().cloned()) else { continue };
            let (value, condition) = if cells.len() > 1 {
                (first.clone(), first.end + 1..last.end)
            } else {
                self.value_and_condition(first)
            };
            let value = trailing_words_removed(self.row_in(value)?);
            let condition =
                if self.is_blank(condition.clone()) { None } else { condition_of(self.row_in(condition)?) };
            cases.push((value, condition));
        }
        if cases.is_empty() {
            return self.stuck();
        }
        Ok(Expr::new(Kind::Cases(cases), span))
    }

    /// Without `&`, the first comma or wide space ends the value.
    fn value_and_condition(&self, row: Window) -> (Window, Window) {
        let parts = self.split(row.clone(), |kind| matches!(kind, Tok::Comma | Tok::Gap | Tok::Text(..)));
        match parts.first() {
            Some(value)
                if parts.len() > 1 && !self.is_blank(value.clone()) && !self.has_relation(value.clone()) =>
            {
                let words = matches!(self.tokens[value.end].kind, Tok::Text(..));
                (value.clone(), value.end + usize::from(!words)..row.end)
            }
            _ => (row.clone(), row.end..row.end),
        }
    }

    /// Rows of formulas. A row that begins with a relation goes on with the row above. In an
    /// array (`columns`) every `&` may separate formulas.
    pub fn display(&mut self, window: Window, columns: bool) -> Result<Expr> {
        let span = self.span_of(window.clone());
        let mut formulas = Vec::new();
        for row in self.formulas(window, true) {
            formulas.push(self.whole_row(row, false, columns)?);
        }
        match formulas.len() {
            0 => self.stuck(),
            1 => Ok(formulas.remove(0)),
            _ => Ok(Expr::new(Kind::Sequence(formulas), span)),
        }
    }

    /// Whether nothing stands before the first `&` of a row; `None` if there is none, or no relation after it.
    fn begins_blank(&self, row: Window) -> Option<bool> {
        let column = row.clone().find(|&at| self.tokens[at].kind == Tok::Align)?;
        if self.trim(row.start..column).is_empty() {
            return Some(true);
        }
        let after = self.trim(column + 1..row.end);
        after.clone().next().filter(|&at| matches!(self.tokens[at].kind, Tok::Rel(_))).map(|_| false)
    }

    /// The formulas of a window: its rows, joined where one goes on with another. Rows that begin
    /// with a relation are joined only if `relations`.
    pub fn formulas(&self, window: Window, relations: bool) -> Vec<Window> {
        let mut formulas: Vec<Window> = Vec::new();
        // Whether a row above stands on both sides of its `&`, with a relation after it.
        let mut aligned = false;
        for row in self.split(window, |kind| kind == Tok::RowBreak) {
            let blank = self.begins_blank(row.clone());
            let trimmed = self.trim(row);
            let Some(first) = trimmed.clone().next().map(|at| self.tokens[at].kind) else { continue };
            let goes_on = match first {
                Tok::Rel(Rel::Colon) => false,
                Tok::Rel(Rel::Lt) if self.angle_end(trimmed.start).is_some() => false,
                Tok::Rel(_) | Tok::Command(super::commands::Role::Stacked) => relations,
                // `- t = …` is a formula of its own, `- t` the rest of one
                Tok::Plus | Tok::Minus => {
                    !self.has_relation(trimmed.clone()) || aligned && blank == Some(true)
                }
                // `= (a + b)`, and below it `(a - b)`
                kind => {
                    continues(kind) || aligned && blank == Some(true) && !self.has_relation(trimmed.clone())
                }
            };
            aligned |= blank == Some(false);
            match formulas.last_mut() {
                Some(above) if goes_on || waits(self.tokens[above.end - 1].kind) => above.end = trimmed.end,
                _ => formulas.push(trimmed),
            }
        }
        formulas
    }
}

const OTHERWISE: &[&str] =
    &["otherwise", "else", "other", "others", "elsewhere", "sonst", "否则", "其他", "其它"];

/// A condition without the word "if" before it; `None` for "otherwise".
fn condition_of(expr: Expr) -> Option<Expr> {
    let is_otherwise =
        |text: &str| OTHERWISE.contains(&text.trim_matches(['.', ',', ' ']).to_ascii_lowercase().as_str());
    match expr.kind {
        Kind::Text(ref text) if is_otherwise(text) => None,
        Kind::Sequence(mut items) if matches!(items.first(), Some(Expr { kind: Kind::Text(_), .. })) => {
            items.remove(0);
            match items.len() {
                0 => None,
                1 => items.pop(),
                _ => Some(Expr { kind: Kind::Sequence(items), span: expr.span }),
            }
        }
        _ => Some(expr),
    }
}

/// A value without the word "if" after it.
fn trailing_words_removed(expr: Expr) -> Expr {
    match expr.kind {
        Kind::Sequence(mut items)
            if items.len() == 2 && matches!(items.last(), Some(Expr { kind: Kind::Text(_), .. })) =>
        {
            items.swap_remove(0)
        }
        _ => expr,
    }
}
