//! What names mean, and where: the definitions and conditions met so far.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

use super::features::has_column;
use super::names::{Head, bases, is_index_letter, walk};
use super::object::Declared;
use super::statement::{Contact, Place, Said, Statement};
use super::topic::Topic;
use crate::formula::{BinomialStyle, Expr, Kind, Link, Rel, interval};
use crate::language::lexicon::families::{self, Family};
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
}

/// How much was known at some time.
#[derive(Clone, Copy, Debug, Default)]
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

/// How letters are used in a document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Letters {
    /// Letters that are applied to arguments like functions.
    pub functions: BTreeSet<String>,
    /// Those of them of which the document shows it.
    applied: BTreeSet<String>,
    /// How often letters stand with an index and without arguments.
    members: BTreeMap<String, i64>,
    /// Letters of which members stand in the arguments of calls: t in f(t_1, t_2).
    arguments: BTreeSet<String>,
    /// Whether the document speaks of polar forms.
    polar_forms: bool,
    /// Letters whose index 10 means 1, 0, because there is an index 00 or 01 or 011, too.
    pub pairs: BTreeSet<String>,
    /// Letters with an upper index that is no power: b_i^r.
    pub towers: BTreeSet<String>,
    /// Whether members of a family B stand in an equation with binomial coefficients.
    pub binomial_family: bool,
    /// The lengths of the intervals between numbers.
    lengths: BTreeSet<Rational>,
    /// Whether lengths or ratios of intervals have names: h_0, Δ_1, u_1 - u_0.
    ratios: bool,
    /// Whether some family is numbered from 0.
    from_zero: bool,
    /// The least number of a B-spline in a sum over them: 1 in Σ_{i=1}^m d_i N_{i,2}.
    first_spline: Option<i64>,
    /// The first and last number and the degree, or order, of B-splines in sums over them.
    pub spline_sums: BTreeSet<[i64; 3]>,
    /// The letters of points and the degree, or order, of B-splines in sums over them.
    pub spline_points: BTreeSet<(String, i64)>,
    /// The degrees, or orders, of B-splines.
    pub spline_sizes: BTreeSet<i64>,
    /// Whether somewhere the degree is the first, or the second index of B_{a,b}, as the letters tell.
    degrees: [bool; 2],
    /// Whether points are written as what looks like binomial coefficients.
    columns: bool,
}

impl Definition {
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

/// Whether a member of a family with the notation of Bernstein polynomials stands in a formula.
fn has_bernstein(expr: &Expr) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        found |= Head::of(part).is_some_and(|head| head.is_bernstein());
    });
    found
}

fn has_factorials(expr: &Expr) -> bool {
    let mut found = false;
    walk(expr, &mut |part| found |= matches!(part.kind, Kind::Binomial(..) | Kind::Factorial(_)));
    found
}

/// Whether a name is given a value that nobody writes as a binomial coefficient: b_1 = \binom{1}{3} is a point.
fn gives_a_column(name: &Expr, value: &Expr) -> bool {
    let column = matches!(&value.kind, Kind::Binomial(_, _, BinomialStyle::Stacked)) && has_column(value);
    column && Head::of(name).is_some()
}

impl Letters {
    /// Whether something above something is a point: no index stands in it.
    pub fn is_column(&self, x: &Expr, y: &Expr) -> bool {
        self.columns && [x, y].iter().all(|part| !bases(part).iter().any(|name| is_index_letter(name)))
    }

    /// Whether members of a letter stand in the arguments of calls: t_1 in f(t_1, t_2).
    pub fn is_argument(&self, letter: &str) -> bool {
        self.arguments.contains(letter)
    }

    /// Whether a letter stands with an index and without arguments: b_i.
    pub fn has_members(&self, letter: &str) -> bool {
        self.members.get(letter).is_some_and(|count| *count > 0)
    }

    /// Whether points are written as what looks like binomial coefficients.
    pub fn has_columns(&self) -> bool {
        self.columns
    }

