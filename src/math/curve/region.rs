//! Signs of a polynomial in two variables on a rectangle or triangle, with certificates.
//!
//! F = S² G, where G has each irreducible factor at most once, is not negative on a region with an interior if and only if G is not.
//! That is shown by Bernstein coefficients of G that are not negative, over parts of the region. Where G has a zero inside of
//! it, that may never end; then the least value of G is found where it can be: at a corner, on an edge, where G is a
//! polynomial in one variable, or at a critical point inside, a common zero of both derivatives.
//!
//! R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29 (2012); V. Powers, B. Reznick,
//! "Polynomials that are positive on an interval", Trans. AMS 352 (2000).

use std::collections::VecDeque;

use num_traits::{One, Signed, Zero};

use super::{Direction, Interval, Point, TensorPatch, Triangle, TrianglePatch, indices};
use crate::budget;
use crate::math::number::{Rational, integer, rational};
use crate::math::poly::{MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;
use crate::math::system::{Bounds, RealZero, SystemError, common_zeros};

/// A rectangle or a triangle.
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// Pairs of numbers from two intervals.
    Rectangle([Rational; 2], [Rational; 2]),
    /// The convex hull of three points.
    Triangle([[Rational; 2]; 3]),
}

/// A part of a region, and the Bernstein coefficients over it: rows in the first variable, or b_{ijk} in the order of
/// [`indices`].
#[derive(Clone, Debug, PartialEq)]
pub struct RegionPart {
    /// The part.
    pub region: Region,
    /// The coefficients.
    pub coefficients: Vec<Vec<Rational>>,
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
    /// G is not negative on the edges, nor at these critical points: all of those in the region that do not form curves, and for
    /// each closed curve of them one at least.
    CriticalPoints(Vec<RealZero>),
}

/// Why it is not shown that F ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub enum RegionFailure {
    /// F is negative at this point of the region.
    Negative([Rational; 2]),
    /// Many parts did not suffice, and the critical points are not found.
    Open(SystemError),
}

/// Parts are halved until there are so many.
const MOST_PARTS: usize = 48;

impl Region {
    /// The corners, in order around the region.
    pub fn corners(&self) -> Vec<[Rational; 2]> {
        match self {
            Region::Rectangle([a, b], [c, d]) => {
                [(a, c), (b, c), (b, d), (a, d)].map(|(x, y)| [x.clone(), y.clone()]).to_vec()
            }
            Region::Triangle(corners) => corners.to_vec(),
        }
    }

    /// Linear forms that are not negative exactly on the region.
    fn sides(&self, unknowns: &[Symbol; 2]) -> Vec<MultiPoly> {
        let corners = self.corners();
        let [x, y] = unknowns.clone().map(MultiPoly::symbol);
        let centre =
            corners.iter().fold([Rational::zero(), Rational::zero()], |[s, t], [x, y]| [s + x, t + y]);
        let centre = centre.map(|c| c / integer(corners.len() as i64));
        let side = |i: usize| {
            let ([a, b], [c, d]) = (&corners[i], &corners[(i + 1) % corners.len()]);
            let (dx, dy) = (c - a, d - b);
            let form = (y.clone() - MultiPoly::constant(b.clone())).scaled(&dx)
                - (x.clone() - MultiPoly::constant(a.clone())).scaled(&dy);
            let inside = (&centre[1] - b) * &dx - (&centre[0] - a) * &dy;
            if inside.is_negative() { -form } else { form }
        };
        (0..corners.len()).map(side).collect()
    }
}

/// A part that is still to be looked at.
enum Open {
    Rectangle(TensorPatch<Rational>),
    Triangle(TrianglePatch<Rational>),
}

