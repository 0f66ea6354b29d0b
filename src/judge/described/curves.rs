//! The curves that a section speaks of: by their control points, by a formula, by words.

use std::rc::Rc;

use crate::formula::{Expr, Kind};
use crate::judge::described::meanings::New;
use crate::judge::known::checker::Checker;
use crate::judge::known::found::Curve;
use crate::judge::model::Model;
use crate::judge::page::context::{Body, Definition, is_variable};
use crate::judge::page::object::{Declared, Object, RATIONAL, Sort};
use crate::judge::page::statement::{Place, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::values::evaluator::{self, evaluate_reading};
use crate::judge::written::names::{Head, bases, walk};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// So many curves of a section are looked at, the latest first.
const MOST_CURVES: usize = 3;

/// The letters of weights.
const WEIGHTS: [&str; 2] = ["w", "omega"];

/// A letter that no page has, for a curve without a name.
const CURVE: &str = "\u{25ab}";

impl Curve {
    /// A curve with a name, over [0, 1].
    pub(super) fn new(name: Expr, degree: Expr) -> Self {
        let interval = (Expr::int(0), Expr::int(1));
        Curve { name, degree, interval, points: None, object: None, segment: false }
    }
}

impl Curve {
    /// Whether its weights are given.
    pub fn has_weights(&self) -> bool {
        self.object.as_ref().is_some_and(|object| !object.weights.is_empty())
    }

    /// How many coordinates its points have, if all are given by them.
    pub fn dimension(&self) -> Option<usize> {
        let points = &self.object.as_ref()?.points;
        let count = points.first()?.items()?.len();
        points.iter().all(|point| point.items().is_some_and(|all| all.len() == count)).then_some(count)
    }
}

impl Checker {
    /// The curves of which the section gives a formula or control points, those of words first, then the latest.
    pub(in crate::judge) fn curves(&self, new: &New, right: &Expr, statement: &Statement) -> Vec<Curve> {
        let place = &statement.place;
        let mut found = self.curves_in_words(new, statement);
        found.extend(self.curves_by_formula(new, right, statement));
        let (spline, bernstein) =
            (statement.topics.has(Topic::Spline), statement.topics.has(Topic::Bernstein));
        let bezier = [
            Topic::BezierCurve,
            Topic::ControlPoints,
            Topic::Casteljau,
            Topic::Elevation,
            Topic::Subdivision,
        ];
        if bernstein || !spline && bezier.into_iter().any(|topic| statement.topics.has(topic)) {
            let told = |told: &Declared| {
                told.object.sort == Sort::Other(RATIONAL.into()) && place.knows(&told.place, false)
            };
            let rational = statement.topics.has(Topic::Rational) || self.context.objects.iter().any(told);
            found.extend(self.curves_by_points(new, place, rational));
        }
        // "If these are the first points of a quintic, then κ(0) = …"
        let degrees: Vec<i64> = statement.sentence.degrees().collect();
        if let (true, [degree]) = (new.arguments > 0, degrees.as_slice()) {
            found.retain(|curve| curve.degree.as_int().is_none_or(|own| own == *degree));
        }
        found.truncate(MOST_CURVES);
        found
    }

    /// "A cubic Bézier curve with the control points b_0, …, b_3"
    fn curves_in_words(&self, new: &New, statement: &Statement) -> Vec<Curve> {
        let place = &statement.place;
        let here = |declared: &&Declared| place.knows(&declared.place, declared.object.local);
        let curve = |declared: &Declared| {
            let object = &*declared.object;
            // The points p_i are no new points p_i; the curve p is another thing.
            let same = |head: Head| head.base == new.letter && (new.arguments == 0 || head.lower.is_empty());
            if object.names.iter().filter_map(Head::of).any(same) {
                return None;
            }
            let segment = object.sort == Sort::SplineCurve && object.uniform && object.interval.is_some();
            let points = match object.sort {
                // Those of a B-spline are no Bézier points.
                Sort::ControlPoints
                    if object.of.is_none()
                        && object.knots.is_empty()
                        && !statement.near.has(Topic::Spline)
                        && !statement.is_on_splines_only() =>
                {
                    &object.names
                }
                Sort::BezierCurve => &object.points,
                Sort::SplineCurve if segment || object.is_unnamed() && !object.knots.is_empty() => {
                    &object.points
                }
                _ => return None,
            };
            let degree = object.degree.clone().or_else(|| last_index(points))?;
            let own = match object.sort {
                Sort::ControlPoints => {
                    let weights = object.weights.clone();
                    Some(Object { weights, ..bezier_curve(points.clone(), &degree) })
                }
                _ if object.is_unnamed() => Some(Object {
                    names: vec![Expr::name(CURVE)],
                    degree: Some(degree.clone()),
                    ..object.clone()
                }),
                _ => None,
            };
            let name = if own.is_some() { Expr::name(CURVE) } else { object.names[0].clone() };
            let mut curve = Curve::new(name, degree);
            curve.interval =
                match (&object.interval, self.closed_intervals_beside(&declared.place).as_slice()) {
                    (Some(own), _) => own.clone(),
                    (None, []) => curve.interval,
                    // "x has over [0, 2] the control points …"
                    (None, [one]) if object.sort == Sort::ControlPoints => one.clone(),
                    (None, _) if object.sort == Sort::ControlPoints => return None,
                    (None, _) => curve.interval,
                };
            curve.points = points.first().and_then(Head::of).map(|head| head.base);
            Some(Curve { object: own, segment, ..curve })
        };
        self.context.objects.iter().rev().filter(here).filter_map(curve).collect()
    }

    /// The different closed intervals in the paragraph of a place.
    fn closed_intervals_beside(&self, place: &Place) -> Vec<(Expr, Expr)> {
        let mut found: Vec<(Expr, Expr)> = Vec::new();
        for (_, [from, to], open) in self.context.intervals_beside(place) {
            if open == [false, false] && !found.iter().any(|(a, b)| a.same_as(from) && b.same_as(to)) {
                found.push((from.clone(), to.clone()));
            }
        }
        found
    }

    /// x(t) = (1 - t)^2 b_0 + …; "for a quadratic (1 - t)^2 b_0 + …"
    fn curves_by_formula(&self, new: &New, right: &Expr, statement: &Statement) -> Vec<Curve> {
        let place = &statement.place;
        let used = bases(right);
        let shares = |body: &Expr| bases(body).iter().any(|name| !is_variable(name) && used.contains(name));
        // "p(t) = 2t^3 - 3t has the control points": numbers on both sides
        let named = |definition: &Definition| {
            statement.near.has(Topic::ControlPoints) && definition.place.group == place.group
        };
        // "The polar form of f(t) = t^3 is F(u, v, w) = u v w"
        let polarised = statement.topics.has(Topic::PolarForm) && new.arguments > 1;
        let defined = self.context.definitions.iter().rev().filter_map(|definition| {
            let head = &definition.head;
            let arguments = head.flat();
            let (Body::Formula(body), [Expr { kind: Kind::Name(variable), .. }]) =
                (&definition.body, arguments.as_slice())
            else {
                return None;
            };
            let labelled = head.lower.iter().all(|label| label.as_int().is_some());
            let plain = labelled && head.upper.is_empty() && head.base != new.letter;
            let here = place.knows(&definition.place, definition.assumed);
            (plain && here && (shares(body) || named(definition) || polarised))
                .then(|| (function(head), body, variable.clone()))
        });
        let heard = self.heard(place).filter_map(|expr| {
            let variables: Vec<String> = bases(expr).into_iter().filter(|name| is_variable(name)).collect();
            // "The polar form of (t - a)(t - b)"
            let product = polarised && matches!(expr.kind, Kind::Mul(_));
            let sum = matches!(expr.kind, Kind::Add(_) | Kind::Big { .. }) || product;
            match <[String; 1]>::try_from(variables) {
                Ok([variable]) if sum && shares(expr) => Some((expr.clone(), expr, variable)),
                _ => None,
            }
        });
        let curve = |(name, body, variable): (Expr, &Expr, String)| {
            Some(Curve::new(name, self.degree_of_formula(body, &variable, place)?))
        };
        defined.chain(heard).take(MOST_CURVES).filter_map(curve).collect()
    }

    /// P_0 = (0, 0), P_1 = (1, 2), P_2 = (3, 3). Without their weights the points of a rational curve say nothing of it.
    fn curves_by_points(&self, new: &New, place: &Place, rational: bool) -> Vec<Curve> {
        let index = |head: &Head| {
            head.index().filter(|_| head.arguments.is_none() && head.upper.is_empty())?.as_int()
        };
        let letters = self.context.definitions.iter().rev().filter(|definition| {
            let head = &definition.head;
            index(head) == Some(0)
                && (new.arguments > 0 || head.base != new.letter)
                && place.knows(&definition.place, definition.assumed)
        });
        let known = |letter: &str| -> Vec<Expr> {
            let known = |i: &i64| {
                self.context
                    .visible(letter, place)
                    .any(|(_, definition, near)| near && index(&definition.head) == Some(*i))
            };
            (0..).take_while(known).map(|i| Expr::indexed(letter, i)).collect()
        };
        let curve = |letter: &str| {
            let points = known(letter);
            let mut given = WEIGHTS.iter().filter(|_| rational).map(|letter| known(letter));
            let weights = given.find(|weights| !weights.is_empty()).unwrap_or_default();
            let degree = Expr::int(points.len() as i64 - 1);
            let whole = points.len() > 2 && (!rational || weights.len() == points.len());
            (whole && !WEIGHTS.contains(&letter)).then(|| Curve {
                points: Some(letter.to_owned()),
                object: Some(Object { weights, ..bezier_curve(points, &degree) }),
                ..Curve::new(Expr::name(CURVE), degree)
            })
        };
        // Those of a spline, on several pieces, are not those of one curve.
        let of_spline = |letter: &str| {
            self.context.objects.iter().any(|told| {
                let object = &*told.object;
                let names = match object.sort {
                    Sort::ControlPoints => &object.names,
                    Sort::SplineCurve => &object.points,
                    _ => return false,
                };
                let own = names.iter().filter_map(Head::of).any(|head| head.base == letter);
                own && (object.sort == Sort::SplineCurve || !object.knots.is_empty())
                    && place.knows(&told.place, false)
            })
        };
        let letters = letters.map(|definition| definition.head.base.as_str());
        letters.filter(|letter| !of_spline(letter)).filter_map(curve).take(MOST_CURVES).collect()
    }

    /// The degree of the B-splines in a formula, if words say it.
    fn degree_of_splines(&self, body: &Expr, place: &Place) -> Option<Expr> {
        let mut found = None;
        walk(body, &mut |part| {
            let Kind::Apply(callee, _) = &part.kind else { return };
            let object = Head::of(callee).and_then(|head| self.context.object(&head, place));
            found = found.take().or_else(|| {
                let object = &object.filter(|declared| declared.object.sort == Sort::BSpline)?.object;
                let degree = evaluator::machine().eval_int(object.degree.as_ref()?).ok()?;
                Some(Expr::int(degree))
            });
        });
        found
    }

    /// The degree of a formula in a variable: the upper end of its sum, or that of its value.
    fn degree_of_formula(&self, body: &Expr, variable: &str, place: &Place) -> Option<Expr> {
        // Σ d_i N_i(u), where words say of which degree N_i is
        if let Some(degree) = self.degree_of_splines(body, place) {
            return Some(degree);
        }
        if let Kind::Big { upper: Some(upper), .. } = &body.kind {
            return Some(upper.as_ref().clone());
        }
        let symbol = Symbol::new(variable);
        let model = Model::new(self.context.clone(), place.clone(), Default::default(), None);
        let own = [(symbol.clone(), Value::symbol(symbol.clone()))];
        let degree = |value: &Value| match value {
            Value::Scalar(formula) => Some(i64::from(formula.as_polynomial()?.degree_in(&symbol))),
            _ => None,
        };
        let value = evaluate_reading(body, Rc::new(model), own).ok()?;
        let degree = match value.clone().coordinates() {
            Some(items) => items.iter().filter_map(degree).max(),
            None => degree(&value),
        };
        degree.filter(|degree| *degree > 0).map(Expr::int)
    }
}

/// A function by its head, without its arguments: T_3.
fn function(head: &Head) -> Expr {
    match head.lower.as_slice() {
        [] => Expr::name(&head.base),
        lower => Kind::Subscript(Box::new(Expr::name(&head.base)), lower.to_vec()).into(),
    }
}

/// A Bézier curve without a name.
fn bezier_curve(points: Vec<Expr>, degree: &Expr) -> Object {
    let names = vec![Expr::name(CURVE)];
    Object { names, points, degree: Some(degree.clone()), ..Object::new(Sort::BezierCurve) }
}

/// The number of the last point of b_0, …, b_n.
fn last_index(points: &[Expr]) -> Option<Expr> {
    let index = |point: &Expr| Head::of(point)?.index().cloned();
    match points {
        [one] if Head::of(one).is_some() => None,
        [first, .., last] if points.iter().any(|point| point.kind == Kind::Ellipsis) => {
            (index(first)?.as_int()? == 0).then(|| index(last)).flatten()
        }
        _ => Some(Expr::int(points.len() as i64 - 1)),
    }
}
