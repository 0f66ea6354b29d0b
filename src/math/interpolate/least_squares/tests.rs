use crate::math::interval::Interval;
use nalgebra::DMatrix;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::*;
use crate::math::interpolate::{nodal_polynomial, polynomial_through};
use crate::math::number::{Rational, integer as z, rational as q};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![4 => (-5i64..=5).prop_map(z), 2 => (-9i64..=9, 1i64..=6).prop_map(|(p, d)| q(p, d))]
}

/// Nodes (which may repeat), values and weights.
fn data() -> impl Strategy<Value = (Vec<Rational>, Vec<Rational>, Vec<Rational>)> {
    let weight = prop_oneof![1 => Just(z(0)), 4 => (1i64..5, 1i64..4).prop_map(|(p, d)| q(p, d))];
    prop::collection::vec((number(), number(), weight), 1..9).prop_map(|list| {
        let (mut nodes, mut values, mut weights) = (vec![], vec![], vec![]);
        for (x, y, w) in list {
            nodes.push(x);
            values.push(y);
            weights.push(w);
        }
        (nodes, values, weights)
    })
}

fn distinct_count(nodes: &[Rational], weights: &[Rational]) -> usize {
    let mut kept: Vec<&Rational> =
        nodes.iter().zip(weights).filter(|(_, w)| !w.is_zero()).map(|(x, _)| x).collect();
    kept.sort();
    kept.dedup();
    kept.len()
}

fn horner(p: &[Rational], t: &Rational) -> Rational {
    Coefficients::new(p.to_vec()).value(t)
}

