use super::*;
use crate::math::curve::Point;
use crate::math::linalg::{characteristic_polynomial, multiply};
use crate::math::number::{Rational, integer as z, rational as q};
use crate::math::poly::{Coefficients, Poly};
use crate::math::spline::{BSpline, KnotVector};
use nalgebra::DMatrix;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

fn number() -> impl Strategy<Value = Rational> {
    (-9i64..10, 1i64..5).prop_map(|(p, r)| q(p, r))
}

fn any_scheme() -> impl Strategy<Value = Scheme<Rational>> {
    (prop::collection::vec(number(), 1..9), -5i64..5)
        .prop_filter_map("all are 0", |(mask, first)| Scheme::new(mask, first).ok())
}

fn polygon(dimension: usize) -> impl Strategy<Value = Vec<Point<Rational>>> {
    let point = prop::collection::vec(number(), dimension).prop_map(Point::from);
    prop::collection::vec(point, 1..9)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// New points are the coefficients of a(z) p(z²), for one period of a closed polygon those modulo
    /// z^{2m} − 1.
    #[test]
    fn a_step_is_a_product_with_the_symbol(scheme in any_scheme(), points in polygon(2), closed in any::<bool>()) {
        let m = points.len();
        let stretched = |k: usize| {
            let list = points.iter().flat_map(|p| [p[k].clone(), z(0)]).collect();
            Coefficients::new(list).times(&scheme.symbol())
        };
        let products = [stretched(0), stretched(1)];
        let at = |i: i64, k: usize| -> Rational {
            let place = i - scheme.first();
            let period = 2 * m as i64;
            let list = products[k].iter().enumerate().map(|(j, x)| (j as i64, x));
            list.filter(|(j, _)| if closed { (j - place) % period == 0 } else { *j == place })
                .fold(z(0), |sum, (_, x)| sum + x)
        };
        match scheme.refine(&points, closed) {
            Ok(finer) => {
                let start = if closed { 0 } else { scheme.last() - 1 };
                let count = if closed { 2 * m } else { 2 * m + 1 - scheme.mask().len() + 1 };
                prop_assert_eq!(finer.len(), count);
                for (i, point) in (start..).zip(&finer) {
                    prop_assert_eq!(point, &[at(i, 0), at(i, 1)]);
                }
                let matrix = scheme.matrix(m, closed).unwrap();
                let column = DMatrix::from_fn(m, 1, |i, _| points[i][0].clone());
                let product = multiply(&matrix, &column).unwrap();
                prop_assert!(product.iter().zip(&finer).all(|(x, point)| *x == point[0]));
                let twice = scheme.refine_often(&points, closed, 2);
                prop_assert_eq!(twice, scheme.refine(&finer, closed));
            }
            Err(error) => {
                let needed = scheme.mask().len() / 2;
                prop_assert!(!closed && m < needed.max(1));
                prop_assert_eq!(error, SubdivisionError::TooFewPoints { needed: needed.max(1), given: m });
            }
        }
    }

    /// Sum rules of order k: Σ (−1)^i i^r a_i = 0 for r < k, and not for k.
    #[test]
    fn sum_rules_are_moments(rest in prop::collection::vec(number(), 1..5), k in 0usize..5, first in -5i64..5) {
        let factor = Coefficients::new(vec![z(1), z(1)]);
        let mask = (0..k).fold(Coefficients::new(rest), |p, _| p.times(&factor)).into_vec();
        let Ok(scheme) = Scheme::new(mask, first) else { return Ok(()) };
        let moment = |r: u32| scheme.mask().iter().enumerate().fold(z(0), |sum, (i, a)| {
            let i = scheme.first() + i as i64;
            let sign = if i % 2 == 0 { z(1) } else { z(-1) };
            sum + a * sign * z(i.pow(r))
        });
        let order = scheme.sum_rules();
        prop_assert!(order >= k);
        prop_assert!((0..order as u32).all(|r| moment(r).is_zero()));
        prop_assert!(!moment(order as u32).is_zero());
    }

    /// The norm of an iterate is the largest row sum of the powers of the matrix for a long closed polygon.
    #[test]
    fn norms_are_row_sums(symbol in prop::collection::vec(number(), 1..5), steps in 1usize..4) {
        let Ok(scheme) = Scheme::new(symbol, 0) else { return Ok(()) };
        let m = 8;
        let mut matrix = DMatrix::identity(m, m);
        for k in 0..steps {
            matrix = multiply(&scheme.matrix(m << k, true).unwrap(), &matrix).unwrap();
        }
        let sums = matrix.row_iter().map(|row| row.iter().fold(z(0), |sum, x| sum + x.abs()));
        prop_assert_eq!(iterated_norm(&scheme.symbol(), steps), sums.max().unwrap());
    }

    /// Uniform splines of degree n: the refined points are those over halved knots, the limits its values.
    #[test]
    fn lane_riesenfeld_is_knot_insertion(n in 0usize..6, points in prop::collection::vec(number(), 7..10)) {
        let points: Vec<Point<Rational>> = points.into_iter().map(|x| [x].into()).collect();
        let scheme = Scheme::lane_riesenfeld(n);
        let knots = KnotVector::uniform(n, points.len(), &z(0), &z(1)).unwrap();
        let s = BSpline::new(knots, points.clone()).unwrap();
        let finer = s.refine(s.halved_knots().unwrap()).unwrap();
        prop_assert_eq!(finer.points(), scheme.refine(&points, false).unwrap());
        prop_assert_eq!(scheme.sum_rules(), n + 1);
        for order in 0..n {
            // The parameter of the first value: N_0 has its middle at (n + 1)/2 or, for even n, half a step before.
            let stencil = limit_stencil(&scheme, order, 3).unwrap();
            let derived = s.nth_derivative(order).unwrap();
            let at = s.interval().start().clone();
            let values = stencil.apply(&points, false).unwrap();
            let expected = derived.value(&at).unwrap();
            prop_assert!(values.contains(&expected), "degree {n}, order {order}: {values:?} {expected:?}");
            prop_assert_eq!(values.iter().position(|value| *value == expected).map(|_| ()), Some(()));
        }
        prop_assert_eq!(contraction(&scheme, n, 4).unwrap(), Contraction::Eigenvalue);
        prop_assert_eq!(contraction(&scheme, n + 1, 4).unwrap(), Contraction::NoFactor);
    }

    /// The limit point stays the same when a step comes before; derivatives halve with the parameter.
    #[test]
    fn limits_do_not_change_by_a_step(points in polygon(2), which in 0usize..5) {
        let scheme = match which {
            0 => Scheme::lane_riesenfeld(3),
            1 => Scheme::four_point(&q(1, 16)),
            2 => Scheme::four_point(&q(1, 20)),
            3 => Scheme::corner_cutting(&q(1, 3), &q(1, 3)),
            _ => Scheme::corner_cutting(&q(1, 4), &q(1, 4)),
        };
        let finer = scheme.refine(&points, true).unwrap();
        for order in 0..2 {
            let Ok(stencil) = limit_stencil(&scheme, order, 4) else {
                prop_assert_eq!((which, order), (3, 1));
                continue;
            };
            let values = stencil.apply(&points, true).unwrap();
            let after = stencil.apply(&finer, true).unwrap();
            for (i, value) in values.iter().enumerate() {
                let scaled: Vec<Rational> = after[2 * i].iter().map(|x| x * z(1 << order)).collect();
                prop_assert_eq!(value, &scaled);
            }
        }
    }
}

