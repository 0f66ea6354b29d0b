//! A request while it is put together: its functions, their object, and what is said of them.

use super::draft::{self, Draft};
use super::{Read, apposition, knots, lists, notations};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term, call};
use crate::judge::written::names::bases;
use crate::language::eval;
use crate::language::functions::{BASIS, BASIS_OR_KNOTS, Gives, Parameter, Takes, builtin};
use crate::language::lexicon::phrases::{Label, Place};
use crate::language::lexicon::roles;
use crate::session::given::is_equation;

/// The chapter of functions of which the first argument is a polynomial whose values are looked at.
const ROOTS: &str = "Roots of polynomials";

/// A request, read.
#[derive(Clone, Default)]
pub(super) struct Utterance {
    /// The functions; once settled, from the inside out.
    pub(super) drafts: Vec<Draft>,
    /// What the innermost of them is about.
    pub(super) items: Vec<Expr>,
    /// What is said of the arguments.
    pub(super) said: Vec<Read>,
    /// What the innermost function is applied to, if that is a formula with lists in place of its notations.
    pub(super) formula: Option<Expr>,
    /// Points that are to be met.
    pub(super) through: Option<Span>,
    /// Places that have a word: in the middle.
    pub(super) places: Vec<Place>,
    /// Whether something is so: closed.
    pub(super) flags: Vec<(&'static str, Expr)>,
}

impl Utterance {
    /// Takes what a label says.
    pub(super) fn hear(&mut self, label: Label, items: Vec<Expr>) {
        // at t = 0, 1/2, 1
        let mut items = items;
        if let (Label::At, [first, rest @ ..]) = (label, items.as_mut_slice())
            && let Some((name, value)) = eval::named(first).map(|(name, value)| (name, value.clone()))
            && !rest.is_empty()
            && roles::is_variable(&name)
            && rest.iter().all(|item| matches!(item.kind, Kind::Number(_) | Kind::Div(..)))
        {
            *first = value;
        }
        // in t = 1
        let values = !items.is_empty() && items.iter().all(|item| eval::named(item).is_some());
        let met = label == Label::Through;
        // from [0, 1] to [0, 2]
        if label == Label::From
            && let [Expr { kind: Kind::List(ends), .. }] = items.as_slice()
            && matches!(ends.as_slice(), [a, b] if a.as_int() == Some(0) && b.as_int() == Some(1))
        {
            return;
        }
        let label = match label {
            Label::In if values => Label::At,
            // forma polare di t^2 in (1, 2)
            Label::In
                if is_point(&items) && self.drafts.iter().any(|draft| draft.builtin.name == "polar") =>
            {
                Label::At
            }
            // the parabola through (0, 1), (1, 3), (2, 11)
            Label::Through if draft::is_points(&items) && self.drafts.is_empty() => Label::Through,
            Label::Through => {
                self.through = self.through.or(items.first().map(|item| item.span));
                Label::With
            }
            label => label,
        };
        // through (0, 2), (1, 0) and (3, 8)
        if let Some(last) = self.said.last_mut()
            && self.through.is_some_and(|first| last.items.first().is_some_and(|item| item.span == first))
            && met
        {
            last.items.extend(items);
            return;
        }
        if let (Some(last), Label::Through) = (self.said.last_mut(), label)
            && last.label == Label::Through
        {
            last.items.extend(items);
            return;
        }
        self.said.push(Read { label, items });
    }

    /// Whether a place is said in any way.
    pub(super) fn has_place(&self) -> bool {
        !self.places.is_empty() || self.says(Label::At)
    }

