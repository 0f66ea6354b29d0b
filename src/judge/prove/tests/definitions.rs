//! Names and calls that notes define, unfolded by the lookup.

use std::collections::BTreeMap;

use super::{Proof, sides};
use crate::formula::{Expr, Kind};
use crate::judge::prove::prove;
use crate::language::latex;

/// `left = right` as a rule for the letters among its parameters.
struct Rule {
    parameters: Vec<&'static str>,
    left: Expr,
    right: Expr,
}

fn rule(parameters: &[&'static str], text: &str) -> Rule {
    let (left, right) = sides(text);
    Rule { parameters: parameters.to_vec(), left: left.without_spans(), right: right.without_spans() }
}

type Found = BTreeMap<String, Expr>;

/// Whether the expression has the shape of the pattern; the parameters stand for anything.
fn fits(pattern: &Expr, expr: &Expr, parameters: &[&str], found: &mut Found) -> bool {
    if let Kind::Name(name) = &pattern.kind
        && parameters.contains(&name.as_str())
    {
        return found.insert(name.clone(), expr.clone()).is_none_or(|old| old.same_as(expr));
    }
    let (mut a, mut b) = (Vec::new(), Vec::new());
    pattern.for_each_child(&mut |child| a.push(child));
    expr.for_each_child(&mut |child| b.push(child));
    if a.is_empty() || b.is_empty() {
        return pattern.same_as(expr);
    }
    std::mem::discriminant(&pattern.kind) == std::mem::discriminant(&expr.kind)
        && a.len() == b.len()
        && a.into_iter().zip(b).all(|(x, y)| fits(x, y, parameters, found))
}

fn put(expr: &Expr, found: &Found) -> Expr {
    if let Kind::Name(name) = &expr.kind
        && let Some(value) = found.get(name)
    {
        return value.clone();
    }
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = put(child, found));
    result
}

fn proof_given(rules: &[Rule], text: &str) -> Option<Proof> {
    let lookup = |expr: &Expr| {
        let expr = expr.clone().without_spans();
        rules.iter().find_map(|rule| {
            let mut found = Found::new();
            fits(&rule.left, &expr, &rule.parameters, &mut found).then(|| put(&rule.right, &found).grouped())
        })
    };
    let (left, right) = sides(text);
    prove(&left, &right, &lookup)
}

#[test]
fn curves() {
    let rules = [rule(&["t"], r"P(t) = \sum_{i=0}^n b_i B_i^n(t)")];
    for text in [
        r"P(0) = b_0",
        r"P(1) = b_n",
        r"P'(t) = n\sum_{i=0}^{n-1}(b_{i+1} - b_i)B_i^{n-1}(t)",
        r"P'(t) = n\sum_{i=0}^{n-1}\Delta b_i B_i^{n-1}(t)",
        r"\dot{P}(0) = n (b_1 - b_0)",
        r"P'(0) = n \Delta b_0",
        r"P'(1) = n (b_n - b_{n-1})",
        r"P''(0) = n(n-1)(b_2 - 2b_1 + b_0)",
        r"P''(0) = n(n-1)\Delta^2 b_0",
        r"\frac{d}{dt}P(t) = n\sum_{i=0}^{n-1}B_i^{n-1}(t)(b_{i+1} - b_i)",
        r"P^{(k)}(t) = \frac{n!}{(n-k)!}\sum_{i=0}^{n-k}\Delta^k b_i B_i^{n-k}(t)",
        r"\int_0^1 P(t) dt = \frac{1}{n+1}\sum_{i=0}^n b_i",
        r"P(1-t) = \sum_{i=0}^n b_{n-i} B_i^n(t)",
    ] {
        assert!(proof_given(&rules, text).is_some(), "{text}");
    }
    for text in [
        r"P(0) = b_1",
        r"P'(0) = n (b_0 - b_1)",
        r"P'(1) = n (b_n + b_{n-1})",
        r"P''(0) = n^2(b_2 - 2b_1 + b_0)",
        r"P''(0) = n(n-1)(b_2 - b_1 + b_0)",
        r"P^{(k)}(t) = \frac{n!}{(n-k)!}\sum_{i=0}^{n-k}\Delta^k b_i B_i^{n-k+1}(t)",
        r"P^{(k)}(t) = \frac{n!}{(n-k)!}\sum_{i=0}^{n-k}\Delta^{k+1} b_i B_i^{n-k}(t)",
        r"P(1-t) = \sum_{i=0}^n b_{i} B_i^n(t)",
        r"P(t+1) = P(t) + P(1)",
        r"Q(t) = \sum_{i=0}^n b_i B_i^n(t)",
    ] {
        assert!(proof_given(&rules, text).is_none(), "{text}");
    }
}

#[test]
fn other_notations() {
    let degree_first = [rule(&["n", "i", "t"], r"B_{n,i}(t) = \binom{n}{i} t^i (1-t)^{n-i}")];
    let text = r"B_{n,i}(x) = (1-x) B_{n-1, i}(x) + x B_{n-1, i-1}(x)";
    assert!(proof_given(&degree_first, text).is_some());
    assert!(proof_given(&[], text).is_none());
    let wrong = r"B_{n,i}(x) = (1-x) B_{n-1, i-1}(x) + x B_{n-1, i}(x)";
    assert!(proof_given(&degree_first, wrong).is_none());
}

/// A definition in the notes counts, not the standard meaning.
#[test]
fn other_meanings() {
    let own = [rule(&["i", "n", "t"], r"B_i^n(t) = \binom{n}{i} t^i (1+t)^{n-i}")];
    assert!(proof_given(&own, r"\sum_{i=0}^n B_i^n(t) = 1").is_none());
    assert!(proof_given(&own, r"\sum_{i=0}^n B_i^n(t) = (1+2t)^n").is_some());
    let backward = [rule(&["i"], r"\Delta b_i = b_i - b_{i-1}")];
    assert!(proof_given(&backward, r"\Delta b_i = b_{i+1} - b_i").is_none());
    assert!(proof_given(&backward, r"\Delta b_{i+1} = b_{i+1} - b_i").is_some());
    let circular =
        [rule(&["t"], r"F(t) = F(t) + 1"), rule(&["t"], r"G(t) = H(t)"), rule(&["t"], r"H(t) = G(t)")];
    assert!(proof_given(&circular, r"F(t) = 1").is_none());
    assert!(proof_given(&circular, r"G(t) = 1").is_none());
}

/// Formulas nested as deeply as the reader allows, and long ones, end soon.
#[test]
fn large_input() {
    let deep = format!("{}t{} = t", "(".repeat(120), ")".repeat(120));
    let (left, right) = sides(&deep);
    assert!(prove(&left, &right, &|_| None).is_some());
    for text in [
        "t^{1000000000} = t",
        r"\binom{n+1000000000000}{k} = 0",
        r"(n+99999999999999999999)! = n!",
        r"\Delta^{1000000} b_i = 0",
        r"\frac{d^{1000000}}{dt^{1000000}} t^n = 0",
        r"(a+b+c+x+y+z)^{n+24} = a (a+b+c+x+y+z)^{n}",
        r"\sum_{i=0}^{n} i^{40} = n",
        r"\prod_{j=0}^{100000}(n-j) = n",
        r"2^{99999999999999999999 n} = 1",
        r"\left(\sum_{i=0}^n b_i\right)^{12} = 0",
    ] {
        let (left, right) = sides(text);
        let started = std::time::Instant::now();
        assert!(prove(&left, &right, &|_| None).is_none(), "{text}");
        assert!(started.elapsed().as_secs() < 5, "{text}");
    }
    assert!(latex::read("").is_err());
}
