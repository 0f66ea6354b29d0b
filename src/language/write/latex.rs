//! LaTeX for KaTeX and for LaTeX with amsmath (and amssymb for `\mathbb`): `\frac{5}{3} (t_1 + t_2)`.

use std::fmt;

use super::decimal;
use super::marks::Marks;
use super::names;
use super::plain::without_brackets;
use super::radicals::with_radicals;
use super::shape;
use super::walk::{Joint, Notation, Pieces, Tail, walk};
use crate::formula::{
    Accent, BigOp, BinomialStyle, Delimiter, Enclosure, Expr, Kind, Precedence, Quotient, Rel,
    before_brackets,
};
use crate::language::lexicon::relations;

/// The formula in LaTeX, without dollar signs.
///
/// Parentheses grow (`\left( … \right)`) only around what is taller than a line. Between a name
/// and a parenthesis a product has a `\cdot`, since `c(t + 1)` could be a value of c, and between 3 and 1/2,
/// which could be a mixed number. Roots of quadratic polynomials are written by radicals. Pieces that could not be read are printed as they were written.
///
/// Cost: linear in the size of the tree.
///
/// ```
/// use polarform::expr::Expr;
/// let tree = Expr::product(vec![Expr::int(5).over(Expr::int(3)), Expr::indexed("t", 12).power(Expr::int(2))]);
/// assert_eq!(polarform::write::latex(&tree), r"\frac{5}{3} t_{12}^2");
/// ```
pub fn latex(expr: &Expr) -> String {
    let mut text = String::new();
    write_latex(&mut text, expr).expect("writing into a String cannot fail");
    text
}

/// Writes what [`latex()`] returns into `out`.
///
/// # Errors
/// Those of `out`.
pub fn write_latex(out: &mut dyn fmt::Write, expr: &Expr) -> fmt::Result {
    let shown = with_radicals(expr);
    let expr = shown.as_ref().unwrap_or(expr);
    walk(&Latex { tall: Marks::outside_scripts(expr, is_tall) }, expr, Precedence::Sequence, out)
}

/// Whether the node is set taller than a line of text, by itself.
fn is_tall(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(value) => decimal::level(value) == Precedence::Product,
        Kind::Div(_, _, quotient) => *quotient == Quotient::Fraction,
        Kind::Binomial(_, _, style) => *style == BinomialStyle::Stacked,
        Kind::Matrix(..)
        | Kind::Big { .. }
        | Kind::Integral { .. }
        | Kind::Derivative { .. }
        | Kind::Cases(_)
        | Kind::Brace(..) => true,
        _ => false,
    }
}

struct Latex {
    /// What needs tall brackets.
    tall: Marks,
}

/// A pair of brackets: small, tall.
struct Fence {
    small: (&'static str, &'static str),
    tall: (&'static str, &'static str),
}

const PAREN: Fence = Fence { small: ("(", ")"), tall: ("\\left( ", " \\right)") };
const SQUARE: Fence = Fence { small: ("[", "]"), tall: ("\\left[ ", " \\right]") };
const BRACE: Fence = Fence { small: ("\\{ ", " \\}"), tall: ("\\left\\{ ", " \\right\\}") };
const ABS: Fence = Fence { small: ("\\lvert ", " \\rvert"), tall: ("\\left\\lvert ", " \\right\\rvert") };
const NORM: Fence = Fence { small: ("\\lVert ", " \\rVert"), tall: ("\\left\\lVert ", " \\right\\rVert") };
const FLOOR: Fence =
    Fence { small: ("\\lfloor ", " \\rfloor"), tall: ("\\left\\lfloor ", " \\right\\rfloor") };
const CEIL: Fence = Fence { small: ("\\lceil ", " \\rceil"), tall: ("\\left\\lceil ", " \\right\\rceil") };

impl Fence {
    fn around(&self, tall: bool) -> (&'static str, &'static str) {
        if tall { self.tall } else { self.small }
    }
}

impl Notation for Latex {
    type Error = fmt::Error;

    fn level(&self, expr: &Expr) -> Precedence {
        match &expr.kind {
            Kind::Number(value) => match decimal::level(value) {
                Precedence::Product => Precedence::Compose,
                level => level,
            },
            // The fraction holds together, but takes no exponent.
            Kind::Div(_, _, Quotient::Fraction) | Kind::At { .. } => Precedence::Compose,
            Kind::Binomial(_, _, BinomialStyle::Subscripted) => Precedence::Power,
            Kind::Apply(callee, groups) if infix(callee, groups).is_some() => Precedence::Compose,
            _ => expr.precedence(),
        }
    }

