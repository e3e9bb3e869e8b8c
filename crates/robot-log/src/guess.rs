//! What a file probably is: a role, its columns and its units, by what its columns are called, by its name, and by its
//! numbers. What is not certain is left open.

use crate::axes::{axes, third_axis};
use crate::binary;
use crate::columns::{clockwise, columns};
use crate::cut::cut;
use crate::fields::Line;
use crate::names::{Name, candidates, is_acceleration, is_spread};
use crate::quaternion;
use crate::question::Question;
use crate::role::{Quantity, Role};
use crate::source::Source;
use crate::table::{LOOKED_AT, Table};
use crate::true_names::{beside_reckoned, has_coordinates, has_truth, is_received, reckoned};
use crate::vocabulary::BESIDE;
use crate::wide;

/// Words in a file's name, and the role that they speak for.
const FILES: [(&str, Role); 23] = [
    ("landmark", Role::Landmarks),
    ("beacons", Role::Landmarks),
    ("buoys", Role::Landmarks),
    ("anchors", Role::Landmarks),
    ("map", Role::Landmarks),
    ("barcode", Role::Barcodes),
    ("truth", Role::Truth),
    ("mocap", Role::Truth),
    ("motion_capture", Role::Truth),
    ("vicon", Role::Truth),
    ("optitrack", Role::Truth),
    ("qualisys", Role::Truth),
    ("gps", Role::Sensors),
    ("gnss", Role::Sensors),
    ("location", Role::Sensors),
    ("navsat", Role::Sensors),
    ("measure", Role::Sightings),
    ("sight", Role::Sightings),
    ("range", Role::Sightings),
    ("observ", Role::Sightings),
    ("odom", Role::Velocities),
    ("veloc", Role::Velocities),
    ("motion", Role::Velocities),
];

/// What is asked of places that may be either.
pub(crate) const IS_TRUE: &str = "Are x and y the true position, or what a sensor read?";

/// What is asked of poses, which the robot may have reckoned besides.
const IS_ITS_OWN: &str = "Are x and y the true position, a sensor\u{2019}s fixes, or what the robot has reckoned of \
                          its way?";
const OR_ITS_OWN: [Role; 3] = [Role::Truth, Role::Sensors, Role::Reckoned];

/// How a file is read unless the reader says otherwise.
pub(crate) fn guess(name: &str, text: &str) -> Source {
    let refused = binary::refusal(name, text);
    let table = Table::new(text).filter(|_| refused.is_none() && !is_log(text));
    let Some(mut table) = table else {
        return Source { role: Role::Log, refused, ..Source::default() };
    };
    let mut names = Name::all(&table.names);
    for head in &table.heads {
        names[*head] = Name::new("");
    }
    let (role, undecided) = role(name, text, &table, &names);
    table.cut = cut(&table, text);
    let mut source = Source { role, undecided, table: Some(table), names, ..Source::default() };
    columns(&mut source, name, text);
    source
}

/// Whether a text is in the book's own format, or is meant to be: a row begins with a letter, or it is no text at all.
fn is_log(text: &str) -> bool {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let rows = || text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')).take(40);
    let letter = |line: &str| {
        let mut letters = line.trim_start_matches(['"', '\'']).chars();
        let first = letters.next().filter(|c| "LGDOVSTRBPH".contains(*c));
        // Rates that change evenly.
        let next = letters.next().filter(|c| *c != 'E' || !first.is_some_and(|c| "VST".contains(c)));
        first.is_some() && next.or_else(|| letters.next()).is_some_and(|c| !c.is_alphanumeric() && c != '_')
    };
    let strange = rows().any(|line| line.contains(['\0', '\u{fffd}']));
    let letters = rows().filter(|line| letter(line)).count();
    strange || (letters > 0 && 2 * letters >= rows().count())
}

