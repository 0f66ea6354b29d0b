//! Polar forms as text, their monomials grouped by degree.

use std::fmt::{Debug, Display, Formatter, Result};

use super::{PolarForm, TensorPolarForm, Worked};
use crate::math::number::Combinations;
use crate::math::ring::Ring;

/// With more arguments than this the symmetric functions are not written out.
const MOST_ARGUMENTS: usize = 8;

/// `f(t1, t2) = t1 t2 + (t1 + t2)`: the weights of the elementary symmetric functions e_k, highest
/// degree first. For more than eight arguments these are written `e_k`.
impl<C: Ring + Display> Display for PolarForm<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let n = self.degree();
        let name = |i: usize| format!("t{}", i + 1);
        let arguments: Vec<String> = match n {
            0..=MOST_ARGUMENTS => (0..n).map(name).collect(),
            _ => vec![name(0), "...".to_owned(), name(n - 1)],
        };
        write!(f, "f({}) = ", arguments.join(", "))?;
        let mut first = true;
        for (k, weight) in self.weights().iter().enumerate().rev().filter(|(_, w)| !w.is_zero()) {
            let text = weight.to_string();
            let several = text.contains(" + ") || text.contains(" - ");
            let (sign, size) = match text.strip_prefix('-') {
                Some(rest) if !several => ("-", rest.to_owned()),
                _ => ("", text),
            };
            f.write_str(match (first, sign) {
                (true, sign) => sign,
                (false, "") => " + ",
                (false, _) => " - ",
            })?;
            first = false;
            let size = if several && k > 0 { format!("({size})") } else { size };
            match (k, size.as_str()) {
                (0, _) => f.write_str(&size)?,
                (_, "1") => f.write_str(&symmetric(n, k))?,
                _ => write!(f, "{size} {}", symmetric(n, k))?,
            }
        }
        if first { f.write_str("0") } else { Ok(()) }
    }
}

/// `PolarForm(f(t1, t2) = t1 t2)`.
impl<C: Ring + Display> Debug for PolarForm<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "PolarForm({self})")
    }
}

/// The forms in the second group of arguments, one for each power of u.
impl<C: Ring + Display> Debug for TensorPolarForm<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("TensorPolarForm")?;
        f.debug_list().entries(self.rows()).finish()
    }
}

impl<C: Ring + Display> Debug for Worked<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.debug_struct("Worked")
            .field("method", &self.method)
            .field("steps", &self.steps)
            .field("form", &self.form)
            .finish()
    }
}

/// e_k of n arguments, for k > 0.
fn symmetric(n: usize, k: usize) -> String {
    if n > MOST_ARGUMENTS {
        return format!("e_{k}");
    }
    let monomial = |subset: Vec<usize>| -> String {
        subset.iter().map(|i| format!("t{}", i + 1)).collect::<Vec<_>>().join(" ")
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
            "TensorPolarForm[PolarForm(f(t1) = 1), PolarForm(f(t1) = 2 t1)]"
        );
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
