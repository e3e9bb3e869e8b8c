//! A log that was read, and how large one may be.

use crate::corrections::Corrections;
use estimate::drive::Drive;

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
    /// What is read otherwise than the files have it.
    pub corrections: Corrections,
}

impl From<Log> for Understood {
    fn from(log: Log) -> Self {
        let (notes, landmarks, corrections) = (Vec::new(), Vec::new(), Corrections::default());
        Self { log, notes, landmarks, wheels: false, corrections }
    }
}
