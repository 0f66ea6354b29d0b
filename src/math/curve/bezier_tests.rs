use super::*;
use crate::math::basis::bernstein_all;
use crate::math::number::{integer as z, rational as q};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use proptest::prelude::*;

type Curve = BezierCurve<Rational>;

fn small() -> impl Strategy<Value = Rational> {
    (-9i64..10, 1i64..6).prop_map(|(p, r)| q(p, r))
}

pub(crate) fn any_curve() -> impl Strategy<Value = Curve> {
    let points = (1usize..4).prop_flat_map(|d| {
        let point = prop_oneof![
            3 => prop::collection::vec(small(), d),
            1 => Just(vec![z(1); d]),
        ];
        prop::collection::vec(point, 1..7)
    });
    (points, small(), small()).prop_map(|(points, a, b)| {
        let b = if a == b { &a + z(1) } else { b };
        Curve::new(points, Interval::new(a, b).unwrap()).unwrap()
    })
}

/// Σ b_i B_i^n: independent of the lerps.
fn by_bernstein(c: &Curve, t: &Rational) -> Point<Rational> {
    let (a, b) = c.interval().ends();
    let weights = bernstein_all(c.degree(), &((t - a) / (b - a)));
    combination(c.dimension(), weights.iter().zip(c.points())).from_origin()
}

proptest! {
    #[test]
    fn values_agree(c in any_curve(), t in small()) {
        let value = c.value(&t);
        prop_assert_eq!(&value, &by_bernstein(&c, &t));
        let n = c.degree();
        let tableau = c.tableau(&vec![t.clone(); n]).unwrap();
        prop_assert_eq!(tableau.result(), &value);
        let power: Point<Rational> = c.power().iter().map(|p| Coefficients::new(p.clone()).value(&t)).collect();
        prop_assert_eq!(&power, &value);
        // every entry is the value of the polar form at its label
        let forms = c.polar_forms();
        for (points, labels) in tableau.levels.iter().zip(&tableau.labels) {
            for (point, label) in points.iter().zip(labels) {
                for (x, form) in point.iter().zip(&forms) {
                    prop_assert_eq!(x, &form.value(label).unwrap());
                }
            }
        }
    }

    #[test]
    fn every_representation_is_the_same_curve(c in any_curve(), r in small(), s in small(), t in small()) {
        let value = c.value(&t);
        if r != s {
            let part = c.part(Interval::new(r.clone(), s.clone()).unwrap());
            prop_assert_eq!(part.value(&t), value.clone());
            prop_assert_eq!(part.part(c.interval().clone()), c.clone());
        }
        if &r != c.interval().start() && &r != c.interval().end() {
            let (left, right) = c.subdivide(&r).unwrap();
            let (before, after) = c.interval().split(&r).unwrap();
            prop_assert_eq!((&left, &right), (&c.part(before), &c.part(after)));
        }
        // numbers go another way than symbols
        let s = c.interval().local(&r);
        if let Ok((left, right)) = c.subdivide(&r) {
            prop_assert_eq!((left.points, right.points), c.split_by_steps(&s));
        }
        for by in 0..4 {
            prop_assert_eq!(c.elevate(by).points, c.elevate_by_matrix(by).points);
        }
        let raised = c.elevate(3);
        prop_assert_eq!(raised.value(&t), value.clone());
        prop_assert_eq!(raised.reduce(3).unwrap(), c.clone());
        prop_assert_eq!(raised.exact_degree(), c.exact_degree());
        let (start, edges) = c.edges();
        let edges = Curve::from_edges(start.clone(), &edges, c.interval().clone());
        prop_assert_eq!(edges.unwrap(), c.clone());
    }

    #[test]
    fn calculus(c in any_curve(), t in small()) {
        let n = c.degree();
        for k in 0..=n + 1 {
            let derivative = c.nth_derivative(k);
            let forms: Point<Rational> = c.polar_forms().iter()
                .map(|form| form.nth_derivative(k).diagonal().value(&t)).collect();
            prop_assert_eq!(derivative.value(&t), forms);
        }
        let start = Point::from(vec![z(7); c.dimension()]);
        let primitive = c.antiderivative(start.clone()).unwrap();
        prop_assert_eq!(primitive.derivative(), c.clone());
        let (a, b) = c.interval().ends();
        prop_assert_eq!(primitive.value(a), start.clone());
        prop_assert_eq!(primitive.value(b) - &start, c.integral());
    }

    #[test]
    fn products(c in any_curve(), d in any_curve(), t in small()) {
        let d = d.over(c.interval().clone());
        match c.product(&d) {
            Ok(product) => {
                let (x, y) = (c.value(&t), d.value(&t));
                let expected = if x.len() == 1 { y.iter().map(|y| &x[0] * y).collect() }
                    else if y.len() == 1 { x.iter().map(|x| x * &y[0]).collect() }
                    else { vec![x.iter().zip(&y).map(|(x, y)| x * y).sum()] };
                prop_assert_eq!(product.value(&t), expected);
            }
            Err(_) => prop_assert!(c.dimension() != d.dimension()),
        }
        let inner = PolarForm::new(vec![z(1), q(1, 2), z(-1)]);
        let composed = c.compose(&inner, Interval::unit()).unwrap();
        prop_assert_eq!(composed.value(&t), c.value(&inner.diagonal().value(&t)));
    }

    #[test]
    fn scaling_of_bernstein_polynomials(n in 0usize..6, c in small(), t in small()) {
        let matrix = bernstein_scaling(n, &c);
        let (inner, outer) = (bernstein_all(n, &(&c * &t)), bernstein_all(n, &t));
        for (row, left) in matrix.iter().zip(&inner) {
            let right: Rational = row.iter().zip(&outer).map(|(x, y)| x * y).sum();
            prop_assert_eq!(left, &right);
        }
    }
}

