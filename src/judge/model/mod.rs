//! One instance of a statement: every name has a meaning in it.
//!
//! A model says what the names of a statement stand for when its integers have values: the
//! definitions of the notes, standard meanings, and for functions that nobody defined polynomials
//! with symbols as coefficients. It is a [`Reading`]: what it has no opinion on is left to the
//! evaluator of the language.

mod arguments;
mod calls;
mod definitions;
mod derivatives;
mod dots;
mod dotted_arguments;
mod families;
mod functionals;
mod lists;
mod notations;
mod objects;
mod piecewise;
mod polynomials;
mod spline;
mod steps;
mod symmetric;
mod tensor;

pub(in crate::judge) use functionals::applies;

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use crate::formula::{BinomialStyle, Expr, Kind, Rel, Sign, Term, interval};
use crate::judge::page::context::{Context, Definition};
use crate::judge::page::statement::{Curve, Place};
use crate::judge::values::roots;
use crate::judge::written::names::{Head, symbol_of};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Machine, Reading};
use crate::language::lexicon::{letters, roles};
use crate::language::ops::arithmetic;
use crate::language::value::Value;
use crate::math::number::{Rational, rational};
use crate::math::poly::{Fraction, Index, MultiPoly, Symbol};
use num_traits::Zero;

type Evaluated = Result<Value, Diagnostic>;

/// How many terms a sum without bounds is given.
pub const FREE_TERMS: i64 = 3;

/// Notations that are read one way or another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Choices {
    /// C_n^i has its total above (C_i^n in other books).
    pub total_above: bool,
    /// B_{i,n} has its degree first.
    pub degree_first: bool,
    /// f^k(t) is a power, not a derivative.
    pub powers: bool,
    /// Only definitions of the same section are used.
    pub near_only: bool,
    /// N_i^k has degree k, not order k.
    pub spline_degree: bool,
    /// t_1 t_2 + … + t_4 t_5 has all products of two, not only those of neighbours.
    pub all_products: bool,
    /// q(2t - 1), where the page says q = x^2 - 1, is a value and no product.
    pub applied: bool,
    /// The formula is about functions in general: those defined elsewhere by one formula are not
    /// meant.
    pub general: bool,
    /// Points are read as one of their coordinates, which has this number among so many.
    pub coordinate: Option<(usize, usize)>,
}

impl Choices {
    /// Whether points with so many coordinates are read as one of them.
    pub fn reads(&self, coordinates: usize) -> bool {
        self.coordinate.is_some_and(|(_, count)| count == coordinates)
    }

    /// The reading of a notation.
    pub fn reading(&mut self, ambiguity: Ambiguity) -> &mut bool {
        match ambiguity {
            Ambiguity::Binomial => &mut self.total_above,
            Ambiguity::Bernstein => &mut self.degree_first,
            Ambiguity::Power => &mut self.powers,
            Ambiguity::Spline => &mut self.spline_degree,
            Ambiguity::Dots => &mut self.all_products,
            Ambiguity::Applied => &mut self.applied,
        }
    }
}

/// What happened during an evaluation.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// Numbers of arguments polar forms were called with.
    pub arities: BTreeSet<usize>,
    /// Whether a degree was needed that nothing fixes.
    pub wants_degree: bool,
    /// Definitions that were used, and whether they stand near.
    pub definitions: BTreeSet<(usize, bool)>,
    /// Functions without a definition.
    pub unknown: BTreeSet<String>,
    /// Functions without a definition that are tied to their polar forms.
    pub paired: BTreeSet<String>,
    /// Meanings assumed.
    pub standard: BTreeSet<String>,
    /// Names that stand for anything of a kind: any matrix, any polynomial of a degree.
    pub generic: BTreeSet<String>,
    /// Notations with several readings that occurred.
    pub ambiguous: BTreeSet<Ambiguity>,
    /// A curve was given another number of control points than its degree asks for.
    pub mixed: bool,
    /// Whether an infinite sum was cut.
    pub infinite: bool,
    /// Whether a sum without bounds was given some.
    pub unbounded: bool,
    /// Whether a polar form had dots without a count among its arguments.
    pub flexible: bool,
    /// Whether matrices occurred of which nothing more is said.
    pub matrices: bool,
    /// Whether knots occurred that nothing gives.
    pub any_knots: bool,
    /// Whether Bernstein polynomials occurred: their parameters run from 0 to 1.
    pub unit: bool,
}

