//! An interpolating cubic spline by its moments: the system, its solution, the pieces.

use super::lines::{chain, factor, line, multiple, product, sequence, subscript, term};
use super::schemes::{difference, point_expr};
use super::words::{AtEnds, Reason, Title};
use crate::formula::{Delimiter, Expr, Kind, Sign, Term};
use crate::language::value::{Derivation, Form, Line, polynomial_expr};
use crate::math::interpolate::{CubicSpline, End, Ends, SplineSystem, Unknowns, value_of};
use crate::math::number::integer;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

/// The moments M_i = S''(x_i) from μ_i M_{i−1} + 2 M_i + λ_i M_{i+1} = d_i and the two ends, and
/// the pieces of S with them.
///
/// Cost: that of writing out n pieces and (n + 1)² entries.
pub fn moments(spline: &CubicSpline<Fraction, Vec<Fraction>>, form: Form) -> Derivation {
    let moments = Moments { spline, form };
    Derivation { title: Title::Moments.words(), lines: moments.lines(), language: None }
}

struct Moments<'a> {
    spline: &'a CubicSpline<Fraction, Vec<Fraction>>,
    form: Form,
}

fn plus(expr: Expr) -> Term {
    Term { sign: Sign::Plus, expr }
}

fn sum(a: Expr, b: Expr) -> Expr {
    Expr::sum(vec![plus(a), plus(b)])
}

fn minus(a: Expr, b: Expr) -> Expr {
    Expr::sum(vec![plus(a), Term { sign: Sign::Minus, expr: b }])
}

fn name(letter: &str, i: usize) -> Expr {
    subscript(letter, &[i])
}

