//! Numbers of the Observability Probe.

use crate::checks::observability::five_cases;
use crate::givens::Givens;
use estimate::localizer::SensorKind;
use estimate::{Error, Landmark};
use geom::SE2;
use lab::Lab;
use lab::Listing;
use labs::observability_probe::{Moment, ObservabilityProbe, ProbeParams, stacked_ranks};
use labs::true_path::after;
use nalgebra::Vector2;
use std::sync::Arc;

pub(super) fn list(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    ranks(givens, to)?;
    turned(to)?;
    traces(givens, to)?;
    runs(givens, to)
}

fn ranks(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    to.by("chapter_kalman::checks::observability::five_cases", Some(9));
    for (i, case) in (1..).zip(five_cases(givens)?) {
        to.add(format!("probe.frozen.{i}"), case.frozen.rank as f64, case.about);
        to.add(format!("probe.path.{i}"), case.path.rank as f64, case.about);
    }
    Ok(())
}

/// The exercise: a straight drive that ends 3 m west and 4 m north of its one landmark, and the direction that it never
/// shows.
fn turned(to: &mut Listing) -> Result<(), Error> {
    let landmarks: Arc<[Landmark]> = [Landmark { id: 0, x: 3.0, y: -4.0 }].into();
    let moments: Vec<Moment> = [-1.0, -0.5, 0.0]
        .map(|x| Moment { pose: SE2::new(x, 0.0, 0.0), landmarks: Arc::clone(&landmarks), u: Vector2::new(0.5, 0.0) })
        .into();
    let ranks = stacked_ranks(moments.iter(), SensorKind::Range, false, 1e-9)?;
    to.by("labs::observability_probe::stacked_ranks", None).add("ex.ghost.rank", ranks.rank as f64, "its rank");
    if let [c] = &ranks.directions[..] {
        to.vector("ex.ghost.c", c.map(|e| e / c[2]).iter(), "its unseen direction, scaled to end with 1");
        to.vector("ex.ghost.tangent", [c[0] / c[2], c[1] / c[2], 0.0].iter(), "the same with the heading left alone");
    }
    Ok(())
}

fn traces(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    let probe = &givens.probe;
    to.by("labs::true_path::after", Some(10));
    for (name, n) in [("one", 1), ("two", 2)] {
        let path = after(probe, n, SensorKind::Range, probe.steps)?;
        let [position, heading] = path.parts();
        to.add(format!("probe.trace.{name}"), path.trace(), "the pose trace after 240 steps, m² and rad² added")
            .add(format!("probe.trace.{name}.position"), position, "its part in m²")
            .add(format!("probe.trace.{name}.heading"), heading, "its part in rad²");
    }
    to.by("labs::true_path::after", None);
    for steps in [480, 960, 1920] {
        let trace = after(probe, 1, SensorKind::Range, steps)?.trace();
        to.add(format!("probe.trace.one.{steps}"), trace, "the same with one landmark, after more laps");
    }
    for steps in [240, 480, 960, 1920] {
        let trace = after(probe, 1, SensorKind::RangeBearing, steps)?.trace();
        to.add(format!("probe.trace.rb.{steps}"), trace, "the pose trace with one range–bearing landmark");
    }
    Ok(())
}

fn runs(givens: &Givens, to: &mut Listing) -> Result<(), Error> {
    to.by("labs::ObservabilityProbe", None);
    for (name, count, ratio) in [("one", 1, "probe.sv.zero"), ("two", 2, "probe.sv.true")] {
        let mut probe = ObservabilityProbe::new(ProbeParams { count, seed: givens.seed, ..Default::default() })?;
        probe.run(givens.probe.steps)?;
        let frame = probe.frame();
        to.add(format!("probe.run.trace.{name}"), frame.trace.total, "the pose trace of one seeded run")
            .add(format!("probe.run.nees.{name}"), frame.mean.nees.unwrap_or(f64::NAN), "the mean NEES of that run")
            .add(ratio, frame.frozen.relative[2], "the smallest frozen singular value over the largest, at its end");
    }
    Ok(())
}
