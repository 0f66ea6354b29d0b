//! Signs of a polynomial in three variables on a box or tetrahedron, with certificates.
//!
//! As in the plane: F = S² G, where G has each irreducible factor at most once, is not negative on a solid if and only if G is not. That is
//! shown by Bernstein coefficients of G that are not negative, over parts of the solid; else by the faces, where G is a polynomial in two
//! variables, and by the critical points inside, the common zeros of all three derivatives, if these are finitely many.
//!
//! R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29 (2012).

use std::collections::VecDeque;

use num_traits::{One, Signed, Zero};

use super::region::near;
use super::{Region, RegionFailure, positivity_on};
use crate::budget;
use crate::math::blossom::TotalDegreePolarForm;
use crate::math::number::{Rational, binomial, integer, rational};
use crate::math::poly::{MultiPoly, Symbol};
use crate::math::ring::Ring;
use crate::math::system::{MOST_SOLUTIONS, RealZero, SystemError, real_zeros};

/// A box or a tetrahedron.
#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// Triples of numbers from three intervals.
    Box([[Rational; 2]; 3]),
    /// The convex hull of four points.
    Tetrahedron([[Rational; 3]; 4]),
}

/// A part of a solid, and the Bernstein coefficients over it with their indices.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidPart {
    /// The part.
    pub solid: Solid,
    /// b_{ijk} of degrees l, m, n, or b_{ijkl} with i + j + k + l = n.
    pub coefficients: Vec<(Vec<usize>, Rational)>,
}

/// Why F ≥ 0 on a solid: F = S² G, and why G ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidPositivity {
    /// S
    pub root_of_square: MultiPoly,
    /// G
    pub rest: MultiPoly,
    /// What shows it.
    pub shown: SolidShown,
}

/// What shows that G ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidShown {
    /// Coefficients that are not negative, over parts that cover the solid.
    Coefficients(Vec<SolidPart>),
    /// G is not negative on the faces, nor at all its critical points in the solid, which are these.
    CriticalPoints(Vec<RealZero>),
}

/// Why it is not shown that F ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidFailure {
    /// F is negative at this point of the solid.
    Negative([Rational; 3]),
    /// Many parts did not suffice, and the critical points are not found.
    Open(SystemError),
}

/// Parts are halved until so many were looked at.
const MOST_PARTS: usize = 400;

impl Solid {
    /// The corners.
    pub fn corners(&self) -> Vec<[Rational; 3]> {
        match self {
            Solid::Box(ends) => {
                let corner = |k: usize| std::array::from_fn(|i| ends[i][k >> i & 1].clone());
                (0..8).map(corner).collect()
            }
            Solid::Tetrahedron(corners) => corners.to_vec(),
        }
    }

    /// Whether it has a volume.
    pub fn is_proper(&self) -> bool {
        match self {
            Solid::Box(ends) => ends.iter().all(|[a, b]| a < b),
            Solid::Tetrahedron(corners) => !volume(corners).is_zero(),
        }
    }

    /// Linear forms that are not negative exactly on the solid.
    fn sides(&self, unknowns: &[Symbol; 3]) -> Vec<MultiPoly> {
        let letters = unknowns.clone().map(MultiPoly::symbol);
        let number = |q: &Rational| MultiPoly::constant(q.clone());
        match self {
            Solid::Box(ends) => (0..3)
                .flat_map(|k| {
                    [letters[k].clone() - number(&ends[k][0]), number(&ends[k][1]) - letters[k].clone()]
                })
                .collect(),
            Solid::Tetrahedron(corners) => (0..4)
                .map(|k| {
                    let [p, q, r] = std::array::from_fn(|i| &corners[(k + i + 1) % 4]);
                    let normal = cross(&minus(q, p), &minus(r, p));
                    let form = (0..3).fold(MultiPoly::zero(), |sum, i| {
                        sum + (letters[i].clone() - number(&p[i])).scaled(&normal[i])
                    });
                    let inside = dot(&normal, &minus(&corners[k], p));
                    if inside.is_negative() { -form } else { form }
                })
                .collect(),
        }
    }

