//! The laws of polar forms, checked on any claimed expression, and the likely slip.
//!
//! A claim is a polynomial in the arguments. It is *the* polar form exactly when it is
//! symmetric, affine in each argument, and has the right diagonal; this module says which
//! law fails and how, compares the coefficients class by class, and recognises the usual
//! slips: a mean over the wrong count, a wrong constant, a symbol in place of its sibling,
//! a degree bound that is off.

use std::collections::BTreeMap;

use super::expand::orbit_key;
use crate::math::number::{Int, Rational};
use crate::math::poly::{MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::{One, Zero};

/// How the arguments of a polar form are named and grouped: groups (one, or two for
/// tensor-product forms) of arguments, each with its coordinates (one for a number).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ArgumentNames {
    groups: Vec<Vec<Vec<Symbol>>>,
}

impl ArgumentNames {
    /// Groups of arguments of coordinates.
    pub fn new(groups: Vec<Vec<Vec<Symbol>>>) -> Self {
        ArgumentNames { groups }
    }

    /// One group of numbers: t1, …, tn.
    ///
    /// ```
    /// use polarform::blossom::laws::ArgumentNames;
    /// use polarform::poly::Symbol;
    /// let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 3);
    /// assert_eq!(arrangement.groups()[0].len(), 3);
    /// ```
    pub fn univariate(base: &Symbol, count: usize) -> Self {
        ArgumentNames::new(vec![(1..=count).map(|i| vec![base.numbered(i as i64)]).collect()])
    }

    /// The groups.
    pub fn groups(&self) -> &[Vec<Vec<Symbol>>] {
        &self.groups
    }

    fn arguments(&self) -> impl Iterator<Item = &Vec<Symbol>> {
        self.groups.iter().flatten()
    }
}

/// Exchanging two arguments changes the expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Asymmetry {
    /// The two arguments.
    pub swap: (Vec<Symbol>, Vec<Symbol>),
    /// Expression after the exchange minus expression before.
    pub change: MultiPoly,
}

/// The expression is not affine in an argument.
#[derive(Clone, Debug, PartialEq)]
pub struct NotAffine {
    /// The argument.
    pub argument: Vec<Symbol>,
    /// Its degree in that argument.
    pub degree: u32,
}

/// All monomials that exchanges of arguments carry into each other, compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// One monomial of the class.
    pub example: MultiPoly,
    /// How many monomials the class has.
    pub count: usize,
    /// The coefficient claimed, if all monomials of the class have the same.
    pub claimed: Option<MultiPoly>,
    /// The right coefficient.
    pub right: MultiPoly,
}

impl Comparison {
    /// Whether the claim is right here.
    pub fn agrees(&self) -> bool {
        self.claimed.as_ref() == Some(&self.right)
    }
}

/// An explanation of what went wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Slip {
    /// Only the constant differs.
    Constant {
        /// Claimed value.
        claimed: MultiPoly,
        /// Right value.
        right: MultiPoly,
    },
    /// The sum of a class was divided by another number than its count.
    WrongCount {
        /// A monomial of the class.
        example: MultiPoly,
        /// What it was divided by.
        used: Rational,
        /// What it must be divided by.
        count: Rational,
    },
    /// One symbol stands for another.
    Sibling {
        /// As written.
        written: Symbol,
        /// As it should be.
        meant: Symbol,
    },
    /// A factor is missing or too many in all the wrong coefficients.
    Factor(Rational),
    /// The sign of a class is wrong.
    Sign {
        /// A monomial of the class.
        example: MultiPoly,
    },
    /// A class of monomials is missing.
    Missing {
        /// A monomial of the class.
        example: MultiPoly,
    },
}

