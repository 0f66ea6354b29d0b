//! Two equations in two unknowns, by resultants.
//!
//! Let P and Q have no common factor. R(x) = Res_y(P, Q) is 0 at the first coordinates of all common zeros. Where the first
//! subresultant S = A y + B is not 0 there is one common zero over that x at most, y = −B/A: none if A = 0, for then it lies
//! at infinity. Where S = 0 there may be several; then the same is done along another direction, with u = x + k y in place
//! of x.
//!
//! L. González-Vega, M. El Kahoui, "An improved upper complexity bound for the topology computation of a real algebraic
//! plane curve", J. Complexity 12 (1996).

use std::cell::LazyCell;

use nalgebra::DMatrix;
use num_traits::{One, Zero};

use super::quotient::real_zeros;
use super::{RealZero, SystemError, interpolated, selected, univariate};
use crate::budget;
use crate::math::linalg::determinant;
use crate::math::number::{Rational, integer};
use crate::math::poly::{MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;

/// The ends of an interval; `None` is no end.
pub type Bounds = (Option<Rational>, Option<Rational>);

/// The directions that are tried.
const SHEARS: [i64; 7] = [0, 1, -1, 2, -3, 5, 7];

/// All common real zeros of P and Q with both coordinates within bounds, ordered by their coordinates.
///
/// Cost for degrees m and n: two resultants, 2 m n determinants of size m + n − 2, and real roots of a polynomial of degree
/// m n at most.
///
/// # Errors
/// [`SystemError::Infinite`] if P and Q have a common factor, also if that has finitely many real zeros; those of
/// [`real_zeros`] where a zero is multiple in every direction.
///
/// ```
/// use polarform::poly::{MultiPoly, Symbol};
/// use polarform::system::common_zeros;
/// let unknowns = ["x", "y"].map(Symbol::new);
/// let [x, y] = unknowns.clone().map(MultiPoly::symbol);
/// let circle = x.pow(2) + y.pow(2) - MultiPoly::constant(polarform::number::integer(2));
/// let found = common_zeros(&circle, &(x - y), &unknowns, &Default::default()).unwrap();
/// let shown: Vec<String> = found.iter().map(|p| format!("{}, {}", p.coordinates[0], p.coordinates[1])).collect();
/// assert_eq!(shown, ["-1, -1", "1, 1"]);
/// ```
pub fn common_zeros(
    p: &MultiPoly,
    q: &MultiPoly,
    unknowns: &[Symbol; 2],
    bounds: &[Bounds; 2],
) -> Result<Vec<RealZero>, SystemError> {
    if p.gcd(q).as_constant().is_none_or(|c| c.is_zero()) {
        return Err(SystemError::Infinite);
    }
    if p.as_constant().is_some() || q.as_constant().is_some() {
        return Ok(Vec::new());
    }
    let (p, q) = (without_squares(p), without_squares(q));
    let mut zeros = None;
    for k in SHEARS {
        zeros = along(&p, &q, k, unknowns, bounds);
        if zeros.is_some() {
            break;
        }
    }
    let mut zeros = match zeros {
        Some(zeros) => zeros,
        None => {
            let mut zeros = real_zeros(&[p, q], unknowns)?;
            zeros.retain(|zero| zero.coordinates.iter().zip(bounds).all(|(x, bounds)| within(x, bounds)));
            zeros
        }
    };
    zeros.sort_by(|a, b| a.coordinates.cmp(&b.coordinates));
    Ok(zeros)
}

/// Whether a number lies within bounds.
pub fn within(x: &RealRoot, (lower, upper): &Bounds) -> bool {
    let number = |q: &Rational| RealRoot::Rational(q.clone());
    lower.as_ref().is_none_or(|a| *x >= number(a)) && upper.as_ref().is_none_or(|b| *x <= number(b))
}

/// The product of the different factors.
fn without_squares(p: &MultiPoly) -> MultiPoly {
    let mut rest = p.primitive_part();
    for x in p.variables() {
        let common = rest.gcd(&rest.derivative(x));
        // A factor without x divides the derivative, too, and stays.
        let content = rest.coefficients_in(x).iter().fold(MultiPoly::zero(), |content, c| content.gcd(c));
        let repeated = common.div_exact(&content).unwrap_or_else(MultiPoly::one);
        if let Some(quotient) = rest.div_exact(&repeated) {
            rest = quotient;
        }
    }
    rest
}

/// The zeros, if every real one is alone on its line u = x + k y.
fn along(
    p: &MultiPoly,
    q: &MultiPoly,
    k: i64,
    unknowns: &[Symbol; 2],
    bounds: &[Bounds; 2],
) -> Option<Vec<RealZero>> {
    budget::step();
    let [x, y] = unknowns;
    let sheared = |f: &MultiPoly| {
        let line = MultiPoly::symbol(x.clone()) - MultiPoly::symbol(y.clone()).scaled(&integer(k));
        if k == 0 { f.clone() } else { f.substitute(&[(x.clone(), line)]) }
    };
    let (p_k, q_k) = (sheared(p), sheared(q));
    let (f, g) = (columns(&p_k, x, y)?, columns(&q_k, x, y)?);
    if f.len() < 2 || g.len() < 2 {
        return None;
    }
    let r = univariate(&p_k.resultant(&q_k, y), x)?;
    let (lower, upper) = if k == 0 { bounds[0].clone() } else { (None, None) };
    let roots = r.real_roots(lower.as_ref(), upper.as_ref())?;
    if roots.is_empty() {
        return Some(Vec::new());
    }
    let totals = [&p_k, &q_k].map(|f| f.total_degree().unwrap_or(0) as usize);
    let (a, b) = first_subresultant(&f, &g, totals);
    let roots_of = |f: Poly, (lower, upper): &Bounds| -> Vec<RealRoot> {
        let found = f.real_roots(lower.as_ref(), upper.as_ref()).unwrap_or_default();
        found.into_iter().map(|(root, _)| root).collect()
    };
    // Only looked for if a zero lies within the bounds.
    let second = LazyCell::new(|| univariate(&p.resultant(q, x), y).map(|f| roots_of(f, &bounds[1])));
    let first = LazyCell::new(|| univariate(&p.resultant(q, y), x).map(|f| roots_of(f, &bounds[0])));
    // y = −B/A and x = u − k y = (u A + k B)/A
    let above = [Poly::variable() * &a + b.scale(&integer(k)), -b.clone()];
    let mut zeros = Vec::new();
    for (u, _) in roots {
        budget::step();
        if u.sign_of(&a).is_eq() {
            match u.sign_of(&b).is_eq() {
                true => return None,
                false => continue,
            }
        }
        let inside = |n: &Poly, (lower, upper): &Bounds| {
            let turned = u.sign_of(&a).is_lt();
            let sign = |c: &Rational| {
                let sign = u.sign_of(&(n - &a.scale(c)));
                if turned { sign.reverse() } else { sign }
            };
            lower.as_ref().is_none_or(|c| sign(c).is_ge()) && upper.as_ref().is_none_or(|c| sign(c).is_le())
        };
        if !inside(&above[1], &bounds[1]) || k != 0 && !inside(&above[0], &bounds[0]) {
            continue;
        }
        let coordinates = match &u {
            RealRoot::Rational(t) => {
                let below = a.value(t);
                above.iter().map(|n| RealRoot::Rational(n.value(t) / &below)).collect()
            }
            RealRoot::Irrational(number) => {
                let of = |n: &Poly, from: &[RealRoot]| selected(number, n, &a, from.to_vec());
                let first = if k == 0 { u.clone() } else { of(&above[0], LazyCell::force(&first).as_ref()?) };
                vec![first, of(&above[1], LazyCell::force(&second).as_ref()?)]
            }
        };
        zeros.push(RealZero {
            coordinates,
            parameter: u.clone(),
            numerators: above.to_vec(),
            denominator: a.clone(),
        });
    }
    Some(zeros)
}

/// The coefficients of the powers of y, each a polynomial in x.
fn columns(f: &MultiPoly, x: &Symbol, y: &Symbol) -> Option<Vec<Poly>> {
    f.coefficients_in(y).iter().map(|c| univariate(c, x)).collect()
}

/// A and B of the first subresultant A y + B of two polynomials of degrees p, q ≥ 1 in y, up to a sign: determinants of the
/// coefficients of y^{q−2} P, …, P, y^{p−2} Q, …, Q; of values, interpolated.
fn first_subresultant(f: &[Poly], g: &[Poly], totals: [usize; 2]) -> (Poly, Poly) {
    let (p, q) = (f.len() - 1, g.len() - 1);
    if q == 1 {
        return (g[1].clone(), g[0].clone());
    }
    if p == 1 {
        return (f[1].clone(), f[0].clone());
    }
    let highest = |list: &[Poly]| list.iter().filter_map(Poly::degree).max().unwrap_or(0);
    let by_rows = (q - 1) * highest(f) + (p - 1) * highest(g);
    // With weights: the coefficient of y^j has degree d − j at most.
    let sum = |n: usize| n * n.saturating_sub(1) / 2;
    let rows = (q - 1) * totals[0] + sum(q - 1) + (p - 1) * totals[1] + sum(p - 1);
    let by_weights = rows.saturating_sub(sum(p + q - 1) - 1);
    let bound = by_rows.min(by_weights);
    let nodes: Vec<Rational> =
        (0..=bound as i64).map(|k| integer(if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 })).collect();
    let size = p + q - 2;
    let (mut of_a, mut of_b) = (Vec::with_capacity(nodes.len()), Vec::with_capacity(nodes.len()));
    for node in &nodes {
        budget::steps(1 + (size * size) as u32);
        let value = |list: &[Poly]| -> Vec<Rational> { list.iter().map(|c| c.value(node)).collect() };
        let (f, g) = (value(f), value(g));
        let entry = |row: usize, power: usize| {
            let (list, shift) = if row + 1 < q { (&f, q - 2 - row) } else { (&g, p + q - 3 - row) };
            power.checked_sub(shift).and_then(|j| list.get(j)).cloned().unwrap_or_else(Rational::zero)
        };
        let matrix = |last: usize| {
            DMatrix::from_fn(size, size, |i, j| entry(i, if j + 1 == size { last } else { size - j }))
        };
        let value = |last: usize| determinant(&matrix(last)).expect("the matrix is square");
        of_a.push(value(1));
        of_b.push(value(0));
    }
    (interpolated(&nodes, of_a), interpolated(&nodes, of_b))
}
