//! What a reader of a robot's log can change.

use estimate::drive::Settings;
use lab::params;

params! {
    /// What the filter is told about the robot and its sensors.
    pub struct LogParams {
        /// σ_d, of the distance driven: metres for each √second.
        pub sigma_distance: f64 = 0.05, from 0.0 to 10.0 by 0.01;
        /// σ_θ, of the turn: radians for each √second.
        pub sigma_turn: f64 = 0.02, from 0.0 to 10.0 by 0.01;
        /// σ_ρ, of a range: metres.
        pub sigma_range: f64 = 0.6, from 0.001 to 1000.0 by 0.01 in "m";
        /// σ_β, of a bearing: radians.
        pub sigma_bearing: f64 = 0.05, from 0.0001 to 10.0 by 0.01 in "rad";
        /// The probability, between 0 and 1, whose χ² quantile a sighting's d² may not exceed; null takes every
        /// sighting.
        pub gate: Option<f64> = None;
        /// ε in the expected range (1 + ε) ρ + offset, where it is not learned.
        pub scale: f64 = 0.0, from (-0.99) to 10.0 by 0.001;
        /// The offset in it, metres.
        pub offset: f64 = 0.0, from (-1000.0) to 1000.0 by 0.1 in "m";
        /// Whether ε is a fourth state of the filter.
        pub learn: bool = false;
        /// Whether sightings correct the estimate; false is dead reckoning.
        pub sightings: bool = true;
    }
}

impl From<LogParams> for Settings {
    fn from(params: LogParams) -> Self {
        let LogParams { sigma_distance, sigma_turn, sigma_range, sigma_bearing, .. } = params;
        let LogParams { gate, scale, offset, learn, sightings, .. } = params;
        Self { sigma_distance, sigma_turn, sigma_range, sigma_bearing, gate, scale, offset, learn, sightings }
    }
}
