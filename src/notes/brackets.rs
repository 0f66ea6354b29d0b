//! Polar forms called with brackets: b\[t_1, t_2, t_3\] or b⟨t_1, t_2, t_3⟩ beside the curve b(t).

use std::collections::BTreeSet;

use super::primes::each;
use crate::formula::source::SourceFile;
use crate::formula::{Accent, Expr, Kind, bracketed};
use crate::judge::page::statement::Statement;
use crate::judge::page::topic::Topic;
use crate::judge::written::names::{Head, underived, walk};

/// Reads a bracket after a letter as arguments where the page, or a section with that letter, speaks of polar forms
/// and not of divided differences. A letter that is applied with parentheses, too, gets another name with brackets.
///
/// Cost: linear in the formulas.
pub(super) fn as_arguments(file: &SourceFile, statements: &mut [Statement]) {
    let polar = |s: &Statement| s.topics.has(Topic::PolarForm) && !s.topics.has(Topic::DividedDifference);
    let differences = statements.iter().any(|s| s.topics.has(Topic::DividedDifference));
    let (mut letters, mut likely) = (BTreeSet::new(), BTreeSet::new());
    let mut called = BTreeSet::new();
    let general = !differences && statements.iter().any(polar);
    for statement in statements.iter_mut() {
        let meant = general || polar(statement);
        each(statement, &mut |expr| {
            walk(expr, &mut |part| match &part.kind {
                Kind::Mul(factors) if meant => {
                    let pairs = factors.windows(2);
                    for call in pairs.filter_map(|pair| call(file, &pair[0], &pair[1])) {
                        if call.certain { &mut letters } else { &mut likely }.insert(call.letter);
                    }
                }
                Kind::Apply(callee, groups) if groups.iter().flatten().count() == 1 => {
                    called.extend(Head::of(underived(callee)).map(|head| head.base));
                }
                _ => {}
            });
        });
    }
    for statement in statements.iter_mut().filter(|statement| general || polar(statement)) {
        each(statement, &mut |expr| split_digits(file, expr));
    }
    // p[uv] beside p(t): a function is no factor.
    letters.extend(likely.intersection(&called).cloned());
    if letters.is_empty() {
        return;
    }
    for statement in statements {
        each(statement, &mut |expr| apply(file, expr, &letters, &called));
    }
}

/// What stands in a bracket of one of these kinds.
fn inside<'a>(file: &SourceFile, bracket: &'a Expr) -> Option<&'a [Expr]> {
    match &bracket.kind {
        Kind::List(items) => Some(items),
        Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if name == "inner") => {
            groups.first().map(Vec::as_slice)
        }
        Kind::Group(one) => {
            let written =
                file.slice(bracket.span).trim_start_matches(|c: char| c == '\\' || c.is_alphabetic());
            written.trim_start().starts_with('[').then(|| std::slice::from_ref(&**one))
        }
        _ => None,
    }
}

/// A letter before a bracket with arguments.
struct Call {
    letter: String,
    arguments: Vec<Expr>,
    /// Whether it is one whatever the page says of the letter: several arguments with commas, dots, repetitions.
    certain: bool,
}

/// b[t_1, t_2], b[t_1…t_n], b[0^{n-i}1^i]; where others are written like that, b[uv] and b[012], too.
fn call(file: &SourceFile, function: &Expr, bracket: &Expr) -> Option<Call> {
    let items = inside(file, bracket)?;
    let single = |expr: &Expr| {
        matches!(
            expr.kind,
            Kind::Name(_) | Kind::Number(_) | Kind::Subscript(..) | Kind::Accent(..) | Kind::Ellipsis
        )
    };
    let repeated = |expr: &Expr| matches!(&expr.kind, Kind::Pow(base, _) if single(base));
    let (arguments, certain) = match items {
        [one] => match &one.kind {
            Kind::Mul(factors) if factors.iter().all(|factor| single(factor) || repeated(factor)) => {
                let told = |factor: &Expr| factor.kind == Kind::Ellipsis || repeated(factor);
                (factors.clone(), factors.iter().any(told))
            }
            Kind::Number(_) => (digits(file, one).filter(|digits| digits.len() > 1)?, false),
            _ => return None,
        },
        several => (several.to_vec(), several.len() > 1),
    };
    // s_j[u, v] is the polar form of a piece.
    let plain = |head: &Head| head.lower.len() < 2 && head.upper.is_empty() && head.arguments.is_none();
    let head = Head::of(function).filter(plain)?;
    Some(Call { letter: head.base, arguments, certain })
}

/// The digits of a number as it is written, one by one.
fn digits(file: &SourceFile, number: &Expr) -> Option<Vec<Expr>> {
    let digit = |digit: char| Some(Expr::new(Expr::int(i64::from(digit.to_digit(10)?)).kind, number.span));
    file.slice(number.span).trim().chars().map(digit).collect()
}

/// f(01^2): a power after digits that begin with 0 is one of the last digit.
fn split_digits(file: &SourceFile, expr: &mut Expr) {
    expr.for_each_child_mut(&mut |child| split_digits(file, child));
    let Kind::Apply(_, groups) = &mut expr.kind else { return };
    let [group] = groups.as_mut_slice() else { return };
    let [Expr { kind: Kind::Pow(base, exponent), span }] = group.as_slice() else { return };
    if let (Kind::Number(_), Some(mut factors)) = (&base.kind, digits(file, base))
        && factors.len() > 1
        && file.slice(base.span).starts_with('0')
        && let Some(last) = factors.pop()
    {
        factors.push(last.power(exponent.as_ref().clone()));
        *group = vec![Expr::new(Kind::Mul(factors), *span)];
    }
}

fn apply(file: &SourceFile, expr: &mut Expr, letters: &BTreeSet<String>, called: &BTreeSet<String>) {
    expr.for_each_child_mut(&mut |child| apply(file, child, letters, called));
    let Kind::Mul(factors) = &mut expr.kind else { return };
    let mut at = 0;
    while at + 1 < factors.len() {
        if let Some(own) =
            call(file, &factors[at], &factors[at + 1]).filter(|own| letters.contains(&own.letter))
        {
            let mut callee = factors[at].clone();
            if called.contains(&own.letter) {
                rename(&mut callee);
            }
            let span = callee.span.to(factors[at + 1].span);
            let value = Expr::new(Kind::Apply(Box::new(callee), vec![own.arguments]), span);
            factors.splice(at..at + 2, [value]);
        }
        at += 1;
    }
    if let [only] = factors.as_slice() {
        *expr = only.clone();
    }
}

fn rename(callee: &mut Expr) {
    match &mut callee.kind {
        Kind::Name(name) => *name = bracketed(name),
        Kind::Accent(Accent::Bold | Accent::Script | Accent::Blackboard, inner)
        | Kind::Subscript(inner, _) => rename(inner),
        _ => {}
    }
}
