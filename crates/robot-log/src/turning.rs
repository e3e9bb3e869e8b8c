//! Whose turn rates a log takes: those of a gyro, where a file has one. What wheels say of the turn is left out then,
//! since two turn rates would be held in turn; and a log moves by one kind of rows, so their ways become speeds.

use crate::evidence::short;
use crate::file::File;
use crate::reading::LogReader;
use crate::role::Role;
use estimate::drive::squared_turn;

/// Over so long turns are compared, s: noise of a row is little beside them.
const WINDOW: f64 = 1.0;
/// What turns so many times as far is read in another unit: a radian has 57 degrees.
const ANOTHER_UNIT: f64 = 20.0;

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

/// How far the robot of a file turns in a second, rad: the root of the mean square. `None` where it cannot be read.
fn in_a_second(file: &File) -> Option<f64> {
    let mut reading = LogReader::default();
    file.rows(0, |cells| reading.take(file.role(), cells)).ok()?;
    Some(libm::sqrt(squared_turn(reading.to.rows(), WINDOW)))
}

/// What is said of a gyro and of wheels that turn so differently that one of them is read in another unit.
pub(crate) fn units(files: &[File]) -> Option<String> {
    let gyro = &files[gyro(files)?];
    let far = in_a_second(gyro)?;
    let others = files.iter().filter(|file| drives(file)).filter_map(|file| Some((file, in_a_second(file)?)));
    let apart = |(_, other): &(&File, f64)| *other > ANOTHER_UNIT * far || far > ANOTHER_UNIT * *other;
    let (wheels, other) = others.filter(|(_, other)| far > 0.0 && *other > 0.0).find(apart)?;
    let degrees = |turned: f64| short(turned.to_degrees());
    Some(format!(
        "{} turns by {}\u{b0} in a second as a rule, and {} by {}\u{b0}: one of them may be in another unit.",
        gyro.name(),
        degrees(far),
        wheels.name(),
        degrees(other)
    ))
}
