//! Pieces as Markdown and as LaTeX.

use super::options::{BlockOptions, Style};
use super::render::{Picture, Piece, Shown, StepLine, escaped, words_as_text, words_in_formula};
use crate::language::value::Verdict;
use crate::language::write::{Breaks, lines_of, measured};

/// What a document is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Markup {
    Markdown,
    Latex,
}

impl Markup {
    /// A result within a line; `bare` inside a formula, where signs around it would be wrong.
    pub(super) fn inline(self, piece: &Piece, bare: bool) -> String {
        let formula = match piece {
            Piece::Formula(shown) => with_remark(shown),
            Piece::Words(words) if bare => words_in_formula(words),
            Piece::Words(words) if self == Markup::Markdown => return words.clone(),
            Piece::Words(words) => return escaped(words),
            Piece::Steps(lines) => aligned(lines).join(" "),
            Piece::Picture(picture) => return self.picture(picture).join(" "),
        };
        if bare { formula } else { format!("${formula}$") }
    }

    /// The lines that show the results of a block.
    pub(super) fn block(self, pieces: &[Piece], options: &BlockOptions) -> Vec<String> {
        match (options.style, self) {
            _ if pieces.is_empty() => Vec::new(),
            (Style::Display, _) => {
                // A blank line stands between two results of Markdown; TeX would begin a paragraph there.
                let between: &[String] = if self == Markup::Markdown { &[String::new()] } else { &[] };
                pieces
                    .iter()
                    .map(|piece| self.display(piece, options.room(), options.breaks))
                    .collect::<Vec<_>>()
                    .join(between)
            }
            (Style::Inline, _) => {
                let parts: Vec<String> = pieces.iter().map(|piece| self.inline(piece, false)).collect();
                vec![parts.join(", ")]
            }
            (Style::List, Markup::Markdown) => {
                self.items(pieces).into_iter().map(|item| format!("- {item}")).collect()
            }
            (Style::List, Markup::Latex) => {
                // A bracket right after \item would be its label.
                let items = self.items(pieces).into_iter().map(|item| format!("\\item {{}}{item}"));
                enclosed("itemize", "", items)
            }
            (Style::Table, _) => self.table(pieces),
            (Style::Code, _) => self.code(pieces),
        }
    }

    /// A display of its own; a formula that is wider than `room` is broken, and what cannot be broken is
    /// made smaller where that is possible.
    fn display(self, piece: &Piece, room: f64, breaks: Breaks) -> Vec<String> {
        // Renderers of Markdown know aligned only.
        let breaks = if self == Markup::Latex { breaks } else { Breaks::Aligned };
        let lines = match piece {
            Piece::Words(words) => return vec![self.words(words)],
            Piece::Formula(shown) => {
                let whole = with_remark(shown);
                let formula = breaks.broken(&whole, room);
                // A display of its own, whose lines TeX makes.
                if breaks == Breaks::Dmath && formula != whole {
                    return formula.lines().map(str::to_owned).collect();
                }
                // The width of a line is an estimate.
                let too_wide = |line: &str| measured(&line.replace('&', "")) > 1.1 * room;
                let unbroken = formula == whole && !whole.starts_with(r"\begin{aligned}");
                let fails = if unbroken { measured(&whole) > room } else { formula.lines().any(too_wide) };
                if self == Markup::Latex && fails {
                    return reduced(&whole);
                }
                formula.lines().map(str::to_owned).collect()
            }
            Piece::Steps(lines) if self == Markup::Latex && is_wide(lines) => return over_pages(lines, room),
            Piece::Steps(lines) => aligned(lines),
            Piece::Picture(picture) => return self.picture(picture),
        };
        let (open, close) = match self {
            Markup::Markdown => ("$$", "$$"),
            Markup::Latex => (r"\[", r"\]"),
        };
        [vec![open.to_owned()], lines, vec![close.to_owned()]].concat()
    }

