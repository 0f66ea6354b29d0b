//! Values at which a result is taken: at t = 1/2, for a = 2.

use super::Read;
use crate::formula::{Expr, Kind, applied, call};
use crate::judge::names::bases;
use crate::language::eval;
use crate::language::lexicon::phrases::Label;
use crate::language::lexicon::roles;

/// What no function takes: values of a result.
pub(super) struct Values(pub(super) Vec<Read>);

impl Values {
    /// The formula at these values.
    ///
    /// # Errors
    /// What cannot be put into it.
    pub(super) fn put_into(
        &mut self,
        formula: Expr,
        is_number: &dyn Fn(&Expr) -> bool,
    ) -> Result<Expr, Read> {
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
        for read in self.0.drain(..) {
            match parameter(&read) {
                Some(_) if is_number(&formula) => return Err(read),
                // t = 1 and t = 2
                Some(values)
                    if values.iter().any(|(name, _)| parameters.iter().any(|(known, _)| known == name)) =>
                {
                    return Err(read);
                }
                Some(values) => parameters.extend(values),
                None => others.push(read),
            }
        }
        parameters.sort_by(|(one, _), (other, _)| one.cmp(other));
        let mut formula = formula;
        if !parameters.is_empty() {
            let span = formula.span;
            formula = applied(formula, parameters.into_iter().map(|(_, value)| value).collect(), span);
        }
        for read in others {
            match value_of(&formula, &read, is_number) {
                Some(at) => formula = at,
                None => return Err(read),
            }
        }
        Ok(formula)
    }
}

/// The value of a result: at a parameter, or for values of its names.
pub(super) fn value_of(whole: &Expr, read: &Read, is_number: &dyn Fn(&Expr) -> bool) -> Option<Expr> {
    if !matches!(read.label, Label::At | Label::With | Label::To) || is_number(whole) {
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
    let arguments = match read.items.as_slice() {
        // In u and v, or in barycentric coordinates.
        [Expr { kind: Kind::Tuple(items), .. }] => items.clone(),
        [Expr { kind: Kind::List(items), .. }] if polar => items.clone(),
        items => items.to_vec(),
    };
    Some(applied(whole.clone(), arguments, span))
}
