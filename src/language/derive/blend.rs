//! Coons' surface of four curves, as a Boolean sum.

use super::lines::{chain, combination, integer, line, sequence, subscript, symbol};
use super::schemes::point_expr;
use super::words::{Reason, Title};
use crate::formula::{Expr, Sign, Term};
use crate::language::value::{Derivation, Form, polynomial_expr};
use crate::math::curve::{BezierCurve, TensorPatch};
use crate::math::poly::{Fraction, Symbol, horner};
use crate::math::ring::Ring;
use num_traits::{One, Zero};

/// A point by its coordinates.
type Coordinates = Vec<Fraction>;

/// Both ruled surfaces, the bilinear one of the corners that both contain, and their Boolean sum. `surface` is Coons' surface of the curves c_0, c_1
/// in u and d_0, d_1 in v, all over the intervals of the surface.
///
/// Cost: a few products of polynomials for each coordinate.
///
/// # Panics
/// If u or v occur in the points.
pub fn coons(
    in_u: &[BezierCurve<Fraction>; 2],
    in_v: &[BezierCurve<Fraction>; 2],
    surface: &TensorPatch<Fraction>,
    form: Form,
) -> Derivation {
    let [u, v] = ["u", "v"].map(Symbol::new);
    let shown = |point: &Coordinates| point_expr(form, point);
    let name = |letter: &str, i: usize, at: Expr| Expr::apply(subscript(letter, &[i]), vec![at]);
    let expr = |f: &Fraction| polynomial_expr(f);
    let [c, d] = [(in_u, &u), (in_v, &v)]
        .map(|(curves, t)| curves.each_ref().map(|curve| coordinates(&curve.power(), &symbol(t))));
    let ((a, b), (e, f)) = (surface.u().ends(), surface.v().ends());
    let given = |letter: &str, t: &Symbol, curves: &[Coordinates; 2]| {
        let one = |i: usize| chain([name(letter, i, expr(&symbol(t))), shown(&curves[i])]);
        sequence(vec![one(0), one(1)])
    };
    let mut lines = vec![
        line(given("c", &u, &c), Reason::BoundaryCurves(u.clone())),
        line(given("d", &v, &d), Reason::BoundaryCurves(v.clone())),
    ];
    let corner = |i: usize, j: usize| -> Coordinates { in_u[j].value([a, b][i]).iter().cloned().collect() };
    let meet = |i: usize, j: usize| {
        let (x, y) = ([a, b][i], [e, f][j]);
        chain([name("c", j, expr(x)), name("d", i, expr(y)), shown(&corner(i, j))])
    };
    lines.push(line(sequence(vec![meet(0, 0), meet(1, 0), meet(0, 1), meet(1, 1)]), Reason::Corners));
    // 1 − s and s for s = (u − a)/(b − a).
    let weights = |t: &Symbol, (a, b): (&Fraction, &Fraction)| -> [Fraction; 2] {
        let inverse = crate::math::ring::Field::inverse(&b.minus(a)).expect("an interval has a length");
        let s = symbol(t).minus(a).times(&inverse);
        [integer(1).minus(&s), s]
    };
    let (s, t) = (weights(&u, (a, b)), weights(&v, (e, f)));
    let sum = |list: Vec<(Fraction, &Coordinates)>| -> Coordinates {
        let coordinate =
            |k: usize| list.iter().fold(Fraction::zero(), |sum, (w, p)| sum.plus(&w.times(&p[k])));
        (0..in_u[0].dimension()).map(coordinate).collect()
    };
    let at = |letter: &str| Expr::apply(Expr::name(letter), vec![expr(&symbol(&u)), expr(&symbol(&v))]);
    let blended = |letter: &str, t: &Symbol, weights: &[Fraction; 2]| {
        combination((0..2).map(|i| (weights[i].clone(), name(letter, i, expr(&symbol(t))))))
    };
    let by_c = sum(vec![(t[0].clone(), &c[0]), (t[1].clone(), &c[1])]);
    let by_d = sum(vec![(s[0].clone(), &d[0]), (s[1].clone(), &d[1])]);
    lines.push(line(
        chain([at("P"), blended("c", &u, &t), shown(&by_c)]),
        Reason::RuledBetween("c", v.clone()),
    ));
    lines.push(line(
        chain([at("Q"), blended("d", &v, &s), shown(&by_d)]),
        Reason::RuledBetween("d", u.clone()),
    ));
    let corners: Vec<Coordinates> = (0..4).map(|k| corner(k / 2, k % 2)).collect();
    let product = |k: usize| s[k / 2].times(&t[k % 2]);
    let bilinear = sum((0..4).map(|k| (product(k), &corners[k])).collect());
    lines.push(line(chain([at("B"), shown(&bilinear)]), Reason::BilinearOfCorners));
    let terms = [(Sign::Plus, "P"), (Sign::Plus, "Q"), (Sign::Minus, "B")];
    let boolean = Expr::sum(terms.map(|(sign, letter)| Term { sign, expr: at(letter) }).to_vec());
    let one = Fraction::one();
    let whole = sum(vec![(one.clone(), &by_c), (one.clone(), &by_d), (-one, &bilinear)]);
    lines.push(line(chain([at("S"), boolean, shown(&whole)]), Reason::BooleanSum));
    let on = |x: Expr, y: Expr| Expr::apply(Expr::name("S"), vec![x, y]);
    let (x, y) = (|| expr(&symbol(&u)), || expr(&symbol(&v)));
    let boundary = vec![
        chain([on(x(), expr(e)), name("c", 0, x())]),
        chain([on(x(), expr(f)), name("c", 1, x())]),
        chain([on(expr(a), y()), name("d", 0, y())]),
        chain([on(expr(b), y()), name("d", 1, y())]),
    ];
    lines.push(line(sequence(boundary), Reason::AllFourCurves));
    Derivation { title: Title::Coons.words(), lines, language: None }
}

/// The coordinates as polynomials of the parameter, by its powers.
fn coordinates(power: &[Vec<Fraction>], t: &Fraction) -> Coordinates {
    power.iter().map(|list| horner(list, t)).collect()
}
