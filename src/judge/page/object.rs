//! What the page says in words that its names stand for: a polar form, a B-spline, a cubic polynomial.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::rc::Rc;

use crate::formula::{Expr, Kind};
use crate::judge::page::context::{Body, Context};
use crate::judge::page::statement::Place;
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::lexicon::roles;

/// What a name stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sort {
    /// The polar form of something.
    PolarForm,
    /// A function that is affine in each of its arguments.
    Affine,
    /// A polynomial, of a degree if that is said.
    Polynomial,
    /// A function of which nothing more is said.
    Function,
    /// A B-spline, a function of the basis.
    BSpline,
    /// A curve, or a segment of one, made of B-splines and control points.
    SplineCurve,
    /// A Bézier curve.
    BezierCurve,
    /// The control points of a curve.
    ControlPoints,
    /// The coefficients of a polynomial in powers, in their order.
    Coefficients,
    /// The Lagrange polynomials of nodes.
    Lagrange,
    /// The polynomial of least degree through points at nodes.
    Interpolant,
    /// The Bernstein polynomials.
    Bernstein,
    /// Symmetric functions of variables.
    Symmetric(Symmetric),
    /// Knots.
    Knots,
    /// Nodes of an interpolation.
    Nodes,
    /// A matrix.
    Matrix,
    /// A degree.
    Degree,
    /// The order of splines, which is their degree and one.
    Order,
    /// Vectors, differences of points.
    Vectors,
    /// Numbers, points, indices: symbols without properties.
    Symbols,
    /// Something else, in these words: what is claimed of it cannot be wrong as far as is known here.
    Other(Cow<'static, str>),
}

/// Families of symmetric functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetric {
    /// e_k, the sum of the products of k different variables.
    Elementary,
    /// h_k, the sum of the products of k variables.
    Complete,
    /// p_k, the sum of the k-th powers.
    PowerSum,
}

impl Symmetric {
    /// The words used in reports.
    pub fn words(self) -> &'static str {
        match self {
            Symmetric::Elementary => "an elementary symmetric function",
            Symmetric::Complete => "a complete homogeneous symmetric function",
            Symmetric::PowerSum => "a sum of powers",
        }
    }
}

/// What a curve is said to be of whose weights nothing is known.
pub const RATIONAL: &str = "rational";

/// How a name begins that no page has, of something without a name.
pub const UNNAMED: char = '\u{25ab}';

/// Something that a sentence speaks of.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its names as written.
    pub names: Vec<Expr>,
    /// What it is.
    pub sort: Sort,
    /// Its degree.
    pub degree: Option<Expr>,
    /// What it belongs to: the polar form of F, the control points of p.
    pub of: Option<Expr>,
    /// Its knots or nodes.
    pub knots: Vec<Expr>,
    /// Its control points.
    pub points: Vec<Expr>,
    /// Their weights.
    pub weights: Vec<Expr>,
    /// The values of its names, in their order: the knots t_0, …, t_3 are 0, 0, 1, 1.
    pub values: Vec<Expr>,
    /// The ends of its interval.
    pub interval: Option<(Expr, Expr)>,
    /// Whether its knots are equally spaced.
    pub uniform: bool,
    /// Whether it has weights, so that nothing is known of it without them.
    pub rational: bool,
    /// Where it has which values: it interpolates (0, 1), (1, 3).
    pub data: Vec<(Expr, Expr)>,
    /// Whether the second derivatives of a spline vanish at its ends.
    pub natural: bool,
    /// Whether its paragraph as a whole says it, and only for itself.
    pub local: bool,
    /// Whether it may be any of its sort from there on: let p be a polynomial.
    pub any: bool,
}

impl Object {
    /// The nodes or knots that it is, or that it has.
    pub fn nodes(&self) -> &[Expr] {
        match self.sort {
            Sort::Knots | Sort::Nodes => &self.names,
            _ => &self.knots,
        }
    }

    /// Nothing but a sort.
    pub fn new(sort: Sort) -> Self {
        Object {
            names: Vec::new(),
            sort,
            degree: None,
            of: None,
            knots: Vec::new(),
            points: Vec::new(),
            weights: Vec::new(),
            values: Vec::new(),
            interval: None,
            uniform: false,
            rational: false,
            data: Vec::new(),
            natural: false,
            local: false,
            any: false,
        }
    }

