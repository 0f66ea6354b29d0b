//! Circles, exactly: arcs and full circles with rational weights.
//!
//! Write the plane as complex numbers, a circle with centre m, and a = (a point of it) − m. For
//! every complex polynomial z(s) the curve m + a z(s)²/|z(s)|² is a piece of the circle, rational
//! of twice the degree of z, with weights from |z|²; all else here is a choice of z.
//!
//! - z = (1 − s) + s η is an arc over the angle 2 arg η. With η = 1 + ζ, where ζ = e^{iθ} turns the
//!   first end into the last, it has angle θ and weights 1, Re η, |η|². They are rational whenever
//!   the ends are: a quarter has weights 1, 1, 2.
//! - Equal end weights 1, cos(θ/2), 1 need the square root of (1 + cos θ)/2.
//! - z = ((1 − s) + s i)² is the full circle, with weights 1, 0, 1/3, 0, 1; of degree 5 all become
//!   positive: 1, 1/5, 1/5, 1/5, 1/5, 1.
//!
//! References: J. J. Chou, "Higher order Bézier circles", CAD 27 (1995); L. Piegl, W. Tiller, *The
//! NURBS Book* (1997), chapter 7.

use super::domain::determinant;
use super::rational::RationalCurve;
use super::{BezierCurve, CurveError, Interval, Point, dimension};
use crate::math::number::{integer, rational};
use crate::math::ring::{Field, Ring};

/// A complex number: its real and imaginary part.
type Complex<C> = [C; 2];

/// (x + i y)(u + i v)
fn product<C: Ring>([x, y]: &Complex<C>, [u, v]: &Complex<C>) -> Complex<C> {
    [x.times(u).minus(&y.times(v)), x.times(v).plus(&y.times(u))]
}

fn complex<C: Ring>(x: i64, y: i64) -> Complex<C> {
    [x, y].map(|x| C::from_rational(&integer(x)))
}

fn as_complex<C: Clone>(v: &[C]) -> Complex<C> {
    [v[0].clone(), v[1].clone()]
}

/// Re(ȳ z)
fn inner<C: Ring>(y: &Complex<C>, z: &Complex<C>) -> C {
    y[0].times(&z[0]).plus(&y[1].times(&z[1]))
}

/// The curve over [start, start + 1] with control vectors (w m + a z, w).
fn turned<C: Field>(
    centre: &[C],
    arm: &Complex<C>,
    controls: impl IntoIterator<Item = (Complex<C>, C)>,
    start: i64,
) -> RationalCurve<C> {
    let vector = |(z, weight): (Complex<C>, C)| -> Point<C> {
        let moved = product(arm, &z);
        let place = |k: usize| centre[k].times(&weight).plus(&moved[k]);
        [place(0), place(1), weight].into()
    };
    let [a, b] = [start, start + 1].map(|x| C::from_rational(&integer(x)));
    let interval = Interval::new(a, b).expect("an interval of length 1");
    let curve = BezierCurve::new(controls.into_iter().map(vector).collect(), interval);
    RationalCurve::from_homogeneous(curve.expect("a few vectors of length 3"))
        .expect("vectors of length 3 have a weight")
}

/// z² and |z|² for z = (1 − s) + s η, by their Bézier points.
fn arc_controls<C: Ring>(eta: &Complex<C>) -> [(Complex<C>, C); 3] {
    [(complex(1, 0), C::one()), (eta.clone(), eta[0].clone()), (product(eta, eta), inner(eta, eta))]
}

/// A point of the plane and one of the circle around it.
fn check_plane<C: Field>(points: &[Point<C>]) -> Result<(), CurveError> {
    match dimension(points)? {
        2 => Ok(()),
        left => Err(CurveError::DimensionsOf { left, right: 2 }),
    }
}

/// The arc of a circle between two of its points. Centre and ends have coordinates in the field;
/// the radius need not.
///
/// ```
/// use polarform::curve::{CircleArc, CurveError};
/// use polarform::number::{integer as z, rational as q};
/// let [m, p, r] = [[0, 0], [1, 0], [0, 1]].map(|p| p.map(z));
/// let quarter = CircleArc::new(m.clone(), p.clone(), r)?;
/// assert_eq!(quarter.rational().weights(), [1, 1, 2].map(z));
/// // equal end weights would need w = √(1/2)
/// assert_eq!(quarter.squared_weight(), q(1, 2));
/// assert!(matches!(quarter.standard(), Err(CurveError::Irrational { .. })));
/// // over an angle with rational cosine of its half they do not
/// let arc = CircleArc::new(m, p, [q(7, 25), q(24, 25)])?;
/// assert_eq!(arc.standard()?.weights(), [z(1), q(4, 5), z(1)]);
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct CircleArc<C> {
    centre: Point<C>,
    /// The first end, from the centre.
    arm: Complex<C>,
    /// cos θ and sin θ of the angle from the first end to the last.
    turn: Complex<C>,
    /// Whether it goes the long way round, or clockwise over half the circle.
    long: bool,
}

