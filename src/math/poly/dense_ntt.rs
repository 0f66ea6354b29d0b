//! Products of integer vectors by number-theoretic transforms.
//!
//! Each entry is cut into signed digits of w bits, the vectors of digits are
//! multiplied modulo three primes near 2^62 by transforms, the Chinese remainder
//! theorem gives each digit of the product (below 2^184 in size), and the digits
//! are carried together again. Digits of one entry are followed by enough empty
//! places that two entries never overlap, so this is Kronecker substitution with
//! the carries postponed. Cost: O(N log N) word products for N digits in all.
//!
//! J. von zur Gathen, J. Gerhard, "Modern Computer Algebra", sections 8.2–8.4.

use num_bigint::{BigInt, Sign};

use super::dense_modular::Modulus;
use crate::budget;
use crate::math::number::Int;

/// The three largest primes below 2^62 that are 1 modulo 2^44, and generators of
/// their multiplicative groups.
pub(super) const FIELDS: [Modulus; 3] = [
    Modulus::new(0x3fff_c000_0000_0001),
    Modulus::new(0x3ffd_f000_0000_0001),
    Modulus::new(0x3ffd_9000_0000_0001),
];
pub(super) const GENERATORS: [u64; 3] = [11, 3, 3];
pub(super) const ROOT_ORDER_LOG: u32 = 44;

/// The product of the primes exceeds 2^185, so every integer of size below 2^184 is determined.
const RESULT_BITS: u64 = 184;

/// Widest digit: a signed digit must fit in an `i128` and be below p·2^64.
const DIGIT_BITS: u64 = 124;

/// How the entries of two vectors are cut into digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Plan {
    /// Bits of a digit.
    width: u32,
    /// Digits of an entry of the first vector.
    digits_a: usize,
    /// Digits of an entry of the second vector.
    digits_b: usize,
    /// Length of the transform: 2^k or 3·2^k.
    pub length: usize,
}

impl Plan {
    /// The widest digits for `len_a` entries of `bits_a` bits times `len_b` entries of `bits_b` bits.
    pub fn new(len_a: usize, bits_a: u64, len_b: usize, bits_b: u64) -> Plan {
        let mut width = DIGIT_BITS;
        loop {
            let digits_a = bits_a.div_ceil(width).max(1) as usize;
            let digits_b = bits_b.div_ceil(width).max(1) as usize;
            // At most this many products of two digits meet in one place.
            let terms = len_a.min(len_b) * digits_a.min(digits_b);
            let sum_bits = u64::from(usize::BITS - terms.leading_zeros());
            if bits_a.min(width) + bits_b.min(width) + sum_bits <= RESULT_BITS {
                let places = (len_a + len_b - 1) * (digits_a + digits_b - 1);
                let power = places.next_power_of_two().max(4);
                let length = if places <= power / 4 * 3 { power / 4 * 3 } else { power };
                return Plan { width: width as u32, digits_a, digits_b, length };
            }
            width -= 1;
        }
    }

    /// Places from the beginning of one entry to the beginning of the next.
    fn stride(&self) -> usize {
        self.digits_a + self.digits_b - 1
    }
}

/// The product of two nonempty vectors (entry k is Σ a_i b_{k−i}), cut as `plan` says.
pub(super) fn product(a: &[Int], b: &[Int], plan: &Plan) -> Vec<Int> {
    let squaring = std::ptr::eq(a, b);
    let digits_a = digits(a, plan.digits_a, plan.width);
    let digits_b = if squaring { Vec::new() } else { digits(b, plan.digits_b, plan.width) };
    let mut table = Vec::new();
    let mut scratch = Vec::new();
    let images: [Vec<u64>; 3] = std::array::from_fn(|which| {
        let field = &FIELDS[which];
        fill_roots(field, GENERATORS[which], plan.length, &mut table);
        let mut x = residues(field, &digits_a, plan.digits_a, plan);
        forward(field, &table, &mut x);
        if squaring {
            scratch.clone_from(&x);
        } else {
            scratch = residues(field, &digits_b, plan.digits_b, plan);
            forward(field, &table, &mut scratch);
        }
        pointwise(field, &mut x, &scratch);
        backward(field, &mut table, &mut x);
        x
    });
    let places = images[0].iter().zip(&images[1]).zip(&images[2]).map(|((x, y), z)| lift(*x, *y, *z));
    assemble(places, a.len() + b.len() - 1, plan)
}

