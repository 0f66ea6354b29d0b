//! Curves and surfaces as values: how their coordinates are read, and their way back to a formula.

use num_traits::{One, Zero};

use super::piecewise::free_parameter;
use super::{Value, polynomial_expr, symbol_expr};
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::language::lexicon::families;
use crate::math::curve::{BezierCurve, CurveError, Interval, Point, TensorPatch, TrianglePatch, indices};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::{Field, Ring};
use crate::math::spline::{BSpline, SplineSurface};

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
    /// A tensor-product Bézier patch.
    Patch(TensorPatch<Fraction>, Form),
    /// A triangular Bézier patch.
    Triangle(TrianglePatch<Fraction>, Form),
    /// A tensor-product B-spline surface.
    Surface(SplineSurface<Fraction>, Form),
}

impl Form {
    /// A point, or a vector, of homogeneous or ordinary coordinates as a value.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`] if its weight is 0.
    pub fn value(self, point: impl Into<Vec<Fraction>>) -> Result<Value, CurveError> {
        let mut point = point.into();
        if self.rational {
            let weight = point.pop().and_then(|w| w.inverse()).ok_or(CurveError::ZeroDenominator)?;
            point.iter_mut().for_each(|x| *x *= weight.clone());
        }
        Ok(self.plain(point))
    }

