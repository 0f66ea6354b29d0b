//! What is said of one function, bound to its parameters by labels and kinds where the order of the words does not tell: each value
//! goes to the parameter that fits it best, and only if there is one best way for all of them.

use super::Reader;
use super::apposition::has_rows;
use super::draft::{Draft, list};
use super::utterance::Utterance;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, applied, call, named};
use crate::language::eval;
use crate::language::functions::{Builtin, Gives, Need, Parameter, SCHEME, Takes, builtin, senses};
use crate::language::lexicon::phrases::{Label, Place};
use crate::language::lexicon::roles;
use crate::language::value::symbol_expr;

/// Something said, with the word that says for what.
#[derive(Clone)]
struct Said {
    label: Option<Label>,
    items: Vec<Expr>,
}

/// A value at its parameter.
#[derive(Clone)]
struct Bound {
    parameter: usize,
    values: Vec<Expr>,
}

/// More things are not bound.
const MOST_SAID: usize = 6;

impl Reader<'_> {
    /// The calls that bind all that is said, for the function that is named or another sense of its word, the nearest first.
    pub(super) fn bound(&self, asked: &Utterance) -> Vec<Expr> {
        let is_kind = |draft: &&Draft| matches!(draft.builtin.name, "bezier" | "lagrange" | "bernstein");
        let (kinds, others): (Vec<&Draft>, Vec<&Draft>) = asked.drafts.iter().partition(is_kind);
        let (schemes, others) = schemes_apart(others);
        // What is done with what the last of them gives: substitute and simplify.
        let (outer, own) = match (others.as_slice(), kinds.as_slice()) {
            ([outer @ .., own], _) => (outer, *own),
            ([], [kind]) => (&[][..], *kind),
            _ => return Vec::new(),
        };
        let plain = |draft: &&Draft| {
            let mut needed = draft.builtin.parameters.iter().filter(|own| own.need == Need::Required);
            needed.next().is_some() && needed.next().is_none() && draft.part.is_none()
        };
        if outer.len() > 1 || !outer.iter().all(plain) {
            return Vec::new();
        }
        if !asked.flags.is_empty() || own.part.is_some() || schemes.is_some() && kinds.len() > 1 {
            return Vec::new();
        }
        let Some(said) = said(asked, own, schemes) else { return Vec::new() };
        if own.builtin.name == "patch"
            && said.iter().any(|said| has_rows(&asked.drafts, &said.items).is_err())
            && !is_on_diagonal(&said)
        {
            return Vec::new();
        }
        let curve =
            kinds.iter().any(|kind| kind.builtin.name == "bezier" && kind.builtin.name != own.builtin.name);
        // "Split the curve at 1/2" divides no 1/2.
        let places = said.iter().all(|said| said.label == Some(Label::At));
        let other = senses(own.builtin.name).iter().copied().filter(|_| !places);
        let meant = std::iter::once(own.builtin.name).chain(other);
        let calls = meant.filter_map(builtin).flat_map(|function| {
            let mut calls = self.calls(function, own.phrase, &said, curve);
            if calls.is_empty() {
                calls.extend(self.value_of_call(function, own.phrase, &said, curve));
            }
            calls
        });
        let wrapped = |inner: Expr| {
            outer.iter().rev().fold(inner, |inner, draft| call(draft.builtin.name, vec![inner], draft.phrase))
        };
        calls.map(wrapped).collect()
    }

    /// What a function gives, at the place that none of its parameters takes: a patch at u = 1/2, v = 1/2.
    fn value_of_call(
        &self,
        function: &'static Builtin,
        phrase: Span,
        said: &[Said],
        curve: bool,
    ) -> Option<Expr> {
        let has_values = matches!(
            function.gives,
            Gives::Surface
                | Gives::Polar
                | Gives::Curve
                | Gives::Spline
                | Gives::SameCurve
                | Gives::Piecewise
        );
        let value = |item: &Expr| match eval::named(item) {
            Some((name, value)) => roles::is_variable(&name).then(|| value.clone()),
            None => Some(item.clone()),
        };
        let place = |said: &&Said| {
            let named = said.items.iter().all(|item| eval::named(item).is_some());
            said.label == Some(Label::At) || said.label == Some(Label::With) && named
        };
        let (places, others): (Vec<&Said>, Vec<&Said>) = said.iter().partition(place);
        let mut values = places.iter().flat_map(|said| &said.items).map(value).collect::<Option<Vec<_>>>()?;
        // the point (1/2, 1/3) of a surface
        if let (Gives::Surface, [Expr { kind: Kind::Tuple(own), .. }]) = (function.gives, values.as_slice()) {
            values = own.clone();
        }
        if let (Gives::Surface, [middle]) = (function.gives, values.as_slice()) {
            values = vec![middle.clone(), middle.clone()];
        }
        let others: Vec<Said> = others.into_iter().cloned().collect();
        if !has_values || values.is_empty() || others.is_empty() {
            return None;
        }
        let [call] = <[Expr; 1]>::try_from(self.calls(function, phrase, &others, curve)).ok()?;
        Some(applied(call, values, phrase))
    }

    /// The best call of a function for each list of parameters that it may have.
    fn calls(&self, function: &'static Builtin, phrase: Span, said: &[Said], curve: bool) -> Vec<Expr> {
        if function.parameters.iter().any(|own| own.need == Need::Free) {
            return values_put_in(function, phrase, said).into_iter().collect();
        }
        let lists = [Some(function.parameters), function.on_curve.map(|own| own.parameters)];
        let best = |parameters: &'static [Parameter]| {
            let mut best: Vec<(i32, Vec<Bound>)> = Vec::new();
            fill(parameters, said, curve, &mut Vec::new(), 0, &mut best);
            let top = best.iter().map(|(score, _)| *score).max()?;
            let mut first = best.into_iter().filter(|(score, _)| *score == top);
            match (first.next(), first.next()) {
                (Some((_, bound)), None) => self.written(function, parameters, phrase, bound, said),
                _ => None,
            }
        };
        lists.into_iter().flatten().filter_map(best).collect()
    }

    /// The call with the values at their places, and those by name that stand behind one left out.
    fn written(
        &self,
        function: &'static Builtin,
        parameters: &[Parameter],
        phrase: Span,
        bound: Vec<Bound>,
        said: &[Said],
    ) -> Option<Expr> {
        let object = said.first().map(|said| said.items.as_slice()).unwrap_or_default();
        let mut arguments = Vec::new();
        let mut gap = false;
        for (place, parameter) in parameters.iter().enumerate() {
            let mut values: Vec<Expr> = bound
                .iter()
                .filter(|bound| bound.parameter == place)
                .flat_map(|bound| bound.values.clone())
                .collect();
            if values.is_empty() {
                values.extend(self.supplied(function, parameter, object));
            }
            let required = matches!(parameter.need, Need::Required)
                || matches!(parameter.need, Need::Many(least, _) if least > 0);
            if values.is_empty() && required {
                return None;
            }
            gap |= values.is_empty() || matches!(parameter.need, Need::Named(_) | Need::Free);
            match (gap, values.as_slice()) {
                (_, []) => {}
                (false, _) => arguments.extend(values),
                (true, [one]) if parameter.has_name() => arguments.push(named(parameter.name, one.clone())),
                (true, _) => return None,
            }
        }
        Some(call(function.name, arguments, phrase))
    }

    /// What a parameter is that nobody mentions: the variable is that of the formula, the Taylor polynomial is at 0.
    fn supplied(&self, function: &Builtin, parameter: &Parameter, object: &[Expr]) -> Option<Expr> {
        if parameter.need != Need::Required {
            return None;
        }
        let variables = || match object {
            [formula] => self.variables(formula),
            _ => Vec::new(),
        };
        match (parameter.kind, function.name, parameter.name) {
            (Takes::Variable, ..) => match variables().as_slice() {
                [] => Some(Expr::name("t")),
                [one] => Some(symbol_expr(one)),
                _ => None,
            },
            (Takes::Variables, ..) => {
                let own = variables();
                (own.len() > 1).then(|| list(own.iter().map(symbol_expr).collect()))
            }
            (_, "taylor", "a") => Some(Expr::int(0)),
            (Takes::Scalar, _, "t") if function.gives == Gives::Function => Some(Expr::name("t")),
            _ => None,
        }
    }
}

