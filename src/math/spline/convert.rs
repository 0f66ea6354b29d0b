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

    /// The matrix M from the control points to the Bézier points of all pieces: n + 1 rows for
    /// each knot interval of the domain (common points twice), one column for each control point.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`].
    ///
    /// ```
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::KnotVector;
    /// let knots = KnotVector::clamped(2, &z(0), &[z(1)], &z(2))?;
    /// let m = knots.to_bezier_matrix()?;
    /// assert_eq!((m.nrows(), m.ncols()), (6, 4));
    /// // the point where the pieces meet is the mean of two control points
    /// assert_eq!(m.row(2).iter().cloned().collect::<Vec<_>>(), [z(0), q(1, 2), q(1, 2), z(0)]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn to_bezier_matrix(&self) -> Result<DMatrix<C>, SplineError> {
        let pieces = self.unit_spline()?.bezier_pieces();
        let rows: Vec<Point<C>> = pieces.into_iter().flat_map(|piece| piece.points().to_vec()).collect();
        Ok(DMatrix::from_fn(rows.len(), self.count(), |i, j| rows[i][j].clone()))
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