impl Record {
    /// Adds what happened in another evaluation.
    pub fn merge(&mut self, other: &Record) {
        self.arities.extend(&other.arities);
        self.definitions.extend(&other.definitions);
        self.unknown.extend(other.unknown.iter().cloned());
        self.paired.extend(other.paired.iter().cloned());
        self.standard.extend(other.standard.iter().cloned());
        self.generic.extend(other.generic.iter().cloned());
        self.ambiguous.extend(&other.ambiguous);
        self.wants_degree |= other.wants_degree;
        self.mixed |= other.mixed;
        self.infinite |= other.infinite;
        self.unbounded |= other.unbounded;
        self.flexible |= other.flexible;
        self.matrices |= other.matrices;
        self.any_knots |= other.any_knots;
        self.unit |= other.unit;
    }
}

/// A notation with several readings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ambiguity {
    /// C_a^b.
    Binomial,
    /// B_{a,b}.
    Bernstein,
    /// f^k(t).
    Power,
    /// N_i^k.
    Spline,
    /// t_1 t_2 + … + t_4 t_5.
    Dots,
    /// q(2t - 1).
    Applied,
}

/// One instance of a statement.
#[derive(Clone)]
pub struct Model {
    context: Rc<Context>,
    place: Place,
    choices: Choices,
    /// The degree of functions without definition; `None` while it is being found out.
    degree: Option<usize>,
    /// Whether this is the evaluation that finds out the degrees.
    discovering: bool,
    /// Bézier curves are spoken of in the sentence.
    curve: Option<Curve>,
    /// Divided differences occur: values of functions are symbols.
    opaque: bool,
    /// The parameter near which piecewise polynomials are considered.
    around: RefCell<Option<Rational>>,
    /// Whether the knots are the integers.
    uniform: bool,
    /// Knots that words give.
    breaks: Vec<Rational>,
    /// The knots that the page gives, by their numbers.
    given_knots: Rc<BTreeMap<i64, Rational>>,
    /// Whether a sum runs over all B-splines that there are: beyond the given knots there are none.
    all_splines: Cell<bool>,
    /// Letters up to which the relation sums.
    ends: Rc<BTreeSet<String>>,
    /// Whether functions of two groups of arguments occur.
    tensor: bool,
    /// Capital letters whose small ones are their polar forms in this statement.
    pairs: BTreeSet<String>,
    /// Whether the arguments just read had dots without a count.
    flexible: Cell<bool>,
    /// Letters of control points whose curve is being evaluated.
    open: RefCell<BTreeSet<String>>,
    depth: Cell<usize>,
    /// Where the derivative is taken that is being worked out.
    place_of_derivative: RefCell<Option<Fraction>>,
    /// Whether conditions of a definition are being looked at.
    asking: Cell<bool>,
    /// Definitions that are being compared with what is asked for.
    matching: RefCell<Vec<*const Definition>>,
    record: RefCell<Record>,
}

impl Model {
    /// A model at a place of the notes.
    pub fn new(context: Rc<Context>, place: Place, choices: Choices, curve: Option<Curve>) -> Self {
        Model {
            context,
            place,
            choices,
            degree: None,
            discovering: false,
            curve,
            opaque: false,
            around: RefCell::default(),
            uniform: false,
            breaks: Vec::new(),
            given_knots: Rc::default(),
            all_splines: Cell::new(false),
            ends: Rc::default(),
            tensor: false,
            pairs: BTreeSet::new(),
            flexible: Cell::new(false),
            open: RefCell::default(),
            depth: Cell::new(0),
            place_of_derivative: RefCell::default(),
            asking: Cell::new(false),
            matching: RefCell::default(),
            record: RefCell::default(),
        }
    }