    /// The Bernstein coefficients of a polynomial over it.
    fn coefficients(&self, f: &MultiPoly, unknowns: &[Symbol; 3]) -> Vec<(Vec<usize>, Rational)> {
        match self {
            Solid::Box(ends) => over_box(f, unknowns, ends),
            Solid::Tetrahedron(corners) => {
                let degree = f.total_degree().unwrap_or(0) as usize;
                let terms =
                    f.terms(crate::math::poly::MonomialOrder::Lex).into_iter().map(|(monomial, c)| {
                        let exponent =
                            |x: &Symbol| monomial.iter().find(|(s, _)| s == x).map_or(0, |(_, e)| *e);
                        (unknowns.iter().map(exponent).collect::<Vec<u32>>(), c)
                    });
                let form = TotalDegreePolarForm::new(3, degree, terms.collect::<Vec<_>>())
                    .expect("the degree is that of the polynomial");
                let corners: Vec<Vec<Rational>> = corners.iter().map(|p| p.to_vec()).collect();
                form.bezier_points(&corners).expect("four corners in space")
            }
        }
    }

    /// Two halves: the longest interval or edge is halved.
    fn halves(&self) -> [Solid; 2] {
        let half = rational(1, 2);
        match self {
            Solid::Box(ends) => {
                let width = |k: &usize| &ends[*k][1] - &ends[*k][0];
                let k = (0..3).max_by(|i, j| width(i).cmp(&width(j)).then(j.cmp(i))).unwrap_or(0);
                let middle = (&ends[k][0] + &ends[k][1]) * half;
                let (mut low, mut high) = (ends.clone(), ends.clone());
                low[k][1] = middle.clone();
                high[k][0] = middle;
                [Solid::Box(low), Solid::Box(high)]
            }
            Solid::Tetrahedron(corners) => {
                let edges = (0..4).flat_map(|i| (0..i).map(move |j| (j, i)));
                let length = |&(i, j): &(usize, usize)| {
                    let d = minus(&corners[i], &corners[j]);
                    dot(&d, &d)
                };
                let (i, j) = edges.max_by(|a, b| length(a).cmp(&length(b))).unwrap_or((0, 1));
                let middle: [Rational; 3] =
                    std::array::from_fn(|k| (&corners[i][k] + &corners[j][k]) * &half);
                let with = |place: usize| {
                    let mut corners = corners.clone();
                    corners[place] = middle.clone();
                    Solid::Tetrahedron(corners)
                };
                [with(j), with(i)]
            }
        }
    }
}

fn minus(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    std::array::from_fn(|k| &a[k] - &b[k])
}

fn dot(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    a.iter().zip(b).fold(Rational::zero(), |sum, (x, y)| sum + x * y)
}

fn cross(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &a[i] * &b[j] - &a[j] * &b[i]
    })
}

fn volume([p, q, r, s]: &[[Rational; 3]; 4]) -> Rational {
    dot(&cross(&minus(q, p), &minus(r, p)), &minus(s, p))
}

/// Σ c_pqr s^p t^q r^r over the unit cube, one variable after the other: b_i = Σ_{p ≤ i} C(i, p)/C(n, p) c_p.
fn over_box(f: &MultiPoly, unknowns: &[Symbol; 3], ends: &[[Rational; 2]; 3]) -> Vec<(Vec<usize>, Rational)> {
    let line = |k: usize| {
        let [a, b] = &ends[k];
        MultiPoly::symbol(unknowns[k].clone()).scaled(&(b - a)) + MultiPoly::constant(a.clone())
    };
    let moved: Vec<(Symbol, MultiPoly)> = (0..3).map(|k| (unknowns[k].clone(), line(k))).collect();
    let f = f.substitute(&moved);
    let degrees: [usize; 3] = std::array::from_fn(|k| f.degree_in(&unknowns[k]) as usize);
    let sizes = degrees.map(|n| n + 1);
    budget::charge_terms(sizes.iter().map(|&n| n as u64).product());
    let place = |index: &[usize; 3]| (index[0] * sizes[1] + index[1]) * sizes[2] + index[2];
    let mut list = vec![Rational::zero(); sizes.iter().product()];
    for (monomial, c) in f.terms(crate::math::poly::MonomialOrder::Lex) {
        let exponent = |x: &Symbol| monomial.iter().find(|(s, _)| s == x).map_or(0, |(_, e)| *e as usize);
        list[place(&std::array::from_fn(|k| exponent(&unknowns[k])))] = c;
    }
    let all: Vec<[usize; 3]> = (0..sizes[0])
        .flat_map(|i| (0..sizes[1]).flat_map(move |j| (0..sizes[2]).map(move |k| [i, j, k])))
        .collect();
    for (axis, &n) in degrees.iter().enumerate() {
        budget::steps(list.len() as u32);
        let weight = |i: usize, p: usize| Rational::new(binomial(i, p), binomial(n, p));
        let value = |index: &[usize; 3]| {
            (0..=index[axis]).fold(Rational::zero(), |sum, p| {
                let mut from = *index;
                from[axis] = p;
                sum + &list[place(&from)] * weight(index[axis], p)
            })
        };
        list = all.iter().map(value).collect();
    }
    all.iter().zip(list).map(|(index, value)| (index.to_vec(), value)).collect()
}

