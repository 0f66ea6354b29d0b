//! Integers of any size that stay in one machine word while they fit.
//!
//! **Canonical form.** An [`Int`] is *small* (an `i64`) whenever its value fits in
//! an `i64`; only otherwise does it own a heap-allocated [`BigInt`]. Every
//! constructor and operation re-establishes this, so equality and hashing may
//! compare representations.
//!
//! Most coefficients met in lecture notes have a few digits. Keeping those out of
//! the heap makes `num_rational::Ratio<Int>` (our [`Rational`](super::Rational))
//! several times faster than `BigRational` while num-bigint still carries every
//! value that does not fit.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};
use std::str::FromStr;

use num_bigint::{BigInt, ParseBigIntError, Sign, ToBigInt};
use num_integer::Integer;
use num_traits::{FromPrimitive, Num, One, Signed, ToPrimitive, Zero};

use super::lehmer;

/// An integer of any size; values that fit in an `i64` need no allocation.
///
/// ```
/// use polarform::number::Int;
/// let big = Int::from(i64::MAX) + Int::from(1);
/// assert_eq!(big.to_string(), "9223372036854775808");
/// assert_eq!(big - Int::from(1), Int::from(i64::MAX)); // small again
/// ```
#[derive(Clone)]
pub struct Int(Repr);

#[derive(Clone)]
enum Repr {
    Small(i64),
    Big(Box<BigInt>),
}

use Repr::{Big, Small};

impl Int {
    /// The integer 0.
    pub const ZERO: Int = Int(Small(0));
    /// The integer 1.
    pub const ONE: Int = Int(Small(1));

    /// The value as an `i64` if it fits, at no cost.
    #[inline]
    pub fn as_small(&self) -> Option<i64> {
        match self.0 {
            Small(x) => Some(x),
            Big(_) => None,
        }
    }

    /// The value as a borrowed [`BigInt`] when it does not fit in a word, at no cost.
    #[inline]
    pub(crate) fn as_big(&self) -> Option<&BigInt> {
        match &self.0 {
            Small(_) => None,
            Big(b) => Some(b),
        }
    }

    /// The value as a [`BigInt`] (allocates).
    pub fn to_big(&self) -> BigInt {
        match &self.0 {
            Small(x) => BigInt::from(*x),
            Big(b) => (**b).clone(),
        }
    }

    /// The value as a [`BigInt`], reusing the allocation if there is one.
    pub fn into_big(self) -> BigInt {
        match self.0 {
            Small(x) => BigInt::from(x),
            Big(b) => *b,
        }
    }

    /// Number of bits of the absolute value; 0 for 0.
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small(x) => u64::from(64 - x.unsigned_abs().leading_zeros()),
            Big(b) => b.bits(),
        }
    }

    /// self^exponent. Cost: O(log exponent) products of growing size.
    ///
    /// ```
    /// # use polarform::number::Int;
    /// assert_eq!(Int::from(-2).pow(3), Int::from(-8));
    /// assert_eq!(Int::from(0).pow(0), Int::from(1));
    /// ```
    pub fn pow(&self, exponent: u32) -> Int {
        if let Small(x) = self.0
            && let Some(y) = x.checked_pow(exponent)
        {
            return Int(Small(y));
        }
        Int::from(self.to_big().pow(exponent))
    }

    /// self / divisor where the division is known to leave no remainder.
    ///
    /// # Panics
    /// If the divisor is 0; in debug builds also if there is a remainder.
    pub fn div_exact(&self, divisor: &Int) -> Int {
        debug_assert!((self % divisor).is_zero(), "{self} / {divisor} is not exact");
        if divisor.is_one() {
            return self.clone();
        }
        self / divisor
    }

    /// The remainder of self modulo the word `m`, in 0..m.
    ///
    /// # Panics
    /// If `m` is 0.
    pub fn mod_word(&self, m: u64) -> u64 {
        match &self.0 {
            Small(x) => {
                let r = x.unsigned_abs() % m;
                if *x < 0 && r != 0 { m - r } else { r }
            }
            Big(b) => {
                let r = (b.magnitude() % m).to_u64().unwrap_or(0);
                if b.sign() == Sign::Minus && r != 0 { m - r } else { r }
            }
        }
    }
}

impl From<BigInt> for Int {
    fn from(value: BigInt) -> Self {
        match value.to_i64() {
            Some(x) => Int(Small(x)),
            None => Int(Big(Box::new(value))),
        }
    }
}

