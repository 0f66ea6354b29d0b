//! Signs of a polynomial on an interval, a half-line or the line, with certificates.
//!
//! F is not negative if and only if F = S² G, where S has the roots of even multiplicity, and G, whose roots are simple, is
//! not negative. On an interval that is shown by Bernstein coefficients of G that are not negative, over parts that
//! are short enough: where G has no root inside that happens after finitely many halvings. On a half-line it is
//! shown by the coefficients of G(c + x): beyond all roots none is negative, since the roots of the derivatives lie
//! in the convex hull of those of G (Gauss and Lucas).
//!
//! G. Pólya, G. Szegő, "Problems and Theorems in Analysis" 2, part VI; J. M. Lane, R. F. Riesenfeld, "Bounds on a
//! polynomial", BIT 21 (1981).

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::algebraic::RealRoot;
use super::bernstein;
use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational, binomial, integer};
use crate::math::poly::Poly;

/// Numbers from which anybody can check that F ≥ 0: F = S² G, and coefficients of G of which none is negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Positivity {
    /// S
    pub root_of_square: Poly,
    /// G
    pub rest: Poly,
    /// c and G(c − x), if there is no lower end.
    pub below: Option<(Rational, Poly)>,
    /// Intervals with the Bernstein coefficients of G over them.
    pub parts: Vec<(Rational, Rational, Vec<Rational>)>,
    /// c and G(c + x), if there is no upper end.
    pub above: Option<(Rational, Poly)>,
}

impl Poly {
    /// A rational number in [a, b] at which F is negative, one that is short; `None` if F ≥ 0 there. An end that
    /// is `None` is none. Cost: as for isolating the roots.
    ///
    /// ```
    /// # use polarform::{number::{integer, rational}, poly::Poly};
    /// let f = Poly::variable().pow(2) * (Poly::variable() - Poly::from(3));
    /// assert_eq!(f.negative_point(Some(&integer(3)), None), None);
    /// assert_eq!(f.negative_point(None, None), Some(integer(1)));
    /// assert_eq!(f.negative_point(Some(&integer(0)), Some(&rational(1, 3))), Some(rational(1, 4)));
    /// ```
    pub fn negative_point(&self, a: Option<&Rational>, b: Option<&Rational>) -> Option<Rational> {
        if let (Some(a), Some(b)) = (a, b)
            && a >= b
        {
            return (a == b && self.value(a).is_negative()).then(|| a.clone());
        }
        let mut roots: Vec<RealRoot> = self.real_roots(a, b)?.into_iter().map(|(root, _)| root).collect();
        roots.dedup();
        // Between neighbouring roots the sign is constant.
        let ends = [a.cloned(), b.cloned()].map(|end| end.map(RealRoot::Rational));
        let [first, last] = ends;
        let cuts = std::iter::once(first.clone())
            .chain(roots.into_iter().map(Some).filter(|root| *root != first && *root != last))
            .chain(std::iter::once(last.clone()));
        let cuts: Vec<Option<RealRoot>> = cuts.collect();
        let points = cuts.windows(2).map(|pair| between(pair[0].as_ref(), pair[1].as_ref()));
        let negative = points.filter(|x| self.value(x).is_negative());
        negative.min_by_key(|x| (x.denom().bits().max(x.numer().bits()), x.is_negative()))
    }

    /// Why F ≥ 0 on [a, b], where an end that is `None` is none; or a number at which F is negative.
    ///
    /// Cost: as for isolating the roots, then O(n²) additions for each part, of which there are the more the nearer
    /// a complex root is to the interval.
    ///
    /// # Errors
    /// A rational number in [a, b] at which F is negative.
    ///
    /// ```
    /// # use polarform::{number::{integer, rational}, poly::Poly};
    /// let t = Poly::variable();
    /// let shown = (t.pow(2) - &t + Poly::one()).positivity(Some(&integer(0)), Some(&integer(1))).unwrap();
    /// assert_eq!(shown.parts[0].2, [integer(1), rational(1, 2), integer(1)]);
    /// assert_eq!((t.pow(2) - &t).positivity(Some(&integer(0)), Some(&integer(1))), Err(rational(1, 2)));
    /// ```
    pub fn positivity(&self, a: Option<&Rational>, b: Option<&Rational>) -> Result<Positivity, Rational> {
        if let Some(point) = self.negative_point(a, b) {
            return Err(point);
        }
        let (mut square, mut rest) = (Poly::one(), Poly::constant(self.leading_coefficient()));
        if a.is_some() && a == b {
            // At one number the rest may be negative where the square is 0: -t^2 at 0.
            rest = self.clone();
        } else {
            for (factor, multiplicity) in self.square_free_factors() {
                square *= factor.pow((multiplicity / 2) as u32);
                if multiplicity.is_odd() {
                    rest *= factor;
                }
            }
        }
        Ok(by_parts(square, rest, a, b))
    }

