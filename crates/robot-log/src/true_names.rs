//! Columns that are called a true pose, and those that a sensor may have read: not what a filter made of them.

use crate::names::{Name, candidates};
use crate::quaternion;
use crate::role::{Quantity, Role};

/// Words of what a robot has reckoned of its way, of what a filter has made of a pose, and of what a planner has: no
/// sensor has read it.
const RECKONED: [&str; 7] = ["odom", "odometry", "reckoned", "reckoning", "dead", "dr", "wheel"];
const FILTERED: [&str; 18] = [
    "est",
    "estimate",
    "estimated",
    "ekf",
    "ukf",
    "kf",
    "filter",
    "filtered",
    "fused",
    "slam",
    "amcl",
    "smoothed",
    "corrected",
    "optimized",
    "hat",
    "prior",
    "posterior",
    "pred",
];
const PLANNED: [&str; 12] = [
    "predicted",
    "ref",
    "reference",
    "desired",
    "des",
    "cmd",
    "command",
    "target",
    "setpoint",
    "goal",
    "planned",
    "plan",
];

/// Whether a column is called what no sensor has read.
fn is_made(name: &Name) -> bool {
    [&RECKONED[..], &FILTERED, &PLANNED].into_iter().any(|words| name.has_one_itself(words))
}

/// Whether a column is called odometry's.
pub(crate) fn is_reckoned(name: &Name) -> bool {
    name.has_one(&RECKONED) && !name.has_one(&FILTERED) && !is_true(name)
}

/// The columns that are called odometry's, without the words that say so; the others have no name. `None` where they
/// are no x, y and heading.
pub(crate) fn reckoned(names: &[Name]) -> Option<Vec<Name>> {
    let own = |name: &Name| if is_reckoned(name) { name.without(&RECKONED) } else { Name::new("") };
    let own: Vec<Name> = names.iter().map(own).collect();
    let has = |value, quantity| !candidates(value, quantity, &own).is_empty();
    let heading = has("heading", Quantity::Heading) || quaternion::first(&own).is_some();
    (has("x", Quantity::Length) && has("y", Quantity::Length) && heading).then_some(own)
}

/// Whether a column is called true. True north, and the course from there, are none.
pub(crate) fn is_true(name: &Name) -> bool {
    let of_north = name.has("true") && name.has_one(&["heading", "hdg", "north", "course", "track", "bearing"]);
    name.has_one(&["true", "truth", "gt", "groundtruth", "vicon", "mocap"]) && !of_north
}

/// The columns that are not called odometry's, and the first one of the time; the others have no name.
pub(crate) fn beside_reckoned(names: &[Name]) -> Vec<Name> {
    let time = candidates("time", Quantity::Time, names).first().copied();
    let is_one = |at: usize| time == Some(at) || !is_reckoned(&names[at]);
    (0..names.len()).map(|at| if is_one(at) { names[at].clone() } else { Name::new("") }).collect()
}

/// The columns that are called true, or those that a sensor may have read; what is none of these has no name.
fn parted(names: &[Name], truth: bool) -> Vec<Name> {
    let is_one = |name: &Name| is_true(name) == truth && (truth || !is_made(name));
    names.iter().map(|name| if is_one(name) { name.clone() } else { Name::new("") }).collect()
}

/// Whether the columns that are called true, or the others, have an x and a y.
pub(crate) fn has_place(names: &[Name], truth: bool) -> bool {
    has(names, truth, ["x", "y"], Quantity::Length)
}

/// Whether there are columns that are called a true place.
pub(crate) fn has_truth(names: &[Name]) -> bool {
    has_place(names, true) || has_coordinates(names, true)
}

/// Whether these have a latitude and a longitude.
pub(crate) fn has_coordinates(names: &[Name], truth: bool) -> bool {
    has(names, truth, ["latitude", "longitude"], Quantity::Coordinate)
}

fn has(names: &[Name], truth: bool, values: [&str; 2], quantity: Quantity) -> bool {
    let names = parted(names, truth);
    values.iter().all(|value| !candidates(value, quantity, &names).is_empty())
}

/// Whether an x that is not called true is a receiver's.
pub(crate) fn is_received(names: &[Name]) -> bool {
    let x = candidates("x", Quantity::Length, &parted(names, false));
    x.iter().any(|at| names[*at].has_one(&["gps", "gnss", "rtk", "fix", "nav", "laser", "lidar"]))
}

/// The columns among which a role looks for a value: a truth for its pose among those that are called true, a sensor
/// among the others.
pub(crate) fn sought(role: Role, value: &str, names: &[Name]) -> Vec<Name> {
    let of_pose = matches!(value, "x" | "y" | "heading" | "latitude" | "longitude");
    match role {
        Role::Reckoned if of_pose => reckoned(names).unwrap_or_else(|| names.to_vec()),
        // Places of a filter are a sensor's where the reader says so; whose heading it is is not said by that.
        Role::Sensors if of_pose => {
            let some = value == "heading" || has_place(names, false) || has_coordinates(names, false);
            let untrue = || names.iter().map(|name| if is_true(name) { Name::new("") } else { name.clone() });
            if some { parted(names, false) } else { untrue().collect() }
        }
        // A heading without a name of its own may be the true one where nothing else is there that has a pose.
        Role::Truth if of_pose && has_truth(names) => {
            let alone = value == "heading" && !has_place(names, false) && !has_coordinates(names, false);
            if alone { names.to_vec() } else { parted(names, true) }
        }
        _ => names.to_vec(),
    }
}
