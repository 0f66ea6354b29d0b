//! When a relation that fails is wrong, and when it is a condition, an equation or a new definition.
//!
//! A false alarm is worse than silence. A relation is refuted only if its names have a certain
//! meaning and it can be nothing but a claim; everything else that fails stays open.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::hypotheses::is_coefficient;
use crate::judge::instances::tally::{Failure, Outcomes, Tally};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition, Source, is_variable};
use crate::judge::page::statement::{Chain, Role, Statement};
use crate::judge::reasons::counterexample::{best_failure, counterexample, reasons};
use crate::judge::reasons::doubts;
use crate::judge::reasons::failure::{
    are_of_parameters, degrees_agree, is_argument, renames_its_letters, visible,
};
use crate::judge::values::compare::{self};
use crate::judge::written::features::{bare_values, has_divided_differences, has_structure, loose_index};
use crate::judge::written::names::{Head, bases, calls, integer_names, is_index_letter, is_range, walk};
use crate::language::lexicon::families;
use crate::language::lexicon::letters::is_one_letter;
use crate::language::value::Value;
use crate::language::write;
use crate::math::poly::{Fraction, Index, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// Why an equation is left open of whose names nothing is known.
pub(in crate::judge) const MEANINGLESS: &str = "an equation between names without a meaning";

/// What a failing relation is taken for.
pub enum Decision {
    /// Wrong.
    Refuted {
        /// The instance that shows it best.
        failure: Box<Failure>,
        /// Why, in words.
        reasons: String,
    },
    /// The name on the left is defined anew, perhaps with a warning.
    Redefinition(Option<String>),
    /// It says how the members of a family follow from those that are known: F_{n+1} = F_n + F_{n-1}.
    Recursion(Box<Head>),
    /// Not decided, and why.
    Open(String),
    /// It may be a condition, unless something shows that it is a slip.
    Condition(String),
    /// It contradicts what another section defines: wrong, if others of this section show that the same is meant.
    Far(Box<Failure>, String),
    /// Suspicious: an index that belongs to nothing.
    Loose(String),
}

/// Whether the head is that of a family with a standard meaning.
pub fn is_standard(head: Option<&Head>) -> bool {
    let word = |index: &Expr| match &index.kind {
        Kind::Text(_) => true,
        Kind::Name(name) => !is_one_letter(name),
        _ => false,
    };
    head.is_some_and(|head| {
        let indices = || head.lower.iter().chain(&head.upper);
        families::has_values(&head.base)
            && !head.has_its_degree_below()
            && indices().next().is_some()
            && !indices().any(word)
    })
}

/// "Hence b_3 = 10", where the section says "let b_3 = 11": what is given is not found to be something else.
fn contradiction(
    checker: &Checker,
    head: &Head,
    chain: &Chain,
    statement: &Statement,
    failure: &Failure,
) -> Option<String> {
    let claimed = statement.role == Some(Role::Claimed) && chain.conditions.is_empty();
    let constant = [&failure.left, &failure.right].iter().all(|value| compare::symbols(value).is_empty());
    let same = |own: &Head| {
        own.lower.len() == head.lower.len()
            && own.lower.iter().zip(&head.lower).all(|(a, b)| a.same_as(b))
            && own.flat().len() == head.flat().len()
            && own.flat().iter().zip(head.flat()).all(|(a, b)| a.same_as(b))
    };
    let (_, given, near) =
        checker.context.visible(&head.base, &statement.place).find(|(_, own, _)| same(&own.head))?;
    let unchanged = !statement.place.may_change(&given.place);
    let data = near && unchanged && given.source == Source::Given && given.conditions.is_empty();
    // n = 2, then n = 3: a letter alone may run through values.
    let member = !head.lower.is_empty() || head.arguments.is_some();
    (claimed && constant && data && member).then(|| {
        let value = write::text(&failure.left.to_expr());
        format!("line {} gives it the value {value}", given.line)
    })
}

/// The warning that a name is given another meaning than everybody gives it.
pub fn not_usual(head: &Head, counterexample: Option<String>) -> String {
    let shown = counterexample.map_or(String::new(), |text| format!(": {text}"));
    format!("this differs from the usual meaning of {}{shown}", head.base)
}

/// What a failing relation is, before anything raises a doubt.
pub fn decide(
    checker: &Checker,
    tally: &Tally,
    outcomes: &Outcomes,
    chain: &Chain,
    at: usize,
    statement: &Statement,
    head: Option<&Head>,
) -> Decision {
    let first = at == 0;
    let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
    let refuted = |failure: Failure| {
        let reasons = reasons(&failure, tally);
        Decision::Refuted { failure: Box::new(failure), reasons }
    };
    if let Some(reason) = doubts::of_meaning(checker, tally, chain, at, statement) {
        return Decision::Open(reason);
    }
    let number = |side: &Expr| bases(side).is_empty();
    if let Some(index) = loose_index(left, right, &chain.conditions) {
        let reason = format!("the index {index} occurs on one side only, and nothing says what it is");
        return Decision::Loose(reason);
    }
    // The hypotheses say what the left side is.
    let inner = tally.fails.iter().find(|failure| failure.inner).or(tally.fails.first());
    let asserted = statement.role != Some(Role::Introduced);
    // c(t) = a (1 - t) + b t, then c(t) = q_1 (1 - t) + q_2 t: it says what a and b are here.
    if inner.is_some_and(renames_its_letters) {
        return Decision::Condition("it may say what its letters stand for here".to_owned());
    }
    if let (true, Some(failure)) =
        (asserted && tally.determined > 0 && tally.determined + tally.beyond == tally.fails.len(), inner)
    {
        return refuted(failure.clone());
    }
    // d_1^2, where the page says what d_i^k is, but not how that leads to this one
    let unresolved =
        tally.fails.iter().flat_map(|failure| [&failure.left, &failure.right]).find_map(|value| {
            compare::symbols(value).into_iter().find(|symbol| {
                !symbol.upper().is_empty()
                    && checker.context.visible(symbol.base(), &statement.place).any(
                        |(_, definition, near)| {
                            near && definition.head.arguments.is_none()
                                && definition.head.upper.len() == symbol.upper().len()
                        },
                    )
            })
        });
    if let Some(symbol) = unresolved {
        return Decision::Open(format!("what {symbol} is does not follow from the definitions here"));
    }
    // I(m, n) for indices m and n may be anything.
    let of_integers = |side: &Expr| {
        let mut found = false;
        walk(side, &mut |part| {
            if let Kind::Apply(callee, groups) = &part.kind
                && Head::of(callee).is_some_and(|head| {
                    tally.record.unknown.contains(&head.base) && !tally.record.paired.contains(&head.base)
                })
            {
                let inside: BTreeSet<String> = groups.iter().flatten().flat_map(bases).collect();
                found |= !inside.is_empty() && inside.iter().all(|name| is_index_letter(name));
            }
        });
        found
    };
    if of_integers(left) || of_integers(right) {
        return Decision::Open("it needs to be known what a function of integers is".to_owned());
    }
    match checker.recursion(left, right, &statement.place) {
        Some(Some(own)) if first => return Decision::Recursion(Box::new(own)),
        Some(own) => {
            let base = own.or_else(|| Head::of(left)).map_or(String::new(), |head| head.base);
            return Decision::Open(format!("it may say what the other {base} are"));
        }
        None => {}
    }
    let inequality = matches!(chain.relations[at].0, Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge);
    let Some(failure) = best_failure(tally, outcomes, chain) else {
        let reason = format!(
            "exact for {} of {} instances tried; is it meant for a part of the range?",
            tally.holds,
            tally.holds + tally.fails.len()
        );
        return Decision::Open(reason);
    };
    // Something holds for functions of degree at most 1 only: it says that they are affine.
    let degrees = tally.fails.iter().filter_map(|failure| failure.degree).min();
    if outcomes.degrees && tally.holds > 0 && degrees.is_some_and(|least| least == 2) {
        return Decision::Open("true for functions of degree at most 1 only".to_owned());
    }
    // n is not said here: true for one degree, as in an example for n = 3.
    if outcomes.degrees && outcomes.integers.is_empty() && tally.holds > 0 {
        let failed: BTreeSet<usize> = tally.fails.iter().filter_map(|failure| failure.degree).collect();
        if (1..=4).any(|degree| !failed.contains(&degree)) {
            return Decision::Open("true for some degrees only: which one is meant?".to_owned());
        }
    }
    let claimed = statement.role == Some(Role::Claimed);
    let standard = is_standard(head);
    // What words introduced is not introduced anew by what is claimed of it.
    let spoken = head.cloned().or_else(|| Head::of(left).filter(|_| first)).is_some_and(|head| {
        let valued = || {
            let object = checker.context.object(&head, &statement.place);
            claimed && object.is_some_and(|declared| declared.object.has_values())
        };
        checker.is_determined(&head, &statement.place) || valued()
    });
    let written = head;
    let head = head.filter(|_| !spoken);
    // Both sides are made of the same points.
    let same = {
        let symbols = visible(&failure.left);
        symbols == visible(&failure.right) && symbols.iter().any(|symbol| !symbol.is_plain())
    };
    if let Some(head) = head
        && first
    {
        let own: BTreeSet<String> = bases(right);
        let property = own.contains(&head.base) || is_constant(&failure.right);
        // B_i^n on an interval [a, b] of the page is its own; B_1^3 alone may be that of x.
        let of_another =
            |symbol: &Symbol| is_variable(symbol.base()) && !compare::symbols(&failure.left).contains(symbol);
        let parameters = compare::symbols(&failure.right).iter().any(|symbol| {
            let name = symbol.base();
            let foreign = !bases(left).contains(name) && bases(right).contains(name);
            symbol.is_plain() && foreign && (head.arguments.is_some() || of_another(symbol))
        });
        if standard && !property && parameters {
            return Decision::Redefinition(None);
        }
        if standard && !property {
            // B_i^n = … that differs from what everybody calls so.
            return Decision::Redefinition(Some(not_usual(head, counterexample(&failure))));
        }
        // Let P(t) = t; for P(t) = t^2 …: given anew, by a formula in its argument.
        let variables: BTreeSet<String> = head.flat().into_iter().flat_map(bases).collect();
        let closed = !variables.is_empty() && own.is_subset(&variables);
        if statement.role == Some(Role::Introduced) && !standard && closed {
            return Decision::Redefinition(None);
        }
        // For F(t) = t …, in general for F(t) = t^k …
        let example = |definition: &Definition| matches!(&definition.body, Body::Formula(body) if integer_names(body).is_empty());
        let mut known = checker.context.visible(&head.base, &statement.place).peekable();
        if !claimed
            && !standard
            && !integer_names(right).is_empty()
            && known.peek().is_some()
            && known.all(|(_, definition, _)| example(definition))
        {
            return Decision::Redefinition(None);
        }
        let of_family = || {
            let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
            !head.lower.is_empty()
                && head.lower.iter().all(number)
                && checker.context.visible(&head.base, &statement.place).any(|(_, definition, near)| {
                    near && (claimed || definition.place.group == statement.place.group)
                        && definition.head.lower.len() == head.lower.len()
                        && definition.head.upper.len() == head.upper.len()
                        && !definition.head.lower.iter().any(number)
                })
        };
        let again = checker.context.visible(&head.base, &statement.place).any(|(_, definition, _)| {
            definition.head.flat().len() == head.flat().len()
                && definition.head.lower.len() == head.lower.len()
                && definition.head.upper.len() == head.upper.len()
        });
        // c_3 = 5, after c_i = …, where all that this is made of is known.
        let constant = is_constant(&failure.left) && is_constant(&failure.right);
        let member =
            (constant || is_constant(&failure.right) && failure.differs_by_a_number()) && of_family();
        if member || claimed && is_computed(checker, head, statement, &failure) {
            return refuted(failure);
        }
        // n = 2, a_k = k^2: a name that is no function gets a new value, unless it has one in the same symbols.
        // A = f(a, b, c), then A = P_1 + …: a second formula in the same letters says the same.
        let alike = statement.role != Some(Role::Introduced)
            && compare::in_the_same_symbols(&failure.left, &failure.right)
            && checker.is_covered(head, &statement.place);
        let value = head.arguments.is_none()
            && !(same && head.lower.is_empty())
            && !alike
            && (head.lower.is_empty() && is_constant(&failure.right) || again)
            && !own.contains(&head.base);
        if value && !standard {
            return Decision::Redefinition(contradiction(checker, head, chain, statement, &failure));
        }
        let of_capital = own.contains(&crate::judge::written::names::capital_of(&head.base))
            || statement.curve().is_some();
        if statement.role == Some(Role::Introduced)
            && again
            && !of_capital
            && !standard
            && !own.contains(&head.base)
        {
            return Decision::Redefinition(None);
        }
    }
    if let Some(head) = head
        && first
        && !standard
    {
        // A second definition of a name: a claim only where the first one is at hand.
        let defined = checker.context.visible(&head.base, &statement.place).find(|(_, definition, near)| {
            *near && definition.head.arguments.is_some() == head.arguments.is_some()
        });
        let elsewhere = defined.is_none()
            && checker.context.visible(&head.base, &statement.place).any(|(_, definition, _)| {
                definition.head.flat().len() == head.flat().len()
                    && definition.head.lower.len() == head.lower.len()
                    && definition.head.arguments.is_some() == head.arguments.is_some()
            });
        let of_capital = bases(right).contains(&crate::judge::written::names::capital_of(&head.base))
            || statement.curve().is_some();
        // A recursion that differs from an earlier one defines the family anew.
        let closed = checker.context.visible(&head.base, &statement.place).any(|(_, definition, near)| {
            near && definition.head.lower.len() == head.lower.len()
                && definition.head.upper.len() == head.upper.len()
                && matches!(&definition.body, Body::Formula(body) if !calls(body, &head.base))
        });
        let recursion = !head.lower.is_empty() && calls(right, &head.base) && !(claimed && closed);
        if elsewhere && !of_capital || recursion {
            return Decision::Redefinition(None);
        }
        // p(t) = 2 B_1^2(t) + B_2^2(t), after p(t) = t^2 + …: the same in another basis
        let another_basis = asserted
            && !tally.record.standard.is_empty()
            && head.arguments.is_some()
            && defined
                .as_ref()
                .is_some_and(|(number, ..)| tally.record.definitions.iter().any(|(used, _)| used == number))
            && are_of_parameters(&failure);
        if let Some((_, definition, _)) = defined
            && !another_basis
            && !of_capital
            && !(same && head.arguments.is_none())
            && !bases(right).contains(&head.base)
            && definition.place.group != statement.place.group
        {
            return Decision::Redefinition(None);
        }
    }
    let (sl, sr) = (visible(&failure.left), visible(&failure.right));
    // b_5 = 4 b_1 - …, where nothing determines b_5
    let itself = match &failure.left {
        Value::Scalar(own) => match own.variables().as_slice() {
            [only] if !only.is_plain() && !sr.contains(only) => {
                *own == Fraction::from(MultiPoly::symbol(only.clone()))
            }
            _ => false,
        },
        _ => false,
    };
    if first && itself && tally.determined == 0 && Head::of(left).is_some_and(|head| head.arguments.is_none())
    {
        return missing_or_redefinition(head, first, "nothing says what this point is");
    }
    // f(t, t, 0) = t^2 - 4t said what c_0, c_1, c_2 are, and not what c_3 is.
    let in_part = tally
        .record
        .definitions
        .iter()
        .any(|(number, _)| matches!(checker.context.definitions[*number].body, Body::Value(_)));
    let coefficient = |value: &Value| compare::symbols(value).into_iter().find(is_coefficient);
    if let (true, Some(symbol), None) | (true, None, Some(symbol)) =
        (in_part, coefficient(&failure.left), coefficient(&failure.right))
    {
        return Decision::Condition(format!("what {symbol} is is not said"));
    }
    // b_{2,0} beside b_{2,0,0} is a misreading.
    let others = |a: &Symbol| {
        sr.iter().any(|b| {
            a.base() == b.base() && !a.is_plain() && !b.is_plain() && a.indices().len() != b.indices().len()
        })
    };
    if sl.iter().any(others) {
        return Decision::Open("the members of a family have different numbers of indices".to_owned());
    }
    // x = x + 1 has no solution.
    let apart = || match (&failure.left, &failure.right) {
        (Value::Scalar(a), Value::Scalar(b)) => a.minus(b).as_rational().is_some(),
        _ => false,
    };
    if !sl.is_empty() && sl == sr && matches!(chain.relations[at].0, Rel::Eq) && apart() {
        return refuted(failure);
    }
    // Numbers are not to be solved for; f(1, 3, 3) is one where F(t) = 2t^3 + 1.
    let numbers = is_constant(&failure.left) && is_constant(&failure.right);
    let paired = tally.record.unknown.is_subset(&tally.record.paired);
    if sl.is_empty() && sr.is_empty() && (tally.record.unknown.is_empty() || numbers && paired) {
        return refuted(failure);
    }
    // (τ - t_2)/(t_4 - t_2) = 3/4: which numbers t_2 and t_4 are is not said.
    let member = |symbol: &&Symbol| matches!(symbol.indices(), [Index::Number(_), ..]);
    let constant = sl.is_empty() && number(left) || sr.is_empty() && number(right);
    if let (true, Some(symbol)) = (constant, sl.union(&sr).find(member)) {
        return Decision::Condition(format!("what {symbol} is is not said"));
    }
    // Always (1 - t)^2 = 1: no equation to be solved for t.
    let variable = |symbol: &Symbol| symbol.is_plain() && is_variable(symbol.base());
    let plain = tally.record.unknown.is_empty() && tally.record.definitions.is_empty();
    if chain.universal && plain && sl.union(&sr).all(variable) {
        return refuted(failure);
    }
    // Δ as a name, not as an operator, has no meaning.
    let named = |value: &Value| compare::symbols(value).iter().any(|symbol| symbol.base() == "Delta");
    let differences = [left, right].iter().any(|side| bases(side).contains("Delta"))
        && !named(&failure.left)
        && !named(&failure.right);
    let known = differences || !tally.record.definitions.is_empty() || !tally.record.standard.is_empty();
    let unknown: BTreeSet<&String> = tally.record.unknown.iter().collect();
    let unpaired: Vec<&&String> =
        unknown.iter().filter(|name| !tally.record.paired.contains(name.as_str())).collect();
    // h(t_1, t_2) = …, where words say that h is the polar form of FG, for whatever F and G.
    let generic = |value: &Value| compare::symbols(value).iter().any(is_coefficient);
    let from_right = || {
        Head::of(right)
            .is_some_and(|own| own.arguments.is_some() && checker.is_determined(&own, &statement.place))
    };
    if (spoken && first || from_right()) && asserted && generic(&failure.left) && generic(&failure.right) {
        return refuted(failure);
    }
    // Divided differences of functions, whatever these are
    let of_any = !sl.is_empty() && sl == sr && has_divided_differences(&[left, right]);
    if unknown.len() > 1 && !of_any {
        return Decision::Condition(format!(
            "a condition on {}",
            unknown.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(" and ")
        ));
    }
    let sums = has_structure(left) || has_structure(right);
    if !unpaired.is_empty() {
        let name = unpaired[0].as_str();
        let bare = match &left.kind {
            Kind::Apply(callee, groups) => {
                Head::of(callee).is_some_and(|head| head.base == name)
                    && groups.iter().flatten().all(|argument| matches!(argument.kind, Kind::Name(_)))
            }
            _ => false,
        };
        let identity = bare && sums && calls(right, name);
        // "Let F be biaffine. Then F(a + b, c) = F(a, c) + F(b, c)": for whatever F of the class
        let of_class = claimed
            && generic(&failure.left)
            && generic(&failure.right)
            && checker.context.object_of_a_class(name, &statement.place).is_some();
        if !(identity || of_class || of_any) {
            return Decision::Condition(format!(
                "a condition on {name}, or it needs to be known what {name} is"
            ));
        }
        return refuted(failure);
    } else if !unknown.is_empty() {
        // F and its polar form: both sides must speak of them, perhaps by names for values.
        if !(generic(&failure.left) && generic(&failure.right)) {
            return Decision::Condition(
                "a condition on the polar form, or a definition of its points".to_owned(),
            );
        }
        let single = |side: &Expr| bare_values(side) || Head::of(side).is_some_and(|h| h.arguments.is_none());
        if single(left) && single(right) {
            return Decision::Condition("a condition on the polar form".to_owned());
        }
    }
    if inequality {
        return refuted(failure);
    }
    // Other members of one family on each side, of which nothing that was used speaks: a condition on them.
    let spoken_of = |base: &str| {
        let numbers = tally.record.definitions.iter().map(|(number, _)| *number);
        let mut bodies = numbers.map(|number| &checker.context.definitions[number]);
        !tally.record.standard.is_empty()
            || bodies.any(|definition| {
                definition.head.base == base
                    || matches!(&definition.body, Body::Formula(body) if bases(body).contains(base))
            })
    };
    let only = |here: &BTreeSet<Symbol>, there: &BTreeSet<Symbol>, base: &str| {
        here.difference(there).any(|symbol| symbol.base() == base && !symbol.is_plain())
    };
    let open = sl.iter().map(Symbol::base).find(|base| {
        only(&sl, &sr, base) && only(&sr, &sl, base) && bases(left).contains(*base) && !spoken_of(base)
    });
    if let (Some(base), true) = (open, head.is_none()) {
        return Decision::Condition(format!("a condition on {base}"));
    }
    // Which symbols the sides speak of.
    let common: Vec<&Symbol> = sl.intersection(&sr).collect();
    if !known && unknown.is_empty() {
        let numbers = sl.is_empty() && sr.is_empty();
        let same = sl == sr;
        let expansion =
            at > 0 && has_structure(left) && has_structure(right) && (sl.is_subset(&sr) || sr.is_subset(&sl));
        let family = same && !outcomes.integers.is_empty() && (has_structure(left) || has_structure(right));
        let both = has_structure(left) && has_structure(right);
        let one = has_structure(left) || has_structure(right);
        let identity = claimed && (same && one || both && (sl.is_subset(&sr) || sr.is_subset(&sl)));
        if numbers || expansion || family || identity || (same && (at > 0 || degrees_agree(&failure))) {
            return refuted(failure);
        }
        return Decision::Condition(MEANINGLESS.to_owned());
    }
    let letters = |symbols: &BTreeSet<Symbol>| -> BTreeSet<String> {
        symbols.iter().map(|symbol| symbol.base().to_owned()).collect()
    };
    let (bl, br) = (letters(&sl), letters(&sr));
    let subset = sr.is_subset(&sl) || sl.is_subset(&sr) || br.is_subset(&bl) || bl.is_subset(&br);
    if !subset {
        return missing_or_redefinition(head, first, "names without a meaning occur on one side only");
    }
    let extra: Vec<&Symbol> = sr
        .difference(&sl)
        .filter(|symbol| !bl.contains(symbol.base()))
        .filter(|symbol| !(claimed && checker.is_restricted(symbol.base(), &statement.place)))
        .collect();
    if !extra.is_empty() && unknown.is_empty() && !standard {
        let names: Vec<String> = extra.iter().map(|symbol| symbol.to_string()).collect();
        // "The Bernstein polynomials over [a, b] are b_i^n(t) = …": the formula says more than the words.
        let head = written.filter(|_| !claimed);
        return missing_or_redefinition(head, first, &format!("{} has no meaning here", names.join(", ")));
    }
    // c_2 - 2 c_1 + c_0 = …, where the page says no more of the c_i: a condition on them
    let unsaid = sl.difference(&sr).find(|symbol| !symbol.is_plain() && !br.contains(symbol.base()));
    if let (Some(symbol), None, true, false) = (unsaid, head, first, claimed) {
        return Decision::Condition(format!("a condition on {}", symbol.base()));
    }
    if extra.iter().any(|symbol| symbol.is_plain()) && !standard && unknown.is_empty() {
        return missing_or_redefinition(head, first, "a name without a meaning occurs on the right");
    }
    let constant =
        |symbols: &BTreeSet<Symbol>, other: &BTreeSet<Symbol>| symbols.is_empty() && !other.is_empty();
    let only_standard = tally.record.definitions.is_empty() && unknown.is_empty();
    // N_{i,p}(u) = 0 for u outside of an interval: for all i, p and u there
    let for_all = !outcomes.integers.is_empty() && chain.conditions.iter().any(is_range);
    if (constant(&sr, &sl) || constant(&sl, &sr))
        && !only_standard
        && !for_all
        && tally.record.unknown.is_empty()
        && at == 0
    {
        let curve = statement.curve().is_some() && head.is_some();
        if !curve && !claimed {
            return missing_or_redefinition(head, first, "an equation to be solved, or a condition");
        }
    }
    if bare_values(left) && bare_values(right) && at == 0 {
        return Decision::Condition("a condition on the values of a function".to_owned());
    }
    // Definitions of other sections count only if the formula speaks of their coefficients.
    let far: Vec<usize> =
        tally.record.definitions.iter().filter(|(_, near)| !near).map(|(number, _)| *number).collect();
    if !far.is_empty() {
        let written: BTreeSet<String> = bases(left);
        let linked = common.iter().any(|symbol| {
            !symbol.indices().is_empty() && !written.contains(symbol.base()) && !is_argument(symbol, left)
        });
        if !linked {
            let line = checker.context.definitions[far[0]].line;
            let reason = format!("it contradicts line {line}, which stands in another section");
            return match missing_or_redefinition(head, first, &reason) {
                Decision::Condition(reason) => Decision::Far(Box::new(failure), reason),
                other => other,
            };
        }
    }
    refuted(failure)
}

pub fn missing_or_redefinition(head: Option<&Head>, first: bool, reason: &str) -> Decision {
    if head.is_some() && first && !is_standard(head) {
        Decision::Redefinition(None)
    } else {
        Decision::Condition(reason.to_owned())
    }
}

/// "Let m = (a + b)/2, where a = 2 and b = 4. Then m = 4": a name whose formula gives a number with what is known.
fn is_computed(checker: &Checker, head: &Head, statement: &Statement, failure: &Failure) -> bool {
    let plain = head.arguments.is_none() && head.lower.is_empty() && head.upper.is_empty();
    let constant = [&failure.left, &failure.right].iter().all(|value| compare::symbols(value).is_empty());
    let mut known = checker.context.visible(&head.base, &statement.place);
    plain
        && constant
        && known.next().is_some_and(|(_, own, near)| {
            let made = match &own.body {
                Body::Formula(body) => !bases(body).is_empty(),
                Body::Value(_) => false,
            };
            near && made && !statement.place.may_change(&own.place)
        })
}

fn is_constant(value: &Value) -> bool {
    value.as_rational().is_some()
}