debug_by_fields!(CircleArc: centre, arm, turn, long);

impl<C: Field> CircleArc<C> {
    /// The shorter arc between two points of a circle; over half of the circle the one that goes
    /// counter-clockwise.
    ///
    /// # Errors
    /// [`CurveError::Dimensions`], [`CurveError::DimensionsOf`] unless in the plane,
    /// [`CurveError::Degenerate`] if the ends are equal or the radius is 0,
    /// [`CurveError::Impossible`] if the ends have different distances from the centre.
    pub fn new(
        centre: impl Into<Point<C>>,
        from: impl Into<Point<C>>,
        to: impl Into<Point<C>>,
    ) -> Result<Self, CurveError> {
        let points = [centre.into(), from.into(), to.into()];
        check_plane(&points)?;
        let [centre, from, to] = points;
        let [a, b] = [&from, &to].map(|end| as_complex(&(end - &centre)));
        let squared = inner(&a, &a);
        if from == to {
            return Err(CurveError::Degenerate);
        }
        if squared != inner(&b, &b) {
            let why = "the ends of the arc have different distances from the centre";
            return Err(CurveError::Impossible { why });
        }
        let inverse = squared.inverse().ok_or(CurveError::Degenerate)?;
        let turn = [inner(&a, &b).times(&inverse), determinant(&a, &b).times(&inverse)];
        Ok(CircleArc { centre, arm: a, turn, long: false })
    }

    /// The rest of the circle, from the same first end to the same last end.
    pub fn complement(&self) -> Self {
        CircleArc { long: !self.long, ..self.clone() }
    }

    /// cos²(θ/2) = (1 + cos θ)/2: the square of the middle weight of the standard form, which is
    /// rational iff this is the square of a rational number. It is positive on the shorter arc,
    /// negative on the longer one.
    pub fn squared_weight(&self) -> C {
        C::one().plus(&self.turn[0]).scaled(&rational(1, 2))
    }

    /// 1 + ζ
    fn half_turn(&self) -> Complex<C> {
        [C::one().plus(&self.turn[0]), self.turn[1].clone()]
    }

    /// The arc over [0, 1] as a rational quadratic curve with weights 1, 1 + cos θ, 2 + 2 cos θ, the
    /// second with a minus for the longer arc; 1, 0, 1 for half of the circle.
    pub fn rational(&self) -> RationalCurve<C> {
        let half = self.half_turn();
        // for ζ = −1 there is no shorter way: over i
        let eta = if half[0].is_zero() { complex(0, 1) } else { half };
        let eta = if self.long { eta.map(|x| -x) } else { eta };
        turned(&self.centre, &self.arm, arc_controls(&eta), 0)
    }

    /// The arc over [0, 1] with weights 1, w, 1, where w = cos(θ/2), with a minus for the longer
    /// arc.
    ///
    /// # Errors
    /// [`CurveError::Irrational`] if w is not rational; then w is the positive root (or for the
    /// longer arc the negative one) of w² = [`CircleArc::squared_weight`], and
    /// [`CircleArc::rational`] is the same arc without roots.
    pub fn standard(&self) -> Result<RationalCurve<C>, CurveError> {
        let what = "the weight cos(θ/2) of the arc with equal end weights";
        self.rational().standard_form().map_err(|_| CurveError::Irrational { what })
    }
}

/// The vector from the centre to a point of the circle.
fn arm<C: Field>(centre: &[C], start: &[C]) -> Result<Complex<C>, CurveError> {
    let [centre, start] = [centre, start].map(Point::from);
    check_plane(&[centre.clone(), start.clone()])?;
    let arm = as_complex(&(&start - &centre));
    if inner(&arm, &arm).is_zero() { Err(CurveError::Degenerate) } else { Ok(arm) }
}

