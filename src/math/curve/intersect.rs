//! Where plane curves meet: each other, a curve given by an equation, and themselves.
//!
//! Let (X/W, Y/W) and (X*/W*, Y*/W*) be the curves. They meet for the parameters s and t with X(s) W*(t) = X*(t) W(s) and
//! Y(s) W*(t) = Y*(t) W(s). A curve meets F(x, y) = 0 where F(X/W, Y/W) = 0. A double point belongs to a pair s ≠ t
//! with X(s) W(t) − X(t) W(s) = 0 and the same for Y; both are divided by s − t. All these parameters are real numbers in
//! isolating intervals, found by [`common_zeros`].
//!
//! T. W. Sederberg, "Planar piecewise algebraic curves", CAGD 1 (1984); R. N. Goldman, T. W. Sederberg, D. C. Anderson,
//! "Vector elimination", CAGD 1 (1984).

use super::SpaceCurve;
use crate::math::number::Rational;
use crate::math::poly::{MultiPoly, Poly, RealRoot, Symbol};
use crate::math::system::{Bounds, SystemError, common_zeros, image};

/// A curve of the plane by homogeneous coordinates, polynomials of the parameter over an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneCurve {
    coordinates: [Poly; 3],
    range: Bounds,
}

/// A pair of parameters that belong to one point.
#[derive(Clone, Debug, PartialEq)]
pub struct Meeting {
    /// The parameters of the first and of the second curve.
    pub parameters: [RealRoot; 2],
    /// The degree of the polynomial of which the first parameter is a root, 1 for a rational number.
    pub degree: usize,
}

/// The degree of the polynomial that is kept of a number.
fn degree_of(root: &RealRoot) -> usize {
    match root {
        RealRoot::Rational(_) => 1,
        RealRoot::Irrational(number) => number.polynomial().degree().unwrap_or(0),
    }
}

/// A polynomial of a parameter.
fn of(f: &Poly, t: &Symbol) -> MultiPoly {
    f.value_in(&MultiPoly::symbol(t.clone()))
}

impl PlaneCurve {
    /// The curve (X/W, Y/W) for parameters within bounds; `None` if W = 0.
    pub fn new([x, y, w]: [Poly; 3], range: Bounds) -> Option<Self> {
        let common = x.gcd(&y).gcd(&w);
        let reduced = [x, y, w].map(|f| f.div_exact(&common));
        let [Some(x), Some(y), Some(w)] = reduced else { return None };
        (!w.is_zero()).then_some(PlaneCurve { coordinates: [x, y, w], range })
    }

    /// X, Y and W, without a common factor.
    pub fn coordinates(&self) -> &[Poly; 3] {
        &self.coordinates
    }

    /// Where the parameter runs; an end that is `None` is none.
    pub fn range(&self) -> &Bounds {
        &self.range
    }

    /// The point of a parameter, of which W is not 0. Cost: [`image`], twice.
    pub fn point(&self, t: &RealRoot) -> [RealRoot; 2] {
        let [x, y, w] = &self.coordinates;
        [image(t, x, w), image(t, y, w)]
    }

    /// Where this curve meets another one, by increasing parameters.
    ///
    /// Cost for degrees m and n: that of [`common_zeros`] for two polynomials of degree m in s and n in t.
    ///
    /// # Errors
    /// [`SystemError::Infinite`] if both are parts of one curve, or one is a point of the other.
    ///
    /// ```
    /// use polarform::curve::PlaneCurve;
    /// use polarform::number::integer;
    /// use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let parabola = PlaneCurve::new([t.clone(), t.pow(2), Poly::one()], (None, None)).unwrap();
    /// let line = PlaneCurve::new([t.clone(), Poly::from(2), Poly::one()], (Some(integer(0)), None)).unwrap();
    /// let found = parabola.meetings(&line)?;
    /// assert_eq!(found.len(), 1);
    /// assert_eq!(found[0].parameters[0].to_string(), "t^2 - 2 in (1, 2)");
    /// # Ok::<(), polarform::system::SystemError>(())
    /// ```
    pub fn meetings(&self, other: &PlaneCurve) -> Result<Vec<Meeting>, SystemError> {
        let unknowns = ["s", "t"].map(Symbol::new);
        let [x, y, w] = self.coordinates.each_ref().map(|f| of(f, &unknowns[0]));
        let [x2, y2, w2] = other.coordinates.each_ref().map(|f| of(f, &unknowns[1]));
        let p = x * w2.clone() - x2 * w.clone();
        let q = y * w2 - y2 * w;
        let zeros = common_zeros(&p, &q, &unknowns, &[self.range.clone(), other.range.clone()])?;
        // W(s) = W*(t) = 0 solves both equations, too, at infinity.
        let finite = |pair: &[RealRoot; 2]| !pair[0].sign_of(&self.coordinates[2]).is_eq();
        let pairs = zeros.into_iter().filter_map(|zero| <[RealRoot; 2]>::try_from(zero.coordinates).ok());
        Ok(pairs.filter(finite).map(Meeting::new).collect())
    }

