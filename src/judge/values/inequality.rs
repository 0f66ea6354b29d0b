//! Inequalities between polynomials and quotients in one variable, decided by the roots of their difference.

use crate::formula::{Expr, Kind, Link, Rel, Sign, interval};
use crate::judge::values::compare::{Domain, Outcome};
use crate::language::lexicon::roles;
use crate::language::value::{Judgement, Value, Verdict, Witness};
use crate::math::curve::{Region, RegionFailure, RegionShown, positivity_on};
use crate::math::number::{Rational, integer};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;
use num_traits::{Signed, Zero};

/// Where a variable runs; an end that is `None` is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Range {
    lower: Option<Rational>,
    upper: Option<Rational>,
    /// Whether the ends are left out.
    open: [bool; 2],
}

impl Range {
    /// The closed interval between two numbers.
    pub(crate) fn between(lower: Rational, upper: Rational) -> Self {
        Range { lower: Some(lower), upper: Some(upper), open: [false, false] }
    }

    /// Its ends, as far as it has some.
    pub(crate) fn ends(&self) -> impl Iterator<Item = &Rational> {
        self.lower.iter().chain(&self.upper)
    }

    /// Whether a number lies beyond one of its ends.
    pub(crate) fn is_passed_by(&self, number: &Rational) -> bool {
        self.lower.as_ref().is_some_and(|lower| number < lower)
            || self.upper.as_ref().is_some_and(|upper| number > upper)
    }
}

/// What holds for d ≥ 0 or d > 0 everywhere in a range.
pub enum Decision {
    /// It holds.
    Holds,
    /// It fails at a number.
    Fails(Rational),
    /// d > 0 fails at a number that is not rational: d is 0 there.
    Zero(RealRoot),
    /// d has no value somewhere.
    Pole,
}

/// Polynomials of higher degree are not searched for roots.
const HIGHEST_DEGREE: u32 = 200;

/// Whether d ≥ 0, or d > 0, for all values of the only variable in a range, which has more than one number; `None` if there are
/// other variables or the degree is above 200. Cost: as for isolating the roots of numerator and denominator.
pub fn decide(d: &Fraction, strict: bool, range: &Range) -> Option<Decision> {
    let variable = match d.variables().as_slice() {
        [only] => only.clone(),
        _ => return None,
    };
    if d.numerator().degree_in(&variable).max(d.denominator().degree_in(&variable)) > HIGHEST_DEGREE {
        return None;
    }
    let numbers = |p: &MultiPoly| -> Option<Poly> {
        p.coefficients_in(&variable).iter().map(MultiPoly::as_constant).collect()
    };
    let (above, below) = (numbers(d.numerator())?, numbers(d.denominator())?);
    let inside = |p: &Poly| -> Vec<RealRoot> {
        let ends = [(&range.lower, range.open[0]), (&range.upper, range.open[1])];
        let left_out = |root: &RealRoot| {
            ends.iter().any(|(end, open)| {
                *open && matches!((root, end), (RealRoot::Rational(q), Some(end)) if q == end)
            })
        };
        let roots = p.real_roots(range.lower.as_ref(), range.upper.as_ref()).unwrap_or_default();
        roots.into_iter().map(|(root, _)| root).filter(|root| !left_out(root)).collect()
    };
    if !inside(&below).is_empty() {
        return Some(Decision::Pole);
    }
    // The quotient has the sign of the product.
    let product = &above * &below;
    if let Some(point) = product.negative_point(range.lower.as_ref(), range.upper.as_ref()) {
        return Some(Decision::Fails(point));
    }
    let mut zeros = if strict { inside(&above) } else { Vec::new() }.into_iter();
    Some(match zeros.next() {
        None => Decision::Holds,
        Some(RealRoot::Rational(q)) => Decision::Fails(q),
        Some(root) => Decision::Zero(root),
    })
}

/// Whether squares show that d ≥ 0, or d > 0, wherever it has a value: (a - b)^2 ≥ 0.
pub fn holds_by_squares(d: &Fraction, strict: bool) -> bool {
    // The quotient has the sign of the product.
    (d.numerator() * d.denominator()).is_nonnegative_by_squares(strict)
}

/// What an inequality says is positive, or not negative (false).
pub fn positive(judgement: &Judgement) -> Option<(Fraction, bool)> {
    positive_of(judgement.rel, &judgement.left, &judgement.right)
}

fn positive_of(rel: Rel, left: &Value, right: &Value) -> Option<(Fraction, bool)> {
    let (left, right) = (left.as_scalar()?, right.as_scalar()?);
    Some(match rel {
        Rel::Gt => (left.minus(right), true),
        Rel::Ge => (left.minus(right), false),
        Rel::Lt => (right.minus(left), true),
        Rel::Le => (right.minus(left), false),
        _ => return None,
    })
}

