//! The modules against each other and against the plainest formulas.

use nalgebra::DMatrix;
use num_traits::{One, Zero};
use polarform::basis::{Basis, bernstein_to_power, change_of_basis, evaluate_basis, power_to_bernstein};
use polarform::blossom::laws::{ArgumentNames, Report, Slip, check};
use polarform::blossom::{
    Argument, Method, PolarForm, PreparedForm, TensorPolarForm, TotalDegreePolarForm, expand_univariate,
    symmetrize,
};
use polarform::interval::Interval;
use polarform::linalg::multiply;
use polarform::number::{Rational, integer, rational};
use polarform::poly::{MultiPoly, Poly, Symbol};
use polarform::ring::Ring;
use proptest::prelude::*;

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { cases: count, failure_persistence: None, ..ProptestConfig::default() }
}

/// Small fractions, often 0 or repeated, now and then huge.
fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        3 => Just(Rational::zero()),
        1 => Just(Rational::one()),
        8 => (-9i64..10, 1i64..6).prop_map(|(p, q)| rational(p, q)),
        1 => (any::<i64>(), 1..i64::MAX).prop_map(|(p, q)| {
            let q = rational(p, q);
            &q * &q * &q
        }),
    ]
}

fn numbers(count: impl Into<prop::collection::SizeRange>) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(number(), count)
}

/// A polynomial of degree at most n (0 to `most`) and n arguments.
fn form_and_arguments(most: usize) -> impl Strategy<Value = (Vec<Rational>, Vec<Rational>)> {
    (0..=most).prop_flat_map(|n| (numbers(n + 1), numbers(n)))
}

/// All orders of 0, …, n − 1 (Heap's algorithm).
fn permutations(n: usize) -> Vec<Vec<usize>> {
    fn go(k: usize, order: &mut Vec<usize>, all: &mut Vec<Vec<usize>>) {
        if k <= 1 {
            all.push(order.clone());
            return;
        }
        for i in 0..k {
            go(k - 1, order, all);
            order.swap(if k.is_multiple_of(2) { i } else { 0 }, k - 1);
        }
    }
    let mut all = Vec::new();
    go(n, &mut (0..n).collect(), &mut all);
    all
}

fn mean(values: Vec<Rational>) -> Rational {
    let count = integer(values.len() as i64);
    values.into_iter().fold(Rational::zero(), |sum, v| sum + v) / count
}

/// The mean over all n! permutations of c_0 + c_1 t_1 + c_2 t_1 t_2 + … + c_n t_1 … t_n.
fn by_permutations(c: &[Rational], t: &[Rational]) -> Rational {
    let value = |order: &Vec<usize>| {
        let mut product = Rational::one();
        let mut sum = c[0].clone();
        for (k, &i) in order.iter().enumerate() {
            product *= &t[i];
            sum += &c[k + 1] * &product;
        }
        sum
    };
    mean(permutations(t.len()).iter().map(value).collect())
}

/// The polar value by the recursion b_i := (b−u)/(b−a) b_i + (u−a)/(b−a) b_{i+1}, with its own
/// u in each round (de Casteljau's algorithm when all are equal).
fn de_casteljau(mut points: Vec<Rational>, a: &Rational, b: &Rational, arguments: &[Rational]) -> Rational {
    for u in arguments {
        let s = (u - a) / (b - a);
        points = points.windows(2).map(|w| (Rational::one() - &s) * &w[0] + &s * &w[1]).collect();
    }
    points.swap_remove(0)
}

fn horner(c: &[Rational], x: &Rational) -> Rational {
    c.iter().rev().fold(Rational::zero(), |sum, c| sum * x + c)
}

