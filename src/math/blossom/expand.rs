//! Polar forms written out in named arguments, and symmetrisation of any polynomial.
//!
//! Writing out costs one term for every monomial (2^n for degree n); everything that can be
//! done on the n + 1 coefficients is done elsewhere. Symmetrising never enumerates
//! permutations: all monomials of one orbit get the mean of their coefficients over the
//! orbit, whose size is a multinomial coefficient.

use std::collections::BTreeMap;

use super::laws::ArgumentNames;
use super::polar_form::PolarForm;
use super::tensor::TensorPolarForm;
use super::total_degree::TotalDegreePolarForm;
use crate::budget;
use crate::math::number::{Combinations, Int, Rational, multinomial};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

/// Coefficients that can stand in a polynomial.
pub trait Written: Ring {
    /// The coefficient as a polynomial; `None` for a proper quotient.
    fn as_written(&self) -> Option<MultiPoly>;
}

impl Written for Rational {
    fn as_written(&self) -> Option<MultiPoly> {
        Some(MultiPoly::constant(self.clone()))
    }
}

impl Written for MultiPoly {
    fn as_written(&self) -> Option<MultiPoly> {
        Some(self.clone())
    }
}

impl Written for Fraction {
    fn as_written(&self) -> Option<MultiPoly> {
        self.as_polynomial().cloned()
    }
}

/// e_k of the given symbols.
fn elementary(symbols: &[Symbol], k: usize) -> MultiPoly {
    let count = crate::math::number::binomial(symbols.len(), k).to_u64().unwrap_or(u64::MAX);
    budget::charge_terms(count);
    let mut sorted = symbols.to_vec();
    sorted.sort_unstable();
    MultiPoly::from_exponents(&sorted, subsets(sorted.len(), k).map(|e| (e, Int::ONE)), Int::ONE)
}

/// All exponent lists of products of k of n symbols.
fn subsets(n: usize, k: usize) -> impl Iterator<Item = Vec<u32>> {
    Combinations::new(n, k).map(move |chosen| {
        budget::step();
        let mut exponents = vec![0; n];
        chosen.iter().for_each(|&i| exponents[i] = 1);
        exponents
    })
}

/// Σ w_k e_k with numbers w_k, all terms at once.
fn expand_numbers(weights: &[Rational], symbols: &[Symbol]) -> MultiPoly {
    let n = symbols.len();
    let counts = weights.iter().enumerate().filter(|(_, w)| !w.is_zero());
    let counts = counts.map(|(k, _)| crate::math::number::binomial(n, k).to_u64().unwrap_or(u64::MAX));
    budget::charge_terms(counts.fold(0, u64::saturating_add));
    let mut sorted = symbols.to_vec();
    sorted.sort_unstable();
    let denominator = weights.iter().fold(Int::ONE, |l, w| l.lcm(w.denom()));
    let terms = weights.iter().enumerate().filter(|(_, w)| !w.is_zero()).flat_map(|(k, w)| {
        let c = w.numer() * denominator.div_exact(w.denom());
        subsets(n, k).map(move |exponents| (exponents, c.clone()))
    });
    MultiPoly::from_exponents(&sorted, terms, denominator.clone())
}

fn first_coordinates(group: &[Vec<Symbol>]) -> Vec<Symbol> {
    group.iter().map(|argument| argument[0].clone()).collect()
}

/// Σ w_k e_k written out. The arrangement has one group of n numbers.
///
/// Cost: one term for each of up to 2^n monomials (times the terms of the coefficients).
///
/// # Panics
/// If the arrangement does not have one group with n arguments, or a coefficient is a proper quotient.
pub fn expand_univariate<C: Written>(form: &PolarForm<C>, arrangement: &ArgumentNames) -> MultiPoly {
    let symbols = first_coordinates(&arrangement.groups()[0]);
    assert_eq!(symbols.len(), form.degree(), "one symbol for each argument");
    let weights = form.weights();
    let numbers: Option<Vec<Rational>> = weights.iter().map(Ring::as_rational).collect();
    if let Some(numbers) = numbers {
        return expand_numbers(&numbers, &symbols);
    }
    let mut sum = MultiPoly::zero();
    for (k, w) in weights.iter().enumerate().filter(|(_, w)| !w.is_zero()) {
        let w = w.as_written().expect("polynomial coefficients");
        sum += elementary(&symbols, k).times(&w);
    }
    sum
}

