//! Delays that a log of odometry does not tell: between two rows of motion the estimate stands still, and the
//! likelihood of a delay is a staircase.

use crate::drive::gaps::median;
use crate::drive::row::{Drive, Motion};

/// So many places a step are looked at, and so many steps either way.
const PLACES: u32 = 20;
const STEPS: u32 = 2;
/// Log-likelihoods nearer than this are one.
const SAME: f64 = 1e-6;
/// A stair narrower than this share of a step is none: the readings come at all times between two rows.
const WIDE: f64 = 0.4;

/// From where to where the likelihood of a delay is the same as at `at`, by `value` there, if that is a stair.
pub(crate) fn flat(drive: &Drive, at: f64, mut value: impl FnMut(f64) -> Option<f64>) -> Option<[f64; 2]> {
    if drive.motion != Motion::Odometry {
        return None;
    }
    let moves = drive.rows.iter().filter(|row| row.event.is_motion()).map(|row| row.time);
    let period = median(moves.clone().zip(moves.skip(1)).map(|(a, b)| b - a));
    let step = period / f64::from(PLACES);
    let best = value(at)?;
    let mut side = |sign: f64| {
        let places = (1..=PLACES * STEPS).map(|k| at + sign * step * f64::from(k));
        places.take_while(|place| value(*place).is_some_and(|it| (it - best).abs() < SAME)).last().unwrap_or(at)
    };
    let stair = [side(-1.0), side(1.0)];
    (stair[1] - stair[0] > WIDE * period).then_some(stair)
}
