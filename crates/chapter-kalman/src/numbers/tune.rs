//! Numbers of the noise levels fitted to logs: over 500 seeds, and of the log that the figure opens with.

use super::ensembles::percentiles;
use crate::ensembles::{SEEDS, fits};
use core::f64::consts::LN_10;
use estimate::Error;
use lab::Lab;
use lab::Listing;
use labs::{Tune, TuneParams};

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let mut sigma = f64::NAN;
    for length in [50, 200] {
        let runs = fits(length, SEEDS)?;
        let id = |part: &str| format!("ensemble.fit.{length}.{part}");
        sigma = LN_10 * runs.sigma_q.median();
        to.by("chapter_kalman::ensembles::fits", None);
        percentiles(
            to,
            &id("sigma.q"),
            &runs.sigma_q,
            "the standard deviation of a fitted log₁₀ q as its information claims",
        );
        percentiles(to, &id("sigma.W"), &runs.sigma_w, "the same of log₁₀ W");
        percentiles(to, &id("axis"), &runs.axis, "half the long axis of the fit's 95 % region, in decimal logarithms");
        percentiles(to, &id("along"), &runs.along_ratio, "the cosine between that axis and the direction of q/W alone");
        to.add(
            id("factor.q"),
            power(runs.sigma_q.median()),
            "the factor of one such standard deviation of q, in the median",
        )
        .add(id("factor.W"), power(runs.sigma_w.median()), "the same of W")
        .add(id("covered"), runs.covered, "the share of the fits held by no bound whose 95 % region holds the truth")
        .add(
            id("within"),
            runs.within,
            "the share of logs at whose truth the likelihood lacks less than the 95 % quantile",
        )
        .add(id("held"), f64::from(runs.held), "fits that an end of the range held");
    }
    first_log(to)?;
    in_band(to)?;
    exercises(sigma, to);
    Ok(())
}

/// The figure as it opens: the first log under q = 1 and W = 1 m².
fn first_log(to: &mut Listing) -> Result<(), Error> {
    let frame = Tune::new(TuneParams::default())?.frame();
    let (last, band) = (frame.mean_nis.last(), frame.mean_nis_band.last());
    to.by("labs::Tune::frame", None)
        .add("tune.readings", frame.innovations.len() as f64, "readings of the first log of the figure")
        .add("tune.lag1", frame.autocorrelation[0], "its innovations' autocorrelation at lag 1 with q = 1 and W = 1 m²")
        .add("tune.band.lag", frame.autocorrelation_band, "the 95 % band of an autocorrelation of so many readings")
        .add("tune.band.lag.thrice", 3.0 * frame.autocorrelation_band, "three times that band");
    if let (Some(nis), Some(band)) = (last, band) {
        to.add("tune.nis", *nis, "its mean NIS with q = 1 and W = 1 m²")
            .add("tune.band.low", band.low, "lower end of the 95 % band of the mean of so many NIS")
            .add("tune.band.high", band.high, "its upper end");
    }
    Ok(())
}

/// The least q on the first log, with W so large that the mean NIS lies in its band.
pub(super) fn in_band(to: &mut Listing) -> Result<(), Error> {
    const STEP: f64 = 0.01;
    let with = |log_w: f64, committed: bool| {
        Ok::<_, Error>(Tune::new(TuneParams { log_q: -2.0, log_w, committed, ..Default::default() })?.frame())
    };
    let mut held = Vec::new();
    for i in -200..=200 {
        let log_w = f64::from(i) * STEP;
        let frame = with(log_w, false)?;
        if let (Some(nis), Some(band)) = (frame.mean_nis.last(), frame.mean_nis_band.last())
            && (band.low..=band.high).contains(nis)
        {
            held.push(log_w);
        }
    }
    let (Some(&least), Some(&most)) = (held.first(), held.last()) else { return Ok(()) };
    let frame = with(0.5 * (least + most), true)?;
    to.by("labs::Tune::frame", None)
        .add(
            "ex.band.W.least",
            power(least),
            "the least W whose mean NIS on the first log lies in its band, with the least q",
        )
        .add("ex.band.W.most", power(most), "the greatest such W")
        .add(
            "ex.band.lag1",
            frame.autocorrelation[0],
            "the innovations' autocorrelation at lag 1 midway between the two",
        );
    if let (Some(fit), Some(truth)) = (frame.fit, frame.verdict) {
        to.add("ex.band.lacking", 0.5 * fit.lacking, "how far the log-likelihood there lies below its maximum").add(
            "ex.band.nees",
            truth.mean_nees,
            "the mean NEES there",
        );
    }
    Ok(())
}

/// How many readings tell q to a twentieth, where 200 leave ln q this standard deviation: it falls as one over the root
/// of their number.
pub(super) fn exercises(sigma: f64, to: &mut Listing) {
    let (length, goal) = (200.0, 0.05);
    let readings = length * (sigma / goal) * (sigma / goal);
    to.by("chapter_kalman::numbers::tune::exercises", None)
        .add("ex.readings.sigma", sigma, "the standard deviation of ln q fitted to 200 readings, in the median")
        .add("ex.readings", readings, "readings that tell q to 5 % (one σ)")
        .add(
            "ex.readings.unlogged",
            length * (libm::expm1(sigma) / goal) * (libm::expm1(sigma) / goal),
            "the same with the factor less 1 for the standard deviation of ln q",
        )
        .add(
            "ex.readings.linear",
            length * sigma / goal,
            "the same, were σ to fall as one over the number of readings",
        );
}

/// Ten to this power.
fn power(log: f64) -> f64 {
    libm::exp(LN_10 * log)
}
