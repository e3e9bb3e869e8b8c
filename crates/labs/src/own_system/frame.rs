//! What a view draws of a system of the reader's own.

use super::params::OwnParams;
use estimate::{Complex, RiccatiLimit, Verdict};
use lab::record;
use lab::series::Series;

/// So many lists there are at least: there were no more when the first links were made.
const LISTS: usize = 4;

impl OwnSeries {
    /// Empty ones, for so many states and readings.
    pub(super) fn of(states: usize, readings: usize) -> Self {
        let [n, p] = [states, readings].map(|count| count.max(LISTS));
        let each = || vec![Series::default(); n];
        Self {
            step: Series::default(),
            truth: each(),
            estimate: each(),
            variance: each(),
            sigma: each(),
            gain: vec![vec![Series::default(); p]; n],
        }
    }
}

record! {
    /// A system, what can be known of it, and a simulated run.
    pub struct OwnFrame {
        /// Steps since the start.
        pub step: u32,
        /// What the reader has set.
        pub params: OwnParams,
        /// The tolerance.
        pub tolerance: f64,
        /// The rank of [H; HF; …; HFⁿ⁻¹] under the tolerance.
        pub rank: OwnRank,
        /// Whether every direction of the state is seen.
        pub observable: Verdict,
        /// Whether every direction that is not seen dies out by itself.
        pub detectable: Verdict,
        /// Whether the entries of F and H, each known to within the tolerance as a part of itself, let every direction
        /// be seen, though some are so small beside others that a direction counts as unseen.
        pub badly_scaled: bool,
        /// The eigenvalues of F along the unseen directions, by decreasing modulus.
        pub unseen_modes: Vec<Complex<f64>>,
        /// What noise reaches.
        pub noise: OwnReach,
        /// What the inputs reach.
        pub input: OwnReach,
        /// Whether P(k+1 | k) tends to a limit.
        pub limit: RiccatiLimit,
        /// The step at which P and R no longer changed, to twelve digits, from this start; null where they went on to
        /// change.
        pub settled: Option<u32>,
        /// How many steps were tried for that; null where P grew beyond every number before.
        pub tried: Option<u32>,
        /// The limit of P(k+1 | k) from this start, by rows; null where it has none.
        #[name = "limitP"]
        pub limit_p: Option<Vec<Vec<f64>>>,
        /// What doubling the steps says of the limit.
        pub doubled: OwnLimit,
        /// Steps until P(k+1 | k) is within 1 % of its limit from this start, or, where that is 0, until 1 % is left;
        /// null where it has none, or comes to it only later than numbers tell.
        pub near: Option<f64>,
        /// Whether it comes ever more slowly, as the variance of an average does.
        pub slowly: bool,
        /// F over a step, by rows: as given, or sampled.
        #[name = "F"]
        pub f: Vec<Vec<f64>>,
        /// G over a step, by rows.
        #[name = "G"]
        pub g: Vec<Vec<f64>>,
        /// V over a step, by rows.
        #[name = "V"]
        pub v: Vec<Vec<f64>>,
        /// Whether F, taken as what one step does, looks like one of a differential equation.
        pub looks_like_rates: bool,
        /// The gain whose eigenvalues are shown, n×p by rows: the filter's limit, the reader's, or the one that places
        /// the poles.
        #[name = "K"]
        pub k: Vec<Vec<f64>>,
        /// The eigenvalues of (I − KH)F with that gain.
        pub eigenvalues: Vec<OwnEigenvalue>,
        /// The largest modulus among them.
        pub spectral_radius: f64,
        /// How fast each of them dies out, in the same order.
        pub decay: Vec<OwnDecay>,
        /// Steps of a run in which the slowest of those that die out is down to 5 %, as far as a reader can wait.
        pub run_length: u32,
        /// How many eigenvalues a gain can move.
        pub movable: u32,
        /// Whether a gain was found that puts the poles where they are wanted; null where the gain comes otherwise.
        pub placed: Option<bool>,
        /// Whether the run has left every bound and stands still.
        pub diverged: bool,
        /// Whether the filter's numbers since the start are right to six digits.
        pub conditioned: bool,
        /// The true state.
        pub truth: Vec<f64>,
        /// The estimate, x̂(k | k).
        pub estimate: Vec<f64>,
        /// Its covariance, P(k | k), by rows; what the gain in use makes of it.
        #[name = "P"]
        pub p: Vec<Vec<f64>>,
        /// The filter's gain at this step, R(k), n×p by rows; null before the first step.
        #[name = "R"]
        pub r: Option<Vec<Vec<f64>>>,
        /// The last readings; null before the first step.
        pub reading: Option<Vec<f64>>,
        /// The last steps.
        pub series: OwnSeries,
    }

    /// The rank test.
    pub struct OwnRank {
        /// The rank.
        pub rank: u32,
        /// The singular values, in decreasing order.
        pub singular_values: Vec<f64>,
        /// Each as a part of the largest; the tolerance is held against these.
        pub relative: Vec<f64>,
        /// The directions of the state that count as unseen, each with a 1 in one place where the others have 0.
        pub directions: Vec<Vec<f64>>,
    }

    /// What noise or inputs reach.
    pub struct OwnReach {
        /// Whether they move every combination of the states.
        pub reachable: Verdict,
        /// Whether every combination that they do not move dies out by itself.
        pub stabilizable: Verdict,
        /// The combinations of the states that count as not moved, each with a 1 in one place where the others have 0.
        pub unreached: Vec<Vec<f64>>,
    }

    /// Where doubling the steps leads P(k+1 | k) and the filter's gain.
    #[derive(Copy)]
    pub struct OwnLimit {
        /// Whether P has a limit from this start.
        pub converged: bool,
        /// Whether the gain has.
        pub gain_converged: bool,
        /// Whether a larger start has another limit.
        pub depends_on_start: bool,
        /// Steps until they no longer change: a power of two and a few more.
        pub steps: f64,
        /// Whether P falls as the variance of an average does, by its own inverse count: the error of the limit gain
        /// takes longer to die out than P to come to rest.
        pub averages: bool,
        /// Whether a part of P falls so beside what grows, turns or rests, and no limit of P as a whole is found.
        pub part: bool,
        /// Whether P grows without end from every start: noise feeds what no reading tells.
        pub grows: bool,
    }

    /// How fast an error dies out.
    #[derive(Copy)]
    pub struct OwnDecay {
        /// Steps until 5 % of it are left; null where it does not die out.
        pub steps: Option<f64>,
        /// Its time constant in seconds; null where it has none or a step's length is not known.
        pub seconds: Option<f64>,
    }

    /// An eigenvalue of (I − KH)F.
    #[derive(Copy)]
    pub struct OwnEigenvalue {
        /// Real part.
        pub re: f64,
        /// Imaginary part.
        pub im: f64,
        /// Its modulus.
        pub modulus: f64,
        /// Whether no gain moves it.
        pub fixed: bool,
    }

    /// The last steps, oldest first, or of several steps one; the lists of states and readings that the system lacks
    /// are empty.
    #[derive(Default)]
    pub struct OwnSeries {
        /// Steps.
        pub step: Series,
        /// The true state.
        pub truth: Vec<Series>,
        /// The estimate.
        pub estimate: Vec<Series>,
        /// The diagonal of P(k | k).
        pub variance: Vec<Series>,
        /// Its square roots.
        pub sigma: Vec<Series>,
        /// The filter's gain R(k): a row for each state, an entry for each reading.
        pub gain: Vec<Vec<Series>>,
    }
}
