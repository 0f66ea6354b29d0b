//! A call whose arguments are being gathered from what is said of them.

use super::{Read, one_term};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term, call};
use crate::judge::written::names::bases;
use crate::language::eval;
use crate::language::functions::{Builtin, Need, Parameter, Takes, builtin};
use crate::language::lexicon::phrases::{self, Label};
use crate::language::lexicon::roles;

/// A call whose arguments are being gathered.
#[derive(Clone)]
pub(super) struct Draft {
    pub(super) builtin: &'static Builtin,
    pub(super) phrase: Span,
    pub(super) placed: Vec<Expr>,
    pub(super) named: Vec<(&'static str, Expr)>,
    /// Which of the things it gives is wanted.
    pub(super) part: Option<Expr>,
    /// The degree that an elevation or reduction leads to.
    pub(super) degree: Option<Expr>,
}

pub(super) fn is_points(items: &[Expr]) -> bool {
    !items.is_empty() && items.iter().all(|item| matches!(item.kind, Kind::Tuple(_) | Kind::List(_)))
}

/// The name and the value in t = 1, also in x(t) = t^2.
fn named_value(item: &Expr) -> Option<(String, Expr)> {
    if let Some((name, value)) = eval::named(item) {
        return Some((name, value.clone()));
    }
    let Kind::Chain(left, links) = &item.kind else { return None };
    let ([Link { rel: Rel::Eq, expr, .. }], Kind::Apply(callee, groups)) = (links.as_slice(), &left.kind)
    else {
        return None;
    };
    let letter =
        matches!(groups.as_slice(), [one] if matches!(one.as_slice(), [Expr { kind: Kind::Name(_), .. }]));
    match &callee.kind {
        Kind::Name(name) if letter => Some((name.clone(), expr.clone())),
        _ => None,
    }
}

/// Whether they are formulas in one parameter, with parentheses around them.
fn is_coordinates(item: &Expr) -> bool {
    let Kind::Tuple(coordinates) = &item.kind else { return false };
    let mut names: Vec<String> = coordinates.iter().flat_map(bases).collect();
    names.sort();
    names.dedup();
    matches!(coordinates.len(), 2 | 3) && matches!(names.as_slice(), [one] if roles::is_variable(one))
}

pub(super) fn list(items: Vec<Expr>) -> Expr {
    let span = items.iter().map(|item| item.span).reduce(Span::to).unwrap_or_default();
    Expr::new(Kind::List(items), span)
}

/// The first coordinates of points, and what follows them.
fn nodes_and_values(points: &[Expr]) -> Option<[Expr; 2]> {
    let parts = points.iter().map(|point| match point.items()?.split_first()? {
        (_, []) => None,
        (node, [value]) => Some((node.clone(), value.clone())),
        (node, values) => Some((node.clone(), list(values.to_vec()))),
    });
    let (nodes, values): (Vec<Expr>, Vec<Expr>) = parts.collect::<Option<Vec<_>>>()?.into_iter().unzip();
    Some([list(nodes), list(values)])
}

/// A point, and no list of points.
fn is_flat(item: &Expr) -> bool {
    matches!(item.kind, Kind::Tuple(_)) && item.items().is_some_and(|items| !is_points(items))
}

fn is_list(kind: Takes) -> bool {
    matches!(
        kind,
        Takes::Scalars
            | Takes::ScalarOrList
            | Takes::Points
            | Takes::Net
            | Takes::Rows
            | Takes::Variables
            | Takes::List
            | Takes::Coordinates
    )
}

impl Draft {
    pub(super) fn new(builtin: &'static Builtin, phrase: Span) -> Self {
        Draft { builtin, phrase, placed: Vec::new(), named: Vec::new(), part: None, degree: None }
    }