/// The signed digits of every entry, `count` for each, least significant first.
fn digits(entries: &[Int], count: usize, width: u32) -> Vec<i128> {
    let mut out = Vec::with_capacity(entries.len() * count);
    let mask = (1u128 << width) - 1;
    let mut words: Vec<u64> = Vec::new();
    for entry in entries {
        if let (Some(x), 1) = (entry.as_small(), count) {
            out.push(i128::from(x));
            continue;
        }
        words.clear();
        let negative = match entry.as_big() {
            Some(big) => {
                words.extend(big.iter_u64_digits());
                big.sign() == Sign::Minus
            }
            None => {
                let x = entry.as_small().unwrap_or(0);
                words.push(x.unsigned_abs());
                x < 0
            }
        };
        let word = |k: usize| u128::from(words.get(k).copied().unwrap_or(0));
        for j in 0..count {
            let position = j * width as usize;
            let (k, shift) = (position / 64, position % 64);
            // A digit of at most 124 bits touches at most three words.
            let mut value = (word(k) | word(k + 1) << 64) >> shift;
            if shift > 0 {
                value |= word(k + 2) << (128 - shift);
            }
            let digit = (value & mask) as i128;
            out.push(if negative { -digit } else { digit });
        }
    }
    out
}

/// The digits times R^{-1} modulo p, in 0..2p, each entry at its place.
fn residues(field: &Modulus, digits: &[i128], count: usize, plan: &Plan) -> Vec<u64> {
    let mut out = vec![0; plan.length];
    for (places, entry) in out.chunks_mut(plan.stride()).zip(digits.chunks_exact(count)) {
        for (place, &digit) in places.iter_mut().zip(entry) {
            let residue = field.reduce(digit.unsigned_abs());
            *place = if digit < 0 { 2 * field.p - residue } else { residue };
        }
    }
    out
}

/// Fills z with Montgomery forms of roots of unity: z_0 = 1, z_1² = −1, z_{2s}² = z_s, z_{2s+1}² = −z_s.
///
/// Block s of a level stands for the residue modulo x^{2m} − c; the two halves of the
/// block become the residues modulo x^m − z_s and x^m + z_s. Because the same z
/// serves every level, one table is enough.
fn fill_roots(field: &Modulus, generator: u64, length: usize, z: &mut Vec<u64>) {
    let count = (length.next_power_of_two() / 2).max(2);
    let root = field.pow(field.enter(generator), (field.p - 1) >> ROOT_ORDER_LOG);
    z.clear();
    z.push(field.enter(1));
    let mut order_log = 2;
    while z.len() < count {
        let step = field.pow(root, 1 << (ROOT_ORDER_LOG - order_log));
        for s in 0..z.len() {
            z.push(field.canonical(field.mul(z[s], step)));
        }
        order_log += 1;
    }
}

/// Blocks up to this size are transformed level by level, larger ones depth first, to stay in cache.
const CACHED: usize = 1 << 12;

/// Values (below 4p, in the order of the root table) of the polynomial with coefficients x (below 2p).
fn forward(field: &Modulus, z: &[u64], x: &mut [u64]) {
    if x.len().is_power_of_two() {
        return forward_block(field, z, x, 0);
    }
    // Length 3q: the residues modulo x^{2q} − 1 and x^q − i.
    let q = x.len() / 3;
    let two_p = 2 * field.p;
    let (low, high) = x.split_at_mut(2 * q);
    let (x0, x1) = low.split_at_mut(q);
    for ((a, b), c) in x0.iter_mut().zip(x1.iter()).zip(high.iter_mut()) {
        let sum = field.fold(*a + *c);
        *c = field.fold(field.fold(*a + two_p - *c) + field.mul(*b, z[1]));
        *a = sum;
    }
    forward_block(field, z, low, 0);
    forward_block(field, z, high, 2);
}

fn forward_block(field: &Modulus, z: &[u64], x: &mut [u64], block: usize) {
    if x.len() > CACHED {
        budget::steps((x.len() / 256) as u32);
        let (left, right) = x.split_at_mut(x.len() / 2);
        forward_halves(field, z[block], left, right);
        forward_block(field, z, left, 2 * block);
        forward_block(field, z, right, 2 * block + 1);
        return;
    }
    let mut size = x.len();
    let mut first = block;
    while size > 1 {
        for (s, part) in x.chunks_exact_mut(size).enumerate() {
            let (left, right) = part.split_at_mut(size / 2);
            forward_halves(field, z[first + s], left, right);
        }
        size /= 2;
        first *= 2;
    }
}

#[inline(always)]
fn forward_halves(field: &Modulus, root: u64, left: &mut [u64], right: &mut [u64]) {
    for (x, y) in left.iter_mut().zip(right) {
        let u = field.fold(*x);
        let v = field.mul(*y, root);
        *x = u + v;
        *y = u + 2 * field.p - v;
    }
}

