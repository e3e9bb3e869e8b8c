//! A robot whose speed is a state: it keeps its speed until something changes it, and a speedometer reads it.

use crate::odometry::Unicycle;
use crate::scaled::{HasPose, of_pose};
use filters::{MotionModel, State};
use geom::SE2;
use nalgebra::{Matrix4, SVector, Vector2, Vector3, Vector4};

/// A pose, and the speed along its heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseAndSpeed {
    /// The pose.
    pub pose: SE2,
    /// v, m/s.
    pub speed: f64,
}

impl State<4> for PoseAndSpeed {
    fn boxplus(&self, delta: &Vector4<f64>) -> Self {
        let pose = self.pose.boxplus(&Vector3::new(delta[0], delta[1], delta[2]));
        Self { pose, speed: self.speed + delta[3] }
    }

    fn boxminus(&self, other: &Self) -> Vector4<f64> {
        let pose = self.pose.boxminus(other.pose);
        Vector4::new(pose[0], pose[1], pose[2], self.speed - other.speed)
    }

    fn is_finite(&self) -> bool {
        self.pose.is_finite() && self.speed.is_finite()
    }
}

impl HasPose<4> for PoseAndSpeed {
    fn pose(&self) -> SE2 {
        self.pose
    }

    fn epsilon(&self) -> Option<f64> {
        None
    }

    fn speed(&self) -> Option<f64> {
        Some(self.speed)
    }
}

/// The unicycle that keeps its speed over dt seconds: x⁺ = [x + v dt cos θ, y + v dt sin θ, θ + u₂, v + u₁], with the
/// input u = [Δv, Δθ]: by how much the speed changes, and how far it turns.
///
/// # Example
/// ```
/// use estimate::{Coasting, PoseAndSpeed};
/// use filters::MotionModel;
/// use geom::SE2;
/// use nalgebra::Vector2;
/// let at = PoseAndSpeed { pose: SE2::new(0.0, 0.0, 0.0), speed: 2.0 };
/// let next = Coasting { dt: 0.5 }.f(&at, &Vector2::new(-0.1, 0.2));
/// assert_eq!((next.pose.x(), next.pose.theta(), next.speed), (1.0, 0.2, 1.9));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coasting {
    /// s.
    pub dt: f64,
}

impl MotionModel<PoseAndSpeed, 4, 2> for Coasting {
    fn f(&self, x: &PoseAndSpeed, u: &SVector<f64, 2>) -> PoseAndSpeed {
        self.linearized(x, u).0
    }

    fn jacobian(&self, x: &PoseAndSpeed, u: &SVector<f64, 2>) -> Matrix4<f64> {
        self.linearized(x, u).1
    }

    /// ∂/∂v = dt (cos θ, sin θ, 0, 1/dt).
    fn linearized(&self, x: &PoseAndSpeed, u: &SVector<f64, 2>) -> (PoseAndSpeed, Matrix4<f64>) {
        let (pose, by_pose) = Unicycle.linearized(&x.pose, &Vector2::new(x.speed * self.dt, u[1]));
        let mut f: Matrix4<f64> = of_pose(&by_pose);
        let along = Unicycle::input_jacobian(&x.pose).column(0) * self.dt;
        (0..3).for_each(|i| f[(i, 3)] = along[i]);
        f[(3, 3)] = 1.0;
        (PoseAndSpeed { pose, speed: x.speed + u[0] }, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Landmark, Localizer, Reading, Setup};
    use filters::{Ekf, central_differences};

    const MAP: [Landmark; 1] = [Landmark { id: 1, x: 6.0, y: 1.0 }];

    fn state() -> PoseAndSpeed {
        PoseAndSpeed { pose: SE2::new(0.3, -0.7, 2.9), speed: 1.3 }
    }

    fn setup() -> Setup<'static> {
        Setup { map: &MAP, scale: None, offset: 0.0, gate: None }
    }

    #[test]
    fn the_jacobian_is_the_derivative() {
        let (model, u) = (Coasting { dt: 0.4 }, Vector2::new(0.2, -0.3));
        let numeric = central_differences(|x| model.f(x, &u), |a, b| a.boxminus(b), &state(), 1e-5);
        assert!((model.jacobian(&state(), &u) - numeric).amax() < 1e-9);
    }

    #[test]
    fn fixes_say_how_fast_it_is_and_a_speedometer_says_it_at_once() {
        let belief = Ekf { x: PoseAndSpeed { pose: SE2::new(0.0, 0.0, 0.0), speed: 0.0 }, p: Matrix4::identity() };
        let mut by_fixes = Localizer { filter: belief };
        for k in 1..=20 {
            by_fixes.filter.predict(&Coasting { dt: 0.5 }, &Vector2::zeros(), &Matrix4::zeros()).expect("finite");
            let fix = Reading::Position { x: f64::from(k), y: 0.0, w: nalgebra::Matrix2::identity() * 0.01 };
            by_fixes.correct(&fix, &setup()).expect("positive definite");
        }
        assert!((by_fixes.filter.x.speed - 2.0).abs() < 0.01, "{}", by_fixes.filter.x.speed);
        let mut by_speed = Localizer { filter: belief };
        let answer = by_speed.correct(&Reading::Speed { v: 2.0, w: 0.25 }, &setup()).expect("positive definite");
        // S = 1 + 0.25: four fifths of the innovation are taken, and the pose is left alone.
        assert_eq!((answer.innovation[0], answer.s[(0, 0)], answer.outputs), (2.0, 1.25, 1));
        let Ekf { x, p } = by_speed.filter;
        assert!((x.speed - 1.6).abs() < 1e-15 && (p[(3, 3)] - 0.2).abs() < 1e-15);
        assert!(x.pose == belief.x.pose && p.fixed_view::<3, 3>(0, 0) == belief.p.fixed_view::<3, 3>(0, 0));
    }

    #[test]
    fn a_range_says_nothing_of_the_speed_itself() {
        let mut localizer = Localizer { filter: Ekf { x: state(), p: Matrix4::identity() * 0.1 } };
        let range = Reading::Range { landmark: Some(0), range: 5.0, w: 0.1 };
        localizer.correct(&range, &setup()).expect("positive definite");
        assert_eq!((localizer.filter.x.speed, localizer.filter.p[(3, 3)]), (1.3, 0.1));
    }
}