    /// Whether the first of the two indices of these functions is their degree, as a name with them is written: B_{n,i}.
    pub fn has_degree_first(&self, name: &Head) -> bool {
        let [first, _] = name.lower.as_slice() else { return false };
        let size = || bases(first).iter().any(|name| roles::is_degree(name));
        self.degree.as_ref().map_or_else(size, |degree| degree.same_as(first))
    }

    /// The name of the object that a head is written with, if it is one of this object: the same letter with as
    /// many indices, where numbers agree.
    pub fn name_for(&self, head: &Head) -> Option<Head> {
        self.names.iter().find_map(|name| {
            let own = Head::of(name)?;
            let fits = |pattern: &Expr, index: &Expr| match (&pattern.kind, &index.kind) {
                (Kind::Number(a), Kind::Number(b)) => a == b,
                (Kind::Number(_), _) => false,
                (Kind::Name(letter), _) if is_index_letter(letter) => true,
                // b_0, …, b_n names all of b_i.
                _ => true,
            };
            let all = self.names.iter().any(|other| other.kind == Kind::Ellipsis);
            // N_{0,2}, …, N_{3,2}: the second index is 2 in all of them.
            let last = self.names.last().and_then(Head::of);
            let constant = |at: usize, pattern: &Expr| {
                let other = last.as_ref().and_then(|last| last.lower.get(at));
                all && own.lower.len() > 1
                    && matches!(pattern.kind, Kind::Number(_))
                    && other.is_some_and(|other| other.same_as(pattern))
            };
            let same = own.base == head.base
                && own.lower.len() == head.lower.len()
                && (own.upper.len() == head.upper.len() || own.upper.is_empty() && head.arguments.is_some())
                && own
                    .lower
                    .iter()
                    .zip(&head.lower)
                    .enumerate()
                    .all(|(at, (a, b))| all && !constant(at, a) || fits(a, b));
            same.then_some(own)
        })
    }

    /// Its names with their values, dots written out; nothing if their numbers differ.
    pub fn members(&self) -> Vec<(Head, Expr)> {
        let dots = self.names.iter().any(|name| name.kind == Kind::Ellipsis);
        let Some(first) = self.names.first().and_then(Head::of) else { return Vec::new() };
        let start = first.index().and_then(Expr::as_int);
        let heads: Vec<Head> = match (dots, start) {
            (true, Some(start)) => (start..)
                .take(self.values.len())
                .map(|index| Head { lower: vec![Expr::int(index)], ..first.clone() })
                .collect(),
            (true, None) => Vec::new(),
            (false, _) => self.names.iter().filter_map(Head::of).collect(),
        };
        // x_0, …, x_3 are four: the last one says so.
        let last = |head: &Head| {
            self.names.last().and_then(Head::of).is_some_and(|last| {
                matches!((last.lower.as_slice(), head.lower.as_slice()), ([a], [b])
                if a.same_as(b) || !matches!(a.kind, Kind::Number(_)))
            })
        };
        let agree = heads.len() == self.values.len() && (!dots || heads.last().is_some_and(last));
        if agree { heads.into_iter().zip(self.values.iter().cloned()).collect() } else { Vec::new() }
    }

    /// Whether nothing is said of it but its name and sort.
    pub fn is_bare(&self) -> bool {
        *self == Object { names: self.names.clone(), any: self.any, ..Object::new(self.sort.clone()) }
    }

    /// Whether words say values that it has.
    pub fn has_data(&self) -> bool {
        !self.data.is_empty() || !self.points.is_empty()
    }

    /// Whether the page has no name for it.
    pub fn is_unnamed(&self) -> bool {
        let own = |name: &Expr| matches!(&name.kind, Kind::Name(name) if name.starts_with(UNNAMED));
        self.names.iter().all(own)
    }

    /// Whether it is a degree or an order.
    pub fn is_size(&self) -> bool {
        matches!(self.sort, Sort::Degree | Sort::Order)
    }

