//! Where a drive began, as far as its first readings tell: a place to start a filter from where no truth says it.
//!
//! The first fixes alone do not tell the heading of a robot that turns on its way from one to the next, nor that of one
//! that drives backwards. The log has the motion between them: the heading is the one under which the filter finds the
//! first fixes most likely.

use super::opening_parabola::parabola;
use super::opening_trust::{FIRST, Held, tells, trusted as trusted_of};
use super::{Course, Drive, Event, Replay, Settings, Truth};
use alloc::vec::Vec;
use core::f64::consts::PI;
use geom::{SE2, wrap};
use nalgebra::Vector3;

/// Where no motion tells the way, a second fix tells the heading once it is so many of its standard deviations away;
/// and so far from the heading that the fixes tell, one that was read is another.
const FAR: f64 = 5.0;
/// So many fixes are tried first, and then twice as many, to so many rows.
const FEWEST: usize = 4;
const MOST_ROWS: usize = 50_000;
/// A heading that is known is sought again in so many rows at most, and as long as σ falls to this part.
const MANY_ROWS: usize = 4000;
const BETTER: f64 = 0.8;
/// A heading that is so well known needs no more fixes, rad.
const ENOUGH: f64 = 0.05;
/// Beyond this the likelihood of a heading is no parabola, rad.
const PARABOLIC: f64 = 0.6;
/// The start is tried so exactly known that it is the one that is tried, in standard deviations of a fix, and rad.
const KNOWN: f64 = 1e-3;
/// A robot that has gone so many σ of the distance has driven.
const DRIVEN: f64 = 3.0;
/// How often the top of the parabola is sought anew.
const ROUNDS: usize = 4;

/// The start of a drive by its first readings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// x, y and θ: metres, radians.
    pub pose: [f64; 3],
    /// The standard deviation of x and of y, m: the first fix's. A filter reads the first fixes again, and would count
    /// them twice if it knew the place as well as all of them tell it.
    pub sigma: f64,
    /// That of the heading, rad; π, which is no knowledge, where nothing tells it.
    pub sigma_heading: f64,
}

impl Drive {
    /// The start by the first readings; fixes and headings without a standard deviation of their own take that of
    /// `settings`, of which the noise of the motion counts too. Without a fix, by the first ranges to the landmarks;
    /// `None` without either, or where the ranges do not tell it.
    ///
    /// The place and the heading are those under which the first fixes are most likely, with the motion that is logged
    /// between them; of the stretches of 4, 8, 16 … fixes the one is taken that tells the heading best. Its standard
    /// deviation is that of the likelihood's top, where the scale of the speed and the bias of the turn rate are not
    /// known; it is widened by √NIS where the fixes are farther from the motion than is claimed. A heading that was
    /// read, led back to the start by the turns since, is taken where it is better known. Where the motion tells no
    /// way, the direction to the first fix that is far away is the heading.
    /// Of the first fixes those are outliers, and tell nothing, whose distances from their neighbours are others than
    /// the motion tells.
    pub fn opening(&self, settings: &Settings) -> Option<Opening> {
        let fixes = self.rows.iter().enumerate().filter(|(_, row)| matches!(row.event, Event::Position { .. }));
        let end = fixes.take(FIRST).last().map_or(0, |(at, _)| at + 1);
        let held = if end > MOST_ROWS { None } else { pairs(&self.without_sightings(end), settings) };
        let trusted = held.filter(|fixes| fixes.len() > 2 && self.rows.iter().any(|row| row.event.is_motion()));
        match trusted.and_then(|fixes| trusted_of(self, &fixes, MOST_ROWS)) {
            Some(trusted) => trusted.opened(settings),
            None => self.opened(settings),
        }
    }

    fn opened(&self, settings: &Settings) -> Option<Opening> {
        let fix = |event: &Event| match *event {
            Event::Position { x, y, sigma } => Some((x, y, settings.of_fix(sigma))),
            _ => None,
        };
        let mut fixes = self.rows.iter().filter_map(|row| fix(&row.event));
        let Some(first) = fixes.next() else {
            return self.opening_by_ranges(settings).map(|found| self.headed(found, settings));
        };
        // The first that tells something.
        let known = |fix: &(f64, f64, f64)| tells(fix.2);
        let (x, y, sigma) = core::iter::once(first).chain(fixes).find(known).unwrap_or(first);
        let by_chord = || {
            let (theta, off) = self.chord(settings).unwrap_or((0.0, PI));
            (below(settings, [x, y, theta]), off)
        };
        let fixes = self.fitted(settings);
        let (pose, off) = fixes.unwrap_or_else(by_chord);
        Some(self.headed(Opening { pose, sigma, sigma_heading: off.min(PI) }, settings))
    }

