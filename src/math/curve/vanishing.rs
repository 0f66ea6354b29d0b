//! The polynomial of least degree that is 0 on a surface, by linear equations for its coefficients.
//!
//! Let X, Y, Z, W be polynomials in u and v. A form F of degree d is 0 on the surface if F(X, Y, Z, W) = 0, which is linear in the
//! coefficients of F. The forms that are 0 there are the multiples of one irreducible form, so the first degree that has one has only one.
//! Modulo a prime values at a few pairs (u, v) decide. What is found so is proved by values at a grid with more places than the degrees in u and v, modulo
//! primes whose product exceeds twice what such a value may be.
//!
//! T. W. Sederberg, D. C. Anderson, R. N. Goldman, "Implicit representation of parametric curves and surfaces",
//! Computer Vision, Graphics, and Image Processing 28 (1984).

use crate::budget;
use crate::math::linalg::{Kernel, kernel};
use crate::math::number::{Int, Modulus, over_one_denominator, primes};
use crate::math::poly::{MonomialOrder, MultiPoly, Symbol};

/// Forms with more coefficients are not looked for: degree 13.
pub(super) const MOST_TERMS: usize = 560;

/// Where a search ended.
#[derive(Debug, PartialEq)]
pub(super) enum Vanishing {
    /// Exponents of x, y, z and the coefficients of F(x, y, z, 1), integers without a common factor.
    Form(Vec<([u32; 3], Int)>),
    /// Up to the degree at which forms have more than [`MOST_TERMS`] coefficients there is none.
    Beyond,
}

/// Four polynomials in two parameters by their terms, with integers as coefficients.
pub(super) struct Homogeneous {
    coordinates: [Vec<([u32; 2], Int)>; 4],
}

impl Homogeneous {
    /// `None` if there are other symbols.
    pub(super) fn new(coordinates: [&MultiPoly; 4], parameters: [&Symbol; 2]) -> Option<Self> {
        let of = |f: &MultiPoly| {
            f.terms(MonomialOrder::Lex)
                .into_iter()
                .map(|(monomial, c)| {
                    let exponent = |s: &Symbol| monomial.iter().find(|(x, _)| x == s).map_or(0, |(_, e)| *e);
                    let known = monomial.iter().all(|(s, _)| parameters.contains(&s));
                    known.then(|| (parameters.map(exponent), c))
                })
                .collect::<Option<Vec<_>>>()
        };
        let lists = coordinates.map(of).into_iter().collect::<Option<Vec<_>>>()?;
        let all: Vec<_> = lists.iter().flatten().map(|(_, c)| c.clone()).collect();
        let mut numbers = over_one_denominator(&all).0.into_iter();
        let mut with_numbers = |list: &[([u32; 2], _)]| -> Vec<_> {
            list.iter().map(|(e, _)| *e).zip(numbers.by_ref()).collect()
        };
        let [x, y, z, w] = &lists[..] else { return None };
        Some(Homogeneous {
            coordinates: [with_numbers(x), with_numbers(y), with_numbers(z), with_numbers(w)],
        })
    }

    /// The largest exponents of the parameters.
    fn degrees(&self) -> [u32; 2] {
        [0, 1].map(|k| self.coordinates.iter().flatten().map(|(e, _)| e[k]).max().unwrap_or(0))
    }

    /// The values of all monomials of degree d in the coordinates at pairs of parameters, all modulo a prime.
    fn rows(&self, field: &Modulus, degree: u32, places: &[[u64; 2]]) -> Vec<Vec<u64>> {
        let times = |x: u64, y: u64| field.canonical(field.mul(x, y));
        let powers = |x: u64, most: u32| -> Vec<u64> {
            std::iter::successors(Some(field.enter(1)), |p| Some(times(*p, x)))
                .take(most as usize + 1)
                .collect()
        };
        let lists = self
            .coordinates
            .each_ref()
            .map(|list| list.iter().map(|(e, c)| (*e, field.enter(c.mod_word(field.p)))).collect::<Vec<_>>());
        let [m, n] = self.degrees();
        let exponents = exponents(degree);
        let row = |[u, v]: &[u64; 2]| {
            budget::steps(1 + (exponents.len() / 128) as u32);
            let (u, v) = (powers(*u, m), powers(*v, n));
            let value = |list: &Vec<([u32; 2], u64)>| {
                list.iter().fold(0, |sum, ([i, j], c)| {
                    field.canonical(sum + times(*c, times(u[*i as usize], v[*j as usize])))
                })
            };
            let [x, y, z, w] = lists.each_ref().map(|list| powers(value(list), degree));
            let monomial = |[i, j, k]: &[u32; 3]| {
                let rest = (degree - i - j - k) as usize;
                times(times(x[*i as usize], y[*j as usize]), times(z[*k as usize], w[rest]))
            };
            exponents.iter().map(monomial).collect()
        };
        places.iter().map(row).collect()
    }

