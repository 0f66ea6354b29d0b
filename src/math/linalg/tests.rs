use nalgebra::DMatrix;
use num_traits::{One, Zero};
use proptest::prelude::*;

use super::surd::Surd;
use super::*;
use crate::budget::{Limits, Stop};
use crate::math::number::{Int, integer, rational};

macro_rules! dmatrix {
    ($($($x:expr),+);+) => {{
        let rows = [$(vec![$($x),+]),+];
        DMatrix::from_row_iterator(rows.len(), rows[0].len(), rows.into_iter().flatten())
    }};
}

fn identity<F: Field>(n: usize) -> DMatrix<F> {
    DMatrix::identity(n, n)
}

/// Σ over permutations, by expansion along the first column.
fn leibniz<F: Field>(a: &DMatrix<F>) -> F {
    if a.nrows() == 0 {
        return F::one();
    }
    let mut sum = F::zero();
    for i in 0..a.nrows() {
        // not remove_row: that of nalgebra 0.35 drops the wrong entries, here a double free
        let size = a.nrows() - 1;
        let minor = DMatrix::from_fn(size, size, |k, j| a[(if k < i { k } else { k + 1 }, j + 1)].clone());
        let term = a[(i, 0)].times(&leibniz(&minor));
        if i % 2 == 0 { sum += term } else { sum -= term }
    }
    sum
}

/// What Gauss' elimination says, also for rational matrices.
fn plain<F: Field>(a: &DMatrix<F>) -> Reduced<F> {
    Reduced::General(elimination::Echelon::new(joined_rows(a, None), a.ncols()))
}

fn check_laws<F: Field>(a: &DMatrix<F>) {
    let (rows, columns) = a.shape();
    let form = reduced_row_echelon(a);
    let r = form.pivots.len();
    assert_eq!(rank(a), r);
    assert_eq!(rank(&a.transpose()), r);
    assert!(form.pivots.is_sorted_by(|x, y| x < y));
    for i in 0..rows {
        for j in 0..columns {
            let x = &form.matrix[(i, j)];
            if i >= r || j < form.pivots[i] {
                assert!(x.is_zero());
            } else if let Ok(k) = form.pivots.binary_search(&j) {
                assert_eq!(*x, if k == i { F::one() } else { F::zero() });
            }
        }
    }
    // The rows of the form span those of the matrix, and not more.
    let stacked = DMatrix::from_fn(2 * rows, columns, |i, j| {
        if i < rows { a[(i, j)].clone() } else { form.matrix[(i - rows, j)].clone() }
    });
    assert_eq!(rank(&stacked), r);
    let kernel = null_space(a);
    assert_eq!(kernel.shape(), (columns, columns - r));
    assert_eq!(multiply(a, &kernel), Ok(DMatrix::zeros(rows, columns - r)));
    assert_eq!(rank(&kernel), columns - r);

    let other = plain(a);
    assert_eq!(other.pivots(), form.pivots);
    for j in 0..columns {
        let x = other.coordinates(j);
        for (i, x) in x.iter().enumerate() {
            assert_eq!(*x, form.matrix[(i, j)]);
        }
    }
    if rows != columns {
        assert_eq!(determinant(a), Err(LinalgError::NotSquare { rows, columns }));
        assert_eq!(inverse(a), Err(LinalgError::NotSquare { rows, columns }));
        return;
    }
    let value = determinant(a).unwrap();
    assert_eq!(value, leibniz(a));
    assert_eq!(value, other.determinant());
    match inverse(a) {
        Ok(inverted) => {
            assert!(!value.is_zero());
            assert_eq!(multiply(a, &inverted), Ok(identity(rows)));
            assert_eq!(multiply(&inverted, a), Ok(identity(rows)));
        }
        Err(LinalgError::Singular { size, rank, column }) => {
            assert!(value.is_zero());
            assert_eq!((size, rank), (rows, r));
            assert!(!form.pivots.contains(&column));
            assert!((0..column).all(|j| form.pivots.contains(&j)));
        }
        Err(other) => panic!("{other}"),
    }
}

