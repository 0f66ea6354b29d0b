//! What the plain notation and its Unicode form have in common.
//!
//! The plain reader's rules: a parenthesis directly after a name is a call, after a
//! blank a product; digits directly after a name are its index; two numerals need a
//! `*` between them; `{` begins no factor of a product by juxtaposition; braces after
//! `^` only group. What the notation has no sign for is printed as a call: `diff(F, t, 2)`.

use num_traits::Signed;

use super::decimal;
use super::shape;
use super::walk::{Notation, Pieces};
use crate::formula::{BigOp, Delimiter, Enclosure, Expr, Kind, Precedence, Rel, Sign, Term, before_brackets};

/// The signs in which the two differ.
pub(super) trait Plain: Notation {
    /// Between the parameters of a function and what it gives.
    const ARROW: &'static str;
    /// Dots among the items of a list.
    const DOTS: &'static str;
    /// Dots among terms or factors.
    const CENTRED_DOTS: &'static str;
    /// Around what is rounded down.
    const FLOOR: (&'static str, &'static str);
    /// Around what is rounded up.
    const CEIL: (&'static str, &'static str);
    /// A relation with the blanks around it.
    fn relation(rel: Rel) -> &'static str;
    /// Whether the next factor may stand closer to this one than others do, as in 2t.
    fn is_tight(factor: &Expr) -> bool;
}

/// The precedence of what `expr` is printed as: many nodes become calls.
pub(super) fn level(expr: &Expr) -> Precedence {
    match &expr.kind {
        Kind::Number(value) => decimal::level(value),
        // A written plus is read at the start of an item only.
        Kind::Add(terms) if matches!(terms.as_slice(), [Term { sign: Sign::Plus, .. }]) => {
            Precedence::Relation
        }
        Kind::Upper(..)
        | Kind::Transpose(_)
        | Kind::Cross(_)
        | Kind::Big { .. }
        | Kind::Integral { .. }
        | Kind::Derivative { .. }
        | Kind::At { .. }
        | Kind::ForAll(..) => Precedence::Postfix,
        _ => expr.precedence(),
    }
}

