//! Each operation on triangular patches by two ways, also on degenerate ones and on symbols.

use proptest::prelude::*;

use super::*;
use crate::math::number::{integer as z, rational as q};
use crate::math::poly::{Fraction, MultiPoly, Symbol};

pub(in crate::math::curve) fn any_triangle() -> impl Strategy<Value = Triangle<Rational>> {
    prop::collection::vec((-5i64..6).prop_map(z), 6).prop_map(|c| {
        let corners = [c[0..2].to_vec(), c[2..4].to_vec(), c[4..6].to_vec()];
        Triangle::new(corners).unwrap_or_else(|_| Triangle::unit())
    })
}

/// Patches of degree 0 to 3; some have all points equal.
pub(in crate::math::curve) fn any_patch(size: usize) -> impl Strategy<Value = TrianglePatch<Rational>> {
    let coordinate = (-9i64..10, 1i64..4).prop_map(|(p, r)| q(p, r));
    let point = prop::collection::vec(coordinate, size);
    let points =
        (0usize..4).prop_flat_map(move |n| prop::collection::vec(point.clone(), (n + 1) * (n + 2) / 2));
    (points, any_triangle(), 0..8).prop_map(|(mut points, triangle, equal)| {
        if equal == 0 {
            let first = points[0].clone();
            points.iter_mut().for_each(|p| p.clone_from(&first));
        }
        TrianglePatch::new(points, triangle).unwrap()
    })
}

fn plane_point() -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec((-7i64..8, 1i64..4).prop_map(|(p, r)| q(p, r)), 2)
}

/// Σ n!/(i! j! k!) λ_0^i λ_1^j λ_2^k b_ijk
fn by_bernstein(patch: &TrianglePatch<Rational>, p: &[Rational]) -> Point<Rational> {
    let lambda = patch.triangle.barycentric(p).unwrap();
    let weights: Vec<Rational> = indices(patch.degree)
        .iter()
        .map(|index| {
            let powers = index.iter().zip(&lambda).map(|(&e, x)| num_traits::pow(x.clone(), e));
            powers.fold(Rational::from_integer(multinomial(index)), |product, x| product * x)
        })
        .collect();
    combination(patch.dimension(), weights.iter().zip(&patch.points)).from_origin()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn values_agree(patch in any_patch(2), p in plane_point()) {
        let value = patch.value(&p).unwrap();
        prop_assert_eq!(by_bernstein(&patch, &p), value.clone());
        let levels = patch.tableau(&p).unwrap();
        prop_assert_eq!(&levels[patch.degree][0], &value);
        let forms = patch.polar_forms();
        let diagonal: Point<Rational> = forms.iter().map(|f| f.diagonal_at(&p)).collect();
        prop_assert_eq!(diagonal, value.clone());
        prop_assert_eq!(patch.permuted([2, 0, 1]).unwrap().value(&p).unwrap(), value);
        prop_assert_eq!(patch.permuted([1, 0, 2]).unwrap().permuted([1, 0, 2]).unwrap(), patch.clone());
        prop_assert_eq!(TrianglePatch::from_polar_forms(&forms, patch.triangle.clone()).unwrap(), patch);
    }

    #[test]
    fn polar_values_agree(patch in any_patch(2), list in prop::collection::vec((plane_point(), 0..3), 3)) {
        let arguments: Vec<_> = list[..patch.degree].iter().map(|(p, kind)| {
            if *kind == 0 { Argument::Vector(p.clone()) } else { Argument::Point(p.clone()) }
        }).collect();
        let expected: Vec<Rational> =
            patch.polar_forms().iter().map(|f| f.value(&arguments).unwrap()).collect();
        let value = patch.blossom(&arguments).unwrap();
        prop_assert_eq!(value.coordinates(), expected);
    }

    #[test]
    fn pieces_lie_on_the_surface(patch in any_patch(2), other in any_triangle(), p in plane_point()) {
        let value = patch.value(&p).unwrap();
        let moved = patch.part(other.clone());
        prop_assert_eq!(moved.value(&p).unwrap(), value.clone());
        prop_assert_eq!(moved.part(patch.triangle.clone()), patch.clone());
        match patch.subdivide(&other.corners()[2]) {
            Ok(pieces) => for piece in pieces {
                prop_assert_eq!(piece.value(&p).unwrap(), value.clone());
                prop_assert_eq!(patch.part(piece.triangle.clone()), piece);
            },
            Err(error) => {
                prop_assert_eq!(error, CurveError::Degenerate);
                let lambda = patch.triangle.barycentric(&other.corners()[2]).unwrap();
                prop_assert!(lambda.contains(&z(0)));
            }
        }
    }

    #[test]
    fn elevate_then_reduce(patch in any_patch(2), by in 0usize..3, p in plane_point()) {
        let higher = patch.elevate(by);
        prop_assert_eq!(higher.value(&p), patch.value(&p));
        prop_assert_eq!(&higher.reduce(by).unwrap(), &patch);
        for (form, higher) in patch.polar_forms().iter().zip(higher.polar_forms()) {
            prop_assert_eq!(form.elevate(by), higher);
        }
        let Err(CurveError::NotReducible { degree, exact, .. }) = patch.reduce(9) else { panic!() };
        prop_assert_eq!(degree, patch.degree);
        let reduced = patch.reduce(degree - exact).unwrap();
        prop_assert_eq!(reduced.value(&p), patch.value(&p));
        let top = reduced.power_coefficients().into_iter().filter(|([r, s], _)| r + s == exact);
        prop_assert!(exact == 0 || top.into_iter().any(|(_, c)| c.iter().any(|x| *x != z(0))));
    }

    #[test]
    fn derivatives_agree(patch in any_patch(2), p in plane_point(),
                         directions in prop::collection::vec(plane_point(), 0..5)) {
        let vectors: Vec<Vector<Rational>> = directions.iter().cloned().map(Vector::from).collect();
        let derivative = patch.derivative(&vectors).unwrap();
        for (k, form) in patch.polar_forms().iter().enumerate() {
            let expected = form.derivative(&directions).unwrap().diagonal_at(&p);
            prop_assert_eq!(&derivative.value(&p).unwrap()[k], &expected);
        }
    }

    #[test]
    fn normals_are_cross_products(patch in any_patch(3), p in plane_point()) {
        let (x, y) = (patch.partial_derivative(1, 0), patch.partial_derivative(0, 1));
        let (x, y) = (x.value(&p).unwrap(), y.value(&p).unwrap());
        let expected = polygon::cross(&x, &y, |a, b| a * b, |a, b| a - b);
        let normal = patch.normal().unwrap();
        prop_assert_eq!(normal.value(&p).unwrap(), expected);
        prop_assert_eq!(normal.degree(), 2 * patch.degree.saturating_sub(1));
    }

    #[test]
    fn integrals_agree(patch in any_patch(1)) {
        // ∫∫ x^r y^s over the unit triangle is r! s! / (r + s + 2)!
        let patch = TrianglePatch { triangle: Triangle::unit(), ..patch };
        let expected: Rational = patch.power_coefficients().iter().map(|([r, s], c)| {
            let numerator = crate::math::number::factorial(*r) * crate::math::number::factorial(*s);
            &c[0] * Rational::new(numerator, crate::math::number::factorial(r + s + 2))
        }).sum();
        prop_assert_eq!(patch.integral(), [expected]);
        // and the pieces add up over any triangle
        if let Ok(pieces) = patch.subdivide(&[q(1, 5), q(-3, 7)]) {
            let sum: Rational = pieces.iter().map(|piece| piece.integral()[0].clone()).sum();
            prop_assert_eq!(patch.integral(), [sum]);
        }
    }
}

