//! The unit of a heading: from which direction it is counted, and in what.

use crate::names::Name;
use crate::unit::{HUNDREDTHS_FROM_NORTH, Unit};

/// Words for a heading from north, clockwise.
const COURSE: [&str; 13] = [
    "course",
    "cog",
    "compass",
    "crs",
    "kurs",
    "cap",
    "rumbo",
    "rotta",
    "azimuth",
    "bearing",
    "north",
    "direction",
    "richtung",
];

/// Words for a heading that some count from north and others from the axis of x; a θ is always counted from there.
const ASKED: [&str; 13] = [
    "heading",
    "hdg",
    "yaw",
    "gierwinkel",
    "ausrichtung",
    "orientation",
    "lacet",
    "guinada",
    "orientacion",
    "imbardata",
    "orientamento",
    "prua",
    "psi",
];

/// Whether a heading is the direction in which a receiver moves: where the robot points only as long as that stands
/// above the point about which it turns.
pub(crate) fn is_course(name: &Name) -> bool {
    name.has_one(&["course", "cog", "crs", "track", "kurs", "cap", "rumbo", "rotta", "bearing"])
}

/// A full turn, in degrees, and what rounding may add.
const FULL_TURN: f64 = 360.5;

/// The unit of a column of headings, whose name may say one and whose largest number is `most` in the first rows and
/// `furthest` in all; `None` where it has to be asked. `down`: the axes point forward, right and down; `global`:
/// latitudes stand beside it; `captured`: it is of a motion capture, whose angles are counted as its own axes say;
/// `below`: some are below 0.
pub(crate) fn unit(
    name: &Name,
    said: Option<&Unit>,
    [most, furthest]: [f64; 2],
    [down, global, captured, below]: [bool; 4],
) -> Option<&'static str> {
    if let Some(unit) = said.filter(|unit| unit.name == HUNDREDTHS_FROM_NORTH) {
        return Some(unit.name);
    }
    // MAVLink has hundredths of a degree below this name, and others have degrees.
    if said.is_none() && name.has("hdg") {
        return None;
    }
    let course = global || name.has_one(&COURSE);
    let from_north = down || course;
    let degrees = said.map_or(most > 7.0 || course, |unit| unit.name == "deg");
    // A course without a unit that stays below a full turn in radians may be in either; ArduPilot's is in degrees.
    if course && said.is_none() && !name.has("crs") && most > 0.0 && most < 6.3 {
        return None;
    }
    // No heading is more than a full turn: they are hundredths of a degree, or turns are counted on.
    if degrees && furthest > FULL_TURN {
        return None;
    }
    // A course goes from 0 to 360: what goes to 180 on both sides is a program's own, and is counted from either.
    if degrees && course && below && !down {
        return None;
    }
    // Degrees of a heading or a yaw are a compass's as often as they are counted from the axis of x. In radians they
    // are a program's own, and robots' programs count from there.
    if degrees && !from_north && !captured && name.has_one(&ASKED) {
        return None;
    }
    // Beside latitudes they are counted from either: east is x there, and a compass counts from north.
    if !degrees && global && !down && !name.has_one(&COURSE) {
        return None;
    }
    Some(match (degrees, from_north) {
        (false, false) => "rad",
        (true, false) => "deg",
        (false, true) => "rad from north",
        (true, true) => "deg from north",
    })
}
