//! A pose, and the numbers that a replay learns with it.

use crate::odometry::Unicycle;
use crate::scaled::{HasPose, of_pose};
use filters::{MotionModel, State};
use geom::SE2;
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

/// How uncertain b is at the start of a replay, rad/s.
pub const FIRST_SIGMA_BIAS: f64 = 0.02;

/// Which numbers are learned: they stand behind the pose in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Which {
    /// ε, the scale of the ranges.
    pub epsilon: bool,
    /// κ, the scale of the speed.
    pub speed_scale: bool,
    /// b, the bias of the turn rate.
    pub turn_bias: bool,
}

impl Which {
    /// How many states there are with the pose's three.
    pub fn states(self) -> usize {
        3 + usize::from(self.epsilon) + usize::from(self.speed_scale) + usize::from(self.turn_bias)
    }

    /// The place of ε in the state.
    pub fn epsilon(self) -> Option<usize> {
        self.epsilon.then_some(3)
    }

    /// The place of κ.
    pub fn speed_scale(self) -> Option<usize> {
        self.speed_scale.then_some(3 + usize::from(self.epsilon))
    }

    /// The place of b.
    pub fn turn_bias(self) -> Option<usize> {
        self.turn_bias.then_some(self.states() - 1)
    }
}

/// A pose and the learned numbers of `which`, N in all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Learned<const N: usize> {
    pub pose: SE2,
    pub which: Which,
    /// The numbers; those beyond the N states are 0.
    pub numbers: Vector3<f64>,
}

impl<const N: usize> State<N> for Learned<N> {
    fn boxplus(&self, delta: &SVector<f64, N>) -> Self {
        let mut numbers = self.numbers;
        (3..N).for_each(|i| numbers[i - 3] += delta[i]);
        Self { pose: self.pose.boxplus(&Vector3::new(delta[0], delta[1], delta[2])), numbers, ..*self }
    }

    fn boxminus(&self, other: &Self) -> SVector<f64, N> {
        let (pose, numbers) = (self.pose.boxminus(other.pose), self.numbers - other.numbers);
        SVector::from_fn(|i, _| if i < 3 { pose[i] } else { numbers[i - 3] })
    }

    fn is_finite(&self) -> bool {
        self.pose.is_finite() && numerics::all_finite(self.numbers.iter())
    }
}

/// A state with a pose, and with what is learned of how it moves.
pub(crate) trait Moved<const N: usize>: HasPose<N> {
    /// Which numbers are learned.
    fn which(&self) -> Which;
    /// One of the state's numbers behind the pose.
    fn number(&self, at: usize) -> f64;
}

impl Moved<3> for SE2 {
    fn which(&self) -> Which {
        Which::default()
    }

    fn number(&self, _: usize) -> f64 {
        0.0
    }
}

impl<const N: usize> Moved<N> for Learned<N> {
    fn which(&self) -> Which {
        self.which
    }

    fn number(&self, at: usize) -> f64 {
        self.numbers[at - 3]
    }
}

impl<const N: usize> HasPose<N> for Learned<N> {
    fn pose(&self) -> SE2 {
        self.pose
    }

    fn epsilon(&self) -> Option<f64> {
        self.which.epsilon().map(|at| self.number(at))
    }
}

/// How a replay moves over dt seconds: the distance (1 + κ) u₁ and the turn u₂ − b dt, of what was read, u. κ and b are
/// given, or the state's. The robot drives straight along its old heading and turns then, as Choset's unicycle does; a
/// verdict also asks what would be if it turned on the way, and takes the heading half the turn on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rolling {
    pub dt: f64,
    pub speed_scale: f64,
    pub turn_bias: f64,
    /// Whether it turns on the way.
    pub arcs: bool,
}

impl Rolling {
    /// The distance and the turn.
    fn driven<X: Moved<N>, const N: usize>(&self, x: &X, u: &Vector2<f64>) -> Vector2<f64> {
        let which = x.which();
        let scale = which.speed_scale().map_or(self.speed_scale, |at| x.number(at));
        let bias = which.turn_bias().map_or(self.turn_bias, |at| x.number(at));
        Vector2::new(u[0] * (1.0 + scale), u[1] - bias * self.dt)
    }

    /// The pose with the heading along which it drives.
    fn along(&self, pose: &SE2, driven: &Vector2<f64>) -> SE2 {
        if self.arcs { pose.boxplus(&Vector3::new(0.0, 0.0, 0.5 * driven[1])) } else { *pose }
    }

    /// The pose behind the move, and F.
    fn moved(&self, x: &SE2, driven: &Vector2<f64>) -> (SE2, Matrix3<f64>) {
        let (to, f) = Unicycle.linearized(&self.along(x, driven), driven);
        if !self.arcs {
            return (to, f);
        }
        (to.boxplus(&Vector3::new(0.0, 0.0, -0.5 * driven[1])), f)
    }

    /// V = B M Bᵀ at a state, for the noise M of what was read, u.
    pub fn process<X: Moved<N>, const N: usize>(&self, x: &X, u: &Vector2<f64>, noise: &Matrix2<f64>) -> Matrix3<f64> {
        Unicycle::process_covariance(&self.along(&x.pose(), &self.driven(x, u)), noise)
    }
}

impl MotionModel<SE2, 3, 2> for Rolling {
    fn f(&self, x: &SE2, u: &Vector2<f64>) -> SE2 {
        self.linearized(x, u).0
    }

