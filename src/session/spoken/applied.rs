//! A call put together from what was said of it, and what is inside of it.

use super::draft::{Draft, list};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Sign, Term, applied, call, named};
use crate::language::eval;
use crate::language::functions::{Takes, builtin};
use crate::language::lexicon::families::BERNSTEIN;

/// A call of a function that says how often: elevate(c) twice.
pub(super) fn repeated(called: &Expr, count: &Expr) -> Option<Expr> {
    let Kind::Apply(callee, groups) = &called.kind else { return None };
    let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_slice()) else { return None };
    let times = builtin(name)?.parameters.iter().find(|own| matches!(own.name, "k" | "times"))?;
    if arguments.iter().any(|argument| eval::named(argument).is_some()) {
        return None;
    }
    let mut arguments = arguments.clone();
    arguments.push(named(times.name, count.clone()));
    Some(applied((**callee).clone(), arguments, called.span))
}

/// The interval of a Bézier curve that is called: bezier([0, 1, 3])(t).
fn interval_of(called: &Expr) -> Option<[Expr; 2]> {
    let Kind::Apply(curve, _) = &called.kind else { return None };
    let Kind::Apply(callee, groups) = &curve.kind else { return None };
    if !matches!(&callee.kind, Kind::Name(name) if name == "bezier") {
        return None;
    }
    let arguments = groups.first()?;
    let end = |name: &str, other: i64| {
        let own = arguments.iter().filter_map(eval::named).find(|(own, _)| own == name);
        own.map_or_else(|| Expr::int(other), |(_, value)| value.clone())
    };
    let placed: Vec<&Expr> = arguments.iter().filter(|argument| eval::named(argument).is_none()).collect();
    match placed.as_slice() {
        [_, a, b] => Some([(*a).clone(), (*b).clone()]),
        [_] => Some([end("a", 0), end("b", 1)]),
        _ => None,
    }
}