#[test]
fn the_edge_basis_follows_its_formula() {
    // f_i = ((−t)^i/(i−1)!) Φ^{(i−1)}(t), Φ(t) = ((1−t)^n − 1)/t
    for n in 0..7usize {
        let basis = bezier_edge_basis(n);
        assert_eq!(basis[0][0], z(1));
        assert!(basis[0][1..].iter().all(num_traits::Zero::is_zero));
        let mut phi: Coefficients<Rational> = (1..=n)
            .map(|k| {
                let sign = if k % 2 == 1 { -1 } else { 1 };
                Rational::from_integer(binomial(n, k)) * z(sign)
            })
            .collect();
        for (i, f) in basis.iter().enumerate().skip(1) {
            let factor = Rational::new(
                Int::from(if i % 2 == 1 { -1i64 } else { 1 }),
                crate::math::number::factorial(i - 1),
            );
            let mut expected = vec![z(0); i];
            expected.extend(phi.iter().map(|c| c * &factor));
            expected.resize(n + 1, z(0));
            assert_eq!(f, &expected, "f_{i}^{n}");
            phi = phi.derivative();
        }
    }
}

#[test]
fn bernstein_polynomials_are_largest_at_i_over_n() {
    for n in 1..6usize {
        for i in 0..=n {
            let (place, value) = bernstein_maximum(n, i).unwrap();
            for k in 0..=24 {
                assert!(crate::math::basis::bernstein(n, i, &q(k, 24)) <= value);
            }
            assert_eq!(crate::math::basis::bernstein(n, i, &place), value);
        }
    }
    assert!(bernstein_maximum(2, 3).is_err());
}

#[test]
fn symbols() {
    let symbol = |name: &str| Fraction::from(MultiPoly::symbol(Symbol::new(name)));
    let points = vec![vec![symbol("p")], vec![symbol("q")], vec![symbol("w")]];
    let c = BezierCurve::new(points, Interval::new(symbol("a"), symbol("b")).unwrap()).unwrap();
    let middle = c.blossom(&[Argument::Point(symbol("a")), Argument::Point(symbol("b"))]).unwrap();
    assert_eq!(middle, Argument::Point([symbol("q")].into()));
    assert_eq!(c.contains(&symbol("a")), Some(true));
    assert_eq!(c.contains(&symbol("t")), None);
    assert!(matches!(c.reduce(1), Err(CurveError::NotReducible { exact: 2, .. })));
}

#[test]
fn what_is_wrong_is_said() {
    let none: Vec<Point<Rational>> = vec![];
    assert_eq!(Curve::new(none, Interval::unit()), Err(CurveError::TooFewPoints { needed: 1, given: 0 }));
    let constant = Curve::new(vec![vec![z(0)]], Interval::unit()).unwrap();
    assert_eq!(constant.subdivide(&z(1)), Err(CurveError::EmptyInterval));
    let ragged = Curve::new(vec![vec![z(0)], vec![z(0), z(1)]], Interval::unit());
    assert_eq!(ragged, Err(CurveError::Dimensions { index: 1, found: 2, expected: 1 }));
    let point = Curve::new(vec![vec![z(3)]], Interval::unit()).unwrap();
    assert_eq!(point.derivative().points(), [[z(0)]]);
    assert_eq!(point.value(&z(9)), [z(3)]);
    assert_eq!(point.contains(&q(1, 2)), Some(true));
    assert_eq!(point.contains(&z(2)), Some(false));
}

#[test]
fn curves_without_coordinates_keep_their_points() {
    let empty: Vec<Point<Rational>> = vec![Vec::new().into(), Vec::new().into()];
    let c = Curve::new(empty, Interval::unit()).unwrap();
    assert_eq!(c.elevate(2).degree(), 3);
    let (left, right) = c.subdivide(&q(1, 2)).unwrap();
    assert_eq!((left.degree(), right.degree()), (1, 1));
}