/// The pieces of any node, with letters and digits in ASCII; the Unicode form has its own way with
/// names, indices, exponents and accents before it comes here.
pub(super) fn expand<'a, P: Plain>(expr: &'a Expr, out: &mut Pieces<'a>) {
    use Precedence::{Postfix, Relation, Sequence, Sum};
    match &expr.kind {
        Kind::Number(value) => out.string(decimal::numeral(value)),
        Kind::Name(name) => out.str(before_brackets(name).unwrap_or(name)),
        Kind::Subscript(base, indices) => subscript(base, indices, out),
        Kind::Upper(base, indices) => {
            // after a number, it would be an exponent
            if matches!(base.kind, Kind::Number(_)) {
                out.wrapped("(", base, ")");
            } else {
                out.node(base, Postfix);
            }
            out.str("^{(");
            out.script_list(indices, ",");
            out.str(")}");
        }
        Kind::Accent(accent, body) => {
            out.str(accent.name());
            out.wrapped("(", body, ")");
        }
        Kind::Prime(body, count) => {
            shape::primed(body, out);
            out.string("'".repeat(*count as usize));
        }
        Kind::Add(terms) => shape::sum(terms, Some(P::CENTRED_DOTS), out),
        Kind::Mul(factors) => {
            shape::product(factors, Some(P::CENTRED_DOTS), out, |_| false, |factor, _| P::is_tight(factor))
        }
        Kind::Div(above, below, _) => shape::slash(above, below, out, |_| false),
        Kind::Pow(base, exponent) => power(base, exponent, out),
        Kind::Apply(callee, groups) => {
            let (open, close) = if callee.is_called_with_brackets() { ("[", "]") } else { ("(", ")") };
            if is_callee(callee) {
                out.node(callee, Precedence::Power)
            } else {
                out.wrapped("(", callee, ")")
            }
            out.str(open);
            for (i, group) in groups.iter().enumerate() {
                out.str(if i > 0 { "; " } else { "" });
                out.list(group, ", ", Relation);
            }
            out.str(close);
        }
        Kind::Group(body) => out.wrapped("(", body, ")"),
        Kind::Tuple(items) => call("", items, out),
        Kind::List(items) => {
            out.str("[");
            out.list(items, ", ", Relation);
            out.str("]");
        }
        Kind::Set(items, condition) => {
            out.str("{");
            out.list(items, ", ", Relation);
            if let Some(condition) = condition {
                out.str(" | ");
                out.node(condition, Relation);
            }
            out.str("}");
        }
        Kind::Matrix(rows, delimiter) => matrix(rows, *delimiter, out),
        Kind::Binomial(n, k, _) => call("binomial", [&**n, &**k], out),
        Kind::Factorial(body) => {
            // a second ! would be read as a slip
            if matches!(body.kind, Kind::Factorial(_)) {
                out.wrapped("(", body, ")");
            } else {
                out.node(body, Postfix);
            }
            out.str("!");
        }
        Kind::Enclosed(Enclosure::Abs, body) => call("abs", [&**body], out),
        Kind::Enclosed(Enclosure::Norm, body) => call("norm", [&**body], out),
        Kind::Enclosed(Enclosure::Floor, body) => out.wrapped(P::FLOOR.0, body, P::FLOOR.1),
        Kind::Enclosed(Enclosure::Ceil, body) => out.wrapped(P::CEIL.0, body, P::CEIL.1),
        Kind::Big { op, lower, upper, body } => big(*op, lower, upper.as_deref(), body, out),
        Kind::Integral { lower, upper, body, variable } => {
            out.str("integral(");
            out.node(body, Relation);
            out.str(", ");
            out.node(variable, Postfix);
            if lower.is_some() || upper.is_some() {
                out.str("=");
                out.list(lower.as_deref(), "", Sum);
                out.str("..");
                out.list(upper.as_deref(), "", Sum);
            }
            out.str(")");
        }
        Kind::Derivative { variables, body, .. } => derivative(variables, body.as_deref(), out),
        Kind::At { body, lower, upper } => {
            out.str("at(");
            out.list(std::iter::once(&**body).chain(lower), ", ", Relation);
            if let Some(upper) = upper {
                out.str("; ");
                out.node(upper, Relation);
            }
            out.str(")");
        }
        Kind::Cases(cases) => {
            out.str("cases(");
            for (i, (value, condition)) in cases.iter().enumerate() {
                out.str(if i > 0 { ", " } else { "" });
                out.node(value, Relation);
                match condition {
                    Some(condition) => {
                        out.str(" if ");
                        out.node(condition, Relation);
                    }
                    None => out.str(" otherwise"),
                }
            }
            out.str(")");
        }
        Kind::Ellipsis => out.str(P::DOTS),
        Kind::Brace(items, label) => {
            out.str("{");
            out.list(items, ", ", Relation);
            out.str("}");
            if let Some(label) = label {
                out.str("_(");
                out.script(label, Sequence);
                out.str(")");
            }
        }
        Kind::Compose(items) => out.list(items, "∘", Precedence::Power),
        Kind::Cross(items) => call("cross", items, out),
        Kind::Transpose(body) => call("transpose", [&**body], out),
        Kind::Range(low, high) => {
            out.node(low, Sum);
            out.str("..");
            out.node(high, Sum);
        }
        Kind::Lambda(parameters, body) => {
            match parameters.as_slice() {
                [single] => out.node(single, Postfix),
                several => call("", several, out),
            }
            out.str(P::ARROW);
            out.node(body, Precedence::Lambda);
        }
        Kind::Chain(first, links) => shape::chain(first, links, out, |rel, _| P::relation(rel)),
        Kind::Sequence(items) => out.list(items, ", ", Relation),
        Kind::ForAll(items, body) => {
            out.str("forall(");
            out.list(items, ", ", Relation);
            if let Some(body) = body {
                out.str("; ");
                out.node(body, Relation);
            }
            out.str(")");
        }
        Kind::Text(words) => out.string(quoted(words)),
        Kind::Unread(written) => out.str(written),
    }
}

