//! Closed forms of random sums against adding up.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{One, ToPrimitive, Zero};
use proptest::prelude::*;
use proptest::strategy::ValueTree;

use crate::judge::prove::context::Context;
use crate::judge::prove::linear::Linear;
use crate::judge::prove::summation::{Closed, close};
use crate::judge::prove::term::Term;
use crate::math::number::{Int, Rational, factorial, integer};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

type Values = BTreeMap<Symbol, i64>;

fn at(form: &Linear, values: &Values) -> i64 {
    form.terms().iter().map(|(s, a)| a.to_i64().unwrap() * values[s]).sum::<i64>()
        + form.offset().to_i64().unwrap()
}

/// The value of a term without bound variables; `None` where it has none.
fn value(term: &Term, values: &Values) -> Option<Fraction> {
    if term.guards.iter().any(|guard| at(guard, values) < 0) {
        return Some(Fraction::zero());
    }
    let put: Vec<(Symbol, Fraction)> =
        values.iter().map(|(s, x)| (s.clone(), Fraction::from(integer(*x)))).collect();
    let mut result = term.coefficient.substitute(&put).ok()?;
    if term.factorials.iter().any(|(form, m)| *m > 0 && at(form, values) < 0) {
        return None;
    }
    for (form, m) in &term.factorials {
        let Ok(n) = usize::try_from(at(form, values)) else { return Some(Fraction::zero()) };
        let f = Fraction::from(Rational::from_integer(factorial(n)));
        result = result.times(&f.pow(*m).ok()?);
    }
    for (base, exponent) in &term.powers {
        let e = i32::try_from(at(exponent, values)).ok()?;
        result = result.times(&Fraction::from(base.poly()).pow(e).ok()?);
    }
    Some(result)
}

/// The sum over all values of the bound variable.
fn added(term: &Term, variable: &Symbol, values: &Values) -> Option<Fraction> {
    let mut sum = Fraction::zero();
    for j in -15..=15 {
        let mut inner = values.clone();
        inner.insert(variable.clone(), j);
        sum += value(term, &inner)?;
    }
    Some(sum)
}

/// The value of the closed form; the context is made to fit the values where it is asked for.
fn closed(
    term: &Term,
    variable: &Symbol,
    values: &Values,
    context: &Context,
    depth: u32,
) -> Option<Fraction> {
    match close(term, variable, context, &mut BTreeSet::new()) {
        Closed::Open => None,
        Closed::Split(form) if depth > 0 => {
            let more = if at(&form, values) >= 0 { context.with(&form) } else { context.without(&form) };
            closed(term, variable, values, &more, depth - 1)
        }
        Closed::Split(_) => None,
        Closed::Sum(terms) => {
            let mut sum = Fraction::zero();
            for term in terms {
                sum += if term.bound.is_empty() {
                    value(&term, values).unwrap_or_else(|| panic!("{term:?} at {values:?}"))
                } else {
                    closed(&term, variable, values, context, depth.checked_sub(1)?)?
                };
            }
            Some(sum)
        }
    }
}

fn form(n: i64, k: i64, j: i64, c: i64) -> Linear {
    let part = |name: &str, a: i64| Linear::symbol(&Symbol::new(name)).scaled(&Int::from(a));
    part("n", n).plus(&part("k", k)).plus(&part("j", j)).shifted(c)
}

fn random_sum() -> impl Strategy<Value = Term> {
    let ups = prop::collection::vec((0i64..2, -2i64..3), 0..3);
    let downs = prop::collection::vec((0i64..2, -2i64..3), 0..3);
    let poly = prop::collection::vec(-3i64..4, 1..4);
    let ends = ((0i64..2, -1i64..3), (0i64..2, -2i64..2));
    let above = prop::option::of((0i64..2, -1i64..3, 0i64..2, -1i64..3));
    (ups, downs, poly, ends, 0i64..3, -1i64..2, prop::option::of(-1i64..3), above).prop_map(
        |(ups, downs, poly, ((ka, a), (kb, b)), x, sign, pole, above)| {
            let j = Fraction::from(form(0, 0, 1, 0).to_poly());
            let mut p = Fraction::zero();
            for c in poly {
                p = p.times(&j).plus(&Fraction::from(integer(c)));
            }
            if let Some(c) = pole {
                p = p / Fraction::from(form(0, 0, 1, c).to_poly());
            }
            let mut term = Term::new(p);
            for (k, c) in ups {
                term.multiply_factorial(form(0, -k, 1, c), -1);
            }
            for (k, c) in downs {
                term.multiply_factorial(form(1 - k, k, -1, c), -1);
            }
            if let Some((k, c, m, d)) = above {
                term.multiply_factorial(form(0, k, 1, c), 1);
                term.multiply_factorial(form(1, m, -1, d), 1);
            }
            let t = Fraction::from(MultiPoly::symbol(Symbol::new("t")));
            let bases = [
                (t.clone(), x),
                (Fraction::one() - t, -x),
                (-Fraction::one(), sign),
                (Fraction::from(integer(2)), sign),
            ];
            for (base, slope) in bases {
                term.multiply_power(&base, &form(1, 0, slope, 0)).unwrap();
            }
            term.guards.insert(form(0, -ka, 1, -a));
            term.guards.insert(form(1 - kb, kb, -1, b));
            term.bound.insert(Symbol::new("j"));
            term
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn sums(term in random_sum(), n in 0i64..5, k in 0i64..5) {
        let variable = Symbol::new("j");
        let values = Values::from([(Symbol::new("n"), n), (Symbol::new("k"), k)]);
        let mut context = Context::default();
        context.assume(&form(1, 0, 0, 0));
        context.assume(&form(0, 1, 0, 0));
        if let Some(sum) = added(&term, &variable, &values)
            && let Some(found) = closed(&term, &variable, &values, &context, 8)
        {
            prop_assert_eq!(sum, found);
        }
    }
}

/// Most kinds of sums are closed: the test above is not empty.
#[test]
fn many_are_closed() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut context = Context::default();
    context.assume(&form(1, 0, 0, 0));
    context.assume(&form(0, 1, 0, 0));
    let values = Values::from([(Symbol::new("n"), 3), (Symbol::new("k"), 1)]);
    let closed = (0..200)
        .filter(|_| {
            let term = random_sum().new_tree(&mut runner).unwrap().current();
            added(&term, &Symbol::new("j"), &values).is_some()
                && closed(&term, &Symbol::new("j"), &values, &context, 8).is_some()
        })
        .count();
    assert!(closed > 40, "{closed} of 200");
}
