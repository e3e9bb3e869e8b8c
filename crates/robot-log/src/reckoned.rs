//! What a robot has reckoned of its way, as poses from where it was switched on: from one to the next it has driven an
//! arc, and a pose that jumps is where the odometry began anew.

use crate::cells::Cells;
use crate::counter::{Jump, Jumps};
use crate::error::Error;
use crate::fields::Line;
use crate::file::File;
use crate::reading::LogReader;
use crate::role::Role;
use crate::unit::{self, QUATERNION};
use crate::{quaternion, row};
use core::f64::consts::TAU;
use estimate::drive::Event;

/// So many times faster than nearly all other steps, and than those beside it, no robot drives.
const ODD: f64 = 20.0;
/// A jump is longer than this, m, or turns by more than this, rad, and is sought among so many rows at least.
const LEAST: f64 = 0.5;
const LEAST_TURN: f64 = 0.3;
const FEWEST: usize = 8;

/// The way and the turn from one pose to the next, each x, y and heading.
pub(crate) fn step([x, y, from]: [f64; 3], [to_x, to_y, to]: [f64; 3]) -> Event {
    let (dx, dy, turn) = (to_x - x, to_y - y, libm::remainder(to - from, TAU));
    let (mean, half) = (from + turn / 2.0, turn / 2.0);
    // The chord along the mean heading, and the arc above it.
    let chord = dx * libm::cos(mean) + dy * libm::sin(mean);
    let arc = if half.abs() < 1e-6 { 1.0 } else { half / libm::sin(half) };
    Event::Odometry { distance: chord * arc, turn }
}

/// A pose: its line, its time, its x, y and heading; NaN of a heading that is missing.
type Pose = (u32, f64, [f64; 3]);

fn sorted(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut above: Vec<f64> = numbers.filter(|number| *number > 0.0).collect();
    above.sort_unstable_by(f64::total_cmp);
    above
}

/// The steps, by their lengths and their speeds, that no motion makes.
fn odd(lengths: &[f64], speeds: &[f64], least: f64) -> Vec<usize> {
    let usual = sorted(speeds.iter().copied());
    let Some(usual) = usual.get(usual.len() * 9 / 10) else { return Vec::new() };
    let is_odd = |i: &usize| {
        let beside = [i.checked_sub(1), Some(i + 1)].into_iter().flatten().filter_map(|at| speeds.get(at));
        lengths[*i] > least && beside.chain([usual]).all(|speed| speeds[*i] > ODD * speed)
    };
    (0..speeds.len()).filter(is_odd).collect()
}

/// Where no motion leads from one pose to the next, of poses in the order of their times.
fn jumps(poses: &[Pose]) -> Vec<Jump> {
    let times = sorted(poses.windows(2).map(|pair| pair[1].1 - pair[0].1));
    let Some(period) = times.get(times.len() / 2).copied().filter(|_| poses.len() >= FEWEST) else {
        return Vec::new();
    };
    let steps = |length: fn([f64; 3], [f64; 3]) -> f64, least: f64| {
        let lengths: Vec<f64> = poses.windows(2).map(|pair| length(pair[0].2, pair[1].2)).collect();
        // Times that jitter make no step faster than the usual time does.
        let time = |pair: &[Pose]| (pair[1].1 - pair[0].1).max(period);
        let speeds: Vec<f64> = poses.windows(2).zip(&lengths).map(|(pair, length)| length / time(pair)).collect();
        odd(&lengths, &speeds, least)
    };
    let mut all = steps(|[x, y, _], [to_x, to_y, _]| libm::hypot(to_x - x, to_y - y), LEAST);
    all.extend(steps(|[.., from], [.., to]| libm::remainder(to - from, TAU).abs(), LEAST_TURN));
    all.sort_unstable();
    all.dedup();
    all.into_iter().map(|i| Jump { line: poses[i + 1].0, side: 0, from: 0.0, to: 0.0, gap: None }).collect()
}

impl File {
    /// Where its poses jump, if it has reckoned ones.
    pub(crate) fn pose_jumps(&self) -> Jumps {
        let source = &self.source;
        let at = |value| Some((source.column(value)?, source.units[source.role.index(value)?]?));
        let (Some(table), Some(time), Some(x), Some(y)) = (&source.table, source.column("time"), at("x"), at("y"))
        else {
            return Jumps::default();
        };
        let number = |line: &Line<'_>, at: usize| row::number(line.fields.get(at)?.text).filter(|it| it.is_finite());
        let lines = self.lines(table).filter_map(Result::ok).filter(|line| source.is_read(line));
        let (mut rows, seconds) = (0.0, source.units[0].filter(|_| !source.is_date()));
        let turned = at("heading");
        let four = turned.filter(|(_, unit)| unit.name == QUATERNION);
        let four = four.and_then(|(at, _)| quaternion::columns(&source.names, at));
        let heading = |line: &Line<'_>| match four {
            Some([x, y, z, w]) => {
                let parts = [number(line, x)?, number(line, y)?, number(line, z)?, number(line, w)?];
                quaternion::heading(parts).ok().flatten()
            }
            None => turned.and_then(|(at, unit)| Some(unit::convert(unit, number(line, at)?))),
        };
        let poses = lines.filter_map(|line| {
            let [x, y] = [(number(&line, x.0)?, x.1), (number(&line, y.0)?, y.1)].map(|(it, u)| unit::convert(u, it));
            rows += 1.0;
            // Of dates the steps themselves are compared.
            let time = seconds.and_then(|unit| Some(unit::convert(unit, number(&line, time)?)));
            Some((line.number, time.unwrap_or(rows), [x, y, heading(&line).unwrap_or(f64::NAN)]))
        });
        Jumps { range: None, odd: jumps(&poses.collect::<Vec<_>>()) }
    }

    /// What is said of the poses that jump.
    pub(crate) fn pose_jumps_note(&self) -> Option<String> {
        let jumps = if self.role() == Role::Reckoned { self.pose_jumps().odd } else { Vec::new() };
        let (name, first) = (self.name(), jumps.first()?.line);
        let more = if jumps.len() > 1 { format!(" ({} more like it)", jumps.len() - 1) } else { String::new() };
        Some(format!(
            "{name}: the pose jumps at line {first}{more}, as where odometry begins anew: no way is taken from the row \
             before to that one."
        ))
    }
}

