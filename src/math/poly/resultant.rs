//! Resultants and discriminants.
//!
//! For f = a_m t^m + …  and g = b_n t^n + … the resultant is the determinant of Sylvester's matrix of m + n rows:
//! Res(f, g) = a_m^n ∏ g(α) = (−1)^{mn} b_n^m ∏ f(β) over the roots α of f and β of g. It is 0 if and only if f and g
//! have a common factor.
//!
//! In one variable: Euclid's algorithm modulo word-sized primes until their product exceeds twice Hadamard's
//! bound. In several: values in the other variables, interpolated; where that would need too many values,
//! the subresultant remainder sequence.
//!
//! G. E. Collins, "The calculation of multivariate polynomial resultants", J. ACM 18 (1971); W. S. Brown,
//! J. F. Traub, "On Euclid's algorithm and the theory of subresultants", J. ACM 18 (1971).

use num_traits::{One, Zero};

use super::dense_modular::Modulus;
use super::{Coefficients, MultiPoly, Poly, Symbol, dense, dense_modular};
use crate::budget;
use crate::math::number::{Int, Rational, combine};
use crate::math::ring::Ring;

/// From this many values on the remainder sequence is tried in their place.
const MANY_VALUES: u64 = 4096;

impl Poly {
    /// Res(self, other); 0 if one of them is 0, 1 for two constants.
    ///
    /// Cost for degrees m and n and coefficients of b bits: about (m + n) (b + log(m + n))/62 primes, each
    /// O(m n) word operations.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// let t = Poly::variable();
    /// let f = t.pow(2) - Poly::from(2);
    /// assert_eq!(f.resultant(&(&t - Poly::from(3))), integer(7));
    /// assert_eq!(f.resultant(&(t.pow(3) - &t - &t)), integer(0));
    /// ```
    pub fn resultant(&self, other: &Poly) -> Rational {
        let (Some(m), Some(n)) = (self.degree(), other.degree()) else { return Rational::zero() };
        let value = integer_resultant(self.numerators(), other.numerators());
        let den = self.denominator().pow(n as u32) * other.denominator().pow(m as u32);
        Rational::new(value, den)
    }
}

/// Whether n(n − 1)/2 is odd.
fn sign_turns(n: usize) -> bool {
    n % 4 >= 2
}

impl MultiPoly {
    /// The resultant in one variable, a polynomial in the others; 0 if one of the two is 0.
    ///
    /// Cost for degrees m and n in the variable: ∏ (m deg_y g + n deg_y f + 1) resultants of numbers over the other
    /// variables y; if these are more than some thousand, n steps of the subresultant sequence, each (m + n) products
    /// of polynomials.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let [t, x, y] = ["t", "x", "y"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    /// // The points (t^2, t^3) satisfy x^3 = y^2.
    /// let f = x - t.pow(2);
    /// let g = y - t.pow(3);
    /// assert_eq!(f.resultant(&g, &Symbol::new("t")).to_string(), "x^3 - y^2");
    /// ```
    pub fn resultant(&self, other: &Self, variable: &Symbol) -> Self {
        if self.is_zero() || other.is_zero() {
            return MultiPoly::zero();
        }
        let (f, g) = (self.coefficients_in(variable), other.coefficients_in(variable));
        let bounds = degree_bounds(&f, &g);
        let values = bounds.iter().fold(1_u64, |count, (_, d)| count.saturating_mul(u64::from(*d) + 1));
        if values > MANY_VALUES { by_subresultants(f, g) } else { by_values(&f, &g, &bounds) }
    }

    /// (−1)^{n(n−1)/2} Res(F, F')/a_n = a_n^{2n−2} ∏_{i<j} (α_i − α_j)² in one variable, of degree n in it;
    /// `None` if n = 0.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let [t, a, b] = ["t", "a", "b"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    /// let f = t.pow(3) + a * t.clone() + b;
    /// assert_eq!(f.discriminant(&Symbol::new("t")).unwrap().to_string(), "-4 a^3 - 27 b^2");
    /// ```
    pub fn discriminant(&self, variable: &Symbol) -> Option<Self> {
        let n = self.degree_in(variable) as usize;
        let lead = self.coefficients_in(variable).pop().filter(|_| n > 0)?;
        let value = self.resultant(&self.derivative(variable), variable).div_exact(&lead)?;
        Some(if sign_turns(n) { -value } else { value })
    }
}

