//! Where a drive began, by its first ranges to landmarks whose places are known, of a log without fixes.
//!
//! Few ranges fit several places: two circles cross twice, and a robot that drives straight has a mirrored twin. The
//! place and heading are sought all over the landmarks, and are taken where no other place fits nearly as well.

use super::opening::Opening;
use super::opening_seen::{Seen, cost, weight};
use super::opening_spread::{covariance, roots, spread as wide};
use super::{Course, Drive, Event, Replay, Settings};
use alloc::vec::Vec;
use core::f64::consts::{PI, TAU};
use geom::wrap;
use nalgebra::{Matrix3, Vector3};

/// So many readings are tried first, and then twice as many, at most so many among so many rows.
const FEWEST: usize = 24;
const MOST: usize = 768;
const MOST_ROWS: usize = 50_000;
/// A heading that is so well known needs no more readings, rad; one that is less known than this is not.
const ENOUGH: f64 = 0.05;
const UNKNOWN: f64 = 0.6;
/// Places and headings that are tried: so many along each side, in so many directions; so many of each direction are
/// improved, as a twin may have another one.
const SIDE: usize = 9;
const WAYS: usize = 12;
const BEST: usize = 4;
/// How often one is improved.
const ROUNDS: usize = 40;
/// Readings that are so many times farther from the best start than they claim are of another world.
const WORST: f64 = 3.0;
/// A place that is known no better than to this part of the longest range is not known.
const PART: f64 = 0.2;
/// Another place is as likely where its readings are not e to this less likely.
const CLEAR: f64 = 5.0;
/// It is another place where it is so many standard deviations away, and so far, m and rad.
const APART: f64 = 6.0;
const FAR: f64 = 0.3;

/// A start, how badly the readings fit it, and how well they tell it.
#[derive(Clone, Copy)]
struct Found {
    pose: Vector3<f64>,
    cost: f64,
    information: Matrix3<f64>,
}

impl Drive {
    /// The start under which the first ranges, and bearings, fit best; `None` where another fits nearly as well, or
    /// where none fits.
    pub(super) fn opening_by_ranges(&self, settings: &Settings) -> Option<Opening> {
        let (mut count, mut best) = (FEWEST, None);
        loop {
            let seen = self.seen(settings, count)?;
            let found = start(&seen).and_then(|found| opening(&found, &seen));
            if found.is_none() && best.is_some() {
                return best;
            }
            best = found.or(best);
            let known = best.is_some_and(|it| it.sigma_heading < ENOUGH);
            if known || seen.len() < count || 2 * count > MOST {
                return best;
            }
            count *= 2;
        }
    }

    /// The first readings of landmarks, each beside what was reckoned.
    fn seen(&self, settings: &Settings, count: usize) -> Option<Vec<Seen>> {
        let is_seen = |event: &Event| matches!(event, Event::Range { .. } | Event::RangeBearing { .. });
        let all = self.rows.iter().take(MOST_ROWS).enumerate().filter(|(_, row)| is_seen(&row.event));
        let end = all.take(count).last().map(|(at, _)| at + 1)?;
        let stretch = Drive { landmarks: self.landmarks.clone(), ..self.stretch(end) };
        let told = Settings { start: None, start_sigma: 1e-3, start_sigma_heading: 1e-3, ..settings.reckoning() };
        let course = Course::new(&stretch, told).ok()?;
        let (mut replay, mut seen) = (Replay::new(&course), Vec::new());
        while let Some(taken) = replay.take(&stretch, &course).ok()? {
            let (landmark, range, bearing) = match stretch.rows[taken.row].event {
                Event::Range { landmark, range } => (landmark, range, None),
                Event::RangeBearing { landmark, range, bearing } => (landmark, range, Some(bearing)),
                _ => continue,
            };
            let at = stretch.landmarks.get(landmark)?;
            seen.push(Seen::new([at.x, at.y], (range, bearing), &replay, settings));
        }
        (seen.len() > 3).then_some(seen)
    }
}

