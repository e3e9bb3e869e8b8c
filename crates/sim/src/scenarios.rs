//! Every constant of every experiment with the robot, in one place.
//!
//! The book that this chapter follows prints results of runs without the constants behind them, and many sets of round
//! numbers reproduce those results. The constants here are therefore the chapter's own, round and physically plausible, and the
//! chapter prints what they give.

use crate::paths::{LOOP, Rectangle, SQUARE};
use crate::sensor::Sensor;
use core::f64::consts::FRAC_PI_4;
use estimate::slam::linear_slam::Variances;
use estimate::{Landmark, Wheels};

/// Linear SLAM (§8.4.1): an omnidirectional robot that measures displacements to two landmarks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearSlam {
    /// A step is good to 0.1 m, a measured displacement to 0.2 m. The robot starts within 0.1 m of the map's origin, and
    /// a landmark within 2 m of it, which is as good as unknown.
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
    pub sensor: Sensor,
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
    sensor: Sensor { range_sigma: 0.3, bearing_sigma: 0.05, reach: 12.0 },
    p0_sigma: [0.1, 0.1, 0.05],
};

/// Range–bearing SLAM (§8.4.2) on the Probe's square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeBearingSlam {
    /// The course.
    pub course: Rectangle,
    /// Poses at which all landmarks are seen: 600 sightings, three of them founding.
    pub poses: u32,
    /// The true landmarks: the Probe's.
    pub landmarks: [Landmark; 3],
    /// Noise of the input [Δs, Δθ] per tick, one sigma each, metres and radians; V = G diag(σ²) Gᵀ.
    pub u_sigma: [f64; 2],
    /// The sensor: 0.1 m and 1.7°.
    pub sensor: Sensor,
    /// χ² beyond which a sighting is not a known landmark's: the 99 % quantile of two degrees of freedom.
    pub gate: f64,
    /// χ² beyond which it is a new landmark's. Far above the gate: with one threshold for both, every rejected sighting
    /// would found a ghost.
    pub found: f64,
}

/// The chapter's range–bearing SLAM. The first pose is the map's origin by definition, so its P₀ is zero.
pub const RANGE_BEARING_SLAM: RangeBearingSlam = RangeBearingSlam {
    course: SQUARE,
    poses: 200,
    landmarks: PROBE.landmarks,
    u_sigma: [0.02, 0.01],
    sensor: Sensor { range_sigma: 0.1, bearing_sigma: 0.03, reach: 12.0 },
    gate: 9.21,
    found: 50.0,
};

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
    pub sensor: Sensor,
    /// The right wheel's nominal radius exceeds its true one by this fraction.
    pub bias: f64,
}

/// The chapter's odometry hook.
pub const HOOK: Hook = Hook {
    course: LOOP,
    period: 0.1,
    wheels: Wheels { baseline: 0.40, radius: 0.05, ticks_per_turn: 4096.0 },
    slip: 0.001,
    sensor: Sensor { range_sigma: 0.1, bearing_sigma: 0.035, reach: 2.0 },
    bias: 0.005,
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
    use crate::Apartment;

    #[test]
    fn the_probe_s_landmarks_and_course_are_in_its_room() {
        assert_eq!(PROBE.room, Apartment::new().room_a().width);
        for l in PROBE.landmarks {
            assert!((0.0..=PROBE.room).contains(&l.x) && (0.0..=PROBE.room).contains(&l.y));
        }
        assert_eq!(PROBE.steps, 2 * PROBE.course.lap());
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
