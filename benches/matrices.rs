//! Matrices between bases: closed forms, and the generic inverse for comparison.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use polarform::basis::{Basis, bernstein_to_power, change_of_basis, power_to_bernstein};
use polarform::interval::Interval;
use polarform::linalg::{inverse, multiply};
use polarform::number::{Rational, rational};

fn closed_forms(c: &mut Criterion) {
    let mut group = c.benchmark_group("A_n and its inverse");
    group.sample_size(20);
    for n in [10, 50, 100, 200, 500] {
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |b, &n| {
            b.iter(|| (bernstein_to_power(black_box(n)), power_to_bernstein(black_box(n))));
        });
    }
    group.finish();
}

fn generic(c: &mut Criterion) {
    let mut group = c.benchmark_group("degree 50");
    group.sample_size(10);
    let a = bernstein_to_power(50);
    let a_inverse = power_to_bernstein(50);
    let hilbert = nalgebra::DMatrix::from_fn(51, 51, |i, j| rational(1, (i + j + 1) as i64));
    group.bench_function("generic inverse of A_n", |b| b.iter(|| inverse(black_box(&a))));
    group.bench_function("generic inverse of Hilbert's matrix", |b| b.iter(|| inverse(black_box(&hilbert))));
    group.bench_function("product A_n A_n^-1", |b| b.iter(|| multiply(black_box(&a), &a_inverse)));
    group.bench_function("product A_n A_n^-1 by nalgebra", |b| b.iter(|| black_box(&a) * &a_inverse));
    group.finish();
}

fn between_bases(c: &mut Criterion) {
    let mut group = c.benchmark_group("change of basis, degree 20");
    group.sample_size(20);
    let unit = Basis::Bernstein(Interval::unit());
    let bases: [(&str, Basis<Rational>); 4] = [
        ("power", Basis::Power),
        ("Bernstein on [1/3, 5/7]", Basis::Bernstein(Interval::new(rational(1, 3), rational(5, 7)).unwrap())),
        ("Lagrange", Basis::Lagrange((0..=20).map(|k| rational(k, 20)).collect())),
        ("Newton", Basis::Newton((0..=20).map(|k| rational(k, 20)).collect())),
    ];
    for (name, basis) in &bases {
        group.bench_function(format!("{name} to Bernstein"), |b| {
            b.iter(|| change_of_basis(20, black_box(basis), &unit));
        });
        group.bench_function(format!("Bernstein to {name}"), |b| {
            b.iter(|| change_of_basis(20, &unit, black_box(basis)));
        });
    }
    group.finish();
}

criterion_group!(benches, closed_forms, generic, between_bases);
criterion_main!(benches);
