//! Rows of tables become rows of a log.

use crate::cells::Cells;
use crate::error::Error;
use crate::frames::{self, Moved};
use crate::gathering::{CellPlace, Gathering, Unplaced};
use crate::headed::headed;
use crate::landmarks::Landmarks;
use crate::lists;
use crate::log::Understood;
use crate::notes::{self, Counts};
use crate::other_clock::Span;
use crate::own::Own;
use crate::placed::Placed;
use crate::role::Role;
use crate::sampled;
use crate::source::Landmark as Of;
use crate::twice;
use crate::way::Way;
use crate::wgs84::Origin;
use estimate::Landmark;
use estimate::drive::{Event, Pose, Row};
use std::collections::HashMap;

/// A log while its tables are read.
#[derive(Default)]
pub(crate) struct LogReader {
    pub to: Gathering,
    /// The landmark that carries each barcode.
    carried: Option<HashMap<u32, u32>>,
    /// The numbers of those that have names.
    landmarks: Landmarks,
    /// The places that stand beside sightings.
    placed: Placed,
    /// Sightings of a barcode that is in no list.
    unlisted: usize,
    /// True poses whose heading is not known.
    without_heading: Vec<Pose>,
    /// True poses of another origin.
    moved: Moved,
    /// The point in degrees about which all places are: the first, unless one was said.
    pub origin: Option<Origin>,
    /// What is kept of the file that is being read.
    pub kept: Counts,
    notes: Vec<String>,
    /// The files that were read, each with the number of the rows up to its end.
    files: Vec<(String, usize)>,
    /// Whether a truth of another origin stays where it is.
    as_written: bool,
    /// Whether a gyro says how the robot turned, and not the file that is being read.
    turned: bool,
    way: Way,
    /// Rows of rates that tables have: those in the book's own format say themselves how they are meant.
    rates: usize,
}

impl LogReader {
    /// Nothing yet; `carried` is the landmark that carries each barcode, where a file says so; `as_written`, no truth
    /// is moved.
    pub fn new(carried: Option<HashMap<u32, u32>>, as_written: bool) -> Self {
        Self { carried, as_written, ..Self::default() }
    }

    /// Begins a file, whose turns are not taken where a gyro says them.
    pub fn begin_file(&mut self, turned: bool) {
        (self.turned, self.way.since) = (turned, None);
    }

    /// Ends a file, `words` lines above its rows passed over; what a row does not say is not missing where it is
    /// `shared` by several readings. Answers when its rows were.
    pub fn end_file(&mut self, name: &str, words: usize, shared: bool) -> Option<Span> {
        let kept = core::mem::take(&mut self.kept);
        self.files.push((name.into(), self.to.rows().len()));
        self.notes.extend(notes::words(name, words));
        self.notes.extend(kept.notes(name, shared));
        self.to.leave_out(kept.copies());
        kept.stamps.span
    }

    /// How much has been taken: rows, true poses, landmarks, and sightings whose barcode is in no list.
    pub fn taken(&self) -> usize {
        self.to.rows().len() + self.poses().len() + self.to.landmarks().0.len() + self.unlisted
    }

    /// Says something of a file that is not seen row by row.
    pub fn say(&mut self, notes: Vec<String>) {
        self.notes.extend(notes);
    }

