//! What a log says: rows of motion and of readings, by time.

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
    /// A speed and a turn rate in one; [`Motion`] says what the robot does until the next.
    Velocity {
        /// m/s.
        v: f64,
        /// rad/s.
        omega: f64,
    },
    /// A speed.
    Speed {
        /// m/s.
        v: f64,
    },
    /// A turn rate.
    TurnRate {
        /// rad/s.
        omega: f64,
    },
    /// A fix of the position, as of a satellite receiver.
    Position {
        /// m.
        x: f64,
        /// m.
        y: f64,
        /// Its own standard deviation, m; `None` takes that of the settings.
        sigma: Option<f64>,
    },
    /// A heading, as of a compass or of a course.
    Heading {
        /// rad.
        theta: f64,
        /// Its own standard deviation, rad; `None` takes that of the settings.
        sigma: Option<f64>,
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

/// A row of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The stamp, s.
    pub time: f64,
    /// What happened.
    pub event: Event,
    /// Its place among the rows as they stand in the log's files. Of two rows measured at one time, both motion or both
    /// readings, the one with the smaller place is taken first.
    pub line: u32,
}

impl Row {
    /// A row of a log that is put together in the order of its rows.
    pub fn new(time: f64, event: Event) -> Self {
        Self { time, event, line: 0 }
    }
}

/// How a log says that the robot moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// By distance and turn since the row before, driven at the row's time: between two rows the robot stands.
    Odometry,
    /// By distance and turn since the row before, driven evenly on the way from that row to this one.
    EvenOdometry,
    /// By speeds and turn rates, each held until the next.
    Velocity,
    /// By speeds and turn rates that were read of a robot which changes them evenly from one row to the next. Between
    /// two rows of a rate the robot drives with the mean of both, and turns on its way. Over a step longer than 3.5
    /// times the median of its kind, and behind the last row, a rate is held.
    EvenVelocity,
}

impl Motion {
    /// Whether it is by distances and turns, and not by speeds and turn rates.
    pub fn is_odometry(self) -> bool {
        matches!(self, Self::Odometry | Self::EvenOdometry)
    }

    /// Whether the robot drives evenly between two rows, and turns on its way.
    pub fn is_even(self) -> bool {
        matches!(self, Self::EvenOdometry | Self::EvenVelocity)
    }
}

/// A logged drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// The landmarks, at known places.
    pub landmarks: Vec<Landmark>,
    /// Where the robot really was, as far as it is known.
    pub truth: Truth,
    /// Motion and readings by their stamps, at equal stamps motion first, then by their lines.
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
