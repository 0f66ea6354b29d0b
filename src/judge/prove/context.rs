//! What is known of the integers: linear inequalities, and what follows from them.
//!
//! A [`Context`] is a conjunction of inequalities L ≥ 0 between integers. It *entails* G ≥ 0
//! if the inequalities together with G ≤ −1 have no solution; that is decided over the
//! rationals by Fourier–Motzkin elimination with rounding of constants (Schrijver, *Theory of
//! Linear and Integer Programming*, 12.2). "Entailed" is always true; "not entailed" may only
//! mean that the search was given up or that rationals are not enough.

use std::collections::BTreeMap;

use num_traits::{One, Signed, Zero};

use super::linear::Linear;
use crate::budget;
use crate::math::number::Int;
use crate::math::poly::Symbol;

/// More inequalities than this during an elimination end the search.
const MAX_INEQUALITIES: usize = 250;
/// Integers with at most so many values are looked at one by one.
const MAX_VALUES: i64 = 4;

/// A conjunction of inequalities L ≥ 0 between integers.
#[derive(Clone, Debug, Default)]
pub struct Context {
    facts: Vec<Linear>,
}

impl Context {
    /// Adds L ≥ 0.
    pub fn assume(&mut self, form: &Linear) {
        let form = form.tightened();
        let trivial = form.as_constant().is_some_and(|c| !c.is_negative());
        if !trivial && !self.facts.contains(&form) {
            self.facts.push(form);
        }
    }

    /// This context with L ≥ 0 added.
    pub fn with(&self, form: &Linear) -> Self {
        let mut more = self.clone();
        more.assume(form);
        more
    }

    /// This context with L ≤ −1 added.
    pub fn without(&self, form: &Linear) -> Self {
        self.with(&negation(form))
    }

    /// The facts in which the symbol does not occur.
    pub fn forgetting(&self, symbol: &Symbol) -> Self {
        Context { facts: self.facts.iter().filter(|fact| !fact.contains(symbol)).cloned().collect() }
    }

    /// Whether L ≥ 0 follows.
    pub fn entails(&self, form: &Linear) -> bool {
        match form.as_constant() {
            Some(c) => !c.is_negative(),
            None => self.facts.contains(form) || self.without(form).is_impossible(),
        }
    }

    /// Whether L ≤ −1 follows.
    pub fn refutes(&self, form: &Linear) -> bool {
        self.entails(&negation(form))
    }

    /// Whether no integers satisfy the inequalities; `false` may mean that this is not known.
    pub fn is_impossible(&self) -> bool {
        let mut list = strongest(&self.facts);
        loop {
            budget::step();
            if list.iter().any(|form| form.as_constant().is_some_and(Signed::is_negative)) {
                return true;
            }
            let mut counts: BTreeMap<&Symbol, (usize, usize)> = BTreeMap::new();
            for (symbol, a) in list.iter().flat_map(|form| form.terms()) {
                let count = counts.entry(symbol).or_default();
                if a.is_positive() { count.0 += 1 } else { count.1 += 1 }
            }
            let Some((symbol, _)) = counts.into_iter().min_by_key(|(_, (up, down))| up * down) else {
                return false;
            };
            let symbol = symbol.clone();
            let (with, mut rest): (Vec<Linear>, Vec<Linear>) =
                list.into_iter().partition(|form| form.contains(&symbol));
            let (below, above): (Vec<&Linear>, Vec<&Linear>) =
                with.iter().partition(|form| form.coefficient(&symbol).is_positive());
            if below.len() * above.len() + rest.len() > MAX_INEQUALITIES {
                return false;
            }
            for low in &below {
                for high in &above {
                    budget::step();
                    let (a, b) = (low.coefficient(&symbol), -high.coefficient(&symbol));
                    rest.push(low.scaled(&b).plus_multiple(high, &a));
                }
            }
            list = strongest(&rest);
        }
    }

    /// A symbol with the value that the context forces on it, if an equation for one follows.
    pub fn forced(&self) -> Option<(Symbol, Linear)> {
        for fact in &self.facts {
            let unit = fact.terms().iter().find(|(_, a)| a.as_small().is_some_and(|a| a.abs() == 1));
            let Some((symbol, a)) = unit else { continue };
            if self.refutes(&fact.shifted(-1)) {
                // a s + rest = 0 with a = ±1
                let rest = fact.substitute(symbol, &Linear::default());
                return Some((symbol.clone(), rest.scaled(&-a)));
            }
        }
        None
    }

