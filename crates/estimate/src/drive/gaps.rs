//! Stretches of a log in which no motion is read: what was read last is held meanwhile, and no filter knows better.

use crate::drive::row::{Event, Motion, Row};
use alloc::vec::Vec;

/// A gap is so many times as long as the usual step.
const STEPS: f64 = 10.0;
/// No gap is shorter than this, s.
pub const SHORTEST_GAP: f64 = 1.0;

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

/// Held motion with at least so many gaps, which are at least so much of the log, is written where it changes: it has
/// none.
const CHANGES: usize = 8;
const MOST: f64 = 0.5;

/// An end without motion is a gap where it is so much of the log: loggers are switched off one after the other.
const END: f64 = 0.02;

/// How many gaps there are, and the longest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaps {
    /// What is missing.
    pub what: Missing,
    /// How many.
    pub count: u32,
    /// From when to when the longest is, s since the first row.
    pub longest: [f64; 2],
    /// From when to when the longest stretch between them is, s since the first row.
    pub between: [f64; 2],
}

impl Gaps {
    /// Those of one kind, in their order, in a log of so many seconds.
    fn of(what: Missing, all: &[[f64; 2]], duration: f64) -> Option<Self> {
        let length = |[from, to]: &[f64; 2]| to - from;
        let longest = *all.iter().max_by(|a, b| length(a).total_cmp(&length(b)))?;
        let begins = core::iter::once(0.0).chain(all.iter().map(|gap| gap[1]));
        let ends = all.iter().map(|gap| gap[0]).chain([duration]);
        let between = begins.zip(ends).map(|(from, to)| [from, to]);
        let between = between.max_by(|a, b| length(a).total_cmp(&length(b)))?;
        Some(Self { what, count: all.len() as u32, longest, between })
    }
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
    by_kind(rows, motion, |is| long(rows, SHORTEST_GAP, is))
}

/// As [`gaps`], and the stretch from the last row of motion to the last of all, where it is long as well.
///
/// # Example
/// ```
/// use estimate::drive::{Event, Motion, Row, gaps_and_end};
/// let mut rows: Vec<Row> = (0..50).map(|k| Row::new(f64::from(k), Event::Velocity { v: 1.0, omega: 0.0 })).collect();
/// rows.push(Row::new(99.0, Event::Position { x: 0.0, y: 0.0, sigma: None }));
/// let [end] = gaps_and_end(&rows, Motion::Velocity)[..] else { panic!("one") };
/// assert_eq!((end.longest, end.between), ([49.0, 99.0], [0.0, 49.0]));
/// ```
pub fn gaps_and_end(rows: &[Row], motion: Motion) -> Vec<Gaps> {
    let least = SHORTEST_GAP.max(END * duration(rows));
    by_kind(rows, motion, |is| long(rows, SHORTEST_GAP, is).into_iter().chain(end_without(rows, least, is)).collect())
}

fn by_kind(rows: &[Row], motion: Motion, long: impl Fn(fn(&Event) -> bool) -> Vec<[f64; 2]>) -> Vec<Gaps> {
    let of = |what, is| Gaps::of(what, &long(is), duration(rows));
    if motion.is_odometry() {
        return of(Missing::Odometry, Event::is_motion).into_iter().collect();
    }
    let written_at_changes = |is| {
        let all = long(is);
        let missed: f64 = all.iter().map(|[from, to]| to - from).sum();
        motion == Motion::Velocity && all.len() >= CHANGES && missed > MOST * duration(rows)
    };
    let told = |what, is| of(what, is).filter(|_| !written_at_changes(is));
    let speed = told(Missing::Speed, Event::has_speed);
    let turn = told(Missing::TurnRate, Event::has_turn_rate);
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
        _ if motion.is_odometry() => None,
        _ if !has(Event::has_turn_rate) => Some(Missing::TurnRate),
        _ if !has(Event::has_speed) => Some(Missing::Speed),
        _ => None,
    }
}

/// From the first row to the last, s.
fn duration(rows: &[Row]) -> f64 {
    rows.first().zip(rows.last()).map_or(0.0, |(first, last)| last.time - first.time)
}

/// When the rows of one kind are, s since the first row of all, and what is too long to be a step between them.
fn times(rows: &[Row], least: f64, is: impl Fn(&Event) -> bool) -> (Vec<f64>, f64) {
    let first = rows.first().map_or(0.0, |row| row.time);
    let times: Vec<f64> = rows.iter().filter(|row| is(&row.event)).map(|row| row.time - first).collect();
    let steps = times.windows(2).map(|pair| pair[1] - pair[0]);
    let enough = least.max(STEPS * median(steps));
    (times, enough)
}

fn long(rows: &[Row], least: f64, is: impl Fn(&Event) -> bool) -> Vec<[f64; 2]> {
    let (times, enough) = times(rows, least, is);
    times.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[from, to]| to - from > enough).collect()
}

/// From when to when rows of one kind are missing at the end, for more than ten median steps and more than `least`
/// seconds, s since the first row of all.
pub fn end_without(rows: &[Row], least: f64, is: impl Fn(&Event) -> bool) -> Option<[f64; 2]> {
    let (times, enough) = times(rows, least, is);
    let (last, end) = (*times.last()?, duration(rows));
    (end - last > enough).then_some([last, end])
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
    let long = long(rows, least, is);
    let longest = long.iter().copied().max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
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
        let wanted = Gaps { what: Missing::Odometry, count: 1, longest: [1.3, 9.0], between: [0.0, 1.3] };
        assert_eq!(lost, [wanted]);
    }
}