    /// Takes the words of its own phrase that are values of parameters: Chaikin's scheme.
    pub(super) fn take_words(&mut self, phrase: &str) {
        const FOUR_POINT: &[&str] = &[
            "four point",
            "four-point",
            "vierpunkt",
            "vier punkt",
            "vier-punkt",
            "quatre points",
            "cuatro puntos",
            "quattro punti",
            "四点",
        ];
        if self.builtin.name == "subdivide_polygon" && FOUR_POINT.iter().any(|own| phrase.contains(own)) {
            self.named.push(("scheme", Expr { span: self.phrase, ..Expr::name("four_point") }));
            return;
        }
        // "Lagrange polynomials for the nodes", in the plural, are those of the nodes.
        const SEVERAL: &[&str] = &["polynomials", "polynome", "polynômes", "polinomios", "polinomi"];
        if self.builtin.name == "lagrange"
            && phrase.contains("lagrange")
            && SEVERAL.iter().any(|own| phrase.split_whitespace().any(|word| word == *own))
            && let Some(basis) = builtin("lagrange_basis")
        {
            self.builtin = basis;
            return;
        }
        // the regression line, die Ausgleichsgerade
        let degree = self.builtin.parameters.iter().find(|own| matches!(own.name, "n" | "degree"));
        if let (Some(degree), "least_squares", Some(n)) =
            (degree, self.builtin.name, phrases::degree_within(phrase))
        {
            self.named.push((degree.name, Expr { span: self.phrase, ..Expr::int(n) }));
            return;
        }
        // The acceleration is the second derivative.
        const SECOND: &[&str] = &["accel", "beschleunig", "accél", "acele", "加速"];
        if self.builtin.name == "derivative" && SECOND.iter().any(|own| phrase.starts_with(own)) {
            self.named.push(("k", Expr { span: self.phrase, ..Expr::int(2) }));
            return;
        }
        for parameter in self.builtin.parameters.iter().filter(|parameter| parameter.has_name()) {
            let words = phrase.split(|c: char| !c.is_alphabetic());
            let found =
                words.filter_map(|word| parameter.kind.words().into_iter().find(|own| *own == word)).next();
            if let Some(word) = found.filter(|word| *word != self.builtin.name) {
                self.named.push((parameter.name, Expr { span: self.phrase, ..Expr::name(word) }));
            }
        }
    }

    /// What the function is applied to, where a label says it: bezier with control points 0, 1, 3.
    pub(super) fn subject_among(&self, said: &mut Vec<Read>) -> Vec<Expr> {
        let Some(first) = self.builtin.parameters.first() else { return Vec::new() };
        let subject = |read: &Read| match read.label {
            Label::Points | Label::Values => {
                matches!(
                    first.kind,
                    Takes::Points | Takes::Net | Takes::Curve | Takes::Polar | Takes::Geometry
                ) || first.kind == Takes::Coordinates && read.items.len() > 1
            }
            // one step of Chaikin's scheme on 0, 4, 8
            Label::Over => {
                self.builtin.name == "subdivide_polygon"
                    && (read.items.len() > 1 || matches!(&read.items[0].kind, Kind::List(_)))
            }
            Label::Nodes => first.name == "nodes",
            // sign changes in 1, -2, 3
            Label::In => first.kind == Takes::Scalars && read.items.len() > 2,
            Label::With => {
                !matches!(first.kind, Takes::Size)
                    && !read.items.iter().any(|item| matches!(item.kind, Kind::Chain(..)))
            }
            _ => false,
        };
        said.iter().position(subject).map_or_else(Vec::new, |at| said.remove(at).items)
    }

    /// Whether its first argument is one formula, no list.
    pub(super) fn is_of_a_formula(&self) -> bool {
        self.builtin.parameters.first().is_some_and(|first| {
            !is_list(first.kind) && !matches!(first.kind, Takes::Curve | Takes::Geometry | Takes::Spline)
        })
    }

    /// Whether formulas are the coordinates of a curve that is wanted: the curve (t, t^2).
    fn wants_coordinates(&self, items: &[Expr]) -> bool {
        let of_curve = self.builtin.on_curve.is_some_and(|own| own.parameters.len() < 3)
            && self.builtin.parameters.first().is_some_and(|first| first.kind == Takes::Scalar);
        let takes = |first: &Parameter| matches!(first.kind, Takes::Curve | Takes::Geometry);
        (of_curve
            || !matches!(self.builtin.name, "bezier" | "inflections" | "bounding_box" | "arc_length")
                && self.builtin.parameters.first().is_some_and(takes))
            && matches!(items, [one] if is_coordinates(one))
    }

