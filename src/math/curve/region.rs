//! Signs of a polynomial in several variables on a box or simplex, with certificates.
//!
//! F = S² G, where G has each irreducible factor at most once, is not negative on a region with an interior if and only if G is not.
//! That is shown by Bernstein coefficients of G that are not negative, over parts of the region. Where G has a zero inside of
//! it, that may never end; then the least value of G is found where it can be: on a face, where G is a polynomial in one variable
//! less, or at a critical point inside, a common zero of all derivatives.
//!
//! R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29 (2012); V. Powers, B. Reznick,
//! "Polynomials that are positive on an interval", Trans. AMS 352 (2000).

use std::collections::{BTreeMap, VecDeque};

use num_traits::{One, Signed, Zero};

use super::integers::split;
use crate::budget;
use crate::math::blossom::TotalDegreePolarForm;
use crate::math::linalg::determinant;
use crate::math::number::{Rational, binomial, integer, rational};
use crate::math::poly::{MonomialOrder, MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;
use crate::math::system::{Bounds, MOST_SOLUTIONS, RealZero, SystemError, common_zeros, real_zeros};

/// A box or a simplex of some dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// A number from each of some intervals: a rectangle for two of them.
    Box(Vec<[Rational; 2]>),
    /// The convex hull of d + 1 points: a triangle, a tetrahedron.
    Simplex(Vec<Vec<Rational>>),
}

/// A part of a region, and the Bernstein coefficients over it with their indices.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionPart {
    /// The part.
    pub region: Region,
    /// b_{ij…} with an index for each interval, in their order, or for each corner, the first one descending.
    pub coefficients: Vec<(Vec<usize>, Rational)>,
}

/// Why F ≥ 0 on a region: F = S² G, and why G ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionPositivity {
    /// S
    pub root_of_square: MultiPoly,
    /// G
    pub rest: MultiPoly,
    /// What shows it.
    pub shown: RegionShown,
}

/// What shows that G ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub enum RegionShown {
    /// Coefficients that are not negative, over parts that cover the region.
    Coefficients(Vec<RegionPart>),
    /// G is not negative on the faces, nor at these critical points: all of those in the region that do not form curves, and for
    /// each closed curve of them one at least.
    CriticalPoints(Vec<RealZero>),
}

/// Why it is not shown that F ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub enum RegionFailure {
    /// F is negative at this point of the region.
    Negative(Vec<Rational>),
    /// Many parts did not suffice, and the critical points are not found.
    Open(SystemError),
}

impl Region {
    /// How many variables it has.
    pub fn dimension(&self) -> usize {
        match self {
            Region::Box(ends) => ends.len(),
            Region::Simplex(corners) => corners.len() - 1,
        }
    }

    /// The corners.
    pub fn corners(&self) -> Vec<Vec<Rational>> {
        match self {
            Region::Box(ends) => (0..1_usize << ends.len())
                .map(|k| ends.iter().enumerate().map(|(i, ends)| ends[k >> i & 1].clone()).collect())
                .collect(),
            Region::Simplex(corners) => corners.clone(),
        }
    }

    /// Whether it has an interior.
    pub fn is_proper(&self) -> bool {
        match self {
            Region::Box(ends) => ends.iter().all(|[a, b]| a < b),
            Region::Simplex(corners) => {
                let n = self.dimension();
                corners.iter().all(|p| p.len() == n) && !volume(corners).is_zero()
            }
        }
    }

    /// Linear forms that are not negative exactly on the region.
    fn sides(&self, unknowns: &[Symbol]) -> Vec<MultiPoly> {
        let letters: Vec<MultiPoly> = unknowns.iter().cloned().map(MultiPoly::symbol).collect();
        let number = |q: &Rational| MultiPoly::constant(q.clone());
        match self {
            Region::Box(ends) => ends
                .iter()
                .zip(&letters)
                .flat_map(|([a, b], x)| [x.clone() - number(a), number(b) - x.clone()])
                .collect(),
            // The barycentric coordinates, which are affine: by their values at 0 and the unit points.
            Region::Simplex(corners) => {
                let n = unknowns.len();
                let whole = volume(corners);
                let share = |k: usize, p: Vec<Rational>| {
                    let mut corners = corners.clone();
                    corners[k] = p;
                    volume(&corners) / &whole
                };
                let unit = |i: usize| (0..n).map(|j| integer((i == j) as i64)).collect::<Vec<_>>();
                (0..=n)
                    .map(|k| {
                        let at_zero = share(k, unit(n));
                        let slopes = letters
                            .iter()
                            .enumerate()
                            .map(|(i, x)| x.scaled(&(share(k, unit(i)) - &at_zero)));
                        slopes.fold(number(&at_zero), |sum, term| sum + term)
                    })
                    .collect()
            }
        }
    }