    /// Whether it is any function of a class in which data determine one.
    pub fn is_of_a_class(&self) -> bool {
        match self.sort {
            Sort::Polynomial => true,
            Sort::PolarForm | Sort::Affine => self.of.is_none(),
            _ => false,
        }
    }

    /// Whether it is any polynomial, spline or polar form, of a degree that is a number.
    pub fn is_any_polynomial(&self) -> bool {
        let numeric = self.degree.as_ref().is_some_and(|degree| degree.as_int().is_some());
        let given = |knot: &Expr| knot.as_number().is_some() || knot.kind == Kind::Ellipsis;
        numeric
            && match self.sort {
                Sort::Polynomial => true,
                Sort::BezierCurve => self.points.is_empty() && !self.rational,
                Sort::PolarForm => self.of.is_none(),
                Sort::SplineCurve => {
                    self.points.is_empty() && !self.knots.is_empty() && self.knots.iter().all(given)
                }
                _ => false,
            }
    }

    /// Whether it can be applied to arguments.
    pub fn is_function(&self) -> bool {
        matches!(
            self.sort,
            Sort::PolarForm
                | Sort::Affine
                | Sort::Polynomial
                | Sort::Function
                | Sort::BSpline
                | Sort::SplineCurve
                | Sort::BezierCurve
                | Sort::Lagrange
                | Sort::Interpolant
                | Sort::Bernstein
                | Sort::Symmetric(_)
        )
    }

    /// Whether its names have values by it, if it is not all that is said of them.
    pub fn has_values(&self) -> bool {
        self.determines() || self.sort == Sort::ControlPoints && self.of.is_some()
    }

    /// Whether it says all about its names, so that an equation for one of them is a claim.
    pub fn determines(&self) -> bool {
        match self.sort {
            Sort::PolarForm => self.of.is_some(),
            // β_0, …, β_3 of a degree that is not said
            Sort::Bernstein => {
                let indices =
                    self.names.iter().filter_map(Head::of).map(|head| head.lower.len() + head.upper.len());
                self.degree.is_some() || indices.max() != Some(1)
            }
            Sort::Lagrange | Sort::Symmetric(_) => !self.knots.is_empty(),
            Sort::BezierCurve | Sort::Interpolant => !self.points.is_empty(),
            Sort::SplineCurve => (self.uniform || !self.knots.is_empty()) && !self.points.is_empty(),
            Sort::BSpline => self.degree.is_some(),
            // Points of this very curve, as its paragraph says
            Sort::ControlPoints | Sort::Coefficients => self.local && self.of.is_some(),
            _ => false,
        }
    }
}

/// An object and where it was introduced.
#[derive(Clone, Debug)]
pub struct Declared {
    /// What.
    pub object: Rc<Object>,
    /// Where.
    pub place: Place,
    /// The line, for reports.
    pub line: usize,
}

impl Context {
    /// What a head is, as far as words tell: the latest object of its name, those of the same section first.
    pub fn object(&self, head: &Head, place: &Place) -> Option<&Declared> {
        self.remembered(head, place, || self.object_number(head, place))
    }

    fn object_number(&self, head: &Head, place: &Place) -> Option<usize> {
        let alive = |(_, declared): &(usize, &Declared)| {
            place.in_reach(&declared.place, declared.object.local)
                && !place.frees(&head.base, &declared.place)
                && declared.object.name_for(head).is_some()
        };
        let found = self.numbered_objects(&head.base).filter(alive);
        let near = found
            .clone()
            .find(|(_, declared)| place.sees(&declared.place) && !self.is_defined_again(declared, place));
        let far = || found.clone().next().filter(|(_, declared)| !self.is_past(declared, place));
        near.or_else(far).map(|(number, _)| number)
    }

    /// Whether a name got another formula since words spoke of it: H = FG is a quadratic, then F is another one.
    fn is_defined_again(&self, declared: &Declared, place: &Place) -> bool {
        declared.object.names.iter().filter_map(Head::of).any(|head| {
            let formulas = || {
                let near = self.visible(&head.base, place).filter(|(_, definition, near)| {
                    *near && definition.head.lower.is_empty() && definition.head.arguments.is_some()
                });
                near.map(|(_, definition, _)| definition.place.formula)
            };
            let since = declared.place.formula;
            formulas().any(|at| at > since) && formulas().any(|at| at <= since)
        })
    }

