//! Numbers of Kalman SLAM.

use super::Listing;
use crate::checks::maps::{linear_limit, linear_slam};
use crate::givens::Givens;
use crate::mapping::chapter_run;
use estimate::Error;

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let run = linear_slam(givens, givens.linear_slam.steps)?;
    let ends = |v: &[f64]| [v.first(), v.last()].map(|e| e.copied().unwrap_or(f64::NAN));
    let [first, last] = ends(&run.relative);
    let limit = linear_limit(givens)?;
    to.by("labs::checks::maps::linear_slam", Some(11))
        .add("slam.linear.rank", run.rank as f64, "the rank of the observability matrix")
        .add("slam.linear.states", run.states as f64, "states: robot and two landmarks, two coordinates each")
        .add("slam.linear.relative.first", first, "tr Cov(x_ℓ1 − x_r) after the first update, m²")
        .add("slam.linear.relative.last", last, "the same after 200 updates")
        .add("slam.linear.absolute", run.absolute, "tr Cov(x_ℓ1) after 200 updates, m²")
        .add("slam.linear.limit", limit, "its limit")
        .add("slam.linear.shape.first", run.shape[0], "tr Cov(x_ℓ1 − x_ℓ2) after the first update, m²")
        .add("slam.linear.shape.last", run.shape[1], "the same after 200 updates");

    let run = chapter_run(&givens.range_bearing_slam, givens.seed)?;
    let worst = run.worst();
    let tally = run.tally;
    to.by("labs::mapping::chapter_run", Some(12))
        .add("rbslam.sightings", f64::from(tally.sightings), "sightings of the run")
        .add("rbslam.founded", f64::from(tally.founded), "of which so many founded a landmark")
        .add("rbslam.total", f64::from(tally.sightings - tally.founded), "the others")
        .add("rbslam.matched", f64::from(tally.matched), "of which so many were matched")
        .add("rbslam.worst", worst.map_or(f64::NAN, |w| w.error), "the worst landmark's error, m")
        .add("rbslam.sigma", worst.map_or(f64::NAN, |w| w.sigma), "the same in its own standard deviations");
    Ok(())
}
