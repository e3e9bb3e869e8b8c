//! Numbers of the corridor's loop over 500 seeds, by the right filter and by the one without cross-covariances.

use super::Listing;
use super::ensembles::percentiles;
use crate::ensembles::{SEEDS, loops};
use estimate::Error;

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    for (name, correlated) in [("right", true), ("apart", false)] {
        let runs = loops(correlated, SEEDS)?;
        let id = |part: &str| format!("ensemble.loop.{name}.{part}");
        to.by("labs::ensembles::loops", None);
        percentiles(to, &id("nees"), &runs.nees, "the mean NEES of a lap; 3 is expected");
        percentiles(to, &id("error"), &runs.error, "the error of the position after a lap, m");
        percentiles(to, &id("sigma"), &runs.sigma, "one sigma of it in a coordinate as claimed, m");
        to.add(id("nees.mean"), runs.nees.mean(), "the mean of the runs' mean NEES")
            .add(
                id("above"),
                runs.above.median(),
                "the share of a lap's steps whose NEES is above its 95 % band, in the median",
            )
            .add(
                id("shrinks"),
                runs.shrinks.median(),
                "the factor by which closing the loop shrinks the landmarks' mean sigma",
            )
            .add(id("ghosts"), f64::from(runs.with_ghosts), "runs in which a landmark was founded twice")
            .add(id("wrong"), f64::from(runs.with_wrong), "runs with a wrong match");
    }
    Ok(())
}
