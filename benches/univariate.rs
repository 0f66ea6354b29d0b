//! Univariate polynomials over Q: product, composition, evaluation, shift, gcd; the same as queries.

mod inputs;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use inputs::{ck_integers, expected, in_w3, in_w4, in_w4_long, in_w5};
use polarform::number::rational;
use polarform::poly::Poly;
use polarform::session::Session;
use polarform::value::{Value, Verdict};

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
        assert_eq!(f.value(&x), f.shift(&x).coefficient(0));
        group.bench_function(format!("eval/{d}"), |b| b.iter(|| black_box(&f).value(black_box(&x))));
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

/// What a query costs, beside the same computation by [`Poly`].
fn queries(c: &mut Criterion) {
    let mut group = c.benchmark_group("query");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    let linear = |a: i64, b: i64| Poly::from_coefficients(vec![rational(a, 1), rational(b, 1)]);
    let of_powers = || linear(1, 1).pow(2000) * linear(2, -1).pow(2000);
    assert_eq!(of_powers().degree(), Some(4000));
    group.bench_function("product of powers/Poly", |b| b.iter(of_powers));
    let integer = |text: &'static str| {
        move || {
            let answer = Session::default().run(text).expect("a query that is answered");
            answer.outcome.value.as_int().expect("an integer")
        }
    };
    for (name, text, value) in [
        ("product of powers/session", "degree((1+t)^2000*(2-t)^2000, t)", 4000),
        ("composition/session", "degree(((t^2+3t-1)^40)(t^2-t/2+1), t)", 160),
        ("gcd/session", "degree(gcd((t^2+t+3)^60*(t-5)^40, (t^2+t+3)^50*(2t+1)^60), t)", 100),
        ("sum of products/session", "degree(sum(i=0..300, (t+i)^20 (t-i)^20), t)", 40),
        ("quotient/session", "degree((t^600-1)/(t^2-1), t)", 598),
    ] {
        let query = integer(text);
        assert_eq!(query(), value, "{text}");
        group.bench_function(name, |b| b.iter(&query));
    }
    for n in [200, 800] {
        let text = format!("sum(i=0..{n}, binomial({n},i) t^i (1-t)^({n}-i)) = 1");
        let query = || {
            let answer = Session::default().run(&text).expect("a claim that is answered");
            matches!(&answer.outcome.value, Value::Claim(claim) if claim.verdict() == Verdict::Proved)
        };
        assert!(query(), "{text}");
        group.bench_function(format!("partition of unity/{n}/session"), |b| b.iter(query));
    }
    group.finish();
}

criterion_group!(benches, product, composition, one_argument, gcd, queries);
criterion_main!(benches);
