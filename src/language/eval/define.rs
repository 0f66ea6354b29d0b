//! Definitions: names, functions, and functions by cases.

use std::sync::Arc;

use super::entries::{factor_or_index, is_bracketed};
use super::lambda::parameters_of;
use super::machine::Machine;
use super::names::{indices_in_brackets, letters_side_by_side, name_of};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::{families, roles};
use crate::language::value::{Clause, Function, Parameter, Shape, Value, Verdict};
use crate::math::poly::Symbol;

/// The left side of a definition, taken apart.
enum Target {
    Name(Symbol),
    Function { name: Symbol, shape: Shape, parameters: Vec<Expr> },
}

impl Machine {
    /// Whether F(0) = … or, after it, F(n) = … is a case of a function that has none for this yet.
    fn is_case(&mut self, callee: &Expr, arguments: &[&Expr]) -> bool {
        let Some(name) = name_of(callee, self).filter(Symbol::is_plain) else { return false };
        let number = |argument: &&Expr| match &argument.kind {
            Kind::Number(q) => Some(Parameter::Exactly(q.clone())),
            _ => None,
        };
        let numbers: Option<Vec<Parameter>> = arguments.iter().map(number).collect();
        match self.lookup(&name).cloned() {
            None => {
                let letter = name.base();
                let is_function =
                    letter.starts_with(char::is_uppercase) || roles::FUNCTIONS.contains(&letter);
                numbers.is_some() && !arguments.is_empty() && is_function && !self.is_standard(callee)
            }
            Some(Value::Function(function)) => {
                let exact = |clause: &Clause| {
                    clause.parameters.len() == arguments.len()
                        && clause.parameters.iter().all(|p| matches!(p, Parameter::Exactly(_)))
                };
                let named = arguments.iter().all(|argument| matches!(argument.kind, Kind::Name(_)));
                let fresh = match numbers {
                    Some(numbers) => function.clauses.iter().all(|clause| clause.parameters != numbers),
                    None => named,
                };
                fresh && !function.clauses.is_empty() && function.clauses.iter().all(exact)
            }
            Some(_) => false,
        }
    }

