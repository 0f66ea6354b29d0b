//! What the letters of the table stand for: everything that it speaks of, from random data.

use super::super::free::Atom;
use crate::math::blossom::PolarForm;
use crate::math::number::{Rational, integer, rational};
use num_traits::{One, Zero};

/// A number for a letter or a place: other ones for other seeds.
pub(super) fn random(seed: i64, at: i64) -> Rational {
    let mixed = (seed * 7919 + at * 104_729 + seed * at * 31).rem_euclid(211);
    rational(mixed - 97, 1 + mixed % 7)
}

/// What stands behind a theorem in one instance.
#[derive(Clone)]
pub(super) struct Behind {
    pub(super) meaning: &'static str,
    pub(super) integers: Vec<(String, i64)>,
    pub(super) order: bool,
    /// The variables of the equation.
    pub(super) variables: Vec<String>,
    pub(super) seed: i64,
}

pub(super) type Coefficients = Vec<Rational>;

pub(super) fn value(of: &Coefficients, at: &Rational) -> Rational {
    of.iter().rev().fold(Rational::zero(), |sum, factor| sum * at + factor)
}

pub(super) fn derived(of: &Coefficients, order: i64) -> Coefficients {
    (0..order).fold(of.clone(), |of, _| {
        of.iter().enumerate().skip(1).map(|(k, factor)| factor * integer(k as i64)).collect()
    })
}

/// The polar form with as many arguments.
pub(super) fn polar(of: &Coefficients, arguments: &[Rational]) -> Option<Rational> {
    if arguments.is_empty() {
        return Some(of.first().cloned().unwrap_or_default());
    }
    let mut padded = of.clone();
    if padded.len() > arguments.len() + 1 {
        return None;
    }
    padded.resize(arguments.len() + 1, Rational::zero());
    PolarForm::new(padded).value(arguments).ok()
}

pub(super) fn over(a: Rational, b: Rational) -> Option<Rational> {
    (!b.is_zero()).then(|| a / b)
}