    /// Takes a row of a table.
    pub fn take(&mut self, role: Role, cells: Cells<'_>) -> Result<(), Error> {
        let start = cells.start();
        match role {
            Role::Velocities | Role::Odometry => {
                let event = match role {
                    Role::Velocities => Event::Velocity { v: cells.number("v")?, omega: cells.number("omega")? },
                    _ => Event::Odometry { distance: cells.number("distance")?, turn: cells.number("turn")? },
                };
                let time = self.kept.stamps.take(cells)?;
                self.driven(start, time, Some(event))?;
            }
            Role::Encoders => {
                let (time, counted) = (self.kept.stamps.take(cells)?, [cells.number("left")?, cells.number("right")?]);
                let unit = cells.source.role.index("left").and_then(|at| cells.source.units[at]);
                let before = self.kept.counted.replace(counted).filter(|_| !cells.jumps.begins_anew(start.line));
                let wheels = &cells.source.wheels;
                let event = unit.and_then(|unit| wheels.event(unit, counted, before, cells.jumps));
                self.driven(start, time, event)?;
            }
            Role::Reckoned => self.reckoned(cells)?,
            Role::Sensors => self.sensors(cells)?,
            Role::Landmarks => {
                self.to.begin(start)?;
                let id = self.landmark(cells)?;
                let landmark = Landmark { id, x: cells.number("x")?, y: cells.number("y")? };
                self.to.landmark(cells.place("landmark"), landmark)?;
            }
            Role::Truth => {
                self.to.begin(start)?;
                let time = self.kept.stamps.take(cells)?;
                let Some([x, y]) = self.place(cells)? else { return Ok(()) };
                let heading = cells.given("heading")?;
                self.kept.tilted += usize::from(cells.is_tilted("heading"));
                let pose = Pose { time, x, y, theta: heading.unwrap_or(0.0) };
                if cells.source.is_moved() && !self.as_written {
                    self.moved.poses.push((pose, heading.is_some()));
                    return Ok(());
                }
                if heading.is_some() { self.to.truth(pose) } else { self.without_heading.push(pose) }
            }
            Role::Sightings => {
                let columns = ["landmark", "range", "bearing"].map(|value| cells.source.column(value));
                let columns: Vec<usize> = columns.into_iter().flatten().collect();
                if let Some(rows) = lists::rows(cells.line, &columns).map_err(|e| e.within(cells.file))? {
                    return rows.iter().try_for_each(|line| self.take(role, Cells { line, ..cells }));
                }
                self.to.begin(start)?;
                let (time, seen) = (self.kept.stamps.time(cells)?, self.landmark(cells)?);
                self.placed.take(cells, seen)?;
                let range = match cells.range("range", cells.source.column("range").unwrap_or(0))? {
                    Ok(range) => range,
                    Err(none) => return self.kept.without(none),
                };
                let event = match cells.given("bearing")? {
                    Some(bearing) => Event::RangeBearing { landmark: 0, range, bearing },
                    None => Event::Range { landmark: 0, range },
                };
                self.sighting(cells.place("landmark"), Row::new(time, event), seen);
            }
            Role::Ranges => {
                let time = self.kept.stamps.take(cells)?;
                for (seen, column) in cells.source.ranges() {
                    let place = CellPlace::of(cells.file, cells.line, column);
                    let seen = match seen {
                        Of::Called(name) => self.landmarks.named(name),
                        Of::Number(number) => self.landmarks.numbered(number),
                    };
                    let seen = seen.map_err(|message| place.refuse(message))?;
                    match cells.range("first range", column)? {
                        Ok(range) => {
                            self.to.begin(start)?;
                            let row = Row::new(time, Event::Range { landmark: 0, range });
                            self.sighting(place, row, seen);
                        }
                        Err(none) => self.kept.without(none)?,
                    }
                }
            }
            Role::Log | Role::Barcodes | Role::Undecided | Role::Unused => {}
        }
        Ok(())
    }

    /// What the sensors of a row have read; each may be missing.
    fn sensors(&mut self, cells: Cells<'_>) -> Result<(), Error> {
        let (start, time) = (cells.start(), self.kept.stamps.take(cells)?);
        self.kept.unknown += ["v", "heading"].iter().filter(|value| cells.is_absent(value)).count();
        self.kept.tilted += usize::from(cells.is_tilted("heading"));
        self.kept.no_heading += usize::from(cells.is_no_heading("heading"));
        let (v, omega) = (cells.given("v")?, cells.given("omega")?);
        let motion = match (v, omega) {
            (Some(v), Some(omega)) => Some(Event::Velocity { v, omega }),
            (Some(v), None) => Some(Event::Speed { v }),
            (None, Some(omega)) => Some(Event::TurnRate { omega }),
            (None, None) => None,
        };
        motion.map_or(Ok(()), |event| self.motion(start, time, event))?;
        let (place, heading) = (self.place(cells)?, cells.given("heading")?);
        if let Some([x, y]) = place {
            let sigma = self.kept.sigma(cells, "sigma")?;
            self.to.begin(start)?;
            self.kept.fixes.take([x, y], self.to.rows().len());
            self.to.reading(Row::new(time, Event::Position { x, y, sigma }));
        }
        if let Some(theta) = heading {
            let sigma = self.kept.sigma(cells, "sigma of heading")?;
            self.to.begin(start)?;
            self.kept.headings.take(theta, self.to.rows().len());
            self.to.reading(Row::new(time, Event::Heading { theta, sigma }));
        }
        if motion.is_none() && place.is_none() && heading.is_none() {
            self.kept.missing += 1;
        }
        Ok(())
    }

    /// The number of a row's landmark, its own or that of its name.
    fn landmark(&mut self, cells: Cells<'_>) -> Result<u32, Error> {
        let refuse = |message: String| cells.place("landmark").refuse(message);
        match cells.called("landmark") {
            // A barcode is a number.
            Some(name) if self.carried.is_none() => self.landmarks.named(name).map_err(refuse),
            _ => self.landmarks.numbered(cells.whole("landmark")?).map_err(refuse),
        }
    }