/// What the laws say about a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// A swap that changes the expression, if any.
    pub asymmetry: Option<Asymmetry>,
    /// An argument in which it is not affine, if any.
    pub not_affine: Option<NotAffine>,
    /// Diagonal of the claim minus the right diagonal, if not zero; in the coordinates of
    /// the first argument of each group.
    pub diagonal: Option<MultiPoly>,
    /// Coefficients by classes of monomials.
    pub comparisons: Vec<Comparison>,
    /// Likely explanations.
    pub slips: Vec<Slip>,
}

impl Report {
    /// Whether the claim is the polar form.
    pub fn holds(&self) -> bool {
        self.asymmetry.is_none() && self.not_affine.is_none() && self.diagonal.is_none()
    }

    /// The findings in words, the most telling first; empty if the claim holds.
    pub fn describe(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.slips.iter().map(describe_slip).collect();
        if let Some(asymmetry) = &self.asymmetry {
            lines.push(format!(
                "not symmetric: exchanging {} and {} changes it by {}",
                point(&asymmetry.swap.0),
                point(&asymmetry.swap.1),
                asymmetry.change
            ));
        }
        if let Some(failure) = &self.not_affine {
            lines.push(format!(
                "not affine in {}: its degree there is {}",
                point(&failure.argument),
                failure.degree
            ));
        }
        if let Some(difference) = &self.diagonal {
            lines.push(format!("the diagonal is off by {difference}"));
        } else if !self.holds() {
            lines.push("the diagonal is right, but the polar form is not".to_owned());
        }
        for comparison in self.comparisons.iter().filter(|c| !c.agrees()).take(4) {
            let class = if comparison.count > 1 {
                format!("each of the {} terms like {}", comparison.count, comparison.example)
            } else if comparison.example.is_one() {
                "the constant".to_owned()
            } else {
                format!("the term {}", comparison.example)
            };
            lines.push(match &comparison.claimed {
                Some(claimed) => {
                    format!("coefficient of {class}: {claimed} claimed, {} is right", comparison.right)
                }
                None => format!("coefficients of {class} differ; all must be {}", comparison.right),
            });
        }
        lines
    }
}

fn point(coordinates: &[Symbol]) -> String {
    match coordinates {
        [one] => one.to_string(),
        many => {
            let names: Vec<String> = many.iter().map(Symbol::to_string).collect();
            format!("({})", names.join(", "))
        }
    }
}

fn describe_slip(slip: &Slip) -> String {
    match slip {
        Slip::Constant { claimed, right } => {
            format!("only the constant is wrong: {claimed} should be {right}")
        }
        Slip::WrongCount { example, used, count } => format!(
            "the mean of the terms like {example} was taken over {used}, but there are {count} of them"
        ),
        Slip::Sibling { written, meant } => format!("{written} stands where {meant} belongs"),
        Slip::Factor(factor) => format!("a factor {factor} is missing"),
        Slip::Sign { example } => format!("the sign of the terms like {example} is wrong"),
        Slip::Missing { example } => format!("the terms like {example} are missing"),
    }
}

/// Checks a claimed expression against the right polar form, both written in the arguments
/// of the arrangement.
///
/// Cost: linear in the number of terms times the number of arguments.
///
/// ```
/// use polarform::blossom::laws::{ArgumentNames, check};
/// use polarform::poly::{MultiPoly, Symbol};
/// let t = |i| MultiPoly::symbol(Symbol::indexed("t", i));
/// let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 2);
/// let right = t(1) * t(2);
/// let report = check(&(t(1) * t(1)), &right, &arrangement);
/// assert_eq!(report.not_affine.unwrap().degree, 2);
/// assert!(report.asymmetry.is_some());
/// assert!(report.diagonal.is_none()); // t^2 either way
/// assert!(check(&right, &right, &arrangement).holds());
/// ```
pub fn check(claim: &MultiPoly, right: &MultiPoly, arrangement: &ArgumentNames) -> Report {
    let comparisons = compare(claim, right, arrangement);
    Report {
        asymmetry: asymmetry(claim, arrangement),
        not_affine: not_affine(claim, arrangement),
        diagonal: diagonal_difference(claim, right, arrangement),
        slips: slips(claim, right, arrangement, &comparisons),
        comparisons,
    }
}

