//! Values of a polar form over Q, fast: integers only, one reduction at the end.
//!
//! With arguments u_j = p_j/q_j the value is
//!
//! f(u_1, …, u_n) = (Σ_i W_i E_i) / (L ∏ q_j),   ∏ (q_j + p_j x) = Σ_i E_i x^i,
//!
//! where W_i = L c_i / C(n, i) are integers prepared once. A vector argument p/q has
//! the factor (0 + p x). The E_i are kept as rows of words modulo a power of two wide
//! enough for the result, and several arguments are multiplied together first as long
//! as their product has one-word coefficients, so that the inner loop is "row += row ·
//! word". The common denominator is a product of words, hence the final reduction
//! needs only one-word gcds.
//!
//! Cost: O(n²/b · w) word products for b arguments to a block and results of w words:
//! cubic in n with a tiny constant, faster than a product tree far beyond degree 1000.

use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_traits::{One, Zero};

use super::limbs;
use super::polar_form::{Argument, PolarError, PolarForm};
use crate::budget;
use crate::math::number::{Int, Rational, binomial_row};

/// Trial division removes primes below this from the prepared denominator.
const SMALL_PRIMES_BELOW: u64 = 1100;

/// A polar form over Q prepared for many values.
///
/// ```
/// use polarform::blossom::{Evaluator, PolarForm};
/// use polarform::number::{integer, rational};
/// // F(t) = t^2, f(u, v) = u v
/// let f = PolarForm::new(vec![integer(0), integer(0), integer(1)]);
/// let evaluator = Evaluator::new(&f);
/// assert_eq!(evaluator.value(&[rational(1, 2), rational(2, 3)]), Ok(rational(1, 3)));
/// ```
#[derive(Clone, Debug)]
pub struct Evaluator {
    degree: usize,
    /// W_i as sign and words.
    weights: Vec<(Sign, Vec<u64>)>,
    weight_bits: u64,
    /// L = ∏ words · rest.
    words: Vec<u64>,
    rest: Int,
    form: PolarForm<Rational>,
}

/// One factor q + p x of the generating product.
type Factor = (i64, i64);

impl Evaluator {
    /// Prepares the integer weights. Cost: O(n) products and exact divisions of numbers of O(n) bits.
    pub fn new(form: &PolarForm<Rational>) -> Self {
        let n = form.degree();
        let denominators = form.coefficients().iter().fold(Int::ONE, |l, c| l.lcm(c.denom()));
        // lcm of C(n, 0), …, C(n, n) = lcm(1, …, n + 1) / (n + 1)
        let binomials = binomial_row(n);
        let common = (1..=n + 1).fold(Int::ONE, |l, k| l.lcm(&Int::from(k))).div_exact(&Int::from(n + 1));
        let mut weight_bits = 0;
        let weights = (form.coefficients().iter().zip(&binomials))
            .map(|(c, b)| {
                let weight = c.numer() * denominators.div_exact(c.denom()) * common.div_exact(b);
                weight_bits = weight_bits.max(weight.bits());
                let (sign, words) = weight.to_big().to_u64_digits();
                (sign, words)
            })
            .collect();
        let (words, rest) = split_into_words(denominators * common);
        Evaluator { degree: n, weights, weight_bits, words, rest, form: form.clone() }
    }

    /// f at points, or at points and vectors, mixed.
    ///
    /// # Errors
    /// [`PolarError::ArgumentCount`] unless exactly n arguments are given.
    pub fn value<A: Clone + Into<Argument<Rational>>>(
        &self,
        arguments: &[A],
    ) -> Result<Rational, PolarError> {
        let arguments: Vec<Argument<Rational>> = arguments.iter().cloned().map(Into::into).collect();
        if arguments.len() != self.degree {
            return Err(PolarError::ArgumentCount { expected: self.degree, given: arguments.len() });
        }
        let factors = arguments.iter().map(|argument| match argument {
            Argument::Point(u) => Some((u.denom().as_small()?, u.numer().as_small()?)),
            Argument::Vector(v) => Some((0, v.numer().as_small()?)),
        });
        let denominators = arguments.iter().map(|argument| argument.coordinate().denom().as_small());
        // Entries beyond a word are rare: the generic way serves them.
        let words = factors.collect::<Option<Vec<Factor>>>().zip(denominators.collect::<Option<Vec<i64>>>());
        match words.and_then(|(factors, denominators)| Some((self.numerator(&factors)?, denominators))) {
            Some((numerator, denominators)) => Ok(self.reduced(numerator, &denominators)),
            None => self.form.value_generic(&arguments),
        }
    }

