//! What speaks for a relation that fails being wrong.
//!
//! A misreading makes any formula false, and leaves it far from every truth. A slip leaves it one small change away
//! from one. So a relation is wrong if a small edit of it is true, or if it speaks of what the field or the page
//! determines: Bernstein polynomials, B-splines, the polar form of a given polynomial. For everything else that fails
//! the likelier cause is that it was not read as it was meant.

use std::collections::BTreeSet;

use super::Suspect;
use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::instances::hypotheses::is_coefficient;
use crate::judge::page::context::{Body, Definition, is_variable};
use crate::judge::page::finding::Evidence;
use crate::judge::page::object::{Declared, Sort};
use crate::judge::page::statement::Role;
use crate::judge::page::topic::Topic;
use crate::judge::repair::Repair;
use crate::judge::values::compare;
use crate::judge::written::features::has_structure;
use crate::judge::written::names::{Head, bases, calls, contains, is_index_letter, is_standard};
use crate::language::lexicon::words::is_function_word;
use crate::language::lexicon::{families, roles};
use crate::language::value::Value;
use crate::math::poly::Symbol;

impl Suspect<'_> {
    /// What shows that it is wrong, with the repair found. Without any of it the relation stays open.
    pub(in crate::judge) fn evidence(&self, repair: Option<&Repair>) -> Vec<Evidence> {
        let near = repair.is_some_and(|repair| repair.near)
            && (self.claimed()
                || self.tally.determined > 0
                || self.is_near_its_meaning() && (self.says_much() || self.means_one_thing()));
        let shown = [
            (Evidence::Near, near),
            (Evidence::ForAll, self.chain.universal && self.claimed()),
            (
                Evidence::Field,
                self.continues_the_field() && !self.may_be_a_condition() && !self.is_of_one_piece(),
            ),
            (Evidence::Closed, self.is_closed()),
            (Evidence::Calculation, self.is_calculation()),
            (Evidence::Value, self.is_value() || self.is_calculated_here()),
            (Evidence::Expansion, self.is_expansion()),
            (Evidence::Terms, self.agrees_in_part()),
            (Evidence::Names, self.is_of_a_described_point()),
        ];
        let data = self.are_data();
        let counts = |evidence: &Evidence| !data || *evidence == Evidence::ForAll;
        shown.into_iter().filter(|(e, holds)| *holds && counts(e)).map(|(evidence, _)| evidence).collect()
    }

    /// Whether it gives another point than the one that words describe: made of the same control points, or another number
    /// for a control point of a curve that the page gives.
    fn is_of_a_described_point(&self) -> bool {
        let [left, _] = self.sides();
        let told = Head::of(left).and_then(|head| self.checker.context.object(&head, &self.statement.place));
        let Some(Declared { object, .. }) = told else { return false };
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        match object.sort {
            Sort::Symbols => !object.values.is_empty() && left.len() > 1 && left == right,
            Sort::ControlPoints => {
                let given = object.of.is_some() && !left.iter().any(is_coefficient);
                given && self.statement.role.is_none() && left == right && left.len() != 1
            }
            _ => false,
        }
    }

    /// Whether one side is a value of a polynomial that may be any, and the other one a number: f(1, 1) = 5 says something
    /// of it.
    fn are_data(&self) -> bool {
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        let (other, value) = if left.is_empty() { (left, right) } else { (right, left) };
        self.tally.determined == 0 && other.is_empty() && value.iter().any(is_coefficient)
    }

    /// Whether the rest of the page can show that it is wrong: it gives a value of a function, or calculates with
    /// numbers that have names, and is no condition.
    pub(in crate::judge) fn can_be_confirmed(&self) -> bool {
        let [left, _] = self.sides();
        let calculated = self.symbols().is_empty() && Head::of(left).is_none();
        let value = matches!(left.kind, Kind::Apply(..));
        self.is_equation() && (calculated || value) && !self.may_be_a_condition()
    }

    /// Whether the rest of the page can show that it is a slip, where next to it there is a truth.
    pub(in crate::judge) fn is_claim_beside_truth(&self) -> bool {
        self.is_equation() && self.says_much() && !self.names_something() && !self.may_be_a_condition()
    }

    /// Whether it is a slip whatever it speaks of: it says much, and next to it there is a truth.
    pub(in crate::judge) fn is_slip(&self, repair: impl FnOnce() -> Option<Repair>) -> bool {
        // "Let b_i = …" gives a name another value, however near that is.
        self.statement.role != Some(Role::Introduced)
            && self.says_much()
            && (self.is_near_its_meaning() || self.claimed() && self.uses_what_is_near())
            && !self.may_be_a_condition()
            && self.doubt_of_form().is_none()
            && repair().is_some_and(|repair| repair.near)
    }

    /// Whether what it uses was defined close to it, and it gives no name a value.
    fn is_near_its_meaning(&self) -> bool {
        self.uses_what_is_near() && !self.names_something()
    }

    fn uses_what_is_near(&self) -> bool {
        self.tally.record.definitions.iter().all(|(_, near)| *near)
    }

    /// Whether no name in it has a meaning, or declarations and queries give all that it uses.
    fn means_one_thing(&self) -> bool {
        self.tally.record.unknown.is_empty() && self.used().all(|definition| !definition.source.is_text())
    }

    /// Whether it calculates so much that a small edit does not make it true by chance: next to f(s) = a - b there
    /// is always something true.
    fn says_much(&self) -> bool {
        let calculations: usize = self.sides().into_iter().map(calculations).sum();
        self.is_equation() && calculations > 2
    }

    /// Whether its left side is a name, or a function of its variables, that may be given a value here: t = t_5,
    /// after f(x) = x^3 also f(x) = x^2.
    fn names_something(&self) -> bool {
        let [left, right] = self.sides();
        let Some(head) = Head::of(left).filter(|head| self.at == 0 && head.notation().is_none()) else {
            return false;
        };
        // s = x(1/2), and in the same paragraph another formula in the same letters
        let given = self.used().any(|definition| {
            definition.head.base == head.base
                && definition.head.arguments.is_none() == head.arguments.is_none()
                && definition.place.group == self.statement.place.group
        });
        let covered = given && self.checker.is_covered(&head, &self.statement.place);
        if covered && compare::in_the_same_symbols(&self.failure.left, &self.failure.right) {
            return false;
        }
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        match &head.arguments {
            None => head.upper.is_empty() && (head.lower.is_empty() || head.lower.iter().any(number)),
            Some(_) => {
                let own: BTreeSet<String> = head.flat().into_iter().flat_map(bases).collect();
                let variables = head.flat().iter().all(|argument| matches!(argument.kind, Kind::Name(_)));
                variables && !has_structure(right) && bases(right).is_subset(&own)
            }
        }
    }

    /// Names on one side only, or other members of a family on each side, of which nothing is said: what they are may
    /// make it true.
    fn may_be_a_condition(&self) -> bool {
        if self.are_data() {
            return true;
        }
        if self.tally.determined > 0 || self.statement.curve().is_some() {
            return false;
        }
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        let place = &self.statement.place;
        let plain =
            |name: &str| left.iter().chain(&right).all(|symbol| symbol.base() != name || symbol.is_plain());
        // The ends a and b of the interval that the formula for C has, in C'(a)
        let of_formula = |name: &str| {
            let inside = |definition: &Definition| matches!(&definition.body, Body::Formula(body) if bases(body).contains(name));
            self.used().any(inside)
        };
        let open = |name: &str| {
            let known = plain(name) && is_variable(name)
                || of_formula(name)
                || name.starts_with('[')
                || self.is_spoken_of(name)
                || self.checker.is_restricted(name, place)
                || self.checker.is_constrained(name, place);
            !known
        };
        let letters = |symbols: &[Symbol]| -> BTreeSet<String> {
            symbols.iter().map(|s| s.base().to_owned()).collect()
        };
        // The new points P_i^{(1)} beside the P_i
        let marked = |symbols: &[Symbol]| -> BTreeSet<String> {
            symbols.iter().filter(|s| !s.upper().is_empty()).map(|s| s.base().to_owned()).collect()
        };
        let defined = |name: &String| {
            let mut visible = self.checker.context.visible(name, place);
            visible.any(|(_, definition, _)| !definition.head.upper.is_empty())
        };
        if marked(&left).symmetric_difference(&marked(&right)).any(|name| !defined(name)) {
            return true;
        }
        let (own, others) = (letters(&left), letters(&right));
        // ξ in f^{(n)}(ξ), somewhere between the nodes
        let [left, right] = self.sides();
        let place_of_mean = |name: &String| {
            let integer = self.failure.integers.iter().any(|(own, _)| own == name) || is_index_letter(name);
            let unknown = |base: &str| self.tally.record.unknown.contains(base);
            !integer && self.is_only_argument(name, &unknown) && open(name)
        };
        let alone = own.symmetric_difference(&others).any(|name| open(name))
            || bases(left).symmetric_difference(&bases(right)).any(place_of_mean);
        // S'_i(x_i) = S'_{i-1}(x_i), B_{i,n}(u) = 0
        let [one, other] = self.sides();
        let call = |side: &Expr| match &side.kind {
            Kind::Derivative { body: Some(body), .. } => Head::of(body),
            _ => {
                let primed = matches!(side.kind, Kind::Prime(..));
                Head::of(side).filter(|head| head.arguments.is_some() || primed)
            }
        };
        let same = match (call(one), call(other)) {
            (Some(a), Some(b)) => {
                let family = a.notation().is_none() && !a.lower.is_empty();
                family && a.base == b.base && a.lower.len() == b.lower.len()
            }
            (Some(head), None) => {
                matches!(other.kind, Kind::Number(_))
                    && !self.failure.integers.is_empty()
                    && !head.lower.is_empty()
            }
            _ => false,
        };
        // dP_i/dx = dP_{i+1}/dx, where two pieces meet
        let derived = |side: &Expr| matches!(side.kind, Kind::Derivative { .. });
        let joined = same && derived(one) && derived(other);
        let family = joined || same && !self.claimed() && self.chain.conditions.is_empty();
        alone || family
    }

    /// Whether a name stands only as the argument of such functions.
    pub(super) fn is_only_argument(&self, name: &str, of: &dyn Fn(&str) -> bool) -> bool {
        let (mut within, mut all) = (0, 0);
        self.any(&mut |part| {
            match &part.kind {
                Kind::Apply(callee, groups) if bases(callee).iter().any(|base| of(base)) => {
                    within += groups.iter().flatten().filter(|argument| is_name(argument, name)).count();
                }
                _ => all += usize::from(is_name(part, name)),
            }
            false
        });
        within > 0 && within == all
    }

    /// Σ_{i=j-k}^j P_i N_{i,k}(t), the splines that are not 0 between two knots: true between these two. Where t is said
    /// to lie in [t_j, t_{j+1}) it is tried there.
    fn is_of_one_piece(&self) -> bool {
        let free = |bound: &Expr| {
            let names = bases(bound);
            self.failure.integers.iter().any(|(name, _)| names.contains(name) && !roles::is_size(name))
        };
        let between = |condition: &Expr| {
            let Kind::Chain(_, links) = &condition.kind else { return false };
            let ends =
                links.iter().filter(|link| link.rel == Rel::In).filter_map(|link| interval(&link.expr));
            ends.map(|([from, _], _)| from)
                .any(|from| Head::of(from).is_some_and(|head| head.lower.iter().any(&free)))
        };
        let place = &self.statement.place;
        let known =
            self.checker.context.conditions.iter().filter(|known| place.knows(&known.place, known.assumed));
        let mut said = self.chain.conditions.iter().chain(known.map(|known| &known.expr));
        self.failure.around.is_some()
            && !said.any(between)
            && self.any(&mut |part| match &part.kind {
                Kind::Big { lower, upper: Some(upper), .. } => free(upper) && lower.iter().any(free),
                _ => false,
            })
    }

    /// Whether it, or what is equal to its left side by the links before it, is of the field: in Σ i B_i^n(t) = nt = n(1 - t)
    /// the last link says what Σ i B_i^n(t) is.
    fn continues_the_field(&self) -> bool {
        let mut at = self.at;
        let mut earlier = self.earlier;
        if self.is_of_the_field() {
            return true;
        }
        while let [before @ .., tally] = earlier {
            at -= 1;
            let equal = matches!(self.chain.relations[at].0, Rel::Eq);
            if !equal || tally.holds == 0 || !tally.fails.is_empty() || !self.is_equation() {
                return false;
            }
            let link = Suspect { tally, earlier: before, at, ..*self };
            if link.is_of_the_field() {
                return true;
            }
            earlier = before;
        }
        false
    }

    /// Whether it speaks of what has a meaning for everybody here, or of all members of a family of functions that
    /// the page defines.
    fn is_of_the_field(&self) -> bool {
        let record = &self.tally.record;
        let family = |definition: &Definition| {
            let head = &definition.head;
            head.arguments.is_some()
                && !(head.lower.is_empty() && head.upper.is_empty())
                && !head.lower.iter().chain(&head.upper).all(|index| matches!(index.kind, Kind::Number(_)))
        };
        // N by its recursion is what everybody calls so; numbers N_{i,k} that are counted are others.
        let splines = self.statement.topics.has(Topic::Spline);
        let known = |definition: &Definition| {
            let function = splines || definition.head.arguments.is_some();
            function && definition.is_recursive() && families::is_family(&definition.head.base)
        };
        // f[0, 1] = 3, for the f of another exercise
        let here = &self.statement.place;
        let elsewhere = |definition: &Definition| {
            let example = !here.blocks.is_empty() && definition.place.blocks == here.blocks;
            definition.place.group != here.group && !example
        };
        if self.are_numbers() && !self.claimed() && !self.used().any(known) && self.used().any(elsewhere) {
            return false;
        }
        let told = self.claimed() || self.sides().into_iter().any(has_structure);
        // Any function of a class, or the one in it that data determine
        let of_class = |name: &String| {
            let object = self.checker.context.object_of_a_class(name, here);
            object.is_some_and(|object| self.tally.determined > 0 || object.sort != Sort::Polynomial)
        };
        !record.standard.is_empty()
            || self.used().any(known)
            || (self.claimed() || self.statement.concludes) && self.is_determined_here()
            || !record.paired.is_empty()
            || self.claimed() && !record.unknown.is_empty() && record.unknown.iter().all(of_class)
            || told
                && !self.failure.integers.is_empty()
                && record.unknown.is_empty()
                && self.used().any(family)
    }

    /// Whether its paragraph writes something in functions of the field that determines the member on its left side:
    /// t^2 = Σ c_i B_i^2(t), so c_1 = 1.
    fn is_determined_here(&self) -> bool {
        let [left, _] = self.sides();
        let Some(head) = Head::of(left).filter(|head| head.arguments.is_none()) else { return false };
        let place = &self.statement.place;
        self.tally.determined > 0
            && self.checker.context.conditions.iter().any(|condition| {
                condition.place.group == place.group
                    && place.knows(&condition.place, condition.assumed)
                    && bases(&condition.expr).contains(&head.base)
                    && (condition.expr.has(&is_standard) || is_identity(&condition.expr))
            })
    }

    /// Whether no name in it needs a meaning, and it is no equation: a sum or an integral in closed form, an inequality
    /// on a range.
    fn is_closed(&self) -> bool {
        let record = &self.tally.record;
        let operator = self
            .any(&mut |part| matches!(part.kind, Kind::Big { .. } | Kind::Integral { upper: Some(_), .. }));
        let whole = record.definitions.is_empty()
            && record.standard.is_empty()
            && record.unknown.is_empty()
            && record.generic.is_empty();
        let order = matches!(self.rel(), Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge);
        let ranged = order
            && self.failure.integers.iter().all(|(name, _)| {
                self.chain.conditions.iter().any(|condition| bases(condition).contains(name))
            });
        let ranged = ranged && !(self.failure.integers.is_empty() && self.are_numbers());
        whole && (ranged || operator && self.failure.inner && self.symbols().iter().all(Symbol::is_plain))
    }

    /// Whether it gives the value, at numbers, of a function that its section defines: by a number, or by several
    /// parameters of the function, all of which are in its value.
    fn is_value(&self) -> bool {
        let number = |expr: &Expr| bases(expr).is_empty();
        let [left, right] = self.sides();
        let called = |side: &Expr| match &side.kind {
            Kind::Apply(callee, groups) if groups.iter().flatten().all(number) => match &callee.kind {
                Kind::Prime(function, _) => Head::of(function),
                _ => Head::of(callee),
            },
            _ => None,
        };
        let Some(head) = called(left) else { return self.is_value_of_member() };
        let place = &self.statement.place;
        // Its formula stands around an example that gives what is in it.
        let data = self.used().any(|definition| {
            let block = &definition.place.blocks;
            let own = *block == place.blocks
                || place.recalled.as_ref().is_some_and(|recalled| *block == recalled.blocks);
            !block.is_empty() && own && definition.head.base != head.base
        });
        let own = |definition: &Definition| {
            definition.head.base == head.base
                && definition.head.arguments.is_some()
                && (place.is_in_the_blocks_of(&definition.place)
                    || data && place.knows(&definition.place, definition.assumed))
        };
        let known = match self.symbols().is_empty() {
            true => number(right),
            false => {
                let (left, right) =
                    (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
                left.len() > 1 && left == right && !self.may_be_a_condition()
            }
        };
        self.is_equation() && known && self.tally.record.unknown.is_empty() && self.used().any(own)
    }

    /// Whether it claims the number that a member of a family is, which a formula for all of them and numbers give here:
    /// b_0^1 = 2 for t = 1/4, after b_i^r = (1 - t) b_i^{r-1} + t b_{i+1}^{r-1}.
    fn is_value_of_member(&self) -> bool {
        let [left, right] = self.sides();
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        let head = Head::of(left).filter(|head| head.lower.iter().chain(&head.upper).all(number));
        // T_3(x), after T_{n+1}(x) = 2x T_n(x) - T_{n-1}(x)
        let own: BTreeSet<String> = head.iter().flat_map(Head::flat).flat_map(bases).collect();
        let Some(head) = head.filter(|head| {
            let variable = |argument: &&Expr| matches!(argument.kind, Kind::Name(_));
            head.flat().iter().all(variable)
        }) else {
            return false;
        };
        if head.lower.is_empty() && head.upper.is_empty() {
            return self.is_value_of_name(&head);
        }
        let place = &self.statement.place;
        let family = |definition: &Definition| {
            definition.head.base == head.base
                && !definition.head.lower.iter().any(number)
                && (head.arguments.is_none() || definition.is_recursive())
                && place.is_in_the_blocks_of(&definition.place)
        };
        let claimed = self.claimed() || self.statement.concludes;
        let value = match head.arguments {
            None => self.failure.differs_by_a_number() && bases(right).is_empty(),
            Some(_) => {
                let left = compare::symbols(&self.failure.left);
                bases(right).is_subset(&own) && left.iter().all(|symbol| own.contains(symbol.base()))
            }
        };
        claimed && value && self.used().any(family)
    }

    /// Whether it claims another number for a name whose formula and data stand here: q = a - b, where a = 2 and b = 1.
    fn is_value_of_name(&self, head: &Head) -> bool {
        let place = &self.statement.place;
        let here = |definition: &Definition| place.is_in_the_blocks_of(&definition.place);
        let made = |definition: &Definition| {
            definition.head.base == head.base
                && matches!(&definition.body, Body::Formula(body) if !bases(body).is_empty())
        };
        self.claimed()
            && self.symbols().is_empty()
            && self.tally.record.unknown.is_empty()
            && self.used().all(here)
            && self.used().any(made)
    }

    /// Whether it claims another number for what is calculated from formulas that stand here: ∫_0^1 y(t) x'(t) dt.
    fn is_calculated_here(&self) -> bool {
        let [left, right] = self.sides();
        let place = &self.statement.place;
        let here = |definition: &Definition| place.is_in_the_blocks_of(&definition.place);
        matches!(self.statement.role, None | Some(Role::Claimed | Role::Always))
            && self.is_equation()
            && Head::of(left).is_none()
            && bases(right).is_empty()
            && self.symbols().is_empty()
            && self.tally.record.unknown.is_empty()
            && self.used().next().is_some()
            && self.used().all(here)
    }

    /// Whether it writes any function of a kind by its own values or derivatives: Taylor's formula.
    fn is_expansion(&self) -> bool {
        let [left, right] = self.sides();
        let own = |name: &String| calls(left, name) && calls(right, name);
        self.any(&mut |part| matches!(part.kind, Kind::Big { .. }))
            && self.tally.record.unknown.iter().any(own)
    }

    /// Whether it calculates with numbers, and is said to follow; or has no solution, as x = x + 1,
    /// (1 - t) + t = 0.
    fn is_calculation(&self) -> bool {
        let [left, right] = self.sides();
        let literal = |side: &Expr| matches!(side.kind, Kind::Number(_));
        let constant = |name: &String| is_function_word(name) || name == "pi";
        let numbers = self.sides().iter().all(|side| bases(side).iter().all(constant));
        // sin(π/3) = 1/2
        let angle = bases(left).contains("pi");
        let circular = contains(right, left) && !bases(left).is_empty();
        // p + q = 2, where p and q were defined right before: one apart for all that is in them
        let plain = self.claimed()
            && self.uses_what_is_near()
            && self.failure.integers.is_empty()
            && self.used().all(|definition| !definition.source.is_text());
        // k = 1^k is one apart in one instance only; "set k = k + 1" is an assignment
        let circular = circular
            && (self.failure.integers.is_empty() || !self.are_numbers())
            && self.statement.role != Some(Role::Introduced)
            && (self.claimed() || !matches!(&left.kind, Kind::Name(name) if is_index_letter(name)));
        self.rel() == Rel::Approx && numbers
            || (self.claimed() || self.chain.relations.len() > 1 || self.statement.role.is_none() && angle)
                && numbers
                && !(literal(left) && literal(right))
            || self.has_no_solution() && !numbers && (circular || plain)
    }

    /// Whether the sides are polynomials in the same names that agree in three terms and half of all.
    fn agrees_in_part(&self) -> bool {
        let (left, right) = (&self.failure.left, &self.failure.right);
        if let (Value::List(_), Value::List(_)) = (left, right) {
            return self.is_equation() && compare::agree_in_most(left, right);
        }
        let (Value::Scalar(left), Value::Scalar(right)) = (left, right) else { return false };
        let (Some(left), Some(right)) = (left.as_polynomial(), right.as_polynomial()) else { return false };
        let (common, all) = compare::common_terms(left, right);
        self.tally.record.definitions.is_empty()
            && self.tally.record.unknown.is_empty()
            && self.is_equation()
            && left.variables() == right.variables()
            && common > 2
            && 2 * common >= all
    }
}