    fn picture(self, picture: &Picture) -> Vec<String> {
        match (self, &picture.file) {
            (Markup::Latex, _) => {
                // No wider than the text; tikz brings graphicx.
                let fit = r"\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{%";
                let drawn = picture.tikz.lines().map(str::to_owned);
                let lines = std::iter::once(fit.to_owned()).chain(drawn).chain(["}".to_owned()]);
                enclosed("center", "", lines)
            }
            (Markup::Markdown, Some(file)) => {
                let title = picture.title.replace(['[', ']', '\\'], " ");
                vec![format!("![{title}]({file})")]
            }
            // A blank line would end the picture.
            (Markup::Markdown, None) => {
                picture.svg.lines().filter(|line| !line.trim().is_empty()).map(str::to_owned).collect()
            }
        }
    }

    fn words(self, words: &str) -> String {
        match self {
            Markup::Markdown => words.to_owned(),
            Markup::Latex => escaped(words),
        }
    }

    /// Words with formulas between backticks.
    fn reason(self, reason: &str) -> String {
        match self {
            // Dollars are no trouble outside of formulas.
            Markup::Markdown => {
                crate::language::write::write_words(reason, crate::language::write::Format::Latex)
            }
            Markup::Latex => {
                let pieces = reason.split('`').enumerate().map(|(i, piece)| {
                    match crate::language::syntax::parse(piece) {
                        Ok(formula) if i % 2 == 1 => format!("${}$", crate::language::write::latex(&formula)),
                        _ => escaped(piece),
                    }
                });
                pieces.collect()
            }
        }
    }

    /// One for each result, or for each line of a derivation.
    fn items(self, pieces: &[Piece]) -> Vec<String> {
        let mut items = Vec::new();
        for piece in pieces {
            match piece {
                Piece::Steps(lines) => items.extend(
                    lines
                        .iter()
                        .map(|line| format!("{}: {}", line_in_words(line), self.reason(&line.reason))),
                ),
                other => items.push(self.inline(other, false)),
            }
        }
        items
    }

    fn table(self, pieces: &[Piece]) -> Vec<String> {
        let mut rows: Vec<(String, String)> = Vec::new();
        for piece in pieces {
            match piece {
                Piece::Formula(Shown { columns: (left, right), remark, verdict, .. }) => {
                    let right = match (right, remark) {
                        (Some(right), _) => format!("${right}$"),
                        (None, Some(remark)) => self.reason(remark),
                        (None, None) => verdict.map_or("", Verdict::word).to_owned(),
                    };
                    rows.push((format!("${left}$"), right));
                }
                Piece::Words(words) => rows.push((String::new(), self.words(words))),
                Piece::Picture(picture) => rows.push((String::new(), self.picture(picture).join(" "))),
                Piece::Steps(lines) => {
                    rows.extend(lines.iter().map(|line| (line_in_words(line), self.reason(&line.reason))));
                }
            }
        }
        match self {
            Markup::Markdown => {
                let rows = rows
                    .iter()
                    .map(|(left, right)| format!("| {} | {} |", within_cell(left), within_cell(right)));
                ["| | |", "| --- | --- |"].into_iter().map(str::to_owned).chain(rows).collect()
            }
            Markup::Latex => {
                let rows = rows.iter().map(|(left, right)| format!(r"{left} & {right} \\"));
                let table = enclosed("tabular", "{ll}", rows);
                enclosed("center", "", table.into_iter())
            }
        }
    }

