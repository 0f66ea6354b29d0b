//! Univariate polynomials over Q: product, composition, evaluation, shift, gcd.

mod inputs;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use inputs::{ck_integers, expected, in_w3, in_w4, in_w4_long, in_w5};
use polarform::number::rational;
use polarform::poly::Poly;

fn pair((f, g): (Vec<polarform::number::Rational>, Vec<polarform::number::Rational>)) -> (Poly, Poly) {
    (Poly::from_coefficients(f), Poly::from_coefficients(g))
}

fn assert_checksum(case: &str, f: &Poly) {
    assert_eq!(ck_integers(f.numerators(), f.denominator()), expected(case), "{case} has a wrong result");
}

fn product(c: &mut Criterion) {
    let mut group = c.benchmark_group("product");
    for d in [100, 1000, 10000] {
        let (f, g) = pair(in_w4(d));
        assert_checksum(&format!("W4/{d}"), &(&f * &g));
        group.bench_function(format!("W4/{d}"), |b| b.iter(|| black_box(&f) * black_box(&g)));
    }
    let (f, g) = pair(in_w4_long());
    assert_checksum("W4/1000x1000bit", &(&f * &g));
    group.bench_function("W4/1000x1000bit", |b| b.iter(|| black_box(&f) * black_box(&g)));
    // Small coefficients, the usual case in lecture notes.
    for d in [5, 20] {
        let (f, g) = pair(in_w5(d));
        group.bench_function(format!("small/{d}"), |b| b.iter(|| black_box(&f) * black_box(&g)));
    }
    group.finish();
}

fn composition(c: &mut Criterion) {
    let mut group = c.benchmark_group("composition");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for d in [20, 50, 100] {
        let (f, g) = pair(in_w5(d));
        assert_checksum(&format!("W5/{d}"), &f.compose(&g));
        group.bench_function(format!("W5/{d}"), |b| b.iter(|| black_box(&f).compose(black_box(&g))));
    }
    group.finish();
}

fn one_argument(c: &mut Criterion) {
    let mut group = c.benchmark_group("one argument");
    let x = rational(355, 113);
    for d in [10, 100, 1000] {
        let f = Poly::from_coefficients(in_w3(d).0);
        assert_eq!(f.eval(&x), f.shift(&x).coefficient(0));
        group.bench_function(format!("eval/{d}"), |b| b.iter(|| black_box(&f).eval(black_box(&x))));
        group.bench_function(format!("shift/{d}"), |b| b.iter(|| black_box(&f).shift(black_box(&x))));
    }
    group.finish();
}

fn gcd(c: &mut Criterion) {
    let mut group = c.benchmark_group("gcd");
    for d in [10, 50, 200] {
        let (f, g) = pair(in_w5(d));
        let common = Poly::from_coefficients(in_w3(d).0);
        let (a, b) = (f * &common, g * &common);
        assert_eq!(a.gcd(&b), common.leading_monic());
        group.bench_function(format!("{d}"), |bench| bench.iter(|| black_box(&a).gcd(black_box(&b))));
    }
    group.finish();
}

criterion_group!(benches, product, composition, one_argument, gcd);
criterion_main!(benches);