    /// The same with a degree for functions without definition.
    pub fn with_degree(mut self, degree: Option<usize>) -> Self {
        self.degree = degree;
        self
    }

    /// For finding out the degrees: polar forms have the value 0.
    pub fn discovering(mut self) -> Self {
        self.discovering = true;
        self
    }

    /// Capital letters whose small ones are their polar forms.
    pub fn with_pairs(mut self, pairs: BTreeSet<String>) -> Self {
        self.pairs = pairs;
        self
    }

    /// Values of functions are symbols.
    pub fn opaque(mut self, opaque: bool) -> Self {
        self.opaque = opaque;
        self
    }

    /// Piecewise polynomials are considered near a parameter.
    pub fn near(mut self, around: Option<Rational>) -> Self {
        self.around = RefCell::new(around);
        self
    }

    /// Generic knots are the integers.
    pub fn with_uniform_knots(mut self, uniform: bool) -> Self {
        self.uniform = uniform;
        self
    }

    /// Knots that words give, where pieces end.
    pub fn with_breaks(mut self, breaks: Vec<Rational>) -> Self {
        self.breaks = breaks;
        self
    }

    /// Knots that the page gives, by their numbers.
    pub fn with_given_knots(mut self, knots: Rc<BTreeMap<i64, Rational>>) -> Self {
        self.given_knots = knots;
        self
    }

    /// Letters up to which the relation sums: the last values of indices.
    pub fn with_ends(mut self, ends: BTreeSet<String>) -> Self {
        self.ends = Rc::new(ends);
        self
    }

    /// Functions of two groups of arguments occur: F(u, v) is the diagonal of f(u, …; v, …).
    pub fn with_tensor(mut self, tensor: bool) -> Self {
        self.tensor = tensor;
        self
    }

    /// What happened since this was asked last.
    pub fn take_record(&self) -> Record {
        self.record.take()
    }

    fn note(&self, meaning: impl Into<String>) {
        self.record.borrow_mut().standard.insert(meaning.into());
    }

    fn note_generic(&self, meaning: String) {
        self.record.borrow_mut().generic.insert(meaning);
    }

    fn ambiguous(&self, ambiguity: Ambiguity) {
        self.record.borrow_mut().ambiguous.insert(ambiguity);
    }
}