/// The role of a file, and why it has to be said where it is not certain.
fn role(file: &str, text: &str, table: &Table, names: &[Name]) -> (Role, Option<Question>) {
    let file = file.to_lowercase();
    let said: Vec<Role> = FILES.iter().filter(|(word, _)| file.contains(word)).map(|(_, role)| *role).collect();
    if table.nameless {
        let rows = table.lines(text).take(1).any(|line| line.is_ok());
        let ask = "Its columns have no names: what is it?";
        return if rows { (Role::Undecided, Some(Question::open(ask))) } else { (Role::Unused, None) };
    }
    let has = |value: &str, quantity| !candidates(value, quantity, names).is_empty();
    let timed = has("time", Quantity::Time);
    let (down, axes) = (clockwise(names, &file), axes(&file, names).is_some());
    let turns = has("omega", Quantity::AngleRate) || axes || (down && third_axis(names).is_some());
    let [v, omega] = [has("v", Quantity::Speed), turns];
    let [x, y] = [has("x", Quantity::Length), has("y", Quantity::Length)];
    let landmark = has("landmark", Quantity::Number);
    let heading = has("heading", Quantity::Heading);
    let read = has_coordinates(names, false) && !said.contains(&Role::Truth);
    let fix = has_coordinates(names, false) || has_coordinates(names, true);
    let place = x && y && !axes;
    if !timed {
        let role = match () {
            () if landmark && place => Role::Landmarks,
            () if landmark && has("barcode", Quantity::Number) => Role::Barcodes,
            () => said.first().copied().filter(|role| *role == Role::Landmarks).unwrap_or(Role::Unused),
        };
        return (if has("barcode", Quantity::Number) && landmark { Role::Barcodes } else { role }, None);
    }
    // What the robot has reckoned is its motion, and the rest of its table something else.
    if !v && !said.contains(&Role::Truth) && reckoned(names).is_some() {
        let rest = beside_reckoned(names);
        return match self::role(&file, text, table, &rest) {
            (Role::Unused, _) => (Role::Reckoned, None),
            (Role::Undecided, _) if !omega && is_received(&rest) => (Role::Sensors, None),
            other => other,
        };
    }
    let is_true = said.contains(&Role::Truth) || has_truth(names);
    let encoders = encoders(names, &file);
    let sightings = landmark && has("range", Quantity::Length);
    let odometry = has("distance", Quantity::Length) && has("turn", Quantity::Angle);
    // Places are the truth or a sensor's.
    let ask =
        |why: &str| (Role::Undecided, Some(Question { words: why.into(), answers: &[Role::Truth, Role::Sensors] }));
    let certain = |role| (role, None);
    match () {
        // A column of some number of the device is no landmark.
        () if read && (v || omega) => certain(Role::Sensors),
        () if sightings && !said.contains(&Role::Velocities) => certain(Role::Sightings),
        () if wide::of_wheels(names, &file).is_some() => certain(Role::Encoders),
        () if wide::group(names).is_some() => certain(Role::Ranges),
        // A gyro beside the wheels: it is a sensor, and they are read once more.
        () if encoders && !place && omega && !v => certain(Role::Sensors),
        () if encoders && (!omega || v) => certain(Role::Encoders),
        () if read => certain(Role::Sensors),
        () if v && omega && !place && has_blanks(text, table, names) => certain(Role::Sensors),
        () if v && omega && !place => certain(Role::Velocities),
        () if v && omega && is_own_pose(names) => certain(Role::Velocities),
        () if odometry && !place => certain(Role::Odometry),
        () if (place || fix) && is_true && !(v && omega && said.contains(&Role::Truth)) => certain(Role::Truth),
        () if place && said.contains(&Role::Sensors) => certain(Role::Sensors),
        () if place && (v || omega) => ask(IS_TRUE),
        () if place && (heading || quaternion::first(names).is_some()) => {
            (Role::Undecided, Some(Question { words: IS_ITS_OWN.into(), answers: &OR_ITS_OWN }))
        }
        () if place => ask("Are x and y the true position, or a sensor\u{2019}s fixes?"),
        () if sightings => certain(Role::Sightings),
        () if (v != omega) && !heading && !down && !axes && has_unknown(names) => {
            (Role::Undecided, Some(Question::open(halfway(v, table, names))))
        }
        () if v || omega || heading => certain(Role::Sensors),
        () => certain(said.first().copied().filter(|role| *role == Role::Ranges).unwrap_or(Role::Unused)),
    }
}

/// In so many rows at least, and in one of so many: not in one here or there.
const LEAST: usize = 3;
const OFTEN: usize = 10;

