//! What the odometry hook shows: its frame, and the bounded memory behind it.

use super::HookParams;
use crate::shapes::{ellipse_of, rows};
use estimate::Landmark;
use estimate::kf::Gaussian;
use geom::{Ellipse, SE2};
use lab::record;
use lab::series::{Series, Tracks, keep};
use nalgebra::U3;
use sim::scenarios::HOOK;
use sim::{Apartment, Room};
use std::collections::VecDeque;

/// Poses kept in a track: one lap and its start.
const TRACK: usize = 641;
/// Ticks from one kept ellipse to the next.
const TRAIL_EVERY: u32 = 40;
/// Ellipses kept: those of one lap.
const TRAIL: usize = 17;
/// Ticks from one point of the series to the next, so that its window spans a lap and a half.
const SERIES_EVERY: u32 = 4;

record! {
    /// One picture of the hook. Lengths are metres, angles radians.
    pub struct HookFrame {
        /// Ticks driven.
        pub step: u32,
        /// Seconds since the start.
        pub time: f64,
        /// Whole laps driven.
        pub lap: u32,
        /// The parameters of the run.
        pub params: HookParams,
        /// What does not change.
        pub world: World,
        /// The true pose.
        pub truth: [f64; 3],
        /// The estimated pose.
        pub estimate: [f64; 3],
        /// Its claimed covariance.
        #[name = "P"]
        pub p: [[f64; 3]; 3],
        /// The one-sigma ellipse of the claimed position.
        pub ellipse: Ellipse,
        /// The belief of this tick before its fixes.
        pub predicted: PoseBelief,
        /// [Δs, Δθ] as the encoders say; absent at step 0.
        pub u: Option<[f64; 2]>,
        /// The corners read in this tick, used or not.
        pub sightings: Vec<CornerSighting>,
        /// The last corner read, in this tick or before.
        pub last_sighting: Option<LastSighting>,
        /// Estimate minus truth.
        pub error: Quality,
        /// One sigma as claimed.
        pub sigma: Spread,
        /// |error| over sigma.
        pub ratio: Ratio,
        /// The right wheel's bias, where it is a state.
        pub wheel: Option<WheelBelief>,
        /// The course of the last lap.
        pub tracks: Tracks,
        /// Ellipses along the last lap.
        pub trail: VecDeque<Stop>,
        /// Numbers over the last lap and a half.
        pub series: HookSeries,
    }

    /// The apartment and the course.
    pub struct World {
        /// [x₁, y₁, x₂, y₂] of each wall.
        pub walls: Vec<[f64; 4]>,
        /// The rooms.
        pub rooms: &'static [Room],
        /// The mapped corners.
        pub corners: &'static [Landmark],
        /// The corners of the course.
        #[name = "loop"]
        pub course: [[f64; 2]; 4],
        /// How far the sensor reaches.
        pub reach: f64,
    }

    /// A belief over a pose.
    #[derive(Copy)]
    pub struct PoseBelief {
        /// The mean.
        pub x: [f64; 3],
        /// The covariance, by rows.
        #[name = "P"]
        pub p: [[f64; 3]; 3],
        /// The one-sigma ellipse of the position.
        pub ellipse: Ellipse,
    }

    /// A corner as read in one tick.
    #[derive(Copy)]
    pub struct CornerSighting {
        /// Which corner.
        pub landmark: u32,
        /// Where it is.
        pub x: f64,
        /// Where it is.
        pub y: f64,
        /// The range read.
        pub range: f64,
        /// The bearing read, from the landmark.
        pub bearing: f64,
    }

    /// The last corner that was read.
    #[derive(Copy)]
    pub struct LastSighting {
        /// In which tick.
        pub step: u32,
        /// Which corner.
        pub landmark: u32,
        /// Where it is.
        pub x: f64,
        /// Where it is.
        pub y: f64,
        /// The range read.
        pub range: f64,
        /// The bearing read, from the landmark.
        pub bearing: f64,
        /// From where.
        pub from: [f64; 2],
    }

    /// An error of a pose.
    #[derive(Copy)]
    pub struct Quality {
        /// Distance from the truth.
        pub position: f64,
        /// Estimated minus true heading, the short way round.
        pub heading: f64,
    }

