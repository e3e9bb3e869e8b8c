//! The robot whose readings come late.

/// A robot on a rail with three sensors of its position: one fast and coarse, one slow and fine, one fine and late.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreeSensors {
    /// Seconds a tick; every reading is measured at a tick, and comes at one.
    pub tick: f64,
    /// Ticks of a run.
    pub ticks: usize,
    /// The speed at the start, m/s.
    pub speed: f64,
    /// Seconds from one turn to the next but one, where the robot drives to and fro.
    pub round: f64,
    /// The density of the acceleration's noise, m²/s³.
    pub q: f64,
    /// One sigma of each sensor, metres: sonar, laser, camera.
    pub sigma: [f64; 3],
    /// First uncertainty, one sigma each of position and speed; the true start is drawn from it.
    pub p0_sigma: [f64; 2],
    /// What is said of a run is said of the time from here on, seconds: the start is forgotten by then.
    pub settled: f64,
}

/// The chapter's three sensors. In two seconds without a reading the noise of the motion alone makes 0.16 m, three
/// times what the two fine sensors are wrong by.
pub const THREE_SENSORS: ThreeSensors = ThreeSensors {
    tick: 0.05,
    ticks: 400,
    speed: 1.0,
    round: 10.0,
    q: 0.01,
    sigma: [0.5, 0.05, 0.05],
    p0_sigma: [0.1, 0.1],
    settled: 5.0,
};
