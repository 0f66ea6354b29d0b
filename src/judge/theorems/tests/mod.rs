//! Every equation of the table is calculated from what its letters stand for.
//!
//! A polynomial F of degree n with random coefficients stands behind each: its polar form, its values and its
//! derivatives are taken from `math`, and points are values of the polar form.

mod meaning;
mod nets;
mod spoilt;

use std::rc::Rc;

use super::entry::{Equation, Theorem, of_text};
use super::free::{Atom, Free};
use super::letters::Profile;
use crate::judge::instances::integers::as_values;
use crate::judge::model::{Choices, Model, holds};
use crate::judge::page::context::Context;
use crate::judge::page::letters::Letters;
use crate::judge::page::statement::Place;
use crate::judge::page::topic::Topic;
use crate::judge::values::evaluator;
use crate::math::number::{Rational, exact_root, integer};
use crate::math::poly::Fraction;
use num_traits::Zero;

use self::meaning::*;

/// The reading of an equation in which its letters are known.
fn reading(theorem: &Theorem, equation: &Equation, behind: &Behind) -> Rc<Free> {
    let integers = behind.integers.clone();
    let arity = |(letter, arity): &(String, crate::formula::Expr)| {
        let value =
            evaluator::machine().with_locals(as_values(&integers), |machine| machine.eval_int(arity)).ok()?;
        Some((letter.clone(), usize::try_from(value - i64::from(equation.order)).ok()?))
    };
    let arities: Vec<(String, usize)> = theorem.polar.iter().filter_map(arity).collect();
    let world = behind.clone();
    let place = Place::default();
    Rc::new(Free {
        model: Model::new(Rc::new(Context::new(Letters::default())), place, Choices::default(), None),
        functions: Rc::new(equation.profile.functions(&arities)),
        raised: Rc::new(equation.profile.raised.clone()),
        world: Some(Rc::new(move |atom: &Atom| world.atom(atom))),
    })
}

/// Both sides in one instance.
fn sides(
    theorem: &Theorem,
    equation: &Equation,
    rights: &[&crate::formula::Expr],
    behind: &Behind,
) -> Option<Vec<Fraction>> {
    let free = reading(theorem, equation, behind);
    std::iter::once(&equation.left)
        .chain(rights.iter().copied())
        .map(|side| free.value(side, &behind.integers))
        .collect()
}

/// The left side and others where the letters are known.
fn random_sides(
    theorem: &Theorem,
    equation: &Equation,
    rights: &[&crate::formula::Expr],
    integers: Vec<(String, i64)>,
) -> Option<Vec<Fraction>> {
    let variables = equation.profile.variables.iter().map(crate::language::write::text).collect();
    let (order, seed) = (equation.order, 7);
    let behind = Behind { meaning: theorem.meaning, integers, order, variables, seed };
    sides(theorem, equation, rights, &behind)
}

fn instances(theorem: &Theorem, profile: &Profile) -> Vec<Vec<(String, i64)>> {
    let mut all: Vec<Vec<(String, i64)>> = vec![Vec::new()];
    for name in &profile.integers {
        all = all
            .iter()
            .flat_map(|known| {
                (0..=4).map(|value| [known.clone(), vec![(name.clone(), value)]].concat()).collect::<Vec<_>>()
            })
            .collect();
    }
    all.retain(|values| {
        evaluator::machine()
            .with_locals(as_values(values), |machine| {
                Ok(theorem.conditions.iter().all(|condition| holds(machine, condition) != Some(false)))
            })
            .unwrap_or(false)
    });
    all.sort_by_key(|values| std::cmp::Reverse(values.iter().map(|(_, value)| *value).sum::<i64>()));
    all
}

#[test]
fn every_equation_follows_from_what_its_letters_stand_for() {
    let mut wrong = Vec::new();
    let mut unknown = Vec::new();
    for theorem in all().iter() {
        // These are looked at in another test.
        if theorem.meaning == "elsewhere" {
            continue;
        }
        for equation in &theorem.equations {
            let variables =
                equation.profile.variables.iter().map(crate::language::write::text).collect::<Vec<_>>();
            let mut tested = 0;
            let mut spoilt = vec![false; equation.misremembered.len()];
            let text = format!(
                "{}: {} = {}",
                theorem.name,
                crate::language::write::text(&equation.left),
                crate::language::write::text(&equation.right)
            );
            for (seed, integers) in
                instances(theorem, &equation.profile).into_iter().take(24).zip(1..).map(|(i, s)| (s, i))
            {
                for seed in [seed, seed + 40] {
                    let behind = Behind {
                        meaning: theorem.meaning,
                        integers: integers.clone(),
                        order: equation.order,
                        variables: variables.clone(),
                        seed,
                    };
                    let mut rights = vec![&equation.right];
                    rights.extend(&equation.misremembered);
                    let Some(values) = sides(theorem, equation, &rights, &behind) else { continue };
                    if values[0] != values[1] {
                        wrong.push(format!("{text} for {integers:?}: {} and {}", values[0], values[1]));
                        break;
                    }
                    tested += usize::from(!values[0].is_zero());
                    for (at, value) in values[2..].iter().enumerate() {
                        spoilt[at] |= *value != values[0];
                    }
                }
            }
            if tested < 2 {
                unknown.push(format!("{text}: tested {tested}"));
            }
            assert!(
                spoilt.iter().all(|wrong| *wrong) || tested < 2,
                "{text}: what is often taken for it is right"
            );
        }
    }
    assert!(
        wrong.is_empty() && unknown.is_empty(),
        "wrong:\n{}\nunknown:\n{}",
        wrong.join("\n"),
        unknown.join("\n")
    );
}

