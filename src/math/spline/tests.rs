use super::*;
use crate::math::blossom::{Argument, PolarForm};
use crate::math::curve::{BezierCurve, Interval, Point, Vector, combination};
use crate::math::number::{Rational, integer as z, rational as q};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use num_traits::{One, Zero};
use proptest::prelude::*;

type Spline = BSpline<Rational>;

fn small() -> impl Strategy<Value = Rational> {
    (-9i64..10, 1i64..4).prop_map(|(p, r)| q(p, r))
}

/// Knots with many repetitions, clamped or not.
fn any_knots() -> impl Strategy<Value = KnotVector<Rational>> {
    (0usize..5, prop::collection::vec((0i64..3, 1i64..4), 2..9), 0..3).prop_map(|(n, steps, ends)| {
        let mut inner = vec![];
        let mut at = z(0);
        for (step, denominator) in steps {
            at += q(step, denominator);
            let repeated = inner.iter().filter(|x| **x == at).count();
            if repeated <= n {
                inner.push(at.clone());
            }
        }
        let start = &inner[0] - z(1);
        let end = &inner[inner.len() - 1] + z(1);
        if ends == 0 {
            return KnotVector::clamped(n, &inner, &Interval::new(start, end).unwrap()).unwrap();
        }
        if ends == 1 {
            // control points without influence at both ends
            let mut knots: Vec<Rational> = (1..=n as i64).rev().map(|k| &start - z(k)).collect();
            knots.extend(vec![start; n + 1]);
            knots.extend(inner);
            knots.extend(vec![end.clone(); n + 1]);
            knots.extend((1..=n as i64).map(|k| &end + z(k)));
            return KnotVector::new(n, knots).unwrap();
        }
        let mut knots: Vec<Rational> = (1..=n as i64 + 1).rev().map(|k| &start - z(k)).collect();
        knots.push(start);
        knots.extend(inner);
        knots.extend((0..=n as i64 + 1).map(|k| &end + z(k)));
        KnotVector::new(n, knots).unwrap()
    })
}

pub(super) fn any_spline() -> impl Strategy<Value = Spline> {
    any_knots().prop_flat_map(|knots| {
        let m = knots.count();
        prop::collection::vec(prop::collection::vec(small(), 2), m)
            .prop_map(move |points| Spline::new(knots.clone(), points).unwrap())
    })
}

/// A parameter in the domain, often a knot.
pub(super) fn inside(s: &Spline, k: usize) -> Rational {
    let (a, b) = s.interval().ends();
    let inner = s.inner_knots();
    if k.is_multiple_of(3) && !inner.is_empty() {
        return inner[k % inner.len()].0.clone();
    }
    a + (b - a) * q(k as i64 % 17, 16).min(z(1))
}

