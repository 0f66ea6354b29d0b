//! One instance of a statement: every name has a meaning in it.
//!
//! A model says what the names of a statement stand for when its integers have values: the
//! definitions of the notes, standard meanings, and for functions that nobody defined polynomials
//! with symbols as coefficients. It is a [`Reading`]: what it has no opinion on is left to the
//! evaluator of the language.

mod calls;
mod dots;
mod families;
mod polynomials;

pub use polynomials::capital_of;

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::rc::Rc;

use super::context::{Body, Context, Definition};
use super::names::{Head, implied_index, integer_names, is_index_letter};
use super::statement::Place;
use crate::diagnostic::{Code, Diagnostic};
use crate::eval::{Machine, Reading};
use crate::expr::{BigOp, BinomialStyle, Delimiter, Expr, Kind, Link, Rel};
use crate::poly::{Fraction, Index, MultiPoly, Symbol};
use crate::value::Value;
use nalgebra::DMatrix;

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
    /// The formula is about functions in general: those defined elsewhere by one formula are not
    /// meant.
    pub general: bool,
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
    /// Notations with several readings that occurred.
    pub ambiguous: BTreeSet<Ambiguity>,
    /// A curve was given another number of control points than its degree asks for.
    pub mixed: bool,
    /// Whether an infinite sum was cut.
    pub infinite: bool,
    /// Whether a polar form had dots without a count among its arguments.
    pub flexible: bool,
}

impl Record {
    /// Adds what happened in another evaluation.
    pub fn merge(&mut self, other: &Record) {
        self.arities.extend(&other.arities);
        self.definitions.extend(&other.definitions);
        self.unknown.extend(other.unknown.iter().cloned());
        self.paired.extend(other.paired.iter().cloned());
        self.standard.extend(other.standard.iter().cloned());
        self.ambiguous.extend(&other.ambiguous);
        self.wants_degree |= other.wants_degree;
        self.mixed |= other.mixed;
        self.infinite |= other.infinite;
        self.flexible |= other.flexible;
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
}

/// The curve that a sentence speaks of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curve {
    /// The letter of its control points.
    pub points: String,
}

/// One instance of a statement.
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
    /// The knot interval for B-splines.
    interval: Option<i64>,
    /// Whether the knots are the integers.
    uniform: bool,
    /// Whether functions of two groups of arguments occur.
    tensor: bool,
    /// Capital letters whose small ones are their polar forms in this statement.
    pairs: BTreeSet<String>,
    /// Whether the arguments just read had dots without a count.
    flexible: Cell<bool>,
    depth: Cell<usize>,
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
            interval: None,
            uniform: false,
            tensor: false,
            pairs: BTreeSet::new(),
            flexible: Cell::new(false),
            depth: Cell::new(0),
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

    /// B-splines are considered between the knots number m and m + 1.
    pub fn on_interval(mut self, interval: Option<i64>, uniform: bool) -> Self {
        self.interval = interval;
        self.uniform = uniform;
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

    fn ambiguous(&self, ambiguity: Ambiguity) {
        self.record.borrow_mut().ambiguous.insert(ambiguity);
    }
}

impl Reading for Model {
    fn eval(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        match &expr.kind {
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) => self.name(machine, expr),
            Kind::Accent(accent, _) => match accent {
                crate::expr::Accent::Dot | crate::expr::Accent::Ddot => None,
                crate::expr::Accent::Hat => self.hat(machine, expr),
                _ => self.name(machine, expr),
            },
            Kind::Apply(callee, groups) => self.call(machine, callee, groups, expr),
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
                    crate::eval::arithmetic::binomial(&k, &n).map_err(|error| error.at(expr.span))
                }))
            }
            Kind::Matrix(rows, delimiter) => self.blocks(machine, rows, *delimiter, expr),
            Kind::Big { op, lower, upper, body } => {
                self.unbounded(machine, *op, lower, upper.as_deref(), body, expr)
            }
            Kind::Prime(body, order) => self.derived_name(machine, body, *order as usize, expr),
            Kind::At { body, lower, upper: None } => self.at(machine, body, lower, expr),
            Kind::List(items) | Kind::Tuple(items) if items.len() == 1 => Some(machine.eval(&items[0])),
            Kind::Compose(items) => self.composed(machine, items, expr),
            Kind::Cases(cases) if self.interval.is_some() => self.cases_between_knots(machine, cases, expr),
            _ => None,
        }
    }
}

