//! Each operation on patches by two ways, also on degenerate nets and on symbols.

use proptest::prelude::*;

use super::*;
use crate::math::blossom::PolarForm;
use crate::math::curve::Surface;
use crate::math::number::{integer as z, rational as q};
use crate::math::poly::{Fraction, MultiPoly, Symbol};

/// Patches of degree (0, 0) to (3, 3) over some rectangle; some have all points equal.
pub(in crate::math::curve) fn any_patch(size: usize) -> impl Strategy<Value = TensorPatch<Rational>> {
    let coordinate = (-9i64..10, 1i64..4).prop_map(|(p, r)| q(p, r));
    let point = prop::collection::vec(coordinate, size);
    let net = (1usize..5, 1usize..5)
        .prop_flat_map(move |(m, n)| prop::collection::vec(prop::collection::vec(point.clone(), n), m));
    (net, -3i64..3, 1i64..4, -3i64..3, 1i64..4, 0..8).prop_map(|(mut net, a, b, c, d, equal)| {
        if equal == 0 {
            let first = net[0][0].clone();
            net.iter_mut().flatten().for_each(|p| p.clone_from(&first));
        }
        let (u, v) = (Interval::new(z(a), z(a + b)).unwrap(), Interval::new(z(c), z(c - d)).unwrap());
        TensorPatch::new(net, u, v).unwrap()
    })
}

fn parameter() -> impl Strategy<Value = Rational> {
    (-7i64..8, 1i64..4).prop_map(|(p, r)| q(p, r))
}

/// Σ c_ij u^i v^j
fn by_powers(patch: &TensorPatch<Rational>, u: &Rational, v: &Rational) -> Point<Rational> {
    let mut total = Point::from(vec![z(0); patch.dimension()]);
    for (i, row) in patch.power_coefficients().iter().enumerate() {
        for (j, c) in row.iter().enumerate() {
            let weight = num_traits::pow(u.clone(), i) * num_traits::pow(v.clone(), j);
            total.iter_mut().zip(c).for_each(|(x, y)| *x += &weight * y);
        }
    }
    total
}

/// ∂f/∂u and ∂f/∂v
fn tangents(
    patch: &TensorPatch<Rational>,
    u: &Rational,
    v: &Rational,
) -> (Vector<Rational>, Vector<Rational>) {
    (patch.derivative_at(1, 0, u, v), patch.derivative_at(0, 1, u, v))
}

