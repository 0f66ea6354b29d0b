//! What is written in other words than a function expects, brought to its arguments before they are checked: points for
//! curves, formulas for curves, curves for polynomials, equations for lines, arguments side by side for a list.

use super::Builtin;
use super::parameter::{NODES, Need, Parameter, VALUES};
use super::record::names_places;
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Machine};
use crate::language::ops::errors::curve_error;
use crate::language::ops::formula::{curve_of, is_parameter, symbol_of};
use crate::language::ops::geometry::{bezier, points_of};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, Value, free_parameter};
use crate::math::curve::{BezierCurve, Interval};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

type Result<T> = std::result::Result<T, Diagnostic>;

/// The chapter of functions of which the first argument is a polynomial whose values are looked at.
const ROOTS: &str = "Roots of polynomials";

impl Builtin {
    /// The arguments as the function expects them.
    pub(super) fn converted(&self, machine: &mut Machine, args: Arguments) -> Result<Arguments> {
        let args = self.with_points_together(self.with_first_in_place(args)).with_equations_together();
        let args = self.with_values_apart(args);
        let args = self.with_line(self.with_curve_of_points(machine, args)?);
        let args = self.with_curves_of_formulas(machine, args)?;
        Ok(self.with_polynomial_of_curve(machine, args))
    }

    /// roots(bezier([1, -1, 1])): a Bézier polynomial where a polynomial is expected, and its interval where one is.
    fn with_polynomial_of_curve(&self, machine: &mut Machine, mut args: Arguments) -> Arguments {
        let of_polynomial = self.parameters.first().is_some_and(|first| {
            matches!(first.kind, Takes::Polynomial | Takes::Scalar) && first.name == "F"
        });
        let place = |name: &str| {
            let of_end = |own: &Parameter| own.name == name && own.has_place() && own.kind == Takes::Number;
            self.parameters.iter().any(of_end)
        };
        let on_interval = place("a") && place("b");
        let Some((Value::Geometry(geometry), span)) = args.given(0) else { return args };
        let Geometry::Bezier(curve, form) = &**geometry else { return args };
        if !of_polynomial || !form.scalar || form.rational || !(on_interval || self.topic == ROOTS) {
            return args;
        }
        let variable = free_parameter(curve.points().iter().flat_map(|point| point.iter()));
        let value = curve.value(&Fraction::from(MultiPoly::symbol(variable)))[0].clone();
        let (a, b) = curve.interval().ends();
        let ends = [a.clone(), b.clone()].map(Value::Scalar);
        let whole = args.len() == 1 && !args.has_name("a") && !args.has_name("b");
        args = args.with_first(Value::Scalar(value));
        if whole && on_interval {
            let written =
                ends.iter().map(|end| crate::language::write::text(&end.to_expr())).collect::<Vec<_>>();
            let note = format!("on [{}], the interval of the curve", written.join(", "));
            machine.note(Diagnostic::note(Code::StandardMeaning, note).at(span));
            for (place, end) in (1..).zip(ends) {
                args.put(place, end, span);
            }
        }
        args
    }

    /// arc_length([t^2, t^3]): formulas where a Bézier curve is expected are one over [0, 1].
    fn with_curves_of_formulas(&self, machine: &mut Machine, mut args: Arguments) -> Result<Arguments> {
        let places: Vec<&Parameter> =
            self.parameters.iter().filter(|parameter| parameter.has_place()).collect();
        for place in 0..args.len() {
            let several = |last: &&&Parameter| matches!(last.need, Need::Many(..));
            let kind = places.get(place).or(places.last().filter(several)).map(|parameter| parameter.kind);
            let Some((value, span)) = args.given(place).filter(|_| kind == Some(Takes::Curve)) else {
                continue;
            };
            let value = value.clone();
            if curve_of(&value).at(span)?.is_none() {
                continue;
            }
            let (curve, form) = args.bezier(place)?;
            let curve = bezier(curve, form);
            let note =
                format!("read as the curve {} over [0, 1]", crate::language::write::text(&value.to_expr()));
            machine.note(Diagnostic::note(Code::StandardMeaning, note).at(span));
            args.put(place, curve, span);
        }
        Ok(args)
    }

