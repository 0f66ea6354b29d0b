//! How a document uses its letters.

use std::collections::{BTreeMap, BTreeSet};

use crate::formula::{Accent, BinomialStyle, Expr, Kind, Link, Rel};
use crate::judge::page::statement::{Said, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::written::features::has_column;
use crate::judge::written::names::{Head, bases, is_index_letter, walk};
use crate::language::lexicon::families::{self, Family};
use crate::language::lexicon::roles::{self, is_variable};
use crate::math::number::Rational;

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
    /// Letters of curves and points that are written bold.
    bold: BTreeSet<String>,
    /// Letters with a minus as an index: beside κ_- there is a κ_+, which is no positive part.
    signed: BTreeSet<String>,
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
        let mut nodes = BTreeSet::new();
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
                Said::Object(object) => {
                    nodes.extend(object.nodes().iter().filter_map(Head::of).map(|head| head.base))
                }
                Said::Contact(_) | Said::Triangles(..) | Said::Declaration(..) | Said::Queries(..) => {}
            }
        }
        letters.binomial_family = letters_seen;
        letters.columns = columns;
        // p(0) = f_0: f is the letter of values, if it is applied to nothing.
        let Letters { functions, applied, members, towers, .. } = &mut letters;
        // x_i^{n+1} is a power of the node x_i.
        towers.retain(|name| !nodes.contains(name));
        functions.retain(|name| applied.contains(name) || members.get(name).is_none_or(|count| *count == 0));
        letters
    }

    /// Whether a plain letter is another thing than the curve or the points with this letter, which are bold: the end b of
    /// [a, b], where a curve is **b**.
    pub fn is_beside_bold(&self, expr: &Expr) -> bool {
        matches!(&expr.kind, Kind::Name(letter) if self.bold.contains(letter))
    }

    /// Whether the curve or the points with this letter are written bold.
    pub fn is_bold(&self, letter: &str) -> bool {
        self.bold.contains(letter)
    }

    fn look(&mut self, expr: &Expr) {
        match &expr.kind {
            Kind::Accent(Accent::Bold, inner) => {
                if let Kind::Name(letter) = &inner.kind {
                    self.bold.insert(letter.clone());
                }
            }
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
                if let (Kind::Name(letter), [Expr { kind: Kind::Name(sign), .. }]) =
                    (&base.kind, lower.as_slice())
                    && sign == "minus"
                {
                    self.signed.insert(letter.clone());
                }
                if let Some(head) = Head::of(base) {
                    *self.members.entry(head.base).or_default() += 1;
                }
                self.ratios |= matches!(&base.kind, Kind::Name(name)
                    if matches!(name.as_str(), "h" | "Delta" | "delta" | "u" | "t" | "tau" | "lambda"));
                // b_{00}
                self.from_zero |= lower.iter().any(|index| match &index.kind {
                    Kind::Number(q) => num_traits::Zero::is_zero(q),
                    Kind::Name(word) => word.starts_with('0'),
                    _ => false,
                });
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

    /// Whether a letter has signs as its indices.
    pub fn is_signed(&self, letter: &str) -> bool {
        self.signed.contains(letter)
    }

    /// Whether some letter has signs as its indices.
    pub fn has_signed(&self) -> bool {
        !self.signed.is_empty()
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

    /// The number of the first row of a matrix with named entries: 0, where some index is 0.
    pub fn first_row(&self) -> i64 {
        i64::from(!self.from_zero)
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