fn points(value: &Rational, count: usize) -> Vec<Argument<Rational>> {
    vec![Argument::Point(value.clone()); count]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn values_agree(patch in any_patch(2), u in parameter(), v in parameter()) {
        let (m, n) = patch.degrees();
        let value = patch.value(&u, &v);
        prop_assert_eq!(patch.blossom(&points(&u, m), &points(&v, n)).unwrap(), Argument::Point(value.clone()));
        prop_assert_eq!(by_powers(&patch, &u, &v), value.clone());
        for scheme in [Scheme::UFirst, Scheme::VFirst, Scheme::Bilinear] {
            match patch.tableau(&u, &v, scheme) {
                Ok(nets) => prop_assert_eq!(&nets[nets.len() - 1], &[[value.clone()]]),
                Err(error) => prop_assert_eq!(error, CurveError::Degrees { left: m, right: n }),
            }
        }
        prop_assert_eq!(patch.transposed().value(&v, &u), value);
        let (end, curve) = (patch.u.end(), patch.boundary_curve(Side::UEnd));
        prop_assert_eq!(curve.value(&v), patch.value(end, &v));
        let (end, curve) = (patch.v.end(), patch.boundary_curve(Side::VEnd));
        prop_assert_eq!(curve.value(&u), patch.value(&u, end));
    }

    #[test]
    fn polar_values_agree(patch in any_patch(2), list in prop::collection::vec((parameter(), 0..3), 6)) {
        let (m, n) = patch.degrees();
        let argument = |(x, kind): &(Rational, i32)| {
            if *kind == 0 { Argument::Vector(x.clone()) } else { Argument::Point(x.clone()) }
        };
        let u: Vec<_> = list[..m].iter().map(argument).collect();
        let v: Vec<_> = list[3..3 + n].iter().map(argument).collect();
        let forms = patch.polar_forms();
        let expected: Vec<Rational> = forms.iter().map(|f| f.value(&u, &v).unwrap()).collect();
        let value = patch.blossom(&u, &v).unwrap();
        prop_assert_eq!(value.coordinates(), expected);
        let vectors = u.iter().chain(&v).any(|argument| matches!(argument, Argument::Vector(_)));
        prop_assert_eq!(matches!(value, Argument::Vector(_)), vectors);
        let grid = patch.power_coefficients();
        let back = TensorPatch::from_power_coefficients(grid, patch.u.clone(), patch.v.clone());
        prop_assert_eq!(back.as_ref(), Ok(&patch));
        // the rows alone, through the polar forms of curves
        let row: Vec<Rational> = patch.net[0].iter().map(|p| p[0].clone()).collect();
        let form = PolarForm::from_bezier_points_over(&row, &patch.v).unwrap();
        let at_start = patch.blossom(&points(patch.u.start(), m), &v).unwrap();
        prop_assert_eq!(form.value(&v).unwrap(), at_start.coordinates()[0].clone());
    }

    #[test]
    fn pieces_lie_on_the_surface(patch in any_patch(2), u in parameter(), v in parameter(), w in parameter()) {
        let value = patch.value(&u, &v);
        for direction in [Direction::U, Direction::V] {
            let interval = if direction == Direction::U { &patch.u } else { &patch.v };
            match patch.subdivide(direction, &w) {
                Ok((left, right)) => {
                    prop_assert_eq!(left.value(&u, &v), value.clone());
                    prop_assert_eq!(right.value(&u, &v), value.clone());
                    prop_assert_eq!(&patch.part(left.u.clone(), left.v.clone()), &left);
                    prop_assert_eq!(&left.part(patch.u.clone(), patch.v.clone()), &patch);
                }
                Err(error) => {
                    prop_assert_eq!(error, CurveError::EmptyInterval);
                    prop_assert!(w == *interval.start() || w == *interval.end());
                }
            }
        }
        if let Ok(quarters) = Surface::subdivide(&patch, &[u, v]) {
            let (m, n) = patch.degrees();
            for (quarter, (i, j)) in quarters.iter().zip([(m, n), (m, 0), (0, n), (0, 0)]) {
                prop_assert_eq!(&quarter.net[i][j], &value);
            }
        }
    }

    #[test]
    fn elevate_then_reduce(patch in any_patch(2), by_u in 0usize..3, by_v in 0usize..3,
                           u in parameter(), v in parameter()) {
        let higher = patch.elevate(by_u, by_v);
        prop_assert_eq!(higher.value(&u, &v), patch.value(&u, &v));
        prop_assert_eq!(&higher.reduce(by_u, by_v).unwrap(), &patch);
        let ((m, n), (k, l)) = (patch.degrees(), patch.exact_degrees());
        prop_assert_eq!(higher.exact_degrees(), (k, l));
        prop_assert!(patch.reduce(m - k, n - l).is_ok());
        let error = CurveError::NotReducible { degree: m, exact: k, by: m - k + 1 };
        prop_assert_eq!(patch.reduce(m - k + 1, 0), Err(error));
    }

    #[test]
    fn derivatives_agree(patch in any_patch(2), u in parameter(), v in parameter(), r in 0usize..5, s in 0usize..5) {
        let derivative = patch.derivative(r, s);
        prop_assert_eq!(derivative.value(&u, &v).position(), patch.derivative_at(r, s, &u, &v));
        for (k, form) in patch.polar_forms().iter().enumerate() {
            let form = form.derivative(r, s).unwrap();
            let (m, n) = form.degrees();
            let value = form.value(&points(&u, m), &points(&v, n)).unwrap();
            prop_assert_eq!(&value, &derivative.value(&u, &v)[k]);
        }
    }

    #[test]
    fn normals_are_cross_products(patch in any_patch(3), u in parameter(), v in parameter()) {
        let (x, y) = tangents(&patch, &u, &v);
        let expected = polygon::cross(&x, &y, |a, b| a * b, |a, b| a - b);
        let normal = patch.normal().unwrap();
        prop_assert_eq!(normal.value(&u, &v), expected);
        let (m, n) = patch.degrees();
        if m > 0 && n > 0 {
            prop_assert_eq!(normal.degrees(), (2 * m - 1, 2 * n - 1));
        }
    }
}

