//! Curves and surfaces as values: how their coordinates are read, and their way back to a formula.

use num_traits::{One, Zero};

use super::{Value, polynomial_expr};
use crate::curve::{BezierCurve, CurveError, Point};
use crate::expr::{Expr, Kind, Rel, Sign, Term};
use crate::poly::Fraction;
use crate::ring::{Field, Ring};
use crate::spline::BSpline;

/// How the coordinates of control points are to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Form {
    /// Control points were given as single numbers or symbols, and values are such.
    pub scalar: bool,
    /// The last coordinate is a weight: the point is the others divided by it.
    pub rational: bool,
}

/// A curve or surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A Bézier curve.
    Bezier(BezierCurve<Fraction>, Form),
    /// A B-spline curve.
    Spline(BSpline<Fraction>, Form),
}

impl Form {
    /// A point of homogeneous or ordinary coordinates as a value.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`] if its weight is 0.
    pub fn value(self, mut point: Point<Fraction>) -> Result<Value, CurveError> {
        if self.rational {
            let weight = point.pop().and_then(|w| w.inverse()).ok_or(CurveError::ZeroDenominator)?;
            point.iter_mut().for_each(|x| *x *= weight.clone());
        }
        Ok(self.plain(point))
    }

    /// A point as it is, its weight too.
    pub fn plain(self, mut point: Point<Fraction>) -> Value {
        match (self.scalar, point.len()) {
            (true, 1) => Value::Scalar(point.swap_remove(0)),
            _ => Value::List(point.into_iter().map(Value::Scalar).collect()),
        }
    }

    /// Control points and, for a rational form, their weights; `None` if a weight is 0, so that
    /// the homogeneous points have to be shown.
    pub fn split(self, points: &[Point<Fraction>]) -> Option<(Vec<Value>, Vec<Fraction>)> {
        let values = points.iter().map(|point| self.value(point.clone()).ok()).collect::<Option<_>>()?;
        let weights = match self.rational {
            true => points.iter().map(|point| point[point.len() - 1].clone()).collect(),
            false => Vec::new(),
        };
        Some((values, weights))
    }
}

/// Coordinates multiplied by the weight, which becomes the last one.
pub fn homogeneous(point: &[Fraction], weight: &Fraction) -> Point<Fraction> {
    point.iter().map(|x| x.times(weight)).chain(std::iter::once(weight.clone())).collect()
}

/// `name = value`, as an argument.
fn named(name: &str, value: Expr) -> Expr {
    Expr::relation(Expr::name(name), Rel::Eq, value)
}

fn list(items: impl IntoIterator<Item = Expr>) -> Expr {
    Kind::List(items.into_iter().collect()).into()
}

fn scalars(items: &[Fraction]) -> Expr {
    list(items.iter().map(polynomial_expr))
}