impl Model {
    /// The value of a name with its indices.
    fn name(&self, machine: &mut Machine, expr: &Expr) -> Option<Evaluated> {
        let head = Head::of(expr)?;
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
        if let Some(result) = self.defined(machine, &head, None) {
            return Some(result);
        }
        if let Some(result) = self.standard_name(machine, &head, expr) {
            return Some(result);
        }
        if let Some(result) = self.without_arguments(machine, &head, expr) {
            return Some(result);
        }
        let word = head.base.rsplit(' ').next().unwrap_or(&head.base);
        let greek = crate::syntax::greek_char(word).is_some();
        if word.chars().count() > 1 && !greek && word != "ell" {
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
        let mut symbol = match head.base.split_once(' ') {
            Some((accent, base)) => Symbol::new(base).with_accent(accent),
            None => Symbol::new(&head.base),
        };
        let mut lower = Vec::with_capacity(head.lower.len());
        for index in &head.lower {
            match self.index(machine, index)? {
                Index::Number(i) if i >= 10 && self.context.letters.pairs.contains(&head.base) => {
                    lower.extend([Index::Number(i / 10), Index::Number(i % 10)]);
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
                let alone = ["n", "d", "m"].iter().any(|name| {
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
            Kind::Add(terms) if terms.len() == 1 && matches!(terms[0].expr.kind, Kind::Number(_)) => {
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

    /// The value of a definition that fits.
    fn defined(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: Option<&[Vec<Value>]>,
    ) -> Option<Evaluated> {
        let context = self.context.clone();
        let mut best: Option<(usize, usize, bool, Bound)> = None;
        for (number, definition, near) in context.visible(&head.base, &self.place) {
            // n = 3 holds for its paragraph.
            let own = &definition.head;
            let fixed = own.arguments.is_none()
                && own.lower.is_empty()
                && own.upper.is_empty()
                && is_index_letter(&own.base);
            if fixed && definition.place.group != self.place.group {
                continue;
            }
            if self.choices.near_only && !near
                || (self.choices.general || self.curve.is_some()) && self.is_example(definition)
            {
                continue;
            }
            if let Some((_, _, best_near, _)) = &best
                && *best_near
                && !near
            {
                continue;
            }
            let Some((bound, exact)) = self.matches(machine, definition, head, values) else { continue };
            // Of several that fit, the one with most exact indices; else the latest.
            let better = best.as_ref().is_none_or(|(_, most, ..)| exact > *most);
            if better {
                best = Some((number, exact, near, bound));
            }
        }
        let (number, _, near, bound) = best?;
        let definition = &context.definitions[number];
        let outermost = self.depth.get() == 0;
        let result = self.unfold(machine, definition, bound);
        // A definition that leads nowhere is as good as none.
        if let Err(error) = &result {
            let nowhere = matches!(
                error.code,
                Code::UnknownName | Code::UnknownFunction | Code::Unsupported | Code::AmbiguousProduct
            );
            if nowhere || outermost && error.code == Code::Recursion {
                return None;
            }
        }
        self.record.borrow_mut().definitions.insert((number, near));
        Some(result)
    }

    /// Whether a definition is of one function elsewhere: F(t) = t^3 + 1.
    pub(super) fn is_example(&self, definition: &Definition) -> bool {
        let head = &definition.head;
        let Body::Formula(body) = &definition.body else { return false };
        definition.place.group != self.place.group
            && head.arguments.is_some()
            && head.lower.is_empty()
            && head.upper.is_empty()
            && !head.flat().iter().any(|argument| argument.kind == Kind::Ellipsis)
            && integer_names(body).is_empty()
    }

    fn unfold(&self, machine: &mut Machine, definition: &Definition, bound: Bound) -> Evaluated {
        let body = match &definition.body {
            Body::Value(value) => return Ok(value.clone()),
            Body::Formula(body) => body,
        };
        if self.depth.get() >= crate::budget::depth().min(60) {
            return Err(Diagnostic::error(Code::Recursion, "this definition refers to itself without end"));
        }
        // Integers that nothing fixes have the value of the degree.
        let mut bound = bound;
        for name in integer_names(body) {
            let symbol = Symbol::new(&name);
            if matches!(name.as_str(), "n" | "d" | "m" | "N")
                && !bound.iter().any(|(known, _)| *known == symbol)
                && machine.lookup(&symbol).is_none()
            {
                match self.degree {
                    Some(degree) => bound.push((symbol, Value::int(degree as i64))),
                    None => self.record.borrow_mut().wants_degree = true,
                }
            }
        }
        self.depth.set(self.depth.get() + 1);
        let result = machine.with_locals(bound, |machine| machine.eval(body));
        self.depth.set(self.depth.get() - 1);
        result.map(|value| match value {
            Value::Matrix(matrix) if matrix.shape() == (1, 1) => Value::Scalar(matrix[(0, 0)].clone()),
            other => other,
        })
    }

    /// The parameters of a definition for a call, and how many indices agree exactly.
    fn matches(
        &self,
        machine: &mut Machine,
        definition: &Definition,
        head: &Head,
        values: Option<&[Vec<Value>]>,
    ) -> Option<(Bound, usize)> {
        let own = &definition.head;
        if own.upper.len() != head.upper.len() {
            return None;
        }
        if own.lower.len() != head.lower.len() {
            // Φ for a Φ_i whose formula does not depend on i
            let Body::Formula(body) = &definition.body else { return None };
            let free = integer_names(body);
            let idle =
                own.lower.iter().all(|index| matches!(&index.kind, Kind::Name(name) if !free.contains(name)));
            if !head.lower.is_empty() || !idle {
                return None;
            }
        }
        let mut bound = Bound::new();
        let mut exact = 0;
        let indices = own.lower.iter().chain(&own.upper).zip(head.lower.iter().chain(&head.upper));
        for (pattern, index) in indices {
            match &pattern.kind {
                Kind::Name(name) if is_index_letter(name) => {
                    let value = match machine.lookup(&Symbol::new(name)) {
                        Some(value) if matches!(&index.kind, Kind::Name(other) if other == name) => {
                            value.clone()
                        }
                        _ => machine.eval(index).ok()?,
                    };
                    value.as_int()?;
                    bound.push((Symbol::new(name), value));
                }
                Kind::Number(_) => {
                    let (value, wanted) = (machine.eval(index).ok()?, machine.eval(pattern).ok()?);
                    if value != wanted {
                        return None;
                    }
                    exact += 1;
                }
                _ if pattern.same_as(index) => exact += 1,
                _ => {
                    // p_{n-1} on the left of a definition: for the same value of the index
                    let (value, wanted) =
                        (machine.eval(index).ok()?.as_int()?, machine.eval(pattern).ok()?.as_int()?);
                    if value != wanted {
                        return None;
                    }
                    exact += 1;
                }
            }
        }
        match (&own.arguments, values) {
            (None, None) => {}
            (Some(groups), Some(values)) => {
                if groups.len() != values.len() {
                    return None;
                }
                for (patterns, values) in groups.iter().zip(values) {
                    exact += self.match_arguments(machine, patterns, values, &mut bound)?;
                }
            }
            // The function itself: F for F(t) = …
            (Some(groups), None) => {
                for pattern in groups.iter().flatten() {
                    let symbol = self.symbol_of(machine, &Head::of(pattern)?)?;
                    bound.push((symbol.clone(), Value::symbol(symbol)));
                }
            }
            (None, Some(_)) => return None,
        }
        for condition in &definition.conditions {
            let holds = machine.with_locals(bound.clone(), |machine| Ok(holds(machine, condition)));
            if holds == Ok(Some(false)) {
                return None;
            }
        }
        Some((bound, exact))
    }

    fn match_arguments(
        &self,
        machine: &mut Machine,
        patterns: &[Expr],
        values: &[Value],
        bound: &mut Bound,
    ) -> Option<usize> {
        let dots = patterns.iter().position(|pattern| pattern.kind == Kind::Ellipsis);
        let Some(dots) = dots else {
            if patterns.len() != values.len() {
                return None;
            }
            let mut exact = 0;
            for (pattern, value) in patterns.iter().zip(values) {
                match Head::of(pattern) {
                    Some(head) if head.arguments.is_none() => {
                        let symbol = self.symbol_of(machine, &head)?;
                        if let Some((_, known)) = bound.iter().find(|(known, _)| *known == symbol) {
                            if known != value {
                                return None;
                            }
                        } else {
                            bound.push((symbol, value.clone()));
                        }
                    }
                    _ => {
                        if machine.eval(pattern).ok()? != *value {
                            return None;
                        }
                        exact += 1;
                    }
                }
            }
            return Some(exact);
        };
        // t_1, …, t_n: as many as there are
        if dots == 0 || dots + 2 != patterns.len() {
            return None;
        }
        let first = Head::of(&patterns[0])?;
        let last = Head::of(&patterns[dots + 1])?;
        let [start] = first.lower.as_slice() else { return None };
        let [end] = last.lower.as_slice() else { return None };
        let start = machine.eval(start).ok()?.as_int()?;
        let count = values.len() as i64;
        match &end.kind {
            Kind::Name(name) if machine.lookup(&Symbol::new(name)).is_none() => {
                bound.push((Symbol::new(name), Value::int(start + count - 1)));
            }
            Kind::Name(name) if !bound.iter().any(|(known, _)| *known == Symbol::new(name)) => {
                bound.push((Symbol::new(name), Value::int(start + count - 1)));
            }
            _ => {
                let end = machine.with_locals(bound.clone(), |machine| machine.eval_int(end)).ok()?;
                if end != start + count - 1 {
                    return None;
                }
            }
        }
        let base = Symbol::new(&first.base);
        for (i, value) in values.iter().enumerate() {
            bound.push((base.numbered(start + i as i64), value.clone()));
        }
        Some(0)
    }

    /// Powers that are none: A^T is left to the language, b_i^r may be a name with two indices.
    fn power(&self, machine: &mut Machine, base: &Expr, exponent: &Expr, expr: &Expr) -> Option<Evaluated> {
        if let Kind::Name(mark) = &exponent.kind
            && matches!(mark.as_str(), "T" | "top")
        {
            return Some(machine.eval(base).and_then(|value| match value {
                Value::Scalar(_) => Ok(value),
                other => crate::eval::arithmetic::transpose(other).map_err(|error| error.at(expr.span)),
            }));
        }
        let head = Head::of(expr)?;
        if let Some(result) = self.defined(machine, &head, None) {
            return Some(result);
        }
        if let Some(result) = self.standard_name(machine, &head, expr) {
            return Some(result);
        }
        if !head.lower.is_empty() && self.context.letters.towers.contains(&head.base) && !head.parenthesized {
            return Some(self.symbol(machine, &head, expr).map(Value::symbol));
        }
        if matches!(&exponent.kind, Kind::Name(star) if star == "ast" || star == "star" || star == "prime") {
            return Some(self.symbol(machine, &head, expr).map(Value::symbol));
        }
        None
    }

    /// A matrix with blocks in it or with empty cells beside them.
    fn blocks(
        &self,
        machine: &mut Machine,
        rows: &[Vec<Option<Expr>>],
        delimiter: Delimiter,
        expr: &Expr,
    ) -> Option<Evaluated> {
        if delimiter == Delimiter::Bar || rows.iter().flatten().all(Option::is_some) {
            return None;
        }
        let height = rows.len();
        let width = rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut matrix: DMatrix<Option<Fraction>> = DMatrix::from_element(height, width, None);
        let mut blocks = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            for (j, cell) in row.iter().enumerate() {
                let Some(cell) = cell else { continue };
                match machine.eval(cell) {
                    Ok(Value::Scalar(x)) => matrix[(i, j)] = Some(x),
                    Ok(Value::Matrix(block)) => blocks.push((i, j, block)),
                    Ok(_) => return Some(Err(shape("a cell that is neither a number nor a matrix", expr))),
                    Err(error) => return Some(Err(error)),
                }
            }
        }
        for (i, j, block) in blocks {
            // A block stands for the empty cells around it: its corner is the first empty cell there.
            let (h, w) = block.shape();
            let fits = (0..=height.saturating_sub(h))
                .flat_map(|top| (0..=width.saturating_sub(w)).map(move |left| (top, left)));
            let place = fits.into_iter().find(|&(top, left)| {
                (top..top + h).contains(&i)
                    && (left..left + w).contains(&j)
                    && (top..top + h).all(|r| (left..left + w).all(|c| matrix[(r, c)].is_none()))
            });
            let Some((top, left)) = place else {
                return Some(Err(shape("where the block in this matrix ends is not clear", expr)));
            };
            for r in 0..h {
                for c in 0..w {
                    matrix[(top + r, left + c)] = Some(block[(r, c)].clone());
                }
            }
        }
        let zero = || Fraction::from(MultiPoly::zero());
        Some(Ok(Value::Matrix(matrix.map(|cell| cell.unwrap_or_else(zero)))))
    }

    /// Sums without bounds, with bounds but no index, or up to ∞.
    fn unbounded(
        &self,
        machine: &mut Machine,
        op: BigOp,
        lower: &[Expr],
        upper: Option<&Expr>,
        body: &Expr,
        expr: &Expr,
    ) -> Option<Evaluated> {
        if !matches!(op, BigOp::Sum | BigOp::Product) {
            return None;
        }
        let range = |name: &str, from: Expr, to: Expr| {
            let piece = Expr::new(
                Kind::Chain(
                    Box::new(Expr::name(name)),
                    vec![Link { rel: Rel::Eq, span: expr.span, expr: from }],
                ),
                expr.span,
            );
            let big =
                Kind::Big { op, lower: vec![piece], upper: Some(Box::new(to)), body: Box::new(body.clone()) };
            Expr::new(big, expr.span)
        };
        if let Some(upper) = upper
            && matches!(&upper.kind, Kind::Name(name) if name == "infty")
        {
            let Some(degree) = self.degree else {
                self.record.borrow_mut().wants_degree = true;
                return Some(Err(Diagnostic::error(Code::Undecided, "an infinite sum").at(expr.span)));
            };
            self.record.borrow_mut().infinite = true;
            let end = Expr::int(degree.max(4) as i64 + 4);
            let big = Kind::Big {
                op,
                lower: lower.to_vec(),
                upper: Some(Box::new(end)),
                body: Box::new(body.clone()),
            };
            return Some(machine.eval(&Expr::new(big, expr.span)));
        }
        let bound_names: Vec<Expr> = lower
            .iter()
            .flat_map(|piece| match &piece.kind {
                Kind::Sequence(items) | Kind::Tuple(items) => items.clone(),
                _ => vec![piece.clone()],
            })
            .collect();
        match (bound_names.as_slice(), upper) {
            ([], None) => {
                let name = implied_index(body)?;
                Some(machine.eval(&range(&name, Expr::int(1), Expr::int(FREE_TERMS))))
            }
            ([one], None) => match &one.kind {
                Kind::Name(name) => Some(machine.eval(&range(name, Expr::int(1), Expr::int(FREE_TERMS)))),
                _ => None,
            },
            ([from], Some(to)) if !matches!(from.kind, Kind::Chain(..)) => {
                let name = implied_index(body)?;
                Some(machine.eval(&range(&name, from.clone(), to.clone())))
            }
            // i + j + k = d, i, j, k ≥ 0: the sums run over nonnegative integers anyway
            (many, None) if many.len() > 1 => {
                let first = &many[0];
                let Kind::Chain(left, _) = &first.kind else { return None };
                let rest = many[1..].iter().all(|piece| match &piece.kind {
                    Kind::Name(_) => true,
                    Kind::Chain(_, links) => matches!(links.as_slice(), [Link { rel: Rel::Ge, expr, .. }]
                        if matches!(&expr.kind, Kind::Number(q) if num_traits::Zero::is_zero(q))),
                    _ => false,
                });
                if !matches!(left.kind, Kind::Add(_)) || !rest {
                    return None;
                }
                let big =
                    Kind::Big { op, lower: vec![first.clone()], upper: None, body: Box::new(body.clone()) };
                Some(machine.eval(&Expr::new(big, expr.span)))
            }
            _ => None,
        }
    }

    /// Cases on where t lies: t is taken in the middle of the knot interval.
    fn cases_between_knots(
        &self,
        machine: &mut Machine,
        cases: &[(Expr, Option<Expr>)],
        expr: &Expr,
    ) -> Option<Evaluated> {
        if machine.lookup(&Symbol::new("t")).and_then(Value::as_rational).is_some() {
            return None;
        }
        let middle = self.middle()?;
        for (value, condition) in cases {
            let Some(condition) = condition else { return Some(machine.eval(value)) };
            let names = ["t", "u", "x"].map(|name| (Symbol::new(name), Value::number(middle.clone())));
            let verdict = machine.with_locals(names, |machine| machine.eval(condition));
            let holds = match verdict {
                Ok(Value::Claim(claim)) => claim.verdict() == crate::value::Verdict::Proved,
                Ok(Value::Text(_)) => true,
                Ok(_) => return Some(Err(calls::unclear("when this case holds", expr))),
                // "otherwise" in words
                Err(error) if error.code == Code::UnknownName => true,
                Err(error) => return Some(Err(error)),
            };
            if holds {
                return Some(machine.eval(value));
            }
        }
        Some(Err(calls::unclear("which case holds", expr)))
    }

    /// The middle of the knot interval considered.
    pub fn middle(&self) -> Option<crate::number::Rational> {
        let m = self.interval?;
        Some((self.knot(m) + self.knot(m + 1)) / crate::number::integer(2))
    }

    /// The knot number j: uneven ones, unless the notes define B-splines over the integers.
    pub fn knot(&self, j: i64) -> crate::number::Rational {
        const UNEVEN: [i64; 16] = [-9, -5, -4, -1, 0, 2, 3, 7, 8, 12, 15, 16, 20, 22, 27, 29];
        let uneven = usize::try_from(j + 4).ok().and_then(|at| UNEVEN.get(at).copied());
        crate::number::integer(match uneven {
            Some(knot) if !self.uniform => knot,
            _ if self.uniform => j,
            _ => 3 * j,
        })
    }

    /// Values at t_1 = … = t_n = t, also where an equals sign was lost.
    fn at(&self, machine: &mut Machine, body: &Expr, lower: &[Expr], expr: &Expr) -> Option<Evaluated> {
        let [piece] = lower else { return None };
        let Kind::Chain(left, links) = &piece.kind else { return None };
        let dots = links.iter().any(|link| {
            let mut found = false;
            super::names::walk(&link.expr, &mut |part| found = found || part.kind == Kind::Ellipsis);
            found
        });
        if !dots {
            return None;
        }
        let head = Head::of(left)?;
        let value = match machine.eval(&links.last()?.expr) {
            Ok(value) => value,
            Err(error) => return Some(Err(error)),
        };
        // All members of the family t_1, t_2, … get the value.
        let base = Symbol::new(&head.base);
        let names: Vec<(Symbol, Value)> = (0..=40).map(|i| (base.numbered(i), value.clone())).collect();
        Some(machine.with_locals(names, |machine| machine.eval(body)).map_err(|error| error.at(expr.span)))
    }
}

/// Values for names.
pub type Bound = Vec<(Symbol, Value)>;

fn shape(message: &str, expr: &Expr) -> Diagnostic {
    Diagnostic::error(Code::Shape, message).at(expr.span)
}

/// Whether a condition on integers holds; `None` if that cannot be said.
pub fn holds(machine: &mut Machine, condition: &Expr) -> Option<bool> {
    let Kind::Chain(left, links) = &condition.kind else { return None };
    let mut value = machine.eval(left).ok()?.as_int()?;
    for link in links {
        if let (Rel::Eq | Rel::In, Kind::Range(from, to)) = (link.rel, &link.expr.kind) {
            let (from, to) = (machine.eval(from).ok()?.as_int()?, machine.eval(to).ok()?.as_int()?);
            if !(from..=to).contains(&value) {
                return Some(false);
            }
            continue;
        }
        let next = machine.eval(&link.expr).ok()?.as_int()?;
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