/// The first exchange of two neighbouring arguments that changes the expression. Exchanges of
/// neighbours generate all permutations.
pub fn asymmetry(claim: &MultiPoly, arrangement: &ArgumentNames) -> Option<Asymmetry> {
    for group in &arrangement.groups {
        for pair in group.windows(2) {
            let swapped = claim.rename(&|symbol: &Symbol| {
                let place = |from: &[Symbol], to: &[Symbol]| {
                    from.iter().position(|s| s == symbol).map(|k| to[k].clone())
                };
                place(&pair[0], &pair[1])
                    .or_else(|| place(&pair[1], &pair[0]))
                    .unwrap_or_else(|| symbol.clone())
            });
            if swapped != *claim {
                return Some(Asymmetry {
                    swap: (pair[0].clone(), pair[1].clone()),
                    change: swapped.minus(claim),
                });
            }
        }
    }
    None
}

/// The first argument in which the expression has a degree above 1 (in all coordinates together).
pub fn not_affine(claim: &MultiPoly, arrangement: &ArgumentNames) -> Option<NotAffine> {
    let terms = claim.terms(MonomialOrder::Lex);
    arrangement.arguments().find_map(|argument| {
        let degree = terms
            .iter()
            .map(|(powers, _)| {
                powers.iter().filter(|(s, _)| argument.contains(s)).map(|(_, e)| *e).sum::<u32>()
            })
            .max()
            .unwrap_or(0);
        (degree > 1).then(|| NotAffine { argument: argument.clone(), degree })
    })
}

/// Diagonal of the claim minus diagonal of the right form, if not zero.
fn diagonal_difference(
    claim: &MultiPoly,
    right: &MultiPoly,
    arrangement: &ArgumentNames,
) -> Option<MultiPoly> {
    let difference = claim.minus(right).rename(&|symbol: &Symbol| {
        for group in &arrangement.groups {
            for argument in group {
                if let Some(k) = argument.iter().position(|s| s == symbol) {
                    return group[0][k].clone();
                }
            }
        }
        symbol.clone()
    });
    (!difference.is_zero()).then_some(difference)
}

/// Powers of the arguments, and the coefficient in the other symbols.
type Class = Vec<Vec<Vec<u32>>>;

fn classes(p: &MultiPoly, arrangement: &ArgumentNames) -> BTreeMap<Class, Vec<(MultiPoly, MultiPoly)>> {
    let mut by_monomial: BTreeMap<Vec<(Symbol, u32)>, MultiPoly> = BTreeMap::new();
    for (powers, c) in p.terms(MonomialOrder::Lex) {
        let (inside, outside): (Vec<_>, Vec<_>) =
            powers.into_iter().partition(|(symbol, _)| arrangement.arguments().any(|a| a.contains(symbol)));
        let coefficient = MultiPoly::from_terms([(outside, c)]);
        *by_monomial.entry(inside).or_insert_with(MultiPoly::zero) += coefficient;
    }
    let mut result: BTreeMap<Class, Vec<(MultiPoly, MultiPoly)>> = BTreeMap::new();
    for (powers, coefficient) in by_monomial {
        let key = orbit_key(&powers, arrangement);
        let monomial = MultiPoly::from_terms([(powers, Rational::one())]);
        result.entry(key).or_default().push((monomial, coefficient));
    }
    result
}