fn entry() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => Just(Rational::zero()),
        4 => (-3i64..=3).prop_map(integer),
        3 => (-9i64..=9, 1i64..=9).prop_map(|(p, q)| rational(p, q)),
        1 => (any::<i64>(), 1..=i64::MAX).prop_map(|(p, q)| rational(p, q)),
        1 => (any::<i64>(), 1u32..4).prop_map(|(p, e)| Rational::from_integer(Int::from(p).pow(e))),
    ]
}

fn matrix<T: nalgebra::Scalar>(
    rows: impl Strategy<Value = usize>,
    columns: impl Strategy<Value = usize>,
    entry: impl Strategy<Value = T> + Clone,
) -> impl Strategy<Value = DMatrix<T>> {
    (rows, columns).prop_flat_map(move |(rows, columns)| {
        proptest::collection::vec(entry.clone(), rows * columns)
            .prop_map(move |entries| DMatrix::from_vec(rows, columns, entries))
    })
}

fn rational_matrix() -> impl Strategy<Value = DMatrix<Rational>> {
    matrix(0usize..5, 0usize..5, entry().boxed())
}

fn surd_matrix() -> impl Strategy<Value = DMatrix<Surd>> {
    let some = || (-4i64..=4, 1i64..=3).prop_map(|(p, q)| rational(p, q));
    let small = || prop_oneof![2 => Just(Rational::zero()), 1 => some()];
    let entry = (small(), small()).prop_map(|(p, q)| Surd(p, q)).boxed();
    matrix(0usize..5, 0usize..5, entry)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn rational_laws(a in rational_matrix()) {
        check_laws(&a);
    }

    #[test]
    fn surd_laws(a in surd_matrix()) {
        check_laws(&a);
    }

    #[test]
    fn low_rank(a in matrix(4usize..5, 2usize..3, entry().boxed()),
                b in matrix(2usize..3, 4usize..5, entry().boxed())) {
        let product = multiply(&a, &b).unwrap();
        prop_assert_eq!(&product, &(&a * &b));
        prop_assert!(rank(&product) <= 2);
        check_laws(&product);
    }

    #[test]
    fn solutions_solve(a in matrix(3usize..4, 3usize..4, entry().boxed()),
                       b in matrix(3usize..4, 0usize..3, entry().boxed())) {
        if let Ok(x) = solve(&a, &b) {
            prop_assert_eq!(multiply(&a, &x), Ok(b));
        } else {
            prop_assert!(rank(&a) < 3);
        }
    }
}

#[test]
fn empty_matrices() {
    let none: DMatrix<Rational> = DMatrix::zeros(0, 0);
    assert_eq!(determinant(&none), Ok(Rational::one()));
    assert_eq!(inverse(&none), Ok(none.clone()));
    assert_eq!(rank(&none), 0);
    assert!(is_lower_triangular(&none));
    assert_eq!(solve(&none, &DMatrix::zeros(0, 3)), Ok(DMatrix::zeros(0, 3)));
    let wide: DMatrix<Rational> = DMatrix::zeros(0, 3);
    assert_eq!(null_space(&wide), identity(3));
    assert_eq!(reduced_row_echelon(&wide).matrix, wide);
    let tall: DMatrix<Rational> = DMatrix::zeros(3, 0);
    assert_eq!(multiply(&tall, &wide), Ok(DMatrix::zeros(3, 3)));
    assert_eq!(multiply(&wide, &tall), Ok(none));
}

