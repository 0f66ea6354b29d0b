//! The greatest common divisor of primitive parts in several variables, by images modulo primes.
//!
//! Let G = γ g / lc(g), with g the gcd, lc the leading coefficient in the *main variable* x, and
//! γ = gcd(lc(a), lc(b)), so that G has integer coefficients and the known leading coefficient γ.
//! With numbers modulo a prime for all other variables, G is the gcd of two polynomials in x,
//! scaled. From its images at a geometric sequence of points each coefficient of G in x is found as
//! a sparse polynomial, with as many points as it has terms, twice and a few. Further primes, if
//! numbers are long, only need the coefficients. Two exact divisions prove the result.
//!
//! Cost: for T terms in the largest coefficient of G in x and degree d in x, about 2 T evaluations
//! of a and b, 2 T gcds in O(d²), and O(T²) for each coefficient, all on words. The exponents of the
//! other variables do not matter, as long as the product of the degrees of G stays below 2^44.
//!
//! J. Hu, M. Monagan, "A fast parallel sparse polynomial GCD algorithm", ISSAC 2016; R. Zippel,
//! "Probabilistic algorithms for sparse polynomials", EUROSAM 1979.

use super::dense_modular::{self, Modulus};
use super::dense_ntt::{FIELDS, GENERATORS, ROOT_ORDER_LOG};
use super::gcd_roots::{Recurrence, logarithms, weights};
use super::multivariate::{Exponents, Terms};
use crate::budget;
use crate::math::number::{Int, combine};

type Term = (Exponents, Int);

pub(super) fn field_with_roots(which: usize) -> Modulus {
    FIELDS[which % FIELDS.len()]
}

/// ω of order 2^k, in Montgomery form.
pub(super) fn root_of_order(which: usize, k: u32) -> u64 {
    let which = which % FIELDS.len();
    FIELDS[which].pow(FIELDS[which].enter(GENERATORS[which]), (FIELDS[which].p - 1) >> k)
}

/// Values that look random and are the same in each run (splitmix64).
fn scattered(seed: u64, field: &Modulus) -> u64 {
    let mut x = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (x ^ (x >> 31)) % (field.p - 2) + 2
}

/// The values of monomials at one point, with tables of powers.
struct Point<'a> {
    field: &'a Modulus,
    values: Vec<u64>,
    powers: Vec<Vec<u64>>,
}

/// Higher powers than this are not kept in a table.
const TABLE: u32 = 256;

impl<'a> Point<'a> {
    /// For exponents up to the given degrees; values in Montgomery form.
    fn new(field: &'a Modulus, values: Vec<u64>, degrees: &[u32]) -> Self {
        let powers = values.iter().zip(degrees).map(|(value, degree)| {
            let next = |x: &u64| Some(field.canonical(field.mul(*x, *value)));
            std::iter::successors(Some(field.enter(1)), next)
                .take((*degree).min(TABLE) as usize + 1)
                .collect()
        });
        Point { field, powers: powers.collect(), values }
    }

    fn power(&self, k: usize, e: u32) -> u64 {
        self.powers[k]
            .get(e as usize)
            .copied()
            .unwrap_or_else(|| self.field.pow(self.values[k], u64::from(e)))
    }

    /// The value of the monomial without the variable `but`.
    fn monomial(&self, e: &[u32], but: usize) -> u64 {
        let mut value = self.field.enter(1);
        for (k, &x) in e.iter().enumerate() {
            if k != but && x > 0 {
                value = self.field.canonical(self.field.mul(value, self.power(k, x)));
            }
        }
        value
    }
}

fn degrees(lists: &[&[Term]], variables: usize) -> Vec<u32> {
    let terms = || lists.iter().flat_map(|terms| terms.iter());
    (0..variables).map(|k| terms().map(|(e, _)| e[k]).max().unwrap_or(0)).collect()
}

fn image_of(c: &Int, field: &Modulus) -> u64 {
    field.enter(c.mod_word(field.p))
}

