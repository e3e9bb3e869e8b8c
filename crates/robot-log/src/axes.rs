//! The axes of a gyroscope.

use crate::names::Name;

/// The columns of a gyroscope that says its axes and not which of them points up.
pub(crate) fn axes(file: &str, names: &[Name]) -> Option<Vec<usize>> {
    let gyro = |name: &Name| name.has_one(&["gyro", "gyroscope", "gyr", "gyroskop"]) || file.contains("gyro");
    let on = |axis: &str| {
        let with = |name: &Name| name.has(axis) || (axis == "z" && name.has("wz"));
        names.iter().position(|name| gyro(name) && with(name))
    };
    Some(vec![on("x")?, on("y")?, on("z")?])
}

/// The column of the third axis of a gyroscope in an array: `xyz[2]`.
pub(crate) fn third_axis(names: &[Name]) -> Option<usize> {
    names.iter().position(|name| name.has("2") && name.has_one(&["xyz", "gyro"]))
}
