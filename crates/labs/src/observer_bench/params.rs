//! What a reader of the Bench can change.

use lab::{params, words};

words! {
    /// What the sensor measures.
    pub enum Sensor {
        /// H = [0 1].
        Velocity = "velocity",
        /// H = [1 0].
        Position = "position",
    }
}

words! {
    /// Who chooses the gain.
    pub enum Mode {
        /// The reader: K = g · R∞ at every step.
        Fixed = "fixed",
        /// The filter: K = R(k).
        Filter = "filter",
    }
}

params! {
    /// What the reader can change.
    pub struct BenchParams {
        /// What the sensor measures.
        pub sensor: Sensor = (Sensor::Velocity);
        /// Who chooses the gain.
        pub mode: Mode = (Mode::Fixed);
        /// The knob g in K = g · R∞. It goes past divergence with either sensor.
        pub gain: f64 = 1.0, from 0.0 to 6.0 by 0.01;
        /// Fixes truth and readings.
        pub seed: u32 = 1;
    }
}
