//! One polynomial in several forms, a spline with its system of equations, and a fit.
#![allow(clippy::print_stdout)]

use polarform::basis::Basis;
use polarform::interpolate::{
    CubicSpline, DividedDifferences, Ends, FitOptions, LagrangeForm, Parameterization, Scale, Scheme,
    Tableau, fit_polynomial, parameters,
};
use polarform::interval::Interval;
use polarform::number::{Rational, integer, rational};
use polarform::poly::{Fraction, MultiPoly, Symbol};
use polarform::value::newton_expr;
use polarform::write::text;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let nodes = [0, 1, 3].map(integer);
    let values = [1, 3, 2].map(integer);

    // Lagrange, Newton and Neville lead to the same value.
    let lagrange = LagrangeForm::new(&nodes, &values)?;
    let mut table = DividedDifferences::new(&nodes, &values)?;
    let tableau = Tableau::new(Scheme::Neville, &nodes, &values, &integer(2))?;
    assert_eq!(lagrange.value(&integer(2)), *tableau.value());
    assert_eq!(table.newton_form().value(&integer(2)), *tableau.value());
    println!("p(2) = {}", tableau.value());
    for (k, column) in table.columns().iter().enumerate() {
        println!("  differences over {} nodes: {}", k + 1, list(column));
    }

    // A further node adds a row; the other coefficients stay.
    table.insert(integer(4), integer(0))?;
    println!("coefficients of Newton's form: {}", list(&table.coefficients()));

    // The same with symbols: Newton's form of the straight line through two points.
    let symbol = |name: &str| Fraction::from(MultiPoly::symbol(Symbol::new(name)));
    let line = DividedDifferences::new(&["a", "b"].map(symbol), &["p", "q"].map(symbol))?;
    println!("{}", text(&newton_expr(&line.newton_form(), &Symbol::new("t"))));

    // A natural spline through points of the plane, with parameters by chord lengths.
    let points: Vec<Vec<Rational>> =
        [[0, 0], [3, 4], [9, 12], [9, 0]].iter().map(|p| p.map(integer).to_vec()).collect();
    let chord = parameters(&points, Parameterization::Chord, Scale::Unit, None)?;
    println!("parameters: {}", list(&chord.values));
    let spline = CubicSpline::by_moments(&chord.values, &points, Ends::natural())?;
    println!("moments:");
    for moment in spline.moments() {
        println!("  ({})", list(moment));
    }
    assert_eq!(spline.system().solve()?, spline.moments());

    // The straight line closest to four points, by its Bézier ordinates over [0, 3].
    let options = FitOptions {
        basis: Basis::Bernstein(Interval::new(integer(0), integer(3))?),
        ..FitOptions::default()
    };
    let fit = fit_polynomial(&[0, 1, 2, 3].map(integer), &[0, 1, 1, 2].map(integer), 1, options)?;
    assert_eq!(fit.power, [rational(1, 10), rational(3, 5)]);
    println!("ordinates {}, squared norm {}", list(&fit.solution.coefficients), fit.solution.squared_norm);
    Ok(())
}

fn list<'a>(numbers: impl IntoIterator<Item = &'a Rational>) -> String {
    numbers.into_iter().map(Rational::to_string).collect::<Vec<_>>().join(", ")
}
