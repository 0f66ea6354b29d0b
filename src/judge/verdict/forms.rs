//! Forms of equations that are told apart before they are judged.

use crate::formula::{Expr, Kind};
use crate::judge::page::context::is_variable;
use crate::judge::written::names::{Head, bases, is_index_letter};

/// Whether a call on the left of an equation is one at variables: S(x) = … is, S(a) = y_0 is a value of S, and
/// g(a) = a says that a is a fixed point of g.
pub fn names_its_variables(head: &Head, body: &Expr) -> bool {
    // H(a) = y_a says a value of H: a is a label there.
    let labelled = matches!(body.kind, Kind::Subscript(..));
    let inside = if labelled { Default::default() } else { bases(body) };
    let arguments = head.flat();
    let Some(Expr { kind: Kind::Name(only), .. }) = arguments.first().filter(|_| arguments.len() == 1) else {
        return !is_value_at_points(&arguments, body);
    };
    let fixed = matches!(body.kind, Kind::Name(_));
    is_variable(only) || is_index_letter(only) || inside.contains(only) && !fixed
}

/// f(A, A) = 0; f(A, B) = 1, where A and B are no variables.
fn is_value_at_points(arguments: &[&Expr], body: &Expr) -> bool {
    let name = |argument: &&Expr| match &argument.kind {
        Kind::Name(name) => Some(name.clone()),
        _ => None,
    };
    let names: Vec<String> = arguments.iter().filter_map(name).collect();
    let again = (1..names.len()).any(|at| names[..at].contains(&names[at]));
    let points = names.len() == arguments.len()
        && !names.is_empty()
        && !names.iter().any(|name| is_variable(name) || is_index_letter(name));
    again || points && bases(body).is_empty()
}

/// p(t): no value of p, but p itself.
pub fn is_at_variable(side: &Expr) -> bool {
    let Kind::Apply(_, groups) = &side.kind else { return false };
    matches!(groups.concat().as_slice(), [Expr { kind: Kind::Name(name), .. }] if is_variable(name))
}

/// Whether a formula for a function of variables applies it to others: f(u, v, t) = (1 - s) f(u, v, a) + s f(u, v, b) is
/// a law of f. Where the variable is an integer it may be a recursion.
pub fn is_law(head: &Head, right: &Expr) -> bool {
    let arguments = head.flat();
    let variable = |argument: &&Expr| matches!(&argument.kind, Kind::Name(name) if !is_index_letter(name));
    let own = |part: &Expr| match &part.kind {
        Kind::Apply(callee, groups) => {
            matches!(&callee.kind, Kind::Name(name) if *name == head.base)
                && groups.iter().map(Vec::len).sum::<usize>() == arguments.len()
        }
        _ => false,
    };
    head.lower.is_empty()
        && head.upper.is_empty()
        && !arguments.is_empty()
        && arguments.iter().all(variable)
        && right.has(&own)
}
