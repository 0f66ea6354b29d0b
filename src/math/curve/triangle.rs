//! Triangular Bézier patches.
//!
//! Definition: a patch of degree n over a triangle with corners a, b, c has (n+1)(n+2)/2 control
//! points f(a^i, b^j, c^k), i + j + k = n, where the polar form f is symmetric and affine in each
//! of its n arguments, points of the plane; the surface point at p is f(p, …, p).
//!
//! **Order.** Control points are listed by i descending, then by j descending: for n = 2
//! (2,0,0), (1,1,0), (1,0,1), (0,2,0), (0,1,1), (0,0,2). Row r of the triangle has i = n − r.
//!
//! **Invariant.** At least one point, all of equal dimension, their number fits the degree.
//!
//! References: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989), section 11; G. Farin,
//! *Curves and Surfaces for CAGD*, 5th ed. (2002), chapter 17.

use super::domain::{Corner, Triangle};
use super::polygon::{self, falling};
use super::{CurveError, Point, PolarValue, Vector, combination, dimension};
use crate::budget;
use crate::math::blossom::{Argument, PointArgument, TotalDegreePolarForm};
use crate::math::number::{Int, Rational, multinomial};
use crate::math::ring::{Field, Ring};

/// The multi-indices (i, j, k) with sum n, in the order of the control points.
///
/// ```
/// use polarform::curve::indices;
/// assert_eq!(indices(1), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
/// ```
pub fn indices(n: usize) -> Vec<[usize; 3]> {
    (0..=n).flat_map(|r| (0..=r).map(move |k| [n - r, r - k, k])).collect()
}

/// The place of (i, j, k) in that order.
pub(super) fn place(j: usize, k: usize) -> usize {
    let r = j + k;
    r * (r + 1) / 2 + k
}

/// Puts in one argument with these barycentric coordinates: one level of de Casteljau's algorithm.
fn put<C: Ring>(points: &[Point<C>], degree: usize, argument: &[C; 3]) -> Vec<Point<C>> {
    budget::steps(points.len() as u32);
    let mix = |[_, j, k]: [usize; 3]| {
        let around = [place(j, k), place(j + 1, k), place(j, k + 1)].map(|at| &points[at]);
        combination(points[0].len(), argument.iter().zip(around)).from_origin()
    };
    indices(degree - 1).into_iter().map(mix).collect()
}

/// f(p^i, q^j, r^k) for all i + j + k = n. Cost: O(n^5) products at most.
fn values<C: Ring>(points: &[Point<C>], n: usize, [p, q, r]: [&[C; 3]; 3]) -> Vec<Point<C>> {
    let stages = |start: &[Point<C>], degree: usize, argument: &[C; 3]| {
        let mut list = vec![start.to_vec()];
        for left in (1..=degree).rev() {
            let next = put(&list[list.len() - 1], left, argument);
            list.push(next);
        }
        list
    };
    let mut result = Vec::with_capacity(points.len());
    for (i, first) in stages(points, n, p).iter().enumerate().rev() {
        for (j, second) in stages(first, n - i, q).iter().enumerate().rev() {
            let last = stages(second, n - i - j, r);
            result.extend(last.into_iter().next_back().into_iter().flatten());
        }
    }
    result
}

/// A triangular Bézier patch.
///
/// ```
/// use polarform::curve::{CurveError, Triangle, TrianglePatch};
/// use polarform::number::{integer as z, rational as q};
/// // x y of degree 2 over the unit triangle: only f(b, c) = 1/2 is not 0
/// let points = [z(0), z(0), z(0), z(0), q(1, 2), z(0)].map(|x| vec![x]).to_vec();
/// let patch = TrianglePatch::new(points, Triangle::unit())?;
/// assert_eq!(patch.value(&[q(1, 3), q(1, 2)])?, [q(1, 6)]);
/// assert_eq!(patch.integral(), [q(1, 24)]);
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct TrianglePatch<C> {
    points: Vec<Point<C>>,
    degree: usize,
    triangle: Triangle<C>,
}

