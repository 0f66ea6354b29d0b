//! Calls by names that other programs may have: `splitBezier({0, 4, 4, 0}, 1/2)`, `deBoor(2, knots, points, u=1/2)`. The words of
//! the name tell the function, the kinds of the arguments where they belong.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel, applied, call, named};
use crate::language::eval;
use crate::language::functions::{Builtin, Takes, builtin, function_called, function_in_words};
use crate::language::lexicon::phrases::{Phrase, phrase};
use crate::language::lexicon::roles;
use crate::session::{Session, defines};

use crate::session::foreign::as_list;

impl Session {
    /// The call that is meant by a statement that is one of an unknown function.
    pub(in crate::session) fn called_in_words(&self, file: &SourceFile, whole: Span) -> Option<Expr> {
        let text = file.slice(whole).trim_start();
        let name: &str = text.split('(').next().filter(|name| name.len() < text.len())?.trim_end();
        if let Some(value) = self.polar_value(file, whole, name) {
            return Some(value);
        }
        let plain = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !plain || defines(&self.env, name) || function_called(name).is_some() {
            return None;
        }
        let words = in_words(name)?;
        let (Phrase::Function(function) | Phrase::Command(function), length) =
            phrase(&words, &function_in_words)?
        else {
            return None;
        };
        let rest = words.get(length..)?.trim();
        // A noun of what it is done with: split bezier
        let object = ["", "bezier", "bezier curve", "curve", "spline", "bspline", "polynomial", "knots"];
        if !object.contains(&rest) {
            return None;
        }
        let read = self.read(file, whole).ok()?;
        let Kind::Apply(callee, groups) = read.kind else { return None };
        let [arguments] = groups.as_slice() else { return None };
        let builtin = builtin(function)?;
        let first = builtin.parameters.first()?;
        let arguments: Vec<Expr> = arguments.iter().cloned().map(as_list).map(inside_as_list).collect();
        let arguments = match first.kind {
            Takes::Spline => of_spline(arguments, whole)?,
            Takes::Curve | Takes::Polar | Takes::Geometry => {
                let mut arguments = in_places(builtin, arguments);
                if let Some(points @ Expr { kind: Kind::List(_), .. }) = arguments.first_mut() {
                    let span = points.span;
                    *points = call("bezier", vec![points.clone()], span);
                }
                arguments
            }
            _ => in_places(builtin, arguments),
        };
        Some(applied(Expr { span: callee.span, ..Expr::name(function) }, arguments, whole))
    }
}

impl Session {
    /// The value of a polar form whose arguments stand behind its polynomial: blossom(t^2, u, v).
    fn polar_value(&self, file: &SourceFile, whole: Span, name: &str) -> Option<Expr> {
        if function_called(name) != Some("polar") || defines(&self.env, name) {
            return None;
        }
        let Kind::Apply(callee, groups) = self.read(file, whole).ok()?.kind else { return None };
        let [arguments] = groups.as_slice() else { return None };
        let [formula, first, rest @ ..] = arguments.as_slice() else { return None };
        // polar(t^2, 3, t) has a degree and a letter.
        let letter = |item: &Expr| matches!(item.kind, Kind::Name(_));
        let degree = first.as_int().is_some() && rest.len() == 1 && letter(&rest[0]);
        let simple = |item: &Expr| {
            letter(item)
                || item.as_signed_int().is_some()
                || matches!(item.kind, Kind::Div(..) | Kind::Subscript(..))
        };
        let own = matches!(&callee.kind, Kind::Name(own) if own == name);
        if rest.is_empty() || degree || !own || !arguments.iter().skip(1).all(simple) {
            return None;
        }
        let form = call("polar", vec![formula.clone()], callee.span);
        Some(applied(form, arguments.get(1..)?.to_vec(), whole))
    }
}

/// The words of a name: `splitBezier`, `split_bezier`; `None` if it is a single one.
fn in_words(name: &str) -> Option<String> {
    let mut words = String::new();
    let mut before = '_';
    for letter in name.chars() {
        let start = letter.is_uppercase() && before.is_lowercase();
        if (start || letter == '_') && !words.is_empty() && !words.ends_with(' ') {
            words.push(' ');
        }
        if letter != '_' {
            words.extend(letter.to_lowercase());
        }
        before = letter;
    }
    words.contains(' ').then_some(words)
}

/// knots = {0, 1}
fn inside_as_list(mut argument: Expr) -> Expr {
    if let Kind::Chain(_, links) = &mut argument.kind
        && let [link @ Link { rel: Rel::Eq, .. }] = links.as_mut_slice()
    {
        link.expr = as_list(link.expr.clone());
    }
    argument
}

/// Arguments of a function, where the names of some are those of parameters or of a variable.
fn in_places(builtin: &Builtin, arguments: Vec<Expr>) -> Vec<Expr> {
    let known = |name: &str| builtin.parameters.iter().any(|parameter| parameter.name == name);
    let place = |argument: Expr| match eval::named(&argument) {
        Some((name, value)) if !known(&name) && roles::is_variable(&name) => value.clone(),
        _ => argument,
    };
    arguments.into_iter().map(place).collect()
}

/// A spline of its degree, knots and control points, which may stand in any order, and the parameters behind it.
fn of_spline(arguments: Vec<Expr>, span: Span) -> Option<Vec<Expr>> {
    let (mut degree, mut lists, mut numbers, mut values) = (None, Vec::new(), Vec::new(), Vec::new());
    for argument in arguments {
        match (&argument.kind, eval::named(&argument)) {
            (_, Some((name, value))) => match (name.as_str(), &value.kind) {
                (_, Kind::List(_)) => lists.push(value.clone()),
                ("p" | "n" | "degree" | "deg" | "k", _) => degree = Some(value.clone()),
                _ => values.push(value.clone()),
            },
            // degree 2
            (Kind::Mul(factors), _) => match factors.as_slice() {
                [Expr { kind: Kind::Name(word), .. }, number] if word == "degree" => {
                    degree = Some(number.clone());
                }
                _ => return None,
            },
            (Kind::List(_), _) => lists.push(argument),
            // A spline by itself.
            (Kind::Apply(..) | Kind::Name(_), _) if lists.is_empty() && numbers.is_empty() => return None,
            _ => numbers.push(argument),
        }
    }
    let [one, other] = lists.as_slice() else { return None };
    let count = |list: &Expr| list.items().map_or(0, <[_]>::len);
    let (knots, points) = if count(one) > count(other) { (one, other) } else { (other, one) };
    let expected = i64::try_from(count(knots)).ok()? - i64::try_from(count(points)).ok()? - 1;
    if degree.is_none() {
        let at = numbers.iter().position(|number| number.as_int() == Some(expected));
        degree = at.map(|at| numbers.remove(at));
    }
    let degree = degree.unwrap_or_else(|| Expr { span, ..Expr::int(expected) });
    let spline =
        call("bspline", vec![degree, named("knots", knots.clone()), named("points", points.clone())], span);
    Some(std::iter::once(spline).chain(numbers).chain(values).collect())
}
