//! The units of columns: how they are called, how they are written in a column's name, and what one of them is in
//! seconds, metres and radians.

use crate::role::Quantity;

/// A unit of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// As a reader chooses it.
    pub name: &'static str,
    /// What one of it is in seconds, metres, radians or degrees of latitude; below 0 where it counts the other way
    /// round.
    pub factor: f64,
    /// Where its 0 lies: a compass counts from north, which is a quarter turn from the axis of x.
    pub zero: f64,
    /// How names of columns write it, in words parted by blanks.
    written: &'static [&'static str],
}

const fn unit(name: &'static str, factor: f64, written: &'static [&'static str]) -> Unit {
    Unit { name, factor, zero: 0.0, written }
}

const DEGREE: f64 = core::f64::consts::PI / 180.0;
const QUARTER: f64 = core::f64::consts::FRAC_PI_2;

/// Dates are read by their text: `2026-05-01T12:00:00Z`, or `12:00:00.5`.
pub(crate) const DATE: &str = "date";
/// Days: `2026-05-01`, `01.05.2026`, `5/1/2026`.
pub(crate) const YEAR_FIRST: &str = "year, month, day";
pub(crate) const DAY_FIRST: &str = "day, month, year";
pub(crate) const MONTH_FIRST: &str = "month, day, year";

const TIMES: [Unit; 6] = [
    unit("s", 1.0, &["s", "sec", "secs", "second", "seconds", "sekunden", "secondes", "segundos", "secondi"]),
    unit("ms", 1e-3, &["ms", "msec", "millis", "milliseconds", "millisekunden", "boot ms"]),
    unit("us", 1e-6, &["us", "usec", "usecs", "micros", "microseconds", "mikrosekunden"]),
    unit("ns", 1e-9, &["ns", "nsec", "nsecs", "nanos", "nanosec", "nanosecs", "nanoseconds"]),
    unit(DATE, 1.0, &["iso", "utc", "datetime", "iso8601"]),
    // A spreadsheet's number of a date counts them since 1900, one of a program of mathematics since the year 0.
    unit("days", 86_400.0, &["days", "tage", "jours", "dias", "giorni"]),
];
/// How the day of a stamp is written.
const DAYS: [Unit; 3] = [unit(YEAR_FIRST, 1.0, &[]), unit(DAY_FIRST, 1.0, &[]), unit(MONTH_FIRST, 1.0, &[])];
const LENGTHS: [Unit; 5] = [
    unit("m", 1.0, &["m", "meter", "meters", "metre", "metres", "mètres", "metros", "metri"]),
    unit("cm", 1e-2, &["cm", "centimeter", "centimeters"]),
    unit("mm", 1e-3, &["mm", "millimeter", "millimeters"]),
    unit("km", 1e3, &["km"]),
    unit("ft", 0.3048, &["ft", "feet"]),
];
/// A variance: its root is the standard deviation.
pub(crate) const VARIANCE: &str = "m\u{b2}";
pub(crate) const ANGLE_VARIANCE: &str = "rad\u{b2}";

const SPREADS: [Unit; 6] =
    [LENGTHS[0], LENGTHS[1], LENGTHS[2], LENGTHS[3], LENGTHS[4], unit(VARIANCE, 1.0, &["m\u{b2}", "m 2", "m2"])];
const SPEEDS: [Unit; 6] = [
    unit("m/s", 1.0, &["m s", "mps", "m s 1", "ms 1"]),
    unit("cm/s", 1e-2, &["cm s", "cm"]),
    unit("mm/s", 1e-3, &["mm s", "mm"]),
    unit("km/h", 1.0 / 3.6, &["km h", "kmh", "kph", "kmph"]),
    unit("mph", 0.44704, &["mph", "mi h"]),
    unit("kn", 1852.0 / 3600.0, &["kn", "kt", "kts", "knots", "knoten"]),
];
const ANGLES: [Unit; 5] = [
    unit("rad", 1.0, &RAD),
    unit("deg", DEGREE, &DEG),
    unit("0.01 deg", DEGREE / 100.0, &HUNDREDTHS),
    unit("rad clockwise", -1.0, &[]),
    unit("deg clockwise", -DEGREE, &[]),
];
const ANGLE_SPREADS: [Unit; 4] =
    [ANGLES[0], ANGLES[1], ANGLES[2], unit(ANGLE_VARIANCE, 1.0, &["rad\u{b2}", "rad 2", "rad2"])];
/// A heading may be four numbers: x, y, z and w, of which one column is chosen.
pub(crate) const QUATERNION: &str = "quaternion";

/// Hundredths of a degree, in which MAVLink and ArduPilot write headings: always from north.
pub(crate) const HUNDREDTHS_FROM_NORTH: &str = "0.01 deg from north";

const HEADINGS: [Unit; 6] = [
    unit("rad", 1.0, &RAD),
    unit("deg", DEGREE, &DEG),
    Unit { name: "deg from north", factor: -DEGREE, zero: QUARTER, written: &[] },
    Unit { name: "rad from north", factor: -1.0, zero: QUARTER, written: &[] },
    Unit { name: HUNDREDTHS_FROM_NORTH, factor: -DEGREE / 100.0, zero: QUARTER, written: &HUNDREDTHS },
    unit(QUATERNION, 1.0, &[]),
];
const RATES: [Unit; 6] = [
    unit("rad/s", 1.0, &["rad s", "radps", "rads", "rad"]),
    unit(
        "deg/s",
        DEGREE,
        &["deg s", "dps", "degs", "deg", "degrees", "degree", "grad s", "grad", "grados s", "gradi s", "degres s"],
    ),
    unit("rad/s clockwise", -1.0, &[]),
    unit("deg/s clockwise", -DEGREE, &[]),
    unit("deg/min", DEGREE / 60.0, &["deg min", "degrees min", "degmin"]),
    unit("deg/min clockwise", -DEGREE / 60.0, &[]),
];
const COORDINATES: [Unit; 2] = [unit("deg", 1.0, &DEG), unit("1e-7 deg", 1e-7, &[])];
/// What a wheel has done since the row before or in all, or how fast it is; a wheel's own angle needs its radius.
const WHEELS: [Unit; 10] = [
    unit("ticks", 1.0, &["ticks", "tick", "counts", "count", "pulses", "impulse", "tics", "pulsos"]),
    unit("rad", 1.0, &["rad"]),
    unit("deg", DEGREE, &["deg", "degrees"]),
    unit("m", 1.0, &["m"]),
    unit("mm", 1e-3, &["mm"]),
    unit("rad/s", 1.0, &["rad s", "rads"]),
    unit("rpm", core::f64::consts::PI / 30.0, &["rpm", "u min"]),
    unit("m/s", 1.0, &["m s", "mps"]),
    unit("mm/s", 1e-3, &["mm s"]),
    unit("km/h", 1.0 / 3.6, &["km h", "kmh", "kph", "kmph"]),
];
const RAD: [&str; 3] = ["rad", "rads", "radians"];
const DEG: [&str; 8] = ["deg", "degs", "degree", "degrees", "grad", "degres", "grados", "gradi"];
const HUNDREDTHS: [&str; 11] = [
    "cdeg",
    "cdegs",
    "centideg",
    "centidegs",
    "centidegree",
    "centidegrees",
    "centi deg",
    "centi degrees",
    "0 01 deg",
    "1 e 2 deg",
    "deg e 2",
];

/// The units of a quantity, the one that is usual first; none of a number.
pub fn units_of(quantity: Quantity) -> &'static [Unit] {
    match quantity {
        Quantity::Time => &TIMES,
        Quantity::Fraction => TIMES.split_at(4).0,
        Quantity::Day => &DAYS,
        Quantity::Length => &LENGTHS,
        Quantity::Speed => &SPEEDS,
        Quantity::SigmaWords => &SPREADS,
        Quantity::Angle => &ANGLES,
        Quantity::AngleSpread => &ANGLE_SPREADS,
        Quantity::Heading => &HEADINGS,
        Quantity::AngleRate => &RATES,
        Quantity::Coordinate => &COORDINATES,
        Quantity::Wheel => &WHEELS,
        Quantity::Number => &[],
    }
}