    fn jacobian(&self, x: &SE2, u: &Vector2<f64>) -> SMatrix<f64, 3, 3> {
        self.linearized(x, u).1
    }

    #[inline]
    fn linearized(&self, x: &SE2, u: &Vector2<f64>) -> (SE2, SMatrix<f64, 3, 3>) {
        self.moved(x, &self.driven(x, u))
    }

    #[inline]
    fn transported(
        &self,
        f: &SMatrix<f64, 3, 3>,
        p: &SMatrix<f64, 3, 3>,
        v: &SMatrix<f64, 3, 3>,
    ) -> SMatrix<f64, 3, 3> {
        Unicycle.transported(f, p, v)
    }
}

impl<const N: usize> MotionModel<Learned<N>, N, 2> for Rolling {
    fn f(&self, x: &Learned<N>, u: &Vector2<f64>) -> Learned<N> {
        self.linearized(x, u).0
    }

    fn jacobian(&self, x: &Learned<N>, u: &Vector2<f64>) -> SMatrix<f64, N, N> {
        self.linearized(x, u).1
    }

    /// ∂/∂κ = u₁ (cos θ, sin θ, 0) and ∂/∂b = (0, 0, −dt); what is learned stays as it is. On the way to a turn b moves
    /// the robot aside as well, by half of it.
    fn linearized(&self, x: &Learned<N>, u: &Vector2<f64>) -> (Learned<N>, SMatrix<f64, N, N>) {
        let driven = self.driven(x, u);
        let (pose, aside) = self.moved(&x.pose, &driven);
        let mut f: SMatrix<f64, N, N> = of_pose(&aside);
        (3..N).for_each(|i| f[(i, i)] = 1.0);
        if let Some(at) = x.which.speed_scale() {
            let along = Unicycle::input_jacobian(&self.along(&x.pose, &driven)).column(0) * u[0];
            (0..3).for_each(|i| f[(i, at)] = along[i]);
        }
        if let Some(at) = x.which.turn_bias() {
            f[(2, at)] = -self.dt;
            if self.arcs {
                (0..2).for_each(|i| f[(i, at)] = -0.5 * self.dt * aside[(i, 2)]);
            }
        }
        (Learned { pose, ..*x }, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use filters::central_differences;

    fn state<const N: usize>(which: Which) -> Learned<N> {
        assert_eq!(which.states(), N);
        let numbers = Vector3::from_fn(|i, _| if i + 3 < N { 0.03 + 0.01 * i as f64 } else { 0.0 });
        Learned { pose: SE2::new(0.3, -0.7, 2.9), which, numbers }
    }

    fn assert_derivative<const N: usize>(which: Which) {
        let (x, u) = (state::<N>(which), Vector2::new(1.4, -0.2));
        for arcs in [false, true] {
            let rolling = Rolling { dt: 0.3, speed_scale: 0.2, turn_bias: -0.1, arcs };
            let numeric = central_differences(|x| rolling.f(x, &u), |a, b| a.boxminus(b), &x, 1e-5);
            assert!((rolling.jacobian(&x, &u) - numeric).amax() < 1e-9, "{which:?} {arcs}");
        }
    }

    /// The heading of the middle is that of the chord, whose length misses a part in 24 of the squared turn.
    #[test]
    fn a_robot_that_turns_on_the_way_is_on_the_arc() {
        let (x, turn, distance) = (SE2::new(1.0, 2.0, 0.4), 0.2_f64, 0.5_f64);
        let arcs = Rolling { dt: 1.0, speed_scale: 0.0, turn_bias: 0.0, arcs: true };
        let to = MotionModel::f(&arcs, &x, &Vector2::new(distance, turn));
        let radius = distance / turn;
        let on =
            [1.0 + radius * ((0.6_f64).sin() - (0.4_f64).sin()), 2.0 - radius * ((0.6_f64).cos() - (0.4_f64).cos())];
        let off = (to.x() - on[0]).hypot(to.y() - on[1]);
        assert!(off < distance * turn * turn / 23.0 && (to.theta() - 0.6).abs() < 1e-15, "{off}");
    }

    #[test]
    fn the_jacobians_are_derivatives_whatever_is_learned() {
        let which = |epsilon, speed_scale, turn_bias| Which { epsilon, speed_scale, turn_bias };
        assert_derivative::<4>(which(true, false, false));
        assert_derivative::<4>(which(false, true, false));
        assert_derivative::<4>(which(false, false, true));
        assert_derivative::<5>(which(true, true, false));
        assert_derivative::<5>(which(true, false, true));
        assert_derivative::<5>(which(false, true, true));
        assert_derivative::<6>(which(true, true, true));
    }

    #[test]
    fn a_learned_number_moves_as_the_same_number_when_it_is_given() {
        let which = Which { speed_scale: true, turn_bias: true, ..Which::default() };
        let (x, u) = (state::<5>(which), Vector2::new(1.4, -0.2));
        let given = Rolling { dt: 0.3, speed_scale: x.number(3), turn_bias: x.number(4), arcs: false };
        let learning = Rolling { dt: 0.3, speed_scale: 0.0, turn_bias: 0.0, arcs: false };
        assert_eq!(learning.f(&x, &u).pose, given.f(&x.pose, &u));
    }
}
