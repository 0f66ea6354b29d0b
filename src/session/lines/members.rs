//! Members of a family without their argument, beside others: `B_0^2 + B_1^2 + B_2^2 = 1` is about the polynomials.

use crate::formula::{Expr, Kind, Rel, applied, call};
use crate::judge::written::names::bases;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::{families, roles};
use crate::language::value::Value;
use crate::language::write;
use crate::math::poly::Symbol;
use crate::session::{Session, defines};

impl Session {
    /// A statement whose members of families have their argument, and a remark on it.
    ///
    /// All of them are read so or none: each has integers i and n with 0 <= i <= n, and there are two different ones, or one is
    /// claimed to be something or handed to a function, for B_1^2 by itself may be a power.
    pub(in crate::session) fn with_members_called(&self, statement: Expr) -> (Expr, Option<Diagnostic>) {
        let mut found = Members { env: &|name| defines(&self.env, name), ..Members::default() };
        found.gather(&statement);
        // B_0^2 = (1 - t)^2
        found.asked |= matches!(&statement.kind, Kind::Chain(_, links)
            if links.iter().all(|link| matches!(link.rel, Rel::Eq | Rel::Ne | Rel::Le | Rel::Ge | Rel::Lt | Rel::Gt)));
        let distinct = |names: &[String]| names.windows(2).any(|pair| pair[0] != pair[1]);
        if found.others || found.alone.is_empty() || !(found.asked || distinct(&found.names)) {
            return (statement, None);
        }
        let (span, letter) = (found.alone[0].span, found.argument(&statement));
        let read = applied(found.alone[0].clone(), vec![letter.clone()], span);
        let note = Diagnostic::note(
            Code::StandardMeaning,
            format!("{} is read as {}", write::text(&found.alone[0]), write::text(&read)),
        )
        .at(span)
        .hint(power(&found.alone[0]));
        let mut statement = statement;
        put(&mut statement, &|expr| found.member(expr).is_some(), &letter);
        (statement, Some(note))
    }
}

impl Session {
    /// Bernstein's operator before the name of a function: B_n f, where n and f have values and B has none.
    pub(in crate::session) fn with_operator_applied(&self, statement: Expr) -> (Expr, Option<Diagnostic>) {
        let Kind::Mul(factors) = &statement.kind else { return (statement, None) };
        let [operator, function] = factors.as_slice() else { return (statement, None) };
        let (Kind::Subscript(letter, indices), Kind::Name(name)) = (&operator.kind, &function.kind) else {
            return (statement, None);
        };
        let (Kind::Name(letter), [degree]) = (&letter.kind, indices.as_slice()) else {
            return (statement, None);
        };
        let function_known = matches!(self.env.get(&Symbol::new(name)), Some(Value::Function(_)));
        if letter != "B" || defines(&self.env, letter) || !function_known {
            return (statement, None);
        }
        let meant = call("bernstein_approximation", vec![function.clone(), degree.clone()], statement.span);
        let note = format!("{} is read as {}", write::text(&statement), write::text(&meant));
        let note = Diagnostic::note(Code::StandardMeaning, note).at(statement.span);
        (meant, Some(note.hint("write B_n * f for a product")))
    }
}

struct Members<'a> {
    env: &'a dyn Fn(&str) -> bool,
    /// The members without an argument.
    alone: Vec<Expr>,
    /// All members as written.
    names: Vec<String>,
    /// The argument of one that has it.
    called: Option<Expr>,
    /// Whether the letter stands for something else, too.
    others: bool,
    /// Whether a function is asked of one.
    asked: bool,
}

impl Default for Members<'_> {
    fn default() -> Self {
        Members {
            env: &|_| false,
            alone: Vec::new(),
            names: Vec::new(),
            called: None,
            others: false,
            asked: false,
        }
    }
}

impl Members<'_> {
    fn member(&self, expr: &Expr) -> Option<()> {
        let Kind::Pow(base, upper) = &expr.kind else { return None };
        let Kind::Subscript(letter, lower) = &base.kind else { return None };
        let (Kind::Name(letter), [lower]) = (&letter.kind, lower.as_slice()) else { return None };
        let family = families::notation(letter, 1, 1).is_some_and(|notation| notation.function.is_some());
        let (i, n) = (lower.as_int()?, upper.as_int()?);
        (family && !(self.env)(letter) && (0..=n).contains(&i) && n > 0).then_some(())
    }

    fn gather(&mut self, expr: &Expr) {
        if self.member(expr).is_some() {
            self.alone.push(expr.clone());
            self.names.push(write::text(expr));
            return;
        }
        match &expr.kind {
            Kind::Apply(callee, groups) => {
                match self.member(callee) {
                    Some(()) => {
                        self.names.push(write::text(callee));
                        self.called = groups.first().and_then(|group| group.first()).cloned();
                    }
                    // (B_0^2 + B_1^2)(t) has its argument
                    None => self.others |= callee.has(&|part| self.member(part).is_some()),
                }
                self.asked |= groups.iter().flatten().any(|argument| self.member(argument).is_some());
                groups.iter().flatten().for_each(|argument| self.gather(argument));
            }
            Kind::Mul(factors) => {
                let called = |pair: &[Expr]| {
                    matches!(pair[0].kind, Kind::Group(_))
                        && matches!(pair[1].kind, Kind::Group(_) | Kind::Tuple(_))
                        && pair[0].span.end == pair[1].span.start
                        && pair[0].has(&|part| self.member(part).is_some())
                };
                self.others |= factors.windows(2).any(called);
                factors.iter().for_each(|factor| self.gather(factor));
            }
            Kind::Subscript(letter, _) => {
                self.others |= matches!(&letter.kind, Kind::Name(name)
                    if families::notation(name, 1, 1).is_some_and(|own| own.function.is_some()));
            }
            _ => expr.for_each_child(&mut |child| self.gather(child)),
        }
    }

    /// The argument that others have, or the variable of the statement.
    fn argument(&self, statement: &Expr) -> Expr {
        if let Some(called @ Expr { kind: Kind::Name(_), .. }) = &self.called {
            return called.clone();
        }
        let names = bases(statement);
        let mut variables = names.iter().filter(|name| roles::is_variable(name) && !(self.env)(name));
        match (variables.next(), variables.next()) {
            (Some(only), None) => Expr::name(only),
            _ => Expr::name("t"),
        }
    }
}

fn power(member: &Expr) -> String {
    match &member.kind {
        Kind::Pow(base, exponent) => {
            format!("write ({})^{} for a power", write::text(base), write::text(exponent))
        }
        _ => String::new(),
    }
}

/// Gives members their argument.
fn put(expr: &mut Expr, member: &dyn Fn(&Expr) -> bool, letter: &Expr) {
    if member(expr) {
        let span = expr.span;
        *expr = applied(expr.clone(), vec![Expr { span, ..letter.clone() }], span);
        return;
    }
    if let Kind::Apply(callee, groups) = &mut expr.kind {
        if !member(callee) {
            put(callee, member, letter);
        }
        groups.iter_mut().flatten().for_each(|one| put(one, member, letter));
        return;
    }
    expr.for_each_child_mut(&mut |child| put(child, member, letter));
}
