//! One statement: a definition, a claim, or a formula to evaluate.

use super::define::power_or_upper_index;
use super::env::Env;
use super::lambda::{is_mapping, parameters_of};
use super::machine::Machine;
use super::names::name_of;
use super::tools::Tools;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::words;
use crate::language::value::{Claim, Judgement, Value, Verdict, symbol_expr};
use crate::language::write::text;
use crate::math::poly::Symbol;
use num_traits::{One, Zero};

/// What a statement did.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its value.
    pub value: Value,
    /// The name it defined, if it was a definition.
    pub defined: Option<Symbol>,
    /// Remarks: readings that somebody might not expect.
    pub notes: Vec<Diagnostic>,
    /// Whether something was claimed that fails, where the value is what shows it and no claim.
    pub fails: bool,
}

/// How `=` is understood at the top of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equals {
    /// An unbound name on its left is defined.
    DefinesUnbound,
    /// Always a claim.
    Claims,
}

/// Evaluates one statement and, if it is a definition, adds it to `env`.
///
/// `env` is changed only on success. Limits are those of [`crate::budget::run`] around it.
///
/// # Errors
/// A [`Diagnostic`] with its place.
pub fn evaluate(expr: &Expr, env: &mut Env, equals: Equals, tools: Tools) -> Result<Outcome, Diagnostic> {
    let mut machine = Machine::new(tools).with_names(env);
    let (value, defined) = machine.statement(expr, equals)?;
    machine.told_how_indices_count();
    if let Some(name) = &defined {
        env.set(name.clone(), value.clone().plain());
    }
    Ok(Outcome { value, defined, notes: machine.notes, fails: false })
}

/// The symbols of refuted equations that may be meant as unknowns: one in a polynomial equation, or those of
/// several linear ones.
fn unknowns_of(claim: &Claim) -> Option<Vec<Symbol>> {
    let mut unknowns: Vec<Symbol> = Vec::new();
    let mut linear = true;
    for judgement in &claim.judgements {
        let equation = judgement.rel == Rel::Eq && judgement.verdict == Verdict::Refuted;
        let difference = judgement.difference.as_ref().filter(|_| equation)?.as_scalar()?.as_polynomial()?;
        linear &= difference.total_degree() == Some(1);
        unknowns.extend(difference.variables().iter().cloned());
    }
    unknowns.sort();
    unknowns.dedup();
    let enough = linear && claim.judgements.len() >= unknowns.len();
    (unknowns.len() == 1 || enough && unknowns.len() > 1).then_some(unknowns)
}

impl Machine {
    /// Whether a statement defines a new name.
    pub(crate) fn defines(&mut self, statement: &Expr) -> bool {
        let Kind::Chain(left, links) = &statement.kind else { return false };
        match links[0].rel {
            Rel::Define => true,
            Rel::Eq => links.len() == 1 && self.is_new_definition(left, &links[0].expr),
            _ => false,
        }
    }

