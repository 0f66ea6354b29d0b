//! Random changes of true identities: what is proved must hold wherever it can be evaluated.

use super::{brute, identities, sides};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::judge::prove::prove;
use crate::language::write::latex;

/// A small generator of pseudo-random numbers (Knuth's MMIX constants).
pub struct Random(pub u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }
}

fn nodes(expr: &Expr) -> usize {
    let mut count = 1;
    expr.for_each_child(&mut |child| count += nodes(child));
    count
}

/// Changes the node with the given number, counted from the root.
fn change(expr: &mut Expr, number: &mut usize, random: &mut Random, letters: &[&str]) {
    if *number == 0 {
        change_here(expr, random, letters);
    }
    *number = number.wrapping_sub(1);
    expr.for_each_child_mut(&mut |child| {
        if *number != usize::MAX {
            change(child, number, random, letters);
        }
    });
}

fn change_here(expr: &mut Expr, random: &mut Random, letters: &[&str]) {
    let plus = |expr: &Expr, sign: Sign| {
        let one = Term { sign, expr: Expr::int(1) };
        Expr::sum(vec![Term { sign: Sign::Plus, expr: expr.clone() }, one])
    };
    let sign = [Sign::Plus, Sign::Minus][random.below(2)];
    let pick = random.below(4);
    match &mut expr.kind {
        Kind::Number(x) => {
            let step = [-2, -1, 1, 2][pick];
            *expr = Expr::number(&(x.clone() + crate::math::number::integer(step)));
        }
        Kind::Name(name) if letters.contains(&name.as_str()) => {
            *expr =
                if pick < 2 { plus(expr, sign) } else { Expr::name(letters[random.below(letters.len())]) };
        }
        Kind::Add(terms) => {
            let at = random.below(terms.len());
            match pick {
                0 if terms.len() > 2 => {
                    terms.remove(at);
                }
                1 => {
                    let other = random.below(terms.len());
                    let moved = terms[other].expr.clone();
                    terms[at].expr = moved;
                }
                _ => terms[at].sign = if terms[at].sign == Sign::Plus { Sign::Minus } else { Sign::Plus },
            }
        }
        Kind::Mul(factors) if factors.len() > 2 => {
            let at = random.below(factors.len());
            factors.remove(at);
        }
        Kind::Binomial(a, b, _) | Kind::Div(a, b, _) => std::mem::swap(a, b),
        Kind::Pow(base, exponent) if pick < 2 => match &mut base.kind {
            // B_i^n
            Kind::Subscript(_, indices) if indices.len() == 1 => std::mem::swap(&mut indices[0], exponent),
            _ => **exponent = plus(exponent, sign),
        },
        Kind::Subscript(_, indices) => {
            let at = random.below(indices.len());
            indices[at] = plus(&indices[at], sign);
        }
        _ => {}
    }
}

/// Proves changed identities and evaluates those for which a proof was found. Returns how many
/// were tried, proved, and how many values were compared.
fn run(seed: u64, per_identity: usize, bound: i64) -> (usize, usize, usize) {
    let mut random = Random(seed);
    let letters = ["i", "j", "k", "m", "n"];
    let (mut tried, mut proved, mut compared) = (0, 0, 0);
    for text in identities::all() {
        let (left, right) = sides(text);
        let mut free: Vec<&str> = letters.iter().copied().filter(|letter| text.contains(letter)).collect();
        free.truncate(3);
        for _ in 0..per_identity {
            let (mut a, mut b) = (left.clone(), right.clone());
            for _ in 0..=random.below(2) {
                let mut number = random.below(nodes(&a) + nodes(&b));
                let count = nodes(&a);
                if number < count {
                    change(&mut a, &mut number, &mut random, &free);
                } else {
                    number -= count;
                    change(&mut b, &mut number, &mut random, &free);
                }
            }
            tried += 1;
            let started = std::time::Instant::now();
            let found = prove(&a, &b, &|_| None);
            let time = started.elapsed();
            assert!(time.as_secs() < 10, "{time:?} for a change of {text}");
            let Some(proof) = found else { continue };
            proved += 1;
            let narrow = proof.reason.contains("; for ");
            let (witness, values) = brute::refutation(&a, &b, bound, narrow);
            compared += values;
            assert_eq!(
                witness,
                None,
                "a change of {text} was proved ({}):\n{} = {}",
                proof.reason,
                latex(&a),
                latex(&b)
            );
        }
    }
    (tried, proved, compared)
}

#[test]
fn changed_identities() {
    let (tried, proved, compared) = run(20, 2, 4);
    assert!(
        tried > 200 && proved > 10 && compared > 160,
        "{tried} tried, {proved} proved, {compared} compared"
    );
}

/// The same for a long time: `cargo test --lib judge::prove -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn many_changed_identities() {
    for seed in 2000..2008 {
        let (_, proved, compared) = run(seed, 60, 5);
        assert!(proved > 0 && compared > 0);
    }
}
