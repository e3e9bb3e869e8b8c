//! Numbers of the noise levels fitted to logs, over 500 seeds.

use super::Listing;
use super::ensembles::percentiles;
use crate::ensembles::{SEEDS, fits};
use estimate::Error;

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    for length in [50, 200] {
        let runs = fits(length, SEEDS)?;
        let id = |part: &str| format!("ensemble.fit.{length}.{part}");
        to.by("labs::ensembles::fits", None);
        percentiles(
            to,
            &id("sigma.q"),
            &runs.sigma_q,
            "the standard deviation of a fitted log₁₀ q as its information claims",
        );
        percentiles(to, &id("sigma.W"), &runs.sigma_w, "the same of log₁₀ W");
        percentiles(to, &id("axis"), &runs.axis, "half the long axis of the fit's 95 % region, in decimal logarithms");
        percentiles(to, &id("along"), &runs.along_ratio, "the cosine between that axis and the direction of q/W alone");
        to.add(id("covered"), runs.covered, "the share of the fits held by no bound whose 95 % region holds the truth")
            .add(
                id("within"),
                runs.within,
                "the share of logs at whose truth the likelihood lacks less than the 95 % quantile",
            )
            .add(id("held"), f64::from(runs.held), "fits that an end of the range held");
    }
    Ok(())
}
