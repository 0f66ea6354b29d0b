//! Bézier curves over any interval, in any dimension.
//!
//! F(t) = Σ b_i B_i^n((t−a)/(b−a)), b_i = f(a^{n−i} b^i). A tableau holds all intermediate
//! points of de Casteljau's algorithm: level r, place i is f(u_1, …, u_r, a^{n−r−i}, b^i).
//!
//! Reference: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989); G. Farin, *Curves and
//! Surfaces for CAGD*, 5th ed. (2002), chapters 4–6.

use super::integers;
use super::{CurveError, Interval, Point, PolarValue, Vector, combination, dimension, lerp};
use crate::budget;
use crate::math::basis::raising;
use crate::math::blossom::{Argument, PolarForm};
use crate::math::number::{Int, Rational, binomial, binomial_row};
use crate::math::ring::compare;
use crate::math::ring::{Field, Ring};

/// A polynomial curve by its control points over an interval.
///
/// **Invariant.** At least one point, all of one dimension.
#[derive(Clone, PartialEq)]
pub struct BezierCurve<C> {
    points: Vec<Point<C>>,
    interval: Interval<C>,
}

/// All intermediate points of de Casteljau's or de Boor's algorithm: `levels[r][i]`, level 0 the
/// control points, the last level a single point.
#[derive(Clone, PartialEq)]
pub struct Tableau<C> {
    /// The points by levels.
    pub levels: Vec<Vec<Point<C>>>,
    /// Their polar labels: the arguments of the polar form.
    pub labels: Vec<Vec<Vec<C>>>,
}

debug_by_fields!(Tableau: levels, labels);

impl<C> Tableau<C> {
    /// The single point of the last level.
    ///
    /// # Panics
    /// Never on a tableau made here: the last level has one point.
    pub fn result(&self) -> &Point<C> {
        &self.levels[self.levels.len() - 1][0]
    }
}

/// Points from their coordinates.
fn points_of<C: Ring>(columns: &[Vec<Rational>]) -> Vec<Point<C>> {
    let count = columns.first().map_or(0, Vec::len);
    (0..count).map(|i| columns.iter().map(|column| C::from_rational(&column[i])).collect()).collect()
}