impl Reading for Model {
    fn eval(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        match &expr.kind {
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) => self.name(machine, expr),
            Kind::Accent(accent, _) => match accent {
                crate::formula::Accent::Dot | crate::formula::Accent::Ddot => None,
                crate::formula::Accent::Hat => self.hat(machine, expr),
                _ => self.name(machine, expr),
            },
            Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if name == "sqrt") => {
                let [group] = groups.as_slice() else { return None };
                let [body] = group.as_slice() else { return None };
                let value = machine.eval(body).ok()?.as_rational()?;
                Some(Ok(Value::Scalar(roots::square_root(&value)?)))
            }
            Kind::Apply(callee, groups) => self
                .of_an_angle(machine, callee, groups)
                .map(Ok)
                .or_else(|| self.call(machine, callee, groups, expr)),
            Kind::Add(terms) => self.sum(machine, terms, expr),
            Kind::Mul(factors) => self.product(machine, factors, expr),
            Kind::Pow(base, exponent) => self.power(machine, base, exponent, expr),
            Kind::Binomial(n, k, BinomialStyle::Subscripted) => {
                self.ambiguous(Ambiguity::Binomial);
                if !self.choices.total_above {
                    return None;
                }
                Some(machine.eval(n).and_then(|n| {
                    let k = machine.eval(k)?;
                    arithmetic::binomial(&k, &n).map_err(|error| error.at(expr.span))
                }))
            }
            Kind::Binomial(x, y, BinomialStyle::Stacked) if self.context.letters.is_column(x, y) => {
                Some(self.point(machine, &[x.as_ref(), y.as_ref()], expr))
            }
            Kind::List(items) | Kind::Tuple(items) if self.choices.reads(items.len()) => {
                Some(self.point(machine, &items.iter().collect::<Vec<_>>(), expr))
            }
            Kind::Matrix(rows, _)
                if self.choices.reads(rows.len()) && rows.iter().all(|row| row.len() == 1) =>
            {
                let cells: Option<Vec<&Expr>> = rows.iter().map(|row| row[0].as_ref()).collect();
                Some(self.point(machine, &cells?, expr))
            }
            Kind::Matrix(rows, delimiter) => self.blocks(machine, rows, *delimiter, expr),
            Kind::Big { op, lower, upper, body } => {
                self.unbounded(machine, *op, lower, upper.as_deref(), body, expr)
            }
            Kind::Integral { lower, upper, .. } if self.is_local() => {
                self.piecewise_integral(machine, lower.as_deref(), upper.as_deref(), expr)
            }
            Kind::Prime(body, order) => self.derived_name(machine, body, *order as usize, expr),
            Kind::At { body, lower, upper: None } => self.at(machine, body, lower, expr),
            Kind::List(items) | Kind::Tuple(items) if items.len() == 1 => Some(machine.eval(&items[0])),
            Kind::Compose(items) => self.composed(machine, items, expr),
            Kind::Derivative { variables, body: Some(body), .. } => {
                self.derivative_at_number(machine, variables, body, expr)
            }
            Kind::Cases(cases) if self.is_local() => self.cases_here(machine, cases, expr),
            _ => None,
        }
    }
}

impl Model {
    /// cos(2π/3), sin(π/6): the values at multiples of π that are made of square roots.
    fn of_an_angle(&self, machine: &mut Machine, callee: &Expr, groups: &[Vec<Expr>]) -> Option<Value> {
        let Kind::Name(name) = &callee.kind else { return None };
        let quarter = match name.as_str() {
            "cos" => Rational::zero(),
            "sin" => rational(1, 2),
            _ => return None,
        };
        let [group] = groups else { return None };
        let [angle] = group.as_slice() else { return None };
        let Value::Scalar(angle) = machine.eval(angle).ok()? else { return None };
        let turn = angle.as_polynomial()?.coefficients_in(&Symbol::new("pi"));
        let turn: Vec<Rational> = turn.iter().map(MultiPoly::as_constant).collect::<Option<_>>()?;
        let turn = match turn.as_slice() {
            [] => Rational::zero(),
            [zero] if zero.is_zero() => Rational::zero(),
            [zero, turn] if zero.is_zero() => turn.clone(),
            _ => return None,
        };
        Some(Value::Scalar(roots::cosine(&(turn - quarter))?))
    }

    /// A point, or the coordinate of it that is meant.
    fn point(&self, machine: &mut Machine, coordinates: &[&Expr], expr: &Expr) -> Evaluated {
        let all: Vec<&Expr> = match self.choices.coordinate {
            Some((number, count)) if count == coordinates.len() => return machine.eval(coordinates[number]),
            _ => coordinates.to_vec(),
        };
        let cells = all.into_iter().map(|cell| machine.eval(cell)).collect::<Result<Vec<_>, _>>()?;
        let scalar = |cell: Value| match cell {
            Value::Scalar(x) => Some(x),
            _ => None,
        };
        let column: Option<Vec<Fraction>> = cells.into_iter().map(scalar).collect();
        let column = column.ok_or_else(|| shape("a coordinate that is no number", expr))?;
        Ok(Value::Matrix(nalgebra::DMatrix::from_vec(column.len(), 1, column)))
    }

