//! The corridor's loop over many seeds.

use estimate::Error;
use lab::Lab;
use labs::ensemble::{Distribution, over_seeds};
use labs::{LoopClosure, LoopFrame, LoopParams};
use sim::scenarios::LOOP_CLOSURE;

/// The loop over the seeds: a lap each.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopEnsemble {
    /// The mean NEES of a run; 3 for a consistent filter.
    pub nees: Distribution,
    /// The error of the position at the end, metres.
    pub error: Distribution,
    /// What the filter claims of it, one sigma in a coordinate, metres.
    pub sigma: Distribution,
    /// The part of a run's steps whose NEES is above its 95 % band's upper end.
    pub above: Distribution,
    /// Runs with a landmark founded twice.
    pub with_ghosts: u32,
    /// Runs with a sighting matched to the wrong landmark.
    pub with_wrong: u32,
    /// The factor by which the step that closes the loop shrinks the mean standard deviation of the landmarks, in the
    /// runs where one did.
    pub shrinks: Distribution,
}

/// The loop with the chapter's thresholds, by the right filter or by the one that drops its cross-covariances.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn loops(correlated: bool, seeds: u32) -> Result<LoopEnsemble, Error> {
    let runs = over_seeds(seeds, |seed| {
        let mut lab = LoopClosure::new(LoopParams { correlated, seed, ..LoopParams::default() })?;
        lab.run(LOOP_CLOSURE.poses - 1)?;
        Ok(lab.frame())
    })?;
    let last = |series: &lab::Series| series.iter().last().unwrap_or(f64::NAN);
    let above = |frame: &LoopFrame| {
        let known: Vec<f64> = frame.series.nees.iter().filter(|nees| !nees.is_nan()).collect();
        known.iter().filter(|nees| **nees > frame.nees_band[1]).count() as f64 / known.len() as f64
    };
    Ok(LoopEnsemble {
        nees: Distribution::new(runs.iter().map(|frame| frame.mean_nees.unwrap_or(f64::NAN))),
        error: Distribution::new(runs.iter().map(|frame| last(&frame.series.error))),
        sigma: Distribution::new(runs.iter().map(|frame| last(&frame.series.sigma))),
        above: Distribution::new(runs.iter().map(above)),
        with_ghosts: runs.iter().map(|frame| u32::from(frame.map.spurious > 0)).sum(),
        with_wrong: runs.iter().map(|frame| u32::from(frame.map.wrong > 0)).sum(),
        shrinks: Distribution::new(runs.iter().filter_map(|frame| frame.closure.map(|c| c.before / c.after))),
    })
}
