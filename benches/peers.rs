//! One operation at a time, for comparison with other systems: `benches/peers.py` runs both sides.
//!
//! `peers CASE` prints the least CPU time of a run in seconds, and the checksum of the result;
//! `peers --list` the cases.

#![allow(clippy::print_stdout, reason = "a program that prints its figures")]

mod inputs;

use std::hint::black_box;

use inputs::*;
use nalgebra::DMatrix;
use num_integer::Integer;
use polarform::basis::bernstein_to_power;
use polarform::blossom::PolarForm;
use polarform::curve::{BezierCurve, Interval};
use polarform::interpolate::polynomial_through;
use polarform::linalg::{determinant, inverse as inverse_of, solve};
use polarform::number::{Int, Rational, binomial, integer, rational};
use polarform::piecewise::Piecewise;
use polarform::poly::{MonomialOrder, MultiPoly, Poly, Symbol};
use polarform::ring::Ring;
use polarform::session::Session;
use polarform::spline::{BSpline, KnotVector};
use polarform::value::{Value, Verdict};

const CASES: &[&str] = &[
    "integer gcd/3000",
    "gcd/2,6,4",
    "gcd/2,20,10",
    "gcd/3,6,4",
    "gcd/3,20,10",
    "gcd/4,20,10",
    "exact division/4,20,10",
    "sparse product/2000",
    "product/1000",
    "division/400,200",
    "gcd in t/200",
    "interpolation/50",
    "interpolation/200",
    "elevation/100",
    "subdivision/200",
    "spline values/1000",
    "spline basis/10",
    "polar value/1000",
    "polar value/2000",
    "polar value/3000",
    "solve/50",
    "solve/100",
    "determinant/50",
    "inverse A_n/50",
    "inverse A_n/100",
    "identities/1000",
];

/// CPU time of this thread in seconds, where the system tells it; else the time of the clock.
fn cpu() -> f64 {
    // The scheduler brings its count up to date.
    std::thread::yield_now();
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.as_deref().and_then(|text| text.split(' ').next()?.parse::<u64>().ok());
    nanoseconds.map_or_else(
        || std::time::UNIX_EPOCH.elapsed().map_or(0.0, |time| time.as_secs_f64()),
        |nanoseconds| nanoseconds as f64 * 1e-9,
    )
}

/// Runs until a second is spent, at least 3 and at most 50 times.
fn measure<T>(mut run: impl FnMut() -> T, checksum: impl FnOnce(T) -> u64) {
    let (mut best, mut spent, mut runs) = (f64::MAX, 0.0, 0);
    let mut result = run();
    while runs < 3 || (spent < 1.0 && runs < 50) {
        let begin = cpu();
        result = black_box(run());
        let time = cpu() - begin;
        best = best.min(time);
        spent += time;
        runs += 1;
    }
    println!("{best:e} {}", checksum(result));
}

fn ck_multi(p: &MultiPoly) -> u64 {
    let names = ["x", "y", "z", "w"].map(Symbol::new);
    p.terms(MonomialOrder::Lex).into_iter().fold(0, |sum, (powers, c)| {
        let term = powers.iter().fold(modp(&c), |term, (s, e)| {
            let i = names.iter().position(|name| name == s).expect("one of the four") as u64 + 1;
            times(term, power(point(i), u64::from(*e)))
        });
        plus(sum, term)
    })
}

fn integers(lcg: &mut Lcg, count: usize) -> Vec<Rational> {
    (0..count).map(|_| integer(lcg.num(100))).collect()
}

fn polynomial(lcg: &mut Lcg, degree: usize) -> Poly {
    Poly::from_coefficients(integers(lcg, degree + 1))
}

fn system(n: usize) -> (DMatrix<Rational>, DMatrix<Rational>) {
    let mut lcg = Lcg::new(3000 + n as u64);
    let a = DMatrix::from_row_iterator(n, n, integers(&mut lcg, n * n));
    (a, DMatrix::from_vec(n, 1, integers(&mut lcg, n)))
}

fn curve(seed: u64, n: usize) -> BezierCurve<Rational> {
    let points = in_w7(seed, n).into_iter().map(Vec::from).collect();
    BezierCurve::new(points, Interval::unit()).expect("points of the plane")
}

/// B_i^n = (1 − t) B_i^{n−1} + t B_{i−1}^{n−1} as text.
fn identities(count: usize) -> Vec<String> {
    let pairs: Vec<(usize, usize)> = (1..=20).flat_map(|n| (0..=n).map(move |i| (n, i))).collect();
    let b = |n: usize, i: usize| match i <= n {
        true => format!("{}*t^{i}*(1-t)^{}", binomial(n, i), n - i),
        false => "0".to_owned(),
    };
    let text = |(n, i): &(usize, usize)| {
        format!("{} = (1-t)*({})+t*({})", b(*n, *i), b(n - 1, *i), b(n - 1, i.wrapping_sub(1)))
    };
    pairs.iter().cycle().take(count).map(text).collect()
}