impl From<Int> for BigInt {
    fn from(value: Int) -> Self {
        value.into_big()
    }
}

impl From<i128> for Int {
    #[inline]
    fn from(value: i128) -> Self {
        match i64::try_from(value) {
            Ok(x) => Int(Small(x)),
            Err(_) => Int(Big(Box::new(BigInt::from(value)))),
        }
    }
}

macro_rules! from_word {
    ($($t:ty),*) => {$(
        impl From<$t> for Int {
            #[inline]
            fn from(value: $t) -> Self {
                Int::from(value as i128)
            }
        }
    )*};
}
from_word!(i8, i16, i32, i64, isize, u8, u16, u32, u64, usize);

macro_rules! binary {
    ($Trait:ident, $method:ident, $Assign:ident, $assign:ident, |$a:ident, $b:ident| $small:expr) => {
        impl<'b> $Trait<&'b Int> for &Int {
            type Output = Int;
            #[inline]
            fn $method(self, rhs: &'b Int) -> Int {
                if let (Small($a), Small($b)) = (&self.0, &rhs.0) {
                    let ($a, $b) = (*$a, *$b);
                    if let Some(result) = $small {
                        return result;
                    }
                }
                match (&self.0, &rhs.0) {
                    (Big(x), Big(y)) => Int::from((&**x).$method(&**y)),
                    (Big(x), Small(y)) => Int::from((&**x).$method(*y)),
                    (Small(x), Big(y)) => Int::from((*x).$method(&**y)),
                    (Small(x), Small(y)) => Int::from(BigInt::from(*x).$method(*y)),
                }
            }
        }
        impl $Trait<Int> for &Int {
            type Output = Int;
            #[inline]
            fn $method(self, rhs: Int) -> Int {
                self.$method(&rhs)
            }
        }
        impl $Trait<&Int> for Int {
            type Output = Int;
            #[inline]
            fn $method(self, rhs: &Int) -> Int {
                (&self).$method(rhs)
            }
        }
        impl $Trait<Int> for Int {
            type Output = Int;
            #[inline]
            fn $method(self, rhs: Int) -> Int {
                (&self).$method(&rhs)
            }
        }
        impl $Assign<&Int> for Int {
            #[inline]
            fn $assign(&mut self, rhs: &Int) {
                if let (Small($a), Small($b)) = (&self.0, &rhs.0) {
                    let ($a, $b) = (*$a, *$b);
                    if let Some(result) = $small {
                        *self = result;
                        return;
                    }
                }
                let mut left = std::mem::replace(self, Int::ZERO).into_big();
                match &rhs.0 {
                    Small(y) => left.$assign(*y),
                    Big(y) => left.$assign(&**y),
                }
                *self = Int::from(left);
            }
        }
        impl $Assign<Int> for Int {
            #[inline]
            fn $assign(&mut self, rhs: Int) {
                self.$assign(&rhs);
            }
        }
    };
}
binary!(Add, add, AddAssign, add_assign, |a, b| a.checked_add(b).map(|x| Int(Small(x))));
binary!(Sub, sub, SubAssign, sub_assign, |a, b| a.checked_sub(b).map(|x| Int(Small(x))));
binary!(Mul, mul, MulAssign, mul_assign, |a, b| Some(Int::from(i128::from(a) * i128::from(b))));
binary!(Div, div, DivAssign, div_assign, |a, b| a.checked_div(b).map(|x| Int(Small(x))));
binary!(Rem, rem, RemAssign, rem_assign, |a, b| a.checked_rem(b).map(|x| Int(Small(x))));

impl Neg for &Int {
    type Output = Int;
    fn neg(self) -> Int {
        match &self.0 {
            Small(x) => Int::from(-i128::from(*x)),
            Big(b) => Int::from(-&**b),
        }
    }
}

impl Neg for Int {
    type Output = Int;
    fn neg(self) -> Int {
        match self.0 {
            Small(x) => Int::from(-i128::from(x)),
            Big(b) => Int::from(-*b),
        }
    }
}

impl PartialEq for Int {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Small(a), Small(b)) => a == b,
            (Big(a), Big(b)) => a == b,
            _ => false,
        }
    }
}

impl Eq for Int {}

