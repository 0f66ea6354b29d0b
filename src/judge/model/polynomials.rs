//! Functions without a definition: polynomials with symbols as coefficients, and their polar forms.

use super::calls::{each, unclear, variable};
use super::objects::polar_arguments;
use super::{Evaluated, Model};
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, capital_of, is_capital, polar_names};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::ops::arithmetic;
use crate::language::ops::errors::division_by_zero;
use crate::language::value::Value;
use crate::language::write;
use crate::math::basis;
use crate::math::blossom::{Argument, PolarForm};
use crate::math::linalg;
use crate::math::number::Rational;
use crate::math::poly::{Coefficients, Fraction, Index, MultiPoly, Symbol};
use crate::math::ring::Ring;
use nalgebra::DMatrix;
use num_traits::{One, Zero};

/// Functions that are affine in each of more arguments, and not symmetric, have too many coefficients.
const MOST_ARGUMENTS: usize = 6;

/// Divided differences of more terms are not written out: those of letters over six nodes have 720.
const MOST_TERMS_OF_DIFFERENCES: usize = 1000;

/// The degree of unknown functions that no polar form gives a degree.
const USUAL_DEGREE: usize = 3;

impl Model {
    /// The value of a function that no definition fits.
    pub(super) fn function(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Evaluated {
        if head.base == "det"
            && let Some(value) = determinant_of_columns(values)
        {
            return Ok(value);
        }
        let letter = head.base.rsplit(' ').next().unwrap_or(&head.base).trim_end_matches("[]");
        if letter.chars().count() > 1 && crate::language::lexicon::letters::sign(letter).is_none() {
            // min, exp, a function called Q2: nobody says that it is a polynomial.
            let unknown = Diagnostic::error(Code::UnknownName, format!("'{letter}' has no meaning here"));
            return Err(unknown.at(expr.span));
        }
        // P_{i, …, k} for nodes of which nothing is said
        if head.lower.iter().any(|index| index.kind == Kind::Ellipsis) {
            return Err(unclear("what this function is", expr));
        }
        let shape = |own: &Head| {
            own.lower.len() == head.lower.len()
                && own.upper.len() == head.upper.len()
                && own.arguments.as_ref().map(Vec::len) == Some(values.len())
        };
        let indexed = !head.lower.is_empty() || !head.upper.is_empty();
        if indexed && self.context.visible(&head.base, &self.place).any(|(_, d, near)| near && shape(&d.head))
        {
            // β_i for i > n: nothing is said of it.
            let message = format!("no definition of {} fits these indices", head.base);
            return Err(Diagnostic::error(Code::Domain, message).at(expr.span));
        }
        if let [points, parameter] = values
            && points.len() > 1
            && parameter.len() == 1
            && !head.lower.is_empty()
        {
            return self.bezier(machine, head, points, &parameter[0], expr);
        }
        let upper = is_capital(&head.base);
        match values {
            [one] if one.len() == 1 && (upper || !self.is_paired(machine, head)) => {
                self.of_one_variable(machine, head, &one[0], expr)
            }
            [uv] if self.tensor && upper && uv.len() == 2 && head.lower.is_empty() => {
                self.tensor(head, &[uv[0].clone(), uv[0].clone()], &[uv[1].clone(), uv[1].clone()], expr)
            }
            [arguments] if head.lower.is_empty() && !(upper && arguments.len() > 1) => {
                let capital = capital_of(&head.base);
                // z(u, v) on a page without Z and polar forms is any function.
                if arguments.len() > 1 && !upper && !self.is_paired(machine, head) {
                    return Err(unclear("what this function is", expr));
                }
                self.polar(machine, &capital, head, arguments, expr)
            }
            [u, v] if head.lower.is_empty() => {
                let of = capital_of(&head.base);
                let surface =
                    |own: &Head| own.flat().len() == 2 && own.lower.is_empty() && own.upper.is_empty();
                let known =
                    self.context.visible(&of, &self.place).any(|(_, d, near)| near && surface(&d.head));
                match known && of != head.base {
                    true => self.tensor_of(machine, &Expr::name(of), u, v, expr),
                    false => self.tensor(head, u, v, expr),
                }
            }
            _ => Err(unclear("what this function is", expr)),
        }
    }

    /// f alone, where F is known: the polar form of degree 0.
    pub(super) fn without_arguments(
        &self,
        machine: &mut Machine,
        head: &Head,
        expr: &Expr,
    ) -> Option<Evaluated> {
        let capital = capital_of(&head.base);
        if !head.lower.is_empty()
            || !head.upper.is_empty()
            || capital == head.base
            || !self.context.letters.is_function(&head.base)
        {
            return None;
        }
        let known = self.context.visible(&capital, &self.place).any(|(_, definition, _)| {
            definition.head.flat().len() == 1
                && definition.head.lower.is_empty()
                && definition.head.upper.is_empty()
        });
        self.flexible.set(false);
        known.then(|| self.polar(machine, &capital, head, &[], expr))
    }

    /// The degree of F, if f is its polar form and F one certain polynomial.
    pub(super) fn degree_of_example(&self, machine: &mut Machine, head: &Head, expr: &Expr) -> Option<usize> {
        let capital = capital_of(&head.base);
        if !head.lower.is_empty() || !head.upper.is_empty() || capital == head.base {
            return None;
        }
        let (_, definition, _) = self.context.visible(&capital, &self.place).next()?;
        let crate::judge::page::context::Body::Formula(body) = &definition.body else { return None };
        if definition.head.flat().len() != 1 || !crate::judge::written::names::integer_names(body).is_empty()
        {
            return None;
        }
        let coefficients = self.coefficients(machine, &capital, expr).ok()?;
        Some(coefficients.iter().rposition(|c| !c.is_zero()).unwrap_or(0))
    }

    /// Whether a small letter is the polar form of a function with the capital one.
    fn is_paired(&self, machine: &mut Machine, head: &Head) -> bool {
        if self.curve.is_some() {
            return true;
        }
        let capital = capital_of(&head.base);
        let known = self.record.borrow().paired.contains(&capital);
        known || self.pairs.contains(&capital) || {
            let call = Head { base: capital, arguments: None, ..head.clone() };
            let own = vec![vec![Value::symbol(Symbol::new("t"))]];
            self.context.visible(&call.base, &self.place).next().is_some()
                && self.defined(machine, &call, Some(&own)).is_some()
        }
    }

    /// An unknown function of one variable: Σ F_k z^k.
    fn of_one_variable(
        &self,
        machine: &mut Machine,
        head: &Head,
        argument: &Value,
        expr: &Expr,
    ) -> Evaluated {
        // F(t) where only f(t_1, …, t_n) is known
        if head.lower.is_empty() && head.upper.is_empty() {
            let diagonal = |small: String| self.diagonal(machine, &small, argument);
            if let Some(result) = polar_names(&head.base).find_map(diagonal) {
                return result;
            }
        }
        let Value::Scalar(z) = argument else {
            return Err(unclear("what the value at this argument is", expr));
        };
        if self.opaque {
            let name = Symbol::new(&head.base).with_indices([Index::Word(z.to_string())]);
            self.record.borrow_mut().unknown.insert(head.base.clone());
            return Ok(Value::symbol(name));
        }
        let mut name = Symbol::new(format!("[{}]", head.base));
        // Each member of a family is a function of its own, also κ_{old} and κ^{new}.
        for index in head.lower.iter().chain(&head.upper) {
            let word = match machine.eval(index) {
                Ok(value) => value.as_int().map_or_else(|| write::text(&value.to_expr()), |i| i.to_string()),
                Err(_) => write::text(index),
            };
            name = name.with_indices([Index::Word(word)]);
        }
        let coefficients = if head.lower.is_empty() && head.upper.is_empty() {
            self.coefficients(machine, &head.base, expr)?
        } else {
            self.record.borrow_mut().unknown.insert(head.base.clone());
            (0..=USUAL_DEGREE as i64).map(|k| variable(name.numbered(k))).collect()
        };
        Ok(Value::Scalar(Coefficients::new(coefficients).value(z)))
    }

    fn diagonal(&self, machine: &mut Machine, small: &str, argument: &Value) -> Option<Evaluated> {
        let context = self.context.clone();
        let (_, definition, near) = context.visible(small, &self.place).find(|(_, definition, _)| {
            definition.head.lower.is_empty() && definition.head.flat().len() > 1
        })?;
        if !near || self.choices.general && self.is_example(definition) {
            return None;
        }
        let count = definition.head.flat().iter().filter(|e| e.kind != Kind::Ellipsis).count();
        let count = match self.degree {
            Some(degree) if definition.head.flat().len() != count => degree,
            _ => count,
        };
        let head = Head { arguments: None, ..definition.head.clone() };
        self.defined(machine, &head, Some(&[vec![argument.clone(); count]]))
    }

    /// The coefficients of the function called by a capital letter.
    fn coefficients(
        &self,
        machine: &mut Machine,
        capital: &str,
        expr: &Expr,
    ) -> Result<Vec<Fraction>, Diagnostic> {
        let z = Symbol::new("\u{25e6}");
        let head = Head {
            base: capital.to_owned(),
            lower: Vec::new(),
            upper: Vec::new(),
            parenthesized: false,
            arguments: None,
        };
        if let Some(result) = self.defined(machine, &head, Some(&[vec![Value::symbol(z.clone())]])) {
            let Value::Scalar(formula) = result? else {
                return Err(unclear("which polynomial this is", expr));
            };
            let Some(polynomial) = formula.as_polynomial() else {
                return Err(Diagnostic::error(Code::Type, "this is not a polynomial").at(expr.span));
            };
            return Ok(polynomial.coefficients_in(&z).into_iter().map(Fraction::from).collect());
        }
        let Some(degree) = self.degree else {
            self.record.borrow_mut().wants_degree = true;
            return Ok(vec![zero()]);
        };
        if let Some(curve) = &self.curve {
            // Σ b_i B_i^n in powers
            let matrix = basis::bernstein_to_power(degree);
            let points: Vec<Fraction> =
                (0..=degree).map(|i| variable(Symbol::new(&curve.points).numbered(i as i64))).collect();
            return Ok((0..=degree)
                .map(|row| {
                    (0..=row)
                        .fold(zero(), |sum, column| sum.plus(&points[column].scaled(&matrix[(row, column)])))
                })
                .collect());
        }
        self.record.borrow_mut().unknown.insert(capital.to_owned());
        let name = Symbol::new(format!("[{capital}]"));
        Ok((0..=degree).map(|k| variable(name.numbered(k as i64))).collect())
    }

    /// The polar form, with as many arguments as are given, of the function called by a capital letter.
    fn polar(
        &self,
        machine: &mut Machine,
        capital: &str,
        head: &Head,
        arguments: &[Value],
        expr: &Expr,
    ) -> Evaluated {
        self.record.borrow_mut().paired.insert(capital.to_owned());
        if let Some(result) = self.affine_by_definition(machine, head, arguments) {
            return result;
        }
        if !self.flexible.get() {
            self.record.borrow_mut().arities.insert(arguments.len());
        }
        if self.discovering {
            return Ok(Value::int(0));
        }
        let list = polar_arguments(arguments, expr)?;
        let mut coefficients = self.coefficients(machine, capital, expr)?;
        while coefficients.len() > 1 && coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        let degree = coefficients.len() - 1;
        let wrong_count = || {
            let message = format!(
                "{} is of degree {degree}, so its polar form has more than {} arguments",
                capital,
                arguments.len()
            );
            Diagnostic::error(Code::Arity, message).at(expr.span)
        };
        let more = arguments.len().checked_sub(degree).ok_or_else(wrong_count)?;
        coefficients.extend(std::iter::repeat_n(zero(), more));
        PolarForm::new(coefficients).value(&list).map(Value::Scalar).map_err(|_| wrong_count())
    }

    /// A function with symbols as coefficients that is affine in each argument: symmetric, if it is a polar form.
    pub(super) fn any_affine(
        &self,
        object: &Object,
        head: &Head,
        degree: usize,
        arguments: &[Value],
        expr: &Expr,
    ) -> Evaluated {
        let symmetric = object.sort == Sort::PolarForm;
        if degree != arguments.len() {
            self.record.borrow_mut().mixed = true;
            let message = format!("{} has {degree} arguments, not {}", head.base, arguments.len());
            return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
        }
        let list = polar_arguments(arguments, expr)?;
        self.record.borrow_mut().unknown.insert(head.base.clone());
        let name = Symbol::new(format!("[{}]", head.base));
        let coefficient = |number: usize| variable(name.numbered(number as i64));
        if symmetric || degree > MOST_ARGUMENTS {
            let form = PolarForm::new((0..=degree).map(coefficient).collect::<Vec<_>>());
            let value = form.value(&list).ok().filter(|_| symmetric);
            return value.map(Value::Scalar).ok_or_else(|| unclear("what this function is", expr));
        }
        let mut sum = zero();
        for chosen in 0..1_usize << degree {
            let factors = list.iter().enumerate().map(|(at, argument)| match (argument, chosen >> at & 1) {
                (Argument::Point(t) | Argument::Vector(t), 1) => t.clone(),
                (Argument::Point(_), _) => Fraction::one(),
                (Argument::Vector(_), _) => zero(),
            });
            sum = sum.plus(&factors.fold(coefficient(chosen), |product, factor| product.times(&factor)));
        }
        Ok(Value::Scalar(sum))
    }

    /// A polar form that is defined by its values at numbers, at a vector: f(…, p − q) is
    /// f(…, p) − f(…, q).
    pub(super) fn affine_by_definition(
        &self,
        machine: &mut Machine,
        head: &Head,
        arguments: &[Value],
    ) -> Option<Evaluated> {
        let at = arguments.iter().position(|value| matches!(value, Value::Vector(_)))?;
        let Value::Vector(v) = &arguments[at] else { return None };
        let with = |value: Fraction| {
            let mut list = arguments.to_vec();
            list[at] = Value::Scalar(value);
            vec![list]
        };
        let plain = Head { arguments: None, ..head.clone() };
        let known = |model: &Model, machine: &mut Machine, values: Vec<Vec<Value>>| {
            model.defined(machine, &plain, Some(&values)).or_else(|| {
                let list = &values[0];
                list.iter()
                    .any(|value| matches!(value, Value::Vector(_)))
                    .then(|| model.affine_by_definition(machine, head, list))
                    .flatten()
            })
        };
        let end = known(self, machine, with(v.clone()))?;
        let start = known(self, machine, with(zero()))?;
        Some(end.and_then(|end| arithmetic::add(end, arithmetic::negate(start?)?)))
    }

    /// P_n(b_0, …, b_n; t): the Bézier curve with these control points.
    fn bezier(
        &self,
        machine: &mut Machine,
        head: &Head,
        points: &[Value],
        parameter: &Value,
        expr: &Expr,
    ) -> Evaluated {
        let [degree] = head.lower.as_slice() else {
            return Err(unclear("what this function is", expr));
        };
        let degree = machine.eval_int(degree)?;
        self.note(format!("{}_n(b_0, ..., b_n; t) is the Bézier curve with these control points", head.base));
        if degree + 1 != points.len() as i64 {
            self.record.borrow_mut().mixed = true;
            let message =
                format!("a curve of degree {degree} has {} control points, not {}", degree + 1, points.len());
            return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
        }
        let Value::Scalar(t) = parameter else {
            return Err(unclear("what this parameter is", expr));
        };
        let one = Fraction::from_rational(&Rational::from_integer(1.into()));
        let mut row = points.to_vec();
        while row.len() > 1 {
            row = row
                .windows(2)
                .map(|pair| {
                    let left = each(pair[0].clone(), &|b| Ok(b.times(&one.minus(t))))?;
                    let right = each(pair[1].clone(), &|b| Ok(b.times(t)))?;
                    arithmetic::add(left, right)
                })
                .collect::<Result<_, _>>()?;
        }
        row.pop().ok_or_else(|| unclear("what this curve is", expr))
    }

    /// f[x_0, …, x_k] = Σ_i f(x_i) / Π_{j≠i} (x_i − x_j). For nodes that repeat the nodes are put in
    /// at the end: of a polynomial f this is a polynomial in its nodes.
    pub(super) fn divided_difference(
        &self,
        machine: &mut Machine,
        function: &Expr,
        nodes: &[Expr],
        expr: &Expr,
    ) -> Evaluated {
        let nodes = self.arguments(machine, nodes, None, expr)?;
        self.note("f[x_0, ..., x_k] is the divided difference");
        let nodes: Option<Vec<Fraction>> = nodes.iter().map(|node| node.as_scalar().cloned()).collect();
        let Some(nodes) = nodes else {
            return Err(unclear("what these nodes are", expr));
        };
        let repeated = nodes.iter().enumerate().any(|(i, x)| nodes[..i].contains(x));
        let places: Vec<Symbol> = (0..nodes.len()).map(|i| Symbol::indexed("node", i as i64)).collect();
        let values: Vec<(Symbol, Fraction)> = places.iter().cloned().zip(nodes.iter().cloned()).collect();
        let symbol = |place: &Symbol| Fraction::from(MultiPoly::symbol(place.clone()));
        let nodes = if repeated { places.iter().map(symbol).collect() } else { nodes };
        let mut row = Vec::with_capacity(nodes.len());
        for x in &nodes {
            let value = self.apply(machine, function, &[vec![Value::Scalar(x.clone())]], expr)?;
            let Value::Scalar(value) = value else {
                return Err(unclear("what the values of this function are", expr));
            };
            row.push(value);
        }
        for k in 1..nodes.len() {
            // Of a function whose values are letters it has as many terms as k + 1 nodes have orders.
            if row.iter().any(|entry| entry.numerator().len() > MOST_TERMS_OF_DIFFERENCES) {
                return Err(unclear("what a divided difference of so many nodes is", expr));
            }
            for i in 0..row.len() - 1 {
                let rise = Value::Scalar(row[i + 1].minus(&row[i]));
                let run = Value::Scalar(nodes[i + k].minus(&nodes[i]));
                let Value::Scalar(entry) = arithmetic::divide(rise, run)? else {
                    return Err(unclear("what this quotient is", expr));
                };
                row[i] = entry;
            }
            row.pop();
        }
        let mut sum = row.pop().unwrap_or_else(zero);
        if repeated {
            sum = sum.substitute(&values).map_err(|_| division_by_zero())?;
        }
        Ok(Value::Scalar(sum))
    }
}

fn zero() -> Fraction {
    Fraction::from(MultiPoly::zero())
}

/// det(a, b) of as many vectors as they have coordinates.
fn determinant_of_columns(values: &[Vec<Value>]) -> Option<Value> {
    let scalar = |value: Value| match value {
        Value::Scalar(formula) => Some(formula),
        _ => None,
    };
    let column = |value: &Value| -> Option<Vec<Fraction>> {
        value.clone().coordinates()?.into_iter().map(scalar).collect()
    };
    let columns: Vec<Vec<Fraction>> = values.iter().flatten().map(column).collect::<Option<_>>()?;
    let size = columns.len();
    if size < 2 || columns.iter().any(|column| column.len() != size) {
        return None;
    }
    let matrix = DMatrix::from_fn(size, size, |i, j| columns[j][i].clone());
    linalg::determinant(&matrix).ok().map(Value::Scalar)
}
