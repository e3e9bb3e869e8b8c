//! Statistics over 500 seeds, beside which the chapter quotes single runs. They are computed natively only; in the page
//! a check is a single run.

mod fits;
mod loops;

use estimate::Error;
use estimate::localizer::SensorKind;
pub use fits::{FitEnsemble, fits};
use lab::Lab;
pub use labs::bug_museum::{FIGURES, Figures, PANELS, Sight, Symptoms, bands, diagnosed, museum_run, museum_runs};
pub use labs::ensemble::{Distribution, SEEDS, over_seeds};
use labs::mapping::chapter_run;
use labs::observability_probe::{ObservabilityProbe, ProbeParams};
pub use loops::{LoopEnsemble, loops};
use sim::scenarios::{PROBE, RANGE_BEARING_SLAM, RangeBearingSlam};

/// The Probe's run over the seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeEnsemble {
    /// The pose trace at the end, m² and rad² added.
    pub trace: Distribution,
    /// Its NEES.
    pub nees: Distribution,
}

/// The trace at the end and the mean NEES of one run of the Probe.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn probe_run(landmarks: u32, sensor: SensorKind, seed: u32) -> Result<(f64, f64), Error> {
    let mut probe = ObservabilityProbe::new(ProbeParams { count: landmarks, sensor, seed, ..Default::default() })?;
    probe.run(PROBE.steps)?;
    Ok((probe.last_trace(), probe.mean_nees().unwrap_or(f64::NAN)))
}

/// Range-only localization by the first `landmarks` of the Probe.
///
/// # Errors
/// As [`probe_run`].
pub fn probe(landmarks: u32, seeds: u32) -> Result<ProbeEnsemble, Error> {
    let runs = over_seeds(seeds, |seed| probe_run(landmarks, SensorKind::Range, seed))?;
    Ok(ProbeEnsemble {
        trace: Distribution::new(runs.iter().map(|r| r.0)),
        nees: Distribution::new(runs.iter().map(|r| r.1)),
    })
}

/// The Probe with one range-only landmark, over the seeds after so many steps: the pose trace, and that step's NEES.
///
/// # Errors
/// As [`probe_run`].
pub fn probe_laps(steps: &[u32], seeds: u32) -> Result<Vec<ProbeEnsemble>, Error> {
    let runs = over_seeds(seeds, |seed| {
        let mut probe = ObservabilityProbe::new(ProbeParams { seed, ..Default::default() })?;
        let mut run = Vec::new();
        for &step in steps {
            probe.run(step - probe.steps())?;
            run.push((probe.last_trace(), probe.frame().nees.unwrap_or(f64::NAN)));
        }
        Ok(run)
    })?;
    Ok((0..steps.len())
        .map(|i| ProbeEnsemble {
            trace: Distribution::new(runs.iter().map(|run| run[i].0)),
            nees: Distribution::new(runs.iter().map(|run| run[i].1)),
        })
        .collect())
}

/// Range–bearing SLAM over the seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct SlamEnsemble {
    /// Sightings matched in a run.
    pub matched: Distribution,
    /// The worst landmark's error at the end, metres.
    pub worst: Distribution,
    /// The same in its own standard deviations.
    pub sigma: Distribution,
    /// Landmarks founded though they were in the map, over all runs.
    pub spurious: u32,
    /// Sightings matched to the wrong landmark, over all runs.
    pub wrong: u32,
    /// Runs with a spurious landmark.
    pub with_spurious: u32,
}

/// Range–bearing SLAM with the chapter's constants but this threshold for founding.
///
/// # Errors
/// As [`probe_run`].
pub fn slam(found: f64, seeds: u32) -> Result<SlamEnsemble, Error> {
    let constants = RangeBearingSlam { found, ..RANGE_BEARING_SLAM };
    let runs = over_seeds(seeds, |seed| {
        let run = chapter_run(&constants, seed)?;
        let worst = run.worst();
        Ok((run.tally, worst.map_or(f64::NAN, |w| w.error), worst.map_or(f64::NAN, |w| w.sigma)))
    })?;
    Ok(SlamEnsemble {
        matched: Distribution::new(runs.iter().map(|r| f64::from(r.0.matched))),
        worst: Distribution::new(runs.iter().map(|r| r.1)),
        sigma: Distribution::new(runs.iter().map(|r| r.2)),
        spurious: runs.iter().map(|r| r.0.spurious).sum(),
        wrong: runs.iter().map(|r| r.0.wrong).sum(),
        with_spurious: runs.iter().map(|r| u32::from(r.0.spurious > 0)).sum(),
    })
}