    /// Values for the places that have a word. Of a spline they depend on its knots.
    fn take_places(&mut self) {
        if self.places.contains(&Place::Middle)
            || self.places.contains(&Place::Start)
            || self.places.contains(&Place::End)
        {
            self.take_places_of_spline();
        }
        let ends = self.said.iter().find(|read| read.label == Label::Over).map(|read| read.items.as_slice());
        let (a, b) = match ends {
            Some([Expr { kind: Kind::List(ends) | Kind::Tuple(ends), .. }])
                if let [a, b] = ends.as_slice() =>
            {
                (a.clone(), b.clone())
            }
            _ => (Expr::int(0), Expr::int(1)),
        };
        let unit = ends.is_none();
        let half = |expr: Expr, by: i64| expr.over(Expr::int(by));
        for place in std::mem::take(&mut self.places) {
            let value = match place {
                Place::Start => a.clone(),
                Place::End => b.clone(),
                Place::Middle if unit => half(Expr::int(1), 2),
                Place::Middle => {
                    let sum = [&a, &b].map(|end| Term { sign: Sign::Plus, expr: end.clone().grouped() });
                    half(Expr::sum(sum.into()).grouped(), 2)
                }
                Place::Centre => Expr::new(Kind::Tuple(vec![half(Expr::int(1), 3); 3]), Span::default()),
            };
            self.said.push(Read { label: Label::At, items: vec![value] });
        }
    }

    /// The ends of the interval over which a spline is given, or of its knots for a basis function, are its places.
    fn take_places_of_spline(&mut self) {
        let Some(ends) = knots::ends(self) else { return };
        let over = self.said.iter().any(|read| read.label == Label::Over && read.items.len() == 1);
        if over {
            return;
        }
        let value = |place: &Place| match place {
            Place::Start => Some(ends[0].clone()),
            Place::End => Some(ends[1].clone()),
            Place::Middle => {
                let sum = ends.iter().map(|end| Term { sign: Sign::Plus, expr: end.clone().grouped() });
                Some(Expr::sum(sum.collect()).grouped().over(Expr::int(2)))
            }
            Place::Centre => None,
        };
        let values: Option<Vec<Expr>> = self.places.iter().map(value).collect();
        if let Some(values) = values {
            self.places.clear();
            self.said.extend(values.into_iter().map(|value| Read { label: Label::At, items: vec![value] }));
        }
    }

    /// The values of a spline with knots are its coefficients: linear spline, knots 0, 0, 1, 1, values 3, 5.
    fn values_of_spline(&mut self) {
        let spline =
            self.drafts.iter().any(|draft| matches!(draft.builtin.name, "bspline" | "bspline_basis"));
        // the quadratic with ordinates 0, 4, 0
        let takes =
            |draft: &Draft| draft.builtin.parameters.iter().any(|own| matches!(own.name, "values" | "nodes"));
        let ordinates = self.items.is_empty()
            && !self.drafts.iter().any(takes)
            && !self.said.iter().any(|read| matches!(read.label, Label::Through | Label::At | Label::With));
        if (spline && self.says(Label::Knots) || ordinates)
            && !self.says(Label::Points)
            && !self.says(Label::Nodes)
        {
            self.said
                .iter_mut()
                .filter(|read| read.label == Label::Values)
                .for_each(|read| read.label = Label::Points);
        }
    }

    /// Points with three indices are those of a triangle.
    fn triangles(&mut self) {
        let Some(at) = self.said.iter().position(|read| read.label == Label::Net) else { return };
        let own = self.drafts.iter().any(|draft| draft.builtin.name == "triangle_patch");
        if let (true, false, Some(patch)) = (self.drafts.is_empty(), own, builtin("triangle_patch")) {
            let span = self.said[at].items[0].span;
            self.drafts.push(Draft::new(patch, span));
        }
        self.said[at].label = Label::Points;
        if own && self.items.is_empty() {
            self.items = self.said.remove(at).items;
        }
    }

