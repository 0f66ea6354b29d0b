//! Division, greatest common divisors and square-free factors of [`Poly`].

use num_integer::Integer;

use super::dense_modular;
use super::{Poly, dense, dense_divide};
use crate::budget;
use crate::math::number::{Int, Rational, combine};

impl Poly {
    /// Quotient and remainder: self = quotient · divisor + remainder with the remainder
    /// of lower degree than the divisor; `None` if the divisor is 0.
    ///
    /// Cost: O((deg self − deg divisor + 1) · deg divisor) integer products.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// let t = Poly::variable();
    /// let two = Poly::from(2);
    /// let (q, r) = t.pow(2).div_rem(&(two * &t + Poly::one())).unwrap();
    /// assert_eq!((q.to_string().as_str(), r.to_string().as_str()), ("1/2 t - 1/4", "1/4"));
    /// assert!(t.div_rem(&Poly::zero()).is_none());
    /// ```
    pub fn div_rem(&self, divisor: &Poly) -> Option<(Poly, Poly)> {
        if divisor.is_zero() {
            return None;
        }
        // self = A/d and divisor = B/e with s A = Q B + R: self = (Q e / s d) B/e + R / s d.
        let division = dense_divide::pseudo_division(self.numerators(), divisor.numerators());
        let den = division.scale * self.denominator();
        let quotient = dense::scaled(&division.quotient, divisor.denominator());
        Some((Poly::from_integers(quotient, den.clone()), Poly::from_integers(division.remainder, den)))
    }

    /// self / divisor if that is a polynomial; `None` otherwise or if the divisor is 0.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = t.pow(2) - Poly::one();
    /// assert_eq!(f.div_exact(&(&t - Poly::one())).unwrap().to_string(), "t + 1");
    /// assert!(f.div_exact(&t).is_none());
    /// ```
    pub fn div_exact(&self, divisor: &Poly) -> Option<Poly> {
        if divisor.is_zero() {
            return None;
        }
        if self.is_zero() {
            return Some(Poly::zero());
        }
        // A quotient of primitive polynomials has integer coefficients (Gauss).
        let (a, b) = (dense::content(self.numerators()), dense::content(divisor.numerators()));
        let quotient = dense_divide::exact_quotient(
            &dense::divided(self.numerators().to_vec(), &a),
            &dense::divided(divisor.numerators().to_vec(), &b),
        )?;
        let scale = Rational::new(a * divisor.denominator(), b * self.denominator());
        Some(Poly::integral_trimmed(quotient).scale(&scale))
    }

    /// The monic greatest common divisor; gcd(0, 0) = 0.
    ///
    /// Modular: Euclid's algorithm modulo word-sized primes, the Chinese remainder
    /// theorem, and two divisions that prove the result. Cost: O(deg²) word
    /// operations for each prime, about one prime for 60 bits of the result.
    /// Reference: von zur Gathen and Gerhard, "Modern Computer Algebra", algorithm 6.38.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = t.pow(2) - Poly::one();
    /// let g = t.pow(3) + Poly::one();
    /// assert_eq!(f.gcd(&g).to_string(), "t + 1");
    /// ```
    pub fn gcd(&self, other: &Poly) -> Poly {
        match (self.degree(), other.degree()) {
            (None, _) => other.leading_monic(),
            (_, None) => self.leading_monic(),
            (Some(0), _) | (_, Some(0)) => Poly::one(),
            _ => {
                let a = dense::primitive(self.numerators().to_vec());
                let b = dense::primitive(other.numerators().to_vec());
                Poly::integral_trimmed(primitive_gcd(&a, &b)).leading_monic()
            }
        }
    }

    /// The monic polynomial with the same roots, each simple; 0 for 0.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = t.pow(3) * (&t - Poly::one()).pow(2);
    /// assert_eq!(f.square_free_part().to_string(), "t^2 - t");
    /// ```
    pub fn square_free_part(&self) -> Poly {
        let repeated = self.gcd(&self.derivative());
        self.div_exact(&repeated).map_or_else(Poly::zero, |part| part.leading_monic())
    }

    /// The square-free factorisation: monic, coprime, square-free, nonconstant P_m with
    /// self = lead · ∏ P_m^m, in increasing order of the multiplicity m; empty for constants.
    ///
    /// D. Y. Y. Yun, "On square-free decomposition algorithms", SYMSAC 1976.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = t.pow(3) * (&t - Poly::one());
    /// let factors: Vec<String> = f.square_free_factors().iter().map(|(p, m)| format!("({p})^{m}")).collect();
    /// assert_eq!(factors, ["(t - 1)^1", "(t)^3"]);
    /// ```
    pub fn square_free_factors(&self) -> Vec<(Poly, usize)> {
        let mut factors = Vec::new();
        let exact = |a: &Poly, b: &Poly| a.div_exact(b).unwrap_or_default();
        let derivative = self.derivative();
        let repeated = self.gcd(&derivative);
        if repeated.is_zero() {
            return factors;
        }
        // v is the product of the P_j with j ≥ m, and w/v the sum of (j − m + 1) P_j'/P_j.
        let mut v = exact(self, &repeated);
        let mut w = exact(&derivative, &repeated);
        let mut multiplicity = 1;
        while v.degree() > Some(0) {
            w -= v.derivative();
            let factor = v.gcd(&w);
            v = exact(&v, &factor);
            w = exact(&w, &factor);
            if factor.degree() > Some(0) {
                factors.push((factor, multiplicity));
            }
            multiplicity += 1;
        }
        factors
    }
}

/// The greatest common divisor of two primitive nonconstant integer polynomials, primitive.
pub(super) fn primitive_gcd(a: &[Int], b: &[Int]) -> Vec<Int> {
    // lead(gcd) divides this, so its multiple with this leading coefficient is integral.
    let lead = a[a.len() - 1].gcd(&b[b.len() - 1]);
    let mut found: Vec<Int> = Vec::new();
    let mut modulus = Int::ONE;
    for field in dense_modular::primes() {
        budget::step();
        let lead_image = lead.mod_word(field.p);
        if lead_image == 0 {
            continue; // the degree of an image could drop
        }
        let image =
            |v: &[Int]| -> Vec<u64> { trimmed(v.iter().map(|x| field.enter(x.mod_word(field.p))).collect()) };
        let mut common = dense_modular::gcd(&field, image(a), image(b));
        if common.len() == 1 {
            return vec![Int::ONE];
        }
        let scale = field.enter(lead_image);
        for x in &mut common {
            *x = field.leave(field.canonical(field.mul(*x, scale)));
        }
        if !found.is_empty() && common.len() > found.len() {
            continue; // an unlucky prime: the image has a factor too many
        }
        if found.is_empty() || common.len() < found.len() {
            // The first prime, or all primes before were unlucky.
            found = vec![Int::ZERO; common.len()];
            modulus = Int::ONE;
        }
        let stable = combine(&mut found, &modulus, &common, &field);
        modulus *= Int::from(field.p);
        if stable || modulus.bits() < 128 {
            let candidate = dense::primitive(found.clone());
            // The candidate is a multiple of the image by a unit for each prime in the modulus.
            let divides = |x: &[Int]| dense_divide::divides_given_modulo(x, &candidate, &modulus);
            if divides(a) && divides(b) {
                return candidate;
            }
        }
    }
    unreachable!("there are more primes below 2^62 than a representable gcd can need")
}

fn trimmed(mut v: Vec<u64>) -> Vec<u64> {
    while v.last() == Some(&0) {
        v.pop();
    }
    v
}
