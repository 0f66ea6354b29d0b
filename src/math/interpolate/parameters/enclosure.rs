//! Rational bounds of roots and angles, and rounding that is certain.
//!
//! **Invariant.** A number lies between its bounds, lower ≤ x ≤ upper, and with p digits the bounds
//! of a root or an angle differ by at most 3 · 10^{−p}. Numbers are positive, and only operations
//! that grow with each operand are used, so that bounds go to bounds.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::power_of_ten;
use crate::budget;
use crate::math::number::{Int, Rational, rational};

/// Bounds of a number that is not negative.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bounds {
    lower: Rational,
    upper: Rational,
}

/// How much closer than the last decimal a number must lie to the middle of two decimals to be
/// taken for the middle: 10^{-(decimals + this)}. Only a number that is rational without being
/// known to be, such as t = 1/8 by the symmetry of the points, is ever so close.
const TIE_DIGITS: u32 = 60;

impl Bounds {
    pub(super) fn exactly(x: Rational) -> Self {
        Bounds { lower: x.clone(), upper: x }
    }

    /// floor and floor + 1 in units of 10^{−digits}.
    fn around(floor: Int, digits: u32) -> Self {
        let unit = power_of_ten(digits);
        let upper = Rational::new(&floor + Int::ONE, unit.clone());
        Bounds { lower: Rational::new(floor, unit), upper }
    }

    /// √x
    pub(super) fn square_root(x: &Rational, digits: u32) -> Self {
        match root(x) {
            Some(root) => Bounds::exactly(root),
            None => Bounds::around(scaled_root(x, digits), digits),
        }
    }

    /// √√x
    pub(super) fn fourth_root(x: &Rational, digits: u32) -> Self {
        match root(x).as_ref().and_then(root) {
            Some(root) => Bounds::exactly(root),
            // floor(√floor(√y)) = floor(√√y)
            None => Bounds::around(integer_root(&scaled_root(x, digits.saturating_mul(2))), digits),
        }
    }

    /// arctan √x for x > 0.
    pub(super) fn arctan_of_root(x: &Rational, digits: u32) -> Self {
        let work = Work::new(digits);
        if *x <= Rational::one() {
            return work.bounds(work.arctan(scaled_root(x, work.digits)));
        }
        let complement = work.arctan(scaled_root(&x.recip(), work.digits));
        work.bounds(work.half_pi() - complement)
    }

    /// π/2
    pub(super) fn half_pi(digits: u32) -> Self {
        let work = Work::new(digits);
        work.bounds(work.half_pi())
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Bounds { lower: &self.lower + &other.lower, upper: &self.upper + &other.upper }
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        Bounds { lower: &self.lower * &other.lower, upper: &self.upper * &other.upper }
    }

    /// q · self for q > 0.
    pub(super) fn scaled(&self, q: &Rational) -> Self {
        Bounds { lower: &self.lower * q, upper: &self.upper * q }
    }

    /// x y/(x + y) = 1/(1/x + 1/y), which grows with x and with y.
    pub(super) fn harmonic(&self, other: &Self) -> Self {
        let mean = |x: &Rational, y: &Rational| {
            if x.is_zero() || y.is_zero() { Rational::zero() } else { x * y / (x + y) }
        };
        Bounds { lower: mean(&self.lower, &other.lower), upper: mean(&self.upper, &other.upper) }
    }

    /// x/(x + y), which grows with x and falls with y.
    pub(super) fn part(&self, other: &Self) -> Self {
        let part = |x: &Rational, y: &Rational| if x.is_zero() { Rational::zero() } else { x / (x + y) };
        Bounds { lower: part(&self.lower, &other.upper), upper: part(&self.upper, &other.lower) }
    }

