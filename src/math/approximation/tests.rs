use super::*;
use crate::math::blossom::PolarForm;
use crate::math::curve::{BezierCurve, Interval, Point};
use crate::math::linalg::{inverse, multiply};
use crate::math::number::{Rational, integer as z, rational as q};
use crate::math::poly::Coefficients;
use crate::math::spline::{BSpline, KnotVector};
use nalgebra::DMatrix;
use num_traits::Zero;
use proptest::prelude::*;

fn number() -> impl Strategy<Value = Rational> {
    (-30i64..30, 1i64..7).prop_map(|(p, r)| q(p, r))
}

/// Increasing knots with steps of 0 to 3, no longer repeated than allowed, that have a domain.
fn any_knots() -> impl Strategy<Value = KnotVector<Rational>> {
    (0usize..4, prop::collection::vec(0i64..4, 4..12)).prop_filter_map("no domain", |(n, steps)| {
        let mut at = z(-3);
        let knots = steps.iter().map(|&step| {
            at += q(step, 2);
            at.clone()
        });
        KnotVector::new(n, knots.collect()).ok().filter(|knots| knots.interval().is_ok())
    })
}

/// ∫ F G over [a, b] by powers of t.
fn by_powers(f: &Coefficients<Rational>, g: &Coefficients<Rational>, a: &Rational, b: &Rational) -> Rational {
    let primitive = f.times(g).antiderivative();
    primitive.value(b) - primitive.value(a)
}

fn power(points: &[Rational], interval: &Interval<Rational>) -> Coefficients<Rational> {
    Coefficients::new(PolarForm::from_bezier_points_over(points, interval).unwrap().diagonal().into_vec())
}

fn unit(n: usize, i: usize) -> Vec<Rational> {
    (0..=n).map(|k| z(i64::from(k == i))).collect()
}

/// N_j at the nodes, as splines with one control point 1.
fn values_by_blossom(knots: &KnotVector<Rational>, nodes: &[Rational]) -> DMatrix<Rational> {
    let unit = |j: usize| (0..knots.count()).map(|k| vec![z(i64::from(k == j))]).collect();
    let functions: Vec<_> =
        (0..knots.count()).map(|j| BSpline::new(knots.clone(), unit(j)).unwrap()).collect();
    DMatrix::from_fn(nodes.len(), knots.count(), |i, j| functions[j].value(&nodes[i]).unwrap()[0].clone())
}

