//! Splines as text: the calls by which the query language makes them.

use std::fmt::{Display, Formatter, Result};

use super::{BSpline, KnotVector, RationalSpline, RationalSplineSurface, SplineSurface};
use crate::math::curve::display;
use crate::math::ring::Field;

/// `[t_0, t_1, …]`
impl<C: Display> Display for KnotVector<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        display::list(f, &self.knots, |f, knot| Display::fmt(knot, f))
    }
}

fn opened<C: Field + Display>(f: &mut Formatter<'_>, knots: &KnotVector<C>) -> Result {
    write!(f, "bspline({}, {knots}, ", knots.degree())
}

/// `bspline(n, [t_0, …], [d_0, …])`
impl<C: Field + Display> Display for BSpline<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        opened(f, self.knots())?;
        display::points(f, self.points())?;
        f.write_str(")")
    }
}

/// As for a polynomial spline, with `weights=[…]`; with `homogeneous=1` and the control vectors if one
/// has weight 0.
impl<C: Field + Display> Display for RationalSpline<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let spline = self.homogeneous();
        opened(f, spline.knots())?;
        display::weighted(f, self.points(), &self.weights(), spline.points(), |_| Ok(()))?;
        f.write_str(")")
    }
}

fn opened_surface<C: Field + Display>(f: &mut Formatter<'_>, surface: &SplineSurface<C>) -> Result {
    let (u, v) = surface.knots();
    write!(f, "spline_surface({}, {}, {u}, {v}, ", u.degree(), v.degree())
}

/// `spline_surface(m, n, [u_0, …], [v_0, …], [[d_00, …], …])`
impl<C: Field + Display> Display for SplineSurface<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        opened_surface(f, self)?;
        display::net(f, self.net())?;
        f.write_str(")")
    }
}

/// As for a polynomial surface, with `weights=[[…], …]`; with `homogeneous=1` and the control vectors if one has
/// weight 0.
impl<C: Field + Display> Display for RationalSplineSurface<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let surface = self.homogeneous();
        opened_surface(f, surface)?;
        display::weighted_net(f, self.points(), &self.weights(), surface.net(), |_| Ok(()))?;
        f.write_str(")")
    }
}

debug_by_text!(BSpline, KnotVector, RationalSpline, RationalSplineSurface, SplineSurface);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::interval::Interval;
    use crate::math::number::integer as z;

    #[test]
    fn as_the_language_writes_them() {
        let knots = KnotVector::clamped(1, &[], &Interval::unit()).unwrap();
        assert_eq!(format!("{knots} {knots:?}"), "[0, 0, 1, 1] KnotVector([0, 0, 1, 1])");
        let net = || vec![vec![[z(0)], [z(1)]], vec![[z(2)], [z(3)]]];
        let s = SplineSurface::new(knots.clone(), knots.clone(), net()).unwrap();
        let text = "spline_surface(1, 1, [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]])";
        assert_eq!(format!("{s} {s:?}"), format!("{text} SplineSurface({text})"));
        let weights = [[1, 1], [1, 2]].map(|row| row.map(z).to_vec()).to_vec();
        let rational = RationalSplineSurface::new(knots.clone(), knots, net(), weights).unwrap();
        let weighted = text.replace("]])", "]], weights=[[1, 1], [1, 2]])");
        assert_eq!(rational.to_string(), weighted);
    }
}
