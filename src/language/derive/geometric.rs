//! How two curves meet G^k: the β_j, one after the other.

use super::lines::{chain, derivative, line, power, sequence, term};
use super::schemes::given_curve;
use super::words::{Reason, Title};
use crate::formula::{Expr, Sign, Term};
use crate::language::value::{Derivation, Form, Geometry, polynomial_expr, symbol_expr};
use crate::math::curve::{
    BezierCurve, CurveError, GeometricFailure, beta_matrix, geometric_continuity, jet, transferred,
};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};

/// The derivatives where the curves meet, and for j = 1, …, k the vector G^{(j)} − Σ_{i ≥ 2} B_{j,i} F^{(i)}, which has
/// to be β_j F', and β_j, or why there is none.
///
/// Cost: that of [`geometric_continuity`], and of a β-matrix with symbols.
///
/// # Errors
/// As [`geometric_continuity`].
pub fn geometric_steps(
    (left, right): (&BezierCurve<Fraction>, &BezierCurve<Fraction>),
    (f, g): (&BezierCurve<Rational>, &BezierCurve<Rational>),
    form: Form,
    k: usize,
) -> Result<Derivation, CurveError> {
    let report = geometric_continuity(f, g, k)?;
    let beta = |i: usize| Symbol::indexed("beta", i as i64);
    let symbols: Vec<Fraction> = (1..=k).map(|i| Fraction::from(MultiPoly::symbol(beta(i)))).collect();
    let matrix = beta_matrix(&symbols);
    let vector =
        |v: &[Rational]| form.plain(v.iter().cloned().map(Fraction::from).collect::<Vec<_>>()).to_expr();
    let curve =
        |name: &str, curve: &BezierCurve<Fraction>| given_curve(name, &Geometry::Bezier(curve.clone(), form));
    let jets = [jet(f, f.interval().end(), k), jet(g, g.interval().start(), k)];
    let at = [left.interval().end(), right.interval().start()];
    let mut lines = vec![curve("F", left), curve("G", right)];
    for (i, name) in ["F", "G"].into_iter().enumerate() {
        let value = |j: usize| {
            let left = Expr::apply(derivative(Expr::name(name), j), vec![polynomial_expr(at[i])]);
            chain([left, vector(&jets[i][j])])
        };
        let reason = if i == 0 { Reason::DerivativesAtEnd } else { Reason::DerivativesAtStart };
        lines.push(line(sequence((0..=k).map(value).collect()), reason));
    }
    let found = report.betas.len();
    let last = if report.failure.is_some() { (found + 1).min(k) } else { found };
    for j in 1..=last {
        if report.order.is_none() || matches!(report.failure, Some(GeometricFailure::NotRegular)) {
            break;
        }
        let known: Vec<Rational> =
            report.betas[..j - 1].iter().cloned().chain([num_traits::Zero::zero()]).collect();
        let rest = &jets[1][j] - &transferred(&jets[0][..=j], &known)[j];
        let of = |name: &str, order: usize, at: &Fraction| {
            Expr::apply(derivative(Expr::name(name), order), vec![polynomial_expr(at)])
        };
        let mut terms = vec![Term { sign: Sign::Plus, expr: of("G", j, at[1]) }];
        for i in (2..=j).rev() {
            for (monomial, c) in matrix[(j, i)].numerator().terms(MonomialOrder::Lex) {
                let factors =
                    monomial.iter().filter_map(|(symbol, e)| power(symbol_expr(symbol), *e as usize));
                let factors = factors.chain([of("F", i, at[0])]).collect();
                terms.push(term(&Fraction::from(-c), factors));
            }
        }
        let solved = report.betas.get(j - 1);
        let reason = match (&report.failure, solved) {
            (_, Some(_)) => Reason::BetaWanted(j),
            (Some(GeometricFailure::Opposite), None) => Reason::BetaNegative,
            _ => Reason::BetaMissing(j),
        };
        lines.push(line(chain([Expr::sum(terms), vector(&rest)]), reason));
        if let Some(value) = solved {
            lines.push(line(chain([symbol_expr(&beta(j)), Expr::number(value)]), Reason::BetaFound(j)));
        }
    }
    Ok(Derivation { title: Title::GeometricContinuity(k).words(), lines, language: None })
}