    /// Whether a section speaks anew of what another one introduced, or of what that belongs to.
    fn is_past(&self, declared: &Declared, place: &Place) -> bool {
        let object = &declared.object;
        let since = &declared.place;
        object.names.iter().chain(&object.of).filter_map(Head::of).any(|head| {
            let later = |other: &Place| place.sees(other) && other.formula > since.formula;
            self.visible(&head.base, place).any(|(_, definition, _)| later(&definition.place))
                || self.is_spoken_of_anew(&head.base, since, place)
        })
    }

    /// Whether words of this section say what a letter stands for that another one used before, or those of a section
    /// in between, which does not know that one: the last meaning counts.
    pub fn is_spoken_of_anew(&self, base: &str, since: &Place, place: &Place) -> bool {
        let anew = |other: &Place| {
            let between = !place.sees(since) && place.in_reach(other, false) && !other.sees(since);
            other.formula > since.formula && (place.sees(other) || between)
        };
        self.objects_of(base).any(|declared| anew(&declared.place))
    }

    /// Whether words of a later paragraph of this section let a function be any of its sort: the formula of an example is no
    /// longer that of p after "let p be a polynomial of degree n".
    pub fn is_any_since(&self, base: &str, since: &Place, place: &Place) -> bool {
        self.objects_of(base).any(|declared| {
            let own = &declared.place;
            declared.object.any
                && own.formula > since.formula
                && own.group > since.group
                && place.knows(own, false)
        })
    }

    /// The names in formulas, and those that the definitions and objects of these lead to.
    pub fn reached(&self, sides: &[&Expr], place: &Place) -> BTreeSet<String> {
        let mut found: BTreeSet<String> = sides.iter().flat_map(|side| bases(side)).collect();
        let mut next: Vec<String> = found.iter().cloned().collect();
        while let Some(base) = next.pop() {
            let mut more = BTreeSet::new();
            for (_, definition, _) in self.visible(&base, place) {
                if let Body::Formula(body) = &definition.body {
                    more.extend(bases(body));
                }
            }
            if let Some(declared) = self.object_called(&base, place) {
                let object = &declared.object;
                object.of.iter().chain(&object.points).for_each(|part| more.extend(bases(part)));
            }
            for name in more {
                if found.insert(name.clone()) {
                    next.push(name);
                }
            }
        }
        found
    }

    /// Whether a letter is not that of its standard family here: the page calls it a B-spline, or defines it by
    /// cases.
    pub fn is_own(&self, base: &str, place: &Place) -> bool {
        let spoken = self
            .object_called(base, place)
            .is_some_and(|d| matches!(d.object.sort, Sort::BSpline | Sort::Other(_)));
        spoken
            || self.visible(base, place).any(|(_, definition, _)| {
                let named = |argument: &&Expr| matches!(argument.kind, Kind::Name(_));
                matches!(&definition.body, Body::Formula(Expr { kind: Kind::Cases(_), .. }))
                    && !definition.head.lower.is_empty()
                    && definition.head.flat().iter().all(named)
            })
    }

    /// Whether the paragraph as a whole tells what a letter is: a curve, its points.
    pub fn is_told(&self, base: &str, place: &Place) -> bool {
        let own = |expr: &Expr| Head::of(expr).is_some_and(|head| head.base == base);
        let here =
            self.objects.iter().rev().filter(|told| told.object.local && place.knows(&told.place, true));
        here.map(|told| &told.object).any(|object| object.names.iter().chain(&object.points).any(own))
    }

    /// What stands in the place of a name whatever its indices are.
    pub fn object_called(&self, base: &str, place: &Place) -> Option<&Declared> {
        self.objects_of(base).find(|declared| place.in_reach(&declared.place, declared.object.local))
    }

    /// The same, if it is any function of a class that the page names.
    pub fn object_of_a_class(&self, base: &str, place: &Place) -> Option<&Object> {
        let object = &*self.object_called(base, place)?.object;
        object.is_of_a_class().then_some(object)
    }
}