    /// Of a conic or a standard form that is asked for by weights alone any points will do.
    fn weights_alone(&mut self) {
        let of_weights = |draft: &Draft| matches!(draft.builtin.name, "standard_form" | "conic_kind");
        if !self.drafts.iter().any(of_weights) || !self.items.is_empty() || self.says(Label::Points) {
            return;
        }
        let Some(weights) = self.said.iter().find(|read| read.label == Label::Weights) else { return };
        let count = match weights.items.as_slice() {
            [Expr { kind: Kind::List(items) | Kind::Tuple(items), .. }] => items.len(),
            items => items.len(),
        };
        let span = weights.items.iter().map(|item| item.span).reduce(Span::to).unwrap_or_default();
        let point = |i: usize| {
            let number = |n: usize| Expr { span, ..Expr::int(i64::try_from(n).unwrap_or(0)) };
            Expr::new(Kind::Tuple(vec![number(i), number(i * (count - 1 - i))]), span)
        };
        let points = (0..count).map(point).collect();
        self.said.push(Read { label: Label::Points, items: points });
        let curve = |draft: &Draft| draft.builtin.name == "bezier";
        if let (false, Some(bezier)) = (self.drafts.iter().any(curve), builtin("bezier")) {
            self.drafts.push(Draft::new(bezier, span));
        }
    }

    /// The interval over which a curve is continued stands behind its own: continue 0, 1, 3 on [0, 1] C^1 on [1, 2].
    fn continued(&mut self) {
        let Some(at) = self.drafts.iter().position(|draft| draft.builtin.name == "continuation") else {
            return;
        };
        let place = |read: &Read| read.items.first().map_or(0, |item| item.span.start);
        let intervals = |read: &&Read| {
            matches!(read.label, Label::Over | Label::To | Label::In)
                && matches!(read.items.as_slice(), [Expr { kind: Kind::List(ends), .. }] if ends.len() == 2)
        };
        let found: Vec<&Read> = self.said.iter().filter(intervals).collect();
        let Some(last) = found.iter().max_by_key(|read| place(read)) else { return };
        let Some([start, end]) = last.items[0].items() else { return };
        let own = found.iter().find(|read| place(read) != place(last)).and_then(|read| read.items[0].items());
        let begins = own.map_or(Some(1), |ends| ends.get(1).and_then(Expr::as_int));
        if start.as_int() != begins {
            return;
        }
        let (end, from) = (end.clone(), place(last));
        self.drafts[at].named.push(("end", end));
        self.said.retain(|read| !(intervals(&read) && place(read) == from));
    }

    pub(super) fn says(&self, label: Label) -> bool {
        self.said.iter().any(|read| read.label == label)
    }

    /// Finds the functions that are meant but not named, from what is said.
    pub(super) fn settle(&mut self) {
        if self.drafts.iter().all(|draft| draft.builtin.on_equations.is_none()) {
            lists::gather(&mut self.items, &mut self.said);
        }
        knots::uniform(self);
        self.take_places();
        self.values_of_spline();
        self.weights_alone();
        self.triangles();
        self.continued();
        // the quadratic spline (degree 2)
        let mut degrees: Vec<i64> = Vec::new();
        self.said.retain(|read| match (read.label, read.items.as_slice()) {
            (Label::OfDegree, [degree]) => degree.as_int().is_none_or(|degree| {
                let new = !degrees.contains(&degree);
                degrees.push(degree);
                new
            }),
            _ => true,
        });
        // how many roots
        if let [outer, inner, ..] = self.drafts.as_mut_slice()
            && (outer.builtin.name, inner.builtin.name) == ("length", "roots")
            && let Some(count) = builtin("count_roots")
        {
            inner.builtin = count;
            self.drafts.remove(0);
        }
        // how many sign changes
        if let [outer, inner, ..] = self.drafts.as_slice()
            && outer.builtin.name == "length"
            && inner.builtin.gives == Gives::Count
        {
            self.drafts.remove(0);
        }
        // the point at 1/3 on the curve (0, 0), (1, 2), (2, 0)
        if self.drafts.is_empty() && self.items.is_empty() && !self.says(Label::Points) {
            let curve = |read: &&mut Read| {
                read.label == Label::Over
                    && read.items.len() > 1
                    && read.items.iter().all(|item| matches!(item.kind, Kind::Tuple(_)))
            };
            if let Some(read) = self.said.iter_mut().find(curve) {
                read.label = Label::Points;
            }
        }
        self.values_of_degree();
        self.curve_of_degree();
        self.spline_of_data();
        self.meeting();
        self.roots_within();
        self.value_outside();
        // insert the knot 1 once
        if self.drafts.iter().any(|draft| draft.builtin.name == "insert_knots") {
            self.said.retain(|read| {
                read.label != Label::Times
                    || !matches!(read.items.as_slice(), [one] if one.as_int() == Some(1))
            });
        }
        self.extremes();
        // the interpolation polynomial of Lagrange
        let of_data = |name: &str| {
            ["lagrange", "newton", "hermite", "bezier", "bspline", "patch", "triangle_patch"].contains(&name)
        };
        self.drafts.dedup_by(|inner, outer| {
            let same = inner.builtin.name == outer.builtin.name && of_data(inner.builtin.name);
            // the Newton form of the interpolant
            same || inner.builtin.name == "lagrange" && outer.builtin.name == "newton"
        });
        self.bases();
        self.drafts.reverse();
        self.points_of_formula();
        self.splines();
        self.interpolants();
        notations::exponents(&mut self.items, &mut self.said);
        let points = self.said.iter().find(|read| read.label == Label::Points);
        if let (true, true, Some(points)) = (self.drafts.is_empty(), self.items.is_empty(), points)
            && let Some(curve) = builtin(if self.says(Label::Knots) { "bspline" } else { "bezier" })
        {
            let span = points.items.first().map_or(Span::default(), |item| item.span);
            self.drafts.push(Draft::new(curve, span));
        }
        self.curve_for_function();
        apposition::curve_of_points(&mut self.drafts, &self.items, &self.said);
    }