    /// The number rounded to this many decimals, half to even, if the bounds are close enough to
    /// tell.
    pub(super) fn settled(&self, decimals: u32) -> Option<Rational> {
        let (low, high) = (rounded(&self.lower, decimals), rounded(&self.upper, decimals));
        if low == high {
            return Some(low);
        }
        let close = Rational::new(Int::ONE, power_of_ten(decimals.saturating_add(TIE_DIGITS)));
        // Between the bounds lies the middle of two decimals, and the number with it.
        (&self.upper - &self.lower < close).then(|| rounded(&((low + high) / Int::from(2)), decimals))
    }
}

/// q rounded to this many decimals, half to even.
pub(super) fn rounded(q: &Rational, decimals: u32) -> Rational {
    let unit = power_of_ten(decimals);
    let scaled = q * &unit;
    let (floor, rest) = scaled.numer().div_mod_floor(scaled.denom());
    let twice = rest * Int::from(2);
    let up = twice > *scaled.denom() || (twice == *scaled.denom() && floor.is_odd());
    Rational::new(if up { floor + Int::ONE } else { floor }, unit)
}

/// √q if it is rational.
pub(super) fn root(q: &Rational) -> Option<Rational> {
    let exact = |x: &Int| {
        if x.is_negative() {
            return None;
        }
        let root = integer_root(x);
        (&root * &root == *x).then_some(root)
    };
    Some(Rational::new(exact(q.numer())?, exact(q.denom())?))
}

/// floor(√x) for x ≥ 0
fn integer_root(x: &Int) -> Int {
    Int::from(x.to_big().sqrt())
}

/// floor(10^digits √x) for x ≥ 0
fn scaled_root(x: &Rational, digits: u32) -> Int {
    let scaled = x * power_of_ten(digits.saturating_mul(2));
    integer_root(&scaled.numer().div_floor(scaled.denom()))
}

/// Arithmetic with integers in units of 10^{−digits}, with some digits more than asked for.
struct Work {
    wanted: u32,
    digits: u32,
    unit: BigInt,
}

/// How often the argument of arctan is halved before its series is summed.
const HALVINGS: u32 = 8;

impl Work {
    /// 12 digits more: the errors below are less than 2^8 (4p + 100) units for p digits, which is
    /// less than 10^12 for all p below 10^9.
    fn new(wanted: u32) -> Self {
        let digits = wanted.saturating_add(12);
        Work { wanted, digits, unit: power_of_ten(digits).into_big() }
    }

    /// The bounds of a number known up to 10^12 units.
    fn bounds(&self, value: BigInt) -> Bounds {
        let unit = power_of_ten(self.wanted);
        let nearest = Rational::new(Int::from(value), power_of_ten(self.digits - self.wanted)).floor();
        let bound = |step: i64| (&nearest + rational(step, 1)) / &unit;
        Bounds { lower: bound(-1).max(Rational::zero()), upper: bound(2) }
    }

    /// π/2 = 8 arctan(1/5) − 2 arctan(1/239) (Machin)
    fn half_pi(&self) -> BigInt {
        let inverse = |k: u32| self.series(&(&self.unit / k));
        inverse(5) * 8 - inverse(239) * 2
    }

    /// arctan x for 0 ≤ x ≤ 1, by arctan x = 2 arctan (x/(1 + √(1 + x²))). Each halving at least
    /// halves an error in x and adds less than 2 units.
    fn arctan(&self, x: Int) -> BigInt {
        let mut x = x.into_big();
        for _ in 0..HALVINGS {
            budget::step();
            let hypotenuse = (&self.unit * &self.unit + &x * &x).sqrt();
            x = &x * &self.unit / (&self.unit + hypotenuse);
        }
        self.series(&x) << HALVINGS
    }

    /// x − x³/3 + x⁵/5 − … for |x| ≤ 1/5, in at most p terms of at most 2 units of error each.
    fn series(&self, x: &BigInt) -> BigInt {
        let square = x * x / &self.unit;
        let (mut sum, mut power, mut k) = (BigInt::zero(), x.clone(), 1u32);
        while !power.is_zero() {
            budget::step();
            let term = &power / k;
            if k % 4 == 1 {
                sum += term
            } else {
                sum -= term
            }
            power = &power * &square / &self.unit;
            k += 2;
        }
        sum
    }
}
