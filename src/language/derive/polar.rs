//! A polar form by each of the six methods of [`crate::math::blossom::methods`](crate::math::blossom::Method).

use std::sync::Arc;

use num_traits::Zero;

use super::lines::{
    TERMS_UP_TO, call, chain, combination, derivative, factor, fresh, line, multiple, power, product,
    subscript, symbol,
};
use super::words::{Reason, Title};
use crate::formula::{BigOp, Expr, Kind, Rel, Sign, Term};
use crate::language::lexicon::families;
use crate::language::value::{
    Derivation, Line, Notation, Polar, PolarKind, grouped_expr, polynomial_expr, symbol_expr,
};
use crate::math::blossom::{Method, PolarForm, Step, Weights};
use crate::math::number::{Combinations, Rational, binomial, binomial_row};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;

/// The names of a polynomial and of its polar form in a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Names {
    /// The polynomial, usually F.
    pub polynomial: Expr,
    /// Its polar form, usually f.
    pub form: Expr,
    /// The number of the coordinate, which the names of helpers get as a first index.
    pub coordinate: Option<usize>,
}

impl Default for Names {
    fn default() -> Self {
        Names { polynomial: Expr::name("F"), form: Expr::name("f"), coordinate: None }
    }
}

impl Names {
    /// F_k and f_k, for the coordinates of a curve.
    pub fn coordinate(k: usize) -> Self {
        Names { polynomial: subscript("F", &[k]), form: subscript("f", &[k]), coordinate: Some(k) }
    }
}

/// A polar form of one variable as a value.
pub(super) fn univariate(form: PolarForm<Fraction>, variable: &Symbol) -> Polar {
    Polar { kind: PolarKind::Univariate(form), variables: vec![variable.clone()] }
}

/// F(t) = Σ c_i t^i
pub(super) fn given(polynomial: Expr, polar: &Polar, reason: Reason) -> Line {
    let arguments = polar.variables.iter().map(symbol_expr).collect();
    line(chain([Expr::apply(polynomial, arguments), grouped_expr(&polar.diagonal())]), reason)
}

/// Σ w_k e_k of the first m arguments, written out.
fn symmetric(weights: &Weights<Fraction>, variable: &Symbol) -> Expr {
    let row = binomial_row(weights.len().saturating_sub(1));
    let coefficients = weights.iter().zip(row).map(|(w, b)| w.scaled(&Rational::from_integer(b))).collect();
    univariate(PolarForm::new(coefficients), variable).body(Notation::Grouped)
}

/// The derivation of a polar form by one of the methods; its last line is the result.
///
/// Forms of several variables are found by replacing each monomial, whatever the method.
/// Cost: that of [`PolarForm::derive`] and of writing out the form.
///
/// ```
/// use polarform::blossom::{Method, PolarForm};
/// use polarform::derive::{Names, polar};
/// use polarform::poly::{Fraction, Symbol};
/// use polarform::value::{Language, Polar, PolarKind};
/// use polarform::write::{Format, write_derivation};
///
/// let form = PolarForm::new([0, 2, 1].map(|c| Fraction::from(polarform::number::integer(c))).to_vec());
/// let form = Polar { kind: PolarKind::Univariate(form), variables: vec![Symbol::new("t")] };
/// let derivation = polar(&form, Method::Laguerre, &Names::default());
/// let text = write_derivation(&derivation, Format::Text, Language::English)?;
/// assert!(text.ends_with("f(t1, t2) = t1 t2 + (t1 + t2)    [put together]"));
/// # Ok::<(), polarform::write::WriteError>(())
/// ```
pub fn polar(polar: &Polar, method: Method, names: &Names) -> Derivation {
    let lines = match &polar.kind {
        PolarKind::Univariate(form) => {
            let derivation = Univariate::new(form, &polar.variables[0], names);
            derivation.lines(method)
        }
        kind => {
            let reason = match kind {
                PolarKind::Tensor(_) => Reason::ProductsOfMeans,
                _ => Reason::HandedOut,
            };
            let result = polar.equation(names.form.clone(), Notation::Grouped);
            vec![given(names.polynomial.clone(), polar, Reason::Given), line(result, reason)]
        }
    };
    Derivation { title: Title::Polar(method).words(), lines, language: None }
}