/// An inequality in one variable or two, decided in the ranges that conditions which are linear in one of them give. A counterexample may
/// be excluded by other conditions; what is refuted without one is not. `None` if they give no range, or nothing can be said.
pub fn decided_in(claim: &Judgement, conditions: &[Judgement]) -> Option<Judgement> {
    let (d, strict) = positive(claim)?;
    let variables = d.variables();
    let ranges: Vec<Range> = variables.iter().map(|x| linear_range(x, conditions)).collect::<Option<_>>()?;
    let with = |verdict, witness| {
        Some(Judgement { verdict, witness, difference: None, reasons: Vec::new(), ..claim.clone() })
    };
    let refuted = |point: Vec<Rational>| {
        let assignment: Vec<(Symbol, Rational)> = variables.iter().cloned().zip(point).collect();
        let number = |s: &Symbol| assignment.iter().find(|(name, _)| name == s).map(|(_, q)| q.clone());
        let put = |value: &Value| value.as_scalar()?.value(&number);
        let (left, right) = (put(&claim.left)?, put(&claim.right)?);
        with(Verdict::Refuted, Some(Witness { assignment, left, right }))
    };
    match (variables.as_slice(), ranges.as_slice()) {
        ([_], [range]) => match decide(&d, strict, range)? {
            Decision::Holds => with(Verdict::Proved, None),
            Decision::Fails(point) => refuted(vec![point]),
            // Nothing else excludes that root.
            Decision::Zero(root) if conditions.iter().all(|one| is_linear(one, &variables[0])) => {
                let mut judgement = with(Verdict::Refuted, None)?;
                judgement.reasons.push(format!("the sides are equal at the root of {root}"));
                Some(judgement)
            }
            Decision::Zero(_) | Decision::Pole => None,
        },
        ([x, y], [first, second]) => match over_box(d.as_polynomial()?, strict, [x, y], [first, second])? {
            None => with(Verdict::Proved, None),
            Some(point) => refuted(point.to_vec()),
        },
        _ => None,
    }
}

/// The range that conditions which are linear in a variable alone give it; `None` if there are none, or it is empty.
fn linear_range(variable: &Symbol, conditions: &[Judgement]) -> Option<Range> {
    let mut range: Option<Range> = None;
    for condition in conditions {
        let Some((c, strict)) = positive(condition) else { continue };
        let Some([constant, slope]) = linear(&c, variable) else { continue };
        let (end, range) = (-constant / &slope, range.get_or_insert_with(Range::default));
        let (known, open, k) = if slope.is_positive() {
            (&mut range.lower, &mut range.open, 0)
        } else {
            (&mut range.upper, &mut range.open, 1)
        };
        let nearer = known.as_ref().is_none_or(|known| if k == 0 { end > *known } else { end < *known });
        if nearer || known.as_ref() == Some(&end) {
            open[k] = strict || !nearer && open[k];
            *known = Some(end);
        }
    }
    range.filter(|range| match (&range.lower, &range.upper) {
        (Some(a), Some(b)) => a < b,
        _ => true,
    })
}

fn is_linear(condition: &Judgement, variable: &Symbol) -> bool {
    positive(condition).is_some_and(|(c, _)| linear(&c, variable).is_some())
}

/// c_0 and c_1 of c_0 + c_1 t with numbers, c_1 not 0.
fn linear(f: &Fraction, variable: &Symbol) -> Option<[Rational; 2]> {
    match f.as_polynomial()?.coefficients_in(variable).as_slice() {
        [constant, slope] => Some([constant.as_constant()?, slope.as_constant()?]),
        _ => None,
    }
}

