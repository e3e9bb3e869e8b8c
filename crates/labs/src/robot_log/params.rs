//! What a reader of a robot's log can change.

use estimate::drive::{BySensor, Delays, Settings};
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
        /// σ_P, of a fix that has none of its own: metres.
        pub sigma_fix: f64 = 1.0, from 0.0001 to 100000.0 by 0.1 in "m";
        /// σ_H, of a heading that has none of its own: radians.
        pub sigma_heading: f64 = 0.05, from 0.0001 to 100.0 by 0.01 in "rad";
        /// By how much the σ that a fix brings is multiplied.
        pub fix_sigma_scale: f64 = 1.0, from 0.0001 to 10000.0 by 0.1;
        /// By how much the σ that a heading brings is multiplied.
        pub heading_sigma_scale: f64 = 1.0, from 0.0001 to 10000.0 by 0.1;
        /// The standard deviation of x and of y at the start: metres.
        pub start_sigma: f64 = 0.2, from 0.0001 to 1000000.0 by 0.1 in "m";
        /// The standard deviation of the heading at the start: radians.
        pub start_sigma_heading: f64 = 0.1, from 0.0001 to 100.0 by 0.01 in "rad";
        /// The pose [x, y, θ] at the start of a log without truth; null is the origin.
        pub start: Option<[f64; 3]> = None;
        /// The probability, between 0 and 1, whose χ² quantile a reading's d² may not exceed; null takes every
        /// reading. One value for all sensors, or an object by sensor, where one that is left out has null.
        pub gate: BySensor<Option<f64>> = (BySensor::all(None));
        /// A reading is passed over that is stamped less than this after the last of its sensor that was not: seconds.
        /// One value for all sensors, or an object by sensor, where one that is left out has 0. Default 0.
        pub every: BySensor<f64> = (BySensor::all(0.0)), from 0.0 to 100000.0 by 0.1 in "s";
        /// ε in the expected range (1 + ε) ρ + offset, where it is not learned.
        pub scale: f64 = 0.0, from (-0.99) to 10.0 by 0.001;
        /// The offset in it, metres.
        pub offset: f64 = 0.0, from (-1000.0) to 1000.0 by 0.1 in "m";
        /// What a bearing reads of a landmark straight ahead: radians.
        pub bearing_offset: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "rad";
        /// What a compass reads of a robot that heads along the axis of x: radians.
        pub heading_offset: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "rad";
        /// How far ahead of the point about which the robot turns the antenna of the fixes stands: metres.
        pub antenna_ahead: f64 = 0.0, from (-100.0) to 100.0 by 0.05 in "m";
        /// How far to its left.
        pub antenna_left: f64 = 0.0, from (-100.0) to 100.0 by 0.05 in "m";
        /// Whether ε is a state of the filter.
        pub learn: bool = false;
        /// Whether sightings correct the estimate.
        pub sightings: bool = true;
        /// Whether fixes do.
        pub fixes: bool = true;
        /// Whether headings do.
        pub headings: bool = true;
        /// How late speeds are: a row stamped t was measured at t less this. Seconds.
        pub delay_speed: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "s";
        /// How late turn rates are.
        pub delay_turn: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "s";
        /// How late fixes are.
        pub delay_fix: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "s";
        /// How late headings are.
        pub delay_heading: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "s";
        /// How late ranges are, with or without a bearing.
        pub delay_sighting: f64 = 0.0, from (-10.0) to 10.0 by 0.01 in "s";
        /// κ, where it is not learned: the robot drives (1 + κ) times the speed that is read.
        pub speed_scale: f64 = 0.0, from (-0.99) to 10.0 by 0.001;
        /// b, where it is not learned: the robot turns by the rate that is read less b. Radians a second.
        pub turn_bias: f64 = 0.0, from (-10.0) to 10.0 by 0.001 in "rad/s";
        /// Whether κ is a state of the filter.
        pub learn_speed: bool = false;
        /// Whether b is a state of the filter.
        pub learn_bias: bool = false;
        /// Fixes stamped between these two times, by the log's own clock, do not correct the estimate; null withholds
        /// none.
        pub withheld: Option<[f64; 2]> = None;
    }
}

impl From<LogParams> for Settings {
    fn from(params: LogParams) -> Self {
        let LogParams { sigma_distance, sigma_turn, sigma_range, sigma_bearing, sigma_fix, sigma_heading, .. } = params;
        let LogParams { fix_sigma_scale, heading_sigma_scale, .. } = params;
        let LogParams { start_sigma, start_sigma_heading, start, gate, every, withheld, .. } = params;
        let LogParams { scale, offset, bearing_offset, heading_offset, learn, sightings, fixes, headings, .. } = params;
        let LogParams { speed_scale, turn_bias, learn_speed, learn_bias, .. } = params;
        let delays = Delays {
            speed: params.delay_speed,
            turn: params.delay_turn,
            fix: params.delay_fix,
            heading: params.delay_heading,
            sighting: params.delay_sighting,
        };
        Self {
            sigma_distance,
            sigma_turn,
            sigma_range,
            sigma_bearing,
            sigma_fix,
            sigma_heading,
            fix_sigma_scale,
            heading_sigma_scale,
            start_sigma,
            start_sigma_heading,
            start,
            gate,
            every,
            scale,
            offset,
            bearing_offset,
            heading_offset,
            antenna: [params.antenna_ahead, params.antenna_left],
            learn,
            sightings,
            fixes,
            headings,
            delays,
            speed_scale,
            turn_bias,
            learn_speed,
            learn_bias,
            withheld,
        }
    }
}
