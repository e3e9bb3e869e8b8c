//! Rows of tables become rows of a log: values by their columns, in seconds, metres and radians.

use crate::error::Error;
use crate::fields::Line;
use crate::gathering::{Gathering, Place, Unplaced};
use crate::log::Understood;
use crate::role::Role;
use crate::row;
use crate::source::Source;
use estimate::Landmark;
use estimate::drive::{Drive, Event, Pose, Row};
use std::collections::HashMap;

/// Where the truth has no heading, it is the direction to the next true position that is so far away, m.
const HEADING_OVER: f64 = 0.2;

/// A row of a table, with the column of each value.
pub(crate) struct Cells<'a> {
    pub file: usize,
    pub line: &'a Line<'a>,
    pub source: &'a Source,
}

impl Cells<'_> {
    fn place(&self, value: usize) -> Place {
        Place::of(self.file, self.line, self.source.columns[value].unwrap_or(0))
    }

    /// A value in seconds, metres and radians.
    fn number(&self, value: usize) -> Result<f64, Error> {
        let known = &self.source.role.values()[value];
        let field = self.line.fields[self.source.columns[value].unwrap_or(0)];
        let number = row::finite(self.line, field, known.name).map_err(|e| e.within(self.file))?;
        Ok(self.source.units.convert(known.quantity, number))
    }

    fn given(&self, value: usize) -> Result<Option<f64>, Error> {
        self.source.columns[value].map(|_| self.number(value)).transpose()
    }

    fn time(&self) -> Result<f64, Error> {
        let field = self.line.fields[self.source.columns[0].unwrap_or(0)];
        row::in_bounds(self.line, field, self.number(0)?).map_err(|e| e.within(self.file))
    }

    /// The number of a landmark. A program that keeps all numbers in one table writes 5 as 5.0.
    pub fn whole(&self, value: usize) -> Result<u32, Error> {
        let number = self.number(value)?;
        if number.fract() == 0.0 && (0.0..4_294_967_296.0).contains(&number) {
            return Ok(number as u32);
        }
        let name = self.source.role.values()[value].name;
        Err(self.place(value).refuse(format!("{name} is {number}; a whole number below 2^32 was expected")))
    }

    fn range(&self, value: usize) -> Result<f64, Error> {
        let range = self.number(value)?;
        if range >= 0.0 { Ok(range) } else { Err(self.place(value).refuse("a range of at least 0 was expected")) }
    }
}

/// A log while its tables are read.
#[derive(Default)]
pub(crate) struct Reading {
    pub to: Gathering,
    /// The landmark that carries each barcode.
    carried: Option<HashMap<u32, u32>>,
    /// Sightings of a barcode that is in no list.
    unlisted: usize,
    /// True poses whose heading is not known.
    without_heading: Vec<Pose>,
}

impl Reading {
    /// Nothing yet; `carried` is the landmark that carries each barcode, where a file says so.
    pub fn new(carried: Option<HashMap<u32, u32>>) -> Self {
        Self { carried, ..Self::default() }
    }

    /// Takes a row of a table.
    pub fn take(&mut self, role: Role, cells: Cells<'_>) -> Result<(), Error> {
        let start = Place { column: 1, ..cells.place(0) };
        self.to.begin(start)?;
        match role {
            Role::Velocities => {
                let event = Event::Velocity { v: cells.number(1)?, omega: cells.number(2)? };
                self.to.motion(start, Row::new(cells.time()?, event))?;
            }
            Role::Odometry => {
                let event = Event::Odometry { distance: cells.number(1)?, turn: cells.number(2)? };
                self.to.motion(start, Row::new(cells.time()?, event))?;
            }
            Role::Landmarks => {
                let landmark = Landmark { id: cells.whole(0)?, x: cells.number(1)?, y: cells.number(2)? };
                self.to.landmark(cells.place(0), landmark)?;
            }
            Role::Truth => {
                let (time, x, y) = (cells.time()?, cells.number(1)?, cells.number(2)?);
                match cells.given(3)? {
                    Some(theta) => self.to.truth(Pose { time, x, y, theta }),
                    None => self.without_heading.push(Pose { time, x, y, theta: 0.0 }),
                }
            }
            Role::Sightings => {
                let (time, range, seen) = (cells.time()?, cells.range(2)?, cells.whole(1)?);
                let event = match cells.given(3)? {
                    Some(bearing) => Event::RangeBearing { landmark: 0, range, bearing },
                    None => Event::Range { landmark: 0, range },
                };
                match self.carried.as_ref().map_or(Some(&seen), |carried| carried.get(&seen)) {
                    Some(id) => self.to.sighting(cells.place(1), Row::new(time, event), *id, Unplaced::LeftOut),
                    None => self.unlisted += 1,
                }
            }
            Role::Log | Role::Barcodes | Role::Unused => {}
        }
        Ok(())
    }

