//! What words say of functions that agree, as equations.

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::related::Contacts;
use crate::judge::known::checker::Checker;
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::{Contact, Place, Role, Statement};
use crate::judge::written::names::Head;

impl Checker {
    /// What words say, before a formula, of functions that agree.
    pub(in crate::judge) fn contacts(&self, place: &Place) -> Contacts {
        let understood = !self.context.unread.contains(&place.group);
        let mut found = Contacts { certain: Vec::new(), possible: understood.then(Vec::new) };
        let said = self.context.contacts.iter().filter(|(other, _)| {
            other.formula <= place.formula && place.in_reach(other, false) && place.sees(other)
        });
        for (other, contact) in said {
            let near = other.group == place.group;
            let functions = self.agreeing(contact, other);
            let equations = |orders: &[u32]| -> Option<Vec<Expr>> {
                let pairs = functions.windows(2).flat_map(|pair| {
                    let places = contact.places.iter();
                    places.flat_map(move |at| orders.iter().map(move |order| equation(pair, at, *order)))
                });
                pairs.collect()
            };
            let understood = functions.len() > 1;
            let anew = functions.iter().any(|(name, _)| {
                Head::of(name)
                    .is_none_or(|head| self.context.is_spoken_of_anew(&head.base, other, place) && !near)
            });
            if understood && !anew {
                found.certain.extend(equations(&contact.certain).unwrap_or_default());
            }
            let possible =
                contact.possible.as_ref().filter(|_| understood).and_then(|orders| equations(orders));
            match (possible, near) {
                (Some(possible), _) if !anew => {
                    found.possible.iter_mut().for_each(|all| all.extend(possible.clone()))
                }
                (None, true) => found.possible = None,
                _ => {}
            }
        }
        found
    }

    /// The functions that a sentence says agree: those that it names, or all of its paragraph if it names none.
    fn agreeing(&self, contact: &Contact, place: &Place) -> Vec<(Expr, Object)> {
        let known = |name: &Expr| {
            let declared = self.context.object(&Head::of(name)?, place)?;
            declared.object.is_any_polynomial().then(|| (name.clone(), Object::clone(&declared.object)))
        };
        let mut named: Vec<(Expr, Object)> = contact.names.iter().filter_map(known).collect();
        named.dedup_by(|a, b| a.0.same_as(&b.0));
        let forms = |(_, object): &&(Expr, Object)| object.sort == Sort::PolarForm;
        if named.len() < 2 {
            let here = self.context.objects.iter().filter(|told| told.place.group == place.group);
            let all = here.filter(|told| told.object.is_any_polynomial());
            named = Vec::new();
            for told in all {
                for name in &told.object.names {
                    if !named.iter().any(|(other, _)| other.same_as(name)) {
                        named.push((name.clone(), Object::clone(&told.object)));
                    }
                }
            }
        }
        let functions: Vec<(Expr, Object)> = named.iter().filter(|one| !forms(one)).cloned().collect();
        let polar: Vec<(Expr, Object)> = named.iter().filter(forms).cloned().collect();
        let chosen = if functions.is_empty() { polar } else { functions };
        if chosen.len() == 2 || contact.names.len() == chosen.len() { chosen } else { Vec::new() }
    }

    /// Whether a relation is claimed, and no further fact: its sentence says so, or says nothing but this.
    pub(in crate::judge) fn concludes(&self, statement: &Statement) -> bool {
        statement.role == Some(Role::Claimed) || statement.concludes && statement.role.is_none()
    }
}

/// F^{(k)}(a) = G^{(k)}(a); for polar forms the values f(a, …, a, a + 1, …, a + 1) with k arguments a + 1.
fn equation(pair: &[(Expr, Object)], at: &Expr, order: u32) -> Option<Expr> {
    let value = |(name, object): &(Expr, Object)| {
        if object.sort == Sort::PolarForm {
            let degree = u32::try_from(object.degree.as_ref()?.as_int()?).ok()?;
            let rest = degree.checked_sub(order)?;
            let next = at.clone().grouped().plus(1);
            let arguments = std::iter::repeat_n(at.clone(), rest as usize);
            return Some(Expr::apply(
                name.clone(),
                arguments.chain(std::iter::repeat_n(next, order as usize)).collect(),
            ));
        }
        let derived = match order {
            0 => name.clone(),
            order => Kind::Prime(Box::new(name.clone()), order).into(),
        };
        Some(Expr::apply(derived, vec![at.clone()]))
    };
    Some(Expr::relation(value(&pair[0])?, Rel::Eq, value(&pair[1])?))
}
