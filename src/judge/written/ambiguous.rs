//! Remarks on formulas that print, or a reader, takes in two ways.

use crate::formula::source::Span;
use crate::formula::{BigOp, Expr, Kind, Quotient};
use crate::judge::written::names::{has_free, own_names};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::write::text;

/// Remarks about products that are read in two ways: `3/7 t` and `d/dt F d/dt G` in print, `a/2b` in plain notation.
pub(crate) fn products(expr: &Expr, latex: bool, notes: &mut Vec<Diagnostic>) {
    if let Kind::Mul(factors) = &expr.kind {
        for pair in factors.windows(2) {
            // f(t1) in LaTeX
            let touches = pair[0].span.end == pair[1].span.start;
            if let (Kind::Name(letter), Kind::Number(number), true) =
                (&pair[0].kind, &pair[1].kind, latex && touches)
            {
                notes.push(
                    Diagnostic::note(
                        Code::AmbiguousProduct,
                        format!("{letter}{number} is {letter} times {number}"),
                    )
                    .hint(format!("write {letter}_{number} for a name with an index"))
                    .at(pair[0].span.to(pair[1].span)),
                );
            }
            // [0,1,2]x^2, x^3[0,1,2]
            if let ([_, _], true) = (factors.as_slice(), touches) {
                let other = |expr: &Expr| !matches!(expr.kind, Kind::Number(_));
                let beside = match (is_list_of_numbers(&pair[0]), is_list_of_numbers(&pair[1])) {
                    (true, _) => Some("what follows it"),
                    (_, true) if other(&pair[0]) => Some("what stands before it"),
                    _ => None,
                };
                if let Some(beside) = beside {
                    notes.push(as_factor(beside).at(pair[0].span.to(pair[1].span)));
                }
            }
            let Kind::Div(above, below, Quotient::Slash) = &pair[0].kind else { continue };
            let number = |expr: &Expr| matches!(expr.kind, Kind::Number(_));
            let doubtful = match latex {
                true => !matches!(&pair[1].kind, Kind::Group(_)),
                // 1/2t is half of t, but a/2b and 1/xy?
                false => touches && !(number(above) && number(below)),
            };
            if doubtful && !matches!(&below.kind, Kind::Name(d) if d == "d") {
                let hint =
                    if latex { "write \\frac{3}{7} t, or 3/(7 t)" } else { "write (a/2) b, or a/(2b)" };
                notes.push(
                    Diagnostic::note(
                        Code::AmbiguousProduct,
                        "the quotient is read as a factor of what follows it",
                    )
                    .hint(hint)
                    .at(pair[0].span.to(pair[1].span)),
                );
            }
        }
    }
    // [0,1,2] 1/x
    if let Kind::Div(above, below, Quotient::Slash) = &expr.kind
        && let (Kind::Mul(factors), Kind::Name(_)) = (&above.kind, &below.kind)
        && let [list, Expr { kind: Kind::Number(_), .. }] = factors.as_slice()
        && is_list_of_numbers(list)
    {
        notes.push(as_factor("what follows it").at(expr.span));
    }
    // \sum_k 2k + 3k
    if let (Kind::Add(terms), true) = (&expr.kind, latex) {
        for (at, term) in terms.iter().enumerate() {
            let Some((own, span)) = bound_in(&term.expr) else { continue };
            let outside =
                terms[at + 1..].iter().find(|later| own.iter().any(|name| has_free(&later.expr, name)));
            if let Some(outside) = outside {
                notes.push(
                    Diagnostic::note(
                        Code::AmbiguousProduct,
                        "the index of this sum or product stands outside of it, too",
                    )
                    .hint("write \\left( … \\right) around all that is summed")
                    .at(span.to(outside.expr.span)),
                );
            }
        }
    }
    // \prod_k k x
    if let (Kind::Mul(factors), true) = (&expr.kind, latex)
        && let Some(pair) =
            factors.windows(2).find(|pair| matches!(&pair[0].kind, Kind::Big { op: BigOp::Product, .. }))
    {
        notes.push(
            Diagnostic::note(
                Code::AmbiguousProduct,
                "the product ends with the last factor that has its index",
            )
            .hint("write \\left( … \\right) around all that is multiplied")
            .at(pair[0].span.to(pair[1].span)),
        );
    }
    // d/dt F d/dt G
    if let Kind::Derivative { body: Some(body), .. } = &expr.kind
        && let Some(second) = derivative_among(body)
    {
        notes.push(
            Diagnostic::note(Code::AmbiguousProduct, "the first derivative is that of all that follows it")
                .hint("write parentheses around the product of two derivatives: (d/dt F) (d/dt G)")
                .at(expr.span.to(second.span)),
        );
    }
    expr.for_each_child(&mut |child| products(child, latex, notes));
}

/// What to write for a list of numbers that touches a power or a parenthesis before it: x^3[0, 1, 2] may be a divided
/// difference or a product.
pub(crate) fn touching_list(expr: &Expr) -> Option<Diagnostic> {
    if let Kind::Mul(factors) = &expr.kind {
        let found = factors.windows(2).find(|pair| {
            let before = matches!(pair[0].kind, Kind::Pow(..) | Kind::Group(_));
            let letters = pair[0].has(&|part| matches!(part.kind, Kind::Name(_)));
            before && letters && is_list_of_numbers(&pair[1]) && pair[0].span.end == pair[1].span.start
        });
        if let Some([before, list]) = found {
            let at = factors.iter().position(|factor| factor.span == list.span).unwrap_or(1);
            let function = match (&before.kind, at) {
                (Kind::Group(inner), 1) => text(inner),
                _ => text(&Expr::product(factors.iter().take(at).cloned().collect())),
            };
            let nodes = list.items().unwrap_or_default().iter().map(text).collect::<Vec<_>>().join(", ");
            let problem = Diagnostic::error(Code::AmbiguousProduct, "a divided difference, or a product?")
                .at(before.span.to(list.span))
                .reason("a list of numbers directly after a formula")
                .hint(format!("ask in words for the first: divided difference of {function} at {nodes}"))
                .hint(format!("for the product write * between them: {} * {}", text(before), text(list)));
            return Some(problem);
        }
    }
    let mut found = None;
    expr.for_each_child(&mut |child| found = found.take().or_else(|| touching_list(child)));
    found
}

fn is_list_of_numbers(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::List(items)
        if items.len() > 1 && items.iter().all(|item| matches!(item.kind, Kind::Number(_))))
}

/// A list that may be meant as the nodes of a divided difference.
fn as_factor(of: &str) -> Diagnostic {
    Diagnostic::note(Code::AmbiguousProduct, format!("the list is read as a factor of {of}"))
        .hint("a divided difference is written F[0, 1, 2] for a function F, after F(t) := t^2")
}

/// A derivative among the factors of a product.
fn derivative_among(product: &Expr) -> Option<&Expr> {
    let (Kind::Mul(factors) | Kind::Cross(factors)) = &product.kind else { return None };
    factors.iter().find_map(|factor| match factor.kind {
        Kind::Derivative { .. } => Some(factor),
        _ => derivative_among(factor),
    })
}

/// The names that a sum or product at the end of a term runs over, and its place.
fn bound_in(term: &Expr) -> Option<(Vec<String>, Span)> {
    match &term.kind {
        Kind::Big { lower, body, .. } => {
            let inner = bound_in(body).map_or(Vec::new(), |(names, _)| names);
            Some((own_names(lower).into_iter().chain(inner).collect(), term.span))
        }
        Kind::Mul(factors) => factors.last().and_then(bound_in),
        _ => None,
    }
}