#[test]
fn boundaries_and_corners() {
    let height = [[0, 1, 3], [2, 5, 4]];
    let net = (0..2)
        .map(|i| (0..3).map(|j| vec![z(i), z(j), z(height[i as usize][j as usize])]).collect())
        .collect();
    let patch = TensorPatch::new(net, Interval::new(z(0), z(2)).unwrap(), Interval::unit()).unwrap();
    assert_eq!(patch.boundary(Side::UStart), patch.net[0]);
    assert_eq!(patch.boundary(Side::VEnd), [patch.net[0][2].clone(), patch.net[1][2].clone()]);
    // the twist at the first corner: m n (b_11 − b_10 − b_01 + b_00) / width
    let sum = [z(0), z(0), z(5 - 2 - 1)];
    assert_eq!(patch.derivative_at(1, 1, &z(0), &z(0)), sum);
    let (along_u, along_v) = tangents(&patch, &z(0), &z(0));
    assert_eq!(along_u, (&patch.net[1][0] - &patch.net[0][0]) * &q(1, 2));
    assert_eq!(along_v, (&patch.net[0][1] - &patch.net[0][0]) * &z(2));
}

#[test]
fn bad_nets_are_refused() {
    let unit = Interval::<Rational>::unit;
    let new = |net| TensorPatch::new(net, unit(), unit()).unwrap_err();
    assert_eq!(new(vec![]), CurveError::TooFewPoints { needed: 1, given: 0 });
    assert_eq!(new(vec![vec![]]), CurveError::TooFewPoints { needed: 1, given: 0 });
    let p = vec![z(0)];
    let ragged = vec![vec![p.clone()], vec![p.clone(), p.clone()]];
    assert_eq!(new(ragged), CurveError::RaggedNet { row: 1, found: 2, expected: 1 });
    let mixed = vec![vec![p.clone(), p.clone()], vec![p.clone(), vec![z(0), z(1)]]];
    assert_eq!(new(mixed), CurveError::Dimensions { index: 3, found: 2, expected: 1 });
    let patch = TensorPatch::new(vec![vec![p]], unit(), unit()).unwrap();
    assert_eq!(patch.normal(), Err(CurveError::DimensionsOf { left: 1, right: 3 }));
    let argument = [Argument::Point(z(0))];
    assert_eq!(patch.blossom(&[], &argument), Err(CurveError::Arguments { expected: 0, given: 1 }));
    assert_eq!(patch.reduce(1, 0), Err(CurveError::NotReducible { degree: 0, exact: 0, by: 1 }));
}

#[test]
fn a_biquadratic_patch_of_symbols() {
    let name = |s: &str| Fraction::from(MultiPoly::symbol(Symbol::new(s)));
    let b = |i: usize, j: usize| name(&format!("b{i}{j}"));
    let net = (0..3).map(|i| (0..3).map(|j| vec![b(i, j)]).collect()).collect();
    let (a, e) = (name("a"), name("e"));
    let patch =
        TensorPatch::new(net, Interval::new(a.clone(), e.clone()).unwrap(), Interval::unit()).unwrap();
    // f(a, e; 0, 1) = b_11, and the two directions agree at symbols
    let point = |x: &Fraction| Argument::Point(x.clone());
    let zero = name("t") - name("t");
    let one = Fraction::from(z(1));
    let value = patch.blossom(&[point(&e), point(&a)], &[point(&one), point(&zero)]);
    assert_eq!(value, Ok(Argument::Point([b(1, 1)].into())));
    let (u, v) = (name("u"), name("v"));
    let first = patch.tableau(&u, &v, Scheme::UFirst).unwrap();
    let second = patch.tableau(&u, &v, Scheme::VFirst).unwrap();
    assert_eq!(first[4], second[4]);
    assert_eq!(first[4], patch.tableau(&u, &v, Scheme::Bilinear).unwrap()[2]);
    // ∂f/∂u at the first corner: 2 (b_10 − b_00)/(e − a)
    let along_u = patch.derivative_at(1, 0, &a, &zero);
    assert_eq!(along_u[0], (b(1, 0) - b(0, 0)) * Fraction::from(z(2)) / (e - a));
}
