//! Ranges that are scaled and offset, seen from a pose or from a pose with the scale as a fourth state.

use crate::odometry::Unicycle;
use filters::{MeasurementModel, MotionModel, State};
use geom::SE2;
use nalgebra::{Matrix4, SMatrix, SVector, Vector4};

/// A pose, and a number ε that calibrates one of the robot's sensors: by how much its ranges read long, or by how much
/// a wheel is believed too large ([`RightWheel`](crate::RightWheel)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseAndScale {
    /// The pose.
    pub pose: SE2,
    /// ε.
    pub epsilon: f64,
}

impl State<4> for PoseAndScale {
    fn boxplus(&self, delta: &Vector4<f64>) -> Self {
        let pose = self.pose.boxplus(&delta.fixed_rows::<3>(0).into_owned());
        Self { pose, epsilon: self.epsilon + delta[3] }
    }

    fn boxminus(&self, other: &Self) -> Vector4<f64> {
        let pose = self.pose.boxminus(other.pose);
        Vector4::new(pose[0], pose[1], pose[2], self.epsilon - other.epsilon)
    }

    fn is_finite(&self) -> bool {
        self.pose.is_finite() && self.epsilon.is_finite()
    }
}

/// A state with a pose from which sensors read, and perhaps the scale of its ranges or its speed: `[x, y, θ]`,
/// `[x, y, θ, ε]`, or `[x, y, θ, v]`.
pub trait HasPose<const N: usize>: State<N> {
    /// The pose.
    fn pose(&self) -> SE2;

    /// ε, where it is part of the state: the fourth number of it.
    fn epsilon(&self) -> Option<f64>;

    /// The speed, where it is part of the state: the fourth number of it.
    #[inline]
    fn speed(&self) -> Option<f64> {
        None
    }
}

impl HasPose<3> for SE2 {
    fn pose(&self) -> SE2 {
        *self
    }

    fn epsilon(&self) -> Option<f64> {
        None
    }
}

impl HasPose<4> for PoseAndScale {
    fn pose(&self) -> SE2 {
        self.pose
    }

    fn epsilon(&self) -> Option<f64> {
        Some(self.epsilon)
    }
}

/// A matrix in the coordinates of a pose, zero in every other coordinate of a larger state.
pub(crate) fn of_pose<const R: usize, const C: usize, const M: usize, const N: usize>(
    m: &SMatrix<f64, R, C>,
) -> SMatrix<f64, M, N> {
    SMatrix::from_fn(|i, j| if i < R && j < C { m[(i, j)] } else { 0.0 })
}

/// The unicycle's motion leaves the scale as it is: F = diag(F_pose, 1).
impl MotionModel<PoseAndScale, 4, 2> for Unicycle {
    fn f(&self, x: &PoseAndScale, u: &SVector<f64, 2>) -> PoseAndScale {
        PoseAndScale { pose: self.f(&x.pose, u), ..*x }
    }

    fn jacobian(&self, x: &PoseAndScale, u: &SVector<f64, 2>) -> Matrix4<f64> {
        let mut f: Matrix4<f64> = of_pose(&self.jacobian(&x.pose, u));
        f[(3, 3)] = 1.0;
        f
    }
}

/// A sensor of the pose whose first output is a range: no other may stand in [`Scaled`].
pub trait RangeFirst<const M: usize>: MeasurementModel<SE2, 3, M> {}

/// A sensor whose range ρ is read as (1 + ε) ρ + offset. ε is given, or the state's.
#[derive(Clone, Copy, Debug)]
pub struct Scaled<S> {
    /// The sensor.
    pub sensor: S,
    /// ε where it is given; `None` takes it from the state, and 0 where the state has none.
    pub scale: Option<f64>,
    /// m.
    pub offset: f64,
}

