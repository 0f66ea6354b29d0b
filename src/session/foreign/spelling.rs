//! Remarks on spellings that have another meaning elsewhere: `[0,5; 1,5]`, `[1 -3 2]`, `2.5E2`.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Accent, Expr, Kind, Rel, Sign};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval;
use crate::language::write;

/// Refuses ℝ where a number is wanted; what a relation such as ∈ is about, and indices, are no numbers.
pub(in crate::session) fn set_of_numbers(
    statement: &Expr,
    known: &dyn Fn(&str) -> bool,
) -> Option<Diagnostic> {
    let set = |expr: &Expr| match &expr.kind {
        Kind::Accent(Accent::Blackboard, letter) => {
            matches!(&letter.kind, Kind::Name(name) if matches!(name.as_str(), "N" | "Z" | "Q" | "R" | "C") && !known(name))
        }
        _ => false,
    };
    match &statement.kind {
        _ if set(statement) => Some(
            Diagnostic::error(Code::Unsupported, "a set of numbers has no value")
                .at(statement.span)
                .hint("say what belongs to it: t \\in \\mathbb{R}"),
        ),
        Kind::Chain(_, links) if links.iter().any(|link| !matches!(link.rel, Rel::Eq | Rel::Define)) => None,
        Kind::Group(_) | Kind::Add(_) | Kind::Mul(_) | Kind::Div(..) | Kind::Chain(..) => {
            let mut found = None;
            statement.for_each_child(&mut |child| {
                if found.is_none() {
                    found = set_of_numbers(child, known);
                }
            });
            found
        }
        Kind::Pow(base, _) => set_of_numbers(base, known),
        _ => None,
    }
}

/// Tells of a Bernstein polynomial whose number is larger than its degree: it is 0, and the degree goes before the number here.
pub(in crate::session) fn degree_last(statement: &Expr, known: &dyn Fn(&str) -> bool) -> Option<Diagnostic> {
    if let Kind::Apply(callee, groups) = &statement.kind
        && let (Kind::Name(name), Some([degree, number, rest @ ..])) =
            (&callee.kind, groups.first().map(Vec::as_slice))
        && name == "bernstein"
        && !known(name)
        && let (Some(n), Some(i)) = (degree.as_int(), number.as_int())
        && i > n
    {
        let rest: String = rest.iter().map(|item| format!(", {}", write::text(item))).collect();
        let note = Diagnostic::note(Code::Domain, format!("the degree is {n} here, and the number {i}: 0"))
            .at(degree.span.to(number.span))
            .reason("the degree goes first")
            .hint(format!("write bernstein({i}, {n}{rest}) for the degree {i}"));
        return Some(note);
    }
    let mut found = None;
    statement.for_each_child(&mut |child| {
        if found.is_none() {
            found = degree_last(child, known);
        }
    });
    if let (None, Kind::Apply(_, groups)) = (&found, &statement.kind) {
        found = groups.iter().flatten().find_map(|argument| degree_last(argument, known));
    }
    found
}

/// Tells that b[0, 1/2, 1] is a divided difference where b is a function that may be a curve, whose polar values some write so.
pub(in crate::session) fn differences(
    statement: &Expr,
    is_function: &dyn Fn(&str) -> bool,
    notes: &mut Vec<Diagnostic>,
) {
    if let Kind::Subscript(base, index) = &statement.kind
        && let (Kind::Name(name), [Expr { kind: Kind::List(nodes), .. }]) = (&base.kind, index.as_slice())
        && nodes.len() > 1
        && matches!(name.as_str(), "b" | "c" | "d" | "p")
        && is_function(name)
    {
        let nodes: Vec<String> = nodes.iter().map(write::text).collect();
        notes.push(
            Diagnostic::note(Code::StandardMeaning, "read as a divided difference")
                .at(statement.span)
                .hint(format!("write polar({name})({}) for the polar value", nodes.join(", "))),
        );
    }
    statement.for_each_child(&mut |child| differences(child, is_function, notes));
}

