//! What was measured at one time, and in which order a replay takes it.

use crate::drive::gaps::median;
use crate::drive::row::{Drive, Event, Row};
use crate::drive::settings::Delays;
use alloc::vec::Vec;
use core::cmp::Ordering;

/// What of a row was measured at one time: all of it, or of a `V` row whose two delays differ its speed or its turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    /// The row's index.
    pub row: usize,
    /// Its stamp, s.
    pub stamp: f64,
    /// When it was measured: the stamp less the delay, s.
    pub time: f64,
    /// What happened; of rates that change evenly, with their means until the next row.
    pub event: Event,
    /// Whether the row counts as taken with this step: a `V` in two halves does with its turn.
    pub counts: bool,
    /// Of odometry that is driven evenly, the row on whose way the robot is: when it ends, s, its distance and turn.
    pub way: Option<[f64; 3]>,
}

/// The steps of a drive by the time of their measurement.
pub(crate) fn order(drive: &Drive, delays: &Delays) -> Vec<u32> {
    let splits = delays.speed != delays.turn;
    let mut codes = Vec::with_capacity(drive.rows.len());
    for (code, row) in (0..).step_by(2).zip(&drive.rows) {
        if splits && matches!(row.event, Event::Velocity { .. }) {
            codes.push(code + 1);
        }
        codes.push(code);
    }
    codes.sort_by(|a, b| compare(drive, delays, [*a, *b]));
    codes
}

/// Which of two codes is measured first. Not in line, since a sort has dozens of comparisons.
#[inline(never)]
fn compare(drive: &Drive, delays: &Delays, codes: [u32; 2]) -> Ordering {
    let key = |code: u32| {
        let row = &drive.rows[(code >> 1) as usize];
        let time = step(drive, code, delays).map_or(row.time, |step| step.time);
        (time, !row.event.is_motion(), row.line)
    };
    let [(a, reads, line), (b, other_reads, other_line)] = codes.map(key);
    a.total_cmp(&b).then_with(|| (reads, line).cmp(&(other_reads, other_line)))
}

/// For each step the row of odometry that is next, itself included; `u32::MAX` behind the last. `order`: the codes of
/// the steps, where they are not the rows as they stand.
pub(crate) fn ways(drive: &Drive, order: Option<&[u32]>) -> Vec<u32> {
    let rows =
        order.map_or_else(|| (0..drive.rows.len() as u32).collect(), |codes| codes.iter().map(|it| it >> 1).collect());
    let (mut next, mut ways): (u32, Vec<u32>) = (u32::MAX, rows);
    for row in ways.iter_mut().rev() {
        next = if drive.rows[*row as usize].event.is_motion() { *row } else { next };
        *row = next;
    }
    ways
}

/// When a row of odometry ends, s, its distance and its turn.
pub(crate) fn way(drive: &Drive, row: u32) -> Option<[f64; 3]> {
    match drive.rows.get(row as usize) {
        Some(Row { time, event: Event::Odometry { distance, turn }, .. }) => Some([*time, *distance, *turn]),
        _ => None,
    }
}

/// Over a step that is longer than so many times the median of its kind a rate is held: a robot that stands may not be
/// read until it drives on.
const LONG: f64 = 3.5;

/// What a row reads of speed and turn rate.
fn rates(event: &Event) -> [Option<f64>; 2] {
    match *event {
        Event::Velocity { v, omega } => [Some(v), Some(omega)],
        Event::Speed { v } => [Some(v), None],
        Event::TurnRate { omega } => [None, Some(omega)],
        _ => [None; 2],
    }
}

/// The longest step over which each rate changes evenly, s.
fn longest(drive: &Drive) -> [f64; 2] {
    [0, 1].map(|kind| {
        let times = drive.rows.iter().filter(|row| rates(&row.event)[kind].is_some()).map(|row| row.time);
        let mut before = None;
        let step = |time| Some(time - before.replace(time)?);
        LONG * median(times.filter_map(step))
    })
}

/// Of rates that change evenly, by row: the mean of what each row reads and of what the next row of its kind does. The
/// last of a kind is held, and one before a long step.
pub(crate) fn means(drive: &Drive) -> Vec<[f64; 2]> {
    let (longest, mut next) = (longest(drive), [None; 2]);
    let mean = |row: &Row| {
        let read = rates(&row.event);
        let of = |kind: usize| {
            let now = read[kind]?;
            let near = next[kind].filter(|(time, _): &(f64, f64)| time - row.time <= longest[kind]);
            Some(near.map_or(now, |(_, next)| 0.5 * (now + next)))
        };
        let means = [0, 1].map(|kind| of(kind).unwrap_or(0.0));
        next = [0, 1].map(|kind| read[kind].map(|rate| (row.time, rate)).or(next[kind]));
        means
    };
    let mut means: Vec<[f64; 2]> = drive.rows.iter().rev().map(mean).collect();
    means.reverse();
    means
}

/// The same motion at other rates; what is no rate stays.
pub(crate) fn at_rates(event: Event, [v, omega]: [f64; 2]) -> Event {
    match event {
        Event::Velocity { .. } => Event::Velocity { v, omega },
        Event::Speed { .. } => Event::Speed { v },
        Event::TurnRate { .. } => Event::TurnRate { omega },
        other => other,
    }
}

/// The step of a code.
pub(crate) fn step(drive: &Drive, code: u32, delays: &Delays) -> Option<Step> {
    let index = (code >> 1) as usize;
    let row = drive.rows.get(index)?;
    let counts = code & 1 == 0;
    let (event, delay) = match row.event {
        Event::Velocity { v, .. } if !counts => (Event::Speed { v }, delays.speed),
        Event::Velocity { omega, .. } if delays.speed != delays.turn => (Event::TurnRate { omega }, delays.turn),
        Event::Velocity { .. } | Event::TurnRate { .. } => (row.event, delays.turn),
        Event::Speed { .. } => (row.event, delays.speed),
        Event::Odometry { .. } => (row.event, 0.0),
        Event::Position { .. } => (row.event, delays.fix),
        Event::Heading { .. } => (row.event, delays.heading),
        Event::Range { .. } | Event::RangeBearing { .. } => (row.event, delays.sighting),
    };
    Some(Step { row: index, stamp: row.time, time: row.time - delay, event, counts, way: None })
}
