//! LaTeX for amsmath and KaTeX.

use super::digits;
use crate::expr::{
    Accent, BigOp, BinomialStyle, Delimiter, Enclosure, Expr, Kind, Precedence, Quotient, Rel, Sign,
};

/// The formula as LaTeX (without surrounding dollars).
///
/// ```
/// use polarform::{syntax::parse, write::latex};
/// let formula = parse("5/3 (t_1 + t_2)").unwrap();
/// assert_eq!(latex(&formula), r"5/3 (t_1 + t_2)");
/// ```
pub fn latex(expr: &Expr) -> String {
    let mut writer = Latex { out: String::new() };
    writer.write(expr, Precedence::Sequence);
    writer.out
}

struct Latex {
    out: String,
}

/// Precedence in LaTeX: fractions hold together by themselves.
fn precedence(expr: &Expr) -> Precedence {
    match &expr.kind {
        Kind::Div(_, _, Quotient::Fraction) => Precedence::Postfix,
        Kind::Number(q) if !q.is_integer() && !num_traits::Signed::is_negative(q) => Precedence::Postfix,
        _ => expr.precedence(),
    }
}

/// Content that deserves brackets of its own height.
fn is_tall(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Div(_, _, Quotient::Fraction)
        | Kind::Matrix(..)
        | Kind::Big { .. }
        | Kind::Integral { .. }
        | Kind::Cases(_)
        | Kind::Derivative { .. }
        | Kind::Binomial(..) => true,
        Kind::Number(q) => !q.is_integer(),
        Kind::Subscript(..) | Kind::Upper(..) | Kind::Name(_) => false,
        _ => {
            let mut tall = false;
            expr.for_each_child(&mut |child| tall = tall || is_tall(child));
            tall
        }
    }
}

fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                out.push('\\');
                out.push(c);
            }
            '^' => out.push_str("\\textasciicircum{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            _ => out.push(c),
        }
    }
    out
}

impl Latex {
    fn push(&mut self, text: &str) {
        // A command must not run into a following letter.
        if text.starts_with(|c: char| c.is_ascii_alphabetic()) {
            let word = self.out.rfind(|c: char| !c.is_ascii_alphabetic());
            if let Some(at) = word
                && self.out[at..].starts_with('\\')
                && self.out.len() > at + 1
            {
                self.out.push(' ');
            }
        }
        self.out.push_str(text);
    }

    fn write(&mut self, expr: &Expr, context: Precedence) {
        if precedence(expr) < context {
            self.bracketed(expr);
        } else {
            self.inner(expr);
        }
    }

    fn bracketed(&mut self, expr: &Expr) {
        let tall = is_tall(expr);
        self.push(if tall { "\\left(" } else { "(" });
        self.write(expr, Precedence::Relation);
        self.push(if tall { "\\right)" } else { ")" });
    }

