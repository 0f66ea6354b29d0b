//! Formulas as sums of hypergeometric terms.
//!
//! The reader refuses (`None`) whatever it does not understand completely. It gathers what the
//! formula takes for granted: which names are integers, that the upper entries of binomials are
//! not negative, and the natural ranges of indices.

use std::collections::BTreeSet;

use num_traits::{One, Zero};

use super::classes::classes;
use super::context::Context;
use super::linear::Linear;
use super::names::{self, Names};
use super::term::{Indexed, Term, collected};
use crate::budget;
use crate::formula::{Accent, BigOp, Expr, Kind, Sign};
use crate::language::lexicon::families::FORWARD_DIFFERENCE;
use crate::language::lexicon::roles;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Index, Symbol};

/// Longer sums of terms are refused.
const MAX_TERMS: usize = 300;
/// Powers of sums with larger exponents are refused.
const MAX_POWER: i64 = 12;
/// Definitions may refer to each other this deeply.
const MAX_UNFOLDINGS: u32 = 24;

/// Deep formulas go on in a new segment of the stack when less than this is left.
const RED_ZONE: usize = 128 * 1024;
const SEGMENT: usize = 2 * 1024 * 1024;

/// Looks up what a name or a call stands for.
pub type Lookup<'a> = &'a dyn Fn(&Expr) -> Option<Expr>;

/// A reader of formulas; it remembers what they take for granted.
pub struct Reader<'a> {
    lookup: Lookup<'a>,
    unfoldings: u32,
    fresh: u32,
    /// Variables of sums with what they are called here, the innermost last.
    pub(super) scope: Vec<(String, Symbol)>,
    /// What is ≥ 0 in the ranges of these sums.
    pub(super) ranges: Vec<Linear>,
    /// Whether a value for a case is read.
    pub(super) in_case: bool,
    /// How the names are used.
    pub names: Names,
    /// Names that stand for integers.
    pub integers: BTreeSet<Symbol>,
    /// Names that an earlier reading found to be integers.
    pub expected: BTreeSet<Symbol>,
    /// Symbols that occur in bases of powers or as variables of derivatives and integrals: no integers.
    pub reals: BTreeSet<Symbol>,
    /// Inequalities that hold throughout.
    pub domain: Context,
    /// Index and upper entry of binomials and Bernstein polynomials: 0 ≤ index ≤ entry.
    pub natural: Vec<(Symbol, Linear)>,
    /// b − a + 1 for sums from a letter a to b: they are natural if this is not negative.
    pub lengths: Vec<Linear>,
    /// Symbols that occur in upper entries.
    pub uppers: BTreeSet<Symbol>,
    /// Whether an elementary symmetric function was read.
    pub symmetric: bool,
}

impl<'a> Reader<'a> {
    /// A reader that has seen nothing yet.
    pub fn new(lookup: Lookup<'a>) -> Self {
        Reader {
            lookup,
            unfoldings: 0,
            fresh: 0,
            scope: Vec::new(),
            ranges: Vec::new(),
            in_case: false,
            names: Names::default(),
            integers: BTreeSet::new(),
            expected: BTreeSet::new(),
            reals: BTreeSet::new(),
            domain: Context::default(),
            natural: Vec::new(),
            lengths: Vec::new(),
            uppers: BTreeSet::new(),
            symmetric: false,
        }
    }

    /// A symbol that no formula contains.
    pub(super) fn fresh(&mut self) -> Symbol {
        self.fresh += 1;
        Symbol::new(format!("#{}", self.fresh))
    }

    /// The formula as a sum of terms.
    pub fn read(&mut self, expr: &Expr) -> Option<Vec<Term>> {
        budget::step();
        stacker::maybe_grow(RED_ZONE, SEGMENT, || self.read_kind(expr))
    }