impl Open {
    fn new(f: &MultiPoly, unknowns: &[Symbol; 2], region: &Region) -> Self {
        let [u, v] = unknowns;
        let rows: Vec<Vec<Rational>> = f
            .coefficients_in(u)
            .iter()
            .map(|c| {
                c.coefficients_in(v)
                    .iter()
                    .map(|c| c.as_constant().expect("numbers as coefficients"))
                    .collect()
            })
            .collect();
        match region {
            Region::Rectangle([a, b], [c, d]) => {
                let width = rows.iter().map(Vec::len).max().unwrap_or(1);
                let entry =
                    |row: &Vec<Rational>, j: usize| vec![row.get(j).cloned().unwrap_or_else(Rational::zero)];
                let grid = rows.iter().map(|row| (0..width).map(|j| entry(row, j)).collect()).collect();
                let interval = |a: &Rational, b: &Rational| {
                    Interval::new(a.clone(), b.clone()).expect("a rectangle has a width and a height")
                };
                let patch = TensorPatch::from_power_coefficients(grid, interval(a, b), interval(c, d));
                Open::Rectangle(patch.expect("the rows have one length"))
            }
            Region::Triangle(corners) => {
                // Over the triangle (1, 0), (0, 1), (0, 0) by powers: u^i v^j has the coefficient c_ij/multinomial as a
                // polar value for vectors; the polar form gives all others.
                let degree = f.total_degree().unwrap_or(0) as usize;
                let terms = rows.iter().enumerate().flat_map(|(i, row)| {
                    row.iter()
                        .enumerate()
                        .filter(|(_, c)| !c.is_zero())
                        .map(move |(j, c)| (vec![i as u32, j as u32], c.clone()))
                });
                let form = crate::math::blossom::TotalDegreePolarForm::new(2, degree, terms)
                    .expect("the degree is that of the polynomial");
                let triangle = Triangle::new(corners.clone().map(Vec::from)).expect("a triangle has an area");
                Open::Triangle(TrianglePatch::from_polar_forms(&[form], triangle).expect("one coordinate"))
            }
        }
    }

    fn coefficients(&self) -> Vec<Vec<Rational>> {
        let number = |point: &Point<Rational>| point[0].clone();
        match self {
            Open::Rectangle(patch) => {
                patch.net().iter().map(|row| row.iter().map(number).collect()).collect()
            }
            Open::Triangle(patch) => vec![patch.points().iter().map(number).collect()],
        }
    }

    fn region(&self) -> Region {
        match self {
            Open::Rectangle(patch) => {
                let ends = |interval: &Interval<Rational>| [interval.start().clone(), interval.end().clone()];
                Region::Rectangle(ends(patch.u()), ends(patch.v()))
            }
            Open::Triangle(patch) => {
                Region::Triangle(patch.triangle().corners().each_ref().map(|p| [p[0].clone(), p[1].clone()]))
            }
        }
    }

    /// Two halves, cut across where the least coefficient lies furthest inside.
    fn halves(self) -> [Open; 2] {
        let list = self.coefficients();
        let half = rational(1, 2);
        match self {
            Open::Rectangle(patch) => {
                let (m, n) = patch.degrees();
                let places = (0..=m).flat_map(|i| (0..=n).map(move |j| (i, j)));
                let (i, j) = places.min_by(|p, q| list[p.0][p.1].cmp(&list[q.0][q.1])).unwrap_or((0, 0));
                let inside = |i: usize, n: usize| i.min(n - i) * 2 * (m + n + 1) / n.max(1);
                let width = |interval: &Interval<Rational>| interval.end() - interval.start();
                let along_u = match inside(i, m).cmp(&inside(j, n)) {
                    std::cmp::Ordering::Equal => width(patch.u()) >= width(patch.v()) && m > 0 || n == 0,
                    order => order.is_gt(),
                };
                let (direction, interval) =
                    if along_u { (Direction::U, patch.u()) } else { (Direction::V, patch.v()) };
                let middle = (interval.start() + interval.end()) * half;
                let (first, second) = patch.subdivide(direction, &middle).expect("the middle is no end");
                [Open::Rectangle(first), Open::Rectangle(second)]
            }
            Open::Triangle(patch) => {
                let places = indices(patch.degree());
                let at = (0..places.len()).min_by(|&p, &q| list[0][p].cmp(&list[0][q])).unwrap_or(0);
                // The edge between the corners with the two largest indices.
                let [i, j, k] = places[at];
                let opposite = if i <= j && i <= k {
                    0
                } else if j <= k {
                    1
                } else {
                    2
                };
                let (p, q) = ((opposite + 1) % 3, (opposite + 2) % 3);
                let corners = patch.triangle().corners();
                let middle: Point<Rational> =
                    corners[p].iter().zip(corners[q].iter()).map(|(x, y)| (x + y) * &half).collect();
                let with = |at: usize| {
                    let mut corners = corners.clone();
                    corners[at] = middle.clone();
                    Open::Triangle(
                        patch.over(Triangle::new(corners).expect("half of a triangle has an area")),
                    )
                };
                [with(q), with(p)]
            }
        }
    }
}

