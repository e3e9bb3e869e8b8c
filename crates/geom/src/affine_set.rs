//! The affine set Ω = {x : Hx = y} of states that reproduce an output, and the points of it nearest to a prediction
//! (Choset §8.2.2 and §8.2.3).

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};
use numerics::{MIN_PIVOT, Spd};

/// Ω = {x ∈ ℝⁿ : Hx = y}, H being m×n with full row rank. Sizes may be fixed or known at run time only.
///
/// # Example
/// ```
/// use geom::AffineSet;
/// use nalgebra::{Matrix2, RowVector2, Vector1, Vector2};
/// // A sensor of the velocity reads 2.7 m/s; the prediction is 4 m and 4 m/s.
/// let omega = AffineSet { h: RowVector2::new(0.0, 1.0), y: Vector1::new(2.7) };
/// let (p, x) = (Matrix2::new(1.7, 1.05, 1.05, 2.1), Vector2::new(4.0, 4.0));
/// assert_eq!(omega.euclidean_foot(&x), Some(Vector2::new(4.0, 2.7)));
/// // Position and velocity are correlated, so the most likely state moves the position too.
/// assert!((omega.mahalanobis_foot(&p, &x).unwrap() - Vector2::new(3.35, 2.7)).norm() < 1e-14);
/// ```
pub struct AffineSet<M: Dim, N: Dim>
where
    DefaultAllocator: Allocator<M, N> + Allocator<M>,
{
    /// H, m×n.
    pub h: OMatrix<f64, M, N>,
    /// y, the output that the states of Ω reproduce.
    pub y: OVector<f64, M>,
}

impl<M: Dim, N: Dim> AffineSet<M, N>
where
    DefaultAllocator:
        Allocator<M, N> + Allocator<N, M> + Allocator<N, N> + Allocator<M, M> + Allocator<M> + Allocator<N>,
{
    /// y − Hx: how far `x` is from Ω, in output units.
    pub fn residual(&self, x: &OVector<f64, N>) -> OVector<f64, M> {
        &self.y - &self.h * x
    }

    /// The point of Ω nearest to `x` in the Euclidean metric, x + Hᵀ(HHᵀ)⁻¹(y − Hx).
    ///
    /// `None` when H has not full row rank (to eight digits), or a number is not finite.
    pub fn euclidean_foot(&self, x: &OVector<f64, N>) -> Option<OVector<f64, N>> {
        self.foot(&self.h.transpose(), x)
    }

    /// The point of Ω nearest to `x` in the Mahalanobis metric of the covariance `p`, x + PHᵀ(HPHᵀ)⁻¹(y − Hx): the most
    /// likely state of N(x, P) in Ω (eq. 8.21).
    ///
    /// `p` may be singular as long as HPHᵀ is not; `None` when that is singular (to eight digits), or a number is not
    /// finite.
    pub fn mahalanobis_foot(&self, p: &OMatrix<f64, N, N>, x: &OVector<f64, N>) -> Option<OVector<f64, N>> {
        self.foot(&(p * self.h.transpose()), x)
    }

    /// x + D(HD)⁻¹(y − Hx): the point of Ω reached from `x` along the columns of D.
    fn foot(&self, directions: &OMatrix<f64, N, M>, x: &OVector<f64, N>) -> Option<OVector<f64, N>> {
        let spd = Spd::new(&self.h * directions).filter(|s| s.pivot() >= MIN_PIVOT)?;
        let foot = x + directions * spd.solve(&self.residual(x));
        foot.iter().all(|e| e.is_finite()).then_some(foot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Const, Matrix2, Matrix3, RowVector2, Vector1, Vector2, Vector3, dmatrix, dvector};

    fn rail() -> AffineSet<Const<1>, Const<2>> {
        AffineSet { h: RowVector2::new(0.0, 1.0), y: Vector1::new(2.7) }
    }

    #[test]
    fn the_euclidean_foot_leaves_the_unmeasured_direction_alone() {
        let foot = rail().euclidean_foot(&Vector2::new(4.0, 4.0)).expect("H has full rank");
        assert_eq!(foot, Vector2::new(4.0, 2.7));
    }

    #[test]
    fn the_mahalanobis_foot_moves_the_correlated_component_too() {
        let p = Matrix2::new(1.7, 1.05, 1.05, 2.1);
        let foot = rail().mahalanobis_foot(&p, &Vector2::new(4.0, 4.0)).expect("HPHᵀ is positive");
        assert!((foot - Vector2::new(3.35, 2.7)).norm() < 1e-15);
    }

    #[test]
    fn both_feet_lie_in_omega_and_each_is_orthogonal_in_its_own_metric() {
        let omega = AffineSet { h: dmatrix![1.0, 2.0, -1.0; 0.5, 0.0, 3.0], y: dvector![1.0, -2.0] };
        let l = dmatrix![1.0, 0.0, 0.0; 0.4, 0.8, 0.0; -0.3, 0.2, 1.5];
        let p = &l * l.transpose();
        let x = dvector![0.3, -1.2, 2.0];
        let null = Vector3::new(1.0, 2.0, -1.0).cross(&Vector3::new(0.5, 0.0, 3.0));
        let e = omega.euclidean_foot(&x).expect("full rank");
        let m = omega.mahalanobis_foot(&p, &x).expect("full rank");
        assert!(omega.residual(&e).norm() < 1e-14 && omega.residual(&m).norm() < 1e-14);
        let step = |foot: &nalgebra::DVector<f64>| Vector3::from_iterator((foot - &x).iter().copied());
        let inverse = Matrix3::from_iterator(p.iter().copied()).try_inverse().expect("positive definite");
        assert!(null.dot(&step(&e)).abs() < 1e-13);
        assert!(null.dot(&(inverse * step(&m))).abs() < 1e-13);
        assert!(null.dot(&step(&m)).abs() > 1e-2, "the two metrics differ here");
    }

    #[test]
    fn the_feet_meet_when_p_is_a_multiple_of_the_identity() {
        let x = Vector2::new(-1.0, 7.0);
        let omega = AffineSet { h: RowVector2::new(0.6, -0.8), y: Vector1::new(1.0) };
        let m = omega.mahalanobis_foot(&(3.0 * Matrix2::identity()), &x).expect("positive");
        assert!((m - omega.euclidean_foot(&x).expect("full rank")).norm() < 1e-15);
    }

    #[test]
    fn without_full_row_rank_or_with_a_singular_hph_there_is_no_foot() {
        let twice = AffineSet { h: dmatrix![1.0, 0.0; 1.0, 0.0], y: dvector![1.0, 1.0] };
        assert!(twice.euclidean_foot(&dvector![0.0, 0.0]).is_none());
        let known = Matrix2::new(1.0, 0.0, 0.0, 0.0);
        assert!(rail().mahalanobis_foot(&known, &Vector2::zeros()).is_none());
        let almost = AffineSet { h: dmatrix![1.0, 0.0; 1.0, 1e-6], y: dvector![1.0, 1.0] };
        assert!(almost.euclidean_foot(&dvector![0.0, 0.0]).is_none());
    }

    #[test]
    fn an_overflowing_foot_is_none() {
        let omega = AffineSet { h: RowVector2::new(1e-150, 0.0), y: Vector1::new(1e308) };
        assert!(omega.euclidean_foot(&Vector2::zeros()).is_none());
    }
}