    /// Σ W_i E_i as a row of words in two's complement; `None` if a factor does not fit a word.
    fn numerator(&self, factors: &[Factor]) -> Option<Vec<u64>> {
        let n = self.degree;
        let (blocks, total_bits) = blocks(factors)?;
        let length_bits = u64::from(usize::BITS - n.leading_zeros());
        let width = usize::try_from((total_bits + self.weight_bits + length_bits + 1) / 64 + 1).ok()?;
        budget::charge_terms((width as u64).saturating_mul(n as u64 + 1) / 64);
        let mut rows = vec![0u64; (n + 1) * width];
        rows[0] = 1;
        let (mut degree, mut used, mut bits) = (0, 1, 1);
        let mut next = vec![0u64; width];
        for block in &blocks {
            bits += block.bits;
            let wanted = (bits / 64 + 1) as usize;
            let top = degree + block.coefficients.len() - 1;
            if wanted > used {
                for row in rows.chunks_exact_mut(width).take(degree + 1) {
                    let fill = if limbs::is_negative(&row[..used]) { u64::MAX } else { 0 };
                    row[used..wanted].fill(fill);
                }
                used = wanted;
            }
            for k in (0..=top).rev() {
                let acc = &mut next[..used];
                let mut fresh = true;
                for (m, &factor) in block.coefficients.iter().enumerate() {
                    if factor == 0 || m > k || k - m > degree {
                        continue;
                    }
                    let row = &rows[(k - m) * width..(k - m) * width + used];
                    match (factor > 0, fresh) {
                        (true, true) => limbs::set_scaled(acc, row, factor.unsigned_abs()),
                        (true, false) => limbs::add_scaled(acc, row, factor.unsigned_abs()),
                        (false, true) => {
                            acc.fill(0);
                            limbs::sub_scaled(acc, row, factor.unsigned_abs());
                        }
                        (false, false) => limbs::sub_scaled(acc, row, factor.unsigned_abs()),
                    }
                    fresh = false;
                }
                if fresh {
                    acc.fill(0);
                }
                rows[k * width..k * width + used].copy_from_slice(acc);
            }
            budget::steps(u32::try_from(top * used / 64).unwrap_or(u32::MAX));
            degree = top;
        }
        let mut sum = vec![0u64; width];
        for (row, (sign, words)) in rows.chunks_exact_mut(width).zip(&self.weights) {
            let fill = if limbs::is_negative(&row[..used]) { u64::MAX } else { 0 };
            row[used..].fill(fill);
            for (shift, &word) in words.iter().enumerate().take(width) {
                if *sign == Sign::Minus {
                    limbs::sub_scaled(&mut sum[shift..], row, word);
                } else {
                    limbs::add_scaled(&mut sum[shift..], row, word);
                }
            }
        }
        Some(sum)
    }

    /// numerator / (L ∏ denominators) in lowest terms.
    fn reduced(&self, mut numerator: Vec<u64>, denominators: &[i64]) -> Rational {
        let negative = limbs::is_negative(&numerator);
        if negative {
            limbs::negate(&mut numerator);
        }
        trim(&mut numerator);
        if numerator.is_empty() {
            return Rational::zero();
        }
        // gcd(N, d) = g makes N/g and d/g coprime, and later divisions of N keep them so.
        let mut remaining: Vec<u64> = Vec::new();
        let words = self.words.iter().copied();
        for mut word in words.chain(packed(denominators.iter().map(|q| q.unsigned_abs()))) {
            let g = crate::math::number::gcd_word(limbs::mod_word(&numerator, word), word);
            if g > 1 {
                limbs::divide_word(&mut numerator, g);
                trim(&mut numerator);
                word /= g;
            }
            if word > 1 {
                remaining.push(word);
            }
        }
        let mut denominator = product(&remaining);
        let mut value = Int::from(BigInt::from(BigUint::from_slice(&halves(&numerator))));
        if !self.rest.is_one() {
            let g = value.gcd(&self.rest);
            value = value.div_exact(&g);
            denominator *= self.rest.div_exact(&g);
        }
        Rational::new_raw(if negative { -value } else { value }, denominator)
    }
}

/// Words as half words, the way num-bigint takes them.
fn halves(words: &[u64]) -> Vec<u32> {
    words.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]).collect()
}

fn trim(row: &mut Vec<u64>) {
    while row.last() == Some(&0) {
        row.pop();
    }
}

/// The product of many words, by halves.
fn product(words: &[u64]) -> Int {
    match words {
        [] => Int::ONE,
        [word] => Int::from(*word),
        _ => {
            let (left, right) = words.split_at(words.len() / 2);
            product(left) * product(right)
        }
    }
}

