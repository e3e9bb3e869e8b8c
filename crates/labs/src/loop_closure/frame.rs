//! What the corridor's loop shows.

use super::LoopParams;
use crate::observability_probe::{Fate, ProbeMap};
use crate::odometry_hook::World;
use estimate::Landmark;
use geom::Ellipse;
use lab::record;
use lab::series::{Series, Tracks};

record! {
    /// One picture of the loop.
    pub struct LoopFrame {
        /// Steps taken.
        pub step: u32,
        /// Whole laps driven.
        pub lap: u32,
        /// The parameters of the run.
        pub params: LoopParams,
        /// Walls, course and reach of the sensor. Its corners are not recognized here; the landmarks are.
        pub world: World,
        /// The true landmarks; the robot knows neither their places nor which is which.
        pub landmarks: &'static [Landmark],
        /// The true pose.
        pub truth: [f64; 3],
        /// The pose predicted for this step, before its sightings: what the gates are drawn about.
        pub predicted: [f64; 3],
        /// The estimated pose.
        pub estimate: [f64; 3],
        /// Its covariance, by rows.
        #[name = "P"]
        pub p: [[f64; 3]; 3],
        /// The one-sigma ellipse of its position.
        pub ellipse: Ellipse,
        /// Truth less estimate, the heading the short way round.
        pub error: [f64; 3],
        /// eᵀP⁻¹e of the pose; none where P is singular, as in the first steps.
        pub nees: Option<f64>,
        /// Its mean over the run so far: 3 for a consistent filter. It scatters widely from run to run, since
        /// neighbouring errors are nearly equal.
        pub mean_nees: Option<f64>,
        /// Where 95 % of single values of a consistent filter's NEES lie.
        pub nees_band: [f64; 2],
        /// The two thresholds in effect, and what they let through.
        pub thresholds: LoopThresholds,
        /// The gates of this step: one for each landmark of the map that is expected within reach.
        pub gates: Vec<LoopGate>,
        /// This step's sightings.
        pub sightings: Vec<LoopSighting>,
        /// The map, and how all sightings have fared.
        pub map: ProbeMap,
        /// How far the errors of two positions go together: E[eᵢ·eⱼ] / √(E|eᵢ|² E|eⱼ|²) = tr Pᵢⱼ / √(tr Pᵢᵢ tr Pⱼⱼ),
        /// from −1 to 1, the same however the axes are turned. Row and column 0 are the robot's, then come the
        /// landmarks in the order of the map. 0 where a position is known exactly.
        pub correlation: Vec<Vec<f64>>,
        /// The first sighting of a landmark that had been out of sight for half a lap.
        pub closure: Option<LoopMoment>,
        /// The last steps.
        pub series: LoopSeries,
        /// Where truth and estimate have been.
        pub tracks: Tracks,
        /// What the step that closes the loop does to each landmark that the map had before; empty at other steps.
        pub pulls: Vec<LoopPull>,
    }

    /// What the sightings of a step do to a landmark of the map.
    #[derive(Copy)]
    pub struct LoopPull {
        /// The landmark's number in the map.
        pub id: u32,
        /// Where it was believed to be before, metres.
        pub from: [f64; 2],
        /// Its one-sigma ellipse before.
        pub ellipse: Ellipse,
        /// Where it is believed to be now.
        pub to: [f64; 2],
        /// √(½ tr(P⁻ − P⁺)) = √(½ tr(R S Rᵀ)) with the landmark's rows of the gain R: how far a reading that is off by
        /// one standard deviation moves it in a coordinate, metres.
        pub reach: f64,
    }

    /// Two thresholds on the χ² axis.
    #[derive(Copy)]
    pub struct LoopThresholds {
        /// The gate in effect: the lesser of the two that were chosen.
        pub gate: f64,
        /// The threshold for founding.
        pub found: f64,
        /// The part of right sightings that a consistent filter's gate lets through, 1 − exp(−gate/2).
        pub passes: f64,
        /// The part of right sightings that would found a ghost, were there no other landmark: exp(−found/2).
        pub ghosts: f64,
    }

    /// The gate round one predicted sighting.
    pub struct LoopGate {
        /// The landmark's number in the map.
        pub id: u32,
        /// The sighting expected of it: range (m) and bearing (rad) from the landmark.
        pub expected: [f64; 2],
        /// S, the covariance of its innovation, by rows.
        #[name = "S"]
        pub s: [[f64; 2]; 2],
        /// The gate in the plane: the places where the sightings on its edge would put the landmark, seen from the
        /// predicted pose. A closed curve, its first place given once more at the end; metres.
        pub x: Vec<f64>,
        /// Metres.
        pub y: Vec<f64>,
    }

    /// One sighting.
    #[derive(Copy)]
    pub struct LoopSighting {
        /// Which of the true landmarks was seen.
        pub landmark: usize,
        /// What was read, metres.
        pub range: f64,
        /// What was read, radians, from the landmark.
        pub bearing: f64,
        /// Where it puts the landmark, seen from the predicted pose.
        pub at: [f64; 2],
        /// Its place on the χ² axis: νᵀS⁻¹ν against the landmark that it was matched to, or else against the nearest
        /// one of the map before this step. None where it found the map empty.
        pub chi2: Option<f64>,
        /// What became of it: matched, founded or rejected.
        pub outcome: Fate,
        /// Where the landmark it was taken for is believed to be after this step.
        pub to: Option<[f64; 2]>,
    }

    /// When the loop was closed, and what that did to the map.
    #[derive(Copy)]
    pub struct LoopMoment {
        /// The step.
        pub step: u32,
        /// Which of the true landmarks was seen again.
        pub landmark: usize,
        /// The mean standard deviation of the map's landmarks in a coordinate before this step's sightings, metres.
        pub before: f64,
        /// The same after them.
        pub after: f64,
    }

    /// Numbers over the last steps; NaN where there is none.
    #[derive(Default)]
    pub struct LoopSeries {
        /// The step of each entry.
        pub step: Series,
        /// NEES of the pose.
        pub nees: Series,
        /// The distance from the true position, metres.
        pub error: Series,
        /// The standard deviation of the position in a coordinate, √(½ tr P), as claimed; metres.
        pub sigma: Series,
        /// The mean of the same over the landmarks of the map.
        pub map_sigma: Series,
        /// χ² of each of the last sightings, one entry for a sighting.
        pub chi2: Series,
    }
}
