//! A log that was read, and how large one may be.

use crate::corrections::Corrections;
use estimate::drive::{Drive, Truth};
use std::collections::BTreeSet;

/// The greatest size of a log, bytes.
pub const MAX_BYTES: usize = 64_000_000;
/// The most rows of a log.
pub const MAX_ROWS: usize = 2_000_000;
/// The most landmarks of a log.
pub const MAX_LANDMARKS: usize = 500;

/// A log that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// What it says.
    pub drive: Drive,
    /// All lines of the files that say something, landmarks and truth among them: a line of a table may have several
    /// readings.
    pub count: usize,
}

/// A row is not lost by how its time is rounded, s.
const ROUNDED: f64 = 1e-6;

impl Log {
    /// Leaves what lies between two times, s since the first row, and says so; all where no motion lies there.
    pub(crate) fn cut(&mut self, [from, to]: [f64; 2]) -> String {
        let drive = &mut self.drive;
        let first = drive.rows.first().map_or(0.0, |row| row.time);
        let within = |time: f64| (from - ROUNDED..=to + ROUNDED).contains(&(time - first));
        if !drive.rows.iter().any(|row| row.event.is_motion() && within(row.time)) {
            return format!("No motion lies from {from:.1} to {to:.1} s after the first row: all of the log is read.");
        }
        let lines = |drive: &Drive| drive.rows.iter().map(|row| row.line).collect::<BTreeSet<_>>().len();
        let count = |drive: &Drive| lines(drive) + drive.truth.poses().len();
        let before = count(drive);
        drive.rows.retain(|row| within(row.time));
        drive.truth = Truth::new(drive.truth.poses().iter().filter(|pose| within(pose.time)).copied().collect());
        self.count = self.count.saturating_sub(before - count(&self.drive));
        format!("The log is read from {from:.1} to {to:.1} s after its first row.")
    }
}

/// A log that was read from files, and what was left out of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Understood {
    /// The log.
    pub log: Log,
    /// What was left out or added, in sentences.
    pub notes: Vec<String>,
    /// What the files call the landmarks of the numbers 1, 2 and so on; none where they have numbers.
    pub landmarks: Vec<String>,
    /// Whether turn rates come from the encoders of two wheels alone: no gyro reads any.
    pub wheels: bool,
    /// How far apart these two wheels stand, m, as was said.
    pub base: Option<f64>,
    /// Whether headings are the courses of a receiver of positions.
    pub course: bool,
    /// What is read otherwise than the files have it.
    pub corrections: Corrections,
}

impl From<Log> for Understood {
    fn from(log: Log) -> Self {
        let (notes, landmarks, corrections) = (Vec::new(), Vec::new(), Corrections::default());
        Self { log, notes, landmarks, wheels: false, base: None, course: false, corrections }
    }
}