fn times(matrix: &DMatrix<Rational>, list: &[Rational]) -> Vec<Rational> {
    let column = DMatrix::from_column_slice(list.len(), 1, list);
    multiply(matrix, &column).expect("the sizes fit").iter().cloned().collect()
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn values_by_permutations((c, t) in form_and_arguments(5)) {
        let form = PolarForm::new(c.clone());
        let right = by_permutations(&c, &t);
        prop_assert_eq!(form.value(&t).unwrap(), right.clone());
        prop_assert_eq!(PreparedForm::new(&form).value(&t).unwrap(), right.clone());
        for method in Method::ALL {
            let derived = form.derive(method, &rational(2, 7)).form;
            prop_assert_eq!(derived.value(&t).unwrap(), right.clone(), "{}", method);
        }
    }

    #[test]
    fn written_out_and_put_in((c, t) in form_and_arguments(6)) {
        let form = PolarForm::new(c);
        let arrangement = ArgumentNames::univariate(&Symbol::new("t"), t.len());
        let written = expand_univariate(&form, &arrangement);
        let at = |symbol: &Symbol| {
            (1..=t.len()).find(|&i| *symbol == Symbol::indexed("t", i as i64)).map(|i| t[i - 1].clone())
        };
        prop_assert_eq!(written.value(&at).as_constant(), Some(form.value(&t).unwrap()));
        prop_assert!(check(&written, &written, &arrangement).holds());
    }

    #[test]
    fn matrix_blossom_and_de_casteljau((c, t) in form_and_arguments(7), a in number(), b in number(), x in number()) {
        let n = t.len();
        let form = PolarForm::new(c.clone());
        // Over [0, 1]: by the matrix, by the polar form, and back.
        let points = times(&power_to_bernstein(n), &c);
        prop_assert_eq!(&points, &form.bezier_points(&Interval::unit()));
        prop_assert_eq!(&times(&bernstein_to_power(n), &points), &c);
        prop_assert_eq!(de_casteljau(points, &integer(0), &integer(1), &t), form.value(&t).unwrap());
        prop_assume!(a != b);
        // Over [a, b], reversed intervals included.
        let points = form.bezier_points(&Interval::new(a.clone(), b.clone()).unwrap());
        let to = Basis::Bernstein(Interval::new(a.clone(), b.clone()).unwrap());
        let matrix = change_of_basis(n, &Basis::Power, &to).unwrap();
        prop_assert_eq!(&times(&matrix, &c), &points);
        prop_assert_eq!(de_casteljau(points.clone(), &a, &b, &vec![x.clone(); n]), horner(&c, &x));
        prop_assert_eq!(de_casteljau(points.clone(), &a, &b, &t), form.value(&t).unwrap());
        let values = evaluate_basis(n, &to, &x).unwrap();
        let sum = values.iter().zip(&points).fold(Rational::zero(), |sum, (v, p)| sum + v * p);
        prop_assert_eq!(sum, horner(&c, &x));
        prop_assert_eq!(PolarForm::from_bezier_points_over(&points, &Interval::new(a.clone(), b.clone()).unwrap()).unwrap(), form);
    }

    #[test]
    fn derivatives_are_differences((c, t) in form_and_arguments(6), x in number(), h in number()) {
        let n = t.len();
        prop_assume!(n > 0);
        let form = PolarForm::new(c.clone());
        let mut right = vec![x.clone(); n];
        let left = right.clone();
        right[n - 1] = &x + &Rational::one();
        let difference = form.value(&right).unwrap() - form.value(&left).unwrap();
        let slope = Poly::from_coefficients(c).derivative().value(&x);
        prop_assert_eq!(difference * integer(n as i64), slope.clone());
        // A vector argument is a difference of points, wherever the points are.
        let mut arguments: Vec<Argument<Rational>> = t[1..].iter().cloned().map(Argument::Point).collect();
        arguments.push(Argument::Vector(h.clone()));
        let (mut p, mut q) = (t[1..].to_vec(), t[1..].to_vec());
        p.push(&x + &h);
        q.push(x);
        prop_assert_eq!(form.value(&arguments).unwrap(), form.value(&p).unwrap() - form.value(&q).unwrap());
        prop_assert_eq!(form.nth_derivative(1).value(&t[1..]).unwrap(), {
            let unit: Vec<_> =
                t[1..].iter().cloned().map(Argument::Point).chain([Argument::Vector(integer(1))]).collect();
            form.value(&unit).unwrap() * integer(n as i64)
        });
    }

    #[test]
    fn repeated_knots((c, t) in form_and_arguments(6), order in any::<prop::sample::Index>()) {
        // Any order and any repetition: f(s, …, s, t, …, t) against de Casteljau rounds.
        let n = t.len();
        let k = order.index(n + 1);
        let (s, u) = (rational(1, 2), rational(-3, 4));
        let mut arguments = vec![s; k];
        arguments.resize(n, u);
        let form = PolarForm::new(c);
        let value = form.value(&arguments).unwrap();
        arguments.reverse();
        prop_assert_eq!(form.value(&arguments).unwrap(), value.clone());
        let points = form.bezier_points(&Interval::unit());
        prop_assert_eq!(de_casteljau(points, &integer(0), &integer(1), &arguments), value);
    }
}

