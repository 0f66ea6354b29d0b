use nalgebra::DMatrix;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::*;
use crate::math::linalg::{determinant, solve};
use crate::math::number::{Rational, integer as z, rational as q};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-4i64..=4).prop_map(z),
        2 => (-9i64..=9, 1i64..=6).prop_map(|(p, d)| q(p, d)),
        1 => any::<i64>().prop_map(z),
    ]
}

/// Increasing nodes, as many as values; equal steps are likely.
fn data(most: usize) -> impl Strategy<Value = (Vec<Rational>, Vec<Rational>)> {
    let step = prop_oneof![3 => Just(z(1)), 2 => (1i64..20, 1i64..9).prop_map(|(p, d)| q(p, d)), 1 => Just(q(1, 1 << 40))];
    (number(), prop::collection::vec(step, 1..most), prop::collection::vec(number(), most)).prop_map(
        |(start, steps, mut values)| {
            let mut nodes = vec![start];
            for step in steps {
                nodes.push(nodes.last().unwrap() + step);
            }
            values.truncate(nodes.len());
            (nodes, values)
        },
    )
}

fn end() -> impl Strategy<Value = End<Rational>> {
    prop_oneof![
        Just(End::Natural),
        number().prop_map(End::Slope),
        number().prop_map(End::SecondDerivative),
        Just(End::NotAKnot),
    ]
}

fn horner(p: &[Rational], t: &Rational) -> Rational {
    Coefficients::new(p.to_vec()).value(t)
}

fn derivative(p: &[Rational], k: usize) -> Vec<Rational> {
    Coefficients::new(p.to_vec()).nth_derivative(k).into_vec()
}