/// Upper bounds for the degrees of gcd(a, b), over the same variables: those of the gcds of images
/// with numbers for all variables but one.
///
/// If the leading coefficient of one of the two in x does not vanish in the image, the image of the
/// gcd has the same degree as the gcd and divides the gcd of the images.
pub(super) fn degree_bounds(a: &[Term], b: &[Term], variables: usize) -> Vec<u32> {
    let field = field_with_roots(0);
    let (in_a, in_b) = (degrees(&[a], variables), degrees(&[b], variables));
    let top: Vec<u32> = in_a.iter().zip(&in_b).map(|(x, y)| *x.max(y)).collect();
    let mut bounds: Vec<Option<u32>> =
        in_a.iter().zip(&in_b).map(|(x, y)| (*x.min(y) == 0).then_some(0)).collect();
    for attempt in 0..3 {
        if bounds.iter().all(Option::is_some) {
            break;
        }
        let values = (0..variables as u64).map(|k| scattered(attempt << 32 | k, &field)).collect();
        let point = Point::new(&field, values, &top);
        for k in (0..variables).filter(|k| bounds[*k].is_none()).collect::<Vec<usize>>() {
            let image = |terms: &[Term], degree: u32| {
                budget::charge_terms(u64::from(degree) + 1);
                budget::steps((terms.len() / 32) as u32 + 1);
                let mut row = vec![0; degree as usize + 1];
                for (e, c) in terms {
                    let value = field.canonical(field.mul(image_of(c, &field), point.monomial(e, k)));
                    let cell = &mut row[e[k] as usize];
                    *cell = field.canonical(*cell + value);
                }
                while row.last() == Some(&0) {
                    row.pop();
                }
                row
            };
            let (x, y) = (image(a, in_a[k]), image(b, in_b[k]));
            if x.len() > in_a[k] as usize || y.len() > in_b[k] as usize {
                let degree = dense_modular::gcd(&field, x, y).len().saturating_sub(1) as u32;
                bounds[k] = Some(degree.min(in_a[k]).min(in_b[k]));
            }
        }
    }
    bounds.iter().zip(in_a.iter().zip(&in_b)).map(|(bound, (x, y))| bound.unwrap_or(*x.min(y))).collect()
}

/// The values of a polynomial at a geometric sequence of points, as polynomials in the main variable.
struct Sequence {
    /// For each term its exponent of the main variable, its value at the next point, and what the
    /// value is multiplied by from one point to the next.
    terms: Vec<(u32, u64, u64)>,
    length: usize,
}

impl Sequence {
    fn new(terms: &[Term], main: usize, start: &Point, ratio: &Point) -> Self {
        let field = start.field;
        let term = |(e, c): &Term| {
            let first = field.canonical(field.mul(image_of(c, field), start.monomial(e, main)));
            (e[main], first, ratio.monomial(e, main))
        };
        let length = terms.iter().map(|(e, _)| e[main] as usize + 1).max().unwrap_or(0);
        Sequence { terms: terms.iter().map(term).collect(), length }
    }

    fn next(&mut self, field: &Modulus) -> Vec<u64> {
        budget::steps((self.terms.len() / 128) as u32 + 1);
        let mut row = vec![0; self.length];
        for (e, value, ratio) in &mut self.terms {
            let cell = &mut row[*e as usize];
            *cell = field.canonical(*cell + *value);
            *value = field.canonical(field.mul(*value, *ratio));
        }
        row
    }
}

/// The images of G at a geometric sequence of points.
struct Images<'a> {
    field: &'a Modulus,
    a: Sequence,
    b: Sequence,
    lead: Sequence,
}

/// What the gcd of two images can tell.
enum Image {
    /// The coefficients of G below the leading one.
    Of(Vec<u64>),
    /// A leading coefficient vanishes, or the gcd has a factor too many.
    Unlucky,
    /// G has a lower degree than was thought.
    Lower(usize),
}

impl Images<'_> {
    fn next(&mut self, degree: usize) -> Image {
        let field = self.field;
        let (a, b) = (self.a.next(field), self.b.next(field));
        let lead = self.lead.next(field)[0];
        if a.last() == Some(&0) || b.last() == Some(&0) || lead == 0 {
            return Image::Unlucky;
        }
        let mut image = dense_modular::gcd(field, a, b);
        match image.len() - 1 {
            d if d > degree => Image::Unlucky,
            d if d < degree => Image::Lower(d),
            _ => {
                image.pop();
                image.iter_mut().for_each(|c| *c = field.canonical(field.mul(*c, lead)));
                Image::Of(image)
            }
        }
    }
}

/// Two polynomials over the same variables, without common factor in their coefficients.
pub(super) struct Problem<'a> {
    pub a: &'a [Term],
    pub b: &'a [Term],
    pub variables: usize,
    /// The main variable.
    pub main: usize,
    /// γ over the same variables.
    pub lead: &'a [Term],
    /// Upper bounds for the degrees of the gcd.
    pub bounds: &'a [u32],
}