    /// The Bernstein coefficients of a polynomial over it.
    fn coefficients(&self, f: &MultiPoly, unknowns: &[Symbol]) -> Vec<(Vec<usize>, Rational)> {
        match self {
            Region::Box(ends) => over_box(f, unknowns, ends),
            Region::Simplex(corners) => {
                let degree = f.total_degree().unwrap_or(0) as usize;
                let terms = exponents(f, unknowns);
                let form = TotalDegreePolarForm::new(unknowns.len(), degree, terms)
                    .expect("the degree is that of the polynomial");
                form.bezier_points(corners).expect("a simplex has one corner more than variables")
            }
        }
    }

    /// The faces: each with the region of its parameters and the points p + Σ s_i (q_i − p) of them.
    fn faces(&self) -> Vec<(Region, Vec<Vec<Rational>>)> {
        let n = self.dimension();
        match self {
            Region::Box(ends) => (0..2 * n)
                .map(|face| {
                    let (fixed, end) = (face / 2, &ends[face / 2][face % 2]);
                    let free: Vec<usize> = (0..n).filter(|&i| i != fixed).collect();
                    let at = |moved: Option<usize>| -> Vec<Rational> {
                        let zero = |i: usize| integer((moved == Some(i)) as i64);
                        (0..n).map(|i| if i == fixed { end.clone() } else { zero(i) }).collect()
                    };
                    let region = Region::Box(free.iter().map(|&i| ends[i].clone()).collect());
                    (region, std::iter::once(at(None)).chain(free.iter().map(|&i| at(Some(i)))).collect())
                })
                .collect(),
            Region::Simplex(corners) => (0..=n)
                .map(|left_out| {
                    let kept = (1..=n).map(|i| corners[(left_out + i) % (n + 1)].clone()).collect();
                    let unit = |i: Option<usize>| (1..n).map(|j| integer((i == Some(j)) as i64)).collect();
                    let unit_corners = std::iter::once(unit(None)).chain((1..n).map(|i| unit(Some(i))));
                    (Region::Simplex(unit_corners.collect()), kept)
                })
                .collect(),
        }
    }
}

impl RegionPart {
    /// Two halves, cut across where the least coefficient lies furthest inside.
    fn halves(&self) -> [RegionPart; 2] {
        let half = rational(1, 2);
        let least = self.coefficients.iter().min_by(|a, b| a.1.cmp(&b.1)).map_or(&[][..], |(index, _)| index);
        let [first, second] = match &self.region {
            Region::Box(ends) => {
                let degree =
                    |k: usize| self.coefficients.iter().map(|(index, _)| index[k]).max().unwrap_or(0);
                let scale = 2 * (0..ends.len()).map(degree).sum::<usize>() + 2;
                let inside = |k: usize| {
                    let n = degree(k);
                    least[k].min(n - least[k]) * scale / n.max(1)
                };
                let width =
                    |k: usize| if degree(k) > 0 { &ends[k][1] - &ends[k][0] } else { Rational::zero() };
                let better = |i: &usize, j: &usize| {
                    inside(*i).cmp(&inside(*j)).then_with(|| width(*i).cmp(&width(*j))).then(j.cmp(i))
                };
                let k = (0..ends.len()).max_by(better).unwrap_or(0);
                let middle = (&ends[k][0] + &ends[k][1]) * half;
                let with = |end: usize| {
                    let mut ends = ends.clone();
                    ends[k][end] = middle.clone();
                    Region::Box(ends)
                };
                [(with(1), vec![k]), (with(0), vec![k])]
            }
            Region::Simplex(corners) => {
                // The edge between the corners with the two largest indices.
                let mut places: Vec<usize> = (0..corners.len()).collect();
                places.sort_by(|&i, &j| least[j].cmp(&least[i]).then(j.cmp(&i)));
                let (p, q) = (places[0].min(places[1]), places[0].max(places[1]));
                let middle: Vec<Rational> =
                    corners[p].iter().zip(&corners[q]).map(|(x, y)| (x + y) * &half).collect();
                let with = |at: usize| {
                    let mut corners = corners.clone();
                    corners[at] = middle.clone();
                    Region::Simplex(corners)
                };
                [(with(q), vec![p, q]), (with(p), vec![p, q])]
            }
        };
        let (before, after) = self.split_along(&first.1);
        [
            RegionPart { region: first.0, coefficients: before },
            RegionPart { region: second.0, coefficients: after },
        ]
    }

