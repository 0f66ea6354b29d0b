//! Python expressions for SymPy: `Rational(5, 3)*(t1 + t2)`.
//!
//! The text is meant for `from sympy import *` with the names in it declared as symbols
//! or functions: `t_1` is `t1`, `p_{1,2}` is `p_1_2`, and an index that is not a number
//! is that of an `IndexedBase`: `c[i]`. Python itself would divide integers into
//! floating-point numbers; therefore numeric quotients are `Rational`s, and where both
//! operands are made of integers only, the first is handed to SymPy: `sympify(2*3)/4`.

use std::fmt;

use num_traits::Signed;

use super::decimal;
use super::marks::Marks;
use super::names;
use super::plain::without_brackets;
use super::shape;
use super::walk::{Joint, Notation, Pieces, Tail, walk};
use crate::formula::{Accent, BigOp, Delimiter, Enclosure, Expr, Kind, Link, Precedence, Rel};

/// The formula as a Python expression for SymPy.
///
/// Cost: linear in the size of the tree.
///
/// # Errors
/// When SymPy has nothing that would mean the same, such as for `…` or `1̂`.
///
/// ```
/// use polarform::expr::{Expr, Kind};
/// let tree = Expr::product(vec![Expr::int(5).over(Expr::int(3)), Expr::indexed("t", 1).power(Expr::int(2))]);
/// assert_eq!(polarform::write::sympy(&tree).unwrap(), "Rational(5, 3)*t1**2");
/// let problem = polarform::write::sympy(&Kind::Ellipsis.into()).unwrap_err();
/// assert_eq!(problem.to_string(), "SymPy has nothing for an ellipsis");
/// ```
pub fn sympy(expr: &Expr) -> Result<String, WriteError> {
    let mut text = String::new();
    write_sympy(&mut text, expr)?;
    Ok(text)
}

/// Writes what [`sympy()`] returns into `out`, up to the place of the error if there is one.
///
/// # Errors
/// Those of [`sympy()`] and of `out`.
pub fn write_sympy(out: &mut dyn fmt::Write, expr: &Expr) -> Result<(), WriteError> {
    let notation = Sympy {
        symbolic: Marks::everywhere(expr, is_sympy_value),
        chains: Marks::everywhere(
            expr,
            |expr| matches!(&expr.kind, Kind::Chain(_, links) if links.len() > 1),
        ),
    };
    walk(&notation, expr, Precedence::Sequence, out)
}

/// Why a formula cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WriteError {
    /// The notation has nothing that would mean the same as this, which is named with its article.
    NotSupported(&'static str),
    /// The output did not take the text.
    Output,
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WriteError::NotSupported(what) => write!(f, "SymPy has nothing for {what}"),
            WriteError::Output => f.write_str("the output could not be written"),
        }
    }
}

impl std::error::Error for WriteError {}

impl From<fmt::Error> for WriteError {
    fn from(_: fmt::Error) -> Self {
        WriteError::Output
    }
}

use WriteError::NotSupported;

struct Sympy {
    /// What holds a value of SymPy, not only Python integers.
    symbolic: Marks,
    /// What holds a chain of several relations, whose middle sides are printed twice.
    chains: Marks,
}

/// Whether the node makes a value of SymPy out of whatever is in it.
fn is_sympy_value(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(value) => !value.is_integer(),
        Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..) | Kind::Group(_) => false,
        _ => true,
    }
}

/// Whether the node is an integer, perhaps in parentheses.
fn is_integer(mut expr: &Expr) -> bool {
    while let Kind::Group(inner) = &expr.kind {
        expr = inner;
    }
    matches!(&expr.kind, Kind::Number(value) if value.is_integer())
}

fn is_natural(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Number(value) if value.is_integer() && !value.is_negative())
}

impl Notation for Sympy {
    type Error = WriteError;