#[test]
fn four_points_reproduce_cubics() {
    let cubic = |k: i64| z(k * k * k - 4 * k + 1);
    let points: Vec<Point<Rational>> = (-3..5).map(|k| [z(k), cubic(k)].into()).collect();
    let finer = Scheme::four_point(&q(1, 16)).refine(&points, false).unwrap();
    assert_eq!(finer.len(), 11);
    for point in finer {
        let t = point[0].clone();
        assert_eq!(point[1], &t * &t * &t - &t * z(4) + z(1));
    }
}

#[test]
fn smoothness_of_well_known_schemes() {
    let shown = |scheme: &Scheme<Rational>, order| {
        matches!(contraction(scheme, order, 8).unwrap(), Contraction::Shown { .. })
    };
    let de_rham = Scheme::corner_cutting(&q(1, 3), &q(1, 3));
    assert!(shown(&de_rham, 0) && !shown(&de_rham, 1));
    let chaikin = Scheme::corner_cutting(&q(1, 4), &q(1, 4));
    assert_eq!(chaikin.mask(), Scheme::<Rational>::lane_riesenfeld(2).mask());
    assert!(shown(&chaikin, 1) && !shown(&chaikin, 2));
    for w in [q(1, 16), q(1, 20), q(1, 10)] {
        let scheme = Scheme::four_point(&w);
        assert!(shown(&scheme, 1) && !shown(&scheme, 2), "w = {w}");
    }
    // without tension: the polygon itself
    let polygon = Scheme::four_point(&z(0));
    assert!(shown(&polygon, 0) && !shown(&polygon, 1));
    // w = 1/2: sums of 2, differences that do not contract
    assert!(!shown(&Scheme::four_point(&q(1, 2)), 0));
    let doubled = Scheme::new([1, 3, 3, 1].map(z).to_vec(), 0).unwrap();
    assert_eq!(contraction(&doubled, 0, 4), Ok(Contraction::NoFactor));
    assert_eq!(Scheme::new(vec![z(0); 3], 0), Err(SubdivisionError::EmptyMask));
    let cut = Scheme::new([0, 0, 1, 2, 0].map(z).to_vec(), -1).unwrap();
    assert_eq!((cut.first(), cut.last(), cut.mask()), (1, 2, &[z(1), z(2)][..]));
    assert!(limit_stencil(&de_rham, 1, 4).is_err());
    let w = crate::math::poly::Fraction::from(crate::math::poly::MultiPoly::symbol(
        crate::math::poly::Symbol::new("w"),
    ));
    assert_eq!(contraction(&Scheme::four_point(&w), 0, 4), Err(SubdivisionError::Symbols));
    assert_eq!(Scheme::four_point(&w).sum_rules(), 2);
}

