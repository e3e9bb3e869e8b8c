//! Sensors of the robot's own position, heading and speed.

use crate::scaled::HasPose;
use filters::MeasurementModel;
use geom::{SE2, angle_diff};
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

/// The position of an antenna that stands `at` so far ahead of the pose, and to its left:
/// h(x) = (x, y) + R(θ) at, and ∂h/∂θ = R(θ + π/2) at.
pub(crate) struct Antenna {
    /// m.
    pub at: [f64; 2],
}

impl<X: HasPose<N>, const N: usize> MeasurementModel<X, N, 2> for Antenna {
    fn h(&self, x: &X, _: usize) -> Result<SVector<f64, 2>, filters::Error> {
        Ok(x.pose().transform(Vector2::from(self.at)))
    }

    fn jacobian(&self, x: &X, _: usize) -> Result<SMatrix<f64, 2, N>, filters::Error> {
        let arm = SE2::new(0.0, 0.0, x.pose().theta()).transform(Vector2::from(self.at));
        let mut c = SMatrix::identity();
        (c[(0, 2)], c[(1, 2)]) = (-arm[1], arm[0]);
        Ok(c)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scaled::PoseAndScale;
    use filters::central_differences;

    #[test]
    fn an_antenna_is_led_by_the_heading() {
        let (antenna, state) =
            (Antenna { at: [0.8, -0.3] }, PoseAndScale { pose: SE2::new(4.0, -2.0, 2.1), epsilon: 0.1 });
        let h = |x: &PoseAndScale| antenna.h(x, 0).expect("a pose");
        let (sin, cos) = 2.1_f64.sin_cos();
        let wanted = Vector2::new(4.0 + 0.8 * cos + 0.3 * sin, -2.0 + 0.8 * sin - 0.3 * cos);
        assert!((h(&state) - wanted).amax() < 1e-15);
        let numeric = central_differences(h, |a, b| a - b, &state, 1e-5);
        assert!((antenna.jacobian(&state, 0).expect("a pose") - numeric).amax() < 1e-9);
        let fix: SVector<f64, 2> = Fix.h(&state, 0).expect("a pose");
        assert_eq!(
            Antenna { at: [0.0; 2] }.h(&state, 0),
            Ok(fix),
            "an antenna at the pose is a fix, to the last digit"
        );
    }
}