/// The same for each coordinate of a curve, with the names F_1, F_2, …; a single polynomial is F.
pub fn polar_of_curve(coordinates: &[Arc<Polar>], method: Method) -> Derivation {
    if let [one] = coordinates {
        return polar(one, method, &Names::default());
    }
    let lines = coordinates.iter().enumerate();
    let lines = lines.flat_map(|(k, form)| polar(form, method, &Names::coordinate(k + 1)).lines);
    Derivation { title: Title::Polar(method).words(), lines: lines.collect(), language: None }
}

/// Bernstein polynomials up to this degree have their polar forms written as sums of products.
const PRODUCTS_UP_TO: usize = 4;

struct Univariate<'a> {
    form: &'a PolarForm<Fraction>,
    variable: &'a Symbol,
    names: &'a Names,
    /// n
    degree: usize,
    /// τ
    tau: Symbol,
    /// The index of the sum.
    index: Symbol,
}

impl<'a> Univariate<'a> {
    fn new(form: &'a PolarForm<Fraction>, variable: &'a Symbol, names: &'a Names) -> Self {
        let mut taken: Vec<Symbol> = form.coefficients().iter().flat_map(Fraction::variables).collect();
        taken.push(variable.clone());
        let tau = fresh(&["tau", "s", "u", "x"], &taken);
        taken.push(tau.clone());
        let index = fresh(&["i", "k", "j"], &taken);
        Univariate { form, variable, names, degree: form.degree(), tau, index }
    }

    fn lines(&self, method: Method) -> Vec<Line> {
        let whole = univariate(self.form.clone(), self.variable);
        let mut lines = vec![given(self.names.polynomial.clone(), &whole, Reason::DegreeAtMost(self.degree))];
        lines.extend(match method {
            Method::Elementary => self.elementary(),
            Method::Probability => self.probability(),
            Method::Taylor => self.taylor(),
            Method::Parts => self.parts(),
            Method::Laguerre => self.laguerre(),
            Method::Bezier => self.bezier(),
        });
        lines
    }

    fn argument(&self, k: usize) -> Expr {
        symbol_expr(&self.variable.numbered(k as i64))
    }

    fn arguments(&self) -> Vec<Expr> {
        (1..=self.degree).map(|k| self.argument(k)).collect()
    }

    /// letter_i, or letter_{k,i} for coordinate k.
    fn helper(&self, letter: &str, i: usize) -> Expr {
        match self.names.coordinate {
            Some(k) => subscript(letter, &[k, i]),
            None => subscript(letter, &[i]),
        }
    }

    fn tau(&self) -> Expr {
        symbol_expr(&self.tau)
    }

    fn at_tau(&self, function: Expr) -> Expr {
        Expr::apply(function, vec![self.tau()])
    }

    /// f(t_1, …, t_n)
    fn value(&self) -> Expr {
        call(self.names.form.clone(), self.arguments())
    }

    /// f(t_1, …, t_n) written out.
    fn result(&self, reason: Reason) -> Line {
        let body = univariate(self.form.clone(), self.variable).body(Notation::Grouped);
        line(chain([self.value(), body]), reason)
    }

    /// The powers whose coefficients are not 0, the highest first, without the constant.
    fn powers(&self) -> impl Iterator<Item = usize> {
        (1..=self.degree).rev().filter(|&i| !self.form.coefficients()[i].is_zero())
    }

    /// The mean of the products of i arguments, as σ_{i,n} or written out.
    fn mean_of_products(&self, i: usize, notation: Notation) -> Expr {
        let mut unit = vec![Fraction::zero(); self.degree + 1];
        unit[i] = Fraction::from(crate::math::number::integer(1));
        univariate(PolarForm::new(unit), self.variable).body(notation)
    }

