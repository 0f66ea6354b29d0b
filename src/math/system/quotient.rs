//! All real solutions of a system with finitely many complex ones.
//!
//! The monomials that are no multiple of a leading monomial of a Gröbner basis of I are a basis of A = Q[x]/I, of dimension D,
//! the number of complex solutions with their multiplicities. The minimal polynomial p_i of x_i in A vanishes at the i-th
//! coordinates; with its square-free part added for each i the ideal is radical (Seidenberg), and D is the number of
//! solutions. A linear form u takes D different values at them if its minimal polynomial has degree D; then 1, u, …,
//! u^{D−1} is a basis of A, in which x_i = g_i(u).
//!
//! A. Seidenberg, "Constructions in algebra", Trans. AMS 197 (1974); D. Cox, J. Little, D. O'Shea, "Using Algebraic
//! Geometry", chapter 2.

use nalgebra::DMatrix;
use num_traits::{One, Zero};

use super::groebner::{Exponents, Terms, normal_form, over_numbers, reduced_basis, terms_of};
use super::{RealZero, SystemError, selected};
use crate::budget;
use crate::math::linalg::{multiply, reduced_row_echelon, solve};
use crate::math::number::{Rational, integer};
use crate::math::poly::{MonomialOrder, MultiPoly, Poly, RealRoot, Symbol};

/// The largest number D of complex solutions, with multiplicities, for which [`real_zeros`] looks for the real ones.
pub const MOST_SOLUTIONS: usize = 64;

const ORDER: MonomialOrder = MonomialOrder::GrevLex;

/// The algebra Q[x]/I.
struct Quotient {
    /// Multiplication by each unknown, column by column the images of the basis.
    products: Vec<DMatrix<Rational>>,
    dimension: usize,
}

impl Quotient {
    fn new(basis: &[Terms<Rational>], count: usize) -> Result<Self, SystemError> {
        let lead = |k: usize| -> bool {
            let power = |f: &Terms<Rational>| f[0].0.iter().enumerate().all(|(i, e)| i == k || *e == 0);
            basis.iter().any(power)
        };
        if !(0..count).all(lead) {
            return Err(SystemError::Infinite);
        }
        let divided = |e: &[u32]| basis.iter().any(|f| f[0].0.iter().zip(e).all(|(a, b)| a <= b));
        let mut standard: Vec<Exponents> = Vec::new();
        let mut level: Vec<Exponents> = vec![std::iter::repeat_n(0, count).collect()];
        while !level.is_empty() {
            level.retain(|e| !divided(e));
            standard.extend(level.iter().cloned());
            if standard.len() > MOST_SOLUTIONS {
                return Err(SystemError::Many);
            }
            let mut next: Vec<Exponents> = Vec::new();
            for e in &level {
                for k in 0..count {
                    let mut e = e.clone();
                    e[k] += 1;
                    if !next.contains(&e) {
                        next.push(e);
                    }
                }
            }
            level = next;
        }
        let divisors: Vec<&Terms<Rational>> = basis.iter().collect();
        let dimension = standard.len();
        let mut products = Vec::with_capacity(count);
        for k in 0..count {
            let mut matrix = DMatrix::from_element(dimension, dimension, Rational::zero());
            for (j, e) in standard.iter().enumerate() {
                let mut e = e.clone();
                e[k] += 1;
                for (e, c) in normal_form(vec![(e, Rational::one())], &divisors, ORDER) {
                    let i = standard.iter().position(|s| *s == e).expect("normal forms are standard");
                    matrix[(i, j)] = c;
                }
            }
            products.push(matrix);
        }
        Ok(Quotient { products, dimension })
    }

    /// The powers 1, u, u², … of an element, as columns, and its minimal polynomial: the first power that depends on lower ones.
    fn minimal_polynomial(&self, element: &DMatrix<Rational>) -> (Vec<DMatrix<Rational>>, Poly) {
        let mut one = DMatrix::from_element(self.dimension, 1, Rational::zero());
        one[(0, 0)] = Rational::one();
        let mut powers = vec![one];
        for k in 0..self.dimension {
            budget::steps(1 + (self.dimension * self.dimension) as u32);
            powers.push(multiply(element, &powers[k]).expect("the sizes fit"));
        }
        let matrix = DMatrix::from_fn(self.dimension, powers.len(), |i, j| powers[j][(i, 0)].clone());
        let form = reduced_row_echelon(&matrix);
        let degree =
            (0..).find(|k| form.pivots.get(*k) != Some(k)).expect("there are more columns than rows");
        let coefficients =
            (0..degree).map(|i| -form.matrix[(i, degree)].clone()).chain(std::iter::once(Rational::one()));
        powers.truncate(degree);
        (powers, coefficients.collect())
    }
}

