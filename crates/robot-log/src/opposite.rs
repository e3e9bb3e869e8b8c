//! Whether headings turn the other way round than the robot does: then they, or its turns, are counted the other way.

use crate::lag::{ALIKE, Travelled, together};
use core::f64::consts::{FRAC_PI_2, TAU};
use estimate::drive::{Event, Row};

/// Over how long turns are taken, s: a noisy compass needs longer ones than a robot that turns to and fro.
const WINDOWS: [f64; 3] = [1.0, 4.0, 16.0];

/// Whether the headings among `rows` turn the other way round than the motion among `all` does.
pub(crate) fn opposite(all: &[Row], rows: &[Row]) -> bool {
    let read = |row: &Row| if let Event::Heading { theta, .. } = row.event { Some([row.time, theta]) } else { None };
    let mut headings: Vec<[f64; 2]> = rows.iter().filter_map(read).collect();
    if headings.is_empty() {
        return false;
    }
    headings.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut motion: Vec<&Row> = all.iter().filter(|row| row.event.is_motion()).collect();
    motion.sort_by(|one, other| one.time.total_cmp(&other.time));
    let turned = Travelled::new(motion);
    let alike = WINDOWS.map(|window| together(&pairs(&headings, &turned, window)));
    // What goes together over one time is told, whatever noise makes of another.
    alike.into_iter().find(|alike| alike.abs() > ALIKE).is_some_and(|alike| alike < 0.0)
}

/// By how much headings about `window` seconds apart differ, and how far the robot turned meanwhile; rad.
fn pairs(headings: &[[f64; 2]], turned: &Travelled, window: f64) -> Vec<[f64; 2]> {
    let (mut pairs, mut next) = (Vec::new(), f64::NEG_INFINITY);
    for (i, &[from, theta]) in headings.iter().enumerate().filter(|(_, heading)| heading[0].is_finite()) {
        let later = headings.get(i + headings[i..].partition_point(|heading| heading[0] < from + window));
        let Some(&[to, there]) = later.filter(|later| from >= next && later[0] < from + 2.0 * window) else { continue };
        let Some([before, after]) = turned.at(from).zip(turned.at(to)).map(|(one, other)| [one[1], other[1]]) else {
            continue;
        };
        // Farther than a quarter is as near the other way round, or nearly.
        if (after - before).abs() < FRAC_PI_2 {
            pairs.push([libm::remainder(there - theta, TAU), after - before]);
            next = from + window;
        }
    }
    pairs
}