    fn statement(&mut self, expr: &Expr, equals: Equals) -> Result<(Value, Option<Symbol>), Diagnostic> {
        if let Kind::Chain(left, links) = &expr.kind {
            // f: t ↦ t^2, f := t ↦ t^2
            if let [colon, mapping] = links.as_slice()
                && matches!(colon.rel, Rel::Colon | Rel::Define)
                && is_mapping(std::slice::from_ref(mapping))
            {
                let parameters = parameters_of(&colon.expr).to_vec();
                let body =
                    Expr::new(Kind::Lambda(parameters, Box::new(mapping.expr.clone())), mapping.expr.span);
                let definition = Link { rel: Rel::Define, span: colon.span, expr: body };
                return self.define(left, &[definition]).map(|(name, value)| (value, Some(name)));
            }
            let defines = links[0].rel == Rel::Define
                || (equals == Equals::DefinesUnbound
                    && links[0].rel == Rel::Eq
                    && self.is_new_definition(left, &links[0].expr));
            if defines {
                return self.define(left, links).map(|(name, value)| (value, Some(name)));
            }
        }
        self.is_no_prose(expr)?;
        if equals == Equals::DefinesUnbound {
            self.is_no_known_parameter(expr)?;
            self.is_no_power_defined(expr)?;
            self.is_no_word_defined(expr)?;
            self.is_no_step_defined(expr)?;
        }
        is_without_words(expr)?;
        is_no_decimal_defined(expr)?;
        self.answers = !matches!(expr.kind, Kind::Chain(..));
        let value = match (self.eval_as_written(expr), &expr.kind) {
            // cases(t^2 if t < 1, 2 t - 1 otherwise) without a value for t is a function of t
            (Err(error), Kind::Cases(_)) if error.code == Code::Undecided => match self.only_symbol(expr) {
                Some(parameter) => self.eval_lambda(&[parameter], expr)?,
                None => return Err(error),
            },
            (value, _) => value?,
        };
        if let (Value::Claim(claim), Equals::DefinesUnbound) = (&value, equals) {
            self.may_be_meant_otherwise(expr, claim);
        }
        if let Kind::Sequence(items) = &expr.kind {
            self.warn_of_commas(items);
        }
        Ok((value, None))
    }

    /// Remarks on a refuted claim that may be meant as a definition or as equations to be solved.
    fn may_be_meant_otherwise(&mut self, statement: &Expr, claim: &Claim) {
        if let Kind::Chain(left, links) = &statement.kind
            && let (Kind::Name(name), [Link { rel: Rel::Eq, expr: right, .. }]) =
                (&left.kind, links.as_slice())
            && claim.verdict() == Verdict::Refuted
        {
            let known = self.lookup(&Symbol::new(name)).is_some();
            let note = |why: &str, what: &str| {
                Diagnostic::note(Code::BadDefinition, format!("a claim: {name} {why}"))
                    .at(left.span)
                    .hint(format!("write {name} := ... to {what}"))
            };
            match known {
                true => self.note(note("has a value already", "give it another")),
                false if matches!(right.kind, Kind::Apply(..)) => {
                    self.note(note("stands on the right, too", "define it"));
                }
                false => {}
            }
        }
        let chained = matches!(&statement.kind, Kind::Chain(_, links) if links.len() > 1);
        let number = |judgement: &Judgement| {
            [&judgement.left, &judgement.right].iter().any(|side| side.as_rational().is_some())
        };
        // F(t) = t^2 + 1 with a slip claims something of F for every t.
        if !claim.judgements.iter().all(number) && self.has_calls(statement) {
            return;
        }
        let Some(unknowns) = unknowns_of(claim).filter(|_| !chained) else { return };
        let names: Vec<String> = unknowns.iter().map(|name| text(&symbol_expr(name))).collect();
        let (note, equations) = match (&statement.kind, names.as_slice()) {
            (Kind::Sequence(items), _) => {
                let equations = items.iter().filter(|item| matches!(item.kind, Kind::Chain(..))).map(text);
                let all = equations.collect::<Vec<_>>().join(", ");
                (format!("these do not hold for all {}", names.join(", ")), format!("[{all}]"))
            }
            (_, [only]) => (format!("it does not hold for every {only}"), text(statement)),
            _ => return,
        };
        let note = Diagnostic::note(Code::NoIdentity, note).at(statement.span);
        self.note(note.hint(format!("solve({equations}) gives those for which it holds")));
    }

    /// Whether functions, derivatives or sums stand in an expression.
    fn has_calls(&mut self, expr: &Expr) -> bool {
        let called = match &expr.kind {
            Kind::Apply(..) => !self.is_product(expr).unwrap_or(false),
            Kind::Prime(..)
            | Kind::Derivative { .. }
            | Kind::Integral { .. }
            | Kind::Big { .. }
            | Kind::Compose(_) => true,
            Kind::Name(_) | Kind::Subscript(..) => {
                let value = name_of(expr, self).and_then(|name| self.lookup(&name).cloned());
                value.is_some_and(|value| !matches!(value, Value::Scalar(_)))
            }
            _ => false,
        };
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        called || children.into_iter().any(|child| self.has_calls(child))
    }