    fn level(&self, expr: &Expr) -> Precedence {
        match &expr.kind {
            Kind::Number(value) if value.is_integer() => decimal::level(value),
            Kind::Div(above, below, _) if !(is_integer(above) && is_integer(below)) => Precedence::Product,
            Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..) => expr.precedence(),
            // all others are names, calls or in brackets
            _ => Precedence::Atom,
        }
    }

    fn between(&self, joint: Joint, _: &Tail, _: &str) -> &'static str {
        match joint {
            Joint::Adjacent => "",
            Joint::Times { .. } => "*",
        }
    }

    fn expand<'a>(&self, expr: &'a Expr, out: &mut Pieces<'a>) -> Result<(), WriteError> {
        use Precedence::{Postfix, Power, Sequence, Sum};
        match &expr.kind {
            Kind::Number(value) if value.is_integer() => out.string(value.numer().to_string()),
            Kind::Number(value) => out.string(format!("Rational({}, {})", value.numer(), value.denom())),
            Kind::Name(name) if name == "infty" => out.str("oo"),
            Kind::Name(_) => out.string(identifier(expr)?),
            Kind::Subscript(base, indices) => match identifier(expr) {
                Ok(name) => out.string(name),
                Err(problem) => {
                    if !matches!(base.kind, Kind::Name(_) | Kind::Accent(..)) {
                        return Err(problem);
                    }
                    out.string(identifier(base)?);
                    out.str("[");
                    out.list(without_brackets(indices), ", ", Sum);
                    out.str("]");
                }
            },
            Kind::Upper(..) => return Err(NotSupported("an upper index")),
            Kind::Accent(..) => out.string(identifier(expr)?),
            Kind::Prime(..) => return Err(NotSupported("a derivative without its argument")),
            Kind::Add(terms) => shape::sum(terms, None, out),
            Kind::Mul(factors) => shape::product(factors, None, out, |_| false, |_, _| false),
            Kind::Div(above, below, _) => self.quotient(above, below, out),
            Kind::Pow(base, exponent) => {
                // Python's 2**(-1) is a floating-point number
                if self.symbolic.has(base) || self.symbolic.has(exponent) || is_natural(exponent) {
                    out.node(base, Postfix);
                } else {
                    exact(base, out);
                }
                out.str("**");
                out.node(exponent, Power);
            }
            Kind::Apply(callee, groups) => self.apply(callee, groups, out)?,
            Kind::Group(body) => out.wrapped("(", body, ")"),
            Kind::Tuple(items) | Kind::Sequence(items) => {
                out.str("(");
                out.list(items, ", ", Sequence);
                out.str(if items.len() == 1 { ",)" } else { ")" });
            }
            Kind::List(items) => {
                out.str("[");
                out.list(items, ", ", Sequence);
                out.str("]");
            }
            Kind::Set(items, None) => call("FiniteSet", items, out),
            Kind::Set(items, Some(condition)) => match items.as_slice() {
                [name @ Expr { kind: Kind::Name(_), .. }] => call("ConditionSet", [name, &**condition], out),
                _ => return Err(NotSupported("a set of this form")),
            },
            Kind::Matrix(rows, delimiter) => matrix(rows, *delimiter, out)?,
            Kind::Binomial(n, k, _) => call("binomial", [&**n, &**k], out),
            Kind::Factorial(body) => call("factorial", [&**body], out),
            Kind::Enclosed(enclosure, body) => {
                let name = match enclosure {
                    Enclosure::Abs => "Abs",
                    Enclosure::Floor => "floor",
                    Enclosure::Ceil => "ceiling",
                    Enclosure::Norm => return Err(NotSupported("a norm")),
                };
                call(name, [&**body], out);
            }
            Kind::Big { op, lower, upper, body } => big(*op, lower, upper.as_deref(), body, out)?,
            Kind::Integral { lower, upper, body, variable } => {
                let bounds: Vec<&Expr> = match (lower, upper) {
                    (None, None) => vec![variable],
                    (Some(lower), Some(upper)) => vec![variable, lower, upper],
                    _ => return Err(NotSupported("an integral with one bound")),
                };
                out.str("Integral(");
                out.node(body, Sequence);
                out.str(", ");
                if bounds.len() == 1 {
                    out.node(variable, Sequence)
                } else {
                    call("", bounds, out)
                }
                out.str(")");
            }
            Kind::Derivative { body: None, .. } => return Err(NotSupported("a derivative of nothing")),
            Kind::Derivative { variables, body: Some(body), .. } => {
                out.str("Derivative(");
                out.node(body, Sequence);
                for (variable, order) in variables {
                    out.str(", ");
                    match order {
                        Some(order) => call("", [variable, order], out),
                        None => out.node(variable, Sequence),
                    }
                }
                out.str(")");
            }
            Kind::At { body, lower, upper } => at(body, lower, upper.as_deref(), out)?,
            Kind::Cases(cases) => {
                out.str("Piecewise(");
                for (i, (value, condition)) in cases.iter().enumerate() {
                    out.str(if i > 0 { ", (" } else { "(" });
                    out.node(value, Sequence);
                    out.str(", ");
                    match condition {
                        Some(condition) => out.node(condition, Sequence),
                        None => out.str("True"),
                    }
                    out.str(")");
                }
                out.str(")");
            }
            Kind::Ellipsis => return Err(NotSupported("an ellipsis")),
            Kind::Brace(..) => return Err(NotSupported("an underbrace")),
            Kind::Compose(_) => return Err(NotSupported("a composition without its argument")),
            Kind::Cross(_) => return Err(NotSupported("a cross product")),
            Kind::Transpose(body) => call("Transpose", [&**body], out),
            Kind::Range(low, high) => {
                out.str("Range(");
                out.node(low, Sequence);
                out.str(", ");
                out.node(high, Sum);
                out.str(" + 1)");
            }
            Kind::Lambda(parameters, body) => {
                out.str("Lambda(");
                match parameters.as_slice() {
                    [single] => out.node(single, Sequence),
                    several => call("", several, out),
                }
                out.str(", ");
                out.node(body, Sequence);
                out.str(")");
            }
            Kind::Chain(first, links) => self.chain(first, links, out)?,
            Kind::ForAll(..) => return Err(NotSupported("a statement for all values")),
            Kind::Text(_) => return Err(NotSupported("words")),
            Kind::Unread(_) => return Err(NotSupported("a piece that could not be read")),
        }
        Ok(())
    }
}

