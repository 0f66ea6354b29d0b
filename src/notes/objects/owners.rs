//! Polar forms of which no words say whose they are.

use std::collections::BTreeMap;

use super::page::Page;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, bases};
use crate::language::lexicon::roles::is_variable;

/// "q is its polar form. We try it with Q(t) = …": a polar form of which no words say whose it is, is that of the function
/// with its letter as a capital.
pub(super) fn tell(page: &Page, found: &mut BTreeMap<usize, Vec<Object>>) {
    for (number, object) in
        found.iter_mut().flat_map(|(number, list)| list.iter_mut().map(|own| (*number, own)))
    {
        let ([Expr { kind: Kind::Name(letter), .. }], Sort::PolarForm, None) =
            (object.names.as_slice(), &object.sort, &object.of)
        else {
            continue;
        };
        let Some(here) = page.places.get(&number) else { continue };
        let near = page.formulas.keys().filter(|other| {
            page.places
                .get(other)
                .is_some_and(|there| there.scope == here.scope && there.blocks == here.blocks)
        });
        let function = |said: &Expr| {
            let Kind::Chain(left, links) = &said.kind else { return None };
            let Kind::Apply(callee, groups) = &left.kind else { return None };
            let head = Head::of(callee).filter(|head| head.lower.is_empty() && head.upper.is_empty())?;
            let capital = head.base.starts_with(char::is_uppercase) && head.base.to_lowercase() == *letter;
            let variable = matches!(groups.concat().as_slice(), [Expr { kind: Kind::Name(name), .. }] if is_variable(name));
            let formula = links[0].rel == Rel::Eq && !bases(&links[0].expr).contains(letter);
            (capital && variable && formula).then(|| callee.as_ref().clone())
        };
        object.of = near.flat_map(|other| page.said(*other)).find_map(function);
    }
}