    /// intersections(c, y = 1/2): an equation of a line where another curve is expected.
    fn with_line(&self, mut args: Arguments) -> Arguments {
        if self.name != "intersections" || args.len() != 1 {
            return args;
        }
        for name in ["x", "y", "z"] {
            if let Some((_, Value::Scalar(value), span)) = args.take_named(name) {
                let letter = Fraction::from(MultiPoly::symbol(Symbol::new(name)));
                args.put(1, Value::Scalar(letter.minus(&value)), span);
                break;
            }
        }
        args
    }

    /// elevate([0, 2, 3]), elevate(0, 2, 3): numbers or points where a curve is expected are its control points.
    fn with_curve_of_points(&self, machine: &mut Machine, args: Arguments) -> Result<Arguments> {
        let of_curves =
            |parameter: &Parameter| matches!(parameter.kind, Takes::Curve | Takes::Polar | Takes::Geometry);
        let mut places = self.parameters.iter().filter(|parameter| parameter.has_place());
        if self.topic == "Figures"
            || !places.next().is_some_and(of_curves)
            || places.next().is_some_and(of_curves)
        {
            return Ok(args);
        }
        let number = |value: &Value| value.as_rational().is_some() && !matches!(value, Value::List(_));
        let point = |value: &Value| matches!(value, Value::List(items) if items.len() > 1 && items.iter().all(number));
        let points =
            |items: &[Value]| items.len() > 1 && (items.iter().all(number) || items.iter().all(point));
        let most = self.parameters.iter().filter(|parameter| parameter.has_place());
        let most = most
            .map(|p| if let Need::Many(_, most) = p.need { most } else { 1 })
            .fold(0, usize::saturating_add);
        let side_by_side: Vec<Value> = args.values().cloned().collect();
        let args = match side_by_side.len() > most && points(&side_by_side) {
            true => {
                let span = args.span(0).to(args.span(args.len() - 1));
                args.gathered(span)
            }
            false => args,
        };
        let Some((Value::List(items), span)) = args.given(0) else { return Ok(args) };
        let found = points_of(&Value::List(items.clone())).filter(|_| points(items.as_slice()));
        let Some((points, scalar)) = found else { return Ok(args) };
        let curve = BezierCurve::new(points, Interval::unit()).map_err(curve_error).at(span)?;
        let curve = bezier(curve, Form { scalar, rational: false });
        let written = crate::language::write::text(&curve.to_expr());
        machine
            .note(Diagnostic::note(Code::StandardMeaning, format!("read as the curve {written}")).at(span));
        Ok(args.with_first(curve))
    }

    /// bezier((0, 0), (1, 1), (2, 0)): three lists and more, where one is expected and numbers follow, are its items.
    fn with_points_together(&self, args: Arguments) -> Arguments {
        let mut kinds = self.parameters.iter().filter(|parameter| parameter.has_place()).map(|p| p.kind);
        let expected = kinds.next() == Some(Takes::Points) && kinds.next() == Some(Takes::Scalar);
        let column = |value: &Value| matches!(value, Value::Matrix(column) if column.ncols() == 1);
        let lists = args.values().all(|value| matches!(value, Value::List(_)) || column(value));
        // bezier(0, 1, 4)
        let numbers =
            args.values().all(|value| matches!(value, Value::Scalar(_))) && args.values().count() > 1;
        if !expected || !(lists && args.values().count() > 2 || numbers) {
            return args;
        }
        let span = args.span(0).to(args.span(args.len() - 1));
        args.gathered(span)
    }

    /// lagrange([(0, 1), (1, 3)]): points where nodes and values are expected are both.
    fn with_values_apart(&self, mut args: Arguments) -> Arguments {
        let mut places = self.parameters.iter().filter(|parameter| parameter.has_place());
        let expected = places.next().is_some_and(|first| first.name == NODES.name)
            && places.next().is_some_and(|second| second.name == VALUES.name);
        let parts = |point: &Value| match point {
            Value::List(items) if items.len() == 2 => Some((items[0].clone(), items[1].clone())),
            _ => None,
        };
        if expected && args.len() > 2 && args.values().all(|value| parts(value).is_some()) {
            let span = args.span(0).to(args.span(args.len() - 1));
            args = args.gathered(span);
        }
        let Some((Value::List(points), span)) = args.given(0).filter(|_| expected && args.len() == 1) else {
            return args;
        };
        let Some((nodes, values)) = points.iter().map(parts).collect::<Option<(Vec<_>, Vec<_>)>>() else {
            return args;
        };
        if !args.has_name(VALUES.name) {
            args.put(0, Value::list(nodes), span);
            args.put(1, Value::list(values), span);
        }
        args
    }

