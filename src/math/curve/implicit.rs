//! The equation of a plane curve that is given by polynomials or fractions of them.
//!
//! Let (X/W, Y/W) be the curve with X, Y, W without a common factor. A point (x, y) lies on it, or is a limit of such points, if
//! P = W x − X and Q = W y − Y have a common root t, so if Res_t(P, Q) = 0. This resultant is c F^k: F is the
//! irreducible equation, of degree at most n, and k tells how often the curve is run through.
//!
//! T. W. Sederberg, D. C. Anderson, R. N. Goldman, "Implicit representation of parametric curves and surfaces",
//! Computer Vision, Graphics, and Image Processing 28 (1984).

use nalgebra::DMatrix;
use num_traits::{Signed, Zero};

use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol, horner};
use crate::math::ring::Ring;

/// A polynomial F in two symbols, primitive with a positive leading coefficient and without repeated factors, that is 0 exactly at the points of the curve
/// with the homogeneous coordinates X, Y and W by powers of its parameter, and at their limits; `None` if the curve is a
/// single point or W is 0.
///
/// Cost for degree n: one resultant in three variables, by (n + 1)² resultants of numbers if there are no other symbols,
/// and a greatest common divisor of two polynomials of degree n k.
///
/// # Panics
/// If one of the two symbols occurs in the coordinates.
///
/// ```
/// use polarform::curve::implicit_equation;
/// use polarform::number::integer;
/// use polarform::poly::{Fraction, Symbol};
/// let list = |c: &[i64]| c.iter().map(|c| Fraction::from(integer(*c))).collect::<Vec<_>>();
/// let [x, y] = ["x", "y"].map(Symbol::new);
/// let f = implicit_equation(&[list(&[0, 0, 1]), list(&[0, 0, 0, 1]), list(&[1])], [&x, &y]).unwrap();
/// assert_eq!(f.to_string(), "x^3 - y^2");
/// ```
pub fn implicit_equation(coordinates: &[Vec<Fraction>; 3], symbols: [&Symbol; 2]) -> Option<MultiPoly> {
    let known: Vec<Symbol> = coordinates.iter().flatten().flat_map(Fraction::variables).collect();
    assert!(symbols.iter().all(|s| !known.contains(s)), "the symbols of the equation are those of the curve");
    let parameter =
        (0..).map(|k| Symbol::new("t").numbered(k)).find(|t| !known.contains(t) && !symbols.contains(&t))?;
    let t = Fraction::from(MultiPoly::symbol(parameter.clone()));
    let [first, second, weight] = coordinates.each_ref().map(|list| horner(list, &t));
    if weight.is_zero() {
        return None;
    }
    let line = |coordinate: &Fraction, symbol: &Symbol| {
        let symbol = Fraction::from(MultiPoly::symbol(symbol.clone()));
        weight.times(&symbol).minus(coordinate).numerator().clone()
    };
    let (p, q) = (line(&first, symbols[0]), line(&second, symbols[1]));
    let common = p.gcd(&q);
    let (p, q) = (p.div_exact(&common)?, q.div_exact(&common)?);
    if p.degree_in(&parameter).max(q.degree_in(&parameter)) == 0 {
        return None;
    }
    let power = p.resultant(&q, &parameter);
    // Factors without x and y come from denominators.
    let content = power
        .coefficients_in(symbols[0])
        .iter()
        .flat_map(|c| c.coefficients_in(symbols[1]))
        .fold(MultiPoly::zero(), |content, c| content.gcd(&c));
    let power = power.div_exact(&content)?;
    let occurs = symbols.into_iter().find(|s| power.degree_in(s) > 0)?;
    let equation = power.div_exact(&power.gcd(&power.derivative(occurs)))?;
    let equation = equation.primitive_part();
    let negative = equation.terms(MonomialOrder::Lex).first().is_some_and(|(_, c)| c.is_negative());
    Some(if negative { -equation } else { equation })
}