/// Whether a place is said that is the same for u and v, so that it does not matter which corners of a patch are neighbours.
fn is_on_diagonal(said: &[Said]) -> bool {
    let places = said.iter().filter(|said| matches!(said.label, Some(Label::At | Label::With)));
    let values = places.flat_map(|said| &said.items).flat_map(|item| match &item.kind {
        Kind::Tuple(own) => own.clone(),
        _ => vec![eval::named(item).map_or_else(|| item.clone(), |(_, value)| value.clone())],
    });
    let mut values: Vec<String> = values.map(|value| crate::language::write::text(&value)).collect();
    values.dedup();
    values.len() == 1
}

/// A formula with values for its names: substitute t = 2u in t^3.
fn values_put_in(function: &Builtin, phrase: Span, said: &[Said]) -> Option<Expr> {
    let items = said.iter().flat_map(|said| &said.items).cloned();
    let (values, formulas): (Vec<Expr>, Vec<Expr>) = items.partition(|item| eval::named(item).is_some());
    let put = |value: &Expr| eval::named(value).map(|(name, value)| named(&name, value.clone()));
    match formulas.as_slice() {
        [formula] if !values.is_empty() => {
            let values = values.iter().filter_map(put);
            Some(call(function.name, std::iter::once(formula.clone()).chain(values).collect(), phrase))
        }
        _ => None,
    }
}