    /// Why F > 0 on [a, b]: coefficients of F itself, of which none is negative and those at the ends of each interval are values of
    /// F, so positive. An end that is `None` is none.
    ///
    /// Cost: as [`Poly::positivity`].
    ///
    /// # Errors
    /// A number in [a, b] at which F is negative, or else a root there.
    ///
    /// ```
    /// # use polarform::{number::{integer, rational}, poly::Poly};
    /// let t = Poly::variable();
    /// let shown = (t.pow(2) - &t + Poly::one()).strict_positivity(Some(&integer(0)), None).unwrap();
    /// assert!(shown.root_of_square.degree() == Some(0));
    /// let touched = (&t - Poly::one()).pow(2).strict_positivity(None, None).unwrap_err();
    /// assert_eq!(touched.to_string(), "1");
    /// ```
    pub fn strict_positivity(
        &self,
        a: Option<&Rational>,
        b: Option<&Rational>,
    ) -> Result<Positivity, RealRoot> {
        if let Some(point) = self.negative_point(a, b) {
            return Err(RealRoot::Rational(point));
        }
        match self.real_roots(a, b) {
            // Every number is a root of 0.
            None => {
                let point = a.or(b).cloned().unwrap_or_else(Rational::zero);
                Err(RealRoot::Rational(point))
            }
            Some(roots) => match roots.into_iter().next() {
                Some((root, _)) => Err(root),
                None => Ok(by_parts(Poly::one(), self.clone(), a, b)),
            },
        }
    }

    /// The Bernstein coefficients over an interval [a, b] for the degree n: F = Σ b_i B_i^n with b_i = Σ_k C(i, k)/C(n, k) c_k for
    /// F(a + (b − a) s) = Σ c_k s^k; none for 0. Cost: a composition and n²/2 additions.
    ///
    /// ```
    /// # use polarform::{interval::Interval, number::integer, poly::Poly};
    /// let f = Poly::variable().pow(2);
    /// let interval = Interval::new(integer(0), integer(2))?;
    /// assert_eq!(f.bernstein_coefficients(&interval), [integer(0), integer(0), integer(4)]);
    /// # Ok::<(), polarform::interval::EmptyInterval>(())
    /// ```
    pub fn bernstein_coefficients(&self, interval: &Interval<Rational>) -> Vec<Rational> {
        let (a, b) = interval.ends();
        let Some(n) = self.degree() else { return Vec::new() };
        let local = self.compose(&Poly::from_coefficients(vec![a.clone(), b - a]));
        let share = |k: usize| local.coefficient(k) / Rational::from_integer(binomial(n, k));
        let mut list: Vec<Rational> = (0..=n).map(share).collect();
        for start in 1..=n {
            budget::steps(1 + (n / 32) as u32);
            for i in (start..=n).rev() {
                let lower = list[i - 1].clone();
                list[i] += lower;
            }
        }
        list
    }
}

/// Intervals and tails on which no coefficient of the rest is negative.
fn by_parts(square: Poly, rest: Poly, a: Option<&Rational>, b: Option<&Rational>) -> Positivity {
    let above = b.is_none().then(|| beyond(&rest, a.cloned().unwrap_or_else(Rational::zero)));
    // G(−x) is beyond −c what G is below c.
    let below = a.is_none().then(|| {
        let start = b.map_or_else(Rational::zero, |b| -b);
        let (c, tail) = beyond(&rest.compose(&-Poly::variable()), start);
        (-c, tail)
    });
    let lower = below.as_ref().map(|(c, _)| c).or(a);
    let upper = above.as_ref().map(|(c, _)| c).or(b);
    let parts = match (lower, upper) {
        // Tails that meet leave nothing between them.
        (Some(lower), Some(upper)) if lower != upper || above.is_none() && below.is_none() => {
            nonnegative_parts(&rest, lower, upper)
        }
        _ => Vec::new(),
    };
    Positivity { root_of_square: square, rest, below, parts, above }
}