    fn read_kind(&mut self, expr: &Expr) -> Option<Vec<Term>> {
        if let Some(found) = self.unfolded(expr) {
            return found;
        }
        match &expr.kind {
            Kind::Number(value) => Some(vec![Term::new(Fraction::from(value.clone()))]),
            Kind::Name(name) => self.name(name),
            Kind::Group(body) => self.read(body),
            Kind::Accent(accent, body) => self.accented(*accent, body),
            Kind::Subscript(base, indices) => self.subscripted(base, indices),
            Kind::Add(terms) => {
                let mut sum = Vec::new();
                for term in terms {
                    let sign = if term.sign == Sign::Minus { -Fraction::one() } else { Fraction::one() };
                    sum.extend(self.read(&term.expr)?.iter().map(|t| t.scaled(&sign)));
                }
                bounded(collected(sum))
            }
            Kind::Mul(factors) => self.product_of(factors),
            Kind::Div(above, below, _) => {
                let (above, below) = (self.read(above)?, self.read(below)?);
                let inverse = self.inverse(&below)?;
                self.product(&above, &[inverse])
            }
            Kind::Pow(base, exponent) => self.power(expr, base, exponent),
            Kind::Upper(..) => self.bernstein(expr, None),
            Kind::Apply(callee, groups) => self.apply(callee, groups),
            Kind::Binomial(n, k, _) => {
                let (n, k) = (self.linear(n)?, self.linear(k)?);
                Some(vec![self.binomial(&n, &k)])
            }
            Kind::Factorial(body) => {
                let form = self.linear(body)?;
                self.take_for_granted(&form);
                Some(vec![Term::factorial(form, 1)])
            }
            Kind::Big { op: BigOp::Sum, lower, upper, body } => self.sum(lower, upper.as_deref(), body),
            Kind::Big { op: BigOp::Product, lower, upper, body } => {
                self.product_over(lower, upper.as_deref(), body)
            }
            Kind::Cases(cases) => self.cases(cases),
            Kind::Prime(body, order) => self.primed(body, *order),
            Kind::Derivative { partial, variables, body: Some(body) } => {
                self.differentiated(*partial, variables, body)
            }
            Kind::Integral { lower: Some(lower), upper: Some(upper), body, variable } => {
                self.integrated(lower, upper, body, variable)
            }
            Kind::At { body, lower, upper: None } => self.evaluated(body, lower),
            _ => None,
        }
    }

