//! What the Bench shows.

use super::BenchParams;
use crate::shapes::BenchBelief;
use estimate::Complex;
use lab::record;
use lab::series::Series;

/// How many of the last steps the Bench draws.
pub const DRAWN: usize = 120;

record! {
    /// One picture of the bench.
    pub struct BenchFrame {
        /// Steps taken.
        pub step: u32,
        /// Seconds since the start.
        pub time: f64,
        /// The parameters of the run.
        pub params: BenchParams,
        /// The run left every reasonable bound and stands still.
        pub diverged: bool,
        /// The true state, m and m/s.
        pub truth: [f64; 2],
        /// y, absent at step 0.
        pub reading: Option<f64>,
        /// x̂(k+1 | k), P(k+1 | k).
        pub predicted: BenchBelief,
        /// x̂(k+1 | k+1), P(k+1 | k+1).
        pub posterior: BenchBelief,
        /// ν = y − H x̂(k+1 | k).
        pub innovation: Option<f64>,
        /// S = H P(k+1 | k) Hᵀ + W.
        #[name = "S"]
        pub s: Option<f64>,
        /// The gain used in this step (in the next one, at step 0).
        #[name = "R"]
        pub r: [f64; 2],
        /// R(k), the filter's gain at this step.
        pub filter_gain: [f64; 2],
        /// R∞ of this sensor.
        pub steady_gain: [f64; 2],
        /// H, its one row.
        #[name = "H"]
        pub h: [f64; 2],
        /// y*, the most likely output.
        pub most_likely_output: Option<f64>,
        /// The points of Ω nearest to the prediction.
        pub feet: Option<Feet>,
        /// Of (I − KH)F, by decreasing modulus.
        pub eigenvalues: [Complex<f64>; 2],
        /// The modulus of each.
        pub modulus: [f64; 2],
        /// Which of them a gain can move and has moved out of the unit disc.
        pub outside: [bool; 2],
        /// The larger modulus.
        pub spectral_radius: f64,
        /// Which eigenvalue no gain moves, if any.
        pub pinned: Option<usize>,
        /// Every eigenvalue that a gain can move is inside the unit disc.
        pub stable: bool,
        /// The knob at which the last movable eigenvalue leaves the disc, through −1.
        pub stable_up_to: f64,
        /// HK / HR∞: the setting of the knob that takes over the same share of the innovation as the gain in use.
        pub equivalent_knob: f64,
        /// The last steps.
        pub series: BenchSeries,
        /// The belief that the run begins with.
        pub first: BenchBelief,
    }

    /// The two nearest points of Ω.
    #[derive(Copy)]
    pub struct Feet {
        /// In the Euclidean metric.
        pub euclidean: [f64; 2],
        /// In the metric of P(k+1 | k).
        pub mahalanobis: [f64; 2],
    }

    /// Numbers over the last steps.
    #[derive(Default)]
    pub struct BenchSeries {
        /// The step of each entry.
        pub step: Series<DRAWN>,
        /// First entry of the gain in use.
        pub r1: Series<DRAWN>,
        /// Second entry of the gain in use.
        pub r2: Series<DRAWN>,
        /// Position variance after the update, m².
        pub p11: Series<DRAWN>,
        /// Velocity variance after the update, m²/s².
        pub p22: Series<DRAWN>,
        /// Position error, m.
        pub e1: Series<DRAWN>,
        /// Velocity error, m/s.
        pub e2: Series<DRAWN>,
        /// The equivalent knob of the gain in use.
        pub knob: Series<DRAWN>,
    }
}
