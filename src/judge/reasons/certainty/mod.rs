//! What has to be certain before a relation is called wrong.
//!
//! A relation that fails is wrong only if every name in it has the meaning that it was given, and if it can be
//! nothing but a claim. Whatever raises a doubt about one of them keeps the verdict open: a right formula called
//! wrong is worse than a wrong one passed over.

mod evidence;
mod notation;
mod numbers;

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::tally::{Failure, Tally};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition, is_variable};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::values::compare::{self, Domain, Outcome};
use crate::judge::values::evaluator;
use crate::judge::values::inequality::{self, Range};
use crate::judge::written::features::has_divided_differences;
use crate::judge::written::names::{Head, bases, is_index_letter, underived, walk};
use crate::language::lexicon::families;
use crate::language::lexicon::roles::{is_degree, is_intermediate};
use crate::language::value::{Value, symbol_expr};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

/// A relation that fails, with everything around it.
pub(in crate::judge) struct Suspect<'a> {
    pub(in crate::judge) checker: &'a Checker,
    pub(in crate::judge) tally: &'a Tally,
    /// Of the links of the chain before this one.
    pub(in crate::judge) earlier: &'a [Tally],
    pub(in crate::judge) chain: &'a Chain,
    pub(in crate::judge) at: usize,
    pub(in crate::judge) statement: &'a Statement,
    pub(in crate::judge) failure: &'a Failure,
}

