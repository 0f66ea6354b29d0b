//! Products, quotients and powers of written factors.
//!
//! What is multiplied and what is applied depends on the values: (F + G)(t) is a value of
//! F + G when F and G are functions, and a product when they are numbers.

use std::iter::Peekable;
use std::slice::Iter;

use super::arguments::matrix_of;
use super::curves;
use super::machine::{Evaluated, Machine};
use super::names::name_of;
use super::names::spread;
use crate::formula::source::Span;
use crate::formula::{Delimiter, Expr, Kind, Quotient};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::lexicon::families::{self, BACKWARD_DIFFERENCE, FORWARD_DIFFERENCE};
use crate::language::lexicon::roles;
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::poly::Symbol;
use num_traits::Signed;

fn is_scalar(value: &Value) -> bool {
    matches!(value, Value::Scalar(_))
}

impl Machine {
    /// A product. A function in parentheses, or a power of one, is applied to the parenthesis
    /// that follows it: (F + G)(t), F^2(t).
    pub(crate) fn eval_product(&mut self, factors: &[Expr], span: Span) -> Evaluated {
        if let Some(derivative) = self.differential(factors, span).or_else(|| self.partial(factors, span)) {
            return self.eval(&derivative);
        }
        let mut product: Option<Value> = None;
        // [1, t, t^2] M is a row; the list after it is a column.
        let mut row = false;
        let mut rest = factors.iter().peekable();
        while let Some(factor) = rest.next() {
            let value = self.eval_factor(factor, &mut rest)?;
            product = Some(match (product, value) {
                (None, value) => value,
                (Some(Value::List(items)), Value::List(column)) if row => {
                    row = false;
                    arithmetic::row_times_column(&items, &column).at(factor.span)?
                }
                // On a page a product of two points is the scalar product.
                (Some(Value::List(one)), Value::List(other))
                    if self.has_reading()
                        && one.len() == other.len()
                        && one.iter().chain(other.iter()).all(is_scalar) =>
                {
                    arithmetic::row_times_column(&one, &other).at(factor.span)?
                }
                (Some(product), value) => {
                    row = matches!((&product, &value), (Value::List(_), Value::Matrix(_)));
                    arithmetic::multiply(product, value).at(factor.span)?
                }
            });
        }
        product.ok_or_else(|| Diagnostic::error(Code::Empty, "an empty product").at(span))
    }

    /// The value of a factor, together with the one after it where the two belong together.
    fn eval_factor(&mut self, factor: &Expr, rest: &mut Peekable<Iter<'_, Expr>>) -> Evaluated {
        if let Some((orders, back)) = self.difference_orders(factor)?
            && let Some(next) = rest.peek()
            && let Some(value) = self.difference(&orders, back, next)?
        {
            rest.next();
            return Ok(value);
        }
        if let Some(call) = rest.peek().and_then(|next| self.call_with_matrix(factor, next)) {
            rest.next();
            return self.eval(&call);
        }
        if let (Kind::Pow(base, _), Some(next)) = (&factor.kind, rest.peek())
            && let Kind::Group(inside) = &next.kind
            && touches(factor, next.span)
        {
            self.is_no_lone_call(base, inside)?;
        }
        if let Some(value) = self.difference_before(factor, rest.peek().copied())? {
            rest.next();
            return Ok(value);
        }
        let value = match &factor.kind {
            // In a product, square brackets around one formula are parentheses: 3 [a - b].
            Kind::List(items) if items.len() == 1 => self.eval(&items[0])?,
            _ if is_group(factor) && rest.peek().is_some_and(|next| is_group(next)) => {
                self.eval_called(factor)?
            }
            _ => self.eval(factor)?,
        };
        if let Some(Expr { kind: Kind::Group(inside), span }) = rest.peek()
            && touches(factor, *span)
            && let Some(result) = self.value_of_result(&value, factor, inside, factor.span.to(*span))?
        {
            rest.next();
            return Ok(result);
        }
        if let Some(called) = self.called_after_blank(&value, factor, rest.peek().copied())? {
            rest.next();
            return Ok(called);
        }
        if let (Kind::Group(_), Some(Expr { kind: Kind::Group(inside), span })) = (&factor.kind, rest.peek())
            && matches!(inside.kind, Kind::Number(_))
            && touches(factor, *span)
        {
            self.note_product_by_number(&value, factor.span.to(*span));
        }
        if matches!(factor.kind, Kind::Group(_) | Kind::Pow(..))
            && let Some(next) = rest.peek()
            && let Some(result) = self.apply_to_group(&value, factor, next)?
        {
            rest.next();
            return Ok(result);
        }
        Ok(value)
    }

