//! The gain as a schedule: predict and update on the covariance alone (eqs. 8.27, 8.31, 8.32, 8.29), and its limit.

use crate::error::{Argument, Error};
use crate::lti::{Lti, SystemSizes};
use crate::validate;
use alloc::vec::Vec;
use filters::Sizes;
use filters::linear::{self, Gain};
use nalgebra::{DefaultAllocator, Dim, OMatrix};

mod doubling;
mod exact;
mod steady;

pub use exact::{after_exact_readings, before_exact_readings};
pub use steady::{Limit, STRUCTURE, grows, steady_state};

/// The largest number of iterations of a steady-state search; of a large system fewer, see [`validate::MAX_WORK`].
pub const MAX_ITERATIONS: usize = 100_000;
/// The largest number of steps of a gain schedule; no system is too large for so many.
pub const MAX_STEPS: usize = 10_000;

/// The state of the recursion when both limits were reached, or the iterations ran out.
///
/// # Example
/// ```
/// let (sys, belief) = estimate::rail::position_sensor();
/// let limit = sys.steady_state_gain(&belief.p, 10_000, 1e-12)?;
/// assert!(limit.converged && (limit.r[0] - 0.5885825161812468).abs() < 1e-10);
/// let gains = sys.gain_schedule(&belief.p, 50)?;
/// assert!((gains[49] - limit.r).norm() < 1e-9);
/// # Ok::<(), estimate::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyState<N: Dim, M: Dim>
where
    DefaultAllocator: Sizes<N, M>,
{
    /// R, n×p: the last gain. Thrun K.
    pub r: OMatrix<f64, N, M>,
    /// P(k+1 | k), n×n: the covariance that gain was computed from.
    pub p: OMatrix<f64, N, N>,
    /// Whether P moved by no more than the tolerance in the last step, as a part of its largest entry.
    pub converged: bool,
    /// Whether R did. Without observability R may settle while P grows for ever.
    pub gain_converged: bool,
    /// The number of predict–update pairs taken.
    pub iterations: usize,
}

impl<N: Dim, U: Dim, M: Dim> Lti<N, U, M>
where
    DefaultAllocator: SystemSizes<N, U, M>,
{
    /// P(k+1 | k), R(k+1) and P(k+1 | k+1) from P(k | k).
    fn advance(
        &self,
        p: &OMatrix<f64, N, N>,
    ) -> Result<(OMatrix<f64, N, N>, OMatrix<f64, N, M>, OMatrix<f64, N, N>), Error> {
        let step = || -> Result<_, filters::Error> {
            let predicted = linear::predicted_covariance(&self.f, p, &self.v)?;
            let Gain { k: r, p: posterior, .. } = linear::gain(&predicted, &self.h, &self.w)?;
            Ok((predicted, r, posterior))
        };
        step().map_err(blame)
    }

    // ANCHOR: steady_state
    /// R∞, the limit of the gain, from `p0` = P(0 | 0), by iterating the Riccati recursion in Joseph's form.
    ///
    /// P converges to a stabilizing limit when (F, H) is observable and (F, V^½) stabilizable. Where it does not, as
    /// with the velocity sensor, the gain may converge all the same: the answer says which did.
    ///
    /// # Errors
    /// [`crate::Code::Limit`] when `max_iterations` is 0 or above [`MAX_ITERATIONS`] or what
    /// [`validate::MAX_WORK`] leaves of them for a system of this size; [`crate::Code::Tolerance`];
    /// [`crate::Code::InnovationNotPositiveDefinite`]; [`crate::Code::NotFinite`] when P overflows.
    pub fn steady_state_gain(
        &self,
        p0: &OMatrix<f64, N, N>,
        max_iterations: usize,
        tolerance: f64,
    ) -> Result<SteadyState<N, M>, Error> {
        let most = validate::affordable_steps(self.f.nrows(), self.h.nrows(), MAX_ITERATIONS);
        let max_iterations = validate::count(max_iterations, most, "maxIterations")?;
        let tolerance = validate::tolerance(tolerance, "tolerance")?;
        let (p, r, mut posterior) = self.advance(p0)?;
        let mut state = SteadyState { r, p, converged: false, gain_converged: false, iterations: 1 };
        while state.iterations < max_iterations && !(state.converged && state.gain_converged) {
            let (p, r, next) = self.advance(&posterior)?;
            posterior = next;
            state = SteadyState {
                converged: (&p - &state.p).amax() <= tolerance * p.amax(),
                gain_converged: (&r - &state.r).amax() <= tolerance * r.amax(),
                iterations: state.iterations + 1,
                r,
                p,
            };
        }
        Ok(state)
    }
    // ANCHOR_END: steady_state

    /// R(1), R(2), …: the gains of the first `steps` updates from `p0` = P(0 | 0). No reading enters.
    ///
    /// # Errors
    /// As [`Self::steady_state_gain`], the cap being [`MAX_STEPS`].
    pub fn gain_schedule(&self, p0: &OMatrix<f64, N, N>, steps: usize) -> Result<Vec<OMatrix<f64, N, M>>, Error> {
        let steps = validate::count(steps, MAX_STEPS, "steps")?;
        let mut posterior = p0.clone();
        (0..steps)
            .map(|_| {
                let (_, r, next) = self.advance(&posterior)?;
                posterior = next;
                Ok(r)
            })
            .collect()
    }
}