    /// Whether a form is 0 on the surface.
    fn lies_on(&self, degree: u32, form: &[Int]) -> bool {
        // At places 0, 1, …, md and 0, 1, …, nd no coordinate exceeds the sum of its terms.
        let [m, n] = self.degrees().map(|k| u64::from(k * degree));
        let most = |list: &Vec<([u32; 2], Int)>| {
            list.iter().fold(Int::ZERO, |sum, ([i, j], c)| {
                sum + num_traits::Signed::abs(c) * Int::from(m).pow(*i) * Int::from(n).pow(*j)
            })
        };
        let value = self.coordinates.iter().map(|list| most(list).bits()).max().unwrap_or(0);
        let height = form.iter().map(Int::bits).max().unwrap_or(0);
        let bits = height + value * u64::from(degree) + form.len().ilog2() as u64 + 3;
        let mut known = 0;
        for field in primes() {
            let numbers: Vec<u64> = form.iter().map(|c| field.enter(c.mod_word(field.p))).collect();
            let place = |i: u64, j: u64| [field.enter(i), field.enter(j)];
            for i in 0..=m {
                let places: Vec<[u64; 2]> = (0..=n).map(|j| place(i, j)).collect();
                let zero = |row: &Vec<u64>| {
                    let sum = row
                        .iter()
                        .zip(&numbers)
                        .fold(0, |sum, (a, b)| field.canonical(sum + field.canonical(field.mul(*a, *b))));
                    sum == 0
                };
                if !self.rows(&field, degree, &places).iter().all(zero) {
                    return false;
                }
            }
            known += 61;
            if known > bits {
                break;
            }
        }
        true
    }

    /// The form of least degree that is 0 on the surface, which is no curve.
    pub(super) fn least_form(&self) -> Vanishing {
        for degree in 1.. {
            let exponents = exponents(degree);
            let count = exponents.len();
            if count > MOST_TERMS {
                break;
            }
            let rows = |field: &Modulus| {
                let mut state = 0x9E37_79B9_7F4A_7C15_u64;
                let mut next = || {
                    state ^= state << 13;
                    state ^= state >> 7;
                    state ^= state << 17;
                    state % field.p
                };
                let places: Vec<[u64; 2]> = (0..count + 8).map(|_| [next(), next()]).collect();
                self.rows(field, degree, &places)
            };
            match kernel(rows, count, |form| self.lies_on(degree, form)) {
                Kernel::Trivial => {}
                Kernel::Line(form) => return Vanishing::Form(exponents.into_iter().zip(form).collect()),
                Kernel::Larger => break,
            }
        }
        Vanishing::Beyond
    }
}

/// The exponents of x, y and z in forms of a degree.
fn exponents(degree: u32) -> Vec<[u32; 3]> {
    (0..=degree)
        .flat_map(|i| (0..=degree - i).flat_map(move |j| (0..=degree - i - j).map(move |k| [i, j, k])))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer};
    use crate::math::ring::Ring;
    use num_traits::{One, Zero};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8))]

        /// The equation of a biquadratic patch is 0 at its points and has the degree 8 at most; its coefficients have no common factor.
        #[test]
        fn biquadratic_patches_have_equations(c in prop::collection::vec(prop::collection::vec(-3i64..4, 9), 3)) {
            let [p, q] = ["u", "v"].map(Symbol::new);
            let [u, v] = [&p, &q].map(|s| MultiPoly::symbol(s.clone()));
            let of = |list: &Vec<i64>| list.iter().enumerate().fold(MultiPoly::zero(), |sum, (k, c)| {
                sum + (u.pow(k as u32 / 3) * v.pow(k as u32 % 3)).scaled(&integer(*c))
            });
            let [x, y, z] = [of(&c[0]), of(&c[1]), of(&c[2])];
            let one = MultiPoly::one();
            let surface = Homogeneous::new([&x, &y, &z, &one], [&p, &q]).unwrap();
            let Vanishing::Form(form) = surface.least_form() else { panic!("there is one") };
            prop_assert!(form.iter().any(|(_, c)| !c.is_zero()));
            prop_assert!(form.iter().all(|(e, _)| e.iter().sum::<u32>() <= 8));
            let common = form.iter().fold(Int::ZERO, |g, (_, c)| num_integer::Integer::gcd(&g, c));
            prop_assert_eq!(common, Int::ONE);
            for (i, j) in [(2, 3), (-1, 5), (7, -4)] {
                let at = |f: &MultiPoly| f.value(&|s| Some(integer(if *s == p { i } else { j }))).as_constant().unwrap();
                let [x, y, z] = [at(&x), at(&y), at(&z)];
                let sum = form.iter().fold(Rational::zero(), |sum, ([i, j, k], c)| {
                    let power = |x: &Rational, e: u32| num_traits::pow(x.clone(), e as usize);
                    sum + Rational::from_integer(c.clone()) * power(&x, *i) * power(&y, *j) * power(&z, *k)
                });
                prop_assert!(sum.is_zero());
            }
        }
    }

    #[test]
    fn high_degrees_are_told() {
        let [p, q] = ["u", "v"].map(Symbol::new);
        let [u, v] = [&p, &q].map(|s| MultiPoly::symbol(s.clone()));
        let one = MultiPoly::one();
        // z = x^9 y^9
        let product = u.pow(9) * v.pow(9);
        let surface = Homogeneous::new([&u, &v, &product, &one], [&p, &q]).unwrap();
        assert_eq!(surface.least_form(), Vanishing::Beyond);
        let saddle = Homogeneous::new([&u, &v, &(u.clone() * v.clone()), &one], [&p, &q]).unwrap();
        let Vanishing::Form(form) = saddle.least_form() else { panic!() };
        assert_eq!(form.iter().filter(|(_, c)| !c.is_zero()).count(), 2);
    }
}