    /// The brackets of a matrix after the name of a function are those of a call: \operatorname{tr} \begin{pmatrix} …
    fn call_with_matrix(&mut self, factor: &Expr, next: &Expr) -> Option<Expr> {
        let matrix = match &next.kind {
            Kind::Group(inside) => inside,
            _ => next,
        };
        let Kind::Matrix(_, Delimiter::Paren | Delimiter::Bracket) = &matrix.kind else { return None };
        let name = name_of(factor, self).filter(|name| name.is_plain() && self.lookup(name).is_none())?;
        (self.tools.function)(name.base())
            .or_else(|| (self.tools.alias)(name.base()))
            .filter(|_| self.reading.is_none())?;
        let call = Kind::Apply(Box::new(factor.clone()), vec![vec![matrix.clone()]]);
        Some(Expr::new(call, factor.span.to(next.span)))
    }

    /// `f (3)` for a function or curve f: a value, and a note says so.
    fn called_after_blank(
        &mut self,
        value: &Value,
        factor: &Expr,
        next: Option<&Expr>,
    ) -> Result<Option<Value>, Diagnostic> {
        let named = matches!(factor.kind, Kind::Name(_) | Kind::Subscript(..));
        let callable = match value {
            Value::Function(_) | Value::Polar(_) => true,
            Value::Geometry(geometry) => !geometry.is_surface(),
            _ => false,
        };
        let Some(next) = next.filter(|_| named && callable && self.reading.is_none()) else {
            return Ok(None);
        };
        let arguments = match &next.kind {
            Kind::Group(inside) => vec![inside.as_ref().clone()],
            Kind::Tuple(items) => items.clone(),
            _ => return Ok(None),
        };
        let whole =
            Expr::new(Kind::Apply(Box::new(factor.clone()), vec![arguments]), factor.span.to(next.span));
        let shown = super::super::write::text(factor);
        let note = Diagnostic::note(Code::Called, format!("{shown} is called, although a blank follows it"));
        self.note(note.at(whole.span).hint(format!("write {shown} * (...) for the product")));
        self.eval(&whole).map(Some)
    }

    /// The divided difference `[x_0, x_1] f` of a function f.
    fn difference_before(&mut self, nodes: &Expr, next: Option<&Expr>) -> Result<Option<Value>, Diagnostic> {
        let (Kind::List(items), Some(next)) = (&nodes.kind, next) else { return Ok(None) };
        let span = nodes.span.to(next.span);
        // [x_0, x_1] x^3: nodes are named like the variable.
        let of_letter = letter_of(items)
            .filter(|letter| self.lookup(&Symbol::new(*letter)).is_none() && stands_in(letter, next));
        if let Some(letter) = of_letter
            && items.len() > 1
        {
            let lambda = Kind::Lambda(vec![Expr::name(letter)], Box::new(next.clone()));
            if let Value::Function(function) = self.eval(&Expr::new(lambda, next.span))? {
                let shown = super::super::write::text(next);
                let message = format!("read as the divided difference of {letter} -> {shown}");
                let product = format!("for the product write {shown} * {}", super::super::write::text(nodes));
                self.note(Diagnostic::note(Code::AmbiguousProduct, message).at(span).hint(product));
                return self.divided_difference(&function, items, span).map(Some);
            }
        }
        let Some(name) = name_of(next, self).filter(|_| items.len() > 1) else { return Ok(None) };
        match self.lookup(&name).cloned() {
            Some(Value::Function(function)) => self.divided_difference(&function, items, span).map(Some),
            None if name.is_plain() && roles::FUNCTIONS.contains(&name.base()) && !self.has_reading() => {
                Err(Diagnostic::error(Code::AmbiguousProduct, "a divided difference or a product?")
                    .at(span)
                    .reason(format!("{name} has no value here"))
                    .hint(format!("for a divided difference define the function first: {name}(t) := t^2"))
                    .hint(format!("for the product write {name} * [...]")))
            }
            _ => Ok(None),
        }
    }