    /// The coefficients of both halves: those that differ along an interval, or along an edge, are the Bézier points of a polynomial in one variable.
    #[expect(clippy::type_complexity, reason = "two lists as in the part")]
    fn split_along(&self, along: &[usize]) -> (Vec<(Vec<usize>, Rational)>, Vec<(Vec<usize>, Rational)>) {
        let mut lines: BTreeMap<Vec<usize>, Vec<usize>> = BTreeMap::new();
        for (place, (index, _)) in self.coefficients.iter().enumerate() {
            let others = (0..index.len()).filter(|k| !along.contains(k)).map(|k| index[k]).collect();
            lines.entry(others).or_default().push(place);
        }
        let (mut before, mut after) = (self.coefficients.clone(), self.coefficients.clone());
        let last = along[along.len() - 1];
        for mut places in lines.into_values() {
            budget::step();
            places.sort_by_key(|&place| self.coefficients[place].0[last]);
            let numbers: Vec<Rational> =
                places.iter().map(|&place| self.coefficients[place].1.clone()).collect();
            let (low, high) = split(&numbers, &rational(1, 2));
            for ((place, low), high) in places.into_iter().zip(low).zip(high) {
                before[place].1 = low;
                after[place].1 = high;
            }
        }
        (before, after)
    }
}

/// The exponents of the unknowns with their coefficients.
fn exponents(f: &MultiPoly, unknowns: &[Symbol]) -> Vec<(Vec<u32>, Rational)> {
    let of = |(monomial, c): (Vec<(Symbol, u32)>, Rational)| {
        let exponent = |x: &Symbol| monomial.iter().find(|(s, _)| s == x).map_or(0, |(_, e)| *e);
        (unknowns.iter().map(exponent).collect(), c)
    };
    f.terms(MonomialOrder::Lex).into_iter().map(of).collect()
}

/// n! times the volume of a simplex, with a sign.
fn volume(corners: &[Vec<Rational>]) -> Rational {
    let n = corners.len() - 1;
    let edges = nalgebra::DMatrix::from_fn(n, n, |i, j| &corners[i + 1][j] - &corners[0][j]);
    determinant(&edges).expect("a square matrix")
}

/// Σ c_pq… s^p t^q … over the unit box, one variable after the other: b_i = Σ_{p ≤ i} C(i, p)/C(n, p) c_p.
fn over_box(f: &MultiPoly, unknowns: &[Symbol], ends: &[[Rational; 2]]) -> Vec<(Vec<usize>, Rational)> {
    let moved: Vec<(Symbol, MultiPoly)> = unknowns
        .iter()
        .zip(ends)
        .map(|(x, [a, b])| {
            (x.clone(), MultiPoly::symbol(x.clone()).scaled(&(b - a)) + MultiPoly::constant(a.clone()))
        })
        .collect();
    let f = f.substitute(&moved);
    let degrees: Vec<usize> = unknowns.iter().map(|x| f.degree_in(x) as usize).collect();
    budget::charge_terms(degrees.iter().map(|&n| n as u64 + 1).product());
    let all = degrees.iter().fold(vec![Vec::new()], |all: Vec<Vec<usize>>, &n| {
        let longer = |index: &Vec<usize>| {
            let index = index.clone();
            (0..=n).map(move |k| index.iter().copied().chain([k]).collect())
        };
        all.iter().flat_map(longer).collect()
    });
    let place = |index: &[usize]| index.iter().zip(&degrees).fold(0, |place, (i, n)| place * (n + 1) + i);
    let mut list = vec![Rational::zero(); all.len()];
    for (e, c) in exponents(&f, unknowns) {
        list[place(&e.iter().map(|&k| k as usize).collect::<Vec<_>>())] = c;
    }
    for (axis, &n) in degrees.iter().enumerate() {
        budget::steps(list.len() as u32);
        let weight = |i: usize, p: usize| Rational::new(binomial(i, p), binomial(n, p));
        let value = |index: &Vec<usize>| {
            let mut from = index.clone();
            (0..=index[axis]).fold(Rational::zero(), |sum, p| {
                from[axis] = p;
                sum + &list[place(&from)] * weight(index[axis], p)
            })
        };
        list = all.iter().map(value).collect();
    }
    all.into_iter().zip(list).collect()
}

/// The value of a polynomial in the unknowns.
fn value(f: &MultiPoly, unknowns: &[Symbol], point: &[Rational]) -> Rational {
    let at = |s: &Symbol| unknowns.iter().position(|x| x == s).map(|k| point[k].clone());
    f.value(&at).as_constant().expect("only the unknowns occur")
}