/// Whether rows have a speed or a turn rate and not the other, as those of a bus with a rate for each.
fn has_blanks(text: &str, table: &Table, names: &[Name]) -> bool {
    let first = |value, quantity| candidates(value, quantity, names).first().copied();
    let [v, omega] = [first("v", Quantity::Speed), first("omega", Quantity::AngleRate)];
    let Some((v, omega)) = v.zip(omega) else { return false };
    let blank = |line: &Line<'_>, at: usize| line.fields[at].text.trim().is_empty();
    let half = |line: &Line<'_>| blank(line, v) != blank(line, omega);
    let rows: Vec<bool> = table.lines(text).filter_map(Result::ok).take(LOOKED_AT).map(|line| half(&line)).collect();
    // A number that is missing once is a fault of its row.
    let halves = rows.iter().filter(|half| **half).count();
    halves >= LEAST && OFTEN * halves > rows.len()
}

/// Whether there are the counts or speeds of two wheels.
fn encoders(names: &[Name], file: &str) -> bool {
    let wheel = [
        "encoder",
        "enc",
        "ticks",
        "tick",
        "wheel",
        "count",
        "counts",
        "rad",
        "impulse",
        "rpm",
        "v",
        "vel",
        "velocity",
        "speed",
        "omega",
        "vitesse",
        "geschwindigkeit",
        "velocidad",
        "velocita",
    ];
    let of_wheels = ["encoder", "wheel", "odom"].iter().any(|word| file.contains(word));
    let side = |value| candidates(value, Quantity::Wheel, names);
    let of_wheel = |at: &usize| of_wheels || names[*at].has_one(&wheel) || names[*at].base(Quantity::Wheel).len() == 1;
    side("left").iter().any(of_wheel) && side("right").iter().any(of_wheel)
}

/// As what a table's columns say how the robot moved.
pub(crate) fn moving(names: &[Name], file: &str) -> Option<Role> {
    let has = |value: &str, quantity| !candidates(value, quantity, names).is_empty();
    match () {
        () if encoders(names, &file.to_lowercase()) => Some(Role::Encoders),
        () if has("v", Quantity::Speed) && has("omega", Quantity::AngleRate) => Some(Role::Velocities),
        () if has("distance", Quantity::Length) && has("turn", Quantity::Angle) => Some(Role::Odometry),
        () if !has("v", Quantity::Speed) && reckoned(names).is_some() => Some(Role::Reckoned),
        () => None,
    }
}

/// What a file with a speed and no turn rate asks, or with a turn rate and no speed.
fn halfway(v: bool, table: &Table, names: &[Name]) -> String {
    let [(known, value, quantity), (missing, ..)] = match v {
        true => [("speed", "v", Quantity::Speed), ("turn rate", "omega", Quantity::AngleRate)],
        false => [("turn rate", "omega", Quantity::AngleRate), ("speed", "v", Quantity::Speed)],
    };
    let columns = candidates(value, quantity, names);
    let columns: Vec<String> = columns.iter().map(|at| format!("\u{201c}{}\u{201d}", table.names[*at])).collect();
    format!(
        "It has a {known}, {}, and no column whose name is known for a {missing}: what is the file? Read as sensors, \
         it has the {known} alone.",
        columns.join(" or ")
    )
}

/// Whether a column is neither a speed, a turn rate or a time, nor one of those that are often beside them.
fn has_unknown(names: &[Name]) -> bool {
    let known = [("v", Quantity::Speed), ("omega", Quantity::AngleRate), ("time", Quantity::Time)];
    let known: Vec<usize> =
        known.into_iter().flat_map(|(value, quantity)| candidates(value, quantity, names)).collect();
    let beside = |name: &Name| name.has_one(&BESIDE) || is_acceleration(name) || is_spread(name);
    let other = |(i, name): (usize, &Name)| !name.words.is_empty() && !known.contains(&i) && !beside(name);
    names.iter().enumerate().any(other)
}

/// Whether the positions beside velocities are a robot's own reckoning, as in a message of odometry.
pub(crate) fn is_own_pose(names: &[Name]) -> bool {
    let both = |one: &str, other: &str| names.iter().any(|name| name.has(one) && name.has(other));
    both("pose", "position") && (both("twist", "linear") || both("twist", "angular"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_and_no_more_begins_a_row_of_the_books_own_format() {
        for (text, own) in [
            ("O,1,2,3\n", true),
            ("# a\n\"O\",1\n", true),
            ("Odom,1\n1,2\n", false),
            ("t,v\n", false),
            ("VE,1,2\n", true),
            ("PE,1\n", false),
            ("TEMP,1\n", false),
        ] {
            assert_eq!(is_log(text), own, "{text}");
        }
    }
}
