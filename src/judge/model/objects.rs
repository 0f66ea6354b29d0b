//! Values of what the page introduced in words: polar forms, B-splines, Bézier curves, their points.

use super::calls::{each, unclear, variable};
use super::families::lagrange;
use super::lists::{combination, index_of_support};
use std::rc::Rc;

use super::{Bound, Evaluated, Model};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::context::{Body, is_variable};
use crate::judge::page::object::{Declared, Object, Sort};
use crate::judge::values::inequality::is_unit;
use crate::judge::written::names::{Head, bases, is_capital, is_index_letter};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::lexicon::families;
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::blossom::{Argument, PolarForm};
use crate::math::number::{Rational, integer};
use crate::math::poly::{Coefficients, Fraction, Index, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

/// The variable in which a polynomial is taken apart.
pub(super) const PLACE: &str = "\u{25e6}";

impl Model {
    /// The object that a head is one of.
    pub(super) fn object(&self, head: &Head) -> Option<&Declared> {
        self.context.object(head, &self.place)
    }

    /// The same, shared, with the line where it was introduced.
    pub(super) fn declared(&self, head: &Head) -> Option<(Rc<Object>, usize)> {
        self.object(head).map(|declared| (declared.object.clone(), declared.line))
    }

    /// Works out what a name is, unless that is what is being worked out.
    fn once<T>(&self, name: &str, work: impl FnOnce() -> Option<T>) -> Option<T> {
        if !self.open.borrow_mut().insert(name.to_owned()) {
            return None;
        }
        let result = work();
        self.open.borrow_mut().remove(name);
        result
    }

    /// What the indices of an object stand for in a name of it: i and n in B_2^5, if it was introduced as B_i^n.
    fn indices(&self, machine: &mut Machine, object: &Object, head: &Head) -> Bound {
        let Some(own) = object.name_for(head) else { return Bound::new() };
        let pairs = own.lower.iter().chain(&own.upper).zip(head.lower.iter().chain(&head.upper));
        let letter = |pattern: &Expr| match &pattern.kind {
            Kind::Name(name) if is_index_letter(name) => Some(Symbol::new(name)),
            _ => None,
        };
        pairs
            .filter_map(|(pattern, index)| Some((letter(pattern)?, machine.eval(index).ok()?)))
            .filter(|(_, value)| value.as_int().is_some())
            .collect()
    }

    /// The degree that was said of an object.
    fn stated_degree(&self, machine: &mut Machine, object: &Object, bound: &Bound) -> Option<usize> {
        let degree = object.degree.as_ref()?;
        let value = machine.with_locals(bound.clone(), |machine| machine.eval(degree)).ok()?;
        match value.as_int() {
            Some(degree) => usize::try_from(degree).ok(),
            // Of degree n, where n is nothing else here.
            None => {
                if let Some(last) = self.context.degree_in_data(object, &self.place) {
                    return Some(last);
                }
                if self.degree.is_none() {
                    self.record.borrow_mut().wants_degree = true;
                }
                self.degree
            }
        }
    }

    /// The degree of a function by name, as far as words say it.
    fn degree_of(&self, machine: &mut Machine, of: &Expr) -> Option<usize> {
        let head = Head::of(of)?;
        let (object, _) = self.declared(&head)?;
        let bound = self.indices(machine, &object, &head);
        self.stated_degree(machine, &object, &bound)
    }

    /// How many arguments a polar form takes, if words say it.
    pub(super) fn stated_arity(&self, machine: &mut Machine, head: &Head) -> Option<usize> {
        let (object, _) = self.declared(head)?;
        if object.sort != Sort::PolarForm {
            return None;
        }
        // f^{(+1)} has another number of arguments than f.
        if !head.upper.is_empty() && object.name_for(head)?.upper.is_empty() {
            return None;
        }
        let bound = self.indices(machine, &object, head);
        self.stated_degree(machine, &object, &bound)
            .or_else(|| object.of.as_ref().and_then(|of| self.degree_of(machine, of)))
    }

    /// The value of a function that words introduced.
    pub(super) fn spoken(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: &[Vec<Value>],
        expr: &Expr,
    ) -> Option<Evaluated> {
        let (object, line) = self.declared(head)?;
        let bound = self.indices(machine, &object, head);
        if let (Sort::PolarForm, Some(of), [u, v]) = (&object.sort, &object.of, values) {
            return Some(self.tensor_of(machine, of, u, v, expr));
        }
        let [arguments] = values else { return None };
        if let Sort::Symmetric(kind) = object.sort {
            return self.symmetric(machine, &object, kind, head, Some(arguments));
        }
        let one = match arguments.as_slice() {
            [Value::Scalar(x)] => Some(x.clone()),
            _ => None,
        };
        let note = |what: &str| self.note(format!("{} is {what} of line {line}", head.base));
        let result = match object.sort {
            // F may be known by f only.
            // f may be the polar form of F, of which the page speaks elsewhere; f^{(+1)} is another one.
            Sort::PolarForm | Sort::Affine
                if object.of.is_none()
                    && head.upper.is_empty()
                    && (object.sort == Sort::Affine || object.degree.is_some() || is_capital(&head.base)) =>
            {
                let stated = self.stated_degree(machine, &object, &bound);
                if stated.is_none() {
                    self.record.borrow_mut().arities.insert(arguments.len());
                }
                let degree = stated.unwrap_or(arguments.len());
                self.note_generic(format!("{} is affine in each argument, of line {line}", head.base));
                self.any_affine(&object, head, degree, arguments, expr)
            }
            Sort::Affine => return None,
            // f_j, the polar form of a spline on some piece
            Sort::PolarForm if self.is_local() && object.interval.is_none() && !head.lower.is_empty() => {
                return Some(Err(unclear("of which piece this is the polar form", expr)));
            }
            Sort::PolarForm => self.once(&format!("polar form {}", head.base), || {
                let of = object.of.as_ref()?;
                if let Some(value) = self.of_any_piece(machine, &object, head, of, arguments, expr) {
                    return Some(value);
                }
                note("the polar form");
                // Of the piece on an interval.
                let piece = object.interval.as_ref().filter(|_| self.is_local()).and_then(|(from, to)| {
                    let ends = machine
                        .with_locals(bound.clone(), |machine| Ok((machine.eval(from)?, machine.eval(to)?)));
                    let (from, to) = ends.ok()?;
                    Some((from.as_rational()? + to.as_rational()?) / integer(2))
                });
                Some(match piece {
                    Some(middle) => {
                        self.moved(Some(middle), || self.polar_form(machine, head, of, arguments, expr))
                    }
                    // β_i^n, of B_i^n
                    None => machine.with_locals(bound.clone(), |machine| {
                        self.polar_form(machine, head, of, arguments, expr)
                    }),
                })
            })?,
            // "the cubics B_0^3, …" says nothing new of what has a meaning.
            Sort::Polynomial if head.notation().is_some() => return None,
            Sort::Polynomial => {
                let degree = self.stated_degree(machine, &object, &bound)?;
                let x = one?;
                self.note_generic(format!(
                    "{} is any polynomial of degree {degree} of line {line}",
                    head.base
                ));
                Ok(Value::Scalar(self.generic(machine, head, degree, expr).value(&x)))
            }
            Sort::BSpline => {
                let x = one?;
                let degree = self.stated_degree(machine, &object, &bound)?;
                let knots = match self.knots_of(machine, &object, head, &bound, degree, expr)? {
                    Ok(knots) => knots,
                    Err(error) => return Some(Err(error)),
                };
                note("the B-spline");
                self.local_spline(&knots, &x, expr).map(Value::Scalar)
            }
            Sort::SplineCurve if object.uniform && object.interval.is_some() => {
                let x = one?;
                let degree = self.stated_degree(machine, &object, &bound)?;
                let points = self.points(machine, &object.points, &bound, degree)?;
                note("a uniform segment");
                let x = self.reparametrised(machine, &object, &x)?;
                let weights = (0..=degree as i64).map(|j| {
                    let knots: Vec<Rational> = (j - degree as i64..=j + 1).map(integer).collect();
                    families::spline(&knots, degree as i64 - j, &x).unwrap_or_else(Fraction::zero)
                });
                combination(&points, &weights.collect::<Vec<_>>())
            }
            // s = Σ d_i N_i, where the function that belongs to d_i lives between u_i and u_{i+4}
            Sort::SplineCurve
                if index_of_support(&object).is_some()
                    && (self.is_local() || one.as_ref().is_some_and(|x| x.as_rational().is_some())) =>
            {
                let (x, degree) = (one?, self.stated_degree(machine, &object, &bound)?);
                note("the spline curve");
                return self.by_supports(machine, &object, &bound, degree, &x, expr);
            }
            Sort::SplineCurve if !object.knots.is_empty() && !object.points.is_empty() => {
                let x = one?;
                let knots = self.all_knots(machine, &object, &bound)?;
                let stated = self.stated_degree(machine, &object, &bound);
                let count = self.count(machine, &object.points, &bound);
                let degree = stated.or_else(|| knots.len().checked_sub(count? + 1))?;
                let points =
                    self.points(machine, &object.points, &bound, knots.len().checked_sub(degree + 2)?)?;
                note("the spline curve");
                let weights: Result<Vec<Fraction>, Diagnostic> =
                    knots.windows(degree + 2).map(|window| self.local_spline(window, &x, expr)).collect();
                match weights {
                    Ok(basis) => combination(&points, &self.weighted(machine, &object, &bound, basis)?),
                    Err(error) => Err(error),
                }
            }
            Sort::SplineCurve if object.points.is_empty() && !self.is_local() => {
                let x = one?;
                let degree = self.stated_degree(machine, &object, &bound)?;
                self.any_spline(machine, &object, head, degree, &x, expr)
            }
            // A curve of which only the degree is said; where words speak of its points, without saying what they
            // are, these are called as usual.
            Sort::BezierCurve if object.points.is_empty() && !object.rational => {
                let x = one?;
                let degree = self.stated_degree(machine, &object, &bound)?;
                let Some(curve) = &self.curve else {
                    self.note_generic(format!(
                        "{} is any curve of degree {degree} of line {line}",
                        head.base
                    ));
                    return Some(Ok(Value::Scalar(self.generic(machine, head, degree, expr).value(&x))));
                };
                note("the Bézier curve");
                let x = self.reparametrised(machine, &object, &x)?;
                let point = |i: i64| variable(Symbol::new(&curve.points).numbered(i));
                let terms =
                    (0..=degree as i64).map(|i| point(i).times(&self.bernstein_value(degree as i64, i, &x)));
                Ok(Value::Scalar(terms.fold(Fraction::zero(), |sum, term| sum.plus(&term))))
            }
            Sort::BezierCurve if self.may_be_elsewhere(head, &object) => {
                return Some(Err(unclear("over which interval this curve is", expr)));
            }
            Sort::BezierCurve => {
                let x = one?;
                let degree = self
                    .stated_degree(machine, &object, &bound)
                    .or_else(|| self.count(machine, &object.points, &bound)?.checked_sub(1))?;
                let points = self.points(machine, &object.points, &bound, degree)?;
                note("the Bézier curve");
                let x = self.reparametrised(machine, &object, &x)?;
                let basis = (0..=degree as i64).map(|i| self.bernstein_value(degree as i64, i, &x)).collect();
                combination(&points, &self.weighted(machine, &object, &bound, basis)?)
            }
            Sort::Lagrange => {
                let x = one?;
                let nodes = self.nodes(machine, &object, &bound)?;
                let i = head.lower.first().and_then(|index| machine.eval(index).ok())?.as_int()?;
                let Some(i) = usize::try_from(i).ok().filter(|&i| i < nodes.len()) else {
                    let message = "there is no node with this number";
                    return Some(Err(Diagnostic::error(Code::Domain, message).at(expr.span)));
                };
                note("a Lagrange polynomial");
                lagrange(&nodes, i, &x).map(Value::Scalar)
            }
            Sort::Interpolant => {
                let x = one?;
                let nodes = self.nodes(machine, &object, &bound)?;
                let values = self.points(machine, &object.points, &bound, nodes.len().checked_sub(1)?)?;
                note("the interpolant");
                let weights =
                    (0..nodes.len()).map(|i| lagrange(&nodes, i, &x)).collect::<Result<Vec<_>, _>>();
                weights.and_then(|weights| combination(&values, &weights))
            }
            Sort::Bernstein => {
                let x = self.reparametrised(machine, &object, &one?)?;
                let indices: Vec<&Expr> = head.lower.iter().chain(&head.upper).collect();
                let own = object.name_for(head)?;
                // B_0, …, B_3 of degree 3
                if let [i] = indices.as_slice() {
                    let degree = self.stated_degree(machine, &object, &bound)?;
                    let i = machine.eval(i).ok()?.as_int()?;
                    note("a Bernstein polynomial");
                    return Some(Ok(Value::Scalar(self.bernstein_value(degree as i64, i, &x))));
                }
                let [a, b] = indices.as_slice() else { return None };
                if own.lower.len() + own.upper.len() != 2 {
                    return None;
                }
                let (i, n) = if object.has_degree_first(&own) { (b, a) } else { (a, b) };
                let (i, n) = (machine.eval(i).ok()?.as_int()?, machine.eval(n).ok()?.as_int()?);
                note("a Bernstein polynomial");
                Ok(Value::Scalar(self.bernstein_value(n, i, &x)))
            }
            _ => return None,
        };
        Some(result)
    }

    /// The value of a name without arguments that words introduced: a control point, a matrix.
    pub(super) fn spoken_name(&self, machine: &mut Machine, head: &Head) -> Option<Evaluated> {
        let (object, line) = self.declared(head)?;
        match object.sort {
            Sort::Matrix if head.lower.is_empty() && head.upper.is_empty() => {
                let entry = |i: usize, j: usize| {
                    let name = Symbol::new(&head.base);
                    variable(name.numbered(i as i64 + 1).numbered(j as i64 + 1))
                };
                self.record.borrow_mut().matrices = true;
                self.note_generic(format!("{} is any 2 by 2 matrix", head.base));
                Some(Ok(Value::Matrix(nalgebra::DMatrix::from_fn(2, 2, entry))))
            }
            Sort::Symmetric(kind) => self.symmetric(machine, &object, kind, head, None),
            Sort::Coefficients => {
                let of = object.of.as_ref()?;
                let own = object.name_for(head)?;
                let same = |name: &Expr| {
                    let known = Head::of(name).filter(|known| known.base == own.base)?;
                    known.lower.iter().zip(&head.lower).all(|(a, b)| a.same_as(b)).then_some(())
                };
                let power = object.names.iter().position(|name| same(name).is_some())?;
                let value = self.once(&format!("coefficient {power}"), || {
                    let place = Symbol::new(PLACE);
                    let value = self.at_place(machine, of, vec![Value::symbol(place.clone())], of).ok()?;
                    let coefficient = |formula: Fraction| {
                        let all = coefficients_in(&formula, &place, of)?;
                        Ok(all.into_iter().nth(power).unwrap_or_else(Fraction::zero))
                    };
                    each(value, &coefficient).ok()
                })?;
                self.note(format!("{} is a coefficient of the curve of line {line}", head.base));
                Some(Ok(value))
            }
            Sort::ControlPoints => {
                let of = object.of.as_ref()?;
                let [index] = head.lower.as_slice() else { return None };
                let i = usize::try_from(machine.eval(index).ok()?.as_int()?).ok()?;
                if self.is_made_of(of, &head.base) || object.interval.is_none() && self.hears_of_an_interval()
                {
                    return None;
                }
                // Points over [v, w] beside a curve over [u, v] without a name may be those of another one.
                let unnamed = |own: Head| self.object(&own).is_some_and(|known| known.object.is_unnamed());
                if let Some(own) = &object.interval
                    && !object.local
                    && self.hears_of_a_neighbour(own)
                    && Head::of(of).is_some_and(unnamed)
                {
                    return None;
                }
                // p(t) = Σ b_i B_i^n(t): inside of p they are symbols.
                let value = self.once(&head.base, || {
                    let bound = self.indices(machine, &object, head);
                    let degree = self
                        .stated_degree(machine, &object, &bound)
                        .or_else(|| self.degree_of(machine, of))
                        .or_else(|| self.count(machine, &object.names, &bound)?.checked_sub(1))
                        .filter(|&degree| i <= degree)?;
                    let ends = object.interval.clone().unwrap_or_else(|| (Expr::int(0), Expr::int(1)));
                    let (a, b) = (machine.eval(&ends.0).ok()?, machine.eval(&ends.1).ok()?);
                    let arguments: Vec<Value> =
                        (0..degree).map(|k| if k < degree - i { a.clone() } else { b.clone() }).collect();
                    // Of the piece on the interval
                    let spline =
                        |own: Head| self.object(&own).is_some_and(|of| of.object.sort == Sort::SplineCurve);
                    let local = self.is_local() || Head::of(of).is_some_and(spline);
                    let middle = match (local, a.as_rational(), b.as_rational()) {
                        (true, Some(a), Some(b)) => Some((a + b) / integer(2)),
                        (true, ..) => self.around.borrow().clone(),
                        (false, ..) => None,
                    };
                    self.moved(middle, || self.polar_value(machine, of, degree, &arguments, of)).ok()
                })?;
                self.note(format!("{}_i are the control points of line {line}", head.base));
                Some(Ok(value))
            }
            _ => None,
        }
    }

    /// Whether the paragraph speaks of another interval than [0, 1], over which points may be meant.
    fn hears_of_an_interval(&self) -> bool {
        let mut near = self.context.heard.iter().filter(|(place, _)| place.group == self.place.group);
        // 1/2 ≤ t ≤ 1
        let part = |expr: &Expr| match &expr.kind {
            Kind::Chain(from, links) => {
                let up = links.iter().all(|link| matches!(link.rel, Rel::Le | Rel::Lt));
                links.len() == 2
                    && up
                    && bases(from).is_empty()
                    && bases(&links[1].expr).is_empty()
                    && !is_unit([from, &links[1].expr])
            }
            _ => false,
        };
        let conditions = self.context.conditions.iter().filter(|own| own.place.group == self.place.group);
        conditions.map(|own| &own.expr).any(part)
            || near.any(|(_, expr)| part(expr))
            || self
                .context
                .intervals_beside(&self.place)
                .any(|(_, ends, open)| !is_unit(ends) && open != [true, true])
    }

    /// Whether the paragraph speaks of an interval that ends where this one begins, or begins where it ends.
    fn hears_of_a_neighbour(&self, (start, end): &(Expr, Expr)) -> bool {
        let mut near = self.context.intervals_beside(&self.place);
        near.any(|(_, [from, to], _)| to.same_as(start) || from.same_as(end))
    }

    /// Whether the page gives a function by a formula with members of a letter: F(t) = Σ P_i B_i^n(t).
    fn is_made_of(&self, function: &Expr, letter: &str) -> bool {
        Head::of(function).is_some_and(|head| {
            self.context.visible(&head.base, &self.place).any(|(_, definition, near)| {
                near && matches!(&definition.body, Body::Formula(body) if bases(body).contains(letter))
            })
        })
    }

    /// The parameter of a curve over [a, b] as one over [0, 1].
    pub(super) fn reparametrised(
        &self,
        machine: &mut Machine,
        object: &Object,
        x: &Fraction,
    ) -> Option<Fraction> {
        let Some((from, to)) = &object.interval else { return Some(x.clone()) };
        let (from, to) = (machine.eval(from).ok()?, machine.eval(to).ok()?);
        let (Value::Scalar(from), Value::Scalar(to)) = (from, to) else { return None };
        match arithmetic::divide(Value::Scalar(x.minus(&from)), Value::Scalar(to.minus(&from))).ok()? {
            Value::Scalar(x) => Some(x),
            _ => None,
        }
    }

    /// Whether the paragraph speaks of an interval other than [0, 1] before it says what the curve is, which says of none:
    /// "x has over [0, 2] the control points …".
    fn may_be_elsewhere(&self, head: &Head, object: &Object) -> bool {
        let Some(said) = self.object(head).map(|declared| &declared.place) else { return false };
        object.interval.is_none()
            && self.context.intervals_beside(said).any(|(formula, ends, open)| {
                formula <= said.formula && open == [false, false] && !is_unit(ends)
            })
    }

    /// A polynomial with symbols as coefficients.
    fn generic(
        &self,
        machine: &mut Machine,
        head: &Head,
        degree: usize,
        expr: &Expr,
    ) -> Coefficients<Fraction> {
        let mut name = Symbol::new(format!("[{}]", head.base));
        for index in head.lower.iter().chain(&head.upper) {
            name = match self.symbol(machine, &Head { lower: vec![index.clone()], ..head.clone() }, expr) {
                Ok(symbol) => name.with_indices(symbol.indices().iter().map(|index| match index {
                    Index::Number(i) => Index::Word(i.to_string()),
                    word => word.clone(),
                })),
                Err(_) => name,
            };
        }
        self.record.borrow_mut().unknown.insert(head.base.clone());
        Coefficients::new((0..=degree as i64).map(|k| variable(name.numbered(k))).collect())
    }

    /// The polar form of something at arguments.
    fn polar_form(
        &self,
        machine: &mut Machine,
        head: &Head,
        of: &Expr,
        arguments: &[Value],
        expr: &Expr,
    ) -> Evaluated {
        let stated = self.stated_arity(machine, head);
        if let Some(name) = Head::of(of) {
            self.record.borrow_mut().paired.insert(name.base);
        }
        if stated.is_none() && !self.flexible.get() {
            self.record.borrow_mut().arities.insert(arguments.len());
        }
        if self.discovering && stated.is_none() {
            return Ok(Value::int(0));
        }
        if let Some(degree) = stated
            && degree != arguments.len()
        {
            self.record.borrow_mut().mixed = true;
            let message = format!(
                "{} is a polar form of degree {degree}, so it has {degree} arguments, not {}",
                head.base,
                arguments.len()
            );
            return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
        }
        self.polar_value(machine, of, arguments.len(), arguments, expr)
    }

    /// The polar form of a piece of a spline of which no control points are given: in terms of its powers and kinks, or,
    /// where its knots are not known, of any polynomial.
    fn of_any_piece(
        &self,
        machine: &mut Machine,
        object: &Object,
        head: &Head,
        of: &Expr,
        arguments: &[Value],
        expr: &Expr,
    ) -> Option<Evaluated> {
        let (spline, _) = self.declared(&Head::of(of)?)?;
        let (_, end) = object.interval.as_ref()?;
        if spline.sort != Sort::SplineCurve || !spline.points.is_empty() || self.is_local() {
            return None;
        }
        let degree = self.stated_degree(machine, &spline, &Bound::new())?;
        let place = machine.eval(end).ok()?;
        let outer = self.place_of_derivative.replace(Some(place.as_scalar()?.clone()));
        let value = self.polar_form(machine, head, of, arguments, expr);
        self.place_of_derivative.replace(outer);
        match value {
            Err(_) if head.lower.is_empty() && degree == arguments.len() => {
                let free = Object { degree: Some(Expr::int(degree as i64)), ..Object::new(Sort::PolarForm) };
                Some(self.any_affine(&free, head, degree, arguments, expr))
            }
            value => Some(value),
        }
    }

    /// The value of the polar form of degree `degree` of a polynomial, in each coordinate.
    fn polar_value(
        &self,
        machine: &mut Machine,
        of: &Expr,
        degree: usize,
        arguments: &[Value],
        expr: &Expr,
    ) -> Evaluated {
        if let Some(pairs) = arguments.iter().map(pair).collect::<Option<Vec<_>>>()
            && !pairs.is_empty()
        {
            return self.total_polar_value(machine, of, &pairs, expr);
        }
        let place = Symbol::new(PLACE);
        let value = self.at_place(machine, of, vec![Value::symbol(place.clone())], expr)?;
        let list = polar_arguments(arguments, expr)?;
        each(value, &|formula| {
            let coefficients = coefficients_in(&formula, &place, expr)?;
            let least = coefficients.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
            if least > degree {
                let message =
                    format!("a polynomial of degree {least} has no polar form with {degree} arguments");
                return Err(Diagnostic::error(Code::Arity, message).at(expr.span));
            }
            let mut coefficients = coefficients;
            coefficients.resize(degree + 1, Fraction::zero());
            PolarForm::new(coefficients).value(&list).map_err(|_| unclear("what this polar value is", expr))
        })
    }

    /// The value of a function, a product or sum of functions, or a formula in a variable, at symbols.
    pub(super) fn at_place(
        &self,
        machine: &mut Machine,
        of: &Expr,
        symbols: Vec<Value>,
        expr: &Expr,
    ) -> Evaluated {
        let group = Expr::new(Kind::Group(Box::new(of.clone())), of.span);
        let function = match &of.kind {
            Kind::Mul(_) | Kind::Add(_) | Kind::Compose(_) => group,
            _ => of.clone(),
        };
        // H = FG
        if let Some(head) = Head::of(of)
            && let Some((_, definition, _)) = self.context.visible(&head.base, &self.place).next()
            && definition.head.arguments.is_none()
            && definition.head.lower.len() + definition.head.upper.len()
                == head.lower.len() + head.upper.len()
            && let Body::Formula(body) = &definition.body
        {
            let body = body.clone();
            return self.at_place(machine, &body, symbols, expr);
        }
        if self.is_function(machine, &function) {
            return self.apply(machine, &function, &[symbols], expr);
        }
        let free: Vec<String> = bases(of)
            .into_iter()
            .filter(|name| is_variable(name) && machine.lookup(&Symbol::new(name)).is_none())
            .collect();
        if free.len() != symbols.len() {
            return Err(unclear("in which variable this is a polynomial", expr));
        }
        let locals: Bound = free.iter().map(Symbol::new).zip(symbols).collect();
        machine.with_locals(locals, |machine| machine.eval(of))
    }
}

/// Points and vectors as arguments of a polar form.
pub(super) fn polar_arguments(values: &[Value], expr: &Expr) -> Result<Vec<Argument<Fraction>>, Diagnostic> {
    let argument = |value: &Value| match value {
        Value::Scalar(u) => Ok(Argument::Point(u.clone())),
        Value::Vector(v) => Ok(Argument::Vector(v.clone())),
        _ => Err(unclear("what these arguments are", expr)),
    };
    values.iter().map(argument).collect()
}

/// The coordinates of a point of the plane.
fn pair(value: &Value) -> Option<(Fraction, Fraction)> {
    let Value::List(items) = value else { return None };
    match items.as_slice() {
        [Value::Scalar(x), Value::Scalar(y)] => Some((x.clone(), y.clone())),
        _ => None,
    }
}

pub(super) fn coefficients_in(
    formula: &Fraction,
    place: &Symbol,
    expr: &Expr,
) -> Result<Vec<Fraction>, Diagnostic> {
    let not = || Diagnostic::error(Code::Type, "this is not a polynomial").at(expr.span);
    let denominator = formula.denominator();
    if denominator.variables().contains(place) {
        return Err(not());
    }
    let parts = formula.numerator().coefficients_in(place);
    parts.into_iter().map(|part| Fraction::new(part, denominator.clone()).map_err(|_| not())).collect()
}
