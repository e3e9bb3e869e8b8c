//! The unscented Kalman filter (Julier and Uhlmann 1997; van der Merwe 2004), in Thrun's letters.

mod sigma;

pub use sigma::{Image, SigmaPoints, Spread};

use crate::error::{Error, Quantity};
use crate::manifold::State;
use crate::model::{MeasurementModel, MotionModel};
use crate::update::Update;
use nalgebra::{Const, SMatrix, SVector};

/// An unscented Kalman filter that holds its belief.
///
/// # Example
/// ```
/// use filters::ukf::{SigmaPoints, Ukf};
/// use nalgebra::{Matrix1, Vector1};
/// let square = |x: &Vector1<f64>| Vector1::new(x[0] * x[0]);
/// let mut ukf = Ukf { x: Vector1::new(3.0), p: Matrix1::new(0.25), points: SigmaPoints::default() };
/// let update = ukf.update(&square, &Vector1::new(10.0), (), &Matrix1::new(0.5))?;
/// assert!((update.innovation[0] - 0.75).abs() < 1e-6); // 10 − E x², with E x² = μ² + σ²
/// # Ok::<(), filters::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ukf<X, const N: usize> {
    /// The mean μ.
    pub x: X,
    /// The covariance Σ, n×n, in the coordinates of ⊞ at the mean.
    pub p: SMatrix<f64, N, N>,
    /// The sigma points in use.
    pub points: SigmaPoints,
}

impl<X: State<N>, const N: usize> Ukf<X, N> {
    /// The belief after x⁺ = f(x, u) + noise of covariance R.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::OutOfRange`] when Σ is not positive definite or the points cannot be placed;
    /// the belief is then unchanged.
    pub fn predict<const U: usize>(
        &mut self,
        model: &impl MotionModel<X, N, U>,
        u: &SVector<f64, U>,
        r: &SMatrix<f64, N, N>,
    ) -> Result<(), Error> {
        let spread = self.points.spread(&self.p)?;
        let centre = model.f(&self.x, u);
        let moved = spread.image(Const::<N>, |d| Ok(model.f(&self.x.boxplus(d), u).boxminus(&centre)))?;
        let x = centre.boxplus(&moved.mean);
        if !x.is_finite() {
            return Err(Error::NotFinite(Quantity::PredictedMean));
        }
        (self.p, self.x) = (spread.predicted_covariance(&moved, r)?, x);
        Ok(())
    }

    /// Corrects the belief with the reading `z` of feature `j`, () where the sensor sees none, of noise covariance Q.
    ///
    /// # Errors
    /// As [`Ukf::predict`], [`Error::InnovationNotPositiveDefinite`], or what the model answers; the belief is then
    /// unchanged.
    pub fn update<const M: usize, J: Copy>(
        &mut self,
        model: &impl MeasurementModel<X, N, M, J>,
        z: &SVector<f64, M>,
        j: J,
        q: &SMatrix<f64, M, M>,
    ) -> Result<Update<Const<N>, Const<M>>, Error> {
        let spread = self.points.spread(&self.p)?;
        let centre = model.h(&self.x, j)?;
        let expected = |d: &SVector<f64, N>| Ok(model.residual(&model.h(&self.x.boxplus(d), j)?, &centre));
        let seen = spread.image(Const::<M>, expected)?;
        let innovation = model.residual(z, &(centre + seen.mean));
        let (step, p, update) = spread.correction(&self.p, &seen, innovation, q)?;
        let x = self.x.boxplus(&step);
        if !x.is_finite() {
            return Err(Error::NotFinite(Quantity::Mean));
        }
        (self.x, self.p) = (x, p);
        Ok(update)
    }
}

#[cfg(test)]
mod tests;
