//! Plain notation, in ASCII and in Unicode.

use super::{digits, numbered_without_underscore};
use crate::expr::{Accent, BigOp, Enclosure, Expr, Kind, Precedence, Rel, Sign};

/// The formula in plain notation, as it can be typed.
///
/// ```
/// use polarform::{syntax::parse, write::text};
/// let formula = parse("5/3 (t_1 + t_2) - c_0^2").unwrap();
/// assert_eq!(text(&formula), "5/3 (t1 + t2) - c_0^2");
/// ```
pub fn text(expr: &Expr) -> String {
    let mut writer = Plain { out: String::new(), unicode: false };
    writer.write(expr, Precedence::Sequence);
    writer.out
}

/// The formula with Unicode subscripts, superscripts and Greek letters; a matrix on lines of its own.
///
/// ```
/// use polarform::{syntax::parse, write::unicode};
/// let formula = parse("sigma_2 t_1 t_2^2").unwrap();
/// assert_eq!(unicode(&formula), "σ₂t₁t₂²");
/// ```
pub fn unicode(expr: &Expr) -> String {
    if let Kind::Matrix(rows, _) = &expr.kind
        && rows.len() > 1
    {
        return boxed(rows);
    }
    let mut writer = Plain { out: String::new(), unicode: true };
    writer.write(expr, Precedence::Sequence);
    writer.out
}

/// A matrix as lines between tall brackets, columns aligned to the right.
fn boxed(rows: &[Vec<Option<Expr>>]) -> String {
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().map(|cell| cell.as_ref().map(unicode).unwrap_or_default()).collect())
        .collect();
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|j| cells.iter().filter_map(|row| row.get(j)).map(|c| c.chars().count()).max().unwrap_or(0))
        .collect();
    let last = cells.len() - 1;
    let lines: Vec<String> = cells
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let (open, close) = match i {
                0 => ('⎛', '⎞'),
                i if i == last => ('⎝', '⎠'),
                _ => ('⎜', '⎟'),
            };
            let padded: Vec<String> = widths
                .iter()
                .enumerate()
                .map(|(j, width)| {
                    let cell = row.get(j).map_or("", String::as_str);
                    format!("{}{cell}", " ".repeat(width - cell.chars().count()))
                })
                .collect();
            format!("{open} {} {close}", padded.join("  "))
        })
        .collect();
    lines.join("\n")
}

struct Plain {
    out: String,
    unicode: bool,
}

/// Precedence in plain notation, where sums, integrals and derivatives are written as calls.
fn precedence(expr: &Expr) -> Precedence {
    match &expr.kind {
        Kind::Big { .. } | Kind::Integral { .. } | Kind::Derivative { .. } | Kind::At { .. } => {
            Precedence::Postfix
        }
        Kind::Cross(_) | Kind::Transpose(_) => Precedence::Postfix,
        _ => expr.precedence(),
    }
}

fn script(text: &str, table: &[(char, char)]) -> Option<String> {
    text.chars().map(|c| table.iter().find(|(plain, _)| *plain == c).map(|(_, s)| *s)).collect()
}

const SUBSCRIPTS: &[(char, char)] = &[
    ('0', '₀'),
    ('1', '₁'),
    ('2', '₂'),
    ('3', '₃'),
    ('4', '₄'),
    ('5', '₅'),
    ('6', '₆'),
    ('7', '₇'),
    ('8', '₈'),
    ('9', '₉'),
];

const SUPERSCRIPTS: &[(char, char)] = &[
    ('0', '⁰'),
    ('1', '¹'),
    ('2', '²'),
    ('3', '³'),
    ('4', '⁴'),
    ('5', '⁵'),
    ('6', '⁶'),
    ('7', '⁷'),
    ('8', '⁸'),
    ('9', '⁹'),
];

