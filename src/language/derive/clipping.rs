//! Bézier clipping, step by step.

use super::lines::{chain, line, sequence, subscript};
use super::polar::{given, univariate};
use super::schemes::label;
use super::words::{Reason, Title};
use crate::formula::Expr;
use crate::language::value::{Derivation, Notation, Value, polynomial_expr};
use crate::math::blossom::PolarForm;
use crate::math::interval::Interval;
use crate::math::number::Rational;
use crate::math::poly::{ClipOutcome, Fraction, Poly, RealRoot, Symbol};

/// The roots of F in [a, b], for a polynomial that is not constant and a < b: Bernstein coefficients over each interval are
/// values of the polar form, and the next interval is where the hull of the Bézier points meets the axis.
///
/// Cost: that of [`Poly::clipping`], and a line for each interval.
pub fn clipping(f: &Poly, variable: &Symbol, interval: &Interval<Rational>, width: &Rational) -> Derivation {
    let polar =
        |p: &Poly| PolarForm::new(p.coefficients().into_iter().map(Fraction::from).collect::<Vec<_>>());
    let mut lines = vec![given(Expr::name("F"), &univariate(polar(f), variable), Reason::Given)];
    let simple = f.square_free_part();
    let repeated = simple.degree() < f.degree();
    let (name, small, own) = if repeated { ("G", "g", simple) } else { ("F", "f", f.clone()) };
    if repeated {
        lines.push(given(Expr::name("G"), &univariate(polar(&own), variable), Reason::SimpleRoots));
    }
    let form = polar(&own);
    let n = form.degree();
    lines.push(line(
        univariate(form, variable).equation(Expr::name(small), Notation::Grouped),
        Reason::PolarFormOf(name),
    ));
    let mut found: Vec<RealRoot> = Vec::new();
    for step in own.clipping(interval, width) {
        let ends = [&step.lower, &step.upper].map(|q| Fraction::from(q.clone()));
        let point = |(i, b): (usize, &Rational)| {
            let arguments = [vec![ends[0].clone(); n - i], vec![ends[1].clone(); i]].concat();
            chain([label(small, &arguments), polynomial_expr(&Fraction::from(b.clone()))])
        };
        let reason = match step.outcome {
            ClipOutcome::Empty => Reason::HullMisses,
            ClipOutcome::Exact(root) => {
                found.push(RealRoot::Rational(root.clone()));
                Reason::HullAtEnd(root)
            }
            ClipOutcome::Root => {
                let roots = own.real_roots(Some(&step.lower), Some(&step.upper)).unwrap_or_default();
                found.extend(roots.into_iter().map(|(root, _)| root));
                Reason::HullOneRoot
            }
            ClipOutcome::Clipped(lower, upper) => Reason::HullMeets(lower, upper),
            ClipOutcome::Halved(middle) => Reason::HullTooWide(middle),
        };
        lines.push(line(sequence(step.coefficients.iter().enumerate().map(point).collect()), reason));
    }
    found.sort();
    found.dedup();
    if !found.is_empty() {
        let letter = if *variable == Symbol::new("x") { "r" } else { "x" };
        let count = found.len();
        let shown = |root: RealRoot| match root {
            RealRoot::Irrational(number) => {
                Value::root(RealRoot::Irrational(number.refined(width)), variable)
            }
            rational => Value::root(rational, variable),
        };
        let equation = |(k, root)| chain([subscript(letter, &[k + 1]), shown(root).to_expr()]);
        let all = sequence(found.into_iter().enumerate().map(equation).collect());
        lines.push(line(all, Reason::RootsFound(vec![1; count])));
    }
    Derivation { title: Title::Clipping.words(), lines, language: None }
}