/// The circle through `start` in pieces, the k-th over [k, k + 1], counter-clockwise; each by its
/// η, with a given first factor for the arm.
fn pieces<C: Field>(
    centre: &[C],
    start: &[C],
    steps: &[(Complex<C>, Complex<C>)],
) -> Result<Vec<RationalCurve<C>>, CurveError> {
    let arm = arm(centre, start)?;
    let piece = |((turn, eta), k): (&(Complex<C>, Complex<C>), i64)| {
        turned(centre, &product(&arm, turn), arc_controls(eta), k)
    };
    Ok(steps.iter().zip(0..).map(piece).collect())
}

/// The circle as four quarters with weights 1, 1, 2 over [0, 1], …, [3, 4], counter-clockwise.
///
/// # Errors
/// [`CurveError::Degenerate`] if the start is the centre, [`CurveError::Dimensions`],
/// [`CurveError::DimensionsOf`] unless in the plane.
pub fn circle_quarters<C: Field>(centre: &[C], start: &[C]) -> Result<Vec<RationalCurve<C>>, CurveError> {
    let turns = [complex(1, 0), complex(0, 1), complex(-1, 0), complex(0, -1)];
    pieces(centre, start, &turns.map(|turn| (turn, complex(1, 1))))
}

/// The circle as three pieces in standard form, with weights 1, 3/5, 1 twice and then 1, 7/25, 1,
/// over [0, 1], [1, 2], [2, 3], counter-clockwise.
///
/// Three equal pieces have weights 1, 1/2, 1, but their ends need √3. Here the half angle φ has
/// cos φ = 3/5, sin φ = 4/5, and the last one is π − 2φ.
///
/// # Errors
/// As for [`circle_quarters`].
pub fn circle_thirds<C: Field>(centre: &[C], start: &[C]) -> Result<Vec<RationalCurve<C>>, CurveError> {
    let fraction = |x: i64, y: i64, n: i64| [x, y].map(|x| C::from_rational(&rational(x, n)));
    let half = fraction(3, 4, 5);
    let turn = product(&half, &half);
    let twice = product(&turn, &turn);
    let steps = [(complex(1, 0), half.clone()), (turn, half), (twice, fraction(7, 24, 25))];
    pieces(centre, start, &steps)
}

/// The full circle over [0, 1] as one curve of degree 4, counter-clockwise from `start`, with
/// weights 1, 0, 1/3, 0, 1: its second and fourth control vectors are directions.
///
/// It is m + a z⁴/|z|⁴ with z = (1 − s) + s i, whose fourth power has the Bézier points i^k.
///
/// # Errors
/// As for [`circle_quarters`].
pub fn full_circle<C: Field>(centre: &[C], start: &[C]) -> Result<RationalCurve<C>, CurveError> {
    let arm = arm(centre, start)?;
    let third = C::from_rational(&rational(1, 3));
    let weights = [C::one(), C::zero(), third, C::zero(), C::one()];
    let powers = [complex(1, 0), complex(0, 1), complex(-1, 0), complex(0, -1), complex(1, 0)];
    Ok(turned(centre, &arm, powers.into_iter().zip(weights), 0))
}

