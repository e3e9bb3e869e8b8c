//! Stretches of a log in which no motion is read: what was read last is held meanwhile, and no filter knows better.

use crate::drive::row::{Event, Motion, Row};
use alloc::vec::Vec;

/// A gap is so much longer than the usual step, and longer than this, s.
const STEPS: f64 = 10.0;
const LEAST: f64 = 1.0;

/// What is not read in a gap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// Any motion that is held: speed and turn rate.
    Held,
    /// The speed alone.
    Speed,
    /// The turn rate alone.
    TurnRate,
    /// Distances and turns: the row after it has them all in one step.
    Odometry,
}

impl Missing {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Held => "held",
            Self::Speed => "speed",
            Self::TurnRate => "turn rate",
            Self::Odometry => "odometry",
        }
    }
}

/// How many gaps there are, and the longest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaps {
    /// What is missing.
    pub what: Missing,
    /// How many.
    pub count: u32,
    /// From when to when the longest is, s since the first row.
    pub longest: [f64; 2],
}

/// The gaps between rows of motion, by what they lack: more than ten median steps, and more than a second.
///
/// # Example
/// ```
/// use estimate::drive::{Event, Missing, Motion, Row, gaps};
/// let drives = Event::Velocity { v: 1.0, omega: 0.0 };
/// let times = (0..50).filter(|k| !(20..40).contains(k)).map(|k| f64::from(k) / 10.0);
/// let rows: Vec<Row> = times.map(|time| Row::new(time, drives)).collect();
/// let found = gaps(&rows, Motion::Velocity);
/// assert_eq!((found.len(), found[0].what, found[0].count, found[0].longest), (1, Missing::Held, 1, [1.9, 4.0]));
/// ```
pub fn gaps(rows: &[Row], motion: Motion) -> Vec<Gaps> {
    if motion.is_odometry() {
        return of(rows, Missing::Odometry, Event::is_motion).into_iter().collect();
    }
    let speed = of(rows, Missing::Speed, Event::has_speed);
    let turn = of(rows, Missing::TurnRate, Event::has_turn_rate);
    match (speed, turn) {
        (Some(speed), Some(turn)) if speed == (Gaps { what: Missing::Speed, ..turn }) => {
            alloc::vec![Gaps { what: Missing::Held, ..speed }]
        }
        (speed, turn) => speed.into_iter().chain(turn).collect(),
    }
}

/// What a log whose motion is held never reads: its speed or its turn rate.
///
/// # Example
/// ```
/// use estimate::drive::{Event, Missing, Motion, Row, lacks};
/// let rows = [Row::new(0.0, Event::Speed { v: 1.0 }), Row::new(0.1, Event::Speed { v: 1.0 })];
/// assert_eq!(lacks(&rows, Motion::Velocity), Some(Missing::TurnRate));
/// ```
pub fn lacks(rows: &[Row], motion: Motion) -> Option<Missing> {
    let has = |is: fn(&Event) -> bool| rows.iter().any(|row| is(&row.event));
    match motion {
        Motion::Odometry | Motion::EvenOdometry => None,
        Motion::Velocity if !has(Event::has_turn_rate) => Some(Missing::TurnRate),
        Motion::Velocity if !has(Event::has_speed) => Some(Missing::Speed),
        Motion::Velocity => None,
    }
}

fn of(rows: &[Row], what: Missing, is: impl Fn(&Event) -> bool) -> Option<Gaps> {
    gaps_of(rows, LEAST, is).map(|(count, longest)| Gaps { what, count, longest })
}

/// How many gaps there are between the rows of one kind, each of more than ten median steps and more than `least`
/// seconds, and from when to when the longest is, s since the first row of all; `None` where there is none.
///
/// # Example
/// ```
/// use estimate::drive::{Event, Row, gaps_of};
/// let fix = Event::Position { x: 0.0, y: 0.0, sigma: None };
/// let rows: Vec<Row> = [0.0, 0.5, 1.0, 1.5, 9.5, 10.0].map(|time| Row::new(time, fix)).to_vec();
/// assert_eq!(gaps_of(&rows, 5.0, |event| matches!(event, Event::Position { .. })), Some((1, [1.5, 9.5])));
/// ```
pub fn gaps_of(rows: &[Row], least: f64, is: impl Fn(&Event) -> bool) -> Option<(u32, [f64; 2])> {
    let first = rows.first().map_or(0.0, |row| row.time);
    let times: Vec<f64> = rows.iter().filter(|row| is(&row.event)).map(|row| row.time - first).collect();
    let pairs = || times.windows(2).map(|pair| [pair[0], pair[1]]);
    let length = |[from, to]: [f64; 2]| to - from;
    let enough = least.max(STEPS * median(pairs().map(length)));
    let long: Vec<[f64; 2]> = pairs().filter(|pair| length(*pair) > enough).collect();
    let longest = long.iter().copied().max_by(|a, b| length(*a).total_cmp(&length(*b)))?;
    Some((long.len() as u32, longest))
}

/// The median of the steps above 0, or 0.
pub(crate) fn median(steps: impl Iterator<Item = f64>) -> f64 {
    let mut steps: Vec<f64> = steps.filter(|step| *step > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slow_sensor_and_a_short_stop_have_no_gap_and_each_sensor_has_its_own() {
        let row = |time: f64, event: Event| Row::new(time, event);
        let (speed, turn) = (Event::Speed { v: 1.0 }, Event::TurnRate { omega: 0.1 });
        let slow: Vec<Row> = (0..10).map(|k| row(5.0 * f64::from(k), speed)).collect();
        assert_eq!(gaps(&slow, Motion::Velocity), []);
        let times = (0..200).filter(|k| !(50..70).contains(k) && !(100..150).contains(k)).map(|k| 0.1 * f64::from(k));
        let mut rows: Vec<Row> = (0..200).map(|k| row(0.1 * f64::from(k), turn)).collect();
        rows.extend(times.map(|time| row(time, speed)));
        rows.sort_by(|a, b| a.time.total_cmp(&b.time));
        let found = gaps(&rows, Motion::Velocity);
        assert_eq!((found.len(), found[0].what, found[0].count), (1, Missing::Speed, 2));
        assert!((found[0].longest[0] - 9.9).abs() < 1e-9 && (found[0].longest[1] - 15.0).abs() < 1e-9);
        let step = Event::Odometry { distance: 0.1, turn: 0.0 };
        let rows = [0.0, 0.1, 0.2, 0.3, 1.2, 1.3, 9.0].map(|time| row(time, step));
        let lost = gaps(&rows, Motion::Odometry);
        assert_eq!(lost, [Gaps { what: Missing::Odometry, count: 1, longest: [1.3, 9.0] }]);
    }
}
