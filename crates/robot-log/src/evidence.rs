//! What follows from how a file is read: its rate and span, and the extent of what it holds. A wrong column or unit
//! shows here.

use crate::fields::is_none;
use crate::no_value;
use crate::reading::LogReader;
use crate::table::Table;
use core::f64::consts::{PI, TAU};
use estimate::Landmark;
use estimate::drive::{Event, Pose, Row};

/// Times beyond this are those of a calendar, s.
const CALENDAR: f64 = 1e8;

/// How many values of a column are shown, of the first rows; where these have fewer, of those behind them.
const SAMPLES: usize = 3;
const SAMPLED: usize = 200;
const SAMPLED_AT_MOST: usize = 20_000;

/// Three values of a column: of its first, a middle and the last of its first rows, or the first three that are there.
pub(crate) fn samples<'t>(table: &Table, text: &'t str, column: usize) -> Vec<&'t str> {
    let (mut all, mut looked) = (Vec::new(), 0);
    for line in table.lines(text).filter_map(Result::ok).take(SAMPLED_AT_MOST) {
        if looked >= SAMPLED && all.len() >= SAMPLES {
            break;
        }
        looked += 1;
        all.extend(line.fields.get(column).map(|field| field.text).filter(|text| !is_none(text)));
    }
    match all.as_slice() {
        [] if looked > 0 => vec![""],
        sparse if 2 * sparse.len() < looked => sparse.iter().take(SAMPLES).copied().collect(),
        few if few.len() <= SAMPLES => few.to_vec(),
        all => vec![all[0], all[all.len() / 2], all[all.len() - 1]],
    }
}

/// What follows from the rows that a file has by itself, in words; empty of a file without rows.
pub(crate) fn follows(read: &LogReader) -> String {
    let mut rows = read.to.rows().to_vec();
    rows.sort_by(|a, b| a.time.total_cmp(&b.time));
    // The log says how many there were.
    no_value::left_out(&mut rows);
    let poses = read.poses();
    let (landmarks, seen) = read.to.landmarks();
    let times: Vec<f64> = rows.iter().map(|row| row.time).chain(poses.iter().map(|pose| pose.time)).collect();
    let mut parts = Vec::new();
    parts.extend(rate(times));
    parts.extend(motion(&rows));
    parts.extend(places("positions", &fixes(&rows)));
    parts.extend(spreads(&rows));
    parts.extend(places("true positions", &poses.iter().map(|pose| [pose.x, pose.y]).collect::<Vec<_>>()));
    parts.extend(headings(&rows, &poses));
    parts.extend(ranges(&rows, seen.len()));
    parts.extend(map(landmarks));
    parts.join(", ")
}

/// How often rows come, and from when to when.
pub(crate) fn rate(mut times: Vec<f64>) -> Vec<String> {
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    let (Some(from), Some(to)) = (times.first(), times.last()) else { return Vec::new() };
    let span = to - from;
    let hertz = (span > 0.0).then(|| format!("{} Hz", short((times.len() - 1) as f64 / span)));
    let spanned = if from.abs() > CALENDAR || from.abs() > 1e3 * span {
        format!("{} s long", short(span))
    } else {
        format!("{} to {} s", short(*from), short(*to))
    };
    hertz.into_iter().chain([spanned]).collect()
}