impl Sympy {
    fn quotient<'a>(&self, above: &'a Expr, below: &'a Expr, out: &mut Pieces<'a>) {
        if is_integer(above) && is_integer(below) {
            return call("Rational", [above, below].map(ungrouped), out);
        }
        if self.symbolic.has(above) || self.symbolic.has(below) {
            shape::slash(above, below, out, |_| false);
        } else {
            exact(above, out);
            out.str("/");
            out.node(below, Precedence::Compose);
        }
    }

    fn apply<'a>(
        &self,
        callee: &'a Expr,
        groups: &'a [Vec<Expr>],
        out: &mut Pieces<'a>,
    ) -> Result<(), WriteError> {
        let callee = ungrouped(callee);
        match &callee.kind {
            Kind::Name(_) | Kind::Accent(..) => out.string(identifier(callee)?),
            Kind::Subscript(..) => {
                let name = identifier(callee);
                out.string(name.map_err(|_| NotSupported("a function with an index that is no number"))?);
            }
            Kind::Lambda(..) => out.node(callee, Precedence::Postfix),
            Kind::Compose(functions) => {
                for (i, function) in functions.iter().enumerate() {
                    out.str(if i > 0 { "(" } else { "" });
                    out.string(identifier(function)?);
                }
                arguments(groups, out);
                for _ in 1..functions.len() {
                    out.str(")");
                }
                return Ok(());
            }
            Kind::Prime(function, order) => {
                let [argument] = groups.iter().flatten().collect::<Vec<_>>()[..] else {
                    return Err(NotSupported("a prime on a function of several arguments"));
                };
                return prime(function, *order, argument, out);
            }
            _ => return Err(NotSupported("a call of this form")),
        }
        arguments(groups, out);
        Ok(())
    }

    /// `Eq(a, b)`, and `And(…)` of these for a longer chain.
    fn chain<'a>(&self, first: &'a Expr, links: &'a [Link], out: &mut Pieces<'a>) -> Result<(), WriteError> {
        let several = links.len() > 1;
        out.str(if several { "And(" } else { "" });
        let mut left = first;
        for (i, link) in links.iter().enumerate() {
            // Printing twice at each level would take exponential time.
            if i > 0 && self.chains.has(left) {
                return Err(NotSupported("a chain of relations inside another"));
            }
            out.str(if i > 0 { ", " } else { "" });
            call(relation(link.rel)?, [left, &link.expr], out);
            left = &link.expr;
        }
        out.str(if several { ")" } else { "" });
        Ok(())
    }
}