fn call<'a>(name: &'static str, items: impl IntoIterator<Item = &'a Expr>, out: &mut Pieces<'a>) {
    out.str(name);
    out.str("(");
    out.list(items, ", ", Precedence::Relation);
    out.str(")");
}

/// Names whose integer index is written without underscore: those that stand for arguments.
fn takes_digits(base: &Expr) -> bool {
    matches!(&base.kind, Kind::Name(name) if matches!(name.as_str(), "s" | "t" | "u" | "v" | "w" | "x" | "y" | "z"))
}

fn subscript<'a>(base: &'a Expr, indices: &'a [Expr], out: &mut Pieces<'a>) {
    let indices = without_brackets(indices);
    match base.kind {
        // no index may follow these
        Kind::Subscript(..) | Kind::Number(_) | Kind::Ellipsis | Kind::Text(_) => out.wrapped("(", base, ")"),
        _ => out.node(base, Precedence::Postfix),
    }
    match indices {
        [index] if is_numeral(index) => {
            out.str(if takes_digits(base) { "" } else { "_" });
            out.node(index, Precedence::Atom);
        }
        [index] if is_word(index) => {
            out.str("_");
            out.node(index, Precedence::Atom);
        }
        _ => {
            out.str("_{");
            out.script_list(indices, ",");
            out.str("}");
        }
    }
}

/// Whether the index is an integer without sign.
pub(super) fn is_numeral(index: &Expr) -> bool {
    match &index.kind {
        Kind::Number(value) => value.is_integer() && !value.is_negative(),
        // 01 is the name of an index
        Kind::Name(name) => !name.is_empty() && name.bytes().all(|b| b.is_ascii_digit()),
        _ => false,
    }
}

/// The indices of `b[0]`, which are those of `b_0`.
pub(super) fn without_brackets(indices: &[Expr]) -> &[Expr] {
    match indices {
        [Expr { kind: Kind::List(items), .. }] => items,
        _ => indices,
    }
}

fn is_word(index: &Expr) -> bool {
    matches!(&index.kind, Kind::Name(name) if name.chars().all(char::is_alphabetic))
}

/// `a^b`
pub(super) fn power<'a>(base: &'a Expr, exponent: &'a Expr, out: &mut Pieces<'a>) {
    out.node(base, Precedence::Postfix);
    out.str("^");
    if ends_early(exponent) {
        out.wrapped("(", exponent, ")");
    } else {
        out.script(exponent, Precedence::Power);
    }
}

/// Whether only the beginning of `exponent` would be read as one: braces after `^` only group,
/// and an ordinary name takes no arguments there.
fn ends_early(mut exponent: &Expr) -> bool {
    while let Kind::Factorial(base)
    | Kind::Prime(base, _)
    | Kind::Subscript(base, _)
    | Kind::Upper(base, _)
    | Kind::Pow(base, _) = &exponent.kind
    {
        if level(base) < Precedence::Postfix {
            return false; // it will be in parentheses
        }
        exponent = base;
    }
    matches!(
        exponent.kind,
        Kind::Set(..)
            | Kind::Brace(..)
            | Kind::Apply(..)
            | Kind::Cross(_)
            | Kind::Derivative { .. }
            | Kind::At { .. }
            | Kind::ForAll(..)
            | Kind::Big { op: BigOp::Limit, .. }
            | Kind::Matrix(_, Delimiter::Bar)
    )
}

/// Whether a parenthesis directly after `expr` makes a call of it.
fn is_callee(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Apply(..) | Kind::Group(_) => true,
        Kind::Pow(base, exponent) => is_named(base) && (has_index(base) || is_bare(exponent)),
        _ => is_named(expr),
    }
}

fn is_named(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        Kind::Name(_) | Kind::Subscript(..) | Kind::Prime(..) | Kind::Accent(..) | Kind::Upper(..)
    )
}

