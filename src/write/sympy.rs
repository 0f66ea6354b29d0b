//! Python expressions for SymPy, so that others can check us.

use std::fmt;

use crate::expr::{Accent, BigOp, Enclosure, Expr, Kind, Precedence, Rel, Sign};

/// A construct that SymPy has no expression for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotExpressible(pub &'static str);

impl fmt::Display for NotExpressible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SymPy has no expression for {}", self.0)
    }
}

impl std::error::Error for NotExpressible {}

/// The formula as a Python expression; quotients of numbers are `Rational(p, q)`.
///
/// # Errors
/// [`NotExpressible`] names the construct that has no counterpart.
///
/// ```
/// use polarform::{syntax::parse, write::sympy};
/// let formula = parse("5/3 (t_1 + t_2)^2").unwrap();
/// assert_eq!(sympy(&formula).unwrap(), "Rational(5, 3)*(t1 + t2)**2");
/// ```
pub fn sympy(expr: &Expr) -> Result<String, NotExpressible> {
    let mut writer = Sympy { out: String::new() };
    writer.write(expr, Precedence::Sequence)?;
    Ok(writer.out)
}

type Written = Result<(), NotExpressible>;

struct Sympy {
    out: String,
}

const KEYWORDS: &[&str] =
    &["lambda", "in", "is", "as", "if", "or", "and", "not", "for", "def", "del", "from", "with", "pass"];

/// A name as a Python identifier: t1, c0, p_1_2, lambda_.
pub(super) fn identifier(expr: &Expr) -> Result<String, NotExpressible> {
    let not_a_name = NotExpressible("an index that is not a name or number");
    let part = |expr: &Expr| -> Result<String, NotExpressible> {
        match &expr.kind {
            Kind::Number(q) if q.is_integer() => Ok(q.numer().to_string().replace('-', "m")),
            _ => identifier(expr),
        }
    };
    match &expr.kind {
        Kind::Name(name) => {
            let safe: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
            Ok(if KEYWORDS.contains(&safe.as_str()) { safe + "_" } else { safe })
        }
        Kind::Subscript(base, indices) | Kind::Upper(base, indices) => {
            let mut name = identifier(base)?;
            let simple = matches!((&expr.kind, indices.as_slice()),
                (Kind::Subscript(..), [one]) if matches!(one.kind, Kind::Number(_)));
            for index in indices {
                if !simple {
                    name.push('_');
                }
                name.push_str(&part(index)?);
            }
            Ok(name)
        }
        Kind::Accent(Accent::Bold, body) => identifier(body),
        Kind::Accent(accent, body) => Ok(format!("{}_{accent:?}", identifier(body)?).to_lowercase()),
        _ => Err(not_a_name),
    }
}

impl Sympy {
    fn push(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn write(&mut self, expr: &Expr, context: Precedence) -> Written {
        let own = match &expr.kind {
            Kind::Group(_) => return self.bracketed(expr),
            Kind::Number(_) | Kind::Binomial(..) | Kind::Factorial(_) | Kind::Prime(..) => Precedence::Atom,
            Kind::Big { .. } | Kind::Integral { .. } | Kind::Derivative { .. } => Precedence::Atom,
            Kind::Div(a, b, _) if whole(a).is_some() && whole(b).is_some() => Precedence::Atom,
            _ => expr.precedence(),
        };
        if own < context { self.bracketed(expr) } else { self.inner(expr) }
    }

    fn bracketed(&mut self, expr: &Expr) -> Written {
        self.push("(");
        match &expr.kind {
            Kind::Group(body) => self.write(body, Precedence::Relation)?,
            _ => self.inner(expr)?,
        }
        self.push(")");
        Ok(())
    }

    fn call(&mut self, name: &str, items: &[&Expr]) -> Written {
        self.push(name);
        self.push("(");
        self.list(items.iter().copied())?;
        self.push(")");
        Ok(())
    }

    fn list<'a>(&mut self, items: impl IntoIterator<Item = &'a Expr>) -> Written {
        for (i, item) in items.into_iter().enumerate() {
            if i > 0 {
                self.push(", ");
            }
            self.write(item, Precedence::Relation)?;
        }
        Ok(())
    }

