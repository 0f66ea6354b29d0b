//! Surfaces: a tensor-product patch, its normal, a triangular patch, an octant of a sphere.
//!
//! Run with `cargo run --example surfaces`.
#![allow(clippy::print_stdout)]

use polarform::curve::{CurveError, Interval, Scheme, TensorPatch, Triangle, TrianglePatch, sphere_octant};
use polarform::number::{Rational, integer, rational};

fn main() -> Result<(), CurveError> {
    let net = [[[0, 0, 0], [0, 2, 1], [0, 4, 0]], [[2, 0, 1], [2, 2, 3], [2, 4, 1]]];
    let net = net.map(|row| row.map(|point| point.map(integer).to_vec()).to_vec()).to_vec();
    let patch = TensorPatch::new(net, Interval::unit(), Interval::unit())?;
    let (u, v) = (rational(1, 2), rational(1, 3));

    // De Casteljau first in u or first in v: one point.
    let in_u = patch.tableau(&u, &v, Scheme::UFirst)?;
    let in_v = patch.tableau(&u, &v, Scheme::VFirst)?;
    assert_eq!(in_u.last(), in_v.last());
    println!("F(1/2, 1/3) = {:?}", shown(&patch.value(&u, &v)));
    println!("the normal there is {:?}", shown(&patch.normal()?.value(&u, &v)));

    // The same surface as a triangular patch of degree 3, and back.
    let triangle = patch.to_triangle(Triangle::unit())?;
    assert_eq!(triangle.value(&[u.clone(), v.clone()])?, patch.value(&u, &v));
    println!("as a triangular patch it has {} points", triangle.points().len());

    let heights = [0, 1, 1, 0, 1, 0].map(|h| vec![integer(h)]).to_vec();
    let dome = TrianglePatch::new(heights, Triangle::unit())?;
    println!("height of the dome in the middle: {}", dome.value(&[rational(1, 3), rational(1, 3)])?[0]);

    let octant = sphere_octant(&[0, 0, 0].map(integer), &integer(1))?;
    let point = octant.value(&u, &v)?;
    let radius: Rational = point.iter().map(|x| x * x).sum();
    println!("{:?} has distance {radius} from the centre", shown(&point));
    Ok(())
}

fn shown(point: &[Rational]) -> Vec<String> {
    point.iter().map(ToString::to_string).collect()
}
