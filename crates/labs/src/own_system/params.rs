//! What a reader sets of a system of the reader's own.

use lab::{params, words};

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
    /// A linear system of at most four states, inputs and readings, how it is filtered, and how it is simulated. Only
    /// the first rows and columns count, as many as there are states, inputs and readings.
    pub struct OwnParams {
        /// The seed of the noise.
        pub seed: u32 = 1;
        /// How many states.
        pub states: u32 = 2, from 1.0 to 4.0 by 1.0;
        /// How many inputs.
        pub inputs: u32 = 1, from 0.0 to 4.0 by 1.0;
        /// How many readings a step.
        pub readings: u32 = 1, from 1.0 to 4.0 by 1.0;
        /// F: what a step does to the state.
        pub f: [[f64; 4]; 4] = ([[1.0, 0.5, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0; 4], [0.0; 4]]);
        /// G: what an input does in a step.
        pub g: [[f64; 4]; 4] = ([[0.125, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]]);
        /// H: what a reading tells.
        pub h: [[f64; 4]; 4] = ([[1.0, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4], [0.0; 4]]);
        /// V: the covariance of a step's noise.
        pub v: [[f64; 4]; 4] = ([[0.0015625, 0.00625, 0.0, 0.0], [0.00625, 0.025, 0.0, 0.0], [0.0; 4], [0.0; 4]]);
        /// W: the covariance of a reading's noise.
        pub w: [[f64; 4]; 4] = ([[0.5, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4], [0.0; 4]]);
        /// The variance of each state at the start; P(0 | 0) is so many times I.
        pub start: f64 = 1.0, from 0.0 to 1000000.0 by 0.1;
        /// The decimal logarithm of the tolerance: how well the numbers are known.
        pub log_tolerance: f64 = (-9.0), from (-14.0) to (-1.0) by 0.1;
        /// Who chooses the gain.
        pub gain: GainBy = (GainBy::Filter);
        /// K, the gain chosen by hand.
        pub k: [[f64; 4]; 4] = ([[0.0; 4]; 4]);
        /// The eigenvalues wanted, real and imaginary part. One off the real line takes the place of the next one for
        /// its conjugate.
        pub poles: [[f64; 2]; 4] = ([[0.5, 0.0], [0.2, 0.0], [0.6, 0.0], [0.3, 0.0]]), from (-2.0) to 2.0 by 0.01;
        /// The size of each input in the simulation. Its sign changes every twenty steps.
        pub input: f64 = 0.0, from (-10.0) to 10.0 by 0.1;
        /// Which state the plots show, counted from 1; the last where there are fewer.
        pub shown: u32 = 1, from 1.0 to 4.0 by 1.0;
        /// The names of the states: the Unicode numbers of at most twelve letters, then zeros; zeros alone for x₁, x₂,
        /// …
        pub names: [[u32; 12]; 4] = ([[0; 12]; 4]);
    }
}