/// Why F ≥ 0 on a solid. F is a polynomial in the three unknowns, the solid has a volume.
///
/// Cost: a factorisation, the coefficients over 400 parts at most, and if these do not suffice [`positivity_on`] for each face and a Gröbner basis
/// for the critical points.
///
/// # Errors
/// A point of the solid where F is negative, or [`SolidFailure::Open`] if both ways fail.
///
/// # Panics
/// If F has other symbols or the solid has no volume.
///
/// ```
/// use polarform::curve::{Solid, SolidFailure, SolidShown, positivity_in};
/// use polarform::number::{integer, rational};
/// use polarform::poly::{MultiPoly, Symbol};
/// let unknowns = ["u", "v", "w"].map(Symbol::new);
/// let [u, v, w] = unknowns.clone().map(MultiPoly::symbol);
/// let cube = Solid::Box([(); 3].map(|_| [0, 1].map(integer)));
/// let f = MultiPoly::constant(integer(1)) - u * v * w;
/// assert!(matches!(positivity_in(&f, &unknowns, &cube).unwrap().shown, SolidShown::Coefficients(_)));
/// let g = f - MultiPoly::constant(rational(1, 2));
/// assert_eq!(positivity_in(&g, &unknowns, &cube), Err(SolidFailure::Negative([1, 1, 1].map(integer))));
/// ```
pub fn positivity_in(
    f: &MultiPoly,
    unknowns: &[Symbol; 3],
    solid: &Solid,
) -> Result<SolidPositivity, SolidFailure> {
    assert!(solid.is_proper(), "the solid has a volume");
    let value = |f: &MultiPoly, point: &[Rational; 3]| -> Rational {
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
    let certificate = |rest: &MultiPoly, shown| SolidPositivity {
        root_of_square: square.clone(),
        rest: rest.clone(),
        shown,
    };
    let mut open = VecDeque::from([solid.clone()]);
    let (mut parts, mut looked_at) = (Vec::new(), 0);
    while let Some(part) = open.pop_front() {
        budget::step();
        looked_at += 1;
        if let Some(corner) = part.corners().into_iter().find(|corner| value(f, corner).is_negative()) {
            return Err(SolidFailure::Negative(corner));
        }
        let coefficients = part.coefficients(&rest, unknowns);
        if coefficients.iter().all(|(_, c)| !c.is_negative()) {
            parts.push(SolidPart { solid: part, coefficients });
            continue;
        }
        if looked_at + open.len() > MOST_PARTS {
            return by_critical_points(f, &rest, unknowns, solid, &value)
                .map(|zeros| certificate(&rest, SolidShown::CriticalPoints(zeros)));
        }
        open.extend(part.halves());
    }
    Ok(certificate(&rest, SolidShown::Coefficients(parts)))
}

/// The faces: F as a polynomial in two unknowns, the region where these lie, and the point of two numbers.
type Face<'a> = (MultiPoly, [Symbol; 2], Region, Box<dyn Fn(&[Rational; 2]) -> [Rational; 3] + 'a>);