/// Why F ≥ 0 on a region. F is a polynomial in the unknowns, of which the region has as many and an interior.
///
/// Cost: a factorisation, up to 6 · 4^d subdivisions in d variables, and if these do not suffice the same for each face and the common zeros of
/// all derivatives: by resultants in two variables, by a Gröbner basis in more.
///
/// # Errors
/// A point of the region where F is negative, or [`RegionFailure::Open`] if both ways fail.
///
/// # Panics
/// If F has other symbols or the region has no interior.
///
/// ```
/// use polarform::curve::{Region, RegionFailure, RegionShown, positivity_on};
/// use polarform::number::{integer, rational};
/// use polarform::poly::{MultiPoly, Symbol};
/// let unknowns = ["u", "v"].map(Symbol::new);
/// let [u, v] = unknowns.clone().map(MultiPoly::symbol);
/// let square = Region::Box(vec![[0, 1].map(integer), [0, 1].map(integer)]);
/// let f = MultiPoly::constant(integer(1)) - u.clone() * v.clone();
/// let shown = positivity_on(&f, &unknowns, &square).unwrap();
/// let RegionShown::Coefficients(parts) = shown.shown else { panic!() };
/// let numbers: Vec<_> = parts[0].coefficients.iter().map(|(_, c)| c.clone()).collect();
/// assert_eq!(numbers, [1, 1, 1, 0].map(integer));
/// let g = u * v - MultiPoly::constant(rational(1, 2));
/// assert_eq!(positivity_on(&g, &unknowns, &square), Err(RegionFailure::Negative([0, 0].map(integer).to_vec())));
/// ```
pub fn positivity_on(
    f: &MultiPoly,
    unknowns: &[Symbol],
    region: &Region,
) -> Result<RegionPositivity, RegionFailure> {
    assert!(region.dimension() == unknowns.len() && region.is_proper(), "the region has an interior");
    let factors = f.factors();
    let (mut square, mut rest) = (MultiPoly::one(), MultiPoly::constant(factors.constant));
    for (factor, multiplicity) in factors.factors {
        square *= factor.pow((multiplicity / 2) as u32);
        if multiplicity % 2 == 1 {
            rest *= factor;
        }
    }
    let certificate = |shown| RegionPositivity { root_of_square: square, rest: rest.clone(), shown };
    let most = 6 << (2 * unknowns.len());
    let whole = RegionPart { region: region.clone(), coefficients: region.coefficients(&rest, unknowns) };
    let mut open = VecDeque::from([whole]);
    let (mut parts, mut looked_at) = (Vec::new(), 0);
    while let Some(part) = open.pop_front() {
        budget::step();
        looked_at += 1;
        let mut corners = part.region.corners().into_iter();
        if let Some(corner) = corners.find(|corner| value(f, unknowns, corner).is_negative()) {
            return Err(RegionFailure::Negative(corner));
        }
        budget::charge_terms(part.coefficients.len() as u64);
        if part.coefficients.iter().all(|(_, c)| !c.is_negative()) {
            parts.push(part);
            continue;
        }
        if looked_at + open.len() > most {
            let zeros = by_critical_points(f, &rest, unknowns, region)?;
            return Ok(certificate(RegionShown::CriticalPoints(zeros)));
        }
        open.extend(part.halves());
    }
    Ok(certificate(RegionShown::Coefficients(parts)))
}

/// The critical points of G in the region, if it is negative neither there nor on the faces.
fn by_critical_points(
    f: &MultiPoly,
    g: &MultiPoly,
    unknowns: &[Symbol],
    region: &Region,
) -> Result<Vec<RealZero>, RegionFailure> {
    for (face, points) in region.faces() {
        if let Some(at) = negative_on_face(f, unknowns, &face, &points)? {
            return Err(RegionFailure::Negative(at));
        }
    }
    let corners = region.corners();
    let bound = |k: usize| {
        let list = || corners.iter().map(|p| p[k].clone());
        (list().min(), list().max())
    };
    let bounds: Vec<Bounds> = (0..unknowns.len()).map(bound).collect();
    let zeros = critical_points(g, unknowns, &bounds).map_err(RegionFailure::Open)?;
    let sides = region.sides(unknowns);
    let inside: Vec<RealZero> = zeros
        .into_iter()
        .filter(|zero| sides.iter().all(|side| zero.sign_of(side, unknowns).is_ge()))
        .collect();
    match inside.iter().find(|zero| zero.sign_of(g, unknowns).is_lt()) {
        None => Ok(inside),
        Some(zero) => Err(RegionFailure::Negative(near(zero, |point| {
            let inside = sides.iter().all(|side| !value(side, unknowns, point).is_negative());
            inside && value(f, unknowns, point).is_negative()
        }))),
    }
}