    fn list<'a>(&mut self, items: impl IntoIterator<Item = &'a Expr>, separator: &str) {
        for (i, item) in items.into_iter().enumerate() {
            if i > 0 {
                self.push(separator);
            }
            match item.kind {
                Kind::Ellipsis => self.push("\\ldots"),
                _ => self.write(item, Precedence::Relation),
            }
        }
    }

    /// In braces unless it is a single token.
    fn script(&mut self, mark: &str, items: &[Expr]) {
        self.push(mark);
        let start = self.out.len();
        self.list(items, ",");
        let written = &self.out[start..];
        let command =
            written.strip_prefix('\\').is_some_and(|rest| rest.chars().all(|c| c.is_ascii_alphabetic()));
        if written.chars().count() != 1 && !command {
            self.out.insert(start, '{');
            self.out.push('}');
        }
    }

    fn inner(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Number(q) if q.is_integer() => self.push(&q.to_string()),
            Kind::Number(q) => {
                let sign = if num_traits::Signed::is_negative(q) { "-" } else { "" };
                let magnitude = num_traits::Signed::abs(q.numer());
                self.push(&format!("{sign}\\frac{{{magnitude}}}{{{}}}", q.denom()));
            }
            Kind::Name(name) => self.name(name),
            Kind::Subscript(base, indices) => {
                self.write(base, Precedence::Postfix);
                self.script("_", indices);
            }
            Kind::Upper(base, indices) => {
                self.write(base, Precedence::Postfix);
                self.push("^{(");
                self.list(indices, ",");
                self.push(")}");
            }
            Kind::Accent(accent, body) => {
                self.push(match accent {
                    Accent::Hat => "\\hat{",
                    Accent::Bar => "\\bar{",
                    Accent::Vec => "\\vec{",
                    Accent::Tilde => "\\tilde{",
                    Accent::Dot => "\\dot{",
                    Accent::Ddot => "\\ddot{",
                    Accent::Bold => "\\boldsymbol{",
                    Accent::Script => "\\mathcal{",
                    Accent::Blackboard => "\\mathbb{",
                });
                self.write(body, Precedence::Sequence);
                self.push("}");
            }
            Kind::Prime(body, order) => {
                self.write(body, Precedence::Postfix);
                self.push(&"'".repeat(*order as usize));
            }
            Kind::Add(terms) => {
                for (i, term) in terms.iter().enumerate() {
                    match (i, term.sign) {
                        (0, Sign::Plus) if terms.len() > 1 => {}
                        (0, Sign::Plus) => self.push("+"),
                        (0, Sign::Minus) => self.push("-"),
                        (_, Sign::Plus) => self.push(" + "),
                        (_, Sign::Minus) => self.push(" - "),
                    }
                    match term.expr.kind {
                        Kind::Ellipsis => self.push("\\cdots"),
                        _ => self.write(&term.expr, Precedence::Product),
                    }
                }
            }
            Kind::Mul(factors) => self.product(factors),
            Kind::Div(left, right, Quotient::Fraction) => {
                self.push("\\frac{");
                self.write(left, Precedence::Relation);
                self.push("}{");
                self.write(right, Precedence::Relation);
                self.push("}");
            }
            Kind::Div(left, right, Quotient::Slash) => {
                self.write(left, Precedence::Product);
                self.push("/");
                self.write(right, Precedence::Compose);
            }
            Kind::Pow(base, exponent) => {
                match base.kind {
                    Kind::Div(_, _, Quotient::Fraction) | Kind::Prime(..) => self.bracketed(base),
                    Kind::Number(ref q) if !q.is_integer() => self.bracketed(base),
                    _ => self.write(base, Precedence::Postfix),
                }
                self.script("^", std::slice::from_ref(exponent));
            }
            Kind::Apply(callee, groups) => {
                let plain_root = matches!(&callee.kind, Kind::Name(name) if name == "sqrt");
                if let (true, [group]) = (plain_root, groups.as_slice())
                    && let [radicand] = group.as_slice()
                {
                    self.push("\\sqrt{");
                    self.write(radicand, Precedence::Relation);
                    return self.push("}");
                }
                self.write(callee, Precedence::Power);
                let tall = groups.iter().flatten().any(is_tall);
                self.push(if tall { "\\left(" } else { "(" });
                for (i, group) in groups.iter().enumerate() {
                    if i > 0 {
                        self.push("; ");
                    }
                    self.list(group, ", ");
                }
                self.push(if tall { "\\right)" } else { ")" });
            }
            Kind::Group(body) => self.bracketed(body),
            Kind::Tuple(items) => self.enclosed("(", items, ")"),
            Kind::List(items) => self.enclosed("[", items, "]"),
            Kind::Set(items, condition) => {
                self.push("\\{");
                self.list(items, ", ");
                if let Some(condition) = condition {
                    self.push(" \\mid ");
                    self.write(condition, Precedence::Relation);
                }
                self.push("\\}");
            }
            Kind::Matrix(rows, delimiter) => self.matrix(rows, *delimiter),
            Kind::Binomial(n, k, BinomialStyle::Stacked) => {
                self.push("\\binom{");
                self.write(n, Precedence::Relation);
                self.push("}{");
                self.write(k, Precedence::Relation);
                self.push("}");
            }
            Kind::Binomial(n, k, BinomialStyle::Subscripted) => {
                self.push("C");
                self.script("_", std::slice::from_ref(n));
                self.script("^", std::slice::from_ref(k));
            }
            Kind::Factorial(body) => {
                match precedence(body) {
                    Precedence::Atom => self.inner(body),
                    _ if matches!(body.kind, Kind::Subscript(..)) => self.inner(body),
                    _ => self.bracketed(body),
                }
                self.push("!");
            }
            Kind::Enclosed(enclosure, body) => {
                let (open, close) = match enclosure {
                    Enclosure::Abs => ("\\left|", "\\right|"),
                    Enclosure::Norm => ("\\left\\|", "\\right\\|"),
                    Enclosure::Floor => ("\\left\\lfloor ", "\\right\\rfloor "),
                    Enclosure::Ceil => ("\\left\\lceil ", "\\right\\rceil "),
                };
                self.push(open);
                self.write(body, Precedence::Relation);
                self.push(close);
            }
            Kind::Big { op, lower, upper, body } => {
                self.push(match op {
                    BigOp::Sum => "\\sum",
                    BigOp::Product => "\\prod",
                    BigOp::Max => "\\max",
                    BigOp::Min => "\\min",
                    BigOp::Union => "\\bigcup",
                    BigOp::Intersection => "\\bigcap",
                    BigOp::Limit => "\\lim",
                });
                if !lower.is_empty() {
                    self.push("_{");
                    self.list(lower, ", ");
                    self.push("}");
                }
                if let Some(upper) = upper {
                    self.push("^{");
                    self.write(upper, Precedence::Relation);
                    self.push("}");
                }
                self.push(" ");
                self.write(body, Precedence::Product);
            }
            Kind::Integral { lower, upper, body, variable } => {
                self.push("\\int");
                for (mark, bound) in [("_", lower), ("^", upper)] {
                    if let Some(bound) = bound {
                        self.script(mark, std::slice::from_ref(bound));
                    }
                }
                self.push(" ");
                self.write(body, Precedence::Product);
                self.push(" \\,d");
                self.write(variable, Precedence::Postfix);
            }
            Kind::Derivative { partial, variables, body } => {
                self.derivative(*partial, variables, body.as_deref());
            }
            Kind::At { body, lower, upper } => {
                self.push("\\left. ");
                self.write(body, Precedence::Relation);
                self.push(" \\right|_{");
                self.list(lower, ", ");
                self.push("}");
                if let Some(upper) = upper {
                    self.script("^", std::slice::from_ref(upper));
                }
            }
            Kind::Cases(cases) => {
                self.push("\\begin{cases} ");
                for (i, (value, condition)) in cases.iter().enumerate() {
                    if i > 0 {
                        self.push(" \\\\ ");
                    }
                    self.write(value, Precedence::Relation);
                    match condition {
                        Some(condition) => {
                            self.push(" & ");
                            self.write(condition, Precedence::Sequence);
                        }
                        None => self.push(" & \\text{otherwise}"),
                    }
                }
                self.push(" \\end{cases}");
            }
            Kind::Ellipsis => self.push("\\ldots"),
            Kind::Brace(items, label) => {
                self.push("\\underbrace{");
                self.list(items, ", ");
                self.push("}");
                if let Some(label) = label {
                    self.push("_{");
                    self.write(label, Precedence::Relation);
                    self.push("}");
                }
            }
            Kind::Compose(items) => self.joined(items, " \\circ "),
            Kind::Cross(items) => self.joined(items, " \\times "),
            Kind::Transpose(body) => {
                self.write(body, Precedence::Postfix);
                self.push("^\\top ");
            }
            Kind::Range(from, to) => {
                self.write(from, Precedence::Sum);
                self.push(", \\ldots, ");
                self.write(to, Precedence::Sum);
            }
            Kind::Lambda(parameters, body) => {
                match parameters.as_slice() {
                    [one] => self.write(one, Precedence::Postfix),
                    many => self.enclosed("(", many, ")"),
                }
                self.push(" \\mapsto ");
                self.write(body, Precedence::Lambda);
            }
            Kind::Chain(first, links) => {
                self.write(first, Precedence::Lambda);
                for link in links {
                    self.push(relation(link.rel));
                    self.write(&link.expr, Precedence::Relation);
                }
            }
            Kind::Sequence(items) => self.list(items, ", \\quad "),
            Kind::ForAll(items, body) => {
                self.push("\\forall ");
                self.list(items, ", ");
                if let Some(body) = body {
                    self.push(": ");
                    self.write(body, Precedence::Relation);
                }
            }
            Kind::Text(words) => self.push(&format!("\\text{{{}}}", escaped(words))),
            Kind::Unread(raw) => self.push(raw),
        }
    }

    fn enclosed(&mut self, open: &str, items: &[Expr], close: &str) {
        let tall = items.iter().any(is_tall);
        if tall {
            self.push("\\left");
        }
        self.push(open);
        self.list(items, ", ");
        if tall {
            self.push("\\right");
        }
        self.push(close);
    }

    fn joined(&mut self, items: &[Expr], separator: &str) {
        for (i, item) in items.iter().enumerate() {
            if i > 0 {
                self.push(separator);
            }
            self.write(item, Precedence::Power);
        }
    }

    fn name(&mut self, name: &str) {
        match name {
            "infty" | "ell" => self.push(&format!("\\{name}")),
            "sin" | "cos" | "tan" | "exp" | "log" | "ln" | "max" | "min" | "det" | "gcd" => {
                self.push(&format!("\\{name}"));
            }
            _ if crate::syntax::greek_char(name).is_some() => {
                // Capital letters that look Latin have no command.
                match name {
                    "omicron" => self.push("o"),
                    _ => self.push(&format!("\\{name}")),
                }
            }
            _ if name.chars().count() == 1 || name.starts_with(|c: char| c.is_ascii_digit()) => {
                self.push(name)
            }
            _ => self.push(&format!("\\operatorname{{{}}}", escaped(name))),
        }
    }

    fn product(&mut self, factors: &[Expr]) {
        let last = factors.len() - 1;
        for (i, factor) in factors.iter().enumerate() {
            let open_ended =
                matches!(factor.kind, Kind::Big { .. } | Kind::Integral { .. } | Kind::Derivative { .. });
            // An open end at the end needs no bracket; anywhere else it would swallow the rest.
            let context = match (i, open_ended) {
                (i, true) if i == last => Precedence::Product,
                (_, true) => Precedence::Compose,
                (0, _) => Precedence::Product,
                _ => Precedence::Compose,
            };
            if i > 0 {
                let number = digits(factor).is_some()
                    || matches!(&factor.kind, Kind::Number(_))
                    || matches!(&factor.kind, Kind::Pow(base, _) if digits(base).is_some())
                    || matches!(&factor.kind, Kind::Factorial(base) if digits(base).is_some());
                self.push(if number { " \\cdot " } else { " " });
            }
            match factor.kind {
                Kind::Ellipsis => self.push("\\cdots"),
                _ => self.write(factor, context),
            }
        }
    }

    fn matrix(&mut self, rows: &[Vec<Option<Expr>>], delimiter: Delimiter) {
        let name = match delimiter {
            Delimiter::Paren => "pmatrix",
            Delimiter::Bracket => "bmatrix",
            Delimiter::Bar => "vmatrix",
            Delimiter::None => "matrix",
        };
        self.push(&format!("\\begin{{{name}}} "));
        for (i, row) in rows.iter().enumerate() {
            if i > 0 {
                self.push(" \\\\ ");
            }
            for (j, cell) in row.iter().enumerate() {
                if j > 0 {
                    self.push(" & ");
                }
                if let Some(cell) = cell {
                    self.write(cell, Precedence::Relation);
                }
            }
        }
        self.push(&format!(" \\end{{{name}}}"));
    }

    fn derivative(&mut self, partial: bool, variables: &[(Expr, Option<Expr>)], body: Option<&Expr>) {
        let d = if partial { "\\partial" } else { "d" };
        self.push("\\frac{");
        self.push(d);
        // The order above is the sum of the orders below.
        let orders: Vec<String> =
            variables.iter().map(|(_, order)| order.as_ref().map_or("1".to_owned(), latex)).collect();
        match orders.as_slice() {
            [one] if one == "1" => {}
            [one] => self.push(&format!("^{{{one}}}")),
            many => {
                let numbers: Option<Vec<u32>> = many.iter().map(|order| order.parse().ok()).collect();
                let total = match numbers {
                    Some(numbers) => numbers.iter().sum::<u32>().to_string(),
                    None => many.join("+"),
                };
                self.push(&format!("^{{{total}}}"));
            }
        }
        self.push("}{");
        for (i, ((variable, order), text)) in variables.iter().zip(&orders).enumerate() {
            if i > 0 {
                self.push(" ");
            }
            self.push(d);
            if partial {
                self.push(" ");
            }
            self.write(variable, Precedence::Postfix);
            if order.is_some() && text != "1" {
                self.push(&format!("^{{{text}}}"));
            }
        }
        self.push("}");
        if let Some(body) = body {
            self.push(" ");
            self.write(body, Precedence::Product);
        }
    }
}

fn relation(rel: Rel) -> &'static str {
    match rel {
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
        Rel::Subset => " \\subseteq ",
        Rel::To => " \\to ",
        Rel::MapsTo => " \\mapsto ",
        Rel::Implies => " \\Rightarrow ",
        Rel::Iff => " \\Leftrightarrow ",
        Rel::Colon => " : ",
    }
}
