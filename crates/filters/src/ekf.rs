//! The extended Kalman filter (sister volume, chapter 7), in Thrun's letters.

use crate::covariance::{finite, mend};
use crate::error::{Error, Quantity};
use crate::linear;
use crate::manifold::State;
use crate::model::{MeasurementModel, MotionModel};
use crate::update::Update;
use nalgebra::{Const, SMatrix, SVector};

/// An extended Kalman filter that holds its belief.
///
/// # Example
/// ```
/// use filters::Ekf;
/// use nalgebra::{Matrix1, Vector1};
/// let doubled = |x: &Vector1<f64>, u: &Vector1<f64>| 2.0 * x + u;
/// let mut ekf = Ekf { x: Vector1::new(1.0), p: Matrix1::new(1.0) };
/// ekf.predict(&doubled, &Vector1::new(0.5), &Matrix1::new(0.25))?; // its Jacobian, 2, is found by differences
/// assert!((ekf.x[0] - 2.5).abs() < 1e-15 && (ekf.p[0] - 4.25).abs() < 1e-9);
/// # Ok::<(), filters::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ekf<X, const N: usize> {
    /// The mean μ.
    pub x: X,
    /// The covariance Σ, n×n, of the error in the coordinates of ⊞ at the mean.
    pub p: SMatrix<f64, N, N>,
}

impl<X: State<N>, const N: usize> Ekf<X, N> {
    /// μ̄ = f(μ, u), Σ̄ = A Σ Aᵀ + R, with A at the old mean.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; the belief is then unchanged.
    pub fn predict<const U: usize>(
        &mut self,
        model: &impl MotionModel<X, N, U>,
        u: &SVector<f64, U>,
        r: &SMatrix<f64, N, N>,
    ) -> Result<(), Error> {
        let (x, a) = model.linearized(&self.x, u);
        if !x.is_finite() {
            return Err(Error::NotFinite(Quantity::PredictedMean));
        }
        let mut p = model.transported(&a, &self.p, r);
        mend(&mut p)?;
        *self = Self { x, p };
        Ok(())
    }

    /// Corrects the belief with the reading `z` of feature `j`, () where the sensor sees none, of noise covariance Q;
    /// the covariance in Joseph's form.
    ///
    /// # Errors
    /// [`Error::InnovationNotPositiveDefinite`], [`Error::NotFinite`], or what the model answers; the belief is then
    /// unchanged.
    pub fn update<const M: usize, J: Copy>(
        &mut self,
        model: &impl MeasurementModel<X, N, M, J>,
        z: &SVector<f64, M>,
        j: J,
        q: &SMatrix<f64, M, M>,
    ) -> Result<Update<Const<N>, Const<M>>, Error> {
        let (expected, c) = model.linearized(&self.x, j)?;
        let innovation = finite(model.residual(z, &expected), Quantity::Innovation)?;
        self.correct(&innovation, &c, q)
    }

    /// Corrects the belief by an innovation and its Jacobian, both already at hand.
    ///
    /// # Errors
    /// As [`Ekf::update`].
    pub fn correct<const M: usize>(
        &mut self,
        innovation: &SVector<f64, M>,
        c: &SMatrix<f64, M, N>,
        q: &SMatrix<f64, M, M>,
    ) -> Result<Update<Const<N>, Const<M>>, Error> {
        let gain = linear::gain(&self.p, c, q)?;
        let x = self.x.boxplus(&(gain.k * innovation));
        if !x.is_finite() {
            return Err(Error::NotFinite(Quantity::Mean));
        }
        *self = Self { x, p: gain.p };
        let d2 = gain.d2(innovation);
        Ok(Update { innovation: *innovation, s: gain.s, k: gain.k, d2, doubted: gain.doubted })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gaussian::Gaussian;
    use crate::kalman::Kf;
    use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};

    struct Rail;

    impl MotionModel<Vector2<f64>, 2, 1> for Rail {
        fn f(&self, x: &Vector2<f64>, u: &SVector<f64, 1>) -> Vector2<f64> {
            Vector2::new(x[0] + 0.5 * x[1], x[1] + 0.5 * u[0])
        }

        fn jacobian(&self, _: &Vector2<f64>, _: &SVector<f64, 1>) -> Matrix2<f64> {
            Matrix2::new(1.0, 0.5, 0.0, 1.0)
        }
    }

    impl MeasurementModel<Vector2<f64>, 2, 1> for Rail {
        fn h(&self, x: &Vector2<f64>, _: usize) -> Result<SVector<f64, 1>, Error> {
            Ok(Vector1::new(x[1]))
        }

        fn jacobian(&self, _: &Vector2<f64>, _: usize) -> Result<SMatrix<f64, 1, 2>, Error> {
            Ok(RowVector2::new(0.0, 1.0))
        }
    }

    #[test]
    fn on_a_linear_system_the_ekf_is_the_kalman_filter() {
        let belief = Gaussian { x: Vector2::new(2.0, 4.0), p: Matrix2::new(1.0, 0.0, 0.0, 2.0) };
        let (r, q) = (Matrix2::new(0.2, 0.05, 0.05, 0.1), Matrix1::new(0.5));
        let mut ekf = Ekf { x: belief.x, p: belief.p };
        let mut kf = Kf::from(belief);
        for z in [2.7, 2.0, 2.3] {
            let (u, z) = (Vector1::new(0.3), Vector1::new(z));
            ekf.predict(&Rail, &u, &r).expect("finite");
            kf.predict(&Matrix2::new(1.0, 0.5, 0.0, 1.0), &r, Some((&Vector2::new(0.0, 0.5), &u))).expect("finite");
            ekf.update(&Rail, &z, 0, &q).expect("positive definite");
            kf.update(&z, &RowVector2::new(0.0, 1.0), &q).expect("positive definite");
            assert_eq!((ekf.x, ekf.p), (kf.belief().x, kf.belief().p));
        }
    }

    #[test]
    fn a_refused_step_leaves_the_belief() {
        let before = Ekf { x: Vector2::new(2.0, 4.0), p: Matrix2::identity() };
        let mut ekf = before;
        assert!(ekf.predict(&Rail, &Vector1::new(f64::NAN), &Matrix2::zeros()).is_err());
        assert!(ekf.predict(&Rail, &Vector1::new(0.0), &Matrix2::from_element(f64::INFINITY)).is_err());
        assert!(ekf.update(&Rail, &Vector1::new(f64::NAN), 0, &Matrix1::new(1.0)).is_err());
        assert!(ekf.update(&Rail, &Vector1::new(0.0), 0, &Matrix1::new(-1.0)).is_err());
        assert_eq!(ekf, before);
    }
}