#[test]
fn errors_say_what_is_wrong() {
    let a = dmatrix![integer(1), integer(2), integer(3); integer(4), integer(5), integer(6)];
    assert_eq!(inverse(&a).unwrap_err().to_string(), "the matrix is 2×3, it has to be square");
    assert_eq!(
        multiply(&a, &a).unwrap_err().to_string(),
        "the product A B is not defined: A is 2×3, B is 2×3"
    );
    let one = identity::<Rational>(2);
    let three = DMatrix::zeros(3, 1);
    assert_eq!(
        solve(&one, &three).unwrap_err().to_string(),
        "the system A X = B is not defined: A is 2×2, B is 3×1"
    );
    let dependent = dmatrix![integer(1), integer(2), integer(0);
                             integer(2), integer(4), integer(1);
                             integer(3), integer(6), integer(5)];
    assert_eq!(
        inverse(&dependent).unwrap_err().to_string(),
        "the 3×3 matrix is singular, its rank is 2: column 2 is a combination of the columns before it"
    );
    let zero: DMatrix<Rational> = DMatrix::zeros(1, 1);
    assert_eq!(
        inverse(&zero).unwrap_err().to_string(),
        "the 1×1 matrix is singular, its rank is 0: column 1 is zero"
    );
}

/// det (1/(i+j+1)) of size n is ∏_{k<n} k!^4 … in closed form c_n^4 / c_2n with c_n = ∏_{k<n} k!.
#[test]
fn determinant_of_hilberts_matrix() {
    let superfactorial = |n: usize| -> Int { (0..n).map(crate::math::number::factorial).product() };
    for n in 0..12 {
        let hilbert = DMatrix::from_fn(n, n, |i, j| rational(1, (i + j + 1) as i64));
        let expected = Rational::new(superfactorial(n).pow(4), superfactorial(2 * n));
        assert_eq!(determinant(&hilbert), Ok(expected));
        let inverted = inverse(&hilbert).unwrap();
        assert!(inverted.iter().all(|x| x.is_integer()));
    }
}

#[test]
fn huge_entries() {
    let big = Rational::from_integer(Int::from(10).pow(2000));
    let a = dmatrix![big.clone(), integer(1); integer(-1), big.recip()];
    assert_eq!(determinant(&a), Ok(integer(2)));
    assert_eq!(multiply(&a, &inverse(&a).unwrap()), Ok(identity(2)));
}

#[test]
fn exchanges_change_the_sign() {
    let a = dmatrix![integer(0), integer(1); integer(1), integer(0)];
    assert_eq!(determinant(&a), Ok(integer(-1)));
    assert_eq!(inverse(&a), Ok(a));
}

#[test]
fn limits_stop_elimination() {
    let a = DMatrix::from_fn(60, 60, |i, j| rational(1, (i * i + j + 1) as i64));
    let limits = Limits { time: Some(std::time::Duration::from_millis(1)), ..Limits::default() };
    assert!(matches!(crate::budget::run(&limits, || rank(&a)), Err(Stop::Time(_))));
    let limits = Limits { terms: 100, ..Limits::default() };
    assert!(matches!(crate::budget::run(&limits, || rank(&a)), Err(Stop::Terms { .. })));
}