/// Multiplies neighbouring words together while the product fits a word.
fn packed(words: impl Iterator<Item = u64>) -> Vec<u64> {
    let mut result: Vec<u64> = Vec::new();
    for word in words.filter(|&word| word > 1) {
        match result.last_mut().and_then(|last| last.checked_mul(word).map(|p| (last, p))) {
            Some((last, product)) => *last = product,
            None => result.push(word),
        }
    }
    result
}

/// L as a product of words and a rest without small prime factors.
fn split_into_words(l: Int) -> (Vec<u64>, Int) {
    let mut rest = l;
    let mut factors = Vec::new();
    let mut divisor = 2;
    while divisor < SMALL_PRIMES_BELOW && !rest.is_one() {
        while rest.mod_word(divisor) == 0 {
            rest = rest.div_exact(&Int::from(divisor));
            factors.push(divisor);
        }
        divisor += 1;
    }
    let mut words = packed(factors.into_iter());
    if let Some(word) = rest.as_small()
        && word > 1
    {
        words.push(word.unsigned_abs());
        rest = Int::ONE;
    }
    (words, rest)
}

/// A product of some factors q + p x, with one-word coefficients.
struct Block {
    coefficients: Vec<i64>,
    /// Σ log2(|p| + |q|), rounded up: a bound on the growth by this block.
    bits: u64,
}

/// Groups the factors into blocks; `None` when |p| + |q| of one exceeds a word.
fn blocks(factors: &[Factor]) -> Option<(Vec<Block>, u64)> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut total = 0;
    for &(q, p) in factors {
        let size = p.unsigned_abs().checked_add(q.unsigned_abs())?;
        let bits = u64::from(64 - size.leading_zeros());
        if bits > 62 {
            return None;
        }
        total += bits;
        match blocks.last_mut() {
            Some(block) if block.bits + bits <= 62 => {
                let c = &mut block.coefficients;
                c.push(0);
                for k in (0..c.len()).rev() {
                    c[k] = c[k] * q + if k > 0 { c[k - 1] * p } else { 0 };
                }
                block.bits += bits;
            }
            _ => blocks.push(Block { coefficients: vec![q, p], bits }),
        }
    }
    Some((blocks, total))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use proptest::prelude::*;

    fn any_rational() -> impl Strategy<Value = Rational> {
        prop_oneof![
            Just(Rational::zero()),
            (-9i64..10, 1i64..10).prop_map(|(p, q)| rational(p, q)),
            (any::<i32>(), 1..i32::MAX).prop_map(|(p, q)| rational(p.into(), q.into())),
            (any::<i64>(), 1..i64::MAX).prop_map(|(p, q)| rational(p, q)),
        ]
    }

    fn any_argument() -> impl Strategy<Value = Argument<Rational>> {
        (any_rational(), 0..4).prop_map(
            |(u, kind)| {
                if kind == 0 { Argument::Vector(u) } else { Argument::Point(u) }
            },
        )
    }

    proptest! {
        #[test]
        fn agrees_with_the_generic_way(
            (coefficients, arguments) in (0usize..12).prop_flat_map(|n| (
                prop::collection::vec(any_rational(), n + 1),
                prop::collection::vec(any_argument(), n),
            ))
        ) {
            let form = PolarForm::new(coefficients);
            let fast = Evaluator::new(&form).value(&arguments).unwrap();
            let slow = form.value_generic(&arguments).unwrap();
            assert_eq!(fast, slow);
            let reduced = Rational::new(fast.numer().clone(), fast.denom().clone());
            assert_eq!(fast, reduced, "not in lowest terms");
        }
    }

    #[test]
    fn large_degree_and_wrong_count() {
        let n = 150;
        let form = PolarForm::new((0..=n).map(|i| rational(i * i - 40, i + 1)).collect());
        let points: Vec<Rational> = (0..n).map(|j| rational(7 * j - 300, 1 + j % 17)).collect();
        let evaluator = Evaluator::new(&form);
        let arguments: Vec<_> = points.iter().cloned().map(Argument::Point).collect();
        assert_eq!(evaluator.value(&points), form.value_generic(&arguments));
        assert_eq!(
            evaluator.value(&points[1..]),
            Err(PolarError::ArgumentCount { expected: 150, given: 149 })
        );
        let zero = Evaluator::new(&PolarForm::new(vec![integer(0); 4]));
        assert_eq!(zero.value(&[integer(1), integer(2), integer(3)]), Ok(integer(0)));
    }
}
