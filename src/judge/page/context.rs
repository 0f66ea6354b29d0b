//! What names mean, and where: the definitions and conditions met so far.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::page::letters::Letters;
use crate::judge::page::object::Declared;
use crate::judge::page::statement::{Contact, Place};
use crate::judge::written::names::{Head, bases};
use crate::language::lexicon::families;
use crate::language::lexicon::roles;
pub(crate) use crate::language::lexicon::roles::is_variable;
use crate::language::value::Value;
use crate::math::number::Rational;

/// What a name stands for.
#[derive(Clone, Debug)]
pub enum Body {
    /// The right-hand side as written.
    Formula(Expr),
    /// A value found by comparing coefficients.
    Value(Value),
}

/// A definition met in the notes.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Its left-hand side.
    pub head: Head,
    /// Its right-hand side.
    pub body: Body,
    /// Conditions said with it.
    pub conditions: Vec<Expr>,
    /// Where it was given.
    pub place: Place,
    /// The line, for reports.
    pub line: usize,
    /// Whether it is assumed, for its paragraph only.
    pub assumed: bool,
    /// What says it.
    pub source: Source,
}

/// What says a definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The page, as it is read.
    Page,
    /// The page, which gives it and does not claim it: let b_3 = 11.
    Given,
    /// A declaration for the judge.
    Declaration,
    /// A query; the items of a list there are counted from 0.
    Query,
}

impl Source {
    /// Whether the text of the page says it.
    pub fn is_text(self) -> bool {
        matches!(self, Source::Page | Source::Given)
    }
}

/// A condition on names, such as α + β + γ = 1.
#[derive(Clone, Debug)]
pub struct Condition {
    /// As written.
    pub expr: Expr,
    /// Whether it is assumed, for its paragraph only.
    pub assumed: bool,
    /// Where.
    pub place: Place,
    /// The line, for reports.
    pub line: usize,
    /// For which indices it is said.
    pub ranges: Vec<Expr>,
}

/// Everything known at a place of the notes.
#[derive(Clone, Debug, Default)]
pub struct Context {
    /// In the order they were met.
    pub definitions: Vec<Definition>,
    /// In the order they were met.
    pub conditions: Vec<Condition>,
    /// What words say that names stand for, in the order they were met.
    pub objects: Vec<Declared>,
    /// What was only named or supposed, in the order it was met: x_0, …, x_n; t = 1/2.
    pub heard: Vec<(Place, Rc<Expr>)>,
    /// The paragraphs with words that are not understood.
    pub unread: BTreeSet<u32>,
    /// What words said of functions that agree.
    pub contacts: Vec<(Place, Contact)>,
    /// How letters are used in the whole document.
    pub letters: Letters,
    /// The numbers of the definitions and of the objects of each letter.
    named: HashMap<String, [Vec<usize>; 2]>,
    /// What was last looked up: a chain asks for the same letters thousands of times.
    seen: RefCell<Seen>,
}

/// The numbers of the definitions visible from a place, by their letters, each with whether it is near.
#[derive(Clone, Debug, Default)]
struct Seen {
    place: Option<Place>,
    letters: HashMap<String, Rc<[(usize, bool)]>>,
    /// The number of the object of each way to write a name.
    objects: HashMap<Shape, Option<usize>>,
}

/// What decides which object a name is: its letter, the numbers among its indices, whether it is called.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Shape {
    base: String,
    lower: Vec<Option<Rational>>,
    upper: usize,
    called: bool,
}

impl Shape {
    fn of(head: &Head) -> Self {
        Shape {
            base: head.base.clone(),
            lower: head.lower.iter().map(|index| index.as_number().cloned()).collect(),
            upper: head.upper.len(),
            called: head.arguments.is_some(),
        }
    }
}

/// How much was known at some time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark([usize; 3]);

impl Mark {
    /// So many definitions were known.
    pub fn definitions(self) -> usize {
        self.0[0]
    }

    /// So many conditions were known.
    pub fn conditions(self) -> usize {
        self.0[1]
    }
}