    /// Whether a curve is wanted, for which there are points.
    pub(super) fn wants_curve(&self, items: &[Expr]) -> bool {
        let Some(first) = self.builtin.parameters.first() else { return false };
        if self.wants_coordinates(items) {
            return false;
        }
        match first.kind {
            // the derivative of 0, 1, 3
            Takes::Function => {
                let number = |item: &Expr| matches!(item.kind, Kind::Number(_));
                let simple = |item: &Expr| {
                    number(item) || matches!(item.kind, Kind::Name(_) | Kind::Subscript(..) | Kind::Div(..))
                };
                let numbers = matches!(self.builtin.name, "derivative" | "integrate")
                    && (items.iter().all(number) || items.len() > 2 && items.iter().all(simple));
                items.len() > 1 && (is_points(items) || numbers)
            }
            // the blossom of 0, 1, 3
            Takes::Polynomial if self.builtin.name == "polar" => {
                items.len() > 1
                    && items.iter().all(|item| matches!(item.kind, Kind::Number(_) | Kind::Div(..)))
                    || items.len() > 1 && is_points(items)
            }
            Takes::OneOf(_) if first.name == "curve" => items.len() > 1 && is_points(items),
            Takes::OneOf(_) if first.doc.starts_with("a Bézier curve") => items.len() > 1,
            Takes::Curve | Takes::Polar | Takes::Geometry | Takes::Spline => match items {
                [Expr { kind: Kind::List(points) | Kind::Tuple(points), .. }] => !points.is_empty(),
                // two curves
                _ => {
                    items.len() > 1
                        && !items.iter().all(|item| matches!(item.kind, Kind::Apply(..) | Kind::Chain(..)))
                }
            },
            _ => false,
        }
    }

