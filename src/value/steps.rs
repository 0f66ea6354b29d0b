//! Derivations as lines of formulas with reasons, from the steps of [`crate::blossom`].

use super::polar::{Notation, Polar, PolarKind};
use super::to_expr::{polynomial_expr, symbol_expr};
use crate::blossom::{Method, PolarForm, Step, Weights};
use crate::expr::{Expr, Kind, Rel, Sign, Term};
use crate::number::{Int, Rational};
use crate::poly::{Fraction, MultiPoly, Symbol};
use crate::ring::Ring;
use num_traits::{One, Zero};

/// One line of a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The formula, usually an equation.
    pub formula: Expr,
    /// Why it holds. Formulas stand between backticks, in plain notation.
    pub reason: String,
}

fn line(formula: Expr, reason: impl Into<String>) -> Line {
    Line { formula, reason: reason.into() }
}

fn equation(left: Expr, right: Expr) -> Expr {
    Expr::relation(left, Rel::Eq, right)
}

fn scalar(f: &Fraction) -> Expr {
    polynomial_expr(f)
}

fn constant(q: &Rational) -> Fraction {
    Fraction::from(q.clone())
}

/// Σ w_k e_k of the first m arguments, written out.
fn symmetric(weights: &Weights<Fraction>, variable: &Symbol) -> Expr {
    let count = weights.len().saturating_sub(1);
    let row = crate::number::binomial_row(count);
    let coefficients = weights.iter().zip(row).map(|(w, b)| w.scaled(&Rational::from_integer(b))).collect();
    let polar = Polar {
        kind: PolarKind::Univariate(PolarForm::new(coefficients)),
        variables: vec![variable.clone()],
    };
    polar.body(Notation::Grouped)
}

/// F(t) = Σ c_i t^i
fn diagonal_equation(form: &PolarForm<Fraction>, variable: &Symbol) -> Expr {
    let t = Fraction::from(MultiPoly::symbol(variable.clone()));
    let value = form.coefficients().iter().rev().fold(Fraction::zero(), |sum, c| sum.times(&t).plus(c));
    equation(Expr::apply(Expr::name("F"), vec![symbol_expr(variable)]), scalar(&value))
}

fn sigma(i: usize, n: usize) -> Expr {
    Kind::Subscript(Box::new(Expr::name("sigma")), vec![Expr::int(i as i64), Expr::int(n as i64)]).into()
}

/// The derivation of a polar form by one of the methods; the last line is the result.
/// Only forms of one variable have these derivations; others give the result alone.
pub fn polar_steps(polar: &Polar, method: Method) -> Vec<Line> {
    let result = line(polar.equation(Expr::name("f"), Notation::Grouped), "the polar form");
    let PolarKind::Univariate(form) = &polar.kind else { return vec![result] };
    let variable = &polar.variables[0];
    let n = form.degree();
    // Any development point will do; a symbol shows that it drops out.
    let tau = if method == Method::Taylor {
        Fraction::from(MultiPoly::symbol(Symbol::new("tau")))
    } else {
        Fraction::zero()
    };
    let derivation = form.derive(method, &tau);
    let mut lines =
        vec![line(diagonal_equation(form, variable), format!("a polynomial of degree at most {n}"))];
    let argument = |k: usize| symbol_expr(&variable.numbered(k as i64));
    if matches!(method, Method::Taylor | Method::Parts) {
        let factors = (1..=n).map(|k| {
            Expr::sum(vec![
                Term { sign: Sign::Plus, expr: argument(k) },
                Term { sign: Sign::Minus, expr: Expr::name("tau") },
            ])
            .grouped()
        });
        let phi = Expr::apply(Expr::name("Phi"), vec![Expr::name("tau")]);
        lines.push(line(equation(phi, Expr::product(factors.collect())), "the auxiliary function"));
    }
    for step in &derivation.steps {
        lines.extend(step_line(step, n, variable));
    }
    let last = Polar { kind: PolarKind::Univariate(derivation.form), variables: polar.variables.clone() };
    lines.push(line(last.equation(Expr::name("f"), Notation::Grouped), closing(method)));
    lines
}

fn closing(method: Method) -> &'static str {
    match method {
        Method::Elementary | Method::Probability => "put together",
        Method::Taylor => "the sum of all terms; `tau` drops out",
        Method::Parts => "the sum does not depend on `tau`, so `tau = 0` will do",
        Method::Laguerre => "after all `n` polars `tau` is gone",
        Method::Bezier => "the sum over all Bézier points",
    }
}