    /// k for an undefined Δ^k or ∇^k, r and s for Δ^{r,s}, and whether it goes back.
    fn difference_orders(&mut self, factor: &Expr) -> Result<Option<(Vec<i64>, bool)>, Diagnostic> {
        let (sign, orders) = match &factor.kind {
            Kind::Pow(base, exponent) => (base.as_ref(), std::slice::from_ref(exponent.as_ref())),
            Kind::Upper(base, orders) if orders.len() == 2 => (base.as_ref(), orders.as_slice()),
            _ => (factor, &[][..]),
        };
        let Kind::Name(name) = &sign.kind else { return Ok(None) };
        let back = name == BACKWARD_DIFFERENCE;
        if !back && name != FORWARD_DIFFERENCE || self.lookup(&Symbol::new(name)).is_some() {
            return Ok(None);
        }
        let orders = match orders {
            [] => vec![1],
            orders => orders.iter().map(|order| self.eval_int(order)).collect::<Result<_, _>>()?,
        };
        Ok(Some((orders, back)))
    }

    /// The differences Δ^k b_i = Σ_j (−1)^{k−j} C(k, j) b_{i+j} and ∇^k b_i = Δ^k b_{i−k}, in the first index; Δ^{r,s} b_{i,j}
    /// is that of order r in i and of order s in j.
    fn difference(
        &mut self,
        orders: &[i64],
        back: bool,
        operand: &Expr,
    ) -> Result<Option<Value>, Diagnostic> {
        if let Kind::Apply(..) = &operand.kind {
            return Err(Diagnostic::error(Code::Unsupported, "differences are taken of indexed names only")
                .at(operand.span)
                .hint("write it out: F(1) - F(0)"));
        }
        let of_function = name_of(operand, self)
            .is_some_and(|name| matches!(self.lookup(&name), Some(Value::Function(_) | Value::Polar(_))));
        let formula = matches!(operand.kind, Kind::Pow(..) | Kind::Group(_) | Kind::Binomial(..));
        if (formula || of_function) && !self.has_reading() {
            let sign = if back { BACKWARD_DIFFERENCE } else { FORWARD_DIFFERENCE };
            return Err(Diagnostic::error(Code::AmbiguousProduct, "a difference or a product?")
                .at(operand.span)
                .reason(format!("what follows {sign} may be what the difference is taken of"))
                .hint("for the difference write it out: (x + 1)^2 - x^2")
                .hint(format!("for the product write the letter behind: x^2 {sign}")));
        }
        let Kind::Subscript(base, indices) = &operand.kind else { return Ok(None) };
        let indices = spread(indices, orders.len(), self);
        if indices.is_empty() || indices.len() < orders.len() {
            return Ok(None);
        }
        self.difference_in(orders, 0, back, (base, &indices), operand.span)
    }

