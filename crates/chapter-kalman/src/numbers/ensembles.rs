//! Numbers over 500 seeds.

use crate::ensembles::{Distribution, SEEDS, probe, probe_laps, slam};
use estimate::Error;
use filters::consistency::chi2_interval;
use lab::Listing;
use sim::scenarios::{PROBE, RANGE_BEARING_SLAM};

/// Steps after which the Probe's runs with one landmark are looked at.
const LAPS: [u32; 4] = [240, 480, 960, 1920];

pub(super) fn list(to: &mut Listing) -> Result<(), Error> {
    let [one, two] = [probe(1, SEEDS)?, probe(2, SEEDS)?];
    to.by("chapter_kalman::ensembles::probe", Some(10));
    to.add("ensemble.seeds", f64::from(SEEDS), "runs that differ in their noise only");
    percentiles(to, "ensemble.probe.trace.one", &one.trace, "the pose trace with one range-only landmark");
    percentiles(to, "ensemble.probe.trace.two", &two.trace, "the pose trace with two");
    percentiles(to, "ensemble.probe.nees", &two.nees, "the mean NEES of a run with two landmarks");
    let (low, high) = chi2_interval(3, PROBE.steps, 0.9).map_err(Error::from)?;
    to.by("filters::consistency::chi2_interval", None)
        .add("ensemble.probe.nees.band.low", low, "below it one run in twenty, were its steps independent")
        .add("ensemble.probe.nees.band.high", high, "above it one run in twenty, were its steps independent");

    to.by("chapter_kalman::ensembles::probe_laps", None);
    for (laps, steps) in probe_laps(&LAPS, SEEDS)?.iter().zip(LAPS) {
        to.add(format!("ensemble.probe.laps.{steps}.trace"), laps.trace.median(), "the pose trace, their median").add(
            format!("ensemble.probe.laps.{steps}.nees"),
            laps.nees.median(),
            "the NEES of that step, their median",
        );
    }

    let runs = slam(RANGE_BEARING_SLAM.found, SEEDS)?;
    to.by("chapter_kalman::ensembles::slam", Some(12));
    percentiles(to, "ensemble.rbslam.matched", &runs.matched, "sightings matched in a run");
    percentiles(to, "ensemble.rbslam.worst", &runs.worst, "the worst landmark's error of a run, m");
    percentiles(to, "ensemble.rbslam.sigma", &runs.sigma, "the same in its own standard deviations");
    to.add("ensemble.rbslam.spurious", f64::from(runs.spurious), "landmarks founded twice, in all runs together");
    to.add("ensemble.rbslam.wrong", f64::from(runs.wrong), "wrong matches, in all runs together");
    let mut with_spurious = Vec::new();
    for found in [15.0, 20.0, 25.0, 30.0] {
        with_spurious.push((found, slam(found, SEEDS)?.with_spurious));
    }
    let about = "the greatest threshold for founding, of 15, 20, 25 and 30, that founds ghosts";
    let low = with_spurious.iter().rev().find(|(_, n)| *n > 0).map_or(f64::NAN, |(found, _)| *found);
    to.add("ensemble.rbslam.found.low", low, about);
    Ok(())
}

pub(super) fn percentiles(to: &mut Listing, id: &str, spread: &Distribution, about: &'static str) {
    for (name, p) in [("p05", 0.05), ("p50", 0.5), ("p90", 0.9), ("p95", 0.95)] {
        to.add(format!("{id}.{name}"), spread.percentile(p), about);
    }
}