    /// The parameters at which the curve lies on F(x, y) = 0, increasing; `None` if it lies there everywhere.
    ///
    /// Cost: F of polynomials, and the real roots of one of degree n deg F.
    ///
    /// ```
    /// use polarform::curve::PlaneCurve;
    /// use polarform::number::integer;
    /// use polarform::poly::{MultiPoly, Poly, Symbol};
    /// let t = Poly::variable();
    /// let line = PlaneCurve::new([t.clone(), t.clone(), Poly::one()], (None, None)).unwrap();
    /// let symbols = ["x", "y"].map(Symbol::new);
    /// let [x, y] = symbols.clone().map(MultiPoly::symbol);
    /// let circle = x.pow(2) + y.pow(2) - MultiPoly::constant(integer(8));
    /// let found = line.on(&circle, &symbols).unwrap();
    /// assert_eq!(found.iter().map(|t| t.to_string()).collect::<Vec<_>>(), ["-2", "2"]);
    /// ```
    ///
    /// # Panics
    /// If F has other symbols.
    pub fn on(&self, equation: &MultiPoly, symbols: &[Symbol; 2]) -> Option<Vec<RealRoot>> {
        SpaceCurve::new(self.coordinates.to_vec(), self.range.clone())?.on(equation, symbols)
    }

    /// The pairs of real parameters s ≤ t that belong to one point, in increasing order: crossings, and cusps with s = t. Double
    /// points with complex parameters are not among them.
    ///
    /// Cost for degree n: that of [`common_zeros`] for degrees n − 1 in both unknowns.
    ///
    /// # Errors
    /// [`SystemError::Infinite`] if the curve is run through several times, or is a point.
    ///
    /// ```
    /// use polarform::curve::PlaneCurve;
    /// use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let loops = PlaneCurve::new([t.pow(2), t.pow(3) - &t, Poly::one()], (None, None)).unwrap();
    /// let found = loops.double_points()?;
    /// assert_eq!(found[0].parameters.each_ref().map(|t| t.to_string()), ["-1", "1"]);
    /// # Ok::<(), polarform::system::SystemError>(())
    /// ```
    pub fn double_points(&self) -> Result<Vec<Meeting>, SystemError> {
        let unknowns = ["s", "t"].map(Symbol::new);
        let [x, y, w] = self.coordinates.each_ref().map(|f| of(f, &unknowns[0]));
        let [x2, y2, w2] = self.coordinates.each_ref().map(|f| of(f, &unknowns[1]));
        let [s, t] = unknowns.clone().map(MultiPoly::symbol);
        let apart = s - t;
        let divided = |f: MultiPoly| f.div_exact(&apart).unwrap_or_else(MultiPoly::zero);
        let p = divided(x * w2.clone() - x2 * w.clone());
        let q = divided(y * w2 - y2 * w);
        let zeros = common_zeros(&p, &q, &unknowns, &[self.range.clone(), self.range.clone()])?;
        let kept =
            |pair: &[RealRoot; 2]| pair[0] <= pair[1] && !pair[0].sign_of(&self.coordinates[2]).is_eq();
        let pairs = zeros.into_iter().filter_map(|zero| <[RealRoot; 2]>::try_from(zero.coordinates).ok());
        Ok(pairs.filter(kept).map(Meeting::new).collect())
    }

    /// The parameters of a point, increasing; `None` if the curve is that point.
    ///
    /// Cost: two greatest common divisors and real roots.
    pub fn parameters_of(&self, point: &[Rational; 2]) -> Option<Vec<RealRoot>> {
        let [x, y, w] = &self.coordinates;
        let common = (x - &w.scale(&point[0])).gcd(&(y - &w.scale(&point[1])));
        let (lower, upper) = &self.range;
        let roots = common.real_roots(lower.as_ref(), upper.as_ref())?;
        Some(roots.into_iter().map(|(t, _)| t).collect())
    }
}

impl Meeting {
    fn new(parameters: [RealRoot; 2]) -> Self {
        Meeting { degree: degree_of(&parameters[0]), parameters }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, rational as q};
    use proptest::prelude::*;

    fn poly(list: &[i64]) -> Poly {
        list.iter().map(|&k| z(k)).collect()
    }