    /// The same in the indices from one on.
    fn difference_in(
        &mut self,
        orders: &[i64],
        at: usize,
        back: bool,
        (base, indices): (&Expr, &[Expr]),
        span: Span,
    ) -> Result<Option<Value>, Diagnostic> {
        let Some(order) = orders.get(at) else {
            let member = Kind::Subscript(Box::new(base.clone()), indices.to_vec());
            return self.eval(&Expr::new(member, span)).map(Some);
        };
        let Ok(k) = usize::try_from(*order) else { return Ok(None) };
        crate::budget::charge_terms(k as u64);
        let mut sum: Option<Value> = None;
        for (j, count) in crate::math::number::binomial_row(k).into_iter().enumerate() {
            let plus = |expr: Expr| crate::formula::Term { sign: crate::formula::Sign::Plus, expr };
            let mut list = indices.to_vec();
            let shift = j as i64 - if back { k as i64 } else { 0 };
            if shift != 0 {
                let terms = vec![plus(list[at].clone()), plus(Expr::int(shift))];
                list[at] = Expr::new(Kind::Add(terms), list[at].span);
            }
            let Some(value) = self.difference_in(orders, at + 1, back, (base, &list), span)? else {
                return Ok(None);
            };
            let count = if (k - j).is_multiple_of(2) { count } else { -count };
            let weight = Value::number(crate::math::number::Rational::from_integer(count));
            let term = arithmetic::multiply(weight, value).at(span)?;
            sum = Some(match sum {
                None => term,
                Some(sum) => arithmetic::add(sum, term).at(span)?,
            });
        }
        Ok(sum)
    }

    /// The value of a function at what stands in the parenthesis `next`, which may have a power:
    /// (F + G)(t)^2. `None` if it is a product after all.
    fn apply_to_group(
        &mut self,
        function: &Value,
        callee: &Expr,
        next: &Expr,
    ) -> Result<Option<Value>, Diagnostic> {
        let (bracket, exponent) = match &next.kind {
            Kind::Pow(base, exponent) => (base.as_ref(), Some(exponent)),
            _ => (next, None),
        };
        let group = match &bracket.kind {
            Kind::Group(inner) => vec![inner.as_ref().clone()],
            Kind::Tuple(items) => items.clone(),
            _ => return Ok(None),
        };
        let span = callee.span.to(bracket.span);
        let value = match function {
            Value::Polar(polar) => self.call_polar(polar, &[group], callee, span)?,
            Value::Function(function) => {
                let values = self.arguments(&[group])?;
                if values.iter().any(|(value, _)| matches!(value, Value::Function(_) | Value::Polar(_))) {
                    return Ok(None);
                }
                self.call(function, values, span)?
            }
            // (s + r)(1/2), the sum of two curves at a parameter
            Value::Geometry(_) | Value::Piecewise(_) => {
                let values = self.arguments(&[group])?;
                if !values.iter().all(|(value, _)| matches!(value, Value::Scalar(_))) {
                    return Ok(None);
                }
                match function {
                    Value::Geometry(curve) => curves::call_geometry(curve, &values, span)?,
                    Value::Piecewise(function) => curves::call_piecewise(function, &values, span)?,
                    _ => return Ok(None),
                }
            }
            _ => return Ok(None),
        };
        match exponent {
            None => Ok(Some(value)),
            Some(exponent) => {
                let exponent_value = self.eval(exponent)?;
                arithmetic::power(value, &exponent_value).map(Some).at(exponent.span)
            }
        }
    }

    pub(crate) fn eval_power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Evaluated {
        if let Kind::Name(mark) = &exponent.kind
            && (mark == "T" || mark == "top")
            && self.lookup(&Symbol::new(mark)).is_none_or(|value| !matches!(value, Value::Scalar(_)))
        {
            let value = self.eval(base)?;
            if !matches!(value, Value::Scalar(_)) {
                return arithmetic::transpose(value).at(span);
            }
        }
        // c(t + 1)^2 with a scalar c is c · (t + 1)^2.
        if let Kind::Apply(callee, groups) = &base.kind
            && self.is_product(base)?
        {
            let factor = self.eval(callee)?;
            let inner = self.eval(&groups[0][0])?;
            let exponent_value = self.eval(exponent)?;
            let power = arithmetic::power(inner, &exponent_value).at(span)?;
            return arithmetic::multiply(factor, power).at(span);
        }
        // [F(t)]_0^1
        if let Kind::Subscript(list, lower) = &base.kind
            && let Kind::List(items) = &list.kind
            && items.len() == 1
            && !super::entries::is_bracketed(lower)
        {
            return self.eval_at(&items[0], lower, Some(exponent), span);
        }
        if self.called {
            let whole = Expr::new(Kind::Pow(Box::new(base.clone()), Box::new(exponent.clone())), span);
            if let Some(member) = self.member(&whole)? {
                return Ok(member);
            }
        }
        self.family_without_argument(base, span);
        let value = self.eval(base)?;
        // [[2, 0], [1, 3]]^2
        let value = match matrix_of(&value).filter(|matrix| matrix.is_square() && matrix.nrows() > 1) {
            Some(matrix) => Value::Matrix(matrix),
            None => value,
        };
        self.is_one_factor(exponent, "exponent")?;
        let exponent_value = self.eval(exponent)?;
        if matches!(value, Value::Function(_))
            && exponent_value.as_rational().is_some_and(|k| k.is_negative())
        {
            return Err(Diagnostic::error(
                Code::AmbiguousProduct,
                "the inverse function, or 1 over the function?",
            )
            .at(span)
            .reason("a function with a negative exponent")
            .hint("write 1/F(t) for the quotient; inverse functions are not computed"));
        }
        arithmetic::power(value, &exponent_value).map_err(|error| {
            let place = if error.code == Code::DivisionByZero { base.span } else { exponent.span };
            error.at(place)
        })
    }

