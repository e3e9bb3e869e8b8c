//! A real car: its log replayed with speeds, turn rates and position fixes at the times at which each was measured.

pub(crate) mod frame;
mod params;

pub use frame::{CarFrame, CarLearned, CarPlaces, CarTunnel};
pub use params::{CarFixes, CarParams};

use crate::LoggedDrive;
use estimate::Error;
use estimate::drive::{BySensor, Course, Delays, Drive, Event, Motion, Replay, Settings, Smoothed, Summary};
use lab::series::Track;
use lab::{Digest, Lab, Params, named};
use numerics::hypot;
use std::sync::Arc;

/// A gate that a right fix is beyond once in a thousand.
const GATE: f64 = 0.999;
/// Fixes are withheld in the tunnel between these times, seconds.
pub const TUNNEL: [f64; 2] = [100.0, 130.0];
/// A track has a position for so many rows of motion.
const STRIDE: usize = 20;

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct CarLog {
    logged: Arc<LoggedDrive>,
    params: CarParams,
    frame: CarFrame,
    digest: Digest,
    step: u32,
}

/// What the log's filter is told, of a log by distances too, which have no delay and nothing to be learned of speeds.
fn settings(params: &CarParams, motion: Motion) -> Settings {
    let held = !motion.is_odometry();
    let gate = BySensor { fix: params.gate.then_some(GATE), ..BySensor::all(None) };
    let every = BySensor { fix: if params.fixes == CarFixes::Second { 1.0 } else { 0.0 }, ..BySensor::all(0.0) };
    Settings {
        sigma_distance: 0.3,
        sigma_turn: 0.03,
        sigma_fix: 1.0,
        start_sigma: 1.0,
        start_sigma_heading: 0.1,
        gate,
        every,
        fixes: params.fixes != CarFixes::None,
        delays: Delays { speed: if held { params.delay } else { 0.0 }, ..Delays::default() },
        learn_speed: held && params.learn,
        learn_bias: held && params.learn,
        withheld: params.tunnel.then_some(TUNNEL),
        ..Settings::default()
    }
}

impl Lab for CarLog {
    named! {
        "car-log", CarParams, CarFrame, &[frame::INTERFACES],
        "A car in a town: its log of speeds, turn rates and position fixes, replayed with each at its own time."
    }
    type World = Arc<LoggedDrive>;

    fn start(logged: Arc<LoggedDrive>, params: CarParams) -> Result<Self, Error> {
        params.check()?;
        let mut digest = Digest::default();
        let frame = replayed(logged.drive(), params, &mut digest)?;
        Ok(Self { logged, params, frame, digest, step: 0 })
    }

    fn world(&self) -> Arc<LoggedDrive> {
        Arc::clone(&self.logged)
    }

    fn params(&self) -> &CarParams {
        &self.params
    }

    fn steps(&self) -> u32 {
        self.step
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    fn set(&mut self, params: CarParams) -> Result<(), Error> {
        *self = Self { step: self.step, ..Self::start(self.world(), params)? };
        Ok(())
    }

    fn frame(&self) -> CarFrame {
        self.frame.clone()
    }
}

impl CarLog {
    /// The log-likelihood of the fixes with another delay of the speed, all else as it is.
    ///
    /// # Errors
    /// A limit that names `delay`; whatever the core answers.
    pub fn likelihood(&self, delay: f64) -> Result<f64, Error> {
        let params = CarParams { delay, ..self.params };
        params.check()?;
        let drive = self.logged.drive();
        let course = Course::new(drive, settings(&params, drive.motion))?;
        let mut replay = Replay::new(&course);
        while replay.take(drive, &course)?.is_some() {}
        Ok(replay.summary(&course).log_likelihood.unwrap_or(0.0))
    }

