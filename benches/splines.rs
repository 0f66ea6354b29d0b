//! B-splines: all basis functions, inserting many knots.

mod inputs;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use inputs::{ck_list, ck_poly, ck_residues, expected, in_w9_insertion, in_w9_knots};
use polarform::number::Rational;
use polarform::piecewise::Piecewise;
use polarform::spline::{BSpline, KnotVector};

/// Every basis function as power coefficients on each interval of its support.
fn basis(c: &mut Criterion) {
    let mut group = c.benchmark_group("basis functions on 50 knots");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    for n in [3, 10] {
        let knots = KnotVector::new(n, in_w9_knots()).expect("increasing knots");
        let checksum = |functions: &[Piecewise<Rational>]| {
            ck_residues(functions.iter().flat_map(Piecewise::pieces).map(|piece| ck_poly(piece)))
        };
        assert_eq!(checksum(&knots.basis_functions()), expected(&format!("W9/basis{n}")));
        group.bench_function(format!("degree {n}"), |b| b.iter(|| black_box(&knots).basis_functions()));
    }
    group.finish();
}

/// Boehm's way, one knot after the other.
fn insertion(c: &mut Criterion) {
    let (knots, points, fresh) = in_w9_insertion();
    let spline =
        BSpline::new(KnotVector::new(3, knots).expect("increasing knots"), points).expect("they fit");
    let finer = spline.insert_all(&fresh).expect("inside of the domain");
    assert_eq!(ck_list(finer.points().iter().flatten()), expected("W9/insert1000"));
    let mut group = c.benchmark_group("insertion");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    group.bench_function("1000 knots into 1000 control points", |b| {
        b.iter(|| black_box(&spline).insert_all(black_box(&fresh)))
    });
    group.finish();
}

criterion_group!(benches, basis, insertion);
criterion_main!(benches);