    /// The value of a name with its indices.
    fn name(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        let head = self.context.with_pairs_apart(Head::of(expr)?);
        // Parameters and integers of the instance come first.
        if head.lower.is_empty() && head.upper.is_empty() {
            if let Some(value) = machine.lookup(&Symbol::new(&head.base)) {
                return Some(Ok(value.clone()));
            }
            if let Some(value) = self.local(machine, &head) {
                return Some(Ok(value));
            }
        } else if let Some(value) = self.local(machine, &head) {
            return Some(Ok(value));
        }
        if self.context.letters.is_beside_bold(expr) && !self.context.is_named_alone(&head.base, &self.place)
        {
            return Some(self.symbol(machine, &head, expr).map(Value::symbol));
        }
        if let Some(result) = self.defined(machine, &head, None) {
            return Some(result);
        }
        // Kronecker's δ
        if let ("delta", [i, j]) = (head.base.as_str(), head.lower.as_slice())
            && let (Ok(i), Ok(j)) = (machine.eval(i), machine.eval(j))
            && let (Some(i), Some(j)) = (i.as_int(), j.as_int())
        {
            return Some(Ok(Value::int(i64::from(i == j))));
        }
        if let Some(result) = self.spoken_name(machine, &head) {
            return Some(result);
        }
        if let Some(item) = self.item_of_query(machine, &head) {
            return Some(Ok(item));
        }
        if let Some(result) = self.standard_name(machine, &head, expr) {
            return Some(result);
        }
        if let Some(result) = self.without_arguments(machine, &head, expr) {
            return Some(result);
        }
        if let Some(result) = self.partial_derivative(machine, &head, expr) {
            return Some(result);
        }
        let word = head.base.rsplit(' ').next().unwrap_or(&head.base);
        let greek = letters::sign(word).is_some();
        if word.chars().count() > 1 && !greek {
            // convert(c, polar)
            if crate::language::functions::builtin(word).is_some() {
                return None;
            }
            let unknown = Diagnostic::error(Code::UnknownName, format!("'{word}' has no meaning here"));
            return Some(Err(unknown.at(expr.span)));
        }
        Some(self.symbol(machine, &head, expr).map(Value::symbol))
    }

    /// A value bound in this evaluation, such as t_1 of f(t_1, …, t_n).
    fn local(&self, machine: &mut Machine, head: &Head) -> Option<Value> {
        let symbol = self.symbol_of(machine, head)?;
        machine.lookup(&symbol).cloned()
    }

    /// The symbol that a name without value stands for.
    fn symbol(&self, machine: &mut Machine, head: &Head, expr: &Expr) -> Result<Symbol, Diagnostic> {
        self.symbol_of(machine, head).ok_or_else(|| {
            Diagnostic::error(Code::Undecided, "an index of this name has no value").at(expr.span)
        })
    }

    fn symbol_of(&self, machine: &mut Machine, head: &Head) -> Option<Symbol> {
        let mut symbol = symbol_of(&head.base);
        let mut lower = Vec::with_capacity(head.lower.len());
        for index in &head.lower {
            match self.index(machine, index)? {
                Index::Number(i) if i >= 10 && self.context.letters.pairs.contains(&head.base) => {
                    let digits = i.to_string().into_bytes();
                    lower.extend(digits.iter().map(|digit| Index::Number(i64::from(digit - b'0'))));
                }
                index => lower.push(index),
            }
        }
        if !lower.is_empty() {
            symbol = symbol.with_indices(lower);
        }
        if !head.upper.is_empty() {
            let upper: Option<Vec<Index>> =
                head.upper.iter().map(|index| self.index(machine, index)).collect();
            symbol = symbol.with_upper(upper?);
        }
        Some(symbol)
    }