    /// Takes what the innermost function is applied to; false if it cannot.
    pub(super) fn is_about(&mut self, mut items: Vec<Expr>, said: &mut Vec<Read>) -> bool {
        let Some(first) = self.builtin.parameters.first() else { return items.is_empty() };
        if items.is_empty() {
            return first.kind == Takes::Size;
        }
        if self.wants_coordinates(&items)
            && let [Expr { kind: Kind::Tuple(coordinates), span }] = items.as_slice()
        {
            items = vec![call("curve_of", vec![list(coordinates.clone())], *span)];
        }
        // the area under y = x^2
        if let [Expr { kind: Kind::Chain(left, links), .. }] = items.as_slice()
            && let (Kind::Name(y), [Link { rel: Rel::Eq, expr, .. }]) = (&left.kind, links.as_slice())
            && (first.kind.is_formula()
                || first.kind == Takes::Polar
                || self.builtin.name == "control_points")
            && y == "y"
            && !bases(expr).contains(y)
            && self.builtin.on_equations.is_none()
        {
            items = vec![expr.clone()];
        }
        // the roots of x^2 = 1
        if let ("roots" | "count_roots", [Expr { kind: Kind::Chain(left, links), span }]) =
            (self.builtin.name, items.as_slice())
            && let [link] = links.as_slice()
            && link.rel == Rel::Eq
        {
            let terms = vec![
                Term { sign: Sign::Plus, expr: (**left).clone() },
                Term { sign: Sign::Minus, expr: one_term(link.expr.clone()) },
            ];
            items = vec![Expr { span: *span, ..Expr::sum(terms) }];
        }
        // the second coordinate was set apart as an equation
        if let [Expr { kind: Kind::Chain(..), .. }] = items.as_slice()
            && matches!(first.kind, Takes::Curve | Takes::Any | Takes::OneOf(_) | Takes::Geometry)
        {
            let coordinate = |read: &Read| match read.items.as_slice() {
                [item] => named_value(item).is_some_and(|(name, _)| name == "y" || name == "z"),
                _ => false,
            };
            items.extend(said.extract_if(.., |read| coordinate(read)).flat_map(|read| read.items));
        }
        // the implicit equation of x = t^2, y = t^3
        if matches!(first.kind, Takes::Curve | Takes::Any | Takes::OneOf(_) | Takes::Geometry)
            && items.len() > 1
        {
            let coordinate = |(item, letter): (&Expr, &str)| {
                named_value(item).filter(|(name, _)| name == letter).map(|(_, formula)| formula)
            };
            let coordinates: Option<Vec<Expr>> = items.iter().zip(["x", "y", "z"]).map(coordinate).collect();
            if let Some(coordinates) = coordinates.filter(|own| own.len() == items.len()) {
                let span = coordinates[0].span;
                // Over which interval is not said.
                if self.builtin.name == "inflections" {
                    return false;
                }
                items = vec![match first.kind {
                    Takes::Any | Takes::OneOf(_) => list(coordinates),
                    _ => call("curve_of", vec![list(coordinates)], span),
                }];
            }
        }
        // A polynomial is no list of points.
        if let ("bezier", [formula]) = (self.builtin.name, items.as_slice())
            && matches!(formula.kind, Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..))
        {
            let Some(points) = builtin("bezier_points").filter(|_| self.named.is_empty()) else {
                return false;
            };
            self.builtin = points;
            return self.is_about(items, said);
        }
        // t^2 as a spline
        if let ("bspline", [formula]) = (self.builtin.name, items.as_slice())
            && !matches!(formula.kind, Kind::List(_) | Kind::Tuple(_) | Kind::Number(_))
            && let Some(of_polynomial) = builtin("spline_of")
        {
            self.builtin = of_polynomial;
            return self.is_about(items, said);
        }
        // Coefficients: bernstein coefficients 1, 0, 1.
        if matches!(self.builtin.name, "in_bernstein" | "bezier_points" | "control_points")
            && (items.len() > 1 || matches!(&items[0].kind, Kind::List(_)))
            && let Some(bezier) = builtin("bezier")
        {
            self.builtin = bezier;
            return self.is_about(items, said);
        }
        // solve x = 3 y, y = 2
        if self.builtin.on_equations.is_some() {
            said.retain_mut(|read| {
                let equations = read.items.iter().all(|item| eval::named(item).is_some());
                let given = read.label == Label::With && equations;
                if given {
                    items.append(&mut read.items);
                }
                !given
            });
        }
        // The control points of a polynomial.
        let polynomial = !is_points(&items)
            && items.len() == 1
            && !matches!(items[0].kind, Kind::Name(_) | Kind::Apply(..));
        if self.builtin.name == "control_points"
            && polynomial
            && let Some(points) = builtin("bezier_points")
        {
            self.builtin = points;
            return self.is_about(items, said);
        }
        // [(0, 1), (1, 3)]
        if let (Takes::Scalars, [Expr { kind: Kind::List(points), .. }]) = (first.kind, items.as_slice())
            && is_points(points)
        {
            items = points.clone();
        }
        let one_list = matches!(items.as_slice(), [Expr { kind: Kind::List(_), .. }]);
        match first.kind {
            // (0, 1), (1, 3) for nodes and values
            Takes::Scalars if is_points(&items) && !one_list => match nodes_and_values(&items) {
                Some(both) => self.placed = both.into(),
                None => return false,
            },
            // Which of the corners (0, 0), (1, 2), … are neighbours?
            Takes::Net if !one_list && is_points(&items) && items.iter().all(is_flat) => return false,
            kind if is_list(kind) => {
                self.placed = match items.as_slice() {
                    [Expr { kind: Kind::List(_), .. }] => items,
                    [_] if kind == Takes::Coordinates => items,
                    // degree elevate (0, 2, 0)
                    [Expr { kind: Kind::Tuple(values), .. }] => vec![list(values.clone())],
                    _ => vec![list(items)],
                };
            }
            // the spline 1, 3, 1 over 0, 0, 0, 1, 1, 1
            Takes::Size
                if self.builtin.name == "bspline"
                    && said.iter().any(|read| {
                        read.label == Label::Knots || read.label == Label::Over && read.items.len() > 2
                    }) =>
            {
                let points = match items.as_slice() {
                    [Expr { kind: Kind::List(_), .. }] => items.swap_remove(0),
                    _ => list(items),
                };
                self.named.push(("points", points));
            }
            // A degree before knots: b-spline 0, 1, 2, 3
            Takes::Size if self.builtin.parameters.get(1).is_some_and(|second| is_list(second.kind)) => {
                let values = match items.as_slice() {
                    // greville abscissae of (0, 0, 1, 1)
                    [Expr { kind: Kind::List(values) | Kind::Tuple(values), .. }] => values.clone(),
                    _ => items,
                };
                self.named.push((self.builtin.parameters[1].name, list(values)));
            }
            // the area of (0, 0), (1, 0), (0, 1)
            Takes::Any | Takes::OneOf(_) | Takes::List if items.len() > 1 && self.is_of_one() => {
                self.placed = vec![list(items)]
            }
            // the roots of -1, 2, -2: a polynomial and an interval, or coefficients, of which basis?
            Takes::Polynomial | Takes::Formula | Takes::Scalar if items.len() > 1 && self.has_ends() => {
                return false;
            }
            _ => self.placed = items,
        }
        true
    }

