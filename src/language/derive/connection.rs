//! The matrix of geometric continuity, by differentiating F ∘ φ.

use super::lines::{chain, derivative, factor, line, power, sequence, term};
use super::words::{Reason, Title};
use crate::formula::Expr;
use crate::language::value::{Derivation, Value, symbol_expr};
use crate::math::curve::beta_matrix;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};

/// G^{(j)} = Σ_i B_{j,i}(φ', φ'', …) F^{(i)} for j ≤ k, line by line, and the matrix for β_i = φ^{(i)}.
///
/// Cost: as many terms as partitions of the numbers up to k.
pub fn connection_matrix(k: usize) -> Derivation {
    let beta = |i: usize| Symbol::indexed("beta", i as i64);
    let betas: Vec<Fraction> = (1..=k).map(|i| Fraction::from(MultiPoly::symbol(beta(i)))).collect();
    let matrix = beta_matrix(&betas);
    let t = || Expr::name("t");
    let inner = Expr::apply(Expr::name("phi"), vec![t()]);
    let start = chain([Expr::apply(Expr::name("G"), vec![t()]), Expr::apply(Expr::name("F"), vec![inner])]);
    let mut lines = vec![line(start, Reason::ChangeOfParameter)];
    for j in 1..=k {
        let mut terms = Vec::new();
        for i in (1..=j).rev() {
            for (monomial, c) in matrix[(j, i)].numerator().terms(MonomialOrder::Lex) {
                let order = |symbol: &Symbol| (1..=k).find(|m| beta(*m) == *symbol).unwrap_or(0);
                let inner = monomial.iter().filter_map(|(symbol, e)| {
                    power(factor(derivative(Expr::name("phi"), order(symbol))), *e as usize)
                });
                let factors = inner.chain([derivative(Expr::name("F"), i)]).collect();
                terms.push(term(&Fraction::from(c), factors));
            }
        }
        lines.push(line(chain([derivative(Expr::name("G"), j), Expr::sum(terms)]), Reason::ChainRule));
    }
    if k > 0 {
        let named = |i: usize| chain([derivative(Expr::name("phi"), i), symbol_expr(&beta(i))]);
        lines.push(line(sequence((1..=k).map(named).collect()), Reason::BetasNamed));
    }
    lines.push(line(chain([Expr::name("M"), Value::Matrix(matrix).to_expr()]), Reason::PutTogether));
    Derivation { title: Title::ConnectionMatrix(k).words(), lines, language: None }
}