/// The table as it stands in its files.
fn all() -> Vec<Theorem> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/judge/theorems/tables");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    files.sort();
    files.iter().flat_map(|file| of_text(std::fs::read_to_string(file).unwrap().leak())).collect()
}

/// Curvature and torsion of a curve p/w by the rules for quotients; p(0) = 0, and lengths are rational.
#[test]
fn curvature_and_torsion_follow_from_derivatives() {
    let points: [[i64; 3]; 5] = [[0, 0, 0], [3, 4, 0], [3, 4, 2], [1, 7, 5], [2, 2, 9]];
    let minor =
        |rows: &[[Rational; 3]], a: usize, b: usize| &rows[0][a] * &rows[1][b] - &rows[0][b] * &rows[1][a];
    let cross = |rows: &[[Rational; 3]]| [minor(rows, 1, 2), minor(rows, 2, 0), minor(rows, 0, 1)];
    let dot = |a: &[Rational; 3], b: &[Rational; 3]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2];
    let legs: Vec<[Rational; 3]> =
        (0..3usize).map(|i| [0, 1, 2].map(|k| integer(points[i + 1][k] - points[i][k]))).collect();
    let own = cross(&legs[..2]);
    let own_square = dot(&own, &own);
    let mut seen = 0;
    for theorem in all().iter().filter(|theorem| theorem.meaning == "elsewhere") {
        for (n, equation) in (3..=4i64).flat_map(|n| theorem.equations.iter().map(move |one| (n, one))) {
            let behind = Behind {
                meaning: theorem.meaning,
                integers: vec![("n".to_owned(), n)],
                order: false,
                variables: Vec::new(),
                seed: 4,
            };
            let weight = |i: i64| match theorem.is_about(Topic::Rational) {
                true => behind.member("w", &[i]),
                false => Some(integer(1)),
            };
            let at_zero = |of: &Coefficients, order: i64| value(&derived(of, order), &Rational::zero());
            let w = curve_of(n, &weight);
            let coordinate = |k: usize| {
                let p = curve_of(n, &|i| Some(weight(i)? * integer(points[i as usize][k])));
                let [w0, w1, w2] = [0, 1, 2].map(|order| at_zero(&w, order));
                let one = at_zero(&p, 1) / &w0;
                let two = (at_zero(&p, 2) - integer(2) * &one * &w1) / &w0;
                let three = (at_zero(&p, 3) - integer(3) * (&two * &w1 + &one * &w2)) / &w0;
                [one, two, three]
            };
            let [x, y, z] = [0, 1, 2].map(coordinate);
            let [one, two, three] = [0, 1, 2].map(|k| [x[k].clone(), y[k].clone(), z[k].clone()]);
            let normal = cross(&[one.clone(), two]);
            let (speed, square) = (dot(&one, &one), dot(&normal, &normal));
            let text = crate::language::write::text(&equation.right);
            // Lengths and determinants are put in the place of their formulas.
            let factor = match theorem.name.contains("torsion") {
                true => dot(&normal, &three) / &square * &own_square / dot(&own, &legs[2]),
                // κ² of both, as the length of the normal is a root.
                false => {
                    let ratio = &square / (&speed * &speed * &speed) * integer(5i64.pow(6)) / &own_square;
                    let parts = if text.contains("area") { 2 } else { 1 };
                    exact_root(&ratio, 2).unwrap() * integer(parts)
                }
            };
            let crate::formula::Kind::Mul(factors) = &equation.right.kind else { panic!("{text}") };
            let numbers = crate::formula::Expr::product(factors[..factors.len() - 1].to_vec());
            let number = reading(theorem, equation, &behind).value(&numbers, &behind.integers).unwrap();
            assert_eq!(number.as_rational(), Some(factor), "{text}");
            seen += 1;
        }
    }
    assert!(seen > 12);
}
