//! A_n, raising the degree, and changing the basis, also with symbolic interval ends.
#![allow(clippy::print_stdout)]

use nalgebra::{DMatrix, DVector};
use polarform::basis::{self, Basis};
use polarform::interval::Interval;
use polarform::linalg;
use polarform::number::{Rational, integer, rational};
use polarform::poly::{Fraction, MultiPoly, Symbol};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A_3 turns Bézier points into power coefficients.
    let a = basis::bernstein_to_power(3);
    println!("A_3 ={a}");
    assert_eq!(linalg::inverse(&a).as_ref(), Ok(&basis::power_to_bernstein(3)));

    let points = DVector::from_vec([0, 1, 3, 4].map(integer).to_vec());
    println!("Bézier points 0, 1, 3, 4 have the power coefficients{}", &a * &points);

    // The same curve with one more Bézier point.
    let raise = basis::raising(3, 4)?;
    println!("raised to degree 4:{}", &raise * &points);

    // Values at 0, 1/2, 1 to Bézier points over [0, 1].
    let nodes = Basis::Lagrange(vec![integer(0), rational(1, 2), integer(1)]);
    let unit = Basis::Bernstein(Interval::unit());
    let change: DMatrix<Rational> = basis::change_of_basis(2, &nodes, &unit)?;
    println!("values at 0, 1/2, 1 to Bézier points:{change}");

    // The interval may be symbolic.
    let symbol = |name: &str| Fraction::from(MultiPoly::symbol(Symbol::new(name)));
    let interval = Basis::Bernstein(Interval::new(symbol("r"), symbol("s"))?);
    let change = basis::change_of_basis(1, &Basis::Power, &interval)?;
    println!("powers to Bézier points over [r, s]:{change}");
    Ok(())
}