/// What elimination says, whatever `solve` prefers.
fn by_elimination(a: &DMatrix<Rational>, b: &DMatrix<Rational>) -> DMatrix<Rational> {
    let reduced = Reduced::new(a, Some(b));
    let columns = (a.ncols()..a.ncols() + b.ncols()).flat_map(|column| reduced.coordinates(column));
    DMatrix::from_vec(a.ncols(), b.ncols(), columns.collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn faster_ways_agree_with_elimination(
        a in (1usize..13).prop_flat_map(|n| matrix(Just(n), Just(n), entry().boxed())), shape in 0..4, k in 0usize..4,
    ) {
        let n = a.nrows();
        let kept = |i: usize, j: usize| match shape { 0 => i >= j, 1 => i <= j, _ => true };
        let a = DMatrix::from_fn(n, n, |i, j| match (kept(i, j), i == j) {
            (false, _) => Rational::zero(),
            // mostly regular
            (true, true) if a[(i, j)].is_zero() && shape < 3 => integer(-2),
            (true, _) => a[(i, j)].clone(),
        });
        let b = DMatrix::from_fn(n, k, |i, j| a[(j % n, i)].plus(&rational(i as i64, j as i64 + 1)));
        match solve(&a, &b) {
            Ok(x) => {
                prop_assert_eq!(multiply(&a, &x), Ok(b.clone()));
                prop_assert_eq!(x, by_elimination(&a, &b));
                prop_assert_eq!(rank(&a), n);
            }
            Err(error) => {
                prop_assert_eq!(rank(&a), match error { LinalgError::Singular { rank, .. } => rank, _ => n });
                prop_assert!(rank(&a) < n);
            }
        }
    }
}

/// Entries of one word, of many words, and a determinant that the prime of the lifting divides.
#[test]
fn large_systems() {
    let prime = crate::math::number::primes().next().unwrap().p;
    for (n, size) in [(20usize, 1u32), (12, 9)] {
        let entry = |i: usize, j: usize| {
            let x = (7 * i * i + 13 * j * j * j + 5 * i * j + 1) % 199;
            integer(x as i64 - 99).powered(size)
        };
        let a = DMatrix::from_fn(n, n, entry);
        let b = DMatrix::from_fn(n, 2, |i, j| rational(i as i64 - 5, j as i64 + 3));
        assert_eq!(solve(&a, &b).unwrap(), by_elimination(&a, &b));
        let scaled = DMatrix::from_fn(n, n, |i, j| {
            if i == 0 { &a[(i, j)] + Rational::from_integer(Int::from(prime)) } else { a[(i, j)].clone() }
        });
        let first = DMatrix::from_fn(n, n, |i, j| {
            if i == 0 { scaled[(0, j)].clone() - &a[(0, j)] } else { a[(i, j)].clone() }
        });
        assert_eq!(solve(&scaled, &b).unwrap(), by_elimination(&scaled, &b));
        match solve(&first, &b) {
            Ok(x) => assert_eq!(x, by_elimination(&first, &b)),
            Err(error) => assert!(matches!(error, LinalgError::Singular { .. })),
        }
    }
    let singular = DMatrix::from_fn(11, 11, |i, j| integer((i + j) as i64));
    assert_eq!(inverse(&singular), Err(LinalgError::Singular { size: 11, rank: 2, column: 2 }));
}

proptest! {
    #[test]
    fn all_solutions(rows in 0usize..4, columns in 1usize..4, entries in prop::collection::vec(-2i64..3, 16), x in prop::collection::vec(-3i64..4, 4)) {
        let a = DMatrix::from_fn(rows, columns, |i, j| integer(entries[4 * i + j]));
        let free: Vec<Rational> = x.iter().map(|&x| integer(x)).collect();
        let value = |found: &Solutions<Rational>| {
            let mut at = vec![Rational::zero(); columns];
            for (&c, x) in found.free.iter().zip(&free) {
                at[c] = x.clone();
            }
            for (k, &p) in found.determined.iter().enumerate() {
                let more = (0..found.free.len()).map(|c| &found.coefficients[(k, c)] * &free[c]);
                at[p] = found.constants.as_ref().unwrap()[k].clone() + more.sum::<Rational>();
            }
            at
        };
        let times = |x: &[Rational]| -> Vec<Rational> {
            (0..rows).map(|i| (0..columns).map(|j| &a[(i, j)] * &x[j]).sum()).collect()
        };
        // Of a right side that some x gives, every choice of the free ones is a solution, and x is among them.
        let b = times(&free[..columns]);
        let found = solutions(&a, &b).unwrap();
        prop_assert_eq!(found.determined.len(), rank(&a));
        prop_assert!(!found.minor.is_zero());
        prop_assert_eq!(times(&value(&found)), b.clone());
        // Any right side: solvable just if the rank stays.
        let b: Vec<Rational> = (0..rows).map(|i| integer(entries[4 * i + 3])).collect();
        let found = solutions(&a, &b).unwrap();
        let wide = DMatrix::from_fn(rows, columns + 1, |i, j| if j < columns { a[(i, j)].clone() } else { b[i].clone() });
        prop_assert_eq!(found.constants.is_some(), rank(&wide) == rank(&a));
        if found.constants.is_some() {
            prop_assert_eq!(times(&value(&found)), b);
        }
    }
}