    fn index(&self, machine: &mut Machine, expr: &Expr) -> Option<Index> {
        match &expr.kind {
            // An arbitrary permutation: the one that exchanges the first two will do, since all are
            // made of such exchanges.
            Kind::Apply(callee, groups)
                if matches!(&callee.kind, Kind::Name(name) if name == "pi")
                    && machine.lookup(&Symbol::new("pi")).is_none() =>
            {
                let [group] = groups.as_slice() else { return None };
                let [place] = group.as_slice() else { return None };
                let place = machine.eval(place).ok()?.as_int()?;
                let alone = roles::DEGREES.iter().any(|name| {
                    machine.lookup(&Symbol::new(*name)).and_then(Value::as_int).is_some_and(|size| size < 2)
                });
                Some(Index::Number(match place {
                    1 if !alone => 2,
                    2 if !alone => 1,
                    other => other,
                }))
            }
            Kind::Name(name) if machine.lookup(&Symbol::new(name)).is_none() => {
                Some(Index::Word(name.clone()))
            }
            Kind::Text(text) => Some(Index::Word(text.trim().to_owned())),
            // f_{+1}; but t_{-2} is one of the t_i.
            Kind::Add(terms)
                if matches!(
                    terms.as_slice(),
                    [Term { sign: Sign::Plus, expr: Expr { kind: Kind::Number(_), .. } }]
                ) =>
            {
                Some(Index::Word("+".to_owned() + &machine.eval(&terms[0].expr).ok()?.as_int()?.to_string()))
            }
            // u_{ij} with a two-letter index
            Kind::Mul(factors) => {
                let mut word = String::new();
                for factor in factors {
                    match self.index(machine, factor)? {
                        Index::Number(i) => word.push_str(&i.to_string()),
                        Index::Word(part) => word.push_str(&part),
                    }
                    word.push(',');
                }
                Some(Index::Word(word.trim_end_matches(',').to_owned()))
            }
            _ => {
                let value = machine.eval(expr).ok()?;
                match value.as_int() {
                    Some(i) => Some(Index::Number(i)),
                    None => match value {
                        Value::Scalar(value) => Some(Index::Word(value.to_string())),
                        _ => None,
                    },
                }
            }
        }
    }

    /// v̂, which may be defined as p − q; else the vector with the coordinate v.
    fn hat(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        let head = Head::of(expr)?;
        match self.defined(machine, &head, None)? {
            Ok(Value::Scalar(v)) => Some(Ok(Value::Vector(v))),
            other => Some(other),
        }
    }
}

/// Values for names.
pub type Bound = Vec<(Symbol, Value)>;

fn shape(message: &str, expr: &Expr) -> Diagnostic {
    Diagnostic::error(Code::Shape, message).at(expr.span)
}

/// Whether a condition on numbers holds; `None` if that cannot be said.
pub fn holds(machine: &mut Machine, condition: &Expr) -> Option<bool> {
    if let Some(items) = condition.alternatives() {
        let held: Vec<Option<bool>> = items.iter().map(|item| holds(machine, item)).collect();
        return match held.contains(&Some(true)) {
            true => Some(true),
            false => (!held.contains(&None)).then_some(false),
        };
    }
    let Kind::Chain(left, links) = &condition.kind else { return None };
    let number = |machine: &mut Machine, expr: &Expr| machine.eval(expr).ok()?.as_rational();
    let mut value = number(machine, left)?;
    for link in links {
        if let (Rel::Eq | Rel::In, Kind::Range(from, to)) = (link.rel, &link.expr.kind) {
            let (from, to) = (number(machine, from)?, number(machine, to)?);
            if !value.is_integer() || value < from || value > to {
                return Some(false);
            }
            continue;
        }
        if matches!(link.rel, Rel::In | Rel::NotIn) {
            let ([from, to], [above, below]) = interval(&link.expr)?;
            let (from, to) = (number(machine, from)?, number(machine, to)?);
            let outside = value < from || value > to || above && value == from || below && value == to;
            if outside == (link.rel == Rel::In) {
                return Some(false);
            }
            continue;
        }
        let next = number(machine, &link.expr)?;
        let ok = match link.rel {
            Rel::Eq => value == next,
            Rel::Ne => value != next,
            Rel::Lt => value < next,
            Rel::Le => value <= next,
            Rel::Gt => value > next,
            Rel::Ge => value >= next,
            _ => return None,
        };
        if !ok {
            return Some(false);
        }
        value = next;
    }
    Some(true)
}