    /// One pair of parentheses around the values of a curve: the cubic (0, 1, 0, 2).
    fn values_of_degree(&mut self) {
        let [Expr { kind: Kind::Tuple(values), .. }] = self.items.as_slice() else { return };
        let degree = i64::try_from(values.len()).unwrap_or(0) - 1;
        let number = |item: &Expr| {
            item.as_signed_int().is_some() || matches!(item.kind, Kind::Number(_) | Kind::Div(..))
        };
        let counted = self.said.iter().any(|read| {
            read.label == Label::OfDegree
                && matches!(read.items.as_slice(), [own] if own.as_int() == Some(degree))
        });
        if degree > 1 && counted && values.iter().all(number) {
            self.items = values.clone();
        }
    }

    /// B-splines with points are a curve; control points that a polynomial has over knots are those of its spline.
    fn spline_of_data(&mut self) {
        if !self.says(Label::Knots) {
            return;
        }
        // Marsden's coefficients for quadratic B-splines
        if self.drafts.iter().any(|draft| draft.builtin.name == "spline_of") {
            self.drafts.retain(|draft| draft.builtin.name != "bspline_basis");
        }
        let points = self.items.len() > 1 && !self.says(Label::Points);
        let formula =
            matches!(self.items.as_slice(), [Expr { kind: Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..), .. }]);
        let Some(innermost) = self.drafts.last_mut() else { return };
        let meant = match innermost.builtin.name {
            "bspline_basis" if points => "bspline",
            "coefficients" | "control_points" | "bezier_points" if formula => "spline_of",
            _ => return,
        };
        innermost.builtin = builtin(meant).unwrap_or(innermost.builtin);
    }

    /// Numbers or points that are called a quadratic or a cubic are a curve for functions of polynomials: the extrema of the cubic
    /// 0, 1, 3, 2.
    fn curve_of_degree(&mut self) {
        let of_values = |draft: &Draft| {
            matches!(draft.builtin.name, "max" | "min" | "midpoint" | "slope" | "tangent_line")
                || draft.builtin.topic == ROOTS
        };
        let Some(innermost) = self.drafts.last().filter(|draft| of_values(draft)) else { return };
        let count = i64::try_from(self.items.len()).unwrap_or(0) - 1;
        let counted = self.said.iter().any(|read| {
            read.label == Label::OfDegree
                && matches!(read.items.as_slice(), [degree] if degree.as_int() == Some(count))
        });
        if let (true, true, Some(bezier)) = (counted, count > 0, builtin("bezier")) {
            let phrase = innermost.phrase;
            self.drafts.push(Draft::new(bezier, phrase));
        }
    }

