//! A row of a table: its values in seconds, metres and radians.

use crate::counter::Jumps;
use crate::error::Error;
use crate::fields::{Field, Line, is_none};
use crate::gathering::CellPlace;
use crate::quaternion;
use crate::row;
use crate::source::Source;
use crate::unit::{HUNDREDTHS_FROM_NORTH, QUATERNION, YEAR_FIRST};
use crate::{stamp, trajectory, unit};

/// A row of a table, with the column of each value.
#[derive(Clone, Copy)]
pub(crate) struct Cells<'a> {
    pub file: usize,
    pub line: &'a Line<'a>,
    pub source: &'a Source,
    /// The columns in which −1 stands for what is not known.
    pub absent: &'a [usize],
    /// Where the counters of encoders jump.
    pub jumps: &'a Jumps,
}

impl<'a> Cells<'a> {
    /// Where the row begins.
    pub fn start(&self) -> CellPlace {
        CellPlace { file: self.file, line: self.line.number, column: 1 }
    }

    /// Where a value stands.
    pub fn place(&self, value: &str) -> CellPlace {
        CellPlace::of(self.file, self.line, self.source.column(value).unwrap_or(0))
    }

    fn field(&self, value: &str) -> Option<Field<'a>> {
        self.line.fields.get(self.source.column(value)?).copied()
    }

    /// A field read as a value.
    fn read(&self, value: &str, field: Field<'_>) -> Result<f64, Error> {
        let text = if is_none(field.text) { "" } else { field.text };
        let number = row::finite(self.line, Field { text, ..field }, value).map_err(|e| e.within(self.file))?;
        let unit = self.source.role.index(value).and_then(|at| self.source.units[at]);
        Ok(unit.map_or(number, |unit| unit::convert(unit, number)))
    }

    /// The x, y, z and w of a quaternion, of whose columns one is the value's; `None` where one of them is missing.
    fn quaternion(&self, value: &str) -> Result<Option<[f64; 4]>, Error> {
        let column = self.source.column(value).unwrap_or(0);
        let Some(columns) = quaternion::columns(&self.source.names, column) else {
            return Err(self.place(value).refuse(format!("{value} has no x, y, z and w of a quaternion")));
        };
        let mut parts = [0.0; 4];
        for (part, at) in parts.iter_mut().zip(columns) {
            let Some(field) = self.line.fields.get(at).filter(|field| !is_none(field.text)) else { return Ok(None) };
            *part = row::finite(self.line, *field, value).map_err(|e| e.within(self.file))?;
        }
        Ok(Some(parts))
    }

    /// The heading of a quaternion; `None` of one that is all 0.
    fn turned(&self, value: &str) -> Result<Option<f64>, Error> {
        let Some(parts) = self.quaternion(value)? else { return Ok(None) };
        quaternion::heading(parts).map_err(|message| self.place(value).refuse(message))
    }

    /// Whether a heading is read from a quaternion that is tilted far.
    pub fn is_tilted(&self, value: &str) -> bool {
        let tilted = || matches!(self.quaternion(value), Ok(Some(parts)) if trajectory::is_tilted(parts));
        self.is_in(value, QUATERNION) && tilted()
    }

    /// A value that must be there.
    pub fn number(&self, value: &str) -> Result<f64, Error> {
        let none = Field { text: "", column: self.line.end };
        self.read(value, self.field(value).unwrap_or(none))
    }

    /// A value that a row may lack: its field is empty, or says so.
    pub fn given(&self, value: &str) -> Result<Option<f64>, Error> {
        let absent = self.is_absent(value) || self.is_no_heading(value);
        let Some(field) = self.field(value).filter(|_| !absent) else { return Ok(None) };
        if self.is_in(value, QUATERNION) {
            return self.turned(value);
        }
        if is_none(field.text) { Ok(None) } else { self.read(value, field).map(Some) }
    }

    /// Whether a field says by −1 that its value is not known.
    pub fn is_absent(&self, value: &str) -> bool {
        let column = self.source.column(value).filter(|at| self.absent.contains(at));
        column.and_then(|at| self.line.fields.get(at)).is_some_and(|field| row::number(field.text) == Some(-1.0))
    }

    /// Whether a field says by 65535 that a heading in hundredths of a degree is not known, as MAVLink does.
    pub fn is_no_heading(&self, value: &str) -> bool {
        let number = || self.field(value).and_then(|field| row::number(field.text));
        self.is_in(value, HUNDREDTHS_FROM_NORTH) && number() == Some(65535.0)
    }

    /// Whether a value is read in this unit.
    fn is_in(&self, value: &str, unit: &str) -> bool {
        self.source.role.index(value).and_then(|at| self.source.units[at]).is_some_and(|it| it.name == unit)
    }

    /// The row's time, by the log's clock.
    pub fn time(&self) -> Result<f64, Error> {
        self.own_time().map(|time| time + self.source.said_clock_shift().unwrap_or(0.0))
    }

    /// The row's time, its seconds and their fraction together, as they stand in the file.
    fn own_time(&self) -> Result<f64, Error> {
        let Some(field) = self.field("time") else { return self.number("time") };
        if self.source.is_date() {
            let refuse = || self.place("time").refuse("the time is no date; one as 2026-05-01T12:00:00Z was expected");
            return Ok(stamp::seconds(field.text).ok_or_else(refuse)? + self.day()?);
        }
        let seconds = self.read("time", field)?;
        let time = seconds + self.field("fraction").map_or(Ok(0.0), |_| self.number("fraction"))?;
        row::in_bounds(self.line, field, time).map_err(|e| e.within(self.file))
    }

    /// When the day of a time of day began, of a row that has the two in two columns.
    fn day(&self) -> Result<f64, Error> {
        let Some(field) = self.field("day") else { return Ok(0.0) };
        let unit = self.source.role.index("day").and_then(|at| self.source.units[at]);
        let order = unit.map_or(YEAR_FIRST, |unit| unit.name);
        let refuse = || self.place("day").refuse(format!("the day is none; one as {order} was expected"));
        stamp::day(field.text, order).ok_or_else(refuse)
    }

    /// Whether the time is one of a day without its date.
    pub fn is_time_of_day(&self) -> bool {
        self.source.column("day").is_none()
            && self.source.is_date()
            && self.field("time").is_some_and(|field| stamp::is_time_of_day(field.text))
    }

    /// The number of a landmark. A program that keeps all numbers in one table writes 5 as 5.0.
    pub fn whole(&self, value: &str) -> Result<u32, Error> {
        let number = self.number(value)?;
        if number.fract() == 0.0 && (0.0..4_294_967_296.0).contains(&number) {
            return Ok(number as u32);
        }
        Err(self.place(value).refuse(format!("{value} is {number}; a whole number below 2^32 was expected")))
    }

    /// What a landmark is called, where that is no number.
    pub fn called(&self, value: &str) -> Option<&'a str> {
        self.field(value).map(|field| field.text).filter(|text| !is_none(text) && row::number(text).is_none())
    }

    /// The range in a column, or how the field says that there was none.
    pub fn range(&self, value: &str, column: usize) -> Result<Result<f64, NoRange>, Error> {
        let text = self.line.fields.get(column).map_or("", |field| field.text);
        let Some(field) = self.line.fields.get(column).filter(|_| !is_none(text)) else {
            return Ok(Err(NoRange::Missing));
        };
        match row::number(text) {
            Some(0.0) => return Ok(Err(NoRange::Zero)),
            Some(-1.0) => return Ok(Err(NoRange::MinusOne)),
            Some(number) if number.is_nan() => return Ok(Err(NoRange::Missing)),
            Some(number) if number == f64::INFINITY => return Ok(Err(NoRange::Infinite)),
            _ => {}
        }
        let range = self.read(value, *field)?;
        let place = CellPlace::of(self.file, self.line, column);
        match range {
            _ if range >= 0.0 => Ok(Ok(range)),
            _ if range > -1.0 => Ok(Err(NoRange::Negative)),
            _ => Err(place.refuse("a range of at least 0 was expected")),
        }
    }
}

/// How a row says that its sensor has read no range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoRange {
    /// The field is empty, or has no number.
    Missing,
    Zero,
    MinusOne,
    Infinite,
    /// Below 0 by less than a metre.
    Negative,
}