/// The factors of f(t_1..t_m) g(t_{m+1}..t_{m+n}), symmetrised by writing everything out.
fn product_written_out(f: &PolarForm<Rational>, g: &PolarForm<Rational>) -> MultiPoly {
    let (m, n) = (f.degree(), g.degree());
    let t = Symbol::new("t");
    let arguments = |from: usize, to: usize| {
        ArgumentNames::new(vec![(from..=to).map(|i| vec![t.numbered(i as i64)]).collect()])
    };
    let left = expand_univariate(f, &arguments(1, m));
    let right = expand_univariate(g, &arguments(m + 1, m + n));
    symmetrize(&(left * right), &arguments(1, m + n))
}

proptest! {
    #![proptest_config(cases(20))]

    #[test]
    fn products_by_writing_out(c in numbers(1..4usize), d in numbers(1..5usize)) {
        let (f, g) = (PolarForm::new(c.clone()), PolarForm::new(d.clone()));
        let compact = f.product(&g);
        prop_assert_eq!(&f.product_by_symmetrizing(&g), &compact);
        let x = rational(-5, 7);
        prop_assert_eq!(horner(&compact.diagonal(), &x), horner(&c, &x) * horner(&d, &x));
        let arrangement = ArgumentNames::univariate(&Symbol::new("t"), compact.degree());
        prop_assert_eq!(product_written_out(&f, &g), expand_univariate(&compact, &arrangement));
    }

    #[test]
    fn compositions_by_writing_out(c in numbers(1..4usize), d in numbers(1..4usize)) {
        let (f, g) = (PolarForm::new(c.clone()), PolarForm::new(d.clone()));
        let (m, n) = (f.degree(), g.degree());
        let compact = f.compose(&g);
        prop_assert_eq!(&f.compose_by_symmetrizing(&g), &compact);
        // g with distinct arguments put into f, then all mn arguments symmetrised.
        let t = Symbol::new("t");
        let inner: Vec<(Symbol, MultiPoly)> = (0..m)
            .map(|k| {
                let list = (1..=n).map(|i| vec![t.numbered((k * n + i) as i64)]).collect();
                (Symbol::indexed("x", k as i64 + 1), expand_univariate(&g, &ArgumentNames::new(vec![list])))
            })
            .collect();
        let outer = expand_univariate(&f, &ArgumentNames::univariate(&Symbol::new("x"), m));
        let arrangement = ArgumentNames::univariate(&t, m * n);
        let written = symmetrize(&outer.substitute(&inner), &arrangement);
        prop_assert_eq!(written, expand_univariate(&compact, &arrangement));
    }

    #[test]
    fn sums_and_elevations((c, t) in form_and_arguments(5), d in numbers(1..4usize)) {
        let (f, g) = (PolarForm::new(c), PolarForm::new(d));
        let n = f.degree().max(g.degree());
        let sum = f.sum(&g);
        prop_assert_eq!(sum.degree(), n);
        let elevated = |p: &PolarForm<Rational>| p.elevate(n - p.degree());
        let arguments = [t.as_slice(), &vec![rational(5, 3); n - t.len()]].concat();
        let at = |p: &PolarForm<Rational>| p.value(&arguments).unwrap();
        prop_assert_eq!(at(&sum), at(&elevated(&f)) + at(&elevated(&g)));
        // Elevation is the mean over all ways to leave out one argument.
        let more = [t.as_slice(), &[rational(-2, 3)]].concat();
        let left_out = (0..more.len()).map(|k| {
            let mut rest = more.clone();
            rest.remove(k);
            f.value(&rest).unwrap()
        });
        prop_assert_eq!(f.elevate(1).value(&more).unwrap(), mean(left_out.collect()));
        prop_assert_eq!(f.elevate(3).reduce(3).unwrap(), f);
    }

    #[test]
    fn tensor_and_total_degree_forms(grid in prop::collection::vec(numbers(3), 3), u in numbers(2), v in numbers(2)) {
        // Σ c_ij u^i v^j of degrees (2, 2): the mean over the four ways to pair orders.
        let tensor = TensorPolarForm::new(grid.clone()).unwrap();
        let half = |row: &[Rational]| by_permutations(row, &v);
        let column: Vec<Rational> = grid.iter().map(|row| half(row)).collect();
        prop_assert_eq!(tensor.value(&u, &v).unwrap(), by_permutations(&column, &u));
        // Total degree 2 keeps i + j <= 2: hand the factors out in both orders.
        let terms = (0..3u32).flat_map(|i| (0..3 - i).map(move |j| (i, j)));
        let total = TotalDegreePolarForm::new(
            2, 2, terms.clone().map(|(i, j)| ([i, j].into_iter().collect(), grid[i as usize][j as usize].clone())),
        ).unwrap();
        let value = |p: usize, q: usize| {
            let c = &grid;
            &c[0][0] + &c[1][0] * &u[p] + &c[0][1] * &v[p]
                + &c[2][0] * &u[p] * &u[q] + &c[0][2] * &v[p] * &v[q] + &c[1][1] * &u[p] * &v[q]
        };
        let points = [vec![u[0].clone(), v[0].clone()], vec![u[1].clone(), v[1].clone()]];
        prop_assert_eq!(total.value(&points).unwrap(), mean(vec![value(0, 1), value(1, 0)]));
    }
}

