//! Whether a truth has a frame or a clock of its own, which the fixes and the motion tell.
//!
//! The rule. One explanation beats another if it lowers the mean square distance of the fixes from the truth by a third
//! or more, and by more than 25 times what chance lowers it for each number that is fitted besides (an F-test, in which
//! fixes whose errors go together count as fewer, and few have to tell more). Fixes beyond four times the
//! median distance are set aside.
//!
//! - A frame is another one if a turn and a shift beat the truth as it is, and beat what a shift in time alone does:
//!   late fixes are a fault of their own.
//! - A clock is another one only if the motion agrees, whose speeds and turns are the same in every frame.
//! - A mirror is of the truth only if its turns are opposite to the motion's.
//! - A truth that fits only when it is stretched is in another unit, and nothing is asked.

use crate::alignment::{Fix, Path, Rigid, Sums, fixes};
use crate::lag::{Lag, lag};
use estimate::drive::{Drive, Pose, Row, Truth};

/// A truth's stamps are shifted by no more than this, s, and by no more than this part of it.
const MOST_DELAY: f64 = 5.0;
const PART: f64 = 1.0 / 6.0;
/// How finely shifts in time are tried, s, first and then.
const STEPS: [f64; 2] = [0.1, 0.01];
/// The fewest fixes, and the fewest numbers that they leave free where their errors go together.
const FEWEST: usize = 20;
const FEWEST_FREE: f64 = 5.0;
/// So many times more than chance, and by this part, an explanation is better; where so few numbers are free, chance
/// does more.
const CHANCE: f64 = 25.0;
const FEW: f64 = 20.0;
const BETTER: f64 = 1.0 / 3.0;
/// Distances below this, m, are rounding of the files.
const ROUNDING: f64 = 1e-3;
/// A fix is set aside that is farther than so many median distances, where no more than a fifth are.
const ASIDE: f64 = 4.0;
const MOST_ASIDE: f64 = 0.2;
/// A turn of less than so many of its own standard deviations is none.
const TURNED: f64 = 4.0;
/// The fixes' shift in time and the motion's are one if they differ by less, s, or by less than this part.
const ONE: [f64; 2] = [0.1, 0.2];

/// The motion and the shift in time that bring a truth onto the fixes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Own {
    /// How its places are moved; `None` where its frame is that of the fixes.
    pub frame: Option<Rigid>,
    /// How far its stamps are shifted, s; 0 where its clock is that of the others.
    pub delay: f64,
    /// The standard deviations of the turn, rad, of the shift in the truth's middle, m, and of the delay, s.
    pub sigmas: [f64; 3],
    /// The root of the mean square distance from the fixes before and after, m.
    pub distances: [f64; 2],
}

impl Own {
    /// The truth moved and shifted.
    pub(crate) fn truth(&self, truth: &Truth) -> Truth {
        let moved = |pose: &Pose| {
            let pose = Pose { time: pose.time + self.delay, ..*pose };
            self.frame.map_or(pose, |frame| frame.pose(pose))
        };
        Truth::new(truth.poses().iter().map(moved).collect())
    }
}

/// One shift in time, and how near the truth then comes to the fixes.
#[derive(Clone, Copy, Debug)]
struct Tried {
    delay: f64,
    sums: Sums,
}

/// The fixes of a log beside its truth.
struct Beside<'a> {
    fixes: Vec<Fix>,
    path: Path<'a>,
    most: f64,
}

impl<'a> Beside<'a> {
    /// `None` where the fixes are few.
    fn new(rows: &[Row], truth: &'a Truth) -> Option<Self> {
        let path = Path::new(truth)?;
        let [from, to] = path.span();
        let known = fixes(rows, [from, to]);
        let shared = known.last()?.time - known.first()?.time;
        let most = MOST_DELAY.min(PART * shared);
        // The truth reaches every fix by whatever it is shifted, so that all are compared on the same ones.
        let beside = Self { fixes: fixes(rows, [from + most, to - most]), path, most };
        (beside.fixes.len() >= FEWEST).then_some(beside)
    }

    fn at(&self, delay: f64) -> Option<Tried> {
        Some(Tried { delay, sums: Sums::new(&self.fixes, &self.path, delay)? })
    }