    /// What `lookup` makes of the formula, read; the inner `None` if that cannot be read.
    fn unfolded(&mut self, expr: &Expr) -> Option<Option<Vec<Term>>> {
        let can_be_defined =
            matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..) | Kind::Accent(..) | Kind::Apply(..))
                || matches!(
                    expr.kind,
                    Kind::Pow(..) | Kind::Upper(..) | Kind::Prime(..) | Kind::Binomial(..)
                );
        if !can_be_defined || self.is_bound(expr) {
            return None;
        }
        let body = self.looked_up(expr)?;
        if self.unfoldings >= MAX_UNFOLDINGS {
            return Some(None);
        }
        self.unfoldings += 1;
        self.names.scan(&body);
        let read = self.read(&body);
        self.unfoldings -= 1;
        Some(read)
    }

    /// What `lookup` makes of the formula, if that is something else.
    pub(super) fn looked_up(&self, expr: &Expr) -> Option<Expr> {
        (self.lookup)(expr).filter(|body| !body.same_as(expr))
    }

    fn is_bound(&self, expr: &Expr) -> bool {
        matches!(&expr.kind, Kind::Name(name) if self.scope.iter().any(|(bound, _)| bound == name))
    }

    fn name(&mut self, name: &str) -> Option<Vec<Term>> {
        if let Some((_, symbol)) = self.scope.iter().rev().find(|(bound, _)| bound == name) {
            return Some(vec![symbol_term(symbol.clone())]);
        }
        names::is_letter(name).then(|| vec![symbol_term(Symbol::new(name))])
    }

    fn accented(&mut self, accent: Accent, body: &Expr) -> Option<Vec<Term>> {
        let Kind::Name(name) = &body.kind else { return None };
        let opaque = !matches!(accent, Accent::Dot | Accent::Ddot | Accent::Blackboard);
        (opaque && names::is_letter(name))
            .then(|| vec![symbol_term(Symbol::new(name.clone()).with_accent(accent.name()))])
    }

    /// What an indexed symbol is called: its letter with its accent.
    pub(super) fn head(base: &Expr) -> Option<Symbol> {
        match &base.kind {
            Kind::Name(name) => names::is_letter(name).then(|| Symbol::new(name.clone())),
            Kind::Accent(accent, body)
                if !matches!(accent, Accent::Dot | Accent::Ddot | Accent::Blackboard) =>
            {
                Some(Self::head(body)?.with_accent(accent.name()))
            }
            _ => None,
        }
    }

    fn subscripted(&mut self, base: &Expr, indices: &[Expr]) -> Option<Vec<Term>> {
        let head = Self::head(base)?;
        let forms = self.indices(indices)?;
        Some(vec![indexed_term(&head, forms)])
    }

    /// Indices as forms; b_{ij} has two.
    pub(super) fn indices(&mut self, indices: &[Expr]) -> Option<Vec<Linear>> {
        let mut forms = Vec::new();
        for index in indices {
            match &index.kind {
                Kind::Mul(letters) if letters.iter().all(|x| matches!(x.kind, Kind::Name(_))) => {
                    for letter in letters {
                        forms.push(self.linear(letter)?);
                    }
                }
                _ => forms.push(self.linear(index)?),
            }
        }
        Some(forms)
    }

    /// The formula as an integer-linear form; its symbols are integers from now on.
    pub(super) fn linear(&mut self, expr: &Expr) -> Option<Linear> {
        let value = rational_value(&self.read(expr)?)?;
        let form = Linear::from_poly(value.as_polynomial()?)?;
        if !form.terms().keys().all(|symbol| symbol.indices().is_empty() && symbol.accent().is_empty()) {
            return None;
        }
        self.integers.extend(form.terms().keys().cloned());
        Some(form)
    }

    /// Whether a variable of a sum around this place occurs in the form.
    pub(super) fn mentions_bound(&self, form: &Linear) -> bool {
        self.scope.iter().any(|(_, symbol)| form.contains(symbol))
    }

    /// The formula only makes sense for L ≥ 0, if L does not depend on variables of sums and the
    /// place is not reached under a condition only.
    pub(super) fn take_for_granted(&mut self, form: &Linear) {
        if !self.mentions_bound(form) && !self.in_case {
            self.domain.assume(form);
        }
    }

    /// 0 ≤ k ≤ n is the natural range of a single symbol k.
    pub(super) fn natural_range(&mut self, k: &Linear, n: &Linear) {
        self.uppers.extend(n.terms().keys().cloned());
        if let Some(symbol) = k.as_symbol()
            && !self.mentions_bound(k)
            && !self.mentions_bound(n)
        {
            self.natural.push((symbol.clone(), n.clone()));
        }
    }

    /// C(n, k) = n!/(k! (n−k)!)
    pub(super) fn binomial(&mut self, n: &Linear, k: &Linear) -> Term {
        self.take_for_granted(n);
        self.natural_range(k, n);
        let mut term = Term::factorial(n.clone(), 1);
        term.multiply_factorial(k.clone(), -1);
        term.multiply_factorial(n.minus(k), -1);
        term
    }

    /// The product of two sums; bound variables are told apart.
    pub(super) fn product(&mut self, a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
        let mut product = Vec::new();
        for x in a {
            for y in b {
                budget::step();
                let mut y = y.clone();
                for variable in x.bound.intersection(&y.bound.clone()) {
                    let fresh = self.fresh();
                    self.integers.insert(fresh.clone());
                    y = y.substitute(variable, &Linear::symbol(&fresh))?;
                    y.bound.insert(fresh);
                }
                product.push(x.times(&y));
            }
            if product.len() > MAX_TERMS {
                return None;
            }
        }
        bounded(collected(product))
    }

    /// 1 / sum, if the sum is one term or one class of terms.
    fn inverse(&mut self, sum: &[Term]) -> Option<Term> {
        if let [term] = sum {
            return term.inverse();
        }
        let plain = |t: &Term| t.bound.is_empty() && t.guards.is_empty() && t.symbols.is_empty();
        if !sum.iter().all(plain) {
            return None;
        }
        let mut list = classes(sum)?;
        list.retain(|class| !class.coefficient.is_zero());
        let [class] = list.as_slice() else { return None };
        let mut term = class.common.scaled(&class.coefficient);
        term.defined.extend(sum.iter().flat_map(|t| t.defined.iter().cloned()));
        term.inverse()
    }

    fn product_of(&mut self, factors: &[Expr]) -> Option<Vec<Term>> {
        let mut product = vec![Term::new(Fraction::one())];
        let is_dots = |factor: &Expr| matches!(factor.kind, Kind::Ellipsis);
        if factors.iter().any(is_dots) {
            let factors = self.spread(factors);
            let dots = factors.iter().position(is_dots)?;
            let (first, last, term) = self.dotted(&factors, dots)?;
            let (before, after) =
                (self.product_of(&factors[..first])?, self.product_of(&factors[last + 1..])?);
            let outer = self.product(&before, &after)?;
            return self.product(&outer, &[term]);
        }
        let mut position = 0;
        while let Some(factor) = factors.get(position) {
            let next = factors.get(position + 1);
            if is_differential(factor, next) {
                return None;
            }
            let value = match difference_operator(factor) {
                Some(order) => {
                    position += 1;
                    self.difference(factor, order, next?)?
                }
                None => self.read(factor)?,
            };
            product = self.product(&product, &value)?;
            position += 1;
        }
        Some(product)
    }

    /// The factors of a product, with n (n−1), which reads like a call, as two.
    fn spread(&self, factors: &[Expr]) -> Vec<Expr> {
        let mut list = Vec::new();
        for factor in factors {
            match &factor.kind {
                Kind::Apply(callee, groups) if self.is_product(callee, groups) => {
                    list.extend(self.spread(std::slice::from_ref(&**callee)));
                    list.push(groups[0][0].clone());
                }
                _ => list.push(factor.clone()),
            }
        }
        list
    }

    /// A power, a name with an upper index, or a product such as t^i (1−t)^k, which is read as
    /// a call with an exponent.
    fn power(&mut self, whole: &Expr, base: &Expr, exponent: &Expr) -> Option<Vec<Term>> {
        if names::bernstein(whole).is_some() {
            return self.bernstein(whole, None);
        }
        match &base.kind {
            Kind::Subscript(name, indices) => {
                let head = Self::head(name)?;
                let mut forms = self.indices(indices)?;
                let power = self.linear(exponent)?;
                let number = power.as_constant().is_some() && forms.iter().all(|f| f.as_constant().is_some());
                if number && roles::is_parameter(head.base()) {
                    let base = [indexed_term(&head, forms)];
                    return self.powered(&base, &power);
                }
                // An upper index or a power: generic values of a family of its own cover both.
                forms.push(power);
                Some(vec![opaque_term(&format!("{head}^"), forms)])
            }
            Kind::Apply(callee, groups) if self.is_product(callee, groups) => {
                let argument = &groups[0][0];
                let exponent = self.linear(exponent)?;
                let (first, second) = (self.read(callee)?, self.read(argument)?);
                let power = self.powered(&second, &exponent)?;
                self.product(&first, &power)
            }
            _ => {
                let (base, exponent) = (self.read(base)?, self.linear(exponent)?);
                self.powered(&base, &exponent)
            }
        }
    }

    /// base^exponent
    pub(super) fn powered(&mut self, base: &[Term], exponent: &Linear) -> Option<Vec<Term>> {
        let rational = rational_value(base);
        if let Some(c) = exponent.as_constant() {
            let c = c.as_small()?;
            if let Some(value) = rational {
                if value.is_zero() && c < 0 {
                    return None;
                }
                return Some(vec![Term::power(&value, exponent)?]);
            }
            if c < 0 {
                let inverse = self.inverse(base)?;
                return self.powered(&[inverse], &exponent.negated());
            }
            let mut product = vec![Term::new(Fraction::one())];
            for _ in 0..Some(c).filter(|c| *c <= MAX_POWER)? {
                product = self.product(&product, base)?;
            }
            return Some(product);
        }
        let base = rational?;
        self.reals.extend(base.variables());
        Some(vec![Term::power(&base, exponent)?])
    }

    /// Whether callee(argument) is a product.
    fn is_product(&self, callee: &Expr, groups: &[Vec<Expr>]) -> bool {
        let [group] = groups else { return false };
        let [argument] = group.as_slice() else { return false };
        let call = Expr::apply(callee.clone(), vec![argument.clone()]);
        !self.defines(&call) && self.is_factor(callee, argument)
    }

    fn is_integer(&self, name: &str) -> bool {
        let symbol = Symbol::new(name);
        self.integers.contains(&symbol) || self.expected.contains(&symbol)
    }

    fn is_factor(&self, callee: &Expr, argument: &Expr) -> bool {
        match &callee.kind {
            Kind::Name(name) => {
                let integer = self.is_bound(callee) || self.is_integer(name);
                integer && matches!(argument.kind, Kind::Add(_)) || self.names.is_factor(name, argument)
            }
            Kind::Subscript(base, _) => self.names.is_indexed_factor(base, argument),
            Kind::Number(_) | Kind::Binomial(..) | Kind::Factorial(_) => true,
            Kind::Div(..) => self.is_scalar(callee),
            // b_i^k(1 − t) may be the value of a function.
            Kind::Pow(base, _) => !matches!(base.kind, Kind::Subscript(..)) && self.is_factor(base, argument),
            Kind::Apply(callee, groups) => self.is_product(callee, groups),
            Kind::Group(body) => matches!(argument.kind, Kind::Add(_)) && self.is_scalar(body),
            _ => false,
        }
    }

    /// Whether a formula in parentheses before another one is a factor: it holds letters that
    /// are not applied anywhere.
    fn is_scalar(&self, expr: &Expr) -> bool {
        match &expr.kind {
            Kind::Name(name) => {
                self.is_bound(expr)
                    || self.is_integer(name)
                    || (name.chars().all(char::is_lowercase)
                        && !roles::FUNCTIONS.contains(&name.as_str())
                        && !self.names.is_called(name))
            }
            Kind::Subscript(base, _) => {
                matches!(&base.kind, Kind::Name(name) if names::is_constant_family(name) || roles::is_parameter(name))
            }
            Kind::Number(_)
            | Kind::Add(_)
            | Kind::Mul(_)
            | Kind::Div(..)
            | Kind::Pow(..)
            | Kind::Binomial(..)
            | Kind::Factorial(_)
            | Kind::Group(_) => {
                let mut scalar = true;
                expr.for_each_child(&mut |child| scalar &= self.is_scalar(child));
                scalar
            }
            _ => false,
        }
    }

    /// The value of a function that nobody defines: a symbol of its own for each list of arguments.
    fn opaque_call(&mut self, callee: &Expr, groups: &[Vec<Expr>]) -> Option<Vec<Term>> {
        if groups.iter().flatten().any(|argument| self.holds_bound(argument)) {
            return None;
        }
        let (name, indices, raised) = match &callee.kind {
            Kind::Subscript(name, indices) => (&**name, indices.as_slice(), None),
            Kind::Pow(base, exponent) => match &base.kind {
                Kind::Subscript(name, indices) => (&**name, indices.as_slice(), Some(exponent)),
                _ => return None,
            },
            _ => (callee, &[][..], None),
        };
        let head = Self::head(name)?;
        let mut forms = self.indices(indices)?;
        if let Some(exponent) = raised {
            forms.push(self.linear(exponent)?);
        }
        let mark = if raised.is_some() { "^" } else { "" };
        let arguments: Vec<Vec<Expr>> = groups
            .iter()
            .map(|group| group.iter().map(|argument| argument.clone().without_spans()).collect())
            .collect();
        Some(vec![opaque_term(&format!("{head}{mark}[{arguments:?}]"), forms)])
    }

    fn holds_bound(&self, expr: &Expr) -> bool {
        let mut found = self.is_bound(expr);
        expr.for_each_child(&mut |child| found |= self.holds_bound(child));
        found
    }

    fn apply(&mut self, callee: &Expr, groups: &[Vec<Expr>]) -> Option<Vec<Term>> {
        let [group] = groups else { return self.opaque_call(callee, groups) };
        if let (Some(order), [argument]) = (difference_operator(callee), group.as_slice()) {
            return self.difference(callee, order, argument);
        }
        if let Some(head) = names::bernstein(callee) {
            return match (head.indices.len(), group.as_slice()) {
                (1, [argument]) => self.bernstein(callee, Some(argument)),
                (3, arguments) => self.triangular(callee, arguments),
                _ => None,
            };
        }
        if let Kind::Subscript(base, indices) = &callee.kind
            && let Some(found) = self.elementary(base, indices, group)
        {
            return Some(found);
        }
        if let ([argument], Some((function, order))) = (group.as_slice(), names::under_dots(callee)) {
            return self.derivative_at(&function, order, argument);
        }
        match (&callee.kind, group.as_slice()) {
            (Kind::Prime(function, order), [argument]) => self.derivative_at(function, *order, argument),
            (_, [argument]) if self.is_factor(callee, argument) => {
                let (first, second) = (self.read(callee)?, self.read(argument)?);
                self.product(&first, &second)
            }
            _ => self.opaque_call(callee, groups),
        }
    }
}