fn mean_of(count: &Int) -> String {
    if count.is_one() { "the only product".to_owned() } else { format!("the mean of {count} products") }
}

fn step_line(step: &Step<Fraction>, n: usize, variable: &Symbol) -> Option<Line> {
    let t = symbol_expr(variable);
    let power = |i: usize| match i {
        0 => Expr::int(1),
        1 => t.clone(),
        _ => t.clone().power(Expr::int(i as i64)),
    };
    let unit = |i: usize, weight: Fraction| {
        let mut weights = vec![Fraction::zero(); n + 1];
        weights[i] = weight;
        symmetric(&weights, variable)
    };
    Some(match step {
        Step::Replace { power: i, coefficient, subsets, .. } => {
            if coefficient.is_zero() || *i == 0 {
                return None;
            }
            let mean = unit(*i, constant(&Rational::new(Int::ONE, subsets.clone())));
            line(equation(sigma(*i, n), mean), format!("replaces `{variable}^{i}`: {}", mean_of(subsets)))
        }
        Step::Expect { size, coefficient, probability, .. } => {
            if coefficient.is_zero() || *size == 0 {
                return None;
            }
            let mean = unit(*size, constant(probability));
            line(
                Expr::relation(power(*size), Rel::MapsTo, mean),
                format!(
                    "expected product of {size} of {n} arguments drawn at random, each set with probability `{probability}`"
                ),
            )
        }
        Step::TaylorTerm { order, derivative, auxiliary, factor, term, .. } => {
            if derivative.is_zero() {
                return None;
            }
            let mut factors = vec![];
            if !factor.is_one() {
                factors.push(Expr::number(factor).grouped_if_negative());
            }
            factors.push(symmetric(auxiliary, variable).grouped());
            factors.push(scalar(derivative).grouped());
            line(
                equation(Expr::product(factors), symmetric(term, variable)),
                format!(
                    "term `i = {order}`: `(-1)^{}/{n}! Phi^{{({})}}(tau) F^{{({order})}}(tau)`",
                    n - order,
                    n - order
                ),
            )
        }
        Step::Telescope { order, left, right, .. } => {
            let tau = |parts: &[Weights<Fraction>]| -> Expr {
                let terms: Vec<Term> = parts
                    .iter()
                    .enumerate()
                    .rev()
                    .filter(|(_, weights)| weights.iter().any(|w| !w.is_zero()))
                    .map(|(j, weights)| {
                        let body = symmetric(weights, variable).grouped();
                        let expr = match j {
                            0 => body,
                            1 => Expr::product(vec![body, Expr::name("tau")]),
                            _ => Expr::product(vec![body, Expr::name("tau").power(Expr::int(j as i64))]),
                        };
                        Term { sign: Sign::Plus, expr }
                    })
                    .collect();
                Expr::sum(terms)
            };
            let parts = Kind::Sequence(vec![tau(left), tau(right)]).into();
            line(
                parts,
                if *order < n {
                    format!(
                        "the derivative by `tau` of term `i = {order}`, in two parts; the second cancels the first of `i = {}`",
                        order + 1
                    )
                } else {
                    format!("the derivative by `tau` of term `i = {order}`, in two parts; the second is 0")
                },
            )
        }
        Step::Polar { argument, degree, result } => {
            let point = variable.numbered(*argument as i64);
            let name = Kind::Subscript(Box::new(Expr::name("p")), vec![Expr::int(*argument as i64)]).into();
            let terms: Vec<Term> = result
                .iter()
                .enumerate()
                .rev()
                .filter(|(_, weights)| weights.iter().any(|w| !w.is_zero()))
                .map(|(j, weights)| {
                    let body = symmetric(weights, variable);
                    let expr = match j {
                        0 => body,
                        1 => Expr::product(vec![body.grouped(), Expr::name("tau")]),
                        _ => {
                            Expr::product(vec![body.grouped(), Expr::name("tau").power(Expr::int(j as i64))])
                        }
                    };
                    Term { sign: Sign::Plus, expr }
                })
                .collect();
            line(
                equation(Expr::apply(name, vec![Expr::name("tau")]), Expr::sum(terms)),
                format!("the polar by `{point}`: `p(tau) + ({point} - tau)/{degree} p'(tau)`"),
            )
        }
        Step::BezierTerm { index, point, blossom } => {
            if point.is_zero() {
                return None;
            }
            let weights: Weights<Fraction> = blossom.iter().map(constant).collect();
            let name = Kind::Subscript(Box::new(Expr::name("b")), vec![Expr::int(*index as i64)]).into();
            line(
                Kind::Sequence(vec![equation(name, scalar(point)), symmetric(&weights, variable)]).into(),
                format!("Bézier point {index} and the polar form of its Bernstein polynomial"),
            )
        }
    })
}

