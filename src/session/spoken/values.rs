//! Values at which a result is taken: at t = 1/2, for a = 2.

use super::Read;
use crate::formula::{Expr, Kind, applied, call};
use crate::judge::written::names::bases;
use crate::language::eval;
use crate::language::lexicon::phrases::Label;
use crate::language::lexicon::roles;
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// What a result is, as to its values.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Nature {
    /// It has none at a parameter.
    Number,
    /// A function of one parameter.
    OfOne,
    /// A list of such functions.
    Several,
    /// A list of formulas in t.
    Formulas,
    /// Anything else.
    Other,
}

/// What no function takes: values of a result.
pub(super) struct Values(pub(super) Vec<Read>);

impl Values {
    /// The formula at these values.
    ///
    /// # Errors
    /// What cannot be put into it.
    pub(super) fn put_into(&mut self, formula: Expr, nature: &dyn Fn(&Expr) -> Nature) -> Result<Expr, Read> {
        // A curve at t = 1/2, a patch at u = 1/2 and v = 1/3: letters that do not occur are those of its parameters.
        let occur = bases(&formula);
        let parameter = |read: &Read| {
            let named = |item| eval::named(item).map(|(name, value)| (name, value.clone()));
            let values: Option<Vec<(String, Expr)>> = match read.label {
                Label::At | Label::With | Label::To => read.items.iter().map(named).collect(),
                _ => None,
            };
            values.filter(|values: &Vec<_>| {
                let free = |name: &String| roles::is_variable(name) && !occur.contains(name);
                !values.is_empty() && values.iter().all(|(name, _)| free(name))
            })
        };
        let mut parameters: Vec<(String, Expr)> = Vec::new();
        let mut others = Vec::new();
        for mut read in self.0.drain(..) {
            // at t = 1/4, t = 1/2
            let named: Vec<(String, Expr)> = read
                .items
                .iter()
                .filter_map(|item| eval::named(item).map(|(name, value)| (name, value.clone())))
                .collect();
            if let [(first, _), rest @ ..] = named.as_slice()
                && !rest.is_empty()
                && named.len() == read.items.len()
                && rest.iter().all(|(name, _)| name == first)
                && roles::is_variable(first)
                && read.label == Label::At
            {
                read.items = named.iter().map(|(_, value)| value.clone()).collect();
            }
            match parameter(&read) {
                Some(_) if nature(&formula) == Nature::Number => return Err(read),
                // t = 1 and t = 2
                Some(values)
                    if values.iter().any(|(name, _)| parameters.iter().any(|(known, _)| known == name)) =>
                {
                    return Err(read);
                }
                Some(values) => parameters.extend(values),
                // at 3 and at 0
                None => match others.last_mut() {
                    Some(Read { label: Label::At, items }) if read.label == Label::At => {
                        items.extend(read.items);
                    }
                    _ => others.push(read),
                },
            }
        }
        parameters.sort_by(|(one, _), (other, _)| one.cmp(other));
        let mut formula = formula;
        if !parameters.is_empty() {
            let span = formula.span;
            formula = applied(formula, parameters.into_iter().map(|(_, value)| value).collect(), span);
        }
        for read in others {
            match value_of(&formula, &read, nature) {
                Some(at) => formula = at,
                None => return Err(read),
            }
        }
        Ok(formula)
    }
}

/// The value of a result: at a parameter, or for values of its names.
pub(super) fn value_of(whole: &Expr, read: &Read, nature: &dyn Fn(&Expr) -> Nature) -> Option<Expr> {
    if !matches!(read.label, Label::At | Label::With | Label::To) {
        return None;
    }
    let own = nature(whole);
    if own == Nature::Number {
        return None;
    }
    let span = whole.span;
    let equation = |item: &Expr| eval::named(item).is_some();
    if read.items.iter().all(equation) {
        return Some(call("subs", std::iter::once(whole).chain(&read.items).cloned().collect(), span));
    }
    if read.label != Label::At || read.items.iter().any(|item| matches!(item.kind, Kind::Chain(..))) {
        return None;
    }
    let polar = matches!(&whole.kind, Kind::Apply(callee, _)
        if matches!(&callee.kind, Kind::Name(name) if name == "polar"));
    // at (0, 1) and (1, 1); a curve at 0, 1/2, 1
    let tuple = |item: &Expr| matches!(&item.kind, Kind::Tuple(items) if items.len() > 1);
    // at 0,5
    if let [before, after] = read.items.as_slice()
        && own == Nature::OfOne
        && eval::is_decimal_comma(before, after)
    {
        return None;
    }
    let points = read.items.iter().all(tuple);
    if read.items.len() > 1 && (points || own == Nature::OfOne) {
        let at = |item: &Expr| match &item.kind {
            Kind::Tuple(items) if points => applied(whole.clone(), items.clone(), span),
            _ => applied(whole.clone(), vec![item.clone()], span),
        };
        return Some(Expr::new(Kind::List(read.items.iter().map(at).collect()), span));
    }
    // All basis functions at 1/2
    if matches!(own, Nature::Several | Nature::Formulas) && !points {
        let letter = Expr { span, ..Expr::name("f") };
        let of_each = |at: &Expr| {
            if own == Nature::Formulas {
                return call("subs", vec![whole.clone(), crate::formula::named("t", at.clone())], span);
            }
            let value = applied(letter.clone(), vec![at.clone()], span);
            let each = Expr::new(Kind::Lambda(vec![letter.clone()], Box::new(value)), span);
            call("map", vec![each, whole.clone()], span)
        };
        return Some(match read.items.as_slice() {
            [one] => of_each(one),
            several => Expr::new(Kind::List(several.iter().map(of_each).collect()), span),
        });
    }
    // One of the Lagrange polynomials; a parenthesis behind an index would be a factor.
    if let (Kind::Subscript(..), [value]) = (&whole.kind, read.items.as_slice()) {
        return Some(call("subs", vec![whole.clone(), crate::formula::named("t", value.clone())], span));
    }
    let arguments = match read.items.as_slice() {
        // In u and v, or in barycentric coordinates.
        [Expr { kind: Kind::Tuple(items), .. }] => items.clone(),
        [Expr { kind: Kind::List(items), .. }] if polar => items.clone(),
        items => items.to_vec(),
    };
    Some(applied(whole.clone(), arguments, span))
}

/// Whether it is a formula in t.
pub(super) fn is_in_t(item: &Value) -> bool {
    matches!(item, Value::Scalar(formula) if formula.variables() == [Symbol::new("t")])
}

/// Whether there are values of it at a parameter.
pub(super) fn has_values(item: &Value) -> bool {
    match item {
        Value::Geometry(geometry) => !geometry.is_surface(),
        Value::Piecewise(_) => true,
        _ => false,
    }
}