fn has_index(mut expr: &Expr) -> bool {
    while let Kind::Prime(base, _) | Kind::Accent(_, base) | Kind::Upper(base, _) = &expr.kind {
        expr = base;
    }
    matches!(expr.kind, Kind::Subscript(..))
}

fn is_bare(exponent: &Expr) -> bool {
    match &exponent.kind {
        Kind::Name(_) => true,
        Kind::Subscript(base, _) => matches!(base.kind, Kind::Name(_)),
        _ => false,
    }
}

/// `[a, b; c, d]`; the rows may be ragged and cells empty.
fn matrix<'a>(rows: &'a [Vec<Option<Expr>>], delimiter: Delimiter, out: &mut Pieces<'a>) {
    out.str(if delimiter == Delimiter::Bar { "det([" } else { "[" });
    for (i, row) in rows.iter().enumerate() {
        out.str(if i > 0 { "; " } else { "" });
        for (j, cell) in row.iter().enumerate() {
            out.str(if j > 0 { ", " } else { "" });
            out.list(cell, "", Precedence::Relation);
        }
    }
    // One row without a semicolon is a list, and an empty last row is not counted.
    let last_is_empty = rows.last().is_none_or(|row| matches!(row.as_slice(), [] | [None]));
    out.str(if rows.len() == 1 || last_is_empty { ";" } else { "" });
    out.str(if delimiter == Delimiter::Bar { "])" } else { "]" });
}

/// `sum(i=0..n, body)`, with further conditions before the body.
fn big<'a>(op: BigOp, lower: &'a [Expr], upper: Option<&'a Expr>, body: &'a Expr, out: &mut Pieces<'a>) {
    out.str(match op {
        BigOp::Sum => "sum(",
        BigOp::Product => "prod(",
        BigOp::Max => "max(",
        BigOp::Min => "min(",
        BigOp::Union => "union(",
        BigOp::Intersection => "intersection(",
        BigOp::Limit => "lim(",
    });
    if let Some((index, low, high, conditions)) = shape::bounds(lower, upper) {
        out.node(index, Precedence::Postfix);
        // n!=0 would be a relation
        out.str(if matches!(index.kind, Kind::Factorial(_)) { " = " } else { "=" });
        out.node(low, Precedence::Sum);
        out.str("..");
        out.node(high, Precedence::Sum);
        for condition in conditions {
            out.str(", ");
            out.node(condition, Precedence::Relation);
        }
        out.str(", ");
    } else {
        out.list(lower, ", ", Precedence::Relation);
        let between = if upper.is_some() { "; " } else { ", " };
        out.str(if lower.is_empty() && upper.is_none() { "" } else { between });
        if let Some(upper) = upper {
            out.node(upper, Precedence::Relation);
            out.str("; ");
        }
    }
    // A relation at the end would be one more condition.
    out.node(body, Precedence::Lambda);
    out.str(")");
}

/// `diff(F, t, 2)`; several variables nest, the last innermost; `diff(; t)` is the operator alone.
fn derivative<'a>(variables: &'a [(Expr, Option<Expr>)], body: Option<&'a Expr>, out: &mut Pieces<'a>) {
    let with_order = |out: &mut Pieces<'a>, (variable, order): &'a (Expr, Option<Expr>)| {
        out.node(variable, Precedence::Relation);
        if let Some(order) = order {
            out.str(", ");
            out.node(order, Precedence::Relation);
        }
    };
    let Some(body) = body else {
        out.str("diff(");
        for variable in variables {
            out.str("; ");
            with_order(out, variable);
        }
        return out.str(")");
    };
    for _ in variables {
        out.str("diff(");
    }
    out.node(body, Precedence::Relation);
    for variable in variables.iter().rev() {
        out.str(", ");
        with_order(out, variable);
        out.str(")");
    }
}

/// Words in quotation marks, in one line; there is no escape for the marks themselves.
fn quoted(words: &str) -> String {
    let plain = |c: char| {
        if c == '"' {
            '\''
        } else if c.is_control() {
            ' '
        } else {
            c
        }
    };
    std::iter::once('"').chain(words.chars().map(plain)).chain(std::iter::once('"')).collect()
}