    /// The only letter without a value in an expression.
    fn only_symbol(&mut self, expr: &Expr) -> Option<Expr> {
        fn collect<'a>(machine: &mut Machine, expr: &'a Expr, found: &mut Vec<&'a Expr>) {
            let free = name_of(expr, machine).is_some_and(|name| machine.lookup(&name).is_none());
            match &expr.kind {
                Kind::Name(_) | Kind::Subscript(..) if free => {
                    if !found.iter().any(|known| known.same_as(expr)) {
                        found.push(expr);
                    }
                }
                _ => {
                    let mut children = Vec::new();
                    expr.for_each_child(&mut |child| children.push(child));
                    children.into_iter().for_each(|child| collect(machine, child, found));
                }
            }
        }
        let mut found = Vec::new();
        collect(self, expr, &mut found);
        match found.as_slice() {
            [only] => Some((*only).clone()),
            _ => None,
        }
    }

    /// F(t) = t^2 where t has a value neither defines F nor claims anything.
    fn is_no_known_parameter(&mut self, statement: &Expr) -> Result<(), Diagnostic> {
        let Kind::Chain(left, links) = &statement.kind else { return Ok(()) };
        let ([Link { rel: Rel::Eq, .. }], Kind::Apply(callee, groups)) = (links.as_slice(), &left.kind)
        else {
            return Ok(());
        };
        let Some(function) = name_of(callee, self).filter(|name| self.lookup(name).is_none()) else {
            return Ok(());
        };
        let named = groups.iter().flatten().all(|argument| matches!(argument.kind, Kind::Name(_)));
        let letter = function.base().chars().count() == 1 && (self.tools.function)(function.base()).is_none();
        let known = groups.iter().flatten().find_map(|argument| {
            let name = name_of(argument, self)?;
            let value = self.lookup(&name)?.as_rational()?;
            Some((name, value, argument.span))
        });
        let Some((name, value, span)) = known.filter(|_| named && letter) else { return Ok(()) };
        let shown = text(left);
        Err(Diagnostic::error(Code::BadDefinition, format!("{name} has the value {value} here"))
            .at(span)
            .reason("a parameter, or this value?")
            .hint(format!("write {shown} := ... to define a function of {name}"))
            .hint(format!("or use another letter; at the prompt :forget {name} takes its value away")))
    }

    /// Nobody claims that b_0^1 is something: without a value for b_0 it is meant as a definition.
    fn is_no_power_defined(&mut self, statement: &Expr) -> Result<(), Diagnostic> {
        let Kind::Chain(left, links) = &statement.kind else { return Ok(()) };
        let (Kind::Pow(base, exponent), [link]) = (&left.kind, links.as_slice()) else { return Ok(()) };
        let Kind::Subscript(letter, _) = &base.kind else { return Ok(()) };
        let trivial = matches!(&exponent.kind, Kind::Number(k) if k.is_zero() || k.is_one())
            || is_letter(exponent) && has_other_powers(&link.expr, base);
        let known = |machine: &mut Self, expr: &Expr| {
            name_of(expr, machine).is_none_or(|name| machine.lookup(&name).is_some())
        };
        match name_of(letter, self) {
            Some(name) if link.rel == Rel::Eq && trivial && !known(self, base) && !known(self, letter) => {
                Err(power_or_upper_index(&name, left.span))
            }
            _ => Ok(()),
        }
    }

    /// `pq = p + q` may define the name pq or claim something of the product; `knots = [0, 1]` means to define.
    fn is_no_word_defined(&mut self, statement: &Expr) -> Result<(), Diagnostic> {
        let Kind::Chain(left, links) = &statement.kind else { return Ok(()) };
        let (Kind::Name(word), [link]) = (&left.kind, links.as_slice()) else { return Ok(()) };
        let name = Symbol::new(word);
        if link.rel != Rel::Eq || self.lookup(&name).is_some() {
            return Ok(());
        }
        if (self.tools.function)(word).is_some() && word.len() > 1 && !matches!(link.expr.kind, Kind::Name(_))
        {
            return self.not_reserved(&name, left);
        }
        if !self.is_product_of_letters(word) || !self.is_a_factor_of(&link.expr, word) {
            return Ok(());
        }
        let letters: Vec<String> = word.chars().map(String::from).collect();
        Err(Diagnostic::error(Code::BadDefinition, format!("is '{word}' a new name or a product?"))
            .at(left.span)
            .reason("its letters stand on the right, too")
            .hint(format!("write {word} := ... to define the name"))
            .hint(format!("write {} = ... for a claim about the product", letters.join(" "))))
    }

    /// `Δt = t_1 - t_0` defines something with a name of two letters, which names here do not have.
    fn is_no_step_defined(&mut self, statement: &Expr) -> Result<(), Diagnostic> {
        let Kind::Chain(left, links) = &statement.kind else { return Ok(()) };
        let (Kind::Mul(factors), [link]) = (&left.kind, links.as_slice()) else { return Ok(()) };
        let [delta, letter] = factors.as_slice() else { return Ok(()) };
        let (Kind::Name(delta), Kind::Name(letter)) = (&delta.kind, &letter.kind) else { return Ok(()) };
        let step = delta == "Delta" && letter.chars().count() == 1 && link.rel == Rel::Eq;
        if !step || self.lookup(&Symbol::new(delta)).is_some() {
            return Ok(());
        }
        Err(Diagnostic::error(Code::BadDefinition, format!("is Delta {letter} a new name or a product?"))
            .at(left.span)
            .reason("read as a product")
            .hint(format!("write the letter as an index to define a name: Delta_{letter} := ..."))
            .hint(format!("write {letter} Delta = ... for a claim about the product")))
    }

    /// Whether a letter of a word stands for itself in an expression, also in another word.
    pub(super) fn is_a_factor_of(&mut self, expr: &Expr, word: &str) -> bool {
        match &expr.kind {
            Kind::Name(other) if self.is_product_of_letters(other) => other.contains(|c| word.contains(c)),
            Kind::Name(other) => other.chars().count() == 1 && word.contains(other.as_str()),
            Kind::Subscript(..) | Kind::Upper(..) => false,
            _ => {
                let mut children = Vec::new();
                expr.for_each_child(&mut |child| children.push(child));
                children.into_iter().any(|child| self.is_a_factor_of(child, word))
            }
        }
    }

    /// `1,5` is a list of two numbers; somebody may mean one and a half.
    fn warn_of_commas(&mut self, items: &[Expr]) {
        let touch = |pair: &&[Expr]| is_decimal_comma(&pair[0], &pair[1]);
        if let Some(pair) = items.windows(2).find(touch) {
            let warning = Diagnostic::warning(Code::BadNumber, "a list of numbers, not one decimal number");
            self.note(
                warning.at(pair[0].span.to(pair[1].span)).hint("decimals are written with a point: 1.5"),
            );
        }
    }
}