impl<S, X, const N: usize, const M: usize> MeasurementModel<X, N, M> for Scaled<S>
where
    S: RangeFirst<M>,
    X: HasPose<N>,
{
    fn h(&self, x: &X, j: usize) -> Result<SVector<f64, M>, filters::Error> {
        self.linearized(x, j).map(|(h, _)| h)
    }

    fn jacobian(&self, x: &X, j: usize) -> Result<SMatrix<f64, M, N>, filters::Error> {
        self.linearized(x, j).map(|(_, c)| c)
    }

    /// ∂y/∂pose = (1 + ε) ∂ρ/∂pose in the range's row, and ∂y/∂ε = ρ where ε is not given.
    #[inline(always)]
    fn linearized(&self, x: &X, j: usize) -> Result<(SVector<f64, M>, SMatrix<f64, M, N>), filters::Error> {
        let (mut y, mut c) = self.sensor.linearized(&x.pose(), j)?;
        let (rho, factor) = (y[0], 1.0 + self.scale.or(x.epsilon()).unwrap_or(0.0));
        y[0] = factor * rho + self.offset;
        for k in 0..3 {
            c[(0, k)] *= factor;
        }
        let mut c: SMatrix<f64, M, N> = of_pose(&c);
        if N > 3 && self.scale.is_none() && x.epsilon().is_some() {
            c[(0, 3)] = rho;
        }
        Ok((y, c))
    }

    #[inline]
    fn residual(&self, z: &SVector<f64, M>, expected: &SVector<f64, M>) -> SVector<f64, M> {
        self.sensor.residual(z, expected)
    }
}

/// How uncertain x, y, θ and ε are at the start of a replay: standard deviations in m, m, rad, and a number.
pub const FIRST_SIGMA: [f64; 4] = [0.2, 0.2, 0.1, 0.1];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Landmark;
    use crate::landmarks::{RangeBearing, RangeOnly};
    use filters::central_differences;
    use nalgebra::Vector2;

    const MAP: [Landmark; 2] = [Landmark { id: 1, x: 2.0, y: 1.0 }, Landmark { id: 2, x: -3.0, y: 4.0 }];

    fn state() -> PoseAndScale {
        PoseAndScale { pose: SE2::new(0.3, -0.7, 2.9), epsilon: 0.07 }
    }

    #[test]
    fn the_jacobians_are_derivatives() {
        let (range, both) = (RangeOnly { map: &MAP }, RangeBearing { map: &MAP });
        for j in 0..2 {
            let range = Scaled { sensor: range, scale: None, offset: 0.4 };
            let h = |x: &PoseAndScale| range.h(x, j).expect("apart");
            let numeric = central_differences(h, |a, b| a - b, &state(), 1e-5);
            assert!((range.jacobian(&state(), j).expect("apart") - numeric).amax() < 1e-9);
            let both = Scaled { sensor: both, scale: None, offset: 0.4 };
            let h = |x: &PoseAndScale| both.h(x, j).expect("apart");
            let minus = |a: &SVector<f64, 2>, b: &SVector<f64, 2>| {
                MeasurementModel::<PoseAndScale, 4, 2>::residual(&both, a, b)
            };
            let numeric = central_differences(h, minus, &state(), 1e-5);
            assert!((both.jacobian(&state(), j).expect("apart") - numeric).amax() < 1e-9);
            let u = Vector2::new(0.4, -0.2);
            let moved = central_differences(|x| Unicycle.f(x, &u), |a, b| a.boxminus(b), &state(), 1e-5);
            assert!((Unicycle.jacobian(&state(), &u) - moved).amax() < 1e-9);
        }
    }

    #[test]
    fn a_given_scale_says_nothing_of_the_state_s_own() {
        let sensor = Scaled { sensor: RangeBearing { map: &MAP }, scale: Some(0.07), offset: 0.4 };
        let (y, c) = sensor.linearized(&state(), 1).expect("apart");
        let (of_pose, by_pose) = sensor.linearized(&state().pose, 1).expect("apart");
        assert_eq!((y, c.fixed_columns::<3>(0).into_owned()), (of_pose, by_pose));
        assert_eq!(c.column(3).amax(), 0.0);
    }

    #[test]
    fn a_learned_scale_reads_as_the_same_scale_when_it_is_given() {
        let sensor = RangeOnly { map: &MAP };
        let learned: SVector<f64, 1> = Scaled { sensor, scale: None, offset: 0.4 }.h(&state(), 1).expect("apart");
        let given = Scaled { sensor, scale: Some(0.07), offset: 0.4 }.h(&state().pose, 1).expect("apart");
        assert_eq!(learned, given);
        assert!((given[0] - (1.07 * numerics::hypot(3.3, 4.7) + 0.4)).abs() < 1e-15 * given[0]);
    }
}
