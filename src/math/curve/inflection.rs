//! Where the curvature of a plane curve changes its sign.
//!
//! Of a curve (X/W, Y/W) the curvature has the sign of D/W³ with D = det((X, Y, W), (X', Y', W'), (X'', Y'', W'')), which is
//! det(c', c'') for W = 1. So it changes at the roots of odd multiplicity of D that are no roots of W. Of pieces one after the
//! other it may also change where two of them meet.
//!
//! W. Boehm, H. Prautzsch, "Geometric Concepts for Geometric Design", A K Peters 1994, chapter 3.

use num_traits::{Signed, Zero};

use super::PlaneCurve;
use crate::math::number::Rational;
use crate::math::poly::{Poly, RealRoot};

/// The sign with which a polynomial starts behind a number, or ends before it; 0 for the polynomial 0.
fn sign_beside(f: &Poly, at: &Rational, before: bool) -> i8 {
    let mut derivative = f.clone();
    let mut turned = false;
    while !derivative.is_zero() {
        let value = derivative.value(at);
        if !value.is_zero() {
            return if value.is_negative() != (turned && before) { -1 } else { 1 };
        }
        derivative = derivative.derivative();
        turned = !turned;
    }
    0
}

/// A part of a curve that is straight, so that its curvature has no sign: its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Straight(pub usize);

/// The parameters at which the curvature changes its sign, of one curve or of pieces one after the other, increasing and
/// strictly inside of the whole interval.
///
/// Cost for degree n: the real roots of a polynomial of degree 2 n − 4, or 3 n − 6 for rational curves, for each piece.
///
/// # Errors
/// [`Straight`] names the first piece that is straight.
///
/// ```
/// use polarform::curve::{PlaneCurve, inflections};
/// use polarform::poly::Poly;
/// let t = Poly::variable();
/// let cubic = PlaneCurve::new([t.clone(), t.pow(3) - &t, Poly::one()], (None, None)).unwrap();
/// assert_eq!(inflections(&[cubic]).unwrap()[0].to_string(), "0");
/// ```
pub fn inflections(pieces: &[PlaneCurve]) -> Result<Vec<RealRoot>, Straight> {
    let mut found = Vec::new();
    let mut last: Option<(i8, Rational)> = None;
    for (i, piece) in pieces.iter().enumerate() {
        let [x, y, w] = piece.coordinates();
        let rows = [0, 1, 2].map(|k| [x, y, w].map(|f| f.nth_derivative(k)));
        let minor = |i: usize, j: usize| &rows[1][i] * &rows[2][j] - &rows[1][j] * &rows[2][i];
        let turn = &rows[0][0] * minor(1, 2) - &rows[0][1] * minor(0, 2) + &rows[0][2] * minor(0, 1);
        let (lower, upper) = piece.range();
        let roots = turn.real_roots(lower.as_ref(), upper.as_ref()).ok_or(Straight(i))?;
        let signed = &turn * w;
        if let (Some((before, end)), Some(start)) = (&last, lower)
            && end == start
            && *before != sign_beside(&signed, start, false)
        {
            found.push(RealRoot::Rational(start.clone()));
        }
        let ends = [lower, upper].map(|end| end.clone().map(RealRoot::Rational));
        let inside = |t: &RealRoot| !ends.iter().any(|end| end.as_ref() == Some(t)) && !t.sign_of(w).is_eq();
        found.extend(roots.into_iter().filter(|(t, m)| m % 2 == 1 && inside(t)).map(|(t, _)| t));
        last = upper.as_ref().map(|end| (sign_beside(&signed, end, true), end.clone()));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, rational as q};
    use proptest::prelude::*;

    fn poly(list: &[i64]) -> Poly {
        list.iter().map(|&k| z(k)).collect()
    }

    /// The sign of the turn of three points near a parameter.
    fn turn(curve: &[Poly; 3], t: &Rational) -> i8 {
        let h = q(1, 1 << 20);
        let point = |s: &Rational| {
            let w = curve[2].value(s);
            [curve[0].value(s) / &w, curve[1].value(s) / &w]
        };
        let [a, b, c] = [t - &h, t.clone(), t + &h].map(|s| point(&s));
        let area = (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]);
        if area.is_zero() {
            0
        } else if area.is_negative() {
            -1
        } else {
            1
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Between two neighbouring inflections three near points turn to one side, beyond an inflection to the other.
        #[test]
        fn points_turn_the_other_way(
            x in prop::collection::vec(-5i64..6, 2..5), y in prop::collection::vec(-5i64..6, 3..5),
            w in prop::collection::vec(-3i64..4, 2), cut in 1i64..4,
        ) {
            let weight = Poly::from(7) + poly(&w).pow(2);
            let curve = [poly(&x), poly(&y), weight];
            let part = |a: Rational, b: Rational| PlaneCurve::new(curve.clone(), (Some(a), Some(b))).unwrap();
            let pieces = [part(z(-2), q(cut, 4)), part(q(cut, 4), z(2))];
            let Ok(found) = inflections(&pieces) else { return Ok(()) };
            prop_assert_eq!(&Ok(found.clone()), &inflections(&[part(z(-2), z(2))]));
            let mut sides = Vec::new();
            for k in 0..=400 {
                let t = z(-2) + q(k, 100) + q(1, 997);
                let rank = found.iter().filter(|root| **root < RealRoot::Rational(t.clone())).count();
                let near = |root: &&RealRoot| {
                    let distance = [&t - q(1, 200), &t + q(1, 200)].map(RealRoot::Rational);
                    **root > distance[0] && **root < distance[1]
                };
                let side = turn(&curve, &t);
                if found.iter().find(near).is_none() && t < z(2) && side != 0 {
                    sides.push((rank, side));
                }
            }
            for pair in sides.windows(2) {
                // Near numbers may lie between two samples.
                let apart = (pair[1].0 - pair[0].0) % 2 == 1;
                prop_assert_eq!(pair[0].1 != pair[1].1, apart, "{:?} {:?}", pair, found);
            }
        }
    }

    #[test]
    fn pieces_that_turn_apart_meet_in_an_inflection() {
        let part = |list: &[i64], a: i64, b: i64| {
            PlaneCurve::new([poly(&[0, 1]), poly(list), Poly::one()], (Some(z(a)), Some(z(b)))).unwrap()
        };
        let found = inflections(&[part(&[0, 0, 1], -1, 0), part(&[0, 0, -1], 0, 1)]).unwrap();
        assert_eq!(found, [RealRoot::Rational(z(0))]);
        assert_eq!(inflections(&[part(&[0, 0, 1], -1, 0), part(&[0, 0, 3], 0, 1)]).unwrap(), []);
        assert_eq!(inflections(&[part(&[0, 0, 1], -1, 0), part(&[0], 0, 1)]), Err(Straight(1)));
        // An end of the whole is none.
        assert_eq!(inflections(&[part(&[0, 0, 0, 1], 0, 1)]).unwrap(), []);
    }
}
