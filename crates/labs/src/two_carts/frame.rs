//! What the two carts show.

use super::{READINGS, TwoCartsParams};
use lab::record;

record! {
    /// Two carts that are pushed alike, and what the sensor of each reads. A state is a position and a speed.
    pub struct TwoCartsFrame {
        /// Always 0: the strips show the whole run.
        pub step: u32,
        /// The parameters.
        pub params: TwoCartsParams,
        /// Where each cart starts, m and m/s.
        pub start: [[f64; 2]; 2],
        /// The positions of each, step by step, m.
        pub positions: [[f64; READINGS]; 2],
        /// What the sensor of each reads, step by step.
        pub readings: [[f64; READINGS]; 2],
        /// The largest difference between two readings of one step.
        pub difference: f64,
        /// The rank of the matrix of observability.
        pub rank: u32,
        /// The unit direction of the state that no reading shows, where there is one.
        pub unseen: Option<[f64; 2]>,
    }
}
