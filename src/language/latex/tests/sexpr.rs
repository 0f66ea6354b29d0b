//! Trees as short texts: `(+ a (- b))` for a − b.

use crate::formula::{Accent, BigOp, BinomialStyle, Delimiter, Enclosure, Expr, Kind, Quotient, Rel, Sign};

fn list(items: &[Expr]) -> String {
    items.iter().map(sexpr).collect::<Vec<_>>().join(" ")
}

fn optional(item: Option<&Expr>) -> String {
    item.map_or_else(|| "_".to_owned(), sexpr)
}

/// The tree in one line.
pub fn sexpr(expr: &Expr) -> String {
    match &expr.kind {
        Kind::Number(value) => value.to_string(),
        Kind::Name(name) => name.clone(),
        Kind::Subscript(base, indices) => format!("(_ {} {})", sexpr(base), list(indices)),
        Kind::Upper(base, indices) => format!("(upper {} {})", sexpr(base), list(indices)),
        Kind::Accent(accent, body) => {
            let name = if *accent == Accent::Blackboard { "bb" } else { accent.name() };
            format!("({name} {})", sexpr(body))
        }
        Kind::Prime(body, count) => format!("({} {})", "'".repeat(*count as usize), sexpr(body)),
        Kind::Add(terms) => {
            let terms: Vec<String> = terms
                .iter()
                .map(|term| match term.sign {
                    Sign::Plus => sexpr(&term.expr),
                    Sign::Minus => format!("(- {})", sexpr(&term.expr)),
                })
                .collect();
            format!("(+ {})", terms.join(" "))
        }
        Kind::Mul(factors) => format!("(* {})", list(factors)),
        Kind::Div(a, b, Quotient::Slash) => format!("(/ {} {})", sexpr(a), sexpr(b)),
        Kind::Div(a, b, Quotient::Fraction) => format!("(frac {} {})", sexpr(a), sexpr(b)),
        Kind::Pow(a, b) => format!("(^ {} {})", sexpr(a), sexpr(b)),
        Kind::Apply(callee, groups) => {
            let groups: Vec<String> = groups.iter().map(|group| list(group)).collect();
            format!("({}: {})", sexpr(callee), groups.join(" ; "))
        }
        Kind::Group(body) => format!("[{}]", sexpr(body)),
        Kind::Tuple(items) => format!("(tuple {})", list(items)),
        Kind::List(items) => format!("(list {})", list(items)),
        Kind::Set(items, None) => format!("(set {})", list(items)),
        Kind::Set(items, Some(condition)) => format!("(set {} | {})", list(items), sexpr(condition)),
        Kind::Matrix(rows, delimiter) => {
            let name = match delimiter {
                Delimiter::Paren => "pmatrix",
                Delimiter::Bracket => "bmatrix",
                Delimiter::Bar => "vmatrix",
                Delimiter::None => "matrix",
            };
            let row = |row: &Vec<Option<Expr>>| {
                row.iter().map(|cell| optional(cell.as_ref())).collect::<Vec<_>>().join(" ")
            };
            format!("({name} {})", rows.iter().map(row).collect::<Vec<_>>().join(" / "))
        }
        Kind::Binomial(n, k, BinomialStyle::Stacked) => format!("(binom {} {})", sexpr(n), sexpr(k)),
        Kind::Binomial(n, k, BinomialStyle::Subscripted) => format!("(C {} {})", sexpr(n), sexpr(k)),
        Kind::Factorial(body) => format!("(! {})", sexpr(body)),
        Kind::Enclosed(enclosure, body) => {
            let name = match enclosure {
                Enclosure::Abs => "abs",
                Enclosure::Norm => "norm",
                Enclosure::Floor => "floor",
                Enclosure::Ceil => "ceil",
            };
            format!("({name} {})", sexpr(body))
        }
        Kind::Big { op, lower, upper, body } => {
            let name = match op {
                BigOp::Sum => "sum",
                BigOp::Product => "prod",
                BigOp::Max => "max",
                BigOp::Min => "min",
                BigOp::Union => "union",
                BigOp::Intersection => "intersection",
                BigOp::Limit => "lim",
            };
            format!("({name} ({}) {} {})", list(lower), optional(upper.as_deref()), sexpr(body))
        }
        Kind::Integral { lower, upper, body, variable } => format!(
            "(int {} {} {} {})",
            optional(lower.as_deref()),
            optional(upper.as_deref()),
            sexpr(body),
            sexpr(variable)
        ),
        Kind::Derivative { partial, variables, body } => {
            let variables: Vec<String> = variables
                .iter()
                .map(|(variable, order)| match order {
                    None => sexpr(variable),
                    Some(order) => format!("{}^{}", sexpr(variable), sexpr(order)),
                })
                .collect();
            let name = if *partial { "∂" } else { "d" };
            format!("({name} ({}) {})", variables.join(" "), optional(body.as_deref()))
        }
        Kind::At { body, lower, upper } => {
            format!("(at {} ({}) {})", sexpr(body), list(lower), optional(upper.as_deref()))
        }
        Kind::Cases(cases) => {
            let cases: Vec<String> = cases
                .iter()
                .map(|(value, condition)| format!("{} if {}", sexpr(value), optional(condition.as_ref())))
                .collect();
            format!("(cases {})", cases.join(" / "))
        }
        Kind::Ellipsis => "…".to_owned(),
        Kind::Brace(items, label) => format!("(brace ({}) {})", list(items), optional(label.as_deref())),
        Kind::Compose(list_) => format!("(o {})", list(list_)),
        Kind::Cross(list_) => format!("(x {})", list(list_)),
        Kind::Transpose(body) => format!("(T {})", sexpr(body)),
        Kind::Range(a, b) => format!("(.. {} {})", sexpr(a), sexpr(b)),
        Kind::Lambda(parameters, body) => format!("(-> ({}) {})", list(parameters), sexpr(body)),
        Kind::Chain(first, links) => {
            let mut text = sexpr(first);
            for link in links {
                let other;
                let sign = match link.rel {
                    Rel::Eq => "=",
                    Rel::Define => ":=",
                    Rel::Ne => "≠",
                    Rel::Lt => "<",
                    Rel::Le => "≤",
                    Rel::Gt => ">",
                    Rel::Ge => "≥",
                    Rel::Equiv => "≡",
                    Rel::Approx => "≈",
                    Rel::In => "∈",
                    Rel::NotIn => "∉",
                    Rel::Subset => "⊆",
                    Rel::To => "→",
                    Rel::MapsTo => "↦",
                    Rel::Implies => "⇒",
                    Rel::Iff => "⇔",
                    Rel::Colon => ":",
                    Rel::Other(sign) => {
                        other = sign.to_string();
                        &other
                    }
                };
                text = format!("{text} {sign} {}", sexpr(&link.expr));
            }
            format!("({text})")
        }
        Kind::Sequence(items) => format!("(seq {})", list(items)),
        Kind::ForAll(bound, body) => format!("(all ({}) {})", list(bound), optional(body.as_deref())),
        Kind::Text(text) => format!("{text:?}"),
        Kind::Unread(text) => format!("<unread {text:?}>"),
    }
}
