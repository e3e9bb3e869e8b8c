//! A log while it is read: rows from one file or from several, checked against one another at the end.

use crate::error::Error;
use crate::fields::Line;
use crate::log::{Log, MAX_LANDMARKS, MAX_ROWS};
use estimate::Landmark;
use estimate::drive::{Drive, Event, Motion, Pose, Row, Truth};
use std::collections::HashMap;

/// What a sighting of an unknown landmark asks for, and what it asks for in a table.
const PLACED: &str = "a landmark that is seen needs a row with its place";
const LISTED: &str = "and sightings that name barcodes need the list of these";

/// The letters of motion, in the order in which two kinds are named.
const LETTERS: [&str; 8] = ["O", "D", "V", "S", "T", "VE", "SE", "TE"];

/// A place in the files of a log: file, line and column.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellPlace {
    pub file: usize,
    pub line: u32,
    pub column: u32,
}

impl CellPlace {
    /// The beginning of a line, or of one of its fields.
    pub fn of(file: usize, line: &Line<'_>, field: usize) -> Self {
        Self { file, line: line.number, column: line.fields.get(field).map_or(line.end, |field| field.column) }
    }

    pub fn refuse(self, message: impl Into<String>) -> Error {
        Error::new(self.line, self.column, message).within(self.file)
    }
}

/// What is done with a sighting of a landmark that no row places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unplaced {
    /// The log is refused: it is in the book's own format, which is strict.
    Refused,
    /// The log is refused if it has landmarks and no barcodes; else the sighting is left out and counted: it is of
    /// another robot, or there is no file of landmarks.
    LeftOut,
}

/// A sighting whose landmark is looked up once all rows have been read.
struct Sighting {
    /// The row's index.
    row: usize,
    /// Its landmark's id, and where that stands.
    id: u32,
    place: CellPlace,
    unplaced: Unplaced,
}

/// The rows read so far.
#[derive(Default)]
pub(crate) struct Gathering {
    landmarks: Vec<Landmark>,
    /// The index of each landmark by its id.
    index: HashMap<u32, usize>,
    poses: Vec<Pose>,
    rows: Vec<Row>,
    /// How the robot moves, and the letter of the first row that said so.
    motion: Option<(Motion, &'static str)>,
    /// The sightings. A landmark's row may stand behind them.
    sightings: Vec<Sighting>,
    /// The rows that say again what one before them has said.
    copies: Vec<usize>,
    /// Rows of the log, of which a line may have several, and lines.
    count: usize,
    lines: usize,
    last: Option<CellPlace>,
}

impl Gathering {
    /// Counts a row that begins at `place`.
    pub fn begin(&mut self, place: CellPlace) -> Result<(), Error> {
        self.count += 1;
        let another = |last: CellPlace| (last.file, last.line) != (place.file, place.line);
        self.lines += usize::from(self.last.is_none_or(another));
        self.last = Some(place);
        if self.count > MAX_ROWS {
            return Err(place.refuse(format!("the log has more than {MAX_ROWS} rows")));
        }
        Ok(())
    }

    /// A landmark, whose id stands at `place`.
    pub fn landmark(&mut self, place: CellPlace, landmark: Landmark) -> Result<(), Error> {
        if self.landmarks.len() == MAX_LANDMARKS {
            return Err(
                CellPlace { column: 1, ..place }.refuse(format!("the log has more than {MAX_LANDMARKS} landmarks"))
            );
        }
        if self.index.insert(landmark.id, self.landmarks.len()).is_some() {
            let message = format!("landmark {} stands here for the second time; each has one row", landmark.id);
            return Err(place.refuse(message));
        }
        self.landmarks.push(landmark);
        Ok(())
    }

    pub fn truth(&mut self, pose: Pose) {
        self.poses.push(pose);
    }

