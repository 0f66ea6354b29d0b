//! Polar forms: expanded text, values, products, elevation, control points.

mod inputs;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use inputs::{expected, in_w2, in_w3, in_w7, in_w8, modp, point};
use polarform::blossom::laws::ArgumentNames;
use polarform::blossom::{PolarForm, PreparedForm, expand_univariate};
use polarform::interval::Interval;
use polarform::number::{Int, Rational};
use polarform::poly::Symbol;
use polarform::session::Session;
use polarform::write::{Format, write_expanded};

/// The value at the points of the checksum, modulo its prime.
fn checksum(form: &PolarForm<Rational>) -> u64 {
    let points: Vec<Rational> =
        (1..=form.degree()).map(|i| Rational::from_integer(Int::from(point(i as u64)))).collect();
    modp(&PreparedForm::new(form).value(&points).expect("as many points as arguments"))
}

/// Every monomial written out; the output goes to memory.
fn expanded(c: &mut Criterion) {
    let mut group = c.benchmark_group("expanded");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    for n in [8, 12, 16, 20] {
        let form = PolarForm::new(in_w2(n));
        if n <= 16 {
            assert_eq!(checksum(&form), expected(&format!("W2/{n}")));
        }
        for format in [Format::Text, Format::Latex] {
            let names: Vec<String> = (1..=n)
                .map(|i| match format {
                    Format::Latex if i > 9 => format!("t_{{{i}}}"),
                    Format::Latex => format!("t_{i}"),
                    _ => format!("t{i}"),
                })
                .collect();
            let mut out = Vec::new();
            write_expanded(&mut out, &form, &names, format).expect("memory takes everything");
            group.throughput(Throughput::Bytes(out.len() as u64));
            group.bench_function(format!("W2/{n}/{format}"), |b| {
                b.iter(|| {
                    out.clear();
                    write_expanded(&mut out, black_box(&form), &names, format)
                });
            });
        }
    }
    group.finish();
}

fn values(c: &mut Criterion) {
    let mut group = c.benchmark_group("value");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    for n in [10, 100, 1000] {
        let (coefficients, points) = in_w3(n);
        let form = PolarForm::new(coefficients);
        let evaluator = PreparedForm::new(&form);
        let value = evaluator.value(&points).expect("as many points as arguments");
        assert_eq!(modp(&value), expected(&format!("W3/{n}")));
        group.bench_function(format!("W3/{n}"), |b| b.iter(|| evaluator.value(black_box(&points))));
        group.bench_function(format!("W3/{n}, unprepared"), |b| {
            b.iter(|| black_box(&form).value(black_box(&points)));
        });
    }
    group.finish();
}

/// The polar form of a product: compact, symmetrised compactly, and written out.
fn products(c: &mut Criterion) {
    let mut group = c.benchmark_group("product");
    for m in [5, 7] {
        let (f, g) = in_w8(m);
        let (f, g) = (PolarForm::new(f), PolarForm::new(g));
        let product = f.product(&g);
        assert_eq!(product, f.product_by_symmetrizing(&g));
        assert_eq!(checksum(&product), expected(&format!("W8/{m}")));
        let names: Vec<String> = (1..=2 * m).map(|i| format!("t{i}")).collect();
        group.bench_function(format!("W8/{m}/compact"), |b| b.iter(|| black_box(&f).product(&g)));
        group.bench_function(format!("W8/{m}/symmetrized"), |b| {
            b.iter(|| black_box(&f).product_by_symmetrizing(&g));
        });
        group.bench_function(format!("W8/{m}/as text"), |b| {
            b.iter(|| {
                let mut out = Vec::new();
                write_expanded(&mut out, &black_box(&f).product(&g), &names, Format::Text).map(|()| out)
            });
        });
        let arrangement = ArgumentNames::univariate(&Symbol::new("t"), 2 * m);
        group.bench_function(format!("W8/{m}/as polynomial"), |b| {
            b.iter(|| expand_univariate(&black_box(&f).product(&g), &arrangement));
        });
    }
    group.finish();
}

fn control_points(c: &mut Criterion) {
    let mut group = c.benchmark_group("control points");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    let ordinates = |seed, n| in_w7(seed, n).into_iter().map(|[x, _]| x).collect::<Vec<Rational>>();
    let points = ordinates(700, 100);
    group.bench_function("elevate 100 -> 200", |b| {
        b.iter(|| {
            let form = PolarForm::from_bezier_points(black_box(&points)).expect("there are points");
            form.elevate(100).bezier_points(&Interval::unit())
        });
    });
    group.finish();
}

fn queries(c: &mut Criterion) {
    let mut group = c.benchmark_group("query");
    group.bench_function("polar(t^3 + 3t^2 + 5t + 1)", |b| {
        b.iter(|| Session::default().run(black_box("polar(t^3 + 3t^2 + 5t + 1)")));
    });
    group.bench_function("claim", |b| {
        let mut session = Session::default();
        session.run("f := polar(t^3 + 3t^2 + 5t + 1)").expect("a definition");
        let claim = "f(t, t, 1) - f(t, t, 0) = t^2 + 2t + 5/3";
        b.iter(|| session.run(black_box(claim)));
    });
    group.finish();
}

criterion_group!(benches, expanded, values, products, control_points, queries);
criterion_main!(benches);