    /// The log, and what was left out of it.
    pub fn finish(mut self) -> Result<Understood, Error> {
        let mut notes = Vec::new();
        if !self.without_heading.is_empty() {
            headed(&mut self.without_heading).into_iter().for_each(|pose| self.to.truth(pose));
            notes.push(format!("The truth has no heading; the first {HEADING_OVER} m of its way gives the first one."));
        }
        let mapped = self.to.has_landmarks();
        let (log, left_out) = self.to.finish(self.carried.is_some())?;
        notes.extend(times(&log.drive));
        if self.unlisted > 0 {
            notes.push(format!("{} left out: no list has the barcode.", readings(self.unlisted)));
        }
        if left_out > 0 && mapped {
            notes.push(format!("{} left out: another robot was seen.", readings(left_out)));
        }
        if left_out > 0 && !mapped {
            let left_out = readings(left_out);
            notes.push(format!("{left_out} left out: no file says where the landmarks are. This is dead reckoning."));
        }
        Ok(Understood { log, notes })
    }
}

/// What is strange about the times of a drive. A wrong column, a wrong unit or a second clock shows here.
fn times(drive: &Drive) -> Option<String> {
    let span = |motion: bool| {
        let mut times = drive.rows.iter().filter(|row| row.event.is_motion() == motion).map(|row| row.time);
        let first = times.next()?;
        Some([first, times.next_back().unwrap_or(first)])
    };
    let motion = span(true)?;
    let truth = drive.truth.poses().first().zip(drive.truth.poses().last()).map(|(a, b)| [a.time, b.time]);
    let apart = |other: Option<[f64; 2]>| other.is_some_and(|[from, to]| to < motion[0] || motion[1] < from);
    let beside = [(truth, "The true positions"), (span(false), "The sightings")];
    if let Some((_, what)) = beside.into_iter().find(|(span, _)| apart(*span)) {
        return Some(format!("{what} are all before the motion or after it: is another clock or unit meant?"));
    }
    let rows = drive.rows.iter().filter(|row| row.event.is_motion()).count();
    (rows > 1 && motion[0] == motion[1])
        .then(|| "All rows of motion have the same time: is it in another column?".into())
}

fn readings(count: usize) -> String {
    if count == 1 { "1 reading".into() } else { format!("{count} readings") }
}

/// The poses by time, each headed for the next that is [`HEADING_OVER`] away; the last ones as the one before.
fn headed(poses: &mut [Pose]) -> Vec<Pose> {
    poses.sort_by(|a, b| a.time.total_cmp(&b.time));
    let (mut to, mut theta) = (0, 0.0);
    for i in 0..poses.len() {
        let from = poses[i];
        let away = |at: &Pose| (at.x - from.x) * (at.x - from.x) + (at.y - from.y) * (at.y - from.y);
        to = to.max(i);
        while to < poses.len() && away(&poses[to]) < HEADING_OVER * HEADING_OVER {
            to += 1;
        }
        if let Some(next) = poses.get(to) {
            theta = libm::atan2(next.y - from.y, next.x - from.x);
        }
        poses[i].theta = theta;
    }
    poses.to_vec()
}
