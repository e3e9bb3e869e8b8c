//! Whose turn rates a log takes: those of a gyro, where a file has one. What wheels say of the turn is left out then,
//! since two turn rates would be held in turn; and a log moves by one kind of rows, so their ways become speeds.

use crate::file::File;
use crate::role::Role;

/// The file of a gyro, of turn rates and no speed, where others say how the robot drove and turned.
pub(crate) fn gyro(files: &[File]) -> Option<usize> {
    let alone = |file: &File| file.role() == Role::Sensors && file.turns() && !file.has_speed();
    let mut gyros = files.iter().enumerate().filter(|(_, file)| alone(file));
    let (at, _) = gyros.next().filter(|_| gyros.next().is_none())?;
    files.iter().any(drives).then_some(at)
}

/// Whether all its rows of motion say both how the robot drove and how it turned.
pub(crate) fn drives(file: &File) -> bool {
    matches!(file.role(), Role::Velocities | Role::Odometry | Role::Encoders | Role::Reckoned)
}

/// What is said of the turns that are left out.
pub(crate) fn note(files: &[File]) -> Option<String> {
    let at = gyro(files)?;
    let (gyro, has) = (files[at].name(), |value: &str| files[at].source.column(value).is_some());
    // What else the file says would be left out with it.
    let more = ["x", "latitude", "heading"].into_iter().any(has) || files.iter().any(|it| it.again() == Some(at));
    let leave = if more {
        format!("choose no column (\u{2013}) for the turn rate of {gyro}")
    } else {
        format!("leave {gyro} out")
    };
    let others: Vec<&str> = files.iter().filter(|file| drives(file)).map(File::name).collect();
    Some(format!(
        "The turn rate is that of {gyro} alone; of {} the speed is taken and the turn is not. To turn by the wheels, \
         {leave}.",
        others.join(" and ")
    ))
}
