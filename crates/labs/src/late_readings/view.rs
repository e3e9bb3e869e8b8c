//! The frame of a run.

use super::follow::{Judged, first};
use super::plan::{CAMERA, ticks};
use super::{LateFrame, LateGap, LatePicked, LateReadings, LateSensor, Way, plan::seconds};
use sim::scenarios::THREE_SENSORS;

/// A curve has a point at every second tick.
const STRIDE: usize = 2;

pub(super) fn frame(lab: &LateReadings) -> LateFrame {
    let LateReadings { params, drive, plan, followed, smoothed, ways, .. } = lab;
    let shown = || (0..drive.states.len()).step_by(STRIDE);
    let over = |of: &dyn Fn(usize) -> f64| shown().map(of).collect::<Vec<f64>>();
    let error = |k: usize| followed.live[k].x[0] - drive.states[k][0];
    let later = || smoothed.iter().enumerate().skip(STRIDE - 1).step_by(STRIDE);
    let settled = || ticks(THREE_SENSORS.settled)..drive.states.len();
    let mean = |of: &dyn Fn(usize) -> f64| settled().map(of).sum::<f64>() / settled().len() as f64;
    LateFrame {
        params: *params,
        end: seconds(THREE_SENSORS.ticks),
        settled: THREE_SENSORS.settled,
        time: over(&seconds),
        error: over(&error),
        two_sigma: over(&|k| 2.0 * followed.live[k].p[(0, 0)].sqrt()),
        position: over(&|k| drive.states[k][0]),
        speed: over(&|k| drive.states[k][1]),
        smoothed: later().map(|(i, belief)| belief.x[0] - drive.states[i + 1][0]).collect(),
        smoothed_two_sigma: later().map(|(_, belief)| 2.0 * belief.p[(0, 0)].sqrt()).collect(),
        sensors: [0, 1, CAMERA].map(|sensor| of_sensor(lab, sensor)),
        picked: plan.picked.map(|picked| LatePicked {
            number: picked.number as u32,
            of: picked.of as u32,
            measured: seconds(picked.reading.measured),
            came: seconds(picked.reading.came),
            missing: picked.missing,
        }),
        ways: *ways,
        lag: mean(&|k| -error(k) * along(lab, k)),
        travelled: params.delay * mean(&|k| drive.states[k][1].abs()),
        gap: gap(lab),
    }
}

/// +1 where the robot drives forward at a tick, −1 where it drives back.
fn along(lab: &LateReadings, tick: usize) -> f64 {
    if lab.drive.states[tick][1] < 0.0 { -1.0 } else { 1.0 }
}

fn of_sensor(lab: &LateReadings, sensor: usize) -> LateSensor {
    let LateReadings { params, drive, plan, followed, .. } = lab;
    let came: Vec<_> = plan
        .readings
        .iter()
        .enumerate()
        .filter(|(_, one)| one.sensor == sensor && one.came <= THREE_SENSORS.ticks)
        .collect();
    let taken = |measured: usize, came: usize| if params.way == Way::AsNew { came } else { measured };
    let judged: Vec<&Judged> =
        followed.judged.iter().filter(|one| plan.readings[one.reading].sensor == sensor).collect();
    let counted: Vec<&&Judged> =
        judged.iter().filter(|one| plan.readings[one.reading].came >= ticks(THREE_SENSORS.settled)).collect();
    let mean = |of: &dyn Fn(&Judged) -> f64| {
        (!counted.is_empty()).then(|| counted.iter().map(|one| of(one)).sum::<f64>() / counted.len() as f64)
    };
    LateSensor {
        sigma: THREE_SENSORS.sigma[sensor],
        period: plan.periods[sensor].map_or(0.0, seconds),
        measured: came.iter().map(|(_, one)| seconds(one.measured)).collect(),
        came: came.iter().map(|(_, one)| seconds(one.came)).collect(),
        taken: came.iter().map(|(_, one)| seconds(taken(one.measured, one.came))).collect(),
        off: came
            .iter()
            .map(|(_, one)| drive.readings[one.measured][sensor] - drive.states[taken(one.measured, one.came)][0])
            .collect(),
        used: came.iter().map(|(i, _)| judged.iter().any(|one| one.reading == *i)).collect(),
        innovation: judged.iter().map(|one| one.innovation).collect(),
        innovation_sigma: judged.iter().map(|one| one.s.sqrt()).collect(),
        mean: mean(&|one| one.innovation * along(lab, plan.readings[one.reading].came)),
        nis: mean(&|one| one.innovation * one.innovation / one.s),
    }
}

fn gap(lab: &LateReadings) -> Option<LateGap> {
    let LateReadings { plan, followed, smoothed, .. } = lab;
    let [from, to] = plan.gap?;
    // What is known at the last tick before the gap, and at the last in it.
    let (before, after) = (from.saturating_sub(1), to - 1);
    let sigma = |k: usize| followed.live[k].p[(0, 0)].sqrt();
    let place = |k: usize| (k - before) as f64 / (to - before) as f64;
    let later = |k: usize| smoothed.get(k.max(1) - 1).map_or(f64::INFINITY, |belief| belief.p[(0, 0)].sqrt());
    let highest = |of: &dyn Fn(usize) -> f64| {
        (!smoothed.is_empty()).then(|| (from..to).fold(from, |best, k| if of(k) > of(best) { k } else { best }))
    };
    let (worst, helped) = (highest(&later), highest(&|k| sigma(k) - later(k)));
    Some(LateGap {
        from: seconds(from),
        to: seconds(to),
        sigma_before: if from == 0 { first().p[(0, 0)].sqrt() } else { sigma(before) },
        sigma_after: sigma(after),
        sigma_smoothed: worst.map(later),
        worst_place: worst.map(place),
        helped_place: helped.map(place),
    })
}