/// Python's integers as a number of SymPy.
fn exact<'a>(expr: &'a Expr, out: &mut Pieces<'a>) {
    out.wrapped(if is_integer(expr) { "Integer(" } else { "sympify(" }, ungrouped(expr), ")");
}

fn ungrouped(mut expr: &Expr) -> &Expr {
    while let Kind::Group(inner) = &expr.kind {
        expr = inner;
    }
    expr
}

fn arguments<'a>(groups: &'a [Vec<Expr>], out: &mut Pieces<'a>) {
    call("", groups.iter().flatten(), out);
}

fn call<'a>(name: &'static str, items: impl IntoIterator<Item = &'a Expr>, out: &mut Pieces<'a>) {
    out.str(name);
    out.str("(");
    out.list(items, ", ", Precedence::Sequence);
    out.str(")");
}

/// The name of a variable or function.
fn identifier(expr: &Expr) -> Result<String, WriteError> {
    match &expr.kind {
        Kind::Name(name) => Ok(names::identifier(name)),
        Kind::Accent(accent, body) => {
            let Kind::Name(name) = &body.kind else {
                return Err(NotSupported("an accent on what is no name"));
            };
            let mark = match accent {
                Accent::Hat => "_hat",
                Accent::Bar => "_bar",
                Accent::Vec => "_vec",
                Accent::Tilde => "_tilde",
                Accent::Bold | Accent::Script | Accent::Blackboard => "",
                Accent::Dot | Accent::Ddot => return Err(NotSupported("a derivative without its argument")),
            };
            Ok(names::identifier(&format!("{name}{mark}")))
        }
        Kind::Subscript(base, indices) => {
            let (Kind::Name(_) | Kind::Accent(..)) = &base.kind else {
                return Err(NotSupported("an index on what is no name"));
            };
            let mut name = match &base.kind {
                Kind::Name(name) => name.clone(), // lambda_1 is no keyword
                _ => identifier(base)?,
            };
            let indices = without_brackets(indices);
            let several = indices.len() > 1;
            for index in indices {
                name.push_str(if several { "_" } else { "" });
                match &index.kind {
                    Kind::Number(value) if is_natural(index) => name.push_str(&value.numer().to_string()),
                    Kind::Name(digits) if digits.bytes().all(|b| b.is_ascii_digit()) => name.push_str(digits),
                    _ => return Err(NotSupported("an index that is no number")),
                }
            }
            Ok(names::identifier(&name))
        }
        _ => Err(NotSupported("a call of this form")),
    }
}

fn matrix<'a>(
    rows: &'a [Vec<Option<Expr>>],
    delimiter: Delimiter,
    out: &mut Pieces<'a>,
) -> Result<(), WriteError> {
    if rows.windows(2).any(|pair| pair[0].len() != pair[1].len()) {
        return Err(NotSupported("a matrix with rows of different lengths"));
    }
    out.str(if delimiter == Delimiter::Bar { "det(Matrix([" } else { "Matrix([" });
    for (i, row) in rows.iter().enumerate() {
        out.str(if i > 0 { ", [" } else { "[" });
        for (j, cell) in row.iter().enumerate() {
            out.str(if j > 0 { ", " } else { "" });
            let cell = cell.as_ref().ok_or(NotSupported("an empty cell of a matrix"))?;
            out.node(cell, Precedence::Sequence);
        }
        out.str("]");
    }
    out.str(if delimiter == Delimiter::Bar { "]))" } else { "])" });
    Ok(())
}