impl Suspect<'_> {
    /// Why it may not be wrong after all.
    pub(in crate::judge) fn doubt(&self) -> Option<String> {
        self.unknown_function().or_else(|| self.doubt_of_form())
    }

    /// Why it may not be wrong, whatever its names stand for.
    fn doubt_of_form(&self) -> Option<String> {
        let rules: [fn(&Self) -> Option<String>; 22] = [
            Self::of_one_that_exists,
            Self::data_of_another,
            Self::join_of_any_degree,
            Self::unrelated_functions,
            Self::new_function,
            Self::operator,
            Self::equation_to_be_solved,
            Self::matrices,
            Self::inequality_without_range,
            Self::family_of_another_kind,
            Self::rounded_or_modular,
            Self::word_of_a_group,
            Self::of_what_is_not_used,
            Self::value_of_unknown_data,
            Self::of_another_piece,
            Self::of_one_size,
            Self::of_another_size,
            Self::of_another_degree,
            Self::of_a_value_heard,
            Self::outside_of_its_interval,
            Self::outside_of_a_range,
            Self::unused_equation,
        ];
        rules.into_iter().find_map(|rule| rule(self))
    }

    /// f(b) - f(a) = f'(ξ)(b - a): there is such a ξ.
    fn of_one_that_exists(&self) -> Option<String> {
        let written: Vec<BTreeSet<String>> = self.sides().into_iter().map(bases).collect();
        let said = self.chain.exists.iter().find(|name| written.iter().any(|side| side.contains(*name)));
        let between = || {
            let mut names = written[0].symmetric_difference(&written[1]);
            names.find(|name| is_intermediate(name) && self.is_only_argument(name, &|_| true))
        };
        said.or_else(between).map(|name| format!("it may be said of one {name} that exists"))
    }

    /// "Let p(0) = 1", "the polynomials with p(0) = 1", after p(t) = t^2: values that are given, and not claimed.
    fn data_of_another(&self) -> Option<String> {
        let given = self.statement.of_a_kind || self.statement.role == Some(Role::Introduced);
        let Kind::Apply(callee, groups) = &self.sides()[0].kind else { return None };
        let value = groups.iter().flatten().all(|argument| bases(argument).is_empty());
        let name = Head::of(underived(callee))?.base;
        (given && value && self.are_numbers()).then(|| format!("it may give a value to another {name}"))
    }

    /// Curves of degree n that join: the instances that are solved leave too much open.
    fn join_of_any_degree(&self) -> Option<String> {
        let any = self.tally.determined > 0 && !self.failure.integers.is_empty();
        (any && self.statement.topics.has(Topic::Join))
            .then(|| "how curves of any degree join is not followed here".to_owned())
    }

    /// f(c, u, v) = g(c, u, v) for any f and g, h_1 (b_n - b_{n-1}) = h_0 (c_1 - c_0) for any points b_i and c_i is claimed
    /// by nobody: what relates them was not understood.
    fn unrelated_functions(&self) -> Option<String> {
        let families = |value: &Value| -> BTreeSet<String> {
            let members = compare::symbols(value).into_iter().filter(|symbol| !symbol.is_plain());
            members.map(|symbol| symbol.base().to_owned()).collect()
        };
        let is_function = |name: &String| name.starts_with('[');
        let (left, right) = (families(&self.failure.left), families(&self.failure.right));
        let functions = left.iter().chain(&right).all(is_function);
        let only = |own: &BTreeSet<String>, other: &BTreeSet<String>| -> BTreeSet<String> {
            own.difference(other).cloned().collect()
        };
        let (own, other) = (only(&left, &right), only(&right, &left));
        let unknown = |name: &String| is_function(name) || self.is_family_of_points(name);
        let unrelated =
            if functions { left.is_disjoint(&right) } else { own.iter().chain(&other).all(unknown) };
        let name = |set: &BTreeSet<String>| set.first().map(|name| name.trim_matches(['[', ']']).to_owned());
        let (one, another) = (name(&own)?, name(&other)?);
        unrelated.then(|| format!("what relates {one} and {another} is not understood here"))
    }

    /// Whether words say that a letter is that of control points, or, where curves join, its members are listed.
    fn is_family_of_points(&self, letter: &String) -> bool {
        let context = &self.checker.context;
        let told = context.objects.iter().any(|told| {
            let names = match told.object.sort {
                Sort::ControlPoints => &told.object.names,
                _ => &told.object.points,
            };
            names.iter().filter_map(Head::of).any(|head| head.base == *letter)
        });
        told || self.statement.topics.has(Topic::Join)
            && context.listed(letter, &self.statement.place).is_some()
    }

    /// A law that stays open, data that words change: "Now move b_2 to (6, 8)."
    fn of_what_is_not_used(&self) -> Option<String> {
        self.checker.unused(self.sides(), &self.statement.place)
    }

    /// f[0, 0] = 2, f[0, 2] = 6, f[2, 3] = 3, f[3, 3] = 5 are coefficients of a spline, and no values of one polar form.
    fn of_another_piece(&self) -> Option<String> {
        let given = self.tally.determined > 0 || self.tally.condition.is_some();
        if !given || !self.statement.topics.has(Topic::Spline) {
            return None;
        }
        let mut found = None;
        self.any(&mut |part| {
            let Kind::Apply(callee, groups) = &part.kind else { return false };
            let arguments: Vec<&Expr> = groups.iter().flatten().collect();
            if arguments.len() > 1 && arguments.into_iter().all(|argument| bases(argument).is_empty()) {
                found = found.take().or_else(|| Head::of(callee).map(|head| head.base));
            }
            false
        });
        found.map(|name| format!("on which piece {name} is meant is not said"))
    }

    /// det L = 2^{-n(n+1)/2}, where the page gives the L of one n.
    fn of_one_size(&self) -> Option<String> {
        let integers: BTreeSet<&String> = self.failure.integers.iter().map(|(name, _)| name).collect();
        let fixed = |side: &Expr, value: &Value| {
            let own = bases(side);
            !own.is_empty()
                && own.iter().all(|name| !integers.contains(name))
                && value.as_rational().is_some()
        };
        let [left, right] = self.sides();
        let one = fixed(left, &self.failure.left) || fixed(right, &self.failure.right);
        let name = integers.first().filter(|_| one && self.tally.holds > 0)?;
        Some(format!("it holds for some {name}: which one is meant?"))
    }

    /// "Let us do it for n = 2. …": what fails for another n only is none of this example.
    fn of_another_size(&self) -> Option<String> {
        let place = &self.statement.place;
        let own: BTreeSet<String> = self.chain.conditions.iter().flat_map(bases).collect();
        let heard = self.checker.context.sizes_heard(|other| other.group == place.group);
        let said: Vec<(&str, i64)> = heard.filter(|(name, _)| !own.contains(*name)).collect();
        let fails_with = |name: &str, value: i64| {
            self.tally.fails.iter().any(|failure| {
                match failure.integers.iter().find(|(own, _)| own == name) {
                    Some((_, own)) => *own == value,
                    None => failure.degree.is_none_or(|degree| degree as i64 == value),
                }
            })
        };
        let (name, value) = said.last()?;
        let fails = said.iter().any(|(name, value)| fails_with(name, *value));
        (!fails).then(|| format!("it does not fail for {name} = {value}"))
    }

    /// C'(u) = Σ … N_{i,p-1}(u) for any p, where the page gives a C with N_{i,3} only: that is one of many.
    fn of_another_degree(&self) -> Option<String> {
        let degrees = |expr: &Expr| {
            let mut found: Vec<(String, Expr)> = Vec::new();
            walk(expr, &mut |part| {
                if let Some(head) = Head::of(part)
                    && families::is_family(&head.base)
                    && let Some(degree) = head.upper.last().or(head.lower.get(1))
                {
                    found.push((head.base, degree.clone()));
                }
            });
            found
        };
        let here: Vec<(String, Expr)> = self.sides().into_iter().flat_map(degrees).collect();
        let name = self.used().find_map(|own| {
            let Body::Formula(body) = &own.body else { return None };
            let own_degrees = degrees(body);
            let fixed = |(_, degree): &&(String, Expr)| matches!(degree.kind, Kind::Number(_));
            let any = |(letter, _): &(String, Expr)| {
                here.iter().any(|(other, degree)| other == letter && !bases(degree).is_empty())
            };
            let one = !own_degrees.is_empty() && own_degrees.iter().all(|pair| fixed(&pair) && any(pair));
            one.then(|| own.head.base.clone())
                .filter(|name| own_degrees.iter().all(|(letter, _)| letter != name))
        })?;
        Some(format!("a {name} of one degree is given, and this is said of any"))
    }

    /// "We evaluate at τ = 5/2. …": what holds there may be said of nothing else.
    fn of_a_value_heard(&self) -> Option<String> {
        let place = &self.statement.place;
        let free = self.symbols();
        let heard = self.checker.context.values_heard(|other| other.group == place.group);
        let mut said = heard.filter_map(|(name, expr)| {
            let symbol = free.iter().find(|symbol| symbol.is_plain() && symbol.base() == name)?;
            Some((symbol.clone(), evaluator::number(expr)?))
        });
        let holds = |(symbol, value): &(Symbol, Rational)| {
            let by = [(symbol.clone(), Fraction::from(MultiPoly::constant(value.clone())))];
            let put = |side: &Value| compare::substituted(side, &by);
            let (Some(left), Some(right)) = (put(&self.failure.left), put(&self.failure.right)) else {
                return false;
            };
            // At the end of an interval many a wrong formula is 0 = 0.
            !left.as_rational().is_some_and(|value| value.is_zero())
                && matches!(compare::relation(self.rel(), &left, &right, &[], Domain::Reals), Outcome::Holds)
        };
        let (symbol, value) = said.find(holds).filter(|_| !self.chain.universal)?;
        Some(format!("it holds for {} = {value}", symbol.base()))
    }

    /// s(9/5) or s(u - 1), where s(u) = 1 + 2u was said beside [0, 1]: it may be so there only.
    fn outside_of_its_interval(&self) -> Option<String> {
        let context = &self.checker.context;
        let range_of = |definition: &Definition, variable: &Symbol| {
            let own = &definition.place;
            let near = own.formula.saturating_sub(2)..=own.formula + 1;
            let beside = || {
                let mut all = context.intervals_beside(own).rev();
                let (_, [from, to], _) = all.find(|(formula, ..)| near.contains(formula))?;
                Some(Range::between(evaluator::number(from)?, evaluator::number(to)?))
            };
            let heard = || {
                let beside = context.heard.iter().filter(|(other, _)| other.group == own.group);
                let near: Vec<Expr> = beside
                    .filter(|(other, _)| near.contains(&other.formula))
                    .map(|(_, range)| Expr::clone(range))
                    .collect();
                inequality::range(variable, &near)
            };
            inequality::range(variable, &definition.conditions).or_else(beside).or_else(heard)
        };
        self.used().find_map(|definition| {
            let own = &definition.head;
            let [Expr { kind: Kind::Name(variable), .. }] = own.flat().as_slice() else { return None };
            let variable = Symbol::new(variable);
            let range = range_of(definition, &variable)?;
            let value = |argument: &Expr, at: &Rational| {
                let at = [(variable.clone(), Value::number(at.clone()))];
                let value = evaluator::machine().with_locals(at, |machine| machine.eval(argument));
                value.ok().and_then(|value| value.as_rational())
            };
            let mut outside = |part: &Expr| {
                let Kind::Apply(callee, groups) = &part.kind else { return false };
                let [argument] = groups.iter().flatten().collect::<Vec<_>>()[..] else { return false };
                let called = Head::of(underived(callee)).is_some_and(|head| head.base == own.base);
                called
                    && range.ends().filter_map(|end| value(argument, end)).any(|at| range.is_passed_by(&at))
            };
            self.any(&mut outside).then(|| format!("what {} is there is not said", own.base))
        })
    }

    /// d_i^1 = …, where what d_i^r is was said for i = j - n + r, …, j, and which j is meant here is open.
    fn outside_of_a_range(&self) -> Option<String> {
        let known: BTreeSet<&String> = self.failure.integers.iter().map(|(name, _)| name).collect();
        let open = |definition: &Definition| {
            let own: BTreeSet<String> =
                definition.head.lower.iter().chain(&definition.head.upper).flat_map(bases).collect();
            let ranges = definition
                .conditions
                .iter()
                .filter(|range| bases(range).iter().any(|name| own.contains(name)));
            let mut names = ranges.flat_map(bases);
            names.find(|name| {
                is_index_letter(name) && !own.contains(name) && !known.contains(name) && !is_degree(name)
            })
        };
        // d_i^* = d_i for i ≤ r - n, d_i^* = d_{i-1} for i > r: which of them holds for an i is open, too.
        let place = &self.statement.place;
        let several = |definition: &Definition| {
            let known = self.checker.context.visible(&definition.head.base, place);
            let cases = known.filter(|(_, own, near)| {
                *near && own.head.lower.len() == definition.head.lower.len() && !own.conditions.is_empty()
            });
            cases.count() > 1
        };
        let name = self.used().find_map(|own| open(own).filter(|_| self.tally.holds > 0 || several(own)))?;
        Some(format!("for which {name} it is said is open"))
    }

    /// "We may assume w_0 = 1", in an earlier paragraph, or w = cos 45°, which is not computed: it was not used, so that
    /// w_0 and w are still any numbers here.
    fn unused_equation(&self) -> Option<String> {
        let place = &self.statement.place;
        let context = &self.checker.context;
        let symbols = self.symbols();
        let free: Vec<Expr> = symbols.iter().map(symbol_expr).collect();
        let is_free = |side: &Expr| free.iter().any(|symbol| symbol.same_as(side));
        let ended = |other: &Place| {
            place.sees(other) && place.blocks.starts_with(&other.blocks) && other.group != place.group
        };
        let mut assumed =
            context.conditions.iter().filter(|condition| condition.assumed && ended(&condition.place));
        let assumed = assumed.find(|condition| match &condition.expr.kind {
            Kind::Chain(left, links) => match links.as_slice() {
                [link] => link.rel == Rel::Eq && (is_free(left) || is_free(&link.expr)),
                _ => false,
            },
            _ => false,
        });
        let defined = symbols.iter().filter(|symbol| symbol.is_plain()).find_map(|symbol| {
            let name = |head: &Head| head.is_bare();
            context.visible(symbol.base(), place).find(|(_, known, near)| *near && name(&known.head))
        });
        let line = assumed.map(|condition| condition.line).or(defined.map(|(_, known, _)| known.line))?;
        Some(format!("what line {line} says is not used here"))
    }

    /// q''(1) = 6, where words say that q is a curve, but its data are not understood, or leave its value open: nobody claims
    /// it of any curve.
    fn value_of_unknown_data(&self) -> Option<String> {
        let [left, right] = self.sides();
        let number = |expr: &Expr| bases(expr).is_empty();
        let own = |side: &Expr, other: &Expr| {
            let Kind::Apply(callee, groups) = &side.kind else { return None };
            let name = Head::of(underived(callee))?.base;
            let unknown = self.tally.determined == 0 && self.tally.record.unknown.contains(&name);
            let zero = matches!(&other.kind, Kind::Number(q) if q.is_zero());
            let value = groups.iter().flatten().all(number) && number(other) && !zero;
            (value && (unknown || self.is_in_letters_beyond(side))).then_some(name)
        };
        let name = own(left, right).or_else(|| own(right, left))?;
        Some(format!("the data of {name} are not understood here"))
    }

    /// Whether the sides differ, after all that is known, by something in members that a side does not name.
    fn is_in_letters_beyond(&self, side: &Expr) -> bool {
        let own = bases(side);
        let other = |symbol: &Symbol| !symbol.is_plain() && !own.contains(symbol.base());
        self.failure.difference().is_some_and(|value| compare::symbols(value).iter().any(other))
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

    /// Δ_{j,i}(x) = P_{j+1}(x) − P_j(x), where nothing tells what Δ is, may say what it is.
    fn new_function(&self) -> Option<String> {
        let [left, right] = self.sides();
        let callee = match &left.kind {
            Kind::Apply(callee, _) => Head::of(callee)?,
            _ => return None,
        };
        let record = &self.tally.record;
        let new = record.unknown.contains(&callee.base)
            && !callee.lower.is_empty()
            && !record.paired.contains(&callee.base)
            && !bases(right).contains(&callee.base);
        new.then(|| format!("it may say what {} is", callee.base))
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

    /// P(α) = 0; x_1^2 - 4 x_1 x_2 + 1 = 0, where x_1 and x_2 were numbers in an example.
    fn equation_to_be_solved(&self) -> Option<String> {
        if let Some(name) = &self.statement.solved
            && self.used().any(|definition| definition.head.base == *name)
        {
            return Some(format!("it may be an equation for {name}"));
        }
        let zero = |expr: &Expr| matches!(&expr.kind, Kind::Number(q) if q.is_zero());
        let mut structure =
            |part: &Expr| matches!(part.kind, Kind::Apply(..) | Kind::Big { .. } | Kind::Integral { .. });
        let named = self.sides().into_iter().any(|side| !bases(side).is_empty());
        let plain = self.are_numbers() && named && !self.any(&mut structure);
        let of_example = plain && self.sides().into_iter().any(zero);
        // 2 x_1 + x_2 = -1, where x_1 and x_2 solved another system
        let [left, right] = self.sides();
        let of_system = plain
            && self.chain.relations.len() == 1
            && !self.claimed()
            && matches!(left.kind, Kind::Add(_))
            && bases(right).is_empty();
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
            && self.tally.record.standard.is_empty()
            && !self.has_no_solution()
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
        (self.is_equation() && (of_example || of_system || of_one || root(one, other) || root(other, one)))
            .then(|| "it may be an equation to be solved".to_owned())
    }

    /// x = x + 1 has no solution, nor has 2x/(1 - x^2) = 2/(1 - x^2).
    fn has_no_solution(&self) -> bool {
        match (&self.failure.left, &self.failure.right) {
            (Value::Scalar(left), Value::Scalar(right)) => {
                left.minus(right).numerator().as_constant().is_some()
            }
            _ => false,
        }
    }

    fn symbols(&self) -> BTreeSet<Symbol> {
        [&self.failure.left, &self.failure.right].into_iter().flat_map(compare::symbols).collect()
    }
}