    /// The maximum of t (1 - t) on [0, 1], that of 1/2 and 2/3.
    fn extremes(&mut self) {
        let curve = self.drafts.iter().any(|draft| draft.builtin.name == "bezier");
        for draft in self.drafts.iter_mut().filter(|_| curve) {
            let meant = match draft.builtin.name {
                "max" => builtin("maximum"),
                "min" => builtin("minimum"),
                _ => None,
            };
            draft.builtin = meant.unwrap_or(draft.builtin);
        }
        let [Draft { builtin: of, .. }] = self.drafts.as_mut_slice() else { return };
        if !matches!(of.name, "max" | "min" | "maximum" | "minimum") {
            return;
        }
        for read in &mut self.said {
            if let (Label::At, [Expr { kind: Kind::List(_), .. }]) = (read.label, read.items.as_slice()) {
                read.label = Label::Over;
            }
        }
        let over = self
            .said
            .iter()
            .any(|read| matches!(read.label, Label::Over | Label::In | Label::With | Label::From));
        let meant = match (of.name, self.items.len() == 1 && over) {
            ("max", true) => builtin("maximum"),
            ("min", true) => builtin("minimum"),
            ("maximum", false) if self.items.len() > 1 => builtin("max"),
            ("minimum", false) if self.items.len() > 1 => builtin("min"),
            _ => None,
        };
        *of = meant.unwrap_or(of);
    }

    /// Where curves meet that are given by equations: they are solved together.
    fn meeting(&mut self) {
        let [Draft { builtin: of, .. }] = self.drafts.as_mut_slice() else { return };
        let of_them = |read: &Read| read.label == Label::With && read.items.iter().all(is_equation);
        let line = |read: &Read| read.label == Label::OfDegree;
        if of.name != "intersections"
            || self.items.is_empty()
            || !self.items.iter().all(is_equation)
            || !self.said.iter().all(|read| of_them(read) || line(read))
        {
            return;
        }
        let Some(solve) = builtin("solve") else { return };
        *of = solve;
        self.items
            .extend(std::mem::take(&mut self.said).into_iter().filter(of_them).flat_map(|read| read.items));
    }

    /// A curve with the control points that are said, for a function that takes none by itself: control points 1, 3 to monomials.
    fn curve_for_function(&mut self) {
        let points = self.items.is_empty() && self.says(Label::Points);
        let Some(innermost) = self.drafts.first().filter(|_| points) else { return };
        let takes = |p: &Parameter| {
            let named = matches!(p.name, "points" | "net" | "curve" | "spline");
            let of_points = matches!(
                p.kind,
                Takes::Points
                    | Takes::Net
                    | Takes::Curve
                    | Takes::Polar
                    | Takes::Geometry
                    | Takes::Coordinates
            );
            named || of_points
        };
        let curve = builtin(if self.says(Label::Knots) { "bspline" } else { "bezier" });
        if let (false, Some(curve)) = (innermost.builtin.parameters.iter().any(takes), curve) {
            self.drafts.insert(0, Draft::new(curve, innermost.phrase));
        }
    }

