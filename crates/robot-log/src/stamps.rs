//! The times of a file's rows, one after the other: those that repeat, go back, or begin anew.

use crate::cells::Cells;
use crate::error::Error;
use crate::gathering::CellPlace;
use crate::order::{BACK, ROWS};
use crate::other_clock::{Span, join};
use std::hash::{DefaultHasher, Hash, Hasher};

/// A day, s: a time of day that goes back by more than half of it has passed midnight.
const DAY: f64 = 86_400.0;

/// How many rows are of a kind, and the line of the first.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counted {
    pub count: usize,
    pub line: u32,
}

impl Counted {
    fn take(&mut self, line: u32) {
        self.count += 1;
        if self.count == 1 {
            self.line = line;
        }
    }
}

/// A clock that has gone back.
#[derive(Clone, Copy, Debug)]
struct Back {
    place: CellPlace,
    from: f64,
    to: f64,
    /// How many rows have gone on from there.
    rows: u32,
}

/// What is counted of times.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stamps {
    pub rows: usize,
    /// Rows with the time of the one before, and those of them that are the one before to the last digit.
    pub repeats: Counted,
    pub doubles: Counted,
    /// Times before that of the row before.
    pub backward: Counted,
    /// From when to when they are.
    pub span: Option<Span>,
    /// The last time of day as it stands in the file, and how many midnights have passed.
    of_day: Option<(f64, f64)>,
    last: Option<(f64, u64)>,
    back: Option<Back>,
}

impl Stamps {
    /// The time of a row.
    ///
    /// # Errors
    /// It is no time; the clock of a file of motion has begun anew.
    pub fn take(&mut self, cells: Cells<'_>) -> Result<f64, Error> {
        let (time, line) = (self.time(cells)?, cells.line.number);
        let mut hasher = DefaultHasher::new();
        cells.line.fields.iter().for_each(|field| field.text.hash(&mut hasher));
        let row = hasher.finish();
        if let Some((before, same)) = self.last.replace((time, row)) {
            if before == time {
                self.repeats.take(line);
                if same == row {
                    self.doubles.take(line);
                }
            }
            if time < before {
                self.backward.take(line);
            }
            self.anew(cells, before, time)?;
        }
        self.rows += 1;
        Ok(time)
    }

    /// The time of one of several rows of a moment. A time of day that has passed midnight is one of the next day.
    ///
    /// # Errors
    /// It is no time.
    pub fn time(&mut self, cells: Cells<'_>) -> Result<f64, Error> {
        let mut time = cells.time()?;
        if cells.is_time_of_day() {
            if let Some((before, day)) = &mut self.of_day {
                *day += libm::round((*before - time) / DAY);
                *before = time;
                time += DAY * *day;
            } else {
                self.of_day = Some((time, 0.0));
            }
        }
        self.span = Some(self.span.map_or([time; 2], |span| join(span, [time; 2])));
        Ok(time)
    }

    /// Refuses a second run: its rows would be taken among those of the first.
    fn anew(&mut self, cells: Cells<'_>, before: f64, time: f64) -> Result<(), Error> {
        if time < before - BACK {
            self.back = Some(Back { place: cells.place("time"), from: before, to: time, rows: 0 });
            return Ok(());
        }
        let Some(back) = &mut self.back else { return Ok(()) };
        back.rows += u32::from(time > before);
        let Back { place, from, to, rows } = *back;
        if time > from {
            self.back = None;
        }
        if rows < ROWS || !cells.source.moves() || self.back.is_none() {
            return Ok(());
        }
        Err(place.refuse(format!(
            "the time goes back here from {from} to {to} s, and on from there; a second run is another log: part the \
             file at this line"
        )))
    }

    /// What was strange in a file.
    pub fn notes(&self, name: &str) -> Vec<String> {
        let Self { rows, repeats, doubles, backward, .. } = *self;
        let many = |counted: Counted| rows >= 5 && 5 * counted.count > rows;
        let mut notes = Vec::new();
        if self.of_day.is_some_and(|(_, days)| days != 0.0) {
            notes.push(format!("{name}: its times of day pass midnight, and are of the next day from there on."));
        }
        if many(repeats) {
            notes.push(format!(
                "{name}: {} of {rows} times repeat the one before. Are fractions of a second in another column?",
                repeats.count
            ));
        } else if rows >= 5 {
            let some = |counted: Counted, one: &str, more: &str| {
                let Counted { count, line } = counted;
                let what = if count == 1 { format!("1 row {one}") } else { format!("{count} rows {more}") };
                let first = if count == 1 { "in" } else { "the first in" };
                (count > 0).then(|| format!("{name}: {what}, {first} line {line}"))
            };
            let twice = "what was written twice is taken twice, so leave it out of the file";
            let said = some(doubles, "is the one before to the last digit", "are the one before to the last digit");
            notes.extend(said.map(|said| format!("{said}: {twice}.")));
            if repeats.count > doubles.count {
                let said = some(repeats, "has the time of the one before", "have the time of the one before");
                notes.extend(said.map(|said| format!("{said}.")));
            }
        }
        if many(backward) {
            notes.push(format!(
                "{name}: {} of {rows} times lie before the one above. Is the time in another column?",
                backward.count
            ));
        } else if backward.count > 0 {
            let Counted { count, line } = backward;
            let what = if count == 1 { "1 time lies".into() } else { format!("{count} times lie") };
            let first = if count == 1 { "in" } else { "the first in" };
            notes.push(format!(
                "{name}: {what} before the one above, {first} line {line}. Rows are taken by their times."
            ));
        }
        notes
    }
}
