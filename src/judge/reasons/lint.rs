//! What is suspicious in a definition, and equations that define coefficients.

use crate::language::lexicon::roles;
use crate::language::lexicon::words::is_function_word;
use std::collections::BTreeSet;

use crate::formula::{BigOp, Expr, Kind, Rel};
use crate::judge::page::context::Context;
use crate::judge::page::statement::{Chain, Place, Side};
use crate::judge::values::compare;
use crate::judge::written::features::missing_argument;
use crate::judge::written::names::{Head, bases, implied_index, integer_names, own_names, walk};
use crate::language::value::Value;
use crate::language::write;
use crate::math::linalg;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use nalgebra::DMatrix;

/// A warning about a definition: an index that nothing binds, or an argument that does not occur.
pub fn definition(head: &Head, body: &Expr, conditions: &[Expr]) -> Option<String> {
    let mut given: BTreeSet<String> = BTreeSet::new();
    for part in head.lower.iter().chain(&head.upper).chain(head.flat()) {
        walk(part, &mut |part| {
            if let Kind::Name(name) = &part.kind {
                given.insert(name.clone());
            }
        });
    }
    for condition in conditions {
        walk(condition, &mut |part| {
            if let Kind::Name(name) = &part.kind {
                given.insert(name.clone());
            }
        });
    }
    unbound_index(head, body, &given)
        .or_else(|| missing_argument(head, body))
        .or_else(|| index_of_its_own(head, body))
}

/// Chains that only order names, as a = x_0 < x_1 < … < x_n = b, say what names stand for.
pub fn declares(chain: &Chain) -> Option<&'static str> {
    let ordered = chain.relations.iter().any(|(rel, _)| matches!(rel, Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge));
    let constant = |side: &Side| bases(&side.expr).is_empty() && side.expr.kind != Kind::Ellipsis;
    let names = chain.sides.iter().all(|side| {
        side.expr.kind == Kind::Ellipsis
            || constant(side)
            || Head::of(&side.expr).is_some_and(|head| head.arguments.is_none())
    });
    if ordered && names && chain.relations.len() > 1 {
        return Some("orders names");
    }
    // M_0 = M_n = 0, but w = 2 + 1 = 3 calculates.
    let values = chain.sides.iter().filter(|side| constant(side)).count();
    let set = names
        && values < 2
        && chain.relations.len() > 1
        && chain.relations.iter().all(|(rel, _)| *rel == Rel::Eq)
        && (chain.sides.last().is_some_and(constant)
            || chain.sides.iter().any(|side| side.expr.kind == Kind::Ellipsis));
    set.then_some("sets values")
}

/// f(b, c) = g(b, c): two unknown functions are to agree somewhere.
pub fn joins(context: &Context, chain: &Chain, place: &Place) -> Option<String> {
    let call = |expr: &Expr| -> Option<(String, Vec<String>)> {
        let head = Head::of(expr).filter(|head| head.arguments.is_some() && head.lower.is_empty())?;
        // f(x) = \sqrt x is one function.
        if head.base == "sqrt" || is_function_word(&head.base) {
            return None;
        }
        let known = context.visible(&head.base, place).any(|(_, d, near)| near && d.head.arguments.is_some());
        let arguments = head.flat().iter().map(|argument| write::text(argument)).collect();
        (!known).then_some((head.base, arguments))
    };
    let [left, right] = [call(&chain.sides[0].expr)?, call(&chain.sides[1].expr)?];
    (left.0 != right.0 && left.0.to_lowercase() != right.0.to_lowercase() && left.1 == right.1)
        .then(|| format!("a condition on {} and {}", left.0, right.0))
}

/// a_i x^k under a sum over k: the index i belongs to nothing.
fn unbound_index(head: &Head, body: &Expr, given: &BTreeSet<String>) -> Option<String> {
    let free: BTreeSet<String> = integer_names(body)
        .into_iter()
        .filter(|name| roles::is_running(name) && !given.contains(name))
        .collect();
    let mut warning = None;
    // Within a sum: a factor with an index, none of whose indices is that of the sum.
    walk(body, &mut |part| {
        let Kind::Big { lower, body, op, .. } = &part.kind else { return };
        if warning.is_some() || !matches!(op, BigOp::Sum | BigOp::Product) {
            return;
        }
        let own = own_names(lower);
        let Some(index) = own.first() else { return };
        walk(body, &mut |part| {
            let Kind::Subscript(_, indices) = &part.kind else { return };
            let names: BTreeSet<String> =
                indices.iter().flat_map(crate::judge::written::names::bases).collect();
            if let Some(other) = names.iter().find(|name| free.contains(*name))
                && !own.iter().any(|name| names.contains(name))
                && warning.is_none()
            {
                warning = Some(format!(
                    "{} has the index {other}, but the sum runs over {index}: nothing says what {other} is",
                    write::text(part)
                ));
            }
        });
        // A condition of the sum on another letter: k ≠ j
        for piece in &lower[1.min(lower.len())..] {
            if let Some(other) = integer_names(piece)
                .iter()
                .find(|name| free.contains(*name) && !own.contains(name) && roles::is_running(name))
                && warning.is_none()
            {
                warning = Some(format!(
                    "the condition {} uses {other}, which is neither an index here nor on the left",
                    write::text(piece)
                ));
            }
        }
    });
    if warning.is_some() {
        return warning;
    }
    let indexed = !head.lower.is_empty();
    let mut binomials = BTreeSet::new();
    walk(body, &mut |part| {
        if let Kind::Binomial(n, k, _) = &part.kind {
            binomials.extend(crate::judge::written::names::bases(n));
            binomials.extend(crate::judge::written::names::bases(k));
        }
    });
    let other = free.iter().find(|name| binomials.contains(*name))?;
    indexed.then(|| format!("nothing says what {other} is: it is no index on the left"))
}