const MESHES: [VertexScheme; 4] =
    [VertexScheme::CatmullClark, VertexScheme::DooSabin, VertexScheme::Loop, VertexScheme::Warren];

/// The matrix, if its entries are numbers.
fn numbers(scheme: VertexScheme, n: usize) -> Option<DMatrix<Rational>> {
    let matrix = vertex_matrix(scheme, n).unwrap();
    matrix
        .iter()
        .all(|entry| entry.degree().unwrap_or(0) == 0)
        .then(|| matrix.map(|entry| entry.coefficient(0)))
}

/// Weights are not negative, rows of them sum to 1, and limits do not change in a step.
#[test]
fn around_vertices() {
    for n in 3..13 {
        let cosine = Cosine::new(n);
        assert_eq!(cosine.equation.degree() == Some(1), [3, 4, 6].contains(&n));
        let rest = |f: Poly| f.div_rem(&cosine.equation).unwrap().1;
        for scheme in MESHES {
            let matrix = vertex_matrix(scheme, n).unwrap();
            let rational =
                !matches!(scheme, VertexScheme::DooSabin | VertexScheme::Loop) || [3, 4, 6].contains(&n);
            assert_eq!(numbers(scheme, n).is_some(), rational);
            for row in matrix.row_iter() {
                assert_eq!(row.iter().fold(Poly::zero(), |sum, x| sum + x.clone()), Poly::one());
                assert!(row.iter().all(|x| cosine.value.sign_of(x).is_ge()));
            }
            let limit = vertex_limit(scheme, n).unwrap();
            assert_eq!(limit.iter().fold(Poly::zero(), |sum, x| sum + x.clone()), Poly::one());
            for (j, column) in matrix.column_iter().enumerate() {
                let share = limit.iter().zip(column.iter()).fold(Poly::zero(), |sum, (w, x)| sum + w * x);
                assert_eq!(rest(share), limit[j], "{scheme:?} {n}");
            }
        }
    }
    assert_eq!(vertex_matrix(VertexScheme::Loop, 6), vertex_matrix(VertexScheme::Warren, 6));
    assert_eq!(vertex_matrix(VertexScheme::Loop, 2), Err(SubdivisionError::Valence { given: 2 }));
    assert_eq!(vertex_eigenvalues(VertexScheme::DooSabin, 1), Err(SubdivisionError::Valence { given: 1 }));
}

/// The eigenvalues are the roots of the characteristic polynomial; with an irrational cosine their sums of powers are the traces of powers.
#[test]
fn eigenvalues_around_vertices() {
    for n in 3..11 {
        for scheme in MESHES {
            let found = vertex_eigenvalues(scheme, n).unwrap();
            if let Some(matrix) = numbers(scheme, n) {
                let polynomial: Poly = characteristic_polynomial(&matrix).unwrap().into_iter().collect();
                let mut expected = polynomial.real_roots(None, None).unwrap();
                expected.reverse();
                assert_eq!(found, expected, "{scheme:?} {n}");
                continue;
            }
            let cosine = (std::f64::consts::TAU / n as f64).cos();
            let number = |q: Rational| num_traits::ToPrimitive::to_f64(&q).unwrap();
            let entry =
                |f: &Poly| f.coefficients().into_iter().rev().fold(0.0, |sum, c| sum * cosine + number(c));
            let matrix = vertex_matrix(scheme, n).unwrap().map(|f| entry(&f));
            let value = |root: &crate::math::poly::RealRoot| match root {
                crate::math::poly::RealRoot::Rational(q) => number(q.clone()),
                crate::math::poly::RealRoot::Irrational(x) => {
                    number(x.refined(&Rational::new(1.into(), (1i64 << 50).into())).ends().0)
                }
            };
            assert_eq!(found.iter().map(|(_, m)| m).sum::<usize>(), matrix.nrows());
            let mut power = matrix.clone();
            for k in 1..5 {
                let sum: f64 = found.iter().map(|(x, m)| *m as f64 * value(x).powi(k)).sum();
                assert!((sum - power.trace()).abs() < 1e-9, "{scheme:?} {n} {k}");
                power *= &matrix;
            }
        }
    }
}

/// One step around a regular vertex is that of tensor-product cubics.
#[test]
fn regular_catmull_clark_is_bicubic() {
    let cubic = Scheme::<Rational>::lane_riesenfeld(3);
    let a = |i: i64, j: i64| cubic.coefficient(i - 2 * j);
    // the vertex, edges and faces in order around it
    let places = [(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];
    let expected = DMatrix::from_fn(9, 9, |r, c| {
        let ((i, j), (k, l)) = (places[r], places[c]);
        a(i, k) * a(j, l)
    });
    assert_eq!(numbers(VertexScheme::CatmullClark, 4).unwrap(), expected);
}
