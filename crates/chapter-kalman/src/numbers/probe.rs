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

/// The seed of the run that the text sends a reader to.
const WANDERING: u32 = 2;
/// Until there the usual run shows nothing of the kind.
const LUCKY: u32 = 960;

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
        let [x, y] = [c[0] / c[2], c[1] / c[2]];
        to.vector("ex.ghost.back", [x, y, -1.0].iter(), "the same with the heading turned the other way")
            .vector("ex.ghost.along", [y, -x, 0.0].iter(), "the way along the line of sight")
            .vector("ex.ghost.mirrored", [x, -y, 1.0].iter(), "the unseen direction with a wrong sign");
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
    let bearing = ProbeParams { sensor: SensorKind::RangeBearing, seed: givens.seed, ..Default::default() };
    let mut probe = ObservabilityProbe::new(bearing)?;
    for steps in [240, 480, 960, 1920] {
        probe.run(steps - probe.frame().step)?;
        let trace = probe.frame().trace.total;
        to.add(
            format!("probe.run.trace.rb.{steps}"),
            trace,
            "the pose trace of the figure's run with range and bearing",
        );
    }
    wandering(to)
}

/// A run of the figure whose estimate wanders along the hidden direction, lap after lap.
fn wandering(to: &mut Listing) -> Result<(), Error> {
    let mut probe = ObservabilityProbe::new(ProbeParams { seed: WANDERING, ..Default::default() })?;
    let mut lucky = ObservabilityProbe::new(ProbeParams::default())?;
    lucky.run(LUCKY)?;
    to.by("labs::ObservabilityProbe", None)
        .add("probe.wandering.seed", f64::from(WANDERING), "the run's seed")
        .add("probe.lucky.steps", f64::from(LUCKY), "steps of the run that the figure begins with")
        .add("probe.lucky.nees", lucky.frame().mean.nees.unwrap_or(f64::NAN), "its mean NEES until then");
    for steps in [240, 480, 960, 1920] {
        probe.run(steps - probe.frame().step)?;
        let frame = probe.frame();
        let (id, error) = (format!("probe.wandering.{steps}"), numerics::hypot(frame.error[0], frame.error[1]));
        to.add(format!("{id}.trace"), frame.trace.total, "the pose trace of that run")
            .add(format!("{id}.error"), error, "the error of the position then, m")
            .add(format!("{id}.nees"), frame.mean.nees.unwrap_or(f64::NAN), "the mean NEES until then");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn a_wandering_run_errs_ever_more_while_its_trace_stalls_and_the_usual_run_does_not() {
        let mut listing = Listing::new();
        wandering(&mut listing).expect("computed");
        let n: BTreeMap<_, _> = listing.numbers.into_iter().map(|n| (n.id, n.value)).collect();
        let of = |steps: u32, part: &str| n[&format!("probe.wandering.{steps}.{part}")];
        for (before, after) in [(240, 480), (480, 960), (960, 1920)] {
            assert!(of(before, "error") < of(after, "error") && of(before, "nees") < of(after, "nees"), "{after}");
        }
        // The trace of the true path doubles with each doubling of the drive.
        assert!(of(1920, "trace") < of(960, "trace") && of(1920, "nees") > 20.0);
        assert!(n["probe.lucky.nees"] < 3.0, "{}", n["probe.lucky.nees"]);
    }
}
