//! The integers of a chain: which names are some, and which values are tried.

use crate::language::lexicon::roles;
use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::trial::Trial;
use crate::judge::page::context::Body;
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases, integer_names, is_extreme, is_index_letter, walk};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// Names with their integers, for the evaluator.
pub(in crate::judge) fn as_values(bound: &[(String, i64)]) -> impl Iterator<Item = (Symbol, Value)> {
    bound.iter().map(|(name, value)| (Symbol::new(name), Value::int(*value)))
}

impl Trial<'_> {
    /// The integers of the chain.
    pub fn integers(&self) -> Vec<String> {
        let mut names: BTreeSet<String> = BTreeSet::new();
        for side in &self.sides {
            names.extend(integer_names(side));
        }
        for condition in self.conditions {
            // i = 0, …, n: its bound is an integer, too
            let own = integer_names(condition);
            let ranges = matches!(&condition.kind, Kind::Chain(_, links)
                if links.iter().any(|link| matches!(link.expr.kind, Kind::Range(..))));
            if ranges {
                names.extend(own);
            }
        }
        // n = 2, also where n stands in what b_0 is only; n = 2 and n = 3 are two cases
        let said: Vec<&String> = self.conditions.iter().filter_map(equated_index).collect();
        let once = |name: &&&String| said.iter().filter(|other| *other == *name).count() == 1;
        names.extend(
            said.iter().filter(once).filter(|name| self.fixed(name).is_some()).map(|name| (*name).clone()),
        );
        // n in a formula about P, where P(t) = Σ_{i=0}^n …
        let used: BTreeSet<String> = self.sides.iter().flat_map(|side| bases(side)).collect();
        for base in &used {
            for (_, definition, _) in self.context.visible(base, self.place) {
                if let Body::Formula(body) = &definition.body {
                    let own: Vec<String> =
                        definition.head.lower.iter().chain(&definition.head.upper).flat_map(bases).collect();
                    names.extend(
                        integer_names(body).into_iter().filter(|name| {
                            roles::is_degree(name) && used.contains(name) && !own.contains(name)
                        }),
                    );
                }
            }
        }
        // n in c_i = i/(n + 1) …, where hypotheses have sums up to n
        let first = self.sides.first().and_then(|side| Head::of(side)).map(|head| head.base);
        let about = |hypothesis: &&Expr| {
            matches!(&hypothesis.kind, Kind::Chain(_, links) if links[0].rel == Rel::Eq)
                && first.as_ref().is_some_and(|base| bases(hypothesis).contains(base))
        };
        for hypothesis in self.hypotheses().iter().filter(about) {
            names.extend(integer_names(hypothesis).into_iter().filter(|name| used.contains(name)));
        }
        // n in n f(t, …, t), where words say that F is of degree n
        for object in self.spoken() {
            if let Some(degree) = &object.degree {
                let own = bases(degree).into_iter().filter(|name| is_index_letter(name));
                names.extend(own.filter(|name| used.contains(name)));
            }
        }
        // A name that is a variable of a function on a side is no integer.
        let mut arguments: BTreeSet<String> = BTreeSet::new();
        for side in &self.sides {
            walk(side, &mut |part| {
                if let Kind::Derivative { variables, .. } = &part.kind {
                    arguments.extend(variables.iter().filter_map(|(v, _)| Head::of(v)).map(|head| head.base));
                }
                if let Kind::Apply(callee, groups) = &part.kind
                    && !is_extreme(callee)
                    && Head::of(callee).is_some_and(|head| self.context.letters.is_function(&head.base))
                {
                    for argument in groups.iter().flatten() {
                        if let Kind::Name(name) = &argument.kind {
                            arguments.insert(name.clone());
                        }
                    }
                }
            });
        }
        // s(j) = d_{j-1} + …: an index is an integer wherever it stands
        let mut indices: BTreeSet<String> = BTreeSet::new();
        for side in &self.sides {
            walk(side, &mut |part| {
                if let Kind::Subscript(_, lower) = &part.kind {
                    indices.extend(lower.iter().flat_map(bases).filter(|name| is_index_letter(name)));
                }
            });
        }
        arguments.retain(|name| !indices.contains(name));
        // m = 3, said in this paragraph
        let given = |name: &String| self.context.number_in(name, self.place).is_some();
        names.retain(|name| !arguments.contains(name) && name != "e" && !given(name));
        names.into_iter().collect()
    }

    /// The value that a condition of the chain gives an integer: n = 2.
    pub(in crate::judge) fn fixed(&self, name: &str) -> Option<i64> {
        self.conditions.iter().find_map(|condition| match &condition.kind {
            Kind::Chain(left, links) if matches!(&left.kind, Kind::Name(own) if own == name) => {
                match links.as_slice() {
                    [link] if link.rel == Rel::Eq => evaluator::machine().eval_int(&link.expr).ok(),
                    _ => None,
                }
            }
            _ => None,
        })
    }
}

/// The index that a condition gives a value: n = 2.
pub(in crate::judge) fn equated_index(condition: &Expr) -> Option<&String> {
    match &condition.kind {
        Kind::Chain(left, links) if links.len() == 1 && links[0].rel == Rel::Eq => match &left.kind {
            Kind::Name(name) if is_index_letter(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

/// Whether no index is at an end of its range, as far as names tell: sizes at least 2, indices
/// between 1 and the least size minus 1.
pub(in crate::judge) fn is_inner(bound: &[(String, i64)]) -> bool {
    let least = bound.iter().filter(|(name, _)| roles::is_size(name)).map(|(_, value)| *value).min();
    bound.iter().all(|(name, value)| {
        if roles::is_size(name) {
            *value >= 2
        } else {
            *value >= 1 && least.is_none_or(|least| *value < least.max(2))
        }
    })
}

/// The largest values of the indices of Bernstein polynomials whose degree is a number: 3 for the i of B_i^3.
pub(in crate::judge) fn last_values(sides: &[&Expr]) -> Vec<(String, i64)> {
    let mut found = Vec::new();
    for side in sides {
        walk(side, &mut |part| {
            let Some(head) = Head::of(part).filter(Head::is_bernstein) else { return };
            let (index, degree) = match (head.lower.as_slice(), head.upper.as_slice()) {
                ([index], [degree]) | ([index, degree], []) => (index, degree.as_int()),
                _ => return,
            };
            // In B_{n,0} the degree comes first.
            if let (Kind::Name(name), Some(degree)) = (&index.kind, degree)
                && !roles::is_size(name)
            {
                found.push((name.clone(), degree));
            }
        });
    }
    found
}

/// Whether an index is greater than the least size, or than its last value.
pub(in crate::judge) fn is_outside(bound: &[(String, i64)], last: &[(String, i64)]) -> bool {
    let beyond = |(name, value): &(String, i64)| last.iter().any(|(own, most)| own == name && value > most);
    if bound.iter().any(beyond) {
        return true;
    }
    let least = bound.iter().filter(|(name, _)| roles::is_size(name)).map(|(_, value)| *value).min();
    least.is_some_and(|least| bound.iter().any(|(name, value)| !roles::is_size(name) && *value > least))
}