/// Why F ≥ 0 on a region. F is a polynomial in the two unknowns, the region has an area.
///
/// Cost: a factorisation, up to 96 subdivisions, and if these do not suffice the common zeros of both derivatives.
///
/// # Errors
/// A point of the region where F is negative, or [`RegionFailure::Open`] if both ways fail.
///
/// # Panics
/// If F has other symbols or the region is empty.
///
/// ```
/// use polarform::curve::{Region, RegionFailure, RegionShown, positivity_on};
/// use polarform::number::{integer, rational};
/// use polarform::poly::{MultiPoly, Symbol};
/// let unknowns = ["u", "v"].map(Symbol::new);
/// let [u, v] = unknowns.clone().map(MultiPoly::symbol);
/// let square = Region::Rectangle([0, 1].map(integer), [0, 1].map(integer));
/// let f = MultiPoly::constant(integer(1)) - u.clone() * v.clone();
/// let shown = positivity_on(&f, &unknowns, &square).unwrap();
/// let RegionShown::Coefficients(parts) = shown.shown else { panic!() };
/// assert_eq!(parts[0].coefficients, [[1, 1], [1, 0]].map(|row| row.map(integer).to_vec()));
/// let g = u * v - MultiPoly::constant(rational(1, 2));
/// assert_eq!(positivity_on(&g, &unknowns, &square), Err(RegionFailure::Negative([0, 0].map(integer))));
/// ```
pub fn positivity_on(
    f: &MultiPoly,
    unknowns: &[Symbol; 2],
    region: &Region,
) -> Result<RegionPositivity, RegionFailure> {
    let value = |f: &MultiPoly, point: &[Rational; 2]| -> Rational {
        let at = |s: &Symbol| unknowns.iter().position(|x| x == s).map(|k| point[k].clone());
        f.value(&at).as_constant().expect("only the unknowns occur")
    };
    let factors = f.factors();
    let (mut square, mut rest) = (MultiPoly::one(), MultiPoly::constant(factors.constant));
    for (factor, multiplicity) in factors.factors {
        square *= factor.pow((multiplicity / 2) as u32);
        if multiplicity % 2 == 1 {
            rest *= factor;
        }
    }
    let certificate = |rest: &MultiPoly, shown| RegionPositivity {
        root_of_square: square.clone(),
        rest: rest.clone(),
        shown,
    };
    let mut open = VecDeque::from([Open::new(&rest, unknowns, region)]);
    let mut parts = Vec::new();
    let mut looked_at = 0;
    while let Some(part) = open.pop_front() {
        budget::step();
        looked_at += 1;
        let corners = part.region().corners();
        if let Some(corner) = corners.into_iter().find(|corner| value(f, corner).is_negative()) {
            return Err(RegionFailure::Negative(corner));
        }
        let coefficients = part.coefficients();
        budget::charge_terms(coefficients.iter().map(|row| row.len() as u64).sum());
        if coefficients.iter().flatten().all(|c| !c.is_negative()) {
            parts.push(RegionPart { region: part.region(), coefficients });
            continue;
        }
        if looked_at + open.len() > 2 * MOST_PARTS {
            return by_critical_points(f, &rest, unknowns, region, &value)
                .map(|zeros| certificate(&rest, RegionShown::CriticalPoints(zeros)));
        }
        open.extend(part.halves());
    }
    Ok(certificate(&rest, RegionShown::Coefficients(parts)))
}