    /// A remark on `B_1^3`, which is a power as long as no argument follows.
    fn family_without_argument(&mut self, base: &Expr, span: Span) {
        let Kind::Subscript(letter, lower) = &base.kind else { return };
        let Kind::Name(letter) = &letter.kind else { return };
        let known = self.lookup(&Symbol::new(letter)).is_some() || self.has_reading();
        let family =
            families::notation(letter, lower.len(), 1).is_some_and(|notation| notation.function.is_some());
        if family && !known && name_of(base, self).is_some_and(|name| self.lookup(&name).is_none()) {
            self.note(
                Diagnostic::note(
                    Code::StandardMeaning,
                    "read as a power; a member of the family has an argument",
                )
                .at(span)
                .hint(format!("write {letter}_i^n(t) for its value at t")),
            );
        }
    }

    pub(crate) fn eval_quotient(&mut self, left: &Expr, right: &Expr, style: Quotient) -> Evaluated {
        if style == Quotient::Slash && self.is_product(right)? {
            return Err(Diagnostic::error(Code::AmbiguousProduct, "how far does the denominator go?")
                .at(right.span)
                .reason("a product after '/'")
                .hint("write a/(b (c)) or (a/b) (c)"));
        }
        if let Some(derivative) = self.differential_quotient(left, right) {
            return self.eval(&derivative);
        }
        if style == Quotient::Slash {
            self.is_one_factor(right, "denominator")?;
        }
        let numerator = self.eval(left)?;
        let denominator = self.eval(right)?;
        arithmetic::divide(numerator, denominator).at(right.span)
    }
}

/// The letter of two nodes and more: x of x_0, x_1.
fn letter_of(nodes: &[Expr]) -> Option<&str> {
    fn letter(node: &Expr) -> Option<&str> {
        let Kind::Subscript(base, _) = &node.kind else { return None };
        let Kind::Name(letter) = &base.kind else { return None };
        Some(letter)
    }
    let common = letter(nodes.first()?)?;
    (nodes.len() > 1 && nodes.iter().all(|node| letter(node) == Some(common))).then_some(common)
}

/// Whether a letter stands in a formula without an index.
fn stands_in(letter: &str, expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Name(name) => name == letter,
        Kind::Subscript(..) => false,
        _ => {
            let mut found = false;
            expr.for_each_child(&mut |child| found = found || stands_in(letter, child));
            found
        }
    }
}

/// Whether an expression stands in parentheses, perhaps with a power.
fn is_group(expr: &Expr) -> bool {
    matches!(without_power(expr).kind, Kind::Group(_) | Kind::Tuple(_))
}

/// The base of a power, or what is none.
pub(super) fn without_power(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Pow(base, _) => base,
        _ => expr,
    }
}

/// Whether something follows a formula without a blank; what was not written has no place.
fn touches(factor: &Expr, next: Span) -> bool {
    factor.span.start < factor.span.end && factor.span.end == next.start
}