impl Definition {
    /// Whether it is made of nothing but its own indices and arguments: t_j = j.
    pub fn is_datum(&self) -> bool {
        let own: BTreeSet<String> = self.head.lower.iter().chain(self.head.flat()).flat_map(bases).collect();
        matches!(&self.body, Body::Formula(body) if bases(body).is_subset(&own))
    }

    /// The number that it gives to a name without indices: n = 3.
    pub fn number(&self) -> Option<&Expr> {
        let head = &self.head;
        match &self.body {
            Body::Formula(body)
                if matches!(body.kind, Kind::Number(_))
                    && head.arguments.is_none()
                    && head.lower.is_empty()
                    && head.upper.is_empty() =>
            {
                Some(body)
            }
            _ => None,
        }
    }

    /// Whether it says of two names, and of no family, that they are the same: h_0 = h_1.
    fn equates_names(&self) -> bool {
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        let Body::Formula(body) = &self.body else { return false };
        let other = Head::of(body).filter(|other| other.arguments.is_none() && other.upper.is_empty());
        self.head.arguments.is_none()
            && self.head.upper.is_empty()
            && self.head.lower.iter().all(number)
            && other.is_some_and(|other| other.base == self.head.base && other.lower.iter().all(number))
    }

    /// Whether its formula uses a letter as an index of other families only: x_n = b_n/a_nn, not H_n = Σ_{k=1}^n 1/k.
    pub fn is_of_members(&self, letter: &str) -> bool {
        fn outside(expr: &Expr, letter: &str) -> bool {
            match &expr.kind {
                Kind::Name(name) => name == letter,
                Kind::Subscript(..) | Kind::Upper(..) => false,
                _ => {
                    let mut found = false;
                    expr.for_each_child(&mut |child| found = found || outside(child, letter));
                    found
                }
            }
        }
        matches!(&self.body, Body::Formula(body) if bases(body).contains(letter) && !outside(body, letter))
            && !self.is_recursive()
    }

    /// Whether its formula speaks of what it defines.
    pub fn is_recursive(&self) -> bool {
        matches!(&self.body, Body::Formula(body) if bases(body).contains(&self.head.base))
    }
}

/// The name and the value without names that an equation gives it: u = 5/2.
pub(in crate::judge) fn value_given(equation: &Expr) -> Option<(&str, &Expr)> {
    let Kind::Chain(left, links) = &equation.kind else { return None };
    match (&left.kind, links.as_slice()) {
        (Kind::Name(name), [link]) if link.rel == Rel::Eq && bases(&link.expr).is_empty() => {
            Some((name.as_str(), &link.expr))
        }
        _ => None,
    }
}

/// Whether an equation is one about some names and nothing else: p = 2, a + b = 1.
pub(in crate::judge) fn is_only_about(equation: &Expr, names: &[String]) -> bool {
    let equates =
        matches!(&equation.kind, Kind::Chain(_, links) if links.iter().all(|link| link.rel == Rel::Eq));
    let mut letters = bases(equation).into_iter().peekable();
    equates && letters.peek().is_some() && letters.all(|letter| names.contains(&letter))
}

impl Context {
    /// Nothing known but how letters are used.
    pub fn new(letters: Letters) -> Self {
        Context { letters, ..Context::default() }
    }