/// Everything that makes it the spline of its data.
fn check(spline: &CubicSpline<Rational>) {
    let (nodes, n) = (spline.nodes(), spline.pieces());
    let function = spline.to_piecewise().remove(0);
    for (i, (x, y)) in nodes.iter().zip(spline.values()).enumerate() {
        assert_eq!(function.value(x).unwrap(), *y);
        assert_eq!(function.nth_derivative(1).value(x).unwrap(), spline.slopes()[i]);
        assert_eq!(function.nth_derivative(2).value(x).unwrap(), spline.moments()[i]);
        if i > 0 && i < n {
            assert!(function.smoothness(i) >= Some(2.min(function.degree())));
        }
    }
    for i in 0..n {
        let (a, b) = (&nodes[i], &nodes[i + 1]);
        let power = spline.power(i);
        let middle = (a + b) * q(1, 3);
        let [alpha, beta, gamma, eta] = spline.moment_form(i);
        let (left, right) = (b - &middle, &middle - a);
        let cube = |x: &Rational| num_traits::pow(x.clone(), 3);
        let value = alpha * cube(&left) + beta * cube(&right) + gamma * left + eta * right;
        assert_eq!(value, horner(&power, &middle));
    }
    let solution = match spline.system().unknowns {
        Unknowns::Moments => spline.moments(),
        Unknowns::Slopes => spline.slopes(),
    };
    let system = spline.system();
    assert_eq!(system.matrix.product(&solution[system.first..]), system.right);
    // ∫ S''² the other way
    let second = function.nth_derivative(2);
    assert_eq!(second.map(|p| p.times(p)).integral(), spline.bending_energy());

    let first_piece = |k: usize| horner(&derivative(&spline.power(0), k), &nodes[0]);
    let last_piece = |k: usize| horner(&derivative(&spline.power(n - 1), k), &nodes[n]);
    match spline.ends() {
        Ends::Periodic => {
            for k in 0..3 {
                assert_eq!(first_piece(k), last_piece(k));
            }
        }
        Ends::Each { first, last } => {
            let holds = |end: &End<Rational>, at: &dyn Fn(usize) -> Rational, inner: usize| match end {
                End::Natural => at(2).is_zero(),
                End::Slope(slope) => at(1) == *slope,
                End::SecondDerivative(second) => at(2) == *second,
                End::NotAKnot if n > 1 => function.smoothness(inner) == Some(function.degree()),
                End::NotAKnot => function.degree() < 3,
            };
            assert!(holds(first, &first_piece, 1));
            assert!(holds(last, &last_piece, n.max(2) - 1));
            if n <= 2 && (first, last) == (&End::NotAKnot, &End::NotAKnot) {
                assert!(function.degree() <= n);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn moments_and_slopes_agree((nodes, values) in data(7), first in end(), last in end()) {
        let ends = Ends::Each { first, last };
        let spline = CubicSpline::by_moments(&nodes, &values, ends.clone()).unwrap();
        let other = CubicSpline::by_slopes(&nodes, &values, ends).unwrap();
        prop_assert_eq!(spline.moments(), other.moments());
        prop_assert_eq!(spline.slopes(), other.slopes());
        check(&spline);
        check(&other);
    }

    #[test]
    fn periodic_splines((nodes, mut values) in data(8)) {
        values[nodes.len() - 1] = values[0].clone();
        let spline = CubicSpline::by_moments(&nodes, &values, Ends::Periodic).unwrap();
        let other = CubicSpline::by_slopes(&nodes, &values, Ends::Periodic).unwrap();
        prop_assert_eq!(spline.moments(), other.moments());
        check(&spline);
        check(&other);
    }

    #[test]
    fn cubics_are_reproduced((nodes, cubic) in data(7), second in any::<bool>()) {
        let mut cubic = cubic;
        cubic.resize(4, z(1));
        let values: Vec<Rational> = nodes.iter().map(|x| horner(&cubic, x)).collect();
        let at = |k: usize, x: &Rational| horner(&derivative(&cubic, k), x);
        let n = nodes.len() - 1;
        let mut all = vec![if second {
            Ends::second_derivatives(at(2, &nodes[0]), at(2, &nodes[n]))
        } else {
            Ends::clamped(at(1, &nodes[0]), at(1, &nodes[n]))
        }];
        if n >= 3 {
            all.push(Ends::not_a_knot());
        }
        if n >= 2 {
            all.push(Ends::Each { first: End::NotAKnot, last: End::Slope(at(1, &nodes[n])) });
        }
        for ends in all {
            let spline = CubicSpline::by_moments(&nodes, &values, ends).unwrap();
            for i in 0..n {
                prop_assert_eq!(spline.power(i), cubic.clone());
            }
        }
    }

    /// ∫ S''² is least for the natural spline, and for the clamped one among equal end slopes: the
    /// difference to any other C² interpolant is the energy of their difference.
    #[test]
    fn natural_splines_bend_least((nodes, values) in data(6), slope in number(), other in number()) {
        let natural = CubicSpline::by_moments(&nodes, &values, Ends::natural()).unwrap();
        let bent = CubicSpline::by_moments(&nodes, &values, Ends::clamped(slope, other)).unwrap();
        prop_assert!(natural.bending_energy() <= bent.bending_energy());
        let differences: Vec<Rational> = values.iter().map(|_| z(0)).collect();
        let slopes = |i: usize| &bent.slopes()[i] - &natural.slopes()[i];
        let ends = Ends::clamped(slopes(0), slopes(nodes.len() - 1));
        let difference = CubicSpline::by_slopes(&nodes, &differences, ends).unwrap();
        prop_assert_eq!(
            bent.bending_energy(),
            natural.bending_energy() + difference.bending_energy()
        );
    }

    #[test]
    fn points_are_their_coordinates((nodes, values) in data(6), others in prop::collection::vec(number(), 6)) {
        let points: Vec<Vec<Rational>> =
            values.iter().zip(&others).map(|(x, y)| vec![x.clone(), y.clone()]).collect();
        let spline = CubicSpline::by_moments(&nodes, &points, Ends::not_a_knot()).unwrap();
        let functions = spline.to_piecewise();
        for (k, values) in [&values[..], &others[..nodes.len()]].into_iter().enumerate() {
            let one = CubicSpline::by_moments(&nodes, values, Ends::not_a_knot()).unwrap();
            prop_assert_eq!(&functions[k], &one.to_piecewise()[0]);
        }
    }

    #[test]
    fn tridiagonal_systems(
        entries in prop::collection::vec((-1i64..=2, -1i64..=2, -1i64..=2, -3i64..=3), 1..7),
        cyclic in any::<bool>(),
    ) {
        let n = entries.len();
        let column = |pick: fn(&(i64, i64, i64, i64)) -> i64| entries.iter().map(|e| z(pick(e))).collect::<Vec<_>>();
        let matrix = Tridiagonal::new(column(|e| e.0), column(|e| e.1), column(|e| e.2), cyclic).unwrap();
        let right = column(|e| e.3);
        let dense = matrix.matrix();
        let expected = solve(&dense, &DMatrix::from_column_slice(n, 1, &right));
        match matrix.solve(&right) {
            Ok(x) => {
                prop_assert_eq!(matrix.product(&x), right);
                let expected = expected.unwrap();
                prop_assert_eq!(expected.as_slice(), &x[..]);
            }
            Err(error) => {
                prop_assert_eq!(determinant(&dense), Ok(z(0)));
                let rank = crate::math::linalg::rank(&dense);
                prop_assert_eq!(error, InterpolationError::Singular { unknowns: n, rank });
            }
        }
    }
}

/// Burden, Faires, *Numerical Analysis*, section 3.5: data (1, 2), (2, 3), (3, 5).
#[test]
fn textbook_splines() {
    let (nodes, values) = ([1, 2, 3].map(z), [2, 3, 5].map(z));
    let natural = CubicSpline::by_moments(&nodes, &values, Ends::natural()).unwrap();
    assert_eq!(natural.taylor(0), [z(2), q(3, 4), z(0), q(1, 4)]);
    assert_eq!(natural.taylor(1), [z(3), q(3, 2), q(3, 4), q(-1, 4)]);
    let clamped = CubicSpline::by_slopes(&nodes, &values, Ends::clamped(z(2), z(1))).unwrap();
    assert_eq!(clamped.taylor(0), [z(2), z(2), q(-5, 2), q(3, 2)]);
    assert_eq!(clamped.taylor(1), [z(3), q(3, 2), z(2), q(-3, 2)]);
}

/// Values that SymPy found by solving the 4n equations of all coefficients, and by its
/// `interpolating_spline`, which has not-a-knot ends.
#[test]
fn checked_with_sympy() {
    let (nodes, values) = ([0, 1, 3, 4, 7, 8].map(z), [0, 1, -2, 3, 3, 1].map(z));
    let spline = CubicSpline::by_moments(&nodes, &values, Ends::not_a_knot()).unwrap();
    let function = spline.to_piecewise().remove(0);
    let second = function.nth_derivative(2);
    for (t, value, bend) in [
        (q(1, 2), q(2941, 2184), q(-1849, 273)),
        (q(5, 2), q(-1849, 728), q(1069, 195)),
        (q(15, 2), q(2939, 1560), q(181, 195)),
    ] {
        assert_eq!(function.value(&t), Ok(value));
        assert_eq!(second.value(&t), Ok(bend));
    }
    let ends = Ends::Each { first: End::Natural, last: End::Slope(z(3)) };
    let spline = CubicSpline::by_slopes(&[0, 1, 3, 4].map(z), &[0, 2, -1, 1].map(z), ends).unwrap();
    assert_eq!(spline.power(0), [z(0), q(333, 116), z(0), q(-101, 116)]);
    assert_eq!(spline.power(1), [q(-403, 232), q(1875, 232), q(-1209, 232), q(201, 232)]);
    assert_eq!(spline.power(2), [q(1249, 29), q(-1065, 29), q(282, 29), q(-23, 29)]);
    let values = [0, 2, -1, 0].map(z);
    let spline = CubicSpline::by_moments(&[0, 1, 3, 4].map(z), &values, Ends::Periodic).unwrap();
    assert_eq!(spline.power(0), [z(0), q(9, 4), q(9, 10), q(-23, 20)]);
    assert_eq!(spline.power(1), [q(-19, 10), q(159, 20), q(-24, 5), q(3, 4)]);
    assert_eq!(spline.power(2), [q(139, 5), q(-87, 4), q(51, 10), q(-7, 20)]);
}

/// The natural spline of e_2 on 0, …, 4, its moments by hand.
#[test]
fn a_cardinal_spline() {
    let nodes = [0, 1, 2, 3, 4].map(z);
    let spline = CubicSpline::by_moments(&nodes, &[0, 0, 1, 0, 0].map(z), Ends::natural()).unwrap();
    // M_1 = M_3 = a, M_2 = b with 4a + b = 6 and 2a + 4b = −12
    assert_eq!(spline.moments(), [z(0), q(18, 7), q(-30, 7), q(18, 7), z(0)]);
    let system = spline.system();
    assert_eq!(system.matrix.lower(), [z(0), q(1, 2), q(1, 2), q(1, 2), z(0)]);
    assert_eq!(system.matrix.diagonal(), [z(2), z(2), z(2), z(2), z(2)]);
    assert_eq!(system.right, [0, 3, -6, 3, 0].map(z));
}

/// The system of a periodic spline, with its corners.
#[test]
fn a_periodic_system() {
    let (nodes, values) = ([0, 1, 3, 4].map(z), [0, 1, -1, 0].map(z));
    let system = Steps::new(&nodes, &values, &Ends::Periodic)
        .and_then(|steps| steps.system(Unknowns::Moments, &Ends::Periodic))
        .unwrap();
    assert_eq!(system.first, 1);
    let expected = [z(2), q(2, 3), q(1, 3), q(2, 3), z(2), q(1, 3), q(1, 2), q(1, 2), z(2)];
    assert_eq!(system.matrix.matrix(), DMatrix::from_row_slice(3, 3, &expected));
    assert_eq!(system.right, [-4, 4, 0].map(z));
    assert_eq!(system.solve().unwrap(), [-3, 3, 0].map(z));
    // one period of one piece is a constant
    let spline = CubicSpline::by_slopes(&[0, 1].map(z), &[5, 5].map(z), Ends::Periodic).unwrap();
    assert_eq!(spline.power(0), [5, 0, 0, 0].map(z));
}

#[test]
fn few_points() {
    let line = CubicSpline::by_moments(&[0, 2].map(z), &[1, 5].map(z), Ends::not_a_knot()).unwrap();
    assert_eq!(line.power(0), [1, 2, 0, 0].map(z));
    let parabola = CubicSpline::by_slopes(&[0, 1, 3].map(z), &[0, 1, 9].map(z), Ends::not_a_knot()).unwrap();
    assert_eq!(parabola.power(0), [0, 0, 1, 0].map(z));
    assert_eq!(parabola.power(1), [0, 0, 1, 0].map(z));
    let ends = Ends::Each { first: End::Slope(z(0)), last: End::NotAKnot };
    let parabola = CubicSpline::by_moments(&[0, 2].map(z), &[0, 4].map(z), ends).unwrap();
    assert_eq!(parabola.power(0), [0, 0, 1, 0].map(z));
}

/// Equal steps make the pivot of the first row of a not-a-knot system 0.
#[test]
fn many_nodes() {
    let nodes: Vec<Rational> = (0..120).map(z).collect();
    let values: Vec<Rational> = (0..120).map(|i| z(i * i % 7)).collect();
    let spline = CubicSpline::by_moments(&nodes, &values, Ends::not_a_knot()).unwrap();
    let other = CubicSpline::by_slopes(&nodes, &values, Ends::not_a_knot()).unwrap();
    assert_eq!(spline.moments(), other.moments());
    assert!(spline.system().matrix.diagonal()[0].is_zero());
}

fn s(name: &str) -> Fraction {
    Fraction::from(MultiPoly::symbol(Symbol::new(name)))
}

#[test]
fn symbolic_splines() {
    // M_1 = 3 f[x_0, x_1, x_2] for the natural spline of three points
    let (nodes, values) = ([s("a"), s("b"), s("c")], [s("u"), s("v"), s("w")]);
    let natural = CubicSpline::by_moments(&nodes, &values, Ends::natural()).unwrap();
    let table = crate::math::interpolate::DividedDifferences::new(&nodes, &values).unwrap();
    let three = Fraction::from_rational(&z(3));
    assert_eq!(natural.moments()[1], table.column(2)[0].clone() * three);
    let ends = Ends::Each { first: End::NotAKnot, last: End::Slope(s("m")) };
    let spline = CubicSpline::by_slopes(&nodes, &values, ends.clone()).unwrap();
    let other = CubicSpline::by_moments(&nodes, &values, ends).unwrap();
    assert_eq!(spline.moments(), other.moments());
    assert_eq!(spline.power(0), spline.power(1));
}

#[test]
fn errors_name_the_offender() {
    use InterpolationError as E;
    let new = |nodes: &[Rational], values: &[Rational], ends| CubicSpline::by_moments(nodes, values, ends);
    assert_eq!(new(&[z(0)], &[z(0)], Ends::natural()), Err(E::TooFewPoints { needed: 2, given: 1 }));
    let (down, three) = ([0, 2, 1].map(z), [0, 0, 0].map(z));
    assert_eq!(new(&down, &three, Ends::natural()), Err(E::NotIncreasing { index: 2 }));
    let equal = [0, 1, 1].map(z);
    assert_eq!(new(&equal, &three, Ends::natural()), Err(E::EqualNodes { first: 1, second: 2 }));
    let open = [0, 1, 2].map(z);
    assert_eq!(new(&open, &open, Ends::Periodic), Err(E::NotPeriodic));
    assert!(matches!(new(&open, &open[..2], Ends::natural()), Err(E::Lengths { given: 2, .. })));
    let ragged = CubicSpline::by_moments(
        &open[..2],
        &[vec![z(0)], vec![z(1)]],
        Ends::clamped(vec![z(1), z(2)], vec![z(1)]),
    );
    assert_eq!(ragged, Err(E::Dimensions { what: "end", index: 0, given: 2, needed: 1 }));
    // symbolic nodes that cannot increase
    let twice = [s("a"), s("b"), s("a")];
    let ends = Ends::natural();
    assert_eq!(CubicSpline::by_moments(&twice, &twice, ends), Err(E::EqualNodes { first: 0, second: 2 }));
    assert!(Tridiagonal::<Rational>::new(vec![], vec![], vec![], true).is_err());
    let spline = new(&open, &open, Ends::natural()).unwrap();
    assert!(spline.bending_energy().is_zero() && !spline.bending_energy().is_negative());
    assert!(spline.slopes().iter().all(One::is_one));
}