/// A point of a face at which F is negative, if there is one.
fn negative_on_face(
    f: &MultiPoly,
    unknowns: &[Symbol],
    face: &Region,
    points: &[Vec<Rational>],
) -> Result<Option<Vec<Rational>>, RegionFailure> {
    let parameters = &unknowns[..face.dimension()];
    let line = |i: usize| {
        let terms = parameters.iter().zip(&points[1..]);
        terms.fold(MultiPoly::constant(points[0][i].clone()), |sum, (s, q)| {
            sum + MultiPoly::symbol(s.clone()).scaled(&(&q[i] - &points[0][i]))
        })
    };
    let moved: Vec<(Symbol, MultiPoly)> =
        unknowns.iter().enumerate().map(|(i, x)| (x.clone(), line(i))).collect();
    let on_face = f.substitute(&moved);
    let found = match parameters {
        [s] => {
            let on_edge: Poly =
                on_face.coefficients_in(s).iter().map(|c| c.as_constant().expect("one variable")).collect();
            let ends = face.corners();
            on_edge.negative_point(Some(&ends[0][0]), Some(&ends[1][0])).map(|t| vec![t])
        }
        _ => match positivity_on(&on_face, parameters, face) {
            Ok(_) => None,
            Err(RegionFailure::Negative(at)) => Some(at),
            Err(open) => return Err(open),
        },
    };
    Ok(found.map(|at| {
        (0..unknowns.len())
            .map(|i| {
                at.iter()
                    .zip(&points[1..])
                    .fold(points[0][i].clone(), |sum, (s, q)| sum + (&q[i] - &points[0][i]) * s)
            })
            .collect()
    }))
}

/// The critical points of G, but of curves of them in the plane only some points: at least one on each closed component.
///
/// G is constant along a curve p = 0 on which both derivatives vanish. Such a component meets the edges, or it is closed; then it
/// has a point where p_x = 0.
fn critical_points(
    g: &MultiPoly,
    unknowns: &[Symbol],
    bounds: &[Bounds],
) -> Result<Vec<RealZero>, SystemError> {
    let derivatives: Vec<MultiPoly> = unknowns.iter().map(|x| g.derivative(x)).collect();
    let ([x, y], [a, b]) = (unknowns, bounds) else {
        // Bézout's bound: a Gröbner basis for more would take very long.
        let degree = |d: &MultiPoly| d.total_degree().unwrap_or(0) as usize;
        return match derivatives.iter().fold(1_usize, |most, d| most.saturating_mul(degree(d))) {
            0..=MOST_SOLUTIONS => real_zeros(&derivatives, unknowns),
            _ => Err(SystemError::Degrees),
        };
    };
    let (plane, bounds) = ([x.clone(), y.clone()], [a.clone(), b.clone()]);
    let common = derivatives[0].gcd(&derivatives[1]);
    let (Some(first), Some(second)) = (derivatives[0].div_exact(&common), derivatives[1].div_exact(&common))
    else {
        // G is a number.
        return Ok(Vec::new());
    };
    let mut zeros = common_zeros(&first, &second, &plane, &bounds)?;
    for (p, _) in common.factors().factors {
        let slope = p.derivative(x);
        if !slope.is_zero() {
            zeros.extend(common_zeros(&p, &slope, &plane, &bounds)?);
        }
    }
    Ok(zeros)
}

/// A rational point near a zero that has a property of all points near enough but those of a curve or surface.
fn near(zero: &RealZero, holds: impl Fn(&[Rational]) -> bool) -> Vec<Rational> {
    let mut width = rational(1, 4);
    loop {
        budget::step();
        // Not the middle for all: S may be 0 on a line through it.
        for shift in [rational(1, 2), rational(1, 3), rational(3, 5), rational(5, 7)] {
            let coordinate = |(k, x): (usize, &RealRoot)| match x {
                RealRoot::Rational(q) => q + &width * (&shift - rational(1, 2)) * integer(k as i64 + 1),
                RealRoot::Irrational(number) => {
                    let (lower, upper) = number.refined(&width).ends();
                    &lower + (&upper - &lower) * if k == 0 { shift.clone() } else { rational(1, 2) }
                }
            };
            let point: Vec<Rational> = zero.coordinates.iter().enumerate().map(coordinate).collect();
            if holds(&point) {
                return point;
            }
        }
        width /= integer(16);
    }
}

#[cfg(test)]
#[path = "region_tests.rs"]
mod tests;