    /// The number that the paragraph gives to a name.
    pub fn number_in<'a>(&'a self, name: &'a str, place: &'a Place) -> Option<&'a Expr> {
        let (_, definition, _) = self.visible(name, place).next()?;
        definition.number().filter(|_| definition.place.group == place.group)
    }

    /// b_{10} is b_{1,0}, where the page has b_{00}, too; B_{111}^3 is B_{1,1,1}^3.
    pub fn with_pairs_apart(&self, mut head: Head) -> Head {
        let triangular = || {
            let degree = head.upper.first().and_then(Expr::as_int);
            families::notation(&head.base, 3, head.upper.len()).is_some()
                && head
                    .lower
                    .first()
                    .and_then(Expr::as_int)
                    .filter(|index| (100..1000).contains(index))
                    .is_some_and(|index| {
                        degree.is_some_and(|degree| index / 100 + index / 10 % 10 + index % 10 == degree)
                    })
        };
        if let [Expr { kind: Kind::Number(q), span }] = head.lower.as_slice()
            && (self.letters.pairs.contains(&head.base) || triangular())
            && let Some(number) = q.is_integer().then(|| q.to_string()).filter(|digits| digits.len() > 1)
        {
            let digits = number.bytes().filter(u8::is_ascii_digit);
            let digit = |digit: u8| Expr::new(Expr::int(i64::from(digit - b'0')).kind, *span);
            head.lower = digits.map(digit).collect();
        }
        head
    }

    /// The variables of the function of which x_u, x_{uv} is a partial derivative: u is one of several of them.
    pub fn variables_of_partial(&self, head: &Head, place: &Place) -> Option<Vec<String>> {
        let [index] = head.lower.as_slice() else { return None };
        let letters = crate::judge::written::names::bases(index);
        self.visible(&head.base, place).find_map(|(_, definition, near)| {
            let flat = definition.head.flat();
            let own: Vec<String> = flat.iter().filter_map(|e| Head::of(e)).map(|h| h.base).collect();
            let partial = !letters.is_empty() && letters.iter().all(|letter| own.contains(letter));
            (near && definition.head.lower.is_empty() && own.len() > 1 && partial).then_some(own)
        })
    }

    /// Whether a letter alone, without indices and arguments, has a meaning of its own.
    pub fn is_named_alone(&self, base: &str, place: &Place) -> bool {
        let alone = |head: &Head| head.is_bare();
        self.visible(base, place).any(|(_, own, _)| alone(&own.head))
    }

    /// Adds a definition.
    pub fn define(&mut self, mut definition: Definition) {
        self.seen.take();
        definition.head = self.with_pairs_apart(definition.head);
        let base = definition.head.base.clone();
        self.named.entry(base).or_default()[0].push(self.definitions.len());
        self.definitions.push(definition);
    }

    /// The same with some of its definitions and objects only.
    fn with_only(
        &self,
        definitions: impl Fn(&Definition) -> bool,
        objects: impl Fn(&Declared) -> bool,
    ) -> Context {
        let mut other = Context {
            definitions: Vec::new(),
            objects: Vec::new(),
            named: HashMap::new(),
            seen: RefCell::default(),
            ..self.clone()
        };
        self.definitions.iter().filter(|own| definitions(own)).for_each(|own| other.define(own.clone()));
        self.objects.iter().filter(|own| objects(own)).for_each(|own| other.declare(own.clone()));
        other
    }

    /// The same without what words say of some names.
    pub fn without_objects(&self, names: &[String]) -> Context {
        let spoken = |own: &Declared| {
            own.object.names.iter().filter_map(Head::of).any(|head| names.contains(&head.base))
        };
        self.with_only(|_| true, |own| !spoken(own))
    }

    /// The same without the definitions of some names.
    pub fn without(&self, names: &[String]) -> Context {
        self.with_only(|own| !names.contains(&own.head.base), |_| true)
    }

    /// The same without the values and closed formulas of some names, as an example gives them.
    pub fn without_examples(&self, names: &[String]) -> Context {
        let example = |own: &Definition| match &own.body {
            Body::Formula(body) => {
                // p(t) = t^2, b_1 = b_0
                let variables: BTreeSet<String> =
                    own.head.flat().into_iter().chain(&own.head.lower).flat_map(bases).collect();
                let known = |name: &String| variables.contains(name) || names.contains(name);
                // A recursion is no example.
                let recursive = own.head.lower.iter().any(|index| !bases(index).is_empty())
                    && bases(body).contains(&own.head.base);
                names.contains(&own.head.base) && !recursive && bases(body).iter().all(known)
            }
            Body::Value(_) => names.contains(&own.head.base),
        };
        let mut other = self.with_only(|own| !example(own), |_| true);
        other.conditions.retain(|own| !is_only_about(&own.expr, names));
        other.heard.retain(|(_, own)| !is_only_about(own, names));
        other
    }

    /// Adds what words say that names stand for.
    pub fn declare(&mut self, declared: Declared) {
        self.seen.take();
        let bases: BTreeSet<String> =
            declared.object.names.iter().filter_map(|name| Some(Head::of(name)?.base)).collect();
        for base in bases {
            self.named.entry(base).or_default()[1].push(self.objects.len());
        }
        self.objects.push(declared);
    }

    /// Keeps what is only named or supposed.
    pub fn hear(&mut self, expr: &Expr, place: &Place) {
        self.heard.push((place.clone(), Rc::new(expr.clone())));
    }

    /// The intervals in the paragraph of a place, with the numbers of their formulas, and which of their ends are open.
    pub fn intervals_beside(
        &self,
        place: &Place,
    ) -> impl DoubleEndedIterator<Item = (usize, [&Expr; 2], [bool; 2])> {
        let beside = self.heard.iter().filter(|(other, _)| other.group == place.group);
        beside.filter_map(|(other, expr)| interval(expr).map(|(ends, open)| (other.formula, ends, open)))
    }

    /// The values that names were said to have at some places: τ = 5/2.
    pub fn values_heard(&self, here: impl Fn(&Place) -> bool) -> impl Iterator<Item = (&str, &Expr)> {
        self.heard.iter().filter(move |(place, _)| here(place)).filter_map(|(_, expr)| value_given(expr))
    }

    /// The sizes that were named at some places, each with its number: n = 2.
    pub fn sizes_heard(&self, here: impl Fn(&Place) -> bool) -> impl Iterator<Item = (&str, i64)> {
        let sizes = self.values_heard(here).filter(|(name, _)| roles::is_degree(name));
        sizes.filter_map(|(name, value)| Some((name, value.as_int()?)))
    }

    /// The first and the last number of the members of a letter, as the page lists them last.
    pub fn listed(&self, letter: &str, place: &Place) -> Option<(Expr, Expr)> {
        let index = |expr: &Expr| Head::of(expr).filter(|head| head.base == letter)?.index().cloned();
        let ends = |other: &Place, items: &[&Expr]| {
            let listed = place.knows(other, false) && items.iter().any(|item| item.kind == Kind::Ellipsis);
            let (first, last) = (items.first()?, items.last()?);
            listed.then_some((other.formula, (index(first)?, index(last)?)))
        };
        let object =
            self.objects.iter().rev().find_map(|declared| {
                ends(&declared.place, &declared.object.names.iter().collect::<Vec<_>>())
            });
        let heard = self.heard.chunk_by(|(a, _), (b, _)| a.formula == b.formula).rev().find_map(|items| {
            let named = items.iter().map(|(_, item)| &**item);
            let named = named.filter(|item| !matches!(item.kind, Kind::Chain(..)));
            ends(&items[0].0, &named.collect::<Vec<_>>())
        });
        let named = object.into_iter().chain(heard).max_by_key(|(formula, _)| *formula).map(|(_, ends)| ends);
        // x_j = x_0 + jh for j = 0, …, n
        named.or_else(|| {
            self.visible(letter, place).find_map(|(_, definition, _)| {
                let [index] = definition.head.lower.as_slice() else { return None };
                definition.conditions.iter().find_map(|condition| match &condition.kind {
                    Kind::Chain(own, links) if own.same_as(index) => match &links.as_slice() {
                        [link] => match &link.expr.kind {
                            Kind::Range(from, to) => Some((from.as_ref().clone(), to.as_ref().clone())),
                            _ => None,
                        },
                        _ => None,
                    },
                    _ => None,
                })
            })
        })
    }

    /// How much is known now.
    pub fn mark(&self) -> Mark {
        Mark([self.definitions.len(), self.conditions.len(), self.objects.len()])
    }

    /// Puts another formula into a definition.
    pub fn replace(&mut self, number: usize, formula: Expr) {
        self.seen.take();
        self.definitions[number].body = Body::Formula(formula);
    }

    /// Forgets what was learnt since then.
    pub fn forget(&mut self, since: Mark) {
        let Mark([definitions, conditions, objects]) = since;
        if self.definitions.len() > definitions || self.objects.len() > objects {
            self.seen.take();
            self.named.retain(|_, [own, others]| {
                own.retain(|&number| number < definitions);
                others.retain(|&number| number < objects);
                !own.is_empty() || !others.is_empty()
            });
        }
        self.definitions.truncate(definitions);
        self.conditions.truncate(conditions);
        self.objects.truncate(objects);
    }

    fn spoken(&self, base: &str) -> impl DoubleEndedIterator<Item = &Declared> + Clone {
        let numbers = self.named.get(base).map_or(&[][..], |[_, numbers]| numbers);
        numbers.iter().rev().map(|&number| &self.objects[number])
    }

    /// The objects of a letter, the latest first.
    pub fn objects_of(&self, base: &str) -> impl DoubleEndedIterator<Item = &Declared> + Clone {
        self.spoken(base).filter(|declared| !declared.object.is_size())
    }

    /// What `find` says of a head at a place, or what it said of the last one that was written alike there.
    pub(super) fn remembered(
        &self,
        head: &Head,
        place: &Place,
        find: impl FnOnce() -> Option<usize>,
    ) -> Option<&Declared> {
        let shape = Shape::of(head);
        let here = |seen: &Seen| seen.place.as_ref() == Some(place);
        let known = Some(&*self.seen.borrow())
            .filter(|seen| here(seen))
            .and_then(|seen| seen.objects.get(&shape).copied());
        let number = known.unwrap_or_else(|| {
            let number = find();
            let mut seen = self.seen.borrow_mut();
            if !here(&seen) {
                *seen = Seen { place: Some(place.clone()), ..Seen::default() };
            }
            seen.objects.insert(shape, number);
            number
        });
        number.map(|number| &self.objects[number])
    }

    /// The objects of a letter with their numbers, the latest first.
    pub(super) fn numbered_objects(&self, base: &str) -> impl Iterator<Item = (usize, &Declared)> + Clone {
        let numbers = self.named.get(base).map_or(&[][..], |[_, numbers]| numbers);
        let all = numbers.iter().rev().map(|&number| (number, &self.objects[number]));
        all.filter(|(_, declared)| !declared.object.is_size())
    }

    /// Where words say that a letter is a degree or an order, the latest first.
    pub fn sizes_of(&self, base: &str) -> impl Iterator<Item = &Declared> {
        self.spoken(base).filter(|declared| declared.object.is_size())
    }

    /// The definitions of a letter visible from a place, the nearest and latest first: their numbers,
    /// and whether they stand in the same section, example or quotation, or one around it.
    pub fn visible(&self, base: &str, place: &Place) -> impl Iterator<Item = (usize, &Definition, bool)> {
        let found = self.seen(base, place);
        (0..found.len()).map(move |at| {
            let (number, near) = found[at];
            (number, &self.definitions[number], near)
        })
    }

    /// As found the last time from this place, or anew: O(definitions of the letter).
    fn seen(&self, base: &str, place: &Place) -> Rc<[(usize, bool)]> {
        let mut seen = self.seen.borrow_mut();
        if seen.place.as_ref() != Some(place) {
            *seen = Seen { place: Some(place.clone()), ..Seen::default() };
        } else if let Some(found) = seen.letters.get(base) {
            return found.clone();
        }
        let numbers = self.named.get(base).map_or(&[][..], |[numbers, _]| numbers);
        let alive = numbers.iter().rev().filter(|&&number| {
            let definition = &self.definitions[number];
            place.in_reach(&definition.place, definition.assumed) && !place.frees(base, &definition.place)
        });
        let (close, far): (Vec<usize>, Vec<usize>) =
            alive.copied().partition(|&number| place.sees(&self.definitions[number].place));
        let close = close
            .into_iter()
            .filter(|&number| !self.is_any_since(base, &self.definitions[number].place, place));
        let mut found: Vec<(usize, bool)> = close.map(|number| (number, true)).collect();
        let far = far.into_iter().filter(|&number| {
            let definition = &self.definitions[number];
            matches!(definition.body, Body::Formula(_))
                && !definition.equates_names()
                && !self.is_spoken_of_anew(base, &definition.place, place)
        });
        found.extend(far.map(|number| (number, false)));
        let found: Rc<[(usize, bool)]> = found.into();
        seen.letters.insert(base.to_owned(), found.clone());
        found
    }
}