    /// The solutions of an equation in an interval are roots there: solve t^2 = 2 for t in [0, 2].
    fn roots_within(&mut self) {
        let [Draft { builtin: of, .. }] = self.drafts.as_mut_slice() else { return };
        let [Expr { kind: Kind::Chain(_, equation), .. }] = self.items.as_slice() else { return };
        let pair = |list: &Expr| matches!(&list.kind, Kind::List(ends) if ends.len() == 2);
        let own = bases(&self.items[0]);
        let of_it = |letter: &Expr| matches!(&letter.kind, Kind::Name(name) if own.contains(name));
        let interval = |read: &Read| match read.items.as_slice() {
            [Expr { kind: Kind::Chain(letter, links), .. }] if of_it(letter) => match links.as_slice() {
                [Link { rel: Rel::In, expr, .. }] if pair(expr) => Some(expr.clone()),
                _ => None,
            },
            [list] if pair(list) && matches!(read.label, Label::Over | Label::In) => Some(list.clone()),
            _ => None,
        };
        let name = |read: &Read| {
            read.label == Label::With && matches!(read.items.as_slice(), [letter] if of_it(letter))
        };
        let Some(ends) = self.said.iter().find_map(interval) else { return };
        let others = self.said.iter().filter(|read| interval(read).is_none());
        if let ("solve", [Link { rel: Rel::Eq, .. }], true, Some(roots)) =
            (of.name, equation.as_slice(), others.clone().all(name), builtin("roots"))
        {
            *of = roots;
            self.said = vec![Read { label: Label::Over, items: vec![ends] }];
        }
    }

    /// The value of a curve outside of its interval: extrapolate 0, 1, 3 to t = 2.
    fn value_outside(&mut self) {
        let [Draft { builtin: of, .. }, ..] = self.drafts.as_mut_slice() else { return };
        let mut others = self.said.iter_mut().filter(|read| read.label != Label::OfDegree);
        let (Some(Read { label: label @ (Label::To | Label::At), items }), None) =
            (others.next(), others.next())
        else {
            return;
        };
        let value = match items.as_slice() {
            [item] => eval::named(item).map(|(_, value)| value.clone()),
            _ => None,
        };
        if let ("part", Some(value), Some(extended)) = (of.name, value, builtin("extended")) {
            *of = extended;
            *label = Label::At;
            *items = vec![value];
        }
    }

    /// The basis that a function works with: the mass matrix of the Bernstein polynomials.
    fn bases(&mut self) {
        let [outer, inner] = self.drafts.as_mut_slice() else { return };
        let basis = |p: &&Parameter| [BASIS, BASIS_OR_KNOTS].contains(&p.kind);
        if let (Some(parameter), Some(name)) =
            (outer.builtin.parameters.iter().find(basis), super::basis_of(inner.builtin.name))
        {
            outer.named.push((parameter.name, Expr { span: inner.phrase, ..Expr::name(name) }));
            self.drafts.pop();
        }
    }

