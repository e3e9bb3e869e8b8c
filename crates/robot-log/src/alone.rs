//! What a file says by itself: what follows from how it is read, what is wrong with its rows, and whether it may say
//! how the robot moved.

use crate::error::Error;
use crate::evidence;
use crate::fields::{Field, is_none};
use crate::file::File;
use crate::gathering::Gathering;
use crate::names::candidates;
use crate::parse;
use crate::reading::LogReader;
use crate::role::{Quantity, Role, Value};
use crate::row;
use crate::source::Source;
use crate::unit::QUATERNION;

impl File {
    /// What follows from how it is read, in words: "20 Hz, 0 to 120 s, v \u{2212}0.1 \u{2026} 1 m/s, turned 2 turns".
    /// Empty where it is not read as a table, where it asks something, and as far as a row is at fault.
    pub fn follows(&self) -> String {
        self.alone().0
    }

    /// What is wrong with it whatever the other files are, as far as that is known: the first fault of its rows. Of a
    /// file that asks something, its rows are looked at as far as no answer changes them.
    pub fn fault(&self) -> Option<Error> {
        self.alone().1
    }

    /// What follows from how it is read ([`File::follows`]), and what is wrong with it ([`File::fault`]).
    pub fn alone(&self) -> (String, Option<Error>) {
        if let Err(fault) = self.check() {
            return (String::new(), Some(fault));
        }
        let role = self.role();
        match role {
            Role::Unused => (String::new(), None),
            Role::Log => (String::new(), parse::gather(self.text(), 0, &mut Gathering::default()).err()),
            _ if !self.asks().is_empty() => (String::new(), self.no_number()),
            _ => {
                let mut reading = LogReader::default();
                let fault = self.rows(0, |row| reading.take(role, row)).err();
                (evidence::follows(&reading), fault)
            }
        }
    }

    /// The first row with too few or too many fields, or with something else where a number is read.
    fn no_number(&self) -> Option<Error> {
        let source = &self.source;
        let table = source.table.as_ref()?;
        // It may be left out as a whole.
        if self.answers().contains(&Role::Unused) {
            return None;
        }
        let numbers: Vec<(&Value, usize)> = source
            .role
            .values()
            .iter()
            .enumerate()
            .filter_map(|(i, value)| Some((value, source.columns[i].filter(|_| is_number(source, i, value))?)))
            .collect();
        table.lines(self.text()).find_map(|line| {
            let line = match line {
                Ok(line) => line,
                Err(fault) => return Some(fault),
            };
            if !source.is_read(&line) || source.says_nothing(&line) {
                return None;
            }
            parse::check_text(&line).err().or_else(|| {
                numbers.iter().find_map(|(value, at)| {
                    let field = line.fields[*at];
                    if is_none(field.text) && value.optional {
                        return None;
                    }
                    let text = if is_none(field.text) { "" } else { field.text };
                    row::finite(&line, Field { text, ..field }, value.name).err()
                })
            })
        })
    }

    /// Whether it says how the robot moved, or may do so once it is said what it is.
    pub(crate) fn may_move(&self) -> bool {
        let source = &self.source;
        let has = |value: &str, quantity| !candidates(value, quantity, &source.names).is_empty();
        match source.role {
            Role::Sensors => ["v", "omega"].iter().any(|value| {
                source.role.index(value).is_some_and(|at| source.columns[at].is_some() || !source.doubts[at].is_empty())
            }),
            Role::Undecided if self.answers().is_empty() => true,
            Role::Undecided => {
                let rates = has("v", Quantity::Speed) || has("omega", Quantity::AngleRate);
                self.answers().contains(&Role::Reckoned) || (self.answers().contains(&Role::Sensors) && rates)
            }
            role => role.moves(),
        }
    }
}

/// Whether a value of a row has to be one number: no name, no date, no list of ranges, and no infinity among these.
fn is_number(source: &Source, at: usize, value: &Value) -> bool {
    let other = match value.quantity {
        Quantity::Number | Quantity::Day => true,
        Quantity::Time => source.is_date(),
        Quantity::Heading => source.units[at].is_some_and(|unit| unit.name == QUATERNION),
        _ => matches!(value.name, "range" | "bearing" | "first range"),
    };
    !other
}