/// Refuses formulas with words between them, but for "and": they may be conditions. A choice has an error of
/// its own.
fn is_without_words(statement: &Expr) -> Result<(), Diagnostic> {
    let Kind::Sequence(items) = &statement.kind else { return Ok(()) };
    let word = items.iter().find_map(|item| match &item.kind {
        Kind::Text(word) if !words::joins_statements(word) && word != "or" => Some((word, item.span)),
        _ => None,
    });
    let Some((word, span)) = word else { return Ok(()) };
    Err(Diagnostic::error(Code::UnknownName, format!("'{word}' is a word, not a formula"))
        .at(span)
        .reason("words are not read")
        .hint("write one formula; a name gets its value before, in a statement of its own: t := 2")
        .hint("conditions of a claim: polarform check \"x^2 >= x\" --given \"x >= 1\""))
}

/// Whether an exponent is a letter such as r.
fn is_letter(exponent: &Expr) -> bool {
    matches!(&exponent.kind, Kind::Name(name) if name.len() == 1)
}

/// Whether powers of other members of the family of `member` stand in an expression: b_{i+1}^{r-1} beside b_i.
fn has_other_powers(expr: &Expr, member: &Expr) -> bool {
    if let (Kind::Pow(base, _), Kind::Subscript(letter, _)) = (&expr.kind, &member.kind)
        && matches!(&base.kind, Kind::Subscript(other, _) if other.same_as(letter))
        && !base.same_as(member)
    {
        return true;
    }
    let mut found = false;
    expr.for_each_child(&mut |child| found = found || has_other_powers(child, member));
    found
}

