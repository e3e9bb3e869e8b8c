//! What a fit has found, as far as it has come.

use crate::drive::fitted::Fitted;
use alloc::vec::Vec;

/// What a fit has found.
#[derive(Clone, Debug, PartialEq)]
pub struct FitResult {
    /// Each number: what it is, its value, and its standard deviation, relative of a σ, else in the number's unit.
    /// `None` where the log does not tell it.
    pub numbers: Vec<(Fitted, f64, Option<f64>)>,
    /// The σ that the log does not tell since smaller ones are about as likely, and the greatest that is: the
    /// log-likelihood is less by a half there.
    pub at_most: Vec<(Fitted, f64)>,
    /// The log-likelihood of the counted readings before and after, where what a gate refuses is taken for outliers.
    pub log_likelihood: [f64; 2],
    /// How many readings are counted.
    pub readings: u32,
    /// How many of them are taken for outliers under what was found; `None` where no gate is on.
    pub outliers: Option<u32>,
    /// How many of them the gates refuse, as they are set, under what was found: far more where a filter that once
    /// refuses loses its way. `None` where no gate is on, 0 before the search has ended.
    pub refused: Option<u32>,
    /// Replays so far, and how many there may be at most.
    pub replays: [u32; 2],
    /// Whether the search has ended where no step leads up, and not at the most replays.
    pub settled: bool,
    /// How many of the other readings lie where this share of them is expected under what was found: more are
    /// outliers, which have bent it. 0 before the search has ended.
    pub beyond: u32,
    /// That share.
    pub expected: f64,
    /// The mean distance of a second in which the robot drives, m: a σ of the distance that is a good part of it, in
    /// m/√s, is more than noise.
    pub pace: f64,
    /// Half of the mean turn of a step between rows of motion, rad, counted by its distance. The filter drives each
    /// step straight and turns then, and takes a sensor of bearings to be turned by so much.
    pub half_turn: f64,
    /// The median time between rows of motion, s.
    pub period: f64,
    /// A delay of at most this may be the motion model's own, s: half of that, or all of it.
    pub own_delay: f64,
    /// Delays of a log of odometry, from where to where its likelihood is the same.
    pub flat: Vec<(Fitted, [f64; 2])>,
}