impl LogReader {
    /// Takes a row of a pose that the robot has reckoned.
    pub(crate) fn reckoned(&mut self, cells: Cells<'_>) -> Result<(), Error> {
        let (start, time, [x, y]) =
            (cells.start(), self.kept.stamps.take(cells)?, [cells.number("x")?, cells.number("y")?]);
        let missing = || cells.place("heading").refuse("the heading is missing beside x and y");
        let pose = [x, y, cells.given("heading")?.ok_or_else(missing)?];
        let before = self.kept.reckoned.replace(pose).filter(|_| !cells.jumps.begins_anew(start.line));
        self.driven(start, time, before.map(|before| step(before, pose)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI};

    fn assert_step(from: [f64; 3], to: [f64; 3], wanted: [f64; 2]) {
        let Event::Odometry { distance, turn } = step(from, to) else { panic!("no odometry") };
        assert!((distance - wanted[0]).abs() < 1e-12 && (turn - wanted[1]).abs() < 1e-12, "{distance}, {turn}");
    }

    #[test]
    fn a_step_is_the_arc_between_two_poses_with_its_sign() {
        // A quarter of a circle of 2 m about (0, 2).
        assert_step([0.0, 0.0, 0.0], [2.0, 2.0, FRAC_PI_2], [PI, FRAC_PI_2]);
        assert_step([2.0, 2.0, FRAC_PI_2], [0.0, 0.0, 0.0], [-PI, -FRAC_PI_2]);
        assert_step([1.0, 1.0, FRAC_PI_2], [1.0, 0.25, FRAC_PI_2], [-0.75, 0.0]);
        assert_step([0.0, 0.0, 3.0], [0.0, 0.0, -3.0], [0.0, TAU - 6.0]);
        // Westwards over ±180°, and a turn of the counter above it.
        let (to, half) = (-0.05 * libm::sin(0.1) / 0.1, 0.05);
        assert_step([0.0, 0.0, PI - 0.1], [2.0 * to, 0.0, 0.1 - PI], [2.0 * half, 0.2]);
    }

    #[test]
    fn a_pose_that_begins_anew_jumps_and_neither_a_gap_nor_a_start_does() {
        let of = |at: &dyn Fn(usize) -> Option<(f64, f64)>| {
            let pose = |i: usize| at(i).map(|(time, x)| (i as u32 + 2, time, [x, 0.0, 0.0]));
            jumps(&(0..100).filter_map(pose).collect::<Vec<_>>()).iter().map(|jump| jump.line).collect::<Vec<_>>()
        };
        let tenth = |i: usize| i as f64 / 10.0;
        assert_eq!(of(&|i| Some((tenth(i), tenth(i % 60)))), [62]);
        assert_eq!(of(&|i| Some((tenth(i), tenth(i % 30)))), [32, 62, 92]);
        assert_eq!(of(&|i| Some((tenth(i), tenth(i)))), [0; 0]);
        assert_eq!(of(&|i| (!(40..80).contains(&i)).then(|| (tenth(i), tenth(i)))), [0; 0], "a gap");
        assert_eq!(of(&|i| (i != 40).then(|| (tenth(i), tenth(i)))), [0; 0], "a lost row");
        assert_eq!(of(&|i| Some((tenth(i), (i as f64 - 95.0).max(1e-3 * i as f64)))), [0; 0], "it stood, and drives");
        // Set anew where it began, it turns back at once; and neither half a turn over ±180° nor a quick one does.
        let turned = |of: &dyn Fn(f64) -> f64| {
            let pose = |i: usize| (i as u32 + 2, tenth(i), [0.0, 0.0, of(tenth(i))]);
            jumps(&(0..100).map(pose).collect::<Vec<_>>()).iter().map(|jump| jump.line).collect::<Vec<_>>()
        };
        assert_eq!(turned(&|t| 0.2 * if t < 5.05 { t } else { t - 5.1 }), [53]);
        assert_eq!(turned(&|t| libm::remainder(t, TAU)), [0; 0]);
        assert_eq!(turned(&|t| 0.01 * t + (3.0 * (t - 5.0)).clamp(0.0, 1.5)), [0; 0]);
    }
}