    /// A row that says how the robot drove and turned, if it says anything.
    pub fn driven(&mut self, start: CellPlace, time: f64, event: Option<Event>) -> Result<(), Error> {
        let row = match self.turned {
            true => self.way.speed(time, event, self.to.rows().len()),
            false => event.map(|event| Row::new(time, event)),
        };
        row.map_or(Ok(()), |row| self.motion(start, row.time, row.event))
    }

    fn motion(&mut self, start: CellPlace, time: f64, event: Event) -> Result<(), Error> {
        let odometry = matches!(event, Event::Odometry { .. });
        self.rates += usize::from(!odometry);
        self.to.begin(start)?;
        self.to.motion(start, Row::new(time, event), odometry)
    }

    fn sighting(&mut self, place: CellPlace, row: Row, seen: u32) {
        match self.carried.as_ref().map_or(Some(&seen), |carried| carried.get(&seen)) {
            Some(id) => self.to.sighting(place, row, *id, Unplaced::LeftOut),
            None => self.unlisted += 1,
        }
    }

    /// Where a row says that the robot is: in metres, or in degrees about the first one.
    fn place(&mut self, cells: Cells<'_>) -> Result<Option<[f64; 2]>, Error> {
        let (latitude, longitude) = (cells.given("latitude")?, cells.given("longitude")?);
        if let (Some(latitude), Some(longitude)) = (latitude, longitude) {
            for (name, degrees, most) in [("latitude", latitude, 90.0), ("longitude", longitude, 360.0)] {
                if degrees.abs() > most {
                    let message = format!("the {name} is {degrees}\u{b0}; one within {most}\u{b0} was expected");
                    return Err(cells.place(name).refuse(message));
                }
            }
            // Receivers say so before they have a fix.
            if latitude == 0.0 && longitude == 0.0 {
                self.kept.nowhere += 1;
                return Ok(None);
            }
            let origin = self.origin.get_or_insert(Origin::new(latitude, longitude));
            return Ok(Some(origin.metres(latitude, longitude)));
        }
        Ok(cells.given("x")?.zip(cells.given("y")?).map(|(x, y)| [x, y]))
    }

    /// The true poses so far.
    pub fn poses(&self) -> Vec<Pose> {
        let moved = self.moved.poses.iter().map(|(pose, _)| pose);
        self.to.poses().iter().chain(&self.without_heading).chain(moved).copied().collect()
    }

    /// The log, or the part that is kept, and what was left out; its truth is brought onto the fixes by what is given.
    pub fn finish(mut self, own: Option<&Own>, kept: Option<[f64; 2]>) -> Result<Understood, Error> {
        let mut notes = self.notes;
        notes.extend(self.origin.map(|origin| origin.note()));
        notes.extend(self.moved.onto(self.to.rows()));
        for (pose, known) in self.moved.poses {
            if known { self.to.truth(pose) } else { self.without_heading.push(pose) }
        }
        if !self.without_heading.is_empty() {
            headed(&mut self.without_heading).into_iter().for_each(|pose| self.to.truth(pose));
            notes.push(notes::HEADED.into());
        }
        notes.extend(self.landmarks.note());
        notes.extend(self.placed.onto(&mut self.to)?);
        let mapped = self.to.has_landmarks();
        let of_tables = self.to.rows().iter().filter(|row| row.event.is_motion()).count() == self.rates;
        let (mut log, left_out) = self.to.finish(self.carried.is_some())?;
        if let Some(own) = own {
            log.drive.truth = own.truth(&log.drive.truth);
            notes.push(own.note());
        }
        notes.extend(kept.map(|kept| log.cut(kept)));
        let file = |row: &Row| Some(self.files.iter().find(|(_, end)| (row.line as usize) < *end)?.0.as_str());
        notes.extend(crate::no_value::left_out(&mut log.drive.rows));
        notes.extend(twice::left_out(&mut log.drive.rows));
        notes.extend(of_tables.then(|| sampled::changed(&mut log.drive, &self.way)).flatten());
        notes.extend(notes::times(&log.drive, file));
        notes.extend(frames::apart(&log.drive));
        notes.extend(notes::lacking(&log.drive));
        notes.extend(notes::gaps(&log.drive));
        notes.extend(notes::left_out(self.unlisted, left_out, mapped, &log.drive.rows));
        Ok(Understood { notes, landmarks: self.landmarks.names(), ..log.into() })
    }
}