    /// s − c − 1 for a symbol s with c ≤ s ≤ c + 3: a split on it brings one value apart.
    pub fn few_values(&self) -> Option<Linear> {
        self.facts.iter().find_map(|fact| {
            let (symbol, slope) = fact.terms().first_key_value().filter(|_| fact.terms().len() == 1)?;
            let few = slope.is_one() && self.refutes(&fact.shifted(-MAX_VALUES));
            let single = Linear::symbol(symbol).plus(&Linear::constant(fact.offset().clone()));
            (few && !self.refutes(&single.shifted(-1))).then(|| single.shifted(-1))
        })
    }

    /// The context with a form put in for a symbol.
    pub fn substitute(&self, symbol: &Symbol, value: &Linear) -> Self {
        let mut result = Context::default();
        self.facts.iter().for_each(|fact| result.assume(&fact.substitute(symbol, value)));
        result
    }
}

/// The form that is ≥ 0 exactly where L ≤ −1.
pub fn negation(form: &Linear) -> Linear {
    form.negated().shifted(-1)
}

/// The inequalities without those that another one of the same direction implies.
fn strongest(forms: &[Linear]) -> Vec<Linear> {
    let mut best: BTreeMap<Linear, Int> = BTreeMap::new();
    for form in forms {
        let form = form.tightened();
        if form.terms().is_empty() && !form.offset().is_negative() {
            continue;
        }
        let offset = form.offset().clone();
        let entry = best.entry(form.without_offset()).or_insert_with(|| offset.clone());
        if offset < *entry {
            *entry = offset;
        }
    }
    let join = |(direction, offset): (Linear, Int)| {
        if offset.is_zero() { direction } else { direction.plus(&Linear::constant(offset)) }
    };
    best.into_iter().map(join).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn form(n: i64, i: i64, j: i64, c: i64) -> Linear {
        let part = |name: &str, a: i64| Linear::symbol(&Symbol::new(name)).scaled(&Int::from(a));
        part("n", n).plus(&part("i", i)).plus(&part("j", j)).shifted(c)
    }

    fn given(facts: &[Linear]) -> Context {
        let mut context = Context::default();
        facts.iter().for_each(|fact| context.assume(fact));
        context
    }

    #[test]
    fn what_follows() {
        // 0 ≤ i ≤ j ≤ n − 1
        let context = given(&[form(0, 1, 0, 0), form(0, -1, 1, 0), form(1, 0, -1, -1)]);
        assert!(context.entails(&form(1, -1, 0, -1)));
        assert!(context.entails(&form(1, 0, 0, -1)));
        assert!(!context.entails(&form(1, -1, 0, -2)));
        assert!(context.refutes(&form(-1, 0, 0, 0)));
        assert!(!context.is_impossible());
        assert!(context.with(&form(-1, 1, 0, 0)).is_impossible());
    }

    #[test]
    fn integers_are_used() {
        // 1 ≤ 2i ≤ 1 has no integer solution
        assert!(given(&[form(0, 2, 0, -1), form(0, -2, 0, 1)]).is_impossible());
    }

    #[test]
    fn forced_values() {
        let context = given(&[form(1, 0, 0, 0), form(0, 1, 0, 0), form(0, -1, 0, 0)]);
        assert_eq!(context.forced(), Some((Symbol::new("i"), Linear::default())));
        assert_eq!(given(&[form(1, -1, 0, 0)]).forced(), None);
    }

    #[test]
    fn few_values_are_told_apart() {
        // 1 ≤ i ≤ 2
        let context = given(&[form(1, 0, 0, 0), form(0, 1, 0, -1), form(0, -1, 0, 2)]);
        assert_eq!(context.few_values(), Some(form(0, 1, 0, -2)));
        assert_eq!(given(&[form(1, 0, 0, 0)]).few_values(), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn entailment_holds_at_every_point(
            facts in prop::collection::vec((-2i64..3, -2i64..3, -2i64..3, -3i64..4), 0..5),
            goal in (-2i64..3, -2i64..3, -2i64..3, -3i64..4),
        ) {
            let at = |(a, b, c, d): (i64, i64, i64, i64), n: i64, i: i64, j: i64| a * n + b * i + c * j + d >= 0;
            let forms: Vec<Linear> = facts.iter().map(|&(a, b, c, d)| form(a, b, c, d)).collect();
            if given(&forms).entails(&form(goal.0, goal.1, goal.2, goal.3)) {
                for (n, i, j) in (-4..5).flat_map(|n| (-4..5).flat_map(move |i| (-4..5).map(move |j| (n, i, j)))) {
                    prop_assert!(!facts.iter().all(|&f| at(f, n, i, j)) || at(goal, n, i, j));
                }
            }
        }
    }
}
