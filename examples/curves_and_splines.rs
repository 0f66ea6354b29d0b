//! Bézier curves and B-splines as blossoms: exact values, labels, insertion, joins.
//!
//! Run with `cargo run --example curves_and_splines`.
#![allow(clippy::print_stdout)]

use polarform::curve::{BezierCurve, Interval, continuity_at, joining_conditions};
use polarform::number::{Rational, integer, rational};
use polarform::spline::{BSpline, KnotVector};

fn points(list: &[[i64; 2]]) -> Vec<Vec<Rational>> {
    list.iter().map(|point| point.map(integer).to_vec()).collect()
}

fn show(point: &[Rational]) -> String {
    format!("({}, {})", point[0], point[1])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let curve = BezierCurve::new(points(&[[0, 0], [1, 2], [3, 2], [4, 0]]), Interval::unit())?;
    println!("F(1/3) = {}", show(&curve.value(&rational(1, 3))));
    let (left, right) = curve.subdivide(&rational(1, 2))?;
    println!("the halves meet in {}", show(&right.points()[0]));
    println!("joined C^{}", continuity_at(&left, &right, &rational(1, 2))?.order.unwrap_or(0));

    // A spline: its control points are polar values at consecutive knots.
    let knots = KnotVector::clamped(3, &[integer(1), integer(2)], &Interval::new(integer(0), integer(3))?)?;
    let spline = BSpline::new(knots, points(&[[0, 0], [1, 3], [3, 3], [4, 0], [6, 0], [7, 2]]))?;
    for (i, point) in spline.points().iter().enumerate() {
        let label: Vec<String> = spline.knots().label(i).iter().map(ToString::to_string).collect();
        println!("f({}) = {}", label.join(", "), show(point));
    }

    // A knot goes in and out again without a change of the curve.
    let finer = spline.insert(&rational(3, 2))?;
    assert_eq!(finer.value(&rational(5, 4))?, spline.value(&rational(5, 4))?);
    assert_eq!(finer.remove(&rational(3, 2), 1)?, Ok(spline.clone()));
    let defect = spline.remove(&integer(1), 1)?.expect_err("a knot of its own");
    println!("the knot 1 stays: the derivative of order {} jumps by {}", defect.order, show(&defect.jump));

    // Its Bézier pieces meet C^2.
    let pieces = spline.bezier_pieces();
    let conditions = joining_conditions(&pieces[0], &pieces[1], 3)?;
    println!("{} of the conditions for C^3 hold", conditions.iter().filter(|c| c.holds()).count());
    Ok(())
}
