//! What the late readings show.

use super::LateParams;
use lab::record;

record! {
    /// A run of the robot on its rail, 20 s long, and what the chosen filter makes of it while it drives.
    pub struct LateFrame {
        /// The parameters.
        pub params: LateParams,
        /// The end of the run, seconds.
        pub end: f64,
        /// The means, and all that is said of the whole run, are of the time from here on, seconds.
        pub settled: f64,
        /// Seconds: the times of the four lists that follow.
        pub time: Vec<f64>,
        /// x̂ − x as it was known at each time, metres.
        pub error: Vec<f64>,
        /// Twice the standard deviation of x̂ that the filter claims, metres.
        pub two_sigma: Vec<f64>,
        /// The true position, metres.
        pub position: Vec<f64>,
        /// The true speed, m/s.
        pub speed: Vec<f64>,
        /// x̂ − x of the best track afterwards, at all times but the first; empty where it is not asked for.
        pub smoothed: Vec<f64>,
        /// Twice the standard deviation that the smoother claims.
        pub smoothed_two_sigma: Vec<f64>,
        /// Sonar, laser and camera.
        pub sensors: [LateSensor; 3],
        /// The reading of the camera in hand; none where the camera reads nothing.
        pub picked: Option<LatePicked>,
        /// What each way makes of this run: as new, drop, go back.
        pub ways: [LateCost; 3],
        /// How far the estimate is behind the robot along its motion, in the mean, metres.
        pub lag: f64,
        /// v·τ: the mean speed, without its sign, times the camera's delay, metres.
        pub travelled: f64,
        /// What becomes of the estimate in the gap; none where there is none.
        pub gap: Option<LateGap>,
    }

    /// The readings of a sensor that come within the run.
    pub struct LateSensor {
        /// One standard deviation, metres.
        pub sigma: f64,
        /// Seconds from one reading to the next; 0 where it reads nothing.
        pub period: f64,
        /// When each was measured, seconds.
        pub measured: Vec<f64>,
        /// When it came, seconds.
        pub came: Vec<f64>,
        /// When the filter takes it to be of, seconds: the moment in which it came, or in which it was measured.
        pub taken: Vec<f64>,
        /// How far it is off the true position of that moment, metres.
        pub off: Vec<f64>,
        /// Whether the filter used it.
        pub used: Vec<bool>,
        /// ν of those that were used, metres, as it was when the reading came.
        pub innovation: Vec<f64>,
        /// √S of those.
        pub innovation_sigma: Vec<f64>,
        /// The mean of ν along the motion, metres; none where none was used.
        pub mean: Option<f64>,
        /// The mean of ν²/S, where 1 is expected; none where none was used.
        pub nis: Option<f64>,
    }

    /// A reading in hand.
    #[derive(Copy)]
    pub struct LatePicked {
        /// Which of the camera's it is, from 0 on.
        pub number: u32,
        /// How many there are.
        pub of: u32,
        /// When it was measured, seconds.
        pub measured: f64,
        /// When it comes, seconds; may be after the end.
        pub came: f64,
        /// Whether it is in a gap, so that it was never measured.
        pub missing: bool,
    }

    /// What a way costs.
    #[derive(Copy)]
    pub struct LateCost {
        /// The root of the mean square of x̂ − x, metres.
        pub rms: f64,
        /// The mean of NEES, where 2 is expected.
        pub nees: f64,
    }

    /// The estimate in a gap.
    #[derive(Copy)]
    pub struct LateGap {
        /// From here, seconds.
        pub from: f64,
        /// To here.
        pub to: f64,
        /// The claimed standard deviation as the gap begins, metres.
        pub sigma_before: f64,
        /// As it ends.
        pub sigma_after: f64,
        /// The largest of the smoother's within; none where the smoother is not asked for.
        pub sigma_smoothed: Option<f64>,
        /// Where in the gap that is, as a part of it.
        pub worst_place: Option<f64>,
        /// The place in the gap at which the smoother takes most off the claimed standard deviation.
        pub helped_place: Option<f64>,
    }
}
