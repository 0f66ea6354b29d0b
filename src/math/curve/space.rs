//! Where curves in space meet surfaces and each other.
//!
//! A curve (X_1/W, …, X_d/W) meets F(x_1, …, x_d) = 0 where F(X/W) = 0, one equation for its parameter. Two curves meet where d
//! equations hold for two parameters; two combinations P and Q of them without a common factor have finitely many common zeros,
//! of which those are kept that satisfy all d equations. A curve and a surface meet where d equations hold for three parameters.
//!
//! T. W. Sederberg, "Planar piecewise algebraic curves", CAGD 1 (1984).

use num_traits::{One, Zero};

use crate::budget;
use crate::math::number::{Rational, integer};
use crate::math::poly::{MonomialOrder, MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::Ring;
use crate::math::system::{Bounds, RealZero, SystemError, common_zeros, image, real_zeros, within};

/// A curve by homogeneous coordinates, polynomials of the parameter over an interval; the weight is the last of them.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceCurve {
    coordinates: Vec<Poly>,
    range: Bounds,
}

/// A surface by homogeneous coordinates, polynomials of two parameters within bounds; the weight is the last of them.
#[derive(Clone, Debug, PartialEq)]
pub struct ParametricSurface {
    /// X_1, …, X_d and W.
    pub coordinates: Vec<MultiPoly>,
    /// The two parameters.
    pub parameters: [Symbol; 2],
    /// A rectangle, or for a triangle one around it.
    pub bounds: [Bounds; 2],
    /// What else is not negative in the domain: linear forms for a triangle.
    pub sides: Vec<MultiPoly>,
}

/// Combinations of equations that are tried.
const MIXTURES: [[i64; 2]; 6] = [[0, 0], [1, 0], [0, 1], [1, 2], [2, -1], [3, 5]];

impl SpaceCurve {
    /// The curve for parameters within bounds; `None` if its weight is 0 everywhere.
    ///
    /// # Panics
    /// Without coordinates.
    pub fn new(coordinates: Vec<Poly>, range: Bounds) -> Option<Self> {
        let common = coordinates.iter().fold(Poly::zero(), |common, f| common.gcd(f));
        let coordinates: Vec<Poly> =
            coordinates.iter().map(|f| f.div_exact(&common)).collect::<Option<_>>()?;
        (!coordinates[coordinates.len() - 1].is_zero()).then_some(SpaceCurve { coordinates, range })
    }

    fn weight(&self) -> &Poly {
        &self.coordinates[self.coordinates.len() - 1]
    }

    /// The point of a parameter, of which the weight is not 0. Cost: [`image`] for each coordinate.
    pub fn point(&self, t: &RealRoot) -> Vec<RealRoot> {
        self.coordinates[..self.coordinates.len() - 1].iter().map(|x| image(t, x, self.weight())).collect()
    }

    /// The parameters at which the curve lies on F = 0, increasing; `None` if it lies there everywhere. F is a polynomial in symbols for
    /// the coordinates.
    ///
    /// Cost: F of polynomials, and the real roots of one of degree n deg F.
    ///
    /// # Panics
    /// If F has other symbols.
    ///
    /// ```
    /// use polarform::curve::SpaceCurve;
    /// use polarform::number::integer;
    /// use polarform::poly::{MultiPoly, Poly, Symbol};
    /// let t = Poly::variable();
    /// let cubic = SpaceCurve::new(vec![t.clone(), t.pow(2), t.pow(3), Poly::from(1)], (None, None)).unwrap();
    /// let symbols = ["x", "y", "z"].map(Symbol::new);
    /// let [x, y, z] = symbols.clone().map(MultiPoly::symbol);
    /// let found = cubic.on(&(z - x), &symbols).unwrap();
    /// assert_eq!(found.iter().map(|t| t.to_string()).collect::<Vec<_>>(), ["-1", "0", "1"]);
    /// ```
    pub fn on(&self, equation: &MultiPoly, symbols: &[Symbol]) -> Option<Vec<RealRoot>> {
        let (w, sum) = (self.weight(), on_coordinates(equation, symbols, &self.coordinates));
        let (lower, upper) = &self.range;
        let roots = sum.real_roots(lower.as_ref(), upper.as_ref())?;
        Some(roots.into_iter().map(|(t, _)| t).filter(|t| !t.sign_of(w).is_eq()).collect())
    }