impl Moments<'_> {
    fn expr(&self, point: &[Fraction]) -> Expr {
        point_expr(self.form, point)
    }

    fn lines(&self) -> Vec<Line> {
        let (nodes, values, n) = (self.spline.nodes(), self.spline.values(), self.spline.pieces());
        crate::budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
        let mut lines = Vec::new();
        let given = nodes.iter().enumerate().map(|(i, x)| chain([name("x", i), polynomial_expr(x)]));
        lines.push(line(sequence(given.collect()), Reason::Nodes));
        let data = values.iter().enumerate().map(|(i, y)| chain([name("y", i), self.expr(y)]));
        lines.push(line(sequence(data.collect()), Reason::Data));
        for i in 0..n {
            let sides = [
                name("h", i),
                minus(name("x", i + 1), name("x", i)),
                difference(&nodes[i + 1], &nodes[i]),
                polynomial_expr(&nodes[i + 1].minus(&nodes[i])),
            ];
            lines.push(line(chain(sides), Reason::StepLength));
        }
        // A periodic spline has an equation at x_n as well, whose right neighbour is x_1.
        let cyclic = matches!(self.spline.ends(), Ends::Periodic);
        let system = self.spline.system();
        if matches!(system.unknowns, Unknowns::Moments) {
            for i in 1..n + usize::from(cyclic) {
                lines.extend(self.equation(system, i, i % n, i - system.first));
            }
        }
        lines.extend(self.end_slopes(system));
        lines.push(self.system(system));
        let solution = self.spline.moments().iter().enumerate();
        let solution = solution.map(|(i, moment)| chain([name("M", i), self.expr(moment)]));
        lines.push(line(sequence(solution.collect()), Reason::SystemSolved));
        for i in 0..n {
            crate::budget::step();
            lines.extend(self.piece(i));
        }
        lines
    }

    /// μ_i, λ_i and d_i between the intervals i − 1 and `next`, row `row` of the system.
    fn equation(
        &self,
        system: &SplineSystem<Fraction, Vec<Fraction>>,
        i: usize,
        next: usize,
        row: usize,
    ) -> [Line; 3] {
        let (before, after) = (name("h", i - 1), name("h", next));
        let both = || sum(before.clone(), after.clone());
        let slope = |k: usize| minus(name("y", k + 1), name("y", k)).over(name("h", k));
        let six = Expr::product(vec![Expr::int(6).over(both()), minus(slope(next), slope(i - 1)).grouped()]);
        let matrix = &system.matrix;
        let [mu, lambda] = [&matrix.lower()[row], &matrix.upper()[row]].map(polynomial_expr);
        [
            line(
                chain([name("mu", i), before.clone().over(both()), mu]),
                Reason::CoefficientOf { moment: i - 1 },
            ),
            line(
                chain([name("lambda", i), minus(Expr::int(1), name("mu", i)), lambda]),
                Reason::CoefficientOf { moment: next + 1 },
            ),
            line(
                chain([name("d", i), six, self.expr(&system.right[row])]),
                Reason::RightSide { i, next: next + 1 },
            ),
        ]
    }

    /// The right sides of the equations for ends where S' is given: 2 M_0 + M_1 = d_0 and
    /// M_{n−1} + 2 M_n = d_n.
    fn end_slopes(&self, system: &SplineSystem<Fraction, Vec<Fraction>>) -> Vec<Line> {
        let n = self.spline.pieces();
        let Ends::Each { first, last } = self.spline.ends() else { return Vec::new() };
        let difference = |k: usize| minus(name("y", k + 1), name("y", k)).over(name("h", k));
        let right = |i: usize, k: usize, rest: Expr, row: usize| {
            let product = Expr::product(vec![Expr::int(6).over(name("h", k)), rest.grouped()]);
            let next = if i == 0 { 1 } else { n - 1 };
            line(chain([name("d", i), product, self.expr(&system.right[row])]), Reason::EndSlope { i, next })
        };
        let mut lines = Vec::new();
        if let End::Slope(slope) = first {
            lines.push(right(0, 0, minus(difference(0), factor(self.expr(slope))), 0));
        }
        if let End::Slope(slope) = last {
            lines.push(right(n, n - 1, minus(self.expr(slope), difference(n - 1)), system.right.len() - 1));
        }
        lines
    }

    /// The system: as a matrix for numbers, equation by equation for points.
    fn system(&self, system: &SplineSystem<Fraction, Vec<Fraction>>) -> Line {
        let size = system.right.len();
        let ends = match self.spline.ends() {
            Ends::Periodic => AtEnds::Periodic,
            Ends::Each { first: End::Natural, last: End::Natural } => AtEnds::Natural,
            Ends::Each { first: End::Slope(_), last: End::Slope(_) } => AtEnds::Clamped,
            Ends::Each { first: End::NotAKnot, last: End::NotAKnot } => AtEnds::NotAKnot,
            Ends::Each { .. } => AtEnds::Given,
        };
        let matrix = system.matrix.matrix();
        if !self.form.scalar {
            let row = |row: usize| {
                let terms = (0..size).filter(|&k| !matrix[(row, k)].is_zero());
                let terms = terms.map(|k| term(&matrix[(row, k)], vec![name("M", k + system.first)]));
                chain([Expr::sum(terms.collect()), self.expr(&system.right[row])])
            };
            return line(sequence((0..size).map(row).collect()), Reason::MomentSystem(ends));
        }
        let table = |rows: Vec<Vec<Expr>>| {
            let rows = rows.into_iter().map(|row| row.into_iter().map(Some).collect());
            Expr::from(Kind::Matrix(rows.collect(), Delimiter::Paren))
        };
        let entries = matrix.row_iter().map(|row| row.iter().map(polynomial_expr).collect()).collect();
        let unknowns = (0..size).map(|k| vec![name("M", k + system.first)]).collect();
        let right = system.right.iter().map(|d| vec![self.expr(d)]).collect();
        let left = product(vec![table(entries), table(unknowns)]);
        line(chain([left, table(right)]), Reason::MomentSystem(ends))
    }

    /// S_i by its moments, and by powers of t.
    fn piece(&self, i: usize) -> [Line; 2] {
        let t = Fraction::from(MultiPoly::symbol(Symbol::new("t")));
        let variable = || Expr::name("t");
        let h = || name("h", i);
        let before = || minus(variable(), name("x", i)).grouped();
        let behind = || minus(name("x", i + 1), variable()).grouped();
        let cubic = |moment: Expr, distance: Expr| {
            plus(Expr::product(vec![
                moment.over(multiple(&integer(6), vec![h()])),
                distance.power(Expr::int(3)),
            ]))
        };
        let linear = |k: usize, distance: Expr| {
            let share = Expr::product(vec![name("M", k), h()]).over(Expr::int(6));
            plus(Expr::product(vec![minus(name("y", k).over(h()), share).grouped(), distance]))
        };
        let general = Expr::sum(vec![
            cubic(name("M", i), behind()),
            cubic(name("M", i + 1), before()),
            linear(i, behind()),
            linear(i + 1, before()),
        ]);
        let power = self.spline.power(i);
        let by_powers = value_of(&power, &t).expect("a piece has four coefficients");
        let left = || Expr::apply(name("S", i), vec![variable()]);
        [
            line(chain([left(), general]), Reason::Piece(i)),
            line(chain([left(), self.expr(&by_powers)]), Reason::ByPowers),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;

    #[test]
    fn a_parabola_bends_evenly() {
        let z = |list: &[i64]| list.iter().map(|&k| Fraction::from(integer(k))).collect::<Vec<_>>();
        let points: Vec<Vec<Fraction>> = z(&[0, 1, 4]).into_iter().map(|x| vec![x]).collect();
        let spline = CubicSpline::by_moments(&z(&[0, 1, 2]), &points, Ends::not_a_knot()).unwrap();
        assert!(spline.moments().iter().all(|m| m[0] == Fraction::from(rational(2, 1))));
        let derivation = moments(&spline, Form { scalar: true, rational: false });
        // Nodes, values, two steps, three lines of the equation, ends, system, solution, two pieces twice.
        assert_eq!(derivation.lines.len(), 13);
    }
}