/// Σ w_ij e_i(u) e_j(v) written out. The arrangement has two groups of numbers.
///
/// # Panics
/// If the groups do not fit the degrees, or a coefficient is a proper quotient.
pub fn expand_tensor<C: Written>(form: &TensorPolarForm<C>, arrangement: &ArgumentNames) -> MultiPoly {
    let (m, n) = form.degrees();
    let u = first_coordinates(&arrangement.groups()[0]);
    let v = first_coordinates(&arrangement.groups()[1]);
    assert_eq!((u.len(), v.len()), (m, n), "one symbol for each argument");
    let mut sum = MultiPoly::zero();
    for (i, row) in form.coefficients().into_iter().enumerate() {
        let along_v = PolarForm::new(row.to_vec());
        let inner = expand_univariate(&along_v, &ArgumentNames::new(vec![arrangement.groups()[1].clone()]));
        let share = Rational::new(Int::ONE, crate::math::number::binomial(m, i));
        sum += elementary(&u, i).times(&inner).scaled(&share);
    }
    sum
}

/// The total-degree form written out. The arrangement has one group of d points.
///
/// # Panics
/// If the arrangement does not fit, or a coefficient is a proper quotient.
pub fn expand_total<C: Written>(form: &TotalDegreePolarForm<C>, arrangement: &ArgumentNames) -> MultiPoly {
    let points = &arrangement.groups()[0];
    assert_eq!(points.len(), form.degree(), "one point for each argument");
    let mut sum = MultiPoly::zero();
    for (exponents, c) in form.terms() {
        let c = c.as_written().expect("polynomial coefficients");
        // Any monomial with the right factors in distinct arguments; symmetrising does the rest.
        let mut powers = Vec::new();
        let mut argument = points.iter();
        for (k, &e) in exponents.iter().enumerate() {
            for _ in 0..e {
                let point = argument.next().expect("total degree at most d");
                powers.push((point[k].clone(), 1));
            }
        }
        let monomial = MultiPoly::from_terms([(powers, Rational::one())]);
        sum += symmetrize(&monomial, arrangement).times(&c);
    }
    sum
}

/// The exponents of a monomial at each argument, sorted within each group: equal for monomials
/// that exchanges of arguments carry into each other.
pub(super) fn orbit_key(powers: &[(Symbol, u32)], arrangement: &ArgumentNames) -> Vec<Vec<Vec<u32>>> {
    let exponent = |symbol: &Symbol| powers.iter().find(|(s, _)| s == symbol).map_or(0, |(_, e)| *e);
    arrangement
        .groups()
        .iter()
        .map(|group| {
            let mut list: Vec<Vec<u32>> =
                group.iter().map(|argument| argument.iter().map(exponent).collect()).collect();
            list.sort_unstable_by(|a, b| b.cmp(a));
            list
        })
        .collect()
}

/// The mean of an expression over all exchanges of arguments within each group.
///
/// Other symbols are coefficients. The expression need not be multi-affine.
/// Cost: one term for every monomial of every orbit that occurs.
///
/// ```
/// use polarform::blossom::{laws::ArgumentNames, symmetrize};
/// use polarform::poly::{MultiPoly, Symbol};
/// let t = |i| MultiPoly::symbol(Symbol::indexed("t", i));
/// let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 2);
/// let mean = symmetrize(&(t(1) + t(1)), &arrangement);
/// assert_eq!(mean, t(1) + t(2));
/// ```
pub fn symmetrize(expression: &MultiPoly, arrangement: &ArgumentNames) -> MultiPoly {
    let inside = |symbol: &Symbol| arrangement.groups().iter().flatten().flatten().any(|s| s == symbol);
    // For each orbit the sum of the coefficients of its members.
    let mut orbits: BTreeMap<Vec<Vec<Vec<u32>>>, MultiPoly> = BTreeMap::new();
    for (powers, c) in expression.terms(MonomialOrder::Lex) {
        budget::step();
        let key = orbit_key(&powers, arrangement);
        let outside = powers.into_iter().filter(|(symbol, _)| !inside(symbol)).collect();
        *orbits.entry(key).or_insert_with(MultiPoly::zero) += MultiPoly::from_terms([(outside, c)]);
    }
    let mut total = MultiPoly::zero();
    for (key, sum) in orbits {
        if sum.is_zero() {
            continue;
        }
        // Members of the orbit: all orders of the exponent lists within each group.
        let size: Int = key.iter().map(|group| multinomial(&run_lengths(group))).product();
        budget::charge_terms(size.to_u64().unwrap_or(u64::MAX));
        let mut members: Vec<Vec<(Symbol, u32)>> = vec![Vec::new()];
        for (group, arguments) in key.iter().zip(arrangement.groups()) {
            let mut longer = Vec::new();
            for order in distinct_orders(group) {
                for member in &members {
                    let mut powers = member.clone();
                    for (exponents, argument) in order.iter().zip(arguments) {
                        let pairs = exponents.iter().zip(argument).filter(|(e, _)| **e > 0);
                        powers.extend(pairs.map(|(&e, symbol)| (symbol.clone(), e)));
                    }
                    longer.push(powers);
                }
            }
            members = longer;
        }
        let orbit = MultiPoly::from_terms(members.into_iter().map(|powers| (powers, Rational::one())));
        total += orbit.times(&sum).scaled(&Rational::new(Int::ONE, size));
    }
    total
}

