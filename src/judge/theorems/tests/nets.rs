//! What the letters of the table stand for where no single polynomial stands behind them: nets, meshes, Hermite data.

use super::meaning::{Behind, Coefficients, over, plus, polar, power_at, random, repeated, times, value};
use crate::math::number::{Rational, integer, rational};
use num_traits::{One, Zero};

/// A power of a number.
fn power(of: &Rational, exponent: i64) -> Rational {
    (0..exponent).fold(Rational::one(), |product, _| product * of)
}

/// The cubic with such values and slopes at 0 and 1.
fn hermite(ends: [&Rational; 2], slopes: [&Rational; 2]) -> Coefficients {
    let ([p, q], [m, l]) = (ends, slopes);
    let (two, three) = (integer(2), integer(3));
    vec![p.clone(), m.clone(), &three * (q - p) - &two * m - l, &two * (p - q) + m + l]
}

impl Behind {
    /// The number that a power of a linear function makes of a corner.
    fn corner(&self, at: i64) -> Rational {
        random(self.seed, at)
    }

    /// The piece of a Catmull-Rom spline from the i-th point on.
    fn piece(&self, i: i64) -> Coefficients {
        let point = |i: i64| random(self.seed, 40 + i);
        // The slope of the parabola through three neighbours.
        let slope = |i: i64| {
            let [a, b, c] = [-1, 0, 1].map(|k| point(i + k));
            let parabola = [b.clone(), (&c - &a) * rational(1, 2), (a + c) * rational(1, 2) - b];
            parabola[1].clone()
        };
        hermite([&point(i), &point(i + 1)], [&slope(i), &slope(i + 1)])
    }

    /// The tensor product of two polynomials at knots in both directions.
    fn product(&self, first: &[Rational], second: &[Rational]) -> Option<Rational> {
        let other: Coefficients = (0..=self.degree()).map(|k| random(self.seed + 13, k)).collect();
        Some(polar(&self.polynomial(0), first)? * polar(&other, second)?)
    }

    /// A control point of a uniform spline surface.
    fn net(&self, i: i64, j: i64) -> Option<Rational> {
        let from = |i: i64| (i..i + self.degree()).map(integer).collect::<Vec<_>>();
        self.product(&from(i), &from(j))
    }

    /// What the box spline of the directions (1, 0), (0, 1), (1, 1), each twice, makes of four points around an edge.
    fn loop_edge(&self) -> Rational {
        let mut mask = vec![vec![Rational::zero(); 9]; 9];
        mask[0][0] = rational(1, 16);
        for (dx, dy) in [(1, 0), (0, 1), (1, 1), (1, 0), (0, 1), (1, 1)] {
            let old = mask.clone();
            for (x, row) in old.iter().enumerate() {
                for (y, factor) in row.iter().enumerate() {
                    if x + dx < 9 && y + dy < 9 {
                        mask[x + dx][y + dy] += factor;
                    }
                }
            }
        }
        let old = |x: i64, y: i64| match (x, y) {
            (0, 0) => self.corner(1),
            (1, 0) => self.corner(2),
            (1, 1) => self.corner(3),
            (0, -1) => self.corner(4),
            _ => random(self.seed, 9 + x + 3 * y),
        };
        let mut sum = Rational::zero();
        for x in -2..=2i64 {
            for y in -2..=2i64 {
                if let (Ok(at), Ok(up)) = (usize::try_from(3 - 2 * x), usize::try_from(2 - 2 * y)) {
                    let factor = mask.get(at).and_then(|row| row.get(up)).cloned().unwrap_or_default();
                    sum += factor * old(x, y);
                }
            }
        }
        sum
    }

