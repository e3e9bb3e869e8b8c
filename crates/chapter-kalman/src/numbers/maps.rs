//! Numbers of Kalman SLAM.

use crate::checks::maps::{linear_limit, linear_slam};
use crate::givens::Givens;
use estimate::localizer::SensorKind;
use estimate::{Code, Error};
use filters::linear;
use lab::{Lab, Listing};
use labs::mapping::chapter_run;
use labs::observability_probe::{ObservabilityProbe, ProbeParams};
use nalgebra::Matrix1;

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let run = linear_slam(givens, givens.linear_slam.steps)?;
    let ends = |v: &[f64]| [v.first(), v.last()].map(|e| e.copied().unwrap_or(f64::NAN));
    let [first, last] = ends(&run.relative);
    let limit = linear_limit(givens)?;
    to.by("chapter_kalman::checks::maps::linear_slam", Some(11))
        .add("slam.linear.rank", run.rank as f64, "the rank of the observability matrix")
        .add("slam.linear.states", run.states as f64, "states: robot and two landmarks, two coordinates each")
        .add("slam.linear.relative.first", first, "tr Cov(x_ℓ1 − x_r) after the first update, m²")
        .add("slam.linear.relative.last", last, "the same after 200 updates")
        .add("slam.linear.absolute", run.absolute, "tr Cov(x_ℓ1) after 200 updates, m²")
        .add("slam.linear.limit", limit, "its limit")
        .add("slam.linear.shape.first", run.shape[0], "tr Cov(x_ℓ1 − x_ℓ2) after the first update, m²")
        .add("slam.linear.shape.last", run.shape[1], "the same after 200 updates");

    // Where the robot stood when it first read its landmarks, as all readings together tell it of a map of known shape:
    // two displacements a step are one of variance W/2, and looking back from the far future the random walk is the
    // same.
    let (slam, one) = (&givens.linear_slam.variances, Matrix1::new(1.0));
    let (v, w) = (Matrix1::new(slam.v), Matrix1::new(0.5 * slam.w));
    let mut p = w;
    for _ in 0..200 {
        p = linear::gain(&linear::predicted_covariance(&one, &p, &v)?, &one, &w)?.p;
    }
    let known = 1.0 / (slam.p0_robot + slam.v + p[0]) + 2.0 / slam.p0_landmark;
    to.by("chapter_kalman::numbers::maps::list", None)
        .add("slam.linear.start", slam.p0_robot, "the robot's first variance in each coordinate, m²")
        .add("slam.linear.noise", slam.v, "what the first step adds to it, m²")
        .add("slam.linear.readings", p[0], "variance of the robot against the map at its first reading, all used, m²")
        .add("slam.linear.sum", 2.0 * (slam.p0_robot + slam.v + p[0]), "twice the sum of the three, m²")
        .add("slam.linear.closed", 2.0 / known, "the limit in closed form, with what was known of the landmarks, m²");

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
    in_the_figure(givens, to)
}

/// The same run in the Probe, which opens later in it.
fn in_the_figure(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let params = ProbeParams { count: 3, sensor: SensorKind::RangeBearing, forget: true, ..ProbeParams::default() };
    let mut probe = ObservabilityProbe::new(ProbeParams { seed: givens.seed, ..params })?;
    probe.run(givens.probe.steps)?;
    let map = probe.frame().slam.ok_or(Error::new(Code::Limit, "slam", "the map was not forgotten"))?;
    to.by("labs::ObservabilityProbe", None)
        .add("rbslam.step", f64::from(givens.range_bearing_slam.poses) - 1.0, "the step of the figure after 200 poses")
        .add("rbslam.figure.step", f64::from(probe.frame().step), "the step at which the figure opens")
        .add("rbslam.figure.total", f64::from(map.sightings - map.founded), "sightings until then that founded nothing")
        .add("rbslam.figure.matched", f64::from(map.matched), "of which so many were matched");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn the_landmark_stalls_where_start_noise_and_readings_leave_it() {
        let mut listing = Listing::new();
        list(&Givens::default(), &mut listing).expect("computed");
        let n: BTreeMap<_, _> = listing.numbers.into_iter().map(|n| (n.id, n.value)).collect();
        // The text says both of the run: what it counts after 200 poses, and where the figure opens.
        assert_eq!(n["rbslam.step"] + 1.0, n["rbslam.sightings"] / 3.0);
        assert!(n["rbslam.figure.total"] - n["rbslam.figure.matched"] == n["rbslam.total"] - n["rbslam.matched"]);
        // p²/(p + 0.02) = 0.01 has the root p = 0.02, of which an update leaves a half.
        assert!((n["slam.linear.readings"] - 0.01).abs() < 1e-15);
        // The limit is extrapolated from 2000 and 4000 steps as a + b/k; the next term is of the order of 1/k².
        assert!((n["slam.linear.closed"] - n["slam.linear.limit"]).abs() < 1e-8, "{}", n["slam.linear.closed"]);
    }
}
