//! Doubts about what is meant: why a relation that fails is not wrong for sure.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::instances::tally::Tally;
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition, is_variable};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Chain, Place, Statement};
use crate::judge::values::compare;
use crate::judge::written::features::{has_column, without_argument};
use crate::judge::written::names::{Head, bases, is_range, walk};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// Why it is not sure what a relation means, if it is not.
pub(in crate::judge) fn of_meaning(
    checker: &Checker,
    tally: &Tally,
    chain: &Chain,
    at: usize,
    statement: &Statement,
) -> Option<String> {
    let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
    if let Some(name) = without_argument(left).or_else(|| without_argument(right)) {
        return Some(format!("{name} has no argument here"));
    }
    // B_n^m f, the operator m times
    let power = |part: &Expr| {
        let Kind::Mul(factors) = &part.kind else { return false };
        let [first, second, ..] = factors.as_slice() else { return false };
        let function =
            |head: &Head| head.arguments.is_none() && checker.context.letters.is_function(&head.base);
        Head::of(first).is_some_and(|head| !head.upper.is_empty() && checker.operators.contains(&head.base))
            && Head::of(second).is_some_and(|head| function(&head))
    };
    if left.has(&power) || right.has(&power) {
        return Some("powers of an operator are not computed".to_owned());
    }
    let used = tally.record.definitions.iter().map(|(number, _)| &checker.context.definitions[*number].body);
    let columns = used.into_iter().any(|body| matches!(body, Body::Formula(body) if has_column(body)));
    let read = checker.context.letters.has_columns();
    if !read && (columns || has_column(left) || has_column(right)) {
        return Some("what looks like a binomial coefficient may be a column".to_owned());
    }
    // "at the same point B_{300}^3 = 1/27"
    let bare = |side: &Expr| {
        Head::of(side).is_some_and(|head| {
            let head = checker.context.with_pairs_apart(head);
            head.arguments.is_none() && head.is_bernstein()
        })
    };
    let number = |side: &Expr| bases(side).is_empty();
    if bare(left) && number(right) || number(left) && bare(right) {
        return Some("it has no argument here".to_owned());
    }
    if [left, right].iter().any(|side| checker.leaves_a_part(side, tally)) {
        return Some("a formula in it holds for a part of the range only".to_owned());
    }
    if tally.record.unbounded {
        return Some("it fails for some bounds, but the bounds of a sum are not given".to_owned());
    }
    if chain.relations[at].0 == Rel::Define {
        return Some("it defines its left side".to_owned());
    }
    if chain.blocked || !chain.conditions.iter().all(is_understood) {
        return Some("it fails for some values, but a condition beside it is not understood".to_owned());
    }
    let invented = tally.fails.iter().all(|failure| failure.around.is_some())
        && !tally.fails.is_empty()
        && checker.invents_knots(left, right, &statement.place);
    if invented {
        return Some("nothing says what the knots are".to_owned());
    }
    // Numbers of an example belong to its knots.
    let numbers = tally.record.definitions.iter().any(|(number, _)| {
        let definition = &checker.context.definitions[*number];
        !definition.head.lower.is_empty()
            && match &definition.body {
                Body::Formula(body) => bases(body).is_empty(),
                Body::Value(value) => compare::symbols(value).is_empty(),
            }
    });
    let letters = checker.context.knot_letters(&statement.place, &[left, right]);
    let given = !checker.context.given_knots(&letters, &statement.place).is_empty();
    if numbers
        && !given
        && !tally.fails.is_empty()
        && tally.fails.iter().all(|failure| failure.around.is_some())
    {
        return Some("the knots that these numbers belong to are not known".to_owned());
    }
    let variable = |symbol: &Symbol| symbol.is_plain() && is_variable(symbol.base());
    let varies = |value: &Value| compare::symbols(value).iter().any(variable);
    // "At the corner P_u = 3 (P_10 - P_00)": where the derivative is taken the words say.
    let unapplied = |side: &Expr| {
        Head::of(side).is_some_and(|head| {
            let letters = || head.lower.iter().flat_map(bases);
            head.arguments.is_none() && letters().next().is_some() && letters().all(|name| is_variable(&name))
        })
    };
    let at_a_place =
        |side: &Expr, own: &Value, other: &Value| unapplied(side) && varies(own) && !varies(other);
    if tally.fails.first().is_some_and(|failure| {
        at_a_place(left, &failure.left, &failure.right) || at_a_place(right, &failure.right, &failure.left)
    }) {
        return Some("it has no argument here".to_owned());
    }
    checker.said_in_unknown_words([left, right], &statement.place)
}