/// Lengths of runs of equal items.
fn run_lengths(list: &[Vec<u32>]) -> Vec<usize> {
    list.chunk_by(|a, b| a == b).map(<[_]>::len).collect()
}

/// All different orders of a list sorted in descending order.
fn distinct_orders(sorted: &[Vec<u32>]) -> Vec<Vec<Vec<u32>>> {
    let mut all = vec![sorted.to_vec()];
    let mut current = sorted.to_vec();
    // Previous permutation in lexicographic order, until there is none.
    while let Some(i) = current.windows(2).rposition(|pair| pair[0] > pair[1]) {
        budget::step();
        let j = current.iter().rposition(|item| *item < current[i]).unwrap_or(i + 1);
        current.swap(i, j);
        current[i + 1..].reverse();
        all.push(current.clone());
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};

    fn t(i: i64) -> MultiPoly {
        MultiPoly::symbol(Symbol::indexed("t", i))
    }

    #[test]
    fn orders_are_all_and_distinct() {
        let list = [vec![2], vec![1], vec![1], vec![0]];
        let mut orders = distinct_orders(&list);
        assert_eq!(orders.len(), 12);
        orders.sort();
        orders.dedup();
        assert_eq!(orders.len(), 12);
    }

    #[test]
    fn symmetrised_products_are_polar_forms_of_products() {
        // f(t1, t2) g(t3, t4, t5) symmetrised, against the compact product.
        let f = PolarForm::new([0, 2, 1].map(integer).to_vec());
        let g = PolarForm::new([1, 0, 0, 1].map(integer).to_vec());
        let pick = |from: i64, to: i64| {
            ArgumentNames::new(vec![(from..=to).map(|i| vec![Symbol::indexed("t", i)]).collect()])
        };
        let product = expand_univariate(&f, &pick(1, 2)).times(&expand_univariate(&g, &pick(3, 5)));
        let all = pick(1, 5);
        assert_eq!(symmetrize(&product, &all), expand_univariate(&f.product(&g), &all));
        // The composition f(g(t1, t2, t3), g(t4, t5, t6)).
        let inner = [pick(1, 3), pick(4, 6)].map(|a| expand_univariate(&g, &a));
        let outer = f.map(|c| MultiPoly::constant(c.clone())).value(&inner).unwrap();
        let all = pick(1, 6);
        assert_eq!(symmetrize(&outer, &all), expand_univariate(&f.compose(&g), &all));
    }

    #[test]
    fn symmetrising_any_polynomial() {
        let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 3);
        let c = MultiPoly::symbol(Symbol::new("c"));
        let mean = symmetrize(&(t(1) * t(1) * c.clone()), &arrangement);
        let squares = t(1) * t(1) + t(2) * t(2) + t(3) * t(3);
        assert_eq!(mean, squares.times(&c).scaled(&rational(1, 3)));
        assert_eq!(symmetrize(&mean, &arrangement), mean);
        assert!(symmetrize(&(t(1) - t(2)), &arrangement).is_zero());
    }

    #[test]
    fn total_and_tensor_forms() {
        let points = ArgumentNames::new(vec![
            (1..=2).map(|i| vec![Symbol::indexed("u", i), Symbol::indexed("v", i)]).collect(),
        ]);
        let s = |base: &str, i| MultiPoly::symbol(Symbol::indexed(base, i));
        let total = TotalDegreePolarForm::new(2, 2, [(vec![1, 1], integer(1))]).unwrap();
        let expected = s("u", 1) * s("v", 2) + s("u", 2) * s("v", 1);
        assert_eq!(expand_total(&total, &points), expected.scaled(&rational(1, 2)));
        let groups = ["u", "v"].map(|base| (1..=2).map(|i| vec![Symbol::indexed(base, i)]).collect());
        let mut grid = vec![vec![integer(0); 3]; 3];
        grid[1][1] = integer(1);
        let tensor = TensorPolarForm::new(grid).unwrap();
        let expected = (s("u", 1) + s("u", 2)) * (s("v", 1) + s("v", 2));
        assert_eq!(
            expand_tensor(&tensor, &ArgumentNames::new(groups.to_vec())),
            expected.scaled(&rational(1, 4))
        );
    }
}