/// The projection onto orthogonal polynomials: p_{k+1} = t p_k made orthogonal to p_0, …, p_k.
fn by_orthogonal_polynomials(
    nodes: &[Rational],
    values: &[Rational],
    weights: &[Rational],
    degree: usize,
) -> Coefficients<Rational> {
    let dot = |f: &[Rational], g: &[Rational]| {
        let terms = f.iter().zip(g).zip(weights);
        terms.fold(Rational::zero(), |sum, ((a, b), w)| sum + a * b * w)
    };
    let at = |p: &Coefficients<Rational>| -> Vec<Rational> { nodes.iter().map(|x| p.value(x)).collect() };
    let mut basis: Vec<Coefficients<Rational>> = Vec::new();
    let mut sum = Coefficients::zero();
    for k in 0..=degree {
        let mut next = Coefficients::new([vec![z(0); k], vec![z(1)]].concat());
        let column = at(&next);
        for p in &basis {
            let factor = dot(&column, &at(p)) / dot(&at(p), &at(p));
            next = next.minus(&p.scaled(&factor));
        }
        let factor = dot(values, &at(&next)) / dot(&at(&next), &at(&next));
        sum = sum.plus(&next.scaled(&factor));
        basis.push(next);
    }
    sum
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn two_ways_and_three_bases((nodes, values, weights) in data(), degree in 0usize..4, other in number()) {
        let fit = |basis: Basis<Rational>| {
            let options = FitOptions { basis, weights: Some(weights.clone()), conditions: vec![] };
            fit_polynomial(&nodes, &values, degree, options)
        };
        let distinct = distinct_count(&nodes, &weights);
        let power = fit(Basis::Power);
        if distinct <= degree {
            prop_assert_eq!(power, Err(InterpolationError::TooFewNodes { degree, distinct }));
            return Ok(());
        }
        let power = power.unwrap();
        prop_assert_eq!(&power.solution.coefficients, &power.power);
        prop_assert_eq!(&power.power, &by_orthogonal_polynomials(&nodes, &values, &weights, degree).padded(degree));
        let bernstein = fit(Basis::Bernstein(Interval::new(other.clone(), other + z(3)).unwrap())).unwrap();
        prop_assert_eq!(&bernstein.power, &power.power);
        prop_assert_eq!(&bernstein.solution.residuals, &power.solution.residuals);
        for fit in [&power, &bernstein] {
            prop_assert!(fit.solution.orthogonality().iter().all(Zero::is_zero));
        }
        // no other polynomial is closer
        let norm = |p: &[Rational]| {
            let terms = nodes.iter().zip(&values).zip(&weights);
            terms.fold(z(0), |sum, ((x, y), w)| {
                let r = y - horner(p, x);
                sum + &r * &r * w
            })
        };
        prop_assert_eq!(norm(&power.power), power.solution.squared_norm.clone());
        prop_assert!(!power.solution.squared_norm.is_negative());
        for i in 0..=degree {
            let mut moved = power.power.clone();
            moved[i] += q(1, 1000);
            prop_assert!(norm(&moved) > power.solution.squared_norm);
        }
        if distinct == degree + 1 && distinct == nodes.len() {
            prop_assert_eq!(&power.power, &polynomial_through(&nodes, &values).unwrap());
            prop_assert!(power.solution.squared_norm.is_zero());
        }
    }

    /// With conditions f(x) = y the fit is p + ω g, p interpolating them and g fitted to the rest.
    #[test]
    fn conditions((nodes, values, weights) in data(), places in prop::collection::vec((number(), number()), 1..3), free in 0usize..3) {
        prop_assume!(places.len() == 1 || places[0].0 != places[1].0);
        let degree = places.len() + free;
        let options = FitOptions { weights: Some(weights.clone()), conditions: places.clone(), ..FitOptions::default() };
        let fit = fit_polynomial(&nodes, &values, degree, options);
        let (at, targets): (Vec<_>, Vec<_>) = places.into_iter().unzip();
        let product = nodal_polynomial(&at);
        let start = polynomial_through(&at, &targets).unwrap();
        let matrix = DMatrix::from_fn(nodes.len(), free + 1, |i, j| {
            horner(&product, &nodes[i]) * num_traits::pow(nodes[i].clone(), j)
        });
        let rest: Vec<Rational> = nodes.iter().zip(&values).map(|(x, y)| y - horner(&start, x)).collect();
        match (fit, least_squares(&matrix, &rest, Some(&weights))) {
            (Ok(fit), Ok(other)) => {
                let product = Coefficients::new(product).times(&other.coefficients.into());
                let sum = Coefficients::new(start).plus(&product);
                prop_assert_eq!(sum, Coefficients::new(fit.power.clone()));
                prop_assert_eq!(&fit.solution.squared_norm, &other.squared_norm);
                prop_assert!(fit.solution.orthogonality().iter().all(Zero::is_zero));
                for (x, y) in at.iter().zip(&targets) {
                    prop_assert_eq!(&horner(&fit.power, x), y);
                }
            }
            (Err(error), Err(InterpolationError::DependentColumns { .. })) => {
                prop_assert!(matches!(error, InterpolationError::TooFewNodes { .. }), "{error}");
            }
            (fit, other) => prop_assert!(false, "{fit:?} {other:?}"),
        }
    }

    #[test]
    fn points_are_their_coordinates((nodes, values, weights) in data()) {
        prop_assume!(distinct_count(&nodes, &weights) >= 2);
        let points: Vec<Vec<Rational>> = values.iter().zip(&nodes).map(|(y, x)| vec![y.clone(), x * x]).collect();
        let options = || FitOptions { weights: Some(weights.clone()), ..FitOptions::default() };
        let fit = fit_polynomial(&nodes, &points, 1, FitOptions { basis: Basis::Power, weights: Some(weights.clone()), conditions: vec![] }).unwrap();
        let mut norm = z(0);
        for k in 0..2 {
            let column: Vec<Rational> = points.iter().map(|p| p[k].clone()).collect();
            let one = fit_polynomial(&nodes, &column, 1, options()).unwrap();
            for (c, d) in fit.power.iter().zip(&one.power) {
                prop_assert_eq!(&c[k], d);
            }
            norm += one.solution.squared_norm;
        }
        prop_assert_eq!(norm, fit.solution.squared_norm);
    }
}