/// Compares the order of two values where conditions give the ranges of variables.
pub(in crate::judge) fn inequality(
    rel: Rel,
    left: &Value,
    right: &Value,
    conditions: &[Expr],
    domain: Domain,
) -> Outcome {
    let Some((difference, strict)) = positive_of(rel, left, right) else {
        return Outcome::Unclear("only numbers can be ordered".to_owned());
    };
    let fails = |assignment: Vec<(Symbol, Rational)>| {
        let number =
            |s: &Symbol| assignment.iter().find(|(name, _)| name == s).map(|(_, value)| value.clone());
        let put = |value: &Value| value.as_scalar()?.value(&number);
        let (Some(left_value), Some(right_value)) = (put(left), put(right)) else {
            return Outcome::Unclear("it fails somewhere in the range".to_owned());
        };
        let witness = Witness { assignment, left: left_value, right: right_value };
        Outcome::Fails(Box::new(Judgement {
            rel,
            left: left.clone(),
            right: right.clone(),
            verdict: Verdict::Refuted,
            difference: None,
            witness: Some(witness),
            reasons: Vec::new(),
        }))
    };
    if let Some(d) = difference.as_rational() {
        let holds = d.is_positive() || (d.is_zero() && !strict);
        return if holds { Outcome::Holds } else { fails(Vec::new()) };
    }
    let variables = difference.variables();
    if let [variable] = variables.as_slice() {
        let given = range(variable, conditions);
        let unit = Range { lower: Some(integer(0)), upper: Some(integer(1)), open: [true, true] };
        let assumed = match domain {
            Domain::Unit if variable.is_plain() => Some(unit),
            Domain::Unit => None,
            Domain::Reals => Some(Range::default()),
        };
        let unknown = || Outcome::Unclear("the range of the variable is not given".to_owned());
        let Some(range) = given.clone().or(assumed) else { return unknown() };
        if let (Some(a), Some(b)) = (&range.lower, &range.upper)
            && a >= b
        {
            return Outcome::Unclear("the range of the variable is empty".to_owned());
        }
        return match decide(&difference, strict, &range) {
            Some(Decision::Holds) => Outcome::Holds,
            Some(Decision::Pole) => Outcome::Unclear("a denominator is 0 somewhere in the range".to_owned()),
            _ if given.is_none() => unknown(),
            Some(Decision::Fails(point)) => fails(vec![(variable.clone(), point)]),
            Some(Decision::Zero(root)) => {
                Outcome::Unclear(format!("the sides are equal at the root of {root}"))
            }
            None => unknown(),
        };
    }
    if holds_by_squares(&difference, strict) {
        return Outcome::Holds;
    }
    let Some(polynomial) = difference.as_polynomial() else {
        return Outcome::Unclear(
            "an inequality between quotients in several variables is not decided".to_owned(),
        );
    };
    if let [x, y] = variables.as_slice()
        && let (Some(first), Some(second)) = (range(x, conditions), range(y, conditions))
    {
        match over_box(polynomial, strict, [x, y], [&first, &second]) {
            Some(None) => return Outcome::Holds,
            Some(Some(point)) => return fails([x, y].into_iter().cloned().zip(point).collect()),
            None => {}
        }
    }
    // Barycentric coordinates are not negative.
    let nonnegative = polynomial.terms(MonomialOrder::Lex).iter().all(|(_, c)| !c.is_negative());
    let coordinates = variables.iter().all(|v| v.is_plain() && roles::is_barycentric(v.base()));
    if nonnegative && coordinates && domain == Domain::Unit && !strict {
        return Outcome::Holds;
    }
    Outcome::Unclear("an inequality in several variables is not decided".to_owned())
}

/// Polynomials of higher degree in two variables are not looked at.
const HIGHEST_DEGREE_OF_TWO: u32 = 12;

/// Whether d ≥ 0, or d > 0, on a bounded rectangle of values of two variables: a point where it is not, if there is one. `None` if
/// the ranges are not bounded or nothing can be said. Cost: as for [`positivity_on`].
fn over_box(
    d: &MultiPoly,
    strict: bool,
    [x, y]: [&Symbol; 2],
    ranges: [&Range; 2],
) -> Option<Option<Vec<Rational>>> {
    if d.total_degree()? > HIGHEST_DEGREE_OF_TWO {
        return None;
    }
    let ends = |range: &Range| -> Option<[Rational; 2]> {
        let (a, b) = (range.lower.clone()?, range.upper.clone()?);
        (a < b).then_some([a, b])
    };
    let region = Region::Box(vec![ends(ranges[0])?, ends(ranges[1])?]);
    match positivity_on(d, &[x.clone(), y.clone()], &region) {
        // A sign on an open rectangle is that on the closed one.
        Ok(_) if !strict => Some(None),
        Ok(shown) => {
            let plain = shown.root_of_square.as_constant().is_some();
            let RegionShown::Coefficients(parts) = &shown.shown else { return None };
            let all = || parts.iter().flat_map(|part| part.coefficients.iter().map(|(_, c)| c));
            // Inside of a rectangle every Bernstein polynomial is positive.
            let inside = parts.len() == 1 && ranges.iter().all(|range| range.open == [true, true]);
            let positive = all().all(Signed::is_positive) || inside && all().any(Signed::is_positive);
            (plain && positive).then_some(None)
        }
        Err(RegionFailure::Negative(point)) => {
            let left_out = |range: &Range, q: &Rational| {
                range.open[0] && range.lower.as_ref() == Some(q)
                    || range.open[1] && range.upper.as_ref() == Some(q)
            };
            let inside = ranges.iter().zip(&point).all(|(range, q)| !left_out(range, q));
            inside.then_some(Some(point))
        }
        Err(RegionFailure::Open(_)) => None,
    }
}