    /// Whether `left = right` introduces `left`: an unbound name, alone or applied to distinct
    /// names, that does not occur on the right.
    pub(super) fn is_new_definition(&mut self, left: &Expr, right: &Expr) -> bool {
        let head = match &left.kind {
            Kind::Apply(callee, groups) => {
                let items: Vec<&Expr> = groups.iter().flatten().flat_map(parameters_of).collect();
                if self.is_case(callee, &items) {
                    return true;
                }
                let names: Option<Vec<Symbol>> = items.iter().map(|item| name_of(item, self)).collect();
                let Some(names) = names else { return false };
                let distinct = names.iter().enumerate().all(|(i, name)| !names[..i].contains(name));
                // B_1^3(t) = 3t(1-t)^2 is a claim; B_i^n(t) = ... defines the family.
                if self.is_standard(callee) {
                    return false;
                }
                if !distinct || names.is_empty() || names.iter().any(|name| self.lookup(name).is_some()) {
                    return false;
                }
                callee.as_ref()
            }
            Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..) | Kind::Accent(..) => left,
            _ => return false,
        };
        // B_i^n(t): the base and the indices count.
        // B_{i,n}(t) = B_{n-i,n}(1-t) is about one family.
        if let (Kind::Subscript(letter, lower), Kind::Apply(..)) = (&head.kind, &left.kind)
            && let Kind::Name(letter) = &letter.kind
            && families::notation(letter, lower.len(), 0).is_some_and(|notation| notation.function.is_some())
            && has_member(right, letter)
        {
            return false;
        }
        let (head, indices): (&Expr, Vec<&Expr>) = match &head.kind {
            Kind::Pow(inner, upper) => match &inner.kind {
                Kind::Subscript(base, lower) => (base, lower.iter().chain([upper.as_ref()]).collect()),
                _ => return false,
            },
            _ => (head, Vec::new()),
        };
        let family = !indices.is_empty();
        let bare = |index: &Expr| matches!(index.kind, Kind::Name(_) | Kind::Number(_));
        if !indices.into_iter().all(bare) {
            return false;
        }
        let Some(name) = name_of(head, self) else { return false };
        if let Kind::Name(word) = &left.kind
            && self.is_product_of_letters(word)
            && self.is_a_factor_of(right, word)
        {
            return false;
        }
        let bracket = matches!(&head.kind, Kind::Subscript(_, indices) if is_bracketed(indices));
        let known = self.lookup(&name).is_some()
            || (name.is_plain() && (self.tools.function)(name.base()).is_some())
            || self.lookup(&Symbol::new(name.base())).is_some_and(|value| {
                let called = matches!((&left.kind, value), (Kind::Apply(..), Value::Function(_)));
                bracket || called || has_members(value)
            });
        // A function may have its control points called like itself: b_i^0(t) = b_i.
        let refers = match left.kind {
            Kind::Apply(..) => calls(right, &name, family, self),
            _ => uses(right, &name, self),
        };
        !known && !refers || family && self.is_further_case(&name)
    }

    /// Whether all cases of a family so far have a number among their arguments, as b_i^0(t) has.
    fn is_further_case(&self, name: &Symbol) -> bool {
        let first = |clause: &Clause| clause.parameters.iter().any(|p| matches!(p, Parameter::Exactly(_)));
        match self.lookup(name) {
            Some(Value::Function(function)) => {
                function.shape.lower > 0 && function.shape.inner > 0 && function.clauses.iter().all(first)
            }
            _ => false,
        }
    }

    /// Carries out `left := right (= further …)`.
    pub(super) fn define(&mut self, left: &Expr, links: &[Link]) -> Result<(Symbol, Value), Diagnostic> {
        let body = &links[0].expr;
        if body.kind == Kind::Ellipsis {
            return Err(Diagnostic::error(Code::BadDefinition, "dots define nothing")
                .at(body.span)
                .hint("write the formula, as in F(t) := t^2"));
        }
        if let Some(sequence) = self.sequence(left, body)? {
            return Ok(sequence);
        }
        let (name, value) = match self.target(left)? {
            Target::Name(name) => {
                self.not_reserved(&name, left)?;
                self.not_a_sequence(left, body)?;
                self.not_a_value_in_brackets(left)?;
                self.answers = !matches!(body.kind, Kind::Chain(..));
                let value = self.eval_as_written(body);
                self.answers = false;
                let value = match value? {
                    Value::Function(function) => Value::Function(Arc::new(Function {
                        name: Some(name.clone()),
                        ..(*function).clone()
                    })),
                    value => value,
                };
                (name, value)
            }
            Target::Function { name, shape, parameters } => {
                self.not_reserved(&name, left)?;
                let value = self.define_function(&name, shape, &parameters, body)?;
                (name, value)
            }
        };
        if links.len() > 1 {
            let judgements = (self.tools.judge)(self, body, &links[1..])?;
            if let Some(at) = judgements.iter().position(|judgement| judgement.verdict != Verdict::Proved) {
                self.note(
                    Diagnostic::warning(
                        Code::Undecided,
                        format!("this further equation is {}", judgements[at].verdict.word()),
                    )
                    .at(links[at + 1].span),
                );
            }
        }
        Ok((name, value))
    }

    pub(super) fn not_reserved(&self, name: &Symbol, left: &Expr) -> Result<(), Diagnostic> {
        if name.is_plain() && (self.tools.function)(name.base()).is_some() {
            return Err(Diagnostic::error(
                Code::ReservedName,
                format!("'{}' is a function of the program", name.base()),
            )
            .at(left.span)
            .reason("cannot be defined anew")
            .hint("choose another name"));
        }
        Ok(())
    }

    /// `a_i := i^2` would define one symbol named a_i, which nobody means; so would a recursion b_i^{(r)} := ....
    fn not_a_sequence(&mut self, left: &Expr, body: &Expr) -> Result<(), Diagnostic> {
        let (mut base, mut letters) = (left, Vec::new());
        while let Kind::Subscript(inner, indices) | Kind::Upper(inner, indices) = &base.kind {
            for index in indices_in_brackets(indices) {
                let Kind::Name(_) = &index.kind else { continue };
                let free = name_of(index, self).filter(|name| self.lookup(name).is_none());
                letters.extend(free.filter(|name| mentions(body, name, self)));
            }
            base = inner;
        }
        if letters.is_empty() {
            return Ok(());
        }
        letters.sort();
        let letters: Vec<String> = letters.iter().map(Symbol::to_string).collect();
        let base = name_of(base, self).map_or("a".to_owned(), |base| base.to_string());
        let error = Diagnostic::error(
            Code::BadDefinition,
            format!("this would define the one symbol named with the letter {}", letters[0]),
        )
        .at(left.span)
        .reason("an index, not an argument")
        .hint(format!("define a function of {0}: {base}({0}) := ...", letters.join(", ")));
        Err(match mentions(body, &Symbol::new(&*base), self) {
            true => error.hint(format!("of a recursion the first case goes first: {base}(i, 0) := ...")),
            false => error,
        })
    }

    /// `f[x_0] = y_0` says what a divided difference is, not what f_{x_0} is called.
    fn not_a_value_in_brackets(&mut self, left: &Expr) -> Result<(), Diagnostic> {
        let Kind::Subscript(base, indices) = &left.kind else { return Ok(()) };
        let function = name_of(base, self).is_some_and(|name| roles::FUNCTIONS.contains(&name.base()));
        let node = |index: &Expr| !matches!(index.kind, Kind::Number(_));
        match function && is_bracketed(indices) && indices_in_brackets(indices).iter().any(node) {
            true => Err(factor_or_index(left)),
            false => Ok(()),
        }
    }

    fn target(&mut self, left: &Expr) -> Result<Target, Diagnostic> {
        if let Kind::Pow(inner, _) = &left.kind
            && let Kind::Subscript(base, _) = &inner.kind
            && let Some(name) = name_of(base, self)
        {
            return Err(power_or_upper_index(&name, left.span));
        }
        let bad = || {
            Diagnostic::error(Code::BadDefinition, "only a name or a name with arguments can be defined")
                .at(left.span)
                .reason("cannot be defined")
                .hint("write F := ... or F(t) := ...")
        };
        let Kind::Apply(callee, groups) = &left.kind else {
            return name_of(left, self).map(Target::Name).ok_or_else(bad);
        };
        // f((u1, v1), (u2, v2)) has points as arguments.
        let written: Vec<&[Expr]> = groups.iter().flatten().map(parameters_of).collect();
        let count = written.len();
        let dimension = written.first().map_or(0, |first| if first.len() > 1 { first.len() } else { 0 });
        if written.iter().any(|point| point.len() != dimension.max(1)) {
            return Err(bad().hint("of several points all have the same number of coordinates"));
        }
        let inner: Vec<Expr> = written.concat();
        let (base, lower, upper): (&Expr, &[Expr], Option<&Expr>) = match &callee.kind {
            Kind::Subscript(base, lower) => (base, lower, None),
            Kind::Pow(inner, upper) => match &inner.kind {
                Kind::Subscript(base, lower) => (base, lower, Some(upper)),
                _ => (inner, &[], Some(upper)),
            },
            _ => (callee, &[], None),
        };
        // Indices that are all numbers belong to the name (f_1), unless an upper index shows a family.
        let numeric = lower.iter().all(|index| match &index.kind {
            Kind::Number(_) => true,
            Kind::Name(digits) => digits.bytes().all(|byte| byte.is_ascii_digit()), // b_{01}
            _ => false,
        });
        if upper.is_none() && numeric {
            let name = name_of(callee, self).ok_or_else(bad)?;
            let shape = Shape { dimension, ..Shape::plain(count) };
            return Ok(Target::Function { name, shape, parameters: inner });
        }
        let name = name_of(base, self).ok_or_else(bad)?;
        // b_{ij}(t) has two indices
        let lower: Vec<Expr> = lower
            .iter()
            .flat_map(|index| letters_side_by_side(index, self).unwrap_or_else(|| vec![index.clone()]))
            .collect();
        let shape =
            Shape { lower: lower.len(), upper: usize::from(upper.is_some()), inner: count, dimension };
        let parameters = lower.iter().chain(upper).cloned().chain(inner).collect();
        Ok(Target::Function { name, shape, parameters })
    }

    fn define_function(
        &mut self,
        name: &Symbol,
        shape: Shape,
        parameters: &[Expr],
        body: &Expr,
    ) -> Result<Value, Diagnostic> {
        let mut list: Vec<Parameter> = Vec::with_capacity(parameters.len());
        for parameter in parameters {
            let parsed = match &parameter.kind {
                Kind::Number(q) => Parameter::Exactly(q.clone()),
                _ => {
                    let symbol = name_of(parameter, self).ok_or_else(|| {
                        let error =
                            Diagnostic::error(Code::BadDefinition, "a parameter is a name or a number")
                                .at(parameter.span)
                                .reason("not a name");
                        match &parameter.kind {
                            Kind::Mul(_) => error.hint("in LaTeX an index is written t_1; t1 is t times 1"),
                            _ => error,
                        }
                    })?;
                    Parameter::Name(symbol)
                }
            };
            if matches!(parsed, Parameter::Name(_)) && list.contains(&parsed) {
                return Err(Diagnostic::error(Code::BadDefinition, "two parameters have the same name")
                    .at(parameter.span)
                    .reason("already used"));
            }
            list.push(parsed);
        }
        // While its body is looked at, the function is known but has no cases.
        let placeholder =
            Value::Function(Arc::new(Function { name: Some(name.clone()), shape, clauses: Vec::new() }));
        let mut clause =
            self.with_locals([(name.clone(), placeholder)], |machine| machine.clause(list, body))?;
        // The scope must not keep the placeholder: calls bind the function itself.
        Arc::make_mut(&mut clause.scope).remove(name);
        let mut clauses = match self.lookup(name) {
            Some(Value::Function(known)) if known.shape == shape => known.clauses.clone(),
            _ => Vec::new(),
        };
        let pattern = |clause: &Clause| -> Vec<Option<crate::math::number::Rational>> {
            clause
                .parameters
                .iter()
                .map(|parameter| match parameter {
                    Parameter::Name(_) => None,
                    Parameter::Exactly(q) => Some(q.clone()),
                })
                .collect()
        };
        clauses.retain(|known| pattern(known) != pattern(&clause));
        if !clauses.is_empty() {
            self.note(
                Diagnostic::note(Code::MoreCases, format!("this is a further case of {name}")).at(body.span),
            );
        }
        clauses.push(clause);
        Ok(Value::Function(Arc::new(Function { name: Some(name.clone()), shape, clauses })))
    }
}

