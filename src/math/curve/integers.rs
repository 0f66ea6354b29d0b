//! Bézier coordinates that are numbers: integers over one denominator.

use crate::budget;
use crate::math::number::{Int, Rational, binomial_row, over_one_denominator};
use crate::math::poly::Poly;

/// The first and the last number of each level of de Casteljau's algorithm at the ratio s = p/q: the
/// coordinates of both parts. A level of integers has the denominator q^r in addition; only the ends
/// are reduced. Cost: n² products of an integer by a short one.
pub(super) fn split(numbers: &[Rational], s: &Rational) -> (Vec<Rational>, Vec<Rational>) {
    let (p, q) = (s.numer(), s.denom());
    let rest = q - p;
    let (mut level, mut denominator) = over_one_denominator(numbers);
    let (mut left, mut right) = (Vec::with_capacity(level.len()), Vec::with_capacity(level.len()));
    loop {
        budget::steps(level.len() as u32);
        let end = |x: Option<&Int>| x.map(|x| Rational::new(x.clone(), denominator.clone()));
        left.extend(end(level.first()));
        right.extend(end(level.last()));
        if level.len() <= 1 {
            right.reverse();
            return (left, right);
        }
        for i in 0..level.len() - 1 {
            level[i] = &level[i] * &rest + &level[i + 1] * p;
        }
        level.pop();
        denominator *= q;
    }
}

/// The coordinates with the degree raised from n to n + r: with c_j = C(n, j) b_j the new ones are
/// C(n+r, i) b_i' = Σ_j c_j C(r, i − j), a product of polynomials.
pub(super) fn elevated(numbers: &[Rational], by: usize) -> Vec<Rational> {
    let n = numbers.len().saturating_sub(1);
    let (integers, denominator) = over_one_denominator(numbers);
    let scaled = integers.iter().zip(binomial_row(n)).map(|(b, c)| b * c).collect();
    let product = Poly::from_integers(scaled, Int::ONE) * Poly::from_integers(binomial_row(by), Int::ONE);
    let (numerators, _) = product.into_parts();
    let raised = |(i, c): (usize, Int)| {
        Rational::new(numerators.get(i).cloned().unwrap_or_default(), c * &denominator)
    };
    binomial_row(n + by).into_iter().enumerate().map(raised).collect()
}