/// x·y with the factor that undoes the length of the transform and all Montgomery factors.
fn pointwise(field: &Modulus, x: &mut [u64], y: &[u64]) {
    // Both digits and both products below bring R^{-1} each, so the factor is R^4 / n.
    let undo = |n: usize| {
        let inverse = field.invert(field.enter(n as u64));
        field.enter(field.enter(field.enter(inverse)))
    };
    let (first, second) =
        if x.len().is_power_of_two() { (x.len(), 0) } else { (x.len() / 3 * 2, x.len() / 3) };
    let mut from = 0;
    for part in [first, second] {
        if part > 0 {
            let factor = undo(part);
            for (a, b) in x[from..from + part].iter_mut().zip(&y[from..]) {
                *a = field.mul(field.mul(field.fold(*a), field.fold(*b)), factor);
            }
        }
        from += part;
    }
}

/// Undoes [`forward`] up to the factor in [`pointwise`]; leaves coefficients in 0..p. Inverts the table.
fn backward(field: &Modulus, z: &mut [u64], x: &mut [u64]) {
    let i = z[1];
    // z_s = w^{r(s)} with r(s) the reversed bits of s, for w of order 2·len: the inverses are,
    // within each power-of-two range of s, the negatives in reverse order.
    let mut from = 1;
    while from < z.len() {
        z[from..2 * from].reverse();
        for root in &mut z[from..2 * from] {
            *root = field.p - *root;
        }
        from *= 2;
    }
    let two_p = 2 * field.p;
    if x.len().is_power_of_two() {
        backward_block(field, z, x, 0);
    } else {
        let q = x.len() / 3;
        let half = field.invert(field.enter(2));
        let (low, high) = x.split_at_mut(2 * q);
        backward_block(field, z, low, 0);
        backward_block(field, z, high, 2);
        let (x0, x1) = low.split_at_mut(q);
        // With h = x0 + x1 X^q + x2 X^{2q}: the two residues are (x0 + x2, x1) and x0 + i x1 − x2.
        for ((a, b), c) in x0.iter_mut().zip(x1.iter()).zip(high.iter_mut()) {
            let twice = field.fold(*a + field.mul(*b, i)) + two_p - *c;
            *c = field.mul(twice, half);
            *a = field.fold(*a + two_p - *c);
        }
    }
    for a in x {
        *a = field.canonical(*a);
    }
}

fn backward_block(field: &Modulus, z: &[u64], x: &mut [u64], block: usize) {
    if x.len() > CACHED {
        budget::steps((x.len() / 256) as u32);
        let (left, right) = x.split_at_mut(x.len() / 2);
        backward_block(field, z, left, 2 * block);
        backward_block(field, z, right, 2 * block + 1);
        backward_halves(field, z[block], left, right);
        return;
    }
    let mut size = 2;
    while size <= x.len() {
        let first = block * (x.len() / size);
        for (s, part) in x.chunks_exact_mut(size).enumerate() {
            let (left, right) = part.split_at_mut(size / 2);
            backward_halves(field, z[first + s], left, right);
        }
        size *= 2;
    }
}

#[inline(always)]
fn backward_halves(field: &Modulus, root: u64, left: &mut [u64], right: &mut [u64]) {
    for (x, y) in left.iter_mut().zip(right) {
        let (u, v) = (*x, *y);
        *x = field.fold(u + v);
        *y = field.mul(u + 2 * field.p - v, root);
    }
}

impl Modulus {
    /// A representative below 2p of x < 4p.
    #[inline(always)]
    const fn fold(&self, x: u64) -> u64 {
        let y = x.wrapping_sub(2 * self.p);
        if x >= 2 * self.p { y } else { x }
    }
}

/// A signed number of up to 256 bits in two's complement: high · 2^128 + low.
#[derive(Clone, Copy, Debug, Default)]
struct Wide {
    low: u128,
    high: i128,
}

impl Wide {
    #[inline(always)]
    fn plus(self, other: Wide) -> Wide {
        let (low, carry) = self.low.overflowing_add(other.low);
        Wide { low, high: self.high + other.high + i128::from(carry) }
    }

    /// Division by 2^width rounding down, 0 < width < 128.
    #[inline(always)]
    fn shifted(self, width: u32) -> Wide {
        Wide { low: self.low >> width | (self.high as u128) << (128 - width), high: self.high >> width }
    }

    fn to_int(self) -> Int {
        let low = self.low as i128;
        if self.high == low >> 127 {
            return Int::from(low);
        }
        let negative = self.high < 0;
        let (mut low, mut high) = (self.low, self.high as u128);
        if negative {
            low = low.wrapping_neg();
            high = (!high).wrapping_add(u128::from(low == 0));
        }
        let halves = |x: u128| [x as u32, (x >> 32) as u32, (x >> 64) as u32, (x >> 96) as u32];
        let ([a, b, c, d], [e, f, g, h]) = (halves(low), halves(high));
        let sign = if negative { Sign::Minus } else { Sign::Plus };
        Int::from(BigInt::from_slice(sign, &[a, b, c, d, e, f, g, h]))
    }
}

