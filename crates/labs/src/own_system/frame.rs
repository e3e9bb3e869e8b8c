//! What a view draws of a system of the reader's own.

use super::params::OwnParams;
use estimate::{Complex, RiccatiLimit, Verdict};
use lab::record;
use lab::series::Series;

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
        /// P(k+1 | k) when it settled, by rows; null where it did not.
        #[name = "limitP"]
        pub limit_p: Option<Vec<Vec<f64>>>,
        /// The gain whose eigenvalues are shown, n×p by rows: the filter's last, the reader's, or the one that places
        /// the poles.
        #[name = "K"]
        pub k: Vec<Vec<f64>>,
        /// The eigenvalues of (I − KH)F with that gain.
        pub eigenvalues: Vec<OwnEigenvalue>,
        /// The largest modulus among them.
        pub spectral_radius: f64,
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

    /// The last steps, oldest first; the lists of states and readings that the system lacks are empty.
    #[derive(Default)]
    pub struct OwnSeries {
        /// Steps.
        pub step: Series,
        /// The true state.
        pub truth: [Series; 4],
        /// The estimate.
        pub estimate: [Series; 4],
        /// The diagonal of P(k | k).
        pub variance: [Series; 4],
        /// Its square roots.
        pub sigma: [Series; 4],
        /// The filter's gain R(k): a row for each state, an entry for each reading.
        pub gain: [[Series; 4]; 4],
    }
}