/// The unit of a quantity that is called so.
pub(crate) fn named(quantity: Quantity, name: &str) -> Option<&'static Unit> {
    units_of(quantity).iter().find(|unit| unit.name == name)
}

/// The unit that the words of a column's name say, and which of the words say it.
pub(crate) fn written(quantity: Quantity, words: &[String]) -> Option<(&'static Unit, core::ops::Range<usize>)> {
    let mut best: Option<(&'static Unit, core::ops::Range<usize>)> = None;
    for unit in units_of(quantity) {
        for way in unit.written {
            let parts: Vec<&str> = way.split(' ').collect();
            let at = words.windows(parts.len()).rposition(|found| found.iter().eq(parts.iter()));
            let Some(at) = at else { continue };
            // More words say more: `m s` is a speed's unit, where `m` alone would be a length's.
            if best.as_ref().is_none_or(|(_, range)| range.len() < parts.len()) {
                best = Some((unit, at..at + parts.len()));
            }
        }
    }
    best
}

/// `number` of a unit in seconds, metres and radians.
pub(crate) fn convert(unit: &Unit, number: f64) -> f64 {
    if matches!(unit.name, VARIANCE | ANGLE_VARIANCE) {
        return number.max(0.0).sqrt();
    }
    if unit.factor.abs() > 0.1 && unit.factor != DEGREE && unit.factor != -DEGREE {
        return unit.zero + number * unit.factor;
    }
    // A small unit has a whole number of parts in one: dividing by that rounds once.
    match unit.factor {
        factor if factor.abs() == DEGREE / 100.0 => unit.zero + (number / 100.0).to_radians() * factor.signum(),
        factor if factor.abs() == DEGREE / 60.0 => unit.zero + (number / 60.0).to_radians() * factor.signum(),
        factor if factor == DEGREE => number.to_radians(),
        factor if factor == -DEGREE => unit.zero - number.to_radians(),
        factor => unit.zero + number / libm::round(1.0 / factor),
    }
}
