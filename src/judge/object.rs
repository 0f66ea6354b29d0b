//! What the page says in words that its names stand for: a polar form, a B-spline, a cubic polynomial.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::context::{Body, Context};
use super::inequality::interval;
use super::names::{Head, bases, is_index_letter, walk};
use super::statement::Place;
use crate::formula::{Expr, Kind, Rel, Sign};
use crate::math::number::{Rational, integer};

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

/// How a name begins that no page has, of something without a name.
pub const UNNAMED: char = '\u{25ab}';

/// So many knots are taken of a formula for all of them.
const FORMULA_KNOTS: std::ops::Range<i64> = -4..13;

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
}

impl Object {
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
        }
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
        *self == Object { names: self.names.clone(), ..Object::new(self.sort.clone()) }
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
        let alive = |declared: &&Declared| {
            place.in_reach(&declared.place, declared.object.local) && declared.object.name_for(head).is_some()
        };
        let found = self.objects_of(&head.base).filter(alive);
        found
            .clone()
            .find(|declared| place.sees(&declared.place) && !self.is_defined_again(declared, place))
            .or_else(|| found.clone().next().filter(|declared| !self.is_past(declared, place)))
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

    /// The letters whose members are knots: those that words call so, or between which a B-spline is defined to
    /// be 1 or lives, or of whose members a claim has differences in denominators; else t.
    pub fn knot_letters(&self, place: &Place, sides: &[&Expr]) -> Vec<String> {
        let mut found = self.stated_knots(place);
        if found.is_empty() {
            found = divided_by(sides);
        }
        if found.is_empty() { vec!["t".to_owned()] } else { found }
    }

    /// The knots that the section gives by number, from the first on without a gap.
    pub fn given_knots(&self, letters: &[String], place: &Place) -> BTreeMap<i64, Rational> {
        let mut found = BTreeMap::new();
        for letter in letters {
            for (_, definition, near) in self.visible(letter, place) {
                let value = match &definition.body {
                    Body::Formula(Expr { kind: Kind::Number(q), .. }) => Some(q.clone()),
                    Body::Value(value) => value.as_rational(),
                    Body::Formula(_) => None,
                };
                // u_i = i
                if let (true, Some(Expr { kind: Kind::Name(index), .. }), Body::Formula(body)) =
                    (near && definition.head.lower.len() == 1, definition.head.index(), &definition.body)
                    && bases(body).iter().all(|name| name == index)
                    // i ∈ ℤ; n = 2 beside it says nothing of the knots.
                    && definition.conditions.iter().all(|condition| {
                        of_integers(condition) || !bases(condition).contains(index)
                    })
                {
                    for j in FORMULA_KNOTS {
                        if let Some(value) = value_at(body, index, j) {
                            found.entry(j).or_insert(value);
                        }
                    }
                }
                let index = definition.head.index().and_then(Expr::as_int);
                if let (true, Some(index), Some(value)) = (near, index, value) {
                    found.entry(index).or_insert(value);
                }
            }
        }
        if found.is_empty()
            && let Some(first) = self.first_listed(letters, place).or_else(|| self.letters.first_knot())
        {
            found = (first..).zip(self.unnamed_knots(place)).collect();
        }
        let knots: Vec<(&i64, &Rational)> = found.iter().collect();
        let whole = knots.windows(2).all(|pair| *pair[0].0 + 1 == *pair[1].0 && pair[0].1 <= pair[1].1);
        if whole && knots.len() > 2 { found } else { BTreeMap::new() }
    }

    /// The number of the first knot where the page lists their names: 0 of t_0, …, t_7.
    fn first_listed(&self, letters: &[String], place: &Place) -> Option<i64> {
        self.heard.windows(3).rev().find_map(|window| {
            let [(here, first), (_, dots), (_, last)] = window else { return None };
            let head = Head::of(first).filter(|head| letters.contains(&head.base))?;
            let listed = dots.kind == Kind::Ellipsis && Head::of(last)?.base == head.base;
            (listed && place.knows(here, false)).then(|| head.index()?.as_int())?
        })
    }

    /// Whether the section gives knots that are not at equal distances.
    pub fn has_uneven_knots(&self, place: &Place) -> bool {
        let listed = self.unnamed_knots(place);
        let given = self.given_knots(&self.stated_knots(place), place);
        let uneven =
            |knots: &[Rational]| knots.windows(3).any(|three| &three[1] - &three[0] != &three[2] - &three[1]);
        // Numbers in a row that do not decrease may be knots, whatever they are called.
        let rows = self
            .heard
            .chunk_by(|(a, _), (b, _)| a.formula == b.formula)
            .filter(|row| row.first().is_some_and(|(other, _)| other.group == place.group) && row.len() > 3);
        let mut rows = rows.filter_map(|row| row.iter().map(|(_, expr)| expr.as_number().cloned()).collect());
        let unlike = |row: Vec<Rational>| row.is_sorted() && uneven(&row);
        uneven(&listed) || uneven(&given.into_values().collect::<Vec<_>>()) || rows.any(unlike)
    }

    /// Whether the second index of a B-spline N is its degree. The page tells it by where its recursion begins, at
    /// N_{i,0}, or at N_i^1 with orders; by as many knots as a sum of B-splines needs; by the degree of its splines.
    pub fn spline_has_degree(&self, place: &Place) -> Option<bool> {
        let begins = self.visible("N", place).find_map(|(_, definition, _)| {
            let last = definition.head.upper.last().or(definition.head.lower.get(1))?;
            match last.as_int() {
                Some(0) => Some(true),
                Some(1) => Some(false),
                _ => None,
            }
        });
        let counted = || {
            let knots = self.unnamed_knots(place).len() as i64;
            self.letters.spline_sums.iter().find_map(|[from, to, size]| {
                match knots - (to - from + 1) - size {
                    1 => Some(true),
                    0 => Some(false),
                    _ => None,
                }
            })
        };
        let said = || {
            let here = self
                .objects
                .iter()
                .rev()
                .filter(|declared| place.knows(&declared.place, declared.object.local));
            let splines = here.filter(|d| matches!(d.object.sort, Sort::SplineCurve | Sort::BSpline));
            splines.filter_map(|declared| declared.object.degree.as_ref()?.as_int()).find_map(|degree| {
                let sizes = &self.letters.spline_sizes;
                match (sizes.contains(&degree), sizes.contains(&(degree + 1))) {
                    (true, false) => Some(true),
                    (false, true) => Some(false),
                    _ => None,
                }
            })
        };
        begins.or_else(counted).or_else(said)
    }

    /// The latest list of numbers that the section calls knots: the knot vector (0, 0, 0, 1, 1, 1), perhaps by a name
    /// for it, or the knots of its latest spline.
    fn unnamed_knots(&self, place: &Place) -> Vec<Rational> {
        let here =
            self.objects.iter().rev().filter(|declared| place.knows(&declared.place, declared.object.local));
        let lists = here.map(|declared| match declared.object.sort {
            Sort::Knots => declared.object.names.as_slice(),
            Sort::SplineCurve => declared.object.knots.as_slice(),
            _ => &[],
        });
        let numbers = |items: &[Expr]| -> Option<Vec<Rational>> {
            let items = match items {
                [one @ Expr { kind: Kind::Name(name), .. }] => self
                    .visible(name, place)
                    .find_map(|(_, definition, near)| match &definition.body {
                        Body::Formula(body) if near => body.elements(),
                        _ => None,
                    })
                    .or_else(|| one.elements())?,
                [one] => one.elements()?,
                items => items,
            };
            items.iter().map(|item| item.as_number().cloned()).collect()
        };
        lists.filter(|items| !items.is_empty()).find_map(numbers).unwrap_or_default()
    }

    /// The letters that the page itself gives to knots.
    pub fn stated_knots(&self, place: &Place) -> Vec<String> {
        let mut found: Vec<String> = Vec::new();
        let mut add = |expr: &Expr| {
            if let Kind::Subscript(base, _) = &expr.kind
                && let Kind::Name(letter) = &base.kind
                && !found.contains(letter)
            {
                found.push(letter.clone());
            }
        };
        let alive = |declared: &&Declared| place.in_reach(&declared.place, declared.object.local);
        for declared in self.objects.iter().filter(alive) {
            if declared.object.sort == Sort::Knots {
                declared.object.names.iter().for_each(&mut add);
            }
            if matches!(declared.object.sort, Sort::BSpline | Sort::SplineCurve) {
                declared.object.knots.iter().for_each(&mut add);
            }
        }
        for definition in self.definitions.iter().filter(|d| place.in_reach(&d.place, d.assumed)) {
            let Body::Formula(Expr { kind: Kind::Cases(cases), .. }) = &definition.body else { continue };
            for condition in cases.iter().filter_map(|(_, condition)| condition.as_ref()) {
                if let Kind::Chain(left, links) = &condition.kind
                    && let [one, two] = links.as_slice()
                    && matches!((one.rel, two.rel), (Rel::Le | Rel::Lt, Rel::Le | Rel::Lt))
                {
                    add(left);
                    add(&two.expr);
                }
            }
        }
        if found.is_empty() { self.ends_of_supports(place) } else { found }
    }

    /// The letters of the ends of intervals [u_i, u_{i+p+1}], [u_j, u_{j+1}).
    fn ends_of_supports(&self, place: &Place) -> Vec<String> {
        let letter = |end: &Expr| {
            let head = Head::of(end).filter(|head| head.arguments.is_none() && head.upper.is_empty())?;
            head.lower.iter().any(|index| !bases(index).is_empty()).then_some(head.base)
        };
        let heard = self.heard.iter().filter(|(other, _)| place.knows(other, false));
        let mut found: Vec<String> = Vec::new();
        for ([from, to], _) in heard.filter_map(|(_, expr)| interval(expr)) {
            if let (Some(one), Some(other)) = (letter(from), letter(to))
                && one == other
                && !found.contains(&one)
            {
                found.push(one);
            }
        }
        found
    }

    /// Whether a letter is not that of its standard family here: the page calls it a B-spline, or defines it by
    /// cases.
    pub fn is_own(&self, base: &str, place: &Place) -> bool {
        let spoken = self.object_called(base, place).is_some_and(|d| d.object.sort == Sort::BSpline);
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

/// i ∈ ℤ
fn of_integers(condition: &Expr) -> bool {
    matches!(&condition.kind, Kind::Chain(_, links)
        if matches!(links.as_slice(), [link] if link.rel == Rel::In && matches!(link.expr.kind, Kind::Accent(..))))
}

/// The value of a formula in an index that adds, multiplies and divides.
fn value_at(body: &Expr, index: &str, value: i64) -> Option<Rational> {
    let of = |expr: &Expr| value_at(expr, index, value);
    Some(match &body.kind {
        Kind::Name(name) if name == index => integer(value),
        Kind::Number(q) => q.clone(),
        Kind::Group(inner) => of(inner)?,
        Kind::Add(terms) => terms.iter().try_fold(integer(0), |sum, term| {
            let own = of(&term.expr)?;
            Some(if term.sign == Sign::Minus { sum - own } else { sum + own })
        })?,
        Kind::Mul(factors) => factors.iter().try_fold(integer(1), |all, own| Some(all * of(own)?))?,
        Kind::Div(above, below, _) => {
            let below = of(below)?;
            (below != integer(0)).then_some(())?;
            of(above)? / below
        }
        _ => return None,
    })
}

/// The letters in denominators that are differences of members of one family: t in (x - t_i)/(t_{i+n} - t_i).
pub fn divided_by(sides: &[&Expr]) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let member = |expr: &Expr| match &expr.kind {
        Kind::Subscript(base, _) => match &base.kind {
            Kind::Name(letter) => Some(letter.clone()),
            _ => None,
        },
        _ => None,
    };
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Div(_, below, _) = &part.kind
                && let Kind::Add(terms) = &below.kind
                && let [first, second] = terms.as_slice()
                && let (Some(a), Some(b)) = (member(&first.expr), member(&second.expr))
                && a == b
                && !found.contains(&a)
            {
                found.push(a);
            }
        });
    }
    found
}