    fn elementary(&self) -> Vec<Line> {
        let mut lines = Vec::new();
        for i in self.powers() {
            let sides = [Notation::Sigma, Notation::Grouped].map(|n| self.mean_of_products(i, n));
            let reason = Reason::PowerToMean {
                variable: self.variable.clone(),
                power: i,
                of: binomial(self.degree, i),
            };
            lines.push(line(chain(sides), reason));
        }
        if !lines.is_empty() {
            let body = univariate(self.form.clone(), self.variable).body(Notation::Sigma);
            lines.push(line(chain([self.value(), body]), Reason::PowersReplaced));
        }
        lines.push(self.result(Reason::PutTogether));
        lines
    }

    fn probability(&self) -> Vec<Line> {
        let n = self.degree;
        let mut lines = Vec::new();
        let mut terms = Vec::new();
        for i in self.powers() {
            let count = binomial(n, i);
            let probability = Rational::new(1.into(), count.clone());
            let mut sides = vec![self.helper("E", i)];
            if count <= TERMS_UP_TO.into() {
                let products = Combinations::new(n, i).map(|chosen| {
                    let factors = chosen.iter().map(|&k| self.argument(k + 1)).collect();
                    (Fraction::from(probability.clone()), Expr::product(factors))
                });
                sides.push(combination(products));
            }
            sides.push(self.mean_of_products(i, Notation::Grouped));
            let power = Reason::Expectation { size: i, of: n, probability };
            lines.push(line(chain(sides), power));
            terms.push((self.form.coefficients()[i].clone(), self.helper("E", i)));
        }
        if !terms.is_empty() {
            terms.push((self.form.coefficients()[0].clone(), Expr::int(1)));
            lines.push(line(chain([self.value(), combination(terms)]), Reason::ExpectationIsLinear));
        }
        lines.push(self.result(Reason::PutTogether));
        lines
    }

    /// Φ(τ) = ∏ (t_j − τ)
    fn auxiliary(&self) -> Line {
        let factor = |k: usize| {
            let plus = Term { sign: Sign::Plus, expr: self.argument(k) };
            let minus = Term { sign: Sign::Minus, expr: self.tau() };
            Expr::sum(vec![plus, minus]).grouped()
        };
        let product = match self.degree {
            1 => match factor(1).kind {
                Kind::Group(inner) => *inner,
                kind => kind.into(),
            },
            n => Expr::product((1..=n).map(factor).collect()),
        };
        line(chain([self.at_tau(Expr::name("Phi")), product]), Reason::Auxiliary)
    }

    /// ±1/n! Φ^{(a)}(τ) F^{(b)}(τ), the sign that of term i.
    fn taylor_product(&self, i: usize, a: usize, b: usize) -> Expr {
        let mut factor = Rational::new(1.into(), crate::math::number::factorial(self.degree));
        if (self.degree - i) % 2 == 1 {
            factor = -factor;
        }
        let phi = self.at_tau(derivative(Expr::name("Phi"), a));
        multiple(&factor, vec![phi, self.at_tau(derivative(self.names.polynomial.clone(), b))])
    }

    fn taylor(&self) -> Vec<Line> {
        let n = self.degree;
        let (index, last) = (symbol_expr(&self.index), Expr::int(n as i64));
        let rest = || {
            let minus = Term { sign: Sign::Minus, expr: index.clone() };
            Expr::sum(vec![Term { sign: Sign::Plus, expr: last.clone() }, minus])
        };
        let upper = |function: Expr, order: Expr| Expr::from(Kind::Upper(Box::new(function), vec![order]));
        let sign = Expr::int(-1).grouped().power(rest());
        let body = Expr::product(vec![
            sign.over(Kind::Factorial(Box::new(last.clone())).into()),
            self.at_tau(upper(Expr::name("Phi"), rest())),
            self.at_tau(upper(self.names.polynomial.clone(), index.clone())),
        ]);
        let sum: Expr = Kind::Big {
            op: BigOp::Sum,
            lower: vec![Expr::relation(index.clone(), Rel::Eq, Expr::int(0))],
            upper: Some(Box::new(last.clone())),
            body: Box::new(body),
        }
        .into();
        let mut lines = vec![self.auxiliary(), line(chain([self.value(), sum]), Reason::TaylorForm)];
        for step in self.form.derive(Method::Taylor, &symbol(&self.tau)).steps {
            let Step::TaylorTerm { order, derivative, auxiliary, factor, term, .. } = step else { continue };
            if derivative.is_zero() {
                continue;
            }
            let mut numbers =
                vec![self.bracket(&auxiliary), super::lines::factor(polynomial_expr(&derivative))];
            // A number stands better before the bracket.
            if derivative.as_rational().is_some() {
                numbers.reverse();
            }
            let sides = [
                self.taylor_product(order, n - order, order),
                multiple(&factor, numbers),
                symmetric(&term, self.variable),
            ];
            lines.push(line(chain(sides), Reason::TermNumber(order)));
        }
        lines.push(self.result(Reason::TauDropsOut(self.tau.clone())));
        lines
    }

