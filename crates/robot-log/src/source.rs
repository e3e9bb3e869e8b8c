//! How a file of a log is read.

use crate::fields::{Line, is_none};
use crate::frames::{self, Frame};
use crate::names::Name;
use crate::order::Order;
use crate::other_clock::OtherClock;
use crate::own::Own;
use crate::question::Question;
use crate::role::{Quantity, Role, Value};
use crate::several::{Several, grouped};
use crate::table::Table;
use crate::unit::{self, DATE, QUATERNION, Unit};
use crate::wheels::Wheels;
use crate::wide;

/// How a file is read.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Source {
    pub role: Role,
    pub table: Option<Table>,
    /// The words of each column's name.
    pub names: Vec<Name>,
    /// The column of each of the role's values.
    pub columns: Vec<Option<usize>>,
    /// The unit of each of them; `None` where there is none, or where it has to be said.
    pub units: Vec<Option<&'static Unit>>,
    /// The columns of which each value may be in one.
    pub doubts: Vec<Vec<usize>>,
    /// The order of its rows, where that is not the one in which they stand.
    pub order: Option<Order>,
    /// What follows for the time from each of the columns of which it may be one, in words.
    pub clocks: Vec<String>,
    /// The columns that are called as landmarks of another file, with the landmarks' names.
    pub called: Vec<(String, usize)>,
    /// The file whose speed is taken instead of this one's.
    pub driven_by: Option<String>,
    /// How the unit of its headings is known.
    pub headings: Known,
    /// What encoders need besides.
    pub wheels: Wheels,
    /// The column that tells the rows of several robots apart.
    pub several: Option<Several>,
    /// Whose rows are read: one's, or, as `None`, all of them; not said yet.
    pub only: Option<Option<String>>,
    /// Whether its places are counted from another point than those of the log's fixes, and what is said of that.
    pub foreign: bool,
    /// Whether its places are in metres beside latitudes and longitudes, and no truth's: their origin is asked.
    pub beside: bool,
    /// What brings a truth onto the log's fixes, where it does not lie on them.
    pub own: Option<Own>,
    pub frame: Option<Frame>,
    /// Its clock beside that of the motion.
    pub other_clock: Option<OtherClock>,
    /// What is added to them then, s, as it was said.
    pub clock_shift: Option<f64>,
    /// Whether its role was said, and not guessed.
    pub role_said: bool,
    /// Whether what it is is asked since it is one of several with positions.
    pub among_several: bool,
    /// The question of what the file is, where that is not known.
    pub undecided: Option<Question>,
    /// The file of the same text that was added before: this one is not used, or each row would count twice.
    pub same_as: Option<String>,
    /// Why the file is refused, whatever it is read as.
    pub refused: Option<String>,
}

/// How a unit is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Known {
    /// By its column's name and numbers.
    #[default]
    Guessed,
    /// It was guessed, and other rows of the log speak against that.
    Doubted,
    /// It was said.
    Said,
}

/// Why the unit of headings is asked that was guessed.
const OPPOSITE: &str = " As it was guessed, its headings turn the other way round than the motion says that the robot \
                        does. If they are right, it is the motion whose turns have another sign.";

impl Source {
    /// The column of a value.
    pub fn column(&self, value: &str) -> Option<usize> {
        self.columns[self.role.index(value)?]
    }

    /// Whether a value is read in degrees, from wherever and whichever way these are counted.
    pub fn is_in_degrees(&self, value: &str) -> bool {
        let unit = self.role.index(value).and_then(|at| self.units[at]);
        unit.is_some_and(|unit| unit.name.starts_with("deg"))
    }

    /// Whether a row of motion or of a sighting says nothing: in a table that other sensors share its fields are then
    /// empty.
    pub fn says_nothing(&self, line: &Line<'_>) -> bool {
        let needed = match self.role {
            Role::Velocities => &["v", "omega"][..],
            Role::Odometry => &["distance", "turn"],
            Role::Encoders => &["left", "right"],
            Role::Reckoned => &["x", "y", "heading"],
            Role::Sightings => &["landmark", "range"],
            _ => return false,
        };
        let field = |value: &&str| self.column(value).and_then(|at| line.fields.get(at));
        needed.iter().all(|value| field(value).is_some_and(|field| is_none(field.text)))
    }