impl Hash for Int {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.0 {
            Small(x) => x.hash(state),
            Big(b) => b.hash(state),
        }
    }
}

impl PartialOrd for Int {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Int {
    fn cmp(&self, other: &Self) -> Ordering {
        let sign = |b: &BigInt| {
            if b.sign() == Sign::Minus { Ordering::Less } else { Ordering::Greater }
        };
        match (&self.0, &other.0) {
            (Small(a), Small(b)) => a.cmp(b),
            (Big(a), Big(b)) => a.cmp(b),
            (Big(a), Small(_)) => sign(a),
            (Small(_), Big(b)) => sign(b).reverse(),
        }
    }
}

impl Default for Int {
    fn default() -> Self {
        Int::ZERO
    }
}

impl Zero for Int {
    fn zero() -> Self {
        Int::ZERO
    }
    #[inline]
    fn is_zero(&self) -> bool {
        matches!(self.0, Small(0))
    }
}

impl One for Int {
    fn one() -> Self {
        Int::ONE
    }
    #[inline]
    fn is_one(&self) -> bool {
        matches!(self.0, Small(1))
    }
}

impl Num for Int {
    type FromStrRadixErr = ParseBigIntError;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        BigInt::from_str_radix(text, radix).map(Int::from)
    }
}

impl FromStr for Int {
    type Err = ParseBigIntError;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.parse::<i64>() {
            Ok(x) => Ok(Int(Small(x))),
            Err(_) => text.parse::<BigInt>().map(Int::from),
        }
    }
}

impl Signed for Int {
    fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }
    fn abs_sub(&self, other: &Self) -> Self {
        if self <= other { Int::ZERO } else { self - other }
    }
    fn signum(&self) -> Self {
        match self.cmp(&Int::ZERO) {
            Ordering::Less => Int(Small(-1)),
            Ordering::Equal => Int::ZERO,
            Ordering::Greater => Int::ONE,
        }
    }
    fn is_positive(&self) -> bool {
        *self > Int::ZERO
    }
    #[inline]
    fn is_negative(&self) -> bool {
        match &self.0 {
            Small(x) => *x < 0,
            Big(b) => b.sign() == Sign::Minus,
        }
    }
}

/// Greatest common divisor of two words, by Stein's binary algorithm.
#[inline]
pub(crate) fn gcd_word(mut a: u64, mut b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    loop {
        b >>= b.trailing_zeros();
        if a > b {
            std::mem::swap(&mut a, &mut b);
        }
        b -= a;
        if b == 0 {
            return a << shift;
        }
    }
}

impl Integer for Int {
    fn div_floor(&self, other: &Self) -> Self {
        self.div_mod_floor(other).0
    }
    fn mod_floor(&self, other: &Self) -> Self {
        self.div_mod_floor(other).1
    }
    fn div_mod_floor(&self, other: &Self) -> (Self, Self) {
        if let (Small(a), Small(b)) = (&self.0, &other.0)
            && *b != -1
        {
            let (q, r) = a.div_mod_floor(b);
            return (Int(Small(q)), Int(Small(r)));
        }
        let (q, r) = self.to_big().div_mod_floor(&other.to_big());
        (Int::from(q), Int::from(r))
    }
    #[inline]
    fn gcd(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Small(a), Small(b)) => Int::from(gcd_word(a.unsigned_abs(), b.unsigned_abs())),
            // One division brings the pair down to a word.
            (Small(a), Big(_)) if *a != 0 => {
                let a = a.unsigned_abs();
                Int::from(gcd_word(a, other.mod_word(a)))
            }
            (Big(_), Small(b)) if *b != 0 => {
                let b = b.unsigned_abs();
                Int::from(gcd_word(b, self.mod_word(b)))
            }
            (Big(a), Big(b)) => Int::from(BigInt::from(lehmer::gcd(a.magnitude(), b.magnitude()))),
            (Big(_), Small(_)) => self.abs(),
            (Small(_), Big(_)) => other.abs(),
        }
    }
    fn lcm(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Int::ZERO;
        }
        (self.div_exact(&self.gcd(other)) * other).abs()
    }
    fn divides(&self, other: &Self) -> bool {
        self.is_multiple_of(other)
    }
    fn is_multiple_of(&self, other: &Self) -> bool {
        if other.is_zero() { self.is_zero() } else { (self % other).is_zero() }
    }
    fn is_even(&self) -> bool {
        match &self.0 {
            Small(x) => x % 2 == 0,
            Big(b) => b.is_even(),
        }
    }
    fn is_odd(&self) -> bool {
        !self.is_even()
    }
    fn div_rem(&self, other: &Self) -> (Self, Self) {
        if let (Small(a), Small(b)) = (&self.0, &other.0)
            && *b != -1
        {
            return (Int(Small(a / b)), Int(Small(a % b)));
        }
        let (q, r) = match (&self.0, &other.0) {
            (Big(a), Big(b)) => a.div_rem(b),
            _ => self.to_big().div_rem(&other.to_big()),
        };
        (Int::from(q), Int::from(r))
    }
}

