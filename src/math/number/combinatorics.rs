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
    let k = k.min(n - k);
    let mut c = Int::ONE;
    for i in 0..k {
        c *= Int::from(n - i);
        c = c.div_exact(&Int::from(i + 1));
    }
    c
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
    let mut c = Int::ONE;
    for k in 0..=n {
        if k > n / 2 {
            let mirrored = row[n - k].clone();
            row.push(mirrored);
            continue;
        }
        row.push(c.clone());
        c *= Int::from(n - k);
        c = c.div_exact(&Int::from(k + 1));
    }
    row
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
