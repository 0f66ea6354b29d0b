//! Polynomials in several symbols: products, powers, gcd, fractions with symbolic knots.

mod inputs;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use inputs::{expected, plus, point, power, times};
use polarform::number::integer;
use polarform::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use polarform::ring::Ring;

fn symbol(name: &str) -> MultiPoly {
    MultiPoly::symbol(Symbol::new(name))
}

/// The value at the points of the checksum, modulo its prime.
fn checksum(p: &MultiPoly) -> u64 {
    let names = ["x", "y", "z", "w"].map(Symbol::new);
    p.terms(MonomialOrder::Lex).into_iter().fold(0, |sum, (powers, c)| {
        let term = powers.iter().fold(inputs::modp(&c), |term, (s, e)| {
            let i = names.iter().position(|name| name == s).expect("one of the four") as u64 + 1;
            times(term, power(point(i), u64::from(*e)))
        });
        plus(sum, term)
    })
}

fn products(c: &mut Criterion) {
    let mut group = c.benchmark_group("multivariate product");
    group.sample_size(10).measurement_time(Duration::from_secs(2));
    let base =
        ["x", "y", "z", "w"].iter().fold(MultiPoly::constant(integer(1)), |sum, n| sum.plus(&symbol(n)));
    for k in [8, 12, 16] {
        let f = base.pow(k);
        let g = f.plus(&MultiPoly::constant(integer(1)));
        assert_eq!(checksum(&f.times(&g)), expected(&format!("W8/fateman/{k}")));
        group.bench_function(format!("W8/fateman/{k}"), |b| b.iter(|| black_box(&f).times(black_box(&g))));
    }
    let (a, b) = (symbol("t").plus(&symbol("c")), symbol("t").minus(&symbol("d")));
    group.bench_function("2 terms by 2 terms", |bench| bench.iter(|| black_box(&a).times(black_box(&b))));
    group.finish();
}

/// (t − t_1)/(t_3 − t_1) and the like: the fractions of symbolic knots.
fn fractions(c: &mut Criterion) {
    let mut group = c.benchmark_group("fractions");
    let knot = |i: i64| Fraction::from(MultiPoly::symbol(Symbol::indexed("t", i)));
    let t = Fraction::from(symbol("t"));
    let weight = |i: i64, k: i64| (t.minus(&knot(i))) / (knot(i + k).minus(&knot(i)));
    group.bench_function("Cox-de Boor, degree 3, symbolic knots", |b| {
        b.iter(|| {
            // The piece of N_0^3 on [t_3, t_4), by the recursion with N_3^0 = 1 alone.
            let mut row: Vec<Fraction> = (0..4).map(|i| Fraction::from(integer(i64::from(i == 3)))).collect();
            for k in 1..=3 {
                for i in 0..4 - k {
                    let left = row[i].times(&weight(i as i64, k as i64));
                    let one = Fraction::from(integer(1));
                    let right = row[i + 1].times(&one.minus(&weight(i as i64 + 1, k as i64)));
                    row[i] = left.plus(&right);
                }
            }
            row.swap_remove(0)
        });
    });
    group.finish();
}

/// gcd(A C, B C) and A C / C for random factors, as `docs/benchmarks.md` has them.
fn common_factors(c: &mut Criterion) {
    let mut group = c.benchmark_group("multivariate gcd");
    for (variables, terms, degree) in
        [(2, 6, 4), (2, 20, 10), (3, 6, 4), (3, 20, 10), (4, 12, 6), (4, 20, 10)]
    {
        let [a, b, common] = inputs::in_gcd(variables, terms, degree);
        let (x, y) = (a.times(&common), b.times(&common));
        assert!(x.gcd(&y).div_exact(&common.primitive_part()).is_some());
        let name = format!("gcd, {variables} variables, {terms} terms, degree < {degree}");
        group.bench_function(name, |bench| bench.iter(|| black_box(&x).gcd(black_box(&y))));
        let name = format!("exact division, {variables} variables, {terms} terms, degree < {degree}");
        group.bench_function(name, |bench| bench.iter(|| black_box(&x).div_exact(black_box(&common))));
    }
    group.finish();
}

criterion_group!(benches, products, fractions, common_factors);
criterion_main!(benches);