    /// What the replay says of itself.
    ///
    /// # Errors
    /// Whatever the core answers.
    pub fn summary(&self) -> Result<Summary, Error> {
        let drive = self.logged.drive();
        let course = Course::new(drive, settings(&self.params, drive.motion))?;
        let mut replay = Replay::new(&course);
        while replay.take(drive, &course)?.is_some() {}
        let summary = replay.summary(&course);
        if !self.params.tunnel {
            return Ok(summary);
        }
        Ok(Smoothed::new(drive, &course, &replay, STRIDE)?.told(summary))
    }
}

fn replayed(drive: &Drive, params: CarParams, digest: &mut Digest) -> Result<CarFrame, Error> {
    let told = settings(&params, drive.motion);
    let (course, reckoned) = (Course::new(drive, told)?, Course::new(drive, told.reckoning())?);
    let (mut replay, mut reckoning) = (Replay::new(&course), Replay::new(&reckoned));
    let first = drive.span().unwrap_or_default()[0];
    let (mut tracks, mut motions) = ([Track::default(), Track::default()], 0);
    let [mut used, mut refused, mut withheld] = [(); 3].map(|()| CarPlaces::default());
    let (mut times, mut along, mut off) = (Vec::new(), Vec::new(), 0.0_f64);
    while let Some(taken) = replay.take(drive, &course)? {
        reckoning.take(drive, &reckoned)?;
        let (pose, alone) = (replay.pose(), reckoning.pose());
        digest.take(&[pose.x(), pose.y(), pose.theta()]);
        match drive.rows[taken.row].event {
            Event::Position { x, y, .. } => {
                off = off.max(hypot(alone.x() - x, alone.y() - y));
                let to = match (&taken.judged, taken.withheld) {
                    (Some(judged), _) if judged.used => &mut used,
                    (Some(_), _) => &mut refused,
                    (None, Some(_)) => &mut withheld,
                    (None, None) => continue,
                };
                to.x.push(x);
                to.y.push(y);
                if let Some([ahead, _]) = taken.judged.and_then(|judged| judged.along) {
                    times.push(taken.time - first);
                    along.push(ahead);
                }
            }
            event if event.is_motion() => {
                if motions % STRIDE == 0 {
                    for (track, pose) in tracks.iter_mut().zip([pose, alone]) {
                        track.push(pose.x(), pose.y(), usize::MAX);
                    }
                }
                motions += 1;
            }
            _ => {}
        }
    }
    let mut summary = replay.summary(&course);
    let mut smoothed = Track::default();
    if params.tunnel {
        let later = Smoothed::new(drive, &course, &replay, STRIDE)?;
        for one in &later.track {
            digest.take(&[one.pose.x(), one.pose.y()]);
            smoothed.push(one.pose.x(), one.pose.y(), usize::MAX);
        }
        summary = later.told(summary);
    }
    let [estimate, reckoning] = tracks.map(|track| track.outlined());
    let tunnel = summary.withheld.and_then(|told| {
        Some(CarTunnel {
            rows: told.rows,
            rms: told.rms?,
            worst: told.worst?,
            rms_smoothed: told.rms_smoothed,
            worst_smoothed: told.worst_smoothed,
        })
    });
    let learned = summary.speed_scale.zip(summary.turn_bias).filter(|_| params.learn && told.learn_speed);
    Ok(CarFrame {
        params,
        estimate,
        reckoning,
        smoothed: smoothed.outlined(),
        fixes: used.thinned(),
        refused: refused.thinned(),
        withheld: withheld.thinned(),
        time: thinned(&times),
        along: thinned(&along),
        reckoned_off: off,
        used: summary.used,
        refusals: summary.refused,
        nis: summary.nis,
        lag1: summary.sensors.fix.and_then(|fix| fix.lag1),
        log_likelihood: summary.log_likelihood,
        learned: learned.map(|(speed_scale, turn_bias)| CarLearned {
            speed_scale,
            speed_scale_sigma: summary.speed_scale_sigma.unwrap_or(0.0),
            turn_bias,
            turn_bias_sigma: summary.turn_bias_sigma.unwrap_or(0.0),
        }),
        tunnel,
    })
}

/// At most so many fixes are drawn.
const MOST: usize = 250;

fn thinned(values: &[f64]) -> Vec<f64> {
    values.iter().step_by(values.len().div_ceil(MOST).max(1)).copied().collect()
}

impl CarPlaces {
    fn thinned(&self) -> Self {
        Self { x: thinned(&self.x), y: thinned(&self.y) }
    }
}

#[cfg(test)]
mod tests;
