//! What the chapter chose: the constants behind its numbers, in one place, so that a test can move one and see the
//! numbers move.

use estimate::Lti;
use estimate::kf::Gaussian;
use estimate::rail::{dead_reckoning, position_sensor};
use nalgebra::{U1, U2};
use sim::scenarios::{
    LINEAR_SLAM, LinearSlam, PROBE, PROBLEM_9, Probe, Problem9, RANGE_BEARING_SLAM, RangeBearingSlam,
};

/// The chapter's chosen constants. What [`crate::numbers`] computes comes from one of these, but for what is said of
/// the odometry hook and of the Probe's seeds: those are runs of the labs themselves, on `sim::scenarios`.
#[derive(Clone, Debug, PartialEq)]
pub struct Givens {
    /// The rail robot with its velocity sensor (Choset §8.2.6).
    pub velocity: Lti<U2, U1, U1>,
    /// The rail robot with a position sensor.
    pub position: Lti<U2, U1, U1>,
    /// The first belief of both (§8.2.6).
    pub belief: Gaussian<U2>,
    /// The readings of the three hand-checked steps, m/s. Choset gives none; these are the chapter's.
    pub readings: [f64; 3],
    /// The eigenvalues that the chapter places for the position sensor.
    pub poles: [f64; 2],
    /// The first estimation error of the placed observer, m and m/s.
    pub first_error: [f64; 2],
    /// The scalar problem searched by brute force: P⁻, H and W.
    pub scalar: [f64; 3],
    /// Choset's Problem 9 (chapter 8).
    pub problem9: Problem9,
    /// The seed of every single run that is quoted: the first, not the best.
    pub seed: u32,
    /// The Observability Probe.
    pub probe: Probe,
    /// Linear SLAM.
    pub linear_slam: LinearSlam,
    /// Range–bearing SLAM.
    pub range_bearing_slam: RangeBearingSlam,
}

impl Default for Givens {
    fn default() -> Self {
        let (velocity, belief) = dead_reckoning();
        let (position, _) = position_sensor();
        Self {
            velocity,
            position,
            belief,
            readings: [2.7, 2.0, 2.3],
            poles: [0.5, 0.2],
            first_error: [1.0, 1.0],
            scalar: [1.7, 1.0, 0.5],
            problem9: PROBLEM_9,
            seed: 1,
            probe: PROBE,
            linear_slam: LINEAR_SLAM,
            range_bearing_slam: RANGE_BEARING_SLAM,
        }
    }
}