    /// Looks through all formulas.
    pub fn of(statements: &[Statement]) -> Self {
        let mut letters = Letters {
            functions: roles::NAMED_FUNCTIONS.iter().map(|name| (*name).to_owned()).collect(),
            ..Letters::default()
        };
        letters.polar_forms = statements.iter().any(|statement| statement.topics.has(Topic::PolarForm));
        let (mut letters_seen, mut columns) = (false, false);
        let mut look = |expr: &Expr| {
            walk(expr, &mut |part| letters.look(part));
        };
        for statement in statements {
            match &statement.said {
                Said::Chain(chain) => {
                    let sides = || chain.sides.iter().map(|side| &side.expr);
                    letters_seen |= sides().any(has_bernstein) && sides().any(has_factorials);
                    let pairs = || chain.sides.windows(2);
                    columns |= pairs().any(|pair| gives_a_column(&pair[0].expr, &pair[1].expr));
                    sides().for_each(&mut look);
                }
                Said::Condition(side) | Said::Bare(side, _) => look(&side.expr),
                Said::Object(_)
                | Said::Contact(_)
                | Said::Triangles(..)
                | Said::Declaration(..)
                | Said::Queries(..) => {}
            }
        }
        letters.binomial_family = letters_seen;
        letters.columns = columns;
        // p(0) = f_0: f is the letter of values, if it is applied to nothing.
        let Letters { functions, applied, members, .. } = &mut letters;
        functions.retain(|name| applied.contains(name) || members.get(name).is_none_or(|count| *count == 0));
        letters
    }

