//! What a reader of the two carts can change.

use crate::observer_bench::Sensor;
use lab::params;

params! {
    /// What the reader can change.
    pub struct TwoCartsParams {
        /// Position of the second cart less that of the first, at the start.
        pub position: f64 = 1.0, from (-2.0) to 2.0 by 0.05 in "m";
        /// Speed of the second cart less that of the first, at the start.
        pub speed: f64 = 0.0, from (-1.0) to 1.0 by 0.05 in "m/s";
        /// What the sensor of each measures.
        pub sensor: Sensor = (Sensor::Velocity);
    }
}
