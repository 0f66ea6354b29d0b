//! Roots that are rational.

use num_bigint::BigInt;
use num_traits::Signed;

use super::{Int, Rational};

/// The rational x with x^n = q, not negative where there are two; `None` if there is none, and for
/// n = 0.
///
/// p/q in lowest terms is an n-th power iff p and q are. Cost: two integer roots.
///
/// ```
/// use polarform::number::{exact_root, rational as q};
/// assert_eq!(exact_root(&q(9, 4), 2), Some(q(3, 2)));
/// assert_eq!(exact_root(&q(-1, 27), 3), Some(q(-1, 3)));
/// assert_eq!(exact_root(&q(1, 2), 2), None);
/// ```
pub fn exact_root(q: &Rational, n: u32) -> Option<Rational> {
    if n == 0 || (n.is_multiple_of(2) && q.is_negative()) {
        return None;
    }
    let root = |x: &Int| -> Option<Int> {
        let x: BigInt = x.to_big();
        let candidate = x.nth_root(n);
        (candidate.pow(n) == x).then(|| candidate.into())
    };
    Some(Rational::new(root(q.numer())?, root(q.denom())?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn powers_have_roots(p in -2000i64..2000, r in 1i64..2000, n in 1u32..6) {
            let x = rational(p, r);
            let power = num_traits::pow(x.clone(), n as usize);
            let expected = if n % 2 == 0 { x.abs() } else { x };
            prop_assert_eq!(exact_root(&power, n), Some(expected));
            if let Some(root) = exact_root(&rational(p, r), n) {
                prop_assert_eq!(num_traits::pow(root, n as usize), rational(p, r));
            }
        }
    }

    #[test]
    fn none_where_there_is_none() {
        assert_eq!(exact_root(&rational(-4, 1), 2), None);
        assert_eq!(exact_root(&rational(4, 1), 0), None);
        assert_eq!(exact_root(&rational(0, 1), 7), Some(rational(0, 1)));
    }
}
