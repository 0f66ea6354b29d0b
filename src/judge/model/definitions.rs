//! Definitions of the notes: which one fits a name or call, and what it gives.

use std::collections::BTreeSet;

use super::{Bound, Evaluated, Model, holds};
use crate::formula::{Expr, Kind, Rel, Sign};
use crate::judge::page::context::{Body, Condition, Definition, Source};
use crate::judge::written::names::{
    Head, bases, calls, capital_of, integer_names, is_capital, is_index_letter, walk,
};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::lexicon::{families, roles};
use crate::language::value::Value;
use crate::math::poly::{Index, Symbol};

/// A function is given by several formulas, and its argument is any number.
pub(super) const OPEN_PIECE: &str = "which of several formulas counts here is open";

impl Model {
    /// The value of a definition that fits.
    pub(super) fn defined(
        &self,
        machine: &mut Machine,
        head: &Head,
        values: Option<&[Vec<Value>]>,
    ) -> Option<Evaluated> {
        let context = self.context.clone();
        let mut best: Option<(usize, usize, bool, Bound)> = None;
        let (mut excluded, mut pieces) = (false, 0);
        for (number, definition, near) in context.visible(&head.base, &self.place) {
            // n = 3 holds for its paragraph.
            let fixed = is_index_letter(&definition.head.base) && definition.number().is_some();
            if fixed && definition.place.group != self.place.group {
                continue;
            }
            if self.choices.near_only && !near
                || (self.choices.general || self.curve.is_some()) && self.is_example(definition)
            {
                continue;
            }
            // One of a neighbouring section counts if it is later than that of the section around.
            if let Some((best_number, _, best_near, _)) = &best
                && *best_near
                && !near
                && !(number > *best_number && self.place.is_beside(&definition.place))
            {
                continue;
            }
            // A family that another section gave anew, whole: b_0 of the one before is another.
            if let Some((latest, _, false, _)) = &best
                && context.definitions[*latest].place.scope != definition.place.scope
                && !context.definitions[*latest].is_recursive()
            {
                continue;
            }
            if self.is_made_of_itself(machine, definition, head) {
                continue;
            }
            let Some((bound, exact)) = self.matches(machine, definition, head, values) else { continue };
            match self.allows(machine, definition, &bound) {
                Some(false) => {
                    excluded = true;
                    continue;
                }
                None if near => pieces += 1,
                _ => {}
            }
            // Of several that fit, the one with most exact indices; else the latest.
            let bare =
                |number: usize| values.is_some() && context.definitions[number].head.arguments.is_none();
            let better = best.as_ref().is_none_or(|(latest, most, ..)| match (bare(*latest), bare(number)) {
                // H_2 = …, after H_2(t) = …, is not for calls; b_i^0 = b_i, after b_i^r(t) = …, is.
                (false, true) => exact > *most,
                (true, false) => exact >= *most,
                _ => exact > *most || number > *latest,
            });
            if better {
                best = Some((number, exact, near, bound));
            }
        }
        if let Some((number, ..)) = &best
            && values.is_some()
            && self.is_of_another_function(*number)
        {
            best = None;
        }
        let Some((number, _, near, bound)) = best else {
            // C(t) = Σ …, for n ≥ 2: where n is 1, C is not any function.
            let function = values.is_some() && head.lower.is_empty() && head.upper.is_empty();
            let message = "it is defined for other numbers only";
            return (function && excluded).then(|| Err(Diagnostic::error(Code::Domain, message)));
        };
        let definition = &context.definitions[number];
        // f(x) = x^2 for x ≤ 1, f(x) = 2 - x for x ≥ 1: which of them for any x?
        if pieces > 1 && self.allows(machine, definition, &bound).is_none() {
            return Some(Err(Diagnostic::error(Code::Domain, OPEN_PIECE)));
        }
        // f(x) = 0 if x is not rational
        let in_words = |condition: &Expr| {
            matches!(&condition.kind, Kind::Chain(_, links)
                if links.iter().any(|link| matches!(link.expr.kind, Kind::Text(_))))
        };
        if values.is_some() && definition.conditions.iter().any(in_words) {
            let message = format!("for which numbers {} is so is said in words", head.base);
            return Some(Err(Diagnostic::error(Code::Domain, message)));
        }
        if values.is_some() && self.is_of_functions(definition, &bound) {
            let message = "it is given a formula for a function here";
            return Some(Err(Diagnostic::error(Code::Unsupported, message)));
        }
        let outermost = self.depth.get() == 0;
        let result = self.unfold(machine, definition, bound);
        // A definition that leads nowhere is as good as none.
        if let Err(error) = &result {
            let nowhere = matches!(
                error.code,
                Code::UnknownName | Code::UnknownFunction | Code::Unsupported | Code::AmbiguousProduct
            );
            // N_l^m = (-1)^m √… P_l^m is not the one that everybody knows.
            let own = families::is_family(&head.base) && !definition.is_recursive();
            if nowhere && !own || outermost && matches!(error.code, Code::Recursion | Code::Undecided) {
                return None;
            }
        }
        self.record.borrow_mut().definitions.insert((number, near));
        Some(result)
    }