/// Whether a value has entries or members with indices; x_1 has nothing to do with a number x.
fn has_members(value: &Value) -> bool {
    match value {
        Value::Scalar(_) => false,
        Value::Function(function) => function.shape.lower > 0,
        _ => true,
    }
}

/// The error for b_0^1 on the left of a definition.
pub(super) fn power_or_upper_index(base: &Symbol, span: Span) -> Diagnostic {
    Diagnostic::error(Code::BadDefinition, "a power cannot be defined; is this an upper index?")
        .at(span)
        .reason("read as a power")
        .hint(format!("write an upper index in parentheses: {base}_0^{{(1)}}"))
        .hint(format!(
            "a recursion has arguments and a first case: {base}_i^0(t) := ..., then {base}_i^r(t) := ..."
        ))
}

/// Whether the name occurs in the expression.
fn mentions(expr: &Expr, name: &Symbol, machine: &mut Machine) -> bool {
    if name_of(expr, machine).as_ref() == Some(name) {
        return true;
    }
    let mut children = Vec::new();
    expr.for_each_child(&mut |child| children.push(child));
    children.into_iter().any(|child| mentions(child, name, machine))
}

/// The same where a name with an index is another one: b = [b_0, b_1].
fn uses(expr: &Expr, name: &Symbol, machine: &mut Machine) -> bool {
    if name_of(expr, machine).as_ref() == Some(name) {
        return true;
    }
    if let Kind::Subscript(base, indices) = &expr.kind
        && matches!(base.kind, Kind::Name(_))
    {
        return indices.iter().any(|index| uses(index, name, machine));
    }
    let mut children = Vec::new();
    expr.for_each_child(&mut |child| children.push(child));
    children.into_iter().any(|child| uses(child, name, machine))
}

/// Whether the name is called in the expression; of a family its members count, in b(t) = b_0 (1 - t) they do not.
fn calls(expr: &Expr, name: &Symbol, family: bool, machine: &mut Machine) -> bool {
    if let Kind::Apply(callee, _) = &expr.kind
        && (family
            || !matches!(callee.kind, Kind::Subscript(..))
            || name_of(callee, machine).as_ref() == Some(name))
        && mentions(callee, name, machine)
    {
        return true;
    }
    let mut children = Vec::new();
    expr.for_each_child(&mut |child| children.push(child));
    children.into_iter().any(|child| calls(child, name, family, machine))
}

/// Whether a member of the family with a letter stands in a formula: B_{n-i,n}.
fn has_member(expr: &Expr, family: &str) -> bool {
    if let Kind::Subscript(letter, _) = &expr.kind
        && matches!(&letter.kind, Kind::Name(name) if name == family)
    {
        return true;
    }
    let mut found = false;
    expr.for_each_child(&mut |child| found = found || has_member(child, family));
    found
}