/// Σ N_i(t) d_i with the recurrence of Cox and de Boor.
fn by_basis(s: &Spline, t: &Rational) -> Point<Rational> {
    let span = s.knots().span_of(t).unwrap();
    let n = s.degree();
    let knots = s.knots().knots();
    // Values of the polynomials of that span, so that ends and jumps are those of de Boor.
    let weights: Vec<Rational> = (0..s.points().len())
        .map(|i| {
            if i + n < span || i > span {
                return z(0);
            }
            let f = s.knots().basis_function(i).unwrap();
            let piece = f.breaks().iter().position(|x| *x == knots[span]).unwrap();
            f.pieces()[piece].value(t)
        })
        .collect();
    combination(2, weights.iter().zip(s.points())).from_origin()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn values_agree(s in any_spline(), k in 0usize..60) {
        // numbers go another way than symbols
        let arguments: Vec<Argument<Rational>> =
            (0..s.degree()).map(|r| Argument::Point(inside(&s, k + 7 * r))).collect();
        for span in s.knots().spans() {
            prop_assert_eq!(s.blossom(span, &arguments).unwrap().into_point(), s.blossom_by_steps(span, &arguments));
        }
        let t = inside(&s, k);
        let value = s.value(&t).unwrap();
        prop_assert_eq!(&value, &by_basis(&s, &t));
        let span = s.knots().span_of(&t).unwrap();
        let tableau = s.de_boor(span, &vec![t.clone(); s.degree()]).unwrap();
        prop_assert_eq!(tableau.tableau.result(), &value);
        let piece = s.bezier_piece(span).unwrap();
        prop_assert_eq!(&piece.value(&t), &value);
        // every entry of the tableau is the polar value of the piece at its label
        let forms = piece.polar_forms();
        for (points, labels) in tableau.tableau.levels.iter().zip(&tableau.tableau.labels) {
            for (point, label) in points.iter().zip(labels) {
                let expected: Vec<Rational> = forms.iter().map(|f| f.value(label).unwrap()).collect();
                prop_assert_eq!(point, &expected);
            }
        }
        let power: Vec<Rational> = s.power_pieces().iter().map(|p| p.value(&t).unwrap()).collect();
        prop_assert_eq!(value, power);
    }

    #[test]
    fn two_ways_to_the_basis_functions(knots in any_knots()) {
        let all = knots.basis_functions();
        for (i, f) in all.iter().enumerate() {
            prop_assert_eq!(f, &knots.basis_function(i).unwrap());
            prop_assert_eq!(f, &knots.basis_function_by_blossom(i).unwrap());
            // ∫ N_i = (t_{i+n+1} − t_i)/(n + 1)
            let n = knots.degree();
            let width = &knots.knots()[i + n + 1] - &knots.knots()[i];
            prop_assert_eq!(f.integral(), width / z(n as i64 + 1));
            // C^{n−s} at a knot of multiplicity s inside of the support
            for (k, knot) in f.breaks().iter().enumerate().skip(1).take(f.pieces().len() - 1) {
                let window = &knots.knots()[i..=i + n + 1];
                let s = window.iter().filter(|x| *x == knot).count();
                let expected = n.checked_sub(s);
                prop_assert_eq!(f.smoothness(k).map_or(-1, |x| x as i64), expected.map_or(-1, |x| x as i64));
            }
        }
    }

    #[test]
    fn partition_of_unity_and_marsden(knots in any_knots(), x in small()) {
        let n = knots.degree();
        // (x − t)^n has the control points ∏ (x − t_{i+j})
        let factor = Coefficients::new(vec![x.clone(), z(-1)]);
        let polynomial = (0..n).fold(Coefficients::constant(z(1)), |power, _| power.times(&factor));
        let form = PolarForm::new(polynomial.to_vec());
        let s = Spline::of_polynomial(knots.clone(), &[form]).unwrap();
        for i in 0..knots.count() {
            let product = knots.label(i).iter().fold(z(1), |p, t| p * (&x - t));
            prop_assert_eq!(&s.points()[i][0], &product);
        }
        for piece in s.power_pieces()[0].pieces() {
            prop_assert_eq!(piece, &polynomial);
        }
        // as functions, also at knots where they jump
        let (a, b) = knots.interval().unwrap().ends();
        let all = knots.basis_functions();
        let total = all[1..].iter().fold(all[0].clone(), |sum, f| sum.sum(f).unwrap());
        let last = &knots.knots()[knots.knots().len() - 1];
        let inside = |t: &&Rational| a <= *t && (*t < b || (*t == b && b == last));
        for knot in knots.knots().iter().filter(inside) {
            prop_assert!(total.value(knot).unwrap().is_one());
            let sum: Rational = all.iter().map(|f| f.value(knot).unwrap()).sum();
            prop_assert!(sum.is_one());
        }
        let one = Spline::new(knots.clone(), vec![vec![z(1)]; knots.count()]).unwrap();
        prop_assert!(one.power_pieces()[0].pieces().iter().all(|p| **p == [z(1)]));
        if n > 0 {
            let line = (0..knots.count()).map(|i| vec![knots.greville(i)]).collect();
            let line = Spline::new(knots, line).unwrap();
            prop_assert!(line.power_pieces()[0].pieces().iter().all(|p| **p == [z(0), z(1)]));
        }
    }

    #[test]
    fn inserting_and_removing(s in any_spline(), ks in prop::collection::vec(0usize..60, 1..4)) {
        let mut fresh: Vec<Rational> = Vec::new();
        for k in ks {
            let t = inside(&s, k);
            let inner = &t != s.interval().start() && &t != s.interval().end();
            if inner && s.knots().multiplicity(&t) + fresh.iter().filter(|x| **x == t).count() <= s.degree() {
                fresh.push(t);
            }
        }
        let fine = s.insert_all(&fresh).unwrap();
        let one_by_one = fresh.iter().fold(s.clone(), |s, t| s.insert(t).unwrap());
        prop_assert_eq!(&fine, &one_by_one);
        prop_assert_eq!(s.refine(fine.knots().clone()).unwrap().tight(), fine.tight());
        prop_assert_eq!(&s.refine(s.knots().clone()).unwrap(), &s);
        prop_assert_eq!(merged(&fine), merged(&s));
        let mut back = fine;
        for t in &fresh {
            back = back.remove(t, 1).unwrap().unwrap();
        }
        prop_assert_eq!(back.tight(), s.tight());
    }

    #[test]
    fn removal_is_refused_exactly(s in any_spline()) {
        for (knot, multiplicity) in s.inner_knots() {
            let order = s.degree() + 1 - multiplicity;
            let pieces = s.power_pieces();
            let at = pieces[0].breaks().iter().position(|x| *x == knot).unwrap();
            let jump: Vec<Rational> = pieces.iter().map(|p| {
                let d = p.nth_derivative(order);
                d.pieces()[at].value(&knot) - d.pieces()[at - 1].value(&knot)
            }).collect();
            match s.remove(&knot, 1).unwrap() {
                Ok(coarse) => {
                    prop_assert!(jump.iter().all(Zero::is_zero));
                    prop_assert_eq!(merged(&coarse), merged(&s));
                }
                Err(defect) => {
                    prop_assert_eq!(defect.order, order);
                    prop_assert_eq!(&defect.jump, &jump);
                    prop_assert!(!jump.iter().all(Zero::is_zero));
                }
            }
        }
    }

    #[test]
    fn raising_and_lowering(s in any_spline(), by in 1usize..3) {
        let raised = s.elevate(by).unwrap();
        prop_assert_eq!(merged(&raised), merged(&s));
        let n = s.degree();
        // control points as means of polar values with one argument dropped
        if by == 1 {
            for i in 0..raised.points().len() {
                let label = raised.knots().label(i);
                let Some(span) = raised.knots().spans().into_iter().find(|&j| i <= j && j <= i + n + 1) else { continue };
                let old = s.knots().span_of(&raised.knots().knots()[span]).unwrap();
                let total = (0..=n).fold(Vector::zero(2), |total, dropped| {
                    let arguments: Vec<Argument<Rational>> = label.iter().enumerate()
                        .filter(|(j, _)| *j != dropped).map(|(_, t)| Argument::Point(t.clone())).collect();
                    total + s.blossom(old, &arguments).unwrap().into_point().position()
                });
                let mean: Vec<Rational> = total.iter().map(|x| x / z(n as i64 + 1)).collect();
                prop_assert_eq!(&raised.points()[i], &mean);
            }
        }
        let back = raised.reduce(by).unwrap();
        prop_assert_eq!(back.degree(), n);
        prop_assert_eq!(merged(&back), merged(&s));
    }

    #[test]
    fn calculus(s in any_spline(), k in 0usize..60) {
        let primitive = s.antiderivative().unwrap();
        prop_assert_eq!(primitive.derivative().unwrap().tight(), s.tight());
        let (a, b) = s.interval().ends();
        prop_assert!(primitive.value(a).unwrap().iter().all(Zero::is_zero));
        prop_assert_eq!(primitive.value(b).unwrap().position(), s.integral());
        let t = inside(&s, k);
        match s.derivative() {
            Ok(derivative) => {
                let expected: Vec<Rational> =
                    s.power_pieces().iter().map(|p| p.nth_derivative(1).value(&t).unwrap()).collect();
                prop_assert_eq!(derivative.value(&t).unwrap(), expected);
            }
            Err(error) => {
                let jumps = matches!(error, SplineError::NotSmooth { .. });
                prop_assert!(jumps);
            }
        }
    }

    #[test]
    fn products(s in any_spline(), r in any_spline(), k in 0usize..60) {
        // bring r to the domain of s
        let (a, b) = s.interval().ends();
        let (c, d) = r.interval().ends();
        let scale = (b - a) / (d - c);
        let knots = r.knots().knots().iter().map(|t| (t - c) * &scale + a).collect();
        let r = Spline::new(KnotVector::new(r.degree(), knots).unwrap(), r.points().to_vec()).unwrap();
        let product = s.product(&r).unwrap();
        let t = inside(&s, k);
        let (x, y) = (s.value(&t).unwrap(), r.value(&t).unwrap());
        prop_assert_eq!(product.value(&t).unwrap(), vec![&x[0] * &y[0] + &x[1] * &y[1]]);
        prop_assert_eq!(product.degree(), s.degree() + r.degree());
        // the same by symmetrising: mean over the subsets of m of m + n arguments
        let (m, n) = (s.degree(), r.degree());
        let span = product.knots().span_of(&t).unwrap();
        let start = &product.knots().knots()[span];
        let (js, jr) = (s.knots().span_of(start).unwrap(), r.knots().span_of(start).unwrap());
        let label = product.knots().label(span);
        let point = |list: Vec<&Rational>| list.into_iter().cloned().map(Argument::Point).collect::<Vec<_>>();
        let mut total = z(0);
        for chosen in crate::math::number::Combinations::new(m + n, m) {
            let left = point(chosen.iter().map(|&i| &label[i]).collect());
            let right = point((0..m + n).filter(|i| !chosen.contains(i)).map(|i| &label[i]).collect());
            let (x, y) = (s.blossom(js, &left).unwrap(), r.blossom(jr, &right).unwrap());
            let (x, y) = (x.coordinates(), y.coordinates());
            total += &x[0] * &y[0] + &x[1] * &y[1];
        }
        let mean = total / Rational::from_integer(crate::math::number::binomial(m + n, m));
        prop_assert_eq!(&product.points()[span][0], &mean);
    }

    #[test]
    fn matrices(s in any_spline()) {
        let m = s.knots().to_bezier_matrix().unwrap();
        let expected: Vec<Point<Rational>> =
            s.bezier_pieces().iter().flat_map(|piece| piece.points().to_vec()).collect();
        for (i, point) in expected.iter().enumerate() {
            let row: Vec<Rational> = m.row(i).iter().cloned().collect();
            prop_assert!(row.iter().sum::<Rational>().is_one());
            prop_assert_eq!(combination(2, row.iter().zip(s.points())), point.position());
        }
        let n = s.degree();
        for (span, piece) in s.knots().spans().into_iter().zip(s.bezier_pieces()) {
            let matrix = s.knots().power_matrix(span).unwrap();
            let power = piece.power();
            for i in 0..=n {
                let row: Vec<Rational> = matrix.row(i).iter().cloned().collect();
                let point = combination(2, row.iter().zip(&s.points()[span - n..=span]));
                prop_assert_eq!(point, power.iter().map(|p| p[i].clone()).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn periodic_splines_close(n in 0usize..5, steps in prop::collection::vec(1i64..4, 2..6),
                              raw in prop::collection::vec((-5i64..6, -5i64..6), 6)) {
        let mut period = vec![z(0)];
        for step in &steps {
            period.push(&period[period.len() - 1] + z(*step));
        }
        let points: Vec<Point<Rational>> = raw[..steps.len()].iter().map(|&(x, y)| [z(x), z(y)].into()).collect();
        let s = Spline::periodic(n, &period, &points).unwrap();
        prop_assert_eq!(s.interval().ends(), (&period[0], &period[period.len() - 1]));
        let pieces = s.bezier_pieces();
        let (first, last) = (&pieces[0], &pieces[pieces.len() - 1]);
        for k in 0..n {
            prop_assert_eq!(first.nth_derivative(k).value(&period[0]), last.nth_derivative(k).value(s.interval().end()));
        }
    }
}

/// The curve as a function: pieces that are one polynomial joined.
fn merged(s: &Spline) -> Vec<crate::math::piecewise::Piecewise<Rational>> {
    s.power_pieces().iter().map(crate::math::piecewise::Piecewise::merged).collect()
}

fn symbol(name: &str, i: i64) -> Fraction {
    Fraction::from(MultiPoly::symbol(Symbol::indexed(name, i)))
}

#[test]
fn symbolic_knots_give_the_textbook_ratios() {
    let knots = KnotVector::new(3, (0..8).map(|i| symbol("t", i)).collect()).unwrap();
    let points = (0..4).map(|i| vec![symbol("d", i)]).collect();
    let s = BSpline::new(knots, points).unwrap();
    let t = Fraction::from(MultiPoly::symbol(Symbol::new("t")));
    assert_eq!(s.value(&t), Err(SplineError::Unordered));
    let scheme = s.de_boor(3, &[t.clone(), t.clone(), t.clone()]).unwrap();
    // α = (t − t_1)/(t_4 − t_1), as in every textbook
    let expected = (t.clone() - symbol("t", 1)) / (symbol("t", 4) - symbol("t", 1));
    assert_eq!(scheme.ratios[0][0], expected);
    assert_eq!(scheme.tableau.labels[1][0], [symbol("t", 2), symbol("t", 3), t.clone()]);
    assert_eq!(s.value_on(3, &t).unwrap(), *scheme.tableau.result());
    // two ways to the basis function with symbolic knots
    let small = KnotVector::new(2, (0..4).map(|i| symbol("t", i)).collect()).unwrap();
    assert_eq!(small.basis_function(0), small.basis_function_by_blossom(0));
    // at a knot the place is known
    assert_eq!(s.value(&symbol("t", 3)).unwrap().len(), 1);
}

#[test]
fn a_bezier_curve_is_a_spline_without_inner_knots() {
    let points: Vec<Point<Rational>> = [1, -2, 5, 3].map(|x| [z(x)].into()).to_vec();
    let knots = KnotVector::clamped(3, &[], &Interval::new(z(0), z(2)).unwrap()).unwrap();
    let s = Spline::new(knots, points.clone()).unwrap();
    assert_eq!(s.bezier_pieces(), [BezierCurve::new(points, Interval::new(z(0), z(2)).unwrap()).unwrap()]);
    assert!(s.smoothness().is_empty());
}

#[test]
fn what_is_wrong_is_said() {
    let knots = |n, list: &[i64]| KnotVector::new(n, list.iter().map(|&k| z(k)).collect());
    assert!(matches!(knots(2, &[0, 1, 2]), Err(SplineError::TooFewKnots { needed: 4, given: 3, .. })));
    assert_eq!(knots(1, &[0, 2, 1, 3]).unwrap_err(), SplineError::DecreasingKnots { index: 2 });
    assert!(matches!(knots(1, &[0, 1, 1, 1]), Err(SplineError::Multiplicity { index: 1, found: 3, .. })));
    let two = vec![vec![z(0)], vec![z(1)]];
    assert!(matches!(
        Spline::new(knots(1, &[0, 0, 1, 2, 2]).unwrap(), two.clone()),
        Err(SplineError::PointCount { points: 2, knots: 5, degree: 1 })
    ));
    assert_eq!(Spline::new(knots(2, &[0, 1, 2, 3, 4]).unwrap(), two.clone()), Err(SplineError::NoDomain));
    let line = Spline::new(knots(1, &[0, 0, 1, 1]).unwrap(), two).unwrap();
    assert_eq!(line.value(&z(2)), Err(SplineError::OutsideDomain));
    assert_eq!(line.value_on(1, &z(2)).unwrap(), [z(2)]);
    assert!(matches!(line.remove(&q(1, 2), 1), Err(SplineError::NotAKnot { multiplicity: 0, .. })));
    assert!(matches!(line.reduce(1), Err(SplineError::PieceDegree { piece: 0, exact: 1, asked: 0 })));
    let jump = Spline::new(knots(0, &[0, 1, 2]).unwrap(), vec![vec![z(0)], vec![z(1)]]).unwrap();
    assert_eq!(jump.smoothness(), [(z(1), 1, None)]);
    assert_eq!(jump.derivative().unwrap_err(), SplineError::NotSmooth { knot: 1 });
}
