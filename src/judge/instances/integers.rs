//! The integers of a chain: which names are some, and which values are tried.

use crate::language::lexicon::families::Family;
use crate::language::lexicon::roles;
use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::judge::instances::trial::Trial;
use crate::judge::page::context::{Body, Definition, Source};
use crate::judge::values::evaluator;
use crate::judge::written::features::highest_derivative;
use crate::judge::written::names::{
    Head, bases, integer_names, is_extreme, is_index_letter, own_names, underived, walk,
};
use crate::language::value::Value;
use crate::language::write;
use crate::math::poly::Symbol;

/// With more integers in the sides no others are tried beside them.
const MOST_BESIDE_SIZES: usize = 3;

/// Degrees tried for functions without a definition, unless a derivative asks for more.
const LARGEST_DEGREE: usize = 4;

/// Numbers in a side up to this one say how many values of an integer have to be tried.
const LARGEST_NUMBER: i64 = 20;

/// Formulas for any function with so many of its values are tried for higher degrees.
const MOST_VALUES: usize = 8;

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
        // m, where the page has x(t) = Σ_{i=0}^m …, and of x(1) = b_n the n is another size
        if names.iter().any(|name| roles::is_degree(name)) && names.len() <= MOST_BESIDE_SIZES {
            names.extend(self.other_sizes(&names));
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

    /// Sizes in what the page says of the names of the chain, which stand in no side.
    fn other_sizes(&self, names: &BTreeSet<String>) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        let mut put = |sizes: BTreeSet<String>, own: &BTreeSet<String>| {
            let sizes = sizes.into_iter().filter(|name| roles::is_degree(name));
            found.extend(sizes.filter(|name| !own.contains(name) && !names.contains(name)));
        };
        for base in &self.facts.reached {
            for (_, definition, near) in self.context.visible(base, self.place) {
                if let (true, Body::Formula(body)) = (near, &definition.body) {
                    let head = &definition.head;
                    let own =
                        head.lower.iter().chain(&head.upper).chain(head.flat()).flat_map(bases).collect();
                    put(integer_names(body), &own);
                }
            }
        }
        for object in self.spoken() {
            if let Some(degree) = &object.degree {
                put(bases(degree), &BTreeSet::new());
            }
        }
        // n = 2m: it is none of its own.
        let made = |name: &String| {
            let mut said = self.conditions.iter().chain(self.hypotheses()).filter_map(equated_index);
            let all: Vec<String> = names.iter().cloned().collect();
            said.any(|own| own == name) || self.by_formula(name, &all).is_some()
        };
        found.retain(|name| !made(name));
        found
    }

    /// What the page says that an integer is made of: i + j + k for n, n - i for j, 2m + 1 for n.
    pub(in crate::judge) fn made_of(&self, name: &str, integers: &[String]) -> Option<Expr> {
        self.as_sum(name, integers).or_else(|| self.by_formula(name, integers))
    }

    /// The formula that the paragraph, or words that give it, have for an integer in others of the chain.
    fn by_formula(&self, name: &str, integers: &[String]) -> Option<Expr> {
        let (_, definition, near) = self.context.visible(name, self.place).next()?;
        let Definition { head, body: Body::Formula(body), place, source, .. } = definition else {
            return None;
        };
        let given = place.group == self.place.group || *source == Source::Given;
        let plain = head.is_bare();
        let own = bases(body);
        let others = !own.is_empty() && own.iter().all(|other| other != name && integers.contains(other));
        let arithmetic = !body.has(&|part| {
            !matches!(
                part.kind,
                Kind::Name(_)
                    | Kind::Number(_)
                    | Kind::Add(_)
                    | Kind::Mul(_)
                    | Kind::Div(..)
                    | Kind::Pow(..)
                    | Kind::Group(_)
            )
        });
        // j = n - i: i is not made of j then.
        let back = |other: &String| {
            let mut visible = self.context.visible(other, self.place);
            visible.next().is_some_and(|(number, ..)| {
                let other = &self.context.definitions[number];
                matches!(&other.body, Body::Formula(body) if bases(body).contains(name))
            })
        };
        (near && given && plain && others && arithmetic && !own.iter().any(back)).then(|| body.clone())
    }

    /// What a condition says an integer is the sum of: i + j + k for n.
    fn as_sum(&self, name: &str, integers: &[String]) -> Option<Expr> {
        let sum = |condition: &Expr| {
            let Kind::Chain(left, links) = &condition.kind else { return None };
            let [link] = links.as_slice() else { return None };
            let (own, sum) = match (&left.kind, &link.expr.kind) {
                (Kind::Name(own), Kind::Add(_)) => (own, &link.expr),
                (Kind::Add(_), Kind::Name(own)) => (own, left.as_ref()),
                _ => return None,
            };
            let Kind::Add(terms) = &sum.kind else { return None };
            let letters = terms.iter().all(|term| {
                term.sign == Sign::Plus
                    && matches!(&term.expr.kind, Kind::Name(other) if other != name && integers.contains(other))
            });
            (link.rel == Rel::Eq && own == name && letters).then(|| sum.clone())
        };
        let said = self.conditions.iter().chain(self.hypotheses()).find_map(sum);
        said.or_else(|| {
            // The n of B_{ijk}^n
            let mut found = None;
            let mut look = |part: &Expr| {
                let Some(head) = Head::of(part).filter(|head| head.is_a(Family::Triangular)) else { return };
                let letter = |expr: &Expr| matches!(&expr.kind, Kind::Name(own) if integers.contains(own));
                let own =
                    matches!(head.upper.as_slice(), [Expr { kind: Kind::Name(own), .. }] if own == name);
                if own && head.lower.iter().all(letter) {
                    found = Some(Expr::sum(
                        head.lower.into_iter().map(|expr| Term { sign: Sign::Plus, expr }).collect(),
                    ));
                }
            };
            self.sides.iter().for_each(|side| walk(side, &mut look));
            found
        })
    }

    /// Whether no side has names but these integers, and those that its sums run over.
    pub(super) fn is_of_integers(&self, integers: &[String]) -> bool {
        self.sides.iter().all(|side| {
            let mut inside = BTreeSet::new();
            walk(side, &mut |part| {
                if let Kind::Big { lower, .. } = &part.kind {
                    inside.extend(own_names(lower));
                }
            });
            bases(side).iter().all(|name| integers.contains(name) || inside.contains(name))
        })
    }

    /// The largest small number in a side.
    pub(super) fn largest_number(&self) -> i64 {
        let mut found = 0;
        for side in &self.sides {
            walk(side, &mut |part| {
                let number = part.as_int().filter(|number| (0..=LARGEST_NUMBER).contains(number));
                found = found.max(number.unwrap_or(0));
            });
        }
        found
    }

    /// A degree for which every derivative that is written is still alive.
    pub(super) fn largest_degree(&self) -> usize {
        let derivatives = self.sides.iter().map(|side| highest_derivative(side) + 1);
        // What is made of k values of any function is exact for degrees below k by chance.
        let mut places: BTreeSet<String> = BTreeSet::new();
        for side in &self.sides {
            walk(side, &mut |part| {
                if let Kind::Apply(callee, groups) = &part.kind
                    && Head::of(underived(callee))
                        .is_some_and(|head| self.context.letters.is_function(&head.base))
                    && let [argument] = groups.concat().as_slice()
                {
                    places.insert(write::text(argument));
                }
            });
        }
        let values = if places.len() > LARGEST_DEGREE { (places.len() + 1).min(MOST_VALUES) } else { 0 };
        derivatives.fold(LARGEST_DEGREE.max(values), usize::max)
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

/// The largest values of indices, as Bernstein polynomials and binomial coefficients tell them: 3 for the i of B_i^3, m for
/// that of B_i^m.
pub(in crate::judge) fn last_values(sides: &[&Expr]) -> Vec<(String, Expr)> {
    let mut found = Vec::new();
    let mut pair = |index: &Expr, last: &Expr| {
        // In B_{n,0} the degree comes first.
        if let Kind::Name(name) = &index.kind
            && !roles::is_size(name)
        {
            found.push((name.clone(), last.clone()));
        }
    };
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Binomial(upper, lower, _) = &part.kind {
                return pair(lower, upper);
            }
            let Some(head) = Head::of(part).filter(Head::is_bernstein) else { return };
            if let ([index], [degree]) | ([index, degree], []) =
                (head.lower.as_slice(), head.upper.as_slice())
            {
                pair(index, degree);
            }
        });
    }
    found
}

