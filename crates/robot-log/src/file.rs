//! A file of a log: its text, how it is read, and what follows from that.

use crate::cells::Cells;
use crate::columns;
use crate::error::Error;
use crate::evidence;
use crate::guess;
use crate::parse;
use crate::reading::Reading;
use crate::role::Role;
use crate::row;
use crate::source::Source;
use crate::table::Table;
use crate::unit::{self, Unit};
use crate::wheels::{Counting, Wheels};

/// How many values of a column are shown, of the first rows.
const SAMPLES: usize = 3;
const SAMPLED: usize = 200;

/// A file of a log, and how it is read.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    name: String,
    text: String,
    source: Source,
}

impl File {
    /// A file, and a guess how it is read.
    pub(crate) fn new(name: &str, text: &str) -> Self {
        // Some spreadsheets end a line with a carriage return alone.
        let text = if text.contains('\n') { text.to_string() } else { text.replace('\r', "\n") };
        let source = guess::guess(name, &text);
        Self { name: name.to_string(), text, source }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// What it is read as.
    pub fn role(&self) -> Role {
        self.source.role
    }

    /// What its columns are called; none of a file that is no table.
    pub fn header(&self) -> &[String] {
        self.source.table.as_ref().map_or(&[], |table| &table.names)
    }

    /// How many lines above its rows are neither names nor comments.
    pub(crate) fn words(&self) -> usize {
        self.source.table.as_ref().map_or(0, |table| table.words)
    }

    /// For each value of its role the column that it is read from.
    pub fn columns(&self) -> &[Option<usize>] {
        &self.source.columns
    }

    /// For each value of its role the unit that it is read in; `None` where it has none, no column, or where the unit
    /// is asked.
    pub fn units(&self) -> &[Option<&'static Unit>] {
        &self.source.units
    }

    /// What its encoders need besides.
    pub fn wheels(&self) -> &Wheels {
        &self.source.wheels
    }

    /// What has to be said before it can be read, in sentences: a guess that is not certain chooses nothing.
    pub fn asks(&self) -> Vec<String> {
        self.source.asks()
    }

    /// Whether a question is about a value of its role, the `at`-th: about its column, or its unit.
    pub fn is_asked(&self, at: usize) -> bool {
        self.source.is_asked(at)
    }

    /// Three values of a column as they stand in the file: of its first, a middle and the last of its first rows.
    pub fn samples(&self, column: usize) -> Vec<&str> {
        let Some(table) = &self.source.table else { return Vec::new() };
        let lines = table.lines(&self.text).filter_map(Result::ok).take(SAMPLED);
        let all: Vec<&str> = lines.filter_map(|line| line.fields.get(column).map(|field| field.text)).collect();
        match all.as_slice() {
            all if all.len() <= SAMPLES => all.to_vec(),
            all => vec![all[0], all[all.len() / 2], all[all.len() - 1]],
        }
    }

    /// What follows from how it is read, in words: "20 Hz, 0 to 120 s, v −0.1 … 1 m/s, turned 2 turns". Empty where it
    /// is not read as a table, where it asks something, and as far as a row is at fault.
    pub fn follows(&self) -> String {
        if self.source.table.is_none() || self.check().is_err() || !self.asks().is_empty() {
            return String::new();
        }
        let mut reading = Reading::default();
        let role = self.role();
        let _ = self.rows(0, |row| reading.take(role, row));
        evidence::follows(&reading)
    }

    pub(crate) fn set_role(&mut self, role: Role) {
        self.source.role = role;
        self.source.undecided = (role == Role::Undecided).then(|| "What is it?".into());
        columns::columns(&mut self.source, &self.name, &self.text);
    }

    pub(crate) fn set_column(&mut self, value: &str, column: Option<usize>) -> bool {
        let Some(at) = self.source.role.index(value) else { return false };
        if column.is_some_and(|column| column >= self.header().len()) {
            return false;
        }
        let source = &mut self.source;
        source.columns[at] = column;
        source.doubts[at].clear();
        source.units[at] = columns::unit(source, at, &self.name, &self.text);
        true
    }

    pub(crate) fn set_unit(&mut self, value: &str, unit: &str) -> bool {
        let Some(at) = self.source.role.index(value) else { return false };
        let Some(unit) = unit::named(self.source.role.values()[at].quantity, unit) else { return false };
        self.source.units[at] = Some(unit);
        true
    }

    pub(crate) fn set_wheel(&mut self, name: &str, number: f64) -> bool {
        self.role() == Role::Encoders && self.source.wheels.set(name, number)
    }

    pub(crate) fn set_counting(&mut self, counting: Counting) -> bool {
        let wheels = self.role() == Role::Encoders;
        if wheels {
            self.source.wheels.counting = Some(counting);
        }
        wheels
    }

    /// Refuses what no choice would mend: a log of another program, an empty file, a header that is none.
    pub(crate) fn check(&self) -> Result<(), Error> {
        // A table whose header is wrong may be used for nothing, and that would be said instead.
        if let Some(fault) = self.source.table.as_ref().and_then(|table| table.fault.clone()) {
            return Err(fault);
        }
        if self.role() == Role::Unused {
            return Ok(());
        }
        if let Some(why) = &self.source.refused {
            return Err(Error::new(1, 1, why.clone()));
        }
        match self.text.trim_matches([' ', '\n', '\r', '\t', '\u{feff}']).is_empty() {
            true => Err(Error::new(1, 1, "the file is empty")),
            false => Ok(()),
        }
    }

    /// The columns of a receiver's speed and course in which −1 says that they are not known, as phones write it: no
    /// other of their numbers is below 0.
    fn absent(&self, table: &Table) -> Vec<usize> {
        let column = |value: &str| self.source.column(value);
        if self.role() != Role::Sensors || column("latitude").is_none() {
            return Vec::new();
        }
        let columns = ["v", "heading"].into_iter().filter_map(column);
        let below = |at: usize| {
            let fields =
                table.lines(&self.text).filter_map(Result::ok).filter_map(move |line| line.fields.get(at).copied());
            fields.filter_map(|field| row::number(field.text)).filter(|number| *number < 0.0)
        };
        columns.filter(|at| below(*at).all(|number| number == -1.0)).collect()
    }

    /// Hands over each row, its values known by their names in the role.
    pub(crate) fn rows(&self, index: usize, mut take: impl FnMut(Cells<'_>) -> Result<(), Error>) -> Result<(), Error> {
        let source = &self.source;
        let refuse = |message: String| Error::new(1, 1, message).within(index);
        let Some(table) = &source.table else { return Err(refuse("the file has no row of numbers".into())) };
        if let Some(value) = source.lacks() {
            let role = source.role.name();
            return Err(refuse(format!("no column has been chosen for {value}, which {role} need")));
        }
        let absent = self.absent(table);
        let mut none = matches!(source.role, Role::Velocities | Role::Odometry | Role::Encoders | Role::Sensors);
        for line in table.lines(&self.text) {
            none = false;
            let line = line.map_err(|e| e.within(index))?;
            parse::check_text(&line).map_err(|e| e.within(index))?;
            take(Cells { file: index, line: &line, source, absent: &absent })?;
        }
        if none { Err(refuse("the file has no row of numbers".into())) } else { Ok(()) }
    }
}