/// The form over [0, …] as a polynomial in t_1, …, t_n with coefficients c_0, …, c_n times numbers.
fn symbolic(numbers: &[Rational]) -> (MultiPoly, ArgumentNames) {
    let n = numbers.len() - 1;
    let c = |k: usize| MultiPoly::symbol(Symbol::indexed("c", k as i64)).scaled(&numbers[k]);
    let form = PolarForm::new((0..=n).map(c).collect());
    let arrangement = ArgumentNames::univariate(&Symbol::new("t"), n);
    (expand_univariate(&form, &arrangement), arrangement)
}

fn numeric(numbers: &[Rational]) -> (MultiPoly, ArgumentNames) {
    let arrangement = ArgumentNames::univariate(&Symbol::new("t"), numbers.len() - 1);
    (expand_univariate(&PolarForm::new(numbers.to_vec()), &arrangement), arrangement)
}

/// e_k of t_1, …, t_n.
fn esym(n: usize, k: usize) -> MultiPoly {
    let mut c = vec![Rational::zero(); n + 1];
    c[k] = Rational::from_integer(polarform::number::binomial(n, k));
    numeric(&c).0
}

fn assert_found(report: &Report) {
    assert!(!report.holds());
    assert!(!report.describe().is_empty());
}

proptest! {
    #![proptest_config(cases(24))]

    /// Slips planted in a right form are found and named.
    #[test]
    fn planted_slips(
        numbers in prop::collection::vec((1i64..9, 1i64..5).prop_map(|(p, q)| rational(p, q)), 4..6usize),
        place in any::<prop::sample::Index>(),
        k in 1i64..5,
    ) {
        let n = numbers.len() - 1;
        let (right, arrangement) = numeric(&numbers);
        // A class with more than one monomial: 1, …, n − 1.
        let i = 1 + place.index(n - 1);
        let class = esym(n, i).scaled(&(&numbers[i] / Rational::from_integer(polarform::number::binomial(n, i))));
        let planted = |claim: MultiPoly| check(&claim, &right, &arrangement);

        let report = planted(right.plus(&MultiPoly::constant(integer(k))));
        assert_found(&report);
        prop_assert_eq!(&report.slips, &[Slip::Constant {
            claimed: MultiPoly::constant(&numbers[0] + integer(k)),
            right: MultiPoly::constant(numbers[0].clone()),
        }]);
        prop_assert_eq!(report.diagonal, Some(MultiPoly::constant(integer(k))));

        let report = planted(right.minus(&class));
        assert_found(&report);
        prop_assert!(matches!(report.slips.as_slice(), [Slip::Missing { .. }]), "{:?}", report.slips);

        let report = planted(right.minus(&class.scaled(&integer(2))));
        assert_found(&report);
        prop_assert!(matches!(report.slips.as_slice(), [Slip::Sign { .. }]), "{:?}", report.slips);

        // The mean over `count + k` products instead of `count`.
        let count = Rational::from_integer(polarform::number::binomial(n, i));
        let wrong = &count + integer(k);
        let report = planted(right.minus(&class).plus(&class.scaled(&(&count / &wrong))));
        assert_found(&report);
        match report.slips.as_slice() {
            [Slip::WrongCount { used, count: counted, .. }] => {
                prop_assert_eq!(used, &wrong);
                prop_assert_eq!(counted, &count);
            }
            other => prop_assert!(false, "{:?}", other),
        }

        // A factor forgotten everywhere.
        let report = planted(right.scaled(&integer(k + 1)));
        assert_found(&report);
        prop_assert_eq!(report.slips, [Slip::Factor(rational(1, k + 1))]);

        // One monomial alone breaks the symmetry, a square the affinity.
        let t = |j| MultiPoly::symbol(Symbol::indexed("t", j));
        let report = planted(right.plus(&t(1)));
        prop_assert!(report.asymmetry.is_some() && report.not_affine.is_none());
        let report = planted(right.plus(&(t(1) * t(1))).minus(&(t(1) * t(2))));
        prop_assert_eq!(report.not_affine.as_ref().map(|f| f.degree), Some(2));
        prop_assert!(report.diagonal.is_none() && report.asymmetry.is_some());
    }

    /// A coefficient written for its neighbour is named.
    #[test]
    fn planted_siblings(
        numbers in prop::collection::vec((1i64..9, 1i64..5).prop_map(|(p, q)| rational(p, q)), 3..6usize),
        place in any::<prop::sample::Index>(),
    ) {
        let n = numbers.len() - 1;
        let (right, arrangement) = symbolic(&numbers);
        let i = place.index(n);
        let (meant, written) = (Symbol::indexed("c", i as i64), Symbol::indexed("c", i as i64 + 1));
        let claim = right.substitute(&[(meant.clone(), MultiPoly::symbol(written.clone()))]);
        let report = check(&claim, &right, &arrangement);
        assert_found(&report);
        prop_assert_eq!(report.slips, [Slip::Sibling { written, meant }]);
    }
}