/// The resultant of integer polynomials that are not 0.
fn integer_resultant(f: &[Int], g: &[Int]) -> Int {
    let (m, n) = (f.len() - 1, g.len() - 1);
    if m == 0 || n == 0 {
        return f[0].pow(n as u32) * g[0].pow(m as u32);
    }
    // Hadamard: |Res| ≤ |f|^n |g|^m with Euclidean lengths, |f|² ≤ (m + 1) 2^{2 bits}.
    let length = |a: &[Int]| 2 * dense::height_bits(a) + u64::from(usize::BITS - a.len().leading_zeros());
    let bits = (length(f) * n as u64 + length(g) * m as u64) / 2 + 2;
    budget::charge_bits(bits);
    let mut found = [Int::ZERO];
    let mut modulus = Int::ONE;
    for field in dense_modular::primes() {
        budget::step();
        let image = |a: &[Int]| -> Vec<u64> { a.iter().map(|x| field.enter(x.mod_word(field.p))).collect() };
        let (a, b) = (image(f), image(g));
        if a[m] == 0 || b[n] == 0 {
            continue;
        }
        combine(&mut found, &modulus, &[field.leave(image_resultant(&field, a, b))], &field);
        modulus *= Int::from(field.p);
        if modulus.bits() > bits {
            break;
        }
    }
    let [found] = found;
    found
}

/// The resultant modulo a prime, in Montgomery form; the leading entries are not 0.
fn image_resultant(field: &Modulus, mut a: Vec<u64>, mut b: Vec<u64>) -> u64 {
    let mut result = field.enter(1);
    let times = |x: u64, y: u64| field.canonical(field.mul(x, y));
    // Res(a, b) = (−1)^{mn} lead(b)^{m − deg r} Res(b, r) for the remainder r.
    while b.len() > 1 {
        let (m, n) = (a.len() - 1, b.len() - 1);
        let lead = b[n];
        let inverse = field.invert(lead);
        while a.len() > n {
            budget::step();
            let top = times(a[a.len() - 1], inverse);
            let offset = a.len() - b.len();
            for (x, &y) in a[offset..].iter_mut().zip(&b) {
                *x = field.sub(*x, times(y, top));
            }
            while a.last() == Some(&0) {
                a.pop();
            }
        }
        if a.is_empty() {
            return 0;
        }
        result = times(result, field.pow(lead, (m + 1 - a.len()) as u64));
        if m * n % 2 == 1 {
            result = field.sub(0, result);
        }
        std::mem::swap(&mut a, &mut b);
    }
    times(result, field.pow(b[0], (a.len() - 1) as u64))
}

/// The variables of the coefficients, each with a bound of the degree of the resultant in it.
fn degree_bounds(f: &[MultiPoly], g: &[MultiPoly]) -> Vec<(Symbol, u32)> {
    let mut variables: Vec<Symbol> = f.iter().chain(g).flat_map(|c| c.variables().to_vec()).collect();
    variables.sort();
    variables.dedup();
    let highest = |list: &[MultiPoly], y: &Symbol| list.iter().map(|c| c.degree_in(y)).max().unwrap_or(0);
    let (m, n) = (f.len() as u32 - 1, g.len() as u32 - 1);
    let bound = |y: &Symbol| highest(g, y).saturating_mul(m).saturating_add(highest(f, y).saturating_mul(n));
    variables.into_iter().map(|y| (y.clone(), bound(&y))).collect()
}

/// The determinant of Sylvester's matrix for these formal degrees: leading entries may be 0. One variable after
/// the other gets values, from which the result is interpolated.
fn by_values(f: &[MultiPoly], g: &[MultiPoly], bounds: &[(Symbol, u32)]) -> MultiPoly {
    budget::step();
    let Some(((y, bound), rest)) = bounds.split_last() else {
        let numbers = |list: &[MultiPoly]| -> Poly {
            list.iter().map(|c| c.as_constant().unwrap_or_else(Rational::zero)).collect()
        };
        return MultiPoly::constant(formal_resultant(numbers(f), f.len() - 1, numbers(g), g.len() - 1));
    };
    let nodes: Vec<Rational> = (0..=i64::from(*bound)).map(node).collect();
    let value = |x: &Rational| {
        let at = |list: &[MultiPoly]| -> Vec<MultiPoly> {
            list.iter().map(|c| c.value(&|s| (s == y).then(|| x.clone()))).collect()
        };
        by_values(&at(f), &at(g), rest)
    };
    let mut differences: Vec<MultiPoly> = nodes.iter().map(value).collect();
    for k in 1..nodes.len() {
        for i in (k..nodes.len()).rev() {
            let step = (&nodes[i] - &nodes[i - k]).recip();
            differences[i] = differences[i].minus(&differences[i - 1]).scaled(&step);
        }
    }
    // Newton's form, from the inside: p ← (y − x_k) p + d_k.
    let mut list = Coefficients::zero();
    for (x, difference) in nodes.iter().zip(&differences).rev() {
        list.multiply_by_root(&MultiPoly::constant(x.clone()));
        list = list.plus(&Coefficients::constant(difference.clone()));
    }
    MultiPoly::from_coefficients_in(y, &list)
}

