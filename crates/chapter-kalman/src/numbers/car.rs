//! Numbers of the car's log: the replays that the text goes through.

use estimate::{Code, Error};
use lab::{Lab, Listing};
use labs::{CarFixes, CarFrame, CarLog, CarParams, LoggedDrive, TUNNEL};
use std::sync::Arc;

/// The log, as the figure fetches it.
const CAR: &str = include_str!("../../../../content/logs/car.csv");
/// The likeliest delay is looked for in these steps of the slider, seconds: first, last, step.
const LOOKED: [i32; 3] = [40, 80, 2];
const CENTI: f64 = 0.01;

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let log = robot_log::parse(CAR).map_err(|e| Error::new(Code::Type, "car.csv", e.to_string()))?;
    let logged = Arc::new(LoggedDrive::new(log.drive));
    let lab = |params| CarLog::start(Arc::clone(&logged), params);
    let frame = |params| Ok::<CarFrame, Error>(lab(params)?.frame());
    let open = CarParams::default();
    let [first, last] = logged.span();
    let (second, all) = (frame(open)?, frame(CarParams { fixes: CarFixes::All, ..open })?);
    let known = |value: Option<f64>| value.unwrap_or(f64::NAN);
    to.by("labs::CarLog::frame", None)
        .add("car.minutes", (last - first) / 60.0, "how long the drive took")
        .add("car.sigma", 1.0, "standard deviation of a fix, as the filter is told, m")
        .add("car.alone", second.reckoned_off, "how far speed and turn alone are off a fix at worst, m")
        .add("car.all.nis", known(all.nis), "the NIS with all fixes")
        .add("car.second.nis", known(second.nis), "the NIS with one fix a second");
    let start = lab(open)?;
    let (mut best, mut top) = (0.0, f64::NEG_INFINITY);
    let [from, until, step] = LOOKED;
    for centi in (from..=until).step_by(step as usize) {
        let delay = f64::from(centi) * CENTI;
        let likelihood = start.likelihood(delay)?;
        if likelihood > top {
            (best, top) = (delay, likelihood);
        }
    }
    to.by("labs::CarLog::likelihood", None)
        .add("car.delay", best, "the delay of the speed under which the fixes are likeliest, s")
        .add("car.gain", top - known(second.log_likelihood), "by how much the log-likelihood rises to there");
    let late = CarParams { delay: best, ..open };
    let both = lab(CarParams { learn: true, ..late })?;
    let learned = both.frame();
    let tunnel = frame(CarParams { tunnel: true, ..open })?;
    let gated = [
        ("car.gate", frame(CarParams { learn: true, gate: true, ..late })?),
        ("car.gate.open", frame(CarParams { gate: true, ..open })?),
    ];
    to.by("labs::CarLog::summary", None)
        .add("car.learned.lag1", known(both.summary()?.lag1), "the innovations at lag 1 with both right")
        .by("labs::CarLog::frame", None)
        .add("car.late.nis", known(frame(late)?.nis), "the NIS with the delay right")
        .add("car.learned.nis", known(learned.nis), "and with the scale learned too")
        .add("car.kappa", known(learned.learned.map(|it| it.speed_scale)), "the learned scale of the speed")
        .add("car.tunnel.seconds", TUNNEL[1] - TUNNEL[0], "how long fixes are withheld, s")
        .add("car.tunnel.worst", known(tunnel.tunnel.map(|it| it.worst)), "the filter's worst distance there, m")
        .add("car.tunnel.smoothed", known(tunnel.tunnel.and_then(|it| it.worst_smoothed)), "the smoother's, m");
    for (id, gated) in gated {
        to.add(format!("{id}.refused"), f64::from(gated.refusals), "fixes beyond the gate")
            .add(format!("{id}.of"), f64::from(gated.used + gated.refusals), "of so many")
            .add(format!("{id}.nis"), known(gated.nis), "the NIS of the others");
    }
    Ok(())
}