/// The range of a variable that the conditions give, by the first of them that gives an end: 0 ≤ t ≤ 1, t ∈ [0, 1), t > 0.
pub(crate) fn range(symbol: &Symbol, conditions: &[Expr]) -> Option<Range> {
    let named = |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if *symbol == Symbol::new(name));
    let mut found: Option<Range> = None;
    for condition in conditions {
        let Kind::Chain(left, links) = &condition.kind else { continue };
        let one = match links.as_slice() {
            [link] if link.rel == Rel::In && named(left) => of_interval(&link.expr),
            // The names of integers have values elsewhere; here t > 0 is about a real number.
            [link] if named(left) && roles::is_variable(symbol.base()) => bound(link.rel, &link.expr),
            [link] if named(&link.expr) && roles::is_variable(symbol.base()) => {
                turned(link.rel).and_then(|rel| bound(rel, left))
            }
            [one, two] if named(&one.expr) => between(left, one, two),
            _ => None,
        };
        let Some(one) = one else { continue };
        let range = found.get_or_insert_with(Range::default);
        if range.lower.is_none() {
            (range.lower, range.open[0]) = (one.lower, one.open[0]);
        }
        if range.upper.is_none() {
            (range.upper, range.open[1]) = (one.upper, one.open[1]);
        }
    }
    found
}

/// Whether an interval is that from 0 to 1.
pub(crate) fn is_unit([from, to]: [&Expr; 2]) -> bool {
    (from.as_int(), to.as_int()) == (Some(0), Some(1))
}

fn of_interval(expr: &Expr) -> Option<Range> {
    let ([a, b], open) = interval(expr)?;
    Some(Range { lower: Some(constant(a)?), upper: Some(constant(b)?), open })
}

/// a ≤ t < b, or with > and ≥.
fn between(first: &Expr, one: &Link, two: &Link) -> Option<Range> {
    let (lower, upper) = (bound(turned(one.rel)?, first)?, bound(two.rel, &two.expr)?);
    let both = |x: Range, y: Range| Range { lower: x.lower, upper: y.upper, open: [x.open[0], y.open[1]] };
    match (lower.lower.is_some(), upper.upper.is_some()) {
        (true, true) => Some(both(lower, upper)),
        (false, false) => Some(both(upper, lower)),
        _ => None,
    }
}

/// t rel number
fn bound(rel: Rel, number: &Expr) -> Option<Range> {
    let end = Some(constant(number)?);
    Some(match rel {
        Rel::Ge => Range { lower: end, ..Range::default() },
        Rel::Gt => Range { lower: end, open: [true, false], ..Range::default() },
        Rel::Le => Range { upper: end, ..Range::default() },
        Rel::Lt => Range { upper: end, open: [false, true], ..Range::default() },
        _ => return None,
    })
}

fn turned(rel: Rel) -> Option<Rel> {
    Some(match rel {
        Rel::Le => Rel::Ge,
        Rel::Lt => Rel::Gt,
        Rel::Ge => Rel::Le,
        Rel::Gt => Rel::Lt,
        _ => return None,
    })
}

/// A number as it is written: 2, −1, 1/2.
fn constant(expr: &Expr) -> Option<Rational> {
    match &expr.kind {
        Kind::Number(q) => Some(q.clone()),
        Kind::Group(inner) => constant(inner),
        Kind::Div(above, below, _) => {
            let below = constant(below).filter(|q| !q.is_zero())?;
            Some(constant(above)? / below)
        }
        Kind::Add(terms) => match terms.as_slice() {
            [only] => {
                let value = constant(&only.expr)?;
                Some(if only.sign == Sign::Minus { -value } else { value })
            }
            _ => None,
        },
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::syntax::parse;

    fn given(conditions: &[&str]) -> Option<Range> {
        let conditions: Vec<Expr> = conditions.iter().map(|text| parse(text).unwrap()).collect();
        range(&Symbol::new("t"), &conditions)
    }

    #[test]
    fn ranges_are_read() {
        let range = |lower: Option<i64>, upper: Option<i64>, open| {
            Some(Range { lower: lower.map(integer), upper: upper.map(integer), open })
        };
        assert_eq!(given(&["0 <= t <= 1"]), range(Some(0), Some(1), [false, false]));
        assert_eq!(given(&["-1 <= t < 1"]), range(Some(-1), Some(1), [false, true]));
        assert_eq!(given(&["4/2 > t > -(1)"]), range(Some(-1), Some(2), [true, true]));
        assert_eq!(given(&["t >= 2"]), range(Some(2), None, [false, false]));
        assert_eq!(given(&["s = 1", "0 < t", "t <= 5", "t <= 3"]), range(Some(0), Some(5), [true, false]));
        assert_eq!(given(&["t = 1"]), None);
        assert_eq!(given(&["0 <= t >= 1"]), None);
        assert_eq!(given(&["a <= t <= 1"]), None);
    }
}