/// Refuses `x = 1,5` and `0,5 + 1`.
fn is_no_decimal_defined(statement: &Expr) -> Result<(), Diagnostic> {
    let Kind::Sequence(items) = &statement.kind else { return Ok(()) };
    let claims = |pair: &&[Expr]| {
        // 1,5 + 2,25
        let summed = || items.iter().any(|item| !matches!(item.kind, Kind::Number(_)));
        let either = items.len() == 2 || matches!(pair[0].kind, Kind::Chain(..)) || summed();
        either && is_decimal_comma(&pair[0], &pair[1])
    };
    let Some(pair) = items.windows(2).find(claims) else { return Ok(()) };
    let what = if matches!(pair[0].kind, Kind::Chain(..)) { "statements" } else { "numbers" };
    Err(Diagnostic::error(Code::BadNumber, format!("a decimal comma, or two {what}?"))
        .at(pair[0].span.to(pair[1].span))
        .hint("write a decimal with a point: 1.5")
        .hint(format!("write a blank after the comma between two {what}")))
}

/// Whether the comma between two items stands between two numbers, as in 1,5.
pub(crate) fn is_decimal_comma(before: &Expr, after: &Expr) -> bool {
    before.span.end + 1 == after.span.start && is_decimal_part(before, after)
}

/// Whether a sign between two formulas stands between two numbers.
pub(crate) fn is_decimal_part(before: &Expr, after: &Expr) -> bool {
    ends_in_number(before) && begins_with_number(after)
}

fn ends_in_number(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Add(terms) => terms.last().is_some_and(|term| ends_in_number(&term.expr)),
        Kind::Mul(factors) => factors.last().is_some_and(ends_in_number),
        Kind::Chain(_, links) => links.last().is_some_and(|link| ends_in_number(&link.expr)),
        _ => false,
    }
}

fn begins_with_number(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Add(terms) => terms.first().is_some_and(|term| begins_with_number(&term.expr)),
        Kind::Mul(factors) => factors.first().is_some_and(begins_with_number),
        Kind::Div(above, ..) | Kind::Pow(above, _) => begins_with_number(above),
        Kind::Chain(left, _) => begins_with_number(left),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::syntax;

    /// Without tools there are formulas and definitions, but no functions and no verdicts.
    #[test]
    fn the_evaluator_knows_only_what_it_is_handed() {
        let tools = Tools {
            function: |_| None,
            names: Vec::new,
            alias: |_| None,
            synonym: |_| None,
            is_word: |_| false,
            argument_word: |_| false,
            judge: |_, _, _| Ok(Vec::new()),
        };
        let mut env = Env::default();
        let mut run = |text: &str| {
            let statement = syntax::parse(text).unwrap();
            evaluate(&statement, &mut env, Equals::DefinesUnbound, tools)
        };
        run("F(t) := t^2 + 1").unwrap();
        assert_eq!(run("F(3)").unwrap().value.as_int(), Some(10));
        assert_eq!(run("sum(i=1..4, i)").unwrap().value.as_int(), Some(10));
        assert!(run("degree(t^2, t)").is_err());
        let Value::Claim(claim) = run("1 + 1 = 3").unwrap().value else { panic!("not a claim") };
        assert!(claim.judgements.is_empty());
    }
}
