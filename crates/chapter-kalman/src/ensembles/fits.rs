//! Fits of the noise levels over many seeds.

use estimate::Error;
use filters::consistency::chi2_quantile;
use lab::Lab;
use labs::ensemble::{Distribution, over_seeds};
use labs::{Tune, TuneParams};

/// The fit over the seeds, each with noise levels of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct FitEnsemble {
    /// The square of (fit − truth) in the metric of the information, of the fits that no bound held: χ² with 2 degrees
    /// of freedom where the information tells the truth.
    pub distance: Distribution,
    /// The part of those fits whose 95 % region holds the truth.
    pub covered: f64,
    /// The part of all logs at whose truth the likelihood lacks less than the 95 % quantile.
    pub within: f64,
    /// The standard deviation of log₁₀ q that the information claims.
    pub sigma_q: Distribution,
    /// The same of log₁₀ W.
    pub sigma_w: Distribution,
    /// Half the long axis of the 95 % region, in decimal logarithms.
    pub axis: Distribution,
    /// The cosine of the angle between the long axis of the region and the direction (1, −1), along which q/W alone
    /// changes.
    pub along_ratio: Distribution,
    /// Fits that a bound held.
    pub held: u32,
}

/// Logs of so many readings, fitted.
///
/// # Errors
/// Whatever the core answers; on the chapter's constants, nothing.
pub fn fits(length: u32, seeds: u32) -> Result<FitEnsemble, Error> {
    let runs = over_seeds(seeds, |seed| {
        let lab = Tune::new(TuneParams { length, committed: true, seed, ..TuneParams::default() })?;
        let frame = lab.frame();
        Ok((lab.distance(), frame.fit, frame.verdict.map(|verdict| verdict.lacking)))
    })?;
    let limit = chi2_quantile(2, 0.95)?;
    let free: Vec<_> =
        runs.iter().filter_map(|(off, fit, _)| Some(((*off)?, fit.as_ref()?.sigma?, fit.as_ref()?.region?))).collect();
    let distance = Distribution::new(free.iter().map(|(off, ..)| *off));
    let within = runs.iter().filter(|(.., lacking)| lacking.is_some_and(|lacking| lacking <= limit)).count();
    Ok(FitEnsemble {
        covered: distance.share_below(limit),
        distance,
        within: within as f64 / runs.len() as f64,
        sigma_q: Distribution::new(free.iter().map(|(_, sigma, _)| sigma[0])),
        sigma_w: Distribution::new(free.iter().map(|(_, sigma, _)| sigma[1])),
        axis: Distribution::new(free.iter().map(|(.., region)| region.semi_major)),
        along_ratio: Distribution::new(free.iter().map(|(.., region)| {
            let (sin, cos) = libm::sincos(region.angle);
            (cos - sin).abs() * core::f64::consts::FRAC_1_SQRT_2
        })),
        held: (runs.len() - free.len()) as u32,
    })
}
