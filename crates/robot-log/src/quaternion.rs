//! A heading that is written as a quaternion: `orientation.x`, `orientation.y`, `orientation.z`, `orientation.w`.

use crate::names::Name;

/// How far the squared length of a quaternion may be from 1: digits that were cut off.
const NEAR_ONE: f64 = 0.1;
const AXES: [&str; 4] = ["x", "y", "z", "w"];

/// The part of a quaternion that a column may hold, and what its name has before that.
fn part(name: &Name) -> Option<(usize, &[String])> {
    let (last, path) = name.words.split_last()?;
    let axis = last.strip_prefix('q').filter(|axis| !axis.is_empty()).unwrap_or(last);
    Some((AXES.iter().position(|it| *it == axis)?, path))
}

/// The columns of x, y, z and w beside one of them, which are called as it is.
pub(crate) fn columns(names: &[Name], at: usize) -> Option<[usize; 4]> {
    let (_, path) = part(names.get(at)?)?;
    let short = names[at].words.last()?.starts_with('q');
    let is = |axis: usize, name: &Name| {
        part(name) == Some((axis, path)) && name.words.last().is_some_and(|last| last.starts_with('q') == short)
    };
    let mut found = [0; 4];
    for (axis, column) in found.iter_mut().enumerate() {
        *column = names.iter().position(|name| is(axis, name))?;
    }
    Some(found)
}

/// The column of the w of the first quaternion whose name says what it is, or that is `qw`.
pub(crate) fn first(names: &[Name]) -> Option<usize> {
    (0..names.len()).find(|at| {
        let name = &names[*at];
        let said = name.has_one(&["orientation", "quaternion", "quat", "rotation", "q", "qw"]);
        said && part(name).is_some_and(|(axis, _)| axis == 3) && columns(names, *at).is_some()
    })
}

/// The angle from the axis of x, counter-clockwise, of [x, y, z, w]: atan2(2 (wz + xy), w² + x² − y² − z²), rad. `None`
/// of one that is all 0, which says that there is no orientation.
pub(crate) fn heading([x, y, z, w]: [f64; 4]) -> Result<Option<f64>, String> {
    let square = x * x + y * y + z * z + w * w;
    if square == 0.0 {
        return Ok(None);
    }
    if (square - 1.0).abs() > NEAR_ONE {
        return Err(format!("the quaternion has the squared length {square}; 1 was expected"));
    }
    Ok(Some(libm::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::FRAC_PI_2;

    #[test]
    fn a_turn_about_the_vertical_is_the_heading_whatever_the_tilt() {
        let near = |parts, expected: f64| {
            let found = heading(parts).expect("of length 1").expect("turned");
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        };
        let (sin, cos) = libm::sincos(0.3);
        near([0.0, 0.0, sin, cos], 0.6);
        near([0.0, 0.0, -sin, -cos], 0.6);
        let half = 0.5_f64.sqrt();
        near([0.0, 0.0, half, half], FRAC_PI_2);
        // Rolled by 0.4 about its own axis, and then turned by 0.6.
        let (roll, level) = libm::sincos(0.2);
        near([cos * roll, sin * roll, sin * level, cos * level], 0.6);
        assert_eq!(heading([0.0; 4]), Ok(None));
        assert!(heading([1.0, 1.0, 0.0, 0.0]).is_err());
    }

    #[test]
    fn the_four_columns_are_called_alike() {
        let names = |all: &[&str]| all.iter().map(|name| Name::new(name)).collect::<Vec<_>>();
        let pose = names(&[
            "pose.position.x",
            "pose.orientation.x",
            "pose.orientation.y",
            "pose.orientation.z",
            "t",
            "pose.orientation.w",
        ]);
        assert_eq!((first(&pose), columns(&pose, 3), columns(&pose, 0)), (Some(5), Some([1, 2, 3, 5]), None));
        assert_eq!(first(&names(&["x", "y", "z", "w"])), None);
        assert_eq!(columns(&names(&["tx", "ty", "tz", "qx", "qy", "qz", "qw"]), 6), Some([3, 4, 5, 6]));
    }
}