impl ToPrimitive for Int {
    fn to_i64(&self) -> Option<i64> {
        self.as_small()
    }
    fn to_u64(&self) -> Option<u64> {
        match &self.0 {
            Small(x) => u64::try_from(*x).ok(),
            Big(b) => b.to_u64(),
        }
    }
    fn to_i128(&self) -> Option<i128> {
        match &self.0 {
            Small(x) => Some(i128::from(*x)),
            Big(b) => b.to_i128(),
        }
    }
    fn to_f64(&self) -> Option<f64> {
        match &self.0 {
            Small(x) => Some(*x as f64),
            Big(b) => b.to_f64(),
        }
    }
}

/// Gives `Rational::to_f64`, correctly rounded however long the two numbers are.
impl ToBigInt for Int {
    fn to_bigint(&self) -> Option<BigInt> {
        Some(self.to_big())
    }
}

impl FromPrimitive for Int {
    fn from_i64(n: i64) -> Option<Self> {
        Some(Int::from(n))
    }
    fn from_u64(n: u64) -> Option<Self> {
        Some(Int::from(n))
    }
}

impl fmt::Display for Int {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Small(x) => x.fmt(f),
            Big(b) => b.fmt(f),
        }
    }
}

impl fmt::Debug for Int {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::iter::Sum for Int {
    fn sum<I: Iterator<Item = Int>>(iter: I) -> Int {
        iter.fold(Int::ZERO, |a, b| a + b)
    }
}

impl std::iter::Product for Int {
    fn product<I: Iterator<Item = Int>>(iter: I) -> Int {
        iter.fold(Int::ONE, |a, b| a * b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_int() -> impl Strategy<Value = BigInt> {
        prop_oneof![
            any::<i8>().prop_map(BigInt::from),
            any::<i64>().prop_map(BigInt::from),
            Just(BigInt::from(i64::MIN)),
            Just(BigInt::from(i64::MAX)),
            Just(BigInt::from(i64::MAX) + 1),
            Just(BigInt::from(-1)),
            any::<(i128, i128)>().prop_map(|(a, b)| BigInt::from(a) * b),
        ]
    }

    fn canonical(x: &Int) -> bool {
        match &x.0 {
            Small(_) => true,
            Big(b) => b.to_i64().is_none(),
        }
    }

    proptest! {
        #[test]
        fn agrees_with_bigint(a in any_int(), b in any_int()) {
            let (x, y) = (Int::from(a.clone()), Int::from(b.clone()));
            let check = |ours: Int, theirs: BigInt| {
                assert!(canonical(&ours));
                assert_eq!(ours.to_big(), theirs);
            };
            check(&x + &y, &a + &b);
            check(&x - &y, &a - &b);
            check(&x * &y, &a * &b);
            check(-&x, -&a);
            check(x.gcd(&y), a.gcd(&b));
            check(x.lcm(&y), a.lcm(&b));
            check(x.abs(), a.abs());
            if !b.is_zero() {
                check(&x / &y, &a / &b);
                check(&x % &y, &a % &b);
                check(x.mod_floor(&y), a.mod_floor(&b));
                check(x.div_floor(&y), a.div_floor(&b));
            }
            let mut z = x.clone();
            z += &y;
            check(z.clone(), &a + &b);
            z -= &y;
            check(z.clone(), a.clone());
            z *= &y;
            check(z, &a * &b);
            assert_eq!(x.cmp(&y), a.cmp(&b));
            assert_eq!(x.to_string(), a.to_string());
            assert_eq!(a.to_string().parse::<Int>().unwrap(), x);
            assert_eq!(BigInt::from(x.mod_word(97)), a.mod_floor(&BigInt::from(97)));
        }
    }
}
