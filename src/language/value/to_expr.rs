//! Values as formulas, arranged as a person would write them.

use nalgebra::DMatrix;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::factors::quotient;
use super::grouped::grouped;
use super::{List, Notation, Polar, PolarKind, Value};
use crate::budget;
use crate::formula::{Accent, Delimiter, Expr, Kind, Rel, Sign, Term};
use crate::language::lexicon::families::{BINOMIAL_COEFFICIENT, FORWARD_DIFFERENCE};
use crate::math::blossom::{PolarForm, TensorPolarForm, TotalDegreePolarForm};
use crate::math::number::{Combinations, Int, Rational, binomial, multinomial};
use crate::math::poly::{Fraction, Index, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// Groups with more terms than this are shortened in ellipsis notation.
const ELLIPSIS_ABOVE: usize = 4;

/// A symbol as a formula: base, accent, indices.
pub fn symbol_expr(symbol: &Symbol) -> Expr {
    let mut expr = Expr::name(symbol.base());
    let accent = Accent::ALL.into_iter().find(|accent| accent.name() == symbol.accent());
    if let Some(accent) = accent {
        expr = Kind::Accent(accent, Box::new(expr)).into();
    }
    let index = |index: &Index| match index {
        Index::Number(i) => Expr::int(*i),
        Index::Word(word) => Expr::name(word),
    };
    if !symbol.indices().is_empty() {
        expr = Kind::Subscript(Box::new(expr), symbol.indices().iter().map(index).collect()).into();
    }
    if !symbol.upper().is_empty() {
        expr = Kind::Upper(Box::new(expr), symbol.upper().iter().map(index).collect()).into();
    }
    expr
}

/// |coefficient| times the factors, as a term with its sign; a coefficient 1 is not written.
pub fn exact_term(coefficient: &Rational, mut factors: Vec<Expr>) -> Term {
    let sign = if coefficient.is_negative() { Sign::Minus } else { Sign::Plus };
    let magnitude = coefficient.abs();
    if !magnitude.is_one() || factors.is_empty() {
        factors.insert(0, Expr::number(&magnitude));
    }
    Term { sign, expr: Expr::product(factors) }
}

pub(super) fn power_expr(symbol: &Symbol, exponent: u32) -> Expr {
    let base = symbol_expr(symbol);
    match exponent {
        1 => base,
        // C_5^2 is a binomial coefficient.
        _ if symbol.base() == BINOMIAL_COEFFICIENT && symbol.indices().len() == 1 => {
            base.grouped().power(Expr::int(i64::from(exponent)))
        }
        _ => base.power(Expr::int(i64::from(exponent))),
    }
}

pub(super) fn poly_terms(p: &MultiPoly) -> Vec<Term> {
    let mut list = p.terms(MonomialOrder::GrLex);
    // 1 - t and t2 - t1 rather than -t + 1 and -t1 + t2.
    if let [first, second] = list.as_slice()
        && first.1.is_negative()
        && second.1.is_positive()
    {
        list.swap(0, 1);
    }
    let term = |(mut powers, c): (Vec<(Symbol, u32)>, Rational)| {
        budget::step();
        // Before an indexed name Δ is a difference.
        powers.sort_by_key(|(symbol, _)| symbol.is_plain() && symbol.base() == FORWARD_DIFFERENCE);
        exact_term(&c, powers.iter().map(|(symbol, e)| power_expr(symbol, *e)).collect())
    };
    list.into_iter().map(term).collect()
}

fn poly_expr(p: &MultiPoly) -> Expr {
    budget::charge_terms(p.len() as u64);
    Expr::sum(poly_terms(p))
}

/// A rational function as a formula, terms by descending degree.
pub fn polynomial_expr(f: &Fraction) -> Expr {
    match f.as_polynomial() {
        Some(p) => poly_expr(p),
        None => quotient_expr(f),
    }
}

/// A rational function as on a board: grouped by points or powers where that says more.
pub fn grouped_expr(f: &Fraction) -> Expr {
    grouped(f).unwrap_or_else(|| polynomial_expr(f))
}

/// A formula for reading: grouped, or multiplied out.
fn scalar_expr(f: &Fraction, notation: Notation) -> Expr {
    match notation {
        Notation::Expanded => polynomial_expr(f),
        _ => grouped_expr(f),
    }
}

/// A combination of some symbols as a sum of coefficients times symbols, coefficients in factors;
/// `None` if it is not linear in them without a rest, or nothing is gained.
pub fn collected(f: &Fraction, symbols: &[Symbol]) -> Option<Expr> {
    let mut rest = f.clone();
    let mut terms = Vec::with_capacity(symbols.len());
    for symbol in symbols {
        let coefficient = f.derivative(symbol);
        if coefficient.variables().iter().any(|other| symbols.contains(other)) {
            return None;
        }
        if coefficient.is_zero() {
            continue;
        }
        rest -= coefficient.times(&Fraction::from(MultiPoly::symbol(symbol.clone())));
        terms.push(flattened(weighted(&coefficient, Some(symbol_expr(symbol)))));
    }
    // 2 b_3 - b_2 rather than -b_2 + 2 b_3.
    if let Some(first) = terms.iter().position(|term| term.sign == Sign::Plus) {
        terms[..=first].rotate_right(1);
    }
    (rest.is_zero() && !terms.is_empty()).then(|| Expr::sum(terms))
}

/// A quotient that is a combination of symbols of one family such as d_0, d_1, …, which is not in the
/// denominator: of control points, written as a mean.
fn combination_of_points(f: &Fraction) -> Option<Expr> {
    let below = f.denominator().variables();
    let mut families: Vec<Vec<Symbol>> = Vec::new();
    for symbol in f.numerator().variables().iter().filter(|symbol| !symbol.indices().is_empty()) {
        match families.iter_mut().find(|family| family[0].base() == symbol.base()) {
            Some(family) => family.push(symbol.clone()),
            None => families.push(vec![symbol.clone()]),
        }
    }
    families.retain(|family| {
        let linear = |(powers, _): &(Vec<(Symbol, u32)>, Rational)| {
            powers.iter().filter(|(symbol, _)| family.contains(symbol)).map(|(_, e)| e).sum::<u32>() == 1
        };
        family.len() > 1
            && !below.iter().any(|symbol| !symbol.indices().is_empty() && symbol.base() == family[0].base())
            && f.numerator().terms(MonomialOrder::Lex).iter().all(linear)
    });
    match families.as_slice() {
        // Of sum 1: a mean. A difference such as (y_1 - y_0)/(x_1 - x_0) is one quotient.
        [family] if family.iter().fold(Fraction::zero(), |sum, y| sum + f.derivative(y)).is_one() => {
            collected(f, family)
        }
        _ => None,
    }
}

/// A proper quotient, denominators (and numerators, if that works out) in factors.
fn quotient_expr(f: &Fraction) -> Expr {
    if let Some(expr) = combination_of_points(f) {
        return expr;
    }
    let (top, bottom) = quotient(f);
    let power = |(factor, k): &(MultiPoly, u32)| {
        let base = poly_expr(factor);
        if *k == 1 { base } else { base.power(Expr::int(i64::from(*k))) }
    };
    let denominator = Expr::product(bottom.powers.iter().map(power).collect());
    let simple = top.powers.iter().all(|(factor, _)| factor.len() <= 2);
    let magnitude = top.constant.abs();
    let (whole, part) = (magnitude.numer().clone(), magnitude.denom().clone());
    // Rational factors are shared out: 2/3 · x/y is 2 x over 3 y.
    let denominator = match part.is_one() {
        true => denominator,
        false => exact_term(&Rational::from_integer(part), vec![denominator]).expr,
    };
    let numerator = if simple {
        exact_term(&Rational::from_integer(whole), top.powers.iter().map(power).collect()).expr
    } else {
        let product = top.powers.iter().fold(MultiPoly::one(), |p, (q, k)| p.times(&q.powered(*k)));
        poly_expr(&product.scaled(&Rational::from_integer(whole)))
    };
    let fraction = numerator.over(flat_product(denominator));
    if top.constant.is_negative() { fraction.negated() } else { fraction }
}

/// A product inside a product run together with it.
fn flat_product(expr: Expr) -> Expr {
    flattened(Term { sign: Sign::Plus, expr }).expr
}

/// A coefficient before a bracket: sign and factors, `c_2/3` for a third of c_2.
fn coefficient_parts(c: &Fraction) -> (Sign, Vec<Expr>) {
    if let Some(q) = c.as_rational() {
        let sign = if q.is_negative() { Sign::Minus } else { Sign::Plus };
        let magnitude = q.abs();
        return (sign, if magnitude.is_one() { Vec::new() } else { vec![Expr::number(&magnitude)] });
    }
    let Some(p) = c.as_polynomial() else {
        let expr = polynomial_expr(c);
        // The minus of -1/(t - 1) belongs to the term.
        return match expr.kind {
            Kind::Add(mut terms) if terms.len() == 1 => {
                let term = terms.swap_remove(0);
                (term.sign, vec![term.expr])
            }
            kind => (Sign::Plus, vec![Expr { kind, ..expr }]),
        };
    };
    let content = p.content();
    let negative = p.len() == 1 && p.terms(MonomialOrder::GrLex)[0].1.is_negative();
    let sign = if negative { Sign::Minus } else { Sign::Plus };
    let whole = if negative { -p.clone() } else { p.clone() };
    let integral = whole.scaled(&Rational::from_integer(content.denom().clone()));
    let expr = poly_expr(&integral);
    if content.denom().is_one() {
        (sign, vec![expr])
    } else {
        (sign, vec![expr.over(Expr::number(&Rational::from_integer(content.denom().clone())))])
    }
}

/// coefficient · body, as a term.
pub(super) fn weighted(coefficient: &Fraction, body: Option<Expr>) -> Term {
    let (sign, mut factors) = coefficient_parts(coefficient);
    factors.extend(body);
    Term { sign, expr: Expr::product(factors) }
}

/// Adds a term to a sum; a plain sum is taken apart into its terms.
pub(super) fn push_term(terms: &mut Vec<Term>, term: Term) {
    match term {
        Term { sign: Sign::Plus, expr: Expr { kind: Kind::Add(parts), .. } } => terms.extend(parts),
        other => terms.push(other),
    }
}

/// The sum of all products of k of the symbols, in brackets if it has several terms.
fn elementary_expr(arguments: &[Expr], k: usize, notation: Notation) -> Option<Expr> {
    if k == 0 {
        return None;
    }
    let n = arguments.len();
    let count = binomial(n, k).to_usize().unwrap_or(usize::MAX);
    let product = |chosen: &[usize]| Expr::product(chosen.iter().map(|&i| arguments[i].clone()).collect());
    let plus = |expr| Term { sign: Sign::Plus, expr };
    if count == 1 {
        return Some(product(&(0..n).collect::<Vec<_>>()));
    }
    if notation == Notation::Ellipsis && count > ELLIPSIS_ABOVE {
        let first: Vec<usize> = (0..k).collect();
        let last: Vec<usize> = (n - k..n).collect();
        let middle = Expr::from(Kind::Ellipsis);
        return Some(Expr::sum(vec![plus(product(&first)), plus(middle), plus(product(&last))]).grouped());
    }
    budget::charge_terms((count as u64).saturating_mul(k as u64 + 1));
    let terms = Combinations::new(n, k).map(|chosen| plus(product(&chosen))).collect();
    Some(Expr::sum(terms).grouped())
}

/// σ_{k,n} of the arguments.
fn sigma_expr(arguments: &[Expr], k: usize) -> Option<Expr> {
    if k == 0 {
        return None;
    }
    let n = arguments.len();
    let indices = vec![Expr::int(k as i64), Expr::int(n as i64)];
    let sigma = Kind::Subscript(Box::new(Expr::name("sigma")), indices).into();
    let list = if n > ELLIPSIS_ABOVE {
        vec![arguments[0].clone(), Kind::Ellipsis.into(), arguments[n - 1].clone()]
    } else {
        arguments.to_vec()
    };
    Some(Expr::apply(sigma, list))
}

fn univariate_body(form: &PolarForm<Fraction>, arguments: &[Expr], notation: Notation) -> Expr {
    let n = form.degree();
    let weights = form.weights();
    let mut terms = Vec::new();
    for k in (0..=n).rev() {
        if weights[k].is_zero() {
            continue;
        }
        match notation {
            Notation::Expanded => {
                let count = binomial(n, k).to_u64().unwrap_or(u64::MAX);
                budget::charge_terms(count.saturating_add(terms.len() as u64).saturating_mul(k as u64 + 1));
                for chosen in Combinations::new(n, k) {
                    let factors: Vec<Expr> = chosen.iter().map(|&i| arguments[i].clone()).collect();
                    let body = (k > 0).then(|| Expr::product(factors));
                    terms.push(flattened(weighted(&weights[k], body)));
                }
            }
            Notation::Sigma => {
                terms.push(flattened(weighted(&form.coefficients()[k], sigma_expr(arguments, k))));
            }
            Notation::Grouped | Notation::Ellipsis => {
                let body = elementary_expr(arguments, k, notation);
                let term = flattened(weighted(&weights[k], body));
                if k == 0 { push_term(&mut terms, term) } else { terms.push(term) }
            }
        }
    }
    // A single sum needs no brackets around it.
    match Expr::sum(terms) {
        Expr { kind: Kind::Group(body), .. } => *body,
        sum => sum,
    }
}

/// Nested products run together: (5/3) · (a · b) is written 5/3 a b.
fn flattened(term: Term) -> Term {
    let Kind::Mul(factors) = term.expr.kind else { return term };
    let mut flat = Vec::with_capacity(factors.len());
    for factor in factors {
        match factor.kind {
            Kind::Mul(inner) => flat.extend(inner),
            _ => flat.push(factor),
        }
    }
    Term { sign: term.sign, expr: Expr::product(flat) }
}

fn tensor_body(form: &TensorPolarForm<Fraction>, u: &[Expr], v: &[Expr], notation: Notation) -> Expr {
    let (m, n) = form.degrees();
    let mut terms = Vec::new();
    let grid = form.coefficients();
    for i in (0..=m).rev() {
        for j in (0..=n).rev() {
            let c = &grid[i][j];
            if c.is_zero() {
                continue;
            }
            let ways = binomial(m, i) * binomial(n, j);
            let (weight, left, right) = match notation {
                Notation::Sigma => (c.clone(), sigma_expr(u, i), sigma_expr(v, j)),
                _ => (
                    c.scaled(&Rational::new(Int::ONE, ways)),
                    elementary_expr(u, i, notation),
                    elementary_expr(v, j, notation),
                ),
            };
            let factors: Vec<Expr> = left.into_iter().chain(right).collect();
            let body = (!factors.is_empty()).then(|| Expr::product(factors));
            push_term(&mut terms, flattened(weighted(&weight, body)));
        }
    }
    Expr::sum(terms)
}

fn total_body(form: &TotalDegreePolarForm<Fraction>, points: &[Vec<Expr>], notation: Notation) -> Expr {
    let d = form.degree();
    let mut ordered: Vec<(&[u32], &Fraction)> = form.terms().collect();
    ordered.sort_by_key(|(exponents, _)| {
        (std::cmp::Reverse(exponents.iter().sum::<u32>()), std::cmp::Reverse(exponents.to_vec()))
    });
    let mut terms = Vec::new();
    for (exponents, c) in ordered {
        // Which coordinate each argument contributes; the last mark means none.
        let none = exponents.len();
        let used: u32 = exponents.iter().sum();
        let mut parts: Vec<usize> = exponents.iter().map(|&e| e as usize).collect();
        parts.push(d - used as usize);
        let ways = multinomial(&parts);
        budget::charge_terms(ways.to_u64().unwrap_or(u64::MAX));
        let mut marks: Vec<usize> = (0..=none).flat_map(|k| vec![k; parts[k]]).collect();
        let mut monomials = Vec::new();
        loop {
            // u's before v's: u1 v2 + u2 v1.
            let mut chosen: Vec<(usize, usize)> =
                marks.iter().enumerate().filter(|(_, mark)| **mark < none).map(|(j, &k)| (k, j)).collect();
            chosen.sort_unstable();
            let factors: Vec<Expr> = chosen.into_iter().map(|(k, j)| points[j][k].clone()).collect();
            monomials.push(Term { sign: Sign::Plus, expr: Expr::product(factors) });
            if !next_order(&mut marks) {
                break;
            }
        }
        let body = match (used, monomials.len()) {
            (0, _) => None,
            (_, 1) => Some(monomials.remove(0).expr),
            (_, count) if notation == Notation::Ellipsis && count > ELLIPSIS_ABOVE => {
                let last = monomials.swap_remove(count - 1);
                let middle = Term { sign: Sign::Plus, expr: Kind::Ellipsis.into() };
                monomials.truncate(1);
                monomials.extend([middle, last]);
                Some(Expr::sum(monomials).grouped())
            }
            _ => Some(Expr::sum(monomials).grouped()),
        };
        let weight = c.scaled(&Rational::new(Int::ONE, ways));
        push_term(&mut terms, flattened(weighted(&weight, body)));
    }
    Expr::sum(terms)
}

/// The next order of a list in lexicographic order; false after the last.
fn next_order(list: &mut [usize]) -> bool {
    let Some(i) = list.windows(2).rposition(|pair| pair[0] < pair[1]) else { return false };
    let j = list.iter().rposition(|&item| item > list[i]).unwrap_or(i + 1);
    list.swap(i, j);
    list[i + 1..].reverse();
    true
}

impl Polar {
    /// The arguments by groups, as symbols: t gives t1, t2, …; points have one symbol for each
    /// coordinate.
    pub fn arguments(&self) -> Vec<Vec<Vec<Symbol>>> {
        let arity = self.arity();
        match &self.kind {
            PolarKind::Univariate(_) | PolarKind::Tensor(_) => arity
                .iter()
                .zip(&self.variables)
                .map(|(&n, variable)| (1..=n).map(|i| vec![variable.numbered(i as i64)]).collect())
                .collect(),
            PolarKind::Total(_) => {
                let point = |i: usize| self.variables.iter().map(|v| v.numbered(i as i64)).collect();
                vec![(1..=arity[0]).map(point).collect()]
            }
        }
    }

    /// The right-hand side: the form written out in its arguments.
    pub fn body(&self, notation: Notation) -> Expr {
        let arguments = self.arguments();
        let flat = |group: &[Vec<Symbol>]| -> Vec<Expr> {
            group.iter().map(|argument| symbol_expr(&argument[0])).collect()
        };
        match &self.kind {
            PolarKind::Univariate(form) => univariate_body(form, &flat(&arguments[0]), notation),
            PolarKind::Tensor(form) => {
                tensor_body(form, &flat(&arguments[0]), &flat(&arguments[1]), notation)
            }
            PolarKind::Total(form) => {
                let points: Vec<Vec<Expr>> =
                    arguments[0].iter().map(|point| point.iter().map(symbol_expr).collect()).collect();
                total_body(form, &points, notation)
            }
        }
    }

    /// The left-hand side `f(t1, …, tn)`.
    pub fn call(&self, name: Expr) -> Expr {
        let groups: Vec<Vec<Expr>> = self
            .arguments()
            .iter()
            .map(|group| {
                group
                    .iter()
                    .map(|argument| match argument.as_slice() {
                        [one] => symbol_expr(one),
                        many => Kind::Tuple(many.iter().map(symbol_expr).collect()).into(),
                    })
                    .collect()
            })
            .collect();
        if groups.iter().all(Vec::is_empty) {
            return name;
        }
        Kind::Apply(Box::new(name), groups).into()
    }

    /// `f(t1, …, tn) = …`
    pub fn equation(&self, name: Expr, notation: Notation) -> Expr {
        Expr::relation(self.call(name), Rel::Eq, self.body(notation))
    }
}

fn matrix_expr(matrix: &DMatrix<Fraction>, notation: Notation) -> Expr {
    let rows = (0..matrix.nrows())
        .map(|i| (0..matrix.ncols()).map(|j| Some(scalar_expr(&matrix[(i, j)], notation))).collect())
        .collect();
    Kind::Matrix(rows, Delimiter::Paren).into()
}

impl Value {
    /// The value as a formula.
    pub fn to_expr(&self) -> Expr {
        self.to_expr_in(Notation::Grouped)
    }

    /// The value as a formula for reading: curves in their basis, piecewise functions by cases.
    /// Other values are as by [`Value::to_expr_in`].
    pub fn display_expr(&self, notation: Notation) -> Expr {
        match self {
            Value::Geometry(geometry) => geometry.display_expr(),
            Value::Piecewise(function) => function.display_expr(),
            Value::List(items)
                if items.iter().any(|item| matches!(item, Value::Geometry(_) | Value::Piecewise(_))) =>
            {
                items.formula(items.iter().map(|item| item.display_expr(notation)).collect())
            }
            _ => self.to_expr_in(notation),
        }
    }

    /// The value as a formula, polar forms in the given notation.
    pub fn to_expr_in(&self, notation: Notation) -> Expr {
        match self {
            Value::Scalar(f) => scalar_expr(f, notation),
            Value::Algebraic(root) => root.to_expr(),
            Value::Written(written) => written.expr.clone(),
            Value::Vector(f) => Kind::Accent(Accent::Hat, Box::new(polynomial_expr(f))).into(),
            Value::Polar(polar) => polar.equation(Expr::name("f"), notation),
            Value::Function(function) => function_expr(function, notation),
            Value::Builtin(name) => Expr::name(*name),
            Value::List(items) => {
                if let Some(curve) = curve_expr(items, Expr::name("f"), notation) {
                    return curve;
                }
                items.formula(items.iter().map(|item| item.to_expr_in(notation)).collect())
            }
            Value::Matrix(matrix) => matrix_expr(matrix, notation),
            Value::Geometry(geometry) => geometry.to_expr(),
            Value::Piecewise(function) => function.to_expr(),
            Value::Table(table) => table.to_expr(),
            Value::Derivation(derivation) => derivation.to_expr(),
            Value::Figure(scene) => Kind::Text(format!("figure: {}", scene.title())).into(),
            Value::Claim(claim) => Kind::Text(claim.verdict().word().to_owned()).into(),
            Value::Text(text) => Kind::Text(text.clone()).into(),
        }
    }
}

/// `f(t1, t2) = (x, y)` for the polar forms of the coordinates of a curve or surface.
pub fn curve_expr(items: &List<Value>, name: Expr, notation: Notation) -> Option<Expr> {
    let polars: Option<Vec<&Polar>> = items
        .iter()
        .map(|item| match item {
            Value::Polar(polar) => Some(&**polar),
            _ => None,
        })
        .collect();
    let polars = polars?;
    let first = polars.first()?;
    let alike =
        polars.iter().all(|polar| polar.arity() == first.arity() && polar.variables == first.variables);
    if !alike {
        return None;
    }
    let bodies = polars.iter().map(|polar| polar.body(notation)).collect();
    Some(Expr::relation(first.call(name), Rel::Eq, items.formula(bodies)))
}

fn function_expr(function: &super::Function, notation: Notation) -> Expr {
    let clauses: Vec<Expr> = function
        .clauses
        .iter()
        .map(|clause| {
            let parameters: Vec<Expr> = clause
                .parameters
                .iter()
                .map(|parameter| match parameter {
                    super::Parameter::Name(symbol) => symbol_expr(symbol),
                    super::Parameter::Exactly(q) => Expr::number(q),
                })
                .collect();
            let body = match &clause.formula {
                Some(formula) if !clause.written => scalar_expr(formula, notation),
                _ => clause.body.clone(),
            };
            let shape = function.shape;
            let (lower, rest) = parameters.split_at(shape.lower);
            let (upper, inner) = rest.split_at(shape.upper);
            let points = inner.chunks(shape.dimension.max(1)).map(|point| Kind::Tuple(point.to_vec()).into());
            let inner = &if shape.dimension > 0 { points.collect() } else { inner.to_vec() };
            let Some(name) = &function.name else {
                return Kind::Lambda(inner.to_vec(), Box::new(body)).into();
            };
            let mut head = symbol_expr(name);
            if !lower.is_empty() {
                head = Kind::Subscript(Box::new(head), lower.to_vec()).into();
            }
            if let [upper] = upper {
                head = head.power(upper.clone());
            }
            let head = if inner.is_empty() { head } else { Expr::apply(head, inner.to_vec()) };
            Expr::relation(head, Rel::Define, body)
        })
        .collect();
    match <[Expr; 1]>::try_from(clauses) {
        Ok([one]) => one,
        Err(many) => Kind::Sequence(many).into(),
    }
}