    /// The pairs of parameters at which this curve and another one of the same dimension have a common point.
    ///
    /// Cost for degrees m and n: that of [`common_zeros`] for two polynomials of degree m in s and n in t, and the signs of the
    /// equations there.
    ///
    /// # Errors
    /// [`SystemError::Infinite`] if both are parts of one curve, or one is a point of the other.
    ///
    /// # Panics
    /// If the dimensions differ.
    ///
    /// ```
    /// use polarform::curve::SpaceCurve;
    /// use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let one = Poly::from(1);
    /// let cubic = SpaceCurve::new(vec![t.clone(), t.pow(2), t.pow(3), one.clone()], (None, None)).unwrap();
    /// let line = SpaceCurve::new(vec![t.clone(), t.clone(), t.clone(), one], (None, None)).unwrap();
    /// let found = cubic.meetings(&line)?;
    /// assert_eq!(found.iter().map(|[s, _]| s.to_string()).collect::<Vec<_>>(), ["0", "1"]);
    /// # Ok::<(), polarform::system::SystemError>(())
    /// ```
    pub fn meetings(&self, other: &SpaceCurve) -> Result<Vec<[RealRoot; 2]>, SystemError> {
        assert_eq!(self.coordinates.len(), other.coordinates.len(), "both curves have one dimension");
        let unknowns = ["s", "t"].map(Symbol::new);
        let of = |f: &Poly, k: usize| f.value_in(&MultiPoly::symbol(unknowns[k].clone()));
        let (w, w2) = (of(self.weight(), 0), of(other.weight(), 1));
        let count = self.coordinates.len() - 1;
        let equations: Vec<MultiPoly> = (0..count)
            .map(|k| of(&self.coordinates[k], 0) * w2.clone() - of(&other.coordinates[k], 1) * w.clone())
            .filter(|f| !f.is_zero())
            .collect();
        let common = equations.iter().fold(MultiPoly::zero(), |common, f| common.gcd(f));
        if equations.len() < 2 || common.as_constant().is_none() {
            return Err(SystemError::Infinite);
        }
        let bounds = [self.range.clone(), other.range.clone()];
        let zeros = match few_zeros(&equations, &unknowns) {
            Some(zeros) => {
                let inside = |zero: &RealZero| (0..2).all(|k| within(&zero.coordinates[k], &bounds[k]));
                zeros.into_iter().filter(inside).collect()
            }
            None => mixed_zeros(&equations, &unknowns, &bounds)?,
        };
        let kept = |zero: &RealZero| {
            !zero.coordinates[0].sign_of(self.weight()).is_eq()
                && !zero.coordinates[1].sign_of(other.weight()).is_eq()
                && equations.iter().all(|f| zero.sign_of(f, &unknowns).is_eq())
        };
        let found = zeros.into_iter().filter(kept);
        Ok(found.filter_map(|zero| zero.coordinates.try_into().ok()).collect())
    }

    /// The parameters t of this curve and u, v of a surface of the same dimension at their common points, ordered.
    ///
    /// Cost: a Gröbner basis in three unknowns, and D^4 operations for D complex solutions.
    ///
    /// # Errors
    /// Those of [`real_zeros`].
    ///
    /// # Panics
    /// If the dimensions differ.
    pub fn on_surface(&self, surface: &ParametricSurface) -> Result<Vec<[RealRoot; 3]>, SystemError> {
        assert_eq!(self.coordinates.len(), surface.coordinates.len(), "both have one dimension");
        let t = Symbol::new("\u{25e6}");
        let [u, v] = &surface.parameters;
        let unknowns = [t.clone(), u.clone(), v.clone()];
        let of = |f: &Poly| f.value_in(&MultiPoly::symbol(t.clone()));
        let count = self.coordinates.len() - 1;
        let (w, w2) = (of(self.weight()), &surface.coordinates[count]);
        let mut equations: Vec<MultiPoly> = (0..count)
            .map(|k| of(&self.coordinates[k]) * w2.clone() - surface.coordinates[k].clone() * w.clone())
            .collect();
        // At base points of the surface, often complex ones, the equations hold for all t: their weight has no inverse.
        let mut all = unknowns.to_vec();
        let weights = w * w2.clone();
        if weights.as_constant().is_none() {
            let inverse = Symbol::new("\u{25e7}");
            equations.push(weights * MultiPoly::symbol(inverse.clone()) - MultiPoly::constant(integer(1)));
            all.push(inverse);
        }
        let zeros = real_zeros(&equations, &all)?;
        let kept = |zero: &RealZero| {
            within(&zero.coordinates[0], &self.range)
                && (0..2).all(|k| within(&zero.coordinates[k + 1], &surface.bounds[k]))
                && surface.sides.iter().all(|side| zero.sign_of(side, &all).is_ge())
        };
        let found = zeros.into_iter().filter(kept);
        Ok(found.filter_map(|zero| zero.coordinates[..3].to_vec().try_into().ok()).collect())
    }
}

