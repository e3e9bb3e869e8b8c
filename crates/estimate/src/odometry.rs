//! From encoder counts to Choset's input u = [Δs, Δθ], and how it moves a unicycle.

use core::f64::consts::TAU;
use filters::MotionModel;
use geom::SE2;
use nalgebra::{Matrix2, Matrix3, Matrix3x2, SMatrix, SVector, Vector2, Vector3};

/// The wheels as the software believes them to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheels {
    /// Between the two points of contact, metres.
    pub baseline: f64,
    /// Nominal radius, metres.
    pub radius: f64,
    /// Encoder ticks in a turn of a wheel.
    pub ticks_per_turn: f64,
}

impl Wheels {
    /// How far a wheel of nominal radius rolls in a tick of its encoder, metres.
    pub fn metres_per_tick(&self) -> f64 {
        TAU * self.radius / self.ticks_per_turn
    }
}

/// What both encoders counted since the last reading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ticks {
    /// Of the left wheel.
    pub left: i64,
    /// Of the right wheel.
    pub right: i64,
}

// ANCHOR: odometry_delta
/// u = [Δs, Δθ], metres and radians, from what the wheels' encoders counted: the mean of the wheels' travel, and their
/// difference over the baseline.
///
/// # Example
/// ```
/// use estimate::{Ticks, Wheels};
/// let wheels = Wheels { baseline: 0.5, radius: 1.0 / core::f64::consts::TAU, ticks_per_turn: 1000.0 }; // 1 mm a tick
/// let u = estimate::odometry_delta(&wheels, Ticks { left: 100, right: 200 });
/// assert!((u[0] - 0.15).abs() < 1e-15 && (u[1] - 0.2).abs() < 1e-15);
/// ```
pub fn odometry_delta(wheels: &Wheels, counted: Ticks) -> Vector2<f64> {
    let metres = |ticks: i64| ticks as f64 * wheels.metres_per_tick();
    let (left, right) = (metres(counted.left), metres(counted.right));
    Vector2::new(0.5 * (left + right), (right - left) / wheels.baseline)
}
// ANCHOR_END: odometry_delta

/// The covariance of u when each wheel slips by an independent amount of standard deviation `slip` (metres): diagonal,
/// since sum and difference of two like noises are uncorrelated.
pub fn slip_covariance(wheels: &Wheels, slip: f64) -> Matrix2<f64> {
    let turn = slip / wheels.baseline;
    Matrix2::new(0.5 * slip * slip, 0.0, 0.0, 2.0 * turn * turn)
}

/// The unicycle of §8.3: x⁺ = [x + u₁ cos θ, y + u₁ sin θ, θ + u₂], driving along the old heading, then turning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unicycle;

impl Unicycle {
    /// ∂f/∂u at heading θ, 3×2: what turns noise in u into noise in the state.
    pub fn input_jacobian(pose: &SE2) -> Matrix3x2<f64> {
        let (sin, cos) = libm::sincos(pose.theta());
        Matrix3x2::new(cos, 0.0, sin, 0.0, 0.0, 1.0)
    }

    /// V = (∂f/∂u) M (∂f/∂u)ᵀ for an input covariance M.
    pub fn process_covariance(pose: &SE2, input: &Matrix2<f64>) -> Matrix3<f64> {
        let g = Self::input_jacobian(pose);
        filters::covariance::symmetric(g * input * g.transpose())
    }
}

// ANCHOR: unicycle
impl MotionModel<SE2, 3, 2> for Unicycle {
    fn f(&self, x: &SE2, u: &SVector<f64, 2>) -> SE2 {
        self.linearized(x, u).0
    }

    fn jacobian(&self, x: &SE2, u: &SVector<f64, 2>) -> SMatrix<f64, 3, 3> {
        self.linearized(x, u).1
    }

    /// The Jacobian's third column says it all: a heading error δθ pushes the position sideways, by u₁ δθ.
    fn linearized(&self, x: &SE2, u: &SVector<f64, 2>) -> (SE2, SMatrix<f64, 3, 3>) {
        let (sin, cos) = libm::sincos(x.theta());
        let moved = x.boxplus(&Vector3::new(u[0] * cos, u[0] * sin, u[1]));
        (moved, Matrix3::new(1.0, 0.0, -u[0] * sin, 0.0, 1.0, u[0] * cos, 0.0, 0.0, 1.0))
    }

