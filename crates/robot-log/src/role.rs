//! What a file of a log can hold, and in which units.

use Quantity::{
    Angle, AngleRate, AngleSpread, Coordinate, Day, Fraction, Heading, Length, Number, SigmaWords, Speed, Time, Wheel,
};

/// What a column measures, which decides its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A time.
    Time,
    /// The part of a stamp that is added to its seconds.
    Fraction,
    /// The day of a stamp whose time of day is in another column.
    Day,
    /// A length.
    Length,
    /// How far a length may be off.
    SigmaWords,
    /// An angle.
    Angle,
    /// How far an angle may be off.
    AngleSpread,
    /// An angle with a direction that is 0: the axis of x, or north.
    Heading,
    /// A length in a second.
    Speed,
    /// An angle in a second.
    AngleRate,
    /// A latitude or a longitude.
    Coordinate,
    /// What an encoder has counted.
    Wheel,
    /// The number of a landmark.
    Number,
}

/// A value that a role needs in every row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Value {
    /// What it is called.
    pub name: &'static str,
    /// What it measures.
    pub quantity: Quantity,
    /// Whether a file may have no column of it.
    pub optional: bool,
}

const fn value(name: &'static str, quantity: Quantity) -> Value {
    Value { name, quantity, optional: false }
}

const fn optional(name: &'static str, quantity: Quantity) -> Value {
    Value { name, quantity, optional: true }
}

/// What a file of a log is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// A log in the book's own format, with a letter at the beginning of each row.
    Log,
    /// Velocities: a speed and a turn rate.
    Velocities,
    /// Distance and turn since the row before.
    Odometry,
    /// What the encoders of two wheels have counted.
    Encoders,
    /// Poses that the robot has reckoned of its way, from where it was switched on.
    Reckoned,
    /// Readings of one sensor or several: a speed, a turn rate, a position, a heading. A row may lack some.
    Sensors,
    /// Sightings of landmarks.
    Sightings,
    /// Ranges to several landmarks in one row, a column for each.
    Ranges,
    /// The places of the landmarks.
    Landmarks,
    /// True positions.
    Truth,
    /// Which landmark carries which barcode, where sightings name barcodes.
    Barcodes,
    /// Not known: it has to be said.
    Undecided,
    /// Left out.
    #[default]
    Unused,
}

/// The second column of a stamp.
const FRACTION: Value = optional("fraction", Fraction);
/// The day of a time of day.
const DAY: Value = optional("day", Day);
const TIME: Value = value("time", Time);

impl Role {
    /// All roles and their names.
    pub const ALL: [(Role, &'static str); 13] = [
        (Role::Log, "log"),
        (Role::Velocities, "velocities"),
        (Role::Odometry, "odometry"),
        (Role::Encoders, "encoders"),
        (Role::Reckoned, "reckoned"),
        (Role::Sensors, "sensors"),
        (Role::Sightings, "sightings"),
        (Role::Ranges, "ranges"),
        (Role::Landmarks, "landmarks"),
        (Role::Truth, "truth"),
        (Role::Barcodes, "barcodes"),
        (Role::Undecided, "undecided"),
        (Role::Unused, "unused"),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(role, _)| *role == self).map_or("unused", |(_, name)| name)
    }

    /// The values of a row, of which the optional ones stand last.
    pub fn values(self) -> &'static [Value] {
        const VELOCITIES: [Value; 5] = [TIME, value("v", Speed), value("omega", AngleRate), FRACTION, DAY];
        const ODOMETRY: [Value; 5] = [TIME, value("distance", Length), value("turn", Angle), FRACTION, DAY];
        const ENCODERS: [Value; 5] = [TIME, value("left", Wheel), value("right", Wheel), FRACTION, DAY];
        const RECKONED: [Value; 6] =
            [TIME, value("x", Length), value("y", Length), value("heading", Heading), FRACTION, DAY];
        const SENSORS: [Value; 12] = [
            TIME,
            optional("v", Speed),
            optional("omega", AngleRate),
            optional("x", Length),
            optional("y", Length),
            optional("latitude", Coordinate),
            optional("longitude", Coordinate),
            optional("sigma", SigmaWords),
            optional("heading", Heading),
            optional("sigma of heading", AngleSpread),
            FRACTION,
            DAY,
        ];
        const SIGHTINGS: [Value; 8] = [
            TIME,
            value("landmark", Number),
            value("range", Length),
            optional("bearing", Angle),
            optional("landmark x", Length),
            optional("landmark y", Length),
            FRACTION,
            DAY,
        ];
        const RANGES: [Value; 4] = [TIME, value("first range", Length), FRACTION, DAY];
        const LANDMARKS: [Value; 3] = [value("landmark", Number), value("x", Length), value("y", Length)];
        const TRUTH: [Value; 8] = [
            TIME,
            optional("x", Length),
            optional("y", Length),
            optional("heading", Heading),
            optional("latitude", Coordinate),
            optional("longitude", Coordinate),
            FRACTION,
            DAY,
        ];
        const BARCODES: [Value; 2] = [value("landmark", Number), value("barcode", Number)];
        match self {
            Self::Velocities => &VELOCITIES,
            Self::Odometry => &ODOMETRY,
            Self::Encoders => &ENCODERS,
            Self::Reckoned => &RECKONED,
            Self::Sensors => &SENSORS,
            Self::Sightings => &SIGHTINGS,
            Self::Ranges => &RANGES,
            Self::Landmarks => &LANDMARKS,
            Self::Truth => &TRUTH,
            Self::Barcodes => &BARCODES,
            Self::Log | Self::Undecided | Self::Unused => &[],
        }
    }

    /// The index of a value.
    pub(crate) fn index(self, name: &str) -> Option<usize> {
        self.values().iter().position(|value| value.name == name)
    }

    /// Whether its rows say how the robot moved, or may say so.
    pub(crate) fn moves(self) -> bool {
        matches!(self, Self::Log | Self::Velocities | Self::Odometry | Self::Encoders | Self::Reckoned | Self::Sensors)
    }
}