    /// Whether the column of a value has to be said, or its unit.
    pub fn is_asked(&self, at: usize) -> bool {
        let Some(value) = self.role.values().get(at) else { return false };
        match self.columns[at] {
            Some(_) => !unit::units_of(value.quantity).is_empty() && self.units[at].is_none(),
            None => !self.doubts[at].is_empty(),
        }
    }

    /// What has to be said before the file can be read, in sentences.
    pub fn asks(&self) -> Vec<String> {
        let mut asks = self.asks_itself();
        if self.said_clock_shift().is_none() {
            asks.extend(self.other_clock.and_then(|clock| clock.question()));
        }
        if self.said_frame().is_none() {
            asks.extend(self.beside.then(|| frames::BESIDE.to_string()));
            asks.extend(self.foreign.then(|| frames::question(self.column("latitude").is_some())));
            asks.extend(self.own.map(|own| own.question()));
        }
        asks
    }

    /// What is asked of the file, whatever the others of the log are.
    pub fn asks_itself(&self) -> Vec<String> {
        let mut asks: Vec<String> = self.undecided.iter().map(|asked| asked.words.clone()).collect();
        let header = self.table.as_ref().map_or(&[][..], |table| &table.names);
        for (i, value) in self.role.values().iter().enumerate() {
            if !self.is_asked(i) {
                continue;
            }
            if let Some(column) = self.columns[i] {
                let day = value.quantity == Quantity::Day;
                let what = if day { "order are the numbers of" } else { "unit is" };
                let doubted = value.quantity == Quantity::Heading && self.headings == Known::Doubted;
                let why = if doubted { OPPOSITE } else { "" };
                asks.push(format!("In which {what} \u{201c}{}\u{201d}?{why}", header[column]));
            } else {
                let among: Vec<String> =
                    self.doubts[i].iter().map(|at| format!("\u{201c}{}\u{201d}", header[*at])).collect();
                let clocks = if value.name == "time" { self.clocks.as_slice() } else { &[] };
                let follows: Vec<String> = among.iter().zip(clocks).map(|(name, it)| format!("{name}: {it}")).collect();
                let follows = if follows.is_empty() { String::new() } else { format!(" {}.", follows.join("; ")) };
                asks.push(format!("Which column is {}: {}?{follows}", said(value), among.join(" or ")));
            }
        }
        if let Some(Several { column, values }) = self.several.as_ref().filter(|_| self.only.is_none()) {
            let each: Vec<String> = values
                .iter()
                .map(|(value, rows)| format!("\u{201c}{value}\u{201d} in {} rows", grouped(*rows)))
                .collect();
            let (column, each) = (&header[*column], each.join(", "));
            asks.push(format!("Whose rows are the log\u{2019}s? \u{201c}{column}\u{201d} is {each}."));
        }
        if let (Role::Ranges, Some(at)) = (self.role, self.column("first range"))
            && self.ranges().is_empty()
        {
            let name = &header[at];
            asks.push(format!(
                "\u{201c}{name}\u{201d} has no number in its name, and no landmark is called so: which column is \
                 the first of the ranges?"
            ));
        }
        if self.role == Role::Encoders {
            let unit = self.role.index("left").and_then(|at| self.units[at]);
            asks.extend(unit.and_then(|unit| self.wheels.lacks(unit.name)));
        }
        asks
    }

    /// The columns of ranges, each with its landmark's name, or, where columns are told apart by it, its number.
    pub fn ranges(&self) -> Vec<(Landmark<'_>, usize)> {
        let Some(first) = self.column("first range") else { return Vec::new() };
        if self.called.iter().any(|(_, at)| *at == first) {
            return self.called.iter().map(|(name, at)| (Landmark::Called(name), *at)).collect();
        }
        let group = wide::group_of(&self.names, first).unwrap_or_default();
        group.into_iter().map(|(number, at)| (Landmark::Number(number), at)).collect()
    }