impl ParametricSurface {
    /// G(u, v) such that the points of the surface on F = 0 are those with G = 0: W^{deg F} F(X/W), without a number as factor; 0 if the surface lies on F = 0.
    ///
    /// # Panics
    /// If F has other symbols than those of the coordinates.
    ///
    /// ```
    /// use polarform::curve::ParametricSurface;
    /// use polarform::number::integer;
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let [u, v] = ["u", "v"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    /// let one = MultiPoly::constant(integer(1));
    /// let saddle = ParametricSurface {
    ///     coordinates: vec![u.clone(), v.clone(), u * v, one.clone()],
    ///     parameters: ["u", "v"].map(Symbol::new),
    ///     bounds: Default::default(),
    ///     sides: Vec::new(),
    /// };
    /// let symbols = ["x", "y", "z"].map(Symbol::new);
    /// let plane = MultiPoly::symbol(symbols[2].clone()) - one;
    /// assert_eq!(saddle.section(&plane, &symbols).to_string(), "u v - 1");
    /// ```
    pub fn section(&self, equation: &MultiPoly, symbols: &[Symbol]) -> MultiPoly {
        on_coordinates(equation, symbols, &self.coordinates).primitive_part()
    }
}

/// W^{deg F} F(X/W) for homogeneous coordinates X, W.
fn on_coordinates<R: Ring>(equation: &MultiPoly, symbols: &[Symbol], coordinates: &[R]) -> R {
    let w = &coordinates[coordinates.len() - 1];
    let degree = equation.total_degree().unwrap_or(0);
    let mut sum = R::zero();
    for (monomial, c) in equation.terms(MonomialOrder::Lex) {
        budget::step();
        let total: u32 = monomial.iter().map(|(_, e)| e).sum();
        let term = monomial.iter().fold(w.powered(degree - total).scaled(&c), |term, (symbol, e)| {
            let place = symbols.iter().position(|s| s == symbol).expect("only coordinates occur");
            term.times(&coordinates[place].powered(*e))
        });
        sum += term;
    }
    sum
}

/// The common zeros of three equations or more, if polynomials in each unknown alone tell that they are few: that in s is a common factor of
/// the resultants Res_t(f_1, f_2), Res_t(f_1, f_3), …
fn few_zeros(equations: &[MultiPoly], unknowns: &[Symbol; 2]) -> Option<Vec<RealZero>> {
    const FEW: usize = 8;
    let mut system = equations.to_vec();
    for (kept, other) in [(0, 1), (1, 0)] {
        let mut common = MultiPoly::zero();
        for f in &equations[1..] {
            let free = [&equations[0], f].iter().all(|f| f.degree_in(&unknowns[other]) == 0);
            // The resultant of two numbers is 1, whatever they are.
            let eliminated =
                if free { equations[0].gcd(f) } else { equations[0].resultant(f, &unknowns[other]) };
            common = common.gcd(&eliminated);
        }
        match common.degree_in(&unknowns[kept]) as usize {
            _ if common.is_zero() || equations.len() < 3 => return None,
            0 => return Some(Vec::new()),
            1..=FEW => system.push(common),
            _ => return None,
        }
    }
    real_zeros(&system, unknowns).ok()
}

/// The common zeros of two combinations of equations without a common factor that have none themselves.
fn mixed_zeros(
    equations: &[MultiPoly],
    unknowns: &[Symbol; 2],
    bounds: &[Bounds; 2],
) -> Result<Vec<RealZero>, SystemError> {
    // Σ a_i f_i for the numbers 1, k, k², …, and the rest of them for another k.
    let combination = |k: i64| {
        let mut factor = Rational::one();
        equations.iter().fold(MultiPoly::zero(), |sum, f| {
            let term = f.scaled(&factor);
            factor *= integer(k);
            sum + term
        })
    };
    let pairs = (0..equations.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
    let plain = pairs.map(|(i, j)| (equations[i].clone(), equations[j].clone()));
    let mixed = MIXTURES.iter().map(|[a, b]| (combination(a + 1), combination(b - 2)));
    for (p, q) in plain.chain(mixed) {
        if p.is_zero() || q.is_zero() || p.gcd(&q).as_constant().is_none() {
            continue;
        }
        return common_zeros(&p, &q, unknowns, bounds);
    }
    Err(SystemError::Entangled)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, rational as q};
    use proptest::prelude::*;

    fn poly(list: &[i64]) -> Poly {
        list.iter().map(|&k| z(k)).collect()
    }

    fn curve(lists: &[Vec<i64>], range: Bounds) -> SpaceCurve {
        let one = std::iter::once(Poly::from(1));
        SpaceCurve::new(lists.iter().map(|list| poly(list)).chain(one).collect(), range).unwrap()
    }

    fn lists(count: usize, len: usize) -> impl Strategy<Value = Vec<Vec<i64>>> {
        prop::collection::vec(prop::collection::vec(-3i64..4, len), count)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// A curve moved so that it meets another one at planted parameters does; all that is found is a common point.
        #[test]
        fn planted_meetings_are_found(a in lists(3, 3), b in lists(3, 3), s in -2i64..3, t in -2i64..3) {
            let shift: Vec<Rational> = (0..3).map(|k| poly(&a[k]).value(&z(s)) - poly(&b[k]).value(&z(t))).collect();
            let moved: Vec<Poly> = b.iter().zip(&shift).map(|(f, d)| poly(f) + Poly::constant(d.clone())).collect();
            let first = curve(&a, (None, None));
            let other = SpaceCurve::new(moved.into_iter().chain([Poly::from(1)]).collect(), (None, None)).unwrap();
            let Ok(found) = first.meetings(&other) else { return Ok(()) };
            let planted = [s, t].map(|k| RealRoot::Rational(z(k)));
            prop_assert!(found.contains(&planted));
            for [s, t] in &found {
                prop_assert_eq!(first.point(s), other.point(t));
            }
        }

        /// Curves in planes through one line: two equations may speak of one parameter only.
        #[test]
        fn flat_curves_meet_where_they_must(a in lists(1, 3), b in lists(1, 3), c in -2i64..3) {
            let zero = vec![0];
            let first = curve(&[a[0].clone(), zero.clone(), a[0].iter().map(|k| c * k).collect()], (None, None));
            let other = curve(&[zero.clone(), b[0].clone(), zero], (None, None));
            let Ok(found) = first.meetings(&other) else { return Ok(()) };
            let roots = |f: &[i64]| poly(f).real_roots(None, None).unwrap_or_default();
            let all: Vec<[RealRoot; 2]> = roots(&a[0])
                .iter()
                .flat_map(|(s, _)| roots(&b[0]).into_iter().map(|(t, _)| [s.clone(), t]))
                .collect();
            prop_assert_eq!(found.len(), all.len());
            prop_assert!(all.iter().all(|pair| found.contains(pair)));
        }

        /// On a patch: a point of the surface is put on the curve, and the equation of the surface finds the same parameters.
        #[test]
        fn surfaces_are_met_where_their_equation_says(a in lists(3, 3), c in lists(3, 4), t in -1i64..2, u in 0i64..3, v in 0i64..3) {
            let names = ["u", "v"].map(Symbol::new);
            let [x, y] = names.clone().map(MultiPoly::symbol);
            let one = MultiPoly::constant(z(1));
            let monomials = [one.clone(), x.clone(), y.clone(), x * y];
            let mut coordinates: Vec<MultiPoly> = c.iter().map(|list| {
                list.iter().zip(&monomials).fold(MultiPoly::zero(), |sum, (c, m)| sum + m.scaled(&z(*c)))
            }).collect();
            coordinates.push(one);
            let (u, v) = (q(u, 2), q(v, 2));
            let bounds = [(Some(z(0)), Some(z(1))), (Some(z(0)), Some(z(1)))];
            let surface = ParametricSurface { coordinates, parameters: names.clone(), bounds, sides: Vec::new() };
            let at = |f: &MultiPoly| f.value(&|s| Some(if *s == names[0] { u.clone() } else { v.clone() })).as_constant().unwrap();
            let moved: Vec<Poly> = a.iter().zip(&surface.coordinates).map(|(f, g)| {
                poly(f) + Poly::constant(at(g) - poly(f).value(&z(t)))
            }).chain([Poly::from(1)]).collect();
            let line = SpaceCurve::new(moved, (Some(z(-1)), Some(z(1)))).unwrap();
            let Ok(found) = line.on_surface(&surface) else { return Ok(()) };
            let planted = [z(t), u.clone(), v.clone()].map(RealRoot::Rational);
            prop_assert_eq!(found.contains(&planted), u <= z(1) && v <= z(1));
            let symbols = ["x", "y", "z"].map(Symbol::new);
            let fractions: Vec<crate::math::poly::Fraction> =
                surface.coordinates[..3].iter().map(|f| f.clone().into()).collect();
            let equation = crate::math::curve::surface_equation(&fractions.try_into().unwrap(), [&names[0], &names[1]], &symbols);
            if let Ok(Some(equation)) = equation {
                prop_assert!(surface.section(&equation, &symbols).is_zero());
                let on = line.on(&equation, &symbols).unwrap();
                prop_assert!(found.iter().all(|[t, _, _]| on.contains(t)));
            }
        }
    }

    /// The unit sphere by (2 u, 2 v, u^2 + v^2 - 1)/(u^2 + v^2 + 1), whose coordinates all vanish at complex u and v. Lines that are no
    /// tangents meet it where its equation says.
    #[test]
    fn base_points_are_no_common_points() {
        let names = ["u", "v"].map(Symbol::new);
        let [u, v] = names.clone().map(MultiPoly::symbol);
        let one = || MultiPoly::constant(z(1));
        let squares = u.clone() * u.clone() + v.clone() * v.clone();
        let coordinates = vec![u.scaled(&z(2)), v.scaled(&z(2)), squares.clone() - one(), squares + one()];
        let sphere = ParametricSurface {
            coordinates,
            parameters: names,
            bounds: Default::default(),
            sides: Vec::new(),
        };
        let symbols = ["x", "y", "z"].map(Symbol::new);
        let [x, y, z] = symbols.clone().map(MultiPoly::symbol);
        let equation = x.clone() * x + y.clone() * y + z.clone() * z - one();
        for (point, direction) in [([0, 0, 0], [1, 1, 1]), ([1, 0, 2], [0, 1, -1]), ([0, 3, 0], [1, 1, 0])] {
            let lists: Vec<Vec<i64>> = (0..3).map(|k| vec![point[k], direction[k]]).collect();
            let line = curve(&lists, (None, None));
            let found: Vec<RealRoot> =
                line.on_surface(&sphere).unwrap().into_iter().map(|[t, ..]| t).collect();
            assert_eq!(found, line.on(&equation, &symbols).unwrap(), "{point:?} {direction:?}");
        }
    }

    #[test]
    fn curves_overlap_or_miss() {
        let free = || (None, None);
        let cubic = curve(&[vec![0, 1], vec![0, 0, 1], vec![0, 0, 0, 1]], free());
        assert_eq!(cubic.meetings(&cubic), Err(SystemError::Infinite));
        let apart = curve(&[vec![0, 1], vec![1, 0, 1], vec![5]], free());
        assert_eq!(cubic.meetings(&apart).unwrap(), Vec::<[RealRoot; 2]>::new());
        // x − x and y − y have the factor s − t in common, z does not.
        let other = curve(&[vec![0, 1], vec![0, 0, 1], vec![0, 1]], free());
        let found: Vec<String> =
            cubic.meetings(&other).unwrap().iter().map(|[s, t]| format!("{s} {t}")).collect();
        assert_eq!(found, ["-1 -1", "0 0", "1 1"]);
    }
}