/// The constants of Garner's algorithm, in Montgomery form.
const INVERSE_P0_MOD_P1: u64 = FIELDS[1].invert(FIELDS[1].enter(FIELDS[0].p - FIELDS[1].p));
const INVERSE_P0_MOD_P2: u64 = FIELDS[2].invert(FIELDS[2].enter(FIELDS[0].p - FIELDS[2].p));
const INVERSE_P1_MOD_P2: u64 = FIELDS[2].invert(FIELDS[2].enter(FIELDS[1].p - FIELDS[2].p));
const P01: u128 = FIELDS[0].p as u128 * FIELDS[1].p as u128;

/// The integer of size below 2^184 with the three given residues (Garner's algorithm).
#[inline]
fn lift(x: u64, y: u64, z: u64) -> Wide {
    let [_, f1, f2] = &FIELDS;
    // The primes lie close together, so a residue of one is below twice another.
    let v1 = f1.canonical(f1.mul(f1.sub(y, f1.canonical(x)), INVERSE_P0_MOD_P1));
    let w = f2.canonical(f2.mul(f2.sub(z, f2.canonical(x)), INVERSE_P0_MOD_P2));
    let v2 = f2.canonical(f2.mul(f2.sub(w, f2.canonical(v1)), INVERSE_P1_MOD_P2));
    // x + p0 v1 + p0 p1 v2
    let base = u128::from(x) + u128::from(FIELDS[0].p) * u128::from(v1);
    let mut value = times_p01(v2).plus(Wide { low: base, high: 0 });
    if value.high >> (RESULT_BITS + 1 - 128) != 0 {
        // Beyond 2^185: a negative number plus p0 p1 p2.
        let all = times_p01(f2.p);
        let (low, borrow) = value.low.overflowing_sub(all.low);
        value = Wide { low, high: value.high - all.high - i128::from(borrow) };
    }
    value
}

#[inline]
fn times_p01(v: u64) -> Wide {
    let low = u128::from(P01 as u64) * u128::from(v);
    let high = (P01 >> 64) * u128::from(v);
    Wide { low, high: 0 }.plus(Wide { low: high << 64, high: (high >> 64) as i128 })
}

/// Carries the digits of every entry together.
fn assemble(mut places: impl Iterator<Item = Wide>, entries: usize, plan: &Plan) -> Vec<Int> {
    let stride = plan.stride();
    if stride == 1 {
        return places.take(entries).map(Wide::to_int).collect();
    }
    let width = plan.width;
    let mask = (1u128 << width) - 1;
    let words = (stride * width as usize + 256).div_ceil(32) + 1;
    let mut buffer = vec![0u32; words];
    let mut out = Vec::with_capacity(entries);
    for _ in 0..entries {
        buffer.fill(0);
        let mut carry = Wide::default();
        for j in 0..stride {
            carry = carry.plus(places.next().unwrap_or_default());
            put(&mut buffer, j * width as usize, carry.low & mask);
            carry = carry.shifted(width);
        }
        let position = stride * width as usize;
        let negative = carry.high < 0;
        put(&mut buffer, position, carry.low & u128::from(u64::MAX));
        put(&mut buffer, position + 64, carry.shifted(64).low & u128::from(u64::MAX));
        if negative {
            negate(&mut buffer, position + 128);
        }
        let sign = if negative { Sign::Minus } else { Sign::Plus };
        out.push(Int::from(BigInt::from_slice(sign, &buffer)));
    }
    out
}

/// Writes up to 124 bits at a bit position that holds zeros.
#[inline]
fn put(buffer: &mut [u32], position: usize, value: u128) {
    let (k, shift) = (position / 32, position % 32);
    let low = value << shift;
    let high = if shift == 0 { 0 } else { (value >> (128 - shift)) as u32 };
    for (j, word) in buffer[k..k + 4].iter_mut().enumerate() {
        *word |= (low >> (32 * j)) as u32;
    }
    if high != 0 {
        buffer[k + 4] |= high;
    }
}

/// 2^bits − value, in place, for a value below 2^bits.
fn negate(buffer: &mut [u32], bits: usize) {
    let mut carry = true;
    for word in buffer.iter_mut() {
        let (x, more) = (!*word).overflowing_add(u32::from(carry));
        *word = x;
        carry = more;
    }
    buffer[bits / 32] &= ((1u64 << (bits % 32)) - 1) as u32;
    buffer[bits / 32 + 1..].fill(0);
}