fn curve(points: &[Rational], interval: &Interval<Rational>) -> BezierCurve<Rational> {
    BezierCurve::new(points.iter().map(|x| vec![x.clone()]).collect(), interval.clone()).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn gram_matrices_are_integrals(n in 0usize..6, r in 0usize..4, a in number(), w in 1i64..9) {
        let b = &a + q(w, 3);
        let interval = Interval::new(a.clone(), b.clone()).unwrap();
        let gram = bernstein_gram(n, &interval, r);
        for i in 0..=n {
            for j in 0..=n {
                let [f, g] = [i, j].map(|k| power(&unit(n, k), &interval).nth_derivative(r));
                prop_assert_eq!(&gram[(i, j)], &by_powers(&f, &g, &a, &b));
            }
        }
    }

    #[test]
    fn spline_gram_matrices_are_integrals(knots in any_knots(), r in 0usize..3) {
        let gram = spline_gram(&knots, r).unwrap();
        let functions = knots.basis_functions();
        let (start, end) = knots.interval().unwrap().ends();
        for (i, f) in functions.iter().enumerate() {
            for (j, g) in functions.iter().enumerate() {
                let mut expected = z(0);
                for span in knots.spans() {
                    let (a, b) = (&knots.knots()[span], &knots.knots()[span + 1]);
                    let middle = (a + b) / z(2);
                    let piece = |f: &crate::math::piecewise::Piecewise<Rational>| match f.locate(&middle) {
                        Ok(k) => f.pieces()[k].nth_derivative(r),
                        Err(_) => Coefficients::zero(),
                    };
                    expected += by_powers(&piece(f), &piece(g), a, b);
                }
                prop_assert_eq!(&gram[(i, j)], &expected, "{} {} on [{}, {}]", i, j, start, end);
            }
        }
    }

    #[test]
    fn an_energy_is_a_form_of_the_control_points(knots in any_knots(), r in 0usize..3, seed in 0u64..1000) {
        let value = |i: usize| q(((seed >> (i % 10)) % 13) as i64 - 6, 1 + (i % 3) as i64);
        let d: Vec<Rational> = (0..knots.count()).map(value).collect();
        let s = BSpline::new(knots.clone(), d.iter().map(|x| vec![x.clone()]).collect()).unwrap();
        let column = DMatrix::from_vec(d.len(), 1, d);
        let gram = spline_gram(&knots, r).unwrap();
        let form = multiply(&multiply(&column.transpose(), &gram).unwrap(), &column).unwrap();
        prop_assert_eq!(&form[(0, 0)], &spline_energy(&s, r));
    }

    #[test]
    fn the_nearest_curve_is_orthogonal_to_its_residual(
        points in prop::collection::vec(number(), 1..7), drop in 0usize..4, ends in 0usize..3, w in 1i64..9
    ) {
        let interval = Interval::new(z(-1), q(w, 2)).unwrap();
        let c = curve(&points, &interval);
        let n = c.degree();
        let Some(m) = n.checked_sub(drop) else {
            return Ok(());
        };
        let found = match best_reduction(&c, m, ends) {
            Ok(found) => found,
            Err(error) => {
                prop_assert_eq!(error, ApproximationError::TooManyEnds { fixed: 2 * ends, points: m + 1 });
                prop_assert!(2 * ends > m + 1);
                return Ok(());
            }
        };
        let (a, b) = interval.ends();
        let own: Vec<Rational> = found.points().iter().map(|p| p[0].clone()).collect();
        let residual = power(&points, &interval).minus(&power(&own, &interval));
        for i in ends..=m.saturating_sub(ends) {
            if i + ends <= m {
                prop_assert!(by_powers(&residual, &power(&unit(m, i), &interval), a, b).is_zero(), "{}", i);
            }
        }
        for r in 0..ends {
            prop_assert!(residual.nth_derivative(r).value(a).is_zero());
            prop_assert!(residual.nth_derivative(r).value(b).is_zero());
        }
        if drop == 0 {
            prop_assert!(by_powers(&residual, &residual, a, b).is_zero());
        }
        if ends == 0 {
            // the same by the dual basis
            let column = DMatrix::from_fn(m + 1, 1, |i, _| {
                by_powers(&power(&points, &interval), &power(&unit(m, i), &interval), a, b) / (b - a)
            });
            let dual = multiply(&dual_bernstein(m), &column).unwrap();
            prop_assert_eq!(dual.as_slice(), &own[..]);
        }
    }

    #[test]
    fn functionals_give_control_points(knots in any_knots(), k in 0i64..7, seed in 0i64..1000) {
        let n = knots.degree();
        let value = |i: usize| q((seed * (i as i64 + 3)) % 17 - 8, 1 + (i % 3) as i64);
        let s = BSpline::new(knots.clone(), (0..knots.count()).map(|i| vec![value(i)]).collect()).unwrap();
        for (span, piece) in knots.spans().into_iter().zip(s.power_pieces()[0].pieces()) {
            let (a, b) = (&knots.knots()[span], &knots.knots()[span + 1]);
            let tau = a + (b - a) * q(k, 6);
            for i in span - n..=span {
                let weights = de_boor_fix(knots.label(i), &tau);
                let sum = (0..=n).fold(z(0), |sum, r| sum + &weights[r] * piece.nth_derivative(r).value(&tau));
                prop_assert_eq!(&sum, &s.points()[i][0]);
            }
        }
    }

    /// The weights against ψ, expanded and differentiated.
    #[test]
    fn functionals_by_the_formula_of_de_boor_and_fix(label in prop::collection::vec(number(), 0..6), tau in number()) {
        let n = label.len();
        let psi = label.iter().fold(Coefficients::constant(z(1)), |p, u| {
            p.times(&Coefficients::new(vec![u.clone(), z(-1)]))
        });
        let factorial = (1..=n as i64).fold(z(1), |product, k| product * z(k));
        let expected = (0..=n).map(|r| {
            let sign = if (n - r) % 2 == 0 { z(1) } else { z(-1) };
            psi.nth_derivative(n - r).value(&tau) * sign / &factorial
        });
        prop_assert_eq!(de_boor_fix(&label, &tau), expected.collect::<Vec<_>>());
    }

    #[test]
    fn splines_take_their_values(
        n in 0usize..5, steps in prop::collection::vec(1i64..6, 2..10), values in prop::collection::vec(number(), 10)
    ) {
        let mut at = z(-2);
        let nodes: Vec<Rational> = steps.iter().map(|&step| { at += q(step, 3); at.clone() }).collect();
        let values: Vec<Point<Rational>> =
            nodes.iter().zip(values).map(|(x, y)| [y.clone(), x * y].into()).collect();
        if nodes.len() < n + 1 {
            prop_assert!(averaged_knots(n, &nodes).is_err());
            return Ok(());
        }
        let knots = averaged_knots(n, &nodes).unwrap();
        let s = interpolating_spline(knots.clone(), &nodes, &values).unwrap();
        for (x, y) in nodes.iter().zip(&values) {
            prop_assert_eq!(&s.value(x).unwrap(), y);
        }
        // As many nodes as functions: the best fit is the interpolant; a heavy penalty costs accuracy.
        let fit = fitted_spline(knots.clone(), &nodes, &values, None, None).unwrap();
        prop_assert_eq!(fit.points(), s.points());
        let smoothing = Smoothing { weight: z(5), order: 1 };
        let smooth = fitted_spline(knots, &nodes, &values, None, Some(&smoothing)).unwrap();
        prop_assert!(spline_energy(&smooth, 1) <= spline_energy(&s, 1));
    }

    /// No other spline is nearer: in every direction the derivative of what is made least vanishes.
    #[test]
    fn fits_are_least(
        knots in any_knots(), places in prop::collection::vec(0i64..24, 1..14),
        weights in prop::collection::vec(0i64..3, 14), penalty in prop::option::of((1i64..4, 0usize..3))
    ) {
        let (a, b) = knots.interval().unwrap().ends();
        let mut places = places;
        places.sort_unstable();
        let nodes: Vec<Rational> = places.iter().map(|&k| a + (b - a) * q(k, 23).min(z(1))).collect();
        let values: Vec<Point<Rational>> = places.iter().map(|&k| [z((k * k) % 7)].into()).collect();
        let weights: Vec<Rational> = weights[..nodes.len()].iter().map(|&w| z(w)).collect();
        let smoothing = penalty.map(|(weight, order)| Smoothing { weight: z(weight), order });
        let found = fitted_spline(knots.clone(), &nodes, &values, Some(&weights), smoothing.as_ref());
        let matrix = values_by_blossom(&knots, &nodes);
        let weighted = DMatrix::from_fn(nodes.len(), knots.count(), |i, j| &matrix[(i, j)] * &weights[i]);
        let mut normal = multiply(&matrix.transpose(), &weighted).unwrap();
        if let Some(smoothing) = &smoothing {
            normal += spline_gram(&knots, smoothing.order).unwrap().map(|x| x * &smoothing.weight);
        }
        let full = crate::math::linalg::rank(&normal) == knots.count();
        prop_assert_eq!(found.is_ok(), full, "{:?}", found);
        if let Ok(fit) = found {
            let d = DMatrix::from_fn(knots.count(), 1, |i, _| fit.points()[i][0].clone());
            let y = DMatrix::from_fn(nodes.len(), 1, |i, _| values[i][0].clone());
            prop_assert_eq!(multiply(&normal, &d).unwrap(), multiply(&weighted.transpose(), &y).unwrap());
        }
    }

    /// Interpolation is possible exactly where the matrix of values is regular.
    #[test]
    fn the_condition_of_schoenberg_and_whitney(knots in any_knots(), places in prop::collection::vec(1i64..9, 12)) {
        let (a, b) = knots.interval().unwrap().ends();
        let m = knots.count();
        let total: i64 = places[..m].iter().sum();
        let mut sum = -places[0];
        let nodes: Vec<Rational> = places[..m].iter().map(|step| {
            sum += step;
            a + (b - a) * q(sum, total - places[0] + places[m - 1] % 3)
        }).collect();
        if nodes.iter().any(|x| x > b) {
            return Ok(());
        }
        let values: Vec<Point<Rational>> = (0..m).map(|i| [z(i as i64)].into()).collect();
        let matrix = values_by_blossom(&knots, &nodes);
        let regular = crate::math::linalg::rank(&matrix) == m;
        let found = interpolating_spline(knots, &nodes, &values);
        prop_assert_eq!(found.is_ok(), regular, "{:?}", found);
        if let Err(error) = found {
            let told = matches!(error, ApproximationError::SchoenbergWhitney { .. });
            prop_assert!(told, "{error}");
        }
    }
}

