//! Divided differences one after the other, and Newton's form.

use super::lines::{
    chain, derivative, factor, fresh, line, power, product, sequence, subscript, symbol, term,
};
use super::schemes::{difference, point_expr};
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::language::value::{Derivation, Form, Line, polynomial_expr};
use crate::math::interpolate::{Datum, DividedDifferences, value_of};
use crate::math::number::{Rational, factorial};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;

/// The table of divided differences as equations, and the interpolating polynomial in Newton's
/// form and by powers. At a node that repeats, the data are values and derivatives.
///
/// Cost: that of the table, which is computed already, and of writing it out.
pub fn newton(table: &DividedDifferences<Fraction, Vec<Fraction>>, form: Form) -> Derivation {
    let newton = Newton { table, form };
    Derivation { title: Title::Newton.words(), lines: newton.lines(), language: None }
}

struct Newton<'a> {
    table: &'a DividedDifferences<Fraction, Vec<Fraction>>,
    form: Form,
}

fn node(i: usize) -> Expr {
    subscript("x", &[i])
}

impl Newton<'_> {
    /// The first of the nodes that are equal to node i.
    fn first(&self, i: usize) -> usize {
        let nodes = self.table.nodes();
        nodes.iter().position(|x| *x == nodes[i]).unwrap_or(i)
    }

    /// f(x_i), or f'(x_i), …
    fn datum(&self, i: usize, order: usize) -> Expr {
        Expr::apply(derivative(Expr::name("f"), order), vec![node(self.first(i))])
    }

    /// f[x_i, …, x_{i+k}], which is f(x_i) for k = 0.
    fn name(&self, i: usize, k: usize) -> Expr {
        if k == 0 {
            return self.datum(i, 0);
        }
        let nodes = Kind::List((i..=i + k).map(node).collect()).into();
        Expr::product(vec![Expr::name("f"), nodes])
    }

    fn value(&self, i: usize, k: usize) -> &Vec<Fraction> {
        &self.table.column(k)[i]
    }

    fn expr(&self, point: &[Fraction]) -> Expr {
        point_expr(self.form, point)
    }

    /// p − q with the numbers put in.
    fn numbers(&self, p: &[Fraction], q: &[Fraction]) -> Expr {
        if let ([x], [y], true) = (p, q, self.form.scalar) {
            return difference(x, y);
        }
        minus(self.expr(p), self.expr(q))
    }

    fn lines(&self) -> Vec<Line> {
        let (nodes, n) = (self.table.nodes(), self.table.degree());
        // Each difference is written with all its nodes.
        crate::budget::charge_terms((n as u64 + 1).saturating_pow(3) / 6);
        let mut lines = Vec::new();
        let given = nodes.iter().enumerate().map(|(i, x)| chain([node(i), polynomial_expr(x)]));
        lines.push(line(sequence(given.collect()), Reason::Nodes));
        let data = (0..=n).map(|i| {
            let (first, order) = (self.first(i), i - self.first(i));
            let share = Rational::from_integer(factorial(order));
            let datum: Vec<Fraction> = self.value(first, order).iter().map(|x| x.scaled(&share)).collect();
            chain([self.datum(i, order), self.expr(&datum)])
        });
        lines.push(line(sequence(data.collect()), Reason::Data));
        for k in 1..=n {
            for i in 0..=n - k {
                crate::budget::step();
                let value = self.value(i, k);
                if nodes[i] == nodes[i + k] {
                    let share = Expr::int(1).over(Kind::Factorial(Box::new(Expr::int(k as i64))).into());
                    let datum = self.datum(i, k);
                    let datum = if k == 1 { datum } else { Expr::product(vec![share, datum]) };
                    lines
                        .push(line(chain([self.name(i, k), datum, self.expr(value)]), Reason::EqualNodes(k)));
                    continue;
                }
                let quotient =
                    minus(self.name(i + 1, k - 1), self.name(i, k - 1)).over(minus(node(i + k), node(i)));
                let numbers = self
                    .numbers(self.value(i + 1, k - 1), self.value(i, k - 1))
                    .over(difference(&nodes[i + k], &nodes[i]));
                let sides = [self.name(i, k), quotient, numbers, self.expr(value)];
                lines.push(line(chain(sides), Reason::DividedDifference(k)));
            }
        }
        lines.extend(self.polynomial());
        lines
    }

    fn polynomial(&self) -> [Line; 3] {
        let (nodes, n) = (self.table.nodes(), self.table.degree());
        let taken: Vec<Symbol> =
            nodes.iter().chain(self.table.column(0).iter().flatten()).flat_map(Fraction::variables).collect();
        let variable = fresh(&["t", "x", "s", "u"], &taken);
        let t = symbol(&variable);
        let left = || Expr::apply(Expr::name("p"), vec![polynomial_expr(&t)]);
        let plus = |expr| Term { sign: Sign::Plus, expr };
        let names = (0..=n).map(|k| {
            let factors = (0..k).map(|i| minus(polynomial_expr(&t), node(i)).grouped());
            plus(product(std::iter::once(self.name(0, k)).chain(factors).collect()))
        });
        let numbers = (0..=n).filter(|&k| !self.value(0, k).is_origin()).map(|k| {
            let factors = powers((0..k).map(|i| factor(polynomial_expr(&t.minus(&nodes[i])))));
            match (self.value(0, k).as_slice(), self.form.scalar) {
                ([c], true) => term(c, factors),
                (point, _) => plus(product(std::iter::once(self.expr(point)).chain(factors).collect())),
            }
        });
        let by_power = self.table.newton_form().to_power();
        let by_powers = value_of(&by_power, &t).expect("a table has at least one value");
        [
            line(chain([left(), Expr::sum(names.collect())]), Reason::NewtonForm),
            line(chain([left(), Expr::sum(numbers.collect())]), Reason::NumbersPutIn),
            line(chain([left(), self.expr(&by_powers)]), Reason::ByPowers),
        ]
    }
}

fn minus(a: Expr, b: Expr) -> Expr {
    Expr::sum(vec![Term { sign: Sign::Plus, expr: a }, Term { sign: Sign::Minus, expr: b }])
}

/// The factors, neighbours that are equal as a power.
fn powers(factors: impl Iterator<Item = Expr>) -> Vec<Expr> {
    let mut runs: Vec<(Expr, usize)> = Vec::new();
    for factor in factors {
        match runs.last_mut() {
            Some((before, count)) if *before == factor => *count += 1,
            _ => runs.push((factor, 1)),
        }
    }
    runs.into_iter().filter_map(|(base, count)| power(base, count)).collect()
}
