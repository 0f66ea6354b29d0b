//! Exact numbers: integers, rationals, binomial coefficients, exact literals.
//!
//! [`Rational`] is `num_rational::Ratio` over [`Int`], an integer that keeps
//! word-sized values off the heap. A `Ratio` is always in lowest terms with a
//! positive denominator, so equality of values is equality of representations.

mod combinatorics;
mod factors;
mod int;
mod lehmer;
pub(crate) mod limbs;
mod literal;
mod modular;
mod root;

pub use combinatorics::{Combinations, binomial, binomial_row, binomials_where, factorial, multinomial};
pub use factors::prime_factors;
pub use int::Int;
pub(crate) use int::gcd_word;
pub use literal::{LiteralError, parse_decimal, parse_scientific};
pub(crate) use modular::{Modulus, combine, primes};
pub use root::exact_root;

/// An exact rational number in lowest terms with positive denominator.
pub type Rational = num_rational::Ratio<Int>;

/// The rational p/q.
///
/// # Panics
/// If `q` is 0.
///
/// ```
/// use polarform::number::rational;
/// assert_eq!(rational(2, -4).to_string(), "-1/2");
/// ```
pub fn rational(p: i64, q: i64) -> Rational {
    Rational::new(Int::from(p), Int::from(q))
}

/// The integer `p` as a rational.
pub fn integer(p: i64) -> Rational {
    Rational::from_integer(Int::from(p))
}

/// The numbers as integers over their least common denominator.
pub(crate) fn over_one_denominator(numbers: &[Rational]) -> (Vec<Int>, Int) {
    let scale = numbers.iter().fold(Int::ONE, |scale, x| num_integer::Integer::lcm(&scale, x.denom()));
    (numbers.iter().map(|x| x.numer() * &scale.div_exact(x.denom())).collect(), scale)
}
