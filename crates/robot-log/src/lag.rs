//! How far the clock of a truth is from that of the motion. Speeds and turns are the same in every frame, so they tell
//! a late truth from late fixes: the truth is shifted in time until its speeds and turns go as the motion's do.

use crate::alignment::Path;
use estimate::drive::{Drive, Event, Row};

/// Over how long speeds and turns are taken, s.
const WINDOW: f64 = 1.0;
/// How far apart the samples are, s, and how many there are at the most.
const EVERY: f64 = 0.5;
const MOST: usize = 1500;
/// The fewest samples that say something.
const FEWEST: usize = 24;
/// Slower than this, m/s, a truth has no direction.
const SLOW: f64 = 0.05;
/// Motion whose rows are farther apart than this, s, is not known between them.
const GAP: f64 = 2.0;
/// How finely shifts are tried, s.
const STEP: f64 = 0.05;
/// So strongly the speeds or the turns have to go together.
pub(crate) const ALIKE: f64 = 0.7;
/// A shift is told from none where the logarithm of the likelihood rises by more than this.
const TOLD: f64 = 15.0;

/// What the motion says of a truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lag {
    /// By how much the truth's stamps are to be shifted, s; `None` where that is not told from none.
    pub delay: Option<f64>,
    /// Whether the truth turns the other way.
    pub opposite: bool,
}

/// How far the robot went and turned since the first row of motion: time, m, rad.
pub(crate) struct Travelled(Vec<[f64; 3]>);

impl Travelled {
    /// By the rows of motion, in the order of their times.
    pub fn new<'r>(motion: impl IntoIterator<Item = &'r Row>) -> Self {
        let (mut knots, mut held) = (Vec::<[f64; 3]>::new(), [0.0; 2]);
        for row in motion {
            let [before, way, turned] = knots.last().copied().unwrap_or([row.time, 0.0, 0.0]);
            let apart = row.time - before;
            let mut now = [row.time, way + held[0] * apart, turned + held[1] * apart];
            match row.event {
                Event::Velocity { v, omega } => held = [v, omega],
                Event::Speed { v } => held[0] = v,
                Event::TurnRate { omega } => held[1] = omega,
                Event::Odometry { distance, turn } => now = [row.time, way + distance, turned + turn],
                _ => {}
            }
            knots.push(now);
        }
        Self(knots)
    }

    /// How far until a time, m and rad; `None` in a gap, and outside.
    pub fn at(&self, time: f64) -> Option<[f64; 2]> {
        let after = self.0.partition_point(|knot| knot[0] <= time);
        let (before, next) = (self.0.get(after.checked_sub(1)?)?, self.0.get(after)?);
        let (apart, share) = (next[0] - before[0], (time - before[0]) / (next[0] - before[0]));
        (apart <= GAP).then(|| [1, 2].map(|i| before[i] + share * (next[i] - before[i])))
    }

    /// The speed and the turn about a time.
    fn about(&self, time: f64) -> Option<[Option<f64>; 2]> {
        let [before, now, after] = [self.at(time - WINDOW)?, self.at(time)?, self.at(time + WINDOW)?];
        let speed = ((now[0] - before[0]).abs() + (after[0] - now[0]).abs()) / (2.0 * WINDOW);
        let turn = self.at(time + WINDOW / 2.0)?[1] - self.at(time - WINDOW / 2.0)?[1];
        Some([Some(speed), Some(turn)])
    }
}

/// The speed and the turn of the truth about a time; a truth that stands has no turn.
fn about(path: &Path<'_>, time: f64) -> Option<[Option<f64>; 2]> {
    let [before, now, after] = [path.at(time - WINDOW)?, path.at(time)?, path.at(time + WINDOW)?];
    let (one, two) = ([now[0] - before[0], now[1] - before[1]], [after[0] - now[0], after[1] - now[1]]);
    let ways = [one, two].map(|[x, y]| libm::hypot(x, y));
    let turn = libm::atan2(one[0] * two[1] - one[1] * two[0], one[0] * two[0] + one[1] * two[1]);
    // A turn of more than a quarter within a second is a robot that has gone back.
    let moves = ways.iter().all(|way| *way > SLOW * WINDOW) && turn.abs() < core::f64::consts::FRAC_PI_2;
    Some([Some((ways[0] + ways[1]) / (2.0 * WINDOW)), moves.then_some(turn)])
}

/// How two series go together, by Pearson's coefficient; 0 where there are too few, or one stands still.
pub(crate) fn together(pairs: &[[f64; 2]]) -> f64 {
    if pairs.len() < FEWEST {
        return 0.0;
    }
    let count = pairs.len() as f64;
    let means = [0, 1].map(|i| pairs.iter().map(|pair| pair[i]).sum::<f64>() / count);
    let [mut ones, mut both, mut twos] = [0.0; 3];
    for pair in pairs {
        let [one, two] = [pair[0] - means[0], pair[1] - means[1]];
        (ones, both, twos) = (ones + one * one, both + one * two, twos + two * two);
    }
    let size = libm::sqrt(ones * twos);
    if size > 1e-12 * count { both / size } else { 0.0 }
}

/// Compares the truth with the motion, its stamps shifted by up to `most`, s. `None` where the two do not go together:
/// then the motion says nothing of the truth's clock.
pub(crate) fn lag(drive: &Drive, path: &Path<'_>, most: f64) -> Option<Lag> {
    let (course, [from, to]) = (Travelled::new(drive.rows.iter().filter(|row| row.event.is_motion())), path.span());
    let (from, to) = (from + most + WINDOW, to - most - WINDOW);
    if to - from < EVERY * FEWEST as f64 {
        return None;
    }
    let every = EVERY.max((to - from) / MOST as f64);
    let times = (0..=MOST).map(|i| from + every * i as f64).take_while(|time| *time <= to);
    let moved: Vec<(f64, [Option<f64>; 2])> = times.filter_map(|time| Some((time, course.about(time)?))).collect();
    // Neighbouring windows share what they have seen.
    let independent = moved.len() as f64 * (every / (2.0 * WINDOW)).min(1.0);
    let alike = |delay: f64| {
        let mut pairs = [Vec::new(), Vec::new()];
        for (time, of) in &moved {
            let Some(truth) = about(path, time - delay) else { continue };
            for i in 0..2 {
                pairs[i].extend(of[i].zip(truth[i]).map(|(a, b)| [a, b]));
            }
        }
        let [speed, turn] = pairs.map(|pairs| together(&pairs));
        [speed.max(0.0), turn]
    };
    let cost = |of: [f64; 2]| of.iter().map(|r| libm::log((1.0 - r * r).max(1e-6))).sum::<f64>();
    let steps = libm::floor(most / STEP) as i32;
    let tried = |i: i32| STEP * f64::from(i);
    let (best, least) = (-steps..=steps).map(|i| (i, cost(alike(tried(i))))).min_by(|a, b| a.1.total_cmp(&b.1))?;
    let of = alike(tried(best));
    if of[0] < ALIKE && of[1].abs() < ALIKE {
        return None;
    }
    let told = best.abs() < steps && independent / 2.0 * (cost(alike(0.0)) - least) > TOLD;
    Some(Lag { delay: told.then(|| tried(best)), opposite: of[1] < -ALIKE })
}
