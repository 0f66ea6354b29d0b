//! Real roots in intervals of their own, by Bernstein coefficients and Descartes' rule of signs.
//!
//! A polynomial has at most as many roots inside an interval as the signs of its Bernstein coefficients change,
//! and as many up to an even number: none without a change, exactly one with one change. Otherwise the interval is halved.
//! For simple roots this ends, since a short interval that has no root or one, with no other near it, has
//! at most one change (the theorem of two circles).
//!
//! J. M. Lane, R. F. Riesenfeld, "Bounds on a polynomial", BIT 21 (1981); S. Basu, R. Pollack, M.-F. Roy,
//! "Algorithms in Real Algebraic Geometry", section 10.2.

use num_traits::{One, Zero};

use super::algebraic::{AlgebraicNumber, RealRoot};
use super::bernstein;
use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational};
use crate::math::poly::Poly;
use crate::math::poly::factor::coarse_factors;

/// An interval that was looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its lower end.
    pub lower: Rational,
    /// Its upper end.
    pub upper: Rational,
    /// How often the signs of the Bernstein coefficients over it change.
    pub changes: usize,
    /// Whether the upper end is a root.
    pub root_at_upper: bool,
}

/// All intervals that are looked at, each before its halves and the left half first, for a polynomial with simple
/// roots only. The roots are those at upper ends, one inside of each with one change, and perhaps the lower end.
pub(super) fn parts(f: &[Int], lower: &Rational, upper: &Rational) -> Vec<Part> {
    let mut open = vec![(lower.clone(), upper.clone(), bernstein::over(f, lower, upper))];
    let mut found = Vec::new();
    while let Some((lower, upper, list)) = open.pop() {
        budget::steps(1 + (list.len() * list.len() / 64) as u32);
        let changes = bernstein::sign_changes(&list);
        let root_at_upper = list.last().is_some_and(Zero::is_zero);
        if changes > 1 {
            let middle = (&lower + &upper) / Rational::from_integer(2.into());
            let (left, right) = bernstein::halves(&list);
            open.push((middle.clone(), upper.clone(), right));
            open.push((lower.clone(), middle, left));
        }
        found.push(Part { lower, upper, changes, root_at_upper });
    }
    found
}

impl Poly {
    /// A power of 2 that is larger than every root in size, also than the complex ones; 1 for constants.
    ///
    /// M. Fujiwara, "Über die obere Schranke des absoluten Betrages der Wurzeln einer algebraischen Gleichung",
    /// Tôhoku Math. J. 10 (1916): no root exceeds 2 max |a_{n−k}/a_n|^{1/k}.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// let f = Poly::variable().pow(2) - Poly::from(100);
    /// assert_eq!(f.root_bound(), integer(32));
    /// ```
    pub fn root_bound(&self) -> Rational {
        let Some((lead, lower)) = self.numerators().split_last() else { return Rational::one() };
        let exponent = lower.iter().rev().zip(1_i64..).filter(|(a, _)| !a.is_zero()).map(|(a, k)| {
            let ratio = a.bits() as i64 - lead.bits() as i64 + 1;
            1 + num_integer::Integer::div_ceil(&ratio, &k)
        });
        let exponent = exponent.max().unwrap_or(0).max(0);
        budget::charge_bits(exponent as u64);
        Rational::from_integer(Int::from(2).pow(exponent as u32))
    }