#[test]
fn a_textbook_system() {
    // the parabola closest to 1, 0, 0, 2 at −1, 0, 1, 2, by hand: the normal equations
    let fit = fit_polynomial(&[-1, 0, 1, 2].map(z), &[1, 0, 0, 2].map(z), 2, FitOptions::default()).unwrap();
    let normal = DMatrix::from_row_slice(3, 3, &[4, 2, 6, 2, 6, 8, 6, 8, 18].map(z));
    assert_eq!(fit.solution.normal_matrix, normal);
    assert_eq!(fit.solution.normal_right, [3, 3, 9].map(z));
    assert_eq!(fit.power, [q(-3, 20), q(-9, 20), q(3, 4)]);
    assert_eq!(fit.solution.residuals, [q(-1, 20), q(3, 20), q(-3, 20), q(1, 20)]);
    assert_eq!(fit.solution.squared_norm, q(1, 20));
}

fn s(name: &str) -> Fraction {
    Fraction::from(MultiPoly::symbol(Symbol::new(name)))
}

#[test]
fn symbolic_data() {
    // the weighted mean
    let ones = DMatrix::from_element(2, 1, Fraction::one());
    let fit = least_squares(&ones, &[s("x"), s("y")], Some(&[s("v"), s("w")])).unwrap();
    let mean = (s("v") * s("x") + s("w") * s("y")) / (s("v") + s("w"));
    assert_eq!(fit.coefficients, [mean]);
    assert!(fit.orthogonality()[0].is_zero());
    // weights that cancel
    let weights = [s("w"), -s("w")];
    let error = least_squares(&ones, &[s("x"), s("y")], Some(&weights)).unwrap_err();
    assert_eq!(error, InterpolationError::Singular { unknowns: 1, rank: 0 });
}

#[test]
fn errors_name_the_offender() {
    use InterpolationError as E;
    let (nodes, values) = ([0, 1, 1].map(z), [0, 1, 2].map(z));
    let plain = FitOptions::<Rational>::default;
    let error = fit_polynomial(&nodes, &values, 2, plain()).unwrap_err();
    assert_eq!(error.to_string(), "degree 2 needs 3 distinct nodes of weight other than 0, there are 2");
    let weights = Some(vec![z(1), z(-1), z(1)]);
    let options = FitOptions { weights, ..plain() };
    assert_eq!(fit_polynomial(&nodes, &values, 1, options), Err(E::NegativeWeight { index: 1 }));
    let options = FitOptions { weights: Some(vec![z(1)]), ..plain() };
    assert!(matches!(fit_polynomial(&nodes, &values, 1, options), Err(E::Lengths { what: "weights", .. })));
    let options = FitOptions { conditions: vec![(z(1), z(0)), (z(1), z(0))], ..plain() };
    assert_eq!(fit_polynomial(&nodes, &values, 2, options), Err(E::EqualNodes { first: 0, second: 1 }));
    let options = FitOptions { conditions: vec![(z(1), z(0)), (z(2), z(0))], ..plain() };
    assert_eq!(
        fit_polynomial(&nodes, &values, 0, options),
        Err(E::TooManyConditions { conditions: 2, unknowns: 1 })
    );
    let options = FitOptions { basis: Basis::Lagrange(vec![z(1)]), ..plain() };
    assert!(matches!(fit_polynomial(&nodes, &values, 1, options), Err(E::Basis(_))));
    let same = DMatrix::from_row_slice(2, 2, &[1, 2, 2, 4].map(z));
    assert_eq!(least_squares(&same, &values[..2], None), Err(E::DependentColumns { column: 1 }));
    let given = Conditions { matrix: same, values: vec![z(0), z(0)] };
    let identity = DMatrix::identity(2, 2);
    assert_eq!(
        least_squares_under(&identity, &values[..2], None, &given),
        Err(E::DependentCondition { index: 1 })
    );
    assert!(least_squares(&DMatrix::<Rational>::zeros(0, 1), &[] as &[Rational], None).is_err());
    let none = least_squares(&DMatrix::zeros(2, 0), &values[1..], None).unwrap();
    assert_eq!((none.squared_norm, none.coefficients), (z(5), vec![]));
}
