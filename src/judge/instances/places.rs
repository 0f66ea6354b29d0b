//! Where piecewise polynomials are tried: near parameters in each knot interval.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::formula::{BigOp, Expr, Kind, Rel};
use crate::judge::instances::integers::as_values;
use crate::judge::instances::trial::Trial;
use crate::judge::model::Model;
use crate::judge::page::context::{Body, is_variable};
use crate::judge::page::object::{Object, Sort};
use crate::judge::values::evaluator;
use crate::judge::written::features::has_splines;
use crate::judge::written::names::{Head, bases, has_members, is_index_letter, is_range, walk};
use crate::language::lexicon::families;
use crate::language::lexicon::families::Family;
use crate::language::value::Value;
use crate::math::number::{Rational, integer};
use crate::math::poly::Symbol;
use crate::math::ring::Ring;
use num_traits::Zero;

/// Knots that the page gives are tried up to this number.
const LAST_GIVEN: i64 = 24;

/// The same of knots that are given by a formula, for all degrees up to 4.
const LAST_COVERED: i64 = 8;

/// Generic knot intervals are tried from number 0 to this one.
const LAST_INTERVAL: i64 = 3;

impl Trial<'_> {
    /// Whether it is about piecewise polynomials.
    pub(in crate::judge) fn has_pieces(&self) -> bool {
        has_splines(&self.sides)
            || self.sides.iter().any(|side| has_cases_of_variables(side))
            || self.defined_by_splines()
            || self.speaks_of_splines()
    }

    /// Whether a name in it was introduced as a B-spline or a curve of them.
    fn speaks_of_splines(&self) -> bool {
        self.spoken().any(|object| {
            object.sort == Sort::BSpline
                || object.sort == Sort::SplineCurve && !object.knots.is_empty() && !object.points.is_empty()
        })
    }

    /// What words introduced of the names in it.
    pub(in crate::judge) fn spoken(&self) -> impl Iterator<Item = &Object> {
        self.spoken_of(&self.facts.reached)
    }

    fn spoken_of<'b>(&'b self, names: &'b BTreeSet<String>) -> impl Iterator<Item = &'b Object> {
        names.iter().filter_map(|base| Some(&*self.context.object_called(base, self.place)?.object))
    }

    /// The knots that words give for splines with these names, in increasing order.
    pub(in crate::judge) fn breaks(&self, bound: &[(String, i64)], of: &BTreeSet<String>) -> Vec<Rational> {
        let model = Rc::new(self.model(None, None, &[]));
        let names: Vec<(Symbol, Value)> = as_values(bound).collect();
        let mut found: Vec<Rational> = Vec::new();
        let splines = |object: &&Object| matches!(object.sort, Sort::BSpline | Sort::SplineCurve);
        for object in self.spoken_of(of).filter(splines) {
            let mut add = |own: &[(Symbol, Value)]| {
                let names: Vec<(Symbol, Value)> = names.iter().chain(own).cloned().collect();
                let knots = evaluator::machine().with_locals(names, |machine| {
                    if object.sort == Sort::SplineCurve {
                        return Ok(model.all_knots(machine, object, &Vec::new()));
                    }
                    let degree = object.degree.as_ref().and_then(|degree| machine.eval_int(degree).ok());
                    let degree = degree.and_then(|degree| usize::try_from(degree).ok());
                    let own =
                        degree.and_then(|degree| model.explicit_knots(machine, object, &Vec::new(), degree));
                    Ok(own.or_else(|| model.all_knots(machine, object, &Vec::new())))
                });
                found.extend(knots.ok().flatten().unwrap_or_default());
            };
            // N_i with the knots i, …, i + 3
            match object.names.iter().find_map(free_index).filter(|own| !bound.iter().any(|(b, _)| b == own))
            {
                Some(own) => add(&[(Symbol::new(&own), Value::int(0))]),
                None => add(&[]),
            }
        }
        // max(x - 2, 0)^3, |x| = x for x >= 0
        for side in &self.sides {
            walk(side, &mut |part| {
                let Kind::Cases(cases) = &part.kind else { return };
                for condition in cases.iter().filter_map(|(_, condition)| condition.as_ref()) {
                    found.extend(ends(condition));
                }
            });
        }
        found.sort();
        found.dedup();
        // One break alone has no interval.
        if let [only] = found.as_slice() {
            found = vec![only - integer(1), only.clone(), only + integer(1)];
        }
        found
    }

    /// The parameters near which piecewise polynomials are compared: in every interval between knots, and for given
    /// knots also beside them, as far as the conditions allow.
    pub(in crate::judge) fn places(&self, bound: &[(String, i64)], breaks: &[Rational]) -> Vec<Rational> {
        let model = self.model(None, Some(Rational::zero()), breaks);
        let last = match self.facts.given_knots.first_key_value() {
            // Knots by a formula for all i: a sum over all splines is whole only where those that are taken cover it.
            Some((first, _)) if *first < 0 => LAST_COVERED,
            Some(_) => LAST_GIVEN,
            None => LAST_INTERVAL + 1,
        };
        let generic: Vec<Rational> = (0..=last).map(|j| model.knot(j)).collect();
        let knots = if breaks.is_empty() { generic } else { breaks.to_vec() };
        let mut places: Vec<Rational> = Vec::new();
        for ends in knots.windows(2).filter(|ends| ends[0] < ends[1]) {
            let inside = |a: i64, b: i64| (&ends[0] * integer(a) + &ends[1] * integer(b)) / integer(a + b);
            match breaks.is_empty() {
                true => places.push(inside(1, 1)),
                false => places.extend([inside(2, 1), inside(1, 3)]),
            }
        }
        if let (false, [first, .., last]) = (breaks.is_empty(), knots.as_slice()) {
            places.extend([first - integer(1), last + integer(1)]);
        }
        self.keep_the_segments_meant(&knots, &mut places);
        let mentions_knots = |condition: &&Expr| has_members(condition, &self.facts.knot_letters);
        let conditions: Vec<&Expr> =
            self.conditions.iter().chain(self.hypotheses().iter().filter(mentions_knots)).collect();
        let variables: Vec<&Expr> =
            self.hypotheses().iter().filter(|range| self.is_of_a_variable(range)).collect();
        // At t = 1
        if let Some(place) = conditions.iter().find_map(|condition| number_of_variable(condition)) {
            return vec![place];
        }
        // Σ_{i=a}^b c_i N_{i,p} is meant where no other N_{i,p} lives, if nothing else is said.
        let between_knots = |condition: &&Expr| {
            mentions_knots(condition) && own_variables(condition).iter().any(|name| is_variable(name))
        };
        if !self.conditions.iter().any(|one| mentions_knots(&one))
            && !self.hypotheses().iter().any(|one| between_knots(&one))
        {
            for [from, to, degree] in self.sums_of_splines(bound) {
                let (start, end) = (model.knot(from + degree), model.knot(to + 1));
                if breaks.is_empty() {
                    places.retain(|place| start <= *place && *place < end);
                }
            }
        }
        let names = |reading: &Model| -> Vec<(Symbol, Value)> {
            reading.knots(&self.facts.knot_letters).into_iter().chain(as_values(bound)).collect()
        };
        // f is the polar form of the piece on [u_j, u_{j+1})
        if let (Some(ends), true) = (self.piece_heard(), breaks.is_empty()) {
            let names = names(&model);
            let [from, to] = ends.map(|end| {
                let value = evaluator::machine().with_locals(names.clone(), |machine| machine.eval(end));
                value.ok().and_then(|value| value.as_rational())
            });
            if let (Some(from), Some(to)) = (from, to) {
                places.retain(|place| from <= *place && *place < to);
            }
        }
        let allows = |place: &Rational, conditions: &[&Expr]| {
            let reading = Rc::new(self.model(None, Some(place.clone()), breaks));
            let names = names(&reading);
            conditions.iter().all(|condition| {
                let held = evaluator::machine()
                    .with_locals(names.clone(), |machine| Ok(reading.holds_here(machine, condition)));
                held.ok().flatten() != Some(false)
            })
        };
        places.retain(|place| allows(place, &conditions));
        if places.iter().any(|place| allows(place, &variables)) {
            places.retain(|place| allows(place, &variables));
        }
        places
    }

    /// The interval between knots of which the paragraph speaks, if it is one, and sides are about a polar form.
    fn piece_heard(&self) -> Option<[&Expr; 2]> {
        let form = |part: &Expr| match &part.kind {
            Kind::Apply(callee, groups) => {
                matches!(callee.kind, Kind::Name(_) | Kind::Subscript(..))
                    && groups.iter().map(Vec::len).sum::<usize>() > 1
            }
            _ => false,
        };
        if !self.sides.iter().any(|side| side.has(&form)) {
            return None;
        }
        let knots = |end: &Expr| has_members(end, &self.facts.knot_letters);
        // "f the blossom of the piece on [t_j, t_{j+1})", perhaps in an earlier paragraph
        let mut forms = self.spoken().filter(|object| object.sort == Sort::PolarForm);
        let own = forms.find_map(|form| form.interval.as_ref());
        if let Some((from, to)) = own.filter(|(from, to)| knots(from) && knots(to)) {
            return Some([from, to]);
        }
        let heard = self.context.intervals_beside(self.place).map(|(_, ends, _)| ends);
        let mut heard = heard.filter(|ends| ends.iter().all(|end| knots(end)));
        let first = heard.next()?;
        heard.all(|other| other[0].same_as(first[0]) && other[1].same_as(first[1])).then_some(first)
    }

    /// "First piece, 0 ≤ t < 1": where the variable of a side lies in this paragraph.
    fn is_of_a_variable(&self, range: &Expr) -> bool {
        let names = own_variables(range);
        is_range(range)
            && matches!(names.as_slice(), [name] if is_variable(name))
            && self.sides.iter().any(|side| {
                let mut found = false;
                walk(side, &mut |part| {
                    if let Kind::Apply(_, groups) = &part.kind {
                        found |= groups.iter().flatten().any(|argument| own_variables(argument) == names);
                    }
                });
                found
            })
    }

    /// x(0, 0) on the knots 0, 0, 0, 1, 2, 2, 2 is a value of the polar form of a segment that touches these arguments.
    fn keep_the_segments_meant(&self, knots: &[Rational], places: &mut Vec<Rational>) {
        let mut hulls: Vec<(Rational, Rational)> = Vec::new();
        for side in &self.sides {
            walk(side, &mut |part| {
                let Kind::Apply(callee, groups) = &part.kind else { return };
                let ([arguments], Kind::Name(_)) = (groups.as_slice(), &callee.kind) else { return };
                let numbers: Option<Vec<Rational>> = arguments.iter().map(evaluator::number).collect();
                let Some(numbers) = numbers.filter(|numbers| numbers.len() > 1) else { return };
                hulls.extend(numbers.iter().min().cloned().zip(numbers.iter().max().cloned()));
            });
        }
        let meant = |place: &Rational| {
            let start = knots.iter().filter(|knot| *knot <= place).max();
            let end = knots.iter().filter(|knot| *knot > place).min();
            let (Some(start), Some(end)) = (start, end) else { return false };
            hulls.iter().all(|(least, most)| match least == most {
                true => start <= least && least <= end,
                false => start < most && least < end,
            })
        };
        if !hulls.is_empty() && places.iter().any(&meant) {
            places.retain(meant);
        }
    }

    /// The bounds and the degree of each sum of B-splines in the sides, for some values of the integers.
    fn sums_of_splines(&self, bound: &[(String, i64)]) -> Vec<[i64; 3]> {
        let names: Vec<(Symbol, Value)> = as_values(bound).collect();
        let number = |expr: &Expr, own: &[(Symbol, Value)]| {
            let names: Vec<_> = names.iter().chain(own).cloned().collect();
            let value = evaluator::machine().with_locals(names, |machine| machine.eval_int(expr));
            value.ok()
        };
        // C'(u), where C(u) = Σ P_i N_{i,p}(u)
        let defined = self.facts.reached.iter().filter_map(|base| {
            match &self.context.visible(base, self.place).next()?.1.body {
                Body::Formula(body) => Some(body),
                Body::Value(_) => None,
            }
        });
        let order = i64::from(self.context.spline_has_degree(self.place) == Some(false));
        let mut found = Vec::new();
        for side in self.sides.iter().copied().chain(defined) {
            walk(side, &mut |part| {
                let Kind::Big { op: BigOp::Sum, lower, upper: Some(upper), body } = &part.kind else {
                    return;
                };
                let [Expr { kind: Kind::Chain(own, links), .. }] = lower.as_slice() else { return };
                let (Kind::Name(index), [link]) = (&own.kind, links.as_slice()) else { return };
                walk(body, &mut |inner| {
                    let Some(head) = Head::of(inner).filter(|head| head.is_a(Family::Spline)) else { return };
                    // N_i, N_{i+1}
                    let runs = |expr: &&Expr| bases(expr).contains(index);
                    let mut indices = head.lower.iter().chain(&head.upper);
                    if let (Some(own), Some(degree)) = (indices.next().filter(runs), indices.next())
                        && let (Some(from), Some(to), Some(degree)) =
                            (number(&link.expr, &[]), number(upper, &[]), number(degree, &[]))
                    {
                        let at = |end: i64| number(own, &[(Symbol::new(index), Value::int(end))]);
                        let ends = at(from).zip(at(to));
                        found.extend(ends.map(|(from, to)| [from, to, degree - order]));
                    }
                });
            });
        }
        found
    }

    /// Whether a function in it is defined by B-splines.
    fn defined_by_splines(&self) -> bool {
        self.facts.reached.iter().any(|base| {
            self.context.visible(base, self.place).next().is_some_and(
                |(_, definition, _)| matches!(&definition.body, Body::Formula(body) if has_splines(&[body])),
            )
        })
    }

    /// Whether the notes define B-splines over the integers: i ≤ t < i + 1.
    pub(in crate::judge) fn has_integer_knots(&self) -> bool {
        // N_0(t) = (1 - t)^2 is one of them.
        let general = |head: &Head| head.lower.iter().all(|index| !matches!(index.kind, Kind::Number(_)));
        let mut all = self.context.visible(families::SPLINE, self.place);
        let defined = all.find(|(_, definition, _)| general(&definition.head));
        let indexed = |expr: &Expr| has_members(expr, &self.facts.knot_letters);
        let free = !self.sides.iter().any(|side| indexed(side));
        if self.sides.iter().any(|side| has_cases_of_variables(side)) {
            return free;
        }
        match defined.map(|(_, definition, _)| &definition.body) {
            Some(Body::Formula(body)) => {
                free && (!indexed(body) || self.sides.iter().any(|side| is_shifted(side)))
            }
            _ => false,
        }
    }
}

