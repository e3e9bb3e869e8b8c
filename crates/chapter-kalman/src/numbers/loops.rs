//! Numbers of the corridor's loop over 500 seeds, by the right filter and by the one without cross-covariances.

use super::ensembles::percentiles;
use crate::ensembles::{SEEDS, loops};
use estimate::Error;
use filters::consistency::chi2_quantile;
use lab::Listing;

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    for (name, correlated) in [("right", true), ("apart", false)] {
        let runs = loops(correlated, SEEDS)?;
        let id = |part: &str| format!("ensemble.loop.{name}.{part}");
        to.by("chapter_kalman::ensembles::loops", None);
        percentiles(to, &id("nees"), &runs.nees, "the mean NEES of a lap; 3 is expected");
        percentiles(to, &id("error"), &runs.error, "the error of the position after a lap, m");
        percentiles(to, &id("sigma"), &runs.sigma, "one sigma of it in a coordinate as claimed, m");
        to.add(id("nees.mean"), runs.nees.mean(), "the mean of the runs' mean NEES")
            .add(id("above"), runs.above.median(), "median share of a lap's steps with NEES above its 95 % band")
            .add(
                id("shrinks"),
                runs.shrinks.median(),
                "median factor by which the closure shrinks the map's mean sigma",
            )
            .add(id("ghosts"), f64::from(runs.with_ghosts), "runs in which a landmark was founded twice")
            .add(id("wrong"), f64::from(runs.with_wrong), "runs with a wrong match");
    }
    exercises(to)
}

/// χ² of a right sighting has two degrees of freedom: it is above g with the probability exp(−g/2).
fn exercises(to: &mut Listing) -> Result<(), Error> {
    let rare = 1e-6;
    to.by("chapter_kalman::numbers::loops::exercises", None)
        .add("ex.ghost", -2.0 * libm::log(rare), "χ² that a right sighting exceeds once in a million")
        .add("ex.ghost.one", chi2_quantile(1, 1.0 - rare)?, "the same with one degree of freedom")
        .add("ex.ghost.half", -libm::log(rare), "the same with exp(−g) in place of exp(−g/2)");
    Ok(())
}
