//! What a reader who tunes the filter can change.

use lab::params;
use sim::scenarios::TUNING;

params! {
    /// What the reader can change. The log, and the noise hidden in it, follow from the seed and the length alone.
    pub struct TuneParams {
        /// The filter's q, as its decimal logarithm: it takes V = q V₀ with the chapter's V₀.
        pub log_q: f64 = 0.0, from (-TUNING.reach) to (TUNING.reach) by 0.02;
        /// The filter's W in m², as its decimal logarithm.
        pub log_w: f64 = 0.0, from (-TUNING.reach) to (TUNING.reach) by 0.02;
        /// The readings of the log. A longer log goes on where a shorter one of the same seed ends.
        pub length: u32 = 200, from 20.0 to 1000.0 by 10.0;
        /// Whether the likeliest noise is looked for.
        pub fit: bool = false;
        /// Whether the reader has committed to the settings: only then does the frame hold the truth.
        pub committed: bool = false;
        /// Fixes the hidden noise levels and all noise.
        pub seed: u32 = 1;
    }
}
