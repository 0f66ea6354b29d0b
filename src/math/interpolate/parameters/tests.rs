use num_traits::ToPrimitive;
use proptest::prelude::*;

use super::enclosure::rounded;
use super::*;
use crate::math::number::{integer as z, parse_decimal};
use Parameterization::{Centripetal, Chord, Foley, Uniform};

const ALL: [Parameterization; 4] = [Uniform, Chord, Centripetal, Foley];

fn points(list: &[(i64, i64)]) -> Vec<Vec<Rational>> {
    list.iter().map(|&(x, y)| vec![z(x), z(y)]).collect()
}

fn unit(list: &[(i64, i64)], method: Parameterization, decimals: u32) -> Parameters {
    parameters(&points(list), method, Scale::Unit, Some(decimals)).unwrap()
}

fn float(x: &Rational) -> f64 {
    x.numer().to_f64().unwrap() / x.denom().to_f64().unwrap()
}

/// The same in floating point.
fn floating(points: &[Vec<Rational>], method: Parameterization, scale: Scale) -> Vec<f64> {
    let points: Vec<Vec<f64>> = points.iter().map(|p| p.iter().map(float).collect()).collect();
    let edges: Vec<Vec<f64>> =
        points.windows(2).map(|w| w[1].iter().zip(&w[0]).map(|(x, y)| x - y).collect()).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let d: Vec<f64> = edges.iter().map(|e| dot(e, e).sqrt()).collect();
    let n = d.len();
    let turn = |i: usize| {
        let cosine = dot(&edges[i - 1], &edges[i]) / (d[i - 1] * d[i]);
        cosine.clamp(-1.0, 1.0).acos().min(std::f64::consts::FRAC_PI_2)
    };
    let step = |i: usize| match method {
        Uniform => 1.0,
        Chord => d[i],
        Centripetal => d[i].sqrt(),
        Foley => {
            let left = if i > 0 { turn(i) * d[i - 1] / (d[i - 1] + d[i]) } else { 0.0 };
            let right = if i + 1 < n { turn(i + 1) * d[i + 1] / (d[i] + d[i + 1]) } else { 0.0 };
            d[i] * (1.0 + 1.5 * left + 1.5 * right)
        }
    };
    let mut t = vec![0.0];
    for i in 0..n {
        t.push(t[i] + step(i));
    }
    let total = if scale == Scale::Unit { t[n] } else { 1.0 };
    t.iter().map(|x| x / total).collect()
}