impl<C: Field> TrianglePatch<C> {
    /// The patch with these control points, in the order of [`indices`].
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`], [`CurveError::NotTriangular`], [`CurveError::Dimensions`].
    pub fn new(points: Vec<impl Into<Point<C>>>, triangle: Triangle<C>) -> Result<Self, CurveError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        dimension(&points)?;
        let count = points.len();
        let size = |n: usize| (n + 1) * (n + 2) / 2;
        let degree = (0..).take_while(|&n| size(n) <= count).last().unwrap_or(0);
        if size(degree) != count {
            return Err(CurveError::NotTriangular { count });
        }
        Ok(TrianglePatch { points, degree, triangle })
    }

    fn with_points(&self, points: Vec<Point<C>>, degree: usize) -> Self {
        TrianglePatch { points, degree, triangle: self.triangle.clone() }
    }

    /// The control points.
    pub fn points(&self) -> &[Point<C>] {
        &self.points
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The number of coordinates.
    pub fn dimension(&self) -> usize {
        self.points[0].len()
    }

    /// The triangle of the parameter plane.
    pub fn triangle(&self) -> &Triangle<C> {
        &self.triangle
    }

    /// f for arguments given by barycentric coordinates, with sum 1 for a point and 0 for a vector.
    ///
    /// Cost: O(n³) products per coordinate.
    ///
    /// # Errors
    /// [`CurveError::Arguments`] unless there are n of them.
    pub fn blossom_barycentric(&self, arguments: &[[C; 3]]) -> Result<Point<C>, CurveError> {
        if arguments.len() != self.degree {
            return Err(CurveError::Arguments { expected: self.degree, given: arguments.len() });
        }
        let mut level = self.points.clone();
        for (argument, left) in arguments.iter().zip((1..=self.degree).rev()) {
            level = put(&level, left, argument);
        }
        Ok(level.swap_remove(0))
    }

    fn coordinates(&self, arguments: &[PointArgument<C>]) -> Result<Vec<[C; 3]>, CurveError> {
        arguments.iter().map(|argument| self.triangle.coordinates(argument)).collect()
    }

    /// f(p_1, …, p_n) for points and vectors of the parameter plane.
    ///
    /// # Errors
    /// [`CurveError::Arguments`], [`CurveError::DimensionsOf`] for an argument outside of the plane.
    pub fn blossom(&self, arguments: &[PointArgument<C>]) -> Result<PolarValue<C>, CurveError> {
        let value = self.blossom_barycentric(&self.coordinates(arguments)?)?;
        Ok(PolarValue::of(value, arguments))
    }

    /// The surface point at p, inside of the triangle or outside.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless p is in the plane.
    pub fn value(&self, p: &[C]) -> Result<Point<C>, CurveError> {
        let coordinates = self.triangle.barycentric(p)?;
        self.blossom_barycentric(&vec![coordinates; self.degree])
    }

    /// All levels of de Casteljau's algorithm at p: entry (i, j, k) of level r, in the order of
    /// [`indices`], is f(p^r, a^i, b^j, c^k).
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless p is in the plane.
    pub fn tableau(&self, p: &[C]) -> Result<Vec<Vec<Point<C>>>, CurveError> {
        let argument = self.triangle.barycentric(p)?;
        let mut levels = vec![self.points.clone()];
        for left in (1..=self.degree).rev() {
            let next = put(&levels[levels.len() - 1], left, &argument);
            levels.push(next);
        }
        Ok(levels)
    }

    /// The three patches over (p, b, c), (a, p, c) and (a, b, p), all from one tableau.
    ///
    /// # Errors
    /// [`CurveError::Degenerate`] if p lies on an edge, [`CurveError::DimensionsOf`].
    pub fn subdivide(&self, p: &[C]) -> Result<[Self; 3], CurveError> {
        let levels = self.tableau(p)?;
        let piece = |corner: usize| -> Result<Self, CurveError> {
            let mut corners = self.triangle.corners().clone();
            corners[corner] = p.into();
            let point = |index: [usize; 3]| {
                let [_, mut j, mut k] = index;
                // p stands in for that corner, which is then not among the others
                match corner {
                    1 => j = 0,
                    2 => k = 0,
                    _ => {}
                }
                levels[index[corner]][place(j, k)].clone()
            };
            let points = indices(self.degree).into_iter().map(point).collect();
            Ok(TrianglePatch { points, degree: self.degree, triangle: Triangle::new(corners)? })
        };
        Ok([piece(0)?, piece(1)?, piece(2)?])
    }

    /// The same surface over another triangle, by its polar values.
    pub fn part(&self, triangle: Triangle<C>) -> Self {
        let inside = |corner: &Point<C>| {
            self.triangle.barycentric(corner).expect("corners of a triangle lie in the plane")
        };
        let [p, q, r] = triangle.corners().each_ref().map(inside);
        let points = values(&self.points, self.degree, [&p, &q, &r]);
        TrianglePatch { points, degree: self.degree, triangle }
    }

    /// f(p^i, q^j, r^k) in the order of [`indices`], for points and vectors.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] for an argument outside of the plane.
    pub fn polar_values(&self, frame: &[PointArgument<C>; 3]) -> Result<Vec<Point<C>>, CurveError> {
        let [p, q, r] = frame;
        let coordinates = [p, q, r].map(|argument| self.triangle.coordinates(argument));
        let [p, q, r] = coordinates;
        Ok(values(&self.points, self.degree, [&p?, &q?, &r?]))
    }

    /// The same surface of degree n + by:
    /// (n + 1) b'_{ijk} = i b_{i−1,j,k} + j b_{i,j−1,k} + k b_{i,j,k−1} for each step.
    pub fn elevate(&self, by: usize) -> Self {
        let size = (self.degree as u64).saturating_add(by as u64).saturating_add(2);
        budget::charge_terms(size.saturating_mul(size) / 2);
        let mut points = self.points.clone();
        for degree in self.degree + 1..=self.degree + by {
            let mix = |index: [usize; 3]| {
                budget::step();
                let share = |count: usize| C::from_rational(&Rational::new(count.into(), degree.into()));
                let [i, j, k] = index;
                let below = [
                    (i > 0).then(|| (share(i), place(j, k))),
                    (j > 0).then(|| (share(j), place(j.wrapping_sub(1), k))),
                    (k > 0).then(|| (share(k), place(j, k.wrapping_sub(1)))),
                ];
                let terms = below.iter().flatten().map(|(weight, at)| (weight, &points[*at]));
                combination(self.dimension(), terms).from_origin()
            };
            points = indices(degree).into_iter().map(mix).collect();
        }
        self.with_points(points, self.degree + by)
    }

    /// The surface with the degree lowered by one, if that is possible.
    fn reduced_once(&self) -> Option<Self> {
        let n = self.degree;
        let lower_degree = n.checked_sub(1)?;
        let mut lower: Vec<Point<C>> = Vec::with_capacity(self.points.len() - n);
        for (at, [i, j, k]) in indices(n).into_iter().enumerate() {
            budget::step();
            // rest = n b_{ijk} − j c_{i,j−1,k} − k c_{i,j,k−1} is i c_{i−1,j,k}, so 0 for i = 0
            let mut rest = self.points[at].position() * &small(n);
            let mut take = |count: usize, from: usize| {
                let factor = small::<C>(count);
                rest.iter_mut().zip(&lower[from]).for_each(|(x, y)| *x -= factor.times(y));
            };
            if j > 0 {
                take(j, place(j - 1, k));
            }
            if k > 0 {
                take(k, place(j, k - 1));
            }
            if i > 0 {
                let share = C::from_rational(&Rational::new(Int::ONE, i.into()));
                lower.push((rest * &share).from_origin());
            } else if !rest.is_zero() {
                return None;
            }
        }
        Some(self.with_points(lower, lower_degree))
    }

    /// The same surface of degree n − by, exactly.
    ///
    /// # Errors
    /// [`CurveError::NotReducible`] with the smallest degree that is possible.
    pub fn reduce(&self, by: usize) -> Result<Self, CurveError> {
        let mut patch = self.clone();
        for _ in 0..by {
            match patch.reduced_once() {
                Some(lower) => patch = lower,
                None => {
                    return Err(CurveError::NotReducible { degree: self.degree, exact: patch.degree, by });
                }
            }
        }
        Ok(patch)
    }

    /// The derivative in the given directions v_1, …, v_k of the parameter plane, of degree n − k:
    /// n!/(n−k)! f(…, v̂_1, …, v̂_k); zero of degree 0 if k > n.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] for a direction outside of the plane.
    pub fn derivative(&self, directions: &[Vector<C>]) -> Result<Self, CurveError> {
        let vectors: Vec<_> = directions.iter().map(|v| Argument::Vector(v.to_vec())).collect();
        let vectors = self.coordinates(&vectors)?;
        if vectors.len() > self.degree {
            return Ok(self.with_points(vec![Vector::zero(self.dimension()).from_origin()], 0));
        }
        let mut points = self.points.clone();
        let mut degree = self.degree;
        for vector in &vectors {
            points = put(&points, degree, vector);
            degree -= 1;
        }
        let factor = C::from_rational(&falling(self.degree, vectors.len()));
        let points = points.iter().map(|p| (p.position() * &factor).from_origin()).collect();
        Ok(self.with_points(points, degree))
    }

    /// ∂^{r+s}/∂x^r ∂y^s with x, y the coordinates of the parameter plane.
    pub fn partial_derivative(&self, r: usize, s: usize) -> Self {
        // one more than the degree gives zero already
        let most = self.degree + 1;
        let mut directions = vec![Vector::from([C::one(), C::zero()]); r.min(most)];
        directions.extend(vec![Vector::from([C::zero(), C::one()]); s.min(most)]);
        self.derivative(&directions).expect("the unit vectors lie in the plane")
    }

    /// The control points of the edge opposite to a corner: from b to c, from a to c, from a to b.
    pub fn boundary(&self, opposite: Corner) -> Vec<Point<C>> {
        let n = self.degree;
        let at = |s: usize| match opposite {
            Corner::A => place(n - s, s),
            Corner::B => place(0, s),
            Corner::C => place(s, 0),
        };
        (0..=n).map(|s| self.points[at(s)].clone()).collect()
    }

    /// The normal ∂f/∂x × ∂f/∂y as a polynomial: a patch of vectors of degree 2n − 2.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless the dimension is 3.
    pub fn normal(&self) -> Result<Self, CurveError> {
        if self.dimension() != 3 {
            return Err(CurveError::DimensionsOf { left: self.dimension(), right: 3 });
        }
        let (along_x, along_y) = (self.partial_derivative(1, 0), self.partial_derivative(0, 1));
        let degree = along_x.degree;
        let parts = |patch: &Self| (0..3).map(|k| patch.coordinate(k)).collect::<Vec<_>>();
        let times = |f: &Vec<C>, g: &Vec<C>| product((f, degree), (g, degree));
        let minus = |f: Vec<C>, g: Vec<C>| f.iter().zip(&g).map(|(x, y)| x.minus(y)).collect();
        let normal = polygon::cross(&parts(&along_x), &parts(&along_y), times, minus);
        let point = |at: usize| normal.iter().map(|coordinate| coordinate[at].clone()).collect();
        Ok(self.with_points((0..normal[0].len()).map(point).collect(), 2 * degree))
    }

    /// The Bernstein coefficients of one coordinate.
    pub(super) fn coordinate(&self, k: usize) -> Vec<C> {
        self.points.iter().map(|point| point[k].clone()).collect()
    }

    /// The mean of the surface points over the triangle: the mean of the control points.
    pub fn mean(&self) -> Point<C> {
        let share = C::from_rational(&Rational::new(Int::ONE, self.points.len().into()));
        combination(self.dimension(), self.points.iter().map(|point| (&share, point))).from_origin()
    }

    /// ∬ f dx dy over the triangle: its area times the mean of the control points, of position vectors. The area has
    /// a sign, positive for corners in counter-clockwise order.
    pub fn integral(&self) -> Vector<C> {
        self.mean().position() * &self.triangle.area()
    }

    /// The same surface with the corners in another order: the new first corner is the
    /// `order[0]`-th one. `None` unless `order` is a permutation of 0, 1, 2.
    pub fn permuted(&self, order: [usize; 3]) -> Option<Self> {
        let mut sorted = order;
        sorted.sort_unstable();
        if sorted != [0, 1, 2] {
            return None;
        }
        let corners = order.map(|at| self.triangle.corners()[at].clone());
        let point = |index: [usize; 3]| {
            let mut old = [0; 3];
            order.iter().zip(index).for_each(|(&at, count)| old[at] = count);
            self.points[place(old[1], old[2])].clone()
        };
        let triangle = Triangle::new(corners).ok()?;
        let points = indices(self.degree).into_iter().map(point).collect();
        Some(TrianglePatch { points, degree: self.degree, triangle })
    }

    /// The coefficients of f(x, y) = Σ c_{rs} x^r y^s, r + s ≤ n, with the exponents.
    pub fn power_coefficients(&self) -> Vec<([usize; 2], Point<C>)> {
        let (zero, one) = (C::zero, C::one);
        let frame = [
            Argument::Vector(vec![one(), zero()]),
            Argument::Vector(vec![zero(), one()]),
            Argument::Point(vec![zero(), zero()]),
        ];
        let values = self.polar_values(&frame).expect("the frame lies in the plane");
        let weigh = |([i, j, k], point): ([usize; 3], Point<C>)| {
            let count = Rational::from_integer(multinomial(&[i, j, k]));
            ([i, j], point.iter().map(|x| x.scaled(&count)).collect())
        };
        indices(self.degree).into_iter().zip(values).map(weigh).collect()
    }

    /// The polar form of each coordinate.
    pub fn polar_forms(&self) -> Vec<TotalDegreePolarForm<C>> {
        let terms = self.power_coefficients();
        let form = |at: usize| {
            let terms = terms.iter().map(|([r, s], c)| (vec![*r as u32, *s as u32], c[at].clone()));
            TotalDegreePolarForm::new(2, self.degree, terms).expect("exponents with sum at most the degree")
        };
        (0..self.dimension()).map(form).collect()
    }

    /// The patch with these polar forms of its coordinates.
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`] if there are none, [`CurveError::Degrees`],
    /// [`CurveError::DimensionsOf`] unless their arguments are points of the plane.
    pub fn from_polar_forms(
        forms: &[TotalDegreePolarForm<C>],
        triangle: Triangle<C>,
    ) -> Result<Self, CurveError> {
        let Some(first) = forms.first() else {
            return Err(CurveError::TooFewPoints { needed: 1, given: 0 });
        };
        let degree = first.degree();
        let mut coordinates = Vec::with_capacity(forms.len());
        for form in forms {
            if form.degree() != degree {
                return Err(CurveError::Degrees { left: degree, right: form.degree() });
            }
            let values = form
                .bezier_points(&triangle.corners().clone().map(Vec::from))
                .map_err(|_| CurveError::DimensionsOf { left: 2, right: form.dimension() })?;
            coordinates.push(values);
        }
        let point = |at: usize| coordinates.iter().map(|values| values[at].1.clone()).collect();
        let points = (0..coordinates[0].len()).map(point).collect();
        Ok(TrianglePatch { points, degree, triangle })
    }
}