impl Plain {
    fn push(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn either(&mut self, ascii: &str, unicode: &str) {
        self.out.push_str(if self.unicode { unicode } else { ascii });
    }

    fn write(&mut self, expr: &Expr, context: Precedence) {
        if precedence(expr) < context {
            self.push("(");
            self.inner(expr);
            self.push(")");
        } else {
            self.inner(expr);
        }
    }

    fn list<'a>(&mut self, items: impl IntoIterator<Item = &'a Expr>, separator: &str) {
        for (i, item) in items.into_iter().enumerate() {
            if i > 0 {
                self.push(separator);
            }
            self.write(item, Precedence::Relation);
        }
    }

    fn call(&mut self, name: &str, items: &[&Expr]) {
        self.push(name);
        self.push("(");
        self.list(items.iter().copied(), ", ");
        self.push(")");
    }

    fn inner(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Number(q) => self.push(&q.to_string()),
            Kind::Name(name) => self.name(name),
            Kind::Subscript(base, indices) => self.subscript(base, indices),
            Kind::Upper(base, indices) => {
                self.write(base, Precedence::Postfix);
                self.push("^{(");
                self.list(indices, ",");
                self.push(")}");
            }
            Kind::Accent(accent, body) => {
                let name = match accent {
                    Accent::Hat => "hat",
                    Accent::Bar => "bar",
                    Accent::Vec => "vec",
                    Accent::Tilde => "tilde",
                    Accent::Dot => "dot",
                    Accent::Ddot => "ddot",
                    Accent::Bold => "bold",
                    Accent::Script => "script",
                    Accent::Blackboard => "blackboard",
                };
                self.call(name, &[body]);
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
                    self.write(&term.expr, Precedence::Product);
                }
            }
            Kind::Mul(factors) => self.product(factors),
            Kind::Div(left, right, _) => {
                self.write(left, Precedence::Product);
                self.push("/");
                self.write(right, Precedence::Compose);
            }
            Kind::Pow(base, exponent) => self.power(base, exponent),
            Kind::Apply(callee, groups) => {
                // t^2(…) would read as a product: a callee that is a power needs an index or a name.
                let family = match &callee.kind {
                    Kind::Pow(base, exponent) => {
                        matches!(base.kind, Kind::Subscript(..)) || matches!(exponent.kind, Kind::Name(_))
                    }
                    Kind::Upper(..) => true,
                    _ => false,
                };
                self.write(callee, if family { Precedence::Power } else { Precedence::Postfix });
                self.push("(");
                for (i, group) in groups.iter().enumerate() {
                    if i > 0 {
                        self.push("; ");
                    }
                    self.list(group, ", ");
                }
                self.push(")");
            }
            Kind::Group(body) => {
                self.push("(");
                self.write(body, Precedence::Relation);
                self.push(")");
            }
            Kind::Tuple(items) => {
                self.push("(");
                self.list(items, ", ");
                self.push(")");
            }
            Kind::List(items) => {
                self.push("[");
                self.list(items, ", ");
                self.push("]");
            }
            Kind::Set(items, condition) => {
                self.push("{");
                self.list(items, ", ");
                if let Some(condition) = condition {
                    self.push(" | ");
                    self.write(condition, Precedence::Relation);
                }
                self.push("}");
            }
            Kind::Matrix(rows, _) => {
                self.push("[");
                for (i, row) in rows.iter().enumerate() {
                    if i > 0 {
                        self.push("; ");
                    }
                    for (j, cell) in row.iter().enumerate() {
                        if j > 0 {
                            self.push(", ");
                        }
                        if let Some(cell) = cell {
                            self.write(cell, Precedence::Relation);
                        }
                    }
                }
                // Without it a single row would read as a list.
                self.push(if rows.len() == 1 { ";]" } else { "]" });
            }
            Kind::Binomial(n, k, _) => self.call("binomial", &[n, k]),
            Kind::Factorial(body) => {
                self.write(body, Precedence::Postfix);
                self.push("!");
            }
            Kind::Enclosed(enclosure, body) => {
                let name = match enclosure {
                    Enclosure::Abs => "abs",
                    Enclosure::Norm => "norm",
                    Enclosure::Floor => "floor",
                    Enclosure::Ceil => "ceil",
                };
                self.call(name, &[body]);
            }
            Kind::Big { op, lower, upper, body } => self.big(*op, lower, upper.as_deref(), body),
            Kind::Integral { lower, upper, body, variable } => {
                self.push("integral(");
                self.write(body, Precedence::Relation);
                self.push(", ");
                self.write(variable, Precedence::Relation);
                if let (Some(lower), Some(upper)) = (lower, upper) {
                    self.push("=");
                    self.write(lower, Precedence::Sum);
                    self.push("..");
                    self.write(upper, Precedence::Sum);
                }
                self.push(")");
            }
            Kind::Derivative { variables, body, .. } => {
                self.push("diff(");
                if let Some(body) = body {
                    self.write(body, Precedence::Relation);
                }
                for (variable, order) in variables {
                    self.push(", ");
                    self.write(variable, Precedence::Relation);
                    if let Some(order) = order {
                        self.push(", ");
                        self.write(order, Precedence::Relation);
                    }
                }
                self.push(")");
            }
            Kind::At { body, lower, .. } => {
                self.push("subs(");
                self.write(body, Precedence::Relation);
                for piece in lower {
                    self.push(", ");
                    self.write(piece, Precedence::Relation);
                }
                self.push(")");
            }
            Kind::Cases(cases) => {
                self.push("cases(");
                for (i, (value, condition)) in cases.iter().enumerate() {
                    if i > 0 {
                        self.push(", ");
                    }
                    self.write(value, Precedence::Lambda);
                    match condition {
                        Some(condition) => {
                            self.push(" if ");
                            self.write(condition, Precedence::Relation);
                        }
                        None => self.push(" otherwise"),
                    }
                }
                self.push(")");
            }
            Kind::Ellipsis => self.either("...", "⋯"),
            Kind::Brace(items, _) => self.list(items, ", "),
            Kind::Compose(items) => {
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        self.push("∘");
                    }
                    self.write(item, Precedence::Power);
                }
            }
            Kind::Cross(items) => {
                let items: Vec<&Expr> = items.iter().collect();
                self.call("cross", &items);
            }
            Kind::Transpose(body) => self.call("transpose", &[body]),
            Kind::Range(from, to) => {
                self.write(from, Precedence::Sum);
                self.push("..");
                self.write(to, Precedence::Sum);
            }
            Kind::Lambda(parameters, body) => {
                match parameters.as_slice() {
                    [one] => self.write(one, Precedence::Postfix),
                    many => {
                        self.push("(");
                        self.list(many, ", ");
                        self.push(")");
                    }
                }
                self.either(" -> ", " ↦ ");
                self.write(body, Precedence::Lambda);
            }
            Kind::Chain(first, links) => {
                self.write(first, Precedence::Lambda);
                for link in links {
                    let sign = self.relation(link.rel);
                    self.push(sign);
                    let inner =
                        if link.rel == Rel::Define { Precedence::Relation } else { Precedence::Lambda };
                    self.write(&link.expr, inner);
                }
            }
            Kind::Sequence(items) => self.list(items, ", "),
            Kind::ForAll(items, body) => {
                self.either("for all ", "∀ ");
                self.list(items, ", ");
                if let Some(body) = body {
                    self.push(": ");
                    self.write(body, Precedence::Relation);
                }
            }
            Kind::Text(words) => {
                self.push("\"");
                self.push(&words.replace('"', "'"));
                self.push("\"");
            }
            Kind::Unread(raw) => self.push(raw),
        }
    }

    fn relation(&self, rel: Rel) -> &'static str {
        match (rel, self.unicode) {
            (Rel::Eq, _) => " = ",
            (Rel::Define, _) => " := ",
            (Rel::Ne, false) => " != ",
            (Rel::Ne, true) => " ≠ ",
            (Rel::Lt, _) => " < ",
            (Rel::Le, false) => " <= ",
            (Rel::Le, true) => " ≤ ",
            (Rel::Gt, _) => " > ",
            (Rel::Ge, false) => " >= ",
            (Rel::Ge, true) => " ≥ ",
            (Rel::Equiv, _) => " ≡ ",
            (Rel::Approx, _) => " ≈ ",
            (Rel::In, false) => " in ",
            (Rel::In, true) => " ∈ ",
            (Rel::Subset, _) => " ⊆ ",
            (Rel::To, _) => " → ",
            (Rel::MapsTo, _) => " ↦ ",
            (Rel::Implies, _) => " ⇒ ",
            (Rel::Iff, _) => " ⇔ ",
            (Rel::Colon, _) => " : ",
        }
    }

    fn name(&mut self, name: &str) {
        match crate::syntax::greek_char(name) {
            Some(letter) if self.unicode => self.out.push(letter),
            _ => self.push(name),
        }
    }

    fn subscript(&mut self, base: &Expr, indices: &[Expr]) {
        self.write(base, Precedence::Postfix);
        if let [index] = indices {
            if let Some(digits) = digits(index) {
                if self.unicode
                    && let Some(low) = script(&digits, SUBSCRIPTS)
                {
                    return self.push(&low);
                }
                let bare = matches!(&base.kind, Kind::Name(name) if numbered_without_underscore(name));
                if !bare {
                    self.push("_");
                }
                return self.push(&digits);
            }
            if let Kind::Name(name) = &index.kind
                && name.chars().count() == 1
                && name.chars().all(char::is_alphabetic)
            {
                self.push("_");
                return self.name(name);
            }
        }
        self.push("_{");
        self.list(indices, ",");
        self.push("}");
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) {
        self.write(base, Precedence::Postfix);
        if let Some(digits) = digits(exponent) {
            if self.unicode
                && let Some(high) = script(&digits, SUPERSCRIPTS)
            {
                return self.push(&high);
            }
            self.push("^");
            return self.push(&digits);
        }
        self.push("^");
        self.write(exponent, Precedence::Postfix);
    }

    fn product(&mut self, factors: &[Expr]) {
        for (i, factor) in factors.iter().enumerate() {
            let context = if i == 0 { Precedence::Product } else { Precedence::Compose };
            if i == 0 {
                self.write(factor, context);
                continue;
            }
            let before = self.out.len();
            self.write(factor, context);
            let starts_with_digit = self.out[before..].starts_with(|c: char| c.is_ascii_digit() || c == '.');
            // Subscripts and superscripts end a name, so t₁t₂ needs no space; t u does.
            let ends_name = self.out[..before].ends_with(|c: char| {
                let scripts = SUBSCRIPTS.iter().chain(SUPERSCRIPTS);
                scripts.map(|(_, script)| *script).any(|script| script == c)
            });
            let starts_name = self.out[before..].starts_with(char::is_alphabetic);
            let separator = match (starts_with_digit, self.unicode && ends_name && starts_name) {
                (true, _) => "*",
                (_, true) => "",
                _ => " ",
            };
            self.out.insert_str(before, separator);
        }
    }

    fn big(&mut self, op: BigOp, lower: &[Expr], upper: Option<&Expr>, body: &Expr) {
        self.push(match op {
            BigOp::Sum => "sum(",
            BigOp::Product => "prod(",
            BigOp::Max => "max(",
            BigOp::Min => "min(",
            BigOp::Union => "union(",
            BigOp::Intersection => "intersection(",
            BigOp::Limit => "limit(",
        });
        for piece in lower {
            match (&piece.kind, upper) {
                (Kind::Chain(name, links), Some(upper)) if links.len() == 1 => {
                    self.write(name, Precedence::Sum);
                    self.push("=");
                    self.write(&links[0].expr, Precedence::Sum);
                    self.push("..");
                    self.write(upper, Precedence::Sum);
                }
                _ => self.write(piece, Precedence::Relation),
            }
            self.push(", ");
        }
        self.write(body, Precedence::Relation);
        self.push(")");
    }
}