fn polygon() -> impl Strategy<Value = Vec<Vec<Rational>>> {
    let coordinate = || (-20i64..=20, 1i64..=4).prop_map(|(p, d)| rational(p, d));
    prop::collection::vec(prop::collection::vec(coordinate(), 2), 2..7).prop_map(|mut points| {
        points.dedup();
        if points.len() < 2 {
            points.push(vec![z(100), z(7)]);
        }
        points
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn close_to_floating_point(points in polygon(), unit in any::<bool>()) {
        let scale = if unit { Scale::Unit } else { Scale::Sum };
        for method in ALL {
            let exact = parameters(&points, method, scale, Some(20)).unwrap();
            for (t, expected) in exact.values.iter().zip(floating(&points, method, scale)) {
                prop_assert!((float(t) - expected).abs() < 1e-6);
            }
            // fewer decimals of the true numbers, however they are found
            if !exact.exact && let Ok(fewer) = parameters(&points, method, scale, Some(6)) {
                for (t, u) in exact.values.iter().zip(&fewer.values) {
                    prop_assert_eq!(&rounded(t, 6), u);
                }
            }
        }
    }

    #[test]
    fn reversed_and_scaled(points in polygon(), by in 1i64..50) {
        let back: Vec<_> = points.iter().rev().cloned().collect();
        let large: Vec<Vec<Rational>> =
            points.iter().map(|p| p.iter().map(|x| x * z(by) + z(3)).collect()).collect();
        for method in ALL {
            let there = parameters(&points, method, Scale::Unit, Some(30)).unwrap();
            let again = parameters(&large, method, Scale::Unit, Some(30)).unwrap();
            prop_assert_eq!(&there, &again);
            let mirrored = parameters(&back, method, Scale::Unit, Some(30)).unwrap();
            for (t, u) in there.values.iter().zip(mirrored.values.iter().rev()) {
                prop_assert!(t + u == z(1) || !there.exact);
                prop_assert!((t + u - z(1)) * power_of_ten(30) <= z(1));
            }
        }
    }

    #[test]
    fn rounding_is_half_to_even(p in any::<i32>(), d in 1i64..1000, decimals in 0u32..4) {
        let (x, unit) = (rational(p.into(), d), Rational::from_integer(power_of_ten(decimals)));
        let distance = (rounded(&x, decimals) - &x) * &unit;
        let half = rational(1, 2);
        prop_assert!(distance <= half && distance >= -half.clone());
        let scaled = (rounded(&x, decimals) * unit).to_integer();
        if distance == half || distance == -half {
            prop_assert!((scaled % Int::from(2)).is_zero());
        }
    }
}

#[test]
fn exact_where_possible() {
    assert_eq!(unit(&[(0, 0), (1, 5), (2, 0)], Uniform, 3).values, [z(0), rational(1, 2), z(1)]);
    // lengths √2 and 2√2: irrational, their ratio is not
    let diagonal = [(0, 0), (1, 1), (3, 3)];
    for method in [Chord, Foley] {
        let chord = parameters(&points(&diagonal), method, Scale::Unit, None).unwrap();
        assert_eq!(chord.values, [z(0), rational(1, 3), z(1)]);
        assert!(chord.exact && chord.decimals.is_none());
    }
    let error = parameters(&points(&diagonal), Chord, Scale::Sum, None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the parameters are irrational: segment 0, from P_0 to P_1, has an irrational length; \
         ask for a number of decimals"
    );
    // lengths 3√2 and 12√2: the roots have the ratio 2
    let centripetal = parameters(&points(&[(0, 0), (3, 3), (15, 15)]), Centripetal, Scale::Unit, None);
    assert_eq!(centripetal.unwrap().values, [z(0), rational(1, 3), z(1)]);
    let sums = parameters(&points(&[(0, 0), (9, 0), (9, 16)]), Centripetal, Scale::Sum, None);
    assert_eq!(sums.unwrap().values, [0, 3, 7].map(z));
    // exact although decimals are given
    assert!(unit(&[(0, 0), (3, 4), (3, 14)], Chord, 1).exact);
}

#[test]
fn known_digits() {
    let pi = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899";
    let expected = rounded(&parse_decimal(pi).unwrap(), 70);
    let twice = Bounds::half_pi(90).scaled(&z(2));
    assert_eq!(twice.settled(70), Some(expected.clone()));
    let quarter = Bounds::arctan_of_root(&z(1), 90).scaled(&z(4));
    assert_eq!(quarter.settled(70), Some(expected.clone()));
    // arctan √3 = π/3 and arctan 1/√3 = π/6
    assert_eq!(Bounds::arctan_of_root(&z(3), 90).scaled(&z(3)).settled(70), Some(expected.clone()));
    assert_eq!(Bounds::arctan_of_root(&rational(1, 3), 90).scaled(&z(6)).settled(70), Some(expected));
    // arctan 1/2 + arctan 1/3 = π/4, arctan of something tiny
    let half = Bounds::arctan_of_root(&rational(1, 4), 60).plus(&Bounds::arctan_of_root(&rational(1, 9), 60));
    assert_eq!(half.settled(50), Bounds::half_pi(60).scaled(&rational(1, 2)).settled(50));
    let tiny = Bounds::arctan_of_root(&Rational::new(Int::ONE, power_of_ten(60)), 80);
    assert_eq!(tiny.settled(40), Some(Rational::new(Int::ONE, power_of_ten(30))));
    let root = parse_decimal("1.4142135623730950488016887242096980785696718753769").unwrap();
    assert_eq!(Bounds::square_root(&z(2), 60).settled(49), Some(root));
    assert_eq!(Bounds::fourth_root(&z(4), 60).settled(49), Bounds::square_root(&z(2), 60).settled(49));
}

/// A right angle of two unit edges: Δ = 1 + (3/2)(π/2)/2 on both; the third edge has the length 3.
#[test]
fn foley_by_hand() {
    let half = unit(&[(0, 0), (1, 0), (1, 1)], Foley, 5);
    assert_eq!(half.values, [z(0), rational(1, 2), z(1)]);
    assert!(!half.exact);
    let sums = parameters(&points(&[(0, 0), (1, 0), (1, 1)]), Foley, Scale::Sum, Some(12)).unwrap();
    assert_eq!(sums.values[1], parse_decimal("2.178097245096").unwrap());
    // θ̂ = π/4 between edges 1 and √2 : 1 + (3/2)(π/4) √2/(1 + √2)
    let sums = parameters(&points(&[(0, 0), (1, 0), (2, 1)]), Foley, Scale::Sum, Some(10)).unwrap();
    assert_eq!(sums.values[1], parse_decimal("1.6901133884").unwrap());
    // a polygon that turns back turns by more than π/2
    let sums = parameters(&points(&[(0, 0), (1, 0), (0, 0)]), Foley, Scale::Sum, Some(12)).unwrap();
    assert_eq!(sums.values[1], parse_decimal("2.178097245096").unwrap());
}

/// Twenty decimals from SymPy.
#[test]
fn checked_with_sympy() {
    let polygon = [(0, 0), (1, 0), (2, 1), (2, 3), (0, 3)];
    for (method, expected) in [
        (Chord, ["0.15590375815769151962", "0.37638496736923392153", "0.68819248368461696077"]),
        (Centripetal, ["0.19929710939832100619", "0.43630264989428001653", "0.71815132494714000826"]),
        (Foley, ["0.11689196262817047680", "0.32993192269491269220", "0.69871599914619057953"]),
    ] {
        let found = unit(&polygon, method, 20).values;
        let expected = expected.map(|text| parse_decimal(text).unwrap());
        assert_eq!(found[1..4], expected);
    }
}

#[test]
fn small_and_large() {
    let tiny = Rational::new(Int::ONE, power_of_ten(200));
    let shrunk = |by: &Rational| -> Vec<Vec<Rational>> {
        points(&[(0, 0), (1, 0), (2, 1), (5, 5)]).iter().map(|p| p.iter().map(|x| x * by).collect()).collect()
    };
    for method in [Chord, Centripetal, Foley] {
        let expected = parameters(&shrunk(&z(1)), method, Scale::Unit, Some(15)).unwrap();
        for by in [tiny.clone(), tiny.recip()] {
            assert_eq!(parameters(&shrunk(&by), method, Scale::Unit, Some(15)).unwrap(), expected);
        }
    }
}

#[test]
fn errors_name_the_offender() {
    use InterpolationError as E;
    let ask =
        |list: &[(i64, i64)], method, decimals| parameters(&points(list), method, Scale::Unit, decimals);
    assert_eq!(ask(&[(0, 0)], Chord, None), Err(E::TooFewPoints { needed: 2, given: 1 }));
    let stopped = [(0, 0), (1, 1), (1, 1)];
    assert_eq!(ask(&stopped, Chord, None), Err(E::CoincidentPoints { index: 1 }));
    assert!(ask(&stopped, Uniform, None).is_ok());
    assert!(matches!(ask(&[(0, 0), (1, 0), (1, 1)], Foley, None), Err(E::Irrational { segment: 0, .. })));
    assert!(matches!(ask(&[(0, 0), (1, 0), (2, 1)], Chord, None), Err(E::Irrational { segment: 1, .. })));
    // 1/2 is rounded to the even 0
    let equal = E::TooFewDecimals { index: 0, decimals: 0 };
    assert_eq!(ask(&[(0, 0), (1, 0), (1, 1)], Foley, Some(0)), Err(equal.clone()));
    assert_eq!(equal.to_string(), "the parameters t_0 and t_1 are equal to 0 decimals");
    let ragged = [vec![z(0)], vec![z(1), z(2)]];
    assert!(matches!(parameters(&ragged, Uniform, Scale::Unit, None), Err(E::Dimensions { index: 1, .. })));
}