fn compare(claim: &MultiPoly, right: &MultiPoly, arrangement: &ArgumentNames) -> Vec<Comparison> {
    let (claimed, correct) = (classes(claim, arrangement), classes(right, arrangement));
    let mut keys: Vec<&Class> = claimed.keys().chain(correct.keys()).collect();
    keys.sort();
    keys.dedup();
    let mut comparisons: Vec<Comparison> = keys
        .into_iter()
        .filter_map(|key| {
            let ours = claimed.get(key).map_or(&[] as &[_], Vec::as_slice);
            let theirs = correct.get(key).map_or(&[] as &[_], Vec::as_slice);
            let example = theirs.first().or(ours.first())?.0.clone();
            let count = theirs.len().max(ours.len());
            let complete = ours.is_empty() || ours.len() == count;
            let same = ours.windows(2).all(|pair| pair[0].1 == pair[1].1);
            let zero = MultiPoly::zero();
            let first = ours.first().map_or(&zero, |(_, c)| c);
            Some(Comparison {
                example,
                count,
                claimed: (complete && same).then(|| first.clone()),
                right: theirs.first().map_or(zero.clone(), |(_, c)| c.clone()),
            })
        })
        .collect();
    comparisons.reverse();
    comparisons
}

fn slips(
    claim: &MultiPoly,
    right: &MultiPoly,
    arrangement: &ArgumentNames,
    comparisons: &[Comparison],
) -> Vec<Slip> {
    let wrong: Vec<&Comparison> = comparisons.iter().filter(|c| !c.agrees()).collect();
    let Some(first) = wrong.first() else { return Vec::new() };
    if let Some(sibling) = sibling(claim, right, arrangement) {
        return vec![sibling];
    }
    let mut found = Vec::new();
    if wrong.len() == 1
        && first.example.is_one()
        && let Some(claimed) = &first.claimed
    {
        return vec![Slip::Constant { claimed: claimed.clone(), right: first.right.clone() }];
    }
    let ratios: Option<Vec<Rational>> = wrong.iter().map(|c| ratio(c)).collect();
    if let Some(ratios) = &ratios
        && ratios.len() > 1
        && ratios.windows(2).all(|pair| pair[0] == pair[1])
        && !ratios[0].is_zero()
    {
        found.push(Slip::Factor(ratios[0].clone()));
        return found;
    }
    for comparison in wrong {
        let Some(claimed) = &comparison.claimed else { continue };
        let example = comparison.example.clone();
        if claimed.is_zero() {
            found.push(Slip::Missing { example });
        } else if claimed.plus(&comparison.right).is_zero() {
            found.push(Slip::Sign { example });
        } else if let Some(ratio) = ratio(comparison) {
            // right = claimed · ratio: the mean was taken over count · ratio.
            let count = Rational::from_integer(Int::from(comparison.count));
            let used = &count * &ratio;
            if comparison.count > 1 && used.is_integer() && used > Rational::zero() {
                found.push(Slip::WrongCount { example, used, count });
            }
        }
    }
    found
}

/// right / claimed, when both are multiples of each other by a number.
fn ratio(comparison: &Comparison) -> Option<Rational> {
    let claimed = comparison.claimed.as_ref().filter(|c| !c.is_zero())?;
    comparison.right.div_exact(claimed)?.as_constant()
}