    /// Which value lacks its column, if one does.
    pub fn lacks(&self) -> Option<&'static str> {
        let has = |name: &str| self.column(name).is_some();
        let values = self.role.values();
        let needed = values.iter().zip(&self.columns).find(|(value, column)| column.is_none() && !value.optional);
        needed.map(|(value, _)| value.name).or_else(|| match self.role {
            Role::Sensors | Role::Truth => {
                let pairs = [("x", "y"), ("y", "x"), ("latitude", "longitude"), ("longitude", "latitude")];
                let half = pairs.into_iter().find(|(one, other)| has(one) && !has(other));
                let any = ["v", "omega", "heading", "x", "latitude"].into_iter().any(has);
                let place = has("x") || has("latitude");
                half.map(|(_, other)| other).or(match self.role {
                    Role::Truth if !place => Some("x"),
                    Role::Sensors if !any => Some("v, omega, x and y, or heading"),
                    _ => None,
                })
            }
            _ => None,
        })
    }

    /// Whether its rows say how the robot moved, as far as their columns are known.
    pub fn moves(&self) -> bool {
        match self.role {
            Role::Sensors => ["v", "omega"].iter().any(|value| self.column(value).is_some()),
            role => role.moves(),
        }
    }

    /// Whether a line is one of those that are read: of several robots it may be another's.
    pub fn is_read(&self, line: &Line<'_>) -> bool {
        let (Some(several), Some(Some(only))) = (&self.several, &self.only) else { return true };
        line.fields.get(several.column).is_some_and(|field| field.text == only)
    }

    /// Whether its true poses are moved onto the fixes.
    pub fn is_moved(&self) -> bool {
        self.said_frame() == Some(Frame::Moved)
    }

    /// Where the places of a truth are counted from, as it was said and still may be.
    pub fn said_frame(&self) -> Option<Frame> {
        self.frame.filter(|frame| self.may_be(*frame))
    }

    /// Whether that may be said of the file.
    pub fn may_be(&self, frame: Frame) -> bool {
        match frame {
            Frame::Same => self.foreign || self.beside || self.own.is_some(),
            Frame::At(_) => self.foreign || self.beside,
            Frame::Moved => self.foreign,
            Frame::Own => self.own.is_some(),
        }
    }

    /// What is added to its times, as it was said and still may be.
    pub fn said_clock_shift(&self) -> Option<f64> {
        self.clock_shift.filter(|_| self.other_clock.is_some())
    }

    /// Whether the unit of its headings is a guess, and may be another one.
    pub fn guesses_heading(&self) -> bool {
        let unit = self.role.index("heading").and_then(|at| self.units[at]);
        self.headings == Known::Guessed && unit.is_some_and(|unit| unit.name != QUATERNION)
    }

    /// Asks for the unit of its headings, which turn the other way round than the robot.
    pub fn doubt_heading(&mut self) {
        if let Some(at) = self.role.index("heading") {
            (self.headings, self.units[at]) = (Known::Doubted, None);
        }
    }

    /// Knows from now on so how a value is read. What was added to times is forgotten with them: others may need
    /// something else.
    pub fn known(&mut self, value: &str, known: Known) {
        match value {
            "heading" => self.headings = known,
            "time" => self.clock_shift = None,
            _ => {}
        }
    }

    /// Whether a column's stamps are dates.
    pub fn is_date(&self) -> bool {
        self.units.first().copied().flatten().is_some_and(|unit| unit.name == DATE)
    }
}

/// Of which landmark a column is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Landmark<'a> {
    Called(&'a str),
    Number(u32),
}

/// A value as a question names it.
fn said(value: &Value) -> &'static str {
    match value.name {
        "v" => "the speed",
        "omega" => "the turn rate",
        "time" => "the time",
        name => name,
    }
}
