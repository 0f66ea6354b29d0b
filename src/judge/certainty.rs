//! What has to be certain before a relation is called wrong.
//!
//! A relation that fails is wrong only if every name in it has the meaning that it was given, and if it can be
//! nothing but a claim. Whatever raises a doubt about one of them keeps the verdict open: a right formula called
//! wrong is worse than a wrong one passed over.

use std::collections::BTreeSet;

use super::check::Checker;
use super::compare;
use super::context::{Body, Definition, is_variable};
use super::features::has_divided_differences;
use super::names::{Head, bases, is_index_letter, walk};
use super::object::Sort;
use super::statement::{Chain, Role, Statement};
use super::tally::{Failure, Tally};
use super::topic::Topic;
use crate::formula::{Accent, Expr, Kind, Rel};
use crate::language::lexicon::families::Family;
use crate::language::lexicon::letters;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::Symbol;
use num_traits::{Signed, Zero};

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
        let rules: [fn(&Self) -> Option<String>; 15] = [
            Self::rests_on_another_section,
            Self::unknown_function,
            Self::operator,
            Self::value_in_passing,
            Self::recursion_of_a_family,
            Self::matrices,
            Self::inequality_without_range,
            Self::family_of_another_kind,
            Self::rounded_or_modular,
            Self::symbols_on_one_side,
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
        let far = self.tally.record.definitions.iter().find(|(_, near)| !near)?;
        let line = self.checker.context.definitions[far.0].line;
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

    /// A letter before a bracket is a factor only if it stands somewhere else without one.
    fn operator(&self) -> Option<String> {
        let mut callees: Vec<&str> = Vec::new();
        let mut plain: BTreeSet<&str> = BTreeSet::new();
        fn collect<'e>(expr: &'e Expr, callees: &mut Vec<&'e str>, plain: &mut BTreeSet<&'e str>) {
            match &expr.kind {
                Kind::Apply(callee, groups) => {
                    match &callee.kind {
                        Kind::Name(name) => callees.push(name),
                        _ => collect(callee, callees, plain),
                    }
                    groups.iter().flatten().for_each(|argument| collect(argument, callees, plain));
                }
                Kind::Name(name) => {
                    plain.insert(name);
                }
                _ => expr.for_each_child(&mut |child| collect(child, callees, plain)),
            }
        }
        for side in &self.chain.sides {
            collect(&side.expr, &mut callees, &mut plain);
        }
        let place = &self.statement.place;
        let context = &self.checker.context;
        // dt, d(t^n)
        let differential =
            callees.contains(&"d") && !self.failure.integers.iter().any(|(name, _)| name == "d");
        if differential {
            return Some("d may be a differential".to_owned());
        }
        let known = |name: &str| {
            plain.contains(name)
                || name.chars().count() > 1 && letters::sign(name).is_none()
                || context.letters.is_function(name)
                || context.object_called(name, place).is_some()
                || context.visible(name, place).next().is_some()
                || self.tally.record.unknown.contains(name)
                || is_index_letter(name) && self.failure.integers.iter().any(|(own, _)| own == name)
        };
        if let Some(name) = callees.into_iter().find(|name| !known(name)) {
            return Some(format!("{name} may be a function or an operator"));
        }
        // f^{-1}(y) is a value of the inverse.
        let function = |name: &str| {
            context.letters.is_function(name)
                || context.visible(name, place).any(|(_, definition, _)| definition.head.arguments.is_some())
        };
        let inverse = self.any(&mut |part| match &part.kind {
            Kind::Pow(base, exponent) => {
                matches!(&base.kind, Kind::Name(name) if function(name)) && is_minus_one(exponent)
            }
            _ => false,
        });
        if inverse {
            return Some("it may be an inverse function".to_owned());
        }
        // b^0(0): a value of b^0, or a product?
        let value = self.any(&mut |part| match &part.kind {
            Kind::Mul(factors) => factors.windows(2).any(|pair| {
                matches!((&pair[0].kind, &pair[1].kind), (Kind::Pow(base, _), Kind::Group(inner))
                    if matches!(&base.kind, Kind::Name(name) if !plain_elsewhere(name, part, &self.sides()))
                        && matches!(inner.kind, Kind::Number(_) | Kind::Name(_)))
            }),
            _ => false,
        });
        if value {
            return Some("what stands before the bracket may be a function".to_owned());
        }
        // ΔS_i, where nothing says of what sequence it is a difference
        let difference = self.any(&mut |part| match &part.kind {
            Kind::Mul(factors) => factors.windows(2).any(|pair| {
                matches!(&pair[0].kind, Kind::Name(name) if name == "Delta")
                    && bases(&pair[1]).iter().all(|name| context.object_called(name, place).is_none())
            }),
            _ => false,
        });
        let named = self.symbols().iter().any(|symbol| symbol.base() == "Delta");
        (named || difference && !self.claimed()).then(|| "what Δ means is not said".to_owned())
    }

    /// n = 6, τ_4 = t_1: a value, unless it is said to follow.
    fn value_in_passing(&self) -> Option<String> {
        let equation = matches!(self.rel(), Rel::Eq | Rel::Equiv);
        let left = self.sides()[0];
        let name = Head::of(left).is_some_and(|head| head.arguments.is_none() && head.notation().is_none());
        let first = self.at == 0;
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        // t = b_1(t)/3 + …, A^{-1} = …: it speaks of what is known.
        let known = !left.is_empty()
            && left.iter().all(|symbol| right.contains(symbol))
            && left.len() == right.len()
            || Head::of(self.sides()[0]).is_some_and(|head| !head.upper.is_empty() && head.lower.is_empty());
        if equation && first && name && !known && !self.claimed() {
            return Some("it may say what its left side is".to_owned());
        }
        let name_only = |expr: &Expr| {
            Head::of(expr).is_some_and(|head| {
                head.arguments.is_none() && !head.lower.is_empty() && head.notation().is_none()
            }) && !self
                .checker
                .context
                .object(&Head::of(expr).expect("just taken apart"), &self.statement.place)
                .is_some()
        };
        let [one, other] = self.sides();
        if equation && name_only(one) && name_only(other) && self.tally.determined == 0 {
            return Some("it may say what these names stand for".to_owned());
        }
        // x_1^2 - 4 x_1 x_2 + 1 = 0, where x_1 and x_2 were numbers in an example
        let zero = |expr: &Expr| matches!(&expr.kind, Kind::Number(q) if q.is_zero());
        let valued = self.tally.record.definitions.iter().any(|(number, _)| {
            let definition = &self.checker.context.definitions[*number];
            definition.head.arguments.is_none()
                && matches!(&definition.body, Body::Formula(body) if bases(body).is_empty())
        });
        let called = self
            .any(&mut |part| matches!(part.kind, Kind::Apply(..) | Kind::Big { .. } | Kind::Integral { .. }));
        if equation && valued && !called && (zero(one) || zero(other)) {
            return Some("it may be an equation to be solved".to_owned());
        }
        // P(α) = 0 is an equation for α.
        let root = |call: &Expr, value: &Expr| {
            let place = &self.statement.place;
            let context = &self.checker.context;
            bases(value).is_empty()
                && match &call.kind {
                    Kind::Apply(_, groups) => groups.iter().flatten().any(|argument| {
                        matches!(&argument.kind, Kind::Name(name) if !is_variable(name)
                            && !is_index_letter(name)
                            && context.visible(name, place).next().is_none()
                            && context.object_called(name, place).is_none())
                    }),
                    _ => false,
                }
        };
        let [a, b] = self.sides();
        (equation && (root(a, b) || root(b, a))).then(|| "it may be an equation to be solved".to_owned())
    }

    /// a_{n,m} = a_{n,m-1} + a_{n-1,m-1} holds where it is meant to hold.
    fn recursion_of_a_family(&self) -> Option<String> {
        let [left, right] = self.sides();
        let head = Head::of(left)?;
        let place = &self.statement.place;
        let context = &self.checker.context;
        let own = |definition: &Definition| definition.head.base == head.base;
        let used: Vec<_> =
            self.tally.record.definitions.iter().map(|(n, _)| &context.definitions[*n]).collect();
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        // T_0 = 1 begins what a recursion goes on with.
        let begins = !head.lower.is_empty() && head.lower.iter().all(number);
        if begins && used.iter().any(|definition| own(definition) && definition.is_recursive()) {
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
        let recursive = !head.lower.is_empty() && member(right);
        let ahead =
            head.arguments.is_none() && head.lower.iter().any(|index| matches!(index.kind, Kind::Add(_)));
        let numbers = !ahead && self.claimed() && self.symbols().is_empty();
        let known = head.notation().is_some()
            || context.object_called(&head.base, place).is_some()
            || numbers
            || !ahead && used.iter().any(|definition| own(definition) && closed(definition));
        (recursive && !known).then(|| format!("it may say how the {} go on", head.base))
    }

    /// Products of matrices, inverses and transposes of what nobody introduced.
    fn matrices(&self) -> Option<String> {
        let place = &self.statement.place;
        let context = &self.checker.context;
        let known = |name: &str| {
            context.object_called(name, place).is_some() || context.visible(name, place).next().is_some()
        };
        let capital = |expr: &Expr| match &expr.kind {
            Kind::Name(name) => name.starts_with(char::is_uppercase).then_some(name.clone()),
            Kind::Subscript(base, _) => match &base.kind {
                Kind::Name(name) if name == "I" => Some(name.clone()),
                _ => None,
            },
            _ => None,
        };
        let mut unknown: Option<String> = None;
        let mut look = |expr: &Expr| {
            if let Some(name) = capital(expr).filter(|name| !known(name)) {
                unknown.get_or_insert(name);
            }
        };
        let mut matrix = false;
        for side in self.sides() {
            walk(side, &mut |part| match &part.kind {
                Kind::Transpose(inner) => {
                    matrix = true;
                    look(inner);
                }
                Kind::Pow(base, exponent) if is_minus_one(exponent) && capital(base).is_some() => {
                    matrix = true;
                    look(base);
                }
                Kind::Mul(factors) => {
                    let capitals = factors.iter().filter(|factor| capital(factor).is_some()).count();
                    if capitals > 1 {
                        matrix = true;
                    }
                    factors.iter().for_each(&mut look);
                }
                Kind::Add(terms) => terms.iter().for_each(|term| look(&term.expr)),
                Kind::Matrix(..) => matrix = true,
                _ => {}
            });
        }
        // \begin{bmatrix} n \\ k \end{bmatrix} counts something.
        let counts = self.any(&mut |part| match &part.kind {
            Kind::Matrix(rows, _) => rows.iter().flatten().flatten().all(|entry| {
                let names = bases(entry);
                !names.is_empty() && names.iter().all(|name| is_index_letter(name))
            }),
            _ => false,
        });
        if counts {
            return Some("the bracket may be a number".to_owned());
        }
        let declared = self.any(&mut |part| match &part.kind {
            Kind::Name(name) => {
                context.object_called(name, place).is_some_and(|d| d.object.sort == Sort::Matrix)
            }
            _ => false,
        });
        // Those of a factorisation have properties that words give.
        let determinant = self.any(&mut |part| matches!(&part.kind, Kind::Name(name) if name == "det"));
        if determinant && self.tally.record.standard.iter().any(|note| note.contains("any 2 by 2 matrix")) {
            return Some("which matrices these are is not said".to_owned());
        }
        let name = unknown.filter(|_| matrix || declared)?;
        Some(format!("{name} may be a matrix"))
    }

    /// An inequality holds for some range: it has to be given.
    fn inequality_without_range(&self) -> Option<String> {
        if !matches!(self.rel(), Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge) {
            return None;
        }
        if self.statement.role == Some(Role::Introduced) {
            return Some("a condition".to_owned());
        }
        let ranged = |name: &str, plain: bool| {
            self.checker.is_restricted(name, &self.statement.place)
                || self.chain.conditions.iter().any(|condition| bases(condition).contains(name))
                || self.chain.universal
                || self.tally.record.unit && plain
        };
        let written = || self.sides().into_iter().flat_map(bases).filter(|name| is_variable(name));
        let free = self.symbols().into_iter().map(|symbol| (symbol.base().to_owned(), symbol.is_plain()));
        if let Some((name, _)) =
            free.chain(written().map(|name| (name, true))).find(|(name, plain)| !ranged(name, *plain))
        {
            return Some(format!("for which {name} it is meant is not said"));
        }
        let integer = self.failure.integers.iter().find(|(name, value)| {
            *value < 2 && !self.chain.conditions.iter().any(|condition| bases(condition).contains(name))
        });
        integer.map(|(name, _)| format!("for which {name} it is meant is not said"))
    }

    /// B_i^k on a page about B-splines, or without an argument.
    fn family_of_another_kind(&self) -> Option<String> {
        let mut family = |part: &Expr| {
            Head::of(part).is_some_and(|head| head.is_a(Family::Bernstein) || head.is_a(Family::Triangular))
        };
        let assumed = self.tally.record.standard.iter().any(|note| note.contains("Bernstein"));
        if !assumed || !self.any(&mut family) {
            return None;
        }
        let topics = self.statement.topics;
        let told = topics.has(Topic::Bernstein) || self.checker.context.letters.binomial_family;
        (!told).then(|| "nothing says that the B are Bernstein polynomials".to_owned())
    }

    /// Numbers that were rounded, or that are counted modulo another.
    fn rounded_or_modular(&self) -> Option<String> {
        if self.rel() == Rel::Equiv {
            return Some("it may be a congruence".to_owned());
        }
        if self.statement.role == Some(Role::Introduced)
            && self.tally.record.definitions.is_empty()
            && self.tally.record.standard.is_empty()
        {
            return Some("a condition".to_owned());
        }
        let written = |side: &Expr| bases(side).is_empty();
        if !self.sides().into_iter().all(written) {
            return None;
        }
        if self.statement.topics.has(Topic::Modular) {
            return Some("it may be meant modulo a number".to_owned());
        }
        // The Legendre symbol of 2 and 5
        let quotient = |side: &Expr| matches!(&side.kind, Kind::Group(inner) if matches!(inner.kind, Kind::Div(..) | Kind::Number(_)));
        if self.sides().into_iter().any(quotient) {
            return Some("the bracket may be a symbol".to_owned());
        }
        let (Some(left), Some(right)) = (number(&self.failure.left), number(&self.failure.right)) else {
            return None;
        };
        // As many digits as the side shows.
        let mut finest: Option<Rational> = None;
        for side in self.sides() {
            walk(side, &mut |part| {
                if let Kind::Number(q) = &part.kind
                    && !q.is_integer()
                {
                    let digits = last_digit(q);
                    finest = Some(finest.take().map_or(digits.clone(), |known| known.max(digits)));
                }
            });
        }
        let near = finest.is_some_and(|digit| {
            let size = right.abs().max(Rational::from_integer(1.into()));
            (left - &right).abs() <= digit * size
        });
        near.then(|| "equal up to rounding".to_owned())
    }

    fn symbols(&self) -> BTreeSet<Symbol> {
        [&self.failure.left, &self.failure.right].into_iter().flat_map(compare::symbols).collect()
    }

    /// A name on one side only, of which nothing is said: what it is may make the relation true.
    fn symbols_on_one_side(&self) -> Option<String> {
        let (left, right) = (compare::symbols(&self.failure.left), compare::symbols(&self.failure.right));
        let letters = |symbols: &[Symbol]| -> BTreeSet<String> {
            symbols.iter().map(|symbol| symbol.base().to_owned()).collect()
        };
        let left: Vec<Symbol> = left.into_iter().collect();
        let right: Vec<Symbol> = right.into_iter().collect();
        let (a, b) = (letters(&left), letters(&right));
        let place = &self.statement.place;
        let open = |name: &&String| {
            let plain =
                left.iter().chain(&right).all(|symbol| symbol.base() != name.as_str() || symbol.is_plain());
            !(plain && is_variable(name))
                && !name.starts_with('[')
                && self.checker.context.object_called(name, place).is_none()
                && !self.checker.is_restricted(name, place)
                && !self.checker.is_constrained(name, place)
        };
        // Members of a family with upper indices of which nothing is said
        let tower = |symbols: &[Symbol], others: &[Symbol]| {
            symbols.iter().any(|symbol| {
                !symbol.upper().is_empty()
                    && !others.contains(symbol)
                    && self.checker.context.object_called(symbol.base(), place).is_none()
            })
        };
        if tower(&left, &right) && tower(&right, &left) && self.tally.determined == 0 {
            return Some("a condition on the members of a family".to_owned());
        }
        // y_2 beside y_1: another datum
        let single = |value: &Value, others: &[Symbol]| {
            let Value::Scalar(scalar) = value else { return false };
            let mut own = compare::symbols(value).into_iter();
            let only = own.next().filter(|_| own.next().is_none());
            only.is_some_and(|symbol| {
                !symbol.is_plain()
                    && !others.contains(&symbol)
                    && !others.is_empty()
                    && *scalar
                        == crate::math::poly::Fraction::from(crate::math::poly::MultiPoly::symbol(
                            symbol.clone(),
                        ))
                    && self.checker.context.object_called(symbol.base(), place).is_none()
            })
        };
        if self.tally.determined == 0
            && !self.claimed()
            && (single(&self.failure.left, &right) || single(&self.failure.right, &left))
        {
            return Some("a condition on data".to_owned());
        }
        if self.tally.determined > 0 {
            return None;
        }
        let name = a.symmetric_difference(&b).find(open)?;
        Some(format!("what {name} is is not said"))
    }

    /// Lists of names, and brackets that count conditions.
    fn brackets(&self) -> Option<String> {
        let list = |expr: &Expr| match &expr.kind {
            Kind::List(items) | Kind::Tuple(items) => {
                items.iter().all(|item| matches!(item.kind, Kind::Name(_)))
            }
            _ => false,
        };
        if self.sides().into_iter().all(list) {
            return Some("what these lists stand for is not said".to_owned());
        }
        let counted = self.any(&mut |part| match &part.kind {
            Kind::List(items) => items.iter().any(|item| matches!(item.kind, Kind::Chain(..))),
            _ => false,
        });
        counted.then(|| "a condition stands in brackets".to_owned())
    }

    /// r(t) = …, and below it r(t) = …: two examples, unless the second is said to follow.
    fn alternative(&self) -> Option<String> {
        let [left, right] = self.sides();
        let head = Head::of(left).filter(|head| head.arguments.is_some() && head.notation().is_none())?;
        let own: BTreeSet<String> = head.flat().into_iter().flat_map(bases).collect();
        let closed = |body: &Expr| bases(body).iter().all(|name| own.contains(name) || is_index_letter(name));
        let plain = head.flat().iter().all(|argument| matches!(argument.kind, Kind::Name(_)));
        let before = self.tally.record.definitions.iter().any(|(number, _)| {
            let definition = &self.checker.context.definitions[*number];
            definition.head.base == head.base
                && matches!(&definition.body, Body::Formula(body) if closed(body))
        });
        (self.at == 0 && !self.claimed() && plain && closed(right) && before)
            .then(|| format!("it may be another {}", head.base))
    }

    /// What holds for some degrees, and is meant for them: ℓ_0(x_1) = 0 needs two nodes.
    fn some_degrees(&self) -> Option<String> {
        let failed: BTreeSet<usize> =
            self.tally.fails.iter().map(|failure| failure.degree).collect::<Option<_>>()?;
        (self.failure.integers.is_empty()
            && self.tally.holds > 0
            && (1..=4).any(|degree| !failed.contains(&degree)))
        .then(|| "true for some degrees only: which one is meant?".to_owned())
    }

    /// A sum over all w_j, of which the page gave those of an example.
    fn members_of_an_example(&self) -> Option<String> {
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        let definitions =
            self.tally.record.definitions.iter().map(|(n, _)| &self.checker.context.definitions[*n]);
        let given: BTreeSet<&str> = definitions
            .filter(|definition| {
                !definition.head.lower.is_empty() && definition.head.lower.iter().all(number)
            })
            .filter(|definition| definition.head.arguments.is_none() && definition.head.upper.is_empty())
            .map(|definition| definition.head.base.as_str())
            .collect();
        if self.failure.integers.is_empty() || given.is_empty() {
            return None;
        }
        let general = self.any(&mut |part| match &part.kind {
            Kind::Big { upper: Some(upper), body, .. } => {
                !number(upper) && bases(body).iter().any(|name| given.contains(name.as_str()))
            }
            _ => false,
        });
        general.then(|| "the members of an example may not be meant here".to_owned())
    }

    /// Letters side by side that make a word.
    fn word(&self) -> Option<String> {
        let mut found: Option<String> = None;
        for side in self.sides() {
            walk(side, &mut |part| {
                let Kind::Mul(factors) = &part.kind else { return };
                let letter = |factor: &Expr| match &factor.kind {
                    Kind::Name(name) if name.chars().count() == 1 => Some(name.clone()),
                    Kind::Apply(callee, _) => match &callee.kind {
                        Kind::Name(name) if name.chars().count() == 1 => Some(name.clone()),
                        _ => None,
                    },
                    _ => None,
                };
                let mut run = String::new();
                let mut end = usize::MAX;
                for factor in factors {
                    match letter(factor) {
                        Some(name) if run.is_empty() || factor.span.start == end => run.push_str(&name),
                        Some(name) => run = name,
                        None => run.clear(),
                    }
                    end = factor.span.end;
                    if run.chars().count() >= 5 || speech_word(&run) {
                        found = Some(run.clone());
                    }
                }
            });
        }
        found.map(|word| format!("{word} may be a word"))
    }
}

