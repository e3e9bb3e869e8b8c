//! Late readings: a robot on a rail with a fast and coarse sensor, a slow and fine one, and a fine one whose readings
//! come late; and three ways to take what comes late.

mod drive;
mod follow;
pub(crate) mod frame;
mod params;
mod plan;
mod view;

pub use frame::{LateCost, LateFrame, LateGap, LatePicked, LateSensor};
pub use params::{Course, LateParams, Way};

use crate::ensemble::SEEDS;
use drive::Drive;
use estimate::dynamic::Belief;
use estimate::{Code, Error};
use follow::{Followed, cost, follow, smoothed};
use lab::{Digest, Lab, Params, kept, named};
use plan::Plan;
use std::rc::Rc;

/// The numbers of a seed: RMS and NEES of each way.
pub const COSTS: usize = 2 * Way::ALL.len();

/// The lab. It has no steps: [`Lab::run`] counts them and changes nothing else.
#[derive(Clone, Debug)]
pub struct LateReadings {
    params: LateParams,
    drive: Rc<Drive>,
    plan: Plan,
    followed: Followed,
    smoothed: Vec<Belief>,
    ways: [LateCost; 3],
    digest: Digest,
    step: u32,
}

impl Lab for LateReadings {
    named! {
        "late-readings", LateParams, LateFrame, &[frame::INTERFACES],
        "A robot on a rail with three sensors, one of which is late, and three ways to take what comes late."
    }
    kept! {}

    fn start((): (), params: LateParams) -> Result<Self, Error> {
        params.check()?;
        Self::on(Rc::new(Drive::new(params.seed, params.course)?), params)
    }

    fn tried() -> Vec<Self::Params> {
        let open = LateParams::default();
        let gap = LateParams { gap: Some([8.0, 12.0]), smooth: true, course: Course::ToAndFro, ..open };
        vec![open, LateParams { way: Way::GoBack, own_delay: Some(3.0), ..open }, gap]
    }

    fn advance(&mut self) -> Result<(), Error> {
        self.step += 1;
        Ok(())
    }

    /// The drive is kept where the parameters leave it as it is.
    fn set(&mut self, params: LateParams) -> Result<(), Error> {
        params.check()?;
        let same = (params.seed, params.course) == (self.drive.seed, self.drive.course);
        let drive = if same { Rc::clone(&self.drive) } else { Rc::new(Drive::new(params.seed, params.course)?) };
        *self = Self { step: self.step, ..Self::on(drive, params)? };
        Ok(())
    }

    fn frame(&self) -> LateFrame {
        view::frame(self)
    }
}

impl LateReadings {
    fn on(drive: Rc<Drive>, params: LateParams) -> Result<Self, Error> {
        let plan = Plan::new(&params);
        let mut digest = Digest::default();
        for (state, readings) in drive.states.iter().zip(&drive.readings) {
            digest.take(state.as_slice());
            digest.take(readings);
        }
        let (mut chosen, mut ways) = (Followed::default(), Vec::new());
        for way in Way::ALL {
            let followed = follow(&drive, &plan, way)?;
            for belief in &followed.live {
                digest.take(belief.x.as_slice());
                digest.take(belief.p.as_slice());
            }
            followed.judged.iter().for_each(|one| digest.take(&[one.innovation, one.s]));
            ways.push(cost(&drive, &followed.live)?);
            if way == params.way {
                chosen = followed;
            }
        }
        let smoothed = if params.smooth { smoothed(&drive, &plan)? } else { Vec::new() };
        for belief in &smoothed {
            digest.take(belief.x.as_slice());
            digest.take(belief.p.as_slice());
        }
        let ways = [ways[0], ways[1], ways[2]];
        Ok(Self { params, drive, plan, followed: chosen, smoothed, ways, digest, step: 0 })
    }

    /// What each way costs over `count` seeds from `first` on, whatever the seed of the run: RMS and NEES as new,
    /// dropped, gone back, seed by seed.
    ///
    /// # Errors
    /// [`Code::Limit`] naming `count` beyond 500; whatever the filter answers.
    pub fn seeds(&self, first: u32, count: u32) -> Result<Vec<f64>, Error> {
        if count > SEEDS {
            return Err(Error::new(Code::Limit, "count", format!("is {count}; it must be at most {SEEDS}")));
        }
        let mut costs = Vec::with_capacity(COSTS * count as usize);
        for seed in 0..count {
            for LateCost { rms, nees } in self.costs(first.wrapping_add(seed))? {
                costs.extend([rms, nees]);
            }
        }
        Ok(costs)
    }

    /// What each way costs with another seed.
    ///
    /// # Errors
    /// Whatever the filter answers.
    pub fn costs(&self, seed: u32) -> Result<[LateCost; 3], Error> {
        let drive = Drive::new(seed, self.params.course)?;
        let mut costs = self.ways;
        for (way, into) in Way::ALL.into_iter().zip(&mut costs) {
            *into = cost(&drive, &follow(&drive, &self.plan, way)?.live)?;
        }
        Ok(costs)
    }
}

#[cfg(test)]
mod tests;
