//! Every constant of every experiment with the robot, in one place.
//!
//! The book that this chapter follows prints results of runs without the constants behind them, and many sets of round
//! numbers reproduce those results. The constants here are therefore the chapter's own, round and physically plausible,
//! and the chapter prints what they give.

mod three_sensors;

pub use three_sensors::{THREE_SENSORS, ThreeSensors};

use crate::apartment::Apartment;
use crate::paths::{CORRIDOR, LOOP, Rectangle, SQUARE, Stadium};
use crate::sensor::LandmarkSensor;
use core::f64::consts::FRAC_PI_4;
use estimate::slam::linear_slam::Variances;
use estimate::{Landmark, Wheels};

/// Linear SLAM (§8.4.1): an omnidirectional robot that measures displacements to two landmarks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearSlam {
    /// A step is good to 0.1 m, a measured displacement to 0.2 m. The robot starts within 0.1 m of the map's origin,
    /// and a landmark within 2 m of it, which is as good as unknown.
    pub variances: Variances,
    /// Steps, each a prediction and then an update: enough for every limit to show.
    pub steps: u32,
}

/// The chapter's linear SLAM.
pub const LINEAR_SLAM: LinearSlam =
    LinearSlam { variances: Variances { v: 0.01, w: 0.04, p0_robot: 0.01, p0_landmark: 4.0 }, steps: 200 };

/// The Observability Probe: localization on a square in room A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// The room's side, metres; its own frame, origin in the south-west corner.
    pub room: f64,
    /// The course.
    pub course: Rectangle,
    /// Steps of the quoted run: two laps.
    pub steps: u32,
    /// The landmarks, shown one to three of them. The first two stand on one wall, which keeps an estimate from the
    /// mirror image across their line: nobody drives behind the wall.
    pub landmarks: [Landmark; 3],
    /// Process noise per tick, one sigma each of x, y (metres) and heading (radians): 1 cm and 1.7° on 0.1 m.
    pub v_sigma: [f64; 3],
    /// The sensor: 0.3 m, as from signal strength, and 2.9°; the room is within reach.
    pub sensor: LandmarkSensor,
    /// First uncertainty, one sigma each of x, y and heading; the first estimate is drawn from it.
    pub p0_sigma: [f64; 3],
}

/// The chapter's Probe.
pub const PROBE: Probe = Probe {
    room: 6.0,
    course: SQUARE,
    steps: 240,
    landmarks: [
        Landmark { id: 0, x: 6.0, y: 6.0 },
        Landmark { id: 1, x: 0.0, y: 6.0 },
        Landmark { id: 2, x: 3.0, y: 0.0 },
    ],
    v_sigma: [0.01, 0.01, 0.03],
    sensor: LandmarkSensor { range_sigma: 0.3, bearing_sigma: 0.05, reach: 12.0 },
    p0_sigma: [0.1, 0.1, 0.05],
};

/// Range–bearing SLAM (§8.4.2) on a course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeBearingSlam {
    /// The course.
    pub course: Rectangle,
    /// Poses of the quoted run.
    pub poses: u32,
    /// The true landmarks.
    pub landmarks: &'static [Landmark],
    /// The apartment whose walls hide landmarks; none in the open.
    pub home: Option<Apartment>,
    /// Noise of the input [Δs, Δθ] per tick, one sigma each, metres and radians; V = G diag(σ²) Gᵀ.
    pub u_sigma: [f64; 2],
    /// The sensor.
    pub sensor: LandmarkSensor,
    /// χ² beyond which a sighting is not a known landmark's: the 99 % quantile of two degrees of freedom.
    pub gate: f64,
    /// χ² beyond which it is a new landmark's. Far above the gate: with one threshold for both, every rejected sighting
    /// would found a ghost.
    pub found: f64,
}

/// The chapter's range–bearing SLAM: the Probe's square and landmarks, all seen at every pose, which makes 600
/// sightings, three of them founding; a sensor of 0.1 m and 1.7°. The first pose is the map's origin by definition, so
/// its P₀ is zero.
pub const RANGE_BEARING_SLAM: RangeBearingSlam = RangeBearingSlam {
    course: SQUARE,
    poses: 200,
    landmarks: &PROBE.landmarks,
    home: None,
    u_sigma: [0.02, 0.01],
    sensor: LandmarkSensor { range_sigma: 0.1, bearing_sigma: 0.03, reach: 12.0 },
    gate: 9.21,
    found: 50.0,
};