#[test]
fn degenerate_forms() {
    let none: &[Rational] = &[];
    for constant in [integer(0), integer(7), rational(-1, 3)] {
        let form = PolarForm::new(vec![constant.clone()]);
        assert_eq!(form.degree(), 0);
        assert_eq!(form.value(none), Ok(constant.clone()));
        assert_eq!(form.bezier_points(&Interval::unit()), vec![constant.clone()]);
        assert_eq!(form.elevate(4).value(&[1, 2, 3, 4].map(integer)), Ok(constant.clone()));
        assert_eq!(*form.nth_derivative(1).diagonal(), *none);
        for method in Method::ALL {
            assert_eq!(form.derive(method, &integer(3)).form, form, "{method}");
        }
        // Composing with a constant on either side gives a constant.
        let square = PolarForm::new([0, 0, 1].map(integer).to_vec());
        assert_eq!(form.compose(&square).value(none), Ok(constant.clone()));
        assert_eq!(square.compose(&form).value(none), Ok(&constant * &constant));
    }
    // The zero polynomial of degree bound 3.
    let zero = PolarForm::new(vec![integer(0); 4]);
    for method in Method::ALL {
        assert_eq!(zero.derive(method, &rational(1, 2)).form, zero, "{method}");
    }
    assert_eq!(zero.value(&[5, 6, 7].map(integer)), Ok(integer(0)));
    assert_eq!(zero.reduce(3), Ok(PolarForm::new(vec![integer(0)])));
}

#[test]
fn huge_coefficients() {
    let huge = Rational::from_integer(polarform::number::factorial(60));
    let tiny = huge.recip();
    let c = vec![huge.clone(), tiny.clone(), -huge.clone(), tiny.clone()];
    let t = vec![tiny.clone(), huge.clone(), rational(1, 3)];
    let form = PolarForm::new(c.clone());
    let right = by_permutations(&c, &t);
    assert_eq!(form.value(&t), Ok(right.clone()));
    for method in Method::ALL {
        assert_eq!(form.derive(method, &huge).form.value(&t), Ok(right.clone()), "{method}");
    }
    let points = form.bezier_points(&Interval::new(tiny.clone(), huge.clone()).unwrap());
    assert_eq!(de_casteljau(points, &tiny, &huge, &t), right);
}