#[test]
fn the_dual_basis_is_the_inverse_of_the_gram_matrix() {
    for n in 0..12 {
        let gram = bernstein_gram(n, &Interval::unit(), 0);
        assert_eq!(dual_bernstein(n), inverse(&gram).unwrap(), "degree {n}");
    }
}

/// Over uniform knots ∫ N_i^n N_j^n is the value of the B-spline of degree 2n + 1 at n + 1 + j − i.
#[test]
fn uniform_mass_matrices_are_values_of_a_spline() {
    for n in 0..4 {
        let knots = KnotVector::uniform(n, 3 * n + 2, &z(0), &z(1)).unwrap();
        let gram = spline_gram(&knots, 0).unwrap();
        let big = KnotVector::uniform(2 * n + 1, 1, &z(0), &z(1)).unwrap().basis_function(0).unwrap();
        // those in the middle have their support within the domain
        let i = n;
        for j in n..=2 * n {
            if knots.support(j)[n + 1] <= *knots.interval().unwrap().end() && j + 1 > n {
                let inside = knots.support(i)[0] >= *knots.interval().unwrap().start();
                if inside {
                    let value = big.value(&z((n + 1 + j - i) as i64)).unwrap();
                    assert_eq!(gram[(i, j)], value, "degree {n}, functions {i} and {j}");
                }
            }
        }
    }
}

