//! The ghost: a copy of the robot that starts elsewhere and drives the same ticks. Where it would read what the robot
//! reads, no filter can tell the two apart.

use super::ProbeParams;
use super::frame::{Ghost, GhostReadings};
use super::ranks::direction;
use estimate::Landmark;
use estimate::landmarks::RangeBearing;
use estimate::localizer::SensorKind;
use filters::MeasurementModel;
use geom::{SE2, angle_diff};
use lab::series::Track;
use sim::paths::Tick;

/// The ghost and what it has read, all without noise.
#[derive(Clone, Debug)]
pub(super) struct Haunting {
    /// Where the robot started.
    start: SE2,
    pose: SE2,
    /// The dials as a small displacement of the start: m, m, rad.
    displaced: [f64; 3],
    track: Track,
    moved: f64,
    gaps: [f64; 2],
    readings: Vec<GhostReadings>,
}

impl Haunting {
    /// The ghost before its first step: the robot's start turned about the first landmark with its heading left alone,
    /// shifted to the east, then turned on the spot.
    pub fn new(params: &ProbeParams, start: SE2) -> Self {
        let [ax, ay] = params.landmarks[0];
        let (dx, dy) = (start.x() - ax, start.y() - ay);
        let (around, shift, turn) = (params.ghost_around, params.ghost_shift, params.ghost_turn);
        let (s, c) = libm::sincos(around);
        let pose = SE2::new(ax + c * dx - s * dy + shift, ay + s * dx + c * dy, start.theta() + turn);
        Self {
            start,
            pose,
            displaced: [shift - around * dy, around * dx, turn],
            track: Track::default(),
            moved: 0.0,
            gaps: [0.0; 2],
            readings: vec![GhostReadings::default(); params.count as usize],
        }
    }

    /// Drives the robot's tick.
    pub fn drive(&mut self, tick: Tick) {
        self.pose = tick.drive(self.pose);
    }

    /// Compares what robot and ghost read at this step. A landmark under one of them has no bearing: it is left out.
    pub fn compare(&mut self, truth: SE2, landmarks: &[Landmark], most: usize) {
        self.track.push(self.pose.x(), self.pose.y(), most);
        self.moved = self.moved.max(numerics::hypot(self.pose.x() - truth.x(), self.pose.y() - truth.y()));
        let sensor = RangeBearing { map: landmarks };
        for (j, readings) in self.readings.iter_mut().enumerate() {
            let [robot, ghost] = [truth, self.pose].map(|pose| sensor.h(&pose, j).map_or([f64::NAN; 2], Into::into));
            readings.range.push(robot[0]);
            readings.bearing.push(robot[1]);
            readings.ghost_range.push(ghost[0]);
            readings.ghost_bearing.push(ghost[1]);
            // `max` passes over what is no number.
            self.gaps[0] = self.gaps[0].max((ghost[0] - robot[0]).abs());
            self.gaps[1] = self.gaps[1].max(angle_diff(ghost[1], robot[1]).abs());
        }
    }

    /// What is hashed of a step.
    pub fn numbers(&self) -> [f64; 5] {
        [self.pose.x(), self.pose.y(), self.pose.theta(), self.gaps[0], self.gaps[1]]
    }

    /// What is shown. To first order the displacement at the present pose is Φ times that of the start: a turn of the
    /// start also moves every later pose, by its lever.
    pub fn frame(&self, truth: SE2, sensor: SensorKind) -> Ghost {
        let [x, y, turn] = self.displaced;
        let now = [x - turn * (truth.y() - self.start.y()), y + turn * (truth.x() - self.start.x()), turn];
        Ghost {
            pose: self.pose.to_vector().into(),
            track: self.track.outlined(),
            moved: self.moved,
            range_gap: self.gaps[0],
            bearing_gap: (sensor == SensorKind::RangeBearing).then_some(self.gaps[1]),
            by_hand: (self.displaced != [0.0; 3]).then(|| direction(now)),
            readings: self.readings.clone(),
        }
    }
}