    fn parentheses(&self, expr: &Expr) -> (&'static str, &'static str) {
        PAREN.around(self.tall.has(expr))
    }

    fn between(&self, joint: Joint, before: &Tail, next: &str) -> &'static str {
        let first = next.chars().next();
        match joint {
            Joint::Adjacent if before.command && first.is_some_and(|c| c.is_ascii_alphabetic()) => " ",
            // \\[…] would be the distance to the next row
            Joint::Adjacent if before.row_break && first == Some('[') => "{}",
            Joint::Adjacent => "",
            Joint::Times { mixed: true, .. } => " \\cdot ",
            Joint::Times { .. } if first.is_some_and(|c| c.is_ascii_digit()) => " \\cdot ",
            Joint::Times { hint: callee, .. } => {
                let bracket = ["(", "\\left(", "\\{", "\\left\\{"].iter().any(|open| next.starts_with(open));
                if callee && bracket { " \\cdot " } else { " " }
            }
        }
    }

    fn expand<'a>(&self, expr: &'a Expr, out: &mut Pieces<'a>) -> fmt::Result {
        use Precedence::{Postfix, Power, Relation, Sequence, Sum};
        match &expr.kind {
            Kind::Number(value) => match decimal::decimal(value) {
                Some(digits) => out.string(digits),
                None => out.string(format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom())),
            },
            Kind::Name(name) => self.name(name, false, out),
            Kind::Subscript(base, indices) => {
                // letters with accents or styles take an index as letters do
                out.node(base, Precedence::Atom);
                script("_", without_brackets(indices), out);
            }
            Kind::Upper(base, indices) => {
                out.node(base, Postfix);
                out.str("^{(");
                out.script_list(indices, ",");
                out.str(")}");
            }
            Kind::Accent(accent, body) => {
                out.str(accent_command(*accent, body));
                out.wrapped("{", body, "}");
            }
            Kind::Prime(body, count) => {
                shape::primed(body, out);
                out.string("'".repeat(*count as usize));
            }
            Kind::Add(terms) => shape::sum(terms, Some("\\cdots"), out),
            Kind::Mul(factors) => shape::product(factors, Some("\\cdots"), out, is_open, could_be_called),
            Kind::Div(above, below, Quotient::Slash) => shape::slash(above, below, out, is_open),
            Kind::Div(above, below, Quotient::Fraction) => {
                out.wrapped("\\frac{", above, "}");
                out.wrapped("{", below, "}");
            }
            Kind::Pow(base, exponent) => {
                out.node(base, Postfix);
                // The braces group already; parentheses would make an upper index.
                let inner = match &exponent.kind {
                    Kind::Group(inner) => inner,
                    _ => exponent,
                };
                script("^", std::slice::from_ref(inner), out);
            }
            Kind::Apply(callee, groups) => self.apply(callee, groups, out),
            Kind::Group(body) => self.fenced(&PAREN, std::slice::from_ref(&**body), out),
            Kind::Tuple(items) => self.fenced(&PAREN, items, out),
            Kind::List(items) => self.fenced(&SQUARE, items, out),
            Kind::Set(items, None) => self.fenced(&BRACE, items, out),
            Kind::Set(items, Some(condition)) => {
                let (open, close) = BRACE.around(self.tall.has(expr));
                out.str(open);
                out.list(items, ", ", Relation);
                out.str(" \\mid ");
                out.node(condition, Relation);
                out.str(close);
            }
            Kind::Matrix(rows, delimiter) => matrix(rows, *delimiter, out),
            Kind::Binomial(n, k, BinomialStyle::Stacked) => {
                out.wrapped("\\binom{", n, "}");
                out.wrapped("{", k, "}");
            }
            Kind::Binomial(n, k, BinomialStyle::Subscripted) => {
                out.str("C_{");
                out.script(n, Sequence);
                out.str("}^{");
                out.script(k, Sequence);
                out.str("}");
            }
            Kind::Factorial(body) => {
                out.node(body, Postfix);
                out.str("!");
            }
            Kind::Enclosed(enclosure, body) => {
                let fence = match enclosure {
                    Enclosure::Abs => &ABS,
                    Enclosure::Norm => &NORM,
                    Enclosure::Floor => &FLOOR,
                    Enclosure::Ceil => &CEIL,
                };
                self.fenced(fence, std::slice::from_ref(&**body), out);
            }
            Kind::Big { op, lower, upper, body } => {
                out.str(operator(*op));
                if !lower.is_empty() {
                    out.str(if lower.len() > 1 { "_{\\substack{" } else { "_{" });
                    let compact = lower.len() == 1;
                    if compact {
                        out.script_list(lower, "")
                    } else {
                        out.list(lower, " \\\\ ", Relation)
                    }
                    out.str(if lower.len() > 1 { "}}" } else { "}" });
                }
                if let Some(upper) = upper {
                    out.str("^{");
                    out.script(upper, Sequence);
                    out.str("}");
                }
                out.str(" ");
                out.node(body, Precedence::Product);
            }
            Kind::Integral { lower, upper, body, variable } => {
                out.str("\\int");
                for (mark, bound) in [("_{", lower), ("^{", upper)] {
                    if let Some(bound) = bound {
                        out.str(mark);
                        out.script(bound, Sequence);
                        out.str("}");
                    }
                }
                out.str(" ");
                out.node(body, Precedence::Product);
                out.str(" \\, d");
                out.node(variable, Postfix);
            }
            Kind::Derivative { partial, variables, body } => {
                derivative(*partial, variables, out);
                if let Some(body) = body {
                    out.str(" ");
                    out.node(body, Precedence::Product);
                }
            }
            Kind::At { body, lower, upper } => {
                let (open, close) =
                    if upper.is_some() { ("\\left[ ", " \\right]") } else { ("\\left. ", " \\right|") };
                out.wrapped(open, body, close);
                out.str("_{");
                out.script_list(lower, ",\\,");
                out.str("}");
                if let Some(upper) = upper {
                    out.str("^{");
                    out.script(upper, Sequence);
                    out.str("}");
                }
            }
            Kind::Cases(cases) => {
                out.str("\\begin{cases} ");
                for (i, (value, condition)) in cases.iter().enumerate() {
                    out.str(if i > 0 { " \\\\ " } else { "" });
                    out.node(value, Relation);
                    out.str(" & ");
                    match condition {
                        Some(condition) => out.node(condition, Sequence),
                        None => out.str("\\text{otherwise}"),
                    }
                }
                out.str(" \\end{cases}");
            }
            Kind::Ellipsis => out.str("\\ldots"),
            Kind::Brace(items, label) => {
                out.str("\\underbrace{");
                out.list(items, ", ", Relation);
                out.str("}");
                if let Some(label) = label {
                    out.str("_{");
                    out.script(label, Sequence);
                    out.str("}");
                }
            }
            Kind::Compose(items) => out.list(items, " \\circ ", Power),
            Kind::Cross(items) => out.list(items, " \\times ", Power),
            Kind::Transpose(body) => {
                out.node(body, Postfix);
                out.str("^T");
            }
            Kind::Range(low, high) => {
                out.node(low, Sum);
                out.str("..");
                out.node(high, Sum);
            }
            Kind::Lambda(parameters, body) => {
                match parameters.as_slice() {
                    [single] => out.node(single, Postfix),
                    several => self.fenced(&PAREN, several, out),
                }
                out.str(" \\mapsto ");
                out.node(body, Precedence::Lambda);
            }
            Kind::Chain(first, links) => shape::chain(first, links, out, relation),
            Kind::Sequence(items) => out.list(items, ", ", Relation),
            Kind::ForAll(items, body) => {
                out.str("\\forall ");
                out.list(items, ", ", Relation);
                if let Some(body) = body {
                    out.str(": ");
                    out.node(body, Relation);
                }
            }
            Kind::Text(words) => out.string(format!("\\text{{{}}}", names::escaped(words))),
            Kind::Unread(written) => out.str(written),
        }
        Ok(())
    }
}