fn big<'a>(
    op: BigOp,
    lower: &'a [Expr],
    upper: Option<&'a Expr>,
    body: &'a Expr,
    out: &mut Pieces<'a>,
) -> Result<(), WriteError> {
    let name = match op {
        BigOp::Sum => "Sum(",
        BigOp::Product => "Product(",
        BigOp::Limit => match lower {
            [Expr { kind: Kind::Chain(variable, links), .. }] if upper.is_none() => match links.as_slice() {
                [Link { rel: Rel::To, expr: limit, .. }] => {
                    // from both sides, which is not SymPy's default
                    out.str("Limit(");
                    out.list([body, &**variable, limit], ", ", Precedence::Sequence);
                    out.str(", '+-')");
                    return Ok(());
                }
                _ => return Err(NotSupported("a limit of this form")),
            },
            _ => return Err(NotSupported("a limit of this form")),
        },
        BigOp::Max | BigOp::Min => return Err(NotSupported("a maximum or minimum over a range")),
        BigOp::Union | BigOp::Intersection => {
            return Err(NotSupported("a union or intersection over a range"));
        }
    };
    match shape::bounds(lower, upper) {
        Some((index, low, high, [])) => {
            out.str(name);
            out.node(body, Precedence::Sequence);
            out.str(", ");
            call("", [index, low, high], out);
            out.str(")");
            Ok(())
        }
        _ => Err(NotSupported("a sum or product that is not over an integer range")),
    }
}

/// `Subs(body, t, 0)`
fn at<'a>(
    body: &'a Expr,
    lower: &'a [Expr],
    upper: Option<&'a Expr>,
    out: &mut Pieces<'a>,
) -> Result<(), WriteError> {
    let mut variables = Vec::with_capacity(lower.len());
    let mut values = Vec::with_capacity(lower.len());
    for relation in lower {
        match &relation.kind {
            Kind::Chain(variable, links) => match links.as_slice() {
                [Link { rel: Rel::Eq, expr: value, .. }] => {
                    variables.push(&**variable);
                    values.push(value);
                }
                _ => return Err(NotSupported("a value at a place of this form")),
            },
            _ => return Err(NotSupported("a value at a place of this form")),
        }
    }
    if upper.is_some() {
        return Err(NotSupported("a difference of values"));
    }
    out.str("Subs(");
    out.node(body, Precedence::Sequence);
    for list in [variables, values] {
        out.str(", ");
        match list[..] {
            [single] => out.node(single, Precedence::Sequence),
            _ => call("", list, out),
        }
    }
    out.str(")");
    Ok(())
}

/// `F''(t)` is `Derivative(F(t), (t, 2))`; at anything but a variable, it is put in afterwards.
fn prime<'a>(
    function: &'a Expr,
    order: u32,
    argument: &'a Expr,
    out: &mut Pieces<'a>,
) -> Result<(), WriteError> {
    let function = identifier(function)?;
    let name = match identifier(argument) {
        Ok(name) => name,
        Err(_) => "Symbol('x')".to_owned(),
    };
    let derivative = if order == 1 {
        format!("Derivative({function}({name}), {name})")
    } else {
        format!("Derivative({function}({name}), ({name}, {order}))")
    };
    if identifier(argument).is_ok() {
        out.string(derivative);
    } else {
        out.string(format!("Subs({derivative}, {name}, "));
        out.node(argument, Precedence::Sequence);
        out.str(")");
    }
    Ok(())
}

fn relation(rel: Rel) -> Result<&'static str, WriteError> {
    Ok(match rel {
        Rel::Eq | Rel::Define => "Eq",
        Rel::Ne => "Ne",
        Rel::Lt => "Lt",
        Rel::Le => "Le",
        Rel::Gt => "Gt",
        Rel::Ge => "Ge",
        Rel::In => "Contains",
        Rel::Implies => "Implies",
        Rel::Iff => "Equivalent",
        Rel::Equiv
        | Rel::Approx
        | Rel::NotIn
        | Rel::Subset
        | Rel::To
        | Rel::MapsTo
        | Rel::Colon
        | Rel::Other(_) => return Err(NotSupported("this relation")),
    })
}
