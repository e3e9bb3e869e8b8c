//! What a reader of the two bells can change.

use crate::picture::{FIRST_READING, FIRST_STEP};
use lab::params;

params! {
    /// What the reader can change: two opinions about one velocity. They begin as those of the first hand-checked step.
    pub struct TwoBellsParams {
        /// What the prediction expects, Hx̂⁻.
        pub expected: f64 = 4.0, from 0.0 to 7.0 by 0.05 in "m/s";
        /// Its variance, HP⁻Hᵀ.
        pub expected_variance: f64 = (FIRST_STEP[(1, 1)]), from 0.05 to 4.0 by 0.05;
        /// The reading y.
        pub reading: f64 = FIRST_READING, from 0.0 to 7.0 by 0.05 in "m/s";
        /// Its variance, W.
        pub noise: f64 = 0.5, from 0.05 to 4.0 by 0.05;
    }
}