/// The number that a condition gives to a variable: 1 in t = 1.
fn number_of_variable(condition: &Expr) -> Option<Rational> {
    let Kind::Chain(left, links) = &condition.kind else { return None };
    match (&left.kind, links.as_slice()) {
        (Kind::Name(name), [link]) if link.rel == Rel::Eq && is_variable(name) => {
            evaluator::machine().eval(&link.expr).ok()?.as_rational()
        }
        _ => None,
    }
}

/// Whether a B-spline is moved by a number: N_{0,p}(u - 1) has a meaning of its own for integer knots only.
fn is_shifted(side: &Expr) -> bool {
    side.has(&|part: &Expr| {
        let Kind::Apply(callee, groups) = &part.kind else { return false };
        let [group] = groups.as_slice() else { return false };
        let [Expr { kind: Kind::Add(terms), .. }] = group.as_slice() else { return false };
        let spline = Head::of(callee).is_some_and(|head| head.base == families::SPLINE);
        let [first, second] = terms.as_slice() else { return false };
        spline
            && matches!(&first.expr.kind, Kind::Name(name) if is_variable(name))
            && matches!(second.expr.kind, Kind::Number(_))
    })
}

/// Whether cases in a formula depend on where a variable lies.
fn has_cases_of_variables(side: &Expr) -> bool {
    let mut found = false;
    walk(side, &mut |part| {
        if let Kind::Cases(cases) = &part.kind {
            let mut conditions = cases.iter().filter_map(|(_, condition)| condition.as_ref());
            found |= conditions.any(|condition| {
                is_order(condition) && own_variables(condition).iter().any(|name| is_variable(name))
            });
        }
    });
    found
}