fn faces<'a>(f: &MultiPoly, unknowns: &[Symbol; 3], solid: &'a Solid) -> Vec<Face<'a>> {
    match solid {
        Solid::Box(ends) => (0..6)
            .map(|face| -> Face<'a> {
                let (k, end) = (face / 2, &ends[face / 2][face % 2]);
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let on = f.substitute(&[(unknowns[k].clone(), MultiPoly::constant(end.clone()))]);
                let point = move |p: &[Rational; 2]| {
                    let mut point = [end.clone(), end.clone(), end.clone()];
                    (point[i], point[j]) = (p[0].clone(), p[1].clone());
                    point
                };
                let region = Region::Rectangle(ends[i].clone(), ends[j].clone());
                (on, [unknowns[i].clone(), unknowns[j].clone()], region, Box::new(point))
            })
            .collect(),
        Solid::Tetrahedron(corners) => (0..4)
            .map(|k| -> Face<'a> {
                let [p, q, r] = std::array::from_fn(|i| &corners[(k + i + 1) % 4]);
                let pair = [unknowns[0].clone(), unknowns[1].clone()];
                let [s, t] = pair.clone().map(MultiPoly::symbol);
                let line = |i: usize| {
                    MultiPoly::constant(p[i].clone())
                        + s.scaled(&(&q[i] - &p[i]))
                        + t.scaled(&(&r[i] - &p[i]))
                };
                let moved: Vec<(Symbol, MultiPoly)> =
                    (0..3).map(|i| (unknowns[i].clone(), line(i))).collect();
                let point = move |at: &[Rational; 2]| {
                    std::array::from_fn(|i| &p[i] + (&q[i] - &p[i]) * &at[0] + (&r[i] - &p[i]) * &at[1])
                };
                let unit = Region::Triangle([[0, 0], [1, 0], [0, 1]].map(|p| p.map(integer)));
                (f.substitute(&moved), pair, unit, Box::new(point))
            })
            .collect(),
    }
}