#[test]
fn schoenberg_splines_are_lines_for_lines() {
    let knots = KnotVector::new(3, [-1, 0, 0, 2, 3, 3, 5, 6, 7].map(z).to_vec()).unwrap();
    let line = |x: &Rational| Ok::<_, ApproximationError>([z(2) * x - z(5)].into());
    let s = schoenberg(knots, line).unwrap().unwrap();
    for k in 0..=6 {
        let (a, b) = s.interval().ends();
        let t = a + (b - a) * q(k, 6);
        assert_eq!(s.value(&t).unwrap()[0], z(2) * &t - z(5));
    }
}

#[test]
fn what_cannot_be_approximated() {
    let c = curve(&[1, 2, 5].map(z), &Interval::unit());
    assert_eq!(
        best_reduction(&c, 3, 0),
        Err(crate::math::curve::CurveError::Degrees { left: 2, right: 3 }.into())
    );
    assert_eq!(best_reduction(&c, 0, 0).unwrap().points(), [[q(8, 3)]]);
    let single = KnotVector::new(2, [0, 1, 2, 3].map(z).to_vec()).unwrap();
    assert!(spline_gram(&single, 0).is_err());
    let knots = || KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2)).unwrap()).unwrap();
    let values: Vec<Point<Rational>> = (0..3).map(|k| [z(k)].into()).collect();
    let late = interpolating_spline(knots(), &[q(3, 2), q(7, 4), z(2)], &values);
    assert_eq!(late, Err(ApproximationError::SchoenbergWhitney { index: 0 }));
    let few = interpolating_spline(knots(), &[0, 2].map(z), &values[..2]);
    assert_eq!(few, Err(ApproximationError::NodeCount { nodes: 2, functions: 3 }));
    let gap = fitted_spline(knots(), &[q(3, 2), q(7, 4), z(2)], &values, None, None);
    assert_eq!(gap, Err(ApproximationError::NoNodeFor { index: 0 }));
    let none = fitted_spline(knots(), &[], &[], None, None);
    assert!(none.is_err());
    // A penalty on the slope leaves constants free, a node ties them.
    let smoothing = Smoothing { weight: z(1), order: 1 };
    let one = fitted_spline(knots(), &[z(1)], &values[2..], None, Some(&smoothing)).unwrap();
    assert_eq!(one.points(), [[z(2)], [z(2)], [z(2)]]);
    let zero = energy(&curve(&[4, 4].map(z), &Interval::unit()), 1);
    assert!(zero.is_zero());
}
