//! Linear time-invariant systems in Choset's letters (§8.2, App. J.5).

use crate::error::Error;
use crate::observability::{self, Observability};
use filters::Sizes;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DefaultAllocator, Dim, OMatrix};

/// What nalgebra must be able to store for a system of N states, U inputs and M outputs; it is so for all sizes.
pub trait SystemSizes<N: Dim, U: Dim, M: Dim>: Sizes<N, M> + Allocator<N, U> + Allocator<U> {}

impl<N: Dim, U: Dim, M: Dim> SystemSizes<N, U, M> for DefaultAllocator where
    Self: Sizes<N, M> + Allocator<N, U> + Allocator<U>
{
}

// ANCHOR: lti
/// The system x(k+1) = F x(k) + G u(k) + v(k), y(k) = H x(k) + w(k), with v ~ N(0, V) and w ~ N(0, W):
/// n states (`N`), m inputs (`U`) and p outputs (`M`).
#[derive(Clone, Debug, PartialEq)]
pub struct Lti<N: Dim, U: Dim, M: Dim>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    /// F, n×n: the dynamics. Thrun A.
    pub f: OMatrix<f64, N, N>,
    /// G, n×m: the input. Thrun B.
    pub g: OMatrix<f64, N, U>,
    /// H, p×n: the output, assumed of full row rank. Thrun C.
    pub h: OMatrix<f64, M, N>,
    /// V, n×n: process covariance. Thrun R.
    pub v: OMatrix<f64, N, N>,
    /// W, p×p: measurement covariance. Thrun Q.
    pub w: OMatrix<f64, M, M>,
}
// ANCHOR_END: lti

impl<N: Dim, U: Dim, M: Dim> Copy for Lti<N, U, M>
where
    DefaultAllocator: SystemSizes<N, U, M>,
    OMatrix<f64, N, N>: Copy,
    OMatrix<f64, N, U>: Copy,
    OMatrix<f64, M, N>: Copy,
    OMatrix<f64, M, M>: Copy,
{
}

impl<N: Dim, U: Dim, M: Dim> Lti<N, U, M>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    // ANCHOR: discretize
    /// The Euler discretization of ẋ = Ax + Bu, y = Cx with period `t` seconds (App. J.5): F = I + tA, G = tB, H = C.
    /// The noise covariances are those of one period.
    pub fn discretize(
        a: OMatrix<f64, N, N>,
        b: OMatrix<f64, N, U>,
        c: OMatrix<f64, M, N>,
        t: f64,
        v: OMatrix<f64, N, N>,
        w: OMatrix<f64, M, M>,
    ) -> Self {
        let n = a.shape_generic().0;
        Self { f: OMatrix::identity_generic(n, n) + a * t, g: b * t, h: c, v, w }
    }
    // ANCHOR_END: discretize

    // ANCHOR: observability
    /// Q = [H; HF; …; HF^{n−1}] (Theorem 8.2.2), np × n.
    pub fn observability_matrix(&self) -> DMatrix<f64> {
        observability::observability_matrix(&self.f, &self.h)
    }

    /// The rank of Q with its singular values and null directions; `tol` is relative to the largest singular value.
    ///
    /// # Errors
    /// As [`observability::analyze`].
    pub fn observability(&self, tol: f64) -> Result<Observability, Error> {
        observability::analyze(&self.observability_matrix(), tol)
    }

    /// Whether rank Q = n under the relative tolerance `tol`.
    ///
    /// # Errors
    /// As [`observability::analyze`].
    pub fn is_observable(&self, tol: f64) -> Result<bool, Error> {
        Ok(self.observability(tol)?.rank == self.f.nrows())
    }
    // ANCHOR_END: observability
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rail::dead_reckoning;
    use nalgebra::{Matrix2, RowVector2, Vector2};

    #[test]
    fn discretize_is_eulers_step() {
        let (sys, _) = dead_reckoning();
        let a = Matrix2::new(0.0, 1.0, 0.0, 0.0);
        let found = Lti::discretize(a, Vector2::new(0.0, 1.0), RowVector2::new(0.0, 1.0), 0.5, sys.v, sys.w);
        assert_eq!(found, sys);
    }

    #[test]
    fn the_velocity_sensor_does_not_see_the_position() {
        let (sys, _) = dead_reckoning();
        let seen = sys.observability(1e-9).expect("found");
        assert_eq!(seen.rank, 1);
        assert!((seen.nullspace[0][0] - 1.0).abs() < 1e-15);
        assert_eq!(sys.is_observable(1e-9), Ok(false));
        assert_eq!(Lti { h: RowVector2::new(1.0, 0.0), ..sys }.is_observable(1e-9), Ok(true));
        assert!(sys.is_observable(-1.0).is_err());
    }
}