/// The critical points of G in the solid, if it is negative neither there nor on the faces.
fn by_critical_points(
    f: &MultiPoly,
    g: &MultiPoly,
    unknowns: &[Symbol; 3],
    solid: &Solid,
    value: &dyn Fn(&MultiPoly, &[Rational; 3]) -> Rational,
) -> Result<Vec<RealZero>, SolidFailure> {
    for (on, pair, region, point) in faces(f, unknowns, solid) {
        match positivity_on(&on, &pair, &region) {
            Ok(_) => {}
            Err(RegionFailure::Negative(at)) => return Err(SolidFailure::Negative(point(&at))),
            Err(RegionFailure::Open(error)) => return Err(SolidFailure::Open(error)),
        }
    }
    let derivatives: Vec<MultiPoly> = unknowns.iter().map(|x| g.derivative(x)).collect();
    // Bézout's bound: a Gröbner basis for more would take very long.
    let most = derivatives
        .iter()
        .fold(1_usize, |most, d| most.saturating_mul(d.total_degree().unwrap_or(0) as usize));
    if most > MOST_SOLUTIONS {
        return Err(SolidFailure::Open(SystemError::Degrees));
    }
    let zeros = real_zeros(&derivatives, unknowns).map_err(SolidFailure::Open)?;
    let sides = solid.sides(unknowns);
    let inside: Vec<RealZero> = zeros
        .into_iter()
        .filter(|zero| sides.iter().all(|side| zero.sign_of(side, unknowns).is_ge()))
        .collect();
    match inside.iter().find(|zero| zero.sign_of(g, unknowns).is_lt()) {
        None => Ok(inside),
        Some(zero) => Err(SolidFailure::Negative(near(zero, |point: &[Rational; 3]| {
            let inside = sides.iter().all(|side| !value(side, point).is_negative());
            inside && value(f, point).is_negative()
        }))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, multinomial};
    use proptest::prelude::*;

    fn unknowns() -> [Symbol; 3] {
        ["u", "v", "w"].map(Symbol::new)
    }

    fn polynomial() -> impl Strategy<Value = MultiPoly> {
        prop::collection::vec((-4i64..5, 0u32..3, 0u32..3, 0u32..2), 1..6).prop_map(|terms| {
            let [u, v, w] = unknowns().map(MultiPoly::symbol);
            terms.into_iter().fold(MultiPoly::zero(), |sum, (c, i, j, k)| {
                sum + (u.pow(i) * v.pow(j) * w.pow(k)).scaled(&z(c))
            })
        })
    }

    fn solid() -> impl Strategy<Value = Solid> {
        let interval = || (-3i64..3, 1i64..4).prop_map(|(a, d)| [z(a), z(a + d)]);
        let corner = || (-3i64..4, -3i64..4, -3i64..4).prop_map(|(a, b, c)| [a, b, c].map(z));
        prop_oneof![
            (interval(), interval(), interval()).prop_map(|(a, b, c)| Solid::Box([a, b, c])),
            [corner(), corner(), corner(), corner()]
                .prop_map(Solid::Tetrahedron)
                .prop_filter("flat", Solid::is_proper),
        ]
    }

    fn at(f: &MultiPoly, point: &[Rational; 3]) -> Rational {
        let names = unknowns();
        f.value(&|s| names.iter().position(|x| x == s).map(|k| point[k].clone())).as_constant().unwrap()
    }

    /// The coefficients are those of F over the part, at a point.
    fn checks(part: &SolidPart, f: &MultiPoly, shares: [i64; 3]) -> bool {
        match &part.solid {
            Solid::Box(ends) => {
                let t: [Rational; 3] = shares.map(|k| rational(k, 7));
                let point = std::array::from_fn(|k| &ends[k][0] + (&ends[k][1] - &ends[k][0]) * &t[k]);
                let degrees: [usize; 3] = std::array::from_fn(|k| {
                    part.coefficients.iter().map(|(index, _)| index[k]).max().unwrap()
                });
                let sum = part.coefficients.iter().fold(z(0), |sum, (index, c)| {
                    sum + (0..3).fold(c.clone(), |product, k| {
                        let (n, i) = (degrees[k], index[k]);
                        product
                            * Rational::from_integer(binomial(n, i))
                            * t[k].powered(i as u32)
                            * (z(1) - &t[k]).powered((n - i) as u32)
                    })
                });
                sum == at(f, &point)
            }
            Solid::Tetrahedron(corners) => {
                let whole = rational(1, 1 + shares.iter().sum::<i64>());
                let weights: Vec<Rational> =
                    [1, shares[0], shares[1], shares[2]].map(|k| z(k) * &whole).to_vec();
                let point =
                    std::array::from_fn(|k| (0..4).fold(z(0), |sum, i| sum + &corners[i][k] * &weights[i]));
                let sum = part.coefficients.iter().fold(z(0), |sum, (index, c)| {
                    let scale = Rational::from_integer(multinomial(index));
                    sum + index
                        .iter()
                        .zip(&weights)
                        .fold(c * scale, |product, (e, w)| product * w.powered(*e as u32))
                });
                sum == at(f, &point)
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        /// Certificates check, counterexamples are some, and no value of a grid contradicts.
        #[test]
        fn answers_are_right(f in polynomial(), p in polynomial(), kind in 0..3, solid in solid(), shares in [0i64..8, 0i64..8, 0i64..8]) {
            let f = match kind {
                0 => f,
                1 => f.clone() * f,
                _ => f.clone() * f + MultiPoly::constant(z(1)) + p.scaled(&rational(1, 100)),
            };
            let corners = solid.corners();
            let count = corners.len() as i64;
            let inside = |weights: [i64; 3]| -> [Rational; 3] {
                // Towards a corner from the centre.
                std::array::from_fn(|k| {
                    let centre = corners.iter().fold(z(0), |sum, p| sum + &p[k]) / z(count);
                    let corner = &corners[weights[0] as usize % corners.len()][k];
                    &centre + (corner - &centre) * rational(weights[1], 7)
                })
            };
            match positivity_in(&f, &unknowns(), &solid) {
                Ok(shown) => {
                    prop_assert!(!at(&f, &inside(shares)).is_negative());
                    prop_assert_eq!(shown.root_of_square.pow(2) * shown.rest.clone(), f);
                    if let SolidShown::Coefficients(parts) = &shown.shown {
                        prop_assert!(parts.iter().all(|part| checks(part, &shown.rest, shares)));
                        prop_assert!(parts.iter().all(|part| part.coefficients.iter().all(|(_, c)| !c.is_negative())));
                    }
                }
                Err(SolidFailure::Negative(point)) => {
                    prop_assert!(at(&f, &point).is_negative());
                    for side in solid.sides(&unknowns()) {
                        prop_assert!(!at(&side, &point).is_negative());
                    }
                }
                Err(SolidFailure::Open(_)) => {}
            }
        }
    }

    #[test]
    fn zeros_inside_are_no_obstacle() {
        let [u, v, w] = unknowns().map(MultiPoly::symbol);
        let cube = Solid::Box([(); 3].map(|_| [-z(1), z(2)]));
        // A minimum 0 at (1/3, 1/3, 1/3) that no halving meets, but no square.
        let third = MultiPoly::constant(rational(1, 3));
        let f = (u.clone() - third.clone()).pow(2)
            + (v.clone() - third.clone()).pow(2)
            + (w.clone() - third).pow(2);
        let shown = positivity_in(&f, &unknowns(), &cube).unwrap().shown;
        assert!(matches!(shown, SolidShown::CriticalPoints(zeros) if zeros.len() == 1));
        let lower = f - MultiPoly::constant(rational(1, 1_000_000));
        assert!(matches!(positivity_in(&lower, &unknowns(), &cube), Err(SolidFailure::Negative(_))));
    }
}