/// c ≥ start and G(c + x) without negative coefficients, for a G with a positive value far out.
fn beyond(g: &Poly, start: Rational) -> (Rational, Poly) {
    let mut step = Rational::zero();
    loop {
        budget::step();
        let c = &start + &step;
        let tail = g.shift(&c);
        if !tail.numerators().iter().any(Signed::is_negative) {
            return (c, tail);
        }
        step = if step.is_zero() { Rational::one() } else { step * integer(2) };
    }
}

/// Intervals from a to b over which no Bernstein coefficient is negative.
fn nonnegative_parts(g: &Poly, a: &Rational, b: &Rational) -> Vec<(Rational, Rational, Vec<Rational>)> {
    let mut found = Vec::new();
    if g.is_zero() || a > b {
        return found;
    }
    if a == b {
        return vec![(a.clone(), b.clone(), vec![g.value(a)])];
    }
    let mut open = vec![(a.clone(), b.clone(), bernstein::over(g.numerators(), a, b))];
    while let Some((lower, upper, list)) = open.pop() {
        budget::steps(1 + (list.len() * list.len() / 64) as u32);
        if list.iter().any(Signed::is_negative) {
            let middle = (&lower + &upper) / integer(2);
            let (left, right) = bernstein::halves(&list);
            open.push((middle.clone(), upper, right));
            open.push((lower, middle, left));
        } else {
            budget::charge_terms(list.len() as u64);
            let interval = Interval::new(lower.clone(), upper.clone()).expect("the parts have a width");
            let list = g.bernstein_coefficients(&interval);
            found.push((lower, upper, list));
        }
    }
    found
}

/// A short rational number between two different ones in order; `None` is beyond all.
fn between(lower: Option<&RealRoot>, upper: Option<&RealRoot>) -> Rational {
    // Ends of isolating intervals, moved until there is room between them.
    let (mut l, mut u) = (lower.cloned(), upper.cloned());
    loop {
        let low = l.as_ref().map(|root| match root {
            RealRoot::Rational(q) => q.clone(),
            RealRoot::Irrational(number) => number.ends().1,
        });
        let high = u.as_ref().map(|root| match root {
            RealRoot::Rational(q) => q.clone(),
            RealRoot::Irrational(number) => number.ends().0,
        });
        let irrational = |root: &Option<RealRoot>| matches!(root, Some(RealRoot::Irrational(_)));
        let (closed_low, closed_high) = (irrational(&l), irrational(&u));
        match (low, high) {
            (None, None) => return Rational::zero(),
            (Some(low), None) => return low.floor() + integer(1),
            (None, Some(high)) => return high.ceil() - integer(1),
            (Some(low), Some(high)) => {
                if low < high {
                    return simplest(&low, &high);
                }
                // The shared end of two intervals is no root.
                if low == high && closed_low && closed_high {
                    return low;
                }
            }
        }
        for end in [&mut l, &mut u] {
            if let Some(RealRoot::Irrational(number)) = end {
                let (a, b) = number.ends();
                *end = Some(RealRoot::Irrational(number.refined(&((b - a) / integer(2)))));
            }
        }
    }
}

/// The number with the least denominator in the open interval, by continued fractions.
fn simplest(low: &Rational, high: &Rational) -> Rational {
    if low.is_negative() && high.is_positive() {
        return Rational::zero();
    }
    if !high.is_positive() {
        return -simplest(&-high, &-low);
    }
    let whole = low.floor();
    let next = &whole + integer(1);
    if next < *high {
        return next;
    }
    // Both lie in [whole, whole + 1]: 1/x for x − whole.
    let (l, h) = (low - &whole, high - &whole);
    if l.is_zero() {
        return whole + Rational::new(Int::ONE, (h.recip().floor() + integer(1)).to_integer());
    }
    whole + simplest(&h.recip(), &l.recip()).recip()
}