    pub(super) fn other_member(&self, base: &str, indices: &[i64]) -> Option<Rational> {
        let n = self.degree();
        match (base, indices) {
            ("b", [i, j, k, r]) if self.is("triangle") => {
                let moved: Rational =
                    ["u", "v", "w"].iter().zip(1..).map(|(l, at)| self.number(l) * self.corner(at)).sum();
                let corners =
                    power(&self.corner(1), *i) * power(&self.corner(2), *j) * power(&self.corner(3), *k);
                Some(corners * power(&moved, *r))
            }
            // The corner across an edge makes a parallelogram.
            ("c", [i, j, 1]) if self.is("parallelogram") => {
                let [a, b, c] = [1, 2, 3].map(|at| self.corner(at));
                Some(power(&a, *i) * power(&b, *j) * (a + b - c))
            }
            ("e", []) | ("q", [1]) if self.is("mesh") => {
                let at = [rational(1, 2), integer(1)];
                self.product(&at, &at)
            }
            ("a", []) | ("p", [1]) if self.is("mesh") => self.net(0, 0),
            ("b", []) | ("p", [2]) if self.is("mesh") => self.net(1, 0),
            ("c", []) | ("p", [3]) if self.is("mesh") => self.net(1, 1),
            ("d", []) | ("p", [4]) if self.is("mesh") => self.net(0, 1),
            // Around a vertex of valence 4 it is the uniform bicubic surface.
            ("v" | "p" | "e" | "f", []) if self.is("vertex") => {
                let mean = |points: &[(i64, i64)]| -> Option<Rational> {
                    let all: Option<Vec<Rational>> = points.iter().map(|(i, j)| self.net(*i, *j)).collect();
                    Some(all?.into_iter().sum::<Rational>() * rational(1, points.len() as i64))
                };
                let legs = [(0, 1), (2, 1), (1, 0), (1, 2)];
                match base {
                    "v" => {
                        let at = [rational(3, 2), integer(2), rational(5, 2)];
                        self.product(&at, &at)
                    }
                    "p" => self.net(1, 1),
                    "e" => Some((mean(&legs)? + self.net(1, 1)?) * rational(1, 2)),
                    _ => {
                        let corners = mean(&[(0, 0), (2, 0), (0, 2), (2, 2)])?;
                        Some((corners + self.net(1, 1)? + mean(&legs)? * integer(2)) * rational(1, 4))
                    }
                }
            }
            ("e", []) | ("q", [1]) if self.is("loop") => Some(self.loop_edge()),
            ("a", []) | ("p", [1]) if self.is("loop") => Some(self.corner(1)),
            ("b", []) | ("p", [2]) if self.is("loop") => Some(self.corner(2)),
            ("c", []) | ("p", [3]) if self.is("loop") => Some(self.corner(3)),
            ("d", []) | ("p", [4]) if self.is("loop") => Some(self.corner(4)),
            ("b", [i]) if self.is("catmull") => {
                let threes = self.integer("i").is_some();
                let (piece, place) = if threes { (i.div_euclid(3), i.rem_euclid(3)) } else { (1, *i) };
                polar(&self.piece(piece), &repeated(&[(&integer(0), 3 - place), (&integer(1), place)])?)
            }
            ("p", [i]) if self.is("catmull") => Some(value(&self.piece(*i), &Rational::zero())),
            ("m", [i]) if self.is("catmull") => self.piece(*i).get(1).cloned(),
            // a^n w_n = w_0
            ("a", []) if self.is("root") => Some(rational(2, 3)),
            ("w", [0]) if self.is("root") => Some(power(&rational(2, 3), n) * self.member("w", &[n])?),
            ("q", [i]) if self.is("rational") => {
                // The middle of the segment between two points with weights.
                let [w, v] = [*i, i + 1].map(|i| self.member("w", &[i]));
                let [p, q] = [*i, i + 1].map(|i| self.member("b", &[i]));
                let half = rational(1, 2);
                let (w, v) = (w?, v?);
                let weighted = [&w * p?, &v * q?];
                over(value(&weighted_segment(&weighted), &half), value(&weighted_segment(&[w, v]), &half))
            }
            ("p", [i]) if self.is("centred") => Some(value(&self.polynomial(0), &self.knot(*i))),
            _ => None,
        }
    }

    pub(super) fn other_function(&self, base: &str, indices: &[i64], at: &[Rational]) -> Option<Rational> {
        match (base, indices, at) {
            ("H", [i] | [i, 3], [x]) => {
                let [zero, one] = [0, 1].map(integer);
                let data = |k: i64| if k == *i { &one } else { &zero };
                Some(value(&hermite([data(0), data(3)], [data(1), data(2)]), x))
            }
            ("s", [], [x]) if self.is("catmull") => Some(value(&self.piece(1), x)),
            ("a", [], [z]) if self.is("symbol") => {
                // Every value twice, then means of neighbours.
                let mut mask = vec![Rational::one(), Rational::one()];
                for _ in 0..self.degree() {
                    let shifted = times(&mask, &power_at(&Rational::zero(), 1));
                    mask = plus(&mask, &shifted).iter().map(|factor| factor * rational(1, 2)).collect();
                }
                Some(value(&mask, z))
            }
            _ => None,
        }
    }
}

fn weighted_segment([first, last]: &[Rational; 2]) -> Coefficients {
    vec![first.clone(), last - first]
}