/// The rational function that a sum of terms is, if it is nothing else.
pub fn rational_value(terms: &[Term]) -> Option<Fraction> {
    match terms {
        [] => Some(Fraction::zero()),
        [term] if term.is_rational() => Some(term.coefficient.clone()),
        _ => None,
    }
}

/// A symbol as a term.
pub fn symbol_term(symbol: Symbol) -> Term {
    Term::new(Fraction::from(crate::math::poly::MultiPoly::symbol(symbol)))
}

/// head_{…}: a symbol among others if all indices are numbers, else a member of a family.
pub fn indexed_term(head: &Symbol, forms: Vec<Linear>) -> Term {
    let numbers: Option<Vec<i64>> = forms.iter().map(|form| form.as_constant()?.as_small()).collect();
    match numbers {
        Some(numbers) => symbol_term(head.with_indices(numbers.into_iter().map(Index::Number))),
        None => opaque_term(&head.to_string(), forms),
    }
}

/// A member of a family of symbols.
pub fn opaque_term(head: &str, indices: Vec<Linear>) -> Term {
    let mut term = Term::new(Fraction::one());
    term.symbols.insert(Indexed { head: head.to_owned(), indices }, 1);
    term
}

fn bounded(terms: Vec<Term>) -> Option<Vec<Term>> {
    (terms.len() <= MAX_TERMS).then_some(terms)
}

/// d before another name: perhaps a differential.
fn is_differential(factor: &Expr, next: Option<&Expr>) -> bool {
    matches!(&factor.kind, Kind::Name(d) if d == "d")
        && next.is_some_and(|next| !matches!(next.kind, Kind::Number(_) | Kind::Group(_) | Kind::Big { .. }))
}

/// The order of Δ or Δ^k.
fn difference_operator(factor: &Expr) -> Option<Expr> {
    let is_delta = |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if name == FORWARD_DIFFERENCE);
    match &factor.kind {
        Kind::Pow(base, order) if is_delta(base) => Some((**order).clone()),
        _ if is_delta(factor) => Some(Expr::from(Kind::Number(Rational::one()))),
        _ => None,
    }
}