fn by_rows(m: &DMatrix<Rational>) -> u64 {
    ck_residues(m.transpose().iter().map(modp))
}

fn main() {
    // Cargo adds options of its own.
    let Some(case) = std::env::args().skip(1).find(|argument| argument != "--bench") else { return };
    if case == "--list" {
        CASES.iter().for_each(|case| println!("{case}"));
        return;
    }
    let (name, sizes) = case.split_once('/').expect("a case");
    let sizes: Vec<usize> = sizes.split(',').map(|size| size.parse().expect("a number")).collect();
    let n = sizes[0];
    match name {
        "integer gcd" => {
            let mut lcg = Lcg::new(1);
            let mut long = || lcg.bigrat(n as u32, 1).numer().clone();
            let pairs: Vec<(Int, Int)> = (0..100).map(|_| (long(), long())).collect();
            let run = || pairs.iter().map(|(a, b)| Rational::from(a.gcd(b))).collect::<Vec<_>>();
            measure(run, |list| ck_list(&list));
        }
        "gcd" | "exact division" => {
            let [a, b, c] = in_gcd(n, sizes[1], sizes[2] as u32);
            let (x, y) = (a.times(&c), b.times(&c));
            match name {
                "gcd" => measure(|| x.gcd(&y), |g| ck_multi(&g)),
                _ => measure(|| x.div_exact(&c).expect("a factor"), |q| ck_multi(&q)),
            }
        }
        "sparse product" => {
            let [a, b, _] = in_gcd(4, n, 100);
            measure(|| a.times(&b), |c| ck_multi(&c));
        }
        "spline basis" => {
            let knots = KnotVector::new(n, in_w9_knots()).expect("increasing knots");
            let checksum = |list: Vec<Piecewise<Rational>>| {
                ck_residues(list.iter().flat_map(Piecewise::pieces).map(|piece| ck_poly(piece)))
            };
            measure(|| knots.basis_functions(), checksum);
        }
        "polar value" => {
            let (coefficients, arguments) = in_w3(n);
            let form = PolarForm::new(coefficients);
            measure(|| form.value(&arguments).expect("as many as the degree"), |value| modp(&value));
        }
        "identities" => {
            let texts = identities(n);
            let run = || {
                let mut session = Session::default();
                let holds = |text: &&String| {
                    let answer = session.run(text).expect("a claim");
                    matches!(answer.outcome.value, Value::Claim(claim) if claim.verdict() == Verdict::Proved)
                };
                texts.iter().filter(holds).count()
            };
            measure(run, |count| count as u64);
        }
        "product" => {
            let (f, g) = in_w4(n);
            let (f, g) = (Poly::from_coefficients(f), Poly::from_coefficients(g));
            measure(|| &f * &g, |h| ck_poly(&h.coefficients()));
        }
        "division" => {
            let mut lcg = Lcg::new(4000);
            let (f, g) = (polynomial(&mut lcg, n), polynomial(&mut lcg, sizes[1]));
            let run = || f.div_rem(&g).expect("not zero");
            measure(run, |(q, r)| ck_residues([ck_poly(&q.coefficients()), ck_poly(&r.coefficients())]));
        }
        "gcd in t" => {
            let mut lcg = Lcg::new(5000);
            let [a, b, c] = [0; 3].map(|_| polynomial(&mut lcg, n));
            let (x, y) = (&a * &c, &b * &c);
            measure(|| x.gcd(&y), |g| ck_poly(&g.coefficients()));
        }
        "interpolation" => {
            let nodes: Vec<Rational> = (0..n as i64).map(integer).collect();
            let values = integers(&mut Lcg::new(2000 + n as u64), n);
            measure(|| polynomial_through(&nodes, &values).expect("distinct nodes"), |p| ck_list(&p));
        }
        "elevation" => {
            let curve = curve(700, n);
            measure(|| curve.elevate(n), |c| ck_list(c.points().iter().flatten()));
        }
        "subdivision" => {
            let curve = curve(701, n);
            let run = || curve.subdivide(&rational(1, 3)).expect("inside");
            measure(run, |(left, right)| ck_list(left.points().iter().chain(right.points()).flatten()));
        }
        "spline values" => {
            let (knots, points, fresh) = in_w9_insertion();
            let knots = KnotVector::new(3, knots).expect("increasing knots");
            let spline = BSpline::new(knots, points).expect("they fit");
            let run = || fresh.iter().map(|t| spline.value(t).expect("inside")).collect::<Vec<_>>();
            measure(run, |list| ck_list(list.iter().flatten()));
        }
        "solve" => {
            let (a, b) = system(n);
            measure(|| solve(&a, &b).expect("regular"), |x| by_rows(&x));
        }
        "determinant" => {
            let (a, _) = system(n);
            measure(|| determinant(&a).expect("square"), |x| modp(&x));
        }
        "inverse A_n" => {
            let a = bernstein_to_power(n);
            measure(|| inverse_of(&a).expect("regular"), |x| by_rows(&x));
        }
        _ => panic!("no such case: {case}"),
    }
}
