//! A whole log, checked and in the order of its replay.

use crate::error::Error;
use crate::fields::{Line, Lines};
use crate::row::{Read, read};
use estimate::Landmark;
use estimate::drive::{Drive, Event, Motion, Pose, Row, Truth};
use std::collections::HashMap;

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
    /// All rows of the file, landmarks and truth among them.
    pub count: usize,
}

/// Reads a log.
///
/// # Errors
/// Where the text is no log, with line, column and what was expected: it is too large or no text, a row has an unknown letter, too
/// few or too many fields, a field that is no finite number, a negative range, a time beyond 10¹¹ s; a landmark is named twice or a
/// sighting names none; `O` rows and `V` rows are mixed; there is no motion. A fault of the whole log names its last row.
pub fn parse(text: &str) -> Result<Log, Error> {
    if text.len() > MAX_BYTES {
        let message = format!("the log has {} bytes; at most {MAX_BYTES} were expected", text.len());
        return Err(Error::new(1, 1, message));
    }
    let mut reading = Reading::default();
    let mut lines = Lines::new(text);
    while let Some(line) = lines.next()? {
        if let Some(at) = line.fields.iter().find(|field| field.text.contains(not_text)) {
            let message = "a control character was found; a log is plain text in UTF-8";
            return Err(Error::new(line.number, at.column, message));
        }
        let row = read(&line)?;
        reading.take(&line, row)?;
    }
    reading.finish()
}

/// Characters that no text has; a file in UTF-16 or a picture is full of them.
fn not_text(c: char) -> bool {
    (c.is_control() && c != '\t') || c == '\u{fffd}'
}

/// A log while it is read.
#[derive(Default)]
struct Reading {
    landmarks: Vec<Landmark>,
    /// The index of each landmark by its id.
    index: HashMap<u32, usize>,
    poses: Vec<Pose>,
    rows: Vec<Row>,
    motion: Option<Motion>,
    /// The sightings: the row's index, its landmark's id, and where the id stands. A landmark's row may stand behind them.
    sightings: Vec<(usize, u32, [u32; 2])>,
    count: usize,
    last_line: u32,
}

impl Reading {
    fn take(&mut self, line: &Line<'_>, row: Read) -> Result<(), Error> {
        let column = |field: usize| line.fields[field].column;
        let line = line.number;
        self.count += 1;
        self.last_line = line;
        if self.count > MAX_ROWS {
            return Err(Error::new(line, 1, format!("the log has more than {MAX_ROWS} rows")));
        }
        match row {
            Read::Landmark(landmark) => self.place([line, column(1)], landmark)?,
            Read::Truth(pose) => self.poses.push(pose),
            Read::Motion(row) => self.moved(line, row)?,
            Read::Sighting(row, id) => {
                self.sightings.push((self.rows.len(), id, [line, column(2)]));
                self.rows.push(row);
            }
        }
        Ok(())
    }

    fn place(&mut self, [line, column]: [u32; 2], landmark: Landmark) -> Result<(), Error> {
        if self.landmarks.len() == MAX_LANDMARKS {
            return Err(Error::new(line, 1, format!("the log has more than {MAX_LANDMARKS} landmarks")));
        }
        if self.index.insert(landmark.id, self.landmarks.len()).is_some() {
            let message = format!("landmark {} stands here for the second time; each has one row", landmark.id);
            return Err(Error::new(line, column, message));
        }
        self.landmarks.push(landmark);
        Ok(())
    }

    fn moved(&mut self, line: u32, row: Row) -> Result<(), Error> {
        let motion = match row.event {
            Event::Velocity { .. } => Motion::Velocity,
            _ => Motion::Odometry,
        };
        if *self.motion.get_or_insert(motion) != motion {
            return Err(Error::new(line, 1, "the log has O rows and V rows; a log moves by one kind"));
        }
        self.rows.push(row);
        Ok(())
    }

    fn finish(mut self) -> Result<Log, Error> {
        for (at, id, [line, column]) in self.sightings {
            let missing = || format!("there is no landmark {id}; a row L,{id},x,y was expected");
            let known = *self.index.get(&id).ok_or_else(|| Error::new(line, column, missing()))?;
            match &mut self.rows[at].event {
                Event::Range { landmark, .. } | Event::RangeBearing { landmark, .. } => *landmark = known,
                Event::Odometry { .. } | Event::Velocity { .. } => {}
            }
        }
        let Some(motion) = self.motion else {
            return Err(Error::new(self.last_line.max(1), 1, "the log has no motion; O rows or V rows were expected"));
        };
        // The sort is stable: rows of one time and kind stay in the order of their lines.
        let sighting = |row: &Row| !row.event.is_motion();
        self.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(sighting(a).cmp(&sighting(b))));
        let truth = Truth::new(self.poses);
        Ok(Log { drive: Drive { landmarks: self.landmarks, truth, rows: self.rows, motion }, count: self.count })
    }
}