    fn inner(&mut self, expr: &Expr) -> Written {
        match &expr.kind {
            Kind::Number(q) if q.is_integer() => self.push(&q.numer().to_string()),
            Kind::Number(q) => self.push(&format!("Rational({}, {})", q.numer(), q.denom())),
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) => {
                let name = identifier(expr)?;
                self.push(&name);
            }
            Kind::Accent(Accent::Hat, _) => return Err(NotExpressible("a vector argument")),
            Kind::Accent(..) => {
                let name = identifier(expr)?;
                self.push(&name);
            }
            Kind::Add(terms) => {
                for (i, term) in terms.iter().enumerate() {
                    self.push(match (i, term.sign) {
                        (0, Sign::Plus) => "",
                        (0, Sign::Minus) => "-",
                        (_, Sign::Plus) => " + ",
                        (_, Sign::Minus) => " - ",
                    });
                    self.write(&term.expr, Precedence::Product)?;
                }
            }
            Kind::Mul(factors) => {
                for (i, factor) in factors.iter().enumerate() {
                    if i > 0 {
                        self.push("*");
                    }
                    self.write(factor, if i == 0 { Precedence::Product } else { Precedence::Compose })?;
                }
            }
            Kind::Div(a, b, _) => {
                if let (Some(p), Some(q)) = (whole(a), whole(b)) {
                    self.push(&format!("Rational({p}, {q})"));
                } else {
                    self.write(a, Precedence::Product)?;
                    self.push("/");
                    // Integers divided by integers would be a float in Python.
                    self.write(b, Precedence::Compose)?;
                }
            }
            Kind::Pow(base, exponent) => {
                match whole(base) {
                    // 2**-1 of plain integers would be a float in Python.
                    Some(base) => self.push(&format!("Integer({base})")),
                    None => self.write(base, Precedence::Postfix)?,
                }
                self.push("**");
                self.write(exponent, Precedence::Postfix)?;
            }
            Kind::Apply(callee, groups) => {
                let name = identifier(callee)?;
                let items: Vec<&Expr> = groups.iter().flatten().collect();
                self.call(&name, &items)?;
            }
            Kind::Group(_) => self.bracketed(expr)?,
            Kind::Tuple(items) => {
                self.push("(");
                self.list(items)?;
                self.push(if items.len() == 1 { ",)" } else { ")" });
            }
            Kind::List(items) | Kind::Sequence(items) => {
                self.push("[");
                self.list(items)?;
                self.push("]");
            }
            Kind::Matrix(rows, _) => {
                self.push("Matrix([");
                for (i, row) in rows.iter().enumerate() {
                    self.push(if i > 0 { ", [" } else { "[" });
                    let cells: Option<Vec<&Expr>> = row.iter().map(Option::as_ref).collect();
                    self.list(cells.ok_or(NotExpressible("an empty cell"))?)?;
                    self.push("]");
                }
                self.push("])");
            }
            Kind::Binomial(n, k, _) => self.call("binomial", &[n, k])?,
            Kind::Factorial(body) => self.call("factorial", &[body])?,
            Kind::Enclosed(enclosure, body) => {
                let name = match enclosure {
                    Enclosure::Abs => "Abs",
                    Enclosure::Floor => "floor",
                    Enclosure::Ceil => "ceiling",
                    Enclosure::Norm => return Err(NotExpressible("a norm")),
                };
                self.call(name, &[body])?;
            }
            Kind::Big { op: op @ (BigOp::Sum | BigOp::Product), lower, upper: Some(upper), body } => {
                let [Expr { kind: Kind::Chain(index, links), .. }] = lower.as_slice() else {
                    return Err(NotExpressible("a sum over a set"));
                };
                let [link] = links.as_slice() else { return Err(NotExpressible("a sum over a set")) };
                self.push(if *op == BigOp::Sum { "Sum(" } else { "Product(" });
                self.write(body, Precedence::Relation)?;
                self.push(", (");
                self.list([index.as_ref(), &link.expr, upper])?;
                self.push("))");
            }
            Kind::Integral { lower, upper, body, variable } => {
                self.push("Integral(");
                self.write(body, Precedence::Relation)?;
                self.push(", ");
                match (lower, upper) {
                    (Some(lower), Some(upper)) => {
                        self.push("(");
                        self.list([variable.as_ref(), lower, upper])?;
                        self.push(")");
                    }
                    _ => self.write(variable, Precedence::Relation)?,
                }
                self.push(")");
            }
            Kind::Derivative { variables, body: Some(body), .. } => {
                self.push("Derivative(");
                self.write(body, Precedence::Relation)?;
                for (variable, order) in variables {
                    self.push(", (");
                    self.write(variable, Precedence::Relation)?;
                    self.push(", ");
                    match order {
                        Some(order) => self.write(order, Precedence::Relation)?,
                        None => self.push("1"),
                    }
                    self.push(")");
                }
                self.push(")");
            }
            Kind::Transpose(body) => {
                self.write(body, Precedence::Postfix)?;
                self.push(".T");
            }
            Kind::Lambda(parameters, body) => {
                self.push("Lambda((");
                self.list(parameters)?;
                self.push(",), ");
                self.write(body, Precedence::Relation)?;
                self.push(")");
            }
            Kind::Chain(first, links) => {
                let [link] = links.as_slice() else { return Err(NotExpressible("a chain of relations")) };
                let name = match link.rel {
                    Rel::Eq | Rel::Define => "Eq",
                    Rel::Ne => "Ne",
                    Rel::Lt => "Lt",
                    Rel::Le => "Le",
                    Rel::Gt => "Gt",
                    Rel::Ge => "Ge",
                    _ => return Err(NotExpressible("this relation")),
                };
                self.call(name, &[first, &link.expr])?;
            }
            Kind::Text(words) => self.push(&format!("{words:?}")),
            Kind::Prime(..) => return Err(NotExpressible("a prime")),
            Kind::Set(..) => return Err(NotExpressible("a set")),
            Kind::Big { .. } => return Err(NotExpressible("this kind of sum")),
            Kind::Derivative { .. } => return Err(NotExpressible("a bare differential operator")),
            Kind::At { .. } => return Err(NotExpressible("an evaluation bar")),
            Kind::Cases(_) => return Err(NotExpressible("cases")),
            Kind::Ellipsis | Kind::Brace(..) => return Err(NotExpressible("an ellipsis")),
            Kind::Compose(_) => return Err(NotExpressible("a composition")),
            Kind::Cross(_) => return Err(NotExpressible("a cross product")),
            Kind::Range(..) => return Err(NotExpressible("a range")),
            Kind::ForAll(..) => return Err(NotExpressible("a quantifier")),
            Kind::Unread(_) => return Err(NotExpressible("an unread piece")),
        }
        Ok(())
    }
}

/// A literal integer.
fn whole(expr: &Expr) -> Option<String> {
    match &expr.kind {
        Kind::Number(q) if q.is_integer() => Some(q.numer().to_string()),
        _ => None,
    }
}
