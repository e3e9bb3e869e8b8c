//! What a reader of the corridor's loop can change.

use lab::params;
use sim::scenarios::LOOP_CLOSURE;

params! {
    /// What the reader can change.
    pub struct LoopParams {
        /// A sighting whose χ² is above this for a landmark is not taken for it.
        pub gate: f64 = (LOOP_CLOSURE.gate), from 0.5 to 100.0 by 0.01;
        /// A sighting whose χ² is above this for every landmark founds a new one. Below the gate it is the gate too: a
        /// sighting cannot be of a known landmark and of a new one.
        pub found: f64 = (LOOP_CLOSURE.found), from 0.5 to 100.0 by 0.01;
        /// Whether the filter keeps the cross-covariances of robot and landmarks; without them each is on its own after
        /// every step, which is wrong.
        pub correlated: bool = true;
        /// Fixes all noise.
        pub seed: u32 = 1;
    }
}