    /// One sigma of a pose, as the filter claims it.
    #[derive(Copy)]
    pub struct Spread {
        /// The root of the position's trace.
        pub position: f64,
        /// One sigma of the heading.
        pub heading: f64,
    }

    /// How many claimed sigmas the error is.
    #[derive(Copy)]
    pub struct Ratio {
        /// Absent while nothing is claimed.
        pub position: Option<f64>,
        /// Absent while nothing is claimed.
        pub heading: Option<f64>,
    }

    /// What a filter that learns the right wheel's bias believes of it.
    #[derive(Copy)]
    pub struct WheelBelief {
        /// ε̂: the part of what the encoder counts that the wheel did not roll.
        pub epsilon: f64,
        /// One sigma of it.
        pub sigma: f64,
        /// The true ε.
        pub truth: f64,
        /// The rank, of four states, of all readings used so far, stacked along the true path.
        pub rank: usize,
    }

    /// The estimate at one tick of the past.
    #[derive(Copy)]
    pub struct Stop {
        /// The tick.
        pub step: u32,
        /// Where the robot believed to be.
        pub x: [f64; 2],
        /// The one-sigma ellipse there.
        pub ellipse: Ellipse,
    }

    /// Numbers over time.
    #[derive(Default)]
    pub struct HookSeries {
        /// The tick of each entry.
        pub step: Series,
        /// Position error.
        pub position: Series,
        /// Size of the heading error.
        pub heading: Series,
        /// Claimed sigma of the position.
        pub sigma_position: Series,
        /// Claimed sigma of the heading.
        pub sigma_heading: Series,
        /// ε̂, where the wheel's bias is a state.
        pub epsilon: Series,
        /// Claimed sigma of ε̂.
        pub sigma_epsilon: Series,
    }
}

impl World {
    pub(crate) fn of(home: &Apartment) -> Self {
        let walls = home.walls.iter().map(|w| [w.from[0], w.from[1], w.to[0], w.to[1]]).collect();
        let course = HOOK.course.corners();
        Self { walls, rooms: home.rooms, corners: home.corners, course, reach: HOOK.sensor.reach }
    }
}

impl From<&Gaussian<U3>> for PoseBelief {
    fn from(belief: &Gaussian<U3>) -> Self {
        let position = belief.p.fixed_view::<2, 2>(0, 0).into_owned();
        Self { x: belief.x.into(), p: rows(&belief.p), ellipse: ellipse_of(&position) }
    }
}

impl Quality {
    pub(crate) fn over(self, sigma: Spread) -> Ratio {
        let ratio = |error: f64, sigma: f64| (sigma > 0.0).then(|| error.abs() / sigma);
        Ratio { position: ratio(self.position, sigma.position), heading: ratio(self.heading, sigma.heading) }
    }
}

/// Tracks, trail and series, each of bounded length.
#[derive(Clone, Debug, Default)]
pub(crate) struct HookRecord {
    pub tracks: Tracks,
    pub trail: VecDeque<Stop>,
    pub series: HookSeries,
}

impl HookRecord {
    pub fn take(
        &mut self,
        step: u32,
        truth: SE2,
        belief: &Gaussian<U3>,
        (error, sigma): (Quality, Spread),
        wheel: Option<WheelBelief>,
    ) {
        let x = [belief.x[0], belief.x[1]];
        self.tracks.truth.push(truth.x(), truth.y(), TRACK);
        self.tracks.estimate.push(x[0], x[1], TRACK);
        if step.is_multiple_of(TRAIL_EVERY) {
            keep(&mut self.trail, Stop { step, x, ellipse: PoseBelief::from(belief).ellipse }, TRAIL);
        }
        if step.is_multiple_of(SERIES_EVERY) {
            let series = &mut self.series;
            series.step.push(f64::from(step));
            series.position.push(error.position);
            series.heading.push(error.heading.abs());
            series.sigma_position.push(sigma.position);
            series.sigma_heading.push(sigma.heading);
            if let Some(wheel) = wheel {
                series.epsilon.push(wheel.epsilon);
                series.sigma_epsilon.push(wheel.sigma);
            }
        }
    }
}