/// A symbol outside the arguments which, replaced by another one everywhere it is too much,
/// makes the claim right: c_1 written for c_2.
fn sibling(claim: &MultiPoly, right: &MultiPoly, arrangement: &ArgumentNames) -> Option<Slip> {
    let outside = |p: &MultiPoly| -> Vec<Symbol> {
        let inside = |symbol: &Symbol| arrangement.arguments().any(|a| a.contains(symbol));
        p.variables().iter().filter(|symbol| !inside(symbol)).cloned().collect()
    };
    let difference = right.minus(claim);
    let (present, wanted) = (outside(claim), outside(&difference));
    for written in present.iter().filter(|symbol| wanted.contains(symbol)) {
        for meant in wanted.iter().filter(|symbol| *symbol != written && symbol.base() == written.base()) {
            // right − claim = (meant − written) · q with a q that holds neither.
            let gap = MultiPoly::symbol(meant.clone()).minus(&MultiPoly::symbol(written.clone()));
            if let Some(quotient) = difference.div_exact(&gap)
                && !quotient.variables().contains(written)
                && !quotient.variables().contains(meant)
            {
                return Some(Slip::Sibling { written: written.clone(), meant: meant.clone() });
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::blossom::{PolarForm, expand::expand_univariate};
    use crate::math::number::{integer, rational};

    fn t(i: i64) -> MultiPoly {
        MultiPoly::symbol(Symbol::indexed("t", i))
    }

    fn scale(p: MultiPoly, n: i64, d: i64) -> MultiPoly {
        p.scaled(&rational(n, d))
    }

    fn cubic() -> (MultiPoly, ArgumentNames) {
        let form = PolarForm::new([1, 5, 3, 1].map(integer).to_vec());
        let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 3);
        (expand_univariate(&form, &arrangement), arrangement)
    }

    #[test]
    fn the_right_form_holds() {
        let (right, arrangement) = cubic();
        assert!(check(&right, &right, &arrangement).holds());
        assert!(check(&right, &right, &arrangement).describe().is_empty());
    }

    #[test]
    fn constants_and_counts() {
        let (right, arrangement) = cubic();
        let off = right.plus(&MultiPoly::constant(integer(2)));
        let report = check(&off, &right, &arrangement);
        assert!(matches!(report.slips.as_slice(), [Slip::Constant { .. }]), "{report:?}");
        assert_eq!(report.diagonal, Some(MultiPoly::constant(integer(2))));
        // 5/6 (t1 + t2 + t3): the mean was taken over 6.
        let halved = right.minus(&scale(t(1) + t(2) + t(3), 5, 6));
        let report = check(&halved, &right, &arrangement);
        assert_eq!(report.slips, [Slip::WrongCount { example: t(1), used: integer(6), count: integer(3) }]);
    }

    #[test]
    fn siblings() {
        let c = |i| MultiPoly::symbol(Symbol::indexed("c", i));
        let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 2);
        let pairs = t(1) * t(2);
        let ends = scale(t(1) + t(2), 1, 2);
        let right = c(0) + c(1) * ends.clone() + c(2) * pairs.clone();
        let claim = c(0) + c(1) * ends + c(1) * pairs;
        let report = check(&claim, &right, &arrangement);
        assert_eq!(
            report.slips,
            [Slip::Sibling { written: Symbol::indexed("c", 1), meant: Symbol::indexed("c", 2) }]
        );
    }

    #[test]
    fn a_missing_class_and_a_swap() {
        let (right, arrangement) = cubic();
        let claim = right.minus(&t(1));
        let report = check(&claim, &right, &arrangement);
        assert_eq!(report.asymmetry.as_ref().unwrap().change, t(1) - t(2));
        assert!(report.describe().iter().any(|line| line.contains("not symmetric")));
        let pairs = t(1) * t(2) + t(1) * t(3) + t(2) * t(3);
        let report = check(&right.minus(&pairs), &right, &arrangement);
        assert!(matches!(report.slips.as_slice(), [Slip::Missing { .. }]));
    }

    #[test]
    fn points_are_not_numbers() {
        // The tensor-product form of u v is not affine in the points.
        let s = |base: &str, i| MultiPoly::symbol(Symbol::indexed(base, i));
        let arrangement = ArgumentNames::new(vec![
            (1..=2).map(|i| vec![Symbol::indexed("u", i), Symbol::indexed("v", i)]).collect(),
        ]);
        let right = scale(s("u", 1) * s("v", 2) + s("u", 2) * s("v", 1), 1, 2);
        let claim = scale((s("u", 1) + s("u", 2)) * (s("v", 1) + s("v", 2)), 1, 4);
        let report = check(&claim, &right, &arrangement);
        assert!(report.asymmetry.is_none());
        assert!(report.diagonal.is_none());
        assert_eq!(report.not_affine.unwrap().degree, 2);
    }
}