    /// The shift in time by which a distance becomes least.
    fn nearest(&self, distance: impl Fn(&Sums) -> f64) -> Option<Tried> {
        let among = |middle: f64, step: f64, reach: f64| {
            let steps = libm::round(reach / step) as i32;
            let all = (-steps..=steps).filter_map(|i| self.at(middle + step * f64::from(i)));
            all.filter(|it| it.delay.abs() <= self.most + 1e-9)
                .min_by(|a, b| distance(&a.sums).total_cmp(&distance(&b.sums)))
        };
        let coarse = among(0.0, STEPS[0], self.most)?;
        let fine = among(coarse.delay, STEPS[1], STEPS[0])?;
        // A parabola through the neighbours has its bottom between the steps.
        let near = [-1.0, 0.0, 1.0].map(|side| self.at(fine.delay + side * STEPS[1]).map(|it| distance(&it.sums)));
        let [Some(a), Some(b), Some(c)] = near else { return Some(fine) };
        let bend = a + c - 2.0 * b;
        let off = if bend > 0.0 { ((a - c) / (2.0 * bend)).clamp(-0.5, 0.5) } else { 0.0 };
        self.at(fine.delay + off * STEPS[1])
    }

    /// What is left between each fix and the truth that is shifted in time and moved.
    fn left(&self, delay: f64, by: Rigid) -> Vec<(Fix, [f64; 2])> {
        let apart = |fix: &Fix| {
            let at = by.place(self.path.at(fix.time - delay)?);
            Some((*fix, [fix.at[0] - at[0], fix.at[1] - at[1]]))
        };
        self.fixes.iter().filter_map(apart).collect()
    }

    /// What is told of the truth, and how surely: `at` is how late the fixes are against it, `delay` what of that is
    /// its clock; in a frame of its own its hand is another one or not.
    fn told(&self, at: Tried, hand: Option<bool>, delay: f64, free: f64) -> Own {
        let distance = |sums: &Sums| hand.map_or(sums.same, |mirrored| sums.rigid(mirrored));
        let least = distance(&at.sums);
        let variance = (least + ROUNDING * ROUNDING) / free;
        let turn_sigma = libm::sqrt(variance / at.sums.spread());
        let beside = [-1.0, 1.0].map(|side| self.at(at.delay + side * STEPS[0]).map_or(0.0, |it| distance(&it.sums)));
        let bend = (beside[0] + beside[1] - 2.0 * least) / (2.0 * STEPS[0] * STEPS[0]);
        let turns = |mirrored| mirrored || at.sums.motion(false, true).turn.abs() > TURNED * turn_sigma;
        let after = if hand.is_some_and(|hand| !turns(hand)) { at.sums.shifted() } else { least };
        Own {
            frame: hand.map(|mirrored| at.sums.motion(mirrored, turns(mirrored))),
            delay,
            sigmas: [turn_sigma, libm::sqrt(variance), libm::sqrt(variance / bend.max(f64::MIN_POSITIVE))],
            distances: [self.at(0.0).map_or(f64::NAN, |it| it.sums.same), after].map(libm::sqrt),
        }
    }

    /// Sets the fixes aside that lie far away from a truth that is moved so; not if these are many.
    fn without_far(&mut self, delay: f64, by: Rigid) {
        let left = self.left(delay, by);
        let far = |of: [f64; 2]| libm::hypot(of[0], of[1]);
        let mut distances: Vec<f64> = left.iter().map(|(_, of)| far(*of)).collect();
        distances.sort_unstable_by(f64::total_cmp);
        let Some(median) = distances.get(distances.len() / 2) else { return };
        let kept: Vec<Fix> = left.iter().filter(|(_, of)| far(*of) <= ASIDE * median).map(|(fix, _)| *fix).collect();
        if kept.len() as f64 >= (1.0 - MOST_ASIDE) * left.len() as f64 {
            self.fixes = kept;
        }
    }
}

/// How many numbers are left free by residuals that go together from fix to fix: twice the fixes, by the time over
/// which their errors are correlated.
fn free(left: &[(Fix, [f64; 2])]) -> f64 {
    let product = |i: usize, j: usize| left[i].1[0] * left[j].1[0] + left[i].1[1] * left[j].1[1];
    let square = (0..left.len()).map(|i| product(i, i)).sum::<f64>();
    let mut time = 1.0;
    for lag in 1..left.len() / 2 {
        let together = (lag..left.len()).map(|i| product(i, i - lag)).sum::<f64>() / square;
        if together.is_nan() || together < 0.05 {
            break;
        }
        time += 2.0 * together;
    }
    2.0 * left.len() as f64 / time
}

