//! What a log says: rows of motion and sightings, by time.

use crate::Landmark;
use crate::drive::truth::Truth;
use alloc::vec::Vec;

/// What happened in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Odometry since the row of its kind before.
    Odometry {
        /// m.
        distance: f64,
        /// rad.
        turn: f64,
    },
    /// A velocity, held until the next.
    Velocity {
        /// m/s.
        v: f64,
        /// rad/s.
        omega: f64,
    },
    /// A range to a landmark.
    Range {
        /// Its index among [`Drive::landmarks`].
        landmark: usize,
        /// m.
        range: f64,
    },
    /// A range and a bearing to a landmark.
    RangeBearing {
        /// Its index among [`Drive::landmarks`].
        landmark: usize,
        /// m.
        range: f64,
        /// rad, from the robot's nose to the landmark, counter-clockwise: Choset's bearing, which is seen from the
        /// landmark, and π.
        bearing: f64,
    },
}

impl Event {
    /// Whether the row says how the robot moved, and not what it saw.
    pub fn is_motion(&self) -> bool {
        matches!(self, Self::Odometry { .. } | Self::Velocity { .. })
    }
}

/// A row of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// s.
    pub time: f64,
    /// What happened.
    pub event: Event,
}

/// How a log says that the robot moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// By distance and turn since the row before.
    Odometry,
    /// By velocities, each held until the next.
    Velocity,
}

/// A logged drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// The landmarks, at known places.
    pub landmarks: Vec<Landmark>,
    /// Where the robot really was, as far as it is known.
    pub truth: Truth,
    /// Motion and sightings in the order of their replay: by time, at equal times motion first.
    pub rows: Vec<Row>,
    /// Of which kind the motion is.
    pub motion: Motion,
}

impl Drive {
    /// The first and the last time of a row, s; `None` where there is no row.
    pub fn span(&self) -> Option<[f64; 2]> {
        Some([self.rows.first()?.time, self.rows.last()?.time])
    }
}