/// A filter's error, blaming P0 for a covariance that overflows.
#[cold]
fn blame(error: filters::Error) -> Error {
    Error::from(error).called(|argument| match argument {
        Argument::Covariance => "P0".into(),
        other => other.letter(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Code;
    use crate::kf::kalman_step;
    use crate::observer::Observer;
    use crate::rail::{dead_reckoning, position_sensor};
    use nalgebra::{Matrix2, Vector1, Vector2};

    /// The tolerance is relative: the same system in other units converges at the same step to the same gain.
    #[test]
    fn convergence_does_not_depend_on_the_units() {
        let (sys, belief) = position_sensor();
        let limit = sys.steady_state_gain(&belief.p, 10_000, 1e-9).expect("converges");
        for unit in [0.5_f64.powi(40), 2.0_f64.powi(40)] {
            let other = Lti { v: sys.v * unit, w: sys.w * unit, ..sys };
            let there = other.steady_state_gain(&(belief.p * unit), 10_000, 1e-9).expect("converges");
            assert_eq!((there.iterations, there.r, there.p), (limit.iterations, limit.r, limit.p * unit));
        }
        // A sensor in other units: its gain is small, and so must be what counts as a change of it.
        let fine = Lti { h: sys.h * 2.0_f64.powi(30), w: sys.w * 2.0_f64.powi(60), ..sys };
        let there = fine.steady_state_gain(&belief.p, 10_000, 1e-9).expect("converges");
        assert_eq!((there.iterations, there.r * 2.0_f64.powi(30)), (limit.iterations, limit.r));
        let (velocity, _) = dead_reckoning();
        let fine = Lti { h: velocity.h * 2.0_f64.powi(30), w: velocity.w * 2.0_f64.powi(60), ..velocity };
        assert!(!fine.steady_state_gain(&belief.p, 3, 1e-9).expect("runs").gain_converged, "after three steps");
    }

    #[test]
    fn the_position_sensor_converges_to_a_fixed_point() {
        let (sys, belief) = position_sensor();
        let limit = sys.steady_state_gain(&belief.p, 10_000, 1e-12).expect("converges");
        assert!(limit.converged && limit.gain_converged && limit.iterations < 100);
        let (p, r, _) = sys.advance(&sys.advance(&belief.p).expect("finite").2).expect("finite");
        assert!((p - limit.p).norm() > 1e-3 && (r - limit.r).norm() > 1e-3, "two steps are not the limit");
        let s = (sys.h * limit.p * sys.h.transpose() + sys.w)[0];
        let posterior = limit.p - limit.p * sys.h.transpose() * (sys.h * limit.p) / s;
        assert!((sys.f * posterior * sys.f.transpose() + sys.v - limit.p).norm() < 1e-11);
    }

    #[test]
    fn the_velocity_sensor_s_gain_settles_while_its_covariance_grows() {
        let (sys, belief) = dead_reckoning();
        let limit = sys.steady_state_gain(&belief.p, 500, 1e-12).expect("runs");
        assert!(!limit.converged && limit.gain_converged);
        assert_eq!(limit.iterations, 500);
        let exact = Vector2::new(0.5, (21.0_f64.sqrt() - 1.0) / 10.0);
        assert!((limit.r - exact).norm() < 1e-12);
        let later = sys.steady_state_gain(&belief.p, 501, 1e-12).expect("runs");
        assert!((later.p[(0, 0)] - limit.p[(0, 0)] - 0.3).abs() < 1e-9);
    }

    #[test]
    fn an_observer_with_the_limit_gain_joins_the_filter_within_fifty_steps() {
        let (sys, mut belief) = position_sensor();
        let k = sys.steady_state_gain(&belief.p, 10_000, 1e-12).expect("converges").r;
        let mut observer = Observer { sys, k, xhat: belief.x };
        for step in 0..50 {
            let y = Vector1::new(libm::sin(0.3 * f64::from(step)));
            belief = kalman_step(&sys, &belief, &Vector1::zeros(), &y).expect("positive definite").posterior;
            observer.step(&Vector1::zeros(), &y);
        }
        assert!((observer.xhat - belief.x).amax() < 1e-6);
        assert!((observer.xhat - belief.x).amax() > 0.0, "they only approach each other");
    }

    #[test]
    fn the_schedule_lists_the_filter_s_gains() {
        let (sys, mut belief) = dead_reckoning();
        let schedule = sys.gain_schedule(&belief.p, 5).expect("runs");
        assert_eq!(schedule.len(), 5);
        for gain in schedule {
            let step = kalman_step(&sys, &belief, &Vector1::zeros(), &Vector1::new(1.0)).expect("pd");
            assert_eq!(gain, step.r);
            belief = step.posterior;
        }
    }

    #[test]
    fn bounds_are_kept_and_overflow_is_an_error() {
        let (sys, belief) = dead_reckoning();
        let code = |iterations, tolerance| sys.steady_state_gain(&belief.p, iterations, tolerance).map_err(|e| e.code);
        assert_eq!(code(0, 1e-9).expect_err("none"), Code::Limit);
        assert_eq!(code(MAX_ITERATIONS + 1, 1e-9).expect_err("too many"), Code::Limit);
        assert_eq!(code(5, -1.0).expect_err("negative"), Code::Tolerance);
        assert_eq!(sys.gain_schedule(&belief.p, 0).expect_err("none").code, Code::Limit);
        assert_eq!(sys.gain_schedule(&belief.p, MAX_STEPS + 1).expect_err("too many").code, Code::Limit);
        assert_eq!(sys.gain_schedule(&belief.p, MAX_STEPS).expect("allowed").len(), MAX_STEPS);
        let unstable = Lti { f: 10.0 * Matrix2::identity(), ..sys };
        assert_eq!(unstable.steady_state_gain(&belief.p, 1000, 1e-12).expect_err("overflows").code, Code::NotFinite);
    }

    #[test]
    fn running_out_of_iterations_is_an_answer() {
        let (sys, belief) = position_sensor();
        let early = sys.steady_state_gain(&belief.p, 3, 1e-12).expect("an answer");
        assert_eq!((early.converged, early.gain_converged, early.iterations), (false, false, 3));
        assert_eq!(early.r, sys.gain_schedule(&belief.p, 3).expect("runs")[2]);
    }
}
