//! The recurrence of Cox and de Boor and de Boor's scheme over integers, for knots that are numbers.
//!
//! With T = L t for the common denominator L of the knots all differences are integers. A piece is
//! kept as integer numerators over one denominator; only the finished coefficients are reduced.
//! That takes a few gcds for each piece instead of one for each coefficient and step.

use num_integer::Integer;
use num_traits::Zero;

use crate::budget;
use crate::math::number::{Int, Rational, over_one_denominator};

/// Numerators of the powers of T over a denominator; no numerators for the zero function.
#[derive(Clone, Default)]
struct Piece {
    numerators: Vec<Int>,
    denominator: Int,
}

impl Piece {
    /// (sign (T − knot) / width) times this.
    fn times_linear(&self, knot: &Int, width: &Int, falling: bool) -> Piece {
        if self.numerators.is_empty() {
            return Piece::default();
        }
        let mut numerators = Vec::with_capacity(self.numerators.len() + 1);
        numerators.push(-(&self.numerators[0] * knot));
        for pair in self.numerators.windows(2) {
            numerators.push(&pair[0] - &(&pair[1] * knot));
        }
        numerators.push(self.numerators[self.numerators.len() - 1].clone());
        if falling {
            numerators.iter_mut().for_each(|x| *x = -&*x);
        }
        Piece { numerators, denominator: &self.denominator * width }
    }

    fn plus(self, other: Piece) -> Piece {
        if self.numerators.is_empty() {
            return other;
        }
        if other.numerators.is_empty() {
            return self;
        }
        let common = self.denominator.gcd(&other.denominator);
        let left = other.denominator.div_exact(&common);
        let right = self.denominator.div_exact(&common);
        let sum = |(x, y): (&Int, &Int)| x * &left + y * &right;
        Piece {
            numerators: self.numerators.iter().zip(&other.numerators).map(sum).collect(),
            denominator: self.denominator * left,
        }
    }

    /// Power coefficients in t = T/L.
    fn coefficients(&self, scale: &Int) -> Vec<Rational> {
        let mut power = Int::ONE;
        let mut list = Vec::with_capacity(self.numerators.len());
        for numerator in &self.numerators {
            list.push(Rational::new(numerator * &power, self.denominator.clone()));
            power = &power * scale;
        }
        list
    }
}

/// f(u_1, …, u_n) by de Boor's scheme, from the 2n knots t_{j−n+1}, …, t_{j+n} around the interval
/// [t_j, t_{j+1}] and its n + 1 control points.
///
/// All points of a level have one denominator, the least common multiple of the widths there joined
/// to the one before. Cost: n² products for each coordinate, one gcd for each.
pub(super) fn de_boor(knots: &[Rational], points: &[Vec<Rational>], arguments: &[Rational]) -> Vec<Rational> {
    let n = arguments.len();
    let all: Vec<Rational> = knots.iter().chain(arguments).cloned().collect();
    let (integers, _) = over_one_denominator(&all);
    let (knots, arguments) = integers.split_at(knots.len());
    let size = points[0].len();
    let flat: Vec<Rational> = points.iter().flatten().cloned().collect();
    let (mut level, mut denominator) = over_one_denominator(&flat);
    for (r, u) in arguments.iter().enumerate() {
        budget::step();
        // Point i lies over [t_lo, t_hi] with lo = r + i among these knots.
        let ends = |i: usize| (&knots[r + i], &knots[n + i]);
        let widths: Vec<Int> = (0..n - r).map(|i| ends(i).1 - ends(i).0).collect();
        let common = widths.iter().fold(Int::ONE, |common, width| common.lcm(width));
        let mut next = Vec::with_capacity((n - r) * size);
        for (i, width) in widths.iter().enumerate() {
            let unit = common.div_exact(width);
            let (low, high) = (&unit * (ends(i).1 - u), &unit * (u - ends(i).0));
            for k in i * size..(i + 1) * size {
                next.push(&level[k] * &low + &level[k + size] * &high);
            }
        }
        level = next;
        denominator *= common;
    }
    level.into_iter().map(|x| Rational::new(x, denominator.clone())).collect()
}

/// All functions of degree n over these knots: power coefficients on each interval of the support.
pub(super) fn recurrence(knots: &[Rational], n: usize) -> Vec<Vec<Vec<Rational>>> {
    let (knots, scale) = over_one_denominator(knots);
    let unit = |pair: &[Int]| match pair[0] == pair[1] {
        true => Piece::default(),
        false => Piece { numerators: vec![Int::ONE], denominator: Int::ONE },
    };
    let mut level: Vec<Vec<Piece>> = knots.windows(2).map(|pair| vec![unit(pair)]).collect();
    for k in 1..=n {
        let widths: Vec<Int> = (0..knots.len() - k).map(|i| &knots[i + k] - &knots[i]).collect();
        level = (0..level.len() - 1)
            .map(|i| {
                budget::step();
                let mut local = vec![Piece::default(); k + 1];
                if !widths[i].is_zero() {
                    for (piece, lower) in local.iter_mut().zip(&level[i]) {
                        *piece = lower.times_linear(&knots[i], &widths[i], false);
                    }
                }
                if !widths[i + 1].is_zero() {
                    for (piece, lower) in local[1..].iter_mut().zip(&level[i + 1]) {
                        let fall = lower.times_linear(&knots[i + k + 1], &widths[i + 1], true);
                        *piece = std::mem::take(piece).plus(fall);
                    }
                }
                local
            })
            .collect();
    }
    level.iter().map(|local| local.iter().map(|piece| piece.coefficients(&scale)).collect()).collect()
}
