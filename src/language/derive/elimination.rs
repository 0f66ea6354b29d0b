//! Sturm's chain with its signs, and resultants as determinants.

use nalgebra::DMatrix;
use num_traits::Zero;

use super::lines::{chain, line, sequence, subscript};
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind};
use crate::language::value::{Derivation, Value, grouped_expr, in_letter, polynomial_expr, symbol_expr};
use crate::math::interval::Interval;
use crate::math::linalg::determinant;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Poly, Symbol, sign_changes};

/// Sturm's chain of F, line by line, the signs at a and b, and the number of roots in (a, b]; F is not constant.
///
/// Cost: that of [`Poly::sturm_chain`], and a value of each polynomial at both ends.
pub fn sturm(f: &Poly, variable: &Symbol, interval: &Interval<Rational>) -> Derivation {
    let name = |k: usize| Expr::apply(subscript("P", &[k]), vec![symbol_expr(variable)]);
    let of = |p: &Poly| grouped_expr(&Fraction::from(in_letter(p, variable)));
    let simple = f.square_free_part();
    let own = if simple.degree() < f.degree() { &simple } else { f };
    let left = Expr::apply(Expr::name("F"), vec![symbol_expr(variable)]);
    let mut lines = vec![line(chain([left, of(f)]), Reason::Given)];
    let chain_of = own.sturm_chain();
    for (k, p) in chain_of.iter().enumerate() {
        let reason = match k {
            0 if own == f => Reason::ChainStarts,
            0 => Reason::SimpleRoots,
            1 => Reason::ItsDerivative,
            _ => Reason::SturmRemainder(k),
        };
        lines.push(line(chain([name(k), of(p)]), reason));
    }
    let (a, b) = interval.ends();
    let mut count = [0_usize; 2];
    for (end, count) in [a, b].into_iter().zip(&mut count) {
        let values: Vec<Rational> = chain_of.iter().map(|p| p.value(end)).collect();
        *count = sign_changes(&values);
        let value = |(k, q): (usize, &Rational)| {
            chain([Expr::apply(subscript("P", &[k]), vec![Expr::number(end)]), Expr::number(q)])
        };
        let all = sequence(values.iter().enumerate().map(value).collect());
        lines.push(line(all, Reason::SturmSigns { at: end.clone(), changes: *count }));
    }
    let roots = count[0].saturating_sub(count[1]);
    let [v, w] = count.map(|n| Expr::int(n as i64));
    let difference = crate::formula::Term { sign: crate::formula::Sign::Minus, expr: w };
    let first = crate::formula::Term { sign: crate::formula::Sign::Plus, expr: v };
    let sides = [Expr::sum(vec![first, difference]), Expr::int(roots as i64)];
    lines.push(line(chain(sides), Reason::SturmCount { lower: a.clone(), upper: b.clone() }));
    Derivation { title: Title::Sturm.words(), lines, language: None }
}

/// Res(F, G) as Sylvester's determinant, for polynomials in a variable that are not both constant. `None` for 0.
///
/// Cost: a determinant of size m + n with polynomials as entries.
pub fn resultant(f: &MultiPoly, g: &MultiPoly, variable: &Symbol) -> Option<Derivation> {
    if f.is_zero() || g.is_zero() {
        return None;
    }
    let at = |name: &str| Expr::apply(Expr::name(name), vec![symbol_expr(variable)]);
    let of = |p: &MultiPoly| grouped_expr(&Fraction::from(p.clone()));
    let lists = [f, g].map(|p| p.coefficients_in(variable));
    let (m, n) = (lists[0].len() - 1, lists[1].len() - 1);
    crate::budget::charge_terms(((m + n) as u64).saturating_pow(2));
    // Row i < n has the coefficients of F, highest first, moved by i columns; the other m rows those of G.
    let matrix = DMatrix::from_fn(m + n, m + n, |i, j| {
        let (list, shift) = if i < n { (&lists[0], i) } else { (&lists[1], i - n) };
        let power = (list.len() - 1 + shift).checked_sub(j);
        let entry = power.filter(|_| j >= shift).and_then(|k| list.get(k)).cloned();
        Fraction::from(entry.unwrap_or_else(MultiPoly::zero))
    });
    let value = determinant(&matrix).ok()?;
    let mut lines =
        vec![line(chain([at("F"), of(f)]), Reason::Given), line(chain([at("G"), of(g)]), Reason::Given)];
    if m + n > 0 {
        lines.push(line(
            chain([Expr::name("M"), Value::Matrix(matrix).to_expr()]),
            Reason::Sylvester { m, n },
        ));
    }
    let determinant = Expr::apply(Expr::name("det"), vec![Expr::name("M")]);
    let left = if m + n > 0 { determinant } else { Kind::Text("Res".to_owned()).into() };
    let reason = if value.is_zero() { Reason::CommonFactor } else { Reason::NoCommonFactor };
    lines.push(line(chain([left, polynomial_expr(&value)]), reason));
    Some(Derivation { title: Title::Resultant.words(), lines, language: None })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::integer;
    use proptest::prelude::*;

    fn poly(list: &[i64]) -> Poly {
        list.iter().map(|&c| integer(c)).collect()
    }

    /// The last side of the last line.
    fn result(shown: &Derivation) -> Expr {
        match &shown.lines.last().unwrap().formula.kind {
            Kind::Chain(_, links) => links.last().unwrap().expr.clone(),
            other => panic!("{other:?}"),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// The determinant is the resultant, and the count that of isolated roots.
        #[test]
        fn second_ways(f in prop::collection::vec(-6i64..7, 2..6), g in prop::collection::vec(-6i64..7, 2..5), a in -4i64..4) {
            let (f, g, t) = (poly(&f), poly(&g), Symbol::new("t"));
            let [p, q] = [&f, &g].map(|h| in_letter(h, &t));
            if !f.is_zero() && !g.is_zero() && f.degree() > Some(0) {
                let shown = resultant(&p, &q, &t).unwrap();
                prop_assert_eq!(result(&shown), polynomial_expr(&Fraction::from(f.resultant(&g))));
            }
            if f.degree() > Some(0) {
                let interval = Interval::new(integer(a), integer(a + 3)).unwrap();
                let shown = sturm(&f, &t, &interval);
                let roots = f.real_roots(Some(&integer(a)), Some(&integer(a + 3))).unwrap();
                let inside = roots.iter().filter(|(r, _)| *r != crate::math::poly::RealRoot::Rational(integer(a))).count();
                prop_assert_eq!(result(&shown), Expr::int(inside as i64));
            }
        }
    }
}