/// All real solutions of F_1 = … = F_r = 0, ordered by their coordinates.
///
/// Cost: a Gröbner basis, then D^4 operations on numbers for D complex solutions, and the real roots of a polynomial of
/// degree D.
///
/// # Errors
/// [`SystemError::Infinite`] also if there are finitely many real ones; [`SystemError::Many`], [`SystemError::Pairs`].
///
/// ```
/// use polarform::poly::{MultiPoly, Symbol};
/// use polarform::system::real_zeros;
/// let unknowns = ["x", "y", "z"].map(Symbol::new);
/// let [x, y, z] = unknowns.clone().map(MultiPoly::symbol);
/// let number = |k| MultiPoly::constant(polarform::number::integer(k));
/// let system = [x.clone() + y.clone() + z.clone() - number(6), x.clone() * y.clone() - number(2), z - number(3)];
/// let found = real_zeros(&system, &unknowns).unwrap();
/// let shown: Vec<String> = found.iter().map(|p| format!("{:?}", p.coordinates.iter().map(|c| c.to_string()).collect::<Vec<_>>())).collect();
/// assert_eq!(shown, [r#"["1", "2", "3"]"#, r#"["2", "1", "3"]"#]);
/// ```
pub fn real_zeros(polynomials: &[MultiPoly], unknowns: &[Symbol]) -> Result<Vec<RealZero>, SystemError> {
    let lists: Vec<_> = polynomials.iter().map(|f| terms_of(f, unknowns, ORDER)).collect();
    let lists = over_numbers(&lists).expect("the coefficients are numbers");
    let mut basis = reduced_basis(lists, ORDER)?;
    let count = unknowns.len();
    let (quotient, minimal) = loop {
        let quotient = Quotient::new(&basis, count)?;
        if quotient.dimension == 0 {
            return Ok(Vec::new());
        }
        let minimal: Vec<Poly> = quotient.products.iter().map(|m| quotient.minimal_polynomial(m).1).collect();
        let simple: Vec<Poly> = minimal.iter().map(Poly::square_free_part).collect();
        if simple.iter().zip(&minimal).all(|(a, b)| a.degree() == b.degree()) {
            break (quotient, minimal);
        }
        for (p, x) in simple.iter().zip(unknowns) {
            let terms = p.coefficients().into_iter().map(MultiPoly::constant).collect::<Vec<_>>();
            let polynomial = MultiPoly::from_coefficients_in(x, &terms);
            let list = [terms_of(&polynomial, unknowns, ORDER)];
            basis.extend(over_numbers(&list).expect("the coefficients are numbers"));
        }
        basis = reduced_basis(basis, ORDER)?;
    };
    let dimension = quotient.dimension;
    // u = Σ k^i x_i takes different values for all but finitely many k.
    let forms = (0_i64..).map(|k| {
        let mut factor = Rational::one();
        let mut sum = DMatrix::from_element(dimension, dimension, Rational::zero());
        for product in &quotient.products {
            for (entry, x) in sum.iter_mut().zip(product.iter()) {
                *entry += x * &factor;
            }
            factor *= integer(k);
        }
        sum
    });
    let (powers, m) = forms
        .map(|u| quotient.minimal_polynomial(&u))
        .find(|(_, m)| m.degree() == Some(dimension))
        .ok_or(SystemError::Entangled)?;
    let matrix = DMatrix::from_fn(dimension, dimension, |i, j| powers[j][(i, 0)].clone());
    let coordinates = DMatrix::from_fn(dimension, count, |i, k| quotient.products[k][(i, 0)].clone());
    let found = solve(&matrix, &coordinates).expect("the powers are a basis");
    let numerators: Vec<Poly> =
        (0..count).map(|k| (0..dimension).map(|i| found[(i, k)].clone()).collect()).collect();
    let roots_of = |p: &Poly| -> Vec<RealRoot> {
        p.real_roots(None, None).unwrap_or_default().into_iter().map(|(root, _)| root).collect()
    };
    let candidates: Vec<Vec<RealRoot>> = minimal.iter().map(roots_of).collect();
    let zero = |u: RealRoot| {
        let coordinates = match &u {
            RealRoot::Rational(q) => numerators.iter().map(|n| RealRoot::Rational(n.value(q))).collect(),
            RealRoot::Irrational(number) => numerators
                .iter()
                .zip(&candidates)
                .map(|(n, from)| selected(number, n, &Poly::one(), from.clone()))
                .collect(),
        };
        RealZero { coordinates, parameter: u, numerators: numerators.clone(), denominator: Poly::one() }
    };
    let mut zeros: Vec<RealZero> = roots_of(&m).into_iter().map(zero).collect();
    zeros.sort_by(|a, b| a.coordinates.cmp(&b.coordinates));
    Ok(zeros)
}