    fn list(len: usize) -> impl Strategy<Value = Vec<i64>> {
        prop::collection::vec(-4i64..5, len)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// The parameters are those of the roots of the equation of the other curve, where that has no double point there.
        #[test]
        fn meetings_satisfy_the_equation(
            a in list(4), b in list(3), c in list(3), d in list(4), w in list(2), lower in -2i64..1, upper in 1i64..3,
        ) {
            let curve = PlaneCurve::new([poly(&a), poly(&b), Poly::one()], (Some(z(lower)), Some(z(upper)))).unwrap();
            let weight = Poly::from(11) + poly(&w).pow(2);
            let other = PlaneCurve::new([poly(&c), poly(&d), weight], (None, None)).unwrap();
            let symbols = ["x", "y"].map(Symbol::new);
            let lists = other.coordinates.each_ref().map(|f| {
                f.coefficients().into_iter().map(crate::math::poly::Fraction::from).collect::<Vec<_>>()
            });
            let Some(equation) = crate::math::curve::implicit_equation(&lists, [&symbols[0], &symbols[1]]) else {
                return Ok(());
            };
            let (found, on) = (curve.meetings(&other), curve.on(&equation, &symbols));
            let Ok(found) = found else {
                prop_assert!(on.is_none() || curve.coordinates.iter().all(|f| f.degree().unwrap_or(0) == 0)
                    || other.double_points().is_err());
                return Ok(());
            };
            let on = on.unwrap();
            // Every meeting lies on the equation, with equal points.
            for meeting in &found {
                prop_assert!(on.contains(&meeting.parameters[0]));
                if meeting.degree <= 6 {
                    prop_assert_eq!(curve.point(&meeting.parameters[0]), other.point(&meeting.parameters[1]));
                }
            }
            // A point of the equation has a real parameter, unless it is an isolated point or a limit.
            for t in &on {
                let known = found.iter().any(|meeting| meeting.parameters[0] == *t);
                if let (false, RealRoot::Rational(t)) = (known, t) {
                    let w = curve.coordinates[2].value(t);
                    let point = [0, 1].map(|k| curve.coordinates[k].value(t) / &w);
                    prop_assert_eq!(other.parameters_of(&point).unwrap(), Vec::<RealRoot>::new());
                }
            }
        }

        /// A curve through a point twice has a double point there, whose pair is found.
        #[test]
        fn planted_double_points_are_found(x in list(3), y in list(3), s in -3i64..4, t in -3i64..4) {
            prop_assume!(s < t);
            // X = (u − s)(u − t) x(u) + 5 is 5 at both.
            let factor = (Poly::variable() - Poly::from(s)) * (Poly::variable() - Poly::from(t));
            let curve = PlaneCurve::new(
                [&factor * &poly(&x) + Poly::from(5), &factor * &poly(&y) - Poly::from(1), Poly::one()],
                (None, None),
            ).unwrap();
            let Ok(found) = curve.double_points() else { return Ok(()) };
            let planted = [s, t].map(|k| RealRoot::Rational(z(k)));
            prop_assert!(found.iter().any(|pair| pair.parameters == planted));
            prop_assert!(found.iter().all(|pair| pair.degree > 5 || curve.point(&pair.parameters[0]) == curve.point(&pair.parameters[1])));
            let parameters = curve.parameters_of(&[z(5), z(-1)]).unwrap();
            prop_assert!(planted.iter().all(|t| parameters.contains(t)));
        }
    }

    #[test]
    fn curves_that_touch_overlap_or_miss() {
        let t = Poly::variable();
        let unit = (Some(z(0)), Some(z(1)));
        let parabola = PlaneCurve::new([t.clone(), t.pow(2), Poly::one()], unit.clone()).unwrap();
        let tangent =
            PlaneCurve::new([t.clone(), &t - &Poly::constant(q(1, 4)), Poly::one()], unit.clone()).unwrap();
        let found = parabola.meetings(&tangent).unwrap();
        assert_eq!(found[0].parameters, [1, 1].map(|_| RealRoot::Rational(q(1, 2))));
        assert_eq!(found.len(), 1);
        assert_eq!(parabola.meetings(&parabola), Err(SystemError::Infinite));
        let above = PlaneCurve::new([t.clone(), Poly::from(2), Poly::one()], unit.clone()).unwrap();
        assert_eq!(parabola.meetings(&above), Ok(Vec::new()));
        let cusp = PlaneCurve::new([t.pow(2), t.pow(3), Poly::one()], (None, None)).unwrap();
        assert_eq!(cusp.double_points().unwrap()[0].parameters, [0, 0].map(|k| RealRoot::Rational(z(k))));
        let twice = PlaneCurve::new([t.pow(2), t.pow(4), Poly::one()], (None, None)).unwrap();
        assert_eq!(twice.double_points(), Err(SystemError::Infinite));
    }
}
