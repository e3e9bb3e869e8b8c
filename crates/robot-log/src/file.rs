//! A file of a log: its text, how it is read, and what follows from that.

use crate::cells::Cells;
use crate::clocks::clocks;
use crate::columns;
use crate::error::Error;
use crate::evidence;
use crate::fields::Line;
use crate::guess;
use crate::holds::Again;
use crate::notes;
use crate::order::Order;
use crate::parse;
use crate::role::Role;
use crate::row;
use crate::several::{grouped, several};
use crate::source::{Known, Source};
use crate::stamp;
use crate::table::Table;
use crate::unit::{self, Unit};
use crate::wheels::{Counting, Wheels, needed};
use std::sync::Arc;

/// A file of a log, and how it is read.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    name: String,
    text: Arc<str>,
    pub(crate) source: Source,
    /// Of which file it is another reading.
    pub(crate) again: Option<Again>,
}

impl File {
    /// A file, and a guess how it is read.
    pub(crate) fn new(name: &str, text: &str) -> Self {
        // Some spreadsheets end a line with a carriage return alone.
        let text: Arc<str> = if text.contains('\n') { text.into() } else { text.replace('\r', "\n").into() };
        let source = guess::guess(name, &text);
        let mut file = Self { name: name.to_string(), text, source, again: None };
        file.tell_apart();
        file
    }

    /// Looks which column tells several robots apart, what follows from each of several clocks, and the rows' order.
    fn tell_apart(&mut self) {
        let source = &mut self.source;
        source.clocks = clocks(source, &self.name, &self.text);
        let table = source.table.as_ref();
        let found = table.and_then(|table| several(source.role, table, &source.names, &source.columns, &self.text));
        if found != source.several {
            (source.several, source.only) = (found, None);
        }
        self.source.order = self.find_order();
    }

    pub(crate) fn rename(&mut self, name: String) {
        self.name = name;
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

    /// What of them has to be said in the unit of its columns, and `counting`, how they count; nothing of other files.
    pub fn needs(&self) -> &'static [&'static str] {
        match self.role() {
            Role::Encoders => needed(self.source.units[1].map(|unit| unit.name)),
            _ => &[],
        }
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

    /// What its reader should know of how it was read.
    pub(crate) fn notes(&self) -> Vec<String> {
        let unit = self.source.units.get(1).copied().flatten();
        let counted =
            unit.filter(|_| self.role() == Role::Encoders).and_then(|unit| self.jumps().note(&self.name, unit));
        let frame = notes::frame(&self.name, &self.source);
        let order = self.source.order.as_ref().map(|order| order.note(&self.name));
        let cut = self.source.table.as_ref().and_then(|table| Some(notes::cut(&self.name, table.cut?)));
        let all = self.others().into_iter().chain(order).chain(counted).chain(self.left_speed());
        all.chain(frame).chain(cut).chain(self.pose_jumps_note()).collect()
    }

    /// What is said of it where it is not used.
    pub(crate) fn unused(&self) -> String {
        match &self.source.same_as {
            Some(other) => format!("{} is not used: it is the same as {other}", self.name),
            None => notes::unused(&self.name, &self.source.names),
        }
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

    pub(crate) fn set_role(&mut self, role: Role) {
        self.source.role = role;
        self.source.undecided = (role == Role::Undecided).then(|| crate::question::Question::open("What is it?"));
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
        source.known(value, Known::Guessed);
        source.units[at] = columns::unit(source, at, &self.name, &self.text);
        self.tell_apart();
        true
    }

    pub(crate) fn set_unit(&mut self, value: &str, unit: &str) -> bool {
        let Some(at) = self.source.role.index(value) else { return false };
        let Some(unit) = unit::named(self.source.role.values()[at].quantity, unit) else { return false };
        self.source.units[at] = Some(unit);
        self.source.known(value, Known::Said);
        self.source.order = self.find_order();
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

    /// Finds the order in which its rows have to be read; `None` where it is that of the file. Only rows of motion need
    /// it, of which one goes on from another.
    fn find_order(&self) -> Option<Order> {
        let source = &self.source;
        // What goes back at midnight, or belongs to another robot, is none.
        if !source.moves() || source.column("day").is_some() || source.several.is_some() {
            return None;
        }
        let (table, at) = (source.table.as_ref()?, source.column("time")?);
        let unit = source.units.first().copied().flatten()?;
        let time = |text: &str| match source.is_date() {
            true => Some(stamp::seconds(text).filter(|_| !stamp::is_time_of_day(text))?),
            false => row::number(text).map(|number| unit::convert(unit, number)),
        };
        let times = table.column(&self.text, at).filter_map(|(line, text)| Some((line, time(text)?)));
        Order::of(times.filter(|(_, time)| time.is_finite()))
    }

    /// Its lines in the order in which they are read.
    pub(crate) fn lines<'t>(&'t self, table: &'t Table) -> Box<dyn Iterator<Item = Result<Line<'t>, Error>> + 't> {
        match &self.source.order {
            None => Box::new(table.lines(&self.text)),
            Some(order) => Box::new(order.lines().into_iter().flat_map(|part| table.lines_within(&self.text, part))),
        }
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
        let mut none = source.role.moves() && source.role != Role::Log;
        for line in self.lines(table) {
            none = false;
            let line = line.map_err(|e| e.within(index))?;
            parse::check_text(&line).map_err(|e| e.within(index))?;
            if source.is_read(&line) && !source.says_nothing(&line) {
                take(Cells { file: index, line: &line, source, absent: &absent, jumps: &jumps })?;
            }
        }
        if none { Err(refuse("the file has no row of numbers".into())) } else { Ok(()) }
    }
}