/// Whether a name stands in formulas outside of one part of them.
fn plain_elsewhere(name: &str, part: &Expr, sides: &[&Expr]) -> bool {
    let count = |expr: &Expr| {
        let mut found = 0;
        walk(expr, &mut |inner| found += usize::from(matches!(&inner.kind, Kind::Name(own) if own == name)));
        found
    };
    sides.iter().map(|side| count(side)).sum::<usize>() > count(part)
}

/// Words that join conditions; nobody multiplies these letters in this order.
fn speech_word(run: &str) -> bool {
    matches!(
        run,
        "or" | "ou"
            | "if"
            | "si"
            | "and"
            | "et"
            | "und"
            | "oder"
            | "sonst"
            | "wenn"
            | "for"
            | "pour"
            | "sinon"
            | "else"
    )
}

fn is_minus_one(exponent: &Expr) -> bool {
    match &exponent.kind {
        Kind::Number(q) => *q == -Rational::from_integer(1.into()),
        Kind::Add(terms) => {
            matches!(terms.as_slice(), [only] if only.sign == crate::formula::Sign::Minus
                && matches!(&only.expr.kind, Kind::Number(q) if *q == Rational::from_integer(1.into())))
        }
        Kind::Group(inner) => is_minus_one(inner),
        Kind::Accent(Accent::Bold, inner) => is_minus_one(inner),
        _ => false,
    }
}

fn number(value: &Value) -> Option<Rational> {
    value.as_rational()
}

/// The value of the last decimal digit of a number: 1/1000 for 1.053.
fn last_digit(q: &Rational) -> Rational {
    let ten = Rational::from_integer(10.into());
    let mut digit = Rational::from_integer(1.into());
    let mut scaled = q.clone();
    for _ in 0..40 {
        if scaled.is_integer() {
            return digit;
        }
        scaled *= &ten;
        digit /= &ten;
    }
    Rational::zero()
}