/// The steps of a sum, product or composition: both operands, what is symmetrised, the result.
pub fn combination_steps(name: &str, f: &Polar, g: &Polar, result: &Polar) -> Vec<Line> {
    let (PolarKind::Univariate(left), PolarKind::Univariate(right), PolarKind::Univariate(form)) =
        (&f.kind, &g.kind, &result.kind)
    else {
        return vec![line(result.equation(Expr::name("h"), Notation::Grouped), "the result")];
    };
    let t = &result.variables[0];
    let renamed = |form: &PolarForm<Fraction>| Polar {
        kind: PolarKind::Univariate(form.clone()),
        variables: vec![t.clone()],
    };
    let (f, g) = (renamed(left), renamed(right));
    let mut lines = vec![
        line(f.equation(Expr::name("f"), Notation::Grouped), "the polar form of `F`"),
        line(g.equation(Expr::name("g"), Notation::Grouped), "the polar form of `G`"),
    ];
    let argument = |k: usize| symbol_expr(&t.numbered(k as i64));
    let (m, n) = (left.degree(), right.degree());
    match name {
        "polar_sum" => {
            for (form, other, letter) in [(left, right, "f"), (right, left, "g")] {
                if form.degree() < other.degree() {
                    let raised = renamed(&form.elevate(other.degree() - form.degree()));
                    let name: Expr = Expr::name(letter).power(Expr::name("ast"));
                    lines.push(line(
                        raised.equation(name, Notation::Grouped),
                        "elevated: the mean over all ways to leave out arguments",
                    ));
                }
            }
        }
        "polar_product" => {
            let range = |from: usize, to: usize| (from..=to).map(argument).collect::<Vec<_>>();
            let product = Expr::product(vec![
                Expr::apply(Expr::name("f"), range(1, m)),
                Expr::apply(Expr::name("g"), range(m + 1, m + n)),
            ]);
            let body =
                Expr::product(vec![f.body(Notation::Grouped).grouped(), shifted_body(&g, m, t).grouped()]);
            lines.push(line(equation(product, body), "distinct arguments, multiplied; then symmetrise"));
        }
        _ => {
            let calls: Vec<Expr> = (0..m)
                .map(|k| Expr::apply(Expr::name("g"), (k * n + 1..=(k + 1) * n).map(argument).collect()))
                .collect();
            let inner: Vec<Fraction> = (0..m).map(|k| value_of(&g, k * n, t)).collect();
            if let Ok(value) = left.value_at(&inner) {
                lines.push(line(
                    equation(Expr::apply(Expr::name("f"), calls), scalar(&value)),
                    "`g` with distinct arguments put into `f`; then symmetrise",
                ));
            }
        }
    }
    let last = Polar { kind: PolarKind::Univariate(form.clone()), variables: vec![t.clone()] };
    let reason =
        if name == "polar_sum" { "added" } else { "the mean over all permutations of the arguments" };
    lines.push(line(last.equation(Expr::name("h"), Notation::Grouped), reason));
    lines
}

/// g(t_{k+1}, …, t_{k+n}) as a polynomial.
fn value_of(g: &Polar, offset: usize, t: &Symbol) -> Fraction {
    let PolarKind::Univariate(form) = &g.kind else { return Fraction::zero() };
    let arguments: Vec<Fraction> = (1..=form.degree())
        .map(|j| Fraction::from(MultiPoly::symbol(t.numbered((offset + j) as i64))))
        .collect();
    form.value_at(&arguments).unwrap_or_else(|_| Fraction::zero())
}

fn shifted_body(g: &Polar, offset: usize, t: &Symbol) -> Expr {
    scalar(&value_of(g, offset, t))
}

impl Expr {
    /// In brackets if it begins with a minus sign, so that it can stand in a product.
    fn grouped_if_negative(self) -> Expr {
        if matches!(&self.kind, Kind::Add(_)) { self.grouped() } else { self }
    }
}
