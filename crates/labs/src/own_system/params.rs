//! What a reader sets of a system of the reader's own.

use lab::{UpTo, params, words};

/// The most states that a system may have here.
pub const MOST: usize = 9;
/// A matrix of at most nine rows and columns.
pub type Entries = UpTo<UpTo<f64, 4, MOST>, 4, MOST>;

/// A matrix with zeros for what is not given.
fn entries<const M: usize, const N: usize>(rows: [[f64; N]; M]) -> Entries {
    rows.map(UpTo::from).into()
}

words! {
    /// Who chooses the gain.
    pub enum GainBy {
        /// The Kalman filter: its gain at each step, and the limit of that gain for the eigenvalues.
        Filter = "filter",
        /// The reader, entry by entry.
        Hand = "hand",
        /// The eigenvalues that the reader wants.
        Placement = "placement",
    }
}

params! {
    /// A linear system of at most nine states, eight inputs and eight readings, how it is filtered, and how it is
    /// simulated. Only the first rows and columns count, as many as there are states, inputs and readings.
    pub struct OwnParams {
        /// The seed of the noise.
        pub seed: u32 = 1;
        /// How many states.
        pub states: u32 = 2, from 1.0 to 9.0 by 1.0;
        /// How many inputs.
        pub inputs: u32 = 1, from 0.0 to 8.0 by 1.0;
        /// How many readings a step.
        pub readings: u32 = 1, from 1.0 to 8.0 by 1.0;
        /// F: what a step does to the state.
        pub f: Entries = (entries([[1.0, 0.5], [0.0, 1.0]]));
        /// G: what an input does in a step.
        pub g: Entries = (entries([[0.125], [0.5]]));
        /// H: what a reading tells.
        pub h: Entries = (entries([[1.0, 0.0]]));
        /// V: the covariance of a step's noise.
        pub v: Entries = (entries([[0.0015625, 0.00625], [0.00625, 0.025]]));
        /// W: the covariance of a reading's noise.
        pub w: Entries = (entries([[0.5]]));
        /// The variance of each state at the start; P(0 | 0) is so many times I, or the spread.
        pub start: f64 = 1.0, from 0.0 to 1000000.0 by 0.1;
        /// The decimal logarithm of the tolerance: how well the numbers are known.
        pub log_tolerance: f64 = (-9.0), from (-14.0) to (-1.0) by 0.1;
        /// Who chooses the gain.
        pub gain: GainBy = (GainBy::Filter);
        /// K, the gain chosen by hand.
        pub k: Entries = (Entries::default());
        /// The eigenvalues wanted, real and imaginary part. One off the real line takes the place of the next one for
        /// its conjugate.
        pub poles: UpTo<[f64; 2], 4, MOST> = ([[0.5, 0.0], [0.2, 0.0], [0.6, 0.0], [0.3, 0.0]].into()),
            from (-2.0) to 2.0 by 0.01;
        /// The size of each input in the simulation. Its sign changes every twenty steps.
        pub input: f64 = 0.0, from (-10.0) to 10.0 by 0.1;
        /// Which state the plots show, counted from 1; the last where there are fewer.
        pub shown: u32 = 1, from 1.0 to 9.0 by 1.0;
        /// The names of the states: the Unicode numbers of at most twelve letters, then zeros; zeros alone for x₁, x₂,
        /// …
        pub names: UpTo<[u32; 12], 4, MOST> = ([[0; 12]; 4].into());
        /// The variance of each state at the start, as a part of `start`: P(0 | 0) is start · diag(spread).
        pub spread: UpTo<f64, 4, MOST> = ([1.0; MOST].into()), from 0.0 to 1e12 by 0.1;
        /// How long a step lasts; 0 where that is not known.
        pub period: f64 = 0.0, from 0.0 to 1000000.0 by 0.001 in "s";
        /// Whether F, G and V are of continuous time: what moves the state in a second, and the density of its noise.
        /// They are then sampled with the period.
        pub continuous: bool = false;
        /// Of so many steps the plots keep one.
        pub every: u32 = 1, from 1.0 to 1000.0 by 1.0;
    }
}
