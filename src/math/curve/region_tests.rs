//! Tests of certificates over regions.

use super::*;
use crate::math::number::{integer as z, multinomial};
use proptest::prelude::*;

fn unknowns(dimension: usize) -> Vec<Symbol> {
    ["u", "v", "w"][..dimension].iter().map(|name| Symbol::new(*name)).collect()
}

fn polynomial(degree: u32) -> impl Strategy<Value = MultiPoly> {
    prop::collection::vec((-4i64..6, 0..=degree, 0..=degree, 0u32..2), 1..7).prop_map(|terms| {
        let [u, v, w] = ["u", "v", "w"].map(|name| MultiPoly::symbol(Symbol::new(name)));
        terms
            .into_iter()
            .fold(MultiPoly::zero(), |sum, (c, i, j, k)| sum + (u.pow(i) * v.pow(j) * w.pow(k)).scaled(&z(c)))
    })
}

fn region(dimension: usize) -> impl Strategy<Value = Region> {
    let interval = (-3i64..3, 1i64..4).prop_map(|(a, d)| [z(a), z(a + d)]);
    let corner = prop::collection::vec((-3i64..4).prop_map(z), dimension);
    prop_oneof![
        prop::collection::vec(interval, dimension).prop_map(Region::Box),
        prop::collection::vec(corner, dimension + 1)
            .prop_map(Region::Simplex)
            .prop_filter("flat", Region::is_proper),
    ]
}

/// A point by shares of the intervals, or by barycentric coordinates.
fn point(region: &Region, shares: &[i64]) -> (Vec<Rational>, Vec<Rational>) {
    match region {
        Region::Box(ends) => {
            let local: Vec<Rational> = shares[..ends.len()].iter().map(|&k| rational(k, 7)).collect();
            (ends.iter().zip(&local).map(|([a, b], t)| a + (b - a) * t).collect(), local)
        }
        Region::Simplex(corners) => {
            let whole = 1 + shares[..corners.len() - 1].iter().sum::<i64>();
            let local: Vec<Rational> = std::iter::once(1)
                .chain(shares.iter().copied())
                .take(corners.len())
                .map(|k| rational(k, whole))
                .collect();
            let coordinate = |k: usize| corners.iter().zip(&local).fold(z(0), |sum, (p, s)| sum + &p[k] * s);
            ((0..corners.len() - 1).map(coordinate).collect(), local)
        }
    }
}

/// The coefficients are those of F over the part, at a point.
fn checks(part: &RegionPart, f: &MultiPoly, unknowns: &[Symbol], shares: &[i64]) -> bool {
    let (at, local) = point(&part.region, shares);
    let degree = |k: usize| part.coefficients.iter().map(|(index, _)| index[k]).max().unwrap();
    let sum = part.coefficients.iter().fold(z(0), |sum, (index, c)| {
        let weight = match &part.region {
            Region::Box(_) => index.iter().enumerate().fold(z(1), |product, (k, &i)| {
                let n = degree(k);
                product
                    * Rational::from_integer(binomial(n, i))
                    * local[k].powered(i as u32)
                    * (z(1) - &local[k]).powered((n - i) as u32)
            }),
            Region::Simplex(_) => index
                .iter()
                .zip(&local)
                .fold(Rational::from_integer(multinomial(index)), |product, (e, w)| {
                    product * w.powered(*e as u32)
                }),
        };
        sum + c * weight
    });
    sum == value(f, unknowns, &at)
}

fn size(region: &Region) -> Rational {
    match region {
        Region::Box(ends) => ends.iter().fold(z(1), |product, [a, b]| product * (b - a)),
        Region::Simplex(corners) => volume(corners).abs(),
    }
}