    /// FPFᵀ + V with a = F₁₃ and b = F₂₃ alone: the rest of F is ones and zeros.
    #[inline]
    fn transported(&self, f: &Matrix3<f64>, p: &Matrix3<f64>, v: &Matrix3<f64>) -> Matrix3<f64> {
        let (a, b) = (f[(0, 2)], f[(1, 2)]);
        let (from_x, from_y) = (a * p[(2, 2)], b * p[(2, 2)]);
        let xx = v[(0, 0)] + (p[(0, 0)] + a * p[(2, 0)]) + (p[(2, 0)] + from_x) * a;
        let yx = v[(1, 0)] + (p[(1, 0)] + b * p[(2, 0)]) + (p[(2, 1)] + from_y) * a;
        let yy = v[(1, 1)] + (p[(1, 1)] + b * p[(2, 1)]) + (p[(2, 1)] + from_y) * b;
        let (tx, ty) = (v[(2, 0)] + p[(2, 0)] + from_x, v[(2, 1)] + p[(2, 1)] + from_y);
        Matrix3::new(xx, yx, tx, yx, yy, ty, tx, ty, v[(2, 2)] + p[(2, 2)])
    }
}
// ANCHOR_END: unicycle

#[cfg(test)]
mod tests {
    use super::*;
    use filters::{Ekf, central_differences};

    /// The unicycle, its covariance multiplied out as any model's is.
    struct Plain;

    impl MotionModel<SE2, 3, 2> for Plain {
        fn f(&self, x: &SE2, u: &SVector<f64, 2>) -> SE2 {
            Unicycle.f(x, u)
        }

        fn jacobian(&self, x: &SE2, u: &SVector<f64, 2>) -> SMatrix<f64, 3, 3> {
            Unicycle.jacobian(x, u)
        }
    }

    #[test]
    fn the_shorter_way_has_the_bits_of_the_dense_products() {
        let v = Matrix3::new(1e-3, 1e-4, 0.0, 1e-4, 2e-3, -1e-5, 0.0, -1e-5, 3e-4);
        let mut shorter = Ekf { x: SE2::new(0.4, -1.2, 2.8), p: Matrix3::identity() * 0.01 };
        let mut dense = shorter;
        for k in 0..200 {
            let u = Vector2::new(0.1 * f64::from(k % 7), 0.05 * f64::from(k % 5) - 0.1);
            shorter.predict(&Unicycle, &u, &v).expect("finite");
            dense.predict(&Plain, &u, &v).expect("finite");
            assert_eq!(shorter, dense, "step {k}");
        }
    }

    #[test]
    fn a_refused_motion_leaves_mean_and_covariance() {
        let before = Ekf { x: SE2::new(0.4, -1.2, 2.8), p: Matrix3::identity() };
        let mut ekf = before;
        for (u, v) in [(f64::NAN, 0.0), (f64::INFINITY, 0.0), (1e200, 0.0), (0.1, f64::INFINITY), (0.1, f64::NAN)] {
            let v = Matrix3::identity() * v;
            assert!(ekf.predict(&Unicycle, &Vector2::new(u, 0.1), &v).is_err(), "{u}");
            assert_eq!(ekf, before);
        }
    }

    #[test]
    fn the_jacobians_are_derivatives() {
        let (x, u) = (SE2::new(0.4, -1.2, 2.8), Vector2::new(0.7, 0.9));
        let by_state = central_differences(|x| Unicycle.f(x, &u), |a, b| a.boxminus(*b), &x, 1e-5);
        assert!((by_state - Unicycle.jacobian(&x, &u)).amax() < 1e-9);
        let by_input = central_differences(|u| Unicycle.f(&x, u), |a, b| a.boxminus(*b), &u, 1e-5);
        assert!((by_input - Unicycle::input_jacobian(&x)).amax() < 1e-9);
    }
}