/// The full circle over [0, 1] as one curve of degree 5 with the positive weights
/// 1, 1/5, 1/5, 1/5, 1/5, 1, counter-clockwise from `start`: [`full_circle`] with the degree raised.
///
/// # Errors
/// As for [`circle_quarters`].
///
/// ```
/// use polarform::curve::circle_quintic;
/// use polarform::number::{integer as z, rational as q};
/// let circle = circle_quintic(&[z(0), z(0)], &[z(1), z(0)])?;
/// assert_eq!(circle.points()[1], Some([z(1), z(4)].into()));
/// assert_eq!(circle.points()[2], Some([z(-3), z(2)].into()));
/// assert_eq!(circle.value(&q(1, 2))?, [z(-1), z(0)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn circle_quintic<C: Field>(centre: &[C], start: &[C]) -> Result<RationalCurve<C>, CurveError> {
    Ok(full_circle(centre, start)?.elevate(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::conic::{ConicKind, ImplicitConic, conic_kind};
    use crate::math::curve::polygon;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use num_traits::Signed;
    use proptest::prelude::*;

    /// Whether x² + y² = r² w² as polynomials, with x and y from the centre: |x − m w|² − r² w².
    fn on_circle(curve: &RationalCurve<Rational>, centre: &[Rational], squared: &Rational) -> bool {
        let line = |k: usize| -> Vec<Rational> {
            curve
                .homogeneous()
                .points()
                .iter()
                .map(|h| if k < 2 { &h[k] - &centre[k] * &h[2] } else { h[2].clone() })
                .collect()
        };
        let square = |k: usize| polygon::product(&[line(k)], &[line(k)]).swap_remove(0);
        let (x, y, w) = (square(0), square(1), square(2));
        (0..w.len()).all(|i| &x[i] + &y[i] == squared * &w[i])
    }

    /// A rational point of the unit circle, by its stereographic parameter.
    fn unit(t: &Rational) -> Complex<Rational> {
        let w = z(1) + t * t;
        [(z(1) - t * t) / &w, z(2) * t / w]
    }

    proptest! {
        #[test]
        fn arcs(m in (-5i64..6, -5i64..6), arm in (-5i64..6, 1i64..6), t in (-9i64..10, 1i64..5), s in (1i64..8, 8i64..9)) {
            let centre = Point::from([z(m.0), z(m.1)]);
            let a = [z(arm.0), z(arm.1)];
            let end = |zeta: &Complex<Rational>| &centre + &product(&a, zeta).into();
            let zeta = unit(&q(t.0, t.1));
            let (from, to) = (end(&complex(1, 0)), end(&zeta));
            let made = CircleArc::new(centre.clone(), from.clone(), to.clone());
            if from == to {
                prop_assert_eq!(made, Err(CurveError::Degenerate));
                return Ok(());
            }
            let short = made.unwrap();
            let squared = inner(&short.arm, &short.arm);
            for arc in [short.clone(), short.complement()] {
                let curve = arc.rational();
                prop_assert!(on_circle(&curve, &centre, &squared));
                prop_assert_eq!(&curve.value(&z(0)).unwrap(), &from);
                prop_assert_eq!(&curve.value(&z(1)).unwrap(), &to);
                prop_assert_eq!(conic_kind(&curve), Ok(Some(ConicKind::Ellipse)));
                let conic = ImplicitConic::new(&curve).unwrap();
                prop_assert_eq!(conic.centre(), Some(centre.clone()));
                let weights = curve.weights();
                prop_assert_eq!(&weights[1] * &weights[1], arc.squared_weight() * &weights[0] * &weights[2]);
                // the ends come from half angles here, t = tan(θ/2), with cos(θ/2) = 1/√(1 + t²)
                match arc.standard() {
                    Ok(standard) => {
                        prop_assert_eq!(&standard.weights()[0], &standard.weights()[2]);
                        prop_assert!(on_circle(&standard, &centre, &squared));
                        let positive = standard.weights()[1].is_positive();
                        prop_assert!(arc.squared_weight() == z(0) || positive != arc.long);
                    }
                    Err(_) => prop_assert!(crate::math::number::exact_root(&arc.squared_weight(), 2).is_none()),
                }
            }
            // between the ends the shorter arc lies on the side of the point where its tangents meet
            let at = q(s.0, s.1);
            let point = short.rational().value(&at).unwrap();
            let chord = &to - &from;
            let side = |p: &Point<Rational>| determinant(&chord, &(p - &from)).signum();
            if let Some(apex) = short.rational().points().swap_remove(1) {
                prop_assert_eq!(side(&point), side(&apex));
            }
            let around = if short.turn[1].is_negative() { short.complement() } else { short };
            let tangent = around.rational().derivatives(&at, 1).unwrap();
            prop_assert!(determinant(&(tangent[0].clone() - &centre.position()), &tangent[1]).is_positive());
        }

        #[test]
        fn full_circles(m in (-5i64..6, -5i64..6), arm in (-5i64..6, 1i64..6), s in 0i64..9) {
            let centre = Point::from([z(m.0), z(m.1)]);
            let start = vec![z(m.0 + arm.0), z(m.1 + arm.1)];
            let squared = z(arm.0 * arm.0 + arm.1 * arm.1);
            let quintic = circle_quintic(&centre, &start).unwrap();
            prop_assert_eq!(quintic.weights(), [z(1), q(1, 5), q(1, 5), q(1, 5), q(1, 5), z(1)]);
            prop_assert!(on_circle(&quintic, &centre, &squared));
            let quarters = circle_quarters(&centre, &start).unwrap();
            let thirds = circle_thirds(&centre, &start).unwrap();
            for list in [&quarters, &thirds] {
                let ends = list.iter().zip(list.iter().cycle().skip(1));
                for (piece, next) in ends {
                    prop_assert!(on_circle(piece, &centre, &squared));
                    let (_, end) = piece.interval().ends();
                    prop_assert_eq!(piece.value(end), next.value(next.interval().start()));
                }
            }
            prop_assert_eq!(thirds[2].standard_form().unwrap().weights(), [z(1), q(7, 25), z(1)]);
            // the quintic at s is in the quarter that holds the angle, here checked by its tangent
            let jet = quintic.derivatives(&q(s, 8), 1).unwrap();
            prop_assert!(determinant(&(jet[0].clone() - &centre.position()), &jet[1]).is_positive());
            prop_assert_eq!(quintic.value(&q(1, 2)).unwrap(), quarters[1].value(&z(2)).unwrap());
        }
    }

    #[test]
    fn the_quintic_from_its_definition() {
        // ((1 − s) + s i)^4 and |…|^4 by multiplying Bézier points, then one step of elevation
        let [re, im] = [[1, 0], [0, 1]].map(|c| vec![c.map(z).to_vec()]);
        let add = |f: &[Vec<Rational>], g: &[Vec<Rational>], sign: i64| -> Vec<Vec<Rational>> {
            vec![f[0].iter().zip(&g[0]).map(|(x, y)| x + y * z(sign)).collect()]
        };
        let square = |re: &Vec<Vec<Rational>>, im: &Vec<Vec<Rational>>| {
            let mixed = polygon::product(re, im);
            (add(&polygon::product(re, re), &polygon::product(im, im), -1), add(&mixed, &mixed, 1))
        };
        let (re2, im2) = square(&re, &im);
        let (re4, im4) = square(&re2, &im2);
        let norm = add(&polygon::product(&re, &re), &polygon::product(&im, &im), 1);
        let weight = polygon::product(&norm, &norm);
        let circle = full_circle(&[z(0), z(0)], &[z(1), z(0)]).unwrap();
        for (i, h) in circle.homogeneous().points().iter().enumerate() {
            assert_eq!(h, &[re4[0][i].clone(), im4[0][i].clone(), weight[0][i].clone()]);
        }
        let points: Vec<_> = circle.elevate(1).points().into_iter().map(Option::unwrap).collect();
        assert_eq!(points, [[1, 0], [1, 4], [-3, 2], [-3, -2], [1, -4], [1, 0]].map(|p| p.map(z).to_vec()));
    }

    #[test]
    fn a_half_circle_and_bad_input() {
        let p = |x, y| Point::from([z(x), z(y)]);
        let half = CircleArc::new(p(0, 0), p(1, 0), p(-1, 0)).unwrap();
        assert_eq!(half.rational().points()[1], None);
        assert_eq!(half.rational().value(&q(1, 2)), Ok(p(0, 1)));
        assert_eq!(half.complement().rational().value(&q(1, 2)), Ok(p(0, -1)));
        assert_eq!(half.standard().unwrap(), half.rational());
        let new = |m, a, b| CircleArc::new(m, a, b).unwrap_err();
        assert!(matches!(new(p(0, 0), p(1, 0), p(2, 0)), CurveError::Impossible { .. }));
        assert_eq!(new(p(0, 0), p(0, 0), p(0, 0)), CurveError::Degenerate);
        assert_eq!(
            new(p(0, 0), p(1, 0), [z(1)].into()),
            CurveError::Dimensions { index: 2, found: 1, expected: 2 }
        );
        assert_eq!(circle_quintic(&p(1, 1), &p(1, 1)), Err(CurveError::Degenerate));
        assert_eq!(circle_quarters(&[z(1)], &[z(0)]), Err(CurveError::DimensionsOf { left: 1, right: 2 }));
    }

    #[test]
    fn a_symbolic_radius() {
        let name = |s: &str| Fraction::from(MultiPoly::symbol(Symbol::new(s)));
        let zero = Fraction::from(z(0));
        let r = name("r");
        let centre = Point::from([name("x"), name("y")]);
        let from = vec![name("x") + r.clone(), name("y")];
        let to = vec![name("x"), name("y") + r.clone()];
        let arc = CircleArc::new(centre.clone(), from, to).unwrap();
        assert_eq!(arc.squared_weight(), Fraction::from(q(1, 2)));
        let point = arc.rational().value(&name("t")).unwrap();
        let v = &point - &centre;
        assert_eq!(v[0].clone() * v[0].clone() + v[1].clone() * v[1].clone() - r.clone() * r, zero);
    }
}