impl Latex {
    /// A letter, a command, or letters set upright; `called` if arguments follow.
    fn name<'a>(&self, name: &'a str, called: bool, out: &mut Pieces<'a>) {
        let name = before_brackets(name).unwrap_or(name);
        let is_index = name.bytes().all(|b| b.is_ascii_digit());
        if name == "omicron" {
            out.str("o");
        } else if names::is_command(name) {
            out.string(format!("\\{name}"));
        } else if is_index || name.len() == 1 && name.as_bytes()[0].is_ascii_alphabetic() {
            out.str(name);
        } else if !name.bytes().all(|b| b.is_ascii_alphanumeric()) {
            out.string(format!("\\text{{{}}}", names::escaped(name)));
        } else if called {
            out.string(format!("\\operatorname{{{name}}}"));
        } else {
            out.string(format!("\\mathrm{{{name}}}"));
        }
    }

    fn fenced<'a>(&self, fence: &Fence, items: &'a [Expr], out: &mut Pieces<'a>) {
        let (open, close) = fence.around(items.iter().any(|item| self.tall.has(item)));
        out.str(open);
        match items {
            [single] => out.node(single, Precedence::Sequence),
            several => out.list(several, ", ", Precedence::Relation),
        }
        out.str(close);
    }

    fn apply<'a>(&self, callee: &'a Expr, groups: &'a [Vec<Expr>], out: &mut Pieces<'a>) {
        if let Some(sign) = infix(callee, groups) {
            return out.list(&groups[0], sign, Precedence::Power);
        }
        match (&callee.kind, groups) {
            (Kind::Name(name), [group]) if name == "sqrt" && group.len() == 1 => {
                return out.wrapped("\\sqrt{", &group[0], "}");
            }
            (Kind::Name(name), [group]) if name == "root" && group.len() == 2 => {
                out.wrapped("\\sqrt[{", &group[1], "}]");
                return out.wrapped("{", &group[0], "}");
            }
            (Kind::Name(name), _) => self.name(name, true, out),
            (Kind::Group(_) | Kind::Apply(..), _) => out.node(callee, Precedence::Postfix),
            _ if is_named(callee) => out.node(callee, Precedence::Power),
            _ => {
                let (open, close) = PAREN.around(self.tall.has(callee));
                out.wrapped(open, callee, close);
            }
        }
        let fence = if callee.is_called_with_brackets() { &SQUARE } else { &PAREN };
        let (open, close) = fence.around(groups.iter().flatten().any(|item| self.tall.has(item)));
        out.str(open);
        for (i, group) in groups.iter().enumerate() {
            out.str(if i > 0 { "; " } else { "" });
            out.list(group, ", ", Precedence::Relation);
        }
        out.str(close);
    }
}

