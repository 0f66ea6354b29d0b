//! Quotients of polynomials in several symbols, in lowest terms.
//!
//! **Canonical form.** Numerator and denominator have no common factor; the denominator is
//! primitive (integer coefficients without common factor) with positive leading coefficient
//! in lexicographic order, so every rational factor is in the numerator; 0 is 0/1.
//! Nearly always both denominators are 1, and then no gcd is computed at all.

use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use std::sync::{Arc, LazyLock};

use num_traits::{One, Zero};

use super::multivariate::MultiPoly;
use super::ring_ops::ring_operators;
use super::symbol::Symbol;
use crate::math::number::Rational;
use crate::math::ring::{Field, Ring};

/// A rational function in any symbols.
///
/// ```
/// use polarform::poly::{Fraction, MultiPoly, Symbol};
/// let s = |name: &str| Fraction::from(MultiPoly::symbol(Symbol::new(name)));
/// let ratio = (s("x") * s("x") - s("y") * s("y")) / (s("x") - s("y"));
/// assert_eq!(ratio, s("x") + s("y"));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Fraction {
    numerator: MultiPoly,
    /// Nothing for 1, which nearly all are: a polynomial takes no room for its denominator.
    below: Option<Arc<MultiPoly>>,
}

static ONE: LazyLock<MultiPoly> = LazyLock::new(MultiPoly::one);

/// Division by zero in an operation on fractions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DivisionByZero;

impl fmt::Display for DivisionByZero {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("division by zero")
    }
}

impl std::error::Error for DivisionByZero {}

impl From<MultiPoly> for Fraction {
    fn from(numerator: MultiPoly) -> Self {
        Fraction { numerator, below: None }
    }
}

impl From<Rational> for Fraction {
    fn from(q: Rational) -> Self {
        Fraction::from(MultiPoly::constant(q))
    }
}

impl Fraction {
    /// numerator / denominator in lowest terms.
    ///
    /// # Errors
    /// [`DivisionByZero`] if the denominator is 0.
    pub fn new(numerator: MultiPoly, denominator: MultiPoly) -> Result<Self, DivisionByZero> {
        if denominator.is_zero() {
            return Err(DivisionByZero);
        }
        let g = numerator.gcd(&denominator);
        Ok(Fraction::from_coprime(exact(&numerator, &g), exact(&denominator, &g)))
    }

    fn over(numerator: MultiPoly, denominator: MultiPoly) -> Self {
        Fraction { numerator, below: (!denominator.is_one()).then(|| Arc::new(denominator)) }
    }

    /// The canonical form of a quotient without common polynomial factor.
    fn from_coprime(numerator: MultiPoly, denominator: MultiPoly) -> Self {
        if numerator.is_zero() {
            return Fraction::from(MultiPoly::zero());
        }
        let primitive = denominator.primitive_part();
        // denominator = factor · primitive with a rational factor.
        let factor = denominator.leading_coefficient() / primitive.leading_coefficient();
        let result = Fraction::over(numerator.scaled(&factor.recip()), primitive);
        debug_assert!(result.is_canonical());
        result
    }

    /// Whether the representation is the canonical one; always true from outside.
    pub fn is_canonical(&self) -> bool {
        let denominator = self.denominator();
        *denominator == denominator.primitive_part()
            && !denominator.is_zero()
            && (self.numerator.gcd(denominator).is_one() || self.numerator.is_zero())
            && (!self.numerator.is_zero() || denominator.is_one())
            && self.below.as_ref().is_none_or(|denominator| !denominator.is_one())
    }

    /// The numerator; it holds all rational factors.
    pub fn numerator(&self) -> &MultiPoly {
        &self.numerator
    }

    /// The denominator, a primitive polynomial.
    pub fn denominator(&self) -> &MultiPoly {
        self.below.as_deref().unwrap_or(&ONE)
    }

    /// The polynomial this is, if the denominator is 1.
    pub fn as_polynomial(&self) -> Option<&MultiPoly> {
        self.below.is_none().then_some(&self.numerator)
    }

    /// The rational number this is, if it is constant.
    pub fn as_rational(&self) -> Option<Rational> {
        self.as_polynomial().and_then(MultiPoly::as_constant)
    }

