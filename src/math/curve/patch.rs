//! Tensor-product Bézier patches.
//!
//! Definition: a patch of degree (m, n) over [a, b] × [c, d] has a net of (m+1)(n+1) control
//! points. Its polar form f takes m arguments u_1, …, u_m and n arguments v_1, …, v_n, is affine
//! in each and symmetric in each group; the control point (i, j) is f(a^{m−i}, b^i; c^{n−j}, d^j),
//! and the surface point at (u, v) is f(u, …, u; v, …, v).
//!
//! Every operation acts on the columns of the net (in u) or on its rows (in v) as on Bézier
//! points of a curve, and the two directions commute.
//!
//! **Invariant.** The net has at least one point, rows of equal length, points of equal dimension.
//!
//! References: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989), section 10; G. Farin,
//! *Curves and Surfaces for CAGD*, 5th ed. (2002), chapters 14 and 15.

use super::polygon::{self, falling};
use super::{BezierCurve, CurveError, Point, PolarValue, Vector};
use crate::budget;
use crate::math::blossom::{Argument, TensorPolarForm};
use crate::math::interval::Interval;
use crate::math::number::{Rational, binomial_row};
use crate::math::ring::{Field, Ring};

/// Points by rows: entry (i, j) belongs to the i-th point in u and the j-th in v.
pub type Net<C> = Vec<Vec<Point<C>>>;

/// One of the two parameters of a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The first one.
    U,
    /// The second one.
    V,
}

/// One of the four boundary curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// u = a, a curve in v.
    UStart,
    /// u = b, a curve in v.
    UEnd,
    /// v = c, a curve in u.
    VStart,
    /// v = d, a curve in u.
    VEnd,
}

/// In which order de Casteljau's algorithm puts in the arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// All m times u, then all n times v.
    UFirst,
    /// All n times v, then all m times u.
    VFirst,
    /// u and v together, by bilinear means of four points; for m = n.
    Bilinear,
}

/// A tensor-product Bézier patch.
///
/// ```
/// use polarform::curve::{CurveError, Interval, TensorPatch};
/// use polarform::number::{integer as z, rational as q};
/// // the bilinear patch z = u v
/// let net = vec![vec![vec![z(0), z(0), z(0)], vec![z(0), z(1), z(0)]],
///                vec![vec![z(1), z(0), z(0)], vec![z(1), z(1), z(1)]]];
/// let patch = TensorPatch::new(net, Interval::unit(), Interval::unit())?;
/// assert_eq!(patch.value(&q(1, 2), &q(1, 3)), [q(1, 2), q(1, 3), q(1, 6)]);
/// // its normal (−v, −u, 1) as a patch of degree (1, 1)
/// assert_eq!(patch.normal()?.value(&q(1, 2), &q(1, 3)), [q(-1, 3), q(-1, 2), z(1)]);
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct TensorPatch<C> {
    net: Net<C>,
    u: Interval<C>,
    v: Interval<C>,
}

/// The same net with the two directions exchanged.
pub(crate) fn transposed<T: Clone>(net: &[Vec<T>]) -> Vec<Vec<T>> {
    (0..net[0].len()).map(|j| net.iter().map(|row| row[j].clone()).collect()).collect()
}

fn in_v<C: Ring>(net: &[Vec<Point<C>>], change: impl Fn(&[Point<C>]) -> Vec<Point<C>>) -> Net<C> {
    net.iter().map(|row| change(row)).collect()
}

fn in_u<C: Ring>(net: &[Vec<Point<C>>], change: impl Fn(&[Point<C>]) -> Vec<Point<C>>) -> Net<C> {
    transposed(&in_v(&transposed(net), change))
}