    /// Whether it has one argument with a place.
    fn is_of_one(&self) -> bool {
        let placed = |p: &&Parameter| matches!(p.need, Need::Required | Need::Optional(_) | Need::Many(..));
        let mut own = self.builtin.parameters.iter().filter(placed);
        own.next().is_some_and(|first| first.need == Need::Required) && own.next().is_none()
    }

    /// The coefficient of x^3 in (1 + x)^7.
    pub(super) fn takes_coefficient(&mut self, said: &mut Vec<Read>) {
        let whole = |read: &Read| read.label == Label::In && read.items.len() == 1;
        if self.builtin.name != "coefficient" {
            return;
        }
        if let ([monomial], Some(at)) = (self.placed.as_slice(), said.iter().position(whole)) {
            let (variable, power) = match &monomial.kind {
                Kind::Pow(base, exponent) => ((**base).clone(), (**exponent).clone()),
                _ => (monomial.clone(), Expr { span: monomial.span, ..Expr::int(1) }),
            };
            self.placed = said.remove(at).items;
            self.placed.extend([variable, power]);
        }
    }

    pub(super) fn parameter(&self, names: &[&str]) -> Option<&'static Parameter> {
        let free = |p: &&Parameter| p.has_name() && !self.named.iter().any(|(name, _)| *name == p.name);
        let left = self.builtin.parameters.iter().skip(self.placed.len());
        left.filter(free).find(|p| names.contains(&p.name))
    }

    /// Takes what a label says, if there is a parameter for it; else gives it back.
    pub(super) fn take(&mut self, read: Read) -> Option<Read> {
        let read = self.take_other(read)?;
        let read = self.take_labelled(read)?;
        self.take_second(read)
    }

    fn take_labelled(&mut self, read: Read) -> Option<Read> {
        let one = read.items.len() == 1;
        let Some(first) = read.items.first().cloned() else { return Some(read) };
        // n = 3, a = 0
        if let Some((name, value)) = eval::named(&first)
            && one
            && matches!(read.label, Label::At | Label::With)
        {
            // Of a formula in that name it is the value of the name.
            let place = self.builtin.parameters.get(1).is_some_and(|second| {
                second.name == "t" && second.need == Need::Required && second.kind == Takes::Scalar
            });
            if !place && self.placed.iter().any(|formula| bases(formula).contains(&name)) {
                return Some(read);
            }
            let shown = |p: &&Parameter| p.name == name || p.form == format!("{}={name}", p.name);
            let found = self.builtin.parameters.iter().find(shown);
            // u = 1/2 is no interval of u.
            let fits = |p: &&Parameter| match p.kind {
                Takes::Variable => false,
                Takes::Interval => value.items().is_some(),
                _ => true,
            };
            let found = found.filter(fits).map(|p| p.name);
            let degree = || {
                let called = roles::is_degree(&name) || name == "p";
                let parameter = self.parameter(&["degree", "n"]).filter(|_| called);
                parameter.filter(|p| p.kind == Takes::Size).map(|p| p.name)
            };
            return match found.filter(|name| self.parameter(&[name]).is_some()).or_else(degree) {
                Some(name) => {
                    self.named.push((name, value.clone()));
                    None
                }
                None => self.take_parameter(read),
            };
        }
        // solve for a
        if self.builtin.on_equations.is_some() {
            let names =
                read.items.iter().all(|item| matches!(item.kind, Kind::Name(_) | Kind::Subscript(..)));
            if !(names && matches!(read.label, Label::With | Label::In)) {
                return Some(read);
            }
            self.named.extend(read.items.into_iter().map(|name| ("", name)));
            return None;
        }
        let number = one && matches!(first.kind, Kind::Number(_));
        let name = one && matches!(first.kind, Kind::Name(_) | Kind::Subscript(..));
        let single = |names: &[&str]| self.parameter(names).map(|p| p.name).filter(|_| one);
        let found = match read.label {
            // raise the degree by 2
            Label::In if number && matches!(self.builtin.name, "elevate" | "reduce") => single(&["k"]),
            Label::OfDegree => return self.take_degree(read, first),
            // Without weights it is not known which curve is meant.
            Label::Rational => {
                return (!self.named.iter().any(|(name, _)| *name == "weights")).then_some(read);
            }
            Label::To if number && single(&["b"]).is_some() && self.named.iter().any(|(n, _)| *n == "a") => {
                Some("b")
            }
            Label::To | Label::With | Label::Over if number => return self.take_degree(read, first),
            Label::From => single(&["a", "m", "from"]),
            Label::To if self.builtin.name == "change_of_basis" => single(&["to"]),
            Label::In | Label::To | Label::With | Label::Over if name => {
                let variable = self.builtin.parameters.iter().find(|p| p.kind == Takes::Variable);
                variable.map(|p| p.name)
            }
            // the restriction to [0, 1/2]
            Label::To if matches!(first.kind, Kind::List(_)) => return self.take_interval(read),
            // compose t^2 with t + 1
            Label::With if self.builtin.name == "compose" && self.placed.len() == 1 => {
                self.placed.extend(read.items);
                return None;
            }
            Label::Over | Label::With | Label::In => return self.take_interval(read),
            Label::Times => single(&["k", "times"]),
            Label::Number => single(&["i"]),
            // puntos de control de t^3 en [0, 2]
            Label::At
                if matches!(&first.kind, Kind::List(ends) if one && ends.len() == 2)
                    && self.has_ends()
                    && !matches!(self.builtin.name, "bezier" | "bspline" | "patch") =>
            {
                return self.take_interval(read);
            }
            Label::At => return self.take_parameter(read),
            Label::Knots | Label::Nodes | Label::Values | Label::Weights | Label::Points => {
                let name = match read.label {
                    Label::Knots => "knots",
                    Label::Nodes => "nodes",
                    Label::Values => "values",
                    Label::Weights => "weights",
                    _ => "points",
                };
                let names: &[&str] = match name {
                    "knots" => &["knots", "nodes"],
                    "points" => &["points", "net"],
                    _ => &[name],
                };
                let Some(parameter) = self.parameter(names) else { return Some(read) };
                let value = match &first.kind {
                    Kind::List(_)
                        if one
                            && (!is_points(first.items().unwrap_or_default())
                                || parameter.kind == Takes::Net) =>
                    {
                        first
                    }
                    // knots (0, 0, 1, 1)
                    Kind::Tuple(values) if one && !is_points(values) => list(values.clone()),
                    Kind::List(_) if one => first,
                    _ => list(read.items),
                };
                self.named.push((parameter.name, value));
                return None;
            }
            _ => None,
        };
        match found {
            Some(name) => {
                self.named.push((name, first));
                None
            }
            None => Some(read),
        }
    }

    /// Whether its object may be a curve, though other things may be, too.
    pub(super) fn takes_curves(&self) -> bool {
        self.builtin.parameters.first().is_some_and(|first| first.doc.contains("curve"))
    }

    /// Whether it cannot be without an interval: the part of a curve.
    pub(super) fn needs_ends(&self) -> bool {
        let end = if self.builtin.name == "over" { "a" } else { "r" };
        self.parameter(&[end]).is_some_and(|end| end.need == Need::Required)
    }

    /// Whether it takes an interval by its ends.
    pub(super) fn has_ends(&self) -> bool {
        self.parameter(&["a"]).is_some() && self.parameter(&["b"]).is_some()
    }
}