fn is_order(condition: &Expr) -> bool {
    matches!(&condition.kind, Kind::Chain(_, links)
        if links.iter().all(|link| matches!(link.rel, Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge)))
}

/// The names without an index in a condition.
fn own_variables(condition: &Expr) -> Vec<String> {
    let mut found = Vec::new();
    fn collect(expr: &Expr, found: &mut Vec<String>) {
        match &expr.kind {
            Kind::Name(name) => found.push(name.clone()),
            Kind::Subscript(..) => {}
            _ => expr.for_each_child(&mut |child| collect(child, found)),
        }
    }
    collect(condition, &mut found);
    found
}

/// Where a variable, perhaps shifted by a number, meets the numbers of a condition: 2 in x - 2 >= 0.
fn ends(condition: &Expr) -> Vec<Rational> {
    let Kind::Chain(left, links) = &condition.kind else { return Vec::new() };
    let sides: Vec<&Expr> =
        std::iter::once(left.as_ref()).chain(links.iter().map(|link| &link.expr)).collect();
    let mut found = Vec::new();
    for pair in sides.windows(2) {
        let value = |expr: &Expr| match evaluator::machine().eval(expr) {
            Ok(Value::Scalar(value)) => Some(value),
            _ => None,
        };
        let (Some(a), Some(b)) = (value(pair[0]), value(pair[1])) else { continue };
        let difference = a.minus(&b);
        let Some(polynomial) = difference.as_polynomial() else { continue };
        if let [variable] = polynomial.variables()
            && let [constant, slope] = polynomial.coefficients_in(variable).as_slice()
            && let (Some(constant), Some(slope)) = (constant.as_constant(), slope.as_constant())
        {
            found.push(-constant / slope);
        }
    }
    found
}

/// The index of a family: i in N_i.
fn free_index(name: &Expr) -> Option<String> {
    Head::of(name)?.lower.iter().find_map(|index| match &index.kind {
        Kind::Name(letter) if is_index_letter(letter) => Some(letter.clone()),
        _ => None,
    })
}