impl<C: Field> TensorPatch<C> {
    /// The patch with this net over the rectangle of two intervals.
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`], [`CurveError::RaggedNet`], [`CurveError::Dimensions`] with
    /// the place counted along the rows.
    pub fn new(
        net: Vec<Vec<impl Into<Point<C>>>>,
        u: Interval<C>,
        v: Interval<C>,
    ) -> Result<Self, CurveError> {
        let row = |row: Vec<_>| row.into_iter().map(Into::into).collect();
        let net: Net<C> = net.into_iter().map(row).collect();
        let expected = net.first().map_or(0, Vec::len);
        if expected == 0 {
            return Err(CurveError::TooFewPoints { needed: 1, given: 0 });
        }
        if let Some(row) = net.iter().position(|row| row.len() != expected) {
            return Err(CurveError::RaggedNet { row, found: net[row].len(), expected });
        }
        let size = net[0][0].len();
        match net.iter().flatten().position(|point| point.len() != size) {
            Some(index) => {
                let found = net[index / expected][index % expected].len();
                Err(CurveError::Dimensions { index, found, expected: size })
            }
            None => Ok(TensorPatch { net, u, v }),
        }
    }

    /// The control points.
    pub fn net(&self) -> &[Vec<Point<C>>] {
        &self.net
    }

    /// The interval of u.
    pub fn u(&self) -> &Interval<C> {
        &self.u
    }

    /// The interval of v.
    pub fn v(&self) -> &Interval<C> {
        &self.v
    }

    /// (m, n)
    pub fn degrees(&self) -> (usize, usize) {
        (self.net.len() - 1, self.net[0].len() - 1)
    }

    /// The number of coordinates.
    pub fn dimension(&self) -> usize {
        self.net[0][0].len()
    }

    fn with_net(&self, net: Net<C>) -> Self {
        TensorPatch { net, u: self.u.clone(), v: self.v.clone() }
    }

    /// f(u_1, …, u_m; v_1, …, v_n), points and vectors mixed. Cost: O(m n (m + n)) per coordinate
    /// at most.
    ///
    /// # Errors
    /// [`CurveError::Arguments`] for a wrong number in either group.
    pub fn blossom(&self, u: &[Argument<C>], v: &[Argument<C>]) -> Result<PolarValue<C>, CurveError> {
        let (m, n) = self.degrees();
        for (expected, given) in [(m, u.len()), (n, v.len())] {
            if expected != given {
                return Err(CurveError::Arguments { expected, given });
            }
        }
        let along_v: Vec<[C; 2]> = v.iter().map(|argument| self.v.coordinates(argument)).collect();
        let along_u: Vec<[C; 2]> = u.iter().map(|argument| self.u.coordinates(argument)).collect();
        let column: Vec<Point<C>> = self.net.iter().map(|row| polygon::blossom(row, &along_v)).collect();
        Ok(PolarValue::of(polygon::blossom(&column, &along_u), &[u, v].concat()))
    }

    /// The surface point at (u, v), inside of the rectangle or outside.
    pub fn value(&self, u: &C, v: &C) -> Point<C> {
        let s = self.v.point_coordinates(v);
        let column: Vec<Point<C>> = self.net.iter().map(|row| polygon::value(row, &s)).collect();
        polygon::value(&column, &self.u.point_coordinates(u))
    }

    /// All nets of de Casteljau's algorithm, from the control net to the single point (u, v).
    ///
    /// Entry (i, j) after r arguments u and s arguments v is
    /// f(u^r, a^{m−r−i}, b^i; v^s, c^{n−s−j}, d^j).
    ///
    /// # Errors
    /// [`CurveError::Degrees`] for the bilinear scheme if m ≠ n.
    pub fn tableau(&self, u: &C, v: &C, scheme: Scheme) -> Result<Vec<Net<C>>, CurveError> {
        let (m, n) = self.degrees();
        let (s, t) = (self.u.point_coordinates(u), self.v.point_coordinates(v));
        let levels = match scheme {
            Scheme::Bilinear if m != n => return Err(CurveError::Degrees { left: m, right: n }),
            Scheme::Bilinear => m,
            _ => m + n,
        };
        budget::charge_terms((levels as u64 + 1) * (m as u64 + 1) * (n as u64 + 1));
        let mut nets = vec![self.net.clone()];
        for level in 0..levels {
            let last = &nets[level];
            nets.push(match scheme {
                Scheme::Bilinear => bilinear(last, &s, &t),
                Scheme::UFirst if level < m => in_u(last, |column| polygon::put(column, &s)),
                Scheme::VFirst if level >= n => in_u(last, |column| polygon::put(column, &s)),
                _ => in_v(last, |row| polygon::put(row, &t)),
            });
        }
        Ok(nets)
    }

    /// The two patches on both sides of u = t, or of v = t.
    ///
    /// # Errors
    /// [`CurveError::EmptyInterval`] if t is an end of the interval.
    pub fn subdivide(&self, direction: Direction, t: &C) -> Result<(Self, Self), CurveError> {
        if direction == Direction::U {
            let (left, right) = self.transposed().subdivide(Direction::V, t)?;
            return Ok((left.transposed(), right.transposed()));
        }
        let (start, end) = self.v.split(t)?;
        let s = self.v.point_coordinates(t);
        let (left, right) = self.net.iter().map(|row| polygon::split(row, &s)).unzip();
        let part = |net, v| TensorPatch { net, u: self.u.clone(), v };
        Ok((part(left, start), part(right, end)))
    }

    /// The same surface over another rectangle. Cost: O(m n (m² + n²)).
    pub fn part(&self, u: Interval<C>, v: Interval<C>) -> Self {
        let ends = |whole: &Interval<C>, part: &Interval<C>| {
            (whole.point_coordinates(part.start()), whole.point_coordinates(part.end()))
        };
        let ((p, q), (r, s)) = (ends(&self.u, &u), ends(&self.v, &v));
        let net = in_v(&self.net, |row| polygon::values(row, &r, &s));
        TensorPatch { net: in_u(&net, |column| polygon::values(column, &p, &q)), u, v }
    }

    /// The same surface of degree (m + by_u, n + by_v).
    pub fn elevate(&self, by_u: usize, by_v: usize) -> Self {
        let size = |points: usize, by: usize| (points as u64).saturating_add(by as u64);
        budget::charge_terms(size(self.net.len(), by_u).saturating_mul(size(self.net[0].len(), by_v)));
        let net = in_v(&self.net, |row| polygon::elevated(row, by_v));
        self.with_net(in_u(&net, |column| polygon::elevated(column, by_u)))
    }

    /// The smallest degrees in u and in v with which the surface can be written.
    pub fn exact_degrees(&self) -> (usize, usize) {
        let exact = |net: &[Vec<Point<C>>]| net.iter().map(|row| polygon::exact_degree(row)).max();
        (exact(&transposed(&self.net)).unwrap_or(0), exact(&self.net).unwrap_or(0))
    }

    /// The same surface of degree (m − by_u, n − by_v), exactly.
    ///
    /// # Errors
    /// [`CurveError::NotReducible`] with the degrees in the direction that fails, u first.
    pub fn reduce(&self, by_u: usize, by_v: usize) -> Result<Self, CurveError> {
        let ((m, n), (exact_m, exact_n)) = (self.degrees(), self.exact_degrees());
        polygon::check_reducible(m, exact_m, by_u)?;
        polygon::check_reducible(n, exact_n, by_v)?;
        let net = in_v(&self.net, |row| polygon::reduced(row, by_v));
        Ok(self.with_net(in_u(&net, |column| polygon::reduced(column, by_u))))
    }

    /// ∂^{r+s}/∂u^r ∂v^s as a patch of degree (m − r, n − s), where a degree below 0 gives zero
    /// of degree 0: m!/(m−r)! n!/(n−s)! f(…, 1̂^r; …, 1̂^s).
    pub fn derivative(&self, r: usize, s: usize) -> Self {
        let net = in_v(&self.net, |row| polygon::derivative(row, s, self.v.inverse_width()));
        self.with_net(in_u(&net, |column| polygon::derivative(column, r, self.u.inverse_width())))
    }

    /// The value of ∂^{r+s}/∂u^r ∂v^s at (u, v), by one polar value.
    pub fn derivative_at(&self, r: usize, s: usize, u: &C, v: &C) -> Vector<C> {
        let (m, n) = self.degrees();
        if r > m || s > n {
            return Vector::zero(self.dimension());
        }
        let arguments = |interval: &Interval<C>, t: &C, degree: usize, order: usize| -> Vec<[C; 2]> {
            let mut list = vec![interval.point_coordinates(t); degree - order];
            list.resize(degree, interval.coordinates(&Argument::Vector(C::one())));
            list
        };
        let (along_u, along_v) = (arguments(&self.u, u, m, r), arguments(&self.v, v, n, s));
        let column: Vec<Point<C>> = self.net.iter().map(|row| polygon::blossom(row, &along_v)).collect();
        let factor = C::from_rational(&(falling(m, r) * falling(n, s)));
        polygon::blossom(&column, &along_u).position() * &factor
    }

    /// The control points of a boundary curve, in the direction of its parameter.
    pub fn boundary(&self, side: Side) -> Vec<Point<C>> {
        let (m, n) = self.degrees();
        let column = |j: usize| self.net.iter().map(|row| row[j].clone()).collect();
        match side {
            Side::UStart => self.net[0].clone(),
            Side::UEnd => self.net[m].clone(),
            Side::VStart => column(0),
            Side::VEnd => column(n),
        }
    }

    /// A boundary curve.
    pub fn boundary_curve(&self, side: Side) -> BezierCurve<C> {
        let along = match side {
            Side::UStart | Side::UEnd => &self.v,
            Side::VStart | Side::VEnd => &self.u,
        };
        BezierCurve::new(self.boundary(side), along.clone()).expect("points of equal dimension")
    }

    /// The normal ∂f/∂u × ∂f/∂v as a polynomial: a patch of vectors of degree (2m − 1, 2n − 1).
    ///
    /// It vanishes where the patch is not regular. Cost: O(m² n²) products.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless the dimension is 3.
    pub fn normal(&self) -> Result<Self, CurveError> {
        if self.dimension() != 3 {
            return Err(CurveError::DimensionsOf { left: self.dimension(), right: 3 });
        }
        let (along_u, along_v) = (self.derivative(1, 0), self.derivative(0, 1));
        let parts = |patch: &Self| (0..3).map(|k| patch.coordinate(k)).collect::<Vec<_>>();
        let normal = polygon::cross(
            &parts(&along_u),
            &parts(&along_v),
            |f, g| polygon::product(f, g),
            |f, g| minus(&f, &g),
        );
        Ok(self.with_net(joined(&normal)))
    }

    /// The Bernstein coefficients of the k-th coordinate.
    pub(super) fn coordinate(&self, k: usize) -> Vec<Vec<C>> {
        self.net.iter().map(|row| row.iter().map(|point| point[k].clone()).collect()).collect()
    }

    /// The patch over the same rectangle with these Bernstein coefficients of its coordinates.
    pub(super) fn with_coordinates(&self, coordinates: &[Vec<Vec<C>>]) -> Self {
        self.with_net(joined(coordinates))
    }

    /// The same surface with the parameters exchanged.
    pub fn transposed(&self) -> Self {
        TensorPatch { net: transposed(&self.net), u: self.v.clone(), v: self.u.clone() }
    }

    /// The points c_{ij} of f(u, v) = Σ c_{ij} u^i v^j.
    pub fn power_coefficients(&self) -> Net<C> {
        let frame = |interval: &Interval<C>| {
            [Argument::Point(C::zero()), Argument::Vector(C::one())].map(|p| interval.coordinates(&p))
        };
        let ([p, q], [r, s]) = (frame(&self.u), frame(&self.v));
        let net = in_v(&self.net, |row| polygon::values(row, &r, &s));
        let net = in_u(&net, |column| polygon::values(column, &p, &q));
        let (m, n) = self.degrees();
        let (rows, columns) = (binomial_row(m), binomial_row(n));
        let weigh = |(row, a): (&Vec<Point<C>>, &crate::math::number::Int)| {
            row.iter()
                .zip(&columns)
                .map(|(point, b)| point.iter().map(|x| x.scaled(&Rational::from_integer(a * b))).collect())
                .collect()
        };
        net.iter().zip(&rows).map(weigh).collect()
    }

    /// The patch Σ c_{ij} u^i v^j over a rectangle.
    ///
    /// # Errors
    /// As for [`TensorPatch::new`].
    pub fn from_power_coefficients(
        grid: Vec<Vec<impl Into<Point<C>>>>,
        u: Interval<C>,
        v: Interval<C>,
    ) -> Result<Self, CurveError> {
        let patch = TensorPatch::new(grid, u, v)?;
        let nets: Vec<Vec<Vec<C>>> = (0..patch.dimension())
            .map(|k| power_form(patch.coordinate(k)).bezier_net(&patch.u, &patch.v))
            .collect();
        Ok(if nets.is_empty() { patch } else { patch.with_coordinates(&nets) })
    }

    /// The polar form of each coordinate.
    pub fn polar_forms(&self) -> Vec<TensorPolarForm<C>> {
        let power = self.with_net(self.power_coefficients());
        (0..self.dimension()).map(|k| power_form(power.coordinate(k))).collect()
    }
}

fn power_form<C: Ring>(grid: Vec<Vec<C>>) -> TensorPolarForm<C> {
    TensorPolarForm::new(grid).expect("a net has rows of equal positive length")
}

/// One level of the bilinear scheme: Σ α_k β_l b_{i+k,j+l} over the four neighbours.
fn bilinear<C: Ring>(net: &[Vec<Point<C>>], alpha: &[C; 2], beta: &[C; 2]) -> Net<C> {
    let square = |pair: &[Vec<Point<C>>], j: usize| {
        budget::step();
        let mut total = Point::from(vec![C::zero(); pair[0][j].len()]);
        for (k, a) in alpha.iter().enumerate() {
            for (l, b) in beta.iter().enumerate() {
                let weight = a.times(b);
                total.iter_mut().zip(&pair[k][j + l]).for_each(|(x, y)| *x += weight.times(y));
            }
        }
        total
    };
    net.windows(2).map(|pair| (0..pair[0].len() - 1).map(|j| square(pair, j)).collect()).collect()
}

/// Points from their coordinates; there is at least one coordinate.
fn joined<C: Ring>(coordinates: &[Vec<Vec<C>>]) -> Net<C> {
    let point = |i: usize, j: usize| coordinates.iter().map(|net| net[i][j].clone()).collect();
    let (rows, columns) = (coordinates[0].len(), coordinates[0][0].len());
    (0..rows).map(|i| (0..columns).map(|j| point(i, j)).collect()).collect()
}

/// f − g for nets of equal size.
pub(super) fn minus<C: Ring>(f: &[Vec<C>], g: &[Vec<C>]) -> Vec<Vec<C>> {
    polygon::zipped(f, g, C::minus)
}

#[cfg(test)]
pub(in crate::math::curve) mod tests;
