//! Sensors of the robot's own position, heading and speed.

use crate::scaled::HasPose;
use filters::MeasurementModel;
use geom::angle_diff;
use nalgebra::{SMatrix, SVector, Vector1, Vector2};

/// The position alone: h(x) = (x, y).
pub(crate) struct Fix;

impl<X: HasPose<N>, const N: usize> MeasurementModel<X, N, 2> for Fix {
    fn h(&self, x: &X, _: usize) -> Result<SVector<f64, 2>, filters::Error> {
        Ok(Vector2::new(x.pose().x(), x.pose().y()))
    }

    fn jacobian(&self, _: &X, _: usize) -> Result<SMatrix<f64, 2, N>, filters::Error> {
        Ok(SMatrix::identity())
    }
}

/// The heading alone: h(x) = θ.
pub(crate) struct Compass;

impl<X: HasPose<N>, const N: usize> MeasurementModel<X, N, 1> for Compass {
    fn h(&self, x: &X, _: usize) -> Result<SVector<f64, 1>, filters::Error> {
        Ok(Vector1::new(x.pose().theta()))
    }

    fn jacobian(&self, _: &X, _: usize) -> Result<SMatrix<f64, 1, N>, filters::Error> {
        Ok(SMatrix::from_fn(|_, j| if j == 2 { 1.0 } else { 0.0 }))
    }

    fn residual(&self, z: &SVector<f64, 1>, expected: &SVector<f64, 1>) -> SVector<f64, 1> {
        Vector1::new(angle_diff(z[0], expected[0]))
    }
}

/// The speed alone: h(x) = v, the fourth number of the state.
pub(crate) struct Speedometer;

impl<X: HasPose<N>, const N: usize> MeasurementModel<X, N, 1> for Speedometer {
    fn h(&self, x: &X, _: usize) -> Result<SVector<f64, 1>, filters::Error> {
        Ok(Vector1::new(x.speed().unwrap_or(0.0)))
    }

    fn jacobian(&self, x: &X, _: usize) -> Result<SMatrix<f64, 1, N>, filters::Error> {
        let read = if x.speed().is_some() { 1.0 } else { 0.0 };
        Ok(SMatrix::from_fn(|_, j| if j == 3 { read } else { 0.0 }))
    }
}