/// P = W x − X, Q = W y − Y and Bézout's matrix of them, with the coefficient b_ij of t^i s^j in (P(t) Q(s) − P(s) Q(t))/(t − s): its determinant is 0 at the
/// points of the curve. `None` if both are constant in t, or W is 0.
///
/// Cost: n² products of polynomials in x and y.
///
/// # Panics
/// If t, x or y occur in the coordinates.
///
/// ```
/// use polarform::curve::bezout_matrix;
/// use polarform::number::integer;
/// use polarform::poly::{Fraction, Symbol};
/// let list = |c: &[i64]| c.iter().map(|c| Fraction::from(integer(*c))).collect::<Vec<_>>();
/// let [t, x, y] = ["t", "x", "y"].map(Symbol::new);
/// let (p, q, matrix) = bezout_matrix(&[list(&[0, 0, 1]), list(&[0, 0, 0, 1]), list(&[1])], &t, [&x, &y]).unwrap();
/// assert_eq!(format!("{p}, {q}, {}", matrix[(1, 1)]), "-t^2 + x, -t^3 + y, x");
/// ```
pub fn bezout_matrix(
    coordinates: &[Vec<Fraction>; 3],
    t: &Symbol,
    symbols: [&Symbol; 2],
) -> Option<(Fraction, Fraction, DMatrix<Fraction>)> {
    let mut known = coordinates.iter().flatten().flat_map(Fraction::variables);
    assert!(!known.any(|s| s == *t || s == *symbols[0] || s == *symbols[1]), "t, x and y are free");
    let size = coordinates.iter().map(Vec::len).max()?;
    let at = |list: &Vec<Fraction>, i: usize| list.get(i).cloned().unwrap_or_else(Fraction::zero);
    let [x, y, w] = coordinates;
    let line = |coordinate: &Vec<Fraction>, symbol: &Symbol| -> Vec<Fraction> {
        let symbol = Fraction::from(MultiPoly::symbol(symbol.clone()));
        (0..size).map(|i| at(w, i).times(&symbol).minus(&at(coordinate, i))).collect()
    };
    let (p, q) = (line(x, symbols[0]), line(y, symbols[1]));
    let n = (1..size).rev().find(|&i| !p[i].is_zero() || !q[i].is_zero())?;
    if w.iter().all(Zero::is_zero) {
        return None;
    }
    // (t^i s^j − t^j s^i)/(t − s) = Σ t^{j + k} s^{i − 1 − k} for i > j.
    let mut matrix: DMatrix<Fraction> = DMatrix::from_element(n, n, Fraction::zero());
    for i in 1..=n {
        for j in 0..i {
            crate::budget::step();
            let minor = p[i].times(&q[j]).minus(&p[j].times(&q[i]));
            for k in 0..i - j {
                matrix[(j + k, i - 1 - k)] += minor.clone();
            }
        }
    }
    let t = Fraction::from(MultiPoly::symbol(t.clone()));
    let [p, q] = [p, q].map(|list| horner(&list, &t));
    Some((p, q, matrix))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::{ImplicitConic, Interval, RationalCurve};
    use crate::math::number::{Rational, integer, rational};
    use crate::math::poly::Poly;
    use proptest::prelude::*;

    fn fractions(list: &[Rational]) -> Vec<Fraction> {
        list.iter().cloned().map(Fraction::from).collect()
    }

    fn symbols() -> [Symbol; 2] {
        ["x", "y"].map(Symbol::new)
    }

    fn coordinate(len: usize) -> impl Strategy<Value = Vec<Rational>> {
        prop::collection::vec((-5i64..6, 1i64..3), 0..len)
            .prop_map(|list| list.into_iter().map(|(p, q)| rational(p, q)).collect())
    }

    proptest! {
        /// What vanishes on a curve and is irreducible is its equation, up to a factor.
        #[test]
        fn the_equation_is_irreducible_and_vanishes(
            x in coordinate(5), y in coordinate(5), w in coordinate(4), inner in coordinate(4), rational_curve: bool,
        ) {
            let poly = |list: &[Rational]| Poly::from_coefficients(list.to_vec());
            // Also curves that are run through several times.
            let inner = if inner.is_empty() { Poly::variable() } else { poly(&inner) };
            let w = if rational_curve && !poly(&w).is_zero() { poly(&w) } else { Poly::one() };
            let [x, y, w] = [poly(&x), poly(&y), w].map(|p| p.compose(&inner));
            prop_assume!(!w.is_zero());
            let names = symbols();
            let lists = [&x, &y, &w].map(|p| fractions(&p.coefficients()));
            let point = [&x, &y].iter().all(|p| (*p * &w.derivative()) == (p.derivative() * &w));
            match implicit_equation(&lists, [&names[0], &names[1]]) {
                None => prop_assert!(point),
                Some(f) => {
                    prop_assert!(!point);
                    // The determinant is a multiple of the equation.
                    let (_, _, matrix) = bezout_matrix(&lists, &Symbol::new("t"), [&names[0], &names[1]]).unwrap();
                    if matrix.nrows() <= 4 {
                        let determinant = crate::math::linalg::determinant(&matrix).unwrap();
                        prop_assert!(determinant.numerator().div_exact(&f).is_some());
                    }
                    let factors = f.factors().factors;
                    prop_assert!(factors.len() == 1 && factors[0].1 == 1, "{f}");
                    prop_assert!(f.total_degree().unwrap() as usize <= [&x, &y, &w].iter().filter_map(|p| p.degree()).max().unwrap());
                    for k in -6..7 {
                        let (x, y, w) = (x.value(&integer(k)), y.value(&integer(k)), w.value(&integer(k)));
                        if w.is_zero() {
                            continue;
                        }
                        let at = |s: &Symbol| Some(if *s == names[0] { &x / &w } else { &y / &w });
                        prop_assert!(f.value(&at).is_zero());
                    }
                }
            }
        }

        #[test]
        fn conics_have_the_equation_that_their_control_points_give(
            points in prop::collection::vec((-4i64..5, -4i64..5), 3), weight in 1i64..5,
        ) {
            let points: Vec<Vec<Rational>> = points.iter().map(|(x, y)| [*x, *y].map(integer).to_vec()).collect();
            let curve = RationalCurve::new(points.clone(), vec![integer(1), rational(weight, 2), integer(1)], Interval::unit()).unwrap();
            if let Ok(conic) = ImplicitConic::new(&curve) {
                let power = curve.homogeneous().power();
                let lists = [0, 1, 2].map(|k| fractions(&power[k]));
                let names = symbols();
                let f = implicit_equation(&lists, [&names[0], &names[1]]).unwrap();
                // Both vanish on the curve; at other points they have one ratio.
                let value = |x: i64, y: i64| {
                    let own = f.value(&|s| Some(integer(if *s == names[0] { x } else { y }))).as_constant().unwrap();
                    (own, conic.value(&[integer(x), integer(y)]).unwrap())
                };
                let (a, b) = (value(17, -11), value(-13, 19));
                prop_assert_eq!(&a.0 * &b.1, &a.1 * &b.0);
            }
        }
    }

    #[test]
    fn special_curves() {
        let names = symbols();
        let of = |x: &[i64], y: &[i64], w: &[i64]| {
            let lists = [x, y, w].map(|c| fractions(&c.iter().map(|c| integer(*c)).collect::<Vec<_>>()));
            implicit_equation(&lists, [&names[0], &names[1]]).map(|f| f.to_string())
        };
        assert_eq!(of(&[0, 0, 1], &[0, 0, 0, 0, 1], &[1]).as_deref(), Some("x^2 - y"));
        assert_eq!(of(&[3], &[0, 1], &[1]).as_deref(), Some("x - 3"));
        assert_eq!(of(&[3], &[4], &[1]), None);
        assert_eq!(of(&[0, 1], &[0, 2], &[0, 5]), None);
        assert_eq!(of(&[1], &[1], &[]), None);
        // The unit circle, and the cubic with a double point.
        assert_eq!(of(&[1, 0, -1], &[0, 2], &[1, 0, 1]).as_deref(), Some("x^2 + y^2 - 1"));
        assert_eq!(of(&[-1, 0, 1], &[0, -1, 0, 1], &[1]).as_deref(), Some("x^3 + x^2 - y^2"));
    }

    #[test]
    fn control_points_may_be_symbols() {
        let names = symbols();
        let a = Fraction::from(MultiPoly::symbol(Symbol::new("a")));
        let (zero, one) = (Fraction::zero(), Fraction::from(integer(1)));
        let lists = [vec![zero.clone(), a.clone()], vec![zero.clone(), zero, one.clone()], vec![one]];
        let f = implicit_equation(&lists, [&names[0], &names[1]]).unwrap();
        assert_eq!(f.to_string(), "a^2 y - x^2");
    }
}
