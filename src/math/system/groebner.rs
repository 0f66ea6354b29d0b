//! Gröbner bases by Buchberger's algorithm.
//!
//! **Definition.** Polynomials of an ideal I form a Gröbner basis for an order of monomials if the leading monomials of I
//! are the multiples of theirs. It is reduced if each has the leading coefficient 1 and no monomial that is a multiple of
//! another's leading one; then it is unique.
//!
//! **Criteria.** Pairs with coprime leading monomials, and pairs that others replace, are left out (R. Gebauer,
//! H. M. Möller, "On an installation of Buchberger's algorithm", J. Symbolic Computation 6 (1988)).
//!
//! B. Buchberger, dissertation, Innsbruck 1965; D. Cox, J. Little, D. O'Shea, "Ideals, Varieties, and Algorithms",
//! chapter 2.

use num_traits::Signed;
use smallvec::SmallVec;

use super::SystemError;
use crate::budget;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};

pub(super) type Exponents = SmallVec<[u32; 6]>;

/// A polynomial by its terms, the leading one first.
pub(super) type Terms<F> = Vec<(Exponents, F)>;

/// No more pairs are reduced.
pub(super) const MOST_PAIRS: usize = 3000;

/// A polynomial in some unknowns, by terms. Other symbols are coefficients.
pub(super) fn terms_of(f: &MultiPoly, unknowns: &[Symbol], order: MonomialOrder) -> Terms<Fraction> {
    let mut list = vec![(Exponents::new(), f.clone())];
    for x in unknowns {
        list = list
            .into_iter()
            .flat_map(|(exponents, c)| {
                (0u32..).zip(c.coefficients_in(x)).filter(|(_, c)| !c.is_empty()).map(move |(e, c)| {
                    let mut exponents = exponents.clone();
                    exponents.push(e);
                    (exponents, c)
                })
            })
            .collect();
    }
    list.retain(|(_, c)| !c.is_empty());
    list.sort_by(|a, b| order.compare(&b.0, &a.0));
    list.into_iter().map(|(e, c)| (e, Fraction::from(c))).collect()
}

/// The polynomial with these terms.
pub(super) fn monomial(exponents: &[u32], unknowns: &[Symbol]) -> MultiPoly {
    let powers = unknowns.iter().cloned().zip(exponents.iter().copied()).filter(|(_, e)| *e > 0);
    MultiPoly::from_terms([(powers.collect(), num_traits::One::one())])
}

fn divides(a: &[u32], b: &[u32]) -> bool {
    a.iter().zip(b).all(|(x, y)| x <= y)
}

fn lcm(a: &[u32], b: &[u32]) -> Exponents {
    a.iter().zip(b).map(|(x, y)| *x.max(y)).collect()
}

fn coprime(a: &[u32], b: &[u32]) -> bool {
    a.iter().zip(b).all(|(x, y)| *x == 0 || *y == 0)
}

/// f − c x^shift g, where both are sorted.
fn minus_multiple<F: Field>(
    f: &[(Exponents, F)],
    c: &F,
    shift: &[u32],
    g: &[(Exponents, F)],
    order: MonomialOrder,
) -> Terms<F> {
    budget::steps(1 + (f.len() + g.len()) as u32 / 8);
    let mut result = Vec::with_capacity(f.len() + g.len());
    let mut left = f.iter().peekable();
    let moved = g
        .iter()
        .map(|(e, x)| -> (Exponents, F) { (e.iter().zip(shift).map(|(a, b)| a + b).collect(), -c.times(x)) });
    for (e, x) in moved {
        while let Some(term) = left.next_if(|(a, _)| order.compare(a, &e).is_gt()) {
            result.push(term.clone());
        }
        match left.next_if(|(a, _)| *a == e) {
            Some((_, y)) => {
                let sum = y.plus(&x);
                if !sum.is_zero() {
                    result.push((e, sum));
                }
            }
            None => result.push((e, x)),
        }
    }
    result.extend(left.cloned());
    result
}

/// The remainder of f on division by polynomials with leading coefficient 1: no monomial is a multiple of a leading one.
pub(super) fn normal_form<F: Field>(f: Terms<F>, basis: &[&Terms<F>], order: MonomialOrder) -> Terms<F> {
    let (mut rest, mut done) = (f, Vec::new());
    while let Some((lead, c)) = rest.first().cloned() {
        match basis.iter().find(|g| divides(&g[0].0, &lead)) {
            Some(g) => {
                let shift: Exponents = lead.iter().zip(&g[0].0).map(|(a, b)| a - b).collect();
                rest = minus_multiple(&rest, &c, &shift, g, order);
            }
            None => {
                rest.remove(0);
                done.push((lead, c));
            }
        }
    }
    done
}

fn monic<F: Field>(mut f: Terms<F>) -> Option<Terms<F>> {
    let inverse = f.first()?.1.inverse()?;
    for (_, c) in &mut f {
        *c = c.times(&inverse);
    }
    Some(f)
}