impl Checker {
    /// What the page says of a name in words that are not understood may be what a claim rests on.
    pub(in crate::judge) fn said_in_unknown_words(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let names = sides.into_iter().flat_map(bases);
        names.into_iter().find_map(|base| {
            // A formula for it says all.
            let defined = self.context.visible(&base, place).any(|(_, definition, near)| {
                near && definition.head.arguments.is_some()
                    && definition.head.flat().iter().all(|argument| matches!(argument.kind, Kind::Name(_)))
            });
            // So do those for all its members here.
            let members_defined = || {
                let mut members = Vec::new();
                for side in sides {
                    walk(side, &mut |part| {
                        let own = |head: &Head| head.base == base && !head.lower.is_empty();
                        members.extend(
                            Head::of(part).filter(own).map(|head| Head { upper: Vec::new(), ..head }),
                        );
                    });
                }
                let said = |member: &Head| self.is_covered(member, place) || self.has_formula(member, place);
                !members.is_empty() && members.iter().all(said)
            };
            match &self.context.object_called(&base, place)?.object.sort {
                Sort::Other(words) if !defined && !members_defined() => {
                    Some(format!("it fails for some values, but {base} is said to be: {words}"))
                }
                _ => None,
            }
        })
    }

    /// Whether a formula for a member stands among the conditions, as for r_{cd}, whose index is none.
    fn has_formula(&self, member: &Head, place: &Place) -> bool {
        let own = |side: &Expr| {
            Head::of(side).is_some_and(|head| {
                head.base == member.base
                    && head.lower.len() == member.lower.len()
                    && head.lower.iter().zip(&member.lower).all(|(one, other)| one.same_as(other))
            })
        };
        self.context.conditions.iter().any(|fact| {
            place.knows(&fact.place, false)
                && matches!(&fact.expr.kind, Kind::Chain(left, links) if own(left)
                    && matches!(links.as_slice(), [link] if link.rel == Rel::Eq))
        })
    }

    /// Whether an integral goes beyond what the page says of its function: ∫_0^3 s(x) dx, where s is given on [0, 1].
    fn leaves_a_part(&self, side: &Expr, tally: &Tally) -> bool {
        let range = |definition: &Definition| {
            let own: BTreeSet<String> = definition.head.flat().into_iter().flat_map(bases).collect();
            let restricts = |condition: &&Expr| is_range(condition) && !bases(condition).is_disjoint(&own);
            definition.conditions.iter().find(restricts).cloned()
        };
        let used = tally.record.definitions.iter().map(|(number, _)| &self.context.definitions[*number]);
        let ranges: Vec<Expr> = used.filter_map(range).collect();
        let mut found = false;
        walk(side, &mut |part| {
            let Kind::Integral { lower, upper, .. } = &part.kind else { return };
            let ends = || lower.iter().chain(upper);
            let named = |range: &Expr| ends().all(|end| range.has(&|inner| inner.same_as(end)));
            found |= ranges.iter().any(|range| !named(range));
        });
        found
    }
}

/// Whether what a condition restricts is seen from its form.
fn is_understood(condition: &Expr) -> bool {
    if let Some(items) = condition.alternatives() {
        return items.iter().all(is_understood);
    }
    let Kind::Chain(_, links) = &condition.kind else { return false };
    links.iter().all(|link| match link.rel {
        Rel::NotIn => interval(&link.expr).is_some(),
        Rel::In => match &link.expr.kind {
            Kind::List(_) | Kind::Tuple(_) | Kind::Apply(..) | Kind::Set(_, None) | Kind::Range(..) => true,
            // i ∈ ℤ, x ∈ ℝ, p ∈ ℝ^3
            Kind::Accent(..) => true,
            Kind::Pow(base, _) | Kind::Subscript(base, _) => matches!(base.kind, Kind::Accent(..)),
            _ => false,
        },
        Rel::Eq | Rel::Ne | Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge => true,
        _ => false,
    })
}