/// The sign between the arguments of ∪, ⊗ and their like.
fn infix(callee: &Expr, groups: &[Vec<Expr>]) -> Option<&'static str> {
    match (&callee.kind, groups) {
        (Kind::Name(name), [group]) if group.len() >= 2 => names::operator(name),
        _ => None,
    }
}

/// Whether the node takes in the factors to its right.
fn is_open(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::Big { .. } | Kind::Integral { .. } | Kind::Derivative { .. })
}

/// Whether the node is a name with what is attached to it.
fn is_named(mut expr: &Expr) -> bool {
    while let Kind::Subscript(base, _)
    | Kind::Upper(base, _)
    | Kind::Accent(_, base)
    | Kind::Prime(base, _)
    | Kind::Pow(base, _) = &expr.kind
    {
        expr = base;
    }
    matches!(expr.kind, Kind::Name(_))
}

/// Whether the parentheses of `next` could be taken for arguments of `factor`: not after t^2, but
/// after B_1^2 and (F ∘ G).
fn could_be_called(factor: &Expr, next: &Expr) -> bool {
    let inner = match &factor.kind {
        Kind::Group(inner) => inner,
        _ => factor,
    };
    match &inner.kind {
        Kind::Compose(_) | Kind::Derivative { .. } | Kind::Prime(..) | Kind::Upper(..) => true,
        Kind::Div(_, below, Quotient::Slash) => could_be_called(below, next),
        Kind::Mul(factors) => {
            matches!(factors.last(), Some(Expr { kind: Kind::Derivative { .. }, .. }))
        }
        Kind::Add(_) => match &next.kind {
            Kind::Tuple(_) => true,
            Kind::Group(inner) => matches!(inner.kind, Kind::Name(_)),
            _ => false,
        },
        Kind::Pow(base, exponent) if matches!(exponent.kind, Kind::Number(_)) => {
            is_named(factor) && matches!(base.kind, Kind::Subscript(..))
        }
        _ => is_named(factor),
    }
}

/// `_1`, `_{12}`, `_{i,j}`: a single character needs no braces.
fn script<'a>(mark: &'static str, indices: &'a [Expr], out: &mut Pieces<'a>) {
    out.str(mark);
    let single = match indices {
        [Expr { kind: Kind::Number(value), .. }] => {
            value.is_integer() && value.numer().as_small().is_some_and(|x| (0..10).contains(&x))
        }
        [Expr { kind: Kind::Name(name), .. }] => {
            name.len() == 1 && name.as_bytes()[0].is_ascii_alphanumeric()
        }
        _ => false,
    };
    if single {
        out.node(&indices[0], Precedence::Atom);
    } else {
        out.str("{");
        match indices {
            [index] => out.script(index, Precedence::Sequence),
            several => out.script_list(several, ","),
        }
        out.str("}");
    }
}