/// The functions but for that which says a subdivision scheme beside one that takes it.
fn schemes_apart(drafts: Vec<&Draft>) -> (Option<Option<Expr>>, Vec<&Draft>) {
    let takes = |draft: &&&Draft| draft.builtin.parameters.iter().any(|own| own.kind == SCHEME);
    let of_scheme = |draft: &&&Draft| {
        matches!(draft.builtin.name, "subdivide_polygon" | "subdivide" | "bspline" | "bspline_basis")
    };
    let Some(own) = drafts.iter().find(|draft| takes(draft) && draft.builtin.name != "subdivide_polygon")
    else {
        let alone = drafts.iter().filter(takes).count() == 1;
        let rest = drafts.iter().filter(|draft| !(alone && of_scheme(draft) && !takes(draft)));
        let rest: Vec<&Draft> = rest.copied().collect();
        let scheme = alone.then(|| rest.iter().find_map(|draft| scheme_of(draft)));
        return (scheme, rest);
    };
    let scheme = drafts.iter().find_map(|draft| scheme_of(draft));
    let rest = drafts.iter().filter(|draft| draft.builtin.name == own.builtin.name || !of_scheme(draft));
    (Some(scheme), rest.copied().collect())
}

/// The scheme that the words of a function name.
fn scheme_of(draft: &Draft) -> Option<Expr> {
    draft.named.iter().find(|(name, _)| *name == "scheme").map(|(_, word)| word.clone())
}