/// Whether an index is greater than its last value, or than the least size, if no index has a last value.
pub(in crate::judge) fn is_outside(bound: &[(String, i64)], last: &[(String, Expr)]) -> bool {
    let mut told = false;
    for (name, most) in last {
        let Some((_, value)) = bound.iter().find(|(own, _)| own == name) else { continue };
        let most = evaluator::machine().with_locals(as_values(bound), |machine| machine.eval_int(most));
        let Ok(most) = most else { continue };
        told = true;
        if *value > most {
            return true;
        }
    }
    let least = bound.iter().filter(|(name, _)| roles::is_size(name)).map(|(_, value)| *value).min();
    !told
        && least
            .is_some_and(|least| bound.iter().any(|(name, value)| !roles::is_size(name) && *value > least))
}

/// Whether no integer is 0.
pub(in crate::judge) fn is_positive(bound: &[(String, i64)]) -> bool {
    bound.iter().all(|(_, value)| *value > 0)
}

/// The letters for which 0 may not be meant where nothing is said: sizes, and those of which something less is written,
/// as the i of B_{i-1}, or that something is divided by.
pub(in crate::judge) fn may_begin_with_one(sides: &[&Expr]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let names = |expr: &Expr| bases(expr).into_iter().filter(|name| is_index_letter(name));
    for side in sides {
        found.extend(names(side).filter(|name| roles::is_size(name)));
        walk(side, &mut |part| match &part.kind {
            Kind::Add(terms) if terms.iter().any(|term| term.sign == Sign::Minus) => {
                found.extend(names(part))
            }
            Kind::Div(_, below, _) => found.extend(names(below)),
            _ => {}
        });
    }
    found
}