#[test]
fn edges_and_corners() {
    let points: Vec<Point<Rational>> = (0..6).map(|i| [z(i)].into()).collect();
    let patch = TrianglePatch::new(points, Triangle::unit()).unwrap();
    let edge =
        |corner| patch.boundary(corner).iter().map(|p| p[0].to_integer().to_string()).collect::<String>();
    assert_eq!(edge(Corner::A), "345");
    assert_eq!(edge(Corner::B), "025");
    assert_eq!(edge(Corner::C), "013");
    assert!(patch.permuted([0, 0, 1]).is_none());
}

#[test]
fn bad_patches_are_refused() {
    let new = |points: Vec<Vec<Rational>>| TrianglePatch::new(points, Triangle::unit()).unwrap_err();
    assert_eq!(new(vec![]), CurveError::TooFewPoints { needed: 1, given: 0 });
    assert_eq!(new(vec![vec![z(0)]; 4]), CurveError::NotTriangular { count: 4 });
    assert_eq!(
        new(vec![vec![z(0)], vec![z(0)], vec![]]),
        CurveError::Dimensions { index: 2, found: 0, expected: 1 }
    );
    let patch = TrianglePatch::new(vec![vec![z(0)]; 3], Triangle::unit()).unwrap();
    assert_eq!(patch.value(&[z(0)]), Err(CurveError::DimensionsOf { left: 2, right: 1 }));
    assert_eq!(patch.normal(), Err(CurveError::DimensionsOf { left: 1, right: 3 }));
    assert_eq!(patch.blossom(&[]), Err(CurveError::Arguments { expected: 1, given: 0 }));
    assert!(patch.subdivide(&[q(1, 2), z(0)]).is_err());
}

#[test]
fn a_quadratic_patch_of_symbols() {
    let name = |s: &str| Fraction::from(MultiPoly::symbol(Symbol::new(s)));
    let b = |[i, j, k]: [usize; 3]| name(&format!("b{i}{j}{k}"));
    let points = indices(2).into_iter().map(|index| vec![b(index)]).collect();
    let corner = |s: &str| Point::from([name(&format!("{s}x")), name(&format!("{s}y"))]);
    let corners = [corner("a"), corner("b"), corner("c")];
    let patch = TrianglePatch::new(points, Triangle::new(corners.clone()).unwrap()).unwrap();
    let [a, _, c] = corners.clone().map(|corner| Argument::Point(corner.into()));
    assert_eq!(patch.blossom(&[a, c]), Ok(Argument::Point([b([1, 0, 1])].into())));
    // the derivative along the edge from a to b, at a: 2 (b_110 − b_200)
    let along = patch.derivative(&[&corners[1] - &corners[0]]).unwrap();
    let expected = (b([1, 1, 0]) - b([2, 0, 0])) * Fraction::from(z(2));
    assert_eq!(along.points()[0], [expected]);
}