    /// An opening with the heading that was read, where that is better known, and no other than the fixes tell: an
    /// antenna or a compass may be turned.
    fn headed(&self, opening: Opening, settings: &Settings) -> Opening {
        let [x, y, _] = opening.pose;
        match self.first_heading(settings) {
            Some((theta, read))
                if read < opening.sigma_heading
                    && wrap(theta - opening.pose[2]).abs() < FAR * libm::hypot(read, opening.sigma_heading) =>
            {
                Opening { pose: [x, y, theta], sigma_heading: read, ..opening }
            }
            _ => opening,
        }
    }

    /// The direction from the first fix to the first one far from it, and its σ: √2 σ over their distance.
    fn chord(&self, settings: &Settings) -> Option<(f64, f64)> {
        let fix = |event: &Event| match *event {
            Event::Position { x, y, sigma } => Some((x, y, settings.of_fix(sigma))),
            _ => None,
        };
        let mut fixes = self.rows.iter().filter_map(|row| fix(&row.event));
        let (x, y, first) = fixes.find(|fix| tells(fix.2))?;
        fixes.find_map(|(px, py, own)| {
            let (distance, off) = (libm::hypot(px - x, py - y), libm::hypot(first, own));
            (distance > FAR * off).then(|| (libm::atan2(py - y, px - x), off / distance))
        })
    }

    /// The first heading that was read at the start or behind it, led back by the turns since, and its σ.
    fn first_heading(&self, settings: &Settings) -> Option<(f64, f64)> {
        let at = self.rows.iter().take(MOST_ROWS).position(|row| matches!(row.event, Event::Heading { .. }))?;
        let Event::Heading { theta, sigma } = self.rows[at].event else { return None };
        let stretch = self.stretch(at + 1);
        let course = Course::new(&stretch, Settings { start: None, ..settings.reckoning() }).ok()?;
        let mut replay = Replay::new(&course);
        while replay.take(&stretch, &course).ok()?.is_some() {}
        let drifted = settings.sigma_turn * libm::sqrt((self.rows[at].time - course.start()).max(0.0));
        let before = self.rows[at].time < course.start();
        let off = libm::hypot(settings.of_heading(sigma), drifted);
        (!before).then(|| (wrap(theta - settings.heading_offset - replay.pose().theta()), off))
    }

    /// The first rows of the drive, without truth and headings.
    pub(super) fn stretch(&self, rows: usize) -> Drive {
        let rows = self.rows.iter().take(rows).copied().collect();
        Drive { landmarks: Vec::new(), truth: Truth::new(Vec::new()), rows, motion: self.motion }
    }

    /// The start under which the first fixes are most likely, and the σ of its heading; `None` where the motion between
    /// them does not tell it.
    fn fitted(&self, settings: &Settings) -> Option<([f64; 3], f64)> {
        let mut best: Option<([f64; 3], f64)> = None;
        let mut count = FEWEST;
        loop {
            let mut fixes = self.rows.iter().enumerate().filter(|(_, row)| matches!(row.event, Event::Position { .. }));
            let last = fixes.by_ref().nth(count - 1).map(|(at, _)| at + 1);
            let rows = last.unwrap_or(self.rows.len());
            if rows > MOST_ROWS || (best.is_some() && rows > MANY_ROWS) {
                return best;
            }
            let found = fit(&self.without_sightings(rows), settings);
            if let (Some((_, known)), Some((_, off))) = (best, found)
                && off > BETTER * known
            {
                // More fixes tell hardly more, or less: the motion has drifted by more than they tell.
                return if off < known { found } else { best };
            }
            if best.is_some() && found.is_none() {
                return best;
            }
            best = found;
            if last.is_none() || best.is_some_and(|(_, off)| off < ENOUGH) {
                return best;
            }
            count *= 2;
        }
    }

    fn without_sightings(&self, rows: usize) -> Drive {
        let mut stretch = self.stretch(rows);
        stretch.rows.retain(|row| row.event.is_motion() || matches!(row.event, Event::Position { .. }));
        stretch
    }
}

/// The robot's pose below an antenna, of which the heading is the robot's.
fn below(settings: &Settings, [x, y, theta]: [f64; 3]) -> [f64; 3] {
    let [ahead, left] = settings.antenna;
    SE2::new(x, y, theta).compose(SE2::new(-ahead, -left, 0.0)).to_vector().into()
}

/// The start of a stretch of motion and fixes, and the σ of its heading.
fn fit(stretch: &Drive, settings: &Settings) -> Option<([f64; 3], f64)> {
    let pairs = pairs(stretch, settings)?;
    if !has_driven(stretch, &pairs, settings) {
        return None;
    }
    let (antenna, rough) = turned(&pairs)?;
    let mut pose = Vector3::from(below(settings, antenna.into()));
    let sigma = pairs.iter().map(|pair| pair.sigma).fold(f64::INFINITY, f64::min);
    let small = sigma * KNOWN;
    let told = |pose: Vector3<f64>| likelihood(stretch, settings, pose, small);
    // The steps in which the likelihood is felt out: so far it falls by about a half.
    let steps = Vector3::new(sigma, sigma, rough.min(PARABOLIC)) * 0.5;
    let mut off = None;
    for _ in 0..ROUNDS {
        let (slope, bend) = parabola(told, pose, steps)?;
        let covariance = (-bend).try_inverse().filter(|it| (0..3).all(|i| it[(i, i)] > 0.0))?;
        let step = covariance * slope;
        pose += step;
        off = Some(libm::sqrt(covariance[(2, 2)]));
        if (0..3).all(|i| step[i].abs() < 0.01 * libm::sqrt(covariance[(i, i)])) {
            break;
        }
    }
    let (_, nis) = told(pose)?;
    let off = off? * libm::sqrt(nis.max(1.0));
    (off < PARABOLIC && pose.iter().all(|it| it.is_finite())).then(|| ([pose[0], pose[1], wrap(pose[2])], off))
}