    /// A point as it is, its weight too.
    pub fn plain(self, point: impl Into<Vec<Fraction>>) -> Value {
        let mut point = point.into();
        match (self.scalar, point.len()) {
            (true, 1) => Value::Scalar(point.swap_remove(0)),
            _ => Value::point(point.into_iter().map(Value::Scalar).collect()),
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

/// (x, y); a single coordinate stays in its list.
fn point(coordinates: &[Fraction]) -> Expr {
    Value::point(coordinates.iter().cloned().map(Value::Scalar).collect()).to_expr()
}

impl Geometry {
    /// The kind of object, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Geometry::Bezier(_, form) if form.rational => "a rational Bézier curve",
            Geometry::Bezier(..) => "a Bézier curve",
            Geometry::Spline(_, form) if form.rational => "a rational B-spline curve",
            Geometry::Spline(..) => "a B-spline curve",
            Geometry::Patch(_, form) if form.rational => "a rational tensor-product patch",
            Geometry::Patch(..) => "a tensor-product patch",
            Geometry::Triangle(_, form) if form.rational => "a rational triangular patch",
            Geometry::Triangle(..) => "a triangular patch",
            Geometry::Surface(_, form) if form.rational => "a rational B-spline surface",
            Geometry::Surface(..) => "a B-spline surface",
        }
    }

    /// How coordinates are read.
    pub fn form(&self) -> Form {
        match self {
            Geometry::Bezier(_, form)
            | Geometry::Spline(_, form)
            | Geometry::Patch(_, form)
            | Geometry::Triangle(_, form)
            | Geometry::Surface(_, form) => *form,
        }
    }

    /// Whether it has two parameters.
    pub fn is_surface(&self) -> bool {
        !matches!(self, Geometry::Bezier(..) | Geometry::Spline(..))
    }

    /// All control points in one list.
    pub fn control_points(&self) -> Vec<Point<Fraction>> {
        match self {
            Geometry::Bezier(curve, _) => curve.points().to_vec(),
            Geometry::Spline(spline, _) => spline.points().to_vec(),
            Geometry::Patch(patch, _) => patch.net().concat(),
            Geometry::Triangle(patch, _) => patch.points().to_vec(),
            Geometry::Surface(surface, _) => surface.net().concat(),
        }
    }

    /// The call that makes it, in the plain language.
    pub fn to_expr(&self) -> Expr {
        match self {
            Geometry::Bezier(curve, form) => {
                let mut arguments = Vec::new();
                let (a, b) = curve.interval().ends();
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
            Geometry::Patch(patch, form) => {
                let mut arguments = Vec::new();
                let extra = net_argument(patch.net(), *form, &mut arguments);
                if !(is_unit(patch.u()) && is_unit(patch.v())) {
                    arguments.extend([patch.u(), patch.v()].map(interval_expr));
                }
                arguments.extend(extra);
                Expr::apply(Expr::name("patch"), arguments)
            }
            Geometry::Triangle(patch, form) => {
                let mut arguments = Vec::new();
                let extra = self.points_argument(patch.points(), *form, &mut arguments);
                if patch.triangle() != &crate::math::curve::Triangle::unit() {
                    arguments.push(list(patch.triangle().corners().iter().map(|corner| scalars(corner))));
                }
                arguments.extend(extra);
                Expr::apply(Expr::name("triangle_patch"), arguments)
            }
            Geometry::Surface(surface, form) => {
                let (u, v) = surface.knots();
                let degree = |n: usize| Expr::int(n as i64);
                let mut arguments =
                    vec![degree(u.degree()), degree(v.degree()), scalars(u.knots()), scalars(v.knots())];
                let extra = net_argument(surface.net(), *form, &mut arguments);
                arguments.extend(extra);
                Expr::apply(Expr::name("spline_surface"), arguments)
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
                arguments.push(list(points.iter().map(|point| self::point(point))));
                Some(named("homogeneous", Expr::int(1)))
            }
        }
    }

    /// How the parameter of a curve is called: t, unless an end, a knot or a point is called so.
    pub fn parameter(&self) -> Symbol {
        match self {
            Geometry::Bezier(curve, _) => {
                let (a, b) = curve.interval().ends();
                free_parameter(curve.points().iter().flatten().chain([a, b]))
            }
            Geometry::Spline(spline, _) => {
                free_parameter(spline.points().iter().flatten().chain(spline.knots().knots()))
            }
            _ => Symbol::new("t"),
        }
    }

    /// The object as a formula in control points and basis functions, for reading.
    pub fn display_expr(&self) -> Expr {
        self.display_expr_in(&self.parameter())
    }

    /// The same with a letter for the parameter of a curve.
    pub fn display_expr_in(&self, parameter: &Symbol) -> Expr {
        let t = || symbol_expr(parameter);
        match self {
            Geometry::Bezier(curve, form) => {
                let (a, b) = curve.interval().ends();
                let interval = Interval::new(a.clone(), b.clone()).expect("the ends differ");
                let basis = |i: usize| {
                    family(families::BERNSTEIN, &[i], curve.degree(), vec![local(&interval, parameter)])
                };
                self.combination(curve.points(), *form, &basis)
            }
            Geometry::Spline(spline, form) => {
                let basis = |i: usize| family(families::SPLINE, &[i], spline.degree(), vec![t()]);
                let body = self.combination(spline.points(), *form, &basis);
                Kind::Sequence(vec![body, knots_expr(&parameter.to_string(), spline.knots().knots())]).into()
            }
            Geometry::Patch(patch, form) => {
                let (m, n) = patch.degrees();
                let basis = |k: usize| {
                    let (i, j) = (k / (n + 1), k % (n + 1));
                    let left =
                        family(families::BERNSTEIN, &[i], m, vec![local(patch.u(), &Symbol::new("u"))]);
                    Expr::product(vec![
                        left,
                        family(families::BERNSTEIN, &[j], n, vec![local(patch.v(), &Symbol::new("v"))]),
                    ])
                };
                self.combination(&patch.net().concat(), *form, &basis)
            }
            Geometry::Triangle(patch, form) => {
                let places = indices(patch.degree());
                let point = ["u", "v", "w"].map(Expr::name).to_vec();
                let basis = |k: usize| family(families::BERNSTEIN, &places[k], patch.degree(), point.clone());
                self.combination(patch.points(), *form, &basis)
            }
            Geometry::Surface(surface, form) => {
                let (u, v) = surface.knots();
                let columns = v.count();
                let basis = |k: usize| {
                    let left = family(families::SPLINE, &[k / columns], u.degree(), vec![Expr::name("u")]);
                    Expr::product(vec![
                        left,
                        family(families::SPLINE, &[k % columns], v.degree(), vec![Expr::name("v")]),
                    ])
                };
                let body = self.combination(&surface.net().concat(), *form, &basis);
                let knots = [("u", u), ("v", v)].map(|(name, knots)| knots_expr(name, knots.knots()));
                Kind::Sequence([vec![body], knots.to_vec()].concat()).into()
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
                Some(_) => Some(bracketed(value.to_expr())),
                None => Some(as_point(value.to_expr())),
            };
            // 2 times 1/2 would read as a mixed number.
            if let (Some(x), Some(w)) = (value.as_scalar(), weights.get(i)) {
                let product = x.times(w);
                let factor = (!product.is_one()).then(|| bracketed(polynomial_expr(&product)));
                return Some(factor.into_iter().chain([basis(i)]).collect());
            }
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

/// (t_0, …, t_k) = (…)
fn knots_expr(name: &str, knots: &[Fraction]) -> Expr {
    let indexed =
        |i: usize| Expr::from(Kind::Subscript(Box::new(Expr::name(name)), vec![Expr::int(i as i64)]));
    let names = vec![indexed(0), Kind::Ellipsis.into(), indexed(knots.len() - 1)];
    let values = Kind::Tuple(knots.iter().map(polynomial_expr).collect()).into();
    Expr::relation(Kind::Tuple(names).into(), Rel::Eq, values)
}

fn is_unit(interval: &Interval<Fraction>) -> bool {
    interval.start().is_zero() && interval.end().is_one()
}

fn interval_expr(interval: &Interval<Fraction>) -> Expr {
    list([interval.start(), interval.end()].map(polynomial_expr))
}

/// The parameter relative to an interval: (u − a)/(b − a).
fn local(interval: &Interval<Fraction>, name: &Symbol) -> Expr {
    let variable = Fraction::from(crate::math::poly::MultiPoly::symbol(name.clone()));
    polynomial_expr(&interval.local(&variable))
}

/// B_{i,j,k}^n(…)
fn family(name: &str, lower: &[usize], degree: usize, arguments: Vec<Expr>) -> Expr {
    let indices = lower.iter().map(|&i| Expr::int(i as i64)).collect();
    let head = Kind::Subscript(Box::new(Expr::name(name)), indices);
    Expr::apply(Expr::from(head).power(Expr::int(degree as i64)), arguments)
}

/// The net as an argument of a call; the weights come after the rest.
fn net_argument(net: &[Vec<Point<Fraction>>], form: Form, arguments: &mut Vec<Expr>) -> Option<Expr> {
    let split: Option<Vec<_>> = net.iter().map(|row| form.split(row)).collect();
    match split {
        Some(rows) => {
            arguments.push(list(rows.iter().map(|(values, _)| list(values.iter().map(Value::to_expr)))));
            form.rational.then(|| named("weights", list(rows.iter().map(|(_, weights)| scalars(weights)))))
        }
        None => {
            arguments.push(list(net.iter().map(|row| list(row.iter().map(|point| self::point(point))))));
            Some(named("homogeneous", Expr::int(1)))
        }
    }
}

/// A point with round brackets, as it is written in a sum.
fn as_point(expr: Expr) -> Expr {
    match expr.kind {
        Kind::List(coordinates) => Kind::Tuple(coordinates).into(),
        _ => bracketed(expr),
    }
}

fn bracketed(expr: Expr) -> Expr {
    if matches!(expr.kind, Kind::Add(_)) { expr.grouped() } else { expr }
}

/// The sum of products; 0 if there are none.
fn summed(terms: impl Iterator<Item = Option<Vec<Expr>>>) -> Expr {
    let signed = |mut factors: Vec<Expr>| {
        // -B_0^1(t) rather than (-1) B_0^1(t)
        let negative = match factors.first().map(|first| &first.kind) {
            Some(Kind::Group(body)) => match &body.kind {
                Kind::Add(terms) if terms.len() == 1 && terms[0].sign == Sign::Minus => {
                    Some(terms[0].expr.clone())
                }
                _ => None,
            },
            _ => None,
        };
        let sign = if negative.is_some() { Sign::Minus } else { Sign::Plus };
        if let Some(magnitude) = negative {
            factors[0] = magnitude;
        }
        if sign == Sign::Minus && matches!(&factors[0].kind, Kind::Number(one) if one.is_one()) {
            factors.remove(0);
        }
        let flat = factors.into_iter().flat_map(|factor| match factor.kind {
            Kind::Mul(inner) => inner,
            _ => vec![factor],
        });
        Term { sign, expr: Expr::product(flat.collect()) }
    };
    let terms: Vec<Term> = terms.flatten().map(signed).collect();
    if terms.is_empty() { Expr::int(0) } else { Expr::sum(terms) }
}
