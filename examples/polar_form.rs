//! From a polynomial to its polar form: values, partial values, derivatives, Bézier points.
#![allow(clippy::print_stdout)]

use polarform::blossom::{Argument, Method, PolarError, PolarForm};
use polarform::interval::Interval;
use polarform::number::{Rational, integer, rational};
use polarform::poly::Poly;

fn main() -> Result<(), PolarError> {
    // F(t) = t^3 + 3t^2 + 5t + 1
    let polynomial = Poly::from_coefficients([1, 5, 3, 1].map(integer).to_vec());
    let f = PolarForm::new(polynomial.coefficients());

    println!("{f}");

    // Points give values; equal points give values of F.
    println!("f(0, 1, 2) = {}", f.value(&[0, 1, 2].map(integer))?);
    let half = rational(1, 2);
    let diagonal = f.value(&[half.clone(), half.clone(), half.clone()])?;
    assert_eq!(diagonal, polynomial.value(&half));
    println!("f(1/2, 1/2, 1/2) = F(1/2) = {diagonal}");

    // A unit vector for one argument gives a third of the derivative: F'(t) = 3 f(t, t, 1̂).
    let t = integer(2);
    let slope =
        f.value(&[Argument::Point(t.clone()), Argument::Point(t.clone()), Argument::Vector(integer(1))])?
            * integer(3);
    assert_eq!(slope, polynomial.derivative().value(&t));
    println!("F'(2) = 3 f(2, 2, 1^) = {slope}");

    // Putting in one argument leaves a polar form of degree 2.
    let rest = f.partial(&[Argument::Point(integer(1))])?;
    println!("f(1, 0, 1) = {}", rest.value(&[0, 1].map(integer))?);

    // The Bézier points over [0, 1] are f(0,0,0), f(0,0,1), f(0,1,1), f(1,1,1).
    let points = f.bezier_points(&Interval::unit());
    let shown: Vec<String> = points.iter().map(Rational::to_string).collect();
    println!("Bézier points: {}", shown.join(", "));
    assert_eq!(PolarForm::from_bezier_points(&points)?, f);

    // Six derivations, one result.
    for method in Method::ALL {
        assert_eq!(f.derive(method, &integer(7)).form, f, "{}", method.name());
    }
    Ok(())
}