    /// The control points of the Bézier curve t^2.
    fn points_of_formula(&mut self) {
        if let ([Draft { builtin: curve, .. }, Draft { builtin: points, .. }, ..], [formula]) =
            (self.drafts.as_slice(), self.items.as_slice())
            && (curve.name, points.name) == ("bezier", "control_points")
            && matches!(formula.kind, Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..))
        {
            self.drafts.remove(0);
        }
    }

    /// The spline that knots and control points are of: insert knot 1: knots 0, 0, 2, 2, control points 3, 4.
    fn splines(&mut self) {
        // insert the knot 1/2 into 0, 0, 1, 1 with control points 0, 2
        let of_spline = |draft: &Draft| {
            draft.builtin.parameters.first().is_some_and(|subject| subject.kind == Takes::Spline)
        };
        if self.drafts.first().is_some_and(of_spline) && self.says(Label::Points) && !self.says(Label::Knots)
        {
            let several = |read: &&mut Read| {
                let list = matches!(read.items.as_slice(), [Expr { kind: Kind::List(items), .. }] if items.len() > 2);
                matches!(read.label, Label::To | Label::In | Label::Over) && (list || read.items.len() > 2)
            };
            if let Some(read) = self.said.iter_mut().find(several) {
                read.label = Label::Knots;
            }
        }
        if let Some(Draft { builtin: first, phrase, .. }) = self.drafts.first()
            && first.parameters.first().is_some_and(|subject| subject.kind == Takes::Spline)
            && let (true, Some(spline)) = (self.says(Label::Knots), builtin("bspline"))
        {
            self.drafts.insert(0, Draft::new(spline, *phrase));
            self.drafts[1].placed = std::mem::take(&mut self.items);
        }
        if self.says(Label::Points)
            && let Some(basis) = self.drafts.iter_mut().find(|draft| draft.builtin.name == "bspline_basis")
            && let Some(spline) = builtin("bspline")
        {
            basis.builtin = spline;
        }
    }

    /// The parabola through points.
    fn interpolants(&mut self) {
        if !self.drafts.is_empty() || !self.items.is_empty() {
            return;
        }
        let find = |label: Label| self.said.iter().find(|read| read.label == label);
        let (Some(degree), Some(points)) = (find(Label::OfDegree), find(Label::Through)) else { return };
        if let ([degree], Some(lagrange)) = (degree.items.as_slice(), builtin("lagrange"))
            && degree.as_int().is_some_and(|degree| usize::try_from(degree + 1) == Ok(points.items.len()))
        {
            self.items.clone_from(&points.items);
            self.drafts.push(Draft::new(lagrange, self.items[0].span));
            self.said.retain(|read| !matches!(read.label, Label::OfDegree | Label::Through));
        }
    }

    /// What is asked for, where it is a call by itself: the solution of M x = b, an elementary symmetric polynomial.
    pub(super) fn whole(&self) -> Option<Expr> {
        let [Draft { builtin, phrase, .. }] = self.drafts.as_slice() else { return None };
        let [object] = self.items.as_slice() else { return None };
        match (builtin.name, self.said.as_slice()) {
            ("esym", []) => notations::symmetric(object),
            ("solve", [Read { items, .. }]) => match (&object.kind, items.as_slice()) {
                (Kind::Matrix(..), [item]) => {
                    let (_, right) = eval::named(item)?;
                    let vector = matches!(right.kind, Kind::Matrix(..) | Kind::List(_));
                    vector.then(|| call("solve", vec![object.clone(), right.clone()], *phrase))
                }
                _ => None,
            },
            // solve [2, 1; 1, 3] x = [3; 5]
            ("solve", []) => {
                let Kind::Chain(left, links) = &object.kind else { return None };
                let (Kind::Mul(factors), [Link { rel: Rel::Eq, expr: right, .. }]) =
                    (&left.kind, links.as_slice())
                else {
                    return None;
                };
                match factors.as_slice() {
                    [matrix @ Expr { kind: Kind::Matrix(..), .. }, Expr { kind: Kind::Name(_), .. }] => {
                        Some(call("solve", vec![matrix.clone(), right.clone()], *phrase))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Puts lists into the notations that they are said for: the B-spline N_{0,2}, the Lagrange polynomial L_1.
    pub(super) fn put_into_notations(&mut self) {
        let [one] = self.items.as_slice() else { return };
        let Some(read) = notations::with_values(one, &mut self.said) else { return };
        let same =
            |name: &str| name == read.function || name == "lagrange" && read.function == "lagrange_basis";
        if self.drafts.first().is_some_and(|draft| same(draft.builtin.name)) {
            self.drafts.remove(0);
        }
        self.formula = Some(read.formula);
        self.items.clear();
    }

    /// Gives the innermost function its object; false if it cannot take it.
    pub(super) fn apply_innermost(&mut self) -> bool {
        let Some(innermost) = self.drafts.first_mut() else { return true };
        if self.formula.is_none() && !innermost.is_about(std::mem::take(&mut self.items), &mut self.said) {
            return false;
        }
        innermost.takes_coefficient(&mut self.said);
        let of_variable = |read: &Read| {
            let variable = matches!(read.items.as_slice(), [Expr { kind: Kind::Name(_), .. }]);
            variable && matches!(read.label, Label::In | Label::To)
        };
        if innermost.builtin.name == "derivative"
            && self.said.iter().any(of_variable)
            && let Some(of_formulas) = builtin("diff")
        {
            innermost.builtin = of_formulas;
        }
        true
    }
}

/// Whether something is nothing but one point of numbers.
fn is_point(items: &[Expr]) -> bool {
    let number = |item: &Expr| matches!(item.kind, Kind::Number(_) | Kind::Div(..));
    matches!(items, [Expr { kind: Kind::Tuple(items), .. }] if items.iter().all(number))
}
