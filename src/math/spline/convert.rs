//! Matrices between control points, Bézier points and powers.
//!
//! All maps are linear in the control points, so their matrices are the images of unit points.

use nalgebra::DMatrix;

use super::{BSpline, KnotVector, SplineError};
use crate::budget;
use crate::math::curve::Point;
use crate::math::ring::Field;

impl<C: Field> KnotVector<C> {
    /// The spline whose control points are the unit vectors of an m-dimensional space.
    fn unit_spline(&self) -> Result<BSpline<C>, SplineError> {
        let m = self.count();
        budget::charge_terms((m as u64).saturating_mul(m as u64));
        let unit =
            |i: usize| -> Point<C> { (0..m).map(|k| if k == i { C::one() } else { C::zero() }).collect() };
        BSpline::new(self.clone(), (0..m).map(unit).collect())
    }

    /// The matrix from the n + 1 control points that matter on the interval [t_j, t_{j+1}] to the Bézier
    /// points of the piece there: its columns are the Bézier ordinates of N_{j−n}, …, N_j (the Bézier
    /// extraction of finite elements). Cost: n³/3 affine combinations of n + 1 coordinates.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`] unless j is one of [`KnotVector::spans`].
    ///
    /// ```
    /// use nalgebra::DMatrix;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::KnotVector;
    /// let uniform = KnotVector::uniform(2, 3, &z(0), &z(1))?.extraction(2)?;
    /// let rows = [[q(1, 2), q(1, 2), z(0)], [z(0), z(1), z(0)], [z(0), q(1, 2), q(1, 2)]];
    /// assert_eq!(uniform, DMatrix::from_row_slice(3, 3, &rows.concat()));
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn extraction(&self, span: usize) -> Result<DMatrix<C>, SplineError> {
        let n = self.degree();
        if !self.spans().contains(&span) {
            return Err(SplineError::NoDomain);
        }
        let window = KnotVector::new(n, self.knots()[span - n..=span + n + 1].to_vec())?;
        let piece = window.unit_spline()?.bezier_piece(n)?;
        Ok(DMatrix::from_fn(n + 1, n + 1, |i, j| piece.points()[i][j].clone()))
    }

    /// The matrix M from the control points to the Bézier points of all pieces: n + 1 rows for
    /// each knot interval of the domain (common points twice), one column for each control point.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`].
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::KnotVector;
    /// let knots = KnotVector::clamped(2, &[z(1)], &Interval::new(z(0), z(2))?)?;
    /// let m = knots.to_bezier_matrix()?;
    /// assert_eq!((m.nrows(), m.ncols()), (6, 4));
    /// // the point where the pieces meet is the mean of two control points
    /// assert_eq!(m.row(2).iter().cloned().collect::<Vec<_>>(), [z(0), q(1, 2), q(1, 2), z(0)]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn to_bezier_matrix(&self) -> Result<DMatrix<C>, SplineError> {
        self.interval()?;
        let (n, spans) = (self.degree(), self.spans());
        let (rows, columns) = (spans.len() * (n + 1), self.count());
        budget::charge_terms((rows as u64).saturating_mul(columns as u64));
        let mut matrix = DMatrix::zeros(rows, columns);
        for (k, &span) in spans.iter().enumerate() {
            matrix.view_mut((k * (n + 1), span - n), (n + 1, n + 1)).copy_from(&self.extraction(span)?);
        }
        Ok(matrix)
    }

    /// The matrix from the n + 1 control points that matter on the interval [t_j, t_{j+1}] to the
    /// power coefficients of the piece there, in t.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`] unless j is one of [`KnotVector::spans`].
    pub fn power_matrix(&self, span: usize) -> Result<DMatrix<C>, SplineError> {
        let n = self.degree();
        let power = self.unit_spline()?.bezier_piece(span)?.power();
        Ok(DMatrix::from_fn(n + 1, n + 1, |i, j| power[span - n + j][i].clone()))
    }
}
