//! Checks 9 and 10: what can be known of a pose.

use crate::givens::Givens;
use estimate::Error;
use estimate::Landmark;
use estimate::localizer::SensorKind;
use geom::SE2;
use lab::Check;
use labs::observability_probe::{Moment, ProbeRanks, frozen_ranks, stacked_ranks};
use labs::true_path::after;
use nalgebra::Vector2;
use sim::paths::{Rectangle, Tick};

/// The relative tolerance of the checks' ranks: far above rounding, far below every singular value that is not zero.
const TOLERANCE: f64 = 1e-9;
/// Ticks before and after the pose at which a case is frozen.
const AROUND: u32 = 8;

/// One of the five cases of check 9: the ranks frozen at a pose, and along the path through it.
pub(crate) struct Case {
    /// What it is.
    pub about: &'static str,
    pub frozen: ProbeRanks,
    pub path: ProbeRanks,
}

/// Check 9's cases, on the true path of the Probe.
///
/// The fourth has its landmarks on a line through the robot's place in the middle of its first side, which it crosses.
pub(crate) fn five_cases(givens: &Givens) -> Result<Vec<Case>, Error> {
    let probe = &givens.probe;
    let [first, second, _] = probe.landmarks;
    let middle = probe.course.ticks[0] / 2;
    let crossing = probe.course.poses().nth(middle as usize).unwrap_or(probe.course.start());
    // Halfway from the robot to the first landmark.
    let between = Landmark { id: 9, x: 0.5 * (crossing.x() + first.x), y: 0.5 * (crossing.y() + first.y) };
    let case = |about, landmarks: &[Landmark], sight, moving| -> Result<Case, Error> {
        let drive = moments(&probe.course, middle, landmarks, moving);
        let frozen = frozen_ranks(&drive[AROUND as usize], sight, false, TOLERANCE)?;
        Ok(Case { about, frozen, path: stacked_ranks(drive.iter(), sight, false, TOLERANCE)? })
    };
    Ok(vec![
        case("one range-only landmark", &[first], SensorKind::Range, true)?,
        case("two range-only landmarks", &[first, second], SensorKind::Range, true)?,
        case("one range–bearing landmark, moving", &[first], SensorKind::RangeBearing, true)?,
        case("two range-only landmarks whose line the robot crosses", &[first, between], SensorKind::Range, true)?,
        case("one range–bearing landmark, stopped", &[first], SensorKind::RangeBearing, false)?,
    ])
}

/// The moments of a course about tick `middle`; stopped, the robot stays where it is then.
fn moments(course: &Rectangle, middle: u32, landmarks: &[Landmark], moving: bool) -> Vec<Moment> {
    let poses: Vec<SE2> = course.poses().take((middle + AROUND + 1) as usize).collect();
    let moment = |k: u32| {
        let (at, tick) = if moving { (k, course.tick(k)) } else { (middle, Tick { ds: 0.0, dtheta: 0.0 }) };
        Moment { pose: poses[at as usize], landmarks: landmarks.into(), u: Vector2::new(tick.ds, tick.dtheta) }
    };
    (middle - AROUND..=middle + AROUND).map(moment).collect()
}

/// Check 9: the frozen ranks, and beside them what the path really shows.
pub(super) fn observability_ranks(givens: &Givens) -> Result<Check, Error> {
    let cases = five_cases(givens)?;
    let of = |rank: fn(&Case) -> usize| cases.iter().map(move |c| rank(c) as f64);
    let actual: Vec<f64> = of(|c| c.frozen.rank).chain(of(|c| c.path.rank)).collect();
    let expected = vec![2.0, 3.0, 3.0, 2.0, 2.0, 2.0, 3.0, 2.0, 3.0, 2.0];
    Ok(Check::new(9, "Five linearized ranks, frozen; the same five along the path", expected, actual, 0.0))
}

/// Check 10: the pose trace after two laps with one range-only landmark and with two, Jacobians on the true path.
pub(super) fn traces(givens: &Givens) -> Result<Check, Error> {
    let trace = |n| after(&givens.probe, n, SensorKind::Range, givens.probe.steps).map(|path| path.trace());
    let title = "The pose trace after 240 steps, with one landmark and with two";
    Ok(Check::new(10, title, vec![0.48232, 0.03402], vec![trace(1)?, trace(2)?], 5e-6))
}