/// Certificates check and cover the region, counterexamples are some, and no value of a grid contradicts.
fn answers_are_right(f: &MultiPoly, region: &Region, shares: &[i64]) -> Result<(), TestCaseError> {
    let unknowns = unknowns(region.dimension());
    let samples = (0..=6).flat_map(|i| (0..=6).map(move |j| [i, j, (i * j + shares[0]) % 7]));
    let least = samples.map(|shares| value(f, &unknowns, &point(region, &shares).0)).min().unwrap();
    match positivity_on(f, &unknowns, region) {
        Ok(shown) => {
            prop_assert!(!least.is_negative());
            prop_assert_eq!(shown.root_of_square.pow(2) * shown.rest.clone(), f.clone());
            if let RegionShown::Coefficients(parts) = &shown.shown {
                prop_assert!(parts.iter().all(|part| checks(part, &shown.rest, &unknowns, shares)));
                prop_assert!(
                    parts.iter().all(|part| part.coefficients.iter().all(|(_, c)| !c.is_negative()))
                );
                prop_assert_eq!(parts.iter().fold(z(0), |sum, part| sum + size(&part.region)), size(region));
            }
        }
        Err(RegionFailure::Negative(at)) => {
            prop_assert!(value(f, &unknowns, &at).is_negative());
            prop_assert!(
                region.sides(&unknowns).iter().all(|side| !value(side, &unknowns, &at).is_negative())
            );
        }
        Err(RegionFailure::Open(_)) => prop_assert!(!least.is_negative()),
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn in_the_plane(f in polynomial(3), g in polynomial(2), region in region(2), kind in 0..4, shares in prop::collection::vec(0i64..8, 3)) {
        let flat = |f: MultiPoly| f.value(&|s| (*s == Symbol::new("w")).then(|| z(1)));
        let (f, g) = (flat(f), flat(g));
        let f = match kind {
            0 => f,
            1 => f.pow(2) + g.pow(2),
            2 => g.pow(2) * (f + MultiPoly::constant(z(9))),
            _ => f + MultiPoly::constant(z(3)),
        };
        answers_are_right(&f, &region, &shares)?;
    }

    #[test]
    fn in_space(f in polynomial(2), p in polynomial(2), region in region(3), kind in 0..3, shares in prop::collection::vec(0i64..8, 3)) {
        let f = match kind {
            0 => f,
            1 => f.clone() * f,
            _ => f.clone() * f + MultiPoly::constant(z(1)) + p.scaled(&rational(1, 100)),
        };
        answers_are_right(&f, &region, &shares)?;
    }
}

/// Σ (x_i − 1/3)² is 0 at one point, which no halving meets, and is no square.
#[test]
fn zeros_inside_need_critical_points() {
    for dimension in [2, 3] {
        let symbols = unknowns(dimension);
        let third = MultiPoly::constant(rational(1, 3));
        let f = symbols
            .iter()
            .fold(MultiPoly::zero(), |sum, x| sum + (MultiPoly::symbol(x.clone()) - third.clone()).pow(2));
        let region = Region::Box(vec![[-z(1), z(2)]; dimension]);
        let RegionShown::CriticalPoints(points) = positivity_on(&f, &symbols, &region).unwrap().shown else {
            panic!()
        };
        assert_eq!(points[0].coordinates, vec![RealRoot::Rational(rational(1, 3)); dimension]);
        let lower = f - MultiPoly::constant(rational(1, 1 << 20));
        let Err(RegionFailure::Negative(p)) = positivity_on(&lower, &symbols, &region) else { panic!() };
        assert!(value(&lower, &symbols, &p).is_negative());
    }
    // Motzkin's polynomial is no sum of squares, and has zeros at (±1, ±1).
    let symbols = unknowns(2);
    let [u, v] = ["u", "v"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    let motzkin =
        u.pow(4) * v.pow(2) + u.pow(2) * v.pow(4) - (u.pow(2) * v.pow(2)).scaled(&z(3)) + MultiPoly::one();
    assert!(positivity_on(&motzkin, &symbols, &Region::Box(vec![[-z(2), z(2)]; 2])).is_ok());
}