/// All that is said, the object first; `None` if there is too much or something that has no value.
fn said(asked: &Utterance, own: &Draft, scheme: Option<Option<Expr>>) -> Option<Vec<Said>> {
    let mut all: Vec<Said> = Vec::new();
    if !asked.items.is_empty() {
        all.push(Said { label: None, items: asked.items.clone() });
    }
    let mut degree = None;
    for read in &asked.said {
        let label = Some(read.label);
        if read.label == Label::OfDegree {
            degree = degree.or_else(|| read.items.first().cloned());
        }
        match all.last_mut() {
            // at 1, 2 and 3; from 0 to 1
            Some(last)
                if last.label == label && !read.items.iter().any(|item| eval::named(item).is_some()) =>
            {
                last.items.extend(read.items.clone());
            }
            Some(last)
                if last.label == Some(Label::From) && read.label == Label::To && last.items.len() == 1 =>
            {
                last.label = Some(Label::Over);
                last.items.extend(read.items.clone());
            }
            _ => all.push(Said { label, items: read.items.clone() }),
        }
    }
    for place in &asked.places {
        let value = match place {
            Place::Start => Expr::int(0),
            Place::End => Expr::int(1),
            Place::Middle => Expr::int(1).over(Expr::int(2)),
            Place::Centre => return None,
        };
        all.push(Said { label: Some(Label::At), items: vec![value] });
    }
    for (name, value) in &own.named {
        if *name != "scheme" {
            all.push(Said { label: None, items: vec![named(name, value.clone())] });
        }
    }
    // A line through two points, a cubic with four: the degree says no more.
    let counted = |degree: &Expr, all: &[Said]| {
        let count = |said: &Said| match said.items.as_slice() {
            [Expr { kind: Kind::List(items), .. }] => items.len(),
            items => items.len(),
        };
        degree.as_int().is_some_and(|n| {
            all.iter().any(|said| {
                said.label != Some(Label::OfDegree)
                    && usize::try_from(n + 1) == Ok(count(said))
                    && count(said) > 1
            })
        })
    };
    if own.builtin.parameters.iter().all(|own| !matches!(own.name, "n" | "degree" | "d" | "k" | "i" | "m"))
        && degree.as_ref().is_some_and(|degree| counted(degree, &all))
        && scheme.is_none()
    {
        all.retain(|said| said.label != Some(Label::OfDegree));
    }
    // The cubic B-spline scheme is that of Lane and Riesenfeld of degree 3.
    if let Some(scheme) = scheme {
        let word = match (scheme, degree) {
            (Some(word), None) => word,
            (_, Some(degree)) => {
                all.retain(|said| said.label != Some(Label::OfDegree));
                list(vec![Expr::name("lane_riesenfeld"), degree])
            }
            (None, None) => return None,
        };
        all.push(Said { label: None, items: vec![named("scheme", word)] });
    }
    (all.len() <= MOST_SAID && !all.is_empty()).then_some(all)
}

/// All ways to give each value to a parameter, with how well they fit.
fn fill(
    parameters: &[Parameter],
    said: &[Said],
    curve: bool,
    bound: &mut Vec<Bound>,
    score: i32,
    found: &mut Vec<(i32, Vec<Bound>)>,
) {
    let Some((first, rest)) = said.split_first() else {
        found.push((score, bound.clone()));
        return;
    };
    let free = |at: usize, bound: &[Bound]| bound.iter().all(|own| own.parameter != at);
    for (at, parameter) in
        parameters.iter().enumerate().filter(|(at, _)| free(*at, bound)).collect::<Vec<_>>()
    {
        if let Some((fits, values)) = fit(first, parameters, at, curve) {
            bound.push(Bound { parameter: at, values });
            fill(parameters, rest, curve, bound, score + fits, found);
            bound.pop();
        }
        // [0, 2] for a and b
        let second = parameters.get(at + 1).filter(|_| free(at + 1, bound));
        let ends =
            second.is_some_and(|second| matches!((parameter.name, second.name), ("a", "b") | ("r", "s")));
        if let (true, Some([from, to])) = (ends, ends_of(first)) {
            bound.push(Bound { parameter: at, values: vec![from] });
            bound.push(Bound { parameter: at + 1, values: vec![to] });
            fill(parameters, rest, curve, bound, score + STRONG, found);
            bound.truncate(bound.len() - 2);
        }
    }
}

const STRONG: i32 = 4;