    /// All symbols that occur, in natural order.
    pub fn variables(&self) -> Vec<Symbol> {
        let mut list: Vec<Symbol> =
            self.numerator.variables().iter().chain(self.denominator().variables()).cloned().collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// self^exponent; a power of a reduced fraction is reduced.
    ///
    /// # Errors
    /// [`DivisionByZero`] for a negative power of 0.
    pub fn pow(&self, exponent: i32) -> Result<Self, DivisionByZero> {
        let k = exponent.unsigned_abs();
        if exponent >= 0 {
            return Ok(self.powered(k));
        }
        if self.is_zero() {
            return Err(DivisionByZero);
        }
        Ok(Fraction::from_coprime(self.denominator().pow(k), self.numerator.pow(k)))
    }

    /// Replaces symbols by fractions, all at once.
    ///
    /// # Errors
    /// [`DivisionByZero`] if a denominator becomes 0.
    pub fn substitute(&self, replacements: &[(Symbol, Fraction)]) -> Result<Self, DivisionByZero> {
        let plain: Option<Vec<(Symbol, MultiPoly)>> = replacements
            .iter()
            .map(|(symbol, f)| Some((symbol.clone(), f.as_polynomial()?.clone())))
            .collect();
        if let Some(plain) = plain {
            let numerator = self.numerator.substitute(&plain);
            if self.below.is_none() {
                return Ok(Fraction::from(numerator));
            }
            return Fraction::new(numerator, self.denominator().substitute(&plain));
        }
        let numerator = substitute_fractions(&self.numerator, replacements);
        let denominator = substitute_fractions(self.denominator(), replacements);
        let inverse = denominator.inverse().ok_or(DivisionByZero)?;
        Ok(numerator.times(&inverse))
    }

    /// ∂/∂symbol, by the quotient rule.
    pub fn derivative(&self, symbol: &Symbol) -> Self {
        let (n, d) = (&self.numerator, self.denominator());
        if d.degree_in(symbol) == 0 {
            return Fraction::new(n.derivative(symbol), d.clone()).unwrap_or_else(|_| self.clone());
        }
        let top = n.derivative(symbol).times(d).minus(&n.times(&d.derivative(symbol)));
        Fraction::new(top, d.times(d)).unwrap_or_else(|_| self.clone())
    }

    /// The value at numbers for all symbols; `None` if one is missing or the denominator vanishes.
    pub fn value(&self, value: &dyn Fn(&Symbol) -> Option<Rational>) -> Option<Rational> {
        let denominator = self.denominator().value(value).as_constant()?;
        if denominator.is_zero() {
            return None;
        }
        Some(self.numerator.value(value).as_constant()? / denominator)
    }
}

/// p with fractions put in, all at once.
fn substitute_fractions(p: &MultiPoly, replacements: &[(Symbol, Fraction)]) -> Fraction {
    let mut sum = Fraction::zero();
    for (powers, c) in p.terms(super::MonomialOrder::Lex) {
        crate::budget::step();
        let mut term = Fraction::from(c);
        for (symbol, e) in powers {
            let value = match replacements.iter().find(|(s, _)| *s == symbol) {
                Some((_, value)) => value.clone(),
                None => Fraction::from(MultiPoly::symbol(symbol)),
            };
            term = term.times(&value.powered(e));
        }
        sum += term;
    }
    sum
}

/// a / b where b is known to divide a.
fn exact(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    if b.is_one() { a.clone() } else { a.div_exact(b).unwrap_or_else(|| a.clone()) }
}

impl Ring for Fraction {
    fn from_rational(q: &Rational) -> Self {
        Fraction::from(q.clone())
    }

    fn plus(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        if a.below.is_none() && b.below.is_none() {
            return Fraction::from(a.numerator.plus(&b.numerator));
        }
        // With g = gcd of the denominators only g can share a factor with the new numerator
        // (Henrici; Knuth, TAOCP vol. 2, 4.5.1).
        let g = a.denominator().gcd(b.denominator());
        let (x, y) = (exact(a.denominator(), &g), exact(b.denominator(), &g));
        let top = a.numerator.times(&y).plus(&b.numerator.times(&x));
        let h = top.gcd(&g);
        Fraction::from_coprime(exact(&top, &h), x.times(&exact(b.denominator(), &h)))
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&-other.clone())
    }

    fn times(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        if a.below.is_none() && b.below.is_none() {
            return Fraction::from(a.numerator.times(&b.numerator));
        }
        let g = a.numerator.gcd(b.denominator());
        let h = b.numerator.gcd(a.denominator());
        if a.is_zero() || b.is_zero() {
            return Fraction::zero();
        }
        Fraction::from_coprime(
            exact(&a.numerator, &g).times(&exact(&b.numerator, &h)),
            exact(a.denominator(), &h).times(&exact(b.denominator(), &g)),
        )
    }

    fn size(&self) -> u64 {
        self.numerator.size() + self.denominator().size() - 1
    }

    fn scaled(&self, q: &Rational) -> Self {
        if q.is_zero() {
            return Fraction::zero();
        }
        Fraction { numerator: self.numerator.scaled(q), below: self.below.clone() }
    }

    fn as_rational(&self) -> Option<Rational> {
        Fraction::as_rational(self)
    }

    fn powered(&self, exponent: u32) -> Self {
        let numerator = self.numerator.pow(exponent);
        match &self.below {
            None => Fraction::from(numerator),
            Some(denominator) => Fraction::over(numerator, denominator.pow(exponent)),
        }
    }
}

impl Field for Fraction {
    fn inverse(&self) -> Option<Self> {
        (!self.is_zero()).then(|| Fraction::from_coprime(self.denominator().clone(), self.numerator.clone()))
    }
}

