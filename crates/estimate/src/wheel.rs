//! A right wheel that is believed too large: the fraction ε as a fourth state, which the filter learns from its fixes.

use crate::odometry::Unicycle;
use crate::scaled::PoseAndScale;
use filters::MotionModel;
use geom::SE2;
use nalgebra::{Matrix2, Matrix4, SVector, Vector2};

/// The unicycle of §8.3 on encoders whose right wheel is believed too large by a fraction ε: where its encoder says
/// that it rolled d_r, it rolled d_r (1 − ε). The state is [x, y, θ, ε] in m, m, rad and 1; the input u = [Δs, Δθ] is
/// what the encoders say.
///
/// u(ε) = u − ε [d_r/2, d_r/b] with d_r = Δs + b Δθ/2, and ε⁺ = ε. So
/// F = [F_pose, −G_u [d_r/2, d_r/b]ᵀ; 0, 1], with F_pose and G_u of the unicycle at u(ε).
///
/// # Example
/// ```
/// use estimate::RightWheel;
/// use estimate::drive::PoseAndScale;
/// use filters::MotionModel;
/// use geom::SE2;
/// use nalgebra::Vector2;
/// let at = PoseAndScale { pose: SE2::new(0.0, 0.0, 0.0), epsilon: 0.01 };
/// let next = RightWheel { baseline: 0.5 }.f(&at, &Vector2::new(1.0, 0.0)); // both encoders say 1 m
/// assert!((next.pose.x() - 0.995).abs() < 1e-15, "the right wheel rolled 0.99 m");
/// assert!((next.pose.theta() + 0.02).abs() < 1e-15, "so the robot has turned to the right");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RightWheel {
    /// b, between the two points of contact, metres.
    pub baseline: f64,
}

impl RightWheel {
    /// −∂u/∂ε = [d_r/2, d_r/b].
    fn lever(&self, u: &Vector2<f64>) -> Vector2<f64> {
        let rolled = u[0] + 0.5 * self.baseline * u[1];
        Vector2::new(0.5 * rolled, rolled / self.baseline)
    }

    /// V of the state for the covariance `input` of u at this pose, 4×4; ε receives no noise.
    pub fn process_covariance(pose: &SE2, input: &Matrix2<f64>) -> Matrix4<f64> {
        let mut v = Matrix4::zeros();
        v.fixed_view_mut::<3, 3>(0, 0).copy_from(&Unicycle::process_covariance(pose, input));
        v
    }
}

impl MotionModel<PoseAndScale, 4, 2> for RightWheel {
    fn f(&self, x: &PoseAndScale, u: &SVector<f64, 2>) -> PoseAndScale {
        self.linearized(x, u).0
    }

    fn jacobian(&self, x: &PoseAndScale, u: &SVector<f64, 2>) -> Matrix4<f64> {
        self.linearized(x, u).1
    }

    fn linearized(&self, x: &PoseAndScale, u: &SVector<f64, 2>) -> (PoseAndScale, Matrix4<f64>) {
        let lever = self.lever(u);
        let (pose, by_pose) = Unicycle.linearized(&x.pose, &(u - lever * x.epsilon));
        let mut f = Matrix4::identity();
        f.fixed_view_mut::<3, 3>(0, 0).copy_from(&by_pose);
        f.fixed_view_mut::<3, 1>(0, 3).copy_from(&(Unicycle::input_jacobian(&x.pose) * -lever));
        (PoseAndScale { pose, ..*x }, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Landmark;
    use crate::landmarks::RangeBearing;
    use crate::odometry::{Ticks, Wheels, odometry_delta};
    use crate::scaled::Scaled;
    use crate::{Localizer, Sighting};
    use filters::{Ekf, MeasurementModel, central_differences};

    const WHEEL: RightWheel = RightWheel { baseline: 0.4 };

    fn state() -> PoseAndScale {
        PoseAndScale { pose: SE2::new(0.3, -0.7, 2.9), epsilon: 0.02 }
    }

    #[test]
    fn the_jacobians_are_derivatives() {
        let u = Vector2::new(0.4, -0.2);
        let moved = central_differences(|x| WHEEL.f(x, &u), filters::State::boxminus, &state(), 1e-5);
        assert!((WHEEL.jacobian(&state(), &u) - moved).amax() < 1e-9);
    }

    #[test]
    fn a_stacked_fix_of_four_states_is_the_filter_s_own() {
        let map = [Landmark { id: 1, x: 2.0, y: 1.0 }];
        let (model, w) = (
            Scaled { sensor: RangeBearing { map: &map }, scale: Some(0.0), offset: 0.0 },
            Matrix2::new(0.01, 0.0, 0.0, 0.001),
        );
        let mut own = Ekf { x: state(), p: Matrix4::identity() * 1e-4 };
        for _ in 0..50 {
            own.predict(&WHEEL, &Vector2::new(0.05, 0.01), &(Matrix4::identity() * 1e-6)).expect("finite");
        }
        let mut stacked = Localizer { filter: own };
        // Off by 0.2 m and 0.05 rad.
        let y = model.h(&own.x, 0).expect("apart") + Vector2::new(0.2, 0.05);
        own.update(&model, &y, 0, &w).expect("apart");
        stacked.update_stacked(&model, &[Sighting { j: 0, y }], &w).expect("apart");
        assert!((own.p - stacked.filter.p).amax() < 1e-15 && own.x.epsilon != 0.02);
        assert!(filters::State::boxminus(&own.x, &stacked.filter.x).amax() < 1e-15);
    }

    #[test]
    fn a_wheel_of_known_bias_is_a_smaller_wheel() {
        // The right encoder counts 2000 ticks of a wheel that is 2 % smaller than believed: 1960 ticks of the nominal
        // one.
        let wheels = Wheels { baseline: 0.4, radius: 0.05, ticks_per_turn: 4096.0 };
        let believed = odometry_delta(&wheels, Ticks { left: 1500, right: 2000 });
        let rolled = odometry_delta(&wheels, Ticks { left: 1500, right: 1960 });
        let by_state = WHEEL.f(&state(), &believed);
        assert!(by_state.pose.boxminus(Unicycle.f(&state().pose, &rolled)).amax() < 1e-15);
        assert_eq!(by_state.epsilon, 0.02);
    }
}