/// The critical points of G in the region, if it is negative neither there nor on the edges.
fn by_critical_points(
    f: &MultiPoly,
    g: &MultiPoly,
    unknowns: &[Symbol; 2],
    region: &Region,
    value: &dyn Fn(&MultiPoly, &[Rational; 2]) -> Rational,
) -> Result<Vec<RealZero>, RegionFailure> {
    let corners = region.corners();
    let [x, y] = unknowns;
    for i in 0..corners.len() {
        let (p, q) = (&corners[i], &corners[(i + 1) % corners.len()]);
        let line = |k: usize| {
            Poly::from_coefficients(vec![p[k].clone(), &q[k] - &p[k]]).value_in(&MultiPoly::symbol(x.clone()))
        };
        let on_edge = f.substitute(&[(x.clone(), line(0)), (y.clone(), line(1))]);
        let on_edge: Poly =
            on_edge.coefficients_in(x).iter().map(|c| c.as_constant().expect("one variable")).collect();
        if let Some(t) = on_edge.negative_point(Some(&Rational::zero()), Some(&Rational::one())) {
            let point = [0, 1].map(|k| &p[k] + (&q[k] - &p[k]) * &t);
            return Err(RegionFailure::Negative(point));
        }
    }
    let bound = |k: usize| {
        let list = || corners.iter().map(|p| p[k].clone());
        (list().min(), list().max())
    };
    let bounds = [bound(0), bound(1)];
    let zeros = critical_points(g, unknowns, &bounds).map_err(RegionFailure::Open)?;
    let sides = region.sides(unknowns);
    let inside: Vec<RealZero> = zeros
        .into_iter()
        .filter(|zero| sides.iter().all(|side| zero.sign_of(side, unknowns).is_ge()))
        .collect();
    for zero in &inside {
        if zero.sign_of(g, unknowns).is_lt() {
            return Err(RegionFailure::Negative(near(zero, |point: &[Rational; 2]| {
                let inside = sides.iter().all(|side| !value(side, point).is_negative());
                inside && value(f, point).is_negative()
            })));
        }
    }
    Ok(inside)
}

/// The critical points of G, but of curves of them only some points: at least one on each closed component.
///
/// G is constant along a curve p = 0 on which both derivatives vanish. Such a component meets the edges, or it is closed; then it
/// has a point where p_x = 0.
fn critical_points(
    g: &MultiPoly,
    unknowns: &[Symbol; 2],
    bounds: &[Bounds; 2],
) -> Result<Vec<RealZero>, SystemError> {
    let derivatives = unknowns.each_ref().map(|x| g.derivative(x));
    let common = derivatives[0].gcd(&derivatives[1]);
    let [Some(first), Some(second)] = derivatives.map(|d| d.div_exact(&common)) else {
        // G is a number.
        return Ok(Vec::new());
    };
    let mut zeros = common_zeros(&first, &second, unknowns, bounds)?;
    for (p, _) in common.factors().factors {
        let slope = p.derivative(&unknowns[0]);
        if !slope.is_zero() {
            zeros.extend(common_zeros(&p, &slope, unknowns, bounds)?);
        }
    }
    Ok(zeros)
}

/// A rational point near a zero that has a property of all points near enough but those of a curve or surface.
pub(super) fn near<const N: usize>(zero: &RealZero, holds: impl Fn(&[Rational; N]) -> bool) -> [Rational; N] {
    let mut width = rational(1, 4);
    loop {
        budget::step();
        // Not the middle for all: S may be 0 on a line through it.
        for shift in [rational(1, 2), rational(1, 3), rational(3, 5), rational(5, 7)] {
            let coordinate = |k: usize| match &zero.coordinates[k] {
                RealRoot::Rational(q) => q + &width * (&shift - rational(1, 2)) * integer(k as i64 + 1),
                RealRoot::Irrational(number) => {
                    let (lower, upper) = number.refined(&width).ends();
                    &lower + (&upper - &lower) * if k == 0 { shift.clone() } else { rational(1, 2) }
                }
            };
            let point = std::array::from_fn(coordinate);
            if holds(&point) {
                return point;
            }
        }
        width /= integer(16);
    }
}

