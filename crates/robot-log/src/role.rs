//! What a file of a log can hold, and in which units.

use Quantity::{Angle, AngleRate, Length, Number, Speed, Time};

/// What a column measures, which decides its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A time.
    Time,
    /// A length.
    Length,
    /// An angle.
    Angle,
    /// A length in a second.
    Speed,
    /// An angle in a second.
    AngleRate,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A log in the book's own format, with a letter at the beginning of each row.
    Log,
    /// Velocities, each held until the next.
    Velocities,
    /// Distance and turn since the row before.
    Odometry,
    /// Sightings of landmarks.
    Sightings,
    /// The places of the landmarks.
    Landmarks,
    /// True positions.
    Truth,
    /// Which landmark carries which barcode, where sightings name barcodes.
    Barcodes,
    /// Left out.
    Unused,
}

impl Role {
    /// All roles and their names.
    pub const ALL: [(Role, &'static str); 8] = [
        (Role::Log, "log"),
        (Role::Velocities, "velocities"),
        (Role::Odometry, "odometry"),
        (Role::Sightings, "sightings"),
        (Role::Landmarks, "landmarks"),
        (Role::Truth, "truth"),
        (Role::Barcodes, "barcodes"),
        (Role::Unused, "unused"),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(role, _)| *role == self).map_or("unused", |(_, name)| name)
    }

    /// The values of a row, of which the optional ones stand last.
    pub fn values(self) -> &'static [Value] {
        const VELOCITIES: [Value; 3] = [value("time", Time), value("v", Speed), value("omega", AngleRate)];
        const ODOMETRY: [Value; 3] = [value("time", Time), value("distance", Length), value("turn", Angle)];
        const SIGHTINGS: [Value; 4] =
            [value("time", Time), value("landmark", Number), value("range", Length), optional("bearing", Angle)];
        const LANDMARKS: [Value; 3] = [value("landmark", Number), value("x", Length), value("y", Length)];
        const TRUTH: [Value; 4] =
            [value("time", Time), value("x", Length), value("y", Length), optional("heading", Angle)];
        const BARCODES: [Value; 2] = [value("landmark", Number), value("barcode", Number)];
        match self {
            Self::Velocities => &VELOCITIES,
            Self::Odometry => &ODOMETRY,
            Self::Sightings => &SIGHTINGS,
            Self::Landmarks => &LANDMARKS,
            Self::Truth => &TRUTH,
            Self::Barcodes => &BARCODES,
            Self::Log | Self::Unused => &[],
        }
    }
}

/// The units of a file; those of v and ω are the length and the angle in a second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// `s`, `ms`, `us` or `ns`.
    pub time: &'static str,
    /// `m`, `cm` or `mm`.
    pub length: &'static str,
    /// `rad` or `deg`.
    pub angle: &'static str,
}

impl Default for Units {
    fn default() -> Self {
        Self { time: "s", length: "m", angle: "rad" }
    }
}

/// The units of time, and how many of each make a second.
pub const TIMES: [(&str, f64); 4] = [("s", 1.0), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)];
/// The units of length, and how many of each make a metre.
pub const LENGTHS: [(&str, f64); 3] = [("m", 1.0), ("cm", 100.0), ("mm", 1000.0)];
/// The units of angles.
pub const ANGLES: [&str; 2] = ["rad", "deg"];

impl Units {
    /// `number` in seconds, metres and radians.
    pub fn convert(&self, quantity: Quantity, number: f64) -> f64 {
        let per =
            |units: &[(&str, f64)], unit: &str| units.iter().find(|(name, _)| *name == unit).map_or(1.0, |it| it.1);
        match quantity {
            Time => number / per(&TIMES, self.time),
            Length | Speed => number / per(&LENGTHS, self.length),
            Angle | AngleRate if self.angle == "deg" => number.to_radians(),
            Angle | AngleRate | Number => number,
        }
    }
}