/// Adds the remarks on a statement that was read from a file.
pub(in crate::session) fn remarks(statement: &Expr, file: &SourceFile, notes: &mut Vec<Diagnostic>) {
    if let Some(note) = of_part(statement, file)
        && !notes.iter().any(|known| known.message == note.message)
    {
        notes.push(note);
    }
    statement.for_each_child(&mut |child| remarks(child, file, notes));
}

fn of_part(part: &Expr, file: &SourceFile) -> Option<Diagnostic> {
    match &part.kind {
        Kind::Number(_) if file.slice(part.span).contains('E') => {
            let message = format!("{} is {}", file.slice(part.span), write::text(part));
            Some(Diagnostic::note(Code::StandardMeaning, message).at(part.span))
        }
        Kind::Matrix(rows, _)
            if file.slice(part.span).starts_with("\\left[") && rows.iter().all(|row| row.len() == 1) =>
        {
            let note = "semicolons make a column; a list has commas";
            Some(Diagnostic::note(Code::StandardMeaning, note).at(part.span))
        }
        Kind::Matrix(rows, _) => {
            let rows: Vec<Vec<&Expr>> = rows.iter().map(|row| row.iter().flatten().collect()).collect();
            of_decimals(&rows, part.span, file).or_else(|| of_signs(&rows, part.span, file))
        }
        // 1.23(45)
        Kind::Mul(factors) => factors.windows(2).find_map(|pair| {
            let digits = match &pair[1].kind {
                Kind::Group(inner) => matches!(&inner.kind, Kind::Number(number) if number.is_integer()),
                _ => false,
            };
            let decimal = matches!(pair[0].kind, Kind::Number(_)) && file.slice(pair[0].span).contains('.');
            (decimal && digits && pair[0].span.end == pair[1].span.start).then(|| {
                let note =
                    "read as a product; the digits of a repeating decimal stand below a bar: 0.\\overline{3}";
                Diagnostic::note(Code::AmbiguousProduct, note).at(pair[0].span.to(pair[1].span))
            })
        }),
        Kind::List(items) => of_signs(&[items.iter().collect()], part.span, file),
        _ => None,
    }
}

/// `[0,5; 1,5]`, with a blank after each semicolon and none after a comma, may be a list of two decimals.
fn of_decimals(rows: &[Vec<&Expr>], span: Span, file: &SourceFile) -> Option<Diagnostic> {
    let comma = |row: &Vec<&Expr>| match row.as_slice() {
        [before, after] => {
            eval::is_decimal_comma(before, after)
                && file.slice(Span::new(before.span.end, after.span.start)) == ","
        }
        _ => false,
    };
    let apart = |pair: &[Vec<&Expr>]| match (pair[0].last(), pair[1].first()) {
        (Some(end), Some(start)) if end.span.end < start.span.start => {
            let between = file.slice(Span::new(end.span.end, start.span.start));
            between.trim() == ";" && between.len() > 1
        }
        _ => false,
    };
    let decimals = rows.len() > 1 && rows.iter().all(comma) && rows.windows(2).all(apart);
    decimals.then(|| {
        let count = rows.len();
        let message = format!("a matrix of {count} rows and 2 columns, not {count} decimal numbers");
        Diagnostic::note(Code::BadNumber, message).at(span).hint("decimals are written with a point: 1.5")
    })
}

/// `[1 -3 2]`: items without commas, one with a sign.
fn of_signs(rows: &[Vec<&Expr>], span: Span, file: &SourceFile) -> Option<Diagnostic> {
    let signed = |item: &Expr| {
        matches!(&item.kind, Kind::Add(terms)
            if matches!(terms.as_slice(), [term] if term.sign == Sign::Minus))
    };
    let blank = |pair: &[&Expr]| {
        let (end, start) = (pair[0].span.end, pair[1].span.start);
        signed(pair[1]) && end < start && file.slice(Span::new(end, start)).trim().is_empty()
    };
    rows.iter().any(|row| row.windows(2).any(blank)).then(|| {
        let shown =
            |row: &Vec<&Expr>| row.iter().map(|item| write::text(item)).collect::<Vec<_>>().join(", ");
        let all: Vec<String> = rows.iter().map(shown).collect();
        let message = format!("read as the items {}, with no difference", all.join("; "));
        Diagnostic::note(Code::StandardMeaning, message).at(span)
    })
}