    fn look(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Apply(callee, groups) => {
                for argument in groups.iter().flatten() {
                    walk(argument, &mut |part| {
                        let member = Head::of(part).filter(|head| !head.lower.is_empty());
                        self.arguments.extend(member.map(|head| head.base));
                    });
                }
                let Some(head) = Head::of(callee) else { return };
                if head.is_a(Family::Spline) {
                    let size = head.upper.last().or(head.lower.get(1));
                    self.spline_sizes.extend(size.and_then(Expr::as_int));
                }
                let marked = matches!(callee.kind, Kind::Accent(..));
                if roles::is_factor(&head.base) && head.lower.is_empty() && !marked {
                    return;
                }
                if !head.lower.is_empty() {
                    *self.members.entry(head.base.clone()).or_default() -= 1;
                }
                let flat: Vec<&Expr> = groups.iter().flatten().collect();
                let variable = |expr: &Expr| {
                    Head::of(expr).is_some_and(|head| {
                        head.arguments.is_none() && head.upper.is_empty() && is_variable(&head.base)
                    })
                };
                let number = |expr: &Expr| matches!(expr.kind, Kind::Number(_) | Kind::Div(..));
                if flat.len() > 1 || flat.iter().any(|argument| variable(argument) || number(argument)) {
                    self.applied.insert(head.base.clone());
                    self.functions.insert(head.base);
                }
            }
            Kind::List(ends) => {
                if let [Expr { kind: Kind::Number(from), .. }, Expr { kind: Kind::Number(to), .. }] =
                    ends.as_slice()
                {
                    self.lengths.insert(to - from);
                }
            }
            Kind::Subscript(base, lower) => {
                if let Some(head) = Head::of(base) {
                    *self.members.entry(head.base).or_default() += 1;
                }
                self.ratios |= matches!(&base.kind, Kind::Name(name)
                    if matches!(name.as_str(), "h" | "Delta" | "delta" | "u" | "t" | "tau" | "lambda"));
                self.from_zero |= lower
                    .iter()
                    .any(|index| matches!(&index.kind, Kind::Number(q) if num_traits::Zero::is_zero(q)));
                if let (Kind::Name(letter), [first, second]) = (&base.kind, lower.as_slice())
                    && families::notation(letter, 2, 0).is_some_and(|known| known.family == Family::Bernstein)
                {
                    let size = |index: &Expr| bases(index).iter().any(|name| roles::is_degree(name));
                    match (size(first), size(second)) {
                        (true, false) => self.degrees[0] = true,
                        (false, true) => self.degrees[1] = true,
                        _ => {}
                    }
                }
                let letters = |index: &Expr| {
                    matches!(&index.kind, Kind::Mul(factors)
                    if factors.iter().all(|f| matches!(&f.kind, Kind::Name(name) if is_index_letter(name))))
                };
                let digits = |index: &Expr| {
                    matches!(&index.kind, Kind::Name(word)
                    if word.len() > 1 && word.starts_with('0'))
                };
                if let [index] = lower.as_slice()
                    && (letters(index) || digits(index))
                    && let Some(head) = Head::of(base)
                {
                    self.pairs.insert(head.base);
                }
            }
            Kind::Big { lower, upper, body, .. } => {
                if let [Expr { kind: Kind::Chain(index, links), .. }] = lower.as_slice()
                    && let [Link { rel: Rel::Eq, expr: from, .. }] = links.as_slice()
                    && let Some(from) = from.as_int()
                {
                    walk(body, &mut |part| {
                        let Some(head) = Head::of(part).filter(|head| head.is_a(Family::Spline)) else {
                            return;
                        };
                        let indices: Vec<&Expr> = head.lower.iter().chain(&head.upper).collect();
                        let [own, size] = indices[..] else { return };
                        if !own.same_as(index) {
                            return;
                        }
                        self.first_spline = Some(self.first_spline.map_or(from, |first| first.min(from)));
                        if let (Some(to), Some(size)) =
                            (upper.as_ref().and_then(|to| to.as_int()), size.as_int())
                        {
                            self.spline_sums.insert([from, to, size]);
                        }
                    });
                }
            }
            Kind::Mul(factors) => {
                let heads: Vec<Head> = factors.iter().filter_map(Head::of).collect();
                let spline = heads.iter().find(|head| head.is_a(Family::Spline));
                let size = spline.and_then(|head| head.upper.last().or(head.lower.get(1))?.as_int());
                let points = heads.iter().filter(|head| head.arguments.is_none() && head.index().is_some());
                self.spline_points.extend(
                    size.into_iter()
                        .flat_map(|size| points.clone().map(move |head| (head.base.clone(), size))),
                );
            }
            Kind::Pow(base, upper) => {
                // b_i^{r-1} beside b_i^r is a point of the algorithm of de Casteljau.
                if let Kind::Subscript(..) = &base.kind
                    && let Some(head) = Head::of(base)
                    && matches!(&upper.kind, Kind::Add(terms) if terms.len() == 2
                        && matches!(terms[0].expr.kind, Kind::Name(_))
                        && matches!(terms[1].expr.kind, Kind::Number(_)))
                {
                    self.towers.insert(head.base);
                }
            }
            _ => {}
        }
    }

    /// Whether the degree is the first index of B_{a,b}, if the letters of the page tell.
    pub fn degree_first(&self) -> Option<bool> {
        match self.degrees {
            [true, false] => Some(true),
            [false, true] => Some(false),
            _ => None,
        }
    }

    /// Whether the page speaks of no intervals of different lengths.
    pub fn has_one_length(&self) -> bool {
        self.lengths.len() < 2 && !self.ratios
    }

    /// Whether an f with several arguments may be the polar form of F, as far as the page as a whole tells.
    pub fn may_have_polar_form(&self, capital: &str) -> bool {
        self.polar_forms || self.is_function(capital)
    }

    /// Whether the page speaks of polar forms.
    pub fn speaks_of_polar_forms(&self) -> bool {
        self.polar_forms
    }

    /// The number of the first of some knots that are listed without names.
    pub fn first_knot(&self) -> Option<i64> {
        self.first_spline.or_else(|| self.from_zero.then_some(0))
    }

    /// Whether a letter is applied like a function.
    pub fn is_function(&self, base: &str) -> bool {
        self.functions.contains(base)
    }
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
        let letters = super::names::bases(index);
        self.visible(&head.base, place).find_map(|(_, definition, near)| {
            let flat = definition.head.flat();
            let own: Vec<String> = flat.iter().filter_map(|e| Head::of(e)).map(|h| h.base).collect();
            let partial = !letters.is_empty() && letters.iter().all(|letter| own.contains(letter));
            (near && definition.head.lower.is_empty() && own.len() > 1 && partial).then_some(own)
        })
    }

    /// Adds a definition.
    pub fn define(&mut self, mut definition: Definition) {
        self.seen.take();
        definition.head = self.with_pairs_apart(definition.head);
        let base = definition.head.base.clone();
        self.named.entry(base).or_default()[0].push(self.definitions.len());
        self.definitions.push(definition);
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
        self.heard.iter().filter(move |(place, _)| here(place)).filter_map(|(_, expr)| {
            let Kind::Chain(left, links) = &expr.kind else { return None };
            match (&left.kind, links.as_slice()) {
                (Kind::Name(name), [link]) if link.rel == Rel::Eq && bases(&link.expr).is_empty() => {
                    Some((name.as_str(), &link.expr))
                }
                _ => None,
            }
        })
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
            *seen = Seen { place: Some(place.clone()), letters: HashMap::new() };
        } else if let Some(found) = seen.letters.get(base) {
            return found.clone();
        }
        let numbers = self.named.get(base).map_or(&[][..], |[numbers, _]| numbers);
        let alive = numbers.iter().rev().filter(|&&number| {
            let definition = &self.definitions[number];
            place.in_reach(&definition.place, definition.assumed)
        });
        let (close, far): (Vec<usize>, Vec<usize>) =
            alive.copied().partition(|&number| place.sees(&self.definitions[number].place));
        let mut found: Vec<(usize, bool)> = close.into_iter().map(|number| (number, true)).collect();
        let far = far.into_iter().filter(|&number| {
            let definition = &self.definitions[number];
            matches!(definition.body, Body::Formula(_))
                && !self.is_spoken_of_anew(base, &definition.place, place)
        });
        found.extend(far.map(|number| (number, false)));
        let found: Rc<[(usize, bool)]> = found.into();
        seen.letters.insert(base.to_owned(), found.clone());
        found
    }
}
