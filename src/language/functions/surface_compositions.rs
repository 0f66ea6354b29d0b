//! Curves on surfaces, and patches of patches.

use super::gives::Gives;
use super::on_surface::not_for;
use super::parameter::{SURFACE, required};
use super::record::Variant;
use super::sections::is_surface;
use super::surface_schemes::surface_coordinates;
use super::surfaces::tensor;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, division_by_zero};
use crate::language::ops::formula::coefficients_in;
use crate::language::ops::geometry::bezier;
use crate::language::ops::takes::Takes;
use crate::language::value::{Geometry, Value};
use crate::math::curve::{BezierCurve, Interval, Net, Point, TensorPatch};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

pub(super) const COMPOSE: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required(
            "G",
            Takes::OneOf(&[Takes::Curve, Takes::Surface, Takes::Coordinates]),
            "a polynomial curve or patch of the domain, or two formulas in t or in u and v",
        ),
    ],
    Gives::Any,
    compose,
);

/// s(G(t)), a curve on the surface, or s(G(u, v)).
fn compose(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    if is_surface(args.value(1)?) { patch_of_patch(args, &geometry) } else { curve_on_patch(args, &geometry) }
}

/// The (homogeneous) coordinates of a patch at two formulas.
fn value_at(geometry: &Geometry, args: &Arguments, inner: &[Fraction]) -> Result<Vec<Fraction>> {
    let [u, v] = inner else {
        let message = format!("a curve or patch of the domain has two coordinates, this one {}", inner.len());
        return Err(Diagnostic::error(Code::Shape, message).at(args.span(1)).hint("such as [t, t^2]"));
    };
    if [u, v].iter().any(|f| f.as_polynomial().is_none()) {
        let error = Diagnostic::error(Code::Type, "this is rational: polynomials are needed inside");
        return Err(error
            .at(args.span(1))
            .hint("homogeneous(c) is the polynomial curve of its homogeneous coordinates"));
    }
    match geometry {
        Geometry::Patch(patch, _) => Ok(patch.value(u, v).into()),
        Geometry::Triangle(patch, _) => {
            patch.value(&[u.clone(), v.clone()]).map(Vec::from).map_err(curve_error).at(args.span(0))
        }
        other => Err(not_for(other, args)),
    }
}

/// Degrees of the composition in one parameter that occurs in u and v with these degrees.
fn formal_degree(geometry: &Geometry, in_u: usize, in_v: usize) -> usize {
    match geometry {
        Geometry::Patch(patch, _) => patch.degrees().0 * in_u + patch.degrees().1 * in_v,
        Geometry::Triangle(patch, _) => patch.degree() * in_u.max(in_v),
        _ => 0,
    }
}

fn curve_on_patch(args: &Arguments, geometry: &Geometry) -> Evaluated {
    let (power, interval) = match args.value(1)? {
        Value::List(items) if items.iter().all(|item| item.as_scalar().is_some()) => {
            let formulas = args.scalars(1)?;
            let sum = formulas.iter().fold(Fraction::zero(), |sum, f| sum + f.clone());
            let t = crate::language::ops::formula::variable_of(&sum, args.variable()?).at(args.span(1))?;
            let lists = formulas.iter().map(|f| coefficients_in(f, &t)).collect::<Result<Vec<_>>>();
            (lists.at(args.span(1))?, Interval::unit())
        }
        _ => {
            let (curve, form) = args.bezier(1)?;
            if form.rational {
                let error =
                    Diagnostic::error(Code::Type, "this is rational: a polynomial curve is needed inside");
                return Err(error.at(args.span(1)).hint("rational patches may stand outside"));
            }
            (curve.power(), curve.interval().clone())
        }
    };
    // A letter of its own: control points may have t.
    let t = Symbol::new("\u{25e6}");
    let letter = Fraction::from(MultiPoly::symbol(t.clone()));
    let inner: Vec<Fraction> =
        power.iter().map(|list| Coefficients::new(list.clone()).value(&letter)).collect();
    let coordinates = value_at(geometry, args, &inner)?;
    let degree = |k: usize| Coefficients::new(power[k].clone()).degree().unwrap_or(0);
    let length = formal_degree(geometry, degree(0), degree(1)) + 1;
    let lists = coordinates.iter().map(|f| {
        let mut list = coefficients_in(f, &t)?;
        list.resize(length.max(list.len()), Fraction::zero());
        Ok(list)
    });
    let lists = lists.collect::<Result<Vec<_>>>().at(args.span(1))?;
    let curve = BezierCurve::from_power(&lists, interval).map_err(curve_error)?;
    Ok(bezier(curve, geometry.form()))
}

fn patch_of_patch(args: &Arguments, geometry: &Geometry) -> Evaluated {
    let letters = ["u", "v"].map(Symbol::new);
    let (u_range, v_range) = match args.value(1)? {
        Value::Geometry(inner) => match &**inner {
            Geometry::Patch(patch, form) if !form.rational => (patch.u().clone(), patch.v().clone()),
            other => {
                let error =
                    Diagnostic::error(Code::Type, format!("this is not offered for {} inside", other.kind()));
                return Err(error
                    .at(args.span(1))
                    .hint("a polynomial tensor-product patch, or two formulas in u and v"));
            }
        },
        _ => (Interval::unit(), Interval::unit()),
    };
    // Letters of their own: control points may have u and v.
    let own = [1, 2].map(|k| Symbol::new("\u{25e6}").numbered(k));
    let moved: Vec<(Symbol, Fraction)> = letters
        .into_iter()
        .zip(&own)
        .map(|(x, y)| (x, Fraction::from(MultiPoly::symbol(y.clone()))))
        .collect();
    let inner = surface_coordinates(args, 1)?
        .iter()
        .map(|f| f.substitute(&moved))
        .collect::<std::result::Result<Vec<_>, _>>();
    let inner = inner.map_err(|_| division_by_zero()).at(args.span(1))?;
    let letters = own;
    let coordinates = value_at(geometry, args, &inner)?;
    let degree = |k: usize, x: &Symbol| inner[k].numerator().degree_in(x) as usize;
    let size = |x: &Symbol| formal_degree(geometry, degree(0, x), degree(1, x)) + 1;
    let (height, width) = (size(&letters[0]), size(&letters[1]));
    crate::budget::charge_terms((height as u64).saturating_mul(width as u64));
    let zero: Point<Fraction> = vec![Fraction::zero(); coordinates.len()].into();
    let mut grid: Net<Fraction> = vec![vec![zero; width]; height];
    for (k, f) in coordinates.iter().enumerate() {
        for (i, in_u) in coefficients_in(f, &letters[0]).at(args.span(0))?.iter().enumerate() {
            for (j, c) in coefficients_in(in_u, &letters[1]).at(args.span(0))?.into_iter().enumerate() {
                grid[i][j][k] = c;
            }
        }
    }
    let patch = TensorPatch::from_power_coefficients(grid, u_range, v_range).map_err(curve_error)?;
    Ok(tensor(patch, geometry.form()))
}