/// q(t) = β_0 (1 - t)^2 + …: two formulas for one function of a variable.
fn is_identity(condition: &Expr) -> bool {
    let Kind::Chain(left, links) = &condition.kind else { return false };
    let variables = |expr: &Expr| -> BTreeSet<String> {
        bases(expr).into_iter().filter(|name| is_variable(name)).collect()
    };
    let own = variables(left);
    links.iter().all(|link| link.rel == Rel::Eq && !variables(&link.expr).is_disjoint(&own))
}

fn is_name(expr: &Expr, name: &str) -> bool {
    matches!(&expr.kind, Kind::Name(own) if own == name)
}

/// How many sums, products, powers and values of functions are calculated in it, apart from indices.
fn calculations(expr: &Expr) -> usize {
    let own = match &expr.kind {
        Kind::Subscript(..) | Kind::Upper(..) => return 0,
        Kind::Add(terms) => terms.len() - 1,
        Kind::Mul(factors) => factors.len() - 1,
        Kind::Apply(_, groups) => {
            groups.iter().flatten().any(|argument| !matches!(argument.kind, Kind::Name(_))).into()
        }
        Kind::Pow(..)
        | Kind::Div(..)
        | Kind::Big { .. }
        | Kind::Integral { .. }
        | Kind::Binomial(..)
        | Kind::Factorial(_)
        | Kind::Prime(..) => 1,
        _ => 0,
    };
    let mut all = own;
    expr.for_each_child(&mut |child| all += calculations(child));
    all
}
