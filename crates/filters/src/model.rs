//! How a state moves and what a sensor reads of it, for the nonlinear filters (sister volume, chapter 7).

use crate::error::Error;
use crate::linear;
use crate::manifold::State;
use nalgebra::{SMatrix, SVector};

/// How the state moves: x⁺ = f(x, u).
pub trait MotionModel<X: State<N>, const N: usize, const U: usize> {
    /// f(x, u).
    fn f(&self, x: &X, u: &SVector<f64, U>) -> X;

    /// A = ∂f/∂x at (x, u), n×n, in the coordinates of ⊞.
    fn jacobian(&self, x: &X, u: &SVector<f64, U>) -> SMatrix<f64, N, N>;

    /// Both, for a model whose two share their work.
    fn linearized(&self, x: &X, u: &SVector<f64, U>) -> (X, SMatrix<f64, N, N>) {
        (self.f(x, u), self.jacobian(x, u))
    }

    /// A Σ Aᵀ + R for an A that [`MotionModel::jacobian`] answered: a model that knows which of its entries are ones
    /// and zeros may leave their products out.
    #[inline]
    fn transported(
        &self,
        a: &SMatrix<f64, N, N>,
        p: &SMatrix<f64, N, N>,
        r: &SMatrix<f64, N, N>,
    ) -> SMatrix<f64, N, N> {
        linear::congruence(a, p, r)
    }
}

/// What a sensor reads of feature `j`: z = h(x, j) + noise.
pub trait MeasurementModel<X: State<N>, const N: usize, const M: usize> {
    /// h(x, j).
    ///
    /// # Errors
    /// [`Error::AtFeature`] where h does not exist, [`Error::OutOfRange`] when there is no feature `j`.
    fn h(&self, x: &X, j: usize) -> Result<SVector<f64, M>, Error>;

    /// C = ∂h/∂x at x, m×n, in the coordinates of ⊞.
    ///
    /// # Errors
    /// As [`MeasurementModel::h`].
    fn jacobian(&self, x: &X, j: usize) -> Result<SMatrix<f64, M, N>, Error>;

    /// Both, for a sensor whose two share their work.
    ///
    /// # Errors
    /// As [`MeasurementModel::h`].
    fn linearized(&self, x: &X, j: usize) -> Result<(SVector<f64, M>, SMatrix<f64, M, N>), Error> {
        Ok((self.h(x, j)?, self.jacobian(x, j)?))
    }

    /// z − ẑ, wrapped where a component is an angle.
    fn residual(&self, z: &SVector<f64, M>, expected: &SVector<f64, M>) -> SVector<f64, M> {
        z - expected
    }
}
