//! A file of a log: its text, how it is read, and what follows from that.

use crate::cells::Cells;
use crate::columns;
use crate::counter::Jumps;
use crate::error::Error;
use crate::evidence;
use crate::fields::Line;
use crate::guess;
use crate::notes;
use crate::parse;
use crate::reading::LogReader;
use crate::role::Role;
use crate::row;
use crate::several::{grouped, several};
use crate::source::{Question, Source};
use crate::table::Table;
use crate::unit::{self, Unit};
use crate::wheels::{Counting, Wheels, is_speed};

/// A file of a log, and how it is read.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    name: String,
    text: String,
    pub(crate) source: Source,
}

impl File {
    /// A file, and a guess how it is read.
    pub(crate) fn new(name: &str, text: &str) -> Self {
        // Some spreadsheets end a line with a carriage return alone.
        let text = if text.contains('\n') { text.to_string() } else { text.replace('\r', "\n") };
        let source = guess::guess(name, &text);
        let mut file = Self { name: name.to_string(), text, source };
        file.tell_apart();
        file
    }

    /// Looks whether a column tells the rows of several robots apart; another column than before asks anew.
    fn tell_apart(&mut self) {
        let source = &mut self.source;
        let table = source.table.as_ref();
        let found = table.and_then(|table| several(source.role, table, &source.names, &source.columns, &self.text));
        if found != source.several {
            (source.several, source.only) = (found, None);
        }
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
        let mut asks = self.source.asks();
        if self.wheels().counting == Some(Counting::Total) {
            asks.extend(self.odd_jumps());
        }
        asks
    }

    /// The column whose names tell the rows of several robots apart, and each name with the number of its rows; `None`
    /// of a file without such a column.
    pub fn several(&self) -> Option<(usize, &[(String, usize)])> {
        self.source.several.as_ref().map(|several| (several.column, several.values.as_slice()))
    }

    /// Whose rows are read: one's, or all of them; `None` where that is asked or there is nothing to be said.
    pub fn only(&self) -> Option<Option<&str>> {
        self.source.only.as_ref().map(Option::as_deref)
    }

    /// What is said of rows that are left out, as they are another robot's.
    pub(crate) fn others(&self) -> Option<String> {
        let (several, only) = (self.source.several.as_ref()?, self.only()??);
        let rows = several.values.iter().filter(|(value, _)| value != only).map(|(_, rows)| rows).sum();
        let (name, column) = (&self.name, &self.header()[several.column]);
        Some(format!("{name}: only the rows whose {column} is {only} are read; {} are not.", grouped(rows)))
    }

    /// The jumps of its encoders that neither motion nor the end of a counter's range explains, as a question.
    fn odd_jumps(&self) -> Option<String> {
        let jumps = self.jumps();
        let first = jumps.odd.first()?;
        let column = self.source.column(["left", "right"][first.side])?;
        let (name, line, from, to) = (&self.header()[column], first.line, first.from, first.to);
        let more = jumps.odd.len() - 1;
        let others = if more == 0 { String::new() } else { format!(" ({more} more like it)") };
        Some(format!(
            "In line {line} \u{201c}{name}\u{201d} jumps from {from} to {to}, which no motion does{others}: mend the \
             file, or say that the count begins anew at a jump."
        ))
    }

    /// Where its encoders' counts jump, as far as they are totals.
    fn jumps(&self) -> Jumps {
        let Source { table: Some(table), units, columns, wheels, .. } = &self.source else { return Jumps::default() };
        let counts = matches!(wheels.counting, Some(Counting::Total | Counting::Restarted));
        let Some(unit) = units.get(1).copied().flatten().filter(|unit| counts && !is_speed(unit.name)) else {
            return Jumps::default();
        };
        let [Some(time), Some(left), Some(right)] = [0, 1, 2].map(|i| columns[i]) else { return Jumps::default() };
        let number = |line: &Line<'_>, at: usize| row::number(line.fields.get(at)?.text).filter(|it| it.is_finite());
        let lines = table.lines(&self.text).filter_map(Result::ok).filter(|line| self.source.is_read(line));
        let counted = lines.filter_map(|line| {
            let [left, right] = [number(&line, left)?, number(&line, right)?].map(|it| unit::convert(unit, it));
            // Of dates the difference does not matter: then the steps themselves are compared.
            Some((line.number, number(&line, time).unwrap_or(0.0), [left, right]))
        });
        Jumps::of(&counted.collect::<Vec<_>>(), unit)
    }

    /// What its reader should know of how it was read.
    pub(crate) fn notes(&self) -> Vec<String> {
        let unit = self.source.units.get(1).copied().flatten();
        let counted =
            unit.filter(|_| self.role() == Role::Encoders).and_then(|unit| self.jumps().note(&self.name, unit));
        let frame = notes::frame(&self.name, &self.source);
        self.others().into_iter().chain(counted).chain(self.left_speed()).chain(frame).collect()
    }

    /// What is said of it where it is not used.
    pub(crate) fn unused(&self) -> String {
        notes::unused(&self.name, &self.source.names)
    }

    /// Whether a question is about a value of its role, the `at`-th: about its column, or its unit.
    pub fn is_asked(&self, at: usize) -> bool {
        self.source.is_asked(at)
    }

    /// Three values of a column as they stand in the file: of its first, a middle and the last of its first rows, or
    /// the first three that are there where most rows have none. A column without any has one that is empty.
    pub fn samples(&self, column: usize) -> Vec<&str> {
        self.source.table.as_ref().map_or(Vec::new(), |table| evidence::samples(table, &self.text, column))
    }

    /// What follows from how it is read, in words: "20 Hz, 0 to 120 s, v −0.1 … 1 m/s, turned 2 turns". Empty where it
    /// is not read as a table, where it asks something, and as far as a row is at fault.
    pub fn follows(&self) -> String {
        if self.source.table.is_none() || self.check().is_err() || !self.asks().is_empty() {
            return String::new();
        }
        let mut reading = LogReader::default();
        let role = self.role();
        let _ = self.rows(0, |row| reading.take(role, row));
        evidence::follows(&reading)
    }

    pub(crate) fn set_role(&mut self, role: Role) {
        self.source.role = role;
        self.source.undecided = (role == Role::Undecided).then(|| Question::open("What is it?"));
        columns::columns(&mut self.source, &self.name, &self.text);
        self.tell_apart();
    }

    pub(crate) fn set_only(&mut self, only: Option<&str>) -> bool {
        let Some(several) = &self.source.several else { return false };
        let known = only.is_none_or(|only| several.values.iter().any(|(value, _)| value == only));
        if known {
            self.source.only = Some(only.map(String::from));
        }
        known
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
        self.tell_apart();
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
        let (absent, jumps) = (self.absent(table), self.jumps());
        let mut none = matches!(source.role, Role::Velocities | Role::Odometry | Role::Encoders | Role::Sensors);
        for line in table.lines(&self.text) {
            none = false;
            let line = line.map_err(|e| e.within(index))?;
            parse::check_text(&line).map_err(|e| e.within(index))?;
            if source.is_read(&line) {
                take(Cells { file: index, line: &line, source, absent: &absent, jumps: &jumps })?;
            }
        }
        if none { Err(refuse("the file has no row of numbers".into())) } else { Ok(()) }
    }
}