impl Geometry {
    /// The kind of object, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Geometry::Bezier(_, form) if form.rational => "a rational Bézier curve",
            Geometry::Bezier(..) => "a Bézier curve",
            Geometry::Spline(_, form) if form.rational => "a rational B-spline curve",
            Geometry::Spline(..) => "a B-spline curve",
        }
    }

    /// How coordinates are read.
    pub fn form(&self) -> Form {
        match self {
            Geometry::Bezier(_, form) | Geometry::Spline(_, form) => *form,
        }
    }

    /// All control points in one list.
    pub fn control_points(&self) -> Vec<Point<Fraction>> {
        match self {
            Geometry::Bezier(curve, _) => curve.points().to_vec(),
            Geometry::Spline(spline, _) => spline.points().to_vec(),
        }
    }

    /// The call that makes it, in the plain language.
    pub fn to_expr(&self) -> Expr {
        match self {
            Geometry::Bezier(curve, form) => {
                let mut arguments = Vec::new();
                let (a, b) = curve.interval();
                let extra = self.points_argument(curve.points(), *form, &mut arguments);
                if !(a.is_zero() && b.is_one()) {
                    arguments.extend([polynomial_expr(a), polynomial_expr(b)]);
                }
                arguments.extend(extra);
                Expr::apply(Expr::name("bezier"), arguments)
            }
            Geometry::Spline(spline, form) => {
                let degree = Expr::int(spline.degree() as i64);
                let mut arguments = vec![degree, scalars(spline.knots().knots())];
                let extra = self.points_argument(spline.points(), *form, &mut arguments);
                arguments.extend(extra);
                Expr::apply(Expr::name("bspline"), arguments)
            }
        }
    }

    /// Adds the control points to the arguments of a call; the weights come after the rest.
    fn points_argument(
        &self,
        points: &[Point<Fraction>],
        form: Form,
        arguments: &mut Vec<Expr>,
    ) -> Option<Expr> {
        match form.split(points) {
            Some((values, weights)) => {
                arguments.push(list(values.iter().map(Value::to_expr)));
                form.rational.then(|| named("weights", scalars(&weights)))
            }
            None => {
                arguments.push(list(points.iter().map(|point| scalars(point))));
                Some(named("homogeneous", Expr::int(1)))
            }
        }
    }

    /// The object as a formula in control points and basis functions, for reading.
    pub fn display_expr(&self) -> Expr {
        let t = || Expr::name("t");
        match self {
            Geometry::Bezier(curve, form) => {
                let n = curve.degree() as i64;
                let (a, b) = curve.interval();
                let local = if a.is_zero() && b.is_one() {
                    t()
                } else {
                    let variable =
                        Fraction::from(crate::poly::MultiPoly::symbol(crate::poly::Symbol::new("t")));
                    let width = b.minus(a).inverse().expect("the ends differ");
                    polynomial_expr(&variable.minus(a).times(&width))
                };
                let basis = |i: usize| {
                    let index = Kind::Subscript(Box::new(Expr::name("B")), vec![Expr::int(i as i64)]);
                    Expr::apply(Expr::from(index).power(Expr::int(n)), vec![local.clone()])
                };
                self.combination(curve.points(), *form, &basis)
            }
            Geometry::Spline(spline, form) => {
                let n = spline.degree() as i64;
                let basis = |i: usize| {
                    let index = Kind::Subscript(Box::new(Expr::name("N")), vec![Expr::int(i as i64)]);
                    Expr::apply(Expr::from(index).power(Expr::int(n)), vec![t()])
                };
                let knots = spline.knots().knots();
                let last = knots.len() as i64 - 1;
                let name = |i: i64| Expr::from(Kind::Subscript(Box::new(t()), vec![Expr::int(i)]));
                let tuple: Expr = Kind::Tuple(vec![name(0), Kind::Ellipsis.into(), name(last)]).into();
                let values = Kind::Tuple(knots.iter().map(polynomial_expr).collect()).into();
                let body = self.combination(spline.points(), *form, &basis);
                Kind::Sequence(vec![body, Expr::relation(tuple, Rel::Eq, values)]).into()
            }
        }
    }

    /// Σ point · basis, over Σ weight · basis for a rational form.
    fn combination(&self, points: &[Point<Fraction>], form: Form, basis: &dyn Fn(usize) -> Expr) -> Expr {
        let Some((values, weights)) = form.split(points) else {
            let terms = points.iter().enumerate().map(|(i, point)| Some(vec![scalars(point), basis(i)]));
            return summed(terms);
        };
        let weight = |i: usize| weights.get(i).filter(|w| !w.is_one()).map(|w| bracketed(polynomial_expr(w)));
        let term = |(i, value): (usize, &Value)| {
            let point = match value.as_scalar() {
                Some(x) if x.is_zero() => return None,
                Some(x) if x.is_one() => None,
                _ => Some(bracketed(value.to_expr())),
            };
            Some(weight(i).into_iter().chain(point).chain([basis(i)]).collect())
        };
        let top = summed(values.iter().enumerate().map(term));
        if !form.rational {
            return top;
        }
        let bottom = (0..values.len()).map(|i| Some(weight(i).into_iter().chain([basis(i)]).collect()));
        top.over(summed(bottom))
    }
}

fn bracketed(expr: Expr) -> Expr {
    if matches!(expr.kind, Kind::Add(_)) { expr.grouped() } else { expr }
}

/// The sum of products; 0 if there are none.
fn summed(terms: impl Iterator<Item = Option<Vec<Expr>>>) -> Expr {
    let plus = |factors| Term { sign: Sign::Plus, expr: Expr::product(factors) };
    let terms: Vec<Term> = terms.flatten().map(plus).collect();
    if terms.is_empty() { Expr::int(0) } else { Expr::sum(terms) }
}