/// 0, 1, −1, 2, −2, …
fn node(k: i64) -> Rational {
    Rational::from_integer(Int::from(if k % 2 == 1 { (k + 1) / 2 } else { -k / 2 }))
}

/// The determinant of Sylvester's matrix for formal degrees m and n.
fn formal_resultant(f: Poly, m: usize, g: Poly, n: usize) -> Rational {
    match (m, n) {
        (0, _) => return f.coefficient(0).powered(n as u32),
        (_, 0) => return g.coefficient(0).powered(m as u32),
        _ => {}
    }
    let (Some(p), Some(q)) = (f.degree(), g.degree()) else { return Rational::zero() };
    let value = f.resultant(&g);
    match (m - p, n - q) {
        (0, 0) => value,
        // Expansion by the first column, of which only the row of the other polynomial is left.
        (lost, 0) => {
            let power = g.leading_coefficient().powered(lost as u32);
            if lost * n % 2 == 1 { -(value * power) } else { value * power }
        }
        (0, lost) => value * f.leading_coefficient().powered(lost as u32),
        _ => Rational::zero(),
    }
}

/// The resultant by the subresultant remainder sequence, coefficients in a ring with exact division.
fn by_subresultants(mut a: Vec<MultiPoly>, mut b: Vec<MultiPoly>) -> MultiPoly {
    let mut negative = false;
    if a.len() < b.len() {
        negative = (a.len() - 1) * (b.len() - 1) % 2 == 1;
        std::mem::swap(&mut a, &mut b);
    }
    let quotient = |a: &MultiPoly, b: &MultiPoly| a.div_exact(b).unwrap_or_else(MultiPoly::zero);
    let (mut lead, mut h) = (MultiPoly::one(), MultiPoly::one());
    while b.len() > 1 {
        let (m, n) = (a.len() - 1, b.len() - 1);
        let delta = (m - n) as u32;
        negative ^= m % 2 == 1 && n % 2 == 1;
        let divisor = lead.times(&h.powered(delta));
        let rest = pseudo_remainder(a, &b).iter().map(|c| quotient(c, &divisor)).collect();
        a = std::mem::replace(&mut b, rest);
        if b.is_empty() {
            return MultiPoly::zero();
        }
        lead = a[n].clone();
        h = match delta {
            0 => h,
            _ => quotient(&lead.powered(delta), &h.powered(delta - 1)),
        };
    }
    let m = (a.len() - 1) as u32;
    let result = match m {
        0 => MultiPoly::one(),
        _ => quotient(&b[0].powered(m), &h.powered(m - 1)),
    };
    if negative { -result } else { result }
}

