//! A log in memory, once for all labs that replay it.

use super::frame::LogTimeline;
use estimate::drive::{Drive, Event};
use lab::series::Track;

/// At most so many positions of a track, and so many readings, are in a frame.
const MOST_POSITIONS: u32 = 600;
const MOST_READINGS: u32 = 480;
/// The timeline has at most so many moments.
const MOST_MOMENTS: u32 = 240;
/// NIS is averaged over so many blocks of readings, of so many readings at least.
const BLOCKS: u32 = 60;
const LEAST_BLOCK: u32 = 20;

/// A drive, and how much of it a frame shows.
#[derive(Debug)]
pub struct LoggedDrive {
    drive: Drive,
    wheels: bool,
    motions: u32,
    sightings: u32,
    bearings: bool,
    /// The truth as a frame draws it, and the times of its positions.
    truth: Track,
    truth_times: Vec<f64>,
    timeline: LogTimeline,
}

impl LoggedDrive {
    /// The drive that a log says.
    pub fn new(drive: Drive) -> Self {
        let motions = drive.rows.iter().filter(|row| row.event.is_motion()).count() as u32;
        let sightings = drive.rows.len() as u32 - motions;
        let bearings = drive.rows.iter().any(|row| matches!(row.event, Event::RangeBearing { .. }));
        let poses = drive.truth.poses();
        let stride = stride(poses.len() as u32, MOST_POSITIONS) as usize;
        let (mut truth, mut truth_times) = (Track::default(), Vec::new());
        for pose in poses.iter().step_by(stride) {
            truth.push(pose.x, pose.y, usize::MAX);
            truth_times.push(pose.time);
        }
        let timeline = timeline(&drive);
        Self { drive, wheels: false, motions, sightings, bearings, truth, truth_times, timeline }
    }

    /// The same, of which two wheels alone say how the robot turned.
    #[must_use]
    pub fn by_wheels(self, wheels: bool) -> Self {
        Self { wheels, ..self }
    }

    /// Whether two wheels alone say how the robot turned: no gyro does.
    pub fn is_by_wheels(&self) -> bool {
        self.wheels
    }

    /// What the log says.
    pub fn drive(&self) -> &Drive {
        &self.drive
    }

    /// Rows of motion and sightings: the last step of a replay.
    pub fn rows(&self) -> u32 {
        self.drive.rows.len() as u32
    }

    /// The first and the last time of these rows, s. A log has motion, hence rows.
    pub fn span(&self) -> [f64; 2] {
        self.drive.span().unwrap_or_default()
    }

    /// Whether a sighting has a bearing.
    pub fn bearings(&self) -> bool {
        self.bearings
    }

    /// The true positions up to `time`.
    pub(super) fn truth_until(&self, time: f64) -> Track {
        let count = self.truth_times.partition_point(|at| *at <= time);
        let of = |all: &std::collections::VecDeque<f64>| all.iter().take(count).copied().collect();
        Track { x: of(&self.truth.x), y: of(&self.truth.y) }
    }

    pub(super) fn timeline(&self) -> LogTimeline {
        self.timeline.clone()
    }

    /// Every how many rows of motion one is kept.
    pub(super) fn motion_stride(&self) -> u32 {
        stride(self.motions, MOST_POSITIONS)
    }

    /// Every how many sightings one is kept.
    pub(super) fn sighting_stride(&self) -> u32 {
        stride(self.sightings, MOST_READINGS)
    }

    /// Every how many of `looked` readings one is kept.
    pub(super) fn looked_stride(&self, looked: u32) -> u32 {
        stride(looked, MOST_READINGS)
    }

    /// How many used readings make a block of the NIS.
    pub(super) fn block(&self) -> u32 {
        self.sightings.div_ceil(BLOCKS).max(LEAST_BLOCK)
    }
}

fn timeline(drive: &Drive) -> LogTimeline {
    let rows = drive.rows.len() as u32;
    let first = drive.rows.first().map_or(0.0, |row| row.time);
    let mut timeline = LogTimeline::default();
    let stride = stride(rows, MOST_MOMENTS);
    for step in (1..rows).step_by(stride as usize).chain([rows]).filter(|step| *step > 0) {
        timeline.time.push(drive.rows[step as usize - 1].time - first);
        timeline.step.push(step);
    }
    timeline
}

fn stride(count: u32, most: u32) -> u32 {
    count.div_ceil(most).max(1)
}
