//! What has to be certain before a relation is called wrong.
//!
//! A relation that fails is wrong only if every name in it has the meaning that it was given, and if it can be
//! nothing but a claim. Whatever raises a doubt about one of them keeps the verdict open: a right formula called
//! wrong is worse than a wrong one passed over.

mod notation;
mod numbers;

use std::collections::BTreeSet;

use super::check::Checker;
use super::compare;
use super::context::{Body, Definition, is_variable};
use super::features::has_divided_differences;
use super::names::{Head, bases, integer_names, is_index_letter, walk};
use super::object::Sort;
use super::statement::{Chain, Role, Statement};
use super::tally::{Failure, Tally};
use super::topic::Topic;
use crate::formula::{Expr, Kind, Rel};
use crate::language::value::Value;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

/// A relation that fails, with everything around it.
pub(super) struct Suspect<'a> {
    pub(super) checker: &'a Checker,
    pub(super) tally: &'a Tally,
    pub(super) chain: &'a Chain,
    pub(super) at: usize,
    pub(super) statement: &'a Statement,
    pub(super) failure: &'a Failure,
}

impl Suspect<'_> {
    /// Why it may not be wrong after all.
    pub(super) fn doubt(&self) -> Option<String> {
        let rules: [fn(&Self) -> Option<String>; 19] = [
            Self::rests_on_another_section,
            Self::given_twice,
            Self::unknown_function,
            Self::operator,
            Self::value_in_passing,
            Self::names_for_names,
            Self::equation_to_be_solved,
            Self::recursion_of_a_family,
            Self::matrices,
            Self::inequality_without_range,
            Self::family_of_another_kind,
            Self::rounded_or_modular,
            Self::name_on_one_side,
            Self::other_members,
            Self::brackets,
            Self::word,
            Self::alternative,
            Self::some_degrees,
            Self::members_of_an_example,
        ];
        rules.into_iter().find_map(|rule| rule(self))
    }

    fn sides(&self) -> [&Expr; 2] {
        [&self.chain.sides[self.at].expr, &self.chain.sides[self.at + 1].expr]
    }

    fn rel(&self) -> Rel {
        self.chain.relations[self.at].0
    }

    fn claimed(&self) -> bool {
        self.statement.role == Some(Role::Claimed) || self.chain.universal
    }

    fn any(&self, test: &mut dyn FnMut(&Expr) -> bool) -> bool {
        let mut found = false;
        for side in self.sides() {
            walk(side, &mut |part| found = found || test(part));
        }
        found
    }

    /// A formula of another section may have been meant for that one.
    fn rests_on_another_section(&self) -> Option<String> {
        // x(t) = Σ b_i B_i^n(t) holds for the whole chapter, f(x) = x^2 for an example of it.
        let particular = |definition: &Definition| {
            let Body::Formula(body) = &definition.body else { return true };
            let mut general = !integer_names(body).is_empty();
            walk(body, &mut |part| general |= matches!(part.kind, Kind::Subscript(..)));
            !general
        };
        let definitions = &self.checker.context.definitions;
        let mut far = self.tally.record.definitions.iter().filter(|(_, near)| !near);
        let line = far.find_map(|(number, _)| {
            let definition = &definitions[*number];
            particular(definition).then_some(definition.line)
        })?;
        Some(format!("it contradicts line {line}, which stands in another section"))
    }

    /// A function of which the page says nothing may have any property.
    fn unknown_function(&self) -> Option<String> {
        let spoken = |name: &str| {
            let small = name.to_lowercase();
            [name, small.as_str()].iter().any(|name| {
                self.checker.context.object_called(name, &self.statement.place).is_some_and(|declared| {
                    declared.object.is_function() && !matches!(declared.object.sort, Sort::Function)
                        || declared.object.sort == Sort::ControlPoints
                })
            })
        };
        // On polar forms f and F are what everybody calls so; a divided difference is one of any function.
        if self.statement.topics.has(Topic::PolarForm) || has_divided_differences(&self.sides()) {
            return None;
        }
        let unknown = self.tally.record.unknown.iter().find(|name| !spoken(name))?;
        Some(format!("what {unknown} is is not said"))
    }

    /// Whether words say what a name is.
    fn is_spoken_of(&self, name: &str) -> bool {
        self.checker.context.object_called(name, &self.statement.place).is_some()
    }

    fn used(&self) -> impl Iterator<Item = &Definition> {
        self.tally.record.definitions.iter().map(|(number, _)| &self.checker.context.definitions[*number])
    }

    /// Whether both sides are numbers.
    fn are_numbers(&self) -> bool {
        [&self.failure.left, &self.failure.right].into_iter().all(|value| value.as_rational().is_some())
    }

    fn is_equation(&self) -> bool {
        matches!(self.rel(), Rel::Eq | Rel::Equiv)
    }

    /// u_k = … in one example, and u_k = … in another: which one is meant later?
    fn given_twice(&self) -> Option<String> {
        let place = &self.statement.place;
        let alike = |a: &Head, b: &Head| {
            let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
            a.lower.len() == b.lower.len()
                && a.upper.len() == b.upper.len()
                && a.arguments.is_some() == b.arguments.is_some()
                && !a.lower.iter().chain(&b.lower).any(number)
        };
        let twice = self.used().find(|definition| {
            let head = &definition.head;
            let others = self.checker.context.visible(&head.base, place);
            let formulas = others.filter(|(_, other, near)| {
                *near && alike(head, &other.head) && !other.is_recursive() && !definition.is_recursive()
            });
            definition.place.group != place.group && !self.claimed() && formulas.count() > 1
        })?;
        Some(format!("which of its formulas {} has here is not said", twice.head.base))
    }

    /// n = 6: a value, unless it is said to follow.
    fn value_in_passing(&self) -> Option<String> {
        let head =
            Head::of(self.sides()[0]).filter(|head| head.arguments.is_none() && head.notation().is_none())?;
        let plain = head.lower.is_empty() && head.upper.is_empty();
        if self.is_equation()
            && self.at == 0
            && plain
            && self.are_numbers()
            && bases(self.sides()[1]).is_empty()
        {
            return Some("it may say what its left side is".to_owned());
        }
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        // t = b_1(t)/3 + …, A^{-1} = …: it speaks of what is known.
        let within = |a: &[Symbol], b: &[Symbol]| !a.is_empty() && a.iter().all(|symbol| b.contains(symbol));
        let family = self.used().any(|definition| definition.head.base == head.base);
        let same = within(&left, &right)
            || within(&right, &left)
            || family && !left.is_empty() && letters(&left) == letters(&right);
        let power = !head.upper.is_empty() && head.lower.is_empty();
        (self.is_equation() && self.at == 0 && !same && !power && !self.claimed())
            .then(|| "it may say what its left side is".to_owned())
    }

    /// τ_4 = t_1: names for the same thing.
    fn names_for_names(&self) -> Option<String> {
        let name = |expr: &Expr| {
            Head::of(expr).is_some_and(|head| {
                let member = head.arguments.is_none() && !head.lower.is_empty() && head.notation().is_none();
                let object = self.checker.context.object(&head, &self.statement.place);
                member && object.is_none_or(|declared| !declared.object.has_values())
            })
        };
        (self.is_equation() && self.sides().into_iter().all(name) && self.tally.determined == 0)
            .then(|| "it may say what these names stand for".to_owned())
    }

    /// P(α) = 0; x_1^2 - 4 x_1 x_2 + 1 = 0, where x_1 and x_2 were numbers in an example.
    fn equation_to_be_solved(&self) -> Option<String> {
        let zero = |expr: &Expr| matches!(&expr.kind, Kind::Number(q) if q.is_zero());
        let mut structure =
            |part: &Expr| matches!(part.kind, Kind::Apply(..) | Kind::Big { .. } | Kind::Integral { .. });
        let named = self.sides().into_iter().any(|side| !bases(side).is_empty());
        let of_example =
            self.are_numbers() && named && self.sides().into_iter().any(zero) && !self.any(&mut structure);
        // 2 x^2 = x^2 + 2, with nothing to multiply out
        let mut product = |part: &Expr| match &part.kind {
            Kind::Pow(base, _) => matches!(base.kind, Kind::Group(_)),
            Kind::Mul(factors) => factors.iter().any(|factor| matches!(factor.kind, Kind::Group(_))),
            Kind::Apply(..)
            | Kind::Big { .. }
            | Kind::Integral { .. }
            | Kind::Binomial(..)
            | Kind::Factorial(_) => true,
            _ => false,
        };
        let symbols = self.symbols();
        let of_one = symbols.len() == 1
            && symbols.iter().all(Symbol::is_plain)
            && self.at == 0
            && !self.chain.universal
            && self.tally.record.definitions.is_empty()
            && !self.is_constant_apart()
            && !self.any(&mut product);
        let free = |argument: &Expr| match &argument.kind {
            Kind::Name(name) => {
                !is_variable(name)
                    && !is_index_letter(name)
                    && !self.is_spoken_of(name)
                    && self.checker.context.visible(name, &self.statement.place).next().is_none()
            }
            _ => false,
        };
        // D(x) = 0 for a polynomial D of which no more is said
        let generic = |callee: &Expr| {
            Head::of(callee).is_some_and(|head| self.tally.record.unknown.contains(&head.base))
                && !self.claimed()
        };
        let root = |call: &Expr, value: &Expr| {
            bases(value).is_empty()
                && matches!(&call.kind, Kind::Apply(callee, groups)
                    if groups.iter().flatten().any(free) || generic(callee))
        };
        let [one, other] = self.sides();
        (self.is_equation() && (of_example || of_one || root(one, other) || root(other, one)))
            .then(|| "it may be an equation to be solved".to_owned())
    }

    /// x = x + 1 has no solution.
    fn is_constant_apart(&self) -> bool {
        match (&self.failure.left, &self.failure.right) {
            (Value::Scalar(left), Value::Scalar(right)) => left.minus(right).as_rational().is_some(),
            _ => false,
        }
    }

    /// a_{n,m} = a_{n,m-1} + a_{n-1,m-1} holds where it is meant to hold.
    fn recursion_of_a_family(&self) -> Option<String> {
        let [left, right] = self.sides();
        let head = Head::of(left)?;
        let own = |definition: &Definition| definition.head.base == head.base;
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        // T_0 = 1 begins what a recursion goes on with.
        let begins = !head.lower.is_empty()
            && head.lower.iter().all(number)
            && head.upper.is_empty()
            && !head.flat().into_iter().any(number);
        if begins && self.used().any(|definition| own(definition) && definition.is_recursive()) {
            return Some("a recursion may begin here".to_owned());
        }
        let member = |expr: &Expr| {
            let mut found = false;
            walk(expr, &mut |part| {
                found |= Head::of(part).is_some_and(|own| {
                    own.base == head.base
                        && own.lower.len() == head.lower.len()
                        && own.upper.len() == head.upper.len()
                });
            });
            found
        };
        let closed = |definition: &Definition| {
            let Body::Formula(body) = &definition.body else { return true };
            !member(body) && !definition.head.lower.iter().all(number)
        };
        // b_i = b_i + 1 goes nowhere.
        let mut circular = false;
        walk(right, &mut |part| circular |= part.same_as(left));
        let recursive = !head.lower.is_empty() && member(right) && !circular;
        let ahead =
            head.arguments.is_none() && head.lower.iter().any(|index| matches!(index.kind, Kind::Add(_)));
        let numbers = !ahead && self.claimed() && self.symbols().is_empty();
        let known = head.notation().is_some()
            || self.is_spoken_of(&head.base)
            || numbers
            || !ahead && self.used().any(|definition| own(definition) && closed(definition));
        (recursive && !known).then(|| format!("it may say how the {} go on", head.base))
    }

    fn symbols(&self) -> BTreeSet<Symbol> {
        [&self.failure.left, &self.failure.right].into_iter().flat_map(compare::symbols).collect()
    }

    /// A name on one side only, of which nothing is said: what it is may make the relation true.
    fn name_on_one_side(&self) -> Option<String> {
        let sides = [&self.failure.left, &self.failure.right].map(compare::symbols);
        // The tangent \dot x_i may be given by the other side.
        let of_one = |symbol: &&Symbol| sides[0].contains(symbol) != sides[1].contains(symbol);
        let mut dotted = sides.iter().flatten().filter(|symbol| symbol.accent() == "dot");
        if let Some(symbol) = dotted.find(of_one) {
            return Some(format!("what {symbol} is is not said"));
        }
        // The points of a curve that the words speak of may be what is missing.
        if self.tally.determined > 0 || self.statement.curve().is_some() {
            return None;
        }
        let [left, right] = sides;
        let place = &self.statement.place;
        let plain =
            |name: &str| left.iter().chain(&right).all(|symbol| symbol.base() != name || symbol.is_plain());
        // The ends a and b of the interval that the formula for C has, in C'(a)
        let of_formula = |name: &str| {
            let inside = |definition: &Definition| matches!(&definition.body, Body::Formula(body) if bases(body).contains(name));
            name.starts_with(char::is_lowercase) && self.used().any(inside)
        };
        let open = |name: &&&str| {
            !(plain(name) && (is_variable(name) || of_formula(name)))
                && !name.starts_with('[')
                && !self.is_spoken_of(name)
                && !self.checker.is_restricted(name, place)
                && !self.checker.is_constrained(name, place)
        };
        let (own, others) = (letters(&left), letters(&right));
        let name = own.symmetric_difference(&others).find(open)?;
        Some(format!("what {name} is is not said"))
    }

    /// Other members of a family on each side, of which nothing is said: a condition on them.
    fn other_members(&self) -> Option<String> {
        if self.tally.determined > 0 {
            return None;
        }
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        let tower = |symbols: &[Symbol], others: &[Symbol]| {
            let own = |symbol: &Symbol| {
                !symbol.upper().is_empty() && !others.contains(symbol) && !self.is_spoken_of(symbol.base())
            };
            symbols.iter().any(own)
        };
        // y_2 beside y_1
        let datum = |value: &Value, own: &[Symbol], others: &[Symbol]| match (value, own) {
            (Value::Scalar(value), [only]) => {
                !only.is_plain()
                    && !others.is_empty()
                    && !others.contains(only)
                    && !self.is_spoken_of(only.base())
                    && *value == Fraction::from(MultiPoly::symbol(only.clone()))
            }
            _ => false,
        };
        let called = self.any(&mut |part| matches!(part.kind, Kind::Apply(..)));
        let data = !self.claimed()
            && !called
            && (datum(&self.failure.left, &left, &right) || datum(&self.failure.right, &right, &left));
        (data || tower(&left, &right) && tower(&right, &left))
            .then(|| "a condition on the members of a family".to_owned())
    }

    /// r(t) = …, and below it r(t) = …: two examples, unless the second is said to follow.
    fn alternative(&self) -> Option<String> {
        let [left, right] = self.sides();
        let head = Head::of(left).filter(|head| head.arguments.is_some() && head.notation().is_none())?;
        let own: BTreeSet<String> = head.flat().into_iter().flat_map(bases).collect();
        let closed = |body: &Expr| {
            let mut structure = false;
            walk(body, &mut |part| structure |= matches!(part.kind, Kind::Big { .. } | Kind::Apply(..)));
            !structure && bases(body).iter().all(|name| own.contains(name) || is_index_letter(name))
        };
        let plain = head.flat().iter().all(|argument| matches!(argument.kind, Kind::Name(_)));
        let before = self.used().any(|definition| {
            definition.head.base == head.base
                && matches!(&definition.body, Body::Formula(body) if closed(body))
        });
        (self.at == 0 && !self.claimed() && plain && closed(right) && before)
            .then(|| format!("it may be another {}", head.base))
    }
}

/// The letters of symbols.
fn letters(symbols: &[Symbol]) -> BTreeSet<&str> {
    symbols.iter().map(Symbol::base).collect()
}
