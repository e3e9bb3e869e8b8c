//! What the car's log shows.

use super::CarParams;
use lab::record;
use lab::series::Track;

record! {
    /// The whole drive under the reader's settings.
    pub struct CarFrame {
        /// The parameters.
        pub params: CarParams,
        /// The estimated course.
        pub estimate: Track,
        /// The course by speeds and turn rates alone.
        pub reckoning: Track,
        /// The smoothed course; empty where there is no tunnel.
        pub smoothed: Track,
        /// Fixes that corrected the estimate, or some of them.
        pub fixes: CarPlaces,
        /// Fixes beyond the gate.
        pub refused: CarPlaces,
        /// Fixes that were withheld.
        pub withheld: CarPlaces,
        /// Seconds: the times of the innovations that follow.
        pub time: Vec<f64>,
        /// ν/√S of the fixes along the estimated heading.
        pub along: Vec<f64>,
        /// How far the course by speeds and turn rates alone is off a fix at worst, metres.
        pub reckoned_off: f64,
        /// Fixes that corrected the estimate.
        pub used: u32,
        /// Fixes beyond the gate.
        pub refusals: u32,
        /// The mean of NIS for each output, where 1 is expected; none where no fix was used.
        pub nis: Option<f64>,
        /// The autocorrelation of the innovations of x from one used fix to the next.
        pub lag1: Option<f64>,
        /// The log-likelihood of the used fixes.
        pub log_likelihood: Option<f64>,
        /// What is learned; none where nothing is.
        pub learned: Option<CarLearned>,
        /// How far the track is from the withheld fixes; none where none is withheld.
        pub tunnel: Option<CarTunnel>,
    }

    /// Places in the plane.
    #[derive(Default)]
    pub struct CarPlaces {
        /// Metres.
        pub x: Vec<f64>,
        /// Metres.
        pub y: Vec<f64>,
    }

    /// What the filter has learned of the car's sensors.
    #[derive(Copy)]
    pub struct CarLearned {
        /// κ: the car drives (1 + κ) times the speed that is read.
        pub speed_scale: f64,
        /// Its standard deviation.
        pub speed_scale_sigma: f64,
        /// b: the car turns by the rate that is read less b, rad/s.
        pub turn_bias: f64,
        /// Its standard deviation.
        pub turn_bias_sigma: f64,
    }

    /// The distance from the withheld fixes.
    #[derive(Copy)]
    pub struct CarTunnel {
        /// How many were withheld.
        pub rows: u32,
        /// Of the filter, the root of the mean square, metres.
        pub rms: f64,
        /// Of the filter at worst.
        pub worst: f64,
        /// The same of the smoothed track.
        pub rms_smoothed: Option<f64>,
        /// At worst.
        pub worst_smoothed: Option<f64>,
    }
}