    fn bracket(&self, weights: &Weights<Fraction>) -> Expr {
        factor(symmetric(weights, self.variable))
    }

    fn parts(&self) -> Vec<Line> {
        let n = self.degree;
        let name = |i: usize| self.helper("T", i);
        let prime = |i: usize| self.at_tau(derivative(name(i), 1));
        let mut lines = vec![self.auxiliary()];
        for i in 0..=n {
            let sides = [self.at_tau(name(i)), self.taylor_product(i, n - i, i)];
            lines.push(line(chain(sides), Reason::TermNumber(i)));
        }
        for i in 0..=n {
            let plus = |expr| Term { sign: Sign::Plus, expr };
            let mut terms = Vec::new();
            // Beyond the n-th derivative both functions are 0.
            for (a, b) in [(n - i + 1, i), (n - i, i + 1)] {
                if a <= n && b <= n {
                    match self.taylor_product(i, a, b) {
                        Expr { kind: Kind::Add(inner), .. } => terms.extend(inner),
                        other => terms.push(plus(other)),
                    }
                }
            }
            let reason = if i == 0 { Reason::ProductRule } else { Reason::CancelsWithTheTermBefore };
            lines.push(line(chain([prime(i), Expr::sum(terms)]), reason));
        }
        let total = |items: Vec<Expr>| {
            Expr::sum(items.into_iter().map(|expr| Term { sign: Sign::Plus, expr }).collect())
        };
        let vanishing = total((0..=n).map(prime).collect());
        lines.push(line(chain([vanishing, Expr::int(0)]), Reason::Telescopes));
        let at_zero = |i: usize| Expr::apply(name(i), vec![Expr::int(0)]);
        for step in self.form.derive(Method::Taylor, &Fraction::zero()).steps {
            let Step::TaylorTerm { order, term, .. } = step else { continue };
            let sides = [at_zero(order), symmetric(&term, self.variable)];
            lines.push(line(chain(sides), Reason::TauIsZero(self.tau.clone())));
        }
        let sum = total((0..=n).map(at_zero).collect());
        lines.push(line(chain([self.value(), sum]), Reason::AnyTau(self.tau.clone())));
        lines.push(self.result(Reason::PutTogether));
        lines
    }

    /// Σ_j p_j τ^j with symmetric coefficients p_j.
    fn in_tau(&self, by_power: &[Weights<Fraction>]) -> Expr {
        let mut terms = Vec::new();
        for (j, weights) in by_power.iter().enumerate().rev() {
            if weights.iter().all(Fraction::is_zero) {
                continue;
            }
            match (symmetric(weights, self.variable), power(self.tau(), j)) {
                (Expr { kind: Kind::Add(inner), .. }, None) => terms.extend(inner),
                (body, None) => terms.push(Term { sign: Sign::Plus, expr: body }),
                (Expr { kind: Kind::Number(q), .. }, Some(power))
                    if q == Rational::from_integer(1.into()) =>
                {
                    terms.push(Term { sign: Sign::Plus, expr: power });
                }
                // A single negative term keeps its sign in front.
                (Expr { kind: Kind::Add(mut inner), .. }, Some(power)) if inner.len() == 1 => {
                    let Term { sign, expr } = inner.remove(0);
                    terms.push(Term { sign, expr: product(vec![expr, power]) });
                }
                (body, Some(power)) => {
                    terms.push(Term { sign: Sign::Plus, expr: product(vec![factor(body), power]) });
                }
            }
        }
        Expr::sum(terms)
    }