/// The start that the readings fit best; `None` where another fits nearly as well.
fn start(seen: &[Seen]) -> Option<Found> {
    let reach = seen.iter().map(|it| it.range).fold(0.0, f64::max);
    let side = |axis: usize| {
        let of = |fold: fn(f64, f64) -> f64, begin| seen.iter().map(|it| it.landmark[axis]).fold(begin, fold);
        [of(f64::min, f64::INFINITY) - reach, of(f64::max, f64::NEG_INFINITY) + reach]
    };
    let (x, y) = (side(0), side(1));
    let at = |[from, to]: [f64; 2], i: usize| from + (to - from) * i as f64 / (SIDE - 1) as f64;
    let mut found: Vec<Found> = Vec::new();
    for way in 0..WAYS {
        let theta = TAU * way as f64 / WAYS as f64;
        let places = (0..SIDE * SIDE).map(|i| Vector3::new(at(x, i % SIDE), at(y, i / SIDE), theta));
        let mut tried: Vec<(f64, Vector3<f64>)> = places.map(|pose| (cost(seen, &pose), pose)).collect();
        tried.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        found.extend(tried.iter().take(BEST).filter_map(|(_, pose)| improved(seen, *pose)));
    }
    found.sort_by(|one, other| one.cost.total_cmp(&other.cost));
    let (best, others) = found.split_first()?;
    let off = deviations(best)?;
    let apart = |other: &&Found| {
        let step = other.pose - best.pose;
        let place = libm::hypot(step[0], step[1]);
        let turned = wrap(step[2]).abs();
        place > FAR + APART * libm::hypot(off[0], off[1]) || (off[2] < UNKNOWN && turned > FAR + APART * off[2])
    };
    let rival = others.iter().find(apart).map_or(f64::INFINITY, |it| it.cost);
    (rival - best.cost > CLEAR).then_some(*best)
}

/// A start that is moved to where the readings fit best near it (Levenberg and Marquardt).
fn improved(seen: &[Seen], mut pose: Vector3<f64>) -> Option<Found> {
    let (mut before, mut damped) = (cost(seen, &pose), 1e-3);
    let mut information = Matrix3::zeros();
    for _ in 0..ROUNDS {
        let mut slope = Vector3::zeros();
        information = Matrix3::zeros();
        for it in seen {
            let (residuals, slopes) = it.residuals(&pose);
            for (residual, along) in residuals.into_iter().zip(slopes) {
                let weight = weight(residual);
                slope -= along * (weight * residual);
                information += along * along.transpose() * weight;
            }
        }
        let mut bent = information;
        (0..3).for_each(|i| bent[(i, i)] += damped * information[(i, i)].max(1e-9));
        let step = bent.try_inverse()? * slope;
        let next = pose + step;
        let after = cost(seen, &next);
        if after <= before {
            (pose, damped) = (next, (damped * 0.3).max(1e-9));
            let done = before - after < 1e-9 * (1.0 + before);
            before = after;
            if done {
                break;
            }
        } else if damped > 1e9 {
            break;
        } else {
            damped *= 10.0;
        }
    }
    pose[2] = wrap(pose[2]);
    pose.iter().all(|it| it.is_finite()).then_some(Found { pose, cost: before, information })
}

/// The standard deviations of x, y and θ.
fn deviations(found: &Found) -> Option<Vector3<f64>> {
    roots(&covariance(&found.information)?)
}

/// The start as a filter takes it, which reads the same ranges again: it is told by half of them.
fn opening(found: &Found, seen: &[Seen]) -> Option<Opening> {
    let outputs: usize = seen.iter().map(|it| 1 + usize::from(it.bearing.is_some())).sum();
    let spread = libm::sqrt(2.0 * found.cost / outputs.saturating_sub(3).max(1) as f64);
    if spread > WORST {
        return None;
    }
    let off = wide(found.information, &found.pose, seen, spread)? * core::f64::consts::SQRT_2;
    let sigma = off[0].max(off[1]);
    let reach = seen.iter().map(|it| it.range).fold(0.0, f64::max);
    if sigma > PART * reach {
        return None;
    }
    let pose = [found.pose[0], found.pose[1], found.pose[2]];
    Some(Opening { pose, sigma, sigma_heading: off[2].min(PI) })
}