    fn code(self, pieces: &[Piece]) -> Vec<String> {
        let mut lines = Vec::new();
        for piece in pieces {
            match piece {
                Piece::Words(words) => lines.push(words.clone()),
                Piece::Picture(picture) => lines.push(picture.title.clone()),
                Piece::Formula(Shown { text, remark: Some(remark), .. }) => {
                    lines.push(format!("{text}    [{}]", words_as_text(remark)));
                }
                Piece::Formula(Shown { text, .. }) => lines.push(text.clone()),
                Piece::Steps(steps) => lines.extend(
                    steps.iter().map(|line| format!("{}    [{}]", line.text, words_as_text(&line.reason))),
                ),
            }
        }
        let lines = lines.iter().flat_map(|line| line.lines());
        match self {
            Markup::Markdown => {
                let lines = lines.map(str::to_owned);
                ["```text".to_owned()].into_iter().chain(lines).chain(["```".to_owned()]).collect()
            }
            Markup::Latex => {
                let lines: Vec<String> = lines.map(typewriter).collect();
                let last = lines.len().saturating_sub(1);
                let lines = lines.into_iter().enumerate();
                let lines = lines.map(|(i, line)| if i < last { line + r"\\{}" } else { line });
                enclosed("quote", r"\ttfamily", lines)
            }
        }
    }
}

/// A line of a listing: every blank stays.
fn typewriter(line: &str) -> String {
    escaped(line).replace(' ', r"\ ").replace("--", "-{}-")
}

fn enclosed(name: &str, arguments: &str, lines: impl Iterator<Item = String>) -> Vec<String> {
    let mut all = vec![format!(r"\begin{{{name}}}{arguments}")];
    all.extend(lines);
    all.push(format!(r"\end{{{name}}}"));
    all
}

fn with_remark(shown: &Shown) -> String {
    match &shown.remark {
        None => shown.latex.clone(),
        Some(remark) => {
            format!(r"{} \quad \textbf{{[}}{}\textbf{{]}}", shown.latex, words_in_formula(remark))
        }
    }
}

/// A derivation, its signs below each other.
fn aligned(lines: &[StepLine]) -> Vec<String> {
    let last = lines.len().saturating_sub(1);
    let rows = lines.iter().enumerate().map(|(i, line)| {
        let (left, right) = &line.latex;
        let left = if line.repeats { "" } else { left };
        let end = if i < last { r" \\" } else { "" };
        format!("{left} &{right} && {}{end}", words_in_formula(&line.reason))
    });
    enclosed("aligned", "", rows)
}

/// Derivations with longer lines, or more of them, get a display of their own in LaTeX.
const WIDEST: usize = 60;
const LONGEST: usize = 12;

fn is_wide(lines: &[StepLine]) -> bool {
    let width = |line: &StepLine| line.text.chars().count() + line.reason.chars().count();
    lines.len() > LONGEST || lines.iter().any(|line| width(line) > WIDEST)
}

/// A derivation that may break over pages, each reason below its line.
fn over_pages(lines: &[StepLine], room: f64) -> Vec<String> {
    let last = lines.len().saturating_sub(1);
    let margin = lines.iter().map(|line| measured(&line.latex.0)).fold(0.0, f64::max);
    let rows = lines.iter().enumerate().map(|(i, line)| {
        let (left, right) = &line.latex;
        let left = if line.repeats { "" } else { left };
        let end = if i < last { r"\\[0.5ex]" } else { "" };
        let right = lines_of(right, room - margin).join(r" \\* &");
        let reasons = in_lines(&line.reason, room - margin - 20.0);
        let reasons: Vec<String> = reasons.iter().map(|reason| words_in_formula(reason)).collect();
        format!(r"{left} &{right} \\*[-0.3ex] &\qquad {}{end}", reasons.join(r" \\*[-0.3ex] &\qquad "))
    });
    let display = enclosed("align*", "", rows);
    [vec![r"{\allowdisplaybreaks".to_owned()], display, vec!["}".to_owned()]].concat()
}

/// Words with formulas between backticks in lines of about this width; no formula is broken.
fn in_lines(words: &str, width: f64) -> Vec<String> {
    /// A letter of text with its share of the blanks, in points.
    const LETTER: f64 = 4.9;
    let mut lines: Vec<String> = vec![String::new()];
    let mut inside = false;
    for word in words.split(' ') {
        let line = lines
            .last_mut()
            .filter(|line| inside || line.is_empty() || LETTER * ((line.len() + word.len()) as f64) < width);
        match line {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) => {
                line.push(' ');
                line.push_str(word);
            }
            None => lines.push(word.to_owned()),
        }
        inside ^= word.matches('`').count() % 2 == 1;
    }
    lines
}