impl Draft {
    /// The call, of what is inside of it.
    pub(super) fn applied_to(mut self, inside: Option<Expr>) -> Option<Expr> {
        let span = self.phrase;
        let span = self.placed.iter().chain(&inside).map(|item| item.span).fold(span, Span::to);
        if let Some(mut inside) = inside {
            let subject = self.builtin.parameters.first().map(|first| first.kind);
            if let Kind::Apply(callee, groups) = &inside.kind
                && let Kind::Name(name) = &callee.kind
            {
                match (subject, name.as_str(), groups.first().map(Vec::as_slice)) {
                    // The points of a curve stand for it.
                    (
                        Some(Takes::Curve | Takes::Polar | Takes::Geometry),
                        "control_points" | "bezier_points",
                        Some([curve]),
                    ) => inside = curve.clone(),
                    // The zeros of a Bézier polynomial.
                    (
                        Some(
                            Takes::Polynomial | Takes::Scalar | Takes::Formula | Takes::Any | Takes::OneOf(_),
                        ),
                        "bezier",
                        _,
                    ) if self.builtin.on_curve.is_none() && !self.takes_curves() => {
                        let span = inside.span;
                        inside = applied(inside, vec![Expr { span, ..Expr::name("t") }], span);
                    }
                    _ => {}
                }
            }
            self.placed.insert(0, inside);
        }
        // The Bézier form of a spline is that of its pieces.
        if matches!(self.builtin.name, "in_bernstein" | "bezier_points")
            && let [spline] = self.placed.as_slice()
            && matches!(&spline.kind, Kind::Apply(callee, _)
                if matches!(&callee.kind, Kind::Name(name) if name == "bspline"))
            && self.named.is_empty()
        {
            return Some(call("pieces", vec![spline.clone()], span));
        }
        // The control points of the parts of a curve are those of each.
        if self.builtin.name == "control_points"
            && let [parts] = self.placed.as_slice()
            && matches!(&parts.kind, Kind::Apply(callee, _)
                if matches!(&callee.kind, Kind::Name(name) if matches!(name.as_str(), "subdivide" | "pieces")))
        {
            let letter = Expr { span, ..Expr::name("c") };
            let each = Expr::new(
                Kind::Lambda(vec![letter.clone()], Box::new(call("control_points", vec![letter], span))),
                span,
            );
            return Some(call("map", vec![each, parts.clone()], span));
        }
        // The largest value of B_i^n is meant on [0, 1].
        if matches!(self.builtin.name, "maximum" | "minimum")
            && let [Expr { kind: Kind::Pow(base, _), .. }] = self.placed.as_slice()
            && matches!(&base.kind, Kind::Subscript(letter, _) if matches!(&letter.kind, Kind::Name(name) if name == BERNSTEIN))
            && self.named.is_empty()
        {
            self.named.extend([("a", Expr::int(0)), ("b", Expr::int(1))]);
        }
        // The largest value of a Bézier polynomial is the one over its interval.
        if matches!(self.builtin.name, "maximum" | "minimum")
            && self.placed.len() == 1
            && let Some([a, b]) = interval_of(&self.placed[0])
            && !self.named.iter().any(|(name, _)| matches!(*name, "a" | "b"))
        {
            self.named.extend([("a", a), ("b", b)]);
        }
        let phrase = self.phrase;
        let called =
            |name: &str, arguments| applied(Expr { span: phrase, ..Expr::name(name) }, arguments, span);
        // As many degrees as lie between.
        if let Some(degree) = self.degree.take() {
            let own = called("degree", vec![self.placed.first()?.clone()]);
            let (more, less) = match self.builtin.name {
                "elevate" => (degree, own),
                _ => (own, degree),
            };
            let by = Expr {
                span,
                ..Expr::sum(vec![
                    Term { sign: Sign::Plus, expr: more },
                    Term { sign: Sign::Minus, expr: less },
                ])
            };
            self.placed.push(by);
        }
        if self.builtin.name == "bspline_basis" && !self.named.iter().any(|(name, _)| *name == "i") {
            let knots =
                self.named.iter().find(|(name, _)| *name == "knots").and_then(|(_, knots)| knots.items());
            let degree = self.named.iter().find(|(name, _)| *name == "n").and_then(|(_, n)| n.as_int());
            // The only one.
            if let (Some(knots), Some(degree)) = (knots, degree)
                && i64::try_from(knots.len()).is_ok_and(|count| count == degree + 2)
            {
                self.named.push(("i", Expr { span, ..Expr::int(0) }));
            }
        }
        // The knots of m + 1 points are m + n + 2.
        if self.builtin.name == "bspline" && self.placed.is_empty() {
            let count = |name: &str| {
                let (_, list) = self.named.iter().find(|(own, _)| *own == name)?;
                i64::try_from(list.items()?.len()).ok()
            };
            let known = self.named.iter().any(|(name, _)| *name == "n");
            if let (Some(knots), Some(points), false) = (count("knots"), count("points"), known)
                && knots > points
            {
                self.named.push(("n", Expr { span, ..Expr::int(knots - points - 1) }));
            }
        }
        // solve x + y = 3, x - y = 1 for x and y
        if self.builtin.on_equations.is_some() {
            let (unknowns, others): (Vec<_>, Vec<_>) =
                self.named.into_iter().partition(|(name, _)| name.is_empty());
            self.named = others;
            if self.placed.len() > 1 {
                self.placed = vec![list(self.placed)];
            }
            match unknowns.len() {
                0 | 1 => self.named.extend(unknowns),
                _ => self.named.push(("", list(unknowns.into_iter().map(|(_, name)| name).collect()))),
            }
        }
        let others = self.named.into_iter().map(|(name, value)| match name {
            "" => value,
            _ => named(name, value),
        });
        let arguments = self.placed.into_iter().chain(others).collect();
        let whole = called(self.builtin.name, arguments);
        Some(match self.part {
            Some(part) => Expr::new(Kind::Subscript(Box::new(whole), vec![list(vec![part])]), span),
            None => whole,
        })
    }
}