/// Whether the coefficients are those of F over the part: Σ of Bernstein polynomials.
#[cfg(test)]
fn checks(part: &RegionPart, f: &MultiPoly, unknowns: &[Symbol; 2]) -> bool {
    let [u, v] = unknowns.clone().map(MultiPoly::symbol);
    let number = |q: &Rational| MultiPoly::constant(q.clone());
    let mut sum = MultiPoly::zero();
    match &part.region {
        Region::Rectangle([a, b], [c, d]) => {
            let (m, n) = (part.coefficients.len() - 1, part.coefficients[0].len() - 1);
            let bernstein = |n: usize, i: usize, x: &MultiPoly, a: &Rational, b: &Rational| {
                let scale = (b - a).powered(n as u32).recip()
                    * Rational::from_integer(crate::math::number::binomial(n, i));
                ((x.clone() - number(a)).pow(i as u32) * (number(b) - x.clone()).pow((n - i) as u32))
                    .scaled(&scale)
            };
            for (i, row) in part.coefficients.iter().enumerate() {
                for (j, q) in row.iter().enumerate() {
                    sum += (bernstein(m, i, &u, a, b) * bernstein(n, j, &v, c, d)).scaled(q);
                }
            }
        }
        Region::Triangle([p, q, r]) => {
            let count = part.coefficients[0].len();
            let n = (0..).find(|n| (n + 1) * (n + 2) / 2 >= count).unwrap_or(0);
            let turn = |p: &[Rational; 2], q: &[Rational; 2]| {
                (v.clone() - number(&p[1])).scaled(&(&q[0] - &p[0]))
                    - (u.clone() - number(&p[0])).scaled(&(&q[1] - &p[1]))
            };
            let area = (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0]);
            let barycentric = [turn(q, r), turn(r, p), turn(p, q)].map(|form| form.scaled(&area.recip()));
            for ([i, j, k], c) in indices(n).into_iter().zip(&part.coefficients[0]) {
                let [a, b, d] = &barycentric;
                let scale = c * Rational::from_integer(crate::math::number::multinomial(&[i, j, k]));
                sum += (a.pow(i as u32) * b.pow(j as u32) * d.pow(k as u32)).scaled(&scale);
            }
        }
    }
    sum == *f
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn unknowns() -> [Symbol; 2] {
        ["u", "v"].map(Symbol::new)
    }

    fn polynomial(degree: usize) -> impl Strategy<Value = MultiPoly> {
        prop::collection::vec((0..=degree, 0..=degree, -4i64..6), 1..7).prop_map(|list| {
            let [u, v] = unknowns().map(MultiPoly::symbol);
            list.into_iter().fold(MultiPoly::zero(), |sum, (i, j, c)| {
                sum + (u.pow(i as u32) * v.pow(j as u32)).scaled(&integer(c))
            })
        })
    }

    fn region() -> impl Strategy<Value = Region> {
        (any::<bool>(), -2i64..2, -2i64..2, 1i64..3, 1i64..3, -1i64..2).prop_map(
            |(box_shaped, a, b, w, h, s)| match box_shaped {
                true => Region::Rectangle([a, a + w].map(integer), [b, b + h].map(integer)),
                false => Region::Triangle([[a, b], [a + w, b + s], [a - s, b + h]].map(|p| p.map(integer))),
            },
        )
    }

    /// Points of a grid over the region.
    fn samples(region: &Region) -> Vec<[Rational; 2]> {
        let corners = region.corners();
        let mut found = Vec::new();
        for i in 0..=6i64 {
            for j in 0..=6i64 {
                let (s, t) = (rational(i, 6), rational(j, 6));
                let point = |k: usize| match corners.as_slice() {
                    [p, q, r] => &p[k] + (&q[k] - &p[k]) * &s * (integer(1) - &t) + (&r[k] - &p[k]) * &s * &t,
                    _ => &corners[0][k] + (&corners[2][k] - &corners[0][k]) * if k == 0 { &s } else { &t },
                };
                found.push([point(0), point(1)]);
            }
        }
        found
    }

    fn value(f: &MultiPoly, p: &[Rational; 2]) -> Rational {
        let names = unknowns();
        f.value(&|s| names.iter().position(|x| x == s).map(|k| p[k].clone())).as_constant().unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        /// Certificates are right, points are negative and in the region, and no sample contradicts the verdict.
        #[test]
        fn verdicts_agree_with_values(f in polynomial(3), g in polynomial(2), region in region(), kind in 0..4) {
            let symbols = unknowns();
            let f = match kind {
                0 => f,
                1 => f.pow(2) + g.pow(2),
                2 => g.pow(2) * (f + MultiPoly::constant(integer(9))),
                _ => f + MultiPoly::constant(integer(3)),
            };
            let least = samples(&region).iter().map(|p| value(&f, p)).min().unwrap();
            match positivity_on(&f, &symbols, &region) {
                Ok(shown) => {
                    prop_assert!(!least.is_negative());
                    prop_assert_eq!(shown.root_of_square.pow(2) * shown.rest.clone(), f);
                    if let RegionShown::Coefficients(parts) = &shown.shown {
                        prop_assert!(parts.iter().all(|part| checks(part, &shown.rest, &symbols)));
                        prop_assert!(parts.iter().all(|part| part.coefficients.iter().flatten().all(|c| !c.is_negative())));
                        let area = |region: &Region| match region {
                            Region::Rectangle([a, b], [c, d]) => (b - a) * (d - c),
                            Region::Triangle([p, q, r]) => ((&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0])).abs(),
                        };
                        let sum = parts.iter().fold(Rational::zero(), |sum, part| sum + area(&part.region));
                        prop_assert_eq!(sum, area(&region));
                    }
                }
                Err(RegionFailure::Negative(p)) => {
                    prop_assert!(value(&f, &p).is_negative());
                    prop_assert!(region.sides(&symbols).iter().all(|side| !value(side, &p).is_negative()));
                }
                Err(RegionFailure::Open(_)) => prop_assert!(!least.is_negative() && kind > 0),
            }
        }
    }

    #[test]
    fn zeros_inside_need_critical_points() {
        let symbols = unknowns();
        let [u, v] = symbols.clone().map(MultiPoly::symbol);
        let square = Region::Rectangle([-1, 1].map(integer), [-1, 2].map(integer));
        let one = MultiPoly::constant(rational(1, 3));
        // (u − 1/3)² + (v − 1/3)²: 0 at one point.
        let f = (u.clone() - one.clone()).pow(2) + (v.clone() - one).pow(2);
        let RegionShown::CriticalPoints(points) = positivity_on(&f, &symbols, &square).unwrap().shown else {
            panic!()
        };
        assert_eq!(points[0].coordinates, [1, 1].map(|_| RealRoot::Rational(rational(1, 3))));
        let lower = f - MultiPoly::constant(rational(1, 1 << 20));
        let Err(RegionFailure::Negative(p)) = positivity_on(&lower, &symbols, &square) else { panic!() };
        assert!(value(&lower, &p).is_negative());
        // Motzkin's polynomial is no sum of squares, and has zeros at (±1, ±1).
        let motzkin = u.pow(4) * v.pow(2) + u.pow(2) * v.pow(4) - (u.pow(2) * v.pow(2)).scaled(&integer(3))
            + MultiPoly::one();
        assert!(
            positivity_on(&motzkin, &symbols, &Region::Rectangle([-2, 2].map(integer), [-2, 2].map(integer)))
                .is_ok()
        );
    }
}