impl<C: Field> BezierCurve<C> {
    /// The curve with these control points over an interval [a, b].
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`], [`CurveError::Dimensions`].
    ///
    /// ```
    /// use polarform::curve::{BezierCurve, Interval};
    /// use polarform::number::{integer as z, rational as q};
    /// let c = BezierCurve::new(vec![vec![z(0), z(0)], vec![z(1), z(2)], vec![z(2), z(0)]], Interval::unit())?;
    /// assert_eq!(c.value(&q(1, 2)), [z(1), z(1)]);
    /// # Ok::<(), polarform::curve::CurveError>(())
    /// ```
    pub fn new(points: Vec<impl Into<Point<C>>>, interval: Interval<C>) -> Result<Self, CurveError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        dimension(&points)?;
        Ok(BezierCurve { points, interval })
    }

    /// The curve whose coordinates have these polar forms, raised to one degree.
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`] without coordinates.
    pub fn from_polar_forms(forms: &[PolarForm<C>], interval: Interval<C>) -> Result<Self, CurveError> {
        let degree = forms.iter().map(PolarForm::degree).max();
        let degree = degree.ok_or(CurveError::TooFewPoints { needed: 1, given: 0 })?;
        let columns: Vec<Vec<C>> =
            forms.iter().map(|form| form.elevate(degree - form.degree()).bezier_points(&interval)).collect();
        let point = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
        let points: Vec<Point<C>> = (0..=degree).map(point).collect();
        BezierCurve::new(points, interval)
    }

    /// The curve whose coordinates have these power coefficients, lowest first.
    ///
    /// # Errors
    /// As [`BezierCurve::from_polar_forms`].
    pub fn from_power(coordinates: &[Vec<C>], interval: Interval<C>) -> Result<Self, CurveError> {
        let forms: Vec<PolarForm<C>> = coordinates.iter().map(|c| PolarForm::new(c.clone())).collect();
        BezierCurve::from_polar_forms(&forms, interval)
    }

    /// b_0, …, b_n
    pub fn points(&self) -> &[Point<C>] {
        &self.points
    }

    /// [a, b]
    pub fn interval(&self) -> &Interval<C> {
        &self.interval
    }

    /// The degree n of the representation.
    pub fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// The number of coordinates.
    pub fn dimension(&self) -> usize {
        self.points[0].len()
    }

    /// Whether a parameter lies in [a, b]; `None` if that depends on symbols.
    pub fn contains(&self, t: &C) -> Option<bool> {
        let (a, b) = self.interval.ends();
        if t == a || t == b {
            return Some(true);
        }
        let forwards = compare(a, b)?;
        let inside = |x: &C, y: &C| compare(x, y).map(|order| order == forwards);
        Some(inside(a, t)? && inside(t, b)?)
    }

    /// F(t), also outside of [a, b]. Cost: n²/2 affine combinations, over Q on integers.
    pub fn value(&self, t: &C) -> Point<C> {
        let s = self.interval.local(t);
        if let Some(value) = super::polygon::value_of_numbers(&self.points, &s) {
            return value;
        }
        let mut level = self.points.clone();
        while level.len() > 1 {
            budget::step();
            level = level.windows(2).map(|pair| lerp(&pair[0], &pair[1], &s)).collect();
        }
        level.remove(0)
    }

    /// f(u_1, …, u_n): a point, or a vector if one of the arguments is one.
    ///
    /// # Errors
    /// [`CurveError::Arguments`] unless there are n of them.
    pub fn blossom(&self, arguments: &[Argument<C>]) -> Result<PolarValue<C>, CurveError> {
        let n = self.degree();
        if arguments.len() != n {
            return Err(CurveError::Arguments { expected: n, given: arguments.len() });
        }
        let mut level = self.points.clone();
        for argument in arguments {
            budget::step();
            level = self.step(&level, argument);
        }
        Ok(PolarValue::of(level.remove(0), arguments))
    }

    /// One level of de Casteljau's algorithm; for a vector the points lie at its images.
    fn step(&self, level: &[Point<C>], argument: &Argument<C>) -> Vec<Point<C>> {
        match argument {
            Argument::Point(u) => {
                let s = self.interval.local(u);
                level.windows(2).map(|pair| lerp(&pair[0], &pair[1], &s)).collect()
            }
            Argument::Vector(v) => {
                let s = v.times(self.interval.inverse_width());
                level.windows(2).map(|pair| ((&pair[1] - &pair[0]) * &s).from_origin()).collect()
            }
        }
    }

    /// De Casteljau's tableau for f(u_1, …, u_n), with polar labels.
    ///
    /// # Errors
    /// [`CurveError::Arguments`] unless there are n arguments.
    ///
    /// ```
    /// use polarform::curve::{BezierCurve, Interval};
    /// use polarform::number::{integer as z, rational as q};
    /// let c = BezierCurve::new(vec![vec![z(0)], vec![z(1)], vec![z(4)]], Interval::unit())?;
    /// let tableau = c.tableau(&[q(1, 2), q(1, 2)])?;
    /// assert_eq!(tableau.levels[1], [[q(1, 2)], [q(5, 2)]]);
    /// assert_eq!(tableau.labels[1], [[z(0), q(1, 2)], [q(1, 2), z(1)]]);
    /// # Ok::<(), polarform::curve::CurveError>(())
    /// ```
    pub fn tableau(&self, arguments: &[C]) -> Result<Tableau<C>, CurveError> {
        let n = self.degree();
        if arguments.len() != n {
            return Err(CurveError::Arguments { expected: n, given: arguments.len() });
        }
        budget::charge_terms((n as u64 + 1) * (n as u64 + 2));
        let mut levels = vec![self.points.clone()];
        for u in arguments {
            levels.push(self.step(&levels[levels.len() - 1], &Argument::Point(u.clone())));
        }
        let label = |r: usize, i: usize| {
            let first = std::iter::repeat_n(self.interval.start(), n - r - i);
            first.chain(&arguments[..r]).chain(std::iter::repeat_n(self.interval.end(), i)).cloned().collect()
        };
        let labels = (0..=n).map(|r| (0..=n - r).map(|i| label(r, i)).collect()).collect();
        Ok(Tableau { levels, labels })
    }

    /// The parts over [a, t] and [t, b]. Cost: n²/2 affine combinations, over Q on integers.
    ///
    /// # Errors
    /// [`CurveError::EmptyInterval`] if t is one of the ends.
    pub fn subdivide(&self, t: &C) -> Result<(Self, Self), CurveError> {
        let (before, after) = self.interval.split(t)?;
        let s = self.interval.local(t);
        let of_numbers = s.as_rational().and_then(|s| {
            let parts = self.columns_of_numbers()?.into_iter().map(|column| integers::split(&column, &s));
            let (left, right): (Vec<_>, Vec<_>) = parts.unzip();
            Some((points_of(&left), points_of(&right)))
        });
        let (left, right) = of_numbers.unwrap_or_else(|| self.split_by_steps(&s));
        Ok((BezierCurve::new(left, before)?, BezierCurve::new(right, after)?))
    }

    /// The first and the last point of each level of de Casteljau's algorithm.
    pub(super) fn split_by_steps(&self, s: &C) -> (Vec<Point<C>>, Vec<Point<C>>) {
        let mut level = self.points.clone();
        let (mut left, mut right) = (Vec::new(), Vec::new());
        loop {
            budget::steps(level.len() as u32);
            left.push(level[0].clone());
            right.push(level[level.len() - 1].clone());
            if level.len() == 1 {
                right.reverse();
                return (left, right);
            }
            level = level.windows(2).map(|pair| lerp(&pair[0], &pair[1], s)).collect();
        }
    }

    /// Each coordinate of all points, if they are numbers and there are any.
    fn columns_of_numbers(&self) -> Option<Vec<Vec<Rational>>> {
        if self.dimension() == 0 {
            return None;
        }
        let column = |k: usize| self.points.iter().map(|point| point[k].as_rational()).collect();
        (0..self.dimension()).map(column).collect()
    }

    /// The parts between consecutive parameters a, t_1, …, t_k, b.
    ///
    /// # Errors
    /// [`CurveError::EmptyInterval`] if two consecutive ones are equal.
    pub fn subdivide_at(&self, parameters: &[C]) -> Result<Vec<Self>, CurveError> {
        let mut parts = Vec::with_capacity(parameters.len() + 1);
        let mut rest = self.clone();
        for t in parameters {
            let (left, right) = rest.subdivide(t)?;
            parts.push(left);
            rest = right;
        }
        parts.push(rest);
        Ok(parts)
    }

    /// The same polynomial over another interval [r, s]: control points f(r^{n−i}, s^i).
    pub fn part(&self, interval: Interval<C>) -> Self {
        let (r, s) = interval.ends();
        let n = self.degree();
        let mut points = Vec::with_capacity(n + 1);
        // Level i of the tableau for r is f(r^i, …); finish each with s.
        let mut level = self.points.clone();
        let mut ends = vec![];
        for i in 0..=n {
            ends.push(level.clone());
            if i < n {
                level = self.step(&level, &Argument::Point(r.clone()));
            }
        }
        for mut level in ends.into_iter().rev() {
            while level.len() > 1 {
                level = self.step(&level, &Argument::Point(s.clone()));
            }
            points.push(level.remove(0));
        }
        BezierCurve { points, interval }
    }

    /// The same control points over another interval [c, d]: the curve F((t−c)/(d−c) (b−a) + a).
    pub fn over(&self, interval: Interval<C>) -> Self {
        BezierCurve { points: self.points.clone(), interval }
    }

    /// The same curve with `by` more control points. Cost: one product for each entry of the
    /// raising matrix; over Q one product of integer polynomials.
    pub fn elevate(&self, by: usize) -> Self {
        budget::charge_terms((self.points.len() as u64).saturating_add(by as u64));
        if let Some(columns) = self.columns_of_numbers() {
            let raised: Vec<_> = columns.iter().map(|column| integers::elevated(column, by)).collect();
            return BezierCurve { points: points_of(&raised), interval: self.interval.clone() };
        }
        self.elevate_by_matrix(by)
    }

    pub(super) fn elevate_by_matrix(&self, by: usize) -> Self {
        let n = self.degree();
        let matrix = raising(n, n + by).expect("the degree does not fall");
        let points = (0..=n + by).map(|i| {
            let mut point = Point::from(vec![C::zero(); self.dimension()]);
            for j in i.saturating_sub(by)..=i.min(n) {
                for (x, y) in point.iter_mut().zip(&self.points[j]) {
                    *x += y.scaled(&matrix[(i, j)]);
                }
            }
            point
        });
        BezierCurve { points: points.collect(), interval: self.interval.clone() }
    }

    /// The degree of the polynomial: the largest k with Δ^k b_0 ≠ 0 (0 for a constant).
    pub fn exact_degree(&self) -> usize {
        (1..=self.degree()).rev().find(|&k| !self.differences(k)[0].is_zero()).unwrap_or(0)
    }

    /// The same curve with `by` fewer control points, where that is exact.
    ///
    /// # Errors
    /// [`CurveError::NotReducible`] with the exact degree; [`BezierCurve::differences`] then
    /// tells the defect Δ^n b_0.
    pub fn reduce(&self, by: usize) -> Result<Self, CurveError> {
        let (degree, exact) = (self.degree(), self.exact_degree());
        if by > degree - exact {
            return Err(CurveError::NotReducible { degree, exact, by });
        }
        let forms: Vec<PolarForm<C>> = self
            .polar_forms()
            .into_iter()
            .map(|form| form.reduce(by).expect("the leading differences vanish"))
            .collect();
        BezierCurve::from_polar_forms(&forms, self.interval.clone())
    }

    /// Δ^k b_0, …, Δ^k b_{n−k}, with Δ b_i = b_{i+1} − b_i; none if k > n.
    pub fn differences(&self, k: usize) -> Vec<Vector<C>> {
        let mut level: Vec<Vector<C>> = self.points.iter().map(Point::position).collect();
        for _ in 0..k {
            budget::step();
            level = level.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
        }
        level
    }

    /// F', of degree n − 1 or 0, see [`BezierCurve::nth_derivative`].
    pub fn derivative(&self) -> Self {
        self.nth_derivative(1)
    }

    /// F^{(k)}, of degree n − k: n!/(n−k)! Δ^k b_i / (b−a)^k; zero if k > n. Its control points are
    /// these vectors drawn from the origin (the hodograph).
    pub fn nth_derivative(&self, k: usize) -> Self {
        let n = self.degree();
        let interval = self.interval.clone();
        if k > n {
            return BezierCurve { points: vec![Vector::zero(self.dimension()).from_origin()], interval };
        }
        let falling: Int = (n - k + 1..=n).fold(Int::ONE, |product, i| product * Int::from(i));
        let factor = num_traits::pow(self.interval.inverse_width().clone(), k)
            .scaled(&Rational::from_integer(falling));
        let points = self.differences(k).iter().map(|d| (d * &factor).from_origin()).collect();
        BezierCurve { points, interval }
    }

    /// The curve of degree n + 1 that starts at `start` and has the position vectors of this one as
    /// derivatives.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] if start has another dimension.
    pub fn antiderivative(&self, start: impl Into<Point<C>>) -> Result<Self, CurveError> {
        let start = start.into();
        if start.len() != self.dimension() {
            return Err(CurveError::DimensionsOf { left: self.dimension(), right: start.len() });
        }
        let share = self.width().scaled(&Rational::new(Int::ONE, Int::from(self.points.len())));
        let mut points = vec![start];
        for point in &self.points {
            points.push(&points[points.len() - 1] + &(point.position() * &share));
        }
        BezierCurve::new(points, self.interval.clone())
    }

    /// ∫_a^b F(t) dt = (b − a)/(n + 1) Σ b_i, of position vectors.
    pub fn integral(&self) -> Vector<C> {
        let share = self.width().scaled(&Rational::new(Int::ONE, Int::from(self.points.len())));
        combination(self.dimension(), self.points.iter().map(|point| (&share, point)))
    }

    /// b − a
    fn width(&self) -> C {
        let (a, b) = self.interval.ends();
        b.minus(a)
    }

    /// The polar form of each coordinate.
    pub fn polar_forms(&self) -> Vec<PolarForm<C>> {
        (0..self.dimension())
            .map(|k| {
                let column: Vec<C> = self.points.iter().map(|point| point[k].clone()).collect();
                PolarForm::from_bezier_points_over(&column, &self.interval).expect("there are points")
            })
            .collect()
    }

    /// The power coefficients of each coordinate, lowest first, n + 1 of them.
    pub fn power(&self) -> Vec<Vec<C>> {
        self.polar_forms().iter().map(|form| form.coefficients().to_vec()).collect()
    }

    /// b_0 and the edge vectors b_1 − b_0, …, b_n − b_{n−1}: the coefficients in Bézier's
    /// original basis f_i^n = Σ_{j≥i} B_j^n.
    pub fn edges(&self) -> (&Point<C>, Vec<Vector<C>>) {
        (&self.points[0], self.differences(1))
    }

    /// The curve with these coefficients in Bézier's original basis.
    ///
    /// # Errors
    /// As [`BezierCurve::new`].
    pub fn from_edges(
        start: Point<C>,
        edges: &[Vector<C>],
        interval: Interval<C>,
    ) -> Result<Self, CurveError> {
        let mut points = vec![start];
        for (i, edge) in edges.iter().enumerate() {
            if edge.len() != points[0].len() {
                let (found, expected) = (edge.len(), points[0].len());
                return Err(CurveError::Dimensions { index: i + 1, found, expected });
            }
            points.push(&points[i] + edge);
        }
        BezierCurve::new(points, interval)
    }

    /// The product with another curve over the same interval, of degree m + n: of a function and
    /// a curve, or the scalar product of two curves of one dimension.
    ///
    /// c_k = Σ_{i+j=k} C(m,i) C(n,j)/C(m+n,k) a_i b_j.
    ///
    /// # Errors
    /// [`CurveError::NoCommonEnd`] for different intervals, [`CurveError::DimensionsOf`].
    pub fn product(&self, other: &Self) -> Result<Self, CurveError> {
        if self.interval != other.interval {
            return Err(CurveError::NoCommonEnd);
        }
        let (left, right) = (self.dimension(), other.dimension());
        type Multiply<C> = fn(&[C], &[C]) -> Vector<C>;
        let multiply: Multiply<C> = match (left, right) {
            (1, _) => |p, q| q.iter().map(|y| p[0].times(y)).collect(),
            (_, 1) => |p, q| p.iter().map(|x| q[0].times(x)).collect(),
            _ if left == right => {
                |p, q| [p.iter().zip(q).fold(C::zero(), |total, (x, y)| total.plus(&x.times(y)))].into()
            }
            _ => return Err(CurveError::DimensionsOf { left, right }),
        };
        let (m, n) = (self.degree(), other.degree());
        let (rows, columns, whole) = (binomial_row(m), binomial_row(n), binomial_row(m + n));
        let mut points: Vec<Point<C>> = Vec::with_capacity(m + n + 1);
        for k in 0..=m + n {
            let mut total: Option<Vector<C>> = None;
            for i in k.saturating_sub(n)..=k.min(m) {
                budget::step();
                let weight = Rational::new(&rows[i] * &columns[k - i], whole[k].clone());
                let product = multiply(&self.points[i], &other.points[k - i]);
                let term: Vector<C> = product.iter().map(|x| x.scaled(&weight)).collect();
                total = Some(match total {
                    Some(total) => total + term,
                    None => term,
                });
            }
            points.extend(total.map(Vector::from_origin));
        }
        BezierCurve::new(points, self.interval.clone())
    }

    /// F(G(t)) over an interval, for a polynomial G given by its polar form.
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`] for a curve without coordinates.
    pub fn compose(&self, inner: &PolarForm<C>, interval: Interval<C>) -> Result<Self, CurveError> {
        let forms: Vec<PolarForm<C>> = self.polar_forms().iter().map(|form| form.compose(inner)).collect();
        BezierCurve::from_polar_forms(&forms, interval)
    }
}

/// The polynomials f_0^n, …, f_n^n of Bézier's original basis, as power coefficients:
/// f_0 = 1 and f_i = Σ_{j≥i} B_j^n = ((−t)^i / (i−1)!) d^{i−1}/dt^{i−1} (((1−t)^n − 1)/t).
///
/// ```
/// use polarform::curve::bezier_edge_basis;
/// use polarform::number::integer as z;
/// let basis = bezier_edge_basis(2);
/// assert_eq!(basis, [vec![z(1), z(0), z(0)], vec![z(0), z(2), z(-1)], vec![z(0), z(0), z(1)]]);
/// ```
pub fn bezier_edge_basis(n: usize) -> Vec<Vec<Rational>> {
    let matrix = crate::math::basis::bernstein_to_power(n);
    let mut basis: Vec<Vec<Rational>> = Vec::with_capacity(n + 1);
    let mut running: Vec<Rational> = vec![<Rational as num_traits::Zero>::zero(); n + 1];
    for j in (0..=n).rev() {
        for (x, y) in running.iter_mut().zip(matrix.column(j).iter()) {
            *x += y;
        }
        basis.push(running.clone());
    }
    basis.reverse();
    basis
}