/// The frame and the clock of the truth's own, where the log's fixes and motion tell one.
pub(crate) fn own(drive: &Drive, framed: bool) -> Option<Own> {
    let mut beside = Beside::new(&drive.rows, &drive.truth)?;
    let moved = |mirrored: bool| move |sums: &Sums| if framed { sums.rigid(mirrored) } else { sums.same };
    let hand = |beside: &Beside<'_>| {
        let [plain, mirror] = [beside.nearest(moved(false))?, beside.nearest(moved(true))?];
        let mirrored = framed && mirror.sums.rigid(true) < (1.0 - BETTER) * plain.sums.rigid(false);
        Some((if mirrored { mirror } else { plain }, mirrored))
    };
    let by = |it: &Tried, mirrored: bool| match framed {
        true => it.sums.motion(mirrored, true),
        false => Rigid { mirrored: false, turn: 0.0, shift: [0.0; 2] },
    };
    let (first, mirrored) = hand(&beside)?;
    beside.without_far(first.delay, by(&first, mirrored));
    let (full, mirrored) = hand(&beside)?;
    let rest = moved(mirrored);
    let free = free(&beside.left(full.delay, by(&full, mirrored)));
    if beside.fixes.len() < FEWEST || free < FEWEST_FREE {
        return None;
    }
    let chance = CHANCE * (1.0 + (FEW / free) * (FEW / free));
    let beats = |this: f64, other: f64, numbers: f64| {
        let lower = other - this;
        lower > BETTER * other && lower * free / numbers > chance * (this + ROUNDING * ROUNDING)
    };
    let (as_is, late) = (beside.at(0.0)?, beside.nearest(|sums| sums.same)?);
    if !beats(rest(&full.sums), as_is.sums.same, if framed { 4.0 } else { 1.0 }) {
        return None;
    }
    let by_motion = lag(drive, &beside.path, beside.most);
    if mirrored && !by_motion.is_some_and(|lag| lag.opposite) {
        return None;
    }
    let clock = |it: &Tried| clock_is_own(by_motion, it.delay);
    let unmoved = beside.at(0.0).filter(|it| !beats(rest(&full.sums), rest(&it.sums), 1.0));
    let frame = framed && beats(rest(&full.sums), late.sums.same, 3.0);
    let (at, delay) = match frame {
        // Late fixes move a truth along its way: it is compared as late as they are, however little that is.
        true => (full, if unmoved.is_none() && clock(&full) { full.delay } else { 0.0 }),
        false if clock(&late) && beats(late.sums.same, as_is.sums.same, 1.0) => (late, late.delay),
        false => return None,
    };
    if frame && beats(at.sums.stretched(mirrored), rest(&at.sums), 1.0) {
        return None;
    }
    Some(beside.told(at, frame.then_some(mirrored), delay, free))
}

/// The shift, m, that brings a truth onto fixes, as late as they are, and its standard deviation; `None` where they are
/// few.
pub(crate) fn shift(rows: &[Row], truth: &Truth) -> Option<([f64; 2], f64)> {
    let mut beside = Beside::new(rows, truth)?;
    let nearest = |beside: &Beside<'_>| beside.nearest(Sums::shifted);
    let first = nearest(&beside)?;
    beside.without_far(first.delay, first.sums.motion(false, false));
    let found = nearest(&beside)?;
    let by = found.sums.motion(false, false);
    let free = free(&beside.left(found.delay, by));
    (free >= FEWEST_FREE).then(|| (by.shift, libm::sqrt((found.sums.shifted() + ROUNDING * ROUNDING) / free)))
}

/// Whether the motion finds the same shift in time as the fixes.
fn clock_is_own(lag: Option<Lag>, delay: f64) -> bool {
    let by_motion = lag.and_then(|lag| lag.delay);
    by_motion.is_some_and(|of| (of - delay).abs() <= ONE[0].max(ONE[1] * of.abs()))
}