/// Attempts with a prime before another is taken.
const ATTEMPTS: u64 = 6;
/// Numbers of at most this size after the first prime are likely no accident.
const LIKELY_BITS: u64 = 50;

/// What a prime tells.
enum Found<T> {
    Some(T),
    /// The degree in the main variable is lower.
    Lower(usize),
    Nothing,
}

impl Problem<'_> {
    /// The terms of G that pass `accept`, which is asked whenever there is reason to believe that
    /// all of G is known. `None` if nothing is found: exponents are too large, or all primes unlucky.
    pub fn solve<T>(&self, accept: impl Fn(Terms) -> Option<T>) -> Option<T> {
        let mut degree = self.bounds[self.main] as usize;
        let radices = self.radices();
        let bits = radices.iter().try_fold(1u64, |product, r| product.checked_mul(*r))?;
        let bits = 64 - (bits - 1).leading_zeros();
        if bits > ROOT_ORDER_LOG {
            return None;
        }
        let mut which = 0;
        while which < FIELDS.len() {
            match self.skeleton(which, &radices, bits, degree) {
                Found::Lower(d) => degree = d,
                Found::Nothing => which += 1,
                Found::Some(terms) => match self.lifted(which, terms, degree, &accept) {
                    Found::Some(result) => return Some(result),
                    Found::Lower(d) => degree = d,
                    Found::Nothing => which += 1,
                },
            }
        }
        None
    }

    /// One more than the degree of G for each variable; 1 for the main variable.
    fn radices(&self) -> Vec<u64> {
        let lead = degrees(&[self.lead], self.variables);
        let radix =
            |k: usize| if k == self.main { 1 } else { u64::from(self.bounds[k]) + u64::from(lead[k]) + 1 };
        (0..self.variables).map(radix).collect()
    }

    fn points<'f>(&self, field: &'f Modulus, start: Vec<u64>, ratio: Vec<u64>) -> (Point<'f>, Point<'f>) {
        let degrees = degrees(&[self.a, self.b, self.lead], self.variables);
        (Point::new(field, start, &degrees), Point::new(field, ratio, &degrees))
    }

    fn images<'f>(&self, start: &Point<'f>, ratio: &Point<'f>) -> Images<'f> {
        let sequence = |terms: &[Term]| Sequence::new(terms, self.main, start, ratio);
        Images { field: start.field, a: sequence(self.a), b: sequence(self.b), lead: sequence(self.lead) }
    }

    fn random_values(&self, field: &Modulus, seed: u64) -> Vec<u64> {
        (0..self.variables as u64).map(|k| scattered(seed << 20 | k, field)).collect()
    }

    /// The terms of G below the leading coefficient modulo the first prime, with residues.
    fn skeleton(
        &self,
        which: usize,
        radices: &[u64],
        bits: u32,
        degree: usize,
    ) -> Found<Vec<(Exponents, u64)>> {
        let field = field_with_roots(which);
        let omega = root_of_order(which, bits);
        let mut place = 1u64;
        let strides: Vec<u64> = radices
            .iter()
            .map(|r| {
                place *= r;
                place / r
            })
            .collect();
        let ratio: Vec<u64> = strides.iter().map(|stride| field.pow(omega, *stride)).collect();
        'attempt: for attempt in 0..ATTEMPTS {
            let start = self.random_values(&field, attempt << 8 | which as u64);
            let (start, ratio) = self.points(&field, start, ratio.clone());
            let mut images = self.images(&start, &ratio);
            let mut coefficients: Vec<Recurrence> = (0..degree).map(|_| Recurrence::new(&field)).collect();
            while coefficients.iter().any(|c| !c.is_settled()) {
                match images.next(degree) {
                    Image::Of(image) => {
                        coefficients.iter_mut().zip(image).for_each(|(c, value)| c.push(&field, value));
                    }
                    Image::Unlucky => continue 'attempt,
                    Image::Lower(d) => return Found::Lower(d),
                }
            }
            let mut terms = Vec::new();
            for (power, coefficient) in coefficients.iter().enumerate() {
                let Some(logs) = logarithms(&field, coefficient.characteristic(), omega, bits) else {
                    continue 'attempt;
                };
                let roots: Vec<u64> = logs.iter().map(|log| field.pow(omega, *log)).collect();
                let Some(residues) = weights(&field, &roots, coefficient.values()) else { continue 'attempt };
                for (log, residue) in logs.into_iter().zip(residues) {
                    let mut e: Exponents =
                        strides.iter().zip(radices).map(|(s, r)| (log / s % r) as u32).collect();
                    let monomial = start.monomial(&e, self.main);
                    e[self.main] = power as u32;
                    terms.push((e, field.canonical(field.mul(residue, field.invert(monomial)))));
                }
            }
            return Found::Some(terms);
        }
        Found::Nothing
    }

    /// From the terms modulo the first prime to integers.
    fn lifted<T>(
        &self,
        which: usize,
        terms: Vec<(Exponents, u64)>,
        degree: usize,
        accept: &impl Fn(Terms) -> Option<T>,
    ) -> Found<T> {
        let field = field_with_roots(which);
        let (skeleton, first): (Vec<Exponents>, Vec<u64>) = terms.into_iter().unzip();
        let mut integers = vec![Int::ZERO; skeleton.len()];
        let mut modulus = Int::ONE;
        let leave = |field: &Modulus, list: Vec<u64>| -> Vec<u64> {
            list.into_iter().map(|x| field.leave(x)).collect()
        };
        combine(&mut integers, &modulus, &leave(&field, first), &field);
        modulus *= Int::from(field.p);
        let candidate = |integers: &[Int]| {
            let mut terms: Terms = skeleton.iter().cloned().zip(integers.iter().cloned()).collect();
            terms.extend(self.lead.iter().map(|(e, c)| {
                let mut e = e.clone();
                e[self.main] = degree as u32;
                (e, c.clone())
            }));
            accept(terms)
        };
        if integers.iter().all(|c| c.bits() <= LIKELY_BITS)
            && let Some(result) = candidate(&integers)
        {
            return Found::Some(result);
        }
        let height = |terms: &[Term]| terms.iter().map(|(_, c)| c.bits()).max().unwrap_or(0);
        // More than any factor can need (Gelfond), times the leading coefficient.
        let total: u64 =
            degrees(&[self.a, self.b], self.variables).iter().map(|d| 2 * u64::from(*d) + 2).sum();
        let enough = height(self.a) + height(self.b) + height(self.lead) + total + 128;
        for field in dense_modular::primes().filter(|f| f.p != field.p) {
            match self.residues(&field, &skeleton, degree) {
                Found::Some(residues) => {
                    let stable = combine(&mut integers, &modulus, &leave(&field, residues), &field);
                    modulus *= Int::from(field.p);
                    if stable && let Some(result) = candidate(&integers) {
                        return Found::Some(result);
                    }
                    if modulus.bits() > enough {
                        return Found::Nothing;
                    }
                }
                Found::Lower(d) => return Found::Lower(d),
                Found::Nothing => return Found::Nothing,
            }
        }
        Found::Nothing
    }

    /// The coefficients of G at the given monomials, modulo another prime.
    fn residues(&self, field: &Modulus, skeleton: &[Exponents], degree: usize) -> Found<Vec<u64>> {
        // The terms come by powers of the main variable.
        let groups: Vec<&[Exponents]> = skeleton.chunk_by(|x, y| x[self.main] == y[self.main]).collect();
        let count = groups.iter().map(|group| group.len()).max().unwrap_or(0);
        'attempt: for attempt in 0..ATTEMPTS {
            let values = self.random_values(field, attempt << 8 | 0xff);
            let (start, ratio) = self.points(field, values.clone(), values);
            let mut images = self.images(&start, &ratio);
            let mut rows: Vec<Vec<u64>> = Vec::with_capacity(count);
            while rows.len() < count {
                match images.next(degree) {
                    Image::Of(image) => rows.push(image),
                    Image::Unlucky => continue 'attempt,
                    Image::Lower(d) => return Found::Lower(d),
                }
            }
            let mut residues = Vec::with_capacity(skeleton.len());
            for group in &groups {
                let power = group[0][self.main] as usize;
                let monomials: Vec<u64> = group.iter().map(|e| start.monomial(e, self.main)).collect();
                let values: Vec<u64> = rows.iter().map(|row| row[power]).collect();
                let Some(c) = weights(field, &monomials, &values) else { continue 'attempt };
                residues.extend(
                    c.iter().zip(&monomials).map(|(c, m)| field.canonical(field.mul(*c, field.invert(*m)))),
                );
            }
            return Found::Some(residues);
        }
        Found::Nothing
    }
}