    /// Whether a function is to be called that has the value of a formula: B_n(f; x) = Σ f(k/n) …, in B_n(t^2; x).
    fn is_of_functions(&self, definition: &Definition, bound: &Bound) -> bool {
        let Body::Formula(body) = &definition.body else { return false };
        let function = |value: &Value| match value {
            Value::Scalar(_) => crate::judge::values::compare::symbols(value).iter().any(|symbol| {
                *value == Value::symbol(symbol.clone()) && self.context.letters.is_function(symbol.base())
            }),
            _ => true,
        };
        bound.iter().any(|(name, value)| {
            roles::NAMED_FUNCTIONS.contains(&name.base()) && calls(body, name.base()) && !function(value)
        })
    }

    /// Whether a definition of all members of a family leads back to the one that is asked for: x_i = x_0 + ih says
    /// nothing of x_0.
    fn is_made_of_itself(&self, machine: &mut Machine, definition: &Definition, head: &Head) -> bool {
        let ([Expr { kind: Kind::Name(_), .. }], [index], Body::Formula(body)) =
            (definition.head.lower.as_slice(), head.lower.as_slice(), &definition.body)
        else {
            return false;
        };
        let plain =
            definition.head.upper.is_empty() && definition.head.arguments.is_none() && head.upper.is_empty();
        let fixed = |part: &Expr| match &part.kind {
            Kind::Subscript(base, lower) => match (&base.kind, lower.as_slice()) {
                (Kind::Name(letter), [Expr { kind: Kind::Number(_), .. }]) if *letter == head.base => {
                    lower[0].as_int()
                }
                _ => None,
            },
            _ => None,
        };
        if !plain || !body.has(&|part| fixed(part).is_some()) {
            return false;
        }
        let Some(own) = machine.eval(index).ok().and_then(|value| value.as_int()) else { return false };
        body.has(&|part| fixed(part) == Some(own))
    }

    /// Whether a formula for a polar form is one for functions in general, or for another one than the page last gave:
    /// f(t_1, …, t_n) = Σ c_i σ_i, and in an example F(t) = t^2 - t.
    fn is_of_another_function(&self, number: usize) -> bool {
        let definition = &self.context.definitions[number];
        let capital = capital_of(&definition.head.base);
        let several = definition.head.flat().len() > 1;
        if capital == definition.head.base
            || !several
            || definition.place.group == self.place.group
            || !self.context.letters.speaks_of_polar_forms()
        {
            return false;
        }
        let latest = self.context.visible(&capital, &self.place).next();
        latest.is_some_and(|(later, function, near)| {
            let plain = function.head.lower.is_empty() && function.head.upper.is_empty();
            // F(t) = f(t, …, t) leads back to f.
            let body = match &function.body {
                Body::Formula(body) => {
                    integer_names(body).is_empty() && !bases(body).contains(&definition.head.base)
                }
                Body::Value(_) => false,
            };
            near && later > number && plain && body && function.head.flat().len() == 1
        })
    }