/// Speeds, the way and the turns that they add up to.
fn motion(rows: &[Row]) -> Vec<String> {
    let (mut speeds, mut rates) = (Vec::new(), Vec::new());
    let (mut way, mut turned, mut v, mut omega) = (0.0, 0.0, 0.0, 0.0);
    let (mut before, mut moved) = (None, [false; 2]);
    for row in rows {
        let dt = before.replace(row.time).map_or(0.0, |before: f64| row.time - before);
        (way, turned) = (way + f64::abs(v) * dt, turned + omega * dt);
        match row.event {
            Event::Odometry { distance, turn } => {
                (way, turned, moved) = (way + distance.abs(), turned + turn, [true; 2]);
            }
            Event::Velocity { v: along, omega: turning } => {
                (v, omega, moved) = (along, turning, [true; 2]);
                speeds.push(v);
                rates.push(omega);
            }
            Event::Speed { v: along } => {
                (v, moved[0]) = (along, true);
                speeds.push(v);
            }
            Event::TurnRate { omega: turning } => {
                (omega, moved[1]) = (turning, true);
                rates.push(omega);
            }
            _ => {}
        }
    }
    let mut said = Vec::new();
    said.extend(between(&speeds).map(|[least, most]| format!("v {} \u{2026} {} m/s", short(least), short(most))));
    if moved[0] {
        said.push(format!("{} m of way", short(way)));
    }
    if moved[1] {
        said.push(format!("turned {} turns", short(turned / TAU)));
    }
    said
}

fn fixes(rows: &[Row]) -> Vec<[f64; 2]> {
    rows.iter()
        .filter_map(|row| if let Event::Position { x, y, .. } = row.event { Some([x, y]) } else { None })
        .collect()
}

/// The standard deviations that fixes have of their own.
fn spreads(rows: &[Row]) -> Option<String> {
    let own = rows.iter().filter_map(|row| if let Event::Position { sigma, .. } = row.event { sigma } else { None });
    let [least, most] = between(&own.collect::<Vec<_>>())?;
    let to = if least == most { String::new() } else { format!(" \u{2026} {}", short(most)) };
    Some(format!("their \u{3c3} {}{to} m", short(least)))
}

/// How far places reach.
fn places(what: &str, places: &[[f64; 2]]) -> Option<String> {
    let side = |i: usize| between(&places.iter().map(|place| place[i]).collect::<Vec<_>>());
    let (Some([west, east]), Some([south, north])) = (side(0), side(1)) else { return None };
    Some(format!("{what} within {} m by {} m", short(east - west), short(north - south)))
}

fn headings(rows: &[Row], poses: &[Pose]) -> Option<String> {
    let read =
        rows.iter().filter_map(|row| if let Event::Heading { theta, .. } = row.event { Some(theta) } else { None });
    // A course of 0 to 360 degrees from north is a heading from −270 to 90: within a half turn either way it is known.
    let within = |theta: f64| if theta.abs() > PI { theta - TAU * (theta / TAU).round() } else { theta };
    let all: Vec<f64> = read.chain(poses.iter().map(|pose| pose.theta)).map(within).collect();
    let [least, most] = between(&all)?;
    (least != most)
        .then(|| format!("headings {} \u{2026} {}\u{b0}", short(least.to_degrees()), short(most.to_degrees())))
}

fn ranges(rows: &[Row], seen: usize) -> Option<String> {
    let range = |row: &Row| match row.event {
        Event::Range { range, .. } | Event::RangeBearing { range, .. } => Some(range),
        _ => None,
    };
    let [least, most] = between(&rows.iter().filter_map(range).collect::<Vec<_>>())?;
    let what = if seen == 1 { "landmark" } else { "landmarks" };
    Some(format!("ranges {} \u{2026} {} m to {seen} {what}", short(least), short(most)))
}

fn map(landmarks: &[Landmark]) -> Option<String> {
    let at: Vec<[f64; 2]> = landmarks.iter().map(|landmark| [landmark.x, landmark.y]).collect();
    places(&format!("{} landmarks", at.len()), &at)
}

fn between(values: &[f64]) -> Option<[f64; 2]> {
    let least = values.iter().copied().reduce(f64::min)?;
    Some([least, values.iter().copied().reduce(f64::max)?])
}

/// A number with three digits that count.
pub(crate) fn short(number: f64) -> String {
    let size = number.abs();
    // Half a unit below each power of ten the number is rounded up to it.
    let places = [99.95, 9.995, 0.9995, 0.09995].iter().filter(|least| size < **least).count();
    let text = format!("{size:.places$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if number < 0.0 && text != "0" { format!("\u{2212}{text}") } else { text.to_string() }
}