fn accent_command(accent: Accent, body: &Expr) -> &'static str {
    let wide = match &body.kind {
        Kind::Number(value) => !value.numer().as_small().is_some_and(|x| (0..10).contains(&x)),
        Kind::Name(name) => name.chars().count() > 1 && !names::is_command(name),
        _ => true,
    };
    match (accent, wide) {
        (Accent::Hat, false) => "\\hat",
        (Accent::Hat, true) => "\\widehat",
        (Accent::Bar, false) => "\\bar",
        (Accent::Bar, true) => "\\overline",
        (Accent::Vec, false) => "\\vec",
        (Accent::Vec, true) => "\\overrightarrow",
        (Accent::Tilde, false) => "\\tilde",
        (Accent::Tilde, true) => "\\widetilde",
        (Accent::Dot, _) => "\\dot",
        (Accent::Ddot, _) => "\\ddot",
        (Accent::Bold, _) => "\\boldsymbol",
        (Accent::Script, _) => "\\mathcal",
        (Accent::Blackboard, _) => "\\mathbb",
    }
}

fn operator(op: BigOp) -> &'static str {
    match op {
        BigOp::Sum => "\\sum",
        BigOp::Product => "\\prod",
        BigOp::Max => "\\max",
        BigOp::Min => "\\min",
        BigOp::Union => "\\bigcup",
        BigOp::Intersection => "\\bigcap",
        BigOp::Limit => "\\lim",
    }
}

fn relation(rel: Rel, compact: bool) -> &'static str {
    match rel {
        Rel::Eq if compact => "=",
        Rel::Eq => " = ",
        Rel::Define => " := ",
        Rel::Ne => " \\ne ",
        Rel::Lt => " < ",
        Rel::Le => " \\le ",
        Rel::Gt => " > ",
        Rel::Ge => " \\ge ",
        Rel::Equiv => " \\equiv ",
        Rel::Approx => " \\approx ",
        Rel::In => " \\in ",
        Rel::NotIn => " \\notin ",
        Rel::Subset => " \\subseteq ",
        Rel::To => " \\to ",
        Rel::MapsTo => " \\mapsto ",
        Rel::Implies => " \\Rightarrow ",
        Rel::Iff => " \\Leftrightarrow ",
        Rel::Colon => " \\colon ",
        Rel::Other(sign) => relations::of(sign).map_or(" ", |sign| sign.latex),
    }
}

fn matrix<'a>(rows: &'a [Vec<Option<Expr>>], delimiter: Delimiter, out: &mut Pieces<'a>) {
    let (begin, end) = match delimiter {
        Delimiter::Paren => ("\\begin{pmatrix} ", " \\end{pmatrix}"),
        Delimiter::Bracket => ("\\begin{bmatrix} ", " \\end{bmatrix}"),
        Delimiter::Bar => ("\\begin{vmatrix} ", " \\end{vmatrix}"),
        Delimiter::None => ("\\begin{matrix} ", " \\end{matrix}"),
    };
    out.str(begin);
    for (i, row) in rows.iter().enumerate() {
        out.str(if i > 0 { " \\\\ " } else { "" });
        for (j, cell) in row.iter().enumerate() {
            out.str(if j > 0 { " & " } else { "" });
            out.list(cell, "", Precedence::Sequence);
        }
    }
    out.str(end);
}

/// `\frac{d^k}{dt^k}`, `\frac{\partial^{r+s}}{\partial u^r \partial v^s}`
fn derivative<'a>(partial: bool, variables: &'a [(Expr, Option<Expr>)], out: &mut Pieces<'a>) {
    let d = if partial { "\\partial" } else { "d" };
    out.str("\\frac{");
    out.str(d);
    match variables {
        [] | [(_, None)] => {}
        [(_, Some(order))] => script("^", std::slice::from_ref(order), out),
        several => {
            out.str("^{");
            for (i, (_, order)) in several.iter().enumerate() {
                out.str(if i > 0 { "+" } else { "" });
                match order {
                    Some(order) => out.script(order, Precedence::Product),
                    None => out.str("1"),
                }
            }
            out.str("}");
        }
    }
    out.str("}{");
    for (i, (variable, order)) in variables.iter().enumerate() {
        out.str(if i > 0 { " " } else { "" });
        out.str(d);
        out.node(variable, Precedence::Postfix);
        if let Some(order) = order {
            script("^", std::slice::from_ref(order), out);
        }
    }
    out.str("}");
}