/// Whether the robot has driven farther than the noise of what is read of a standing one leads.
fn has_driven(stretch: &Drive, pairs: &[Held], settings: &Settings) -> bool {
    let (Some(first), Some([from, to])) = (pairs.first(), stretch.span()) else { return false };
    let far = |pair: &Held| libm::hypot(pair.reckoned[0] - first.reckoned[0], pair.reckoned[1] - first.reckoned[1]);
    pairs.iter().map(far).fold(0.0, f64::max) > DRIVEN * settings.sigma_distance * libm::sqrt(to - from)
}

/// Each fix of a stretch beside where the motion alone leads.
fn pairs(stretch: &Drive, settings: &Settings) -> Option<Vec<Held>> {
    let course = Course::new(stretch, Settings { start: None, ..settings.reckoning() }).ok()?;
    let (mut replay, mut pairs) = (Replay::new(&course), Vec::new());
    while let Some(taken) = replay.take(stretch, &course).ok()? {
        if let Event::Position { x, y, sigma } = stretch.rows[taken.row].event {
            let reckoned = [replay.pose().x(), replay.pose().y()];
            pairs.push(Held { reckoned, fix: [x, y], sigma: settings.of_fix(sigma) });
        }
    }
    (!pairs.is_empty()).then_some(pairs)
}

/// The pose that turns and shifts what was reckoned onto the fixes, each counted by 1/σ², and the σ of its heading as
/// if the motion had no noise. `None` where what was reckoned has no extent.
fn turned(pairs: &[Held]) -> Option<(Vector3<f64>, f64)> {
    let weight: f64 = pairs.iter().map(|pair| 1.0 / (pair.sigma * pair.sigma)).sum();
    let mean =
        |of: fn(&Held) -> f64| pairs.iter().map(|pair| of(pair) / (pair.sigma * pair.sigma)).sum::<f64>() / weight;
    let reckoned = [mean(|pair| pair.reckoned[0]), mean(|pair| pair.reckoned[1])];
    let fixed = [mean(|pair| pair.fix[0]), mean(|pair| pair.fix[1])];
    let (mut along, mut across, mut extent) = (0.0, 0.0, 0.0);
    for Held { reckoned: at, fix, sigma } in pairs {
        let weight = 1.0 / (sigma * sigma);
        let (qx, qy) = (at[0] - reckoned[0], at[1] - reckoned[1]);
        let (px, py) = (fix[0] - fixed[0], fix[1] - fixed[1]);
        along += weight * (qx * px + qy * py);
        across += weight * (qx * py - qy * px);
        extent += weight * (qx * qx + qy * qy);
    }
    let off = 1.0 / libm::sqrt(extent);
    if off > PARABOLIC {
        return None;
    }
    let theta = libm::atan2(across, along);
    let (sin, cos) = libm::sincos(theta);
    let x = fixed[0] - cos * reckoned[0] + sin * reckoned[1];
    let y = fixed[1] - sin * reckoned[0] - cos * reckoned[1];
    Some((Vector3::new(x, y, theta), off))
}

/// The log-likelihood of a stretch's fixes from a start, and their NIS for each output.
fn likelihood(stretch: &Drive, settings: &Settings, pose: Vector3<f64>, small: f64) -> Option<(f64, f64)> {
    let start = Some([pose[0], pose[1], pose[2]]);
    let Settings { sigma_distance, sigma_turn, sigma_fix, fix_sigma_scale, .. } = *settings;
    let Settings { antenna, .. } = *settings;
    let usual = Settings { sigma_distance, sigma_turn, sigma_fix, fix_sigma_scale, antenna, ..Settings::default() };
    // Scale of the speed and bias of the turn rate are not known here: they may be what their states begin with.
    let held = !stretch.motion.is_odometry();
    let usual = Settings { learn_speed: held, learn_bias: held, ..usual };
    let told = Settings { start, start_sigma: small, start_sigma_heading: KNOWN, ..usual };
    let course = Course::new(stretch, told).ok()?;
    let (mut replay, mut sum) = (Replay::new(&course), 0.0);
    while let Some(taken) = replay.take(stretch, &course).ok()? {
        sum += taken.judged.map_or(0.0, |judged| judged.log_likelihood());
    }
    Some((sum, replay.summary(&course).nis?))
}
