//! How real roots are isolated: polar values over intervals that are halved, and Descartes' rule of signs.

use super::lines::{chain, factor, line, power, sequence, subscript, term};
use super::polar::{given, univariate};
use super::schemes::label;
use super::words::{Reason, Title};
use crate::formula::{Expr, Kind};
use crate::language::value::{
    Derivation, Line, Notation, Value, grouped_expr, in_letter, polynomial_expr, symbol_expr,
};
use crate::math::blossom::PolarForm;
use crate::math::interval::Interval;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Poly, Symbol};
use num_traits::Zero;

/// The roots of F in [a, b], step by step, for a polynomial that is not constant and a < b. Bernstein coefficients over
/// an interval are values of the polar form at its ends; where their signs change once or never, the number of roots is
/// known, elsewhere the interval is halved.
///
/// Cost: n + 1 polar values for each interval, and one derivation line.
pub fn roots(f: &Poly, variable: &Symbol, interval: &Interval<Rational>) -> Derivation {
    let (a, b) = interval.ends();
    let formula = |p: &Poly| Fraction::from(in_letter(p, variable));
    let polar =
        |p: &Poly| PolarForm::new(p.coefficients().into_iter().map(Fraction::from).collect::<Vec<_>>());
    let simple = f.square_free_part();
    let repeated = simple.degree() < f.degree();
    let mut lines = vec![given(Expr::name("F"), &univariate(polar(f), variable), Reason::Given)];
    let (name, small, own) = if repeated { ("G", "g", simple) } else { ("F", "f", f.clone()) };
    if repeated {
        let factors = f
            .square_free_factors()
            .into_iter()
            .filter_map(|(p, m)| power(factor(grouped_expr(&formula(&p))), m));
        let product = Expr::sum(vec![term(&Fraction::from(f.leading_coefficient()), factors.collect())]);
        let left = Expr::apply(Expr::name("F"), vec![symbol_expr(variable)]);
        lines.push(line(chain([left, product]), Reason::SquareFreeFactors));
        lines.push(given(Expr::name("G"), &univariate(polar(&own), variable), Reason::SimpleRoots));
    }
    let form = polar(&own);
    let n = form.degree();
    lines.push(line(
        univariate(form.clone(), variable).equation(Expr::name(small), Notation::Grouped),
        Reason::PolarFormOf(name),
    ));
    let root_line = |t: &Rational| {
        let left = Expr::apply(Expr::name(name), vec![Expr::number(t)]);
        line(chain([left, Expr::int(0)]), Reason::EndIsRoot)
    };
    lines.extend(own.value(a).is_zero().then(|| root_line(a)));
    let parts = own.subdivision(interval);
    crate::budget::charge_terms((parts.len() as u64).saturating_mul(n as u64 + 1));
    for part in parts {
        let ends = [&part.lower, &part.upper].map(|q| Fraction::from(q.clone()));
        let point = |i: usize| {
            let arguments = [vec![ends[0].clone(); n - i], vec![ends[1].clone(); i]].concat();
            // There are n arguments.
            let value = form.value(&arguments).unwrap_or_else(|_| Fraction::zero());
            chain([label(small, &arguments), polynomial_expr(&value)])
        };
        let reason = Reason::SignChanges {
            changes: part.changes,
            lower: part.lower.clone(),
            upper: part.upper.clone(),
        };
        lines.push(line(sequence((0..=n).map(point).collect()), reason));
        lines.extend((part.root_at_upper && part.changes <= 1).then(|| root_line(&part.upper)));
    }
    lines.push(result(f, variable, a, b));
    Derivation { title: Title::Roots.words(), lines, language: None }
}

/// x_1 = …, x_2 = …
fn result(f: &Poly, variable: &Symbol, a: &Rational, b: &Rational) -> Line {
    let found = f.real_roots(Some(a), Some(b)).unwrap_or_default();
    let letter = if *variable == Symbol::new("x") { "r" } else { "x" };
    if found.is_empty() {
        let left = Expr::apply(
            Expr::name("roots"),
            vec![grouped_expr(&Fraction::from(in_letter(f, variable))), Expr::number(a), Expr::number(b)],
        );
        return line(chain([left, Kind::List(Vec::new()).into()]), Reason::NoRoots);
    }
    let multiplicities = found.iter().map(|(_, m)| *m).collect();
    let equation =
        |(k, (root, _))| chain([subscript(letter, &[k + 1]), Value::root(root, variable).to_expr()]);
    line(sequence(found.into_iter().enumerate().map(equation).collect()), Reason::RootsFound(multiplicities))
}
