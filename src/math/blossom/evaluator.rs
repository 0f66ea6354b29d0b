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
//! Cost: O(n²/b · w) word products for b arguments to a block and results of w words: cubic in n with a tiny
//! constant. Beyond some hundred arguments the product is made of halves, by fast multiplication.

use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_traits::{One, Zero};

use super::polar_form::{Argument, PolarError, PolarForm};
use crate::budget;
use crate::math::number::limbs;
use crate::math::number::{Int, Rational, binomial_row};
use crate::math::poly::Poly;

/// Trial division removes primes below this from the prepared denominator.
const SMALL_PRIMES_BELOW: u64 = 1100;

/// Up to so many arguments the generating product is made row by row, faster than from its halves.
const MOST_ROWS: usize = 450;

/// A polar form over Q prepared for many values.
///
/// ```
/// use polarform::blossom::{PreparedForm, PolarForm};
/// use polarform::number::{integer, rational};
/// // F(t) = t^2, f(u, v) = u v
/// let f = PolarForm::new(vec![integer(0), integer(0), integer(1)]);
/// let evaluator = PreparedForm::new(&f);
/// assert_eq!(evaluator.value(&[rational(1, 2), rational(2, 3)]), Ok(rational(1, 3)));
/// ```
#[derive(Clone, Debug)]
pub struct PreparedForm {
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

impl PreparedForm {
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
        PreparedForm { degree: n, weights, weight_bits, words, rest, form: form.clone() }
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
            Some(((sign, numerator), denominators)) => Ok(self.reduced(sign, numerator, &denominators)),
            None => self.form.value_generic(&arguments),
        }
    }

    /// Σ W_i E_i, its sign and words; `None` if a factor does not fit a word.
    fn numerator(&self, factors: &[Factor]) -> Option<(Sign, Vec<u64>)> {
        if factors.len() > MOST_ROWS {
            return self.numerator_by_halves(factors);
        }
        let length_bits = u64::from(usize::BITS - factors.len().leading_zeros());
        let Rows { mut words, width, used } = generating_rows(factors, self.weight_bits + length_bits)?;
        let mut sum = vec![0u64; width];
        for (row, (sign, weight)) in words.chunks_exact_mut(width).zip(&self.weights) {
            let fill = if limbs::is_negative(&row[..used]) { u64::MAX } else { 0 };
            row[used..].fill(fill);
            for (shift, &word) in weight.iter().enumerate().take(width) {
                if *sign == Sign::Minus {
                    limbs::sub_scaled(&mut sum[shift..], row, word);
                } else {
                    limbs::add_scaled(&mut sum[shift..], row, word);
                }
            }
        }
        Some(magnitude(sum))
    }

    /// The same by long integers.
    fn numerator_by_halves(&self, factors: &[Factor]) -> Option<(Sign, Vec<u64>)> {
        let product = generating_product(factors)?;
        let mut sum = BigInt::ZERO;
        for (e, (sign, weight)) in product.numerators().iter().zip(&self.weights) {
            budget::steps((weight.len() as u64 * e.bits() / 65_536) as u32 + 1);
            sum += BigInt::from_slice(*sign, &halves(weight)) * e.to_big();
        }
        Some(sum.to_u64_digits())
    }

    /// numerator / (L ∏ denominators) in lowest terms.
    fn reduced(&self, sign: Sign, mut numerator: Vec<u64>, denominators: &[i64]) -> Rational {
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
        Rational::new_raw(if sign == Sign::Minus { -value } else { value }, denominator)
    }
}

/// E_0, …, E_m as rows of words in two's complement.
struct Rows {
    words: Vec<u64>,
    /// Words of a row, and how many of them are in use; the others repeat the sign.
    width: usize,
    used: usize,
}

/// ∏ (q + p x) row by row, with room for numbers that are longer by `spare_bits`.
fn generating_rows(factors: &[Factor], spare_bits: u64) -> Option<Rows> {
    let n = factors.len();
    let (blocks, total_bits) = blocks(factors)?;
    let width = usize::try_from((total_bits + spare_bits + 1) / 64 + 1).ok()?;
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
    Some(Rows { words: rows, width, used })
}

/// ∏ (q + p x) as a polynomial, from halves.
fn generating_product(factors: &[Factor]) -> Option<Poly> {
    if factors.len() > MOST_ROWS {
        let (left, right) = factors.split_at(factors.len() / 2);
        return Some(generating_product(left)? * generating_product(right)?);
    }
    let Rows { words, width, used } = generating_rows(factors, 0)?;
    let number = |row: &[u64]| {
        let (sign, words) = magnitude(row[..used].to_vec());
        Int::from(BigInt::from_slice(sign, &halves(&words)))
    };
    Some(Poly::from_integers(words.chunks_exact(width).map(number).collect(), Int::ONE))
}

/// The sign and the words of a number in two's complement.
fn magnitude(mut row: Vec<u64>) -> (Sign, Vec<u64>) {
    let negative = limbs::is_negative(&row);
    if negative {
        limbs::negate(&mut row);
    }
    trim(&mut row);
    let sign = match (negative, row.is_empty()) {
        (_, true) => Sign::NoSign,
        (true, false) => Sign::Minus,
        (false, false) => Sign::Plus,
    };
    (sign, row)
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
            let fast = PreparedForm::new(&form).value(&arguments).unwrap();
            let slow = form.value_generic(&arguments).unwrap();
            assert_eq!(fast, slow);
            let reduced = Rational::new(fast.numer().clone(), fast.denom().clone());
            assert_eq!(fast, reduced, "not in lowest terms");
        }
    }

    /// The two ways to the generating product, on factors of all signs and sizes, also without q or p.
    #[test]
    fn halves_and_rows_agree() {
        let n = MOST_ROWS + 7;
        let mut state = 1u64;
        let mut draw = |below: i64| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as i64 % below
        };
        let factors: Vec<Factor> = (0..n)
            .map(|k| match k % 97 {
                0 => (0, draw(9) - 4),
                1 => (draw(5) + 1, 0),
                2 => (draw(1 << 30) + 1, draw(1 << 30) - (1 << 29)),
                _ => (draw(3) + 1, draw(9) - 4),
            })
            .collect();
        let Rows { words, width, used } = generating_rows(&factors, 0).unwrap();
        let by_rows: Vec<(Sign, Vec<u64>)> =
            words.chunks_exact(width).map(|row| magnitude(row[..used].to_vec())).collect();
        let by_halves = generating_product(&factors).unwrap();
        for (k, expected) in by_rows.iter().enumerate() {
            let found = by_halves.numerators().get(k).map(|e| e.to_big().to_u64_digits());
            assert_eq!(found.unwrap_or((Sign::NoSign, Vec::new())), *expected, "E_{k}");
        }
    }

    #[test]
    fn large_degree_and_wrong_count() {
        let n = 150;
        let form = PolarForm::new((0..=n).map(|i| rational(i * i - 40, i + 1)).collect());
        let points: Vec<Rational> = (0..n).map(|j| rational(7 * j - 300, 1 + j % 17)).collect();
        let evaluator = PreparedForm::new(&form);
        let arguments: Vec<_> = points.iter().cloned().map(Argument::Point).collect();
        assert_eq!(evaluator.value(&points), form.value_generic(&arguments));
        assert_eq!(
            evaluator.value(&points[1..]),
            Err(PolarError::ArgumentCount { expected: 150, given: 149 })
        );
        let zero = PreparedForm::new(&PolarForm::new(vec![integer(0); 4]));
        assert_eq!(zero.value(&[integer(1), integer(2), integer(3)]), Ok(integer(0)));
    }
}
