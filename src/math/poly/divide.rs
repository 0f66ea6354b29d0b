//! Exact division of sparse polynomials in several variables.
//!
//! The terms of the dividend and of all products of a term of the quotient with one of the divisor
//! are met in descending order. Small boxes of exponents keep all of them in a dense array; else a
//! heap holds the next product of each term of the quotient, so that memory stays linear.
//!
//! S. C. Johnson, "Sparse polynomial arithmetic", SIGSAM Bulletin 8 (1974); M. Monagan, R. Pearce,
//! "Sparse polynomial division using a heap", J. Symb. Comp. 46 (2011).

use std::collections::BinaryHeap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Zero;

use super::multiply::Packing;
use super::multivariate::{Exponents, Terms};
use crate::budget;
use crate::math::number::Int;

type Term = (Exponents, Int);

/// A dense array may have this many cells for each term of the dividend and the divisor.
const CELLS_PER_TERM: u64 = 16;
const MOST_CELLS: u64 = 1 << 22;

/// The terms of a / b over the integers for nonzero a and b: `Some(None)` if that is no polynomial
/// with integer coefficients, `None` if the exponents do not fit in a word.
pub(super) fn quotient(a: &[Term], b: &[Term], variables: usize) -> Option<Option<Terms>> {
    let packing = Packing::new(a, b, variables)?;
    let degree = |terms: &[Term], k: usize| terms.iter().map(|(e, _)| e[k]).max().unwrap_or(0);
    let room: Option<Vec<u32>> = (0..variables).map(|k| degree(a, k).checked_sub(degree(b, k))).collect();
    let Some(room) = room else { return Some(None) };
    let division = Division { b, packing: &packing, room };
    let few = packing.cells <= CELLS_PER_TERM * (a.len() + b.len()) as u64 && packing.cells <= MOST_CELLS;
    if few && let Some(quotient) = division.dense(a) {
        return Some(quotient);
    }
    Some(division.by_heap(a))
}

struct Division<'a> {
    b: &'a [Term],
    packing: &'a Packing,
    /// The degrees of the quotient, if there is one.
    room: Vec<u32>,
}

impl Division<'_> {
    /// The monomial with this key divided by the leading one of b, if that can be in the quotient.
    fn shift(&self, key: u64) -> Option<Exponents> {
        let (lead, _) = self.b.first()?;
        let parts = self.packing.unpack(key).into_iter().zip(lead).zip(&self.room);
        parts.map(|((x, y), room)| x.checked_sub(*y).filter(|e| e <= room)).collect()
    }

    /// Outer `None` if numbers grow beyond 128 bits.
    fn dense(&self, a: &[Term]) -> Option<Option<Terms>> {
        let mut cells = vec![0i128; self.packing.cells as usize];
        for (e, c) in a {
            cells[self.packing.pack(e) as usize] = i128::from(c.as_small()?);
        }
        let b: Vec<(u64, i64)> =
            self.b.iter().map(|(e, c)| Some((self.packing.pack(e), c.as_small()?))).collect::<Option<_>>()?;
        let bits = |x: i128| 128 - x.unsigned_abs().leading_zeros();
        let height = b.iter().map(|(_, c)| bits(i128::from(*c))).max()?;
        let count = bits(b.len() as i128);
        let ((lead_key, lead), rest) = b.split_first()?;
        let mut quotient: Terms = Vec::new();
        for key in (0..cells.len()).rev() {
            let c = cells[key];
            if c == 0 {
                continue;
            }
            budget::steps(b.len() as u32 / 256 + 1);
            let Some(shift) = self.shift(key as u64) else { return Some(None) };
            if c % i128::from(*lead) != 0 {
                return Some(None);
            }
            let q = c / i128::from(*lead);
            // A cell gets at most one product for each term of b, and a word of the dividend.
            if bits(q) > 63 || bits(q) + height + count >= 126 {
                return None;
            }
            let base = key - *lead_key as usize;
            for (other, d) in rest {
                cells[base + *other as usize] -= i128::from(*d) * q;
            }
            quotient.push((shift, Int::from(q)));
        }
        Some(Some(quotient))
    }

    fn by_heap(&self, a: &[Term]) -> Option<Terms> {
        let b: Vec<u64> = self.b.iter().map(|(e, _)| self.packing.pack(e)).collect();
        let (lead, rest) = (&self.b.first()?.1, &self.b[1..]);
        let mut dividend = a.iter().map(|(e, c)| (self.packing.pack(e), c)).peekable();
        let mut quotient: Terms = Vec::new();
        let mut keys: Vec<u64> = Vec::new();
        // For each term of the quotient the next product: its key, that term, and the one of `rest`.
        let mut heap: BinaryHeap<(u64, u32, u32)> = BinaryHeap::new();
        loop {
            let key = match (dividend.peek(), heap.peek()) {
                (Some((x, _)), Some((y, ..))) => *x.max(y),
                (Some((x, _)), None) => *x,
                (None, Some((y, ..))) => *y,
                (None, None) => return Some(quotient),
            };
            budget::step();
            let mut sum = Sum::default();
            if let Some((_, c)) = dividend.next_if(|(x, _)| *x == key) {
                sum.add(c);
            }
            while let Some(mut top) = heap.peek_mut().filter(|top| top.0 == key) {
                let (_, i, j) = *top;
                sum.subtract_product(&quotient[i as usize].1, &rest[j as usize].1);
                match b.get(j as usize + 2) {
                    Some(next) => *top = (keys[i as usize] + next, i, j + 1),
                    None => drop(std::collections::binary_heap::PeekMut::pop(top)),
                }
            }
            let c = sum.value();
            if c.is_zero() {
                continue;
            }
            let shift = self.shift(key)?;
            let (q, r) = c.div_rem(lead);
            if !r.is_zero() {
                return None;
            }
            budget::charge_terms(quotient.len() as u64);
            keys.push(key - b[0]);
            if let Some(next) = b.get(1) {
                heap.push((key - b[0] + next, quotient.len() as u32, 0));
            }
            quotient.push((shift, q));
        }
    }
}

/// A sum of products, in 128 bits as long as that is possible.
#[derive(Default)]
struct Sum {
    small: i128,
    large: BigInt,
}

impl Sum {
    fn add(&mut self, x: &Int) {
        match x.as_big() {
            Some(x) => self.large += x,
            None => self.small += i128::from(x.as_small().unwrap_or(0)),
        }
    }

    fn subtract_product(&mut self, x: &Int, y: &Int) {
        if let (Some(x), Some(y)) = (x.as_small(), y.as_small()) {
            let product = i128::from(x) * i128::from(y);
            match self.small.checked_sub(product) {
                Some(small) => self.small = small,
                None => self.large -= product,
            }
            return;
        }
        self.large -= (x * y).into_big();
    }

    fn value(self) -> Int {
        if self.large.is_zero() { Int::from(self.small) } else { Int::from(self.large + self.small) }
    }
}
