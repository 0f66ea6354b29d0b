//! Polar forms as text, their monomials grouped by degree.

use std::fmt::{Debug, Display, Formatter, Result};

use super::{Argument, PolarForm, TensorPolarForm, TotalDegreePolarForm, Worked};
use crate::math::number::{Combinations, Rational, binomial_row};
use crate::math::poly::text::{power, sum};
use crate::math::ring::Ring;

/// With more arguments than this the symmetric functions are not written out.
const MOST_ARGUMENTS: usize = 8;

/// `f(t1, t2) = t1 t2 + (t1 + t2)`: the weights of the elementary symmetric functions e_k, highest
/// degree first. For more than eight arguments these are written `e_k`.
impl<C: Ring + Display> Display for PolarForm<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let n = self.degree();
        write!(f, "f({}) = ", arguments("t", n))?;
        let weights = self.weights();
        sum(f, weights.iter().enumerate().rev().map(|(k, weight)| (weight, symmetric("t", n, k))))
    }
}

/// `f(u1, u2; v1) = u1 u2 v1 + (u1 + u2)`: the weights of products of elementary symmetric functions of both groups.
impl<C: Ring + Display> Display for TensorPolarForm<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (m, n) = self.degrees();
        write!(f, "f({}; {}) = ", arguments("u", m), arguments("v", n))?;
        // Rows belong to powers of u, with the weights of e_j(v) in each.
        let binomials = |degree: usize| binomial_row(degree).into_iter().map(Rational::from_integer);
        let mut terms = Vec::new();
        for (i, (row, b)) in self.rows().iter().zip(binomials(m)).enumerate() {
            for (j, weight) in row.weights().iter().enumerate() {
                let behind = [symmetric("u", m, i), symmetric("v", n, j)];
                let behind: Vec<String> = behind.into_iter().filter(|text| !text.is_empty()).collect();
                terms.push((weight.scaled(&b.recip()), behind.join(" ")));
            }
        }
        sum(f, terms.iter().rev().map(|(weight, behind)| (weight, behind.clone())))
    }
}

/// `x1 x2 + 1 of total degree 2`: the polynomial whose polar form it is.
impl<C: Ring + Display> Display for TotalDegreePolarForm<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let monomial = |exponents: &[u32]| {
            let named = exponents.iter().zip(1..).map(|(&e, i)| power(&format!("x{i}"), e as usize));
            named.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ")
        };
        let mut terms: Vec<_> = self.terms().map(|(exponents, c)| (c, monomial(exponents))).collect();
        terms.reverse();
        sum(f, terms)?;
        write!(f, " of total degree {}", self.degree())
    }
}

/// A point by itself, a vector as `vector …`.
impl<P: Display, V: Display> Display for Argument<P, V> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Argument::Point(p) => Display::fmt(p, f),
            Argument::Vector(v) => write!(f, "vector {v}"),
        }
    }
}

debug_by_text!(PolarForm, TensorPolarForm, TotalDegreePolarForm);

impl<C: Ring + Display> Debug for Worked<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.debug_struct("Worked")
            .field("method", &self.method)
            .field("steps", &self.steps)
            .field("form", &self.form)
            .finish()
    }
}

fn arguments(letter: &str, n: usize) -> String {
    let name = |i: usize| format!("{letter}{}", i + 1);
    let list: Vec<String> = match n {
        0..=MOST_ARGUMENTS => (0..n).map(name).collect(),
        _ => vec![name(0), "...".to_owned(), name(n - 1)],
    };
    list.join(", ")
}

/// e_k of n arguments; nothing for k = 0.
fn symmetric(letter: &str, n: usize, k: usize) -> String {
    if k == 0 {
        return String::new();
    }
    if n > MOST_ARGUMENTS {
        return if letter == "t" { format!("e_{k}") } else { format!("e_{k}({letter})") };
    }
    let monomial = |subset: Vec<usize>| -> String {
        subset.iter().map(|i| format!("{letter}{}", i + 1)).collect::<Vec<_>>().join(" ")
    };
    let monomials: Vec<String> = Combinations::new(n, k).map(monomial).collect();
    if monomials.len() == 1 { monomials.concat() } else { format!("({})", monomials.join(" + ")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};

    #[test]
    fn grouped_by_degree() {
        let shown = |list: &[i64]| PolarForm::new(list.iter().map(|&c| integer(c)).collect()).to_string();
        assert_eq!(shown(&[0, 2, 1]), "f(t1, t2) = t1 t2 + (t1 + t2)");
        assert_eq!(
            shown(&[1, 5, 3, 1]),
            "f(t1, t2, t3) = t1 t2 t3 + (t1 t2 + t1 t3 + t2 t3) + 5/3 (t1 + t2 + t3) + 1"
        );
        assert_eq!(shown(&[-1, -3]), "f(t1) = -3 t1 - 1");
        assert_eq!(shown(&[0, 0, 0]), "f(t1, t2) = 0");
        assert_eq!(shown(&[7]), "f() = 7");
        let constant = PolarForm::new(vec![integer(7)]);
        assert_eq!(format!("{:?}", Some(constant)), "Some(PolarForm(f() = 7))");
        let grid = vec![vec![integer(1), integer(0)], vec![integer(0), integer(2)]];
        assert_eq!(
            format!("{:?}", TensorPolarForm::new(grid).unwrap()),
            "TensorPolarForm(f(u1; v1) = 2 u1 v1 + 1)"
        );
        let grid = [[0, 0, 4], [0, 2, 0], [3, 0, 0]].map(|row| row.map(integer).to_vec()).to_vec();
        assert_eq!(
            TensorPolarForm::new(grid).unwrap().to_string(),
            "f(u1, u2; v1, v2) = 3 u1 u2 + 1/2 (u1 + u2) (v1 + v2) + 4 v1 v2"
        );
        let terms = [(vec![1, 1], integer(2)), (vec![0, 2], integer(-1)), (vec![0, 0], integer(5))];
        let total = TotalDegreePolarForm::new(2, 2, terms).unwrap();
        assert_eq!(format!("{total:?}"), "TotalDegreePolarForm(2 x1 x2 - x2^2 + 5 of total degree 2)");
        let vector: Argument<_> = Argument::Vector(rational(1, 2));
        assert_eq!(format!("{} {vector}", Argument::<_>::Point(integer(3))), "3 vector 1/2");
        let long =
            PolarForm::new((0..=20).map(|k| if k == 2 { rational(19, 1) } else { integer(0) }).collect());
        assert_eq!(long.to_string(), "f(t1, ..., t20) = 1/10 e_2");
    }

    #[test]
    fn formulas_as_coefficients() {
        let s = |name: &str| Fraction::from(MultiPoly::symbol(Symbol::new(name)));
        let form = PolarForm::new(vec![s("a") - s("b"), s("a") + s("b"), -s("c")]);
        assert_eq!(form.to_string(), "f(t1, t2) = -c t1 t2 + (1/2 a + 1/2 b) (t1 + t2) + a - b");
    }
}
