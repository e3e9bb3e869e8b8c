//! Where the motion of a log ends before its readings do, and no row says what the robot did from there on; or where a
//! sensor's readings end before the log does; or where the positions begin behind the motion, which is replayed from
//! the first of them on.

use crate::sensed::{MISSED, READ};
use estimate::drive::{Drive, Event, Row, SHORTEST_GAP, end_without};

/// What is said of it: what ends, and what is done from there on.
pub(crate) fn ended(drive: &Drive) -> Vec<String> {
    let rows = &drive.rows;
    let (speed, turn) =
        (end_without(rows, SHORTEST_GAP, Event::has_speed), end_without(rows, SHORTEST_GAP, Event::has_turn_rate));
    let found = match drive.motion {
        motion if motion.is_odometry() => [
            end_without(rows, SHORTEST_GAP, Event::is_motion).map(|of| ("motion", of, "the robot is taken to stand")),
            None,
        ],
        _ if speed == turn => [speed.map(|of| ("motion", of, "the last speed and turn rate are held")), None],
        _ => [
            speed.map(|of| ("speed", of, "the last one is held")),
            turn.map(|of| ("turn rate", of, "the last one is held")),
        ],
    };
    let said = |(what, of, then): (&str, [f64; 2], &str)| {
        let [last, end] = of.map(|time| (10.0 * time).round() / 10.0);
        format!(
            "The last row of the {what} is {last} s after the first row, and the log goes on to {end} s: {then} from \
             there on. What is estimated there is a guess; cut the log there to judge it without."
        )
    };
    found.into_iter().flatten().map(said).collect()
}

/// What is said of positions that begin late, where no truth says where the robot was before.
pub(crate) fn begun_late(drive: &Drive) -> Option<String> {
    let is = |event: &Event| matches!(event, Event::Position { .. });
    let (first, fix) = (drive.rows.first()?, drive.rows.iter().find(|row| is(&row.event))?);
    let moves = drive.rows.iter().find(|row| row.event.is_motion())?;
    let late = drive.truth.poses().is_empty() && fix.time - moves.time > MISSED;
    late.then(|| {
        format!(
            "The first position is read {:.1} s after the first row: the estimate begins there, and what was driven \
             before it is not used.",
            fix.time - first.time
        )
    })
}

/// What is said of sensors whose readings end early, though not before the motion begins.
pub(crate) fn ended_readings(rows: &[Row]) -> Vec<String> {
    let (Some(first), Some(moves)) = (rows.first(), rows.iter().find(|row| row.event.is_motion())) else {
        return Vec::new();
    };
    let said = |(what, is): &(&str, fn(&Event) -> bool)| {
        let [last, end] = end_without(rows, MISSED, *is).filter(|[last, _]| first.time + last >= moves.time)?;
        let [last, end] = [last, end].map(|time| (10.0 * time).round() / 10.0);
        Some(format!(
            "The last of the {what} is {last} s after the first row, and the log goes on to {end} s: from there on the \
             motion leads the estimate on, and other readings if there are any."
        ))
    };
    READ.iter().filter_map(said).collect()
}
