//! The equation of a surface by elimination.
//!
//! The points (X/W, Y/W, Z/W) satisfy W x − X = W y − Y = W z − Z = 0 and 1 − s W = 0 for some u, v and s. A Gröbner basis of
//! these four polynomials for a lexicographic order with s > u > v > x > y > z contains a basis of the polynomials in x, y, z alone that
//! vanish on the surface: for a surface one irreducible polynomial.
//!
//! D. Cox, J. Little, D. O'Shea, "Ideals, Varieties, and Algorithms", section 3.3.

use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;
use crate::math::system::{SystemError, groebner_basis};

/// The polynomial in three symbols that is 0 on a surface and on its closure; `None` if the image is a curve or a point. Other symbols
/// are coefficients.
///
/// Cost: a Gröbner basis in six unknowns: bilinear and biquadratic patches of few terms, no bicubic ones.
///
/// # Errors
/// [`SystemError::Pairs`].
///
/// ```
/// use polarform::curve::surface_equation;
/// use polarform::poly::{Fraction, MultiPoly, Symbol};
/// let [u, v] = ["u", "v"].map(|name| Fraction::from(MultiPoly::symbol(Symbol::new(name))));
/// let names = ["u", "v", "x", "y", "z"].map(Symbol::new);
/// let [s, t, x, y, z] = &names;
/// let product = u.clone() * v.clone();
/// let found = surface_equation(&[u, v, product], [s, t], &[x.clone(), y.clone(), z.clone()]).unwrap();
/// assert_eq!(found.unwrap().to_string(), "x y - z");
/// ```
pub fn surface_equation(
    coordinates: &[Fraction; 3],
    parameters: [&Symbol; 2],
    symbols: &[Symbol; 3],
) -> Result<Option<MultiPoly>, SystemError> {
    let weight =
        coordinates.iter().fold(MultiPoly::constant(crate::math::number::integer(1)), |product, f| {
            let common = product.gcd(f.denominator());
            let rest = f.denominator().div_exact(&common).unwrap_or_else(|| f.denominator().clone());
            product.times(&rest)
        });
    let known: Vec<Symbol> =
        coordinates.iter().flat_map(Fraction::variables).chain(symbols.iter().cloned()).collect();
    let slack =
        (0..).map(|k| Symbol::new("w").numbered(k)).find(|s| !known.contains(s)).expect("one of all is free");
    let mut equations: Vec<MultiPoly> = coordinates
        .iter()
        .zip(symbols)
        .map(|(f, x)| {
            let scaled = f.times(&Fraction::from(weight.clone()));
            weight.times(&MultiPoly::symbol(x.clone())).minus(scaled.numerator())
        })
        .collect();
    let mut unknowns = vec![parameters[0].clone(), parameters[1].clone()];
    if weight.as_constant().is_none() {
        let one = MultiPoly::constant(crate::math::number::integer(1));
        equations.push(one.minus(&weight.times(&MultiPoly::symbol(slack.clone()))));
        unknowns.insert(0, slack);
    }
    let eliminated = unknowns.clone();
    unknowns.extend(symbols.iter().cloned());
    let basis = groebner_basis(&equations, &unknowns, MonomialOrder::Lex)?;
    let mut free = basis.into_iter().filter(|f| f.variables().iter().all(|s| !eliminated.contains(s)));
    Ok(match (free.next(), free.next()) {
        (Some(only), None) => Some(only),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::integer;
    use num_traits::Zero;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        /// The equation vanishes on the surface, is irreducible, and is that of a plane for linear coordinates.
        #[test]
        fn equations_vanish(c in prop::collection::vec(prop::collection::vec(-3i64..4, 4), 3), w in 0i64..2) {
            let [u, v] = ["u", "v"].map(|name| MultiPoly::symbol(Symbol::new(name)));
            let monomials = [MultiPoly::constant(integer(1)), u.clone(), v.clone(), u.clone() * v.clone()];
            let below = MultiPoly::constant(integer(1)) + u.scaled(&integer(w));
            let coordinates: [Fraction; 3] = std::array::from_fn(|k| {
                let above = monomials.iter().zip(&c[k]).fold(MultiPoly::zero(), |sum, (m, c)| sum + m.scaled(&integer(*c)));
                Fraction::new(above, below.clone()).unwrap()
            });
            let symbols = ["x", "y", "z"].map(Symbol::new);
            let [p, q] = ["u", "v"].map(Symbol::new);
            let Ok(found) = surface_equation(&coordinates, [&p, &q], &symbols) else { return Ok(()) };
            // The rank of the Jacobian decides whether there is a surface.
            let d = |f: &Fraction, s: &Symbol| f.derivative(s);
            let minor = |i: usize, j: usize| d(&coordinates[i], &p).times(&d(&coordinates[j], &q)).minus(&d(&coordinates[j], &p).times(&d(&coordinates[i], &q)));
            let regular = [(0, 1), (0, 2), (1, 2)].iter().any(|&(i, j)| !minor(i, j).is_zero());
            prop_assert_eq!(found.is_some(), regular);
            if let Some(f) = found {
                let put: Vec<(Symbol, Fraction)> = symbols.iter().cloned().zip(coordinates.iter().cloned()).collect();
                prop_assert!(Fraction::from(f.clone()).substitute(&put).unwrap().is_zero());
                prop_assert_eq!(f.factors().factors.len(), 1);
            }
        }
    }
}