/// The ends of an interval that is said.
fn ends_of(said: &Said) -> Option<[Expr; 2]> {
    if !matches!(said.label, Some(Label::Over | Label::In | Label::To | Label::With)) {
        return None;
    }
    let value = |item: &Expr| eval::named(item).map_or_else(|| item.clone(), |(_, value)| value.clone());
    match said.items.as_slice() {
        [Expr { kind: Kind::List(ends) | Kind::Tuple(ends), .. }] => <[Expr; 2]>::try_from(ends.clone()).ok(),
        [from, to] => Some([value(from), value(to)]),
        _ => None,
    }
}

/// How well something said fits a parameter, and what it is there.
fn fit(said: &Said, parameters: &[Parameter], place: usize, curve: bool) -> Option<(i32, Vec<Expr>)> {
    let parameter = parameters.get(place)?;
    let needed = i32::from(parameter.need == Need::Required);
    let one = match said.items.as_slice() {
        [one] => Some(one),
        _ => None,
    };
    // n = 3 by the name of the parameter; t = 1/2 is a place
    if let Some((name, value)) = one.and_then(eval::named) {
        // x: 0 1 2 y: 1 3 7
        let own = parameter.name == name
            || value.items().is_some()
                && matches!((name.as_str(), parameter.name), ("x", "nodes") | ("y" | "f", "values"));
        // a and b are the ends of an interval.
        let end = parameter.name == "a" && parameters.iter().any(|own| own.name == "b");
        let place = !end
            && roles::is_variable(&name)
            && matches!(parameter.name, "a" | "at" | "x" | "t" | "u" | "v" | "tau");
        let degree = (roles::is_degree(&name) || name == "p") && matches!(parameter.name, "degree" | "n");
        let fits = own && parameter.has_name() || place || degree;
        let kind = if own && parameter.kind != Takes::Interval {
            Some(vec![value.clone()])
        } else {
            of_kind(std::slice::from_ref(value), parameter.kind, curve)
        };
        return kind.filter(|_| fits).map(|values| (STRONG + i32::from(own) + needed, values));
    }
    // on [1, 2]: an interval, no control points
    let interval = matches!(said.label, Some(Label::Over | Label::In))
        && matches!(said.items.as_slice(), [Expr { kind: Kind::List(ends), .. }] if ends.len() == 2);
    if interval && !matches!(parameter.kind, Takes::Interval | Takes::Variables) {
        return None;
    }
    let values = match parameter.need {
        Need::Many(..) => said
            .items
            .iter()
            .map(|item| of_kind(std::slice::from_ref(item), parameter.kind, curve))
            .collect::<Option<Vec<_>>>()?
            .concat(),
        Need::Free => return None,
        _ => of_kind(&said.items, parameter.kind, curve)?,
    };
    affinity(said.label, parameter, place).map(|fits| (fits + needed, values))
}

/// How well a label goes with a parameter; `None` if it says that something else is meant.
fn affinity(label: Option<Label>, parameter: &Parameter, place: usize) -> Option<i32> {
    let named = |names: &[&str]| names.contains(&parameter.name);
    let strong = |yes: bool| yes.then_some(STRONG);
    Some(match label {
        None if place == 0 => STRONG + 1,
        None => 0,
        Some(Label::At) => match named(&["t", "u", "v", "a", "at", "x", "tau", "point", "p", "nodes"]) {
            true => STRONG,
            false if matches!(parameter.need, Need::Many(..)) => STRONG - 1,
            false => 0,
        },
        Some(Label::OfDegree) => match named(&["degree", "n", "d"]) {
            true => STRONG + 1,
            false => return strong(named(&["k", "i", "m", "order"])),
        },
        Some(Label::Times) => return strong(named(&["k", "times"])),
        Some(Label::Number) => return strong(named(&["i", "j"])),
        Some(Label::Knots) => return strong(named(&["knots"])),
        Some(Label::Nodes) => return strong(named(&["nodes"])),
        Some(Label::Weights) => return strong(named(&["weights"])),
        Some(Label::Values) => return strong(named(&["values"]) || place == 0),
        Some(Label::Points) => {
            return strong(named(&["points", "net", "c", "curve", "spline", "s"]) || place == 0);
        }
        Some(Label::Over) if named(&["interval"]) => STRONG,
        Some(Label::In) if parameter.kind == Takes::Variable => STRONG,
        Some(Label::In) if named(&["k"]) => STRONG,
        Some(Label::To) if named(&["degree", "n"]) => STRONG,
        Some(Label::Over | Label::In | Label::With | Label::From | Label::To | Label::Through) => 1,
        Some(Label::Rational | Label::Uniform | Label::Multiplicity | Label::Net) => return None,
    })
}

