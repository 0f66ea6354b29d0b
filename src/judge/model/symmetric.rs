//! Symmetric functions that words introduce: elementary ones, complete homogeneous ones, sums of powers.

use super::{Bound, Evaluated, Model};
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, Symmetric};
use crate::judge::written::names::Head;
use crate::language::eval::Machine;
use crate::language::value::Value;
use crate::math::number::integer;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

impl Model {
    /// e_k(u_1, …, u_n); e_k alone in the variables that words give.
    pub(super) fn symmetric(
        &self,
        machine: &mut Machine,
        object: &Object,
        kind: Symmetric,
        head: &Head,
        arguments: Option<&[Value]>,
    ) -> Option<Evaluated> {
        let [index] = head.lower.as_slice() else { return None };
        let k = machine.eval(index).ok()?.as_int()?;
        let values = match arguments {
            Some(values) => values.to_vec(),
            None => self.variables(machine, object)?,
        };
        let values: Vec<Fraction> =
            values.iter().map(|value| value.as_scalar().cloned()).collect::<Option<_>>()?;
        crate::budget::charge_terms(values.len() as u64 * k.unsigned_abs().max(1));
        self.note(format!("{} is {}", head.base, kind.words()));
        Some(Ok(Value::Scalar(value(kind, k, &values))))
    }

    /// The variables x_1, …, x_n; n is the degree that is tried if it is nothing else.
    fn variables(&self, machine: &mut Machine, object: &Object) -> Option<Vec<Value>> {
        let last = object.knots.last().and_then(Head::of)?;
        let mut bound = Bound::new();
        if let [Expr { kind: Kind::Name(name), .. }] = last.lower.as_slice()
            && machine.lookup(&Symbol::new(name)).is_none()
        {
            match self.degree {
                Some(degree) => bound.push((Symbol::new(name), Value::int(degree as i64))),
                None => self.record.borrow_mut().wants_degree = true,
            }
        }
        self.items(machine, &object.knots, &bound, None)
    }
}

/// The symmetric function of degree k at some values, by its generating function: Π (1 + x_i T), Π 1/(1 − x_i T).
///
/// Cost: O(k) operations for each value.
fn value(kind: Symmetric, k: i64, values: &[Fraction]) -> Fraction {
    let Ok(k) = usize::try_from(k) else { return Fraction::zero() };
    if kind == Symmetric::PowerSum {
        let power = |x: &Fraction| (0..k).fold(Fraction::from_rational(&integer(1)), |p, _| p.times(x));
        return values.iter().fold(Fraction::zero(), |sum, x| sum.plus(&power(x)));
    }
    let mut row = vec![Fraction::zero(); k + 1];
    row[0] = Fraction::from_rational(&integer(1));
    for x in values {
        // A new value is taken at most once, or as often as one likes.
        let step = |row: &mut Vec<Fraction>, j: usize| row[j] = row[j].plus(&row[j - 1].times(x));
        match kind {
            Symmetric::Elementary => (1..=k).rev().for_each(|j| step(&mut row, j)),
            _ => (1..=k).for_each(|j| step(&mut row, j)),
        }
    }
    row.swap_remove(k)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All products of k of the values, with or without repetition.
    fn products(values: &[Fraction], k: usize, again: bool) -> Fraction {
        match (k, values) {
            (0, _) => Fraction::from_rational(&integer(1)),
            (_, []) => Fraction::zero(),
            (_, [first, rest @ ..]) => {
                let next = if again { values } else { rest };
                first.times(&products(next, k - 1, again)).plus(&products(rest, k, again))
            }
        }
    }

    #[test]
    fn by_all_products() {
        let symbols = ["a", "b", "c", "d"]
            .map(|name| Fraction::from(crate::math::poly::MultiPoly::symbol(Symbol::new(name))));
        for n in 0..=4 {
            for k in 0..=5 {
                let values = &symbols[..n];
                let own = |kind| value(kind, k as i64, values);
                assert_eq!(own(Symmetric::Elementary), products(values, k, false), "e_{k} of {n}");
                assert_eq!(own(Symmetric::Complete), products(values, k, true), "h_{k} of {n}");
            }
        }
        assert_eq!(value(Symmetric::Elementary, -1, &symbols), Fraction::zero());
        assert_eq!(value(Symmetric::PowerSum, 0, &symbols), Fraction::from_rational(&integer(4)));
    }
}