    /// A row of motion, which begins at `place`; `even`, what it says was driven evenly.
    pub fn motion(&mut self, place: CellPlace, row: Row, even: bool) -> Result<(), Error> {
        let (motion, letter) = match (row.event, even) {
            (Event::Odometry { .. }, false) => (Motion::Odometry, "O"),
            (Event::Odometry { .. }, true) => (Motion::EvenOdometry, "D"),
            (Event::Speed { .. }, false) => (Motion::Velocity, "S"),
            (Event::Speed { .. }, true) => (Motion::EvenVelocity, "SE"),
            (Event::TurnRate { .. }, false) => (Motion::Velocity, "T"),
            (Event::TurnRate { .. }, true) => (Motion::EvenVelocity, "TE"),
            (_, false) => (Motion::Velocity, "V"),
            (_, true) => (Motion::EvenVelocity, "VE"),
        };
        let (first, known) = *self.motion.get_or_insert((motion, letter));
        if first != motion {
            let mut pair = [known, letter];
            pair.sort_by_key(|letter| LETTERS.iter().position(|it| it == letter));
            let [one, other] = pair;
            return Err(place.refuse(format!("the log has {one} rows and {other} rows; a log moves by one kind")));
        }
        self.reading(row);
        Ok(())
    }

    /// A row of a sensor that no landmark is needed for.
    pub fn reading(&mut self, row: Row) {
        self.rows.push(Row { line: self.rows.len() as u32, ..row });
    }

    /// A sighting of the landmark `id`, which stands at `place`.
    pub fn sighting(&mut self, place: CellPlace, row: Row, id: u32, unplaced: Unplaced) {
        self.sightings.push(Sighting { row: self.rows.len(), id, place, unplaced });
        self.reading(row);
    }

    /// Leaves rows out of the log: they say again what others have said.
    pub fn leave_out(&mut self, mut rows: Vec<usize>) {
        self.copies.append(&mut rows);
    }

    /// The rows so far, in the order in which they came.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The true poses so far.
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// The landmarks so far, and the ids of those that were seen.
    pub fn landmarks(&self) -> (&[Landmark], Vec<u32>) {
        let mut seen: Vec<u32> = self.sightings.iter().map(|sighting| sighting.id).collect();
        seen.sort_unstable();
        seen.dedup();
        (&self.landmarks, seen)
    }

    /// Whether there is a row of motion.
    pub fn has_motion(&self) -> bool {
        self.motion.is_some()
    }

    /// Whether a landmark has been placed.
    pub fn has_landmarks(&self) -> bool {
        !self.landmarks.is_empty()
    }

    /// Where the last row begins.
    pub fn end(&self) -> CellPlace {
        self.last.unwrap_or(CellPlace { file: 0, line: 1, column: 1 })
    }

    /// The log, and how many sightings were left out of it. With `barcodes`, a sighting of an unknown landmark is of
    /// another robot.
    ///
    /// # Errors
    /// There is no motion, or a sighting is of a landmark without a place and is not left out.
    pub fn finish(mut self, barcodes: bool) -> Result<(Log, usize), Error> {
        let (last, mut left_out) = (self.end(), Vec::new());
        for Sighting { row, id, place, unplaced } in self.sightings {
            match self.index.get(&id) {
                Some(known) => match &mut self.rows[row].event {
                    Event::Range { landmark, .. } | Event::RangeBearing { landmark, .. } => *landmark = *known,
                    _ => {}
                },
                None => match unplaced {
                    Unplaced::LeftOut if barcodes || self.landmarks.is_empty() => left_out.push(row),
                    Unplaced::LeftOut => {
                        return Err(place.refuse(format!("there is no landmark {id}; {PLACED}, {LISTED}")));
                    }
                    Unplaced::Refused => return Err(place.refuse(format!("there is no landmark {id}; {PLACED}"))),
                },
            }
        }
        let strangers = left_out.len();
        left_out.append(&mut self.copies);
        left_out.sort_unstable();
        if !left_out.is_empty() {
            let (mut i, mut out) = (0, left_out.iter().copied().peekable());
            self.rows.retain(|_| {
                i += 1;
                out.next_if_eq(&(i - 1)).is_none()
            });
        }
        let Some((motion, _)) = self.motion else {
            let message = "the log has no motion; D, O, V, S, T, VE, SE or TE rows were expected";
            return Err(CellPlace { column: 1, ..last }.refuse(message));
        };
        // The sort is stable: rows of one time and kind stay in the order of their lines.
        let sighting = |row: &Row| !row.event.is_motion();
        self.rows.sort_by(|a, b| a.time.total_cmp(&b.time).then(sighting(a).cmp(&sighting(b))));
        let truth = Truth::new(self.poses);
        let drive = Drive { landmarks: self.landmarks, truth, rows: self.rows, motion };
        Ok((Log { drive, count: self.lines }, strangers))
    }
}