/// A loop of the corridor with a sensor of short reach: four landmarks at most are in sight at once, and the first ones
/// come into sight again at the end of a lap. The quoted run is a lap; its odometry is good to 2 cm and 0.4° a tick.
pub const LOOP_CLOSURE: RangeBearingSlam = RangeBearingSlam {
    course: CORRIDOR,
    poses: 129,
    landmarks: &WALL_MARKS,
    home: Some(Apartment::new()),
    u_sigma: [0.02, 0.007],
    sensor: LandmarkSensor { range_sigma: 0.1, bearing_sigma: 0.03, reach: 2.5 },
    gate: RANGE_BEARING_SLAM.gate,
    found: RANGE_BEARING_SLAM.found,
};

/// What the robot of [`LOOP_CLOSURE`] recognizes on the corridor's walls, from the start on around the loop.
const WALL_MARKS: [Landmark; 15] = [
    Landmark { id: 0, x: 1.5, y: -1.0 },
    Landmark { id: 1, x: 4.0, y: 1.0 },
    Landmark { id: 2, x: 6.0, y: -1.0 },
    Landmark { id: 3, x: 8.5, y: 1.0 },
    Landmark { id: 4, x: 11.0, y: -0.5 },
    Landmark { id: 5, x: 11.0, y: 2.0 },
    Landmark { id: 6, x: 9.0, y: 4.0 },
    Landmark { id: 7, x: 11.0, y: 6.5 },
    Landmark { id: 8, x: 9.0, y: 7.0 },
    Landmark { id: 9, x: 6.0, y: 5.0 },
    Landmark { id: 10, x: 4.5, y: 7.0 },
    Landmark { id: 11, x: 1.5, y: 5.0 },
    Landmark { id: 12, x: -1.0, y: 6.5 },
    Landmark { id: 13, x: 1.0, y: 3.0 },
    Landmark { id: 14, x: -1.0, y: 1.5 },
];

/// A filter with a bug in it: a robot drives laps of a stadium and sights one of three landmarks at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BugMuseum {
    /// The course.
    pub course: Stadium,
    /// Steps of a run: what is said of a run is said of these.
    pub steps: u32,
    /// The landmarks. At step k the robot looks for number k modulo 3.
    pub landmarks: [Landmark; 3],
    /// Noise of the input [Δs, Δθ] per tick, one sigma each, metres and radians; V = G diag(σ²) Gᵀ.
    pub u_sigma: [f64; 2],
    /// The sensor.
    pub sensor: LandmarkSensor,
    /// The share of readings that are wrong, as when a landmark is taken for another or an echo came by a detour: too
    /// long by one to two metres, and off by up to half a radian.
    pub outliers: f64,
    /// χ² beyond which a reading is refused.
    pub gate: f64,
    /// First uncertainty, one sigma each of x, y and heading; the first estimate is drawn from it.
    pub p0_sigma: [f64; 3],
}

/// The chapter's museum. On either straight the robot drives towards a landmark in line with it, so that the landmark's
/// bearing lies on the cut at ±π all the way; on the second the heading does so too. No landmark is within reach from
/// everywhere.
pub const BUG_MUSEUM: BugMuseum = BugMuseum {
    course: Stadium { start: [0.0, 0.0, 0.0], straight: 16, bend: 8, ds: 0.25 },
    steps: 240,
    landmarks: [
        Landmark { id: 0, x: 6.0, y: 0.0 },
        Landmark { id: 1, x: -2.0, y: 1.257 },
        Landmark { id: 2, x: 2.0, y: 2.5 },
    ],
    u_sigma: [0.02, 0.03],
    sensor: LandmarkSensor { range_sigma: 0.1, bearing_sigma: 0.03, reach: 4.0 },
    outliers: 0.05,
    gate: RANGE_BEARING_SLAM.gate,
    p0_sigma: [0.1, 0.1, 0.05],
};

/// A log of the rail robot with its position sensor (§8.2.6), whose V = q V₀ and W are to be found from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The decimal logarithms of the true q and W are drawn evenly from this far to either side of 0.
    pub hidden: f64,
    /// Those of the filter may be this far to either side.
    pub reach: f64,
}

