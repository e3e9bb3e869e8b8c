//! The odometry hook: a loop of the corridor on encoders, with a wheel that is not as large as the software believes.
//!
//! Truth keeps to the loop; the estimate follows the encoders, and its claimed covariance knows of the slip and not of
//! the bias, unless the bias is a fourth state. Landmark fixes, when they are on, are one range and bearing of each
//! mapped corner as it comes within reach.

mod drive;
pub(crate) mod frame;
mod learning;
mod params;

pub use drive::Drive;
pub use frame::{
    CornerSighting, HookFrame, HookSeries, LastSighting, PoseBelief, Quality, Ratio, Spread, Stop, WheelBelief, World,
};
pub use params::HookParams;

use estimate::Error;
use frame::HookRecord;
use lab::{Digest, Lab, named};
use sim::scenarios::HOOK;

/// The lab.
#[derive(Clone, Debug)]
pub struct OdometryHook {
    drive: Drive,
    record: HookRecord,
    digest: Digest,
}

impl Lab for OdometryHook {
    named! {
        "odometry-hook", HookParams, HookFrame, &[frame::INTERFACES],
        "A loop of the corridor on encoders with a biased wheel, with or without fixes from the mapped corners."
    }
    type World = ();

    fn start((): (), params: HookParams) -> Result<Self, Error> {
        let mut lab = Self { drive: Drive::new(params)?, record: HookRecord::default(), digest: Digest::default() };
        lab.note();
        Ok(lab)
    }

    fn world(&self) {}

    fn params(&self) -> &HookParams {
        &self.drive.params
    }

    fn steps(&self) -> u32 {
        self.drive.step
    }

    fn tried() -> Vec<Self::Params> {
        let open = HookParams::default();
        let fixes = HookParams { fixes: true, ..open };
        vec![open, fixes, HookParams { learn: true, ..fixes }]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.drive.advance()?;
        self.note();
        Ok(())
    }

    fn frame(&self) -> HookFrame {
        let drive = &self.drive;
        let (error, sigma) = drive.quality();
        let belief = PoseBelief::from(&drive.belief());
        HookFrame {
            step: drive.step,
            time: f64::from(drive.step) * HOOK.period,
            lap: drive.step / HOOK.course.lap(),
            params: drive.params,
            world: World::of(&drive.home),
            truth: drive.truth().to_vector().into(),
            estimate: belief.x,
            p: belief.p,
            ellipse: belief.ellipse,
            predicted: (&drive.predicted).into(),
            u: drive.u.map(Into::into),
            sightings: drive.seen.clone(),
            last_sighting: drive.last,
            error,
            sigma,
            ratio: error.over(sigma),
            wheel: drive.wheel(),
            tracks: self.record.tracks.outlined(),
            trail: self.record.trail.clone(),
            series: self.record.series.clone(),
        }
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }
}

impl OdometryHook {
    fn note(&mut self) {
        let drive = &self.drive;
        let belief = drive.belief();
        self.record.take(drive.step, drive.truth(), &belief, drive.quality(), drive.wheel());
        self.digest.take(drive.truth().to_vector().as_slice());
        for seen in &drive.seen {
            self.digest.take(&[seen.range, seen.bearing]);
        }
        for belief in [&drive.predicted, &belief] {
            self.digest.take(belief.x.as_slice());
            self.digest.take(belief.p.as_slice());
        }
        if let Some(wheel) = drive.wheel() {
            self.digest.take(&[wheel.epsilon, wheel.sigma]);
        }
    }
}

#[cfg(test)]
mod tests;