/// Φ_i(τ) = Π_1^n (t_i − τ): the i on the left is that of the product.
fn index_of_its_own(head: &Head, body: &Expr) -> Option<String> {
    let Kind::Big { lower, body: inner, .. } = &body.kind else { return None };
    let own = own_names(lower).first().cloned().or_else(|| implied_index(inner))?;
    let left = head.lower.iter().any(|index| matches!(&index.kind, Kind::Name(name) if *name == own));
    // In Σ_{1 ≤ i_1 < … < i_k ≤ n} k says how many there are.
    let runs = |expr: &Expr| stands_alone(expr, &own);
    (left && (lower.is_empty() || lower.iter().any(runs)))
        .then(|| format!("the right side does not depend on the index {own} of {}", head.base))
}

/// Coefficients that an equation defines: symbols of one letter that were not met before, found by
/// comparing the coefficients of both sides.
pub fn unknowns(
    context: &Context,
    place: &Place,
    left: &Value,
    right: &Value,
) -> Option<Vec<(Symbol, Fraction)>> {
    let (sl, sr) = (compare::symbols(left), compare::symbols(right));
    let only = |a: &[Symbol], b: &[Symbol]| -> Vec<Symbol> {
        a.iter().filter(|symbol| !b.contains(symbol)).cloned().collect()
    };
    let sides = [only(&sr, &sl), only(&sl, &sr)];
    let mut lists = sides.into_iter().filter(|list| {
        !list.is_empty()
            && list.iter().all(|symbol| {
                !symbol.indices().is_empty()
                    && symbol.base() == list[0].base()
                    && !crate::judge::instances::hypotheses::is_coefficient(symbol)
                    && context.visible(symbol.base(), place).all(|(_, _, near)| !near)
            })
    });
    lists.find_map(|new| solved_for(new, left, right))
}

/// The values of the new symbols by comparing coefficients, if the equations are as many.
fn solved_for(new: Vec<Symbol>, left: &Value, right: &Value) -> Option<Vec<(Symbol, Fraction)>> {
    let (sl, sr) = (compare::symbols(left), compare::symbols(right));
    if new.len() < 2 {
        return None;
    }
    // Each entry of the difference is linear in the new symbols; coefficients of the other
    // symbols that are not on both sides are compared.
    let differences: Vec<Fraction> = match (left, right) {
        (Value::Scalar(a), Value::Scalar(b)) => vec![a.minus(b)],
        (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => {
            a.iter().zip(b.iter()).map(|(x, y)| x.minus(y)).collect()
        }
        (Value::List(a), Value::List(b)) if a.len() == b.len() => {
            a.iter().zip(b).map(|(x, y)| Some(x.as_scalar()?.minus(y.as_scalar()?))).collect::<Option<_>>()?
        }
        _ => return None,
    };
    let variables: Vec<Symbol> =
        sl.iter().chain(&sr).filter(|symbol| symbol.is_plain() && !new.contains(symbol)).cloned().collect();
    let mut equations: Vec<MultiPoly> = Vec::new();
    for difference in differences {
        let mut parts = vec![difference.as_polynomial()?.clone()];
        for variable in &variables {
            parts = parts.iter().flat_map(|part| part.coefficients_in(variable)).collect();
        }
        equations.extend(parts.into_iter().filter(|part| !part.is_empty()));
    }
    let zero = || Fraction::from(MultiPoly::zero());
    let mut rows = Vec::new();
    let mut constants = Vec::new();
    for equation in &equations {
        let mut rest = equation.clone();
        let mut row = Vec::with_capacity(new.len());
        for symbol in &new {
            if equation.degree_in(symbol) > 1 {
                return None;
            }
            let parts = rest.coefficients_in(symbol);
            row.push(Fraction::from(parts.get(1).cloned().unwrap_or_else(MultiPoly::zero)));
            rest = parts.into_iter().next().unwrap_or_else(MultiPoly::zero);
        }
        rows.extend(row);
        constants.push(zero().minus(&Fraction::from(rest)));
    }
    if equations.len() != new.len() {
        return None;
    }
    let matrix = DMatrix::from_row_iterator(new.len(), new.len(), rows);
    let constants = DMatrix::from_row_iterator(new.len(), 1, constants);
    let solution = linalg::solve(&matrix, &constants).ok()?;
    Some(new.into_iter().zip(solution.iter().cloned()).collect())
}

/// Whether a name stands in a formula, and not as an index only.
fn stands_alone(expr: &Expr, name: &str) -> bool {
    match &expr.kind {
        Kind::Name(own) => own == name,
        Kind::Subscript(base, _) => stands_alone(base, name),
        _ => {
            let mut found = false;
            expr.for_each_child(&mut |child| found |= stands_alone(child, name));
            found
        }
    }
}