/// Where B_i^n is largest on [0, 1], and its value there: t = i/n, i^i (n−i)^{n−i} C(n,i)/n^n.
/// For n = 0 every parameter is such a place, and 0 is given.
///
/// # Errors
/// [`CurveError::Arguments`] if i > n.
pub fn bernstein_maximum(n: usize, i: usize) -> Result<(Rational, Rational), CurveError> {
    if i > n {
        return Err(CurveError::Arguments { expected: n, given: i });
    }
    let place = Rational::new(Int::from(i), Int::from(n.max(1)));
    let value = crate::math::basis::bernstein(n, i, &place);
    Ok((place, value))
}

/// The matrix of the B_j^n in the B_i^n(ct): B_i^n(ct) = Σ_{j≥i} B_i^j(c) B_j^n(t); entry (i, j)
/// is B_i^j(c). Its columns are the control weights of the part [0, c].
pub fn bernstein_scaling<C: Ring>(n: usize, c: &C) -> Vec<Vec<C>> {
    let rest = C::one().minus(c);
    let entry = |i: usize, j: usize| {
        if i > j {
            return C::zero();
        }
        let weight = Rational::from_integer(binomial(j, i));
        num_traits::pow(c.clone(), i).times(&num_traits::pow(rest.clone(), j - i)).scaled(&weight)
    };
    (0..=n).map(|i| (0..=n).map(|j| entry(i, j)).collect()).collect()
}

#[cfg(test)]
#[path = "bezier_tests.rs"]
pub(crate) mod tests;