/// A count as an element of the field.
fn small<C: Ring>(count: usize) -> C {
    C::from_rational(&Rational::from_integer(count.into()))
}

/// The Bernstein coefficients of a product, from those of the factors with their degrees:
/// (F G)_I = Σ_{J+K=I} C(m; J) C(n; K) / C(m+n; I) F_J G_K.
pub(super) fn product<C: Ring>((f, m): (&[C], usize), (g, n): (&[C], usize)) -> Vec<C> {
    let weigh = |list: &[C], degree: usize| -> Vec<C> {
        let weighed = |(index, x): ([usize; 3], &C)| x.scaled(&Rational::from_integer(multinomial(&index)));
        indices(degree).into_iter().zip(list).map(weighed).collect()
    };
    let (left, right) = (weigh(f, m), weigh(g, n));
    let mut total = vec![C::zero(); (m + n + 1) * (m + n + 2) / 2];
    for ([_, j, k], x) in indices(m).into_iter().zip(&left) {
        budget::steps(right.len() as u32);
        for ([_, q, r], y) in indices(n).into_iter().zip(&right) {
            total[place(j + q, k + r)] += x.times(y);
        }
    }
    let unweigh = |(index, x): ([usize; 3], &C)| x.scaled(&Rational::new(Int::ONE, multinomial(&index)));
    indices(m + n).into_iter().zip(&total).map(unweigh).collect()
}

#[cfg(test)]
pub(in crate::math::curve) mod tests;