pub(super) fn times(a: &Coefficients, b: &Coefficients) -> Coefficients {
    let mut product = vec![Rational::zero(); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

pub(super) fn plus(a: &Coefficients, b: &Coefficients) -> Coefficients {
    (0..a.len().max(b.len()))
        .map(|k| a.get(k).cloned().unwrap_or_default() + b.get(k).cloned().unwrap_or_default())
        .collect()
}

/// (x - at)^power
pub(super) fn power_at(at: &Rational, power: i64) -> Coefficients {
    (0..power).fold(vec![Rational::one()], |product, _| times(&product, &vec![-at.clone(), Rational::one()]))
}

pub(super) fn bernstein(i: i64, n: i64) -> Coefficients {
    if i < 0 || i > n {
        return vec![Rational::zero()];
    }
    let factor = Rational::from_integer(crate::math::number::binomial(n as usize, i as usize));
    let one_minus =
        (0..n - i).fold(vec![factor], |product, _| times(&product, &vec![integer(1), integer(-1)]));
    times(&one_minus, &power_at(&Rational::zero(), i))
}

pub(super) fn repeated(parts: &[(&Rational, i64)]) -> Option<Vec<Rational>> {
    let mut all = Vec::new();
    for (value, count) in parts {
        all.extend(std::iter::repeat_n((*value).clone(), usize::try_from(*count).ok()?));
    }
    Some(all)
}

impl Behind {
    pub(super) fn integer(&self, name: &str) -> Option<i64> {
        self.integers.iter().find(|(own, _)| own == name).map(|(_, value)| *value)
    }

    pub(super) fn is(&self, word: &str) -> bool {
        self.meaning.split(' ').any(|own| own == word)
    }

    pub(super) fn number(&self, letter: &str) -> Rational {
        match letter {
            "u" if self.is("interval") => random(self.seed, 3),
            "v" if self.is("interval") => self.number("u") + integer(2) + rational(1, 3),
            "w" if self.is("interval") => self.number("v") + rational(7, 5),
            "h" => rational(3, 2),
            // Where only the functions of a window are not 0.
            "x" if self.is("window") => rational(23, 5),
            "x" if self.is("cardinal") => rational(6 + self.seed.rem_euclid(10), 5),
            "x" if self.is("knots") => rational(16 + self.seed, 5),
            _ => random(self.seed, letter.bytes().map(i64::from).sum()),
        }
    }

    pub(super) fn degree(&self) -> i64 {
        let said = self.meaning.split(' ').find_map(|word| word.strip_prefix("degree")?.parse().ok());
        let less = i64::from(self.order);
        said.unwrap_or_else(|| self.integer("n").unwrap_or(3) - less)
    }

    /// The polynomial behind the points, or another one.
    pub(super) fn polynomial(&self, number: i64) -> Coefficients {
        let degree = match number {
            1 => self.meaning.split(' ').find_map(|word| word.strip_prefix("other")?.parse().ok()),
            _ => None,
        };
        (0..=degree.unwrap_or_else(|| self.degree())).map(|k| random(self.seed + 13 * number, k)).collect()
    }

    pub(super) fn ends(&self) -> (Rational, Rational) {
        match self.variables.iter().any(|name| name == "v") {
            true => (self.number("u"), self.number("v")),
            false if self.variables.iter().any(|name| name == "h") => (integer(0), self.number("h")),
            false => (integer(0), integer(1)),
        }
    }

    pub(super) fn knot(&self, at: i64) -> Rational {
        if self.is("uniform") {
            return integer(at)
                * if self.variables.iter().any(|name| name == "h") { self.number("h") } else { integer(1) };
        }
        integer(at) + rational((at * at + self.seed).rem_euclid(5), 7)
    }

    pub(super) fn knots(&self, range: std::ops::Range<i64>) -> Vec<Rational> {
        range.map(|at| self.knot(at)).collect()
    }

    /// Bézier points of a polynomial of a degree.
    pub(super) fn points(&self, of: &Coefficients, degree: i64, i: i64) -> Option<Rational> {
        let (from, to) = self.ends();
        polar(of, &repeated(&[(&from, degree - i), (&to, i)])?)
    }

    pub(super) fn atom(&self, atom: &Atom) -> Option<Rational> {
        let indices: Vec<i64> = atom.indices.iter().filter_map(|index| index.parse().ok()).collect();
        if indices.len() != atom.indices.len() {
            return None;
        }
        match &atom.arguments {
            Some(arguments) => {
                let plain: Option<Vec<Rational>> =
                    arguments.iter().map(|(value, _)| value.as_rational()).collect();
                let vectors = arguments.iter().filter(|(_, vector)| *vector).count();
                self.function(&atom.base, &indices, atom.order, &plain?, vectors)
            }
            None => self.member(&atom.base, &indices),
        }
    }

    pub(super) fn function(
        &self,
        base: &str,
        indices: &[i64],
        order: i64,
        at: &[Rational],
        vectors: usize,
    ) -> Option<Rational> {
        let n = self.degree();
        let (f, g) = (self.polynomial(0), self.polynomial(1));
        let curve = || -> Coefficients {
            let mut sum = Vec::new();
            for i in 0..=n {
                let factor = vec![self.member("b", &[i]).unwrap_or_default()];
                sum = plus(&sum, &times(&bernstein(i, n), &factor));
            }
            sum
        };
        if let Some(value) = self.other_function(base, indices, at) {
            return Some(value);
        }
        match (base, indices, at) {
            ("B", [i, k], [x]) => Some(value(&derived(&bernstein(*i, *k), order), x)),
            ("B", [i, j, k, n], [_]) if i + j + k == *n => {
                Some(random(self.seed, 100 + i + 10 * j + 1000 * k))
            }
            ("p" | "s" | "x", [], [x]) if self.is("rational") => {
                let weights = curve_of(n, &|i| self.member("w", &[i]));
                let points = curve_of(n, &|i| Some(self.member("w", &[i])? * self.member("b", &[i])?));
                let (w, p) = (value(&weights, x), value(&points, x));
                match order {
                    0 => over(p, w),
                    1 => {
                        let (dw, dp) = (value(&derived(&weights, 1), x), value(&derived(&points, 1), x));
                        over(dp * &w - p * dw, &w * &w)
                    }
                    _ => None,
                }
            }
            ("p", [], [x]) if self.is("newton") || self.is("weights") => {
                let nodes: Vec<i64> = (0..=n).collect();
                let term = |i: &i64| {
                    let own = self.knot(*i);
                    let y = if self.is("newton") {
                        value(&times(&f, &f), &own)
                    } else {
                        random(self.seed, 50 + i)
                    };
                    nodes
                        .iter()
                        .filter(|j| *j != i)
                        .fold(y, |product, j| product * (x - self.knot(*j)) / (self.knot(*i) - self.knot(*j)))
                };
                Some(nodes.iter().map(term).sum())
            }
            ("f", [], [x]) if self.is("newton") => Some(value(&times(&f, &f), x)),
            ("p", [], [x]) if self.is("curve") => Some(value(&derived(&curve(), order), x)),
            ("F" | "p" | "s", [], [x]) => {
                let x = if self.is("uniform") && !self.is("at") { x + integer(n) } else { x.clone() };
                Some(value(&derived(&f, order), &x))
            }
            ("f", [], _) | ("f", [_], _) if vectors > 0 => {
                // Vectors stand last: F^(r) has the polar form of F with r of them.
                let mut of = f;
                for k in 0..vectors as i64 {
                    of = times(&derived(&of, 1), &vec![rational(1, n - k)]);
                }
                polar(&of, &at[..at.len() - vectors])
            }
            ("g", [], _) if self.is("raised") => polar(&f, at),
            ("g", [], _) if self.is("contact") => {
                let extra = power_at(&self.number("a"), self.integer("r").unwrap_or(n - 1) + 1);
                let extra = if self.integer("r") == Some(n) { Vec::new() } else { extra };
                polar(&plus(&f, &extra), at)
            }
            ("h", [], _) if self.is("product") => polar(&times(&f, &g), at),
            ("h", [], _) if self.is("square") => polar(&times(&f, &f), at),
            ("g", [], _) => polar(&g, at),
            ("f", _, _) => polar(&f, at),
            ("N", [i, k], [x]) => {
                let k = *k - i64::from(self.order);
                Some(self.spline(&|j| self.knot(j), *i, k, x, order))
            }
            ("N", [k], [x]) => Some(self.spline(&integer, 0, *k - i64::from(self.order), x, order)),
            ("N", [], [x]) => Some(self.spline(&integer, 0, n, x, order)),
            ("L", [i], [x]) => {
                let others = (0..=n).filter(|j| j != i);
                Some(others.fold(Rational::one(), |product, j| {
                    product * (x - self.knot(j)) / (self.knot(*i) - self.knot(j))
                }))
            }
            ("p", [i, j], [x]) => {
                let last = if self.is("by-length") { i + j } else { *j };
                Some(self.interpolant(&(*i..=last).collect::<Vec<_>>(), x))
            }
            ("[]f", [], nodes) => Some(self.divided(nodes, &|x| value(&times(&f, &f), x))),
            ("[]g", [], nodes) => Some(self.divided(nodes, &|x| value(&g, x))),
            ("[]h", [], nodes) => Some(self.divided(nodes, &|x| value(&times(&times(&f, &f), &g), x))),
            _ => None,
        }
    }

    /// N_{i,k}(x) by divided differences of truncated powers.
    pub(super) fn spline(
        &self,
        knot: &dyn Fn(i64) -> Rational,
        i: i64,
        k: i64,
        x: &Rational,
        order: i64,
    ) -> Rational {
        if order > k {
            return Rational::zero();
        }
        let nodes: Vec<Rational> = (i..=i + k + 1).map(knot).collect();
        let truncated = |y: &Rational| {
            if y <= x {
                return Rational::zero();
            }
            let factor = (0..order).fold(Rational::one(), |product, j| -product * integer(k - j));
            (0..k - order).fold(factor, |product, _| product * (y - x))
        };
        (&nodes[nodes.len() - 1] - &nodes[0]) * self.divided(&nodes, &truncated)
    }

    pub(super) fn divided(&self, nodes: &[Rational], f: &dyn Fn(&Rational) -> Rational) -> Rational {
        match nodes {
            [] => Rational::zero(),
            [one] => f(one),
            [first, inner @ .., last] => {
                let (mut left, mut right) = (inner.to_vec(), inner.to_vec());
                left.insert(0, first.clone());
                right.push(last.clone());
                (self.divided(&right, f) - self.divided(&left, f)) / (last - first)
            }
        }
    }

    pub(super) fn interpolant(&self, nodes: &[i64], x: &Rational) -> Rational {
        let term = |i: &i64| {
            nodes.iter().filter(|j| *j != i).fold(random(self.seed, 50 + i), |product, j| {
                product * (x - self.knot(*j)) / (self.knot(*i) - self.knot(*j))
            })
        };
        nodes.iter().map(term).sum()
    }

    pub(super) fn member(&self, base: &str, indices: &[i64]) -> Option<Rational> {
        let n = self.degree();
        let f = self.polynomial(0);
        let (from, to) = self.ends();
        let r = self.integer("r").unwrap_or(1);
        let x = self.number("x");
        let t = self.number("t");
        let homogeneous = |weighted: bool| {
            curve_of(n, &|i| {
                Some(self.member("w", &[i])? * if weighted { self.member("b", &[i])? } else { integer(1) })
            })
        };
        if self.is("vertex") && self.integer("n") != Some(4) {
            return None;
        }
        if let Some(value) = self.other_member(base, indices) {
            return Some(value);
        }
        match (base, indices) {
            (letter, []) if self.is("middle") && letter == "s" => {
                Some(value(&homogeneous(true), &rational(1, 2)) / value(&homogeneous(false), &rational(1, 2)))
            }
            ("m", []) if self.is("middle") => {
                Some((self.member("b", &[0])? + self.member("b", &[2])?) / integer(2))
            }
            ("w", []) if self.is("middle") => self.member("w", &[1]),
            ("break", [k]) if *k < 14 => {
                Some(if self.is("cardinal") { integer(*k - 1) } else { self.knot(*k) })
            }
            ("break", _) => None,
            // The parameter is changed so that the weights at both ends agree.
            ("v", []) if self.is("standard") => self.member("v", &[1]),
            ("v", [1]) if self.is("standard") => Some(self.member("w", &[1])? * rational(2, 3) / integer(4)),
            ("w", [0]) if self.is("standard") => Some(integer(4)),
            ("w", [2]) if self.is("standard") => Some(integer(9)),
            ("tau", [i]) if self.is("conic") => {
                let w = [0, 1, 2].map(|j| match self.variables.is_empty() {
                    true => self.member("w", &[j]).unwrap_or_default(),
                    false if j == 1 => self.number("w"),
                    false => integer(1),
                });
                let weighted = |j: i64| value(&bernstein(j, 2), &t) * &w[j as usize];
                over(weighted(*i), weighted(0) + weighted(1) + weighted(2))
            }
            (letter, []) => Some(self.number(letter)),
            ("b" | "c", [i, j, k]) => {
                // The coefficients of (α u + β v + γ w)^n, and of that times u + v + w.
                let multinomial = |i: i64, j: i64, k: i64| {
                    let factorial = |m: i64| (1..=m).fold(Rational::one(), |product, m| product * integer(m));
                    factorial(i + j + k) / (factorial(i) * factorial(j) * factorial(k))
                };
                let power = |i: i64, j: i64, k: i64| {
                    let of = |at: i64, power: i64| {
                        (0..power).fold(Rational::one(), |product, _| product * random(self.seed, at))
                    };
                    if i.min(j).min(k) < 0 {
                        Rational::zero()
                    } else {
                        multinomial(i, j, k) * of(1, i) * of(2, j) * of(3, k)
                    }
                };
                let all = match base {
                    "b" => power(*i, *j, *k),
                    _ => power(i - 1, *j, *k) + power(*i, j - 1, *k) + power(*i, *j, k - 1),
                };
                (*i.min(j).min(k) >= 0).then(|| all / multinomial(*i, *j, *k))
            }
            ("p" | "q", _) if self.is("scheme") || self.is("values") => {
                let level = if base == "q" { 1 } else { indices.get(1).copied().unwrap_or(0) };
                let parts = 1i64 << level;
                if self.is("values") {
                    return Some(value(&f, &rational(indices[0], parts)));
                }
                let shift = if self.is("later") { 2 * parts - 2 } else { parts - 1 };
                let knots: Vec<Rational> = (0..n).map(|k| rational(indices[0] + shift + k, parts)).collect();
                polar(&f, &knots)
            }
            ("b", [i]) if self.is("rational") || self.is("curve") => {
                Some(if *i < 0 || *i > n { Rational::zero() } else { random(self.seed, 20 + i) })
            }
            ("w", [0 | 2]) if self.is("middle") => Some(Rational::one()),
            ("w", [i]) if self.is("weights") => {
                // The barycentric ones.
                let others = (0..=n).filter(|j| j != i);
                Some(others.fold(Rational::one(), |product, j| product / (self.knot(*i) - self.knot(j))))
            }
            ("w", [i]) => Some(if *i < 0 || *i > n {
                Rational::zero()
            } else {
                integer(1) + rational(i * i + self.seed, 3)
            }),
            ("v", [i]) if self.is("elevated") => {
                polar(&homogeneous(false), &repeated(&[(&from, n + 1 - i), (&to, *i)])?)
            }
            ("c", [i]) if self.is("rational") => {
                let at = repeated(&[(&from, n + 1 - i), (&to, *i)])?;
                over(polar(&homogeneous(true), &at)?, polar(&homogeneous(false), &at)?)
            }
            ("w", [i, r]) => {
                polar(&homogeneous(false), &repeated(&[(&from, n - i - r), (&to, *i), (&x, *r)])?)
            }
            ("p", [i, r]) if self.is("rational") => {
                let at = repeated(&[(&from, n - i - r), (&to, *i), (&x, *r)])?;
                over(polar(&homogeneous(true), &at)?, polar(&homogeneous(false), &at)?)
            }
            ("c", [i, _]) | ("c", [i]) if self.is("elevated") => self.points(&f, n + r, *i),
            ("c", [i]) if self.is("right") => polar(&f, &repeated(&[(&t, n - i), (&to, *i)])?),
            ("a", [i]) if self.is("left") => polar(&f, &repeated(&[(&from, n - i), (&t, *i)])?),
            ("b", [i, r]) => polar(&f, &repeated(&[(&from, n - i - r), (&to, *i), (&t, *r)])?),
            ("a", [i]) if self.is("powers") => {
                Some(f.get(usize::try_from(*i).ok()?).cloned().unwrap_or_default())
            }
            ("b", [i]) if self.is("segment") => {
                let at = self.integer("i").unwrap_or(3);
                let at = if self.is("by-threes") { (i + 1).div_euclid(3).max(0) } else { at };
                let place = if self.is("by-threes") { i - 3 * i.div_euclid(3) } else { *i };
                let from = if self.is("by-threes") { i.div_euclid(3) } else { at };
                let from = if self.is("uniform") && !self.is("by-threes") { n } else { from };
                let (from, to) = (self.knot(from), self.knot(from + 1));
                polar(&f, &repeated(&[(&from, n - place), (&to, place)])?)
            }
            ("c", [i]) if self.is("join") => {
                // The same up to the second derivative.
                let (from, to) = (to, self.next_end());
                let other = plus(
                    &f,
                    &power_at(&from, 3)
                        .iter()
                        .map(|q| if n > 2 { q.clone() } else { Rational::zero() })
                        .collect(),
                );
                polar(&other, &repeated(&[(&from, n - i), (&to, *i)])?)
            }
            ("b", [i]) if self.is("join") && *i > n => self.member("c", &[i - n]),
            ("h", [0]) if self.is("join") => Some(to - from),
            ("h", [1]) if self.is("join") => Some(self.next_end() - to),
            ("p", [i]) if self.is("hermite") => Some(value(&f, if *i == 0 { &from } else { &to })),
            ("m", [i]) if self.is("hermite") => {
                Some(value(&derived(&f, 1), if *i == 0 { &from } else { &to }))
            }
            ("d", [i]) if self.is("uniform") && self.is("centred") => polar(&f, &self.knots(i - 1..i + 2)),
            ("d", [i]) => polar(&f, &self.knots(i + 1..i + n + 1)),
            ("d", [i, r]) => {
                let mut at = repeated(&[(&x, *r)])?;
                at.extend(self.knots(i + 1..i + n - r + 1));
                polar(&f, &at)
            }
            ("c", [i]) if self.is("inserted") => {
                let mut at = vec![x];
                at.extend(self.knots(i + 1..i + n));
                polar(&f, &at)
            }
            ("c", [i]) if self.is("derived") => polar(&derived(&f, 1), &self.knots(i + 1..i + n)),
            ("c", [i]) if self.is("derived-next") => polar(&derived(&f, 1), &self.knots(i + 2..i + n + 1)),
            ("a", [i, r]) => {
                let (r, i) = if self.is("from-r") { (*r, i + r) } else { (*r, *i) };
                let (old, next) = (self.member("d", &[i - 1, r - 1])?, self.member("d", &[i, r - 1])?);
                over(self.member("d", &[i, r])? - &old, next - &old)
            }
            ("a", [i]) if self.is("inserted") => {
                let (old, next) = (self.member("d", &[i - 1])?, self.member("d", &[*i])?);
                let mut at = vec![x];
                at.extend(self.knots(i + 1..i + n));
                over(polar(&f, &at)? - &old, next - &old)
            }
            ("g", [i]) if self.is("greville") => {
                polar(&vec![integer(0), integer(1)], &self.knots(i + 1..i + n + 1))
            }
            ("h", [i]) => Some(
                self.knot(i + 1 - i64::from(self.is("before"))) - self.knot(i - i64::from(self.is("before"))),
            ),
            ("M" | "m" | "y", [i]) if self.is("spline") => {
                let at = self.integer("i").unwrap_or(1);
                let order = match base {
                    "M" => 2,
                    "m" => 1,
                    _ => 0,
                };
                let mut piece = f.clone();
                if *i > at {
                    piece = plus(&piece, &times(&power_at(&self.knot(at), 3), &vec![rational(5, 3)]));
                }
                Some(value(&derived(&piece, order), &self.knot(*i)))
            }
            ("b", [i]) => self.points(&f, n, *i),
            ("t" | "x", [i]) => Some(self.knot(*i)),
            ("u", [i]) => Some(random(self.seed, 70 + i)),
            ("y", [i]) => Some(random(self.seed, 50 + i)),
            ("c", [i]) if self.is("newton") => {
                let nodes = self.knots(0..i + 1);
                Some(self.divided(&nodes, &|x| value(&times(&f, &f), x)))
            }
            _ => None,
        }
    }

    pub(super) fn next_end(&self) -> Rational {
        let (from, to) = self.ends();
        match self.variables.iter().any(|name| name == "w") {
            true => self.number("w"),
            false if self.is("one-length") => to.clone() + to - from,
            false => to + rational(9, 4),
        }
    }
}

pub(super) fn curve_of(n: i64, points: &dyn Fn(i64) -> Option<Rational>) -> Coefficients {
    let mut sum = Vec::new();
    for i in 0..=n {
        sum = plus(&sum, &times(&bernstein(i, n), &vec![points(i).unwrap_or_default()]));
    }
    sum
}