/// A formula that cannot be broken, as wide as the text; tikz brings graphicx.
fn reduced(formula: &str) -> Vec<String> {
    let fit = r"\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{$\displaystyle".to_owned();
    let lines = std::iter::once(fit).chain(formula.lines().map(str::to_owned));
    enclosed("center", "", lines.chain(["$}".to_owned()]))
}

fn line_in_words(line: &StepLine) -> String {
    let (left, right) = &line.latex;
    if left.is_empty() { format!("${right}$") } else { format!("${left} {right}$") }
}

/// The text of a cell of Markdown: a bar would end it.
pub(super) fn within_cell(text: &str) -> String {
    if !text.contains('|') {
        return text.to_owned();
    }
    text.replace(r"\|", r"\Vert ").replace('|', r"\vert ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::value::Value;
    use crate::session::Session;
    use crate::weave::{BlockOptions, render};

    fn pieces(statements: &[&str]) -> Vec<Piece> {
        let mut session = Session::default();
        let run = |statement: &&str| {
            let answer = session.run(statement).unwrap();
            let lines = match (&answer.outcome.value, statement.starts_with("polar(")) {
                (Value::Polar(polar), true) => {
                    let method = crate::math::blossom::Method::Elementary;
                    crate::language::derive::polar(polar, method, &crate::language::derive::Names::default())
                        .lines
                }
                _ => Vec::new(),
            };
            render(&answer, &lines, &BlockOptions::default()).unwrap()
        };
        statements.iter().map(run).collect()
    }

    #[test]
    fn styles_of_markdown() {
        let pieces = pieces(&["f := polar(t^2)", "f(0, 1) = 1", "[1, 2; 3, 4]", "degree(0)"]);
        let shown = |style| {
            let options = BlockOptions { style, ..BlockOptions::default() };
            Markup::Markdown.block(&pieces, &options).join("\n")
        };
        let display = shown(Style::Display);
        assert!(display.starts_with("$$\nf(t_1, t_2) = t_1 t_2\n$$\n\n$$\nf(0, 1) = 1 \\quad"), "{display}");
        assert!(shown(Style::List).starts_with("- $f(t_1, t_2) = t_1 t_2$\n- $f(0, 1) = 1 \\quad"));
        let table = shown(Style::Table);
        assert!(
            table.contains("| $f(t_1, t_2)$ | $t_1 t_2$ |\n| $f(0, 1) = 1$ | refuted: left $0$, right $1$ |")
        );
        assert!(table.lines().all(|line| line.matches('|').count() == 3), "{table}");
        let code = shown(Style::Code);
        assert!(code.starts_with("```text\nf(t1, t2) = t1 t2\nf(0, 1) = 1    [refuted: left 0, right 1]\n"));
        assert_eq!(shown(Style::Inline).lines().count(), 1);
        assert!(Markup::Markdown.block(&[], &BlockOptions::default()).is_empty());
    }

    #[test]
    fn steps_are_aligned() {
        let pieces = pieces(&["polar(t^2 + 2t)"]);
        let lines = Markup::Markdown.block(&pieces, &BlockOptions::default());
        assert_eq!(lines[1], r"\begin{aligned}");
        assert_eq!(lines[2], r"F(t) &= t^2 + 2 t && \text{a polynomial of degree at most 2} \\");
        assert!(lines.iter().all(|line| line == "$$" || !line.contains('$')), "{lines:?}");
        let latex = Markup::Latex
            .block(&pieces, &BlockOptions { style: Style::List, ..BlockOptions::default() })
            .join("\n");
        assert!(
            latex.contains(r"\item {}$\sigma_{2,2}(t_1, t_2) = t_1 t_2$: replaces $t^2$: the only product"),
            "{latex}"
        );
    }
}