/// lead(b)^{m−n+1} a mod b, without trailing zeros.
fn pseudo_remainder(mut a: Vec<MultiPoly>, b: &[MultiPoly]) -> Vec<MultiPoly> {
    let Some((lead, lower)) = b.split_last() else { return a };
    let mut left = a.len() - b.len() + 1;
    while a.len() >= b.len() {
        budget::step();
        let Some(top) = a.pop() else { break };
        let offset = a.len() - lower.len();
        for x in &mut a {
            *x = x.times(lead);
        }
        for (x, y) in a[offset..].iter_mut().zip(lower) {
            *x -= y.times(&top);
        }
        left -= 1;
        while a.last().is_some_and(Zero::is_zero) {
            a.pop();
        }
    }
    let scale = lead.powered(left as u32);
    a.iter().map(|x| x.times(&scale)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use proptest::prelude::*;

    /// The determinant of Sylvester's matrix, n rows of f and m rows of g with the highest powers first, by Gauss.
    fn sylvester(f: &[Rational], g: &[Rational]) -> Rational {
        let (m, n) = (f.len() - 1, g.len() - 1);
        let row = |list: &[Rational], shift: usize| {
            let mut row = vec![integer(0); m + n];
            row[shift..shift + list.len()].clone_from_slice(list);
            row[shift..shift + list.len()].reverse();
            row
        };
        let mut rows: Vec<Vec<Rational>> =
            (0..n).map(|i| row(f, i)).chain((0..m).map(|i| row(g, i))).collect();
        let mut determinant = integer(1);
        for k in 0..m + n {
            let Some(pivot) = (k..m + n).find(|&i| !rows[i][k].is_zero()) else { return integer(0) };
            if pivot != k {
                rows.swap(pivot, k);
                determinant = -determinant;
            }
            determinant *= rows[k][k].clone();
            let upper = rows[k].clone();
            for lower in &mut rows[k + 1..] {
                let factor = &lower[k] / &upper[k];
                lower.iter_mut().zip(&upper).for_each(|(x, y)| *x -= &factor * y);
            }
        }
        determinant
    }

    fn coefficients() -> impl Strategy<Value = Vec<Rational>> {
        let entry = prop_oneof![
            3 => (-4i64..5, 1i64..4).prop_map(|(p, q)| rational(p, q)),
            1 => Just(integer(0)),
            1 => any::<i64>().prop_map(integer),
        ];
        prop::collection::vec(entry, 1..7)
    }

    /// Polynomials in x, t and y of small degrees.
    fn in_several() -> impl Strategy<Value = MultiPoly> {
        let term = (-3i64..4, 0u32..4, 0u32..3, 0u32..2);
        prop::collection::vec(term, 0..6).prop_map(|terms| {
            let name = |name: &str, k: u32| (Symbol::new(name), k);
            let term = |(c, i, j, k)| (vec![name("t", i), name("x", j), name("y", k)], integer(c));
            MultiPoly::from_terms(terms.into_iter().map(term))
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn numbers_agree_with_the_determinant(f in coefficients(), g in coefficients()) {
            let (p, q): (Poly, Poly) = (f.iter().cloned().collect(), g.iter().cloned().collect());
            if let (Some(_), Some(_)) = (p.degree(), q.degree()) {
                let (f, g) = (p.coefficients(), q.coefficients());
                prop_assert_eq!(p.resultant(&q), sylvester(&f, &g));
            } else {
                prop_assert_eq!(p.resultant(&q), integer(0));
            }
            // Formal degrees: leading entries that are 0 stay in the matrix.
            prop_assert_eq!(formal_resultant(p, f.len() - 1, q, g.len() - 1), sylvester(&f, &g));
        }

        #[test]
        fn both_ways_agree_in_several_variables(f in in_several(), g in in_several(), h in in_several()) {
            let t = Symbol::new("t");
            prop_assume!(!f.is_zero() && !g.is_zero() && !h.is_zero());
            let lists = (f.coefficients_in(&t), g.coefficients_in(&t));
            let by_values = by_values(&lists.0, &lists.1, &degree_bounds(&lists.0, &lists.1));
            prop_assert_eq!(&by_values, &by_subresultants(lists.0, lists.1));
            // Res(f, g h) = Res(f, g) Res(f, h), Res(g, f) = ± Res(f, g)
            let product = f.resultant(&g.times(&h), &t);
            prop_assert_eq!(product, by_values.times(&f.resultant(&h, &t)));
            let odd = f.degree_in(&t) * g.degree_in(&t) % 2 == 1;
            prop_assert_eq!(g.resultant(&f, &t), if odd { -by_values } else { by_values });
        }

        #[test]
        fn discriminants_are_products_of_differences(
            roots in prop::collection::vec((-6i64..7, 1i64..4), 1..6), lead in 1i64..5,
        ) {
            let roots: Vec<Rational> = roots.into_iter().map(|(p, q)| rational(p, q)).collect();
            let n = roots.len();
            let f: Poly = Coefficients::from_roots(&roots).iter().cloned().collect();
            let mut expected = integer(lead).powered(2 * n as u32 - 2);
            for (i, a) in roots.iter().enumerate() {
                for b in &roots[i + 1..] {
                    expected *= (a - b).powered(2);
                }
            }
            let t = Symbol::new("t");
            let list: Vec<MultiPoly> =
                f.scale(&integer(lead)).coefficients().into_iter().map(MultiPoly::constant).collect();
            let f = MultiPoly::from_coefficients_in(&t, &list);
            prop_assert_eq!(f.discriminant(&t), Some(MultiPoly::constant(expected)));
        }
    }

    #[test]
    fn discriminants_of_general_polynomials() {
        let symbol = |name: &str| MultiPoly::symbol(Symbol::new(name));
        let t = Symbol::new("t");
        let general = |n: usize| {
            let list: Vec<MultiPoly> = (0..=n).map(|k| symbol(&format!("c_{k}"))).collect();
            MultiPoly::from_coefficients_in(&t, &list)
        };
        assert_eq!(general(2).discriminant(&t).unwrap().to_string(), "-4 c_0 c_2 + c_1^2");
        // As many terms as the literature has for them.
        for (n, terms) in [(1, 1), (2, 2), (3, 5), (4, 16), (5, 59)] {
            assert_eq!(general(n).discriminant(&t).unwrap().len(), terms, "degree {n}");
        }
        assert_eq!(symbol("x").discriminant(&t), None);
        assert_eq!(MultiPoly::zero().discriminant(&t), None);
        assert_eq!(symbol("t").discriminant(&t).unwrap().to_string(), "1");
    }

    #[test]
    fn huge_coefficients() {
        let t = Poly::variable();
        let big = Int::from(10).pow(300);
        let f = t.pow(2) - Poly::from(&big * &big);
        assert_eq!(f.resultant(&(&t - Poly::from(big.clone()))), integer(0));
        let expected = Rational::from_integer(&big * &big * Int::from(-1) + Int::from(25));
        assert_eq!(f.resultant(&(&t - Poly::from(5))), expected);
    }
}