    fn laguerre(&self) -> Vec<Line> {
        let name = |k: usize| self.helper("p", k);
        let start = [self.at_tau(name(0)), self.at_tau(self.names.polynomial.clone())];
        let mut lines = vec![line(chain(start), Reason::StartOfPolars)];
        for step in self.form.derive(Method::Laguerre, &Fraction::zero()).steps {
            let Step::Polar { argument, degree, result } = step else { continue };
            let point = self.argument(argument);
            let minus = Term { sign: Sign::Minus, expr: self.tau() };
            let distance = Expr::sum(vec![Term { sign: Sign::Plus, expr: point }, minus]);
            let share =
                if degree == 1 { distance.grouped() } else { distance.over(Expr::int(degree as i64)) };
            let slope = Expr::product(vec![share, self.at_tau(derivative(name(argument - 1), 1))]);
            let plus = |expr| Term { sign: Sign::Plus, expr };
            let polar = Expr::sum(vec![plus(self.at_tau(name(argument - 1))), plus(slope)]);
            let reason = Reason::PolarBy(self.variable.numbered(argument as i64));
            lines.push(line(chain([self.at_tau(name(argument)), polar, self.in_tau(&result)]), reason));
        }
        let end = self.at_tau(name(self.degree));
        lines.push(line(chain([self.value(), end]), Reason::AfterAllPolars(self.tau.clone())));
        lines.push(self.result(Reason::PutTogether));
        lines
    }

    fn bezier(&self) -> Vec<Line> {
        let n = self.degree;
        let t = symbol_expr(self.variable);
        let bernstein = |i: usize| {
            let name = subscript(families::BERNSTEIN, &[i]).power(Expr::int(n as i64));
            Expr::apply(name, vec![t.clone()])
        };
        let polar = |i: usize| call(self.helper("beta", i), self.arguments());
        let steps = self.form.derive(Method::Bezier, &Fraction::zero()).steps;
        let parts: Vec<(usize, Fraction, Weights<Fraction>)> = steps
            .into_iter()
            .filter_map(|step| match step {
                Step::BezierTerm { index, point, blossom } if !point.is_zero() => {
                    Some((index, point, blossom.into_iter().map(Fraction::from).collect()))
                }
                _ => None,
            })
            .collect();
        if parts.is_empty() {
            return vec![self.result(Reason::PutTogether)];
        }
        let basis = combination(parts.iter().map(|(i, point, _)| (point.clone(), bernstein(*i))));
        let left = Expr::apply(self.names.polynomial.clone(), vec![t.clone()]);
        let mut lines = vec![line(chain([left, basis]), Reason::InBernsteinBasis(n))];
        for (i, _, weights) in &parts {
            let mut sides = vec![polar(*i)];
            if n <= PRODUCTS_UP_TO {
                let products = Combinations::new(n, *i).map(|chosen| self.split_product(&chosen));
                let terms = products.map(|expr| Term { sign: Sign::Plus, expr });
                sides.push(Expr::sum(terms.collect()));
            }
            sides.push(symmetric(weights, self.variable));
            lines.push(line(chain(sides), Reason::PolarOfBernstein { index: *i, degree: n }));
        }
        let sum = combination(parts.iter().map(|(i, point, _)| (point.clone(), polar(*i))));
        lines.push(line(chain([self.value(), sum]), Reason::PolarFormIsLinear));
        lines.push(self.result(Reason::PutTogether));
        lines
    }

    /// The product of the chosen arguments and of 1 − t for the others.
    fn split_product(&self, chosen: &[usize]) -> Expr {
        let inside = chosen.iter().map(|&k| self.argument(k + 1));
        let outside = (0..self.degree).filter(|k| !chosen.contains(k)).map(|k| {
            let one = Term { sign: Sign::Plus, expr: Expr::int(1) };
            Expr::sum(vec![one, Term { sign: Sign::Minus, expr: self.argument(k + 1) }]).grouped()
        });
        match <[Expr; 1]>::try_from(inside.chain(outside).collect::<Vec<_>>()) {
            Ok([Expr { kind: Kind::Group(inner), .. }]) => *inner,
            Ok([one]) => one,
            Err(many) => Expr::product(many),
        }
    }
}