    /// The first argument decides how a function works, so it is needed before the others.
    fn with_first_in_place(&self, mut args: Arguments) -> Arguments {
        if args.is_empty() {
            let first = self.parameter_lists().filter(|list| names_places(list)).filter_map(<[_]>::first);
            let mut names =
                first.filter(|first| first.has_place() && first.has_name()).map(|first| first.name);
            if let Some((_, value, span)) = names.find_map(|name| args.take_named(name)) {
                args.push(value, span);
            }
        }
        args
    }
}

/// The variables of a form of a function at their places.
pub(super) fn with_letters(parameters: &[Parameter], args: Arguments) -> Arguments {
    with_variable_apart(
        parameters,
        with_letter_left_out(parameters, with_variables_together(parameters, args)),
    )
}

/// polar_total(F, u, v), groebner(F, x): symbols where a list of variables has its place are its items.
fn with_variables_together(parameters: &[Parameter], mut args: Arguments) -> Arguments {
    let mut places = parameters.iter().filter(|parameter| parameter.has_place());
    let Some(place) = places.position(|parameter| parameter.kind == Takes::Variables) else { return args };
    let symbol = |at: usize| args.given(at).filter(|(value, _)| symbol_of(value).is_some());
    let symbols: Vec<(Value, Span)> =
        (place..args.len()).map_while(symbol).map(|(value, span)| (value.clone(), span)).collect();
    if let [(_, first), ..] = symbols.as_slice() {
        let span = symbols.iter().fold(*first, |span, (_, next)| span.to(*next));
        for _ in 1..symbols.len() {
            args.take_place(place + 1);
        }
        args.put(place, Value::List(symbols.into_iter().map(|(value, _)| value).collect()), span);
    }
    args
}

/// integrate(F, 0, 1): where a variable may be left out, a number belongs to the next place.
fn with_letter_left_out(parameters: &[Parameter], mut args: Arguments) -> Arguments {
    let by_place: Vec<&Parameter> = parameters.iter().filter(|parameter| parameter.has_place()).collect();
    let letter = |p: &&Parameter| p.kind == Takes::Variable && matches!(p.need, Need::Optional(_));
    let several = by_place.iter().any(|parameter| matches!(parameter.need, Need::Many(..)));
    let Some(place) = by_place.iter().position(letter).filter(|_| !several) else { return args };
    let number = args.given(place).is_some_and(|(value, _)| symbol_of(value).is_none());
    if number && place + 1 < by_place.len() && args.len() < by_place.len() {
        args.leave_out(place);
    }
    args
}

/// polar(F, t): a symbol where a number has its place, or nothing has, is the variable.
fn with_variable_apart(parameters: &[Parameter], mut args: Arguments) -> Arguments {
    let named = |p: &&Parameter| p.kind == Takes::Variable && matches!(p.need, Need::Named(_));
    let several = parameters.iter().any(|parameter| matches!(parameter.need, Need::Many(..) | Need::Free));
    let Some(variable) = parameters.iter().find(named).filter(|p| !several && !args.has_name(p.name)) else {
        return args;
    };
    let by_place: Vec<&Parameter> = parameters.iter().filter(|parameter| parameter.has_place()).collect();
    let inside = match args.values().next() {
        Some(Value::Scalar(formula)) => formula.variables(),
        _ => Vec::new(),
    };
    let is_letter = |place: &usize| {
        let number = by_place
            .get(*place)
            .is_none_or(|p| matches!(p.kind, Takes::Size | Takes::Integer | Takes::Number));
        let symbol = args.given(*place).and_then(|(value, _)| symbol_of(value));
        number && symbol.is_some_and(|symbol| inside.contains(&symbol) || is_parameter(&symbol))
    };
    let place = (1..args.len()).find(is_letter);
    if let Some((value, span)) = place.and_then(|place| args.take_place(place)) {
        args.push_named(variable.name.to_owned(), value, span);
    }
    args
}