/// The chapter's hidden noise: q and W (m²) each from a tenth to ten.
pub const TUNING: Tuning = Tuning { hidden: 1.0, reach: 2.0 };

/// The odometry hook: a lap of the corridor on encoders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hook {
    /// The course.
    pub course: Rectangle,
    /// Seconds a tick: 0.5 m/s.
    pub period: f64,
    /// A baseline of 0.40 m, wheels of 10 cm, and a common encoder of 4096 counts: 77 µm a tick.
    pub wheels: Wheels,
    /// One sigma of what a wheel slips in a tick, metres: 2 % of the way.
    pub slip: f64,
    /// The sensor: a corner is recognized from 2 m, and read once as it comes within reach.
    pub sensor: LandmarkSensor,
    /// The right wheel's nominal radius exceeds its true one by this fraction.
    pub bias: f64,
    /// First standard deviation of the bias for a filter that learns it.
    pub bias_sigma: f64,
}

/// The chapter's odometry hook.
pub const HOOK: Hook = Hook {
    course: LOOP,
    period: 0.1,
    wheels: Wheels { baseline: 0.40, radius: 0.05, ticks_per_turn: 4096.0 },
    slip: 0.001,
    sensor: LandmarkSensor { range_sigma: 0.1, bearing_sigma: 0.035, reach: 2.0 },
    bias: 0.005,
    bias_sigma: 0.01,
};

/// Choset's Problem 9 (chapter 8): one EKF step of the unicycle with a sensor of x₁, all constants his.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Problem9 {
    /// x̂(1 | 1).
    pub x: [f64; 3],
    /// P(1 | 1) is this multiple of I.
    pub p: f64,
    /// The input: here a **velocity** and a turn rate, m/s and rad/s.
    pub u: [f64; 2],
    /// The period T, seconds; the displacement is T u₁.
    pub period: f64,
    /// y(2).
    pub y: f64,
    /// Var w.
    pub w: f64,
}

/// Problem 9 as posed.
pub const PROBLEM_9: Problem9 =
    Problem9 { x: [1.0, 0.5, FRAC_PI_4], p: 1.0, u: [3.0, core::f64::consts::PI], period: 0.25, y: 1.7, w: 0.5 };

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_probe_s_landmarks_and_course_are_in_its_room() {
        assert_eq!(PROBE.room, Apartment::new().room_a().width);
        for l in PROBE.landmarks {
            assert!((0.0..=PROBE.room).contains(&l.x) && (0.0..=PROBE.room).contains(&l.y));
        }
        assert_eq!(PROBE.steps, 2 * PROBE.course.lap());
    }

    #[test]
    fn a_robot_of_short_reach_sees_one_to_four_marks_and_the_first_ones_again_after_most_of_a_lap() {
        let (home, course) = (Apartment::new(), LOOP_CLOSURE.course);
        let seen: Vec<Vec<u32>> = course
            .poses()
            .take(course.lap() as usize)
            .map(|pose| {
                let near = |l: &&Landmark| LOOP_CLOSURE.sensor.reaches(pose, l) && home.in_sight(pose, l);
                LOOP_CLOSURE.landmarks.iter().filter(near).map(|l| l.id).collect()
            })
            .collect();
        assert!(seen.iter().all(|now| (1..=4).contains(&now.len())), "{seen:?}");
        let again = seen.iter().rposition(|now| now.contains(&0)).expect("seen from the start");
        assert!(seen[30..110].iter().all(|now| !now.contains(&0) && !now.contains(&14)), "{again} {seen:?}");
    }

    #[test]
    fn the_hook_s_corners_are_seen_about_each_turn_only() {
        let home = Apartment::new();
        let seen: Vec<usize> = HOOK
            .course
            .poses()
            .take(640)
            .map(|p| home.corners.iter().filter(|c| HOOK.sensor.reaches(p, c) && home.in_sight(p, c)).count())
            .collect();
        assert!(seen.iter().all(|n| *n <= 1));
        // √3 − 1 = 0.732 m of each side is within 2 m of a corner that stands a metre aside: 14 ticks and the turn.
        assert_eq!(seen.iter().sum::<usize>(), 4 * 29);
    }
}
