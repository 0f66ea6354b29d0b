use super::*;
use crate::math::number::rational;
use crate::math::poly::MonomialOrder;
use crate::math::ring::Ring;
use num_traits::One;
use proptest::prelude::*;

fn symbols<const N: usize>(names: [&str; N]) -> [Symbol; N] {
    names.map(Symbol::new)
}

/// A polynomial of total degree 2 at most in some unknowns.
fn quadratic(unknowns: Vec<Symbol>) -> impl Strategy<Value = MultiPoly> {
    let count = unknowns.len();
    prop::collection::vec((prop::collection::vec(0usize..=count, 2), -4i64..5), 1..6).prop_map(move |terms| {
        terms.into_iter().fold(MultiPoly::zero(), |sum, (places, c)| {
            let factor =
                |k: usize| unknowns.get(k).map_or_else(MultiPoly::one, |s| MultiPoly::symbol(s.clone()));
            sum + places.into_iter().fold(MultiPoly::constant(integer(c)), |product, k| product * factor(k))
        })
    })
}

fn coordinates(zeros: &[RealZero]) -> Vec<Vec<RealRoot>> {
    zeros.iter().map(|zero| zero.coordinates.clone()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Resultants and Gröbner bases find the same zeros, and every equation holds there.
    #[test]
    fn both_ways_agree(f in quadratic(symbols(["x", "y"]).to_vec()), g in quadratic(symbols(["x", "y"]).to_vec())) {
        let unknowns = symbols(["x", "y"]);
        let by_resultants = common_zeros(&f, &g, &unknowns, &Default::default());
        let by_basis = real_zeros(&[f.clone(), g.clone()], &unknowns);
        match (by_resultants, by_basis) {
            (Ok(a), Ok(b)) => {
                prop_assert_eq!(coordinates(&a), coordinates(&b));
                for zero in a.iter().chain(&b) {
                    prop_assert!(zero.sign_of(&f, &unknowns).is_eq() && zero.sign_of(&g, &unknowns).is_eq());
                    let shifted = f.clone() + MultiPoly::constant(rational(1, 7));
                    prop_assert!(zero.sign_of(&shifted, &unknowns).is_gt());
                }
            }
            (a, b) => prop_assert_eq!(a.err(), b.err()),
        }
    }

    /// Products of lines meet where the lines meet.
    #[test]
    fn lines_meet_where_they_do(lines in prop::collection::vec((-3i64..4, -3i64..4, -3i64..4), 4)) {
        let unknowns = symbols(["x", "y"]);
        let [x, y] = unknowns.clone().map(MultiPoly::symbol);
        let form = |&(a, b, c): &(i64, i64, i64)| {
            x.scaled(&integer(a)) + y.scaled(&integer(b)) + MultiPoly::constant(integer(c))
        };
        prop_assume!(lines.iter().all(|(a, b, _)| (*a, *b) != (0, 0)));
        let (f, g) = (form(&lines[0]) * form(&lines[1]), form(&lines[2]) * form(&lines[3]));
        let mut expected = Vec::new();
        let mut same = false;
        for (a, b, c) in &lines[..2] {
            for (d, e, h) in &lines[2..] {
                let det = a * e - b * d;
                if det == 0 {
                    same |= a * h == c * d && b * h == c * e;
                } else {
                    expected.push([rational(b * h - c * e, det), rational(c * d - a * h, det)].map(RealRoot::Rational).to_vec());
                }
            }
        }
        expected.sort();
        expected.dedup();
        match common_zeros(&f, &g, &unknowns, &Default::default()) {
            Ok(zeros) => {
                prop_assert!(!same);
                prop_assert_eq!(coordinates(&zeros), expected.clone());
                // Within bounds, those within.
                let bounds = [(Some(integer(0)), None), (None, Some(integer(1)))];
                let inside = common_zeros(&f, &g, &unknowns, &bounds).unwrap();
                expected.retain(|p| p[0] >= RealRoot::Rational(integer(0)) && p[1] <= RealRoot::Rational(integer(1)));
                prop_assert_eq!(coordinates(&inside), expected);
            }
            Err(error) => prop_assert!(same && error == SystemError::Infinite),
        }
    }

    /// Whether a polynomial lies in an ideal does not depend on the order, and combinations do.
    #[test]
    fn bases_reduce_combinations_to_zero(
        list in prop::collection::vec(quadratic(symbols(["x", "y", "z"]).to_vec()), 3),
        factors in prop::collection::vec(quadratic(symbols(["x", "y", "z"]).to_vec()), 3),
    ) {
        let unknowns = symbols(["x", "y", "z"]);
        let combination = list.iter().zip(&factors).fold(MultiPoly::zero(), |sum, (f, g)| sum + f.clone() * g.clone());
        for order in [MonomialOrder::Lex, MonomialOrder::GrevLex, MonomialOrder::GrLex] {
            let Ok(basis) = groebner_basis(&list, &unknowns, order) else { continue };
            let with = [basis.clone(), vec![combination.clone()]].concat();
            prop_assert_eq!(&groebner_basis(&with, &unknowns, order).unwrap(), &basis);
            prop_assert_eq!(&groebner_basis(&basis, &unknowns, order).unwrap(), &basis);
        }
    }

    /// The image of a root is a root of what it should be.
    #[test]
    fn images_are_values(c in prop::collection::vec(-5i64..6, 3..6), n in prop::collection::vec(-3i64..4, 1..5), d in prop::collection::vec(-3i64..4, 1..3)) {
        let poly = |list: &[i64]| -> Poly { list.iter().map(|&k| integer(k)).collect() };
        let (m, n, d) = (poly(&c), poly(&n), poly(&d));
        prop_assume!(!m.is_zero());
        for (root, _) in m.real_roots(None, None).unwrap() {
            if root.sign_of(&d).is_eq() {
                continue;
            }
            let value = image(&root, &n, &d);
            let at = match &root {
                RealRoot::Rational(q) => q.clone(),
                RealRoot::Irrational(number) => number.refined(&rational(1, 1 << 40)).ends().0,
            };
            let near = n.value(&at) / d.value(&at);
            let around = rational(1, 1000) * (integer(1) + near.clone() * near.clone());
            prop_assert!(value > RealRoot::Rational(&near - &around) && value < RealRoot::Rational(&near + &around));
            // (D(u) x − N(u)) is 0: as a system in u and x.
            let unknowns = symbols(["u", "x"]);
            let [u, x] = unknowns.clone().map(MultiPoly::symbol);
            let lift = |p: &Poly| p.value_in(&u);
            let found = common_zeros(&lift(&m), &(lift(&d) * x - lift(&n)), &unknowns, &Default::default());
            if let Ok(found) = found {
                prop_assert!(found.iter().any(|zero| zero.coordinates == [root.clone(), value.clone()]));
            }
        }
    }
}

#[test]
fn what_has_no_or_too_many_solutions() {
    let unknowns = symbols(["x", "y"]);
    let [x, y] = unknowns.clone().map(MultiPoly::symbol);
    let number = |k| MultiPoly::constant(integer(k));
    let circle = x.pow(2) + y.pow(2) + number(1);
    assert_eq!(common_zeros(&circle, &x, &unknowns, &Default::default()), Ok(Vec::new()));
    assert_eq!(real_zeros(std::slice::from_ref(&circle), &unknowns), Err(SystemError::Infinite));
    assert_eq!(common_zeros(&x, &x, &unknowns, &Default::default()), Err(SystemError::Infinite));
    assert_eq!(real_zeros(&[x.pow(9), y.pow(9)], &unknowns), Err(SystemError::Many));
    // Two cusps: a point that is multiple in every direction.
    let (f, g) = (x.pow(2) - y.pow(3), x.pow(3) - y.pow(2).scaled(&integer(2)));
    let zeros = common_zeros(&f, &g, &unknowns, &Default::default()).unwrap();
    assert!(zeros.iter().any(|zero| zero.coordinates == [0, 0].map(|k| RealRoot::Rational(integer(k)))));
    for zero in &zeros {
        assert!(zero.sign_of(&f, &unknowns).is_eq() && zero.sign_of(&g, &unknowns).is_eq());
    }
}