    /// The real roots in [a, b] in increasing order with their multiplicities, where `None` for an end means that there
    /// is none; `None` for the zero polynomial, of which every number is a root. Rational roots are given as such,
    /// others by intervals that contain no other root, see [`AlgebraicNumber`].
    ///
    /// Cost: that of factors modulo a prime (see [`Poly::factors`], whose search over many factors is cut short
    /// here), then O(n²) additions for each interval that is looked at, of which there are O(n (b + log n)) for
    /// coefficients of b bits in the worst case and about two for each root usually.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = (t.pow(2) - Poly::from(2)) * (&t - Poly::from(3)).pow(2);
    /// let roots = f.real_roots(None, None).unwrap();
    /// let shown: Vec<String> = roots.iter().map(|(root, m)| format!("{root} ({m})")).collect();
    /// assert_eq!(shown, ["t^2 - 2 in (-2, -1) (1)", "t^2 - 2 in (1, 2) (1)", "3 (2)"]);
    /// ```
    pub fn real_roots(&self, a: Option<&Rational>, b: Option<&Rational>) -> Option<Vec<(RealRoot, usize)>> {
        self.degree()?;
        // Factors are only looked for if there are roots.
        let simple = self.square_free_part();
        let bound = simple.root_bound();
        let lower = a.map_or_else(|| -&bound, |a| a.clone().max(-&bound));
        let upper = b.map_or_else(|| bound.clone(), |b| b.clone().min(bound.clone()));
        let none = lower > upper || simple.degree() == Some(0) || {
            let found = lower < upper
                && parts(simple.primitive_part().numerators(), &lower, &upper)
                    .iter()
                    .any(|part| part.root_at_upper || part.changes == 1);
            !found && !simple.value(&lower).is_zero()
        };
        if none {
            return Some(Vec::new());
        }
        let inside = |q: &Rational| a.is_none_or(|a| a <= q) && b.is_none_or(|b| q <= b);
        let (mut roots, mut others) = (Vec::new(), Vec::new());
        for (part, multiplicity) in self.square_free_factors() {
            for factor in coarse_factors(part.primitive_part()) {
                if factor.degree() == Some(1) {
                    let root = -factor.coefficient(0) / factor.coefficient(1);
                    roots.extend(inside(&root).then_some((RealRoot::Rational(root), multiplicity)));
                } else {
                    others.push((factor, multiplicity));
                }
            }
        }
        let product: Poly = others.iter().map(|(factor, _)| factor.clone()).product();
        let bound = product.root_bound();
        let lower = a.map_or_else(|| -&bound, |a| a.clone().max(-&bound));
        let upper = b.map_or_else(|| bound.clone(), |b| b.clone().min(bound.clone()));
        if product.degree() > Some(0) && lower < upper {
            let rational: Vec<RealRoot> = roots.iter().map(|(root, _)| root.clone()).collect();
            for part in parts(product.numerators(), &lower, &upper).into_iter().filter(|p| p.changes == 1) {
                // The product has one root there, so one factor changes its sign.
                let own = others.iter().find_map(|(factor, multiplicity)| {
                    let number = AlgebraicNumber::between(factor, part.lower.clone(), part.upper.clone())?;
                    Some((number, *multiplicity))
                });
                let Some((mut number, multiplicity)) = own else { continue };
                number.tighten();
                for root in &rational {
                    if let RealRoot::Rational(root) = root {
                        number.separate(root);
                    }
                }
                roots.push((RealRoot::Irrational(number), multiplicity));
            }
        }
        roots.sort();
        Some(roots)
    }

    /// How the roots in an interval (a, b) of the square-free part are isolated: the intervals that are looked at, each before
    /// its halves. Empty if a > b and for constants.
    ///
    /// ```
    /// # use polarform::{interval::Interval, number::integer, poly::Poly};
    /// let t = Poly::variable();
    /// let f = (t.pow(2) - Poly::from(2)) * (&t - Poly::from(3));
    /// let parts = f.subdivision(&Interval::new(integer(0), integer(4))?);
    /// let changes: Vec<usize> = parts.iter().map(|part| part.changes).collect();
    /// assert_eq!(changes, [2, 1, 1]);
    /// # Ok::<(), polarform::interval::EmptyInterval>(())
    /// ```
    pub fn subdivision(&self, interval: &Interval<Rational>) -> Vec<Part> {
        let (a, b) = interval.ends();
        let simple = self.square_free_part();
        if a > b || simple.degree().is_none_or(|n| n == 0) {
            return Vec::new();
        }
        parts(simple.primitive_part().numerators(), a, b)
    }
}