    /// The item b_i of a list b that a query gives.
    pub(super) fn item_of_query(&self, machine: &mut Machine, head: &Head) -> Option<Value> {
        let [index] = head.lower.as_slice() else { return None };
        let list = Head { lower: Vec::new(), ..head.clone() };
        let given = self.context.visible(&head.base, &self.place).any(|(_, d, _)| d.source == Source::Query);
        if !given || !head.upper.is_empty() || head.arguments.is_some() {
            return None;
        }
        let Value::List(items) = self.defined(machine, &list, None)?.ok()? else { return None };
        let index = machine.eval(index).ok()?.as_int()?;
        items.get(usize::try_from(index).ok()?).cloned()
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

    pub(super) fn unfold(&self, machine: &mut Machine, definition: &Definition, bound: Bound) -> Evaluated {
        let body = match &definition.body {
            Body::Value(value) => return Ok(value.clone()),
            Body::Formula(body) => body,
        };
        if self.depth.get() >= crate::budget::depth().min(60) {
            return Err(Diagnostic::error(Code::Recursion, "this definition refers to itself without end"));
        }
        let coordinates = coordinates(body, &bound).map_err(|name| {
            let message = format!("what the coordinates of {name} are is not said");
            Diagnostic::error(Code::Undecided, message).at(body.span)
        })?;
        // Integers that nothing fixes have the value of the degree.
        let mut bound: Bound = bound.into_iter().chain(coordinates).collect();
        for name in integer_names(body) {
            let symbol = Symbol::new(&name);
            if roles::is_degree(&name)
                && !bound.iter().any(|(known, _)| *known == symbol)
                && machine.lookup(&symbol).is_none()
                && self.context.number_in(&name, &self.place).is_none()
            {
                if let Some(size) = self.context.size_in_data(&name, body, &self.place) {
                    bound.push((symbol, Value::int(size)));
                    continue;
                }
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

    /// The parameters of a definition for a call, and how many indices agree exactly. While it is compared, it gives
    /// no value: p_α, where α is a ratio of areas between p_1, p_2, p_3.
    pub(super) fn matches(
        &self,
        machine: &mut Machine,
        definition: &Definition,
        head: &Head,
        values: Option<&[Vec<Value>]>,
    ) -> Option<(Bound, usize)> {
        let own = std::ptr::from_ref(definition);
        if self.matching.borrow().contains(&own) {
            return None;
        }
        self.matching.borrow_mut().push(own);
        let matched = self.compared(machine, definition, head, values);
        self.matching.borrow_mut().pop();
        matched
    }

    fn compared(
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
            // The i of a product without an index of its own is bound in it.
            let bound = matches!(body.kind, Kind::Big { .. });
            let free = if bound { integer_names(body) } else { bases(body) };
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
                    // x_n = b_n/a_nn, beside x_i = (b_i - Σ_{j=i+1}^n a_ij x_j)/a_ii: the last one only
                    let last = self.ends.contains(name)
                        && own.lower.len() == 1
                        && definition.is_of_members(name)
                        && !bases(index).contains(name)
                        && machine.lookup(&Symbol::new(name)).is_some_and(|end| *end != value);
                    // P_N = 1 is said of the last one.
                    let named = own.lower.len() == 1
                        && own.upper.is_empty()
                        && own.arguments.is_none()
                        && roles::is_size(name)
                        && matches!(&definition.body, Body::Formula(body) if !bases(body).contains(name))
                        && machine.lookup(&Symbol::new(name)).is_none_or(|end| *end != value);
                    if last || named {
                        return None;
                    }
                    bound.push((Symbol::new(name), value));
                }
                Kind::Number(_) => {
                    let (value, wanted) = (machine.eval(index).ok()?, machine.eval(pattern).ok()?);
                    if value != wanted {
                        return None;
                    }
                    exact += 1;
                }
                // F_{n+1} = F_n + F_{n-1}, q_{2i} = p_i
                _ if let Some((name, times, more)) = linear(pattern)
                    && let Some(value) = machine.eval(index).ok().and_then(|value| value.as_int()) =>
                {
                    if (value - more) % times != 0 {
                        return None;
                    }
                    bound.push((Symbol::new(name), Value::int((value - more) / times)));
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
                    // F(M) for a point M = (1/3, 1/3), where F(x, y) = …
                    let values = match values.as_slice() {
                        [Value::List(coordinates)] if patterns.len() > 1 => coordinates,
                        values => values,
                    };
                    exact += self.match_arguments(machine, definition, patterns, values, &mut bound)?;
                }
            }
            // The function itself: F for F(t) = …
            (Some(groups), None) => {
                for pattern in groups.iter().flatten() {
                    let symbol = self.symbol_of(machine, &Head::of(pattern)?)?;
                    bound.push((symbol.clone(), Value::symbol(symbol)));
                }
            }
            // b_i^0 = b_i, where the page says b_i^r(t): it does not depend on t.
            (None, Some(_)) if exact > 0 => {}
            (None, Some(_)) => return None,
        }
        Some((bound, exact))
    }

    /// Whether the conditions of a definition that fits do not fail; `None` if one on its arguments may. One that needs
    /// a definition with conditions says nothing: it may need itself.
    fn allows(&self, machine: &mut Machine, definition: &Definition, bound: &Bound) -> Option<bool> {
        if self.asking.replace(true) {
            return Some(true);
        }
        // b_i^0 = b_i for 1 ≤ k ≤ n, 0 ≤ i ≤ n - k: the k is that of another formula beside it. But d_i^* = d_i for i ≤ r - n
        // is so for the r of which all speaks.
        let is_bound =
            |name: &String| bound.iter().any(|(known, _)| known.is_plain() && known.base() == name);
        let elsewhere: BTreeSet<String> = definition
            .conditions
            .iter()
            .map(bases)
            .filter(|names| !names.iter().any(is_bound))
            .flatten()
            .collect();
        let is_given = |name: &String| {
            !elsewhere.contains(name)
                && machine.lookup(&Symbol::new(name)).is_some_and(|value| value.as_int().is_some())
        };
        let own = |condition: &&Expr| {
            bases(condition).iter().all(|name| {
                !matches!(name.as_str(), "i" | "j" | "k" | "l" | "r" | "s")
                    || is_bound(name)
                    || is_given(name)
            })
        };
        let conditions: Vec<&Expr> = definition.conditions.iter().filter(own).collect();
        let arguments: BTreeSet<String> = definition.head.flat().into_iter().flat_map(bases).collect();
        let mut allowed = Some(true);
        // Near a number the arguments have its value.
        let near = |value: &Value| match value {
            Value::Scalar(x) if self.is_local() => self.number_here(x).map(Value::number),
            _ => None,
        };
        let bound: Bound = bound
            .iter()
            .map(|(name, value)| (name.clone(), near(value).unwrap_or_else(|| value.clone())))
            .collect();
        for condition in conditions {
            match machine.with_locals(bound.clone(), |machine| Ok(holds(machine, condition))) {
                Ok(Some(false)) => {
                    allowed = Some(false);
                    break;
                }
                Ok(Some(true)) => {}
                _ if bases(condition).is_disjoint(&arguments) => {}
                _ => allowed = None,
            }
        }
        self.asking.set(false);
        allowed
    }

    /// Whether an argument is no variable of a formula, but a thing of which it is said: K_3 in P(K_3, k) = k(k-1)(k-2),
    /// z in N(z) = a^2 + b^2, after z = a + bi.
    fn stands_for_itself(&self, definition: &Definition, argument: &Head) -> bool {
        let Body::Formula(body) = &definition.body else { return false };
        let inside = bases(body);
        if inside.is_empty() || inside.contains(&argument.base) {
            return false;
        }
        let made_of_it = |(_, own, _): (usize, &Definition, bool)| matches!(&own.body, Body::Formula(other) if !bases(other).is_disjoint(&inside));
        let equation = |condition: &Expr| match &condition.kind {
            Kind::Chain(left, links) => {
                matches!(&left.kind, Kind::Name(name) if *name == argument.base)
                    && links.iter().any(|link| link.rel == Rel::Eq && !bases(&link.expr).is_disjoint(&inside))
            }
            _ => false,
        };
        let said = || {
            let near = |condition: &&Condition| condition.place.group == definition.place.group;
            self.context.conditions.iter().filter(near).any(|condition| equation(&condition.expr))
        };
        !argument.lower.is_empty()
            || definition.conditions.iter().any(equation)
            || said()
            || is_capital(&argument.base)
            || self.context.visible(&argument.base, &definition.place).any(made_of_it)
    }

    fn match_arguments(
        &self,
        machine: &mut Machine,
        definition: &Definition,
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
                // f((x_1, y_1), (x_2, y_2))
                if let (Some(names), Value::List(coordinates)) = (pattern.items(), value) {
                    exact += self.match_arguments(machine, definition, names, coordinates, bound)?;
                    continue;
                }
                match Head::of(pattern) {
                    Some(head) if head.arguments.is_none() => {
                        if self.stands_for_itself(definition, &head) {
                            exact += match_name(&head, value, bound)?;
                            continue;
                        }
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
}

/// Whether a value is a name: that of a pattern, or C_4 for C_n, where n gets its value.
fn match_name(pattern: &Head, value: &Value, bound: &mut Bound) -> Option<usize> {
    let symbols = crate::judge::values::equality::symbols(value);
    let [symbol] = symbols.iter().collect::<Vec<_>>()[..] else { return None };
    if *value != Value::symbol(symbol.clone()) {
        return None;
    }
    let alike = symbol.base() == pattern.base && symbol.upper().is_empty() && pattern.upper.is_empty();
    if !alike || symbol.indices().len() != pattern.lower.len() {
        return None;
    }
    let mut exact = 1;
    for (wanted, index) in pattern.lower.iter().zip(symbol.indices().iter().cloned()) {
        match (&wanted.kind, index) {
            (Kind::Name(name), Index::Number(number)) => {
                bound.push((Symbol::new(name), Value::int(number)));
                exact = 0;
            }
            (Kind::Number(_), Index::Number(number)) if wanted.as_int() == Some(number) => {}
            _ => return None,
        }
    }
    Some(exact)
}

/// An index, its factor and a number: n + 1, n − 1, 2i, 2i + 1.
fn linear(pattern: &Expr) -> Option<(&str, i64, i64)> {
    let (multiple, more) = match &pattern.kind {
        Kind::Add(terms) => match terms.as_slice() {
            [first, number] if first.sign == Sign::Plus => {
                let more = number.expr.as_int()?;
                (&first.expr, if number.sign == Sign::Minus { -more } else { more })
            }
            _ => return None,
        },
        Kind::Mul(_) => (pattern, 0),
        _ => return None,
    };
    let (times, index) = match &multiple.kind {
        Kind::Mul(factors) => match factors.as_slice() {
            [times, index] => (times.as_int().filter(|times| *times > 1)?, index),
            _ => return None,
        },
        _ => (1, multiple),
    };
    match &index.kind {
        Kind::Name(letter) if is_index_letter(letter) => Some((letter, times, more)),
        _ => None,
    }
}

/// The indices of coordinates.
const AXES: [&str; 3] = ["x", "y", "z"];

/// p_x and p_y in a ∧ b = a_x b_y - a_y b_x, for the points that are put for a and b; or the name whose coordinates are
/// not known.
fn coordinates(body: &Expr, bound: &Bound) -> Result<Bound, String> {
    let mut members: BTreeSet<(String, usize)> = BTreeSet::new();
    walk(body, &mut |part| {
        // Each definition is unfolded thousands of times.
        let Kind::Subscript(_, lower) = &part.kind else { return };
        let [Expr { kind: Kind::Name(axis), .. }] = lower.as_slice() else { return };
        let Some(axis) = AXES.iter().position(|own| own == axis) else { return };
        members.extend(Head::of(part).map(|head| (head.base, axis)));
    });
    let mut found = Bound::new();
    for (name, axis) in members {
        let Some((symbol, value)) = bound.iter().find(|(symbol, _)| *symbol == Symbol::new(&name)) else {
            continue;
        };
        let own =
            value.clone().coordinates().and_then(|mut all| (axis < all.len()).then(|| all.swap_remove(axis)));
        let index = Index::Word(AXES[axis].into());
        found.push((symbol.clone().with_indices([index]), own.ok_or(name)?));
    }
    Ok(found)
}