impl Zero for Fraction {
    fn zero() -> Self {
        Fraction::from(MultiPoly::zero())
    }
    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

impl One for Fraction {
    fn one() -> Self {
        Fraction::from(MultiPoly::one())
    }
    fn is_one(&self) -> bool {
        self.numerator.is_one() && self.below.is_none()
    }
}

impl Neg for Fraction {
    type Output = Fraction;
    fn neg(self) -> Fraction {
        Fraction { numerator: -self.numerator, below: self.below }
    }
}

ring_operators!(
    Add add AddAssign add_assign plus,
    Sub sub SubAssign sub_assign minus,
    Mul mul MulAssign mul_assign times;
    Fraction
);

impl Div for Fraction {
    type Output = Fraction;
    /// # Panics
    /// If the divisor is 0; [`Field::inverse`] is the way without panics.
    fn div(self, other: Fraction) -> Fraction {
        let inverse = other.inverse().expect("division by a nonzero fraction");
        self.times(&inverse)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |p: &MultiPoly| if p.len() > 1 { format!("({p})") } else { p.to_string() };
        match self.as_polynomial() {
            Some(p) => write!(f, "{p}"),
            None => write!(f, "{}/{}", part(&self.numerator), part(self.denominator())),
        }
    }
}

impl fmt::Debug for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;
    use proptest::prelude::*;

    #[test]
    fn debugged_as_displayed() {
        let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
        let quotient = Fraction::from(x.clone()) / Fraction::from(y);
        assert_eq!(format!("{:?}", (x, quotient)), "(x, x/y)");
        let poly = crate::math::poly::Poly::variable() - crate::math::poly::Poly::one();
        assert_eq!(format!("{:?}", Some(poly)), "Some(t - 1)");
    }

    fn any_poly() -> impl Strategy<Value = MultiPoly> {
        let term = (prop::collection::vec(0u32..3, 2), -4i64..5, 1i64..4);
        prop::collection::vec(term, 0..4).prop_map(|terms| {
            MultiPoly::from_terms(
                terms.into_iter().map(|(e, p, q)| {
                    (["s", "t"].map(Symbol::new).into_iter().zip(e).collect(), rational(p, q))
                }),
            )
        })
    }

    fn any_fraction() -> impl Strategy<Value = Fraction> {
        (any_poly(), any_poly()).prop_map(|(n, d)| Fraction::new(n, d).unwrap_or_else(|_| Fraction::one()))
    }

    fn at(f: &Fraction) -> Option<Rational> {
        f.value(&|s: &Symbol| Some(if s.base() == "s" { rational(17, 5) } else { rational(-23, 7) }))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(120))]
        #[test]
        fn field_laws(a in any_fraction(), b in any_fraction(), c in any_fraction()) {
            assert!(a.is_canonical());
            assert_eq!(a.plus(&b), b.plus(&a));
            assert_eq!(a.times(&b), b.times(&a));
            assert_eq!(a.plus(&b).times(&c), a.times(&c).plus(&b.times(&c)));
            assert_eq!(a.plus(&b).minus(&b), a);
            assert!(a.minus(&a).is_zero());
            if !b.is_zero() {
                assert_eq!(a.times(&b) / b.clone(), a);
                assert_eq!(b.pow(-2), Ok(b.times(&b).inverse().unwrap()));
            }
            if let (Some(x), Some(y)) = (at(&a), at(&b)) {
                if let Some(sum) = at(&a.plus(&b)) { assert_eq!(sum, &x + &y); }
                if let Some(product) = at(&a.times(&b)) { assert_eq!(product, x * y); }
            }
        }

        #[test]
        fn product_rule(a in any_fraction(), b in any_fraction()) {
            let t = Symbol::new("t");
            let expected = a.derivative(&t).times(&b).plus(&a.times(&b.derivative(&t)));
            assert_eq!(a.times(&b).derivative(&t), expected);
        }

        #[test]
        fn substitution_agrees_with_evaluation(a in any_fraction(), b in any_fraction()) {
            let (s, t) = (Symbol::new("s"), Symbol::new("t"));
            if let (Ok(c), Some(value)) = (a.substitute(&[(t.clone(), b.clone())]), at(&b)) {
                let by_hand = a.value(&|x: &Symbol| Some(if *x == s { rational(17, 5) } else { value.clone() }));
                if let (Some(x), Some(y)) = (at(&c), by_hand) { assert_eq!(x, y); }
            }
        }
    }

    #[test]
    fn zero_denominators() {
        assert_eq!(Fraction::new(MultiPoly::one(), MultiPoly::zero()), Err(DivisionByZero));
        assert_eq!(Fraction::zero().pow(-1), Err(DivisionByZero));
        let t = Symbol::new("t");
        let pole = Fraction::from(MultiPoly::symbol(t.clone())).inverse().unwrap();
        assert_eq!(pole.substitute(&[(t, Fraction::zero())]), Err(DivisionByZero));
    }
}