/// The reduced Gröbner basis, by increasing leading monomials.
pub(super) fn reduced_basis<F: Field>(
    generators: Vec<Terms<F>>,
    order: MonomialOrder,
) -> Result<Vec<Terms<F>>, SystemError> {
    let mut all: Vec<Terms<F>> = Vec::new();
    let mut alive: Vec<bool> = Vec::new();
    let mut pairs: Vec<(Exponents, usize, usize)> = Vec::new();
    let mut waiting: Vec<Terms<F>> = generators.into_iter().filter_map(monic).collect();
    waiting.sort_by(|a, b| order.compare(&b[0].0, &a[0].0));
    let mut reduced = 0;
    loop {
        let next = match waiting.pop() {
            Some(f) => f,
            None => {
                // The normal strategy: the smallest common multiple first.
                let smallest = (0..pairs.len()).min_by(|&a, &b| order.compare(&pairs[a].0, &pairs[b].0));
                let Some(at) = smallest else { break };
                let (common, i, j) = pairs.swap_remove(at);
                reduced += 1;
                if reduced > MOST_PAIRS {
                    return Err(SystemError::Pairs);
                }
                let shift =
                    |f: &Terms<F>| -> Exponents { common.iter().zip(&f[0].0).map(|(a, b)| a - b).collect() };
                let (f, g) = (&all[i], &all[j]);
                let moved = minus_multiple(&[], &-F::one(), &shift(f), f, order);
                minus_multiple(&moved, &F::one(), &shift(g), g, order)
            }
        };
        let basis: Vec<&Terms<F>> =
            all.iter().zip(&alive).filter(|(_, alive)| **alive).map(|(f, _)| f).collect();
        let Some(f) = monic(normal_form(next, &basis, order)) else { continue };
        let lead = f[0].0.clone();
        if lead.iter().all(|e| *e == 0) {
            return Ok(vec![f]);
        }
        // Old pairs of which both halves are replaced by pairs with f.
        let k = all.len();
        pairs.retain(|(common, i, j)| {
            !divides(&lead, common)
                || lcm(&all[*i][0].0, &lead) == *common
                || lcm(&all[*j][0].0, &lead) == *common
        });
        let new: Vec<(Exponents, usize)> =
            (0..k).filter(|&i| alive[i]).map(|i| (lcm(&all[i][0].0, &lead), i)).collect();
        for (at, (common, i)) in new.iter().enumerate() {
            let replaced = |(other_at, (other, o)): (usize, &(Exponents, usize))| {
                divides(other, common)
                    && (other != common
                        || other_at < at && !coprime(&all[*i][0].0, &lead)
                        || other_at != at && coprime(&all[*o][0].0, &lead))
            };
            let needed = !coprime(&all[*i][0].0, &lead) && !new.iter().enumerate().any(replaced);
            if needed {
                pairs.push((common.clone(), *i, k));
            }
        }
        for i in 0..k {
            if alive[i] && divides(&lead, &all[i][0].0) {
                alive[i] = false;
            }
        }
        all.push(f);
        alive.push(true);
    }
    let kept: Vec<Terms<F>> =
        all.into_iter().zip(alive).filter(|(_, alive)| *alive).map(|(f, _)| f).collect();
    let mut result = Vec::with_capacity(kept.len());
    for (i, f) in kept.iter().enumerate() {
        let others: Vec<&Terms<F>> =
            kept.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, g)| g).collect();
        result.push(normal_form(f.clone(), &others, order));
    }
    result.sort_by(|a: &Terms<F>, b| order.compare(&a[0].0, &b[0].0));
    Ok(result)
}

/// The reduced Gröbner basis of the ideal of some polynomials in the unknowns, the larger unknowns first; other symbols are
/// coefficients, for values of which nothing is divided by 0. Each polynomial is multiplied by its denominator. The zero
/// ideal has no element, the whole ring has 1.
///
/// Cost: in the worst case doubly exponential; at most 3000 pairs of polynomials are reduced, and each step counts for
/// the budget.
///
/// # Errors
/// [`SystemError::Pairs`].
///
/// ```
/// use polarform::poly::{MonomialOrder, MultiPoly, Symbol};
/// use polarform::system::groebner_basis;
/// let unknowns = ["x", "y"].map(Symbol::new);
/// let [x, y] = unknowns.clone().map(MultiPoly::symbol);
/// let basis = groebner_basis(&[x.pow(2) + y.clone(), x.clone() * y], &unknowns, MonomialOrder::Lex).unwrap();
/// let shown: Vec<String> = basis.iter().map(|f| f.to_string()).collect();
/// assert_eq!(shown, ["y^2", "x y", "x^2 + y"]);
/// ```
pub fn groebner_basis(
    polynomials: &[MultiPoly],
    unknowns: &[Symbol],
    order: MonomialOrder,
) -> Result<Vec<MultiPoly>, SystemError> {
    let lists: Vec<Terms<Fraction>> = polynomials.iter().map(|f| terms_of(f, unknowns, order)).collect();
    let numbers = over_numbers(&lists);
    let basis: Vec<Terms<Fraction>> = match numbers {
        Some(lists) => reduced_basis(lists, order)?
            .into_iter()
            .map(|f| f.into_iter().map(|(e, c)| (e, Fraction::from(c))).collect())
            .collect(),
        None => reduced_basis(lists, order)?,
    };
    let written = |f: &Terms<Fraction>| {
        let sum = f.iter().fold(Fraction::from(MultiPoly::zero()), |sum, (e, c)| {
            sum.plus(&c.times(&Fraction::from(monomial(e, unknowns))))
        });
        let polynomial = sum.numerator().primitive_part();
        let lead = terms_of(&polynomial, unknowns, order).into_iter().next();
        match lead.is_some_and(|(_, c)| c.numerator().leading_coefficient().is_negative()) {
            true => -polynomial,
            false => polynomial,
        }
    };
    Ok(basis.iter().map(written).collect())
}

/// The same with numbers as coefficients, if they are.
pub(super) fn over_numbers(lists: &[Terms<Fraction>]) -> Option<Vec<Terms<crate::math::number::Rational>>> {
    let one =
        |list: &Terms<Fraction>| list.iter().map(|(e, c)| Some((e.clone(), c.as_rational()?))).collect();
    lists.iter().map(one).collect()
}
