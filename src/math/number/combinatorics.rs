//! Factorials, binomial and multinomial coefficients, and subsets in order.

use super::Int;

/// n! Cost: n products, each by one word.
///
/// ```
/// assert_eq!(polarform::number::factorial(5).to_string(), "120");
/// ```
pub fn factorial(n: usize) -> Int {
    (2..=n).map(Int::from).product()
}

/// C(n, k), the number of k-subsets of n things; 0 when k > n. Cost: O(min(k, n−k)) word products.
///
/// ```
/// use polarform::number::binomial;
/// assert_eq!(binomial(5, 2).to_string(), "10");
/// assert_eq!(binomial(2, 5).to_string(), "0");
/// ```
pub fn binomial(n: usize, k: usize) -> Int {
    if k > n {
        return Int::ZERO;
    }
    half_row(n).nth(k.min(n - k)).expect("a place in the first half")
}

/// Row n of Pascal's triangle: C(n, 0), …, C(n, n). Cost: n word products and divisions.
///
/// ```
/// use polarform::number::binomial_row;
/// let row: Vec<String> = binomial_row(4).iter().map(|c| c.to_string()).collect();
/// assert_eq!(row, ["1", "4", "6", "4", "1"]);
/// ```
pub fn binomial_row(n: usize) -> Vec<Int> {
    let mut row: Vec<Int> = Vec::with_capacity(n + 1);
    row.extend(half_row(n));
    for k in row.len()..=n {
        row.push(row[n - k].clone());
    }
    row
}

/// (i, C(n, i)) for the i in 0..=n that are asked for, from both ends of the row inward, one after
/// the other. A whole row has about 0.7 n² bits: who needs a few entries takes these only.
///
/// Cost: a word product and a division for each place from the nearer end to the innermost one
/// asked for.
///
/// ```
/// use polarform::number::binomials_where;
/// let ends: Vec<(usize, String)> =
///     binomials_where(1_000_000, |i| i % 999_999 < 2).map(|(i, c)| (i, c.to_string())).collect();
/// let expected = [(0, "1"), (1_000_000, "1"), (1, "1000000"), (999_999, "1000000")];
/// assert_eq!(ends, expected.map(|(i, c)| (i, c.to_owned())));
/// ```
pub fn binomials_where(n: usize, asked: impl Fn(usize) -> bool) -> impl Iterator<Item = (usize, Int)> {
    let places = (0..=n / 2).rev().find(|&i| asked(i) || asked(n - i)).map_or(0, |i| i + 1);
    half_row(n).take(places).enumerate().flat_map(move |(k, c)| {
        let mirrored = (k != n - k && asked(n - k)).then(|| (n - k, c.clone()));
        asked(k).then_some((k, c)).into_iter().chain(mirrored)
    })
}

/// C(n, 0), …, C(n, ⌊n/2⌋), one after the other. Limits on time stop it.
fn half_row(n: usize) -> impl Iterator<Item = Int> {
    let mut c = Int::ONE;
    (0..=n / 2).map(move |k| {
        if k > 0 {
            // Numbers of 4096 bits take about a microsecond.
            crate::budget::steps((c.bits() >> 12) as u32);
            c *= Int::from(n + 1 - k);
            c = c.div_exact(&Int::from(k));
        }
        c.clone()
    })
}

/// (a_1 + … + a_m)! / (a_1! … a_m!), the number of ways to order a multiset.
///
/// ```
/// use polarform::number::multinomial;
/// assert_eq!(multinomial(&[2, 1, 1]).to_string(), "12");
/// ```
pub fn multinomial(parts: &[usize]) -> Int {
    let mut total = 0;
    let mut product = Int::ONE;
    for &part in parts {
        total += part;
        product *= binomial(total, part);
    }
    product
}

/// The k-subsets of 0..n in lexicographic order, as increasing index lists.
///
/// ```
/// use polarform::number::Combinations;
/// let all: Vec<Vec<usize>> = Combinations::new(3, 2).collect();
/// assert_eq!(all, [vec![0, 1], vec![0, 2], vec![1, 2]]);
/// ```
#[derive(Clone, Debug)]
pub struct Combinations {
    n: usize,
    next: Option<Vec<usize>>,
}

impl Combinations {
    /// All k-subsets of 0..n; none when k > n, one (the empty one) when k = 0.
    pub fn new(n: usize, k: usize) -> Self {
        Combinations { n, next: (k <= n).then(|| (0..k).collect()) }
    }
}

impl Iterator for Combinations {
    type Item = Vec<usize>;
    fn next(&mut self) -> Option<Vec<usize>> {
        let current = self.next.take()?;
        let k = current.len();
        if let Some(i) = (0..k).rev().find(|&i| current[i] < self.n - k + i) {
            let mut following = current.clone();
            following[i] += 1;
            for j in i + 1..k {
                following[j] = following[j - 1] + 1;
            }
            self.next = Some(following);
        }
        Some(current)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_match_single_binomials_and_pascal() {
        for n in 0..80 {
            let row = binomial_row(n);
            assert_eq!(row.len(), n + 1);
            for (k, c) in row.iter().enumerate() {
                assert_eq!(*c, binomial(n, k));
                if n > 0 && k > 0 {
                    assert_eq!(*c, binomial(n - 1, k - 1) + binomial(n - 1, k));
                }
            }
        }
    }

    #[test]
    fn entries_asked_for_are_those_of_the_row() {
        for n in 0..30 {
            let row = binomial_row(n);
            for seed in 0..40 {
                let asked = |i: usize| (seed * (i + 3) * (i + 3) + i) % 7 < seed % 8;
                let mut entries: Vec<(usize, Int)> = binomials_where(n, asked).collect();
                entries.sort_unstable();
                let expected = row.iter().cloned().enumerate().filter(|(i, _)| asked(*i));
                assert_eq!(entries, expected.collect::<Vec<_>>(), "n = {n}, seed {seed}");
            }
        }
    }

    #[test]
    fn time_stops_a_row() {
        use crate::budget::{Limits, Stop, run};
        let limits = Limits { steps: Some(1000), ..Limits::default() };
        // C(10^6, 1000) has more than ten thousand bits, so the middle is far.
        assert_eq!(
            run(&limits, || binomials_where(1_000_000, |i| i == 500_000).count()),
            Err(Stop::Steps(1000))
        );
        assert_eq!(run(&limits, || binomials_where(1_000_000, |i| i == 1_000_000).count()), Ok(1));
    }

    #[test]
    fn combinations_count_like_binomials() {
        for n in 0..8 {
            for k in 0..10 {
                let all: Vec<_> = Combinations::new(n, k).collect();
                assert_eq!(Int::from(all.len()), binomial(n, k));
                assert!(all.windows(2).all(|w| w[0] < w[1]));
            }
        }
    }
}