/// Items as a value of a kind, if they may be one.
fn of_kind(items: &[Expr], kind: Takes, curve: bool) -> Option<Vec<Expr>> {
    let one = match items {
        [one] => Some(one),
        _ => None,
    };
    let plain = |item: &Expr| {
        !matches!(item.kind, Kind::List(_) | Kind::Tuple(_) | Kind::Chain(..) | Kind::Matrix(..))
    };
    let several = || match items {
        [list @ Expr { kind: Kind::List(_), .. }] => Some(list.clone()),
        [Expr { kind: Kind::Tuple(values), .. }] => Some(list(values.clone())),
        [_] | [] => None,
        items => Some(list(items.to_vec())),
    };
    let bezier = |points: Expr| call("bezier", vec![points.clone()], points.span);
    let value = match kind {
        Takes::Size => one.filter(|item| item.as_int().is_some_and(|n| n >= 0))?.clone(),
        Takes::Integer | Takes::Number | Takes::Scalar | Takes::Argument => {
            one.filter(|item| plain(item))?.clone()
        }
        Takes::Formula | Takes::Polynomial | Takes::Function => match one.filter(|item| plain(item)) {
            Some(formula) => formula.clone(),
            None => bezier(several().filter(|_| curve)?),
        },
        Takes::Variable => one.filter(|item| matches!(item.kind, Kind::Name(_)))?.clone(),
        Takes::Variables => several().filter(|list| {
            list.items().is_some_and(|own| own.iter().all(|item| matches!(item.kind, Kind::Name(_))))
        })?,
        Takes::Scalars | Takes::Points | Takes::List | Takes::Rows => several()?,
        Takes::Coordinates => several().or_else(|| one.filter(|item| plain(item)).cloned())?,
        Takes::ScalarOrList => several().or_else(|| one.cloned())?,
        Takes::Point => {
            one.filter(|item| matches!(item.kind, Kind::Tuple(_) | Kind::Number(_) | Kind::Div(..)))?.clone()
        }
        // Four corners of a bilinear patch, row by row; else rows that are written as such.
        Takes::Net => {
            let net = several()?;
            let own = net.items().unwrap_or_default();
            let rows = |item: &Expr| matches!(item.kind, Kind::List(_));
            match own.iter().filter(|item| rows(item)).count() {
                0 if own.len() == 4 => list(own.chunks(2).map(|row| list(row.to_vec())).collect()),
                count if count == own.len() => net,
                _ => return None,
            }
        }
        Takes::Curve | Takes::Geometry => match one {
            Some(made @ Expr { kind: Kind::Apply(..) | Kind::Name(_), .. }) => made.clone(),
            _ => bezier(several()?),
        },
        Takes::Interval => several().filter(|list| list.items().is_some_and(|ends| ends.len() == 2))?,
        Takes::Matrix => one.filter(|item| matches!(item.kind, Kind::Matrix(..) | Kind::List(_)))?.clone(),
        Takes::OneOf(kinds) => return kinds.iter().find_map(|kind| of_kind(items, *kind, curve)),
        Takes::Any => several().or_else(|| one.cloned())?,
        _ => return None,
    };
    Some(vec![value])
}
